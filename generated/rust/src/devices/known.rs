//! The devices.

#[allow(unused_imports)] // a part of the specification needs fewer
use super::{BaseRate, Limit, Profile, ProfilePort, Variant};
#[allow(unused_imports)]
use crate::protocol::AckCode;

/// All devices.
#[rustfmt::skip]
pub static ALL: &[&Profile] = &[
    &CL5_10,
    &CL5_15,
    &CL5_25,
    &CV5_10,
    &CV5_15,
    &CV5_25,
    &CV7_AHRS,
    &CV7_AR,
    &CV7_GNSS_INS,
    &CV7_INS,
    &CX5_10,
    &CX5_15,
    &CX5_25,
    &CX5_35,
    &CX5_45,
    &DH3,
    &GQ4_45,
    &GQ7,
    &GV7_AHRS,
    &GV7_AR,
    &GV7_INS,
    &GX3_15,
    &GX3_25,
    &GX3_35,
    &GX3_45,
    &GX4_15,
    &GX4_25,
    &GX4_45,
    &GX5_10,
    &GX5_15,
    &GX5_25,
    &GX5_35,
    &GX5_45,
    &MV5_AR,
    &RQ1_45_LT,
    &RQ1_45_ST,
    &RTK,
];

/// 3DM-CL5-10
///
/// Inertial measurement unit.
///
/// Also called 3DM-CL5-IMU. Generation 5. Model number 6279. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number. Uncertain: MSCL does not
/// list it among the devices with streams or a device status.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static CL5_10: Profile = Profile {
    id: "3dm-cl5-10",
    title: "3DM-CL5-10",
    description: "Inertial measurement unit.",
    also: &["3DM-CL5-IMU"],
    model_number: Some(6279),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
    },
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

/// 3DM-CL5-15
///
/// Attitude reference.
///
/// Also called 3DM-CL5-AR. Generation 5. Model number 6280. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static CL5_15: Profile = Profile {
    id: "3dm-cl5-15",
    title: "3DM-CL5-15",
    description: "Attitude reference.",
    also: &["3DM-CL5-AR"],
    model_number: Some(6280),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL does not offer it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none and external",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CL5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-CL5-AHRS. Generation 5. Model number 6281. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static CL5_25: Profile = Profile {
    id: "3dm-cl5-25",
    title: "3DM-CL5-25",
    description: "Attitude and heading reference system.",
    also: &["3DM-CL5-AHRS"],
    model_number: Some(6281),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, auto_hard_iron and auto_soft_iron",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag and external",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CV5-10
///
/// Inertial measurement unit.
///
/// Also called 3DM-CV5-IMU. Generation 5. Model number 6259. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticImuResponse`](crate::mip_3dm::DeviceStatusDiagnosticImuResponse).
#[rustfmt::skip]
pub static CV5_10: Profile = Profile {
    id: "3dm-cv5-10",
    title: "3DM-CV5-10",
    description: "Inertial measurement unit.",
    also: &["3DM-CV5-IMU"],
    model_number: Some(6259),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL does not offer it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CV5-15
///
/// Attitude reference.
///
/// Also called 3DM-CV5-AR. Generation 5. Model number 6258. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static CV5_15: Profile = Profile {
    id: "3dm-cv5-15",
    title: "3DM-CV5-15",
    description: "Attitude reference.",
    also: &["3DM-CV5-AR"],
    model_number: Some(6258),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL does not offer it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none and external",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CV5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-CV5-AHRS. Generation 5. Model number 6257. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static CV5_25: Profile = Profile {
    id: "3dm-cv5-25",
    title: "3DM-CV5-25",
    description: "Attitude and heading reference system.",
    also: &["3DM-CV5-AHRS"],
    model_number: Some(6257),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, auto_hard_iron and auto_soft_iron",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag and external",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CV7-AHRS
///
/// Attitude and heading reference system.
///
/// Generation 7. Model number 6286. Manual: MicroStrain 3DM-CV7 Documentation (AHRS and AR),
/// online, known from some pages. This profile is incomplete: Only some pages of the manual are
/// known, so it has more commands and data. This profile is incomplete: The limits are those of
/// firmware 1.0.04 and later. Uncertain: MSCL offers only the values `none` and `manual` of
/// [`filter::MagneticDeclinationSource`](crate::filter::MagneticDeclinationSource); the manual also
/// has `wmm`.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter. Firmware up to
/// 1.0.07 has [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) instead, for sensor
/// data only.
///
/// | Set | Descriptor | Data |
/// | --- | --- | --- |
/// | 0x80 | 0x04 | Scaled accel |
/// | 0x80 | 0x05 | Scaled gyro |
/// | 0x80 | 0x06 | Scaled mag |
/// | 0x80 | 0x17 | Scaled pressure |
/// | 0x82 | 0x1C | Compensated acceleration |
/// | 0x82 | 0x0E | Compensated angular rate |
/// | 0x82 | 0x0D | Linear acceleration |
///
/// # GPIO pins
///
/// According to MSCL, each of the pins 1 to 4 can be a GPIO, receive or send pulses (PPS), or
/// timestamp events.
#[rustfmt::skip]
pub static CV7_AHRS: Profile = Profile {
    id: "3dm-cv7-ahrs",
    title: "3DM-CV7-AHRS",
    description: "Attitude and heading reference system.",
    also: &[],
    model_number: Some(6286),
    generation: Some(7),
    manual: Some("3dm-cv7"),
    incomplete: &[
        "Only some pages of the manual are known, so it has more commands and data.",
        "The limits are those of firmware 1.0.04 and later.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The manual says which filter command each firmware version has.");
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The manual says which filter command each firmware version has.");
        0x0D 0x01 "filter.reset" [] None;
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x31 "aiding.true_heading" [] None;
        0x13 0x32 "aiding.magnetic_field" [] None;
        0x80 0x04 "sensor.scaled_accel" [] None;
        0x82 0x06 "filter_data.gyro_bias" [] None;
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x82, hertz: 1000.0 },
        BaseRate { set: 0xA0, hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[115200, 230400, 460800, 921600],
            protocols: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "event_triggers",
            value: 12.0,
            unit: None,
            description: "Total number of triggers.",
        },
        Limit {
            name: "event_gpio_triggers",
            value: 4.0,
            unit: None,
            description: "GPIO triggers.",
        },
        Limit {
            name: "event_threshold_triggers",
            value: 8.0,
            unit: None,
            description: "Threshold triggers.",
        },
        Limit {
            name: "event_combination_triggers",
            value: 8.0,
            unit: None,
            description: "Combination triggers.",
        },
        Limit {
            name: "event_tick_rate",
            value: 1000.0,
            unit: Some("Hz"),
            description: "Rate of the event cycle.",
        },
    ],
    variants: &[
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only mag, external_heading and all",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CV7-AR
///
/// Attitude reference.
///
/// Generation 7. Model number 6287. Manual: MicroStrain 3DM-CV7 Documentation (AHRS and AR),
/// online, known from some pages. This profile is incomplete: Only some pages of the manual are
/// known, so it has more commands and data. This profile is incomplete: The limits are those of
/// firmware 1.0.04 and later. Uncertain: MSCL offers only the values `none` and `manual` of
/// [`filter::MagneticDeclinationSource`](crate::filter::MagneticDeclinationSource); the manual also
/// has `wmm`.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter. Firmware up to
/// 1.0.07 has [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) instead, for sensor
/// data only.
///
/// | Set | Descriptor | Data |
/// | --- | --- | --- |
/// | 0x80 | 0x04 | Scaled accel |
/// | 0x80 | 0x05 | Scaled gyro |
/// | 0x80 | 0x06 | Scaled mag |
/// | 0x80 | 0x17 | Scaled pressure |
/// | 0x82 | 0x1C | Compensated acceleration |
/// | 0x82 | 0x0E | Compensated angular rate |
/// | 0x82 | 0x0D | Linear acceleration |
///
/// # GPIO pins
///
/// According to MSCL, each of the pins 1 to 4 can be a GPIO, receive or send pulses (PPS), or
/// timestamp events.
#[rustfmt::skip]
pub static CV7_AR: Profile = Profile {
    id: "3dm-cv7-ar",
    title: "3DM-CV7-AR",
    description: "Attitude reference.",
    also: &[],
    model_number: Some(6287),
    generation: Some(7),
    manual: Some("3dm-cv7"),
    incomplete: &[
        "Only some pages of the manual are known, so it has more commands and data.",
        "The limits are those of firmware 1.0.04 and later.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The manual says which filter command each firmware version has.");
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The manual says which filter command each firmware version has.");
        0x0D 0x01 "filter.reset" [] None;
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x31 "aiding.true_heading" [] None;
        0x13 0x32 "aiding.magnetic_field" [] None;
        0x80 0x04 "sensor.scaled_accel" [] None;
        0x82 0x06 "filter_data.gyro_bias" [] None;
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x82, hertz: 1000.0 },
        BaseRate { set: 0xA0, hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[115200, 230400, 460800, 921600],
            protocols: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "event_triggers",
            value: 12.0,
            unit: None,
            description: "Total number of triggers.",
        },
        Limit {
            name: "event_gpio_triggers",
            value: 4.0,
            unit: None,
            description: "GPIO triggers.",
        },
        Limit {
            name: "event_threshold_triggers",
            value: 8.0,
            unit: None,
            description: "Threshold triggers.",
        },
        Limit {
            name: "event_combination_triggers",
            value: 8.0,
            unit: None,
            description: "Combination triggers.",
        },
        Limit {
            name: "event_tick_rate",
            value: 1000.0,
            unit: Some("Hz"),
            description: "Rate of the event cycle.",
        },
    ],
    variants: &[
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only external_heading and all",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CV7-GNSS/INS
///
/// Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure
/// sensor.
///
/// Generation 7. Model number 6292. Manual: MicroStrain 3DM-CV7-GNSS/INS Documentation, 8500-0099.
/// Uncertain: What the bug of NMEA input is that the manual warns of.
///
/// Source: mip-sdk-4: Device models.
///
/// # Ports
///
/// The main port is USB 1 while a host has it open (DTR set), else UART 1. MIP is always enabled on
/// it. The others must be enabled first. All ports stream the same data; replies to polls go to the
/// port that sent the poll.
///
/// | Port | Id | Pins |
/// | --- | --- | --- |
/// | Main | 0x01 | alias of USB 1 or UART 1 |
/// | UART 1 | 0x11 | connector pins 4 (RxD) and 5 (TxD) |
/// | UART 2 | 0x12 | GPIO 1 and GPIO 2 |
/// | UART 3 | 0x13 | GPIO 3 and GPIO 4 |
/// | USB 1 | 0x21 | connector pins 1 and 2 |
/// | USB 2 | 0x22 | connector pins 1 and 2 |
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter.
///
/// | Set | Descriptor | Data |
/// | --- | --- | --- |
/// | 0x80 | 0x04 | Scaled accel |
/// | 0x80 | 0x05 | Scaled gyro |
/// | 0x80 | 0x06 | Scaled mag |
/// | 0x80 | 0x17 | Scaled pressure |
/// | 0x82 | 0x1C | Compensated acceleration |
/// | 0x82 | 0x0E | Compensated angular rate |
/// | 0x82 | 0x0D | Linear acceleration |
///
/// # GPIO pins
///
/// Features of each pin; all are unused by default. The encoder feature is not available. The
/// manual marks PPS on pins 2 to 4 with an asterisk that it does not explain.
///
/// | Pin | Connector pin | Features | UART |
/// | --- | --- | --- | --- |
/// | 1 | 7 | GPIO, PPS, timestamp, UART | UART 2 |
/// | 2 | 9 | GPIO, PPS (restricted), timestamp, UART | UART 2 |
/// | 3 | 6 | GPIO, PPS (restricted), timestamp, UART | UART 3 |
/// | 4 | 10 | GPIO, PPS (restricted), timestamp, UART | UART 3 |
///
/// # GPIO behaviors and pin modes
///
/// Values of the behavior for each feature, and the pin modes that go with it. Two pins cannot have
/// the same direction of the same UART. PPS output from an internal receiver is always push-pull.
///
/// | Feature | Behavior | Pins | Pin modes |
/// | --- | --- | --- | --- |
/// | unused (0) | unused (0) | 1 to 4 | none |
/// | gpio (1) | input (1) | 1 to 4 | pull-up or pull-down |
/// | gpio (1) | output low (2) | 1 to 4 | open drain, optionally with pull-up |
/// | gpio (1) | output high (3) | 1 to 4 | open drain, optionally with pull-up |
/// | pps (2) | input (1) | 1; restricted on 2 to 4 | none |
/// | pps (2) | output (2) | 1; restricted on 2 to 4 | none |
/// | timestamp (4) | rising (1) | 1 to 4 | pull-up or pull-down |
/// | timestamp (4) | falling (2) | 1 to 4 | pull-up or pull-down |
/// | timestamp (4) | either (3) | 1 to 4 | pull-up or pull-down |
/// | uart (5) | UART 2 transmit (33) | 1 and 2 | open drain, optionally with pull-up |
/// | uart (5) | UART 2 receive (34) | 1 and 2 | pull-up or pull-down |
/// | uart (5) | UART 3 transmit (49) | 3 and 4 | open drain, optionally with pull-up |
/// | uart (5) | UART 3 receive (50) | 3 and 4 | pull-up or pull-down |
///
/// # NMEA output
///
/// Sentences of [`mip_3dm::NmeaMessageFormat`](crate::mip_3dm::NmeaMessageFormat). The talkers are
/// GN (GNSS), GP (GPS), GA (Galileo) and GL (GLONASS). A sentence is sent only while its data is
/// valid. A GNSS source has a base rate of 5 Hz, so its decimation must be 3 or more.
///
/// | Sentence | Contents | Talkers | Sources |
/// | --- | --- | --- | --- |
/// | GGA | GNSS fix | GN, GP, GA, GL | GNSS, filter |
/// | GLL | Latitude and longitude | GN, GP, GA, GL | GNSS, filter |
/// | GSV | Satellites in view | by constellation | GNSS |
/// | RMC | Recommended minimum | GN, GP, GA, GL | GNSS, filter |
/// | VTG | Course and speed over ground | GN, GP, GA, GL | GNSS, filter |
/// | HDT | True heading | GN, GP, GA, GL | GNSS, filter |
/// | ZDA | Time and date | GN, GP, GA, GL | GNSS |
/// | GST | Error statistics | GN, GP, GA, GL | GNSS, filter |
/// | PMSRA | Euler angles | proprietary | filter |
/// | PMSRR | Angular rate and acceleration | proprietary | sensor |
///
/// # NMEA input
///
/// Sentences accepted from an external receiver, with any talker: RMC, ZDA, HDT, GGA, VTG, GLL and
/// GSV. They are received on the main port, USB 2, or a UART on GPIO pins; while such a UART is
/// configured to receive, on that one only. An epoch is processed when a sentence with another time
/// arrives. The manual warns of a known bug of NMEA input; the errata sheet that it refers to is
/// not known.
///
/// # RTCM input
///
/// RTCM 3 messages that the GNSS receivers use.
///
/// | Contents | Messages |
/// | --- | --- |
/// | GPS observations | 1074, 1075, 1077 |
/// | GLONASS observations | 1084, 1085, 1087 |
/// | Galileo observations | 1094, 1095, 1097 |
/// | BeiDou observations | 1124, 1125, 1127 |
/// | Station coordinates | 1005, 1006 |
/// | Antenna description | 1007 |
/// | Antenna and receiver description | 1033 |
/// | GLONASS biases | 1230 |
///
/// # GNSS signals
///
/// Signals that can be enabled together by [`gnss::SignalConfig`](crate::gnss::SignalConfig). GPS
/// or Galileo must be enabled, and GPS L1 with BeiDou L1 alone is refused.
///
/// | Constellation | Choices |
/// | --- | --- |
/// | GPS | none, L1, L1 + L5 |
/// | GLONASS | none, L1 |
/// | Galileo | none, L1 + L5 |
/// | BeiDou | none, L1, L1 + L5 |
///
/// # Sensor ranges
///
/// Settings of [`mip_3dm::SensorRange`](crate::mip_3dm::SensorRange). The manual gives them for
/// related models, and its gyroscope column is cut off;
/// [`mip_3dm::GetCalibratedSensorRanges`](crate::mip_3dm::GetCalibratedSensorRanges) returns those
/// of the device.
///
/// | Sensor | Setting | Range |
/// | --- | --- | --- |
/// | Accelerometer | 2 | 4 g |
/// | Accelerometer | 3 | 8 g |
/// | Accelerometer | 4 | 16 g |
/// | Gyroscope | 2 | 250 deg/s |
///
/// # Pulse per second
///
/// Without a valid PPS the filter neither starts nor accepts measurements. A PPS output has a duty
/// cycle of 50 %; each second begins at its rising edge.
#[rustfmt::skip]
pub static CV7_GNSS_INS: Profile = Profile {
    id: "3dm-cv7-gnss-ins",
    title: "3DM-CV7-GNSS/INS",
    description: "Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure sensor.",
    also: &[],
    model_number: Some(6292),
    generation: Some(7),
    manual: Some("3dm-cv7-gnss-ins"),
    incomplete: &[
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] None;
        0x01 0x02 "base.set_idle" [] None;
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] None;
        0x01 0x05 "base.built_in_test" [] None;
        0x01 0x06 "base.resume" [] None;
        0x01 0x07 "base.get_extended_descriptors" [] None;
        0x01 0x08 "base.continuous_built_in_test" [] None;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] None;
        0x01 0x72 "base.gps_time_update" [WRITE] None;
        0x01 0x7E "base.soft_reset" [] None;
        0x0C 0x04 "3dm.poll_nmea_data" [] None;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0D "3dm.poll_data" [] None;
        0x0C 0x0E "3dm.get_base_rate" [] None;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x10 "3dm.factory_streaming" [] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x2A "3dm.get_event_support" [] None;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x2C "3dm.get_event_trigger_status" [] None;
        0x0C 0x2D "3dm.get_event_action_status" [] None;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] None;
        0x0C 0x43 "3dm.odometer_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] None;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x01 "filter.reset" [] None;
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x05 "filter.run" [] None;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x17 "filter.external_heading_update" [] None;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1F "filter.external_heading_update_with_time" [] None;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x54 "filter.multi_antenna_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x55 "filter.relative_position_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x56 "filter.reference_point_lever_arm" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x61 "filter.speed_lever_arm" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x63 "filter.wheeled_vehicle_constraint_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0E 0x01 "gnss.receiver_info" [] None;
        0x0E 0x02 "gnss.signal_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0E 0x20 "gnss.spartn_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x13 0x21 "aiding.ecef_position" [] None;
        0x13 0x22 "aiding.llh_position" [] None;
        0x13 0x23 "aiding.height_above_ellipsoid" [] None;
        0x13 0x28 "aiding.ecef_velocity" [] None;
        0x13 0x29 "aiding.ned_velocity" [] None;
        0x13 0x2A "aiding.body_frame_velocity" [] None;
        0x13 0x31 "aiding.true_heading" [] None;
        0x13 0x32 "aiding.magnetic_field" [] None;
        0x13 0x33 "aiding.pressure" [] None;
        0x7F 0x02 "system.interface_control" [WRITE READ SAVE LOAD DEFAULT] Some("The page on ports in the manual names it, but the list of commands does not.");
        0x80 0x04 "sensor.scaled_accel" [] None;
        0x80 0x05 "sensor.scaled_gyro" [] None;
        0x80 0x06 "sensor.scaled_mag" [] None;
        0x80 0x07 "sensor.delta_theta" [] None;
        0x80 0x08 "sensor.delta_velocity" [] None;
        0x80 0x09 "sensor.comp_orientation_matrix" [] None;
        0x80 0x0A "sensor.comp_quaternion" [] None;
        0x80 0x0C "sensor.comp_euler_angles" [] None;
        0x80 0x12 "sensor.gps_timestamp" [] None;
        0x80 0x14 "sensor.temperature_statistics" [] None;
        0x80 0x17 "sensor.scaled_pressure" [] None;
        0x80 0x18 "sensor.overrange_status" [] None;
        0x80 0x40 "sensor.odometer" [] None;
        0x82 0x01 "filter_data.llh_position" [] None;
        0x82 0x02 "filter_data.ned_velocity" [] None;
        0x82 0x03 "filter_data.attitude_quaternion" [] None;
        0x82 0x04 "filter_data.attitude_dcm" [] None;
        0x82 0x05 "filter_data.euler_angles" [] None;
        0x82 0x06 "filter_data.gyro_bias" [] None;
        0x82 0x07 "filter_data.accel_bias" [] None;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] None;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] None;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] None;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] None;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] None;
        0x82 0x0D "filter_data.linear_accel" [] None;
        0x82 0x0E "filter_data.comp_angular_rate" [] None;
        0x82 0x10 "filter_data.status" [] None;
        0x82 0x11 "filter_data.timestamp" [] None;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] None;
        0x82 0x13 "filter_data.gravity_vector" [] None;
        0x82 0x15 "filter_data.magnetic_model" [] None;
        0x82 0x1C "filter_data.comp_accel" [] None;
        0x82 0x21 "filter_data.pressure_altitude" [] None;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] None;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] None;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] None;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] None;
        0x82 0x40 "filter_data.ecef_position" [] None;
        0x82 0x41 "filter_data.ecef_velocity" [] None;
        0x82 0x42 "filter_data.ned_relative_position" [] None;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] None;
        0x82 0x46 "filter_data.aiding_measurement_summary" [] None;
        0x82 0x47 "filter_data.odometer_scale_factor_error" [] None;
        0x82 0x48 "filter_data.odometer_scale_factor_error_uncertainty" [] None;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] None;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] None;
        0x82 0x51 "filter_data.aiding_frame_config_error_uncertainty" [] None;
        0x91 0x03 "gnss_1.llh_position" [] None;
        0x91 0x04 "gnss_1.ecef_position" [] None;
        0x91 0x05 "gnss_1.ned_velocity" [] None;
        0x91 0x06 "gnss_1.ecef_velocity" [] None;
        0x91 0x07 "gnss_1.dop" [] None;
        0x91 0x08 "gnss_1.utc_time" [] None;
        0x91 0x09 "gnss_1.gps_time" [] None;
        0x91 0x0B "gnss_1.fix_info" [] None;
        0x91 0x0D "gnss_1.hardware_status" [] None;
        0x91 0x10 "gnss_1.clock_info_2" [] None;
        0x91 0x11 "gnss_1.gps_leap_seconds" [] None;
        0x91 0x12 "gnss_1.sbas_info" [] None;
        0x91 0x20 "gnss_1.satellite_status" [] None;
        0x91 0x22 "gnss_1.raw" [] None;
        0x91 0x61 "gnss_1.gps_ephemeris" [] None;
        0x91 0x62 "gnss_1.glonass_ephemeris" [] None;
        0x91 0x63 "gnss_1.galileo_ephemeris" [] None;
        0x91 0x64 "gnss_1.beidou_ephemeris" [] None;
        0x92 0x03 "gnss_2.llh_position" [] None;
        0x92 0x04 "gnss_2.ecef_position" [] None;
        0x92 0x05 "gnss_2.ned_velocity" [] None;
        0x92 0x06 "gnss_2.ecef_velocity" [] None;
        0x92 0x07 "gnss_2.dop" [] None;
        0x92 0x08 "gnss_2.utc_time" [] None;
        0x92 0x09 "gnss_2.gps_time" [] None;
        0x92 0x0B "gnss_2.fix_info" [] None;
        0x92 0x0D "gnss_2.hardware_status" [] None;
        0x92 0x10 "gnss_2.clock_info_2" [] None;
        0x92 0x11 "gnss_2.gps_leap_seconds" [] None;
        0x92 0x12 "gnss_2.sbas_info" [] None;
        0x92 0x20 "gnss_2.satellite_status" [] None;
        0x92 0x22 "gnss_2.raw" [] None;
        0x92 0x61 "gnss_2.gps_ephemeris" [] None;
        0x92 0x62 "gnss_2.glonass_ephemeris" [] None;
        0x92 0x63 "gnss_2.galileo_ephemeris" [] None;
        0x92 0x64 "gnss_2.beidou_ephemeris" [] None;
        0x93 0x30 "gnss_corrections.base_station_info" [] None;
        0x93 0x31 "gnss_corrections.rtk_corrections_status" [] None;
        0x94 0x03 "gnss_external.llh_position" [] None;
        0x94 0x05 "gnss_external.ned_velocity" [] None;
        0x94 0x08 "gnss_external.utc_time" [] None;
        0x94 0x0B "gnss_external.fix_info" [] None;
        0x94 0x20 "gnss_external.satellite_status" [] None;
        0xA0 0x01 "system_data.built_in_test" [] None;
        0xA0 0x02 "system_data.time_sync_status" [] None;
        0xA0 0x03 "system_data.gpio_state" [] None;
        0xFF 0xD0 "shared.event_source" [] None;
        0xFF 0xD3 "shared.gps_timestamp" [] None;
        0xFF 0xD4 "shared.delta_time" [] None;
        0xFF 0xD5 "shared.reference_timestamp" [] None;
        0xFF 0xD6 "shared.reference_time_delta" [] None;
        0xFF 0xD7 "shared.external_timestamp" [] None;
        0xFF 0xD8 "shared.external_time_delta" [] None;
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x82, hertz: 1000.0 },
        BaseRate { set: 0x91, hertz: 5.0 },
        BaseRate { set: 0x92, hertz: 5.0 },
        BaseRate { set: 0x93, hertz: 0.0 },
        BaseRate { set: 0x94, hertz: 0.0 },
        BaseRate { set: 0xA0, hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            protocols: &["MIP", "NMEA", "RTCM", "SPARTN"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[115200, 230400, 460800, 921600, 3000000],
            protocols: &["MIP", "NMEA", "RTCM", "SPARTN"],
        },
        ProfilePort {
            name: "UART 2",
            id: Some(0x12),
            baud_rates: &[4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600],
            protocols: &["MIP", "NMEA", "RTCM", "SPARTN"],
        },
        ProfilePort {
            name: "UART 3",
            id: Some(0x13),
            baud_rates: &[4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600],
            protocols: &["MIP", "NMEA", "RTCM", "SPARTN"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            protocols: &["MIP", "NMEA", "RTCM", "SPARTN"],
        },
        ProfilePort {
            name: "USB 2",
            id: Some(0x22),
            baud_rates: &[],
            protocols: &["MIP", "NMEA", "RTCM", "SPARTN"],
        },
    ],
    limits: &[
        Limit {
            name: "event_triggers",
            value: 12.0,
            unit: None,
            description: "Total number of triggers.",
        },
        Limit {
            name: "event_gpio_triggers",
            value: 4.0,
            unit: None,
            description: "GPIO triggers.",
        },
        Limit {
            name: "event_threshold_triggers",
            value: 8.0,
            unit: None,
            description: "Threshold triggers.",
        },
        Limit {
            name: "event_combination_triggers",
            value: 8.0,
            unit: None,
            description: "Combination triggers.",
        },
        Limit {
            name: "event_actions",
            value: 12.0,
            unit: None,
            description: "Total number of actions.",
        },
        Limit {
            name: "event_gpio_actions",
            value: 6.0,
            unit: None,
            description: "GPIO actions.",
        },
        Limit {
            name: "event_message_actions",
            value: 8.0,
            unit: None,
            description: "Message actions.",
        },
        Limit {
            name: "event_message_fields",
            value: 12.0,
            unit: None,
            description: "Fields in the packet of one message action.",
        },
        Limit {
            name: "event_tick_rate",
            value: 1000.0,
            unit: Some("Hz"),
            description: "Rate of the event cycle; always the base rate of the system data set.",
        },
        Limit {
            name: "gpio_pins",
            value: 4.0,
            unit: None,
            description: "User GPIO pins.",
        },
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Frames that the aiding frame configuration can define.",
        },
        Limit {
            name: "nmea_rate",
            value: 10.0,
            unit: Some("Hz"),
            description: "Highest rate of an NMEA sentence from the sensor or filter data set.",
        },
        Limit {
            name: "nmea_gnss_rate",
            value: 2.0,
            unit: Some("Hz"),
            description: "Highest rate of an NMEA sentence from a GNSS set.",
        },
        Limit {
            name: "mip_input_ports",
            value: 2.0,
            unit: None,
            description: "Ports besides the main port that may accept MIP.",
        },
        Limit {
            name: "nmea_input_ports",
            value: 1.0,
            unit: None,
            description: "Ports that may accept NMEA.",
        },
        Limit {
            name: "rtcm_input_ports",
            value: 1.0,
            unit: None,
            description: "Ports that may accept RTCM.",
        },
        Limit {
            name: "spartn_input_ports",
            value: 1.0,
            unit: None,
            description: "Ports that may accept SPARTN.",
        },
        Limit {
            name: "baud_rate_delay",
            value: 250.0,
            unit: Some("ms"),
            description: "Time to wait after a change of the baud rate.",
        },
        Limit {
            name: "time_update_window",
            value: 250.0,
            unit: Some("ms"),
            description: "Time after the rising edge of the PPS within which the GPS time update must arrive.",
        },
        Limit {
            name: "save_time",
            value: 1.0,
            unit: Some("s"),
            description: "Time that saving all settings may take.",
        },
        Limit {
            name: "motion_latency",
            value: 1.9,
            unit: Some("ms"),
            description: "Typical time from a motion to the message that reports it, not including transmission.",
        },
        Limit {
            name: "timestamp_repeatability",
            value: 1.0,
            unit: Some("us"),
            description: "Upper bound of the typical variation of sensor timestamps due to internal processing.",
        },
        Limit {
            name: "gpio_timestamp_accuracy",
            value: 1.0,
            unit: Some("us"),
            description: "Upper bound of the error of GPIO timestamps; the error is far smaller.",
        },
        Limit {
            name: "antenna_offset_error",
            value: 0.5,
            unit: Some("m"),
            description: "Highest value of the maximum offset of the antenna lever arm calibration.",
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_continuous_built_in_test"),
            difference: "values of cv7_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "default receiver_1",
        },
        Variant {
            parameter: "3dm.imu_low_pass_filter.target_descriptor",
            read_as: None,
            difference: "Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read",
        },
        Variant {
            parameter: "filter.gnss_antenna_calibration_control.max_offset",
            read_as: None,
            difference: "range 0 to 0.5; default 0.1",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_continuous_built_in_test"),
            difference: "values of cv7_continuous_built_in_test",
        },
    ],
    ack_codes: &[
        AckCode::OK,
        AckCode::UNKNOWN_COMMAND,
        AckCode::BAD_CHECKSUM,
        AckCode::INVALID_PARAMETER,
        AckCode::COMMAND_FAILED,
        AckCode::COMMAND_TIMEOUT,
        AckCode::UNKNOWN_DESCRIPTOR_SET,
    ],
};

/// 3DM-CV7-INS
///
/// Inertial navigation system without a GNSS receiver of its own.
///
/// Generation 7. Model number 6291. Manual: MicroStrain 3DM-CV7-INS Documentation, online, known
/// from some pages. This profile is incomplete: Only some pages of the manual are known, so it has
/// more commands and data. This profile is incomplete: It has the data sets 0x80, 0x82, 0x94, 0x95,
/// 0xA0 and 0xFF. Uncertain: Only a test site of the vendor names the set 0x95. Uncertain: The base
/// rate of the set 0x94 is inferred from the 3DM-CV7-GNSS/INS.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static CV7_INS: Profile = Profile {
    id: "3dm-cv7-ins",
    title: "3DM-CV7-INS",
    description: "Inertial navigation system without a GNSS receiver of its own.",
    also: &[],
    model_number: Some(6291),
    generation: Some(7),
    manual: Some("3dm-cv7-ins"),
    incomplete: &[
        "Only some pages of the manual are known, so it has more commands and data.",
        "It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x94 0x03 "gnss_external.llh_position" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x04 "gnss_external.ecef_position" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x05 "gnss_external.ned_velocity" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x06 "gnss_external.ecef_velocity" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x07 "gnss_external.dop" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x08 "gnss_external.utc_time" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x0B "gnss_external.fix_info" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x10 "gnss_external.clock_info_2" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x11 "gnss_external.gps_leap_seconds" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x14 "gnss_external.rf_error_detection" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
        0x94 0x20 "gnss_external.satellite_status" [] Some("A test site of the vendor lists it for this device; the firmware is not known.");
    },
    base_rates: &[
        BaseRate { set: 0x94, hertz: 0.0 },
    ],
    ports: &[
    ],
    limits: &[
        Limit {
            name: "antenna_offset",
            value: 10.0,
            unit: Some("m"),
            description: "Greatest distance of the antenna from the device.",
        },
    ],
    variants: &[
    ],
    ack_codes: &[
    ],
};

/// 3DM-CX5-10
///
/// Inertial measurement unit.
///
/// Also called 3DM-CX5-IMU. Generation 5. Model number 6275. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticImuResponse`](crate::mip_3dm::DeviceStatusDiagnosticImuResponse).
#[rustfmt::skip]
pub static CX5_10: Profile = Profile {
    id: "3dm-cx5-10",
    title: "3DM-CX5-10",
    description: "Inertial measurement unit.",
    also: &["3DM-CX5-IMU"],
    model_number: Some(6275),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL does not offer it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CX5-15
///
/// Attitude reference.
///
/// Also called 3DM-CX5-AR. Generation 5. Model number 6274. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number. Uncertain: MSCL does not
/// list it among the devices for which it limits the choices of the filter.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static CX5_15: Profile = Profile {
    id: "3dm-cx5-15",
    title: "3DM-CX5-15",
    description: "Attitude reference.",
    also: &["3DM-CX5-AR"],
    model_number: Some(6274),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL does not offer it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CX5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-CX5-AHRS. Generation 5. Model number 6273. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number. Uncertain: MSCL does not
/// list it among the devices for which it limits the choices of the filter.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static CX5_25: Profile = Profile {
    id: "3dm-cx5-25",
    title: "3DM-CX5-25",
    description: "Attitude and heading reference system.",
    also: &["3DM-CX5-AHRS"],
    model_number: Some(6273),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CX5-35
///
/// Attitude and heading reference with GNSS.
///
/// Also called 3DM-CX5-GNSS/AHRS. Generation 5. Model number 6272. No manual is known. This profile
/// is incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static CX5_35: Profile = Profile {
    id: "3dm-cx5-35",
    title: "3DM-CX5-35",
    description: "Attitude and heading reference with GNSS.",
    also: &["3DM-CX5-GNSS/AHRS"],
    model_number: Some(6272),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-CX5-45
///
/// Inertial navigation system with GNSS.
///
/// Also called 3DM-CX5-GNSS/INS. Generation 5. Model number 6271. No manual is known. This profile
/// is incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static CX5_45: Profile = Profile {
    id: "3dm-cx5-45",
    title: "3DM-CX5-45",
    description: "Inertial navigation system with GNSS.",
    also: &["3DM-CX5-GNSS/INS"],
    model_number: Some(6271),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-DH3
///
/// Device of generation 3, known only by its name and its number.
///
/// Generation 3. Model number 6219. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static DH3: Profile = Profile {
    id: "3dm-dh3",
    title: "3DM-DH3",
    description: "Device of generation 3, known only by its name and its number.",
    also: &[],
    model_number: Some(6219),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GQ4-45
///
/// Tactical grade inertial navigation system with GNSS.
///
/// Generation 4. Model number 6250. Manual: LORD 3DM-GQ4-45 Data Communications Protocol, of
/// September 26, 2015, known from its table of contents. This profile is incomplete: The table of
/// contents of the manual is known up to the commands of the set `3dm`. The sets `filter` and
/// `system` follow. This profile is incomplete: It has the data sets 0x80, 0x81 and 0x82, none of
/// whose fields is known. Uncertain: It may accept raw RTCM by a command whose layout is not known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGq4_45Response`](crate::mip_3dm::DeviceStatusDiagnosticGq4_45Response).
#[rustfmt::skip]
pub static GQ4_45: Profile = Profile {
    id: "3dm-gq4-45",
    title: "3DM-GQ4-45",
    description: "Tactical grade inertial navigation system with GNSS.",
    also: &[],
    model_number: Some(6250),
    generation: Some(4),
    manual: Some("3dm-gq4-45"),
    incomplete: &[
        "The table of contents of the manual is known up to the commands of the set `3dm`. The sets `filter` and `system` follow.",
        "It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] None;
        0x01 0x02 "base.set_idle" [] None;
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] None;
        0x01 0x05 "base.built_in_test" [] None;
        0x01 0x06 "base.resume" [] None;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] None;
        0x01 0x7E "base.soft_reset" [] None;
        0x0C 0x01 "3dm.poll_imu_data" [] None;
        0x0C 0x02 "3dm.poll_gnss_data" [] None;
        0x0C 0x03 "3dm.poll_filter_data" [] None;
        0x0C 0x06 "3dm.get_imu_base_rate" [] None;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] None;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0B "3dm.get_filter_base_rate" [] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] None;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x64 "3dm.device_status" [] None;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are not known",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag, gnss_velocity and external",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GQ7-GNSS/INS
///
/// Inertial navigation system with two GNSS receivers.
///
/// Also called 3DM-GQ7. Generation 7. Model number 6284. Manual: MicroStrain 3DM-GQ7 Documentation,
/// online, known from some pages. This profile is incomplete: Only some pages of the manual are
/// known, so it has more commands and data. This profile is incomplete: The baud rates of the Aux
/// port are not known, nor all of its protocols. Uncertain: The values of
/// [`filter::MagneticDeclinationSource`](crate::filter::MagneticDeclinationSource) are those that
/// MSCL offers. Uncertain: According to MSCL, firmware from 1.0 to below 1.1 has only the values
/// `all_internal` and `external` of [`filter::GnssSource`](crate::filter::GnssSource).
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter. Firmware up to
/// 1.0.10 has [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) instead, for sensor
/// data only.
///
/// | Set | Descriptor | Data |
/// | --- | --- | --- |
/// | 0x80 | 0x04 | Scaled accel |
/// | 0x80 | 0x05 | Scaled gyro |
/// | 0x80 | 0x06 | Scaled mag |
/// | 0x80 | 0x17 | Scaled pressure |
/// | 0x82 | 0x1C | Compensated acceleration |
/// | 0x82 | 0x0E | Compensated angular rate |
/// | 0x82 | 0x0D | Linear acceleration |
///
/// # Firmware
///
/// The system data set 0xA0 and NMEA on the main port require firmware later than 1.0.10.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, encoder |
/// | 2 | GPIO, encoder |
/// | 3 | GPIO, PPS |
/// | 4 | GPIO |
///
/// # NMEA output
///
/// Sentences are GGA, GLL, GSV, RMC, VTG, HDT, ZDA, and the proprietary PMSRA and PMSRR.
#[rustfmt::skip]
pub static GQ7: Profile = Profile {
    id: "3dm-gq7",
    title: "3DM-GQ7-GNSS/INS",
    description: "Inertial navigation system with two GNSS receivers.",
    also: &["3DM-GQ7"],
    model_number: Some(6284),
    generation: Some(7),
    manual: Some("3dm-gq7"),
    incomplete: &[
        "Only some pages of the manual are known, so it has more commands and data.",
        "The baud rates of the Aux port are not known, nor all of its protocols.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x04 "3dm.poll_nmea_data" [] None;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The manual says which filter command each firmware version has.");
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The manual says which filter command each firmware version has.");
        0x0D 0x05 "filter.run" [] None;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x91 0x03 "gnss_1.llh_position" [] None;
        0x91 0x0B "gnss_1.fix_info" [] None;
        0x92 0x0D "gnss_2.hardware_status" [] None;
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x82, hertz: 1000.0 },
        BaseRate { set: 0x91, hertz: 2.0 },
        BaseRate { set: 0x92, hertz: 2.0 },
        BaseRate { set: 0x93, hertz: 0.0 },
        BaseRate { set: 0xA0, hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[115200, 230400, 460800, 921600],
            protocols: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "Aux",
            id: Some(0x02),
            baud_rates: &[],
            protocols: &["MIP"],
        },
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "filter.magnetic_declination_source.source",
            read_as: None,
            difference: "only wmm and manual",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GV7-AHRS
///
/// Attitude and heading reference system.
///
/// Generation 7. Model number 6288. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GV7_AHRS: Profile = Profile {
    id: "3dm-gv7-ahrs",
    title: "3DM-GV7-AHRS",
    description: "Attitude and heading reference system.",
    also: &[],
    model_number: Some(6288),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
    },
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

/// 3DM-GV7-AR
///
/// Attitude reference.
///
/// Generation 7. Model number 6289. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GV7_AR: Profile = Profile {
    id: "3dm-gv7-ar",
    title: "3DM-GV7-AR",
    description: "Attitude reference.",
    also: &[],
    model_number: Some(6289),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
    },
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

/// 3DM-GV7-INS
///
/// Inertial navigation system.
///
/// Generation 7. Model number 6290. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GV7_INS: Profile = Profile {
    id: "3dm-gv7-ins",
    title: "3DM-GV7-INS",
    description: "Inertial navigation system.",
    also: &[],
    model_number: Some(6290),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
    },
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

/// 3DM-GX3-15
///
/// Device of generation 3, known only by its name and its number.
///
/// Generation 3. Model number 6227. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GX3_15: Profile = Profile {
    id: "3dm-gx3-15",
    title: "3DM-GX3-15",
    description: "Device of generation 3, known only by its name and its number.",
    also: &[],
    model_number: Some(6227),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX3-25
///
/// Device of generation 3, known only by its name and its number.
///
/// Generation 3. Model number 6223. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GX3_25: Profile = Profile {
    id: "3dm-gx3-25",
    title: "3DM-GX3-25",
    description: "Device of generation 3, known only by its name and its number.",
    also: &[],
    model_number: Some(6223),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX3-35
///
/// Device of generation 3, known only by its name and its number.
///
/// Generation 3. Model number 6225. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features; mip-sdk-2014: Example of the
/// 3DM-GX3-35.
#[rustfmt::skip]
pub static GX3_35: Profile = Profile {
    id: "3dm-gx3-35",
    title: "3DM-GX3-35",
    description: "Device of generation 3, known only by its name and its number.",
    also: &[],
    model_number: Some(6225),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x34 "3dm.gps_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] Some("The SDK of 2014 has an example for this device.");
        0x0C 0x35 "3dm.imu_signal_conditioning" [WRITE READ SAVE LOAD DEFAULT] Some("The SDK of 2014 has an example for this device.");
        0x0C 0x36 "3dm.imu_timestamp" [WRITE READ] Some("The SDK of 2014 has an example for this device.");
        0x0C 0x60 "3dm.data_stream_format" [WRITE READ SAVE LOAD DEFAULT] Some("The SDK of 2014 has an example for this device.");
        0x0C 0x61 "3dm.device_power_state" [WRITE READ SAVE LOAD DEFAULT] Some("The SDK of 2014 has an example for this device.");
        0x0C 0x62 "3dm.gps_advanced_settings" [SAVE LOAD DEFAULT] Some("The SDK of 2014 has an example for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX3-45
///
/// Device of generation 3, known only by its name and its number.
///
/// Generation 3. Model number 6228. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features; mip-sdk-2014: Example of the
/// 3DM-GX3-45.
#[rustfmt::skip]
pub static GX3_45: Profile = Profile {
    id: "3dm-gx3-45",
    title: "3DM-GX3-45",
    description: "Device of generation 3, known only by its name and its number.",
    also: &[],
    model_number: Some(6228),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x04 "filter.set_initial_attitude_from_imu" [] Some("The SDK of 2014 has an example for this device.");
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.vehicle_dynamics_mode.mode",
            read_as: None,
            difference: "only portable, automotive and airborne",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag, gnss_velocity and external",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX4-15
///
/// Device of generation 4, known only by its name and its number.
///
/// Generation 4. Model number 6233. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticGx4Response`](crate::mip_3dm::DeviceStatusDiagnosticGx4Response).
#[rustfmt::skip]
pub static GX4_15: Profile = Profile {
    id: "3dm-gx4-15",
    title: "3DM-GX4-15",
    description: "Device of generation 4, known only by its name and its number.",
    also: &[],
    model_number: Some(6233),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX4-25
///
/// Device of generation 4, known only by its name and its number.
///
/// Generation 4. Model number 6234. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticGx4Response`](crate::mip_3dm::DeviceStatusDiagnosticGx4Response).
#[rustfmt::skip]
pub static GX4_25: Profile = Profile {
    id: "3dm-gx4-25",
    title: "3DM-GX4-25",
    description: "Device of generation 4, known only by its name and its number.",
    also: &[],
    model_number: Some(6234),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag and external",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX4-45
///
/// Device of generation 4, known only by its name and its number.
///
/// Generation 4. Model number 6236. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static GX4_45: Profile = Profile {
    id: "3dm-gx4-45",
    title: "3DM-GX4-45",
    description: "Device of generation 4, known only by its name and its number.",
    also: &[],
    model_number: Some(6236),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag, gnss_velocity and external",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX5-10
///
/// Inertial measurement unit.
///
/// Also called 3DM-GX5-IMU. Generation 5. Model number 6255. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticImuResponse`](crate::mip_3dm::DeviceStatusDiagnosticImuResponse).
#[rustfmt::skip]
pub static GX5_10: Profile = Profile {
    id: "3dm-gx5-10",
    title: "3DM-GX5-10",
    description: "Inertial measurement unit.",
    also: &["3DM-GX5-IMU"],
    model_number: Some(6255),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL does not offer it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX5-15
///
/// Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter.
///
/// Also called 3DM-GX5-AR. Generation 5. Model number 6254. Manual: LORD Sensing 3DM-GX5-15 Data
/// Communications Protocol, 8500-0067 rev. E.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Base rates
///
/// The manual gives both 1000 and 500 for each stream. Read the base rates from the device before
/// computing a decimation.
///
/// # Frame of the sensor data
///
/// [`filter::SensorToVehicleRotationEuler`](crate::filter::SensorToVehicleRotationEuler) rotates
/// scaled acceleration and angular rate, delta theta and delta velocity, as well as the outputs of
/// the estimation filter other than the gyroscope bias. Until it is set, they are in the sensor
/// frame. It does not rotate the outputs of the complementary filter.
///
/// # Low-pass filter
///
/// Data that [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) can select.
///
/// | Set | Descriptor | Data |
/// | --- | --- | --- |
/// | 0x80 | 0x04 | Scaled accel |
/// | 0x80 | 0x05 | Scaled gyro |
/// | 0x80 | 0x17 | Scaled pressure |
///
/// # UART
///
/// The default baud rate is 115200. There is no handshake; data that does not fit is dropped.
///
/// # Time synchronization
///
/// The pulse per second goes to pin 7 of the connector. Send
/// [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate) once per second. The filter timestamp and
/// the sensor timestamp follow it.
///
/// # Direct mode
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor.
/// Meanwhile, only that command and [`mip_3dm::DeviceStatus`](crate::mip_3dm::DeviceStatus) are
/// available.
#[rustfmt::skip]
pub static GX5_15: Profile = Profile {
    id: "3dm-gx5-15",
    title: "3DM-GX5-15",
    description: "Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter.",
    also: &["3DM-GX5-AR"],
    model_number: Some(6254),
    generation: Some(5),
    manual: Some("3dm-gx5-15"),
    incomplete: &[
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] None;
        0x01 0x02 "base.set_idle" [] None;
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] None;
        0x01 0x05 "base.built_in_test" [] None;
        0x01 0x06 "base.resume" [] None;
        0x01 0x07 "base.get_extended_descriptors" [] None;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] None;
        0x01 0x7E "base.soft_reset" [] None;
        0x0C 0x01 "3dm.poll_imu_data" [] None;
        0x0C 0x03 "3dm.poll_filter_data" [] None;
        0x0C 0x06 "3dm.get_imu_base_rate" [] None;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0B "3dm.get_filter_base_rate" [] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x64 "3dm.device_status" [] None;
        0x0D 0x01 "filter.reset" [] None;
        0x0D 0x02 "filter.set_initial_attitude" [] None;
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x17 "filter.external_heading_update" [] None;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1F "filter.external_heading_update_with_time" [] None;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x21 "filter.tare_orientation" [WRITE SAVE LOAD DEFAULT] None;
        0x0D 0x23 "filter.commanded_angular_zupt" [] None;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] None;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] None;
        0x80 0x04 "sensor.scaled_accel" [] None;
        0x80 0x05 "sensor.scaled_gyro" [] None;
        0x80 0x07 "sensor.delta_theta" [] None;
        0x80 0x08 "sensor.delta_velocity" [] None;
        0x80 0x09 "sensor.comp_orientation_matrix" [] None;
        0x80 0x0A "sensor.comp_quaternion" [] None;
        0x80 0x0C "sensor.comp_euler_angles" [] None;
        0x80 0x10 "sensor.north_vector" [] None;
        0x80 0x11 "sensor.up_vector" [] None;
        0x80 0x12 "sensor.gps_timestamp" [] None;
        0x80 0x17 "sensor.scaled_pressure" [] None;
        0x82 0x03 "filter_data.attitude_quaternion" [] None;
        0x82 0x04 "filter_data.attitude_dcm" [] None;
        0x82 0x05 "filter_data.euler_angles" [] None;
        0x82 0x06 "filter_data.gyro_bias" [] None;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] None;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] None;
        0x82 0x0D "filter_data.linear_accel" [] None;
        0x82 0x0E "filter_data.comp_angular_rate" [] None;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] None;
        0x82 0x10 "filter_data.status" [] None;
        0x82 0x11 "filter_data.timestamp" [] None;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] None;
        0x82 0x13 "filter_data.gravity_vector" [] None;
        0x82 0x14 "filter_data.heading_update_state" [] None;
        0x82 0x1C "filter_data.comp_accel" [] None;
        0x82 0x21 "filter_data.pressure_altitude" [] None;
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 1000.0 },
        BaseRate { set: 0x82, hertz: 500.0 },
    ],
    ports: &[
        ProfilePort {
            name: "UART 1",
            id: None,
            baud_rates: &[9600, 19200, 115200, 230400, 460800, 921600],
            protocols: &["MIP"],
        },
        ProfilePort {
            name: "USB",
            id: None,
            baud_rates: &[],
            protocols: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "low_pass_cutoff",
            value: 250.0,
            unit: Some("Hz"),
            description: "Highest cutoff of the low-pass filters.",
        },
        Limit {
            name: "external_heading_rate",
            value: 20.0,
            unit: Some("Hz"),
            description: "Highest rate of external heading updates.",
        },
        Limit {
            name: "zero_angular_rate_update_rate",
            value: 10.0,
            unit: Some("Hz"),
            description: "Highest rate of commanded zero angular rate updates.",
        },
        Limit {
            name: "baud_rate_delay",
            value: 250.0,
            unit: Some("ms"),
            description: "Time from the acknowledge of a new baud rate until commands are answered at that rate.",
        },
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only imu and filter",
        },
        Variant {
            parameter: "3dm.uart_baud_rate.baud",
            read_as: None,
            difference: "default 115200",
        },
        Variant {
            parameter: "3dm.imu_low_pass_filter.frequency",
            read_as: None,
            difference: "range at most 250",
        },
        Variant {
            parameter: "3dm.complementary_filter.pitch_roll_enable",
            read_as: None,
            difference: "default true",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "default true",
        },
        Variant {
            parameter: "3dm.device_status.model_number",
            read_as: None,
            difference: "always 6254",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only imu and filter",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none and external",
        },
        Variant {
            parameter: "filter.enable_measurements.control",
            read_as: None,
            difference: "only accel",
        },
        Variant {
            parameter: "sensor.comp_orientation_matrix.m",
            read_as: None,
            difference: "From the NED frame to the sensor frame",
        },
        Variant {
            parameter: "sensor.comp_quaternion.q",
            read_as: None,
            difference: "Between NED and the sensor frame",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only external",
        },
    ],
    ack_codes: &[
        AckCode::OK,
        AckCode::UNKNOWN_COMMAND,
        AckCode::BAD_CHECKSUM,
        AckCode::INVALID_PARAMETER,
        AckCode::COMMAND_FAILED,
        AckCode::COMMAND_TIMEOUT,
    ],
};

/// 3DM-GX5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-GX5-AHRS. Generation 5. Model number 6253. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticResponse`](crate::mip_3dm::DeviceStatusDiagnosticResponse).
#[rustfmt::skip]
pub static GX5_25: Profile = Profile {
    id: "3dm-gx5-25",
    title: "3DM-GX5-25",
    description: "Attitude and heading reference system.",
    also: &["3DM-GX5-AHRS"],
    model_number: Some(6253),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0C 0x64 "3dm.device_status" [] Some("MSCL requests it from this device.");
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, auto_hard_iron and auto_soft_iron",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, mag and external",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX5-35
///
/// Attitude and heading reference with GNSS.
///
/// Also called 3DM-GX5-GNSS/AHRS. Generation 5. Model number 6252. Manual: LORD 3DM-GX5-35 DCP
/// Manual, revision unknown, known from some pages. This profile is incomplete: Only some pages of
/// the manual are known, so it has more commands and data. Uncertain: The base rates are those that
/// the manual gives for all 3DM-GX5.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Receiver
///
/// The GNSS receiver is a u-blox M8M. GLONASS and BeiDou cannot be used together.
///
/// # Streams
///
/// The manual lists the selectors of the sensor and the filter stream, though the device has no
/// filter.
///
/// # Device status
///
/// It answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static GX5_35: Profile = Profile {
    id: "3dm-gx5-35",
    title: "3DM-GX5-35",
    description: "Attitude and heading reference with GNSS.",
    also: &["3DM-GX5-GNSS/AHRS"],
    model_number: Some(6252),
    generation: Some(5),
    manual: Some("3dm-gx5-35"),
    incomplete: &[
        "Only some pages of the manual are known, so it has more commands and data.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] None;
        0x01 0x02 "base.set_idle" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] None;
        0x01 0x05 "base.built_in_test" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x06 "base.resume" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x07 "base.get_extended_descriptors" [] None;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] None;
        0x01 0x7E "base.soft_reset" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x01 "3dm.poll_imu_data" [] None;
        0x0C 0x02 "3dm.poll_gnss_data" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x06 "3dm.get_imu_base_rate" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x07 "3dm.get_gnss_base_rate" [] None;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x23 "3dm.gnss_assisted_fix" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x24 "3dm.gnss_time_assistance" [WRITE READ] None;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x64 "3dm.device_status" [] None;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] None;
        0x80 0x04 "sensor.scaled_accel" [] None;
        0x80 0x05 "sensor.scaled_gyro" [] None;
        0x80 0x06 "sensor.scaled_mag" [] None;
        0x80 0x07 "sensor.delta_theta" [] None;
        0x80 0x08 "sensor.delta_velocity" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x09 "sensor.comp_orientation_matrix" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x0A "sensor.comp_quaternion" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x0C "sensor.comp_euler_angles" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x10 "sensor.north_vector" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x11 "sensor.up_vector" [] None;
        0x80 0x12 "sensor.gps_timestamp" [] None;
        0x80 0x17 "sensor.scaled_pressure" [] None;
        0x81 0x03 "gnss_data.llh_position" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x04 "gnss_data.ecef_position" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x05 "gnss_data.ned_velocity" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x06 "gnss_data.ecef_velocity" [] None;
        0x81 0x07 "gnss_data.dop" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x08 "gnss_data.utc_time" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x09 "gnss_data.gps_time" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0A "gnss_data.clock_info" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0B "gnss_data.fix_info" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0C "gnss_data.sv_info" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0D "gnss_data.hardware_status" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0E "gnss_data.dgps_info" [] None;
        0x81 0x0F "gnss_data.dgps_channel" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 500.0 },
        BaseRate { set: 0x81, hertz: 4.0 },
    ],
    ports: &[
    ],
    limits: &[
        Limit {
            name: "reserved_gnss_channels",
            value: 32.0,
            unit: None,
            description: "Sum of the channels that constellations reserve.",
        },
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are not known",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.gnss_sbas_settings.enable_sbas",
            read_as: None,
            difference: "default 1",
        },
        Variant {
            parameter: "3dm.gnss_sbas_settings.sbas_options",
            read_as: None,
            difference: "default enable_ranging and enable_corrections",
        },
        Variant {
            parameter: "3dm.gnss_assisted_fix.option",
            read_as: None,
            difference: "default none",
        },
        Variant {
            parameter: "3dm.gnss_assisted_fix.flags",
            read_as: None,
            difference: "default 255",
        },
        Variant {
            parameter: "3dm.device_status.model_number",
            read_as: None,
            difference: "always 6252",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "default standard",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-GX5-45
///
/// Inertial navigation system with GNSS, magnetometer and pressure sensor.
///
/// Also called 3DM-GX5-GNSS/INS. Generation 5. Model number 6251. Manual: LORD 3DM-GX5-45 DCP
/// Manual, 8500-0064 rev. C, known from some pages. This profile is incomplete: Only some pages of
/// the manual are known, so it has more commands and data. This profile is incomplete: Only four
/// fields of the filter data are listed; the manual has 27 or more. Uncertain: The values of
/// [`filter::GnssSource`](crate::filter::GnssSource) are those that MSCL offers. Uncertain: The
/// base rates are those that the manuals of the 3DM-GX5-35 and the 3DM-GX5-45 give for all 3DM-GX5.
/// Uncertain: An example in the manual has a base rate of 100 Hz for the sensor data. Uncertain:
/// The manual gives the length of
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and offsets of
/// [`mip_3dm::DeviceStatusDiagnosticGx4Response`](crate::mip_3dm::DeviceStatusDiagnosticGx4Response);
/// MSCL differs.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # RTCM input
///
/// The command with the descriptor 0x20 of the set `3dm` accepts RTCM 2.3; its layout is not known.
/// The receiver uses the messages 1, 2, 3 and 9.
///
/// # Functions that the specification does not define
///
/// The manual has a read of [`mip_3dm::DeviceSettings`](crate::mip_3dm::DeviceSettings), which is
/// answered with the settings of all commands.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static GX5_45: Profile = Profile {
    id: "3dm-gx5-45",
    title: "3DM-GX5-45",
    description: "Inertial navigation system with GNSS, magnetometer and pressure sensor.",
    also: &["3DM-GX5-GNSS/INS"],
    model_number: Some(6251),
    generation: Some(5),
    manual: Some("3dm-gx5-45"),
    incomplete: &[
        "Only some pages of the manual are known, so it has more commands and data.",
        "Only four fields of the filter data are listed; the manual has 27 or more.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x02 "base.set_idle" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x05 "base.built_in_test" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x06 "base.resume" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x07 "base.get_extended_descriptors" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x01 0x7E "base.soft_reset" [] None;
        0x0C 0x01 "3dm.poll_imu_data" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x02 "3dm.poll_gnss_data" [] None;
        0x0C 0x03 "3dm.poll_filter_data" [] None;
        0x0C 0x06 "3dm.get_imu_base_rate" [] None;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] None;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0B "3dm.get_filter_base_rate" [] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] None;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x23 "3dm.gnss_assisted_fix" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x24 "3dm.gnss_time_assistance" [WRITE READ] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x39 "3dm.capture_gyro_bias" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0C 0x64 "3dm.device_status" [] None;
        0x0D 0x01 "filter.reset" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0D 0x02 "filter.set_initial_attitude" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x16 "filter.external_gnss_update" [] None;
        0x0D 0x17 "filter.external_heading_update" [] None;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x1F "filter.external_heading_update_with_time" [] None;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x21 "filter.tare_orientation" [WRITE SAVE LOAD DEFAULT] None;
        0x0D 0x22 "filter.commanded_zupt" [] None;
        0x0D 0x23 "filter.commanded_angular_zupt" [] None;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [WRITE SAVE] None;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x29 "filter.pressure_altitude_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x2B "filter.hard_iron_offset_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x47 "filter.altitude_aiding" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] None;
        0x80 0x04 "sensor.scaled_accel" [] None;
        0x80 0x05 "sensor.scaled_gyro" [] None;
        0x80 0x06 "sensor.scaled_mag" [] None;
        0x80 0x07 "sensor.delta_theta" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x08 "sensor.delta_velocity" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x09 "sensor.comp_orientation_matrix" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x0A "sensor.comp_quaternion" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x0C "sensor.comp_euler_angles" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x10 "sensor.north_vector" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x11 "sensor.up_vector" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x12 "sensor.gps_timestamp" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x80 0x17 "sensor.scaled_pressure" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x03 "gnss_data.llh_position" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x04 "gnss_data.ecef_position" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x05 "gnss_data.ned_velocity" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x06 "gnss_data.ecef_velocity" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x07 "gnss_data.dop" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x08 "gnss_data.utc_time" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x09 "gnss_data.gps_time" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0A "gnss_data.clock_info" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0B "gnss_data.fix_info" [] Some("The section numbers leave room for it, and the manual of a related device has it there.");
        0x81 0x0C "gnss_data.sv_info" [] None;
        0x81 0x0D "gnss_data.hardware_status" [] None;
        0x81 0x0E "gnss_data.dgps_info" [] None;
        0x81 0x0F "gnss_data.dgps_channel" [] None;
        0x82 0x04 "filter_data.attitude_dcm" [] None;
        0x82 0x05 "filter_data.euler_angles" [] None;
        0x82 0x0E "filter_data.comp_angular_rate" [] None;
        0x82 0x14 "filter_data.heading_update_state" [] None;
    },
    base_rates: &[
        BaseRate { set: 0x80, hertz: 500.0 },
        BaseRate { set: 0x81, hertz: 4.0 },
        BaseRate { set: 0x82, hertz: 500.0 },
    ],
    ports: &[
        ProfilePort {
            name: "UART 1",
            id: None,
            baud_rates: &[9600, 19200, 115200, 230400, 460800, 921600],
            protocols: &["MIP"],
        },
        ProfilePort {
            name: "USB",
            id: None,
            baud_rates: &[],
            protocols: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "baud_rate_delay",
            value: 250.0,
            unit: Some("ms"),
            description: "Time from the acknowledge of a new baud rate until commands are answered at that rate.",
        },
        Limit {
            name: "rtcm_chunk",
            value: 253.0,
            unit: Some("byte"),
            description: "Maximum number of RTCM bytes in one field.",
        },
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are not known",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.mag_hard_iron_offset.offset",
            read_as: None,
            difference: "default 0, 0, 0",
        },
        Variant {
            parameter: "3dm.uart_baud_rate.baud",
            read_as: None,
            difference: "default 115200",
        },
        Variant {
            parameter: "3dm.device_status.model_number",
            read_as: None,
            difference: "always 6251",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.antenna_offset.offset",
            read_as: None,
            difference: "frame sensor",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal and external",
        },
        Variant {
            parameter: "filter.adaptive_filter_options.level",
            read_as: None,
            difference: "only off and moderate",
        },
        Variant {
            parameter: "filter.antenna_offset_response.offset",
            read_as: None,
            difference: "frame sensor",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-MV5-AR
///
/// Device of generation 5, known only by its name and its number.
///
/// Also called 3DM-MV5-15. Generation 5. Model number 6243. No manual is known. This profile is
/// incomplete: No manual is known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static MV5_AR: Profile = Profile {
    id: "3dm-mv5-ar",
    title: "3DM-MV5-AR",
    description: "Device of generation 5, known only by its name and its number.",
    also: &["3DM-MV5-15"],
    model_number: Some(6243),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-RQ1-45-LT
///
/// Ruggedized tactical grade inertial navigation system with GPS.
///
/// Also called 3DM-RQ1-45_LT. Generation 4. Model number 6232. Manual: LORD 3DM-RQ1-45 Data
/// Communications Protocol, of June 25, 2013, known from its table of contents. This profile is
/// incomplete: The table of contents of the manual is known up to
/// [`filter::SetInitialHeading`](crate::filter::SetInitialHeading). The set `system` follows. This
/// profile is incomplete: It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.
/// Uncertain: The SDK writes the name with an underscore before LT and ST.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticRq1_45Response`](crate::mip_3dm::DeviceStatusDiagnosticRq1_45Response).
///
/// # What it lacks
///
/// According to the table of contents of the manual, it has neither
/// [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate) nor
/// [`mip_3dm::ComplementaryFilter`](crate::mip_3dm::ComplementaryFilter).
#[rustfmt::skip]
pub static RQ1_45_LT: Profile = Profile {
    id: "3dm-rq1-45-lt",
    title: "3DM-RQ1-45-LT",
    description: "Ruggedized tactical grade inertial navigation system with GPS.",
    also: &["3DM-RQ1-45_LT"],
    model_number: Some(6232),
    generation: Some(4),
    manual: Some("3dm-rq1-45"),
    incomplete: &[
        "The table of contents of the manual is known up to `filter.set_initial_heading`. The set `system` follows.",
        "It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] None;
        0x01 0x02 "base.set_idle" [] None;
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] None;
        0x01 0x05 "base.built_in_test" [] None;
        0x01 0x06 "base.resume" [] None;
        0x01 0x7E "base.soft_reset" [] None;
        0x0C 0x01 "3dm.poll_imu_data" [] None;
        0x0C 0x02 "3dm.poll_gnss_data" [] None;
        0x0C 0x03 "3dm.poll_filter_data" [] None;
        0x0C 0x06 "3dm.get_imu_base_rate" [] None;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] None;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0B "3dm.get_filter_base_rate" [] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] None;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x64 "3dm.device_status" [] None;
        0x0D 0x01 "filter.reset" [] None;
        0x0D 0x02 "filter.set_initial_attitude" [] None;
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are not known",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, gnss_velocity and external",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-RQ1-45-ST
///
/// Ruggedized tactical grade inertial navigation system with GPS.
///
/// Also called 3DM-RQ1-45_ST. Generation 4. Model number 6239. Manual: LORD 3DM-RQ1-45 Data
/// Communications Protocol, of June 25, 2013, known from its table of contents. This profile is
/// incomplete: The table of contents of the manual is known up to
/// [`filter::SetInitialHeading`](crate::filter::SetInitialHeading). The set `system` follows. This
/// profile is incomplete: It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.
/// Uncertain: The SDK writes the name with an underscore before LT and ST.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it answers with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticRq1_45Response`](crate::mip_3dm::DeviceStatusDiagnosticRq1_45Response).
///
/// # What it lacks
///
/// According to the table of contents of the manual, it has neither
/// [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate) nor
/// [`mip_3dm::ComplementaryFilter`](crate::mip_3dm::ComplementaryFilter).
#[rustfmt::skip]
pub static RQ1_45_ST: Profile = Profile {
    id: "3dm-rq1-45-st",
    title: "3DM-RQ1-45-ST",
    description: "Ruggedized tactical grade inertial navigation system with GPS.",
    also: &["3DM-RQ1-45_ST"],
    model_number: Some(6239),
    generation: Some(4),
    manual: Some("3dm-rq1-45"),
    incomplete: &[
        "The table of contents of the manual is known up to `filter.set_initial_heading`. The set `system` follows.",
        "It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] None;
        0x01 0x02 "base.set_idle" [] None;
        0x01 0x03 "base.get_device_info" [] None;
        0x01 0x04 "base.get_device_descriptors" [] None;
        0x01 0x05 "base.built_in_test" [] None;
        0x01 0x06 "base.resume" [] None;
        0x01 0x7E "base.soft_reset" [] None;
        0x0C 0x01 "3dm.poll_imu_data" [] None;
        0x0C 0x02 "3dm.poll_gnss_data" [] None;
        0x0C 0x03 "3dm.poll_filter_data" [] None;
        0x0C 0x06 "3dm.get_imu_base_rate" [] None;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] None;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x0B "3dm.get_filter_base_rate" [] None;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] None;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] None;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x39 "3dm.capture_gyro_bias" [] None;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] None;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] None;
        0x0C 0x64 "3dm.device_status" [] None;
        0x0D 0x01 "filter.reset" [] None;
        0x0D 0x02 "filter.set_initial_attitude" [] None;
        0x0D 0x03 "filter.set_initial_heading" [] None;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] Some("MSCL lists the choices for this device.");
    },
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are not known",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.heading_source.source",
            read_as: None,
            difference: "only none, gnss_velocity and external",
        },
        Variant {
            parameter: "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
        Variant {
            parameter: "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement",
            read_as: None,
            difference: "only disabled and fixed",
        },
    ],
    ack_codes: &[
    ],
};

/// 3DM-RTK
///
/// Modem for GNSS corrections.
///
/// Generation 7. Model number 6285. No manual is known. This profile is incomplete: No manual is
/// known. The SDK gives only its name and number.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static RTK: Profile = Profile {
    id: "3dm-rtk",
    title: "3DM-RTK",
    description: "Modem for GNSS corrections.",
    also: &[],
    model_number: Some(6285),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known. The SDK gives only its name and number.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] Some("The vendor's software requests it from every device.");
        0x01 0x02 "base.set_idle" [] Some("The vendor's software requests it from every device.");
        0x01 0x03 "base.get_device_info" [] Some("The vendor's software requests it from every device.");
        0x01 0x04 "base.get_device_descriptors" [] Some("The vendor's software requests it from every device.");
        0x01 0x06 "base.resume" [] Some("The vendor's software requests it from every device.");
    },
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
