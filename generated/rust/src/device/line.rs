//! Ports of a computer: serial ports, TCP connections, and logs.

use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};
use std::{borrow::ToOwned, boxed::Box, format, string::String};

use serialport::SerialPort;

use super::{Device, DeviceError, Port};

/// A read without data returns after this time, so that commands can time out.
const READ: Duration = Duration::from_millis(10);
/// The time-out for connecting and for writing.
const WRITE: Duration = Duration::from_secs(5);
/// The baud rate of a port whose address contains none.
const USUAL: u32 = 115_200;
/// The pause between attempts to open a lost port.
const PAUSE: Duration = Duration::from_millis(100);
/// A log's clock advances by this at its end, so that nothing waits for more.
const END: u32 = 1 << 30;

/// A serial port, a TCP connection or a log, opened by its address:
///
/// - `serial:/dev/ttyACM0`, `serial:COM3:460800`: a serial port, optionally with its baud rate;
/// - `tcp:192.168.1.20:9000`: a host and a port;
/// - `file:log.bin`: recorded bytes. A log accepts no commands. After its last packet,
///   [`Device::next_packet`](super::Device::next_packet) returns `None` at once.
pub struct Line {
    way: Way,
    place: String,
    baud: Option<u32>,
    start: Instant,
    /// The time of a log's clock.
    log_ms: u32,
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
    /// The address is of no known kind ([`ErrorKind::InvalidInput`]), or the port cannot be opened.
    pub fn open(place: &str) -> io::Result<Self> {
        let (way, baud) = Self::way(place)?;
        Ok(Self { way, place: place.to_owned(), baud, start: Instant::now(), log_ms: 0 })
    }

    fn way(place: &str) -> io::Result<(Way, Option<u32>)> {
        let named = |error: io::Error| io::Error::new(error.kind(), format!("{place}: {error}"));
        Ok(match place.split_once(':') {
            Some(("serial", rest)) => serial(rest).map_err(named)?,
            Some(("tcp", rest)) => (Way::Tcp(connected(rest).map_err(named)?), None),
            Some(("file", path)) => (Way::Log(File::open(path).map_err(named)?), None),
            _ => {
                let known = "expected serial:NAME, serial:NAME:BAUD, tcp:HOST:PORT or file:PATH";
                return Err(io::Error::new(ErrorKind::InvalidInput, format!("{place}: {known}")));
            }
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
            match Self::way(&self.place) {
                Ok((way, _)) => {
                    self.way = way;
                    return rate.map_or(Ok(()), |rate| self.set_baud(rate).map(drop));
                }
                Err(error) if began.elapsed() >= within => return Err(error),
                Err(_) => std::thread::sleep(PAUSE),
            }
        }
    }

    /// Returns the baud rate in the address.
    #[must_use]
    pub const fn named_baud(&self) -> Option<u32> {
        self.baud
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

fn serial(rest: &str) -> io::Result<(Way, Option<u32>)> {
    let numbered = rest.rsplit_once(':').and_then(|(name, rate)| Some((name, rate.parse().ok()?)));
    let (name, baud) = numbered.map_or((rest, None), |(name, rate)| (name, Some(rate)));
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

fn closed() -> io::Error {
    io::Error::new(ErrorKind::UnexpectedEof, "the other end has closed the connection")
}

impl Port for Line {
    type Error = io::Error;

    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match &mut self.way {
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
        }
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
        Ok(true)
    }

    fn baud(&self) -> Option<u32> {
        match &self.way {
            Way::Serial(port) => port.baud_rate().ok(),
            _ => None,
        }
    }
}
