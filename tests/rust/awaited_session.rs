//! The functions of `session` of an asynchronous device, as those of a blocking one.

use mip_protocol::device::{DeviceError, Port};
use mip_protocol::devices::{Profile, Rejected};
use mip_protocol::session::{ChangesBaud, Rate, StreamError};
use mip_protocol::{Command, DescriptorSet};

use crate::awaited::{block_on, Device};

impl<P: Port, const N: usize, const Q: usize> Device<P, N, Q>
where
    P::Error: embedded_io_async::Error,
{
    pub fn connect(&mut self, rates: &[u32]) -> Result<Option<u32>, DeviceError<P::Error>> {
        block_on(self.inner().connect(rates))
    }

    pub fn stream(
        &mut self,
        set: DescriptorSet,
        rates: &[Rate],
    ) -> Result<u16, StreamError<P::Error>> {
        block_on(self.inner().stream(set, rates))
    }

    pub fn stream_only(
        &mut self,
        set: DescriptorSet,
        rates: &[Rate],
    ) -> Result<u16, StreamError<P::Error>> {
        block_on(self.inner().stream_only(set, rates))
    }

    pub fn change_baud(
        &mut self,
        command: &impl ChangesBaud,
    ) -> Result<u32, DeviceError<P::Error>> {
        block_on(self.inner().change_baud(command))
    }

    pub fn profile(&mut self) -> Result<Option<&'static Profile>, DeviceError<P::Error>> {
        block_on(self.inner().profile())
    }

    pub fn rejected(
        &mut self,
        command: &impl Command,
    ) -> Result<Option<Rejected>, DeviceError<P::Error>> {
        block_on(self.inner().rejected(command))
    }
}
