//! A serial port, a pseudo-terminal or a TCP connection.
//!
//! A thread reads, because files have no time-out. It holds the port until the other end closes it
//! or the driver ends. The standard library cannot set a terminal up: it must be raw already.

use std::fs::OpenOptions;
use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::mpsc::{channel, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

pub struct Port {
    writer: Box<dyn Write>,
    connection: Option<TcpStream>,
    pieces: Receiver<Vec<u8>>,
    start: Instant,
    pub closed: bool,
}

impl Port {
    /// `name` is the path of a terminal, or HOST:PORT.
    pub fn open(name: &str) -> io::Result<Self> {
        let (sender, pieces) = channel();
        let start = Instant::now();
        if name.contains(':') {
            let stream = TcpStream::connect(name)?;
            pump(stream.try_clone()?, sender);
            let connection = Some(stream.try_clone()?);
            return Ok(Self { writer: Box::new(stream), connection, pieces, start, closed: false });
        }
        let file = OpenOptions::new().read(true).write(true).open(name)?;
        pump(file.try_clone()?, sender);
        Ok(Self { writer: Box::new(file), connection: None, pieces, start, closed: false })
    }

    pub fn milliseconds(&self) -> u32 {
        self.start.elapsed().as_millis() as u32
    }

    pub fn write(&mut self, data: &[u8]) {
        self.closed |= self.writer.write_all(data).is_err();
    }

    /// Reads what has arrived, waiting at most that long; nothing also if the port is closed.
    pub fn read(&mut self, longest: Duration) -> Vec<u8> {
        match self.pieces.recv_timeout(longest) {
            Ok(data) => data,
            Err(RecvTimeoutError::Timeout) => Vec::new(),
            Err(RecvTimeoutError::Disconnected) => {
                if self.closed {
                    thread::sleep(longest);
                }
                self.closed = true;
                Vec::new()
            }
        }
    }
}

impl Drop for Port {
    fn drop(&mut self) {
        if let Some(connection) = &self.connection {
            let _ = connection.shutdown(Shutdown::Both);
        }
    }
}

fn pump(mut from: impl Read + Send + 'static, to: Sender<Vec<u8>>) {
    thread::spawn(move || {
        let mut buffer = [0; 4096];
        while let Ok(size @ 1..) = from.read(&mut buffer) {
            if to.send(buffer[..size].to_vec()).is_err() {
                break;
            }
        }
    });
}
