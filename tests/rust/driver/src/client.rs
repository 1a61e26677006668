//! The `client` requests: steps in, events out.

use mip_protocol::dynamic::Value;
use mip_protocol::{
    AnyField, Client, DescriptorSet, Event, Packet, Parser, RawField, Reason, RequestError, Role,
    Ticket,
};

use crate::json::Json;
use crate::{
    bytes, decode_error, decode_field, encode_error, hex, object, string, to_value, value_error,
    Answer,
};

/// A client, and what has happened.
struct Session {
    client: Client<400>,
    now: u32,
    sent: Vec<Ticket<()>>,
    events: Vec<Json>,
}

pub fn play(request: &Json) -> Answer {
    let mut parser = Parser::new();
    let (client, sent, events) = (Client::default(), Vec::new(), Vec::new());
    let now = u32::MAX - 1500; // it wraps around soon
    let mut session = Session { client, now, sent, events };
    for step in request.get("steps").and_then(Json::array).ok_or("request")? {
        match step.get("step").and_then(Json::string).ok_or("request")? {
            "send" => session.send(step)?,
            "end" => session.end(&mut parser),
            "receive" => session.receive(step, &mut parser)?,
            "time" => {
                let passed = step.get("milliseconds").and_then(Json::integer).ok_or("request")?;
                session.now = session.now.wrapping_add(passed);
                session.poll(&mut parser);
            }
            _ => return Err("request"),
        }
    }
    Ok(object([("events", Json::Array(session.events))]))
}

fn number(of: usize) -> Json {
    Json::Integer(of as i128)
}

impl Session {
    fn happens<const N: usize>(&mut self, event: &str, what: [(&str, Json); N]) {
        let head = ("event".to_owned(), string(event));
        let what = what.into_iter().map(|(key, value)| (key.to_owned(), value));
        self.events.push(Json::Object(std::iter::once(head).chain(what).collect()));
    }

    fn send(&mut self, step: &Json) -> Result<(), &'static str> {
        let set = step.get("set").and_then(Json::integer).filter(|set| (1..=254_u8).contains(set));
        let set = set.map(DescriptorSet).ok_or("request")?;
        let fields = step.get("fields").and_then(Json::array).ok_or("request")?;
        if fields.is_empty() {
            return Err("request");
        }
        let before = self.client.clone();
        let mut packets = self.client.barrier().map_or_else(Vec::new, |p| p.bytes().to_vec());
        let mut request = self.client.request(set);
        let mut tickets: Vec<Ticket<()>> = Vec::new();
        for field in fields {
            let added = command(set, field).and_then(|command| {
                request.add_any(&command).map_err(|error| match error {
                    RequestError::Encode(error) => encode_error(error),
                    RequestError::NoCommand => "unknown",
                    RequestError::Busy => panic!("more commands than any scenario sends"),
                    error => panic!("{error:?}"),
                })
            });
            match added {
                Ok(ticket) => tickets.push(ticket),
                Err("request") => return Err("request"),
                Err(error) => {
                    self.client = before; // no barrier was sent
                    self.happens("not_sent", [("error", string(error))]);
                    return Ok(());
                }
            }
        }
        let packet = request.send(self.now);
        packets.extend_from_slice(packet.bytes());
        let bytes = hex(&packets);
        let first = self.sent.len();
        self.sent.extend_from_slice(&tickets);
        let commands = Json::Array((first..self.sent.len()).map(number).collect());
        self.happens("sent", [("packet", bytes), ("commands", commands)]);
        for (at, _) in tickets.iter().enumerate().filter(|(_, ticket)| ticket.is_silent()) {
            self.happens("silent", [("command", number(first + at))]);
        }
        Ok(())
    }

    fn receive(&mut self, step: &Json, parser: &mut Parser) -> Result<(), &'static str> {
        let stream = bytes(step.get("bytes"))?;
        let chunk = match step.get("chunk") {
            Some(chunk) => chunk.integer().filter(|n| *n > 0).ok_or("request")?,
            None => stream.len().max(1),
        };
        for chunk in stream.chunks(chunk) {
            parser.feed(chunk).for_each(|packet| self.take(&packet));
            self.poll(parser);
        }
        Ok(())
    }

    fn poll(&mut self, parser: &mut Parser) {
        while let Some(packet) = self.client.poll(parser, self.now) {
            self.take(&packet);
        }
        let events: Vec<Event> = self.client.events().cloned().collect();
        for event in events {
            self.answer(&event);
        }
    }

    fn end(&mut self, parser: &mut Parser) {
        while let Some(packet) = parser.flush() {
            self.take(&packet);
        }
        self.poll(parser);
        let sent = self.sent.iter().enumerate();
        let waiting = sent.filter(|(_, t)| self.client.is_pending(t)).map(|(at, _)| number(at));
        let waiting = Json::Array(waiting.collect());
        let skipped = Json::Integer(parser.skipped().into());
        self.happens("end", [("waiting", waiting), ("skipped", skipped)]);
    }

    fn take(&mut self, packet: &Packet<'_>) {
        let events = self.client.receive(packet);
        let others: Vec<Json> = events
            .others()
            .map(|field| match field {
                Ok(field) => decode_field(&field),
                Err(_) => object([("error", string("field_length"))]),
            })
            .collect();
        let events: Vec<Event> = events.cloned().collect();
        for event in &events {
            self.answer(event);
        }
        let empty = packet.payload().is_empty(); // otherwise, a packet without fields left answers a barrier
        if events.is_empty() && empty || !others.is_empty() {
            let set = Json::Integer(packet.set().0.into());
            self.happens("received", [("set", set), ("fields", Json::Array(others))]);
        }
    }

    fn answer(&mut self, event: &Event) {
        let at = self.sent.iter().position(|t| t.id() == event.id).expect("it was sent");
        let command = ("command", number(at));
        match (event.outcome(), event.response()) {
            (Ok(()), None) => self.happens("acknowledged", [command]),
            (Ok(()), Some(field)) => {
                self.happens("acknowledged", [command, ("response", decode_field(&field))]);
            }
            (Err(Reason::Refused(code)), _) => {
                self.happens("refused", [command, ("code", Json::Integer(code.0.into()))]);
            }
            (Err(Reason::TimedOut), _) => self.happens("timed_out", [command]),
            (Err(Reason::MissingResponse), _) => self.happens("missing_response", [command]),
            (Err(Reason::Undecodable(_)), field) => {
                let field = field.expect("there is one");
                let RawField { descriptor, data, .. } = field;
                let Err(error) = AnyField::decode(&field) else { panic!("it is decodable") };
                let response = object([
                    ("descriptor", Json::Integer(descriptor.into())),
                    ("error", string(decode_error(error))),
                    ("raw", hex(data)),
                ]);
                self.happens("undecodable", [command, ("response", response)]);
            }
            (outcome, _) => panic!("{outcome:?}"),
        }
    }
}

/// A command of the set by its name.
fn command(set: DescriptorSet, field: &Json) -> Result<AnyField, &'static str> {
    let name = field.get("name").and_then(Json::string).ok_or("request")?;
    let values: Value = to_value(field.get("values").ok_or("request")?)?;
    let any = AnyField::from_value(name, &values).map_err(value_error)?;
    let info = any.info();
    let descriptor = field.get("descriptor").map(Json::integer::<u8>);
    let right =
        info.name_in(set) == Some(name) && descriptor.map_or(true, |d| d == Some(info.descriptor));
    if right && info.role == Role::Command {
        Ok(any)
    } else {
        Err("unknown")
    }
}
