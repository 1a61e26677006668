//! What each device supports.

use crate::macros::device_fields;
use crate::types::{AckCode, FunctionSelector};

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
    /// Values that it reads in its own way.
    pub readings: &'static [Reading],
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

/// A value that a device reads in its own way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// A parameter (`set.field.parameter`) or a type, by its name in the specification.
    pub of: &'static str,
    /// The type that it is read as.
    pub read_as: &'static str,
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

/// All devices.
pub static ALL: &[&Device] = &[&MODEL_A, &MODEL_B];

/// Model A
///
/// Supports nearly everything.
///
/// # Pins
///
/// What each pin can do.
///
/// | Pin | Use |
/// | --- | --- |
/// | 1 | pulse |
/// | 2 | serial |
pub static MODEL_A: Device = Device {
    id: "model-a",
    title: "Model A",
    description: "Supports nearly everything.",
    model_number: Some(4711),
    fields: device_fields! {
        0x01 0x01 "tools.ping" [];
        0x01 0x02 "tools.settings" [WRITE READ SAVE LOAD DEFAULT APPLY];
        0x01 0x03 "tools.set_time" [WRITE READ APPLY];
        0x01 0x04 "tools.status" [];
        0x01 0x05 "tools.bias" [WRITE READ SAVE LOAD DEFAULT];
        0x01 0x06 "tools.capture_bias" [];
        0x01 0x07 "tools.formats" [];
        0x01 0x08 "tools.choice" [WRITE READ];
        0x01 0x09 "tools.list" [WRITE READ SAVE];
        0x01 0x0A "tools.inventory" [];
        0x01 0x0B "tools.pin" [WRITE READ];
        0x80 0x01 "measurements.accel" [];
        0x80 0x02 "measurements.numbers" [];
        0x80 0x03 "measurements.strings" [];
        0x80 0x04 "measurements.health" [];
        0x80 0x05 "measurements.arrays" [];
        0x80 0x06 "measurements.growing" [];
        0x80 0x07 "measurements.cloud" [];
        0x81 0x01 "more.accel" [];
        0x81 0x03 "more.strings" [];
        0x81 0x07 "more.own" [];
        0xFF 0xD3 "shared.timestamp" [];
        0x0C 0x10 "3d.default" [];
    },
    base_rates: &[BaseRate { set: 0x80, hertz: 1000.0 }, BaseRate { set: 0x81, hertz: 500.0 }],
    ports: &[
        Port {
            name: "Main",
            id: Some(0x11),
            baud_rates: &[9600, 115200],
            protocols: &["MIP", "NMEA"],
        },
        Port { name: "USB", id: None, baud_rates: &[], protocols: &["MIP"] },
    ],
    limits: &[
        Limit { name: "segments", value: 12.0, unit: None, description: "In a format." },
        Limit { name: "range", value: 2.5, unit: Some("g"), description: "Of the sensor." },
    ],
    readings: &[
        Reading { of: "tools.status_short.flags", read_as: "model_a_faults" },
        Reading { of: "tools.status_long.flags", read_as: "model_a_faults" },
    ],
    ack_codes: &[AckCode::OK, AckCode::UNKNOWN_COMMAND, AckCode::INVALID_PARAMETER],
};

/// Model B
///
/// Small, and reads the acknowledge code in its own way.
pub static MODEL_B: Device = Device {
    id: "model-b",
    title: "Model B",
    description: "Small, and reads the acknowledge code in its own way.",
    model_number: None,
    fields: device_fields! {
        0x01 0x01 "tools.ping" [];
        0x01 0x02 "tools.settings" [WRITE READ];
        0x01 0x04 "tools.status" [];
        0x80 0x01 "measurements.accel" [];
    },
    base_rates: &[BaseRate { set: 0x80, hertz: 0.0 }],
    ports: &[],
    limits: &[],
    readings: &[
        Reading { of: "tools.status_short.flags", read_as: "model_b_faults" },
        Reading { of: "tools.status_long.flags", read_as: "model_b_faults" },
        Reading { of: "ack_code", read_as: "mode" },
    ],
    ack_codes: &[AckCode::OK, AckCode::UNKNOWN_COMMAND],
};
