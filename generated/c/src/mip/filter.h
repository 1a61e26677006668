/**
 * @file
 *
 * Filter commands (0x0D). Commands that set up, start and aid the navigation filter.
 */
#ifndef MIP_FILTER_H
#define MIP_FILTER_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/filter.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_FILTER_SET 0x0D

/**
 * Kind of vehicle that the filter is tuned for. Uncertain: The SDK names the modes only; the
 * descriptions follow from the names. Uncertain: mip_filter_data_status reports a mode too, but is
 * known to have the values 1 to 3 only.
 *
 * - mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
 */
typedef uint8_t mip_filter_dynamics_mode;
/** Carried by hand. */
#define MIP_FILTER_DYNAMICS_MODE_PORTABLE 1
/** Ground vehicle. */
#define MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE 2
/** Aircraft. */
#define MIP_FILTER_DYNAMICS_MODE_AIRBORNE 3
/** Aircraft under high acceleration. */
#define MIP_FILTER_DYNAMICS_MODE_AIRBORNE_HIGH_G 4

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
/** Bit 5. Estimate the hard iron offset of the magnetometer. */
#define MIP_FILTER_ESTIMATED_STATES_AUTO_HARD_IRON 0x0020U
/** Bit 6. Estimate the soft iron matrix of the magnetometer. */
#define MIP_FILTER_ESTIMATED_STATES_AUTO_SOFT_IRON 0x0040U

/** Where the filter takes GNSS data from. */
typedef uint8_t mip_filter_gnss_aiding_source;
/** All internal receivers. */
#define MIP_FILTER_GNSS_AIDING_SOURCE_ALL_INTERNAL 1
/** GNSS measurements that the user sends. */
#define MIP_FILTER_GNSS_AIDING_SOURCE_EXTERNAL 2
/** Internal receiver 1 only. */
#define MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_1 3
/** Internal receiver 2 only. */
#define MIP_FILTER_GNSS_AIDING_SOURCE_INTERNAL_2 4

/** The north that a heading refers to. */
typedef uint8_t mip_filter_heading_type;
/** True north. */
#define MIP_FILTER_HEADING_TYPE_TRUE_HEADING 1
/** Magnetic north. */
#define MIP_FILTER_HEADING_TYPE_MAGNETIC_HEADING 2

/**
 * Where the filter takes heading updates from.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 * - 3dm-gx5-45: (0x0D, 0x18)
 * - mip-sdk-4: Heading Source (0x0D,0x18)
 */
typedef uint8_t mip_filter_heading_update_source;
/** No heading updates. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_NONE 0
/** The magnetometer. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_MAG 1
/** The velocity that the GNSS receiver measures. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY 2
/** The heading messages that the user sends. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL 3
/** GNSS velocity and magnetometer. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY_AND_MAG 4
/** GNSS velocity and the messages of the user. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY_AND_EXTERNAL 5
/** Magnetometer and the messages of the user. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_MAG_AND_EXTERNAL 6
/** All three. */
#define MIP_FILTER_HEADING_UPDATE_SOURCE_ALL 7

/** Axes to tare; 0 resets all axes. */
typedef uint8_t mip_filter_tare_axes;
/** Bit 0. Tare roll. */
#define MIP_FILTER_TARE_AXES_ROLL 0x01U
/** Bit 1. Tare pitch. */
#define MIP_FILTER_TARE_AXES_PITCH 0x02U
/** Bit 2. Tare yaw. */
#define MIP_FILTER_TARE_AXES_YAW 0x04U

/** Measurements that the filter uses. */
typedef uint16_t mip_filter_measurement_flags;
/** Bit 0. Accelerometer measurements. */
#define MIP_FILTER_MEASUREMENT_FLAGS_ACCEL 0x0001U
/** Bit 1. Magnetometer measurements, on models that have a magnetometer. */
#define MIP_FILTER_MEASUREMENT_FLAGS_MAG 0x0002U

/** Where the declination, the inclination or the magnitude of the magnetic field comes from. */
typedef uint8_t mip_filter_mag_parameter_source;
/** No source. Uncertain: What the device does without a source. */
#define MIP_FILTER_MAG_PARAMETER_SOURCE_NONE 1
/** The World Magnetic Model, at the estimated position. */
#define MIP_FILTER_MAG_PARAMETER_SOURCE_WMM 2
/** The value that the command gives. */
#define MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL 3

/** How measurements are weighted whose magnitude is not as expected. */
typedef uint8_t mip_filter_adaptive_measurement_selector;
/** No adaptation. */
#define MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED 0
/** Adapted by the limits that the command gives. */
#define MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED 1
/** Adapted by the filter itself; the limits are ignored. 3DM-GX5 and later. */
#define MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_AUTO 2

/**
 * What aids the altitude.
 *
 * - mip-sdk-4: Altitude Aiding (0x0D,0x47)
 */
typedef uint8_t mip_filter_altitude_aiding_source;
/** No aiding. */
#define MIP_FILTER_ALTITUDE_AIDING_SOURCE_NONE 0
/** The pressure sensor. */
#define MIP_FILTER_ALTITUDE_AIDING_SOURCE_PRESSURE 1

/** What aids pitch and roll. */
typedef uint8_t mip_filter_pitch_roll_aiding_source;
/** No aiding. */
#define MIP_FILTER_PITCH_ROLL_AIDING_SOURCE_NONE 0
/** The measured gravity vector. */
#define MIP_FILTER_PITCH_ROLL_AIDING_SOURCE_GRAVITY_VECTOR 1

/** A source of aiding measurements. */
typedef uint16_t mip_filter_aiding_source;
/** GNSS position and velocity. */
#define MIP_FILTER_AIDING_SOURCE_GNSS_POSITION_VELOCITY 0
/** GNSS heading of two antennas. */
#define MIP_FILTER_AIDING_SOURCE_GNSS_HEADING 1
/** Built-in pressure altimeter. */
#define MIP_FILTER_AIDING_SOURCE_ALTIMETER 2
/** Speed sensor or odometer. */
#define MIP_FILTER_AIDING_SOURCE_SPEED 3
/** Built-in magnetometer. */
#define MIP_FILTER_AIDING_SOURCE_MAG 4
/** Heading that the user sends. */
#define MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING 5
/** Pressure altitude that the user sends. */
#define MIP_FILTER_AIDING_SOURCE_EXTERNAL_ALTIMETER 6
/** Magnetic field that the user sends. */
#define MIP_FILTER_AIDING_SOURCE_EXTERNAL_MAG 7
/** Velocity in the vehicle that the user sends. */
#define MIP_FILTER_AIDING_SOURCE_BODY_FRAME_VELOCITY 8
/** All sources, for save, load and default. */
#define MIP_FILTER_AIDING_SOURCE_ALL 0xFFFF

/**
 * What the filter assumes about the acceleration.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
typedef uint8_t mip_filter_accel_constraint;
/** Nothing. */
#define MIP_FILTER_ACCEL_CONSTRAINT_NONE 0
/** It is zero. */
#define MIP_FILTER_ACCEL_CONSTRAINT_ZERO_ACCEL 1

/**
 * What the filter assumes about the velocity.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
typedef uint8_t mip_filter_velocity_constraint;
/** Nothing. */
#define MIP_FILTER_VELOCITY_CONSTRAINT_NONE 0
/** It is zero. */
#define MIP_FILTER_VELOCITY_CONSTRAINT_ZERO_VELOCITY 1
/** It is that of a wheeled vehicle. */
#define MIP_FILTER_VELOCITY_CONSTRAINT_WHEELED_VEHICLE 2

/**
 * What the filter assumes about the angular rate.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
typedef uint8_t mip_filter_angular_constraint;
/** Nothing. */
#define MIP_FILTER_ANGULAR_CONSTRAINT_NONE 0
/** It is zero. */
#define MIP_FILTER_ANGULAR_CONSTRAINT_ZERO_ANGULAR_RATE 1

/** Which initial conditions the device finds itself and which the user gives. */
typedef uint8_t mip_filter_initial_condition_source;
/** Position, velocity and attitude are found. In full: auto_position_velocity_attitude. */
#define MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POS_VEL_ATTITUDE 0
/**
 * Position, velocity, pitch and roll are found; the heading is given. In full:
 * auto_position_velocity_pitch_roll.
 */
#define MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POS_VEL_PITCH_ROLL 1
/** Position and velocity are found; the attitude is given. In full: auto_position_velocity. */
#define MIP_FILTER_INITIAL_CONDITION_SOURCE_AUTO_POS_VEL 2
/** Position, velocity and attitude are given. */
#define MIP_FILTER_INITIAL_CONDITION_SOURCE_MANUAL 3

/** Ways in which the device may find its initial heading. */
typedef uint8_t mip_filter_heading_alignment;
/** Bit 0. From the baseline between two GNSS antennas. */
#define MIP_FILTER_HEADING_ALIGNMENT_DUAL_ANTENNA 0x01U
/** Bit 1. From the GNSS velocity; assumes motion along the positive x axis of the vehicle. */
#define MIP_FILTER_HEADING_ALIGNMENT_KINEMATIC 0x02U
/** Bit 2. From the built-in magnetometer. */
#define MIP_FILTER_HEADING_ALIGNMENT_MAG 0x04U
/** Bit 3. From the heading that the user sends. */
#define MIP_FILTER_HEADING_ALIGNMENT_EXTERNAL 0x08U

/** Frame in which a position is given. */
typedef uint8_t mip_filter_reference_frame;
/** Earth-centred, Earth-fixed coordinates (WGS84). */
#define MIP_FILTER_REFERENCE_FRAME_ECEF 1
/** Latitude, longitude and height above the ellipsoid (WGS84). */
#define MIP_FILTER_REFERENCE_FRAME_LLH 2

/** How strongly the filter adapts to measurements that do not fit. */
typedef uint8_t mip_filter_adaptive_level;
/** No adaptation. */
#define MIP_FILTER_ADAPTIVE_LEVEL_OFF 0
/** Little adaptation. */
#define MIP_FILTER_ADAPTIVE_LEVEL_CONSERVATIVE 1
/** Moderate adaptation. */
#define MIP_FILTER_ADAPTIVE_LEVEL_MODERATE 2
/** Strong adaptation. */
#define MIP_FILTER_ADAPTIVE_LEVEL_AGGRESSIVE 3

/** Where the reference of relative positions comes from. */
typedef uint8_t mip_filter_relative_position_source;
/** The base station of the RTK corrections. */
#define MIP_FILTER_RELATIVE_POSITION_SOURCE_AUTO 0
/** The coordinates that the command gives. */
#define MIP_FILTER_RELATIVE_POSITION_SOURCE_MANUAL 1

/** A point of reference. */
typedef uint8_t mip_filter_reference_point;
/** The origin of the vehicle. */
#define MIP_FILTER_REFERENCE_POINT_VEHICLE 1

/**
 * Reset navigation filter: command (0x0D,0x01).
 *
 * Puts the filter back into its initialization state.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GX5-15, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST. May be supported by 3DM-GX5-45.
 *
 * If automatic initialization is off, the attitude or heading must be set before the filter runs
 * again.
 *
 * 3DM-CV7: send it after a large jump of the system time, for example when the PPS is first found.
 *
 * - 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01)
 * - 3dm-gx5-15: 4.3.1 Reset Filter (0x0D, 0x01)
 */
struct mip_filter_reset {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_RESET_DESCRIPTOR 0x01
#define MIP_FILTER_RESET_NAME "filter.reset"

extern const struct mip_codec mip_filter_reset_codec;
mip_error mip_filter_reset_decode(struct mip_filter_reset *value, const struct mip_field *field);
mip_error mip_filter_reset_encode(const struct mip_filter_reset *value,
                                  struct mip_builder *builder);

/**
 * Set initial attitude: command (0x0D,0x02).
 *
 * Gives the filter its initial attitude, the orientation of the sensor frame in the NED frame.
 *
 * Supported by 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. May be supported by 3DM-GX5-45.
 *
 * Accepted only in the initialization state.
 *
 * - 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02)
 */
struct mip_filter_set_initial_attitude {
    /** Roll angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. */
    float roll;
    /** Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. */
    float pitch;
    /**
     * Heading (yaw) angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
     */
    float heading;
};

#define MIP_FILTER_SET_INITIAL_ATTITUDE_DESCRIPTOR 0x02
#define MIP_FILTER_SET_INITIAL_ATTITUDE_NAME "filter.set_initial_attitude"

extern const struct mip_codec mip_filter_set_initial_attitude_codec;
mip_error mip_filter_set_initial_attitude_decode(struct mip_filter_set_initial_attitude *value,
                                                 const struct mip_field *field);
mip_error mip_filter_set_initial_attitude_encode(
    const struct mip_filter_set_initial_attitude *value, struct mip_builder *builder);
/** Set initial attitude. */
struct mip_filter_set_initial_attitude mip_filter_set_initial_attitude_make(float roll, float pitch,
                                                                            float heading);

/**
 * Set initial heading: command (0x0D,0x03).
 *
 * Gives the filter its initial heading; pitch and roll come from the accelerometers.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT
 * and 3DM-RQ1-45-ST.
 *
 * 3DM-GX5: accepted only in the initialization state.
 *
 * 3DM-CV7: resets the estimated heading; if magnetometer aiding is on, the given heading is
 * ignored.
 *
 * - 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03)
 * - 3dm-gx5-15: 4.3.3 Set Initial Heading (0x0D, 0x03)
 */
struct mip_filter_set_initial_heading {
    /** Initial heading. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. */
    float heading;
};

#define MIP_FILTER_SET_INITIAL_HEADING_DESCRIPTOR 0x03
#define MIP_FILTER_SET_INITIAL_HEADING_NAME "filter.set_initial_heading"

extern const struct mip_codec mip_filter_set_initial_heading_codec;
mip_error mip_filter_set_initial_heading_decode(struct mip_filter_set_initial_heading *value,
                                                const struct mip_field *field);
mip_error mip_filter_set_initial_heading_encode(const struct mip_filter_set_initial_heading *value,
                                                struct mip_builder *builder);
/** Set initial heading. */
struct mip_filter_set_initial_heading mip_filter_set_initial_heading_make(float heading);

/**
 * Run navigation filter: command (0x0D,0x05).
 *
 * Starts a filter that was set up to wait for this command.
 *
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
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

#define MIP_FILTER_RUN_DESCRIPTOR 0x05
#define MIP_FILTER_RUN_NAME "filter.run"

extern const struct mip_codec mip_filter_run_codec;
mip_error mip_filter_run_decode(struct mip_filter_run *value, const struct mip_field *field);
mip_error mip_filter_run_encode(const struct mip_filter_run *value, struct mip_builder *builder);

/**
 * Vehicle dynamics mode: command (0x0D,0x10).
 *
 * Kind of vehicle that the filter is tuned for.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_vehicle_dynamics_mode_response. Supported by 3DM-GX5-45. May be supported by
 * 3DM-GX3-45. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
 */
struct mip_filter_vehicle_dynamics_mode {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Kind of vehicle. Required for write. On the 3DM-GX3-45: only
     * MIP_FILTER_DYNAMICS_MODE_PORTABLE, MIP_FILTER_DYNAMICS_MODE_AUTOMOTIVE and
     * MIP_FILTER_DYNAMICS_MODE_AIRBORNE.
     */
    mip_filter_dynamics_mode mode;
};

#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_DESCRIPTOR 0x10
#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_NAME "filter.vehicle_dynamics_mode"

extern const struct mip_codec mip_filter_vehicle_dynamics_mode_codec;
mip_error mip_filter_vehicle_dynamics_mode_decode(struct mip_filter_vehicle_dynamics_mode *value,
                                                  const struct mip_field *field);
mip_error mip_filter_vehicle_dynamics_mode_encode(
    const struct mip_filter_vehicle_dynamics_mode *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_vehicle_dynamics_mode
mip_filter_vehicle_dynamics_mode_write(mip_filter_dynamics_mode mode);
/** Send the current setting back in a response. */
struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_save(void);
/** Load the saved setting. */
struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_load(void);
/** Load the factory default setting. */
struct mip_filter_vehicle_dynamics_mode mip_filter_vehicle_dynamics_mode_default(void);

/**
 * Vehicle dynamics mode response: response (0x0D,0x80).
 *
 * Answers mip_filter_vehicle_dynamics_mode. Supported by 3DM-GX5-45. May be supported by
 * 3DM-GX3-45. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
 */
struct mip_filter_vehicle_dynamics_mode_response {
    /** Kind of vehicle. */
    mip_filter_dynamics_mode mode;
};

#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE_DESCRIPTOR 0x80
#define MIP_FILTER_VEHICLE_DYNAMICS_MODE_RESPONSE_NAME "filter.vehicle_dynamics_mode_response"

extern const struct mip_codec mip_filter_vehicle_dynamics_mode_response_codec;
mip_error mip_filter_vehicle_dynamics_mode_response_decode(
    struct mip_filter_vehicle_dynamics_mode_response *value, const struct mip_field *field);
mip_error mip_filter_vehicle_dynamics_mode_response_encode(
    const struct mip_filter_vehicle_dynamics_mode_response *value, struct mip_builder *builder);

/**
 * Sensor to vehicle frame transformation: command (0x0D,0x11).
 *
 * Euler angles of the rotation from the sensor frame to the vehicle frame (5-series).
 *
 * In full: filter.sensor_to_vehicle_rotation_euler.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_sensor_to_vehicle_euler_response. Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
 * velocity, and the orientation, compensated and linear acceleration, angular rate and gravity
 * vector of the filter.
 *
 * The 3DM-CV7 takes the inverse instead: mip_3dm_sensor_to_vehicle_euler.
 *
 * - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
 */
struct mip_filter_sensor_to_vehicle_euler {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Roll angle. Unit: rad. Required for write. */
    float roll;
    /** Pitch angle. Unit: rad. Required for write. */
    float pitch;
    /** Yaw angle. Unit: rad. Required for write. */
    float yaw;
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_EULER_DESCRIPTOR 0x11
#define MIP_FILTER_SENSOR_TO_VEHICLE_EULER_NAME "filter.sensor_to_vehicle_rotation_euler"

extern const struct mip_codec mip_filter_sensor_to_vehicle_euler_codec;
mip_error mip_filter_sensor_to_vehicle_euler_decode(
    struct mip_filter_sensor_to_vehicle_euler *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_euler_encode(
    const struct mip_filter_sensor_to_vehicle_euler *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_write(float roll,
                                                                                   float pitch,
                                                                                   float yaw);
/** Send the current setting back in a response. */
struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_save(void);
/** Load the saved setting. */
struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_load(void);
/** Load the factory default setting. */
struct mip_filter_sensor_to_vehicle_euler mip_filter_sensor_to_vehicle_euler_default(void);

/**
 * Sensor to vehicle frame transformation response: response (0x0D,0x81).
 *
 * In full: filter.sensor_to_vehicle_rotation_euler_response.
 *
 * Answers mip_filter_sensor_to_vehicle_euler. Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
 */
struct mip_filter_sensor_to_vehicle_euler_response {
    /** Roll angle. Unit: rad. */
    float roll;
    /** Pitch angle. Unit: rad. */
    float pitch;
    /** Yaw angle. Unit: rad. */
    float yaw;
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_EULER_RESPONSE_DESCRIPTOR 0x81
#define MIP_FILTER_SENSOR_TO_VEHICLE_EULER_RESPONSE_NAME \
    "filter.sensor_to_vehicle_rotation_euler_response"

extern const struct mip_codec mip_filter_sensor_to_vehicle_euler_response_codec;
mip_error mip_filter_sensor_to_vehicle_euler_response_decode(
    struct mip_filter_sensor_to_vehicle_euler_response *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_euler_response_encode(
    const struct mip_filter_sensor_to_vehicle_euler_response *value, struct mip_builder *builder);

/**
 * Sensor to vehicle offset: command (0x0D,0x12).
 *
 * Origin of the vehicle frame, as seen from the sensor.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_sensor_to_vehicle_offset_response. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only. Uncertain: The direction, from the sensor to the origin of the vehicle frame, is
 * inferred from the name.
 *
 * It shifts mip_filter_data_llh_position and nothing else.
 *
 * The shift is constant. It does not follow the attitude, as a lever arm would.
 *
 * - mip-sdk-4: Sensor To Vehicle Offset (0x0D,0x12)
 */
struct mip_filter_sensor_to_vehicle_offset {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * From the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m. Frame:
     * sensor. Range: magnitude at most 10. Required for write.
     */
    float offset[3];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_DESCRIPTOR 0x12
#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_NAME "filter.sensor_to_vehicle_offset"

extern const struct mip_codec mip_filter_sensor_to_vehicle_offset_codec;
mip_error mip_filter_sensor_to_vehicle_offset_decode(
    struct mip_filter_sensor_to_vehicle_offset *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_offset_encode(
    const struct mip_filter_sensor_to_vehicle_offset *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_sensor_to_vehicle_offset
mip_filter_sensor_to_vehicle_offset_write(const float offset[3]);
/** Send the current setting back in a response. */
struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_save(void);
/** Load the saved setting. */
struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_load(void);
/** Load the factory default setting. */
struct mip_filter_sensor_to_vehicle_offset mip_filter_sensor_to_vehicle_offset_default(void);

/**
 * Sensor to vehicle offset response: response (0x0D,0x82).
 *
 * Answers mip_filter_sensor_to_vehicle_offset. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Sensor To Vehicle Offset (0x0D,0x12)
 */
struct mip_filter_sensor_to_vehicle_offset_response {
    /**
     * From the sensor to the origin of the vehicle frame. Elements: x, y, z. Unit: m. Frame:
     * sensor. Range: magnitude at most 10.
     */
    float offset[3];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE_DESCRIPTOR 0x82
#define MIP_FILTER_SENSOR_TO_VEHICLE_OFFSET_RESPONSE_NAME "filter.sensor_to_vehicle_offset_response"

extern const struct mip_codec mip_filter_sensor_to_vehicle_offset_response_codec;
mip_error mip_filter_sensor_to_vehicle_offset_response_decode(
    struct mip_filter_sensor_to_vehicle_offset_response *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_offset_response_encode(
    const struct mip_filter_sensor_to_vehicle_offset_response *value, struct mip_builder *builder);

/**
 * GNSS antenna offset: command (0x0D,0x13).
 *
 * Position of the GNSS antenna relative to the origin of the sensor.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_antenna_offset_response.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GX5-45.
 *
 * 7-series devices expect the vehicle frame, 5-series devices the sensor frame.
 *
 * On the 3DM-CV7 it is for GNSS data that come as NMEA; data that come by the aiding commands use
 * mip_aiding_frame_config.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
 */
struct mip_filter_antenna_offset {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * From the sensor origin to the centre of the antenna. Elements: x, y, z. Unit: m. Frame:
     * vehicle. Range: magnitude at most 10. Required for write.
     */
    float offset[3];
};

#define MIP_FILTER_ANTENNA_OFFSET_DESCRIPTOR 0x13
#define MIP_FILTER_ANTENNA_OFFSET_NAME "filter.antenna_offset"

extern const struct mip_codec mip_filter_antenna_offset_codec;
mip_error mip_filter_antenna_offset_decode(struct mip_filter_antenna_offset *value,
                                           const struct mip_field *field);
mip_error mip_filter_antenna_offset_encode(const struct mip_filter_antenna_offset *value,
                                           struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_antenna_offset mip_filter_antenna_offset_write(const float offset[3]);
/** Send the current setting back in a response. */
struct mip_filter_antenna_offset mip_filter_antenna_offset_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_antenna_offset mip_filter_antenna_offset_save(void);
/** Load the saved setting. */
struct mip_filter_antenna_offset mip_filter_antenna_offset_load(void);
/** Load the factory default setting. */
struct mip_filter_antenna_offset mip_filter_antenna_offset_default(void);

/**
 * GNSS antenna offset response: response (0x0D,0x83).
 *
 * Answers mip_filter_antenna_offset. Supported by 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
 */
struct mip_filter_antenna_offset_response {
    /**
     * From the sensor origin to the centre of the antenna. Elements: x, y, z. Unit: m. Frame:
     * vehicle. Range: magnitude at most 10.
     */
    float offset[3];
};

#define MIP_FILTER_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR 0x83
#define MIP_FILTER_ANTENNA_OFFSET_RESPONSE_NAME "filter.antenna_offset_response"

extern const struct mip_codec mip_filter_antenna_offset_response_codec;
mip_error mip_filter_antenna_offset_response_decode(
    struct mip_filter_antenna_offset_response *value, const struct mip_field *field);
mip_error mip_filter_antenna_offset_response_encode(
    const struct mip_filter_antenna_offset_response *value, struct mip_builder *builder);

/**
 * Estimation control flags: command (0x0D,0x14).
 *
 * Which states the filter estimates.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_estimation_control_response. Supported by 3DM-GX5-15 and 3DM-GX5-45. May be supported
 * by 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-15, 3DM-CV5-25, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15,
 * 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-25, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 */
struct mip_filter_estimation_control {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * States to estimate. Required for write. On the 3DM-CL5-15, 3DM-CV5-15, 3DM-GX3-45,
     * 3DM-GX4-15, 3DM-GX4-25 and 3DM-GX5-15: only MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS. On the
     * 3DM-CL5-25, 3DM-CV5-25 and 3DM-GX5-25: only MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS,
     * MIP_FILTER_ESTIMATED_STATES_AUTO_HARD_IRON and MIP_FILTER_ESTIMATED_STATES_AUTO_SOFT_IRON. On
     * the 3DM-GQ4-45, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     * MIP_FILTER_ESTIMATED_STATES_GYRO_BIAS, MIP_FILTER_ESTIMATED_STATES_ACCEL_BIAS,
     * MIP_FILTER_ESTIMATED_STATES_GYRO_SCALE_FACTOR, MIP_FILTER_ESTIMATED_STATES_ACCEL_SCALE_FACTOR
     * and MIP_FILTER_ESTIMATED_STATES_ANTENNA_OFFSET.
     */
    mip_filter_estimated_states flags;
};

#define MIP_FILTER_ESTIMATION_CONTROL_DESCRIPTOR 0x14
#define MIP_FILTER_ESTIMATION_CONTROL_NAME "filter.estimation_control"

extern const struct mip_codec mip_filter_estimation_control_codec;
mip_error mip_filter_estimation_control_decode(struct mip_filter_estimation_control *value,
                                               const struct mip_field *field);
mip_error mip_filter_estimation_control_encode(const struct mip_filter_estimation_control *value,
                                               struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_estimation_control
mip_filter_estimation_control_write(mip_filter_estimated_states flags);
/** Send the current setting back in a response. */
struct mip_filter_estimation_control mip_filter_estimation_control_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_estimation_control mip_filter_estimation_control_save(void);
/** Load the saved setting. */
struct mip_filter_estimation_control mip_filter_estimation_control_load(void);
/** Load the factory default setting. */
struct mip_filter_estimation_control mip_filter_estimation_control_default(void);

/**
 * Estimation control flags response: response (0x0D,0x84).
 *
 * Answers mip_filter_estimation_control. Supported by 3DM-GX5-15 and 3DM-GX5-45. May be supported
 * by 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-15, 3DM-CV5-25, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15,
 * 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-25, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
 */
struct mip_filter_estimation_control_response {
    /** States to estimate. */
    mip_filter_estimated_states flags;
};

#define MIP_FILTER_ESTIMATION_CONTROL_RESPONSE_DESCRIPTOR 0x84
#define MIP_FILTER_ESTIMATION_CONTROL_RESPONSE_NAME "filter.estimation_control_response"

extern const struct mip_codec mip_filter_estimation_control_response_codec;
mip_error mip_filter_estimation_control_response_decode(
    struct mip_filter_estimation_control_response *value, const struct mip_field *field);
mip_error mip_filter_estimation_control_response_encode(
    const struct mip_filter_estimation_control_response *value, struct mip_builder *builder);

/**
 * GNSS aiding source: command (0x0D,0x15).
 *
 * Which GNSS receiver aids the filter.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_gnss_source_response.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45.
 *
 * A change while the filter runs may put it back into initialization until the new source gives
 * data.
 *
 * - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
 */
struct mip_filter_gnss_source {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Source of the GNSS data. Required for write. */
    mip_filter_gnss_aiding_source source;
};

#define MIP_FILTER_GNSS_SOURCE_DESCRIPTOR 0x15
#define MIP_FILTER_GNSS_SOURCE_NAME "filter.gnss_source"

extern const struct mip_codec mip_filter_gnss_source_codec;
mip_error mip_filter_gnss_source_decode(struct mip_filter_gnss_source *value,
                                        const struct mip_field *field);
mip_error mip_filter_gnss_source_encode(const struct mip_filter_gnss_source *value,
                                        struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_gnss_source mip_filter_gnss_source_write(mip_filter_gnss_aiding_source source);
/** Send the current setting back in a response. */
struct mip_filter_gnss_source mip_filter_gnss_source_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_gnss_source mip_filter_gnss_source_save(void);
/** Load the saved setting. */
struct mip_filter_gnss_source mip_filter_gnss_source_load(void);
/** Load the factory default setting. */
struct mip_filter_gnss_source mip_filter_gnss_source_default(void);

/**
 * GNSS aiding source response: response (0x0D,0x86).
 *
 * Answers mip_filter_gnss_source. Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
 */
struct mip_filter_gnss_source_response {
    /** Source of the GNSS data. */
    mip_filter_gnss_aiding_source source;
};

#define MIP_FILTER_GNSS_SOURCE_RESPONSE_DESCRIPTOR 0x86
#define MIP_FILTER_GNSS_SOURCE_RESPONSE_NAME "filter.gnss_source_response"

extern const struct mip_codec mip_filter_gnss_source_response_codec;
mip_error mip_filter_gnss_source_response_decode(struct mip_filter_gnss_source_response *value,
                                                 const struct mip_field *field);
mip_error mip_filter_gnss_source_response_encode(
    const struct mip_filter_gnss_source_response *value, struct mip_builder *builder);

/**
 * External GNSS update: command (0x0D,0x16).
 *
 * Gives the filter one position and velocity of a GNSS receiver that the user provides.
 *
 * Supported by 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * Refused unless mip_filter_gnss_source selects the external source.
 *
 * The highest rate depends on the device.
 *
 * - mip-sdk-4: External Gnss Update (0x0D,0x16)
 */
struct mip_filter_external_gnss_update {
    /** GPS time of week. Unit: s. */
    double tow;
    /** GPS week, counted without rollover. Unit: week. */
    uint16_t week_number;
    /** Latitude. Unit: deg. Frame: llh. */
    double latitude;
    /** Longitude. Unit: deg. Frame: llh. */
    double longitude;
    /** Height above the ellipsoid. Unit: m. Frame: llh. */
    double height;
    /** Velocity. Elements: x, y, z. Unit: m/s. Frame: ned. */
    float velocity[3];
    /** Standard deviation of the position. Elements: x, y, z. Unit: m. Frame: ned. */
    float position_uncertainty[3];
    /** Standard deviation of the velocity. Elements: x, y, z. Unit: m/s. Frame: ned. */
    float velocity_uncertainty[3];
};

#define MIP_FILTER_EXTERNAL_GNSS_UPDATE_DESCRIPTOR 0x16
#define MIP_FILTER_EXTERNAL_GNSS_UPDATE_NAME "filter.external_gnss_update"

extern const struct mip_codec mip_filter_external_gnss_update_codec;
mip_error mip_filter_external_gnss_update_decode(struct mip_filter_external_gnss_update *value,
                                                 const struct mip_field *field);
mip_error mip_filter_external_gnss_update_encode(
    const struct mip_filter_external_gnss_update *value, struct mip_builder *builder);
/** External GNSS update. */
struct mip_filter_external_gnss_update mip_filter_external_gnss_update_make(
    double tow, uint16_t week_number, double latitude, double longitude, double height,
    const float velocity[3], const float position_uncertainty[3],
    const float velocity_uncertainty[3]);

/**
 * External heading update: command (0x0D,0x17).
 *
 * Gives the filter one measurement of the heading of the sensor frame in the NED frame.
 *
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * Refused unless external heading updates are enabled, by mip_filter_heading_source on the 3DM-GX5
 * and by mip_filter_aiding_measurement_enable on the 3DM-CV7.
 *
 * The 3DM-GX5-15 takes at most 20 updates per second.
 *
 * If the declination source is not valid, -25 models refuse true headings and -45 models magnetic
 * ones.
 *
 * - 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17)
 * - 3dm-gx5-15: 4.3.7 External Heading Update (0x0D, 0x17)
 */
struct mip_filter_external_heading_update {
    /**
     * Heading relative to the north that `type` names. Unit: rad. Frame: ned. Range:
     * -3.141592653589793 to 3.141592653589793.
     */
    float heading;
    /**
     * Standard deviation; the device refuses a value out of bounds. Unit: rad. Range: greater than
     * 0.
     */
    float heading_uncertainty;
    /** North that the heading refers to. */
    mip_filter_heading_type type;
};

#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_DESCRIPTOR 0x17
#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_NAME "filter.external_heading_update"

extern const struct mip_codec mip_filter_external_heading_update_codec;
mip_error mip_filter_external_heading_update_decode(
    struct mip_filter_external_heading_update *value, const struct mip_field *field);
mip_error mip_filter_external_heading_update_encode(
    const struct mip_filter_external_heading_update *value, struct mip_builder *builder);
/** External heading update. */
struct mip_filter_external_heading_update mip_filter_external_heading_update_make(
    float heading, float heading_uncertainty, mip_filter_heading_type type);

/**
 * Heading update control: command (0x0D,0x18).
 *
 * Source of the heading that aids the filter.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_heading_source_response.
 * Supported by 3DM-GX5-15 and 3DM-GX5-45. May be supported by 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-15,
 * 3DM-CV5-25, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-25, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 */
struct mip_filter_heading_source {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Source of the heading. Required for write. On the 3DM-CL5-15, 3DM-CV5-15 and 3DM-GX5-15: only
     * MIP_FILTER_HEADING_UPDATE_SOURCE_NONE and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL. On the
     * 3DM-CL5-25, 3DM-CV5-25, 3DM-GX4-25 and 3DM-GX5-25: only
     * MIP_FILTER_HEADING_UPDATE_SOURCE_NONE, MIP_FILTER_HEADING_UPDATE_SOURCE_MAG and
     * MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL. On the 3DM-GQ4-45, 3DM-GX3-45 and 3DM-GX4-45: only
     * MIP_FILTER_HEADING_UPDATE_SOURCE_NONE, MIP_FILTER_HEADING_UPDATE_SOURCE_MAG,
     * MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL.
     * On the 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only MIP_FILTER_HEADING_UPDATE_SOURCE_NONE,
     * MIP_FILTER_HEADING_UPDATE_SOURCE_GNSS_VELOCITY and MIP_FILTER_HEADING_UPDATE_SOURCE_EXTERNAL.
     */
    mip_filter_heading_update_source source;
};

#define MIP_FILTER_HEADING_SOURCE_DESCRIPTOR 0x18
#define MIP_FILTER_HEADING_SOURCE_NAME "filter.heading_source"

extern const struct mip_codec mip_filter_heading_source_codec;
mip_error mip_filter_heading_source_decode(struct mip_filter_heading_source *value,
                                           const struct mip_field *field);
mip_error mip_filter_heading_source_encode(const struct mip_filter_heading_source *value,
                                           struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_heading_source
mip_filter_heading_source_write(mip_filter_heading_update_source source);
/** Send the current setting back in a response. */
struct mip_filter_heading_source mip_filter_heading_source_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_heading_source mip_filter_heading_source_save(void);
/** Load the saved setting. */
struct mip_filter_heading_source mip_filter_heading_source_load(void);
/** Load the factory default setting. */
struct mip_filter_heading_source mip_filter_heading_source_default(void);

/**
 * Heading update control response: response (0x0D,0x87).
 *
 * Answers mip_filter_heading_source. Supported by 3DM-GX5-15 and 3DM-GX5-45. May be supported by
 * 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-15, 3DM-CV5-25, 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-25, 3DM-GX4-45,
 * 3DM-GX5-25, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
 */
struct mip_filter_heading_source_response {
    /** Source of the heading. */
    mip_filter_heading_update_source source;
};

#define MIP_FILTER_HEADING_SOURCE_RESPONSE_DESCRIPTOR 0x87
#define MIP_FILTER_HEADING_SOURCE_RESPONSE_NAME "filter.heading_source_response"

extern const struct mip_codec mip_filter_heading_source_response_codec;
mip_error mip_filter_heading_source_response_decode(
    struct mip_filter_heading_source_response *value, const struct mip_field *field);
mip_error mip_filter_heading_source_response_encode(
    const struct mip_filter_heading_source_response *value, struct mip_builder *builder);

/**
 * Automatic initialization: command (0x0D,0x19).
 *
 * Whether the filter initializes by itself when the device starts.
 *
 * Also called `auto_init_control`. Functions: write, read, save, load and default. Answered by
 * mip_filter_auto_initialization_control_response. Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * It needs a valid heading source.
 *
 * - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
 */
struct mip_filter_auto_initialization_control {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
};

#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_DESCRIPTOR 0x19
#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_NAME "filter.auto_initialization_control"

extern const struct mip_codec mip_filter_auto_initialization_control_codec;
mip_error mip_filter_auto_initialization_control_decode(
    struct mip_filter_auto_initialization_control *value, const struct mip_field *field);
mip_error mip_filter_auto_initialization_control_encode(
    const struct mip_filter_auto_initialization_control *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_auto_initialization_control
mip_filter_auto_initialization_control_write(uint8_t enable);
/** Send the current setting back in a response. */
struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_save(void);
/** Load the saved setting. */
struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_load(void);
/** Load the factory default setting. */
struct mip_filter_auto_initialization_control mip_filter_auto_initialization_control_default(void);

/**
 * Automatic initialization response: response (0x0D,0x88).
 *
 * Also called `auto_init_control_response`. Answers mip_filter_auto_initialization_control.
 * Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
 */
struct mip_filter_auto_initialization_control_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE_DESCRIPTOR 0x88
#define MIP_FILTER_AUTO_INITIALIZATION_CONTROL_RESPONSE_NAME \
    "filter.auto_initialization_control_response"

extern const struct mip_codec mip_filter_auto_initialization_control_response_codec;
mip_error mip_filter_auto_initialization_control_response_decode(
    struct mip_filter_auto_initialization_control_response *value, const struct mip_field *field);
mip_error mip_filter_auto_initialization_control_response_encode(
    const struct mip_filter_auto_initialization_control_response *value,
    struct mip_builder *builder);

/**
 * Accelerometer noise: command (0x0D,0x1A).
 *
 * Standard deviation of the accelerometer noise that the filter assumes (process noise).
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_accel_noise_response.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
 * - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
 */
struct mip_filter_accel_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_ACCEL_NOISE_DESCRIPTOR 0x1A
#define MIP_FILTER_ACCEL_NOISE_NAME "filter.accel_noise"

extern const struct mip_codec mip_filter_accel_noise_codec;
mip_error mip_filter_accel_noise_decode(struct mip_filter_accel_noise *value,
                                        const struct mip_field *field);
mip_error mip_filter_accel_noise_encode(const struct mip_filter_accel_noise *value,
                                        struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_accel_noise mip_filter_accel_noise_write(const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_accel_noise mip_filter_accel_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_accel_noise mip_filter_accel_noise_save(void);
/** Load the saved setting. */
struct mip_filter_accel_noise mip_filter_accel_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_accel_noise mip_filter_accel_noise_default(void);

/**
 * Accelerometer noise response: response (0x0D,0x89).
 *
 * Answers mip_filter_accel_noise. Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
 * - 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
 */
struct mip_filter_accel_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: m/s^2. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_ACCEL_NOISE_RESPONSE_DESCRIPTOR 0x89
#define MIP_FILTER_ACCEL_NOISE_RESPONSE_NAME "filter.accel_noise_response"

extern const struct mip_codec mip_filter_accel_noise_response_codec;
mip_error mip_filter_accel_noise_response_decode(struct mip_filter_accel_noise_response *value,
                                                 const struct mip_field *field);
mip_error mip_filter_accel_noise_response_encode(
    const struct mip_filter_accel_noise_response *value, struct mip_builder *builder);

/**
 * Gyroscope noise: command (0x0D,0x1B).
 *
 * Standard deviation of the gyroscope noise that the filter assumes (process noise).
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_gyro_noise_response.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
 * - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
 */
struct mip_filter_gyro_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_GYRO_NOISE_DESCRIPTOR 0x1B
#define MIP_FILTER_GYRO_NOISE_NAME "filter.gyro_noise"

extern const struct mip_codec mip_filter_gyro_noise_codec;
mip_error mip_filter_gyro_noise_decode(struct mip_filter_gyro_noise *value,
                                       const struct mip_field *field);
mip_error mip_filter_gyro_noise_encode(const struct mip_filter_gyro_noise *value,
                                       struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_gyro_noise mip_filter_gyro_noise_write(const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_gyro_noise mip_filter_gyro_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_gyro_noise mip_filter_gyro_noise_save(void);
/** Load the saved setting. */
struct mip_filter_gyro_noise mip_filter_gyro_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_gyro_noise mip_filter_gyro_noise_default(void);

/**
 * Gyroscope noise response: response (0x0D,0x8A).
 *
 * Answers mip_filter_gyro_noise. Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
 * - 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
 */
struct mip_filter_gyro_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: rad/s. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_GYRO_NOISE_RESPONSE_DESCRIPTOR 0x8A
#define MIP_FILTER_GYRO_NOISE_RESPONSE_NAME "filter.gyro_noise_response"

extern const struct mip_codec mip_filter_gyro_noise_response_codec;
mip_error mip_filter_gyro_noise_response_decode(struct mip_filter_gyro_noise_response *value,
                                                const struct mip_field *field);
mip_error mip_filter_gyro_noise_response_encode(const struct mip_filter_gyro_noise_response *value,
                                                struct mip_builder *builder);

/**
 * Accelerometer bias model: command (0x0D,0x1C).
 *
 * Parameters of the model by which the accelerometer bias drifts.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_accel_bias_model_response.
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
 */
struct mip_filter_accel_bias_model {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
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

#define MIP_FILTER_ACCEL_BIAS_MODEL_DESCRIPTOR 0x1C
#define MIP_FILTER_ACCEL_BIAS_MODEL_NAME "filter.accel_bias_model"

extern const struct mip_codec mip_filter_accel_bias_model_codec;
mip_error mip_filter_accel_bias_model_decode(struct mip_filter_accel_bias_model *value,
                                             const struct mip_field *field);
mip_error mip_filter_accel_bias_model_encode(const struct mip_filter_accel_bias_model *value,
                                             struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_accel_bias_model mip_filter_accel_bias_model_write(const float beta[3],
                                                                     const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_accel_bias_model mip_filter_accel_bias_model_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_accel_bias_model mip_filter_accel_bias_model_save(void);
/** Load the saved setting. */
struct mip_filter_accel_bias_model mip_filter_accel_bias_model_load(void);
/** Load the factory default setting. */
struct mip_filter_accel_bias_model mip_filter_accel_bias_model_default(void);

/**
 * Accelerometer bias model response: response (0x0D,0x8B).
 *
 * Answers mip_filter_accel_bias_model. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-45.
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

#define MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE_DESCRIPTOR 0x8B
#define MIP_FILTER_ACCEL_BIAS_MODEL_RESPONSE_NAME "filter.accel_bias_model_response"

extern const struct mip_codec mip_filter_accel_bias_model_response_codec;
mip_error mip_filter_accel_bias_model_response_decode(
    struct mip_filter_accel_bias_model_response *value, const struct mip_field *field);
mip_error mip_filter_accel_bias_model_response_encode(
    const struct mip_filter_accel_bias_model_response *value, struct mip_builder *builder);

/**
 * Gyroscope bias model: command (0x0D,0x1D).
 *
 * Parameters of the model by which the gyroscope bias drifts.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_gyro_bias_model_response.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
 * - 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
 */
struct mip_filter_gyro_bias_model {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
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

#define MIP_FILTER_GYRO_BIAS_MODEL_DESCRIPTOR 0x1D
#define MIP_FILTER_GYRO_BIAS_MODEL_NAME "filter.gyro_bias_model"

extern const struct mip_codec mip_filter_gyro_bias_model_codec;
mip_error mip_filter_gyro_bias_model_decode(struct mip_filter_gyro_bias_model *value,
                                            const struct mip_field *field);
mip_error mip_filter_gyro_bias_model_encode(const struct mip_filter_gyro_bias_model *value,
                                            struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_write(const float beta[3],
                                                                   const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_save(void);
/** Load the saved setting. */
struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_load(void);
/** Load the factory default setting. */
struct mip_filter_gyro_bias_model mip_filter_gyro_bias_model_default(void);

/**
 * Gyroscope bias model response: response (0x0D,0x8C).
 *
 * Answers mip_filter_gyro_bias_model. Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
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

#define MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE_DESCRIPTOR 0x8C
#define MIP_FILTER_GYRO_BIAS_MODEL_RESPONSE_NAME "filter.gyro_bias_model_response"

extern const struct mip_codec mip_filter_gyro_bias_model_response_codec;
mip_error mip_filter_gyro_bias_model_response_decode(
    struct mip_filter_gyro_bias_model_response *value, const struct mip_field *field);
mip_error mip_filter_gyro_bias_model_response_encode(
    const struct mip_filter_gyro_bias_model_response *value, struct mip_builder *builder);

/**
 * Automatic zero velocity update: command (0x0D,0x1E).
 *
 * Lets the filter take the device as standing still while its GNSS speed is small.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_auto_zupt_response.
 * Supported by 3DM-GQ7-GNSS/INS and 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * The update applies while the magnitude of the GNSS velocity vector is at or below the threshold.
 *
 * - mip-sdk-4: Auto Zupt (0x0D,0x1E)
 */
struct mip_filter_auto_zupt {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /** Largest speed that is taken as zero. Unit: m/s. Range: at least 0. Required for write. */
    float threshold;
};

#define MIP_FILTER_AUTO_ZUPT_DESCRIPTOR 0x1E
#define MIP_FILTER_AUTO_ZUPT_NAME "filter.auto_zupt"

extern const struct mip_codec mip_filter_auto_zupt_codec;
mip_error mip_filter_auto_zupt_decode(struct mip_filter_auto_zupt *value,
                                      const struct mip_field *field);
mip_error mip_filter_auto_zupt_encode(const struct mip_filter_auto_zupt *value,
                                      struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_auto_zupt mip_filter_auto_zupt_write(uint8_t enable, float threshold);
/** Send the current setting back in a response. */
struct mip_filter_auto_zupt mip_filter_auto_zupt_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_auto_zupt mip_filter_auto_zupt_save(void);
/** Load the saved setting. */
struct mip_filter_auto_zupt mip_filter_auto_zupt_load(void);
/** Load the factory default setting. */
struct mip_filter_auto_zupt mip_filter_auto_zupt_default(void);

/**
 * Automatic zero velocity update response: response (0x0D,0x8D).
 *
 * Answers mip_filter_auto_zupt. Supported by 3DM-GQ7-GNSS/INS and 3DM-GX5-45. Known from the
 * MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Auto Zupt (0x0D,0x1E)
 */
struct mip_filter_auto_zupt_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Largest speed that is taken as zero. Unit: m/s. Range: at least 0. */
    float threshold;
};

#define MIP_FILTER_AUTO_ZUPT_RESPONSE_DESCRIPTOR 0x8D
#define MIP_FILTER_AUTO_ZUPT_RESPONSE_NAME "filter.auto_zupt_response"

extern const struct mip_codec mip_filter_auto_zupt_response_codec;
mip_error mip_filter_auto_zupt_response_decode(struct mip_filter_auto_zupt_response *value,
                                               const struct mip_field *field);
mip_error mip_filter_auto_zupt_response_encode(const struct mip_filter_auto_zupt_response *value,
                                               struct mip_builder *builder);

/**
 * External heading update with time: command (0x0D,0x1F).
 *
 * Gives the filter one measurement of the heading of the sensor frame with its GPS time.
 *
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * Better than mip_filter_external_heading_update where the heading changes quickly; the time must
 * be accurate.
 *
 * Refused unless external heading updates are enabled, by mip_filter_heading_source on the 3DM-GX5
 * and by mip_filter_aiding_measurement_enable on the 3DM-CV7.
 *
 * The 3DM-GX5-15 takes at most 20 updates per second.
 *
 * If the declination source is not valid, -25 models refuse true headings and -45 models magnetic
 * ones.
 *
 * - 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F)
 * - 3dm-gx5-15: 4.3.8 External Heading Update with Timestamp (0x0D, 0x1F)
 */
struct mip_filter_external_heading_update_with_time {
    /** GPS time of week of the measurement. Unit: s. */
    double tow;
    /** GPS week, counted without rollover. Unit: week. */
    uint16_t week_number;
    /**
     * Heading relative to the north that `type` names. Unit: rad. Frame: ned. Range:
     * -3.141592653589793 to 3.141592653589793.
     */
    float heading;
    /**
     * Standard deviation; the device refuses a value out of bounds. Unit: rad. Range: greater than
     * 0.
     */
    float heading_uncertainty;
    /** North that the heading refers to. */
    mip_filter_heading_type type;
};

#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME_DESCRIPTOR 0x1F
#define MIP_FILTER_EXTERNAL_HEADING_UPDATE_WITH_TIME_NAME "filter.external_heading_update_with_time"

extern const struct mip_codec mip_filter_external_heading_update_with_time_codec;
mip_error mip_filter_external_heading_update_with_time_decode(
    struct mip_filter_external_heading_update_with_time *value, const struct mip_field *field);
mip_error mip_filter_external_heading_update_with_time_encode(
    const struct mip_filter_external_heading_update_with_time *value, struct mip_builder *builder);
/** External heading update with time. */
struct mip_filter_external_heading_update_with_time
mip_filter_external_heading_update_with_time_make(double tow, uint16_t week_number, float heading,
                                                  float heading_uncertainty,
                                                  mip_filter_heading_type type);

/**
 * Zero angular rate update: command (0x0D,0x20).
 *
 * Lets the filter take the device as not rotating while its angular rate is small.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_auto_angular_zupt_response. Supported by 3DM-CV7-GNSS/INS, 3DM-CV7-INS,
 * 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * The update applies while the magnitude of the angular rate vector is at or below the threshold.
 *
 * - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
 * - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
 */
struct mip_filter_auto_angular_zupt {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Largest angular rate that is taken as zero. Unit: rad/s. Range: at least 0. Required for
     * write.
     */
    float threshold;
};

#define MIP_FILTER_AUTO_ANGULAR_ZUPT_DESCRIPTOR 0x20
#define MIP_FILTER_AUTO_ANGULAR_ZUPT_NAME "filter.auto_angular_zupt"

extern const struct mip_codec mip_filter_auto_angular_zupt_codec;
mip_error mip_filter_auto_angular_zupt_decode(struct mip_filter_auto_angular_zupt *value,
                                              const struct mip_field *field);
mip_error mip_filter_auto_angular_zupt_encode(const struct mip_filter_auto_angular_zupt *value,
                                              struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_write(uint8_t enable,
                                                                       float threshold);
/** Send the current setting back in a response. */
struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_save(void);
/** Load the saved setting. */
struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_load(void);
/** Load the factory default setting. */
struct mip_filter_auto_angular_zupt mip_filter_auto_angular_zupt_default(void);

/**
 * Zero angular rate update response: response (0x0D,0x8E).
 *
 * Answers mip_filter_auto_angular_zupt. Supported by 3DM-CV7-GNSS/INS, 3DM-CV7-INS,
 * 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
 * - 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
 */
struct mip_filter_auto_angular_zupt_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Largest angular rate that is taken as zero. Unit: rad/s. Range: at least 0. */
    float threshold;
};

#define MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE_DESCRIPTOR 0x8E
#define MIP_FILTER_AUTO_ANGULAR_ZUPT_RESPONSE_NAME "filter.auto_angular_zupt_response"

extern const struct mip_codec mip_filter_auto_angular_zupt_response_codec;
mip_error mip_filter_auto_angular_zupt_response_decode(
    struct mip_filter_auto_angular_zupt_response *value, const struct mip_field *field);
mip_error mip_filter_auto_angular_zupt_response_encode(
    const struct mip_filter_auto_angular_zupt_response *value, struct mip_builder *builder);

/**
 * Tare orientation: command (0x0D,0x21).
 *
 * Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_tare_orientation_response.
 * Supported by 3DM-GX5-15 and 3DM-GX5-45. On the 3DM-GX5-15: write, save, load and default only. On
 * the 3DM-GX5-45: write, save, load and default only.
 *
 * Refused while the filter has no valid attitude.
 *
 * - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
 * - mip-sdk-4: Tare Orientation (0x0D,0x21)
 */
struct mip_filter_tare_orientation {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Axes to tare; 0 resets all axes. Required for write. */
    mip_filter_tare_axes axes;
};

#define MIP_FILTER_TARE_ORIENTATION_DESCRIPTOR 0x21
#define MIP_FILTER_TARE_ORIENTATION_NAME "filter.tare_orientation"

extern const struct mip_codec mip_filter_tare_orientation_codec;
mip_error mip_filter_tare_orientation_decode(struct mip_filter_tare_orientation *value,
                                             const struct mip_field *field);
mip_error mip_filter_tare_orientation_encode(const struct mip_filter_tare_orientation *value,
                                             struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_tare_orientation mip_filter_tare_orientation_write(mip_filter_tare_axes axes);
/** Send the current setting back in a response. */
struct mip_filter_tare_orientation mip_filter_tare_orientation_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_tare_orientation mip_filter_tare_orientation_save(void);
/** Load the saved setting. */
struct mip_filter_tare_orientation mip_filter_tare_orientation_load(void);
/** Load the factory default setting. */
struct mip_filter_tare_orientation mip_filter_tare_orientation_default(void);

/**
 * Tare orientation response: response (0x0D,0xA1).
 *
 * Answers mip_filter_tare_orientation. Uncertain: Which devices send it. The SDK reads the setting
 * back; the manuals of the 3DM-GX5-15 and 3DM-GX5-45 have neither the read function nor the
 * response.
 *
 * - 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
 * - mip-sdk-4: Tare Orientation (0x0D,0x21)
 */
struct mip_filter_tare_orientation_response {
    /** Axes to tare; 0 resets all axes. */
    mip_filter_tare_axes axes;
};

#define MIP_FILTER_TARE_ORIENTATION_RESPONSE_DESCRIPTOR 0xA1
#define MIP_FILTER_TARE_ORIENTATION_RESPONSE_NAME "filter.tare_orientation_response"

extern const struct mip_codec mip_filter_tare_orientation_response_codec;
mip_error mip_filter_tare_orientation_response_decode(
    struct mip_filter_tare_orientation_response *value, const struct mip_field *field);
mip_error mip_filter_tare_orientation_response_encode(
    const struct mip_filter_tare_orientation_response *value, struct mip_builder *builder);

/**
 * Commanded zero velocity update: command (0x0D,0x22).
 *
 * Tells the filter once that the device stands still.
 *
 * Supported by 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * The highest rate depends on the device.
 *
 * - mip-sdk-4: Commanded Zupt (0x0D,0x22)
 */
struct mip_filter_commanded_zupt {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_COMMANDED_ZUPT_DESCRIPTOR 0x22
#define MIP_FILTER_COMMANDED_ZUPT_NAME "filter.commanded_zupt"

extern const struct mip_codec mip_filter_commanded_zupt_codec;
mip_error mip_filter_commanded_zupt_decode(struct mip_filter_commanded_zupt *value,
                                           const struct mip_field *field);
mip_error mip_filter_commanded_zupt_encode(const struct mip_filter_commanded_zupt *value,
                                           struct mip_builder *builder);

/**
 * Commanded zero angular rate update: command (0x0D,0x23).
 *
 * Tells the filter once that the device is not rotating.
 *
 * Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * At most 10 per second.
 *
 * - 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23)
 */
struct mip_filter_commanded_angular_zupt {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_FILTER_COMMANDED_ANGULAR_ZUPT_DESCRIPTOR 0x23
#define MIP_FILTER_COMMANDED_ANGULAR_ZUPT_NAME "filter.commanded_angular_zupt"

extern const struct mip_codec mip_filter_commanded_angular_zupt_codec;
mip_error mip_filter_commanded_angular_zupt_decode(struct mip_filter_commanded_angular_zupt *value,
                                                   const struct mip_field *field);
mip_error mip_filter_commanded_angular_zupt_encode(
    const struct mip_filter_commanded_angular_zupt *value, struct mip_builder *builder);

/**
 * Set reference position: command (0x0D,0x26).
 *
 * Position for which the device computes gravity (WGS84) and the magnetic field (WMM2015).
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_reference_position_response. Supported by 3DM-GX5-15.
 *
 * - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
 */
struct mip_filter_reference_position {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /** Latitude. Unit: deg. Frame: llh. Required for write. */
    double latitude;
    /** Longitude. Unit: deg. Frame: llh. Required for write. */
    double longitude;
    /** Altitude. Unit: m. Frame: llh. Required for write. */
    double altitude;
};

#define MIP_FILTER_REFERENCE_POSITION_DESCRIPTOR 0x26
#define MIP_FILTER_REFERENCE_POSITION_NAME "filter.reference_position"

extern const struct mip_codec mip_filter_reference_position_codec;
mip_error mip_filter_reference_position_decode(struct mip_filter_reference_position *value,
                                               const struct mip_field *field);
mip_error mip_filter_reference_position_encode(const struct mip_filter_reference_position *value,
                                               struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_reference_position mip_filter_reference_position_write(uint8_t enable,
                                                                         double latitude,
                                                                         double longitude,
                                                                         double altitude);
/** Send the current setting back in a response. */
struct mip_filter_reference_position mip_filter_reference_position_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_reference_position mip_filter_reference_position_save(void);
/** Load the saved setting. */
struct mip_filter_reference_position mip_filter_reference_position_load(void);
/** Load the factory default setting. */
struct mip_filter_reference_position mip_filter_reference_position_default(void);

/**
 * Set reference position response: response (0x0D,0x90).
 *
 * Answers mip_filter_reference_position. Supported by 3DM-GX5-15.
 *
 * - 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
 */
struct mip_filter_reference_position_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /** Latitude. Unit: deg. Frame: llh. */
    double latitude;
    /** Longitude. Unit: deg. Frame: llh. */
    double longitude;
    /** Altitude. Unit: m. Frame: llh. */
    double altitude;
};

#define MIP_FILTER_REFERENCE_POSITION_RESPONSE_DESCRIPTOR 0x90
#define MIP_FILTER_REFERENCE_POSITION_RESPONSE_NAME "filter.reference_position_response"

extern const struct mip_codec mip_filter_reference_position_response_codec;
mip_error mip_filter_reference_position_response_decode(
    struct mip_filter_reference_position_response *value, const struct mip_field *field);
mip_error mip_filter_reference_position_response_encode(
    const struct mip_filter_reference_position_response *value, struct mip_builder *builder);

/**
 * Capture automatic magnetometer calibration: command (0x0D,0x27).
 *
 * Makes the automatic magnetometer calibration part of the fixed one.
 *
 * Also called `mag_capture_auto_cal`. Functions: write and save. Supported by 3DM-GX5-45. Known
 * from the MicroStrain MIP SDK only.
 *
 * A write combines the automatic calibration with mip_3dm_mag_hard_iron_offset and
 * mip_3dm_mag_soft_iron_matrix, and resets it.
 *
 * A save does the same as the save of both of these commands.
 *
 * - mip-sdk-4: Mag Capture Auto Cal (0x0D,0x27)
 */
struct mip_filter_mag_capture_auto_calibration {
    /** What to do with the setting. */
    mip_function_selector function;
};

#define MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION_DESCRIPTOR 0x27
#define MIP_FILTER_MAG_CAPTURE_AUTO_CALIBRATION_NAME "filter.mag_capture_auto_calibration"

extern const struct mip_codec mip_filter_mag_capture_auto_calibration_codec;
mip_error mip_filter_mag_capture_auto_calibration_decode(
    struct mip_filter_mag_capture_auto_calibration *value, const struct mip_field *field);
mip_error mip_filter_mag_capture_auto_calibration_encode(
    const struct mip_filter_mag_capture_auto_calibration *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_mag_capture_auto_calibration mip_filter_mag_capture_auto_calibration_write(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_mag_capture_auto_calibration mip_filter_mag_capture_auto_calibration_save(void);

/**
 * Gravity noise: command (0x0D,0x28).
 *
 * Standard deviation of the gravity noise that the filter assumes (process noise).
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_gravity_noise_response.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * The factory values suit most laboratory conditions.
 *
 * - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
 * - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
 */
struct mip_filter_gravity_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. Required for
     * write.
     */
    float noise[3];
};

#define MIP_FILTER_GRAVITY_NOISE_DESCRIPTOR 0x28
#define MIP_FILTER_GRAVITY_NOISE_NAME "filter.gravity_noise"

extern const struct mip_codec mip_filter_gravity_noise_codec;
mip_error mip_filter_gravity_noise_decode(struct mip_filter_gravity_noise *value,
                                          const struct mip_field *field);
mip_error mip_filter_gravity_noise_encode(const struct mip_filter_gravity_noise *value,
                                          struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_gravity_noise mip_filter_gravity_noise_write(const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_gravity_noise mip_filter_gravity_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_gravity_noise mip_filter_gravity_noise_save(void);
/** Load the saved setting. */
struct mip_filter_gravity_noise mip_filter_gravity_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_gravity_noise mip_filter_gravity_noise_default(void);

/**
 * Gravity noise response: response (0x0D,0x93).
 *
 * Answers mip_filter_gravity_noise. Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
 * - 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
 */
struct mip_filter_gravity_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: g. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_GRAVITY_NOISE_RESPONSE_DESCRIPTOR 0x93
#define MIP_FILTER_GRAVITY_NOISE_RESPONSE_NAME "filter.gravity_noise_response"

extern const struct mip_codec mip_filter_gravity_noise_response_codec;
mip_error mip_filter_gravity_noise_response_decode(struct mip_filter_gravity_noise_response *value,
                                                   const struct mip_field *field);
mip_error mip_filter_gravity_noise_response_encode(
    const struct mip_filter_gravity_noise_response *value, struct mip_builder *builder);

/**
 * Pressure altitude noise: command (0x0D,0x29).
 *
 * Standard deviation of the noise of the pressure altitude model that the filter assumes.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_pressure_altitude_noise_response. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * A small value follows the pressure faster, and takes weather and draughts for changes of height.
 *
 * - mip-sdk-4: Pressure Altitude Noise (0x0D,0x29)
 */
struct mip_filter_pressure_altitude_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Standard deviation. Unit: m. Range: greater than 0. Required for write. */
    float noise;
};

#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_DESCRIPTOR 0x29
#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_NAME "filter.pressure_altitude_noise"

extern const struct mip_codec mip_filter_pressure_altitude_noise_codec;
mip_error mip_filter_pressure_altitude_noise_decode(
    struct mip_filter_pressure_altitude_noise *value, const struct mip_field *field);
mip_error mip_filter_pressure_altitude_noise_encode(
    const struct mip_filter_pressure_altitude_noise *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_write(float noise);
/** Send the current setting back in a response. */
struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_save(void);
/** Load the saved setting. */
struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_pressure_altitude_noise mip_filter_pressure_altitude_noise_default(void);

/**
 * Pressure altitude noise response: response (0x0D,0x94).
 *
 * Answers mip_filter_pressure_altitude_noise. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Pressure Altitude Noise (0x0D,0x29)
 */
struct mip_filter_pressure_altitude_noise_response {
    /** Standard deviation. Unit: m. Range: greater than 0. */
    float noise;
};

#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE_DESCRIPTOR 0x94
#define MIP_FILTER_PRESSURE_ALTITUDE_NOISE_RESPONSE_NAME "filter.pressure_altitude_noise_response"

extern const struct mip_codec mip_filter_pressure_altitude_noise_response_codec;
mip_error mip_filter_pressure_altitude_noise_response_decode(
    struct mip_filter_pressure_altitude_noise_response *value, const struct mip_field *field);
mip_error mip_filter_pressure_altitude_noise_response_encode(
    const struct mip_filter_pressure_altitude_noise_response *value, struct mip_builder *builder);

/**
 * Hard iron offset noise: command (0x0D,0x2B).
 *
 * Standard deviation of the noise of the estimated hard iron offset (process noise).
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_hard_iron_offset_noise_response. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Hard Iron Offset Noise (0x0D,0x2B)
 */
struct mip_filter_hard_iron_offset_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_DESCRIPTOR 0x2B
#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_NAME "filter.hard_iron_offset_noise"

extern const struct mip_codec mip_filter_hard_iron_offset_noise_codec;
mip_error mip_filter_hard_iron_offset_noise_decode(struct mip_filter_hard_iron_offset_noise *value,
                                                   const struct mip_field *field);
mip_error mip_filter_hard_iron_offset_noise_encode(
    const struct mip_filter_hard_iron_offset_noise *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_hard_iron_offset_noise
mip_filter_hard_iron_offset_noise_write(const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_save(void);
/** Load the saved setting. */
struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_hard_iron_offset_noise mip_filter_hard_iron_offset_noise_default(void);

/**
 * Hard iron offset noise response: response (0x0D,0x96).
 *
 * Answers mip_filter_hard_iron_offset_noise. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Hard Iron Offset Noise (0x0D,0x2B)
 */
struct mip_filter_hard_iron_offset_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE_DESCRIPTOR 0x96
#define MIP_FILTER_HARD_IRON_OFFSET_NOISE_RESPONSE_NAME "filter.hard_iron_offset_noise_response"

extern const struct mip_codec mip_filter_hard_iron_offset_noise_response_codec;
mip_error mip_filter_hard_iron_offset_noise_response_decode(
    struct mip_filter_hard_iron_offset_noise_response *value, const struct mip_field *field);
mip_error mip_filter_hard_iron_offset_noise_response_encode(
    const struct mip_filter_hard_iron_offset_noise_response *value, struct mip_builder *builder);

/**
 * Soft iron matrix noise: command (0x0D,0x2C).
 *
 * Standard deviation of the noise of the estimated soft iron matrix (process noise).
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_soft_iron_matrix_noise_response. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Soft Iron Matrix Noise (0x0D,0x2C)
 */
struct mip_filter_soft_iron_matrix_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1. Range: greater than 0. Required for write.
     */
    float noise[9];
};

#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_DESCRIPTOR 0x2C
#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_NAME "filter.soft_iron_matrix_noise"

extern const struct mip_codec mip_filter_soft_iron_matrix_noise_codec;
mip_error mip_filter_soft_iron_matrix_noise_decode(struct mip_filter_soft_iron_matrix_noise *value,
                                                   const struct mip_field *field);
mip_error mip_filter_soft_iron_matrix_noise_encode(
    const struct mip_filter_soft_iron_matrix_noise *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_soft_iron_matrix_noise
mip_filter_soft_iron_matrix_noise_write(const float noise[9]);
/** Send the current setting back in a response. */
struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_save(void);
/** Load the saved setting. */
struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_soft_iron_matrix_noise mip_filter_soft_iron_matrix_noise_default(void);

/**
 * Soft iron matrix noise response: response (0x0D,0x97).
 *
 * Answers mip_filter_soft_iron_matrix_noise. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Soft Iron Matrix Noise (0x0D,0x2C)
 */
struct mip_filter_soft_iron_matrix_noise_response {
    /**
     * Standard deviation per element. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1. Range: greater than 0.
     */
    float noise[9];
};

#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE_DESCRIPTOR 0x97
#define MIP_FILTER_SOFT_IRON_MATRIX_NOISE_RESPONSE_NAME "filter.soft_iron_matrix_noise_response"

extern const struct mip_codec mip_filter_soft_iron_matrix_noise_response_codec;
mip_error mip_filter_soft_iron_matrix_noise_response_decode(
    struct mip_filter_soft_iron_matrix_noise_response *value, const struct mip_field *field);
mip_error mip_filter_soft_iron_matrix_noise_response_encode(
    const struct mip_filter_soft_iron_matrix_noise_response *value, struct mip_builder *builder);

/**
 * Enable or disable measurements: command (0x0D,0x41).
 *
 * Which inertial measurements the filter uses.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_enable_measurements_response. Supported by 3DM-GX5-15.
 *
 * - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
 */
struct mip_filter_enable_measurements {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Measurements to use. Required for write. */
    mip_filter_measurement_flags control;
};

#define MIP_FILTER_ENABLE_MEASUREMENTS_DESCRIPTOR 0x41
#define MIP_FILTER_ENABLE_MEASUREMENTS_NAME "filter.enable_measurements"

extern const struct mip_codec mip_filter_enable_measurements_codec;
mip_error mip_filter_enable_measurements_decode(struct mip_filter_enable_measurements *value,
                                                const struct mip_field *field);
mip_error mip_filter_enable_measurements_encode(const struct mip_filter_enable_measurements *value,
                                                struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_enable_measurements
mip_filter_enable_measurements_write(mip_filter_measurement_flags control);
/** Send the current setting back in a response. */
struct mip_filter_enable_measurements mip_filter_enable_measurements_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_enable_measurements mip_filter_enable_measurements_save(void);
/** Load the saved setting. */
struct mip_filter_enable_measurements mip_filter_enable_measurements_load(void);
/** Load the factory default setting. */
struct mip_filter_enable_measurements mip_filter_enable_measurements_default(void);

/**
 * Enable or disable measurements response: response (0x0D,0xB0).
 *
 * Answers mip_filter_enable_measurements. Supported by 3DM-GX5-15.
 *
 * - 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
 */
struct mip_filter_enable_measurements_response {
    /** Measurements to use. */
    mip_filter_measurement_flags control;
};

#define MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE_DESCRIPTOR 0xB0
#define MIP_FILTER_ENABLE_MEASUREMENTS_RESPONSE_NAME "filter.enable_measurements_response"

extern const struct mip_codec mip_filter_enable_measurements_response_codec;
mip_error mip_filter_enable_measurements_response_decode(
    struct mip_filter_enable_measurements_response *value, const struct mip_field *field);
mip_error mip_filter_enable_measurements_response_encode(
    const struct mip_filter_enable_measurements_response *value, struct mip_builder *builder);

/**
 * Magnetometer noise: command (0x0D,0x42).
 *
 * Standard deviation of the magnetometer noise that the filter assumes.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_mag_noise_response.
 * Supported by 3DM-GX5-45. Known from the MicroStrain MIP SDK only. Uncertain: The SDK calls it
 * process noise, although the noise is that of a measurement.
 *
 * - mip-sdk-4: Mag Noise (0x0D,0x42)
 */
struct mip_filter_mag_noise {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. Required
     * for write.
     */
    float noise[3];
};

#define MIP_FILTER_MAG_NOISE_DESCRIPTOR 0x42
#define MIP_FILTER_MAG_NOISE_NAME "filter.mag_noise"

extern const struct mip_codec mip_filter_mag_noise_codec;
mip_error mip_filter_mag_noise_decode(struct mip_filter_mag_noise *value,
                                      const struct mip_field *field);
mip_error mip_filter_mag_noise_encode(const struct mip_filter_mag_noise *value,
                                      struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_mag_noise mip_filter_mag_noise_write(const float noise[3]);
/** Send the current setting back in a response. */
struct mip_filter_mag_noise mip_filter_mag_noise_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_mag_noise mip_filter_mag_noise_save(void);
/** Load the saved setting. */
struct mip_filter_mag_noise mip_filter_mag_noise_load(void);
/** Load the factory default setting. */
struct mip_filter_mag_noise mip_filter_mag_noise_default(void);

/**
 * Magnetometer noise response: response (0x0D,0xB1).
 *
 * Answers mip_filter_mag_noise. Supported by 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Mag Noise (0x0D,0x42)
 */
struct mip_filter_mag_noise_response {
    /** Standard deviation per axis. Elements: x, y, z. Unit: gauss. Range: greater than 0. */
    float noise[3];
};

#define MIP_FILTER_MAG_NOISE_RESPONSE_DESCRIPTOR 0xB1
#define MIP_FILTER_MAG_NOISE_RESPONSE_NAME "filter.mag_noise_response"

extern const struct mip_codec mip_filter_mag_noise_response_codec;
mip_error mip_filter_mag_noise_response_decode(struct mip_filter_mag_noise_response *value,
                                               const struct mip_field *field);
mip_error mip_filter_mag_noise_response_encode(const struct mip_filter_mag_noise_response *value,
                                               struct mip_builder *builder);

/**
 * Magnetic declination source: command (0x0D,0x43).
 *
 * Source of the local declination of the magnetic field.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_magnetic_declination_source_response. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45.
 *
 * Without a good declination source, keep automatic magnetometer calibration off.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
 */
struct mip_filter_magnetic_declination_source {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Source of the declination. Required for write. On the 3DM-GQ7-GNSS/INS: only
     * MIP_FILTER_MAG_PARAMETER_SOURCE_WMM and MIP_FILTER_MAG_PARAMETER_SOURCE_MANUAL.
     */
    mip_filter_mag_parameter_source source;
    /** Declination; used only if `source` is manual. Unit: rad. Required for write. */
    float declination;
};

#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_DESCRIPTOR 0x43
#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_NAME "filter.magnetic_declination_source"

extern const struct mip_codec mip_filter_magnetic_declination_source_codec;
mip_error mip_filter_magnetic_declination_source_decode(
    struct mip_filter_magnetic_declination_source *value, const struct mip_field *field);
mip_error mip_filter_magnetic_declination_source_encode(
    const struct mip_filter_magnetic_declination_source *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_write(
    mip_filter_mag_parameter_source source, float declination);
/** Send the current setting back in a response. */
struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_save(void);
/** Load the saved setting. */
struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_load(void);
/** Load the factory default setting. */
struct mip_filter_magnetic_declination_source mip_filter_magnetic_declination_source_default(void);

/**
 * Magnetic declination source response: response (0x0D,0xB2).
 *
 * Answers mip_filter_magnetic_declination_source. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
 */
struct mip_filter_magnetic_declination_source_response {
    /** Source of the declination. */
    mip_filter_mag_parameter_source source;
    /** Declination; used only if `source` is manual. Unit: rad. */
    float declination;
};

#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE_DESCRIPTOR 0xB2
#define MIP_FILTER_MAGNETIC_DECLINATION_SOURCE_RESPONSE_NAME \
    "filter.magnetic_declination_source_response"

extern const struct mip_codec mip_filter_magnetic_declination_source_response_codec;
mip_error mip_filter_magnetic_declination_source_response_decode(
    struct mip_filter_magnetic_declination_source_response *value, const struct mip_field *field);
mip_error mip_filter_magnetic_declination_source_response_encode(
    const struct mip_filter_magnetic_declination_source_response *value,
    struct mip_builder *builder);

/**
 * Gravity magnitude error adaptive measurement: command (0x0D,0x44).
 *
 * How far the filter trusts gravity measurements whose magnitude is not that of gravity.
 *
 * In full: filter.accel_magnitude_error_adaptive_measurement.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_accel_magnitude_adaptive_response. Supported by 3DM-GX5-15 and 3DM-GX5-45. May be
 * supported by 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST.
 *
 * Also called accelerometer magnitude error adaptive measurement.
 *
 * All parameters after the selector keep their values if they are left out.
 *
 * Filter and limits take effect only with `fixed`.
 *
 * Raise the limits where vibration is strong, lower them where it is weak. High limits cost pitch
 * and roll accuracy under linear acceleration, low limits cost heading accuracy.
 *
 * - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
 */
struct mip_filter_accel_magnitude_adaptive {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Kind of adaptation. Required for write. On the 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15,
     * 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     * MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
     * MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
     */
    mip_filter_adaptive_measurement_selector adaptive_measurement;
    /** Cut-off frequency of the low-pass filter. Unit: Hz. Optional. */
    float frequency;
    /** Lower limit of the error. Unit: m/s^2. Optional. */
    float low_limit;
    /** Upper limit of the error. Unit: m/s^2. Optional. */
    float high_limit;
    /** Standard deviation at the lower limit. Unit: m/s^2. Optional. */
    float low_limit_uncertainty;
    /** Standard deviation at the upper limit. Unit: m/s^2. Optional. */
    float high_limit_uncertainty;
    /** Smallest standard deviation. Unit: m/s^2. Optional. */
    float minimum_uncertainty;
};

#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_DESCRIPTOR 0x44
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_NAME "filter.accel_magnitude_error_adaptive_measurement"
/** The value of `present` if frequency is the last parameter that is there. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_FREQUENCY 2
/** The value of `present` if low_limit is the last parameter that is there. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_LOW_LIMIT 3
/** The value of `present` if high_limit is the last parameter that is there. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT 4
/** The value of `present` if low_limit_uncertainty is the last parameter that is there. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_LOW_LIMIT_UNCERTAINTY 5
/** The value of `present` if high_limit_uncertainty is the last parameter that is there. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT_UNCERTAINTY 6
/** The value of `present` if minimum_uncertainty is the last parameter that is there. */
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_MINIMUM_UNCERTAINTY 7

extern const struct mip_codec mip_filter_accel_magnitude_adaptive_codec;
mip_error mip_filter_accel_magnitude_adaptive_decode(
    struct mip_filter_accel_magnitude_adaptive *value, const struct mip_field *field);
mip_error mip_filter_accel_magnitude_adaptive_encode(
    const struct mip_filter_accel_magnitude_adaptive *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_write(
    mip_filter_adaptive_measurement_selector adaptive_measurement);
/** Send the current setting back in a response. */
struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_save(void);
/** Load the saved setting. */
struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_load(void);
/** Load the factory default setting. */
struct mip_filter_accel_magnitude_adaptive mip_filter_accel_magnitude_adaptive_default(void);

/**
 * Gravity magnitude error adaptive measurement response: response (0x0D,0xB3).
 *
 * In full: filter.accel_magnitude_error_adaptive_measurement_response.
 *
 * Answers mip_filter_accel_magnitude_adaptive. Supported by 3DM-GX5-15 and 3DM-GX5-45. May be
 * supported by 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
 */
struct mip_filter_accel_magnitude_adaptive_response {
    /** Kind of adaptation. */
    mip_filter_adaptive_measurement_selector adaptive_measurement;
    /** Cut-off frequency of the low-pass filter. Unit: Hz. */
    float frequency;
    /** Lower limit of the error. Unit: m/s^2. */
    float low_limit;
    /** Upper limit of the error. Unit: m/s^2. */
    float high_limit;
    /** Standard deviation at the lower limit. Unit: m/s^2. */
    float low_limit_uncertainty;
    /** Standard deviation at the upper limit. Unit: m/s^2. */
    float high_limit_uncertainty;
    /** Smallest standard deviation. Unit: m/s^2. */
    float minimum_uncertainty;
};

#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR 0xB3
#define MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_RESPONSE_NAME \
    "filter.accel_magnitude_error_adaptive_measurement_response"

extern const struct mip_codec mip_filter_accel_magnitude_adaptive_response_codec;
mip_error mip_filter_accel_magnitude_adaptive_response_decode(
    struct mip_filter_accel_magnitude_adaptive_response *value, const struct mip_field *field);
mip_error mip_filter_accel_magnitude_adaptive_response_encode(
    const struct mip_filter_accel_magnitude_adaptive_response *value, struct mip_builder *builder);

/**
 * Magnetometer magnitude error adaptive measurement: command (0x0D,0x45).
 *
 * How far the filter trusts a magnetic field whose magnitude is not as expected.
 *
 * In full: filter.mag_magnitude_error_adaptive_measurement.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_mag_magnitude_adaptive_response. Supported by 3DM-GX5-45. May be supported by
 * 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 * Known from the MicroStrain MIP SDK only. Uncertain: Whether the parameters behind the selector
 * may be left out on write, as those of mip_filter_accel_magnitude_adaptive may.
 *
 * The limits and the low-pass filter take effect only with `fixed`; with `auto` the device finds
 * limits.
 *
 * High limits suit high dynamics but let disturbances of the field through; low limits can spoil
 * the heading.
 *
 * - mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
 */
struct mip_filter_mag_magnitude_adaptive {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Kind of adaptation. Required for write. On the 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15,
     * 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: only
     * MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_DISABLED and
     * MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED.
     */
    mip_filter_adaptive_measurement_selector adaptive_measurement;
    /** Cut-off frequency of the low-pass filter. Unit: Hz. Required for write. */
    float frequency;
    /**
     * Lower limit of the error. Unit: gauss. Required for write. Uncertain: The unit. The SDK
     * prints m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the
     * response.
     */
    float low_limit;
    /**
     * Upper limit of the error. Unit: gauss. Required for write. Uncertain: The unit. The SDK
     * prints m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the
     * response.
     */
    float high_limit;
    /**
     * Standard deviation at the lower limit. Unit: gauss. Required for write. Uncertain: The unit.
     * The SDK prints m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the
     * response.
     */
    float low_limit_uncertainty;
    /**
     * Standard deviation at the upper limit. Unit: gauss. Required for write. Uncertain: The unit.
     * The SDK prints m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the
     * response.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: gauss. Required for write. Uncertain: The unit. The SDK
     * prints m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the
     * response.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_DESCRIPTOR 0x45
#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_NAME "filter.mag_magnitude_error_adaptive_measurement"

extern const struct mip_codec mip_filter_mag_magnitude_adaptive_codec;
mip_error mip_filter_mag_magnitude_adaptive_decode(struct mip_filter_mag_magnitude_adaptive *value,
                                                   const struct mip_field *field);
mip_error mip_filter_mag_magnitude_adaptive_encode(
    const struct mip_filter_mag_magnitude_adaptive *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_write(
    mip_filter_adaptive_measurement_selector adaptive_measurement, float frequency, float low_limit,
    float high_limit, float low_limit_uncertainty, float high_limit_uncertainty,
    float minimum_uncertainty);
/** Send the current setting back in a response. */
struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_save(void);
/** Load the saved setting. */
struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_load(void);
/** Load the factory default setting. */
struct mip_filter_mag_magnitude_adaptive mip_filter_mag_magnitude_adaptive_default(void);

/**
 * Magnetometer magnitude error adaptive measurement response: response (0x0D,0xB4).
 *
 * In full: filter.mag_magnitude_error_adaptive_measurement_response.
 *
 * Answers mip_filter_mag_magnitude_adaptive. Supported by 3DM-GX5-45. May be supported by
 * 3DM-GQ4-45, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 * Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
 */
struct mip_filter_mag_magnitude_adaptive_response {
    /** Kind of adaptation. */
    mip_filter_adaptive_measurement_selector adaptive_measurement;
    /** Cut-off frequency of the low-pass filter. Unit: Hz. */
    float frequency;
    /**
     * Lower limit of the error. Unit: gauss. Uncertain: The unit. The SDK prints m/s^2; a manual of
     * the 3DM-GX5-45 prints m/s^2 in the command and gauss in the response.
     */
    float low_limit;
    /**
     * Upper limit of the error. Unit: gauss. Uncertain: The unit. The SDK prints m/s^2; a manual of
     * the 3DM-GX5-45 prints m/s^2 in the command and gauss in the response.
     */
    float high_limit;
    /**
     * Standard deviation at the lower limit. Unit: gauss. Uncertain: The unit. The SDK prints
     * m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the response.
     */
    float low_limit_uncertainty;
    /**
     * Standard deviation at the upper limit. Unit: gauss. Uncertain: The unit. The SDK prints
     * m/s^2; a manual of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the response.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: gauss. Uncertain: The unit. The SDK prints m/s^2; a manual
     * of the 3DM-GX5-45 prints m/s^2 in the command and gauss in the response.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE_DESCRIPTOR 0xB4
#define MIP_FILTER_MAG_MAGNITUDE_ADAPTIVE_RESPONSE_NAME \
    "filter.mag_magnitude_error_adaptive_measurement_response"

extern const struct mip_codec mip_filter_mag_magnitude_adaptive_response_codec;
mip_error mip_filter_mag_magnitude_adaptive_response_decode(
    struct mip_filter_mag_magnitude_adaptive_response *value, const struct mip_field *field);
mip_error mip_filter_mag_magnitude_adaptive_response_encode(
    const struct mip_filter_mag_magnitude_adaptive_response *value, struct mip_builder *builder);

/**
 * Magnetometer dip angle error adaptive measurement: command (0x0D,0x46).
 *
 * How far the filter trusts a magnetic field whose dip angle is not as expected.
 *
 * In full: filter.mag_dip_angle_error_adaptive_measurement.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_mag_dip_angle_adaptive_response. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * It has no effect while mip_filter_accel_magnitude_adaptive or mip_filter_mag_magnitude_adaptive
 * is set to `auto`.
 *
 * High limits suit high dynamics but let disturbances of the field through; low limits can spoil
 * the heading.
 *
 * - mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
 */
struct mip_filter_mag_dip_angle_adaptive {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Whether the adaptation is on. Required for write. */
    mip_bool enable;
    /** Cut-off frequency of the low-pass filter. Unit: Hz. Required for write. */
    float frequency;
    /**
     * Upper limit of the error. Unit: rad. Required for write. Uncertain: The unit. The SDK prints
     * m/s^2; rad is inferred from the quantity.
     */
    float high_limit;
    /**
     * Standard deviation at the upper limit. Unit: rad. Required for write. Uncertain: The unit.
     * The SDK prints m/s^2; rad is inferred from the quantity.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: rad. Required for write. Uncertain: The unit. The SDK
     * prints m/s^2; rad is inferred from the quantity.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_DESCRIPTOR 0x46
#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_NAME "filter.mag_dip_angle_error_adaptive_measurement"

extern const struct mip_codec mip_filter_mag_dip_angle_adaptive_codec;
mip_error mip_filter_mag_dip_angle_adaptive_decode(struct mip_filter_mag_dip_angle_adaptive *value,
                                                   const struct mip_field *field);
mip_error mip_filter_mag_dip_angle_adaptive_encode(
    const struct mip_filter_mag_dip_angle_adaptive *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_mag_dip_angle_adaptive
mip_filter_mag_dip_angle_adaptive_write(mip_bool enable, float frequency, float high_limit,
                                        float high_limit_uncertainty, float minimum_uncertainty);
/** Send the current setting back in a response. */
struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_save(void);
/** Load the saved setting. */
struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_load(void);
/** Load the factory default setting. */
struct mip_filter_mag_dip_angle_adaptive mip_filter_mag_dip_angle_adaptive_default(void);

/**
 * Magnetometer dip angle error adaptive measurement response: response (0x0D,0xB5).
 *
 * In full: filter.mag_dip_angle_error_adaptive_measurement_response.
 *
 * Answers mip_filter_mag_dip_angle_adaptive. Supported by 3DM-GX5-45. Known from the MicroStrain
 * MIP SDK only.
 *
 * - mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
 */
struct mip_filter_mag_dip_angle_adaptive_response {
    /** Whether the adaptation is on. */
    mip_bool enable;
    /** Cut-off frequency of the low-pass filter. Unit: Hz. */
    float frequency;
    /**
     * Upper limit of the error. Unit: rad. Uncertain: The unit. The SDK prints m/s^2; rad is
     * inferred from the quantity.
     */
    float high_limit;
    /**
     * Standard deviation at the upper limit. Unit: rad. Uncertain: The unit. The SDK prints m/s^2;
     * rad is inferred from the quantity.
     */
    float high_limit_uncertainty;
    /**
     * Smallest standard deviation. Unit: rad. Uncertain: The unit. The SDK prints m/s^2; rad is
     * inferred from the quantity.
     */
    float minimum_uncertainty;
};

#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE_DESCRIPTOR 0xB5
#define MIP_FILTER_MAG_DIP_ANGLE_ADAPTIVE_RESPONSE_NAME \
    "filter.mag_dip_angle_error_adaptive_measurement_response"

extern const struct mip_codec mip_filter_mag_dip_angle_adaptive_response_codec;
mip_error mip_filter_mag_dip_angle_adaptive_response_decode(
    struct mip_filter_mag_dip_angle_adaptive_response *value, const struct mip_field *field);
mip_error mip_filter_mag_dip_angle_adaptive_response_encode(
    const struct mip_filter_mag_dip_angle_adaptive_response *value, struct mip_builder *builder);

/**
 * Altitude aiding: command (0x0D,0x47).
 *
 * What aids the altitude beside GNSS.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_altitude_aiding_response.
 * Supported by 3DM-GX5-45. Known from the MicroStrain MIP SDK only.
 *
 * GNSS stays the main source of altitude; the aid improves it and bridges outages.
 *
 * Weather and place shift the pressure altitude, at times by more than 40 m.
 *
 * - mip-sdk-4: Altitude Aiding (0x0D,0x47)
 */
struct mip_filter_altitude_aiding {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Source of the aiding. Required for write. */
    mip_filter_altitude_aiding_source selector;
};

#define MIP_FILTER_ALTITUDE_AIDING_DESCRIPTOR 0x47
#define MIP_FILTER_ALTITUDE_AIDING_NAME "filter.altitude_aiding"

extern const struct mip_codec mip_filter_altitude_aiding_codec;
mip_error mip_filter_altitude_aiding_decode(struct mip_filter_altitude_aiding *value,
                                            const struct mip_field *field);
mip_error mip_filter_altitude_aiding_encode(const struct mip_filter_altitude_aiding *value,
                                            struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_altitude_aiding
mip_filter_altitude_aiding_write(mip_filter_altitude_aiding_source selector);
/** Send the current setting back in a response. */
struct mip_filter_altitude_aiding mip_filter_altitude_aiding_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_altitude_aiding mip_filter_altitude_aiding_save(void);
/** Load the saved setting. */
struct mip_filter_altitude_aiding mip_filter_altitude_aiding_load(void);
/** Load the factory default setting. */
struct mip_filter_altitude_aiding mip_filter_altitude_aiding_default(void);

/**
 * Altitude aiding response: response (0x0D,0xB7).
 *
 * Answers mip_filter_altitude_aiding. Supported by 3DM-GX5-45. Known from the MicroStrain MIP SDK
 * only.
 *
 * - mip-sdk-4: Altitude Aiding (0x0D,0x47)
 */
struct mip_filter_altitude_aiding_response {
    /** Source of the aiding. */
    mip_filter_altitude_aiding_source selector;
};

#define MIP_FILTER_ALTITUDE_AIDING_RESPONSE_DESCRIPTOR 0xB7
#define MIP_FILTER_ALTITUDE_AIDING_RESPONSE_NAME "filter.altitude_aiding_response"

extern const struct mip_codec mip_filter_altitude_aiding_response_codec;
mip_error mip_filter_altitude_aiding_response_decode(
    struct mip_filter_altitude_aiding_response *value, const struct mip_field *field);
mip_error mip_filter_altitude_aiding_response_encode(
    const struct mip_filter_altitude_aiding_response *value, struct mip_builder *builder);

/**
 * Pitch and roll aiding: command (0x0D,0x4B).
 *
 * What aids pitch and roll while the motion is gentle.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_pitch_roll_aiding_response. Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
 */
struct mip_filter_pitch_roll_aiding {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Source of the aiding. Required for write. */
    mip_filter_pitch_roll_aiding_source aiding;
};

#define MIP_FILTER_PITCH_ROLL_AIDING_DESCRIPTOR 0x4B
#define MIP_FILTER_PITCH_ROLL_AIDING_NAME "filter.pitch_roll_aiding"

extern const struct mip_codec mip_filter_pitch_roll_aiding_codec;
mip_error mip_filter_pitch_roll_aiding_decode(struct mip_filter_pitch_roll_aiding *value,
                                              const struct mip_field *field);
mip_error mip_filter_pitch_roll_aiding_encode(const struct mip_filter_pitch_roll_aiding *value,
                                              struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_pitch_roll_aiding
mip_filter_pitch_roll_aiding_write(mip_filter_pitch_roll_aiding_source aiding);
/** Send the current setting back in a response. */
struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_save(void);
/** Load the saved setting. */
struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_load(void);
/** Load the factory default setting. */
struct mip_filter_pitch_roll_aiding mip_filter_pitch_roll_aiding_default(void);

/**
 * Pitch and roll aiding response: response (0x0D,0xBB).
 *
 * Answers mip_filter_pitch_roll_aiding. Supported by 3DM-GX5-15 and 3DM-GX5-45.
 *
 * - 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
 */
struct mip_filter_pitch_roll_aiding_response {
    /** Source of the aiding. */
    mip_filter_pitch_roll_aiding_source aiding;
};

#define MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE_DESCRIPTOR 0xBB
#define MIP_FILTER_PITCH_ROLL_AIDING_RESPONSE_NAME "filter.pitch_roll_aiding_response"

extern const struct mip_codec mip_filter_pitch_roll_aiding_response_codec;
mip_error mip_filter_pitch_roll_aiding_response_decode(
    struct mip_filter_pitch_roll_aiding_response *value, const struct mip_field *field);
mip_error mip_filter_pitch_roll_aiding_response_encode(
    const struct mip_filter_pitch_roll_aiding_response *value, struct mip_builder *builder);

/**
 * Magnetic inclination source: command (0x0D,0x4C).
 *
 * Source of the local inclination (dip angle) of the magnetic field.
 *
 * Also called `inclination_source`. Functions: write, read, save, load and default. Answered by
 * mip_filter_magnetic_inclination_source_response. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * Without a good inclination source, keep automatic magnetometer calibration off.
 *
 * - mip-sdk-4: Inclination Source (0x0D,0x4C)
 */
struct mip_filter_magnetic_inclination_source {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Source of the inclination. Required for write. */
    mip_filter_mag_parameter_source source;
    /**
     * Inclination; used only if `source` is manual. Unit: rad. Required for write. Uncertain:
     * Whether it may be left out if `source` is not manual. The SDK sends it always.
     */
    float inclination;
};

#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_DESCRIPTOR 0x4C
#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_NAME "filter.magnetic_inclination_source"

extern const struct mip_codec mip_filter_magnetic_inclination_source_codec;
mip_error mip_filter_magnetic_inclination_source_decode(
    struct mip_filter_magnetic_inclination_source *value, const struct mip_field *field);
mip_error mip_filter_magnetic_inclination_source_encode(
    const struct mip_filter_magnetic_inclination_source *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_write(
    mip_filter_mag_parameter_source source, float inclination);
/** Send the current setting back in a response. */
struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_save(void);
/** Load the saved setting. */
struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_load(void);
/** Load the factory default setting. */
struct mip_filter_magnetic_inclination_source mip_filter_magnetic_inclination_source_default(void);

/**
 * Magnetic inclination source response: response (0x0D,0xBC).
 *
 * Also called `inclination_source_response`. Answers mip_filter_magnetic_inclination_source. Known
 * from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Inclination Source (0x0D,0x4C)
 */
struct mip_filter_magnetic_inclination_source_response {
    /** Source of the inclination. */
    mip_filter_mag_parameter_source source;
    /**
     * Inclination; used only if `source` is manual. Unit: rad. Uncertain: Whether it may be left
     * out if `source` is not manual. The SDK sends it always.
     */
    float inclination;
};

#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE_DESCRIPTOR 0xBC
#define MIP_FILTER_MAGNETIC_INCLINATION_SOURCE_RESPONSE_NAME \
    "filter.magnetic_inclination_source_response"

extern const struct mip_codec mip_filter_magnetic_inclination_source_response_codec;
mip_error mip_filter_magnetic_inclination_source_response_decode(
    struct mip_filter_magnetic_inclination_source_response *value, const struct mip_field *field);
mip_error mip_filter_magnetic_inclination_source_response_encode(
    const struct mip_filter_magnetic_inclination_source_response *value,
    struct mip_builder *builder);

/**
 * Magnetic field magnitude source: command (0x0D,0x4D).
 *
 * Source of the local magnitude of the magnetic field.
 *
 * Also called `mag_field_magnitude_source`. Functions: write, read, save, load and default.
 * Answered by mip_filter_magnetic_magnitude_source_response. No device profile lists it. Known from
 * the MicroStrain MIP SDK only.
 *
 * Without a good magnitude source, keep automatic magnetometer calibration off.
 *
 * mip_filter_mag_magnitude_adaptive relies on it too.
 *
 * - mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
 */
struct mip_filter_magnetic_magnitude_source {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Source of the magnitude. Required for write. */
    mip_filter_mag_parameter_source source;
    /**
     * Magnitude; used only if `source` is manual. Unit: gauss. Required for write. Uncertain:
     * Whether it may be left out if `source` is not manual. The SDK sends it always.
     */
    float magnitude;
};

#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_DESCRIPTOR 0x4D
#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_NAME "filter.magnetic_magnitude_source"

extern const struct mip_codec mip_filter_magnetic_magnitude_source_codec;
mip_error mip_filter_magnetic_magnitude_source_decode(
    struct mip_filter_magnetic_magnitude_source *value, const struct mip_field *field);
mip_error mip_filter_magnetic_magnitude_source_encode(
    const struct mip_filter_magnetic_magnitude_source *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_magnetic_magnitude_source
mip_filter_magnetic_magnitude_source_write(mip_filter_mag_parameter_source source, float magnitude);
/** Send the current setting back in a response. */
struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_save(void);
/** Load the saved setting. */
struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_load(void);
/** Load the factory default setting. */
struct mip_filter_magnetic_magnitude_source mip_filter_magnetic_magnitude_source_default(void);

/**
 * Magnetic field magnitude source response: response (0x0D,0xBD).
 *
 * Also called `mag_field_magnitude_source_response`. Answers mip_filter_magnetic_magnitude_source.
 * Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
 */
struct mip_filter_magnetic_magnitude_source_response {
    /** Source of the magnitude. */
    mip_filter_mag_parameter_source source;
    /**
     * Magnitude; used only if `source` is manual. Unit: gauss. Uncertain: Whether it may be left
     * out if `source` is not manual. The SDK sends it always.
     */
    float magnitude;
};

#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE_DESCRIPTOR 0xBD
#define MIP_FILTER_MAGNETIC_MAGNITUDE_SOURCE_RESPONSE_NAME \
    "filter.magnetic_magnitude_source_response"

extern const struct mip_codec mip_filter_magnetic_magnitude_source_response_codec;
mip_error mip_filter_magnetic_magnitude_source_response_decode(
    struct mip_filter_magnetic_magnitude_source_response *value, const struct mip_field *field);
mip_error mip_filter_magnetic_magnitude_source_response_encode(
    const struct mip_filter_magnetic_magnitude_source_response *value, struct mip_builder *builder);

/**
 * Sensor to vehicle rotation, matrix: command (0x0D,0x4E).
 *
 * Rotation from the sensor frame to the vehicle frame as a direction cosine matrix.
 *
 * In full: filter.sensor_to_vehicle_rotation_dcm.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_sensor_to_vehicle_dcm_response. No device profile lists it. Known from the MicroStrain
 * MIP SDK only.
 *
 * It is the inverse of the matrix that mip_3dm_sensor_to_vehicle_dcm takes.
 *
 * It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
 * velocity, and the orientation, linear acceleration, angular rate and gravity vector of the
 * filter.
 *
 * The device refuses a matrix that is not orthonormal to 0.001.
 *
 * The device keeps a quaternion, so the elements read back may differ a little from those written.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
 */
struct mip_filter_sensor_to_vehicle_dcm {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Rotation matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Unit: 1. Required for write.
     */
    float dcm[9];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_DCM_DESCRIPTOR 0x4E
#define MIP_FILTER_SENSOR_TO_VEHICLE_DCM_NAME "filter.sensor_to_vehicle_rotation_dcm"

extern const struct mip_codec mip_filter_sensor_to_vehicle_dcm_codec;
mip_error mip_filter_sensor_to_vehicle_dcm_decode(struct mip_filter_sensor_to_vehicle_dcm *value,
                                                  const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_dcm_encode(
    const struct mip_filter_sensor_to_vehicle_dcm *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_write(const float dcm[9]);
/** Send the current setting back in a response. */
struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_save(void);
/** Load the saved setting. */
struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_load(void);
/** Load the factory default setting. */
struct mip_filter_sensor_to_vehicle_dcm mip_filter_sensor_to_vehicle_dcm_default(void);

/**
 * Sensor to vehicle rotation, matrix response: response (0x0D,0xBE).
 *
 * In full: filter.sensor_to_vehicle_rotation_dcm_response.
 *
 * Answers mip_filter_sensor_to_vehicle_dcm. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
 */
struct mip_filter_sensor_to_vehicle_dcm_response {
    /**
     * Rotation matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Unit: 1.
     */
    float dcm[9];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_DCM_RESPONSE_DESCRIPTOR 0xBE
#define MIP_FILTER_SENSOR_TO_VEHICLE_DCM_RESPONSE_NAME \
    "filter.sensor_to_vehicle_rotation_dcm_response"

extern const struct mip_codec mip_filter_sensor_to_vehicle_dcm_response_codec;
mip_error mip_filter_sensor_to_vehicle_dcm_response_decode(
    struct mip_filter_sensor_to_vehicle_dcm_response *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_dcm_response_encode(
    const struct mip_filter_sensor_to_vehicle_dcm_response *value, struct mip_builder *builder);

/**
 * Sensor to vehicle rotation, quaternion: command (0x0D,0x4F).
 *
 * Rotation from the sensor frame to the vehicle frame as a quaternion.
 *
 * In full: filter.sensor_to_vehicle_rotation_quaternion.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_sensor_to_vehicle_quaternion_response. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * It is the inverse of the quaternion that mip_3dm_sensor_to_vehicle_quaternion takes.
 *
 * It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
 * velocity, and the orientation, linear acceleration, angular rate and gravity vector of the
 * filter.
 *
 * The device normalizes it, so the elements read back may differ a little from those written.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
 */
struct mip_filter_sensor_to_vehicle_quaternion {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Unit quaternion, scalar part first. Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to
     * 1.001. Required for write.
     */
    float q[4];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_DESCRIPTOR 0x4F
#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_NAME "filter.sensor_to_vehicle_rotation_quaternion"

extern const struct mip_codec mip_filter_sensor_to_vehicle_quaternion_codec;
mip_error mip_filter_sensor_to_vehicle_quaternion_decode(
    struct mip_filter_sensor_to_vehicle_quaternion *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_quaternion_encode(
    const struct mip_filter_sensor_to_vehicle_quaternion *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_sensor_to_vehicle_quaternion
mip_filter_sensor_to_vehicle_quaternion_write(const float q[4]);
/** Send the current setting back in a response. */
struct mip_filter_sensor_to_vehicle_quaternion mip_filter_sensor_to_vehicle_quaternion_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_sensor_to_vehicle_quaternion mip_filter_sensor_to_vehicle_quaternion_save(void);
/** Load the saved setting. */
struct mip_filter_sensor_to_vehicle_quaternion mip_filter_sensor_to_vehicle_quaternion_load(void);
/** Load the factory default setting. */
struct mip_filter_sensor_to_vehicle_quaternion
mip_filter_sensor_to_vehicle_quaternion_default(void);

/**
 * Sensor to vehicle rotation, quaternion response: response (0x0D,0xBF).
 *
 * In full: filter.sensor_to_vehicle_rotation_quaternion_response.
 *
 * Answers mip_filter_sensor_to_vehicle_quaternion. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
 */
struct mip_filter_sensor_to_vehicle_quaternion_response {
    /**
     * Unit quaternion, scalar part first. Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to
     * 1.001.
     */
    float q[4];
};

#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_DESCRIPTOR 0xBF
#define MIP_FILTER_SENSOR_TO_VEHICLE_QUATERNION_RESPONSE_NAME \
    "filter.sensor_to_vehicle_rotation_quaternion_response"

extern const struct mip_codec mip_filter_sensor_to_vehicle_quaternion_response_codec;
mip_error mip_filter_sensor_to_vehicle_quaternion_response_decode(
    struct mip_filter_sensor_to_vehicle_quaternion_response *value, const struct mip_field *field);
mip_error mip_filter_sensor_to_vehicle_quaternion_response_encode(
    const struct mip_filter_sensor_to_vehicle_quaternion_response *value,
    struct mip_builder *builder);

/**
 * Aiding measurement control: command (0x0D,0x50).
 *
 * Enables or disables one source of aiding measurements.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_aiding_measurement_enable_response. Supported by 3DM-CV7-GNSS/INS. May be supported by
 * 3DM-CV7-AHRS and 3DM-CV7-AR.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
 */
struct mip_filter_aiding_measurement_enable {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * The source; `all` is for save, load and default. On the 3DM-CV7-AHRS: only
     * MIP_FILTER_AIDING_SOURCE_MAG, MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and
     * MIP_FILTER_AIDING_SOURCE_ALL. On the 3DM-CV7-AR: only
     * MIP_FILTER_AIDING_SOURCE_EXTERNAL_HEADING and MIP_FILTER_AIDING_SOURCE_ALL.
     */
    mip_filter_aiding_source aiding_source;
    /** Whether the filter uses the source. Required for write. */
    mip_bool enable;
};

#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_DESCRIPTOR 0x50
#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_NAME "filter.aiding_measurement_enable"

extern const struct mip_codec mip_filter_aiding_measurement_enable_codec;
mip_error mip_filter_aiding_measurement_enable_decode(
    struct mip_filter_aiding_measurement_enable *value, const struct mip_field *field);
mip_error mip_filter_aiding_measurement_enable_encode(
    const struct mip_filter_aiding_measurement_enable *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_write(mip_filter_aiding_source aiding_source, mip_bool enable);
/** Send the current setting back in a response. */
struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_read(mip_filter_aiding_source aiding_source);
/** Save the current setting to non-volatile memory. */
struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_save(mip_filter_aiding_source aiding_source);
/** Load the saved setting. */
struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_load(mip_filter_aiding_source aiding_source);
/** Load the factory default setting. */
struct mip_filter_aiding_measurement_enable
mip_filter_aiding_measurement_enable_default(mip_filter_aiding_source aiding_source);

/**
 * Aiding measurement control response: response (0x0D,0xD0).
 *
 * Answers mip_filter_aiding_measurement_enable. Supported by 3DM-CV7-GNSS/INS. May be supported by
 * 3DM-CV7-AHRS and 3DM-CV7-AR.
 *
 * - 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
 */
struct mip_filter_aiding_measurement_enable_response {
    /** The source; `all` is for save, load and default. */
    mip_filter_aiding_source aiding_source;
    /** Whether the filter uses the source. */
    mip_bool enable;
};

#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE_DESCRIPTOR 0xD0
#define MIP_FILTER_AIDING_MEASUREMENT_ENABLE_RESPONSE_NAME \
    "filter.aiding_measurement_enable_response"

extern const struct mip_codec mip_filter_aiding_measurement_enable_response_codec;
mip_error mip_filter_aiding_measurement_enable_response_decode(
    struct mip_filter_aiding_measurement_enable_response *value, const struct mip_field *field);
mip_error mip_filter_aiding_measurement_enable_response_encode(
    const struct mip_filter_aiding_measurement_enable_response *value, struct mip_builder *builder);

/**
 * Kinematic constraint: command (0x0D,0x51).
 *
 * Assumptions about the motion that the filter uses as measurements.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_kinematic_constraint_response. No device profile lists it. Known from the MicroStrain
 * MIP SDK only. Uncertain: Whether there are further values. The SDK has plain numbers and gives
 * the values in remarks.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
struct mip_filter_kinematic_constraint {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Assumption about the acceleration. Default: MIP_FILTER_ACCEL_CONSTRAINT_NONE. Required for
     * write.
     */
    mip_filter_accel_constraint accel_constraint;
    /**
     * Assumption about the velocity. Default: MIP_FILTER_VELOCITY_CONSTRAINT_NONE. Required for
     * write.
     */
    mip_filter_velocity_constraint velocity_constraint;
    /**
     * Assumption about the angular rate. Default: MIP_FILTER_ANGULAR_CONSTRAINT_NONE. Required for
     * write.
     */
    mip_filter_angular_constraint angular_constraint;
};

#define MIP_FILTER_KINEMATIC_CONSTRAINT_DESCRIPTOR 0x51
#define MIP_FILTER_KINEMATIC_CONSTRAINT_NAME "filter.kinematic_constraint"

extern const struct mip_codec mip_filter_kinematic_constraint_codec;
mip_error mip_filter_kinematic_constraint_decode(struct mip_filter_kinematic_constraint *value,
                                                 const struct mip_field *field);
mip_error mip_filter_kinematic_constraint_encode(
    const struct mip_filter_kinematic_constraint *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_kinematic_constraint
mip_filter_kinematic_constraint_write(mip_filter_accel_constraint accel_constraint,
                                      mip_filter_velocity_constraint velocity_constraint,
                                      mip_filter_angular_constraint angular_constraint);
/** Send the current setting back in a response. */
struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_save(void);
/** Load the saved setting. */
struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_load(void);
/** Load the factory default setting. */
struct mip_filter_kinematic_constraint mip_filter_kinematic_constraint_default(void);

/**
 * Kinematic constraint response: response (0x0D,0xD1).
 *
 * Answers mip_filter_kinematic_constraint. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Kinematic Constraint (0x0D,0x51)
 */
struct mip_filter_kinematic_constraint_response {
    /** Assumption about the acceleration. Default: MIP_FILTER_ACCEL_CONSTRAINT_NONE. */
    mip_filter_accel_constraint accel_constraint;
    /** Assumption about the velocity. Default: MIP_FILTER_VELOCITY_CONSTRAINT_NONE. */
    mip_filter_velocity_constraint velocity_constraint;
    /** Assumption about the angular rate. Default: MIP_FILTER_ANGULAR_CONSTRAINT_NONE. */
    mip_filter_angular_constraint angular_constraint;
};

#define MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE_DESCRIPTOR 0xD1
#define MIP_FILTER_KINEMATIC_CONSTRAINT_RESPONSE_NAME "filter.kinematic_constraint_response"

extern const struct mip_codec mip_filter_kinematic_constraint_response_codec;
mip_error mip_filter_kinematic_constraint_response_decode(
    struct mip_filter_kinematic_constraint_response *value, const struct mip_field *field);
mip_error mip_filter_kinematic_constraint_response_encode(
    const struct mip_filter_kinematic_constraint_response *value, struct mip_builder *builder);

/**
 * Navigation filter initialization: command (0x0D,0x52).
 *
 * Sources and values of the initial attitude, position and velocity of the filter.
 *
 * Also called `initialization_configuration`. Functions: write, read, save, load and default.
 * Answered by mip_filter_initialization_config_response. Supported by 3DM-CV7-GNSS/INS and
 * 3DM-GQ7-GNSS/INS.
 *
 * Single precision resolves the latitude and longitude of the initial position to about a metre
 * only.
 *
 * Kinematic alignment sets the heading once the speed reaches 2 m/s.
 *
 * External alignment needs a heading at least every 5 seconds.
 *
 * - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
 */
struct mip_filter_initialization_config {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * 1: the filter starts only after mip_filter_run; 0: as soon as it can. Range: 0 to 1. Required
     * for write.
     */
    uint8_t wait_for_run_command;
    /** Which initial conditions are found and which are given. Required for write. */
    mip_filter_initial_condition_source initial_condition_source;
    /** Ways in which the initial heading may be found. Required for write. */
    mip_filter_heading_alignment auto_heading_alignment_selector;
    /** Given heading. Unit: deg. Required for write. */
    float initial_heading;
    /** Given pitch. Unit: deg. Required for write. */
    float initial_pitch;
    /** Given roll. Unit: deg. Required for write. */
    float initial_roll;
    /**
     * Given position. Elements: x, y, z. Required for write. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: unit deg, deg, m; frame llh.
     */
    float initial_position[3];
    /**
     * Given velocity. Elements: x, y, z. Unit: m/s. Required for write. If reference_frame_selector
     * is MIP_FILTER_REFERENCE_FRAME_ECEF: frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: frame ned.
     */
    float initial_velocity[3];
    /** Frame of the given position and velocity. Required for write. */
    mip_filter_reference_frame reference_frame_selector;
};

#define MIP_FILTER_INITIALIZATION_CONFIG_DESCRIPTOR 0x52
#define MIP_FILTER_INITIALIZATION_CONFIG_NAME "filter.initialization_config"

extern const struct mip_codec mip_filter_initialization_config_codec;
mip_error mip_filter_initialization_config_decode(struct mip_filter_initialization_config *value,
                                                  const struct mip_field *field);
mip_error mip_filter_initialization_config_encode(
    const struct mip_filter_initialization_config *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_initialization_config mip_filter_initialization_config_write(
    uint8_t wait_for_run_command, mip_filter_initial_condition_source initial_condition_source,
    mip_filter_heading_alignment auto_heading_alignment_selector, float initial_heading,
    float initial_pitch, float initial_roll, const float initial_position[3],
    const float initial_velocity[3], mip_filter_reference_frame reference_frame_selector);
/** Send the current setting back in a response. */
struct mip_filter_initialization_config mip_filter_initialization_config_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_initialization_config mip_filter_initialization_config_save(void);
/** Load the saved setting. */
struct mip_filter_initialization_config mip_filter_initialization_config_load(void);
/** Load the factory default setting. */
struct mip_filter_initialization_config mip_filter_initialization_config_default(void);

/**
 * Navigation filter initialization response: response (0x0D,0xD2).
 *
 * Also called `initialization_configuration_response`. Answers mip_filter_initialization_config.
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
 */
struct mip_filter_initialization_config_response {
    /** 1: the filter starts only after mip_filter_run; 0: as soon as it can. Range: 0 to 1. */
    uint8_t wait_for_run_command;
    /** Which initial conditions are found and which are given. */
    mip_filter_initial_condition_source initial_condition_source;
    /** Ways in which the initial heading may be found. */
    mip_filter_heading_alignment auto_heading_alignment_selector;
    /** Given heading. Unit: deg. */
    float initial_heading;
    /** Given pitch. Unit: deg. */
    float initial_pitch;
    /** Given roll. Unit: deg. */
    float initial_roll;
    /**
     * Given position. Elements: x, y, z. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: unit deg, deg, m; frame llh.
     */
    float initial_position[3];
    /**
     * Given velocity. Elements: x, y, z. Unit: m/s. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: frame ned.
     */
    float initial_velocity[3];
    /** Frame of the given position and velocity. */
    mip_filter_reference_frame reference_frame_selector;
};

#define MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE_DESCRIPTOR 0xD2
#define MIP_FILTER_INITIALIZATION_CONFIG_RESPONSE_NAME "filter.initialization_config_response"

extern const struct mip_codec mip_filter_initialization_config_response_codec;
mip_error mip_filter_initialization_config_response_decode(
    struct mip_filter_initialization_config_response *value, const struct mip_field *field);
mip_error mip_filter_initialization_config_response_encode(
    const struct mip_filter_initialization_config_response *value, struct mip_builder *builder);

/**
 * Adaptive filter control: command (0x0D,0x53).
 *
 * How the filter adapts to measurements that do not fit its model.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_adaptive_filter_options_response. Supported by 3DM-CV7-GNSS/INS. May be supported by
 * 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
 */
struct mip_filter_adaptive_filter_options {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /**
     * Strength of the adaptation. Default: 2. Required for write. On the 3DM-GX5-45: only
     * MIP_FILTER_ADAPTIVE_LEVEL_OFF and MIP_FILTER_ADAPTIVE_LEVEL_MODERATE.
     */
    mip_filter_adaptive_level level;
    /**
     * Longest time for which measurements are rejected before the filter recovers. Unit: ms.
     * Required for write.
     */
    uint16_t time_limit;
};

#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_DESCRIPTOR 0x53
#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_NAME "filter.adaptive_filter_options"

extern const struct mip_codec mip_filter_adaptive_filter_options_codec;
mip_error mip_filter_adaptive_filter_options_decode(
    struct mip_filter_adaptive_filter_options *value, const struct mip_field *field);
mip_error mip_filter_adaptive_filter_options_encode(
    const struct mip_filter_adaptive_filter_options *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_adaptive_filter_options
mip_filter_adaptive_filter_options_write(mip_filter_adaptive_level level, uint16_t time_limit);
/** Send the current setting back in a response. */
struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_save(void);
/** Load the saved setting. */
struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_load(void);
/** Load the factory default setting. */
struct mip_filter_adaptive_filter_options mip_filter_adaptive_filter_options_default(void);

/**
 * Adaptive filter control response: response (0x0D,0xD3).
 *
 * Answers mip_filter_adaptive_filter_options. Supported by 3DM-CV7-GNSS/INS. May be supported by
 * 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
 */
struct mip_filter_adaptive_filter_options_response {
    /** Strength of the adaptation. Default: 2. */
    mip_filter_adaptive_level level;
    /** Longest time for which measurements are rejected before the filter recovers. Unit: ms. */
    uint16_t time_limit;
};

#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE_DESCRIPTOR 0xD3
#define MIP_FILTER_ADAPTIVE_FILTER_OPTIONS_RESPONSE_NAME "filter.adaptive_filter_options_response"

extern const struct mip_codec mip_filter_adaptive_filter_options_response_codec;
mip_error mip_filter_adaptive_filter_options_response_decode(
    struct mip_filter_adaptive_filter_options_response *value, const struct mip_field *field);
mip_error mip_filter_adaptive_filter_options_response_encode(
    const struct mip_filter_adaptive_filter_options_response *value, struct mip_builder *builder);

/**
 * GNSS multi-antenna offset: command (0x0D,0x54).
 *
 * Position of the antenna of one receiver on devices with several antennas.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_multi_antenna_offset_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
 */
struct mip_filter_multi_antenna_offset {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Number of the receiver, from 1. Range: at least 1. */
    uint8_t receiver_id;
    /**
     * From the sensor to the antenna. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude
     * at most 10. Required for write.
     */
    float antenna_offset[3];
};

#define MIP_FILTER_MULTI_ANTENNA_OFFSET_DESCRIPTOR 0x54
#define MIP_FILTER_MULTI_ANTENNA_OFFSET_NAME "filter.multi_antenna_offset"

extern const struct mip_codec mip_filter_multi_antenna_offset_codec;
mip_error mip_filter_multi_antenna_offset_decode(struct mip_filter_multi_antenna_offset *value,
                                                 const struct mip_field *field);
mip_error mip_filter_multi_antenna_offset_encode(
    const struct mip_filter_multi_antenna_offset *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_multi_antenna_offset
mip_filter_multi_antenna_offset_write(uint8_t receiver_id, const float antenna_offset[3]);
/** Send the current setting back in a response. */
struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_read(uint8_t receiver_id);
/** Save the current setting to non-volatile memory. */
struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_save(uint8_t receiver_id);
/** Load the saved setting. */
struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_load(uint8_t receiver_id);
/** Load the factory default setting. */
struct mip_filter_multi_antenna_offset mip_filter_multi_antenna_offset_default(uint8_t receiver_id);

/**
 * GNSS multi-antenna offset response: response (0x0D,0xD4).
 *
 * Answers mip_filter_multi_antenna_offset. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
 */
struct mip_filter_multi_antenna_offset_response {
    /** Number of the receiver, from 1. Range: at least 1. */
    uint8_t receiver_id;
    /**
     * From the sensor to the antenna. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude
     * at most 10.
     */
    float antenna_offset[3];
};

#define MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE_DESCRIPTOR 0xD4
#define MIP_FILTER_MULTI_ANTENNA_OFFSET_RESPONSE_NAME "filter.multi_antenna_offset_response"

extern const struct mip_codec mip_filter_multi_antenna_offset_response_codec;
mip_error mip_filter_multi_antenna_offset_response_decode(
    struct mip_filter_multi_antenna_offset_response *value, const struct mip_field *field);
mip_error mip_filter_multi_antenna_offset_response_encode(
    const struct mip_filter_multi_antenna_offset_response *value, struct mip_builder *builder);

/**
 * Relative position configuration: command (0x0D,0x55).
 *
 * Reference point of the relative position that the filter reports.
 *
 * Also called `rel_pos_configuration`. Functions: write, read, save, load and default. Answered by
 * mip_filter_relative_position_config_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
 */
struct mip_filter_relative_position_config {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Source of the reference point. Required for write. */
    mip_filter_relative_position_source source;
    /** Frame of the coordinates. Required for write. */
    mip_filter_reference_frame reference_frame_selector;
    /**
     * Reference point. Elements: x, y, z. Required for write. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: unit deg, deg, m; frame llh.
     */
    double reference_coordinates[3];
};

#define MIP_FILTER_RELATIVE_POSITION_CONFIG_DESCRIPTOR 0x55
#define MIP_FILTER_RELATIVE_POSITION_CONFIG_NAME "filter.relative_position_config"

extern const struct mip_codec mip_filter_relative_position_config_codec;
mip_error mip_filter_relative_position_config_decode(
    struct mip_filter_relative_position_config *value, const struct mip_field *field);
mip_error mip_filter_relative_position_config_encode(
    const struct mip_filter_relative_position_config *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_relative_position_config mip_filter_relative_position_config_write(
    mip_filter_relative_position_source source, mip_filter_reference_frame reference_frame_selector,
    const double reference_coordinates[3]);
/** Send the current setting back in a response. */
struct mip_filter_relative_position_config mip_filter_relative_position_config_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_relative_position_config mip_filter_relative_position_config_save(void);
/** Load the saved setting. */
struct mip_filter_relative_position_config mip_filter_relative_position_config_load(void);
/** Load the factory default setting. */
struct mip_filter_relative_position_config mip_filter_relative_position_config_default(void);

/**
 * Relative position configuration response: response (0x0D,0xD5).
 *
 * Also called `rel_pos_configuration_response`. Answers mip_filter_relative_position_config.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
 */
struct mip_filter_relative_position_config_response {
    /** Source of the reference point. */
    mip_filter_relative_position_source source;
    /** Frame of the coordinates. */
    mip_filter_reference_frame reference_frame_selector;
    /**
     * Reference point. Elements: x, y, z. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_ECEF: unit m; frame ecef. If reference_frame_selector is
     * MIP_FILTER_REFERENCE_FRAME_LLH: unit deg, deg, m; frame llh.
     */
    double reference_coordinates[3];
};

#define MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE_DESCRIPTOR 0xD5
#define MIP_FILTER_RELATIVE_POSITION_CONFIG_RESPONSE_NAME "filter.relative_position_config_response"

extern const struct mip_codec mip_filter_relative_position_config_response_codec;
mip_error mip_filter_relative_position_config_response_decode(
    struct mip_filter_relative_position_config_response *value, const struct mip_field *field);
mip_error mip_filter_relative_position_config_response_encode(
    const struct mip_filter_relative_position_config_response *value, struct mip_builder *builder);

/**
 * Reference point lever arm: command (0x0D,0x56).
 *
 * Moves the point to which the position and the velocity of the filter refer.
 *
 * Also called `ref_point_lever_arm`. Functions: write, read, save, load and default. Answered by
 * mip_filter_reference_point_lever_arm_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * It shifts mip_filter_data_llh_position, mip_filter_data_ned_velocity,
 * mip_filter_data_ecef_position, mip_filter_data_ecef_velocity and
 * mip_filter_data_ned_relative_position, depending on the attitude and, for velocities, on the
 * angular rate.
 *
 * - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
 */
struct mip_filter_reference_point_lever_arm {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Point to move; it must be 1. Required for write. */
    mip_filter_reference_point reference_point;
    /**
     * From the sensor to the point. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at
     * most 10. Required for write.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_DESCRIPTOR 0x56
#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_NAME "filter.reference_point_lever_arm"

extern const struct mip_codec mip_filter_reference_point_lever_arm_codec;
mip_error mip_filter_reference_point_lever_arm_decode(
    struct mip_filter_reference_point_lever_arm *value, const struct mip_field *field);
mip_error mip_filter_reference_point_lever_arm_encode(
    const struct mip_filter_reference_point_lever_arm *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_write(
    mip_filter_reference_point reference_point, const float lever_arm_offset[3]);
/** Send the current setting back in a response. */
struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_save(void);
/** Load the saved setting. */
struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_load(void);
/** Load the factory default setting. */
struct mip_filter_reference_point_lever_arm mip_filter_reference_point_lever_arm_default(void);

/**
 * Reference point lever arm response: response (0x0D,0xD6).
 *
 * Also called `ref_point_lever_arm_response`. Answers mip_filter_reference_point_lever_arm.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
 */
struct mip_filter_reference_point_lever_arm_response {
    /** Point to move; it must be 1. */
    mip_filter_reference_point reference_point;
    /**
     * From the sensor to the point. Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at
     * most 10.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE_DESCRIPTOR 0xD6
#define MIP_FILTER_REFERENCE_POINT_LEVER_ARM_RESPONSE_NAME \
    "filter.reference_point_lever_arm_response"

extern const struct mip_codec mip_filter_reference_point_lever_arm_response_codec;
mip_error mip_filter_reference_point_lever_arm_response_decode(
    struct mip_filter_reference_point_lever_arm_response *value, const struct mip_field *field);
mip_error mip_filter_reference_point_lever_arm_response_encode(
    const struct mip_filter_reference_point_lever_arm_response *value, struct mip_builder *builder);

/**
 * Speed measurement: command (0x0D,0x60).
 *
 * Gives the filter one measurement of the forward speed of the vehicle (along its x axis).
 *
 * No device profile lists it. Known from the MicroStrain MIP SDK only. Uncertain: The SDK names a
 * response, `filter.speed_measurement_response`, but has no layout of it.
 *
 * It must not be used together with the odometer of the device.
 *
 * Single precision resolves the time of week to 0.0625 s at the end of the week.
 *
 * - mip-sdk-4: Speed Measurement (0x0D,0x60)
 */
struct mip_filter_speed_measurement {
    /** Send 1. Reserved: send 1. */
    uint8_t source;
    /** GPS time of week of the measurement. Unit: s. Uncertain: The unit; the SDK prints none. */
    float tow;
    /** Speed, negative in reverse. Unit: m/s. Frame: vehicle. */
    float speed;
    /** Standard deviation of the speed. Unit: m/s. */
    float speed_uncertainty;
};

#define MIP_FILTER_SPEED_MEASUREMENT_DESCRIPTOR 0x60
#define MIP_FILTER_SPEED_MEASUREMENT_NAME "filter.speed_measurement"

extern const struct mip_codec mip_filter_speed_measurement_codec;
mip_error mip_filter_speed_measurement_decode(struct mip_filter_speed_measurement *value,
                                              const struct mip_field *field);
mip_error mip_filter_speed_measurement_encode(const struct mip_filter_speed_measurement *value,
                                              struct mip_builder *builder);
/** Speed measurement. */
struct mip_filter_speed_measurement mip_filter_speed_measurement_make(float tow, float speed,
                                                                      float speed_uncertainty);

/**
 * Speed measurement lever arm: command (0x0D,0x61).
 *
 * Position of the point whose speed is measured, such as the wheel that an odometer is on.
 *
 * Functions: write, read, save, load and default. Answered by mip_filter_speed_lever_arm_response.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * It corrects for the speed that such a point has only because the vehicle turns.
 *
 * - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
 */
struct mip_filter_speed_lever_arm {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Reserved: send 1. */
    uint8_t source;
    /**
     * From the sensor to the point of measurement. Elements: x, y, z. Unit: m. Frame: vehicle.
     * Required for write.
     */
    float lever_arm_offset[3];
};

#define MIP_FILTER_SPEED_LEVER_ARM_DESCRIPTOR 0x61
#define MIP_FILTER_SPEED_LEVER_ARM_NAME "filter.speed_lever_arm"

extern const struct mip_codec mip_filter_speed_lever_arm_codec;
mip_error mip_filter_speed_lever_arm_decode(struct mip_filter_speed_lever_arm *value,
                                            const struct mip_field *field);
mip_error mip_filter_speed_lever_arm_encode(const struct mip_filter_speed_lever_arm *value,
                                            struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_write(const float lever_arm_offset[3]);
/** Send the current setting back in a response. */
struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_save(void);
/** Load the saved setting. */
struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_load(void);
/** Load the factory default setting. */
struct mip_filter_speed_lever_arm mip_filter_speed_lever_arm_default(void);

/**
 * Speed measurement lever arm response: response (0x0D,0xE1).
 *
 * Answers mip_filter_speed_lever_arm. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
 */
struct mip_filter_speed_lever_arm_response {
    /** Reserved. */
    uint8_t source;
    /** From the sensor to the point of measurement. Elements: x, y, z. Unit: m. Frame: vehicle. */
    float lever_arm_offset[3];
};

#define MIP_FILTER_SPEED_LEVER_ARM_RESPONSE_DESCRIPTOR 0xE1
#define MIP_FILTER_SPEED_LEVER_ARM_RESPONSE_NAME "filter.speed_lever_arm_response"

extern const struct mip_codec mip_filter_speed_lever_arm_response_codec;
mip_error mip_filter_speed_lever_arm_response_decode(
    struct mip_filter_speed_lever_arm_response *value, const struct mip_field *field);
mip_error mip_filter_speed_lever_arm_response_encode(
    const struct mip_filter_speed_lever_arm_response *value, struct mip_builder *builder);

/**
 * Vertical gyro constraint: command (0x0D,0x62).
 *
 * Lets the filter hold pitch and roll by the accelerometers while there is no GNSS.
 *
 * In full: filter.vertical_gyro_constraint_control.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_vertical_gyro_constraint_response. No device profile lists it. Known from the
 * MicroStrain MIP SDK only.
 *
 * It takes the linear acceleration as zero.
 *
 * - mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
 */
struct mip_filter_vertical_gyro_constraint {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
};

#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_DESCRIPTOR 0x62
#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_NAME "filter.vertical_gyro_constraint_control"

extern const struct mip_codec mip_filter_vertical_gyro_constraint_codec;
mip_error mip_filter_vertical_gyro_constraint_decode(
    struct mip_filter_vertical_gyro_constraint *value, const struct mip_field *field);
mip_error mip_filter_vertical_gyro_constraint_encode(
    const struct mip_filter_vertical_gyro_constraint *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_vertical_gyro_constraint
mip_filter_vertical_gyro_constraint_write(uint8_t enable);
/** Send the current setting back in a response. */
struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_save(void);
/** Load the saved setting. */
struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_load(void);
/** Load the factory default setting. */
struct mip_filter_vertical_gyro_constraint mip_filter_vertical_gyro_constraint_default(void);

/**
 * Vertical gyro constraint response: response (0x0D,0xE2).
 *
 * In full: filter.vertical_gyro_constraint_control_response.
 *
 * Answers mip_filter_vertical_gyro_constraint. Known from the MicroStrain MIP SDK only.
 *
 * - mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
 */
struct mip_filter_vertical_gyro_constraint_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_RESPONSE_DESCRIPTOR 0xE2
#define MIP_FILTER_VERTICAL_GYRO_CONSTRAINT_RESPONSE_NAME \
    "filter.vertical_gyro_constraint_control_response"

extern const struct mip_codec mip_filter_vertical_gyro_constraint_response_codec;
mip_error mip_filter_vertical_gyro_constraint_response_decode(
    struct mip_filter_vertical_gyro_constraint_response *value, const struct mip_field *field);
mip_error mip_filter_vertical_gyro_constraint_response_encode(
    const struct mip_filter_vertical_gyro_constraint_response *value, struct mip_builder *builder);

/**
 * Wheeled vehicle constraint: command (0x0D,0x63).
 *
 * Lets the filter assume that the vehicle moves only along its x axis.
 *
 * In full: filter.wheeled_vehicle_constraint_control.
 *
 * Functions: write, read, save, load and default. Answered by
 * mip_filter_wheeled_vehicle_constraint_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * It improves the heading of cars and the like, above all when GNSS comes and goes. It is wrong for
 * vehicles that move sideways, such as aircraft.
 *
 * - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
 */
struct mip_filter_wheeled_vehicle_constraint {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
};

#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_DESCRIPTOR 0x63
#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_NAME "filter.wheeled_vehicle_constraint_control"

extern const struct mip_codec mip_filter_wheeled_vehicle_constraint_codec;
mip_error mip_filter_wheeled_vehicle_constraint_decode(
    struct mip_filter_wheeled_vehicle_constraint *value, const struct mip_field *field);
mip_error mip_filter_wheeled_vehicle_constraint_encode(
    const struct mip_filter_wheeled_vehicle_constraint *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_wheeled_vehicle_constraint
mip_filter_wheeled_vehicle_constraint_write(uint8_t enable);
/** Send the current setting back in a response. */
struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_save(void);
/** Load the saved setting. */
struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_load(void);
/** Load the factory default setting. */
struct mip_filter_wheeled_vehicle_constraint mip_filter_wheeled_vehicle_constraint_default(void);

/**
 * Wheeled vehicle constraint response: response (0x0D,0xE3).
 *
 * In full: filter.wheeled_vehicle_constraint_control_response.
 *
 * Answers mip_filter_wheeled_vehicle_constraint. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
 */
struct mip_filter_wheeled_vehicle_constraint_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
};

#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_RESPONSE_DESCRIPTOR 0xE3
#define MIP_FILTER_WHEELED_VEHICLE_CONSTRAINT_RESPONSE_NAME \
    "filter.wheeled_vehicle_constraint_control_response"

extern const struct mip_codec mip_filter_wheeled_vehicle_constraint_response_codec;
mip_error mip_filter_wheeled_vehicle_constraint_response_decode(
    struct mip_filter_wheeled_vehicle_constraint_response *value, const struct mip_field *field);
mip_error mip_filter_wheeled_vehicle_constraint_response_encode(
    const struct mip_filter_wheeled_vehicle_constraint_response *value,
    struct mip_builder *builder);

/**
 * GNSS antenna offset calibration: command (0x0D,0x64).
 *
 * Lets the filter track the error of the antenna offset.
 *
 * In full: filter.gnss_antenna_calibration_control.
 *
 * Also called `gnss_antenna_cal_control`. Functions: write, read, save, load and default. Answered
 * by mip_filter_gnss_antenna_calibration_response. Supported by 3DM-CV7-GNSS/INS and
 * 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
 * - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
 */
struct mip_filter_gnss_antenna_calibration {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** 0 disables, 1 enables. Range: 0 to 1. Required for write. */
    uint8_t enable;
    /**
     * Largest absolute error that is tracked; the limits are those of the 3DM-CV7. Unit: m. Frame:
     * vehicle. Range: 0 to 0.5. Default: 0.1. Required for write.
     */
    float max_offset;
};

#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_DESCRIPTOR 0x64
#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_NAME "filter.gnss_antenna_calibration_control"

extern const struct mip_codec mip_filter_gnss_antenna_calibration_codec;
mip_error mip_filter_gnss_antenna_calibration_decode(
    struct mip_filter_gnss_antenna_calibration *value, const struct mip_field *field);
mip_error mip_filter_gnss_antenna_calibration_encode(
    const struct mip_filter_gnss_antenna_calibration *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_filter_gnss_antenna_calibration
mip_filter_gnss_antenna_calibration_write(uint8_t enable, float max_offset);
/** Send the current setting back in a response. */
struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_save(void);
/** Load the saved setting. */
struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_load(void);
/** Load the factory default setting. */
struct mip_filter_gnss_antenna_calibration mip_filter_gnss_antenna_calibration_default(void);

/**
 * GNSS antenna offset calibration response: response (0x0D,0xE4).
 *
 * In full: filter.gnss_antenna_calibration_control_response.
 *
 * Also called `gnss_antenna_cal_control_response`. Answers mip_filter_gnss_antenna_calibration.
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
 * - 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
 */
struct mip_filter_gnss_antenna_calibration_response {
    /** 0 disables, 1 enables. Range: 0 to 1. */
    uint8_t enable;
    /**
     * Largest absolute error that is tracked; the limits are those of the 3DM-CV7. Unit: m. Frame:
     * vehicle. Range: 0 to 0.5. Default: 0.1.
     */
    float max_offset;
};

#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_RESPONSE_DESCRIPTOR 0xE4
#define MIP_FILTER_GNSS_ANTENNA_CALIBRATION_RESPONSE_NAME \
    "filter.gnss_antenna_calibration_control_response"

extern const struct mip_codec mip_filter_gnss_antenna_calibration_response_codec;
mip_error mip_filter_gnss_antenna_calibration_response_decode(
    struct mip_filter_gnss_antenna_calibration_response *value, const struct mip_field *field);
mip_error mip_filter_gnss_antenna_calibration_response_encode(
    const struct mip_filter_gnss_antenna_calibration_response *value, struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
