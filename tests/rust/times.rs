//! Prints times, validity or the rejected field for each line of standard input:
//!
//!     time DEVICE PACKET [PACKET]...    the times of the last packet, read after the others
//!     valid DEVICE FIELD DATA           a word for each value with flags: alone, and on the device
//!     utc CLOCK NANOSECONDS             the time of a clock with an epoch in UTC
//!     rejected DEVICE COMMAND DATA LISTED         the field, of a command's set, descriptor and data

use std::io::stdin;

use mip_protocol::devices::{Known, Profile, Rejected};
use mip_protocol::time::{Clock, Times, Utc};
use mip_protocol::{Packet, RawField};

mod valid {
    include!("valid.rs"); // written by the test
}

fn main() {
    for line in stdin().lines() {
        let line = line.unwrap();
        let mut words = line.split(' ');
        let what = words.next().unwrap();
        let name = words.next().unwrap();
        if what == "utc" {
            let clock = Clock::ALL.iter().find(|clock| clock.name() == name).unwrap();
            let time = words.next().unwrap().parse().unwrap();
            println!("{}", Utc::from_clock(*clock, time).unwrap().unix_nanoseconds());
            continue;
        }
        let device = Profile::by_id(name);
        if what == "rejected" {
            let [command, data, listed] = [(); 3].map(|()| bytes(words.next().unwrap()));
            let numbers = listed.chunks(2).map(|x| u16::from_be_bytes([x[0], x[1]]));
            let known = Known { profile: device, descriptors: &numbers.collect::<Vec<_>>() };
            let command = RawField { set: command[0].into(), descriptor: command[1], data: &data };
            let text = Rejected::find(&command, &known).map(|found| {
                let Rejected { index, set, descriptor, reason, .. } = found;
                format!("{index} {:02X} {descriptor:02X} {reason:?} {found}", set.0)
            });
            println!("{}", text.unwrap_or_default());
            continue;
        }
        if what == "valid" {
            let name = words.next().unwrap();
            println!(
                "{}",
                valid::valid(name, device, &bytes(words.next().unwrap_or(""))).join(" ")
            );
            continue;
        }
        let mut times = device.map_or_else(Times::new, Times::of);
        let mut last = Vec::new();
        for data in words.map(bytes) {
            let packet = Packet::new(&data).unwrap();
            last = Clock::ALL.iter().map(|clock| times.read(&packet, *clock)).collect();
            if device.is_none() && line.split(' ').count() == 3 {
                let alone = Clock::ALL.iter().map(|clock| packet.time(*clock));
                assert_eq!(alone.collect::<Vec<_>>(), last);
            }
        }
        let texts = Clock::ALL.iter().zip(last).map(|(clock, time)| {
            let utc = time.and_then(|time| Utc::from_clock(*clock, time));
            let seconds = time.map_or("none".into(), |time: i64| time.to_string());
            format!("{}={}", clock.name(), utc.map_or(seconds, |utc| utc.to_string()))
        });
        println!("{}", texts.collect::<Vec<_>>().join(" "));
    }
}

fn bytes(text: &str) -> Vec<u8> {
    (0..text.len()).step_by(2).map(|i| u8::from_str_radix(&text[i..i + 2], 16).unwrap()).collect()
}
