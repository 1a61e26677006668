//! Sets up a device as the manuals advise: idle, settings, message format, save, resume.
//!
//!     cargo run --example setup --features open -- serial:/dev/ttyACM0

use std::error::Error;
use std::io::{stdout, Write};

use mip_protocol::types::DescriptorRate;
use mip_protocol::{base, mip_3dm, sensor, shared, Field};

const RATE: u16 = 100; // Hz
const CUTOFF: f32 = 25.0; // Hz

fn main() -> Result<(), Box<dyn Error>> {
    let place = std::env::args().nth(1).ok_or("usage: setup serial:PORT | tcp:HOST:PORT")?;
    // 1. Idle: the device sends no data while it is set up.
    let mut device = mip_protocol::open(&place)?;
    let accel = sensor::ScaledAccel::DESCRIPTOR;

    // 2. Settings.
    let filter = mip_3dm::LowPassFilter::write(sensor::SET, accel, true, true, CUTOFF);
    device.request(&filter)?;

    // 3. The data to send, and its rates. Several commands may share a packet.
    let base_rate = device.request(&mip_3dm::GetBaseRate::new(sensor::SET))?.rate;
    let decimation = (base_rate / RATE).max(1);
    let fields = [shared::GpsTimestamp::DESCRIPTOR, accel, sensor::ScaledGyro::DESCRIPTOR];
    let format = fields.map(|descriptor| DescriptorRate::new(descriptor, decimation));
    let format = mip_3dm::MessageFormat::write(sensor::SET, format);
    device.request_all((&format, &mip_3dm::DataStreamControl::write(sensor::SET, true)))?;

    // 4. Check the settings.
    let filter = device.request(&mip_3dm::LowPassFilter::read(sensor::SET, accel))?;
    let format = device.request(&mip_3dm::MessageFormat::read(sensor::SET))?;

    // 5. Save, so that the settings survive a power cycle.
    device.request(&mip_3dm::LowPassFilter::save(sensor::SET, accel))?;
    device.request(&mip_3dm::MessageFormat::save(sensor::SET))?;
    device.request(&mip_3dm::DataStreamControl::save(sensor::SET))?;

    // 6. Resume: the device sends data.
    device.request(&base::Resume::new())?;
    let packet = device.next_packet(2000)?.ok_or("no data")?;

    // Printed last, so that a closed pipe, as in `setup PORT | head`, interrupts no earlier step.
    let mut out = stdout().lock();
    writeln!(out, "low-pass filter at {} Hz", filter.frequency)?;
    for field in format.descriptors.iter() {
        let rate = base_rate / field.decimation.max(1);
        writeln!(out, "field 0x{:02X} at {rate} Hz", field.descriptor)?;
    }
    writeln!(out, "saved; {} fields in the first packet", packet.fields().count())?;
    Ok(())
}
