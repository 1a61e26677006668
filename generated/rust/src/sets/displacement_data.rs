//! Displacement data (0x90): Measurements of the DEMOD-DC, a digital demodulator for displacement
//! sensors.
//!
//! Source: mscl: Displacement Data (0x90).

// What the macros make, which `cargo doc` shows and `src/macros` defines:
// `open_enum!` and `bitfield!` types of values; `record!` a structure with its codec; `union!` its
// alternatives; `view!` methods that read single values; `constructors!` and `setters!` what makes
// it; `field!` its sets and descriptor; `command!` and `responses!` how it is answered.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const DISPLACEMENT_DATA_SET: u8 = 0x90;

record! {
    /// Raw displacement (0x90,0x01).
    ///
    /// Displacement in counts of the converter.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain Communication Library.
    ///
    /// Source: mscl: Raw displacement (0x90,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DisplacementRaw {
        /// Displacement in counts.
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
    /// Calibrated displacement of the sensor.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain Communication Library.
    ///
    /// Source: mscl: Displacement (0x90,0x02).
    #[derive(Copy, Default)]
    pub struct Displacement {
        /// Displacement.
        ///
        /// Unit: mm.
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
