//! A program for a microcontroller that uses everything. It links only if nothing in it can panic:
//! the panic handler calls a function that does not exist.

#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;

use mip_protocol::device::{Device, Port};
use mip_protocol::protocol::Acknowledge;
use mip_protocol::{dispatch, AnyField, Client, Packet, PacketBuilder, Parser, RawField};

extern "C" {
    fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    unsafe { a_panic_can_be_reached() }
}

/// The bytes of a line that is not there.
#[inline(never)]
fn input() -> &'static [u8] {
    black_box(&[0x75, 0x65])
}

struct Line;

impl Port for Line {
    type Error = ();

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, ()> {
        black_box(buffer);
        Ok(black_box(7))
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), ()> {
        black_box(bytes);
        Ok(())
    }

    fn now_ms(&mut self) -> u32 {
        black_box(7)
    }
}

/// Commands whose type is known only at run time, and known ones.
fn ask(device: &mut Device<Line, 2, 600>, any: &AnyField) {
    let added = device.send_all(1, |request| request.add_any(any));
    if let Ok(ticket) = &added {
        black_box(ticket.id());
    }
    if let Ok(Some(packet)) = device.next_packet(7) {
        black_box(packet.bytes());
    }
    black_box(device.dropped());
}

#[no_mangle]
pub extern "C" fn _start() -> ! {
    let mut device: Device<_, 2, 600> = Device::with_client(Line, Client::new());
    let mut parser = Parser::new();
    let mut client: Client<4> = Client::new();
    let mut builder = PacketBuilder::new(0x80);
    loop {
        let mut rest = input();
        while let Some(packet) = parser.next(&mut rest) {
            look_into(&packet, &mut client, &mut builder);
        }
        black_box(rest);
        let mut packets = mip_protocol::packets(input());
        for packet in &mut packets {
            look_into(&packet, &mut client, &mut builder);
        }
        black_box((packets.skipped(), packets.remainder()));
        while let Some(packet) = parser.flush() {
            look_into(&packet, &mut client, &mut builder);
        }
        if let Some(Ok(found)) =
            &AnyField::decode_with_trailing(&RawField { set: 1, descriptor: 1, data: input() })
        {
            ask(&mut device, &found.field);
        }
        if let Ok(packet) = Packet::new(input()) {
            look_into(&packet, &mut client, &mut builder);
        }
        while let Some(packet) = client.poll(&mut parser, black_box(7)) {
            look_into(&packet, &mut client, &mut builder);
        }
        for event in client.events() {
            black_box(event);
        }
        black_box(parser.skipped());
    }
}

fn look_into(packet: &Packet<'_>, client: &mut Client<4>, builder: &mut PacketBuilder) {
    for event in client.receive(packet) {
        black_box(event);
    }
    for field in packet.fields().flatten() {
        look_at(&field, builder);
    }
    black_box(builder.bytes());
}

fn look_at(field: &RawField<'_>, builder: &mut PacketBuilder) {
    if let Some(Ok(reply)) = field.view::<Acknowledge>() {
        black_box((reply.command(), reply.code()));
    }
    let _ = black_box(dispatch!(field, {
        Acknowledge(reply) => black_box(reply.command),
        _ => 0,
    }));
    if let Some(Ok(found)) = AnyField::decode_with_trailing(field) {
        let mut data = [0; 253];
        if let Ok(length) = found.field.encode(&mut data) {
            if let Some(data) = data.get(..length) {
                let _ = black_box(builder.push_raw(field.descriptor, data));
            }
        }
        black_box((found.name(), found.title(), found.left_over));
    }
}
