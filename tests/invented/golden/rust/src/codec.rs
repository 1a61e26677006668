//! How values stand on the wire: big-endian, one after another, without padding.
//!
//! [`Wire`] is implemented by everything that has bytes: numbers, enumerations, bitfields,
//! structures and fields. [`Reader`] and [`Writer`] work on borrowed bytes and never panic.

use core::fmt;

/// Why the data of a field could not be decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DecodeError {
    /// The data ends before the last value that must be there.
    Truncated,
    /// A count says that there are more elements than follow, or than a field can hold.
    Count,
    /// A value that is always the same has another value.
    Constant,
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Truncated => "the data of the field ends too early",
            Self::Count => "a count does not match the data that follows",
            Self::Constant => "a constant of the field has another value",
        })
    }
}

/// Why a field could not be encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum EncodeError {
    /// A value is `None` that the function needs, or that stands before a present one.
    Missing,
    /// There are more elements than their counter can tell.
    Count,
    /// A union does not hold the member that its tag names.
    Tag,
    /// It does not fit into a field, a packet or the caller's buffer.
    Length,
    /// The field does not belong to the descriptor set of the packet.
    Set,
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Missing => "a value is missing",
            Self::Count => "there are more elements than their counter can tell",
            Self::Tag => "a union does not hold the member that its tag names",
            Self::Length => "the bytes do not fit",
            Self::Set => "the field does not belong to the descriptor set of the packet",
        })
    }
}

#[cfg(feature = "std")]
impl std::error::Error for DecodeError {}

#[cfg(feature = "std")]
impl std::error::Error for EncodeError {}

/// A value that has bytes on the wire.
pub trait Wire: Sized {
    /// How many bytes, at most. Types of constant size always have as many.
    const SIZE: usize;

    /// Reads one value.
    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError>;

    /// Writes the value.
    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError>;
}

/// One of several alternatives, which another value, the tag, selects.
pub trait Union: Sized {
    /// The type of the tag.
    type Tag;

    /// Reads the alternative of a tag.
    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, DecodeError>;

    /// Writes it if it is the alternative of this tag.
    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeError>;
}

/// Items whose number another value tells. As a [`Wire`] they are as many as are still there.
pub trait Counted: Wire {
    /// Reads so many items.
    fn decode_counted(count: usize, reader: &mut Reader<'_>) -> Result<Self, DecodeError>;
}

/// Takes values off the front of a field's data.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    data: &'a [u8],
    ended: bool,
}

impl<'a> Reader<'a> {
    /// Starts at the front of the data.
    #[must_use]
    pub const fn new(data: &'a [u8]) -> Self {
        Self { data, ended: false }
    }

    /// How many bytes are left.
    #[must_use]
    pub const fn remaining(&self) -> usize {
        self.data.len()
    }

    /// The next `count` bytes.
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], DecodeError> {
        match (self.data.get(..count), self.data.get(count..)) {
            (Some(head), Some(tail)) => {
                self.data = tail;
                Ok(head)
            }
            _ => Err(DecodeError::Truncated),
        }
    }

    /// The next `N` bytes.
    pub fn bytes<const N: usize>(&mut self) -> Result<[u8; N], DecodeError> {
        <[u8; N]>::try_from(self.take(N)?).map_err(|_| DecodeError::Truncated)
    }

    /// The next value.
    pub fn read<T: Wire>(&mut self) -> Result<T, DecodeError> {
        T::decode_from(self)
    }

    /// Demands that the next value is this one.
    pub fn constant<T: Wire + PartialEq>(&mut self, value: T) -> Result<(), DecodeError> {
        if self.read::<T>()? == value {
            Ok(())
        } else {
            Err(DecodeError::Constant)
        }
    }

    /// As many items as a counter says.
    pub fn counted<L: Counted>(&mut self, count: impl Into<u64>) -> Result<L, DecodeError> {
        L::decode_counted(usize::try_from(count.into()).unwrap_or(usize::MAX), self)
    }

    /// The alternative of a tag.
    pub fn union<U: Union>(&mut self, tag: U::Tag) -> Result<U, DecodeError> {
        U::decode_as(tag, self)
    }

    /// The alternative of a tag, as a group by itself; there is none without the tag.
    pub fn some_union<U: Union>(
        &mut self,
        required: bool,
        tag: impl Into<Option<U::Tag>>,
    ) -> Result<Option<U>, DecodeError> {
        match tag.into() {
            Some(tag) => self.group(required, |reader| reader.union(tag)),
            None => Ok(None),
        }
    }

    /// A value that is a group by itself.
    pub fn some<T: Wire>(&mut self, required: bool) -> Result<Option<T>, DecodeError> {
        self.group(required, Self::read)
    }

    /// A group of values that come and go together: read if it must be there or is wholly there.
    ///
    /// After a group that is absent, everything that may be absent is.
    pub fn group<T>(
        &mut self,
        required: bool,
        read: impl FnOnce(&mut Self) -> Result<T, DecodeError>,
    ) -> Result<Option<T>, DecodeError> {
        if required {
            return read(self).map(Some);
        }
        if self.ended || self.data.is_empty() {
            self.ended = true;
            return Ok(None);
        }
        let mark = self.data;
        match read(self) {
            // What takes no bytes, an empty union, is as good as absent.
            Ok(value) if self.data.len() < mark.len() => Ok(Some(value)),
            Ok(_) | Err(DecodeError::Truncated) => {
                self.data = mark;
                self.ended = true;
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }
}

/// Puts values one after another into a caller's buffer.
#[derive(Debug)]
pub struct Writer<'a> {
    buffer: &'a mut [u8],
    length: usize,
    ended: bool,
}

impl<'a> Writer<'a> {
    /// Starts at the front of the buffer.
    #[must_use]
    pub fn new(buffer: &'a mut [u8]) -> Self {
        Self { buffer, length: 0, ended: false }
    }

    /// How many bytes have been written.
    #[must_use]
    pub const fn length(&self) -> usize {
        self.length
    }

    /// Appends bytes.
    pub fn put(&mut self, bytes: &[u8]) -> Result<(), EncodeError> {
        let free = self.buffer.get_mut(self.length..).and_then(|free| free.get_mut(..bytes.len()));
        free.ok_or(EncodeError::Length)?.copy_from_slice(bytes);
        self.length = self.length.saturating_add(bytes.len());
        Ok(())
    }

    /// Appends a value.
    pub fn write<T: Wire>(&mut self, value: &T) -> Result<(), EncodeError> {
        value.encode_to(self)
    }

    /// Appends an alternative.
    pub fn union<U: Union>(&mut self, tag: U::Tag, value: &U) -> Result<(), EncodeError> {
        value.encode_as(tag, self)
    }

    /// Appends an alternative that is a group by itself, if it is present and may be.
    pub fn some_union<U: Union>(
        &mut self,
        required: bool,
        tag: impl Into<Option<U::Tag>>,
        value: &Option<U>,
    ) -> Result<(), EncodeError> {
        match (self.optional(required, value)?, tag.into()) {
            (Some(value), Some(tag)) => self.union(tag, value),
            (Some(_), None) => Err(EncodeError::Missing),
            (None, _) => Ok(()),
        }
    }

    /// Appends the number of elements that follow later.
    pub fn count<C: Wire + TryFrom<usize>>(&mut self, count: usize) -> Result<(), EncodeError> {
        self.write(&C::try_from(count).map_err(|_| EncodeError::Count)?)
    }

    /// Decides about a group that is one value: gives it if it is present and may be.
    pub fn optional<'v, T>(
        &mut self,
        required: bool,
        value: &'v Option<T>,
    ) -> Result<Option<&'v T>, EncodeError> {
        self.group(required, [value.is_some()])?;
        Ok(value.as_ref())
    }

    /// Appends a value that is a group by itself, if it is present and may be.
    pub fn some<T: Wire>(&mut self, required: bool, value: &Option<T>) -> Result<(), EncodeError> {
        self.optional(required, value)?.map_or(Ok(()), |value| self.write(value))
    }

    /// Decides about a group of values that come and go together: is it to be written?
    pub fn group<const N: usize>(
        &mut self,
        required: bool,
        present: [bool; N],
    ) -> Result<bool, EncodeError> {
        if !self.ended && present.iter().all(|p| *p) {
            return Ok(true);
        }
        if required || present.iter().any(|p| *p) {
            return Err(EncodeError::Missing);
        }
        self.ended = true;
        Ok(false)
    }
}

macro_rules! numbers {
    ($($number:ty)*) => {$(
        impl Wire for $number {
            const SIZE: usize = core::mem::size_of::<Self>();

            fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
                reader.bytes().map(Self::from_be_bytes)
            }

            fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
                writer.put(&self.to_be_bytes())
            }
        }
    )*};
}

numbers!(u8 u16 u32 u64 i8 i16 i32 i64 f32 f64);

impl<T: Wire + Copy + Default, const N: usize> Wire for [T; N] {
    const SIZE: usize = T::SIZE.saturating_mul(N);

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut items = [T::default(); N];
        for item in &mut items {
            *item = reader.read()?;
        }
        Ok(items)
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        self.iter().try_for_each(|item| writer.write(item))
    }
}

/// A truth value that keeps its byte: 0 is false, and anything else is true.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bool(pub u8);

impl Bool {
    /// As devices send it.
    pub const FALSE: Self = Self(0);
    /// As devices send it.
    pub const TRUE: Self = Self(1);

    /// Is it true?
    #[must_use]
    pub const fn get(self) -> bool {
        self.0 != 0
    }
}

impl From<bool> for Bool {
    fn from(value: bool) -> Self {
        Self(value.into())
    }
}

impl From<Bool> for bool {
    fn from(value: Bool) -> Self {
        value.get()
    }
}

impl PartialEq<bool> for Bool {
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

impl Wire for Bool {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.read().map(Self)
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.0)
    }
}
