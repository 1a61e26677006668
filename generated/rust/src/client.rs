//! Encodes commands and recognizes their replies, without input or output.

use core::cell::Cell;
use core::fmt;
use core::marker::PhantomData;

use crate::codec::Writer;
use crate::error::{DecodeError, EncodeError, EncodeErrorKind};
use crate::field::{Command, Field, RawField, Response, ResponseCheck};
use crate::packet::{FieldLengthError, Fields, Packet, PacketBuilder, MAX_PAYLOAD};
use crate::parser::Parser;
use crate::protocol::{AckCode, Acknowledge, DescriptorSet, BARRIER};
#[cfg(feature = "registry")]
use crate::registry::AnyField;
use crate::view::{View, Viewed};

/// Tracks at most `N` commands that a device has not answered yet.
///
/// The caller transfers the bytes and provides the time: a count of milliseconds that only goes
/// forward, and may wrap around. A [`Device`](crate::device::Device) does both for a port.
///
/// 1. [`Client::barrier`] returns a packet to send first, if an earlier command was not answered.
///    Without it, a late reply to that command may be matched to the next command of its type.
/// 2. [`Client::send`] returns the bytes of one command to send; for several in one packet,
///    [`Client::request`] begins it, [`Request::add`] adds commands to it, and [`Request::send`]
///    returns its bytes.
/// 3. Pass every received packet to [`Client::receive`], which yields an [`Event`] for each command
///    that it answers, and gives access to the other fields of the packet.
/// 4. Call [`Client::poll`] regularly with the current time; it creates the events of commands that
///    have timed out.
///
/// Events that are not taken are kept, and returned by the next call, by [`Client::events`] or by
/// [`Client::take`]. For this purpose, each of the `N` slots has room for the longest response. The
/// packet to send is also in the client, so that it need not be moved.
///
/// A client is `Send` and not `Sync`, because taking an event marks it as taken through a shared
/// reference. Threads, tasks or interrupts that share a client need a mutex, as for everything that
/// takes `&mut self`.
#[derive(Clone, Debug)]
pub struct Client<const N: usize = 8> {
    table: Table<[Slot; N]>,
}

/// The part of a client that does not depend on the number of slots, so that its code exists once.
///
/// In a new client it is all zeros, so that a client in static memory needs no initial values in
/// flash.
#[derive(Clone, Debug)]
struct Table<S: ?Sized> {
    packet: PacketBuilder,
    /// The number of the next command, and that of the next event.
    next: u32,
    happened: u32,
    /// The number of commands without a reply since the last answered barrier, at most
    /// [`BARRIERS`].
    missed: u8,
    /// The number of commands in the last barrier, until it is answered.
    behind: u8,
    /// The reply time-out minus [`DEFAULT_TIMEOUT_MS`]; it may wrap around.
    patience: u32,
    /// A bit for each field of the last packet, set if it answers a command; there are at most 127.
    taken: [u32; 4],
    slots: S,
}

type Slots = Table<[Slot]>;

/// A command, from when it is added to a request until its event is taken.
#[derive(Clone)]
struct Slot {
    /// Taking an event changes only this, so that the event can be borrowed.
    state: Cell<State>,
    /// The event's sequence number; simultaneous events share one.
    order: u32,
    /// The time at which it times out; until it is sent, its time-out.
    deadline: u32,
    /// The number of commands in the barrier that must be answered first.
    behind: u8,
    event: Event,
}

/// The properties that all commands of a type share.
pub(crate) struct Kind {
    name: &'static str,
    set: DescriptorSet,
    descriptor: u8,
    timeout_ms: u32,
    /// The descriptors of all responses.
    responses: &'static [u8],
}

/// Returns them.
#[allow(dead_code)] // without the features of command sets
pub(crate) const fn kind<C: Command>() -> &'static Kind {
    KindOf::<C>::KIND
}

impl Kind {
    /// Returns the name of the command in the specification.
    #[allow(dead_code)] // without the features of command sets
    pub(crate) const fn name(&self) -> &'static str {
        self.name
    }
}

struct KindOf<C>(PhantomData<C>);

impl<C: Command> KindOf<C> {
    const KIND: &'static Kind = &Kind {
        name: C::NAME,
        set: C::SET,
        descriptor: C::DESCRIPTOR,
        timeout_ms: match C::TIMEOUT_MS {
            Some(timeout_ms) => timeout_ms,
            None => 0,
        },
        responses: C::RESPONSES,
    };
}

/// A command of any type, so that the code that sends it exists once.
pub(crate) trait AnyCommand {
    fn kind(&self) -> &'static Kind;
    fn is_silent(&self) -> bool;
    fn wanted(&self) -> Option<ResponseCheck>;
    fn write_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind>;
}

impl<C: Command> AnyCommand for C {
    fn kind(&self) -> &'static Kind {
        KindOf::<C>::KIND
    }

    fn is_silent(&self) -> bool {
        !self.expects_reply()
    }

    fn wanted(&self) -> Option<ResponseCheck> {
        self.response_check()
    }

    fn write_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        self.encode_to(writer)
    }
}

/// A command that is sent without waiting for a reply.
pub(crate) struct Silent<'c, C>(pub(crate) &'c C);

impl<C: AnyCommand> AnyCommand for Silent<'_, C> {
    fn kind(&self) -> &'static Kind {
        self.0.kind()
    }

    fn is_silent(&self) -> bool {
        true
    }

    fn wanted(&self) -> Option<ResponseCheck> {
        None
    }

    fn write_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        self.0.write_to(writer)
    }
}

/// A command in bytes: for a few commands, this takes less code than their types.
#[allow(dead_code)] // without the features of command sets
pub(crate) struct Bytes<'d> {
    pub(crate) kind: &'static Kind,
    /// The check for the response that it requests.
    pub(crate) check: Option<ResponseCheck>,
    pub(crate) data: &'d [u8],
}

#[allow(dead_code)] // without the features of command sets
impl<'d> Bytes<'d> {
    /// Creates a command without a response.
    pub(crate) const fn of(kind: &'static Kind, data: &'d [u8]) -> Self {
        Self { kind, check: None, data }
    }

    /// Returns the field that is sent.
    #[cfg(feature = "open")]
    pub(crate) const fn field(&self) -> RawField<'d> {
        RawField { set: self.kind.set, descriptor: self.kind.descriptor, data: self.data }
    }
}

impl AnyCommand for Bytes<'_> {
    fn kind(&self) -> &'static Kind {
        self.kind
    }

    fn is_silent(&self) -> bool {
        false
    }

    fn wanted(&self) -> Option<ResponseCheck> {
        self.check
    }

    fn write_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        writer.put(self.data)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Free,
    /// Part of a request that is not sent yet.
    Added,
    Waiting,
    /// The event has happened.
    Done,
}

impl Slot {
    #[allow(clippy::declare_interior_mutable_const)] // it is only copied
    const FREE: Self = Self {
        state: Cell::new(State::Free),
        order: 0,
        deadline: 0,
        behind: 0,
        event: Event::NONE,
    };

    fn is(&self, state: State) -> bool {
        self.state.get() == state
    }
}

impl fmt::Debug for Slot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { state, deadline, event: Event { id, set, descriptor, .. }, .. } = self;
        write!(f, "{id}: 0x{:02X},0x{descriptor:02X} {:?} until {deadline}", set.0, state.get())
    }
}

/// Identifies a command that was sent, and the type of its response.
pub struct Ticket<C> {
    id: u32,
    silent: bool,
    command: PhantomData<fn() -> C>,
}

impl<C> Ticket<C> {
    /// Returns the number that the command's event contains.
    #[must_use]
    pub const fn id(&self) -> u32 {
        self.id
    }

    /// Does the device not answer the command? Then there is no event.
    #[must_use]
    pub const fn is_silent(&self) -> bool {
        self.silent
    }

    /// Returns it for another type of command.
    pub(crate) const fn of<D>(self) -> Ticket<D> {
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RequestError {
    /// The command cannot be encoded, or the packet is full.
    Encode(EncodeError),
    /// All slots are in use, by pending commands or by events that were not taken.
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
            Self::NoCommand => f.write_str("the field is not a command"),
        }
    }
}

error!(RequestError);

/// A command without a result. The device may have carried it out, except if it refused it.
///
/// ```
/// use mip_protocol::client::{CommandError, Reason};
///
/// let error = CommandError::new("base.ping", Reason::TimedOut);
/// assert_eq!(error.to_string(), "base.ping: no reply arrived in time");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct CommandError {
    /// The name of the command in the specification, `family.field`.
    pub command: &'static str,
    /// Why it has no result.
    pub reason: Reason,
}

/// Why a command has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Reason {
    /// The device rejected it.
    Refused(AckCode),
    /// No reply arrived in time.
    TimedOut,
    /// It was acknowledged without the response that it requests.
    MissingResponse,
    /// It was carried out, but the response could not be decoded.
    Undecodable(DecodeError),
    /// Its result was not kept, because other commands were sent after it.
    Forgotten,
}

impl CommandError {
    /// Creates the error of the command with this name.
    #[must_use]
    pub const fn new(command: &'static str, reason: Reason) -> Self {
        Self { command, reason }
    }

    pub(crate) const fn of<C: Command>(reason: Reason) -> Self {
        Self::new(C::NAME, reason)
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(code) => {
                f.write_str("the device rejected the command: ")?;
                let Some(name) = code.name() else { return write!(f, "code {}", code.0) };
                name.split('_').try_for_each(|word| write!(f, "{word} "))?;
                write!(f, "({})", code.0)
            }
            Self::TimedOut => f.write_str("no reply arrived in time"),
            Self::MissingResponse => f.write_str("the response is missing"),
            Self::Undecodable(_) => f.write_str("the response cannot be decoded"),
            Self::Forgotten => f.write_str("other commands were sent after it"),
        }
    }
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.command, self.reason)
    }
}

#[cfg(any(feature = "core-error", feature = "std"))]
impl crate::error::Error for CommandError {
    fn source(&self) -> Option<&(dyn crate::error::Error + 'static)> {
        match &self.reason {
            Reason::Undecodable(error) => Some(error),
            _ => None,
        }
    }
}

/// The result of a command, with the response not yet decoded.
#[derive(Clone)]
pub struct Event {
    /// The number of the ticket.
    pub id: u32,
    /// The descriptor set of the command.
    pub set: DescriptorSet,
    /// The descriptor of the command.
    pub descriptor: u8,
    kind: Option<&'static Kind>,
    /// The check for the response that the command requests.
    check: Option<ResponseCheck>,
    outcome: Outcome,
    /// A payload that begins with the response; zeros if there is none.
    response: [u8; MAX_PAYLOAD],
}

impl Event {
    const NONE: Self = Self {
        id: 0,
        set: DescriptorSet(0),
        descriptor: 0,
        kind: None,
        check: None,
        outcome: Outcome::Complete,
        response: [0; MAX_PAYLOAD],
    };

    /// Returns the name of the command in the specification, `family.field`.
    #[must_use]
    pub fn command(&self) -> &'static str {
        self.kind.map_or("", |kind| kind.name)
    }

    /// Returns the result: `Ok` if the device carried it out, and the response is present, if the
    /// command requests one.
    ///
    /// # Errors
    ///
    /// The reason why the command has no result.
    pub fn outcome(&self) -> Result<(), Reason> {
        let reply = self.reply()?;
        judged(reply.and_then(|field| self.check.and_then(|check| check(&field))), Some(()))
    }

    /// Returns the undecoded response.
    #[must_use]
    pub fn response(&self) -> Option<RawField<'_>> {
        Fields::new(self.set, &self.response).sound()
    }

    /// Stores the first of these fields as the response.
    fn keep(&mut self, fields: &Fields<'_>) {
        self.response.iter_mut().zip(fields.payload()).for_each(|(place, byte)| *place = *byte);
    }

    /// Returns the response, or `()` for a command without one, if the event belongs to this ticket.
    #[must_use]
    pub fn answer<C: Command>(
        &self,
        ticket: &Ticket<C>,
    ) -> Option<Result<C::Response, CommandError>> {
        (self.id == ticket.id).then(|| self.decoded::<C>())
    }

    /// Like [`Event::answer`], but the response is read in place, without copying.
    #[must_use]
    pub fn view<'e, C: Command>(
        &'e self,
        ticket: &Ticket<C>,
    ) -> Option<Result<View<'e, C::Response>, CommandError>>
    where
        C::Response: Field + Viewed,
    {
        let read = |field: RawField<'e>| field.view::<C::Response>().transpose();
        let viewed = || judged(self.reply()?.and_then(read), None);
        (self.id == ticket.id).then(|| viewed().map_err(CommandError::of::<C>))
    }

    fn decoded<C: Command>(&self) -> Result<C::Response, CommandError> {
        self.reply().map_err(CommandError::of::<C>).and_then(response::<C>)
    }

    /// Returns the response, which may be absent, if the device has carried out the command.
    fn reply(&self) -> Result<Option<RawField<'_>>, Reason> {
        match self.outcome {
            Outcome::Complete => Ok(self.response()),
            Outcome::MissingResponse => Err(Reason::MissingResponse),
            Outcome::Refused(code) => Err(Reason::Refused(code)),
            Outcome::TimedOut => Err(Reason::TimedOut),
        }
    }
}

/// Decodes the response to a command that the device has carried out.
pub(crate) fn response<C: Command>(
    reply: Option<RawField<'_>>,
) -> Result<C::Response, CommandError> {
    let found = reply.and_then(|field| C::Response::from_field(&field));
    judged(found, C::Response::absent()).map_err(CommandError::of::<C>)
}

/// Chooses between a response that was found, and the value without one.
fn judged<R>(found: Option<Result<R, DecodeError>>, absent: Option<R>) -> Result<R, Reason> {
    match found {
        Some(found) => found.map_err(Reason::Undecodable),
        None => absent.ok_or(Reason::MissingResponse),
    }
}

impl PartialEq for Event {
    fn eq(&self, other: &Self) -> bool {
        (self.id, self.set, self.descriptor, self.outcome(), self.response())
            == (other.id, other.set, other.descriptor, other.outcome(), other.response())
    }
}

/// What is known of a command's result. The first one is zero, so that a new client is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// Acknowledged, with the response that it requests, which may be impossible to decode.
    Complete,
    MissingResponse,
    Refused(AckCode),
    TimedOut,
}

impl fmt::Debug for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (command, outcome) = (self.command(), self.outcome());
        write!(f, "Event({}: {command} {outcome:?}, {:?})", self.id, self.response())
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Event {
    fn format(&self, f: defmt::Formatter<'_>) {
        let (command, outcome) = (self.command(), self.outcome());
        defmt::write!(f, "Event({}: {} {}, {})", self.id, command, outcome, self.response());
    }
}

/// The reply time-out, unless the command or the caller sets another one.
pub const DEFAULT_TIMEOUT_MS: u32 = 1000;

/// The number of different barriers: they have 2 to 63 commands, whose replies fit into one packet.
const BARRIERS: u8 = 62;

/// The longest wait in ms; longer ones would be ambiguous because the time wraps around.
const FUTURE: u32 = u32::MAX >> 1;

/// Returns the time after a number of milliseconds.
pub(crate) fn after(now_ms: u32, wait_ms: u32) -> u32 {
    now_ms.wrapping_add(wait_ms.min(FUTURE))
}

/// Has this time been reached?
pub(crate) const fn has_passed(deadline: u32, now_ms: u32) -> bool {
    now_ms.wrapping_sub(deadline) <= FUTURE
}

impl<const N: usize> Default for Client<N> {
    fn default() -> Self {
        Self::with_timeout(DEFAULT_TIMEOUT_MS)
    }
}

impl Client {
    /// Creates a client with eight slots that waits [`DEFAULT_TIMEOUT_MS`] for a reply. For another
    /// number of slots, call [`Client::default`] or [`Client::with_timeout`].
    ///
    /// ```
    /// use mip_protocol::client::{Client, DEFAULT_TIMEOUT_MS};
    ///
    /// let client = Client::new();
    /// assert_eq!((client.pending(), client.deadline()), (0, None));
    /// static SMALL: std::sync::Mutex<Client<1>> =
    ///     std::sync::Mutex::new(Client::with_timeout(DEFAULT_TIMEOUT_MS));
    /// ```
    #[must_use]
    pub const fn new() -> Self {
        Self::with_timeout(DEFAULT_TIMEOUT_MS)
    }
}

impl<const N: usize> Client<N> {
    /// Creates a client that waits this long for a reply, or longer if the specification states so
    /// for a command. The longest time is 2³¹ - 1 ms, 24.8 days.
    #[must_use]
    pub const fn with_timeout(timeout_ms: u32) -> Self {
        let mut client = Self::NEW;
        client.table.patience = timeout_ms.wrapping_sub(DEFAULT_TIMEOUT_MS);
        client
    }

    /// A constant, so that creating a client clears memory instead of copying it.
    #[allow(clippy::declare_interior_mutable_const)] // it is only copied
    const NEW: Self = Self {
        table: Table {
            packet: PacketBuilder::BLANK,
            next: 0,
            happened: 0,
            missed: 0,
            behind: 0,
            patience: 0,
            taken: [0; 4],
            slots: [Slot::FREE; N],
        },
    };

    /// Returns the number of commands that wait for a reply.
    #[must_use]
    pub fn pending(&self) -> usize {
        self.table().waiting().count()
    }

    /// Does this command wait for a reply?
    #[must_use]
    pub fn is_pending<C>(&self, ticket: &Ticket<C>) -> bool {
        self.table().waiting().any(|slot| slot.event.id == ticket.id)
    }

    /// Returns the time at which the next command times out.
    ///
    /// Time wraps around: the deadline has passed if `now_ms.wrapping_sub(deadline) <= u32::MAX /
    /// 2`.
    #[must_use]
    pub fn deadline(&self) -> Option<u32> {
        let mut first = None;
        for slot in self.table().waiting() {
            if first.map_or(true, |first| !has_passed(first, slot.deadline)) {
                first = Some(slot.deadline);
            }
        }
        first
    }

    /// Returns the barrier to send before the next packet of commands, or `None` if no earlier
    /// command is without a reply. If you call this before [`Client::send`] and
    /// [`Client::request`], and send what it returns, a late reply is never matched to a later
    /// command.
    ///
    /// A barrier is a packet of several commands that change nothing. The device replies in order,
    /// and to all commands of a packet in one packet, whose size identifies the barrier. Before the
    /// reply to the barrier, no reply is matched to a command sent after it; after that, none is
    /// matched to a command sent before it, which has timed out. If the barrier is not answered,
    /// the commands after it time out, although the device may have carried them out.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// use mip_protocol::{base::Ping, Client, Parser};
    ///
    /// let (mut client, mut parser) = (Client::new(), Parser::new());
    /// assert_eq!(client.barrier(), None);
    /// client.send(&Ping::new(), 0).unwrap();
    /// assert_eq!(client.poll(&mut parser, 1000), None); // it has timed out
    /// assert_eq!(client.barrier().unwrap().fields().count(), 2); // send this before the next command
    /// # }
    /// ```
    #[must_use = "the barrier must be sent"]
    pub fn barrier(&mut self) -> Option<Packet<'_>> {
        self.table_mut().barrier()
    }

    /// Begins a packet with commands of one descriptor set.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// use mip_protocol::base::{self, GetDeviceInfo, Ping};
    /// use mip_protocol::Client;
    ///
    /// let mut client = Client::new();
    /// let mut request = client.request(base::SET);
    /// let ping = request.add(&Ping::new()).unwrap();
    /// let info = request.add(&GetDeviceInfo::new()).unwrap();
    /// let packet = request.send(0);
    /// assert_eq!(packet.fields().count(), 2);
    /// # let _ = (ping, info);
    /// # }
    /// ```
    pub fn request(&mut self, set: DescriptorSet) -> Request<'_> {
        let table = self.table_mut();
        for slot in &table.slots {
            if slot.is(State::Added) {
                slot.state.set(State::Free); // left from a request that was not sent
            }
        }
        table.packet.start(set);
        Request { table }
    }

    /// Returns a packet with one command, ready to be sent.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// use mip_protocol::{base::Ping, packets, Client};
    ///
    /// let mut client = Client::new();
    /// let (ticket, packet) = client.send(&Ping::new(), 0).unwrap();
    /// assert_eq!(packet.bytes(), b"\x75\x65\x01\x02\x02\x01\xE0\xC6"); // send it
    /// for packet in packets(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A") {
    ///     client.receive(&packet);
    /// }
    /// assert_eq!(client.take(&ticket), Some(Ok(())));
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// The command cannot be encoded, or all slots are in use.
    pub fn send<C: Command>(
        &mut self,
        command: &C,
        now_ms: u32,
    ) -> Result<(Ticket<C>, Packet<'_>), RequestError> {
        let (ticket, packet) = self.send_any(command, now_ms)?;
        Ok((ticket.of(), packet))
    }

    /// Like `send`, also for a command whose type is not known.
    pub(crate) fn send_any<C: AnyCommand + ?Sized>(
        &mut self,
        command: &C,
        now_ms: u32,
    ) -> Result<(Ticket<()>, Packet<'_>), RequestError> {
        let table = self.table_mut();
        let ticket = table.add(command, Some(now_ms))?;
        Ok((ticket, table.packet.packet()))
    }

    /// Processes a received packet, and returns the events that have not been taken.
    ///
    /// Data, late replies and replies to other hosts create no events; [`Events::others`] returns
    /// them.
    ///
    /// ```
    /// use mip_protocol::{packets, Client};
    ///
    /// let mut client = Client::new();
    /// for packet in packets(b"\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A") {
    ///     let events = client.receive(&packet);
    ///     assert_eq!(events.others().count(), 1); // nothing was sent that it could answer
    /// }
    /// ```
    pub fn receive<'p>(&mut self, packet: &Packet<'p>) -> Events<'_, 'p> {
        let (table, mut fields) = (self.table_mut(), packet.fields());
        if table.passes(&fields) {
            fields.end();
        }
        table.receive(fields.clone());
        Events { table, fields }
    }

    /// Like `receive`, but returns whether the packet contains more than replies.
    pub(crate) fn finds_data(&mut self, packet: &Packet<'_>) -> bool {
        let (table, fields) = (self.table_mut(), packet.fields());
        !table.passes(&fields) && table.receive(fields)
    }

    /// Returns the events that have not been taken: from earlier packets and from time-outs.
    pub fn events(&mut self) -> Events<'_, 'static> {
        Events { table: self.table_mut(), fields: Fields::NONE }
    }

    /// Takes the result of this command, if it is known: its response, or `()` if it has none.
    /// Events of other commands are kept.
    ///
    /// The result of a silent command is known as soon as it is sent: `Ok`.
    ///
    /// In the result, the command is an error if the device rejected it or did not reply in time,
    /// or if the response is missing or cannot be decoded. In the last two cases, the device has
    /// carried out the command.
    pub fn take<C: Command>(
        &mut self,
        ticket: &Ticket<C>,
    ) -> Option<Result<C::Response, CommandError>> {
        if ticket.silent {
            return Some(response::<C>(None));
        }
        self.table().take(ticket.id).map(Event::decoded::<C>)
    }

    /// Takes the undecoded response to this command, which no longer waits.
    pub(crate) fn take_reply(
        &self,
        ticket: Ticket<()>,
        command: &dyn AnyCommand,
    ) -> Result<Option<RawField<'_>>, CommandError> {
        let reply = match self.table().take(ticket.id) {
            Some(event) => event.reply(),
            None if ticket.silent => Ok(None),
            None => Err(Reason::TimedOut),
        };
        reply.map_err(|reason| CommandError::new(command.kind().name, reason))
    }

    /// May noise be why this command, which no longer waits, has no result?
    pub(crate) fn may_be_noise(&self, ticket: Ticket<()>) -> bool {
        match self.known_event(&ticket).map(Event::outcome) {
            Some(outcome) => !matches!(outcome, Ok(()) | Err(Reason::Refused(_))),
            None => !ticket.silent,
        }
    }

    /// Takes the event of this command, if there is one. Events of other commands are kept.
    ///
    /// Tickets of any type are accepted, including those of [`Request::add_any`]. A silent command
    /// has no event.
    pub fn take_event<C>(&mut self, ticket: &Ticket<C>) -> Option<&Event> {
        self.table().take(ticket.id)
    }

    /// Updates the time. Call it until it returns `None`; then all overdue commands have timed out.
    ///
    /// Noise that looks like the start of a packet delays the packets after it. Before a command
    /// times out, this returns them; handle them like any other packet. An incomplete packet is
    /// kept.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// use mip_protocol::{base::Ping, Client, Parser, Reason};
    ///
    /// let (mut client, mut parser) = (Client::new(), Parser::new());
    /// let (ticket, _) = client.send(&Ping::new(), 0).unwrap();
    /// while let Some(packet) = client.poll(&mut parser, 1000) {
    ///     client.receive(&packet); // what noise has hidden
    /// }
    /// let error = client.take(&ticket).unwrap().unwrap_err();
    /// assert_eq!(error.reason, Reason::TimedOut);
    /// # }
    /// ```
    pub fn poll<'p>(&mut self, parser: &'p mut Parser, now_ms: u32) -> Option<Packet<'p>> {
        self.table_mut().poll(parser, now_ms)
    }

    /// Stops waiting for a command, without an event.
    pub fn cancel<C>(&mut self, ticket: &Ticket<C>) {
        self.table_mut().free(|slot| slot.event.id == ticket.id);
    }

    /// Borrows the last packet to send.
    #[cfg(feature = "embedded-io-async-07")]
    pub(crate) fn packet(&self) -> Packet<'_> {
        self.table().packet.packet()
    }

    /// Stops waiting for all commands; earlier events are kept.
    pub(crate) fn give_up(&mut self) {
        self.table_mut().free(|slot| slot.is(State::Waiting));
    }

    /// Like [`Client::take`], but the result is kept and can be read again.
    pub(crate) fn known<C: Command>(
        &self,
        ticket: &Ticket<C>,
    ) -> Option<Result<C::Response, CommandError>> {
        if ticket.silent {
            return Some(response::<C>(None));
        }
        self.known_event(ticket).map(Event::decoded::<C>)
    }

    /// Like [`Client::take_event`], but the event is kept.
    pub(crate) fn known_event<C>(&self, ticket: &Ticket<C>) -> Option<&Event> {
        self.table().find(ticket.id).map(|slot| &slot.event)
    }

    /// Discards all commands and events. Replies that still arrive for them are treated as data.
    pub fn clear(&mut self) {
        let table = self.table_mut();
        if table.behind > 0 {
            miss(&mut table.missed); // it may not have been sent
        }
        table.free(|_| true);
    }

    /// Keeps a reply that is not waited for from answering a later command.
    pub(crate) fn ignore_reply(&mut self) {
        let table = self.table_mut();
        if table.missed == 0 || table.behind == table.missed.wrapping_add(1) {
            miss(&mut table.missed); // otherwise, a barrier is due anyway
        }
    }

    /// Is every packet data, because no reply is expected?
    pub(crate) fn is_idle(&self) -> bool {
        self.table().behind == 0 && self.pending() == 0
    }

    fn table(&self) -> &Slots {
        &self.table
    }

    fn table_mut(&mut self) -> &mut Slots {
        &mut self.table
    }
}

impl Slots {
    fn waiting(&self) -> impl Iterator<Item = &Slot> {
        self.slots.iter().filter(|slot| slot.is(State::Waiting))
    }

    /// Adds a command to the packet; `sent_ms` is the time if the packet is sent at once.
    fn add<C: AnyCommand + ?Sized>(
        &mut self,
        command: &C,
        sent_ms: Option<u32>,
    ) -> Result<Ticket<()>, RequestError> {
        let (silent, wanted) = (command.is_silent(), command.wanted());
        let encode = |writer: &mut Writer<'_>| command.write_to(writer);
        let id = self.enter(command.kind(), silent, wanted, &encode, sent_ms)?;
        Ok(Ticket { id, silent, command: PhantomData })
    }

    /// Does the part of `add` that does not depend on the command's type, so that its code exists
    /// once.
    fn enter(
        &mut self,
        kind: &'static Kind,
        silent: bool,
        wanted: Option<ResponseCheck>,
        encode: &dyn Fn(&mut Writer<'_>) -> Result<(), EncodeErrorKind>,
        sent_ms: Option<u32>,
    ) -> Result<u32, RequestError> {
        // If this command is sent now, commands added before belong to a request that was dropped.
        let free = self
            .slots
            .iter_mut()
            .find(|slot| slot.is(State::Free) || sent_ms.is_some() && slot.is(State::Added));
        if free.is_none() && !silent {
            return Err(RequestError::Busy);
        }
        if sent_ms.is_some() {
            self.packet.start(kind.set);
        }
        self.packet.push_by(kind.name, kind.set, kind.descriptor, encode)?;
        let id = self.next;
        self.next = id.wrapping_add(1);
        if let (Some(slot), false) = (free, silent) {
            let timeout_ms = self.patience.wrapping_add(DEFAULT_TIMEOUT_MS);
            slot.deadline = timeout_ms.max(kind.timeout_ms);
            slot.behind = self.behind;
            let event = &mut slot.event;
            (event.id, event.kind, event.check) = (id, Some(kind), wanted);
            (event.set, event.descriptor) = (kind.set, kind.descriptor);
            event.response[0] = 0;
            slot.state.set(State::Added);
            if let Some(now_ms) = sent_ms {
                slot.sent(now_ms);
            }
        }
        Ok(id)
    }

    /// Forgets commands. Those that wait for a reply count as missed.
    fn free(&mut self, which: impl Fn(&Slot) -> bool) {
        for slot in self.slots.iter().filter(|slot| which(slot)) {
            if slot.is(State::Waiting) {
                miss(&mut self.missed);
            }
            slot.state.set(State::Free);
        }
    }

    fn barrier(&mut self) -> Option<Packet<'_>> {
        let [set, descriptor] = BARRIER;
        if set == 0 || self.missed == 0 || self.behind == self.missed.wrapping_add(1) {
            return None;
        }
        for _ in self.slots.iter().filter(|slot| slot.is(State::Waiting)) {
            miss(&mut self.missed); // it may be the same command as in a barrier
        }
        self.behind = self.missed.wrapping_add(1);
        self.packet.start(DescriptorSet(set));
        (0..self.behind).try_for_each(|_| self.packet.push_raw(descriptor, &[])).ok()?;
        Some(self.packet.packet())
    }

    /// Does the packet answer the last barrier? If so, the commands sent before it time out.
    fn passes(&mut self, fields: &Fields<'_>) -> bool {
        let (size, [set, descriptor]) = (self.behind, BARRIER);
        let (mut rest, mut left) = (fields.payload(), size);
        while let [4, Acknowledge::DESCRIPTOR, of, _, behind @ ..] = rest {
            if *of != descriptor {
                return false;
            }
            (rest, left) = (behind, left.wrapping_sub(1));
        }
        if size == 0 || left > 0 || !rest.is_empty() || fields.set().0 != set {
            return false;
        }
        let order = self.happened;
        for slot in self.slots.iter_mut().filter(|slot| slot.is(State::Waiting)) {
            if slot.behind == size {
                slot.behind = 0;
            } else {
                self.happened = order.wrapping_add(1);
                slot.event.outcome = Outcome::TimedOut;
                slot.happens(order);
            }
        }
        if size == self.missed.wrapping_add(1) {
            self.missed = 0;
        }
        self.behind = 0;
        true
    }

    /// Looks for replies to commands, and marks the fields that belong to them.
    /// Returns whether there are others.
    fn receive(&mut self, mut fields: Fields<'_>) -> bool {
        self.taken = [0; 4];
        let (mut at, mut left, mut others) = (0, 0, false);
        while let Some(field) = fields.sound() {
            if left == 0 {
                left = self.answers(&field, &fields);
            }
            if left > 0 {
                self.take_field(at);
                left = left.wrapping_sub(1);
            } else {
                others = true;
            }
            at = at.wrapping_add(1);
        }
        others || !fields.payload().is_empty()
    }

    fn take_field(&mut self, at: u8) {
        if let Some(bits) = self.taken.get_mut(usize::from(at >> 5)) {
            *bits |= 1 << (at & 31);
        }
    }

    /// Finds the oldest command that an acknowledge and the field after it answer, and creates its
    /// event. Returns the number of fields in the reply: 2 with a response, 0 if there is no such
    /// command.
    ///
    /// A response is never matched to a command that does not request one, because it may be the
    /// late reply to another command. An acknowledge without a response is matched first to
    /// commands that request none.
    fn answers(&mut self, field: &RawField<'_>, rest: &Fields<'_>) -> u8 {
        // Reads only these two bytes: decoding the whole field would need 100 bytes of code.
        let (command, code) = match (field.descriptor, field.data) {
            (Acknowledge::DESCRIPTOR, [command, code, ..]) => (*command, AckCode(*code)),
            _ => return 0,
        };
        let behind = rest.clone().sound();
        let (mut best, mut found) = (0, None);
        for slot in &mut self.slots {
            let Some(outcome) = slot.outcome(field.set, command, code, behind.as_ref()) else {
                continue;
            };
            let whole = u32::from(outcome != Outcome::MissingResponse);
            let rank = whole << 31 | self.next.wrapping_sub(slot.event.id);
            if rank > best {
                (best, found) = (rank, Some((slot, outcome)));
            }
        }
        let Some((slot, outcome)) = found else { return 0 };
        slot.event.outcome = outcome;
        let has_response = outcome == Outcome::Complete && slot.event.check.is_some();
        if has_response {
            slot.event.keep(rest);
        }
        let order = self.happened;
        self.happened = order.wrapping_add(1);
        slot.happens(order);
        1_u8.wrapping_add(has_response.into())
    }

    /// Returns the command with this number, if there is an event for it.
    fn find(&self, id: u32) -> Option<&Slot> {
        self.slots.iter().find(|slot| slot.is(State::Done) && slot.event.id == id)
    }

    /// Takes the event of this command, if there is one.
    fn take(&self, id: u32) -> Option<&Event> {
        let slot = self.find(id)?;
        slot.state.set(State::Free);
        Some(&slot.event)
    }

    fn poll<'p>(&mut self, parser: &'p mut Parser, now_ms: u32) -> Option<Packet<'p>> {
        if parser.holds() {
            return Some(parser.packet());
        }
        let order = self.happened; // the same for all: they stay in the order of the commands
        for slot in &mut self.slots {
            if slot.is(State::Waiting) && has_passed(slot.deadline, now_ms) {
                if parser.holds_behind() {
                    return Some(parser.packet());
                }
                self.happened = order.wrapping_add(1);
                slot.event.outcome = Outcome::TimedOut;
                slot.happens(order);
                miss(&mut self.missed);
            }
        }
        None
    }

    /// Takes the oldest event that has not been taken.
    fn first(&self) -> Option<&Event> {
        let (mut oldest, mut found) = ((0, 0), None);
        for slot in &self.slots {
            let since = self.happened.wrapping_sub(slot.order);
            let age = (since, self.next.wrapping_sub(slot.event.id));
            if slot.is(State::Done) && age > oldest {
                (oldest, found) = (age, Some(slot));
            }
        }
        let slot = found?;
        slot.state.set(State::Free);
        Some(&slot.event)
    }
}

/// Counts one more command without a reply.
fn miss(missed: &mut u8) {
    *missed = if *missed < BARRIERS { missed.wrapping_add(1) } else { 1 };
}

impl Slot {
    /// Returns the command's result if this acknowledge and the field after it answer it.
    fn outcome(
        &self,
        set: DescriptorSet,
        command: u8,
        code: AckCode,
        behind: Option<&RawField<'_>>,
    ) -> Option<Outcome> {
        let kind = self.event.kind.filter(|kind| (kind.set, kind.descriptor) == (set, command))?;
        if !self.is(State::Waiting) || self.behind > 0 {
            return None;
        }
        if code.0 != 0 {
            return Some(Outcome::Refused(code));
        }
        // `contains` needs 180 bytes of code on a microcontroller.
        #[allow(clippy::manual_contains)]
        let responds = behind
            .map_or(false, |field| kind.responses.iter().any(|known| *known == field.descriptor));
        match self.event.check {
            Some(check) if responds => check(behind?).map(|_| Outcome::Complete),
            None if responds => None,
            Some(_) => Some(Outcome::MissingResponse),
            None => Some(Outcome::Complete),
        }
    }

    /// Marks the command as sent: it waits for its reply from now on.
    fn sent(&mut self, now_ms: u32) {
        self.state.set(State::Waiting);
        self.deadline = after(now_ms, self.deadline);
    }

    /// Creates the event of a command that was answered or has timed out.
    fn happens(&mut self, order: u32) {
        self.state.set(State::Done);
        self.order = order;
    }
}

/// A packet of commands that is not sent yet. Dropping it discards them.
#[derive(Debug)]
pub struct Request<'c> {
    table: &'c mut Slots,
}

impl<'c> Request<'c> {
    /// Appends a command. On an error the request is unchanged.
    ///
    /// # Errors
    ///
    /// The command cannot be encoded, the packet is full or of another set, or all slots are in
    /// use.
    pub fn add<C: Command>(&mut self, command: &C) -> Result<Ticket<C>, RequestError> {
        let set = self.table.packet.set();
        if set != C::SET {
            return Err(EncodeError::set(C::NAME, C::SET, set).into());
        }
        self.table.add(command, None).map(Ticket::of)
    }

    /// Appends a command whose type is known only at run time.
    ///
    /// The ticket has no type that could decode a response. To get the event, pass it to
    /// [`Client::take_event`] or [`Device::event`](crate::device::Device::event):
    ///
    /// ```
    /// use mip_protocol::device::{Device, DeviceError, Port};
    /// use mip_protocol::{AnyField, RequestError};
    ///
    /// fn show<P: Port>(
    ///     device: &mut Device<P>,
    ///     command: &AnyField,
    /// ) -> Result<(), DeviceError<P::Error>> {
    ///     let Some(set) = command.info().set() else { return Err(RequestError::NoCommand.into()) };
    ///     let ticket = device.send_all(set, |request| request.add_any(command))?;
    ///     let Some(event) = device.event(&ticket) else {
    ///         println!("sent; the device does not answer it");
    ///         return Ok(());
    ///     };
    ///     println!("{:?}", event.outcome());
    ///     if let Some(Ok(Some(response))) = event.response().map(|f| AnyField::decode(&f)) {
    ///         println!("{}: {response:?}", response.info().name);
    ///     }
    ///     Ok(())
    /// }
    /// ```
    ///
    /// # Errors
    ///
    /// The field is not a command, or those of [`Request::add`].
    #[cfg(feature = "registry")]
    #[inline]
    pub fn add_any(&mut self, field: &AnyField) -> Result<Ticket<()>, RequestError> {
        field.add_to(self).unwrap_or(Err(RequestError::NoCommand))
    }

    /// Returns the packet to send. From now on its commands are pending. If none were added, the
    /// packet has no fields, and need not be sent.
    #[must_use = "the packet must be sent"]
    pub fn send(self, now_ms: u32) -> Packet<'c> {
        for slot in &mut self.table.slots {
            if slot.is(State::Added) {
                slot.sent(now_ms);
            }
        }
        self.table.packet.packet()
    }
}

/// The events that have not been taken, oldest first. Untaken events remain in the client.
#[derive(Debug)]
pub struct Events<'c, 'p> {
    table: &'c Slots,
    fields: Fields<'p>,
}

impl<'c, 'p> Events<'c, 'p> {
    /// Returns the fields of the packet that do not answer a command: data and unexpected replies.
    #[must_use]
    pub fn others(&self) -> Others<'c, 'p> {
        Others { fields: self.fields.clone(), taken: &self.table.taken, at: 0 }
    }
}

/// An event borrows the client; to keep it longer, clone it.
impl<'c> Iterator for Events<'c, '_> {
    type Item = &'c Event;

    fn next(&mut self) -> Option<&'c Event> {
        self.table.first()
    }
}

/// The fields of a packet that do not answer a command; from [`Events::others`].
#[derive(Clone, Debug)]
pub struct Others<'c, 'p> {
    fields: Fields<'p>,
    taken: &'c [u32; 4],
    at: u8,
}

impl<'p> Iterator for Others<'_, 'p> {
    type Item = Result<RawField<'p>, FieldLengthError>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let field = self.fields.next()?;
            let bits = self.taken.get(usize::from(self.at >> 5))?;
            let taken = bits & (1 << (self.at & 31)) != 0;
            self.at = self.at.wrapping_add(1);
            if !taken {
                return Some(field);
            }
        }
    }
}
