//! The traits of fields, commands and responses.

use crate::codec::{Reader, Wire, Writer};
use crate::error::{
    DecodeError, DecodeErrorKind, EncodeError, EncodeErrorKind, RangeError, ReadError,
};
use crate::protocol::{DescriptorSet, FunctionSelector};
use crate::view::{self, View, Viewed};
use core::fmt;
use core::ops::{Deref, RangeInclusive};

/// A type of field: one layout of one field descriptor, in every descriptor set in which it occurs.
///
/// For the set of a received field, see [`Packet::set`](crate::Packet::set) or [`RawField::set`].
pub trait Field: Wire {
    /// The descriptor sets in which it occurs, in ascending order.
    const SETS: &'static [DescriptorSet];
    /// The field descriptor.
    const DESCRIPTOR: u8;
    /// The name in the specification, `family.field`. The name of a family of one set is the set's.
    const NAME: &'static str;
    /// Constants inside the data, as offset and bytes; they distinguish layouts of one descriptor.
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[];
    /// The possible numbers of bytes of its data; they distinguish layouts with the same constants.
    const SIZES: RangeInclusive<usize> = 0..=usize::MAX;

    /// Does it occur in this descriptor set?
    #[inline]
    #[must_use]
    fn occurs_in(set: DescriptorSet) -> bool {
        Self::SETS.contains(&set)
    }

    /// Decodes the data of a field, the bytes after its descriptor.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Field};
    ///
    /// let reply = Acknowledge::decode(&[1, 0])?;
    /// assert_eq!(reply.command, 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A required value is missing, a count exceeds what follows, or a constant has the wrong
    /// value.
    #[inline]
    fn decode(data: &[u8]) -> Result<Self, DecodeError> {
        let mut reader = Reader::new(data);
        Self::decode_from(&mut reader).map_err(|_| reader.error(Self::NAME))
    }

    /// Like [`Field::decode`], but also returns the number of bytes left over, because newer
    /// firmware may append some.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Field};
    ///
    /// let (_, left_over) = Acknowledge::decode_with_trailing(&[1, 0, 7])?;
    /// assert_eq!(left_over, 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Returns the errors of [`Field::decode`].
    #[inline]
    fn decode_with_trailing(data: &[u8]) -> Result<(Self, usize), DecodeError> {
        let mut reader = Reader::new(data);
        match Self::decode_from(&mut reader) {
            Ok(value) => Ok((value, reader.remaining())),
            Err(_) => Err(reader.error(Self::NAME)),
        }
    }

    /// Encodes the field's data into the front of the buffer, and returns its length.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Field};
    ///
    /// let mut buffer = [0; 4];
    /// assert_eq!(Acknowledge { command: 1, code: 0.into() }.encode(&mut buffer)?, 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A value is missing or does not fit, or the buffer is too short.
    #[inline]
    fn encode(&self, buffer: &mut [u8]) -> Result<usize, EncodeError> {
        let mut writer = Writer::of_field(buffer);
        let done = self.encode_to(&mut writer);
        writer.finish(done, Self::NAME)
    }

    /// Encodes the field's data into a `Vec`.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`Field::encode`].
    #[cfg(feature = "alloc")]
    fn to_vec(&self) -> Result<alloc::vec::Vec<u8>, EncodeError> {
        let mut buffer = [0; crate::packet::MAX_FIELD_DATA];
        let length = self.encode(&mut buffer)?;
        Ok(buffer.iter().copied().take(length).collect())
    }
}

/// A field that occurs in one descriptor set only: its type determines the set of its packet.
pub trait OneSet: Field {
    /// The descriptor set.
    const SET: DescriptorSet;
}

/// A field that the device acknowledges, with or without a response after the acknowledge.
#[cfg_attr(
    any(feature = "open", feature = "core-error"), // they need a Rust that has this
    diagnostic::on_unimplemented(
        message = "`{Self}` is no command",
        note = "commands are made by constructors, such as `base::Ping::new()` or `mip_3dm::PpsSourceControl::read()`"
    )
)]
pub trait Command: OneSet {
    /// The result of a request: `()`, the type of the response, or an enumeration of several types.
    /// For a command whose function is known only at run time, it is an `Option` of this.
    type Response: Response;
    /// The descriptors of its responses, whatever its function is.
    const RESPONSES: &'static [u8] = Self::Response::DESCRIPTORS;
    /// The time that a device may take to reply, in ms, if longer than usual.
    const TIMEOUT_MS: Option<u32> = None;

    /// Will the device acknowledge it?
    #[must_use]
    fn expects_reply(&self) -> bool {
        true
    }

    /// Checks that its values are in the ranges that the specification states. Nothing else does so: a
    /// device rejects what it does not accept, which may depend on its model.
    ///
    /// ```
    /// # #[cfg(feature = "filter")] {
    /// use mip_protocol::{filter::SetInitialHeading, Command};
    ///
    /// assert_eq!(SetInitialHeading::new(core::f32::consts::PI).check(), Ok(()));
    /// let error = SetInitialHeading::new(90.0).check().unwrap_err();
    /// assert_eq!((error.member, error.value, error.range), ("heading", 90.0, "-pi to pi"));
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// Returns the first value out of its range. Values that are not present have none.
    fn check(&self) -> Result<(), RangeError> {
        Ok(())
    }

    /// Returns the check for the response that it requests with these values.
    #[must_use]
    fn response_check(&self) -> Option<ResponseCheck> {
        None
    }
}

/// A command with the function `FUNCTION`, made by one of the command's constructors. It is usually
/// written [`ReadCall<C>`](crate::protocol::ReadCall), [`WriteCall<C>`](crate::protocol::WriteCall) and so on. Its
/// type determines the response.
///
/// It can be sent and searched like any field: `field.get::<ReadCall<PpsSourceControl>>()` is `Ok(None)`
/// for other functions. Its values can be read like the command's; to change them, convert it with
/// [`Call::into_command`].
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Call<C, const FUNCTION: u8>(C);

/// Commands with other functions are errors.
#[cfg(feature = "serde")]
impl<'de, C, const FUNCTION: u8> serde::Deserialize<'de> for Call<C, FUNCTION>
where
    C: Field + serde::Deserialize<'de>,
{
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        use serde::de::Error as _;
        let (command, mut data) =
            (C::deserialize(deserializer)?, [0; crate::packet::MAX_FIELD_DATA]);
        let size = command.encode(&mut data).map_err(D::Error::custom)?;
        Self::decode(data.get(..size).unwrap_or_default()).map_err(D::Error::custom)?;
        Ok(Self(command))
    }
}

impl<C, const FUNCTION: u8> Call<C, FUNCTION> {
    /// The function.
    pub const FUNCTION: FunctionSelector = FunctionSelector(FUNCTION);

    /// Wraps a command that has this function.
    #[allow(dead_code)] // if no command has a function
    pub(crate) const fn of(command: C) -> Self {
        Self(command)
    }

    /// Returns the command, whose values and function can be changed.
    ///
    /// ```
    /// # #[cfg(all(feature = "mip_3dm", feature = "sensor"))] {
    /// use mip_protocol::mip_3dm::LowPassFilter;
    ///
    /// let mut command = LowPassFilter::read(mip_protocol::sensor::SET, 0x04).into_command();
    /// command.field_descriptor = Some(0x05); // the function is no longer part of the type
    /// # }
    /// ```
    #[must_use]
    pub fn into_command(self) -> C {
        self.0
    }
}

impl<C, const FUNCTION: u8> Deref for Call<C, FUNCTION> {
    type Target = C;

    #[inline]
    fn deref(&self) -> &C {
        &self.0
    }
}

impl<C: fmt::Debug, const FUNCTION: u8> fmt::Debug for Call<C, FUNCTION> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<C: Wire, const FUNCTION: u8> Wire for Call<C, FUNCTION> {
    const SIZE: usize = C::SIZE;
    const FIXED: bool = C::FIXED;

    #[inline]
    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, ReadError> {
        let function = reader.clone().read::<u8>();
        match function {
            Ok(other) if other != FUNCTION => {
                Err(reader.wrong(DecodeErrorKind::Constant, FUNCTION.into(), other.into()))
            }
            _ => reader.read().map(Self),
        }
    }

    #[inline]
    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        writer.write(&self.0)
    }
}

impl<C: Field, const FUNCTION: u8> Field for Call<C, FUNCTION> {
    const SETS: &'static [DescriptorSet] = C::SETS;
    const DESCRIPTOR: u8 = C::DESCRIPTOR;
    const NAME: &'static str = C::NAME;
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[FUNCTION])];
    const SIZES: RangeInclusive<usize> = C::SIZES;

    #[inline]
    fn occurs_in(set: DescriptorSet) -> bool {
        C::occurs_in(set)
    }
}

impl<C: OneSet, const FUNCTION: u8> OneSet for Call<C, FUNCTION> {
    const SET: DescriptorSet = C::SET;
}

/// A command that supports the function `FUNCTION`, among others.
pub trait Takes<const FUNCTION: u8>: Command {
    /// The response for this function.
    type Response: Response;
}

impl<C: Takes<FUNCTION>, const FUNCTION: u8> Command for Call<C, FUNCTION> {
    type Response = <C as Takes<FUNCTION>>::Response;
    const RESPONSES: &'static [u8] = C::RESPONSES;
    const TIMEOUT_MS: Option<u32> = C::TIMEOUT_MS;

    #[inline]
    fn expects_reply(&self) -> bool {
        self.0.expects_reply()
    }

    #[inline]
    fn check(&self) -> Result<(), RangeError> {
        self.0.check()
    }

    #[inline]
    fn response_check(&self) -> Option<ResponseCheck> {
        // The type knows: a program that only writes has no code for the responses to a read.
        if Self::Response::DESCRIPTORS.is_empty() {
            return None;
        }
        self.0.response_check()
    }
}

/// Recognizes a response: returns the error if it cannot be decoded, and `None` for other fields.
pub type ResponseCheck = fn(&RawField<'_>) -> Option<Result<(), DecodeError>>;

/// Checks for one type of response.
#[must_use]
pub fn check<R: Field>(field: &RawField<'_>) -> Option<Result<(), DecodeError>> {
    if R::FIXED && R::CONSTANTS.is_empty() {
        return field.is::<R>().then(|| view::enough::<R>(field.data));
    }
    R::from_field(field).map(|found| found.map(|_| ()))
}

/// A field that answers the command `C`.
pub trait ResponseOf<C: Command>: Field {}

/// The responses of a command.
pub trait Response: Sized {
    /// The descriptors of the responses.
    const DESCRIPTORS: &'static [u8];

    /// Decodes a field if it is such a response.
    fn from_field(field: &RawField<'_>) -> Option<Result<Self, DecodeError>>;

    /// Returns the value for an acknowledge without a response; `None` if a response is required.
    #[inline]
    #[must_use]
    fn absent() -> Option<Self> {
        None
    }
}

impl Response for () {
    const DESCRIPTORS: &'static [u8] = &[];

    fn from_field(_: &RawField<'_>) -> Option<Result<Self, DecodeError>> {
        None
    }

    #[inline]
    fn absent() -> Option<Self> {
        Some(())
    }
}

impl<R: Response> Response for Option<R> {
    const DESCRIPTORS: &'static [u8] = R::DESCRIPTORS;

    #[inline]
    fn from_field(field: &RawField<'_>) -> Option<Result<Self, DecodeError>> {
        R::from_field(field).map(|found| found.map(Some))
    }

    #[inline]
    fn absent() -> Option<Self> {
        Some(None)
    }
}

#[doc(hidden)]
impl<T: Field> Response for T {
    const DESCRIPTORS: &'static [u8] = &[T::DESCRIPTOR];

    #[inline]
    fn from_field(field: &RawField<'_>) -> Option<Result<Self, DecodeError>> {
        if !field.is::<T>() {
            return None;
        }
        let mut reader = Reader::new(field.data);
        match T::decode_from(&mut reader) {
            Ok(value) => Some(Ok(value)),
            Err(_) if reader.is_other_layout() => None,
            Err(_) => Some(Err(reader.error(T::NAME))),
        }
    }
}

/// The role of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Role {
    /// Sent to the device.
    Command,
    /// Sent by the device to answer a command.
    Response,
    /// Sent by the device without a request, for example periodically.
    Data,
}

impl Role {
    /// Returns the specification's word for the role.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Command => "command",
            Self::Response => "response",
            Self::Data => "data",
        }
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// One field of a packet, not yet decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RawField<'a> {
    /// The descriptor set of the packet.
    pub set: DescriptorSet,
    /// The field descriptor.
    pub descriptor: u8,
    /// The bytes after the descriptor.
    pub data: &'a [u8],
}

impl<'a> RawField<'a> {
    /// Is it a field of this type?
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, RawField};
    ///
    /// let field = RawField { set: 0x01.into(), descriptor: 0xF1, data: &[1, 0] };
    /// assert!(field.is::<Acknowledge>());
    /// ```
    #[inline]
    #[must_use]
    pub fn is<T: Field>(&self) -> bool {
        T::occurs_in(self.set) && self.descriptor == T::DESCRIPTOR && self.has_layout_of::<T>()
    }

    /// Can the data, as far as present, have this type's layout? Checks the constants and the size.
    #[inline]
    #[must_use]
    pub fn has_layout_of<T: Field>(&self) -> bool {
        T::SIZES.contains(&self.data.len())
            && (T::CONSTANTS.is_empty() || self.has_constants(T::CONSTANTS))
    }

    pub(crate) fn has_constants(&self, constants: &[(usize, &[u8])]) -> bool {
        constants.iter().all(|(offset, bytes)| {
            self.data.iter().skip(*offset).zip(bytes.iter()).all(|(here, byte)| here == byte)
        })
    }

    /// Decodes the field if it is of this type.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Packet};
    ///
    /// for field in &Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")? {
    ///     if let Some(reply) = field?.get::<Acknowledge>()? {
    ///         assert_eq!(reply.command, 1);
    ///     }
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The data is invalid.
    #[inline]
    pub fn get<T: Field>(&self) -> Result<Option<T>, DecodeError> {
        self.is::<T>().then(|| T::decode(self.data)).transpose()
    }

    /// Returns a view of the field, to read values in place, if it is of this type.
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] {
    /// use mip_protocol::{sensor::ScaledAccel, RawField};
    ///
    /// let field = RawField { set: 0x80.into(), descriptor: 0x04, data: &[0; 12] };
    /// let accel = field.view::<ScaledAccel>().unwrap().unwrap();
    /// assert_eq!(accel.scaled_accel().x, 0.0);
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// The data is too short.
    #[inline]
    pub fn view<T: Field + Viewed>(&self) -> Result<Option<View<'a, T>>, DecodeError> {
        self.is::<T>().then(|| view::open(self.data)).transpose()
    }
}

/// Returns `N` consecutive sets, starting with the number `first`.
#[allow(clippy::indexing_slicing)] // evaluated at compile time
pub(crate) const fn run<const N: usize>(first: u8) -> [DescriptorSet; N] {
    let (mut sets, mut at, mut number) = ([DescriptorSet(0); N], 0, first);
    while at < N {
        sets[at] = DescriptorSet(number);
        (at, number) = (at.wrapping_add(1), number.wrapping_add(1));
    }
    sets
}
