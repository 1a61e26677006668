//! The ranges of values, which the specification states for some.

use crate::error::RangeError;
use crate::list::List;
use crate::protocol::DescriptorSet;

/// The bounds of a range.
#[derive(Clone, Copy)]
pub(crate) enum Bound {
    From(f64),
    Above(f64),
    To(f64),
    Below(f64),
}

/// A number, or several, of which each must be in the range.
pub(crate) trait Limited {
    /// Returns a number beyond the bound, or that is not a number.
    fn outside(&self, bound: Bound) -> Option<f64>;
}

macro_rules! limited {
    ($($number:ident)*) => {$(
        impl Limited for $number {
            #[allow(clippy::cast_lossless)] // one macro for all numbers
            fn outside(&self, bound: Bound) -> Option<f64> {
                // Bounds have the precision of the value: the `f32` next to π is greater than π.
                let inside = match bound {
                    Bound::From(least) => *self >= least as $number,
                    Bound::Above(least) => *self > least as $number,
                    Bound::To(most) => *self <= most as $number,
                    Bound::Below(most) => *self < most as $number,
                };
                (!inside).then_some(*self as f64)
            }
        }
    )*};
}

limited! { u8 u16 u32 u64 i8 i16 i32 i64 f32 f64 }

impl Limited for DescriptorSet {
    fn outside(&self, bound: Bound) -> Option<f64> {
        self.0.outside(bound)
    }
}

impl<T: Limited> Limited for Option<T> {
    fn outside(&self, bound: Bound) -> Option<f64> {
        self.as_ref().and_then(|value| value.outside(bound))
    }
}

impl<T: Limited, const N: usize> Limited for [T; N] {
    fn outside(&self, bound: Bound) -> Option<f64> {
        self.iter().find_map(|value| value.outside(bound))
    }
}

impl<T: Limited, const N: usize> Limited for List<T, N> {
    fn outside(&self, bound: Bound) -> Option<f64> {
        self.iter().find_map(|value| value.outside(bound))
    }
}

/// A structure, field or union whose values have ranges.
pub(crate) trait Ranged {
    /// Returns the error for the first value out of its range, in the field with this name.
    fn check_in(&self, field: &'static str) -> Result<(), RangeError>;
}

impl<T: Ranged> Ranged for Option<T> {
    fn check_in(&self, field: &'static str) -> Result<(), RangeError> {
        self.iter().try_for_each(|value| value.check_in(field))
    }
}

impl<T: Ranged, const N: usize> Ranged for [T; N] {
    fn check_in(&self, field: &'static str) -> Result<(), RangeError> {
        self.iter().try_for_each(|value| value.check_in(field))
    }
}

impl<T: Ranged, const N: usize> Ranged for List<T, N> {
    fn check_in(&self, field: &'static str) -> Result<(), RangeError> {
        self.iter().try_for_each(|value| value.check_in(field))
    }
}
