/**
 * @file
 *
 * Tools (0x01). Commands of every shape.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_TOOLS_H
#define MIP_TOOLS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/tools.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_tools Tools (0x01)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_TOOLS_SET 0x01

/** Which member the union has. */
enum mip_tools_shape MIP_ENUM_8 {
    /** The value `none`. */
    MIP_TOOLS_SHAPE_NONE = 0,
    /** The value `circle`. */
    MIP_TOOLS_SHAPE_CIRCLE = 1,
    /** The value `path`. */
    MIP_TOOLS_SHAPE_PATH = 2,
    /** The value `turn`. */
    MIP_TOOLS_SHAPE_TURN = 3,
    /** The value `label`. */
    MIP_TOOLS_SHAPE_LABEL = 4
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_tools_shape_name(uint8_t value);

/** How a circle is filled. */
enum mip_tools_fill MIP_ENUM_8 {
    /** The value `empty`. */
    MIP_TOOLS_FILL_EMPTY = 0,
    /** The value `solid`. */
    MIP_TOOLS_FILL_SOLID = 1,
    /** The value `striped`. */
    MIP_TOOLS_FILL_STRIPED = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_tools_fill_name(uint8_t value);

/** Two numbers. Full name: stripes. */
struct mip_tools_bars {
    /** Of a stripe. Unit: m. */
    double width;
    /** Of all stripes. Unit: deg. Range: -180 to 180. */
    float angle;
};

/** The member of mip_tools_circle that `fill` selects. */
union mip_tools_circle_filling {
    /** If fill is MIP_TOOLS_FILL_SOLID. A colour. */
    uint32_t solid;
    /** If fill is MIP_TOOLS_FILL_STRIPED. */
    struct mip_tools_bars striped;
};

/** Ends in a union of its own. */
struct mip_tools_circle {
    /** The middle. */
    struct mip_point center;
    /** Which member follows. A value of enum mip_tools_fill. */
    uint8_t fill;
    /** How it is filled. Selected by fill. Empty if fill is MIP_TOOLS_FILL_EMPTY. */
    union mip_tools_circle_filling filling;
};

/** A counted array at its end. */
struct mip_tools_path {
    /** Does it return to its start? */
    mip_bool closed;
    /** Number of points. Counts the elements of points. */
    uint8_t num_points;
    /** The points. */
    struct mip_point points[62];
};

/** What drives a pin. */
enum mip_tools_drive MIP_ENUM_8 {
    /** The value `off`. */
    MIP_TOOLS_DRIVE_OFF = 0,
    /** The value `pulse`. */
    MIP_TOOLS_DRIVE_PULSE = 1,
    /** The value `serial`. */
    MIP_TOOLS_DRIVE_SERIAL = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_tools_drive_name(uint8_t value);

/** Of a pulse. Full name: pulse_use. */
enum mip_tools_pulse MIP_ENUM_8 {
    /** The value `input`. */
    MIP_TOOLS_PULSE_INPUT = 1,
    /** The value `output`. */
    MIP_TOOLS_PULSE_OUTPUT = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_tools_pulse_name(uint8_t value);

/** Of a serial line. */
enum mip_tools_serial_use MIP_ENUM_8 {
    /** The value `receive`. */
    MIP_TOOLS_SERIAL_USE_RECEIVE = 1,
    /** The value `transmit`. */
    MIP_TOOLS_SERIAL_USE_TRANSMIT = 33
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_tools_serial_use_name(uint8_t value);

/** One of a list; what it is depends on what was asked for. */
struct mip_tools_reading {
    /** Of the reading. */
    uint8_t kind;
    /** Of the reading. */
    float value;
};

/** Of the model A. Full name: model_a_faults. */
typedef uint32_t mip_tools_a_faults;
/** Bit 0. */
#define MIP_TOOLS_A_FAULTS_CLOCK UINT32_C(0x00000001)
/** Bit 8. The sensor is broken. Concerns mip_measurements_accel and mip_tools_capture_bias. */
#define MIP_TOOLS_A_FAULTS_SENSOR UINT32_C(0x00000100)
/** Bit 24. */
#define MIP_TOOLS_A_FAULTS_SOLUTION UINT32_C(0x01000000)

/** Of the model B. */
typedef uint32_t mip_tools_model_b_faults;
/** Bit 0. */
#define MIP_TOOLS_MODEL_B_FAULTS_GENERAL UINT32_C(0x00000001)
/** Bit 1. */
#define MIP_TOOLS_MODEL_B_FAULTS_OVERLOAD UINT32_C(0x00000002)
/** Bit 12. */
#define MIP_TOOLS_MODEL_B_FAULTS_ACCEL UINT32_C(0x00001000)

/**
 * Ping: command (0x01,0x01).
 *
 * Tests the line.
 *
 * Supported by Model A, Model B, Model C and Old 1.
 *
 * - guide: Ping
 * - leaflet: Ping
 */
struct mip_tools_ping {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_PING 0x0101
/** Its descriptor. */
#define MIP_TOOLS_PING_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_TOOLS_PING_NAME "tools.ping"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_ping_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_ping_decode(struct mip_tools_ping *value,
                                              const struct mip_field *field) {
    return mip_decode_only(&mip_tools_ping_codec, 0x01, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_ping_encode(const struct mip_tools_ping *value,
                                                          struct mip_builder *builder) {
    return mip_encode(&mip_tools_ping_codec, value, builder);
}

/**
 * Settings: command (0x01,0x02).
 *
 * Every function, and a prefix of parameters for each.
 *
 * Functions: write, read, save, load, default and apply. Response: mip_tools_settings_response.
 * Supported by Model A, Model B and Model C. On the Model B: write and read only. On the Model C:
 * write, read and save only.
 *
 * - guide: Settings
 * - leaflet: Settings
 */
struct mip_tools_settings {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones; a ..._WITH_... constant sends all up to that one.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of the port, 0 for all. Range: 0 to 8. */
    uint8_t port;
    /**
     * What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read and
     * apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
     */
    uint8_t mode;
    /** Speed. Unit: Bd. Default: 115200. Required for write and apply. */
    uint32_t baud;
    /**
     * Required by no function, not even by write. Optional. If mode is MIP_MODE_FAST: unit s; range
     * 1 to 10; default 5. If mode is MIP_MODE_SLOW: unit m.
     */
    uint16_t limit;
    /** Reserved: send 1. Optional. */
    uint8_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_SETTINGS 0x0102
/** Its descriptor. */
#define MIP_TOOLS_SETTINGS_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_TOOLS_SETTINGS_NAME "tools.settings"
/** The value of `present` if limit is the last parameter that is present. */
#define MIP_TOOLS_SETTINGS_WITH_LIMIT 4
/** The value of `present` if reserved is the last parameter that is present. */
#define MIP_TOOLS_SETTINGS_WITH_RESERVED 5

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_settings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_settings_decode(struct mip_tools_settings *value,
                                                  const struct mip_field *field) {
    return mip_decode_only(&mip_tools_settings_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_tools_settings_encode(const struct mip_tools_settings *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_settings_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 * - mode: What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read
 *   and apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
 * - baud: Speed. Unit: Bd. Default: 115200. Required for write and apply.
 */
static inline struct mip_tools_settings *mip_tools_settings_write(
    struct mip_tools_settings *command, uint8_t port, enum mip_mode mode, uint32_t baud) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->port = port;
    command->mode = (uint8_t)mode;
    command->baud = baud;
    command->reserved = 1;
    return command;
}

/**
 * Send the current setting back in a response. Fills the structure and returns its address.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 * - mode: What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read
 *   and apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
 */
static inline struct mip_tools_settings *mip_tools_settings_read(struct mip_tools_settings *command,
                                                                 uint8_t port, enum mip_mode mode) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->port = port;
    command->mode = (uint8_t)mode;
    command->reserved = 1;
    return command;
}

/**
 * Save the current setting to non-volatile memory. Fills the structure and returns its address.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 */
static inline struct mip_tools_settings *mip_tools_settings_save(struct mip_tools_settings *command,
                                                                 uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    command->port = port;
    command->reserved = 1;
    return command;
}

/**
 * Load the saved setting. Fills the structure and returns its address.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 */
static inline struct mip_tools_settings *mip_tools_settings_load(struct mip_tools_settings *command,
                                                                 uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    command->port = port;
    command->reserved = 1;
    return command;
}

/**
 * Load the factory default setting. Fills the structure and returns its address.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 */
static inline struct mip_tools_settings *
mip_tools_settings_default(struct mip_tools_settings *command, uint8_t port) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    command->port = port;
    command->reserved = 1;
    return command;
}

/**
 * Apply the new setting and send no acknowledge (5-series devices). Fills the structure and returns
 * its address.
 *
 * - port: Number of the port, 0 for all. Range: 0 to 8.
 * - mode: What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. Required for write, read
 *   and apply. On the Model C: only MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
 * - baud: Speed. Unit: Bd. Default: 115200. Required for write and apply.
 */
static inline struct mip_tools_settings *mip_tools_settings_apply(
    struct mip_tools_settings *command, uint8_t port, enum mip_mode mode, uint32_t baud) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    command->port = port;
    command->mode = (uint8_t)mode;
    command->baud = baud;
    command->reserved = 1;
    return command;
}

/**
 * Settings response: response (0x01,0x82).
 *
 * Response to mip_tools_settings. Supported by Model A, Model B and Model C.
 *
 * - guide: Settings
 * - leaflet: Settings
 */
struct mip_tools_settings_response {
    /** Number of the port, 0 for all. Range: 0 to 8. */
    uint8_t port;
    /** What to do. A value of enum mip_mode. Default: MIP_MODE_FAST. */
    uint8_t mode;
    /** Speed. Unit: Bd. Default: 115200. */
    uint32_t baud;
    /**
     * Required by no function, not even by write. If mode is MIP_MODE_FAST: unit s; range 1 to 10;
     * default 5. If mode is MIP_MODE_SLOW: unit m.
     */
    uint16_t limit;
    /** Reserved. */
    uint8_t reserved;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_SETTINGS_RESPONSE 0x0182
/** Its descriptor. */
#define MIP_TOOLS_SETTINGS_RESPONSE_DESCRIPTOR 0x82
/** Its name in the specification. */
#define MIP_TOOLS_SETTINGS_RESPONSE_NAME "tools.settings_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_settings_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_settings_response_decode(
    struct mip_tools_settings_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_tools_settings_response_codec, 0x82, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_settings_response_encode(
    const struct mip_tools_settings_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_settings_response_codec, value, builder);
}

/**
 * Set time: command (0x01,0x03).
 *
 * Two responses for one command.
 *
 * Functions: write, read and apply. Response: mip_tools_set_time_fast_response or
 * mip_tools_set_time_slow_response. Supported by Model A and Model C.
 *
 * Send it once a second.
 *
 * - guide: Set time
 */
struct mip_tools_set_time {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Which half of the time. A value of enum mip_mode. */
    uint8_t part;
    /** The new value. Unit: s. Required for write and apply. */
    uint32_t value;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_SET_TIME 0x0103
/** Its descriptor. */
#define MIP_TOOLS_SET_TIME_DESCRIPTOR 0x03
/** Its name in the specification. */
#define MIP_TOOLS_SET_TIME_NAME "tools.set_time"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_set_time_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_set_time_decode(struct mip_tools_set_time *value,
                                                  const struct mip_field *field) {
    return mip_decode_only(&mip_tools_set_time_codec, 0x03, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_tools_set_time_encode(const struct mip_tools_set_time *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_set_time_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - part: Which half of the time. A value of enum mip_mode.
 * - value: The new value. Unit: s. Required for write and apply.
 */
static inline struct mip_tools_set_time *
mip_tools_set_time_write(struct mip_tools_set_time *command, enum mip_mode part, uint32_t value) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->part = (uint8_t)part;
    command->value = value;
    return command;
}

/**
 * Send the current setting back in a response. Fills the structure and returns its address.
 *
 * - part: Which half of the time. A value of enum mip_mode.
 */
static inline struct mip_tools_set_time *mip_tools_set_time_read(struct mip_tools_set_time *command,
                                                                 enum mip_mode part) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->part = (uint8_t)part;
    return command;
}

/**
 * Apply the new setting and send no acknowledge (5-series devices). Fills the structure and returns
 * its address.
 *
 * - part: Which half of the time. A value of enum mip_mode.
 * - value: The new value. Unit: s. Required for write and apply.
 */
static inline struct mip_tools_set_time *
mip_tools_set_time_apply(struct mip_tools_set_time *command, enum mip_mode part, uint32_t value) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_APPLY;
    command->part = (uint8_t)part;
    command->value = value;
    return command;
}

/**
 * Set time response: response (0x01,0x83).
 *
 * Response to mip_tools_set_time. Sent if part is MIP_MODE_FAST. Supported by Model A and Model C.
 *
 * - guide: Set time
 */
struct mip_tools_set_time_fast_response {
    /** The fast half. Unit: s. */
    uint32_t value;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_SET_TIME_FAST_RESPONSE 0x0183
/** Its descriptor. */
#define MIP_TOOLS_SET_TIME_FAST_RESPONSE_DESCRIPTOR 0x83
/** Its name in the specification. */
#define MIP_TOOLS_SET_TIME_FAST_RESPONSE_NAME "tools.set_time_fast_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_set_time_fast_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_set_time_fast_response_decode(
    struct mip_tools_set_time_fast_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_tools_set_time_fast_response_codec, 0x83, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_set_time_fast_response_encode(
    const struct mip_tools_set_time_fast_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_set_time_fast_response_codec, value, builder);
}

/**
 * Set time response: response (0x01,0x84).
 *
 * Response to mip_tools_set_time. Sent if part is MIP_MODE_SLOW. Supported by Model A and Model C.
 *
 * - guide: Set time
 */
struct mip_tools_set_time_slow_response {
    /** The slow half. Unit: s. */
    uint32_t value;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_SET_TIME_SLOW_RESPONSE 0x0184
/** Its descriptor. */
#define MIP_TOOLS_SET_TIME_SLOW_RESPONSE_DESCRIPTOR 0x84
/** Its name in the specification. */
#define MIP_TOOLS_SET_TIME_SLOW_RESPONSE_NAME "tools.set_time_slow_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_set_time_slow_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_set_time_slow_response_decode(
    struct mip_tools_set_time_slow_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_tools_set_time_slow_response_codec, 0x84, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_set_time_slow_response_encode(
    const struct mip_tools_set_time_slow_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_set_time_slow_response_codec, value, builder);
}

/**
 * Status: command (0x01,0x04).
 *
 * Layouts of one response, told apart by constants and by size.
 *
 * For advanced use. Response: mip_tools_status_paged, mip_tools_status_short,
 * mip_tools_status_long, mip_tools_status_old or mip_tools_full. The device may take 2.5 s to
 * reply. Supported by Model A, Model B and Model C.
 *
 * Parameters without a member, on the wire only:
 * - model: The model that the layouts belong to. Always 4711.
 *
 * - guide: Status
 */
struct mip_tools_status {
    /** Which layout. Range: 1 to 2. On the Model C: always 2. Inferred: It has one layout. */
    uint8_t selector;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_STATUS 0x0104
/** Its descriptor. */
#define MIP_TOOLS_STATUS_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_TOOLS_STATUS_NAME "tools.status"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_status_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_status_decode(struct mip_tools_status *value,
                                                const struct mip_field *field) {
    return mip_decode_only(&mip_tools_status_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_status_encode(const struct mip_tools_status *value,
                                                            struct mip_builder *builder) {
    return mip_encode(&mip_tools_status_codec, value, builder);
}

/**
 * Status. Fills the structure and returns its address.
 *
 * - selector: Which layout. Range: 1 to 2. On the Model C: always 2. Inferred: It has one layout.
 */
static inline struct mip_tools_status *mip_tools_status_make(struct mip_tools_status *command,
                                                             uint8_t selector) {
    memset(command, 0, sizeof(*command));
    command->selector = selector;
    return command;
}

/**
 * Status response: response (0x01,0x90).
 *
 * As long as the short layout. A further constant tells it from that one.
 *
 * Response to mip_tools_status. Sent if selector is 1. Supported by Model C.
 *
 * Parameters without a member, on the wire only:
 * - model: The model. Always 4711.
 * - selector: The short layout. Always 1.
 * - page: The page. Always 7.
 *
 * - guide: Status
 */
struct mip_tools_status_paged {
    /** Since start. Unit: s. */
    uint16_t uptime;
    /** How full it is. */
    uint8_t level;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_TOOLS_STATUS_PAGED 0x0190
/** Its descriptor. */
#define MIP_TOOLS_STATUS_PAGED_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_TOOLS_STATUS_PAGED_NAME "tools.status_paged"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_status_paged_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_status_paged_decode(struct mip_tools_status_paged *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_tools_status_paged_codec, 0x90, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_status_paged_encode(
    const struct mip_tools_status_paged *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_status_paged_codec, value, builder);
}

/**
 * Status response: response (0x01,0x90).
 *
 * Response to mip_tools_status. Sent if selector is 1. Supported by Model A and Model B.
 *
 * Parameters without a member, on the wire only:
 * - model: The model. Always 4711.
 * - selector: The short layout. Always 1.
 *
 * - guide: Status
 */
struct mip_tools_status_short {
    /**
     * Faults. On the Model A and Model C: values of mip_tools_a_faults. On the Model B: values of
     * mip_tools_model_b_faults.
     */
    uint32_t flags;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_TOOLS_STATUS_SHORT 0x0190
/** Its descriptor. */
#define MIP_TOOLS_STATUS_SHORT_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_TOOLS_STATUS_SHORT_NAME "tools.status_short"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_status_short_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_status_short_decode(struct mip_tools_status_short *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_tools_status_short_codec, 0x90, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_status_short_encode(
    const struct mip_tools_status_short *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_status_short_codec, value, builder);
}

/**
 * Status response: response (0x01,0x90).
 *
 * Response to mip_tools_status. Distinguished from mip_tools_status_old and mip_tools_full by the
 * size of its data. Sent if selector is 2. Supported by Model B.
 *
 * Parameters without a member, on the wire only:
 * - model: The model. Always 4711.
 * - selector: The long layout. Always 2.
 *
 * - guide: Status
 */
struct mip_tools_status_long {
    /**
     * Faults. On the Model A: values of mip_tools_a_faults. On the Model B: values of
     * mip_tools_model_b_faults. On the Model C: the values are unknown.
     */
    uint32_t flags;
    /** Since start. Unit: s. */
    uint64_t uptime;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_TOOLS_STATUS_LONG 0x0190
/** Its descriptor. */
#define MIP_TOOLS_STATUS_LONG_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_TOOLS_STATUS_LONG_NAME "tools.status_long"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_status_long_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_status_long_decode(struct mip_tools_status_long *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_tools_status_long_codec, 0x90, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_status_long_encode(
    const struct mip_tools_status_long *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_status_long_codec, value, builder);
}

/**
 * Status response: response (0x01,0x90).
 *
 * The long layout of old devices. Its size tells it from the others.
 *
 * Response to mip_tools_status. Distinguished from mip_tools_status_long and mip_tools_full by the
 * size of its data. Sent if selector is 2. Supported by Model A.
 *
 * Parameters without a member, on the wire only:
 * - model: The model. Always 4711.
 * - selector: The long layout. Always 2.
 *
 * - guide: Status
 */
struct mip_tools_status_old {
    /** Since start. Unit: s. */
    uint32_t uptime;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_TOOLS_STATUS_OLD 0x0190
/** Its descriptor. */
#define MIP_TOOLS_STATUS_OLD_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_TOOLS_STATUS_OLD_NAME "tools.status_old"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_status_old_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_status_old_decode(struct mip_tools_status_old *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_tools_status_old_codec, 0x90, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_tools_status_old_encode(const struct mip_tools_status_old *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_status_old_codec, value, builder);
}

/**
 * Status response: response (0x01,0x90).
 *
 * Full name: tools.status_full.
 *
 * Response to mip_tools_status. Distinguished from mip_tools_status_long and mip_tools_status_old
 * by the size of its data. Sent if selector is 2. Supported by Model C.
 *
 * Parameters without a member, on the wire only:
 * - model: The model. Always 4711.
 * - selector: The long layout. Always 2.
 *
 * - guide: Status
 */
struct mip_tools_full {
    /** Where it is. */
    struct mip_point place;
    /** Since start. Unit: s. */
    uint64_t uptime;
    /** What it does. A value of enum mip_mode. */
    uint8_t mode;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_TOOLS_FULL 0x0190
/** Its descriptor. */
#define MIP_TOOLS_FULL_DESCRIPTOR 0x90
/** Its name in the specification. */
#define MIP_TOOLS_FULL_NAME "tools.status_full"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_full_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_full_decode(struct mip_tools_full *value,
                                              const struct mip_field *field) {
    return mip_decode_only(&mip_tools_full_codec, 0x90, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_full_encode(const struct mip_tools_full *value,
                                                          struct mip_builder *builder) {
    return mip_encode(&mip_tools_full_codec, value, builder);
}

/**
 * Bias: command (0x01,0x05).
 *
 * Its response serves another command too.
 *
 * Functions: write, read, save, load and default. Response: mip_tools_bias_vector. Changes
 * mip_measurements_accel and mip_measurements_gust. Probably changes MIP_MORE_SET. Supported by
 * Model A and Model C.
 *
 * - guide: Bias
 * - leaflet: Bias
 */
struct mip_tools_bias {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. Required for write. */
    float bias[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_BIAS 0x0105
/** Its descriptor. */
#define MIP_TOOLS_BIAS_DESCRIPTOR 0x05
/** Its name in the specification. */
#define MIP_TOOLS_BIAS_NAME "tools.bias"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_bias_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_bias_decode(struct mip_tools_bias *value,
                                              const struct mip_field *field) {
    return mip_decode_only(&mip_tools_bias_codec, 0x05, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_bias_encode(const struct mip_tools_bias *value,
                                                          struct mip_builder *builder) {
    return mip_encode(&mip_tools_bias_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - bias: Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. Required for write.
 */
static inline struct mip_tools_bias *mip_tools_bias_write(struct mip_tools_bias *command,
                                                          const float bias[3]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    memcpy(command->bias, bias, sizeof(command->bias));
    return command;
}

/** Send the current setting back in a response. Fills the structure and returns its address. */
static inline struct mip_tools_bias *mip_tools_bias_read(struct mip_tools_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_tools_bias *mip_tools_bias_save(struct mip_tools_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/** Load the saved setting. Fills the structure and returns its address. */
static inline struct mip_tools_bias *mip_tools_bias_load(struct mip_tools_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_LOAD;
    return command;
}

/** Load the factory default setting. Fills the structure and returns its address. */
static inline struct mip_tools_bias *mip_tools_bias_default(struct mip_tools_bias *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return command;
}

/**
 * Bias response: response (0x01,0x9B).
 *
 * Response to mip_tools_bias and mip_tools_capture_bias. Supported by Model A and Model C.
 *
 * - guide: Bias
 * - leaflet: Bias
 */
struct mip_tools_bias_vector {
    /** Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. */
    float bias[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_BIAS_VECTOR 0x019B
/** Its descriptor. */
#define MIP_TOOLS_BIAS_VECTOR_DESCRIPTOR 0x9B
/** Its name in the specification. */
#define MIP_TOOLS_BIAS_VECTOR_NAME "tools.bias_vector"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_bias_vector_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_bias_vector_decode(struct mip_tools_bias_vector *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_tools_bias_vector_codec, 0x9B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_bias_vector_encode(
    const struct mip_tools_bias_vector *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_bias_vector_codec, value, builder);
}

/**
 * Capture bias: command (0x01,0x06).
 *
 * Measures the bias.
 *
 * Response: mip_tools_bias_vector. Probably changes mip_measurements_accel. Supported by Model A
 * and Model C. Deprecated on the Model C: use mip_tools_bias instead. On the Model C: firmware >=
 * 1.0, < 1.1.
 *
 * - guide: Capture bias
 */
struct mip_tools_capture_bias {
    /** How long. Unit: s. Range: 1 to 30. */
    uint16_t time;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_CAPTURE_BIAS 0x0106
/** Its descriptor. */
#define MIP_TOOLS_CAPTURE_BIAS_DESCRIPTOR 0x06
/** Its name in the specification. */
#define MIP_TOOLS_CAPTURE_BIAS_NAME "tools.capture_bias"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_capture_bias_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_capture_bias_decode(struct mip_tools_capture_bias *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_tools_capture_bias_codec, 0x06, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_capture_bias_encode(
    const struct mip_tools_capture_bias *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_capture_bias_codec, value, builder);
}

/**
 * Capture bias. Fills the structure and returns its address.
 *
 * - time: How long. Unit: s. Range: 1 to 30.
 */
static inline struct mip_tools_capture_bias *
mip_tools_capture_bias_make(struct mip_tools_capture_bias *command, uint16_t time) {
    memset(command, 0, sizeof(*command));
    command->time = time;
    return command;
}

/**
 * Formats: command (0x01,0x07).
 *
 * Counted arrays of structures and of numbers; not answered if told so.
 *
 * Not acknowledged if suppress_ack is true. Supported by Model A and Model C.
 *
 * - guide: Formats
 */
struct mip_tools_formats {
    /** Send no acknowledge. */
    mip_bool suppress_ack;
    /** Number of segments. Counts the elements of segments. */
    uint8_t num_segments;
    /** Between a counter and its array. Deprecated. */
    uint8_t checkpoint;
    /** The segments. */
    struct mip_segment segments[25];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_FORMATS 0x0107
/** Its descriptor. */
#define MIP_TOOLS_FORMATS_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_TOOLS_FORMATS_NAME "tools.formats"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_formats_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_formats_decode(struct mip_tools_formats *value,
                                                 const struct mip_field *field) {
    return mip_decode_only(&mip_tools_formats_codec, 0x07, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_formats_encode(const struct mip_tools_formats *value,
                                                             struct mip_builder *builder) {
    return mip_encode(&mip_tools_formats_codec, value, builder);
}

/**
 * Formats. Fills the structure and returns its address.
 *
 * - suppress_ack: Send no acknowledge.
 * - num_segments: Number of segments. Counts the elements of segments.
 * - checkpoint: Between a counter and its array. Deprecated.
 * - segments: The segments.
 */
static inline struct mip_tools_formats *mip_tools_formats_make(
    struct mip_tools_formats *command, mip_bool suppress_ack, uint8_t num_segments,
    uint8_t checkpoint, const struct mip_segment segments[]) {
    memset(command, 0, sizeof(*command));
    command->suppress_ack = mip_truth(suppress_ack);
    command->num_segments = num_segments;
    command->checkpoint = checkpoint;
    mip_copy(command->segments, sizeof(command->segments), segments,
             mip_counted(num_segments, segments, sizeof(segments[0])));
    return command;
}

/** The member of mip_tools_choice that `shape` selects. */
union mip_tools_choice_parameters {
    /** If shape is MIP_TOOLS_SHAPE_CIRCLE. */
    struct mip_tools_circle circle;
    /** If shape is MIP_TOOLS_SHAPE_PATH. */
    struct mip_tools_path path;
    /** If shape is MIP_TOOLS_SHAPE_TURN. A rotation. Elements: w, x, y, z. Unit: 1. */
    float rotation[4];
    /** If shape is MIP_TOOLS_SHAPE_LABEL. A name. */
    char label[9];
};

/**
 * Choice: command (0x01,0x08).
 *
 * A tagged union with an empty variant, nested unions, arrays and strings in it.
 *
 * Functions: write and read. Response: mip_tools_choice_response. Supported by Model A.
 *
 * - guide: Choice
 */
struct mip_tools_choice {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Which one. */
    uint8_t instance;
    /** Which member follows. A value of enum mip_tools_shape. Required for write. */
    uint8_t shape;
    /**
     * The member. Selected by shape. Required for write. Empty if shape is MIP_TOOLS_SHAPE_NONE.
     */
    union mip_tools_choice_parameters parameters;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_CHOICE 0x0108
/** Its descriptor. */
#define MIP_TOOLS_CHOICE_DESCRIPTOR 0x08
/** Its name in the specification. */
#define MIP_TOOLS_CHOICE_NAME "tools.choice"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_choice_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_choice_decode(struct mip_tools_choice *value,
                                                const struct mip_field *field) {
    return mip_decode_only(&mip_tools_choice_codec, 0x08, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_choice_encode(const struct mip_tools_choice *value,
                                                            struct mip_builder *builder) {
    return mip_encode(&mip_tools_choice_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - instance: Which one.
 * - shape: Which member follows. A value of enum mip_tools_shape. Required for write.
 * - parameters: The member. Selected by shape. Required for write. Empty if shape is
 *   MIP_TOOLS_SHAPE_NONE.
 */
static inline struct mip_tools_choice *mip_tools_choice_write(
    struct mip_tools_choice *command, uint8_t instance, enum mip_tools_shape shape,
    const union mip_tools_choice_parameters *parameters) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->instance = instance;
    command->shape = (uint8_t)shape;
    if (parameters != NULL) {
        command->parameters = *parameters;
    }
    return command;
}

/**
 * Send the current setting back in a response. Fills the structure and returns its address.
 *
 * - instance: Which one.
 */
static inline struct mip_tools_choice *mip_tools_choice_read(struct mip_tools_choice *command,
                                                             uint8_t instance) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->instance = instance;
    return command;
}

/** The member of mip_tools_choice_response that `shape` selects. */
union mip_tools_choice_response_parameters {
    /** If shape is MIP_TOOLS_SHAPE_CIRCLE. */
    struct mip_tools_circle circle;
    /** If shape is MIP_TOOLS_SHAPE_PATH. */
    struct mip_tools_path path;
    /** If shape is MIP_TOOLS_SHAPE_TURN. A rotation. Elements: w, x, y, z. Unit: 1. */
    float rotation[4];
    /** If shape is MIP_TOOLS_SHAPE_LABEL. A name. */
    char label[9];
};

/**
 * Choice response: response (0x01,0x88).
 *
 * Response to mip_tools_choice. Supported by Model A.
 *
 * - guide: Choice
 */
struct mip_tools_choice_response {
    /** Which one. */
    uint8_t instance;
    /** Which member follows. A value of enum mip_tools_shape. */
    uint8_t shape;
    /** The member. Selected by shape. Empty if shape is MIP_TOOLS_SHAPE_NONE. */
    union mip_tools_choice_response_parameters parameters;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_CHOICE_RESPONSE 0x0188
/** Its descriptor. */
#define MIP_TOOLS_CHOICE_RESPONSE_DESCRIPTOR 0x88
/** Its name in the specification. */
#define MIP_TOOLS_CHOICE_RESPONSE_NAME "tools.choice_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_choice_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_choice_response_decode(struct mip_tools_choice_response *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_tools_choice_response_codec, 0x88, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_choice_response_encode(
    const struct mip_tools_choice_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_choice_response_codec, value, builder);
}

/**
 * List: command (0x01,0x09).
 *
 * Optional counted array; a read may carry a zero count.
 *
 * Functions: write, read and save. Response: mip_tools_list_response. Supported by Model A and
 * Model C.
 *
 * - guide: List
 */
struct mip_tools_list {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** Number of items. Counts the elements of items. Required for write. */
    uint8_t count;
    /** The items. Required for write. */
    uint16_t items[125];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_LIST 0x0109
/** Its descriptor. */
#define MIP_TOOLS_LIST_DESCRIPTOR 0x09
/** Its name in the specification. */
#define MIP_TOOLS_LIST_NAME "tools.list"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_list_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_list_decode(struct mip_tools_list *value,
                                              const struct mip_field *field) {
    return mip_decode_only(&mip_tools_list_codec, 0x09, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_list_encode(const struct mip_tools_list *value,
                                                          struct mip_builder *builder) {
    return mip_encode(&mip_tools_list_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - count: Number of items. Counts the elements of items. Required for write.
 * - items: The items. Required for write.
 */
static inline struct mip_tools_list *mip_tools_list_write(struct mip_tools_list *command,
                                                          uint8_t count, const uint16_t items[]) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->count = count;
    mip_copy(command->items, sizeof(command->items), items,
             mip_counted(count, items, sizeof(items[0])));
    return command;
}

/** Send the current setting back in a response. Fills the structure and returns its address. */
static inline struct mip_tools_list *mip_tools_list_read(struct mip_tools_list *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    return command;
}

/** Save the current setting to non-volatile memory. Fills the structure and returns its address. */
static inline struct mip_tools_list *mip_tools_list_save(struct mip_tools_list *command) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_SAVE;
    return command;
}

/**
 * List response: response (0x01,0x89).
 *
 * Response to mip_tools_list. Supported by Model A and Model C.
 *
 * - guide: List
 */
struct mip_tools_list_response {
    /** Number of items. Counts the elements of items. */
    uint8_t count;
    /** The items. */
    uint16_t items[126];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_LIST_RESPONSE 0x0189
/** Its descriptor. */
#define MIP_TOOLS_LIST_RESPONSE_DESCRIPTOR 0x89
/** Its name in the specification. */
#define MIP_TOOLS_LIST_RESPONSE_NAME "tools.list_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_list_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_list_response_decode(struct mip_tools_list_response *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_tools_list_response_codec, 0x89, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_list_response_encode(
    const struct mip_tools_list_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_list_response_codec, value, builder);
}

/**
 * Inventory: command (0x01,0x0A).
 *
 * Answers with an array to the end of the field.
 *
 * Full name: tools.inventory.
 *
 * Response: mip_tools_stock_response. Supported by Model A and Model C.
 *
 * - guide: Inventory
 */
struct mip_tools_stock {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_STOCK 0x010A
/** Its descriptor. */
#define MIP_TOOLS_STOCK_DESCRIPTOR 0x0A
/** Its name in the specification. */
#define MIP_TOOLS_STOCK_NAME "tools.inventory"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_stock_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_stock_decode(struct mip_tools_stock *value,
                                               const struct mip_field *field) {
    return mip_decode_only(&mip_tools_stock_codec, 0x0A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_stock_encode(const struct mip_tools_stock *value,
                                                           struct mip_builder *builder) {
    return mip_encode(&mip_tools_stock_codec, value, builder);
}

/**
 * Inventory response: response (0x01,0x8A).
 *
 * Full name: tools.inventory_response.
 *
 * Response to mip_tools_stock. Supported by Model A and Model C.
 *
 * - guide: Inventory
 */
struct mip_tools_stock_response {
    /** The number of elements of descriptors. */
    uint8_t descriptors_count;
    /** As many as there are. */
    uint16_t descriptors[126];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_STOCK_RESPONSE 0x018A
/** Its descriptor. */
#define MIP_TOOLS_STOCK_RESPONSE_DESCRIPTOR 0x8A
/** Its name in the specification. */
#define MIP_TOOLS_STOCK_RESPONSE_NAME "tools.inventory_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_stock_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_stock_response_decode(struct mip_tools_stock_response *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_tools_stock_response_codec, 0x8A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_stock_response_encode(
    const struct mip_tools_stock_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_stock_response_codec, value, builder);
}

/**
 * Pin: command (0x01,0x0B).
 *
 * The names of one number depend on another.
 *
 * Functions: write and read. Response: mip_tools_pin_response. Supported by Model A and Model C.
 *
 * - guide: Pin
 */
struct mip_tools_pin {
    /**
     * Number of present parameters, without the function selector. Decoding sets it. 0 sends only
     * the required ones.
     */
    uint8_t present;
    /** Operation on the setting. A value of enum mip_function_selector. */
    uint8_t function;
    /** What drives it. A value of enum mip_tools_drive. */
    uint8_t drive;
    /**
     * How it is used. Required for write. If drive is MIP_TOOLS_DRIVE_PULSE: values of enum
     * mip_tools_pulse. If drive is MIP_TOOLS_DRIVE_SERIAL: values of enum mip_tools_serial_use.
     */
    uint8_t use;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_PIN 0x010B
/** Its descriptor. */
#define MIP_TOOLS_PIN_DESCRIPTOR 0x0B
/** Its name in the specification. */
#define MIP_TOOLS_PIN_NAME "tools.pin"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_pin_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_pin_decode(struct mip_tools_pin *value,
                                             const struct mip_field *field) {
    return mip_decode_only(&mip_tools_pin_codec, 0x0B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_pin_encode(const struct mip_tools_pin *value,
                                                         struct mip_builder *builder) {
    return mip_encode(&mip_tools_pin_codec, value, builder);
}

/**
 * Apply the new setting. Fills the structure and returns its address.
 *
 * - drive: What drives it. A value of enum mip_tools_drive.
 * - use: How it is used. Required for write. If drive is MIP_TOOLS_DRIVE_PULSE: values of enum
 *   mip_tools_pulse. If drive is MIP_TOOLS_DRIVE_SERIAL: values of enum mip_tools_serial_use.
 */
static inline struct mip_tools_pin *mip_tools_pin_write(struct mip_tools_pin *command,
                                                        enum mip_tools_drive drive, uint8_t use) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_WRITE;
    command->drive = (uint8_t)drive;
    command->use = use;
    return command;
}

/**
 * Send the current setting back in a response. Fills the structure and returns its address.
 *
 * - drive: What drives it. A value of enum mip_tools_drive.
 */
static inline struct mip_tools_pin *mip_tools_pin_read(struct mip_tools_pin *command,
                                                       enum mip_tools_drive drive) {
    memset(command, 0, sizeof(*command));
    command->function = MIP_FUNCTION_SELECTOR_READ;
    command->drive = (uint8_t)drive;
    return command;
}

/**
 * Pin response: response (0x01,0x8B).
 *
 * Response to mip_tools_pin. Supported by Model A and Model C.
 *
 * - guide: Pin
 */
struct mip_tools_pin_response {
    /** What drives it now. A value of enum mip_tools_drive. */
    uint8_t drive;
    /**
     * How it is used. If drive is MIP_TOOLS_DRIVE_PULSE: values of enum mip_tools_pulse. If drive
     * is MIP_TOOLS_DRIVE_SERIAL: values of enum mip_tools_serial_use.
     */
    uint8_t use;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_PIN_RESPONSE 0x018B
/** Its descriptor. */
#define MIP_TOOLS_PIN_RESPONSE_DESCRIPTOR 0x8B
/** Its name in the specification. */
#define MIP_TOOLS_PIN_RESPONSE_NAME "tools.pin_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_pin_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_pin_response_decode(struct mip_tools_pin_response *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_tools_pin_response_codec, 0x8B, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_pin_response_encode(
    const struct mip_tools_pin_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_pin_response_codec, value, builder);
}

/**
 * Hello: command (0x01,0x0C).
 *
 * The device asks and a host answers.
 *
 * No device is known for certain to support it. Also called `keep_alive`. Response:
 * mip_tools_hello_response. Sent by the device; the host replies. Known only from the Kit of names.
 *
 * - sheet: Hello
 */
struct mip_tools_hello {
    /**
     * Number of present parameters. Decoding sets it. 0 sends only the required ones; a
     * ..._WITH_... constant sends all up to that one.
     */
    uint8_t present;
    /** Reserved: send 1.0. */
    float reserved;
    /** Reserved: send 0.0. Optional. */
    double later[2];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_HELLO 0x010C
/** Its descriptor. */
#define MIP_TOOLS_HELLO_DESCRIPTOR 0x0C
/** Its name in the specification. */
#define MIP_TOOLS_HELLO_NAME "tools.hello"
/** The value of `present` if later is the last parameter that is present. */
#define MIP_TOOLS_HELLO_WITH_LATER 2

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_hello_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_hello_decode(struct mip_tools_hello *value,
                                               const struct mip_field *field) {
    return mip_decode_only(&mip_tools_hello_codec, 0x0C, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_hello_encode(const struct mip_tools_hello *value,
                                                           struct mip_builder *builder) {
    return mip_encode(&mip_tools_hello_codec, value, builder);
}

/**
 * Hello response: response (0x01,0x8C).
 *
 * No device is known for certain to support it. Also called `keep_alive_response` and `welcome`.
 * Response to mip_tools_hello. Known only from the Kit of names. Uncertain: When it comes.
 *
 * - sheet: Hello
 */
struct mip_tools_hello_response {
    /** When the device was seen. Unit: s. */
    uint32_t seen;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_HELLO_RESPONSE 0x018C
/** Its descriptor. */
#define MIP_TOOLS_HELLO_RESPONSE_DESCRIPTOR 0x8C
/** Its name in the specification. */
#define MIP_TOOLS_HELLO_RESPONSE_NAME "tools.hello_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_hello_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_hello_response_decode(struct mip_tools_hello_response *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_tools_hello_response_codec, 0x8C, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_hello_response_encode(
    const struct mip_tools_hello_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_hello_response_codec, value, builder);
}

/**
 * Readings: command (0x01,0x0D).
 *
 * A parameter outside of a structure says how its members are read.
 *
 * Response: mip_tools_readings_response. Supported by Model A and Model C.
 *
 * - guide: Readings
 */
struct mip_tools_readings {
    /** What is asked for. A value of enum mip_tools_drive. */
    uint8_t drive;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_READINGS 0x010D
/** Its descriptor. */
#define MIP_TOOLS_READINGS_DESCRIPTOR 0x0D
/** Its name in the specification. */
#define MIP_TOOLS_READINGS_NAME "tools.readings"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_readings_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_readings_decode(struct mip_tools_readings *value,
                                                  const struct mip_field *field) {
    return mip_decode_only(&mip_tools_readings_codec, 0x0D, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_tools_readings_encode(const struct mip_tools_readings *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_readings_codec, value, builder);
}

/**
 * Readings. Fills the structure and returns its address.
 *
 * - drive: What is asked for. A value of enum mip_tools_drive.
 */
static inline struct mip_tools_readings *mip_tools_readings_make(struct mip_tools_readings *command,
                                                                 enum mip_tools_drive drive) {
    memset(command, 0, sizeof(*command));
    command->drive = (uint8_t)drive;
    return command;
}

/**
 * Readings response: response (0x01,0x8D).
 *
 * Response to mip_tools_readings. Supported by Model A and Model C.
 *
 * - guide: Readings
 */
struct mip_tools_readings_response {
    /** What was asked for. A value of enum mip_tools_drive. */
    uint8_t drive;
    /** Number of readings. Counts the elements of readings. */
    uint8_t count;
    /**
     * The readings. If drive is MIP_TOOLS_DRIVE_PULSE: kind has values of enum mip_tools_pulse.
     * Seldom 2. If drive is MIP_TOOLS_DRIVE_SERIAL: kind has values of enum mip_tools_serial_use.
     */
    struct mip_tools_reading readings[49];
    /**
     * The last one. If drive is MIP_TOOLS_DRIVE_PULSE: value has unit s; range 0 to 1. If drive is
     * MIP_TOOLS_DRIVE_SERIAL: value: Nothing.
     */
    struct mip_tools_reading last;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_READINGS_RESPONSE 0x018D
/** Its descriptor. */
#define MIP_TOOLS_READINGS_RESPONSE_DESCRIPTOR 0x8D
/** Its name in the specification. */
#define MIP_TOOLS_READINGS_RESPONSE_NAME "tools.readings_response"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_readings_response_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_readings_response_decode(
    struct mip_tools_readings_response *value, const struct mip_field *field) {
    return mip_decode_only(&mip_tools_readings_response_codec, 0x8D, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_readings_response_encode(
    const struct mip_tools_readings_response *value, struct mip_builder *builder) {
    return mip_encode(&mip_tools_readings_response_codec, value, builder);
}

/**
 * Poll: command (0x01,0x0E).
 *
 * Descriptors of a set that a parameter names, and of one that is always the same.
 *
 * Supported by Model C.
 *
 * - guide: Formats
 */
struct mip_tools_poll {
    /** Data descriptor set. Range: 0x80 to 0xFE. */
    uint8_t descriptor_set;
    /** Field descriptor. Refers to fields of MIP_MEASUREMENTS_SET. Default: 0x01. */
    uint8_t first;
    /** Number of fields. Counts the elements of descriptors. */
    uint8_t count;
    /** Field descriptors. Refers to fields of descriptor_set. */
    uint8_t descriptors[250];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_TOOLS_POLL 0x010E
/** Its descriptor. */
#define MIP_TOOLS_POLL_DESCRIPTOR 0x0E
/** Its name in the specification. */
#define MIP_TOOLS_POLL_NAME "tools.poll"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_tools_poll_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_tools_poll_decode(struct mip_tools_poll *value,
                                              const struct mip_field *field) {
    return mip_decode_only(&mip_tools_poll_codec, 0x0E, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_tools_poll_encode(const struct mip_tools_poll *value,
                                                          struct mip_builder *builder) {
    return mip_encode(&mip_tools_poll_codec, value, builder);
}

/**
 * Poll. Fills the structure and returns its address.
 *
 * - descriptor_set: Data descriptor set. Range: 0x80 to 0xFE.
 * - first: Field descriptor. Refers to fields of MIP_MEASUREMENTS_SET. Default: 0x01.
 * - count: Number of fields. Counts the elements of descriptors.
 * - descriptors: Field descriptors. Refers to fields of descriptor_set.
 */
static inline struct mip_tools_poll *mip_tools_poll_make(struct mip_tools_poll *command,
                                                         uint8_t descriptor_set, uint8_t first,
                                                         uint8_t count,
                                                         const uint8_t descriptors[]) {
    memset(command, 0, sizeof(*command));
    command->descriptor_set = descriptor_set;
    command->first = first;
    command->count = count;
    mip_copy(command->descriptors, sizeof(command->descriptors), descriptors,
             mip_counted(count, descriptors, sizeof(descriptors[0])));
    return command;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
