//! The fields of packets, with their times.

use core::fmt;
use core::marker::PhantomData;

use crate::error::DecodeError;
use crate::packet::{FromPacket, Packet};
use crate::slice::Packets;
use crate::time::{Time, Times};

/// The fields `F` of packets, one after another, each with the time of its packet; from
/// [`Packets::fields`], `PacketReader::fields`, [`Device::fields`](crate::device::Device::fields)
/// and `AsyncDevice::fields`.
///
/// The time is that of the packet's first clock in [`Clock::ALL`](crate::Clock::ALL), or `None` if
/// it has no valid one. Packets without these fields are skipped.
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct Timed<S, F> {
    pub(crate) source: S,
    pub(crate) wait_ms: u32,
    pub(crate) reader: Reader<F>,
}

/// Returns the next fields of the packets that an expression returns, or its error.
macro_rules! next_fields {
    ($timed:ident, $packet:expr, $invalid:expr) => {
        loop {
            match $packet {
                Ok(packet) => {
                    if let Some(found) = $timed.reader.read(&packet?) {
                        return Some(found.map_err($invalid));
                    }
                }
                Err(error) => return Some(Err(error)),
            }
        }
    };
}

#[allow(unused_imports)] // without features
pub(crate) use next_fields;

/// Reads fields and times.
pub(crate) struct Reader<F> {
    times: Times,
    fields: PhantomData<fn() -> F>,
}

impl<F: FromPacket> Reader<F> {
    #[inline]
    pub(crate) fn read(
        &mut self,
        packet: &Packet<'_>,
    ) -> Option<Result<(Option<Time>, F), DecodeError>> {
        let time = self.times.first(packet);
        F::from_packet(packet).transpose().map(|found| found.map(|fields| (time, fields)))
    }
}

impl<S, F> Timed<S, F> {
    pub(crate) fn new(source: S, times: Times, wait_ms: u32) -> Self {
        Self { source, wait_ms, reader: Reader { times, fields: PhantomData } }
    }

    /// Reads the times of this device; see [`Times::of`]. A `Device` that has been asked what it is,
    /// by `profile` or `stream`, reads those of its own model without this.
    #[cfg(feature = "devices")]
    pub fn of_device(mut self, device: &crate::devices::Profile) -> Self {
        self.reader.times = Times::of(device);
        self
    }
}

impl<S, F> fmt::Debug for Timed<S, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Timed").field("times", &self.reader.times).finish_non_exhaustive()
    }
}

impl<F: FromPacket> Iterator for Timed<Packets<'_>, F> {
    type Item = Result<(Option<Time>, F), DecodeError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.source.by_ref().find_map(|packet| self.reader.read(&packet))
    }
}
