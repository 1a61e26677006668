use mip_protocol::device::{Device, DeviceError, Port};
use mip_protocol::sensor::{self, ScaledAccel};
use mip_protocol::{base, mip_3dm};

/// The port is, for example, `StdPort::new(serial)` with a port of the crate `serialport`.
fn run<P: Port>(port: P) -> Result<(), DeviceError<P::Error>> {
    let mut device = Device::new(port);
    let info = device.request(&base::GetDeviceInfo::new())?; // its response, or an error
    println!("{}", info.device_info.model_name);
    device.request(&mip_3dm::DataStreamControl::write(sensor::SET, true))?; // no response: ()

    let (rate, pps) = (mip_3dm::GetBaseRate::new(sensor::SET), mip_3dm::PpsSourceControl::read());
    let (rate, pps) = device.request_all((&rate, &pps))?; // in one packet
    println!("{} Hz, {}", rate.rate, pps.source);

    while let Some(packet) = device.next_packet(1000)? {
        match packet.find::<ScaledAccel>() {
            // It is upside down: what is decoded no longer borrows the packet, nor that the device.
            Ok(Some(accel)) if accel.scaled_accel.z > 0.0 => device.request(&base::SetIdle::new())?,
            Ok(Some(accel)) => println!("{:.4} g along x", accel.scaled_accel.x),
            Err(broken) => println!("{broken}"),
            Ok(None) => {} // the packet contains other fields
        }
    }
    Ok(()) // no data for a second
}
