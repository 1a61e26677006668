//! An embassy task that sets up a sensor and receives its data.
//!
//!     cargo build --release --target thumbv7em-none-eabi
//!
//! Replace `Uart` and `Clock` with those of your microcontroller's HAL,
//! for example `embassy_stm32::usart::BufferedUart`, and enable its time driver feature.

#![no_std]
#![no_main]

use core::convert::Infallible;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use core::task::Waker;

use embassy_executor::Spawner;
use embassy_time::Timer;
use embedded_io_async::{ErrorType, Read, Write};
use mip_protocol::device::AsyncDevice;
use mip_protocol::sensor::{self, ScaledAccel};
use mip_protocol::session::{Rate, StreamError};

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    loop {
        let _lost = measure(Uart).await; // start again
        Timer::after_secs(1).await;
    }
}

async fn measure(
    port: impl Read<Error = Infallible> + Write,
) -> Result<(), StreamError<Infallible>> {
    // One command at a time, and room for a few packets that arrive meanwhile.
    let client = mip_protocol::Client::<1>::default();
    let wait = |milliseconds: u32| Timer::after_millis(milliseconds.into());
    let mut device: AsyncDevice<_, _, 1, 1024> = AsyncDevice::with_client(port, wait, client);

    device.connect(&[]).await?; // at the port's baud rate; sets the device to idle
    device.stream(sensor::SET, &[Rate::of::<ScaledAccel>(100.0)]).await?;
    while let Some(packet) = device.next_packet(1000).await? {
        if let Ok(Some(accel)) = packet.find::<ScaledAccel>() {
            SHOWN.store(accel.scaled_accel.z.to_bits(), Relaxed);
        }
    }
    Ok(()) // no data for a second
}

/// Stands in for the registers of a microcontroller.
static RECEIVED: AtomicU32 = AtomicU32::new(u32::MAX);
static SENT: AtomicU32 = AtomicU32::new(0);
static TICKS: AtomicU32 = AtomicU32::new(0);
static SHOWN: AtomicU32 = AtomicU32::new(0);

struct Uart;

impl ErrorType for Uart {
    type Error = Infallible;
}

impl Read for Uart {
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        loop {
            match (u8::try_from(RECEIVED.load(Relaxed)), buffer.first_mut()) {
                (Ok(byte), Some(place)) => {
                    *place = byte;
                    return Ok(1);
                }
                _ => Timer::after_millis(1).await,
            }
        }
    }
}

impl Write for Uart {
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        bytes.iter().for_each(|byte| SENT.store((*byte).into(), Relaxed));
        Ok(bytes.len())
    }

    async fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

struct Clock;

impl embassy_time_driver::Driver for Clock {
    fn now(&self) -> u64 {
        TICKS.load(Relaxed).into()
    }

    /// Without interrupts: polls again at once.
    fn schedule_wake(&self, _at: u64, waker: &Waker) {
        waker.wake_by_ref();
    }
}

embassy_time_driver::time_driver_impl!(static CLOCK: Clock = Clock);

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
