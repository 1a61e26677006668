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
use mip_protocol::devices::{Profile, Rejected};
use mip_protocol::session::{ChangesBaud, Rate, StreamError};
use mip_protocol::{
    Client, Command, CommandError, DescriptorSet, FromPacket, Packet, Parser, RequestError, Ticket,
};

/// A port that is read each time when it is polled. It has the clock of that port.
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
        poll_fn(|_| {
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

type Sleep = Pin<Box<dyn Future<Output = ()>>>;
type Inner<P, const N: usize, const Q: usize> =
    AsyncDevice<Awaited<P>, Box<dyn FnMut(u32) -> Sleep>, N, Q>;

pub struct Device<P, const N: usize = 8, const Q: usize = 4096>(Inner<P, N, Q>);

struct Nobody;

impl Wake for Nobody {
    fn wake(self: Arc<Self>) {}
}

fn block_on<T>(future: impl Future<Output = T>) -> T {
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

    pub fn connect(&mut self, rates: &[u32]) -> Result<Option<u32>, DeviceError<P::Error>> {
        block_on(self.0.connect(rates))
    }

    pub fn stream(
        &mut self,
        set: DescriptorSet,
        rates: &[Rate],
    ) -> Result<u16, StreamError<P::Error>> {
        block_on(self.0.stream(set, rates))
    }

    pub fn change_baud(
        &mut self,
        command: &impl ChangesBaud,
    ) -> Result<u32, DeviceError<P::Error>> {
        block_on(self.0.change_baud(command))
    }

    pub fn profile(&mut self) -> Result<Option<&'static Profile>, DeviceError<P::Error>> {
        block_on(self.0.profile())
    }

    pub fn rejected(
        &mut self,
        command: &impl Command,
    ) -> Result<Option<Rejected>, DeviceError<P::Error>> {
        block_on(self.0.rejected(command))
    }

    pub fn request<C: Command>(
        &mut self,
        command: &C,
    ) -> Result<C::Response, DeviceError<P::Error>> {
        block_on(self.0.request(command))
    }

    pub fn next_packet(
        &mut self,
        wait_ms: u32,
    ) -> Result<Option<Packet<'_>>, DeviceError<P::Error>> {
        block_on(self.0.next_packet(wait_ms))
    }
}
