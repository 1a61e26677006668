//! First steps with a device: finding its baud rate, and starting its data at rates in Hz.
//!
//! `open` finds a device on a port of the computer, [`Device::connect`] on any port, and
//! [`Device::stream`] starts its data.

use core::fmt;

use crate::device::{Device, DeviceError, Port};
use crate::error::EncodeError;
#[allow(unused_imports)]
use crate::types;
use crate::{Command, CommandError, Field};

/// The baud rates of all known devices: the usual one first, the others in descending order.
#[rustfmt::skip]
pub const BAUD_RATES: [u32; 10] = [
    115200, 3000000, 921600, 460800, 230400, 57600, 38400, 19200, 9600, 4800,
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
/// - `serial:/dev/ttyACM0`, `serial:COM3:460800`: a serial port. The [`BAUD_RATES`] are tried until
///   the device answers, which takes about a third of a second each; a given rate is tried first.
/// - `tcp:192.168.1.20:9000`: a host and a port.
/// - `file:log.bin`: a recorded log, whose packets [`Device::next_packet`] returns.
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
    let all = if has_rate { &BAUD_RATES[..] } else { &[] };
    let mut found = Err(CommandError::TimedOut.into());
    if let Some(rate) = given {
        found = device.connect(&[rate]);
    }
    if is_timeout(&found) {
        found = device.connect(all);
    }
    match found {
        Err(DeviceError::Command(CommandError::TimedOut)) => {
            Err(DeviceError::Port(nobody(place, all)))
        }
        found => found.map(|_| device),
    }
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
    sets: &'static [u8],
    name: &'static str,
}

impl Rate {
    /// A field at a rate in Hz; 0: the highest rate of the device.
    #[must_use]
    pub const fn of<T: Field>(hz: f32) -> Self {
        Self { descriptor: T::DESCRIPTOR, hz, sets: T::SETS, name: T::NAME }
    }

    /// The same for a field of unknown type, by its descriptor.
    #[must_use]
    pub const fn of_descriptor(descriptor: u8, hz: f32) -> Self {
        Self { descriptor, hz, sets: &[], name: "" }
    }

    /// Returns the decimation whose rate is nearest to `hz`.
    fn decimation(&self, base: u16) -> u16 {
        let (base, wanted) = (f32::from(base), self.hz);
        if wanted == 0.0 || wanted >= base || wanted.is_nan() {
            return 1;
        }
        if wanted * f32::from(u16::MAX) <= base {
            return u16::MAX;
        }
        let below = (base / wanted) as u16;
        let above = below.saturating_add(1);
        let (faster, slower) = (base / f32::from(below), base / f32::from(above));
        if faster - wanted <= wanted - slower {
            below
        } else {
            above
        }
    }
}

/// The reason why a stream was not started.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StreamError<E> {
    /// A command failed.
    Device(DeviceError<E>),
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
            Self::NoSuchRate { descriptor, name, wanted, nearest, base } => {
                if name.is_empty() {
                    write!(f, "field 0x{descriptor:02X}")?;
                } else {
                    f.write_str(name)?;
                }
                write!(f, " at {wanted} Hz: not a rate of the device; nearest: {nearest} Hz")?;
                write!(f, ", as it divides {base} Hz by whole numbers")
            }
        }
    }
}

#[cfg(any(feature = "core-error", feature = "std"))]
impl<E: fmt::Debug + fmt::Display> crate::error::Error for StreamError<E> {}

/// A command that changes the baud rate of a port of the device.
pub trait ChangesBaud: Command {
    /// The new rate, if the command writes one.
    fn new_baud(&self) -> Option<u32>;
}

impl ChangesBaud for crate::protocol::Write<crate::base::CommSpeed> {
    fn new_baud(&self) -> Option<u32> {
        self.baud
    }
}

impl ChangesBaud for crate::protocol::Write<crate::mip_3dm::UartBaudRate> {
    fn new_baud(&self) -> Option<u32> {
        self.baud
    }
}

#[cfg(feature = "open")]
fn is_timeout<T, E>(result: &Result<T, DeviceError<E>>) -> bool {
    matches!(result, Err(DeviceError::Command(CommandError::TimedOut)))
}

fn is_refused<T, E>(result: &Result<T, DeviceError<E>>) -> bool {
    matches!(result, Err(DeviceError::Command(CommandError::Refused(_))))
}

/// Repeats a command if its error may have been caused by noise.
fn repeated<T, E>(
    mut call: impl FnMut() -> Result<T, DeviceError<E>>,
) -> Result<T, DeviceError<E>> {
    let mut left = ATTEMPTS;
    loop {
        left = left.saturating_sub(1);
        match call() {
            Err(DeviceError::Command(
                CommandError::TimedOut
                | CommandError::MissingResponse
                | CommandError::Undecodable(_),
            )) if left > 0 => {}
            result => return result,
        }
    }
}

impl<P: Port, const N: usize, const Q: usize> Device<P, N, Q> {
    /// Finds the device: tries each of these baud rates, such as [`BAUD_RATES`], until a device
    /// answers a ping or sends data; then sets the device to idle. Data that arrived is discarded.
    ///
    /// Returns the rate; `None` if the port supports none of them ([`Port::set_baud`]), for example
    /// a TCP connection. Commands without a reply are repeated. A rate at which no device
    /// answers takes about a third of a second.
    ///
    /// # Errors
    ///
    /// The port fails, or no device answers ([`CommandError::TimedOut`]); the port then has the rate
    /// that was tried last.
    pub fn connect(&mut self, rates: &[u32]) -> Result<Option<u32>, DeviceError<P::Error>> {
        let ping = crate::base::Ping::new();
        let (mut found, mut tried) = (None, false);
        for rate in rates {
            if self.port_mut().set_baud(*rate).map_err(DeviceError::Port)? {
                tried = true;
                if self.is_heard(&ping, LISTEN)? {
                    found = Some(*rate);
                    break;
                }
            }
        }
        if tried && found.is_none() {
            return Err(CommandError::TimedOut.into());
        }
        repeated(|| self.request(&crate::base::SetIdle::new()))?;
        self.discard();
        Ok(found)
    }

    /// Starts the data of a descriptor set: reads its base rate, writes which fields are sent and
    /// how often, in this order, enables the stream, and ends the idle state. Returns the base rate
    /// in Hz, at which fields with a rate of 0 are sent. A base rate of 0 means that data is sent
    /// as it arrives.
    ///
    /// Fields that all sets share, such as time stamps, come first. If the device rejects the first
    /// command, the older commands for the set are used instead. Commands without a reply are
    /// repeated.
    ///
    /// # Errors
    ///
    /// [`StreamError::NoSuchRate`], before any setting is changed; [`StreamError::Device`] if a field
    /// does not occur in the set, there are too many, or a command fails.
    #[rustfmt::skip]
    #[allow(clippy::float_cmp)] // a rate that is nearly the same is another one
    pub fn stream(&mut self, set: u8, rates: &[Rate]) -> Result<u16, StreamError<P::Error>> {
        for rate in rates {
            if let Some(first) = rate.sets.first().filter(|_| !rate.sets.contains(&set)) {
                let error = EncodeError::set(rate.name, *first, set);
                return Err(DeviceError::Request(error.into()).into());
            }
        }
        let current = repeated(|| self.request(&crate::mip_3dm::GetBaseRate::new(set))).map(|x| x.rate);
        let older = is_refused(&current);
        let older_rate = match set {
            _ if !older => None,
            0x80 => Some(repeated(|| self.request(&crate::mip_3dm::GetImuBaseRate::new())).map(|x| x.rate)),
            0x81 => Some(repeated(|| self.request(&crate::mip_3dm::GetGnssBaseRate::new())).map(|x| x.rate)),
            0x82 => Some(repeated(|| self.request(&crate::mip_3dm::GetFilterBaseRate::new())).map(|x| x.rate)),
            _ => None,
        };
        // A device that rejects this command as well does not have the set.
        let base = older_rate.filter(|rate| !is_refused(rate)).unwrap_or(current)?;
        for rate in rates {
            let nearest = f32::from(base) / f32::from(rate.decimation(base));
            if base != 0 && rate.hz != 0.0 && rate.hz != nearest {
                let Rate { descriptor, hz: wanted, name, .. } = *rate;
                return Err(StreamError::NoSuchRate { descriptor, name, wanted, nearest, base });
            }
        }
        let fields = rates.iter().map(|rate| types::DescriptorRate::new(rate.descriptor, rate.decimation(base)));
        match set {
            0x80 if older => {
                let format = crate::mip_3dm::ImuMessageFormat::write(fields.collect::<crate::List<types::DescriptorRate, 83>>());
                repeated(|| self.request(&format))?;
                repeated(|| self.request(&crate::mip_3dm::DataStreamControl::write(1, true)))?;
            }
            0x81 if older => {
                let format = crate::mip_3dm::GnssMessageFormat::write(fields.collect::<crate::List<types::DescriptorRate, 83>>());
                repeated(|| self.request(&format))?;
                repeated(|| self.request(&crate::mip_3dm::DataStreamControl::write(2, true)))?;
            }
            0x82 if older => {
                let format = crate::mip_3dm::FilterMessageFormat::write(fields.collect::<crate::List<types::DescriptorRate, 83>>());
                repeated(|| self.request(&format))?;
                repeated(|| self.request(&crate::mip_3dm::DataStreamControl::write(3, true)))?;
            }
            _ => {
                let format = crate::mip_3dm::MessageFormat::write(set, fields.collect::<crate::List<types::DescriptorRate, 83>>());
                repeated(|| self.request(&format))?;
                repeated(|| self.request(&crate::mip_3dm::DataStreamControl::write(set, true)))?;
            }
        }
        repeated(|| self.request(&crate::base::Resume::new()))?;
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
    /// ([`CommandError::TimedOut`]).
    pub fn change_baud<C>(&mut self, command: &C) -> Result<u32, DeviceError<P::Error>>
    where
        C: ChangesBaud,
    {
        let (Some(new), Some(old)) = (command.new_baud(), self.port().baud()) else {
            return Err(DeviceError::NoBaudRate);
        };
        match self.request(command) {
            // The reply may have arrived at the new rate.
            Err(DeviceError::Command(CommandError::TimedOut)) => {}
            result => drop(result?),
        }
        self.pass(CHANGE)?;
        let ping = crate::base::Ping::new();
        for rate in [new, old] {
            if self.port_mut().set_baud(rate).map_err(DeviceError::Port)?
                && self.is_heard(&ping, LISTEN)?
            {
                return Ok(rate);
            }
        }
        Err(CommandError::TimedOut.into())
    }
}
