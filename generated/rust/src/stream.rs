//! Packets from files, sockets, serial ports and other sources.

use std::fmt;
use std::io::{self, Read};

use crate::error::DecodeError;
use crate::owned::PacketBuf;
use crate::packet::{FromPacket, Packet};
use crate::parser::{judge, Candidate, Parser};
use crate::time::{Time, Times};
use crate::timed::{next_fields, Timed};

/// Reads packets from a source.
///
/// As an iterator, it returns packets that own their bytes; [`PacketReader::next_packet`] returns
/// borrowed ones, and copies nothing.
///
/// ```
/// use mip_protocol::PacketReader;
///
/// let log: &[u8] = b"\x75\x65\x01\x02\x02\x01\xE0\xC6 and something else";
/// let mut packets = PacketReader::new(log);
/// for packet in packets.by_ref() {
///     let packet = packet?;
///     for field in &packet {
///         println!("{:?}", field?);
///     }
/// }
/// assert_eq!(packets.parser().skipped(), 19);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct PacketReader<R> {
    source: R,
    parser: Parser,
    chunk: [u8; 4096],
    start: usize,
    end: usize,
}

impl<R: fmt::Debug> fmt::Debug for PacketReader<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unread = self.end.saturating_sub(self.start);
        write!(f, "PacketReader({:?}, {:?}, {unread} unread)", self.source, self.parser)
    }
}

impl<R> PacketReader<R> {
    /// Creates a reader of a source, which need not be buffered.
    pub const fn new(source: R) -> Self {
        Self { source, parser: Parser::new(), chunk: [0; 4096], start: 0, end: 0 }
    }

    /// Borrows the parser, which counts the skipped bytes and those of an incomplete packet.
    pub const fn parser(&self) -> &Parser {
        &self.parser
    }

    /// Borrows the source.
    pub const fn get_ref(&self) -> &R {
        &self.source
    }

    /// Borrows the source, for example to send commands to a port.
    pub fn get_mut(&mut self) -> &mut R {
        &mut self.source
    }

    /// Returns the source. Bytes that were read but not yet returned are lost.
    pub fn into_inner(self) -> R {
        self.source
    }
}

impl<R: Read> PacketReader<R> {
    /// Returns the next packet, or `None` if the source has no more bytes: at the end of a file, or
    /// after the time-out of some ports.
    ///
    /// In this case and after an error, an incomplete packet is kept; call this again when there may
    /// be more bytes. One exception: if the source has no more bytes and a whole packet is inside the
    /// incomplete one, the outer header was noise, and the inner packet is returned.
    ///
    /// ```
    /// let log = &b"noise\x75\x65\x01\x02\x02\x01\xE0\xC6"[..];
    /// let mut reader = mip_protocol::PacketReader::new(log);
    /// while let Some(packet) = reader.next_packet()? {
    ///     assert_eq!(packet.set(), 0x01.into());
    /// }
    /// assert_eq!(reader.parser().skipped(), 5);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Returns the errors of the source, except [`Interrupted`](io::ErrorKind::Interrupted).
    pub fn next_packet(&mut self) -> io::Result<Option<Packet<'_>>> {
        loop {
            let rest = self.chunk.get(self.start..self.end).unwrap_or_default();
            if self.parser.is_empty() {
                if let Candidate::Whole(size) = judge(rest) {
                    let first = self.start;
                    self.start = first.saturating_add(size);
                    return Ok(self.chunk.get(first..self.start).map(Packet::trusted));
                }
            }
            let (size, left) = self.parser.step(rest);
            self.start = self.end.saturating_sub(left);
            if self.parser.is_done() {
                return Ok(Some(self.parser.packet()));
            }
            if size > 0 {
                let first = self.start.saturating_sub(size);
                return Ok(self.chunk.get(first..self.start).map(Packet::trusted));
            }
            match self.source.read(&mut self.chunk) {
                Ok(0) => break,
                Ok(count) => (self.start, self.end) = (0, count.min(self.chunk.len())),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(self.parser.look_behind())
    }
}

impl<R: Read> PacketReader<R> {
    /// Returns the fields `F` of the packets, with their times: a field, or a tuple of fields of one
    /// packet; see [`FromPacket`].
    ///
    /// ```no_run
    /// # #[cfg(feature = "sensor")]
    /// # fn example() -> std::io::Result<()> {
    /// use mip_protocol::{sensor::ScaledAccel, PacketReader};
    ///
    /// let mut log = PacketReader::new(std::fs::File::open("log.bin")?);
    /// for found in log.fields::<ScaledAccel>() {
    ///     let (time, accel) = found?;
    ///     println!("{:?}: {}", time.and_then(|time| time.utc()), accel.scaled_accel.x);
    /// }
    /// # Ok(()) }
    /// ```
    pub fn fields<F: FromPacket>(&mut self) -> Timed<&mut Self, F> {
        Timed::new(self, Times::new(), 0)
    }
}

/// A field that cannot be decoded is an error of the kind [`InvalidData`](io::ErrorKind::InvalidData).
impl<R: Read, F: FromPacket> Iterator for Timed<&mut PacketReader<R>, F> {
    type Item = io::Result<(Option<Time>, F)>;

    fn next(&mut self) -> Option<Self::Item> {
        next_fields!(self, self.source.next_packet(), invalid)
    }
}

fn invalid(error: DecodeError) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, error)
}

/// The packets up to the end of the source, or to the time-out of some ports.
impl<R: Read> Iterator for PacketReader<R> {
    type Item = io::Result<PacketBuf>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_packet().map(|packet| packet.map(PacketBuf::from)).transpose()
    }
}
