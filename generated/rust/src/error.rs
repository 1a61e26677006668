//! Errors of the codec: the kind of error, the field, and what was needed.

use core::fmt;

use crate::protocol::DescriptorSet;

#[cfg(feature = "core-error")]
pub(crate) use core::error::Error;
#[cfg(all(feature = "std", not(feature = "core-error")))]
pub(crate) use std::error::Error;

/// Why the data of a field could not be decoded.
///
/// ```
/// use mip_protocol::{error::DecodeErrorKind, protocol::Acknowledge, Field};
///
/// let error = Acknowledge::decode(&[1]).unwrap_err();
/// assert_eq!((error.kind, error.need, error.got), (DecodeErrorKind::Truncated, 2, 1));
/// assert_eq!(error.to_string(), "protocol.acknowledge: it needs 2 bytes and has 1");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct DecodeError {
    /// The kind of error.
    pub kind: DecodeErrorKind,
    /// The name of the field in the specification, `family.field`.
    pub field: &'static str,
    /// The required value; see the kind.
    pub need: usize,
    /// The value found instead.
    pub got: usize,
}

/// The kinds of errors in the data of a field; after the colon, the meaning of `need` and `got`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum DecodeErrorKind {
    /// The data ends before the last required value: the numbers of bytes needed and present.
    Truncated,
    /// A count exceeds the number of elements that follow, or that a field can contain: the count
    /// and the maximum.
    Count,
    /// A constant has the wrong value: the required value and the actual one.
    Constant,
}

/// Why a field could not be encoded.
///
/// ```
/// use mip_protocol::error::{EncodeError, EncodeErrorKind};
/// use mip_protocol::PacketBuilder;
///
/// let error: EncodeError = PacketBuilder::new(0x80.into()).push_raw(0x04, &[0; 254]).unwrap_err();
/// assert_eq!((error.kind, error.need), (EncodeErrorKind::Length, 254));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct EncodeError {
    /// The kind of error.
    pub kind: EncodeErrorKind,
    /// The field's name in the specification, `family.field`; empty if only its bytes are known.
    pub field: &'static str,
    /// The name of the member, if the error is about one: the first that is missing.
    pub member: &'static str,
    /// The required value; see the kind.
    pub need: usize,
    /// The value found instead.
    pub got: usize,
}

/// The kinds of errors when a field is encoded; after the colon, the meaning of `need` and `got`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EncodeErrorKind {
    /// A value is `None` although the function requires it or a later value is present: how many
    /// values belong together, and how many of them are present.
    Missing,
    /// There are more elements than the list or their counter can hold: their number and the
    /// maximum.
    Count,
    /// A union does not contain the member that its tag selects.
    Tag,
    /// The data does not fit into a field, a packet or the caller's buffer: the number of bytes
    /// needed (at least) and free.
    Length,
    /// The field does not occur in the packet's descriptor set: a set in which it occurs, and the
    /// packet's set.
    Set,
}

/// The data of a field is invalid; [`Reader::error`](crate::Reader::error) returns the reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct ReadError;

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the data is invalid")
    }
}

/// No value of an enumeration has this name; from its `FromStr`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct NameError;

impl fmt::Display for NameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no value has this name")
    }
}

/// A value is out of the range that the specification states; from
/// [`Command::check`](crate::Command::check).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct RangeError {
    /// The name of the field in the specification, `family.field`.
    pub field: &'static str,
    /// The name of the member, which may be in a structure of the field.
    pub member: &'static str,
    /// Its value.
    pub value: f64,
    /// The range: "1 to 4", "at least 0".
    pub range: &'static str,
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, member, value, range } = self;
        write!(f, "{field}.{member}: {value} is out of range: {range}")
    }
}

impl DecodeError {
    /// Adds the name of the field.
    #[must_use]
    pub(crate) const fn new(
        kind: DecodeErrorKind,
        field: &'static str,
        need: usize,
        got: usize,
    ) -> Self {
        Self { kind, field, need, got }
    }
}

impl EncodeError {
    #[must_use]
    pub(crate) const fn new(
        kind: EncodeErrorKind,
        field: &'static str,
        need: usize,
        got: usize,
    ) -> Self {
        Self { kind, field, member: "", need, got }
    }

    /// Creates the error for bytes that do not fit.
    #[must_use]
    pub(crate) const fn length(field: &'static str, need: usize, got: usize) -> Self {
        Self::new(EncodeErrorKind::Length, field, need, got)
    }

    /// Creates the error for a field in a packet of a set in which it does not occur.
    #[must_use]
    pub(crate) const fn set(field: &'static str, need: DescriptorSet, got: DescriptorSet) -> Self {
        Self::new(EncodeErrorKind::Set, field, need.0 as usize, got.0 as usize)
    }
}

impl fmt::Display for DecodeErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Truncated => "the data ends too early",
            Self::Count => "a count does not match the data that follows",
            Self::Constant => "a constant has the wrong value",
        })
    }
}

impl fmt::Display for EncodeErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Missing => "a value is missing",
            Self::Count => "there are more elements than can be counted",
            Self::Tag => "a union does not contain the member that its tag selects",
            Self::Length => "the bytes do not fit",
            Self::Set => "the field does not occur in the descriptor set of the packet",
        })
    }
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, field, need, got } = self;
        write!(f, "{field}: ")?;
        match kind {
            DecodeErrorKind::Truncated => write!(f, "it needs {need} bytes and has {got}"),
            DecodeErrorKind::Count => write!(f, "{need} elements are counted, {got} can follow"),
            DecodeErrorKind::Constant => write!(f, "a constant is {got:#x} and not {need:#x}"),
        }
    }
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, field, member, need, got } = self;
        match (field.is_empty(), member.is_empty()) {
            (true, true) => {}
            (false, false) => write!(f, "{field}.{member}: ")?,
            _ => write!(f, "{field}{member}: ")?,
        }
        match kind {
            EncodeErrorKind::Missing if *need == 1 => {
                f.write_str("it is missing, or a value before it")
            }
            EncodeErrorKind::Missing => write!(f, "{got} of {need} required values are present"),
            EncodeErrorKind::Count => write!(f, "{need} elements were given, {got} fit"),
            EncodeErrorKind::Tag => write!(f, "{kind}"),
            EncodeErrorKind::Length => write!(f, "it needs {need} bytes, {got} are free"),
            EncodeErrorKind::Set => match (need, got) {
                (_, 0 | 0xFF) => write!(f, "no packet has set {got:#04x}"),
                _ => write!(f, "it occurs in set {need:#04x}, and not in set {got:#04x}"),
            },
        }
    }
}

error!(DecodeError DecodeErrorKind EncodeError EncodeErrorKind NameError RangeError ReadError);
