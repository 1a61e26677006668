//! Turns a log of accelerations and angular rates into a table.
//!
//!     cargo run --example log_to_csv --features std -- log.bin > log.csv

use std::error::Error;
use std::fs::File;
use std::io::{stdout, Write};

use mip_protocol::sensor::{ScaledAccel, ScaledGyro};
use mip_protocol::{shared, types::Vector3f, PacketReader};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: log_to_csv LOG")?;
    let mut packets = PacketReader::new(File::open(path)?);
    let mut table = stdout().lock();
    writeln!(table, "tow_s,accel_x_g,accel_y_g,accel_z_g,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s")?;
    while let Some(packet) = packets.next_packet()? {
        // What is not in the packet leaves its columns empty; what is broken is an error.
        let time = packet.find::<shared::GpsTimestamp>().transpose()?;
        let accel = packet.find::<ScaledAccel>().transpose()?.map(|field| field.scaled_accel);
        let gyro = packet.find::<ScaledGyro>().transpose()?.map(|field| field.scaled_gyro);
        if accel.is_none() && gyro.is_none() {
            continue;
        }
        let time = time.filter(|time| time.valid_flags.tow()).map(|time| time.tow.to_string());
        let columns = [time.unwrap_or_default(), text(accel), text(gyro)];
        writeln!(table, "{}", columns.join(","))?;
    }
    eprintln!("{} bytes are not part of a packet", packets.parser().skipped());
    Ok(())
}

fn text(vector: Option<Vector3f>) -> String {
    vector.map_or(",,".into(), |v| format!("{},{},{}", v.x, v.y, v.z))
}
