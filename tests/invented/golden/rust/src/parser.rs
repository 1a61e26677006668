//! Finds packets in a stream of bytes.

use core::ops::Range;

use crate::packet::{checksum, Packet, MAX_PACKET};
use crate::protocol::SYNC;

/// Finds the packets in a stream that arrives in chunks of any size.
///
/// Garbage, other protocols, false syncs and broken packets never hide a packet: after a bad
/// candidate the search continues one byte after its sync. Nothing is allocated; only packets that
/// span chunks are copied.
///
/// ```
/// use mip_protocol::Parser;
///
/// let mut parser = Parser::new();
/// let mut chunk: &[u8] = b"noise\x75\x65\x01\x02\x02\x01\xE0\xC6";
/// while let Some(packet) = parser.next(&mut chunk) {
///     assert_eq!(packet.set(), 1);
/// }
/// assert_eq!(parser.skipped(), 5);
/// ```
#[derive(Clone, Debug)]
pub struct Parser {
    buffer: [u8; MAX_PACKET],
    start: usize,
    end: usize,
    given: usize,
    skipped: u64,
}

/// Where a packet is.
pub(crate) enum Found {
    Held(usize),
    InInput(Range<usize>),
}

/// What the bytes starting at a possible sync are.
enum Candidate {
    Whole(usize),
    Bad,
    /// Undecided until this many bytes are available.
    Open(usize),
}

fn judge(bytes: &[u8]) -> Candidate {
    let [first, second] = SYNC;
    match *bytes {
        [a, ..] if a != first => Candidate::Bad,
        [_, b, ..] if b != second => Candidate::Bad,
        [_, _, 0, ..] => Candidate::Bad,
        [_, _, _, length, ..] => {
            let end = usize::from(length).saturating_add(4);
            let size = end.saturating_add(2);
            match (bytes.get(..end), bytes.get(end..size)) {
                (Some(head), Some(sums)) if sums == checksum(head) => Candidate::Whole(size),
                (Some(_), Some(_)) => Candidate::Bad,
                _ => Candidate::Open(size),
            }
        }
        _ => Candidate::Open(4),
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
        Self { buffer: [0; MAX_PACKET], start: 0, end: 0, given: 0, skipped: 0 }
    }

    /// The number of bytes so far that belong to no packet, without those that are held back.
    #[must_use]
    pub const fn skipped(&self) -> u64 {
        self.skipped
    }

    /// The number of bytes that are held back until more arrive.
    #[must_use]
    pub const fn pending(&self) -> usize {
        self.end.saturating_sub(self.start).saturating_sub(self.given)
    }

    /// The next packet. Call it until it returns `None`; `input` is then empty.
    pub fn next<'p, 'i: 'p>(&'p mut self, input: &mut &'i [u8]) -> Option<Packet<'p>> {
        let bytes = *input;
        let found = self.step(input)?;
        self.packet(found, bytes)
    }

    /// Gives up the pending candidate only if a whole packet is behind its first bytes, and returns
    /// that packet: the candidate was noise then. Otherwise nothing changes.
    pub fn look_behind(&mut self) -> Option<Packet<'_>> {
        let nothing: &mut &[u8] = &mut [].as_slice();
        let mut found = self.step(nothing);
        if found.is_none() {
            let held = self.held();
            let whole =
                |at: &usize| matches!(held.get(*at..).map(judge), Some(Candidate::Whole(_)));
            let at = (1..held.len()).find(whole)?;
            self.skip(at);
            self.start = self.start.saturating_add(at);
            found = self.step(nothing);
        }
        self.packet(found?, &[])
    }

    /// Gives up the pending candidate, for instance at the end of a file.
    ///
    /// Packets inside it are not lost: call it until it returns `None`.
    pub fn flush(&mut self) -> Option<Packet<'_>> {
        let found = self.flush_step()?;
        self.packet(found, &[])
    }

    /// Searches for a packet and removes the searched bytes from the front of the input.
    pub(crate) fn step(&mut self, input: &mut &[u8]) -> Option<Found> {
        let whole = input.len();
        self.release();
        while self.start < self.end {
            match judge(self.held()) {
                Candidate::Whole(size) => return Some(self.give(size)),
                Candidate::Bad => self.drop_candidate(),
                Candidate::Open(size) => {
                    if !self.fill(size, input) {
                        return None;
                    }
                }
            }
        }
        loop {
            let noise = input.iter().position(|b| *b == SYNC[0]).unwrap_or(input.len());
            self.skip(noise);
            *input = input.get(noise..).unwrap_or_default();
            match judge(input) {
                Candidate::Whole(size) => {
                    let start = whole.saturating_sub(input.len());
                    *input = input.get(size..).unwrap_or_default();
                    return Some(Found::InInput(start..start.saturating_add(size)));
                }
                Candidate::Bad => {
                    self.skip(1);
                    *input = input.get(1..).unwrap_or_default();
                }
                Candidate::Open(_) => {
                    self.fill(input.len(), input);
                    return None;
                }
            }
        }
    }

    pub(crate) fn flush_step(&mut self) -> Option<Found> {
        self.release();
        while self.start < self.end {
            if let Candidate::Whole(size) = judge(self.held()) {
                return Some(self.give(size));
            }
            self.drop_candidate();
        }
        None
    }

    /// The packet that a step has found in the input.
    pub(crate) fn packet<'a>(&'a self, found: Found, input: &'a [u8]) -> Option<Packet<'a>> {
        match found {
            Found::Held(size) => self.held().get(..size),
            Found::InInput(range) => input.get(range),
        }
        .map(Packet::trusted)
    }

    fn held(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    fn skip(&mut self, count: usize) {
        self.skipped = self.skipped.saturating_add(u64::try_from(count).unwrap_or(u64::MAX));
    }

    fn give(&mut self, size: usize) -> Found {
        self.given = size;
        Found::Held(size)
    }

    /// Drops the packet that was returned last.
    fn release(&mut self) {
        self.start = self.start.saturating_add(self.given).min(self.end);
        self.given = 0;
        if self.start == self.end {
            (self.start, self.end) = (0, 0);
        }
    }

    /// Continues after the candidate's sync, where the next may start.
    fn drop_candidate(&mut self) {
        let behind = self.held().iter().skip(1).position(|b| *b == SYNC[0]);
        let count = behind.map_or(self.held().len(), |at| at.saturating_add(1));
        self.skip(count);
        self.start = self.start.saturating_add(count);
        self.release();
    }

    /// Takes input until `size` bytes are held. Is that reached?
    fn fill(&mut self, size: usize, input: &mut &[u8]) -> bool {
        if self.start.saturating_add(size) > self.buffer.len() {
            self.buffer.rotate_left(self.start.min(MAX_PACKET));
            (self.start, self.end) = (0, self.end.saturating_sub(self.start));
        }
        let wanted = size.saturating_sub(self.end.saturating_sub(self.start));
        let count = wanted.min(input.len());
        let (head, tail) = input.split_at(count);
        let free = self.buffer.get_mut(self.end..).and_then(|free| free.get_mut(..count));
        if let Some(free) = free {
            free.copy_from_slice(head);
            self.end = self.end.saturating_add(count);
        }
        *input = tail;
        count == wanted
    }
}
