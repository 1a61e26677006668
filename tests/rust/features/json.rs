//! Every field, with random data, through JSON and back.

use mip_protocol::registry::FIELDS;
use mip_protocol::{AnyField, RawField};

/// Random bytes; those of special floats are frequent.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn byte(&mut self) -> u8 {
        match self.next() % 8 {
            0 => 0,
            1 => 0x7F,
            2 => 0xFF,
            3 => (self.next() % 8) as u8,
            _ => self.next() as u8,
        }
    }
}

fn encoded(field: &AnyField) -> Vec<u8> {
    let mut buffer = [0; 253];
    let length = field.encode(&mut buffer).unwrap();
    buffer[..length].to_vec()
}

#[test]
fn every_field_goes_to_json_and_comes_back() {
    let (mut random, mut special, mut missed) = (Random(1), 0, Vec::new());
    for info in FIELDS {
        let mut done = 0;
        for attempt in 0..400_usize {
            let mut data: Vec<u8> = (0..attempt % 254).map(|_| random.byte()).collect();
            if let Some(first) = data.first_mut().filter(|_| attempt % 2 == 0) {
                *first = *first % 5 + 1; // often a function
            }
            let field = RawField { set: info.sets[0], descriptor: info.descriptor, data: &data };
            let Ok(Some(value)) = &AnyField::decode(&field) else { continue };
            if value.info() != info {
                continue; // another layout of this descriptor
            }
            let text = serde_json::to_string(value).unwrap();
            let back: AnyField = match serde_json::from_str(&text) {
                Ok(back) => back,
                Err(error) => panic!("{text}: {error}"),
            };
            assert_eq!(encoded(&back), encoded(value), "{text}");
            special += usize::from(text.contains("NaN(0x"));
            done += 1;
        }
        if done == 0 {
            missed.push(info.name);
        }
    }
    assert!(special > 100, "{special}");
    // Random bytes seldom match a layout that begins with a constant.
    assert!(missed.len() * 4 < FIELDS.len(), "{missed:?}");
}
