//! Builds packets, and reads them without copying.

use core::fmt;
use core::ops::RangeInclusive;

use crate::codec::Writer;
use crate::error::{DecodeError, DecodeErrorKind, EncodeError, EncodeErrorKind};
use crate::field::{Field, OneSet, RawField};
use crate::parser::copy;
use crate::protocol::{DescriptorSet, SYNC};
use crate::view::{self, View, Viewed};

/// The maximum size of a payload.
pub const MAX_PAYLOAD: usize = 255;
/// The maximum size of a packet.
pub const MAX_PACKET: usize = MAX_PAYLOAD + OVERHEAD;
/// The maximum size of the data of one field.
pub const MAX_FIELD_DATA: usize = 253;

pub(crate) const HEADER: usize = 4;
pub(crate) const OVERHEAD: usize = HEADER + 2;
const FIELD_HEADER: usize = 2;

/// Data of a fixed size up to this number of bytes is summed before it is written to memory.
const SMALL: usize = 32;

/// True if speed matters more than size: on 64-bit systems, but not on microcontrollers.
pub(crate) const HOST: bool = cfg!(target_pointer_width = "64");

/// Computes the two checksum bytes of a packet: sums over header and payload.
///
/// ```
/// assert_eq!(mip_protocol::checksum(b"\x75\x65\x01\x02\x02\x01"), [0xE0, 0xC6]);
/// ```
#[must_use]
#[inline]
pub fn checksum(bytes: &[u8]) -> [u8; 2] {
    if HOST {
        quick(bytes)
    } else {
        small(bytes)
    }
}

/// Computes a checksum byte by byte, with little code.
#[inline(never)] // most packets are summed by `blocks`, and this code would only take space there
fn small(bytes: &[u8]) -> [u8; 2] {
    sums([0, 0], bytes)
}

/// Continues a checksum.
#[inline]
fn sums([mut a, mut b]: [u8; 2], bytes: &[u8]) -> [u8; 2] {
    for byte in bytes {
        a = a.wrapping_add(*byte);
        b = b.wrapping_add(a);
    }
    [a, b]
}

/// Continues a checksum four bytes at a time: most values have that size, and are still in
/// registers.
#[inline]
fn quads([a, b]: [u8; 2], bytes: &[u8]) -> [u8; 2] {
    // Two lanes of 16 bits, of which only the low eight matter.
    const LANES: u32 = 0x00FF_00FF;
    let (mut even, mut odd, mut before) = (0_u32, 0_u32, 0_u32);
    let quads = bytes.chunks_exact(4);
    let rest = quads.remainder();
    let size = bytes.len().wrapping_sub(rest.len());
    for quad in quads {
        let quad = u32::from_le_bytes(quad.try_into().unwrap_or_default());
        before = before.wrapping_add(even).wrapping_add(odd) & LANES;
        even = even.wrapping_add(quad & LANES);
        odd = odd.wrapping_add(quad >> 8 & LANES);
    }
    // The weights of even bytes are 4 and 2, those of odd ones 3 and 1.
    let both = even.wrapping_add(odd);
    let once = before.wrapping_mul(4).wrapping_add(even).wrapping_add(both);
    let second = once.wrapping_add(once >> 16).wrapping_add(both.wrapping_mul(2));
    let first = both.wrapping_add(both >> 16);
    let b = b.wrapping_add(a.wrapping_mul(size as u8)).wrapping_add(second as u8);
    sums([a.wrapping_add(first as u8), b], rest)
}

/// Bytes that are summed at once, with vector instructions.
type Block = [u8; 16];

/// The weights of a block's bytes in the second sum: 16 to 1, plus 256, which changes none of its
/// low eight bits. Compilers turn powers of two into shifts, and then use no vector instructions.
const WEIGHTS: [u16; 16] =
    [272, 271, 270, 269, 268, 267, 266, 265, 264, 263, 262, 261, 260, 259, 258, 257];

/// At `rest`, a block that keeps the last `rest` bytes of another.
#[rustfmt::skip]
const MASKS: [u8; 32] = [
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
];

/// Returns the sixteen bytes at an offset.
#[inline(always)]
fn block(bytes: &[u8], at: usize) -> Option<Block> {
    bytes.get(at..at.wrapping_add(16))?.try_into().ok()
}

/// Adds two blocks byte by byte.
#[inline(always)]
fn add(mut to: Block, from: Block) -> Block {
    to.iter_mut().zip(&from).for_each(|(to, from)| *to = to.wrapping_add(*from));
    to
}

/// Adds the bytes of a block.
#[inline(always)]
fn total(block: Block) -> u32 {
    block.iter().map(|byte| u32::from(*byte)).sum()
}

/// Computes a checksum, quickly.
#[inline(never)] // inlined, it often gets no vector instructions, and is half as fast
fn quick(bytes: &[u8]) -> [u8; 2] {
    blocks(bytes).unwrap_or_else(|| small(bytes))
}

/// Computes a checksum sixteen bytes at a time. Returns `None` if there are fewer.
#[inline(always)]
fn blocks(bytes: &[u8]) -> Option<[u8; 2]> {
    let mut last = block(bytes, bytes.len().wrapping_sub(16))?;
    // Sums of bytes by their position in a block, and the sum of these sums before each block.
    // Only the low eight bits of every sum matter.
    let (mut done, mut before) = ([0; 16], [0; 16]);
    let mut at = 0;
    while let Some(block) = block(bytes, at) {
        before = add(before, done);
        done = add(done, block);
        at = at.wrapping_add(16);
    }
    // The bytes after the blocks are the last ones of the last sixteen.
    let rest = bytes.len() % 16;
    last.iter_mut().zip(&block(&MASKS, rest)?).for_each(|(byte, mask)| *byte &= *mask);
    let sums = add(done, last);
    // The weighted sum is first: in another order, compilers mix the sums, which is slower.
    let within = weighted(sums);
    let after = total(done).wrapping_mul(rest as u32).wrapping_add(total(before).wrapping_mul(16));
    Some([total(sums) as u8, within.wrapping_add(after as u8)])
}

/// Adds the bytes of a block, with their weights.
#[inline(always)]
fn weighted(block: Block) -> u8 {
    let products = block.iter().zip(&WEIGHTS).map(|(a, b)| u16::from(*a).wrapping_mul(*b));
    products.fold(0, u16::wrapping_add) as u8
}

/// Why bytes are not a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PacketError {
    /// The bytes do not start with the two sync bytes.
    Sync,
    /// The number of bytes differs from the length in the packet, or the descriptor set is 0 or
    /// 0xFF, which no packet has.
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
#[non_exhaustive]
pub struct FieldLengthError;

impl fmt::Display for FieldLengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the length of a field does not fit into the packet")
    }
}

error!(PacketError FieldLengthError);

/// A complete packet with a correct checksum, borrowed from the memory that holds its bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Packet<'a> {
    bytes: &'a [u8],
}

impl<'a> Packet<'a> {
    /// Checks that bytes are exactly one packet.
    ///
    /// ```
    /// use mip_protocol::{Packet, PacketError};
    ///
    /// assert!(Packet::new(b"\x75\x65\x01\x02\x02\x01\xE0\xC6").is_ok());
    /// assert_eq!(Packet::new(b"$GPGGA"), Err(PacketError::Sync));
    /// ```
    ///
    /// # Errors
    ///
    /// The sync bytes, the length or the checksum is wrong.
    pub fn new(bytes: &'a [u8]) -> Result<Self, PacketError> {
        if !bytes.starts_with(&SYNC) {
            return Err(PacketError::Sync);
        }
        let [_, _, 1..=254, length, ..] = *bytes else {
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

    /// Creates a packet from bytes that are known to be one.
    pub(crate) const fn trusted(bytes: &'a [u8]) -> Self {
        Self { bytes }
    }

    /// Returns all bytes of the packet.
    #[must_use]
    pub const fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// Returns the descriptor set.
    #[must_use]
    pub fn set(&self) -> DescriptorSet {
        DescriptorSet(self.bytes.get(2).copied().unwrap_or_default())
    }

    /// Returns the payload: the fields, one after another.
    ///
    /// ```
    /// let packet = mip_protocol::Packet::new(b"\x75\x65\x01\x02\x02\x01\xE0\xC6")?;
    /// assert_eq!(packet.payload(), [2, 1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn payload(&self) -> &'a [u8] {
        self.bytes.get(HEADER..self.bytes.len().saturating_sub(2)).unwrap_or_default()
    }

    /// Iterates over the fields.
    ///
    /// ```
    /// let packet = mip_protocol::Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")?;
    /// for field in packet.fields() {
    ///     assert_eq!(field?.descriptor, 0xF1);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn fields(&self) -> Fields<'a> {
        match *self.bytes {
            [_, _, set, _, ref payload @ .., _, _] => Fields { set: DescriptorSet(set), payload },
            _ => Fields::NONE,
        }
    }

    /// Decodes the first field of this type; `None` if the packet contains none.
    ///
    /// A type that occurs in several descriptor sets is found in packets of each; for the packet's
    /// set, call [`Packet::set`].
    ///
    /// A tuple of types is found if the packet contains them all; see [`FromPacket`].
    ///
    /// A field of this type that extends past the payload is an error
    /// ([`Truncated`](crate::DecodeErrorKind::Truncated)), even if the part in the packet could be
    /// decoded.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Packet};
    ///
    /// let packet = Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")?;
    /// if let Some(reply) = packet.find::<Acknowledge>()? {
    ///     assert_eq!(reply.command, 1);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The data is invalid.
    #[inline]
    pub fn find<T: FromPacket>(&self) -> Result<Option<T>, DecodeError> {
        T::from_packet(self)
    }

    /// Like [`Packet::find`], but returns a view, to read values in place.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Packet};
    ///
    /// let packet = Packet::new(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A")?;
    /// assert_eq!(packet.view::<Acknowledge>()?.map(|reply| reply.command()), Some(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The data is too short.
    #[inline]
    pub fn view<T: Field + Viewed>(&self) -> Result<Option<View<'a, T>>, DecodeError> {
        self.search::<T>()?.map(|field| view::open(field.data)).transpose()
    }

    /// Decodes all fields of this type, in order. One that extends past the payload is an error, as
    /// for [`Packet::find`].
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, Packet};
    ///
    /// let bytes = [
    ///     0x75, 0x65, 0x01, 0x08, 0x04, 0xF1, 0x01, 0x00, 0x04, 0xF1, 0x02, 0x04, 0xD4, 0xCD,
    /// ];
    /// let packet = Packet::new(&bytes)?;
    /// for reply in packet.find_all::<Acknowledge>() {
    ///     println!("{:?}", reply?);
    /// }
    /// assert_eq!(packet.find_all::<Acknowledge>().count(), 2);
    /// assert_eq!(packet.into_iter().count(), 2); // and `for field in &packet`
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn find_all<T: Field + 'a>(&self) -> impl Iterator<Item = Result<T, DecodeError>> + 'a {
        let mut fields = if T::occurs_in(self.set()) { self.fields() } else { Fields::NONE };
        core::iter::from_fn(move || {
            while let Some(field) = fields.sound() {
                if field.descriptor == T::DESCRIPTOR && field.has_layout_of::<T>() {
                    return Some(T::decode(field.data));
                }
            }
            let cut = fields.cut(T::DESCRIPTOR, &T::SIZES, T::CONSTANTS, T::NAME);
            fields.end();
            cut.map(Err)
        })
    }

    /// Returns the first field of this type, not yet decoded.
    #[inline]
    fn search<T: Field>(&self) -> Result<Option<RawField<'a>>, DecodeError> {
        let mut fields = self.fields();
        if !T::occurs_in(fields.set) {
            return Ok(None);
        }
        while let Some(field) = fields.sound() {
            if field.descriptor == T::DESCRIPTOR && field.has_layout_of::<T>() {
                return Ok(Some(field));
            }
        }
        if fields.payload.is_empty() {
            return Ok(None);
        }
        fields.cut(T::DESCRIPTOR, &T::SIZES, T::CONSTANTS, T::NAME).map_or(Ok(None), Err)
    }
}

/// What [`Packet::find`] reads from one packet: a field; or a tuple of up to six fields, all of which
/// must be there. In a tuple, `Option<T>` is a field that may be absent; at least one is there.
#[cfg_attr(
    any(feature = "open", feature = "core-error"), // they need a Rust that has this
    diagnostic::on_unimplemented(
        message = "`{Self}` is no field that a packet can contain",
        note = "types of fields are in the modules of the descriptor sets, such as `sensor::ScaledAccel`"
    )
)]
pub trait FromPacket: Sized {
    /// Decodes it; `None` if it is not in the packet.
    ///
    /// # Errors
    ///
    /// The data of a field is invalid.
    fn from_packet(packet: &Packet<'_>) -> Result<Option<Self>, DecodeError>;

    #[doc(hidden)]
    fn is_present(&self) -> bool {
        true
    }
}

#[doc(hidden)]
impl<T: Field> FromPacket for T {
    #[inline]
    fn from_packet(packet: &Packet<'_>) -> Result<Option<Self>, DecodeError> {
        packet.search::<T>()?.map(|field| T::decode(field.data)).transpose()
    }
}

impl<T: Field> FromPacket for Option<T> {
    #[inline]
    fn from_packet(packet: &Packet<'_>) -> Result<Option<Self>, DecodeError> {
        T::from_packet(packet).map(Some)
    }

    fn is_present(&self) -> bool {
        self.is_some()
    }
}

macro_rules! several {
    ($($part:ident)+) => {
        #[allow(non_snake_case)]
        impl<$($part: FromPacket),+> FromPacket for ($($part,)+) {
            #[inline]
            fn from_packet(packet: &Packet<'_>) -> Result<Option<Self>, DecodeError> {
                $(let Some($part) = $part::from_packet(packet)? else { return Ok(None) };)+
                Ok(($($part.is_present())||+).then_some(($($part,)+)))
            }
        }
    };
}

several! { A B }
several! { A B C }
several! { A B C D }
several! { A B C D E }
several! { A B C D E F }

impl<'a> IntoIterator for Packet<'a> {
    type Item = Result<RawField<'a>, FieldLengthError>;
    type IntoIter = Fields<'a>;

    fn into_iter(self) -> Fields<'a> {
        self.fields()
    }
}

impl<'a> IntoIterator for &Packet<'a> {
    type Item = Result<RawField<'a>, FieldLengthError>;
    type IntoIter = Fields<'a>;

    fn into_iter(self) -> Fields<'a> {
        self.fields()
    }
}

impl AsRef<[u8]> for Packet<'_> {
    fn as_ref(&self) -> &[u8] {
        self.bytes
    }
}

impl<'a> TryFrom<&'a [u8]> for Packet<'a> {
    type Error = PacketError;

    fn try_from(bytes: &'a [u8]) -> Result<Self, PacketError> {
        Self::new(bytes)
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
    set: DescriptorSet,
    payload: &'a [u8],
}

impl<'a> Fields<'a> {
    pub(crate) const NONE: Self = Self { set: DescriptorSet(0), payload: &[] };

    pub(crate) fn new(set: DescriptorSet, payload: &'a [u8]) -> Self {
        Self { set, payload }
    }

    /// Returns the descriptor set.
    pub(crate) const fn set(&self) -> DescriptorSet {
        self.set
    }

    /// Skips all further fields.
    pub(crate) fn end(&mut self) {
        self.payload = &[];
    }

    /// Returns the bytes of all remaining fields.
    pub(crate) const fn payload(&self) -> &'a [u8] {
        self.payload
    }

    /// Returns the next field, if there is one and it is not malformed.
    #[inline]
    pub(crate) fn sound(&mut self) -> Option<RawField<'a>> {
        let [length @ 2..=255, descriptor, ..] = *self.payload else { return None };
        let rest = self.payload.get(length.into()..)?;
        let data = self.payload.get(FIELD_HEADER..length.into())?;
        self.payload = rest;
        Some(RawField { set: self.set, descriptor, data })
    }

    /// Returns the error for a last field that extends past the payload, if its present part
    /// matches the searched one.
    #[cold]
    fn cut(
        &self,
        wanted: u8,
        sizes: &RangeInclusive<usize>,
        constants: &[(usize, &[u8])],
        name: &'static str,
    ) -> Option<DecodeError> {
        let [length @ 2..=255, descriptor, data @ ..] = self.payload else { return None };
        let need = usize::from(*length).saturating_sub(FIELD_HEADER);
        let field = RawField { set: self.set, descriptor: *descriptor, data };
        let is_it =
            *descriptor == wanted && sizes.contains(&need) && field.has_constants(constants);
        is_it.then(|| DecodeError::new(DecodeErrorKind::Truncated, name, need, data.len()))
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = Result<RawField<'a>, FieldLengthError>;

    // Without this, each field costs a call that returns it in memory, which halves decoding speed.
    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if let Some(field) = self.sound() {
            return Some(Ok(field));
        }
        let malformed = !self.payload.is_empty();
        self.payload = &[];
        malformed.then_some(Err(FieldLengthError))
    }
}

impl core::iter::FusedIterator for Fields<'_> {}

/// Builds a packet from fields. It contains a valid packet at any time.
///
/// Adding a field that does not fit is an error, and leaves the packet unchanged. A builder owns
/// its packet, so it can also keep a received one: [`From`] copies that without checking it again.
#[derive(Clone)]
pub struct PacketBuilder {
    bytes: [u8; MAX_PACKET],
}

impl PacketBuilder {
    /// Begins a packet of this descriptor set, without fields.
    ///
    /// No packet has set 0 or 0xFF, and [`Packet::new`] rejects them: a builder with such a set
    /// accepts no field, and its packet must not be sent.
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] {
    /// use mip_protocol::sensor::{self, ScaledAccel};
    /// use mip_protocol::PacketBuilder;
    ///
    /// let mut builder = PacketBuilder::new(sensor::SET);
    /// builder.push(&ScaledAccel::default()).unwrap();
    /// builder.push_raw(0xFE, &[1, 2]).unwrap(); // a field that this crate does not know
    /// assert_eq!(builder.packet().fields().count(), 2);
    /// # }
    /// ```
    #[must_use]
    pub const fn new(set: DescriptorSet) -> Self {
        let [first, second] = SYNC;
        let mut bytes = [0; MAX_PACKET];
        (bytes[0], bytes[1], bytes[2]) = (first, second, set.0);
        [bytes[4], bytes[5]] = Self::sums_of_header(set);
        Self { bytes }
    }

    /// Computes the checksum of a packet without fields.
    #[inline]
    const fn sums_of_header(set: DescriptorSet) -> [u8; 2] {
        let [first, second] = SYNC;
        let sum = first.wrapping_add(second).wrapping_add(set.0);
        // The second sum counts each byte once, and once more for each header byte after it.
        [sum, sum.wrapping_mul(2).wrapping_add(first.wrapping_mul(2)).wrapping_add(second)]
    }

    /// Zeroed memory in which a packet can be begun.
    pub(crate) const BLANK: Self = Self { bytes: [0; MAX_PACKET] };

    /// Begins the next packet, with another set.
    pub(crate) fn start(&mut self, set: DescriptorSet) {
        let [first, second, number, payload, ..] = &mut self.bytes;
        let [a, b] = SYNC;
        (*first, *second, *number, *payload) = (a, b, set.0, 0);
        self.seal(Self::sums_of_header(set));
    }

    /// Builds a packet with only this field, which must occur in one set only.
    ///
    /// For a field of several sets, begin the packet with [`PacketBuilder::new`], and
    /// [push](PacketBuilder::push) the field.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// let packet = mip_protocol::PacketBuilder::with(&mip_protocol::base::Ping::new()).unwrap();
    /// assert_eq!(packet.bytes(), b"\x75\x65\x01\x02\x02\x01\xE0\xC6");
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// Returns the errors of [`PacketBuilder::push`].
    pub fn with<T: OneSet>(field: &T) -> Result<Self, EncodeError> {
        let mut builder = Self::new(T::SET);
        builder.push(field)?;
        Ok(builder)
    }

    /// Returns the descriptor set.
    #[must_use]
    pub const fn set(&self) -> DescriptorSet {
        let [_, _, set, ..] = self.bytes;
        DescriptorSet(set)
    }

    /// Appends a field, which must occur in the set of the packet.
    ///
    /// ```
    /// use mip_protocol::{protocol::Acknowledge, PacketBuilder};
    ///
    /// let mut builder = PacketBuilder::new(0x01.into());
    /// builder.push(&Acknowledge { command: 1, code: 0.into() })?;
    /// assert_eq!(builder.packet().bytes(), b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A");
    /// # Ok::<(), mip_protocol::EncodeError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The field does not occur in the set, cannot be encoded, or does not fit.
    #[inline]
    pub fn push<T: Field>(&mut self, field: &T) -> Result<(), EncodeError> {
        let set = T::SETS.first().copied().unwrap_or_default();
        if !T::occurs_in(self.set()) {
            return Err(EncodeError::set(T::NAME, set, self.set()));
        }
        if HOST && T::FIXED && T::SIZE <= SMALL {
            // The data stays in registers, because reading it back from memory takes longer.
            let mut data = [0; SMALL];
            field.encode(&mut data)?;
            let data = data.get(..T::SIZE).unwrap_or_default();
            return self.append(T::NAME, set, T::DESCRIPTOR, data);
        }
        let length = field.encode(self.free(T::NAME, set)?)?;
        self.close(T::DESCRIPTOR, length);
        Ok(())
    }

    /// Like `push`, but compiled once for all types; the caller has compared the sets.
    pub(crate) fn push_by(
        &mut self,
        name: &'static str,
        set: DescriptorSet,
        descriptor: u8,
        encode: &dyn Fn(&mut Writer<'_>) -> Result<(), EncodeErrorKind>,
    ) -> Result<(), EncodeError> {
        let mut writer = Writer::of_field(self.free(name, set)?);
        let done = encode(&mut writer);
        let length = writer.finish(done, name)?;
        self.close(descriptor, length);
        Ok(())
    }

    /// Appends a field from its bytes.
    ///
    /// ```
    /// let mut builder = mip_protocol::PacketBuilder::new(0x01.into());
    /// builder.push_raw(0x01, &[])?;
    /// assert_eq!(builder.packet().bytes(), b"\x75\x65\x01\x02\x02\x01\xE0\xC6");
    /// # Ok::<(), mip_protocol::EncodeError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The bytes do not fit, or the set of the packet is 0 or 0xFF.
    pub fn push_raw(&mut self, descriptor: u8, data: &[u8]) -> Result<(), EncodeError> {
        self.append("", self.set(), descriptor, data)
    }

    /// Removes all fields, to build the next packet of the set. A loop with one builder clears a
    /// packet's memory only once.
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] {
    /// use mip_protocol::{sensor, PacketBuilder};
    ///
    /// let mut builder = PacketBuilder::new(sensor::SET);
    /// for x in [1.0, 2.0] {
    ///     builder.clear();
    ///     builder.push(&sensor::ScaledAccel::new([x, 0.0, -1.0])).unwrap();
    ///     println!("{:02x?}", builder.bytes());
    /// }
    /// # }
    /// ```
    #[inline]
    pub fn clear(&mut self) {
        let [_, _, set, payload, ..] = &mut self.bytes;
        *payload = 0;
        let sums = Self::sums_of_header(DescriptorSet(*set));
        self.seal(sums);
    }

    /// Returns the bytes to send.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get(..self.end().saturating_add(2)).unwrap_or_default()
    }

    /// Returns the packet as it is now.
    #[must_use]
    pub fn packet(&self) -> Packet<'_> {
        Packet { bytes: self.bytes() }
    }

    /// Returns the offset of the checksum.
    #[inline]
    fn end(&self) -> usize {
        let [_, _, _, payload, ..] = self.bytes;
        HEADER.saturating_add(payload.into())
    }

    /// Returns the space for the data of another field, whose header will replace the checksum.
    /// Until the field is closed, the packet is unchanged.
    #[inline]
    fn free(&mut self, field: &'static str, set: DescriptorSet) -> Result<&mut [u8], EncodeError> {
        if matches!(self.set().0, 0 | 0xFF) {
            return Err(EncodeError::set(field, set, self.set()));
        }
        let payload = self.end();
        let start = payload.saturating_add(FIELD_HEADER);
        let end = start.saturating_add(MAX_FIELD_DATA).min(HEADER.saturating_add(MAX_PAYLOAD));
        let left = end.saturating_sub(payload);
        self.bytes.get_mut(start..end).ok_or(EncodeError::length(field, FIELD_HEADER, left))
    }

    /// Adds a field from its data.
    #[inline]
    fn append(
        &mut self,
        field: &'static str,
        set: DescriptorSet,
        descriptor: u8,
        data: &[u8],
    ) -> Result<(), EncodeError> {
        let free = self.free(field, set)?;
        if data.len() > free.len() {
            return Err(EncodeError::length(field, data.len(), free.len()));
        }
        copy(free, data);
        if HOST {
            let (before, header) = self.head(descriptor, data.len());
            self.seal(quads(sums(before, &header), data));
        } else {
            self.close(descriptor, data.len());
        }
        Ok(())
    }

    /// Adds a field whose data is already in the packet.
    #[inline]
    fn close(&mut self, descriptor: u8, length: usize) {
        let start = self.end();
        let (before, _) = self.head(descriptor, length);
        let field = self.bytes.get(start..self.end()).unwrap_or_default();
        self.seal(sums(before, field));
    }

    /// Writes the header of another field. Returns the checksum before it, and the header.
    ///
    /// The checksum continues from the previous one. Because its second sum adds the first one
    /// after each byte, the increase of the payload length counts once for each byte since then.
    #[inline]
    fn head(&mut self, descriptor: u8, length: usize) -> ([u8; 2], [u8; 2]) {
        let end = self.end().min(MAX_PACKET);
        let header = [length.saturating_add(FIELD_HEADER) as u8, descriptor];
        let [grown, _] = header;
        let (head, tail) = self.bytes.split_at_mut(end);
        let ([_, _, _, payload, ..], [a, b, ..]) = (head, tail) else { return ([0, 0], header) };
        *payload = payload.wrapping_add(grown);
        let since_length = (end as u8).wrapping_sub(3);
        let before = [a.wrapping_add(grown), b.wrapping_add(grown.wrapping_mul(since_length))];
        [*a, *b] = header;
        (before, header)
    }

    /// Sets the checksum.
    #[inline]
    fn seal(&mut self, sums: [u8; 2]) {
        let end = self.end();
        if let Some([a, b, ..]) = self.bytes.get_mut(end..) {
            [*a, *b] = sums;
        }
    }
}

impl PartialEq for PacketBuilder {
    fn eq(&self, other: &Self) -> bool {
        self.bytes() == other.bytes()
    }
}

impl Eq for PacketBuilder {}

impl From<Packet<'_>> for PacketBuilder {
    fn from(packet: Packet<'_>) -> Self {
        let mut builder = Self::new(DescriptorSet(0));
        let places = builder.bytes.iter_mut().zip(packet.bytes);
        places.for_each(|(place, byte)| *place = *byte);
        builder
    }
}

impl<'a> From<&'a PacketBuilder> for Packet<'a> {
    fn from(builder: &'a PacketBuilder) -> Self {
        builder.packet()
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
