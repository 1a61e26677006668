//! Ports of the standard library.

use std::io::{self, ErrorKind, Read, Write};
use std::time::{Duration, Instant};

use super::Port;

/// A port over anything that reads and writes, with the clock of the system.
///
/// A read without data may wait or not, and may return 0 or an error: of the kinds
/// [`TimedOut`](ErrorKind::TimedOut), [`WouldBlock`](ErrorKind::WouldBlock) or
/// [`Interrupted`](ErrorKind::Interrupted). It must return at some point, because only then can a
/// command time out: set a time-out of the port, for example 10 ms. Writes must wait.
///
/// Because 0 may mean that nothing has arrived yet, it is not an error: with a TCP connection that the
/// other side has closed, commands time out, and [`next_packet`](super::Device::next_packet) returns
/// `None`, until a write fails. Where it matters, write a [`Port`] that returns an error for 0.
#[derive(Clone, Debug)]
pub struct StdPort<T> {
    io: T,
    start: Instant,
}

impl<T> StdPort<T> {
    /// A port, for example of the crate `serialport`.
    #[must_use]
    pub fn new(io: T) -> Self {
        Self { io, start: Instant::now() }
    }

    /// The object that reads and writes.
    pub const fn get_ref(&self) -> &T {
        &self.io
    }

    /// The object that reads and writes, for example to set its baud rate.
    pub fn get_mut(&mut self) -> &mut T {
        &mut self.io
    }

    /// The object that reads and writes.
    pub fn into_inner(self) -> T {
        self.io
    }
}

impl<T: Read + Write> Port for StdPort<T> {
    type Error = io::Error;

    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let interrupted = |error: &io::Error| error.kind() == ErrorKind::Interrupted;
        let count = match self.io.read(buffer) {
            Err(error) if interrupted(&error) => self.io.read(buffer), // there may be more
            count => count,
        };
        match count {
            Ok(0) => {}
            Ok(count) => return Ok(count),
            Err(error) => match error.kind() {
                ErrorKind::TimedOut | ErrorKind::Interrupted => return Ok(0),
                ErrorKind::WouldBlock => {}
                _ => return Err(error),
            },
        }
        // It may not have waited at all.
        std::thread::sleep(Duration::from_millis(1));
        Ok(0)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.io.write_all(bytes)?;
        self.io.flush()
    }

    fn now_ms(&mut self) -> u32 {
        self.start.elapsed().as_millis() as u32
    }
}
