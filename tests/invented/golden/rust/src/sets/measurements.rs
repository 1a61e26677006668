//! Measurements (0x80, 0x81, 0x92): Data of every type; `tools` has what they are set up with.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// Measurements (0x80): Data of every type; `tools` has what they are set up with.
pub const MEASUREMENTS_SET: u8 = 0x80;

/// More measurements (0x81): A second sensor with some fields of the first.
pub const MORE_SET: u8 = 0x81;

/// Copied measurements (0x92): All the fields of another set.
///
/// Uncertain: Which device sends it.
pub const COPY_SET: u8 = 0x92;

record! {
    /// Acceleration (0x01).
    ///
    /// A vector whose elements are valid together.
    ///
    /// Occurs in measurements (0x80), more (0x81) and copy (0x92). Maximum rate: 100 Hz. Supported
    /// by [Model A](crate::devices::MODEL_A), [Model B](crate::devices::MODEL_B) and [Model
    /// C](crate::devices::MODEL_C). On the [Model C](crate::devices::MODEL_C): firmware \> 1.0.07.
    ///
    /// Source: guide: Acceleration; leaflet: Acceleration; guide: Second acceleration; guide: Third
    /// acceleration.
    #[derive(Copy, Default)]
    pub struct Accel {
        /// Specific force.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor. At rest and level: x 0, z -1. Positive: along
        /// [`types::Point`]. Each element has its own valid flag. x:
        /// [`valid_flags.ready`](types::StateFlags::ready), y:
        /// [`valid_flags.hot`](types::StateFlags::hot), z:
        /// [`valid_flags.ready`](types::StateFlags::ready). On the [Model
        /// B](crate::devices::MODEL_B): unit m, m, s; frame ned; valid flags x:
        /// [`valid_flags.hot`](types::StateFlags::hot), y:
        /// [`valid_flags.ready`](types::StateFlags::ready), z:
        /// [`valid_flags.hot`](types::StateFlags::hot). Turned by the device. On the [Model
        /// C](crate::devices::MODEL_C): no flag marks it as valid.
        pub scaled_accel: types::Vector3f,
        /// What is valid.
        ///
        /// On the [Model C](crate::devices::MODEL_C): only [`ready`](types::StateFlags::ready) and
        /// [`level`](types::StateFlags::level).
        pub valid_flags: types::StateFlags,
    }
}

view! {
    Accel
    scaled_accel: types::Vector3f, at 0;
    valid_flags: types::StateFlags, at 12;
}

constructors! {
    Accel

    /// Creates it from its values.
    fn new(scaled_accel: impl Into<types::Vector3f>, valid_flags: types::StateFlags);
}

field! {
    Accel: 0x01, "measurements.accel";
    in [0x80 0x81 0x92];
}

record! {
    /// Numbers (0x02).
    ///
    /// One of each.
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Numbers.
    #[derive(Copy, Default)]
    pub struct Numbers {
        /// Unsigned.
        pub u8: u8,
        /// Unsigned.
        pub u16: u16,
        /// Unsigned.
        pub u32: u32,
        /// Unsigned.
        pub u64: u64,
        /// Signed.
        pub s8: i8,
        /// Signed.
        pub s16: i16,
        /// Signed.
        pub s32: i32,
        /// Signed.
        pub s64: i64,
        /// Four bytes.
        ///
        /// Unit: 1.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub float: f32,
        /// Eight bytes.
        ///
        /// Unit: 1.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub double: f64,
        /// True or false.
        pub bool: crate::Bool,
        /// One character.
        pub char: u8,
    }
}

view! {
    Numbers
    u8: u8, at 0;
    u16: u16, at 1;
    u32: u32, at 3;
    u64: u64, at 7;
    s8: i8, at 15;
    s16: i16, at 16;
    s32: i32, at 18;
    s64: i64, at 22;
    float: f32, at 30;
    double: f64, at 34;
    bool: crate::Bool, at 42;
    char: u8, at 43;
}

constructors! {
    Numbers

    /// Creates it from its values.
    fn new(
        u8: u8,
        u16: u16,
        u32: u32,
        u64: u64,
        s8: i8,
        s16: i16,
        s32: i32,
        s64: i64,
        float: f32,
        double: f64,
        bool: bool,
        char: u8,
    );
}

field! {
    Numbers: 0x02, "measurements.numbers";
    in [0x80 0x92];
}

record! {
    /// Strings (0x03).
    ///
    /// Fixed, counted, and to the end.
    ///
    /// Occurs in measurements (0x80), more (0x81) and copy (0x92). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `length`: Of the name. Counts the elements of
    /// [`name`](Strings::name).
    ///
    /// Source: guide: Strings; guide: Second strings.
    #[derive(Default, Eq, Hash)]
    pub struct Strings {
        /// Padded with spaces.
        pub model: crate::Text<16>,
        /// The name.
        pub name: crate::VarText<236>,
        /// All that follows.
        pub rest: crate::VarText<236>,
    }
    wire 253 {
        [model]
        [length: u8 counts name]
        [name by length]
        [rest]
    }
}

constructors! {
    Strings

    /// Creates it from its values.
    fn new(
        model: crate::Text<16>,
        name: crate::VarText<236>,
        rest: crate::VarText<236>,
    );
}

field! {
    Strings: 0x03, "measurements.strings";
    in [0x80 0x81 0x92];
}

record! {
    /// Health (0x04).
    ///
    /// The wide bitfield.
    ///
    /// Deprecated: use [`Numbers`] instead. Occurs in measurements (0x80) and copy (0x92).
    /// Supported by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Health.
    #[derive(Copy, Default, Eq, Hash)]
    #[deprecated(note = "use `measurements.numbers` instead")]
    pub struct Health {
        /// The bits.
        pub result: types::Health,
        /// An enumeration over four bytes.
        pub code: types::WideCode,
    }
}

view! {
    Health
    result: types::Health, at 0;
    code: types::WideCode, at 16;
}

constructors! {
    Health

    /// Creates it from its values.
    fn new(result: types::Health, code: types::WideCode);
}

field! {
    Health: 0x04, "measurements.health";
    in [0x80 0x92];
}

record! {
    /// Arrays (0x05).
    ///
    /// Arrays of all that can stand in one.
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Arrays.
    #[derive(Copy, Default)]
    pub struct Arrays {
        /// Enumerations.
        pub modes: [types::Mode; 3],
        /// Bitfields.
        pub flags: [types::StateFlags; 2],
        /// Vectors.
        ///
        /// Elements: x, y, z. Unit: m.
        pub vectors: [types::Vector3f; 2],
        /// Structures.
        ///
        /// Unit: m.
        pub points: [types::Point; 2],
        /// A nested structure.
        pub track: types::Segment,
        /// Reserved.
        pub offsets: [i8; 4],
    }
}

view! {
    Arrays
    modes: [types::Mode; 3], at 0;
    flags: [types::StateFlags; 2], at 3;
    vectors: [types::Vector3f; 2], at 7;
    points: [types::Point; 2], at 31;
    track as types::Segment, at 39;
    offsets: [i8; 4], at 49;
}

constructors! {
    Arrays

    /// Creates it from its values.
    fn new(
        modes: [types::Mode; 3],
        flags: [types::StateFlags; 2],
        vectors: [types::Vector3f; 2],
        points: [types::Point; 2],
        track: types::Segment,
    ), offsets: [0; 4];
}

field! {
    Arrays: 0x05, "measurements.arrays";
    in [0x80 0x92];
}

record! {
    /// Growing (0x06).
    ///
    /// Newer devices send more of it.
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Growing.
    #[derive(Copy, Default)]
    pub struct Growing {
        /// Always there.
        pub first: u16,
        /// From version 2 on.
        ///
        /// Optional.
        pub second: Option<u16>,
        /// From version 3 on.
        ///
        /// Unit: deg. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub third: Option<f32>,
    }
    wire 8 {
        [first]
        [second optional]
        [third optional]
    }
}

constructors! {
    Growing

    /// Creates it from its values.
    fn new(first: u16), second: None, third: None;
}

field! {
    Growing: 0x06, "measurements.growing";
    in [0x80 0x92];
}

record! {
    /// Radio (0x07).
    ///
    /// A bool vouches for values; one source has no layout that agrees with it.
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Also called `modem` and `rf`. Supported by
    /// [Model C](crate::devices::MODEL_C). Known only from the Kit of names. Uncertain: The leaflet
    /// gives the strength two bytes. Uncertain: Inferred: the strength is never positive.
    ///
    /// Source: sheet: Radio.
    #[derive(Copy, Default)]
    pub struct Radio {
        /// Whether there is a connection.
        pub connected: crate::Bool,
        /// Of the signal.
        ///
        /// Range: less than 1. Valid if [`connected`](Radio::connected) is true. Uncertain: Its
        /// unit.
        pub strength: i32,
        /// Never nothing.
        ///
        /// Unit: m. Range: greater than 0, at most 10. Valid if [`connected`](Radio::connected) is
        /// true. On the [Model C](crate::devices::MODEL_C): valid if
        /// [`connected`](Radio::connected) is true; deprecated.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub noise: f32,
        /// Reserved.
        ///
        /// Reserved.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub gap: f32,
        /// Reserved.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub gaps: [f64; 2],
    }
}

view! {
    Radio
    connected: crate::Bool, at 0;
    strength: i32, at 1;
    noise: f32, at 5;
    gap: f32, at 9;
    gaps: [f64; 2], at 13;
}

constructors! {
    Radio

    /// Creates it from its values.
    fn new(
        connected: bool,
        strength: i32,
        noise: f32,
    ), gap: 0.0, gaps: [0.0; 2];
}

field! {
    Radio: 0x07, "measurements.radio";
    in [0x80 0x92];
}

record! {
    /// Own (0x81,0x07).
    ///
    /// In one of the sets only, with a descriptor that has another layout in the others.
    ///
    /// Supported by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C). On
    /// the [Model C](crate::devices::MODEL_C): firmware \> 1.0.07.
    ///
    /// Source: guide: Own.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Own {
        /// Of the second sensor.
        pub mode: types::Mode,
    }
}

view! {
    Own
    mode: types::Mode, at 0;
}

constructors! {
    Own

    /// Creates it from its values.
    fn new(mode: types::Mode);
}

field! {
    Own: 0x07, "measurements.own";
    in [0x81];
}

record! {
    /// Cloud (0x08).
    ///
    /// The count can exceed what a field holds beside the value behind the array.
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// The wire format also contains `num_points`: Number of points. Counts the elements of
    /// [`points`](Cloud::points).
    ///
    /// Source: guide: Cloud.
    #[derive(Default, Eq, Hash)]
    pub struct Cloud {
        /// The points.
        pub points: crate::List<types::Point, 61>,
        /// Behind an array that fills the field.
        ///
        /// Unit: s.
        pub stamp: u64,
    }
    wire 253 {
        [num_points: u8 counts points]
        [points by num_points]
        [stamp]
    }
}

constructors! {
    Cloud

    /// Creates it from its values.
    fn new(points: impl Into<crate::List<types::Point, 61>>, stamp: u64);
}

field! {
    Cloud: 0x08, "measurements.cloud";
    in [0x80 0x92];
}

record! {
    /// Gust (0x09).
    ///
    /// One valid flag for all values but one; [`Breeze`] has the same place.
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Not listed in any device profile.
    ///
    /// The wire format also contains `gap`: Always the same. Always 7.
    ///
    /// - `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see
    ///   [`types::Mode`] and [`tools::Shape`](crate::tools::Shape).
    ///
    /// Source: guide: Gust.
    #[derive(Copy, Default)]
    pub struct Gust {
        /// Which one.
        pub station: u8,
        /// Where it was measured.
        ///
        /// Valid if [`valid_flags.ready`](types::StateFlags::ready) is set.
        pub place: types::Point,
        /// Above the plane.
        ///
        /// Unit: m. Valid if [`valid_flags.ready`](types::StateFlags::ready) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub height: f32,
        /// Of the wind.
        ///
        /// Elements: x, y, z. Unit: m. Range: magnitude at most 40. Valid if
        /// [`valid_flags.ready`](types::StateFlags::ready) is set.
        pub speed: types::Vector3f,
        /// What is valid.
        pub valid_flags: types::StateFlags,
    }
    wire 24 {
        [station]
        [place]
        [height]
        [speed]
        [gap: u8 = 7]
        [valid_flags]
    }
}

constructors! {
    Gust

    /// Creates it from its values.
    fn new(
        station: u8,
        place: types::Point,
        height: f32,
        speed: impl Into<types::Vector3f>,
        valid_flags: types::StateFlags,
    );
}

field! {
    Gust: 0x09, "measurements.gust";
    in [0x80 0x92];
}

record! {
    /// Breeze (0x0A).
    ///
    /// Its place is told as in [`Gust`].
    ///
    /// Occurs in measurements (0x80) and copy (0x92). Supported by [Model
    /// A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Breeze.
    #[derive(Copy, Default)]
    pub struct Breeze {
        /// Where it was measured.
        pub place: types::Point,
        /// Above the plane.
        ///
        /// Unit: m.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub height: f32,
        /// Of the vane.
        ///
        /// Elements: w, x, y, z. Unit: 1. Range: -1 to 1, magnitude 0.5 to 1.5. Default: 1, 0, 0,
        /// 0.
        pub turn: types::Quatf,
    }
}

view! {
    Breeze
    place as types::Point, at 0;
    height: f32, at 4;
    turn: types::Quatf, at 8;
}

constructors! {
    Breeze

    /// Creates it from its values.
    fn new(
        place: types::Point,
        height: f32,
        turn: impl Into<types::Quatf>,
    );
}

field! {
    Breeze: 0x0A, "measurements.breeze";
    in [0x80 0x92];
}
