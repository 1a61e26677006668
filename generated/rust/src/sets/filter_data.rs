//! Filter data (0x82): Estimates of the navigation filter and its status.
//!
//! Source: 3dm-gx5-15: 5.2 Estimation Filter Data; 3dm-cv7-gnss-ins: Filter (0x82).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x82);

bitfield! {
    /// Validity of the values of a field.
    ValidFlags: u16 {
        /// All values of the field are valid. Bit 0.
        VALID: bool = 0,
            valid, set_valid, with_valid;
    }
}

bitfield! {
    /// Sources of heading updates; 0 if heading updates are disabled.
    ///
    /// Source: 3dm-gx5-15: 5.2.16 Heading Update Source State (0x82, 0x14); 3dm-gx5-45: 5.3.27
    /// Heading Update Source State (0x82, 0x14).
    HeadingSourceFlags: u16 {
        /// The magnetometer. Bit 0. Requires a magnetometer.
        MAG: bool = 0,
            mag, set_mag, with_mag;
        /// The velocity that the GNSS receiver measures. Bit 1. Requires a receiver.
        GNSS_VELOCITY: bool = 1,
            gnss_velocity, set_gnss_velocity, with_gnss_velocity;
        /// Heading messages that your program sends. Bit 2.
        EXTERNAL: bool = 2,
            external, set_external, with_external;
    }
}

bitfield! {
    /// Use of one GNSS receiver by the filter.
    GnssAidingStatus: u16 {
        /// The receiver's raw ranges are used. Bit 0.
        TIGHT_COUPLING: bool = 0,
            tight_coupling, set_tight_coupling, with_tight_coupling;
        /// RTK corrections are used. Bit 1.
        DIFFERENTIAL: bool = 1,
            differential, set_differential, with_differential;
        /// The receiver has an RTK integer fix, the most accurate kind. Bit 2.
        INTEGER_FIX: bool = 2,
            integer_fix, set_integer_fix, with_integer_fix;
        /// GPS L1 is used. Bit 3.
        GPS_L1: bool = 3,
            gps_l1, set_gps_l1, with_gps_l1;
        /// GPS L2 is used. Bit 4.
        GPS_L2: bool = 4,
            gps_l2, set_gps_l2, with_gps_l2;
        /// GPS L5 is used; not on every model. Bit 5.
        GPS_L5: bool = 5,
            gps_l5, set_gps_l5, with_gps_l5;
        /// GLONASS L1 is used. Bit 6.
        GLONASS_L1: bool = 6,
            glonass_l1, set_glonass_l1, with_glonass_l1;
        /// GLONASS L2 is used. Bit 7.
        GLONASS_L2: bool = 7,
            glonass_l2, set_glonass_l2, with_glonass_l2;
        /// Galileo E1 is used. Bit 8.
        GALILEO_E1: bool = 8,
            galileo_e1, set_galileo_e1, with_galileo_e1;
        /// Galileo E5 is used. Bit 9.
        GALILEO_E5: bool = 9,
            galileo_e5, set_galileo_e5, with_galileo_e5;
        /// Galileo E6 is used. Bit 10.
        GALILEO_E6: bool = 10,
            galileo_e6, set_galileo_e6, with_galileo_e6;
        /// BeiDou B1 is used; not on every model. Bit 11.
        BEIDOU_B1: bool = 11,
            beidou_b1, set_beidou_b1, with_beidou_b1;
        /// BeiDou B2 is used; not on every model. Bit 12.
        BEIDOU_B2: bool = 12,
            beidou_b2, set_beidou_b2, with_beidou_b2;
        /// BeiDou B3 is used; not on every model. Bit 13.
        BEIDOU_B3: bool = 13,
            beidou_b3, set_beidou_b3, with_beidou_b3;
        /// The receiver has no position fix. Bit 14.
        NO_FIX: bool = 14,
            no_fix, set_no_fix, with_no_fix;
        /// The antenna offset of the receiver is probably wrong. Bit 15.
        CONFIG_ERROR: bool = 15,
            config_error, set_config_error, with_config_error;
    }
}

open_enum! {
    /// Source of a heading measurement.
    ///
    /// Source: mip-sdk-4: Head Aid Status (0x82,0x45).
    HeadingAidingType: u8 {
        /// Two GNSS antennas.
        DUAL_ANTENNA = 1, "dual_antenna";
        /// A heading message from your program.
        EXTERNAL_MESSAGE = 2, "external_message";
    }
}

open_enum! {
    /// Kind of aiding measurement. Values from 0x20 are the descriptors of the commands of set
    /// `aiding` that send the measurement.
    AidingMeasurementType: u8 {
        /// GNSS position and velocity.
        GNSS = 1, "gnss";
        /// GNSS heading from two antennas.
        DUAL_ANTENNA = 2, "dual_antenna";
        /// Heading.
        HEADING = 3, "heading";
        /// Pressure altitude.
        PRESSURE = 4, "pressure";
        /// Mag.
        MAG = 5, "mag";
        /// Speed or odometer.
        SPEED = 6, "speed";
        /// ECEF position, sent by command.
        AIDING_ECEF_POSITION = 33, "aiding_ecef_position";
        /// Latitude, longitude and height, sent by command.
        AIDING_LLH_POSITION = 34, "aiding_llh_position";
        /// Height above the ellipsoid, sent by command.
        AIDING_HEIGHT_ABOVE_ELLIPSOID = 35, "aiding_height_above_ellipsoid";
        /// ECEF velocity, sent by command.
        AIDING_ECEF_VELOCITY = 40, "aiding_ecef_velocity";
        /// NED velocity, sent by command.
        AIDING_NED_VELOCITY = 41, "aiding_ned_velocity";
        /// Body frame velocity, sent by command.
        AIDING_BODY_FRAME_VELOCITY = 42, "aiding_body_frame_velocity";
        /// True heading, sent by command.
        AIDING_TRUE_HEADING = 49, "aiding_true_heading";
        /// Magnetic field, sent by command.
        AIDING_MAGNETIC_FIELD = 50, "aiding_magnetic_field";
        /// Pressure, sent by command.
        AIDING_PRESSURE = 51, "aiding_pressure";
    }
}

bitfield! {
    /// Use of an aiding measurement by the filter.
    AidingMeasurementIndicator: u8 {
        /// The measurement is enabled. Bit 0.
        ENABLED: bool = 0,
            enabled, set_enabled, with_enabled;
        /// The filter used the measurement. Bit 1.
        USED: bool = 1,
            used, set_used, with_used;
        /// The measurement disagrees with the estimate. Bit 2.
        RESIDUAL_HIGH_WARNING: bool = 2,
            residual_high_warning, set_residual_high_warning, with_residual_high_warning;
        /// The time of the measurement is doubtful. Bit 3.
        SAMPLE_TIME_WARNING: bool = 3,
            sample_time_warning, set_sample_time_warning, with_sample_time_warning;
        /// The measurement is configured incorrectly. Bit 4.
        CONFIG_ERROR: bool = 4,
            config_error, set_config_error, with_config_error;
        /// There are more measurements than the filter can process. Bit 5.
        MAX_MEASUREMENTS_EXCEEDED: bool = 5,
            max_measurements_exceeded, set_max_measurements_exceeded, with_max_measurements_exceeded;
    }
}

open_enum! {
    /// Kind of dual-antenna heading solution.
    DualAntennaFixType: u8 {
        /// No solution.
        FIX_NONE = 0, "fix_none";
        /// Solution with float ambiguities.
        FIX_DA_FLOAT = 1, "fix_da_float";
        /// Solution with fixed ambiguities.
        FIX_DA_FIXED = 2, "fix_da_fixed";
    }
}

bitfield! {
    /// Inputs available to the dual-antenna heading solution.
    DualAntennaStatusFlags: u16 {
        /// Data of receiver 1 is valid. Bit 0.
        RECEIVER_1_DATA_VALID: bool = 0,
            receiver_1_data_valid, set_receiver_1_data_valid, with_receiver_1_data_valid;
        /// Data of receiver 2 is valid. Bit 1.
        RECEIVER_2_DATA_VALID: bool = 1,
            receiver_2_data_valid, set_receiver_2_data_valid, with_receiver_2_data_valid;
        /// The antenna offsets are valid. Bit 2.
        ANTENNA_OFFSETS_VALID: bool = 2,
            antenna_offsets_valid, set_antenna_offsets_valid, with_antenna_offsets_valid;
    }
}

open_enum! {
    /// State of the filter of a 5-series device.
    ///
    /// Source: 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10); 3dm-cv7-gnss-ins: Status (0x82,0x10).
    Gx5FilterState: u16 {
        /// The device is starting.
        STARTUP = 0, "startup";
        /// Initialization; the status flags show what is missing.
        INIT = 1, "init";
        /// Running with a valid solution.
        RUN_SOLUTION_VALID = 2, "run_solution_valid";
        /// Running with an error; the status flags show which.
        RUN_SOLUTION_ERROR = 3, "run_solution_error";
    }
}

open_enum! {
    /// Mode of the filter of a 3DM-CV7.
    ///
    /// Source: 3dm-cv7-gnss-ins: Filter States; 3dm-cv7-gnss-ins: Status (0x82,0x10).
    Cv7FilterState: u16 {
        /// Initialization; initial conditions are missing or the filter waits for a command.
        INIT = 1, "init";
        /// Vertical gyro: pitch and roll, and heading relative to the initial one.
        VERTICAL_GYRO = 2, "vertical_gyro";
        /// Pitch, roll and absolute heading.
        AHRS = 3, "ahrs";
        /// Full navigation: position, velocity and attitude.
        FULL_NAV = 4, "full_nav";
    }
}

open_enum! {
    /// Motion for which the filter of a 5-series device is configured.
    Gx5DynamicsMode: u16 {
        /// Carried by hand.
        PORTABLE = 1, "portable";
        /// Ground vehicle.
        AUTOMOTIVE = 2, "automotive";
        /// Aircraft.
        AIRBORNE = 3, "airborne";
        /// Aircraft with high acceleration. Uncertain: The manual of the 3DM-GX5-15 lists 1 to 3;
        /// [`filter::VehicleDynamicsMode`](crate::filter::VehicleDynamicsMode) sets 4, too.
        AIRBORNE_HIGH_G = 4, "airborne_high_g";
    }
}

open_enum! {
    /// Dynamics mode of a 7-series device; there is only one.
    Cv7DynamicsMode: u16 {
        /// The only mode.
        DEFAULT = 1, "default";
    }
}

bitfield! {
    /// Problems of the filter of a 5-series device; their meaning depends on the state of the
    /// filter.
    ///
    /// Source: 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10); 3dm-cv7-gnss-ins: Status (0x82,0x10).
    Gx5StatusFlags: u16 while Gx5FilterState {
        /// No inertial data. Bit 0. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`sensor::ScaledAccel`](crate::sensor::ScaledAccel) and
        /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
        RUN_IMU_UNAVAILABLE: bool = 0 while [2, 3],
            run_imu_unavailable, set_run_imu_unavailable, with_run_imu_unavailable;
        /// No GNSS data; only on models with GNSS. Bit 1. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`LlhPosition`] and [`NedVelocity`].
        RUN_GPS_UNAVAILABLE: bool = 1 while [2, 3],
            run_gps_unavailable, set_run_gps_unavailable, with_run_gps_unavailable;
        /// A matrix in the computation is singular. Bit 3. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`filter::Reset`](crate::filter::Reset).
        RUN_MATRIX_SINGULARITY: bool = 3 while [2, 3],
            run_matrix_singularity, set_run_matrix_singularity, with_run_matrix_singularity;
        /// A position covariance is above its normal limit. Bit 4. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`LlhPosition`] and [`LlhPositionUncertainty`].
        RUN_POSITION_COVARIANCE_WARNING: bool = 4 while [2, 3],
            run_position_covariance_warning, set_run_position_covariance_warning, with_run_position_covariance_warning;
        /// A velocity covariance is above its normal limit. Bit 5. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`NedVelocity`] and [`NedVelocityUncertainty`].
        RUN_VELOCITY_COVARIANCE_WARNING: bool = 5 while [2, 3],
            run_velocity_covariance_warning, set_run_velocity_covariance_warning, with_run_velocity_covariance_warning;
        /// An attitude covariance is above its normal limit. Bit 6. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`EulerAngles`] and [`EulerAnglesUncertainty`].
        RUN_ATTITUDE_COVARIANCE_WARNING: bool = 6 while [2, 3],
            run_attitude_covariance_warning, set_run_attitude_covariance_warning, with_run_attitude_covariance_warning;
        /// The solution contains NaN values. Bit 7. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`filter::Reset`](crate::filter::Reset).
        RUN_NAN_IN_SOLUTION_WARNING: bool = 7 while [2, 3],
            run_nan_in_solution_warning, set_run_nan_in_solution_warning, with_run_nan_in_solution_warning;
        /// The estimated gyroscope bias is high. Bit 8. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`GyroBias`].
        RUN_GYRO_BIAS_EST_HIGH_WARNING: bool = 8 while [2, 3],
            run_gyro_bias_est_high_warning, set_run_gyro_bias_est_high_warning, with_run_gyro_bias_est_high_warning;
        /// The estimated accelerometer bias is high. Bit 9. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`AccelBias`].
        RUN_ACCEL_BIAS_EST_HIGH_WARNING: bool = 9 while [2, 3],
            run_accel_bias_est_high_warning, set_run_accel_bias_est_high_warning, with_run_accel_bias_est_high_warning;
        /// The estimated gyroscope scale factor is high. Bit 10. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`GyroScaleFactor`].
        RUN_GYRO_SCALE_FACTOR_EST_HIGH_WARNING: bool = 10 while [2, 3],
            run_gyro_scale_factor_est_high_warning, set_run_gyro_scale_factor_est_high_warning, with_run_gyro_scale_factor_est_high_warning;
        /// The estimated accelerometer scale factor is high. Bit 11. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`AccelScaleFactor`].
        RUN_ACCEL_SCALE_FACTOR_EST_HIGH_WARNING: bool = 11 while [2, 3],
            run_accel_scale_factor_est_high_warning, set_run_accel_scale_factor_est_high_warning, with_run_accel_scale_factor_est_high_warning;
        /// The estimated magnetometer bias is high. Bit 12. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`MagBias`].
        RUN_MAG_BIAS_EST_HIGH_WARNING: bool = 12 while [2, 3],
            run_mag_bias_est_high_warning, set_run_mag_bias_est_high_warning, with_run_mag_bias_est_high_warning;
        /// The estimated correction of the antenna offset is high; on models with GNSS. Bit 13.
        /// Only while `filter_state` is [`Gx5FilterState::RUN_SOLUTION_VALID`] or
        /// [`Gx5FilterState::RUN_SOLUTION_ERROR`]. Affects [`AntennaOffsetCorrection`] and
        /// [`filter::AntennaOffset`](crate::filter::AntennaOffset).
        RUN_ANTENNA_OFFSET_CORRECTION_EST_HIGH_WARNING: bool = 13 while [2, 3],
            run_antenna_offset_correction_est_high_warning, set_run_antenna_offset_correction_est_high_warning, with_run_antenna_offset_correction_est_high_warning;
        /// The estimated hard-iron offset is high. Bit 14. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`MagOffset`].
        RUN_MAG_HARD_IRON_EST_HIGH_WARNING: bool = 14 while [2, 3],
            run_mag_hard_iron_est_high_warning, set_run_mag_hard_iron_est_high_warning, with_run_mag_hard_iron_est_high_warning;
        /// The estimated soft-iron correction is high. Bit 15. Only while `filter_state` is
        /// [`Gx5FilterState::RUN_SOLUTION_VALID`] or [`Gx5FilterState::RUN_SOLUTION_ERROR`].
        /// Affects [`MagMatrix`].
        RUN_MAG_SOFT_IRON_EST_HIGH_WARNING: bool = 15 while [2, 3],
            run_mag_soft_iron_est_high_warning, set_run_mag_soft_iron_est_high_warning, with_run_mag_soft_iron_est_high_warning;
        /// The attitude is not initialized. Bit 12. Overlaps other bits. Only while `filter_state`
        /// is [`Gx5FilterState::INIT`]. Affects [`AttitudeQuaternion`], [`AttitudeDcm`] and
        /// [`EulerAngles`].
        INIT_NO_ATTITUDE: bool = 12 while [1],
            init_no_attitude, set_init_no_attitude, with_init_no_attitude;
        /// Position and velocity are not initialized. Bit 13. Overlaps other bits. Only while
        /// `filter_state` is [`Gx5FilterState::INIT`]. Affects [`LlhPosition`] and [`NedVelocity`].
        INIT_NO_POSITION_VELOCITY: bool = 13 while [1],
            init_no_position_velocity, set_init_no_position_velocity, with_init_no_position_velocity;
    }
}

open_enum! {
    /// Convergence of the filter's estimates.
    ///
    /// Source: 3dm-cv7-gnss-ins: Filter condition (bits 0-1); 3dm-cv7-gnss-ins: How do I interpret
    /// the Status (0x82,0x10) message?.
    FilterCondition: u8 {
        /// Estimates have settled and agree with the aiding measurements.
        STABLE = 1, "stable";
        /// Estimates have not settled yet.
        CONVERGING = 2, "converging";
        /// Estimates are unstable or recovering.
        UNSTABLE = 3, "unstable";
    }
}

bitfield! {
    /// Condition and warnings of the filter of a 3DM-CV7.
    ///
    /// Source: 3dm-cv7-gnss-ins: Filter Status Flags; 3dm-cv7-gnss-ins: How do I interpret the
    /// Status (0x82,0x10) message?; 3dm-cv7-gnss-ins: Status (0x82,0x10).
    Cv7StatusFlags: u16 {
        /// Convergence of the estimates. Bits 0 to 1. A value of [`FilterCondition`].
        FILTER_CONDITION: FilterCondition = 0..=1,
            filter_condition, set_filter_condition, with_filter_condition;
        /// Roll and pitch are doubtful; check the mounting transformation. Bit 2. Affects
        /// [`AttitudeQuaternion`], [`AttitudeDcm`] and [`EulerAngles`].
        ROLL_PITCH_WARNING: bool = 2,
            roll_pitch_warning, set_roll_pitch_warning, with_roll_pitch_warning;
        /// The heading is doubtful; check the heading source. Bit 3. Affects
        /// [`AttitudeQuaternion`], [`AttitudeDcm`] and [`EulerAngles`].
        HEADING_WARNING: bool = 3,
            heading_warning, set_heading_warning, with_heading_warning;
        /// The position is doubtful; check the GNSS reception and antennas. Bit 4. Affects
        /// [`LlhPosition`], [`EcefPosition`] and [`NedRelativePosition`].
        POSITION_WARNING: bool = 4,
            position_warning, set_position_warning, with_position_warning;
        /// The velocity is doubtful; check the GNSS reception and antennas. Bit 5. Affects
        /// [`NedVelocity`] and [`EcefVelocity`].
        VELOCITY_WARNING: bool = 5,
            velocity_warning, set_velocity_warning, with_velocity_warning;
        /// The sensor biases are doubtful; capture the gyroscope bias. Bit 6. Affects
        /// [`AccelBias`], [`GyroBias`] and
        /// [`mip_3dm::CaptureGyroBias`](crate::mip_3dm::CaptureGyroBias).
        IMU_BIAS_WARNING: bool = 6,
            imu_bias_warning, set_imu_bias_warning, with_imu_bias_warning;
        /// The GNSS clock is doubtful; navigation continues. Bit 7. Affects [`Timestamp`] and
        /// [`ClockCorrection`].
        GNSS_CLOCK_WARNING: bool = 7,
            gnss_clock_warning, set_gnss_clock_warning, with_gnss_clock_warning;
        /// The antenna offsets are probably wrong. Bit 8. Affects [`MultiAntennaOffsetCorrection`]
        /// and [`filter::MultiAntennaOffset`](crate::filter::MultiAntennaOffset).
        ANTENNA_LEVER_ARM_WARNING: bool = 8,
            antenna_lever_arm_warning, set_antenna_lever_arm_warning, with_antenna_lever_arm_warning;
        /// The mounting transformation is probably wrong. Bit 9. Affects
        /// [`mip_3dm::SensorToVehicleTransformEuler`](crate::mip_3dm::SensorToVehicleTransformEuler)
        /// and
        /// [`mip_3dm::SensorToVehicleTransformDcm`](crate::mip_3dm::SensorToVehicleTransformDcm).
        MOUNTING_TRANSFORM_WARNING: bool = 9,
            mounting_transform_warning, set_mounting_transform_warning, with_mounting_transform_warning;
        /// No pulse per second is detected, or the time of an external heading is too old. Bit 10.
        /// Affects [`mip_3dm::PpsSourceControl`](crate::mip_3dm::PpsSourceControl).
        TIME_SYNC_WARNING: bool = 10,
            time_sync_warning, set_time_sync_warning, with_time_sync_warning;
        /// Not 0 if the solution contains NaN values; reset the filter. Bits 12 to 15. Affects
        /// [`filter::Reset`](crate::filter::Reset).
        SOLUTION_ERROR: u8 = 12..=15,
            solution_error, set_solution_error, with_solution_error;
    }
}

record! {
    /// LLH position (0x82,0x01).
    ///
    /// Estimated position as latitude, longitude and height.
    ///
    /// Also called `position_llh`. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS)
    /// and [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: LLH Position (0x82,0x01).
    #[derive(Copy, Default)]
    pub struct LlhPosition {
        /// Geodetic latitude.
        ///
        /// Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub latitude: f64,
        /// Geodetic longitude.
        ///
        /// Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub longitude: f64,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub ellipsoid_height: f64,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    LlhPosition
    latitude: f64, at 0;
    longitude: f64, at 8;
    ellipsoid_height: f64, at 16;
    valid_flags: ValidFlags, at 24;
}

constructors! {
    LlhPosition

    /// Creates it from its values.
    fn new(
        latitude: f64,
        longitude: f64,
        ellipsoid_height: f64,
        valid_flags: ValidFlags,
    );
}

valid! {
    LlhPosition
    latitude_is_valid "latitude": valid_flags 0x1;
    longitude_is_valid "longitude": valid_flags 0x1;
    ellipsoid_height_is_valid "ellipsoid_height": valid_flags 0x1;
}

field! {
    LlhPosition: 0x01, "filter_data.llh_position";
    in [0x82];
}

record! {
    /// NED velocity (0x82,0x02).
    ///
    /// Estimated velocity in the NED frame.
    ///
    /// Also called `velocity_ned`. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS)
    /// and [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Velocity NED (0x82,0x02).
    #[derive(Copy, Default)]
    pub struct NedVelocity {
        /// Velocity north.
        ///
        /// Unit: m/s. Frame: ned. At rest and level: 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub north: f32,
        /// Velocity east.
        ///
        /// Unit: m/s. Frame: ned. At rest and level: 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub east: f32,
        /// Velocity down.
        ///
        /// Unit: m/s. Frame: ned. At rest and level: 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub down: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    NedVelocity
    north: f32, at 0;
    east: f32, at 4;
    down: f32, at 8;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    NedVelocity

    /// Creates it from its values.
    fn new(
        north: f32,
        east: f32,
        down: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    NedVelocity
    north_is_valid "north": valid_flags 0x1;
    east_is_valid "east": valid_flags 0x1;
    down_is_valid "down": valid_flags 0x1;
}

field! {
    NedVelocity: 0x02, "filter_data.ned_velocity";
    in [0x82];
}

record! {
    /// Attitude quaternion (0x82,0x03).
    ///
    /// Estimated orientation of the vehicle frame in the NED frame as a quaternion.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7)
    /// and [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 17 more.
    ///
    /// - `v_ned = q * v_vehicle * q^-1`
    /// - The 3DM-GX5-15 manual documents the inverse rotation, which is taken for a misprint.
    ///
    /// Source: 3dm-cv7-gnss-ins: Attitude Quaternion (0x82,0x03); 3dm-gx5-15: 5.2.3 Orientation,
    /// Quaternion (0x82, 0x03).
    #[derive(Copy, Default)]
    pub struct AttitudeQuaternion {
        /// Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first.
        ///
        /// Elements: w, x, y, z. Unit: 1. Frame: ned. At rest and level: x 0, y 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub q: types::Quatf,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AttitudeQuaternion
    q: types::Quatf, at 0;
    valid_flags: ValidFlags, at 16;
}

constructors! {
    AttitudeQuaternion

    /// Creates it from its values.
    fn new(q: impl Into<types::Quatf>, valid_flags: ValidFlags);
}

valid! {
    AttitudeQuaternion
    q_is_valid "q": valid_flags 0x1;
}

field! {
    AttitudeQuaternion: 0x03, "filter_data.attitude_quaternion";
    in [0x82];
}

record! {
    /// Attitude direction cosine matrix (0x82,0x04).
    ///
    /// Estimated orientation of the vehicle frame in the NED frame as a rotation matrix.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 17 more.
    ///
    /// - `v_vehicle = dcm * v_ned`
    ///
    /// Source: 3dm-cv7-gnss-ins: Attitude DCM (0x82,0x04); 3dm-gx5-15: 5.2.7 Orientation, Matrix
    /// (0x82, 0x04).
    #[derive(Copy, Default)]
    pub struct AttitudeDcm {
        /// Rotates vectors of the NED frame into the vehicle frame; row-major.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: ned. At rest and
        /// level: m13 0, m23 0, m31 0, m32 0, m33 1. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub dcm: types::Matrix3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AttitudeDcm
    dcm: types::Matrix3f, at 0;
    valid_flags: ValidFlags, at 36;
}

constructors! {
    AttitudeDcm

    /// Creates it from its values.
    fn new(dcm: impl Into<types::Matrix3f>, valid_flags: ValidFlags);
}

valid! {
    AttitudeDcm
    dcm_is_valid "dcm": valid_flags 0x1;
}

field! {
    AttitudeDcm: 0x04, "filter_data.attitude_dcm";
    in [0x82];
}

record! {
    /// Euler angles (0x82,0x05).
    ///
    /// Estimated orientation of the vehicle frame in the NED frame as Euler angles.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 20 more. Uncertain: The ranges of the angles are inferred; no source states them.
    ///
    /// Source: 3dm-cv7-gnss-ins: Euler Angles (0x82,0x05); 3dm-gx5-15: 5.2.5 Orientation, Euler
    /// Angles (0x82, 0x05).
    #[derive(Copy, Default)]
    pub struct EulerAngles {
        /// Rotation about the x axis of the vehicle, after yaw and pitch (order 3-2-1).
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. At rest and level: 0. Positive: right side
        /// down. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub roll: f32,
        /// Rotation about the y axis.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest and
        /// level: 0. Positive: nose up. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch: f32,
        /// Rotation about the z axis: the heading.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub yaw: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    EulerAngles
    roll: f32, at 0;
    pitch: f32, at 4;
    yaw: f32, at 8;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    EulerAngles

    /// Creates it from its values.
    fn new(
        roll: f32,
        pitch: f32,
        yaw: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    EulerAngles
    roll_is_valid "roll": valid_flags 0x1;
    pitch_is_valid "pitch": valid_flags 0x1;
    yaw_is_valid "yaw": valid_flags 0x1;
}

field! {
    EulerAngles: 0x05, "filter_data.euler_angles";
    in [0x82];
}

record! {
    /// Gyroscope bias (0x82,0x06).
    ///
    /// Estimated bias of the gyroscope.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-GX5-15](crate::devices::GX5_15);
    /// likely or assumed on 18 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyro Bias (0x82,0x06); 3dm-gx5-15: 5.2.9 Gyro Bias (0x82, 0x06).
    #[derive(Copy, Default)]
    pub struct GyroBias {
        /// Bias that the filter subtracts.
        ///
        /// Elements: x, y, z. Unit: rad/s. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub bias: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    GyroBias
    bias: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    GyroBias

    /// Creates it from its values.
    fn new(bias: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    GyroBias
    bias_is_valid "bias": valid_flags 0x1;
}

field! {
    GyroBias: 0x06, "filter_data.gyro_bias";
    in [0x82];
}

record! {
    /// Accelerometer bias (0x82,0x07).
    ///
    /// Estimated bias of the accelerometer.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 6 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accel Bias (0x82,0x07).
    #[derive(Copy, Default)]
    pub struct AccelBias {
        /// Bias that the filter subtracts.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub bias: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AccelBias
    bias: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    AccelBias

    /// Creates it from its values.
    fn new(bias: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    AccelBias
    bias_is_valid "bias": valid_flags 0x1;
}

field! {
    AccelBias: 0x07, "filter_data.accel_bias";
    in [0x82];
}

record! {
    /// Position uncertainty (0x82,0x08).
    ///
    /// Standard deviation of the estimated position, in the NED frame.
    ///
    /// Also called `position_llh_uncertainty`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 5 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: LLH Position Uncertainty (0x82,0x08).
    #[derive(Copy, Default)]
    pub struct LlhPositionUncertainty {
        /// North standard deviation.
        ///
        /// Unit: m. Frame: ned. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub north: f32,
        /// East standard deviation.
        ///
        /// Unit: m. Frame: ned. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub east: f32,
        /// Down standard deviation.
        ///
        /// Unit: m. Frame: ned. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub down: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    LlhPositionUncertainty
    north: f32, at 0;
    east: f32, at 4;
    down: f32, at 8;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    LlhPositionUncertainty

    /// Creates it from its values.
    fn new(
        north: f32,
        east: f32,
        down: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    LlhPositionUncertainty
    north_is_valid "north": valid_flags 0x1;
    east_is_valid "east": valid_flags 0x1;
    down_is_valid "down": valid_flags 0x1;
}

field! {
    LlhPositionUncertainty: 0x08, "filter_data.llh_position_uncertainty";
    in [0x82];
}

record! {
    /// NED velocity uncertainty (0x82,0x09).
    ///
    /// Standard deviation of the estimated velocity in the NED frame.
    ///
    /// Also called `velocity_ned_uncertainty`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 5 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: NED Velocity Uncertainty (0x82,0x09).
    #[derive(Copy, Default)]
    pub struct NedVelocityUncertainty {
        /// North standard deviation.
        ///
        /// Unit: m/s. Frame: ned. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub north: f32,
        /// East standard deviation.
        ///
        /// Unit: m/s. Frame: ned. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub east: f32,
        /// Down standard deviation.
        ///
        /// Unit: m/s. Frame: ned. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub down: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    NedVelocityUncertainty
    north: f32, at 0;
    east: f32, at 4;
    down: f32, at 8;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    NedVelocityUncertainty

    /// Creates it from its values.
    fn new(
        north: f32,
        east: f32,
        down: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    NedVelocityUncertainty
    north_is_valid "north": valid_flags 0x1;
    east_is_valid "east": valid_flags 0x1;
    down_is_valid "down": valid_flags 0x1;
}

field! {
    NedVelocityUncertainty: 0x09, "filter_data.ned_velocity_uncertainty";
    in [0x82];
}

record! {
    /// Euler angles uncertainty (0x82,0x0A).
    ///
    /// Standard deviation of the estimated Euler angles.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-15](crate::devices::GX5_15); likely or
    /// assumed on 19 more.
    ///
    /// - 3DM-GX5: derived from the quaternion, less accurate at steep pitch, and not valid beyond
    ///   70 degrees of pitch up or down.
    ///
    /// Source: 3dm-cv7-gnss-ins: Euler Angles Uncertainty (0x82,0x0A); 3dm-gx5-15: 5.2.6 Attitude
    /// Uncertainty, Euler Angles (0x82, 0x0A).
    #[derive(Copy, Default)]
    pub struct EulerAnglesUncertainty {
        /// Standard deviation of roll.
        ///
        /// Unit: rad. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub roll: f32,
        /// Standard deviation of pitch.
        ///
        /// Unit: rad. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch: f32,
        /// Standard deviation of yaw.
        ///
        /// Unit: rad. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub yaw: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    EulerAnglesUncertainty
    roll: f32, at 0;
    pitch: f32, at 4;
    yaw: f32, at 8;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    EulerAnglesUncertainty

    /// Creates it from its values.
    fn new(
        roll: f32,
        pitch: f32,
        yaw: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    EulerAnglesUncertainty
    roll_is_valid "roll": valid_flags 0x1;
    pitch_is_valid "pitch": valid_flags 0x1;
    yaw_is_valid "yaw": valid_flags 0x1;
}

field! {
    EulerAnglesUncertainty: 0x0A, "filter_data.euler_angles_uncertainty";
    in [0x82];
}

record! {
    /// Gyroscope bias uncertainty (0x82,0x0B).
    ///
    /// Standard deviation of the estimated gyroscope bias.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 20 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyro Bias Uncertainty (0x82,0x0B); 3dm-gx5-15: 5.2.10 Gyro Bias
    /// Uncertainty (0x82, 0x0B).
    #[derive(Copy, Default)]
    pub struct GyroBiasUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Frame: sensor. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub bias_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    GyroBiasUncertainty
    bias_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    GyroBiasUncertainty

    /// Creates it from its values.
    fn new(bias_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    GyroBiasUncertainty
    bias_uncertainty_is_valid "bias_uncertainty": valid_flags 0x1;
}

field! {
    GyroBiasUncertainty: 0x0B, "filter_data.gyro_bias_uncertainty";
    in [0x82];
}

record! {
    /// Accelerometer bias uncertainty (0x82,0x0C).
    ///
    /// Standard deviation of the estimated accelerometer bias.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 6 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accel Bias Uncertainty (0x82,0x0C).
    #[derive(Copy, Default)]
    pub struct AccelBiasUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Frame: sensor. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub bias_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AccelBiasUncertainty
    bias_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    AccelBiasUncertainty

    /// Creates it from its values.
    fn new(bias_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    AccelBiasUncertainty
    bias_uncertainty_is_valid "bias_uncertainty": valid_flags 0x1;
}

field! {
    AccelBiasUncertainty: 0x0C, "filter_data.accel_bias_uncertainty";
    in [0x82];
}

record! {
    /// Linear acceleration (0x82,0x0D).
    ///
    /// Rate of change of the velocity, with the effect of gravity removed.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7)
    /// and [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 17 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Linear Accel (0x82,0x0D); 3dm-gx5-15: 5.2.12 Linear Acceleration
    /// (0x82, 0x0D).
    #[derive(Copy, Default)]
    pub struct LinearAccel {
        /// Linear acceleration; zero while the velocity is constant.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest and level: x 0, y 0, z 0. Valid
        /// if [`valid_flags.valid`](ValidFlags::valid) is set.
        pub accel: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    LinearAccel
    accel: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    LinearAccel

    /// Creates it from its values.
    fn new(accel: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    LinearAccel
    accel_is_valid "accel": valid_flags 0x1;
}

field! {
    LinearAccel: 0x0D, "filter_data.linear_accel";
    in [0x82];
}

record! {
    /// Compensated angular rate (0x82,0x0E).
    ///
    /// Angular rate with the estimated bias removed.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 16 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Comp Angular Rate (0x82,0x0E); 3dm-gx5-15: 5.2.8 Compensated
    /// Angular Rate (0x82, 0x0E).
    #[derive(Copy, Default)]
    pub struct CompAngularRate {
        /// Angular rate.
        ///
        /// Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and level: x 0, y 0, z 0.
        /// Positive: right side down, nose up, clockwise seen from above. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub gyro: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    CompAngularRate
    gyro: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    CompAngularRate

    /// Creates it from its values.
    fn new(gyro: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    CompAngularRate
    gyro_is_valid "gyro": valid_flags 0x1;
}

field! {
    CompAngularRate: 0x0E, "filter_data.comp_angular_rate";
    in [0x82];
}

record! {
    /// WGS84 local gravity magnitude (0x82,0x0F).
    ///
    /// Magnitude of gravity at the position of the device according to the WGS84 model.
    ///
    /// Also called `wgs84_gravity_mag`. Confirmed on [3DM-GX5-15](crate::devices::GX5_15); likely
    /// or assumed on 10 more.
    ///
    /// - The model is valid up to an altitude of 20 km.
    ///
    /// Source: 3dm-gx5-15: 5.2.15 WGS84 Local Gravity Magnitude (0x82, 0x0F).
    #[derive(Copy, Default)]
    pub struct Wgs84GravityMagnitude {
        /// Gravity at this position according to the model.
        ///
        /// Unit: m/s^2. Range: at least 0. At rest and level: 9.8. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub gravity_magnitude: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    Wgs84GravityMagnitude
    gravity_magnitude: f32, at 0;
    valid_flags: ValidFlags, at 4;
}

constructors! {
    Wgs84GravityMagnitude

    /// Creates it from its values.
    fn new(gravity_magnitude: f32, valid_flags: ValidFlags);
}

valid! {
    Wgs84GravityMagnitude
    gravity_magnitude_is_valid "gravity_magnitude": valid_flags 0x1;
}

field! {
    Wgs84GravityMagnitude: 0x0F, "filter_data.wgs84_gravity_magnitude";
    in [0x82];
}

record! {
    /// Filter status (0x82,0x10).
    ///
    /// State, dynamics mode, condition and warnings of the filter.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7)
    /// and [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 17 more.
    ///
    /// - 7-series: state 1 is initialization, 2 vertical gyro, 3 AHRS, 4 full navigation. On the
    ///   3DM-CV7, normal operation is state 4, mode 1, flags 1 (stable).
    /// - 5-series and older: state 0 is start-up, 1 initialization, 2 a valid solution, 3 a
    ///   solution with an error. Bits 12 and 13 of the flags have other meanings in state 1 than in
    ///   states 2 and 3.
    ///
    /// Source: 3dm-cv7-gnss-ins: Status (0x82,0x10); 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Status {
        /// Progress of the filter from start-up to its full solution.
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
        /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
        /// [3DM-GX5-25](crate::devices::GX5_25), [3DM-GX5-45](crate::devices::GX5_45),
        /// [3DM-MV5-AR](crate::devices::MV5_AR), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT),
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and [3DM-RQ1-IMU](crate::devices::RQ1_IMU):
        /// values of [`Gx5FilterState`] (inferred: the 3DM-GX5-15 has them, and the SDK lists the
        /// same states for all generations up to the fifth). On the
        /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
        /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
        /// [3DM-GV7-AR](crate::devices::GV7_AR) and [3DM-GV7-INS](crate::devices::GV7_INS): values
        /// of [`Cv7FilterState`] (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the
        /// same states for its generation). On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`Cv7FilterState`]. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): values of [`Gx5FilterState`].
        pub filter_state: u16,
        /// Motion for which the filter is configured.
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
        /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
        /// [3DM-GX5-25](crate::devices::GX5_25), [3DM-GX5-45](crate::devices::GX5_45),
        /// [3DM-MV5-AR](crate::devices::MV5_AR), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT),
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and [3DM-RQ1-IMU](crate::devices::RQ1_IMU):
        /// values of [`Gx5DynamicsMode`] (inferred: the 3DM-GX5-15 has them, and the SDK lists the
        /// same states for all generations up to the fifth). On the
        /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
        /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
        /// [3DM-GV7-AR](crate::devices::GV7_AR) and [3DM-GV7-INS](crate::devices::GV7_INS): values
        /// of [`Cv7DynamicsMode`] (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the
        /// same states for its generation). On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`Cv7DynamicsMode`]. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): values of [`Gx5DynamicsMode`].
        pub dynamics_mode: u16,
        /// Condition and warnings.
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
        /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
        /// [3DM-GX5-25](crate::devices::GX5_25), [3DM-GX5-45](crate::devices::GX5_45),
        /// [3DM-MV5-AR](crate::devices::MV5_AR), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT),
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and [3DM-RQ1-IMU](crate::devices::RQ1_IMU):
        /// values of [`Gx5StatusFlags`] (inferred: the 3DM-GX5-15 has them, and the SDK lists the
        /// same states for all generations up to the fifth). On the
        /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
        /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
        /// [3DM-GV7-AR](crate::devices::GV7_AR) and [3DM-GV7-INS](crate::devices::GV7_INS): values
        /// of [`Cv7StatusFlags`] (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the
        /// same states for its generation). On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`Cv7StatusFlags`]. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): values of [`Gx5StatusFlags`].
        pub status_flags: u16,
    }
}

view! {
    Status
    filter_state: u16, at 0;
    dynamics_mode: u16, at 2;
    status_flags: u16, at 4;
}

constructors! {
    Status

    /// Creates it from its values.
    fn new(
        filter_state: u16,
        dynamics_mode: u16,
        status_flags: u16,
    );
}

#[rustfmt::skip]
impl Status {
    /// Reads `filter_state` as [`Gx5FilterState`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
    /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
    /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
    /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
    /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
    /// [3DM-GX5-25](crate::devices::GX5_25), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-MV5-AR](crate::devices::MV5_AR), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT),
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and [3DM-RQ1-IMU](crate::devices::RQ1_IMU):
    /// values of [`Gx5FilterState`] (inferred: the 3DM-GX5-15 has them, and the SDK lists the same
    /// states for all generations up to the fifth). On the [3DM-GX5-15](crate::devices::GX5_15):
    /// values of [`Gx5FilterState`].
    #[inline]
    #[must_use]
    pub fn filter_state_as_gx5_filter_state(&self) -> Gx5FilterState {
        self.filter_state.into()
    }

    /// Reads `filter_state` as [`Cv7FilterState`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
    /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
    /// [3DM-GV7-AR](crate::devices::GV7_AR) and [3DM-GV7-INS](crate::devices::GV7_INS): values of
    /// [`Cv7FilterState`] (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same
    /// states for its generation). On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values
    /// of [`Cv7FilterState`].
    #[inline]
    #[must_use]
    pub fn filter_state_as_cv7_filter_state(&self) -> Cv7FilterState {
        self.filter_state.into()
    }

    /// Reads `dynamics_mode` as [`Gx5DynamicsMode`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
    /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
    /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
    /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
    /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
    /// [3DM-GX5-25](crate::devices::GX5_25), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-MV5-AR](crate::devices::MV5_AR), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT),
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and [3DM-RQ1-IMU](crate::devices::RQ1_IMU):
    /// values of [`Gx5DynamicsMode`] (inferred: the 3DM-GX5-15 has them, and the SDK lists the same
    /// states for all generations up to the fifth). On the [3DM-GX5-15](crate::devices::GX5_15):
    /// values of [`Gx5DynamicsMode`].
    #[inline]
    #[must_use]
    pub fn dynamics_mode_as_gx5_dynamics_mode(&self) -> Gx5DynamicsMode {
        self.dynamics_mode.into()
    }

    /// Reads `dynamics_mode` as [`Cv7DynamicsMode`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
    /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
    /// [3DM-GV7-AR](crate::devices::GV7_AR) and [3DM-GV7-INS](crate::devices::GV7_INS): values of
    /// [`Cv7DynamicsMode`] (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same
    /// states for its generation). On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values
    /// of [`Cv7DynamicsMode`].
    #[inline]
    #[must_use]
    pub fn dynamics_mode_as_cv7_dynamics_mode(&self) -> Cv7DynamicsMode {
        self.dynamics_mode.into()
    }

    /// Reads `status_flags` as [`Gx5StatusFlags`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
    /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
    /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
    /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
    /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
    /// [3DM-GX5-25](crate::devices::GX5_25), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-MV5-AR](crate::devices::MV5_AR), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT),
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and [3DM-RQ1-IMU](crate::devices::RQ1_IMU):
    /// values of [`Gx5StatusFlags`] (inferred: the 3DM-GX5-15 has them, and the SDK lists the same
    /// states for all generations up to the fifth). On the [3DM-GX5-15](crate::devices::GX5_15):
    /// values of [`Gx5StatusFlags`].
    #[inline]
    #[must_use]
    pub fn status_flags_as_gx5_status_flags(&self) -> Gx5StatusFlags {
        self.status_flags.into()
    }

    /// Reads `status_flags` as [`Cv7StatusFlags`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
    /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
    /// [3DM-GV7-AR](crate::devices::GV7_AR) and [3DM-GV7-INS](crate::devices::GV7_INS): values of
    /// [`Cv7StatusFlags`] (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists the same
    /// states for its generation). On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values
    /// of [`Cv7StatusFlags`].
    #[inline]
    #[must_use]
    pub fn status_flags_as_cv7_status_flags(&self) -> Cv7StatusFlags {
        self.status_flags.into()
    }
}

field! {
    Status: 0x10, "filter_data.status";
    in [0x82];
}

record! {
    /// Filter timestamp (0x82,0x11).
    ///
    /// GPS time of the filter data.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 10 more.
    ///
    /// - Without PPS the internal clock drives the time, and the time jumps when the PPS returns.
    /// - Without synchronization to a receiver or an external clock it is the internal system time.
    /// - 3DM-CV7: this field may be withdrawn; prefer
    ///   [`shared::GpsTimestamp`](crate::shared::GpsTimestamp).
    ///
    /// Source: 3dm-cv7-gnss-ins: Timestamp (0x82,0x11); 3dm-gx5-15: 5.2.2 GPS Timestamp (0x82,
    /// 0x11).
    #[derive(Copy, Default)]
    pub struct Timestamp {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week, counted from 1980.
        ///
        /// Unit: week. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        pub week_number: u16,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    Timestamp
    tow: f64, at 0;
    week_number: u16, at 8;
    valid_flags: ValidFlags, at 10;
}

constructors! {
    Timestamp

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        valid_flags: ValidFlags,
    );
}

valid! {
    Timestamp
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x1;
}

field! {
    Timestamp: 0x11, "filter_data.timestamp";
    in [0x82];
}

record! {
    /// Quaternion uncertainty (0x82,0x12).
    ///
    /// Standard deviation of the elements of the estimated attitude quaternion.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 20 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Quaternion Attitude Uncertainty (0x82,0x12); 3dm-gx5-15: 5.2.4
    /// Attitude Uncertainty, Quaternion Elements (0x82, 0x12).
    #[derive(Copy, Default)]
    pub struct QuaternionAttitudeUncertainty {
        /// Standard deviation per element.
        ///
        /// Elements: w, x, y, z. Unit: 1. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub q: types::Quatf,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    QuaternionAttitudeUncertainty
    q: types::Quatf, at 0;
    valid_flags: ValidFlags, at 16;
}

constructors! {
    QuaternionAttitudeUncertainty

    /// Creates it from its values.
    fn new(q: impl Into<types::Quatf>, valid_flags: ValidFlags);
}

valid! {
    QuaternionAttitudeUncertainty
    q_is_valid "q": valid_flags 0x1;
}

field! {
    QuaternionAttitudeUncertainty: 0x12, "filter_data.quaternion_attitude_uncertainty";
    in [0x82];
}

record! {
    /// Gravity vector (0x82,0x13).
    ///
    /// Estimated gravity.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-GX5-15](crate::devices::GX5_15);
    /// likely or assumed on 18 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gravity Vector (0x82,0x13); 3dm-gx5-15: 5.2.14 Gravity Vector
    /// (0x82, 0x13).
    #[derive(Copy, Default)]
    pub struct GravityVector {
        /// Gravity vector, which points down.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest and level: x 0, y 0, z 9.8.
        /// Valid if [`valid_flags.valid`](ValidFlags::valid) is set. Uncertain: No source states
        /// the sign.
        pub gravity: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    GravityVector
    gravity: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    GravityVector

    /// Creates it from its values.
    fn new(gravity: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    GravityVector
    gravity_is_valid "gravity": valid_flags 0x1;
}

field! {
    GravityVector: 0x13, "filter_data.gravity_vector";
    in [0x82];
}

record! {
    /// Heading update source state (0x82,0x14).
    ///
    /// The last heading that updated the filter, and its source.
    ///
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 8 more.
    ///
    /// - The valid bit means that the source provided data within the last 2 seconds.
    ///
    /// Source: 3dm-gx5-15: 5.2.16 Heading Update Source State (0x82, 0x14).
    #[derive(Copy, Default)]
    pub struct HeadingUpdateState {
        /// Heading of the sensor frame relative to true north.
        ///
        /// Unit: rad. Frame: ned. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Standard deviation of the heading.
        ///
        /// Unit: rad. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading_uncertainty: f32,
        /// Sources of the heading.
        ///
        /// On the [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-15](crate::devices::CX5_15) and
        /// [3DM-GX5-15](crate::devices::GX5_15): only [`external`](HeadingSourceFlags::external).
        /// On the [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-GX4-25](crate::devices::GX4_25) and [3DM-GX5-25](crate::devices::GX5_25): only
        /// [`mag`](HeadingSourceFlags::mag) and [`external`](HeadingSourceFlags::external).
        pub source: HeadingSourceFlags,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    HeadingUpdateState
    heading: f32, at 0;
    heading_uncertainty: f32, at 4;
    source: HeadingSourceFlags, at 8;
    valid_flags: ValidFlags, at 10;
}

constructors! {
    HeadingUpdateState

    /// Creates it from its values.
    fn new(
        heading: f32,
        heading_uncertainty: f32,
        source: HeadingSourceFlags,
        valid_flags: ValidFlags,
    );
}

valid! {
    HeadingUpdateState
    heading_is_valid "heading": valid_flags 0x1;
    heading_uncertainty_is_valid "heading_uncertainty": valid_flags 0x1;
}

field! {
    HeadingUpdateState: 0x14, "filter_data.heading_update_state";
    in [0x82];
}

record! {
    /// Magnetic model (0x82,0x15).
    ///
    /// Magnetic field at the position of the device according to the World Magnetic Model.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 11 more.
    ///
    /// - It is valid only with a valid GNSS position.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetic Model (0x82,0x15).
    #[derive(Copy, Default)]
    pub struct MagneticModel {
        /// North component of the field.
        ///
        /// Unit: gauss. Frame: ned. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub intensity_north: f32,
        /// East component of the field.
        ///
        /// Unit: gauss. Frame: ned. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub intensity_east: f32,
        /// Down component of the field.
        ///
        /// Unit: gauss. Frame: ned. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub intensity_down: f32,
        /// Angle of the field below the horizontal plane.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: the
        /// field points down. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination: f32,
        /// Angle from true north to magnetic north.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is east of true north.
        /// Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub declination: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagneticModel
    intensity_north: f32, at 0;
    intensity_east: f32, at 4;
    intensity_down: f32, at 8;
    inclination: f32, at 12;
    declination: f32, at 16;
    valid_flags: ValidFlags, at 20;
}

constructors! {
    MagneticModel

    /// Creates it from its values.
    fn new(
        intensity_north: f32,
        intensity_east: f32,
        intensity_down: f32,
        inclination: f32,
        declination: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    MagneticModel
    intensity_north_is_valid "intensity_north": valid_flags 0x1;
    intensity_east_is_valid "intensity_east": valid_flags 0x1;
    intensity_down_is_valid "intensity_down": valid_flags 0x1;
    inclination_is_valid "inclination": valid_flags 0x1;
    declination_is_valid "declination": valid_flags 0x1;
}

field! {
    MagneticModel: 0x15, "filter_data.magnetic_model";
    in [0x82];
}

record! {
    /// Gyroscope scale factor (0x82,0x16).
    ///
    /// Estimated scale factor of the gyroscope.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gyro Scale Factor (0x82,0x16).
    #[derive(Copy, Default)]
    pub struct GyroScaleFactor {
        /// Scale factor per axis.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub scale_factor: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    GyroScaleFactor
    scale_factor: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    GyroScaleFactor

    /// Creates it from its values.
    fn new(scale_factor: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    GyroScaleFactor
    scale_factor_is_valid "scale_factor": valid_flags 0x1;
}

field! {
    GyroScaleFactor: 0x16, "filter_data.gyro_scale_factor";
    in [0x82];
}

record! {
    /// Accelerometer scale factor (0x82,0x17).
    ///
    /// Estimated scale factor of the accelerometer.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Accel Scale Factor (0x82,0x17).
    #[derive(Copy, Default)]
    pub struct AccelScaleFactor {
        /// Scale factor per axis.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub scale_factor: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AccelScaleFactor
    scale_factor: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    AccelScaleFactor

    /// Creates it from its values.
    fn new(scale_factor: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    AccelScaleFactor
    scale_factor_is_valid "scale_factor": valid_flags 0x1;
}

field! {
    AccelScaleFactor: 0x17, "filter_data.accel_scale_factor";
    in [0x82];
}

record! {
    /// Gyroscope scale factor uncertainty (0x82,0x18).
    ///
    /// Standard deviation of the estimated scale factor of the gyroscope.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gyro Scale Factor Uncertainty (0x82,0x18).
    #[derive(Copy, Default)]
    pub struct GyroScaleFactorUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: sensor. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub scale_factor_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    GyroScaleFactorUncertainty
    scale_factor_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    GyroScaleFactorUncertainty

    /// Creates it from its values.
    fn new(scale_factor_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    GyroScaleFactorUncertainty
    scale_factor_uncertainty_is_valid "scale_factor_uncertainty": valid_flags 0x1;
}

field! {
    GyroScaleFactorUncertainty: 0x18, "filter_data.gyro_scale_factor_uncertainty";
    in [0x82];
}

record! {
    /// Accelerometer scale factor uncertainty (0x82,0x19).
    ///
    /// Standard deviation of the estimated scale factor of the accelerometer.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Accel Scale Factor Uncertainty (0x82,0x19).
    #[derive(Copy, Default)]
    pub struct AccelScaleFactorUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: sensor. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub scale_factor_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AccelScaleFactorUncertainty
    scale_factor_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    AccelScaleFactorUncertainty

    /// Creates it from its values.
    fn new(scale_factor_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    AccelScaleFactorUncertainty
    scale_factor_uncertainty_is_valid "scale_factor_uncertainty": valid_flags 0x1;
}

field! {
    AccelScaleFactorUncertainty: 0x19, "filter_data.accel_scale_factor_uncertainty";
    in [0x82];
}

record! {
    /// Magnetometer bias (0x82,0x1A).
    ///
    /// Estimated bias of the magnetometer.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a
    /// magnetometer.
    ///
    /// Source: mip-sdk-4: Mag Bias (0x82,0x1A).
    #[derive(Copy, Default)]
    pub struct MagBias {
        /// Estimated bias of the magnetometer.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub bias: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagBias
    bias: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    MagBias

    /// Creates it from its values.
    fn new(bias: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    MagBias
    bias_is_valid "bias": valid_flags 0x1;
}

field! {
    MagBias: 0x1A, "filter_data.mag_bias";
    in [0x82];
}

record! {
    /// Magnetometer bias uncertainty (0x82,0x1B).
    ///
    /// Standard deviation of the estimated bias of the magnetometer.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a
    /// magnetometer.
    ///
    /// Source: mip-sdk-4: Mag Bias Uncertainty (0x82,0x1B).
    #[derive(Copy, Default)]
    pub struct MagBiasUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub bias_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagBiasUncertainty
    bias_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    MagBiasUncertainty

    /// Creates it from its values.
    fn new(bias_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    MagBiasUncertainty
    bias_uncertainty_is_valid "bias_uncertainty": valid_flags 0x1;
}

field! {
    MagBiasUncertainty: 0x1B, "filter_data.mag_bias_uncertainty";
    in [0x82];
}

record! {
    /// Compensated acceleration (0x82,0x1C).
    ///
    /// Specific force with the estimated bias removed.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7)
    /// and [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 14 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Compensated Acceleration (0x82,0x1C); 3dm-gx5-15: 5.2.11
    /// Compensated Acceleration (0x82, 0x1C).
    #[derive(Copy, Default)]
    pub struct CompAccel {
        /// Specific force: acceleration minus gravity.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest and level: x 0, y 0, z -9.8.
        /// Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        pub accel: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    CompAccel
    accel: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    CompAccel

    /// Creates it from its values.
    fn new(accel: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    CompAccel
    accel_is_valid "accel": valid_flags 0x1;
}

field! {
    CompAccel: 0x1C, "filter_data.comp_accel";
    in [0x82];
}

record! {
    /// Standard atmosphere (0x82,0x20).
    ///
    /// US Standard Atmosphere of 1976 at the device's altitude.
    ///
    /// No device is known for certain to support it. Known only from the MicroStrain MIP SDK.
    ///
    /// - It is valid only with a valid GNSS position.
    ///
    /// Source: mip-sdk-4: Standard atmosphere (0x82,0x20).
    #[derive(Copy, Default)]
    pub struct StandardAtmosphere {
        /// Altitude used in the model.
        ///
        /// Unit: m. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub geometric_altitude: f32,
        /// Geometric altitude corrected for the decrease of gravity with height.
        ///
        /// Unit: m. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub geopotential_altitude: f32,
        /// Temperature at this altitude according to the model.
        ///
        /// Unit: degC. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub standard_temperature: f32,
        /// Pressure at this altitude according to the model.
        ///
        /// Unit: mbar. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub standard_pressure: f32,
        /// Air density at this altitude according to the model.
        ///
        /// Unit: kg/m^3. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is
        /// set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub standard_density: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    StandardAtmosphere
    geometric_altitude: f32, at 0;
    geopotential_altitude: f32, at 4;
    standard_temperature: f32, at 8;
    standard_pressure: f32, at 12;
    standard_density: f32, at 16;
    valid_flags: ValidFlags, at 20;
}

constructors! {
    StandardAtmosphere

    /// Creates it from its values.
    fn new(
        geometric_altitude: f32,
        geopotential_altitude: f32,
        standard_temperature: f32,
        standard_pressure: f32,
        standard_density: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    StandardAtmosphere
    geometric_altitude_is_valid "geometric_altitude": valid_flags 0x1;
    geopotential_altitude_is_valid "geopotential_altitude": valid_flags 0x1;
    standard_temperature_is_valid "standard_temperature": valid_flags 0x1;
    standard_pressure_is_valid "standard_pressure": valid_flags 0x1;
    standard_density_is_valid "standard_density": valid_flags 0x1;
}

field! {
    StandardAtmosphere: 0x20, "filter_data.standard_atmosphere";
    in [0x82];
}

record! {
    /// Pressure altitude (0x82,0x21).
    ///
    /// Altitude from the measured pressure, by the US Standard Atmosphere of 1976.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 17 more. Requires a pressure
    /// sensor.
    ///
    /// - It needs a valid pressure. The model ends at a pressure of 0.0037 mbar, an altitude of
    ///   84852 m.
    ///
    /// Source: 3dm-cv7-gnss-ins: Pressure Altitude (0x82,0x21); 3dm-gx5-15: 5.2.13 Pressure
    /// Altitude (0x82, 0x21).
    #[derive(Copy, Default)]
    pub struct PressureAltitude {
        /// Altitude at which the standard atmosphere has the measured pressure.
        ///
        /// Unit: m. Range: at most 84852. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pressure_altitude: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    PressureAltitude
    pressure_altitude: f32, at 0;
    valid_flags: ValidFlags, at 4;
}

constructors! {
    PressureAltitude

    /// Creates it from its values.
    fn new(pressure_altitude: f32, valid_flags: ValidFlags);
}

valid! {
    PressureAltitude
    pressure_altitude_is_valid "pressure_altitude": valid_flags 0x1;
}

field! {
    PressureAltitude: 0x21, "filter_data.pressure_altitude";
    in [0x82];
}

record! {
    /// Density altitude (0x82,0x22).
    ///
    /// Density of the surrounding air, expressed as the altitude with the same density in the
    /// standard atmosphere.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The
    /// SDK lists only the name; the description is the usual meaning of the term.
    ///
    /// Source: mip-sdk-4: Density altitude (0x82,0x22).
    #[derive(Copy, Default)]
    pub struct DensityAltitude {
        /// Altitude at which the standard atmosphere has the present air density.
        ///
        /// Unit: m. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub density_altitude: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    DensityAltitude
    density_altitude: f32, at 0;
    valid_flags: ValidFlags, at 4;
}

constructors! {
    DensityAltitude

    /// Creates it from its values.
    fn new(density_altitude: f32, valid_flags: ValidFlags);
}

valid! {
    DensityAltitude
    density_altitude_is_valid "density_altitude": valid_flags 0x1;
}

field! {
    DensityAltitude: 0x22, "filter_data.density_altitude";
    in [0x82];
}

record! {
    /// Magnetometer offset (0x82,0x25).
    ///
    /// Estimated hard iron offset of the magnetometer.
    ///
    /// No device is known for certain to support it. Also called `magnetometer_offset`. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// - The filter adds it to the stored offset of
    ///   [`mip_3dm::MagHardIronOffset`](crate::mip_3dm::MagHardIronOffset).
    ///
    /// Source: mip-sdk-4: Magnetometer offset (0x82,0x25).
    #[derive(Copy, Default)]
    pub struct MagOffset {
        /// Estimated constant field of magnetized parts near the magnetometer.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub hard_iron: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagOffset
    hard_iron: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    MagOffset

    /// Creates it from its values.
    fn new(hard_iron: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    MagOffset
    hard_iron_is_valid "hard_iron": valid_flags 0x1;
}

field! {
    MagOffset: 0x25, "filter_data.mag_offset";
    in [0x82];
}

record! {
    /// Magnetometer matrix (0x82,0x26).
    ///
    /// Estimated soft iron matrix of the magnetometer.
    ///
    /// No device is known for certain to support it. Also called `magnetometer_matrix`. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// - The filter multiplies the stored matrix of
    ///   [`mip_3dm::MagSoftIronMatrix`](crate::mip_3dm::MagSoftIronMatrix) by this matrix on the
    ///   right.
    ///
    /// Source: mip-sdk-4: Magnetometer matrix (0x82,0x26).
    #[derive(Copy, Default)]
    pub struct MagMatrix {
        /// Soft iron matrix in row-major order.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: sensor. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub soft_iron: types::Matrix3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagMatrix
    soft_iron: types::Matrix3f, at 0;
    valid_flags: ValidFlags, at 36;
}

constructors! {
    MagMatrix

    /// Creates it from its values.
    fn new(soft_iron: impl Into<types::Matrix3f>, valid_flags: ValidFlags);
}

valid! {
    MagMatrix
    soft_iron_is_valid "soft_iron": valid_flags 0x1;
}

field! {
    MagMatrix: 0x26, "filter_data.mag_matrix";
    in [0x82];
}

record! {
    /// Magnetometer offset uncertainty (0x82,0x28).
    ///
    /// Standard deviation of the estimated hard iron offset.
    ///
    /// No device is known for certain to support it. Also called `magnetometer_offset_uncertainty`.
    /// Known only from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Magnetometer offset uncertainty (0x82,0x28).
    #[derive(Copy, Default)]
    pub struct MagOffsetUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub hard_iron_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagOffsetUncertainty
    hard_iron_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    MagOffsetUncertainty

    /// Creates it from its values.
    fn new(hard_iron_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    MagOffsetUncertainty
    hard_iron_uncertainty_is_valid "hard_iron_uncertainty": valid_flags 0x1;
}

field! {
    MagOffsetUncertainty: 0x28, "filter_data.mag_offset_uncertainty";
    in [0x82];
}

record! {
    /// Magnetometer matrix uncertainty (0x82,0x29).
    ///
    /// Standard deviation of the estimated soft iron matrix.
    ///
    /// No device is known for certain to support it. Also called `magnetometer_matrix_uncertainty`.
    /// Known only from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Magnetometer matrix uncertainty (0x82,0x29).
    #[derive(Copy, Default)]
    pub struct MagMatrixUncertainty {
        /// Standard deviation per element.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: sensor. Range: at
        /// least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        pub soft_iron_uncertainty: types::Matrix3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagMatrixUncertainty
    soft_iron_uncertainty: types::Matrix3f, at 0;
    valid_flags: ValidFlags, at 36;
}

constructors! {
    MagMatrixUncertainty

    /// Creates it from its values.
    fn new(soft_iron_uncertainty: impl Into<types::Matrix3f>, valid_flags: ValidFlags);
}

valid! {
    MagMatrixUncertainty
    soft_iron_uncertainty_is_valid "soft_iron_uncertainty": valid_flags 0x1;
}

field! {
    MagMatrixUncertainty: 0x29, "filter_data.mag_matrix_uncertainty";
    in [0x82];
}

record! {
    /// Magnetometer covariance matrix (0x82,0x2A).
    ///
    /// Covariance of the magnetometer measurement.
    ///
    /// Also called `magnetometer_covariance_matrix`. Not listed in any device profile. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Magnetometer covariance matrix (0x82,0x2A).
    #[derive(Copy, Default)]
    pub struct MagCovarianceMatrix {
        /// Covariance matrix in row-major order.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set. Uncertain: No source states the unit,
        /// which is likely gauss^2, or the frame.
        pub covariance: types::Matrix3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagCovarianceMatrix
    covariance: types::Matrix3f, at 0;
    valid_flags: ValidFlags, at 36;
}

constructors! {
    MagCovarianceMatrix

    /// Creates it from its values.
    fn new(covariance: impl Into<types::Matrix3f>, valid_flags: ValidFlags);
}

valid! {
    MagCovarianceMatrix
    covariance_is_valid "covariance": valid_flags 0x1;
}

field! {
    MagCovarianceMatrix: 0x2A, "filter_data.mag_covariance_matrix";
    in [0x82];
}

record! {
    /// Magnetometer residual vector (0x82,0x2C).
    ///
    /// Residual of the magnetometer measurement.
    ///
    /// Also called `magnetometer_residual_vector`. Not listed in any device profile. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Magnetometer residual vector (0x82,0x2C).
    #[derive(Copy, Default)]
    pub struct MagResidualVector {
        /// Difference between the measured and the expected magnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: vehicle. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub residual: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MagResidualVector
    residual: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    MagResidualVector

    /// Creates it from its values.
    fn new(residual: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    MagResidualVector
    residual_is_valid "residual": valid_flags 0x1;
}

field! {
    MagResidualVector: 0x2C, "filter_data.mag_residual_vector";
    in [0x82];
}

record! {
    /// Antenna offset correction (0x82,0x30).
    ///
    /// Estimated error of the GNSS antenna offset.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - The filter adds it to the stored offset of
    ///   [`filter::AntennaOffset`](crate::filter::AntennaOffset).
    ///
    /// Source: mip-sdk-4: Antenna offset correction (0x82,0x30).
    #[derive(Copy, Default)]
    pub struct AntennaOffsetCorrection {
        /// Estimated correction of the configured antenna offset.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub offset: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AntennaOffsetCorrection
    offset: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    AntennaOffsetCorrection

    /// Creates it from its values.
    fn new(offset: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    AntennaOffsetCorrection
    offset_is_valid "offset": valid_flags 0x1;
}

field! {
    AntennaOffsetCorrection: 0x30, "filter_data.antenna_offset_correction";
    in [0x82];
}

record! {
    /// Antenna offset correction uncertainty (0x82,0x31).
    ///
    /// Standard deviation of the estimated error of the GNSS antenna offset.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Antenna offset correction uncertainty (0x82,0x31).
    #[derive(Copy, Default)]
    pub struct AntennaOffsetCorrectionUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub offset_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    AntennaOffsetCorrectionUncertainty
    offset_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    AntennaOffsetCorrectionUncertainty

    /// Creates it from its values.
    fn new(offset_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    AntennaOffsetCorrectionUncertainty
    offset_uncertainty_is_valid "offset_uncertainty": valid_flags 0x1;
}

field! {
    AntennaOffsetCorrectionUncertainty: 0x31, "filter_data.antenna_offset_correction_uncertainty";
    in [0x82];
}

record! {
    /// Clock correction (0x82,0x32).
    ///
    /// Estimated clock error of one GNSS receiver.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Clock correction (0x82,0x32).
    #[derive(Copy, Default)]
    pub struct ClockCorrection {
        /// Receiver, counted from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: u8,
        /// Bias of the clock.
        ///
        /// Unit: s. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias: f32,
        /// Drift of the clock.
        ///
        /// Unit: s/s. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias_drift: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    ClockCorrection
    receiver_id: u8, at 0;
    bias: f32, at 1;
    bias_drift: f32, at 5;
    valid_flags: ValidFlags, at 9;
}

constructors! {
    ClockCorrection

    /// Creates it from its values.
    fn new(
        receiver_id: u8,
        bias: f32,
        bias_drift: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    ClockCorrection
    bias_is_valid "bias": valid_flags 0x1;
    bias_drift_is_valid "bias_drift": valid_flags 0x1;
}

field! {
    ClockCorrection: 0x32, "filter_data.clock_correction";
    in [0x82];
}

record! {
    /// Clock correction uncertainty (0x82,0x33).
    ///
    /// Standard deviation of the estimated clock error of one GNSS receiver.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Clock correction uncertainty (0x82,0x33).
    #[derive(Copy, Default)]
    pub struct ClockCorrectionUncertainty {
        /// Receiver, counted from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: u8,
        /// Standard deviation of the bias.
        ///
        /// Unit: s. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias_uncertainty: f32,
        /// Standard deviation of the drift.
        ///
        /// Unit: s/s. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias_drift_uncertainty: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    ClockCorrectionUncertainty
    receiver_id: u8, at 0;
    bias_uncertainty: f32, at 1;
    bias_drift_uncertainty: f32, at 5;
    valid_flags: ValidFlags, at 9;
}

constructors! {
    ClockCorrectionUncertainty

    /// Creates it from its values.
    fn new(
        receiver_id: u8,
        bias_uncertainty: f32,
        bias_drift_uncertainty: f32,
        valid_flags: ValidFlags,
    );
}

valid! {
    ClockCorrectionUncertainty
    bias_uncertainty_is_valid "bias_uncertainty": valid_flags 0x1;
    bias_drift_uncertainty_is_valid "bias_drift_uncertainty": valid_flags 0x1;
}

field! {
    ClockCorrectionUncertainty: 0x33, "filter_data.clock_correction_uncertainty";
    in [0x82];
}

record! {
    /// Multi-antenna offset correction (0x82,0x34).
    ///
    /// Estimated error of one GNSS antenna's offset.
    ///
    /// Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7). Requires a receiver.
    ///
    /// - The filter adds it to the stored offset.
    ///
    /// Source: 3dm-cv7-gnss-ins: Multi Antenna Offset Correction (0x82,0x34).
    #[derive(Copy, Default)]
    pub struct MultiAntennaOffsetCorrection {
        /// Receiver that the antenna belongs to.
        pub receiver_id: u8,
        /// Estimated correction of the configured antenna offset.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub offset: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MultiAntennaOffsetCorrection
    receiver_id: u8, at 0;
    offset: types::Vector3f, at 1;
    valid_flags: ValidFlags, at 13;
}

constructors! {
    MultiAntennaOffsetCorrection

    /// Creates it from its values.
    fn new(
        receiver_id: u8,
        offset: impl Into<types::Vector3f>,
        valid_flags: ValidFlags,
    );
}

valid! {
    MultiAntennaOffsetCorrection
    offset_is_valid "offset": valid_flags 0x1;
}

field! {
    MultiAntennaOffsetCorrection: 0x34, "filter_data.multi_antenna_offset_correction";
    in [0x82];
}

record! {
    /// Multi-antenna offset correction uncertainty (0x82,0x35).
    ///
    /// Standard deviation of the estimated error of one GNSS antenna's offset.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    /// Requires a receiver.
    ///
    /// Source: 3dm-cv7-gnss-ins: Multi Antenna Offset Correction Uncertainty (0x82,0x35).
    #[derive(Copy, Default)]
    pub struct MultiAntennaOffsetCorrectionUncertainty {
        /// Receiver that the antenna belongs to.
        pub receiver_id: u8,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub offset_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    MultiAntennaOffsetCorrectionUncertainty
    receiver_id: u8, at 0;
    offset_uncertainty: types::Vector3f, at 1;
    valid_flags: ValidFlags, at 13;
}

constructors! {
    MultiAntennaOffsetCorrectionUncertainty

    /// Creates it from its values.
    fn new(
        receiver_id: u8,
        offset_uncertainty: impl Into<types::Vector3f>,
        valid_flags: ValidFlags,
    );
}

valid! {
    MultiAntennaOffsetCorrectionUncertainty
    offset_uncertainty_is_valid "offset_uncertainty": valid_flags 0x1;
}

field! {
    MultiAntennaOffsetCorrectionUncertainty: 0x35, "filter_data.multi_antenna_offset_correction_uncertainty";
    in [0x82];
}

record! {
    /// ECEF position uncertainty (0x82,0x36).
    ///
    /// Standard deviation of the estimated position in Earth-fixed coordinates.
    ///
    /// Also called `ecef_pos_uncertainty`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: ECEF Position Uncertainty (0x82,0x36).
    #[derive(Copy, Default)]
    pub struct EcefPositionUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub position_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    EcefPositionUncertainty
    position_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    EcefPositionUncertainty

    /// Creates it from its values.
    fn new(position_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    EcefPositionUncertainty
    position_uncertainty_is_valid "position_uncertainty": valid_flags 0x1;
}

field! {
    EcefPositionUncertainty: 0x36, "filter_data.ecef_position_uncertainty";
    in [0x82];
}

record! {
    /// ECEF velocity uncertainty (0x82,0x37).
    ///
    /// Standard deviation of the estimated velocity in Earth-fixed coordinates.
    ///
    /// Also called `ecef_vel_uncertainty`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: ECEF Velocity Uncertainty (0x82,0x37).
    #[derive(Copy, Default)]
    pub struct EcefVelocityUncertainty {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. Range: at least 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub velocity_uncertainty: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    EcefVelocityUncertainty
    velocity_uncertainty: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    EcefVelocityUncertainty

    /// Creates it from its values.
    fn new(velocity_uncertainty: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    EcefVelocityUncertainty
    velocity_uncertainty_is_valid "velocity_uncertainty": valid_flags 0x1;
}

field! {
    EcefVelocityUncertainty: 0x37, "filter_data.ecef_velocity_uncertainty";
    in [0x82];
}

record! {
    /// ECEF position (0x82,0x40).
    ///
    /// Estimated position in Earth-fixed coordinates.
    ///
    /// Also called `ecef_pos`. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: ECEF Position (0x82,0x40).
    #[derive(Copy, Default)]
    pub struct EcefPosition {
        /// Position of the reference point.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub position: types::Vector3d,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    EcefPosition
    position: types::Vector3d, at 0;
    valid_flags: ValidFlags, at 24;
}

constructors! {
    EcefPosition

    /// Creates it from its values.
    fn new(position: impl Into<types::Vector3d>, valid_flags: ValidFlags);
}

valid! {
    EcefPosition
    position_is_valid "position": valid_flags 0x1;
}

field! {
    EcefPosition: 0x40, "filter_data.ecef_position";
    in [0x82];
}

record! {
    /// ECEF velocity (0x82,0x41).
    ///
    /// Estimated velocity in Earth-fixed coordinates.
    ///
    /// Also called `ecef_vel`. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: ECEF Velocity (0x82,0x41).
    #[derive(Copy, Default)]
    pub struct EcefVelocity {
        /// Velocity of the reference point.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and level: x 0, y 0, z 0. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub velocity: types::Vector3f,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    EcefVelocity
    velocity: types::Vector3f, at 0;
    valid_flags: ValidFlags, at 12;
}

constructors! {
    EcefVelocity

    /// Creates it from its values.
    fn new(velocity: impl Into<types::Vector3f>, valid_flags: ValidFlags);
}

valid! {
    EcefVelocity
    velocity_is_valid "velocity": valid_flags 0x1;
}

field! {
    EcefVelocity: 0x41, "filter_data.ecef_velocity";
    in [0x82];
}

record! {
    /// NED relative position (0x82,0x42).
    ///
    /// Estimated position relative to the point that
    /// [`filter::RelativePositionConfig`](crate::filter::RelativePositionConfig) sets.
    ///
    /// Also called `rel_pos_ned`. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: NED Relative Position (0x82,0x42).
    #[derive(Copy, Default)]
    pub struct NedRelativePosition {
        /// From the reference point to the device.
        ///
        /// Elements: north, east, down. Unit: m. Frame: ned. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        pub relative_position: types::Ned3d,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    NedRelativePosition
    relative_position: types::Ned3d, at 0;
    valid_flags: ValidFlags, at 24;
}

constructors! {
    NedRelativePosition

    /// Creates it from its values.
    fn new(relative_position: impl Into<types::Ned3d>, valid_flags: ValidFlags);
}

valid! {
    NedRelativePosition
    relative_position_is_valid "relative_position": valid_flags 0x1;
}

field! {
    NedRelativePosition: 0x42, "filter_data.ned_relative_position";
    in [0x82];
}

record! {
    /// GNSS position aiding status (0x82,0x43).
    ///
    /// Use of the position measurements of one GNSS receiver by the filter.
    ///
    /// Also called `gnss_pos_aid_status`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// - Single precision resolves the time of week to 0.0625 s at the end of the week.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Position Aiding Status (0x82,0x43).
    #[derive(Copy, Default)]
    pub struct GnssPositionAidingStatus {
        /// Number of the receiver.
        pub receiver_id: u8,
        /// GPS time of week of the last measurement.
        ///
        /// Unit: s. Range: 0 to 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f32,
        /// State of the measurements in the filter.
        pub status: GnssAidingStatus,
        /// Reserved.
        pub reserved: [u8; 8],
    }
}

view! {
    GnssPositionAidingStatus
    receiver_id: u8, at 0;
    tow: f32, at 1;
    status: GnssAidingStatus, at 5;
    reserved: [u8; 8], at 7;
}

constructors! {
    GnssPositionAidingStatus

    /// Creates it from its values.
    fn new(
        receiver_id: u8,
        tow: f32,
        status: GnssAidingStatus,
    ), reserved: [0; 8];
}

field! {
    GnssPositionAidingStatus: 0x43, "filter_data.gnss_position_aiding_status";
    in [0x82];
}

record! {
    /// GNSS attitude aiding status (0x82,0x44).
    ///
    /// State of the attitude aiding by two GNSS antennas.
    ///
    /// Also called `gnss_att_aid_status`. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// - Single precision resolves the time of week to 0.0625 s at the end of the week.
    ///
    /// Source: mip-sdk-4: Gnss Att Aid Status (0x82,0x44).
    #[derive(Copy, Default)]
    pub struct GnssAttitudeAidingStatus {
        /// GPS time of week of the last valid measurement.
        ///
        /// Unit: s. Range: 0 to 604800. Uncertain: It is not known whether this is the time of the
        /// measurement or that of its processing.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f32,
        /// State of the measurements in the filter.
        pub status: GnssAidingStatus,
        /// Reserved.
        ///
        /// Reserved.
        pub reserved: [u8; 8],
    }
}

view! {
    GnssAttitudeAidingStatus
    tow: f32, at 0;
    status: GnssAidingStatus, at 4;
    reserved: [u8; 8], at 6;
}

constructors! {
    GnssAttitudeAidingStatus

    /// Creates it from its values.
    fn new(tow: f32, status: GnssAidingStatus), reserved: [0; 8];
}

field! {
    GnssAttitudeAidingStatus: 0x44, "filter_data.gnss_attitude_aiding_status";
    in [0x82];
}

record! {
    /// Heading aiding status (0x82,0x45).
    ///
    /// The heading measurement that the filter used last.
    ///
    /// Also called `head_aid_status`. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// - Single precision resolves the time of week to 0.0625 s at the end of the week.
    ///
    /// Source: mip-sdk-4: Head Aid Status (0x82,0x45).
    #[derive(Copy, Default)]
    pub struct HeadingAidingStatus {
        /// GPS time of week of the last valid measurement.
        ///
        /// Unit: s. Range: 0 to 604800. Uncertain: It is not known whether this is the time of the
        /// measurement or that of its processing.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f32,
        /// Source of the heading.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: HeadingAidingType,
        /// Reserved.
        ///
        /// Reserved.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub reserved: [f32; 2],
    }
    wire 13 {
        [tow]
        [type_ "type"]
        [reserved]
    }
}

view! {
    HeadingAidingStatus
    tow: f32, at 0;
    type_: HeadingAidingType, at 4;
    reserved: [f32; 2], at 5;
}

constructors! {
    HeadingAidingStatus

    /// Creates it from its values.
    fn new(tow: f32, type_: HeadingAidingType), reserved: [0.0; 2];
}

field! {
    HeadingAidingStatus: 0x45, "filter_data.heading_aiding_status";
    in [0x82];
}

record! {
    /// Aiding measurement summary (0x82,0x46).
    ///
    /// Use of one kind of aiding measurement in the last measurement interval.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// - Single precision resolves the time of week to 0.0625 s at the end of the week.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Measurement Summary (0x82,0x46).
    #[derive(Copy, Default)]
    pub struct AidingMeasurementSummary {
        /// GPS time of week at the end of the interval.
        ///
        /// Unit: s. Range: 0 to 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f32,
        /// Number of the source of the measurement.
        pub source: u8,
        /// Kind of measurement.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: AidingMeasurementType,
        /// Use of the measurement by the filter.
        pub indicator: AidingMeasurementIndicator,
    }
    wire 7 {
        [tow]
        [source]
        [type_ "type"]
        [indicator]
    }
}

view! {
    AidingMeasurementSummary
    tow: f32, at 0;
    source: u8, at 4;
    type_: AidingMeasurementType, at 5;
    indicator: AidingMeasurementIndicator, at 6;
}

constructors! {
    AidingMeasurementSummary

    /// Creates it from its values.
    fn new(
        tow: f32,
        source: u8,
        type_: AidingMeasurementType,
        indicator: AidingMeasurementIndicator,
    );
}

field! {
    AidingMeasurementSummary: 0x46, "filter_data.aiding_measurement_summary";
    in [0x82];
}

record! {
    /// Odometer scale factor error (0x82,0x47).
    ///
    /// Estimated relative error of the odometer scale factor.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - Estimated scale factor = configured scale factor \* (1 + error).
    ///
    /// Source: 3dm-cv7-gnss-ins: Odometer Scale Factor Error (0x82,0x47).
    #[derive(Copy, Default)]
    pub struct OdometerScaleFactorError {
        /// Relative error.
        ///
        /// Unit: 1. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub scale_factor_error: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    OdometerScaleFactorError
    scale_factor_error: f32, at 0;
    valid_flags: ValidFlags, at 4;
}

constructors! {
    OdometerScaleFactorError

    /// Creates it from its values.
    fn new(scale_factor_error: f32, valid_flags: ValidFlags);
}

valid! {
    OdometerScaleFactorError
    scale_factor_error_is_valid "scale_factor_error": valid_flags 0x1;
}

field! {
    OdometerScaleFactorError: 0x47, "filter_data.odometer_scale_factor_error";
    in [0x82];
}

record! {
    /// Odometer scale factor error uncertainty (0x82,0x48).
    ///
    /// Uncertainty of the estimated error of the odometer scale factor.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Odometer Scale Factor Error Uncertainty (0x82,0x48).
    #[derive(Copy, Default)]
    pub struct OdometerScaleFactorErrorUncertainty {
        /// Uncertainty of the relative error.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub scale_factor_error_uncertainty: f32,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    OdometerScaleFactorErrorUncertainty
    scale_factor_error_uncertainty: f32, at 0;
    valid_flags: ValidFlags, at 4;
}

constructors! {
    OdometerScaleFactorErrorUncertainty

    /// Creates it from its values.
    fn new(scale_factor_error_uncertainty: f32, valid_flags: ValidFlags);
}

valid! {
    OdometerScaleFactorErrorUncertainty
    scale_factor_error_uncertainty_is_valid "scale_factor_error_uncertainty": valid_flags 0x1;
}

field! {
    OdometerScaleFactorErrorUncertainty: 0x48, "filter_data.odometer_scale_factor_error_uncertainty";
    in [0x82];
}

record! {
    /// GNSS dual antenna status (0x82,0x49).
    ///
    /// Heading from two GNSS antennas.
    ///
    /// Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7). Requires 2 antennas.
    ///
    /// - It is a measurement that aids the filter. The heading of [`EulerAngles`] is the estimate
    ///   of the filter from all measurements.
    /// - Single precision resolves the time of week to 0.0625 s at the end of the week.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Dual Antenna Status (0x82,0x49).
    #[derive(Copy, Default)]
    pub struct GnssDualAntennaStatus {
        /// GPS time of week of the last measurement.
        ///
        /// Unit: s. Range: 0 to 604800. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f32,
        /// Heading derived from the baseline of the antennas.
        ///
        /// Unit: rad. Frame: ned. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Standard deviation of the heading.
        ///
        /// Unit: rad. Range: at least 0. Valid if [`valid_flags.valid`](ValidFlags::valid) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading_uncertainty: f32,
        /// Kind of solution.
        pub fix_type: DualAntennaFixType,
        /// Inputs available to the solution.
        pub status_flags: DualAntennaStatusFlags,
        /// Validity of the values of a field.
        pub valid_flags: ValidFlags,
    }
}

view! {
    GnssDualAntennaStatus
    tow: f32, at 0;
    heading: f32, at 4;
    heading_uncertainty: f32, at 8;
    fix_type: DualAntennaFixType, at 12;
    status_flags: DualAntennaStatusFlags, at 13;
    valid_flags: ValidFlags, at 15;
}

constructors! {
    GnssDualAntennaStatus

    /// Creates it from its values.
    fn new(
        tow: f32,
        heading: f32,
        heading_uncertainty: f32,
        fix_type: DualAntennaFixType,
        status_flags: DualAntennaStatusFlags,
        valid_flags: ValidFlags,
    );
}

valid! {
    GnssDualAntennaStatus
    tow_is_valid "tow": valid_flags 0x1;
    heading_is_valid "heading": valid_flags 0x1;
    heading_uncertainty_is_valid "heading_uncertainty": valid_flags 0x1;
}

field! {
    GnssDualAntennaStatus: 0x49, "filter_data.gnss_dual_antenna_status";
    in [0x82];
}

record! {
    /// Aiding frame configuration error (0x82,0x50).
    ///
    /// Estimated error of a frame that [`aiding::FrameConfig`](crate::aiding::FrameConfig) defines.
    /// The filter corrects for it.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 2 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Frame Configuration Error (0x82,0x50).
    #[derive(Copy, Default)]
    pub struct AidingFrameConfigError {
        /// Number of the frame.
        pub frame_id: u8,
        /// Estimated error of the translation.
        ///
        /// Elements: x, y, z. Unit: m.
        pub translation: types::Vector3f,
        /// Estimated error of the rotation.
        ///
        /// Elements: w, x, y, z. Unit: 1.
        pub attitude: types::Quatf,
    }
}

view! {
    AidingFrameConfigError
    frame_id: u8, at 0;
    translation: types::Vector3f, at 1;
    attitude: types::Quatf, at 13;
}

constructors! {
    AidingFrameConfigError

    /// Creates it from its values.
    fn new(
        frame_id: u8,
        translation: impl Into<types::Vector3f>,
        attitude: impl Into<types::Quatf>,
    );
}

field! {
    AidingFrameConfigError: 0x50, "filter_data.aiding_frame_config_error";
    in [0x82];
}

record! {
    /// Aiding frame configuration error uncertainty (0x82,0x51).
    ///
    /// Uncertainty of the error in [`AidingFrameConfigError`].
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Frame Configuration Error Uncertainty (0x82,0x51).
    #[derive(Copy, Default)]
    pub struct AidingFrameConfigErrorUncertainty {
        /// Number of the frame.
        pub frame_id: u8,
        /// Standard deviation of the error of the translation.
        ///
        /// Elements: x, y, z. Unit: m. Range: at least 0.
        pub translation_uncertainty: types::Vector3f,
        /// Uncertainty of the rotation about each axis.
        ///
        /// Elements: x, y, z. Unit: rad. Range: at least 0.
        pub attitude_uncertainty: types::Vector3f,
    }
}

view! {
    AidingFrameConfigErrorUncertainty
    frame_id: u8, at 0;
    translation_uncertainty: types::Vector3f, at 1;
    attitude_uncertainty: types::Vector3f, at 13;
}

constructors! {
    AidingFrameConfigErrorUncertainty

    /// Creates it from its values.
    fn new(
        frame_id: u8,
        translation_uncertainty: impl Into<types::Vector3f>,
        attitude_uncertainty: impl Into<types::Vector3f>,
    );
}

field! {
    AidingFrameConfigErrorUncertainty: 0x51, "filter_data.aiding_frame_config_error_uncertainty";
    in [0x82];
}
