//! What each device supports.

use crate::protocol::{AckCode, FunctionSelector};

mod known;

pub use known::*;

/// What is known about a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Device {
    /// The name in the specification.
    pub id: &'static str,
    /// The name that people know.
    pub title: &'static str,
    /// What it is.
    pub description: &'static str,
    /// The number of the model, if it has one.
    pub model_number: Option<u16>,
    /// Its commands and data fields.
    pub fields: &'static [Supported],
    /// How often data can be sent.
    pub base_rates: &'static [BaseRate],
    /// Where it can be connected.
    pub ports: &'static [Port],
    /// Numbers that bound what it can do.
    pub limits: &'static [Limit],
    /// Parameters that are something else than on other devices.
    pub variants: &'static [Variant],
    /// The codes that its acknowledges carry.
    pub ack_codes: &'static [AckCode],
}

/// A field that a device supports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Supported {
    /// The descriptor set.
    pub set: u8,
    /// The field descriptor.
    pub descriptor: u8,
    /// The name in the specification.
    pub name: &'static str,
    /// The function selectors that the device takes; none if the field has no such.
    pub functions: &'static [FunctionSelector],
}

/// How often the data of a descriptor set can be sent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseRate {
    /// The descriptor set.
    pub set: u8,
    /// Rate in Hz, which a decimation divides; 0 if data are sent as they come.
    pub hertz: f64,
}

/// A place where a device can be connected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Port {
    /// The name that people know.
    pub name: &'static str,
    /// The number that commands use, if there is one.
    pub id: Option<u8>,
    /// Baud rates that can be set.
    pub baud_rates: &'static [u32],
    /// What it speaks.
    pub protocols: &'static [&'static str],
}

/// A number that bounds what a device can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The name in the specification.
    pub name: &'static str,
    /// The number.
    pub value: f64,
    /// Its unit, if it has one.
    pub unit: Option<&'static str>,
    /// What it bounds.
    pub description: &'static str,
}

/// A parameter that is something else on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The parameter by its name in the specification, `set.field.parameter`.
    pub parameter: &'static str,
    /// The type that names its values or bits, where it is another.
    pub read_as: Option<&'static str>,
    /// What is different.
    pub difference: &'static str,
}

impl Device {
    /// The device of this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Self> {
        ALL.iter().copied().find(|device| device.id == id)
    }

    /// The entry of a field, if the device supports it in packets of this set.
    ///
    /// Shared data count in every data set.
    #[must_use]
    pub fn supports(&self, set: u8, descriptor: u8) -> Option<&'static Supported> {
        let matches = |f: &&Supported| f.set == set || (f.set == 0xFF && set >= 0x80);
        self.fields.iter().find(|f| f.descriptor == descriptor && matches(f))
    }

    /// Does it support this field?
    #[must_use]
    pub fn has<T: crate::Field>(&self) -> bool {
        self.fields.iter().any(|f| T::in_set(f.set) && f.descriptor == T::DESCRIPTOR)
    }

    /// The base rate of a descriptor set in Hz; 0 if data are sent as they come.
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
