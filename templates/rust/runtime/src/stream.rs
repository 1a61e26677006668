//! Packets from files, sockets, serial ports and other sources.

use std::io::{self, Read};

use crate::packet::Packet;
use crate::parser::Parser;

/// Reads packets until the end.
///
/// ```
/// use mip_protocol::PacketReader;
///
/// let log: &[u8] = b"\x75\x65\x01\x02\x02\x01\xE0\xC6 and something else";
/// let mut packets = PacketReader::new(log);
/// while let Some(packet) = packets.next_packet()? {
///     println!("{packet:?}");
/// }
/// assert_eq!(packets.parser().skipped(), 19);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct PacketReader<R> {
    source: R,
    parser: Parser,
    chunk: [u8; 4096],
    start: usize,
    end: usize,
}

impl<R: Read> PacketReader<R> {
    /// Reads from a source, which need not be buffered.
    pub fn new(source: R) -> Self {
        let parser = Parser::new();
        Self { source, parser, chunk: [0; 4096], start: 0, end: 0 }
    }

    /// The parser, which counts the skipped bytes.
    pub const fn parser(&self) -> &Parser {
        &self.parser
    }

    /// The next packet, or `None` at the end.
    ///
    /// # Errors
    ///
    /// The errors of the source; after a time-out, for instance, it can be called again.
    pub fn next_packet(&mut self) -> io::Result<Option<Packet<'_>>> {
        loop {
            let mut rest = self.chunk.get(self.start..self.end).unwrap_or_default();
            if let Some(found) = self.parser.step(&mut rest) {
                let left = rest.len();
                let chunk = self.chunk.get(self.start..self.end).unwrap_or_default();
                self.start = self.end.saturating_sub(left);
                return Ok(self.parser.packet(found, chunk));
            }
            (self.start, self.end) = (0, 0);
            match self.source.read(&mut self.chunk) {
                Ok(0) => break,
                Ok(count) => self.end = count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(self.parser.flush())
    }
}
