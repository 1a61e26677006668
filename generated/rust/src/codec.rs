//! The wire format of values: big-endian, one after another, without padding.
//!
//! [`Wire`] is implemented by all types with a wire format: numbers, enumerations, bitfields,
//! structures and fields. [`Reader`] and [`Writer`] work on borrowed bytes and never panic.

// All methods have the same errors, which the reader and the writer describe.
#![allow(clippy::missing_errors_doc)]

use core::fmt;

use crate::bits::Number;
pub use crate::error::{DecodeError, DecodeErrorKind, EncodeError, EncodeErrorKind, ReadError};
use crate::list::Item;
use crate::packet::MAX_FIELD_DATA;

/// A value with a wire format.
pub trait Wire: Sized {
    /// The maximum size in bytes; types of fixed size always have this size.
    const SIZE: usize;
    /// Does every value have this size? Then too few bytes are the only possible error.
    const FIXED: bool = false;

    /// Reads one value.
    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError>;

    /// Writes the value.
    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind>;
}

/// One of several alternatives, selected by another value, the tag.
pub trait Union: Sized {
    /// The type of the tag.
    type Tag;

    /// Reads the alternative that a tag selects.
    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, ReadError>;

    /// Writes the value if it is the alternative that the tag selects.
    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind>;
}

/// Items counted by another value. As a [`Wire`], they fill the rest of the data.
pub trait Counted: Wire {
    /// Reads this number of items.
    fn decode_counted(count: usize, reader: &mut Reader<'_>) -> Result<Self, ReadError>;
}

/// Reads values from the front of a field's data.
///
/// It remembers the last error: its functions return only [`ReadError`], which is small and fast, and
/// [`Reader::error`] returns the details.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    data: &'a [u8],
    length: usize,
    ended: bool,
    kind: DecodeErrorKind,
    need: usize,
    got: usize,
}

impl<'a> Reader<'a> {
    /// Creates a reader that starts at the front of the data.
    #[inline]
    #[must_use]
    pub const fn new(data: &'a [u8]) -> Self {
        let kind = DecodeErrorKind::Truncated;
        Self { data, length: data.len(), ended: false, kind, need: 0, got: 0 }
    }

    /// Returns the number of bytes left.
    #[inline]
    #[must_use]
    pub const fn remaining(&self) -> usize {
        self.data.len()
    }

    /// Returns the last error, as an error of a field of this type.
    #[must_use]
    #[inline]
    pub fn error(&self, field: &'static str) -> DecodeError {
        let (mut need, mut got) = (self.need, self.got);
        if self.kind == DecodeErrorKind::Truncated {
            need = need.saturating_add(self.length.saturating_sub(self.data.len()));
            got = self.length;
        }
        DecodeError::new(self.kind, field, need, got)
    }

    /// Was the last error a wrong constant? Constants distinguish layouts of one descriptor.
    #[inline]
    pub(crate) fn is_other_layout(&self) -> bool {
        self.kind == DecodeErrorKind::Constant
    }

    #[inline]
    pub(crate) fn wrong(&mut self, kind: DecodeErrorKind, need: usize, got: usize) -> ReadError {
        (self.kind, self.need, self.got) = (kind, need, got);
        ReadError
    }

    /// Checks that this number of bytes is left.
    #[inline(always)]
    pub fn require(&mut self, count: usize) -> Result<(), ReadError> {
        if count <= self.data.len() {
            return Ok(());
        }
        (self.kind, self.need) = (DecodeErrorKind::Truncated, count); // without bytes already read
        Err(ReadError)
    }

    // Every value is read with these two. They are inlined, so that the compiler removes checks
    // that cannot fail.

    /// Reads the next `count` bytes.
    #[inline(always)]
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], ReadError> {
        self.require(count)?;
        match (self.data.get(..count), self.data.get(count..)) {
            (Some(head), Some(tail)) => {
                self.data = tail;
                Ok(head)
            }
            _ => Err(ReadError),
        }
    }

    /// Reads the next `N` bytes.
    #[inline(always)]
    pub fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        <[u8; N]>::try_from(self.take(N)?).map_err(|_| ReadError)
    }

    /// Reads the next value.
    #[inline]
    pub fn read<T: Wire>(&mut self) -> Result<T, ReadError> {
        T::decode_from(self)
    }

    /// Checks that the next value is this constant.
    #[inline]
    #[allow(dead_code)] // few sets have constants
    pub(crate) fn constant<T: Wire + Number>(&mut self, value: T) -> Result<(), ReadError> {
        let (need, got) = (value.to_bits(), self.read::<T>()?.to_bits());
        if need == got {
            return Ok(());
        }
        Err(self.wrong(DecodeErrorKind::Constant, need as usize, got as usize))
    }

    /// Reads as many items as a counter states.
    #[inline]
    pub fn counted<L: Counted>(&mut self, count: impl Into<u64>) -> Result<L, ReadError> {
        L::decode_counted(usize::try_from(count.into()).unwrap_or(usize::MAX), self)
    }

    /// Reads the alternative that a tag selects.
    #[inline]
    pub fn union<U: Union>(&mut self, tag: U::Tag) -> Result<U, ReadError> {
        U::decode_as(tag, self)
    }

    /// Reads the alternative that a tag selects, as a group by itself; it is absent if the tag is.
    #[inline]
    pub fn some_union<U: Union>(
        &mut self,
        required: bool,
        tag: impl Into<Option<U::Tag>>,
    ) -> Result<Option<U>, ReadError> {
        match tag.into() {
            Some(tag) => self.group(required, |reader| reader.union(tag)),
            None => Ok(None),
        }
    }

    /// Reads a value that is a group by itself.
    #[inline]
    pub fn some<T: Wire>(&mut self, required: bool) -> Result<Option<T>, ReadError> {
        self.group(required, Self::read)
    }

    /// Reads a group of values that are all present or all absent. An optional group that is
    /// incomplete counts as absent.
    ///
    /// After an absent group, all groups that may be absent are absent.
    #[inline]
    pub fn group<T>(
        &mut self,
        required: bool,
        read: impl FnOnce(&mut Self) -> Result<T, ReadError>,
    ) -> Result<Option<T>, ReadError> {
        if required {
            return read(self).map(Some);
        }
        if self.ended || self.data.is_empty() {
            self.ended = true;
            return Ok(None);
        }
        let mark = self.data;
        match read(self) {
            // An empty union has no bytes, so it is the same as an absent one.
            Ok(value) if self.data.len() < mark.len() => Ok(Some(value)),
            Err(ReadError) if self.kind != DecodeErrorKind::Truncated => Err(ReadError),
            _ => {
                self.data = mark;
                self.ended = true;
                Ok(None)
            }
        }
    }
}

/// Writes values one after another to a caller's buffer.
#[derive(Debug)]
pub struct Writer<'a> {
    /// The free space after the written values.
    free: &'a mut [u8],
    size: usize,
    ended: bool,
    need: usize,
    got: usize,
    member: &'static str,
}

impl<'a> Writer<'a> {
    /// Creates a writer that starts at the front of the buffer.
    #[inline]
    #[must_use]
    pub fn new(buffer: &'a mut [u8]) -> Self {
        Self { size: buffer.len(), free: buffer, ended: false, need: 0, got: 0, member: "" }
    }

    /// Creates a writer that writes no more than a field can contain.
    #[inline]
    #[must_use]
    pub(crate) fn of_field(buffer: &'a mut [u8]) -> Self {
        let most = buffer.len().min(MAX_FIELD_DATA);
        Self::new(buffer.get_mut(..most).unwrap_or_default())
    }

    /// Returns the number of bytes written to a field, or the last error as an error of that field.
    #[inline]
    pub fn finish(
        &self,
        done: Result<(), EncodeErrorKind>,
        field: &'static str,
    ) -> Result<usize, EncodeError> {
        match done {
            Ok(()) => Ok(self.length()),
            Err(kind) => {
                let error = EncodeError::new(kind, field, self.need, self.got);
                Err(EncodeError { member: self.member, ..error })
            }
        }
    }

    pub(crate) fn wrong(
        &mut self,
        kind: EncodeErrorKind,
        need: usize,
        got: usize,
    ) -> EncodeErrorKind {
        (self.need, self.got) = (need, got);
        kind
    }

    /// Names the member of the last error, unless a member inside it is named.
    #[cold]
    pub fn in_member(&mut self, kind: EncodeErrorKind, member: &'static str) -> EncodeErrorKind {
        if self.member.is_empty() {
            self.member = member;
        }
        kind
    }

    /// Returns the number of bytes written.
    #[inline]
    #[must_use]
    pub const fn length(&self) -> usize {
        self.size.saturating_sub(self.free.len())
    }

    /// Checks that this number of bytes fits.
    #[inline]
    pub fn require(&mut self, count: usize) -> Result<(), EncodeErrorKind> {
        if count <= self.free.len() {
            return Ok(());
        }
        Err(self.full(count))
    }

    #[cold]
    fn full(&mut self, count: usize) -> EncodeErrorKind {
        self.wrong(EncodeErrorKind::Length, self.length().saturating_add(count), self.size)
    }

    /// Appends bytes.
    #[inline]
    pub fn put(&mut self, bytes: &[u8]) -> Result<(), EncodeErrorKind> {
        self.require(bytes.len())?;
        let (places, free) = core::mem::take(&mut self.free).split_at_mut(bytes.len());
        places.iter_mut().zip(bytes).for_each(|(place, byte)| *place = *byte);
        self.free = free;
        Ok(())
    }

    /// Appends a value.
    #[inline]
    pub fn write<T: Wire>(&mut self, value: &T) -> Result<(), EncodeErrorKind> {
        value.encode_to(self)
    }

    /// Appends an alternative.
    #[inline]
    pub fn union<U: Union>(&mut self, tag: U::Tag, value: &U) -> Result<(), EncodeErrorKind> {
        value.encode_as(tag, self)
    }

    /// Appends an alternative that is a group by itself, if it is present and allowed.
    #[inline]
    pub fn some_union<U: Union>(
        &mut self,
        required: bool,
        tag: impl Into<Option<U::Tag>>,
        value: &Option<U>,
    ) -> Result<(), EncodeErrorKind> {
        match (self.optional(required, value)?, tag.into()) {
            (Some(value), Some(tag)) => self.union(tag, value),
            (Some(_), None) => Err(self.wrong(EncodeErrorKind::Missing, 1, 0)),
            (None, _) => Ok(()),
        }
    }

    /// Appends the number of elements that follow later.
    #[inline]
    pub fn count<C: Wire + TryFrom<usize>>(&mut self, count: usize) -> Result<(), EncodeErrorKind> {
        if let Ok(number) = C::try_from(count) {
            return self.write(&number);
        }
        let most = 1_usize.checked_shl(C::SIZE.saturating_mul(8) as u32).unwrap_or(0);
        Err(self.wrong(EncodeErrorKind::Count, count, most.wrapping_sub(1)))
    }

    /// Returns a value that is a group by itself if it is to be written: present and allowed.
    #[inline]
    pub fn optional<'v, T>(
        &mut self,
        required: bool,
        value: &'v Option<T>,
    ) -> Result<Option<&'v T>, EncodeErrorKind> {
        self.group(required, [value.is_some()])?;
        Ok(value.as_ref())
    }

    /// Appends a value that is a group by itself, if it is present and allowed.
    #[inline]
    pub fn some<T: Wire>(
        &mut self,
        required: bool,
        value: &Option<T>,
    ) -> Result<(), EncodeErrorKind> {
        self.optional(required, value)?.map_or(Ok(()), |value| self.write(value))
    }

    /// Decides whether to write a group of values that are present or absent together.
    #[inline]
    pub fn group<const N: usize>(
        &mut self,
        required: bool,
        present: [bool; N],
    ) -> Result<bool, EncodeErrorKind> {
        if !self.ended && present.iter().all(|p| *p) {
            return Ok(true);
        }
        if required || present.iter().any(|p| *p) {
            let there = if self.ended { 0 } else { present.iter().filter(|p| **p).count() };
            return Err(self.wrong(EncodeErrorKind::Missing, N, there));
        }
        self.ended = true;
        Ok(false)
    }
}

macro_rules! numbers {
    ($($number:ty)*) => {$(
        impl Wire for $number {
            const SIZE: usize = core::mem::size_of::<Self>();
            const FIXED: bool = true;

            #[inline]
            fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
                reader.bytes().map(Self::from_be_bytes)
            }

            #[inline]
            fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
                writer.put(&self.to_be_bytes())
            }
        }

        impl Item for $number {
            const BLANK: Self = 0 as Self;
        }
    )*};
}

numbers!(u8 u16 u32 u64 i8 i16 i32 i64 f32 f64);

impl<T: Wire + Item, const N: usize> Wire for [T; N] {
    const SIZE: usize = T::SIZE.saturating_mul(N);
    const FIXED: bool = T::FIXED;

    #[inline]
    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        let mut items = Self::BLANK;
        for item in &mut items {
            *item = reader.read()?;
        }
        Ok(items)
    }

    #[inline]
    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        self.iter().try_for_each(|item| writer.write(item))
    }
}

/// A Boolean that keeps its byte: 0 is false, anything else is true.
///
/// It compares by meaning: `Bool(2) == Bool::TRUE`.
#[derive(Clone, Copy, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bool(pub u8);

impl Bool {
    /// False, with the usual byte.
    pub const FALSE: Self = Self(0);
    /// True, with the usual byte.
    pub const TRUE: Self = Self(1);

    /// Is it true?
    #[must_use]
    pub const fn get(self) -> bool {
        self.0 != 0
    }
}

impl From<bool> for Bool {
    #[inline]
    fn from(value: bool) -> Self {
        Self(value.into())
    }
}

impl From<Bool> for bool {
    #[inline]
    fn from(value: Bool) -> Self {
        value.get()
    }
}

impl PartialEq for Bool {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.get() == other.get()
    }
}

impl Eq for Bool {}

impl core::hash::Hash for Bool {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        self.get().hash(state);
    }
}

impl PartialEq<bool> for Bool {
    #[inline]
    fn eq(&self, other: &bool) -> bool {
        self.get() == *other
    }
}

impl fmt::Debug for Bool {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 => f.write_str("false"),
            1 => f.write_str("true"),
            other => write!(f, "true({other})"),
        }
    }
}

impl Item for Bool {
    const BLANK: Self = Self::FALSE;
}

impl Wire for Bool {
    const SIZE: usize = 1;
    const FIXED: bool = true;

    #[inline]
    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        reader.read().map(Self)
    }

    #[inline]
    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        writer.write(&self.0)
    }
}
