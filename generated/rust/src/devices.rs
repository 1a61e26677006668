//! The fields that each device supports.

use crate::protocol::{AckCode, DescriptorSet, FunctionSelector};

mod known;
mod lists;
mod rejected;

pub use known::*;
pub use rejected::{Known, Rejected, Rejection};

/// A device profile.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Profile {
    /// The name in the specification.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// A description.
    pub description: &'static str,
    /// Other names.
    pub also: &'static [&'static str],
    /// Its model number, if that is known.
    pub model_number: Option<u16>,
    /// The generation of devices that it belongs to, if that is known.
    pub generation: Option<u8>,
    /// The manual that describes it, if one is known.
    pub manual: Option<&'static str>,
    /// Statements on what is unknown about it. If there are any, it may support more than is
    /// listed.
    pub incomplete: &'static [&'static str],
    /// The commands and data fields that it supports, or is believed to support.
    pub fields: &'static [Supported],
    /// The commands and data fields that it is known not to support.
    pub refuses: &'static [Supported],
    /// The data sets of which it is known to support no field.
    pub absent_sets: &'static [AbsentSet],
    /// The firmware that some of these fields require.
    pub firmware: &'static [Firmware],
    /// Base rates of data sets.
    pub base_rates: &'static [BaseRate],
    /// Its ports.
    pub ports: &'static [ProfilePort],
    /// Its limits.
    pub limits: &'static [Limit],
    /// Parameters with another meaning than on other devices.
    pub variants: &'static [Variant],
    /// The acknowledge codes that it sends.
    pub ack_codes: &'static [AckCode],
}

/// Does a device support a command or a data field?
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Support {
    /// It does.
    Yes,
    /// An example, a program or a list of others names this very model.
    Likely,
    /// Its family or a nearly identical device has it.
    Assumed,
    /// It does not.
    No,
    /// No source mentions it, and the profile is incomplete.
    Unknown,
}

/// Why a device is believed to have some fields, or not to have them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Evidence {
    /// The answer.
    pub answer: Support,
    /// The reason for the answer.
    pub why: &'static str,
    /// What the device lacks: "has no magnetometer"; empty if no hardware is concerned.
    pub absence: &'static str,
}

/// A data set of which a device supports no field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct AbsentSet {
    /// The descriptor set.
    pub set: DescriptorSet,
    /// Why that is believed.
    pub evidence: &'static Evidence,
}

/// A field that a device supports, is believed to support, or does not support.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Supported {
    /// The descriptor set; 0xFF if it may be any data set.
    pub set: DescriptorSet,
    /// The field descriptor.
    pub descriptor: u8,
    /// The name in that set, `set.field`.
    pub name: &'static str,
    /// The function selectors that the device accepts; empty if the field has none.
    pub functions: &'static [FunctionSelector],
    /// Whether the device supports it, and why that is believed.
    pub evidence: &'static Evidence,
}

/// The firmware that a command or a data field requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Firmware {
    /// The descriptor set.
    pub set: DescriptorSet,
    /// The field descriptor.
    pub descriptor: u8,
    /// The versions that support it: `> 1.0.07` or `>= 1.0, < 1.1`.
    pub versions: &'static str,
}

/// The base rate of a data set.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BaseRate {
    /// The descriptor set.
    pub set: DescriptorSet,
    /// The rate in Hz, before decimation; 0 if data is sent as it arrives.
    pub hertz: f64,
}

/// A port of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct ProfilePort {
    /// Its title.
    pub name: &'static str,
    /// The number that commands use, if there is one.
    pub id: Option<u8>,
    /// The baud rates that it supports.
    pub baud_rates: &'static [u32],
    /// The protocols that it receives.
    pub receives: &'static [&'static str],
    /// The protocols that it sends.
    pub sends: &'static [&'static str],
}

/// A limit of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Limit {
    /// The name in the specification.
    pub name: &'static str,
    /// The number.
    pub value: f64,
    /// Its unit, if it has one.
    pub unit: Option<&'static str>,
    /// The limited quantity.
    pub description: &'static str,
    /// The firmware versions that it applies to, if not all: `>= 1.0.04`.
    pub firmware: Option<&'static str>,
}

/// A parameter with another meaning on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Variant {
    /// The parameter by its name in the specification, `set.field.parameter`.
    pub parameter: &'static str,
    /// The type that defines its values or bits on this device, if that differs.
    pub read_as: Option<&'static str>,
    /// The difference.
    pub difference: &'static str,
}

impl Profile {
    /// Returns the device with this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Self> {
        ALL.iter().copied().find(|device| device.id == id)
    }

    /// Returns the device with this id, title or other name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        let called = |d: &&Self| d.id == name || d.title == name || d.also.contains(&name);
        ALL.iter().copied().find(called)
    }

    /// Returns the device with this model number; `None` if it is unknown, for example because the
    /// device is newer than this crate.
    ///
    /// ```
    /// use mip_protocol::devices::{model_number, Profile};
    ///
    /// let number = model_number("6286-9960").unwrap(); // as in the device information
    /// println!("{:?}", Profile::by_model(number).map(|device| device.title));
    /// ```
    #[must_use]
    pub fn by_model(number: u16) -> Option<&'static Self> {
        ALL.iter().copied().find(|device| device.model_number == Some(number))
    }

    /// Returns whether the device supports a field in packets of this set. For a field that a
    /// complete profile does not list, this is [`Support::No`].
    ///
    /// A shared field belongs to every data set.
    ///
    /// ```
    /// use mip_protocol::devices::{Profile, Support};
    ///
    /// # if Profile::by_id("3dm-cv7-ar").is_none() { return }
    /// let device = Profile::by_id("3dm-cv7-ar").unwrap();
    /// assert_eq!(device.support(0x80.into(), 0x04), Support::Yes);
    /// assert_eq!(device.support(0x91.into(), 0x03), Support::No); // it has no GNSS receiver
    /// ```
    #[must_use]
    pub fn support(&self, set: DescriptorSet, descriptor: u8) -> Support {
        match self.evidence(set, descriptor) {
            Some(evidence) => evidence.answer,
            None if self.incomplete.is_empty() => Support::No,
            None => Support::Unknown,
        }
    }

    /// Returns the profile's entry for a field in packets of this set, with its evidence.
    #[must_use]
    pub fn field(&self, set: DescriptorSet, descriptor: u8) -> Option<&'static Supported> {
        let shared = if set.0 < 0x80 { set } else { DescriptorSet(0xFF) };
        self.stated(set, descriptor).or_else(|| self.stated(shared, descriptor))
    }

    fn stated(&self, set: DescriptorSet, descriptor: u8) -> Option<&'static Supported> {
        let mut stated = self.fields.iter().chain(self.refuses);
        stated.find(|f| (f.set, f.descriptor) == (set, descriptor))
    }

    /// Returns the reason to believe that the device supports a field in packets of this set, or
    /// does not; also of a set of which it supports no field.
    ///
    /// ```
    /// use mip_protocol::devices::Profile;
    ///
    /// # if Profile::find("3DM-CV7-AHRS").is_none() { return }
    /// let device = Profile::find("3DM-CV7-AHRS").unwrap();
    /// if let Some(evidence) = device.evidence(0x80.into(), 0x04) {
    ///     println!("{:?}: {}", evidence.answer, evidence.why);
    /// }
    /// ```
    #[must_use]
    pub fn evidence(&self, set: DescriptorSet, descriptor: u8) -> Option<&'static Evidence> {
        let field = self.stated(set, descriptor).map(|field| field.evidence);
        let absent = self.absent_sets.iter().find(|absent| absent.set == set);
        let of_set = field.or_else(|| absent.map(|absent| absent.evidence));
        of_set.or_else(|| self.field(set, descriptor).map(|field| field.evidence))
    }

    /// Does the device support this field, certainly or as is believed, in any set in which it occurs? For
    /// a single set, use [`Profile::support`].
    ///
    /// ```
    /// # #[cfg(feature = "sensor")] {
    /// use mip_protocol::devices::Profile;
    ///
    /// # if Profile::find("3DM-CV7-AHRS").is_none() { return }
    /// let device = Profile::find("3DM-CV7-AHRS").unwrap();
    /// assert!(device.has::<mip_protocol::sensor::ScaledAccel>());
    /// # }
    /// ```
    #[must_use]
    pub fn has<T: crate::Field>(&self) -> bool {
        let found = |set: &DescriptorSet| self.support(*set, T::DESCRIPTOR);
        T::SETS.iter().map(found).any(|x| !matches!(x, Support::No | Support::Unknown))
    }

    /// Returns the firmware versions that support a field; `None` if all do, or if that is unknown.
    #[must_use]
    pub fn firmware_of(&self, set: DescriptorSet, descriptor: u8) -> Option<&'static str> {
        let mut said = self.firmware.iter();
        said.find(|f| (f.set, f.descriptor) == (set, descriptor)).map(|f| f.versions)
    }

    /// Returns the base rate of a descriptor set in Hz; 0 if data is sent as it arrives.
    ///
    /// ```
    /// use mip_protocol::devices::Profile;
    ///
    /// # if Profile::find("3DM-CV7-AHRS").is_none() { return }
    /// let device = Profile::find("3DM-CV7-AHRS").unwrap();
    /// println!("{:?} Hz", device.base_rate(0x80.into()));
    /// ```
    #[must_use]
    pub fn base_rate(&self, set: DescriptorSet) -> Option<f64> {
        self.base_rates.iter().find(|rate| rate.set == set).map(|rate| rate.hertz)
    }

    /// Returns the limit with this name.
    ///
    /// ```
    /// use mip_protocol::devices::Profile;
    ///
    /// # if Profile::find("3DM-CV7-AHRS").is_none() { return }
    /// let device = Profile::find("3DM-CV7-AHRS").unwrap();
    /// println!("{:?}", device.limit("event_triggers"));
    /// ```
    #[must_use]
    pub fn limit(&self, name: &str) -> Option<f64> {
        self.limits.iter().find(|limit| limit.name == name).map(|limit| limit.value)
    }
}

/// Returns the number with which a model or serial number of the device information begins.
///
/// Spaces may precede it; a dot, dash, space, NUL or the end of the text must follow it.
///
/// ```
/// use mip_protocol::devices::model_number;
///
/// assert_eq!(model_number("  6254-4220      "), Some(6254));
/// assert_eq!(model_number("GX5-15"), None);
/// ```
#[must_use]
pub fn model_number(text: &str) -> Option<u16> {
    let text = text.trim_start_matches(' ');
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let (digits, rest) = (text.get(..end)?, text.get(end..)?);
    let ends = rest.is_empty() || rest.starts_with(['.', '-', ' ', '\0']);
    digits.parse().ok().filter(|number| ends && *number > 0)
}
