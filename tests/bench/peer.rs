//! The same work with another crate, used as its documentation shows: it reads the stream byte by byte.

use std::hint::black_box;

use microstrain_inertial::api::data::filter::FilterField;
use microstrain_inertial::api::data::sensor::SensorField;
use microstrain_inertial::api::data::DataPacket;
use microstrain_inertial::framer::{MessageFramer, RawPacket};

fn packets(data: &[u8], mut found: impl FnMut(&RawPacket<'_>) -> usize) -> usize {
    let (mut framer, mut count) = (MessageFramer::new(), 0);
    for byte in data {
        if let Ok(Some(packet)) = framer.push_byte(*byte) {
            count += found(&packet);
        }
    }
    count
}

pub fn parse(data: &[u8]) -> usize {
    packets(data, |packet| {
        black_box(packet);
        1
    })
}

fn sensor(field: &SensorField) -> bool {
    !matches!(field, SensorField::Unknown { .. })
}

fn filter(field: &FilterField) -> bool {
    !matches!(field, FilterField::Unknown { .. })
}

pub fn get(data: &[u8]) -> usize {
    packets(data, |packet| {
        match DataPacket::from_frame(packet.descriptor_set(), packet.payload()) {
            Ok(DataPacket::SensorPacket(packet)) => {
                packet.fields().filter(|field| black_box(field).as_ref().is_ok_and(sensor)).count()
            }
            Ok(DataPacket::FilterPacket(packet)) => {
                packet.fields().filter(|field| black_box(field).as_ref().is_ok_and(filter)).count()
            }
            _ => 0,
        }
    })
}
