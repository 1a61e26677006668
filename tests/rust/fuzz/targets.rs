//! What fuzzing runs on any bytes. Inputs have the same form as those of C, with the same
//! seeds: see the heads of `parser.c`, `fields.c` and `client.c` in `tests/c/fuzz`.

use mip_protocol::registry::{visit, FieldInfo, Listed, Visitor};
use mip_protocol::{checksum, packets, AnyField, Client, Event, Packet, PacketBuilder, Parser};
use mip_protocol::{Outcome, RawField, Role, Ticket};

type Target = fn(&[u8]);

/// All targets.
pub const TARGETS: [(&str, Target); 3] =
    [("parser", parser), ("fields", fields), ("client", client)];

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

    /// A count, and then that many bytes.
    fn counted(&mut self, most: usize) -> &'a [u8] {
        let count = usize::from(self.byte()) % (most + 1);
        self.bytes(count)
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
        let any = AnyField::decode_with_trailing(field).expect("it is known");
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
        assert!(AnyField::decode(field).is_none());
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
        visit(&RawField { set, descriptor, data }, Codec { lack });
        return;
    }
    let payload = input.bytes(255);
    let bytes = packet(set, payload);
    let mut walk = Packet::new(&bytes).expect("it is a packet").fields();
    let mut builder = PacketBuilder::new(set);
    let mut rest = payload;
    while let Some(data) = rest.first().and_then(|length| rest.get(2..usize::from(*length))) {
        let field = walk.next().and_then(Result::ok).expect("there is one");
        assert_eq!(field, RawField { set, descriptor: rest[1], data });
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

// --------------------------------------------------------------------------------- client

const SLOTS: usize = 4;
/// Milliseconds after which every request is late.
const LONGEST: u32 = 10_000_000;

struct Session {
    client: Client<SLOTS>,
    parser: Parser,
    now: u32,
    /// The last command sent from each slot.
    sent: [Option<Sent>; SLOTS],
    /// The requests that have not ended.
    waiting: Vec<Ticket<()>>,
}

#[derive(Clone, Copy)]
struct Sent {
    set: u8,
    info: &'static FieldInfo,
    ticket: Ticket<()>,
}

impl Session {
    fn send(&mut self, input: &mut Input<'_>) {
        let slot = usize::from(input.byte()) % SLOTS;
        let (set, descriptor) = (input.byte(), input.byte());
        input.byte(); // which response C expects
        let data = input.counted(253);
        let Some(Ok(command)) = AnyField::decode(&RawField { set, descriptor, data }) else {
            return;
        };
        let info = command.info();
        if let Some(packet) = self.client.barrier() {
            assert_eq!(Packet::new(packet.bytes()), Ok(packet));
        }
        let mut request = self.client.request(set);
        let added = request.add_any(&command);
        let ticket = match added {
            Ok(ticket) => ticket,
            Err(_) => return,
        };
        assert_eq!(info.role, Role::Command);
        let packet = request.send(self.now);
        let sent = packet.fields().next().and_then(Result::ok).expect("the command");
        assert_eq!((sent.set, sent.descriptor), (set, descriptor));
        assert!(data.starts_with(sent.data));
        self.sent[slot] = Some(Sent { set, info, ticket });
        if !ticket.is_silent() {
            self.waiting.push(ticket);
        }
    }

    fn answer(&mut self, input: &mut Input<'_>, piece: usize) {
        let slot = usize::from(input.byte()) % SLOTS;
        let (code, choice) = (input.byte(), input.byte());
        let data = input.counted(249);
        let Some(Sent { set, info, .. }) = self.sent[slot] else { return };
        let mut answer = PacketBuilder::new(set);
        answer.push_raw(0xF1, &[info.descriptor, code]).expect("it fits");
        if let Some(response) = info.linked.get(usize::from(choice)) {
            let response = FieldInfo::by_name(response).expect("it is listed");
            answer.push_raw(response.descriptor, data).expect("it fits");
        }
        self.arrive(answer.bytes(), piece);
    }

    fn arrive(&mut self, bytes: &[u8], piece: usize) {
        for mut piece in bytes.chunks(if piece > 0 { piece } else { bytes.len().max(1) }) {
            while let Some(packet) = self.parser.next(&mut piece) {
                take(&mut self.client, &mut self.waiting, &packet);
            }
            self.poll();
        }
    }

    fn poll(&mut self) {
        while let Some(packet) = self.client.poll(&mut self.parser, self.now) {
            take(&mut self.client, &mut self.waiting, &packet);
        }
        for event in self.client.events() {
            ended(&mut self.waiting, event);
        }
    }

    fn flush(&mut self) {
        while let Some(packet) = self.parser.flush() {
            take(&mut self.client, &mut self.waiting, &packet);
        }
        self.poll();
    }

    fn cancel(&mut self, slot: usize) {
        if let Some(Sent { ticket, .. }) = self.sent[slot] {
            self.client.cancel(&ticket);
            self.waiting.retain(|waiting| waiting.id() != ticket.id());
            assert!(!self.client.is_pending(&ticket));
        }
    }
}

/// A request ends once.
fn ended(waiting: &mut Vec<Ticket<()>>, event: &Event) {
    let at = waiting.iter().position(|ticket| ticket.id() == event.id);
    waiting.remove(at.expect("it was waiting"));
    assert!(
        event.response().is_none()
            || matches!(event.outcome, Outcome::Acknowledged | Outcome::Undecodable)
    );
}

/// What is not an answer is returned unchanged, in order.
fn take(client: &mut Client<SLOTS>, waiting: &mut Vec<Ticket<()>>, packet: &Packet<'_>) {
    let events = client.receive(packet);
    let mut all = packet.fields();
    for other in events.others() {
        assert!(all.any(|field| field == other));
    }
    for event in events {
        ended(waiting, event);
    }
}

/// Whatever is sent and arrives, each request ends once, and nothing panics.
pub fn client(data: &[u8]) {
    const KINDS: u8 = 7;
    let mut input = Input(data);
    let now = u32::MAX - 3000; // it wraps around soon
    let (client, parser) = (Client::new(), Parser::new());
    let mut session = Session { client, parser, now, sent: [None; SLOTS], waiting: Vec::new() };
    while !input.0.is_empty() {
        let kind = input.byte();
        let piece = usize::from(kind / KINDS); // 0: all at once
        match kind % KINDS {
            0 => session.send(&mut input),
            1 => session.answer(&mut input, piece),
            2 => {
                let set = input.byte();
                let payload = input.counted(255);
                session.arrive(&packet(set, payload), piece);
            }
            3 => {
                let bytes = input.counted(255);
                session.arrive(bytes, piece);
            }
            4 => {
                let time = u16::from_be_bytes([input.byte(), input.byte()]);
                session.now = session.now.wrapping_add(time.into());
                session.poll();
            }
            5 => session.cancel(usize::from(input.byte()) % SLOTS),
            _ => session.flush(),
        }
        assert_eq!(session.client.pending(), session.waiting.len());
        assert!(session.waiting.iter().all(|ticket| session.client.is_pending(ticket)));
    }
    session.flush();
    session.now = session.now.wrapping_add(LONGEST);
    session.poll();
    assert_eq!((session.client.pending(), session.waiting.len()), (0, 0));
}
