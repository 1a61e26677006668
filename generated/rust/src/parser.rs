//! Finds packets in a stream of bytes that arrives piece by piece.

use core::fmt;

use crate::packet::{checksum, Packet, HEADER, MAX_PACKET, OVERHEAD};
use crate::protocol::SYNC;

/// Finds the packets in a stream that arrives in chunks of any size.
///
/// Garbage, other protocols, false syncs and broken packets never hide a packet: after a bad
/// candidate the search continues one byte after its sync. Nothing is allocated. A packet that lies
/// inside a chunk is checked and returned there; only one that is cut by its end is copied.
///
/// ```
/// use mip_protocol::Parser;
///
/// let mut parser = Parser::new();
/// for chunk in [&b"noise\x75\x65\x01\x02"[..], b"\x02\x01\xE0\xC6 and more"] {
///     let mut packets = parser.feed(chunk);
///     while let Some(packet) = packets.next() {
///         assert_eq!(packet.set(), 1);
///     }
/// }
/// assert_eq!(parser.skipped(), 14);
/// ```
///
/// If all bytes are in memory, [`packets`](crate::packets) is simpler.
#[derive(Clone)]
pub struct Parser {
    /// A candidate that the end of a chunk has cut, or the packet that was returned last.
    buffer: [u8; MAX_PACKET],
    length: u16,
    /// The size of the packet in the buffer that was returned last.
    done: u16,
    /// How many bytes are needed to judge the candidate in the buffer.
    missing: u16,
    /// The low word and the high one: with the alignment of 64 bits, clearing the memory of a parser
    /// and of a client is not the same function on microcontrollers.
    skipped: [u32; 2],
}

/// Where a packet is.
pub(crate) enum Found<'i> {
    InBuffer,
    /// The last bytes that were removed from the input.
    InInput(&'i [u8]),
}

/// What the bytes starting at a possible sync are.
pub(crate) enum Candidate {
    Whole(usize),
    Bad,
    /// Undecided until this many bytes are available.
    Open(usize),
}

#[inline]
pub(crate) fn judge(bytes: &[u8]) -> Candidate {
    let [first, second] = SYNC;
    match *bytes {
        [a, ..] if a != first => Candidate::Bad,
        [_, b, ..] if b != second => Candidate::Bad,
        [_, _, 0, ..] => Candidate::Bad,
        [_, _, _, length, ..] => {
            let size = usize::from(length).saturating_add(OVERHEAD);
            match bytes.get(..size) {
                Some([head @ .., a, b]) if [*a, *b] == checksum(head) => Candidate::Whole(size),
                Some(_) => Candidate::Bad,
                None => Candidate::Open(size),
            }
        }
        _ => Candidate::Open(HEADER),
    }
}

/// The first byte, and those up to the next that may begin a packet.
pub(crate) fn noise(bytes: &[u8]) -> usize {
    let sync = bytes.iter().skip(1).position(|b| *b == SYNC[0]);
    sync.map_or(bytes.len(), |at| at.saturating_add(1))
}

/// What follows the first bytes.
pub(crate) fn behind(bytes: &[u8], count: usize) -> &[u8] {
    bytes.get(count..).unwrap_or_default()
}

impl fmt::Debug for Parser {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Parser({} pending, {} skipped)", self.pending(), self.skipped())
    }
}

impl Default for Parser {
    fn default() -> Self {
        Self::new()
    }
}

impl Parser {
    /// A new parser.
    #[must_use]
    pub const fn new() -> Self {
        Self { buffer: [0; MAX_PACKET], length: 0, done: 0, missing: 0, skipped: [0; 2] }
    }

    /// The number of bytes so far that are not part of a packet, without those that are held back.
    #[must_use]
    pub const fn skipped(&self) -> u64 {
        let [low, high] = self.skipped;
        (high as u64) << 32 | low as u64
    }

    /// The number of bytes that are held back until more arrive.
    #[must_use]
    pub const fn pending(&self) -> usize {
        self.length.saturating_sub(self.done) as usize
    }

    /// Takes a chunk, and returns a [`Feed`] that lends its packets one after another.
    pub fn feed<'p, 'i>(&'p mut self, chunk: &'i [u8]) -> Feed<'p, 'i> {
        Feed { parser: self, rest: chunk }
    }

    /// Discards the pending candidate only if a whole packet follows its first bytes, and returns
    /// that packet: the candidate was noise. Otherwise nothing changes.
    pub fn look_behind(&mut self) -> Option<Packet<'_>> {
        self.held_back(true)
    }

    /// The next packet that is complete in the buffer; also one after the candidate, if requested.
    pub(crate) fn held_back(&mut self, behind_candidate: bool) -> Option<Packet<'_>> {
        if self.step(&mut [].as_slice()).is_none() {
            if !behind_candidate {
                return None;
            }
            let mut at = 0_usize;
            let size = loop {
                at = at.wrapping_add(1);
                match judge(behind(self.held(), at)) {
                    Candidate::Whole(size) => break size,
                    _ if at >= self.held().len() => return None,
                    _ => {}
                }
            };
            self.skip(at);
            self.drop_front(at);
            self.done = short(size);
        }
        Some(self.packet())
    }

    /// Discards the pending candidate, for example at the end of a file.
    ///
    /// Packets inside it are not lost: call it until it returns `None`.
    pub fn flush(&mut self) -> Option<Packet<'_>> {
        while self.step(&mut [].as_slice()).is_none() {
            if self.length == 0 {
                return None;
            }
            let count = noise(self.held());
            self.skip(count);
            self.drop_front(count);
            self.missing = 0;
        }
        Some(self.packet())
    }

    /// Searches for a packet and removes the searched bytes from the front of the input.
    pub(crate) fn step<'i>(&mut self, input: &mut &'i [u8]) -> Option<Found<'i>> {
        let given = *input;
        if self.done > 0 {
            self.drop_front(self.done.into());
            (self.done, self.missing) = (0, 0);
        }
        loop {
            if self.missing > 0 && !self.fill(input) {
                return None;
            }
            let buffered = self.length > 0;
            let bytes = if buffered { self.held() } else { *input };
            match judge(bytes) {
                Candidate::Whole(size) => {
                    if buffered {
                        self.done = short(size);
                        return Some(Found::InBuffer);
                    }
                    let (packet, rest) = input.split_at(size.min(input.len()));
                    *input = rest;
                    return Some(Found::InInput(packet));
                }
                Candidate::Open(size) => {
                    let known = bytes.len();
                    if known == 0 {
                        return None;
                    }
                    if !buffered {
                        self.missing = short(known);
                        self.fill(input);
                    }
                    self.missing = short(size.saturating_sub(known));
                }
                Candidate::Bad => {
                    let count = noise(bytes);
                    self.skip(count);
                    if buffered {
                        self.drop_front(count);
                        // The rest, which has just been copied, is found again where it was.
                        let left = usize::from(self.length);
                        let start = given.len().saturating_sub(input.len()).checked_sub(left);
                        if let Some(start) = start {
                            *input = behind(given, start);
                            self.length = 0;
                        }
                    } else {
                        *input = behind(input, count);
                    }
                }
            }
        }
    }

    /// Removes the packet that was returned last. True if nothing else is held back.
    #[inline]
    pub(crate) fn is_empty(&mut self) -> bool {
        if self.length != self.done {
            return false;
        }
        (self.length, self.done, self.missing) = (0, 0, 0);
        true
    }

    /// The packet in the buffer that was found last.
    pub(crate) fn packet(&self) -> Packet<'_> {
        Packet::trusted(self.buffer.get(..self.done.into()).unwrap_or_default())
    }

    fn held(&self) -> &[u8] {
        self.buffer.get(..self.length.into()).unwrap_or_default()
    }

    fn skip(&mut self, count: usize) {
        let skipped = self.skipped().wrapping_add(count as u64);
        self.skipped = [skipped as u32, (skipped >> 32) as u32];
    }

    /// Removes bytes from the front of the buffer.
    fn drop_front(&mut self, count: usize) {
        let (mut from, mut to) = (count, 0);
        while let Some(byte) = self.held().get(from).copied() {
            if let Some(place) = self.buffer.get_mut(to) {
                *place = byte;
            }
            (from, to) = (from.wrapping_add(1), to.wrapping_add(1));
        }
        self.length = short(to);
    }

    /// Takes the missing bytes from the input. True if all of them are there.
    fn fill(&mut self, input: &mut &[u8]) -> bool {
        let count = usize::from(self.missing).min(input.len());
        let (head, tail) = input.split_at(count);
        let free = self.buffer.get_mut(self.length.into()..).unwrap_or_default();
        match (free, head) {
            ([place, ..], [byte]) => *place = *byte,
            (free, head) => {
                for (place, byte) in free.iter_mut().zip(head) {
                    *place = *byte;
                }
            }
        }
        *input = tail;
        self.length = self.length.wrapping_add(short(count));
        self.missing = self.missing.wrapping_sub(short(count));
        self.missing == 0
    }
}

/// Numbers of bytes in the buffer are small.
const fn short(count: usize) -> u16 {
    count as u16
}

/// A chunk that a parser works through; from [`Parser::feed`].
///
/// ```
/// # use mip_protocol::Parser;
/// # let mut parser = Parser::new();
/// # let chunk = b"\x75\x65\x01\x02\x02\x01\xE0\xC6";
/// let mut packets = parser.feed(chunk);
/// while let Some(packet) = packets.next() {
///     println!("{packet:?}");
/// }
/// ```
///
/// A packet may be in the parser's buffer, which is needed for the next one: this is not an
/// `Iterator`, and a packet cannot be kept while the next is requested. To keep it, copy it, for
/// example into a [`PacketBuilder`](crate::PacketBuilder) or a `PacketBuf`.
///
/// ```compile_fail
/// # use mip_protocol::Parser;
/// # let mut parser = Parser::new();
/// # let chunk = b"\x75\x65\x01\x02\x02\x01\xE0\xC6";
/// let mut packets = parser.feed(chunk);
/// let first = packets.next();
/// let second = packets.next();
/// println!("{first:?} {second:?}");
/// ```
///
/// Call it until it returns `None`. If you stop earlier, the part of the chunk that was not reached
/// is not in the parser: it is [`Feed::rest`], to be fed later.
#[derive(Debug)]
#[must_use = "it lends the packets of the chunk"]
pub struct Feed<'p, 'i> {
    parser: &'p mut Parser,
    rest: &'i [u8],
}

impl<'i> Feed<'_, 'i> {
    /// The next packet, or `None` at the end of the chunk.
    #[allow(clippy::should_implement_trait)] // an iterator cannot lend
    #[inline]
    pub fn next(&mut self) -> Option<Packet<'_>> {
        // The usual case first: nothing is held back, and a packet is next.
        if self.parser.is_empty() {
            if let Candidate::Whole(size) = judge(self.rest) {
                let (packet, rest) = self.rest.split_at(size.min(self.rest.len()));
                self.rest = rest;
                return Some(Packet::trusted(packet));
            }
        }
        match self.parser.step(&mut self.rest)? {
            Found::InBuffer => Some(self.parser.packet()),
            Found::InInput(bytes) => Some(Packet::trusted(bytes)),
        }
    }

    /// The part of the chunk that has not been reached yet.
    #[must_use]
    pub const fn rest(&self) -> &'i [u8] {
        self.rest
    }
}
