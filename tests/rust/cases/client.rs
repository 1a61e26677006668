//! The command client.

use std::error::Error;

use mip_protocol::types::{Mode, Vector3f};
use mip_protocol::{
    protocol, tools, AnyField, Client, Command, CommandError, DescriptorSet, EncodeErrorKind,
    Event, Field, PacketBuilder, Parser, Reason, RequestError, Ticket,
};
use protocol::{AckCode, Acknowledge};

/// A reply packet that the device would send.
struct Reply(PacketBuilder);

impl Reply {
    fn new() -> Self {
        Self(PacketBuilder::new(tools::SET))
    }

    fn ack(self, command: u8, code: AckCode) -> Self {
        self.field(&Acknowledge { command, code })
    }

    fn field<T: Field>(mut self, field: &T) -> Self {
        self.0.push(field).unwrap();
        self
    }
}

fn only<const N: usize>(client: &mut Client<N>, reply: &Reply) -> Event {
    let mut events: Vec<_> = client.receive(&reply.0.packet()).cloned().collect();
    assert_eq!(events.len(), 1);
    events.remove(0)
}

/// The result of a command that failed.
fn failed<C: Command, R>(reason: Reason) -> Option<Result<R, CommandError>> {
    Some(Err(CommandError::new(C::NAME, reason)))
}

/// The events of commands that took too long; there is no parser that holds anything back.
fn expire<const N: usize>(client: &mut Client<N>, now: u32) -> Vec<Event> {
    assert!(client.poll(&mut Parser::new(), now).is_none());
    client.events().cloned().collect()
}

fn sent<C: Command>(client: &mut Client, command: &C, now: u32) -> Ticket<C> {
    let (ticket, packet) = client.send(command, now).unwrap();
    assert_eq!(packet.find::<C>().unwrap().unwrap().to_vec(), command.to_vec());
    ticket
}

#[test]
fn commands_that_nobody_answers_are_not_waited_for() {
    let mut client: Client<1> = Client::default();
    let (apply, packet) = client.send(&tools::Settings::apply(1, Mode::FAST, 1), 0).unwrap();
    assert_eq!(packet.fields().count(), 1);
    assert!(apply.is_silent());
    let (quiet, _) = client.send(&tools::Formats::new(true, 0, []), 0).unwrap();
    assert!(quiet.is_silent());
    assert_eq!((client.pending(), client.deadline()), (0, None));
    assert_eq!(expire(&mut client, u32::MAX / 2).len(), 0);
    // The result of such a command is available at once.
    assert_eq!(client.take(&apply), Some(Ok(())));
    assert_eq!(client.take(&quiet), Some(Ok(())));
    // Beside other commands, too, and even if the client is full.
    let mut request = client.request(tools::SET);
    let loud = request.add(&tools::Ping).unwrap();
    let silent = request.add(&tools::Formats::new(true, 0, [])).unwrap();
    assert_eq!(request.send(0).fields().count(), 2);
    assert_eq!((loud.is_silent(), silent.is_silent(), client.pending()), (false, true, 1));
}

#[test]
fn one_of_several_responses() {
    let mut client = Client::new();
    let fast = tools::SetTimeFastResponse { value: 1 };
    let slow = tools::SetTimeSlowResponse { value: 2 };
    let ticket = sent(&mut client, &tools::SetTime::read(Mode::FAST), 0);
    let reply = Reply::new().ack(3, AckCode::OK).field(&fast);
    let answer = only(&mut client, &reply).answer(&ticket);
    assert_eq!(answer, Some(Ok(tools::SetTimeResponses::Fast(fast))));
    let ticket = sent(&mut client, &tools::SetTime::read(Mode::SLOW), 0);
    let reply = Reply::new().ack(3, AckCode::OK).field(&slow);
    let answer = only(&mut client, &reply).answer(&ticket);
    assert_eq!(answer, Some(Ok(tools::SetTimeResponses::Slow(slow))));
    // Two layouts of one descriptor.
    let ticket = sent(&mut client, &tools::Status::new(2), 0);
    let long = tools::StatusLong { flags: 1, uptime: 2 };
    let reply = Reply::new().ack(4, AckCode::OK).field(&long);
    let answer = only(&mut client, &reply).answer(&ticket);
    assert_eq!(answer, Some(Ok(tools::StatusResponses::Long(long))));
}

#[test]
fn events_that_are_not_taken_stay() {
    let mut client: Client<4> = Client::default();
    let mut request = client.request(tools::SET);
    let first = request.add(&tools::Ping).unwrap();
    let second = request.add(&tools::Bias::read()).unwrap();
    let third = request.add(&tools::Ping).unwrap();
    let _ = request.send(0);
    let response = tools::BiasVector { bias: Vector3f::from([1.0, 2.0, 3.0]) };
    let reply = Reply::new().ack(1, AckCode::OK).ack(5, AckCode::OK).field(&response);
    // Reading only the first event, or none, loses nothing.
    assert_eq!(client.receive(&reply.0.packet()).next().unwrap().id, first.id());
    drop(client.receive(&Reply::new().ack(1, AckCode::INVALID_PARAMETER).0.packet()));
    assert_eq!(client.pending(), 0);
    // Places whose events were not taken are not free.
    assert!(client.send(&tools::Ping, 0).is_ok() && client.send(&tools::Ping, 0).is_ok());
    assert_eq!(client.send(&tools::Ping, 0).unwrap_err(), RequestError::Busy);
    let code = AckCode::INVALID_PARAMETER;
    assert_eq!(client.take(&third), failed::<tools::Ping, _>(Reason::Refused(code)));
    assert_eq!(client.take(&third), None);
    let late = sent_in(&mut client, 0);
    assert!(client.poll(&mut Parser::new(), 1000).is_none());
    let events: Vec<_> = client.events().collect();
    assert_eq!(events.len(), 4);
    assert_eq!(events[0].answer(&second), Some(Ok(response)));
    assert_eq!(events[3].answer(&late), failed::<tools::Ping, _>(Reason::TimedOut));
    assert_eq!(client.events().count(), 0);
    // A command that was cancelled has no event, not even one that is there already.
    let ticket = sent_in(&mut client, 0);
    drop(client.receive(&Reply::new().ack(1, AckCode::OK).0.packet()));
    client.cancel(&ticket);
    assert_eq!(client.events().count(), 0);
}

fn sent_in<const N: usize>(client: &mut Client<N>, now: u32) -> Ticket<tools::Ping> {
    client.send(&tools::Ping, now).unwrap().0
}

#[test]
fn the_time_may_wrap_around() {
    let mut client = Client::new();
    let early = sent_in(&mut client, u32::MAX - 1500);
    let late = sent_in(&mut client, u32::MAX - 100);
    assert_eq!(client.deadline(), Some(u32::MAX - 500));
    client.cancel(&early);
    client.cancel(&late);
    // The earlier deadline counts, whatever its slot.
    let soon = sent_in(&mut client, u32::MAX - 100);
    let before = sent_in(&mut client, u32::MAX - 1200);
    assert_eq!(client.deadline(), Some(u32::MAX - 200));
    client.cancel(&before);
    client.cancel(&soon);
    assert_eq!(client.deadline(), None);
    // Half of the range is the longest time.
    let mut patient: Client = Client::with_timeout(u32::MAX);
    sent_in(&mut patient, 7);
    assert_eq!(patient.deadline(), Some(7 + u32::MAX / 2));
    assert_eq!(expire(&mut patient, u32::MAX / 2).len(), 0);
    assert_eq!(expire(&mut patient, u32::MAX / 2 + 7).len(), 1);
}

#[test]
fn errors_name_the_command_and_the_reason() {
    let mut client = Client::new();
    let response = tools::BiasVector { bias: Vector3f::from([1.0, 2.0, 3.0]) };
    let mut answer = |reply: &Reply| {
        let ticket = sent(&mut client, &tools::Bias::read(), 0);
        only(&mut client, reply).answer(&ticket).unwrap()
    };
    assert_eq!(answer(&Reply::new().ack(5, AckCode::OK).field(&response)), Ok(response));
    let error = answer(&Reply::new().ack(5, AckCode::INVALID_PARAMETER)).unwrap_err();
    assert_eq!(error, CommandError::new("tools.bias", Reason::Refused(AckCode(3))));
    let text = "tools.bias: the device rejected the command: invalid parameter (3)";
    assert_eq!((error.to_string().as_str(), error.source().is_none()), (text, true));
    let unknown = Reason::Refused(AckCode(0x77)).to_string();
    assert_eq!(unknown, "the device rejected the command: code 119");
    let bare = answer(&Reply::new().ack(5, AckCode::OK)).unwrap_err();
    assert_eq!((bare.command, bare.reason), ("tools.bias", Reason::MissingResponse));
    let mut short = Reply::new().ack(5, AckCode::OK);
    short.0.push_raw(tools::BiasVector::DESCRIPTOR, &[0; 11]).unwrap();
    let error = answer(&short).unwrap_err();
    assert_eq!(error.to_string(), "tools.bias: the response cannot be decoded");
    let source = error.source().unwrap().to_string();
    assert_eq!(source, "tools.bias_vector: it needs 12 bytes and has 11");
}

#[test]
fn a_client_in_static_memory() {
    static CLIENT: std::sync::Mutex<Client<2>> = std::sync::Mutex::new(Client::with_timeout(7));
    static PARSER: std::sync::Mutex<Parser> = std::sync::Mutex::new(Parser::new());
    const BUILDER: PacketBuilder = PacketBuilder::new(tools::SET);
    let mut client = CLIENT.lock().unwrap();
    let ticket = sent_in(&mut client, 0);
    let mut reply = BUILDER;
    reply.push(&Acknowledge { command: 1, code: AckCode::OK }).unwrap();
    let mut parser = PARSER.lock().unwrap();
    let mut received = reply.bytes();
    while let Some(packet) = parser.next(&mut received) {
        assert_eq!(client.receive(&packet).count(), 1);
    }
    assert!(!client.is_pending(&ticket));
}

#[test]
fn later_commands_are_answered_later_in_whatever_slots() {
    let mut client: Client<3> = Client::default();
    for _ in 0..100 {
        let mut request = client.request(tools::SET);
        let tickets = [0; 3].map(|_| request.add(&tools::Ping).unwrap());
        assert_eq!(request.add(&tools::Ping).unwrap_err(), RequestError::Busy);
        let _ = request.send(0);
        client.cancel(&tickets[1]);
        let again = sent_in(&mut client, 0); // in a slot before that of an older command
        let reply = Reply::new().ack(1, AckCode::OK).ack(1, AckCode::OK).ack(1, AckCode::OK);
        let ids: Vec<_> = client.receive(&reply.0.packet()).map(|event| event.id).collect();
        assert_eq!(ids, [tickets[0].id(), tickets[2].id(), again.id()]);
    }
}

fn refused<C>(added: Result<Ticket<C>, RequestError>) -> EncodeErrorKind {
    match added {
        Err(RequestError::Encode(error)) => error.kind,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_response_is_lent_from_its_slot() {
    let mut client = Client::new();
    let ticket = sent(&mut client, &tools::Bias::read(), 0);
    let other = sent(&mut client, &tools::Bias::read(), 0);
    let response = tools::BiasVector { bias: [1.0, 2.0, 3.0].into() };
    let event = only(&mut client, &Reply::new().ack(5, AckCode::OK).field(&response));
    let Some(Ok(view)) = event.view(&ticket) else { panic!("{event:?}") };
    assert_eq!(view.bias(), response.bias);
    assert!(event.view(&other).is_none());
    let event = only(&mut client, &Reply::new().ack(5, AckCode(3)));
    let error = event.view(&other).unwrap().unwrap_err();
    assert_eq!(error.reason, Reason::Refused(AckCode(3)));
}

#[test]
fn a_full_client_or_packet_refuses() {
    let mut client: Client<2> = Client::default();
    client.send(&tools::Ping, 0).unwrap();
    let mut request = client.request(tools::SET);
    request.add(&tools::Ping).unwrap();
    assert_eq!(request.add(&tools::Ping).unwrap_err(), RequestError::Busy);
    let packet = request.send(0);
    assert_eq!(packet.fields().count(), 1);
    assert_eq!(client.send(&tools::Ping, 0).unwrap_err(), RequestError::Busy);

    let mut client: Client<8> = Client::default();
    let mut request = client.request(tools::SET);
    let long = tools::List::write([0; 100]);
    request.add(&long).unwrap();
    assert_eq!(refused(request.add(&long)), EncodeErrorKind::Length);
    assert_eq!(request.send(0).fields().count(), 1);
    assert_eq!(client.pending(), 1);
    let mut request = client.request(DescriptorSet(0x0C));
    assert_eq!(refused(request.add(&tools::Ping)), EncodeErrorKind::Set);
    // A request that is not sent is forgotten.
    let mut request = client.request(tools::SET);
    request.add(&tools::Ping).unwrap();
    drop(request);
    assert_eq!(client.pending(), 1);
}

#[test]
fn the_event_of_any_ticket() {
    let mut client = Client::new();
    let mut request = client.request(tools::SET);
    let any = request.add_any(&AnyField::from(tools::Ping)).unwrap();
    let bias = request.add(&tools::Bias::read()).unwrap();
    let _ = request.send(0);
    assert_eq!(client.take_event(&any), None);
    let reply = Reply::new().ack(1, AckCode::OK).ack(5, AckCode::INVALID_PARAMETER);
    let _ = client.receive(&reply.0.packet());
    let event = client.take_event(&any).cloned().unwrap();
    assert_eq!((event.id, event.outcome()), (any.id(), Ok(())));
    assert_eq!((event.set, event.descriptor), (tools::SET, 1));
    assert_eq!(client.take_event(&any), None);
    let refused = client.take_event(&bias).unwrap();
    let code = AckCode::INVALID_PARAMETER;
    assert_eq!(refused.answer(&bias), failed::<tools::Bias, _>(Reason::Refused(code)));
    assert_eq!(client.events().count(), 0);
}
