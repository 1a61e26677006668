//! What fuzzing runs on any bytes. Inputs have the same form as those of C, with the same
//! seeds: see the heads of `parser.c` and `fields.c` in `tests/c/fuzz`.

use mip_protocol::registry::{visit, Listed, Visitor};
use mip_protocol::{checksum, packets, AnyField, Packet, PacketBuilder, Parser, RawField};

type Target = fn(&[u8]);

/// All targets.
pub const TARGETS: [(&str, Target); 2] = [("parser", parser), ("fields", fields)];

/// Reads an input from its front; behind its end are zeros.
struct Input<'a>(&'a [u8]);

impl<'a> Input<'a> {
    fn byte(&mut self) -> u8 {
        self.bytes(1).first().copied().unwrap_or_default()
    }

    /// The next bytes, at most `count`.
    fn bytes(&mut self, count: usize) -> &'a [u8] {
        let (head, tail) = self.0.split_at(count.min(self.0.len()));
        self.0 = tail;
        head
    }
}

// --------------------------------------------------------------------------------- parser

/// A parser that keeps the whole stream and tries every place in order.
struct Plain<'a> {
    stream: &'a [u8],
    /// Bytes processed.
    at: usize,
    skipped: u64,
}

impl<'a> Plain<'a> {
    /// What is at a position: a packet (its size), nothing (0), or the start of a possible packet.
    fn size_at(&self, at: usize) -> Option<usize> {
        let rest = &self.stream[at..];
        match *rest {
            [0x75] | [0x75, 0x65] | [0x75, 0x65, 1..=254] => None,
            [0x75, 0x65, 1..=254, length, ..] => {
                let end = usize::from(length) + 4;
                let sums = rest.get(end..end + 2)?;
                let (mut a, mut b) = (0_u8, 0_u8);
                for byte in &rest[..end] {
                    a = a.wrapping_add(*byte);
                    b = b.wrapping_add(a);
                }
                Some(if sums == [a, b] { end + 2 } else { 0 })
            }
            _ => Some(0),
        }
    }

    fn skip(&mut self, count: usize) {
        self.at += count;
        self.skipped += count as u64;
    }

    fn next(&mut self) -> Option<&'a [u8]> {
        while self.at < self.stream.len() {
            match self.size_at(self.at)? {
                0 => self.skip(1),
                size => {
                    self.at += size;
                    return Some(&self.stream[self.at - size..self.at]);
                }
            }
        }
        None
    }

    fn flush(&mut self) -> Option<&'a [u8]> {
        loop {
            let found = self.next();
            if found.is_some() || self.at == self.stream.len() {
                return found;
            }
            self.skip(1);
        }
    }

    fn look_behind(&mut self) -> Option<&'a [u8]> {
        let found = self.next();
        if found.is_some() {
            return found;
        }
        let mut behind = self.at + 1..self.stream.len();
        let at = behind.find(|at| self.size_at(*at).is_some_and(|size| size > 0))?;
        self.skip(at - self.at);
        self.next()
    }
}

/// Checks that both find the same; true if that is a packet.
fn same(found: Option<Packet<'_>>, plain: Option<&[u8]>) -> bool {
    assert_eq!(found.map(|packet| packet.bytes()), plain);
    if let Some(packet) = found {
        assert_eq!(Packet::new(packet.bytes()), Ok(packet));
    }
    found.is_some()
}

/// The stream parser, with pieces of any size, and what may happen between them, against [`Plain`].
pub fn parser(data: &[u8]) {
    let mut input = Input(data);
    let (pieces, events) = (input.byte(), input.byte());
    let stream = input.0;
    let mut random = u32::from(pieces) << 8 | u32::from(events);
    let mut plain = Plain { stream: &[], at: 0, skipped: 0 };
    let mut parser = Parser::new();
    let mut found = Vec::new();
    while !input.0.is_empty() {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let mut piece = input.bytes(match pieces {
            0 => stream.len(),
            1..=127 => pieces.into(),
            _ => random as usize / (1 << 24) % (usize::from(pieces) - 127) + 1,
        });
        plain.stream = &stream[..stream.len() - input.0.len()];
        loop {
            let next = plain.next();
            found.extend(next);
            if !same(parser.next(&mut piece), next) {
                break;
            }
            assert_eq!(parser.skipped(), plain.skipped);
        }
        assert!(piece.is_empty());
        let between = if events > 0 { random >> 16 & 0xFF } else { 0xFF };
        while between < 16 && same(parser.flush(), plain.flush()) {}
        while between < 32 && same(parser.look_behind(), plain.look_behind()) {}
        // The parser checks the header of a candidate once all four bytes are there.
        let late = parser.skipped() as usize + parser.pending();
        assert_eq!(late, plain.skipped as usize + plain.stream.len() - plain.at);
    }
    loop {
        let next = plain.flush();
        found.extend(next);
        if !same(parser.flush(), next) {
            break;
        }
    }
    assert_eq!((parser.skipped(), parser.pending()), (plain.skipped, 0));
    if events == 0 {
        let all: Vec<&[u8]> = packets(stream).map(|packet| packet.bytes()).collect();
        assert_eq!(all, found);
    }
}

// --------------------------------------------------------------------------------- fields

/// Decodes, encodes and decodes a field as its type.
struct Codec {
    lack: usize,
}

impl Visitor for Codec {
    type Output = ();

    fn visit<T: Listed>(self, field: &RawField<'_>) {
        assert_eq!(T::INFO.descriptor, field.descriptor);
        assert!(T::INFO.occurs_in(field.set));
        let decoded = T::decode_with_trailing(field.data);
        assert!(field.is::<T>() || decoded.is_err());
        let any = AnyField::decode_with_trailing(field).map(|any| any.expect("it is known"));
        let (value, left_over) = match decoded {
            Ok(decoded) => decoded,
            Err(error) => {
                assert_eq!(T::decode(field.data).err(), Some(error));
                assert_eq!(any.err(), Some(error));
                return;
            }
        };
        let any = any.expect("both decode it");
        assert_eq!((any.set, any.left_over), (field.set, left_over));
        let known = &field.data[..field.data.len() - left_over];
        let mut buffer = [0; 253];
        let encode = |value: &AnyField, buffer: &mut [u8]| value.encode(buffer);
        for again in [&any.field, &value.clone().into_any(), &through_a_tree(&any.field)] {
            buffer.fill(0xAA);
            assert_eq!(encode(again, &mut buffer), Ok(known.len()));
            assert_eq!(&buffer[..known.len()], known);
        }
        // With too little room, it cannot be encoded.
        if let Some(room) = known.len().checked_sub(1 + self.lack) {
            assert!(value.encode(&mut buffer[..room]).is_err());
        }
        let mut builder = PacketBuilder::new(field.set);
        builder.push_raw(0x7E, &[1, 2, 3]).expect("it fits");
        let before = builder.bytes().to_vec();
        if builder.push(&value).is_err() {
            assert!(known.len() + 2 > 255 - 5);
            assert_eq!(builder.bytes(), before);
        }
        assert_eq!(Packet::new(builder.bytes()), Ok(builder.packet()));
    }

    fn unknown(self, field: &RawField<'_>) {
        assert_eq!(AnyField::decode(field), Ok(None));
    }
}

fn through_a_tree(field: &AnyField) -> AnyField {
    AnyField::from_value(field.info().name, &field.to_value()).expect("it is its own tree")
}

/// Every layout of a descriptor; and what a walk and a builder make of any payload.
pub fn fields(data: &[u8]) {
    let mut input = Input(data);
    let (flags, set, descriptor, lack) = (input.byte(), input.byte(), input.byte(), input.byte());
    let lack = lack.into();
    if set == 0 || set == 0xFF {
        return; // no packet has them
    }
    if flags & 0x80 == 0 {
        let data = input.bytes(253);
        visit(&RawField { set: set.into(), descriptor, data }, Codec { lack });
        return;
    }
    let payload = input.bytes(255);
    let bytes = packet(set, payload);
    let mut walk = Packet::new(&bytes).expect("it is a packet").fields();
    let mut builder = PacketBuilder::new(set.into());
    let mut rest = payload;
    while let Some(data) = rest.first().and_then(|length| rest.get(2..usize::from(*length))) {
        let field = walk.next().and_then(Result::ok).expect("there is one");
        assert_eq!(field, RawField { set: set.into(), descriptor: rest[1], data });
        builder.push_raw(field.descriptor, field.data).expect("it came from a packet");
        visit(&field, Codec { lack });
        rest = &rest[data.len() + 2..];
    }
    assert_eq!(walk.next().map(|last| last.is_err()), (!rest.is_empty()).then_some(true));
    assert!(walk.next().is_none());
    assert_eq!(builder.packet().payload(), &payload[..payload.len() - rest.len()]);
}

fn packet(set: u8, payload: &[u8]) -> Vec<u8> {
    let mut bytes = [&[0x75, 0x65, set, payload.len() as u8], payload].concat();
    bytes.extend(checksum(&bytes));
    bytes
}
