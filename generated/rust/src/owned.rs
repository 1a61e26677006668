//! Packets on the heap.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use crate::error::DecodeError;
use crate::field::RawField;
use crate::packet::{FieldLengthError, Fields, FromPacket, Packet, PacketBuilder, PacketError};
use crate::protocol::DescriptorSet;
use crate::time::Clock;

/// A packet that owns its bytes, so that it can be kept or sent to another thread.
///
/// Conversions from and to [`Packet`] do not check the packet again:
///
/// ```
/// use mip_protocol::{packets, Packet, PacketBuf};
///
/// let log = b"\x75\x65\x01\x02\x02\x01\xE0\xC6\x75\x65\x01\x02\x02\x01\xE0\xC6";
/// let kept: Vec<PacketBuf> = packets(log).map(PacketBuf::from).collect();
/// let packet: Packet<'_> = (&kept[0]).into();
/// assert_eq!((packet.set().0, kept[1].fields().count()), (1, 1));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct PacketBuf {
    bytes: Box<[u8]>,
}

impl PacketBuf {
    /// Returns all bytes of the packet.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Borrows the packet, to read it.
    #[must_use]
    pub fn packet(&self) -> Packet<'_> {
        Packet::trusted(&self.bytes)
    }

    /// Returns the descriptor set.
    #[must_use]
    pub fn set(&self) -> DescriptorSet {
        self.packet().set()
    }

    /// Iterates over the fields.
    #[must_use]
    pub fn fields(&self) -> Fields<'_> {
        self.packet().fields()
    }

    /// Decodes the first field of this type; see [`Packet::find`].
    ///
    /// # Errors
    ///
    /// The data is invalid.
    #[inline]
    pub fn find<T: FromPacket>(&self) -> Result<Option<T>, DecodeError> {
        self.packet().find()
    }

    /// Returns the time of a clock in the packet; see [`Packet::time`].
    #[must_use]
    pub fn time(&self, clock: Clock) -> Option<i64> {
        self.packet().time(clock)
    }
}

impl<'a> IntoIterator for &'a PacketBuf {
    type Item = Result<RawField<'a>, FieldLengthError>;
    type IntoIter = Fields<'a>;

    fn into_iter(self) -> Fields<'a> {
        self.fields()
    }
}

impl From<Packet<'_>> for PacketBuf {
    fn from(packet: Packet<'_>) -> Self {
        Self { bytes: packet.bytes().into() }
    }
}

impl From<&PacketBuilder> for PacketBuf {
    fn from(builder: &PacketBuilder) -> Self {
        builder.packet().into()
    }
}

impl<'a> From<&'a PacketBuf> for Packet<'a> {
    fn from(packet: &'a PacketBuf) -> Self {
        packet.packet()
    }
}

impl From<PacketBuf> for Vec<u8> {
    fn from(packet: PacketBuf) -> Self {
        packet.bytes.into()
    }
}

/// Checks the bytes, and keeps them in place.
impl TryFrom<Vec<u8>> for PacketBuf {
    type Error = PacketError;

    fn try_from(bytes: Vec<u8>) -> Result<Self, PacketError> {
        Packet::new(&bytes)?;
        Ok(Self { bytes: bytes.into() })
    }
}

/// Checks the bytes, and copies them.
impl TryFrom<&[u8]> for PacketBuf {
    type Error = PacketError;

    fn try_from(bytes: &[u8]) -> Result<Self, PacketError> {
        Packet::new(bytes).map(Self::from)
    }
}

impl AsRef<[u8]> for PacketBuf {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

impl fmt::Debug for PacketBuf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.packet().fmt(f)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for PacketBuf {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.bytes())
    }
}

/// Checks the bytes.
#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for PacketBuf {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let bytes = crate::List::<u8, { crate::packet::MAX_PACKET }>::deserialize(deserializer)?;
        Self::try_from(bytes.as_slice()).map_err(serde::de::Error::custom)
    }
}
