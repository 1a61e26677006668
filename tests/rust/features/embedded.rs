//! What only ports of `embedded-io` and `embedded-io-async` can do.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::convert::Infallible;
use std::future::{poll_fn, Future};
use std::pin::pin;
use std::rc::Rc;
use std::sync::Arc;
use std::task::{Context, Poll, Wake, Waker};

use embedded_io::ErrorKind;
use mip_protocol::device::{AsyncDevice, Device, DeviceError, EmbeddedError, EmbeddedPort};
use mip_protocol::protocol::{AckCode, Acknowledge};
use mip_protocol::types::Vector3f;
use mip_protocol::{measurements, tools, Client, CommandError, OneSet, PacketBuilder, Reason};

/// A line on which each packet is answered, byte by byte; while nothing arrives, time goes on.
#[derive(Default)]
struct Line {
    replies: VecDeque<Vec<u8>>,
    coming: VecDeque<u8>,
    now: u32,
    closed: bool,
    /// Noise arrives without end.
    flooded: bool,
}

/// The answer to a packet of pings, mostly one; several are a barrier.
fn pong(pings: &[u8]) -> Vec<u8> {
    let mut answer = ack(1, AckCode::OK);
    let commands = pings.get(3).map_or(1, |size| size / 2); // the rest of one
    (1..commands).for_each(|_| answer.push_raw(0xF1, &[1, 0]).unwrap());
    answer.bytes().to_vec()
}

#[derive(Clone, Default)]
struct Uart(Rc<RefCell<Line>>);

impl Uart {
    fn answering(replies: &[Vec<u8>]) -> Self {
        let uart = Self::default();
        uart.0.borrow_mut().replies = replies.iter().cloned().collect();
        uart
    }

    fn take(&self, buffer: &mut [u8]) -> Option<usize> {
        let mut line = self.0.borrow_mut();
        if line.flooded {
            line.now += 1;
            buffer[0] = 0;
            return Some(1);
        }
        match line.coming.pop_front() {
            Some(byte) => buffer[0] = byte,
            None if line.closed => return Some(0),
            None => return None,
        }
        Some(1)
    }

    fn put(&self, bytes: &[u8]) -> usize {
        let mut line = self.0.borrow_mut();
        let barrier = bytes[4..].starts_with(&[2, 1, 2, 1]) && !line.closed;
        let reply =
            if barrier { pong(bytes) } else { line.replies.pop_front().unwrap_or_default() };
        line.coming.extend(reply);
        bytes.len()
    }

    fn now(&self) -> u32 {
        self.0.borrow().now
    }
}

impl embedded_io::ErrorType for Uart {
    type Error = Infallible;
}

impl embedded_io_async::Read for Uart {
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        poll_fn(|_| self.take(buffer).map_or(Poll::Pending, |count| Poll::Ready(Ok(count)))).await
    }
}

impl embedded_io_async::Write for Uart {
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        Ok(self.put(bytes))
    }

    async fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

struct Nobody;

impl Wake for Nobody {
    fn wake(self: Arc<Self>) {}
}

/// A minimal executor: while something waits, time goes on.
fn block_on<T>(line: &Uart, future: impl Future<Output = T>) -> T {
    let waker = Waker::from(Arc::new(Nobody));
    let mut future = pin!(future);
    loop {
        if let Poll::Ready(done) = future.as_mut().poll(&mut Context::from_waker(&waker)) {
            return done;
        }
        line.0.borrow_mut().now += 10;
    }
}

fn sleep(line: &Uart, milliseconds: u32) -> impl Future<Output = ()> {
    let (line, end) = (line.clone(), line.now() + milliseconds);
    poll_fn(move |_| if line.now() < end { Poll::Pending } else { Poll::Ready(()) })
}

fn ack(command: u8, code: AckCode) -> PacketBuilder {
    let mut builder = PacketBuilder::new(tools::SET);
    builder.push(&Acknowledge { command, code }).unwrap();
    builder
}

const BIAS: tools::BiasVector = tools::BiasVector { bias: Vector3f { x: 1.0, y: 2.0, z: 3.0 } };
const NO_PING: CommandError = CommandError::new("tools.ping", Reason::TimedOut);

#[test]
fn a_future_that_is_dropped() {
    let mut answer = ack(5, AckCode::OK);
    answer.push(&BIAS).unwrap();
    let uart = Uart::answering(&[vec![], answer.bytes().to_vec()]);
    let clock = uart.clone();
    let client = Client::with_timeout(100);
    let mut device: AsyncDevice<_, _, 1, 600> =
        AsyncDevice::with_client(uart.clone(), |ms| sleep(&clock, ms), client);
    {
        let read = tools::Bias::read();
        let waker = Waker::from(Arc::new(Nobody));
        let mut request = pin!(device.request(&read));
        assert!(request.as_mut().poll(&mut Context::from_waker(&waker)).is_pending());
    }
    assert_eq!(block_on(&uart, device.request(&tools::Bias::read())), Ok(BIAS));
    // Its answer arrives late: it answers nothing.
    uart.0.borrow_mut().coming.extend(answer.bytes());
    let packet = block_on(&uart, device.next_packet(50)).unwrap().map(|p| p.bytes().to_vec());
    assert_eq!(packet.as_deref(), Some(answer.bytes()));
    assert_eq!(tools::BiasVector::SET, tools::SET);
}

#[test]
fn time_goes_on_while_noise_comes_without_end() {
    let uart = Uart::default();
    uart.0.borrow_mut().flooded = true;
    let clock = uart.clone();
    let mut device = AsyncDevice::new(uart.clone(), |ms| sleep(&clock, ms));
    let late = DeviceError::Command(NO_PING);
    assert_eq!(block_on(&uart, device.request(&tools::Ping)), Err(late));
    assert_eq!(uart.now(), 64 + 1000 + 64); // what waits before, and what could have arrived in time
    assert!(block_on(&uart, device.next_packet(50)).unwrap().is_none());
    assert_eq!(uart.now(), 64 + 1115 + 63);
}

#[test]
fn packets_behind_noise_are_found_before_a_port_is_closed() {
    let mut data = PacketBuilder::new(measurements::MEASUREMENTS_SET);
    data.push(&measurements::Accel::default()).unwrap();
    let noise = b"ue\x80\xFF";
    let uart = Uart::default();
    let clock = uart.clone();
    let mut device = AsyncDevice::new(uart.clone(), |ms| sleep(&clock, ms));
    {
        let waker = Waker::from(Arc::new(Nobody));
        let mut request = pin!(device.request(&tools::Ping));
        assert!(request.as_mut().poll(&mut Context::from_waker(&waker)).is_pending());
        uart.0.borrow_mut().coming.extend([noise, ack(1, AckCode::OK).bytes()].concat());
        uart.0.borrow_mut().closed = true;
        assert_eq!(block_on(&uart, request), Ok(()));
    }
    uart.0.borrow_mut().coming.extend([noise, data.bytes()].concat());
    let packet = block_on(&uart, device.next_packet(50)).unwrap().map(|p| p.bytes().to_vec());
    assert_eq!(packet.as_deref(), Some(data.bytes()));
    assert_eq!(block_on(&uart, device.next_packet(50)).unwrap_err(), DeviceError::Closed);
}

/// A UART on which every fourth operation, starting with the first, fails with an error of this
/// kind, and which accepts at most `accepts` bytes.
#[derive(Clone)]
struct Shaky {
    uart: Uart,
    read: ErrorKind,
    write: ErrorKind,
    accepts: usize,
    operations: u32,
}

/// Each operation fails.
const ALWAYS: u32 = u32::MAX;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Failed(ErrorKind);

impl std::fmt::Display for Failed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?}", self.0)
    }
}

impl std::error::Error for Failed {}

impl embedded_io::Error for Failed {
    fn kind(&self) -> ErrorKind {
        self.0
    }
}

impl Shaky {
    fn new(read: ErrorKind, write: ErrorKind, accepts: usize) -> Self {
        let uart = Uart::default();
        Self { uart, read, write, accepts, operations: 0 }
    }

    fn fails(&mut self, kind: ErrorKind) -> Result<(), Failed> {
        self.operations = self.operations.saturating_add(1);
        if self.operations % 4 == 1 || self.operations == ALWAYS {
            Err(Failed(kind))
        } else {
            Ok(())
        }
    }

    /// The answer to a ping arrives when all of it has been accepted.
    fn accept(&mut self, bytes: &[u8]) -> Result<usize, Failed> {
        self.fails(self.write)?;
        if self.accepts >= bytes.len() {
            self.uart.0.borrow_mut().coming.extend(pong(bytes));
        }
        Ok(bytes.len().min(self.accepts))
    }
}

impl embedded_io::ErrorType for Shaky {
    type Error = Failed;
}

impl embedded_io::ReadReady for Shaky {
    fn read_ready(&mut self) -> Result<bool, Failed> {
        self.fails(self.read)?;
        let mut line = self.uart.0.borrow_mut();
        let ready = line.closed || !line.coming.is_empty();
        line.now += if ready { 0 } else { 10 };
        Ok(ready)
    }
}

impl embedded_io::Read for Shaky {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Failed> {
        self.fails(self.read)?;
        Ok(self.uart.take(buffer).expect("this would wait for ever"))
    }
}

impl embedded_io::Write for Shaky {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Failed> {
        self.accept(bytes)
    }

    fn flush(&mut self) -> Result<(), Failed> {
        self.fails(self.write)
    }
}

impl embedded_io_async::Read for Shaky {
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Failed> {
        self.fails(self.read)?;
        Ok(embedded_io_async::Read::read(&mut self.uart, buffer).await.unwrap())
    }
}

impl embedded_io_async::Write for Shaky {
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, Failed> {
        self.accept(bytes)
    }

    async fn flush(&mut self) -> Result<(), Failed> {
        self.fails(self.write)
    }
}

fn at<P>(port: &Shaky, of: impl FnOnce(Shaky, Uart) -> P) -> P {
    of(port.clone(), port.uart.clone())
}

fn blocking(port: &Shaky) -> Result<(), DeviceError<EmbeddedError<Failed>>> {
    at(port, |port, uart| {
        Device::new(EmbeddedPort::new(port, move || uart.now())).request(&tools::Ping)
    })
}

fn awaited(port: &Shaky) -> Result<(), DeviceError<Failed>> {
    at(port, |port, uart| {
        let mut device = AsyncDevice::new(port, |ms| sleep(&uart, ms));
        block_on(&uart, device.request(&tools::Ping))
    })
}

#[test]
fn errors_that_only_mean_that_it_is_to_be_tried_again() {
    use ErrorKind::{BrokenPipe, Interrupted, TimedOut};
    for kind in [Interrupted, TimedOut] {
        assert_eq!(blocking(&Shaky::new(kind, Interrupted, 3)), Ok(()));
        assert_eq!(awaited(&Shaky::new(kind, Interrupted, 3)), Ok(()));
    }
    // They take time like any other wait.
    let port = Shaky { operations: ALWAYS, ..Shaky::new(TimedOut, Interrupted, 3) };
    let mut device = AsyncDevice::new(port.clone(), |ms| sleep(&port.uart, ms));
    assert!(block_on(&port.uart, device.next_packet(100)).unwrap().is_none());
    assert_eq!(device.port().accepts, 3);
    assert_eq!(device.into_port().read, TimedOut);
    // Others end the command.
    let broken = Shaky::new(BrokenPipe, Interrupted, 3);
    let error = DeviceError::Port(EmbeddedError::Driver(Failed(BrokenPipe)));
    assert_eq!(blocking(&broken), Err(error));
    assert_eq!(error.to_string(), "port: BrokenPipe");
    assert_eq!(awaited(&broken), Err(DeviceError::Port(Failed(BrokenPipe))));
    let mut late = Shaky::new(Interrupted, TimedOut, 3);
    let error = DeviceError::Port(EmbeddedError::Driver(Failed(TimedOut)));
    assert_eq!(blocking(&late), Err(error));
    late.operations = 3; // the first reads what has arrived
    assert_eq!(awaited(&late), Err(DeviceError::Port(Failed(TimedOut))));
}

#[test]
fn a_port_that_accepts_no_bytes() {
    use ErrorKind::Interrupted;
    let port = Shaky::new(Interrupted, Interrupted, 0);
    assert_eq!(blocking(&port), Err(DeviceError::Port(EmbeddedError::WriteZero)));
    assert_eq!(EmbeddedError::<Failed>::WriteZero.to_string(), "the driver accepts no bytes");
    assert_eq!(awaited(&port), Err(DeviceError::Closed));
}

/// The port did not accept a ping; now it accepts bytes, and the answer arrives after an interruption.
fn late(port: &mut Shaky) {
    (port.accepts, port.operations) = (usize::MAX, 0);
    port.uart.0.borrow_mut().coming.extend(ack(1, AckCode(3)).bytes());
}

#[test]
fn an_interruption_hides_no_late_answer() {
    let port = Shaky::new(ErrorKind::Interrupted, ErrorKind::Interrupted, 0);
    let clock = port.uart.clone();
    let mut device = Device::new(EmbeddedPort::new(port.clone(), move || clock.now()));
    assert!(device.request(&tools::Ping).is_err());
    late(device.port_mut().get_mut());
    assert_eq!(device.request(&tools::Ping), Ok(()));

    let port = Shaky::new(ErrorKind::Interrupted, ErrorKind::Interrupted, 0);
    let mut device = AsyncDevice::new(port.clone(), |ms| sleep(&port.uart, ms));
    assert!(block_on(&port.uart, device.request(&tools::Ping)).is_err());
    late(device.port_mut());
    assert_eq!(block_on(&port.uart, device.request(&tools::Ping)), Ok(()));
}
