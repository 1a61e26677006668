//! Packets, the stream parser, lists and text.

use mip_protocol::packet::{checksum, MAX_FIELD_DATA, MAX_PAYLOAD};
use mip_protocol::{
    measurements, packets, shared, tools, types, Clock, DescriptorSet, EncodeError,
    EncodeErrorKind, Field, Packet, PacketBuf, PacketBuilder, PacketError, PacketReader, Parser,
    RawField, Text, VarText,
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
    assert_eq!(fields, [Ok(RawField { set: DescriptorSet(1), descriptor: 1, data: &[] })]);
    assert_eq!(packet.find::<tools::Ping>(), Ok(Some(tools::Ping)));
    assert_eq!(packet.find::<tools::Inventory>(), Ok(None));
    assert_eq!(format!("{packet:?}"), "Packet(756501020201e0c6)");
}

#[test]
fn packets_and_fields_are_iterated() {
    let mut builder = PacketBuilder::new(measurements::MEASUREMENTS_SET);
    let accel =
        |x| measurements::Accel { scaled_accel: [x, 0.0, 0.0].into(), ..Default::default() };
    let both = [accel(1.0), accel(2.0)];
    builder.push(&both[0]).unwrap();
    builder.push(&measurements::Numbers::default()).unwrap();
    builder.push(&both[1]).unwrap();
    let mut log = builder.bytes().to_vec();
    log.extend(NMEA);
    log.extend(PING);
    let mut reader = PacketReader::new(&log[..]);
    let mut kept = Vec::new();
    for packet in &mut reader {
        kept.push(packet.unwrap());
    }
    assert_eq!((kept.len(), reader.parser().skipped()), (2, NMEA.len() as u64));
    let packet = kept[0].packet();
    assert_eq!(packet.find_all::<measurements::Accel>().collect::<Vec<_>>(), both.map(Ok));
    assert_eq!(packet.find_all::<tools::Ping>().count(), 0);
    let mut descriptors = Vec::new();
    for field in &kept[0] {
        descriptors.push(field.unwrap().descriptor);
    }
    assert_eq!(descriptors, packet.into_iter().map(|f| f.unwrap().descriptor).collect::<Vec<_>>());
    assert_eq!((&packet).into_iter().count(), 3);
    // A field of this type that its packet cuts is an error, and the last item.
    let payload = packet.payload();
    let mut cut = PacketBuilder::new(packet.set()).bytes()[..4].to_vec();
    cut.extend(&payload[..payload.len() - 1]);
    cut[3] = (payload.len() - 1) as u8;
    cut.extend(checksum(&cut));
    let cut = Packet::new(&cut).unwrap();
    let found: Vec<_> = cut.find_all::<measurements::Accel>().collect();
    assert_eq!((found.len(), found[0], found[1].is_err()), (2, Ok(both[0]), true));
    assert_eq!(cut.find_all::<measurements::Numbers>().count(), 1);
}

#[test]
fn fields_of_a_log_come_with_the_time_of_their_packet() {
    type Both = (measurements::Accel, Option<measurements::Numbers>);
    let accel = measurements::Accel { scaled_accel: [1.0, 2.0, 3.0].into(), ..Default::default() };
    let mut builder = PacketBuilder::new(measurements::MEASUREMENTS_SET);
    builder.push(&accel).unwrap();
    let mut log = [&PING, builder.bytes()].concat(); // the ping has neither
    builder.push(&measurements::Numbers::default()).unwrap();
    builder.push(&shared::Timestamp { tow: 1.5, valid_flags: types::StateFlags::READY }).unwrap();
    log.extend(builder.bytes());
    let found: Vec<_> = packets(&log).fields::<Both>().map(Result::unwrap).collect();
    let [(None, (_, None)), (Some(time), (_, Some(_)))] = found[..] else { panic!("{found:?}") };
    assert_eq!(found[0].1 .0, accel);
    assert_eq!((time.seconds(), Some(time.nanoseconds)), (1.5, packet_time(&builder, time.clock)));
    assert_eq!(time.to_string(), time.utc().map_or("1.5".into(), |utc| utc.to_string()));
    let mut reader = PacketReader::new(&log[..]);
    let read: Vec<_> = reader.fields::<Both>().map(Result::unwrap).collect();
    assert_eq!(read, found);
    // All must be there; one of several that may be absent.
    let of = |log| packets(log).fields::<(measurements::Accel, measurements::Numbers)>().count();
    assert_eq!(of(&log), 1);
    let optional = packets(&log).fields::<(Option<tools::Ping>, Option<measurements::Numbers>)>();
    assert_eq!(
        optional.map(|found| found.unwrap().1 .0.is_some()).collect::<Vec<_>>(),
        [true, false]
    );
    let cut =
        [&[0x75, 0x65, 0x80, 4, 14, measurements::Accel::DESCRIPTOR, 0, 0][..], &[0, 0]].concat();
    let cut = [&cut[..8], &checksum(&cut[..8])].concat();
    assert!(packets(&cut).fields::<Both>().next().unwrap().is_err());
    let error = PacketReader::new(&cut[..]).fields::<Both>().next().unwrap().unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidData);
}

fn packet_time(builder: &PacketBuilder, clock: Clock) -> Option<i64> {
    builder.packet().time(clock)
}

fn kind(error: EncodeError) -> EncodeErrorKind {
    error.kind
}

#[test]
fn packets_are_kept_and_built_on_without_checking_them_again() {
    let built = PacketBuilder::with(&tools::Ping).unwrap();
    let packet = Packet::from(&built);
    let kept = PacketBuf::from(packet);
    assert_eq!(kept, PacketBuf::from(&built));
    assert_eq!((kept.bytes(), kept.as_ref(), packet.as_ref()), (&PING[..], &PING[..], &PING[..]));
    assert_eq!((Packet::from(&kept), kept.packet()), (packet, packet));
    assert_eq!(format!("{kept:?}"), format!("{packet:?}"));
    assert_eq!(Vec::from(kept.clone()), PING);
    assert_eq!(PacketBuf::try_from(PING.to_vec()), Ok(kept.clone()));
    assert_eq!(PacketBuf::try_from(vec![0x75]), Err(PacketError::Sync));
    assert_eq!(PacketBuf::try_from(&PING[..]), Ok(kept.clone()));
    assert_eq!(PacketBuf::try_from(&PING[..7]), Err(PacketError::Length));
    assert_eq!(Packet::try_from(&PING[..]), Ok(packet));
    assert_eq!(Packet::try_from(&PING[1..]), Err(PacketError::Sync));
    let mut more = PacketBuilder::from(packet);
    assert_eq!(more, built);
    more.push(&tools::Inventory::default()).unwrap();
    assert_eq!(Packet::new(more.bytes()).unwrap().fields().count(), 2);
    assert!(more != built);
}

/// Byte by byte, as the protocol defines it.
fn fletcher(bytes: &[u8]) -> [u8; 2] {
    bytes.iter().fold([0, 0], |[a, b], byte| {
        let a = byte.wrapping_add(a);
        [a, a.wrapping_add(b)]
    })
}

#[test]
fn the_checksum_of_any_number_of_any_bytes_is_that_of_the_protocol() {
    let mixed: Vec<u8> = (0..5000_u32).map(|i| (i.wrapping_mul(0x9E37_79B1) >> 24) as u8).collect();
    // Miri takes minutes for more.
    let (few, long): (usize, &[usize]) =
        if cfg!(miri) { (70, &[]) } else { (600, &[2047, 2048, 2049, 4096, 5000]) };
    for bytes in [mixed, vec![0xFF; 5000], vec![0x01; 5000], vec![0x80; 5000]] {
        for length in (0..few).chain(long.iter().copied()) {
            assert_eq!(checksum(&bytes[..length]), fletcher(&bytes[..length]), "{length}");
            assert_eq!(checksum(&bytes[5000 - length..]), fletcher(&bytes[5000 - length..]));
        }
    }
}

#[test]
fn a_builder_refuses_what_does_not_fit_and_stays_valid() {
    let mut packet = PacketBuilder::new(tools::SET);
    packet.push_raw(0x70, &[0xAA; 200]).unwrap();
    let before = packet.bytes().to_vec();
    for data in [&[0; 54][..], &[0; 254]] {
        // one byte too many for the payload, and for any field
        assert_eq!(packet.push_raw(0x71, data).map_err(kind), Err(EncodeErrorKind::Length));
        assert_eq!(packet.bytes(), before);
    }
    // A field that fails half-way.
    let mut broken = tools::Settings::write(1, types::Mode::FAST, 9600).into_command();
    broken.mode = None;
    assert_eq!(packet.push(&broken).map_err(kind), Err(EncodeErrorKind::Missing));
    assert_eq!(packet.bytes(), before);
    // A field of another set.
    let own = measurements::Own { mode: types::Mode::SLOW };
    assert_eq!(packet.push(&own).map_err(kind), Err(EncodeErrorKind::Set));
    assert_eq!(packet.bytes(), before);
    // A field that just fits.
    packet.push_raw(0x71, &[0; 51]).unwrap();
    assert_eq!(packet.bytes().len(), MAX_PAYLOAD + 6);
    assert_eq!(packet.push(&tools::Ping).map_err(kind), Err(EncodeErrorKind::Length));
    assert_eq!(packet.packet().fields().count(), 2);
    packet.clear();
    assert_eq!(packet, PacketBuilder::new(tools::SET));
    assert!(Packet::new(packet.bytes()).is_ok());
    packet.push_raw(0x72, &[1; MAX_FIELD_DATA]).unwrap();
    assert!(Packet::new(packet.bytes()).is_ok());
}

// ----------------------------------------------------------------------------------------- parser

/// The header of this packet ends with the checksum of what is in front of it.
#[test]
fn a_header_is_no_packet() {
    let mut packet = PacketBuilder::new(DescriptorSet(0xDA));
    packet.push_raw(0x01, &[0; 0x4F - 2]).unwrap();
    let bytes = packet.bytes();
    assert_eq!(checksum(&bytes[..2]), bytes[2..4]);
    for cut in 1..bytes.len() {
        let (mut parser, mut found) = (Parser::new(), 0);
        for part in [&bytes[..cut], &bytes[cut..]] {
            parser.feed(part).for_each(|_| found += 1);
        }
        assert_eq!((found, parser.skipped()), (1, 0), "{cut}");
    }
}

#[test]
fn what_is_not_asked_for_stays_in_the_chunk() {
    let mut parser = Parser::new();
    let stream = [&PING[..], &PING, b"no", &PING[..5]].concat();
    let mut chunk = &stream[..];
    assert_eq!(parser.next(&mut chunk).unwrap().bytes(), PING);
    assert_eq!(chunk, &stream[8..]);
    assert_eq!((parser.pending(), parser.skipped()), (0, 0));
    assert_eq!(parser.next(&mut chunk).unwrap().bytes(), PING);
    assert!(parser.next(&mut chunk).is_none() && parser.next(&mut chunk).is_none());
    assert!(chunk.is_empty());
    assert_eq!(parser.next(&mut &PING[5..]).unwrap().bytes(), PING);
    assert_eq!((parser.pending(), parser.skipped()), (0, 2));
}

#[test]
fn an_error_ends_the_search_of_a_chunk() {
    let mut parser = Parser::new();
    let stream = PING.repeat(3);
    let mut count = 0;
    let result = parser.feed(&stream).try_for_each(|_| {
        count += 1;
        if count < 2 {
            Ok(())
        } else {
            Err(count)
        }
    });
    assert_eq!((result, count), (Err(2), 2));
    let mut all = 0;
    let result: Result<(), ()> = parser.feed(&stream).try_for_each(|_| {
        all += 1;
        Ok(())
    });
    assert_eq!((result, all, parser.pending()), (Ok(()), 3, 0));
}

#[test]
fn the_packets_of_a_slice_borrow_it() {
    let noise: &[u8] = b"ue\x80\xFF";
    let stream = [&PING[..], noise, &PING, NMEA, &PING[..7]].concat();
    let mut found = packets(&stream);
    assert_eq!(found.next().map(|packet| packet.bytes()), Some(&PING[..]));
    assert_eq!((found.skipped(), found.remainder()), (0, &stream[8..]));
    let last = {
        let all: Vec<Packet<'_>> = found.by_ref().collect(); // one of them is behind a false sync
        assert_eq!(all.len(), 1);
        all[0]
    };
    assert_eq!(last.bytes().as_ptr(), stream[12..].as_ptr());
    for _ in 0..2 {
        assert_eq!(found.next(), None);
        assert_eq!((found.skipped(), found.remainder()), (4 + NMEA.len(), &PING[..7]));
    }
    let mut none = packets(&[]);
    assert_eq!((none.next(), none.skipped(), none.remainder()), (None, 0, &[][..]));
    let mut open = packets(b"xue\x80\xFFue\x80"); // the first of two candidates may be the packet
    assert_eq!((open.next(), open.skipped(), open.remainder().len()), (None, 1, 7));
    let mut noise = packets(b"uuxu");
    assert_eq!((noise.next(), noise.skipped(), noise.remainder()), (None, 3, &b"u"[..]));
}

/// A port that returns one piece of the list for each read; some are empty.
struct Pieces(Vec<std::io::Result<&'static [u8]>>);

impl std::io::Read for Pieces {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let piece = if self.0.is_empty() { Ok(&[][..]) } else { self.0.remove(0) }?;
        buffer[..piece.len()].copy_from_slice(piece);
        Ok(piece.len())
    }
}

#[test]
fn a_source_that_pauses_loses_no_packet() {
    let pause = || Err(std::io::ErrorKind::WouldBlock.into());
    let interrupted = || Err(std::io::ErrorKind::Interrupted.into());
    let (head, tail): (&[u8], &[u8]) = (b"\x75\x65\x01", b"\x02\x02\x01\xE0\xC6");
    let pieces =
        vec![Ok(head), Ok(&[][..]), Ok(tail), Ok(head), pause(), interrupted(), Ok(tail), Ok(head)];
    let mut packets = PacketReader::new(Pieces(pieces));
    assert!(packets.next_packet().unwrap().is_none()); // nothing for now
    assert_eq!(packets.parser().pending(), 3);
    assert_eq!(packets.next_packet().unwrap().unwrap().bytes(), PING);
    let error = packets.next_packet().unwrap_err();
    assert_eq!((error.kind(), packets.parser().pending()), (std::io::ErrorKind::WouldBlock, 3));
    assert_eq!(packets.next_packet().unwrap().unwrap().bytes(), PING);
    for _ in 0..2 {
        assert!(packets.next_packet().unwrap().is_none());
        assert_eq!((packets.parser().pending(), packets.parser().skipped()), (3, 0));
    }
    assert!(packets.get_ref().0.is_empty() && packets.get_mut().0.is_empty());
    assert!(packets.into_inner().0.is_empty());
}

// ---------------------------------------------------------------------------------- lists and text

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
