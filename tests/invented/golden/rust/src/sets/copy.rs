//! Copied measurements (0x92): All the fields of another set.
//!
//! Uncertain: Which device sends it.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x92;

/// Third acceleration (0x92,0x01).
///
/// A vector whose elements are valid together.
///
/// Has the layout of [`measurements::Accel`](crate::measurements::Accel). Sent at 100 Hz at most.
/// May be supported by Model C.
///
/// Source: guide: Third acceleration.
pub type Accel = crate::measurements::Accel;

/// Numbers (0x92,0x02).
///
/// One of each.
///
/// Has the layout of [`measurements::Numbers`](crate::measurements::Numbers). No device profile
/// lists it. Known from the Kit of names only.
///
/// Source: sheet: Copied measurements.
pub type Numbers = crate::measurements::Numbers;

/// Strings (0x92,0x03).
///
/// Fixed, counted, and to the end.
///
/// Has the layout of [`measurements::Strings`](crate::measurements::Strings). No device profile
/// lists it. Known from the Kit of names only.
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
/// of [`measurements::Health`](crate::measurements::Health). No device profile lists it. Known from
/// the Kit of names only.
///
/// Source: sheet: Copied measurements.
pub type Health = crate::measurements::Health;

/// Arrays (0x92,0x05).
///
/// Arrays of all that can stand in one.
///
/// Has the layout of [`measurements::Arrays`](crate::measurements::Arrays). No device profile lists
/// it. Known from the Kit of names only.
///
/// Source: sheet: Copied measurements.
pub type Arrays = crate::measurements::Arrays;

/// Growing (0x92,0x06).
///
/// Newer devices send more of it.
///
/// Has the layout of [`measurements::Growing`](crate::measurements::Growing). No device profile
/// lists it. Known from the Kit of names only.
///
/// Source: sheet: Copied measurements.
pub type Growing = crate::measurements::Growing;

/// Radio (0x92,0x07).
///
/// A bool vouches for values; one source has no layout that agrees with it.
///
/// Has the layout of [`measurements::Radio`](crate::measurements::Radio). Also called `modem` and
/// `rf`. No device profile lists it. Known from the Kit of names only. Uncertain: The leaflet gives
/// the strength two bytes. Uncertain: Inferred: the strength is never positive.
///
/// Source: sheet: Copied measurements.
pub type Radio = crate::measurements::Radio;

/// Cloud (0x92,0x08).
///
/// The count can exceed what a field holds beside the value behind the array.
///
/// Has the layout of [`measurements::Cloud`](crate::measurements::Cloud). No device profile lists
/// it. Known from the Kit of names only.
///
/// On the wire there is also `num_points`: Number of points. The number of elements of `points`.
///
/// Source: sheet: Copied measurements.
pub type Cloud = crate::measurements::Cloud;

/// Gust (0x92,0x09).
///
/// One valid flag for all values but one; [`measurements::Breeze`](crate::measurements::Breeze) has
/// the same place.
///
/// Has the layout of [`measurements::Gust`](crate::measurements::Gust). No device profile lists it.
/// Known from the Kit of names only.
///
/// On the wire there is also `gap`: Always the same. Always 7.
///
/// - `speed * 3.6` is in km/h, and `valid_flags` tells whether `speed` counts; see [`types::Mode`]
///   and [`tools::Shape`](crate::tools::Shape).
///
/// Source: sheet: Copied measurements.
pub type Gust = crate::measurements::Gust;

/// Breeze (0x92,0x0A).
///
/// Its place is told as in [`measurements::Gust`](crate::measurements::Gust).
///
/// Has the layout of [`measurements::Breeze`](crate::measurements::Breeze). No device profile lists
/// it. Known from the Kit of names only.
///
/// Source: sheet: Copied measurements.
pub type Breeze = crate::measurements::Breeze;
