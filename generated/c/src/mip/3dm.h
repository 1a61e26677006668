/**
 * @file
 *
 * 3DM (0x0C). Commands that set up the sensors, the outputs, the pins and the events of a device.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_3DM_H
#define MIP_3DM_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
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
     * fix. Requires a receiver.
     */
    MIP_3DM_PPS_SOURCE_RECEIVER_1 = 1,
    /**
     * From GNSS receiver 2. The external time is GPS time, and valid only while the receiver has a
     * fix. Requires 2 receivers.
     */
    MIP_3DM_PPS_SOURCE_RECEIVER_2 = 2,
    /** From a GPIO pin that is configured as a PPS input. */
    MIP_3DM_PPS_SOURCE_GPIO = 3,
    /** From the oscillator of the device. */
    MIP_3DM_PPS_SOURCE_GENERATED = 4
};

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
 * Motion that a GNSS receiver assumes. Uncertain: The SDK of 2014 numbers the modes 0 to 8, but the
 * list in its comments lacks `fixed`, which u-blox receivers do not have either. Uncertain: The
 * sources list only names; the descriptions of the modes are inferred from them.
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

/**
 * Processing steps of 3-series devices. Uncertain: Bits 4, 5, 9 and 12 are from the single-byte
 * protocol of the 3DM-GX3. MSCL has the quaternion as 0x10000, which exceeds 16 bits. Uncertain:
 * The sources list only names; the descriptions of the bits are inferred from them.
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
     * Ticks of the internal clock. Uncertain: The source states 2 both for this value and for the
     * nanoseconds.
     */
    MIP_3DM_IMU_TIMESTAMP_SELECTOR_INTERNAL_TICKS = 3
};

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
    /** On models with a magnetometer. Requires a magnetometer. */
    MIP_3DM_SENSOR_RANGE_TYPE_MAG = 3,
    /** The pressure sensor. Requires a pressure sensor. */
    MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE = 4
};

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
    /** The GNSS receiver. Requires a receiver. */
    MIP_3DM_INTERNAL_SENSOR_GNSS = 2
};

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
    /** GNSS data. Requires a receiver. */
    MIP_3DM_LEGACY_DATA_STREAM_GNSS = 2,
    /** Estimation filter data (0x82). */
    MIP_3DM_LEGACY_DATA_STREAM_FILTER = 3
};

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

/**
 * Poll IMU data: command (0x0C,0x01).
 *
 * Requests one sensor data packet (0x80) with the listed fields, in the listed order.
 *
 * Also called `poll_imu_message`. Not acknowledged if suppress_ack is true. Devices without it may
 * have mip_3dm_poll_data.
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

#define MIP_3DM_POLL_IMU_DATA 0x0C01
#define MIP_3DM_POLL_IMU_DATA_DESCRIPTOR 0x01
MIP_FIELD(mip_3dm_poll_imu_data, 0x01);

/** Fills the structure, and returns it. */
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
 * Poll GNSS data: command (0x0C,0x02).
 *
 * Requests one GNSS data packet with the listed fields, in the listed order.
 *
 * Also called `poll_gnss_message`. Not acknowledged if suppress_ack is true. Devices without it may
 * have mip_3dm_poll_data. Known only from the MicroStrain MIP SDK. Requires a receiver.
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

#define MIP_3DM_POLL_GNSS_DATA 0x0C02
#define MIP_3DM_POLL_GNSS_DATA_DESCRIPTOR 0x02
MIP_FIELD(mip_3dm_poll_gnss_data, 0x02);

/** Fills the structure, and returns it. */
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
 * Poll estimation filter data: command (0x0C,0x03).
 *
 * Requests one filter data packet (0x82) with the listed fields, in the listed order.
 *
 * Also called `poll_filter_message`. Not acknowledged if suppress_ack is true. Devices without it
 * may have mip_3dm_poll_data.
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

#define MIP_3DM_POLL_FILTER_DATA 0x0C03
#define MIP_3DM_POLL_FILTER_DATA_DESCRIPTOR 0x03
MIP_FIELD(mip_3dm_poll_filter_data, 0x03);

/** Fills the structure, and returns it. */
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
 * Poll NMEA data: command (0x0C,0x04).
 *
 * Requests the listed NMEA sentences once.
 *
 * Also called `nmea_poll_data`. Not acknowledged if suppress_ack is true.
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

#define MIP_3DM_POLL_NMEA_DATA 0x0C04
#define MIP_3DM_POLL_NMEA_DATA_DESCRIPTOR 0x04
MIP_FIELD(mip_3dm_poll_nmea_data, 0x04);

/** Fills the structure, and returns it. */
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
 * Get IMU data base rate: command (0x0C,0x06).
 *
 * Gets the base rate, which is divided by the decimations of mip_3dm_imu_message_format.
 *
 * Also called `imu_get_base_rate`. Response: mip_3dm_get_imu_base_rate_response. Devices without it
 * may have mip_3dm_get_base_rate.
 *
 * - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
 */
struct mip_3dm_get_imu_base_rate {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_3DM_GET_IMU_BASE_RATE 0x0C06
#define MIP_3DM_GET_IMU_BASE_RATE_DESCRIPTOR 0x06
MIP_FIELD(mip_3dm_get_imu_base_rate, 0x06);

/**
 * Get IMU data base rate response: response (0x0C,0x83).
 *
 * Also called `imu_get_base_rate_response`. Response to mip_3dm_get_imu_base_rate.
 *
 * - 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
 */
struct mip_3dm_get_imu_base_rate_response {
    /** Base rate of the sensor data. Unit: Hz. */
    uint16_t rate;
};

#define MIP_3DM_GET_IMU_BASE_RATE_RESPONSE 0x0C83
#define MIP_3DM_GET_IMU_BASE_RATE_RESPONSE_DESCRIPTOR 0x83
MIP_FIELD(mip_3dm_get_imu_base_rate_response, 0x83);

/**
 * Get GNSS data base rate: command (0x0C,0x07).
 *
 * Gets the base rate, which is divided by the decimations of mip_3dm_gnss_message_format.
 *
 * Also called `gnss_get_base_rate`. Response: mip_3dm_get_gnss_base_rate_response. Devices without
 * it may have mip_3dm_get_base_rate. Known only from the MicroStrain MIP SDK. Requires a receiver.
 *
 * - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
 */
struct mip_3dm_get_gnss_base_rate {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_3DM_GET_GNSS_BASE_RATE 0x0C07
#define MIP_3DM_GET_GNSS_BASE_RATE_DESCRIPTOR 0x07
MIP_FIELD(mip_3dm_get_gnss_base_rate, 0x07);

/**
 * Get GNSS data base rate response: response (0x0C,0x84).
 *
 * Also called `gnss_get_base_rate_response`. Response to mip_3dm_get_gnss_base_rate. Known only
 * from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
 */
struct mip_3dm_get_gnss_base_rate_response {
    /** Base rate of the GNSS data. Unit: Hz. */
    uint16_t rate;
};

#define MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE 0x0C84
#define MIP_3DM_GET_GNSS_BASE_RATE_RESPONSE_DESCRIPTOR 0x84
MIP_FIELD(mip_3dm_get_gnss_base_rate_response, 0x84);

/**
 * IMU message format: command (0x0C,0x08).
 *
 * Sets the fields of the sensor data packets (0x80), their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_imu_message_format_response.
 * Devices without it may have mip_3dm_message_format.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of fields. Counts the elements of descriptors. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_SENSOR_SET. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

#define MIP_3DM_IMU_MESSAGE_FORMAT 0x0C08
#define MIP_3DM_IMU_MESSAGE_FORMAT_DESCRIPTOR 0x08
MIP_FIELD(mip_3dm_imu_message_format, 0x08);
MIP_FILL(mip_3dm_imu_message_format, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_imu_message_format, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_imu_message_format, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_imu_message_format, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * IMU message format response: response (0x0C,0x80).
 *
 * Response to mip_3dm_imu_message_format.
 *
 * - 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
 */
struct mip_3dm_imu_message_format_response {
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_SENSOR_SET. */
    struct mip_descriptor_rate descriptors[84];
};

#define MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE 0x0C80
#define MIP_3DM_IMU_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x80
MIP_FIELD(mip_3dm_imu_message_format_response, 0x80);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_imu_message_format *
mip_3dm_imu_message_format_write_from(struct mip_3dm_imu_message_format *command,
                                      const struct mip_3dm_imu_message_format_response *response) {
    return mip_3dm_imu_message_format_write(command, response->num_descriptors,
                                            response->descriptors);
}

/**
 * GNSS message format: command (0x0C,0x09).
 *
 * Sets the fields of the GNSS data packets, their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gnss_message_format_response.
 * Devices without it may have mip_3dm_message_format. Requires a receiver.
 *
 * The decimation is the base rate, as mip_3dm_get_gnss_base_rate reports it, divided by the desired
 * rate.
 *
 * - mip-sdk-4: GNSS message format (0x0C,0x09)
 * - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
 */
struct mip_3dm_gnss_message_format {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of fields. Counts the elements of descriptors. Range: 0 to 82. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_GNSS_DATA_SET. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

#define MIP_3DM_GNSS_MESSAGE_FORMAT 0x0C09
#define MIP_3DM_GNSS_MESSAGE_FORMAT_DESCRIPTOR 0x09
MIP_FIELD(mip_3dm_gnss_message_format, 0x09);
MIP_FILL(mip_3dm_gnss_message_format, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_gnss_message_format, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_gnss_message_format, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_gnss_message_format, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * GNSS message format response: response (0x0C,0x81).
 *
 * Response to mip_3dm_gnss_message_format.
 *
 * - mip-sdk-4: GNSS message format (0x0C,0x09)
 * - 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
 */
struct mip_3dm_gnss_message_format_response {
    /** Number of fields. Counts the elements of descriptors. Range: 0 to 82. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_GNSS_DATA_SET. */
    struct mip_descriptor_rate descriptors[84];
};

#define MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE 0x0C81
#define MIP_3DM_GNSS_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x81
MIP_FIELD(mip_3dm_gnss_message_format_response, 0x81);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gnss_message_format *mip_3dm_gnss_message_format_write_from(
    struct mip_3dm_gnss_message_format *command,
    const struct mip_3dm_gnss_message_format_response *response) {
    return mip_3dm_gnss_message_format_write(command, response->num_descriptors,
                                             response->descriptors);
}

/**
 * Estimation filter message format: command (0x0C,0x0A).
 *
 * Sets the fields of the filter data packets (0x82), their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_filter_message_format_response.
 * Devices without it may have mip_3dm_message_format.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of fields. Counts the elements of descriptors. Required for write. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_FILTER_DATA_SET. Required for write. */
    struct mip_descriptor_rate descriptors[83];
};

#define MIP_3DM_FILTER_MESSAGE_FORMAT 0x0C0A
#define MIP_3DM_FILTER_MESSAGE_FORMAT_DESCRIPTOR 0x0A
MIP_FIELD(mip_3dm_filter_message_format, 0x0A);
MIP_FILL(mip_3dm_filter_message_format, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_filter_message_format, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_filter_message_format, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_filter_message_format, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * Estimation filter message format response: response (0x0C,0x82).
 *
 * Response to mip_3dm_filter_message_format.
 *
 * - 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
 */
struct mip_3dm_filter_message_format_response {
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t num_descriptors;
    /** Fields and decimations. Refers to fields of MIP_FILTER_DATA_SET. */
    struct mip_descriptor_rate descriptors[84];
};

#define MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE 0x0C82
#define MIP_3DM_FILTER_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x82
MIP_FIELD(mip_3dm_filter_message_format_response, 0x82);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_filter_message_format *mip_3dm_filter_message_format_write_from(
    struct mip_3dm_filter_message_format *command,
    const struct mip_3dm_filter_message_format_response *response) {
    return mip_3dm_filter_message_format_write(command, response->num_descriptors,
                                               response->descriptors);
}

/**
 * Get estimation filter data base rate: command (0x0C,0x0B).
 *
 * Gets the base rate, which is divided by the decimations of mip_3dm_filter_message_format.
 *
 * Also called `filter_get_base_rate`. Response: mip_3dm_get_filter_base_rate_response. Devices
 * without it may have mip_3dm_get_base_rate.
 *
 * - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
 */
struct mip_3dm_get_filter_base_rate {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_3DM_GET_FILTER_BASE_RATE 0x0C0B
#define MIP_3DM_GET_FILTER_BASE_RATE_DESCRIPTOR 0x0B
MIP_FIELD(mip_3dm_get_filter_base_rate, 0x0B);

/**
 * Get estimation filter data base rate response: response (0x0C,0x8A).
 *
 * Also called `filter_get_base_rate_response`. Response to mip_3dm_get_filter_base_rate.
 *
 * - 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
 */
struct mip_3dm_get_filter_base_rate_response {
    /** Base rate of the filter data. Unit: Hz. */
    uint16_t rate;
};

#define MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE 0x0C8A
#define MIP_3DM_GET_FILTER_BASE_RATE_RESPONSE_DESCRIPTOR 0x8A
MIP_FIELD(mip_3dm_get_filter_base_rate_response, 0x8A);

/**
 * NMEA message format: command (0x0C,0x0C).
 *
 * Sets the NMEA sentences that the device streams.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_nmea_message_format_response.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of sentences. Counts the elements of format_entries. Required for write. */
    uint8_t count;
    /** Sentences to stream. Required for write. */
    struct mip_nmea_message format_entries[50];
};

#define MIP_3DM_NMEA_MESSAGE_FORMAT 0x0C0C
#define MIP_3DM_NMEA_MESSAGE_FORMAT_DESCRIPTOR 0x0C
MIP_FIELD(mip_3dm_nmea_message_format, 0x0C);
MIP_FILL(mip_3dm_nmea_message_format, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_nmea_message_format, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_nmea_message_format, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_nmea_message_format, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * NMEA message format response: response (0x0C,0x8C).
 *
 * Response to mip_3dm_nmea_message_format.
 *
 * - 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
 */
struct mip_3dm_nmea_message_format_response {
    /** Number of sentences. Counts the elements of format_entries. */
    uint8_t count;
    /** Sentences to stream. */
    struct mip_nmea_message format_entries[50];
};

#define MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE 0x0C8C
#define MIP_3DM_NMEA_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x8C
MIP_FIELD(mip_3dm_nmea_message_format_response, 0x8C);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_nmea_message_format *mip_3dm_nmea_message_format_write_from(
    struct mip_3dm_nmea_message_format *command,
    const struct mip_3dm_nmea_message_format_response *response) {
    return mip_3dm_nmea_message_format_write(command, response->count, response->format_entries);
}

/**
 * Poll data: command (0x0C,0x0D).
 *
 * Requests one data packet of the descriptor set with the listed fields, in the listed order.
 *
 * Not acknowledged if suppress_ack is true. Devices without it may have mip_3dm_poll_imu_data,
 * mip_3dm_poll_gnss_data and mip_3dm_poll_filter_data.
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

#define MIP_3DM_POLL_DATA 0x0C0D
#define MIP_3DM_POLL_DATA_DESCRIPTOR 0x0D
MIP_FIELD(mip_3dm_poll_data, 0x0D);

/** Fills the structure, and returns it. */
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
 * Get data base rate: command (0x0C,0x0E).
 *
 * Gets the base rate, which is divided by the decimations of a descriptor set.
 *
 * Response: mip_3dm_get_base_rate_response. Devices without it may have mip_3dm_get_imu_base_rate,
 * mip_3dm_get_gnss_base_rate and mip_3dm_get_filter_base_rate.
 *
 * - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
 */
struct mip_3dm_get_base_rate {
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    uint8_t descriptor_set;
};

#define MIP_3DM_GET_BASE_RATE 0x0C0E
#define MIP_3DM_GET_BASE_RATE_DESCRIPTOR 0x0E
MIP_FIELD(mip_3dm_get_base_rate, 0x0E);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_get_base_rate *
mip_3dm_get_base_rate_make(struct mip_3dm_get_base_rate *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Get data base rate response: response (0x0C,0x8E).
 *
 * Response to mip_3dm_get_base_rate.
 *
 * - 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
 */
struct mip_3dm_get_base_rate_response {
    /** Data descriptor set specified in the command. */
    uint8_t descriptor_set;
    /** Base rate; 0 if the rate is variable or unknown and data is sent as it arrives. Unit: Hz. */
    uint16_t rate;
};

#define MIP_3DM_GET_BASE_RATE_RESPONSE 0x0C8E
#define MIP_3DM_GET_BASE_RATE_RESPONSE_DESCRIPTOR 0x8E
MIP_FIELD(mip_3dm_get_base_rate_response, 0x8E);

/**
 * Message format: command (0x0C,0x0F).
 *
 * Sets the fields of the data packets of a descriptor set, their order and their decimations.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_message_format_response.
 * Devices without it may have mip_3dm_imu_message_format, mip_3dm_gnss_message_format and
 * mip_3dm_filter_message_format.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_MESSAGE_FORMAT 0x0C0F
#define MIP_3DM_MESSAGE_FORMAT_DESCRIPTOR 0x0F
MIP_FIELD(mip_3dm_message_format, 0x0F);

/** Fills the structure for `write`, and returns it. */
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

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_read(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->descriptor_set = descriptor_set;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_save(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->descriptor_set = descriptor_set;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_load(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->descriptor_set = descriptor_set;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_default(struct mip_3dm_message_format *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Message format response: response (0x0C,0x8F).
 *
 * Response to mip_3dm_message_format.
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

#define MIP_3DM_MESSAGE_FORMAT_RESPONSE 0x0C8F
#define MIP_3DM_MESSAGE_FORMAT_RESPONSE_DESCRIPTOR 0x8F
MIP_FIELD(mip_3dm_message_format_response, 0x8F);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_message_format *
mip_3dm_message_format_write_from(struct mip_3dm_message_format *command,
                                  const struct mip_3dm_message_format_response *response) {
    return mip_3dm_message_format_write(command, response->descriptor_set,
                                        response->num_descriptors, response->descriptors);
}

/**
 * Factory streaming: command (0x0C,0x10).
 *
 * Sets all message formats to those that technical support needs in a recording.
 *
 * - 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
 */
struct mip_3dm_factory_streaming {
    /** Treatment of the existing formats. A value of enum mip_3dm_factory_streaming_action. */
    uint8_t action;
    /** Reserved: send 0. */
    uint8_t reserved;
};

#define MIP_3DM_FACTORY_STREAMING 0x0C10
#define MIP_3DM_FACTORY_STREAMING_DESCRIPTOR 0x10
MIP_FIELD(mip_3dm_factory_streaming, 0x10);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_factory_streaming *mip_3dm_factory_streaming_make(
    struct mip_3dm_factory_streaming *command, enum mip_3dm_factory_streaming_action action) {
    memset(command, 0, sizeof(*command));
    command->action = (uint8_t)action;
    return command;
}

/**
 * Data stream control: command (0x0C,0x11).
 *
 * Switches a data stream on or off.
 *
 * Also called `datastream_control`. Functions: write, read, save, load and default. Response:
 * mip_3dm_data_stream_control_response.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Data descriptor set; 0 means all streams (save, load, default). On the 3DM-CV5-10,
     * 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25,
     * 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream;
     * only MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
     * MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
     * 3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
     * 3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
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

#define MIP_3DM_DATA_STREAM_CONTROL 0x0C11
#define MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR 0x11
MIP_FIELD(mip_3dm_data_stream_control, 0x11);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_write(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set, mip_bool enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->descriptor_set = descriptor_set;
    command->enable = mip_truth(enable);
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_read(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->descriptor_set = descriptor_set;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_save(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->descriptor_set = descriptor_set;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_load(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->descriptor_set = descriptor_set;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_data_stream_control *mip_3dm_data_stream_control_default(
    struct mip_3dm_data_stream_control *command, uint8_t descriptor_set) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->descriptor_set = descriptor_set;
    return command;
}

/**
 * Data stream control response: response (0x0C,0x85).
 *
 * Also called `datastream_control_response`. Response to mip_3dm_data_stream_control.
 *
 * - 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
 * - 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
 */
struct mip_3dm_data_stream_control_response {
    /**
     * Stream specified in the command. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10,
     * 3DM-CX5-15, 3DM-CX5-25, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-25 and
     * 3DM-MV5-AR: values of enum mip_3dm_legacy_data_stream; only
     * MIP_3DM_LEGACY_DATA_STREAM_ALL_STREAMS, MIP_3DM_LEGACY_DATA_STREAM_IMU and
     * MIP_3DM_LEGACY_DATA_STREAM_FILTER. On the 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-35,
     * 3DM-GX3-45, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
     * 3DM-RQ1-IMU: values of enum mip_3dm_legacy_data_stream. On the 3DM-GX5-15: values of enum
     * mip_3dm_legacy_data_stream; only MIP_3DM_LEGACY_DATA_STREAM_IMU and
     * MIP_3DM_LEGACY_DATA_STREAM_FILTER.
     */
    uint8_t descriptor_set;
    /** True if the stream is sent. */
    mip_bool enabled;
};

#define MIP_3DM_DATA_STREAM_CONTROL_RESPONSE 0x0C85
#define MIP_3DM_DATA_STREAM_CONTROL_RESPONSE_DESCRIPTOR 0x85
MIP_FIELD(mip_3dm_data_stream_control_response, 0x85);

/**
 * Raw RTCM 2.3 message: command (0x0C,0x20).
 *
 * Sends RTCM 2.3 corrections to the GNSS receiver.
 *
 * Requires a receiver.
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

#define MIP_3DM_RAW_RTCM_2_3_MESSAGE 0x0C20
#define MIP_3DM_RAW_RTCM_2_3_MESSAGE_DESCRIPTOR 0x20
MIP_FIELD(mip_3dm_raw_rtcm_2_3_message, 0x20);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_raw_rtcm_2_3_message *mip_3dm_raw_rtcm_2_3_message_make(
    struct mip_3dm_raw_rtcm_2_3_message *command, uint8_t data_count, const uint8_t data_[]) {
    memset(command, 0, sizeof(*command));
    command->data_count = data_count;
    mip_copy(command->data, sizeof(command->data), data_,
             mip_counted(data_count, data_, sizeof(data_[0])));
    return command;
}

/**
 * Constellation settings: command (0x0C,0x21).
 *
 * Selects the constellations that the GNSS receiver tracks, and their shares of its tracking
 * channels.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_3dm_constellation_settings_response. Probably affects mip_gnss_data_fix_info,
 * mip_gnss_data_sv_info and mip_gnss_data_satellite_status. Requires a receiver. Uncertain: The
 * factory default is doubtful: the SDK names only GPS and GLONASS as enabled, but has channels for
 * SBAS and QZSS too.
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
 * - mip-sdk-4: Constellation settings (0x0C,0x21)
 * - 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
 */
struct mip_3dm_constellation_settings {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_CONSTELLATION_SETTINGS 0x0C21
#define MIP_3DM_CONSTELLATION_SETTINGS_DESCRIPTOR 0x21
MIP_FIELD(mip_3dm_constellation_settings, 0x21);
MIP_FILL(mip_3dm_constellation_settings, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_constellation_settings, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_constellation_settings, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_constellation_settings, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * Constellation settings response: response (0x0C,0xA0).
 *
 * Tracking channels of the receiver and the setting of each constellation.
 *
 * Response to mip_3dm_constellation_settings.
 *
 * - mip-sdk-4: Constellation settings (0x0C,0x21)
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

#define MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE 0x0CA0
#define MIP_3DM_CONSTELLATION_SETTINGS_RESPONSE_DESCRIPTOR 0xA0
MIP_FIELD(mip_3dm_constellation_settings_response, 0xA0);

/**
 * GNSS SBAS settings: command (0x0C,0x22).
 *
 * Sets how the GNSS receivers use satellite-based augmentation (SBAS).
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gnss_sbas_settings_response.
 * Probably affects mip_gnss_data_sbas_info and mip_gnss_data_sbas_correction. Requires a receiver.
 *
 * - 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
 */
struct mip_3dm_gnss_sbas_settings {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_GNSS_SBAS_SETTINGS 0x0C22
#define MIP_3DM_GNSS_SBAS_SETTINGS_DESCRIPTOR 0x22
MIP_FIELD(mip_3dm_gnss_sbas_settings, 0x22);
MIP_FILL(mip_3dm_gnss_sbas_settings, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_gnss_sbas_settings, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_gnss_sbas_settings, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_gnss_sbas_settings, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * GNSS SBAS settings response: response (0x0C,0xA1).
 *
 * Response to mip_3dm_gnss_sbas_settings.
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

#define MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE 0x0CA1
#define MIP_3DM_GNSS_SBAS_SETTINGS_RESPONSE_DESCRIPTOR 0xA1
MIP_FIELD(mip_3dm_gnss_sbas_settings_response, 0xA1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gnss_sbas_settings *
mip_3dm_gnss_sbas_settings_write_from(struct mip_3dm_gnss_sbas_settings *command,
                                      const struct mip_3dm_gnss_sbas_settings_response *response) {
    return mip_3dm_gnss_sbas_settings_write(command, response->enable_sbas, response->sbas_options,
                                            response->num_included_prns, response->included_prns);
}

/**
 * GNSS assisted fix: command (0x0C,0x23).
 *
 * Sets whether the GNSS receiver keeps the data of its last fix and starts from it at the next
 * power-up.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gnss_assisted_fix_response.
 * Known only from the MicroStrain MIP SDK. Requires a receiver.
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
 * - mip-sdk-4: GNSS assisted fix (0x0C,0x23)
 */
struct mip_3dm_gnss_assisted_fix {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_GNSS_ASSISTED_FIX 0x0C23
#define MIP_3DM_GNSS_ASSISTED_FIX_DESCRIPTOR 0x23
MIP_FIELD(mip_3dm_gnss_assisted_fix, 0x23);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_gnss_assisted_fix *mip_3dm_gnss_assisted_fix_write(
    struct mip_3dm_gnss_assisted_fix *command, enum mip_3dm_assisted_fix_option option) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->option = (uint8_t)option;
    command->flags = 255;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_read(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->flags = 255;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_save(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->flags = 255;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_load(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->flags = 255;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_default(struct mip_3dm_gnss_assisted_fix *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->flags = 255;
    return command;
}

/**
 * GNSS assisted fix response: response (0x0C,0xA2).
 *
 * Response to mip_3dm_gnss_assisted_fix. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: GNSS assisted fix (0x0C,0x23)
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

#define MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE 0x0CA2
#define MIP_3DM_GNSS_ASSISTED_FIX_RESPONSE_DESCRIPTOR 0xA2
MIP_FIELD(mip_3dm_gnss_assisted_fix_response, 0xA2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gnss_assisted_fix *
mip_3dm_gnss_assisted_fix_write_from(struct mip_3dm_gnss_assisted_fix *command,
                                     const struct mip_3dm_gnss_assisted_fix_response *response) {
    return mip_3dm_gnss_assisted_fix_write(command,
                                           (enum mip_3dm_assisted_fix_option)response->option);
}

/**
 * GNSS time assistance: command (0x0C,0x24).
 *
 * Sends the current GPS time to the GNSS receiver.
 *
 * Functions: write and read. Response: mip_3dm_gnss_time_assistance_response. Known only from the
 * MicroStrain MIP SDK. Requires a receiver.
 *
 * It is needed right after power-up if mip_3dm_gnss_assisted_fix was on at power-off.
 *
 * - mip-sdk-4: GNSS time assistance (0x0C,0x24)
 */
struct mip_3dm_gnss_time_assistance {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_GNSS_TIME_ASSISTANCE 0x0C24
#define MIP_3DM_GNSS_TIME_ASSISTANCE_DESCRIPTOR 0x24
MIP_FIELD(mip_3dm_gnss_time_assistance, 0x24);
MIP_FILL(mip_3dm_gnss_time_assistance, read, MIP_FUNCTION_SELECTOR_READ);

/** Fills the structure for `write`, and returns it. */
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

/**
 * GNSS time assistance response: response (0x0C,0xA3).
 *
 * Response to mip_3dm_gnss_time_assistance. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: GNSS time assistance (0x0C,0x24)
 */
struct mip_3dm_gnss_time_assistance_response {
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    double tow;
    /** GPS week number since 1980. Unit: week. */
    uint16_t week_number;
    /** Estimated accuracy of the time that is sent. Unit: s. Range: at least 0. */
    float accuracy;
};

#define MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE 0x0CA3
#define MIP_3DM_GNSS_TIME_ASSISTANCE_RESPONSE_DESCRIPTOR 0xA3
MIP_FIELD(mip_3dm_gnss_time_assistance_response, 0xA3);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gnss_time_assistance *mip_3dm_gnss_time_assistance_write_from(
    struct mip_3dm_gnss_time_assistance *command,
    const struct mip_3dm_gnss_time_assistance_response *response) {
    return mip_3dm_gnss_time_assistance_write(command, response->tow, response->week_number,
                                              response->accuracy);
}

/**
 * PPS source control: command (0x0C,0x28).
 *
 * Selects the source of the pulse per second (PPS).
 *
 * Also called `pps_source`. Functions: write, read, save, load and default. Response:
 * mip_3dm_pps_source_control_response. Affects mip_system_data_time_sync_status. Probably affects
 * mip_shared_gps_timestamp, mip_shared_external_timestamp and mip_sensor_gps_timestamp.
 *
 * The pins are configured separately, by mip_3dm_gpio_config.
 *
 * The filter needs a valid pulse; `disabled` and `generated` are rarely useful.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 */
struct mip_3dm_pps_source_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_PPS_SOURCE_CONTROL 0x0C28
#define MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR 0x28
MIP_FIELD(mip_3dm_pps_source_control, 0x28);
MIP_FILL(mip_3dm_pps_source_control, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_pps_source_control, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_pps_source_control, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_pps_source_control, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_pps_source_control *mip_3dm_pps_source_control_write(
    struct mip_3dm_pps_source_control *command, enum mip_3dm_pps_source source) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->source = (uint8_t)source;
    return command;
}

/**
 * PPS source control response: response (0x0C,0xA8).
 *
 * Also called `pps_source_response`. Response to mip_3dm_pps_source_control.
 *
 * - 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
 */
struct mip_3dm_pps_source_control_response {
    /** Source of the pulse. A value of enum mip_3dm_pps_source. */
    uint8_t source;
};

#define MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE 0x0CA8
#define MIP_3DM_PPS_SOURCE_CONTROL_RESPONSE_DESCRIPTOR 0xA8
MIP_FIELD(mip_3dm_pps_source_control_response, 0xA8);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_pps_source_control *
mip_3dm_pps_source_control_write_from(struct mip_3dm_pps_source_control *command,
                                      const struct mip_3dm_pps_source_control_response *response) {
    return mip_3dm_pps_source_control_write(command, (enum mip_3dm_pps_source)response->source);
}

/**
 * Get supported events: command (0x0C,0x2A).
 *
 * Gets the types of event triggers or actions that the device supports, and the number of each.
 *
 * Response: mip_3dm_get_event_support_response.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
struct mip_3dm_get_event_support {
    /** Triggers or actions. A value of enum mip_3dm_event_support_query. */
    uint8_t query;
};

#define MIP_3DM_GET_EVENT_SUPPORT 0x0C2A
#define MIP_3DM_GET_EVENT_SUPPORT_DESCRIPTOR 0x2A
MIP_FIELD(mip_3dm_get_event_support, 0x2A);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_get_event_support *mip_3dm_get_event_support_make(
    struct mip_3dm_get_event_support *command, enum mip_3dm_event_support_query query) {
    memset(command, 0, sizeof(*command));
    command->query = (uint8_t)query;
    return command;
}

/**
 * Get supported events response: response (0x0C,0xB4).
 *
 * Response to mip_3dm_get_event_support.
 *
 * - 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
 */
struct mip_3dm_get_event_support_response {
    /** Query specified in the command. A value of enum mip_3dm_event_support_query. */
    uint8_t query;
    /** Number of instances, which are numbered from 1. Unit: 1. */
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

#define MIP_3DM_GET_EVENT_SUPPORT_RESPONSE 0x0CB4
#define MIP_3DM_GET_EVENT_SUPPORT_RESPONSE_DESCRIPTOR 0xB4
MIP_FIELD(mip_3dm_get_event_support_response, 0xB4);

/**
 * Event control: command (0x0C,0x2B).
 *
 * Enables, disables or tests an event trigger.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_event_control_response.
 *
 * Triggers are disabled by default and after configuration.
 *
 * A trigger of type none cannot be enabled.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 */
struct mip_3dm_event_control {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_EVENT_CONTROL 0x0C2B
#define MIP_3DM_EVENT_CONTROL_DESCRIPTOR 0x2B
MIP_FIELD(mip_3dm_event_control, 0x2B);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_event_control *mip_3dm_event_control_write(
    struct mip_3dm_event_control *command, uint8_t instance, enum mip_event_trigger_mode mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->instance = instance;
    command->mode = (uint8_t)mode;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_read(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_save(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->instance = instance;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_load(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->instance = instance;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_event_control *
mip_3dm_event_control_default(struct mip_3dm_event_control *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->instance = instance;
    return command;
}

/**
 * Event control response: response (0x0C,0xB5).
 *
 * Response to mip_3dm_event_control.
 *
 * - 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
 */
struct mip_3dm_event_control_response {
    /** Trigger instance. */
    uint8_t instance;
    /**
     * Mode of the trigger. A value of enum mip_event_trigger_mode. Default:
     * MIP_EVENT_TRIGGER_MODE_DISABLED.
     */
    uint8_t mode;
};

#define MIP_3DM_EVENT_CONTROL_RESPONSE 0x0CB5
#define MIP_3DM_EVENT_CONTROL_RESPONSE_DESCRIPTOR 0xB5
MIP_FIELD(mip_3dm_event_control_response, 0xB5);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_event_control *mip_3dm_event_control_write_from(
    struct mip_3dm_event_control *command, const struct mip_3dm_event_control_response *response) {
    return mip_3dm_event_control_write(command, response->instance,
                                       (enum mip_event_trigger_mode)response->mode);
}

/**
 * Get event trigger status: command (0x0C,0x2C).
 *
 * Gets the type and the state of event triggers.
 *
 * Response: mip_3dm_get_event_trigger_status_response.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
struct mip_3dm_get_event_trigger_status {
    /**
     * Number of requested triggers; 0 requests all instances. Counts the elements of
     * requested_instances.
     */
    uint8_t requested_count;
    /** Numbers of the triggers to report; none for all. */
    uint8_t requested_instances[252];
};

#define MIP_3DM_GET_EVENT_TRIGGER_STATUS 0x0C2C
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_DESCRIPTOR 0x2C
MIP_FIELD(mip_3dm_get_event_trigger_status, 0x2C);

/** Fills the structure, and returns it. */
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
 * Get event trigger status response: response (0x0C,0xB6).
 *
 * Response to mip_3dm_get_event_trigger_status.
 *
 * - 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
 */
struct mip_3dm_get_event_trigger_status_response {
    /** Number of entries. Counts the elements of triggers. */
    uint8_t count;
    /** One entry per trigger, in the requested order, or by instance if all were requested. */
    struct mip_3dm_event_trigger_status_entry triggers[126];
};

#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE 0x0CB6
#define MIP_3DM_GET_EVENT_TRIGGER_STATUS_RESPONSE_DESCRIPTOR 0xB6
MIP_FIELD(mip_3dm_get_event_trigger_status_response, 0xB6);

/**
 * Get event action status: command (0x0C,0x2D).
 *
 * Gets the type and the trigger of event actions.
 *
 * Response: mip_3dm_get_event_action_status_response.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
struct mip_3dm_get_event_action_status {
    /**
     * Number of requested actions; 0 requests all instances. Counts the elements of
     * requested_instances.
     */
    uint8_t requested_count;
    /** Numbers of the actions to report; none for all. */
    uint8_t requested_instances[252];
};

#define MIP_3DM_GET_EVENT_ACTION_STATUS 0x0C2D
#define MIP_3DM_GET_EVENT_ACTION_STATUS_DESCRIPTOR 0x2D
MIP_FIELD(mip_3dm_get_event_action_status, 0x2D);

/** Fills the structure, and returns it. */
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
 * Get event action status response: response (0x0C,0xB7).
 *
 * Response to mip_3dm_get_event_action_status.
 *
 * - 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
 */
struct mip_3dm_get_event_action_status_response {
    /** Number of entries. Counts the elements of actions. */
    uint8_t count;
    /** One entry per action, in the requested order, or by instance if all were requested. */
    struct mip_3dm_event_action_status_entry actions[126];
};

#define MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE 0x0CB7
#define MIP_3DM_GET_EVENT_ACTION_STATUS_RESPONSE_DESCRIPTOR 0xB7
MIP_FIELD(mip_3dm_get_event_action_status_response, 0xB7);

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
 * Event trigger configuration: command (0x0C,0x2E).
 *
 * Configures the kind and the condition of an event trigger.
 *
 * Also called `event_trigger`. Functions: write, read, save, load and default. Response:
 * mip_3dm_event_trigger_config_response.
 *
 * The trigger is disabled afterwards; mip_3dm_event_control enables it.
 *
 * A GPIO trigger needs its pin configured by mip_3dm_gpio_config.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
struct mip_3dm_event_trigger_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_EVENT_TRIGGER_CONFIG 0x0C2E
#define MIP_3DM_EVENT_TRIGGER_CONFIG_DESCRIPTOR 0x2E
MIP_FIELD(mip_3dm_event_trigger_config, 0x2E);

/**
 * Fills the structure for `write`, and returns it.
 *
 * A type without a name cannot be sent: the function stays 0, and sending fails with
 * MIP_ERROR_MISSING.
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
    if (command->type != MIP_EVENT_TRIGGER_TYPE_NONE &&
        command->type != MIP_EVENT_TRIGGER_TYPE_GPIO &&
        command->type != MIP_EVENT_TRIGGER_TYPE_THRESHOLD &&
        command->type != MIP_EVENT_TRIGGER_TYPE_COMBINATION) {
        command->function = 0;
    }
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_event_trigger_config *
mip_3dm_event_trigger_config_read(struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_event_trigger_config *
mip_3dm_event_trigger_config_save(struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->instance = instance;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_event_trigger_config *
mip_3dm_event_trigger_config_load(struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->instance = instance;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_event_trigger_config *mip_3dm_event_trigger_config_default(
    struct mip_3dm_event_trigger_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->instance = instance;
    return command;
}

/**
 * Event trigger configuration response: response (0x0C,0xB8).
 *
 * Also called `event_trigger_response`. Response to mip_3dm_event_trigger_config.
 *
 * - 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
 */
struct mip_3dm_event_trigger_config_response {
    /** Trigger instance. */
    uint8_t instance;
    /**
     * Kind of trigger. A value of enum mip_event_trigger_type. Default:
     * MIP_EVENT_TRIGGER_TYPE_NONE.
     */
    uint8_t type;
    /** The condition. Selected by type. Empty if type is MIP_EVENT_TRIGGER_TYPE_NONE. */
    union mip_3dm_event_trigger_config_parameters parameters;
};

#define MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE 0x0CB8
#define MIP_3DM_EVENT_TRIGGER_CONFIG_RESPONSE_DESCRIPTOR 0xB8
MIP_FIELD(mip_3dm_event_trigger_config_response, 0xB8);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_event_trigger_config *mip_3dm_event_trigger_config_write_from(
    struct mip_3dm_event_trigger_config *command,
    const struct mip_3dm_event_trigger_config_response *response) {
    return mip_3dm_event_trigger_config_write(command, response->instance,
                                              (enum mip_event_trigger_type)response->type,
                                              &response->parameters);
}

/** The member of mip_3dm_event_action_config that `type` selects. */
union mip_3dm_event_action_config_parameters {
    /** If type is MIP_EVENT_ACTION_TYPE_GPIO. Controls a GPIO pin. */
    struct mip_event_action_gpio gpio;
    /** If type is MIP_EVENT_ACTION_TYPE_MESSAGE. Sends a data packet. */
    struct mip_event_action_message message;
};

/**
 * Event action configuration: command (0x0C,0x2F).
 *
 * Configures the trigger and the effect of an event action.
 *
 * Also called `event_action`. Functions: write, read, save, load and default. Response:
 * mip_3dm_event_action_config_response.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_EVENT_ACTION_CONFIG 0x0C2F
#define MIP_3DM_EVENT_ACTION_CONFIG_DESCRIPTOR 0x2F
MIP_FIELD(mip_3dm_event_action_config, 0x2F);

/**
 * Fills the structure for `write`, and returns it.
 *
 * A type without a name cannot be sent: the function stays 0, and sending fails with
 * MIP_ERROR_MISSING.
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
    if (command->type != MIP_EVENT_ACTION_TYPE_NONE &&
        command->type != MIP_EVENT_ACTION_TYPE_GPIO &&
        command->type != MIP_EVENT_ACTION_TYPE_MESSAGE) {
        command->function = 0;
    }
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_read(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_save(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->instance = instance;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_load(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->instance = instance;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_event_action_config *
mip_3dm_event_action_config_default(struct mip_3dm_event_action_config *command, uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->instance = instance;
    return command;
}

/**
 * Event action configuration response: response (0x0C,0xB9).
 *
 * Also called `event_action_response`. Response to mip_3dm_event_action_config.
 *
 * - 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
 * - 3dm-cv7-gnss-ins: Event Cycle
 */
struct mip_3dm_event_action_config_response {
    /** Action instance. */
    uint8_t instance;
    /** Trigger instance that the action follows. */
    uint8_t trigger;
    /**
     * Kind of action. A value of enum mip_event_action_type. Default: MIP_EVENT_ACTION_TYPE_NONE.
     */
    uint8_t type;
    /** Effect of the action. Selected by type. Empty if type is MIP_EVENT_ACTION_TYPE_NONE. */
    union mip_3dm_event_action_config_parameters parameters;
};

#define MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE 0x0CB9
#define MIP_3DM_EVENT_ACTION_CONFIG_RESPONSE_DESCRIPTOR 0xB9
MIP_FIELD(mip_3dm_event_action_config_response, 0xB9);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_event_action_config *mip_3dm_event_action_config_write_from(
    struct mip_3dm_event_action_config *command,
    const struct mip_3dm_event_action_config_response *response) {
    return mip_3dm_event_action_config_write(command, response->instance, response->trigger,
                                             (enum mip_event_action_type)response->type,
                                             &response->parameters);
}

/**
 * Device start up settings: command (0x0C,0x30).
 *
 * Saves, loads or resets all settings of the device at once.
 *
 * Functions: save, load and default. The device may take 2 s to reply.
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

#define MIP_3DM_DEVICE_SETTINGS 0x0C30
#define MIP_3DM_DEVICE_SETTINGS_DESCRIPTOR 0x30
MIP_FIELD(mip_3dm_device_settings, 0x30);
MIP_FILL(mip_3dm_device_settings, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_device_settings, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_device_settings, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/**
 * Sensor-to-vehicle frame transformation Euler: command (0x0C,0x31).
 *
 * Sets the mounting of the sensor in the vehicle as Euler angles.
 *
 * Also called `sensor_2_vehicle_transform_euler`. Functions: write, read, save, load and default.
 * Response: mip_3dm_sensor_to_vehicle_transform_euler_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion, mip_sensor_comp_euler_angles,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably affects mip_filter_data_comp_accel and
 * mip_sensor_comp_orientation_update_matrix.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: right
     * side down. Required for write.
     */
    float roll;
    /**
     * Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: nose
     * up. Required for write.
     */
    float pitch;
    /**
     * Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
     * clockwise seen from above. Required for write.
     */
    float yaw;
};

#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER 0x0C31
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_DESCRIPTOR 0x31
MIP_FIELD(mip_3dm_sensor_to_vehicle_transform_euler, 0x31);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_euler, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_euler, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_euler, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_euler, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * Sensor-to-vehicle frame transformation Euler response: response (0x0C,0xB1).
 *
 * Also called `sensor_2_vehicle_transform_euler_response`. Response to
 * mip_3dm_sensor_to_vehicle_transform_euler.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
 */
struct mip_3dm_sensor_to_vehicle_transform_euler_response {
    /**
     * Roll angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: right
     * side down.
     */
    float roll;
    /**
     * Pitch angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive: nose
     * up.
     */
    float pitch;
    /**
     * Yaw angle of the sensor relative to the vehicle. Unit: rad. Frame: vehicle. Positive:
     * clockwise seen from above.
     */
    float yaw;
};

#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE 0x0CB1
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_EULER_RESPONSE_DESCRIPTOR 0xB1
MIP_FIELD(mip_3dm_sensor_to_vehicle_transform_euler_response, 0xB1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_sensor_to_vehicle_transform_euler *
mip_3dm_sensor_to_vehicle_transform_euler_write_from(
    struct mip_3dm_sensor_to_vehicle_transform_euler *command,
    const struct mip_3dm_sensor_to_vehicle_transform_euler_response *response) {
    return mip_3dm_sensor_to_vehicle_transform_euler_write(command, response->roll, response->pitch,
                                                           response->yaw);
}

/**
 * Sensor-to-vehicle frame transformation quaternion: command (0x0C,0x32).
 *
 * Sets the mounting of the sensor in the vehicle as a quaternion.
 *
 * Also called `sensor_2_vehicle_transform_quaternion`. Functions: write, read, save, load and
 * default. Response: mip_3dm_sensor_to_vehicle_transform_quaternion_response. Affects
 * mip_sensor_scaled_accel, mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta,
 * mip_sensor_delta_velocity, mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion,
 * mip_sensor_comp_euler_angles, mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm,
 * mip_filter_data_euler_angles, mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably affects mip_filter_data_comp_accel and
 * mip_sensor_comp_orientation_update_matrix.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
     * Elements: w, x, y, z. Unit: 1. Required for write.
     */
    float q[4];
};

#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION 0x0C32
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_DESCRIPTOR 0x32
MIP_FIELD(mip_3dm_sensor_to_vehicle_transform_quaternion, 0x32);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_quaternion, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_quaternion, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_quaternion, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_quaternion, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_write(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command, const float q[4]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->q, q, sizeof(command->q));
    return command;
}

/**
 * Sensor-to-vehicle frame transformation quaternion response: response (0x0C,0xB2).
 *
 * Also called `sensor_2_vehicle_transform_quaternion_response`. Response to
 * mip_3dm_sensor_to_vehicle_transform_quaternion.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
 */
struct mip_3dm_sensor_to_vehicle_transform_quaternion_response {
    /**
     * Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
     * Elements: w, x, y, z. Unit: 1.
     */
    float q[4];
};

#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE 0x0CB2
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_QUATERNION_RESPONSE_DESCRIPTOR 0xB2
MIP_FIELD(mip_3dm_sensor_to_vehicle_transform_quaternion_response, 0xB2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_sensor_to_vehicle_transform_quaternion *
mip_3dm_sensor_to_vehicle_transform_quaternion_write_from(
    struct mip_3dm_sensor_to_vehicle_transform_quaternion *command,
    const struct mip_3dm_sensor_to_vehicle_transform_quaternion_response *response) {
    return mip_3dm_sensor_to_vehicle_transform_quaternion_write(command, response->q);
}

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix: command (0x0C,0x33).
 *
 * Sets the mounting of the sensor in the vehicle as a direction cosine matrix.
 *
 * Also called `sensor_2_vehicle_transform_dcm`. Functions: write, read, save, load and default.
 * Response: mip_3dm_sensor_to_vehicle_transform_dcm_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion, mip_sensor_comp_euler_angles,
 * mip_filter_data_attitude_quaternion, mip_filter_data_attitude_dcm, mip_filter_data_euler_angles,
 * mip_filter_data_linear_accel, mip_filter_data_comp_angular_rate and
 * mip_filter_data_gravity_vector. Probably affects mip_filter_data_comp_accel and
 * mip_sensor_comp_orientation_update_matrix.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12,
     * m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for write.
     */
    float dcm[9];
};

#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM 0x0C33
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_DESCRIPTOR 0x33
MIP_FIELD(mip_3dm_sensor_to_vehicle_transform_dcm, 0x33);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_dcm, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_dcm, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_dcm, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_sensor_to_vehicle_transform_dcm, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_write(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command, const float dcm[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->dcm, dcm, sizeof(command->dcm));
    return command;
}

/**
 * Sensor-to-vehicle frame transformation direction cosine matrix response: response (0x0C,0xB3).
 *
 * Also called `sensor_2_vehicle_transform_dcm_response`. Response to
 * mip_3dm_sensor_to_vehicle_transform_dcm.
 *
 * - 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33)
 */
struct mip_3dm_sensor_to_vehicle_transform_dcm_response {
    /**
     * Rotates vectors of the sensor frame into the vehicle frame; row-major. Elements: m11, m12,
     * m13, m21, m22, m23, m31, m32, m33. Unit: 1.
     */
    float dcm[9];
};

#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE 0x0CB3
#define MIP_3DM_SENSOR_TO_VEHICLE_TRANSFORM_DCM_RESPONSE_DESCRIPTOR 0xB3
MIP_FIELD(mip_3dm_sensor_to_vehicle_transform_dcm_response, 0xB3);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_sensor_to_vehicle_transform_dcm *
mip_3dm_sensor_to_vehicle_transform_dcm_write_from(
    struct mip_3dm_sensor_to_vehicle_transform_dcm *command,
    const struct mip_3dm_sensor_to_vehicle_transform_dcm_response *response) {
    return mip_3dm_sensor_to_vehicle_transform_dcm_write(command, response->dcm);
}

/**
 * GPS dynamics mode: command (0x0C,0x34).
 *
 * Sets the dynamics that the GNSS receiver assumes of the vehicle.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_gps_dynamics_mode_response. Probably affects mip_gnss_data_llh_position and
 * mip_gnss_data_ned_velocity. Known only from the MIP SDK of 2014 and MicroStrain Communication
 * Library. Requires a receiver. Uncertain: No source lists the devices that support it; the SDK of
 * 2014 uses it in its example for the 3DM-GX3-35 only.
 *
 * - mip-sdk-2014: GPS dynamics mode (0x0C,0x34)
 * - mscl: GPS dynamics mode (0x0C,0x34)
 */
struct mip_3dm_gps_dynamics_mode {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Assumed dynamics. A value of enum mip_3dm_receiver_dynamics. Required for write. */
    uint8_t mode;
};

#define MIP_3DM_GPS_DYNAMICS_MODE 0x0C34
#define MIP_3DM_GPS_DYNAMICS_MODE_DESCRIPTOR 0x34
MIP_FIELD(mip_3dm_gps_dynamics_mode, 0x34);
MIP_FILL(mip_3dm_gps_dynamics_mode, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_gps_dynamics_mode, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_gps_dynamics_mode, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_gps_dynamics_mode, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_gps_dynamics_mode *mip_3dm_gps_dynamics_mode_write(
    struct mip_3dm_gps_dynamics_mode *command, enum mip_3dm_receiver_dynamics mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->mode = (uint8_t)mode;
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

#define MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE 0x0C92
#define MIP_3DM_GPS_DYNAMICS_MODE_RESPONSE_DESCRIPTOR 0x92
MIP_FIELD(mip_3dm_gps_dynamics_mode_response, 0x92);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gps_dynamics_mode *
mip_3dm_gps_dynamics_mode_write_from(struct mip_3dm_gps_dynamics_mode *command,
                                     const struct mip_3dm_gps_dynamics_mode_response *response) {
    return mip_3dm_gps_dynamics_mode_write(command, (enum mip_3dm_receiver_dynamics)response->mode);
}

/**
 * IMU signal conditioning: command (0x0C,0x35).
 *
 * Configures the filters and the orientation algorithm of 3-series devices.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_imu_signal_conditioning_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_delta_theta, mip_sensor_delta_velocity,
 * mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion and mip_sensor_comp_euler_angles.
 * Probably affects mip_sensor_scaled_mag. Known only from the MIP SDK of 2014 and MicroStrain
 * Communication Library. Uncertain: The ranges, the defaults and some of the flags are those of the
 * single-byte protocol of the 3DM-GX3, which has the same record. Uncertain: No source lists the
 * devices that support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only.
 * Uncertain: MSCL reads the response without `reserved`, so some devices may not send it.
 *
 * The filters are moving averages; the first zero of their response is at 1000 Hz divided by the
 * width.
 *
 * - mip-sdk-2014: IMU signal conditioning (0x0C,0x35)
 * - mscl: IMU signal conditioning (0x0C,0x35)
 */
struct mip_3dm_imu_signal_conditioning {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_IMU_SIGNAL_CONDITIONING 0x0C35
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_DESCRIPTOR 0x35
MIP_FIELD(mip_3dm_imu_signal_conditioning, 0x35);
MIP_FILL(mip_3dm_imu_signal_conditioning, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_imu_signal_conditioning, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_imu_signal_conditioning, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_imu_signal_conditioning, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

#define MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE 0x0C86
#define MIP_3DM_IMU_SIGNAL_CONDITIONING_RESPONSE_DESCRIPTOR 0x86
MIP_FIELD(mip_3dm_imu_signal_conditioning_response, 0x86);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_imu_signal_conditioning *mip_3dm_imu_signal_conditioning_write_from(
    struct mip_3dm_imu_signal_conditioning *command,
    const struct mip_3dm_imu_signal_conditioning_response *response) {
    return mip_3dm_imu_signal_conditioning_write(
        command, response->orientation_decimation, response->data_conditioning_flags,
        response->inertial_filter_width, response->mag_filter_width, response->up_compensation,
        response->north_compensation, (enum mip_3dm_mag_bandwidth)response->mag_bandwidth);
}

/**
 * IMU timestamp: command (0x0C,0x36).
 *
 * Sets or reads a time counter of the sensor data.
 *
 * No device is known for certain to support it. Functions: write and read. Response:
 * mip_3dm_imu_timestamp_response. Known only from the MIP SDK of 2014. Uncertain: No source lists
 * the devices that support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only.
 * Uncertain: A read is assumed to omit `time`, which the device would ignore.
 *
 * - mip-sdk-2014: IMU timestamp (0x0C,0x36)
 */
struct mip_3dm_imu_timestamp {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Counter to set or read. A value of enum mip_3dm_imu_timestamp_selector. */
    uint8_t selector;
    /** Value of the counter, in the unit that `selector` selects. Required for write. */
    uint32_t time;
};

#define MIP_3DM_IMU_TIMESTAMP 0x0C36
#define MIP_3DM_IMU_TIMESTAMP_DESCRIPTOR 0x36
MIP_FIELD(mip_3dm_imu_timestamp, 0x36);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_imu_timestamp *
mip_3dm_imu_timestamp_write(struct mip_3dm_imu_timestamp *command,
                            enum mip_3dm_imu_timestamp_selector selector, uint32_t time) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->selector = (uint8_t)selector;
    command->time = time;
    return command;
}

/** Fills the structure for `read`, and returns it. */
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

#define MIP_3DM_IMU_TIMESTAMP_RESPONSE 0x0C93
#define MIP_3DM_IMU_TIMESTAMP_RESPONSE_DESCRIPTOR 0x93
MIP_FIELD(mip_3dm_imu_timestamp_response, 0x93);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_imu_timestamp *mip_3dm_imu_timestamp_write_from(
    struct mip_3dm_imu_timestamp *command, const struct mip_3dm_imu_timestamp_response *response) {
    return mip_3dm_imu_timestamp_write(
        command, (enum mip_3dm_imu_timestamp_selector)response->selector, response->time);
}

/**
 * Accelerometer bias configuration: command (0x0C,0x37).
 *
 * Sets the bias that is subtracted from the scaled acceleration.
 *
 * For advanced use. Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_accel_bias_response. Affects mip_sensor_scaled_accel. Probably affects
 * mip_sensor_delta_velocity and mip_filter_data_accel_bias. On the 3DM-CV7-GNSS/INS: write, read,
 * save, load and default only.
 *
 * - 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
 * - 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
 */
struct mip_3dm_accel_bias {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Bias that the device subtracts from the measured acceleration. Elements: x, y, z. Unit: g.
     * Frame: sensor. Required for write and apply.
     */
    float bias[3];
};

#define MIP_3DM_ACCEL_BIAS 0x0C37
#define MIP_3DM_ACCEL_BIAS_DESCRIPTOR 0x37
MIP_FIELD(mip_3dm_accel_bias, 0x37);
MIP_FILL(mip_3dm_accel_bias, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_accel_bias, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_accel_bias, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_accel_bias, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_write(struct mip_3dm_accel_bias *command, const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/** Fills the structure for `apply`, and returns it. */
static inline struct mip_3dm_accel_bias *
mip_3dm_accel_bias_apply(struct mip_3dm_accel_bias *command, const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/**
 * Accelerometer bias configuration response: response (0x0C,0x9A).
 *
 * Response to mip_3dm_accel_bias.
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

#define MIP_3DM_ACCEL_BIAS_RESPONSE 0x0C9A
#define MIP_3DM_ACCEL_BIAS_RESPONSE_DESCRIPTOR 0x9A
MIP_FIELD(mip_3dm_accel_bias_response, 0x9A);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_accel_bias *mip_3dm_accel_bias_write_from(
    struct mip_3dm_accel_bias *command, const struct mip_3dm_accel_bias_response *response) {
    return mip_3dm_accel_bias_write(command, response->bias);
}

/**
 * Gyroscope bias configuration: command (0x0C,0x38).
 *
 * Sets the bias that is subtracted from the scaled angular rate.
 *
 * For advanced use. Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_gyro_bias_response. Affects mip_sensor_scaled_gyro. Probably affects
 * mip_sensor_delta_theta, mip_filter_data_gyro_bias and mip_filter_data_status. On the
 * 3DM-CV7-AHRS: write, read, save, load and default only. On the 3DM-CV7-AR: write, read, save,
 * load and default only. On the 3DM-CV7-GNSS/INS: write, read, save, load and default only.
 *
 * - 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
 * - 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
 */
struct mip_3dm_gyro_bias {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Bias that the device subtracts from the measured angular rate. Elements: x, y, z. Unit:
     * rad/s. Frame: sensor. Required for write and apply.
     */
    float bias[3];
};

#define MIP_3DM_GYRO_BIAS 0x0C38
#define MIP_3DM_GYRO_BIAS_DESCRIPTOR 0x38
MIP_FIELD(mip_3dm_gyro_bias, 0x38);
MIP_FILL(mip_3dm_gyro_bias, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_gyro_bias, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_gyro_bias, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_gyro_bias, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_write(struct mip_3dm_gyro_bias *command,
                                                                const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/** Fills the structure for `apply`, and returns it. */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_apply(struct mip_3dm_gyro_bias *command,
                                                                const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/**
 * Gyroscope bias configuration response: response (0x0C,0x9B).
 *
 * The bias in use.
 *
 * Also called `capture_gyro_bias_response`. Response to mip_3dm_gyro_bias and
 * mip_3dm_capture_gyro_bias.
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

#define MIP_3DM_GYRO_BIAS_RESPONSE 0x0C9B
#define MIP_3DM_GYRO_BIAS_RESPONSE_DESCRIPTOR 0x9B
MIP_FIELD(mip_3dm_gyro_bias_response, 0x9B);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gyro_bias *mip_3dm_gyro_bias_write_from(
    struct mip_3dm_gyro_bias *command, const struct mip_3dm_gyro_bias_response *response) {
    return mip_3dm_gyro_bias_write(command, response->bias);
}

/**
 * Capture gyroscope bias: command (0x0C,0x39).
 *
 * Averages the angular rate of the device at rest and uses the result as the gyroscope bias.
 *
 * Response: mip_3dm_gyro_bias_response. Affects mip_sensor_scaled_gyro. Probably affects
 * mip_sensor_delta_theta, mip_filter_data_gyro_bias and mip_filter_data_status. The device may take
 * 31 s to reply.
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

#define MIP_3DM_CAPTURE_GYRO_BIAS 0x0C39
#define MIP_3DM_CAPTURE_GYRO_BIAS_DESCRIPTOR 0x39
MIP_FIELD(mip_3dm_capture_gyro_bias, 0x39);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_capture_gyro_bias *mip_3dm_capture_gyro_bias_make(
    struct mip_3dm_capture_gyro_bias *command, uint16_t averaging_time_ms) {
    memset(command, 0, sizeof(*command));
    command->averaging_time_ms = averaging_time_ms;
    return command;
}

/**
 * Magnetometer hard iron offset: command (0x0C,0x3A).
 *
 * Sets the offset that corrects the scaled magnetic field for hard iron.
 *
 * Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_mag_hard_iron_offset_response. Affects mip_sensor_scaled_mag. On the 3DM-CV7-AHRS: write,
 * read, save, load and default only. On the 3DM-CV7-GNSS/INS: write, read, save, load and default
 * only. Requires a magnetometer. Uncertain: The sources do not state the formula; it is inferred
 * from the terms.
 *
 * The values come from a calibration of the device as it is installed.
 *
 * On some devices, mip_filter_mag_capture_auto_calibration captures them from the filter's
 * automatic calibration.
 *
 * Before it sends mip_sensor_scaled_mag, the device corrects the field: the matrix times (measured
 * - offset), with the matrix of mip_3dm_mag_soft_iron_matrix.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
 * - 3dm-gx5-45: (0x0C, 0x3A)
 */
struct mip_3dm_mag_hard_iron_offset {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Offset that the device subtracts from the measured magnetic field. Elements: x, y, z. Unit:
     * gauss. Frame: sensor. Required for write and apply. On the 3DM-GX5-45: default 0, 0, 0.
     */
    float offset[3];
};

#define MIP_3DM_MAG_HARD_IRON_OFFSET 0x0C3A
#define MIP_3DM_MAG_HARD_IRON_OFFSET_DESCRIPTOR 0x3A
MIP_FIELD(mip_3dm_mag_hard_iron_offset, 0x3A);
MIP_FILL(mip_3dm_mag_hard_iron_offset, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_mag_hard_iron_offset, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_mag_hard_iron_offset, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_mag_hard_iron_offset, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_mag_hard_iron_offset *mip_3dm_mag_hard_iron_offset_write(
    struct mip_3dm_mag_hard_iron_offset *command, const float offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->offset, offset, sizeof(command->offset));
    return command;
}

/** Fills the structure for `apply`, and returns it. */
static inline struct mip_3dm_mag_hard_iron_offset *mip_3dm_mag_hard_iron_offset_apply(
    struct mip_3dm_mag_hard_iron_offset *command, const float offset[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->offset, offset, sizeof(command->offset));
    return command;
}

/**
 * Magnetometer hard iron offset response: response (0x0C,0x9C).
 *
 * Response to mip_3dm_mag_hard_iron_offset.
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

#define MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE 0x0C9C
#define MIP_3DM_MAG_HARD_IRON_OFFSET_RESPONSE_DESCRIPTOR 0x9C
MIP_FIELD(mip_3dm_mag_hard_iron_offset_response, 0x9C);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_mag_hard_iron_offset *mip_3dm_mag_hard_iron_offset_write_from(
    struct mip_3dm_mag_hard_iron_offset *command,
    const struct mip_3dm_mag_hard_iron_offset_response *response) {
    return mip_3dm_mag_hard_iron_offset_write(command, response->offset);
}

/**
 * Magnetometer soft iron matrix: command (0x0C,0x3B).
 *
 * Sets the matrix that corrects the scaled magnetic field for soft iron.
 *
 * Functions: write, read, save, load, default and apply. Response:
 * mip_3dm_mag_soft_iron_matrix_response. Affects mip_sensor_scaled_mag. On the 3DM-CV7-AHRS: write,
 * read, save, load and default only. On the 3DM-CV7-GNSS/INS: write, read, save, load and default
 * only. Requires a magnetometer. Uncertain: The sources do not state the formula; it is inferred
 * from the terms.
 *
 * The values come from a calibration of the device as it is installed.
 *
 * On some devices, mip_filter_mag_capture_auto_calibration captures them from the filter's
 * automatic calibration.
 *
 * Before it sends mip_sensor_scaled_mag, the device corrects the field: the matrix times (measured
 * - offset), with the offset of mip_3dm_mag_hard_iron_offset.
 *
 * - 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
 * - 3dm-gx5-35: (0x0C, 0x3B)
 */
struct mip_3dm_mag_soft_iron_matrix {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Soft iron matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.
     * Unit: 1. Frame: sensor. Required for write and apply.
     */
    float matrix[9];
};

#define MIP_3DM_MAG_SOFT_IRON_MATRIX 0x0C3B
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_DESCRIPTOR 0x3B
MIP_FIELD(mip_3dm_mag_soft_iron_matrix, 0x3B);
MIP_FILL(mip_3dm_mag_soft_iron_matrix, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_mag_soft_iron_matrix, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_mag_soft_iron_matrix, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_mag_soft_iron_matrix, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_mag_soft_iron_matrix *mip_3dm_mag_soft_iron_matrix_write(
    struct mip_3dm_mag_soft_iron_matrix *command, const float matrix[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->matrix, matrix, sizeof(command->matrix));
    return command;
}

/** Fills the structure for `apply`, and returns it. */
static inline struct mip_3dm_mag_soft_iron_matrix *mip_3dm_mag_soft_iron_matrix_apply(
    struct mip_3dm_mag_soft_iron_matrix *command, const float matrix[9]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    memcpy(command->matrix, matrix, sizeof(command->matrix));
    return command;
}

/**
 * Magnetometer soft iron matrix response: response (0x0C,0x9D).
 *
 * Response to mip_3dm_mag_soft_iron_matrix.
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

#define MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE 0x0C9D
#define MIP_3DM_MAG_SOFT_IRON_MATRIX_RESPONSE_DESCRIPTOR 0x9D
MIP_FIELD(mip_3dm_mag_soft_iron_matrix_response, 0x9D);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_mag_soft_iron_matrix *mip_3dm_mag_soft_iron_matrix_write_from(
    struct mip_3dm_mag_soft_iron_matrix *command,
    const struct mip_3dm_mag_soft_iron_matrix_response *response) {
    return mip_3dm_mag_soft_iron_matrix_write(command, response->matrix);
}

/**
 * Coning and sculling enable: command (0x0C,0x3E).
 *
 * Enables or disables coning and sculling compensation.
 *
 * Functions: write, read, save, load and default. Response:
 * mip_3dm_coning_sculling_enable_response. Probably affects mip_sensor_delta_theta and
 * mip_sensor_delta_velocity.
 *
 * - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
 */
struct mip_3dm_coning_sculling_enable {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** True if the compensation is on. Default: true. Required for write. */
    mip_bool enable;
};

#define MIP_3DM_CONING_SCULLING_ENABLE 0x0C3E
#define MIP_3DM_CONING_SCULLING_ENABLE_DESCRIPTOR 0x3E
MIP_FIELD(mip_3dm_coning_sculling_enable, 0x3E);
MIP_FILL(mip_3dm_coning_sculling_enable, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_coning_sculling_enable, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_coning_sculling_enable, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_coning_sculling_enable, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_coning_sculling_enable *mip_3dm_coning_sculling_enable_write(
    struct mip_3dm_coning_sculling_enable *command, mip_bool enable) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->enable = mip_truth(enable);
    return command;
}

/**
 * Coning and sculling enable response: response (0x0C,0x9E).
 *
 * Response to mip_3dm_coning_sculling_enable.
 *
 * - 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
 */
struct mip_3dm_coning_sculling_enable_response {
    /** True if the compensation is on. Default: true. */
    mip_bool enable;
};

#define MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE 0x0C9E
#define MIP_3DM_CONING_SCULLING_ENABLE_RESPONSE_DESCRIPTOR 0x9E
MIP_FIELD(mip_3dm_coning_sculling_enable_response, 0x9E);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_coning_sculling_enable *mip_3dm_coning_sculling_enable_write_from(
    struct mip_3dm_coning_sculling_enable *command,
    const struct mip_3dm_coning_sculling_enable_response *response) {
    return mip_3dm_coning_sculling_enable_write(command, response->enable);
}

/**
 * UART baud rate: command (0x0C,0x40).
 *
 * Sets the baud rate of the main port.
 *
 * Also called `uart_baudrate`. Functions: write, read, save, load and default. Response:
 * mip_3dm_uart_baud_rate_response. Devices without it may have mip_base_comm_speed.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * New baud rate; the port must support it. Unit: Bd. Required for write. On the 3DM-GX5-15 and
     * 3DM-GX5-45: default 115200.
     */
    uint32_t baud;
};

#define MIP_3DM_UART_BAUD_RATE 0x0C40
#define MIP_3DM_UART_BAUD_RATE_DESCRIPTOR 0x40
MIP_FIELD(mip_3dm_uart_baud_rate, 0x40);
MIP_FILL(mip_3dm_uart_baud_rate, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_uart_baud_rate, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_uart_baud_rate, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_uart_baud_rate, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_write(struct mip_3dm_uart_baud_rate *command, uint32_t baud) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->baud = baud;
    return command;
}

/**
 * UART baud rate response: response (0x0C,0x87).
 *
 * Also called `uart_baudrate_response`. Response to mip_3dm_uart_baud_rate.
 *
 * - 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
 * - 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
 */
struct mip_3dm_uart_baud_rate_response {
    /** New baud rate; the port must support it. Unit: Bd. */
    uint32_t baud;
};

#define MIP_3DM_UART_BAUD_RATE_RESPONSE 0x0C87
#define MIP_3DM_UART_BAUD_RATE_RESPONSE_DESCRIPTOR 0x87
MIP_FIELD(mip_3dm_uart_baud_rate_response, 0x87);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_uart_baud_rate *
mip_3dm_uart_baud_rate_write_from(struct mip_3dm_uart_baud_rate *command,
                                  const struct mip_3dm_uart_baud_rate_response *response) {
    return mip_3dm_uart_baud_rate_write(command, response->baud);
}

/**
 * GPIO configuration: command (0x0C,0x41).
 *
 * Sets the use of a GPIO pin.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_gpio_config_response. Probably
 * affects mip_system_data_gpio_state and mip_system_data_gpio_analog_value.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_GPIO_CONFIG 0x0C41
#define MIP_3DM_GPIO_CONFIG_DESCRIPTOR 0x41
MIP_FIELD(mip_3dm_gpio_config, 0x41);

/** Fills the structure for `write`, and returns it. */
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

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_read(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->pin = pin;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_save(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->pin = pin;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_load(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->pin = pin;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_gpio_config *
mip_3dm_gpio_config_default(struct mip_3dm_gpio_config *command, uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->pin = pin;
    return command;
}

/**
 * GPIO configuration response: response (0x0C,0xC1).
 *
 * Response to mip_3dm_gpio_config.
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

#define MIP_3DM_GPIO_CONFIG_RESPONSE 0x0CC1
#define MIP_3DM_GPIO_CONFIG_RESPONSE_DESCRIPTOR 0xC1
MIP_FIELD(mip_3dm_gpio_config_response, 0xC1);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gpio_config *mip_3dm_gpio_config_write_from(
    struct mip_3dm_gpio_config *command, const struct mip_3dm_gpio_config_response *response) {
    return mip_3dm_gpio_config_write(command, response->pin,
                                     (enum mip_gpio_feature)response->feature, response->behavior,
                                     response->pin_mode);
}

/**
 * GPIO state: command (0x0C,0x42).
 *
 * Sets or reads the state of a GPIO pin.
 *
 * Functions: write and read. Response: mip_3dm_gpio_state_response. Affects
 * mip_system_data_gpio_state.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t pin;
    /** True means high. Required for write. */
    mip_bool state;
};

#define MIP_3DM_GPIO_STATE 0x0C42
#define MIP_3DM_GPIO_STATE_DESCRIPTOR 0x42
MIP_FIELD(mip_3dm_gpio_state, 0x42);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_gpio_state *
mip_3dm_gpio_state_write(struct mip_3dm_gpio_state *command, uint8_t pin, mip_bool state) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->pin = pin;
    command->state = mip_truth(state);
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_gpio_state *mip_3dm_gpio_state_read(struct mip_3dm_gpio_state *command,
                                                                 uint8_t pin) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->pin = pin;
    return command;
}

/**
 * GPIO state response: response (0x0C,0xC2).
 *
 * Response to mip_3dm_gpio_state.
 *
 * - 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
 */
struct mip_3dm_gpio_state_response {
    /** GPIO pin, counted from 1. Range: at least 1. */
    uint8_t pin;
    /** True means high. */
    mip_bool state;
};

#define MIP_3DM_GPIO_STATE_RESPONSE 0x0CC2
#define MIP_3DM_GPIO_STATE_RESPONSE_DESCRIPTOR 0xC2
MIP_FIELD(mip_3dm_gpio_state_response, 0xC2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_gpio_state *mip_3dm_gpio_state_write_from(
    struct mip_3dm_gpio_state *command, const struct mip_3dm_gpio_state_response *response) {
    return mip_3dm_gpio_state_write(command, response->pin, response->state);
}

/**
 * Odometer configuration: command (0x0C,0x43).
 *
 * Configures the input from a wheel encoder.
 *
 * Also called `odometer`. Functions: write, read, save, load and default. Response:
 * mip_3dm_odometer_config_response. Affects mip_sensor_odometer.
 *
 * - 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
 */
struct mip_3dm_odometer_config {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_ODOMETER_CONFIG 0x0C43
#define MIP_3DM_ODOMETER_CONFIG_DESCRIPTOR 0x43
MIP_FIELD(mip_3dm_odometer_config, 0x43);
MIP_FILL(mip_3dm_odometer_config, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_odometer_config, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_odometer_config, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_odometer_config, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * Odometer configuration response: response (0x0C,0xC3).
 *
 * Also called `odometer_response`. Response to mip_3dm_odometer_config.
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

#define MIP_3DM_ODOMETER_CONFIG_RESPONSE 0x0CC3
#define MIP_3DM_ODOMETER_CONFIG_RESPONSE_DESCRIPTOR 0xC3
MIP_FIELD(mip_3dm_odometer_config_response, 0xC3);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_odometer_config *
mip_3dm_odometer_config_write_from(struct mip_3dm_odometer_config *command,
                                   const struct mip_3dm_odometer_config_response *response) {
    return mip_3dm_odometer_config_write(command, (enum mip_3dm_odometer_mode)response->mode,
                                         response->scaling, response->uncertainty);
}

/**
 * Advanced low-pass filter settings: command (0x0C,0x50).
 *
 * Configures the low-pass filter of one sensor data quantity.
 *
 * For advanced use. Also called `imu_lowpass_filter`. Functions: write, read, save, load and
 * default. Response: mip_3dm_imu_low_pass_filter_response. Affects mip_sensor_scaled_accel,
 * mip_sensor_scaled_gyro, mip_sensor_scaled_mag and mip_sensor_scaled_pressure. Devices without it
 * may have mip_3dm_low_pass_filter. Deprecated on the 3DM-CV7-AHRS: use mip_3dm_low_pass_filter
 * instead. Deprecated on the 3DM-CV7-AR: use mip_3dm_low_pass_filter instead. Deprecated on the
 * 3DM-CV7-GNSS/INS: use mip_3dm_low_pass_filter instead. Deprecated on the 3DM-GQ7-GNSS/INS: use
 * mip_3dm_low_pass_filter instead. Requires firmware up to 1.0.07 on the 3DM-CV7-AHRS and
 * 3DM-CV7-AR. Requires firmware up to 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * The filter has one pole. By default it is on and its cutoff is half the rate of the message
 * format.
 *
 * - 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
 * - 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
 */
struct mip_3dm_imu_low_pass_filter {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_IMU_LOW_PASS_FILTER 0x0C50
#define MIP_3DM_IMU_LOW_PASS_FILTER_DESCRIPTOR 0x50
MIP_FIELD(mip_3dm_imu_low_pass_filter, 0x50);

/** Fills the structure for `write`, and returns it. */
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

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_read(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->target_descriptor = target_descriptor;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_save(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->target_descriptor = target_descriptor;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_load(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->target_descriptor = target_descriptor;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_default(
    struct mip_3dm_imu_low_pass_filter *command, uint8_t target_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->target_descriptor = target_descriptor;
    return command;
}

/**
 * Advanced low-pass filter settings response: response (0x0C,0x8B).
 *
 * Also called `imu_lowpass_filter_response`. Response to mip_3dm_imu_low_pass_filter.
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

#define MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE 0x0C8B
#define MIP_3DM_IMU_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR 0x8B
MIP_FIELD(mip_3dm_imu_low_pass_filter_response, 0x8B);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_imu_low_pass_filter *mip_3dm_imu_low_pass_filter_write_from(
    struct mip_3dm_imu_low_pass_filter *command,
    const struct mip_3dm_imu_low_pass_filter_response *response) {
    return mip_3dm_imu_low_pass_filter_write(command, response->target_descriptor, response->enable,
                                             response->manual, response->frequency);
}

/**
 * Complementary filter configuration: command (0x0C,0x51).
 *
 * Configures the complementary filter, which computes the attitude independently of the estimation
 * filter.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_complementary_filter_response.
 * Affects mip_sensor_comp_orientation_matrix, mip_sensor_comp_quaternion and
 * mip_sensor_comp_euler_angles. Probably affects mip_sensor_north_vector and mip_sensor_up_vector.
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
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_COMPLEMENTARY_FILTER 0x0C51
#define MIP_3DM_COMPLEMENTARY_FILTER_DESCRIPTOR 0x51
MIP_FIELD(mip_3dm_complementary_filter, 0x51);
MIP_FILL(mip_3dm_complementary_filter, read, MIP_FUNCTION_SELECTOR_READ);
MIP_FILL(mip_3dm_complementary_filter, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_complementary_filter, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_complementary_filter, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/** Fills the structure for `write`, and returns it. */
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

/**
 * Complementary filter configuration response: response (0x0C,0x97).
 *
 * Response to mip_3dm_complementary_filter.
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

#define MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE 0x0C97
#define MIP_3DM_COMPLEMENTARY_FILTER_RESPONSE_DESCRIPTOR 0x97
MIP_FIELD(mip_3dm_complementary_filter_response, 0x97);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_complementary_filter *mip_3dm_complementary_filter_write_from(
    struct mip_3dm_complementary_filter *command,
    const struct mip_3dm_complementary_filter_response *response) {
    return mip_3dm_complementary_filter_write(
        command, response->pitch_roll_enable, response->heading_enable,
        response->pitch_roll_time_constant, response->heading_time_constant);
}

/**
 * Sensor range: command (0x0C,0x52).
 *
 * Sets the measuring range of a sensor.
 *
 * Functions: write, read, save, load and default. Response: mip_3dm_sensor_range_response. Probably
 * affects mip_sensor_scaled_accel, mip_sensor_scaled_gyro and mip_sensor_overrange_status.
 *
 * mip_3dm_get_calibrated_sensor_ranges lists the settings. The device may reject other settings, or
 * measure incorrectly with them.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
struct mip_3dm_sensor_range {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. On the
     * 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
     * MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
     * MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
     */
    uint8_t sensor;
    /** Number of the range. Required for write. */
    uint8_t setting;
};

#define MIP_3DM_SENSOR_RANGE 0x0C52
#define MIP_3DM_SENSOR_RANGE_DESCRIPTOR 0x52
MIP_FIELD(mip_3dm_sensor_range, 0x52);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_write(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor, uint8_t setting) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->sensor = (uint8_t)sensor;
    command->setting = setting;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_read(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->sensor = (uint8_t)sensor;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_save(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->sensor = (uint8_t)sensor;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_load(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->sensor = (uint8_t)sensor;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_default(
    struct mip_3dm_sensor_range *command, enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Sensor range response: response (0x0C,0xD2).
 *
 * Response to mip_3dm_sensor_range.
 *
 * - 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
 */
struct mip_3dm_sensor_range_response {
    /** Sensor whose range is set or read. A value of enum mip_3dm_sensor_range_type. */
    uint8_t sensor;
    /** Number of the range. */
    uint8_t setting;
};

#define MIP_3DM_SENSOR_RANGE_RESPONSE 0x0CD2
#define MIP_3DM_SENSOR_RANGE_RESPONSE_DESCRIPTOR 0xD2
MIP_FIELD(mip_3dm_sensor_range_response, 0xD2);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_sensor_range *mip_3dm_sensor_range_write_from(
    struct mip_3dm_sensor_range *command, const struct mip_3dm_sensor_range_response *response) {
    return mip_3dm_sensor_range_write(command, (enum mip_3dm_sensor_range_type)response->sensor,
                                      response->setting);
}

/**
 * Get calibrated sensor ranges: command (0x0C,0x53).
 *
 * Gets the ranges that a sensor supports.
 *
 * Also called `calibrated_sensor_ranges`. Response: mip_3dm_get_calibrated_sensor_ranges_response.
 *
 * - 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
 */
struct mip_3dm_get_calibrated_sensor_ranges {
    /**
     * Sensor to query; `all` is not allowed. A value of enum mip_3dm_sensor_range_type. On the
     * 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only MIP_3DM_SENSOR_RANGE_TYPE_ALL,
     * MIP_3DM_SENSOR_RANGE_TYPE_ACCEL, MIP_3DM_SENSOR_RANGE_TYPE_GYRO and
     * MIP_3DM_SENSOR_RANGE_TYPE_PRESSURE.
     */
    uint8_t sensor;
};

#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES 0x0C53
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_DESCRIPTOR 0x53
MIP_FIELD(mip_3dm_get_calibrated_sensor_ranges, 0x53);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_get_calibrated_sensor_ranges *
mip_3dm_get_calibrated_sensor_ranges_make(struct mip_3dm_get_calibrated_sensor_ranges *command,
                                          enum mip_3dm_sensor_range_type sensor) {
    memset(command, 0, sizeof(*command));
    command->sensor = (uint8_t)sensor;
    return command;
}

/**
 * Get calibrated sensor ranges response: response (0x0C,0xD3).
 *
 * Also called `calibrated_sensor_ranges_response`. Response to
 * mip_3dm_get_calibrated_sensor_ranges.
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

#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE 0x0CD3
#define MIP_3DM_GET_CALIBRATED_SENSOR_RANGES_RESPONSE_DESCRIPTOR 0xD3
MIP_FIELD(mip_3dm_get_calibrated_sensor_ranges_response, 0xD3);

/**
 * Low-pass anti-aliasing filter: command (0x0C,0x54).
 *
 * Configures the low-pass filter of a data field.
 *
 * Also called `lowpass_filter`. Functions: write, read, save, load and default. Response:
 * mip_3dm_low_pass_filter_response. Affects mip_sensor_scaled_accel, mip_sensor_scaled_gyro,
 * mip_sensor_scaled_mag, mip_sensor_scaled_pressure, mip_filter_data_comp_accel,
 * mip_filter_data_comp_angular_rate and mip_filter_data_linear_accel. Devices without it may have
 * mip_3dm_imu_low_pass_filter. Requires firmware later than 1.0.07 on the 3DM-CV7-AHRS and
 * 3DM-CV7-AR. Requires firmware later than 1.0.10 on the 3DM-GQ7-GNSS/INS.
 *
 * Except for read, a field descriptor of 0 means all fields of the set; if both are 0, all sets are
 * meant.
 *
 * - 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
 */
struct mip_3dm_low_pass_filter {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
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

#define MIP_3DM_LOW_PASS_FILTER 0x0C54
#define MIP_3DM_LOW_PASS_FILTER_DESCRIPTOR 0x54
MIP_FIELD(mip_3dm_low_pass_filter, 0x54);

/** Fills the structure for `write`, and returns it. */
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

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_read(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_save(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_load(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/** Fills the structure for `default`, and returns it. */
static inline struct mip_3dm_low_pass_filter *mip_3dm_low_pass_filter_default(
    struct mip_3dm_low_pass_filter *command, uint8_t descriptor_set, uint8_t field_descriptor) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->descriptor_set = descriptor_set;
    command->field_descriptor = field_descriptor;
    return command;
}

/**
 * Low-pass anti-aliasing filter response: response (0x0C,0xD4).
 *
 * Also called `lowpass_filter_response`. Response to mip_3dm_low_pass_filter.
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

#define MIP_3DM_LOW_PASS_FILTER_RESPONSE 0x0CD4
#define MIP_3DM_LOW_PASS_FILTER_RESPONSE_DESCRIPTOR 0xD4
MIP_FIELD(mip_3dm_low_pass_filter_response, 0xD4);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_low_pass_filter *
mip_3dm_low_pass_filter_write_from(struct mip_3dm_low_pass_filter *command,
                                   const struct mip_3dm_low_pass_filter_response *response) {
    return mip_3dm_low_pass_filter_write(command, response->descriptor_set,
                                         response->field_descriptor, response->enable,
                                         response->manual, response->frequency);
}

/**
 * Data stream format: command (0x0C,0x60).
 *
 * Selects MIP data or the raw data of a sensor for a stream.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_data_stream_format_response. Known only from the MIP SDK of 2014 and
 * MicroStrain Communication Library. Uncertain: A comment in the SDK of 2014 restricts it to the
 * 3DM-GX3-35; no other source lists devices. Uncertain: Functions other than write are assumed not
 * to require `format`. The SDK of 2014 sends both parameters with every function, and a 0 in place
 * of `format`.
 *
 * In the wrapped format, packets of the sensor arrive in fields of the data sets: `sensor.aspp` and
 * `sensor.gxsb` for the IMU, `gnss_data.nmea` and `gnss_data.ubx` for the receiver.
 *
 * - mip-sdk-2014: Data stream format (0x0C,0x60)
 * - mscl: Data stream format (0x0C,0x60)
 */
struct mip_3dm_data_stream_format {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Stream whose format is set or read. A value of enum mip_3dm_internal_sensor. */
    uint8_t stream;
    /** Format of a data stream. A value of enum mip_3dm_stream_format. */
    uint8_t format;
};

#define MIP_3DM_DATA_STREAM_FORMAT 0x0C60
#define MIP_3DM_DATA_STREAM_FORMAT_DESCRIPTOR 0x60
MIP_FIELD(mip_3dm_data_stream_format, 0x60);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_write(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_read(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_save(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_data_stream_format *mip_3dm_data_stream_format_load(
    struct mip_3dm_data_stream_format *command, enum mip_3dm_internal_sensor stream,
    enum mip_3dm_stream_format format) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->stream = (uint8_t)stream;
    command->format = (uint8_t)format;
    return command;
}

/** Fills the structure for `default`, and returns it. */
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

#define MIP_3DM_DATA_STREAM_FORMAT_RESPONSE 0x0C88
#define MIP_3DM_DATA_STREAM_FORMAT_RESPONSE_DESCRIPTOR 0x88
MIP_FIELD(mip_3dm_data_stream_format_response, 0x88);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_data_stream_format *
mip_3dm_data_stream_format_write_from(struct mip_3dm_data_stream_format *command,
                                      const struct mip_3dm_data_stream_format_response *response) {
    return mip_3dm_data_stream_format_write(command, (enum mip_3dm_internal_sensor)response->stream,
                                            (enum mip_3dm_stream_format)response->format);
}

/**
 * Device power state: command (0x0C,0x61).
 *
 * Sets the power state of an internal sensor.
 *
 * No device is known for certain to support it. Functions: write, read, save, load and default.
 * Response: mip_3dm_device_power_state_response. The device may take 5 s to reply. Known only from
 * the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: A comment in the SDK of
 * 2014 names the 3DM-GX3-25 and the 3DM-GX3-35; no other source lists devices. Uncertain: The
 * time-out of 5 s is assumed; the SDK of 2014 uses one that is longer than usual. Uncertain:
 * Functions other than write are assumed not to require `state`. The SDK of 2014 sends `device`
 * with every function, and a 0 in place of `state`.
 *
 * - mip-sdk-2014: Device power state (0x0C,0x61)
 * - mscl: Device power state (0x0C,0x61)
 */
struct mip_3dm_device_power_state {
    /** Number of present parameters, of a decoded field. To send: 0, or a ..._WITH_... constant. */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /**
     * The sensor. A value of enum mip_3dm_internal_sensor. On the 3DM-GX3-15 and 3DM-GX3-25: only
     * MIP_3DM_INTERNAL_SENSOR_IMU.
     */
    uint8_t device;
    /**
     * Power state of an internal sensor. A value of enum mip_3dm_sensor_power_state. Required for
     * write.
     */
    uint8_t state;
};

#define MIP_3DM_DEVICE_POWER_STATE 0x0C61
#define MIP_3DM_DEVICE_POWER_STATE_DESCRIPTOR 0x61
MIP_FIELD(mip_3dm_device_power_state, 0x61);

/** Fills the structure for `write`, and returns it. */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_write(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_,
    enum mip_3dm_sensor_power_state state) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->device = (uint8_t)device_;
    command->state = (uint8_t)state;
    return command;
}

/** Fills the structure for `read`, and returns it. */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_read(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->device = (uint8_t)device_;
    return command;
}

/** Fills the structure for `save`, and returns it. */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_save(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->device = (uint8_t)device_;
    return command;
}

/** Fills the structure for `load`, and returns it. */
static inline struct mip_3dm_device_power_state *mip_3dm_device_power_state_load(
    struct mip_3dm_device_power_state *command, enum mip_3dm_internal_sensor device_) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->device = (uint8_t)device_;
    return command;
}

/** Fills the structure for `default`, and returns it. */
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

#define MIP_3DM_DEVICE_POWER_STATE_RESPONSE 0x0C89
#define MIP_3DM_DEVICE_POWER_STATE_RESPONSE_DESCRIPTOR 0x89
MIP_FIELD(mip_3dm_device_power_state_response, 0x89);

/** Fills the structure for `write` with the values of a response, and returns it. */
static inline struct mip_3dm_device_power_state *
mip_3dm_device_power_state_write_from(struct mip_3dm_device_power_state *command,
                                      const struct mip_3dm_device_power_state_response *response) {
    return mip_3dm_device_power_state_write(command, (enum mip_3dm_internal_sensor)response->device,
                                            (enum mip_3dm_sensor_power_state)response->state);
}

/**
 * GPS advanced settings: command (0x0C,0x62).
 *
 * Saves, loads or resets the settings of the GNSS receiver that were made in direct mode.
 *
 * No device is known for certain to support it. For advanced use. Functions: save, load and
 * default. Known only from the MIP SDK of 2014 and MicroStrain Communication Library. Requires a
 * receiver. Uncertain: A comment in the SDK of 2014 names the 3DM-GX3-35; no other source lists
 * devices.
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

#define MIP_3DM_GPS_ADVANCED_SETTINGS 0x0C62
#define MIP_3DM_GPS_ADVANCED_SETTINGS_DESCRIPTOR 0x62
MIP_FIELD(mip_3dm_gps_advanced_settings, 0x62);
MIP_FILL(mip_3dm_gps_advanced_settings, save, MIP_FUNCTION_SELECTOR_SAVE);
MIP_FILL(mip_3dm_gps_advanced_settings, load, MIP_FUNCTION_SELECTOR_LOAD);
MIP_FILL(mip_3dm_gps_advanced_settings, default, MIP_FUNCTION_SELECTOR_DEFAULT);

/**
 * Device status: command (0x0C,0x64).
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
 * mip_3dm_device_status_diagnostic_gx3_response.
 *
 * The device expects its own model number, which mip_base_get_device_info returns.
 *
 * Device families reply in different layouts. The selector and the length distinguish them.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

#define MIP_3DM_DEVICE_STATUS 0x0C64
#define MIP_3DM_DEVICE_STATUS_DESCRIPTOR 0x64
MIP_FIELD(mip_3dm_device_status, 0x64);

/** Fills the structure, and returns it. */
static inline struct mip_3dm_device_status *
mip_3dm_device_status_make(struct mip_3dm_device_status *command, uint16_t model_number,
                           enum mip_3dm_device_status_selector status_selector) {
    memset(command, 0, sizeof(*command));
    command->model_number = model_number;
    command->status_selector = (uint8_t)status_selector;
    return command;
}

/**
 * Basic device status (inertial sensor of the 3DM-RQ1-45): response (0x0C,0x90).
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
 * - mscl: Device status (0x0C,0x64)
 */
struct mip_3dm_device_status_basic_rq1_imu_response {
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: us. */
    uint64_t system_timer;
};

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_BASIC_RQ1_IMU_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_basic_rq1_imu_response, 0x90);

/**
 * Basic device status: response (0x0C,0x90).
 *
 * State and timer.
 *
 * Response to mip_3dm_device_status. The size of its data distinguishes it from
 * mip_3dm_device_status_basic_without_state_response and mip_3dm_device_status_basic_gx3_response.
 * Sent if status_selector is MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_BASIC_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_basic_response, 0x90);

/**
 * Basic device status (without state): response (0x0C,0x90).
 *
 * Timer only.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_basic_response and
 * mip_3dm_device_status_basic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC. Uncertain: MSCL uses it for the 3DM-GX4-15, 3DM-GX4-25,
 * 3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10, the SDK of 2014 for the 3DM-GX4-15, the 3DM-GX4-25 and the
 * inertial sensor of the 3DM-GX4-45; that the 3DM-CL5-10 has it is inferred. Uncertain: The manual
 * of the 3DM-GX5-45 documents it too, but for the model number of another device; MSCL uses the
 * layout with a state for that device.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
 */
struct mip_3dm_device_status_basic_without_state_response {
    /** Model number of the device. */
    uint16_t model_number;
    /** Reserved. */
    uint32_t status_flags;
    /** Time since start-up. Unit: ms. */
    uint32_t system_timer;
};

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_BASIC_WITHOUT_STATE_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_basic_without_state_response, 0x90);

/**
 * Diagnostic device status: response (0x0C,0x90).
 *
 * State, timer, and the counters of streams and port.
 *
 * Response to mip_3dm_device_status. The size of its data distinguishes it from
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_response, 0x90);

/**
 * Diagnostic device status (with GNSS): response (0x0C,0x90).
 *
 * State, timer, and the counters of pulses, streams, port and receiver.
 *
 * Response to mip_3dm_device_status. The size of its data distinguishes it from
 * mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: MSCL uses it for the 3DM-GX4-45 and the -35
 * and -45 of GX5 and CX5; its length is from a manual. Uncertain: MSCL lists only the names of the
 * values, from which the descriptions are inferred; the times are assumed to be in ms like the
 * system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GNSS_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_gnss_response, 0x90);

/**
 * Diagnostic device status (3DM-GQ4-45): response (0x0C,0x90).
 *
 * The layout with GNSS, plus flags for parts that could not be started.
 *
 * Response to mip_3dm_device_status. The size of its data distinguishes it from
 * mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: No known manual documents it. Uncertain:
 * MSCL lists only the names of the values, from which the descriptions are inferred; the times are
 * assumed to be in ms like the system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GQ4_45_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_gq4_45_response, 0x90);

/**
 * Diagnostic device status (3DM-RQ1-45): response (0x0C,0x90).
 *
 * The layout with GNSS, plus the temperature.
 *
 * Response to mip_3dm_device_status. The size of its data distinguishes it from
 * mip_3dm_device_status_diagnostic_response, mip_3dm_device_status_diagnostic_gnss_response,
 * mip_3dm_device_status_diagnostic_gq4_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: No known manual documents it. Uncertain:
 * MSCL lists only the names of the values, from which the descriptions are inferred; the times are
 * assumed to be in ms like the system timer.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_45_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_rq1_45_response, 0x90);

/**
 * Diagnostic device status (3DM-GX4-15, 3DM-GX4-25): response (0x0C,0x90).
 *
 * Timer, and counters of pulses, streams, port and USB.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_imu_response,
 * mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
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
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_gx4_response, 0x90);

/**
 * Diagnostic device status (IMU): response (0x0C,0x90).
 *
 * Timer, available sensors, temperature, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_gx4_imu_response,
 * mip_3dm_device_status_diagnostic_rq1_imu_response and
 * mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
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
 * - mscl: Device status (0x0C,0x64)
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
    /** Largest measurable angular rate. */
    uint16_t gyro_range;
    /** Largest measurable acceleration. */
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_IMU_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_imu_response, 0x90);

/**
 * Diagnostic device status (inertial sensor of the 3DM-GX4-45): response (0x0C,0x90).
 *
 * Timer, available sensors and their ranges, temperature, and the counters of pulses, stream and
 * port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_rq1_imu_response
 * and mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: The SDK of 2014 lists the names of the
 * values and the units of temperature and times; the descriptions are inferred from the names.
 * Uncertain: The units of the ranges are not known.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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
    /** Largest measurable angular rate. */
    uint16_t gyro_range;
    /** Largest measurable acceleration. */
    uint8_t accel_range;
    /** Largest measurable magnetic field. */
    float mag_range;
    /** Largest measurable pressure. */
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX4_IMU_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_gx4_imu_response, 0x90);

/**
 * Diagnostic device status (inertial sensor of the 3DM-RQ1-45): response (0x0C,0x90).
 *
 * Timer, temperature and supply, and the counters of pulses, stream and port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response
 * and mip_3dm_device_status_diagnostic_gx3_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: The SDK of 2014 lists the names of the
 * values and the units of temperature and times; the descriptions are inferred from the names.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_RQ1_IMU_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_rq1_imu_response, 0x90);

/**
 * Basic device status (3DM-GX3-35, 3DM-GX3-45): response (0x0C,0x90).
 *
 * State of the port.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_basic_response and
 * mip_3dm_device_status_basic_without_state_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_BASIC. Uncertain: Only the SDK of 2014 contains it, with the names
 * of the values; the descriptions are inferred from the names.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Basic status. Always 1.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_BASIC_GX3_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_basic_gx3_response, 0x90);

/**
 * Diagnostic device status (3DM-GX3-35, 3DM-GX3-45): response (0x0C,0x90).
 *
 * State of the port, and the counters of the port, USB, receiver and IMU.
 *
 * No device is known for certain to support it. Response to mip_3dm_device_status. The size of its
 * data distinguishes it from mip_3dm_device_status_diagnostic_response,
 * mip_3dm_device_status_diagnostic_gnss_response, mip_3dm_device_status_diagnostic_gq4_45_response,
 * mip_3dm_device_status_diagnostic_rq1_45_response, mip_3dm_device_status_diagnostic_gx4_response,
 * mip_3dm_device_status_diagnostic_imu_response, mip_3dm_device_status_diagnostic_gx4_imu_response
 * and mip_3dm_device_status_diagnostic_rq1_imu_response. Sent if status_selector is
 * MIP_3DM_DEVICE_STATUS_SELECTOR_DIAGNOSTIC. Uncertain: Only the SDK of 2014 contains it, with the
 * names of the values; the descriptions are inferred from the names.
 *
 * Parameters without a member, on the wire only:
 * - status_selector: Diagnostic status. Always 2.
 *
 * - 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
 * - 3dm-gx5-35: 4.2.22 Device Status (0x0C, 0x64)
 * - 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64)
 * - mscl: Device status (0x0C,0x64)
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

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE 0x0C90
#define MIP_3DM_DEVICE_STATUS_DIAGNOSTIC_GX3_RESPONSE_DESCRIPTOR 0x90
MIP_FIELD(mip_3dm_device_status_diagnostic_gx3_response, 0x90);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
