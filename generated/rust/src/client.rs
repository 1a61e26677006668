//! Sends commands and recognizes their replies, without doing input or output itself.

use core::fmt;
use core::marker::PhantomData;

use crate::codec::{DecodeError, EncodeError};
use crate::field::{Command, Field, RawField, Response};
use crate::list::List;
use crate::packet::{Fields, Packet, PacketBuilder};
use crate::protocol::{AckCode, Acknowledge};

/// Keeps track of the commands that a device has not answered yet, at most `N` of them.
///
/// The caller moves the bytes and has the clock: any count of milliseconds that does not go back.
///
/// 1. [`Client::request`] begins a packet, [`Request::add`] puts commands into it, and
///    [`Request::send`] gives the bytes to send.
/// 2. Every packet that comes goes through [`Client::receive`], which yields an [`Event`] for each
///    command that it answers. Other packets yield nothing.
/// 3. From time to time [`Client::expire`] yields an event for each command that took too long.
#[derive(Clone, Debug)]
pub struct Client<const N: usize = 8> {
    pending: List<Pending, N>,
    next: u32,
    timeout_ms: u32,
}

#[derive(Clone, Copy, Debug, Default)]
struct Pending {
    id: u32,
    set: u8,
    descriptor: u8,
    timeout_ms: u32,
    deadline: u64,
}

/// Stands for one command that was sent, and knows what answers it.
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

    /// Will nothing ever answer it? Then there is no event either.
    #[must_use]
    pub const fn is_silent(&self) -> bool {
        self.silent
    }
}

impl<C> Clone for Ticket<C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for Ticket<C> {}

impl<C: Field> fmt::Debug for Ticket<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Ticket({}, {})", self.id, C::NAME)
    }
}

/// Why a command could not be put into a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RequestError {
    /// The command does not encode, or the packet is full.
    Encode(EncodeError),
    /// As many commands are pending as the client can hold.
    Busy,
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
        }
    }
}

#[cfg(feature = "std")]
impl std::error::Error for RequestError {}

/// What became of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Answer<R> {
    /// It was carried out; with the response, if one came.
    Acknowledged(Option<R>),
    /// The device refused it.
    Refused(AckCode),
    /// Nothing came in time.
    TimedOut,
    /// It was carried out, but the response could not be decoded.
    Undecodable(DecodeError),
}

/// What became of a command, its response not decoded yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Event<'a> {
    /// The number of the ticket.
    pub id: u32,
    /// The descriptor set of the command.
    pub set: u8,
    /// The descriptor of the command.
    pub descriptor: u8,
    /// How it went: `None` if nothing came in time.
    pub code: Option<AckCode>,
    /// The field behind the acknowledge.
    pub response: Option<RawField<'a>>,
}

impl Event<'_> {
    /// The answer, if the event belongs to this ticket.
    #[must_use]
    pub fn answer<C: Command>(&self, ticket: &Ticket<C>) -> Option<Answer<C::Response>> {
        if self.id != ticket.id {
            return None;
        }
        let response = self.response.as_ref().and_then(C::Response::from_field);
        Some(match (self.code, response) {
            (None, _) => Answer::TimedOut,
            (Some(AckCode(0)), None) => Answer::Acknowledged(None),
            (Some(AckCode(0)), Some(Ok(response))) => Answer::Acknowledged(Some(response)),
            (Some(AckCode(0)), Some(Err(error))) => Answer::Undecodable(error),
            (Some(code), _) => Answer::Refused(code),
        })
    }
}

/// How long a reply may take where neither the command nor the caller says otherwise.
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

    /// A client that waits so long for a reply; longer where a command is known to take longer.
    #[must_use]
    pub fn with_timeout(timeout_ms: u32) -> Self {
        Self { pending: List::new(), next: 1, timeout_ms }
    }

    /// How many commands wait for a reply.
    #[must_use]
    pub fn pending(&self) -> usize {
        self.pending.len()
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

    /// The events that a packet causes. Streams of data and foreign replies cause none.
    #[must_use = "the packet is looked at while the events are taken"]
    pub fn receive<'c, 'p>(&'c mut self, packet: &Packet<'p>) -> Events<'c, 'p, N> {
        Events { client: self, fields: packet.fields() }
    }

    /// An event for each command whose time is over.
    #[must_use = "commands time out while the events are taken"]
    pub fn expire(&mut self, now_ms: u64) -> impl Iterator<Item = Event<'static>> + '_ {
        core::iter::from_fn(move || {
            let late = self.pending.iter().position(|p| p.deadline <= now_ms)?;
            let Pending { id, set, descriptor, .. } = self.remove(late)?;
            Some(Event { id, set, descriptor, code: None, response: None })
        })
    }

    /// Stops waiting for a command; a reply that comes later causes no event.
    pub fn cancel<C>(&mut self, ticket: &Ticket<C>) {
        if let Some(index) = self.pending.iter().position(|p| p.id == ticket.id) {
            self.remove(index);
        }
    }

    fn remove(&mut self, index: usize) -> Option<Pending> {
        let found = self.pending.get(index).copied();
        let mut kept = List::new();
        for (i, entry) in self.pending.iter().enumerate() {
            if i != index && kept.push(*entry).is_err() {
                break;
            }
        }
        self.pending = kept;
        found
    }
}

/// A packet with commands that is not sent yet. Dropping it forgets them.
#[derive(Debug)]
pub struct Request<'c, const N: usize> {
    client: &'c mut Client<N>,
    packet: PacketBuilder,
    added: List<Pending, N>,
}

impl<const N: usize> Request<'_, N> {
    /// Appends a command. If it is refused, the request stays as it was.
    pub fn add<C: Command>(&mut self, command: &C) -> Result<Ticket<C>, RequestError> {
        let silent = !command.expects_reply();
        let waiting = self.client.pending.len().saturating_add(self.added.len());
        if !silent && waiting >= N {
            return Err(RequestError::Busy);
        }
        self.packet.push(command)?;
        let id = self.client.next;
        self.client.next = id.wrapping_add(1);
        if !silent {
            let timeout_ms = C::TIMEOUT_MS.unwrap_or(0).max(self.client.timeout_ms);
            let (set, descriptor) = (self.packet.set(), C::DESCRIPTOR);
            let entry = Pending { id, set, descriptor, timeout_ms, deadline: 0 };
            self.added.push(entry).map_err(|_| RequestError::Busy)?;
        }
        Ok(Ticket { id, silent, command: PhantomData })
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

/// The events of one packet, in order.
#[derive(Debug)]
pub struct Events<'c, 'p, const N: usize> {
    client: &'c mut Client<N>,
    fields: Fields<'p>,
}

impl<'p, const N: usize> Iterator for Events<'_, 'p, N> {
    type Item = Event<'p>;

    fn next(&mut self) -> Option<Event<'p>> {
        loop {
            let field = self.fields.next()?.ok()?;
            let Some(Ok(ack)) = field.get::<Acknowledge>() else { continue };
            let answered = |p: &Pending| p.set == field.set && p.descriptor == ack.command;
            let Some(index) = self.client.pending.iter().position(answered) else { continue };
            let Pending { id, set, descriptor, .. } = self.client.remove(index)?;
            let behind = self.fields.clone().next().and_then(Result::ok);
            let response = behind.filter(|f| !f.is::<Acknowledge>());
            return Some(Event { id, set, descriptor, code: Some(ack.code), response });
        }
    }
}
