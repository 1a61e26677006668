//! Writes the fields of a log as JSON, one packet per line.
//!
//!     cargo run --example json --features std,serde -- log.bin

use std::error::Error;
use std::fs::File;
use std::io::{stdout, BufWriter, Write};

use mip_protocol::{AnyField, FieldLengthError, PacketReader, RawField};
use serde_json::json;

fn main() {
    if let Err(error) = run() {
        eprintln!("json: {error}");
        std::process::exit(1);
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: json LOG")?;
    let mut packets = PacketReader::new(File::open(path)?);
    let mut lines = BufWriter::new(stdout().lock());
    while let Some(packet) = packets.next_packet()? {
        let fields = packet.fields().map(text).collect::<Result<Vec<_>, _>>()?;
        writeln!(lines, r#"{{"set":{},"fields":[{}]}}"#, packet.set().0, fields.join(","))?;
    }
    Ok(lines.flush()?)
}

/// Text, not a `serde_json::Value`: its floats have 64 bits, so that 0.1 would get 17 digits.
fn text(field: Result<RawField<'_>, FieldLengthError>) -> serde_json::Result<String> {
    let field = match field {
        Ok(field) => field,
        Err(error) => return serde_json::to_string(&json!({"error": error.to_string()})),
    };
    let mut raw = json!({"descriptor": field.descriptor, "data": field.data});
    // Borrowed, because it is as large as the largest field.
    match &AnyField::decode(&field) {
        Ok(Some(found)) => return serde_json::to_string(found), // {"sensor.scaled_accel": {…}}
        Err(error) => raw["error"] = error.to_string().into(),
        Ok(None) => {} // unknown
    }
    serde_json::to_string(&raw)
}
