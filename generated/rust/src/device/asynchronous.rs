//! An asynchronous device.

use core::future::{poll_fn, ready, Future};
use core::pin::{pin, Pin};
use core::task::Poll;

use embedded_io_async::{Error, ErrorKind, Read, Write};

use super::{is_over, Client, Command, CommandError, Commands, Core, DeviceError, RequestError};
use super::{BACKLOG, CHUNK};
use crate::client::{response, AnyCommand, Bytes, Event, Request, Silent, Ticket};
use crate::field::RawField;
use crate::packet::{FromPacket, Packet};
use crate::parser::{behind, Parser};
use crate::protocol::DescriptorSet;
use crate::time::Time;
use crate::timed::{next_fields, Timed};

/// A device at a port with the traits of `embedded-io-async`: the asynchronous form of
/// [`Device`](super::Device), for any executor.
///
/// `sleep` is a function that returns a future that waits for a number of milliseconds:
/// `|ms| Timer::after_millis(ms.into())` of `embassy-time`, or
/// `|ms| tokio::time::sleep(Duration::from_millis(ms.into()))`.
///
/// These traits have no function for the baud rate. [`AsyncDevice::with_baud`] provides one;
/// without it, the port keeps its rate.
///
/// Each command is preceded by what has arrived, as data, so that a reply that arrives twice or out
/// of order, as over UDP, is not taken for the next one. For this, the port's `read` is polled once,
/// and dropped if no bytes have arrived, as when a wait ends. Use a driver that loses none by that:
/// one that buffers what it receives, such as `BufferedUart` of embassy.
///
/// Dropping a future cancels the command in the client, but not in the device. The reply is then
/// treated as data, because a barrier precedes the next command.
///
/// A command continues after an [`Interrupted`](ErrorKind::Interrupted) error, and after a
/// [`TimedOut`](ErrorKind::TimedOut) error of a read. A port whose `write` returns 0 is
/// [`Closed`](DeviceError::Closed).
#[derive(Clone, Debug)]
pub struct AsyncDevice<P, S, const N: usize = 8, const Q: usize = 4096> {
    pub(super) port: P,
    sleep: S,
    pub(super) core: Core<N, Q>,
    baud: Option<u32>,
    set_baud: Option<SetBaud<P>>,
}

/// Changes the baud rate of a port, and returns whether it supports the new one.
type SetBaud<P> = fn(&mut P, u32) -> bool;

impl<P, S, F> AsyncDevice<P, S>
where
    S: FnMut(u32) -> F,
    F: Future<Output = ()>,
{
    /// Creates a device with the default memory and time-out; nothing is sent or read.
    #[must_use]
    pub const fn new(port: P, sleep: S) -> Self {
        Self::with_client(port, sleep, Client::new())
    }
}

impl<P, S, F, const N: usize, const Q: usize> AsyncDevice<P, S, N, Q>
where
    S: FnMut(u32) -> F,
    F: Future<Output = ()>,
{
    /// Creates a device whose client has another time-out or size:
    /// `let device: AsyncDevice<_, _, 1, 600> = …`.
    #[must_use]
    pub const fn with_client(port: P, sleep: S, client: Client<N>) -> Self {
        Self { port, sleep, core: Core::new(client), baud: None, set_baud: None }
    }

    /// Adds the present baud rate of the port, and the function that changes it and returns whether
    /// the port supports the new one: `|uart, rate| uart.set_baudrate(rate).is_ok()`.
    #[must_use]
    pub fn with_baud(mut self, rate: u32, set_baud: fn(&mut P, u32) -> bool) -> Self {
        (self.baud, self.set_baud) = (Some(rate), Some(set_baud));
        self
    }
}

impl<P, S, const N: usize, const Q: usize> AsyncDevice<P, S, N, Q> {
    /// Returns the baud rate, if the port has one.
    pub const fn baud(&self) -> Option<u32> {
        self.baud
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

impl<P, S, F, const N: usize, const Q: usize> AsyncDevice<P, S, N, Q>
where
    P: Read + Write,
    S: FnMut(u32) -> F,
    F: Future<Output = ()>,
{
    /// Sends a command, waits until the device has carried it out, and returns its response; see
    /// [`Device::request`](super::Device::request).
    ///
    /// # Errors
    ///
    /// The command cannot be sent, is rejected or not answered, or the port fails.
    pub async fn request<C: Command>(
        &mut self,
        command: &C,
    ) -> Result<C::Response, DeviceError<P::Error>> {
        Ok(response::<C>(self.exchange(command, 1).await?)?)
    }

    /// Sends a command, and does not wait for a reply; one that arrives is data. See
    /// [`Device::send`](super::Device::send).
    ///
    /// # Errors
    ///
    /// The command cannot be sent, or the port fails.
    pub async fn send<C: Command>(&mut self, command: &C) -> Result<(), DeviceError<P::Error>> {
        if command.expects_reply() {
            self.core.client.ignore_reply();
        }
        let (_, packet) = self.core.client.send_any(&Silent(command), 0)?;
        write(&mut self.port, packet.bytes()).await
    }

    /// Sends a command, and returns the undecoded response; again, up to this number of times, if
    /// noise may be why there is none. What it awaits does not depend on the command's type.
    pub(crate) async fn exchange<C: AnyCommand>(
        &mut self,
        command: &C,
        mut attempts: u8,
    ) -> Result<Option<RawField<'_>>, DeviceError<P::Error>> {
        let ticket = loop {
            self.begin().await?;
            let (ticket, _) = self.core.client.send_any(command, 0)?; // times are relative to this moment
            self.finish().await?;
            attempts = attempts.saturating_sub(1);
            if attempts == 0 || !self.core.client.may_be_noise(ticket) {
                break ticket;
            }
        };
        Ok(self.core.client.take_reply(ticket, command)?)
    }

    /// Sends several commands of one descriptor set in one packet, and returns their responses.
    ///
    /// # Errors
    ///
    /// Those of [`AsyncDevice::request`]; of several rejected commands, it is the error of the first.
    pub async fn request_all<C: Commands>(
        &mut self,
        commands: C,
    ) -> Result<C::Responses, DeviceError<P::Error>> {
        let tickets = self.send_all(C::SET, |request| commands.add(request)).await?;
        Ok(C::responses(&tickets, &self.core.client)?)
    }

    /// Sends several commands of one descriptor set in one packet, and waits for all replies; see
    /// [`Device::send_all`](super::Device::send_all).
    ///
    /// # Errors
    ///
    /// Returns the error of the closure or of the port.
    pub async fn send_all<T>(
        &mut self,
        set: DescriptorSet,
        add: impl FnOnce(&mut Request<'_>) -> Result<T, RequestError>,
    ) -> Result<T, DeviceError<P::Error>> {
        self.begin().await?;
        let mut request = self.core.client.request(set);
        let tickets = add(&mut request)?;
        let _ = request.send(0);
        self.finish().await?;
        Ok(tickets)
    }

    /// Forgets the earlier commands, takes in what waits, and sends a barrier if a command was not
    /// answered.
    async fn begin(&mut self) -> Result<(), DeviceError<P::Error>> {
        self.core.client.clear();
        let (mut backlog, mut over) = (BACKLOG, pin!(ready(())));
        while read(&mut self.port, &mut self.core, over.as_mut(), &mut backlog).await? {}
        match self.core.client.barrier() {
            Some(barrier) => write(&mut self.port, barrier.bytes()).await,
            None => Ok(()),
        }
    }

    /// Sends the packet in the client, and waits until no command is pending. This does not depend
    /// on the types of commands, so that its code exists once.
    async fn finish(&mut self) -> Result<(), DeviceError<P::Error>> {
        let packet = self.core.client.packet();
        if !packet.payload().is_empty() {
            write(&mut self.port, packet.bytes()).await?;
        }
        let mut now_ms = 0;
        while let Some(deadline) = self.core.client.deadline() {
            let (mut backlog, mut sleep) =
                (BACKLOG, pin!((self.sleep)(deadline.wrapping_sub(now_ms))));
            while self.core.client.pending() > 0 {
                if !read(&mut self.port, &mut self.core, sleep.as_mut(), &mut backlog).await? {
                    now_ms = deadline;
                    self.core.tick(now_ms);
                    break;
                }
            }
        }
        Ok(())
    }

    /// Returns the response to a command of [`AsyncDevice::send_all`], until the next command is
    /// sent.
    ///
    /// # Errors
    ///
    /// The device rejected or did not answer the command; or it was sent before the last call
    /// ([`Reason::Forgotten`](crate::client::Reason::Forgotten)).
    pub fn answer<C: Command>(&self, ticket: &Ticket<C>) -> Result<C::Response, CommandError> {
        self.core.answer(ticket)
    }

    /// Like [`AsyncDevice::answer`], but without decoding the response; see
    /// [`Device::event`](super::Device::event).
    pub fn event<C>(&self, ticket: &Ticket<C>) -> Option<&Event> {
        self.core.client.known_event(ticket)
    }

    /// Returns the next packet with data or other fields that do not answer a command, or `None` if
    /// none arrives within this number of milliseconds.
    ///
    /// Continuation packets are returned one by one, as the device sends them.
    ///
    /// # Errors
    ///
    /// The port fails.
    pub async fn next_packet(
        &mut self,
        wait_ms: u32,
    ) -> Result<Option<Packet<'_>>, DeviceError<P::Error>> {
        if self.core.data.len() == 0 {
            self.core.client.give_up();
            self.read_until(wait_ms, |core| core.data.len() > 0).await?;
        }
        Ok(self.core.data.pop())
    }

    /// Returns the fields `F` of the packets that [`AsyncDevice::next_packet`] would return, with
    /// their times: `let mut data = device.fields::<ScaledAccel>(1000)`, and then
    /// `while let Some(found) = data.next().await`. See [`Device::fields`](super::Device::fields).
    pub fn fields<T: FromPacket>(&mut self, wait_ms: u32) -> Timed<&mut Self, T> {
        let times = self.core.times();
        Timed::new(self, times, wait_ms)
    }

    /// Reads until the condition holds, or this number of milliseconds has passed.
    async fn read_until(
        &mut self,
        wait_ms: u32,
        holds: impl Fn(&Core<N, Q>) -> bool,
    ) -> Result<(), DeviceError<P::Error>> {
        if holds(&self.core) {
            return Ok(());
        }
        let (mut backlog, mut sleep) = (BACKLOG, pin!((self.sleep)(wait_ms)));
        while !holds(&self.core) {
            if !read(&mut self.port, &mut self.core, sleep.as_mut(), &mut backlog).await? {
                self.core.look_behind();
                break;
            }
        }
        Ok(())
    }

    /// Sends up to two pings until any packet arrives; see [`Device`](super::Device).
    #[allow(dead_code)] // without the features of command sets
    pub(crate) async fn is_heard(
        &mut self,
        ping: &Bytes<'_>,
        wait_ms: u32,
    ) -> Result<bool, DeviceError<P::Error>> {
        let mut heard = false;
        self.core.parser = Parser::new();
        self.discard();
        for _ in 0..2 {
            self.core.client.clear();
            let (_, packet) = self.core.client.send_any(ping, 0)?;
            write(&mut self.port, packet.bytes()).await?;
            let came = |core: &Core<N, Q>| core.client.pending() == 0 || core.data.len() > 0;
            self.read_until(wait_ms, came).await?;
            heard = came(&self.core);
            if heard {
                break;
            }
        }
        self.core.client.clear();
        self.discard();
        Ok(heard)
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
    pub(crate) async fn pass(&mut self, wait_ms: u32) -> Result<(), DeviceError<P::Error>> {
        self.read_until(wait_ms, |_| false).await
    }

    /// Changes the baud rate of the port; returns `false` if that is not possible.
    #[allow(dead_code)] // without the features of command sets
    pub(crate) fn set_baud(&mut self, rate: u32) -> Result<bool, DeviceError<P::Error>> {
        let done = self.set_baud.map_or(false, |set_baud| set_baud(&mut self.port, rate));
        if done {
            self.baud = Some(rate);
        }
        Ok(done)
    }
}

impl<P, S, F, T, const N: usize, const Q: usize> Timed<&mut AsyncDevice<P, S, N, Q>, T>
where
    P: Read + Write,
    S: FnMut(u32) -> F,
    F: Future<Output = ()>,
    T: FromPacket,
{
    /// Returns the next fields, and the time of their packet; `None` if no packet arrives in time.
    #[allow(clippy::should_implement_trait)] // it is asynchronous
    pub async fn next(&mut self) -> Option<Result<(Option<Time>, T), DeviceError<P::Error>>> {
        next_fields!(self, self.source.next_packet(self.wait_ms).await, DeviceError::Data)
    }
}

/// Writes all bytes, unlike `write_all` without a panic if the port accepts none.
async fn write<P: Write>(port: &mut P, mut bytes: &[u8]) -> Result<(), DeviceError<P::Error>> {
    while !bytes.is_empty() {
        match port.write(bytes).await {
            Ok(0) => return Err(DeviceError::Closed),
            Ok(count) => bytes = behind(bytes, count),
            Err(error) if error.kind() == ErrorKind::Interrupted => pause().await,
            Err(error) => return Err(DeviceError::Port(error)),
        }
    }
    loop {
        match port.flush().await {
            Err(error) if error.kind() == ErrorKind::Interrupted => pause().await,
            done => return done.map_err(DeviceError::Port),
        }
    }
}

/// Yields to other futures once; otherwise a timer may never fire.
async fn pause() {
    let mut again = true;
    poll_fn(|context| {
        if core::mem::take(&mut again) {
            context.waker().wake_by_ref();
            return Poll::Pending;
        }
        Poll::Ready(())
    })
    .await;
}

/// Reads once. Returns false if the time is over and there is no more to read.
async fn read<P: Read, const N: usize, const Q: usize>(
    port: &mut P,
    core: &mut Core<N, Q>,
    mut sleep: Pin<&mut impl Future<Output = ()>>,
    backlog: &mut u8,
) -> Result<bool, DeviceError<P::Error>> {
    let mut chunk = [0; CHUNK];
    let room = core.part(&mut chunk);
    let (count, late) = {
        let mut read = pin!(port.read(room));
        poll_fn(|context| {
            // The timer is polled first, in case the program is suspended in between, and not again
            // after it has fired.
            let late = *backlog < BACKLOG || sleep.as_mut().poll(context).is_ready();
            let count = read.as_mut().poll(context);
            match count {
                Poll::Ready(count) => Poll::Ready((Some(count), late)),
                Poll::Pending if late => Poll::Ready((None, late)),
                Poll::Pending => Poll::Pending,
            }
        })
        .await
    };
    let nothing = matches!(&count, Some(Err(error)) if is_nothing(error));
    // After an interrupted read, there may be more.
    let empty = matches!(&count, Some(Err(error)) if error.kind() == ErrorKind::TimedOut);
    let over = is_over(late, count.is_some() && !empty, backlog);
    match count {
        None => Ok(false),
        Some(Ok(0)) if core.look_behind() => Ok(!over),
        Some(Ok(0)) => Err(DeviceError::Closed),
        Some(Ok(count)) => {
            core.arrived(room.get(..count).unwrap_or_default());
            Ok(!over)
        }
        Some(Err(_)) if nothing => {
            pause().await;
            Ok(!over)
        }
        Some(Err(error)) => Err(DeviceError::Port(error)),
    }
}

/// Does this read error only mean that there is no data yet?
fn is_nothing(error: &impl Error) -> bool {
    matches!(error.kind(), ErrorKind::Interrupted | ErrorKind::TimedOut)
}
