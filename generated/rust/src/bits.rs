//! Bits of numbers, and of byte arrays whose least significant byte comes first.

use core::fmt;

/// A named bit, or a number of several bits, inside a bitfield.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bits {
    /// The name in the specification.
    pub name: &'static str,
    /// The lowest bit, counted from 0.
    pub first: u16,
    /// The highest bit; for a flag, the same bit.
    pub last: u16,
}

/// The storage of a bitfield.
pub(crate) trait Storage: Copy {
    fn and(self, other: Self) -> Self;
    fn and_not(self, other: Self) -> Self;
    fn or(self, other: Self) -> Self;
    /// The bits `first` to `last` as a number.
    fn get(self, first: u16, last: u16) -> u64;
    /// Sets the bits `first` to `last` to a number; its excess bits are dropped.
    fn set(&mut self, first: u16, last: u16, value: u64);
}

/// A value in some bits: a flag, a number or an enumeration.
pub(crate) trait Number: Copy {
    fn from_bits(bits: u64) -> Self;
    fn to_bits(self) -> u64;
}

/// The bits `first` to `last` of a number.
pub(crate) const fn number_mask(first: u16, last: u16) -> u64 {
    let unused = 63_u16.saturating_sub(last.saturating_sub(first));
    (u64::MAX >> unused) << first
}

/// The bits `first` to `last` of bytes.
#[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)] // used in constants only
pub(crate) const fn bytes_mask<const N: usize>(first: u16, last: u16) -> [u8; N] {
    let mut bytes = [0; N];
    let mut bit = first;
    while bit <= last {
        bytes[bit as usize / 8] |= 1 << (bit % 8);
        bit += 1;
    }
    bytes
}

macro_rules! mask {
    ([u8; $size:literal], $first:literal $(, $last:literal)?) => {
        $crate::bits::bytes_mask::<$size>($first, $crate::bits::last!($first $(, $last)?))
    };
    ($number:ident, $first:literal $(, $last:literal)?) => {
        $crate::bits::number_mask($first, $crate::bits::last!($first $(, $last)?)) as $number
    };
}

/// The highest of some bits; a flag has only one.
macro_rules! last {
    ($first:literal) => {
        $first
    };
    ($first:literal, $last:literal) => {
        $last
    };
}

pub(crate) use {last, mask};

macro_rules! numbers {
    ($($number:ident)*) => {$(
        impl Storage for $number {
            fn and(self, other: Self) -> Self {
                self & other
            }

            fn and_not(self, other: Self) -> Self {
                self & !other
            }

            fn or(self, other: Self) -> Self {
                self | other
            }

            fn get(self, first: u16, last: u16) -> u64 {
                (u64::from(self) & number_mask(first, last)) >> first
            }

            fn set(&mut self, first: u16, last: u16, value: u64) {
                let mask = number_mask(first, last);
                let bits = (u64::from(*self) & !mask) | ((value << first) & mask);
                *self = Self::from_bits(bits);
            }
        }

        impl Number for $number {
            fn from_bits(bits: u64) -> Self {
                bits as Self
            }

            fn to_bits(self) -> u64 {
                self.into()
            }
        }
    )*};
}

numbers!(u8 u16 u32 u64);

impl Number for bool {
    fn from_bits(bits: u64) -> Self {
        bits != 0
    }

    fn to_bits(self) -> u64 {
        self.into()
    }
}

impl<const N: usize> Storage for [u8; N] {
    fn and(mut self, other: Self) -> Self {
        self.iter_mut().zip(other).for_each(|(a, b)| *a &= b);
        self
    }

    fn and_not(mut self, other: Self) -> Self {
        self.iter_mut().zip(other).for_each(|(a, b)| *a &= !b);
        self
    }

    fn or(mut self, other: Self) -> Self {
        self.iter_mut().zip(other).for_each(|(a, b)| *a |= b);
        self
    }

    fn get(self, first: u16, last: u16) -> u64 {
        (first..=last).rev().fold(0, |value, bit| {
            let byte = self.as_slice().get(usize::from(bit / 8)).copied().unwrap_or_default();
            (value << 1) | u64::from((byte >> (bit % 8)) & 1)
        })
    }

    fn set(&mut self, first: u16, last: u16, mut value: u64) {
        for bit in first..=last {
            if let Some(byte) = self.get_mut(usize::from(bit / 8)) {
                let flag = 1_u8 << (bit % 8);
                *byte = if value & 1 == 0 { *byte & !flag } else { *byte | flag };
            }
            value >>= 1;
        }
    }
}

/// Writes the names of the bits that are set, and the numbers that are not 0.
pub(crate) fn debug<S: Storage>(
    storage: S,
    bits: &[Bits],
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    let mut separator = "";
    for Bits { name, first, last } in bits {
        match storage.get(*first, *last) {
            0 => continue,
            _ if first == last => write!(f, "{separator}{name}")?,
            number => write!(f, "{separator}{name}={number}")?,
        }
        separator = " | ";
    }
    Ok(())
}
