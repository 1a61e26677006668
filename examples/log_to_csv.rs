//! Converts the accelerations and angular rates in a log to a table, with their times.
//!
//!     cargo run --example log_to_csv --features std -- log.bin > log.csv

use std::error::Error;
use std::fs::File;
use std::io::{stdout, BufWriter, Write};

use mip_protocol::time::{Clock, Times, Utc};
use mip_protocol::types::Vector3f;
use mip_protocol::{sensor, PacketReader};

fn main() {
    if let Err(error) = run() {
        eprintln!("log_to_csv: {error}");
        std::process::exit(1);
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: log_to_csv LOG")?;
    let mut packets = PacketReader::new(File::open(path)?);
    let mut times = Times::new();
    let mut table = BufWriter::new(stdout().lock());
    writeln!(
        table,
        "time,time_device,accel_x_g,accel_y_g,accel_z_g,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s"
    )?;
    while let Some(packet) = packets.next_packet()? {
        // A date in UTC if the device has one, and the seconds since power-on by either clock for them.
        let date = times.read(&packet, Clock::Gps).map(|time| Utc::from_gps(time).to_string());
        let mut clocks = [Clock::Reference, Clock::Device].into_iter();
        let seconds = clocks.find_map(|clock| times.read(&packet, clock));
        let seconds = seconds.map(|time| time as f64 / 1e9);
        // Columns of absent fields stay empty; a malformed field is an error.
        let accel = packet.find::<sensor::ScaledAccel>()?;
        let gyro = packet.find::<sensor::ScaledGyro>()?;
        if accel.is_some() || gyro.is_some() {
            let (date, seconds) = (text(date), text(seconds));
            let accel = vector(accel.map(|field| field.scaled_accel));
            let gyro = vector(gyro.map(|field| field.scaled_gyro));
            writeln!(table, "{date},{seconds},{accel},{gyro}")?;
        }
    }
    table.flush()?;
    eprintln!("{} bytes are not part of a packet", packets.parser().skipped());
    Ok(())
}

fn text(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn vector(value: Option<Vector3f>) -> String {
    value.map_or(",,".into(), |v| format!("{},{},{}", v.x, v.y, v.z))
}
