//! Shared data (0xFF): Fields that every data set can contain. No packet has this descriptor set:
//! the fields are sent in packets of the other data sets.
//!
//! Source: 3dm-cv7-gnss-ins: Shared (0xFF); 3dm-cv7-gnss-ins: Shared Data Descriptors.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

bitfield! {
    /// Validity flags for the GPS time.
    GpsTimestampFlags: u16 {
        /// The whole seconds of the time of week have been set. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// The week number has been set. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// The time of week and the week number have been set. Bits 0 to 1. Overlaps other bits.
        TIME_VALID: u8 = 0..=1,
            time_valid, set_time_valid, with_time_valid;
    }
}

bitfield! {
    /// Validity of the external time.
    ExternalTimestampFlags: u16 {
        /// The time is valid. Bit 0.
        NANOSECONDS: bool = 0,
            nanoseconds, set_nanoseconds, with_nanoseconds;
    }
}

bitfield! {
    /// Validity of the external time difference.
    ExternalTimeDeltaFlags: u16 {
        /// The difference is valid. Bit 0.
        DT_NANOS: bool = 0,
            dt_nanos, set_dt_nanos, with_dt_nanos;
    }
}

record! {
    /// Event source (0xFF,0xD0).
    ///
    /// The event trigger that caused the packet.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR)
    /// and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// - Put it first in the format of event messages, to distinguish their packets from scheduled
    ///   ones.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Source (0xFF,0xD0).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventSource {
        /// Id of the trigger; 0 means that the packet was scheduled by
        /// [`mip_3dm::MessageFormat`](crate::mip_3dm::MessageFormat).
        pub trigger_id: u8,
    }
}

view! {
    EventSource
    trigger_id: u8, at 0;
}

constructors! {
    EventSource

    /// Creates it from its values.
    fn new(trigger_id: u8);
}

field! {
    EventSource: 0xD0, "shared.event_source";
    in [0x80..=0xFE];
}

record! {
    /// Ticks (0xFF,0xD1).
    ///
    /// Base periods since power-up.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain:
    /// According to the SDK, the counter returns to 0 after about 50 days. That fits 2^32 ticks at
    /// 1000 Hz; at other rates that time would be longer or shorter.
    ///
    /// - A tick is one period at the base rate of the device.
    ///
    /// Source: mip-sdk-4: Ticks (0xFF,0xD1).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Ticks {
        /// Base periods since the device started, modulo 2^32.
        ///
        /// Unit: 1.
        pub ticks: u32,
    }
}

view! {
    Ticks
    ticks: u32, at 0;
}

constructors! {
    Ticks

    /// Creates it from its values.
    fn new(ticks: u32);
}

field! {
    Ticks: 0xD1, "shared.ticks";
    in [0x80..=0xFE];
}

record! {
    /// Delta ticks (0xFF,0xD2).
    ///
    /// Number of base periods between the previous field of this kind and this one.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Each
    /// set and each event instance may count separately, as with [`DeltaTime`].
    ///
    /// - A tick is one period at the base rate of the device.
    ///
    /// Source: mip-sdk-4: Delta ticks (0xFF,0xD2).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeltaTicks {
        /// Base periods since the previous field of this kind.
        ///
        /// Unit: 1.
        pub ticks: u32,
    }
}

view! {
    DeltaTicks
    ticks: u32, at 0;
}

constructors! {
    DeltaTicks

    /// Creates it from its values.
    fn new(ticks: u32);
}

field! {
    DeltaTicks: 0xD2, "shared.delta_ticks";
    in [0x80..=0xFE];
}

record! {
    /// GPS timestamp (0xFF,0xD3).
    ///
    /// External time of the data as GPS time of week and week number.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 7 more.
    ///
    /// - In event messages it is the time of the trigger.
    /// - It becomes valid after the PPS is locked and
    ///   [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate) has set the time of week and the week
    ///   number.
    /// - With an internal GNSS receiver as PPS source, the device usually sets the time itself.
    /// - With NMEA input, a ZDA sentence sets the time to UTC: the value is then behind GPS time by
    ///   the leap seconds, which are 18 s since 2017.
    ///   [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate) sets GPS time.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Timestamp (0xFF,0xD3); 3dm-cv7-gnss-ins: Configure the
    /// External GNSS Receiver; 3dm-cv7-gnss-ins: RECEIVER Source.
    #[derive(Copy, Default)]
    pub struct GpsTimestamp {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](GpsTimestampFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](GpsTimestampFlags::week_number) is set.
        pub week_number: u16,
        /// Validity flags for the timestamp.
        pub valid_flags: GpsTimestampFlags,
    }
}

view! {
    GpsTimestamp
    tow: f64, at 0;
    week_number: u16, at 8;
    valid_flags: GpsTimestampFlags, at 10;
}

constructors! {
    GpsTimestamp

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        valid_flags: GpsTimestampFlags,
    );
}

valid! {
    GpsTimestamp
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
}

field! {
    GpsTimestamp: 0xD3, "shared.gps_timestamp";
    in [0x80..=0xFE];
}

record! {
    /// Delta time (0xFF,0xD4).
    ///
    /// External time since this field was last sent in the same set and event instance.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 9 more.
    ///
    /// - It is the same as [`ExternalTimeDelta`], in other units.
    /// - Sending either restarts the counter that both share, so use only one of them.
    ///
    /// Source: 3dm-cv7-gnss-ins: Delta Time (0xFF,0xD4).
    #[derive(Copy, Default)]
    pub struct DeltaTime {
        /// Time since the last output.
        ///
        /// Unit: s. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub seconds: f64,
    }
}

view! {
    DeltaTime
    seconds: f64, at 0;
}

constructors! {
    DeltaTime

    /// Creates it from its values.
    fn new(seconds: f64);
}

field! {
    DeltaTime: 0xD4, "shared.delta_time";
    in [0x80..=0xFE];
}

record! {
    /// Reference timestamp (0xFF,0xD5).
    ///
    /// Time of the data by the internal reference clock.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 9 more.
    ///
    /// - The clock starts at power-on, only moves forward and never jumps; the value is always
    ///   valid.
    /// - In event messages it is the time of the trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reference Timestamp (0xFF,0xD5).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ReferenceTimestamp {
        /// Time since initialization.
        ///
        /// Unit: ns.
        pub nanoseconds: u64,
    }
}

view! {
    ReferenceTimestamp
    nanoseconds: u64, at 0;
}

constructors! {
    ReferenceTimestamp

    /// Creates it from its values.
    fn new(nanoseconds: u64);
}

field! {
    ReferenceTimestamp: 0xD5, "shared.reference_timestamp";
    in [0x80..=0xFE];
}

record! {
    /// Reference time delta (0xFF,0xD6).
    ///
    /// Reference time since this field was last sent in the same set and event instance.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 9 more.
    ///
    /// - The value is always valid.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reference Time Delta (0xFF,0xD6).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ReferenceTimeDelta {
        /// Time since the last output.
        ///
        /// Unit: ns.
        pub dt_nanos: u64,
    }
}

view! {
    ReferenceTimeDelta
    dt_nanos: u64, at 0;
}

constructors! {
    ReferenceTimeDelta

    /// Creates it from its values.
    fn new(dt_nanos: u64);
}

field! {
    ReferenceTimeDelta: 0xD6, "shared.reference_time_delta";
    in [0x80..=0xFE];
}

record! {
    /// External timestamp (0xFF,0xD7).
    ///
    /// Time of the data in the external clock domain.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 9 more.
    ///
    /// - It is [`GpsTimestamp`] in nanoseconds.
    /// - In event messages it is the time of the trigger.
    /// - It becomes valid when the external clock is synchronized through the PPS.
    /// - Its epoch is the epoch of the time sent with
    ///   [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate): in most systems that of GPS time, but
    ///   possibly another, such as the Unix epoch. Use [`GpsTimestamp`] for GPS time only.
    /// - With a receiver as the source of the PPS
    ///   ([`mip_3dm::PpsSourceControl`](crate::mip_3dm::PpsSourceControl)), it is GPS time, and
    ///   valid only while that receiver has a fix.
    ///
    /// Source: 3dm-cv7-gnss-ins: External Timestamp (0xFF,0xD7); 3dm-cv7-gnss-ins: Timestamps;
    /// 3dm-cv7-gnss-ins: RECEIVER Source.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ExternalTimestamp {
        /// External time.
        ///
        /// Unit: ns. Valid if [`valid_flags.nanoseconds`](ExternalTimestampFlags::nanoseconds) is
        /// set.
        pub nanoseconds: u64,
        /// Validity of the time.
        pub valid_flags: ExternalTimestampFlags,
    }
}

view! {
    ExternalTimestamp
    nanoseconds: u64, at 0;
    valid_flags: ExternalTimestampFlags, at 8;
}

constructors! {
    ExternalTimestamp

    /// Creates it from its values.
    fn new(nanoseconds: u64, valid_flags: ExternalTimestampFlags);
}

valid! {
    ExternalTimestamp
    nanoseconds_is_valid "nanoseconds": valid_flags 0x1;
}

field! {
    ExternalTimestamp: 0xD7, "shared.external_timestamp";
    in [0x80..=0xFE];
}

record! {
    /// External time delta (0xFF,0xD8).
    ///
    /// External time since this field was last sent in the same set and event instance.
    ///
    /// Confirmed on [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 9 more.
    ///
    /// - It is the same as [`DeltaTime`], in other units.
    /// - Sending either restarts the counter that both share, so use only one of them.
    ///
    /// Source: 3dm-cv7-gnss-ins: External Time Delta (0xFF,0xD8).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ExternalTimeDelta {
        /// Time since the last output.
        ///
        /// Unit: ns. Valid if [`valid_flags.dt_nanos`](ExternalTimeDeltaFlags::dt_nanos) is set.
        pub dt_nanos: u64,
        /// Validity of the difference.
        pub valid_flags: ExternalTimeDeltaFlags,
    }
}

view! {
    ExternalTimeDelta
    dt_nanos: u64, at 0;
    valid_flags: ExternalTimeDeltaFlags, at 8;
}

constructors! {
    ExternalTimeDelta

    /// Creates it from its values.
    fn new(dt_nanos: u64, valid_flags: ExternalTimeDeltaFlags);
}

valid! {
    ExternalTimeDelta
    dt_nanos_is_valid "dt_nanos": valid_flags 0x1;
}

field! {
    ExternalTimeDelta: 0xD8, "shared.external_time_delta";
    in [0x80..=0xFE];
}
