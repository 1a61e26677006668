//! Opens a device, and sends a command of the reference.

use std::error::Error;

// 1. the line of the page that begins with use
use mip_protocol::base;

fn main() -> Result<(), Box<dyn Error>> {
    let place = std::env::args().nth(1).ok_or("usage: program PORT | HOST:PORT")?;
    let mut device = mip_protocol::open(&place)?; // finds the baud rate, and stops other data
    // 2. the other lines of the page
    device.request(&base::Ping::new())?;
    // end of 2
    println!("command: acknowledged");
    Ok(())
}
