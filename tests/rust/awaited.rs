//! An asynchronous device with the functions of a blocking one, so that the same tests run with both.
#![allow(dead_code)] // each program needs some of it

use std::cell::Cell;
use std::future::{poll_fn, Future};
use std::pin::{pin, Pin};
use std::rc::Rc;
use std::sync::Arc;
use std::task::{Context, Poll, Wake, Waker};

use mip_protocol::client::{Event, Request};
use mip_protocol::device::{AsyncDevice, Commands, DeviceError, Port};
use mip_protocol::{
    Client, Command, CommandError, DescriptorSet, FromPacket, Packet, Parser, RequestError, Ticket,
    Time,
};

/// A port that is read each time when it is polled; at first, only if it says that bytes wait. It has the clock of that
/// port.
pub struct Awaited<P> {
    port: P,
    now: Rc<Cell<u32>>,
}

impl<P: Port> embedded_io_async::ErrorType for Awaited<P>
where
    P::Error: embedded_io_async::Error,
{
    type Error = P::Error;
}

impl<P: Port> embedded_io_async::Read for Awaited<P>
where
    P::Error: embedded_io_async::Error,
{
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, P::Error> {
        let mut first = true;
        poll_fn(|_| {
            if std::mem::take(&mut first) && matches!(self.port.waits(), Ok(false)) {
                return Poll::Pending;
            }
            let count = self.port.read(buffer);
            self.now.set(self.port.now_ms());
            if matches!(count, Ok(0)) {
                Poll::Pending
            } else {
                Poll::Ready(count)
            }
        })
        .await
    }
}

impl<P: Port> embedded_io_async::Write for Awaited<P>
where
    P::Error: embedded_io_async::Error,
{
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, P::Error> {
        self.port.write(bytes).map(|()| bytes.len())
    }

    async fn flush(&mut self) -> Result<(), P::Error> {
        Ok(())
    }
}

pub type Sleep = Pin<Box<dyn Future<Output = ()>>>;
pub type Inner<P, const N: usize, const Q: usize> =
    AsyncDevice<Awaited<P>, Box<dyn FnMut(u32) -> Sleep>, N, Q>;

pub struct Device<P, const N: usize = 8, const Q: usize = 4096>(Inner<P, N, Q>);

struct Nobody;

impl Wake for Nobody {
    fn wake(self: Arc<Self>) {}
}

pub fn block_on<T>(future: impl Future<Output = T>) -> T {
    let waker = Waker::from(Arc::new(Nobody));
    let mut future = pin!(future);
    loop {
        if let Poll::Ready(done) = future.as_mut().poll(&mut Context::from_waker(&waker)) {
            return done;
        }
    }
}

impl<P: Port> Device<P>
where
    P::Error: embedded_io_async::Error,
{
    pub fn new(port: P) -> Self {
        Self::with_client(port, Client::new())
    }
}

impl<P: Port, const N: usize, const Q: usize> Device<P, N, Q>
where
    P::Error: embedded_io_async::Error,
{
    pub fn with_client(mut port: P, client: Client<N>) -> Self {
        let (now, rate) = (Rc::new(Cell::new(port.now_ms())), port.baud());
        let clock = now.clone();
        let sleep: Box<dyn FnMut(u32) -> Sleep> = Box::new(move |milliseconds| {
            let (clock, end) = (clock.clone(), clock.get().wrapping_add(milliseconds));
            let left = move || end.wrapping_sub(clock.get()) as i32;
            Box::pin(poll_fn(move |_| if left() > 0 { Poll::Pending } else { Poll::Ready(()) }))
        });
        let device = AsyncDevice::with_client(Awaited { port, now }, sleep, client);
        Self(match rate {
            Some(rate) => device
                .with_baud(rate, |awaited, rate| awaited.port.set_baud(rate).unwrap_or_default()),
            None => device,
        })
    }

    pub fn port(&self) -> &P {
        &self.0.port().port
    }

    pub fn port_mut(&mut self) -> &mut P {
        &mut self.0.port_mut().port
    }

    /// The device, at the present time of the port.
    pub fn inner(&mut self) -> &mut Inner<P, N, Q> {
        let Awaited { port, now } = self.0.port_mut();
        now.set(port.now_ms());
        &mut self.0
    }

    pub fn request<C: Command>(
        &mut self,
        command: &C,
    ) -> Result<C::Response, DeviceError<P::Error>> {
        block_on(self.inner().request(command))
    }

    pub fn send<C: Command>(&mut self, command: &C) -> Result<(), DeviceError<P::Error>> {
        block_on(self.inner().send(command))
    }

    pub fn request_all<C: Commands>(
        &mut self,
        commands: C,
    ) -> Result<C::Responses, DeviceError<P::Error>> {
        block_on(self.inner().request_all(commands))
    }

    pub fn send_all<T>(
        &mut self,
        set: DescriptorSet,
        add: impl FnOnce(&mut Request<'_>) -> Result<T, RequestError>,
    ) -> Result<T, DeviceError<P::Error>> {
        block_on(self.inner().send_all(set, add))
    }

    pub fn answer<C: Command>(&self, ticket: &Ticket<C>) -> Result<C::Response, CommandError> {
        self.0.answer(ticket)
    }

    pub fn event<C>(&self, ticket: &Ticket<C>) -> Option<&Event> {
        self.0.event(ticket)
    }

    pub fn fields<T: FromPacket>(
        &mut self,
        wait_ms: u32,
    ) -> impl Iterator<Item = Result<(Option<Time>, T), DeviceError<P::Error>>> + '_
    where
        T: 'static,
    {
        let mut fields = self.inner().fields::<T>(wait_ms);
        std::iter::from_fn(move || block_on(fields.next()))
    }

    pub fn parser(&self) -> &Parser {
        self.0.parser()
    }

    pub fn dropped(&self) -> u32 {
        self.0.dropped()
    }

    pub fn next_packet(
        &mut self,
        wait_ms: u32,
    ) -> Result<Option<Packet<'_>>, DeviceError<P::Error>> {
        block_on(self.inner().next_packet(wait_ms))
    }
}
