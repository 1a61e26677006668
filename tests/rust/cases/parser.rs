//! The stream parser with random streams, in pieces of any size, against one that keeps everything.

use mip_protocol::{packets, Packet, PacketBuilder, Parser};

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

/// Numbers that look random, and are the same in each run.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) as usize % end
    }

    /// Packets, some of them damaged or cut, and what may be between them.
    fn stream(&mut self) -> Vec<u8> {
        let mut stream = Vec::new();
        for _ in 0..self.below(12) {
            let mut packet = PacketBuilder::new([1, 0x75, 0x80, 0xFE][self.below(4)]);
            for _ in 0..self.below(4) {
                let data = vec![[0, 0x65, 0x75][self.below(3)]; self.below(40)];
                packet.push_raw(self.below(256) as u8, &data).unwrap();
            }
            let mut bytes = packet.bytes().to_vec();
            match self.below(8) {
                0 => {
                    bytes =
                        [&b"u"[..], b"ue", b"ueue\x80", b"$GPGGA,1*00\r\n"][self.below(4)].to_vec()
                }
                1 => bytes = [b"ue\x00\x02", b"ue\xFF\x02", b"ue\x80\xFF"][self.below(3)].to_vec(),
                2 => bytes.truncate(self.below(bytes.len())),
                3 => {
                    let at = self.below(bytes.len());
                    bytes[at] ^= 1 << self.below(8);
                }
                _ => {}
            }
            stream.extend(bytes);
        }
        stream
    }
}

#[test]
fn any_stream_in_any_pieces() {
    let rounds = if cfg!(miri) { 40 } else { 20_000 };
    for round in 0..rounds {
        let mut random = Random(round);
        let (stream, largest, events) =
            (random.stream(), random.below(300) + 1, random.below(2) > 0);
        let mut plain = Plain { stream: &[], at: 0, skipped: 0 };
        let (mut parser, mut found, mut fed) = (Parser::new(), Vec::new(), 0);
        while fed < stream.len() {
            let size = (random.below(largest) + 1).min(stream.len() - fed);
            let mut piece = &stream[fed..fed + size];
            fed += size;
            plain.stream = &stream[..fed];
            loop {
                let next = plain.next();
                found.extend(next);
                if !same(parser.next(&mut piece), next) {
                    break;
                }
                assert_eq!(parser.skipped(), plain.skipped, "{round}");
            }
            assert!(piece.is_empty());
            let between = if events { random.below(256) } else { 255 };
            while between < 16 && same(parser.flush(), plain.flush()) {}
            while between < 32 && same(parser.look_behind(), plain.look_behind()) {}
            // The parser checks the header of a candidate once all four bytes are there.
            let late = parser.skipped() as usize + parser.pending();
            assert_eq!(late, plain.skipped as usize + plain.stream.len() - plain.at, "{round}");
        }
        loop {
            let next = plain.flush();
            found.extend(next);
            if !same(parser.flush(), next) {
                break;
            }
        }
        assert_eq!((parser.skipped(), parser.pending()), (plain.skipped, 0), "{round}");
        if !events {
            assert!(packets(&stream).map(|packet| packet.bytes()).eq(found), "{round}");
        }
    }
}
