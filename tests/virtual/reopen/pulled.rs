//! Reads base rates while data streams; reopens the port each time it is pulled, a given number of times. The device
//! blocks or is awaited.

use std::time::Duration;

use mip_protocol::device::DeviceError;
use mip_protocol::{mip_3dm::GetBaseRate, sensor::ScaledAccel, session::Rate, DescriptorSet};

macro_rules! pulled {
    ($device:expr, $wanted:expr $(, $await:tt)?) => {{
        let [mut reopened, mut streamed, mut answered, mut lost, mut wrong, mut other] = [0_u32; 6];
        let mut device = $device.unwrap();
        let rates = [Rate::of::<ScaledAccel>(100.0)];
        device.stream(DescriptorSet(0x80), &rates)$(.$await)?.unwrap();
        for set in [0x80, 0x82, 0x91].map(DescriptorSet).into_iter().cycle() {
            match device.request(&GetBaseRate::new(set))$(.$await)? {
                Ok(response) => {
                    answered += 1;
                    wrong += u32::from(response.descriptor_set != set);
                }
                Err(DeviceError::Port(_) | DeviceError::Closed) => {
                    lost += 1;
                    device.reopen(Duration::from_secs(10))$(.$await)?.unwrap();
                    let mut packets = 0;
                    while device.next_packet(0)$(.$await)?.is_ok_and(|packet| packet.is_some()) {
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
            if reopened == $wanted {
                break;
            }
        }
        println!(
            "{{\"reopened\": {reopened}, \"streamed\": {streamed}, \"answered\": {answered}, \
             \"lost\": {lost}, \"wrong\": {wrong}, \"other\": {other}}}"
        );
    }};
}

#[tokio::main(flavor = "current_thread")]
async fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, way, place, wanted] = &arguments[..] else { panic!("{arguments:?}") };
    let wanted: u32 = wanted.parse().unwrap();
    if way == "awaited" {
        pulled!(mip_protocol::open_async(place).await, wanted, await);
    } else {
        pulled!(mip_protocol::open(place), wanted);
    }
}
