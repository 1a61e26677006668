//! The conformance driver: one JSON object per line in, one per line out.
//!
//! It knows no field by name: everything goes through the registry and the trees of values.

mod client;
mod json;

use std::io::{self, BufRead, Write};

use json::Json;
use mip_protocol::dynamic::{Record, Value, ValueError};
use mip_protocol::packet::{MAX_FIELD_DATA, MAX_PACKET};
use mip_protocol::{
    AnyField, DecodeError, DecodeErrorKind, DescriptorSet, EncodeError, EncodeErrorKind, Packet,
    PacketBuilder, PacketError, Parser, RawField,
};

type Answer = Result<Json, &'static str>;

fn main() -> io::Result<()> {
    let mut input = io::BufReader::new(io::stdin().lock());
    let mut output = io::BufWriter::new(io::stdout().lock());
    let mut line = Vec::new();
    while input.read_until(b'\n', &mut line)? > 0 {
        let request = std::str::from_utf8(&line).ok().and_then(Json::parse);
        let answer = request.ok_or("request").and_then(|request| answer(&request));
        let mut text = String::new();
        answer.unwrap_or_else(|error| object([("error", string(error))])).write(&mut text);
        writeln!(output, "{text}")?;
        line.clear();
        if input.buffer().is_empty() {
            output.flush()?; // the other end may wait for the answer
        }
    }
    output.flush()
}

fn answer(request: &Json) -> Answer {
    match request.get("op").and_then(Json::string) {
        Some("parse") => parse(request),
        Some("decode") => decode(request),
        Some("encode") => encode(request),
        Some("client") => client::play(request),
        _ => Err("request"),
    }
}

// ------------------------------------------------------------------------------------------ parse

fn parse(request: &Json) -> Answer {
    let stream = bytes(request.get("stream"))?;
    let chunk = request.get("chunk").and_then(Json::integer).filter(|n| *n > 0_usize);
    let mut parser = Parser::new();
    let mut packets = Vec::new();
    for chunk in stream.chunks(chunk.ok_or("request")?) {
        parser.feed(chunk).for_each(|packet| packets.push(hex(packet.bytes())));
    }
    while let Some(packet) = parser.flush() {
        packets.push(hex(packet.bytes()));
    }
    let skipped = Json::Integer(parser.skipped().into());
    Ok(object([("packets", Json::Array(packets)), ("skipped", skipped)]))
}

// ----------------------------------------------------------------------------------------- decode

fn decode(request: &Json) -> Answer {
    let bytes = bytes(request.get("packet"))?;
    let packet = Packet::new(&bytes).map_err(|error| match error {
        PacketError::Sync => "sync",
        PacketError::Length => "length",
        PacketError::Checksum => "checksum",
        _ => "request",
    })?;
    let fields = packet.fields().map(|field| match field {
        Ok(field) => decode_field(&field),
        Err(_) => object([("error", string("field_length"))]),
    });
    let fields = Json::Array(fields.collect());
    Ok(object([("set", Json::Integer(packet.set().0.into())), ("fields", fields)]))
}

fn decode_field(field: &RawField<'_>) -> Json {
    let descriptor = ("descriptor", Json::Integer(field.descriptor.into()));
    match &AnyField::decode_with_trailing(field) {
        Ok(None) => object([descriptor, ("raw", hex(field.data))]),
        Err(error) => {
            object([descriptor, ("error", string(decode_error(*error))), ("raw", hex(field.data))])
        }
        Ok(Some(found)) => object([
            descriptor,
            ("name", string(found.name())),
            ("role", string(found.field.info().role.name())),
            ("values", from_value(&found.field.to_value())),
            ("trailing", Json::Integer(found.left_over as i128)),
        ]),
    }
}

fn from_value(value: &Value) -> Json {
    match value {
        Value::Integer(number) => Json::Integer(*number),
        Value::Float(number) => Json::String(format!("0x{:08x}", number.to_bits())),
        Value::Double(number) => Json::String(format!("0x{:016x}", number.to_bits())),
        Value::Text(text) => string(text),
        Value::List(items) => Json::Array(items.iter().map(from_value).collect()),
        Value::Record(record) => {
            Json::Object(record.iter().map(|(k, v)| (k.to_owned(), from_value(v))).collect())
        }
    }
}

// ----------------------------------------------------------------------------------------- encode

fn encode(request: &Json) -> Answer {
    let set = request.get("set").and_then(Json::integer).map(DescriptorSet).ok_or("request")?;
    // A builder of a set that no packet has accepts no field; of several mistakes, the first one is reported.
    PacketBuilder::new(set).push_raw(0, &[]).map_err(encode_error)?;
    let mut packet = PacketBuilder::new(set);
    for field in request.get("fields").and_then(Json::array).ok_or("request")? {
        let descriptor = field.get("descriptor").map(Json::integer::<u8>);
        match (field.get("raw"), field.get("name").and_then(Json::string)) {
            (Some(raw), _) => {
                let descriptor = descriptor.flatten().ok_or("request")?;
                packet.push_raw(descriptor, &bytes(Some(raw))?).map_err(encode_error)?;
            }
            (None, Some(name)) => {
                let any =
                    AnyField::from_value(name, &to_value(field.get("values").ok_or("request")?)?)
                        .map_err(value_error)?;
                let info = any.info();
                let other = descriptor.is_some_and(|d| d != Some(info.descriptor));
                if info.name_in(set) != Some(name) || other {
                    return Err("unknown");
                }
                let mut data = [0; MAX_FIELD_DATA];
                let length = any.encode(&mut data).map_err(encode_error)?;
                packet.push_raw(info.descriptor, &data[..length]).map_err(encode_error)?;
            }
            (None, None) => return Err("request"),
        }
    }
    debug_assert!(packet.bytes().len() <= MAX_PACKET);
    Ok(object([("packet", hex(packet.bytes()))]))
}

fn to_value(json: &Json) -> Result<Value, &'static str> {
    Ok(match json {
        Json::Null => return Err("range"),
        Json::Bool(value) => Value::Integer((*value).into()),
        Json::Integer(number) => Value::Integer(*number),
        Json::String(text) => Value::Text(text.clone()),
        Json::Array(items) => Value::List(items.iter().map(to_value).collect::<Result<_, _>>()?),
        Json::Object(entries) => {
            let values = entries.iter().map(|(name, value)| Ok((name.clone(), to_value(value)?)));
            Value::Record(values.collect::<Result<Record, _>>()?)
        }
    })
}

fn decode_error(error: DecodeError) -> &'static str {
    match error.kind {
        DecodeErrorKind::Truncated => "truncated",
        DecodeErrorKind::Count => "count",
        DecodeErrorKind::Constant => "constant",
        _ => "request",
    }
}

fn value_error(error: ValueError) -> &'static str {
    match error {
        ValueError::Unknown => "unknown",
        ValueError::Missing => "missing",
        ValueError::Range => "range",
        ValueError::Count => "count",
        ValueError::Tag => "tag",
        _ => "request",
    }
}

fn encode_error(error: EncodeError) -> &'static str {
    match error.kind {
        EncodeErrorKind::Missing => "missing",
        EncodeErrorKind::Count => "count",
        EncodeErrorKind::Tag => "tag",
        EncodeErrorKind::Length => "length",
        EncodeErrorKind::Set => "set",
        _ => "request",
    }
}

// ---------------------------------------------------------------------------------------- helpers

fn bytes(json: Option<&Json>) -> Result<Vec<u8>, &'static str> {
    let digits = json.and_then(Json::string).ok_or("request")?.as_bytes();
    let digit = |b: u8| char::from(b).to_digit(16).map(|d| d as u8);
    let pair = |p: &[u8]| Some((digit(*p.first()?)? << 4) | digit(*p.get(1)?)?);
    digits.chunks(2).map(pair).collect::<Option<_>>().ok_or("request")
}

fn hex(bytes: &[u8]) -> Json {
    Json::String(bytes.iter().map(|b| format!("{b:02x}")).collect())
}

fn string(text: &str) -> Json {
    Json::String(text.to_owned())
}

fn object<const N: usize>(entries: [(&str, Json); N]) -> Json {
    Json::Object(entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
}
