//! The fields that each device supports.

use crate::protocol::{AckCode, FunctionSelector};

mod known;

pub use known::*;

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
    /// The number of the model, if it is known.
    pub model_number: Option<u16>,
    /// The generation of devices that it belongs to, if that is known.
    pub generation: Option<u8>,
    /// The manual that describes it, if one is known.
    pub manual: Option<&'static str>,
    /// Statements on what is unknown about it. If there are any, it may have more than is listed.
    pub incomplete: &'static [&'static str],
    /// The commands and data fields that it certainly or probably has.
    pub fields: &'static [Supported],
    /// The commands and data fields that it is known not to have.
    pub refuses: &'static [Supported],
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

/// Does a device have a command or a data field?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// It does.
    Yes,
    /// It probably does.
    Probable,
    /// It does not.
    No,
    /// No source mentions it, and the profile is incomplete.
    Unknown,
}

/// Why a device is believed to have some fields, or not to have them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Evidence {
    /// The statement about them.
    pub answer: Support,
    /// Why, in words.
    pub why: &'static str,
}

/// A field that a device certainly or probably has, or does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Supported {
    /// The descriptor set; 0xFF if it may be any data set.
    pub set: u8,
    /// The field descriptor.
    pub descriptor: u8,
    /// The name in that set, `set.field`.
    pub name: &'static str,
    /// The function selectors that the device accepts; empty if the field has none.
    pub functions: &'static [FunctionSelector],
    /// The certainty of the statement, and its sources.
    pub evidence: &'static Evidence,
}

/// The firmware that a command or a data field requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Firmware {
    /// The descriptor set.
    pub set: u8,
    /// The field descriptor.
    pub descriptor: u8,
    /// The versions that have it: `> 1.0.07` or `>= 1.0, < 1.1`.
    pub versions: &'static str,
}

/// The base rate of a data set.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BaseRate {
    /// The descriptor set.
    pub set: u8,
    /// The rate in Hz, which a decimation divides; 0 if data is sent as it arrives.
    pub hertz: f64,
}

/// A port of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// The firmware versions that have it, if not all have: `>= 1.0.04`.
    pub firmware: Option<&'static str>,
}

/// A parameter with another meaning on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Variant {
    /// The parameter by its name in the specification, `set.field.parameter`.
    pub parameter: &'static str,
    /// The type that names its values or bits, if that differs.
    pub read_as: Option<&'static str>,
    /// The difference.
    pub difference: &'static str,
}

impl Profile {
    /// The device with this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Self> {
        ALL.iter().copied().find(|device| device.id == id)
    }

    /// The device with this id, title or other name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        let called = |d: &&Self| d.id == name || d.title == name || d.also.contains(&name);
        ALL.iter().copied().find(called)
    }

    /// The device of this model number; `None` if it is unknown, for example that of a newer
    /// device.
    #[must_use]
    pub fn by_model(number: u16) -> Option<&'static Self> {
        ALL.iter().copied().find(|device| device.model_number == Some(number))
    }

    /// Does the device have a field in packets of this set? If the profile is complete, this is
    /// [`Support::No`] for fields that it does not list.
    ///
    /// Shared fields are supported in every data set.
    #[must_use]
    pub fn support(&self, set: u8, descriptor: u8) -> Support {
        match self.field(set, descriptor) {
            Some(field) => field.evidence.answer,
            None if self.incomplete.is_empty() => Support::No,
            None => Support::Unknown,
        }
    }

    /// The entry of the profile for a field in packets of this set; its evidence states how certain
    /// it is, and why.
    #[must_use]
    pub fn field(&self, set: u8, descriptor: u8) -> Option<&'static Supported> {
        let matches = |f: &&Supported| f.set == set || (f.set == 0xFF && set >= 0x80);
        let mut said = self.fields.iter().chain(self.refuses);
        said.find(|f| f.descriptor == descriptor && matches(f))
    }

    /// Does it certainly or probably have this field, in one of the sets in which the field occurs?
    /// For a single set, use [`Profile::support`].
    #[must_use]
    pub fn has<T: crate::Field>(&self) -> bool {
        let found = |set: &u8| self.support(*set, T::DESCRIPTOR);
        T::SETS.iter().map(found).any(|x| matches!(x, Support::Yes | Support::Probable))
    }

    /// The firmware versions that have a field; `None` if all have it, or if it is not known.
    #[must_use]
    pub fn firmware_of(&self, set: u8, descriptor: u8) -> Option<&'static str> {
        let mut said = self.firmware.iter();
        said.find(|f| (f.set, f.descriptor) == (set, descriptor)).map(|f| f.versions)
    }

    /// The base rate of a descriptor set in Hz; 0 if data is sent as it arrives.
    #[must_use]
    pub fn base_rate(&self, set: u8) -> Option<f64> {
        self.base_rates.iter().find(|rate| rate.set == set).map(|rate| rate.hertz)
    }

    /// A limit by its name.
    #[must_use]
    pub fn limit(&self, name: &str) -> Option<f64> {
        self.limits.iter().find(|limit| limit.name == name).map(|limit| limit.value)
    }
}

/// The model number in the device information: its model and serial numbers begin with it.
///
/// Spaces may precede it, and a dot, a dash, a space, a NUL or the end of the text follows it.
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
