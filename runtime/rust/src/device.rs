//! A device at a port: one call for each command, and the data that it sends.
//!
//! [`Device`] uses a [`Port`]. `StdPort` is a port over anything that reads and writes with the
//! standard library, and `EmbeddedPort` one over a driver with the traits of `embedded-io`. To use
//! any other port, implement three functions. `AsyncDevice` does the same with `embedded-io-async`.
//! Each requires a cargo feature: `std`, `embedded-io-07` or `embedded-io-async-07`.
//!
//! ```no_run
//! # #[cfg(feature = "std")]
//! # fn example(serial: std::net::TcpStream) -> Result<(), Box<dyn std::error::Error>> {
//! use mip_protocol::device::{Device, StdPort};
//!
//! serial.set_read_timeout(Some(std::time::Duration::from_millis(10)))?; // reading must not wait forever
//! let mut device = Device::new(StdPort::new(serial));
//! while let Some(packet) = device.next_packet(1000)? {
//!     println!("{packet:?}");
//! }
//! # Ok(()) }
//! ```
//!
//! **Commands**: [`Device::request`] sends a command and returns its response, and
//! [`Device::send_all`] sends several in one packet. If the device rejects a command, does not
//! answer it in time or answers it incorrectly, the error is [`DeviceError::Command`].
//!
//! **Data that arrives while a command waits for its reply** is kept, and [`Device::next_packet`]
//! returns it first, in order. There is room for `Q` bytes; if it is full, the oldest packets are
//! dropped, and [`Device::dropped`] counts them. A device that was set to idle first sends no data.
//!
//! **A reply** may arrive in a packet by itself or with others. Before a command times out, packets
//! that noise has delayed are processed.
//!
//! **After a command that was not answered**, its reply may still arrive. A barrier is therefore
//! sent before the next command (see [`Client::barrier`]), and what arrives before the reply to the
//! barrier is data, so that a late reply is never matched to another command. This costs a packet
//! each way, and no further wait. It works as long as the device replies to commands in order, even
//! after the baud rate was changed or the port was opened again.
//!
//! **A command that changes the baud rate** is acknowledged at the old rate. `Device::change_baud`
//! sends it, and sets the port to the new rate. It exists if the specification has the commands for
//! it.

use core::cell::Cell;
use core::fmt;

use crate::client::{
    after, has_passed, response, AnyCommand, Bytes, Client, CommandError, Event, Request,
    RequestError, Silent, Ticket,
};
use crate::error::DecodeError;
use crate::field::{Command, RawField};
use crate::packet::{FromPacket, Packet, HOST, MAX_PACKET};
use crate::parser::{copy, Parser};
use crate::protocol::DescriptorSet;
use crate::time::{Time, Times};
use crate::timed::{next_fields, Timed};

mod all;
#[cfg(feature = "embedded-io-async-07")]
mod asynchronous;
#[cfg(feature = "embedded-io-07")]
mod embedded;
#[cfg(feature = "open")]
mod line;
#[cfg(feature = "tokio")]
mod line_async;
#[cfg(feature = "std")]
mod standard;

pub use all::Commands;
#[cfg(feature = "embedded-io-async-07")]
pub use asynchronous::AsyncDevice;
#[cfg(feature = "embedded-io-07")]
pub use embedded::{EmbeddedError, EmbeddedPort};
#[cfg(feature = "open")]
pub use line::Line;
#[cfg(feature = "tokio")]
pub use line_async::{AsyncLine, CommandHalf, DataHalf, TokioDevice};
#[cfg(feature = "std")]
pub use standard::StdPort;

/// The connection to a device, and a clock.
#[cfg_attr(
    any(feature = "open", feature = "core-error"), // they need a Rust that has this
    diagnostic::on_unimplemented(
        message = "`{Self}` is no port of a device",
        note = "wrap what implements `Read` and `Write` in `StdPort::new`, or a driver of `embedded-io` in `EmbeddedPort::new`"
    )
)]
pub trait Port {
    /// The port's error type.
    type Error;

    /// Reads received bytes into the front of the buffer, and returns their number. It may wait for
    /// a while if there are none, but must then return 0.
    ///
    /// # Errors
    ///
    /// Returns the errors of the port.
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Self::Error>;

    /// Sends all of these bytes.
    ///
    /// # Errors
    ///
    /// Returns the errors of the port.
    fn write(&mut self, bytes: &[u8]) -> Result<(), Self::Error>;

    /// Returns whether bytes have arrived, so that `read` would not wait. A port where replies can
    /// come twice or out of order, such as UDP, has to know: each command is then preceded by what
    /// has arrived, as data. Serial ports and TCP keep the order.
    ///
    /// # Errors
    ///
    /// Returns the errors of the port.
    fn waits(&mut self) -> Result<bool, Self::Error> {
        Ok(false)
    }

    /// Returns a count of milliseconds that only increases, and may wrap around.
    fn now_ms(&mut self) -> u32;

    /// Changes the baud rate, and discards what was received at the old one. Returns `false` if the
    /// port has no baud rate or does not support this one.
    ///
    /// # Errors
    ///
    /// Returns the errors of the port.
    fn set_baud(&mut self, rate: u32) -> Result<bool, Self::Error> {
        let _ = rate;
        Ok(false)
    }

    /// Returns the baud rate, if the port has one.
    fn baud(&self) -> Option<u32> {
        None
    }
}

impl<P: Port + ?Sized> Port for &mut P {
    type Error = P::Error;

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, P::Error> {
        (**self).read(buffer)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), P::Error> {
        (**self).write(bytes)
    }

    fn waits(&mut self) -> Result<bool, P::Error> {
        (**self).waits()
    }

    fn now_ms(&mut self) -> u32 {
        (**self).now_ms()
    }

    fn set_baud(&mut self, rate: u32) -> Result<bool, P::Error> {
        (**self).set_baud(rate)
    }

    fn baud(&self) -> Option<u32> {
        (**self).baud()
    }
}

/// Why a call failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum DeviceError<E> {
    /// The command was not sent: it cannot be encoded, or too many are waiting.
    Request(RequestError),
    /// The command was sent, but rejected, or not answered in time or correctly.
    Command(CommandError),
    /// A field of received data cannot be decoded.
    Data(DecodeError),
    /// The port could not read or write.
    Port(E),
    /// The port is closed: no more bytes will arrive, or none are accepted.
    Closed,
    /// The command was not sent: the port has no baud rate that could be changed.
    NoBaudRate,
}

impl<E> From<RequestError> for DeviceError<E> {
    fn from(error: RequestError) -> Self {
        Self::Request(error)
    }
}

impl<E> From<CommandError> for DeviceError<E> {
    fn from(error: CommandError) -> Self {
        Self::Command(error)
    }
}

impl<E: fmt::Display> fmt::Display for DeviceError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Request(error) => write!(f, "not sent: {error}"),
            Self::Command(error) => error.fmt(f),
            Self::Data(error) => error.fmt(f),
            Self::Port(error) => write!(f, "port: {error}"),
            Self::Closed => f.write_str("the port is closed"),
            Self::NoBaudRate => f.write_str("not sent: the port has no baud rate"),
        }
    }
}

#[cfg(any(feature = "core-error", feature = "std"))]
impl<E: fmt::Debug + fmt::Display> crate::error::Error for DeviceError<E> {
    fn source(&self) -> Option<&(dyn crate::error::Error + 'static)> {
        match self {
            Self::Command(error) => error.source(),
            _ => None, // the text has all
        }
    }
}

/// The error of a port of the standard library that is closed.
#[cfg(feature = "std")]
fn closed() -> std::io::Error {
    let text = "the other end has closed the connection";
    std::io::Error::new(std::io::ErrorKind::UnexpectedEof, text)
}

/// The number of bytes that a device reads at a time from its port. They are on the stack.
const CHUNK: usize = if HOST { 1024 } else { 256 };

/// After a deadline, the port is read at most this many times, while bytes arrive: if the program
/// was suspended, the reply may be among the bytes that arrived in the meantime.
const BACKLOG: u8 = 64;

/// The backlog is read for at most this many milliseconds; bytes after that have only just arrived.
const CATCH_UP: u32 = 100;

/// Is the wait over? It is if the deadline has passed and no more arrives or the backlog is used
/// up.
fn is_over(late: bool, came: bool, backlog: &mut u8) -> bool {
    *backlog = backlog.saturating_sub(late.into());
    late && (!came || *backlog == 0)
}

/// Decides when a blocking device stops reading after a deadline.
struct Waited {
    backlog: u8,
    since: Option<u32>,
}

impl Waited {
    const fn new() -> Self {
        Self { backlog: BACKLOG, since: None }
    }

    /// Is the wait over? It is also over if reading takes long, because that is no backlog.
    fn is_over(&mut self, deadline: u32, now_ms: u32, came: bool) -> bool {
        if !has_passed(deadline, now_ms) {
            *self = Self::new();
            return false;
        }
        // If the program was suspended during this read, received bytes may still wait to be read.
        let stopped = self.since.is_none() && now_ms.wrapping_sub(deadline) >= CATCH_UP;
        let since = *self.since.get_or_insert(now_ms);
        is_over(true, (came || stopped) && now_ms.wrapping_sub(since) < CATCH_UP, &mut self.backlog)
    }
}

/// The state of the communication with a device, without its port.
#[derive(Clone, Debug)]
struct Core<const N: usize, const Q: usize> {
    client: Client<N>,
    parser: Parser,
    data: Queue<Q>,
    /// Its profile, once the device has been asked what it is.
    #[cfg(feature = "devices")]
    model: Option<&'static crate::devices::Profile>,
}

impl<const N: usize, const Q: usize> Core<N, Q> {
    const fn new(client: Client<N>) -> Self {
        Self {
            client,
            parser: Parser::new(),
            data: Queue::new(),
            #[cfg(feature = "devices")]
            model: None,
        }
    }

    /// Returns what reads the times of this device's packets.
    #[cfg_attr(not(feature = "devices"), allow(clippy::unused_self))]
    fn times(&self) -> Times {
        #[cfg(feature = "devices")]
        if let Some(model) = self.model {
            return Times::of(model);
        }
        Times::new()
    }

    /// Returns the part of a chunk to read into, which always fits into an empty queue.
    #[allow(clippy::unused_self)]
    fn part<'c>(&self, chunk: &'c mut [u8; CHUNK]) -> &'c mut [u8] {
        let size = Q.saturating_sub(MAX_PACKET).clamp(1, CHUNK);
        chunk.get_mut(..size).unwrap_or_default()
    }

    /// Processes received bytes, and returns whether they complete a packet.
    fn arrived(&mut self, mut bytes: &[u8]) -> bool {
        let (mut found, idle) = (false, self.client.is_idle());
        while let Some(packet) = self.parser.next(&mut bytes) {
            if !idle {
                sort(&mut self.client, &mut self.data, &packet);
            } else if !packet.payload().is_empty() {
                self.data.push(packet.bytes()); // the usual case
            }
            found = true;
        }
        found
    }

    /// Times out overdue commands, after processing packets that noise has delayed.
    fn tick(&mut self, now_ms: u32) {
        while let Some(packet) = self.client.poll(&mut self.parser, now_ms) {
            sort(&mut self.client, &mut self.data, &packet);
        }
    }

    /// Finds packets after noise, when no bytes arrive for a while.
    fn look_behind(&mut self) -> bool {
        let mut found = false;
        while let Some(packet) = self.parser.look_behind() {
            sort(&mut self.client, &mut self.data, &packet);
            found = true;
        }
        found
    }

    /// Discards an incomplete packet and all commands; a barrier will precede the next command.
    /// Data that was kept remains.
    #[cfg(feature = "open")]
    fn restart(&mut self) {
        while let Some(packet) = self.parser.flush() {
            sort(&mut self.client, &mut self.data, &packet);
        }
        self.client.give_up();
        self.client.clear();
        self.model = None; // another device may be there
    }

    /// Returns the response to a command that no longer waits, and keeps it.
    fn answer<C: Command>(&self, ticket: &Ticket<C>) -> Result<C::Response, CommandError> {
        all::response(ticket, &self.client)
    }
}

/// Passes a packet to the client, and keeps it if it contains more than answers.
fn sort<const N: usize, const Q: usize>(
    client: &mut Client<N>,
    data: &mut Queue<Q>,
    packet: &Packet<'_>,
) {
    if client.finds_data(packet) {
        data.push(packet.bytes());
    }
}

/// Received packets, one after another.
#[derive(Clone)]
struct Queue<const Q: usize> {
    bytes: [u8; Q],
    start: usize,
    end: usize,
    dropped: u32,
}

impl<const Q: usize> Queue<Q> {
    const fn new() -> Self {
        Self { bytes: [0; Q], start: 0, end: 0, dropped: 0 }
    }

    fn push(&mut self, packet: &[u8]) {
        if packet.len() > Q {
            self.dropped = self.dropped.wrapping_add(1);
            return;
        }
        while Q.wrapping_sub(self.len()) < packet.len() {
            self.dropped = self.dropped.wrapping_add(1);
            let _ = self.pop();
        }
        if Q.wrapping_sub(self.end) < packet.len() {
            let places = Cell::from_mut(self.bytes.as_mut_slice()).as_slice_of_cells();
            let kept = places.get(self.start..self.end).unwrap_or_default();
            places.iter().zip(kept).for_each(|(to, from)| to.set(from.get()));
            (self.start, self.end) = (0, kept.len());
        }
        let end = self.end.wrapping_add(packet.len());
        copy(self.bytes.get_mut(self.end..end).unwrap_or_default(), packet);
        self.end = end;
    }

    fn pop(&mut self) -> Option<Packet<'_>> {
        let all = self.bytes.get(self.start..self.end)?;
        let size = usize::from(*all.get(3)?).saturating_add(6);
        self.start = self.start.saturating_add(size);
        all.get(..size).map(Packet::trusted)
    }

    #[cfg(feature = "std")]
    #[allow(dead_code)] // without the features of command sets
    fn discard(&mut self, set: DescriptorSet) {
        let mut others = std::vec::Vec::new();
        while let Some(packet) = self.pop() {
            if packet.set() != set {
                others.extend_from_slice(packet.bytes());
            }
        }
        copy(self.bytes.get_mut(..others.len()).unwrap_or_default(), &others);
        (self.start, self.end) = (0, others.len());
    }

    const fn len(&self) -> usize {
        self.end.wrapping_sub(self.start)
    }
}

impl<const Q: usize> fmt::Debug for Queue<Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {Q} bytes, {} packets dropped", self.len(), self.dropped)
    }
}

/// A device at a port.
///
/// It has memory for `N` commands of one packet, about 300 bytes each, and for `Q` bytes of data
/// packets that arrive while a command waits; choose a larger `Q` if a device streams fast and is
/// not set to idle first. `Device<_, 1, 600>` is about the smallest useful size.
#[derive(Clone, Debug)]
pub struct Device<P, const N: usize = 8, const Q: usize = 4096> {
    port: P,
    core: Core<N, Q>,
}

impl<P: Port> Device<P> {
    /// Creates a device with the default memory and time-out; nothing is sent or read.
    #[must_use]
    pub const fn new(port: P) -> Self {
        Self::with_client(port, Client::new())
    }
}

impl<P, const N: usize, const Q: usize> Device<P, N, Q> {
    /// Creates a device whose client has another time-out or size:
    /// `let device: Device<_, 1, 600> = …`.
    #[must_use]
    pub const fn with_client(port: P, client: Client<N>) -> Self {
        Self { port, core: Core::new(client) }
    }

    /// Borrows the port.
    pub const fn port(&self) -> &P {
        &self.port
    }

    /// Borrows the port, for example to set its baud rate.
    pub fn port_mut(&mut self) -> &mut P {
        &mut self.port
    }

    /// Returns the port. Bytes that were read but not yet returned are lost.
    pub fn into_port(self) -> P {
        self.port
    }

    /// Borrows the parser, which counts the bytes that are not part of a packet.
    pub const fn parser(&self) -> &Parser {
        &self.core.parser
    }

    /// Returns the number of packets dropped for lack of room while a command waited.
    pub const fn dropped(&self) -> u32 {
        self.core.data.dropped
    }
}

impl<P: Port, const N: usize, const Q: usize> Device<P, N, Q> {
    /// Sends a command, waits until the device has carried it out, and returns its response.
    ///
    /// The command's type determines the type of the response: `()` for a command without one, and
    /// an `Option` if its function is known only at run time. If devices do not answer the command,
    /// it does not wait.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// use mip_protocol::base::GetDeviceInfo;
    /// use mip_protocol::device::{Device, DeviceError, Port};
    ///
    /// fn name<P: Port>(device: &mut Device<P>) -> Result<(), DeviceError<P::Error>> {
    ///     let info = device.request(&GetDeviceInfo::new())?.device_info;
    ///     println!("{}", info.model_name);
    ///     Ok(())
    /// }
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// The command cannot be sent, is rejected or not answered, or the port fails.
    pub fn request<C: Command>(
        &mut self,
        command: &C,
    ) -> Result<C::Response, DeviceError<P::Error>> {
        Ok(response::<C>(self.exchange(command, 1)?)?)
    }

    /// Sends a command, and does not wait for a reply; one that arrives is data, even during the next
    /// request, which is preceded by a barrier for that. This is for commands that the device does
    /// not acknowledge because of a setting of another command, which their documentation names:
    /// [`Device::request`] would wait for each in vain.
    ///
    /// # Errors
    ///
    /// The command cannot be sent, or the port fails.
    pub fn send<C: Command>(&mut self, command: &C) -> Result<(), DeviceError<P::Error>> {
        if command.expects_reply() {
            self.core.client.ignore_reply();
        }
        let now_ms = self.port.now_ms();
        let (_, packet) = self.core.client.send_any(&Silent(command), now_ms)?;
        self.port.write(packet.bytes()).map_err(DeviceError::Port)
    }

    /// Sends a command, and returns the undecoded response; again, up to this number of times, if
    /// noise may be why there is none. This does not depend on the command's type, so that its code
    /// exists once.
    pub(crate) fn exchange(
        &mut self,
        command: &dyn AnyCommand,
        mut attempts: u8,
    ) -> Result<Option<RawField<'_>>, DeviceError<P::Error>> {
        let ticket = loop {
            let now_ms = self.begin().map_err(DeviceError::Port)?;
            let (ticket, packet) = self.core.client.send_any(command, now_ms)?;
            self.port.write(packet.bytes()).map_err(DeviceError::Port)?;
            self.wait().map_err(DeviceError::Port)?;
            attempts = attempts.saturating_sub(1);
            if attempts == 0 || !self.core.client.may_be_noise(ticket) {
                break ticket;
            }
        };
        Ok(self.core.client.take_reply(ticket, command)?)
    }

    /// Sends several commands of one descriptor set in one packet, and returns their responses.
    ///
    /// ```
    /// # #[cfg(feature = "mip_3dm")] mod example {
    /// use mip_protocol::device::{Device, DeviceError, Port};
    /// use mip_protocol::{mip_3dm::{GetBaseRate, PpsSourceControl}, sensor};
    ///
    /// fn ask<P: Port>(device: &mut Device<P>) -> Result<u16, DeviceError<P::Error>> {
    ///     let commands = (&GetBaseRate::new(sensor::SET), &PpsSourceControl::read());
    ///     let (base_rate, _) = device.request_all(commands)?;
    ///     Ok(base_rate.rate)
    /// }
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Device::request`]; of several rejected commands, it is the error of the first.
    pub fn request_all<C: Commands>(
        &mut self,
        commands: C,
    ) -> Result<C::Responses, DeviceError<P::Error>> {
        let tickets = self.send_all(C::SET, |request| commands.add(request))?;
        Ok(C::responses(&tickets, &self.core.client)?)
    }

    /// Sends several commands of one descriptor set in one packet, and waits for all replies.
    ///
    /// The closure adds the commands, and returns any value, usually their tickets. If it adds
    /// none, nothing is sent. [`Device::answer`] returns the outcome of each.
    ///
    /// ```
    /// # #[cfg(feature = "base")] {
    /// use mip_protocol::base::{self, GetDeviceInfo, Ping};
    /// use mip_protocol::device::{Device, DeviceError, Port};
    ///
    /// fn ask<P: Port>(device: &mut Device<P>) -> Result<(), DeviceError<P::Error>> {
    ///     let (ping, info) = device.send_all(base::SET, |request| {
    ///         Ok((request.add(&Ping::new())?, request.add(&GetDeviceInfo::new())?))
    ///     })?;
    ///     println!("{:?} {:?}", device.answer(&ping), device.answer(&info)); // each by itself
    ///     Ok(())
    /// }
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// Returns the error of the closure or of the port.
    pub fn send_all<T>(
        &mut self,
        set: DescriptorSet,
        add: impl FnOnce(&mut Request<'_>) -> Result<T, RequestError>,
    ) -> Result<T, DeviceError<P::Error>> {
        let now_ms = self.begin().map_err(DeviceError::Port)?;
        let mut request = self.core.client.request(set);
        let tickets = add(&mut request)?;
        let packet = request.send(now_ms);
        if !packet.payload().is_empty() {
            self.port.write(packet.bytes()).map_err(DeviceError::Port)?;
        }
        self.wait().map_err(DeviceError::Port)?;
        Ok(tickets)
    }

    /// Returns the response to a command of [`Device::send_all`], until the next command is sent.
    ///
    /// # Errors
    ///
    /// The device rejected or did not answer the command; or it was sent before the last call
    /// ([`Reason::Forgotten`](crate::client::Reason::Forgotten)).
    pub fn answer<C: Command>(&self, ticket: &Ticket<C>) -> Result<C::Response, CommandError> {
        self.core.answer(ticket)
    }

    /// Like [`Device::answer`], but without decoding the response, and for tickets of any type,
    /// including those of [`Request::add_any`]. Returns `None` for an earlier command, and if the
    /// device does not answer the command.
    pub fn event<C>(&self, ticket: &Ticket<C>) -> Option<&Event> {
        self.core.client.known_event(ticket)
    }

    /// Forgets the earlier commands, takes in what waits, and sends a barrier if a command was not
    /// answered.
    fn begin(&mut self) -> Result<u32, P::Error> {
        self.core.client.clear();
        let mut backlog = BACKLOG; // bytes may arrive without end
        while backlog > 0 && self.port.waits()? && self.read()? {
            backlog = backlog.saturating_sub(1);
        }
        if let Some(barrier) = self.core.client.barrier() {
            self.port.write(barrier.bytes())?;
        }
        Ok(self.port.now_ms())
    }

    /// Waits until no command is pending.
    fn wait(&mut self) -> Result<(), P::Error> {
        while let Some(deadline) = self.core.client.deadline() {
            if !self.read_until(deadline, |core| core.client.pending() == 0)? {
                self.core.tick(self.port.now_ms());
            }
        }
        Ok(())
    }

    /// Reads until the condition holds, or this time; returns whether it holds.
    fn read_until(&mut self, end: u32, holds: fn(&Core<N, Q>) -> bool) -> Result<bool, P::Error> {
        let mut waited = Waited::new();
        while !holds(&self.core) {
            let came = self.read()?;
            if waited.is_over(end, self.port.now_ms(), came) {
                return Ok(holds(&self.core));
            }
        }
        Ok(true)
    }

    /// Sends up to two pings until any packet arrives, because bytes of another baud rate may spoil
    /// the first one. What arrives is discarded.
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn is_heard(
        &mut self,
        ping: &Bytes<'_>,
        wait_ms: u32,
    ) -> Result<bool, DeviceError<P::Error>> {
        let came = |core: &Core<N, Q>| core.client.pending() == 0 || core.data.len() > 0;
        let mut heard = false;
        self.core.parser = Parser::new();
        self.discard();
        for _ in 0..2 {
            self.core.client.clear();
            let end = after(self.port.now_ms(), wait_ms);
            let (_, packet) = self.core.client.send_any(ping, end)?;
            self.port.write(packet.bytes()).map_err(DeviceError::Port)?;
            let came = self.read_until(end, came).map_err(DeviceError::Port)?;
            heard = came || self.core.look_behind();
            if heard {
                break;
            }
        }
        self.core.client.clear();
        self.discard();
        Ok(heard)
    }

    /// Changes the baud rate of the port; returns `false` if that is not possible.
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn set_baud(&mut self, rate: u32) -> Result<bool, DeviceError<P::Error>> {
        self.port.set_baud(rate).map_err(DeviceError::Port)
    }

    /// Returns the baud rate, if the port has one.
    pub fn baud(&self) -> Option<u32> {
        self.port.baud()
    }

    /// Borrows the device's profile, to keep it.
    #[cfg(feature = "devices")]
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn model(&mut self) -> &mut Option<&'static crate::devices::Profile> {
        &mut self.core.model
    }

    /// Discards the data that was kept.
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn discard(&mut self) {
        while self.core.data.pop().is_some() {}
    }

    /// Discards the data of a descriptor set that was kept.
    #[cfg(feature = "std")]
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn discard_set(&mut self, set: DescriptorSet) {
        self.core.data.discard(set);
    }

    /// Receives data for a number of milliseconds, and keeps it.
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn pass(&mut self, wait_ms: u32) -> Result<(), DeviceError<P::Error>> {
        let end = after(self.port.now_ms(), wait_ms);
        self.read_until(end, |_| false).map(drop).map_err(DeviceError::Port)
    }

    /// Reads once, and returns whether bytes have arrived.
    fn read(&mut self) -> Result<bool, P::Error> {
        let mut chunk = [0; CHUNK];
        let part = self.core.part(&mut chunk);
        let count = self.port.read(part)?;
        self.core.arrived(part.get(..count).unwrap_or_default());
        Ok(count > 0)
    }

    /// Returns the next packet with data or other fields that do not answer a command, or `None` if
    /// none arrives within this number of milliseconds, at most 2³¹ - 1 (24.8 days). With 0, it
    /// reads what has already arrived.
    ///
    /// If the time ends in the middle of a packet, that packet is kept, unless its data already
    /// contains a whole packet: then it was noise, and the inner packet is returned.
    ///
    /// Continuation packets are returned one by one, as the device sends them.
    ///
    /// ```
    /// use mip_protocol::device::{Device, DeviceError, Port};
    ///
    /// fn show<P: Port>(device: &mut Device<P>) -> Result<(), DeviceError<P::Error>> {
    ///     while let Some(packet) = device.next_packet(1000)? {
    ///         println!("{}: {} fields", packet.set(), packet.fields().count());
    ///     }
    ///     Ok(()) // no data for a second
    /// }
    /// ```
    ///
    /// # Errors
    ///
    /// The port fails.
    pub fn next_packet(
        &mut self,
        wait_ms: u32,
    ) -> Result<Option<Packet<'_>>, DeviceError<P::Error>> {
        if self.core.data.len() == 0 {
            self.core.client.give_up();
            let end = after(self.port.now_ms(), wait_ms);
            let came = self.read_until(end, |core| core.data.len() > 0);
            if !came.map_err(DeviceError::Port)? {
                self.core.look_behind();
            }
        }
        Ok(self.core.data.pop())
    }

    /// Returns the fields `F` of the packets that [`Device::next_packet`] would return, with their
    /// times: a field, or a tuple of fields of one packet; see [`FromPacket`]. It ends when no packet
    /// arrives within this number of milliseconds.
    ///
    /// The flags of times are read as those of the device's model, once `Device::profile` has asked
    /// for it; with the feature `open`, `Device::stream` does.
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] mod example {
    /// use mip_protocol::device::{Device, DeviceError, Port};
    /// use mip_protocol::sensor::{ScaledAccel, ScaledGyro};
    ///
    /// fn show<P: Port>(device: &mut Device<P>) -> Result<(), DeviceError<P::Error>> {
    ///     for found in device.fields::<(ScaledAccel, ScaledGyro)>(1000) {
    ///         let (time, (accel, gyro)) = found?;
    ///         println!("{time:?}: {} {}", accel.scaled_accel.x, gyro.scaled_gyro.x);
    ///     }
    ///     Ok(())
    /// }
    /// # }
    /// ```
    pub fn fields<F: FromPacket>(&mut self, wait_ms: u32) -> Timed<&mut Self, F> {
        let times = self.core.times();
        Timed::new(self, times, wait_ms)
    }
}

impl<P, F, const N: usize, const Q: usize> Iterator for Timed<&mut Device<P, N, Q>, F>
where
    P: Port,
    F: FromPacket,
{
    type Item = Result<(Option<Time>, F), DeviceError<P::Error>>;

    fn next(&mut self) -> Option<Self::Item> {
        next_fields!(self, self.source.next_packet(self.wait_ms), DeviceError::Data)
    }
}
