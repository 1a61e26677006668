//! Displacement data (0x90): Measurements of the DEMOD-DC, a digital demodulator for displacement
//! sensors.
//!
//! Source: mscl: Displacement Data (0x90).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x90);

bitfield! {
    /// Validity of the displacement timestamp.
    ///
    /// Uncertain: The number is possibly no bitfield, because MSCL considers the time valid if it
    /// is 1.
    TimestampFlags: u8 {
        /// The clock has been set; `time` is valid. Bit 0.
        TIME: bool = 0,
            time, set_time, with_time;
    }
}

record! {
    /// Raw displacement (0x90,0x01).
    ///
    /// Displacement in ADC counts.
    ///
    /// No device is known for certain to support it. Known only from the MicroStrain Communication
    /// Library.
    ///
    /// Source: mscl: Raw displacement (0x90,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DisplacementRaw {
        /// Output of the analog-to-digital converter.
        ///
        /// Unit: 1.
        pub counts: u32,
    }
}

view! {
    DisplacementRaw
    counts: u32, at 0;
}

constructors! {
    DisplacementRaw

    /// Creates it from its values.
    fn new(counts: u32);
}

field! {
    DisplacementRaw: 0x01, "displacement_data.displacement_raw";
    in [0x90];
}

record! {
    /// Displacement (0x90,0x02).
    ///
    /// Displacement of the sensor, computed with its calibration.
    ///
    /// No device is known for certain to support it. Known only from the MicroStrain Communication
    /// Library.
    ///
    /// Source: mscl: Displacement (0x90,0x02).
    #[derive(Copy, Default)]
    pub struct Displacement {
        /// Position of the sensor along its axis.
        ///
        /// Unit: mm.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub displacement: f32,
    }
}

view! {
    Displacement
    displacement: f32, at 0;
}

constructors! {
    Displacement

    /// Creates it from its values.
    fn new(displacement: f32);
}

field! {
    Displacement: 0x02, "displacement_data.displacement";
    in [0x90];
}

record! {
    /// Displacement device timestamp (0x90,0x04).
    ///
    /// Time of the measurement by the clock of the device.
    ///
    /// No device is known for certain to support it. Also called `displacement_timestamp`. Known
    /// only from the MicroStrain Communication Library.
    ///
    /// Source: mscl: Displacement device timestamp (0x90,0x04).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Timestamp {
        /// Validity of the displacement timestamp.
        pub flags: TimestampFlags,
        /// UTC since 1970-01-01, without leap seconds, if the clock was set to it.
        ///
        /// Unit: ns. Valid if [`flags.time`](TimestampFlags::time) is set.
        pub time: u64,
    }
}

view! {
    Timestamp
    flags: TimestampFlags, at 0;
    time: u64, at 1;
}

constructors! {
    Timestamp

    /// Creates it from its values.
    fn new(flags: TimestampFlags, time: u64);
}

valid! {
    Timestamp
    time_is_valid "time": flags 0x1;
}

field! {
    Timestamp: 0x04, "displacement_data.timestamp";
    in [0x90];
}
