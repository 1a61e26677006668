//! Reads the base rates of seven sets in turn, and counts the replies that are those of another command.

use std::io;
use std::net::UdpSocket;
use std::time::{Duration, Instant};

use mip_protocol::device::{Device, Port};
use mip_protocol::{mip_3dm::GetBaseRate, Client};

/// Each read returns one datagram.
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

fn main() {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<u16>().unwrap());
    let place = arguments.next().unwrap();
    let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
    socket.connect(("127.0.0.1", place)).unwrap();
    socket.set_read_timeout(Some(Duration::from_millis(10))).unwrap();
    let [mut right, mut stale, mut other, mut shift, mut longest, mut kept] = [0_usize; 6];
    let client = Client::with_timeout(10_000);
    let mut device: Device<_, 8, 65536> = Device::with_client(Udp { socket, start: Instant::now() }, client);
    for (set, _) in [0x80, 0x82, 0x91, 0x92, 0x93, 0x94, 0xA0].into_iter().cycle().zip(0..arguments.next().unwrap()) {
        let before = right;
        match device.request(&GetBaseRate::new(set)) {
            Ok(response) if response.descriptor_set.0 == set => right += 1,
            Ok(_) => stale += 1,
            Err(_) => other += 1,
        }
        shift = if right > before { 0 } else { shift + 1 };
        longest = longest.max(shift);
        std::thread::sleep(Duration::from_millis(20));
    }
    while let Some(packet) = device.next_packet(300).unwrap() {
        kept += packet.fields().count();
    }
    println!(
        "{{\"right\": {right}, \"stale\": {stale}, \"other\": {other}, \"longest\": {longest}, \"kept\": {kept}}}"
    );
}
