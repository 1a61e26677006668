/**
 * @file
 *
 * Filter commands (0x0D). Commands that set up, start and aid the navigation filter.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_FILTER_H
#define MIP_FILTER_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/filter.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_filter Filter commands (0x0D)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_FILTER_SET 0x0D

/**
 * Motion that the filter expects, depending on the kind of vehicle. Uncertain: The SDK lists only
 * the names of the modes, from which the descriptions are inferred. Uncertain:
 * mip_filter_data_status reports a mode too, but is known to have the values 1 to 3 only.
 *
 * - mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
 */
enum mip_filter_dynamics_mode MIP_ENUM_8 {
    /** Carried by hand. */
    MIP_FILTER_DYNAMICS_MODE_PORTABLE = 1,
    /** Ground vehicle. */
    MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE = 2,
    /** Aircraft. */
    MIP_FILTER_DYNAMICS_MODE_AIRBORNE = 3,
    /** Aircraft under high acceleration. */
    MIP_FILTER_DYNAMICS_MODE_AIRBORNE_HIGH_G = 4
};

/**
 * States that the filter estimates.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 * - mip-sdk-4: Estimation Control (0x0D,0x14)
 */
typedef uint16_t mip_filter_estimated_states;
/** Bit 0. Estimate the gyroscope bias (recommended). */
#define MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS 0x0001U
/** Bit 1. Estimate the accelerometer bias. */
#define MIP_FILTER_ESTIMATED_STATES_ACCEL_BIAS 0x0002U
/** Bit 2. Estimate the scale factor of the gyroscope. */
#define MIP_FILTER_ESTIMATED_STATES_GYRO_SCALE_FACTOR 0x0004U
/** Bit 3. Estimate the scale factor of the accelerometer. */
#define MIP_FILTER_ESTIMATED_STATES_ACCEL_SCALE_FACTOR 0x0008U
/** Bit 4. Estimate the offset of the GNSS antenna. */
#define MIP_FILTER_ESTIMATED_STATES_ANTENNA_OFFSET 0x0010U
/** Bit 5. Estimate the hard iron offset of the magnetometer. Requires a magnetometer. */
#define MIP_FILTER_ESTIMATED_STATES_AUTO_HARD_IRON 0x0020U
/** Bit 6. Estimate the soft iron matrix of the magnetometer. Requires a magnetometer. */
#define MIP_FILTER_ESTIMATED_STATES_AUTO_SOFT_IRON 0x0040U

/** Source of the GNSS data that aids the filter. */
enum mip_filter_gnss_aiding_source MIP_ENUM_8 {
    /** All internal receivers. Requires a receiver. */
    MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL = 1,
    /** GNSS measurements that your program sends. */
    MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL = 2,
    /** Internal receiver 1 only. Requires a receiver. */
    MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_1 = 3,
    /** Internal receiver 2 only. Requires 2 receivers. */
    MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_2 = 4
};

/** The north that a heading refers to. */
enum mip_filter_heading_type MIP_ENUM_8 {
    /** True north. */
    MIP_FILTER_HEADING_TYPE_TRUE_HEADING = 1,
    /** Magnetic north. */
    MIP_FILTER_HEADING_TYPE_MAGNETIC_HEADING = 2
};

/**
 * Source of the heading updates that aid the filter.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 * - 3dm-gx5-45: (0x0D, 0x18)
 * - mip-sdk-4: Heading Source (0x0D,0x18)
 */
enum mip_filter_heading_update_source MIP_ENUM_8 {
    /** No heading updates. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_NONE = 0,
    /** The device's own magnetometer. Requires a magnetometer. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_MAG = 1,
    /** The velocity that the GNSS receiver measures. Requires a receiver. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY = 2,
    /** The heading messages that your program sends. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL = 3,
    /** The course over ground and the magnetometer. Requires a receiver and a magnetometer. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY_AND_MAG = 4,
    /** GNSS velocity and your program's heading messages. Requires a receiver. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY_AND_EXTERNAL = 5,
    /** Magnetometer and your program's heading messages. Requires a magnetometer. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_MAG_AND_EXTERNAL = 6,
    /** GNSS, magnetometer and external heading. Requires a receiver and a magnetometer. */
    MIP_FILTER_HEADING_UPDATE_SOURCE_ALL = 7
};

/** Axes to tare; 0 resets all axes. */
typedef uint8_t mip_filter_tare_axes;
/** Bit 0. The present roll becomes zero. */
#define MIP_FILTER_TARE_AXES_ROLL 0x01U
/** Bit 1. The present pitch becomes zero. */
#define MIP_FILTER_TARE_AXES_PITCH 0x02U
/** Bit 2. The present yaw becomes zero. */
#define MIP_FILTER_TARE_AXES_YAW 0x04U

/** Measurements that the filter uses. */
typedef uint16_t mip_filter_measurement_flags;
/** Bit 0. Accelerometer measurements. */
#define MIP_FILTER_MEASUREMENT_FLAGS_ACCEL 0x0001U
/** Bit 1. Magnetometer measurements. Requires a magnetometer. */
#define MIP_FILTER_MEASUREMENT_FLAGS_MAG 0x0002U

/** Source of the declination, the inclination or the magnitude of the magnetic field. */
enum mip_filter_mag_parameter_source MIP_ENUM_8 {
    /** No source. Uncertain: No source states what the device does without a declination. */
    MIP_FILTER_MAG_PARAMETER_SOURCE_NONE = 1,
    /** The World Magnetic Model, at the estimated position. */
    MIP_FILTER_MAG_PARAMETER_SOURCE_WMM = 2,
    /** The value specified by the command. */
    MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL = 3
};

/** Weighting of measurements whose magnitude is not as expected. */
enum mip_filter_adaptive_measurement_selector MIP_ENUM_8 {
    /** No adaptation. */
    MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED = 0,
    /** The limits in the command determine the weights. */
    MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED = 1,
    /** The filter determines the weights; the limits are ignored. 3DM-GX5 and later. */
    MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_AUTO = 2
};

/**
 * Source that aids the altitude.
 *
 * - mip-sdk-4: Altitude Aiding (0x0D,0x47)
 */
enum mip_filter_altitude_aiding_source MIP_ENUM_8 {
    /** No aiding. */
    MIP_FILTER_ALTITUDE_AIDING_SOURCE_NONE = 0,
    /** The pressure sensor. Requires a pressure sensor. */
    MIP_FILTER_ALTITUDE_AIDING_SOURCE_PRESSURE = 1
};

/** Source that aids pitch and roll. */
enum mip_filter_pitch_roll_aiding_source MIP_ENUM_8 {
    /** No aiding. */
    MIP_FILTER_PITCH_ROLL_AIDING_SOURCE_NONE = 0,
    /** The measured gravity vector. */
    MIP_FILTER_PITCH_ROLL_AIDING_SOURCE_GRAVITY_VECTOR = 1
};

/**
 * A source of aiding measurements.
 *
 * Position and velocity of the GNSS receivers.
 */
#define MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY 0
/** GNSS heading from two antennas. Requires 2 antennas. */
#define MIP_FILTER_AIDING_SOURCE_GNSS_HEADING 1
/** Built-in pressure altimeter. Requires a pressure sensor. */
#define MIP_FILTER_AIDING_SOURCE_ALTIMETER 2
/** Speed sensor or odometer. */
#define MIP_FILTER_AIDING_SOURCE_SPEED 3
/** Built-in magnetometer. Requires a magnetometer. */
#define MIP_FILTER_AIDING_SOURCE_MAG 4
/** Heading that your program sends. */
#define MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING 5
/** Pressure altitude that your program sends. */
#define MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER 6
/** Magnetic field that your program sends. */
#define MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG 7
/** Velocity in the body (vehicle) frame that your program sends. */
#define MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY 8
/** All sources, for save, load and default. */
#define MIP_FILTER_AIDING_SOURCE_ALL 0xFFFF

/**
 * Assumption of the filter about the acceleration.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
enum mip_filter_accel_constraint MIP_ENUM_8 {
    /** No assumption. */
    MIP_FILTER_ACCEL_CONSTRAINT_NONE = 0,
    /** The filter assumes no acceleration. */
    MIP_FILTER_ACCEL_CONSTRAINT_ZERO_ACCEL = 1
};

/**
 * Assumption of the filter about the velocity.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
enum mip_filter_velocity_constraint MIP_ENUM_8 {
    /** No assumption. */
    MIP_FILTER_VELOCITY_CONSTRAINT_NONE = 0,
    /** The filter assumes that the device does not move. */
    MIP_FILTER_VELOCITY_CONSTRAINT_ZERO_VELOCITY = 1,
    /** The filter assumes the motion of a wheeled vehicle. */
    MIP_FILTER_VELOCITY_CONSTRAINT_WHEELED_VEHICLE = 2
};

/**
 * Assumption of the filter about the angular rate.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
enum mip_filter_angular_constraint MIP_ENUM_8 {
    /** No assumption. */
    MIP_FILTER_ANGULAR_CONSTRAINT_NONE = 0,
    /** The filter assumes no rotation. */
    MIP_FILTER_ANGULAR_CONSTRAINT_ZERO_ANGULAR_RATE = 1
};

/** Initial conditions that your program provides instead of the device. */
enum mip_filter_initial_condition_source MIP_ENUM_8 {
    /** Position, velocity and attitude are automatic. */
    MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POSITION_VELOCITY_ATTITUDE = 0,
    /** Position, velocity, pitch and roll are automatic; your program provides the heading. */
    MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POSITION_VELOCITY_PITCH_ROLL = 1,
    /** Position and velocity are automatic; your program provides the attitude. */
    MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POSITION_VELOCITY = 2,
    /** Your program provides position, velocity and attitude. */
    MIP_FILTER_INITIAL_CONDITION_SOURCE_MANUAL = 3
};

/** Methods that the device may use to determine its initial heading. */
typedef uint8_t mip_filter_heading_alignment;
/** Bit 0. From the baseline between two GNSS antennas. Requires 2 antennas. */
#define MIP_FILTER_HEADING_ALIGNMENT_DUAL_ANTENNA 0x01U
/** Bit 1. From the GNSS velocity; assumes motion along the positive x axis of the vehicle. */
#define MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC 0x02U
/** Bit 2. From the built-in magnetometer. Requires a magnetometer. */
#define MIP_FILTER_HEADING_ALIGNMENT_MAG 0x04U
/** Bit 3. From the heading that your program sends. */
#define MIP_FILTER_HEADING_ALIGNMENT_EXTERNAL 0x08U

/** Frame of a position. */
enum mip_filter_reference_frame MIP_ENUM_8 {
    /** Earth-centred, Earth-fixed coordinates (WGS84). */
    MIP_FILTER_REFERENCE_FRAME_ECEF = 1,
    /** Latitude, longitude and height above the ellipsoid (WGS84). */
    MIP_FILTER_REFERENCE_FRAME_LLH = 2
};

/** Strength of the adaptation to inconsistent measurements. */
enum mip_filter_adaptive_level MIP_ENUM_8 {
    /** No adaptation. */
    MIP_FILTER_ADAPTIVE_LEVEL_OFF = 0,
    /** Little adaptation. */
    MIP_FILTER_ADAPTIVE_LEVEL_CONSERVATIVE = 1,
    /** Moderate adaptation. */
    MIP_FILTER_ADAPTIVE_LEVEL_MODERATE = 2,
    /** Strong adaptation. */
    MIP_FILTER_ADAPTIVE_LEVEL_AGGRESSIVE = 3
};

/** Source of the reference point for relative positions. */
enum mip_filter_relative_position_source MIP_ENUM_8 {
    /** The base station of the RTK corrections. */
    MIP_FILTER_RELATIVE_POSITION_SOURCE_AUTO = 0,
    /** The coordinates specified by the command. */
    MIP_FILTER_RELATIVE_POSITION_SOURCE_MANUAL = 1
};

/** Point that a lever arm moves. */
enum mip_filter_reference_point MIP_ENUM_8 {
    /** The origin of the vehicle. */
    MIP_FILTER_REFERENCE_POINT_VEHICLE = 1
};

/**
 * Reset navigation filter: command (0x0D,0x01).
 *
 * Returns the filter to its initialization state.
 *
 * Affects MIP_FILTER_DATA_SET.
 *
 * If automatic initialization is off, the attitude or heading must be set before the filter runs
 * again.
 *
 * 3DM-CV7: send it after a large jump of the system time, for example when the PPS is first
 * detected.
 *
 * - 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01)
 * - 3dm-gx5-15: 4.3.1 Reset Filter (0x0D, 0x01)
 */
struct mip_filter_reset {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_RESET 0x0D01
#define MIP_FILTER_RESET_DESCRIPTOR 0x01
MIP_FIELD(mip_filter_reset, 0x01);

/**
 * Set initial attitude: command (0x0D,0x02).
 *
 * Sets the initial attitude of the filter: the orientation of the sensor frame in the NED frame.
 *
 * Affects mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles.
 *
 * Accepted only in the initialization state.
 *
 * - 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02)
 */
struct mip_filter_set_initial_attitude {
    /** Roll angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: right side down. */
    float roll;
    /**
     * Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966.
     * Positive: nose up.
     */
    float pitch;
    /**
     * Heading (yaw) angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from
     * above.
     */
    float heading;
};

#define MIP_FILTER_SET_INITIAL_ATTITUDE 0x0D02
#define MIP_FILTER_SET_INITIAL_ATTITUDE_DESCRIPTOR 0x02
MIP_FIELD(mip_filter_set_initial_attitude, 0x02);

/** Fills the structure, and returns it. */
static inline struct mip_filter_set_initial_attitude *mip_filter_set_initial_attitude_make(
    struct mip_filter_set_initial_attitude *command, float roll, float pitch, float heading) {
    memset(command, 0, sizeof(*command));
    command->roll = roll;
    command->pitch = pitch;
    command->heading = heading;
    return command;
}

/**
 * Set initial heading: command (0x0D,0x03).
 *
 * Sets the initial heading of the filter. Pitch and roll come from the accelerometers.
 *
 * Affects mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles.
 *
 * 3DM-GX5: accepted only in the initialization state.
 *
 * 3DM-CV7: resets the estimated heading; if magnetometer aiding is on, the value of this command is
 * ignored.
 *
 * - 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03)
 * - 3dm-gx5-15: 4.3.3 Set Initial Heading (0x0D, 0x03)
 */
struct mip_filter_set_initial_heading {
    /**
     * Initial heading. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from
     * above.
     */
    float heading;
};

#define MIP_FILTER_SET_INITIAL_HEADING 0x0D03
#define MIP_FILTER_SET_INITIAL_HEADING_DESCRIPTOR 0x03
MIP_FIELD(mip_filter_set_initial_heading, 0x03);

/** Fills the structure, and returns it. */
static inline struct mip_filter_set_initial_heading *
mip_filter_set_initial_heading_make(struct mip_filter_set_initial_heading *command, float heading) {
    memset(command, 0, sizeof(*command));
    command->heading = heading;
    return command;
}

/**
 * Set initial attitude from IMU: command (0x0D,0x04).
 *
 * Initializes the filter's attitude from the complementary filter.
 *
 * No device is known for certain to support it. Also called `set_initial_heading_from_mag`. Affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles. Known only from the MIP SDK of 2014, MicroStrain Communication
 * Library and MicroStrain MIP SDK. Uncertain: The SDK calls it set initial heading from mag,
 * without a layout; the SDK of 2014 has this layout in its example for the 3DM-GX3-45. Uncertain:
 * No source lists the devices that support it.
 *
 * - mip-sdk-4: Set Initial Heading From Mag (0x0D,0x04)
 * - mip-sdk-2014: Set Initial Attitude From AHRS (0x0D,0x04)
 * - mscl: Set Initial Attitude From AHRS (0x0D,0x04)
 */
struct mip_filter_set_initial_attitude_from_imu {
    /**
     * Angle from true north to magnetic north. Unit: rad. Frame: ned. Range: -pi to pi. Positive:
     * magnetic north is east of true north. Uncertain: The sign is the usual one; no source states
     * it.
     */
    float declination;
};

#define MIP_FILTER_SET_INITIAL_ATTITUDE_FROM_IMU 0x0D04
#define MIP_FILTER_SET_INITIAL_ATTITUDE_FROM_IMU_DESCRIPTOR 0x04
MIP_FIELD(mip_filter_set_initial_attitude_from_imu, 0x04);

/** Fills the structure, and returns it. */
static inline struct mip_filter_set_initial_attitude_from_imu *
mip_filter_set_initial_attitude_from_imu_make(
    struct mip_filter_set_initial_attitude_from_imu *command, float declination) {
    memset(command, 0, sizeof(*command));
    command->declination = declination;
    return command;
}

/**
 * Run navigation filter: command (0x0D,0x05).
 *
 * Starts a filter that is configured to wait for this command.
 *
 * Affects mip_filter_data_status.
 *
 * The filter waits in its initialization state if `wait_for_run_command` of
 * mip_filter_initialization_config is set.
 *
 * - 3dm-cv7-gnss-ins: Run Navigation Filter (0x0D,0x05)
 */
struct mip_filter_run {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_RUN 0x0D05
#define MIP_FILTER_RUN_DESCRIPTOR 0x05
MIP_FIELD(mip_filter_run, 0x05);

/**
 * Vehicle dynamics mode: command (0x0D,0x10).
 *
 * Adapts the filter to the expected motion.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_vehicle_dynamics_mode_response. Probably affects MIP_FILTER_DATA_SET. Known only from
 * the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Vehicle dynamics mode (0x0D,0x10)
 */
struct mip_filter_vehicle_dynamics_mode {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Kind of vehicle. A value of enum mip_filter_dynamics_mode. Required for write. On the
     * 3DM-GX3-45: only MIP_FILTER_DYNAMICS_MODE_PORTABLE, MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE and
     * MIP_FILTER_DYNAMICS_MODE_AIRBORNE.
     */
    uint8_t mode;
};

#define MIP_FILTER_VEHICLE_DYNAMICS_MODE 0x0D10
#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_DESCRIPTOR 0x10
MIP_FIELD(mip_filter_vehicle_dynamics_mode, 0x10);
MIP_FILL(mip_filter_vehicle_dynamics_mode, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_vehicle_dynamics_mode, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_vehicle_dynamics_mode, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_vehicle_dynamics_mode, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_vehicle_dynamics_mode *mip_filter_vehicle_dynamics_mode_write(
    struct mip_filter_vehicle_dynamics_mode *command, enum mip_filter_dynamics_mode mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->mode = (uint8_t)mode;
    return command;
}

/**
 * Vehicle dynamics mode response: response (0x0D,0x80).
 *
 * Response to mip_filter_vehicle_dynamics_mode. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Vehicle dynamics mode (0x0D,0x10)
 */
struct mip_filter_vehicle_dynamics_mode_response {
    /** Kind of vehicle. A value of enum mip_filter_dynamics_mode. */
    uint8_t mode;
};

#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE 0x0D80
#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE_DESCRIPTOR 0x80
MIP_FIELD(mip_filter_vehicle_dynamics_mode_response, 0x80);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_vehicle_dynamics_mode *mip_filter_vehicle_dynamics_mode_write_from(
    struct mip_filter_vehicle_dynamics_mode *command,
    const struct mip_filter_vehicle_dynamics_mode_response *response) {
    return mip_filter_vehicle_dynamics_mode_write(command,
                                                  (enum mip_filter_dynamics_mode)response->mode);
}

/**
 * Sensor to vehicle frame transformation: command (0x0D,0x11).
 *
 * Sets the rotation from the sensor frame to the vehicle frame as Euler angles (5-series).
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_sensor_to_vehicle_rotation_euler_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate, mip_filter_data_gravity_vector
 * and mip_filter_data_comp_accel. Uncertain: The text of the manual lacks the formula; it is the
 * inverse of that of mip_3dm_sensor_to_vehicle_transform_euler, which the 3DM-CV7 manual states.
 *
 * The 3DM-CV7 uses the inverse instead: mip_3dm_sensor_to_vehicle_transform_euler.
 *
 * `v_sensor = Rz(yaw) * Ry(pitch) * Rx(roll) * v_vehicle`
 *
 * - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
 */
struct mip_filter_sensor_to_vehicle_rotation_euler {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Roll angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: right
     * side down. Required for write.
     */
    float roll;
    /**
     * Pitch angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: nose
     * up. Required for write.
     */
    float pitch;
    /**
     * Yaw angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive:
     * clockwise seen from above. Required for write.
     */
    float yaw;
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER 0x0D11
#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER_DESCRIPTOR 0x11
MIP_FIELD(mip_filter_sensor_to_vehicle_rotation_euler, 0x11);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_euler, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_euler, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_euler, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_euler, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_rotation_euler *
mip_filter_sensor_to_vehicle_rotation_euler_write(
    struct mip_filter_sensor_to_vehicle_rotation_euler *command, float roll, float pitch,
    float yaw) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->roll = roll;
    command->pitch = pitch;
    command->yaw = yaw;
    return command;
}

/**
 * Sensor to vehicle frame transformation response: response (0x0D,0x81).
 *
 * Response to mip_filter_sensor_to_vehicle_rotation_euler.
 *
 * - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
 */
struct mip_filter_sensor_to_vehicle_rotation_euler_response {
    /**
     * Roll angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: right
     * side down.
     */
    float roll;
    /**
     * Pitch angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive: nose
     * up.
     */
    float pitch;
    /**
     * Yaw angle of the vehicle relative to the sensor. Unit: rad. Frame: sensor. Positive:
     * clockwise seen from above.
     */
    float yaw;
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER_RESPONSE 0x0D81
#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_EULER_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_filter_sensor_to_vehicle_rotation_euler_response, 0x81);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_rotation_euler *
mip_filter_sensor_to_vehicle_rotation_euler_write_from(
    struct mip_filter_sensor_to_vehicle_rotation_euler *command,
    const struct mip_filter_sensor_to_vehicle_rotation_euler_response *response) {
    return mip_filter_sensor_to_vehicle_rotation_euler_write(command, response->roll,
                                                             response->pitch, response->yaw);
}

/**
 * Sensor to vehicle offset: command (0x0D,0x12).
 *
 * Sets the origin of the vehicle frame relative to the sensor.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_sensor_to_vehicle_offset_response. Affects mip_filter_data_llh_position. Known only
 * from the MicroStrain MIP SDK. Uncertain: The direction, from the sensor to the origin of the
 * vehicle frame, is inferred from the name.
 *
 * The shift is constant. It does not follow the attitude, as a lever arm would.
 *
 * - mip-sdk-4: Sensor to vehicle offset (0x0D,0x12)
 */
struct mip_filter_sensor_to_vehicle_offset {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Vector from the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m. Frame:
     * sensor. Range: magnitude at most 10. Required for write.
     */
    float offset[3];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET 0x0D12
#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_DESCRIPTOR 0x12
MIP_FIELD(mip_filter_sensor_to_vehicle_offset, 0x12);
MIP_FILL(mip_filter_sensor_to_vehicle_offset, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_sensor_to_vehicle_offset, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_sensor_to_vehicle_offset, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_sensor_to_vehicle_offset, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_offset *mip_filter_sensor_to_vehicle_offset_write(
    struct mip_filter_sensor_to_vehicle_offset *command, const float offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->offset, offset, sizeof(command->offset));
    return command;
}

/**
 * Sensor to vehicle offset response: response (0x0D,0x82).
 *
 * Response to mip_filter_sensor_to_vehicle_offset. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Sensor to vehicle offset (0x0D,0x12)
 */
struct mip_filter_sensor_to_vehicle_offset_response {
    /**
     * Vector from the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m. Frame:
     * sensor. Range: magnitude at most 10.
     */
    float offset[3];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE 0x0D82
#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_filter_sensor_to_vehicle_offset_response, 0x82);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_offset *
mip_filter_sensor_to_vehicle_offset_write_from(
    struct mip_filter_sensor_to_vehicle_offset *command,
    const struct mip_filter_sensor_to_vehicle_offset_response *response) {
    return mip_filter_sensor_to_vehicle_offset_write(command, response->offset);
}

/**
 * GNSS antenna offset: command (0x0D,0x13).
 *
 * Sets the position of the GNSS antenna relative to the origin of the sensor.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_antenna_offset_response.
 * Probably affects mip_filter_data_llh_position, mip_filter_data_ecef_position,
 * mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity and
 * mip_filter_data_antenna_offset_correction.
 *
 * 5-series devices expect the sensor frame.
 *
 * On the 3DM-CV7 it applies to GNSS data received as NMEA; data from the aiding commands uses
 * mip_aiding_frame_config.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
 */
struct mip_filter_antenna_offset {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Vector from the sensor origin to the phase centre of the antenna. Elements: x, y, z. Unit: m.
     * Frame: vehicle. Range: magnitude at most 10. Required for write. On the 3DM-CX5-45: frame
     * sensor (inferred: the manual of the 3DM-GX5-45 states it). On the 3DM-GX5-45: frame sensor.
     */
    float offset[3];
};

#define MIP_FILTER_ANTENNA_OFFSET 0x0D13
#define MIP_FILTER_ANTENNA_OFFSET_DESCRIPTOR 0x13
MIP_FIELD(mip_filter_antenna_offset, 0x13);
MIP_FILL(mip_filter_antenna_offset, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_antenna_offset, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_antenna_offset, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_antenna_offset, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_antenna_offset *
mip_filter_antenna_offset_write(struct mip_filter_antenna_offset *command, const float offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->offset, offset, sizeof(command->offset));
    return command;
}

/**
 * GNSS antenna offset response: response (0x0D,0x83).
 *
 * Response to mip_filter_antenna_offset.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
 */
struct mip_filter_antenna_offset_response {
    /**
     * Vector from the sensor origin to the phase centre of the antenna. Elements: x, y, z. Unit: m.
     * Frame: vehicle. Range: magnitude at most 10. On the 3DM-CX5-45: frame sensor (inferred: the
     * manual of the 3DM-GX5-45 states it). On the 3DM-GX5-45: frame sensor.
     */
    float offset[3];
};

#define MIP_FILTER_ANTENNA_OFFSET_RESPONSE 0x0D83
#define MIP_FILTER_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR 0x83
MIP_FIELD(mip_filter_antenna_offset_response, 0x83);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_antenna_offset *
mip_filter_antenna_offset_write_from(struct mip_filter_antenna_offset *command,
                                     const struct mip_filter_antenna_offset_response *response) {
    return mip_filter_antenna_offset_write(command, response->offset);
}

/**
 * Estimation control flags: command (0x0D,0x14).
 *
 * Selects the states that the filter estimates.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_estimation_control_response.
 * Affects mip_filter_data_gyro_bias, mip_filter_data_accel_bias, mip_filter_data_gyro_scale_factor,
 * mip_filter_data_accel_scale_factor, mip_filter_data_antenna_offset_correction,
 * mip_filter_data_mag_offset and mip_filter_data_mag_matrix. Probably affects
 * mip_filter_data_gyro_bias_uncertainty, mip_filter_data_accel_bias_uncertainty,
 * mip_filter_data_gyro_scale_factor_uncertainty, mip_filter_data_accel_scale_factor_uncertainty,
 * mip_filter_data_antenna_offset_correction_uncertainty, mip_filter_data_mag_offset_uncertainty and
 * mip_filter_data_mag_matrix_uncertainty.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 */
struct mip_filter_estimation_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * States to estimate. Required for write. On the 3DM-CV5-15, 3DM-CX5-15, 3DM-GX3-45,
     * 3DM-GX4-15, 3DM-GX4-25 and 3DM-GX5-15: only MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS. On the
     * 3DM-CV5-25, 3DM-CX5-25 and 3DM-GX5-25: only MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS,
     * MIP_FILTER_ESTIMATED_STATES_AUTO_HARD_IRON and MIP_FILTER_ESTIMATED_STATES_AUTO_SOFT_IRON. On
     * the 3DM-GQ4-45, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     * MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS, MIP_FILTER_ESTIMATED_STATES_ACCEL_BIAS,
     * MIP_FILTER_ESTIMATED_STATES_GYRO_SCALE_FACTOR, MIP_FILTER_ESTIMATED_STATES_ACCEL_SCALE_FACTOR
     * and MIP_FILTER_ESTIMATED_STATES_ANTENNA_OFFSET.
     */
    mip_filter_estimated_states flags;
};

#define MIP_FILTER_ESTIMATION_CONTROL 0x0D14
#define MIP_FILTER_ESTIMATION_CONTROL_DESCRIPTOR 0x14
MIP_FIELD(mip_filter_estimation_control, 0x14);
MIP_FILL(mip_filter_estimation_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_estimation_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_estimation_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_estimation_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_estimation_control *mip_filter_estimation_control_write(
    struct mip_filter_estimation_control *command, mip_filter_estimated_states flags) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->flags = flags;
    return command;
}

/**
 * Estimation control flags response: response (0x0D,0x84).
 *
 * Response to mip_filter_estimation_control.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 */
struct mip_filter_estimation_control_response {
    /** States to estimate. */
    mip_filter_estimated_states flags;
};

#define MIP_FILTER_ESTIMATION_CONTROL_RESPONSE 0x0D84
#define MIP_FILTER_ESTIMATION_CONTROL_RESPONSE_DESCRIPTOR 0x84
MIP_FIELD(mip_filter_estimation_control_response, 0x84);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_estimation_control *mip_filter_estimation_control_write_from(
    struct mip_filter_estimation_control *command,
    const struct mip_filter_estimation_control_response *response) {
    return mip_filter_estimation_control_write(command, response->flags);
}

/**
 * GNSS aiding source: command (0x0D,0x15).
 *
 * Selects the GNSS receiver that aids the filter.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_gnss_source_response.
 * Probably affects mip_filter_data_llh_position, mip_filter_data_ecef_position,
 * mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity and
 * mip_filter_data_gnss_position_aiding_status.
 *
 * A change while the filter is running may return it to initialization until the new source
 * provides data.
 *
 * - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
 */
struct mip_filter_gnss_source {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the GNSS data. A value of enum mip_filter_gnss_aiding_source. Required for write.
     * On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL.
     * On the 3DM-CX5-45, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     * MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL, MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL and
     * MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_1. On the 3DM-GX5-45: only
     * MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL and MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL.
     */
    uint8_t source;
};

#define MIP_FILTER_GNSS_SOURCE 0x0D15
#define MIP_FILTER_GNSS_SOURCE_DESCRIPTOR 0x15
MIP_FIELD(mip_filter_gnss_source, 0x15);
MIP_FILL(mip_filter_gnss_source, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_gnss_source, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_gnss_source, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_gnss_source, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_gnss_source *mip_filter_gnss_source_write(
    struct mip_filter_gnss_source *command, enum mip_filter_gnss_aiding_source source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    return command;
}

/**
 * GNSS aiding source response: response (0x0D,0x86).
 *
 * Response to mip_filter_gnss_source.
 *
 * - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
 */
struct mip_filter_gnss_source_response {
    /** Source of the GNSS data. A value of enum mip_filter_gnss_aiding_source. */
    uint8_t source;
};

#define MIP_FILTER_GNSS_SOURCE_RESPONSE 0x0D86
#define MIP_FILTER_GNSS_SOURCE_RESPONSE_DESCRIPTOR 0x86
MIP_FIELD(mip_filter_gnss_source_response, 0x86);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_gnss_source *
mip_filter_gnss_source_write_from(struct mip_filter_gnss_source *command,
                                  const struct mip_filter_gnss_source_response *response) {
    return mip_filter_gnss_source_write(command,
                                        (enum mip_filter_gnss_aiding_source)response->source);
}

/**
 * External GNSS update: command (0x0D,0x16).
 *
 * Sends one position and velocity measurement from your own GNSS receiver to the filter.
 *
 * Known only from the MicroStrain MIP SDK.
 *
 * The device rejects this command unless mip_filter_gnss_source selects the external source.
 *
 * The maximum rate depends on the device.
 *
 * - mip-sdk-4: External GNSS update (0x0D,0x16)
 */
struct mip_filter_external_gnss_update {
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week, counted without rollover. Unit: week. */
    uint16_t week_number;
    /** Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. */
    double latitude;
    /** Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. */
    double longitude;
    /** Height above the ellipsoid. Unit: m. Frame: llh. */
    double height;
    /** Velocity of the antenna. Elements: north, east, down. Unit: m/s. Frame: ned. */
    float velocity[3];
    /**
     * Standard deviation of the position. Elements: north, east, down. Unit: m. Frame: ned. Range:
     * at least 0.
     */
    float position_uncertainty[3];
    /**
     * Standard deviation of the velocity. Elements: north, east, down. Unit: m/s. Frame: ned.
     * Range: at least 0.
     */
    float velocity_uncertainty[3];
};

#define MIP_FILTER_EXTERNAL_GNSS_UPDATE 0x0D16
#define MIP_FILTER_EXTERNAL_GNSS_UPDATE_DESCRIPTOR 0x16
MIP_FIELD(mip_filter_external_gnss_update, 0x16);

/** Fills the structure, and returns it. */
static inline struct mip_filter_external_gnss_update *mip_filter_external_gnss_update_make(
    struct mip_filter_external_gnss_update *command, double tow, uint16_t week_number,
    double latitude, double longitude, double height, const float velocity[3],
    const float position_uncertainty[3], const float velocity_uncertainty[3]) {
    memset(command, 0, sizeof(*command));
    command->tow = tow;
    command->week_number = week_number;
    command->latitude = latitude;
    command->longitude = longitude;
    command->height = height;
    memcpy(command->velocity, velocity, sizeof(command->velocity));
    memcpy(command->position_uncertainty, position_uncertainty,
           sizeof(command->position_uncertainty));
    memcpy(command->velocity_uncertainty, velocity_uncertainty,
           sizeof(command->velocity_uncertainty));
    return command;
}

/**
 * External heading update: command (0x0D,0x17).
 *
 * Sends one measurement of the heading of the sensor frame in the NED frame to the filter.
 *
 * The device rejects this command unless external heading updates are enabled, by
 * mip_filter_heading_source on the 3DM-GX5 and by mip_filter_aiding_measurement_enable on the
 * 3DM-CV7.
 *
 * The 3DM-GX5-15 accepts at most 20 updates per second.
 *
 * If the declination source is not valid, -25 models reject true headings and -45 models magnetic
 * ones.
 *
 * - 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17)
 * - 3dm-gx5-15: 4.3.7 External Heading Update (0x0D, 0x17)
 */
struct mip_filter_external_heading_update {
    /**
     * Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range: -pi to pi.
     * Positive: clockwise seen from above.
     */
    float heading;
    /**
     * Standard deviation; the device rejects values out of range. Unit: rad. Range: greater than 0.
     */
    float heading_uncertainty;
    /** North that the heading refers to. A value of enum mip_filter_heading_type. */
    uint8_t type;
};

#define MIP_FILTER_EXTERNAL_HEADING_UPDATE 0x0D17
#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_DESCRIPTOR 0x17
MIP_FIELD(mip_filter_external_heading_update, 0x17);

/** Fills the structure, and returns it. */
static inline struct mip_filter_external_heading_update *mip_filter_external_heading_update_make(
    struct mip_filter_external_heading_update *command, float heading, float heading_uncertainty,
    enum mip_filter_heading_type type) {
    memset(command, 0, sizeof(*command));
    command->heading = heading;
    command->heading_uncertainty = heading_uncertainty;
    command->type = (uint8_t)type;
    return command;
}

/**
 * Heading update control: command (0x0D,0x18).
 *
 * Selects the source of the heading that aids the filter.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_heading_source_response.
 * Affects mip_filter_data_heading_update_state. Probably affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 */
struct mip_filter_heading_source {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the heading. A value of enum mip_filter_heading_update_source. Required for write.
     * On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE and
     * MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL. On the 3DM-CV5-25, 3DM-CX5-25, 3DM-GX4-25 and
     * 3DM-GX5-25: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE, MIP_FILTER_HEADING_UPDATE_SOURCE_MAG
     * and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL. On the 3DM-GQ4-45, 3DM-GX3-45 and 3DM-GX4-45:
     * only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE, MIP_FILTER_HEADING_UPDATE_SOURCE_MAG,
     * MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL.
     * On the 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE,
     * MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL.
     */
    uint8_t source;
};

#define MIP_FILTER_HEADING_SOURCE 0x0D18
#define MIP_FILTER_HEADING_SOURCE_DESCRIPTOR 0x18
MIP_FIELD(mip_filter_heading_source, 0x18);
MIP_FILL(mip_filter_heading_source, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_heading_source, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_heading_source, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_heading_source, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_heading_source *mip_filter_heading_source_write(
    struct mip_filter_heading_source *command, enum mip_filter_heading_update_source source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    return command;
}

/**
 * Heading update control response: response (0x0D,0x87).
 *
 * Response to mip_filter_heading_source.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 */
struct mip_filter_heading_source_response {
    /** Source of the heading. A value of enum mip_filter_heading_update_source. */
    uint8_t source;
};

#define MIP_FILTER_HEADING_SOURCE_RESPONSE 0x0D87
#define MIP_FILTER_HEADING_SOURCE_RESPONSE_DESCRIPTOR 0x87
MIP_FIELD(mip_filter_heading_source_response, 0x87);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_heading_source *
mip_filter_heading_source_write_from(struct mip_filter_heading_source *command,
                                     const struct mip_filter_heading_source_response *response) {
    return mip_filter_heading_source_write(command,
                                           (enum mip_filter_heading_update_source)response->source);
}

/**
 * Automatic initialization: command (0x0D,0x19).
 *
 * Sets whether the filter initializes automatically at power-up.
 *
 * Also called `auto_init_control`. Functions: write, read, save, load and default. Response:
 * mip_filter_auto_initialization_control_response.
 *
 * Automatic initialization needs a valid heading source.
 *
 * - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
 */
struct mip_filter_auto_initialization_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
};

#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL 0x0D19
#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_DESCRIPTOR 0x19
MIP_FIELD(mip_filter_auto_initialization_control, 0x19);
MIP_FILL(mip_filter_auto_initialization_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_auto_initialization_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_auto_initialization_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_auto_initialization_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_auto_initialization_control *
mip_filter_auto_initialization_control_write(struct mip_filter_auto_initialization_control *command,
                                             uint8_t enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    return command;
}

/**
 * Automatic initialization response: response (0x0D,0x88).
 *
 * Also called `auto_init_control_response`. Response to mip_filter_auto_initialization_control.
 *
 * - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
 */
struct mip_filter_auto_initialization_control_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE 0x0D88
#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE_DESCRIPTOR 0x88
MIP_FIELD(mip_filter_auto_initialization_control_response, 0x88);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_auto_initialization_control *
mip_filter_auto_initialization_control_write_from(
    struct mip_filter_auto_initialization_control *command,
    const struct mip_filter_auto_initialization_control_response *response) {
    return mip_filter_auto_initialization_control_write(command, response->enable);
}

/**
 * Accelerometer noise: command (0x0D,0x1A).
 *
 * Sets the standard deviation of the accelerometer noise that the filter assumes (process noise).
 *
 * Functions: write, read, save, load and default. Response: mip_filter_accel_noise_response.
 * Probably affects mip_filter_data_llh_position_uncertainty,
 * mip_filter_data_ecef_position_uncertainty, mip_filter_data_ned_velocity_uncertainty,
 * mip_filter_data_ecef_velocity_uncertainty and mip_filter_data_accel_bias_uncertainty.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
 * - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
 */
struct mip_filter_accel_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_ACCEL_NOISE 0x0D1A
#define MIP_FILTER_ACCEL_NOISE_DESCRIPTOR 0x1A
MIP_FIELD(mip_filter_accel_noise, 0x1A);
MIP_FILL(mip_filter_accel_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_accel_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_accel_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_accel_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_accel_noise *
mip_filter_accel_noise_write(struct mip_filter_accel_noise *command, const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Accelerometer noise response: response (0x0D,0x89).
 *
 * Response to mip_filter_accel_noise.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
 * - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
 */
struct mip_filter_accel_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_ACCEL_NOISE_RESPONSE 0x0D89
#define MIP_FILTER_ACCEL_NOISE_RESPONSE_DESCRIPTOR 0x89
MIP_FIELD(mip_filter_accel_noise_response, 0x89);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_accel_noise *
mip_filter_accel_noise_write_from(struct mip_filter_accel_noise *command,
                                  const struct mip_filter_accel_noise_response *response) {
    return mip_filter_accel_noise_write(command, response->noise);
}

/**
 * Gyroscope noise: command (0x0D,0x1B).
 *
 * Sets the standard deviation of the gyroscope noise that the filter assumes (process noise).
 *
 * Functions: write, read, save, load and default. Response: mip_filter_gyro_noise_response.
 * Probably affects mip_filter_data_euler_angles_uncertainty,
 * mip_filter_data_quaternion_attitude_uncertainty and mip_filter_data_gyro_bias_uncertainty.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
 * - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
 */
struct mip_filter_gyro_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_GYRO_NOISE 0x0D1B
#define MIP_FILTER_GYRO_NOISE_DESCRIPTOR 0x1B
MIP_FIELD(mip_filter_gyro_noise, 0x1B);
MIP_FILL(mip_filter_gyro_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_gyro_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_gyro_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_gyro_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_gyro_noise *
mip_filter_gyro_noise_write(struct mip_filter_gyro_noise *command, const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Gyroscope noise response: response (0x0D,0x8A).
 *
 * Response to mip_filter_gyro_noise.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
 * - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
 */
struct mip_filter_gyro_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_GYRO_NOISE_RESPONSE 0x0D8A
#define MIP_FILTER_GYRO_NOISE_RESPONSE_DESCRIPTOR 0x8A
MIP_FIELD(mip_filter_gyro_noise_response, 0x8A);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_gyro_noise *mip_filter_gyro_noise_write_from(
    struct mip_filter_gyro_noise *command, const struct mip_filter_gyro_noise_response *response) {
    return mip_filter_gyro_noise_write(command, response->noise);
}

/**
 * Accelerometer bias model: command (0x0D,0x1C).
 *
 * Sets the parameters of the accelerometer bias drift model.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_accel_bias_model_response.
 * Probably affects mip_filter_data_accel_bias and mip_filter_data_accel_bias_uncertainty.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
 */
struct mip_filter_accel_bias_model {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. Required for
     * write.
     */
    float beta[3];
    /**
     * Standard deviation of the noise per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than
     * 0. Required for write.
     */
    float noise[3];
};

#define MIP_FILTER_ACCEL_BIAS_MODEL 0x0D1C
#define MIP_FILTER_ACCEL_BIAS_MODEL_DESCRIPTOR 0x1C
MIP_FIELD(mip_filter_accel_bias_model, 0x1C);
MIP_FILL(mip_filter_accel_bias_model, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_accel_bias_model, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_accel_bias_model, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_accel_bias_model, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_accel_bias_model *mip_filter_accel_bias_model_write(
    struct mip_filter_accel_bias_model *command, const float beta[3], const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->beta, beta, sizeof(command->beta));
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Accelerometer bias model response: response (0x0D,0x8B).
 *
 * Response to mip_filter_accel_bias_model.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
 */
struct mip_filter_accel_bias_model_response {
    /** Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. */
    float beta[3];
    /**
     * Standard deviation of the noise per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than
     * 0.
     */
    float noise[3];
};

#define MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE 0x0D8B
#define MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE_DESCRIPTOR 0x8B
MIP_FIELD(mip_filter_accel_bias_model_response, 0x8B);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_accel_bias_model *mip_filter_accel_bias_model_write_from(
    struct mip_filter_accel_bias_model *command,
    const struct mip_filter_accel_bias_model_response *response) {
    return mip_filter_accel_bias_model_write(command, response->beta, response->noise);
}

/**
 * Gyroscope bias model: command (0x0D,0x1D).
 *
 * Sets the parameters of the gyroscope bias drift model.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_gyro_bias_model_response.
 * Probably affects mip_filter_data_gyro_bias and mip_filter_data_gyro_bias_uncertainty.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
 * - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
 */
struct mip_filter_gyro_bias_model {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. Required for
     * write.
     */
    float beta[3];
    /**
     * Standard deviation of the noise per axis. Elements: x, y, z. Unit: rad/s. Range: greater than
     * 0. Required for write.
     */
    float noise[3];
};

#define MIP_FILTER_GYRO_BIAS_MODEL 0x0D1D
#define MIP_FILTER_GYRO_BIAS_MODEL_DESCRIPTOR 0x1D
MIP_FIELD(mip_filter_gyro_bias_model, 0x1D);
MIP_FILL(mip_filter_gyro_bias_model, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_gyro_bias_model, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_gyro_bias_model, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_gyro_bias_model, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_gyro_bias_model *mip_filter_gyro_bias_model_write(
    struct mip_filter_gyro_bias_model *command, const float beta[3], const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->beta, beta, sizeof(command->beta));
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Gyroscope bias model response: response (0x0D,0x8C).
 *
 * Response to mip_filter_gyro_bias_model.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
 * - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
 */
struct mip_filter_gyro_bias_model_response {
    /** Reciprocal of the correlation time per axis. Elements: x, y, z. Unit: 1/s. */
    float beta[3];
    /**
     * Standard deviation of the noise per axis. Elements: x, y, z. Unit: rad/s. Range: greater than
     * 0.
     */
    float noise[3];
};

#define MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE 0x0D8C
#define MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE_DESCRIPTOR 0x8C
MIP_FIELD(mip_filter_gyro_bias_model_response, 0x8C);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_gyro_bias_model *
mip_filter_gyro_bias_model_write_from(struct mip_filter_gyro_bias_model *command,
                                      const struct mip_filter_gyro_bias_model_response *response) {
    return mip_filter_gyro_bias_model_write(command, response->beta, response->noise);
}

/**
 * Automatic zero velocity update: command (0x0D,0x1E).
 *
 * Sets whether the filter assumes that the device is at rest while its GNSS speed is low.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_auto_zupt_response. Probably
 * affects mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity,
 * mip_filter_data_ned_velocity_uncertainty and mip_filter_data_ecef_velocity_uncertainty. Known
 * only from the MicroStrain MIP SDK.
 *
 * The update applies while the magnitude of the GNSS velocity vector is at or below the threshold.
 *
 * - mip-sdk-4: Auto Zupt (0x0D,0x1E)
 */
struct mip_filter_auto_zupt {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /** Highest speed that is treated as zero. Unit: m/s. Range: at least 0. Required for write. */
    float threshold;
};

#define MIP_FILTER_AUTO_ZUPT 0x0D1E
#define MIP_FILTER_AUTO_ZUPT_DESCRIPTOR 0x1E
MIP_FIELD(mip_filter_auto_zupt, 0x1E);
MIP_FILL(mip_filter_auto_zupt, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_auto_zupt, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_auto_zupt, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_auto_zupt, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_auto_zupt *
mip_filter_auto_zupt_write(struct mip_filter_auto_zupt *command, uint8_t enable, float threshold) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    command->threshold = threshold;
    return command;
}

/**
 * Automatic zero velocity update response: response (0x0D,0x8D).
 *
 * Response to mip_filter_auto_zupt. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Auto Zupt (0x0D,0x1E)
 */
struct mip_filter_auto_zupt_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Highest speed that is treated as zero. Unit: m/s. Range: at least 0. */
    float threshold;
};

#define MIP_FILTER_AUTO_ZUPT_RESPONSE 0x0D8D
#define MIP_FILTER_AUTO_ZUPT_RESPONSE_DESCRIPTOR 0x8D
MIP_FIELD(mip_filter_auto_zupt_response, 0x8D);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_auto_zupt *mip_filter_auto_zupt_write_from(
    struct mip_filter_auto_zupt *command, const struct mip_filter_auto_zupt_response *response) {
    return mip_filter_auto_zupt_write(command, response->enable, response->threshold);
}

/**
 * External heading update with time: command (0x0D,0x1F).
 *
 * Sends one measurement of the heading of the sensor frame with its GPS time to the filter.
 *
 * It is better than mip_filter_external_heading_update if the heading changes quickly; the time
 * must be accurate.
 *
 * The device rejects this command unless external heading updates are enabled, by
 * mip_filter_heading_source on the 3DM-GX5 and by mip_filter_aiding_measurement_enable on the
 * 3DM-CV7.
 *
 * The 3DM-GX5-15 accepts at most 20 updates per second.
 *
 * If the declination source is not valid, -25 models reject true headings and -45 models magnetic
 * ones.
 *
 * - 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F)
 * - 3dm-gx5-15: 4.3.8 External Heading Update with Timestamp (0x0D, 0x1F)
 */
struct mip_filter_external_heading_update_with_time {
    /** GPS time of week of the measurement. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week, counted without rollover. Unit: week. */
    uint16_t week_number;
    /**
     * Heading relative to the north selected by `type`. Unit: rad. Frame: ned. Range: -pi to pi.
     * Positive: clockwise seen from above.
     */
    float heading;
    /**
     * Standard deviation; the device rejects values out of range. Unit: rad. Range: greater than 0.
     */
    float heading_uncertainty;
    /** North that the heading refers to. A value of enum mip_filter_heading_type. */
    uint8_t type;
};

#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME 0x0D1F
#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME_DESCRIPTOR 0x1F
MIP_FIELD(mip_filter_external_heading_update_with_time, 0x1F);

/** Fills the structure, and returns it. */
static inline struct mip_filter_external_heading_update_with_time *
mip_filter_external_heading_update_with_time_make(
    struct mip_filter_external_heading_update_with_time *command, double tow, uint16_t week_number,
    float heading, float heading_uncertainty, enum mip_filter_heading_type type) {
    memset(command, 0, sizeof(*command));
    command->tow = tow;
    command->week_number = week_number;
    command->heading = heading;
    command->heading_uncertainty = heading_uncertainty;
    command->type = (uint8_t)type;
    return command;
}

/**
 * Zero angular rate update: command (0x0D,0x20).
 *
 * Sets whether the filter assumes that the device is not rotating while its angular rate is low.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_auto_angular_zupt_response.
 * Probably affects mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm,
 * mip_filter_data_euler_angles, mip_filter_data_gyro_bias and
 * mip_filter_data_gyro_bias_uncertainty.
 *
 * The update applies while the magnitude of the angular rate vector is at or below the threshold.
 *
 * - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
 * - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
 */
struct mip_filter_auto_angular_zupt {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Highest angular rate that is treated as zero. Unit: rad/s. Range: at least 0. Required for
     * write.
     */
    float threshold;
};

#define MIP_FILTER_AUTO_ANGULAR_ZUPT 0x0D20
#define MIP_FILTER_AUTO_ANGULAR_ZUPT_DESCRIPTOR 0x20
MIP_FIELD(mip_filter_auto_angular_zupt, 0x20);
MIP_FILL(mip_filter_auto_angular_zupt, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_auto_angular_zupt, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_auto_angular_zupt, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_auto_angular_zupt, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_auto_angular_zupt *mip_filter_auto_angular_zupt_write(
    struct mip_filter_auto_angular_zupt *command, uint8_t enable, float threshold) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    command->threshold = threshold;
    return command;
}

/**
 * Zero angular rate update response: response (0x0D,0x8E).
 *
 * Response to mip_filter_auto_angular_zupt.
 *
 * - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
 * - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
 */
struct mip_filter_auto_angular_zupt_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Highest angular rate that is treated as zero. Unit: rad/s. Range: at least 0. */
    float threshold;
};

#define MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE 0x0D8E
#define MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE_DESCRIPTOR 0x8E
MIP_FIELD(mip_filter_auto_angular_zupt_response, 0x8E);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_auto_angular_zupt *mip_filter_auto_angular_zupt_write_from(
    struct mip_filter_auto_angular_zupt *command,
    const struct mip_filter_auto_angular_zupt_response *response) {
    return mip_filter_auto_angular_zupt_write(command, response->enable, response->threshold);
}

/**
 * Tare orientation: command (0x0D,0x21).
 *
 * Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_tare_orientation_response.
 * Affects mip_sensor_scaled_accel, mip_sensor_scaled_gyro, mip_sensor_scaled_mag,
 * mip_sensor_delta_theta, mip_sensor_delta_velocity, mip_filter_data_attitude_quaternion,
 * mip_filter_data_attitude_dcm, mip_filter_data_euler_angles, mip_filter_data_linear_accel,
 * mip_filter_data_comp_angular_rate, mip_filter_data_gravity_vector and mip_filter_data_comp_accel.
 * On the 3DM-GX5-15: write, save, load and default only. On the 3DM-GX5-45: write, save, load and
 * default only.
 *
 * The device rejects this command while the filter has no valid attitude.
 *
 * - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
 * - mip-sdk-4: Tare orientation (0x0D,0x21)
 */
struct mip_filter_tare_orientation {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Axes to tare; 0 resets all axes. Required for write. */
    mip_filter_tare_axes axes;
};

#define MIP_FILTER_TARE_ORIENTATION 0x0D21
#define MIP_FILTER_TARE_ORIENTATION_DESCRIPTOR 0x21
MIP_FIELD(mip_filter_tare_orientation, 0x21);
MIP_FILL(mip_filter_tare_orientation, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_tare_orientation, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_tare_orientation, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_tare_orientation, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_tare_orientation *mip_filter_tare_orientation_write(
    struct mip_filter_tare_orientation *command, mip_filter_tare_axes axes) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->axes = axes;
    return command;
}

/**
 * Tare orientation response: response (0x0D,0xA1).
 *
 * Response to mip_filter_tare_orientation. Uncertain: The SDK reads the setting back; the manuals
 * of the 3DM-GX5-15 and 3DM-GX5-45 have neither the read function nor the response.
 *
 * - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
 * - mip-sdk-4: Tare orientation (0x0D,0x21)
 */
struct mip_filter_tare_orientation_response {
    /** Axes that are tared. */
    mip_filter_tare_axes axes;
};

#define MIP_FILTER_TARE_ORIENTATION_RESPONSE 0x0DA1
#define MIP_FILTER_TARE_ORIENTATION_RESPONSE_DESCRIPTOR 0xA1
MIP_FIELD(mip_filter_tare_orientation_response, 0xA1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_tare_orientation *mip_filter_tare_orientation_write_from(
    struct mip_filter_tare_orientation *command,
    const struct mip_filter_tare_orientation_response *response) {
    return mip_filter_tare_orientation_write(command, response->axes);
}

/**
 * Commanded zero velocity update: command (0x0D,0x22).
 *
 * Informs the filter once that the device is at rest.
 *
 * Probably affects mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity,
 * mip_filter_data_ned_velocity_uncertainty and mip_filter_data_ecef_velocity_uncertainty. Known
 * only from the MicroStrain MIP SDK.
 *
 * The maximum rate depends on the device.
 *
 * - mip-sdk-4: Commanded Zupt (0x0D,0x22)
 */
struct mip_filter_commanded_zupt {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_COMMANDED_ZUPT 0x0D22
#define MIP_FILTER_COMMANDED_ZUPT_DESCRIPTOR 0x22
MIP_FIELD(mip_filter_commanded_zupt, 0x22);

/**
 * Commanded zero angular rate update: command (0x0D,0x23).
 *
 * Informs the filter once that the device is not rotating.
 *
 * Probably affects mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm,
 * mip_filter_data_euler_angles, mip_filter_data_gyro_bias and
 * mip_filter_data_gyro_bias_uncertainty.
 *
 * At most 10 per second.
 *
 * - 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23)
 */
struct mip_filter_commanded_angular_zupt {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_COMMANDED_ANGULAR_ZUPT 0x0D23
#define MIP_FILTER_COMMANDED_ANGULAR_ZUPT_DESCRIPTOR 0x23
MIP_FIELD(mip_filter_commanded_angular_zupt, 0x23);

/**
 * Set reference position: command (0x0D,0x26).
 *
 * Sets the position for which the device computes gravity (WGS84) and the magnetic field (WMM2015).
 *
 * Functions: write, read, save, load and default. Response: mip_filter_reference_position_response.
 * Affects mip_filter_data_wgs84_gravity_magnitude and mip_filter_data_magnetic_model.
 *
 * - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
 */
struct mip_filter_reference_position {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Required for
     * write.
     */
    double latitude;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Required for
     * write.
     */
    double longitude;
    /**
     * Altitude of the reference position. Unit: m. Required for write. Uncertain: The reference,
     * ellipsoid or sea level, is inferred. The manual does not state it; its glossary counts
     * altitudes from sea level.
     */
    double altitude;
};

#define MIP_FILTER_REFERENCE_POSITION 0x0D26
#define MIP_FILTER_REFERENCE_POSITION_DESCRIPTOR 0x26
MIP_FIELD(mip_filter_reference_position, 0x26);
MIP_FILL(mip_filter_reference_position, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_reference_position, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_reference_position, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_reference_position, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_reference_position *
mip_filter_reference_position_write(struct mip_filter_reference_position *command, uint8_t enable,
                                    double latitude, double longitude, double altitude) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    command->latitude = latitude;
    command->longitude = longitude;
    command->altitude = altitude;
    return command;
}

/**
 * Set reference position response: response (0x0D,0x90).
 *
 * Response to mip_filter_reference_position.
 *
 * - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
 */
struct mip_filter_reference_position_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. */
    double latitude;
    /** Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. */
    double longitude;
    /**
     * Altitude of the reference position. Unit: m. Uncertain: The reference, ellipsoid or sea
     * level, is inferred. The manual does not state it; its glossary counts altitudes from sea
     * level.
     */
    double altitude;
};

#define MIP_FILTER_REFERENCE_POSITION_RESPONSE 0x0D90
#define MIP_FILTER_REFERENCE_POSITION_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_filter_reference_position_response, 0x90);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_reference_position *mip_filter_reference_position_write_from(
    struct mip_filter_reference_position *command,
    const struct mip_filter_reference_position_response *response) {
    return mip_filter_reference_position_write(command, response->enable, response->latitude,
                                               response->longitude, response->altitude);
}

/**
 * Capture automatic magnetometer calibration: command (0x0D,0x27).
 *
 * Moves the result of the automatic magnetometer calibration into the fixed calibration.
 *
 * Also called `mag_capture_auto_cal`. Functions: write and save. Affects mip_sensor_scaled_mag,
 * mip_filter_data_mag_offset and mip_filter_data_mag_matrix. Known only from the MicroStrain MIP
 * SDK. Requires a magnetometer.
 *
 * A write combines the automatic calibration with mip_3dm_mag_hard_iron_offset and
 * mip_3dm_mag_soft_iron_matrix, then resets the automatic calibration.
 *
 * A save has the same effect as saving both of these settings.
 *
 * - mip-sdk-4: Mag Capture Auto Cal (0x0D,0x27)
 */
struct mip_filter_mag_capture_auto_calibration {
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
};

#define MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION 0x0D27
#define MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION_DESCRIPTOR 0x27
MIP_FIELD(mip_filter_mag_capture_auto_calibration, 0x27);
MIP_FILL(mip_filter_mag_capture_auto_calibration, write, MIP_FUNCTION_SELECTOR_WRITE);
MIP_FILL(mip_filter_mag_capture_auto_calibration, save, MIP_FUNCTION_SELECTOR_SAVE);

/**
 * Gravity noise: command (0x0D,0x28).
 *
 * Sets the standard deviation of the gravity noise that the filter assumes (process noise).
 *
 * Functions: write, read, save, load and default. Response: mip_filter_gravity_noise_response.
 * Probably affects mip_filter_data_euler_angles_uncertainty and
 * mip_filter_data_quaternion_attitude_uncertainty.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
 * - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
 */
struct mip_filter_gravity_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. Required for
     * write.
     */
    float noise[3];
};

#define MIP_FILTER_GRAVITY_NOISE 0x0D28
#define MIP_FILTER_GRAVITY_NOISE_DESCRIPTOR 0x28
MIP_FIELD(mip_filter_gravity_noise, 0x28);
MIP_FILL(mip_filter_gravity_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_gravity_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_gravity_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_gravity_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_gravity_noise *
mip_filter_gravity_noise_write(struct mip_filter_gravity_noise *command, const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Gravity noise response: response (0x0D,0x93).
 *
 * Response to mip_filter_gravity_noise.
 *
 * - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
 * - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
 */
struct mip_filter_gravity_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_GRAVITY_NOISE_RESPONSE 0x0D93
#define MIP_FILTER_GRAVITY_NOISE_RESPONSE_DESCRIPTOR 0x93
MIP_FIELD(mip_filter_gravity_noise_response, 0x93);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_gravity_noise *
mip_filter_gravity_noise_write_from(struct mip_filter_gravity_noise *command,
                                    const struct mip_filter_gravity_noise_response *response) {
    return mip_filter_gravity_noise_write(command, response->noise);
}

/**
 * Pressure altitude noise: command (0x0D,0x29).
 *
 * Sets the standard deviation of the pressure altitude noise that the filter assumes.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_pressure_altitude_noise_response. Probably affects mip_filter_data_llh_position and
 * mip_filter_data_llh_position_uncertainty. Known only from the MicroStrain MIP SDK. Requires a
 * pressure sensor.
 *
 * With a small value, the altitude follows the pressure faster, but weather and draughts appear as
 * changes of height.
 *
 * - mip-sdk-4: Pressure altitude noise (0x0D,0x29)
 */
struct mip_filter_pressure_altitude_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation of the pressure altitude noise. Unit: m. Range: greater than 0. Required
     * for write.
     */
    float noise;
};

#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE 0x0D29
#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_DESCRIPTOR 0x29
MIP_FIELD(mip_filter_pressure_altitude_noise, 0x29);
MIP_FILL(mip_filter_pressure_altitude_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_pressure_altitude_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_pressure_altitude_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_pressure_altitude_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_pressure_altitude_noise *mip_filter_pressure_altitude_noise_write(
    struct mip_filter_pressure_altitude_noise *command, float noise) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->noise = noise;
    return command;
}

/**
 * Pressure altitude noise response: response (0x0D,0x94).
 *
 * Response to mip_filter_pressure_altitude_noise. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Pressure altitude noise (0x0D,0x29)
 */
struct mip_filter_pressure_altitude_noise_response {
    /** Standard deviation of the pressure altitude noise. Unit: m. Range: greater than 0. */
    float noise;
};

#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE 0x0D94
#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE_DESCRIPTOR 0x94
MIP_FIELD(mip_filter_pressure_altitude_noise_response, 0x94);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_pressure_altitude_noise *
mip_filter_pressure_altitude_noise_write_from(
    struct mip_filter_pressure_altitude_noise *command,
    const struct mip_filter_pressure_altitude_noise_response *response) {
    return mip_filter_pressure_altitude_noise_write(command, response->noise);
}

/**
 * Hard iron offset noise: command (0x0D,0x2B).
 *
 * Sets the standard deviation of the noise of the estimated hard iron offset (process noise).
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_hard_iron_offset_noise_response. Probably affects mip_filter_data_mag_offset and
 * mip_filter_data_mag_offset_uncertainty. Known only from the MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * - mip-sdk-4: Hard iron offset noise (0x0D,0x2B)
 */
struct mip_filter_hard_iron_offset_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_HARD_IRON_OFFSET_NOISE 0x0D2B
#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_DESCRIPTOR 0x2B
MIP_FIELD(mip_filter_hard_iron_offset_noise, 0x2B);
MIP_FILL(mip_filter_hard_iron_offset_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_hard_iron_offset_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_hard_iron_offset_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_hard_iron_offset_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_hard_iron_offset_noise *mip_filter_hard_iron_offset_noise_write(
    struct mip_filter_hard_iron_offset_noise *command, const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Hard iron offset noise response: response (0x0D,0x96).
 *
 * Response to mip_filter_hard_iron_offset_noise. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Hard iron offset noise (0x0D,0x2B)
 */
struct mip_filter_hard_iron_offset_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE 0x0D96
#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE_DESCRIPTOR 0x96
MIP_FIELD(mip_filter_hard_iron_offset_noise_response, 0x96);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_hard_iron_offset_noise *
mip_filter_hard_iron_offset_noise_write_from(
    struct mip_filter_hard_iron_offset_noise *command,
    const struct mip_filter_hard_iron_offset_noise_response *response) {
    return mip_filter_hard_iron_offset_noise_write(command, response->noise);
}

/**
 * Soft iron matrix noise: command (0x0D,0x2C).
 *
 * Sets the standard deviation of the noise of the estimated soft iron matrix (process noise).
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_soft_iron_matrix_noise_response. Probably affects mip_filter_data_mag_matrix and
 * mip_filter_data_mag_matrix_uncertainty. Known only from the MicroStrain MIP SDK. Requires a
 * magnetometer.
 *
 * - mip-sdk-4: Soft iron matrix noise (0x0D,0x2C)
 */
struct mip_filter_soft_iron_matrix_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1. Range: greater than 0. Required for write.
     */
    float noise[9];
};

#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE 0x0D2C
#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_DESCRIPTOR 0x2C
MIP_FIELD(mip_filter_soft_iron_matrix_noise, 0x2C);
MIP_FILL(mip_filter_soft_iron_matrix_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_soft_iron_matrix_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_soft_iron_matrix_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_soft_iron_matrix_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_soft_iron_matrix_noise *mip_filter_soft_iron_matrix_noise_write(
    struct mip_filter_soft_iron_matrix_noise *command, const float noise[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Soft iron matrix noise response: response (0x0D,0x97).
 *
 * Response to mip_filter_soft_iron_matrix_noise. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Soft iron matrix noise (0x0D,0x2C)
 */
struct mip_filter_soft_iron_matrix_noise_response {
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1. Range: greater than 0.
     */
    float noise[9];
};

#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE 0x0D97
#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE_DESCRIPTOR 0x97
MIP_FIELD(mip_filter_soft_iron_matrix_noise_response, 0x97);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_soft_iron_matrix_noise *
mip_filter_soft_iron_matrix_noise_write_from(
    struct mip_filter_soft_iron_matrix_noise *command,
    const struct mip_filter_soft_iron_matrix_noise_response *response) {
    return mip_filter_soft_iron_matrix_noise_write(command, response->noise);
}

/**
 * Enable or disable measurements: command (0x0D,0x41).
 *
 * Selects the inertial measurements that the filter uses.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_enable_measurements_response. Probably affects mip_filter_data_attitude_quaternion,
 * mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_euler_angles_uncertainty and mip_filter_data_quaternion_attitude_uncertainty.
 *
 * - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
 */
struct mip_filter_enable_measurements {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Measurements to use. Required for write. On the 3DM-CV5-15, 3DM-CX5-15 and 3DM-GX5-15: only
     * MIP_FILTER_MEASUREMENT_FLAGS_ACCEL.
     */
    mip_filter_measurement_flags control;
};

#define MIP_FILTER_ENABLE_MEASUREMENTS 0x0D41
#define MIP_FILTER_ENABLE_MEASUREMENTS_DESCRIPTOR 0x41
MIP_FIELD(mip_filter_enable_measurements, 0x41);
MIP_FILL(mip_filter_enable_measurements, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_enable_measurements, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_enable_measurements, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_enable_measurements, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_enable_measurements *mip_filter_enable_measurements_write(
    struct mip_filter_enable_measurements *command, mip_filter_measurement_flags control) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->control = control;
    return command;
}

/**
 * Enable or disable measurements response: response (0x0D,0xB0).
 *
 * Response to mip_filter_enable_measurements.
 *
 * - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
 */
struct mip_filter_enable_measurements_response {
    /** Measurements to use. */
    mip_filter_measurement_flags control;
};

#define MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE 0x0DB0
#define MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE_DESCRIPTOR 0xB0
MIP_FIELD(mip_filter_enable_measurements_response, 0xB0);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_enable_measurements *mip_filter_enable_measurements_write_from(
    struct mip_filter_enable_measurements *command,
    const struct mip_filter_enable_measurements_response *response) {
    return mip_filter_enable_measurements_write(command, response->control);
}

/**
 * Magnetometer noise: command (0x0D,0x42).
 *
 * Sets the standard deviation of the magnetometer noise that the filter assumes.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_mag_noise_response. Probably
 * affects mip_filter_data_euler_angles_uncertainty and
 * mip_filter_data_quaternion_attitude_uncertainty. Known only from the MicroStrain MIP SDK.
 * Requires a magnetometer. Uncertain: The SDK calls it process noise, although the noise is that of
 * a measurement.
 *
 * - mip-sdk-4: Mag Noise (0x0D,0x42)
 */
struct mip_filter_mag_noise {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_MAG_NOISE 0x0D42
#define MIP_FILTER_MAG_NOISE_DESCRIPTOR 0x42
MIP_FIELD(mip_filter_mag_noise, 0x42);
MIP_FILL(mip_filter_mag_noise, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_mag_noise, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_mag_noise, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_mag_noise, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_mag_noise *
mip_filter_mag_noise_write(struct mip_filter_mag_noise *command, const float noise[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->noise, noise, sizeof(command->noise));
    return command;
}

/**
 * Magnetometer noise response: response (0x0D,0xB1).
 *
 * Response to mip_filter_mag_noise. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Noise (0x0D,0x42)
 */
struct mip_filter_mag_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_MAG_NOISE_RESPONSE 0x0DB1
#define MIP_FILTER_MAG_NOISE_RESPONSE_DESCRIPTOR 0xB1
MIP_FIELD(mip_filter_mag_noise_response, 0xB1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_mag_noise *mip_filter_mag_noise_write_from(
    struct mip_filter_mag_noise *command, const struct mip_filter_mag_noise_response *response) {
    return mip_filter_mag_noise_write(command, response->noise);
}

/**
 * Magnetic declination source: command (0x0D,0x43).
 *
 * Selects the source of the local declination of the magnetic field.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_magnetic_declination_source_response. Probably affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles. Requires a magnetometer.
 *
 * Without a good declination source, keep automatic magnetometer calibration off.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
 * - 3dm-gq7: Magnetic Field Declination Source Control (0x0D,0x43)
 */
struct mip_filter_magnetic_declination_source {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the declination. A value of enum mip_filter_mag_parameter_source. Required for
     * write. On the 3DM-CX7-AHRS and 3DM-GV7-AHRS: only MIP_FILTER_MAG_PARAMETER_SOURCE_NONE and
     * MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL. On the 3DM-GQ7-GNSS/INS: only
     * MIP_FILTER_MAG_PARAMETER_SOURCE_WMM and MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL.
     */
    uint8_t source;
    /**
     * Angle from true north to magnetic north; used only if `source` is manual. Unit: rad. Frame:
     * ned. Range: -pi to pi. Positive: magnetic north is east of true north. Required for write.
     * Uncertain: The sign is the usual one; no source states it. Uncertain: The manuals, that of
     * the 3DM-GQ7 included, require it only if `source` is manual, but state one length, with the
     * value. Always send it.
     */
    float declination;
};

#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE 0x0D43
#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_DESCRIPTOR 0x43
MIP_FIELD(mip_filter_magnetic_declination_source, 0x43);
MIP_FILL(mip_filter_magnetic_declination_source, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_magnetic_declination_source, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_magnetic_declination_source, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_magnetic_declination_source, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_magnetic_declination_source *
mip_filter_magnetic_declination_source_write(struct mip_filter_magnetic_declination_source *command,
                                             enum mip_filter_mag_parameter_source source,
                                             float declination) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    command->declination = declination;
    return command;
}

/**
 * Magnetic declination source response: response (0x0D,0xB2).
 *
 * Response to mip_filter_magnetic_declination_source.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
 * - 3dm-gq7: Magnetic Field Declination Source Control (0x0D,0x43)
 */
struct mip_filter_magnetic_declination_source_response {
    /** Source of the declination. A value of enum mip_filter_mag_parameter_source. */
    uint8_t source;
    /**
     * Angle from true north to magnetic north; used only if `source` is manual. Unit: rad. Frame:
     * ned. Range: -pi to pi. Positive: magnetic north is east of true north. Uncertain: The sign is
     * the usual one; no source states it. Uncertain: The manuals, that of the 3DM-GQ7 included,
     * require it only if `source` is manual, but state one length, with the value. Always send it.
     */
    float declination;
};

#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE 0x0DB2
#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE_DESCRIPTOR 0xB2
MIP_FIELD(mip_filter_magnetic_declination_source_response, 0xB2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_magnetic_declination_source *
mip_filter_magnetic_declination_source_write_from(
    struct mip_filter_magnetic_declination_source *command,
    const struct mip_filter_magnetic_declination_source_response *response) {
    return mip_filter_magnetic_declination_source_write(
        command, (enum mip_filter_mag_parameter_source)response->source, response->declination);
}

/**
 * Gravity magnitude error adaptive measurement: command (0x0D,0x44).
 *
 * Sets how far the filter trusts gravity measurements whose magnitude is not as expected.
 *
 * Full name: filter.accel_magnitude_error_adaptive_measurement.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_accel_magnitude_adaptive_response. Probably affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_euler_angles_uncertainty and mip_filter_data_quaternion_attitude_uncertainty.
 *
 * Also called accelerometer magnitude error adaptive measurement.
 *
 * All parameters after the selector keep their values if they are omitted.
 *
 * The low-pass filter and the limits take effect only with `fixed`.
 *
 * Raise the limits where vibration is strong, lower them where it is weak. High limits reduce the
 * accuracy of pitch and roll under linear acceleration, low limits reduce the accuracy of the
 * heading.
 *
 * - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
 */
struct mip_filter_accel_magnitude_adaptive {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Kind of adaptation. A value of enum mip_filter_adaptive_measurement_selector. Required for
     * write. On the 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and
     * 3DM-RQ1-45-ST: only MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
     * MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
     */
    uint8_t adaptive_measurement;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Optional. */
    float frequency;
    /** Lower limit of the gravity magnitude error. Unit: m/s^2. Optional. */
    float low_limit;
    /** Upper limit of the gravity magnitude error. Unit: m/s^2. Optional. */
    float high_limit;
    /** Standard deviation at the lower limit. Unit: m/s^2. Range: at least 0. Optional. */
    float low_limit_uncertainty;
    /** Standard deviation at the upper limit. Unit: m/s^2. Range: at least 0. Optional. */
    float high_limit_uncertainty;
    /** Smallest standard deviation. Unit: m/s^2. Range: at least 0. Optional. */
    float minimum_uncertainty;
};

#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE 0x0D44
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_DESCRIPTOR 0x44
/** The value of `present` if frequency is the last parameter that is present. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_FREQUENCY 2
/** The value of `present` if low_limit is the last parameter that is present. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_LOW_LIMIT 3
/** The value of `present` if high_limit is the last parameter that is present. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT 4
/** The value of `present` if low_limit_uncertainty is the last parameter that is present. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_LOW_LIMIT_UNCERTAINTY 5
/** The value of `present` if high_limit_uncertainty is the last parameter that is present. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT_UNCERTAINTY 6
/** The value of `present` if minimum_uncertainty is the last parameter that is present. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_MINIMUM_UNCERTAINTY 7
MIP_FIELD(mip_filter_accel_magnitude_adaptive, 0x44);
MIP_FILL(mip_filter_accel_magnitude_adaptive, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_accel_magnitude_adaptive, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_accel_magnitude_adaptive, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_accel_magnitude_adaptive, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_accel_magnitude_adaptive *mip_filter_accel_magnitude_adaptive_write(
    struct mip_filter_accel_magnitude_adaptive *command,
    enum mip_filter_adaptive_measurement_selector adaptive_measurement) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->adaptive_measurement = (uint8_t)adaptive_measurement;
    return command;
}

/**
 * Gravity magnitude error adaptive measurement response: response (0x0D,0xB3).
 *
 * Full name: filter.accel_magnitude_error_adaptive_measurement_response.
 *
 * Response to mip_filter_accel_magnitude_adaptive.
 *
 * - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
 */
struct mip_filter_accel_magnitude_adaptive_response {
    /** Kind of adaptation. A value of enum mip_filter_adaptive_measurement_selector. */
    uint8_t adaptive_measurement;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. */
    float frequency;
    /** Lower limit of the gravity magnitude error. Unit: m/s^2. */
    float low_limit;
    /** Upper limit of the gravity magnitude error. Unit: m/s^2. */
    float high_limit;
    /** Standard deviation at the lower limit. Unit: m/s^2. Range: at least 0. */
    float low_limit_uncertainty;
    /** Standard deviation at the upper limit. Unit: m/s^2. Range: at least 0. */
    float high_limit_uncertainty;
    /** Smallest standard deviation. Unit: m/s^2. Range: at least 0. */
    float minimum_uncertainty;
};

#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE 0x0DB3
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR 0xB3
MIP_FIELD(mip_filter_accel_magnitude_adaptive_response, 0xB3);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_accel_magnitude_adaptive *
mip_filter_accel_magnitude_adaptive_write_from(
    struct mip_filter_accel_magnitude_adaptive *command,
    const struct mip_filter_accel_magnitude_adaptive_response *response) {
    return mip_filter_accel_magnitude_adaptive_write(
        command, (enum mip_filter_adaptive_measurement_selector)response->adaptive_measurement);
}

/**
 * Magnetometer magnitude error adaptive measurement: command (0x0D,0x45).
 *
 * Sets how far the filter trusts a magnetic field whose magnitude is not as expected.
 *
 * Full name: filter.mag_magnitude_error_adaptive_measurement.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_mag_magnitude_adaptive_response. Probably affects mip_filter_data_attitude_quaternion,
 * mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_euler_angles_uncertainty and mip_filter_data_quaternion_attitude_uncertainty.
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer. Uncertain: The parameters after
 * the selector can possibly be omitted on write, like those of mip_filter_accel_magnitude_adaptive.
 *
 * The limits and the low-pass filter take effect only with `fixed`; with `auto` the device
 * determines the limits.
 *
 * High limits suit high dynamics but do not reject disturbances of the field; low limits can
 * degrade the heading.
 *
 * - mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
 */
struct mip_filter_mag_magnitude_adaptive {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Kind of adaptation. A value of enum mip_filter_adaptive_measurement_selector. Required for
     * write. On the 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and
     * 3DM-RQ1-45-ST: only MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
     * MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
     */
    uint8_t adaptive_measurement;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for write. */
    float frequency;
    /**
     * Lower limit of the magnetic field magnitude error. Unit: gauss. Required for write.
     * Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45
     * m/s^2 in the command and gauss in the response.
     */
    float low_limit;
    /**
     * Upper limit of the magnetic field magnitude error. Unit: gauss. Required for write.
     * Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45
     * m/s^2 in the command and gauss in the response.
     */
    float high_limit;
    /**
     * Standard deviation at the lower limit. Unit: gauss. Range: at least 0. Required for write.
     * Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45
     * m/s^2 in the command and gauss in the response.
     */
    float low_limit_uncertainty;
    /**
     * Standard deviation at the upper limit. Unit: gauss. Range: at least 0. Required for write.
     * Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45
     * m/s^2 in the command and gauss in the response.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: gauss. Range: at least 0. Required for write. Uncertain:
     * The unit gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the
     * command and gauss in the response.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE 0x0D45
#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_DESCRIPTOR 0x45
MIP_FIELD(mip_filter_mag_magnitude_adaptive, 0x45);
MIP_FILL(mip_filter_mag_magnitude_adaptive, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_mag_magnitude_adaptive, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_mag_magnitude_adaptive, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_mag_magnitude_adaptive, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_mag_magnitude_adaptive *mip_filter_mag_magnitude_adaptive_write(
    struct mip_filter_mag_magnitude_adaptive *command,
    enum mip_filter_adaptive_measurement_selector adaptive_measurement, float frequency,
    float low_limit, float high_limit, float low_limit_uncertainty, float high_limit_uncertainty,
    float minimum_uncertainty) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->adaptive_measurement = (uint8_t)adaptive_measurement;
    command->frequency = frequency;
    command->low_limit = low_limit;
    command->high_limit = high_limit;
    command->low_limit_uncertainty = low_limit_uncertainty;
    command->high_limit_uncertainty = high_limit_uncertainty;
    command->minimum_uncertainty = minimum_uncertainty;
    return command;
}

/**
 * Magnetometer magnitude error adaptive measurement response: response (0x0D,0xB4).
 *
 * Full name: filter.mag_magnitude_error_adaptive_measurement_response.
 *
 * Response to mip_filter_mag_magnitude_adaptive. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
 */
struct mip_filter_mag_magnitude_adaptive_response {
    /** Kind of adaptation. A value of enum mip_filter_adaptive_measurement_selector. */
    uint8_t adaptive_measurement;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. */
    float frequency;
    /**
     * Lower limit of the magnetic field magnitude error. Unit: gauss. Uncertain: The unit gauss is
     * inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss
     * in the response.
     */
    float low_limit;
    /**
     * Upper limit of the magnetic field magnitude error. Unit: gauss. Uncertain: The unit gauss is
     * inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss
     * in the response.
     */
    float high_limit;
    /**
     * Standard deviation at the lower limit. Unit: gauss. Range: at least 0. Uncertain: The unit
     * gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command
     * and gauss in the response.
     */
    float low_limit_uncertainty;
    /**
     * Standard deviation at the upper limit. Unit: gauss. Range: at least 0. Uncertain: The unit
     * gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command
     * and gauss in the response.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: gauss. Range: at least 0. Uncertain: The unit gauss is
     * inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss
     * in the response.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE 0x0DB4
#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR 0xB4
MIP_FIELD(mip_filter_mag_magnitude_adaptive_response, 0xB4);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_mag_magnitude_adaptive *
mip_filter_mag_magnitude_adaptive_write_from(
    struct mip_filter_mag_magnitude_adaptive *command,
    const struct mip_filter_mag_magnitude_adaptive_response *response) {
    return mip_filter_mag_magnitude_adaptive_write(
        command, (enum mip_filter_adaptive_measurement_selector)response->adaptive_measurement,
        response->frequency, response->low_limit, response->high_limit,
        response->low_limit_uncertainty, response->high_limit_uncertainty,
        response->minimum_uncertainty);
}

/**
 * Magnetometer dip angle error adaptive measurement: command (0x0D,0x46).
 *
 * Sets how far the filter trusts a magnetic field whose dip angle is not as expected.
 *
 * Full name: filter.mag_dip_angle_error_adaptive_measurement.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_mag_dip_angle_adaptive_response. Probably affects mip_filter_data_attitude_quaternion,
 * mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_euler_angles_uncertainty and mip_filter_data_quaternion_attitude_uncertainty.
 * Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * It has no effect while mip_filter_accel_magnitude_adaptive or mip_filter_mag_magnitude_adaptive
 * is set to `auto`.
 *
 * High limits suit high dynamics but do not reject disturbances of the field; low limits can
 * degrade the heading.
 *
 * - mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
 */
struct mip_filter_mag_dip_angle_adaptive {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** True if the adaptation is on. Required for write. */
    mip_bool enable;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. Required for write. */
    float frequency;
    /**
     * Upper limit of the dip angle error. Unit: rad. Range: at least 0. Required for write.
     * Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
     */
    float high_limit;
    /**
     * Standard deviation at the upper limit. Unit: rad. Range: at least 0. Required for write.
     * Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: rad. Range: at least 0. Required for write. Uncertain: The
     * unit rad is inferred from the quantity; the SDK states m/s^2.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE 0x0D46
#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_DESCRIPTOR 0x46
MIP_FIELD(mip_filter_mag_dip_angle_adaptive, 0x46);
MIP_FILL(mip_filter_mag_dip_angle_adaptive, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_mag_dip_angle_adaptive, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_mag_dip_angle_adaptive, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_mag_dip_angle_adaptive, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_mag_dip_angle_adaptive *mip_filter_mag_dip_angle_adaptive_write(
    struct mip_filter_mag_dip_angle_adaptive *command, mip_bool enable, float frequency,
    float high_limit, float high_limit_uncertainty, float minimum_uncertainty) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = mip_truth(enable);
    command->frequency = frequency;
    command->high_limit = high_limit;
    command->high_limit_uncertainty = high_limit_uncertainty;
    command->minimum_uncertainty = minimum_uncertainty;
    return command;
}

/**
 * Magnetometer dip angle error adaptive measurement response: response (0x0D,0xB5).
 *
 * Full name: filter.mag_dip_angle_error_adaptive_measurement_response.
 *
 * Response to mip_filter_mag_dip_angle_adaptive. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
 */
struct mip_filter_mag_dip_angle_adaptive_response {
    /** True if the adaptation is on. */
    mip_bool enable;
    /** Cutoff frequency of the low-pass filter. Unit: Hz. Range: at least 0. */
    float frequency;
    /**
     * Upper limit of the dip angle error. Unit: rad. Range: at least 0. Uncertain: The unit rad is
     * inferred from the quantity; the SDK states m/s^2.
     */
    float high_limit;
    /**
     * Standard deviation at the upper limit. Unit: rad. Range: at least 0. Uncertain: The unit rad
     * is inferred from the quantity; the SDK states m/s^2.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: rad. Range: at least 0. Uncertain: The unit rad is
     * inferred from the quantity; the SDK states m/s^2.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE 0x0DB5
#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE_DESCRIPTOR 0xB5
MIP_FIELD(mip_filter_mag_dip_angle_adaptive_response, 0xB5);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_mag_dip_angle_adaptive *
mip_filter_mag_dip_angle_adaptive_write_from(
    struct mip_filter_mag_dip_angle_adaptive *command,
    const struct mip_filter_mag_dip_angle_adaptive_response *response) {
    return mip_filter_mag_dip_angle_adaptive_write(
        command, response->enable, response->frequency, response->high_limit,
        response->high_limit_uncertainty, response->minimum_uncertainty);
}

/**
 * Altitude aiding: command (0x0D,0x47).
 *
 * Selects the source that aids the altitude in addition to GNSS.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_altitude_aiding_response.
 * Probably affects mip_filter_data_llh_position and mip_filter_data_llh_position_uncertainty. Known
 * only from the MicroStrain MIP SDK. Requires a pressure sensor.
 *
 * GNSS remains the main source of altitude; the aid improves it and bridges outages.
 *
 * Weather and location shift the pressure altitude, sometimes by more than 40 m.
 *
 * - mip-sdk-4: Altitude aiding (0x0D,0x47)
 */
struct mip_filter_altitude_aiding {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the aiding. A value of enum mip_filter_altitude_aiding_source. Required for write.
     */
    uint8_t selector;
};

#define MIP_FILTER_ALTITUDE_AIDING 0x0D47
#define MIP_FILTER_ALTITUDE_AIDING_DESCRIPTOR 0x47
MIP_FIELD(mip_filter_altitude_aiding, 0x47);
MIP_FILL(mip_filter_altitude_aiding, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_altitude_aiding, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_altitude_aiding, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_altitude_aiding, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_altitude_aiding *mip_filter_altitude_aiding_write(
    struct mip_filter_altitude_aiding *command, enum mip_filter_altitude_aiding_source selector) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->selector = (uint8_t)selector;
    return command;
}

/**
 * Altitude aiding response: response (0x0D,0xB7).
 *
 * Response to mip_filter_altitude_aiding. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Altitude aiding (0x0D,0x47)
 */
struct mip_filter_altitude_aiding_response {
    /** Source of the aiding. A value of enum mip_filter_altitude_aiding_source. */
    uint8_t selector;
};

#define MIP_FILTER_ALTITUDE_AIDING_RESPONSE 0x0DB7
#define MIP_FILTER_ALTITUDE_AIDING_RESPONSE_DESCRIPTOR 0xB7
MIP_FIELD(mip_filter_altitude_aiding_response, 0xB7);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_altitude_aiding *
mip_filter_altitude_aiding_write_from(struct mip_filter_altitude_aiding *command,
                                      const struct mip_filter_altitude_aiding_response *response) {
    return mip_filter_altitude_aiding_write(
        command, (enum mip_filter_altitude_aiding_source)response->selector);
}

/**
 * Pitch and roll aiding: command (0x0D,0x4B).
 *
 * Selects the source that aids pitch and roll while the motion is gentle.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_pitch_roll_aiding_response.
 * Probably affects mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm,
 * mip_filter_data_euler_angles, mip_filter_data_euler_angles_uncertainty and
 * mip_filter_data_quaternion_attitude_uncertainty.
 *
 * - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
 */
struct mip_filter_pitch_roll_aiding {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the aiding. A value of enum mip_filter_pitch_roll_aiding_source. Required for
     * write.
     */
    uint8_t aiding;
};

#define MIP_FILTER_PITCH_ROLL_AIDING 0x0D4B
#define MIP_FILTER_PITCH_ROLL_AIDING_DESCRIPTOR 0x4B
MIP_FIELD(mip_filter_pitch_roll_aiding, 0x4B);
MIP_FILL(mip_filter_pitch_roll_aiding, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_pitch_roll_aiding, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_pitch_roll_aiding, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_pitch_roll_aiding, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_pitch_roll_aiding *mip_filter_pitch_roll_aiding_write(
    struct mip_filter_pitch_roll_aiding *command, enum mip_filter_pitch_roll_aiding_source aiding) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->aiding = (uint8_t)aiding;
    return command;
}

/**
 * Pitch and roll aiding response: response (0x0D,0xBB).
 *
 * Response to mip_filter_pitch_roll_aiding.
 *
 * - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
 */
struct mip_filter_pitch_roll_aiding_response {
    /** Source of the aiding. A value of enum mip_filter_pitch_roll_aiding_source. */
    uint8_t aiding;
};

#define MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE 0x0DBB
#define MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE_DESCRIPTOR 0xBB
MIP_FIELD(mip_filter_pitch_roll_aiding_response, 0xBB);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_pitch_roll_aiding *mip_filter_pitch_roll_aiding_write_from(
    struct mip_filter_pitch_roll_aiding *command,
    const struct mip_filter_pitch_roll_aiding_response *response) {
    return mip_filter_pitch_roll_aiding_write(
        command, (enum mip_filter_pitch_roll_aiding_source)response->aiding);
}

/**
 * Magnetic inclination source: command (0x0D,0x4C).
 *
 * Selects the source of the local inclination (dip angle) of the magnetic field.
 *
 * Also called `inclination_source`. Functions: write, read, save, load and default. Response:
 * mip_filter_magnetic_inclination_source_response. Probably affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * Without a good inclination source, keep automatic magnetometer calibration off.
 *
 * - mip-sdk-4: Inclination Source (0x0D,0x4C)
 */
struct mip_filter_magnetic_inclination_source {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the inclination. A value of enum mip_filter_mag_parameter_source. Required for
     * write.
     */
    uint8_t source;
    /**
     * Angle of the field below the horizontal plane; used only if `source` is manual. Unit: rad.
     * Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: the field points
     * down. Required for write. Uncertain: The sign is the usual one; no source states it.
     * Uncertain: It can possibly be omitted if `source` is not manual, as with
     * mip_filter_magnetic_declination_source. The SDK always sends it.
     */
    float inclination;
};

#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE 0x0D4C
#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_DESCRIPTOR 0x4C
MIP_FIELD(mip_filter_magnetic_inclination_source, 0x4C);
MIP_FILL(mip_filter_magnetic_inclination_source, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_magnetic_inclination_source, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_magnetic_inclination_source, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_magnetic_inclination_source, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_magnetic_inclination_source *
mip_filter_magnetic_inclination_source_write(struct mip_filter_magnetic_inclination_source *command,
                                             enum mip_filter_mag_parameter_source source,
                                             float inclination) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    command->inclination = inclination;
    return command;
}

/**
 * Magnetic inclination source response: response (0x0D,0xBC).
 *
 * Also called `inclination_source_response`. Response to mip_filter_magnetic_inclination_source.
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Inclination Source (0x0D,0x4C)
 */
struct mip_filter_magnetic_inclination_source_response {
    /** Source of the inclination. A value of enum mip_filter_mag_parameter_source. */
    uint8_t source;
    /**
     * Angle of the field below the horizontal plane; used only if `source` is manual. Unit: rad.
     * Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: the field points
     * down. Uncertain: The sign is the usual one; no source states it. Uncertain: It can possibly
     * be omitted if `source` is not manual, as with mip_filter_magnetic_declination_source. The SDK
     * always sends it.
     */
    float inclination;
};

#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE 0x0DBC
#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE_DESCRIPTOR 0xBC
MIP_FIELD(mip_filter_magnetic_inclination_source_response, 0xBC);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_magnetic_inclination_source *
mip_filter_magnetic_inclination_source_write_from(
    struct mip_filter_magnetic_inclination_source *command,
    const struct mip_filter_magnetic_inclination_source_response *response) {
    return mip_filter_magnetic_inclination_source_write(
        command, (enum mip_filter_mag_parameter_source)response->source, response->inclination);
}

/**
 * Magnetic field magnitude source: command (0x0D,0x4D).
 *
 * Selects the source of the local magnitude of the magnetic field.
 *
 * Also called `mag_field_magnitude_source`. Functions: write, read, save, load and default.
 * Response: mip_filter_magnetic_magnitude_source_response. Probably affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
 *
 * Without a good magnitude source, keep automatic magnetometer calibration off.
 *
 * mip_filter_mag_magnitude_adaptive relies on it too.
 *
 * - mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
 */
struct mip_filter_magnetic_magnitude_source {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the magnitude. A value of enum mip_filter_mag_parameter_source. Required for write.
     */
    uint8_t source;
    /**
     * Magnitude; used only if `source` is manual. Unit: gauss. Range: at least 0. Required for
     * write. Uncertain: It can possibly be omitted if `source` is not manual, as with
     * mip_filter_magnetic_declination_source. The SDK always sends it.
     */
    float magnitude;
};

#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE 0x0D4D
#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_DESCRIPTOR 0x4D
MIP_FIELD(mip_filter_magnetic_magnitude_source, 0x4D);
MIP_FILL(mip_filter_magnetic_magnitude_source, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_magnetic_magnitude_source, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_magnetic_magnitude_source, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_magnetic_magnitude_source, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_magnetic_magnitude_source *
mip_filter_magnetic_magnitude_source_write(struct mip_filter_magnetic_magnitude_source *command,
                                           enum mip_filter_mag_parameter_source source,
                                           float magnitude) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    command->magnitude = magnitude;
    return command;
}

/**
 * Magnetic field magnitude source response: response (0x0D,0xBD).
 *
 * Also called `mag_field_magnitude_source_response`. Response to
 * mip_filter_magnetic_magnitude_source. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
 */
struct mip_filter_magnetic_magnitude_source_response {
    /** Source of the magnitude. A value of enum mip_filter_mag_parameter_source. */
    uint8_t source;
    /**
     * Magnitude; used only if `source` is manual. Unit: gauss. Range: at least 0. Uncertain: It can
     * possibly be omitted if `source` is not manual, as with
     * mip_filter_magnetic_declination_source. The SDK always sends it.
     */
    float magnitude;
};

#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE 0x0DBD
#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE_DESCRIPTOR 0xBD
MIP_FIELD(mip_filter_magnetic_magnitude_source_response, 0xBD);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_magnetic_magnitude_source *
mip_filter_magnetic_magnitude_source_write_from(
    struct mip_filter_magnetic_magnitude_source *command,
    const struct mip_filter_magnetic_magnitude_source_response *response) {
    return mip_filter_magnetic_magnitude_source_write(
        command, (enum mip_filter_mag_parameter_source)response->source, response->magnitude);
}

/**
 * Sensor to vehicle rotation, matrix: command (0x0D,0x4E).
 *
 * Sets the rotation from the sensor frame to the vehicle frame as a direction cosine matrix.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_sensor_to_vehicle_rotation_dcm_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably affects mip_filter_data_comp_accel. Known only from the
 * MicroStrain MIP SDK.
 *
 * It is the inverse of the matrix that mip_3dm_sensor_to_vehicle_transform_dcm accepts.
 *
 * The device rejects a matrix that is not orthonormal to within 0.001.
 *
 * The device keeps a quaternion, so the elements read back may differ slightly from those written.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
 */
struct mip_filter_sensor_to_vehicle_rotation_dcm {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; row-major. Elements: m11, m12,
     * m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for write.
     */
    float dcm[9];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM 0x0D4E
#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM_DESCRIPTOR 0x4E
MIP_FIELD(mip_filter_sensor_to_vehicle_rotation_dcm, 0x4E);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_dcm, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_dcm, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_dcm, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_sensor_to_vehicle_rotation_dcm, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_rotation_dcm *
mip_filter_sensor_to_vehicle_rotation_dcm_write(
    struct mip_filter_sensor_to_vehicle_rotation_dcm *command, const float dcm[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->dcm, dcm, sizeof(command->dcm));
    return command;
}

/**
 * Sensor to vehicle rotation, matrix response: response (0x0D,0xBE).
 *
 * Response to mip_filter_sensor_to_vehicle_rotation_dcm. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
 */
struct mip_filter_sensor_to_vehicle_rotation_dcm_response {
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; row-major. Elements: m11, m12,
     * m13, m21, m22, m23, m31, m32, m33. Unit: 1.
     */
    float dcm[9];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM_RESPONSE 0x0DBE
#define MIP_FILTER_SENSOR_TO_VEHICLE_ROTATION_DCM_RESPONSE_DESCRIPTOR 0xBE
MIP_FIELD(mip_filter_sensor_to_vehicle_rotation_dcm_response, 0xBE);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_rotation_dcm *
mip_filter_sensor_to_vehicle_rotation_dcm_write_from(
    struct mip_filter_sensor_to_vehicle_rotation_dcm *command,
    const struct mip_filter_sensor_to_vehicle_rotation_dcm_response *response) {
    return mip_filter_sensor_to_vehicle_rotation_dcm_write(command, response->dcm);
}

/**
 * Sensor to vehicle rotation, quaternion: command (0x0D,0x4F).
 *
 * Sets the rotation from the sensor frame to the vehicle frame as a quaternion.
 *
 * Full name: filter.sensor_to_vehicle_rotation_quaternion.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_sensor_to_vehicle_quaternion_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably affects mip_filter_data_comp_accel. Known only from the
 * MicroStrain MIP SDK.
 *
 * It is the inverse of the quaternion that mip_3dm_sensor_to_vehicle_transform_quaternion accepts.
 *
 * The device normalizes it, so the elements read back may differ slightly from those written.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
 */
struct mip_filter_sensor_to_vehicle_quaternion {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first.
     * Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to 1.001. Required for write.
     */
    float q[4];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION 0x0D4F
#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_DESCRIPTOR 0x4F
MIP_FIELD(mip_filter_sensor_to_vehicle_quaternion, 0x4F);
MIP_FILL(mip_filter_sensor_to_vehicle_quaternion, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_sensor_to_vehicle_quaternion, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_sensor_to_vehicle_quaternion, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_sensor_to_vehicle_quaternion, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_quaternion *
mip_filter_sensor_to_vehicle_quaternion_write(
    struct mip_filter_sensor_to_vehicle_quaternion *command, const float q[4]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->q, q, sizeof(command->q));
    return command;
}

/**
 * Sensor to vehicle rotation, quaternion response: response (0x0D,0xBF).
 *
 * Full name: filter.sensor_to_vehicle_rotation_quaternion_response.
 *
 * Response to mip_filter_sensor_to_vehicle_quaternion. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
 */
struct mip_filter_sensor_to_vehicle_quaternion_response {
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first.
     * Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to 1.001.
     */
    float q[4];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE 0x0DBF
#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_DESCRIPTOR 0xBF
MIP_FIELD(mip_filter_sensor_to_vehicle_quaternion_response, 0xBF);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_sensor_to_vehicle_quaternion *
mip_filter_sensor_to_vehicle_quaternion_write_from(
    struct mip_filter_sensor_to_vehicle_quaternion *command,
    const struct mip_filter_sensor_to_vehicle_quaternion_response *response) {
    return mip_filter_sensor_to_vehicle_quaternion_write(command, response->q);
}

/**
 * Aiding measurement control: command (0x0D,0x50).
 *
 * Enables or disables one source of aiding measurements.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_aiding_measurement_enable_response. Affects
 * mip_filter_data_aiding_measurement_summary. Probably affects MIP_FILTER_DATA_SET.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
 */
struct mip_filter_aiding_measurement_enable {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * The source; `all` is for save, load and default. A value of mip_filter_aiding_source. On the
     * 3DM-CV7-AHRS, 3DM-CX7-AHRS and 3DM-GV7-AHRS: only MIP_FILTER_AIDING_SOURCE_MAG,
     * MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL. On the
     * 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
     * MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only
     * MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY, MIP_FILTER_AIDING_SOURCE_ALTIMETER,
     * MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING,
     * MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER, MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG,
     * MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY and MIP_FILTER_AIDING_SOURCE_ALL. On the
     * 3DM-GQ7-GNSS/INS: only MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY,
     * MIP_FILTER_AIDING_SOURCE_GNSS_HEADING, MIP_FILTER_AIDING_SOURCE_ALTIMETER,
     * MIP_FILTER_AIDING_SOURCE_SPEED, MIP_FILTER_AIDING_SOURCE_MAG,
     * MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL.
     */
    uint16_t aiding_source;
    /** True if the filter uses the source. Required for write. */
    mip_bool enable;
};

#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE 0x0D50
#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_DESCRIPTOR 0x50
MIP_FIELD(mip_filter_aiding_measurement_enable, 0x50);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_aiding_measurement_enable *
mip_filter_aiding_measurement_enable_write(struct mip_filter_aiding_measurement_enable *command,
                                           uint16_t aiding_source, mip_bool enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->aiding_source = aiding_source;
    command->enable = mip_truth(enable);
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_filter_aiding_measurement_enable *
mip_filter_aiding_measurement_enable_read(struct mip_filter_aiding_measurement_enable *command,
                                          uint16_t aiding_source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->aiding_source = aiding_source;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_filter_aiding_measurement_enable *
mip_filter_aiding_measurement_enable_save(struct mip_filter_aiding_measurement_enable *command,
                                          uint16_t aiding_source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->aiding_source = aiding_source;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_filter_aiding_measurement_enable *
mip_filter_aiding_measurement_enable_load(struct mip_filter_aiding_measurement_enable *command,
                                          uint16_t aiding_source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->aiding_source = aiding_source;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_filter_aiding_measurement_enable *
mip_filter_aiding_measurement_enable_default(struct mip_filter_aiding_measurement_enable *command,
                                             uint16_t aiding_source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->aiding_source = aiding_source;
    return command;
}

/**
 * Aiding measurement control response: response (0x0D,0xD0).
 *
 * Response to mip_filter_aiding_measurement_enable.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
 */
struct mip_filter_aiding_measurement_enable_response {
    /** Aiding source that the setting is for. A value of mip_filter_aiding_source. */
    uint16_t aiding_source;
    /** True if the filter uses the source. */
    mip_bool enable;
};

#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE 0x0DD0
#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE_DESCRIPTOR 0xD0
MIP_FIELD(mip_filter_aiding_measurement_enable_response, 0xD0);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_aiding_measurement_enable *
mip_filter_aiding_measurement_enable_write_from(
    struct mip_filter_aiding_measurement_enable *command,
    const struct mip_filter_aiding_measurement_enable_response *response) {
    return mip_filter_aiding_measurement_enable_write(command, response->aiding_source,
                                                      response->enable);
}

/**
 * Kinematic constraint: command (0x0D,0x51).
 *
 * Sets the assumptions about the motion that the filter uses in place of measurements.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_kinematic_constraint_response. Probably affects mip_filter_data_ned_velocity,
 * mip_filter_data_ecef_velocity, mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm
 * and mip_filter_data_euler_angles. Known only from the MicroStrain MIP SDK. Uncertain: There may
 * be further values, because the SDK uses plain numbers and lists values in comments only.
 *
 * - mip-sdk-4: Kinematic constraint (0x0D,0x51)
 */
struct mip_filter_kinematic_constraint {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Assumption about the acceleration. A value of enum mip_filter_accel_constraint. Default:
     * MIP_FILTER_ACCEL_CONSTRAINT_NONE. Required for write.
     */
    uint8_t accel_constraint;
    /**
     * Assumption about the velocity. A value of enum mip_filter_velocity_constraint. Default:
     * MIP_FILTER_VELOCITY_CONSTRAINT_NONE. Required for write.
     */
    uint8_t velocity_constraint;
    /**
     * Assumption about the angular rate. A value of enum mip_filter_angular_constraint. Default:
     * MIP_FILTER_ANGULAR_CONSTRAINT_NONE. Required for write.
     */
    uint8_t angular_constraint;
};

#define MIP_FILTER_KINEMATIC_CONSTRAINT 0x0D51
#define MIP_FILTER_KINEMATIC_CONSTRAINT_DESCRIPTOR 0x51
MIP_FIELD(mip_filter_kinematic_constraint, 0x51);
MIP_FILL(mip_filter_kinematic_constraint, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_kinematic_constraint, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_kinematic_constraint, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_kinematic_constraint, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_kinematic_constraint *
mip_filter_kinematic_constraint_write(struct mip_filter_kinematic_constraint *command,
                                      enum mip_filter_accel_constraint accel_constraint,
                                      enum mip_filter_velocity_constraint velocity_constraint,
                                      enum mip_filter_angular_constraint angular_constraint) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->accel_constraint = (uint8_t)accel_constraint;
    command->velocity_constraint = (uint8_t)velocity_constraint;
    command->angular_constraint = (uint8_t)angular_constraint;
    return command;
}

/**
 * Kinematic constraint response: response (0x0D,0xD1).
 *
 * Response to mip_filter_kinematic_constraint. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Kinematic constraint (0x0D,0x51)
 */
struct mip_filter_kinematic_constraint_response {
    /**
     * Assumption about the acceleration. A value of enum mip_filter_accel_constraint. Default:
     * MIP_FILTER_ACCEL_CONSTRAINT_NONE.
     */
    uint8_t accel_constraint;
    /**
     * Assumption about the velocity. A value of enum mip_filter_velocity_constraint. Default:
     * MIP_FILTER_VELOCITY_CONSTRAINT_NONE.
     */
    uint8_t velocity_constraint;
    /**
     * Assumption about the angular rate. A value of enum mip_filter_angular_constraint. Default:
     * MIP_FILTER_ANGULAR_CONSTRAINT_NONE.
     */
    uint8_t angular_constraint;
};

#define MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE 0x0DD1
#define MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE_DESCRIPTOR 0xD1
MIP_FIELD(mip_filter_kinematic_constraint_response, 0xD1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_kinematic_constraint *mip_filter_kinematic_constraint_write_from(
    struct mip_filter_kinematic_constraint *command,
    const struct mip_filter_kinematic_constraint_response *response) {
    return mip_filter_kinematic_constraint_write(
        command, (enum mip_filter_accel_constraint)response->accel_constraint,
        (enum mip_filter_velocity_constraint)response->velocity_constraint,
        (enum mip_filter_angular_constraint)response->angular_constraint);
}

/**
 * Navigation filter initialization: command (0x0D,0x52).
 *
 * Sets the sources and values of the initial attitude, position and velocity of the filter.
 *
 * Also called `initialization_configuration`. Functions: write, read, save, load and default.
 * Response: mip_filter_initialization_config_response. Probably affects mip_filter_data_status,
 * mip_filter_data_llh_position, mip_filter_data_ecef_position, mip_filter_data_ned_velocity,
 * mip_filter_data_ecef_velocity, mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm
 * and mip_filter_data_euler_angles.
 *
 * The initial angles are in degrees, unlike those of mip_filter_set_initial_attitude, which are in
 * radians.
 *
 * Single precision resolves the latitude and longitude of the initial position to about a metre
 * only.
 *
 * Kinematic alignment sets the heading once the speed reaches 2 m/s.
 *
 * External alignment needs a heading at least every 5 seconds.
 *
 * A change takes effect at the next start of the filter: after mip_filter_reset or a power cycle.
 *
 * - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
 */
struct mip_filter_initialization_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * 1: the filter starts only after mip_filter_run; 0: it starts as soon as it can. Range: 0 to
     * 1. Required for write.
     */
    uint8_t wait_for_run_command;
    /**
     * Initial conditions that your program provides instead of the device. A value of enum
     * mip_filter_initial_condition_source. Required for write.
     */
    uint8_t initial_condition_source;
    /**
     * Methods that may be used to determine the initial heading. Required for write. On the
     * 3DM-CV7-INS, 3DM-CX7-INS and 3DM-GV7-INS: only MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC,
     * MIP_FILTER_HEADING_ALIGNMENT_MAG and MIP_FILTER_HEADING_ALIGNMENT_EXTERNAL. On the
     * 3DM-GQ7-GNSS/INS: only MIP_FILTER_HEADING_ALIGNMENT_DUAL_ANTENNA,
     * MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC and MIP_FILTER_HEADING_ALIGNMENT_MAG.
     */
    mip_filter_heading_alignment auto_heading_alignment_selector;
    /**
     * Initial heading relative to true north. Unit: deg. Frame: ned. Positive: clockwise seen from
     * above. Required for write.
     */
    float initial_heading;
    /** Initial pitch angle. Unit: deg. Frame: ned. Positive: nose up. Required for write. */
    float initial_pitch;
    /** Initial roll angle. Unit: deg. Frame: ned. Positive: right side down. Required for write. */
    float initial_roll;
    /**
     * Initial position that your program provides. Elements: x, y, z. Required for write. If
     * reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If
     * reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_LLH: elements latitude, longitude,
     * height; unit deg, deg, m; frame llh.
     */
    float initial_position[3];
    /**
     * Initial velocity that your program provides. Elements: x, y, z. Unit: m/s. Required for
     * write. If reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_ECEF: frame ecef. If
     * reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_LLH: elements north, east, down; frame
     * ned.
     */
    float initial_velocity[3];
    /**
     * Frame of the initial position and velocity. A value of enum mip_filter_reference_frame.
     * Required for write.
     */
    uint8_t reference_frame_selector;
};

#define MIP_FILTER_INITIALIZATION_CONFIG 0x0D52
#define MIP_FILTER_INITIALIZATION_CONFIG_DESCRIPTOR 0x52
MIP_FIELD(mip_filter_initialization_config, 0x52);
MIP_FILL(mip_filter_initialization_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_initialization_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_initialization_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_initialization_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_initialization_config *mip_filter_initialization_config_write(
    struct mip_filter_initialization_config *command, uint8_t wait_for_run_command,
    enum mip_filter_initial_condition_source initial_condition_source,
    mip_filter_heading_alignment auto_heading_alignment_selector, float initial_heading,
    float initial_pitch, float initial_roll, const float initial_position[3],
    const float initial_velocity[3], enum mip_filter_reference_frame reference_frame_selector) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->wait_for_run_command = wait_for_run_command;
    command->initial_condition_source = (uint8_t)initial_condition_source;
    command->auto_heading_alignment_selector = auto_heading_alignment_selector;
    command->initial_heading = initial_heading;
    command->initial_pitch = initial_pitch;
    command->initial_roll = initial_roll;
    memcpy(command->initial_position, initial_position, sizeof(command->initial_position));
    memcpy(command->initial_velocity, initial_velocity, sizeof(command->initial_velocity));
    command->reference_frame_selector = (uint8_t)reference_frame_selector;
    return command;
}

/**
 * Navigation filter initialization response: response (0x0D,0xD2).
 *
 * Also called `initialization_configuration_response`. Response to
 * mip_filter_initialization_config.
 *
 * - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
 */
struct mip_filter_initialization_config_response {
    /**
     * 1: the filter starts only after mip_filter_run; 0: it starts as soon as it can. Range: 0 to
     * 1.
     */
    uint8_t wait_for_run_command;
    /**
     * Initial conditions that your program provides instead of the device. A value of enum
     * mip_filter_initial_condition_source.
     */
    uint8_t initial_condition_source;
    /** Methods that may be used to determine the initial heading. */
    mip_filter_heading_alignment auto_heading_alignment_selector;
    /**
     * Initial heading relative to true north. Unit: deg. Frame: ned. Positive: clockwise seen from
     * above.
     */
    float initial_heading;
    /** Initial pitch angle. Unit: deg. Frame: ned. Positive: nose up. */
    float initial_pitch;
    /** Initial roll angle. Unit: deg. Frame: ned. Positive: right side down. */
    float initial_roll;
    /**
     * Initial position that your program provides. Elements: x, y, z. If reference_frame_selector
     * is MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: elements latitude, longitude, height; unit deg, deg, m; frame
     * llh.
     */
    float initial_position[3];
    /**
     * Initial velocity that your program provides. Elements: x, y, z. Unit: m/s. If
     * reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_ECEF: frame ecef. If
     * reference_frame_selector is MIP_FILTER_REFERENCE_FRAME_LLH: elements north, east, down; frame
     * ned.
     */
    float initial_velocity[3];
    /** Frame of the initial position and velocity. A value of enum mip_filter_reference_frame. */
    uint8_t reference_frame_selector;
};

#define MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE 0x0DD2
#define MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE_DESCRIPTOR 0xD2
MIP_FIELD(mip_filter_initialization_config_response, 0xD2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_initialization_config *mip_filter_initialization_config_write_from(
    struct mip_filter_initialization_config *command,
    const struct mip_filter_initialization_config_response *response) {
    return mip_filter_initialization_config_write(
        command, response->wait_for_run_command,
        (enum mip_filter_initial_condition_source)response->initial_condition_source,
        response->auto_heading_alignment_selector, response->initial_heading,
        response->initial_pitch, response->initial_roll, response->initial_position,
        response->initial_velocity,
        (enum mip_filter_reference_frame)response->reference_frame_selector);
}

/**
 * Adaptive filter control: command (0x0D,0x53).
 *
 * Sets how the filter adapts to measurements that do not fit its model.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_adaptive_filter_options_response. Probably affects MIP_FILTER_DATA_SET.
 *
 * - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
 */
struct mip_filter_adaptive_filter_options {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Strength of the adaptation. A value of enum mip_filter_adaptive_level. Default: 2. Required
     * for write. On the 3DM-GX5-45: only MIP_FILTER_ADAPTIVE_LEVEL_OFF and
     * MIP_FILTER_ADAPTIVE_LEVEL_MODERATE.
     */
    uint8_t level;
    /**
     * Longest time for which measurements are rejected before the filter recovers. Unit: ms.
     * Required for write.
     */
    uint16_t time_limit;
};

#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS 0x0D53
#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_DESCRIPTOR 0x53
MIP_FIELD(mip_filter_adaptive_filter_options, 0x53);
MIP_FILL(mip_filter_adaptive_filter_options, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_adaptive_filter_options, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_adaptive_filter_options, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_adaptive_filter_options, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_adaptive_filter_options *mip_filter_adaptive_filter_options_write(
    struct mip_filter_adaptive_filter_options *command, enum mip_filter_adaptive_level level,
    uint16_t time_limit) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->level = (uint8_t)level;
    command->time_limit = time_limit;
    return command;
}

/**
 * Adaptive filter control response: response (0x0D,0xD3).
 *
 * Response to mip_filter_adaptive_filter_options.
 *
 * - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
 */
struct mip_filter_adaptive_filter_options_response {
    /** Strength of the adaptation. A value of enum mip_filter_adaptive_level. Default: 2. */
    uint8_t level;
    /** Longest time for which measurements are rejected before the filter recovers. Unit: ms. */
    uint16_t time_limit;
};

#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE 0x0DD3
#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE_DESCRIPTOR 0xD3
MIP_FIELD(mip_filter_adaptive_filter_options_response, 0xD3);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_adaptive_filter_options *
mip_filter_adaptive_filter_options_write_from(
    struct mip_filter_adaptive_filter_options *command,
    const struct mip_filter_adaptive_filter_options_response *response) {
    return mip_filter_adaptive_filter_options_write(
        command, (enum mip_filter_adaptive_level)response->level, response->time_limit);
}

/**
 * GNSS multi-antenna offset: command (0x0D,0x54).
 *
 * Sets the position of the antenna of one receiver on devices with several antennas.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_multi_antenna_offset_response. Probably affects mip_filter_data_llh_position,
 * mip_filter_data_ecef_position, mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_multi_antenna_offset_correction and mip_filter_data_gnss_dual_antenna_status.
 * Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
 */
struct mip_filter_multi_antenna_offset {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of the receiver, from 1. Range: at least 1. */
    uint8_t receiver_id;
    /**
     * Lever arm from the sensor to the antenna. Elements: x, y, z. Unit: m. Frame: vehicle. Range:
     * magnitude at most 10. Required for write.
     */
    float antenna_offset[3];
};

#define MIP_FILTER_MULTI_ANTENNA_OFFSET 0x0D54
#define MIP_FILTER_MULTI_ANTENNA_OFFSET_DESCRIPTOR 0x54
MIP_FIELD(mip_filter_multi_antenna_offset, 0x54);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_multi_antenna_offset *
mip_filter_multi_antenna_offset_write(struct mip_filter_multi_antenna_offset *command,
                                      uint8_t receiver_id, const float antenna_offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->receiver_id = receiver_id;
    memcpy(command->antenna_offset, antenna_offset, sizeof(command->antenna_offset));
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_filter_multi_antenna_offset *mip_filter_multi_antenna_offset_read(
    struct mip_filter_multi_antenna_offset *command, uint8_t receiver_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->receiver_id = receiver_id;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_filter_multi_antenna_offset *mip_filter_multi_antenna_offset_save(
    struct mip_filter_multi_antenna_offset *command, uint8_t receiver_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->receiver_id = receiver_id;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_filter_multi_antenna_offset *mip_filter_multi_antenna_offset_load(
    struct mip_filter_multi_antenna_offset *command, uint8_t receiver_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->receiver_id = receiver_id;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_filter_multi_antenna_offset *mip_filter_multi_antenna_offset_default(
    struct mip_filter_multi_antenna_offset *command, uint8_t receiver_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->receiver_id = receiver_id;
    return command;
}

/**
 * GNSS multi-antenna offset response: response (0x0D,0xD4).
 *
 * Response to mip_filter_multi_antenna_offset.
 *
 * - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
 */
struct mip_filter_multi_antenna_offset_response {
    /** Number of the receiver, from 1. Range: at least 1. */
    uint8_t receiver_id;
    /**
     * Lever arm from the sensor to the antenna. Elements: x, y, z. Unit: m. Frame: vehicle. Range:
     * magnitude at most 10.
     */
    float antenna_offset[3];
};

#define MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE 0x0DD4
#define MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR 0xD4
MIP_FIELD(mip_filter_multi_antenna_offset_response, 0xD4);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_multi_antenna_offset *mip_filter_multi_antenna_offset_write_from(
    struct mip_filter_multi_antenna_offset *command,
    const struct mip_filter_multi_antenna_offset_response *response) {
    return mip_filter_multi_antenna_offset_write(command, response->receiver_id,
                                                 response->antenna_offset);
}

/**
 * Relative position configuration: command (0x0D,0x55).
 *
 * Sets the reference point of the relative position that the filter reports.
 *
 * Also called `rel_pos_configuration`. Functions: write, read, save, load and default. Response:
 * mip_filter_relative_position_config_response. Affects mip_filter_data_ned_relative_position.
 *
 * - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
 */
struct mip_filter_relative_position_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the reference point. A value of enum mip_filter_relative_position_source. Required
     * for write.
     */
    uint8_t source;
    /** Frame of the coordinates. A value of enum mip_filter_reference_frame. Required for write. */
    uint8_t reference_frame_selector;
    /**
     * Reference point. Elements: x, y, z. Required for write. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: elements latitude, longitude, height; unit deg, deg, m; frame
     * llh.
     */
    double reference_coordinates[3];
};

#define MIP_FILTER_RELATIVE_POSITION_CONFIG 0x0D55
#define MIP_FILTER_RELATIVE_POSITION_CONFIG_DESCRIPTOR 0x55
MIP_FIELD(mip_filter_relative_position_config, 0x55);
MIP_FILL(mip_filter_relative_position_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_relative_position_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_relative_position_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_relative_position_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_relative_position_config *
mip_filter_relative_position_config_write(struct mip_filter_relative_position_config *command,
                                          enum mip_filter_relative_position_source source,
                                          enum mip_filter_reference_frame reference_frame_selector,
                                          const double reference_coordinates[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    command->reference_frame_selector = (uint8_t)reference_frame_selector;
    memcpy(command->reference_coordinates, reference_coordinates,
           sizeof(command->reference_coordinates));
    return command;
}

/**
 * Relative position configuration response: response (0x0D,0xD5).
 *
 * Also called `rel_pos_configuration_response`. Response to mip_filter_relative_position_config.
 *
 * - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
 */
struct mip_filter_relative_position_config_response {
    /** Source of the reference point. A value of enum mip_filter_relative_position_source. */
    uint8_t source;
    /** Frame of the coordinates. A value of enum mip_filter_reference_frame. */
    uint8_t reference_frame_selector;
    /**
     * Reference point. Elements: x, y, z. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: elements latitude, longitude, height; unit deg, deg, m; frame
     * llh.
     */
    double reference_coordinates[3];
};

#define MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE 0x0DD5
#define MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE_DESCRIPTOR 0xD5
MIP_FIELD(mip_filter_relative_position_config_response, 0xD5);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_relative_position_config *
mip_filter_relative_position_config_write_from(
    struct mip_filter_relative_position_config *command,
    const struct mip_filter_relative_position_config_response *response) {
    return mip_filter_relative_position_config_write(
        command, (enum mip_filter_relative_position_source)response->source,
        (enum mip_filter_reference_frame)response->reference_frame_selector,
        response->reference_coordinates);
}

/**
 * Reference point lever arm: command (0x0D,0x56).
 *
 * Moves the point to which the position and the velocity of the filter refer.
 *
 * Also called `ref_point_lever_arm`. Functions: write, read, save, load and default. Response:
 * mip_filter_reference_point_lever_arm_response. Affects mip_filter_data_llh_position,
 * mip_filter_data_ecef_position, mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity and
 * mip_filter_data_ned_relative_position.
 *
 * The shift in position depends on the attitude; the shift in velocity also depends on the angular
 * rate.
 *
 * - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
 */
struct mip_filter_reference_point_lever_arm {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Point to move; it must be 1. A value of enum mip_filter_reference_point. Required for write.
     */
    uint8_t reference_point;
    /**
     * Lever arm from the sensor to the point. Elements: x, y, z. Unit: m. Frame: vehicle. Range:
     * magnitude at most 10. Required for write.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM 0x0D56
#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_DESCRIPTOR 0x56
MIP_FIELD(mip_filter_reference_point_lever_arm, 0x56);
MIP_FILL(mip_filter_reference_point_lever_arm, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_reference_point_lever_arm, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_reference_point_lever_arm, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_reference_point_lever_arm, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_reference_point_lever_arm *
mip_filter_reference_point_lever_arm_write(struct mip_filter_reference_point_lever_arm *command,
                                           enum mip_filter_reference_point reference_point,
                                           const float lever_arm_offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->reference_point = (uint8_t)reference_point;
    memcpy(command->lever_arm_offset, lever_arm_offset, sizeof(command->lever_arm_offset));
    return command;
}

/**
 * Reference point lever arm response: response (0x0D,0xD6).
 *
 * Also called `ref_point_lever_arm_response`. Response to mip_filter_reference_point_lever_arm.
 *
 * - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
 */
struct mip_filter_reference_point_lever_arm_response {
    /** Point to which the lever arm leads. A value of enum mip_filter_reference_point. */
    uint8_t reference_point;
    /**
     * Lever arm from the sensor to the point. Elements: x, y, z. Unit: m. Frame: vehicle. Range:
     * magnitude at most 10.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE 0x0DD6
#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE_DESCRIPTOR 0xD6
MIP_FIELD(mip_filter_reference_point_lever_arm_response, 0xD6);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_reference_point_lever_arm *
mip_filter_reference_point_lever_arm_write_from(
    struct mip_filter_reference_point_lever_arm *command,
    const struct mip_filter_reference_point_lever_arm_response *response) {
    return mip_filter_reference_point_lever_arm_write(
        command, (enum mip_filter_reference_point)response->reference_point,
        response->lever_arm_offset);
}

/**
 * Speed measurement: command (0x0D,0x60).
 *
 * Sends one measurement of the forward speed of the vehicle (along its x axis) to the filter.
 *
 * Known only from the MicroStrain MIP SDK. Uncertain: The SDK names a response,
 * `filter.speed_measurement_response`, but has no layout of it.
 *
 * Do not use it together with the device's odometer.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - mip-sdk-4: Speed measurement (0x0D,0x60)
 */
struct mip_filter_speed_measurement {
    /** Send 1. Reserved: send 1. */
    uint8_t source;
    /**
     * GPS time of week of the measurement. Unit: s. Range: 0 to 604800. Uncertain: The unit is
     * inferred; the SDK states none.
     */
    float tow;
    /** Speed along the x axis of the vehicle. Unit: m/s. Frame: vehicle. Positive: forward. */
    float speed;
    /** Standard deviation of the speed. Unit: m/s. Range: at least 0. */
    float speed_uncertainty;
};

#define MIP_FILTER_SPEED_MEASUREMENT 0x0D60
#define MIP_FILTER_SPEED_MEASUREMENT_DESCRIPTOR 0x60
MIP_FIELD(mip_filter_speed_measurement, 0x60);

/** Fills the structure, and returns it. */
static inline struct mip_filter_speed_measurement *mip_filter_speed_measurement_make(
    struct mip_filter_speed_measurement *command, float tow, float speed, float speed_uncertainty) {
    memset(command, 0, sizeof(*command));
    command->source = 1;
    command->tow = tow;
    command->speed = speed;
    command->speed_uncertainty = speed_uncertainty;
    return command;
}

/**
 * Speed measurement lever arm: command (0x0D,0x61).
 *
 * Sets the position of the point whose speed is measured, such as the wheel that drives the
 * odometer.
 *
 * Functions: write, read, save, load and default. Response: mip_filter_speed_lever_arm_response.
 * Probably affects mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity and
 * mip_filter_data_odometer_scale_factor_error.
 *
 * It corrects for the part of the speed at that point that is due to the rotation of the vehicle.
 *
 * - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
 */
struct mip_filter_speed_lever_arm {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Reserved: send 1. */
    uint8_t source;
    /**
     * Lever arm from the sensor to the point of measurement. Elements: x, y, z. Unit: m. Frame:
     * vehicle. Required for write.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_SPEED_LEVER_ARM 0x0D61
#define MIP_FILTER_SPEED_LEVER_ARM_DESCRIPTOR 0x61
MIP_FIELD(mip_filter_speed_lever_arm, 0x61);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_speed_lever_arm *mip_filter_speed_lever_arm_write(
    struct mip_filter_speed_lever_arm *command, const float lever_arm_offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = 1;
    memcpy(command->lever_arm_offset, lever_arm_offset, sizeof(command->lever_arm_offset));
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_filter_speed_lever_arm *
mip_filter_speed_lever_arm_read(struct mip_filter_speed_lever_arm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->source = 1;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_filter_speed_lever_arm *
mip_filter_speed_lever_arm_save(struct mip_filter_speed_lever_arm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->source = 1;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_filter_speed_lever_arm *
mip_filter_speed_lever_arm_load(struct mip_filter_speed_lever_arm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->source = 1;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_filter_speed_lever_arm *
mip_filter_speed_lever_arm_default(struct mip_filter_speed_lever_arm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->source = 1;
    return command;
}

/**
 * Speed measurement lever arm response: response (0x0D,0xE1).
 *
 * Response to mip_filter_speed_lever_arm.
 *
 * - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
 */
struct mip_filter_speed_lever_arm_response {
    /** Reserved. */
    uint8_t source;
    /**
     * Lever arm from the sensor to the point of measurement. Elements: x, y, z. Unit: m. Frame:
     * vehicle.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_SPEED_LEVER_ARM_RESPONSE 0x0DE1
#define MIP_FILTER_SPEED_LEVER_ARM_RESPONSE_DESCRIPTOR 0xE1
MIP_FIELD(mip_filter_speed_lever_arm_response, 0xE1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_speed_lever_arm *
mip_filter_speed_lever_arm_write_from(struct mip_filter_speed_lever_arm *command,
                                      const struct mip_filter_speed_lever_arm_response *response) {
    return mip_filter_speed_lever_arm_write(command, response->lever_arm_offset);
}

/**
 * Vertical gyro constraint: command (0x0D,0x62).
 *
 * Sets whether the filter maintains pitch and roll with the accelerometers while there is no GNSS.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_vertical_gyro_constraint_control_response. Probably affects
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm and
 * mip_filter_data_euler_angles. Known only from the MicroStrain MIP SDK.
 *
 * It assumes that the linear acceleration is zero.
 *
 * - mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
 */
struct mip_filter_vertical_gyro_constraint_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
};

#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL 0x0D62
#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL_DESCRIPTOR 0x62
MIP_FIELD(mip_filter_vertical_gyro_constraint_control, 0x62);
MIP_FILL(mip_filter_vertical_gyro_constraint_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_vertical_gyro_constraint_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_vertical_gyro_constraint_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_vertical_gyro_constraint_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_vertical_gyro_constraint_control *
mip_filter_vertical_gyro_constraint_control_write(
    struct mip_filter_vertical_gyro_constraint_control *command, uint8_t enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    return command;
}

/**
 * Vertical gyro constraint response: response (0x0D,0xE2).
 *
 * Response to mip_filter_vertical_gyro_constraint_control. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
 */
struct mip_filter_vertical_gyro_constraint_control_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL_RESPONSE 0x0DE2
#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_CONTROL_RESPONSE_DESCRIPTOR 0xE2
MIP_FIELD(mip_filter_vertical_gyro_constraint_control_response, 0xE2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_vertical_gyro_constraint_control *
mip_filter_vertical_gyro_constraint_control_write_from(
    struct mip_filter_vertical_gyro_constraint_control *command,
    const struct mip_filter_vertical_gyro_constraint_control_response *response) {
    return mip_filter_vertical_gyro_constraint_control_write(command, response->enable);
}

/**
 * Wheeled vehicle constraint: command (0x0D,0x63).
 *
 * Sets whether the filter assumes that the vehicle moves only along its x axis.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_filter_wheeled_vehicle_constraint_control_response. Probably affects
 * mip_filter_data_ned_velocity, mip_filter_data_ecef_velocity, mip_filter_data_attitude_quaternion,
 * mip_filter_data_attitude_dcm and mip_filter_data_euler_angles.
 *
 * It improves the heading of cars and similar vehicles, especially with intermittent GNSS. Do not
 * use it for vehicles that move sideways, such as aircraft.
 *
 * - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
 */
struct mip_filter_wheeled_vehicle_constraint_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
};

#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL 0x0D63
#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL_DESCRIPTOR 0x63
MIP_FIELD(mip_filter_wheeled_vehicle_constraint_control, 0x63);
MIP_FILL(mip_filter_wheeled_vehicle_constraint_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_wheeled_vehicle_constraint_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_wheeled_vehicle_constraint_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_wheeled_vehicle_constraint_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_wheeled_vehicle_constraint_control *
mip_filter_wheeled_vehicle_constraint_control_write(
    struct mip_filter_wheeled_vehicle_constraint_control *command, uint8_t enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    return command;
}

/**
 * Wheeled vehicle constraint response: response (0x0D,0xE3).
 *
 * Response to mip_filter_wheeled_vehicle_constraint_control.
 *
 * - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
 */
struct mip_filter_wheeled_vehicle_constraint_control_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE 0x0DE3
#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_CONTROL_RESPONSE_DESCRIPTOR 0xE3
MIP_FIELD(mip_filter_wheeled_vehicle_constraint_control_response, 0xE3);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_wheeled_vehicle_constraint_control *
mip_filter_wheeled_vehicle_constraint_control_write_from(
    struct mip_filter_wheeled_vehicle_constraint_control *command,
    const struct mip_filter_wheeled_vehicle_constraint_control_response *response) {
    return mip_filter_wheeled_vehicle_constraint_control_write(command, response->enable);
}

/**
 * GNSS antenna offset calibration: command (0x0D,0x64).
 *
 * Enables antenna offset calibration.
 *
 * Also called `gnss_antenna_cal_control`. Functions: write, read, save, load and default. Response:
 * mip_filter_gnss_antenna_calibration_control_response. Affects
 * mip_filter_data_multi_antenna_offset_correction. Probably affects
 * mip_filter_data_multi_antenna_offset_uncertainty. Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
 * - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
 */
struct mip_filter_gnss_antenna_calibration_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Largest absolute error that is tracked. Unit: m. Frame: vehicle. Range: at least 0. Required
     * for write. On the 3DM-CV7-GNSS/INS: range 0 to 0.5; default 0.1.
     */
    float max_offset;
};

#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL 0x0D64
#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL_DESCRIPTOR 0x64
MIP_FIELD(mip_filter_gnss_antenna_calibration_control, 0x64);
MIP_FILL(mip_filter_gnss_antenna_calibration_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_filter_gnss_antenna_calibration_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_filter_gnss_antenna_calibration_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_filter_gnss_antenna_calibration_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_filter_gnss_antenna_calibration_control *
mip_filter_gnss_antenna_calibration_control_write(
    struct mip_filter_gnss_antenna_calibration_control *command, uint8_t enable, float max_offset) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = enable;
    command->max_offset = max_offset;
    return command;
}

/**
 * GNSS antenna offset calibration response: response (0x0D,0xE4).
 *
 * Also called `gnss_antenna_cal_control_response`. Response to
 * mip_filter_gnss_antenna_calibration_control.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
 * - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
 */
struct mip_filter_gnss_antenna_calibration_control_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Largest absolute error that is tracked. Unit: m. Frame: vehicle. Range: at least 0. */
    float max_offset;
};

#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL_RESPONSE 0x0DE4
#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_CONTROL_RESPONSE_DESCRIPTOR 0xE4
MIP_FIELD(mip_filter_gnss_antenna_calibration_control_response, 0xE4);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_filter_gnss_antenna_calibration_control *
mip_filter_gnss_antenna_calibration_control_write_from(
    struct mip_filter_gnss_antenna_calibration_control *command,
    const struct mip_filter_gnss_antenna_calibration_control_response *response) {
    return mip_filter_gnss_antenna_calibration_control_write(command, response->enable,
                                                             response->max_offset);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
