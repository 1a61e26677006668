//! Requests accelerations from a device on a serial port, ten times a second, and prints fifty.
//!
//!     cargo run --example stream --features std -- /dev/ttyACM0

use std::error::Error;
use std::io::{stdout, Write};
use std::time::Duration;

use mip_protocol::device::{Device, StdPort};
use mip_protocol::types::DescriptorRate;
use mip_protocol::{base, mip_3dm, sensor, shared, Field};

const RATE: u16 = 10; // Hz
const SAMPLES: usize = 50;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: stream PORT")?;
    // While nothing comes, reads return after 10 ms, so that commands can time out.
    let serial = serialport::new(path, 115_200).timeout(Duration::from_millis(10)).open()?;
    let mut device = Device::new(StdPort::new(serial));

    // Without data in between, the answers come at once, whatever was set before.
    device.run(&base::SetIdle::new())?;
    while device.next_packet(0)?.is_some() {} // what it sent before
    let info = device.request(&base::GetDeviceInfo::new())?.device_info;
    let base_rate = device.request(&mip_3dm::GetBaseRate::new(sensor::SENSOR_SET))?.rate;
    let mut out = stdout().lock();
    writeln!(out, "{}, {base_rate} Hz", info.model_name)?;

    let decimation = (base_rate / RATE).max(1);
    let fields = [shared::GpsTimestamp::DESCRIPTOR, sensor::ScaledAccel::DESCRIPTOR];
    let format = fields.map(|descriptor| DescriptorRate::new(descriptor, decimation));
    device.run(&mip_3dm::MessageFormat::write(sensor::SENSOR_SET, format))?;
    device.run(&mip_3dm::DataStreamControl::write(sensor::SENSOR_SET, true))?;
    device.run(&base::Resume::new())?;

    let mut count = 0;
    while count < SAMPLES {
        let packet = device.next_packet(2000)?.ok_or("no data")?;
        let Some(accel) = packet.find::<sensor::ScaledAccel>().transpose()? else { continue };
        match packet.find::<shared::GpsTimestamp>().transpose()? {
            Some(time) if time.valid_flags.tow() => write!(out, "{:.3} s", time.tow)?,
            _ => write!(out, "no time")?, // before the receiver has a fix
        }
        let [x, y, z]: [f32; 3] = accel.scaled_accel.into();
        writeln!(out, ": {x:8.4} {y:8.4} {z:8.4} g")?;
        count += 1;
    }
    Ok(())
}
