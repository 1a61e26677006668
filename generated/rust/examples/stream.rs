//! Finds a device, shows its model, and then its accelerations at 100 Hz until no more arrive.
//!
//!     cargo run --example stream --features open -- /dev/ttyACM0

use std::error::Error;
use std::io::{stdout, Write};

use mip_protocol::base::GetDeviceInfo;
use mip_protocol::sensor::{self, ScaledAccel, ScaledGyro};
use mip_protocol::session::Rate;

fn main() {
    if let Err(error) = run() {
        eprintln!("stream: {error}");
        std::process::exit(1);
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let place = std::env::args().nth(1).ok_or("usage: stream PORT | HOST:PORT")?;
    let mut device = mip_protocol::open(&place)?; // finds the baud rate, and stops other data
    let mut out = stdout().lock();
    let info = device.request(&GetDeviceInfo::new())?.device_info;
    writeln!(out, "{}", info.model_name.to_string().trim())?; // some devices pad it in front

    device.stream(sensor::SET, &[Rate::of::<ScaledAccel>(100.0), Rate::of::<ScaledGyro>(50.0)])?;
    while let Some(packet) = device.next_packet(1000)? {
        if let Some(accel) = packet.find::<ScaledAccel>()? {
            let [x, y, z]: [f32; 3] = accel.scaled_accel.into();
            writeln!(out, "{x:8.4} {y:8.4} {z:8.4} g")?;
        }
    }
    Ok(())
}
