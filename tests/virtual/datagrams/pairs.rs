//! Reads the base rates of seven sets in turn, and counts the replies that are those of another command, with a device
//! that blocks or one that is awaited.

use std::io;
use std::net::UdpSocket;
use std::time::{Duration, Instant};

use mip_protocol::device::{AsyncDevice, Device, Port};
use mip_protocol::{mip_3dm::GetBaseRate, Client};

/// Each read returns one datagram.
struct Awaited(tokio::net::UdpSocket);

impl embedded_io_async::ErrorType for Awaited {
    type Error = io::Error;
}

impl embedded_io_async::Read for Awaited {
    async fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.recv(buffer).await
    }
}

impl embedded_io_async::Write for Awaited {
    async fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.send(bytes).await
    }

    async fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// The same, with time-outs.
struct Udp {
    socket: UdpSocket,
    start: Instant,
}

impl Port for Udp {
    type Error = io::Error;

    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self.socket.recv(buffer) {
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => Ok(0),
            count => count,
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.socket.send(bytes).map(|_| ())
    }

    fn waits(&mut self) -> io::Result<bool> {
        self.socket.set_nonblocking(true)?;
        let waits = self.socket.peek(&mut [0; 1]).is_ok();
        self.socket.set_nonblocking(false)?;
        Ok(waits)
    }

    fn now_ms(&mut self) -> u32 {
        self.start.elapsed().as_millis() as u32
    }
}

macro_rules! count {
    ($device:expr, $pairs:expr $(, $await:tt)?) => {{
        let [mut right, mut stale, mut other, mut shift, mut longest, mut kept] = [0_usize; 6];
        for (set, _) in [0x80, 0x82, 0x91, 0x92, 0x93, 0x94, 0xA0].into_iter().cycle().zip(0..$pairs) {
            let before = right;
            match $device.request(&GetBaseRate::new(set))$(.$await)? {
                Ok(response) if response.descriptor_set.0 == set => right += 1,
                Ok(_) => stale += 1,
                Err(_) => other += 1,
            }
            shift = if right > before { 0 } else { shift + 1 };
            longest = longest.max(shift);
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
        while let Some(packet) = $device.next_packet(300)$(.$await)?.unwrap() {
            kept += packet.fields().count();
        }
        println!(
            "{{\"right\": {right}, \"stale\": {stale}, \"other\": {other}, \"longest\": {longest}, \"kept\": {kept}}}"
        );
    }};
}

#[tokio::main(flavor = "current_thread")]
async fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, way, place, pairs] = &arguments[..] else { panic!("{arguments:?}") };
    let pairs: u32 = pairs.parse().unwrap();
    let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
    socket.connect(("127.0.0.1", place.parse().unwrap())).unwrap();
    let client = Client::with_timeout(10_000);
    if way == "awaited" {
        socket.set_nonblocking(true).unwrap();
        let port = Awaited(tokio::net::UdpSocket::from_std(socket).unwrap());
        let wait = |ms: u32| tokio::time::sleep(Duration::from_millis(ms.into()));
        let mut device: AsyncDevice<_, _, 8, 65536> = AsyncDevice::with_client(port, wait, client);
        count!(device, pairs, await);
    } else {
        socket.set_read_timeout(Some(Duration::from_millis(10))).unwrap();
        let port = Udp { socket, start: Instant::now() };
        let mut device: Device<_, 8, 65536> = Device::with_client(port, client);
        count!(device, pairs);
    }
}
