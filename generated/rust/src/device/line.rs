//! Ports of a computer: serial ports, TCP connections, and logs.

use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};
use std::{borrow::ToOwned, boxed::Box, format, string::String};

use serialport::SerialPort;

use super::{closed, Device, DeviceError, Port};

/// A read without data returns after this time, so that commands can time out.
const READ: Duration = Duration::from_millis(10);
/// The time-out for connecting and for writing.
pub(super) const WRITE: Duration = Duration::from_secs(5);
/// The baud rate of a port whose address contains none.
pub(super) const USUAL: u32 = 115_200;
/// The pause between attempts to open a lost port.
pub(super) const PAUSE: Duration = Duration::from_millis(100);
/// A log's clock advances by this at its end, so that nothing waits for more.
const END: u32 = 1 << 30;

/// A serial port, a TCP connection or a log, opened by its address:
///
/// - `/dev/ttyACM0`, `COM3:460800`: a serial port, optionally with its baud rate;
/// - `192.168.1.20:9000`: a host and a port;
/// - `log.bin`: recorded bytes. A log accepts no commands. After its last packet,
///   [`Device::next_packet`](super::Device::next_packet) returns `None` at once.
///
/// The prefixes `serial:`, `tcp:` and `file:` state the kind.
pub struct Line {
    way: Way,
    place: String,
    /// The baud rate in the address, and that of the port, which a lost one does not tell.
    named: Option<u32>,
    baud: Option<u32>,
    start: Instant,
    /// The time of a log's clock.
    log_ms: u32,
    record: Record,
}

/// Where received bytes are copied to.
pub(super) type Record = Option<Box<dyn Write + Send>>;

/// Copies received bytes, and returns their number.
pub(super) fn recorded(record: &mut Record, bytes: &[u8], count: usize) -> io::Result<usize> {
    match record {
        Some(record) => record.write_all(bytes.get(..count).unwrap_or_default()).map(|()| count),
        None => Ok(count),
    }
}

enum Way {
    Serial(Box<dyn SerialPort>),
    Tcp(TcpStream),
    Log(File),
    /// It could not be opened again.
    Lost,
}

impl<const N: usize, const Q: usize> Device<Line, N, Q> {
    /// Opens the port again after a call has failed with [`DeviceError::Port`], trying every 100 ms
    /// for up to `within`. Data that has not been read yet is kept.
    ///
    /// The command that was waiting remains unanswered. The device may have restarted; then it
    /// sends nothing until you call `stream` again.
    ///
    /// ```no_run
    /// # fn example() -> Result<(), Box<dyn std::error::Error>> {
    /// use mip_protocol::device::{Device, DeviceError, Line};
    /// use std::time::Duration;
    ///
    /// let mut device = Device::new(Line::open("/dev/ttyACM0")?);
    /// if let Err(DeviceError::Port(_)) = device.next_packet(1000) {
    ///     device.reopen(Duration::from_secs(30))?; // it was unplugged
    /// }
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    ///
    /// The port cannot be opened.
    pub fn reopen(&mut self, within: Duration) -> Result<(), DeviceError<io::Error>> {
        self.core.restart();
        self.port.reopen(within).map_err(DeviceError::Port)
    }
}

impl Line {
    /// Opens the port. Nothing is sent.
    ///
    /// # Errors
    ///
    /// The port cannot be opened.
    pub fn open(place: &str) -> io::Result<Self> {
        let (way, named) = Self::way(place)?;
        Ok(Self {
            place: place.to_owned(),
            baud: matches!(way, Way::Serial(_)).then(|| named.unwrap_or(USUAL)),
            way,
            named,
            start: Instant::now(),
            log_ms: 0,
            record: None,
        })
    }

    fn way(place: &str) -> io::Result<(Way, Option<u32>)> {
        Self::opened(place).map_err(|error| named(place, &error))
    }

    fn opened(place: &str) -> io::Result<(Way, Option<u32>)> {
        Ok(match place.split_once(':') {
            Some(("serial", rest)) => serial(rest)?,
            Some(("tcp", rest)) => (Way::Tcp(connected(rest)?), None),
            Some(("file", path)) => (Way::Log(File::open(path)?), None),
            _ if std::path::Path::new(place).is_file() => (Way::Log(File::open(place)?), None),
            _ if is_host(place) => (Way::Tcp(connected(place)?), None),
            _ => serial(place)?,
        })
    }

    /// Opens a lost port again, at its last baud rate, trying every 100 ms for up to `within`.
    /// [`Device::reopen`] calls this.
    ///
    /// # Errors
    ///
    /// Returns the error of the last attempt.
    pub fn reopen(&mut self, within: Duration) -> io::Result<()> {
        let (began, rate) = (Instant::now(), self.baud());
        self.way = Way::Lost; // it is closed first
        loop {
            let opened = Self::way(&self.place).and_then(|(way, _)| {
                self.way = way;
                match rate {
                    Some(rate) if !self.set_baud(rate)? => Err(refused(rate)),
                    _ => Ok(()),
                }
            });
            let Err(error) = opened else { return Ok(()) };
            self.way = Way::Lost;
            if began.elapsed() >= within {
                return Err(error);
            }
            std::thread::sleep(PAUSE);
        }
    }

    /// Copies all bytes that are received from now on, for example to a file, which is then a log:
    /// `device.port_mut().record(File::create("log.bin")?)`. An error there is one of the port.
    ///
    /// ```no_run
    /// # fn example() -> Result<(), Box<dyn std::error::Error>> {
    /// use mip_protocol::device::{Device, Line};
    ///
    /// let mut device = Device::new(Line::open("192.168.1.20:9000")?);
    /// device.port_mut().record(std::fs::File::create("log.bin")?);
    /// # Ok(()) }
    /// ```
    pub fn record(&mut self, to: impl Write + Send + 'static) {
        self.record = Some(Box::new(to));
    }

    /// Returns the baud rate in the address.
    #[must_use]
    pub const fn named_baud(&self) -> Option<u32> {
        self.named
    }

    /// Is it a log, which accepts no commands?
    #[must_use]
    pub const fn is_log(&self) -> bool {
        matches!(self.way, Way::Log(_))
    }
}

impl core::fmt::Debug for Line {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match &self.way {
            Way::Serial(port) => write!(f, "Line(serial {:?})", port.name()),
            Way::Tcp(stream) => write!(f, "Line({stream:?})"),
            Way::Log(file) => write!(f, "Line({file:?})"),
            Way::Lost => f.write_str("Line(lost)"),
        }
    }
}

/// Adds the address to an error.
pub(super) fn named(place: &str, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{place}: {error}"))
}

/// The error of a port that is open again, but not at its last baud rate.
pub(super) fn refused(rate: u32) -> io::Error {
    io::Error::new(ErrorKind::Unsupported, format!("the port does not support {rate} baud"))
}

/// Is it a host and a port, and not a serial port and its baud rate?
pub(super) fn is_host(place: &str) -> bool {
    let Some((host, port)) = place.rsplit_once(':') else { return false };
    let is_com = host.get(..3).map_or(false, |name| name.eq_ignore_ascii_case("COM"))
        && host.len() > 3
        && host.bytes().skip(3).all(|byte| byte.is_ascii_digit());
    let is_serial = is_com || host.contains(['/', '\\']);
    !is_serial && !host.is_empty() && port.parse::<u16>().is_ok()
}

/// Returns the name of a serial port and its baud rate.
pub(super) fn serial_name(text: &str) -> (&str, Option<u32>) {
    let numbered = text.rsplit_once(':').and_then(|(name, rate)| Some((name, rate.parse().ok()?)));
    numbered.map_or((text, None), |(name, rate)| (name, Some(rate)))
}

fn serial(rest: &str) -> io::Result<(Way, Option<u32>)> {
    let (name, baud) = serial_name(rest);
    let port = serialport::new(name, baud.unwrap_or(USUAL)).timeout(READ).open()?;
    Ok((Way::Serial(port), baud))
}

fn connected(place: &str) -> io::Result<TcpStream> {
    let mut last = io::Error::new(ErrorKind::InvalidInput, "the host has no address");
    for address in std::net::ToSocketAddrs::to_socket_addrs(place)? {
        match TcpStream::connect_timeout(&address, WRITE) {
            Ok(stream) => {
                stream.set_nodelay(true)?;
                stream.set_read_timeout(Some(READ))?;
                stream.set_write_timeout(Some(WRITE))?;
                return Ok(stream);
            }
            Err(error) => last = error,
        }
    }
    Err(last)
}

/// Treats a time-out or an interrupt as no bytes; returns other errors.
fn none_yet(error: io::Error) -> io::Result<usize> {
    match error.kind() {
        ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted => Ok(0),
        _ => Err(error),
    }
}

impl Port for Line {
    type Error = io::Error;

    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = match &mut self.way {
            Way::Serial(port) => port.read(buffer).or_else(none_yet),
            Way::Tcp(stream) => match stream.read(buffer) {
                Ok(0) => Err(closed()),
                count => count.or_else(none_yet),
            },
            Way::Log(file) => {
                let count = file.read(buffer)?;
                if count == 0 {
                    self.log_ms = self.log_ms.wrapping_add(END);
                }
                Ok(count)
            }
            Way::Lost => Err(closed()),
        };
        recorded(&mut self.record, buffer, count?)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        match &mut self.way {
            // Not flushed, because that would wait until a pseudo-terminal is read, perhaps
            // forever.
            Way::Serial(port) => port.write_all(bytes),
            Way::Tcp(stream) => stream.write_all(bytes),
            Way::Log(_) => Err(io::Error::new(ErrorKind::Unsupported, "a log accepts no commands")),
            Way::Lost => Err(closed()),
        }
    }

    fn now_ms(&mut self) -> u32 {
        match self.way {
            Way::Log(_) => self.log_ms,
            _ => self.start.elapsed().as_millis() as u32,
        }
    }

    fn set_baud(&mut self, rate: u32) -> io::Result<bool> {
        let Way::Serial(port) = &mut self.way else { return Ok(false) };
        match port.set_baud_rate(rate).map_err(io::Error::from) {
            Ok(()) => {}
            Err(error) if error.kind() == ErrorKind::InvalidInput => return Ok(false),
            Err(error) => return Err(error),
        }
        port.clear(serialport::ClearBuffer::Input)?; // received at the old rate
        self.baud = Some(rate);
        Ok(true)
    }

    fn baud(&self) -> Option<u32> {
        self.baud
    }
}
