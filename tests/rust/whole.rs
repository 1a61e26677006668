//! All generic functions of the crate with each type that they are for, so that they are compiled. The test writes
//! `every_command`.

#![no_std]

use core::hint::black_box;

use mip_protocol::device::{Device, Port};
use mip_protocol::registry::{visit, Listed, Visitor};
use mip_protocol::{
    AnyField, Client, Command, DescriptorSet, EncodeError, Field, List, Packet, PacketBuilder,
    RawField,
};

pub struct Line;

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

pub struct Each<'a> {
    packet: Packet<'a>,
    builder: &'a mut PacketBuilder,
    buffer: &'a mut [u8],
}

impl Each<'_> {
    fn field<T: Field>(&mut self, field: &RawField<'_>) -> Result<(), EncodeError> {
        black_box((
            T::occurs_in(field.set),
            field.is::<T>(),
            field.get::<T>(),
            self.packet.find::<T>(),
        ));
        if let Ok((value, _)) = T::decode_with_trailing(field.data) {
            black_box(T::decode(field.data).is_ok());
            black_box(value.encode(self.buffer)?);
            self.builder.push(&value)?;
        }
        Ok(())
    }
}

impl Visitor for Each<'_> {
    type Output = Result<(), EncodeError>;

    fn visit<T: Listed>(mut self, field: &RawField<'_>) -> Self::Output {
        if let Ok(value) = T::decode(field.data) {
            black_box(value == value.clone());
            black_box(value.into_any());
        }
        self.field::<T>(field)
    }

    fn unknown(self, field: &RawField<'_>) -> Self::Output {
        self.builder.push_raw(field.descriptor, field.data)
    }
}

pub fn every_field(field: &RawField<'_>, each: Each<'_>) -> Result<(), EncodeError> {
    visit(field, each)
}

pub fn list(list: &mut List<u16, 5>, other: &[u16]) -> bool {
    list.extend(other);
    black_box((list.push(7), list.pop()));
    *list == List::from(other) && list.iter().eq(&[7])
}

type Parts<'a> = (&'a mut Client<2>, &'a mut Device<Line, 2, 600>, Packet<'a>);

pub fn command<C: Command>(command: &C, (client, device, packet): Parts<'_>) {
    black_box(device.request(command).is_ok());
    black_box((command.expects_reply(), C::TIMEOUT_MS));
    let mut request = client.request(C::SET);
    black_box(request.add(command).is_ok());
    black_box(request.send(7));
    let Ok((ticket, sent)) = client.send(command, 7) else { return };
    black_box(sent);
    for event in client.receive(&packet) {
        black_box(event.answer(&ticket).is_some_and(|answer| answer.is_ok()));
        black_box(event.response());
    }
    black_box((
        client.is_pending(&ticket),
        client.take(&ticket).is_some(),
        client.take_event(&ticket),
    ));
    client.cancel(&ticket);
}

pub fn any(field: &AnyField, device: &mut Device<Line, 2, 600>) -> bool {
    device.send_all(DescriptorSet(1), |request| request.add_any(field)).is_ok()
}
