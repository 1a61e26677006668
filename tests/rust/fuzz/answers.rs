//! What Rust makes of streams, in the form that `tests/c/fuzz/answers.c` defines.

use std::fmt::Write;

use mip_protocol::error::DecodeErrorKind;
use mip_protocol::registry::FieldInfo;
use mip_protocol::{AnyField, Packet, Parser, RawField};

fn hex(out: &mut String, bytes: &[u8]) {
    for byte in bytes {
        for digit in [byte >> 4, byte & 15] {
            out.push(char::from(b"0123456789abcdef"[usize::from(digit)]));
        }
    }
}

fn show_field(out: &mut String, raw: &RawField<'_>) -> std::fmt::Result {
    let Some(decoded) = AnyField::decode_with_trailing(raw) else {
        return write!(out, "{} ", raw.descriptor);
    };
    let info = FieldInfo::of(raw).expect("it is known");
    write!(out, "{}", info.name_in(raw.set).unwrap_or(info.name))?;
    match decoded {
        Ok(value) => {
            let mut buffer = [0; 253];
            let length = value.field.encode(&mut buffer).expect("it was decoded");
            out.push('=');
            hex(out, &buffer[..length]);
            write!(out, "+{} ", value.left_over)
        }
        Err(error) => {
            let kind = match error.kind {
                DecodeErrorKind::Truncated => "truncated",
                DecodeErrorKind::Count => "count",
                DecodeErrorKind::Constant => "constant",
                kind => panic!("{kind:?}"),
            };
            write!(out, "!{kind} ")
        }
    }
}

fn show(out: &mut String, packet: &Packet<'_>) {
    hex(out, packet.bytes());
    out.push(' ');
    for raw in packet.fields() {
        match raw {
            Ok(raw) => show_field(out, &raw).expect("a string takes it"),
            Err(_) => out.push_str("! "),
        }
    }
}

fn answer(line: &str) -> String {
    let (piece, digits) = line.split_once(' ').expect("two words");
    let digits: Vec<u8> =
        digits.chars().map(|digit| digit.to_digit(16).expect("a digit") as u8).collect();
    let stream: Vec<u8> = digits.chunks(2).map(|pair| pair[0] << 4 | pair[1]).collect();
    let piece = match piece.parse().expect("a number") {
        0 => stream.len().max(1),
        piece => piece,
    };
    let (mut out, mut parser) = (String::new(), Parser::new());
    for mut chunk in stream.chunks(piece) {
        while let Some(packet) = parser.next(&mut chunk) {
            show(&mut out, &packet);
        }
    }
    while let Some(packet) = parser.flush() {
        show(&mut out, &packet);
    }
    out + &parser.skipped().to_string()
}

fn main() {
    let input = std::io::read_to_string(std::io::stdin()).expect("lines");
    let output: String = input.lines().map(|line| answer(line) + "\n").collect();
    print!("{output}");
}
