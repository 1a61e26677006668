//! Sets up a sensor and receives its data on a microcontroller, byte
//! by byte, without an operating system, memory allocation or any other crate.
//!
//!     cargo build --release --example firmware --target thumbv7em-none-eabi
//!
//! On a computer, the program reads from standard input and writes to standard output.

#![cfg_attr(target_os = "none", no_std, no_main)]

use mip_protocol::mip_3dm::{DataStreamControl, GetBaseRate};
use mip_protocol::sensor::{self, ScaledAccel, ScaledGyro};
use mip_protocol::shared::GpsTimestamp;
use mip_protocol::{Client, Parser, RawField};

/// What the program needs from its hardware.
trait Board {
    /// Returns a received byte; `None` if there is none yet.
    fn receive(&mut self) -> Option<u8>;
    fn send(&mut self, bytes: &[u8]);
    fn milliseconds(&mut self) -> u32;
    fn show(&mut self, what: u32, value: f32);
    /// Should the program continue?
    fn running(&self) -> bool;
}

fn run(board: &mut impl Board) {
    let mut parser = Parser::new();
    let mut client: Client<1> = Client::default(); // one command at a time
    let mut start = None;

    let rate = match client.send(&GetBaseRate::new(sensor::SET), board.milliseconds()) {
        Ok((ticket, packet)) => {
            board.send(packet.bytes());
            ticket
        }
        Err(_) => return,
    };
    while board.running() {
        if let Some(byte) = board.receive() {
            let mut received = &[byte][..];
            while let Some(packet) = parser.next(&mut received) {
                for field in client.receive(&packet).others().map_while(Result::ok) {
                    take(board, &field);
                }
            }
        }
        // Commands time out after the bytes held back have been searched.
        while let Some(packet) = client.poll(&mut parser, board.milliseconds()) {
            for field in client.receive(&packet).others().map_while(Result::ok) {
                take(board, &field);
            }
        }
        match client.take(&rate) {
            None => {}
            Some(Ok(response)) => {
                board.show(1, response.rate.into());
                let stream = DataStreamControl::write(sensor::SET, true);
                if let Ok((ticket, packet)) = client.send(&stream, board.milliseconds()) {
                    board.send(packet.bytes());
                    start = Some(ticket);
                }
            }
            Some(Err(_)) => board.show(2, 0.0), // refused, or not answered
        }
        if let Some(answer) = start.as_ref().and_then(|ticket| client.take(ticket)) {
            board.show(if answer.is_ok() { 3 } else { 4 }, 0.0);
        }
    }
}

fn take(board: &mut impl Board, field: &RawField<'_>) {
    if let Ok(Some(time)) = field.get::<GpsTimestamp>() {
        board.show(5, time.week_number.into());
    } else if let Ok(Some(accel)) = field.get::<ScaledAccel>() {
        board.show(6, accel.scaled_accel.z);
    } else if let Ok(Some(gyro)) = field.get::<ScaledGyro>() {
        board.show(7, gyro.scaled_gyro.z);
    }
}

#[cfg(target_os = "none")]
mod board {
    use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

    /// Stands in for the registers of a microcontroller.
    static REGISTERS: [AtomicU32; 4] = [const { AtomicU32::new(0) }; 4];

    struct Machine;

    impl super::Board for Machine {
        fn receive(&mut self) -> Option<u8> {
            u8::try_from(REGISTERS[0].load(Relaxed)).ok()
        }

        fn send(&mut self, bytes: &[u8]) {
            bytes.iter().for_each(|byte| REGISTERS[1].store((*byte).into(), Relaxed));
        }

        fn milliseconds(&mut self) -> u32 {
            REGISTERS[2].load(Relaxed)
        }

        fn show(&mut self, what: u32, value: f32) {
            REGISTERS[3].store(what ^ value.to_bits(), Relaxed);
        }

        fn running(&self) -> bool {
            true
        }
    }

    #[no_mangle]
    pub extern "C" fn _start() -> ! {
        loop {
            super::run(&mut Machine);
        }
    }

    #[panic_handler]
    fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
        loop {}
    }
}

#[cfg(not(target_os = "none"))]
mod board {
    use std::io::{stdin, stdout, Read, Write};
    use std::time::Instant;

    pub struct Machine {
        pub start: Instant,
        pub open: bool,
    }

    impl super::Board for Machine {
        fn receive(&mut self) -> Option<u8> {
            let mut byte = [0];
            self.open = matches!(stdin().read(&mut byte), Ok(1));
            self.open.then_some(byte[0])
        }

        fn send(&mut self, bytes: &[u8]) {
            let mut out = stdout();
            self.open = out.write_all(bytes).and_then(|()| out.flush()).is_ok();
        }

        fn milliseconds(&mut self) -> u32 {
            self.start.elapsed().as_millis() as u32
        }

        fn show(&mut self, what: u32, value: f32) {
            eprintln!("{what} {value}");
        }

        fn running(&self) -> bool {
            self.open
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    run(&mut board::Machine { start: std::time::Instant::now(), open: true });
}
