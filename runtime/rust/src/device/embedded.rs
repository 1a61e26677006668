//! Ports with the traits of `embedded-io`.

use core::fmt;

use embedded_io::{Error, ErrorKind, Read, ReadReady, Write};

use super::Port;
use crate::parser::behind;

/// A port over a driver with the traits of `embedded-io`, and a clock.
///
/// [`ReadReady`] is required because [`Read`] waits until bytes arrive, possibly forever. A read
/// that fails with [`Interrupted`](ErrorKind::Interrupted) or [`TimedOut`](ErrorKind::TimedOut)
/// counts as no data yet, and an interrupted write is repeated.
#[derive(Clone, Debug)]
pub struct EmbeddedPort<T, F> {
    io: T,
    now_ms: F,
}

impl<T, F> EmbeddedPort<T, F> {
    /// Creates a port from a driver and a function that counts milliseconds, which may wrap around.
    #[must_use]
    pub const fn new(io: T, now_ms: F) -> Self {
        Self { io, now_ms }
    }

    /// Borrows the driver.
    pub const fn get_ref(&self) -> &T {
        &self.io
    }

    /// Borrows the driver, for example to set its baud rate.
    pub fn get_mut(&mut self) -> &mut T {
        &mut self.io
    }
}

/// The error of an [`EmbeddedPort`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EmbeddedError<E> {
    /// The error of the driver.
    Driver(E),
    /// The driver accepts no bytes: its `write` returned 0.
    WriteZero,
}

impl<E: fmt::Display> fmt::Display for EmbeddedError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Driver(error) => error.fmt(f),
            Self::WriteZero => f.write_str("the driver accepts no bytes"),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for EmbeddedError<E> {}

/// Tries again after an interruption, which may hide that bytes have arrived; nothing has if an error
/// only means that it is to be tried later.
fn patiently<V: Default, E: Error>(
    mut once: impl FnMut() -> Result<V, E>,
) -> Result<V, EmbeddedError<E>> {
    let result = match once() {
        Err(error) if error.kind() == ErrorKind::Interrupted => once(),
        result => result,
    };
    result.or_else(|error| match error.kind() {
        ErrorKind::Interrupted | ErrorKind::TimedOut => Ok(V::default()),
        _ => Err(EmbeddedError::Driver(error)),
    })
}

impl<T: Read + ReadReady + Write, F: FnMut() -> u32> Port for EmbeddedPort<T, F> {
    type Error = EmbeddedError<T::Error>;

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Self::Error> {
        patiently(|| if self.io.read_ready()? { self.io.read(buffer) } else { Ok(0) })
    }

    // `write_all` would panic if the driver accepts no bytes.
    fn write(&mut self, mut bytes: &[u8]) -> Result<(), Self::Error> {
        while !bytes.is_empty() {
            match self.io.write(bytes) {
                Ok(0) => return Err(EmbeddedError::WriteZero),
                Ok(count) => bytes = behind(bytes, count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(EmbeddedError::Driver(error)),
            }
        }
        loop {
            match self.io.flush() {
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                done => return done.map_err(EmbeddedError::Driver),
            }
        }
    }

    fn waits(&mut self) -> Result<bool, Self::Error> {
        patiently(|| self.io.read_ready())
    }

    fn now_ms(&mut self) -> u32 {
        (self.now_ms)()
    }
}
