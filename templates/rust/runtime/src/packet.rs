//! Packets: building them, and reading them without copying.

use core::fmt;

use crate::error::{DecodeError, EncodeError};
use crate::field::{Field, RawField};
use crate::protocol::SYNC;

/// The maximum size of a payload.
pub const MAX_PAYLOAD: usize = 255;
/// The maximum size of a packet.
pub const MAX_PACKET: usize = MAX_PAYLOAD + OVERHEAD;
/// The maximum size of the data of one field.
pub const MAX_FIELD_DATA: usize = 253;

const HEADER: usize = 4;
const OVERHEAD: usize = HEADER + 2;
const FIELD_HEADER: usize = 2;

/// The two checksum bytes of a packet: sums over header and payload.
#[must_use]
pub fn checksum(bytes: &[u8]) -> [u8; 2] {
    let (a, b) = bytes.iter().fold((0_u8, 0_u8), |(a, b), byte| {
        let a = a.wrapping_add(*byte);
        (a, b.wrapping_add(a))
    });
    [a, b]
}

/// Why bytes are not a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PacketError {
    /// The bytes do not start with the two sync bytes.
    Sync,
    /// The number of bytes is not what the packet states, or the descriptor set is 0.
    Length,
    /// The checksum is wrong.
    Checksum,
}

impl fmt::Display for PacketError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sync => "the bytes do not begin with the sync bytes of a packet",
            Self::Length => "the bytes are not one whole packet",
            Self::Checksum => "the checksum is wrong",
        })
    }
}

/// A field inside a packet whose length is below 2 or runs past the payload.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FieldLengthError;

impl fmt::Display for FieldLengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the length of a field does not fit into the packet")
    }
}

#[cfg(feature = "std")]
impl std::error::Error for PacketError {}

#[cfg(feature = "std")]
impl std::error::Error for FieldLengthError {}

/// A complete packet with a correct checksum, borrowed from the memory that holds its bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Packet<'a> {
    bytes: &'a [u8],
}

impl<'a> Packet<'a> {
    /// Checks that bytes are exactly one packet.
    pub fn new(bytes: &'a [u8]) -> Result<Self, PacketError> {
        if !bytes.starts_with(&SYNC) {
            return Err(PacketError::Sync);
        }
        let [_, _, 1..=255, length, ..] = *bytes else {
            return Err(PacketError::Length);
        };
        let end = HEADER.saturating_add(usize::from(length));
        if bytes.len() != end.saturating_add(2) {
            return Err(PacketError::Length);
        }
        match (bytes.get(..end), bytes.get(end..)) {
            (Some(head), Some(tail)) if tail == checksum(head) => Ok(Self { bytes }),
            _ => Err(PacketError::Checksum),
        }
    }

    /// Takes bytes that are known to be a packet.
    pub(crate) const fn trusted(bytes: &'a [u8]) -> Self {
        Self { bytes }
    }

    /// All bytes of the packet.
    #[must_use]
    pub const fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// The descriptor set.
    #[must_use]
    pub fn set(&self) -> u8 {
        self.bytes.get(2).copied().unwrap_or_default()
    }

    /// The payload: the fields, one after another.
    #[must_use]
    pub fn payload(&self) -> &'a [u8] {
        self.bytes.get(HEADER..self.bytes.len().saturating_sub(2)).unwrap_or_default()
    }

    /// Iterates over the fields.
    #[must_use]
    pub fn fields(&self) -> Fields<'a> {
        Fields { set: self.set(), payload: self.payload() }
    }

    /// The first field of this type, decoded; `None` if the packet holds none.
    #[must_use]
    pub fn find<T: Field>(&self) -> Option<Result<T, DecodeError>> {
        self.fields().flatten().find_map(|field| field.get())
    }
}

impl fmt::Debug for Packet<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Packet(")?;
        self.bytes.iter().try_for_each(|b| write!(f, "{b:02x}"))?;
        write!(f, ")")
    }
}

/// The fields of a packet. A malformed field is the last item; the fields before it are valid.
#[derive(Clone, Debug)]
pub struct Fields<'a> {
    set: u8,
    payload: &'a [u8],
}

impl<'a> Iterator for Fields<'a> {
    type Item = Result<RawField<'a>, FieldLengthError>;

    fn next(&mut self) -> Option<Self::Item> {
        let length = usize::from(*self.payload.first()?);
        match (self.payload.get(..length), self.payload.get(length..)) {
            (Some([_, descriptor, data @ ..]), Some(rest)) => {
                self.payload = rest;
                Some(Ok(RawField { set: self.set, descriptor: *descriptor, data }))
            }
            _ => {
                self.payload = &[];
                Some(Err(FieldLengthError))
            }
        }
    }
}

impl core::iter::FusedIterator for Fields<'_> {}

/// Builds a packet from fields. It holds a valid packet at any time.
///
/// A field that does not fit is an error, and leaves the packet unchanged.
#[derive(Clone)]
pub struct PacketBuilder {
    bytes: [u8; MAX_PACKET],
    payload: u8,
}

impl PacketBuilder {
    /// A packet of this descriptor set, without fields. Set 0 is invalid and accepts no field.
    #[must_use]
    pub fn new(set: u8) -> Self {
        let mut bytes = [0; MAX_PACKET];
        let [sync_1, sync_2, number, ..] = &mut bytes;
        (*sync_1, *sync_2, *number) = (SYNC[0], SYNC[1], set);
        let mut builder = Self { bytes, payload: 0 };
        builder.seal();
        builder
    }

    /// A packet with only this field.
    pub fn with<T: Field>(field: &T) -> Result<Self, EncodeError> {
        let mut builder = Self::new(T::SET);
        builder.push(field)?;
        Ok(builder)
    }

    /// The descriptor set.
    #[must_use]
    pub fn set(&self) -> u8 {
        self.packet().set()
    }

    /// Appends a field.
    pub fn push<T: Field>(&mut self, field: &T) -> Result<(), EncodeError> {
        if !T::in_set(self.set()) {
            return Err(EncodeError::set(T::NAME, T::SET, self.set()));
        }
        self.append(T::DESCRIPTOR, |free| field.encode(free))
    }

    /// Appends a field from its bytes.
    pub fn push_raw(&mut self, descriptor: u8, data: &[u8]) -> Result<(), EncodeError> {
        if self.set() == 0 {
            return Err(EncodeError::set("", 0, 0));
        }
        self.append(descriptor, |free| {
            let length = free.len();
            match free.get_mut(..data.len()) {
                Some(place) => place.copy_from_slice(data),
                None => return Err(EncodeError::length("", data.len(), length)),
            }
            Ok(data.len())
        })
    }

    /// Removes all fields.
    pub fn clear(&mut self) {
        self.payload = 0;
        self.seal();
    }

    /// The bytes to send.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        let length = usize::from(self.payload).saturating_add(OVERHEAD);
        self.bytes.get(..length).unwrap_or_default()
    }

    /// The packet as it is now.
    #[must_use]
    pub fn packet(&self) -> Packet<'_> {
        Packet { bytes: self.bytes() }
    }

    fn append(
        &mut self,
        descriptor: u8,
        encode: impl FnOnce(&mut [u8]) -> Result<usize, EncodeError>,
    ) -> Result<(), EncodeError> {
        if self.set() == 0 {
            return Err(EncodeError::set("", 0, 0));
        }
        let start = HEADER.saturating_add(self.payload.into());
        let most = FIELD_HEADER.saturating_add(MAX_FIELD_DATA);
        let end = start.saturating_add(most).min(HEADER.saturating_add(MAX_PAYLOAD));
        let done = match self.bytes.get_mut(start..end) {
            Some([length, number, free @ ..]) => encode(free).and_then(|count| {
                let whole = count.saturating_add(FIELD_HEADER);
                (*length, *number) = (
                    u8::try_from(whole).map_err(|_| EncodeError::length("", whole, 255))?,
                    descriptor,
                );
                Ok(*length)
            }),
            _ => Err(EncodeError::length("", FIELD_HEADER, end.saturating_sub(start))),
        };
        if let Ok(length) = done {
            self.payload = self.payload.saturating_add(length);
        }
        self.seal();
        done.map(drop)
    }

    /// Sets payload length and checksum.
    fn seal(&mut self) {
        let [_, _, _, length, ..] = &mut self.bytes;
        *length = self.payload;
        let end = HEADER.saturating_add(self.payload.into());
        let sums = checksum(self.bytes.get(..end).unwrap_or_default());
        for (byte, sum) in self.bytes.iter_mut().skip(end).zip(sums) {
            *byte = sum;
        }
    }
}

impl AsRef<[u8]> for PacketBuilder {
    fn as_ref(&self) -> &[u8] {
        self.bytes()
    }
}

impl fmt::Debug for PacketBuilder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.packet().fmt(f)
    }
}
