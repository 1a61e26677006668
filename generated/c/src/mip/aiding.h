/**
 * @file
 *
 * Aiding commands (0x13). Measurements of external sensors for the navigation filter, and the
 * frames of the sensors.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_AIDING_H
#define MIP_AIDING_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/aiding.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_aiding Aiding commands (0x13)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_AIDING_SET 0x13

/**
 * Format of the rotation of an aiding frame.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 */
enum mip_aiding_frame_format MIP_ENUM_8 {
    /** Euler angles: roll, pitch, yaw. */
    MIP_AIDING_FRAME_FORMAT_EULER = 1,
    /** Quaternion: w, x, y, z. */
    MIP_AIDING_FRAME_FORMAT_QUATERNION = 2
};

/**
 * Replies of the device to aiding measurements.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 */
enum mip_aiding_echo_mode MIP_ENUM_8 {
    /** No acknowledge. */
    MIP_AIDING_ECHO_MODE_SUPPRESS_ACK = 0,
    /** ACK, as for any command. */
    MIP_AIDING_ECHO_MODE_STANDARD = 1,
    /** The data is returned in a response. */
    MIP_AIDING_ECHO_MODE_RESPONSE = 2
};

/** Clock that the time of a measurement refers to. */
enum mip_aiding_timebase MIP_ENUM_8 {
    /** Internal reference clock of the device. */
    MIP_AIDING_TIMEBASE_INTERNAL_REFERENCE = 1,
    /** External clock, to which the PPS synchronizes the device. */
    MIP_AIDING_TIMEBASE_EXTERNAL_TIME = 2,
    /** Latency relative to the arrival of the command. */
    MIP_AIDING_TIMEBASE_TIME_OF_ARRIVAL = 3
};

/** Time at which a measurement was taken. */
struct mip_aiding_measurement_time {
    /** Clock that the time refers to. A value of enum mip_aiding_timebase. */
    uint8_t timebase;
    /** Reserved: send 1. */
    uint8_t reserved;
    /** Time by that clock. Unit: ns. */
    uint64_t nanoseconds;
};

/** Valid axes of a measurement; the others are ignored. */
typedef uint16_t mip_aiding_axis_flags;
/** Bit 0. First axis. */
#define MIP_AIDING_AXIS_FLAGS_X 0x0001U
/** Bit 1. Second axis. */
#define MIP_AIDING_AXIS_FLAGS_Y 0x0002U
/** Bit 2. Third axis. */
#define MIP_AIDING_AXIS_FLAGS_Z 0x0004U

/** Valid coordinates of a position; the others are ignored. */
typedef uint16_t mip_aiding_llh_axis_flags;
/** Bit 0. Latitude and its uncertainty are valid. */
#define MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE 0x0001U
/** Bit 1. Longitude and its uncertainty are valid. */
#define MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE 0x0002U
/** Bit 2. Height and its uncertainty are valid. */
#define MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT 0x0004U

/** The member of mip_aiding_frame_config that `format` selects. */
union mip_aiding_frame_config_rotation {
    /**
     * If format is MIP_AIDING_FRAME_FORMAT_EULER. Roll, pitch and yaw of the frame relative to the
     * vehicle; positive are right side down, nose up, and clockwise seen from above. Elements: x,
     * y, z. Unit: rad. Frame: vehicle. Range: -pi to pi.
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
 * Sets the position and the orientation of an external sensor on the vehicle.
 *
 * Functions: write, read, save, load and default. Response: mip_aiding_frame_config_response.
 * Affects mip_filter_data_aiding_frame_config_error. Probably affects
 * mip_filter_data_aiding_frame_config_error_uncertainty.
 *
 * Aiding measurements refer to the frame by its number.
 *
 * `p_vehicle = R * p_frame + t`, with the rotation R and the translation t.
 *
 * For GNSS positions and velocities the rotation does not matter. Send the identity: Euler angles
 * 0, 0, 0 or the quaternion 1, 0, 0, 0.
 *
 * In a read, `format` selects the format of the rotation in the reply.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 * - 3dm-cv7-gnss-ins: Aiding Frames
 */
struct mip_aiding_frame_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of the frame. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Format of the rotation. A value of enum mip_aiding_frame_format. Required for write and read.
     */
    uint8_t format;
    /** True if the filter estimates the errors of the frame. Required for write. */
    mip_bool tracking_enabled;
    /**
     * Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m. Frame:
     * vehicle. Required for write.
     */
    float translation[3];
    /**
     * Rotates vectors of this frame into the vehicle frame. Selected by format. Required for write.
     */
    union mip_aiding_frame_config_rotation rotation;
};

#define MIP_AIDING_FRAME_CONFIG 0x1301
#define MIP_AIDING_FRAME_CONFIG_DESCRIPTOR 0x01
MIP_FIELD(mip_aiding_frame_config, 0x01);

/**
 * Fills the structure for `write`, and returns it.
 *
 * A format without a name cannot be sent: the function stays 0, and sending fails with
 * MIP_ERROR_MISSING.
 */
static inline struct mip_aiding_frame_config *mip_aiding_frame_config_write(
    struct mip_aiding_frame_config *command, uint8_t frame_id, enum mip_aiding_frame_format format,
    mip_bool tracking_enabled, const float translation[3],
    const union mip_aiding_frame_config_rotation *rotation) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->frame_id = frame_id;
    command->format = (uint8_t)format;
    command->tracking_enabled = mip_truth(tracking_enabled);
    memcpy(command->translation, translation, sizeof(command->translation));
    if (rotation != NULL) {
        command->rotation = *rotation;
    }
    if (command->format != MIP_AIDING_FRAME_FORMAT_EULER &&
        command->format != MIP_AIDING_FRAME_FORMAT_QUATERNION) {
        command->function = 0;
    }
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_aiding_frame_config *
mip_aiding_frame_config_read(struct mip_aiding_frame_config *command, uint8_t frame_id,
                             enum mip_aiding_frame_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->frame_id = frame_id;
    command->format = (uint8_t)format;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_aiding_frame_config *
mip_aiding_frame_config_save(struct mip_aiding_frame_config *command, uint8_t frame_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->frame_id = frame_id;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_aiding_frame_config *
mip_aiding_frame_config_load(struct mip_aiding_frame_config *command, uint8_t frame_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->frame_id = frame_id;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_aiding_frame_config *
mip_aiding_frame_config_default(struct mip_aiding_frame_config *command, uint8_t frame_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->frame_id = frame_id;
    return command;
}

/**
 * Frame configuration response: response (0x13,0x81).
 *
 * Response to mip_aiding_frame_config.
 *
 * - 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
 * - 3dm-cv7-gnss-ins: Aiding Frames
 */
struct mip_aiding_frame_config_response {
    /** Number of the frame. Range: 1 to 4. */
    uint8_t frame_id;
    /** Format of the rotation. A value of enum mip_aiding_frame_format. */
    uint8_t format;
    /** True if the filter estimates the errors of the frame. */
    mip_bool tracking_enabled;
    /**
     * Position of the frame's origin in the vehicle frame. Elements: x, y, z. Unit: m. Frame:
     * vehicle.
     */
    float translation[3];
    /** Rotates vectors of this frame into the vehicle frame. Selected by format. */
    union mip_aiding_frame_config_rotation rotation;
};

#define MIP_AIDING_FRAME_CONFIG_RESPONSE 0x1381
#define MIP_AIDING_FRAME_CONFIG_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_aiding_frame_config_response, 0x81);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_aiding_frame_config *
mip_aiding_frame_config_write_from(struct mip_aiding_frame_config *command,
                                   const struct mip_aiding_frame_config_response *response) {
    return mip_aiding_frame_config_write(
        command, response->frame_id, (enum mip_aiding_frame_format)response->format,
        response->tracking_enabled, response->translation, &response->rotation);
}

/**
 * Sensor frame map: command (0x13,0x02).
 *
 * Sets the frame in which an aiding sensor measures.
 *
 * Also called `sensor_frame_mapping`. Functions: write, read, save, load and default. Response:
 * mip_aiding_sensor_frame_map_response. Known only from the MicroStrain MIP SDK, versions 1 to 3.
 * Uncertain: The layout is that of a branch of the SDK of 2024; later versions do not have it.
 * Uncertain: No source lists the devices that support it.
 *
 * - mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback
 */
struct mip_aiding_sensor_frame_map {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of the sensor. Range: at least 1. Required for write. */
    uint8_t sensor_id;
    /**
     * Frame of the sensor, defined by mip_aiding_frame_config. Range: 1 to 4. Default: 1. Required
     * for write.
     */
    uint8_t frame_id;
};

#define MIP_AIDING_SENSOR_FRAME_MAP 0x1302
#define MIP_AIDING_SENSOR_FRAME_MAP_DESCRIPTOR 0x02
MIP_FIELD(mip_aiding_sensor_frame_map, 0x02);
MIP_FILL(mip_aiding_sensor_frame_map, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_aiding_sensor_frame_map, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_aiding_sensor_frame_map, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_aiding_sensor_frame_map, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_aiding_sensor_frame_map *mip_aiding_sensor_frame_map_write(
    struct mip_aiding_sensor_frame_map *command, uint8_t sensor_id, uint8_t frame_id) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->sensor_id = sensor_id;
    command->frame_id = frame_id;
    return command;
}

/**
 * Sensor frame map response: response (0x13,0x82).
 *
 * Also called `sensor_frame_mapping_response`. Response to mip_aiding_sensor_frame_map. Known only
 * from the MicroStrain MIP SDK, versions 1 to 3.
 *
 * - mip-sdk-3: Sensor Frame Mapping (0x13,0x02), branch CmdCallback
 */
struct mip_aiding_sensor_frame_map_response {
    /** Number of the sensor. Range: at least 1. */
    uint8_t sensor_id;
    /** Frame of the sensor, defined by mip_aiding_frame_config. Range: 1 to 4. Default: 1. */
    uint8_t frame_id;
};

#define MIP_AIDING_SENSOR_FRAME_MAP_RESPONSE 0x1382
#define MIP_AIDING_SENSOR_FRAME_MAP_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_aiding_sensor_frame_map_response, 0x82);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_aiding_sensor_frame_map *mip_aiding_sensor_frame_map_write_from(
    struct mip_aiding_sensor_frame_map *command,
    const struct mip_aiding_sensor_frame_map_response *response) {
    return mip_aiding_sensor_frame_map_write(command, response->sensor_id, response->frame_id);
}

/**
 * Echo control: command (0x13,0x1F).
 *
 * Sets how the device replies to aiding measurements.
 *
 * Functions: write, read, save, load and default. Response: mip_aiding_echo_control_response.
 *
 * The manual does not contain the layout of the responses that carry the data back.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 * - 3dm-cv7-gnss-ins: Aiding Command Echo Control
 */
struct mip_aiding_echo_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Reply mode. A value of enum mip_aiding_echo_mode. Required for write. */
    uint8_t mode;
};

#define MIP_AIDING_ECHO_CONTROL 0x131F
#define MIP_AIDING_ECHO_CONTROL_DESCRIPTOR 0x1F
MIP_FIELD(mip_aiding_echo_control, 0x1F);
MIP_FILL(mip_aiding_echo_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_aiding_echo_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_aiding_echo_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_aiding_echo_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_aiding_echo_control *mip_aiding_echo_control_write(
    struct mip_aiding_echo_control *command, enum mip_aiding_echo_mode mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->mode = (uint8_t)mode;
    return command;
}

/**
 * Echo control response: response (0x13,0x9F).
 *
 * Response to mip_aiding_echo_control.
 *
 * - 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
 * - 3dm-cv7-gnss-ins: Aiding Command Echo Control
 */
struct mip_aiding_echo_control_response {
    /** Reply mode. A value of enum mip_aiding_echo_mode. */
    uint8_t mode;
};

#define MIP_AIDING_ECHO_CONTROL_RESPONSE 0x139F
#define MIP_AIDING_ECHO_CONTROL_RESPONSE_DESCRIPTOR 0x9F
MIP_FIELD(mip_aiding_echo_control_response, 0x9F);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_aiding_echo_control *
mip_aiding_echo_control_write_from(struct mip_aiding_echo_control *command,
                                   const struct mip_aiding_echo_control_response *response) {
    return mip_aiding_echo_control_write(command, (enum mip_aiding_echo_mode)response->mode);
}

/**
 * ECEF position: command (0x13,0x21).
 *
 * Sends a measured position in Earth-fixed coordinates.
 *
 * Also called `pos_ecef`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
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
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Position of the origin of the frame. Elements: x, y, z. Unit: m. Frame: ecef. Each element
     * has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y
     * in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    double position[3];
    /**
     * Uncertainty of the position. Elements: x, y, z. Unit: m. Frame: ecef. Range: greater than 0.
     * Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float uncertainty[3];
    /** Valid axes. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_ECEF_POSITION 0x1321
#define MIP_AIDING_ECEF_POSITION_DESCRIPTOR 0x21
MIP_FIELD(mip_aiding_ecef_position, 0x21);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_ecef_position *mip_aiding_ecef_position_make(
    struct mip_aiding_ecef_position *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, const double position[3], const float uncertainty[3],
    mip_aiding_axis_flags valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    memcpy(command->position, position, sizeof(command->position));
    memcpy(command->uncertainty, uncertainty, sizeof(command->uncertainty));
    command->valid_flags = valid_flags;
    return command;
}

/**
 * LLH position: command (0x13,0x22).
 *
 * Sends a measured position as latitude, longitude and height.
 *
 * Also called `pos_llh`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * Use only one form of position: ECEF or LLH.
 *
 * To send a height only, clear the valid flags of latitude and longitude. An uncertainty of 0 is no
 * substitute.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: LLH Position (0x13,0x22)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > LLH Position
 */
struct mip_aiding_llh_position {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
     * MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE in valid_flags is set.
     */
    double latitude;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
     * MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE in valid_flags is set.
     */
    double longitude;
    /**
     * Height above the ellipsoid. Unit: m. Frame: llh. Valid if MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT in
     * valid_flags is set.
     */
    double height;
    /**
     * Uncertainty of the position. Elements: north, east, down. Unit: m. Frame: ned. Range: greater
     * than 0. Each element has its own valid flag. north: MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE in
     * valid_flags, east: MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE in valid_flags, down:
     * MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT in valid_flags.
     */
    float uncertainty[3];
    /** Valid coordinates. */
    mip_aiding_llh_axis_flags valid_flags;
};

#define MIP_AIDING_LLH_POSITION 0x1322
#define MIP_AIDING_LLH_POSITION_DESCRIPTOR 0x22
MIP_FIELD(mip_aiding_llh_position, 0x22);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_llh_position *mip_aiding_llh_position_make(
    struct mip_aiding_llh_position *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, double latitude, double longitude, double height, const float uncertainty[3],
    mip_aiding_llh_axis_flags valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    command->latitude = latitude;
    command->longitude = longitude;
    command->height = height;
    memcpy(command->uncertainty, uncertainty, sizeof(command->uncertainty));
    command->valid_flags = valid_flags;
    return command;
}

/**
 * Height above ellipsoid: command (0x13,0x23).
 *
 * Sends a measured height above the ellipsoid.
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23)
 */
struct mip_aiding_height_above_ellipsoid {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /** Height above the ellipsoid. Unit: m. Frame: llh. */
    float height;
    /** Uncertainty of the height. Unit: m. Range: at least 0. */
    float uncertainty;
    /** Nonzero if the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID 0x1323
#define MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID_DESCRIPTOR 0x23
MIP_FIELD(mip_aiding_height_above_ellipsoid, 0x23);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_height_above_ellipsoid *mip_aiding_height_above_ellipsoid_make(
    struct mip_aiding_height_above_ellipsoid *command,
    const struct mip_aiding_measurement_time *time, uint8_t frame_id, float height,
    float uncertainty, uint16_t valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    command->height = height;
    command->uncertainty = uncertainty;
    command->valid_flags = valid_flags;
    return command;
}

/**
 * Pressure (old): command (0x13,0x25).
 *
 * Sends a static air pressure measured by an external sensor (superseded by mip_aiding_pressure).
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK. Known
 * only from the MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of a branch of
 * the SDK of 2024; later versions do not have it. Uncertain: No source lists the devices that
 * support it.
 *
 * - mip-sdk-3: Pressure (0x13,0x25), branch feature/UsbSerial
 */
struct mip_aiding_pressure_old {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /** Air pressure. Unit: mbar. */
    float pressure;
    /** Standard deviation of the pressure. Unit: mbar. Range: greater than 0. */
    float uncertainty;
    /** Nonzero if the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_PRESSURE_OLD 0x1325
#define MIP_AIDING_PRESSURE_OLD_DESCRIPTOR 0x25
MIP_FIELD(mip_aiding_pressure_old, 0x25);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_pressure_old *mip_aiding_pressure_old_make(
    struct mip_aiding_pressure_old *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, float pressure, float uncertainty, uint16_t valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    command->pressure = pressure;
    command->uncertainty = uncertainty;
    command->valid_flags = valid_flags;
    return command;
}

/**
 * ECEF velocity: command (0x13,0x28).
 *
 * Sends a measured velocity in Earth-fixed coordinates.
 *
 * Also called `vel_ecef`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * Use only one form of velocity: ECEF or NED.
 *
 * For a sensor that is fixed to the vehicle, use mip_aiding_body_frame_velocity.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Velocity
 */
struct mip_aiding_ecef_velocity {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: ecef. Each element
     * has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y
     * in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float velocity[3];
    /**
     * Uncertainty of the velocity. Elements: x, y, z. Unit: m/s. Frame: ecef. Range: greater than
     * 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float uncertainty[3];
    /** Valid axes. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_ECEF_VELOCITY 0x1328
#define MIP_AIDING_ECEF_VELOCITY_DESCRIPTOR 0x28
MIP_FIELD(mip_aiding_ecef_velocity, 0x28);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_ecef_velocity *mip_aiding_ecef_velocity_make(
    struct mip_aiding_ecef_velocity *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, const float velocity[3], const float uncertainty[3],
    mip_aiding_axis_flags valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    memcpy(command->velocity, velocity, sizeof(command->velocity));
    memcpy(command->uncertainty, uncertainty, sizeof(command->uncertainty));
    command->valid_flags = valid_flags;
    return command;
}

/**
 * NED velocity: command (0x13,0x29).
 *
 * Sends a measured velocity in the local level frame.
 *
 * Also called `vel_ned`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * Use only one form of velocity: ECEF or NED.
 *
 * For a sensor that is fixed to the vehicle, use mip_aiding_body_frame_velocity.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x13,0x29)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > NED Velocity
 */
struct mip_aiding_ned_velocity {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Velocity of the origin of the frame. Elements: north, east, down. Unit: m/s. Frame: ned. Each
     * element has its own valid flag. north: MIP_AIDING_AXIS_FLAGS_X in valid_flags, east:
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, down: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float velocity[3];
    /**
     * Uncertainty of the velocity. Elements: north, east, down. Unit: m/s. Frame: ned. Range:
     * greater than 0. Each element has its own valid flag. north: MIP_AIDING_AXIS_FLAGS_X in
     * valid_flags, east: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, down: MIP_AIDING_AXIS_FLAGS_Z in
     * valid_flags.
     */
    float uncertainty[3];
    /** Valid axes. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_NED_VELOCITY 0x1329
#define MIP_AIDING_NED_VELOCITY_DESCRIPTOR 0x29
MIP_FIELD(mip_aiding_ned_velocity, 0x29);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_ned_velocity *mip_aiding_ned_velocity_make(
    struct mip_aiding_ned_velocity *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, const float velocity[3], const float uncertainty[3],
    mip_aiding_axis_flags valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    memcpy(command->velocity, velocity, sizeof(command->velocity));
    memcpy(command->uncertainty, uncertainty, sizeof(command->uncertainty));
    command->valid_flags = valid_flags;
    return command;
}

/**
 * Body frame velocity: command (0x13,0x2A).
 *
 * Sends a measured velocity of the vehicle in the frame of the sensor.
 *
 * Also called `vel_body_frame`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * The device supports up to four sensors of this kind.
 *
 * For a wheeled vehicle constraint, send a velocity of 0 with only y valid, at least once per
 * second.
 *
 * With z also valid and 0, motion is constrained to a plane (2D mode).
 *
 * For a zero velocity update, send a velocity of 0 while the GNSS speed is below a threshold that
 * you choose.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > Body Frame Velocity
 * - 3dm-cv7-gnss-ins: Filter Kinematic Constraints
 */
struct mip_aiding_body_frame_velocity {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Velocity of the origin of the frame. Elements: x, y, z. Unit: m/s. Frame: aiding. Each
     * element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y:
     * MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float velocity[3];
    /**
     * Standard deviation of the velocity. Elements: x, y, z. Unit: m/s. Frame: aiding. Range:
     * greater than 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in
     * valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in
     * valid_flags.
     */
    float uncertainty[3];
    /** Valid axes. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_BODY_FRAME_VELOCITY 0x132A
#define MIP_AIDING_BODY_FRAME_VELOCITY_DESCRIPTOR 0x2A
MIP_FIELD(mip_aiding_body_frame_velocity, 0x2A);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_body_frame_velocity *mip_aiding_body_frame_velocity_make(
    struct mip_aiding_body_frame_velocity *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, const float velocity[3], const float uncertainty[3],
    mip_aiding_axis_flags valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    memcpy(command->velocity, velocity, sizeof(command->velocity));
    memcpy(command->uncertainty, uncertainty, sizeof(command->uncertainty));
    command->valid_flags = valid_flags;
    return command;
}

/**
 * True heading: command (0x13,0x31).
 *
 * Sends a measured heading relative to true north.
 *
 * Also called `heading_true`. Not acknowledged if mode of mip_aiding_echo_control is
 * MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: True Heading (0x13,0x31)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > True Heading
 */
struct mip_aiding_true_heading {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Heading relative to true north. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise
     * seen from above.
     */
    float heading;
    /** Uncertainty of the heading. Unit: rad. Range: greater than 0. */
    float uncertainty;
    /** Nonzero if the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_TRUE_HEADING 0x1331
#define MIP_AIDING_TRUE_HEADING_DESCRIPTOR 0x31
MIP_FIELD(mip_aiding_true_heading, 0x31);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_true_heading *mip_aiding_true_heading_make(
    struct mip_aiding_true_heading *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, float heading, float uncertainty, uint16_t valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    command->heading = heading;
    command->uncertainty = uncertainty;
    command->valid_flags = valid_flags;
    return command;
}

/**
 * Magnetic field: command (0x13,0x32).
 *
 * Sends a magnetic field measured by an external magnetometer.
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
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
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /**
     * Calibrated magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding. Each element has
     * its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y in
     * valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in valid_flags.
     */
    float magnetic_field[3];
    /**
     * Standard deviation of the magnetic field. Elements: x, y, z. Unit: gauss. Frame: aiding.
     * Range: greater than 0. Each element has its own valid flag. x: MIP_AIDING_AXIS_FLAGS_X in
     * valid_flags, y: MIP_AIDING_AXIS_FLAGS_Y in valid_flags, z: MIP_AIDING_AXIS_FLAGS_Z in
     * valid_flags.
     */
    float uncertainty[3];
    /** Valid axes. */
    mip_aiding_axis_flags valid_flags;
};

#define MIP_AIDING_MAGNETIC_FIELD 0x1332
#define MIP_AIDING_MAGNETIC_FIELD_DESCRIPTOR 0x32
MIP_FIELD(mip_aiding_magnetic_field, 0x32);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_magnetic_field *mip_aiding_magnetic_field_make(
    struct mip_aiding_magnetic_field *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, const float magnetic_field[3], const float uncertainty[3],
    mip_aiding_axis_flags valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    memcpy(command->magnetic_field, magnetic_field, sizeof(command->magnetic_field));
    memcpy(command->uncertainty, uncertainty, sizeof(command->uncertainty));
    command->valid_flags = valid_flags;
    return command;
}

/**
 * Pressure: command (0x13,0x33).
 *
 * Sends a static air pressure measured by an external sensor.
 *
 * Not acknowledged if mode of mip_aiding_echo_control is MIP_AIDING_ECHO_MODE_SUPPRESS_ACK.
 *
 * In mode `response` of mip_aiding_echo_control, the device sends the data back in a response of
 * unknown layout.
 *
 * - 3dm-cv7-gnss-ins: Pressure (0x13,0x33)
 * - 3dm-cv7-gnss-ins: Filter Aiding Measurements > External Pressure
 */
struct mip_aiding_pressure {
    /** Time of the measurement. */
    struct mip_aiding_measurement_time time;
    /** Sensor frame, defined by mip_aiding_frame_config. Range: 1 to 4. */
    uint8_t frame_id;
    /** Air pressure. Unit: mbar. */
    float pressure;
    /** Standard deviation of the pressure. Unit: mbar. Range: greater than 0. */
    float uncertainty;
    /** Nonzero if the measurement is valid. */
    uint16_t valid_flags;
};

#define MIP_AIDING_PRESSURE 0x1333
#define MIP_AIDING_PRESSURE_DESCRIPTOR 0x33
MIP_FIELD(mip_aiding_pressure, 0x33);

/** Fills the structure, and returns it. */
static inline struct mip_aiding_pressure *mip_aiding_pressure_make(
    struct mip_aiding_pressure *command, const struct mip_aiding_measurement_time *time,
    uint8_t frame_id, float pressure, float uncertainty, uint16_t valid_flags) {
    memset(command, 0, sizeof(*command));
    command->time = *time;
    command->time.reserved = 1;
    command->frame_id = frame_id;
    command->pressure = pressure;
    command->uncertainty = uncertainty;
    command->valid_flags = valid_flags;
    return command;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
