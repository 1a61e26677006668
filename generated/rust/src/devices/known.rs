//! The devices.

#[allow(unused_imports)] // a part of the specification needs fewer
use super::{
    AbsentSet, BaseRate, Evidence, Firmware, Limit, Profile, ProfilePort, Support, Variant,
};
#[allow(unused_imports)]
use crate::protocol::{AckCode, DescriptorSet};

/// All devices.
#[rustfmt::skip]
pub static ALL: &[&Profile] = &[
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
    &CX5_45,
    &CX7_AHRS,
    &CX7_AR,
    &CX7_INS,
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
    &GX4_IMU,
    &GX5_15,
    &GX5_25,
    &GX5_35,
    &GX5_45,
    &MV5_AR,
    &RQ1_45_LT,
    &RQ1_45_ST,
    &RQ1_IMU,
    &RTK,
    &DEMOD_DC,
];

#[rustfmt::skip]
const CV5_10_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (3DM-CV5-10 Data Communications Protocol Manual: Contents).",
    absence: "",
};
#[rustfmt::skip]
const CV5_10_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV5_10_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-CX5-10.",
    absence: "",
};
#[rustfmt::skip]
const CV5_10_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (MicroStrain Communication Library: Issue 145).",
    absence: "",
};
#[rustfmt::skip]
const CV5_10_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Not in the manual, whose list of the set is complete.",
    absence: "",
};
#[rustfmt::skip]
const CV5_10_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CV5_10_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const CV5_10_8: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a pressure sensor, which the device lacks.",
    absence: "has no pressure sensor",
};

/// 3DM-CV5-10
///
/// Inertial measurement unit.
///
/// Also called 3DM-CV5-IMU. Generation 5. Model number 6259. Sensors: accelerometer, gyroscope.
/// GNSS receivers: none. GNSS antennas: none. Sets known completely from the manual: base (0x01).
/// Manual: 3DM-CV5-10 Data Communications Protocol Manual, 8500-0070 revision E, 2018, known from
/// its contents. This profile is incomplete: Of the manual, only the table of contents is known, up
/// to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`. Uncertain: The sensors are
/// inferred from the name of the model; that it has no magnetometer also from MSCL, which offers it
/// no north compensation.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
    manual: Some("3dm-cv5-10"),
    incomplete: &[
        "Of the manual, only the table of contents is known, up to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CV5_10_1;
        0x01 0x02 "base.set_idle" [] CV5_10_1;
        0x01 0x03 "base.get_device_info" [] CV5_10_1;
        0x01 0x04 "base.get_device_descriptors" [] CV5_10_1;
        0x01 0x05 "base.built_in_test" [] CV5_10_1;
        0x01 0x06 "base.resume" [] CV5_10_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CV5_10_1;
        0x01 0x7E "base.soft_reset" [] CV5_10_1;
        0x0C 0x01 "3dm.poll_imu_data" [] CV5_10_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CV5_10_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CV5_10_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV5_10_3;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV5_10_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_10_3;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_10_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV5_10_3;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CV5_10_3;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CV5_10_3;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV5_10_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV5_10_3;
        0x0C 0x64 "3dm.device_status" [] CV5_10_3;
        0x80 0x04 "sensor.scaled_accel" [] CV5_10_2;
        0x80 0x05 "sensor.scaled_gyro" [] CV5_10_2;
        0x80 0x07 "sensor.delta_theta" [] CV5_10_3;
        0x80 0x08 "sensor.delta_velocity" [] CV5_10_3;
        0x80 0x12 "sensor.gps_timestamp" [] CV5_10_3;
    },
    refuses: supported! {
        0x01 0x07 "base.get_extended_descriptors" [] CV5_10_5;
        0x01 0x08 "base.continuous_built_in_test" [] CV5_10_5;
        0x01 0x09 "base.comm_speed" [] CV5_10_5;
        0x0C 0x02 "3dm.poll_gnss_data" [] CV5_10_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CV5_10_6;
        0x0C 0x09 "3dm.gnss_message_format" [] CV5_10_6;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CV5_10_6;
        0x0C 0x21 "3dm.constellation_settings" [] CV5_10_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CV5_10_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CV5_10_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CV5_10_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CV5_10_6;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] CV5_10_7;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] CV5_10_7;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CV5_10_6;
        0x80 0x01 "sensor.raw_accel" [] CV5_10_4;
        0x80 0x03 "sensor.raw_mag" [] CV5_10_7;
        0x80 0x06 "sensor.scaled_mag" [] CV5_10_7;
        0x80 0x16 "sensor.raw_pressure" [] CV5_10_8;
        0x80 0x17 "sensor.scaled_pressure" [] CV5_10_8;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CV5_10_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CV5_10_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CV5_10_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CV5_10_6 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL has no support for it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CV5_15_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (3DM-CV5-15 Data Communications Protocol Manual: Contents).",
    absence: "",
};
#[rustfmt::skip]
const CV5_15_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CV5_15_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV5_15_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15.",
    absence: "",
};
#[rustfmt::skip]
const CV5_15_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Not in the manual, whose list of the set is complete.",
    absence: "",
};
#[rustfmt::skip]
const CV5_15_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CV5_15_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const CV5_15_8: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CV5-15
///
/// Attitude reference.
///
/// Also called 3DM-CV5-AR. Generation 5. Model number 6258. Sensors: accelerometer, gyroscope,
/// pressure sensor. GNSS receivers: none. GNSS antennas: none. Sets known completely from the
/// manual: base (0x01). Manual: 3DM-CV5-15 Data Communications Protocol Manual, revision D, 2018,
/// known from its contents. This profile is incomplete: Of the manual, only the table of contents
/// is known, up to [`mip_3dm::FilterMessageFormat`](crate::mip_3dm::FilterMessageFormat). It lists
/// the sets `base`, `3dm`, `filter`, `system`, `sensor` and `filter_data`.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
    manual: Some("3dm-cv5-15"),
    incomplete: &[
        "Of the manual, only the table of contents is known, up to `3dm.filter_message_format`. It lists the sets `base`, `3dm`, `filter`, `system`, `sensor` and `filter_data`.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CV5_15_1;
        0x01 0x02 "base.set_idle" [] CV5_15_1;
        0x01 0x03 "base.get_device_info" [] CV5_15_1;
        0x01 0x04 "base.get_device_descriptors" [] CV5_15_1;
        0x01 0x05 "base.built_in_test" [] CV5_15_1;
        0x01 0x06 "base.resume" [] CV5_15_1;
        0x01 0x07 "base.get_extended_descriptors" [] CV5_15_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CV5_15_1;
        0x01 0x7E "base.soft_reset" [] CV5_15_1;
        0x0C 0x01 "3dm.poll_imu_data" [] CV5_15_1;
        0x0C 0x03 "3dm.poll_filter_data" [] CV5_15_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CV5_15_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CV5_15_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] CV5_15_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] CV5_15_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV5_15_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_15_4;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_15_4;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV5_15_2;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0C 0x64 "3dm.device_status" [] CV5_15_4;
        0x0D 0x01 "filter.reset" [] CV5_15_3;
        0x0D 0x02 "filter.set_initial_attitude" [] CV5_15_4;
        0x0D 0x03 "filter.set_initial_heading" [] CV5_15_4;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] CV5_15_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x17 "filter.external_heading_update" [] CV5_15_4;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] CV5_15_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CV5_15_4;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x23 "filter.commanded_angular_zupt" [] CV5_15_4;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] CV5_15_4;
        0x80 0x04 "sensor.scaled_accel" [] CV5_15_2;
        0x80 0x05 "sensor.scaled_gyro" [] CV5_15_2;
        0x80 0x07 "sensor.delta_theta" [] CV5_15_4;
        0x80 0x08 "sensor.delta_velocity" [] CV5_15_4;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CV5_15_4;
        0x80 0x0A "sensor.comp_quaternion" [] CV5_15_4;
        0x80 0x0C "sensor.comp_euler_angles" [] CV5_15_4;
        0x80 0x10 "sensor.north_vector" [] CV5_15_4;
        0x80 0x11 "sensor.up_vector" [] CV5_15_4;
        0x80 0x12 "sensor.gps_timestamp" [] CV5_15_2;
        0x80 0x17 "sensor.scaled_pressure" [] CV5_15_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] CV5_15_4;
        0x82 0x04 "filter_data.attitude_dcm" [] CV5_15_4;
        0x82 0x05 "filter_data.euler_angles" [] CV5_15_2;
        0x82 0x06 "filter_data.gyro_bias" [] CV5_15_4;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CV5_15_4;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CV5_15_4;
        0x82 0x0D "filter_data.linear_accel" [] CV5_15_4;
        0x82 0x0E "filter_data.comp_angular_rate" [] CV5_15_2;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] CV5_15_4;
        0x82 0x10 "filter_data.status" [] CV5_15_2;
        0x82 0x11 "filter_data.timestamp" [] CV5_15_2;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CV5_15_4;
        0x82 0x13 "filter_data.gravity_vector" [] CV5_15_4;
        0x82 0x14 "filter_data.heading_update_state" [] CV5_15_4;
        0x82 0x1C "filter_data.comp_accel" [] CV5_15_2;
        0x82 0x21 "filter_data.pressure_altitude" [] CV5_15_4;
    },
    refuses: supported! {
        0x01 0x08 "base.continuous_built_in_test" [] CV5_15_5;
        0x01 0x09 "base.comm_speed" [] CV5_15_5;
        0x0C 0x02 "3dm.poll_gnss_data" [] CV5_15_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CV5_15_6;
        0x0C 0x09 "3dm.gnss_message_format" [] CV5_15_6;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CV5_15_6;
        0x0C 0x21 "3dm.constellation_settings" [] CV5_15_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CV5_15_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CV5_15_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CV5_15_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CV5_15_6;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] CV5_15_7;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] CV5_15_7;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CV5_15_6;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] CV5_15_7;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] CV5_15_7;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] CV5_15_7;
        0x0D 0x42 "filter.mag_noise" [] CV5_15_7;
        0x0D 0x43 "filter.magnetic_declination_source" [] CV5_15_7;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] CV5_15_7;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] CV5_15_7;
        0x0D 0x4C "filter.magnetic_inclination_source" [] CV5_15_7;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] CV5_15_7;
        0x0D 0x54 "filter.multi_antenna_offset" [] CV5_15_6;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CV5_15_6;
        0x80 0x03 "sensor.raw_mag" [] CV5_15_7;
        0x80 0x06 "sensor.scaled_mag" [] CV5_15_7;
        0x82 0x1A "filter_data.mag_bias" [] CV5_15_7;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] CV5_15_7;
        0x82 0x25 "filter_data.mag_offset" [] CV5_15_7;
        0x82 0x26 "filter_data.mag_matrix" [] CV5_15_7;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CV5_15_7;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CV5_15_7;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] CV5_15_7;
        0x82 0x2C "filter_data.mag_residual_vector" [] CV5_15_7;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CV5_15_6;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CV5_15_6;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CV5_15_8;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CV5_15_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CV5_15_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CV5_15_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CV5_15_6 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL has no support for it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only external",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CV5_25_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CV5_25_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV5_25_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV5_25_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
    absence: "",
};
#[rustfmt::skip]
const CV5_25_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CV5_25_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CV5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-CV5-AHRS. Generation 5. Model number 6257. Sensors: accelerometer, gyroscope,
/// magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known.
/// This profile is incomplete: No manual is known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CV5_25_1;
        0x01 0x02 "base.set_idle" [] CV5_25_1;
        0x01 0x03 "base.get_device_info" [] CV5_25_2;
        0x01 0x04 "base.get_device_descriptors" [] CV5_25_3;
        0x01 0x05 "base.built_in_test" [] CV5_25_4;
        0x01 0x06 "base.resume" [] CV5_25_1;
        0x01 0x07 "base.get_extended_descriptors" [] CV5_25_3;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CV5_25_4;
        0x01 0x7E "base.soft_reset" [] CV5_25_4;
        0x0C 0x01 "3dm.poll_imu_data" [] CV5_25_4;
        0x0C 0x03 "3dm.poll_filter_data" [] CV5_25_4;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CV5_25_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CV5_25_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] CV5_25_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] CV5_25_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV5_25_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_25_4;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_25_4;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV5_25_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_25_4;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] CV5_25_4;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0C 0x64 "3dm.device_status" [] CV5_25_4;
        0x0D 0x01 "filter.reset" [] CV5_25_2;
        0x0D 0x02 "filter.set_initial_attitude" [] CV5_25_4;
        0x0D 0x03 "filter.set_initial_heading" [] CV5_25_4;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] CV5_25_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x17 "filter.external_heading_update" [] CV5_25_4;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] CV5_25_2;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] CV5_25_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CV5_25_4;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x23 "filter.commanded_angular_zupt" [] CV5_25_4;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [WRITE SAVE] CV5_25_4;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x29 "filter.pressure_altitude_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x2B "filter.hard_iron_offset_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x47 "filter.altitude_aiding" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] CV5_25_4;
        0x80 0x04 "sensor.scaled_accel" [] CV5_25_1;
        0x80 0x05 "sensor.scaled_gyro" [] CV5_25_1;
        0x80 0x06 "sensor.scaled_mag" [] CV5_25_4;
        0x80 0x07 "sensor.delta_theta" [] CV5_25_4;
        0x80 0x08 "sensor.delta_velocity" [] CV5_25_4;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CV5_25_4;
        0x80 0x0A "sensor.comp_quaternion" [] CV5_25_4;
        0x80 0x0C "sensor.comp_euler_angles" [] CV5_25_4;
        0x80 0x10 "sensor.north_vector" [] CV5_25_4;
        0x80 0x11 "sensor.up_vector" [] CV5_25_4;
        0x80 0x12 "sensor.gps_timestamp" [] CV5_25_1;
        0x80 0x17 "sensor.scaled_pressure" [] CV5_25_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] CV5_25_4;
        0x82 0x04 "filter_data.attitude_dcm" [] CV5_25_4;
        0x82 0x05 "filter_data.euler_angles" [] CV5_25_1;
        0x82 0x06 "filter_data.gyro_bias" [] CV5_25_4;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CV5_25_4;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CV5_25_4;
        0x82 0x0D "filter_data.linear_accel" [] CV5_25_4;
        0x82 0x0E "filter_data.comp_angular_rate" [] CV5_25_1;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] CV5_25_4;
        0x82 0x10 "filter_data.status" [] CV5_25_1;
        0x82 0x11 "filter_data.timestamp" [] CV5_25_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CV5_25_4;
        0x82 0x13 "filter_data.gravity_vector" [] CV5_25_4;
        0x82 0x14 "filter_data.heading_update_state" [] CV5_25_4;
        0x82 0x15 "filter_data.magnetic_model" [] CV5_25_4;
        0x82 0x1C "filter_data.comp_accel" [] CV5_25_1;
        0x82 0x21 "filter_data.pressure_altitude" [] CV5_25_4;
        0x82 0x25 "filter_data.mag_offset" [] CV5_25_4;
        0x82 0x26 "filter_data.mag_matrix" [] CV5_25_4;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CV5_25_4;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CV5_25_4;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CV5_25_5;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CV5_25_5;
        0x0C 0x09 "3dm.gnss_message_format" [] CV5_25_5;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CV5_25_5;
        0x0C 0x21 "3dm.constellation_settings" [] CV5_25_5;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CV5_25_5;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CV5_25_5;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CV5_25_5;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CV5_25_5;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CV5_25_5;
        0x0D 0x54 "filter.multi_antenna_offset" [] CV5_25_5;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CV5_25_5;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CV5_25_5;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CV5_25_5;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CV5_25_6;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CV5_25_5 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CV5_25_5 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CV5_25_5 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CV5_25_5 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
        Variant {
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only mag and external",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CV7_AHRS_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and Specifications).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_2: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_3: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_4: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS messages).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_5: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public program).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_6: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_7: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_8: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (Public programs of users: Program for a 3DM-CV7).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_9: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_10: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (PX4: Driver of the vendor's sensors).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_11: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_12: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (firmware 1.0.07; ROS driver of the vendor: Issue 257).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_13: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (ROS driver of the vendor: Issue 350).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AHRS_14: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};

/// 3DM-CV7-AHRS
///
/// Attitude and heading reference system.
///
/// Generation 7. Model number 6286. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7 Documentation
/// (AHRS and AR), online, known from some pages. This profile is incomplete: Only some pages of its
/// manual are known; the device has further commands and data. Uncertain: MSCL offers only the
/// values `none` and `manual` of
/// [`filter::MagneticDeclinationSource`](crate::filter::MagneticDeclinationSource); the manual also
/// has `wmm`.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// Features of each pin, according to MSCL, and its position on the connector, according to the ROS
/// driver.
///
/// | Pin | Connector pin | Features |
/// | --- | --- | --- |
/// | 1 | 7 | GPIO, PPS, timestamp |
/// | 2 | 9 | GPIO, PPS, timestamp |
/// | 3 | 6 | GPIO, PPS, timestamp |
/// | 4 | 10 | GPIO, PPS, timestamp |
///
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1.
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
        "Only some pages of its manual are known; the device has further commands and data.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CV7_AHRS_6;
        0x01 0x02 "base.set_idle" [] CV7_AHRS_6;
        0x01 0x03 "base.get_device_info" [] CV7_AHRS_7;
        0x01 0x04 "base.get_device_descriptors" [] CV7_AHRS_1;
        0x01 0x05 "base.built_in_test" [] CV7_AHRS_8;
        0x01 0x06 "base.resume" [] CV7_AHRS_6;
        0x01 0x07 "base.get_extended_descriptors" [] CV7_AHRS_1;
        0x01 0x08 "base.continuous_built_in_test" [] CV7_AHRS_11;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CV7_AHRS_11;
        0x01 0x7E "base.soft_reset" [] CV7_AHRS_2;
        0x0C 0x0D "3dm.poll_data" [] CV7_AHRS_11;
        0x0C 0x0E "3dm.get_base_rate" [] CV7_AHRS_1;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_6;
        0x0C 0x10 "3dm.factory_streaming" [] CV7_AHRS_11;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_9;
        0x0C 0x2A "3dm.get_event_support" [] CV7_AHRS_2;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_6;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CV7_AHRS_11;
        0x0C 0x2D "3dm.get_event_action_status" [] CV7_AHRS_11;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_4;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_4;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV7_AHRS_6;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_6;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV7_AHRS_11;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV7_AHRS_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_4;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CV7_AHRS_11;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_1;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_10;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CV7_AHRS_11;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_1;
        0x0D 0x01 "filter.reset" [] CV7_AHRS_3;
        0x0D 0x03 "filter.set_initial_heading" [] CV7_AHRS_3;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_11;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_5;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_9;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AHRS_3;
        0x13 0x31 "aiding.true_heading" [] CV7_AHRS_3;
        0x13 0x32 "aiding.magnetic_field" [] CV7_AHRS_3;
        0x80 0x04 "sensor.scaled_accel" [] CV7_AHRS_3;
        0x80 0x05 "sensor.scaled_gyro" [] CV7_AHRS_5;
        0x80 0x06 "sensor.scaled_mag" [] CV7_AHRS_1;
        0x80 0x07 "sensor.delta_theta" [] CV7_AHRS_11;
        0x80 0x08 "sensor.delta_velocity" [] CV7_AHRS_11;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CV7_AHRS_11;
        0x80 0x0A "sensor.comp_quaternion" [] CV7_AHRS_5;
        0x80 0x0C "sensor.comp_euler_angles" [] CV7_AHRS_2;
        0x80 0x14 "sensor.temperature_statistics" [] CV7_AHRS_11;
        0x80 0x17 "sensor.scaled_pressure" [] CV7_AHRS_1;
        0x80 0x18 "sensor.overrange_status" [] CV7_AHRS_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] CV7_AHRS_5;
        0x82 0x04 "filter_data.attitude_dcm" [] CV7_AHRS_5;
        0x82 0x05 "filter_data.euler_angles" [] CV7_AHRS_5;
        0x82 0x06 "filter_data.gyro_bias" [] CV7_AHRS_3;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CV7_AHRS_10;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CV7_AHRS_11;
        0x82 0x0D "filter_data.linear_accel" [] CV7_AHRS_5;
        0x82 0x0E "filter_data.comp_angular_rate" [] CV7_AHRS_5;
        0x82 0x10 "filter_data.status" [] CV7_AHRS_5;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CV7_AHRS_11;
        0x82 0x13 "filter_data.gravity_vector" [] CV7_AHRS_5;
        0x82 0x1C "filter_data.comp_accel" [] CV7_AHRS_1;
        0x82 0x21 "filter_data.pressure_altitude" [] CV7_AHRS_11;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] CV7_AHRS_2;
        0xA0 0x01 "system_data.built_in_test" [] CV7_AHRS_11;
        0xA0 0x02 "system_data.time_sync_status" [] CV7_AHRS_4;
        0xA0 0x03 "system_data.gpio_state" [] CV7_AHRS_11;
        0xFF 0xD0 "shared.event_source" [] CV7_AHRS_4;
        0xFF 0xD3 "shared.gps_timestamp" [] CV7_AHRS_4;
        0xFF 0xD4 "shared.delta_time" [] CV7_AHRS_11;
        0xFF 0xD5 "shared.reference_timestamp" [] CV7_AHRS_11;
        0xFF 0xD6 "shared.reference_time_delta" [] CV7_AHRS_11;
        0xFF 0xD7 "shared.external_timestamp" [] CV7_AHRS_11;
        0xFF 0xD8 "shared.external_time_delta" [] CV7_AHRS_11;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CV7_AHRS_14;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CV7_AHRS_14;
        0x0C 0x09 "3dm.gnss_message_format" [] CV7_AHRS_14;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CV7_AHRS_14;
        0x0C 0x21 "3dm.constellation_settings" [] CV7_AHRS_14;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CV7_AHRS_14;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CV7_AHRS_14;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CV7_AHRS_14;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CV7_AHRS_14;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CV7_AHRS_14;
        0x0D 0x54 "filter.multi_antenna_offset" [] CV7_AHRS_14;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CV7_AHRS_14;
        0x81 0x03 "gnss_data.llh_position" [] CV7_AHRS_12;
        0x81 0x0B "gnss_data.fix_info" [] CV7_AHRS_12;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CV7_AHRS_12;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CV7_AHRS_14;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] CV7_AHRS_12;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CV7_AHRS_13;
        0x91 0x03 "gnss_1.llh_position" [] CV7_AHRS_12;
        0x91 0x0B "gnss_1.fix_info" [] CV7_AHRS_12;
        0x91 0x12 "gnss_1.sbas_info" [] CV7_AHRS_13;
        0x91 0x14 "gnss_1.rf_error_detection" [] CV7_AHRS_13;
        0x92 0x0B "gnss_2.fix_info" [] CV7_AHRS_13;
        0x92 0x12 "gnss_2.sbas_info" [] CV7_AHRS_13;
        0x92 0x14 "gnss_2.rf_error_detection" [] CV7_AHRS_13;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CV7_AHRS_14 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CV7_AHRS_14 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CV7_AHRS_14 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CV7_AHRS_14 },
    ],
    firmware: &[
        Firmware {
            set: DescriptorSet(0x0C),
            descriptor: 0x50,
            versions: "<= 1.0.07",
        },
        Firmware {
            set: DescriptorSet(0x0C),
            descriptor: 0x54,
            versions: "> 1.0.07",
        },
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0xA0), hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[115200, 230400, 460800, 921600],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[115200, 230400, 460800, 921600],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
        Limit {
            name: "event_triggers",
            value: 12.0,
            unit: None,
            description: "Total number of triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_gpio_triggers",
            value: 4.0,
            unit: None,
            description: "Number of GPIO triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_threshold_triggers",
            value: 8.0,
            unit: None,
            description: "Number of threshold triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_combination_triggers",
            value: 8.0,
            unit: None,
            description: "Number of combination triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_tick_rate",
            value: 1000.0,
            unit: Some("Hz"),
            description: "Rate of the event cycle.",
            firmware: Some(">= 1.0.04"),
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
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
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CV7_AR_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and Specifications).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_2: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_3: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_4: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS messages).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_5: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public program).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_6: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Listed by the device (MicroStrain Communication Library: Issue 258).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_7: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_8: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_9: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (PX4: Driver of the vendor's sensors).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_10: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_11: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (MicroStrain Communication Library: Issue 258).",
    absence: "",
};
#[rustfmt::skip]
const CV7_AR_12: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CV7_AR_13: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const CV7_AR_14: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CV7-AR
///
/// Attitude reference.
///
/// Generation 7. Model number 6287. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
/// receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7 Documentation (AHRS and AR),
/// online, known from some pages. This profile is incomplete: Only some pages of its manual are
/// known; the device has further commands and data. Uncertain: MSCL offers only the values `none`
/// and `manual` of [`filter::MagneticDeclinationSource`](crate::filter::MagneticDeclinationSource);
/// the manual also has `wmm`.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// Features of each pin, according to MSCL, and its position on the connector, according to the ROS
/// driver.
///
/// | Pin | Connector pin | Features |
/// | --- | --- | --- |
/// | 1 | 7 | GPIO, PPS, timestamp |
/// | 2 | 9 | GPIO, PPS, timestamp |
/// | 3 | 6 | GPIO, PPS, timestamp |
/// | 4 | 10 | GPIO, PPS, timestamp |
///
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1.
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
        "Only some pages of its manual are known; the device has further commands and data.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CV7_AR_7;
        0x01 0x02 "base.set_idle" [] CV7_AR_7;
        0x01 0x03 "base.get_device_info" [] CV7_AR_7;
        0x01 0x04 "base.get_device_descriptors" [] CV7_AR_1;
        0x01 0x05 "base.built_in_test" [] CV7_AR_10;
        0x01 0x06 "base.resume" [] CV7_AR_7;
        0x01 0x07 "base.get_extended_descriptors" [] CV7_AR_1;
        0x01 0x08 "base.continuous_built_in_test" [] CV7_AR_6;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CV7_AR_10;
        0x01 0x7E "base.soft_reset" [] CV7_AR_2;
        0x0C 0x0D "3dm.poll_data" [] CV7_AR_10;
        0x0C 0x0E "3dm.get_base_rate" [] CV7_AR_1;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_7;
        0x0C 0x10 "3dm.factory_streaming" [] CV7_AR_10;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_3;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_8;
        0x0C 0x2A "3dm.get_event_support" [] CV7_AR_2;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_7;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CV7_AR_10;
        0x0C 0x2D "3dm.get_event_action_status" [] CV7_AR_10;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_4;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_4;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV7_AR_7;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_7;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV7_AR_10;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV7_AR_3;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_4;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CV7_AR_10;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_1;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_9;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CV7_AR_10;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_1;
        0x0D 0x01 "filter.reset" [] CV7_AR_3;
        0x0D 0x03 "filter.set_initial_heading" [] CV7_AR_3;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_10;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_5;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_8;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_3;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_3;
        0x13 0x31 "aiding.true_heading" [] CV7_AR_3;
        0x13 0x32 "aiding.magnetic_field" [] CV7_AR_3;
        0x80 0x04 "sensor.scaled_accel" [] CV7_AR_3;
        0x80 0x05 "sensor.scaled_gyro" [] CV7_AR_5;
        0x80 0x07 "sensor.delta_theta" [] CV7_AR_10;
        0x80 0x08 "sensor.delta_velocity" [] CV7_AR_10;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CV7_AR_10;
        0x80 0x0A "sensor.comp_quaternion" [] CV7_AR_5;
        0x80 0x0C "sensor.comp_euler_angles" [] CV7_AR_2;
        0x80 0x14 "sensor.temperature_statistics" [] CV7_AR_10;
        0x80 0x17 "sensor.scaled_pressure" [] CV7_AR_1;
        0x80 0x18 "sensor.overrange_status" [] CV7_AR_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] CV7_AR_5;
        0x82 0x04 "filter_data.attitude_dcm" [] CV7_AR_5;
        0x82 0x05 "filter_data.euler_angles" [] CV7_AR_5;
        0x82 0x06 "filter_data.gyro_bias" [] CV7_AR_3;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CV7_AR_9;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CV7_AR_10;
        0x82 0x0D "filter_data.linear_accel" [] CV7_AR_5;
        0x82 0x0E "filter_data.comp_angular_rate" [] CV7_AR_5;
        0x82 0x10 "filter_data.status" [] CV7_AR_5;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CV7_AR_10;
        0x82 0x13 "filter_data.gravity_vector" [] CV7_AR_5;
        0x82 0x1C "filter_data.comp_accel" [] CV7_AR_1;
        0x82 0x21 "filter_data.pressure_altitude" [] CV7_AR_10;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] CV7_AR_2;
        0xA0 0x01 "system_data.built_in_test" [] CV7_AR_6;
        0xA0 0x02 "system_data.time_sync_status" [] CV7_AR_4;
        0xA0 0x03 "system_data.gpio_state" [] CV7_AR_6;
        0xFF 0xD0 "shared.event_source" [] CV7_AR_4;
        0xFF 0xD3 "shared.gps_timestamp" [] CV7_AR_4;
        0xFF 0xD4 "shared.delta_time" [] CV7_AR_6;
        0xFF 0xD5 "shared.reference_timestamp" [] CV7_AR_6;
        0xFF 0xD6 "shared.reference_time_delta" [] CV7_AR_6;
        0xFF 0xD7 "shared.external_timestamp" [] CV7_AR_6;
        0xFF 0xD8 "shared.external_time_delta" [] CV7_AR_6;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CV7_AR_12;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CV7_AR_12;
        0x0C 0x09 "3dm.gnss_message_format" [] CV7_AR_12;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CV7_AR_12;
        0x0C 0x21 "3dm.constellation_settings" [] CV7_AR_12;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CV7_AR_12;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CV7_AR_12;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CV7_AR_12;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CV7_AR_12;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] CV7_AR_13;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] CV7_AR_13;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CV7_AR_12;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_11;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] CV7_AR_13;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] CV7_AR_13;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] CV7_AR_13;
        0x0D 0x42 "filter.mag_noise" [] CV7_AR_13;
        0x0D 0x43 "filter.magnetic_declination_source" [] CV7_AR_13;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_11;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] CV7_AR_13;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] CV7_AR_13;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] CV7_AR_11;
        0x0D 0x4C "filter.magnetic_inclination_source" [] CV7_AR_13;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] CV7_AR_13;
        0x0D 0x54 "filter.multi_antenna_offset" [] CV7_AR_12;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CV7_AR_12;
        0x80 0x03 "sensor.raw_mag" [] CV7_AR_13;
        0x80 0x06 "sensor.scaled_mag" [] CV7_AR_13;
        0x82 0x1A "filter_data.mag_bias" [] CV7_AR_13;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] CV7_AR_13;
        0x82 0x25 "filter_data.mag_offset" [] CV7_AR_13;
        0x82 0x26 "filter_data.mag_matrix" [] CV7_AR_13;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CV7_AR_13;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CV7_AR_13;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] CV7_AR_13;
        0x82 0x2C "filter_data.mag_residual_vector" [] CV7_AR_13;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CV7_AR_12;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CV7_AR_12;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CV7_AR_14;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CV7_AR_12 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CV7_AR_12 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CV7_AR_12 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CV7_AR_12 },
    ],
    firmware: &[
        Firmware {
            set: DescriptorSet(0x0C),
            descriptor: 0x50,
            versions: "<= 1.0.07",
        },
        Firmware {
            set: DescriptorSet(0x0C),
            descriptor: 0x54,
            versions: "> 1.0.07",
        },
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0xA0), hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[115200, 230400, 460800, 921600],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[115200, 230400, 460800, 921600],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
        Limit {
            name: "event_triggers",
            value: 12.0,
            unit: None,
            description: "Total number of triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_gpio_triggers",
            value: 4.0,
            unit: None,
            description: "Number of GPIO triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_threshold_triggers",
            value: 8.0,
            unit: None,
            description: "Number of threshold triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_combination_triggers",
            value: 8.0,
            unit: None,
            description: "Number of combination triggers.",
            firmware: Some(">= 1.0.04"),
        },
        Limit {
            name: "event_tick_rate",
            value: 1000.0,
            unit: Some("Hz"),
            description: "Rate of the event cycle.",
            firmware: Some(">= 1.0.04"),
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "3dm.sensor_range.sensor",
            read_as: None,
            difference: "only all, accel, gyro and pressure",
        },
        Variant {
            parameter: "3dm.get_calibrated_sensor_ranges.sensor",
            read_as: None,
            difference: "only all, accel, gyro and pressure",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only external_heading and all",
        },
        Variant {
            parameter: "sensor.overrange_status.status",
            read_as: None,
            difference: "only accel_x, accel_y, accel_z, gyro_x, gyro_y, gyro_z and pressure",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CV7_GNSS_INS_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};

/// 3DM-CV7-GNSS/INS
///
/// Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure
/// sensor.
///
/// Generation 7. Model number 6292. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: 2. GNSS antennas: 2. Manual: MicroStrain 3DM-CV7-GNSS/INS Documentation,
/// 8500-0099. Uncertain: The manual warns of a bug in the NMEA input, and does not describe it.
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
/// manual marks PPS on pins 2 to 4 with an asterisk, which it does not explain.
///
/// | Pin | Connector pin | Features | UART |
/// | --- | --- | --- | --- |
/// | 1 | 7 | GPIO, PPS, timestamp, UART | UART 2 |
/// | 2 | 9 | GPIO, PPS\*, timestamp, UART | UART 2 |
/// | 3 | 6 | GPIO, PPS\*, timestamp, UART | UART 3 |
/// | 4 | 10 | GPIO, PPS\*, timestamp, UART | UART 3 |
///
/// # GPIO behaviors and pin modes
///
/// Values of the behavior for each feature, and the pin modes that go with it. Two pins cannot have
/// the same direction of the same UART. PPS output from an internal receiver is always push-pull.
/// The asterisk is the same as in the table of pin features.
///
/// | Feature | Behavior | Pins | Pin modes |
/// | --- | --- | --- | --- |
/// | unused (0) | unused (0) | 1 to 4 | none |
/// | gpio (1) | input (1) | 1 to 4 | pull-up or pull-down |
/// | gpio (1) | output low (2) | 1 to 4 | open drain, optionally with pull-up |
/// | gpio (1) | output high (3) | 1 to 4 | open drain, optionally with pull-up |
/// | pps (2) | input (1) | 1; 2 to 4\* | none |
/// | pps (2) | output (2) | 1; 2 to 4\* | none |
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
/// not available.
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
/// or Galileo must be enabled, and GPS L1 with BeiDou L1 alone is rejected.
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
/// Settings of [`mip_3dm::SensorRange`](crate::mip_3dm::SensorRange). The manual lists them for
/// related models, and its gyroscope column is cut off;
/// [`mip_3dm::GetCalibratedSensorRanges`](crate::mip_3dm::GetCalibratedSensorRanges) returns the
/// settings that the device supports.
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
        0x01 0x01 "base.ping" [] CV7_GNSS_INS_1;
        0x01 0x02 "base.set_idle" [] CV7_GNSS_INS_1;
        0x01 0x03 "base.get_device_info" [] CV7_GNSS_INS_1;
        0x01 0x04 "base.get_device_descriptors" [] CV7_GNSS_INS_1;
        0x01 0x05 "base.built_in_test" [] CV7_GNSS_INS_1;
        0x01 0x06 "base.resume" [] CV7_GNSS_INS_1;
        0x01 0x07 "base.get_extended_descriptors" [] CV7_GNSS_INS_1;
        0x01 0x08 "base.continuous_built_in_test" [] CV7_GNSS_INS_1;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x01 0x72 "base.gps_time_update" [WRITE] CV7_GNSS_INS_1;
        0x01 0x7E "base.soft_reset" [] CV7_GNSS_INS_1;
        0x0C 0x04 "3dm.poll_nmea_data" [] CV7_GNSS_INS_1;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x0D "3dm.poll_data" [] CV7_GNSS_INS_1;
        0x0C 0x0E "3dm.get_base_rate" [] CV7_GNSS_INS_1;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x10 "3dm.factory_streaming" [] CV7_GNSS_INS_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x2A "3dm.get_event_support" [] CV7_GNSS_INS_1;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CV7_GNSS_INS_1;
        0x0C 0x2D "3dm.get_event_action_status" [] CV7_GNSS_INS_1;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV7_GNSS_INS_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CV7_GNSS_INS_1;
        0x0C 0x43 "3dm.odometer_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CV7_GNSS_INS_1;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x01 "filter.reset" [] CV7_GNSS_INS_1;
        0x0D 0x03 "filter.set_initial_heading" [] CV7_GNSS_INS_1;
        0x0D 0x05 "filter.run" [] CV7_GNSS_INS_1;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x17 "filter.external_heading_update" [] CV7_GNSS_INS_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CV7_GNSS_INS_1;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x54 "filter.multi_antenna_offset" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x55 "filter.relative_position_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x56 "filter.reference_point_lever_arm" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x61 "filter.speed_lever_arm" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x63 "filter.wheeled_vehicle_constraint_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0E 0x01 "gnss.receiver_info" [] CV7_GNSS_INS_1;
        0x0E 0x02 "gnss.signal_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x0E 0x20 "gnss.spartn_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x13 0x21 "aiding.ecef_position" [] CV7_GNSS_INS_1;
        0x13 0x22 "aiding.llh_position" [] CV7_GNSS_INS_1;
        0x13 0x23 "aiding.height_above_ellipsoid" [] CV7_GNSS_INS_1;
        0x13 0x28 "aiding.ecef_velocity" [] CV7_GNSS_INS_1;
        0x13 0x29 "aiding.ned_velocity" [] CV7_GNSS_INS_1;
        0x13 0x2A "aiding.body_frame_velocity" [] CV7_GNSS_INS_1;
        0x13 0x31 "aiding.true_heading" [] CV7_GNSS_INS_1;
        0x13 0x32 "aiding.magnetic_field" [] CV7_GNSS_INS_1;
        0x13 0x33 "aiding.pressure" [] CV7_GNSS_INS_1;
        0x7F 0x02 "system.interface_control" [WRITE READ SAVE LOAD DEFAULT] CV7_GNSS_INS_1;
        0x80 0x04 "sensor.scaled_accel" [] CV7_GNSS_INS_1;
        0x80 0x05 "sensor.scaled_gyro" [] CV7_GNSS_INS_1;
        0x80 0x06 "sensor.scaled_mag" [] CV7_GNSS_INS_1;
        0x80 0x07 "sensor.delta_theta" [] CV7_GNSS_INS_1;
        0x80 0x08 "sensor.delta_velocity" [] CV7_GNSS_INS_1;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CV7_GNSS_INS_1;
        0x80 0x0A "sensor.comp_quaternion" [] CV7_GNSS_INS_1;
        0x80 0x0C "sensor.comp_euler_angles" [] CV7_GNSS_INS_1;
        0x80 0x12 "sensor.gps_timestamp" [] CV7_GNSS_INS_1;
        0x80 0x14 "sensor.temperature_statistics" [] CV7_GNSS_INS_1;
        0x80 0x17 "sensor.scaled_pressure" [] CV7_GNSS_INS_1;
        0x80 0x18 "sensor.overrange_status" [] CV7_GNSS_INS_1;
        0x80 0x40 "sensor.odometer" [] CV7_GNSS_INS_1;
        0x82 0x01 "filter_data.llh_position" [] CV7_GNSS_INS_1;
        0x82 0x02 "filter_data.ned_velocity" [] CV7_GNSS_INS_1;
        0x82 0x03 "filter_data.attitude_quaternion" [] CV7_GNSS_INS_1;
        0x82 0x04 "filter_data.attitude_dcm" [] CV7_GNSS_INS_1;
        0x82 0x05 "filter_data.euler_angles" [] CV7_GNSS_INS_1;
        0x82 0x06 "filter_data.gyro_bias" [] CV7_GNSS_INS_1;
        0x82 0x07 "filter_data.accel_bias" [] CV7_GNSS_INS_1;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x0D "filter_data.linear_accel" [] CV7_GNSS_INS_1;
        0x82 0x0E "filter_data.comp_angular_rate" [] CV7_GNSS_INS_1;
        0x82 0x10 "filter_data.status" [] CV7_GNSS_INS_1;
        0x82 0x11 "filter_data.timestamp" [] CV7_GNSS_INS_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x13 "filter_data.gravity_vector" [] CV7_GNSS_INS_1;
        0x82 0x15 "filter_data.magnetic_model" [] CV7_GNSS_INS_1;
        0x82 0x1C "filter_data.comp_accel" [] CV7_GNSS_INS_1;
        0x82 0x21 "filter_data.pressure_altitude" [] CV7_GNSS_INS_1;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CV7_GNSS_INS_1;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x40 "filter_data.ecef_position" [] CV7_GNSS_INS_1;
        0x82 0x41 "filter_data.ecef_velocity" [] CV7_GNSS_INS_1;
        0x82 0x42 "filter_data.ned_relative_position" [] CV7_GNSS_INS_1;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] CV7_GNSS_INS_1;
        0x82 0x46 "filter_data.aiding_measurement_summary" [] CV7_GNSS_INS_1;
        0x82 0x47 "filter_data.odometer_scale_factor_error" [] CV7_GNSS_INS_1;
        0x82 0x48 "filter_data.odometer_scale_factor_error_uncertainty" [] CV7_GNSS_INS_1;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CV7_GNSS_INS_1;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] CV7_GNSS_INS_1;
        0x82 0x51 "filter_data.aiding_frame_config_error_uncertainty" [] CV7_GNSS_INS_1;
        0x91 0x03 "gnss_1.llh_position" [] CV7_GNSS_INS_1;
        0x91 0x04 "gnss_1.ecef_position" [] CV7_GNSS_INS_1;
        0x91 0x05 "gnss_1.ned_velocity" [] CV7_GNSS_INS_1;
        0x91 0x06 "gnss_1.ecef_velocity" [] CV7_GNSS_INS_1;
        0x91 0x07 "gnss_1.dop" [] CV7_GNSS_INS_1;
        0x91 0x08 "gnss_1.utc_time" [] CV7_GNSS_INS_1;
        0x91 0x09 "gnss_1.gps_time" [] CV7_GNSS_INS_1;
        0x91 0x0B "gnss_1.fix_info" [] CV7_GNSS_INS_1;
        0x91 0x0D "gnss_1.hardware_status" [] CV7_GNSS_INS_1;
        0x91 0x10 "gnss_1.clock_info_2" [] CV7_GNSS_INS_1;
        0x91 0x11 "gnss_1.gps_leap_seconds" [] CV7_GNSS_INS_1;
        0x91 0x12 "gnss_1.sbas_info" [] CV7_GNSS_INS_1;
        0x91 0x20 "gnss_1.satellite_status" [] CV7_GNSS_INS_1;
        0x91 0x22 "gnss_1.raw" [] CV7_GNSS_INS_1;
        0x91 0x61 "gnss_1.gps_ephemeris" [] CV7_GNSS_INS_1;
        0x91 0x62 "gnss_1.glonass_ephemeris" [] CV7_GNSS_INS_1;
        0x91 0x63 "gnss_1.galileo_ephemeris" [] CV7_GNSS_INS_1;
        0x91 0x64 "gnss_1.beidou_ephemeris" [] CV7_GNSS_INS_1;
        0x92 0x03 "gnss_2.llh_position" [] CV7_GNSS_INS_1;
        0x92 0x04 "gnss_2.ecef_position" [] CV7_GNSS_INS_1;
        0x92 0x05 "gnss_2.ned_velocity" [] CV7_GNSS_INS_1;
        0x92 0x06 "gnss_2.ecef_velocity" [] CV7_GNSS_INS_1;
        0x92 0x07 "gnss_2.dop" [] CV7_GNSS_INS_1;
        0x92 0x08 "gnss_2.utc_time" [] CV7_GNSS_INS_1;
        0x92 0x09 "gnss_2.gps_time" [] CV7_GNSS_INS_1;
        0x92 0x0B "gnss_2.fix_info" [] CV7_GNSS_INS_1;
        0x92 0x0D "gnss_2.hardware_status" [] CV7_GNSS_INS_1;
        0x92 0x10 "gnss_2.clock_info_2" [] CV7_GNSS_INS_1;
        0x92 0x11 "gnss_2.gps_leap_seconds" [] CV7_GNSS_INS_1;
        0x92 0x12 "gnss_2.sbas_info" [] CV7_GNSS_INS_1;
        0x92 0x20 "gnss_2.satellite_status" [] CV7_GNSS_INS_1;
        0x92 0x22 "gnss_2.raw" [] CV7_GNSS_INS_1;
        0x92 0x61 "gnss_2.gps_ephemeris" [] CV7_GNSS_INS_1;
        0x92 0x62 "gnss_2.glonass_ephemeris" [] CV7_GNSS_INS_1;
        0x92 0x63 "gnss_2.galileo_ephemeris" [] CV7_GNSS_INS_1;
        0x92 0x64 "gnss_2.beidou_ephemeris" [] CV7_GNSS_INS_1;
        0x93 0x30 "gnss_corrections.base_station_info" [] CV7_GNSS_INS_1;
        0x93 0x31 "gnss_corrections.rtk_corrections_status" [] CV7_GNSS_INS_1;
        0x94 0x03 "gnss_external.llh_position" [] CV7_GNSS_INS_1;
        0x94 0x05 "gnss_external.ned_velocity" [] CV7_GNSS_INS_1;
        0x94 0x08 "gnss_external.utc_time" [] CV7_GNSS_INS_1;
        0x94 0x0B "gnss_external.fix_info" [] CV7_GNSS_INS_1;
        0x94 0x20 "gnss_external.satellite_status" [] CV7_GNSS_INS_1;
        0xA0 0x01 "system_data.built_in_test" [] CV7_GNSS_INS_1;
        0xA0 0x02 "system_data.time_sync_status" [] CV7_GNSS_INS_1;
        0xA0 0x03 "system_data.gpio_state" [] CV7_GNSS_INS_1;
        0xFF 0xD0 "shared.event_source" [] CV7_GNSS_INS_1;
        0xFF 0xD3 "shared.gps_timestamp" [] CV7_GNSS_INS_1;
        0xFF 0xD4 "shared.delta_time" [] CV7_GNSS_INS_1;
        0xFF 0xD5 "shared.reference_timestamp" [] CV7_GNSS_INS_1;
        0xFF 0xD6 "shared.reference_time_delta" [] CV7_GNSS_INS_1;
        0xFF 0xD7 "shared.external_timestamp" [] CV7_GNSS_INS_1;
        0xFF 0xD8 "shared.external_time_delta" [] CV7_GNSS_INS_1;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x91), hertz: 5.0 },
        BaseRate { set: DescriptorSet(0x92), hertz: 5.0 },
        BaseRate { set: DescriptorSet(0x93), hertz: 0.0 },
        BaseRate { set: DescriptorSet(0x94), hertz: 0.0 },
        BaseRate { set: DescriptorSet(0xA0), hertz: 1000.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP", "NMEA", "RTCM", "SPARTN"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[115200, 230400, 460800, 921600, 3000000],
            receives: &["MIP", "NMEA", "RTCM", "SPARTN"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "UART 2",
            id: Some(0x12),
            baud_rates: &[4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600],
            receives: &["MIP", "NMEA", "RTCM", "SPARTN"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "UART 3",
            id: Some(0x13),
            baud_rates: &[4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600],
            receives: &["MIP", "NMEA", "RTCM", "SPARTN"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP", "NMEA", "RTCM", "SPARTN"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "USB 2",
            id: Some(0x22),
            baud_rates: &[],
            receives: &["MIP", "NMEA", "RTCM", "SPARTN"],
            sends: &["MIP", "NMEA"],
        },
    ],
    limits: &[
        Limit {
            name: "event_triggers",
            value: 12.0,
            unit: None,
            description: "Total number of triggers.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_gpio_triggers",
            value: 4.0,
            unit: None,
            description: "Number of GPIO triggers.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_threshold_triggers",
            value: 8.0,
            unit: None,
            description: "Number of threshold triggers.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_combination_triggers",
            value: 8.0,
            unit: None,
            description: "Number of combination triggers.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_actions",
            value: 12.0,
            unit: None,
            description: "Total number of actions.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_gpio_actions",
            value: 6.0,
            unit: None,
            description: "Number of GPIO actions.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_message_actions",
            value: 8.0,
            unit: None,
            description: "Number of message actions.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "event_message_fields",
            value: 12.0,
            unit: None,
            description: "Maximum number of fields in the packet of a message action.",
            firmware: None,
        },
        Limit {
            name: "event_tick_rate",
            value: 1000.0,
            unit: Some("Hz"),
            description: "Rate of the event cycle; always the base rate of the system data set.",
            firmware: Some(">= 1.2.02"),
        },
        Limit {
            name: "gpio_pins",
            value: 4.0,
            unit: None,
            description: "Number of user GPIO pins.",
            firmware: None,
        },
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define.",
            firmware: None,
        },
        Limit {
            name: "nmea_rate",
            value: 10.0,
            unit: Some("Hz"),
            description: "Maximum rate of an NMEA sentence from the sensor or filter data set.",
            firmware: None,
        },
        Limit {
            name: "nmea_gnss_rate",
            value: 2.0,
            unit: Some("Hz"),
            description: "Maximum rate of an NMEA sentence from a GNSS set.",
            firmware: None,
        },
        Limit {
            name: "mip_input_ports",
            value: 2.0,
            unit: None,
            description: "Number of ports, besides the main port, that may accept MIP.",
            firmware: None,
        },
        Limit {
            name: "nmea_input_ports",
            value: 1.0,
            unit: None,
            description: "Number of ports that may accept NMEA.",
            firmware: None,
        },
        Limit {
            name: "rtcm_input_ports",
            value: 1.0,
            unit: None,
            description: "Number of ports that may accept RTCM.",
            firmware: None,
        },
        Limit {
            name: "spartn_input_ports",
            value: 1.0,
            unit: None,
            description: "Number of ports that may accept SPARTN.",
            firmware: None,
        },
        Limit {
            name: "baud_rate_delay",
            value: 250.0,
            unit: Some("ms"),
            description: "Time to wait after a baud rate change.",
            firmware: None,
        },
        Limit {
            name: "time_update_window",
            value: 250.0,
            unit: Some("ms"),
            description: "Time after the rising edge of the PPS within which the GPS time update must arrive.",
            firmware: None,
        },
        Limit {
            name: "save_time",
            value: 1.0,
            unit: Some("s"),
            description: "Maximum duration of saving all settings.",
            firmware: None,
        },
        Limit {
            name: "motion_latency",
            value: 1.9,
            unit: Some("ms"),
            description: "Typical time from a motion to the message that reports it, not including transmission.",
            firmware: None,
        },
        Limit {
            name: "timestamp_repeatability",
            value: 1.0,
            unit: Some("us"),
            description: "Upper bound of the typical variation of sensor timestamps due to internal processing.",
            firmware: None,
        },
        Limit {
            name: "gpio_timestamp_accuracy",
            value: 1.0,
            unit: Some("us"),
            description: "Upper bound of the error of GPIO timestamps; the error is far smaller.",
            firmware: None,
        },
        Limit {
            name: "antenna_offset_error",
            value: 0.5,
            unit: Some("m"),
            description: "Upper limit of the maximum offset in the antenna lever arm calibration.",
            firmware: None,
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

#[rustfmt::skip]
const CV7_INS_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_2: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7-INS Documentation: Field pages).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_3: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-CV7-INS Documentation: Index of the set 0x94, on a test site).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_4: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_5: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_6: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (PX4: Driver of the vendor's sensors).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_7: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_8: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_9: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (Public programs of users: Notes on a 3DM-CV7-INS, 2026).",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_10: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const CV7_INS_11: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CV7_INS_12: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CV7-INS
///
/// Inertial navigation system without an internal GNSS receiver.
///
/// Generation 7. Model number 6291. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7-INS
/// Documentation, online, known from some pages. This profile is incomplete: Only some pages of its
/// manual are known; the device has further commands and data. This profile is incomplete: It has
/// the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF. Uncertain: Only a test site of the vendor
/// names the set 0x95. Uncertain: The base rate of the set 0x94 is inferred from the
/// 3DM-CV7-GNSS/INS.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the
/// pins GPIO 1 and 2, UART 3 on GPIO 3 and 4.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp, UART 2 |
/// | 2 | GPIO, PPS, timestamp, UART 2 |
/// | 3 | GPIO, PPS, timestamp, UART 3, encoder A |
/// | 4 | GPIO, PPS, timestamp, UART 3, encoder B |
///
/// # GNSS sets
///
/// The sets 0x94 and 0x95 contain the data of two external receivers.
#[rustfmt::skip]
pub static CV7_INS: Profile = Profile {
    id: "3dm-cv7-ins",
    title: "3DM-CV7-INS",
    description: "Inertial navigation system without an internal GNSS receiver.",
    also: &[],
    model_number: Some(6291),
    generation: Some(7),
    manual: Some("3dm-cv7-ins"),
    incomplete: &[
        "Only some pages of its manual are known; the device has further commands and data.",
        "It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CV7_INS_4;
        0x01 0x02 "base.set_idle" [] CV7_INS_4;
        0x01 0x03 "base.get_device_info" [] CV7_INS_4;
        0x01 0x04 "base.get_device_descriptors" [] CV7_INS_6;
        0x01 0x05 "base.built_in_test" [] CV7_INS_10;
        0x01 0x06 "base.resume" [] CV7_INS_4;
        0x01 0x07 "base.get_extended_descriptors" [] CV7_INS_6;
        0x01 0x08 "base.continuous_built_in_test" [] CV7_INS_10;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_7;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CV7_INS_10;
        0x01 0x7E "base.soft_reset" [] CV7_INS_10;
        0x0C 0x04 "3dm.poll_nmea_data" [] CV7_INS_10;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x0D "3dm.poll_data" [] CV7_INS_10;
        0x0C 0x0E "3dm.get_base_rate" [] CV7_INS_4;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_4;
        0x0C 0x10 "3dm.factory_streaming" [] CV7_INS_10;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_6;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_7;
        0x0C 0x2A "3dm.get_event_support" [] CV7_INS_10;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CV7_INS_10;
        0x0C 0x2D "3dm.get_event_action_status" [] CV7_INS_10;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CV7_INS_4;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_6;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV7_INS_10;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CV7_INS_10;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CV7_INS_4;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] CV7_INS_10;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] CV7_INS_10;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_7;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CV7_INS_7;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_6;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CV7_INS_10;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0D 0x01 "filter.reset" [] CV7_INS_4;
        0x0D 0x03 "filter.set_initial_heading" [] CV7_INS_10;
        0x0D 0x05 "filter.run" [] CV7_INS_10;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_1;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_6;
        0x0D 0x17 "filter.external_heading_update" [] CV7_INS_10;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CV7_INS_10;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_1;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_7;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_4;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_2;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_8;
        0x0D 0x55 "filter.relative_position_config" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_7;
        0x0D 0x56 "filter.reference_point_lever_arm" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_2;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CV7_INS_10;
        0x13 0x21 "aiding.ecef_position" [] CV7_INS_10;
        0x13 0x22 "aiding.llh_position" [] CV7_INS_4;
        0x13 0x23 "aiding.height_above_ellipsoid" [] CV7_INS_10;
        0x13 0x28 "aiding.ecef_velocity" [] CV7_INS_10;
        0x13 0x29 "aiding.ned_velocity" [] CV7_INS_4;
        0x13 0x2A "aiding.body_frame_velocity" [] CV7_INS_4;
        0x13 0x31 "aiding.true_heading" [] CV7_INS_4;
        0x13 0x32 "aiding.magnetic_field" [] CV7_INS_10;
        0x13 0x33 "aiding.pressure" [] CV7_INS_10;
        0x80 0x04 "sensor.scaled_accel" [] CV7_INS_9;
        0x80 0x05 "sensor.scaled_gyro" [] CV7_INS_9;
        0x80 0x06 "sensor.scaled_mag" [] CV7_INS_6;
        0x80 0x07 "sensor.delta_theta" [] CV7_INS_10;
        0x80 0x08 "sensor.delta_velocity" [] CV7_INS_10;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CV7_INS_10;
        0x80 0x0A "sensor.comp_quaternion" [] CV7_INS_10;
        0x80 0x0C "sensor.comp_euler_angles" [] CV7_INS_10;
        0x80 0x14 "sensor.temperature_statistics" [] CV7_INS_10;
        0x80 0x17 "sensor.scaled_pressure" [] CV7_INS_6;
        0x80 0x18 "sensor.overrange_status" [] CV7_INS_10;
        0x82 0x01 "filter_data.llh_position" [] CV7_INS_5;
        0x82 0x02 "filter_data.ned_velocity" [] CV7_INS_5;
        0x82 0x03 "filter_data.attitude_quaternion" [] CV7_INS_6;
        0x82 0x04 "filter_data.attitude_dcm" [] CV7_INS_10;
        0x82 0x05 "filter_data.euler_angles" [] CV7_INS_5;
        0x82 0x06 "filter_data.gyro_bias" [] CV7_INS_10;
        0x82 0x07 "filter_data.accel_bias" [] CV7_INS_10;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] CV7_INS_6;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] CV7_INS_6;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CV7_INS_6;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CV7_INS_10;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] CV7_INS_10;
        0x82 0x0D "filter_data.linear_accel" [] CV7_INS_6;
        0x82 0x0E "filter_data.comp_angular_rate" [] CV7_INS_6;
        0x82 0x10 "filter_data.status" [] CV7_INS_5;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CV7_INS_10;
        0x82 0x13 "filter_data.gravity_vector" [] CV7_INS_10;
        0x82 0x15 "filter_data.magnetic_model" [] CV7_INS_10;
        0x82 0x1C "filter_data.comp_accel" [] CV7_INS_10;
        0x82 0x21 "filter_data.pressure_altitude" [] CV7_INS_10;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] CV7_INS_7;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] CV7_INS_10;
        0x82 0x40 "filter_data.ecef_position" [] CV7_INS_7;
        0x82 0x41 "filter_data.ecef_velocity" [] CV7_INS_10;
        0x82 0x42 "filter_data.ned_relative_position" [] CV7_INS_7;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] CV7_INS_10;
        0x82 0x46 "filter_data.aiding_measurement_summary" [] CV7_INS_7;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] CV7_INS_2;
        0x82 0x51 "filter_data.aiding_frame_config_error_uncertainty" [] CV7_INS_10;
        0x94 0x03 "gnss_external.llh_position" [] CV7_INS_3;
        0x94 0x04 "gnss_external.ecef_position" [] CV7_INS_3;
        0x94 0x05 "gnss_external.ned_velocity" [] CV7_INS_3;
        0x94 0x06 "gnss_external.ecef_velocity" [] CV7_INS_3;
        0x94 0x07 "gnss_external.dop" [] CV7_INS_3;
        0x94 0x08 "gnss_external.utc_time" [] CV7_INS_3;
        0x94 0x0B "gnss_external.fix_info" [] CV7_INS_3;
        0x94 0x10 "gnss_external.clock_info_2" [] CV7_INS_3;
        0x94 0x11 "gnss_external.gps_leap_seconds" [] CV7_INS_3;
        0x94 0x14 "gnss_external.rf_error_detection" [] CV7_INS_3;
        0x94 0x20 "gnss_external.satellite_status" [] CV7_INS_3;
        0xA0 0x01 "system_data.built_in_test" [] CV7_INS_10;
        0xA0 0x02 "system_data.time_sync_status" [] CV7_INS_5;
        0xA0 0x03 "system_data.gpio_state" [] CV7_INS_10;
        0xFF 0xD0 "shared.event_source" [] CV7_INS_10;
        0xFF 0xD3 "shared.gps_timestamp" [] CV7_INS_5;
        0xFF 0xD4 "shared.delta_time" [] CV7_INS_10;
        0xFF 0xD5 "shared.reference_timestamp" [] CV7_INS_10;
        0xFF 0xD6 "shared.reference_time_delta" [] CV7_INS_10;
        0xFF 0xD7 "shared.external_timestamp" [] CV7_INS_10;
        0xFF 0xD8 "shared.external_time_delta" [] CV7_INS_10;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CV7_INS_11;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CV7_INS_11;
        0x0C 0x09 "3dm.gnss_message_format" [] CV7_INS_11;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CV7_INS_11;
        0x0C 0x21 "3dm.constellation_settings" [] CV7_INS_11;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CV7_INS_11;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CV7_INS_11;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CV7_INS_11;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CV7_INS_11;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CV7_INS_11;
        0x0D 0x54 "filter.multi_antenna_offset" [] CV7_INS_11;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CV7_INS_11;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CV7_INS_11;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CV7_INS_11;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CV7_INS_12;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CV7_INS_11 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CV7_INS_11 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CV7_INS_11 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CV7_INS_11 },
    ],
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x94), hertz: 0.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 2",
            id: Some(0x12),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 3",
            id: Some(0x13),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
        Limit {
            name: "antenna_offset",
            value: 10.0,
            unit: Some("m"),
            description: "Maximum distance of the antenna from the device.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1, uart_2, uart_3 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1, uart_2, uart_3 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only external",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only gnss_position_velocity, altimeter, mag, external_heading, external_altimeter, external_mag, body_frame_velocity and all",
        },
        Variant {
            parameter: "filter.initialization_config.auto_heading_alignment_selector",
            read_as: None,
            difference: "only kinematic, mag and external",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX5_10_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (3DM-CX5-10 Data Communications Protocol Manual: Contents).",
    absence: "",
};
#[rustfmt::skip]
const CX5_10_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_10_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-CX5-10.",
    absence: "",
};
#[rustfmt::skip]
const CX5_10_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Not in the manual, whose list of the set is complete.",
    absence: "",
};
#[rustfmt::skip]
const CX5_10_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CX5_10_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const CX5_10_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a pressure sensor, which the device lacks.",
    absence: "has no pressure sensor",
};

/// 3DM-CX5-10
///
/// Inertial measurement unit.
///
/// Also called 3DM-CX5-IMU. Generation 5. Model number 6275. Sensors: accelerometer, gyroscope.
/// GNSS receivers: none. GNSS antennas: none. Sets known completely from the manual: base (0x01).
/// Manual: 3DM-CX5-10 Data Communications Protocol Manual, 8500-0087 revision A, 2017, known from
/// its contents. This profile is incomplete: Of the manual, only the table of contents is known, up
/// to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`. Uncertain: The sensors are
/// inferred from the name of the model; that it has no magnetometer also from MSCL, which offers it
/// no north compensation.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
    manual: Some("3dm-cx5-10"),
    incomplete: &[
        "Of the manual, only the table of contents is known, up to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX5_10_1;
        0x01 0x02 "base.set_idle" [] CX5_10_1;
        0x01 0x03 "base.get_device_info" [] CX5_10_1;
        0x01 0x04 "base.get_device_descriptors" [] CX5_10_1;
        0x01 0x05 "base.built_in_test" [] CX5_10_1;
        0x01 0x06 "base.resume" [] CX5_10_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX5_10_1;
        0x01 0x7E "base.soft_reset" [] CX5_10_1;
        0x0C 0x01 "3dm.poll_imu_data" [] CX5_10_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CX5_10_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_10_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX5_10_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX5_10_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_10_3;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_10_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX5_10_3;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CX5_10_3;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CX5_10_3;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_10_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_10_3;
        0x0C 0x64 "3dm.device_status" [] CX5_10_3;
        0x80 0x04 "sensor.scaled_accel" [] CX5_10_2;
        0x80 0x05 "sensor.scaled_gyro" [] CX5_10_2;
        0x80 0x07 "sensor.delta_theta" [] CX5_10_3;
        0x80 0x08 "sensor.delta_velocity" [] CX5_10_3;
        0x80 0x12 "sensor.gps_timestamp" [] CX5_10_3;
    },
    refuses: supported! {
        0x01 0x07 "base.get_extended_descriptors" [] CX5_10_4;
        0x01 0x08 "base.continuous_built_in_test" [] CX5_10_4;
        0x01 0x09 "base.comm_speed" [] CX5_10_4;
        0x0C 0x02 "3dm.poll_gnss_data" [] CX5_10_5;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX5_10_5;
        0x0C 0x09 "3dm.gnss_message_format" [] CX5_10_5;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CX5_10_5;
        0x0C 0x21 "3dm.constellation_settings" [] CX5_10_5;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CX5_10_5;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CX5_10_5;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CX5_10_5;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CX5_10_5;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] CX5_10_6;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] CX5_10_6;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CX5_10_5;
        0x80 0x03 "sensor.raw_mag" [] CX5_10_6;
        0x80 0x06 "sensor.scaled_mag" [] CX5_10_6;
        0x80 0x16 "sensor.raw_pressure" [] CX5_10_7;
        0x80 0x17 "sensor.scaled_pressure" [] CX5_10_7;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CX5_10_5 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CX5_10_5 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CX5_10_5 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CX5_10_5 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL has no support for it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX5_15_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CX5_15_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_15_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_15_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15.",
    absence: "",
};
#[rustfmt::skip]
const CX5_15_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CX5_15_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const CX5_15_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CX5-15
///
/// Attitude reference.
///
/// Also called 3DM-CX5-AR. Generation 5. Model number 6274. Sensors: accelerometer, gyroscope,
/// pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
/// incomplete: No manual is known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX5_15_1;
        0x01 0x02 "base.set_idle" [] CX5_15_1;
        0x01 0x03 "base.get_device_info" [] CX5_15_2;
        0x01 0x04 "base.get_device_descriptors" [] CX5_15_3;
        0x01 0x05 "base.built_in_test" [] CX5_15_4;
        0x01 0x06 "base.resume" [] CX5_15_1;
        0x01 0x07 "base.get_extended_descriptors" [] CX5_15_3;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX5_15_4;
        0x01 0x7E "base.soft_reset" [] CX5_15_4;
        0x0C 0x01 "3dm.poll_imu_data" [] CX5_15_4;
        0x0C 0x03 "3dm.poll_filter_data" [] CX5_15_4;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CX5_15_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_15_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_15_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] CX5_15_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX5_15_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_15_4;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_15_4;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX5_15_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0C 0x64 "3dm.device_status" [] CX5_15_4;
        0x0D 0x01 "filter.reset" [] CX5_15_2;
        0x0D 0x02 "filter.set_initial_attitude" [] CX5_15_4;
        0x0D 0x03 "filter.set_initial_heading" [] CX5_15_4;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] CX5_15_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x17 "filter.external_heading_update" [] CX5_15_4;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] CX5_15_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CX5_15_4;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x23 "filter.commanded_angular_zupt" [] CX5_15_4;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] CX5_15_4;
        0x80 0x04 "sensor.scaled_accel" [] CX5_15_1;
        0x80 0x05 "sensor.scaled_gyro" [] CX5_15_1;
        0x80 0x07 "sensor.delta_theta" [] CX5_15_4;
        0x80 0x08 "sensor.delta_velocity" [] CX5_15_4;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CX5_15_4;
        0x80 0x0A "sensor.comp_quaternion" [] CX5_15_4;
        0x80 0x0C "sensor.comp_euler_angles" [] CX5_15_4;
        0x80 0x10 "sensor.north_vector" [] CX5_15_4;
        0x80 0x11 "sensor.up_vector" [] CX5_15_4;
        0x80 0x12 "sensor.gps_timestamp" [] CX5_15_1;
        0x80 0x17 "sensor.scaled_pressure" [] CX5_15_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] CX5_15_4;
        0x82 0x04 "filter_data.attitude_dcm" [] CX5_15_4;
        0x82 0x05 "filter_data.euler_angles" [] CX5_15_1;
        0x82 0x06 "filter_data.gyro_bias" [] CX5_15_4;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CX5_15_4;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CX5_15_4;
        0x82 0x0D "filter_data.linear_accel" [] CX5_15_4;
        0x82 0x0E "filter_data.comp_angular_rate" [] CX5_15_1;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] CX5_15_4;
        0x82 0x10 "filter_data.status" [] CX5_15_1;
        0x82 0x11 "filter_data.timestamp" [] CX5_15_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CX5_15_4;
        0x82 0x13 "filter_data.gravity_vector" [] CX5_15_4;
        0x82 0x14 "filter_data.heading_update_state" [] CX5_15_4;
        0x82 0x1C "filter_data.comp_accel" [] CX5_15_1;
        0x82 0x21 "filter_data.pressure_altitude" [] CX5_15_4;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CX5_15_5;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX5_15_5;
        0x0C 0x09 "3dm.gnss_message_format" [] CX5_15_5;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CX5_15_5;
        0x0C 0x21 "3dm.constellation_settings" [] CX5_15_5;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CX5_15_5;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CX5_15_5;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CX5_15_5;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CX5_15_5;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] CX5_15_6;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] CX5_15_6;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CX5_15_5;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] CX5_15_6;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] CX5_15_6;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] CX5_15_6;
        0x0D 0x42 "filter.mag_noise" [] CX5_15_6;
        0x0D 0x43 "filter.magnetic_declination_source" [] CX5_15_6;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] CX5_15_6;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] CX5_15_6;
        0x0D 0x4C "filter.magnetic_inclination_source" [] CX5_15_6;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] CX5_15_6;
        0x0D 0x54 "filter.multi_antenna_offset" [] CX5_15_5;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CX5_15_5;
        0x80 0x03 "sensor.raw_mag" [] CX5_15_6;
        0x80 0x06 "sensor.scaled_mag" [] CX5_15_6;
        0x82 0x1A "filter_data.mag_bias" [] CX5_15_6;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] CX5_15_6;
        0x82 0x25 "filter_data.mag_offset" [] CX5_15_6;
        0x82 0x26 "filter_data.mag_matrix" [] CX5_15_6;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CX5_15_6;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CX5_15_6;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] CX5_15_6;
        0x82 0x2C "filter_data.mag_residual_vector" [] CX5_15_6;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CX5_15_5;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CX5_15_5;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CX5_15_7;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CX5_15_5 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CX5_15_5 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CX5_15_5 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CX5_15_5 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.complementary_filter.heading_enable",
            read_as: None,
            difference: "MSCL has no support for it",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only external",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX5_25_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (3DM-CX5-25 Data Communications Protocol Manual: Title).",
    absence: "",
};
#[rustfmt::skip]
const CX5_25_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CX5_25_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_25_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_25_5: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
    absence: "",
};
#[rustfmt::skip]
const CX5_25_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CX5_25_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CX5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-CX5-AHRS. Generation 5. Model number 6273. Sensors: accelerometer, gyroscope,
/// magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. Manual: 3DM-CX5-25
/// Data Communications Protocol Manual, 8500-0085 revision A, 2017, known from its title. This
/// profile is incomplete: Of the manual, only the title is known. It has 149 pages.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
    manual: Some("3dm-cx5-25"),
    incomplete: &[
        "Of the manual, only the title is known. It has 149 pages.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX5_25_2;
        0x01 0x02 "base.set_idle" [] CX5_25_2;
        0x01 0x03 "base.get_device_info" [] CX5_25_3;
        0x01 0x04 "base.get_device_descriptors" [] CX5_25_4;
        0x01 0x05 "base.built_in_test" [] CX5_25_5;
        0x01 0x06 "base.resume" [] CX5_25_2;
        0x01 0x07 "base.get_extended_descriptors" [] CX5_25_4;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX5_25_5;
        0x01 0x7E "base.soft_reset" [] CX5_25_5;
        0x0C 0x01 "3dm.poll_imu_data" [] CX5_25_5;
        0x0C 0x03 "3dm.poll_filter_data" [] CX5_25_5;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CX5_25_2;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_25_2;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_25_2;
        0x0C 0x0B "3dm.get_filter_base_rate" [] CX5_25_2;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX5_25_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_25_5;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_25_5;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX5_25_2;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_25_5;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_25_5;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0C 0x64 "3dm.device_status" [] CX5_25_5;
        0x0D 0x01 "filter.reset" [] CX5_25_3;
        0x0D 0x02 "filter.set_initial_attitude" [] CX5_25_5;
        0x0D 0x03 "filter.set_initial_heading" [] CX5_25_5;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] CX5_25_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x17 "filter.external_heading_update" [] CX5_25_5;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] CX5_25_3;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] CX5_25_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CX5_25_5;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CX5_25_1;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] CX5_25_1;
        0x0D 0x23 "filter.commanded_angular_zupt" [] CX5_25_5;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [WRITE SAVE] CX5_25_5;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x29 "filter.pressure_altitude_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x2B "filter.hard_iron_offset_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x47 "filter.altitude_aiding" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] CX5_25_5;
        0x80 0x04 "sensor.scaled_accel" [] CX5_25_2;
        0x80 0x05 "sensor.scaled_gyro" [] CX5_25_2;
        0x80 0x06 "sensor.scaled_mag" [] CX5_25_5;
        0x80 0x07 "sensor.delta_theta" [] CX5_25_5;
        0x80 0x08 "sensor.delta_velocity" [] CX5_25_5;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CX5_25_5;
        0x80 0x0A "sensor.comp_quaternion" [] CX5_25_5;
        0x80 0x0C "sensor.comp_euler_angles" [] CX5_25_5;
        0x80 0x10 "sensor.north_vector" [] CX5_25_5;
        0x80 0x11 "sensor.up_vector" [] CX5_25_5;
        0x80 0x12 "sensor.gps_timestamp" [] CX5_25_2;
        0x80 0x17 "sensor.scaled_pressure" [] CX5_25_5;
        0x82 0x03 "filter_data.attitude_quaternion" [] CX5_25_5;
        0x82 0x04 "filter_data.attitude_dcm" [] CX5_25_5;
        0x82 0x05 "filter_data.euler_angles" [] CX5_25_2;
        0x82 0x06 "filter_data.gyro_bias" [] CX5_25_5;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CX5_25_5;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CX5_25_5;
        0x82 0x0D "filter_data.linear_accel" [] CX5_25_5;
        0x82 0x0E "filter_data.comp_angular_rate" [] CX5_25_2;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] CX5_25_5;
        0x82 0x10 "filter_data.status" [] CX5_25_2;
        0x82 0x11 "filter_data.timestamp" [] CX5_25_2;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CX5_25_5;
        0x82 0x13 "filter_data.gravity_vector" [] CX5_25_5;
        0x82 0x14 "filter_data.heading_update_state" [] CX5_25_5;
        0x82 0x15 "filter_data.magnetic_model" [] CX5_25_5;
        0x82 0x1C "filter_data.comp_accel" [] CX5_25_2;
        0x82 0x21 "filter_data.pressure_altitude" [] CX5_25_5;
        0x82 0x25 "filter_data.mag_offset" [] CX5_25_5;
        0x82 0x26 "filter_data.mag_matrix" [] CX5_25_5;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CX5_25_5;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CX5_25_5;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CX5_25_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX5_25_6;
        0x0C 0x09 "3dm.gnss_message_format" [] CX5_25_6;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CX5_25_6;
        0x0C 0x21 "3dm.constellation_settings" [] CX5_25_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CX5_25_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CX5_25_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CX5_25_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CX5_25_6;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CX5_25_6;
        0x0D 0x54 "filter.multi_antenna_offset" [] CX5_25_6;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CX5_25_6;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CX5_25_6;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CX5_25_6;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CX5_25_7;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CX5_25_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CX5_25_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CX5_25_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CX5_25_6 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
        Variant {
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only mag and external",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX5_45_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (3DM-CX5-45 Data Communications Protocol Manual: Title).",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_4: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ArduPilot: AP_ExternalAHRS_MicroStrain5).",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_5: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_6: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-45.",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_7: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
    absence: "",
};
#[rustfmt::skip]
const CX5_45_8: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const CX5_45_9: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-CX5-45
///
/// Inertial navigation system with GNSS.
///
/// Also called 3DM-CX5-GNSS/INS. Generation 5. Model number 6271. Sensors: accelerometer,
/// gyroscope, magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual:
/// 3DM-CX5-45 Data Communications Protocol Manual, 8500-0089 revision A, 2017, known from its
/// title. This profile is incomplete: Of the manual, only the title is known. It has 196 pages, and
/// describes the data from page 131.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
    manual: Some("3dm-cx5-45"),
    incomplete: &[
        "Of the manual, only the title is known. It has 196 pages, and describes the data from page 131.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX5_45_2;
        0x01 0x02 "base.set_idle" [] CX5_45_2;
        0x01 0x03 "base.get_device_info" [] CX5_45_3;
        0x01 0x04 "base.get_device_descriptors" [] CX5_45_5;
        0x01 0x05 "base.built_in_test" [] CX5_45_6;
        0x01 0x06 "base.resume" [] CX5_45_2;
        0x01 0x07 "base.get_extended_descriptors" [] CX5_45_5;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX5_45_6;
        0x01 0x7E "base.soft_reset" [] CX5_45_6;
        0x0C 0x01 "3dm.poll_imu_data" [] CX5_45_6;
        0x0C 0x02 "3dm.poll_gnss_data" [] CX5_45_6;
        0x0C 0x03 "3dm.poll_filter_data" [] CX5_45_6;
        0x0C 0x06 "3dm.get_imu_base_rate" [] CX5_45_2;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX5_45_3;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0C 0x0B "3dm.get_filter_base_rate" [] CX5_45_2;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [WRITE READ] CX5_45_6;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX5_45_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_45_6;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_45_6;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX5_45_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_45_6;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] CX5_45_6;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0C 0x64 "3dm.device_status" [] CX5_45_6;
        0x0D 0x01 "filter.reset" [] CX5_45_2;
        0x0D 0x02 "filter.set_initial_attitude" [] CX5_45_6;
        0x0D 0x03 "filter.set_initial_heading" [] CX5_45_6;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x16 "filter.external_gnss_update" [] CX5_45_6;
        0x0D 0x17 "filter.external_heading_update" [] CX5_45_6;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] CX5_45_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CX5_45_6;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x22 "filter.commanded_zupt" [] CX5_45_6;
        0x0D 0x23 "filter.commanded_angular_zupt" [] CX5_45_6;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [WRITE SAVE] CX5_45_6;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x29 "filter.pressure_altitude_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x2B "filter.hard_iron_offset_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x47 "filter.altitude_aiding" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] CX5_45_6;
        0x80 0x04 "sensor.scaled_accel" [] CX5_45_1;
        0x80 0x05 "sensor.scaled_gyro" [] CX5_45_1;
        0x80 0x06 "sensor.scaled_mag" [] CX5_45_1;
        0x80 0x07 "sensor.delta_theta" [] CX5_45_6;
        0x80 0x08 "sensor.delta_velocity" [] CX5_45_6;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CX5_45_6;
        0x80 0x0A "sensor.comp_quaternion" [] CX5_45_4;
        0x80 0x0C "sensor.comp_euler_angles" [] CX5_45_6;
        0x80 0x10 "sensor.north_vector" [] CX5_45_6;
        0x80 0x11 "sensor.up_vector" [] CX5_45_6;
        0x80 0x12 "sensor.gps_timestamp" [] CX5_45_2;
        0x80 0x17 "sensor.scaled_pressure" [] CX5_45_4;
        0x81 0x03 "gnss_data.llh_position" [] CX5_45_4;
        0x81 0x04 "gnss_data.ecef_position" [] CX5_45_6;
        0x81 0x05 "gnss_data.ned_velocity" [] CX5_45_4;
        0x81 0x06 "gnss_data.ecef_velocity" [] CX5_45_6;
        0x81 0x07 "gnss_data.dop" [] CX5_45_4;
        0x81 0x08 "gnss_data.utc_time" [] CX5_45_6;
        0x81 0x09 "gnss_data.gps_time" [] CX5_45_6;
        0x81 0x0A "gnss_data.clock_info" [] CX5_45_6;
        0x81 0x0B "gnss_data.fix_info" [] CX5_45_2;
        0x81 0x0C "gnss_data.sv_info" [] CX5_45_6;
        0x81 0x0D "gnss_data.hardware_status" [] CX5_45_6;
        0x81 0x0E "gnss_data.dgps_info" [] CX5_45_6;
        0x81 0x0F "gnss_data.dgps_channel" [] CX5_45_6;
        0x82 0x01 "filter_data.llh_position" [] CX5_45_2;
        0x82 0x02 "filter_data.ned_velocity" [] CX5_45_2;
        0x82 0x03 "filter_data.attitude_quaternion" [] CX5_45_4;
        0x82 0x04 "filter_data.attitude_dcm" [] CX5_45_6;
        0x82 0x05 "filter_data.euler_angles" [] CX5_45_2;
        0x82 0x06 "filter_data.gyro_bias" [] CX5_45_7;
        0x82 0x07 "filter_data.accel_bias" [] CX5_45_7;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] CX5_45_7;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] CX5_45_7;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CX5_45_7;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CX5_45_7;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] CX5_45_7;
        0x82 0x0D "filter_data.linear_accel" [] CX5_45_7;
        0x82 0x0E "filter_data.comp_angular_rate" [] CX5_45_6;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] CX5_45_7;
        0x82 0x10 "filter_data.status" [] CX5_45_2;
        0x82 0x11 "filter_data.timestamp" [] CX5_45_2;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CX5_45_7;
        0x82 0x13 "filter_data.gravity_vector" [] CX5_45_7;
        0x82 0x14 "filter_data.heading_update_state" [] CX5_45_6;
        0x82 0x15 "filter_data.magnetic_model" [] CX5_45_7;
        0x82 0x1C "filter_data.comp_accel" [] CX5_45_7;
        0x82 0x20 "filter_data.standard_atmosphere" [] CX5_45_7;
        0x82 0x21 "filter_data.pressure_altitude" [] CX5_45_7;
        0x82 0x25 "filter_data.mag_offset" [] CX5_45_7;
        0x82 0x26 "filter_data.mag_matrix" [] CX5_45_7;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CX5_45_7;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CX5_45_7;
    },
    refuses: supported! {
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CX5_45_8;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: CX5_45_9 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "filter.antenna_offset.offset",
            read_as: None,
            difference: "frame sensor (inferred: the manual of the 3DM-GX5-45 states it)",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal, external and internal_1",
        },
        Variant {
            parameter: "filter.antenna_offset_response.offset",
            read_as: None,
            difference: "frame sensor (inferred: the manual of the 3DM-GX5-45 states it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX7_AHRS_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const CX7_AHRS_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX7_AHRS_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const CX7_AHRS_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CX7_AHRS_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CX7-AHRS
///
/// Attitude and heading reference system.
///
/// Generation 7. Model number 6701. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
/// incomplete: No manual is known. Uncertain: Only MSCL lists it; the SDK does not.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp |
/// | 2 | GPIO, PPS, timestamp |
/// | 3 | GPIO, PPS, timestamp |
/// | 4 | GPIO, PPS, timestamp |
#[rustfmt::skip]
pub static CX7_AHRS: Profile = Profile {
    id: "3dm-cx7-ahrs",
    title: "3DM-CX7-AHRS",
    description: "Attitude and heading reference system.",
    also: &[],
    model_number: Some(6701),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX7_AHRS_2;
        0x01 0x02 "base.set_idle" [] CX7_AHRS_2;
        0x01 0x03 "base.get_device_info" [] CX7_AHRS_2;
        0x01 0x04 "base.get_device_descriptors" [] CX7_AHRS_2;
        0x01 0x05 "base.built_in_test" [] CX7_AHRS_3;
        0x01 0x06 "base.resume" [] CX7_AHRS_2;
        0x01 0x07 "base.get_extended_descriptors" [] CX7_AHRS_2;
        0x01 0x08 "base.continuous_built_in_test" [] CX7_AHRS_3;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX7_AHRS_3;
        0x01 0x7E "base.soft_reset" [] CX7_AHRS_3;
        0x0C 0x0D "3dm.poll_data" [] CX7_AHRS_3;
        0x0C 0x0E "3dm.get_base_rate" [] CX7_AHRS_2;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_2;
        0x0C 0x10 "3dm.factory_streaming" [] CX7_AHRS_3;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_1;
        0x0C 0x2A "3dm.get_event_support" [] CX7_AHRS_3;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CX7_AHRS_3;
        0x0C 0x2D "3dm.get_event_action_status" [] CX7_AHRS_3;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX7_AHRS_2;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_AHRS_3;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_AHRS_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX7_AHRS_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_AHRS_3;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_AHRS_3;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_1;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CX7_AHRS_3;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CX7_AHRS_3;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0D 0x01 "filter.reset" [] CX7_AHRS_3;
        0x0D 0x03 "filter.set_initial_heading" [] CX7_AHRS_3;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_1;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_1;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_1;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AHRS_3;
        0x13 0x31 "aiding.true_heading" [] CX7_AHRS_3;
        0x13 0x32 "aiding.magnetic_field" [] CX7_AHRS_3;
        0x80 0x04 "sensor.scaled_accel" [] CX7_AHRS_3;
        0x80 0x05 "sensor.scaled_gyro" [] CX7_AHRS_3;
        0x80 0x06 "sensor.scaled_mag" [] CX7_AHRS_3;
        0x80 0x07 "sensor.delta_theta" [] CX7_AHRS_3;
        0x80 0x08 "sensor.delta_velocity" [] CX7_AHRS_3;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CX7_AHRS_3;
        0x80 0x0A "sensor.comp_quaternion" [] CX7_AHRS_3;
        0x80 0x0C "sensor.comp_euler_angles" [] CX7_AHRS_3;
        0x80 0x14 "sensor.temperature_statistics" [] CX7_AHRS_3;
        0x80 0x17 "sensor.scaled_pressure" [] CX7_AHRS_3;
        0x80 0x18 "sensor.overrange_status" [] CX7_AHRS_3;
        0x82 0x03 "filter_data.attitude_quaternion" [] CX7_AHRS_3;
        0x82 0x04 "filter_data.attitude_dcm" [] CX7_AHRS_3;
        0x82 0x05 "filter_data.euler_angles" [] CX7_AHRS_3;
        0x82 0x06 "filter_data.gyro_bias" [] CX7_AHRS_3;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CX7_AHRS_3;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CX7_AHRS_3;
        0x82 0x0D "filter_data.linear_accel" [] CX7_AHRS_3;
        0x82 0x0E "filter_data.comp_angular_rate" [] CX7_AHRS_3;
        0x82 0x10 "filter_data.status" [] CX7_AHRS_3;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CX7_AHRS_3;
        0x82 0x13 "filter_data.gravity_vector" [] CX7_AHRS_3;
        0x82 0x1C "filter_data.comp_accel" [] CX7_AHRS_3;
        0x82 0x21 "filter_data.pressure_altitude" [] CX7_AHRS_3;
        0xA0 0x01 "system_data.built_in_test" [] CX7_AHRS_3;
        0xA0 0x02 "system_data.time_sync_status" [] CX7_AHRS_3;
        0xA0 0x03 "system_data.gpio_state" [] CX7_AHRS_3;
        0xFF 0xD0 "shared.event_source" [] CX7_AHRS_3;
        0xFF 0xD3 "shared.gps_timestamp" [] CX7_AHRS_3;
        0xFF 0xD4 "shared.delta_time" [] CX7_AHRS_3;
        0xFF 0xD5 "shared.reference_timestamp" [] CX7_AHRS_3;
        0xFF 0xD6 "shared.reference_time_delta" [] CX7_AHRS_3;
        0xFF 0xD7 "shared.external_timestamp" [] CX7_AHRS_3;
        0xFF 0xD8 "shared.external_time_delta" [] CX7_AHRS_3;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CX7_AHRS_4;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX7_AHRS_4;
        0x0C 0x09 "3dm.gnss_message_format" [] CX7_AHRS_4;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CX7_AHRS_4;
        0x0C 0x21 "3dm.constellation_settings" [] CX7_AHRS_4;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CX7_AHRS_4;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CX7_AHRS_4;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CX7_AHRS_4;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CX7_AHRS_4;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CX7_AHRS_4;
        0x0D 0x54 "filter.multi_antenna_offset" [] CX7_AHRS_4;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CX7_AHRS_4;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CX7_AHRS_4;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CX7_AHRS_4;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CX7_AHRS_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CX7_AHRS_4 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CX7_AHRS_4 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CX7_AHRS_4 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CX7_AHRS_4 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.magnetic_declination_source.source",
            read_as: None,
            difference: "only none and manual",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only mag, external_heading and all",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX7_AR_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const CX7_AR_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX7_AR_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const CX7_AR_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CX7_AR_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const CX7_AR_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CX7-AR
///
/// Attitude reference.
///
/// Generation 7. Model number 6700. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
/// receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
/// is known. Uncertain: Only MSCL lists it; the SDK does not.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp |
/// | 2 | GPIO, PPS, timestamp |
/// | 3 | GPIO, PPS, timestamp |
/// | 4 | GPIO, PPS, timestamp |
#[rustfmt::skip]
pub static CX7_AR: Profile = Profile {
    id: "3dm-cx7-ar",
    title: "3DM-CX7-AR",
    description: "Attitude reference.",
    also: &[],
    model_number: Some(6700),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX7_AR_2;
        0x01 0x02 "base.set_idle" [] CX7_AR_2;
        0x01 0x03 "base.get_device_info" [] CX7_AR_2;
        0x01 0x04 "base.get_device_descriptors" [] CX7_AR_2;
        0x01 0x05 "base.built_in_test" [] CX7_AR_3;
        0x01 0x06 "base.resume" [] CX7_AR_2;
        0x01 0x07 "base.get_extended_descriptors" [] CX7_AR_2;
        0x01 0x08 "base.continuous_built_in_test" [] CX7_AR_3;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX7_AR_3;
        0x01 0x7E "base.soft_reset" [] CX7_AR_3;
        0x0C 0x0D "3dm.poll_data" [] CX7_AR_3;
        0x0C 0x0E "3dm.get_base_rate" [] CX7_AR_2;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_2;
        0x0C 0x10 "3dm.factory_streaming" [] CX7_AR_3;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_1;
        0x0C 0x2A "3dm.get_event_support" [] CX7_AR_3;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CX7_AR_3;
        0x0C 0x2D "3dm.get_event_action_status" [] CX7_AR_3;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX7_AR_2;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_AR_3;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_AR_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX7_AR_3;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_1;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CX7_AR_3;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CX7_AR_3;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0D 0x01 "filter.reset" [] CX7_AR_3;
        0x0D 0x03 "filter.set_initial_heading" [] CX7_AR_3;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_1;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_1;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CX7_AR_3;
        0x13 0x31 "aiding.true_heading" [] CX7_AR_3;
        0x13 0x32 "aiding.magnetic_field" [] CX7_AR_3;
        0x80 0x04 "sensor.scaled_accel" [] CX7_AR_3;
        0x80 0x05 "sensor.scaled_gyro" [] CX7_AR_3;
        0x80 0x07 "sensor.delta_theta" [] CX7_AR_3;
        0x80 0x08 "sensor.delta_velocity" [] CX7_AR_3;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CX7_AR_3;
        0x80 0x0A "sensor.comp_quaternion" [] CX7_AR_3;
        0x80 0x0C "sensor.comp_euler_angles" [] CX7_AR_3;
        0x80 0x14 "sensor.temperature_statistics" [] CX7_AR_3;
        0x80 0x17 "sensor.scaled_pressure" [] CX7_AR_3;
        0x80 0x18 "sensor.overrange_status" [] CX7_AR_3;
        0x82 0x03 "filter_data.attitude_quaternion" [] CX7_AR_3;
        0x82 0x04 "filter_data.attitude_dcm" [] CX7_AR_3;
        0x82 0x05 "filter_data.euler_angles" [] CX7_AR_3;
        0x82 0x06 "filter_data.gyro_bias" [] CX7_AR_3;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CX7_AR_3;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CX7_AR_3;
        0x82 0x0D "filter_data.linear_accel" [] CX7_AR_3;
        0x82 0x0E "filter_data.comp_angular_rate" [] CX7_AR_3;
        0x82 0x10 "filter_data.status" [] CX7_AR_3;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CX7_AR_3;
        0x82 0x13 "filter_data.gravity_vector" [] CX7_AR_3;
        0x82 0x1C "filter_data.comp_accel" [] CX7_AR_3;
        0x82 0x21 "filter_data.pressure_altitude" [] CX7_AR_3;
        0xA0 0x01 "system_data.built_in_test" [] CX7_AR_3;
        0xA0 0x02 "system_data.time_sync_status" [] CX7_AR_3;
        0xA0 0x03 "system_data.gpio_state" [] CX7_AR_3;
        0xFF 0xD0 "shared.event_source" [] CX7_AR_3;
        0xFF 0xD3 "shared.gps_timestamp" [] CX7_AR_3;
        0xFF 0xD4 "shared.delta_time" [] CX7_AR_3;
        0xFF 0xD5 "shared.reference_timestamp" [] CX7_AR_3;
        0xFF 0xD6 "shared.reference_time_delta" [] CX7_AR_3;
        0xFF 0xD7 "shared.external_timestamp" [] CX7_AR_3;
        0xFF 0xD8 "shared.external_time_delta" [] CX7_AR_3;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CX7_AR_4;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX7_AR_4;
        0x0C 0x09 "3dm.gnss_message_format" [] CX7_AR_4;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CX7_AR_4;
        0x0C 0x21 "3dm.constellation_settings" [] CX7_AR_4;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CX7_AR_4;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CX7_AR_4;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CX7_AR_4;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CX7_AR_4;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] CX7_AR_5;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] CX7_AR_5;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CX7_AR_4;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] CX7_AR_5;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] CX7_AR_5;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] CX7_AR_5;
        0x0D 0x42 "filter.mag_noise" [] CX7_AR_5;
        0x0D 0x43 "filter.magnetic_declination_source" [] CX7_AR_5;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] CX7_AR_5;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] CX7_AR_5;
        0x0D 0x4C "filter.magnetic_inclination_source" [] CX7_AR_5;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] CX7_AR_5;
        0x0D 0x54 "filter.multi_antenna_offset" [] CX7_AR_4;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CX7_AR_4;
        0x80 0x03 "sensor.raw_mag" [] CX7_AR_5;
        0x80 0x06 "sensor.scaled_mag" [] CX7_AR_5;
        0x82 0x1A "filter_data.mag_bias" [] CX7_AR_5;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] CX7_AR_5;
        0x82 0x25 "filter_data.mag_offset" [] CX7_AR_5;
        0x82 0x26 "filter_data.mag_matrix" [] CX7_AR_5;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] CX7_AR_5;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] CX7_AR_5;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] CX7_AR_5;
        0x82 0x2C "filter_data.mag_residual_vector" [] CX7_AR_5;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CX7_AR_4;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CX7_AR_4;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CX7_AR_6;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CX7_AR_4 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CX7_AR_4 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CX7_AR_4 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CX7_AR_4 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "3dm.sensor_range.sensor",
            read_as: None,
            difference: "only all, accel, gyro and pressure",
        },
        Variant {
            parameter: "3dm.get_calibrated_sensor_ranges.sensor",
            read_as: None,
            difference: "only all, accel, gyro and pressure",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only external_heading and all",
        },
        Variant {
            parameter: "sensor.overrange_status.status",
            read_as: None,
            difference: "only accel_x, accel_y, accel_z, gyro_x, gyro_y, gyro_z and pressure",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const CX7_INS_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const CX7_INS_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const CX7_INS_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const CX7_INS_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const CX7_INS_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-CX7-INS
///
/// Inertial navigation system.
///
/// Generation 7. Model number 6702. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
/// incomplete: No manual is known. Uncertain: Only MSCL lists it; the SDK does not.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the
/// pins GPIO 1 and 2, UART 3 on GPIO 3 and 4.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp, UART 2 |
/// | 2 | GPIO, PPS, timestamp, UART 2 |
/// | 3 | GPIO, PPS, timestamp, UART 3, encoder A |
/// | 4 | GPIO, PPS, timestamp, UART 3, encoder B |
#[rustfmt::skip]
pub static CX7_INS: Profile = Profile {
    id: "3dm-cx7-ins",
    title: "3DM-CX7-INS",
    description: "Inertial navigation system.",
    also: &[],
    model_number: Some(6702),
    generation: Some(7),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] CX7_INS_2;
        0x01 0x02 "base.set_idle" [] CX7_INS_2;
        0x01 0x03 "base.get_device_info" [] CX7_INS_2;
        0x01 0x04 "base.get_device_descriptors" [] CX7_INS_2;
        0x01 0x05 "base.built_in_test" [] CX7_INS_3;
        0x01 0x06 "base.resume" [] CX7_INS_2;
        0x01 0x07 "base.get_extended_descriptors" [] CX7_INS_2;
        0x01 0x08 "base.continuous_built_in_test" [] CX7_INS_3;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] CX7_INS_3;
        0x01 0x7E "base.soft_reset" [] CX7_INS_3;
        0x0C 0x04 "3dm.poll_nmea_data" [] CX7_INS_3;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x0D "3dm.poll_data" [] CX7_INS_3;
        0x0C 0x0E "3dm.get_base_rate" [] CX7_INS_2;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_2;
        0x0C 0x10 "3dm.factory_streaming" [] CX7_INS_3;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_1;
        0x0C 0x2A "3dm.get_event_support" [] CX7_INS_3;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x2C "3dm.get_event_trigger_status" [] CX7_INS_3;
        0x0C 0x2D "3dm.get_event_action_status" [] CX7_INS_3;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] CX7_INS_2;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_INS_3;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_INS_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] CX7_INS_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_INS_3;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] CX7_INS_3;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_1;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] CX7_INS_3;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] CX7_INS_3;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x01 "filter.reset" [] CX7_INS_3;
        0x0D 0x03 "filter.set_initial_heading" [] CX7_INS_3;
        0x0D 0x05 "filter.run" [] CX7_INS_3;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x17 "filter.external_heading_update" [] CX7_INS_3;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x1F "filter.external_heading_update_with_time" [] CX7_INS_3;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_1;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_1;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_1;
        0x0D 0x55 "filter.relative_position_config" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x0D 0x56 "filter.reference_point_lever_arm" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] CX7_INS_3;
        0x13 0x21 "aiding.ecef_position" [] CX7_INS_3;
        0x13 0x22 "aiding.llh_position" [] CX7_INS_3;
        0x13 0x23 "aiding.height_above_ellipsoid" [] CX7_INS_3;
        0x13 0x28 "aiding.ecef_velocity" [] CX7_INS_3;
        0x13 0x29 "aiding.ned_velocity" [] CX7_INS_3;
        0x13 0x2A "aiding.body_frame_velocity" [] CX7_INS_3;
        0x13 0x31 "aiding.true_heading" [] CX7_INS_3;
        0x13 0x32 "aiding.magnetic_field" [] CX7_INS_3;
        0x13 0x33 "aiding.pressure" [] CX7_INS_3;
        0x80 0x04 "sensor.scaled_accel" [] CX7_INS_3;
        0x80 0x05 "sensor.scaled_gyro" [] CX7_INS_3;
        0x80 0x06 "sensor.scaled_mag" [] CX7_INS_3;
        0x80 0x07 "sensor.delta_theta" [] CX7_INS_3;
        0x80 0x08 "sensor.delta_velocity" [] CX7_INS_3;
        0x80 0x09 "sensor.comp_orientation_matrix" [] CX7_INS_3;
        0x80 0x0A "sensor.comp_quaternion" [] CX7_INS_3;
        0x80 0x0C "sensor.comp_euler_angles" [] CX7_INS_3;
        0x80 0x14 "sensor.temperature_statistics" [] CX7_INS_3;
        0x80 0x17 "sensor.scaled_pressure" [] CX7_INS_3;
        0x80 0x18 "sensor.overrange_status" [] CX7_INS_3;
        0x82 0x01 "filter_data.llh_position" [] CX7_INS_3;
        0x82 0x02 "filter_data.ned_velocity" [] CX7_INS_3;
        0x82 0x03 "filter_data.attitude_quaternion" [] CX7_INS_3;
        0x82 0x04 "filter_data.attitude_dcm" [] CX7_INS_3;
        0x82 0x05 "filter_data.euler_angles" [] CX7_INS_3;
        0x82 0x06 "filter_data.gyro_bias" [] CX7_INS_3;
        0x82 0x07 "filter_data.accel_bias" [] CX7_INS_3;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] CX7_INS_3;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] CX7_INS_3;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] CX7_INS_3;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] CX7_INS_3;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] CX7_INS_3;
        0x82 0x0D "filter_data.linear_accel" [] CX7_INS_3;
        0x82 0x0E "filter_data.comp_angular_rate" [] CX7_INS_3;
        0x82 0x10 "filter_data.status" [] CX7_INS_3;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] CX7_INS_3;
        0x82 0x13 "filter_data.gravity_vector" [] CX7_INS_3;
        0x82 0x15 "filter_data.magnetic_model" [] CX7_INS_3;
        0x82 0x1C "filter_data.comp_accel" [] CX7_INS_3;
        0x82 0x21 "filter_data.pressure_altitude" [] CX7_INS_3;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] CX7_INS_3;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] CX7_INS_3;
        0x82 0x40 "filter_data.ecef_position" [] CX7_INS_3;
        0x82 0x41 "filter_data.ecef_velocity" [] CX7_INS_3;
        0x82 0x42 "filter_data.ned_relative_position" [] CX7_INS_3;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] CX7_INS_3;
        0x82 0x46 "filter_data.aiding_measurement_summary" [] CX7_INS_3;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] CX7_INS_3;
        0x82 0x51 "filter_data.aiding_frame_config_error_uncertainty" [] CX7_INS_3;
        0x94 0x03 "gnss_external.llh_position" [] CX7_INS_3;
        0x94 0x05 "gnss_external.ned_velocity" [] CX7_INS_3;
        0x94 0x08 "gnss_external.utc_time" [] CX7_INS_3;
        0x94 0x0B "gnss_external.fix_info" [] CX7_INS_3;
        0x94 0x20 "gnss_external.satellite_status" [] CX7_INS_3;
        0xA0 0x01 "system_data.built_in_test" [] CX7_INS_3;
        0xA0 0x02 "system_data.time_sync_status" [] CX7_INS_3;
        0xA0 0x03 "system_data.gpio_state" [] CX7_INS_3;
        0xFF 0xD0 "shared.event_source" [] CX7_INS_3;
        0xFF 0xD3 "shared.gps_timestamp" [] CX7_INS_3;
        0xFF 0xD4 "shared.delta_time" [] CX7_INS_3;
        0xFF 0xD5 "shared.reference_timestamp" [] CX7_INS_3;
        0xFF 0xD6 "shared.reference_time_delta" [] CX7_INS_3;
        0xFF 0xD7 "shared.external_timestamp" [] CX7_INS_3;
        0xFF 0xD8 "shared.external_time_delta" [] CX7_INS_3;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] CX7_INS_4;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] CX7_INS_4;
        0x0C 0x09 "3dm.gnss_message_format" [] CX7_INS_4;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] CX7_INS_4;
        0x0C 0x21 "3dm.constellation_settings" [] CX7_INS_4;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] CX7_INS_4;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] CX7_INS_4;
        0x0C 0x24 "3dm.gnss_time_assistance" [] CX7_INS_4;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] CX7_INS_4;
        0x0C 0x62 "3dm.gps_advanced_settings" [] CX7_INS_4;
        0x0D 0x54 "filter.multi_antenna_offset" [] CX7_INS_4;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] CX7_INS_4;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] CX7_INS_4;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] CX7_INS_4;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] CX7_INS_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: CX7_INS_4 },
        AbsentSet { set: DescriptorSet(0x91), evidence: CX7_INS_4 },
        AbsentSet { set: DescriptorSet(0x92), evidence: CX7_INS_4 },
        AbsentSet { set: DescriptorSet(0x93), evidence: CX7_INS_4 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 2",
            id: Some(0x12),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 3",
            id: Some(0x13),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1, uart_2, uart_3 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1, uart_2, uart_3 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only external",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only gnss_position_velocity, altimeter, mag, external_heading, external_altimeter, external_mag, body_frame_velocity and all",
        },
        Variant {
            parameter: "filter.initialization_config.auto_heading_alignment_selector",
            read_as: None,
            difference: "only kinematic, mag and external",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const DH3_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};

/// 3DM-DH3
///
/// Device of generation 3.
///
/// Generation 3. Model number 6219. No manual is known. This profile is incomplete: No manual is
/// known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static DH3: Profile = Profile {
    id: "3dm-dh3",
    title: "3DM-DH3",
    description: "Device of generation 3.",
    also: &[],
    model_number: Some(6219),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] DH3_1;
        0x01 0x02 "base.set_idle" [] DH3_1;
        0x01 0x03 "base.get_device_info" [] DH3_1;
        0x01 0x04 "base.get_device_descriptors" [] DH3_1;
        0x01 0x06 "base.resume" [] DH3_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] DH3_1;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
    firmware: &[
    ],
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
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GQ4_45_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const GQ4_45_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-RQ1-45-LT and 3DM-GX4-45.",
    absence: "",
};
#[rustfmt::skip]
const GQ4_45_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const GQ4_45_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-GQ4-45
///
/// Tactical grade inertial navigation system with GNSS.
///
/// Generation 4. Model number 6250. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-GQ4-45 Data Communications
/// Protocol, of September 26, 2015, known from its table of contents. This profile is incomplete:
/// The manual's table of contents is known only up to the commands of the set `3dm`. The unknown
/// part includes the sets `filter` and `system`. This profile is incomplete: It has the data sets
/// 0x80, 0x81 and 0x82, but none of their fields are known. Uncertain: It may accept raw RTCM by a
/// command whose layout is not known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Direct modes
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor
/// or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the
/// 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "The manual's table of contents is known only up to the commands of the set `3dm`. The unknown part includes the sets `filter` and `system`.",
        "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GQ4_45_1;
        0x01 0x02 "base.set_idle" [] GQ4_45_1;
        0x01 0x03 "base.get_device_info" [] GQ4_45_1;
        0x01 0x04 "base.get_device_descriptors" [] GQ4_45_1;
        0x01 0x05 "base.built_in_test" [] GQ4_45_1;
        0x01 0x06 "base.resume" [] GQ4_45_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GQ4_45_1;
        0x01 0x7E "base.soft_reset" [] GQ4_45_1;
        0x0C 0x01 "3dm.poll_imu_data" [] GQ4_45_1;
        0x0C 0x02 "3dm.poll_gnss_data" [] GQ4_45_1;
        0x0C 0x03 "3dm.poll_filter_data" [] GQ4_45_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GQ4_45_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GQ4_45_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GQ4_45_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GQ4_45_1;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ4_45_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ4_45_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GQ4_45_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ4_45_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ4_45_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_1;
        0x0C 0x64 "3dm.device_status" [] GQ4_45_1;
        0x0D 0x01 "filter.reset" [] GQ4_45_2;
        0x0D 0x02 "filter.set_initial_attitude" [] GQ4_45_2;
        0x0D 0x03 "filter.set_initial_heading" [] GQ4_45_2;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x16 "filter.external_gnss_update" [] GQ4_45_2;
        0x0D 0x17 "filter.external_heading_update" [] GQ4_45_2;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GQ4_45_2;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x22 "filter.commanded_zupt" [] GQ4_45_2;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GQ4_45_2;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GQ4_45_2;
        0x80 0x04 "sensor.scaled_accel" [] GQ4_45_2;
        0x80 0x05 "sensor.scaled_gyro" [] GQ4_45_2;
        0x80 0x06 "sensor.scaled_mag" [] GQ4_45_2;
        0x81 0x03 "gnss_data.llh_position" [] GQ4_45_2;
        0x81 0x05 "gnss_data.ned_velocity" [] GQ4_45_2;
        0x81 0x09 "gnss_data.gps_time" [] GQ4_45_2;
        0x82 0x01 "filter_data.llh_position" [] GQ4_45_2;
        0x82 0x02 "filter_data.ned_velocity" [] GQ4_45_2;
        0x82 0x05 "filter_data.euler_angles" [] GQ4_45_2;
    },
    refuses: supported! {
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GQ4_45_3;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: GQ4_45_4 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal, external and internal_1",
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
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GQ7_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the ROS messages).",
    absence: "",
};
#[rustfmt::skip]
const GQ7_2: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-GQ7 Documentation: Protocol Support and Specifications).",
    absence: "",
};
#[rustfmt::skip]
const GQ7_3: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const GQ7_4: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the wiki of the ROS driver).",
    absence: "",
};
#[rustfmt::skip]
const GQ7_5: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const GQ7_6: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const GQ7_7: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (PX4: Driver of the vendor's sensors).",
    absence: "",
};
#[rustfmt::skip]
const GQ7_8: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};

/// 3DM-GQ7-GNSS/INS
///
/// Inertial navigation system with two GNSS receivers.
///
/// Also called 3DM-GQ7. Generation 7. Model number 6284. Sensors: accelerometer, gyroscope,
/// magnetometer, pressure sensor. GNSS receivers: 2. GNSS antennas: 2. Manual: MicroStrain 3DM-GQ7
/// Documentation, online, known from some pages. This profile is incomplete: Only some pages of its
/// manual are known; the device has further commands and data. This profile is incomplete: The baud
/// rates of the Aux port are not known, nor all of its protocols. Uncertain: The values of
/// [`filter::MagneticDeclinationSource`](crate::filter::MagneticDeclinationSource) are those that
/// MSCL offers. Uncertain: According to MSCL, firmware from 1.0 to below 1.1 has only the values
/// `all_internal` and `external` of [`filter::GnssSource`](crate::filter::GnssSource).
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// Features of each pin, according to MSCL.
///
/// | Pin | Connector pin | Features |
/// | --- | --- | --- |
/// | 1 | primary 7 | GPIO, PPS, encoder A |
/// | 2 | primary 9 | GPIO, encoder B |
/// | 3 | auxiliary 7 | GPIO, PPS |
/// | 4 | auxiliary 9 | GPIO |
///
/// # NMEA output
///
/// Sentences are GGA, GLL, GSV, RMC, VTG, HDT, ZDA, and the proprietary PMSRA and PMSRR.
///
/// # GNSS signals
///
/// Signals that can be enabled together by [`gnss::SignalConfig`](crate::gnss::SignalConfig),
/// according to MSCL.
///
/// | Constellation | Choices |
/// | --- | --- |
/// | GPS | none, L1 C/A + L2C |
/// | GLONASS | none, L1 + L2 |
/// | Galileo | none, E1 + E5b |
/// | BeiDou | none, B1 + B2 |
///
/// # GNSS sets
///
/// The set 0x91 belongs to the first receiver and 0x92 to the second; 0x93 contains the RTK
/// corrections.
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
        "Only some pages of its manual are known; the device has further commands and data.",
        "The baud rates of the Aux port are not known, nor all of its protocols.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GQ7_5;
        0x01 0x02 "base.set_idle" [] GQ7_5;
        0x01 0x03 "base.get_device_info" [] GQ7_1;
        0x01 0x04 "base.get_device_descriptors" [] GQ7_2;
        0x01 0x05 "base.built_in_test" [] GQ7_8;
        0x01 0x06 "base.resume" [] GQ7_5;
        0x01 0x07 "base.get_extended_descriptors" [] GQ7_2;
        0x01 0x08 "base.continuous_built_in_test" [] GQ7_8;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] GQ7_2;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GQ7_8;
        0x01 0x7E "base.soft_reset" [] GQ7_8;
        0x0C 0x04 "3dm.poll_nmea_data" [] GQ7_3;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0C 0x0D "3dm.poll_data" [] GQ7_8;
        0x0C 0x0E "3dm.get_base_rate" [] GQ7_2;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] GQ7_5;
        0x0C 0x10 "3dm.factory_streaming" [] GQ7_6;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0C 0x2A "3dm.get_event_support" [] GQ7_8;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x2C "3dm.get_event_trigger_status" [] GQ7_8;
        0x0C 0x2D "3dm.get_event_action_status" [] GQ7_8;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GQ7_5;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ7_8;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ7_8;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GQ7_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ7_8;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GQ7_8;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] GQ7_1;
        0x0C 0x43 "3dm.odometer_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GQ7_2;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] GQ7_8;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GQ7_2;
        0x0D 0x01 "filter.reset" [] GQ7_5;
        0x0D 0x03 "filter.set_initial_heading" [] GQ7_8;
        0x0D 0x05 "filter.run" [] GQ7_3;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0D 0x17 "filter.external_heading_update" [] GQ7_8;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GQ7_8;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] GQ7_5;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0D 0x54 "filter.multi_antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GQ7_5;
        0x0D 0x55 "filter.relative_position_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0D 0x56 "filter.reference_point_lever_arm" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0D 0x61 "filter.speed_lever_arm" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0D 0x63 "filter.wheeled_vehicle_constraint_control" [WRITE READ SAVE LOAD DEFAULT] GQ7_5;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [WRITE READ SAVE LOAD DEFAULT] GQ7_3;
        0x0E 0x01 "gnss.receiver_info" [] GQ7_8;
        0x0E 0x02 "gnss.signal_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x0E 0x10 "gnss.rtk_dongle_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_6;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] GQ7_8;
        0x13 0x31 "aiding.true_heading" [] GQ7_8;
        0x80 0x04 "sensor.scaled_accel" [] GQ7_4;
        0x80 0x05 "sensor.scaled_gyro" [] GQ7_4;
        0x80 0x06 "sensor.scaled_mag" [] GQ7_4;
        0x80 0x07 "sensor.delta_theta" [] GQ7_4;
        0x80 0x08 "sensor.delta_velocity" [] GQ7_4;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GQ7_8;
        0x80 0x0A "sensor.comp_quaternion" [] GQ7_4;
        0x80 0x0C "sensor.comp_euler_angles" [] GQ7_8;
        0x80 0x12 "sensor.gps_timestamp" [] GQ7_4;
        0x80 0x14 "sensor.temperature_statistics" [] GQ7_1;
        0x80 0x17 "sensor.scaled_pressure" [] GQ7_4;
        0x80 0x18 "sensor.overrange_status" [] GQ7_4;
        0x80 0x40 "sensor.odometer" [] GQ7_4;
        0x82 0x01 "filter_data.llh_position" [] GQ7_4;
        0x82 0x02 "filter_data.ned_velocity" [] GQ7_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] GQ7_4;
        0x82 0x04 "filter_data.attitude_dcm" [] GQ7_8;
        0x82 0x05 "filter_data.euler_angles" [] GQ7_4;
        0x82 0x06 "filter_data.gyro_bias" [] GQ7_8;
        0x82 0x07 "filter_data.accel_bias" [] GQ7_8;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] GQ7_4;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] GQ7_4;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GQ7_4;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GQ7_8;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] GQ7_8;
        0x82 0x0D "filter_data.linear_accel" [] GQ7_4;
        0x82 0x0E "filter_data.comp_angular_rate" [] GQ7_4;
        0x82 0x10 "filter_data.status" [] GQ7_4;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GQ7_8;
        0x82 0x13 "filter_data.gravity_vector" [] GQ7_8;
        0x82 0x15 "filter_data.magnetic_model" [] GQ7_8;
        0x82 0x1C "filter_data.comp_accel" [] GQ7_4;
        0x82 0x21 "filter_data.pressure_altitude" [] GQ7_8;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GQ7_4;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GQ7_8;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] GQ7_4;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] GQ7_4;
        0x82 0x40 "filter_data.ecef_position" [] GQ7_4;
        0x82 0x41 "filter_data.ecef_velocity" [] GQ7_4;
        0x82 0x42 "filter_data.ned_relative_position" [] GQ7_4;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] GQ7_4;
        0x82 0x46 "filter_data.aiding_measurement_summary" [] GQ7_4;
        0x82 0x47 "filter_data.odometer_scale_factor_error" [] GQ7_8;
        0x82 0x48 "filter_data.odometer_scale_factor_error_uncertainty" [] GQ7_8;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GQ7_4;
        0x91 0x03 "gnss_1.llh_position" [] GQ7_3;
        0x91 0x04 "gnss_1.ecef_position" [] GQ7_4;
        0x91 0x05 "gnss_1.ned_velocity" [] GQ7_4;
        0x91 0x06 "gnss_1.ecef_velocity" [] GQ7_4;
        0x91 0x07 "gnss_1.dop" [] GQ7_7;
        0x91 0x08 "gnss_1.utc_time" [] GQ7_8;
        0x91 0x09 "gnss_1.gps_time" [] GQ7_8;
        0x91 0x0B "gnss_1.fix_info" [] GQ7_3;
        0x91 0x0D "gnss_1.hardware_status" [] GQ7_8;
        0x91 0x10 "gnss_1.clock_info_2" [] GQ7_8;
        0x91 0x11 "gnss_1.gps_leap_seconds" [] GQ7_7;
        0x91 0x12 "gnss_1.sbas_info" [] GQ7_4;
        0x91 0x14 "gnss_1.rf_error_detection" [] GQ7_4;
        0x91 0x20 "gnss_1.satellite_status" [] GQ7_8;
        0x91 0x22 "gnss_1.raw" [] GQ7_8;
        0x91 0x61 "gnss_1.gps_ephemeris" [] GQ7_8;
        0x91 0x62 "gnss_1.glonass_ephemeris" [] GQ7_8;
        0x91 0x63 "gnss_1.galileo_ephemeris" [] GQ7_8;
        0x91 0x64 "gnss_1.beidou_ephemeris" [] GQ7_8;
        0x92 0x03 "gnss_2.llh_position" [] GQ7_4;
        0x92 0x04 "gnss_2.ecef_position" [] GQ7_4;
        0x92 0x05 "gnss_2.ned_velocity" [] GQ7_4;
        0x92 0x06 "gnss_2.ecef_velocity" [] GQ7_4;
        0x92 0x07 "gnss_2.dop" [] GQ7_7;
        0x92 0x08 "gnss_2.utc_time" [] GQ7_8;
        0x92 0x09 "gnss_2.gps_time" [] GQ7_8;
        0x92 0x0B "gnss_2.fix_info" [] GQ7_5;
        0x92 0x0D "gnss_2.hardware_status" [] GQ7_3;
        0x92 0x10 "gnss_2.clock_info_2" [] GQ7_8;
        0x92 0x11 "gnss_2.gps_leap_seconds" [] GQ7_7;
        0x92 0x12 "gnss_2.sbas_info" [] GQ7_4;
        0x92 0x14 "gnss_2.rf_error_detection" [] GQ7_4;
        0x92 0x20 "gnss_2.satellite_status" [] GQ7_8;
        0x92 0x22 "gnss_2.raw" [] GQ7_8;
        0x92 0x61 "gnss_2.gps_ephemeris" [] GQ7_8;
        0x92 0x62 "gnss_2.glonass_ephemeris" [] GQ7_8;
        0x92 0x63 "gnss_2.galileo_ephemeris" [] GQ7_8;
        0x92 0x64 "gnss_2.beidou_ephemeris" [] GQ7_8;
        0x93 0x30 "gnss_corrections.base_station_info" [] GQ7_4;
        0x93 0x31 "gnss_corrections.rtk_corrections_status" [] GQ7_4;
        0xA0 0x01 "system_data.built_in_test" [] GQ7_1;
        0xA0 0x02 "system_data.time_sync_status" [] GQ7_8;
        0xA0 0x03 "system_data.gpio_state" [] GQ7_8;
        0xFF 0xD0 "shared.event_source" [] GQ7_8;
        0xFF 0xD3 "shared.gps_timestamp" [] GQ7_4;
        0xFF 0xD4 "shared.delta_time" [] GQ7_8;
        0xFF 0xD5 "shared.reference_timestamp" [] GQ7_8;
        0xFF 0xD6 "shared.reference_time_delta" [] GQ7_8;
        0xFF 0xD7 "shared.external_timestamp" [] GQ7_8;
        0xFF 0xD8 "shared.external_time_delta" [] GQ7_8;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
    firmware: &[
        Firmware {
            set: DescriptorSet(0x0C),
            descriptor: 0x50,
            versions: "<= 1.0.10",
        },
        Firmware {
            set: DescriptorSet(0x0C),
            descriptor: 0x54,
            versions: "> 1.0.10",
        },
        Firmware {
            set: DescriptorSet(0x0E),
            descriptor: 0x02,
            versions: "> 1.0.10",
        },
        Firmware {
            set: DescriptorSet(0xA0),
            descriptor: 0x01,
            versions: "> 1.0.10",
        },
        Firmware {
            set: DescriptorSet(0xA0),
            descriptor: 0x02,
            versions: "> 1.0.10",
        },
        Firmware {
            set: DescriptorSet(0xA0),
            descriptor: 0x03,
            versions: "> 1.0.10",
        },
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0xA0), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x91), hertz: 2.0 },
        BaseRate { set: DescriptorSet(0x92), hertz: 2.0 },
        BaseRate { set: DescriptorSet(0x93), hertz: 0.0 },
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[115200, 230400, 460800, 921600],
            receives: &["MIP", "NMEA"],
            sends: &["MIP", "NMEA"],
        },
        ProfilePort {
            name: "Aux",
            id: Some(0x02),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "nmea_rate",
            value: 10.0,
            unit: Some("Hz"),
            description: "Maximum rate of an NMEA sentence, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: None,
            difference: "1 is the main port, 2 the auxiliary one",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("gq7_continuous_built_in_test"),
            difference: "values of gq7_continuous_built_in_test (inferred: the sources are about system_data.built_in_test, whose flags are the same on the 3DM-CV7-GNSS/INS)",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: None,
            difference: "1 is the main port, 2 the auxiliary one",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, receiver_1, receiver_2, gpio and generated",
        },
        Variant {
            parameter: "filter.magnetic_declination_source.source",
            read_as: None,
            difference: "only wmm and manual",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only gnss_position_velocity, gnss_heading, altimeter, speed, mag, external_heading and all",
        },
        Variant {
            parameter: "filter.initialization_config.auto_heading_alignment_selector",
            read_as: None,
            difference: "only dual_antenna, kinematic and mag",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("gq7_continuous_built_in_test"),
            difference: "values of gq7_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GV7_AHRS_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AHRS_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AHRS_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AHRS_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AHRS_5: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const GV7_AHRS_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GV7_AHRS_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-GV7-AHRS
///
/// Attitude and heading reference system.
///
/// Generation 7. Model number 6288. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
/// incomplete: No manual is known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp |
/// | 2 | GPIO, PPS, timestamp |
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
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GV7_AHRS_1;
        0x01 0x02 "base.set_idle" [] GV7_AHRS_1;
        0x01 0x03 "base.get_device_info" [] GV7_AHRS_1;
        0x01 0x04 "base.get_device_descriptors" [] GV7_AHRS_4;
        0x01 0x05 "base.built_in_test" [] GV7_AHRS_5;
        0x01 0x06 "base.resume" [] GV7_AHRS_1;
        0x01 0x07 "base.get_extended_descriptors" [] GV7_AHRS_4;
        0x01 0x08 "base.continuous_built_in_test" [] GV7_AHRS_5;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GV7_AHRS_5;
        0x01 0x7E "base.soft_reset" [] GV7_AHRS_5;
        0x0C 0x0D "3dm.poll_data" [] GV7_AHRS_5;
        0x0C 0x0E "3dm.get_base_rate" [] GV7_AHRS_1;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0C 0x10 "3dm.factory_streaming" [] GV7_AHRS_5;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_2;
        0x0C 0x2A "3dm.get_event_support" [] GV7_AHRS_5;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0C 0x2C "3dm.get_event_trigger_status" [] GV7_AHRS_5;
        0x0C 0x2D "3dm.get_event_action_status" [] GV7_AHRS_5;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_AHRS_5;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_AHRS_5;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GV7_AHRS_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_AHRS_5;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_AHRS_5;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_3;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] GV7_AHRS_5;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] GV7_AHRS_5;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0D 0x01 "filter.reset" [] GV7_AHRS_1;
        0x0D 0x03 "filter.set_initial_heading" [] GV7_AHRS_5;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_2;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_1;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_2;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AHRS_5;
        0x13 0x31 "aiding.true_heading" [] GV7_AHRS_5;
        0x13 0x32 "aiding.magnetic_field" [] GV7_AHRS_5;
        0x80 0x04 "sensor.scaled_accel" [] GV7_AHRS_5;
        0x80 0x05 "sensor.scaled_gyro" [] GV7_AHRS_5;
        0x80 0x06 "sensor.scaled_mag" [] GV7_AHRS_5;
        0x80 0x07 "sensor.delta_theta" [] GV7_AHRS_5;
        0x80 0x08 "sensor.delta_velocity" [] GV7_AHRS_5;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GV7_AHRS_5;
        0x80 0x0A "sensor.comp_quaternion" [] GV7_AHRS_5;
        0x80 0x0C "sensor.comp_euler_angles" [] GV7_AHRS_5;
        0x80 0x14 "sensor.temperature_statistics" [] GV7_AHRS_5;
        0x80 0x17 "sensor.scaled_pressure" [] GV7_AHRS_5;
        0x80 0x18 "sensor.overrange_status" [] GV7_AHRS_5;
        0x82 0x03 "filter_data.attitude_quaternion" [] GV7_AHRS_5;
        0x82 0x04 "filter_data.attitude_dcm" [] GV7_AHRS_5;
        0x82 0x05 "filter_data.euler_angles" [] GV7_AHRS_1;
        0x82 0x06 "filter_data.gyro_bias" [] GV7_AHRS_5;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GV7_AHRS_5;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GV7_AHRS_5;
        0x82 0x0D "filter_data.linear_accel" [] GV7_AHRS_5;
        0x82 0x0E "filter_data.comp_angular_rate" [] GV7_AHRS_5;
        0x82 0x10 "filter_data.status" [] GV7_AHRS_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GV7_AHRS_5;
        0x82 0x13 "filter_data.gravity_vector" [] GV7_AHRS_5;
        0x82 0x1C "filter_data.comp_accel" [] GV7_AHRS_5;
        0x82 0x21 "filter_data.pressure_altitude" [] GV7_AHRS_5;
        0xA0 0x01 "system_data.built_in_test" [] GV7_AHRS_5;
        0xA0 0x02 "system_data.time_sync_status" [] GV7_AHRS_2;
        0xA0 0x03 "system_data.gpio_state" [] GV7_AHRS_5;
        0xFF 0xD0 "shared.event_source" [] GV7_AHRS_1;
        0xFF 0xD3 "shared.gps_timestamp" [] GV7_AHRS_1;
        0xFF 0xD4 "shared.delta_time" [] GV7_AHRS_5;
        0xFF 0xD5 "shared.reference_timestamp" [] GV7_AHRS_5;
        0xFF 0xD6 "shared.reference_time_delta" [] GV7_AHRS_5;
        0xFF 0xD7 "shared.external_timestamp" [] GV7_AHRS_5;
        0xFF 0xD8 "shared.external_time_delta" [] GV7_AHRS_5;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GV7_AHRS_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GV7_AHRS_6;
        0x0C 0x09 "3dm.gnss_message_format" [] GV7_AHRS_6;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GV7_AHRS_6;
        0x0C 0x21 "3dm.constellation_settings" [] GV7_AHRS_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GV7_AHRS_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GV7_AHRS_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GV7_AHRS_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GV7_AHRS_6;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GV7_AHRS_6;
        0x0D 0x54 "filter.multi_antenna_offset" [] GV7_AHRS_6;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GV7_AHRS_6;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GV7_AHRS_6;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GV7_AHRS_6;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GV7_AHRS_7;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GV7_AHRS_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GV7_AHRS_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GV7_AHRS_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GV7_AHRS_6 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.magnetic_declination_source.source",
            read_as: None,
            difference: "only none and manual",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only mag, external_heading and all",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GV7_AR_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AR_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AR_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AR_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GV7_AR_5: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const GV7_AR_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GV7_AR_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const GV7_AR_8: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-GV7-AR
///
/// Attitude reference.
///
/// Generation 7. Model number 6289. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
/// receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
/// is known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp |
/// | 2 | GPIO, PPS, timestamp |
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
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GV7_AR_1;
        0x01 0x02 "base.set_idle" [] GV7_AR_1;
        0x01 0x03 "base.get_device_info" [] GV7_AR_1;
        0x01 0x04 "base.get_device_descriptors" [] GV7_AR_4;
        0x01 0x05 "base.built_in_test" [] GV7_AR_5;
        0x01 0x06 "base.resume" [] GV7_AR_1;
        0x01 0x07 "base.get_extended_descriptors" [] GV7_AR_4;
        0x01 0x08 "base.continuous_built_in_test" [] GV7_AR_5;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GV7_AR_5;
        0x01 0x7E "base.soft_reset" [] GV7_AR_5;
        0x0C 0x0D "3dm.poll_data" [] GV7_AR_5;
        0x0C 0x0E "3dm.get_base_rate" [] GV7_AR_1;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_1;
        0x0C 0x10 "3dm.factory_streaming" [] GV7_AR_5;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_2;
        0x0C 0x2A "3dm.get_event_support" [] GV7_AR_5;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_1;
        0x0C 0x2C "3dm.get_event_trigger_status" [] GV7_AR_5;
        0x0C 0x2D "3dm.get_event_action_status" [] GV7_AR_5;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_1;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GV7_AR_1;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_1;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_AR_5;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_AR_5;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GV7_AR_1;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_3;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] GV7_AR_5;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] GV7_AR_5;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0D 0x01 "filter.reset" [] GV7_AR_1;
        0x0D 0x03 "filter.set_initial_heading" [] GV7_AR_5;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_2;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_2;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] GV7_AR_5;
        0x13 0x31 "aiding.true_heading" [] GV7_AR_5;
        0x13 0x32 "aiding.magnetic_field" [] GV7_AR_5;
        0x80 0x04 "sensor.scaled_accel" [] GV7_AR_5;
        0x80 0x05 "sensor.scaled_gyro" [] GV7_AR_5;
        0x80 0x07 "sensor.delta_theta" [] GV7_AR_5;
        0x80 0x08 "sensor.delta_velocity" [] GV7_AR_5;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GV7_AR_5;
        0x80 0x0A "sensor.comp_quaternion" [] GV7_AR_5;
        0x80 0x0C "sensor.comp_euler_angles" [] GV7_AR_5;
        0x80 0x14 "sensor.temperature_statistics" [] GV7_AR_5;
        0x80 0x17 "sensor.scaled_pressure" [] GV7_AR_5;
        0x80 0x18 "sensor.overrange_status" [] GV7_AR_5;
        0x82 0x03 "filter_data.attitude_quaternion" [] GV7_AR_5;
        0x82 0x04 "filter_data.attitude_dcm" [] GV7_AR_5;
        0x82 0x05 "filter_data.euler_angles" [] GV7_AR_1;
        0x82 0x06 "filter_data.gyro_bias" [] GV7_AR_5;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GV7_AR_5;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GV7_AR_5;
        0x82 0x0D "filter_data.linear_accel" [] GV7_AR_5;
        0x82 0x0E "filter_data.comp_angular_rate" [] GV7_AR_5;
        0x82 0x10 "filter_data.status" [] GV7_AR_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GV7_AR_5;
        0x82 0x13 "filter_data.gravity_vector" [] GV7_AR_5;
        0x82 0x1C "filter_data.comp_accel" [] GV7_AR_5;
        0x82 0x21 "filter_data.pressure_altitude" [] GV7_AR_5;
        0xA0 0x01 "system_data.built_in_test" [] GV7_AR_5;
        0xA0 0x02 "system_data.time_sync_status" [] GV7_AR_2;
        0xA0 0x03 "system_data.gpio_state" [] GV7_AR_5;
        0xFF 0xD0 "shared.event_source" [] GV7_AR_1;
        0xFF 0xD3 "shared.gps_timestamp" [] GV7_AR_1;
        0xFF 0xD4 "shared.delta_time" [] GV7_AR_5;
        0xFF 0xD5 "shared.reference_timestamp" [] GV7_AR_5;
        0xFF 0xD6 "shared.reference_time_delta" [] GV7_AR_5;
        0xFF 0xD7 "shared.external_timestamp" [] GV7_AR_5;
        0xFF 0xD8 "shared.external_time_delta" [] GV7_AR_5;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GV7_AR_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GV7_AR_6;
        0x0C 0x09 "3dm.gnss_message_format" [] GV7_AR_6;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GV7_AR_6;
        0x0C 0x21 "3dm.constellation_settings" [] GV7_AR_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GV7_AR_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GV7_AR_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GV7_AR_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GV7_AR_6;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] GV7_AR_7;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] GV7_AR_7;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GV7_AR_6;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] GV7_AR_7;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] GV7_AR_7;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] GV7_AR_7;
        0x0D 0x42 "filter.mag_noise" [] GV7_AR_7;
        0x0D 0x43 "filter.magnetic_declination_source" [] GV7_AR_7;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] GV7_AR_7;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] GV7_AR_7;
        0x0D 0x4C "filter.magnetic_inclination_source" [] GV7_AR_7;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] GV7_AR_7;
        0x0D 0x54 "filter.multi_antenna_offset" [] GV7_AR_6;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GV7_AR_6;
        0x80 0x03 "sensor.raw_mag" [] GV7_AR_7;
        0x80 0x06 "sensor.scaled_mag" [] GV7_AR_7;
        0x82 0x1A "filter_data.mag_bias" [] GV7_AR_7;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] GV7_AR_7;
        0x82 0x25 "filter_data.mag_offset" [] GV7_AR_7;
        0x82 0x26 "filter_data.mag_matrix" [] GV7_AR_7;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] GV7_AR_7;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] GV7_AR_7;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] GV7_AR_7;
        0x82 0x2C "filter_data.mag_residual_vector" [] GV7_AR_7;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GV7_AR_6;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GV7_AR_6;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GV7_AR_8;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GV7_AR_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GV7_AR_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GV7_AR_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GV7_AR_6 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "3dm.sensor_range.sensor",
            read_as: None,
            difference: "only all, accel, gyro and pressure",
        },
        Variant {
            parameter: "3dm.get_calibrated_sensor_ranges.sensor",
            read_as: None,
            difference: "only all, accel, gyro and pressure",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only external_heading and all",
        },
        Variant {
            parameter: "sensor.overrange_status.status",
            read_as: None,
            difference: "only accel_x, accel_y, accel_z, gyro_x, gyro_y, gyro_z and pressure",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GV7_INS_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GV7_INS_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver of the vendor: Example configurations).",
    absence: "",
};
#[rustfmt::skip]
const GV7_INS_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GV7_INS_4: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GV7_INS_5: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
    absence: "",
};
#[rustfmt::skip]
const GV7_INS_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GV7_INS_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-GV7-INS
///
/// Inertial navigation system.
///
/// Generation 7. Model number 6290. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
/// incomplete: No manual is known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Anti-aliasing low-pass filter
///
/// Data that [`mip_3dm::LowPassFilter`](crate::mip_3dm::LowPassFilter) can filter on the 3DM-CV7
/// and the 3DM-GQ7, and so probably on the others;
/// [`mip_3dm::ImuLowPassFilter`](crate::mip_3dm::ImuLowPassFilter) filters sensor data only.
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
/// # Ports
///
/// The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the
/// pins GPIO 1 and 2.
///
/// # GPIO pins
///
/// Features of each pin, according to MSCL.
///
/// | Pin | Features |
/// | --- | --- |
/// | 1 | GPIO, PPS, timestamp, UART 2 |
/// | 2 | GPIO, PPS, timestamp, UART 2 |
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
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GV7_INS_1;
        0x01 0x02 "base.set_idle" [] GV7_INS_1;
        0x01 0x03 "base.get_device_info" [] GV7_INS_1;
        0x01 0x04 "base.get_device_descriptors" [] GV7_INS_4;
        0x01 0x05 "base.built_in_test" [] GV7_INS_5;
        0x01 0x06 "base.resume" [] GV7_INS_1;
        0x01 0x07 "base.get_extended_descriptors" [] GV7_INS_4;
        0x01 0x08 "base.continuous_built_in_test" [] GV7_INS_5;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_2;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GV7_INS_5;
        0x01 0x7E "base.soft_reset" [] GV7_INS_5;
        0x0C 0x04 "3dm.poll_nmea_data" [] GV7_INS_5;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x0D "3dm.poll_data" [] GV7_INS_5;
        0x0C 0x0E "3dm.get_base_rate" [] GV7_INS_1;
        0x0C 0x0F "3dm.message_format" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_1;
        0x0C 0x10 "3dm.factory_streaming" [] GV7_INS_5;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x28 "3dm.pps_source_control" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_2;
        0x0C 0x2A "3dm.get_event_support" [] GV7_INS_5;
        0x0C 0x2B "3dm.event_control" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x2C "3dm.get_event_trigger_status" [] GV7_INS_5;
        0x0C 0x2D "3dm.get_event_action_status" [] GV7_INS_5;
        0x0C 0x2E "3dm.event_trigger_config" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x2F "3dm.event_action_config" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GV7_INS_1;
        0x0C 0x31 "3dm.sensor_to_vehicle_transform_euler" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x32 "3dm.sensor_to_vehicle_transform_quaternion" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x33 "3dm.sensor_to_vehicle_transform_dcm" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_INS_5;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_INS_5;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GV7_INS_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_INS_5;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GV7_INS_5;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_2;
        0x0C 0x42 "3dm.gpio_state" [WRITE READ] GV7_INS_2;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x52 "3dm.sensor_range" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0C 0x53 "3dm.get_calibrated_sensor_ranges" [] GV7_INS_5;
        0x0C 0x54 "3dm.low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x01 "filter.reset" [] GV7_INS_1;
        0x0D 0x03 "filter.set_initial_heading" [] GV7_INS_5;
        0x0D 0x05 "filter.run" [] GV7_INS_5;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_2;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x17 "filter.external_heading_update" [] GV7_INS_5;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GV7_INS_5;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_2;
        0x0D 0x50 "filter.aiding_measurement_enable" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_1;
        0x0D 0x52 "filter.initialization_config" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_1;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_3;
        0x0D 0x55 "filter.relative_position_config" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_2;
        0x0D 0x56 "filter.reference_point_lever_arm" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x13 0x01 "aiding.frame_config" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_1;
        0x13 0x1F "aiding.echo_control" [WRITE READ SAVE LOAD DEFAULT] GV7_INS_5;
        0x13 0x21 "aiding.ecef_position" [] GV7_INS_5;
        0x13 0x22 "aiding.llh_position" [] GV7_INS_1;
        0x13 0x23 "aiding.height_above_ellipsoid" [] GV7_INS_5;
        0x13 0x28 "aiding.ecef_velocity" [] GV7_INS_5;
        0x13 0x29 "aiding.ned_velocity" [] GV7_INS_1;
        0x13 0x2A "aiding.body_frame_velocity" [] GV7_INS_1;
        0x13 0x31 "aiding.true_heading" [] GV7_INS_1;
        0x13 0x32 "aiding.magnetic_field" [] GV7_INS_5;
        0x13 0x33 "aiding.pressure" [] GV7_INS_5;
        0x80 0x04 "sensor.scaled_accel" [] GV7_INS_5;
        0x80 0x05 "sensor.scaled_gyro" [] GV7_INS_5;
        0x80 0x06 "sensor.scaled_mag" [] GV7_INS_5;
        0x80 0x07 "sensor.delta_theta" [] GV7_INS_5;
        0x80 0x08 "sensor.delta_velocity" [] GV7_INS_5;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GV7_INS_5;
        0x80 0x0A "sensor.comp_quaternion" [] GV7_INS_5;
        0x80 0x0C "sensor.comp_euler_angles" [] GV7_INS_5;
        0x80 0x14 "sensor.temperature_statistics" [] GV7_INS_5;
        0x80 0x17 "sensor.scaled_pressure" [] GV7_INS_5;
        0x80 0x18 "sensor.overrange_status" [] GV7_INS_5;
        0x82 0x01 "filter_data.llh_position" [] GV7_INS_1;
        0x82 0x02 "filter_data.ned_velocity" [] GV7_INS_1;
        0x82 0x03 "filter_data.attitude_quaternion" [] GV7_INS_5;
        0x82 0x04 "filter_data.attitude_dcm" [] GV7_INS_5;
        0x82 0x05 "filter_data.euler_angles" [] GV7_INS_1;
        0x82 0x06 "filter_data.gyro_bias" [] GV7_INS_5;
        0x82 0x07 "filter_data.accel_bias" [] GV7_INS_5;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] GV7_INS_5;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] GV7_INS_5;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GV7_INS_5;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GV7_INS_5;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] GV7_INS_5;
        0x82 0x0D "filter_data.linear_accel" [] GV7_INS_5;
        0x82 0x0E "filter_data.comp_angular_rate" [] GV7_INS_5;
        0x82 0x10 "filter_data.status" [] GV7_INS_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GV7_INS_5;
        0x82 0x13 "filter_data.gravity_vector" [] GV7_INS_5;
        0x82 0x15 "filter_data.magnetic_model" [] GV7_INS_5;
        0x82 0x1C "filter_data.comp_accel" [] GV7_INS_5;
        0x82 0x21 "filter_data.pressure_altitude" [] GV7_INS_5;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] GV7_INS_2;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] GV7_INS_5;
        0x82 0x40 "filter_data.ecef_position" [] GV7_INS_2;
        0x82 0x41 "filter_data.ecef_velocity" [] GV7_INS_5;
        0x82 0x42 "filter_data.ned_relative_position" [] GV7_INS_2;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] GV7_INS_5;
        0x82 0x46 "filter_data.aiding_measurement_summary" [] GV7_INS_2;
        0x82 0x50 "filter_data.aiding_frame_config_error" [] GV7_INS_5;
        0x82 0x51 "filter_data.aiding_frame_config_error_uncertainty" [] GV7_INS_5;
        0x94 0x03 "gnss_external.llh_position" [] GV7_INS_5;
        0x94 0x05 "gnss_external.ned_velocity" [] GV7_INS_5;
        0x94 0x08 "gnss_external.utc_time" [] GV7_INS_5;
        0x94 0x0B "gnss_external.fix_info" [] GV7_INS_5;
        0x94 0x20 "gnss_external.satellite_status" [] GV7_INS_5;
        0xA0 0x01 "system_data.built_in_test" [] GV7_INS_5;
        0xA0 0x02 "system_data.time_sync_status" [] GV7_INS_5;
        0xA0 0x03 "system_data.gpio_state" [] GV7_INS_5;
        0xFF 0xD0 "shared.event_source" [] GV7_INS_5;
        0xFF 0xD3 "shared.gps_timestamp" [] GV7_INS_1;
        0xFF 0xD4 "shared.delta_time" [] GV7_INS_5;
        0xFF 0xD5 "shared.reference_timestamp" [] GV7_INS_5;
        0xFF 0xD6 "shared.reference_time_delta" [] GV7_INS_5;
        0xFF 0xD7 "shared.external_timestamp" [] GV7_INS_5;
        0xFF 0xD8 "shared.external_time_delta" [] GV7_INS_5;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GV7_INS_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GV7_INS_6;
        0x0C 0x09 "3dm.gnss_message_format" [] GV7_INS_6;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GV7_INS_6;
        0x0C 0x21 "3dm.constellation_settings" [] GV7_INS_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GV7_INS_6;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GV7_INS_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GV7_INS_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GV7_INS_6;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GV7_INS_6;
        0x0D 0x54 "filter.multi_antenna_offset" [] GV7_INS_6;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GV7_INS_6;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GV7_INS_6;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GV7_INS_6;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GV7_INS_7;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GV7_INS_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GV7_INS_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GV7_INS_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GV7_INS_6 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
        ProfilePort {
            name: "Main",
            id: Some(0x01),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 1",
            id: Some(0x11),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "UART 2",
            id: Some(0x12),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
        ProfilePort {
            name: "USB 1",
            id: Some(0x21),
            baud_rates: &[],
            receives: &["MIP"],
            sends: &["MIP"],
        },
    ],
    limits: &[
        Limit {
            name: "aiding_frames",
            value: 4.0,
            unit: None,
            description: "Number of frames that the aiding frame configuration can define, according to MSCL.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1, uart_2 and usb_1",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.continuous_built_in_test_response.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: Some("comm_interface"),
            difference: "values of comm_interface; only main, uart_1, uart_2 and usb_1",
        },
        Variant {
            parameter: "3dm.pps_source_control.source",
            read_as: None,
            difference: "only disabled, gpio and generated",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only external",
        },
        Variant {
            parameter: "filter.aiding_measurement_enable.aiding_source",
            read_as: None,
            difference: "only gnss_position_velocity, altimeter, mag, external_heading, external_altimeter, external_mag, body_frame_velocity and all",
        },
        Variant {
            parameter: "filter.initialization_config.auto_heading_alignment_selector",
            read_as: None,
            difference: "only kinematic, mag and external",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("cv7_filter_state"),
            difference: "values of cv7_filter_state (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("cv7_dynamics_mode"),
            difference: "values of cv7_dynamics_mode (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("cv7_status_flags"),
            difference: "values of cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation)",
        },
        Variant {
            parameter: "system_data.built_in_test.result",
            read_as: Some("cv7_inertial_continuous_built_in_test"),
            difference: "values of cv7_inertial_continuous_built_in_test",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX3_15_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GX3_15_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX3-35.",
    absence: "",
};
#[rustfmt::skip]
const GX3_15_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GX3_15_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const GX3_15_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a pressure sensor, which the device lacks.",
    absence: "has no pressure sensor",
};

/// 3DM-GX3-15
///
/// Inertial sensor of generation 3.
///
/// Generation 3. Model number 6227. Sensors: accelerometer, gyroscope. GNSS receivers: none. GNSS
/// antennas: none. No manual is known. This profile is incomplete: Its manual (8500-0024, revision
/// 002 of 2012, for firmware 2.0.00 and later) is not known. Uncertain: The sensors are inferred
/// from the name of the model; that it has no magnetometer also from MSCL, which offers it no north
/// compensation.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GX3_15: Profile = Profile {
    id: "3dm-gx3-15",
    title: "3DM-GX3-15",
    description: "Inertial sensor of generation 3.",
    also: &[],
    model_number: Some(6227),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX3_15_2;
        0x01 0x02 "base.set_idle" [] GX3_15_2;
        0x01 0x03 "base.get_device_info" [] GX3_15_2;
        0x01 0x04 "base.get_device_descriptors" [] GX3_15_2;
        0x01 0x05 "base.built_in_test" [] GX3_15_2;
        0x01 0x06 "base.resume" [] GX3_15_2;
        0x0C 0x01 "3dm.poll_imu_data" [] GX3_15_2;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX3_15_2;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_15_2;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX3_15_2;
        0x0C 0x35 "3dm.imu_signal_conditioning" [WRITE READ SAVE LOAD DEFAULT] GX3_15_1;
        0x0C 0x36 "3dm.imu_timestamp" [WRITE READ] GX3_15_2;
        0x0C 0x61 "3dm.device_power_state" [WRITE READ SAVE LOAD DEFAULT] GX3_15_2;
        0x0C 0x64 "3dm.device_status" [] GX3_15_2;
        0x80 0x04 "sensor.scaled_accel" [] GX3_15_2;
        0x80 0x05 "sensor.scaled_gyro" [] GX3_15_2;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GX3_15_3;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX3_15_3;
        0x0C 0x09 "3dm.gnss_message_format" [] GX3_15_3;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX3_15_3;
        0x0C 0x21 "3dm.constellation_settings" [] GX3_15_3;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GX3_15_3;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GX3_15_3;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GX3_15_3;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GX3_15_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] GX3_15_4;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] GX3_15_4;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GX3_15_3;
        0x80 0x03 "sensor.raw_mag" [] GX3_15_4;
        0x80 0x06 "sensor.scaled_mag" [] GX3_15_4;
        0x80 0x16 "sensor.raw_pressure" [] GX3_15_5;
        0x80 0x17 "sensor.scaled_pressure" [] GX3_15_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GX3_15_3 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GX3_15_3 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GX3_15_3 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GX3_15_3 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.device_power_state.device",
            read_as: None,
            difference: "only imu",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX3_25_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GX3_25_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX3_25_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX3-35.",
    absence: "",
};
#[rustfmt::skip]
const GX3_25_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (ROS driver of the vendor: Issue 347).",
    absence: "",
};
#[rustfmt::skip]
const GX3_25_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (firmware 2.0.06; ROS driver of the vendor: Issue 213).",
    absence: "",
};
#[rustfmt::skip]
const GX3_25_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GX3_25_7: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a pressure sensor, which the device lacks.",
    absence: "has no pressure sensor",
};

/// 3DM-GX3-25
///
/// Inertial sensor of generation 3.
///
/// Generation 3. Model number 6223. Sensors: accelerometer, gyroscope, magnetometer. GNSS
/// receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: Its manual
/// (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known. Uncertain: The
/// sensors are inferred from the name of the model.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
#[rustfmt::skip]
pub static GX3_25: Profile = Profile {
    id: "3dm-gx3-25",
    title: "3DM-GX3-25",
    description: "Inertial sensor of generation 3.",
    also: &[],
    model_number: Some(6223),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX3_25_3;
        0x01 0x02 "base.set_idle" [] GX3_25_3;
        0x01 0x03 "base.get_device_info" [] GX3_25_3;
        0x01 0x04 "base.get_device_descriptors" [] GX3_25_3;
        0x01 0x05 "base.built_in_test" [] GX3_25_3;
        0x01 0x06 "base.resume" [] GX3_25_3;
        0x0C 0x01 "3dm.poll_imu_data" [] GX3_25_3;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX3_25_3;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_25_3;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX3_25_3;
        0x0C 0x35 "3dm.imu_signal_conditioning" [WRITE READ SAVE LOAD DEFAULT] GX3_25_1;
        0x0C 0x36 "3dm.imu_timestamp" [WRITE READ] GX3_25_3;
        0x0C 0x61 "3dm.device_power_state" [WRITE READ SAVE LOAD DEFAULT] GX3_25_2;
        0x0C 0x64 "3dm.device_status" [] GX3_25_3;
        0x80 0x04 "sensor.scaled_accel" [] GX3_25_3;
        0x80 0x05 "sensor.scaled_gyro" [] GX3_25_3;
        0x80 0x06 "sensor.scaled_mag" [] GX3_25_3;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GX3_25_6;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX3_25_6;
        0x0C 0x09 "3dm.gnss_message_format" [] GX3_25_6;
        0x0C 0x0C "3dm.nmea_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX3_25_6;
        0x0C 0x21 "3dm.constellation_settings" [] GX3_25_6;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GX3_25_6;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GX3_25_6;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GX3_25_6;
        0x0C 0x43 "3dm.odometer_config" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GX3_25_6;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0D 0x54 "filter.multi_antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0E 0x02 "gnss.signal_config" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x0E 0x10 "gnss.rtk_dongle_config" [WRITE READ SAVE LOAD DEFAULT] GX3_25_4;
        0x80 0x16 "sensor.raw_pressure" [] GX3_25_7;
        0x80 0x17 "sensor.scaled_pressure" [] GX3_25_7;
        0x81 0x03 "gnss_data.llh_position" [] GX3_25_5;
        0x81 0x05 "gnss_data.ned_velocity" [] GX3_25_5;
        0x81 0x0B "gnss_data.fix_info" [] GX3_25_5;
        0x82 0x01 "filter_data.llh_position" [] GX3_25_4;
        0x82 0x02 "filter_data.ned_velocity" [] GX3_25_4;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX3_25_4;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] GX3_25_4;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] GX3_25_4;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX3_25_4;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX3_25_4;
        0x82 0x10 "filter_data.status" [] GX3_25_4;
        0x82 0x36 "filter_data.ecef_position_uncertainty" [] GX3_25_4;
        0x82 0x37 "filter_data.ecef_velocity_uncertainty" [] GX3_25_4;
        0x82 0x40 "filter_data.ecef_position" [] GX3_25_4;
        0x82 0x41 "filter_data.ecef_velocity" [] GX3_25_4;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] GX3_25_5;
        0x91 0x03 "gnss_1.llh_position" [] GX3_25_5;
        0x91 0x05 "gnss_1.ned_velocity" [] GX3_25_5;
        0x91 0x0B "gnss_1.fix_info" [] GX3_25_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GX3_25_6 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GX3_25_6 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GX3_25_6 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GX3_25_6 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.device_power_state.device",
            read_as: None,
            difference: "only imu",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX3_35_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX3_35_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX3_35_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a pressure sensor, which the device lacks.",
    absence: "has no pressure sensor",
};
#[rustfmt::skip]
const GX3_35_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-GX3-35
///
/// Inertial sensor of generation 3.
///
/// Generation 3. Model number 6225. Sensors: accelerometer, gyroscope, magnetometer. GNSS
/// receivers: 1. GNSS antennas: 1. No manual is known. This profile is incomplete: Its manual (1.00
/// of 2011-01-04) is not known. Uncertain: The sensors are inferred from the name of the model.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features; mip-sdk-2014: Example of the
/// 3DM-GX3-35.
///
/// # Receiver
///
/// The GNSS receiver is made by u-blox.
#[rustfmt::skip]
pub static GX3_35: Profile = Profile {
    id: "3dm-gx3-35",
    title: "3DM-GX3-35",
    description: "Inertial sensor of generation 3.",
    also: &[],
    model_number: Some(6225),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "Its manual (1.00 of 2011-01-04) is not known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX3_35_1;
        0x01 0x02 "base.set_idle" [] GX3_35_1;
        0x01 0x03 "base.get_device_info" [] GX3_35_1;
        0x01 0x04 "base.get_device_descriptors" [] GX3_35_1;
        0x01 0x05 "base.built_in_test" [] GX3_35_1;
        0x01 0x06 "base.resume" [] GX3_35_1;
        0x0C 0x01 "3dm.poll_imu_data" [] GX3_35_1;
        0x0C 0x02 "3dm.poll_gnss_data" [] GX3_35_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX3_35_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX3_35_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x34 "3dm.gps_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x35 "3dm.imu_signal_conditioning" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x36 "3dm.imu_timestamp" [WRITE READ] GX3_35_1;
        0x0C 0x60 "3dm.data_stream_format" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x61 "3dm.device_power_state" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x0C 0x62 "3dm.gps_advanced_settings" [SAVE LOAD DEFAULT] GX3_35_2;
        0x0C 0x64 "3dm.device_status" [] GX3_35_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX3_35_1;
        0x80 0x04 "sensor.scaled_accel" [] GX3_35_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX3_35_1;
        0x80 0x06 "sensor.scaled_mag" [] GX3_35_1;
        0x81 0x03 "gnss_data.llh_position" [] GX3_35_1;
        0x81 0x05 "gnss_data.ned_velocity" [] GX3_35_1;
        0x81 0x09 "gnss_data.gps_time" [] GX3_35_1;
    },
    refuses: supported! {
        0x80 0x16 "sensor.raw_pressure" [] GX3_35_3;
        0x80 0x17 "sensor.scaled_pressure" [] GX3_35_3;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: GX3_35_4 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX3_45_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX3_45_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GX3_45_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX3-35.",
    absence: "",
};
#[rustfmt::skip]
const GX3_45_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a pressure sensor, which the device lacks.",
    absence: "has no pressure sensor",
};
#[rustfmt::skip]
const GX3_45_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const GX3_45_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-GX3-45
///
/// Inertial sensor of generation 3.
///
/// Generation 3. Model number 6228. Sensors: accelerometer, gyroscope, magnetometer. GNSS
/// receivers: 1. GNSS antennas: 1. No manual is known. This profile is incomplete: No manual is
/// known. Uncertain: The SDK of 2014 has the model number 6226. Uncertain: The sensors are inferred
/// from the name of the model.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features; mip-sdk-2014: Example of the
/// 3DM-GX3-45.
#[rustfmt::skip]
pub static GX3_45: Profile = Profile {
    id: "3dm-gx3-45",
    title: "3DM-GX3-45",
    description: "Inertial sensor of generation 3.",
    also: &[],
    model_number: Some(6228),
    generation: Some(3),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX3_45_1;
        0x01 0x02 "base.set_idle" [] GX3_45_1;
        0x01 0x03 "base.get_device_info" [] GX3_45_1;
        0x01 0x04 "base.get_device_descriptors" [] GX3_45_1;
        0x01 0x05 "base.built_in_test" [] GX3_45_1;
        0x01 0x06 "base.resume" [] GX3_45_3;
        0x0C 0x01 "3dm.poll_imu_data" [] GX3_45_3;
        0x0C 0x02 "3dm.poll_gnss_data" [] GX3_45_3;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX3_45_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX3_45_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX3_45_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0C 0x35 "3dm.imu_signal_conditioning" [WRITE READ SAVE LOAD DEFAULT] GX3_45_3;
        0x0C 0x36 "3dm.imu_timestamp" [WRITE READ] GX3_45_3;
        0x0C 0x64 "3dm.device_status" [] GX3_45_3;
        0x0D 0x01 "filter.reset" [] GX3_45_1;
        0x0D 0x02 "filter.set_initial_attitude" [] GX3_45_1;
        0x0D 0x03 "filter.set_initial_heading" [] GX3_45_1;
        0x0D 0x04 "filter.set_initial_attitude_from_imu" [] GX3_45_1;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX3_45_2;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX3_45_2;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX3_45_1;
        0x80 0x04 "sensor.scaled_accel" [] GX3_45_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX3_45_1;
        0x80 0x06 "sensor.scaled_mag" [] GX3_45_1;
        0x81 0x03 "gnss_data.llh_position" [] GX3_45_1;
        0x81 0x05 "gnss_data.ned_velocity" [] GX3_45_1;
        0x81 0x09 "gnss_data.gps_time" [] GX3_45_1;
        0x82 0x01 "filter_data.llh_position" [] GX3_45_1;
        0x82 0x02 "filter_data.ned_velocity" [] GX3_45_1;
        0x82 0x05 "filter_data.euler_angles" [] GX3_45_1;
    },
    refuses: supported! {
        0x0D 0x29 "filter.pressure_altitude_noise" [] GX3_45_4;
        0x0D 0x47 "filter.altitude_aiding" [] GX3_45_4;
        0x80 0x16 "sensor.raw_pressure" [] GX3_45_4;
        0x80 0x17 "sensor.scaled_pressure" [] GX3_45_4;
        0x82 0x21 "filter_data.pressure_altitude" [] GX3_45_4;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX3_45_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: GX3_45_6 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal, external and internal_1",
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
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX4_15_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX4_15_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX4-25.",
    absence: "",
};
#[rustfmt::skip]
const GX4_15_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GX4_15_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const GX4_15_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-GX4-15
///
/// Device of generation 4.
///
/// Generation 4. Model number 6233. Sensors: accelerometer, gyroscope, pressure sensor. GNSS
/// receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
/// is known. Uncertain: The sensors are inferred from the name of the model; that it has no
/// magnetometer also from MSCL, which offers it no north compensation.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Direct modes
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor
/// or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the
/// 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.
///
/// # Device status
///
/// According to MSCL, it replies with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticGx4Response`](crate::mip_3dm::DeviceStatusDiagnosticGx4Response).
#[rustfmt::skip]
pub static GX4_15: Profile = Profile {
    id: "3dm-gx4-15",
    title: "3DM-GX4-15",
    description: "Device of generation 4.",
    also: &[],
    model_number: Some(6233),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX4_15_1;
        0x01 0x02 "base.set_idle" [] GX4_15_1;
        0x01 0x03 "base.get_device_info" [] GX4_15_1;
        0x01 0x04 "base.get_device_descriptors" [] GX4_15_1;
        0x01 0x05 "base.built_in_test" [] GX4_15_1;
        0x01 0x06 "base.resume" [] GX4_15_2;
        0x01 0x7E "base.soft_reset" [] GX4_15_2;
        0x0C 0x01 "3dm.poll_imu_data" [] GX4_15_1;
        0x0C 0x03 "3dm.poll_filter_data" [] GX4_15_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX4_15_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX4_15_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX4_15_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_15_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_15_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX4_15_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX4_15_2;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX4_15_2;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX4_15_2;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0C 0x64 "3dm.device_status" [] GX4_15_1;
        0x0D 0x01 "filter.reset" [] GX4_15_1;
        0x0D 0x02 "filter.set_initial_attitude" [] GX4_15_1;
        0x0D 0x03 "filter.set_initial_heading" [] GX4_15_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GX4_15_1;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX4_15_1;
        0x80 0x04 "sensor.scaled_accel" [] GX4_15_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX4_15_1;
        0x80 0x07 "sensor.delta_theta" [] GX4_15_2;
        0x80 0x08 "sensor.delta_velocity" [] GX4_15_2;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX4_15_2;
        0x80 0x0A "sensor.comp_quaternion" [] GX4_15_2;
        0x80 0x0C "sensor.comp_euler_angles" [] GX4_15_2;
        0x80 0x10 "sensor.north_vector" [] GX4_15_2;
        0x80 0x11 "sensor.up_vector" [] GX4_15_2;
        0x80 0x12 "sensor.gps_timestamp" [] GX4_15_2;
        0x80 0x17 "sensor.scaled_pressure" [] GX4_15_2;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX4_15_2;
        0x82 0x04 "filter_data.attitude_dcm" [] GX4_15_2;
        0x82 0x05 "filter_data.euler_angles" [] GX4_15_1;
        0x82 0x06 "filter_data.gyro_bias" [] GX4_15_2;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX4_15_2;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GX4_15_2;
        0x82 0x0D "filter_data.linear_accel" [] GX4_15_2;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX4_15_2;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] GX4_15_2;
        0x82 0x10 "filter_data.status" [] GX4_15_2;
        0x82 0x11 "filter_data.timestamp" [] GX4_15_2;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GX4_15_2;
        0x82 0x13 "filter_data.gravity_vector" [] GX4_15_2;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GX4_15_3;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX4_15_3;
        0x0C 0x09 "3dm.gnss_message_format" [] GX4_15_3;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX4_15_3;
        0x0C 0x21 "3dm.constellation_settings" [] GX4_15_3;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GX4_15_3;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GX4_15_3;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GX4_15_3;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GX4_15_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] GX4_15_4;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] GX4_15_4;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GX4_15_3;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] GX4_15_4;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] GX4_15_4;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] GX4_15_4;
        0x0D 0x42 "filter.mag_noise" [] GX4_15_4;
        0x0D 0x43 "filter.magnetic_declination_source" [] GX4_15_4;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] GX4_15_4;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] GX4_15_4;
        0x0D 0x4C "filter.magnetic_inclination_source" [] GX4_15_4;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] GX4_15_4;
        0x0D 0x54 "filter.multi_antenna_offset" [] GX4_15_3;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GX4_15_3;
        0x80 0x03 "sensor.raw_mag" [] GX4_15_4;
        0x80 0x06 "sensor.scaled_mag" [] GX4_15_4;
        0x82 0x1A "filter_data.mag_bias" [] GX4_15_4;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] GX4_15_4;
        0x82 0x25 "filter_data.mag_offset" [] GX4_15_4;
        0x82 0x26 "filter_data.mag_matrix" [] GX4_15_4;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] GX4_15_4;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] GX4_15_4;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] GX4_15_4;
        0x82 0x2C "filter_data.mag_residual_vector" [] GX4_15_4;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GX4_15_3;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GX4_15_3;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX4_15_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GX4_15_3 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GX4_15_3 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GX4_15_3 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GX4_15_3 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX4_25_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX4_25_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (Public programs of users: Driver imu_3dm_gx4).",
    absence: "",
};
#[rustfmt::skip]
const GX4_25_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-25.",
    absence: "",
};
#[rustfmt::skip]
const GX4_25_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (MicroStrain Communication Library: Issue 30).",
    absence: "",
};
#[rustfmt::skip]
const GX4_25_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GX4_25_6: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-GX4-25
///
/// Device of generation 4.
///
/// Generation 4. Model number 6234. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
/// incomplete: Its manual (of 2014-12-23) is not known. Uncertain: A third-party ROS driver uses
/// the model number 6253 for it, which is that of the 3DM-GX5-25. Uncertain: The sensors are
/// inferred from the name of the model.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Direct modes
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor
/// or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the
/// 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.
///
/// # Device status
///
/// According to MSCL, it replies with
/// [`mip_3dm::DeviceStatusBasicWithoutStateResponse`](crate::mip_3dm::DeviceStatusBasicWithoutStateResponse)
/// and
/// [`mip_3dm::DeviceStatusDiagnosticGx4Response`](crate::mip_3dm::DeviceStatusDiagnosticGx4Response).
#[rustfmt::skip]
pub static GX4_25: Profile = Profile {
    id: "3dm-gx4-25",
    title: "3DM-GX4-25",
    description: "Device of generation 4.",
    also: &[],
    model_number: Some(6234),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "Its manual (of 2014-12-23) is not known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX4_25_1;
        0x01 0x02 "base.set_idle" [] GX4_25_1;
        0x01 0x03 "base.get_device_info" [] GX4_25_1;
        0x01 0x04 "base.get_device_descriptors" [] GX4_25_1;
        0x01 0x05 "base.built_in_test" [] GX4_25_1;
        0x01 0x06 "base.resume" [] GX4_25_2;
        0x01 0x7E "base.soft_reset" [] GX4_25_3;
        0x0C 0x01 "3dm.poll_imu_data" [] GX4_25_1;
        0x0C 0x03 "3dm.poll_filter_data" [] GX4_25_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX4_25_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX4_25_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX4_25_3;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_25_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_25_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX4_25_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_25_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_25_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX4_25_3;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX4_25_2;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX4_25_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0C 0x64 "3dm.device_status" [] GX4_25_1;
        0x0D 0x01 "filter.reset" [] GX4_25_1;
        0x0D 0x02 "filter.set_initial_attitude" [] GX4_25_1;
        0x0D 0x03 "filter.set_initial_heading" [] GX4_25_1;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x17 "filter.external_heading_update" [] GX4_25_1;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GX4_25_1;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GX4_25_1;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] GX4_25_2;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX4_25_1;
        0x80 0x04 "sensor.scaled_accel" [] GX4_25_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX4_25_1;
        0x80 0x06 "sensor.scaled_mag" [] GX4_25_1;
        0x80 0x07 "sensor.delta_theta" [] GX4_25_3;
        0x80 0x08 "sensor.delta_velocity" [] GX4_25_3;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX4_25_3;
        0x80 0x0A "sensor.comp_quaternion" [] GX4_25_3;
        0x80 0x0C "sensor.comp_euler_angles" [] GX4_25_3;
        0x80 0x10 "sensor.north_vector" [] GX4_25_3;
        0x80 0x11 "sensor.up_vector" [] GX4_25_3;
        0x80 0x12 "sensor.gps_timestamp" [] GX4_25_3;
        0x80 0x17 "sensor.scaled_pressure" [] GX4_25_2;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX4_25_2;
        0x82 0x04 "filter_data.attitude_dcm" [] GX4_25_3;
        0x82 0x05 "filter_data.euler_angles" [] GX4_25_1;
        0x82 0x06 "filter_data.gyro_bias" [] GX4_25_2;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX4_25_2;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GX4_25_2;
        0x82 0x0D "filter_data.linear_accel" [] GX4_25_3;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX4_25_3;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] GX4_25_3;
        0x82 0x10 "filter_data.status" [] GX4_25_3;
        0x82 0x11 "filter_data.timestamp" [] GX4_25_3;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GX4_25_3;
        0x82 0x13 "filter_data.gravity_vector" [] GX4_25_3;
        0x82 0x14 "filter_data.heading_update_state" [] GX4_25_3;
        0x82 0x15 "filter_data.magnetic_model" [] GX4_25_3;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GX4_25_5;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX4_25_5;
        0x0C 0x09 "3dm.gnss_message_format" [] GX4_25_5;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX4_25_5;
        0x0C 0x21 "3dm.constellation_settings" [] GX4_25_5;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GX4_25_5;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GX4_25_5;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GX4_25_5;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GX4_25_5;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GX4_25_5;
        0x0D 0x54 "filter.multi_antenna_offset" [] GX4_25_5;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GX4_25_5;
        0x82 0x07 "filter_data.accel_bias" [] GX4_25_4;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GX4_25_5;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GX4_25_5;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX4_25_6;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GX4_25_5 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GX4_25_5 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GX4_25_5 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GX4_25_5 },
    ],
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 500.0 },
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are unknown",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
        Variant {
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only mag and external",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX4_45_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX4_45_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-25.",
    absence: "",
};
#[rustfmt::skip]
const GX4_45_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const GX4_45_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-GX4-45
///
/// Device of generation 4.
///
/// Generation 4. Model number 6236. Sensors: accelerometer, gyroscope, magnetometer, pressure
/// sensor. GNSS receivers: 1. GNSS antennas: 1. No manual is known. This profile is incomplete: No
/// manual is known. Uncertain: The sensors are inferred from the name of the model.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Direct modes
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor
/// or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the
/// 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.
///
/// # Device status
///
/// According to MSCL, it replies with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static GX4_45: Profile = Profile {
    id: "3dm-gx4-45",
    title: "3DM-GX4-45",
    description: "Device of generation 4.",
    also: &[],
    model_number: Some(6236),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX4_45_1;
        0x01 0x02 "base.set_idle" [] GX4_45_1;
        0x01 0x03 "base.get_device_info" [] GX4_45_1;
        0x01 0x04 "base.get_device_descriptors" [] GX4_45_1;
        0x01 0x05 "base.built_in_test" [] GX4_45_1;
        0x01 0x06 "base.resume" [] GX4_45_2;
        0x01 0x7E "base.soft_reset" [] GX4_45_2;
        0x0C 0x01 "3dm.poll_imu_data" [] GX4_45_1;
        0x0C 0x02 "3dm.poll_gnss_data" [] GX4_45_1;
        0x0C 0x03 "3dm.poll_filter_data" [] GX4_45_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX4_45_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX4_45_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX4_45_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX4_45_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_45_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_45_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX4_45_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_45_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_45_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX4_45_2;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX4_45_2;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX4_45_2;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0C 0x64 "3dm.device_status" [] GX4_45_1;
        0x0D 0x01 "filter.reset" [] GX4_45_1;
        0x0D 0x02 "filter.set_initial_attitude" [] GX4_45_1;
        0x0D 0x03 "filter.set_initial_heading" [] GX4_45_1;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x16 "filter.external_gnss_update" [] GX4_45_1;
        0x0D 0x17 "filter.external_heading_update" [] GX4_45_1;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GX4_45_1;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x22 "filter.commanded_zupt" [] GX4_45_1;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GX4_45_1;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX4_45_1;
        0x80 0x04 "sensor.scaled_accel" [] GX4_45_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX4_45_1;
        0x80 0x06 "sensor.scaled_mag" [] GX4_45_1;
        0x80 0x07 "sensor.delta_theta" [] GX4_45_2;
        0x80 0x08 "sensor.delta_velocity" [] GX4_45_2;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX4_45_2;
        0x80 0x0A "sensor.comp_quaternion" [] GX4_45_2;
        0x80 0x0C "sensor.comp_euler_angles" [] GX4_45_2;
        0x80 0x10 "sensor.north_vector" [] GX4_45_2;
        0x80 0x11 "sensor.up_vector" [] GX4_45_2;
        0x80 0x12 "sensor.gps_timestamp" [] GX4_45_2;
        0x80 0x17 "sensor.scaled_pressure" [] GX4_45_2;
        0x81 0x03 "gnss_data.llh_position" [] GX4_45_1;
        0x81 0x05 "gnss_data.ned_velocity" [] GX4_45_1;
        0x81 0x09 "gnss_data.gps_time" [] GX4_45_1;
        0x82 0x01 "filter_data.llh_position" [] GX4_45_1;
        0x82 0x02 "filter_data.ned_velocity" [] GX4_45_1;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX4_45_2;
        0x82 0x04 "filter_data.attitude_dcm" [] GX4_45_2;
        0x82 0x05 "filter_data.euler_angles" [] GX4_45_1;
        0x82 0x06 "filter_data.gyro_bias" [] GX4_45_2;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX4_45_2;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GX4_45_2;
        0x82 0x0D "filter_data.linear_accel" [] GX4_45_2;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX4_45_2;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] GX4_45_2;
        0x82 0x10 "filter_data.status" [] GX4_45_2;
        0x82 0x11 "filter_data.timestamp" [] GX4_45_2;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GX4_45_2;
        0x82 0x13 "filter_data.gravity_vector" [] GX4_45_2;
        0x82 0x14 "filter_data.heading_update_state" [] GX4_45_2;
        0x82 0x15 "filter_data.magnetic_model" [] GX4_45_2;
    },
    refuses: supported! {
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX4_45_3;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: GX4_45_4 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "3dm.device_status_basic_response.system_state",
            read_as: Some("gx4_system_state"),
            difference: "values of gx4_system_state",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal, external and internal_1",
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
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX4_IMU_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const GX4_IMU_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-GX4-25.",
    absence: "",
};

/// 3DM-GX4-IMU
///
/// Inertial sensor inside the 3DM-GX4-45, which replies in the direct mode.
///
/// Generation 4. Model number 6237. No manual is known. This profile is incomplete: No manual is
/// known.
///
/// Source: mip-sdk-2014: GX4 IMU.
#[rustfmt::skip]
pub static GX4_IMU: Profile = Profile {
    id: "3dm-gx4-imu",
    title: "3DM-GX4-IMU",
    description: "Inertial sensor inside the 3DM-GX4-45, which replies in the direct mode.",
    also: &[],
    model_number: Some(6237),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX4_IMU_1;
        0x01 0x02 "base.set_idle" [] GX4_IMU_1;
        0x01 0x03 "base.get_device_info" [] GX4_IMU_1;
        0x01 0x04 "base.get_device_descriptors" [] GX4_IMU_1;
        0x01 0x05 "base.built_in_test" [] GX4_IMU_1;
        0x01 0x06 "base.resume" [] GX4_IMU_2;
        0x0C 0x01 "3dm.poll_imu_data" [] GX4_IMU_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX4_IMU_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX4_IMU_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_IMU_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_IMU_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX4_IMU_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_IMU_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GX4_IMU_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX4_IMU_1;
        0x0C 0x64 "3dm.device_status" [] GX4_IMU_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX4_IMU_1;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX5_15_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const GX5_15_2: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (MicroStrain Communication Library: Issue 301).",
    absence: "",
};
#[rustfmt::skip]
const GX5_15_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const GX5_15_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};
#[rustfmt::skip]
const GX5_15_5: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};

/// 3DM-GX5-15
///
/// Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter.
///
/// Also called 3DM-GX5-AR. Generation 5. Model number 6254. Sensors: accelerometer, gyroscope,
/// pressure sensor. GNSS receivers: none. GNSS antennas: none. Manual: LORD Sensing 3DM-GX5-15 Data
/// Communications Protocol, 8500-0067 rev. E.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Base rates
///
/// The manual states both 1000 and 500 for each stream. Read the base rates from the device before
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
/// Connect the PPS signal to pin 7 of the connector, and send
/// [`base::GpsTimeUpdate`](crate::base::GpsTimeUpdate) once per second. The filter and sensor
/// timestamps are then synchronized with them.
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
        0x01 0x01 "base.ping" [] GX5_15_1;
        0x01 0x02 "base.set_idle" [] GX5_15_1;
        0x01 0x03 "base.get_device_info" [] GX5_15_1;
        0x01 0x04 "base.get_device_descriptors" [] GX5_15_1;
        0x01 0x05 "base.built_in_test" [] GX5_15_1;
        0x01 0x06 "base.resume" [] GX5_15_1;
        0x01 0x07 "base.get_extended_descriptors" [] GX5_15_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GX5_15_1;
        0x01 0x7E "base.soft_reset" [] GX5_15_1;
        0x0C 0x01 "3dm.poll_imu_data" [] GX5_15_1;
        0x0C 0x03 "3dm.poll_filter_data" [] GX5_15_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX5_15_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX5_15_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_15_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_15_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX5_15_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0C 0x64 "3dm.device_status" [] GX5_15_1;
        0x0D 0x01 "filter.reset" [] GX5_15_1;
        0x0D 0x02 "filter.set_initial_attitude" [] GX5_15_1;
        0x0D 0x03 "filter.set_initial_heading" [] GX5_15_1;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x17 "filter.external_heading_update" [] GX5_15_1;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GX5_15_1;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x21 "filter.tare_orientation" [WRITE SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GX5_15_1;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX5_15_1;
        0x80 0x04 "sensor.scaled_accel" [] GX5_15_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX5_15_1;
        0x80 0x07 "sensor.delta_theta" [] GX5_15_1;
        0x80 0x08 "sensor.delta_velocity" [] GX5_15_1;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX5_15_1;
        0x80 0x0A "sensor.comp_quaternion" [] GX5_15_1;
        0x80 0x0C "sensor.comp_euler_angles" [] GX5_15_1;
        0x80 0x10 "sensor.north_vector" [] GX5_15_1;
        0x80 0x11 "sensor.up_vector" [] GX5_15_1;
        0x80 0x12 "sensor.gps_timestamp" [] GX5_15_1;
        0x80 0x17 "sensor.scaled_pressure" [] GX5_15_1;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX5_15_1;
        0x82 0x04 "filter_data.attitude_dcm" [] GX5_15_1;
        0x82 0x05 "filter_data.euler_angles" [] GX5_15_1;
        0x82 0x06 "filter_data.gyro_bias" [] GX5_15_1;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX5_15_1;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GX5_15_1;
        0x82 0x0D "filter_data.linear_accel" [] GX5_15_1;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX5_15_1;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] GX5_15_1;
        0x82 0x10 "filter_data.status" [] GX5_15_1;
        0x82 0x11 "filter_data.timestamp" [] GX5_15_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GX5_15_1;
        0x82 0x13 "filter_data.gravity_vector" [] GX5_15_1;
        0x82 0x14 "filter_data.heading_update_state" [] GX5_15_1;
        0x82 0x1C "filter_data.comp_accel" [] GX5_15_1;
        0x82 0x21 "filter_data.pressure_altitude" [] GX5_15_1;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GX5_15_3;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX5_15_3;
        0x0C 0x09 "3dm.gnss_message_format" [] GX5_15_3;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX5_15_3;
        0x0C 0x21 "3dm.constellation_settings" [] GX5_15_3;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GX5_15_3;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GX5_15_3;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GX5_15_3;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GX5_15_3;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] GX5_15_4;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] GX5_15_4;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GX5_15_3;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [] GX5_15_4;
        0x0D 0x2B "filter.hard_iron_offset_noise" [] GX5_15_4;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [] GX5_15_4;
        0x0D 0x42 "filter.mag_noise" [] GX5_15_4;
        0x0D 0x43 "filter.magnetic_declination_source" [] GX5_15_4;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [] GX5_15_4;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [] GX5_15_4;
        0x0D 0x4C "filter.magnetic_inclination_source" [] GX5_15_4;
        0x0D 0x4D "filter.magnetic_magnitude_source" [] GX5_15_4;
        0x0D 0x54 "filter.multi_antenna_offset" [] GX5_15_3;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GX5_15_3;
        0x80 0x01 "sensor.raw_accel" [] GX5_15_2;
        0x80 0x02 "sensor.raw_gyro" [] GX5_15_2;
        0x80 0x03 "sensor.raw_mag" [] GX5_15_4;
        0x80 0x06 "sensor.scaled_mag" [] GX5_15_4;
        0x82 0x1A "filter_data.mag_bias" [] GX5_15_4;
        0x82 0x1B "filter_data.mag_bias_uncertainty" [] GX5_15_4;
        0x82 0x25 "filter_data.mag_offset" [] GX5_15_4;
        0x82 0x26 "filter_data.mag_matrix" [] GX5_15_4;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] GX5_15_4;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] GX5_15_4;
        0x82 0x2A "filter_data.mag_covariance_matrix" [] GX5_15_4;
        0x82 0x2C "filter_data.mag_residual_vector" [] GX5_15_4;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GX5_15_3;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GX5_15_3;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX5_15_5;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GX5_15_3 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GX5_15_3 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GX5_15_3 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GX5_15_3 },
    ],
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 1000.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 500.0 },
    ],
    ports: &[
        ProfilePort {
            name: "UART 1",
            id: None,
            baud_rates: &[9600, 19200, 115200, 230400, 460800, 921600],
            receives: &["MIP"],
            sends: &["MIP"],
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
            name: "low_pass_cutoff",
            value: 250.0,
            unit: Some("Hz"),
            description: "Maximum cutoff frequency of the low-pass filters.",
            firmware: None,
        },
        Limit {
            name: "external_heading_rate",
            value: 20.0,
            unit: Some("Hz"),
            description: "Maximum rate of external heading updates.",
            firmware: None,
        },
        Limit {
            name: "zero_angular_rate_update_rate",
            value: 10.0,
            unit: Some("Hz"),
            description: "Maximum rate of commanded zero angular rate updates.",
            firmware: None,
        },
        Limit {
            name: "baud_rate_delay",
            value: 250.0,
            unit: Some("ms"),
            description: "Time from the ACK of a new baud rate until the device replies to commands at that rate.",
            firmware: None,
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
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.comp_orientation_matrix.m",
            read_as: None,
            difference: "Rotates vectors of the NED frame into the sensor frame; row-major",
        },
        Variant {
            parameter: "sensor.comp_quaternion.q",
            read_as: None,
            difference: "Rotates vectors of the sensor frame into the NED frame; Hamilton quaternion, w first",
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

#[rustfmt::skip]
const GX5_25_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Transcribed from the manual by others (Public programs of users: Parser of 3DM-GX5-25 data in MATLAB, 2018).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_4: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver microstrain_mips: Table of tested functions).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_5: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver microstrain_mips: Conditions by model).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_6: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_7: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_8: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (ROS driver of the vendor: Issue 238).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_9: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (firmware 1.1.76; ROS driver of the vendor: Issue 368).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_10: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (ROS driver of the vendor: Issue 59; MicroStrain Communication Library: Issue 200).",
    absence: "",
};
#[rustfmt::skip]
const GX5_25_11: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};

/// 3DM-GX5-25
///
/// Attitude and heading reference system.
///
/// Also called 3DM-GX5-AHRS. Generation 5. Model number 6253. Sensors: accelerometer, gyroscope,
/// magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known.
/// This profile is incomplete: Its manual (8500-0065) is not known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "Its manual (8500-0065) is not known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX5_25_2;
        0x01 0x02 "base.set_idle" [] GX5_25_2;
        0x01 0x03 "base.get_device_info" [] GX5_25_3;
        0x01 0x04 "base.get_device_descriptors" [] GX5_25_6;
        0x01 0x05 "base.built_in_test" [] GX5_25_7;
        0x01 0x06 "base.resume" [] GX5_25_2;
        0x01 0x07 "base.get_extended_descriptors" [] GX5_25_6;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GX5_25_7;
        0x01 0x7E "base.soft_reset" [] GX5_25_7;
        0x0C 0x01 "3dm.poll_imu_data" [] GX5_25_7;
        0x0C 0x03 "3dm.poll_filter_data" [] GX5_25_7;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX5_25_2;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_25_2;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_25_2;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX5_25_2;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX5_25_2;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_25_4;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_25_4;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX5_25_2;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_25_4;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_25_4;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0C 0x64 "3dm.device_status" [] GX5_25_4;
        0x0D 0x01 "filter.reset" [] GX5_25_3;
        0x0D 0x02 "filter.set_initial_attitude" [] GX5_25_4;
        0x0D 0x03 "filter.set_initial_heading" [] GX5_25_4;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GX5_25_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x17 "filter.external_heading_update" [] GX5_25_7;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GX5_25_3;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX5_25_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GX5_25_7;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GX5_25_7;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [WRITE SAVE] GX5_25_7;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x29 "filter.pressure_altitude_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x2B "filter.hard_iron_offset_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x41 "filter.enable_measurements" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_25_5;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_25_5;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x47 "filter.altitude_aiding" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] GX5_25_7;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX5_25_4;
        0x80 0x04 "sensor.scaled_accel" [] GX5_25_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX5_25_1;
        0x80 0x06 "sensor.scaled_mag" [] GX5_25_1;
        0x80 0x07 "sensor.delta_theta" [] GX5_25_1;
        0x80 0x08 "sensor.delta_velocity" [] GX5_25_1;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX5_25_1;
        0x80 0x0A "sensor.comp_quaternion" [] GX5_25_1;
        0x80 0x0C "sensor.comp_euler_angles" [] GX5_25_1;
        0x80 0x10 "sensor.north_vector" [] GX5_25_1;
        0x80 0x11 "sensor.up_vector" [] GX5_25_1;
        0x80 0x12 "sensor.gps_timestamp" [] GX5_25_1;
        0x80 0x17 "sensor.scaled_pressure" [] GX5_25_1;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX5_25_1;
        0x82 0x04 "filter_data.attitude_dcm" [] GX5_25_1;
        0x82 0x05 "filter_data.euler_angles" [] GX5_25_1;
        0x82 0x06 "filter_data.gyro_bias" [] GX5_25_1;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX5_25_1;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GX5_25_1;
        0x82 0x0D "filter_data.linear_accel" [] GX5_25_1;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX5_25_1;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] GX5_25_1;
        0x82 0x10 "filter_data.status" [] GX5_25_1;
        0x82 0x11 "filter_data.timestamp" [] GX5_25_1;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GX5_25_1;
        0x82 0x13 "filter_data.gravity_vector" [] GX5_25_1;
        0x82 0x14 "filter_data.heading_update_state" [] GX5_25_1;
        0x82 0x15 "filter_data.magnetic_model" [] GX5_25_1;
        0x82 0x1C "filter_data.comp_accel" [] GX5_25_1;
        0x82 0x21 "filter_data.pressure_altitude" [] GX5_25_1;
        0x82 0x25 "filter_data.mag_offset" [] GX5_25_1;
        0x82 0x26 "filter_data.mag_matrix" [] GX5_25_1;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] GX5_25_1;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] GX5_25_1;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] GX5_25_11;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX5_25_11;
        0x0C 0x09 "3dm.gnss_message_format" [] GX5_25_11;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX5_25_11;
        0x0C 0x21 "3dm.constellation_settings" [] GX5_25_11;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] GX5_25_11;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] GX5_25_11;
        0x0C 0x24 "3dm.gnss_time_assistance" [] GX5_25_11;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] GX5_25_11;
        0x0C 0x41 "3dm.gpio_config" [WRITE READ SAVE LOAD DEFAULT] GX5_25_8;
        0x0C 0x62 "3dm.gps_advanced_settings" [] GX5_25_11;
        0x0D 0x54 "filter.multi_antenna_offset" [] GX5_25_11;
        0x0D 0x64 "filter.gnss_antenna_calibration_control" [] GX5_25_11;
        0x80 0x18 "sensor.overrange_status" [] GX5_25_9;
        0x81 0x03 "gnss_data.llh_position" [] GX5_25_8;
        0x81 0x0B "gnss_data.fix_info" [] GX5_25_8;
        0x82 0x01 "filter_data.llh_position" [] GX5_25_9;
        0x82 0x02 "filter_data.ned_velocity" [] GX5_25_10;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] GX5_25_9;
        0x82 0x34 "filter_data.multi_antenna_offset_correction" [] GX5_25_11;
        0x82 0x35 "filter_data.multi_antenna_offset_correction_uncertainty" [] GX5_25_11;
        0x82 0x43 "filter_data.gnss_position_aiding_status" [] GX5_25_8;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX5_25_8;
        0x91 0x03 "gnss_1.llh_position" [] GX5_25_8;
        0x91 0x0B "gnss_1.fix_info" [] GX5_25_8;
        0x92 0x0B "gnss_2.fix_info" [] GX5_25_9;
        0x92 0x12 "gnss_2.sbas_info" [] GX5_25_9;
        0x92 0x14 "gnss_2.rf_error_detection" [] GX5_25_9;
        0x93 0x31 "gnss_corrections.rtk_corrections_status" [] GX5_25_8;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: GX5_25_11 },
        AbsentSet { set: DescriptorSet(0x91), evidence: GX5_25_11 },
        AbsentSet { set: DescriptorSet(0x92), evidence: GX5_25_11 },
        AbsentSet { set: DescriptorSet(0x93), evidence: GX5_25_11 },
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("gx5_built_in_test"),
            difference: "values of gx5_built_in_test (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "3dm.data_stream_control.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
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
        Variant {
            parameter: "system.comm_mode.mode",
            read_as: None,
            difference: "only standard and sensor_direct",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.heading_update_state.source",
            read_as: None,
            difference: "only mag and external",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const GX5_35_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const GX5_35_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GX5_35_3: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
    absence: "",
};
#[rustfmt::skip]
const GX5_35_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-GX5-35
///
/// Attitude and heading reference system (AHRS) with GNSS.
///
/// Also called 3DM-GX5-GNSS/AHRS. Generation 5. Model number 6252. Sensors: accelerometer,
/// gyroscope, magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD
/// 3DM-GX5-35 DCP Manual, revision unknown, known from some pages. This profile is incomplete: Only
/// some pages of its manual are known; the device has further commands and data. Uncertain: The
/// base rates are those that the manual states for all 3DM-GX5.
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
/// It replies with
/// [`mip_3dm::DeviceStatusBasicResponse`](crate::mip_3dm::DeviceStatusBasicResponse) and
/// [`mip_3dm::DeviceStatusDiagnosticGnssResponse`](crate::mip_3dm::DeviceStatusDiagnosticGnssResponse).
#[rustfmt::skip]
pub static GX5_35: Profile = Profile {
    id: "3dm-gx5-35",
    title: "3DM-GX5-35",
    description: "Attitude and heading reference system (AHRS) with GNSS.",
    also: &["3DM-GX5-GNSS/AHRS"],
    model_number: Some(6252),
    generation: Some(5),
    manual: Some("3dm-gx5-35"),
    incomplete: &[
        "Only some pages of its manual are known; the device has further commands and data.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX5_35_1;
        0x01 0x02 "base.set_idle" [] GX5_35_2;
        0x01 0x03 "base.get_device_info" [] GX5_35_1;
        0x01 0x04 "base.get_device_descriptors" [] GX5_35_1;
        0x01 0x05 "base.built_in_test" [] GX5_35_3;
        0x01 0x06 "base.resume" [] GX5_35_2;
        0x01 0x07 "base.get_extended_descriptors" [] GX5_35_1;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GX5_35_1;
        0x01 0x7E "base.soft_reset" [] GX5_35_3;
        0x0C 0x01 "3dm.poll_imu_data" [] GX5_35_1;
        0x0C 0x02 "3dm.poll_gnss_data" [] GX5_35_3;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX5_35_2;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX5_35_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x23 "3dm.gnss_assisted_fix" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x24 "3dm.gnss_time_assistance" [WRITE READ] GX5_35_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_35_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_35_3;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX5_35_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_35_3;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_35_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX5_35_3;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX5_35_3;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_35_3;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x0C 0x64 "3dm.device_status" [] GX5_35_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX5_35_1;
        0x80 0x04 "sensor.scaled_accel" [] GX5_35_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX5_35_1;
        0x80 0x06 "sensor.scaled_mag" [] GX5_35_1;
        0x80 0x07 "sensor.delta_theta" [] GX5_35_1;
        0x80 0x08 "sensor.delta_velocity" [] GX5_35_3;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX5_35_3;
        0x80 0x0A "sensor.comp_quaternion" [] GX5_35_3;
        0x80 0x0C "sensor.comp_euler_angles" [] GX5_35_3;
        0x80 0x10 "sensor.north_vector" [] GX5_35_3;
        0x80 0x11 "sensor.up_vector" [] GX5_35_1;
        0x80 0x12 "sensor.gps_timestamp" [] GX5_35_1;
        0x80 0x17 "sensor.scaled_pressure" [] GX5_35_1;
        0x81 0x03 "gnss_data.llh_position" [] GX5_35_3;
        0x81 0x04 "gnss_data.ecef_position" [] GX5_35_3;
        0x81 0x05 "gnss_data.ned_velocity" [] GX5_35_3;
        0x81 0x06 "gnss_data.ecef_velocity" [] GX5_35_1;
        0x81 0x07 "gnss_data.dop" [] GX5_35_3;
        0x81 0x08 "gnss_data.utc_time" [] GX5_35_3;
        0x81 0x09 "gnss_data.gps_time" [] GX5_35_3;
        0x81 0x0A "gnss_data.clock_info" [] GX5_35_3;
        0x81 0x0B "gnss_data.fix_info" [] GX5_35_3;
        0x81 0x0C "gnss_data.sv_info" [] GX5_35_3;
        0x81 0x0D "gnss_data.hardware_status" [] GX5_35_3;
        0x81 0x0E "gnss_data.dgps_info" [] GX5_35_1;
        0x81 0x0F "gnss_data.dgps_channel" [] GX5_35_3;
    },
    refuses: supported! {
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: GX5_35_4 },
    ],
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 500.0 },
        BaseRate { set: DescriptorSet(0x81), hertz: 4.0 },
    ],
    ports: &[
    ],
    limits: &[
        Limit {
            name: "reserved_gnss_channels",
            value: 32.0,
            unit: None,
            description: "Sum of the channels that constellations reserve.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are unknown",
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

#[rustfmt::skip]
const GX5_45_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_2: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented (LORD 3DM-GX5-45 DCP Manual: Single pages).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_3: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_4: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_5: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ROS driver microstrain_mips: Table of tested functions).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_6: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_7: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (ArduPilot: AP_ExternalAHRS_MicroStrain5).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_8: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_9: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-35.",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_10: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_11: &Evidence = &Evidence {
    answer: Support::No,
    why: "Rejected by the device (MicroStrain Communication Library: Issue 43).",
    absence: "",
};
#[rustfmt::skip]
const GX5_45_12: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const GX5_45_13: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-GX5-45
///
/// Inertial navigation system with GNSS, magnetometer and pressure sensor.
///
/// Also called 3DM-GX5-GNSS/INS. Generation 5. Model number 6251. Sensors: accelerometer,
/// gyroscope, magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD
/// 3DM-GX5-45 DCP Manual, 8500-0064 rev. C, known from some pages. This profile is incomplete: Only
/// some pages of its manual are known; the device has further commands and data. This profile is
/// incomplete: Only four fields of the filter data are listed; the manual documents 27 or more.
/// Uncertain: The values of [`filter::GnssSource`](crate::filter::GnssSource) are those that MSCL
/// offers. Uncertain: The base rates are those that the manuals of the 3DM-GX5-35 and the
/// 3DM-GX5-45 state for all 3DM-GX5. Uncertain: An example in the manual has a base rate of 100 Hz
/// for the sensor data. Uncertain: The manual states the length of
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
/// # Read of all settings
///
/// According to the manual, [`mip_3dm::DeviceSettings`](crate::mip_3dm::DeviceSettings) can also be
/// read, which returns the settings of all commands. The response is not documented, so the read is
/// not defined here.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "Only some pages of its manual are known; the device has further commands and data.",
        "Only four fields of the filter data are listed; the manual documents 27 or more.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] GX5_45_3;
        0x01 0x02 "base.set_idle" [] GX5_45_3;
        0x01 0x03 "base.get_device_info" [] GX5_45_1;
        0x01 0x04 "base.get_device_descriptors" [] GX5_45_8;
        0x01 0x05 "base.built_in_test" [] GX5_45_9;
        0x01 0x06 "base.resume" [] GX5_45_2;
        0x01 0x07 "base.get_extended_descriptors" [] GX5_45_2;
        0x01 0x72 "base.gps_time_update" [WRITE READ APPLY] GX5_45_9;
        0x01 0x7E "base.soft_reset" [] GX5_45_1;
        0x0C 0x01 "3dm.poll_imu_data" [] GX5_45_9;
        0x0C 0x02 "3dm.poll_gnss_data" [] GX5_45_1;
        0x0C 0x03 "3dm.poll_filter_data" [] GX5_45_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] GX5_45_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] GX5_45_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] GX5_45_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] GX5_45_5;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] GX5_45_1;
        0x0C 0x21 "3dm.constellation_settings" [WRITE READ SAVE LOAD DEFAULT] GX5_45_9;
        0x0C 0x22 "3dm.gnss_sbas_settings" [WRITE READ SAVE LOAD DEFAULT] GX5_45_9;
        0x0C 0x23 "3dm.gnss_assisted_fix" [WRITE READ SAVE LOAD DEFAULT] GX5_45_9;
        0x0C 0x24 "3dm.gnss_time_assistance" [WRITE READ] GX5_45_9;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] GX5_45_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_45_5;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_45_5;
        0x0C 0x39 "3dm.capture_gyro_bias" [] GX5_45_4;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_45_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] GX5_45_5;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] GX5_45_5;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_45_9;
        0x0C 0x51 "3dm.complementary_filter" [WRITE READ SAVE LOAD DEFAULT] GX5_45_5;
        0x0C 0x64 "3dm.device_status" [] GX5_45_1;
        0x0D 0x01 "filter.reset" [] GX5_45_3;
        0x0D 0x02 "filter.set_initial_attitude" [] GX5_45_5;
        0x0D 0x03 "filter.set_initial_heading" [] GX5_45_1;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x16 "filter.external_gnss_update" [] GX5_45_1;
        0x0D 0x17 "filter.external_heading_update" [] GX5_45_1;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x1F "filter.external_heading_update_with_time" [] GX5_45_1;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x21 "filter.tare_orientation" [WRITE SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x22 "filter.commanded_zupt" [] GX5_45_1;
        0x0D 0x23 "filter.commanded_angular_zupt" [] GX5_45_1;
        0x0D 0x26 "filter.reference_position" [WRITE READ SAVE LOAD DEFAULT] GX5_45_5;
        0x0D 0x27 "filter.mag_capture_auto_calibration" [WRITE SAVE] GX5_45_1;
        0x0D 0x28 "filter.gravity_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x29 "filter.pressure_altitude_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x2B "filter.hard_iron_offset_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x2C "filter.soft_iron_matrix_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x47 "filter.altitude_aiding" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x4B "filter.pitch_roll_aiding" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x0D 0x53 "filter.adaptive_filter_options" [WRITE READ SAVE LOAD DEFAULT] GX5_45_6;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] GX5_45_1;
        0x80 0x04 "sensor.scaled_accel" [] GX5_45_1;
        0x80 0x05 "sensor.scaled_gyro" [] GX5_45_1;
        0x80 0x06 "sensor.scaled_mag" [] GX5_45_1;
        0x80 0x07 "sensor.delta_theta" [] GX5_45_9;
        0x80 0x08 "sensor.delta_velocity" [] GX5_45_9;
        0x80 0x09 "sensor.comp_orientation_matrix" [] GX5_45_9;
        0x80 0x0A "sensor.comp_quaternion" [] GX5_45_7;
        0x80 0x0C "sensor.comp_euler_angles" [] GX5_45_9;
        0x80 0x10 "sensor.north_vector" [] GX5_45_9;
        0x80 0x11 "sensor.up_vector" [] GX5_45_9;
        0x80 0x12 "sensor.gps_timestamp" [] GX5_45_3;
        0x80 0x17 "sensor.scaled_pressure" [] GX5_45_7;
        0x81 0x03 "gnss_data.llh_position" [] GX5_45_7;
        0x81 0x04 "gnss_data.ecef_position" [] GX5_45_9;
        0x81 0x05 "gnss_data.ned_velocity" [] GX5_45_7;
        0x81 0x06 "gnss_data.ecef_velocity" [] GX5_45_9;
        0x81 0x07 "gnss_data.dop" [] GX5_45_7;
        0x81 0x08 "gnss_data.utc_time" [] GX5_45_9;
        0x81 0x09 "gnss_data.gps_time" [] GX5_45_9;
        0x81 0x0A "gnss_data.clock_info" [] GX5_45_9;
        0x81 0x0B "gnss_data.fix_info" [] GX5_45_3;
        0x81 0x0C "gnss_data.sv_info" [] GX5_45_1;
        0x81 0x0D "gnss_data.hardware_status" [] GX5_45_1;
        0x81 0x0E "gnss_data.dgps_info" [] GX5_45_1;
        0x81 0x0F "gnss_data.dgps_channel" [] GX5_45_1;
        0x82 0x01 "filter_data.llh_position" [] GX5_45_3;
        0x82 0x02 "filter_data.ned_velocity" [] GX5_45_3;
        0x82 0x03 "filter_data.attitude_quaternion" [] GX5_45_7;
        0x82 0x04 "filter_data.attitude_dcm" [] GX5_45_1;
        0x82 0x05 "filter_data.euler_angles" [] GX5_45_1;
        0x82 0x06 "filter_data.gyro_bias" [] GX5_45_10;
        0x82 0x07 "filter_data.accel_bias" [] GX5_45_10;
        0x82 0x08 "filter_data.llh_position_uncertainty" [] GX5_45_10;
        0x82 0x09 "filter_data.ned_velocity_uncertainty" [] GX5_45_10;
        0x82 0x0A "filter_data.euler_angles_uncertainty" [] GX5_45_10;
        0x82 0x0B "filter_data.gyro_bias_uncertainty" [] GX5_45_10;
        0x82 0x0C "filter_data.accel_bias_uncertainty" [] GX5_45_10;
        0x82 0x0D "filter_data.linear_accel" [] GX5_45_10;
        0x82 0x0E "filter_data.comp_angular_rate" [] GX5_45_1;
        0x82 0x0F "filter_data.wgs84_gravity_magnitude" [] GX5_45_10;
        0x82 0x10 "filter_data.status" [] GX5_45_3;
        0x82 0x11 "filter_data.timestamp" [] GX5_45_3;
        0x82 0x12 "filter_data.quaternion_attitude_uncertainty" [] GX5_45_10;
        0x82 0x13 "filter_data.gravity_vector" [] GX5_45_10;
        0x82 0x14 "filter_data.heading_update_state" [] GX5_45_1;
        0x82 0x15 "filter_data.magnetic_model" [] GX5_45_10;
        0x82 0x1C "filter_data.comp_accel" [] GX5_45_10;
        0x82 0x20 "filter_data.standard_atmosphere" [] GX5_45_10;
        0x82 0x21 "filter_data.pressure_altitude" [] GX5_45_10;
        0x82 0x25 "filter_data.mag_offset" [] GX5_45_10;
        0x82 0x26 "filter_data.mag_matrix" [] GX5_45_10;
        0x82 0x28 "filter_data.mag_offset_uncertainty" [] GX5_45_10;
        0x82 0x29 "filter_data.mag_matrix_uncertainty" [] GX5_45_10;
    },
    refuses: supported! {
        0x80 0x01 "sensor.raw_accel" [] GX5_45_11;
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] GX5_45_12;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: GX5_45_13 },
    ],
    firmware: &[
    ],
    base_rates: &[
        BaseRate { set: DescriptorSet(0x80), hertz: 500.0 },
        BaseRate { set: DescriptorSet(0x81), hertz: 4.0 },
        BaseRate { set: DescriptorSet(0x82), hertz: 500.0 },
    ],
    ports: &[
        ProfilePort {
            name: "UART 1",
            id: None,
            baud_rates: &[9600, 19200, 115200, 230400, 460800, 921600],
            receives: &["MIP"],
            sends: &["MIP"],
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
            name: "baud_rate_delay",
            value: 250.0,
            unit: Some("ms"),
            description: "Time from the ACK of a new baud rate until the device replies to commands at that rate.",
            firmware: None,
        },
        Limit {
            name: "rtcm_chunk",
            value: 253.0,
            unit: Some("byte"),
            description: "Maximum number of RTCM bytes in one field.",
            firmware: None,
        },
    ],
    variants: &[
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: None,
            difference: "the values are unknown",
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
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const MV5_AR_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};
#[rustfmt::skip]
const MV5_AR_2: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a receiver, which the device lacks.",
    absence: "has no GNSS receiver",
};
#[rustfmt::skip]
const MV5_AR_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires a magnetometer, which the device lacks.",
    absence: "has no magnetometer",
};

/// 3DM-MV5-AR
///
/// Device of generation 5.
///
/// Also called 3DM-MV5-15. Generation 5. Model number 6243. Sensors: accelerometer, gyroscope. GNSS
/// receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete: No manual
/// is known. Uncertain: The sensors are inferred from the name of the model.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # J1939
///
/// Besides MIP it sends J1939 messages on CAN, from the address 0xE2, according to a third-party
/// driver. The resolution is 1/32768 deg for angles, 1/128 deg/s for rates and 0.01 m/s^2 for
/// accelerations.
///
/// | Message | PGN | Signals | Offset |
/// | --- | --- | --- | --- |
/// | Slope sensor 2 | 0xF029 | pitch (bits 0 to 23), roll (24 to 47) | -250 deg |
/// | Angular rate | 0xF02A | pitch (0 to 15), roll (16 to 31), yaw (32 to 47) | -250 deg/s |
/// | Acceleration | 0xF02D | lateral (0 to 15), longitudinal (16 to 31), vertical (32 to 47) | -320 m/s^2 |
#[rustfmt::skip]
pub static MV5_AR: Profile = Profile {
    id: "3dm-mv5-ar",
    title: "3DM-MV5-AR",
    description: "Device of generation 5.",
    also: &["3DM-MV5-15"],
    model_number: Some(6243),
    generation: Some(5),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] MV5_AR_1;
        0x01 0x02 "base.set_idle" [] MV5_AR_1;
        0x01 0x03 "base.get_device_info" [] MV5_AR_1;
        0x01 0x04 "base.get_device_descriptors" [] MV5_AR_1;
        0x01 0x06 "base.resume" [] MV5_AR_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] MV5_AR_1;
    },
    refuses: supported! {
        0x0C 0x02 "3dm.poll_gnss_data" [] MV5_AR_2;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] MV5_AR_2;
        0x0C 0x09 "3dm.gnss_message_format" [] MV5_AR_2;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] MV5_AR_2;
        0x0C 0x21 "3dm.constellation_settings" [] MV5_AR_2;
        0x0C 0x22 "3dm.gnss_sbas_settings" [] MV5_AR_2;
        0x0C 0x23 "3dm.gnss_assisted_fix" [] MV5_AR_2;
        0x0C 0x24 "3dm.gnss_time_assistance" [] MV5_AR_2;
        0x0C 0x34 "3dm.gps_dynamics_mode" [] MV5_AR_2;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [] MV5_AR_3;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [] MV5_AR_3;
        0x0C 0x62 "3dm.gps_advanced_settings" [] MV5_AR_2;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x81), evidence: MV5_AR_2 },
        AbsentSet { set: DescriptorSet(0x91), evidence: MV5_AR_2 },
        AbsentSet { set: DescriptorSet(0x92), evidence: MV5_AR_2 },
        AbsentSet { set: DescriptorSet(0x93), evidence: MV5_AR_2 },
    ],
    firmware: &[
    ],
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
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "3dm.data_stream_control_response.descriptor_set",
            read_as: Some("legacy_data_stream"),
            difference: "values of legacy_data_stream; only all_streams, imu and filter",
        },
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const RQ1_45_LT_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const RQ1_45_LT_2: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const RQ1_45_LT_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const RQ1_45_LT_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-RQ1-45-LT
///
/// Ruggedized tactical grade inertial navigation system with GPS.
///
/// Also called 3DM-RQ1-45_LT. Generation 4. Model number 6232. GNSS receivers: 1. GNSS antennas: 1.
/// Manual: LORD 3DM-RQ1-45 Data Communications Protocol, of June 25, 2013, known from its table of
/// contents. This profile is incomplete: The manual's table of contents is known only up to
/// [`filter::SetInitialHeading`](crate::filter::SetInitialHeading). The unknown part includes the
/// set `system`. This profile is incomplete: It has the data sets 0x80, 0x81 and 0x82, but none of
/// their fields are known. Uncertain: The SDK writes the name with an underscore before LT and ST.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Direct modes
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor
/// or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the
/// 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "The manual's table of contents is known only up to `filter.set_initial_heading`. The unknown part includes the set `system`.",
        "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] RQ1_45_LT_1;
        0x01 0x02 "base.set_idle" [] RQ1_45_LT_1;
        0x01 0x03 "base.get_device_info" [] RQ1_45_LT_1;
        0x01 0x04 "base.get_device_descriptors" [] RQ1_45_LT_1;
        0x01 0x05 "base.built_in_test" [] RQ1_45_LT_1;
        0x01 0x06 "base.resume" [] RQ1_45_LT_1;
        0x01 0x7E "base.soft_reset" [] RQ1_45_LT_1;
        0x0C 0x01 "3dm.poll_imu_data" [] RQ1_45_LT_1;
        0x0C 0x02 "3dm.poll_gnss_data" [] RQ1_45_LT_1;
        0x0C 0x03 "3dm.poll_filter_data" [] RQ1_45_LT_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] RQ1_45_LT_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] RQ1_45_LT_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] RQ1_45_LT_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] RQ1_45_LT_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_LT_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_LT_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] RQ1_45_LT_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_LT_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_LT_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_1;
        0x0C 0x64 "3dm.device_status" [] RQ1_45_LT_1;
        0x0D 0x01 "filter.reset" [] RQ1_45_LT_1;
        0x0D 0x02 "filter.set_initial_attitude" [] RQ1_45_LT_1;
        0x0D 0x03 "filter.set_initial_heading" [] RQ1_45_LT_1;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x16 "filter.external_gnss_update" [] RQ1_45_LT_2;
        0x0D 0x17 "filter.external_heading_update" [] RQ1_45_LT_2;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x1F "filter.external_heading_update_with_time" [] RQ1_45_LT_2;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x22 "filter.commanded_zupt" [] RQ1_45_LT_2;
        0x0D 0x23 "filter.commanded_angular_zupt" [] RQ1_45_LT_2;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_LT_2;
        0x80 0x04 "sensor.scaled_accel" [] RQ1_45_LT_2;
        0x80 0x05 "sensor.scaled_gyro" [] RQ1_45_LT_2;
        0x80 0x06 "sensor.scaled_mag" [] RQ1_45_LT_2;
        0x81 0x03 "gnss_data.llh_position" [] RQ1_45_LT_2;
        0x81 0x05 "gnss_data.ned_velocity" [] RQ1_45_LT_2;
        0x81 0x09 "gnss_data.gps_time" [] RQ1_45_LT_2;
        0x82 0x01 "filter_data.llh_position" [] RQ1_45_LT_2;
        0x82 0x02 "filter_data.ned_velocity" [] RQ1_45_LT_2;
        0x82 0x05 "filter_data.euler_angles" [] RQ1_45_LT_2;
    },
    refuses: supported! {
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] RQ1_45_LT_3;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: RQ1_45_LT_4 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "3dm.device_status_basic_response.system_state",
            read_as: Some("gx4_system_state"),
            difference: "values of gx4_system_state",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal, external and internal_1",
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
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const RQ1_45_ST_1: &Evidence = &Evidence {
    answer: Support::Yes,
    why: "Documented.",
    absence: "",
};
#[rustfmt::skip]
const RQ1_45_ST_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by nearly identical devices, 3DM-RQ1-45-LT.",
    absence: "",
};
#[rustfmt::skip]
const RQ1_45_ST_3: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 antennas, which the device lacks.",
    absence: "has fewer than 2 GNSS antennas",
};
#[rustfmt::skip]
const RQ1_45_ST_4: &Evidence = &Evidence {
    answer: Support::No,
    why: "Requires 2 receivers, which the device lacks.",
    absence: "has fewer than 2 GNSS receivers",
};

/// 3DM-RQ1-45-ST
///
/// Ruggedized tactical grade inertial navigation system with GPS.
///
/// Also called 3DM-RQ1-45_ST. Generation 4. Model number 6239. GNSS receivers: 1. GNSS antennas: 1.
/// Manual: LORD 3DM-RQ1-45 Data Communications Protocol, of June 25, 2013, known from its table of
/// contents. This profile is incomplete: The manual's table of contents is known only up to
/// [`filter::SetInitialHeading`](crate::filter::SetInitialHeading). The unknown part includes the
/// set `system`. This profile is incomplete: It has the data sets 0x80, 0x81 and 0x82, but none of
/// their fields are known. Uncertain: The SDK writes the name with an underscore before LT and ST.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Direct modes
///
/// [`system::CommMode`](crate::system::CommMode) connects the port to the internal inertial sensor
/// or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the
/// 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.
///
/// # Device status
///
/// According to MSCL, it replies with
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
        "The manual's table of contents is known only up to `filter.set_initial_heading`. The unknown part includes the set `system`.",
        "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] RQ1_45_ST_1;
        0x01 0x02 "base.set_idle" [] RQ1_45_ST_1;
        0x01 0x03 "base.get_device_info" [] RQ1_45_ST_1;
        0x01 0x04 "base.get_device_descriptors" [] RQ1_45_ST_1;
        0x01 0x05 "base.built_in_test" [] RQ1_45_ST_1;
        0x01 0x06 "base.resume" [] RQ1_45_ST_1;
        0x01 0x7E "base.soft_reset" [] RQ1_45_ST_1;
        0x0C 0x01 "3dm.poll_imu_data" [] RQ1_45_ST_1;
        0x0C 0x02 "3dm.poll_gnss_data" [] RQ1_45_ST_1;
        0x0C 0x03 "3dm.poll_filter_data" [] RQ1_45_ST_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] RQ1_45_ST_1;
        0x0C 0x07 "3dm.get_gnss_base_rate" [] RQ1_45_ST_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x09 "3dm.gnss_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x0A "3dm.filter_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x0B "3dm.get_filter_base_rate" [] RQ1_45_ST_1;
        0x0C 0x11 "3dm.data_stream_control" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x20 "3dm.raw_rtcm_2_3_message" [] RQ1_45_ST_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_ST_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_ST_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] RQ1_45_ST_1;
        0x0C 0x3A "3dm.mag_hard_iron_offset" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_ST_1;
        0x0C 0x3B "3dm.mag_soft_iron_matrix" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_45_ST_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x40 "3dm.uart_baud_rate" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x50 "3dm.imu_low_pass_filter" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_1;
        0x0C 0x64 "3dm.device_status" [] RQ1_45_ST_1;
        0x0D 0x01 "filter.reset" [] RQ1_45_ST_1;
        0x0D 0x02 "filter.set_initial_attitude" [] RQ1_45_ST_1;
        0x0D 0x03 "filter.set_initial_heading" [] RQ1_45_ST_1;
        0x0D 0x10 "filter.vehicle_dynamics_mode" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x11 "filter.sensor_to_vehicle_rotation_euler" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x12 "filter.sensor_to_vehicle_offset" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x13 "filter.antenna_offset" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x14 "filter.estimation_control" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x15 "filter.gnss_source" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x16 "filter.external_gnss_update" [] RQ1_45_ST_2;
        0x0D 0x17 "filter.external_heading_update" [] RQ1_45_ST_2;
        0x0D 0x18 "filter.heading_source" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x19 "filter.auto_initialization_control" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x1A "filter.accel_noise" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x1B "filter.gyro_noise" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x1C "filter.accel_bias_model" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x1D "filter.gyro_bias_model" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x1E "filter.auto_zupt" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x1F "filter.external_heading_update_with_time" [] RQ1_45_ST_2;
        0x0D 0x20 "filter.auto_angular_zupt" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x21 "filter.tare_orientation" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x22 "filter.commanded_zupt" [] RQ1_45_ST_2;
        0x0D 0x23 "filter.commanded_angular_zupt" [] RQ1_45_ST_2;
        0x0D 0x42 "filter.mag_noise" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x43 "filter.magnetic_declination_source" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x44 "filter.accel_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x45 "filter.mag_magnitude_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x0D 0x46 "filter.mag_dip_angle_error_adaptive_measurement" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] RQ1_45_ST_2;
        0x80 0x04 "sensor.scaled_accel" [] RQ1_45_ST_2;
        0x80 0x05 "sensor.scaled_gyro" [] RQ1_45_ST_2;
        0x80 0x06 "sensor.scaled_mag" [] RQ1_45_ST_2;
        0x81 0x03 "gnss_data.llh_position" [] RQ1_45_ST_2;
        0x81 0x05 "gnss_data.ned_velocity" [] RQ1_45_ST_2;
        0x81 0x09 "gnss_data.gps_time" [] RQ1_45_ST_2;
        0x82 0x01 "filter_data.llh_position" [] RQ1_45_ST_2;
        0x82 0x02 "filter_data.ned_velocity" [] RQ1_45_ST_2;
        0x82 0x05 "filter_data.euler_angles" [] RQ1_45_ST_2;
    },
    refuses: supported! {
        0x82 0x49 "filter_data.gnss_dual_antenna_status" [] RQ1_45_ST_3;
    },
    absent_sets: &[
        AbsentSet { set: DescriptorSet(0x92), evidence: RQ1_45_ST_4 },
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "3dm.device_status_basic_response.system_state",
            read_as: Some("gx4_system_state"),
            difference: "values of gx4_system_state",
        },
        Variant {
            parameter: "filter.estimation_control.flags",
            read_as: None,
            difference: "only gyro_bias, accel_bias, gyro_scale_factor, accel_scale_factor and antenna_offset",
        },
        Variant {
            parameter: "filter.gnss_source.source",
            read_as: None,
            difference: "only all_internal, external and internal_1",
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
        Variant {
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const RQ1_IMU_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
    absence: "",
};
#[rustfmt::skip]
const RQ1_IMU_2: &Evidence = &Evidence {
    answer: Support::Assumed,
    why: "Supported by devices of the same generation, 3DM-GX4-25.",
    absence: "",
};

/// 3DM-RQ1-IMU
///
/// Inertial sensor inside the 3DM-RQ1-45, which replies in the direct mode.
///
/// Generation 4. Model number 6238. No manual is known. This profile is incomplete: No manual is
/// known.
///
/// Source: mip-sdk-2014: RQ1 IMU.
#[rustfmt::skip]
pub static RQ1_IMU: Profile = Profile {
    id: "3dm-rq1-imu",
    title: "3DM-RQ1-IMU",
    description: "Inertial sensor inside the 3DM-RQ1-45, which replies in the direct mode.",
    also: &[],
    model_number: Some(6238),
    generation: Some(4),
    manual: None,
    incomplete: &[
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] RQ1_IMU_1;
        0x01 0x02 "base.set_idle" [] RQ1_IMU_1;
        0x01 0x03 "base.get_device_info" [] RQ1_IMU_1;
        0x01 0x04 "base.get_device_descriptors" [] RQ1_IMU_1;
        0x01 0x05 "base.built_in_test" [] RQ1_IMU_1;
        0x01 0x06 "base.resume" [] RQ1_IMU_2;
        0x0C 0x01 "3dm.poll_imu_data" [] RQ1_IMU_1;
        0x0C 0x06 "3dm.get_imu_base_rate" [] RQ1_IMU_1;
        0x0C 0x08 "3dm.imu_message_format" [WRITE READ SAVE LOAD DEFAULT] RQ1_IMU_1;
        0x0C 0x37 "3dm.accel_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_IMU_1;
        0x0C 0x38 "3dm.gyro_bias" [WRITE READ SAVE LOAD DEFAULT APPLY] RQ1_IMU_1;
        0x0C 0x39 "3dm.capture_gyro_bias" [] RQ1_IMU_1;
        0x0C 0x3E "3dm.coning_sculling_enable" [WRITE READ SAVE LOAD DEFAULT] RQ1_IMU_1;
        0x0C 0x64 "3dm.device_status" [] RQ1_IMU_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] RQ1_IMU_1;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
    firmware: &[
    ],
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
            difference: "the values are unknown",
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
            parameter: "sensor.gps_timestamp.tow",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.week_number",
            read_as: None,
            difference: "valid if valid_flags.time_initialized is set (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "sensor.gps_timestamp.valid_flags",
            read_as: Some("gx5_sensor_gps_timestamp_flags"),
            difference: "values of gx5_sensor_gps_timestamp_flags (inferred: the 3DM-GX5-15 has it)",
        },
        Variant {
            parameter: "filter_data.status.filter_state",
            read_as: Some("gx5_filter_state"),
            difference: "values of gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.dynamics_mode",
            read_as: Some("gx5_dynamics_mode"),
            difference: "values of gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
        Variant {
            parameter: "filter_data.status.status_flags",
            read_as: Some("gx5_status_flags"),
            difference: "values of gx5_status_flags (inferred: the 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth)",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const RTK_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
    absence: "",
};

/// 3DM-RTK
///
/// Modem for GNSS corrections.
///
/// Generation 7. Model number 6285. No manual is known. This profile is incomplete: No manual is
/// known.
///
/// Source: mip-sdk-4: Device models; mscl: MIP node features.
///
/// # Versions
///
/// According to MSCL, model numbers that end in 0000 denote version 1, and those that end in 0100
/// version 2. Their status words in [`rtk::GetStatusFlags`](crate::rtk::GetStatusFlags) differ.
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
        "No manual is known.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] RTK_1;
        0x01 0x02 "base.set_idle" [] RTK_1;
        0x01 0x03 "base.get_device_info" [] RTK_1;
        0x01 0x04 "base.get_device_descriptors" [] RTK_1;
        0x01 0x05 "base.built_in_test" [] RTK_1;
        0x01 0x06 "base.resume" [] RTK_1;
        0x01 0x09 "base.comm_speed" [WRITE READ SAVE LOAD DEFAULT] RTK_1;
        0x01 0x7E "base.soft_reset" [] RTK_1;
        0x0C 0x30 "3dm.device_settings" [SAVE LOAD DEFAULT] RTK_1;
        0x0F 0x01 "rtk.get_status_flags" [] RTK_1;
        0x0F 0x07 "rtk.get_activation_code" [] RTK_1;
        0x7F 0x10 "system.comm_mode" [WRITE READ SAVE LOAD DEFAULT] RTK_1;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
    firmware: &[
    ],
    base_rates: &[
    ],
    ports: &[
    ],
    limits: &[
    ],
    variants: &[
        Variant {
            parameter: "base.comm_speed.port",
            read_as: None,
            difference: "the values are unknown",
        },
        Variant {
            parameter: "base.built_in_test_response.result",
            read_as: Some("cv7_built_in_test"),
            difference: "values of cv7_built_in_test (inferred: the 3DM-CV7-GNSS/INS has it)",
        },
        Variant {
            parameter: "base.comm_speed_response.port",
            read_as: None,
            difference: "the values are unknown",
        },
    ],
    ack_codes: &[
    ],
};

#[rustfmt::skip]
const DEMOD_DC_1: &Evidence = &Evidence {
    answer: Support::Likely,
    why: "Used by programs for this model (MicroStrain Communication Library: Displacement node).",
    absence: "",
};

/// DEMOD-DC
///
/// Digital demodulator for displacement sensors.
///
/// Also called Digital Demod. Model number 6130. No manual is known. This profile is incomplete: No
/// manual is known; everything here is from MSCL.
///
/// Source: mscl: Displacement node.
#[rustfmt::skip]
pub static DEMOD_DC: Profile = Profile {
    id: "demod-dc",
    title: "DEMOD-DC",
    description: "Digital demodulator for displacement sensors.",
    also: &["Digital Demod"],
    model_number: Some(6130),
    generation: None,
    manual: None,
    incomplete: &[
        "No manual is known; everything here is from MSCL.",
    ],
    fields: supported! {
        0x01 0x01 "base.ping" [] DEMOD_DC_1;
        0x01 0x02 "base.set_idle" [] DEMOD_DC_1;
        0x01 0x03 "base.get_device_info" [] DEMOD_DC_1;
        0x01 0x04 "base.get_device_descriptors" [] DEMOD_DC_1;
        0x01 0x06 "base.resume" [] DEMOD_DC_1;
        0x11 0x01 "displacement.get_calibration" [] DEMOD_DC_1;
        0x11 0x02 "displacement.output_rate" [READ] DEMOD_DC_1;
        0x11 0x04 "displacement.device_time" [WRITE] DEMOD_DC_1;
        0x90 0x01 "displacement_data.displacement_raw" [] DEMOD_DC_1;
        0x90 0x02 "displacement_data.displacement" [] DEMOD_DC_1;
        0x90 0x04 "displacement_data.timestamp" [] DEMOD_DC_1;
    },
    refuses: supported! {
    },
    absent_sets: &[
    ],
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
