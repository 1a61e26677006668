//! Writes the fields of a log as JSON, one packet in a line.
//!
//!     cargo run --example json --features std,serde -- log.bin

use std::error::Error;
use std::fs::File;

use mip_protocol::{AnyField, PacketReader};
use serde_json::{json, Value};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: json LOG")?;
    let mut packets = PacketReader::new(File::open(path)?);
    while let Some(packet) = packets.next_packet()? {
        let mut fields = Vec::new();
        for field in packet.fields().flatten() {
            // Borrowed, because it is as large as the largest field.
            fields.push(match &AnyField::decode(&field) {
                Some(Ok((any, _))) => serde_json::to_value(any)?, // {"sensor.scaled_accel": {…}}
                _ => json!({"descriptor": field.descriptor, "data": field.data}),
            });
        }
        println!("{}", json!({"set": packet.set(), "fields": Value::Array(fields)}));
    }
    Ok(())
}
