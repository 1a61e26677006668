/**
 * @file
 *
 * Filter data (0x82). Estimates of the navigation filter and its status.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_FILTER_DATA_H
#define MIP_FILTER_DATA_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/filter_data.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_filter_data Filter data (0x82)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_FILTER_DATA_SET 0x82

/** Validity of the values of a field. */
typedef uint16_t mip_filter_data_valid_flags;
/** Bit 0. All values of the field are valid. */
#define MIP_FILTER_DATA_VALID_FLAGS_VALID 0x0001U

/**
 * Sources of heading updates; 0 if heading updates are disabled.
 *
 * - 3dm-gx5-15: 5.2.16 Heading Update Source State (0x82, 0x14)
 * - 3dm-gx5-45: 5.3.27 Heading Update Source State (0x82, 0x14)
 */
typedef uint16_t mip_filter_data_heading_source_flags;
/** Bit 0. The magnetometer. Requires a magnetometer. */
#define MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_MAG 0x0001U
/** Bit 1. The velocity that the GNSS receiver measures. Requires a receiver. */
#define MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_GNSS_VELOCITY 0x0002U
/** Bit 2. Heading messages that your program sends. */
#define MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_EXTERNAL 0x0004U

/** Use of one GNSS receiver by the filter. */
typedef uint16_t mip_filter_data_gnss_aiding_status;
/** Bit 0. The receiver's raw ranges are used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_TIGHT_COUPLING 0x0001U
/** Bit 1. RTK corrections are used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_DIFFERENTIAL 0x0002U
/** Bit 2. The receiver has an RTK integer fix, the most accurate kind. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_INTEGER_FIX 0x0004U
/** Bit 3. GPS L1 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GPS_L1 0x0008U
/** Bit 4. GPS L2 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GPS_L2 0x0010U
/** Bit 5. GPS L5 is used; not on every model. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GPS_L5 0x0020U
/** Bit 6. GLONASS L1 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GLONASS_L1 0x0040U
/** Bit 7. GLONASS L2 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GLONASS_L2 0x0080U
/** Bit 8. Galileo E1 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GALILEO_E1 0x0100U
/** Bit 9. Galileo E5 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GALILEO_E5 0x0200U
/** Bit 10. Galileo E6 is used. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_GALILEO_E6 0x0400U
/** Bit 11. BeiDou B1 is used; not on every model. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_BEIDOU_B1 0x0800U
/** Bit 12. BeiDou B2 is used; not on every model. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_BEIDOU_B2 0x1000U
/** Bit 13. BeiDou B3 is used; not on every model. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_BEIDOU_B3 0x2000U
/** Bit 14. The receiver has no position fix. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_NO_FIX 0x4000U
/** Bit 15. The antenna offset of the receiver is probably wrong. */
#define MIP_FILTER_DATA_GNSS_AIDING_STATUS_CONFIG_ERROR 0x8000U

/**
 * Source of a heading measurement.
 *
 * - mip-sdk-4: Head Aid Status (0x82,0x45)
 */
enum mip_filter_data_heading_aiding_type MIP_ENUM_8 {
    /** Two GNSS antennas. */
    MIP_FILTER_DATA_HEADING_AIDING_TYPE_DUAL_ANTENNA = 1,
    /** A heading message from your program. */
    MIP_FILTER_DATA_HEADING_AIDING_TYPE_EXTERNAL_MESSAGE = 2
};

/**
 * Kind of aiding measurement. Values from 0x20 are the descriptors of the commands of set `aiding`
 * that send the measurement.
 */
enum mip_filter_data_aiding_measurement_type MIP_ENUM_8 {
    /** GNSS position and velocity. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_GNSS = 1,
    /** GNSS heading from two antennas. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_DUAL_ANTENNA = 2,
    /** The value `heading`. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_HEADING = 3,
    /** Pressure altitude. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_PRESSURE = 4,
    /** The value `mag`. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_MAG = 5,
    /** Speed or odometer. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_SPEED = 6,
    /** ECEF position, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_ECEF_POSITION = 33,
    /** Latitude, longitude and height, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_LLH_POSITION = 34,
    /** Height above the ellipsoid, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_HEIGHT_ABOVE_ELLIPSOID = 35,
    /** ECEF velocity, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_ECEF_VELOCITY = 40,
    /** NED velocity, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_NED_VELOCITY = 41,
    /** Body frame velocity, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_BODY_FRAME_VELOCITY = 42,
    /** True heading, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_TRUE_HEADING = 49,
    /** Magnetic field, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_MAGNETIC_FIELD = 50,
    /** Pressure, sent by command. */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_TYPE_AIDING_PRESSURE = 51
};

/** Use of an aiding measurement by the filter. */
typedef uint8_t mip_filter_data_aiding_measurement_indicator;
/** Bit 0. The measurement is enabled. */
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_ENABLED 0x01U
/** Bit 1. The filter used the measurement. */
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_USED 0x02U
/** Bit 2. The measurement disagrees with the estimate. */
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_RESIDUAL_HIGH_WARNING 0x04U
/** Bit 3. The time of the measurement is doubtful. */
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_SAMPLE_TIME_WARNING 0x08U
/** Bit 4. The measurement is configured incorrectly. */
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_CONFIG_ERROR 0x10U
/** Bit 5. There are more measurements than the filter can process. */
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_INDICATOR_MAX_MEASUREMENTS_EXCEEDED 0x20U

/** Kind of dual-antenna heading solution. */
enum mip_filter_data_dual_antenna_fix_type MIP_ENUM_8 {
    /** No solution. */
    MIP_FILTER_DATA_DUAL_ANTENNA_FIX_TYPE_FIX_NONE = 0,
    /** Solution with float ambiguities. */
    MIP_FILTER_DATA_DUAL_ANTENNA_FIX_TYPE_FIX_DA_FLOAT = 1,
    /** Solution with fixed ambiguities. */
    MIP_FILTER_DATA_DUAL_ANTENNA_FIX_TYPE_FIX_DA_FIXED = 2
};

/** Inputs available to the dual-antenna heading solution. */
typedef uint16_t mip_filter_data_dual_antenna_status_flags;
/** Bit 0. Data of receiver 1 is valid. */
#define MIP_FILTER_DATA_DUAL_ANTENNA_STATUS_FLAGS_RECEIVER_1_DATA_VALID 0x0001U
/** Bit 1. Data of receiver 2 is valid. */
#define MIP_FILTER_DATA_DUAL_ANTENNA_STATUS_FLAGS_RECEIVER_2_DATA_VALID 0x0002U
/** Bit 2. The antenna offsets are valid. */
#define MIP_FILTER_DATA_DUAL_ANTENNA_STATUS_FLAGS_ANTENNA_OFFSETS_VALID 0x0004U

/**
 * State of the filter of a 5-series device.
 *
 * - 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10)
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
enum mip_filter_data_gx5_filter_state MIP_ENUM_16 {
    /** The device is starting. */
    MIP_FILTER_DATA_GX5_FILTER_STATE_STARTUP = 0,
    /** Initialization; the status flags show what is missing. */
    MIP_FILTER_DATA_GX5_FILTER_STATE_INIT = 1,
    /** Running with a valid solution. */
    MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID = 2,
    /** Running with an error; the status flags show which. */
    MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR = 3
};

/**
 * Mode of the filter of a 3DM-CV7.
 *
 * - 3dm-cv7-gnss-ins: Filter States
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
enum mip_filter_data_cv7_filter_state MIP_ENUM_16 {
    /** Initialization; initial conditions are missing or the filter waits for a command. */
    MIP_FILTER_DATA_CV7_FILTER_STATE_INIT = 1,
    /** Vertical gyro: pitch and roll, and heading relative to the initial one. */
    MIP_FILTER_DATA_CV7_FILTER_STATE_VERTICAL_GYRO = 2,
    /** Pitch, roll and absolute heading. */
    MIP_FILTER_DATA_CV7_FILTER_STATE_AHRS = 3,
    /** Full navigation: position, velocity and attitude. */
    MIP_FILTER_DATA_CV7_FILTER_STATE_FULL_NAV = 4
};

/** Motion for which the filter of a 5-series device is configured. */
enum mip_filter_data_gx5_dynamics_mode MIP_ENUM_16 {
    /** Carried by hand. */
    MIP_FILTER_DATA_GX5_DYNAMICS_MODE_PORTABLE = 1,
    /** Ground vehicle. */
    MIP_FILTER_DATA_GX5_DYNAMICS_MODE_AUTOMOTIVE = 2,
    /** Aircraft. */
    MIP_FILTER_DATA_GX5_DYNAMICS_MODE_AIRBORNE = 3,
    /**
     * Aircraft with high acceleration. Uncertain: The manual of the 3DM-GX5-15 lists 1 to 3;
     * mip_filter_vehicle_dynamics_mode sets 4, too.
     */
    MIP_FILTER_DATA_GX5_DYNAMICS_MODE_AIRBORNE_HIGH_G = 4
};

/** Dynamics mode of a 7-series device; there is only one. */
enum mip_filter_data_cv7_dynamics_mode MIP_ENUM_16 {
    /** The only mode. */
    MIP_FILTER_DATA_CV7_DYNAMICS_MODE_DEFAULT = 1
};

/**
 * Problems of the filter of a 5-series device; their meaning depends on the state of the filter.
 *
 * - 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10)
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
typedef uint16_t mip_filter_data_gx5_status_flags;
/**
 * Bit 0. No inertial data. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_sensor_scaled_accel and
 * mip_sensor_scaled_gyro.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_IMU_UNAVAILABLE 0x0001U
/**
 * Bit 1. No GNSS data; only on models with GNSS. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_llh_position and
 * mip_filter_data_ned_velocity.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_GPS_UNAVAILABLE 0x0002U
/**
 * Bit 3. A matrix in the computation is singular. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_reset.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MATRIX_SINGULARITY 0x0008U
/**
 * Bit 4. A position covariance is above its normal limit. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_llh_position and
 * mip_filter_data_llh_position_uncertainty.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_POSITION_COVARIANCE_WARNING 0x0010U
/**
 * Bit 5. A velocity covariance is above its normal limit. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_ned_velocity and
 * mip_filter_data_ned_velocity_uncertainty.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_VELOCITY_COVARIANCE_WARNING 0x0020U
/**
 * Bit 6. An attitude covariance is above its normal limit. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_euler_angles and
 * mip_filter_data_euler_angles_uncertainty.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ATTITUDE_COVARIANCE_WARNING 0x0040U
/**
 * Bit 7. The solution contains NaN values. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_reset.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_NAN_IN_SOLUTION_WARNING 0x0080U
/**
 * Bit 8. The estimated gyroscope bias is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_gyro_bias.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_GYRO_BIAS_EST_HIGH_WARNING 0x0100U
/**
 * Bit 9. The estimated accelerometer bias is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_accel_bias.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ACCEL_BIAS_EST_HIGH_WARNING 0x0200U
/**
 * Bit 10. The estimated gyroscope scale factor is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_gyro_scale_factor.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_GYRO_SCALE_FACTOR_EST_HIGH_WARNING 0x0400U
/**
 * Bit 11. The estimated accelerometer scale factor is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_accel_scale_factor.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ACCEL_SCALE_FACTOR_EST_HIGH_WARNING 0x0800U
/**
 * Bit 12. The estimated magnetometer bias is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_mag_bias.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MAG_BIAS_EST_HIGH_WARNING 0x1000U
/**
 * Bit 13. The estimated correction of the antenna offset is high; on models with GNSS. Only while
 * `filter_state` is MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects
 * mip_filter_data_antenna_offset_correction and mip_filter_antenna_offset.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_ANTENNA_OFFSET_CORRECTION_EST_HIGH_WARNING 0x2000U
/**
 * Bit 14. The estimated hard-iron offset is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_mag_offset.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MAG_HARD_IRON_EST_HIGH_WARNING 0x4000U
/**
 * Bit 15. The estimated soft-iron correction is high. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_VALID or
 * MIP_FILTER_DATA_GX5_FILTER_STATE_RUN_SOLUTION_ERROR. Affects mip_filter_data_mag_matrix.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_RUN_MAG_SOFT_IRON_EST_HIGH_WARNING 0x8000U
/**
 * Bit 12. The attitude is not initialized. Overlaps other bits. Only while `filter_state` is
 * MIP_FILTER_DATA_GX5_FILTER_STATE_INIT. Affects mip_filter_data_attitude_quaternion,
 * mip_filter_data_attitude_dcm and mip_filter_data_euler_angles.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_INIT_NO_ATTITUDE 0x1000U
/**
 * Bit 13. Position and velocity are not initialized. Overlaps other bits. Only while `filter_state`
 * is MIP_FILTER_DATA_GX5_FILTER_STATE_INIT. Affects mip_filter_data_llh_position and
 * mip_filter_data_ned_velocity.
 */
#define MIP_FILTER_DATA_GX5_STATUS_FLAGS_INIT_NO_POSITION_VELOCITY 0x2000U

/**
 * Convergence of the filter's estimates.
 *
 * - 3dm-cv7-gnss-ins: Filter condition (bits 0-1)
 * - 3dm-cv7-gnss-ins: How do I interpret the Status (0x82,0x10) message?
 */
enum mip_filter_data_filter_condition MIP_ENUM_8 {
    /** Estimates have settled and agree with the aiding measurements. */
    MIP_FILTER_DATA_FILTER_CONDITION_STABLE = 1,
    /** Estimates have not settled yet. */
    MIP_FILTER_DATA_FILTER_CONDITION_CONVERGING = 2,
    /** Estimates are unstable or recovering. */
    MIP_FILTER_DATA_FILTER_CONDITION_UNSTABLE = 3
};

/**
 * Condition and warnings of the filter of a 3DM-CV7.
 *
 * - 3dm-cv7-gnss-ins: Filter Status Flags
 * - 3dm-cv7-gnss-ins: How do I interpret the Status (0x82,0x10) message?
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 */
typedef uint16_t mip_filter_data_cv7_status_flags;
/** Bits 0 to 1. Convergence of the estimates. A value of enum mip_filter_data_filter_condition. */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_FILTER_CONDITION 0x0003U
/**
 * Bit 2. Roll and pitch are doubtful; check the mounting transformation. Affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_ROLL_PITCH_WARNING 0x0004U
/**
 * Bit 3. The heading is doubtful; check the heading source. Affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_HEADING_WARNING 0x0008U
/**
 * Bit 4. The position is doubtful; check the GNSS reception and antennas. Affects
 * mip_filter_data_llh_position, mip_filter_data_ecef_position and
 * mip_filter_data_ned_relative_position.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_POSITION_WARNING 0x0010U
/**
 * Bit 5. The velocity is doubtful; check the GNSS reception and antennas. Affects
 * mip_filter_data_ned_velocity and mip_filter_data_ecef_velocity.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_VELOCITY_WARNING 0x0020U
/**
 * Bit 6. The sensor biases are doubtful; capture the gyroscope bias. Affects
 * mip_filter_data_accel_bias, mip_filter_data_gyro_bias and mip_3dm_capture_gyro_bias.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_IMU_BIAS_WARNING 0x0040U
/**
 * Bit 7. The GNSS clock is doubtful; navigation continues. Affects mip_filter_data_timestamp and
 * mip_filter_data_clock_correction.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_GNSS_CLOCK_WARNING 0x0080U
/**
 * Bit 8. The antenna offsets are probably wrong. Affects
 * mip_filter_data_multi_antenna_offset_correction and mip_filter_multi_antenna_offset.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_ANTENNA_LEVER_ARM_WARNING 0x0100U
/**
 * Bit 9. The mounting transformation is probably wrong. Affects
 * mip_3dm_sensor_to_vehicle_transform_euler and mip_3dm_sensor_to_vehicle_transform_dcm.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_MOUNTING_TRANSFORM_WARNING 0x0200U
/**
 * Bit 10. No pulse per second is detected, or the time of an external heading is too old. Affects
 * mip_3dm_pps_source_control.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_TIME_SYNC_WARNING 0x0400U
/**
 * Bits 12 to 15. Not 0 if the solution contains NaN values; reset the filter. Affects
 * mip_filter_reset.
 */
#define MIP_FILTER_DATA_CV7_STATUS_FLAGS_SOLUTION_ERROR 0xF000U

/** Bits 0 to 1. Convergence of the estimates. A value of enum mip_filter_data_filter_condition. */
static inline uint8_t
mip_filter_data_cv7_status_flags_get_filter_condition(mip_filter_data_cv7_status_flags flags) {
    const uint32_t bits = flags & MIP_FILTER_DATA_CV7_STATUS_FLAGS_FILTER_CONDITION;
    return (uint8_t)bits;
}

/** Sets it. */
static inline void mip_filter_data_cv7_status_flags_set_filter_condition(
    mip_filter_data_cv7_status_flags *flags, uint8_t value) {
    const uint32_t mask = MIP_FILTER_DATA_CV7_STATUS_FLAGS_FILTER_CONDITION;
    const uint32_t bits = value;
    *flags = (mip_filter_data_cv7_status_flags)((*flags & ~mask) | (bits & mask));
}

/**
 * Bits 12 to 15. Not 0 if the solution contains NaN values; reset the filter. Affects
 * mip_filter_reset.
 */
static inline uint8_t
mip_filter_data_cv7_status_flags_get_solution_error(mip_filter_data_cv7_status_flags flags) {
    const uint32_t bits = flags & MIP_FILTER_DATA_CV7_STATUS_FLAGS_SOLUTION_ERROR;
    return (uint8_t)(bits >> 12);
}

/** Sets it. */
static inline void mip_filter_data_cv7_status_flags_set_solution_error(
    mip_filter_data_cv7_status_flags *flags, uint8_t value) {
    const uint32_t mask = MIP_FILTER_DATA_CV7_STATUS_FLAGS_SOLUTION_ERROR;
    const uint32_t bits = (uint32_t)value << 12;
    *flags = (mip_filter_data_cv7_status_flags)((*flags & ~mask) | (bits & mask));
}

/**
 * LLH position: data (0x82,0x01).
 *
 * Estimated position as latitude, longitude and height.
 *
 * Also called `position_llh`.
 *
 * - 3dm-cv7-gnss-ins: LLH Position (0x82,0x01)
 */
struct mip_filter_data_llh_position {
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    double latitude;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    double longitude;
    /**
     * Height above the ellipsoid. Unit: m. Frame: llh. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID
     * in valid_flags is set.
     */
    double ellipsoid_height;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_LLH_POSITION 0x8201
#define MIP_FILTER_DATA_LLH_POSITION_DESCRIPTOR 0x01
MIP_FIELD(mip_filter_data_llh_position, 0x01);

/**
 * NED velocity: data (0x82,0x02).
 *
 * Estimated velocity in the NED frame.
 *
 * Also called `velocity_ned`.
 *
 * - 3dm-cv7-gnss-ins: Velocity NED (0x82,0x02)
 */
struct mip_filter_data_ned_velocity {
    /**
     * Velocity north. Unit: m/s. Frame: ned. At rest and level: 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float north;
    /**
     * Velocity east. Unit: m/s. Frame: ned. At rest and level: 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float east;
    /**
     * Velocity down. Unit: m/s. Frame: ned. At rest and level: 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float down;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_NED_VELOCITY 0x8202
#define MIP_FILTER_DATA_NED_VELOCITY_DESCRIPTOR 0x02
MIP_FIELD(mip_filter_data_ned_velocity, 0x02);

/**
 * Attitude quaternion: data (0x82,0x03).
 *
 * Estimated orientation of the vehicle frame in the NED frame as a quaternion.
 *
 * `v_ned = q * v_vehicle * q^-1`
 *
 * The 3DM-GX5-15 manual documents the inverse rotation, which is taken for a misprint.
 *
 * - 3dm-cv7-gnss-ins: Attitude Quaternion (0x82,0x03)
 * - 3dm-gx5-15: 5.2.3 Orientation, Quaternion (0x82, 0x03)
 */
struct mip_filter_data_attitude_quaternion {
    /**
     * Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first.
     * Elements: w, x, y, z. Unit: 1. Frame: ned. At rest and level: x 0, y 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float q[4];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ATTITUDE_QUATERNION 0x8203
#define MIP_FILTER_DATA_ATTITUDE_QUATERNION_DESCRIPTOR 0x03
MIP_FIELD(mip_filter_data_attitude_quaternion, 0x03);

/**
 * Attitude direction cosine matrix: data (0x82,0x04).
 *
 * Estimated orientation of the vehicle frame in the NED frame as a rotation matrix.
 *
 * `v_vehicle = dcm * v_ned`
 *
 * - 3dm-cv7-gnss-ins: Attitude DCM (0x82,0x04)
 * - 3dm-gx5-15: 5.2.7 Orientation, Matrix (0x82, 0x04)
 */
struct mip_filter_data_attitude_dcm {
    /**
     * Rotates vectors of the NED frame into the vehicle frame; row-major. Elements: m11, m12, m13,
     * m21, m22, m23, m31, m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0,
     * m32 0, m33 1. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float dcm[9];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ATTITUDE_DCM 0x8204
#define MIP_FILTER_DATA_ATTITUDE_DCM_DESCRIPTOR 0x04
MIP_FIELD(mip_filter_data_attitude_dcm, 0x04);

/**
 * Euler angles: data (0x82,0x05).
 *
 * Estimated orientation of the vehicle frame in the NED frame as Euler angles.
 *
 * Uncertain: The ranges of the angles are inferred; no source states them.
 *
 * - 3dm-cv7-gnss-ins: Euler Angles (0x82,0x05)
 * - 3dm-gx5-15: 5.2.5 Orientation, Euler Angles (0x82, 0x05)
 */
struct mip_filter_data_euler_angles {
    /**
     * Rotation about the x axis of the vehicle, after yaw and pitch (order 3-2-1). Unit: rad.
     * Frame: ned. Range: -pi to pi. At rest and level: 0. Positive: right side down. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float roll;
    /**
     * Rotation about the y axis. Unit: rad. Frame: ned. Range: -1.5707963267948966 to
     * 1.5707963267948966. At rest and level: 0. Positive: nose up. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float pitch;
    /**
     * Rotation about the z axis: the heading. Unit: rad. Frame: ned. Range: -pi to pi. Positive:
     * clockwise seen from above. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float yaw;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_EULER_ANGLES 0x8205
#define MIP_FILTER_DATA_EULER_ANGLES_DESCRIPTOR 0x05
MIP_FIELD(mip_filter_data_euler_angles, 0x05);

/**
 * Gyroscope bias: data (0x82,0x06).
 *
 * Estimated bias of the gyroscope.
 *
 * - 3dm-cv7-gnss-ins: Gyro Bias (0x82,0x06)
 * - 3dm-gx5-15: 5.2.9 Gyro Bias (0x82, 0x06)
 */
struct mip_filter_data_gyro_bias {
    /**
     * Bias that the filter subtracts. Elements: x, y, z. Unit: rad/s. Frame: sensor. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_GYRO_BIAS 0x8206
#define MIP_FILTER_DATA_GYRO_BIAS_DESCRIPTOR 0x06
MIP_FIELD(mip_filter_data_gyro_bias, 0x06);

/**
 * Accelerometer bias: data (0x82,0x07).
 *
 * Estimated bias of the accelerometer.
 *
 * - 3dm-cv7-gnss-ins: Accel Bias (0x82,0x07)
 */
struct mip_filter_data_accel_bias {
    /**
     * Bias that the filter subtracts. Elements: x, y, z. Unit: m/s^2. Frame: sensor. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ACCEL_BIAS 0x8207
#define MIP_FILTER_DATA_ACCEL_BIAS_DESCRIPTOR 0x07
MIP_FIELD(mip_filter_data_accel_bias, 0x07);

/**
 * Position uncertainty: data (0x82,0x08).
 *
 * Standard deviation of the estimated position, in the NED frame.
 *
 * Also called `position_llh_uncertainty`.
 *
 * - 3dm-cv7-gnss-ins: LLH Position Uncertainty (0x82,0x08)
 */
struct mip_filter_data_llh_position_uncertainty {
    /**
     * North standard deviation. Unit: m. Frame: ned. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float north;
    /**
     * East standard deviation. Unit: m. Frame: ned. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float east;
    /**
     * Down standard deviation. Unit: m. Frame: ned. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float down;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_LLH_POSITION_UNCERTAINTY 0x8208
#define MIP_FILTER_DATA_LLH_POSITION_UNCERTAINTY_DESCRIPTOR 0x08
MIP_FIELD(mip_filter_data_llh_position_uncertainty, 0x08);

/**
 * NED velocity uncertainty: data (0x82,0x09).
 *
 * Standard deviation of the estimated velocity in the NED frame.
 *
 * Also called `velocity_ned_uncertainty`.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity Uncertainty (0x82,0x09)
 */
struct mip_filter_data_ned_velocity_uncertainty {
    /**
     * North standard deviation. Unit: m/s. Frame: ned. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float north;
    /**
     * East standard deviation. Unit: m/s. Frame: ned. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float east;
    /**
     * Down standard deviation. Unit: m/s. Frame: ned. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float down;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_NED_VELOCITY_UNCERTAINTY 0x8209
#define MIP_FILTER_DATA_NED_VELOCITY_UNCERTAINTY_DESCRIPTOR 0x09
MIP_FIELD(mip_filter_data_ned_velocity_uncertainty, 0x09);

/**
 * Euler angles uncertainty: data (0x82,0x0A).
 *
 * Standard deviation of the estimated Euler angles.
 *
 * 3DM-GX5: derived from the quaternion, less accurate at steep pitch, and not valid beyond 70
 * degrees of pitch up or down.
 *
 * - 3dm-cv7-gnss-ins: Euler Angles Uncertainty (0x82,0x0A)
 * - 3dm-gx5-15: 5.2.6 Attitude Uncertainty, Euler Angles (0x82, 0x0A)
 */
struct mip_filter_data_euler_angles_uncertainty {
    /**
     * Standard deviation of roll. Unit: rad. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float roll;
    /**
     * Standard deviation of pitch. Unit: rad. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float pitch;
    /**
     * Standard deviation of yaw. Unit: rad. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float yaw;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_EULER_ANGLES_UNCERTAINTY 0x820A
#define MIP_FILTER_DATA_EULER_ANGLES_UNCERTAINTY_DESCRIPTOR 0x0A
MIP_FIELD(mip_filter_data_euler_angles_uncertainty, 0x0A);

/**
 * Gyroscope bias uncertainty: data (0x82,0x0B).
 *
 * Standard deviation of the estimated gyroscope bias.
 *
 * - 3dm-cv7-gnss-ins: Gyro Bias Uncertainty (0x82,0x0B)
 * - 3dm-gx5-15: 5.2.10 Gyro Bias Uncertainty (0x82, 0x0B)
 */
struct mip_filter_data_gyro_bias_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Frame: sensor. Range: at least
     * 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_GYRO_BIAS_UNCERTAINTY 0x820B
#define MIP_FILTER_DATA_GYRO_BIAS_UNCERTAINTY_DESCRIPTOR 0x0B
MIP_FIELD(mip_filter_data_gyro_bias_uncertainty, 0x0B);

/**
 * Accelerometer bias uncertainty: data (0x82,0x0C).
 *
 * Standard deviation of the estimated accelerometer bias.
 *
 * - 3dm-cv7-gnss-ins: Accel Bias Uncertainty (0x82,0x0C)
 */
struct mip_filter_data_accel_bias_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Frame: sensor. Range: at least
     * 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ACCEL_BIAS_UNCERTAINTY 0x820C
#define MIP_FILTER_DATA_ACCEL_BIAS_UNCERTAINTY_DESCRIPTOR 0x0C
MIP_FIELD(mip_filter_data_accel_bias_uncertainty, 0x0C);

/**
 * Linear acceleration: data (0x82,0x0D).
 *
 * Rate of change of the velocity, with the effect of gravity removed.
 *
 * - 3dm-cv7-gnss-ins: Linear Accel (0x82,0x0D)
 * - 3dm-gx5-15: 5.2.12 Linear Acceleration (0x82, 0x0D)
 */
struct mip_filter_data_linear_accel {
    /**
     * Linear acceleration; zero while the velocity is constant. Elements: x, y, z. Unit: m/s^2.
     * Frame: vehicle. At rest and level: x 0, y 0, z 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID
     * in valid_flags is set.
     */
    float accel[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_LINEAR_ACCEL 0x820D
#define MIP_FILTER_DATA_LINEAR_ACCEL_DESCRIPTOR 0x0D
MIP_FIELD(mip_filter_data_linear_accel, 0x0D);

/**
 * Compensated angular rate: data (0x82,0x0E).
 *
 * Angular rate with the estimated bias removed.
 *
 * - 3dm-cv7-gnss-ins: Comp Angular Rate (0x82,0x0E)
 * - 3dm-gx5-15: 5.2.8 Compensated Angular Rate (0x82, 0x0E)
 */
struct mip_filter_data_comp_angular_rate {
    /**
     * Angular rate. Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and level: x 0, y 0, z
     * 0. Positive: right side down, nose up, clockwise seen from above. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float gyro[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_COMP_ANGULAR_RATE 0x820E
#define MIP_FILTER_DATA_COMP_ANGULAR_RATE_DESCRIPTOR 0x0E
MIP_FIELD(mip_filter_data_comp_angular_rate, 0x0E);

/**
 * WGS84 local gravity magnitude: data (0x82,0x0F).
 *
 * Magnitude of gravity at the position of the device according to the WGS84 model.
 *
 * Also called `wgs84_gravity_mag`.
 *
 * The model is valid up to an altitude of 20 km.
 *
 * - 3dm-gx5-15: 5.2.15 WGS84 Local Gravity Magnitude (0x82, 0x0F)
 */
struct mip_filter_data_wgs84_gravity_magnitude {
    /**
     * Gravity at this position according to the model. Unit: m/s^2. Range: at least 0. At rest and
     * level: 9.8. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float gravity_magnitude;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_WGS84_GRAVITY_MAGNITUDE 0x820F
#define MIP_FILTER_DATA_WGS84_GRAVITY_MAGNITUDE_DESCRIPTOR 0x0F
MIP_FIELD(mip_filter_data_wgs84_gravity_magnitude, 0x0F);

/**
 * Filter status: data (0x82,0x10).
 *
 * State, dynamics mode, condition and warnings of the filter.
 *
 * 7-series: state 1 is initialization, 2 vertical gyro, 3 AHRS, 4 full navigation. On the 3DM-CV7,
 * normal operation is state 4, mode 1, flags 1 (stable).
 *
 * 5-series and older: state 0 is start-up, 1 initialization, 2 a valid solution, 3 a solution with
 * an error. Bits 12 and 13 of the flags have other meanings in state 1 than in states 2 and 3.
 *
 * - 3dm-cv7-gnss-ins: Status (0x82,0x10)
 * - 3dm-gx5-15: 5.2.1 Filter Status (0x82, 0x10)
 */
struct mip_filter_data_status {
    /**
     * Progress of the filter from start-up to its full solution. On the 3DM-CV5-10, 3DM-CV5-15,
     * 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15,
     * 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25,
     * 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of enum
     * mip_filter_data_gx5_filter_state (inferred: the 3DM-GX5-15 has them, and the SDK lists the
     * same states for all generations up to the fifth). On the 3DM-CV7-AHRS, 3DM-CV7-AR,
     * 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS,
     * 3DM-GV7-AR and 3DM-GV7-INS: values of enum mip_filter_data_cv7_filter_state (inferred: the
     * 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation). On the
     * 3DM-CV7-GNSS/INS: values of enum mip_filter_data_cv7_filter_state. On the 3DM-GX5-15: values
     * of enum mip_filter_data_gx5_filter_state.
     */
    uint16_t filter_state;
    /**
     * Motion for which the filter is configured. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25,
     * 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-35,
     * 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45,
     * 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of enum
     * mip_filter_data_gx5_dynamics_mode (inferred: the 3DM-GX5-15 has them, and the SDK lists the
     * same states for all generations up to the fifth). On the 3DM-CV7-AHRS, 3DM-CV7-AR,
     * 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS,
     * 3DM-GV7-AR and 3DM-GV7-INS: values of enum mip_filter_data_cv7_dynamics_mode (inferred: the
     * 3DM-CV7-GNSS/INS has them, and the SDK lists the same states for its generation). On the
     * 3DM-CV7-GNSS/INS: values of enum mip_filter_data_cv7_dynamics_mode. On the 3DM-GX5-15: values
     * of enum mip_filter_data_gx5_dynamics_mode.
     */
    uint16_t dynamics_mode;
    /**
     * Condition and warnings. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15,
     * 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15,
     * 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT,
     * 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of mip_filter_data_gx5_status_flags (inferred: the
     * 3DM-GX5-15 has them, and the SDK lists the same states for all generations up to the fifth).
     * On the 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS,
     * 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR and 3DM-GV7-INS: values of
     * mip_filter_data_cv7_status_flags (inferred: the 3DM-CV7-GNSS/INS has them, and the SDK lists
     * the same states for its generation). On the 3DM-CV7-GNSS/INS: values of
     * mip_filter_data_cv7_status_flags. On the 3DM-GX5-15: values of
     * mip_filter_data_gx5_status_flags.
     */
    uint16_t status_flags;
};

#define MIP_FILTER_DATA_STATUS 0x8210
#define MIP_FILTER_DATA_STATUS_DESCRIPTOR 0x10
MIP_FIELD(mip_filter_data_status, 0x10);

/**
 * Filter timestamp: data (0x82,0x11).
 *
 * GPS time of the filter data.
 *
 * Without PPS the internal clock drives the time, and the time jumps when the PPS returns.
 *
 * Without synchronization to a receiver or an external clock it is the internal system time.
 *
 * 3DM-CV7: this field may be withdrawn; prefer mip_shared_gps_timestamp.
 *
 * - 3dm-cv7-gnss-ins: Timestamp (0x82,0x11)
 * - 3dm-gx5-15: 5.2.2 GPS Timestamp (0x82, 0x11)
 */
struct mip_filter_data_timestamp {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    double tow;
    /**
     * GPS week, counted from 1980. Unit: week. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in
     * valid_flags is set.
     */
    uint16_t week_number;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_TIMESTAMP 0x8211
#define MIP_FILTER_DATA_TIMESTAMP_DESCRIPTOR 0x11
MIP_FIELD(mip_filter_data_timestamp, 0x11);

/**
 * Quaternion uncertainty: data (0x82,0x12).
 *
 * Standard deviation of the elements of the estimated attitude quaternion.
 *
 * - 3dm-cv7-gnss-ins: Quaternion Attitude Uncertainty (0x82,0x12)
 * - 3dm-gx5-15: 5.2.4 Attitude Uncertainty, Quaternion Elements (0x82, 0x12)
 */
struct mip_filter_data_quaternion_attitude_uncertainty {
    /**
     * Standard deviation per element. Elements: w, x, y, z. Unit: 1. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float q[4];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_QUATERNION_ATTITUDE_UNCERTAINTY 0x8212
#define MIP_FILTER_DATA_QUATERNION_ATTITUDE_UNCERTAINTY_DESCRIPTOR 0x12
MIP_FIELD(mip_filter_data_quaternion_attitude_uncertainty, 0x12);

/**
 * Gravity vector: data (0x82,0x13).
 *
 * Estimated gravity.
 *
 * - 3dm-cv7-gnss-ins: Gravity Vector (0x82,0x13)
 * - 3dm-gx5-15: 5.2.14 Gravity Vector (0x82, 0x13)
 */
struct mip_filter_data_gravity_vector {
    /**
     * Gravity vector, which points down. Elements: x, y, z. Unit: m/s^2. Frame: vehicle. At rest
     * and level: x 0, y 0, z 9.8. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     * Uncertain: No source states the sign.
     */
    float gravity[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_GRAVITY_VECTOR 0x8213
#define MIP_FILTER_DATA_GRAVITY_VECTOR_DESCRIPTOR 0x13
MIP_FIELD(mip_filter_data_gravity_vector, 0x13);

/**
 * Heading update source state: data (0x82,0x14).
 *
 * The last heading that updated the filter, and its source.
 *
 * The valid bit means that the source provided data within the last 2 seconds.
 *
 * - 3dm-gx5-15: 5.2.16 Heading Update Source State (0x82, 0x14)
 */
struct mip_filter_data_heading_update_state {
    /**
     * Heading of the sensor frame relative to true north. Unit: rad. Frame: ned. Positive:
     * clockwise seen from above. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float heading;
    /**
     * Standard deviation of the heading. Unit: rad. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float heading_uncertainty;
    /**
     * Sources of the heading. On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only
     * MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_EXTERNAL. On the 3DM-CV5-25, 3DM-CX5-25, 3DM-GX4-25 and
     * 3DM-GX5-25: only MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_MAG and
     * MIP_FILTER_DATA_HEADING_SOURCE_FLAGS_EXTERNAL.
     */
    mip_filter_data_heading_source_flags source;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_HEADING_UPDATE_STATE 0x8214
#define MIP_FILTER_DATA_HEADING_UPDATE_STATE_DESCRIPTOR 0x14
MIP_FIELD(mip_filter_data_heading_update_state, 0x14);

/**
 * Magnetic model: data (0x82,0x15).
 *
 * Magnetic field at the position of the device according to the World Magnetic Model.
 *
 * It is valid only with a valid GNSS position.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Model (0x82,0x15)
 */
struct mip_filter_data_magnetic_model {
    /**
     * North component of the field. Unit: gauss. Frame: ned. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float intensity_north;
    /**
     * East component of the field. Unit: gauss. Frame: ned. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float intensity_east;
    /**
     * Down component of the field. Unit: gauss. Frame: ned. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float intensity_down;
    /**
     * Angle of the field below the horizontal plane. Unit: rad. Frame: ned. Range:
     * -1.5707963267948966 to 1.5707963267948966. Positive: the field points down. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float inclination;
    /**
     * Angle from true north to magnetic north. Unit: rad. Frame: ned. Range: -pi to pi. Positive:
     * magnetic north is east of true north. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in
     * valid_flags is set.
     */
    float declination;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAGNETIC_MODEL 0x8215
#define MIP_FILTER_DATA_MAGNETIC_MODEL_DESCRIPTOR 0x15
MIP_FIELD(mip_filter_data_magnetic_model, 0x15);

/**
 * Gyroscope scale factor: data (0x82,0x16).
 *
 * Estimated scale factor of the gyroscope.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gyro Scale Factor (0x82,0x16)
 */
struct mip_filter_data_gyro_scale_factor {
    /**
     * Scale factor per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float scale_factor[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_GYRO_SCALE_FACTOR 0x8216
#define MIP_FILTER_DATA_GYRO_SCALE_FACTOR_DESCRIPTOR 0x16
MIP_FIELD(mip_filter_data_gyro_scale_factor, 0x16);

/**
 * Accelerometer scale factor: data (0x82,0x17).
 *
 * Estimated scale factor of the accelerometer.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Accel Scale Factor (0x82,0x17)
 */
struct mip_filter_data_accel_scale_factor {
    /**
     * Scale factor per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float scale_factor[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ACCEL_SCALE_FACTOR 0x8217
#define MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_DESCRIPTOR 0x17
MIP_FIELD(mip_filter_data_accel_scale_factor, 0x17);

/**
 * Gyroscope scale factor uncertainty: data (0x82,0x18).
 *
 * Standard deviation of the estimated scale factor of the gyroscope.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gyro Scale Factor Uncertainty (0x82,0x18)
 */
struct mip_filter_data_gyro_scale_factor_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Range: at least 0.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float scale_factor_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_GYRO_SCALE_FACTOR_UNCERTAINTY 0x8218
#define MIP_FILTER_DATA_GYRO_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR 0x18
MIP_FIELD(mip_filter_data_gyro_scale_factor_uncertainty, 0x18);

/**
 * Accelerometer scale factor uncertainty: data (0x82,0x19).
 *
 * Standard deviation of the estimated scale factor of the accelerometer.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Accel Scale Factor Uncertainty (0x82,0x19)
 */
struct mip_filter_data_accel_scale_factor_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: 1. Frame: sensor. Range: at least 0.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float scale_factor_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_UNCERTAINTY 0x8219
#define MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR 0x19
MIP_FIELD(mip_filter_data_accel_scale_factor_uncertainty, 0x19);

/**
 * Magnetometer bias: data (0x82,0x1A).
 *
 * Estimated bias of the magnetometer.
 *
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Mag Bias (0x82,0x1A)
 */
struct mip_filter_data_mag_bias {
    /**
     * Estimated bias of the magnetometer. Elements: x, y, z. Unit: gauss. Frame: sensor. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_BIAS 0x821A
#define MIP_FILTER_DATA_MAG_BIAS_DESCRIPTOR 0x1A
MIP_FIELD(mip_filter_data_mag_bias, 0x1A);

/**
 * Magnetometer bias uncertainty: data (0x82,0x1B).
 *
 * Standard deviation of the estimated bias of the magnetometer.
 *
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Mag Bias Uncertainty (0x82,0x1B)
 */
struct mip_filter_data_mag_bias_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Frame: sensor. Range: at least
     * 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_BIAS_UNCERTAINTY 0x821B
#define MIP_FILTER_DATA_MAG_BIAS_UNCERTAINTY_DESCRIPTOR 0x1B
MIP_FIELD(mip_filter_data_mag_bias_uncertainty, 0x1B);

/**
 * Compensated acceleration: data (0x82,0x1C).
 *
 * Specific force with the estimated bias removed.
 *
 * - 3dm-cv7-gnss-ins: Compensated Acceleration (0x82,0x1C)
 * - 3dm-gx5-15: 5.2.11 Compensated Acceleration (0x82, 0x1C)
 */
struct mip_filter_data_comp_accel {
    /**
     * Specific force: acceleration minus gravity. Elements: x, y, z. Unit: m/s^2. Frame: vehicle.
     * At rest and level: x 0, y 0, z -9.8. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in
     * valid_flags is set.
     */
    float accel[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_COMP_ACCEL 0x821C
#define MIP_FILTER_DATA_COMP_ACCEL_DESCRIPTOR 0x1C
MIP_FIELD(mip_filter_data_comp_accel, 0x1C);

/**
 * Standard atmosphere: data (0x82,0x20).
 *
 * US Standard Atmosphere of 1976 at the device's altitude.
 *
 * No device is known for certain to support it. Known only from the MicroStrain MIP SDK.
 *
 * It is valid only with a valid GNSS position.
 *
 * - mip-sdk-4: Standard atmosphere (0x82,0x20)
 */
struct mip_filter_data_standard_atmosphere {
    /**
     * Altitude used in the model. Unit: m. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in
     * valid_flags is set.
     */
    float geometric_altitude;
    /**
     * Geometric altitude corrected for the decrease of gravity with height. Unit: m. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float geopotential_altitude;
    /**
     * Temperature at this altitude according to the model. Unit: degC. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float standard_temperature;
    /**
     * Pressure at this altitude according to the model. Unit: mbar. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float standard_pressure;
    /**
     * Air density at this altitude according to the model. Unit: kg/m^3. Range: at least 0. Valid
     * if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float standard_density;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_STANDARD_ATMOSPHERE 0x8220
#define MIP_FILTER_DATA_STANDARD_ATMOSPHERE_DESCRIPTOR 0x20
MIP_FIELD(mip_filter_data_standard_atmosphere, 0x20);

/**
 * Pressure altitude: data (0x82,0x21).
 *
 * Altitude from the measured pressure, by the US Standard Atmosphere of 1976.
 *
 * Requires a pressure sensor.
 *
 * It needs a valid pressure. The model ends at a pressure of 0.0037 mbar, an altitude of 84852 m.
 *
 * - 3dm-cv7-gnss-ins: Pressure Altitude (0x82,0x21)
 * - 3dm-gx5-15: 5.2.13 Pressure Altitude (0x82, 0x21)
 */
struct mip_filter_data_pressure_altitude {
    /**
     * Altitude at which the standard atmosphere has the measured pressure. Unit: m. Range: at most
     * 84852. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float pressure_altitude;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_PRESSURE_ALTITUDE 0x8221
#define MIP_FILTER_DATA_PRESSURE_ALTITUDE_DESCRIPTOR 0x21
MIP_FIELD(mip_filter_data_pressure_altitude, 0x21);

/**
 * Density altitude: data (0x82,0x22).
 *
 * Density of the surrounding air, expressed as the altitude with the same density in the standard
 * atmosphere.
 *
 * Known only from the MicroStrain MIP SDK. Uncertain: The SDK lists only the name; the description
 * is the usual meaning of the term.
 *
 * - mip-sdk-4: Density altitude (0x82,0x22)
 */
struct mip_filter_data_density_altitude {
    /**
     * Altitude at which the standard atmosphere has the present air density. Unit: m. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float density_altitude;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_DENSITY_ALTITUDE 0x8222
#define MIP_FILTER_DATA_DENSITY_ALTITUDE_DESCRIPTOR 0x22
MIP_FIELD(mip_filter_data_density_altitude, 0x22);

/**
 * Magnetometer offset: data (0x82,0x25).
 *
 * Estimated hard iron offset of the magnetometer.
 *
 * No device is known for certain to support it. Also called `magnetometer_offset`. Known only from
 * the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * The filter adds it to the stored offset of mip_3dm_mag_hard_iron_offset.
 *
 * - mip-sdk-4: Magnetometer offset (0x82,0x25)
 */
struct mip_filter_data_mag_offset {
    /**
     * Estimated constant field of magnetized parts near the magnetometer. Elements: x, y, z. Unit:
     * gauss. Frame: sensor. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float hard_iron[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_OFFSET 0x8225
#define MIP_FILTER_DATA_MAG_OFFSET_DESCRIPTOR 0x25
MIP_FIELD(mip_filter_data_mag_offset, 0x25);

/**
 * Magnetometer matrix: data (0x82,0x26).
 *
 * Estimated soft iron matrix of the magnetometer.
 *
 * No device is known for certain to support it. Also called `magnetometer_matrix`. Known only from
 * the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * The filter multiplies the stored matrix of mip_3dm_mag_soft_iron_matrix by this matrix on the
 * right.
 *
 * - mip-sdk-4: Magnetometer matrix (0x82,0x26)
 */
struct mip_filter_data_mag_matrix {
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Unit: 1. Frame: sensor. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float soft_iron[9];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_MATRIX 0x8226
#define MIP_FILTER_DATA_MAG_MATRIX_DESCRIPTOR 0x26
MIP_FIELD(mip_filter_data_mag_matrix, 0x26);

/**
 * Magnetometer offset uncertainty: data (0x82,0x28).
 *
 * Standard deviation of the estimated hard iron offset.
 *
 * No device is known for certain to support it. Also called `magnetometer_offset_uncertainty`.
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Magnetometer offset uncertainty (0x82,0x28)
 */
struct mip_filter_data_mag_offset_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Frame: sensor. Range: at least
     * 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float hard_iron_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_OFFSET_UNCERTAINTY 0x8228
#define MIP_FILTER_DATA_MAG_OFFSET_UNCERTAINTY_DESCRIPTOR 0x28
MIP_FIELD(mip_filter_data_mag_offset_uncertainty, 0x28);

/**
 * Magnetometer matrix uncertainty: data (0x82,0x29).
 *
 * Standard deviation of the estimated soft iron matrix.
 *
 * No device is known for certain to support it. Also called `magnetometer_matrix_uncertainty`.
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Magnetometer matrix uncertainty (0x82,0x29)
 */
struct mip_filter_data_mag_matrix_uncertainty {
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1. Frame: sensor. Range: at least 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in
     * valid_flags is set.
     */
    float soft_iron_uncertainty[9];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_MATRIX_UNCERTAINTY 0x8229
#define MIP_FILTER_DATA_MAG_MATRIX_UNCERTAINTY_DESCRIPTOR 0x29
MIP_FIELD(mip_filter_data_mag_matrix_uncertainty, 0x29);

/**
 * Magnetometer covariance matrix: data (0x82,0x2A).
 *
 * Covariance of the magnetometer measurement.
 *
 * Also called `magnetometer_covariance_matrix`. Known only from the MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * - mip-sdk-4: Magnetometer covariance matrix (0x82,0x2A)
 */
struct mip_filter_data_mag_covariance_matrix {
    /**
     * Covariance matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set. Uncertain: No source states
     * the unit, which is likely gauss^2, or the frame.
     */
    float covariance[9];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_COVARIANCE_MATRIX 0x822A
#define MIP_FILTER_DATA_MAG_COVARIANCE_MATRIX_DESCRIPTOR 0x2A
MIP_FIELD(mip_filter_data_mag_covariance_matrix, 0x2A);

/**
 * Magnetometer residual vector: data (0x82,0x2C).
 *
 * Residual of the magnetometer measurement.
 *
 * Also called `magnetometer_residual_vector`. Known only from the MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * - mip-sdk-4: Magnetometer residual vector (0x82,0x2C)
 */
struct mip_filter_data_mag_residual_vector {
    /**
     * Difference between the measured and the expected magnetic field. Elements: x, y, z. Unit:
     * gauss. Frame: vehicle. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float residual[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MAG_RESIDUAL_VECTOR 0x822C
#define MIP_FILTER_DATA_MAG_RESIDUAL_VECTOR_DESCRIPTOR 0x2C
MIP_FIELD(mip_filter_data_mag_residual_vector, 0x2C);

/**
 * Antenna offset correction: data (0x82,0x30).
 *
 * Estimated error of the GNSS antenna offset.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * The filter adds it to the stored offset of mip_filter_antenna_offset.
 *
 * - mip-sdk-4: Antenna offset correction (0x82,0x30)
 */
struct mip_filter_data_antenna_offset_correction {
    /**
     * Estimated correction of the configured antenna offset. Elements: x, y, z. Unit: m. Frame:
     * vehicle. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float offset[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION 0x8230
#define MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_DESCRIPTOR 0x30
MIP_FIELD(mip_filter_data_antenna_offset_correction, 0x30);

/**
 * Antenna offset correction uncertainty: data (0x82,0x31).
 *
 * Standard deviation of the estimated error of the GNSS antenna offset.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Antenna offset correction uncertainty (0x82,0x31)
 */
struct mip_filter_data_antenna_offset_correction_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m. Frame: vehicle. Range: at least 0.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float offset_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_UNCERTAINTY 0x8231
#define MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_UNCERTAINTY_DESCRIPTOR 0x31
MIP_FIELD(mip_filter_data_antenna_offset_correction_uncertainty, 0x31);

/**
 * Clock correction: data (0x82,0x32).
 *
 * Estimated clock error of one GNSS receiver.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Clock correction (0x82,0x32)
 */
struct mip_filter_data_clock_correction {
    /** Receiver, counted from 1. Range: at least 1. */
    uint8_t receiver_id;
    /**
     * Bias of the clock. Unit: s. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias;
    /**
     * Drift of the clock. Unit: s/s. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is
     * set.
     */
    float bias_drift;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_CLOCK_CORRECTION 0x8232
#define MIP_FILTER_DATA_CLOCK_CORRECTION_DESCRIPTOR 0x32
MIP_FIELD(mip_filter_data_clock_correction, 0x32);

/**
 * Clock correction uncertainty: data (0x82,0x33).
 *
 * Standard deviation of the estimated clock error of one GNSS receiver.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Clock correction uncertainty (0x82,0x33)
 */
struct mip_filter_data_clock_correction_uncertainty {
    /** Receiver, counted from 1. Range: at least 1. */
    uint8_t receiver_id;
    /**
     * Standard deviation of the bias. Unit: s. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias_uncertainty;
    /**
     * Standard deviation of the drift. Unit: s/s. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float bias_drift_uncertainty;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_CLOCK_CORRECTION_UNCERTAINTY 0x8233
#define MIP_FILTER_DATA_CLOCK_CORRECTION_UNCERTAINTY_DESCRIPTOR 0x33
MIP_FIELD(mip_filter_data_clock_correction_uncertainty, 0x33);

/**
 * Multi-antenna offset correction: data (0x82,0x34).
 *
 * Estimated error of one GNSS antenna's offset.
 *
 * Requires a receiver.
 *
 * The filter adds it to the stored offset.
 *
 * - 3dm-cv7-gnss-ins: Multi Antenna Offset Correction (0x82,0x34)
 */
struct mip_filter_data_multi_antenna_offset_correction {
    /** Receiver that the antenna belongs to. */
    uint8_t receiver_id;
    /**
     * Estimated correction of the configured antenna offset. Elements: x, y, z. Unit: m. Frame:
     * vehicle. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float offset[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_CORRECTION 0x8234
#define MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_CORRECTION_DESCRIPTOR 0x34
MIP_FIELD(mip_filter_data_multi_antenna_offset_correction, 0x34);

/**
 * Multi-antenna offset correction uncertainty: data (0x82,0x35).
 *
 * Standard deviation of the estimated error of one GNSS antenna's offset.
 *
 * Full name: filter_data.multi_antenna_offset_correction_uncertainty.
 *
 * Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: Multi Antenna Offset Correction Uncertainty (0x82,0x35)
 */
struct mip_filter_data_multi_antenna_offset_uncertainty {
    /** Receiver that the antenna belongs to. */
    uint8_t receiver_id;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m. Frame: vehicle. Range: at least 0.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float offset_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_UNCERTAINTY 0x8235
#define MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_UNCERTAINTY_DESCRIPTOR 0x35
MIP_FIELD(mip_filter_data_multi_antenna_offset_uncertainty, 0x35);

/**
 * ECEF position uncertainty: data (0x82,0x36).
 *
 * Standard deviation of the estimated position in Earth-fixed coordinates.
 *
 * Also called `ecef_pos_uncertainty`.
 *
 * - 3dm-cv7-gnss-ins: ECEF Position Uncertainty (0x82,0x36)
 */
struct mip_filter_data_ecef_position_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m. Frame: ecef. Range: at least 0.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float position_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ECEF_POSITION_UNCERTAINTY 0x8236
#define MIP_FILTER_DATA_ECEF_POSITION_UNCERTAINTY_DESCRIPTOR 0x36
MIP_FIELD(mip_filter_data_ecef_position_uncertainty, 0x36);

/**
 * ECEF velocity uncertainty: data (0x82,0x37).
 *
 * Standard deviation of the estimated velocity in Earth-fixed coordinates.
 *
 * Also called `ecef_vel_uncertainty`.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity Uncertainty (0x82,0x37)
 */
struct mip_filter_data_ecef_velocity_uncertainty {
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m/s. Frame: ecef. Range: at least 0.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float velocity_uncertainty[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ECEF_VELOCITY_UNCERTAINTY 0x8237
#define MIP_FILTER_DATA_ECEF_VELOCITY_UNCERTAINTY_DESCRIPTOR 0x37
MIP_FIELD(mip_filter_data_ecef_velocity_uncertainty, 0x37);

/**
 * ECEF position: data (0x82,0x40).
 *
 * Estimated position in Earth-fixed coordinates.
 *
 * Also called `ecef_pos`.
 *
 * - 3dm-cv7-gnss-ins: ECEF Position (0x82,0x40)
 */
struct mip_filter_data_ecef_position {
    /**
     * Position of the reference point. Elements: x, y, z. Unit: m. Frame: ecef. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    double position[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ECEF_POSITION 0x8240
#define MIP_FILTER_DATA_ECEF_POSITION_DESCRIPTOR 0x40
MIP_FIELD(mip_filter_data_ecef_position, 0x40);

/**
 * ECEF velocity: data (0x82,0x41).
 *
 * Estimated velocity in Earth-fixed coordinates.
 *
 * Also called `ecef_vel`.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity (0x82,0x41)
 */
struct mip_filter_data_ecef_velocity {
    /**
     * Velocity of the reference point. Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and
     * level: x 0, y 0, z 0. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float velocity[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ECEF_VELOCITY 0x8241
#define MIP_FILTER_DATA_ECEF_VELOCITY_DESCRIPTOR 0x41
MIP_FIELD(mip_filter_data_ecef_velocity, 0x41);

/**
 * NED relative position: data (0x82,0x42).
 *
 * Estimated position relative to the point that mip_filter_relative_position_config sets.
 *
 * Also called `rel_pos_ned`.
 *
 * - 3dm-cv7-gnss-ins: NED Relative Position (0x82,0x42)
 */
struct mip_filter_data_ned_relative_position {
    /**
     * From the reference point to the device. Elements: north, east, down. Unit: m. Frame: ned.
     * Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    double relative_position[3];
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_NED_RELATIVE_POSITION 0x8242
#define MIP_FILTER_DATA_NED_RELATIVE_POSITION_DESCRIPTOR 0x42
MIP_FIELD(mip_filter_data_ned_relative_position, 0x42);

/**
 * GNSS position aiding status: data (0x82,0x43).
 *
 * Use of the position measurements of one GNSS receiver by the filter.
 *
 * Also called `gnss_pos_aid_status`.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - 3dm-cv7-gnss-ins: GNSS Position Aiding Status (0x82,0x43)
 */
struct mip_filter_data_gnss_position_aiding_status {
    /** Number of the receiver. */
    uint8_t receiver_id;
    /** GPS time of week of the last measurement. Unit: s. Range: 0 to 604800. */
    float tow;
    /** State of the measurements in the filter. */
    mip_filter_data_gnss_aiding_status status;
    /** Reserved. */
    uint8_t reserved[8];
};

#define MIP_FILTER_DATA_GNSS_POSITION_AIDING_STATUS 0x8243
#define MIP_FILTER_DATA_GNSS_POSITION_AIDING_STATUS_DESCRIPTOR 0x43
MIP_FIELD(mip_filter_data_gnss_position_aiding_status, 0x43);

/**
 * GNSS attitude aiding status: data (0x82,0x44).
 *
 * State of the attitude aiding by two GNSS antennas.
 *
 * Also called `gnss_att_aid_status`. Known only from the MicroStrain MIP SDK.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - mip-sdk-4: Gnss Att Aid Status (0x82,0x44)
 */
struct mip_filter_data_gnss_attitude_aiding_status {
    /**
     * GPS time of week of the last valid measurement. Unit: s. Range: 0 to 604800. Uncertain: It is
     * not known whether this is the time of the measurement or that of its processing.
     */
    float tow;
    /** State of the measurements in the filter. */
    mip_filter_data_gnss_aiding_status status;
    /** Reserved. Reserved. */
    uint8_t reserved[8];
};

#define MIP_FILTER_DATA_GNSS_ATTITUDE_AIDING_STATUS 0x8244
#define MIP_FILTER_DATA_GNSS_ATTITUDE_AIDING_STATUS_DESCRIPTOR 0x44
MIP_FIELD(mip_filter_data_gnss_attitude_aiding_status, 0x44);

/**
 * Heading aiding status: data (0x82,0x45).
 *
 * The heading measurement that the filter used last.
 *
 * Also called `head_aid_status`. Known only from the MicroStrain MIP SDK.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - mip-sdk-4: Head Aid Status (0x82,0x45)
 */
struct mip_filter_data_heading_aiding_status {
    /**
     * GPS time of week of the last valid measurement. Unit: s. Range: 0 to 604800. Uncertain: It is
     * not known whether this is the time of the measurement or that of its processing.
     */
    float tow;
    /** Source of the heading. A value of enum mip_filter_data_heading_aiding_type. */
    uint8_t type;
    /** Reserved. Reserved. */
    float reserved[2];
};

#define MIP_FILTER_DATA_HEADING_AIDING_STATUS 0x8245
#define MIP_FILTER_DATA_HEADING_AIDING_STATUS_DESCRIPTOR 0x45
MIP_FIELD(mip_filter_data_heading_aiding_status, 0x45);

/**
 * Aiding measurement summary: data (0x82,0x46).
 *
 * Use of one kind of aiding measurement in the last measurement interval.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Summary (0x82,0x46)
 */
struct mip_filter_data_aiding_measurement_summary {
    /** GPS time of week at the end of the interval. Unit: s. Range: 0 to 604800. */
    float tow;
    /** Number of the source of the measurement. */
    uint8_t source;
    /** Kind of measurement. A value of enum mip_filter_data_aiding_measurement_type. */
    uint8_t type;
    /** Use of the measurement by the filter. */
    mip_filter_data_aiding_measurement_indicator indicator;
};

#define MIP_FILTER_DATA_AIDING_MEASUREMENT_SUMMARY 0x8246
#define MIP_FILTER_DATA_AIDING_MEASUREMENT_SUMMARY_DESCRIPTOR 0x46
MIP_FIELD(mip_filter_data_aiding_measurement_summary, 0x46);

/**
 * Odometer scale factor error: data (0x82,0x47).
 *
 * Estimated relative error of the odometer scale factor.
 *
 * Estimated scale factor = configured scale factor * (1 + error).
 *
 * - 3dm-cv7-gnss-ins: Odometer Scale Factor Error (0x82,0x47)
 */
struct mip_filter_data_odometer_scale_factor_error {
    /**
     * Relative error. Unit: 1. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float scale_factor_error;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR 0x8247
#define MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_DESCRIPTOR 0x47
MIP_FIELD(mip_filter_data_odometer_scale_factor_error, 0x47);

/**
 * Odometer scale factor error uncertainty: data (0x82,0x48).
 *
 * Uncertainty of the estimated error of the odometer scale factor.
 *
 * - 3dm-cv7-gnss-ins: Odometer Scale Factor Error Uncertainty (0x82,0x48)
 */
struct mip_filter_data_odometer_scale_factor_error_uncertainty {
    /**
     * Uncertainty of the relative error. Unit: 1. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float scale_factor_error_uncertainty;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_UNCERTAINTY 0x8248
#define MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_UNCERTAINTY_DESCRIPTOR 0x48
MIP_FIELD(mip_filter_data_odometer_scale_factor_error_uncertainty, 0x48);

/**
 * GNSS dual antenna status: data (0x82,0x49).
 *
 * Heading from two GNSS antennas.
 *
 * Requires 2 antennas.
 *
 * It is a measurement that aids the filter. The heading of mip_filter_data_euler_angles is the
 * estimate of the filter from all measurements.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - 3dm-cv7-gnss-ins: GNSS Dual Antenna Status (0x82,0x49)
 */
struct mip_filter_data_gnss_dual_antenna_status {
    /**
     * GPS time of week of the last measurement. Unit: s. Range: 0 to 604800. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float tow;
    /**
     * Heading derived from the baseline of the antennas. Unit: rad. Frame: ned. Positive: clockwise
     * seen from above. Valid if MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float heading;
    /**
     * Standard deviation of the heading. Unit: rad. Range: at least 0. Valid if
     * MIP_FILTER_DATA_VALID_FLAGS_VALID in valid_flags is set.
     */
    float heading_uncertainty;
    /** Kind of solution. A value of enum mip_filter_data_dual_antenna_fix_type. */
    uint8_t fix_type;
    /** Inputs available to the solution. */
    mip_filter_data_dual_antenna_status_flags status_flags;
    /** Validity of the values of a field. */
    mip_filter_data_valid_flags valid_flags;
};

#define MIP_FILTER_DATA_GNSS_DUAL_ANTENNA_STATUS 0x8249
#define MIP_FILTER_DATA_GNSS_DUAL_ANTENNA_STATUS_DESCRIPTOR 0x49
MIP_FIELD(mip_filter_data_gnss_dual_antenna_status, 0x49);

/**
 * Aiding frame configuration error: data (0x82,0x50).
 *
 * Estimated error of a frame that mip_aiding_frame_config defines. The filter corrects for it.
 *
 * - 3dm-cv7-gnss-ins: Aiding Frame Configuration Error (0x82,0x50)
 */
struct mip_filter_data_aiding_frame_config_error {
    /** Number of the frame. */
    uint8_t frame_id;
    /** Estimated error of the translation. Elements: x, y, z. Unit: m. */
    float translation[3];
    /** Estimated error of the rotation. Elements: w, x, y, z. Unit: 1. */
    float attitude[4];
};

#define MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR 0x8250
#define MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_DESCRIPTOR 0x50
MIP_FIELD(mip_filter_data_aiding_frame_config_error, 0x50);

/**
 * Aiding frame configuration error uncertainty: data (0x82,0x51).
 *
 * Uncertainty of the error in mip_filter_data_aiding_frame_config_error.
 *
 * - 3dm-cv7-gnss-ins: Aiding Frame Configuration Error Uncertainty (0x82,0x51)
 */
struct mip_filter_data_aiding_frame_config_error_uncertainty {
    /** Number of the frame. */
    uint8_t frame_id;
    /**
     * Standard deviation of the error of the translation. Elements: x, y, z. Unit: m. Range: at
     * least 0.
     */
    float translation_uncertainty[3];
    /**
     * Uncertainty of the rotation about each axis. Elements: x, y, z. Unit: rad. Range: at least 0.
     */
    float attitude_uncertainty[3];
};

#define MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_UNCERTAINTY 0x8251
#define MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_UNCERTAINTY_DESCRIPTOR 0x51
MIP_FIELD(mip_filter_data_aiding_frame_config_error_uncertainty, 0x51);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
