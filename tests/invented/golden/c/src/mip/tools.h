/**
 * @file
 *
 * Tools (0x01). Commands of every shape.
 */
#ifndef MIP_TOOLS_H
#define MIP_TOOLS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/tools.h and mip/constants.h are not of one version"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Descriptor set of these fields. */
#define MIP_TOOLS_SET 0x01

/** Which member the union has. */
typedef uint8_t mip_tools_shape;
#define MIP_TOOLS_SHAPE_NONE 0
#define MIP_TOOLS_SHAPE_CIRCLE 1
#define MIP_TOOLS_SHAPE_PATH 2
#define MIP_TOOLS_SHAPE_TURN 3
#define MIP_TOOLS_SHAPE_LABEL 4

/** How a circle is filled. */
typedef uint8_t mip_tools_fill;
#define MIP_TOOLS_FILL_EMPTY 0
#define MIP_TOOLS_FILL_SOLID 1
#define MIP_TOOLS_FILL_STRIPED 2

/** Two numbers. In full: stripes. */
struct mip_tools_bars {
    /** Of a stripe. Unit: m. */
    double width;
    /** Of all stripes. Unit: deg. Range: -180 to 180. */
    float angle;
};

void mip_tools_bars_read(struct mip_reader *r, struct mip_tools_bars *v);
void mip_tools_bars_write(struct mip_writer *w, const struct mip_tools_bars *v);

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
    /** Which member follows. */
    mip_tools_fill fill;
    /** How it is filled. Selected by fill. Empty if fill is MIP_TOOLS_FILL_EMPTY. */
    union mip_tools_circle_filling filling;
};

void mip_tools_circle_read(struct mip_reader *r, struct mip_tools_circle *v);
void mip_tools_circle_write(struct mip_writer *w, const struct mip_tools_circle *v);

/** A counted array at its end. */
struct mip_tools_path {
    /** Does it return to its start? */
    mip_bool closed;
    /** Number of points. The number of elements of points. */
    uint8_t num_points;
    /** The points. */
    struct mip_point points[62];
};

void mip_tools_path_read(struct mip_reader *r, struct mip_tools_path *v);
void mip_tools_path_write(struct mip_writer *w, const struct mip_tools_path *v);

/** What drives a pin. */
typedef uint8_t mip_tools_drive;
#define MIP_TOOLS_DRIVE_OFF 0
#define MIP_TOOLS_DRIVE_PULSE 1
#define MIP_TOOLS_DRIVE_SERIAL 2

/** Of a pulse. In full: pulse_use. */
typedef uint8_t mip_tools_pulse;
#define MIP_TOOLS_PULSE_INPUT 1
#define MIP_TOOLS_PULSE_OUTPUT 2

/** Of a serial line. */
typedef uint8_t mip_tools_serial_use;
#define MIP_TOOLS_SERIAL_USE_RECEIVE 1
#define MIP_TOOLS_SERIAL_USE_TRANSMIT 33

/** One of a list; what it is depends on what was asked for. */
struct mip_tools_reading {
    /** Of the reading. */
    uint8_t kind;
    /** Of the reading. */
    float value;
};

void mip_tools_reading_read(struct mip_reader *r, struct mip_tools_reading *v);
void mip_tools_reading_write(struct mip_writer *w, const struct mip_tools_reading *v);

/** Of the model A. In full: model_a_faults. */
typedef uint32_t mip_tools_a_faults;
/** Bit 0. */
#define MIP_TOOLS_A_FAULTS_CLOCK UINT32_C(0x00000001)
/** Bit 8. */
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
 * Supported by Model A, Model B, Model C and Old 1. May be supported by Old 2.
 *
 * - guide: Ping
 * - leaflet: Ping
 */
struct mip_tools_ping {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_TOOLS_PING_DESCRIPTOR 0x01
#define MIP_TOOLS_PING_NAME "tools.ping"

extern const struct mip_codec mip_tools_ping_codec;
mip_error mip_tools_ping_decode(struct mip_tools_ping *value, const struct mip_field *field);
mip_error mip_tools_ping_encode(const struct mip_tools_ping *value, struct mip_builder *builder);

/**
 * Settings: command (0x01,0x02).
 *
 * Every function, and a prefix of parameters for each.
 *
 * Functions: write, read, save, load, default and apply. Answered by mip_tools_settings_response.
 * Supported by Model A, Model B and Model C. On the Model B: write and read only. On the Model C:
 * write, read and save only.
 *
 * - guide: Settings
 * - leaflet: Settings
 */
struct mip_tools_settings {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Number of the port, 0 for all. Range: 0 to 8. */
    uint8_t port;
    /**
     * What to do. Default: MIP_MODE_FAST. Required for write, read and apply. On the Model C: only
     * MIP_MODE_DEFAULT and MIP_MODE_FAST; not deprecated.
     */
    mip_mode mode;
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

#define MIP_TOOLS_SETTINGS_DESCRIPTOR 0x02
#define MIP_TOOLS_SETTINGS_NAME "tools.settings"
/** The value of `present` if limit is the last parameter that is there. */
#define MIP_TOOLS_SETTINGS_WITH_LIMIT 4
/** The value of `present` if reserved is the last parameter that is there. */
#define MIP_TOOLS_SETTINGS_WITH_RESERVED 5

extern const struct mip_codec mip_tools_settings_codec;
mip_error mip_tools_settings_decode(struct mip_tools_settings *value,
                                    const struct mip_field *field);
mip_error mip_tools_settings_encode(const struct mip_tools_settings *value,
                                    struct mip_builder *builder);
/** Apply the new setting. */
struct mip_tools_settings mip_tools_settings_write(uint8_t port, mip_mode mode, uint32_t baud);
/** Send the current setting back in a response. */
struct mip_tools_settings mip_tools_settings_read(uint8_t port, mip_mode mode);
/** Save the current setting to non-volatile memory. */
struct mip_tools_settings mip_tools_settings_save(uint8_t port);
/** Load the saved setting. */
struct mip_tools_settings mip_tools_settings_load(uint8_t port);
/** Load the factory default setting. */
struct mip_tools_settings mip_tools_settings_default(uint8_t port);
/** Apply the new setting and send no acknowledge (5-series devices). */
struct mip_tools_settings mip_tools_settings_apply(uint8_t port, mip_mode mode, uint32_t baud);

/**
 * Settings response: response (0x01,0x82).
 *
 * Answers mip_tools_settings. Supported by Model A, Model B and Model C.
 *
 * - guide: Settings
 * - leaflet: Settings
 */
struct mip_tools_settings_response {
    /** Number of the port, 0 for all. Range: 0 to 8. */
    uint8_t port;
    /** What to do. Default: MIP_MODE_FAST. */
    mip_mode mode;
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

#define MIP_TOOLS_SETTINGS_RESPONSE_DESCRIPTOR 0x82
#define MIP_TOOLS_SETTINGS_RESPONSE_NAME "tools.settings_response"

extern const struct mip_codec mip_tools_settings_response_codec;
mip_error mip_tools_settings_response_decode(struct mip_tools_settings_response *value,
                                             const struct mip_field *field);
mip_error mip_tools_settings_response_encode(const struct mip_tools_settings_response *value,
                                             struct mip_builder *builder);

/**
 * Set time: command (0x01,0x03).
 *
 * Two responses for one command.
 *
 * Functions: write, read and apply. Answered by mip_tools_set_time_fast_response or
 * mip_tools_set_time_slow_response. Supported by Model A and Model C.
 *
 * Send it once a second.
 *
 * - guide: Set time
 */
struct mip_tools_set_time {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Which half of the time. */
    mip_mode part;
    /** The new value. Unit: s. Required for write and apply. */
    uint32_t value;
};

#define MIP_TOOLS_SET_TIME_DESCRIPTOR 0x03
#define MIP_TOOLS_SET_TIME_NAME "tools.set_time"

extern const struct mip_codec mip_tools_set_time_codec;
mip_error mip_tools_set_time_decode(struct mip_tools_set_time *value,
                                    const struct mip_field *field);
mip_error mip_tools_set_time_encode(const struct mip_tools_set_time *value,
                                    struct mip_builder *builder);
/** Apply the new setting. */
struct mip_tools_set_time mip_tools_set_time_write(mip_mode part, uint32_t value);
/** Send the current setting back in a response. */
struct mip_tools_set_time mip_tools_set_time_read(mip_mode part);
/** Apply the new setting and send no acknowledge (5-series devices). */
struct mip_tools_set_time mip_tools_set_time_apply(mip_mode part, uint32_t value);

/**
 * Set time response: response (0x01,0x83).
 *
 * Answers mip_tools_set_time. Sent if part is MIP_MODE_FAST. Supported by Model A and Model C.
 *
 * - guide: Set time
 */
struct mip_tools_set_time_fast_response {
    /** The fast half. Unit: s. */
    uint32_t value;
};

#define MIP_TOOLS_SET_TIME_FAST_RESPONSE_DESCRIPTOR 0x83
#define MIP_TOOLS_SET_TIME_FAST_RESPONSE_NAME "tools.set_time_fast_response"

extern const struct mip_codec mip_tools_set_time_fast_response_codec;
mip_error mip_tools_set_time_fast_response_decode(struct mip_tools_set_time_fast_response *value,
                                                  const struct mip_field *field);
mip_error mip_tools_set_time_fast_response_encode(
    const struct mip_tools_set_time_fast_response *value, struct mip_builder *builder);

/**
 * Set time response: response (0x01,0x84).
 *
 * Answers mip_tools_set_time. Sent if part is MIP_MODE_SLOW. Supported by Model A and Model C.
 *
 * - guide: Set time
 */
struct mip_tools_set_time_slow_response {
    /** The slow half. Unit: s. */
    uint32_t value;
};

#define MIP_TOOLS_SET_TIME_SLOW_RESPONSE_DESCRIPTOR 0x84
#define MIP_TOOLS_SET_TIME_SLOW_RESPONSE_NAME "tools.set_time_slow_response"

extern const struct mip_codec mip_tools_set_time_slow_response_codec;
mip_error mip_tools_set_time_slow_response_decode(struct mip_tools_set_time_slow_response *value,
                                                  const struct mip_field *field);
mip_error mip_tools_set_time_slow_response_encode(
    const struct mip_tools_set_time_slow_response *value, struct mip_builder *builder);

/**
 * Status: command (0x01,0x04).
 *
 * Layouts of one response, told apart by constants and by size.
 *
 * For advanced use. Answered by mip_tools_status_short, mip_tools_status_long, mip_tools_status_old
 * or mip_tools_full. The device may take 2.5 s to answer. Supported by Model A, Model B and Model
 * C.
 *
 * On the wire only, without a member:
 * - model: The model that the layouts belong to. Always 4711.
 *
 * - guide: Status
 */
struct mip_tools_status {
    /** Which layout. Range: 1 to 2. On the Model C: always 2. */
    uint8_t selector;
};

#define MIP_TOOLS_STATUS_DESCRIPTOR 0x04
#define MIP_TOOLS_STATUS_NAME "tools.status"

extern const struct mip_codec mip_tools_status_codec;
mip_error mip_tools_status_decode(struct mip_tools_status *value, const struct mip_field *field);
mip_error mip_tools_status_encode(const struct mip_tools_status *value,
                                  struct mip_builder *builder);
/** Status. */
struct mip_tools_status mip_tools_status_make(uint8_t selector);

/**
 * Status response: response (0x01,0x90).
 *
 * Answers mip_tools_status. Sent if selector is 1. Supported by Model A, Model B and Model C.
 *
 * On the wire only, without a member:
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

#define MIP_TOOLS_STATUS_SHORT_DESCRIPTOR 0x90
#define MIP_TOOLS_STATUS_SHORT_NAME "tools.status_short"

extern const struct mip_codec mip_tools_status_short_codec;
mip_error mip_tools_status_short_decode(struct mip_tools_status_short *value,
                                        const struct mip_field *field);
mip_error mip_tools_status_short_encode(const struct mip_tools_status_short *value,
                                        struct mip_builder *builder);

/**
 * Status response: response (0x01,0x90).
 *
 * Answers mip_tools_status. Told from mip_tools_status_old and mip_tools_full by the size of its
 * data. Sent if selector is 2. Supported by Model A, Model B and Model C.
 *
 * On the wire only, without a member:
 * - model: The model. Always 4711.
 * - selector: The long layout. Always 2.
 *
 * - guide: Status
 */
struct mip_tools_status_long {
    /**
     * Faults. On the Model A: values of mip_tools_a_faults. On the Model B: values of
     * mip_tools_model_b_faults. On the Model C: values that are not known.
     */
    uint32_t flags;
    /** Since start. Unit: s. */
    uint64_t uptime;
};

#define MIP_TOOLS_STATUS_LONG_DESCRIPTOR 0x90
#define MIP_TOOLS_STATUS_LONG_NAME "tools.status_long"

extern const struct mip_codec mip_tools_status_long_codec;
mip_error mip_tools_status_long_decode(struct mip_tools_status_long *value,
                                       const struct mip_field *field);
mip_error mip_tools_status_long_encode(const struct mip_tools_status_long *value,
                                       struct mip_builder *builder);

/**
 * Status response: response (0x01,0x90).
 *
 * The long layout of old devices. Its size tells it from the others.
 *
 * Answers mip_tools_status. Told from mip_tools_status_long and mip_tools_full by the size of its
 * data. Sent if selector is 2. Supported by Model A, Model B and Model C.
 *
 * On the wire only, without a member:
 * - model: The model. Always 4711.
 * - selector: The long layout. Always 2.
 *
 * - guide: Status
 */
struct mip_tools_status_old {
    /** Since start. Unit: s. */
    uint32_t uptime;
};

#define MIP_TOOLS_STATUS_OLD_DESCRIPTOR 0x90
#define MIP_TOOLS_STATUS_OLD_NAME "tools.status_old"

extern const struct mip_codec mip_tools_status_old_codec;
mip_error mip_tools_status_old_decode(struct mip_tools_status_old *value,
                                      const struct mip_field *field);
mip_error mip_tools_status_old_encode(const struct mip_tools_status_old *value,
                                      struct mip_builder *builder);

/**
 * Status response: response (0x01,0x90).
 *
 * In full: tools.status_full.
 *
 * Answers mip_tools_status. Told from mip_tools_status_long and mip_tools_status_old by the size of
 * its data. Sent if selector is 2. Supported by Model A, Model B and Model C.
 *
 * On the wire only, without a member:
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
    /** What it does. */
    mip_mode mode;
};

#define MIP_TOOLS_FULL_DESCRIPTOR 0x90
#define MIP_TOOLS_FULL_NAME "tools.status_full"

extern const struct mip_codec mip_tools_full_codec;
mip_error mip_tools_full_decode(struct mip_tools_full *value, const struct mip_field *field);
mip_error mip_tools_full_encode(const struct mip_tools_full *value, struct mip_builder *builder);

/**
 * Bias: command (0x01,0x05).
 *
 * Its response serves another command too.
 *
 * Functions: write, read, save, load and default. Answered by mip_tools_bias_vector. Supported by
 * Model A and Model C.
 *
 * - guide: Bias
 * - leaflet: Bias
 */
struct mip_tools_bias {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. Required for write. */
    float bias[3];
};

#define MIP_TOOLS_BIAS_DESCRIPTOR 0x05
#define MIP_TOOLS_BIAS_NAME "tools.bias"

extern const struct mip_codec mip_tools_bias_codec;
mip_error mip_tools_bias_decode(struct mip_tools_bias *value, const struct mip_field *field);
mip_error mip_tools_bias_encode(const struct mip_tools_bias *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_tools_bias mip_tools_bias_write(const float bias[3]);
/** Send the current setting back in a response. */
struct mip_tools_bias mip_tools_bias_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_tools_bias mip_tools_bias_save(void);
/** Load the saved setting. */
struct mip_tools_bias mip_tools_bias_load(void);
/** Load the factory default setting. */
struct mip_tools_bias mip_tools_bias_default(void);

/**
 * Bias response: response (0x01,0x9B).
 *
 * Answers mip_tools_bias and mip_tools_capture_bias. Supported by Model A and Model C.
 *
 * - guide: Bias
 * - leaflet: Bias
 */
struct mip_tools_bias_vector {
    /** Taken off the measurement. Elements: x, y, z. Unit: g. Frame: sensor. */
    float bias[3];
};

#define MIP_TOOLS_BIAS_VECTOR_DESCRIPTOR 0x9B
#define MIP_TOOLS_BIAS_VECTOR_NAME "tools.bias_vector"

extern const struct mip_codec mip_tools_bias_vector_codec;
mip_error mip_tools_bias_vector_decode(struct mip_tools_bias_vector *value,
                                       const struct mip_field *field);
mip_error mip_tools_bias_vector_encode(const struct mip_tools_bias_vector *value,
                                       struct mip_builder *builder);

/**
 * Capture bias: command (0x01,0x06).
 *
 * Measures the bias.
 *
 * Answered by mip_tools_bias_vector. Supported by Model A and Model C. Deprecated on the Model C:
 * use mip_tools_bias instead.
 *
 * - guide: Capture bias
 */
struct mip_tools_capture_bias {
    /** How long. Unit: s. Range: 1 to 30. */
    uint16_t time;
};

#define MIP_TOOLS_CAPTURE_BIAS_DESCRIPTOR 0x06
#define MIP_TOOLS_CAPTURE_BIAS_NAME "tools.capture_bias"

extern const struct mip_codec mip_tools_capture_bias_codec;
mip_error mip_tools_capture_bias_decode(struct mip_tools_capture_bias *value,
                                        const struct mip_field *field);
mip_error mip_tools_capture_bias_encode(const struct mip_tools_capture_bias *value,
                                        struct mip_builder *builder);
/** Capture bias. */
struct mip_tools_capture_bias mip_tools_capture_bias_make(uint16_t time);

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
    /** Number of segments. The number of elements of segments. */
    uint8_t num_segments;
    /** Between a counter and its array. */
    uint8_t checkpoint;
    /** The segments. */
    struct mip_segment segments[25];
};

#define MIP_TOOLS_FORMATS_DESCRIPTOR 0x07
#define MIP_TOOLS_FORMATS_NAME "tools.formats"

extern const struct mip_codec mip_tools_formats_codec;
mip_error mip_tools_formats_decode(struct mip_tools_formats *value, const struct mip_field *field);
mip_error mip_tools_formats_encode(const struct mip_tools_formats *value,
                                   struct mip_builder *builder);
/** Formats. */
struct mip_tools_formats mip_tools_formats_make(mip_bool suppress_ack, uint8_t num_segments,
                                                uint8_t checkpoint,
                                                const struct mip_segment segments[]);

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
 * Functions: write and read. Answered by mip_tools_choice_response. Supported by Model A.
 *
 * - guide: Choice
 */
struct mip_tools_choice {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Which one. */
    uint8_t instance;
    /** Which member follows. Required for write. */
    mip_tools_shape shape;
    /**
     * The member. Selected by shape. Required for write. Empty if shape is MIP_TOOLS_SHAPE_NONE.
     */
    union mip_tools_choice_parameters parameters;
};

#define MIP_TOOLS_CHOICE_DESCRIPTOR 0x08
#define MIP_TOOLS_CHOICE_NAME "tools.choice"

extern const struct mip_codec mip_tools_choice_codec;
mip_error mip_tools_choice_decode(struct mip_tools_choice *value, const struct mip_field *field);
mip_error mip_tools_choice_encode(const struct mip_tools_choice *value,
                                  struct mip_builder *builder);
/** Apply the new setting. */
struct mip_tools_choice mip_tools_choice_write(uint8_t instance, mip_tools_shape shape,
                                               const union mip_tools_choice_parameters *parameters);
/** Send the current setting back in a response. */
struct mip_tools_choice mip_tools_choice_read(uint8_t instance);

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
 * Answers mip_tools_choice. Supported by Model A.
 *
 * - guide: Choice
 */
struct mip_tools_choice_response {
    /** Which one. */
    uint8_t instance;
    /** Which member follows. */
    mip_tools_shape shape;
    /** The member. Selected by shape. Empty if shape is MIP_TOOLS_SHAPE_NONE. */
    union mip_tools_choice_response_parameters parameters;
};

#define MIP_TOOLS_CHOICE_RESPONSE_DESCRIPTOR 0x88
#define MIP_TOOLS_CHOICE_RESPONSE_NAME "tools.choice_response"

extern const struct mip_codec mip_tools_choice_response_codec;
mip_error mip_tools_choice_response_decode(struct mip_tools_choice_response *value,
                                           const struct mip_field *field);
mip_error mip_tools_choice_response_encode(const struct mip_tools_choice_response *value,
                                           struct mip_builder *builder);

/**
 * List: command (0x01,0x09).
 *
 * Optional counted array; a read may carry a zero count.
 *
 * Functions: write, read and save. Answered by mip_tools_list_response. Supported by Model A and
 * Model C.
 *
 * - guide: List
 */
struct mip_tools_list {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** Number of items. The number of elements of items. Required for write. */
    uint8_t count;
    /** The items. Required for write. */
    uint16_t items[125];
};

#define MIP_TOOLS_LIST_DESCRIPTOR 0x09
#define MIP_TOOLS_LIST_NAME "tools.list"

extern const struct mip_codec mip_tools_list_codec;
mip_error mip_tools_list_decode(struct mip_tools_list *value, const struct mip_field *field);
mip_error mip_tools_list_encode(const struct mip_tools_list *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_tools_list mip_tools_list_write(uint8_t count, const uint16_t items[]);
/** Send the current setting back in a response. */
struct mip_tools_list mip_tools_list_read(void);
/** Save the current setting to non-volatile memory. */
struct mip_tools_list mip_tools_list_save(void);

/**
 * List response: response (0x01,0x89).
 *
 * Answers mip_tools_list. Supported by Model A and Model C.
 *
 * - guide: List
 */
struct mip_tools_list_response {
    /** Number of items. The number of elements of items. */
    uint8_t count;
    /** The items. */
    uint16_t items[126];
};

#define MIP_TOOLS_LIST_RESPONSE_DESCRIPTOR 0x89
#define MIP_TOOLS_LIST_RESPONSE_NAME "tools.list_response"

extern const struct mip_codec mip_tools_list_response_codec;
mip_error mip_tools_list_response_decode(struct mip_tools_list_response *value,
                                         const struct mip_field *field);
mip_error mip_tools_list_response_encode(const struct mip_tools_list_response *value,
                                         struct mip_builder *builder);

/**
 * Inventory: command (0x01,0x0A).
 *
 * Answers with an array to the end of the field.
 *
 * In full: tools.inventory.
 *
 * Answered by mip_tools_stock_response. Supported by Model A and Model C.
 *
 * - guide: Inventory
 */
struct mip_tools_stock {
    /** Not used: there are no parameters. */
    uint8_t empty;
};

#define MIP_TOOLS_STOCK_DESCRIPTOR 0x0A
#define MIP_TOOLS_STOCK_NAME "tools.inventory"

extern const struct mip_codec mip_tools_stock_codec;
mip_error mip_tools_stock_decode(struct mip_tools_stock *value, const struct mip_field *field);
mip_error mip_tools_stock_encode(const struct mip_tools_stock *value, struct mip_builder *builder);

/**
 * Inventory response: response (0x01,0x8A).
 *
 * In full: tools.inventory_response.
 *
 * Answers mip_tools_stock. Supported by Model A and Model C.
 *
 * - guide: Inventory
 */
struct mip_tools_stock_response {
    /** The number of elements of descriptors. */
    uint8_t descriptors_count;
    /** As many as there are. */
    uint16_t descriptors[126];
};

#define MIP_TOOLS_STOCK_RESPONSE_DESCRIPTOR 0x8A
#define MIP_TOOLS_STOCK_RESPONSE_NAME "tools.inventory_response"

extern const struct mip_codec mip_tools_stock_response_codec;
mip_error mip_tools_stock_response_decode(struct mip_tools_stock_response *value,
                                          const struct mip_field *field);
mip_error mip_tools_stock_response_encode(const struct mip_tools_stock_response *value,
                                          struct mip_builder *builder);

/**
 * Pin: command (0x01,0x0B).
 *
 * The names of one number depend on another.
 *
 * Functions: write and read. Answered by mip_tools_pin_response. Supported by Model A and Model C.
 *
 * - guide: Pin
 */
struct mip_tools_pin {
    /** Parameters that are present, the selector not counted; 0: only the required ones. */
    uint8_t present;
    /** What to do with the setting. */
    mip_function_selector function;
    /** What drives it. */
    mip_tools_drive drive;
    /**
     * How it is used. Required for write. If drive is MIP_TOOLS_DRIVE_PULSE: values of
     * mip_tools_pulse. If drive is MIP_TOOLS_DRIVE_SERIAL: values of mip_tools_serial_use.
     */
    uint8_t use;
};

#define MIP_TOOLS_PIN_DESCRIPTOR 0x0B
#define MIP_TOOLS_PIN_NAME "tools.pin"

extern const struct mip_codec mip_tools_pin_codec;
mip_error mip_tools_pin_decode(struct mip_tools_pin *value, const struct mip_field *field);
mip_error mip_tools_pin_encode(const struct mip_tools_pin *value, struct mip_builder *builder);
/** Apply the new setting. */
struct mip_tools_pin mip_tools_pin_write(mip_tools_drive drive, uint8_t use);
/** Send the current setting back in a response. */
struct mip_tools_pin mip_tools_pin_read(mip_tools_drive drive);

/**
 * Pin response: response (0x01,0x8B).
 *
 * Answers mip_tools_pin. Supported by Model A and Model C.
 *
 * - guide: Pin
 */
struct mip_tools_pin_response {
    /** What drives it. */
    mip_tools_drive drive;
    /**
     * How it is used. If drive is MIP_TOOLS_DRIVE_PULSE: values of mip_tools_pulse. If drive is
     * MIP_TOOLS_DRIVE_SERIAL: values of mip_tools_serial_use.
     */
    uint8_t use;
};

#define MIP_TOOLS_PIN_RESPONSE_DESCRIPTOR 0x8B
#define MIP_TOOLS_PIN_RESPONSE_NAME "tools.pin_response"

extern const struct mip_codec mip_tools_pin_response_codec;
mip_error mip_tools_pin_response_decode(struct mip_tools_pin_response *value,
                                        const struct mip_field *field);
mip_error mip_tools_pin_response_encode(const struct mip_tools_pin_response *value,
                                        struct mip_builder *builder);

/**
 * Hello: command (0x01,0x0C).
 *
 * The device asks and a host answers.
 *
 * Also called `keep_alive`. Answered by mip_tools_hello_response. The device sends it, and the host
 * answers. May be supported by Model C. Known from the Kit of names only.
 *
 * - sheet: Hello
 */
struct mip_tools_hello {
    /** Parameters that are present; 0: only the required ones. */
    uint8_t present;
    /** Reserved: send 1.0. */
    float reserved;
    /** Reserved: send 0.0. Optional. */
    double later[2];
};

#define MIP_TOOLS_HELLO_DESCRIPTOR 0x0C
#define MIP_TOOLS_HELLO_NAME "tools.hello"
/** The value of `present` if later is the last parameter that is there. */
#define MIP_TOOLS_HELLO_WITH_LATER 2

extern const struct mip_codec mip_tools_hello_codec;
mip_error mip_tools_hello_decode(struct mip_tools_hello *value, const struct mip_field *field);
mip_error mip_tools_hello_encode(const struct mip_tools_hello *value, struct mip_builder *builder);

/**
 * Hello response: response (0x01,0x8C).
 *
 * Also called `keep_alive_response` and `welcome`. Answers mip_tools_hello. May be supported by
 * Model C. Known from the Kit of names only. Uncertain: When it comes.
 *
 * - sheet: Hello
 */
struct mip_tools_hello_response {
    /** When the device was seen. Unit: s. */
    uint32_t seen;
};

#define MIP_TOOLS_HELLO_RESPONSE_DESCRIPTOR 0x8C
#define MIP_TOOLS_HELLO_RESPONSE_NAME "tools.hello_response"

extern const struct mip_codec mip_tools_hello_response_codec;
mip_error mip_tools_hello_response_decode(struct mip_tools_hello_response *value,
                                          const struct mip_field *field);
mip_error mip_tools_hello_response_encode(const struct mip_tools_hello_response *value,
                                          struct mip_builder *builder);

/**
 * Readings: command (0x01,0x0D).
 *
 * A parameter outside of a structure says how its members are read.
 *
 * Answered by mip_tools_readings_response. Supported by Model A and Model C.
 *
 * - guide: Readings
 */
struct mip_tools_readings {
    /** What is asked for. */
    mip_tools_drive drive;
};

#define MIP_TOOLS_READINGS_DESCRIPTOR 0x0D
#define MIP_TOOLS_READINGS_NAME "tools.readings"

extern const struct mip_codec mip_tools_readings_codec;
mip_error mip_tools_readings_decode(struct mip_tools_readings *value,
                                    const struct mip_field *field);
mip_error mip_tools_readings_encode(const struct mip_tools_readings *value,
                                    struct mip_builder *builder);
/** Readings. */
struct mip_tools_readings mip_tools_readings_make(mip_tools_drive drive);

/**
 * Readings response: response (0x01,0x8D).
 *
 * Answers mip_tools_readings. Supported by Model A and Model C.
 *
 * - guide: Readings
 */
struct mip_tools_readings_response {
    /** What was asked for. */
    mip_tools_drive drive;
    /** Number of readings. The number of elements of readings. */
    uint8_t count;
    /**
     * The readings. If drive is MIP_TOOLS_DRIVE_PULSE: kind has values of mip_tools_pulse. Seldom
     * 2. If drive is MIP_TOOLS_DRIVE_SERIAL: kind has values of mip_tools_serial_use.
     */
    struct mip_tools_reading readings[49];
    /**
     * The last one. If drive is MIP_TOOLS_DRIVE_PULSE: value has unit s; range 0 to 1. If drive is
     * MIP_TOOLS_DRIVE_SERIAL: value: Nothing.
     */
    struct mip_tools_reading last;
};

#define MIP_TOOLS_READINGS_RESPONSE_DESCRIPTOR 0x8D
#define MIP_TOOLS_READINGS_RESPONSE_NAME "tools.readings_response"

extern const struct mip_codec mip_tools_readings_response_codec;
mip_error mip_tools_readings_response_decode(struct mip_tools_readings_response *value,
                                             const struct mip_field *field);
mip_error mip_tools_readings_response_encode(const struct mip_tools_readings_response *value,
                                             struct mip_builder *builder);

#ifdef __cplusplus
}
#endif

#endif
