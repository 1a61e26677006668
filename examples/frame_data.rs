//! Opens a device, streams a data field of the reference once per second, and reads it.

use std::error::Error;

use mip_protocol::session::Rate;
use mip_protocol::DescriptorSet;
// 1. the line of the page that begins with use
use mip_protocol::sensor;

// 3. the descriptor set and the descriptor of the page
const FIELD: (DescriptorSet, u8) = (DescriptorSet(0x80), 0x04);

fn main() -> Result<(), Box<dyn Error>> {
    let place = std::env::args().nth(1).ok_or("usage: program PORT | HOST:PORT")?;
    let mut device = mip_protocol::open(&place)?; // finds the baud rate, and stops other data
    device.stream(FIELD.0, &[Rate::of_descriptor(FIELD.1, 1.0)])?; // 1 Hz
    while let Some(packet) = device.next_packet(5000)? {
        // 2. the other lines of the page
        if let Some(value) = packet.find::<sensor::ScaledAccel>()? {
            println!("{:?}", value.scaled_accel);
        }
        // end of 2
    }
    Ok(())
}
