//! More measurements (0x81): A second sensor with the fields of the first.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x81;

record! {
    /// Second acceleration (0x81,0x01).
    ///
    /// A vector whose elements are valid together.
    ///
    /// Has the layout of [`measurements::Accel`](crate::measurements::Accel). Maximum rate: 100 Hz.
    /// Supported by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Second acceleration.
    #[derive(Copy, Default)]
    pub struct Accel {
        /// Specific force.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor. Each element has its own valid flag. x:
        /// [`valid_flags.ready`](types::StateFlags::ready), y:
        /// [`valid_flags.hot`](types::StateFlags::hot), z:
        /// [`valid_flags.ready`](types::StateFlags::ready).
        pub scaled_accel: types::Vector3f,
        /// What is valid.
        pub valid_flags: types::StateFlags,
    }
}

field! {
    Accel: 0x81, 0x01, "more.accel";
}

record! {
    /// Strings (0x81,0x03).
    ///
    /// Fixed, counted, and to the end.
    ///
    /// Has the layout of [`measurements::Strings`](crate::measurements::Strings). Supported by
    /// [Model A](crate::devices::MODEL_A).
    ///
    /// The wire format also contains `length`: Of the name. The number of elements of
    /// [`name`](Strings::name).
    ///
    /// Source: guide: Second strings.
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

field! {
    Strings: 0x81, 0x03, "more.strings";
}

record! {
    /// Own (0x81,0x07).
    ///
    /// Beside those that it repeats.
    ///
    /// Supported by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Own.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Own {
        /// Of the second sensor.
        pub mode: types::Mode,
    }
}

field! {
    Own: 0x81, 0x07, "more.own";
}
