//! speed FILE FUNCTION ROUNDS: as speed.c. Runs one of the functions below over the bytes of a file, and prints the
//! fewest nanoseconds of processor time that a round took and what it found.

#[cfg(feature = "peer")]
mod peer;

use std::hint::black_box;
use std::io::{self, Read, Write};

use mip_protocol::device::{Device, StdPort};
use mip_protocol::registry::{visit, Listed, Visitor};
use mip_protocol::{filter_data as filter, packets, sensor, shared, types};
use mip_protocol::{AnyField, Field, Packet, PacketBuilder, PacketReader, Parser, RawField};

const CHUNK: usize = 4096;

// ---------------------------------------------------------------------------------------- ours

fn chunks(data: &[u8], size: usize, mut found: impl FnMut(&Packet<'_>) -> usize) -> usize {
    let (mut parser, mut count) = (Parser::new(), 0);
    for mut chunk in data.chunks(size) {
        while let Some(packet) = parser.next(&mut chunk) {
            count += found(&packet);
        }
    }
    count
}

fn each(packet: &Packet<'_>, decode: impl Fn(&RawField<'_>) -> bool) -> usize {
    packet.fields().flatten().filter(|field| decode(field)).count()
}

fn whole(packet: &Packet<'_>) -> usize {
    black_box(packet.bytes());
    1
}

fn parse(data: &[u8]) -> usize {
    chunks(data, CHUNK, whole)
}

fn slice(data: &[u8]) -> usize {
    packets(data).map(|packet| whole(&packet)).sum()
}

fn small(data: &[u8]) -> usize {
    chunks(data, 64, whole)
}

fn bytewise(data: &[u8]) -> usize {
    chunks(data, 1, whole)
}

fn reader(data: &[u8]) -> usize {
    let (mut reader, mut count) = (PacketReader::new(data), 0);
    while let Ok(Some(packet)) = reader.next_packet() {
        count += whole(&packet);
    }
    count
}

/// A port whose bytes are in memory, and that ignores what is sent.
struct Memory<'a>(&'a [u8]);

impl Read for Memory<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.read(buffer)
    }
}

impl Write for Memory<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn device(data: &[u8]) -> usize {
    let (mut device, mut count) = (Device::new(StdPort::new(Memory(data))), 0);
    while let Ok(Some(packet)) = device.next_packet(0) {
        count += whole(&packet);
    }
    count
}

fn got<T: Field>(field: &RawField<'_>) -> bool {
    used(field.get::<T>())
}

/// Uses the value, as a loop without the crate does; false if there is none.
fn used<T, E>(value: Result<Option<T>, E>) -> bool {
    match value {
        Ok(Some(value)) => {
            black_box(value);
            true
        }
        _ => false,
    }
}

fn of_any_set(field: &RawField<'_>) -> bool {
    match field.descriptor {
        shared::EventSource::DESCRIPTOR => got::<shared::EventSource>(field),
        shared::GpsTimestamp::DESCRIPTOR => got::<shared::GpsTimestamp>(field),
        shared::ReferenceTimestamp::DESCRIPTOR => got::<shared::ReferenceTimestamp>(field),
        shared::ReferenceTimeDelta::DESCRIPTOR => got::<shared::ReferenceTimeDelta>(field),
        _ => false,
    }
}

fn get(data: &[u8]) -> usize {
    let known = |field: &RawField<'_>| match field.set {
        sensor::SET => match field.descriptor {
            sensor::ScaledAccel::DESCRIPTOR => got::<sensor::ScaledAccel>(field),
            sensor::ScaledGyro::DESCRIPTOR => got::<sensor::ScaledGyro>(field),
            sensor::DeltaTheta::DESCRIPTOR => got::<sensor::DeltaTheta>(field),
            sensor::DeltaVelocity::DESCRIPTOR => got::<sensor::DeltaVelocity>(field),
            _ => of_any_set(field),
        },
        filter::SET => match field.descriptor {
            filter::AttitudeQuaternion::DESCRIPTOR => got::<filter::AttitudeQuaternion>(field),
            filter::LlhPosition::DESCRIPTOR => got::<filter::LlhPosition>(field),
            filter::NedVelocity::DESCRIPTOR => got::<filter::NedVelocity>(field),
            filter::LinearAccel::DESCRIPTOR => got::<filter::LinearAccel>(field),
            filter::CompAngularRate::DESCRIPTOR => got::<filter::CompAngularRate>(field),
            filter::Status::DESCRIPTOR => got::<filter::Status>(field),
            _ => of_any_set(field),
        },
        _ => false,
    };
    chunks(data, CHUNK, |packet| each(packet, known))
}

fn any(data: &[u8]) -> usize {
    chunks(data, CHUNK, |packet| {
        let mut count = 0;
        for field in packet.fields().flatten() {
            // Borrowed: moving a value as large as the largest field takes longer.
            if let Ok(Some(value)) = &AnyField::decode(&field) {
                black_box(value);
                count += 1;
            }
        }
        count
    })
}

struct Decode;

impl Visitor for Decode {
    type Output = bool;

    fn visit<T: Listed>(self, field: &RawField<'_>) -> bool {
        used(T::decode(field.data).map(Some))
    }

    fn unknown(self, _: &RawField<'_>) -> bool {
        false
    }
}

fn visitor(data: &[u8]) -> usize {
    chunks(data, CHUNK, |packet| each(packet, |field| visit(field, Decode)))
}

fn counted<T: Field>(packet: &Packet<'_>) -> usize {
    used(packet.find::<T>()).into()
}

fn find(data: &[u8]) -> usize {
    chunks(data, CHUNK, |packet| {
        counted::<shared::ReferenceTimestamp>(packet)
            + counted::<sensor::ScaledAccel>(packet)
            + counted::<sensor::ScaledGyro>(packet)
    })
}

/// Two vectors and a time, which change with each packet.
fn values(number: u32) -> (f32, u64) {
    (number as f32, u64::from(number) << 20)
}

/// As many packets as a stream of this size has.
fn numbers(data: &[u8]) -> std::ops::Range<u32> {
    0..data.len() as u32 / BUILT
}

/// The size of a packet with three fields.
const BUILT: u32 = 44;

fn encode(data: &[u8]) -> usize {
    let (mut builder, mut size) = (PacketBuilder::new(sensor::SET), 0);
    for number in numbers(data) {
        let values = black_box(values(number));
        builder.clear();
        size += build(&mut builder, values);
    }
    size
}

#[inline(always)] // as if it were written in each loop
fn build(builder: &mut PacketBuilder, (x, nanoseconds): (f32, u64)) -> usize {
    let vector = types::Vector3f { x, y: -x, z: x };
    let accel = sensor::ScaledAccel { scaled_accel: vector };
    let gyro = sensor::ScaledGyro { scaled_gyro: vector };
    let time = shared::ReferenceTimestamp { nanoseconds };
    let fits = builder.push(&time).and(builder.push(&accel)).and(builder.push(&gyro));
    if fits.is_err() {
        return 0;
    }
    black_box(builder.bytes()).len()
}

// ------------------------------------------------------------------- safe loops without the crate

/// The next packet: the bytes after it, and its own.
fn next(mut data: &[u8]) -> Option<(&[u8], &[u8])> {
    loop {
        let length = usize::from(*data.get(3)?);
        let is_header = data[0] == 0x75 && data[1] == 0x65 && !matches!(data[2], 0 | 0xFF);
        if is_header && data.len() >= length + 6 {
            let (packet, rest) = data.split_at(length + 6);
            let (mut a, mut b, mut left) = (0_u16, 0_u16, (length + 4) as u16);
            for byte in &packet[..length + 4] {
                a = a.wrapping_add(u16::from(*byte));
                b = b.wrapping_add(u16::from(*byte).wrapping_mul(left));
                left = left.wrapping_sub(1);
            }
            if packet[length + 4..] == [a as u8, b as u8] {
                return Some((rest, packet));
            }
        }
        data = &data[1..];
    }
}

fn bare(mut data: &[u8]) -> usize {
    let mut count = 0;
    while let Some((rest, packet)) = next(data) {
        black_box(packet);
        (data, count) = (rest, count + 1);
    }
    count
}

/// The same for bytes that arrive in pieces: the rest of one is moved to the front, and the next is appended.
fn pieces(data: &[u8], size: usize) -> usize {
    let (mut held, mut count) = (Vec::with_capacity(1024), 0);
    for piece in data.chunks(size) {
        held.extend_from_slice(piece);
        let mut rest = &held[..];
        while let Some((behind, packet)) = next(rest) {
            black_box(packet);
            (rest, count) = (behind, count + 1);
        }
        let used = held.len() - rest.len();
        held.drain(..used);
    }
    count
}

fn bare_parse(data: &[u8]) -> usize {
    pieces(data, CHUNK)
}

fn bare_small(data: &[u8]) -> usize {
    pieces(data, 64)
}

fn floats<const N: usize>(data: &[u8]) -> [f32; N] {
    std::array::from_fn(|i| f32::from_be_bytes(data[4 * i..4 * i + 4].try_into().unwrap()))
}

fn doubles<const N: usize>(data: &[u8]) -> [f64; N] {
    std::array::from_fn(|i| f64::from_be_bytes(data[8 * i..8 * i + 8].try_into().unwrap()))
}

fn words<const N: usize>(data: &[u8]) -> [u16; N] {
    std::array::from_fn(|i| u16::from_be_bytes(data[2 * i..2 * i + 2].try_into().unwrap()))
}

fn long(data: &[u8]) -> u64 {
    u64::from_be_bytes(data[..8].try_into().unwrap())
}

fn seen<T>(value: T) -> bool {
    black_box(value);
    true
}

/// Counts the fields that are seen.
#[inline(always)] // as if it were written in each loop
fn walked(mut data: &[u8], look: impl Fn(u8, u8, &[u8]) -> bool) -> usize {
    let mut count = 0;
    while let Some((rest, packet)) = next(data) {
        data = rest;
        let mut payload = &packet[4..packet.len() - 2];
        while let [length, descriptor, ..] = *payload {
            let Some(value) = payload.get(2..usize::from(length)) else { break };
            payload = &payload[usize::from(length)..];
            count += usize::from(look(packet[2], descriptor, value));
        }
    }
    count
}

fn bare_get(data: &[u8]) -> usize {
    walked(data, |set, descriptor, value| match (set, descriptor, value.len()) {
        (0x80, 0x04 | 0x05 | 0x07 | 0x08, 12..) => seen(floats::<3>(value)),
        (_, 0xD0, 1..) => seen(value[0]),
        (_, 0xD3, 12..) => seen((doubles::<1>(value), words::<2>(&value[8..]))),
        (_, 0xD5 | 0xD6, 8..) => seen(long(value)),
        (0x82, 0x03, 18..) => seen((floats::<4>(value), words::<1>(&value[16..]))),
        (0x82, 0x01, 26..) => seen((doubles::<3>(value), words::<1>(&value[24..]))),
        (0x82, 0x02 | 0x0D | 0x0E, 14..) => seen((floats::<3>(value), words::<1>(&value[12..]))),
        (0x82, 0x10, 6..) => seen(words::<3>(value)),
        _ => false,
    })
}

fn bare_find(data: &[u8]) -> usize {
    walked(data, |set, descriptor, value| match (set, descriptor, value.len()) {
        (0x80, 0x04 | 0x05, 12..) => seen(floats::<3>(value)),
        (_, 0xD5, 8..) => seen(long(value)),
        _ => false,
    })
}

fn bare_encode(data: &[u8]) -> usize {
    let (mut packet, mut size) = ([0; BUILT as usize], 0);
    for number in numbers(data) {
        let values = black_box(values(number));
        size += bare_build(&mut packet, values);
    }
    size
}

#[inline(always)]
fn bare_build(packet: &mut [u8; BUILT as usize], (x, nanoseconds): (f32, u64)) -> usize {
    packet[..6].copy_from_slice(&[0x75, 0x65, 0x80, 38, 10, 0xD5]);
    packet[6..14].copy_from_slice(&nanoseconds.to_be_bytes());
    for (at, descriptor) in [(14, 4), (28, 5)] {
        packet[at..at + 2].copy_from_slice(&[14, descriptor]);
        for (place, value) in packet[at + 2..at + 14].chunks_exact_mut(4).zip([x, -x, x]) {
            place.copy_from_slice(&value.to_be_bytes());
        }
    }
    let (mut a, mut b) = (0_u8, 0_u8);
    for byte in &packet[..42] {
        a = a.wrapping_add(*byte);
        b = b.wrapping_add(a);
    }
    packet[42..].copy_from_slice(&[a, b]);
    black_box(&packet[..]).len()
}

// ---------------------------------------------------------------------------------------- measure

type Row = (&'static str, fn(&[u8]) -> usize);

const ROWS: &[Row] = &[
    ("parse", parse),
    ("slice", slice),
    ("small", small),
    ("bytewise", bytewise),
    ("reader", reader),
    ("device", device),
    ("get", get),
    ("any", any),
    ("visitor", visitor),
    ("find", find),
    ("encode", encode),
    ("bare", bare),
    ("bare_parse", bare_parse),
    ("bare_small", bare_small),
    ("bare_get", bare_get),
    ("bare_find", bare_find),
    ("bare_encode", bare_encode),
    #[cfg(feature = "peer")]
    ("peer", peer::parse),
    #[cfg(feature = "peer")]
    ("peer_get", peer::get),
];

extern "C" {
    /// Microseconds of processor time, on POSIX.
    fn clock() -> std::ffi::c_long;
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let data = std::fs::read(&arguments[1]).expect("a readable file");
    let (_, run) = ROWS.iter().find(|(name, _)| *name == arguments[2]).expect("a function");
    let (mut best, mut found) = (f64::INFINITY, 0);
    for _ in 0..arguments[3].parse().expect("a number of rounds") {
        // SAFETY: it has no arguments and always returns.
        let begin = unsafe { clock() };
        found = run(black_box(&data));
        let end = unsafe { clock() };
        best = best.min((end - begin) as f64 * 1000.0);
    }
    println!("{best:.0} {found}");
}
