//! Finds packets in a stream of bytes that arrives piece by piece.

use core::cell::Cell;
use core::fmt;

use crate::packet::{checksum, Packet, HEADER, HOST, MAX_PACKET, OVERHEAD};
use crate::protocol::SYNC;

/// Finds the packets in a stream that arrives in chunks of any size.
///
/// Noise, other protocols, false sync bytes and damaged packets never hide a packet: after a bad
/// candidate, the search continues one byte after its first sync byte. Nothing is allocated. A
/// packet within a chunk is checked and returned in place; only one that spans chunks is copied.
///
/// ```
/// use mip_protocol::Parser;
///
/// let mut parser = Parser::new();
/// for chunk in [&b"noise\x75\x65\x01\x02"[..], b"\x02\x01\xE0\xC6 and more"] {
///     parser.feed(chunk).for_each(|packet| assert_eq!(packet.set().0, 1));
/// }
/// assert_eq!(parser.skipped(), 14);
/// ```
///
/// If all bytes are in memory, [`packets`](crate::packets) is simpler.
#[derive(Clone)]
pub struct Parser {
    /// A candidate that continues in the next chunk, or the packet that was returned last.
    buffer: [u8; MAX_PACKET],
    length: u16,
    /// The size of the packet in the buffer that was returned last.
    done: u16,
    /// The number of further bytes needed to judge the candidate in the buffer; 0 after a packet.
    missing: u16,
    /// The low and the high word. With 64-bit alignment, a microcontroller would need different
    /// functions to clear the memory of a parser and of a client.
    skipped: [u32; 2],
}

/// The classification of the bytes that start at a possible sync.
pub(crate) enum Candidate {
    Whole(usize),
    Bad,
    /// Cannot be judged until this many bytes are available.
    Open(usize),
}

#[inline]
pub(crate) fn judge(bytes: &[u8]) -> Candidate {
    let [first, _] = SYNC;
    match *bytes {
        [a, b, 1..=254, length, ..] if [a, b] == SYNC => {
            let size = usize::from(length).saturating_add(OVERHEAD);
            let end = size.saturating_sub(2);
            match (bytes.get(..end), bytes.get(end..size).map(<[u8; 2]>::try_from)) {
                (Some(head), Some(Ok(sums))) if sums == checksum(head) => Candidate::Whole(size),
                (_, Some(_)) => Candidate::Bad,
                _ => Candidate::Open(size),
            }
        }
        [] => Candidate::Open(HEADER),
        [a] if a == first => Candidate::Open(HEADER),
        [a, b] if [a, b] == SYNC => Candidate::Open(HEADER),
        [a, b, 1..=254] if [a, b] == SYNC => Candidate::Open(HEADER),
        _ => Candidate::Bad,
    }
}

/// Do the bytes end with the checksum of the bytes before?
#[inline(never)] // inlined, it would be repeated wherever packets are searched
fn has_checksum(bytes: &[u8]) -> bool {
    matches!(*bytes, [ref head @ .., a, b] if [a, b] == checksum(head))
}

/// Returns the number of bytes up to the next one, after the first, that may begin a packet.
pub(crate) fn noise(bytes: &[u8]) -> usize {
    bytes.iter().skip(1).take_while(|b| **b != SYNC[0]).count().wrapping_add(1)
}

/// Returns the bytes after the first `count`.
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
    /// Creates a parser.
    #[must_use]
    pub const fn new() -> Self {
        Self { buffer: [0; MAX_PACKET], length: 0, done: 0, missing: 0, skipped: [0; 2] }
    }

    /// Returns the number of bytes so far that are not part of a packet, without pending ones.
    #[must_use]
    pub const fn skipped(&self) -> u64 {
        let [low, high] = self.skipped;
        (high as u64) << 32 | low as u64
    }

    /// Returns the number of bytes that are held back until more arrive.
    #[must_use]
    pub const fn pending(&self) -> usize {
        self.length.saturating_sub(self.done) as usize
    }

    /// Accepts a chunk. Call a method of the returned [`Feed`] with a function that handles
    /// packets.
    ///
    /// ```
    /// let (mut parser, mut count) = (mip_protocol::Parser::new(), 0);
    /// for chunk in [&b"\x75\x65\x01\x02"[..], b"\x02\x01\xE0\xC6"] {
    ///     parser.feed(chunk).for_each(|packet| count += packet.fields().count());
    /// }
    /// assert_eq!((count, parser.skipped()), (1, 0));
    /// ```
    #[inline]
    pub fn feed<'p, 'i>(&'p mut self, chunk: &'i [u8]) -> Feed<'p, 'i> {
        Feed { parser: self, chunk }
    }

    /// Returns the next packet of a chunk, or `None` at its end.
    ///
    /// Removes the searched bytes from the front of the chunk, so a loop needs a variable for it:
    ///
    /// ```
    /// # use mip_protocol::Parser;
    /// # let mut parser = Parser::new();
    /// # let received = b"\x75\x65\x01\x02\x02\x01\xE0\xC6";
    /// let mut chunk = &received[..];
    /// while let Some(packet) = parser.next(&mut chunk) {
    ///     println!("{packet:?}");
    /// }
    /// ```
    ///
    /// Call it until it returns `None`. If you stop earlier, the variable contains the bytes that
    /// were not searched, to be passed later.
    ///
    /// A packet cannot be kept while the next one is requested, because it may be in the parser's
    /// buffer. To keep it, copy it, for example into a [`PacketBuilder`](crate::PacketBuilder) or a
    /// `PacketBuf`.
    ///
    /// ```compile_fail
    /// # use mip_protocol::Parser;
    /// # let mut parser = Parser::new();
    /// # let mut chunk = &b"\x75\x65\x01\x02\x02\x01\xE0\xC6"[..];
    /// let first = parser.next(&mut chunk);
    /// let second = parser.next(&mut chunk);
    /// println!("{first:?} {second:?}");
    /// ```
    #[inline(always)] // a loop has it once
    pub fn next<'p, 'i: 'p>(&'p mut self, chunk: &mut &'i [u8]) -> Option<Packet<'p>> {
        // The usual cases first: nothing is held back, and a packet is next, or its first part.
        let input = *chunk;
        if HOST && self.is_empty() {
            match judge(input) {
                Candidate::Whole(size) => {
                    let (packet, rest) = input.split_at(size.min(input.len()));
                    *chunk = rest;
                    return Some(Packet::trusted(packet));
                }
                Candidate::Open(size) => {
                    self.hold(input, size);
                    *chunk = &[];
                    return None;
                }
                Candidate::Bad => {}
            }
        } else if HOST && self.missing > 0 {
            // The next part of a candidate, or the rest of it.
            if input.len() < self.missing.into() {
                self.extend(input);
                *chunk = &[];
                return None;
            }
            let (part, rest) = input.split_at(usize::from(self.missing).min(input.len()));
            let size = self.complete(part);
            if size > 0 {
                *chunk = rest;
                let (packet, _) = self.buffer.split_at(size.min(MAX_PACKET));
                return Some(Packet::trusted(packet));
            }
        }
        self.search(chunk)
    }

    /// Like `next`, in all cases.
    fn search<'p, 'i: 'p>(&'p mut self, chunk: &mut &'i [u8]) -> Option<Packet<'p>> {
        let input = *chunk;
        let (size, left) = self.step(input);
        let (searched, rest) = input.split_at(input.len().saturating_sub(left));
        *chunk = rest;
        match size {
            0 => None,
            _ if self.is_done() => Some(self.packet()),
            _ => Some(Packet::trusted(behind(searched, searched.len().wrapping_sub(size)))),
        }
    }

    /// Discards the pending candidate if a whole packet begins within it, because it was noise, and
    /// returns that packet. Otherwise nothing changes.
    pub fn look_behind(&mut self) -> Option<Packet<'_>> {
        (self.holds() || self.holds_behind()).then(|| self.packet())
    }

    /// Is the next packet complete in the buffer?
    pub(crate) fn holds(&mut self) -> bool {
        self.step(&[]).0 > 0
    }

    /// Is there a packet within the candidate, which is then noise?
    pub(crate) fn holds_behind(&mut self) -> bool {
        let mut rest = self.held();
        while let [_, behind @ ..] = rest {
            rest = behind;
            if let Candidate::Whole(size) = judge(rest) {
                let noise = self.held().len().wrapping_sub(rest.len());
                self.skip(noise);
                self.drop_front(noise);
                (self.done, self.missing) = (short(size), 0);
                return true;
            }
        }
        false
    }

    /// Discards the pending candidate, for example at the end of a file.
    ///
    /// Packets within it are not lost: call this until it returns `None`.
    ///
    /// ```
    /// let mut parser = mip_protocol::Parser::new();
    /// let mut bytes = &b"\x75\x65\x80\xFF\x75\x65\x01\x02\x02\x01\xE0\xC6"[..];
    /// assert_eq!(parser.next(&mut bytes), None); // the first header may be that of a long packet
    /// assert!(parser.flush().is_some());
    /// ```
    pub fn flush(&mut self) -> Option<Packet<'_>> {
        while !self.holds() {
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

    /// Searches for a packet. Returns its size, or 0, and how many bytes of the input are left. The
    /// packet is in the buffer if `done` is set; otherwise it ends where the searched bytes end.
    pub(crate) fn step(&mut self, given: &[u8]) -> (usize, usize) {
        let mut input = given;
        if self.done > 0 {
            self.drop_front(self.done.into());
            self.done = 0;
        }
        loop {
            if self.missing > 0 {
                input = self.fill(input);
                if self.missing > 0 {
                    return (0, input.len());
                }
            }
            let buffered = self.length > 0;
            let bytes = if buffered { self.held() } else { input };
            match judge(bytes) {
                Candidate::Whole(size) => {
                    if buffered {
                        self.done = short(size);
                        return (size, input.len());
                    }
                    return (size, input.len().wrapping_sub(size));
                }
                Candidate::Open(size) => {
                    let known = bytes.len();
                    if known == 0 {
                        return (0, 0);
                    }
                    if !buffered {
                        self.missing = short(known);
                        input = self.fill(input);
                    }
                    self.missing = short(size.wrapping_sub(known));
                }
                Candidate::Bad => {
                    let count = noise(bytes);
                    self.skip(count);
                    if buffered {
                        self.drop_front(count);
                        // The rest, which has just been copied, is found again where it was.
                        let left = usize::from(self.length);
                        let start = given.len().wrapping_sub(input.len()).checked_sub(left);
                        if let Some(start) = start {
                            input = behind(given, start);
                            self.length = 0;
                        }
                    } else {
                        input = behind(input, count);
                    }
                }
            }
        }
    }

    /// Removes the packet that was returned last. True if nothing else is held back.
    #[inline]
    pub(crate) fn is_empty(&mut self) -> bool {
        if self.length > 0 {
            if self.length != self.done {
                return false;
            }
            (self.length, self.done, self.missing) = (0, 0, 0);
        }
        true
    }

    /// Is the packet that was found last in the buffer?
    pub(crate) const fn is_done(&self) -> bool {
        self.done > 0
    }

    /// Returns the packet in the buffer that was found last.
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
        let held = self.buffer.get_mut(..self.length.into()).unwrap_or_default();
        let places = Cell::from_mut(held).as_slice_of_cells();
        let rest = places.get(count..).unwrap_or_default();
        places.iter().zip(rest).for_each(|(to, from)| to.set(from.get()));
        self.length = short(rest.len());
    }

    /// Stores the first bytes of a candidate of this size, if nothing is held back.
    #[cold] // rare, compared with whole packets
    fn hold(&mut self, bytes: &[u8], size: usize) {
        if bytes.is_empty() {
            return;
        }
        if let Some(places) = self.buffer.get_mut(..bytes.len()) {
            self.length = short(bytes.len());
            self.missing = short(size.wrapping_sub(bytes.len()));
            places.copy_from_slice(bytes);
        }
    }

    /// Adds the missing bytes. If they complete a packet, returns its size; the packet is at the
    /// front of the buffer, and nothing is held back any more. Otherwise returns 0, and the bytes
    /// are still missing.
    #[inline]
    fn complete(&mut self, bytes: &[u8]) -> usize {
        let start = usize::from(self.length);
        let size = start.wrapping_add(bytes.len());
        if let Some(places) = self.buffer.get_mut(start..size) {
            places.copy_from_slice(bytes);
            let (held, _) = self.buffer.split_at(size.min(MAX_PACKET));
            if size > HEADER && has_checksum(held) {
                (self.length, self.missing) = (0, 0);
                return size;
            }
        }
        0
    }

    /// Adds some of the missing bytes.
    #[inline]
    fn extend(&mut self, bytes: &[u8]) {
        let start = usize::from(self.length);
        if let ([byte], Some(place)) = (bytes, self.buffer.get_mut(start)) {
            *place = *byte;
            (self.length, self.missing) =
                (self.length.wrapping_add(1), self.missing.wrapping_sub(1));
        } else {
            self.fill(bytes);
        }
    }

    /// Adds the missing bytes, as far as present. Returns the bytes after them.
    fn fill<'i>(&mut self, input: &'i [u8]) -> &'i [u8] {
        let start = usize::from(self.length);
        let count = usize::from(self.missing).min(input.len());
        self.length = self.length.wrapping_add(short(count));
        self.missing = self.missing.wrapping_sub(short(count));
        let (head, tail) = input.split_at(count);
        copy(self.buffer.get_mut(start..).unwrap_or_default(), head);
        tail
    }
}

/// Copies bytes to the front.
#[inline]
pub(crate) fn copy(places: &mut [u8], bytes: &[u8]) {
    // On microcontrollers, `memcpy` may be larger than the parser.
    if HOST {
        if let Some(places) = places.get_mut(..bytes.len()) {
            places.copy_from_slice(bytes);
        }
        return;
    }
    for (place, byte) in places.iter_mut().zip(bytes) {
        *place = *byte;
    }
}

/// Converts a number of bytes in the buffer, which always fits.
const fn short(count: usize) -> u16 {
    count as u16
}

/// A chunk and the parser that searches it; from [`Parser::feed`].
///
/// It has no method that returns one packet, because a loop would feed the chunk again each time.
///
/// ```compile_fail
/// # let mut parser = mip_protocol::Parser::new();
/// # let chunk = b"\x75\x65\x01\x02\x02\x01\xE0\xC6";
/// while let Some(packet) = parser.feed(chunk).next() {}
/// ```
#[derive(Debug)]
#[must_use = "the chunk is searched only by `for_each` or `try_for_each`"]
pub struct Feed<'p, 'i> {
    parser: &'p mut Parser,
    chunk: &'i [u8],
}

impl Feed<'_, '_> {
    /// Calls a function with each packet of the chunk.
    #[inline]
    pub fn for_each(mut self, mut call: impl FnMut(Packet<'_>)) {
        while let Some(packet) = self.parser.next(&mut self.chunk) {
            call(packet);
        }
    }

    /// Calls a function with each packet of the chunk, until the first error.
    ///
    /// After an error, the rest of the chunk is not searched. If you need it, use [`Parser::next`].
    ///
    /// # Errors
    ///
    /// Returns the errors of the function.
    #[inline]
    pub fn try_for_each<E>(
        mut self,
        mut call: impl FnMut(Packet<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        while let Some(packet) = self.parser.next(&mut self.chunk) {
            call(packet)?;
        }
        Ok(())
    }
}
