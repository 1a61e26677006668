//! Converts the accelerations and angular rates in a log to a table, with the log's timestamps.
//!
//!     cargo run --example log_to_csv --features std -- log.bin > log.csv

use std::error::Error;
use std::fs::File;
use std::io::{stdout, BufWriter, Write};

use mip_protocol::types::{SensorGpsTimestampFlags, Vector3f};
use mip_protocol::{dispatch, sensor, shared, PacketReader};

/// The values of a packet, as far as present.
#[derive(Default)]
struct Row {
    tow_s: Option<f64>,
    since_start_s: Option<f64>,
    accel: Option<Vector3f>,
    gyro: Option<Vector3f>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: log_to_csv LOG")?;
    let mut packets = PacketReader::new(File::open(path)?);
    let mut table = BufWriter::new(stdout().lock());
    writeln!(
        table,
        "tow_s,since_start_s,accel_x_g,accel_y_g,accel_z_g,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s"
    )?;
    while let Some(packet) = packets.next_packet()? {
        // Columns of absent fields stay empty; a malformed field is an error.
        let mut row = Row::default();
        for field in packet.fields() {
            dispatch!(field?, {
                shared::GpsTimestamp(time) => {
                    row.tow_s = Some(time.tow).filter(|_| time.valid_flags.tow());
                },
                // The timestamp of older devices. The 5-series has one flag for time and week.
                sensor::GpsTimestamp(time) => {
                    let valid = SensorGpsTimestampFlags::TOW_VALID
                        | SensorGpsTimestampFlags::TIME_INITIALIZED;
                    row.tow_s = Some(time.tow).filter(|_| time.valid_flags.intersects(valid));
                },
                shared::ReferenceTimestamp(time) => {
                    row.since_start_s = Some(time.nanoseconds as f64 / 1e9);
                },
                sensor::ScaledAccel(field) => row.accel = Some(field.scaled_accel),
                sensor::ScaledGyro(field) => row.gyro = Some(field.scaled_gyro),
            })?;
        }
        if row.accel.is_some() || row.gyro.is_some() {
            let (tow, since_start) = (number(row.tow_s), number(row.since_start_s));
            writeln!(table, "{tow},{since_start},{},{}", vector(row.accel), vector(row.gyro))?;
        }
    }
    table.flush()?;
    eprintln!("{} bytes are not part of a packet", packets.parser().skipped());
    Ok(())
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn vector(value: Option<Vector3f>) -> String {
    value.map_or(",,".into(), |v| format!("{},{},{}", v.x, v.y, v.z))
}
