//! Ports that use the traits of the standard library.

use std::io::{self, ErrorKind, Read, Write};
use std::time::{Duration, Instant};

use super::Port;

/// A port over anything that reads and writes, with the system's clock.
///
/// A read without data may wait or return at once, with an error of the kind
/// [`TimedOut`](ErrorKind::TimedOut), [`WouldBlock`](ErrorKind::WouldBlock) or
/// [`Interrupted`](ErrorKind::Interrupted). Commands can time out only when it returns, so set a
/// time-out of the port, for example 10 ms. Writes must block.
///
/// A read of 0 bytes means that the other end has closed the connection: the error is
/// [`UnexpectedEof`](ErrorKind::UnexpectedEof).
#[derive(Clone, Debug)]
pub struct StdPort<T> {
    io: T,
    start: Instant,
}

impl<T> StdPort<T> {
    /// Creates a port, for example from one of the crate `serialport`.
    ///
    /// ```no_run
    /// use mip_protocol::device::{Device, StdPort};
    ///
    /// let stream = std::net::TcpStream::connect("192.168.1.20:9000")?;
    /// stream.set_read_timeout(Some(std::time::Duration::from_millis(10)))?;
    /// let device = Device::new(StdPort::new(stream));
    /// # let _ = device;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn new(io: T) -> Self {
        Self { io, start: Instant::now() }
    }

    /// Borrows the object that reads and writes.
    pub const fn get_ref(&self) -> &T {
        &self.io
    }

    /// Borrows the object that reads and writes, for example to set its baud rate.
    pub fn get_mut(&mut self) -> &mut T {
        &mut self.io
    }

    /// Returns the object that reads and writes.
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
            Ok(0) => return Err(super::closed()),
            Ok(count) => return Ok(count),
            Err(error) => match error.kind() {
                ErrorKind::TimedOut | ErrorKind::Interrupted => return Ok(0),
                ErrorKind::WouldBlock => {}
                _ => return Err(error),
            },
        }
        // The read may have returned without waiting.
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
