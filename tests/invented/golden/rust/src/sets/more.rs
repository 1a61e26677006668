//! More measurements (0x81): A second sensor with the fields of the first.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x81;

/// Second acceleration (0x81,0x01).
///
/// A vector whose elements are valid together.
///
/// Has the layout of [`measurements::Accel`](crate::measurements::Accel). Sent at 100 Hz at most.
/// Supported by Model A and Model C.
///
/// Source: guide: Second acceleration.
pub type Accel = crate::measurements::Accel;

/// Strings (0x81,0x03).
///
/// Fixed, counted, and to the end.
///
/// Has the layout of [`measurements::Strings`](crate::measurements::Strings). Supported by Model A.
///
/// On the wire there is also `length`: Of the name. The number of elements of `name`.
///
/// Source: guide: Second strings.
pub type Strings = crate::measurements::Strings;

record! {
    /// Own (0x81,0x07).
    ///
    /// Beside those that it repeats.
    ///
    /// Supported by Model A and Model C.
    ///
    /// Source: guide: Own.
    #[derive(Default)]
    pub struct Own {
        /// Of the second sensor.
        pub mode: types::Mode,
    }
}

field! {
    Own: 0x81, 0x07, "more.own";
}
