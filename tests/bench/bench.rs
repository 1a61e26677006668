//! Parses a file that holds a stream, decodes two fields of each packet, and prints nanoseconds for each.

use mip_protocol::sensor::{ScaledAccel, ScaledGyro};
use mip_protocol::Parser;
use std::time::Instant;

fn run(data: &[u8], decode: bool, sum: &mut f64) -> f64 {
    let (mut parser, mut packets) = (Parser::new(), 0u32);
    let begin = Instant::now();
    let mut rest = data;
    while let Some(packet) = parser.next(&mut rest) {
        packets += 1;
        if !decode {
            continue;
        }
        for field in packet.fields().flatten() {
            if let Some(Ok(accel)) = field.get::<ScaledAccel>() {
                *sum += f64::from(accel.scaled_accel.x);
            } else if let Some(Ok(gyro)) = field.get::<ScaledGyro>() {
                *sum += f64::from(gyro.scaled_gyro.x);
            }
        }
    }
    begin.elapsed().as_nanos() as f64 / f64::from(packets)
}

fn main() {
    let path = std::env::args().nth(1).expect("a file");
    let data = std::fs::read(path).expect("a readable file");
    let mut sum = 0.0;
    print!("{:.1} ", run(&data, false, &mut sum));
    println!("{:.1}", run(&data, true, &mut sum));
    assert!(sum > 0.0);
}
