//! The time of packets by clock, valid or not, and its conversion to UTC.
//!
//! ```
//! use mip_protocol::time::Utc;
//!
//! let time = Utc::from_unix_nanoseconds(1_709_251_199_500_000_000);
//! assert_eq!(time.to_string(), "2024-02-29T23:59:59.500000000Z");
//! assert_eq!(format!("{time:.3}"), "2024-02-29T23:59:59.500Z");
//! assert_eq!(Utc::from_unix_nanoseconds(-1).to_string(), "1969-12-31T23:59:59.999999999Z");
//! ```

use core::fmt;

#[cfg(feature = "devices")]
use crate::devices::Profile;
use crate::packet::Packet;

mod clocks;

pub use clocks::Clock;

/// Nanoseconds.
const SECOND: i64 = 1_000_000_000;
const DAY: i64 = 86_400_000_000_000;
const WEEK: i64 = 604_800_000_000_000;
/// Each part of a timestamp must be below this many nanoseconds, so that the sum of two fits.
const MOST: i64 = 4_000_000_000_000_000_000;

/// A field that contains the time of its packet.
struct Source {
    sets: &'static [u8],
    descriptor: u8,
    /// The smallest number of bytes of its data.
    size: usize,
    clock: Clock,
    /// The clock of a time that is not valid as a date.
    undated: Option<Clock>,
    parts: &'static [Part],
    /// Those with the fewest flags first, the usual one last.
    readings: &'static [Reading],
}

/// A number in a timestamp, and the nanoseconds of its unit.
struct Part {
    place: Place,
    is_float: bool,
    is_signed: bool,
    scale: i64,
    /// Does it count in a time without a date?
    undated: bool,
}

/// Where the data of a field contains a number.
struct Place {
    at: usize,
    size: usize,
    /// Arrays before it: offset and size of the counter, and the size of an element.
    after: &'static [(usize, usize, usize)],
}

/// How some devices mark a timestamp as valid.
struct Reading {
    devices: &'static [&'static str],
    flags: &'static [Flag],
    /// The bits that others have in addition.
    fewer: u64,
}

struct Flag {
    place: Place,
    mask: u64,
}

/// Reads the times of packets. It combines the flags of all packets that it has seen, to recognize
/// how a device that is not known marks its timestamps as valid.
///
/// [`Packet::time`] does the same for a single packet.
///
/// ```
/// use mip_protocol::time::{Clock, Times};
/// use mip_protocol::packets;
///
/// let mut times = Times::new();
/// for packet in packets(b"\x75\x65\x01\x02\x02\x01\xE0\xC6") {
///     for clock in Clock::ALL {
///         assert_eq!(times.read(&packet, *clock), None);
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Times {
    device: Option<&'static str>,
    seen: [u64; clocks::SOURCES.len()],
}

impl Times {
    /// Reads times of a device that is not known.
    #[must_use]
    pub const fn new() -> Self {
        Self { device: None, seen: [0; clocks::SOURCES.len()] }
    }

    /// Reads times of this device.
    #[cfg(feature = "devices")]
    #[must_use]
    pub const fn of(device: &Profile) -> Self {
        Self { device: Some(device.id), seen: [0; clocks::SOURCES.len()] }
    }

    /// Returns the time of the first clock, in the order of [`Clock::ALL`], that a packet has.
    pub fn first(&mut self, packet: &Packet<'_>) -> Option<Time> {
        let mut clocks = Clock::ALL.iter();
        clocks.find_map(|clock| {
            let nanoseconds = self.read(packet, *clock)?;
            Some(Time { clock: *clock, nanoseconds })
        })
    }

    /// Returns the time of a clock in nanoseconds; see [`Packet::time`].
    pub fn read(&mut self, packet: &Packet<'_>, clock: Clock) -> Option<i64> {
        for (source, seen) in clocks::SOURCES.iter().zip(&mut self.seen) {
            if source.clock != clock && source.undated != Some(clock) {
                continue;
            }
            let Some(found) = source.find(packet) else { continue };
            *seen |= source.flags(found);
            let date = source.date(found, source.reading(self.device, *seen));
            if source.clock == clock {
                return date;
            }
            if date.is_none() {
                return source.of_week(found);
            }
        }
        None
    }
}

impl Packet<'_> {
    /// Returns the time of a clock in the packet, in nanoseconds since the clock's epoch, or since
    /// its start if it has none; `None` if the packet does not contain it, or if it is not valid.
    ///
    /// For the date of a clock with an epoch, see [`Utc`]. A time of week that is not valid as a
    /// date is the time of a clock without one. If several fields contain the time of a clock, the
    /// one with the lowest descriptor counts. How flags are read if that depends on the device is
    /// recognized from the flags that are set; to combine them for all packets of a log or to name
    /// the device, use [`Times`].
    ///
    /// ```
    /// use mip_protocol::{packets, Clock};
    ///
    /// for packet in packets(b"\x75\x65\x01\x02\x02\x01\xE0\xC6") {
    ///     assert_eq!(Clock::ALL.iter().find_map(|clock| packet.time(*clock)), None);
    /// }
    /// ```
    #[must_use]
    pub fn time(&self, clock: Clock) -> Option<i64> {
        Times::new().read(self, clock)
    }
}

impl Source {
    /// Returns the data of the first such field of a packet that is long enough.
    fn find<'a>(&self, packet: &Packet<'a>) -> Option<&'a [u8]> {
        let mut fields = packet.fields();
        let set = fields.set().0;
        if !(self.sets.contains(&set) || (self.sets.contains(&0xFF) && set >= 0x80)) {
            return None;
        }
        while let Some(field) = fields.sound() {
            if field.descriptor == self.descriptor && field.data.len() >= self.size {
                return Some(field.data);
            }
        }
        None
    }

    /// Returns the flags that select a reading.
    fn flags(&self, data: &[u8]) -> u64 {
        let mut flags = self.readings.iter().flat_map(|reading| reading.flags);
        flags.next().map_or(0, |flag| flag.bits(data))
    }

    fn reading(&self, device: Option<&str>, seen: u64) -> &'static Reading {
        let Some(usual) = self.readings.last() else { return &Reading::NONE };
        let mut others = self.readings.iter();
        let found = match device {
            Some(device) => others.find(|reading| reading.devices.contains(&device)),
            None => others.find(|reading| reading.fewer != 0 && seen & reading.fewer == 0),
        };
        found.unwrap_or(usual)
    }

    /// Returns a valid time; `None` if it is none, or if its week is 0.
    fn date(&self, data: &[u8], reading: &Reading) -> Option<i64> {
        let (time, of_week) = (self.sum(data, false)?, self.of_week(data)?);
        (reading.is_valid(data) && (time > of_week || !self.has_weeks())).then_some(time)
    }

    /// Returns a time without its weeks; `None` if it is in no week.
    fn of_week(&self, data: &[u8]) -> Option<i64> {
        self.sum(data, true).filter(|time| !self.has_weeks() || (0..=WEEK).contains(time))
    }

    fn has_weeks(&self) -> bool {
        self.parts.iter().any(|part| !part.undated)
    }

    /// Adds the parts of a time; `None` if one is not a number, or too large.
    fn sum(&self, data: &[u8], undated: bool) -> Option<i64> {
        let mut parts = self.parts.iter().filter(|part| part.undated || !undated);
        parts.try_fold(0_i64, |sum, part| sum.checked_add(part.nanoseconds(data)?))
    }
}

impl Part {
    fn nanoseconds(&self, data: &[u8]) -> Option<i64> {
        let bits = self.place.bits(data)?;
        let time = if self.is_float {
            let is_double = self.place.size == 8;
            let single = f32::from_bits(bits as u32);
            let number = if is_double { f64::from_bits(bits) } else { f64::from(single) };
            rounded(number * self.scale as f64)
        } else if self.is_signed {
            let unused = 64_usize.saturating_sub(self.place.size.saturating_mul(8)) as u32;
            let number = (bits.wrapping_shl(unused) as i64).wrapping_shr(unused);
            number.checked_mul(self.scale)
        } else {
            i64::try_from(bits).ok()?.checked_mul(self.scale)
        };
        time.filter(|time| time.unsigned_abs() < MOST.unsigned_abs())
    }
}

impl Reading {
    /// Of a timestamp that is always valid.
    const NONE: Self = Self { devices: &[], flags: &[], fewer: 0 };

    fn is_valid(&self, data: &[u8]) -> bool {
        self.flags.iter().all(|flag| crate::bits::are_set(flag.bits(data), flag.mask))
    }
}

impl Flag {
    fn bits(&self, data: &[u8]) -> u64 {
        self.place.bits(data).unwrap_or_default()
    }
}

impl Place {
    /// Returns the number there, without its sign; `None` if the data ends before it.
    fn bits(&self, data: &[u8]) -> Option<u64> {
        let mut at = self.at;
        for (counter, size, element) in self.after {
            let count = number(data, *counter, *size)? as usize;
            at = at.checked_add(count.checked_mul(*element)?)?;
        }
        number(data, at, self.size)
    }
}

fn number(data: &[u8], at: usize, size: usize) -> Option<u64> {
    let bytes = data.get(at..)?.get(..size)?;
    Some(bytes.iter().fold(0, |number, byte| number.wrapping_shl(8) | u64::from(*byte)))
}

/// Rounds to the nearest integer, halves to the even one; `None` if it does not fit.
fn rounded(number: f64) -> Option<i64> {
    if !(-(MOST as f64) < number && number < MOST as f64) {
        return None;
    }
    let whole = number as i64;
    let rest = number - whole as f64;
    let is_odd = whole & 1 == 1;
    let up = rest > 0.5 || (is_odd && rest >= 0.5);
    let down = rest < -0.5 || (is_odd && rest <= -0.5);
    Some(whole.wrapping_add(up.into()).wrapping_sub(down.into()))
}

/// The time of a packet by one of its clocks.
///
/// It is written as [`Utc`], or as seconds if its clock has no epoch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Time {
    /// The clock.
    pub clock: Clock,
    /// Nanoseconds since the clock's epoch, or since its start if it has none.
    pub nanoseconds: i64,
}

impl Time {
    /// Converts it to UTC; `None` if the clock has no epoch.
    ///
    /// ```
    /// use mip_protocol::{Clock, Time};
    ///
    /// for clock in Clock::ALL {
    ///     let time = Time { clock: *clock, nanoseconds: 1_500_000_000 };
    ///     println!("{time} by {}: {:?}", clock.name(), time.utc());
    ///     assert_eq!(time.seconds(), 1.5);
    /// }
    /// ```
    #[must_use]
    pub fn utc(self) -> Option<Utc> {
        Utc::from_clock(self.clock, self.nanoseconds)
    }

    /// Returns the seconds since the clock's epoch, or since its start.
    #[must_use]
    pub fn seconds(self) -> f64 {
        self.nanoseconds as f64 / SECOND as f64
    }
}

impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.utc() {
            Some(utc) => utc.fmt(f),
            None => self.seconds().fmt(f),
        }
    }
}

/// A time in UTC, in nanoseconds since 1970. A leap second becomes the second after it.
///
/// It is written as in ISO 8601, with nine digits after the point or as many as the precision says;
/// with `serde`, as the number of nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Utc(i64);

impl Utc {
    /// Creates it from nanoseconds since 1970.
    #[must_use]
    pub const fn from_unix_nanoseconds(nanoseconds: i64) -> Self {
        Self(nanoseconds)
    }

    /// Returns the nanoseconds since 1970.
    #[must_use]
    pub const fn unix_nanoseconds(self) -> i64 {
        self.0
    }

    /// Converts the time of a clock, in nanoseconds; `None` if the clock has no epoch.
    #[must_use]
    pub fn from_clock(clock: Clock, nanoseconds: i64) -> Option<Self> {
        let without_leaps = nanoseconds.saturating_add(clock.epoch()?.saturating_mul(SECOND));
        let mut shift = 0;
        for (begin, ahead) in clocks::LEAP_SECONDS {
            if without_leaps >= begin.saturating_add(ahead).saturating_mul(SECOND) {
                shift = ahead;
            }
        }
        Some(Self(without_leaps.saturating_sub(shift.saturating_mul(SECOND))))
    }

    /// Returns year, month and day.
    ///
    /// ```
    /// let time = mip_protocol::Utc::from_unix_nanoseconds(951_782_400_000_000_000);
    /// assert_eq!((time.date(), time.time_of_day()), ((2000, 2, 29), (0, 0, 0, 0)));
    /// ```
    #[must_use]
    pub fn date(self) -> (i32, u8, u8) {
        // Years begin in March, so that the leap day is the last one; an era has 400 years.
        let days = self.0.div_euclid(DAY).wrapping_add(719_468);
        let (era, day) = (days.div_euclid(146_097), days.rem_euclid(146_097));
        let leaps = (day / 1460).wrapping_sub(day / 36_524).wrapping_add(day / 146_096);
        let year = day.wrapping_sub(leaps) / 365;
        let before = year.wrapping_mul(365).wrapping_add(year / 4).wrapping_sub(year / 100);
        let day = day.wrapping_sub(before);
        let month = day.wrapping_mul(5).wrapping_add(2) / 153;
        let first = month.wrapping_mul(153).wrapping_add(2) / 5;
        let day = day.wrapping_sub(first).wrapping_add(1);
        let is_late = month >= 10;
        let month = if is_late { month.wrapping_sub(9) } else { month.wrapping_add(3) };
        let year = era.wrapping_mul(400).wrapping_add(year).wrapping_add(is_late.into());
        (year as i32, month as u8, day as u8)
    }

    /// Returns hour, minute, second and nanosecond.
    #[must_use]
    pub const fn time_of_day(self) -> (u8, u8, u8, u32) {
        let time = self.0.rem_euclid(DAY);
        let (seconds, nanoseconds) = (time / SECOND, time % SECOND);
        let (hour, minute) = (seconds / 3600, seconds / 60 % 60);
        (hour as u8, minute as u8, (seconds % 60) as u8, nanoseconds as u32)
    }
}

impl fmt::Display for Utc {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (year, month, day) = self.date();
        let (hour, minute, second, mut fraction) = self.time_of_day();
        write!(f, "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}")?;
        let digits = f.precision().unwrap_or(9).min(9);
        for _ in digits..9 {
            fraction /= 10;
        }
        if digits > 0 {
            write!(f, ".{fraction:0digits$}")?;
        }
        f.write_str("Z")
    }
}
