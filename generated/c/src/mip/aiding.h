/**
 * @file
 *
 * Aiding commands (0x13). Measurements of external sensors for the navigation filter, and the
 * frames of the sensors.
 */
#ifndef MIP_AIDING_H
#define MIP_AIDING_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/aiding.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_AIDING_SET 0x13

/**
 * How the rotation of an aiding frame is given.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 */
typedef uint8_t mip_aiding_frame_format;
/** Euler angles: roll, pitch, yaw. */
#define MIP_AIDING_FRAME_FORMAT_EULER 1
/** Quaternion: w, x, y, z. */
#define MIP_AIDING_FRAME_FORMAT_QUATERNION 2

/**
 * How the device answers aiding measurements.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 */
typedef uint8_t mip_aiding_echo_mode;
/** No acknowledge. */
#define MIP_AIDING_ECHO_MODE_SUPPRESS_ACK 0
/** Acknowledge as for any command. */
#define MIP_AIDING_ECHO_MODE_STANDARD 1
/** The data come back in a response. */
#define MIP_AIDING_ECHO_MODE_RESPONSE 2

/** Clock of the time of a measurement. */
typedef uint8_t mip_aiding_timebase;
/** Internal reference clock of the device. */
#define MIP_AIDING_TIMEBASE_INTERNAL_REFERENCE 1
/** External clock, with which the PPS synchronizes the device. */
#define MIP_AIDING_TIMEBASE_EXTERNAL_TIME 2
/** Latency relative to the arrival of the command. */
#define MIP_AIDING_TIMEBASE_TIME_OF_ARRIVAL 3

/** When a measurement was taken. */
struct mip_aiding_measurement_time {
    /** Clock of the time. */
    mip_aiding_timebase timebase;
    /** Reserved: send 1. */
    uint8_t reserved;
    /** Time by that clock. Unit: ns. */
    uint64_t nanoseconds;
};

void mip_aiding_measurement_time_read(struct mip_reader *r, struct mip_aiding_measurement_time *v);
void mip_aiding_measurement_time_write(struct mip_writer *w,
                                       const struct mip_aiding_measurement_time *v);

/** Which axes of a measurement are valid; the others are ignored. */
typedef uint16_t mip_aiding_axis_flags;
/** Bit 0. First axis. */
#define MIP_AIDING_AXIS_FLAGS_X 0x0001U
/** Bit 1. Second axis. */
#define MIP_AIDING_AXIS_FLAGS_Y 0x0002U
/** Bit 2. Third axis. */
#define MIP_AIDING_AXIS_FLAGS_Z 0x0004U

/** Which coordinates of a position are valid; the others are ignored. */
typedef uint16_t mip_aiding_llh_axis_flags;
/** Bit 0. Latitude and its uncertainty. */
#define MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE 0x0001U
/** Bit 1. Longitude and its uncertainty. */
#define MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE 0x0002U
/** Bit 2. Height and its uncertainty. */
#define MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT 0x0004U

/** The member of mip_aiding_frame_config that `format` selects. */
union mip_aiding_frame_config_rotation {
    /**
     * If format is MIP_AIDING_FRAME_FORMAT_EULER. Roll, pitch and yaw. Elements: x, y, z. Unit:
     * rad. Range: -3.141592653589793 to 3.141592653589793.
     */
    float euler[3];
    /**
     * If format is MIP_AIDING_FRAME_FORMAT_QUATERNION. Quaternion, scalar part first. Elements: w,
     * x, y, z. Unit: 1.
     */
    float quaternion[4];
};

/**
 * Frame configuration: command (0x13,0x01).
 *
 * Where and how an external sensor is mounted on the vehicle.
 *
 * Functions: write, read, save, load and default. Answered by mip_aiding_frame_config_response.
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * Aiding measurements name the frame by its number.
 *
 * `p_vehicle = R * p_frame + t`, with the rotation R and the translation t.
 *
 * The rotation does not matter for GNSS positions and velocities; set it to zero.
 *
 * A read names the format that the answer shall have.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 * - 3dm-cv7-gnss-ins: Aiding Frames
 */
struct mip_aiding_frame_config {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Number of the frame. Range: 1 to 4. */
    uint8_t frame_id;
    /** How the rotation is given. Required for write and read. */
    mip_aiding_frame_format format;
    /** Whether the filter estimates the errors of the frame. Required for write. */
    mip_bool tracking_enabled;
    /**
     * Origin of the frame in the vehicle. Elements: x, y, z. Unit: m. Frame: vehicle. Required for
     * write.
     */
    float translation[3];
    /** Rotation from the frame to the vehicle. Selected by format. Required for write. */
    union mip_aiding_frame_config_rotation rotation;
};

#define MIP_AIDING_FRAME_CONFIG_DESCRIPTOR 0x01
#define MIP_AIDING_FRAME_CONFIG_NAME "aiding.frame_config"

extern const struct mip_codec mip_aiding_frame_config_codec;
mip_error mip_aiding_frame_config_decode(struct mip_aiding_frame_config *value,
                                         const struct mip_field *field);
mip_error mip_aiding_frame_config_encode(const struct mip_aiding_frame_config *value,
                                         struct mip_builder *builder);
/** Apply the new setting. */
struct mip_aiding_frame_config mip_aiding_frame_config_write(
    uint8_t frame_id, mip_aiding_frame_format format, mip_bool tracking_enabled,
    const float translation[3], const union mip_aiding_frame_config_rotation *rotation);
/** Send the current setting back in a response. */
struct mip_aiding_frame_config mip_aiding_frame_config_read(uint8_t frame_id,
                                                            mip_aiding_frame_format format);
/** Save the current setting to non-volatile memory. */
struct mip_aiding_frame_config mip_aiding_frame_config_save(uint8_t frame_id);
/** Load the saved setting. */
struct mip_aiding_frame_config mip_aiding_frame_config_load(uint8_t frame_id);
/** Load the factory default setting. */
struct mip_aiding_frame_config mip_aiding_frame_config_default(uint8_t frame_id);

/** The member of mip_aiding_frame_config_response that `format` selects. */
union mip_aiding_frame_config_response_rotation {
    /**
     * If format is MIP_AIDING_FRAME_FORMAT_EULER. Roll, pitch and yaw. Elements: x, y, z. Unit:
     * rad. Range: -3.141592653589793 to 3.141592653589793.
     */
    float euler[3];
    /**
     * If format is MIP_AIDING_FRAME_FORMAT_QUATERNION. Quaternion, scalar part first. Elements: w,
     * x, y, z. Unit: 1.
     */
    float quaternion[4];
};

/**
 * Frame configuration response: response (0x13,0x81).
 *
 * Answers mip_aiding_frame_config. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 * - 3dm-cv7-gnss-ins: Aiding Frames
 */
struct mip_aiding_frame_config_response {
    /** Number of the frame. Range: 1 to 4. */
    uint8_t frame_id;
    /** How the rotation is given. */
    mip_aiding_frame_format format;
    /** Whether the filter estimates the errors of the frame. */
    mip_bool tracking_enabled;
    /** Origin of the frame in the vehicle. Elements: x, y, z. Unit: m. Frame: vehicle. */
    float translation[3];
    /** Rotation from the frame to the vehicle. Selected by format. */
    union mip_aiding_frame_config_response_rotation rotation;
};

#define MIP_AIDING_FRAME_CONFIG_RESPONSE_DESCRIPTOR 0x81
#define MIP_AIDING_FRAME_CONFIG_RESPONSE_NAME "aiding.frame_config_response"

extern const struct mip_codec mip_aiding_frame_config_response_codec;
mip_error mip_aiding_frame_config_response_decode(struct mip_aiding_frame_config_response *value,
                                                  const struct mip_field *field);
mip_error mip_aiding_frame_config_response_encode(
    const struct mip_aiding_frame_config_response *value, struct mip_builder *builder);

/**
 * Echo control: command (0x13,0x1F).
 *
 * How the device answers aiding measurements.
 *
 * Functions: write, read, save, load and default. Answered by mip_aiding_echo_control_response.
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * The manual does not give the layout of the responses that carry the data back.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 * - 3dm-cv7-gnss-ins: Aiding Command Echo Control
 */
struct mip_aiding_echo_control {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** How they are answered. Required for write. */
    mip_aiding_echo_mode mode;
};

#define MIP_AIDING_ECHO_CONTROL_DESCRIPTOR 0x1F
#define MIP_AIDING_ECHO_CONTROL_NAME "aiding.echo_control"

extern const struct mip_codec mip_aiding_echo_control_codec;
mip_error mip_aiding_echo_control_decode(struct mip_aiding_echo_control *value,
                                         const struct mip_field *field);
mip_error mip_aiding_echo_control_encode(const struct mip_aiding_echo_control *value,
                                         struct mip_builder *builder);
/** Apply the new setting. */
struct mip_aiding_echo_control mip_aiding_echo_control_write(mip_aiding_echo_mode mode);
/** Send the current setting back in a response. */
struct mip_aiding_echo_control mip_aiding_echo_control_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_aiding_echo_control mip_aiding_echo_control_save(void);
/** Load the saved setting. */
struct mip_aiding_echo_control mip_aiding_echo_control_load(void);
/** Load the factory default setting. */
struct mip_aiding_echo_control mip_aiding_echo_control_default(void);

/**
 * Echo control response: response (0x13,0x9F).
 *
 * Answers mip_aiding_echo_control. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 * - 3dm-cv7-gnss-ins: Aiding Command Echo Control
 */
struct mip_aiding_echo_control_response {
    /** How they are answered. */
    mip_aiding_echo_mode mode;
};

#define MIP_AIDING_ECHO_CONTROL_RESPONSE_DESCRIPTOR 0x9F
#define MIP_AIDING_ECHO_CONTROL_RESPONSE_NAME "aiding.echo_control_response"

extern const struct mip_codec mip_aiding_echo_control_response_codec;
mip_error mip_aiding_echo_control_response_decode(struct mip_aiding_echo_control_response *value,
                                                  const struct mip_field *field);
mip_error mip_aiding_echo_control_response_encode(
    const struct mip_aiding_echo_control_response *value, struct mip_builder *builder);

/**
 * ECEF position: command (0x13,0x21).
 *
 * A measured position in Earth-fixed coordinates.
 *
 * Also called `pos_ecef`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Supported by 3DM-CV7-GNSS/INS.
 *
 * Use only one form of position: ECEF or LLH.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: ECEF Position (0x13,0x21)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Position
 */
struct mip_aiding_ecef_position {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Position. Elements: x, y, z. Unit: m. Frame: ecef. Each element is valid by its bit: x by
     * MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by
     * MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    double position[3];
    /**
     * Uncertainty of the position. Elements: x, y, z. Unit: m. Frame: ecef. Range: greater than 0.
     * Each element is valid by its bit: x by MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float uncertainty[3];
    /** Which axes are valid. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_ECEF_POSITION_DESCRIPTOR 0x21
#define MIP_AIDING_ECEF_POSITION_NAME "aiding.ecef_position"

extern const struct mip_codec mip_aiding_ecef_position_codec;
mip_error mip_aiding_ecef_position_decode(struct mip_aiding_ecef_position *value,
                                          const struct mip_field *field);
mip_error mip_aiding_ecef_position_encode(const struct mip_aiding_ecef_position *value,
                                          struct mip_builder *builder);
/** ECEF position. */
struct mip_aiding_ecef_position mip_aiding_ecef_position_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const double position[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags);

/**
 * LLH position: command (0x13,0x22).
 *
 * A measured position as latitude, longitude and height.
 *
 * Also called `pos_llh`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Supported by 3DM-CV7-GNSS/INS.
 *
 * Use only one form of position: ECEF or LLH.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: LLH Position (0x13,0x22)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > LLH Position
 */
struct mip_aiding_llh_position {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Latitude. Unit: deg. Frame: llh. Valid if MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE in valid_flags
     * is set.
     */
    double latitude;
    /**
     * Longitude. Unit: deg. Frame: llh. Valid if MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE in valid_flags
     * is set.
     */
    double longitude;
    /**
     * Height above the ellipsoid. Unit: m. Frame: llh. Valid if MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT in
     * valid_flags is set.
     */
    double height;
    /**
     * Uncertainty along north, east and down. Elements: x, y, z. Unit: m. Frame: ned. Range:
     * greater than 0. Each element is valid by its bit: x by MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE in
     * valid_flags, y by MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE in valid_flags, z by
     * MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT in valid_flags.
     */
    float uncertainty[3];
    /** Which coordinates are valid. */
    mip_aiding_llh_axis_flags valid_flags;
};

#define MIP_AIDING_LLH_POSITION_DESCRIPTOR 0x22
#define MIP_AIDING_LLH_POSITION_NAME "aiding.llh_position"

extern const struct mip_codec mip_aiding_llh_position_codec;
mip_error mip_aiding_llh_position_decode(struct mip_aiding_llh_position *value,
                                         const struct mip_field *field);
mip_error mip_aiding_llh_position_encode(const struct mip_aiding_llh_position *value,
                                         struct mip_builder *builder);
/** LLH position. */
struct mip_aiding_llh_position
mip_aiding_llh_position_make(const struct mip_aiding_measurement_time *time, uint8_t frame_id,
                             double latitude, double longitude, double height,
                             const float uncertainty[3], mip_aiding_llh_axis_flags valid_flags);

/**
 * Height above ellipsoid: command (0x13,0x23).
 *
 * A measured height.
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23)
 */
struct mip_aiding_height_above_ellipsoid {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /** Height above the ellipsoid. Unit: m. Frame: llh. */
    float height;
    /** Uncertainty of the height. Unit: m. */
    float uncertainty;
    /** Not 0: the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID_DESCRIPTOR 0x23
#define MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID_NAME "aiding.height_above_ellipsoid"

extern const struct mip_codec mip_aiding_height_above_ellipsoid_codec;
mip_error mip_aiding_height_above_ellipsoid_decode(struct mip_aiding_height_above_ellipsoid *value,
                                                   const struct mip_field *field);
mip_error mip_aiding_height_above_ellipsoid_encode(
    const struct mip_aiding_height_above_ellipsoid *value, struct mip_builder *builder);
/** Height above ellipsoid. */
struct mip_aiding_height_above_ellipsoid mip_aiding_height_above_ellipsoid_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, float height,
    float uncertainty, uint16_t valid_flags);

/**
 * ECEF velocity: command (0x13,0x28).
 *
 * A measured velocity in Earth-fixed coordinates.
 *
 * Also called `vel_ecef`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Supported by 3DM-CV7-GNSS/INS.
 *
 * Use only one form of velocity: ECEF or NED.
 *
 * Not for a sensor that is fixed to the vehicle; that takes mip_aiding_body_frame_velocity.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Velocity
 */
struct mip_aiding_ecef_velocity {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Velocity. Elements: x, y, z. Unit: m/s. Frame: ecef. Each element is valid by its bit: x by
     * MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by
     * MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float velocity[3];
    /**
     * Uncertainty of the velocity. Elements: x, y, z. Unit: m/s. Frame: ecef. Range: greater than
     * 0. Each element is valid by its bit: x by MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float uncertainty[3];
    /** Which axes are valid. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_ECEF_VELOCITY_DESCRIPTOR 0x28
#define MIP_AIDING_ECEF_VELOCITY_NAME "aiding.ecef_velocity"

extern const struct mip_codec mip_aiding_ecef_velocity_codec;
mip_error mip_aiding_ecef_velocity_decode(struct mip_aiding_ecef_velocity *value,
                                          const struct mip_field *field);
mip_error mip_aiding_ecef_velocity_encode(const struct mip_aiding_ecef_velocity *value,
                                          struct mip_builder *builder);
/** ECEF velocity. */
struct mip_aiding_ecef_velocity mip_aiding_ecef_velocity_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float velocity[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags);

/**
 * NED velocity: command (0x13,0x29).
 *
 * A measured velocity in the local level frame.
 *
 * Also called `vel_ned`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Supported by 3DM-CV7-GNSS/INS.
 *
 * Use only one form of velocity: ECEF or NED.
 *
 * Not for a sensor that is fixed to the vehicle; that takes mip_aiding_body_frame_velocity.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x13,0x29)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > NED Velocity
 */
struct mip_aiding_ned_velocity {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Velocity. Elements: x, y, z. Unit: m/s. Frame: ned. Each element is valid by its bit: x by
     * MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by
     * MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float velocity[3];
    /**
     * Uncertainty of the velocity. Elements: x, y, z. Unit: m/s. Frame: ned. Range: greater than 0.
     * Each element is valid by its bit: x by MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float uncertainty[3];
    /** Which axes are valid. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_NED_VELOCITY_DESCRIPTOR 0x29
#define MIP_AIDING_NED_VELOCITY_NAME "aiding.ned_velocity"

extern const struct mip_codec mip_aiding_ned_velocity_codec;
mip_error mip_aiding_ned_velocity_decode(struct mip_aiding_ned_velocity *value,
                                         const struct mip_field *field);
mip_error mip_aiding_ned_velocity_encode(const struct mip_aiding_ned_velocity *value,
                                         struct mip_builder *builder);
/** NED velocity. */
struct mip_aiding_ned_velocity mip_aiding_ned_velocity_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float velocity[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags);

/**
 * Body frame velocity: command (0x13,0x2A).
 *
 * A measured velocity of the vehicle in the frame of the sensor.
 *
 * Also called `vel_body_frame`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Supported by 3DM-CV7-GNSS/INS.
 *
 * The device takes up to four sensors of this kind.
 *
 * A wheeled vehicle constraint is a velocity of 0 with y valid only, sent at least once in a
 * second.
 *
 * With z valid too, and 0, the vehicle moves in a plane only (2D mode).
 *
 * A zero velocity update is a velocity of 0, sent while the GNSS speed is below a threshold of the
 * user.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > Body Frame Velocity
 * - 3dm-cv7-gnss-ins: Filter Kinematic Constraints
 */
struct mip_aiding_body_frame_velocity {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Velocity. Elements: x, y, z. Unit: m/s. Frame: aiding. Each element is valid by its bit: x by
     * MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by
     * MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float velocity[3];
    /**
     * Standard deviation of the velocity. Elements: x, y, z. Unit: m/s. Frame: aiding. Range:
     * greater than 0. Each element is valid by its bit: x by MIP_AIDING_AXIS_FLAGS_X in
     * valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by MIP_AIDING_AXIS_FLAGS_Z in
     * valid_flags.
     */
    float uncertainty[3];
    /** Which axes are valid. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_BODY_FRAME_VELOCITY_DESCRIPTOR 0x2A
#define MIP_AIDING_BODY_FRAME_VELOCITY_NAME "aiding.body_frame_velocity"

extern const struct mip_codec mip_aiding_body_frame_velocity_codec;
mip_error mip_aiding_body_frame_velocity_decode(struct mip_aiding_body_frame_velocity *value,
                                                const struct mip_field *field);
mip_error mip_aiding_body_frame_velocity_encode(const struct mip_aiding_body_frame_velocity *value,
                                                struct mip_builder *builder);
/** Body frame velocity. */
struct mip_aiding_body_frame_velocity mip_aiding_body_frame_velocity_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float velocity[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags);

/**
 * True heading: command (0x13,0x31).
 *
 * A measured heading relative to true north.
 *
 * Also called `heading_true`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: True Heading (0x13,0x31)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > True Heading
 */
struct mip_aiding_true_heading {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /** Heading. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. */
    float heading;
    /** Uncertainty of the heading. Unit: rad. Range: greater than 0. */
    float uncertainty;
    /** Not 0: the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_TRUE_HEADING_DESCRIPTOR 0x31
#define MIP_AIDING_TRUE_HEADING_NAME "aiding.true_heading"

extern const struct mip_codec mip_aiding_true_heading_codec;
mip_error mip_aiding_true_heading_decode(struct mip_aiding_true_heading *value,
                                         const struct mip_field *field);
mip_error mip_aiding_true_heading_encode(const struct mip_aiding_true_heading *value,
                                         struct mip_builder *builder);
/** True heading. */
struct mip_aiding_true_heading
mip_aiding_true_heading_make(const struct mip_aiding_measurement_time *time, uint8_t frame_id,
                             float heading, float uncertainty, uint16_t valid_flags);

/**
 * Magnetic field: command (0x13,0x32).
 *
 * A magnetic field measured by an external magnetometer.
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * The magnetometer must be calibrated.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Magnetic Field (0x13,0x32)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Magnetometer
 */
struct mip_aiding_magnetic_field {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding. Each element is valid by its
     * bit: x by MIP_AIDING_AXIS_FLAGS_X in valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in
     * valid_flags, z by MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float magnetic_field[3];
    /**
     * Standard deviation of the magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding.
     * Range: greater than 0. Each element is valid by its bit: x by MIP_AIDING_AXIS_FLAGS_X in
     * valid_flags, y by MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z by MIP_AIDING_AXIS_FLAGS_Z in
     * valid_flags.
     */
    float uncertainty[3];
    /** Which axes are valid. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_MAGNETIC_FIELD_DESCRIPTOR 0x32
#define MIP_AIDING_MAGNETIC_FIELD_NAME "aiding.magnetic_field"

extern const struct mip_codec mip_aiding_magnetic_field_codec;
mip_error mip_aiding_magnetic_field_decode(struct mip_aiding_magnetic_field *value,
                                           const struct mip_field *field);
mip_error mip_aiding_magnetic_field_encode(const struct mip_aiding_magnetic_field *value,
                                           struct mip_builder *builder);
/** Magnetic field. */
struct mip_aiding_magnetic_field mip_aiding_magnetic_field_make(
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, const float magnetic_field[3],
    const float uncertainty[3], mip_aiding_axis_flags valid_flags);

/**
 * Pressure: command (0x13,0x33).
 *
 * A static air pressure measured by an external sensor.
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Pressure (0x13,0x33)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Pressure
 */
struct mip_aiding_pressure {
    /** When the measurement was taken. */
    struct mip_aiding_measurement_time time;
    /** Frame of the sensor, as mip_aiding_frame_config defines it. Range: 1 to 4. */
    uint8_t frame_id;
    /** Air pressure. Unit: mbar. */
    float pressure;
    /** Standard deviation of the pressure. Unit: mbar. Range: greater than 0. */
    float uncertainty;
    /** Not 0: the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_PRESSURE_DESCRIPTOR 0x33
#define MIP_AIDING_PRESSURE_NAME "aiding.pressure"

extern const struct mip_codec mip_aiding_pressure_codec;
mip_error mip_aiding_pressure_decode(struct mip_aiding_pressure *value,
                                     const struct mip_field *field);
mip_error mip_aiding_pressure_encode(const struct mip_aiding_pressure *value,
                                     struct mip_builder *builder);
/** Pressure. */
struct mip_aiding_pressure mip_aiding_pressure_make(const struct mip_aiding_measurement_time *time,
                                                    uint8_t frame_id, float pressure,
                                                    float uncertainty, uint16_t valid_flags);

#ifdef __cplusplus
}
#endif

#endif
