//! The devices.

use super::{BaseRate, Device, Limit, Port, Variant};
use crate::protocol::AckCode;

/// All devices.
#[rustfmt::skip]
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
#[rustfmt::skip]
pub static MODEL_A: Device = Device {
    id: "model-a",
    title: "Model A",
    description: "Supports nearly everything.",
    model_number: Some(4711),
    fields: supported! {
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
        0x0C 0x10 "3d.default" [];
        0x80 0x01 "measurements.accel" [];
        0x80 0x02 "measurements.numbers" [];
        0x80 0x03 "measurements.strings" [];
        0x80 0x04 "measurements.health" [];
        0x80 0x05 "measurements.arrays" [];
        0x80 0x06 "measurements.growing" [];
        0x80 0x08 "measurements.cloud" [];
        0x81 0x01 "more.accel" [];
        0x81 0x03 "more.strings" [];
        0x81 0x07 "more.own" [];
        0xFF 0xD3 "shared.timestamp" [];
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x81, hertz: 500.0 },
    ],
    ports: &[
        Port {
            name: "Main",
            id: Some(0x11),
            baud_rates: &[9600, 115200],
            protocols: &["MIP", "NMEA"],
        },
        Port {
            name: "USB",
            id: None,
            baud_rates: &[],
            protocols: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "segments",
            value: 12.0,
            unit: None,
            description: "In a format.",
        },
        Limit {
            name: "range",
            value: 2.5,
            unit: Some("g"),
            description: "Of the sensor.",
        },
    ],
    variants: &[
        Variant {
            parameter: "tools.status_short.flags",
            read_as: Some("model_a_faults"),
            difference: "values of model_a_faults",
        },
        Variant {
            parameter: "tools.status_long.flags",
            read_as: Some("model_a_faults"),
            difference: "values of model_a_faults",
        },
    ],
    ack_codes: &[
        AckCode::OK,
        AckCode::UNKNOWN_COMMAND,
        AckCode::INVALID_PARAMETER,
    ],
};

/// Model B
///
/// Small, and reads the acknowledge code in its own way.
#[rustfmt::skip]
pub static MODEL_B: Device = Device {
    id: "model-b",
    title: "Model B",
    description: "Small, and reads the acknowledge code in its own way.",
    model_number: None,
    fields: supported! {
        0x01 0x01 "tools.ping" [];
        0x01 0x02 "tools.settings" [WRITE READ];
        0x01 0x04 "tools.status" [];
        0x80 0x01 "measurements.accel" [];
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 0.0 },
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "protocol.acknowledge.code",
            read_as: Some("mode"),
            difference: "values of mode",
        },
        Variant {
            parameter: "tools.status_short.flags",
            read_as: Some("model_b_faults"),
            difference: "values of model_b_faults",
        },
        Variant {
            parameter: "tools.status_long.flags",
            read_as: Some("model_b_faults"),
            difference: "values of model_b_faults",
        },
        Variant {
            parameter: "measurements.accel.scaled_accel",
            read_as: None,
            difference: "unit m, m, s; frame ned. Turned by the device",
        },
    ],
    ack_codes: &[
        AckCode::OK,
        AckCode::UNKNOWN_COMMAND,
    ],
};
