/**
 * @file
 *
 * 3DM (0x0C). Commands that set up the sensors, the outputs, the pins and the events of a device.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_3DM_H
#define MIP_3DM_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/3dm.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_3dm 3DM (0x0C)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_3DM_SET 0x0C

/**
 * A field requested by a poll.
 *
 * - 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
 */
struct mip_3dm_poll_entry {
    /** Field descriptor. */
    uint8_t descriptor;
    /** Reserved; occupies the position of a decimation. Reserved: send 0. */
    uint16_t reserved;
};

/**
 * Treatment of the existing message formats.
 *
 * - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
 */
enum mip_3dm_factory_streaming_action MIP_ENUM_8 {
    /** The formats are replaced. */
    MIP_3DM_FACTORY_STREAMING_ACTION_OVERWRITE = 0,
    /** The support fields are merged into the formats; the order may change. */
    MIP_3DM_FACTORY_STREAMING_ACTION_MERGE = 1,
    /** The support fields are appended to the formats; fields may occur twice. */
    MIP_3DM_FACTORY_STREAMING_ACTION_ADD = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_factory_streaming_action_name(uint8_t value);

/**
 * Constellation in receiver settings. The values differ from those of enum mip_gnss_constellation,
 * which GNSS data uses.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 */
enum mip_3dm_constellation_id MIP_ENUM_8 {
    /** GPS, satellites G1 to G32. */
    MIP_3DM_CONSTELLATION_ID_GPS = 0,
    /** SBAS, satellites S120 to S158. */
    MIP_3DM_CONSTELLATION_ID_SBAS = 1,
    /** Galileo, satellites E1 to E36. */
    MIP_3DM_CONSTELLATION_ID_GALILEO = 2,
    /** BeiDou, satellites B1 to B37. */
    MIP_3DM_CONSTELLATION_ID_BEIDOU = 3,
    /** QZSS, satellites Q1 to Q5. */
    MIP_3DM_CONSTELLATION_ID_QZSS = 5,
    /** GLONASS, satellites R1 to R32. */
    MIP_3DM_CONSTELLATION_ID_GLONASS = 6
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_constellation_id_name(uint8_t value);

/**
 * Options of a constellation.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 */
typedef uint16_t mip_3dm_constellation_options;
/** Bit 0. The L1-SAIF signal; QZSS only. */
#define MIP_3DM_CONSTELLATION_OPTIONS_L1SAIF 0x0001U

/**
 * Settings for the tracking of one constellation.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 */
struct mip_3dm_constellation_settings_entry {
    /** Constellation that this entry configures. A value of enum mip_3dm_constellation_id. */
    uint8_t constellation_id;
    /** 1 enables the constellation, 0 disables it. Range: 0 to 1. */
    uint8_t enable;
    /** Number of channels reserved for the constellation. Unit: 1. Range: 0 to 32. */
    uint8_t reserved_channels;
    /** Maximum number of channels for the constellation. Unit: 1. Range: 0 to 32. */
    uint8_t max_channels;
    /** Options of this constellation. */
    mip_3dm_constellation_options option_flags;
};

/**
 * Purposes for which SBAS is used.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
typedef uint16_t mip_3dm_sbas_options;
/** Bit 0. SBAS pseudoranges are used in the position solution. */
#define MIP_3DM_SBAS_OPTIONS_ENABLE_RANGING 0x0001U
/** Bit 1. SBAS differential corrections are applied. */
#define MIP_3DM_SBAS_OPTIONS_ENABLE_CORRECTIONS 0x0002U
/** Bit 2. Only GPS satellites with SBAS integrity information are used. */
#define MIP_3DM_SBAS_OPTIONS_APPLY_INTEGRITY 0x0004U

/**
 * Use of a receiver's last fix at power-up.
 *
 * - mip-sdk-4: Gnss Assisted Fix (0x0C,0x23)
 */
enum mip_3dm_assisted_fix_option MIP_ENUM_8 {
    /** The receiver ignores its last fix. */
    MIP_3DM_ASSISTED_FIX_OPTION_NONE = 0,
    /** The receiver starts from its last fix. */
    MIP_3DM_ASSISTED_FIX_OPTION_ENABLED = 1
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_assisted_fix_option_name(uint8_t value);

/**
 * Source of the pulse per second.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 * - 3dm-cv7-gnss-ins: RECEIVER Source
 */
enum mip_3dm_pps_source MIP_ENUM_8 {
    /** No pulse. */
    MIP_3DM_PPS_SOURCE_DISABLED = 0,
    /**
     * From GNSS receiver 1. The external time is GPS time, and valid only while the receiver has a
     * fix.
     */
    MIP_3DM_PPS_SOURCE_RECEIVER_1 = 1,
    /**
     * From GNSS receiver 2. The external time is GPS time, and valid only while the receiver has a
     * fix.
     */
    MIP_3DM_PPS_SOURCE_RECEIVER_2 = 2,
    /** From a GPIO pin that is configured as a PPS input. */
    MIP_3DM_PPS_SOURCE_GPIO = 3,
    /** From the oscillator of the device. */
    MIP_3DM_PPS_SOURCE_GENERATED = 4
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_pps_source_name(uint8_t value);

/**
 * The part of the event system that is queried.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
enum mip_3dm_event_support_query MIP_ENUM_8 {
    /** Supported types of triggers. */
    MIP_3DM_EVENT_SUPPORT_QUERY_TRIGGER_TYPES = 1,
    /** Supported types of actions. */
    MIP_3DM_EVENT_SUPPORT_QUERY_ACTION_TYPES = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_event_support_query_name(uint8_t value);

/**
 * Capacity of a device for one trigger or action type.
 *
 * - 3dm-cv7-gnss-ins: Info
 */
struct mip_3dm_event_support_info {
    /** Trigger type or action type. */
    uint8_t type;
    /** Maximum number of instances of this type. Unit: 1. */
    uint8_t count;
};

/**
 * Type and state of one trigger.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
struct mip_3dm_event_trigger_status_entry {
    /** Configured type. A value of enum mip_event_trigger_type. */
    uint8_t type;
    /** State. */
    mip_event_trigger_status status;
};

/**
 * Type and trigger of one action.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
struct mip_3dm_event_action_status_entry {
    /** Configured type. A value of enum mip_event_action_type. */
    uint8_t action_type;
    /** Trigger instance that the action follows. */
    uint8_t trigger_id;
};

/**
 * Motion that a GNSS receiver assumes. Uncertain: The value `fixed`. The SDK of 2014 numbers the
 * modes 0 to 8, but the list in its comments lacks this one, as u-blox receivers do. Uncertain: The
 * descriptions. The sources list only names, from which the descriptions of the modes are inferred.
 *
 * - mip-sdk-2014: GPS Dynamics Mode (0x0C,0x34)
 */
enum mip_3dm_receiver_dynamics MIP_ENUM_8 {
    /** Low accelerations; fits most applications. */
    MIP_3DM_RECEIVER_DYNAMICS_PORTABLE = 0,
    /** Fixed installation. */
    MIP_3DM_RECEIVER_DYNAMICS_FIXED = 1,
    /** At rest. */
    MIP_3DM_RECEIVER_DYNAMICS_STATIONARY = 2,
    /** Walking speed. */
    MIP_3DM_RECEIVER_DYNAMICS_PEDESTRIAN = 3,
    /** Road vehicles. */
    MIP_3DM_RECEIVER_DYNAMICS_AUTOMOTIVE = 4,
    /** Vessels at sea level. */
    MIP_3DM_RECEIVER_DYNAMICS_SEA = 5,
    /** Aircraft with accelerations below 1 g. */
    MIP_3DM_RECEIVER_DYNAMICS_AIRBORNE_1G = 6,
    /** Aircraft with accelerations below 2 g. */
    MIP_3DM_RECEIVER_DYNAMICS_AIRBORNE_2G = 7,
    /** Aircraft with accelerations below 4 g. */
    MIP_3DM_RECEIVER_DYNAMICS_AIRBORNE_4G = 8
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_receiver_dynamics_name(uint8_t value);

/**
 * Processing steps of 3-series devices. Uncertain: Bits 4, 5, 9 and 12 are from the single-byte
 * protocol of the 3DM-GX3. MSCL has the quaternion as 0x10000, which exceeds 16 bits. Uncertain:
 * The descriptions. The sources list only names, from which the descriptions of the bits are
 * inferred.
 *
 * - mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35)
 * - mscl: IMU Signal Conditioning (0x0C,0x35)
 */
typedef uint16_t mip_3dm_data_conditioning_flags;
/** Bit 0. Computes the orientation. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_ORIENTATION_CALCULATION 0x0001U
/** Bit 1. Corrects coning and sculling. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_CONING_SCULLING 0x0002U
/** Bit 4. Sends floats with the least significant byte first. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_LITTLE_ENDIAN_FLOATS 0x0010U
/** Bit 5. Suppresses values that are NaN (not a number). */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_NAN_SUPPRESSED 0x0020U
/** Bit 6. Compensates for the distance between the accelerometers. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_FINITE_SIZE_CORRECTION 0x0040U
/** Bit 8. Switches the magnetometer off. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_DISABLE_MAG 0x0100U
/** Bit 9. Reduces the power of the magnetometer. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_MAG_LOW_POWER 0x0200U
/** Bit 10. Disables the heading correction. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_DISABLE_NORTH_COMPENSATION 0x0400U
/** Bit 11. Disables the pitch and roll correction. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_DISABLE_UP_COMPENSATION 0x0800U
/** Bit 12. Computes the quaternion. */
#define MIP_3DM_DATA_CONDITIONING_FLAGS_QUATERNION_CALCULATION 0x1000U

/**
 * Bandwidth of the magnetometer of 3-series devices.
 *
 * - mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35)
 */
enum mip_3dm_mag_bandwidth MIP_ENUM_8 {
    /** High bandwidth. */
    MIP_3DM_MAG_BANDWIDTH_HIGH = 0,
    /** Low bandwidth. */
    MIP_3DM_MAG_BANDWIDTH_LOW = 1
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_mag_bandwidth_name(uint8_t value);

/**
 * A time counter of the sensor data.
 *
 * - mip-sdk-2014: IMU Timestamp (0x0C,0x36)
 */
enum mip_3dm_imu_timestamp_selector MIP_ENUM_8 {
    /** Seconds of the time beacon. */
    MIP_3DM_IMU_TIMESTAMP_SELECTOR_BEACON_SECONDS = 1,
    /** Nanoseconds of the time beacon. */
    MIP_3DM_IMU_TIMESTAMP_SELECTOR_BEACON_NANOSECONDS = 2,
    /**
     * Ticks of the internal clock. Uncertain: The value. The source states 2 for this one and for
     * the nanoseconds.
     */
    MIP_3DM_IMU_TIMESTAMP_SELECTOR_INTERNAL_TICKS = 3
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_imu_timestamp_selector_name(uint8_t value);

/**
 * Operating mode of the odometer input.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
enum mip_3dm_odometer_mode MIP_ENUM_8 {
    /** Not used. */
    MIP_3DM_ODOMETER_MODE_DISABLED = 0,
    /** Quadrature encoder on two pins. */
    MIP_3DM_ODOMETER_MODE_QUADRATURE = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_odometer_mode_name(uint8_t value);

/**
 * A sensor whose range can be set.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
enum mip_3dm_sensor_range_type MIP_ENUM_8 {
    /** All sensors; for save, load and default only. */
    MIP_3DM_SENSOR_RANGE_TYPE_ALL = 0,
    /** The value `accel`. */
    MIP_3DM_SENSOR_RANGE_TYPE_ACCEL = 1,
    /** The value `gyro`. */
    MIP_3DM_SENSOR_RANGE_TYPE_GYRO = 2,
    /** The value `mag`. */
    MIP_3DM_SENSOR_RANGE_TYPE_MAG = 3,
    /** The value `pressure`. */
    MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE = 4
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_sensor_range_type_name(uint8_t value);

/**
 * A range that a sensor supports.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
struct mip_3dm_sensor_range_entry {
    /** Value for mip_3dm_sensor_range. */
    uint8_t setting;
    /** Largest measurable value. */
    float range;
};

/**
 * A sensor inside a 3-series device.
 *
 * - mip-sdk-2014: Device Power State (0x0C,0x61)
 */
enum mip_3dm_internal_sensor MIP_ENUM_8 {
    /** The inertial sensor. */
    MIP_3DM_INTERNAL_SENSOR_IMU = 1,
    /** The GNSS receiver. */
    MIP_3DM_INTERNAL_SENSOR_GNSS = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_internal_sensor_name(uint8_t value);

/**
 * Format of a data stream.
 *
 * - mip-sdk-2014: Data Stream Format (0x0C,0x60)
 */
enum mip_3dm_stream_format MIP_ENUM_8 {
    /** MIP data fields. */
    MIP_3DM_STREAM_FORMAT_STANDARD = 1,
    /** The sensor's own packets, each in a MIP field. */
    MIP_3DM_STREAM_FORMAT_WRAPPED_RAW = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_stream_format_name(uint8_t value);

/**
 * Power state of an internal sensor.
 *
 * - mip-sdk-2014: Device Power State (0x0C,0x61)
 */
enum mip_3dm_sensor_power_state MIP_ENUM_8 {
    /** Full power. */
    MIP_3DM_SENSOR_POWER_STATE_ON = 1,
    /** On with reduced power. */
    MIP_3DM_SENSOR_POWER_STATE_LOW_POWER = 2,
    /** Very low power; starts quickly. */
    MIP_3DM_SENSOR_POWER_STATE_SLEEP = 3,
    /** Off or in deep sleep. */
    MIP_3DM_SENSOR_POWER_STATE_OFF = 4
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_sensor_power_state_name(uint8_t value);

/**
 * Level of detail of a device status.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 */
enum mip_3dm_device_status_selector MIP_ENUM_8 {
    /** State and timer. */
    MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC = 1,
    /** State, timer, and the counters of streams and port. */
    MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_device_status_selector_name(uint8_t value);

/**
 * A data stream of a device of the generations 3 to 5.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 */
enum mip_3dm_legacy_data_stream MIP_ENUM_8 {
    /** All streams; for save, load and default only. */
    MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS = 0,
    /** Sensor data (0x80). */
    MIP_3DM_LEGACY_DATA_STREAM_IMU = 1,
    /** GNSS data. */
    MIP_3DM_LEGACY_DATA_STREAM_GNSS = 2,
    /** Estimation filter data (0x82). */
    MIP_3DM_LEGACY_DATA_STREAM_FILTER = 3
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_legacy_data_stream_name(uint8_t value);

/**
 * State of the system in the device status of the 3DM-GX4-45 and the 3DM-RQ1-45.
 *
 * - mip-sdk-2014: Device Status (0x0C,0x64)
 */
enum mip_3dm_gx4_system_state MIP_ENUM_16 {
    /** The system is starting. */
    MIP_3DM_GX4_SYSTEM_STATE_INIT = 1,
    /** The sensors are starting. */
    MIP_3DM_GX4_SYSTEM_STATE_SENSOR_STARTUP = 2,
    /** The system is running. */
    MIP_3DM_GX4_SYSTEM_STATE_RUNNING = 3
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_3dm_gx4_system_state_name(uint16_t value);

/**
 * Poll IMU Data: command (0x0C,0x01).
 *
 * Requests one sensor data packet (0x80) with the listed fields, in the listed order.
 *
 * Also called `poll_imu_message`. Not acknowledged if suppress_ack is true. Supported by
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * An empty list polls the fields that mip_3dm_imu_message_format stores; if nothing is stored, the
 * device rejects the command.
 *
 * Descriptors that the device does not know are ignored.
 *
 * The data is sent in a separate packet after the reply.
 *
 * - 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
 */
struct mip_3dm_poll_imu_data {
    /** Send no acknowledge. */
    mip_bool suppress_ack;
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields to send. Refers to fields of MIP_SENSOR_SET. */
    struct mip_3dm_poll_entry descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_POLL_IMU_DATA 0x0C01
/** Its descriptor. */
#define MIP_3DM_POLL_IMU_DATA_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_3DM_POLL_IMU_DATA_NAME "3dm.poll_imu_data"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_poll_imu_data_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_poll_imu_data_decode(struct mip_3dm_poll_imu_data *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_poll_imu_data_codec, 0x01, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_poll_imu_data_encode(
    const struct mip_3dm_poll_imu_data *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_poll_imu_data_codec, value, builder);
}

/**
 * Poll IMU Data. Fills the structure and returns its address.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors.
 * - descriptors: Fields to send. Refers to fields of MIP_SENSOR_SET.
 */
static inline struct mip_3dm_poll_imu_data *
mip_3dm_poll_imu_data_make(struct mip_3dm_poll_imu_data *command, mip_bool suppress_ack,
                           uint8_t num_descriptors, const struct mip_3dm_poll_entry descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->suppress_ack = mip_truth(suppress_ack);
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/**
 * Poll GNSS Data: command (0x0C,0x02).
 *
 * Requests one GNSS data packet with the listed fields, in the listed order.
 *
 * Also called `poll_gnss_message`. Not acknowledged if suppress_ack is true. Supported by
 * 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Known only from the MicroStrain MIP SDK.
 *
 * An empty list polls the format stored by mip_3dm_gnss_message_format; if none is stored, the
 * device rejects the command.
 *
 * Descriptors that the device does not know are omitted.
 *
 * The data is sent in a separate packet after the reply.
 *
 * - mip-sdk-4: Poll Gnss Message (0x0C,0x02)
 */
struct mip_3dm_poll_gnss_data {
    /** Send no acknowledge. */
    mip_bool suppress_ack;
    /** Number of fields. Counts the elements of descriptors. Range: 0 to 83. */
    uint8_t num_descriptors;
    /**
     * Fields to send. Refers to fields of MIP_GNSS_DATA_SET. Uncertain: The SDK has a decimation in
     * place of the reserved number and does not document how a poll uses it.
     */
    struct mip_3dm_poll_entry descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_POLL_GNSS_DATA 0x0C02
/** Its descriptor. */
#define MIP_3DM_POLL_GNSS_DATA_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_3DM_POLL_GNSS_DATA_NAME "3dm.poll_gnss_data"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_poll_gnss_data_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_poll_gnss_data_decode(struct mip_3dm_poll_gnss_data *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_poll_gnss_data_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_poll_gnss_data_encode(
    const struct mip_3dm_poll_gnss_data *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_poll_gnss_data_codec, value, builder);
}

/**
 * Poll GNSS Data. Fills the structure and returns its address.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Range: 0 to 83.
 * - descriptors: Fields to send. Refers to fields of MIP_GNSS_DATA_SET. Uncertain: The SDK has a
 *   decimation in place of the reserved number and does not document how a poll uses it.
 */
static inline struct mip_3dm_poll_gnss_data *mip_3dm_poll_gnss_data_make(
    struct mip_3dm_poll_gnss_data *command, mip_bool suppress_ack, uint8_t num_descriptors,
    const struct mip_3dm_poll_entry descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->suppress_ack = mip_truth(suppress_ack);
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/**
 * Poll Estimation Filter Data: command (0x0C,0x03).
 *
 * Requests one filter data packet (0x82) with the listed fields, in the listed order.
 *
 * Also called `poll_filter_message`. Not acknowledged if suppress_ack is true. Supported by
 * 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * An empty list polls the fields that mip_3dm_filter_message_format stores; if none are, the device
 * rejects the command.
 *
 * Descriptors that the device does not know are ignored.
 *
 * The data is sent in a separate packet after the reply.
 *
 * - 3dm-gx5-15: 4.2.2 Poll Estimation Filter Data (0x0C, 0x03)
 */
struct mip_3dm_poll_filter_data {
    /** Send no acknowledge. */
    mip_bool suppress_ack;
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields to send. Refers to fields of MIP_FILTER_DATA_SET. */
    struct mip_3dm_poll_entry descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_POLL_FILTER_DATA 0x0C03
/** Its descriptor. */
#define MIP_3DM_POLL_FILTER_DATA_DESCRIPTOR 0x03
/** Its name in the specification. */
#define MIP_3DM_POLL_FILTER_DATA_NAME "3dm.poll_filter_data"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_poll_filter_data_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_poll_filter_data_decode(struct mip_3dm_poll_filter_data *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_poll_filter_data_codec, 0x03, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_poll_filter_data_encode(
    const struct mip_3dm_poll_filter_data *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_poll_filter_data_codec, value, builder);
}

/**
 * Poll Estimation Filter Data. Fills the structure and returns its address.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors.
 * - descriptors: Fields to send. Refers to fields of MIP_FILTER_DATA_SET.
 */
static inline struct mip_3dm_poll_filter_data *mip_3dm_poll_filter_data_make(
    struct mip_3dm_poll_filter_data *command, mip_bool suppress_ack, uint8_t num_descriptors,
    const struct mip_3dm_poll_entry descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->suppress_ack = mip_truth(suppress_ack);
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/**
 * Poll NMEA Data: command (0x0C,0x04).
 *
 * Requests the listed NMEA sentences once.
 *
 * Also called `nmea_poll_data`. Not acknowledged if suppress_ack is true. Supported by
 * 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * An empty list polls the stored NMEA format; if none is stored, the device rejects the command.
 *
 * The sentences follow the reply as ordinary NMEA text, on the port of the command, even if NMEA is
 * disabled there.
 *
 * A sentence is sent only if its data is valid.
 *
 * - 3dm-cv7-gnss-ins: Poll NMEA Data (0x0C,0x04)
 */
struct mip_3dm_poll_nmea_data {
    /** Send no acknowledge. */
    mip_bool suppress_ack;
    /** Number of sentences. Counts the elements of format_entries. */
    uint8_t count;
    /** Sentences to send. */
    struct mip_nmea_message format_entries[50];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_POLL_NMEA_DATA 0x0C04
/** Its descriptor. */
#define MIP_3DM_POLL_NMEA_DATA_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_3DM_POLL_NMEA_DATA_NAME "3dm.poll_nmea_data"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_poll_nmea_data_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_poll_nmea_data_decode(struct mip_3dm_poll_nmea_data *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_poll_nmea_data_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_poll_nmea_data_encode(
    const struct mip_3dm_poll_nmea_data *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_poll_nmea_data_codec, value, builder);
}

/**
 * Poll NMEA Data. Fills the structure and returns its address.
 *
 * - suppress_ack: Send no acknowledge.
 * - count: Number of sentences. Counts the elements of format_entries.
 * - format_entries: Sentences to send.
 */
static inline struct mip_3dm_poll_nmea_data *
mip_3dm_poll_nmea_data_make(struct mip_3dm_poll_nmea_data *command, mip_bool suppress_ack,
                            uint8_t count, const struct mip_nmea_message format_entries[]) {
    memset(command, 0, sizeof(*command));
    command->suppress_ack = mip_truth(suppress_ack);
    command->count = count;
    mip_copy(command->format_entries, sizeof(command->format_entries), format_entries,
             mip_counted(count, format_entries, sizeof(format_entries[0])));
    return command;
}

/**
 * Get IMU Data Base Rate: command (0x0C,0x06).
 *
 * Gets the base rate, which is divided by the decimations of mip_3dm_imu_message_format.
 *
 * Also called `imu_get_base_rate`. Response: mip_3dm_get_imu_base_rate_response. Supported by
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
 */
struct mip_3dm_get_imu_base_rate {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_IMU_BASE_RATE 0x0C06
/** Its descriptor. */
#define MIP_3DM_GET_IMU_BASE_RATE_DESCRIPTOR 0x06
/** Its name in the specification. */
#define MIP_3DM_GET_IMU_BASE_RATE_NAME "3dm.get_imu_base_rate"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_imu_base_rate_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_imu_base_rate_decode(struct mip_3dm_get_imu_base_rate *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_imu_base_rate_codec, 0x06, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_imu_base_rate_encode(
    const struct mip_3dm_get_imu_base_rate *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_imu_base_rate_codec, value, builder);
}

/**
 * Get IMU Data Base Rate response: response (0x0C,0x83).
 *
 * Also called `imu_get_base_rate_response`. Response to mip_3dm_get_imu_base_rate. Supported by
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
 */
struct mip_3dm_get_imu_base_rate_response {
    /** Base rate of the sensor data. Unit: Hz. */
    uint16_t rate;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_IMU_BASE_RATE_RESPONSE 0x0C83
/** Its descriptor. */
#define MIP_3DM_GET_IMU_BASE_RATE_RESPONSE_DESCRIPTOR 0x83
/** Its name in the specification. */
#define MIP_3DM_GET_IMU_BASE_RATE_RESPONSE_NAME "3dm.get_imu_base_rate_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_imu_base_rate_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_imu_base_rate_response_decode(
    struct mip_3dm_get_imu_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_imu_base_rate_response_codec, 0x83, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_imu_base_rate_response_encode(
    const struct mip_3dm_get_imu_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_imu_base_rate_response_codec, value, builder);
}

/**
 * Get GNSS Data Base Rate: command (0x0C,0x07).
 *
 * Gets the base rate, which is divided by the decimations of mip_3dm_gnss_message_format.
 *
 * Also called `gnss_get_base_rate`. Response: mip_3dm_get_gnss_base_rate_response. Supported by
 * 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
 */
struct mip_3dm_get_gnss_base_rate {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_GNSS_BASE_RATE 0x0C07
/** Its descriptor. */
#define MIP_3DM_GET_GNSS_BASE_RATE_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_3DM_GET_GNSS_BASE_RATE_NAME "3dm.get_gnss_base_rate"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_gnss_base_rate_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_gnss_base_rate_decode(struct mip_3dm_get_gnss_base_rate *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_gnss_base_rate_codec, 0x07, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_gnss_base_rate_encode(
    const struct mip_3dm_get_gnss_base_rate *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_gnss_base_rate_codec, value, builder);
}

/**
 * Get GNSS Data Base Rate response: response (0x0C,0x84).
 *
 * Also called `gnss_get_base_rate_response`. Response to mip_3dm_get_gnss_base_rate. Supported by
 * 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
 */
struct mip_3dm_get_gnss_base_rate_response {
    /** Base rate of the GNSS data. Unit: Hz. */
    uint16_t rate;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE 0x0C84
/** Its descriptor. */
#define MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE_DESCRIPTOR 0x84
/** Its name in the specification. */
#define MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE_NAME "3dm.get_gnss_base_rate_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_gnss_base_rate_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_gnss_base_rate_response_decode(
    struct mip_3dm_get_gnss_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_gnss_base_rate_response_codec, 0x84, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_gnss_base_rate_response_encode(
    const struct mip_3dm_get_gnss_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_gnss_base_rate_response_codec, value, builder);
}

/**
 * IMU Message Format: command (0x0C,0x08).
 *
 * Sets the fields of the sensor data packets (0x80), their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_imu_message_format_response.
 * Supported by 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST.
 *
 * The decimation is the base rate, as mip_3dm_get_imu_base_rate reports it, divided by the desired
 * rate.
 *
 * The list replaces the previous one. If any descriptor is unknown, the device rejects the command
 * and changes nothing.
 *
 * - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
 */
struct mip_3dm_imu_message_format {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of fields. Counts the elements of descriptors. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_SENSOR_SET. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_MESSAGE_FORMAT 0x0C08
/** Its descriptor. */
#define MIP_3DM_IMU_MESSAGE_FORMAT_DESCRIPTOR 0x08
/** Its name in the specification. */
#define MIP_3DM_IMU_MESSAGE_FORMAT_NAME "3dm.imu_message_format"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_message_format_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_message_format_decode(struct mip_3dm_imu_message_format *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_message_format_codec, 0x08, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_message_format_encode(
    const struct mip_3dm_imu_message_format *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_message_format_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Required for write.
 * - descriptors: Fields and decimations. Refers to fields of MIP_SENSOR_SET. Required for write.
 */
static inline struct mip_3dm_imu_message_format *mip_3dm_imu_message_format_write(
    struct mip_3dm_imu_message_format *command, uint8_t num_descriptors,
    const struct mip_descriptor_rate descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_message_format *
mip_3dm_imu_message_format_read(struct mip_3dm_imu_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_message_format *
mip_3dm_imu_message_format_save(struct mip_3dm_imu_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_message_format *
mip_3dm_imu_message_format_load(struct mip_3dm_imu_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_message_format *
mip_3dm_imu_message_format_default(struct mip_3dm_imu_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * IMU Message Format response: response (0x0C,0x80).
 *
 * Response to mip_3dm_imu_message_format. Supported by 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
 */
struct mip_3dm_imu_message_format_response {
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_SENSOR_SET. */
    struct mip_descriptor_rate descriptors[84];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE 0x0C80
/** Its descriptor. */
#define MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x80
/** Its name in the specification. */
#define MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE_NAME "3dm.imu_message_format_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_message_format_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_message_format_response_decode(
    struct mip_3dm_imu_message_format_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_message_format_response_codec, 0x80, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_message_format_response_encode(
    const struct mip_3dm_imu_message_format_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_message_format_response_codec, value, builder);
}

/**
 * GNSS Message Format: command (0x0C,0x09).
 *
 * Sets the fields of the GNSS data packets, their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gnss_message_format_response.
 * Supported by 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * The decimation is the base rate, as mip_3dm_get_gnss_base_rate reports it, divided by the desired
 * rate.
 *
 * - mip-sdk-4: GNSS Message Format (0x0C,0x09)
 * - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
 */
struct mip_3dm_gnss_message_format {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of fields. Counts the elements of descriptors. Range: 0 to 82. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_GNSS_DATA_SET. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_MESSAGE_FORMAT 0x0C09
/** Its descriptor. */
#define MIP_3DM_GNSS_MESSAGE_FORMAT_DESCRIPTOR 0x09
/** Its name in the specification. */
#define MIP_3DM_GNSS_MESSAGE_FORMAT_NAME "3dm.gnss_message_format"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_message_format_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_message_format_decode(
    struct mip_3dm_gnss_message_format *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_message_format_codec, 0x09, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_message_format_encode(
    const struct mip_3dm_gnss_message_format *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_message_format_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Range: 0 to 82. Required
 *   for write.
 * - descriptors: Fields and decimations. Refers to fields of MIP_GNSS_DATA_SET. Required for write.
 */
static inline struct mip_3dm_gnss_message_format *mip_3dm_gnss_message_format_write(
    struct mip_3dm_gnss_message_format *command, uint8_t num_descriptors,
    const struct mip_descriptor_rate descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_message_format *
mip_3dm_gnss_message_format_read(struct mip_3dm_gnss_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_message_format *
mip_3dm_gnss_message_format_save(struct mip_3dm_gnss_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_message_format *
mip_3dm_gnss_message_format_load(struct mip_3dm_gnss_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_message_format *
mip_3dm_gnss_message_format_default(struct mip_3dm_gnss_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * GNSS Message Format response: response (0x0C,0x81).
 *
 * Response to mip_3dm_gnss_message_format. Supported by 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - mip-sdk-4: GNSS Message Format (0x0C,0x09)
 * - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
 */
struct mip_3dm_gnss_message_format_response {
    /** Number of fields. Counts the elements of descriptors. Range: 0 to 82. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_GNSS_DATA_SET. */
    struct mip_descriptor_rate descriptors[84];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE 0x0C81
/** Its descriptor. */
#define MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x81
/** Its name in the specification. */
#define MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE_NAME "3dm.gnss_message_format_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_message_format_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_message_format_response_decode(
    struct mip_3dm_gnss_message_format_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_message_format_response_codec, 0x81, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_message_format_response_encode(
    const struct mip_3dm_gnss_message_format_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_message_format_response_codec, value, builder);
}

/**
 * Estimation Filter Message Format: command (0x0C,0x0A).
 *
 * Sets the fields of the filter data packets (0x82), their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_filter_message_format_response.
 * Supported by 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * The decimation is the base rate, as mip_3dm_get_filter_base_rate reports it, divided by the
 * desired rate.
 *
 * The list replaces the previous one. If any descriptor is unknown, the device rejects the command
 * and changes nothing.
 *
 * - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
 */
struct mip_3dm_filter_message_format {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of fields. Counts the elements of descriptors. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_FILTER_DATA_SET. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_FILTER_MESSAGE_FORMAT 0x0C0A
/** Its descriptor. */
#define MIP_3DM_FILTER_MESSAGE_FORMAT_DESCRIPTOR 0x0A
/** Its name in the specification. */
#define MIP_3DM_FILTER_MESSAGE_FORMAT_NAME "3dm.filter_message_format"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_filter_message_format_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_filter_message_format_decode(
    struct mip_3dm_filter_message_format *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_filter_message_format_codec, 0x0A, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_filter_message_format_encode(
    const struct mip_3dm_filter_message_format *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_filter_message_format_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Required for write.
 * - descriptors: Fields and decimations. Refers to fields of MIP_FILTER_DATA_SET. Required for
 *   write.
 */
static inline struct mip_3dm_filter_message_format *mip_3dm_filter_message_format_write(
    struct mip_3dm_filter_message_format *command, uint8_t num_descriptors,
    const struct mip_descriptor_rate descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_filter_message_format *
mip_3dm_filter_message_format_read(struct mip_3dm_filter_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_filter_message_format *
mip_3dm_filter_message_format_save(struct mip_3dm_filter_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_filter_message_format *
mip_3dm_filter_message_format_load(struct mip_3dm_filter_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_filter_message_format *
mip_3dm_filter_message_format_default(struct mip_3dm_filter_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Estimation Filter Message Format response: response (0x0C,0x82).
 *
 * Response to mip_3dm_filter_message_format. Supported by 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
 */
struct mip_3dm_filter_message_format_response {
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_FILTER_DATA_SET. */
    struct mip_descriptor_rate descriptors[84];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE 0x0C82
/** Its descriptor. */
#define MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x82
/** Its name in the specification. */
#define MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE_NAME "3dm.filter_message_format_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_filter_message_format_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_filter_message_format_response_decode(
    struct mip_3dm_filter_message_format_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_filter_message_format_response_codec, 0x82, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_filter_message_format_response_encode(
    const struct mip_3dm_filter_message_format_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_filter_message_format_response_codec, value, builder);
}

/**
 * Get Estimation Filter Data Base Rate: command (0x0C,0x0B).
 *
 * Gets the base rate, which is divided by the decimations of mip_3dm_filter_message_format.
 *
 * Also called `filter_get_base_rate`. Response: mip_3dm_get_filter_base_rate_response. Supported by
 * 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
 */
struct mip_3dm_get_filter_base_rate {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_FILTER_BASE_RATE 0x0C0B
/** Its descriptor. */
#define MIP_3DM_GET_FILTER_BASE_RATE_DESCRIPTOR 0x0B
/** Its name in the specification. */
#define MIP_3DM_GET_FILTER_BASE_RATE_NAME "3dm.get_filter_base_rate"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_filter_base_rate_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_filter_base_rate_decode(
    struct mip_3dm_get_filter_base_rate *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_filter_base_rate_codec, 0x0B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_filter_base_rate_encode(
    const struct mip_3dm_get_filter_base_rate *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_filter_base_rate_codec, value, builder);
}

/**
 * Get Estimation Filter Data Base Rate response: response (0x0C,0x8A).
 *
 * Also called `filter_get_base_rate_response`. Response to mip_3dm_get_filter_base_rate. Supported
 * by 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
 */
struct mip_3dm_get_filter_base_rate_response {
    /** Base rate of the filter data. Unit: Hz. */
    uint16_t rate;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE 0x0C8A
/** Its descriptor. */
#define MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE_DESCRIPTOR 0x8A
/** Its name in the specification. */
#define MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE_NAME "3dm.get_filter_base_rate_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_filter_base_rate_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_filter_base_rate_response_decode(
    struct mip_3dm_get_filter_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_filter_base_rate_response_codec, 0x8A, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_filter_base_rate_response_encode(
    const struct mip_3dm_get_filter_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_filter_base_rate_response_codec, value, builder);
}

/**
 * NMEA Message Format: command (0x0C,0x0C).
 *
 * Sets the NMEA sentences that the device streams.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_nmea_message_format_response.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * A sentence may be listed several times with different talkers or sources.
 *
 * A sentence is sent only while the device is not idle and the data of the source is valid.
 *
 * The 3DM-CV7-GNSS/INS rejects the format if a sentence would be sent more than 10 times per
 * second, or, from a GNSS set, more than twice.
 *
 * - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
 */
struct mip_3dm_nmea_message_format {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of sentences. Counts the elements of format_entries. Required for write. */
    uint8_t count;
    /** Sentences to stream. Required for write. */
    struct mip_nmea_message format_entries[50];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_NMEA_MESSAGE_FORMAT 0x0C0C
/** Its descriptor. */
#define MIP_3DM_NMEA_MESSAGE_FORMAT_DESCRIPTOR 0x0C
/** Its name in the specification. */
#define MIP_3DM_NMEA_MESSAGE_FORMAT_NAME "3dm.nmea_message_format"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_nmea_message_format_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_nmea_message_format_decode(
    struct mip_3dm_nmea_message_format *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_nmea_message_format_codec, 0x0C, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_nmea_message_format_encode(
    const struct mip_3dm_nmea_message_format *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_nmea_message_format_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - count: Number of sentences. Counts the elements of format_entries. Required for write.
 * - format_entries: Sentences to stream. Required for write.
 */
static inline struct mip_3dm_nmea_message_format *
mip_3dm_nmea_message_format_write(struct mip_3dm_nmea_message_format *command, uint8_t count,
                                  const struct mip_nmea_message format_entries[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->count = count;
    mip_copy(command->format_entries, sizeof(command->format_entries), format_entries,
             mip_counted(count, format_entries, sizeof(format_entries[0])));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_nmea_message_format *
mip_3dm_nmea_message_format_read(struct mip_3dm_nmea_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_nmea_message_format *
mip_3dm_nmea_message_format_save(struct mip_3dm_nmea_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_nmea_message_format *
mip_3dm_nmea_message_format_load(struct mip_3dm_nmea_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_nmea_message_format *
mip_3dm_nmea_message_format_default(struct mip_3dm_nmea_message_format *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * NMEA Message Format response: response (0x0C,0x8C).
 *
 * Response to mip_3dm_nmea_message_format. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
 */
struct mip_3dm_nmea_message_format_response {
    /** Number of sentences. Counts the elements of format_entries. */
    uint8_t count;
    /** Sentences to stream. */
    struct mip_nmea_message format_entries[50];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE 0x0C8C
/** Its descriptor. */
#define MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x8C
/** Its name in the specification. */
#define MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE_NAME "3dm.nmea_message_format_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_nmea_message_format_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_nmea_message_format_response_decode(
    struct mip_3dm_nmea_message_format_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_nmea_message_format_response_codec, 0x8C, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_nmea_message_format_response_encode(
    const struct mip_3dm_nmea_message_format_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_nmea_message_format_response_codec, value, builder);
}

/**
 * Poll Data: command (0x0C,0x0D).
 *
 * Requests one data packet of the descriptor set with the listed fields, in the listed order.
 *
 * Not acknowledged if suppress_ack is true. Supported by 3DM-CV7-GNSS/INS.
 *
 * An empty list polls the fields that mip_3dm_message_format stores; if nothing is stored, the
 * device rejects the command.
 *
 * Descriptors that the device does not know are ignored.
 *
 * The data is sent in a separate packet after the reply, on the port of the command.
 *
 * List shared descriptors (0xD0 and up) before the others.
 *
 * - 3dm-cv7-gnss-ins: Poll Data (0x0C,0x0D)
 */
struct mip_3dm_poll_data {
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    uint8_t descriptor_set;
    /** Send no acknowledge. */
    mip_bool suppress_ack;
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Field descriptors. Refers to fields of descriptor_set. */
    uint8_t descriptors[250];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_POLL_DATA 0x0C0D
/** Its descriptor. */
#define MIP_3DM_POLL_DATA_DESCRIPTOR 0x0D
/** Its name in the specification. */
#define MIP_3DM_POLL_DATA_NAME "3dm.poll_data"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_poll_data_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_poll_data_decode(struct mip_3dm_poll_data *value,
                                                 const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_poll_data_codec, 0x0D, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_poll_data_encode(const struct mip_3dm_poll_data *value,
                                                             struct mip_builder *builder) {
    return mip_encode(&mip_3dm_poll_data_codec, value, builder);
}

/**
 * Poll Data. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set. Range: 0x80 to 0xFE.
 * - suppress_ack: Send no acknowledge.
 * - num_descriptors: Number of fields. Counts the elements of descriptors.
 * - descriptors: Field descriptors. Refers to fields of descriptor_set.
 */
static inline struct mip_3dm_poll_data *mip_3dm_poll_data_make(struct mip_3dm_poll_data *command,
                                                               uint8_t descriptor_set,
                                                               mip_bool suppress_ack,
                                                               uint8_t num_descriptors,
                                                               const uint8_t descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->descriptor_set = descriptor_set;
    command->suppress_ack = mip_truth(suppress_ack);
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/**
 * Get Data Base Rate: command (0x0C,0x0E).
 *
 * Gets the base rate, which is divided by the decimations of a descriptor set.
 *
 * Response: mip_3dm_get_base_rate_response. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS
 * and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
 */
struct mip_3dm_get_base_rate {
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    uint8_t descriptor_set;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_BASE_RATE 0x0C0E
/** Its descriptor. */
#define MIP_3DM_GET_BASE_RATE_DESCRIPTOR 0x0E
/** Its name in the specification. */
#define MIP_3DM_GET_BASE_RATE_NAME "3dm.get_base_rate"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_base_rate_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_base_rate_decode(struct mip_3dm_get_base_rate *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_base_rate_codec, 0x0E, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_base_rate_encode(
    const struct mip_3dm_get_base_rate *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_base_rate_codec, value, builder);
}

/**
 * Get Data Base Rate. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set. Range: 0x80 to 0xFE.
 */
static inline struct mip_3dm_get_base_rate *
mip_3dm_get_base_rate_make(struct mip_3dm_get_base_rate *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Get Data Base Rate response: response (0x0C,0x8E).
 *
 * Response to mip_3dm_get_base_rate. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and
 * 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
 */
struct mip_3dm_get_base_rate_response {
    /** Data descriptor set specified in the command. */
    uint8_t descriptor_set;
    /** Base rate; 0 if the rate is variable or unknown and data is sent as it arrives. Unit: Hz. */
    uint16_t rate;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_BASE_RATE_RESPONSE 0x0C8E
/** Its descriptor. */
#define MIP_3DM_GET_BASE_RATE_RESPONSE_DESCRIPTOR 0x8E
/** Its name in the specification. */
#define MIP_3DM_GET_BASE_RATE_RESPONSE_NAME "3dm.get_base_rate_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_base_rate_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_base_rate_response_decode(
    struct mip_3dm_get_base_rate_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_base_rate_response_codec, 0x8E, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_base_rate_response_encode(
    const struct mip_3dm_get_base_rate_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_base_rate_response_codec, value, builder);
}

/**
 * Message Format: command (0x0C,0x0F).
 *
 * Sets the fields of the data packets of a descriptor set, their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_message_format_response.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * The decimation is the base rate, as mip_3dm_get_base_rate reports it, divided by the desired
 * rate.
 *
 * List shared descriptors (0xD0 and up) under the set whose packets will contain them, before the
 * others.
 *
 * - 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
 */
struct mip_3dm_message_format {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Data descriptor set; 0 means all of them (save, load, default). */
    uint8_t descriptor_set;
    /** Number of fields. Counts the elements of descriptors. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of descriptor_set. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_MESSAGE_FORMAT 0x0C0F
/** Its descriptor. */
#define MIP_3DM_MESSAGE_FORMAT_DESCRIPTOR 0x0F
/** Its name in the specification. */
#define MIP_3DM_MESSAGE_FORMAT_NAME "3dm.message_format"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_message_format_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_message_format_decode(struct mip_3dm_message_format *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_message_format_codec, 0x0F, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_message_format_encode(
    const struct mip_3dm_message_format *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_message_format_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 * - num_descriptors: Number of fields. Counts the elements of descriptors. Required for write.
 * - descriptors: Fields and decimations. Refers to fields of descriptor_set. Required for write.
 */
static inline struct mip_3dm_message_format *mip_3dm_message_format_write(
    struct mip_3dm_message_format *command, uint8_t descriptor_set, uint8_t num_descriptors,
    const struct mip_descriptor_rate descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->descriptor_set = descriptor_set;
    command->num_descriptors = num_descriptors;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(num_descriptors, descriptors, sizeof(descriptors[0])));
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_read(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_save(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_load(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all of them (save, load, default).
 */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_default(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Message Format response: response (0x0C,0x8F).
 *
 * Response to mip_3dm_message_format. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
 */
struct mip_3dm_message_format_response {
    /** Data descriptor set. */
    uint8_t descriptor_set;
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of descriptor_set. */
    struct mip_descriptor_rate descriptors[83];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_MESSAGE_FORMAT_RESPONSE 0x0C8F
/** Its descriptor. */
#define MIP_3DM_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x8F
/** Its name in the specification. */
#define MIP_3DM_MESSAGE_FORMAT_RESPONSE_NAME "3dm.message_format_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_message_format_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_message_format_response_decode(
    struct mip_3dm_message_format_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_message_format_response_codec, 0x8F, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_message_format_response_encode(
    const struct mip_3dm_message_format_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_message_format_response_codec, value, builder);
}

/**
 * Factory Streaming: command (0x0C,0x10).
 *
 * Sets all message formats to those that technical support needs in a recording.
 *
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
 */
struct mip_3dm_factory_streaming {
    /** Treatment of the existing formats. A value of enum mip_3dm_factory_streaming_action. */
    uint8_t action;
    /** Reserved: send 0. */
    uint8_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_FACTORY_STREAMING 0x0C10
/** Its descriptor. */
#define MIP_3DM_FACTORY_STREAMING_DESCRIPTOR 0x10
/** Its name in the specification. */
#define MIP_3DM_FACTORY_STREAMING_NAME "3dm.factory_streaming"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_factory_streaming_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_factory_streaming_decode(struct mip_3dm_factory_streaming *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_factory_streaming_codec, 0x10, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_factory_streaming_encode(
    const struct mip_3dm_factory_streaming *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_factory_streaming_codec, value, builder);
}

/**
 * Factory Streaming. Fills the structure and returns its address.
 *
 * - action: Treatment of the existing formats. A value of enum mip_3dm_factory_streaming_action.
 */
static inline struct mip_3dm_factory_streaming *mip_3dm_factory_streaming_make(
    struct mip_3dm_factory_streaming *command, enum mip_3dm_factory_streaming_action action) {
    memset(command, 0, sizeof(*command));
    command->action = (uint8_t)action;
    return command;
}

/**
 * Data Stream Control: command (0x0C,0x11).
 *
 * Switches a data stream on or off.
 *
 * Also called `datastream_control`. Functions: write, read, save, load and default. Response:
 * mip_3dm_data_stream_control_response. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS,
 * 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * Devices of the generations 3 to 5 identify the stream by a number (enum
 * mip_3dm_legacy_data_stream), other devices by its descriptor set.
 *
 * A newly enabled stream starts with current data, without any from before.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 * - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
 */
struct mip_3dm_data_stream_control {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Data descriptor set; 0 means all streams (save, load, default). On the 3DM-CV5-10,
     * 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     * 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
     * 3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of
     * enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
     * mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
     * MIP_3DM_LEGACY_DATA_STREAM_FILTER.
     */
    uint8_t descriptor_set;
    /**
     * True if the stream is sent. Default: true. Required for write.
     *
     * The stream starts with current data. What was measured while it was disabled is not sent.
     */
    mip_bool enable;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DATA_STREAM_CONTROL 0x0C11
/** Its descriptor. */
#define MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR 0x11
/** Its name in the specification. */
#define MIP_3DM_DATA_STREAM_CONTROL_NAME "3dm.data_stream_control"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_data_stream_control_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_data_stream_control_decode(
    struct mip_3dm_data_stream_control *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_data_stream_control_codec, 0x11, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_data_stream_control_encode(
    const struct mip_3dm_data_stream_control *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_data_stream_control_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3,
 *   3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
 *   3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum
 *   mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum mip_3dm_legacy_data_stream; only
 *   MIP_3DM_LEGACY_DATA_STREAM_IMU and MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 * - enable: True if the stream is sent. Default: true. Required for write. The stream starts with
 *   current data. What was measured while it was disabled is not sent.
 */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_write(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set, mip_bool enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->descriptor_set = descriptor_set;
    command->enable = mip_truth(enable);
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3,
 *   3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
 *   3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum
 *   mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum mip_3dm_legacy_data_stream; only
 *   MIP_3DM_LEGACY_DATA_STREAM_IMU and MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_read(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3,
 *   3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
 *   3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum
 *   mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum mip_3dm_legacy_data_stream; only
 *   MIP_3DM_LEGACY_DATA_STREAM_IMU and MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_save(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3,
 *   3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
 *   3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum
 *   mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum mip_3dm_legacy_data_stream; only
 *   MIP_3DM_LEGACY_DATA_STREAM_IMU and MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_load(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set; 0 means all streams (save, load, default). On the
 *   3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3,
 *   3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
 *   3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum
 *   mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum mip_3dm_legacy_data_stream; only
 *   MIP_3DM_LEGACY_DATA_STREAM_IMU and MIP_3DM_LEGACY_DATA_STREAM_FILTER.
 */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_default(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Data Stream Control response: response (0x0C,0x85).
 *
 * Also called `datastream_control_response`. Response to mip_3dm_data_stream_control. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-10, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 * - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
 */
struct mip_3dm_data_stream_control_response {
    /**
     * Stream specified in the command. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10,
     * 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35,
     * 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45,
     * 3DM-MV5-AR, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum mip_3dm_legacy_data_stream. On
     * the 3DM-GX5-15: values of enum mip_3dm_legacy_data_stream; only
     * MIP_3DM_LEGACY_DATA_STREAM_IMU and MIP_3DM_LEGACY_DATA_STREAM_FILTER.
     */
    uint8_t descriptor_set;
    /** True if the stream is sent. */
    mip_bool enabled;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DATA_STREAM_CONTROL_RESPONSE 0x0C85
/** Its descriptor. */
#define MIP_3DM_DATA_STREAM_CONTROL_RESPONSE_DESCRIPTOR 0x85
/** Its name in the specification. */
#define MIP_3DM_DATA_STREAM_CONTROL_RESPONSE_NAME "3dm.data_stream_control_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_data_stream_control_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_data_stream_control_response_decode(
    struct mip_3dm_data_stream_control_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_data_stream_control_response_codec, 0x85, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_data_stream_control_response_encode(
    const struct mip_3dm_data_stream_control_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_data_stream_control_response_codec, value, builder);
}

/**
 * Raw RTCM 2.3 message: command (0x0C,0x20).
 *
 * Sends RTCM 2.3 corrections to the GNSS receiver.
 *
 * Supported by 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * The receiver uses the RTCM messages 1, 2, 3 and 9.
 *
 * A message may be split at any byte and sent with several of these commands.
 *
 * - 3dm-gx5-45: 4.2.26 Raw RTCM 2.3 Message (0x0C, 0x20)
 * - mip-sdk-2014: Raw RTCM 2.3 message (0x0C,0x20)
 * - mscl: Raw RTCM 2.3 message (0x0C,0x20)
 */
struct mip_3dm_raw_rtcm_2_3_message {
    /** The number of elements of data. */
    uint8_t data_count;
    /** Bytes of the RTCM stream. */
    uint8_t data[253];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_RAW_RTCM_2_3_MESSAGE 0x0C20
/** Its descriptor. */
#define MIP_3DM_RAW_RTCM_2_3_MESSAGE_DESCRIPTOR 0x20
/** Its name in the specification. */
#define MIP_3DM_RAW_RTCM_2_3_MESSAGE_NAME "3dm.raw_rtcm_2_3_message"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_raw_rtcm_2_3_message_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_raw_rtcm_2_3_message_decode(
    struct mip_3dm_raw_rtcm_2_3_message *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_raw_rtcm_2_3_message_codec, 0x20, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_raw_rtcm_2_3_message_encode(
    const struct mip_3dm_raw_rtcm_2_3_message *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_raw_rtcm_2_3_message_codec, value, builder);
}

/**
 * Raw RTCM 2.3 message. Fills the structure and returns its address.
 *
 * - data_: Bytes of the RTCM stream.
 */
static inline struct mip_3dm_raw_rtcm_2_3_message *mip_3dm_raw_rtcm_2_3_message_make(
    struct mip_3dm_raw_rtcm_2_3_message *command, uint8_t data__count, const uint8_t data_[]) {
    memset(command, 0, sizeof(*command));
    command->data_count = data__count;
    mip_copy(command->data, sizeof(command->data), data_,
             mip_counted(data__count, data_, sizeof(data_[0])));
    return command;
}

/**
 * Constellation Settings: command (0x0C,0x21).
 *
 * Selects the constellations that the GNSS receiver tracks, and their shares of its tracking
 * channels.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_3dm_constellation_settings_response. Probably changes mip_gnss_data_fix_info,
 * mip_gnss_data_sv_info and mip_gnss_data_satellite_status. Supported by 3DM-GQ4-45 and 3DM-GX5-35.
 * Uncertain: The factory default. The SDK names only GPS and GLONASS as enabled, but has channels
 * for SBAS and QZSS too.
 *
 * The device rejects entries that reserve more than 32 channels in total. The maximum of an entry
 * must not be less than the number of channels it reserves.
 *
 * GLONASS and BeiDou cannot be used together.
 *
 * If the antenna or its filter is made for GPS only, leave GLONASS and BeiDou off.
 *
 * SBAS and QZSS improve the accuracy of GPS. SBAS does not make the device suitable for
 * safety-of-life use.
 *
 * Factory default: GPS and GLONASS are enabled. Reserved and maximum channels: GPS 8 and 16,
 * GLONASS 8 and 14, SBAS 1 and 3, QZSS 0 and 3.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 * - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
 */
struct mip_3dm_constellation_settings {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Maximum number of tracking channels in use; at most the number that the response reports as
     * available. Unit: 1. Required for write.
     */
    uint16_t max_channels;
    /** Number of entries. Counts the elements of settings. Range: 0 to 41. Required for write. */
    uint8_t config_count;
    /** One entry for each constellation. Required for write. */
    struct mip_3dm_constellation_settings_entry settings[41];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_CONSTELLATION_SETTINGS 0x0C21
/** Its descriptor. */
#define MIP_3DM_CONSTELLATION_SETTINGS_DESCRIPTOR 0x21
/** Its name in the specification. */
#define MIP_3DM_CONSTELLATION_SETTINGS_NAME "3dm.constellation_settings"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_constellation_settings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_constellation_settings_decode(
    struct mip_3dm_constellation_settings *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_constellation_settings_codec, 0x21, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_constellation_settings_encode(
    const struct mip_3dm_constellation_settings *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_constellation_settings_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - max_channels: Maximum number of tracking channels in use; at most the number that the response
 *   reports as available. Unit: 1. Required for write.
 * - config_count: Number of entries. Counts the elements of settings. Range: 0 to 41. Required for
 *   write.
 * - settings: One entry for each constellation. Required for write.
 */
static inline struct mip_3dm_constellation_settings *mip_3dm_constellation_settings_write(
    struct mip_3dm_constellation_settings *command, uint16_t max_channels, uint8_t config_count,
    const struct mip_3dm_constellation_settings_entry settings[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->max_channels = max_channels;
    command->config_count = config_count;
    mip_copy(command->settings, sizeof(command->settings), settings,
             mip_counted(config_count, settings, sizeof(settings[0])));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_constellation_settings *
mip_3dm_constellation_settings_read(struct mip_3dm_constellation_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_constellation_settings *
mip_3dm_constellation_settings_save(struct mip_3dm_constellation_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_constellation_settings *
mip_3dm_constellation_settings_load(struct mip_3dm_constellation_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_constellation_settings *
mip_3dm_constellation_settings_default(struct mip_3dm_constellation_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Constellation Settings response: response (0x0C,0xA0).
 *
 * Tracking channels of the receiver and the setting of each constellation.
 *
 * Response to mip_3dm_constellation_settings. Supported by 3DM-GQ4-45 and 3DM-GX5-35.
 *
 * - mip-sdk-4: Constellation Settings (0x0C,0x21)
 * - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
 */
struct mip_3dm_constellation_settings_response {
    /** Number of channels of the receiver. Unit: 1. */
    uint16_t max_channels_available;
    /** Maximum number of channels in use. Unit: 1. */
    uint16_t max_channels_use;
    /** Number of entries. Counts the elements of settings. Range: 0 to 41. */
    uint8_t config_count;
    /** One entry for each constellation. */
    struct mip_3dm_constellation_settings_entry settings[41];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE 0x0CA0
/** Its descriptor. */
#define MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE_DESCRIPTOR 0xA0
/** Its name in the specification. */
#define MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE_NAME "3dm.constellation_settings_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_constellation_settings_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_constellation_settings_response_decode(
    struct mip_3dm_constellation_settings_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_constellation_settings_response_codec, 0xA0, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_constellation_settings_response_encode(
    const struct mip_3dm_constellation_settings_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_constellation_settings_response_codec, value, builder);
}

/**
 * GNSS SBAS Settings: command (0x0C,0x22).
 *
 * Sets how the GNSS receivers use satellite-based augmentation (SBAS).
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gnss_sbas_settings_response.
 * Probably changes mip_gnss_data_sbas_info and mip_gnss_data_sbas_correction. Supported by
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45 and 3DM-GX5-35.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
struct mip_3dm_gnss_sbas_settings {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * 1 enables SBAS, 0 disables it. Range: 0 to 1. Required for write. On the 3DM-GX5-35: default
     * 1.
     */
    uint8_t enable_sbas;
    /**
     * Purposes of SBAS. Required for write. On the 3DM-GX5-35: default
     * MIP_3DM_SBAS_OPTIONS_ENABLE_RANGING and MIP_3DM_SBAS_OPTIONS_ENABLE_CORRECTIONS.
     */
    mip_3dm_sbas_options sbas_options;
    /**
     * Number of satellites listed; 0 searches for all. Counts the elements of included_prns.
     * Required for write.
     */
    uint8_t num_included_prns;
    /** PRN numbers of the SBAS satellites to search for. Required for write. */
    uint16_t included_prns[124];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_SBAS_SETTINGS 0x0C22
/** Its descriptor. */
#define MIP_3DM_GNSS_SBAS_SETTINGS_DESCRIPTOR 0x22
/** Its name in the specification. */
#define MIP_3DM_GNSS_SBAS_SETTINGS_NAME "3dm.gnss_sbas_settings"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_sbas_settings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_sbas_settings_decode(struct mip_3dm_gnss_sbas_settings *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_sbas_settings_codec, 0x22, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_sbas_settings_encode(
    const struct mip_3dm_gnss_sbas_settings *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_sbas_settings_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - enable_sbas: 1 enables SBAS, 0 disables it. Range: 0 to 1. Required for write. On the
 *   3DM-GX5-35: default 1.
 * - sbas_options: Purposes of SBAS. Required for write. On the 3DM-GX5-35: default
 *   MIP_3DM_SBAS_OPTIONS_ENABLE_RANGING and MIP_3DM_SBAS_OPTIONS_ENABLE_CORRECTIONS.
 * - num_included_prns: Number of satellites listed; 0 searches for all. Counts the elements of
 *   included_prns. Required for write.
 * - included_prns: PRN numbers of the SBAS satellites to search for. Required for write.
 */
static inline struct mip_3dm_gnss_sbas_settings *mip_3dm_gnss_sbas_settings_write(
    struct mip_3dm_gnss_sbas_settings *command, uint8_t enable_sbas,
    mip_3dm_sbas_options sbas_options, uint8_t num_included_prns, const uint16_t included_prns[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable_sbas = enable_sbas;
    command->sbas_options = sbas_options;
    command->num_included_prns = num_included_prns;
    mip_copy(command->included_prns, sizeof(command->included_prns), included_prns,
             mip_counted(num_included_prns, included_prns, sizeof(included_prns[0])));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_sbas_settings *
mip_3dm_gnss_sbas_settings_read(struct mip_3dm_gnss_sbas_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_sbas_settings *
mip_3dm_gnss_sbas_settings_save(struct mip_3dm_gnss_sbas_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_sbas_settings *
mip_3dm_gnss_sbas_settings_load(struct mip_3dm_gnss_sbas_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_sbas_settings *
mip_3dm_gnss_sbas_settings_default(struct mip_3dm_gnss_sbas_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * GNSS SBAS Settings response: response (0x0C,0xA1).
 *
 * Response to mip_3dm_gnss_sbas_settings. Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45 and 3DM-GX5-35.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
struct mip_3dm_gnss_sbas_settings_response {
    /** 1 enables SBAS, 0 disables it. Range: 0 to 1. */
    uint8_t enable_sbas;
    /** Purposes of SBAS. */
    mip_3dm_sbas_options sbas_options;
    /** Number of satellites listed; 0 searches for all. Counts the elements of included_prns. */
    uint8_t num_included_prns;
    /** PRN numbers of the SBAS satellites to search for. */
    uint16_t included_prns[124];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE 0x0CA1
/** Its descriptor. */
#define MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE_DESCRIPTOR 0xA1
/** Its name in the specification. */
#define MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE_NAME "3dm.gnss_sbas_settings_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_sbas_settings_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_sbas_settings_response_decode(
    struct mip_3dm_gnss_sbas_settings_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_sbas_settings_response_codec, 0xA1, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_sbas_settings_response_encode(
    const struct mip_3dm_gnss_sbas_settings_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_sbas_settings_response_codec, value, builder);
}

/**
 * GNSS Assisted Fix: command (0x0C,0x23).
 *
 * Sets whether the GNSS receiver keeps the data of its last fix and starts from it at the next
 * power-up.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gnss_assisted_fix_response.
 * Supported by 3DM-GX5-35. Known only from the MicroStrain MIP SDK.
 *
 * The last fix is kept in the flash memory and the FRAM of the receiver.
 *
 * If you send the time with mip_3dm_gnss_time_assistance right after power-up, the first fix takes
 * 1 s at best.
 *
 * A change from enabled to none erases the flash memory of the receiver, which is rated for 100 000
 * erasures.
 *
 * It slightly increases the power consumption.
 *
 * - mip-sdk-4: GNSS Assisted Fix (0x0C,0x23)
 */
struct mip_3dm_gnss_assisted_fix {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Storage of data for a faster first fix. A value of enum mip_3dm_assisted_fix_option. Default:
     * MIP_3DM_ASSISTED_FIX_OPTION_NONE. Required for write. On the 3DM-GX5-35: default
     * MIP_3DM_ASSISTED_FIX_OPTION_NONE.
     */
    uint8_t option;
    /** Reserved: send 255. Required for write. On the 3DM-GX5-35: default 255. */
    uint8_t flags;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_ASSISTED_FIX 0x0C23
/** Its descriptor. */
#define MIP_3DM_GNSS_ASSISTED_FIX_DESCRIPTOR 0x23
/** Its name in the specification. */
#define MIP_3DM_GNSS_ASSISTED_FIX_NAME "3dm.gnss_assisted_fix"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_assisted_fix_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_assisted_fix_decode(struct mip_3dm_gnss_assisted_fix *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_assisted_fix_codec, 0x23, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_assisted_fix_encode(
    const struct mip_3dm_gnss_assisted_fix *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_assisted_fix_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - option: Storage of data for a faster first fix. A value of enum mip_3dm_assisted_fix_option.
 *   Default: MIP_3DM_ASSISTED_FIX_OPTION_NONE. Required for write. On the 3DM-GX5-35: default
 *   MIP_3DM_ASSISTED_FIX_OPTION_NONE.
 */
static inline struct mip_3dm_gnss_assisted_fix *mip_3dm_gnss_assisted_fix_write(
    struct mip_3dm_gnss_assisted_fix *command, enum mip_3dm_assisted_fix_option option) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->option = (uint8_t)option;
    command->flags = 255;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_read(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->flags = 255;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_save(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->flags = 255;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_load(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->flags = 255;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_default(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->flags = 255;
    return command;
}

/**
 * GNSS Assisted Fix response: response (0x0C,0xA2).
 *
 * Response to mip_3dm_gnss_assisted_fix. Supported by 3DM-GX5-35. Known only from the MicroStrain
 * MIP SDK.
 *
 * - mip-sdk-4: GNSS Assisted Fix (0x0C,0x23)
 */
struct mip_3dm_gnss_assisted_fix_response {
    /**
     * Storage of data for a faster first fix. A value of enum mip_3dm_assisted_fix_option. Default:
     * MIP_3DM_ASSISTED_FIX_OPTION_NONE.
     */
    uint8_t option;
    /** Reserved. */
    uint8_t flags;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE 0x0CA2
/** Its descriptor. */
#define MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE_DESCRIPTOR 0xA2
/** Its name in the specification. */
#define MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE_NAME "3dm.gnss_assisted_fix_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_assisted_fix_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_assisted_fix_response_decode(
    struct mip_3dm_gnss_assisted_fix_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_assisted_fix_response_codec, 0xA2, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_assisted_fix_response_encode(
    const struct mip_3dm_gnss_assisted_fix_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_assisted_fix_response_codec, value, builder);
}

/**
 * GNSS Time Assistance: command (0x0C,0x24).
 *
 * Sends the current GPS time to the GNSS receiver.
 *
 * Functions: write and read. Response: mip_3dm_gnss_time_assistance_response. Supported by
 * 3DM-GX5-35. Known only from the MicroStrain MIP SDK.
 *
 * It is needed right after power-up if mip_3dm_gnss_assisted_fix was on at power-off.
 *
 * - mip-sdk-4: GNSS Time Assistance (0x0C,0x24)
 */
struct mip_3dm_gnss_time_assistance {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. Required for write. */
    double tow;
    /** GPS week number since 1980. Unit: week. Required for write. */
    uint16_t week_number;
    /**
     * Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. Required for write.
     */
    float accuracy;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_TIME_ASSISTANCE 0x0C24
/** Its descriptor. */
#define MIP_3DM_GNSS_TIME_ASSISTANCE_DESCRIPTOR 0x24
/** Its name in the specification. */
#define MIP_3DM_GNSS_TIME_ASSISTANCE_NAME "3dm.gnss_time_assistance"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_time_assistance_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_time_assistance_decode(
    struct mip_3dm_gnss_time_assistance *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_time_assistance_codec, 0x24, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_time_assistance_encode(
    const struct mip_3dm_gnss_time_assistance *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_time_assistance_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - tow: GPS time of week. Unit: s. Range: at least 0, less than 604800. Required for write.
 * - week_number: GPS week number since 1980. Unit: week. Required for write.
 * - accuracy: Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. Required for
 *   write.
 */
static inline struct mip_3dm_gnss_time_assistance *
mip_3dm_gnss_time_assistance_write(struct mip_3dm_gnss_time_assistance *command, double tow,
                                   uint16_t week_number, float accuracy) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->tow = tow;
    command->week_number = week_number;
    command->accuracy = accuracy;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_gnss_time_assistance *
mip_3dm_gnss_time_assistance_read(struct mip_3dm_gnss_time_assistance *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/**
 * GNSS Time Assistance response: response (0x0C,0xA3).
 *
 * Response to mip_3dm_gnss_time_assistance. Supported by 3DM-GX5-35. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: GNSS Time Assistance (0x0C,0x24)
 */
struct mip_3dm_gnss_time_assistance_response {
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number since 1980. Unit: week. */
    uint16_t week_number;
    /** Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. */
    float accuracy;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE 0x0CA3
/** Its descriptor. */
#define MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE_DESCRIPTOR 0xA3
/** Its name in the specification. */
#define MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE_NAME "3dm.gnss_time_assistance_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gnss_time_assistance_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gnss_time_assistance_response_decode(
    struct mip_3dm_gnss_time_assistance_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gnss_time_assistance_response_codec, 0xA3, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gnss_time_assistance_response_encode(
    const struct mip_3dm_gnss_time_assistance_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gnss_time_assistance_response_codec, value, builder);
}

/**
 * PPS Source Control: command (0x0C,0x28).
 *
 * Selects the source of the pulse per second (PPS).
 *
 * Also called `pps_source`. Functions: write, read, save, load and default. Response:
 * mip_3dm_pps_source_control_response. Changes mip_system_data_time_sync_status. Probably changes
 * mip_shared_gps_timestamp, mip_shared_external_timestamp and mip_sensor_gps_timestamp. Supported
 * by 3DM-CV7-GNSS/INS.
 *
 * The pins are configured separately, by mip_3dm_gpio_config.
 *
 * The filter needs a valid pulse; `disabled` and `generated` are rarely useful.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 */
struct mip_3dm_pps_source_control {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Source of the pulse. A value of enum mip_3dm_pps_source. Required for write. On the
     * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GV7-AHRS,
     * 3DM-GV7-AR and 3DM-GV7-INS: only MIP_3DM_PPS_SOURCE_DISABLED, MIP_3DM_PPS_SOURCE_GPIO and
     * MIP_3DM_PPS_SOURCE_GENERATED. On the 3DM-CV7-GNSS/INS: default MIP_3DM_PPS_SOURCE_RECEIVER_1.
     * On the 3DM-GQ7-GNSS/INS: only MIP_3DM_PPS_SOURCE_DISABLED, MIP_3DM_PPS_SOURCE_RECEIVER_1,
     * MIP_3DM_PPS_SOURCE_RECEIVER_2, MIP_3DM_PPS_SOURCE_GPIO and MIP_3DM_PPS_SOURCE_GENERATED.
     */
    uint8_t source;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_PPS_SOURCE_CONTROL 0x0C28
/** Its descriptor. */
#define MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR 0x28
/** Its name in the specification. */
#define MIP_3DM_PPS_SOURCE_CONTROL_NAME "3dm.pps_source_control"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_pps_source_control_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_pps_source_control_decode(struct mip_3dm_pps_source_control *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_pps_source_control_codec, 0x28, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_pps_source_control_encode(
    const struct mip_3dm_pps_source_control *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_pps_source_control_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - source: Source of the pulse. A value of enum mip_3dm_pps_source. Required for write. On the
 *   3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX7-AHRS, 3DM-CX7-AR, 3DM-CX7-INS, 3DM-GV7-AHRS,
 *   3DM-GV7-AR and 3DM-GV7-INS: only MIP_3DM_PPS_SOURCE_DISABLED, MIP_3DM_PPS_SOURCE_GPIO and
 *   MIP_3DM_PPS_SOURCE_GENERATED. On the 3DM-CV7-GNSS/INS: default MIP_3DM_PPS_SOURCE_RECEIVER_1.
 *   On the 3DM-GQ7-GNSS/INS: only MIP_3DM_PPS_SOURCE_DISABLED, MIP_3DM_PPS_SOURCE_RECEIVER_1,
 *   MIP_3DM_PPS_SOURCE_RECEIVER_2, MIP_3DM_PPS_SOURCE_GPIO and MIP_3DM_PPS_SOURCE_GENERATED.
 */
static inline struct mip_3dm_pps_source_control *mip_3dm_pps_source_control_write(
    struct mip_3dm_pps_source_control *command, enum mip_3dm_pps_source source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_pps_source_control *
mip_3dm_pps_source_control_read(struct mip_3dm_pps_source_control *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_pps_source_control *
mip_3dm_pps_source_control_save(struct mip_3dm_pps_source_control *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_pps_source_control *
mip_3dm_pps_source_control_load(struct mip_3dm_pps_source_control *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_pps_source_control *
mip_3dm_pps_source_control_default(struct mip_3dm_pps_source_control *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * PPS Source Control response: response (0x0C,0xA8).
 *
 * Also called `pps_source_response`. Response to mip_3dm_pps_source_control. Supported by
 * 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 */
struct mip_3dm_pps_source_control_response {
    /** Source of the pulse. A value of enum mip_3dm_pps_source. */
    uint8_t source;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE 0x0CA8
/** Its descriptor. */
#define MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE_DESCRIPTOR 0xA8
/** Its name in the specification. */
#define MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE_NAME "3dm.pps_source_control_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_pps_source_control_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_pps_source_control_response_decode(
    struct mip_3dm_pps_source_control_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_pps_source_control_response_codec, 0xA8, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_pps_source_control_response_encode(
    const struct mip_3dm_pps_source_control_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_pps_source_control_response_codec, value, builder);
}

/**
 * Get Supported Events: command (0x0C,0x2A).
 *
 * Gets the types of event triggers or actions that the device supports, and the number of each.
 *
 * Response: mip_3dm_get_event_support_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
struct mip_3dm_get_event_support {
    /** Triggers or actions. A value of enum mip_3dm_event_support_query. */
    uint8_t query;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_EVENT_SUPPORT 0x0C2A
/** Its descriptor. */
#define MIP_3DM_GET_EVENT_SUPPORT_DESCRIPTOR 0x2A
/** Its name in the specification. */
#define MIP_3DM_GET_EVENT_SUPPORT_NAME "3dm.get_event_support"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_event_support_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_event_support_decode(struct mip_3dm_get_event_support *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_event_support_codec, 0x2A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_event_support_encode(
    const struct mip_3dm_get_event_support *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_event_support_codec, value, builder);
}

/**
 * Get Supported Events. Fills the structure and returns its address.
 *
 * - query: Triggers or actions. A value of enum mip_3dm_event_support_query.
 */
static inline struct mip_3dm_get_event_support *mip_3dm_get_event_support_make(
    struct mip_3dm_get_event_support *command, enum mip_3dm_event_support_query query) {
    memset(command, 0, sizeof(*command));
    command->query = (uint8_t)query;
    return command;
}

/**
 * Get Supported Events response: response (0x0C,0xB4).
 *
 * Response to mip_3dm_get_event_support. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
struct mip_3dm_get_event_support_response {
    /** Query specified in the command. A value of enum mip_3dm_event_support_query. */
    uint8_t query;
    /** Number of slots; instances are numbered from 1 to this. Unit: 1. */
    uint8_t max_instances;
    /** Number of types. Counts the elements of entries. */
    uint8_t num_entries;
    /**
     * The types. If query is MIP_3DM_EVENT_SUPPORT_QUERY_TRIGGER_TYPES: type has values of enum
     * mip_event_trigger_type. If query is MIP_3DM_EVENT_SUPPORT_QUERY_ACTION_TYPES: type has values
     * of enum mip_event_action_type.
     */
    struct mip_3dm_event_support_info entries[125];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_EVENT_SUPPORT_RESPONSE 0x0CB4
/** Its descriptor. */
#define MIP_3DM_GET_EVENT_SUPPORT_RESPONSE_DESCRIPTOR 0xB4
/** Its name in the specification. */
#define MIP_3DM_GET_EVENT_SUPPORT_RESPONSE_NAME "3dm.get_event_support_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_event_support_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_event_support_response_decode(
    struct mip_3dm_get_event_support_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_event_support_response_codec, 0xB4, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_event_support_response_encode(
    const struct mip_3dm_get_event_support_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_event_support_response_codec, value, builder);
}

/**
 * Event Control: command (0x0C,0x2B).
 *
 * Enables, disables or tests an event trigger.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_event_control_response.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * Triggers are disabled by default and after configuration.
 *
 * A trigger of type none cannot be enabled.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 */
struct mip_3dm_event_control {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Trigger instance; 0 means all configured triggers, except for read. */
    uint8_t instance;
    /**
     * New mode. A value of enum mip_event_trigger_mode. Default: MIP_EVENT_TRIGGER_MODE_DISABLED.
     * Required for write.
     */
    uint8_t mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_EVENT_CONTROL 0x0C2B
/** Its descriptor. */
#define MIP_3DM_EVENT_CONTROL_DESCRIPTOR 0x2B
/** Its name in the specification. */
#define MIP_3DM_EVENT_CONTROL_NAME "3dm.event_control"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_event_control_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_event_control_decode(struct mip_3dm_event_control *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_event_control_codec, 0x2B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_event_control_encode(
    const struct mip_3dm_event_control *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_event_control_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 * - mode: New mode. A value of enum mip_event_trigger_mode. Default:
 *   MIP_EVENT_TRIGGER_MODE_DISABLED. Required for write.
 */
static inline struct mip_3dm_event_control *mip_3dm_event_control_write(
    struct mip_3dm_event_control *command, uint8_t instance, enum mip_event_trigger_mode mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->instance = instance;
    command->mode = (uint8_t)mode;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_read(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_save(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->instance = instance;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_load(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->instance = instance;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all configured triggers, except for read.
 */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_default(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->instance = instance;
    return command;
}

/**
 * Event Control response: response (0x0C,0xB5).
 *
 * Response to mip_3dm_event_control. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 */
struct mip_3dm_event_control_response {
    /** Number of the trigger. */
    uint8_t instance;
    /**
     * Mode of the trigger. A value of enum mip_event_trigger_mode. Default:
     * MIP_EVENT_TRIGGER_MODE_DISABLED.
     */
    uint8_t mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_EVENT_CONTROL_RESPONSE 0x0CB5
/** Its descriptor. */
#define MIP_3DM_EVENT_CONTROL_RESPONSE_DESCRIPTOR 0xB5
/** Its name in the specification. */
#define MIP_3DM_EVENT_CONTROL_RESPONSE_NAME "3dm.event_control_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_event_control_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_event_control_response_decode(
    struct mip_3dm_event_control_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_event_control_response_codec, 0xB5, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_event_control_response_encode(
    const struct mip_3dm_event_control_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_event_control_response_codec, value, builder);
}

/**
 * Get Event Trigger Status: command (0x0C,0x2C).
 *
 * Gets the type and the state of event triggers.
 *
 * Response: mip_3dm_get_event_trigger_status_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
struct mip_3dm_get_event_trigger_status {
    /**
     * Number of requested triggers; 0 requests all slots. Counts the elements of
     * requested_instances.
     */
    uint8_t requested_count;
    /** Numbers of the triggers to report; none for all. */
    uint8_t requested_instances[252];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS 0x0C2C
/** Its descriptor. */
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_DESCRIPTOR 0x2C
/** Its name in the specification. */
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_NAME "3dm.get_event_trigger_status"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_event_trigger_status_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_event_trigger_status_decode(
    struct mip_3dm_get_event_trigger_status *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_event_trigger_status_codec, 0x2C, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_event_trigger_status_encode(
    const struct mip_3dm_get_event_trigger_status *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_event_trigger_status_codec, value, builder);
}

/**
 * Get Event Trigger Status. Fills the structure and returns its address.
 *
 * - requested_count: Number of requested triggers; 0 requests all slots. Counts the elements of
 *   requested_instances.
 * - requested_instances: Numbers of the triggers to report; none for all.
 */
static inline struct mip_3dm_get_event_trigger_status *mip_3dm_get_event_trigger_status_make(
    struct mip_3dm_get_event_trigger_status *command, uint8_t requested_count,
    const uint8_t requested_instances[]) {
    memset(command, 0, sizeof(*command));
    command->requested_count = requested_count;
    mip_copy(command->requested_instances, sizeof(command->requested_instances),
             requested_instances,
             mip_counted(requested_count, requested_instances, sizeof(requested_instances[0])));
    return command;
}

/**
 * Get Event Trigger Status response: response (0x0C,0xB6).
 *
 * Response to mip_3dm_get_event_trigger_status. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
struct mip_3dm_get_event_trigger_status_response {
    /** Number of entries. Counts the elements of triggers. */
    uint8_t count;
    /** One entry per trigger, in the requested order, or by instance if all were requested. */
    struct mip_3dm_event_trigger_status_entry triggers[126];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE 0x0CB6
/** Its descriptor. */
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE_DESCRIPTOR 0xB6
/** Its name in the specification. */
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE_NAME "3dm.get_event_trigger_status_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_event_trigger_status_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_event_trigger_status_response_decode(
    struct mip_3dm_get_event_trigger_status_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_event_trigger_status_response_codec, 0xB6, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_event_trigger_status_response_encode(
    const struct mip_3dm_get_event_trigger_status_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_event_trigger_status_response_codec, value, builder);
}

/**
 * Get Event Action Status: command (0x0C,0x2D).
 *
 * Gets the type and the trigger of event actions.
 *
 * Response: mip_3dm_get_event_action_status_response. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
struct mip_3dm_get_event_action_status {
    /**
     * Number of requested actions; 0 requests all slots. Counts the elements of
     * requested_instances.
     */
    uint8_t requested_count;
    /** Numbers of the actions to report; none for all. */
    uint8_t requested_instances[252];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_EVENT_ACTION_STATUS 0x0C2D
/** Its descriptor. */
#define MIP_3DM_GET_EVENT_ACTION_STATUS_DESCRIPTOR 0x2D
/** Its name in the specification. */
#define MIP_3DM_GET_EVENT_ACTION_STATUS_NAME "3dm.get_event_action_status"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_event_action_status_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_event_action_status_decode(
    struct mip_3dm_get_event_action_status *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_event_action_status_codec, 0x2D, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_event_action_status_encode(
    const struct mip_3dm_get_event_action_status *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_event_action_status_codec, value, builder);
}

/**
 * Get Event Action Status. Fills the structure and returns its address.
 *
 * - requested_count: Number of requested actions; 0 requests all slots. Counts the elements of
 *   requested_instances.
 * - requested_instances: Numbers of the actions to report; none for all.
 */
static inline struct mip_3dm_get_event_action_status *
mip_3dm_get_event_action_status_make(struct mip_3dm_get_event_action_status *command,
                                     uint8_t requested_count, const uint8_t requested_instances[]) {
    memset(command, 0, sizeof(*command));
    command->requested_count = requested_count;
    mip_copy(command->requested_instances, sizeof(command->requested_instances),
             requested_instances,
             mip_counted(requested_count, requested_instances, sizeof(requested_instances[0])));
    return command;
}

/**
 * Get Event Action Status response: response (0x0C,0xB7).
 *
 * Response to mip_3dm_get_event_action_status. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
struct mip_3dm_get_event_action_status_response {
    /** Number of entries. Counts the elements of actions. */
    uint8_t count;
    /** One entry per action, in the requested order, or by instance if all were requested. */
    struct mip_3dm_event_action_status_entry actions[126];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE 0x0CB7
/** Its descriptor. */
#define MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE_DESCRIPTOR 0xB7
/** Its name in the specification. */
#define MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE_NAME "3dm.get_event_action_status_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_event_action_status_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_event_action_status_response_decode(
    struct mip_3dm_get_event_action_status_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_event_action_status_response_codec, 0xB7, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_event_action_status_response_encode(
    const struct mip_3dm_get_event_action_status_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_event_action_status_response_codec, value, builder);
}

/** The member of mip_3dm_event_trigger_config that `type` selects. */
union mip_3dm_event_trigger_config_parameters {
    /** If type is MIP_EVENT_TRIGGER_TYPE_GPIO. Watches a GPIO pin. */
    struct mip_event_trigger_gpio gpio;
    /**
     * If type is MIP_EVENT_TRIGGER_TYPE_THRESHOLD. Compares one value of a data field with
     * thresholds.
     */
    struct mip_event_trigger_threshold threshold;
    /**
     * If type is MIP_EVENT_TRIGGER_TYPE_COMBINATION. Combines up to four other triggers in a truth
     * table.
     */
    struct mip_event_trigger_combination combination;
};

/**
 * Event Trigger Configuration: command (0x0C,0x2E).
 *
 * Configures the kind and the condition of an event trigger.
 *
 * Also called `event_trigger`. Functions: write, read, save, load and default. Response:
 * mip_3dm_event_trigger_config_response. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and
 * 3DM-CV7-GNSS/INS.
 *
 * The trigger is disabled afterwards; mip_3dm_event_control enables it.
 *
 * A GPIO trigger needs its pin configured by mip_3dm_gpio_config.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
struct mip_3dm_event_trigger_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Trigger instance; 0 means all (save, load, default). */
    uint8_t instance;
    /**
     * Kind of trigger. A value of enum mip_event_trigger_type. Default:
     * MIP_EVENT_TRIGGER_TYPE_NONE. Required for write.
     */
    uint8_t type;
    /**
     * The condition. Selected by type. Required for write. Empty if type is
     * MIP_EVENT_TRIGGER_TYPE_NONE.
     */
    union mip_3dm_event_trigger_config_parameters parameters;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_EVENT_TRIGGER_CONFIG 0x0C2E
/** Its descriptor. */
#define MIP_3DM_EVENT_TRIGGER_CONFIG_DESCRIPTOR 0x2E
/** Its name in the specification. */
#define MIP_3DM_EVENT_TRIGGER_CONFIG_NAME "3dm.event_trigger_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_event_trigger_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_event_trigger_config_decode(
    struct mip_3dm_event_trigger_config *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_event_trigger_config_codec, 0x2E, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_event_trigger_config_encode(
    const struct mip_3dm_event_trigger_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_event_trigger_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 * - type: Kind of trigger. A value of enum mip_event_trigger_type. Default:
 *   MIP_EVENT_TRIGGER_TYPE_NONE. Required for write.
 * - parameters: The condition. Selected by type. Required for write. Empty if type is
 *   MIP_EVENT_TRIGGER_TYPE_NONE.
 */
static inline struct mip_3dm_event_trigger_config *mip_3dm_event_trigger_config_write(
    struct mip_3dm_event_trigger_config *command, uint8_t instance,
    enum mip_event_trigger_type type,
    const union mip_3dm_event_trigger_config_parameters *parameters) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->instance = instance;
    command->type = (uint8_t)type;
    if (parameters != NULL) {
        command->parameters = *parameters;
    }
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_trigger_config *
mip_3dm_event_trigger_config_read(struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_trigger_config *
mip_3dm_event_trigger_config_save(struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->instance = instance;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_trigger_config *
mip_3dm_event_trigger_config_load(struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->instance = instance;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - instance: Trigger instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_trigger_config *mip_3dm_event_trigger_config_default(
    struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->instance = instance;
    return command;
}

/** The member of mip_3dm_event_trigger_config_response that `type` selects. */
union mip_3dm_event_trigger_config_response_parameters {
    /** If type is MIP_EVENT_TRIGGER_TYPE_GPIO. Watches a GPIO pin. */
    struct mip_event_trigger_gpio gpio;
    /**
     * If type is MIP_EVENT_TRIGGER_TYPE_THRESHOLD. Compares one value of a data field with
     * thresholds.
     */
    struct mip_event_trigger_threshold threshold;
    /**
     * If type is MIP_EVENT_TRIGGER_TYPE_COMBINATION. Combines up to four other triggers in a truth
     * table.
     */
    struct mip_event_trigger_combination combination;
};

/**
 * Event Trigger Configuration response: response (0x0C,0xB8).
 *
 * Also called `event_trigger_response`. Response to mip_3dm_event_trigger_config. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
struct mip_3dm_event_trigger_config_response {
    /** Number of the trigger. */
    uint8_t instance;
    /**
     * Kind of trigger. A value of enum mip_event_trigger_type. Default:
     * MIP_EVENT_TRIGGER_TYPE_NONE.
     */
    uint8_t type;
    /** The condition. Selected by type. Empty if type is MIP_EVENT_TRIGGER_TYPE_NONE. */
    union mip_3dm_event_trigger_config_response_parameters parameters;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE 0x0CB8
/** Its descriptor. */
#define MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE_DESCRIPTOR 0xB8
/** Its name in the specification. */
#define MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE_NAME "3dm.event_trigger_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_event_trigger_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_event_trigger_config_response_decode(
    struct mip_3dm_event_trigger_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_event_trigger_config_response_codec, 0xB8, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_event_trigger_config_response_encode(
    const struct mip_3dm_event_trigger_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_event_trigger_config_response_codec, value, builder);
}

/** The member of mip_3dm_event_action_config that `type` selects. */
union mip_3dm_event_action_config_parameters {
    /** If type is MIP_EVENT_ACTION_TYPE_GPIO. Controls a GPIO pin. */
    struct mip_event_action_gpio gpio;
    /** If type is MIP_EVENT_ACTION_TYPE_MESSAGE. Sends a data packet. */
    struct mip_event_action_message message;
};

/**
 * Event Action Configuration: command (0x0C,0x2F).
 *
 * Configures the trigger and the effect of an event action.
 *
 * Also called `event_action`. Functions: write, read, save, load and default. Response:
 * mip_3dm_event_action_config_response. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * A packet holds one descriptor set; for several sets use several actions with the same trigger.
 *
 * A GPIO action needs its pin configured as an output with the gpio feature.
 *
 * In each event cycle, the device updates all triggers first and then runs each action at most
 * once. The rate of the cycle is the base rate of the system data.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Event Cycle
 */
struct mip_3dm_event_action_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Action instance; 0 means all (save, load, default). */
    uint8_t instance;
    /** Trigger instance that the action follows. Required for write. */
    uint8_t trigger;
    /**
     * Kind of action. A value of enum mip_event_action_type. Default: MIP_EVENT_ACTION_TYPE_NONE.
     * Required for write.
     */
    uint8_t type;
    /**
     * Effect of the action. Selected by type. Required for write. Empty if type is
     * MIP_EVENT_ACTION_TYPE_NONE.
     */
    union mip_3dm_event_action_config_parameters parameters;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_EVENT_ACTION_CONFIG 0x0C2F
/** Its descriptor. */
#define MIP_3DM_EVENT_ACTION_CONFIG_DESCRIPTOR 0x2F
/** Its name in the specification. */
#define MIP_3DM_EVENT_ACTION_CONFIG_NAME "3dm.event_action_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_event_action_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_event_action_config_decode(
    struct mip_3dm_event_action_config *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_event_action_config_codec, 0x2F, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_event_action_config_encode(
    const struct mip_3dm_event_action_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_event_action_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 * - trigger: Trigger instance that the action follows. Required for write.
 * - type: Kind of action. A value of enum mip_event_action_type. Default:
 *   MIP_EVENT_ACTION_TYPE_NONE. Required for write.
 * - parameters: Effect of the action. Selected by type. Required for write. Empty if type is
 *   MIP_EVENT_ACTION_TYPE_NONE.
 */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_write(struct mip_3dm_event_action_config *command, uint8_t instance,
                                  uint8_t trigger, enum mip_event_action_type type,
                                  const union mip_3dm_event_action_config_parameters *parameters) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->instance = instance;
    command->trigger = trigger;
    command->type = (uint8_t)type;
    if (parameters != NULL) {
        command->parameters = *parameters;
    }
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_read(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_save(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->instance = instance;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_load(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->instance = instance;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - instance: Action instance; 0 means all (save, load, default).
 */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_default(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->instance = instance;
    return command;
}

/** The member of mip_3dm_event_action_config_response that `type` selects. */
union mip_3dm_event_action_config_response_parameters {
    /** If type is MIP_EVENT_ACTION_TYPE_GPIO. Controls a GPIO pin. */
    struct mip_event_action_gpio gpio;
    /** If type is MIP_EVENT_ACTION_TYPE_MESSAGE. Sends a data packet. */
    struct mip_event_action_message message;
};

/**
 * Event Action Configuration response: response (0x0C,0xB9).
 *
 * Also called `event_action_response`. Response to mip_3dm_event_action_config. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Event Cycle
 */
struct mip_3dm_event_action_config_response {
    /** Number of the action. */
    uint8_t instance;
    /** Trigger instance that the action follows. */
    uint8_t trigger;
    /**
     * Kind of action. A value of enum mip_event_action_type. Default: MIP_EVENT_ACTION_TYPE_NONE.
     */
    uint8_t type;
    /** Effect of the action. Selected by type. Empty if type is MIP_EVENT_ACTION_TYPE_NONE. */
    union mip_3dm_event_action_config_response_parameters parameters;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE 0x0CB9
/** Its descriptor. */
#define MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE_DESCRIPTOR 0xB9
/** Its name in the specification. */
#define MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE_NAME "3dm.event_action_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_event_action_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_event_action_config_response_decode(
    struct mip_3dm_event_action_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_event_action_config_response_codec, 0xB9, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_event_action_config_response_encode(
    const struct mip_3dm_event_action_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_event_action_config_response_codec, value, builder);
}

/**
 * Device Start Up Settings: command (0x0C,0x30).
 *
 * Saves, loads or resets all settings of the device at once.
 *
 * Functions: save, load and default. The device may take 2 s to reply. Supported by
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST.
 *
 * A save may disturb the data output for a short time.
 *
 * A save may take up to 1 s. Use a reply time-out of at least 2 s.
 *
 * - 3dm-gx5-15: 4.2.8 Device Startup Settings (0x0C, 0x30)
 * - 3dm-cv7-gnss-ins: Device Start Up Settings (0x0C,0x30)
 */
struct mip_3dm_device_settings {
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DEVICE_SETTINGS 0x0C30
/** Its descriptor. */
#define MIP_3DM_DEVICE_SETTINGS_DESCRIPTOR 0x30
/** Its name in the specification. */
#define MIP_3DM_DEVICE_SETTINGS_NAME "3dm.device_settings"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_settings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_settings_decode(struct mip_3dm_device_settings *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_settings_codec, 0x30, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_settings_encode(
    const struct mip_3dm_device_settings *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_settings_codec, value, builder);
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_device_settings *
mip_3dm_device_settings_save(struct mip_3dm_device_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_device_settings *
mip_3dm_device_settings_load(struct mip_3dm_device_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_device_settings *
mip_3dm_device_settings_default(struct mip_3dm_device_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Sensor-to-Vehicle Frame Transformation Euler: command (0x0C,0x31).
 *
 * Sets the mounting of the sensor in the vehicle as Euler angles.
 *
 * Also called `sensor_2_vehicle_transform_euler`. Functions: write, read, save, load and default.
 * Response: mip_3dm_sensor_to_vehicle_transform_euler_response. Changes mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion, mip_sensor_comp_euler_angles,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably changes mip_filter_data_comp_accel and
 * mip_sensor_comp_orientation_update_matrix. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * mip_3dm_sensor_to_vehicle_transform_quaternion and mip_3dm_sensor_to_vehicle_transform_dcm set
 * the same transformation; the value read back may be another form of it.
 *
 * Starting aligned with the vehicle frame, the sensor is rotated by yaw, pitch and roll about its
 * own z, y and x axes, in this order.
 *
 * `v_vehicle = Rz(yaw) * Ry(pitch) * Rx(roll) * v_sensor`
 *
 * Every change resets the complementary filter, the estimation filter and all low-pass filters.
 *
 * On some older devices the setting is the inverse rotation.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
 */
struct mip_3dm_sensor_to_vehicle_transform_euler {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Rotation about the x axis. Unit: rad. Required for write. */
    float roll;
    /** Rotation about the y axis. Unit: rad. Required for write. */
    float pitch;
    /** Rotation about the z axis. Unit: rad. Required for write. */
    float yaw;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER 0x0C31
/** Its descriptor. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_DESCRIPTOR 0x31
/** Its name in the specification. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_NAME "3dm.sensor_to_vehicle_transform_euler"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_to_vehicle_transform_euler_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_to_vehicle_transform_euler_decode(
    struct mip_3dm_sensor_to_vehicle_transform_euler *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_to_vehicle_transform_euler_codec, 0x31, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_euler_encode(
    const struct mip_3dm_sensor_to_vehicle_transform_euler *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_to_vehicle_transform_euler_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - roll: Rotation about the x axis. Unit: rad. Required for write.
 * - pitch: Rotation about the y axis. Unit: rad. Required for write.
 * - yaw: Rotation about the z axis. Unit: rad. Required for write.
 */
static inline struct mip_3dm_sensor_to_vehicle_transform_euler *
mip_3dm_sensor_to_vehicle_transform_euler_write(
    struct mip_3dm_sensor_to_vehicle_transform_euler *command, float roll, float pitch, float yaw) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->roll = roll;
    command->pitch = pitch;
    command->yaw = yaw;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_euler *
mip_3dm_sensor_to_vehicle_transform_euler_read(
    struct mip_3dm_sensor_to_vehicle_transform_euler *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_euler *
mip_3dm_sensor_to_vehicle_transform_euler_save(
    struct mip_3dm_sensor_to_vehicle_transform_euler *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_euler *
mip_3dm_sensor_to_vehicle_transform_euler_load(
    struct mip_3dm_sensor_to_vehicle_transform_euler *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_euler *
mip_3dm_sensor_to_vehicle_transform_euler_default(
    struct mip_3dm_sensor_to_vehicle_transform_euler *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Sensor-to-Vehicle Frame Transformation Euler response: response (0x0C,0xB1).
 *
 * Also called `sensor_2_vehicle_transform_euler_response`. Response to
 * mip_3dm_sensor_to_vehicle_transform_euler. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
 */
struct mip_3dm_sensor_to_vehicle_transform_euler_response {
    /** Rotation about the x axis. Unit: rad. */
    float roll;
    /** Rotation about the y axis. Unit: rad. */
    float pitch;
    /** Rotation about the z axis. Unit: rad. */
    float yaw;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE 0x0CB1
/** Its descriptor. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE_DESCRIPTOR 0xB1
/** Its name in the specification. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE_NAME \
    "3dm.sensor_to_vehicle_transform_euler_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_to_vehicle_transform_euler_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_to_vehicle_transform_euler_response_decode(
    struct mip_3dm_sensor_to_vehicle_transform_euler_response *value,
    const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_to_vehicle_transform_euler_response_codec, 0xB1, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_euler_response_encode(
    const struct mip_3dm_sensor_to_vehicle_transform_euler_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_to_vehicle_transform_euler_response_codec, value, builder);
}

/**
 * Sensor-to-Vehicle Frame Transformation Quaternion: command (0x0C,0x32).
 *
 * Sets the mounting of the sensor in the vehicle as a quaternion.
 *
 * Also called `sensor_2_vehicle_transform_quaternion`. Functions: write, read, save, load and
 * default. Response: mip_3dm_sensor_to_vehicle_transform_quaternion_response. Changes
 * mip_sensor_scaled_accel, mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta,
 * mip_sensor_delta_velocity, mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion,
 * mip_sensor_comp_euler_angles, mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm,
 * mip_filter_data_euler_angles, mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably changes mip_filter_data_comp_accel and
 * mip_sensor_comp_orientation_update_matrix. Supported by 3DM-CV7-GNSS/INS.
 *
 * mip_3dm_sensor_to_vehicle_transform_euler and mip_3dm_sensor_to_vehicle_transform_dcm set the
 * same transformation; the value read back may be another form of it.
 *
 * `p_vehicle = q^-1 * p_sensor * q`, where the vectors are quaternions with the scalar part 0. This
 * is the inverse of the quaternion that mip_filter_sensor_to_vehicle_quaternion accepts.
 *
 * Every change resets the complementary filter, the estimation filter and all low-pass filters.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
 */
struct mip_3dm_sensor_to_vehicle_transform_quaternion {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Unit quaternion that transforms vectors from the sensor frame to the vehicle frame. Elements:
     * w, x, y, z. Unit: 1. Required for write.
     */
    float q[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION 0x0C32
/** Its descriptor. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_DESCRIPTOR 0x32
/** Its name in the specification. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_NAME \
    "3dm.sensor_to_vehicle_transform_quaternion"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_to_vehicle_transform_quaternion_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_to_vehicle_transform_quaternion_decode(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_to_vehicle_transform_quaternion_codec, 0x32, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_quaternion_encode(
    const struct mip_3dm_sensor_to_vehicle_transform_quaternion *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_to_vehicle_transform_quaternion_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - q: Unit quaternion that transforms vectors from the sensor frame to the vehicle frame.
 *   Elements: w, x, y, z. Unit: 1. Required for write.
 */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_write(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command, const float q[4]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->q, q, sizeof(command->q));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_read(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_save(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_load(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_default(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Sensor-to-Vehicle Frame Transformation Quaternion response: response (0x0C,0xB2).
 *
 * Also called `sensor_2_vehicle_transform_quaternion_response`. Response to
 * mip_3dm_sensor_to_vehicle_transform_quaternion. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
 */
struct mip_3dm_sensor_to_vehicle_transform_quaternion_response {
    /**
     * Unit quaternion that transforms vectors from the sensor frame to the vehicle frame. Elements:
     * w, x, y, z. Unit: 1.
     */
    float q[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE 0x0CB2
/** Its descriptor. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE_DESCRIPTOR 0xB2
/** Its name in the specification. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE_NAME \
    "3dm.sensor_to_vehicle_transform_quaternion_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_to_vehicle_transform_quaternion_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_to_vehicle_transform_quaternion_response_decode(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion_response *value,
    const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_to_vehicle_transform_quaternion_response_codec, 0xB2,
                           value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_quaternion_response_encode(
    const struct mip_3dm_sensor_to_vehicle_transform_quaternion_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_to_vehicle_transform_quaternion_response_codec, value,
                      builder);
}

/**
 * Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix: command (0x0C,0x33).
 *
 * Sets the mounting of the sensor in the vehicle as a direction cosine matrix.
 *
 * Also called `sensor_2_vehicle_transform_dcm`. Functions: write, read, save, load and default.
 * Response: mip_3dm_sensor_to_vehicle_transform_dcm_response. Changes mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion, mip_sensor_comp_euler_angles,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably changes mip_filter_data_comp_accel and
 * mip_sensor_comp_orientation_update_matrix. Supported by 3DM-CV7-GNSS/INS.
 *
 * mip_3dm_sensor_to_vehicle_transform_euler and mip_3dm_sensor_to_vehicle_transform_quaternion set
 * the same transformation; the value read back may be another form of it.
 *
 * `v_vehicle = dcm * v_sensor`. This is the inverse of the matrix that
 * mip_filter_sensor_to_vehicle_rotation_dcm accepts.
 *
 * Every change resets the complementary filter, the estimation filter and all low-pass filters.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
 */
struct mip_3dm_sensor_to_vehicle_transform_dcm {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * The matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1. Required for write.
     */
    float dcm[9];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM 0x0C33
/** Its descriptor. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_DESCRIPTOR 0x33
/** Its name in the specification. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_NAME "3dm.sensor_to_vehicle_transform_dcm"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_to_vehicle_transform_dcm_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_to_vehicle_transform_dcm_decode(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_to_vehicle_transform_dcm_codec, 0x33, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_dcm_encode(
    const struct mip_3dm_sensor_to_vehicle_transform_dcm *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_to_vehicle_transform_dcm_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - dcm: The matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
 *   Unit: 1. Required for write.
 */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_write(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command, const float dcm[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->dcm, dcm, sizeof(command->dcm));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_read(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_save(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_load(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_default(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix response: response (0x0C,0xB3).
 *
 * Also called `sensor_2_vehicle_transform_dcm_response`. Response to
 * mip_3dm_sensor_to_vehicle_transform_dcm. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
 */
struct mip_3dm_sensor_to_vehicle_transform_dcm_response {
    /**
     * The matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit:
     * 1.
     */
    float dcm[9];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE 0x0CB3
/** Its descriptor. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE_DESCRIPTOR 0xB3
/** Its name in the specification. */
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE_NAME \
    "3dm.sensor_to_vehicle_transform_dcm_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_to_vehicle_transform_dcm_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_to_vehicle_transform_dcm_response_decode(
    struct mip_3dm_sensor_to_vehicle_transform_dcm_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_to_vehicle_transform_dcm_response_codec, 0xB3, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_to_vehicle_transform_dcm_response_encode(
    const struct mip_3dm_sensor_to_vehicle_transform_dcm_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_to_vehicle_transform_dcm_response_codec, value, builder);
}

/**
 * GPS dynamics mode: command (0x0C,0x34).
 *
 * Sets the dynamics that the GNSS receiver assumes of the vehicle.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_gps_dynamics_mode_response. Probably changes mip_gnss_data_llh_position and
 * mip_gnss_data_ned_velocity. Known only from the MIP SDK of 2014 and MicroStrain Communication
 * Library. Uncertain: Which devices support it. The SDK of 2014 uses it in its example for the
 * 3DM-GX3-35 only.
 *
 * - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
 * - mscl: GPS dynamics mode (0x0C,0x34)
 */
struct mip_3dm_gps_dynamics_mode {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Assumed dynamics. A value of enum mip_3dm_receiver_dynamics. Required for write. */
    uint8_t mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPS_DYNAMICS_MODE 0x0C34
/** Its descriptor. */
#define MIP_3DM_GPS_DYNAMICS_MODE_DESCRIPTOR 0x34
/** Its name in the specification. */
#define MIP_3DM_GPS_DYNAMICS_MODE_NAME "3dm.gps_dynamics_mode"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gps_dynamics_mode_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gps_dynamics_mode_decode(struct mip_3dm_gps_dynamics_mode *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gps_dynamics_mode_codec, 0x34, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gps_dynamics_mode_encode(
    const struct mip_3dm_gps_dynamics_mode *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gps_dynamics_mode_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - mode: Assumed dynamics. A value of enum mip_3dm_receiver_dynamics. Required for write.
 */
static inline struct mip_3dm_gps_dynamics_mode *mip_3dm_gps_dynamics_mode_write(
    struct mip_3dm_gps_dynamics_mode *command, enum mip_3dm_receiver_dynamics mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->mode = (uint8_t)mode;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_dynamics_mode *
mip_3dm_gps_dynamics_mode_read(struct mip_3dm_gps_dynamics_mode *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_dynamics_mode *
mip_3dm_gps_dynamics_mode_save(struct mip_3dm_gps_dynamics_mode *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_dynamics_mode *
mip_3dm_gps_dynamics_mode_load(struct mip_3dm_gps_dynamics_mode *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_dynamics_mode *
mip_3dm_gps_dynamics_mode_default(struct mip_3dm_gps_dynamics_mode *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * GPS dynamics mode response: response (0x0C,0x92).
 *
 * No device is known for certain to support it. Response to mip_3dm_gps_dynamics_mode. Known only
 * from the MIP SDK of 2014 and MicroStrain Communication Library.
 *
 * - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
 * - mscl: GPS dynamics mode (0x0C,0x34)
 */
struct mip_3dm_gps_dynamics_mode_response {
    /** Assumed dynamics. A value of enum mip_3dm_receiver_dynamics. */
    uint8_t mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE 0x0C92
/** Its descriptor. */
#define MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE_DESCRIPTOR 0x92
/** Its name in the specification. */
#define MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE_NAME "3dm.gps_dynamics_mode_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gps_dynamics_mode_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gps_dynamics_mode_response_decode(
    struct mip_3dm_gps_dynamics_mode_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gps_dynamics_mode_response_codec, 0x92, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gps_dynamics_mode_response_encode(
    const struct mip_3dm_gps_dynamics_mode_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gps_dynamics_mode_response_codec, value, builder);
}

/**
 * IMU signal conditioning: command (0x0C,0x35).
 *
 * Configures the filters and the orientation algorithm of 3-series devices.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_imu_signal_conditioning_response. Changes mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion and mip_sensor_comp_euler_angles.
 * Probably changes mip_sensor_scaled_mag. Known only from the MIP SDK of 2014 and MicroStrain
 * Communication Library. Uncertain: The ranges, the defaults, and some of the flags. They are those
 * of the single-byte protocol of the 3DM-GX3, which has the same record. Uncertain: Which devices
 * support it. The SDK of 2014 uses it in its example for the 3DM-GX3-35 only. Uncertain: Whether
 * every device sends `reserved` in the response. MSCL reads it without.
 *
 * The filters are moving averages; the first zero of their response is at 1000 Hz divided by the
 * width.
 *
 * - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
 * - mscl: IMU signal conditioning (0x0C,0x35)
 */
struct mip_3dm_imu_signal_conditioning {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Divisor of 1000 Hz that sets the rate at which the orientation is computed. Unit: 1. Range: 1
     * to 1000. Required for write.
     */
    uint16_t orientation_decimation;
    /** Processing steps. Default: 3. Required for write. */
    mip_3dm_data_conditioning_flags data_conditioning_flags;
    /**
     * Width of the accelerometer and gyroscope filter in samples. Unit: 1. Range: 1 to 32. Default:
     * 15. Required for write.
     */
    uint8_t inertial_filter_width;
    /**
     * Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32. Default: 17. Required
     * for write.
     */
    uint8_t mag_filter_width;
    /**
     * Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10.
     * Required for write.
     */
    uint16_t up_compensation;
    /**
     * Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. Required for
     * write.
     */
    uint16_t north_compensation;
    /**
     * Bandwidth of the magnetometer of 3-series devices. A value of enum mip_3dm_mag_bandwidth.
     * Required for write.
     */
    uint8_t mag_bandwidth;
    /** Reserved: send 0. Required for write. */
    uint16_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_SIGNAL_CONDITIONING 0x0C35
/** Its descriptor. */
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_DESCRIPTOR 0x35
/** Its name in the specification. */
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_NAME "3dm.imu_signal_conditioning"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_signal_conditioning_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_signal_conditioning_decode(
    struct mip_3dm_imu_signal_conditioning *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_signal_conditioning_codec, 0x35, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_signal_conditioning_encode(
    const struct mip_3dm_imu_signal_conditioning *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_signal_conditioning_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - orientation_decimation: Divisor of 1000 Hz that sets the rate at which the orientation is
 *   computed. Unit: 1. Range: 1 to 1000. Required for write.
 * - data_conditioning_flags: Processing steps. Default: 3. Required for write.
 * - inertial_filter_width: Width of the accelerometer and gyroscope filter in samples. Unit: 1.
 *   Range: 1 to 32. Default: 15. Required for write.
 * - mag_filter_width: Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32.
 *   Default: 17. Required for write.
 * - up_compensation: Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000.
 *   Default: 10. Required for write.
 * - north_compensation: Time constant of the heading correction. Unit: s. Range: 1 to 1000.
 *   Default: 10. Required for write.
 * - mag_bandwidth: Bandwidth of the magnetometer of 3-series devices. A value of enum
 *   mip_3dm_mag_bandwidth. Required for write.
 */
static inline struct mip_3dm_imu_signal_conditioning *mip_3dm_imu_signal_conditioning_write(
    struct mip_3dm_imu_signal_conditioning *command, uint16_t orientation_decimation,
    mip_3dm_data_conditioning_flags data_conditioning_flags, uint8_t inertial_filter_width,
    uint8_t mag_filter_width, uint16_t up_compensation, uint16_t north_compensation,
    enum mip_3dm_mag_bandwidth mag_bandwidth) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->orientation_decimation = orientation_decimation;
    command->data_conditioning_flags = data_conditioning_flags;
    command->inertial_filter_width = inertial_filter_width;
    command->mag_filter_width = mag_filter_width;
    command->up_compensation = up_compensation;
    command->north_compensation = north_compensation;
    command->mag_bandwidth = (uint8_t)mag_bandwidth;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_signal_conditioning *
mip_3dm_imu_signal_conditioning_read(struct mip_3dm_imu_signal_conditioning *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_signal_conditioning *
mip_3dm_imu_signal_conditioning_save(struct mip_3dm_imu_signal_conditioning *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_signal_conditioning *
mip_3dm_imu_signal_conditioning_load(struct mip_3dm_imu_signal_conditioning *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_imu_signal_conditioning *
mip_3dm_imu_signal_conditioning_default(struct mip_3dm_imu_signal_conditioning *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * IMU signal conditioning response: response (0x0C,0x86).
 *
 * No device is known for certain to support it. Response to mip_3dm_imu_signal_conditioning. Known
 * only from the MIP SDK of 2014 and MicroStrain Communication Library.
 *
 * - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
 * - mscl: IMU signal conditioning (0x0C,0x35)
 */
struct mip_3dm_imu_signal_conditioning_response {
    /**
     * Divisor of 1000 Hz that sets the rate at which the orientation is computed. Unit: 1. Range: 1
     * to 1000.
     */
    uint16_t orientation_decimation;
    /** Processing steps. Default: 3. */
    mip_3dm_data_conditioning_flags data_conditioning_flags;
    /**
     * Width of the accelerometer and gyroscope filter in samples. Unit: 1. Range: 1 to 32. Default:
     * 15.
     */
    uint8_t inertial_filter_width;
    /** Width of the magnetometer filter in samples. Unit: 1. Range: 1 to 32. Default: 17. */
    uint8_t mag_filter_width;
    /** Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10. */
    uint16_t up_compensation;
    /** Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. */
    uint16_t north_compensation;
    /** Bandwidth of the magnetometer of 3-series devices. A value of enum mip_3dm_mag_bandwidth. */
    uint8_t mag_bandwidth;
    /** Reserved. */
    uint16_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE 0x0C86
/** Its descriptor. */
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE_DESCRIPTOR 0x86
/** Its name in the specification. */
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE_NAME "3dm.imu_signal_conditioning_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_signal_conditioning_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_signal_conditioning_response_decode(
    struct mip_3dm_imu_signal_conditioning_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_signal_conditioning_response_codec, 0x86, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_signal_conditioning_response_encode(
    const struct mip_3dm_imu_signal_conditioning_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_signal_conditioning_response_codec, value, builder);
}

/**
 * IMU timestamp: command (0x0C,0x36).
 *
 * Sets or reads a time counter of the sensor data.
 *
 * No device is known for certain to support it. Functions: write and read. Response:
 * mip_3dm_imu_timestamp_response. Known only from the MIP SDK of 2014. Uncertain: Which devices
 * support it. The SDK of 2014 uses it in its example for the 3DM-GX3-35 only. Uncertain: Whether a
 * read includes `time`, which is ignored, or omits it, as is assumed.
 *
 * - mip-sdk-2014: IMU timestamp (0x0C,0x36)
 */
struct mip_3dm_imu_timestamp {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector. */
    uint8_t selector;
    /** Value of the counter, in the unit that `selector` selects. Required for write. */
    uint32_t time;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_TIMESTAMP 0x0C36
/** Its descriptor. */
#define MIP_3DM_IMU_TIMESTAMP_DESCRIPTOR 0x36
/** Its name in the specification. */
#define MIP_3DM_IMU_TIMESTAMP_NAME "3dm.imu_timestamp"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_timestamp_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_timestamp_decode(struct mip_3dm_imu_timestamp *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_timestamp_codec, 0x36, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_timestamp_encode(
    const struct mip_3dm_imu_timestamp *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_timestamp_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - selector: Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector.
 * - time: Value of the counter, in the unit that `selector` selects. Required for write.
 */
static inline struct mip_3dm_imu_timestamp *
mip_3dm_imu_timestamp_write(struct mip_3dm_imu_timestamp *command,
                            enum mip_3dm_imu_timestamp_selector selector, uint32_t time) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->selector = (uint8_t)selector;
    command->time = time;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - selector: Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector.
 */
static inline struct mip_3dm_imu_timestamp *mip_3dm_imu_timestamp_read(
    struct mip_3dm_imu_timestamp *command, enum mip_3dm_imu_timestamp_selector selector) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->selector = (uint8_t)selector;
    return command;
}

/**
 * IMU timestamp response: response (0x0C,0x93).
 *
 * No device is known for certain to support it. Response to mip_3dm_imu_timestamp. Known only from
 * the MIP SDK of 2014.
 *
 * - mip-sdk-2014: IMU timestamp (0x0C,0x36)
 */
struct mip_3dm_imu_timestamp_response {
    /** Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector. */
    uint8_t selector;
    /** Value of the counter, in the unit that `selector` selects. */
    uint32_t time;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_TIMESTAMP_RESPONSE 0x0C93
/** Its descriptor. */
#define MIP_3DM_IMU_TIMESTAMP_RESPONSE_DESCRIPTOR 0x93
/** Its name in the specification. */
#define MIP_3DM_IMU_TIMESTAMP_RESPONSE_NAME "3dm.imu_timestamp_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_timestamp_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_timestamp_response_decode(
    struct mip_3dm_imu_timestamp_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_timestamp_response_codec, 0x93, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_timestamp_response_encode(
    const struct mip_3dm_imu_timestamp_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_timestamp_response_codec, value, builder);
}

/**
 * Accelerometer Bias Configuration: command (0x0C,0x37).
 *
 * Sets the bias that is subtracted from the scaled acceleration.
 *
 * For advanced use. Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_accel_bias_response. Changes mip_sensor_scaled_accel. Probably changes
 * mip_sensor_delta_velocity and mip_filter_data_accel_bias. Supported by 3DM-CV7-GNSS/INS,
 * 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. On the 3DM-CV7-GNSS/INS:
 * write, read, save, load and default only.
 *
 * - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
 */
struct mip_3dm_accel_bias {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g.
     * Frame: sensor. Required for write and apply.
     */
    float bias[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_ACCEL_BIAS 0x0C37
/** Its descriptor. */
#define MIP_3DM_ACCEL_BIAS_DESCRIPTOR 0x37
/** Its name in the specification. */
#define MIP_3DM_ACCEL_BIAS_NAME "3dm.accel_bias"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_accel_bias_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_accel_bias_decode(struct mip_3dm_accel_bias *value,
                                                  const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_accel_bias_codec, 0x37, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_3dm_accel_bias_encode(const struct mip_3dm_accel_bias *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_accel_bias_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - bias: Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit:
 *   g. Frame: sensor. Required for write and apply.
 */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_write(struct mip_3dm_accel_bias *command, const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_read(struct mip_3dm_accel_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_save(struct mip_3dm_accel_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_load(struct mip_3dm_accel_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_default(struct mip_3dm_accel_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Apply the new setting without sending an ACK (5-series devices). Fills the structure and returns
 * its address.
 *
 * - bias: Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit:
 *   g. Frame: sensor. Required for write and apply.
 */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_apply(struct mip_3dm_accel_bias *command, const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/**
 * Accelerometer Bias Configuration response: response (0x0C,0x9A).
 *
 * Response to mip_3dm_accel_bias. Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
 */
struct mip_3dm_accel_bias_response {
    /**
     * Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g.
     * Frame: sensor.
     */
    float bias[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_ACCEL_BIAS_RESPONSE 0x0C9A
/** Its descriptor. */
#define MIP_3DM_ACCEL_BIAS_RESPONSE_DESCRIPTOR 0x9A
/** Its name in the specification. */
#define MIP_3DM_ACCEL_BIAS_RESPONSE_NAME "3dm.accel_bias_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_accel_bias_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_accel_bias_response_decode(
    struct mip_3dm_accel_bias_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_accel_bias_response_codec, 0x9A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_accel_bias_response_encode(
    const struct mip_3dm_accel_bias_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_accel_bias_response_codec, value, builder);
}

/**
 * Gyroscope Bias Configuration: command (0x0C,0x38).
 *
 * Sets the bias that is subtracted from the scaled angular rate.
 *
 * For advanced use. Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_gyro_bias_response. Changes mip_sensor_scaled_gyro. Probably changes
 * mip_sensor_delta_theta, mip_filter_data_gyro_bias and mip_filter_data_status. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and
 * 3DM-RQ1-45-ST. On the 3DM-CV7-AHRS: write, read, save, load and default only. On the 3DM-CV7-AR:
 * write, read, save, load and default only. On the 3DM-CV7-GNSS/INS: write, read, save, load and
 * default only.
 *
 * - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
 */
struct mip_3dm_gyro_bias {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
     * rad/s. Frame: sensor. Required for write and apply.
     */
    float bias[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GYRO_BIAS 0x0C38
/** Its descriptor. */
#define MIP_3DM_GYRO_BIAS_DESCRIPTOR 0x38
/** Its name in the specification. */
#define MIP_3DM_GYRO_BIAS_NAME "3dm.gyro_bias"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gyro_bias_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gyro_bias_decode(struct mip_3dm_gyro_bias *value,
                                                 const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gyro_bias_codec, 0x38, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gyro_bias_encode(const struct mip_3dm_gyro_bias *value,
                                                             struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gyro_bias_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - bias: Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
 *   rad/s. Frame: sensor. Required for write and apply.
 */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_write(struct mip_3dm_gyro_bias *command,
                                                                const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_read(struct mip_3dm_gyro_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_save(struct mip_3dm_gyro_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_load(struct mip_3dm_gyro_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gyro_bias *
mip_3dm_gyro_bias_default(struct mip_3dm_gyro_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Apply the new setting without sending an ACK (5-series devices). Fills the structure and returns
 * its address.
 *
 * - bias: Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
 *   rad/s. Frame: sensor. Required for write and apply.
 */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_apply(struct mip_3dm_gyro_bias *command,
                                                                const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/**
 * Gyroscope Bias Configuration response: response (0x0C,0x9B).
 *
 * The bias in use.
 *
 * Also called `capture_gyro_bias_response`. Response to mip_3dm_gyro_bias and
 * mip_3dm_capture_gyro_bias. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
 * 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
 */
struct mip_3dm_gyro_bias_response {
    /**
     * Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
     * rad/s. Frame: sensor.
     */
    float bias[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GYRO_BIAS_RESPONSE 0x0C9B
/** Its descriptor. */
#define MIP_3DM_GYRO_BIAS_RESPONSE_DESCRIPTOR 0x9B
/** Its name in the specification. */
#define MIP_3DM_GYRO_BIAS_RESPONSE_NAME "3dm.gyro_bias_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gyro_bias_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gyro_bias_response_decode(struct mip_3dm_gyro_bias_response *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gyro_bias_response_codec, 0x9B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gyro_bias_response_encode(
    const struct mip_3dm_gyro_bias_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gyro_bias_response_codec, value, builder);
}

/**
 * Capture Gyroscope Bias: command (0x0C,0x39).
 *
 * Averages the angular rate of the device at rest and uses the result as the gyroscope bias.
 *
 * Response: mip_3dm_gyro_bias_response. Changes mip_sensor_scaled_gyro. Probably changes
 * mip_sensor_delta_theta, mip_filter_data_gyro_bias and mip_filter_data_status. The device may take
 * 31 s to reply. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45,
 * 3DM-GQ7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * The device must be at rest, with as little vibration as possible, for the whole time.
 *
 * The reply arrives after the averaging time.
 *
 * The bias is not saved; to save it, send mip_3dm_gyro_bias with save.
 *
 * The 3DM-GX5-15 also initializes its orientation from the samples.
 *
 * - 3dm-gx5-15: 4.2.11 Capture Gyro Bias (0x0C, 0x39)
 * - 3dm-cv7-gnss-ins: Capture Gyroscope Bias (0x0C,0x39)
 */
struct mip_3dm_capture_gyro_bias {
    /** Time to average over. Unit: ms. Range: 1000 to 30000. */
    uint16_t averaging_time_ms;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_CAPTURE_GYRO_BIAS 0x0C39
/** Its descriptor. */
#define MIP_3DM_CAPTURE_GYRO_BIAS_DESCRIPTOR 0x39
/** Its name in the specification. */
#define MIP_3DM_CAPTURE_GYRO_BIAS_NAME "3dm.capture_gyro_bias"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_capture_gyro_bias_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_capture_gyro_bias_decode(struct mip_3dm_capture_gyro_bias *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_capture_gyro_bias_codec, 0x39, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_capture_gyro_bias_encode(
    const struct mip_3dm_capture_gyro_bias *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_capture_gyro_bias_codec, value, builder);
}

/**
 * Capture Gyroscope Bias. Fills the structure and returns its address.
 *
 * - averaging_time_ms: Time to average over. Unit: ms. Range: 1000 to 30000.
 */
static inline struct mip_3dm_capture_gyro_bias *mip_3dm_capture_gyro_bias_make(
    struct mip_3dm_capture_gyro_bias *command, uint16_t averaging_time_ms) {
    memset(command, 0, sizeof(*command));
    command->averaging_time_ms = averaging_time_ms;
    return command;
}

/**
 * Magnetometer Hard Iron Offset: command (0x0C,0x3A).
 *
 * Sets the offset that corrects the scaled magnetic field for hard iron.
 *
 * Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_mag_hard_iron_offset_response. Changes mip_sensor_scaled_mag. Supported by 3DM-CV7-AHRS,
 * 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. On the
 * 3DM-CV7-AHRS: write, read, save, load and default only. On the 3DM-CV7-AR: write, read, save,
 * load and default only. On the 3DM-CV7-GNSS/INS: write, read, save, load and default only.
 *
 * The values come from a calibration of the device as it is installed.
 *
 * On some devices, mip_filter_mag_capture_auto_calibration captures them from the filter's
 * automatic calibration.
 *
 * The device applies the correction before it sends mip_sensor_scaled_mag.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
 * - 3dm-gx5-45: (0x0C, 0x3A)
 */
struct mip_3dm_mag_hard_iron_offset {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit:
     * gauss. Frame: sensor. Required for write and apply. On the 3DM-GX5-45: default 0, 0, 0.
     */
    float offset[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_MAG_HARD_IRON_OFFSET 0x0C3A
/** Its descriptor. */
#define MIP_3DM_MAG_HARD_IRON_OFFSET_DESCRIPTOR 0x3A
/** Its name in the specification. */
#define MIP_3DM_MAG_HARD_IRON_OFFSET_NAME "3dm.mag_hard_iron_offset"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_mag_hard_iron_offset_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_mag_hard_iron_offset_decode(
    struct mip_3dm_mag_hard_iron_offset *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_mag_hard_iron_offset_codec, 0x3A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_mag_hard_iron_offset_encode(
    const struct mip_3dm_mag_hard_iron_offset *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_mag_hard_iron_offset_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - offset: Offset that the device subtracts from the measured magnetic field. Elements: x, y, z.
 *   Unit: gauss. Frame: sensor. Required for write and apply. On the 3DM-GX5-45: default 0, 0, 0.
 */
static inline struct mip_3dm_mag_hard_iron_offset *mip_3dm_mag_hard_iron_offset_write(
    struct mip_3dm_mag_hard_iron_offset *command, const float offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->offset, offset, sizeof(command->offset));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_hard_iron_offset *
mip_3dm_mag_hard_iron_offset_read(struct mip_3dm_mag_hard_iron_offset *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_hard_iron_offset *
mip_3dm_mag_hard_iron_offset_save(struct mip_3dm_mag_hard_iron_offset *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_hard_iron_offset *
mip_3dm_mag_hard_iron_offset_load(struct mip_3dm_mag_hard_iron_offset *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_hard_iron_offset *
mip_3dm_mag_hard_iron_offset_default(struct mip_3dm_mag_hard_iron_offset *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Apply the new setting without sending an ACK (5-series devices). Fills the structure and returns
 * its address.
 *
 * - offset: Offset that the device subtracts from the measured magnetic field. Elements: x, y, z.
 *   Unit: gauss. Frame: sensor. Required for write and apply. On the 3DM-GX5-45: default 0, 0, 0.
 */
static inline struct mip_3dm_mag_hard_iron_offset *mip_3dm_mag_hard_iron_offset_apply(
    struct mip_3dm_mag_hard_iron_offset *command, const float offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->offset, offset, sizeof(command->offset));
    return command;
}

/**
 * Magnetometer Hard Iron Offset response: response (0x0C,0x9C).
 *
 * Response to mip_3dm_mag_hard_iron_offset. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
 * - 3dm-gx5-45: (0x0C, 0x3A)
 */
struct mip_3dm_mag_hard_iron_offset_response {
    /**
     * Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit:
     * gauss. Frame: sensor.
     */
    float offset[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE 0x0C9C
/** Its descriptor. */
#define MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE_DESCRIPTOR 0x9C
/** Its name in the specification. */
#define MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE_NAME "3dm.mag_hard_iron_offset_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_mag_hard_iron_offset_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_mag_hard_iron_offset_response_decode(
    struct mip_3dm_mag_hard_iron_offset_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_mag_hard_iron_offset_response_codec, 0x9C, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_mag_hard_iron_offset_response_encode(
    const struct mip_3dm_mag_hard_iron_offset_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_mag_hard_iron_offset_response_codec, value, builder);
}

/**
 * Magnetometer Soft Iron Matrix: command (0x0C,0x3B).
 *
 * Sets the matrix that corrects the scaled magnetic field for soft iron.
 *
 * Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_mag_soft_iron_matrix_response. Changes mip_sensor_scaled_mag. Supported by 3DM-CV7-AHRS,
 * 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. On the
 * 3DM-CV7-AHRS: write, read, save, load and default only. On the 3DM-CV7-AR: write, read, save,
 * load and default only. On the 3DM-CV7-GNSS/INS: write, read, save, load and default only.
 *
 * The values come from a calibration of the device as it is installed.
 *
 * On some devices, mip_filter_mag_capture_auto_calibration captures them from the filter's
 * automatic calibration.
 *
 * The device applies the correction before it sends mip_sensor_scaled_mag.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
 * - 3dm-gx5-35: (0x0C, 0x3B)
 */
struct mip_3dm_mag_soft_iron_matrix {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Unit: 1. Frame: sensor. Required for write and apply.
     */
    float matrix[9];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_MAG_SOFT_IRON_MATRIX 0x0C3B
/** Its descriptor. */
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_DESCRIPTOR 0x3B
/** Its name in the specification. */
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_NAME "3dm.mag_soft_iron_matrix"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_mag_soft_iron_matrix_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_mag_soft_iron_matrix_decode(
    struct mip_3dm_mag_soft_iron_matrix *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_mag_soft_iron_matrix_codec, 0x3B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_mag_soft_iron_matrix_encode(
    const struct mip_3dm_mag_soft_iron_matrix *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_mag_soft_iron_matrix_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - matrix: Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32,
 *   m33. Unit: 1. Frame: sensor. Required for write and apply.
 */
static inline struct mip_3dm_mag_soft_iron_matrix *mip_3dm_mag_soft_iron_matrix_write(
    struct mip_3dm_mag_soft_iron_matrix *command, const float matrix[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->matrix, matrix, sizeof(command->matrix));
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_soft_iron_matrix *
mip_3dm_mag_soft_iron_matrix_read(struct mip_3dm_mag_soft_iron_matrix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_soft_iron_matrix *
mip_3dm_mag_soft_iron_matrix_save(struct mip_3dm_mag_soft_iron_matrix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_soft_iron_matrix *
mip_3dm_mag_soft_iron_matrix_load(struct mip_3dm_mag_soft_iron_matrix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_mag_soft_iron_matrix *
mip_3dm_mag_soft_iron_matrix_default(struct mip_3dm_mag_soft_iron_matrix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Apply the new setting without sending an ACK (5-series devices). Fills the structure and returns
 * its address.
 *
 * - matrix: Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32,
 *   m33. Unit: 1. Frame: sensor. Required for write and apply.
 */
static inline struct mip_3dm_mag_soft_iron_matrix *mip_3dm_mag_soft_iron_matrix_apply(
    struct mip_3dm_mag_soft_iron_matrix *command, const float matrix[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->matrix, matrix, sizeof(command->matrix));
    return command;
}

/**
 * Magnetometer Soft Iron Matrix response: response (0x0C,0x9D).
 *
 * Response to mip_3dm_mag_soft_iron_matrix. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR,
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
 * - 3dm-gx5-35: (0x0C, 0x3B)
 */
struct mip_3dm_mag_soft_iron_matrix_response {
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Unit: 1. Frame: sensor.
     */
    float matrix[9];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE 0x0C9D
/** Its descriptor. */
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE_DESCRIPTOR 0x9D
/** Its name in the specification. */
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE_NAME "3dm.mag_soft_iron_matrix_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_mag_soft_iron_matrix_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_mag_soft_iron_matrix_response_decode(
    struct mip_3dm_mag_soft_iron_matrix_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_mag_soft_iron_matrix_response_codec, 0x9D, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_mag_soft_iron_matrix_response_encode(
    const struct mip_3dm_mag_soft_iron_matrix_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_mag_soft_iron_matrix_response_codec, value, builder);
}

/**
 * Coning and Sculling Enable: command (0x0C,0x3E).
 *
 * Enables or disables coning and sculling compensation.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_3dm_coning_sculling_enable_response. Probably changes mip_sensor_delta_theta and
 * mip_sensor_delta_velocity. Supported by 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
 */
struct mip_3dm_coning_sculling_enable {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** True if the compensation is on. Default: true. Required for write. */
    mip_bool enable;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_CONING_SCULLING_ENABLE 0x0C3E
/** Its descriptor. */
#define MIP_3DM_CONING_SCULLING_ENABLE_DESCRIPTOR 0x3E
/** Its name in the specification. */
#define MIP_3DM_CONING_SCULLING_ENABLE_NAME "3dm.coning_sculling_enable"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_coning_sculling_enable_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_coning_sculling_enable_decode(
    struct mip_3dm_coning_sculling_enable *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_coning_sculling_enable_codec, 0x3E, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_coning_sculling_enable_encode(
    const struct mip_3dm_coning_sculling_enable *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_coning_sculling_enable_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - enable: True if the compensation is on. Default: true. Required for write.
 */
static inline struct mip_3dm_coning_sculling_enable *mip_3dm_coning_sculling_enable_write(
    struct mip_3dm_coning_sculling_enable *command, mip_bool enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = mip_truth(enable);
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_coning_sculling_enable *
mip_3dm_coning_sculling_enable_read(struct mip_3dm_coning_sculling_enable *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_coning_sculling_enable *
mip_3dm_coning_sculling_enable_save(struct mip_3dm_coning_sculling_enable *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_coning_sculling_enable *
mip_3dm_coning_sculling_enable_load(struct mip_3dm_coning_sculling_enable *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_coning_sculling_enable *
mip_3dm_coning_sculling_enable_default(struct mip_3dm_coning_sculling_enable *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Coning and Sculling Enable response: response (0x0C,0x9E).
 *
 * Response to mip_3dm_coning_sculling_enable. Supported by 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT
 * and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
 */
struct mip_3dm_coning_sculling_enable_response {
    /** True if the compensation is on. Default: true. */
    mip_bool enable;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE 0x0C9E
/** Its descriptor. */
#define MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE_DESCRIPTOR 0x9E
/** Its name in the specification. */
#define MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE_NAME "3dm.coning_sculling_enable_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_coning_sculling_enable_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_coning_sculling_enable_response_decode(
    struct mip_3dm_coning_sculling_enable_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_coning_sculling_enable_response_codec, 0x9E, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_coning_sculling_enable_response_encode(
    const struct mip_3dm_coning_sculling_enable_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_coning_sculling_enable_response_codec, value, builder);
}

/**
 * UART Baud Rate: command (0x0C,0x40).
 *
 * Sets the baud rate of the main port.
 *
 * Also called `uart_baudrate`. Functions: write, read, save, load and default. Response:
 * mip_3dm_uart_baud_rate_response. Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * The 3DM-GX5-15 replies at the old rate and accepts commands at the new rate 250 ms later.
 *
 * The 3DM-CV7 applies the rate when the port is empty, after at most 250 ms; until then, commands
 * and data may be lost.
 *
 * Set the device to idle first, send the command in a separate packet, and wait 250 ms afterwards.
 *
 * - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
 * - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
 */
struct mip_3dm_uart_baud_rate {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * New baud rate; the port must support it. Unit: Bd. Required for write. On the 3DM-GX5-15 and
     * 3DM-GX5-45: default 115200.
     */
    uint32_t baud;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_UART_BAUD_RATE 0x0C40
/** Its descriptor. */
#define MIP_3DM_UART_BAUD_RATE_DESCRIPTOR 0x40
/** Its name in the specification. */
#define MIP_3DM_UART_BAUD_RATE_NAME "3dm.uart_baud_rate"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_uart_baud_rate_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_uart_baud_rate_decode(struct mip_3dm_uart_baud_rate *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_uart_baud_rate_codec, 0x40, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_uart_baud_rate_encode(
    const struct mip_3dm_uart_baud_rate *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_uart_baud_rate_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - baud: New baud rate; the port must support it. Unit: Bd. Required for write. On the 3DM-GX5-15
 *   and 3DM-GX5-45: default 115200.
 */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_write(struct mip_3dm_uart_baud_rate *command, uint32_t baud) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->baud = baud;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_read(struct mip_3dm_uart_baud_rate *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_save(struct mip_3dm_uart_baud_rate *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_load(struct mip_3dm_uart_baud_rate *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_default(struct mip_3dm_uart_baud_rate *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * UART Baud Rate response: response (0x0C,0x87).
 *
 * Also called `uart_baudrate_response`. Response to mip_3dm_uart_baud_rate. Supported by
 * 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
 * - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
 */
struct mip_3dm_uart_baud_rate_response {
    /** New baud rate; the port must support it. Unit: Bd. */
    uint32_t baud;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_UART_BAUD_RATE_RESPONSE 0x0C87
/** Its descriptor. */
#define MIP_3DM_UART_BAUD_RATE_RESPONSE_DESCRIPTOR 0x87
/** Its name in the specification. */
#define MIP_3DM_UART_BAUD_RATE_RESPONSE_NAME "3dm.uart_baud_rate_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_uart_baud_rate_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_uart_baud_rate_response_decode(
    struct mip_3dm_uart_baud_rate_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_uart_baud_rate_response_codec, 0x87, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_uart_baud_rate_response_encode(
    const struct mip_3dm_uart_baud_rate_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_uart_baud_rate_response_codec, value, builder);
}

/**
 * GPIO Configuration: command (0x0C,0x41).
 *
 * Sets the use of a GPIO pin.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gpio_config_response. Probably
 * changes mip_system_data_gpio_state and mip_system_data_gpio_analog_value. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * Not every pin has every feature.
 *
 * For an output with a feature other than gpio, configure the function that drives it before the
 * pin; otherwise, the level of the pin is undefined in the meantime. For an input, configure the
 * pin before the function that uses it.
 *
 * If only one pin can have a configuration, the last pin configured gets it, and the earlier pin is
 * reset.
 *
 * With NMEA input at most one pin may be a UART input; set it to unused before another one takes
 * over.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 */
struct mip_3dm_gpio_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** GPIO pin, counted from 1; 0 means all pins (save, load, default). */
    uint8_t pin;
    /**
     * Use of the pin. A value of enum mip_gpio_feature. Default: MIP_GPIO_FEATURE_UNUSED. Required
     * for write.
     */
    uint8_t feature;
    /**
     * Role of the pin within the feature; 0 if the feature has no roles. Required for write. If
     * feature is MIP_GPIO_FEATURE_UNUSED: values of enum mip_gpio_unused_behavior. If feature is
     * MIP_GPIO_FEATURE_GPIO: values of enum mip_gpio_behavior. If feature is MIP_GPIO_FEATURE_PPS:
     * values of enum mip_gpio_pps_behavior. If feature is MIP_GPIO_FEATURE_ENCODER: values of enum
     * mip_gpio_encoder_behavior. If feature is MIP_GPIO_FEATURE_TIMESTAMP: values of enum
     * mip_gpio_timestamp_behavior. If feature is MIP_GPIO_FEATURE_UART: values of enum
     * mip_gpio_uart_behavior.
     */
    uint8_t behavior;
    /** Electrical options. Required for write. */
    mip_gpio_pin_mode pin_mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPIO_CONFIG 0x0C41
/** Its descriptor. */
#define MIP_3DM_GPIO_CONFIG_DESCRIPTOR 0x41
/** Its name in the specification. */
#define MIP_3DM_GPIO_CONFIG_NAME "3dm.gpio_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gpio_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gpio_config_decode(struct mip_3dm_gpio_config *value,
                                                   const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gpio_config_codec, 0x41, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_3dm_gpio_config_encode(const struct mip_3dm_gpio_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gpio_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 * - feature: Use of the pin. A value of enum mip_gpio_feature. Default: MIP_GPIO_FEATURE_UNUSED.
 *   Required for write.
 * - behavior: Role of the pin within the feature; 0 if the feature has no roles. Required for
 *   write. If feature is MIP_GPIO_FEATURE_UNUSED: values of enum mip_gpio_unused_behavior. If
 *   feature is MIP_GPIO_FEATURE_GPIO: values of enum mip_gpio_behavior. If feature is
 *   MIP_GPIO_FEATURE_PPS: values of enum mip_gpio_pps_behavior. If feature is
 *   MIP_GPIO_FEATURE_ENCODER: values of enum mip_gpio_encoder_behavior. If feature is
 *   MIP_GPIO_FEATURE_TIMESTAMP: values of enum mip_gpio_timestamp_behavior. If feature is
 *   MIP_GPIO_FEATURE_UART: values of enum mip_gpio_uart_behavior.
 * - pin_mode: Electrical options. Required for write.
 */
static inline struct mip_3dm_gpio_config *mip_3dm_gpio_config_write(
    struct mip_3dm_gpio_config *command, uint8_t pin, enum mip_gpio_feature feature,
    uint8_t behavior, mip_gpio_pin_mode pin_mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->pin = pin;
    command->feature = (uint8_t)feature;
    command->behavior = behavior;
    command->pin_mode = pin_mode;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_read(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->pin = pin;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_save(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->pin = pin;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_load(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->pin = pin;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1; 0 means all pins (save, load, default).
 */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_default(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->pin = pin;
    return command;
}

/**
 * GPIO Configuration response: response (0x0C,0xC1).
 *
 * Response to mip_3dm_gpio_config. Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
 */
struct mip_3dm_gpio_config_response {
    /** GPIO pin, counted from 1. */
    uint8_t pin;
    /** Use of the pin. A value of enum mip_gpio_feature. Default: MIP_GPIO_FEATURE_UNUSED. */
    uint8_t feature;
    /**
     * Role of the pin within the feature; 0 if the feature has no roles. If feature is
     * MIP_GPIO_FEATURE_UNUSED: values of enum mip_gpio_unused_behavior. If feature is
     * MIP_GPIO_FEATURE_GPIO: values of enum mip_gpio_behavior. If feature is MIP_GPIO_FEATURE_PPS:
     * values of enum mip_gpio_pps_behavior. If feature is MIP_GPIO_FEATURE_ENCODER: values of enum
     * mip_gpio_encoder_behavior. If feature is MIP_GPIO_FEATURE_TIMESTAMP: values of enum
     * mip_gpio_timestamp_behavior. If feature is MIP_GPIO_FEATURE_UART: values of enum
     * mip_gpio_uart_behavior.
     */
    uint8_t behavior;
    /** Electrical options. */
    mip_gpio_pin_mode pin_mode;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPIO_CONFIG_RESPONSE 0x0CC1
/** Its descriptor. */
#define MIP_3DM_GPIO_CONFIG_RESPONSE_DESCRIPTOR 0xC1
/** Its name in the specification. */
#define MIP_3DM_GPIO_CONFIG_RESPONSE_NAME "3dm.gpio_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gpio_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gpio_config_response_decode(
    struct mip_3dm_gpio_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gpio_config_response_codec, 0xC1, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gpio_config_response_encode(
    const struct mip_3dm_gpio_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gpio_config_response_codec, value, builder);
}

/**
 * GPIO State: command (0x0C,0x42).
 *
 * Sets or reads the state of a GPIO pin.
 *
 * Functions: write and read. Response: mip_3dm_gpio_state_response. Changes
 * mip_system_data_gpio_state. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * A read returns the level of the pin itself.
 *
 * A write has an effect only on a pin that is configured as an output.
 *
 * An event action of mode `active_high` or `active_low` on the pin overrides the written state.
 *
 * Reading is guaranteed to work only with the gpio feature.
 *
 * mip_3dm_gpio_config determines the state at power-up.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
 */
struct mip_3dm_gpio_state {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t pin;
    /** True means high. Required for write. */
    mip_bool state;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPIO_STATE 0x0C42
/** Its descriptor. */
#define MIP_3DM_GPIO_STATE_DESCRIPTOR 0x42
/** Its name in the specification. */
#define MIP_3DM_GPIO_STATE_NAME "3dm.gpio_state"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gpio_state_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gpio_state_decode(struct mip_3dm_gpio_state *value,
                                                  const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gpio_state_codec, 0x42, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_3dm_gpio_state_encode(const struct mip_3dm_gpio_state *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gpio_state_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1. Range: at least 1.
 * - state: True means high. Required for write.
 */
static inline struct mip_3dm_gpio_state *
mip_3dm_gpio_state_write(struct mip_3dm_gpio_state *command, uint8_t pin, mip_bool state) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->pin = pin;
    command->state = mip_truth(state);
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - pin: GPIO pin, counted from 1. Range: at least 1.
 */
static inline struct mip_3dm_gpio_state *mip_3dm_gpio_state_read(struct mip_3dm_gpio_state *command,
                                                                 uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->pin = pin;
    return command;
}

/**
 * GPIO State response: response (0x0C,0xC2).
 *
 * Response to mip_3dm_gpio_state. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
 */
struct mip_3dm_gpio_state_response {
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t pin;
    /** True means high. */
    mip_bool state;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPIO_STATE_RESPONSE 0x0CC2
/** Its descriptor. */
#define MIP_3DM_GPIO_STATE_RESPONSE_DESCRIPTOR 0xC2
/** Its name in the specification. */
#define MIP_3DM_GPIO_STATE_RESPONSE_NAME "3dm.gpio_state_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gpio_state_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gpio_state_response_decode(
    struct mip_3dm_gpio_state_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gpio_state_response_codec, 0xC2, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gpio_state_response_encode(
    const struct mip_3dm_gpio_state_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gpio_state_response_codec, value, builder);
}

/**
 * Odometer Configuration: command (0x0C,0x43).
 *
 * Configures the input from a wheel encoder.
 *
 * Also called `odometer`. Functions: write, read, save, load and default. Response:
 * mip_3dm_odometer_config_response. Changes mip_sensor_odometer. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
struct mip_3dm_odometer_config {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Operation of the input. A value of enum mip_3dm_odometer_mode. Required for write. */
    uint8_t mode;
    /**
     * Pulses per distance travelled; negative if the encoder rotates backwards. Unit: pulse/m.
     * Required for write.
     *
     * Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
     */
    float scaling;
    /**
     * Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. Required for write.
     */
    float uncertainty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_ODOMETER_CONFIG 0x0C43
/** Its descriptor. */
#define MIP_3DM_ODOMETER_CONFIG_DESCRIPTOR 0x43
/** Its name in the specification. */
#define MIP_3DM_ODOMETER_CONFIG_NAME "3dm.odometer_config"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_odometer_config_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_odometer_config_decode(struct mip_3dm_odometer_config *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_odometer_config_codec, 0x43, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_odometer_config_encode(
    const struct mip_3dm_odometer_config *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_odometer_config_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - mode: Operation of the input. A value of enum mip_3dm_odometer_mode. Required for write.
 * - scaling: Pulses per distance travelled; negative if the encoder rotates backwards. Unit:
 *   pulse/m. Required for write. Pulses on line A per turn of the wheel, divided by the
 *   circumference of the wheel.
 * - uncertainty: Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. Required
 *   for write.
 */
static inline struct mip_3dm_odometer_config *
mip_3dm_odometer_config_write(struct mip_3dm_odometer_config *command,
                              enum mip_3dm_odometer_mode mode, float scaling, float uncertainty) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->mode = (uint8_t)mode;
    command->scaling = scaling;
    command->uncertainty = uncertainty;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_odometer_config *
mip_3dm_odometer_config_read(struct mip_3dm_odometer_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_odometer_config *
mip_3dm_odometer_config_save(struct mip_3dm_odometer_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_odometer_config *
mip_3dm_odometer_config_load(struct mip_3dm_odometer_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_odometer_config *
mip_3dm_odometer_config_default(struct mip_3dm_odometer_config *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Odometer Configuration response: response (0x0C,0xC3).
 *
 * Also called `odometer_response`. Response to mip_3dm_odometer_config. Supported by
 * 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
struct mip_3dm_odometer_config_response {
    /** Operation of the input. A value of enum mip_3dm_odometer_mode. */
    uint8_t mode;
    /**
     * Pulses per distance travelled; negative if the encoder rotates backwards. Unit: pulse/m.
     *
     * Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
     */
    float scaling;
    /** Relative uncertainty of the scaling, 1 sigma. Unit: 1. Range: at least 0. */
    float uncertainty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_ODOMETER_CONFIG_RESPONSE 0x0CC3
/** Its descriptor. */
#define MIP_3DM_ODOMETER_CONFIG_RESPONSE_DESCRIPTOR 0xC3
/** Its name in the specification. */
#define MIP_3DM_ODOMETER_CONFIG_RESPONSE_NAME "3dm.odometer_config_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_odometer_config_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_odometer_config_response_decode(
    struct mip_3dm_odometer_config_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_odometer_config_response_codec, 0xC3, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_odometer_config_response_encode(
    const struct mip_3dm_odometer_config_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_odometer_config_response_codec, value, builder);
}

/**
 * Advanced Low-Pass Filter Settings: command (0x0C,0x50).
 *
 * Configures the low-pass filter of one sensor data quantity.
 *
 * For advanced use. Also called `imu_lowpass_filter`. Functions: write, read, save, load and
 * default. Response: mip_3dm_imu_low_pass_filter_response. Changes mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag and mip_sensor_scaled_pressure. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST. Deprecated on the 3DM-CV7-AHRS: use mip_3dm_low_pass_filter
 * instead. Deprecated on the 3DM-CV7-AR: use mip_3dm_low_pass_filter instead. Deprecated on the
 * 3DM-CV7-GNSS/INS: use mip_3dm_low_pass_filter instead. Deprecated on the 3DM-GQ7-GNSS/INS: use
 * mip_3dm_low_pass_filter instead. On the 3DM-CV7-AHRS: firmware <= 1.0.07. On the 3DM-CV7-AR:
 * firmware <= 1.0.07. On the 3DM-GQ7-GNSS/INS: firmware <= 1.0.10.
 *
 * The filter has one pole. By default it is on and its cutoff is half the rate of the message
 * format.
 *
 * - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
 * - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
 */
struct mip_3dm_imu_low_pass_filter {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
     * magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
     * 3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
     * rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
     */
    uint8_t target_descriptor;
    /** True if the quantity is filtered. Default: true. Required for write. */
    mip_bool enable;
    /**
     * True uses `frequency`; false uses half the rate of the message format. Default: false.
     * Required for write.
     */
    mip_bool manual;
    /**
     * Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. Required for write. On the
     * 3DM-GX5-15: range at most 250.
     */
    uint16_t frequency;
    /** Reserved: send 0. Required for write. */
    uint8_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_LOW_PASS_FILTER 0x0C50
/** Its descriptor. */
#define MIP_3DM_IMU_LOW_PASS_FILTER_DESCRIPTOR 0x50
/** Its name in the specification. */
#define MIP_3DM_IMU_LOW_PASS_FILTER_NAME "3dm.imu_low_pass_filter"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_low_pass_filter_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_low_pass_filter_decode(
    struct mip_3dm_imu_low_pass_filter *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_low_pass_filter_codec, 0x50, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_low_pass_filter_encode(
    const struct mip_3dm_imu_low_pass_filter *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_low_pass_filter_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 * - enable: True if the quantity is filtered. Default: true. Required for write.
 * - manual: True uses `frequency`; false uses half the rate of the message format. Default: false.
 *   Required for write.
 * - frequency: Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. Required for
 *   write. On the 3DM-GX5-15: range at most 250.
 */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_write(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor, mip_bool enable,
    mip_bool manual, uint16_t frequency) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->target_descriptor = target_descriptor;
    command->enable = mip_truth(enable);
    command->manual = mip_truth(manual);
    command->frequency = frequency;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_read(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->target_descriptor = target_descriptor;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_save(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->target_descriptor = target_descriptor;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_load(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->target_descriptor = target_descriptor;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - target_descriptor: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET. On the
 *   3DM-CV7-GNSS/INS: Field descriptor in the sensor data set: scaled acceleration 0x04, angular
 *   rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for read.
 */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_default(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->target_descriptor = target_descriptor;
    return command;
}

/**
 * Advanced Low-Pass Filter Settings response: response (0x0C,0x8B).
 *
 * Also called `imu_lowpass_filter_response`. Response to mip_3dm_imu_low_pass_filter. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-15,
 * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
 * - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
 */
struct mip_3dm_imu_low_pass_filter_response {
    /**
     * Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
     * magnetic field 0x06 or pressure 0x17. Refers to fields of MIP_SENSOR_SET.
     */
    uint8_t target_descriptor;
    /** True if the quantity is filtered. Default: true. */
    mip_bool enable;
    /** True uses `frequency`; false uses half the rate of the message format. Default: false. */
    mip_bool manual;
    /** Cutoff (-3 dB). It has no meaning if `manual` is false. Unit: Hz. */
    uint16_t frequency;
    /** Reserved. */
    uint8_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE 0x0C8B
/** Its descriptor. */
#define MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR 0x8B
/** Its name in the specification. */
#define MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE_NAME "3dm.imu_low_pass_filter_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_imu_low_pass_filter_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_imu_low_pass_filter_response_decode(
    struct mip_3dm_imu_low_pass_filter_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_imu_low_pass_filter_response_codec, 0x8B, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_imu_low_pass_filter_response_encode(
    const struct mip_3dm_imu_low_pass_filter_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_imu_low_pass_filter_response_codec, value, builder);
}

/**
 * Complementary Filter Configuration: command (0x0C,0x51).
 *
 * Configures the complementary filter, which computes the attitude independently of the estimation
 * filter.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_complementary_filter_response.
 * Changes mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion and
 * mip_sensor_comp_euler_angles. Probably changes mip_sensor_north_vector and mip_sensor_up_vector.
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35.
 *
 * Pitch and roll follow the accelerometers, on the assumption that the mean acceleration is zero.
 *
 * The heading follows the magnetometer, if the device has one.
 *
 * The device rejects time constants out of range.
 *
 * The attitude of the estimation filter is better; the 3DM-GX5-15 keeps this filter for
 * compatibility.
 *
 * - 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
 * - 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
 */
struct mip_3dm_complementary_filter {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * True enables the pitch and roll correction, which 5-series manuals call up compensation.
     * Required for write. On the 3DM-GX5-15: default true.
     */
    mip_bool pitch_roll_enable;
    /**
     * True enables the heading correction, which 5-series manuals call north compensation. Required
     * for write. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10 and 3DM-CX5-15: MSCL has no support for
     * it. On the 3DM-GX5-15: default true.
     */
    mip_bool heading_enable;
    /**
     * Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10.
     * Required for write.
     */
    float pitch_roll_time_constant;
    /**
     * Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. Required for
     * write.
     */
    float heading_time_constant;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_COMPLEMENTARY_FILTER 0x0C51
/** Its descriptor. */
#define MIP_3DM_COMPLEMENTARY_FILTER_DESCRIPTOR 0x51
/** Its name in the specification. */
#define MIP_3DM_COMPLEMENTARY_FILTER_NAME "3dm.complementary_filter"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_complementary_filter_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_complementary_filter_decode(
    struct mip_3dm_complementary_filter *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_complementary_filter_codec, 0x51, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_complementary_filter_encode(
    const struct mip_3dm_complementary_filter *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_complementary_filter_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - pitch_roll_enable: True enables the pitch and roll correction, which 5-series manuals call up
 *   compensation. Required for write. On the 3DM-GX5-15: default true.
 * - heading_enable: True enables the heading correction, which 5-series manuals call north
 *   compensation. Required for write. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CX5-10 and 3DM-CX5-15:
 *   MSCL has no support for it. On the 3DM-GX5-15: default true.
 * - pitch_roll_time_constant: Time constant of the pitch and roll correction. Unit: s. Range: 1 to
 *   1000. Default: 10. Required for write.
 * - heading_time_constant: Time constant of the heading correction. Unit: s. Range: 1 to 1000.
 *   Default: 10. Required for write.
 */
static inline struct mip_3dm_complementary_filter *mip_3dm_complementary_filter_write(
    struct mip_3dm_complementary_filter *command, mip_bool pitch_roll_enable,
    mip_bool heading_enable, float pitch_roll_time_constant, float heading_time_constant) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->pitch_roll_enable = mip_truth(pitch_roll_enable);
    command->heading_enable = mip_truth(heading_enable);
    command->pitch_roll_time_constant = pitch_roll_time_constant;
    command->heading_time_constant = heading_time_constant;
    return command;
}

/** Return the current setting in a response. Fills the structure and returns its address. */
static inline struct mip_3dm_complementary_filter *
mip_3dm_complementary_filter_read(struct mip_3dm_complementary_filter *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_complementary_filter *
mip_3dm_complementary_filter_save(struct mip_3dm_complementary_filter *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_complementary_filter *
mip_3dm_complementary_filter_load(struct mip_3dm_complementary_filter *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_complementary_filter *
mip_3dm_complementary_filter_default(struct mip_3dm_complementary_filter *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Complementary Filter Configuration response: response (0x0C,0x97).
 *
 * Response to mip_3dm_complementary_filter. Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15
 * and 3DM-GX5-35.
 *
 * - 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
 * - 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
 */
struct mip_3dm_complementary_filter_response {
    /** True enables the pitch and roll correction, which 5-series manuals call up compensation. */
    mip_bool pitch_roll_enable;
    /** True enables the heading correction, which 5-series manuals call north compensation. */
    mip_bool heading_enable;
    /** Time constant of the pitch and roll correction. Unit: s. Range: 1 to 1000. Default: 10. */
    float pitch_roll_time_constant;
    /** Time constant of the heading correction. Unit: s. Range: 1 to 1000. Default: 10. */
    float heading_time_constant;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE 0x0C97
/** Its descriptor. */
#define MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE_DESCRIPTOR 0x97
/** Its name in the specification. */
#define MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE_NAME "3dm.complementary_filter_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_complementary_filter_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_complementary_filter_response_decode(
    struct mip_3dm_complementary_filter_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_complementary_filter_response_codec, 0x97, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_complementary_filter_response_encode(
    const struct mip_3dm_complementary_filter_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_complementary_filter_response_codec, value, builder);
}

/**
 * Sensor Range: command (0x0C,0x52).
 *
 * Sets the measuring range of a sensor.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_sensor_range_response. Probably
 * changes mip_sensor_scaled_accel, mip_sensor_scaled_gyro and mip_sensor_overrange_status.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * mip_3dm_get_calibrated_sensor_ranges lists the settings. The device may reject other settings, or
 * measure incorrectly with them.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
struct mip_3dm_sensor_range {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. */
    uint8_t sensor;
    /** Number of the range. Required for write. */
    uint8_t setting;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_RANGE 0x0C52
/** Its descriptor. */
#define MIP_3DM_SENSOR_RANGE_DESCRIPTOR 0x52
/** Its name in the specification. */
#define MIP_3DM_SENSOR_RANGE_NAME "3dm.sensor_range"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_range_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_range_decode(struct mip_3dm_sensor_range *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_range_codec, 0x52, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_3dm_sensor_range_encode(const struct mip_3dm_sensor_range *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_range_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type.
 * - setting: Number of the range. Required for write.
 */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_write(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor, uint8_t setting) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->sensor = (uint8_t)sensor;
    command->setting = setting;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type.
 */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_read(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type.
 */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_save(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type.
 */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_load(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - sensor: Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type.
 */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_default(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Sensor Range response: response (0x0C,0xD2).
 *
 * Response to mip_3dm_sensor_range. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
struct mip_3dm_sensor_range_response {
    /** Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. */
    uint8_t sensor;
    /** Number of the range. */
    uint8_t setting;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_SENSOR_RANGE_RESPONSE 0x0CD2
/** Its descriptor. */
#define MIP_3DM_SENSOR_RANGE_RESPONSE_DESCRIPTOR 0xD2
/** Its name in the specification. */
#define MIP_3DM_SENSOR_RANGE_RESPONSE_NAME "3dm.sensor_range_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_sensor_range_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_sensor_range_response_decode(
    struct mip_3dm_sensor_range_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_sensor_range_response_codec, 0xD2, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_sensor_range_response_encode(
    const struct mip_3dm_sensor_range_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_sensor_range_response_codec, value, builder);
}

/**
 * Get Calibrated Sensor Ranges: command (0x0C,0x53).
 *
 * Gets the ranges that a sensor supports.
 *
 * Also called `calibrated_sensor_ranges`. Response: mip_3dm_get_calibrated_sensor_ranges_response.
 * Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
struct mip_3dm_get_calibrated_sensor_ranges {
    /** Sensor to query; `all` is not allowed. A value of enum mip_3dm_sensor_range_type. */
    uint8_t sensor;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES 0x0C53
/** Its descriptor. */
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_DESCRIPTOR 0x53
/** Its name in the specification. */
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_NAME "3dm.get_calibrated_sensor_ranges"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_calibrated_sensor_ranges_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_calibrated_sensor_ranges_decode(
    struct mip_3dm_get_calibrated_sensor_ranges *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_calibrated_sensor_ranges_codec, 0x53, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_calibrated_sensor_ranges_encode(
    const struct mip_3dm_get_calibrated_sensor_ranges *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_calibrated_sensor_ranges_codec, value, builder);
}

/**
 * Get Calibrated Sensor Ranges. Fills the structure and returns its address.
 *
 * - sensor: Sensor to query; `all` is not allowed. A value of enum mip_3dm_sensor_range_type.
 */
static inline struct mip_3dm_get_calibrated_sensor_ranges *
mip_3dm_get_calibrated_sensor_ranges_make(struct mip_3dm_get_calibrated_sensor_ranges *command,
                                          enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Get Calibrated Sensor Ranges response: response (0x0C,0xD3).
 *
 * Also called `calibrated_sensor_ranges_response`. Response to
 * mip_3dm_get_calibrated_sensor_ranges. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
struct mip_3dm_get_calibrated_sensor_ranges_response {
    /** Sensor specified in the command. A value of enum mip_3dm_sensor_range_type. */
    uint8_t sensor;
    /** Number of ranges. Counts the elements of ranges. */
    uint8_t num_ranges;
    /**
     * Ranges for which the sensor is calibrated. If sensor is MIP_3DM_SENSOR_RANGE_TYPE_ACCEL:
     * range has unit g. If sensor is MIP_3DM_SENSOR_RANGE_TYPE_GYRO: range has unit deg/s. If
     * sensor is MIP_3DM_SENSOR_RANGE_TYPE_MAG: range has unit gauss. If sensor is
     * MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE: range has unit mbar.
     */
    struct mip_3dm_sensor_range_entry ranges[50];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE 0x0CD3
/** Its descriptor. */
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE_DESCRIPTOR 0xD3
/** Its name in the specification. */
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE_NAME \
    "3dm.get_calibrated_sensor_ranges_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_get_calibrated_sensor_ranges_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_get_calibrated_sensor_ranges_response_decode(
    struct mip_3dm_get_calibrated_sensor_ranges_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_get_calibrated_sensor_ranges_response_codec, 0xD3, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_get_calibrated_sensor_ranges_response_encode(
    const struct mip_3dm_get_calibrated_sensor_ranges_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_get_calibrated_sensor_ranges_response_codec, value, builder);
}

/**
 * Low-Pass Anti-Aliasing Filter: command (0x0C,0x54).
 *
 * Configures the low-pass filter of a data field.
 *
 * Also called `lowpass_filter`. Functions: write, read, save, load and default. Response:
 * mip_3dm_low_pass_filter_response. Changes mip_sensor_scaled_accel, mip_sensor_scaled_gyro,
 * mip_sensor_scaled_mag, mip_sensor_scaled_pressure, mip_filter_data_comp_accel,
 * mip_filter_data_comp_angular_rate and mip_filter_data_linear_accel. Supported by 3DM-CV7-AHRS,
 * 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS. On the 3DM-CV7-AHRS: firmware > 1.0.07. On the
 * 3DM-CV7-AR: firmware > 1.0.07. On the 3DM-GQ7-GNSS/INS: firmware > 1.0.10.
 *
 * Except for read, a field descriptor of 0 means all fields of the set; if both are 0, all sets are
 * meant.
 *
 * - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
 */
struct mip_3dm_low_pass_filter {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set. */
    uint8_t field_descriptor;
    /** True if the field is filtered. Required for write. */
    mip_bool enable;
    /**
     * True uses `frequency`; false uses half the rate of the field in the message format. Required
     * for write.
     */
    mip_bool manual;
    /**
     * Cutoff; a write ignores it if `manual` is false, a read returns the cutoff in use. Unit: Hz.
     * Range: at least 0. Required for write.
     */
    float frequency;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_LOW_PASS_FILTER 0x0C54
/** Its descriptor. */
#define MIP_3DM_LOW_PASS_FILTER_DESCRIPTOR 0x54
/** Its name in the specification. */
#define MIP_3DM_LOW_PASS_FILTER_NAME "3dm.low_pass_filter"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_low_pass_filter_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_low_pass_filter_decode(struct mip_3dm_low_pass_filter *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_low_pass_filter_codec, 0x54, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_low_pass_filter_encode(
    const struct mip_3dm_low_pass_filter *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_low_pass_filter_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 * - enable: True if the field is filtered. Required for write.
 * - manual: True uses `frequency`; false uses half the rate of the field in the message format.
 *   Required for write.
 * - frequency: Cutoff; a write ignores it if `manual` is false, a read returns the cutoff in use.
 *   Unit: Hz. Range: at least 0. Required for write.
 */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_write(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor,
    mip_bool enable, mip_bool manual, float frequency) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    command->enable = mip_truth(enable);
    command->manual = mip_truth(manual);
    command->frequency = frequency;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_read(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_save(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_load(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - descriptor_set: Descriptor set of the field.
 * - field_descriptor: Field descriptor; 0 if the set is 0. Refers to fields of descriptor_set.
 */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_default(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/**
 * Low-Pass Anti-Aliasing Filter response: response (0x0C,0xD4).
 *
 * Also called `lowpass_filter_response`. Response to mip_3dm_low_pass_filter. Supported by
 * 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
 */
struct mip_3dm_low_pass_filter_response {
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Descriptor of the field that is filtered. Refers to fields of descriptor_set. */
    uint8_t field_descriptor;
    /** True if the field is filtered. */
    mip_bool enable;
    /** True uses `frequency`; false uses half the rate of the field in the message format. */
    mip_bool manual;
    /** Cutoff in use. Unit: Hz. Range: at least 0. */
    float frequency;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_LOW_PASS_FILTER_RESPONSE 0x0CD4
/** Its descriptor. */
#define MIP_3DM_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR 0xD4
/** Its name in the specification. */
#define MIP_3DM_LOW_PASS_FILTER_RESPONSE_NAME "3dm.low_pass_filter_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_low_pass_filter_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_low_pass_filter_response_decode(
    struct mip_3dm_low_pass_filter_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_low_pass_filter_response_codec, 0xD4, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_low_pass_filter_response_encode(
    const struct mip_3dm_low_pass_filter_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_low_pass_filter_response_codec, value, builder);
}

/**
 * Data stream format: command (0x0C,0x60).
 *
 * Selects MIP data or the raw data of a sensor for a stream.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_data_stream_format_response. Known only from the MIP SDK of 2014 and
 * MicroStrain Communication Library. Uncertain: Which devices support it. A comment in the SDK of
 * 2014 restricts it to the 3DM-GX3-35. Uncertain: Whether functions other than write require
 * `format`. The SDK of 2014 sends both parameters with every function, and a 0 in place of
 * `format`.
 *
 * In the wrapped format, packets of the sensor arrive in fields of the data sets: `sensor.aspp` and
 * `sensor.gxsb` for the IMU, `gnss_data.nmea` and `gnss_data.ubx` for the receiver.
 *
 * - mip-sdk-2014: Data stream format (0x0C,0x60)
 * - mscl: Data stream format (0x0C,0x60)
 */
struct mip_3dm_data_stream_format {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Stream whose format is set or read. A value of enum mip_3dm_internal_sensor. */
    uint8_t stream;
    /** Format of a data stream. A value of enum mip_3dm_stream_format. */
    uint8_t format;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DATA_STREAM_FORMAT 0x0C60
/** Its descriptor. */
#define MIP_3DM_DATA_STREAM_FORMAT_DESCRIPTOR 0x60
/** Its name in the specification. */
#define MIP_3DM_DATA_STREAM_FORMAT_NAME "3dm.data_stream_format"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_data_stream_format_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_data_stream_format_decode(struct mip_3dm_data_stream_format *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_data_stream_format_codec, 0x60, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_data_stream_format_encode(
    const struct mip_3dm_data_stream_format *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_data_stream_format_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_write(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_read(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_save(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_load(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - stream: Stream whose format is set or read. A value of enum mip_3dm_internal_sensor.
 * - format: Format of a data stream. A value of enum mip_3dm_stream_format.
 */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_default(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/**
 * Data stream format response: response (0x0C,0x88).
 *
 * No device is known for certain to support it. Response to mip_3dm_data_stream_format. Known only
 * from the MIP SDK of 2014 and MicroStrain Communication Library.
 *
 * - mip-sdk-2014: Data stream format (0x0C,0x60)
 * - mscl: Data stream format (0x0C,0x60)
 */
struct mip_3dm_data_stream_format_response {
    /** Stream whose format is set or read. A value of enum mip_3dm_internal_sensor. */
    uint8_t stream;
    /** Format of a data stream. A value of enum mip_3dm_stream_format. */
    uint8_t format;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DATA_STREAM_FORMAT_RESPONSE 0x0C88
/** Its descriptor. */
#define MIP_3DM_DATA_STREAM_FORMAT_RESPONSE_DESCRIPTOR 0x88
/** Its name in the specification. */
#define MIP_3DM_DATA_STREAM_FORMAT_RESPONSE_NAME "3dm.data_stream_format_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_data_stream_format_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_data_stream_format_response_decode(
    struct mip_3dm_data_stream_format_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_data_stream_format_response_codec, 0x88, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_data_stream_format_response_encode(
    const struct mip_3dm_data_stream_format_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_data_stream_format_response_codec, value, builder);
}

/**
 * Device power state: command (0x0C,0x61).
 *
 * Sets the power state of an internal sensor.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_device_power_state_response. The device may take 5 s to reply. Known only from
 * the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: Which devices support it. A
 * comment in the SDK of 2014 names the 3DM-GX3-25 and the 3DM-GX3-35. Uncertain: The time-out. The
 * SDK of 2014 uses one longer than usual; 5 s is assumed. Uncertain: Whether `state` may be omitted
 * with functions other than write. The SDK of 2014 sends `device` with every function, and a 0 in
 * place of `state`.
 *
 * - mip-sdk-2014: Device power state (0x0C,0x61)
 * - mscl: Device power state (0x0C,0x61)
 */
struct mip_3dm_device_power_state {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** The sensor. A value of enum mip_3dm_internal_sensor. */
    uint8_t device;
    /**
     * Power state of an internal sensor. A value of enum mip_3dm_sensor_power_state. Required for
     * write.
     */
    uint8_t state;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DEVICE_POWER_STATE 0x0C61
/** Its descriptor. */
#define MIP_3DM_DEVICE_POWER_STATE_DESCRIPTOR 0x61
/** Its name in the specification. */
#define MIP_3DM_DEVICE_POWER_STATE_NAME "3dm.device_power_state"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_power_state_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_power_state_decode(struct mip_3dm_device_power_state *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_power_state_codec, 0x61, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_power_state_encode(
    const struct mip_3dm_device_power_state *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_power_state_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor.
 * - state: Power state of an internal sensor. A value of enum mip_3dm_sensor_power_state. Required
 *   for write.
 */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_write(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_,
    enum mip_3dm_sensor_power_state state) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->device = (uint8_t)device_;
    command->state = (uint8_t)state;
    return command;
}

/**
 * Return the current setting in a response. Fills the structure and returns its address.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor.
 */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_read(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->device = (uint8_t)device_;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor.
 */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_save(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->device = (uint8_t)device_;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor.
 */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_load(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->device = (uint8_t)device_;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - device_: The sensor. A value of enum mip_3dm_internal_sensor.
 */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_default(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->device = (uint8_t)device_;
    return command;
}

/**
 * Device power state response: response (0x0C,0x89).
 *
 * No device is known for certain to support it. Response to mip_3dm_device_power_state. Known only
 * from the MIP SDK of 2014 and MicroStrain Communication Library.
 *
 * - mip-sdk-2014: Device power state (0x0C,0x61)
 * - mscl: Device power state (0x0C,0x61)
 */
struct mip_3dm_device_power_state_response {
    /** The sensor. A value of enum mip_3dm_internal_sensor. */
    uint8_t device;
    /** Power state of an internal sensor. A value of enum mip_3dm_sensor_power_state. */
    uint8_t state;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DEVICE_POWER_STATE_RESPONSE 0x0C89
/** Its descriptor. */
#define MIP_3DM_DEVICE_POWER_STATE_RESPONSE_DESCRIPTOR 0x89
/** Its name in the specification. */
#define MIP_3DM_DEVICE_POWER_STATE_RESPONSE_NAME "3dm.device_power_state_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_power_state_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_power_state_response_decode(
    struct mip_3dm_device_power_state_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_power_state_response_codec, 0x89, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_power_state_response_encode(
    const struct mip_3dm_device_power_state_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_power_state_response_codec, value, builder);
}

/**
 * GPS advanced settings: command (0x0C,0x62).
 *
 * Saves, loads or resets the settings of the GNSS receiver that were made in direct mode.
 *
 * No device is known for certain to support it. For advanced use. Functions: save, load and
 * default. Known only from the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain:
 * Which devices support it. A comment in the SDK of 2014 names the 3DM-GX3-35.
 *
 * In direct mode, your program configures the u-blox receiver with its own protocol; see
 * mip_system_comm_mode.
 *
 * - mip-sdk-2014: GPS advanced settings (0x0C,0x62)
 * - mscl: GPS advanced settings (0x0C,0x62)
 */
struct mip_3dm_gps_advanced_settings {
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_GPS_ADVANCED_SETTINGS 0x0C62
/** Its descriptor. */
#define MIP_3DM_GPS_ADVANCED_SETTINGS_DESCRIPTOR 0x62
/** Its name in the specification. */
#define MIP_3DM_GPS_ADVANCED_SETTINGS_NAME "3dm.gps_advanced_settings"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_gps_advanced_settings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_gps_advanced_settings_decode(
    struct mip_3dm_gps_advanced_settings *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_gps_advanced_settings_codec, 0x62, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_gps_advanced_settings_encode(
    const struct mip_3dm_gps_advanced_settings *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_gps_advanced_settings_codec, value, builder);
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_advanced_settings *
mip_3dm_gps_advanced_settings_save(struct mip_3dm_gps_advanced_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_advanced_settings *
mip_3dm_gps_advanced_settings_load(struct mip_3dm_gps_advanced_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_3dm_gps_advanced_settings *
mip_3dm_gps_advanced_settings_default(struct mip_3dm_gps_advanced_settings *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Device Status: command (0x0C,0x64).
 *
 * Gets the state of the device, in basic form or with counters.
 *
 * For advanced use. Response: mip_3dm_device_status_basic_rq1_imu_response,
 * mip_3dm_device_status_basic_response, mip_3dm_device_status_basic_without_state_response,
 * mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response, mip_3dm_device_status_basic_gx3_response or
 * mip_3dm_device_status_diagnostic_gx3_response. Supported by 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35,
 * 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * The device expects its own model number, which mip_base_get_device_info returns.
 *
 * Device families reply in different layouts. The selector and the length distinguish them.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status {
    /**
     * Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the 3DM-GX5-35:
     * always 6252. On the 3DM-GX5-45: always 6251.
     */
    uint16_t model_number;
    /** Level of detail of the reply. A value of enum mip_3dm_device_status_selector. */
    uint8_t status_selector;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3DM_DEVICE_STATUS 0x0C64
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DESCRIPTOR 0x64
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_NAME "3dm.device_status"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_decode(struct mip_3dm_device_status *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_codec, 0x64, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_encode(
    const struct mip_3dm_device_status *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_codec, value, builder);
}

/**
 * Device Status. Fills the structure and returns its address.
 *
 * - model_number: Model number of the device that replies. On the 3DM-GX5-15: always 6254. On the
 *   3DM-GX5-35: always 6252. On the 3DM-GX5-45: always 6251.
 * - status_selector: Level of detail of the reply. A value of enum mip_3dm_device_status_selector.
 */
static inline struct mip_3dm_device_status *
mip_3dm_device_status_make(struct mip_3dm_device_status *command, uint16_t model_number,
                           enum mip_3dm_device_status_selector status_selector) {
    memset(command, 0, sizeof(*command));
    command->model_number = model_number;
    command->status_selector = (uint8_t)status_selector;
    return command;
}

/**
 * Basic Device Status of the inertial sensor of the 3DM-RQ1-45: response (0x0C,0x90).
 *
 * Timer only, in microseconds.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Sent if
 * status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC. Uncertain: The SDK of 2014 lists the
 * names of the values and the unit of the timer; the descriptions are inferred from the names.
 *
 * Parameters without a member, on the wire only:
 * - model_number: Model number of the inertial sensor. Always 6238.
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_basic_rq1_imu_response {
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: us. */
    uint64_t system_timer;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE_NAME "3dm.device_status_basic_rq1_imu_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_basic_rq1_imu_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_basic_rq1_imu_response_decode(
    struct mip_3dm_device_status_basic_rq1_imu_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_basic_rq1_imu_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_basic_rq1_imu_response_encode(
    const struct mip_3dm_device_status_basic_rq1_imu_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_basic_rq1_imu_response_codec, value, builder);
}

/**
 * Basic Device Status: response (0x0C,0x90).
 *
 * State and timer.
 *
 * Response to mip_3dm_device_status. Distinguished from
 * mip_3dm_device_status_basic_without_state_response and mip_3dm_device_status_basic_gx3_response
 * by the size of its data. Sent if status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC.
 * Supported by 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_basic_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /**
     * State of the system; the meaning of its values is not documented. On the 3DM-GX4-45,
     * 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: values of enum mip_3dm_gx4_system_state.
     */
    uint16_t system_state;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE_NAME "3dm.device_status_basic_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_basic_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_basic_response_decode(
    struct mip_3dm_device_status_basic_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_basic_response_codec, 0x90, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_basic_response_encode(
    const struct mip_3dm_device_status_basic_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_basic_response_codec, value, builder);
}

/**
 * Basic Device Status without a state: response (0x0C,0x90).
 *
 * Timer only.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_basic_response and mip_3dm_device_status_basic_gx3_response by the
 * size of its data. Sent if status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC. Uncertain:
 * MSCL uses it for the 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10, the SDK of
 * 2014 for the 3DM-GX4-15, the 3DM-GX4-25 and the inertial sensor of the 3DM-GX4-45; that the
 * 3DM-CL5-10 has it is inferred. Uncertain: The manual of the 3DM-GX5-45 documents it too, but for
 * the model number of another device; MSCL uses the layout with a state for that device.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_basic_without_state_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE_NAME \
    "3dm.device_status_basic_without_state_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_basic_without_state_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_basic_without_state_response_decode(
    struct mip_3dm_device_status_basic_without_state_response *value,
    const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_basic_without_state_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_basic_without_state_response_encode(
    const struct mip_3dm_device_status_basic_without_state_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_basic_without_state_response_codec, value, builder);
}

/**
 * Diagnostic Device Status: response (0x0C,0x90).
 *
 * State, timer, and the counters of streams and port.
 *
 * Response to mip_3dm_device_status. Distinguished from
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Supported by 3DM-GX5-15.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** State of the system; the meaning of its values is not documented. */
    uint16_t system_state;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** True if filter data is streamed. */
    mip_bool filter_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** Filter data packets that were not sent. Unit: 1. */
    uint32_t filter_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
    /** IMU messages that could not be parsed. Unit: 1. */
    uint32_t imu_parser_errors;
    /** IMU messages that were read. Unit: 1. */
    uint32_t imu_message_count;
    /** System timer at the last IMU message. Unit: ms. */
    uint32_t imu_last_message_time;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE_NAME "3dm.device_status_diagnostic_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_response_decode(
    struct mip_3dm_device_status_diagnostic_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_response_encode(
    const struct mip_3dm_device_status_diagnostic_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_response_codec, value, builder);
}

/**
 * Diagnostic Device Status with GNSS: response (0x0C,0x90).
 *
 * State, timer, and the counters of pulses, streams, port and receiver.
 *
 * Response to mip_3dm_device_status. Distinguished from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Supported by 3DM-GX5-35 and 3DM-GX5-45. Uncertain:
 * MSCL uses it for the 3DM-GX4-45 and the -35 and -45 of GX5 and CX5; its length is from a manual.
 * Uncertain: MSCL lists only the names of the values, from which the descriptions are inferred; the
 * times are assumed to be in ms like the system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_gnss_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** State of the system; the meaning of its values is not documented. */
    uint16_t system_state;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** Power state of the GNSS receiver. */
    uint8_t gnss_power_state;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** True if GNSS data is streamed. */
    mip_bool gnss_stream_enabled;
    /** True if filter data is streamed. */
    mip_bool filter_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** GNSS data packets that were not sent. Unit: 1. */
    uint32_t gnss_dropped_packets;
    /** Filter data packets that were not sent. Unit: 1. */
    uint32_t filter_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
    /** IMU messages that could not be parsed. Unit: 1. */
    uint32_t imu_parser_errors;
    /** IMU messages that were read. Unit: 1. */
    uint32_t imu_message_count;
    /** System timer at the last IMU message. Unit: ms. */
    uint32_t imu_last_message_time;
    /** Receiver messages that could not be parsed. Unit: 1. */
    uint32_t gnss_parser_errors;
    /** Receiver messages that were read. Unit: 1. */
    uint32_t gnss_message_count;
    /** System timer at the last receiver message. Unit: ms. */
    uint32_t gnss_last_message_time;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE_NAME \
    "3dm.device_status_diagnostic_gnss_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_gnss_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_gnss_response_decode(
    struct mip_3dm_device_status_diagnostic_gnss_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_gnss_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_gnss_response_encode(
    const struct mip_3dm_device_status_diagnostic_gnss_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_gnss_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of the 3DM-GQ4-45: response (0x0C,0x90).
 *
 * The layout with GNSS, plus flags for parts that could not be started.
 *
 * Response to mip_3dm_device_status. Distinguished from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_rq1_45_response,
 * mip_3dm_device_status_diagnostic_gx4_response, mip_3dm_device_status_diagnostic_imu_response,
 * mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Supported by 3DM-GQ4-45. Uncertain: No known manual
 * documents it. Uncertain: MSCL lists only the names of the values, from which the descriptions are
 * inferred; the times are assumed to be in ms like the system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_gq4_45_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** State of the system; the meaning of its values is not documented. */
    uint16_t system_state;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** Power state of the GNSS receiver. */
    uint8_t gnss_power_state;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** True if GNSS data is streamed. */
    mip_bool gnss_stream_enabled;
    /** True if filter data is streamed. */
    mip_bool filter_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** GNSS data packets that were not sent. Unit: 1. */
    uint32_t gnss_dropped_packets;
    /** Filter data packets that were not sent. Unit: 1. */
    uint32_t filter_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
    /** IMU messages that could not be parsed. Unit: 1. */
    uint32_t imu_parser_errors;
    /** IMU messages that were read. Unit: 1. */
    uint32_t imu_message_count;
    /** System timer at the last IMU message. Unit: ms. */
    uint32_t imu_last_message_time;
    /** Receiver messages that could not be parsed. Unit: 1. */
    uint32_t gnss_parser_errors;
    /** Receiver messages that were read. Unit: 1. */
    uint32_t gnss_message_count;
    /** System timer at the last receiver message. Unit: ms. */
    uint32_t gnss_last_message_time;
    /** True if the magnetometer could not be started. */
    mip_bool mag_init_failed;
    /** True if the pressure sensor could not be started. */
    mip_bool pressure_init_failed;
    /** True if the GNSS receiver could not be started. */
    mip_bool receiver_init_failed;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE_NAME \
    "3dm.device_status_diagnostic_gq4_45_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_gq4_45_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_gq4_45_response_decode(
    struct mip_3dm_device_status_diagnostic_gq4_45_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_gq4_45_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_gq4_45_response_encode(
    const struct mip_3dm_device_status_diagnostic_gq4_45_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_gq4_45_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of the 3DM-RQ1-45: response (0x0C,0x90).
 *
 * The layout with GNSS, plus the temperature.
 *
 * Response to mip_3dm_device_status. Distinguished from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_gx4_response, mip_3dm_device_status_diagnostic_imu_response,
 * mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Supported by 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.
 * Uncertain: No known manual documents it. Uncertain: MSCL lists only the names of the values, from
 * which the descriptions are inferred; the times are assumed to be in ms like the system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_rq1_45_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** State of the system; the meaning of its values is not documented. */
    uint16_t system_state;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** Power state of the GNSS receiver. */
    uint8_t gnss_power_state;
    /** True if the receiver starts cold at power-up. */
    uint8_t cold_start_on_power_on;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    float temperature;
    /** System timer at the last temperature measurement. Unit: ms. */
    uint32_t temperature_last_time;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** True if GNSS data is streamed. */
    mip_bool gnss_stream_enabled;
    /** True if filter data is streamed. */
    mip_bool filter_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** GNSS data packets that were not sent. Unit: 1. */
    uint32_t gnss_dropped_packets;
    /** Filter data packets that were not sent. Unit: 1. */
    uint32_t filter_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
    /** IMU messages that could not be parsed. Unit: 1. */
    uint32_t imu_parser_errors;
    /** IMU messages that were read. Unit: 1. */
    uint32_t imu_message_count;
    /** System timer at the last IMU message. Unit: ms. */
    uint32_t imu_last_message_time;
    /** Receiver messages that could not be parsed. Unit: 1. */
    uint32_t gnss_parser_errors;
    /** Receiver messages that were read. Unit: 1. */
    uint32_t gnss_message_count;
    /** System timer at the last receiver message. Unit: ms. */
    uint32_t gnss_last_message_time;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE_NAME \
    "3dm.device_status_diagnostic_rq1_45_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_rq1_45_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_rq1_45_response_decode(
    struct mip_3dm_device_status_diagnostic_rq1_45_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_rq1_45_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_rq1_45_response_encode(
    const struct mip_3dm_device_status_diagnostic_rq1_45_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_rq1_45_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of the 3DM-GX4-15 and 3DM-GX4-25: response (0x0C,0x90).
 *
 * Timer, and counters of pulses, streams, port and USB.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_imu_response,
 * mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: No known manual documents it for these
 * devices; the offsets 49 to 69 in the manual of the 3DM-GX5-45 agree. Uncertain: MSCL lists only
 * the names of the values, from which the descriptions are inferred; the times are assumed to be in
 * ms like the system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_gx4_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** True if filter data is streamed. */
    mip_bool filter_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** Filter data packets that were not sent. Unit: 1. */
    uint32_t filter_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
    /** Bytes sent over USB. Unit: byte. */
    uint32_t usb_bytes_written;
    /** Bytes received over USB. Unit: byte. */
    uint32_t usb_bytes_read;
    /** Overruns while writing to USB. Unit: 1. */
    uint32_t usb_write_overruns;
    /** Overruns while reading from USB. Unit: 1. */
    uint32_t usb_read_overruns;
    /** IMU messages that could not be parsed. Unit: 1. */
    uint32_t imu_parser_errors;
    /** IMU messages that were read. Unit: 1. */
    uint32_t imu_message_count;
    /** System timer at the last IMU message. Unit: ms. */
    uint32_t imu_last_message_time;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE_NAME \
    "3dm.device_status_diagnostic_gx4_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_gx4_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_gx4_response_decode(
    struct mip_3dm_device_status_diagnostic_gx4_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_gx4_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_gx4_response_encode(
    const struct mip_3dm_device_status_diagnostic_gx4_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_gx4_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of an IMU: response (0x0C,0x90).
 *
 * Timer, available sensors, temperature, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: MSCL uses it for the 3DM-GX5-10, 3DM-CX5-10
 * and 3DM-CV5-10; no known manual documents it. Uncertain: MSCL lists only the names of the values,
 * from which the descriptions are inferred; the times are assumed to be in ms like the system
 * timer. Uncertain: The units of the ranges are not known.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_imu_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** True if the device has a magnetometer. */
    mip_bool has_mag;
    /** True if the device has a pressure sensor. */
    mip_bool has_pressure;
    /** Power state of the sensors. */
    uint8_t power_state;
    /** Largest angular rate that can be measured. */
    uint16_t gyro_range;
    /** Largest acceleration that can be measured. */
    uint16_t accel_range;
    /** Reserved. */
    uint32_t reserved;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    float temperature;
    /** System timer at the last temperature measurement. Unit: ms. */
    uint32_t temperature_last_time;
    /** State of the temperature measurement. */
    uint8_t temperature_error;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE_NAME \
    "3dm.device_status_diagnostic_imu_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_imu_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_imu_response_decode(
    struct mip_3dm_device_status_diagnostic_imu_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_imu_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_imu_response_encode(
    const struct mip_3dm_device_status_diagnostic_imu_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_imu_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of the inertial sensor of the 3DM-GX4-45: response (0x0C,0x90).
 *
 * Timer, available sensors and their ranges, temperature, and the counters of pulses, stream and
 * port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_rq1_imu_response
 * and mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if
 * status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: The SDK of 2014 lists
 * the names of the values and the units of temperature and times; the descriptions are inferred
 * from the names. Uncertain: The units of the ranges are not known.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_gx4_imu_response {
    /** Model number of the inertial sensor. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
    /** True if the device has a magnetometer. */
    mip_bool has_mag;
    /** True if the device has a pressure sensor. */
    mip_bool has_pressure;
    /** Largest angular rate that can be measured. */
    uint16_t gyro_range;
    /** Largest acceleration that can be measured. */
    uint8_t accel_range;
    /** Largest magnetic field that can be measured. */
    float mag_range;
    /** Largest pressure that can be measured. */
    float pressure_range;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    float temperature;
    /** System timer at the last temperature measurement. Unit: ms. */
    uint32_t temperature_last_time;
    /** State of the temperature measurement; 0 is normal. */
    uint8_t temperature_error;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE_NAME \
    "3dm.device_status_diagnostic_gx4_imu_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_gx4_imu_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_gx4_imu_response_decode(
    struct mip_3dm_device_status_diagnostic_gx4_imu_response *value,
    const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_gx4_imu_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_gx4_imu_response_encode(
    const struct mip_3dm_device_status_diagnostic_gx4_imu_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_gx4_imu_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of the inertial sensor of the 3DM-RQ1-45: response (0x0C,0x90).
 *
 * Timer, temperature and supply, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response
 * and mip_3dm_device_status_diagnostic_gx3_response by the size of its data. Sent if
 * status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: The SDK of 2014 lists
 * the names of the values and the units of temperature and times; the descriptions are inferred
 * from the names.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_rq1_imu_response {
    /** Model number of the inertial sensor. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: us. */
    uint64_t system_timer;
    /** Temperature of the board. Unit: degC. Uncertain: The unit is inferred. */
    float temperature;
    /** System timer at the last temperature measurement. Unit: ms. */
    uint32_t temperature_last_time;
    /** True if a temperature sensor is faulty. */
    mip_bool bad_temperature_sensor_detected;
    /** True if the temperature is too low. */
    mip_bool cold_temperature_detected;
    /** True if a supply voltage is out of range. */
    mip_bool bad_voltage_detected;
    /** Number of PPS pulses counted. Unit: 1. */
    uint32_t pps_count;
    /** System timer at the last pulse. Unit: ms. */
    uint32_t pps_last_time;
    /** True if sensor data is streamed. */
    mip_bool imu_stream_enabled;
    /** Sensor data packets that were not sent. Unit: 1. */
    uint32_t imu_dropped_packets;
    /** State of the port; the meaning of its values is not known. */
    uint16_t comm_port_state;
    /** Present baud rate of the port. Unit: Bd. */
    uint32_t comm_port_baud_rate;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE_NAME \
    "3dm.device_status_diagnostic_rq1_imu_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_rq1_imu_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_rq1_imu_response_decode(
    struct mip_3dm_device_status_diagnostic_rq1_imu_response *value,
    const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_rq1_imu_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_rq1_imu_response_encode(
    const struct mip_3dm_device_status_diagnostic_rq1_imu_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_rq1_imu_response_codec, value, builder);
}

/**
 * Basic Device Status of the 3DM-GX3-35 and 3DM-GX3-45: response (0x0C,0x90).
 *
 * State of the port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_basic_response and mip_3dm_device_status_basic_without_state_response
 * by the size of its data. Sent if status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC.
 * Uncertain: Only the SDK of 2014 contains it, with the names of the values; the descriptions are
 * inferred from the names.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_basic_gx3_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Part of the device that the port is connected to. */
    uint8_t comm_mode;
    /** Port in use. */
    uint8_t comm_device;
    /** Settings of the data streams; the meaning of the bits is not known. */
    uint32_t settings_flags;
    /** State of the port; the meaning of its values is not known. */
    uint16_t comm_state;
    /** Baud rate of the port. Unit: Bd. */
    uint32_t comm_baud_rate;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE_NAME "3dm.device_status_basic_gx3_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_basic_gx3_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_basic_gx3_response_decode(
    struct mip_3dm_device_status_basic_gx3_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_basic_gx3_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_basic_gx3_response_encode(
    const struct mip_3dm_device_status_basic_gx3_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_basic_gx3_response_codec, value, builder);
}

/**
 * Diagnostic Device Status of the 3DM-GX3-35 and 3DM-GX3-45: response (0x0C,0x90).
 *
 * State of the port, and the counters of the port, USB, receiver and IMU.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. Distinguished
 * from mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response
 * and mip_3dm_device_status_diagnostic_rq1_imu_response by the size of its data. Sent if
 * status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: Only the SDK of 2014
 * contains it, with the names of the values; the descriptions are inferred from the names.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device Status (0x0C,0x64)
 */
struct mip_3dm_device_status_diagnostic_gx3_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Part of the device that the port is connected to. */
    uint8_t comm_mode;
    /** Port in use. */
    uint8_t comm_device;
    /** Settings of the data streams; the meaning of the bits is not known. */
    uint32_t settings_flags;
    /** State of the port; the meaning of its values is not known. */
    uint16_t comm_state;
    /** Baud rate of the port. Unit: Bd. */
    uint32_t comm_baud_rate;
    /** Bytes sent over the port. Unit: byte. */
    uint32_t comm_port_bytes_written;
    /** Bytes received over the port. Unit: byte. */
    uint32_t comm_port_bytes_read;
    /** Overruns while writing to the port. Unit: 1. */
    uint32_t comm_port_write_overruns;
    /** Overruns while reading from the port. Unit: 1. */
    uint32_t comm_port_read_overruns;
    /** State of the USB port; the meaning of its values is not known. */
    uint16_t usb_state;
    /** Bytes sent over USB. Unit: byte. */
    uint32_t usb_bytes_written;
    /** Bytes received over USB. Unit: byte. */
    uint32_t usb_bytes_read;
    /** Overruns while writing to USB. Unit: 1. */
    uint32_t usb_write_overruns;
    /** Overruns while reading from USB. Unit: 1. */
    uint32_t usb_read_overruns;
    /** State of the receiver's driver; the meaning of its values is not known. */
    uint16_t gnss_driver_state;
    /** State of the port to the receiver; the meaning of its values is not known. */
    uint16_t gnss_port_state;
    /** Bytes sent to the receiver. Unit: byte. */
    uint32_t gnss_bytes_written;
    /** Bytes received from the receiver. Unit: byte. */
    uint32_t gnss_bytes_read;
    /** Overruns while writing to the receiver. Unit: 1. */
    uint32_t gnss_write_overruns;
    /** Overruns while reading from the receiver. Unit: 1. */
    uint32_t gnss_read_overruns;
    /** Receiver messages that were read. Unit: 1. */
    uint32_t gnss_message_count;
    /** Receiver messages that arrived late. Unit: 1. */
    uint32_t gnss_delayed_message_count;
    /** State of the IMU's driver; the meaning of its values is not known. */
    uint16_t imu_driver_state;
    /** State of the port to the IMU; the meaning of its values is not known. */
    uint16_t imu_port_state;
    /** Bytes sent to the IMU. Unit: byte. */
    uint32_t imu_bytes_written;
    /** Bytes received from the IMU. Unit: byte. */
    uint32_t imu_bytes_read;
    /** Overruns while writing to the IMU. Unit: 1. */
    uint32_t imu_write_overruns;
    /** Overruns while reading from the IMU. Unit: 1. */
    uint32_t imu_read_overruns;
    /** IMU messages that were read. Unit: 1. */
    uint32_t imu_message_count;
    /** IMU messages that arrived late. Unit: 1. */
    uint32_t imu_delayed_message_count;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE 0x0C90
/** Its descriptor. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE_NAME \
    "3dm.device_status_diagnostic_gx3_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3dm_device_status_diagnostic_gx3_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3dm_device_status_diagnostic_gx3_response_decode(
    struct mip_3dm_device_status_diagnostic_gx3_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_3dm_device_status_diagnostic_gx3_response_codec, 0x90, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3dm_device_status_diagnostic_gx3_response_encode(
    const struct mip_3dm_device_status_diagnostic_gx3_response *value,
    struct mip_builder *builder) {
    return mip_encode(&mip_3dm_device_status_diagnostic_gx3_response_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
