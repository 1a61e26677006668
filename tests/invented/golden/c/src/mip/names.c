/* The names of values and bits. */
#include "mip/names.h"
#include "mip/protocol.h"
#include "mip/tools.h"
#include "mip/3d.h"
#include "mip/measurements.h"
#include "mip/more.h"
#include "mip/copy.h"
#include "mip/shared.h"

static const char *const labels_function_selector[] = {"write", "read",    "save",
                                                       "load",  "default", "apply"};
static const uint8_t numbers_function_selector[] = {1, 2, 3, 4, 5, 6};
const struct mip_names mip_names_function_selector = {
    "function_selector", labels_function_selector, numbers_function_selector, NULL, 6, 1,
};
const char *mip_function_selector_name(uint8_t value) {
    return mip_value_name(&mip_names_function_selector, value);
}

static const char *const labels_ack_code[] = {"ok", "unknown_command", "invalid_parameter"};
static const uint8_t numbers_ack_code[] = {0, 1, 3};
const struct mip_names mip_names_ack_code = {
    "ack_code", labels_ack_code, numbers_ack_code, NULL, 3, 1,
};
const char *mip_ack_code_name(uint8_t value) {
    return mip_value_name(&mip_names_ack_code, value);
}

static const char *const labels_mode[] = {"default", "fast", "slow"};
static const uint8_t numbers_mode[] = {0, 1, 2};
const struct mip_names mip_names_mode = {
    "mode", labels_mode, numbers_mode, NULL, 3, 1,
};
const char *mip_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_mode, value);
}

static const char *const labels_wide_code[] = {"low", "high"};
static const uint32_t numbers_wide_code[] = {1, UINT32_C(0xFFFF0000)};
const struct mip_names mip_names_wide_code = {
    "wide_code", labels_wide_code, numbers_wide_code, NULL, 2, 4,
};
const char *mip_wide_code_name(uint32_t value) {
    return mip_value_name(&mip_names_wide_code, value);
}

static const struct mip_named_bits bits_state_flags[] = {
    {"ready", 0, 1, NULL},           {"hot", 1, 1, NULL}, {"level", 4, 3, NULL},
    {"mode", 8, 2, &mip_names_mode}, {"any", 0, 2, NULL},
};
const struct mip_names mip_names_state_flags = {
    "state_flags", NULL, NULL, bits_state_flags, 5, 2,
};

static const struct mip_named_bits bits_health[] = {
    {"clock", 0, 1, NULL},
    {"power", 9, 1, NULL},
    {"count", 30, 4, NULL},
    {"last", 127, 1, NULL},
};
const struct mip_names mip_names_health = {
    "health", NULL, NULL, bits_health, 4, 16,
};

static const char *const labels_tools_shape[] = {"none", "circle", "path", "turn", "label"};
static const uint8_t numbers_tools_shape[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_tools_shape = {
    "tools.shape", labels_tools_shape, numbers_tools_shape, NULL, 5, 1,
};
const char *mip_tools_shape_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_shape, value);
}

static const char *const labels_tools_fill[] = {"empty", "solid", "striped"};
static const uint8_t numbers_tools_fill[] = {0, 1, 2};
const struct mip_names mip_names_tools_fill = {
    "tools.fill", labels_tools_fill, numbers_tools_fill, NULL, 3, 1,
};
const char *mip_tools_fill_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_fill, value);
}

static const char *const labels_tools_drive[] = {"off", "pulse", "serial"};
static const uint8_t numbers_tools_drive[] = {0, 1, 2};
const struct mip_names mip_names_tools_drive = {
    "tools.drive", labels_tools_drive, numbers_tools_drive, NULL, 3, 1,
};
const char *mip_tools_drive_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_drive, value);
}

static const char *const labels_tools_pulse[] = {"input", "output"};
static const uint8_t numbers_tools_pulse[] = {1, 2};
const struct mip_names mip_names_tools_pulse = {
    "tools.pulse_use", labels_tools_pulse, numbers_tools_pulse, NULL, 2, 1,
};
const char *mip_tools_pulse_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_pulse, value);
}

static const char *const labels_tools_serial_use[] = {"receive", "transmit"};
static const uint8_t numbers_tools_serial_use[] = {1, 33};
const struct mip_names mip_names_tools_serial_use = {
    "tools.serial_use", labels_tools_serial_use, numbers_tools_serial_use, NULL, 2, 1,
};
const char *mip_tools_serial_use_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_serial_use, value);
}

static const struct mip_named_bits bits_tools_a_faults[] = {
    {"clock", 0, 1, NULL},
    {"sensor", 8, 1, NULL},
    {"solution", 24, 1, NULL},
};
const struct mip_names mip_names_tools_a_faults = {
    "tools.model_a_faults", NULL, NULL, bits_tools_a_faults, 3, 4,
};

static const struct mip_named_bits bits_tools_model_b_faults[] = {
    {"general", 0, 1, NULL},
    {"overload", 1, 1, NULL},
    {"accel", 12, 1, NULL},
};
const struct mip_names mip_names_tools_model_b_faults = {
    "tools.model_b_faults", NULL, NULL, bits_tools_model_b_faults, 3, 4,
};

const struct mip_names *const mip_all_names[] = {
    &mip_names_function_selector,
    &mip_names_ack_code,
    &mip_names_mode,
    &mip_names_wide_code,
    &mip_names_state_flags,
    &mip_names_health,
    &mip_names_tools_shape,
    &mip_names_tools_fill,
    &mip_names_tools_drive,
    &mip_names_tools_pulse,
    &mip_names_tools_serial_use,
    &mip_names_tools_a_faults,
    &mip_names_tools_model_b_faults,
};
const size_t mip_all_names_count = sizeof(mip_all_names) / sizeof(mip_all_names[0]);
