//! The tests of a device, with one that is awaited.

#[path = "../awaited.rs"]
mod awaited;
#[path = "../cases/device.rs"]
mod device;

use awaited::Device;

/// After each time-out, the port is read once more.
const SLACK: u32 = 20;

impl embedded_io_async::Error for device::Gone {
    fn kind(&self) -> embedded_io_async::ErrorKind {
        embedded_io_async::ErrorKind::BrokenPipe
    }
}
