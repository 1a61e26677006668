//! The devices.

#[allow(unused_imports)] // a part of the specification needs fewer
use super::{BaseRate, Evidence, Firmware, Limit, Profile, ProfilePort, Support, Variant};
#[allow(unused_imports)]
use crate::protocol::AckCode;

/// All devices.
#[rustfmt::skip]
pub static ALL: &[&Profile] = &[
    &MODEL_A,
    &MODEL_B,
    &MODEL_C,
    &OLD_1,
    &OLD_2,
];

#[rustfmt::skip]
const MODEL_A_1: &Evidence =
    &Evidence { answer: Support::Yes, why: "Documented." };

/// Model A
///
/// Supports nearly everything.
///
/// Model number 4711. Manual: A guide to devices that do not exist, 1.
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
pub static MODEL_A: Profile = Profile {
    id: "model-a",
    title: "Model A",
    description: "Supports nearly everything.",
    also: &[],
    model_number: Some(4711),
    generation: None,
    manual: Some("guide"),
    incomplete: &[
    ],
    fields: supported! {
        0x01 0x01 "tools.ping" [] MODEL_A_1;
        0x01 0x02 "tools.settings" [WRITE READ SAVE LOAD DEFAULT APPLY] MODEL_A_1;
        0x01 0x03 "tools.set_time" [WRITE READ APPLY] MODEL_A_1;
        0x01 0x04 "tools.status" [] MODEL_A_1;
        0x01 0x05 "tools.bias" [WRITE READ SAVE LOAD DEFAULT] MODEL_A_1;
        0x01 0x06 "tools.capture_bias" [] MODEL_A_1;
        0x01 0x07 "tools.formats" [] MODEL_A_1;
        0x01 0x08 "tools.choice" [WRITE READ] MODEL_A_1;
        0x01 0x09 "tools.list" [WRITE READ SAVE] MODEL_A_1;
        0x01 0x0A "tools.inventory" [] MODEL_A_1;
        0x01 0x0B "tools.pin" [WRITE READ] MODEL_A_1;
        0x01 0x0D "tools.readings" [] MODEL_A_1;
        0x0C 0x10 "3d.default" [] MODEL_A_1;
        0x80 0x01 "measurements.accel" [] MODEL_A_1;
        0x80 0x02 "measurements.numbers" [] MODEL_A_1;
        0x80 0x03 "measurements.strings" [] MODEL_A_1;
        0x80 0x04 "measurements.health" [] MODEL_A_1;
        0x80 0x05 "measurements.arrays" [] MODEL_A_1;
        0x80 0x06 "measurements.growing" [] MODEL_A_1;
        0x80 0x08 "measurements.cloud" [] MODEL_A_1;
        0x80 0x0A "measurements.breeze" [] MODEL_A_1;
        0x81 0x01 "more.accel" [] MODEL_A_1;
        0x81 0x03 "more.strings" [] MODEL_A_1;
        0x81 0x07 "more.own" [] MODEL_A_1;
        0xFF 0xD3 "shared.timestamp" [] MODEL_A_1;
    },
    refuses: supported! {
    },
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x81, hertz: 500.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x11),
            baud_rates: &[9600, 115200],
            receives: &["MIP", "NMEA"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "USB",
            id: None,
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "segments",
            value: 12.0,
            unit: None,
            description: "In a format.",
            firmware: None,
        },
        Limit {
            name: "range",
            value: 2.5,
            unit: Some("g"),
            description: "Of the sensor.",
            firmware: None,
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

#[rustfmt::skip]
const MODEL_B_1: &Evidence =
    &Evidence { answer: Support::Yes, why: "Documented." };

/// Model B
///
/// Small, and reads the acknowledge code in its own way.
///
/// Manual: A leaflet about one of them, 2.
#[rustfmt::skip]
pub static MODEL_B: Profile = Profile {
    id: "model-b",
    title: "Model B",
    description: "Small, and reads the acknowledge code in its own way.",
    also: &[],
    model_number: None,
    generation: None,
    manual: Some("leaflet"),
    incomplete: &[
    ],
    fields: supported! {
        0x01 0x01 "tools.ping" [] MODEL_B_1;
        0x01 0x02 "tools.settings" [WRITE READ] MODEL_B_1;
        0x01 0x04 "tools.status" [] MODEL_B_1;
        0x80 0x01 "measurements.accel" [] MODEL_B_1;
    },
    refuses: supported! {
    },
    firmware: &[
    ],
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
            difference: "unit m, m, s; frame ned; valid flags x: valid_flags.hot, y: valid_flags.ready, z: valid_flags.hot. Turned by the device",
        },
    ],
    ack_codes: &[
        AckCode::OK,
        AckCode::UNKNOWN_COMMAND,
    ],
};

#[rustfmt::skip]
const MODEL_C_1: &Evidence =
    &Evidence { answer: Support::Yes, why: "Documented." };
#[rustfmt::skip]
const MODEL_C_2: &Evidence =
    &Evidence { answer: Support::Yes, why: "Listed by the device (firmware 1.0.07; 2026-11-23)." };
#[rustfmt::skip]
const MODEL_C_3: &Evidence =
    &Evidence { answer: Support::Probable, why: "Transcribed from the manual by others (Kit of names: Names). It names tools.hello." };
#[rustfmt::skip]
const MODEL_C_4: &Evidence =
    &Evidence { answer: Support::No, why: "Rejected by the device (firmware 1.2)." };

/// Model C
///
/// Like the model A, with a radio and without a choice.
///
/// Also called Model See and c. Generation 3. Model number 4713. Same as the [Model
/// A](crate::devices::MODEL_A), except as stated here. No manual is known. Uncertain: Whether it
/// has a model number of its own.
///
/// Source: sheet: Radio.
#[rustfmt::skip]
pub static MODEL_C: Profile = Profile {
    id: "model-c",
    title: "Model C",
    description: "Like the model A, with a radio and without a choice.",
    also: &["Model See", "c"],
    model_number: Some(4713),
    generation: Some(3),
    manual: None,
    incomplete: &[
    ],
    fields: supported! {
        0x01 0x01 "tools.ping" [] MODEL_C_1;
        0x01 0x02 "tools.settings" [WRITE READ SAVE] MODEL_C_1;
        0x01 0x03 "tools.set_time" [WRITE READ APPLY] MODEL_C_1;
        0x01 0x04 "tools.status" [] MODEL_C_1;
        0x01 0x05 "tools.bias" [WRITE READ SAVE LOAD DEFAULT] MODEL_C_1;
        0x01 0x06 "tools.capture_bias" [] MODEL_C_1;
        0x01 0x07 "tools.formats" [] MODEL_C_1;
        0x01 0x09 "tools.list" [WRITE READ SAVE] MODEL_C_1;
        0x01 0x0A "tools.inventory" [] MODEL_C_1;
        0x01 0x0B "tools.pin" [WRITE READ] MODEL_C_1;
        0x01 0x0C "tools.hello" [] MODEL_C_3;
        0x01 0x0D "tools.readings" [] MODEL_C_1;
        0x01 0x0E "tools.poll" [] MODEL_C_2;
        0x80 0x01 "measurements.accel" [] MODEL_C_1;
        0x80 0x02 "measurements.numbers" [] MODEL_C_1;
        0x80 0x03 "measurements.strings" [] MODEL_C_1;
        0x80 0x04 "measurements.health" [] MODEL_C_1;
        0x80 0x05 "measurements.arrays" [] MODEL_C_1;
        0x80 0x06 "measurements.growing" [] MODEL_C_1;
        0x80 0x07 "measurements.radio" [] MODEL_C_1;
        0x80 0x08 "measurements.cloud" [] MODEL_C_1;
        0x80 0x0A "measurements.breeze" [] MODEL_C_1;
        0x81 0x01 "more.accel" [] MODEL_C_1;
        0x81 0x07 "more.own" [] MODEL_C_1;
        0x92 0x01 "copy.accel" [] MODEL_C_3;
        0xFF 0xD3 "shared.timestamp" [] MODEL_C_1;
    },
    refuses: supported! {
        0x01 0x08 "tools.choice" [WRITE READ] MODEL_C_4;
    },
    firmware: &[
        Firmware {
            set: 0x01,
            descriptor: 0x06,
            versions: ">= 1.0, < 1.1",
        },
        Firmware {
            set: 0x81,
            descriptor: 0x01,
            versions: "> 1.0.07",
        },
        Firmware {
            set: 0x81,
            descriptor: 0x07,
            versions: "> 1.0.07",
        },
    ],
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x81, hertz: 250.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x12),
            baud_rates: &[9600],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "CAN",
            id: None,
            baud_rates: &[],
            receives: &[],
            sends: &[],
        },
    ],
    limits: &[
        Limit {
            name: "segments",
            value: 6.0,
            unit: None,
            description: "In a format.",
            firmware: Some("< 2.0"),
        },
    ],
    variants: &[
        Variant {
            parameter: "tools.settings.mode",
            read_as: None,
            difference: "only default and fast; not deprecated",
        },
        Variant {
            parameter: "tools.status.selector",
            read_as: None,
            difference: "always 2. Inferred: It has one layout",
        },
        Variant {
            parameter: "tools.status_short.flags",
            read_as: Some("model_a_faults"),
            difference: "values of model_a_faults",
        },
        Variant {
            parameter: "tools.status_long.flags",
            read_as: None,
            difference: "the values are unknown",
        },
        Variant {
            parameter: "measurements.accel.scaled_accel",
            read_as: None,
            difference: "no flag marks it as valid",
        },
        Variant {
            parameter: "measurements.accel.valid_flags",
            read_as: None,
            difference: "only ready and level",
        },
        Variant {
            parameter: "measurements.radio.noise",
            read_as: None,
            difference: "valid if connected is true; deprecated",
        },
    ],
    ack_codes: &[
        AckCode::OK,
        AckCode::UNKNOWN_COMMAND,
        AckCode::INVALID_PARAMETER,
    ],
};

#[rustfmt::skip]
const OLD_1_1: &Evidence =
    &Evidence { answer: Support::Yes, why: "Documented." };
#[rustfmt::skip]
const OLD_1_2: &Evidence =
    &Evidence { answer: Support::Probable, why: "Supported by devices of the same generation, Model A and Model B." };

/// Old 1
///
/// Known by its name and number.
///
/// Also called First. Generation 1. Model number 4001. No manual is known. This profile is
/// incomplete: No manual is known; see [`tools::Ping`](crate::tools::Ping).
///
/// Source: sheet: Names.
#[rustfmt::skip]
pub static OLD_1: Profile = Profile {
    id: "old-1",
    title: "Old 1",
    description: "Known by its name and number.",
    also: &["First"],
    model_number: Some(4001),
    generation: Some(1),
    manual: None,
    incomplete: &[
        "No manual is known; see `tools.ping`.",
    ],
    fields: supported! {
        0x01 0x01 "tools.ping" [] OLD_1_1;
        0x80 0x02 "measurements.numbers" [] OLD_1_2;
    },
    refuses: supported! {
    },
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const OLD_2_1: &Evidence =
    &Evidence { answer: Support::Probable, why: "Supported by devices of the same generation, Model A and Model B." };

/// Old 2
///
/// Known by its name and number.
///
/// Generation 1. Model number 4002. No manual is known. This profile is incomplete: Nothing is
/// known of its data.
///
/// Source: sheet: Names.
#[rustfmt::skip]
pub static OLD_2: Profile = Profile {
    id: "old-2",
    title: "Old 2",
    description: "Known by its name and number.",
    also: &[],
    model_number: Some(4002),
    generation: Some(1),
    manual: None,
    incomplete: &[
        "Nothing is known of its data.",
    ],
    fields: supported! {
        0x01 0x01 "tools.ping" [] OLD_2_1;
        0x80 0x02 "measurements.numbers" [] OLD_2_1;
    },
    refuses: supported! {
    },
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
    ],
    ack_codes: &[
    ],
};
