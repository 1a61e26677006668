//! Ports of `embedded-io`.

use embedded_io::{Read, ReadReady, Write};

use super::Port;

/// A port over a driver with the traits of `embedded-io`, and a clock.
///
/// [`ReadReady`] is needed because [`Read`] waits until bytes arrive, possibly forever.
#[derive(Clone, Debug)]
pub struct EmbeddedPort<T, F> {
    io: T,
    now_ms: F,
}

impl<T, F> EmbeddedPort<T, F> {
    /// A port, and a function that counts milliseconds, and may wrap around.
    #[must_use]
    pub const fn new(io: T, now_ms: F) -> Self {
        Self { io, now_ms }
    }

    /// The driver.
    pub const fn get_ref(&self) -> &T {
        &self.io
    }

    /// The driver, for example to set its baud rate.
    pub fn get_mut(&mut self) -> &mut T {
        &mut self.io
    }
}

impl<T: Read + ReadReady + Write, F: FnMut() -> u32> Port for EmbeddedPort<T, F> {
    type Error = T::Error;

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, T::Error> {
        if self.io.read_ready()? {
            self.io.read(buffer)
        } else {
            Ok(0)
        }
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), T::Error> {
        self.io.write_all(bytes)?;
        self.io.flush()
    }

    fn now_ms(&mut self) -> u32 {
        (self.now_ms)()
    }
}
