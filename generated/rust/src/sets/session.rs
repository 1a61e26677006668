//! First steps with a device: finding its baud rate, and starting its data at rates in Hz.
//!
//! `open` finds a device on a port of the computer, [`Device::connect`] on any port, and
//! [`Device::stream`] starts its data.

use core::fmt;

use crate::client::{kind, response, Bytes};
use crate::codec::Writer;
use crate::device::{Device, DeviceError, Port};
#[cfg(feature = "devices")]
use crate::devices::{model_number, Known, Profile, Rejected};
use crate::error::EncodeError;
use crate::field::check;
#[cfg(feature = "devices")]
use crate::field::RawField;
use crate::packet::MAX_FIELD_DATA;
#[allow(unused_imports)]
use crate::types;
#[cfg(feature = "devices")]
use crate::List;
use crate::{Command, CommandError, DescriptorSet, Field, Reason};

/// The baud rates of all known devices: the usual one first, the others in descending order.
#[rustfmt::skip]
pub const BAUD_RATES: &[u32] = &[
    115200, 3000000, 921600, 460800, 230400, 57600, 38400, 19200, 9600, 4800,
];

/// The descriptor sets (0 for all) and the descriptors of the timestamps that a stream tries.
const TIMESTAMPS: [(u8, u8); 10] = [
    (0, 0xD5),
    (0, 0xD7),
    (0x81, 0x09),
    (0x91, 0x09),
    (0x92, 0x09),
    (0x94, 0x09),
    (0x95, 0x09),
    (0x82, 0x11),
    (0x80, 0x12),
    (0, 0xD3),
];

/// The time-out of a ping in milliseconds.
const LISTEN: u32 = 150;
/// The time in milliseconds that a device takes to change its baud rate after the acknowledge.
const CHANGE: u32 = 250;
/// The number of attempts for a command without a reply, or with an incorrect one.
const ATTEMPTS: u8 = 3;

/// Opens a port, finds the device there, and sets it to idle: its streams are then off until
/// [`Device::stream`] starts one, or the resume command is sent.
///
/// `place` is one of these:
///
/// - `/dev/ttyACM0`, `COM3:460800`: a serial port. The [`BAUD_RATES`] are tried until the device
///   answers, which takes about a third of a second each; a given rate is tried first.
/// - `192.168.1.20:9000`: a host and a port.
/// - `log.bin`: a recorded log, whose packets [`Device::next_packet`] returns.
///
/// The prefixes `serial:`, `tcp:` and `file:` state the kind.
///
/// # Errors
///
/// [`DeviceError::Port`], with a remedy, if the port cannot be opened or no device answers.
#[cfg(feature = "open")]
pub fn open(place: &str) -> Result<Device<crate::device::Line>, DeviceError<std::io::Error>> {
    let line = crate::device::Line::open(place).map_err(DeviceError::Port)?;
    let (given, is_log, has_rate) = (line.named_baud(), line.is_log(), line.baud().is_some());
    let mut device = Device::new(line);
    if is_log {
        return Ok(device);
    }
    let all = if has_rate { BAUD_RATES } else { &[] };
    let mut found = device.connect(given.as_ref().map_or(all, core::slice::from_ref));
    if given.is_some() && is_timeout(&found) {
        found = device.connect(all);
    }
    if is_timeout(&found) {
        return Err(DeviceError::Port(nobody(place, all)));
    }
    found.map(|_| device)
}

/// Like [`open`], for a runtime of `tokio`; `place` cannot be a log.
///
/// # Errors
///
/// Returns the errors of [`open`].
#[cfg(feature = "tokio")]
pub async fn open_async(
    place: &str,
) -> Result<crate::device::TokioDevice, DeviceError<std::io::Error>> {
    let line = crate::device::AsyncLine::open(place).await.map_err(DeviceError::Port)?;
    let given = line.named_baud();
    let mut device = crate::device::TokioDevice::at(line);
    let all = if device.baud().is_some() { BAUD_RATES } else { &[] };
    let mut found = device.connect(given.as_ref().map_or(all, core::slice::from_ref)).await;
    if given.is_some() && is_timeout(&found) {
        found = device.connect(all).await;
    }
    if is_timeout(&found) {
        return Err(DeviceError::Port(nobody(place, all)));
    }
    found.map(|_| device)
}

/// The error for a device that was not found, with the remedy.
#[cfg(feature = "open")]
fn nobody(place: &str, rates: &[u32]) -> std::io::Error {
    let list = std::format!("{rates:?}");
    let list = list.trim_matches(['[', ']']);
    let at = if list.is_empty() { "" } else { " at " };
    let text =
        std::format!("{place}: no device answers{at}{list}; is it switched on, and on this port?");
    std::io::Error::new(std::io::ErrorKind::NotFound, text)
}

/// A field of a stream, and how often it is sent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rate {
    descriptor: u8,
    hz: f32,
    /// Empty for any set.
    sets: &'static [DescriptorSet],
    name: &'static str,
}

impl Rate {
    /// A field at a rate in Hz, for example 100.
    ///
    /// ```
    /// use mip_protocol::sensor::{ScaledAccel, ScaledGyro};
    /// use mip_protocol::session::Rate;
    ///
    /// let rates = [Rate::of::<ScaledAccel>(100.0), Rate::fastest::<ScaledGyro>()];
    /// assert_ne!(rates[0], Rate::fastest::<ScaledAccel>());
    /// ```
    #[must_use]
    pub const fn of<T: Field>(hz: f32) -> Self {
        Self { descriptor: T::DESCRIPTOR, hz, sets: T::SETS, name: T::NAME }
    }

    /// A field at the highest rate of the device.
    #[must_use]
    pub const fn fastest<T: Field>() -> Self {
        Self::of::<T>(f32::INFINITY)
    }

    /// The same for a field of unknown type, by its descriptor. An infinite rate is the highest one.
    #[must_use]
    pub const fn of_descriptor(descriptor: u8, hz: f32) -> Self {
        Self { descriptor, hz, sets: &[], name: "" }
    }

    /// Returns the decimation whose rate is nearest to `hz`.
    ///
    /// This computes with integers: on a microcontroller that has none for floats, the functions of
    /// the compiler would take 2 kB.
    fn decimation(&self, base: u16) -> u16 {
        let wanted = self.hz.to_bits(); // they have the order of positive floats
        if self.hz.is_sign_negative() {
            return u16::MAX;
        }
        // The greatest decimation whose rate is at least `hz`, bit by bit.
        let (mut below, mut bit) = (0, 1 << 15);
        while bit > 0 {
            if quotient(base, below | bit).to_bits() >= wanted {
                below |= bit;
            }
            bit >>= 1;
        }
        if below == 0 || below == u16::MAX {
            return below.max(1);
        }
        // Is `hz` at least the mean of its rate and the next one, which is at least half of it?
        let above = below.wrapping_add(1);
        let [low, high] = [above, below].map(|x| quotient(base, x).to_bits());
        let places = |x: u32| (x >> 23).wrapping_sub(low >> 23);
        let digits = |x: u32| (x & 0x7F_FFFF | 0x80_0000).wrapping_shl(places(x));
        let sum = digits(low).wrapping_add(digits(high));
        if digits(wanted).wrapping_mul(2) >= sum {
            below
        } else {
            above
        }
    }
}

/// Divides as floats are divided: the result is the nearest one.
fn quotient(base: u16, decimation: u16) -> f32 {
    if base == 0 {
        return 0.0;
    }
    // Long division, until there is one binary digit more than a float has.
    let (mut dividend, divisor) = (u32::from(base) << 16, u32::from(decimation));
    let (mut rest, mut digits, mut exponent) = (0_u32, 0_u32, 166_u32);
    while digits < 1 << 24 {
        rest = rest << 1 | dividend >> 31;
        dividend <<= 1;
        let fits = rest >= divisor;
        rest = rest.wrapping_sub(if fits { divisor } else { 0 });
        digits = digits << 1 | u32::from(fits);
        exponent = exponent.wrapping_sub(1);
    }
    f32::from_bits((exponent << 23).wrapping_add(digits.wrapping_add(1) >> 1))
}

/// Is the wanted rate this one, but for a ten-thousandth of it? 333.33 Hz is 1000 Hz / 3. To compare
/// floats, a microcontroller may need a function of the compiler.
fn same(wanted: f32, rate: f32) -> bool {
    let off = wanted.to_bits().abs_diff(rate.to_bits());
    off.saturating_mul(10_000) <= wanted.to_bits() & 0x7F_FFFF | 0x80_0000
}

/// The reason why a stream was not started.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StreamError<E> {
    /// A command failed.
    Device(DeviceError<E>),
    /// The device rejected a field.
    #[cfg(feature = "devices")]
    Rejected {
        /// The command, and the code with which the device rejected it.
        error: CommandError,
        /// The field, and why it was rejected.
        field: Rejected,
    },
    /// The device does not support this rate: it divides its base rate by whole numbers. No setting
    /// was changed.
    NoSuchRate {
        /// The field.
        descriptor: u8,
        /// The field's name; empty if only its descriptor was given.
        name: &'static str,
        /// The requested rate, in Hz.
        wanted: f32,
        /// The nearest rate of the device, in Hz.
        nearest: f32,
        /// The base rate of the descriptor set, in Hz.
        base: u16,
    },
}

impl<E> From<DeviceError<E>> for StreamError<E> {
    fn from(error: DeviceError<E>) -> Self {
        Self::Device(error)
    }
}

impl<E: fmt::Display> fmt::Display for StreamError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Device(error) => error.fmt(f),
            #[cfg(feature = "devices")]
            Self::Rejected { error, field } => write!(f, "{error}: {field}"),
            Self::NoSuchRate { descriptor, name, wanted, nearest, base } => {
                if name.is_empty() {
                    write!(f, "field 0x{descriptor:02X}")?;
                } else {
                    f.write_str(name)?;
                }
                if *wanted == 0.0 {
                    return f.write_str(" at 0 Hz: for the highest rate, use Rate::fastest");
                }
                write!(f, " at {wanted} Hz: not a rate of the device; nearest: {nearest} Hz")?;
                write!(f, ", as it divides {base} Hz by whole numbers")
            }
        }
    }
}

#[cfg(any(feature = "core-error", feature = "std"))]
impl<E: fmt::Debug + fmt::Display> crate::error::Error for StreamError<E> {
    fn source(&self) -> Option<&(dyn crate::error::Error + 'static)> {
        match self {
            Self::Device(error) => error.source(),
            _ => None,
        }
    }
}

impl types::DescriptorRate {
    /// Creates the entry for a field: it is sent at the base rate divided by `decimation`.
    #[must_use]
    pub fn of<T: Field>(decimation: u16) -> Self {
        Self::new(T::DESCRIPTOR, decimation)
    }
}

/// A command that changes the baud rate of a port of the device.
pub trait ChangesBaud: Command {
    /// The new rate, if the command writes one.
    fn new_baud(&self) -> Option<u32>;
}

impl ChangesBaud for crate::protocol::WriteCall<crate::base::CommSpeed> {
    fn new_baud(&self) -> Option<u32> {
        self.baud
    }
}

impl ChangesBaud for crate::protocol::WriteCall<crate::mip_3dm::UartBaudRate> {
    fn new_baud(&self) -> Option<u32> {
        self.baud
    }
}

/// A ping.
const fn ping() -> Bytes<'static> {
    Bytes::of(kind::<crate::base::Ping>(), &[])
}

/// The error if no device answers a ping.
fn nobody_answers<E>() -> DeviceError<E> {
    CommandError::of::<crate::base::Ping>(Reason::TimedOut).into()
}

/// Does a stream of these rates need a timestamp?
fn has_none(set: DescriptorSet, rates: &[Rate]) -> bool {
    let is_stamp = |of, rate: &Rate| TIMESTAMPS.contains(&(of, rate.descriptor));
    !rates.is_empty() && !rates.iter().any(|rate| is_stamp(0, rate) || is_stamp(set.0, rate))
}

/// Returns the number of a set's stream, and the command that writes its message format.
fn format<'m>(
    set: DescriptorSet,
    older: bool,
    stamp: Option<Rate>,
    rates: &[Rate],
    base: u16,
    memory: &'m mut [u8; MAX_FIELD_DATA],
) -> Result<(u8, Bytes<'m>), EncodeError> {
    let count = (rates.len() as u8).wrapping_add(u8::from(stamp.is_some())); // more do not fit
    let mut writer = Writer::of_field(memory);
    #[rustfmt::skip] // a line for each
    let (kind, number, mut done) = match set.0 {
        0x80 if older => (kind::<crate::mip_3dm::ImuMessageFormat>(), 1, writer.put(&[1, count])),
        0x81 if older => (kind::<crate::mip_3dm::GnssMessageFormat>(), 2, writer.put(&[1, count])),
        0x82 if older => (kind::<crate::mip_3dm::FilterMessageFormat>(), 3, writer.put(&[1, count])),
        _ => (kind::<crate::mip_3dm::MessageFormat>(), set.0, writer.put(&[1, set.0, count])),
    };
    for rate in stamp.iter().chain(rates) {
        let item = types::DescriptorRate::new(rate.descriptor, rate.decimation(base));
        done = done.and_then(|()| writer.write(&item));
    }
    let size = writer.finish(done, kind.name())?;
    Ok((number, Bytes::of(kind, memory.get(..size).unwrap_or_default())))
}

fn reason<T, E>(result: &Result<T, DeviceError<E>>) -> Option<Reason> {
    match result {
        Err(DeviceError::Command(error)) => Some(error.reason),
        _ => None,
    }
}

fn is_timeout<T, E>(result: &Result<T, DeviceError<E>>) -> bool {
    reason(result) == Some(Reason::TimedOut)
}

fn is_refused<T, E>(result: &Result<T, DeviceError<E>>) -> bool {
    matches!(reason(result), Some(Reason::Refused(_)))
}

/// Returns `None` for the error of a command.
#[cfg(feature = "devices")]
fn answered<T, E>(result: Result<T, DeviceError<E>>) -> Result<Option<T>, DeviceError<E>> {
    match result {
        Err(DeviceError::Command(_)) => Ok(None),
        result => result.map(Some),
    }
}

/// The functions of a device, written once: an asynchronous one awaits.
macro_rules! functions {
    ([$($of:tt)*] [$($async:tt)*] [$($await:tt)*]) => {
$($of)* {
    /// Finds the device: tries each of these baud rates, such as [`BAUD_RATES`], until a device
    /// answers a ping or sends data; then sets the device to idle. Data that arrived is discarded.
    ///
    /// Returns the rate; `None` if the port supports none of them, for example a TCP connection.
    /// Commands without a reply are repeated. A rate at which no device answers takes about a third
    /// of a second.
    ///
    /// # Errors
    ///
    /// The port fails, or no device answers ([`Reason::TimedOut`]); the port then has the rate that
    /// was tried last.
    pub $($async)* fn connect(
        &mut self,
        rates: &[u32],
    ) -> Result<Option<u32>, DeviceError<P::Error>> {
        let (mut found, mut tried) = (None, false);
        for rate in rates {
            if self.set_baud(*rate)? {
                tried = true;
                if self.is_heard(&ping(), LISTEN)$($await)*? {
                    found = Some(*rate);
                    break;
                }
            }
        }
        if tried && found.is_none() {
            return Err(nobody_answers());
        }
        self.tell::<crate::base::SetIdle>(&[])$($await)*?;
        self.discard();
        #[cfg(feature = "devices")]
        {
            *self.model() = None; // it may be another device
        }
        Ok(found)
    }

    /// Starts the data of a descriptor set: reads its base rate, writes which fields are sent and
    /// how often, in this order, enables the stream, and ends the idle state. Returns the base rate
    /// in Hz, which is that of [`Rate::fastest`]. A base rate of 0 means that data is sent as it
    /// arrives.
    ///
    /// The first timestamp that the device accepts is added, as often as the most frequent field,
    /// unless `rates` has one; see [`Self::stream_only`]. If the device rejects the first command,
    /// the older commands for the set are used instead. Commands without a reply are repeated. With
    /// the feature `open`, it first asks which model the device is, unless that is known.
    ///
    /// Packets of the set that were kept have the earlier format: with the feature `std`, they are
    /// discarded; without it, `next_packet` returns them first.
    ///
    /// # Errors
    ///
    /// [`StreamError::NoSuchRate`], before any setting is changed; [`StreamError::Rejected`] if the
    /// device rejects one of the fields, with the feature `open`; [`StreamError::Device`] if a field
    /// does not occur in the set, there are too many, or a command fails.
    pub $($async)* fn stream(
        &mut self,
        set: DescriptorSet,
        rates: &[Rate],
    ) -> Result<u16, StreamError<P::Error>> {
        self.start(set, rates, true)$($await)*
    }

    /// Like [`Self::stream`], without adding a timestamp: packets have no time unless one is listed,
    /// best in front of the fields of a single set, because each packet of a long message repeats it.
    ///
    /// # Errors
    ///
    /// Returns those of [`Self::stream`].
    pub $($async)* fn stream_only(
        &mut self,
        set: DescriptorSet,
        rates: &[Rate],
    ) -> Result<u16, StreamError<P::Error>> {
        self.start(set, rates, false)$($await)*
    }

    $($async)* fn start(
        &mut self,
        set: DescriptorSet,
        rates: &[Rate],
        timed: bool,
    ) -> Result<u16, StreamError<P::Error>> {
        for rate in rates {
            let occurs = rate.sets.iter().any(|x| x.0 == set.0); // smaller than `contains`
            if let Some(first) = rate.sets.first().filter(|_| !occurs) {
                let error = EncodeError::set(rate.name, *first, set);
                return Err(DeviceError::Request(error.into()).into());
            }
        }
        #[cfg(feature = "open")]
        if self.model().is_none() {
            answered(self.profile()$($await)*)?;
        }
        let read = [set.0];
        let current = self.ask::<crate::mip_3dm::GetBaseRate>(&read)$($await)*
            .map(|x| x.rate);
        let older = is_refused(&current);
        let older_rate = match set.0 {
            _ if !older => None,
            0x80 => {
                let reply = self.ask::<crate::mip_3dm::GetImuBaseRate>(&[]);
                Some(reply$($await)*.map(|x| x.rate))
            }
            0x81 => {
                let reply = self.ask::<crate::mip_3dm::GetGnssBaseRate>(&[]);
                Some(reply$($await)*.map(|x| x.rate))
            }
            0x82 => {
                let reply = self.ask::<crate::mip_3dm::GetFilterBaseRate>(&[]);
                Some(reply$($await)*.map(|x| x.rate))
            }
            _ => None,
        };
        // A device that rejects this command as well does not have the set.
        let current = older_rate.filter(|rate| !is_refused(rate)).unwrap_or(current);
        let read = Bytes::of(kind::<crate::mip_3dm::GetBaseRate>(), &read);
        let base = self.explained(current, &read)$($await)*?;
        for rate in rates {
            let Rate { descriptor, hz: wanted, name, .. } = *rate;
            let decimation = rate.decimation(base);
            let nearest = quotient(base, decimation);
            let exists = match base {
                0 => decimation == 1,
                _ => same(wanted, nearest) || wanted.to_bits() == f32::INFINITY.to_bits(),
            };
            if !exists {
                return Err(StreamError::NoSuchRate { descriptor, name, wanted, nearest, base });
            }
        }
        let mut memory = [0; MAX_FIELD_DATA];
        let wanted = if timed && has_none(set, rates) { &TIMESTAMPS[..] } else { &[] };
        let mut stamps = wanted.iter().filter(|(own, _)| [0, set.0].contains(own));
        let fastest = rates.iter().map(|rate| rate.hz.to_bits()).max().map_or(0.0, f32::from_bits);
        let number = loop {
            let stamp = stamps.next().map(|x| Rate::of_descriptor(x.1, fastest)); // `None` at last
            let encoded =
                format(set, older, stamp, rates, base, &mut memory);
            let (number, command) = encoded.map_err(|e| DeviceError::Request(e.into()))?;
            let done = self.exchange(&command, ATTEMPTS)$($await)*.map(|_| ());
            if stamp.is_none() || !is_refused(&done) {
                self.explained(done, &command)$($await)*?;
                break number;
            }
        };
        #[cfg(feature = "std")] // not on microcontrollers, where it would cost memory
        self.discard_set(set);
        self.tell::<crate::mip_3dm::DataStreamControl>(&[1, number, 1])$($await)*?;
        self.tell::<crate::base::Resume>(&[])$($await)*?;
        Ok(base)
    }

    /// Sends a command that changes the baud rate, changes the rate of the port, and waits until the
    /// device answers there. Set the device to idle first.
    ///
    /// Returns the rate at which the device answers: the old one if the command is for another port
    /// of the device.
    ///
    /// # Errors
    ///
    /// The port has no baud rate, or the command writes none ([`DeviceError::NoBaudRate`]); the
    /// device rejects it; the port fails; or the device answers at neither rate
    /// ([`Reason::TimedOut`]).
    pub $($async)* fn change_baud<C>(&mut self, command: &C) -> Result<u32, DeviceError<P::Error>>
    where
        C: ChangesBaud,
    {
        let (Some(new), Some(old)) = (command.new_baud(), self.baud()) else {
            return Err(DeviceError::NoBaudRate);
        };
        match self.request(command)$($await)* {
            // The reply may have arrived at the new rate.
            result if is_timeout(&result) => {}
            result => drop(result?),
        }
        self.pass(CHANGE)$($await)*?;
        for rate in [new, old] {
            if self.set_baud(rate)? && self.is_heard(&ping(), LISTEN)$($await)*? {
                return Ok(rate);
            }
        }
        Err(nobody_answers())
    }

    /// Asks the device what it is, and returns its profile; `None` if it is newer than this crate.
    ///
    /// From then on, `fields` reads the flags of times as those of this model, or of the one most
    /// like it if only its name is known.
    ///
    /// # Errors
    ///
    /// The command fails, or the port.
    #[cfg(feature = "devices")]
    pub $($async)* fn profile(
        &mut self,
    ) -> Result<Option<&'static Profile>, DeviceError<P::Error>> {
        let reply = self.ask::<crate::base::GetDeviceInfo>(&[])$($await)*?;
        let texts = [reply.device_info.model_number.as_str(), reply.device_info.serial_number.as_str()];
        let mut numbers = texts.iter().flatten().filter_map(|text| model_number(text));
        let number = numbers.next();
        let found = number.and_then(Profile::by_model);
        *self.model() = found.or(match number {
            Some(6279) => Profile::by_id("3dm-cx5-10"),
            Some(6280) => Profile::by_id("3dm-cx5-15"),
            Some(6281) => Profile::by_id("3dm-cx5-25"),
            Some(6256) => Profile::by_id("3dm-gx5-45"),
            Some(6272) => Profile::by_id("3dm-gx5-35"),
            Some(6255) => Profile::by_id("3dm-cx5-10"),
            _ => None,
        });
        Ok(found)
    }

    /// Finds the field for which the device has rejected a command that lists fields: asks the
    /// device what it is and what it sends. `None` if nothing shows the field.
    ///
    /// # Errors
    ///
    /// The port fails. The errors of commands are ignored, because what the device has answered so
    /// far helps.
    #[cfg(feature = "devices")]
    pub $($async)* fn rejected<C: Command>(
        &mut self,
        command: &C,
    ) -> Result<Option<Rejected>, DeviceError<P::Error>> {
        let mut memory = [0; MAX_FIELD_DATA];
        let Ok(size) = command.encode(&mut memory) else { return Ok(None) };
        let data = memory.get(..size).unwrap_or_default();
        self.rejects(&RawField { set: C::SET, descriptor: C::DESCRIPTOR, data })$($await)*
    }

    /// Like `rejected`, for commands of all types.
    #[cfg(feature = "devices")]
    $($async)* fn rejects(
        &mut self,
        command: &RawField<'_>,
    ) -> Result<Option<Rejected>, DeviceError<P::Error>> {
        let profile = answered(self.profile()$($await)*)?.flatten();
        let mut descriptors = List::<u16, 256>::new();
        {
            match answered(self.ask::<crate::base::GetDeviceDescriptors>(&[])$($await)*)? {
                Some(reply) => descriptors.extend(reply.descriptors.iter().copied()),
                None => descriptors.clear(), // the others alone show nothing
            }
        }
        if descriptors.contains(&0x0107) {
            match answered(self.ask::<crate::base::GetExtendedDescriptors>(&[])$($await)*)? {
                Some(reply) => descriptors.extend(reply.descriptors.iter().copied()),
                None => descriptors.clear(), // the others alone show nothing
            }
        }
        Ok(Rejected::find(command, &Known { profile, descriptors: &descriptors }))
    }

    /// Adds the rejected field to an error, in programs for computers.
    #[cfg_attr(not(feature = "open"), allow(unused_variables, clippy::unused_self))]
    #[cfg_attr(not(feature = "open"), allow(clippy::unused_async))]
    $($async)* fn explained<T>(
        &mut self,
        result: Result<T, DeviceError<P::Error>>,
        command: &Bytes<'_>,
    ) -> Result<T, StreamError<P::Error>> {
        #[cfg(feature = "open")]
        if is_refused(&result) {
            if let (Ok(Some(field)), Err(DeviceError::Command(error))) =
                (self.rejects(&command.field())$($await)*, &result)
            {
                return Err(StreamError::Rejected { error: *error, field });
            }
        }
        Ok(result?)
    }

    /// Sends a command without a response; again if its error may have been caused by noise.
    $($async)* fn tell<C: Command>(&mut self, data: &[u8]) -> Result<(), DeviceError<P::Error>> {
        let command = Bytes::of(kind::<C>(), data);
        self.exchange(&command, ATTEMPTS)$($await)*.map(|_| ())
    }

    /// Sends a command with a response; again if its error may have been caused by noise.
    $($async)* fn ask<C>(&mut self, data: &[u8]) -> Result<C::Response, DeviceError<P::Error>>
    where
        C: Command,
        C::Response: Field,
    {
        let command = Bytes { check: Some(check::<C::Response>), ..Bytes::of(kind::<C>(), data) };
        Ok(response::<C>(self.exchange(&command, ATTEMPTS)$($await)*?)?)
    }
}
    };
}

functions! { [impl<P: Port, const N: usize, const Q: usize> Device<P, N, Q>] [] [] }

#[cfg(feature = "embedded-io-async-07")]
functions! {
    [
        impl<P, S, F, const N: usize, const Q: usize> crate::device::AsyncDevice<P, S, N, Q>
        where
            P: embedded_io_async::Read + embedded_io_async::Write,
            S: FnMut(u32) -> F,
            F: core::future::Future<Output = ()>,
    ]
    [async]
    [.await]
}
