//! Copied measurements (0x92): All the fields of another set.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x92;

/// Third acceleration (0x92,0x01).
///
/// A vector whose elements are valid together.
///
/// Has the layout of [`measurements::Accel`](crate::measurements::Accel). Sent at 100 Hz at most.
///
/// Source: guide: Third acceleration.
pub type Accel = crate::measurements::Accel;

/// Numbers (0x92,0x02).
///
/// One of each.
///
/// Has the layout of [`measurements::Numbers`](crate::measurements::Numbers).
///
/// Source: sheet: Copied measurements.
pub type Numbers = crate::measurements::Numbers;

/// Strings (0x92,0x03).
///
/// Fixed, counted, and to the end.
///
/// Has the layout of [`measurements::Strings`](crate::measurements::Strings).
///
/// On the wire there is also `length`: Of the name. The number of elements of `name`.
///
/// Source: sheet: Copied measurements.
pub type Strings = crate::measurements::Strings;

/// Health (0x92,0x04).
///
/// The wide bitfield.
///
/// Deprecated: use [`measurements::Numbers`](crate::measurements::Numbers) instead. Has the layout
/// of [`measurements::Health`](crate::measurements::Health).
///
/// Source: sheet: Copied measurements.
pub type Health = crate::measurements::Health;

/// Arrays (0x92,0x05).
///
/// Arrays of all that can stand in one.
///
/// Has the layout of [`measurements::Arrays`](crate::measurements::Arrays).
///
/// Source: sheet: Copied measurements.
pub type Arrays = crate::measurements::Arrays;

/// Growing (0x92,0x06).
///
/// Newer devices send more of it.
///
/// Has the layout of [`measurements::Growing`](crate::measurements::Growing).
///
/// Source: sheet: Copied measurements.
pub type Growing = crate::measurements::Growing;

/// Radio (0x92,0x07).
///
/// A bool vouches for values; one source has no layout that agrees with it.
///
/// Has the layout of [`measurements::Radio`](crate::measurements::Radio). Also called `modem` and
/// `rf`. Uncertain: The leaflet gives the strength two bytes. Uncertain: Inferred: the strength is
/// never positive.
///
/// Source: sheet: Copied measurements.
pub type Radio = crate::measurements::Radio;

/// Cloud (0x92,0x08).
///
/// The count can exceed what a field holds beside the value behind the array.
///
/// Has the layout of [`measurements::Cloud`](crate::measurements::Cloud).
///
/// On the wire there is also `num_points`: Number of points. The number of elements of `points`.
///
/// Source: sheet: Copied measurements.
pub type Cloud = crate::measurements::Cloud;
