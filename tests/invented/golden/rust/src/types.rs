//! Types that several descriptor sets share.

open_enum! {
    /// The operation that a settings command requests.
    FunctionSelector: u8 {
        /// Apply the new setting.
        WRITE = 1, "write";
        /// Send the current setting back in a response.
        READ = 2, "read";
        /// Save the current setting to non-volatile memory.
        SAVE = 3, "save";
        /// Load the saved setting.
        LOAD = 4, "load";
        /// Load the factory default setting.
        DEFAULT = 5, "default";
        /// Apply the new setting and send no acknowledge (5-series devices).
        APPLY = 6, "apply";
    }
}

vector! {
    /// Three floats.
    Vector3f: [f32; 3] {
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

vector! {
    /// A quaternion, scalar part first.
    Quatf: [f32; 4] {
        /// The element w.
        w,
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

open_enum! {
    /// The result of a command.
    AckCode: u8 {
        /// Done.
        OK = 0, "ok";
        /// No such command.
        UNKNOWN_COMMAND = 1, "unknown_command";
        /// A parameter is out of range.
        INVALID_PARAMETER = 3, "invalid_parameter";
    }
}

open_enum! {
    /// What the device does.
    ///
    /// Uncertain: Whether there are more.
    Mode: u8 {
        /// A keyword in three languages.
        DEFAULT = 0, "default";
        /// Quick. Uncertain: How quick.
        FAST = 1, "fast";
        /// Careful. Deprecated.
        SLOW = 2, "slow";
    }
}

open_enum! {
    /// An enumeration over four bytes.
    WideCode: u32 {
        /// Low.
        LOW = 1, "low";
        /// High.
        HIGH = 4294901760, "high";
    }
}

bitfield! {
    /// Bits of all kinds.
    StateFlags: u16 {
        /// Ready to measure. Bit 0.
        READY: bool = 0,
            ready, set_ready, with_ready;
        /// Too hot. Bit 1. Uncertain: The limit; 85 degrees is likely.
        HOT: bool = 1,
            hot, set_hot, with_hot;
        /// A number from 0 to 7. Bits 4 to 6.
        LEVEL: u8 = 4..=6,
            level, set_level, with_level;
        /// An enumeration inside the bitfield. Bits 8 to 9. A value of [`Mode`].
        MODE: Mode = 8..=9,
            mode, set_mode, with_mode;
        /// Ready or hot. Bits 0 to 1. Overlaps other bits.
        ANY: u8 = 0..=1,
            any, set_any, with_any;
    }
}

bitfield! {
    /// One hundred and twenty-eight bits, least significant byte first.
    Health: [u8; 16] {
        /// The clock has failed. Bit 0.
        CLOCK: bool = 0,
            clock, set_clock, with_clock;
        /// Too hot. Bit 1. Uncertain: The limit; 85 degrees is likely.
        HOT: bool = 1,
            hot, set_hot, with_hot;
        /// A number from 0 to 7. Bits 4 to 6.
        LEVEL: u8 = 4..=6,
            level, set_level, with_level;
        /// The supply is out of range. Bit 9.
        POWER: bool = 9,
            power, set_power, with_power;
        /// A number across two bytes. Bits 30 to 33.
        COUNT: u8 = 30..=33,
            count, set_count, with_count;
        /// The very last bit. Bit 127.
        LAST: bool = 127,
            last, set_last, with_last;
    }
}

record! {
    /// A place in a plane.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Point {
        /// Eastward.
        ///
        /// Unit: m.
        pub x: i16,
        /// Northward.
        ///
        /// Unit: m.
        pub y: i16,
    }
}

item! { Point { x y } }
view! {
    Point
    x: i16, at 0;
    y: i16, at 2;
}

constructors! {
    Point

    /// Creates it from its values.
    fn new(x: i16, y: i16);
}

tuple! { Point x: i16, y: i16 }

record! {
    /// Two places, nested.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Segment {
        /// Begins here.
        pub from: Point,
        /// Ends here.
        pub to: Point,
        /// Of its ends.
        pub weights: [u8; 2],
    }
}

item! { Segment { from to weights } }
view! {
    Segment
    from as Point, at 0;
    to as Point, at 4;
    weights: [u8; 2], at 8;
}

constructors! {
    Segment

    /// Creates it from its values.
    fn new(
        from: Point,
        to: Point,
        weights: [u8; 2],
    );
}

tuple! { Segment from: Point, to: Point, weights: [u8; 2] }

/// On the [Model B](crate::devices::MODEL_B): values of [`Mode`].
#[rustfmt::skip]
impl From<AckCode> for Mode {
    fn from(value: AckCode) -> Self {
        Self(value.0)
    }
}
