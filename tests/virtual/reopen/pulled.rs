//! Reads base rates while data streams; reopens the port each time it is pulled, a given number of times.

use std::time::Duration;

use mip_protocol::device::DeviceError;
use mip_protocol::{mip_3dm::GetBaseRate, sensor::ScaledAccel, session::Rate, DescriptorSet};

fn main() {
    let mut arguments = std::env::args().skip(1);
    let place = arguments.next().unwrap();
    let wanted: u32 = arguments.next().unwrap().parse().unwrap();
    let [mut reopened, mut streamed, mut answered, mut lost, mut wrong, mut other] = [0_u32; 6];
    let mut device = mip_protocol::open(&place).unwrap();
    device.stream(DescriptorSet(0x80), &[Rate::of::<ScaledAccel>(100.0)]).unwrap();
    for set in [0x80, 0x82, 0x91].map(DescriptorSet).into_iter().cycle() {
        match device.request(&GetBaseRate::new(set)) {
            Ok(response) => {
                answered += 1;
                wrong += u32::from(response.descriptor_set != set);
            }
            Err(DeviceError::Port(_)) => {
                lost += 1;
                device.reopen(Duration::from_secs(10)).unwrap();
                let mut packets = 0;
                while device.next_packet(0).is_ok_and(|packet| packet.is_some()) {
                    packets += 1;
                }
                streamed += u32::from(packets > 0);
                reopened += 1;
            }
            Err(error) => {
                eprintln!("{error}");
                other += 1;
            }
        }
        if reopened == wanted {
            break;
        }
    }
    println!(
        "{{\"reopened\": {reopened}, \"streamed\": {streamed}, \"answered\": {answered}, \
         \"lost\": {lost}, \"wrong\": {wrong}, \"other\": {other}}}"
    );
}
