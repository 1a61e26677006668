//! Packets, the stream parser, lists and text.

#![allow(deprecated)] // of the fields that are tested here

use mip_protocol::packet::{checksum, MAX_FIELD_DATA, MAX_PAYLOAD};
use mip_protocol::{measurements, more, protocol, shared, tools, types};
use mip_protocol::{
    EncodeErrorKind, Field, FieldLengthError, List, Packet, PacketBuilder, PacketError,
    PacketReader, Parser, RawField, Text, VarText,
};

const PING: [u8; 8] = [0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6];
const NMEA: &[u8] = b"$GPGGA,123519,4807.038,N*47\r\n";

// ---------------------------------------------------------------------------------------- packets

#[test]
fn a_packet_is_built_and_looked_into() {
    let packet = PacketBuilder::with(&tools::Ping::new()).unwrap();
    assert_eq!(packet.bytes(), PING);
    assert_eq!(packet.as_ref(), PING);
    let packet = Packet::new(packet.bytes()).unwrap();
    assert_eq!((packet.set(), packet.payload()), (tools::SET, &PING[4..6]));
    let fields: Vec<_> = packet.fields().collect();
    assert_eq!(fields, [Ok(RawField { set: 1, descriptor: 1, data: &[] })]);
    assert_eq!(packet.find::<tools::Ping>(), Some(Ok(tools::Ping)));
    assert_eq!(packet.find::<tools::Inventory>(), None);
    assert_eq!(format!("{packet:?}"), "Packet(756501020201e0c6)");
}

#[test]
fn an_empty_packet_is_legal() {
    let packet = PacketBuilder::new(0x80);
    assert_eq!(packet.bytes(), [0x75, 0x65, 0x80, 0x00, 0x5A, 0x03]);
    assert_eq!(packet.packet().fields().count(), 0);
    assert!(Packet::new(packet.bytes()).is_ok());
}

#[test]
fn what_is_no_packet_is_refused() {
    assert_eq!(Packet::new(&[]), Err(PacketError::Sync));
    assert_eq!(Packet::new(&[0x75]), Err(PacketError::Sync));
    assert_eq!(Packet::new(&[0x75, 0x66, 1, 0, 0, 0]), Err(PacketError::Sync));
    for length in 2..PING.len() {
        assert_eq!(Packet::new(&PING[..length]), Err(PacketError::Length), "{length}");
    }
    assert_eq!(Packet::new(&[&PING[..], &[0]].concat()), Err(PacketError::Length));
    let set_0 = [0x75, 0x65, 0x00, 0x00, 0xDA, 0x03];
    assert_eq!(checksum(&set_0[..4]), set_0[4..]);
    assert_eq!(Packet::new(&set_0), Err(PacketError::Length));
    for bit in 0..16 {
        let mut bytes = PING;
        bytes[6 + bit / 8] ^= 1 << (bit % 8);
        assert_eq!(Packet::new(&bytes), Err(PacketError::Checksum));
    }
}

#[test]
fn a_malformed_field_ends_the_walk_and_keeps_what_was_before() {
    for bad in [&[0_u8, 1][..], &[1, 1], &[3, 1], &[255, 1, 0], &[2]] {
        let payload = [&[2, 1, 3, 9, 7][..], bad].concat();
        let head = [&[0x75, 0x65, 0x01, payload.len() as u8][..], &payload].concat();
        let bytes = [&head[..], &checksum(&head)].concat();
        let mut fields = Packet::new(&bytes).unwrap().fields();
        assert_eq!(fields.next().unwrap().unwrap().descriptor, 1);
        assert_eq!(fields.next().unwrap().unwrap().data, [7]);
        assert_eq!(fields.next(), Some(Err(FieldLengthError)));
        assert_eq!(fields.next(), None);
        assert_eq!(fields.next(), None);
    }
}

#[test]
fn a_builder_refuses_what_does_not_fit_and_stays_valid() {
    let mut packet = PacketBuilder::new(tools::SET);
    packet.push_raw(0x70, &[0xAA; 200]).unwrap();
    let before = packet.bytes().to_vec();
    for (data, error) in [
        (&[0; 54][..], EncodeErrorKind::Length), // one byte too many for the payload
        (&[0; 253], EncodeErrorKind::Length),
        (&[0; 254], EncodeErrorKind::Length), // too much for any field
        (&[0; 1000], EncodeErrorKind::Length),
    ] {
        assert_eq!(packet.push_raw(0x71, data).map_err(|e| e.kind), Err(error));
        assert_eq!(packet.bytes(), before);
        assert!(Packet::new(packet.bytes()).is_ok());
    }
    // A field that fails half-way.
    let mut broken = tools::Settings::write(1, types::Mode::FAST, 9600);
    broken.mode = None;
    assert_eq!(packet.push(&broken).map_err(|e| e.kind), Err(EncodeErrorKind::Missing));
    assert_eq!(packet.bytes(), before);
    // A field of another set.
    assert_eq!(packet.push(&more()).map_err(|e| e.kind), Err(EncodeErrorKind::Set));
    assert_eq!(packet.bytes(), before);
    // What just fits.
    packet.push_raw(0x71, &[0; 51]).unwrap();
    assert_eq!(packet.bytes().len(), MAX_PAYLOAD + 6);
    assert_eq!(packet.push(&tools::Ping).map_err(|e| e.kind), Err(EncodeErrorKind::Length));
    assert_eq!(packet.packet().fields().count(), 2);
    packet.clear();
    assert_eq!((packet.set(), packet.bytes().len()), (tools::SET, 6));
    packet.push_raw(0x72, &[1; MAX_FIELD_DATA]).unwrap();
    assert!(Packet::new(packet.bytes()).is_ok());
}

fn more() -> mip_protocol::more::Own {
    mip_protocol::more::Own { mode: types::Mode::SLOW }
}

#[test]
fn sets_take_their_own_and_the_shared_fields() {
    let stamp = shared::Timestamp::default();
    for set in [0x80, 0x81, 0xFE, 0xFF] {
        assert!(PacketBuilder::new(set).push(&stamp).is_ok());
    }
    assert_eq!(
        PacketBuilder::new(0x7F).push(&stamp).map_err(|e| e.kind),
        Err(EncodeErrorKind::Set)
    );
    let accel = measurements::Accel::default();
    assert!(PacketBuilder::new(0x80).push(&accel).is_ok());
    assert!(PacketBuilder::new(0x80).push(&accel).is_ok());
    assert!(PacketBuilder::new(0x81).push(&more::Accel::default()).is_ok());
    assert_eq!(
        PacketBuilder::new(0x82).push(&accel).map_err(|e| e.kind),
        Err(EncodeErrorKind::Set)
    );
    let health = measurements::Health::default();
    assert_eq!(
        PacketBuilder::new(0x81).push(&health).map_err(|e| e.kind),
        Err(EncodeErrorKind::Set)
    );
    let ack = protocol::Acknowledge::default();
    assert!(PacketBuilder::new(0x01).push(&ack).is_ok());
    assert!(PacketBuilder::new(0x7F).push(&ack).is_ok());
    assert_eq!(PacketBuilder::new(0x80).push(&ack).map_err(|e| e.kind), Err(EncodeErrorKind::Set));
    assert_eq!(PacketBuilder::new(0).push(&ack).map_err(|e| e.kind), Err(EncodeErrorKind::Set));
    assert_eq!(
        PacketBuilder::new(0).push_raw(1, &[]).map_err(|e| e.kind),
        Err(EncodeErrorKind::Set)
    );
}

// ----------------------------------------------------------------------------------------- parser

/// Packets and the number of skipped bytes, fed in chunks that end at these places.
fn parse(stream: &[u8], cuts: &[usize]) -> (Vec<Vec<u8>>, u64) {
    let mut parser = Parser::new();
    let mut packets = Vec::new();
    let mut start = 0;
    for end in cuts.iter().copied().chain([stream.len()]) {
        let mut chunk = &stream[start..end];
        while let Some(packet) = parser.next(&mut chunk) {
            packets.push(packet.bytes().to_vec());
        }
        assert!(chunk.is_empty());
        start = end;
    }
    while let Some(packet) = parser.flush() {
        packets.push(packet.bytes().to_vec());
    }
    assert_eq!(parser.pending(), 0);
    let whole: usize = packets.iter().map(Vec::len).sum();
    assert_eq!(whole as u64 + parser.skipped(), stream.len() as u64);
    (packets, parser.skipped())
}

#[test]
fn every_chunking_gives_the_same_packets() {
    let accel = PacketBuilder::with(&measurements::Accel::default()).unwrap();
    let mut broken = PING;
    broken[7] ^= 1;
    let parts: [&[u8]; 12] = [
        b"u",
        &PING,
        NMEA,
        &broken,
        b"ue",
        accel.bytes(),
        b"ue\x00",
        &PING,
        &[0x75, 0x65, 0x80, 0x20], // begins a packet that swallows the next ones
        &PING,
        accel.bytes(),
        b"ueu",
    ];
    let stream = parts.concat();
    let wanted = parse(&stream, &[]);
    assert_eq!(wanted.0.len(), 5);
    for cut in 0..=stream.len() {
        assert_eq!(parse(&stream, &[cut]), wanted, "{cut}");
        for next in cut..=stream.len() {
            assert_eq!(parse(&stream, &[cut, next]), wanted, "{cut} {next}");
        }
    }
    let every: Vec<usize> = (0..stream.len()).collect();
    assert_eq!(parse(&stream, &every), wanted);
}

#[test]
fn flush_loses_no_packet_inside_of_what_it_gives_up() {
    let mut parser = Parser::new();
    let stream = [&[0x75, 0x65, 0x80, 0xFF][..], &PING, &PING, b"ue"].concat();
    let mut chunk = &stream[..];
    assert!(parser.next(&mut chunk).is_none());
    assert_eq!((parser.pending(), parser.skipped()), (stream.len(), 0));
    assert_eq!(parser.flush().unwrap().bytes(), PING);
    assert_eq!(parser.flush().unwrap().bytes(), PING);
    assert!(parser.flush().is_none());
    assert_eq!((parser.pending(), parser.skipped()), (0, 6));
    // It goes on as if nothing had been.
    let mut chunk = &PING[..];
    assert_eq!(parser.next(&mut chunk).unwrap().bytes(), PING);
    assert!(parser.flush().is_none());
    assert_eq!(parser.skipped(), 6);
}

#[test]
fn a_packet_that_was_given_is_not_given_again_by_flush() {
    let mut parser = Parser::new();
    let (mut first, mut second) = (&PING[..3], &PING[3..]);
    assert!(parser.next(&mut first).is_none());
    assert_eq!(parser.next(&mut second).unwrap().bytes(), PING);
    assert_eq!(parser.pending(), 0);
    assert!(parser.flush().is_none());
    assert_eq!(parser.skipped(), 0);
}

#[test]
fn long_garbage_full_of_false_syncs_passes() {
    let mut stream = b"ue\x80\xFF".repeat(2000);
    stream.extend(b"uu".repeat(3000));
    stream.extend(PING);
    for chunk in [1, 7, 261, 4096] {
        let cuts: Vec<usize> = (0..stream.len()).step_by(chunk).collect();
        let (packets, skipped) = parse(&stream, &cuts);
        assert_eq!(packets, [PING]);
        assert_eq!(skipped, 14_000);
    }
}

/// Gives little at a time, with interruptions and a time-out.
struct Line<'a>(&'a [u8], usize);

impl std::io::Read for Line<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        self.1 += 1;
        match self.1 % 5 {
            1 => Err(std::io::ErrorKind::Interrupted.into()),
            3 => Err(std::io::ErrorKind::TimedOut.into()),
            n => std::io::Read::read(&mut self.0, &mut buffer[..n + 1]),
        }
    }
}

#[test]
fn packets_of_a_source() {
    let stream = [NMEA, &PING, &PING, b"ue\x80\xFF", &PING].concat();
    let mut packets = PacketReader::new(Line(&stream, 0));
    let (mut found, mut late) = (0, 0);
    loop {
        match packets.next_packet() {
            Ok(Some(packet)) => found += usize::from(packet.bytes() == PING),
            Ok(None) => break,
            Err(error) => {
                assert_eq!(error.kind(), std::io::ErrorKind::TimedOut);
                late += 1;
            }
        }
    }
    assert_eq!(found, 3);
    assert!(late > 0);
    assert_eq!(packets.parser().skipped(), NMEA.len() as u64 + 4);
}

// ---------------------------------------------------------------------------------- lists and text

#[test]
fn a_list_holds_what_fits() {
    let mut list = List::<u8, 3>::new();
    assert!(list.is_empty());
    for n in 1..=3 {
        list.push(n).unwrap();
    }
    assert_eq!(list.push(4).map_err(|e| (e.need, e.got)), Err((4, 3)));
    assert_eq!(*list, [1, 2, 3]);
    list[1] = 7;
    list.as_mut_slice().reverse();
    assert_eq!(list, List::from([3, 7, 1]));
    assert_eq!(List::<u8, 3>::from_slice(&[0; 4]).map_err(|e| e.need), Err(4));
    assert_eq!(List::<u8, 3>::try_from(&[9][..]), Ok([9].into()));
    assert_ne!(List::<u8, 3>::from([1]), List::from([1, 2]));
    assert_eq!(format!("{list:?}"), "[3, 7, 1]");
    assert_eq!((&list).into_iter().copied().max(), Some(7));
    list.clear();
    assert_eq!(list, List::default());
    let mut none = List::<u8, 0>::new();
    assert_eq!(none.push(1).map_err(|e| e.got), Err(0));
}

#[test]
fn text_is_latin_1_and_keeps_its_bytes() {
    let text = Text::<8>::padded("naïve").unwrap();
    assert_eq!(&text.0, b"na\xEFve   ");
    assert_eq!(text.to_string(), "naïve");
    assert!(text.as_str().is_err());
    assert_eq!(text.chars().collect::<String>(), "naïve   ");
    assert_eq!(format!("{text:?}"), "\"naïve   \"");
    assert_eq!(Text::<4>::padded("12345"), None);
    assert_eq!(Text::<4>::padded("€"), None);
    assert_eq!(Text(*b"ab \0").as_str(), Ok("ab"));
    assert_eq!(Text(*b"    ").as_str(), Ok(""));
    assert_eq!(&Text::<2>::default().0, b"  ");
    let text = VarText::<8>::new("abc ").unwrap();
    assert_eq!((text.len(), text.is_empty(), text.as_str()), (4, false, Ok("abc")));
    assert_eq!(text.to_string(), "abc");
    assert_eq!(VarText::<2>::new("abc"), None);
    assert_eq!(VarText::<2>::new("€"), None);
}

#[test]
fn strings_come_back_byte_for_byte() {
    let mut field = measurements::Strings {
        model: Text::padded("MODEL").unwrap(),
        name: VarText::new("abc").unwrap(),
        rest: VarText::new("").unwrap(),
    };
    assert_eq!(field.to_vec().unwrap(), b"MODEL           \x03abc");
    field.rest = VarText::new("and more").unwrap();
    let data = field.to_vec().unwrap();
    assert_eq!(data, b"MODEL           \x03abcand more");
    assert_eq!(measurements::Strings::decode(&data), Ok(field));
}
