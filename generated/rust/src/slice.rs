//! Finds packets in a slice of bytes.

use core::iter::FusedIterator;

use crate::packet::{FromPacket, Packet};
use crate::parser::{behind, judge, noise, Candidate};
use crate::time::Times;
use crate::timed::Timed;

/// Iterates over the packets in these bytes, for example of a log that was read as a whole.
///
/// They are the packets that a [`Parser`](crate::Parser) would find, with a
/// [`flush`](crate::Parser::flush) at the end. They borrow the bytes; nothing is copied.
///
/// ```
/// use mip_protocol::{packets, Packet};
///
/// let log = b"noise\x75\x65\x01\x02\x02\x01\xE0\xC6\x75\x65\x01\x02\x02";
/// let mut found = packets(log);
/// let all: Vec<Packet<'_>> = found.by_ref().collect();
/// assert_eq!(all[0].bytes(), &log[5..13]);
/// assert_eq!((all.len(), found.skipped(), found.remainder()), (1, 5, &log[13..]));
/// ```
pub const fn packets(bytes: &[u8]) -> Packets<'_> {
    Packets { rest: bytes, open: &[], skipped: 0 }
}

/// The packets in a slice; from [`packets`].
#[derive(Clone, Debug)]
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct Packets<'a> {
    rest: &'a [u8],
    /// The bytes from the first incomplete candidate on, unless a packet was found after it.
    open: &'a [u8],
    skipped: usize,
}

impl<'a> Packets<'a> {
    /// Returns the fields `F` of the packets, with their times: a field, or a tuple of fields of one
    /// packet; see [`FromPacket`].
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] {
    /// use mip_protocol::{packets, sensor::{ScaledAccel, ScaledGyro}};
    ///
    /// # let log = b"";
    /// for found in packets(log).fields::<(ScaledAccel, Option<ScaledGyro>)>() {
    ///     let (time, (accel, gyro)) = found.unwrap();
    ///     println!("{time:?}: {accel:?} {gyro:?}");
    /// }
    /// # }
    /// ```
    #[inline]
    pub fn fields<F: FromPacket>(self) -> Timed<Self, F> {
        Timed::new(self, Times::new(), 0)
    }

    /// Returns the number of bytes so far that are not part of a packet, without the remainder.
    #[must_use]
    pub const fn skipped(&self) -> usize {
        self.skipped
    }

    /// Returns the bytes that have not been searched yet; at the end, those of an incomplete
    /// packet.
    #[must_use]
    pub const fn remainder(&self) -> &'a [u8] {
        if self.open.is_empty() {
            self.rest
        } else {
            self.open
        }
    }
}

impl<'a> Iterator for Packets<'a> {
    type Item = Packet<'a>;

    #[inline]
    fn next(&mut self) -> Option<Packet<'a>> {
        // The usual case first: a packet is next.
        if let Candidate::Whole(size) = judge(self.rest) {
            let (packet, rest) = self.rest.split_at(size.min(self.rest.len()));
            self.rest = rest;
            return Some(Packet::trusted(packet));
        }
        self.search()
    }
}

impl<'a> Packets<'a> {
    /// Searches for a packet after the front.
    fn search(&mut self) -> Option<Packet<'a>> {
        let (mut rest, given) = (self.rest, self.rest.len());
        let mut open: &[u8] = &[];
        while !rest.is_empty() {
            match judge(rest) {
                Candidate::Whole(size) => {
                    let (packet, behind) = rest.split_at(size.min(rest.len()));
                    self.skipped = self.skipped.wrapping_add(given.wrapping_sub(rest.len()));
                    self.rest = behind;
                    return Some(Packet::trusted(packet));
                }
                Candidate::Open(_) if open.is_empty() => open = rest,
                _ => {}
            }
            rest = behind(rest, noise(rest));
        }
        if given > 0 {
            self.skipped = self.skipped.wrapping_add(given.wrapping_sub(open.len()));
            (self.rest, self.open) = (&[], open);
        }
        None
    }
}

impl FusedIterator for Packets<'_> {}
