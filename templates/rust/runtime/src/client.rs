//! Sends commands and recognizes their replies, without input or output.

use core::fmt;
use core::marker::PhantomData;

use crate::error::{DecodeError, EncodeError};
use crate::field::{Command, RawField, Response, ResponseCheck};
use crate::packet::{FieldLengthError, Packet, PacketBuilder, MAX_FIELD_DATA};
use crate::parser::Parser;
use crate::protocol::{AckCode, Acknowledge};
use crate::registry::AnyField;

/// Tracks at most `N` commands that a device has not answered yet.
///
/// The caller moves the bytes and supplies the time: any count of milliseconds that never
/// decreases.
///
/// 1. [`Client::request`] begins a packet, [`Request::add`] adds commands to it, and
///    [`Request::send`] returns the bytes to send.
/// 2. Pass every received packet to [`Client::receive`], which yields an [`Event`] for each command
///    that it answers, and gives access to the other fields of the packet.
/// 3. Call [`Client::poll`] from time to time with the current time; commands that time out get
///    their events.
///
/// Events that are not taken are kept: the next call returns them, or [`Client::events`] or
/// [`Client::take`] do. For that, each of the `N` slots has room for the longest response.
#[derive(Clone, Debug)]
pub struct Client<const N: usize = 8> {
    slots: [Slot; N],
    /// The number of the next command, and that of the next event.
    next: u32,
    happened: u32,
    timeout_ms: u32,
}

/// A command, from the moment that it is added to a request until its event is taken.
#[derive(Clone)]
struct Slot {
    state: State,
    /// The number of the event, of those that happened.
    order: u32,
    /// The descriptors of all responses of the command, and the check for the one that it asks for.
    responses: &'static [u8],
    wanted: Option<ResponseCheck>,
    timeout_ms: u32,
    deadline: u64,
    event: Event,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Free,
    /// In a request that is not sent yet.
    Added,
    Waiting,
    /// The event has happened.
    Done,
}

impl Slot {
    const FREE: Self = Self {
        state: State::Free,
        order: 0,
        responses: &[],
        wanted: None,
        timeout_ms: 0,
        deadline: 0,
        event: Event::NONE,
    };
}

impl fmt::Debug for Slot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { state, deadline, event: Event { id, set, descriptor, .. }, .. } = self;
        write!(f, "{id}: 0x{set:02X},0x{descriptor:02X} {state:?} until {deadline}")
    }
}

/// Identifies one command that was sent, and the type of its answer.
pub struct Ticket<C> {
    id: u32,
    silent: bool,
    command: PhantomData<fn() -> C>,
}

impl<C> Ticket<C> {
    /// The number that events carry.
    #[must_use]
    pub const fn id(&self) -> u32 {
        self.id
    }

    /// Does the device not answer it? Then there is no event.
    #[must_use]
    pub const fn is_silent(&self) -> bool {
        self.silent
    }

    #[allow(dead_code)] // without the features of command sets
    pub(crate) const fn untyped(self) -> Ticket<()> {
        Ticket { id: self.id, silent: self.silent, command: PhantomData }
    }
}

impl<C> Clone for Ticket<C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for Ticket<C> {}

impl<C> fmt::Debug for Ticket<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Ticket({})", self.id)
    }
}

/// Why a command could not be added to a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RequestError {
    /// The command does not encode, or the packet is full.
    Encode(EncodeError),
    /// The client has no free slot: commands are pending or have events that were not taken.
    Busy,
    /// The field is not a command.
    NoCommand,
}

impl From<EncodeError> for RequestError {
    fn from(error: EncodeError) -> Self {
        Self::Encode(error)
    }
}

impl fmt::Display for RequestError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Encode(error) => error.fmt(f),
            Self::Busy => f.write_str("too many commands are pending"),
            Self::NoCommand => f.write_str("the field is no command"),
        }
    }
}

#[cfg(feature = "std")]
impl std::error::Error for RequestError {}

/// The result of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Answer<R> {
    /// The device carried it out; with the response, if the command asks for one.
    Acknowledged(Option<R>),
    /// The device refused it.
    Refused(AckCode),
    /// Nothing came in time.
    TimedOut,
    /// It was acknowledged, but the response that it asks for did not come.
    MissingResponse,
    /// It was carried out, but the response could not be decoded.
    Undecodable(DecodeError),
    /// It was sent. The device does not answer it, so nothing more is known.
    Silent,
}

impl<R> Answer<R> {
    /// The response, if there is one; an error if the command is not known to be carried out.
    ///
    /// ```
    /// use mip_protocol::client::{Answer, CommandError};
    ///
    /// let answer: Answer<u8> = Answer::TimedOut;
    /// assert_eq!(answer.into_result(), Err(CommandError::TimedOut));
    /// assert_eq!(Answer::Acknowledged(Some(7)).into_result(), Ok(Some(7)));
    /// ```
    pub fn into_result(self) -> Result<Option<R>, CommandError> {
        match self {
            Self::Acknowledged(response) => Ok(response),
            Self::Silent => Ok(None),
            Self::Refused(code) => Err(CommandError::Refused(code)),
            Self::TimedOut => Err(CommandError::TimedOut),
            Self::MissingResponse => Err(CommandError::MissingResponse),
            Self::Undecodable(error) => Err(CommandError::Undecodable(error)),
        }
    }

    /// The response; an error if there is none.
    pub fn into_response(self) -> Result<R, CommandError> {
        self.into_result()?.ok_or(CommandError::MissingResponse)
    }
}

/// Why a command failed, or is not known to have been carried out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CommandError {
    /// The device refused it.
    Refused(AckCode),
    /// Nothing came in time.
    TimedOut,
    /// It was acknowledged, but there is no response.
    MissingResponse,
    /// It was carried out, but the response could not be decoded.
    Undecodable(DecodeError),
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(code) => write!(f, "the device refused the command: {code:?}"),
            Self::TimedOut => f.write_str("no answer came in time"),
            Self::MissingResponse => f.write_str("the answer has no response"),
            Self::Undecodable(error) => error.fmt(f),
        }
    }
}

error!(CommandError);

/// The result of a command of any type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// The device carried it out, and the response is present, if the command asks for one.
    Acknowledged,
    /// The device refused it.
    Refused(AckCode),
    /// Nothing came in time.
    #[default]
    TimedOut,
    /// It was acknowledged, but the response that it asks for did not come.
    MissingResponse,
    /// It was carried out, but the response could not be decoded.
    Undecodable(DecodeError),
}

/// The result of a command, with its response not yet decoded.
#[derive(Clone)]
pub struct Event {
    /// The number of the ticket.
    pub id: u32,
    /// The descriptor set of the command.
    pub set: u8,
    /// The descriptor of the command.
    pub descriptor: u8,
    /// The result.
    pub outcome: Outcome,
    response: Option<u8>,
    length: u8,
    data: [u8; MAX_FIELD_DATA],
}

impl Event {
    const NONE: Self = Self {
        id: 0,
        set: 0,
        descriptor: 0,
        outcome: Outcome::TimedOut,
        response: None,
        length: 0,
        data: [0; MAX_FIELD_DATA],
    };

    /// The undecoded response.
    #[must_use]
    pub fn response(&self) -> Option<RawField<'_>> {
        let data = self.data.get(..self.length.into())?;
        Some(RawField { set: self.set, descriptor: self.response?, data })
    }

    /// Keeps a response.
    fn keep(&mut self, field: &RawField<'_>) {
        self.response = Some(field.descriptor);
        self.length = field.data.len() as u8;
        self.data.iter_mut().zip(field.data).for_each(|(place, byte)| *place = *byte);
    }

    /// The answer, if the event belongs to this ticket.
    #[must_use]
    pub fn answer<C: Command>(&self, ticket: &Ticket<C>) -> Option<Answer<C::Response>> {
        if self.id != ticket.id {
            return None;
        }
        let response = self.response().and_then(|field| C::Response::from_field(&field));
        Some(match (self.outcome, response) {
            (Outcome::Acknowledged, None) => Answer::Acknowledged(None),
            (Outcome::Acknowledged, Some(Ok(response))) => Answer::Acknowledged(Some(response)),
            (Outcome::Acknowledged, Some(Err(error))) => Answer::Undecodable(error),
            (Outcome::Refused(code), _) => Answer::Refused(code),
            (Outcome::TimedOut, _) => Answer::TimedOut,
            (Outcome::MissingResponse, _) => Answer::MissingResponse,
            (Outcome::Undecodable(error), _) => Answer::Undecodable(error),
        })
    }
}

impl PartialEq for Event {
    fn eq(&self, other: &Self) -> bool {
        (self.id, self.set, self.descriptor, self.outcome, self.response())
            == (other.id, other.set, other.descriptor, other.outcome, other.response())
    }
}

impl fmt::Debug for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { id, set, descriptor, outcome, .. } = self;
        write!(f, "Event({id}: 0x{set:02X},0x{descriptor:02X} {outcome:?}, {:?})", self.response())
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Event {
    fn format(&self, f: defmt::Formatter<'_>) {
        let Self { id, set, descriptor, outcome, .. } = self;
        defmt::write!(f, "Event({}: {},{} {}, {})", id, set, descriptor, outcome, self.response());
    }
}

/// How long a reply may take, unless the command or the caller says otherwise.
pub const DEFAULT_TIMEOUT_MS: u32 = 1000;

impl<const N: usize> Default for Client<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> Client<N> {
    /// A client that waits [`DEFAULT_TIMEOUT_MS`] for a reply.
    #[must_use]
    pub const fn new() -> Self {
        Self::with_timeout(DEFAULT_TIMEOUT_MS)
    }

    /// A client that waits this long for a reply; longer for commands that take longer.
    #[must_use]
    pub const fn with_timeout(timeout_ms: u32) -> Self {
        Self { slots: [Slot::FREE; N], next: 1, happened: 0, timeout_ms }
    }

    /// The number of commands that wait for a reply.
    #[must_use]
    pub fn pending(&self) -> usize {
        self.waiting().count()
    }

    /// Does this command wait for a reply?
    #[must_use]
    pub fn is_pending<C>(&self, ticket: &Ticket<C>) -> bool {
        self.waiting().any(|slot| slot.event.id == ticket.id)
    }

    /// When the next command times out.
    #[must_use]
    pub fn deadline(&self) -> Option<u64> {
        self.waiting().map(|slot| slot.deadline).min()
    }

    fn waiting(&self) -> impl Iterator<Item = &Slot> {
        self.slots.iter().filter(|slot| slot.state == State::Waiting)
    }

    /// Begins a packet with commands of one descriptor set.
    pub fn request(&mut self, set: u8) -> Request<'_, N> {
        for slot in &mut self.slots {
            if slot.state == State::Added {
                slot.state = State::Free; // of a request that was not sent
            }
        }
        Request { client: self, packet: PacketBuilder::new(set) }
    }

    /// A packet with one command, ready to be sent.
    pub fn send<C: Command>(
        &mut self,
        command: &C,
        now_ms: u64,
    ) -> Result<(Ticket<C>, PacketBuilder), RequestError> {
        let mut request = self.request(C::SET);
        let ticket = request.add(command)?;
        Ok((ticket, request.send(now_ms)))
    }

    /// Processes a received packet, and returns the events that have not been taken.
    ///
    /// Data and late or foreign replies cause no events; [`Events::others`] returns them.
    pub fn receive<'p>(&mut self, packet: &Packet<'p>) -> Events<'_, 'p, N> {
        let mut taken = Taken([0; 16]);
        let mut fields = packet.fields().map_while(Result::ok).enumerate();
        while let Some((at, field)) = fields.next() {
            let Some(Ok(ack)) = field.get::<Acknowledge>() else { continue };
            let behind = fields.clone().next();
            let Some((index, outcome, whole)) = self.find(field.set, ack, behind.map(|b| b.1))
            else {
                continue;
            };
            taken.add(at);
            if let (true, Some((at, field)), Some(slot)) =
                (whole, behind, self.slots.get_mut(index))
            {
                slot.event.keep(&field);
                taken.add(at);
                fields.next();
            }
            self.happens(index, outcome);
        }
        Events { client: self, packet: Some(*packet), taken }
    }

    /// The events that have not been taken: of earlier packets, and of commands that timed out.
    pub fn events(&mut self) -> Events<'_, 'static, N> {
        Events { client: self, packet: None, taken: Taken([0; 16]) }
    }

    /// The result of this command, if it is known. Events of other commands are kept.
    ///
    /// That of a silent command is known as soon as it is sent.
    pub fn take<C: Command>(&mut self, ticket: &Ticket<C>) -> Option<Answer<C::Response>> {
        if ticket.silent {
            return Some(Answer::Silent);
        }
        let mut slots = self.slots.iter_mut();
        let slot = slots.find(|s| s.state == State::Done && s.event.id == ticket.id)?;
        slot.state = State::Free;
        slot.event.answer(ticket)
    }

    /// Updates the time. Call it until it returns `None`; the overdue commands then have their
    /// events.
    ///
    /// Noise that looks like the start of a packet holds back what follows. Before a command times
    /// out, this returns the packets behind such noise, to be handled like any other. A packet of
    /// which a part has come is kept.
    pub fn poll<'p>(&mut self, parser: &'p mut Parser, now_ms: u64) -> Option<Packet<'p>> {
        let late = self.deadline().map_or(false, |deadline| deadline <= now_ms);
        let found = if late { parser.look_behind() } else { parser.complete() };
        if late && found.is_none() {
            let late = |slot: &Slot| slot.state == State::Waiting && slot.deadline <= now_ms;
            let next = self.next;
            while let Some(index) = self.oldest(late, |slot| next.wrapping_sub(slot.event.id)) {
                self.happens(index, Outcome::TimedOut);
            }
        }
        found
    }

    /// Stops waiting for a command; it gets no event.
    pub fn cancel<C>(&mut self, ticket: &Ticket<C>) {
        for slot in &mut self.slots {
            if slot.event.id == ticket.id {
                slot.state = State::Free;
            }
        }
    }

    /// The oldest of these slots.
    fn oldest(&self, of: impl Fn(&Slot) -> bool, age: impl Fn(&Slot) -> u32) -> Option<usize> {
        let slots = self.slots.iter().enumerate().filter(|(_, slot)| of(slot));
        slots.max_by_key(|(_, slot)| age(slot)).map(|(index, _)| index)
    }

    /// The command is answered, or given up.
    fn happens(&mut self, index: usize, outcome: Outcome) {
        if let Some(slot) = self.slots.get_mut(index) {
            slot.state = State::Done;
            slot.order = self.happened;
            slot.event.outcome = outcome;
            self.happened = self.happened.wrapping_add(1);
        }
    }

    /// Finds the command that an acknowledge and the field after it answer: the oldest one of its
    /// kind. Returns its result, and whether the field is its response.
    ///
    /// A response never answers a command that does not ask for it, because it may be the late
    /// answer to another one; an acknowledge without a response first answers commands that ask for none.
    fn find(
        &self,
        set: u8,
        ack: Acknowledge,
        behind: Option<RawField<'_>>,
    ) -> Option<(usize, Outcome, bool)> {
        let mut best: Option<((bool, u32), usize, Outcome, bool)> = None;
        for (index, slot) in self.slots.iter().enumerate() {
            let (event, waits) = (&slot.event, slot.state == State::Waiting);
            if !waits || event.set != set || event.descriptor != ack.command {
                continue;
            }
            let response = behind.filter(|field| slot.responses.contains(&field.descriptor));
            let (fits, outcome, whole) = match (slot.wanted, response) {
                _ if ack.code.0 != 0 => (true, Outcome::Refused(ack.code), false),
                (None, None) => (true, Outcome::Acknowledged, false),
                (None, Some(_)) => continue,
                (Some(_), None) => (false, Outcome::MissingResponse, false),
                (Some(check), Some(field)) => match check(&field) {
                    Some(Ok(())) => (true, Outcome::Acknowledged, true),
                    Some(Err(error)) => (true, Outcome::Undecodable(error), true),
                    None => continue,
                },
            };
            let rank = (fits, self.next.wrapping_sub(event.id));
            if best.map_or(true, |(other, ..)| rank > other) {
                best = Some((rank, index, outcome, whole));
            }
        }
        best.map(|(_, index, outcome, whole)| (index, outcome, whole))
    }
}

/// A set of fields of a packet, which has at most 127.
#[derive(Clone, Copy, Debug)]
struct Taken([u8; 16]);

impl Taken {
    fn add(&mut self, at: usize) {
        if let Some(byte) = self.0.get_mut(at >> 3) {
            *byte |= 1 << (at & 7);
        }
    }

    fn has(&self, at: usize) -> bool {
        self.0.get(at >> 3).map_or(false, |byte| byte & (1 << (at & 7)) != 0)
    }
}

/// A packet of commands that is not sent yet. Dropping it discards them.
#[derive(Debug)]
pub struct Request<'c, const N: usize> {
    client: &'c mut Client<N>,
    packet: PacketBuilder,
}

impl<const N: usize> Request<'_, N> {
    /// Appends a command. On an error the request is unchanged.
    pub fn add<C: Command>(&mut self, command: &C) -> Result<Ticket<C>, RequestError> {
        let silent = !command.expects_reply();
        if !silent && self.free().is_none() {
            return Err(RequestError::Busy);
        }
        self.packet.push(command)?;
        let id = self.client.next;
        self.client.next = id.wrapping_add(1);
        if !silent {
            let timeout_ms = C::TIMEOUT_MS.unwrap_or(0);
            let (responses, wanted) = (C::Response::DESCRIPTORS, command.response_check());
            self.enter(id, C::DESCRIPTOR, responses, wanted, timeout_ms);
        }
        Ok(Ticket { id, silent, command: PhantomData })
    }

    fn free(&mut self) -> Option<&mut Slot> {
        self.client.slots.iter_mut().find(|slot| slot.state == State::Free)
    }

    /// Fills a slot: what does not depend on the type of the command, so that it is there once.
    fn enter(
        &mut self,
        id: u32,
        descriptor: u8,
        responses: &'static [u8],
        wanted: Option<ResponseCheck>,
        timeout_ms: u32,
    ) {
        let (set, timeout_ms) = (self.packet.set(), timeout_ms.max(self.client.timeout_ms));
        if let Some(slot) = self.free() {
            slot.state = State::Added;
            (slot.responses, slot.wanted, slot.timeout_ms) = (responses, wanted, timeout_ms);
            let event = &mut slot.event;
            (event.id, event.set, event.descriptor) = (id, set, descriptor);
            (event.outcome, event.response, event.length) = (Outcome::TimedOut, None, 0);
        }
    }

    /// Appends a command whose type is known only at run time.
    pub fn add_any(&mut self, field: &AnyField) -> Result<Ticket<()>, RequestError> {
        field.add_to(self).unwrap_or(Err(RequestError::NoCommand))
    }

    /// The packet to send. From now on its commands are pending.
    #[must_use = "the packet is to be sent"]
    pub fn send(self, now_ms: u64) -> PacketBuilder {
        for slot in &mut self.client.slots {
            if slot.state == State::Added {
                slot.state = State::Waiting;
                slot.deadline = now_ms.saturating_add(slot.timeout_ms.into());
            }
        }
        self.packet
    }
}

/// The events that have not been taken, oldest first. Untaken events remain in the client.
#[derive(Debug)]
pub struct Events<'c, 'p, const N: usize> {
    client: &'c mut Client<N>,
    packet: Option<Packet<'p>>,
    taken: Taken,
}

impl<'p, const N: usize> Events<'_, 'p, N> {
    /// The fields of the packet that answer no command: data, and unexpected replies.
    pub fn others(&self) -> impl Iterator<Item = Result<RawField<'p>, FieldLengthError>> + Clone {
        let taken = self.taken;
        let fields = self.packet.into_iter().flat_map(|packet| packet.fields()).enumerate();
        fields.filter(move |(at, _)| !taken.has(*at)).map(|(_, field)| field)
    }
}

impl<const N: usize> Iterator for Events<'_, '_, N> {
    type Item = Event;

    fn next(&mut self) -> Option<Event> {
        let happened = self.client.happened;
        let done = |slot: &Slot| slot.state == State::Done;
        let index = self.client.oldest(done, |slot| happened.wrapping_sub(slot.order))?;
        let slot = self.client.slots.get_mut(index)?;
        slot.state = State::Free;
        Some(slot.event.clone())
    }
}
