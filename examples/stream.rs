//! Finds a device, shows its model, and then its accelerations at 100 Hz until no more arrive.
//!
//!     cargo run --example stream --features open -- serial:/dev/ttyACM0

use std::error::Error;
use std::io::{stdout, Write};

use mip_protocol::base::GetDeviceInfo;
use mip_protocol::sensor::{self, ScaledAccel, ScaledGyro};
use mip_protocol::session::Rate;

fn main() -> Result<(), Box<dyn Error>> {
    let place = std::env::args().nth(1).ok_or("usage: stream serial:PORT | tcp:HOST:PORT")?;
    let mut device = mip_protocol::open(&place)?; // finds the baud rate, and stops other data
    let mut out = stdout().lock();
    writeln!(out, "{}", device.request(&GetDeviceInfo::new())?.device_info.model_name)?;

    device.stream(sensor::SET, &[Rate::of::<ScaledAccel>(100.0), Rate::of::<ScaledGyro>(50.0)])?;
    while let Some(packet) = device.next_packet(1000)? {
        if let Some(accel) = packet.find::<ScaledAccel>()? {
            let [x, y, z]: [f32; 3] = accel.scaled_accel.into();
            writeln!(out, "{x:8.4} {y:8.4} {z:8.4} g")?;
        }
    }
    Ok(())
}
