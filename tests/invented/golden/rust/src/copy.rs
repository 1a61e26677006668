//! Copied measurements (0x92): All the fields of another set.

/// The number of the descriptor set.
pub const SET: u8 = 0x92;

/// (0x92,0x01) Third acceleration: the same as [`measurements.accel`](crate::measurements::Accel).
///
/// - Manual guide: Third acceleration
pub type Accel = crate::measurements::Accel;

/// (0x92,0x02) Numbers: the same as [`measurements.numbers`](crate::measurements::Numbers).
///
/// - Manual sheet: Copied measurements
pub type Numbers = crate::measurements::Numbers;

/// (0x92,0x03) Strings: the same as [`measurements.strings`](crate::measurements::Strings).
///
/// - Manual sheet: Copied measurements
pub type Strings = crate::measurements::Strings;

/// (0x92,0x04) Health: the same as [`measurements.health`](crate::measurements::Health).
///
/// - Manual sheet: Copied measurements
pub type Health = crate::measurements::Health;

/// (0x92,0x05) Arrays: the same as [`measurements.arrays`](crate::measurements::Arrays).
///
/// - Manual sheet: Copied measurements
pub type Arrays = crate::measurements::Arrays;

/// (0x92,0x06) Growing: the same as [`measurements.growing`](crate::measurements::Growing).
///
/// - Manual sheet: Copied measurements
pub type Growing = crate::measurements::Growing;

/// (0x92,0x07) Radio: the same as [`measurements.radio`](crate::measurements::Radio).
///
/// - Manual sheet: Copied measurements
pub type Radio = crate::measurements::Radio;
