//! Sends commands and recognizes their replies, without input or output.

use core::fmt;
use core::marker::PhantomData;

use crate::error::{DecodeError, EncodeError};
use crate::field::{Command, RawField, Response, ResponseCheck};
use crate::list::{Item, List};
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
    pending: List<Pending, N>,
    /// Together with the pending ones never more than `N`.
    events: List<Event, N>,
    next: u32,
    timeout_ms: u32,
}

#[derive(Clone, Copy)]
struct Pending {
    id: u32,
    set: u8,
    descriptor: u8,
    /// The descriptors of all responses of the command, and the check for the one that it asks for.
    responses: &'static [u8],
    wanted: Option<ResponseCheck>,
    timeout_ms: u32,
    deadline: u64,
}

impl Item for Pending {
    const BLANK: Self = Self {
        id: 0,
        set: 0,
        descriptor: 0,
        responses: &[],
        wanted: None,
        timeout_ms: 0,
        deadline: 0,
    };
}

impl fmt::Debug for Pending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { id, set, descriptor, deadline, .. } = self;
        write!(f, "{id}: 0x{set:02X},0x{descriptor:02X} until {deadline}")
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
}

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
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Event {
    /// The number of the ticket.
    pub id: u32,
    /// The descriptor set of the command.
    pub set: u8,
    /// The descriptor of the command.
    pub descriptor: u8,
    /// The result.
    pub outcome: Outcome,
    /// Descriptor and data of the response.
    response: Option<(u8, List<u8, MAX_FIELD_DATA>)>,
}

impl Item for Event {
    const BLANK: Self =
        Self { id: 0, set: 0, descriptor: 0, outcome: Outcome::TimedOut, response: None };
}

impl Event {
    /// The undecoded response.
    #[must_use]
    pub fn response(&self) -> Option<RawField<'_>> {
        let (descriptor, data) = self.response.as_ref()?;
        Some(RawField { set: self.set, descriptor: *descriptor, data })
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
    pub fn new() -> Self {
        Self::with_timeout(DEFAULT_TIMEOUT_MS)
    }

    /// A client that waits this long for a reply; longer for commands that take longer.
    #[must_use]
    pub fn with_timeout(timeout_ms: u32) -> Self {
        Self { pending: List::new(), events: List::new(), next: 1, timeout_ms }
    }

    /// The number of commands that wait for a reply.
    #[must_use]
    pub fn pending(&self) -> usize {
        self.pending.len()
    }

    /// Does this command wait for a reply?
    #[must_use]
    pub fn is_pending<C>(&self, ticket: &Ticket<C>) -> bool {
        self.pending.iter().any(|p| p.id == ticket.id)
    }

    /// When the next command times out.
    #[must_use]
    pub fn deadline(&self) -> Option<u64> {
        self.pending.iter().map(|p| p.deadline).min()
    }

    /// Begins a packet with commands of one descriptor set.
    pub fn request(&mut self, set: u8) -> Request<'_, N> {
        Request { client: self, packet: PacketBuilder::new(set), added: List::new() }
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
        let mut taken = 0;
        let mut fields = packet.fields().map_while(Result::ok).enumerate();
        while let Some((at, field)) = fields.next() {
            let Some(Ok(ack)) = field.get::<Acknowledge>() else { continue };
            let behind = fields.clone().next().map(|(_, field)| field);
            let Some((index, outcome, whole)) = self.find(field.set, ack, behind) else { continue };
            let Some(Pending { id, set, descriptor, .. }) = remove(&mut self.pending, index) else {
                continue;
            };
            taken |= bit(at);
            let mut event = Event { id, set, descriptor, outcome, response: None };
            if let (true, Some((at, field))) = (whole, fields.clone().next()) {
                let data = List::from_slice(field.data).unwrap_or_default();
                event.response = Some((field.descriptor, data));
                taken |= bit(at);
                fields.next();
            }
            self.happened(event);
        }
        Events { client: self, packet: Some(*packet), taken }
    }

    /// The events that have not been taken: of earlier packets, and of commands that timed out.
    pub fn events(&mut self) -> Events<'_, 'static, N> {
        Events { client: self, packet: None, taken: 0 }
    }

    /// The result of this command, if it is known. Events of other commands are kept.
    pub fn take<C: Command>(&mut self, ticket: &Ticket<C>) -> Option<Answer<C::Response>> {
        let index = self.events.iter().position(|event| event.id == ticket.id)?;
        remove(&mut self.events, index)?.answer(ticket)
    }

    /// Updates the time. Call it until it returns `None`; the overdue commands then have their
    /// events.
    ///
    /// Noise that looks like the start of a packet holds back what follows. Before a command times
    /// out, this returns the packets behind such noise, to be handled like any other. A packet of
    /// which a part has come is kept.
    pub fn poll<'p>(&mut self, parser: &'p mut Parser, now_ms: u64) -> Option<Packet<'p>> {
        let late = self.pending.iter().any(|p| p.deadline <= now_ms);
        let found = if late { parser.look_behind() } else { parser.next(&mut [].as_slice()) };
        if found.is_none() {
            while let Some(at) = self.pending.iter().position(|p| p.deadline <= now_ms) {
                let Some(Pending { id, set, descriptor, .. }) = remove(&mut self.pending, at)
                else {
                    break;
                };
                let outcome = Outcome::TimedOut;
                self.happened(Event { id, set, descriptor, outcome, response: None });
            }
        }
        found
    }

    /// Stops waiting for a command; it gets no event.
    pub fn cancel<C>(&mut self, ticket: &Ticket<C>) {
        if let Some(index) = self.pending.iter().position(|p| p.id == ticket.id) {
            remove(&mut self.pending, index);
        }
        if let Some(index) = self.events.iter().position(|event| event.id == ticket.id) {
            remove(&mut self.events, index);
        }
    }

    /// Keeps an event, in the slot that its command has freed.
    fn happened(&mut self, event: Event) {
        let kept = self.events.push(event);
        debug_assert!(kept.is_ok());
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
        let mut left_alone = None;
        for (index, pending) in self.pending.iter().enumerate() {
            if pending.set != set || pending.descriptor != ack.command {
                continue;
            }
            if ack.code.0 != 0 {
                return Some((index, Outcome::Refused(ack.code), false));
            }
            let response = behind.filter(|field| pending.responses.contains(&field.descriptor));
            match (pending.wanted, response) {
                (None, None) => return Some((index, Outcome::Acknowledged, false)),
                (None, Some(_)) => {}
                (Some(_), None) => left_alone = left_alone.or(Some(index)),
                (Some(check), Some(field)) => match check(&field) {
                    Some(Ok(())) => return Some((index, Outcome::Acknowledged, true)),
                    Some(Err(error)) => return Some((index, Outcome::Undecodable(error), true)),
                    None => {}
                },
            }
        }
        left_alone.map(|index| (index, Outcome::MissingResponse, false))
    }
}

/// Removes an item from a list; later items move up.
fn remove<T: Item, const N: usize>(list: &mut List<T, N>, index: usize) -> Option<T> {
    list.get(index)?;
    let mut found = list.pop()?;
    for place in list.iter_mut().skip(index).rev() {
        core::mem::swap(place, &mut found);
    }
    Some(found)
}

/// One bit for each field of a packet, which has at most 127.
fn bit(at: usize) -> u128 {
    u32::try_from(at).ok().and_then(|at| 1_u128.checked_shl(at)).unwrap_or_default()
}

/// A packet of commands that is not sent yet. Dropping it discards them.
#[derive(Debug)]
pub struct Request<'c, const N: usize> {
    client: &'c mut Client<N>,
    packet: PacketBuilder,
    added: List<Pending, N>,
}

impl<const N: usize> Request<'_, N> {
    /// Appends a command. On an error the request is unchanged.
    pub fn add<C: Command>(&mut self, command: &C) -> Result<Ticket<C>, RequestError> {
        let silent = !command.expects_reply();
        let places = [self.client.pending.len(), self.client.events.len(), self.added.len()];
        if !silent && places.iter().sum::<usize>() >= N {
            return Err(RequestError::Busy);
        }
        self.packet.push(command)?;
        let id = self.client.next;
        self.client.next = id.wrapping_add(1);
        if !silent {
            let timeout_ms = C::TIMEOUT_MS.unwrap_or(0).max(self.client.timeout_ms);
            let (set, descriptor) = (self.packet.set(), C::DESCRIPTOR);
            let (responses, wanted) = (C::Response::DESCRIPTORS, command.response_check());
            let entry = Pending { id, set, descriptor, responses, wanted, timeout_ms, deadline: 0 };
            self.added.push(entry).map_err(|_| RequestError::Busy)?;
        }
        Ok(Ticket { id, silent, command: PhantomData })
    }

    /// Appends a command whose type is known only at run time.
    pub fn add_any(&mut self, field: &AnyField) -> Result<Ticket<()>, RequestError> {
        field.add_to(self).unwrap_or(Err(RequestError::NoCommand))
    }

    /// The packet to send. From now on its commands are pending.
    #[must_use = "the packet is to be sent"]
    pub fn send(self, now_ms: u64) -> PacketBuilder {
        for entry in &self.added {
            let deadline = now_ms.saturating_add(entry.timeout_ms.into());
            if self.client.pending.push(Pending { deadline, ..*entry }).is_err() {
                break;
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
    taken: u128,
}

impl<'p, const N: usize> Events<'_, 'p, N> {
    /// The fields of the packet that answer no command: data, and unexpected replies.
    pub fn others(&self) -> impl Iterator<Item = Result<RawField<'p>, FieldLengthError>> + Clone {
        let taken = self.taken;
        let fields = self.packet.into_iter().flat_map(|packet| packet.fields()).enumerate();
        fields.filter(move |(at, _)| taken & bit(*at) == 0).map(|(_, field)| field)
    }
}

impl<const N: usize> Iterator for Events<'_, '_, N> {
    type Item = Event;

    fn next(&mut self) -> Option<Event> {
        remove(&mut self.client.events, 0)
    }
}
