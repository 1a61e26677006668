//! Bits in numbers and in byte arrays, whose least significant byte comes first.

#![allow(dead_code, unused_imports, unused_macros)] // few parts of the specification use all of it

use core::fmt;

/// A flag, or a number of several bits, in a bitfield.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Bits {
    /// The name in the specification.
    pub name: &'static str,
    /// The lowest bit, counted from 0.
    pub first: u16,
    /// The highest bit; for a flag, the same bit.
    pub last: u16,
    /// The values of another member of the structure while which it means something; empty: all.
    pub states: &'static [u64],
}

/// The storage of a bitfield.
pub(crate) trait Storage: Copy {
    /// Returns the bits `first` to `last`, not shifted; the others are 0.
    fn part(self, first: u16, last: u16) -> Self;
    /// Returns the bits `first` to `last` as a number.
    fn get(self, first: u16, last: u16) -> u64;
    /// Sets the bits `first` to `last` to a number; its excess bits are dropped.
    fn set(&mut self, first: u16, last: u16, value: u64);
}

/// A value in some bits: a flag, a number or an enumeration.
pub(crate) trait Number: Copy {
    fn from_bits(bits: u64) -> Self;
    fn to_bits(self) -> u64;
}

/// Returns a mask of the bits `first` to `last` of a number.
pub(crate) const fn number_mask(first: u16, last: u16) -> u64 {
    let unused = 63_u16.saturating_sub(last.saturating_sub(first));
    (u64::MAX >> unused).wrapping_shl(first as u32)
}

/// Are all bits of a mask set? A mask of 0 stands for any bit, as in a `Bool`.
#[inline]
pub(crate) const fn are_set(bits: u64, mask: u64) -> bool {
    if mask == 0 {
        bits != 0
    } else {
        bits & mask == mask
    }
}

/// Returns a mask of the bits `first` to `last` of bytes.
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

macro_rules! merging {
    ($($name:ident($a:ident, $b:ident) = $merged:expr;)*) => {$(
        #[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)] // `i` is below N
        pub(crate) const fn $name<const N: usize>(one: [u8; N], other: [u8; N]) -> [u8; N] {
            let mut bytes = one;
            let mut i = 0;
            while i < N {
                let ($a, $b) = (one[i], other[i]);
                bytes[i] = $merged;
                i += 1;
            }
            bytes
        }
    )*};
}

merging! {
    and(a, b) = a & b;
    and_not(a, b) = a & !b;
    or(a, b) = a | b;
    xor(a, b) = a ^ b;
}

/// Is no bit set?
#[allow(clippy::arithmetic_side_effects, clippy::indexing_slicing)] // `i` is below N
pub(crate) const fn no_bytes<const N: usize>(bytes: [u8; N]) -> bool {
    let mut i = 0;
    while i < N {
        if bytes[i] != 0 {
            return false;
        }
        i += 1;
    }
    true
}

/// Combines the bits of two storages by an operation: `and`, `and_not`, `or` or `xor`.
macro_rules! merge {
    ([u8; $size:literal], $how:ident, $a:expr, $b:expr) => {
        $crate::bits::$how($a, $b)
    };
    ($number:ident, and, $a:expr, $b:expr) => {
        $a & $b
    };
    ($number:ident, and_not, $a:expr, $b:expr) => {
        $a & !$b
    };
    ($number:ident, or, $a:expr, $b:expr) => {
        $a | $b
    };
    ($number:ident, xor, $a:expr, $b:expr) => {
        $a ^ $b
    };
}

/// Implements the number formats of a storage; byte arrays have only the hexadecimal ones.
macro_rules! formats {
    ($name:ident [u8; $size:literal]) => {
        impl ::core::fmt::LowerHex for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::bits::hexadecimal(&self.0, false, f)
            }
        }

        impl ::core::fmt::UpperHex for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::bits::hexadecimal(&self.0, true, f)
            }
        }
    };
    ($name:ident $number:ident) => {
        $crate::bits::formats!($name $number LowerHex UpperHex Octal Binary);
    };
    ($name:ident $number:ident $($format:ident)+) => {$(
        impl ::core::fmt::$format for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                ::core::fmt::$format::fmt(&self.0, f)
            }
        }
    )+};
}

macro_rules! none {
    ([u8; $size:literal]) => {
        [0; $size]
    };
    ($number:ident) => {
        0
    };
}

macro_rules! is_none {
    ([u8; $size:literal], $bits:expr) => {
        $crate::bits::no_bytes($bits)
    };
    ($number:ident, $bits:expr) => {
        $bits == 0
    };
}

macro_rules! mask {
    ([u8; $size:literal], $first:literal $(, $last:literal)?) => {
        $crate::bits::bytes_mask::<$size>($first, $crate::bits::last!($first $(, $last)?))
    };
    ($number:ident, $first:literal $(, $last:literal)?) => {
        $crate::bits::number_mask($first, $crate::bits::last!($first $(, $last)?)) as $number
    };
}

/// The last bit: the second argument, or the only one for a flag.
macro_rules! last {
    ($first:literal) => {
        $first
    };
    ($first:literal, $last:literal) => {
        $last
    };
}

pub(crate) use {formats, is_none, last, mask, merge, none};

macro_rules! numbers {
    ($($number:ident)*) => {$(
        impl Storage for $number {
            #[inline]
            fn part(self, first: u16, last: u16) -> Self {
                self & number_mask(first, last) as Self
            }

            #[inline]
            fn get(self, first: u16, last: u16) -> u64 {
                (u64::from(self) & number_mask(first, last)).wrapping_shr(first.into())
            }

            #[inline]
            fn set(&mut self, first: u16, last: u16, value: u64) {
                let mask = number_mask(first, last);
                let bits = (u64::from(*self) & !mask) | (value.wrapping_shl(first.into()) & mask);
                *self = Self::from_bits(bits);
            }
        }

        impl Number for $number {
            #[inline]
            fn from_bits(bits: u64) -> Self {
                bits as Self
            }

            #[inline]
            fn to_bits(self) -> u64 {
                self.into()
            }
        }

        impl Hexadecimal for $number {
            fn write(&self, separator: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    0 => Ok(()),
                    bits => write!(f, "{separator}{bits:#x}"),
                }
            }
        }
    )*};
}

numbers!(u8 u16 u32 u64);

macro_rules! signed {
    ($($number:ident)*) => {$(
        impl Number for $number {
            #[inline]
            fn from_bits(bits: u64) -> Self {
                bits as Self
            }

            #[inline]
            fn to_bits(self) -> u64 {
                self as u64
            }
        }
    )*};
}

signed!(i8 i16 i32 i64);

impl Number for bool {
    #[inline]
    fn from_bits(bits: u64) -> Self {
        bits != 0
    }

    #[inline]
    fn to_bits(self) -> u64 {
        self.into()
    }
}

impl<const N: usize> Storage for [u8; N] {
    fn part(self, first: u16, last: u16) -> Self {
        let mut part = [0; N];
        part.set(first, last, u64::MAX);
        and(self, part)
    }

    #[inline]
    fn get(self, first: u16, last: u16) -> u64 {
        (first..=last).rev().fold(0, |value, bit| {
            let byte = self.as_slice().get(usize::from(bit / 8)).copied().unwrap_or_default();
            (value << 1) | u64::from((byte >> (bit % 8)) & 1)
        })
    }

    #[inline]
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

/// The operations of a bitfield that its iterators need.
pub trait BitSet: Copy {
    /// Returns the bits `first` to `last`, not shifted; the others are 0.
    #[must_use]
    fn part(self, first: u16, last: u16) -> Self;
    /// Returns the bits that are set here and not in `other`.
    #[must_use]
    fn without(self, other: Self) -> Self;
    /// Is no bit set?
    #[must_use]
    fn none(self) -> bool;
}

/// An iterator over the set bits of a bitfield with their names; from `iter_names`.
#[derive(Clone, Debug)]
pub struct IterNames<B> {
    left: B,
    bits: core::slice::Iter<'static, Bits>,
    state: Option<u64>,
}

impl<B> IterNames<B> {
    pub(crate) fn new(left: B, bits: &'static [Bits], state: Option<u64>) -> Self {
        Self { left, bits: bits.iter(), state }
    }
}

impl<B: BitSet> Iterator for IterNames<B> {
    type Item = (&'static str, B);

    fn next(&mut self) -> Option<Self::Item> {
        let (left, state) = (self.left, self.state);
        let found = self.bits.find(|bits| {
            let here = bits.states.is_empty() || state.map_or(true, |s| bits.states.contains(&s));
            here && !left.part(bits.first, bits.last).none()
        })?;
        let part = left.part(found.first, found.last);
        self.left = left.without(part);
        Some((found.name, part))
    }
}

/// Writes the names of the bits that are set, the numbers that are not 0, and the remaining bits.
///
/// A name is omitted if earlier names cover all of its bits.
pub(crate) fn debug<S: Storage + Hexadecimal>(
    name: &str,
    storage: S,
    bits: &[Bits],
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    write!(f, "{name}(")?;
    text(storage, bits, f)?;
    f.write_str(")")
}

/// Writes the names of the bits that are set, as in `ready | level=3 | 0x40`.
pub(crate) fn text<S: Storage + Hexadecimal>(
    storage: S,
    bits: &[Bits],
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    let (mut left, mut separator) = (storage, "");
    for Bits { name, first, last, .. } in bits {
        let number = storage.get(*first, *last);
        if number == 0 || left.get(*first, *last) != number {
            continue;
        }
        left.set(*first, *last, 0);
        if first == last {
            write!(f, "{separator}{name}")?;
        } else {
            write!(f, "{separator}{name}={number}")?;
        }
        separator = " | ";
    }
    left.write(separator, f)
}

/// Writes bytes as one hexadecimal number.
pub(crate) fn hexadecimal<const N: usize>(
    bytes: &[u8; N],
    upper: bool,
    f: &mut fmt::Formatter<'_>,
) -> fmt::Result {
    let mut text = [b'0'; 128]; // no bitfield has more than 64 bytes
    let digits = bytes.iter().rev().flat_map(|byte| [byte >> 4, byte & 15]);
    let digits = digits.skip_while(|digit| *digit == 0);
    let mut count = 0_usize;
    for (place, digit) in text.iter_mut().zip(digits) {
        let letter = if upper { b'A' } else { b'a' };
        *place = match digit {
            0..=9 => b'0'.wrapping_add(digit),
            _ => letter.wrapping_add(digit).wrapping_sub(10),
        };
        count = count.wrapping_add(1);
    }
    let text = text.as_slice().get(..count.max(1)).and_then(|text| core::str::from_utf8(text).ok());
    f.pad_integral(true, "0x", text.unwrap_or_default())
}

/// Writes the bits without a name as a hexadecimal number.
pub(crate) trait Hexadecimal {
    /// Writes the number if it is not 0.
    fn write(&self, separator: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result;
}

impl<const N: usize> Hexadecimal for [u8; N] {
    fn write(&self, separator: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut bytes = self.iter().rev().skip_while(|byte| **byte == 0);
        if let Some(first) = bytes.next() {
            write!(f, "{separator}{first:#x}")?;
        }
        bytes.try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}
