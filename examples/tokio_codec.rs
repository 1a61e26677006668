//! A codec for `tokio_util::codec::Framed`, for instance over the port of `tokio-serial`:
//! `Framed::new(port, Mip::default())` is a stream of packets, and a sink for packets to send.
//!
//! This program decodes the packets from standard input:
//!
//!     cargo run --example tokio_codec --features std < log.bin

use std::io::{self, Read};

use mip_protocol::{PacketBuf, PacketBuilder, Parser};
use tokio_util::bytes::{Buf, BytesMut};
use tokio_util::codec::{Decoder, Encoder};

#[derive(Default)]
struct Mip {
    parser: Parser,
}

impl Decoder for Mip {
    type Item = PacketBuf;
    type Error = io::Error;

    fn decode(&mut self, bytes: &mut BytesMut) -> io::Result<Option<PacketBuf>> {
        let mut rest = &bytes[..];
        let packet = self.parser.next(&mut rest).map(PacketBuf::from);
        let searched = bytes.len() - rest.len();
        bytes.advance(searched);
        Ok(packet)
    }

    /// At the end, discards an incomplete packet, and finds the packets within it.
    fn decode_eof(&mut self, bytes: &mut BytesMut) -> io::Result<Option<PacketBuf>> {
        match self.decode(bytes)? {
            Some(packet) => Ok(Some(packet)),
            None => Ok(self.parser.flush().map(PacketBuf::from)),
        }
    }
}

impl Encoder<PacketBuilder> for Mip {
    type Error = io::Error;

    fn encode(&mut self, packet: PacketBuilder, bytes: &mut BytesMut) -> io::Result<()> {
        bytes.extend_from_slice(packet.bytes());
        Ok(())
    }
}

fn main() -> io::Result<()> {
    let (mut codec, mut bytes, mut chunk) = (Mip::default(), BytesMut::new(), [0; 100]);
    loop {
        let count = io::stdin().read(&mut chunk)?;
        bytes.extend_from_slice(&chunk[..count]);
        let decode = if count > 0 { Mip::decode } else { Mip::decode_eof };
        while let Some(packet) = decode(&mut codec, &mut bytes)? {
            println!("{packet:?}");
        }
        if count == 0 {
            return Ok(());
        }
    }
}
