//! Asynchronous ports of a computer, with `tokio`.

use std::io;
use std::pin::pin;
use std::string::String;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use std::{borrow::ToOwned, boxed::Box};

use tokio::io::{
    empty, split, AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt, Empty, ReadHalf, WriteHalf,
};
use tokio::net::TcpStream;
use tokio::sync::{Mutex as AsyncMutex, Notify};
use tokio::time::{sleep, timeout, Instant, Sleep};
use tokio_serial::{SerialPort as _, SerialPortBuilderExt, SerialStream};

use super::line::{is_host, named, recorded, refused, serial_name, Record, PAUSE, USUAL, WRITE};
use super::{is_over, AsyncDevice, Core, DeviceError, BACKLOG, CHUNK};
use crate::client::response;
use crate::field::Command;
use crate::owned::PacketBuf;
use crate::packet::FromPacket;
use crate::time::Time;
use crate::timed::Timed;

/// A device at a port that [`AsyncLine`] has opened.
pub type TokioDevice = AsyncDevice<AsyncLine, fn(u32) -> Sleep>;

/// A serial port or a TCP connection, opened by its address; for runtimes of `tokio`. The addresses
/// are those of [`Line`](super::Line), without logs, which need no waiting.
pub struct AsyncLine {
    io: Box<dyn Io>,
    place: String,
    /// The baud rate in the address.
    named: Option<u32>,
    record: Record,
}

trait Io: AsyncRead + AsyncWrite + Unpin + Send {
    /// Changes the baud rate, and discards what was received at the old one.
    fn set_baud(&mut self, rate: u32) -> bool {
        let _ = rate;
        false
    }

    fn baud(&self) -> Option<u32> {
        None
    }
}

impl Io for TcpStream {}

/// A lost port, which is closed.
impl Io for Empty {}

impl Io for SerialStream {
    fn set_baud(&mut self, rate: u32) -> bool {
        self.set_baud_rate(rate).is_ok() && self.clear(tokio_serial::ClearBuffer::Input).is_ok()
    }

    fn baud(&self) -> Option<u32> {
        self.baud_rate().ok()
    }
}

impl AsyncLine {
    /// Opens the port. Nothing is sent.
    ///
    /// # Errors
    ///
    /// The port cannot be opened.
    pub async fn open(place: &str) -> io::Result<Self> {
        let (io, named) = Self::io(place).await.map_err(|error| named(place, &error))?;
        Ok(Self { io, place: place.to_owned(), named, record: None })
    }

    async fn io(place: &str) -> io::Result<(Box<dyn Io>, Option<u32>)> {
        let address = place.strip_prefix("tcp:");
        if let Some(address) = address.or_else(|| is_host(place).then_some(place)) {
            let stream = timeout(WRITE, TcpStream::connect(address)).await??;
            stream.set_nodelay(true)?;
            return Ok((Box::new(stream), None));
        }
        let (name, baud) = serial_name(place.strip_prefix("serial:").unwrap_or(place));
        let port = tokio_serial::new(name, baud.unwrap_or(USUAL)).open_native_async()?;
        Ok((Box::new(port), baud))
    }

    /// Copies all bytes that are received from now on, for example to a file; see
    /// [`Line::record`](super::Line::record). The writer must not block for long.
    pub fn record(&mut self, to: impl io::Write + Send + 'static) {
        self.record = Some(Box::new(to));
    }

    /// Returns the baud rate in the address.
    #[must_use]
    pub const fn named_baud(&self) -> Option<u32> {
        self.named
    }
}

impl core::fmt::Debug for AsyncLine {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "AsyncLine({})", self.place)
    }
}

impl embedded_io_async::ErrorType for AsyncLine {
    type Error = io::Error;
}

impl embedded_io_async::Read for AsyncLine {
    async fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.io.read(buffer).await?;
        recorded(&mut self.record, buffer, count)
    }
}

impl embedded_io_async::Write for AsyncLine {
    async fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.io.write(bytes).await
    }

    /// Does nothing, because it would wait until a pseudo-terminal is read, perhaps forever.
    async fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl TokioDevice {
    /// Creates a device at a port; nothing is sent.
    #[must_use]
    pub fn at(line: AsyncLine) -> Self {
        let rate = line.io.baud();
        let sleep = |ms: u32| sleep(Duration::from_millis(ms.into()));
        let device = Self::new(line, sleep as fn(u32) -> Sleep);
        match rate {
            Some(rate) => device.with_baud(rate, |line, rate| line.io.set_baud(rate)),
            None => device,
        }
    }

    /// Opens the port again after a call has failed with [`DeviceError::Port`] or
    /// [`DeviceError::Closed`], at its last baud rate, trying every 100 ms for up to `within`. Data
    /// that has not been read yet is kept.
    ///
    /// The command that was waiting remains unanswered. The device may have restarted; then it
    /// sends nothing until you call `stream` again.
    ///
    /// # Errors
    ///
    /// Returns the error of the last attempt.
    pub async fn reopen(&mut self, within: Duration) -> Result<(), DeviceError<io::Error>> {
        let (began, rate) = (Instant::now(), self.baud());
        self.core.restart();
        self.port.io = Box::new(empty()); // it is closed first
        loop {
            let opened = AsyncLine::io(&self.port.place).await;
            match opened.and_then(|(mut io, _)| match rate {
                Some(rate) if !io.set_baud(rate) => Err(refused(rate)),
                _ => Ok(io),
            }) {
                Ok(io) => {
                    self.port.io = io;
                    return Ok(());
                }
                Err(error) if began.elapsed() >= within => return Err(DeviceError::Port(error)),
                Err(_) => sleep(PAUSE).await,
            }
        }
    }

    /// Splits the device into a part that sends commands and one that receives data, for two tasks.
    /// Replies arrive only while the second one reads.
    ///
    /// ```no_run
    /// # #[cfg(all(feature = "base", feature = "mip_3dm"))]
    /// # async fn example() -> Result<(), Box<dyn std::error::Error>> {
    /// let device = mip_protocol::open_async("/dev/ttyACM0").await?;
    /// let (commands, mut data) = device.split();
    /// let reader = tokio::spawn(async move {
    ///     while let Ok(Some(packet)) = data.next_packet(1000).await {
    ///         println!("{packet:?}");
    ///     }
    /// });
    /// commands.request(&mip_protocol::base::Resume::new()).await?;
    /// reader.await?;
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn split(self) -> (CommandHalf, DataHalf) {
        let (read, write) = split(self.port.io);
        let (core, port, start) = (Mutex::new(self.core), AsyncMutex::new(write), Instant::now());
        let shared = Arc::new(Shared { core, port, arrived: Notify::new(), start });
        (
            CommandHalf { shared: shared.clone() },
            DataHalf { shared, port: read, record: self.port.record },
        )
    }
}

struct Shared {
    core: Mutex<Core<8, 4096>>,
    port: AsyncMutex<WriteHalf<Box<dyn Io>>>,
    arrived: Notify,
    start: Instant,
}

impl Shared {
    fn core(&self) -> MutexGuard<'_, Core<8, 4096>> {
        self.core.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The part of a device that sends commands; from [`TokioDevice::split`]. Clones share it.
#[derive(Clone)]
pub struct CommandHalf {
    shared: Arc<Shared>,
}

impl CommandHalf {
    /// Writes bytes that are not commands, such as RTCM corrections. Waits until no command is being
    /// sent or answered.
    ///
    /// # Errors
    ///
    /// The port fails.
    pub async fn write(&self, bytes: &[u8]) -> Result<(), DeviceError<io::Error>> {
        let mut port = self.shared.port.lock().await;
        port.write_all(bytes).await.map_err(DeviceError::Port)
    }

    /// Sends a command, waits until the device has carried it out, and returns its response. A
    /// command of another task waits until then.
    ///
    /// Unlike [`AsyncDevice::request`], this does not first take in what has arrived, which only the
    /// other half reads. On a line where replies can come twice or out of order, such as UDP, such a
    /// reply can therefore be taken for that of the next command of the same type.
    ///
    /// Dropping the future cancels the command in the client, but not in the device, which may carry
    /// it out. Its reply answers no later command, because a barrier precedes the next one. If the
    /// port was still writing, only a part may have been sent.
    ///
    /// # Errors
    ///
    /// The command cannot be sent, is rejected or not answered, or the port fails.
    pub async fn request<C: Command>(
        &self,
        command: &C,
    ) -> Result<C::Response, DeviceError<io::Error>> {
        let Shared { port, arrived, start, .. } = &*self.shared;
        let mut port = port.lock().await;
        let (ticket, bytes) = {
            let client = &mut self.shared.core().client;
            client.clear();
            let barrier = client.barrier().map(|packet| packet.bytes().to_vec());
            let mut bytes = barrier.unwrap_or_default();
            let (ticket, packet) = client.send_any(command, start.elapsed().as_millis() as u32)?;
            bytes.extend_from_slice(packet.bytes());
            (ticket, bytes)
        };
        port.write_all(&bytes).await.map_err(DeviceError::Port)?;
        loop {
            let mut next = pin!(arrived.notified());
            next.as_mut().enable();
            let deadline = self.shared.core().client.deadline();
            let Some(deadline) = deadline else {
                return Ok(response::<C>(self.shared.core().client.take_reply(ticket, command)?)?);
            };
            let left = deadline.wrapping_sub(start.elapsed().as_millis() as u32);
            let left = if left > u32::MAX >> 1 { 0 } else { left };
            if timeout(Duration::from_millis(left.into()), next).await.is_err() {
                self.shared.core().tick(deadline);
            }
        }
    }
}

/// The part of a device that receives data; from [`TokioDevice::split`].
pub struct DataHalf {
    shared: Arc<Shared>,
    port: ReadHalf<Box<dyn Io>>,
    record: Record,
}

impl DataHalf {
    /// Returns the next packet with data, or `None` if none arrives within this number of
    /// milliseconds.
    ///
    /// # Errors
    ///
    /// The port fails.
    pub async fn next_packet(
        &mut self,
        wait_ms: u32,
    ) -> Result<Option<PacketBuf>, DeviceError<io::Error>> {
        let (began, wait) = (Instant::now(), Duration::from_millis(wait_ms.into()));
        let mut backlog = BACKLOG;
        loop {
            if let Some(packet) = self.shared.core().data.pop() {
                return Ok(Some(packet.into()));
            }
            let mut chunk = [0; CHUNK];
            let left = wait.saturating_sub(began.elapsed());
            let count = timeout(left, self.port.read(&mut chunk)).await;
            let over = is_over(left.is_zero() || count.is_err(), count.is_ok(), &mut backlog);
            match count {
                Err(_) => {}
                Ok(Ok(0)) => return Err(DeviceError::Closed),
                Ok(count) => {
                    let count = count.and_then(|n| recorded(&mut self.record, &chunk, n));
                    let count = count.map_err(DeviceError::Port)?;
                    self.shared.core().arrived(chunk.get(..count).unwrap_or_default());
                    self.shared.arrived.notify_waiters();
                }
            }
            if over {
                let mut core = self.shared.core();
                core.look_behind();
                return Ok(core.data.pop().map(PacketBuf::from));
            }
        }
    }

    /// Returns the fields `F` of the packets that [`DataHalf::next_packet`] would return, with their
    /// times; see [`AsyncDevice::fields`].
    pub fn fields<F: FromPacket>(&mut self, wait_ms: u32) -> Timed<&mut Self, F> {
        let times = self.shared.core().times();
        Timed::new(self, times, wait_ms)
    }
}

impl<F: FromPacket> Timed<&mut DataHalf, F> {
    /// Returns the next fields, and the time of their packet; `None` if no packet arrives in time.
    #[allow(clippy::should_implement_trait)] // it is asynchronous
    pub async fn next(&mut self) -> Option<Result<(Option<Time>, F), DeviceError<io::Error>>> {
        loop {
            let packet = match self.source.next_packet(self.wait_ms).await {
                Ok(packet) => packet?,
                Err(error) => return Some(Err(error)),
            };
            if let Some(found) = self.reader.read(&packet.packet()) {
                return Some(found.map_err(DeviceError::Data));
            }
        }
    }
}

impl core::fmt::Debug for CommandHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("CommandHalf")
    }
}

impl core::fmt::Debug for DataHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("DataHalf")
    }
}
