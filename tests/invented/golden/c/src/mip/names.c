/* The names of values and bits. */
#include "mip/names.h"
#include "mip/protocol.h"
#include "mip/tools.h"
#include "mip/3d.h"
#include "mip/measurements.h"
#include "mip/shared.h"

static const char name_function_selector[] = "function_selector";
static const char labels_function_selector[] = "write\0"
                                               "read\0"
                                               "save\0"
                                               "load\0"
                                               "default\0"
                                               "apply";
static const uint8_t numbers_function_selector[] = {1, 2, 3, 4, 5, 6};
const struct mip_names mip_names_function_selector = {
    name_function_selector, labels_function_selector, numbers_function_selector, NULL, 6, 1};
const char *mip_function_selector_name(uint8_t value) {
    return mip_value_name(&mip_names_function_selector, value);
}

static const char name_ack_code[] = "ack_code";
static const char labels_ack_code[] = "ok\0"
                                      "unknown_command\0"
                                      "invalid_parameter";
static const uint8_t numbers_ack_code[] = {0, 1, 3};
const struct mip_names mip_names_ack_code = {
    name_ack_code, labels_ack_code, numbers_ack_code, NULL, 3, 1};
const char *mip_ack_code_name(uint8_t value) {
    return mip_value_name(&mip_names_ack_code, value);
}

static const char name_mode[] = "mode";
static const char labels_mode[] = "default\0"
                                  "fast\0"
                                  "slow";
static const uint8_t numbers_mode[] = {0, 1, 2};
const struct mip_names mip_names_mode = {name_mode, labels_mode, numbers_mode, NULL, 3, 1};
const char *mip_mode_name(uint8_t value) {
    return mip_value_name(&mip_names_mode, value);
}

static const char name_wide_code[] = "wide_code";
static const char labels_wide_code[] = "low\0"
                                       "high";
static const uint32_t numbers_wide_code[] = {1, UINT32_C(0xFFFF0000)};
const struct mip_names mip_names_wide_code = {
    name_wide_code, labels_wide_code, numbers_wide_code, NULL, 2, 4};
const char *mip_wide_code_name(uint32_t value) {
    return mip_value_name(&mip_names_wide_code, value);
}

static const char name_state_flags[] = "state_flags";
static const char labels_state_flags[] = "ready\0"
                                         "hot\0"
                                         "level\0"
                                         "mode\0"
                                         "any";
static const struct mip_named_bits bits_state_flags[] = {
    {0, 1, NULL}, {1, 1, NULL}, {4, 3, NULL}, {8, 2, &mip_names_mode}, {0, 2, NULL},
};
const struct mip_names mip_names_state_flags = {
    name_state_flags, labels_state_flags, NULL, bits_state_flags, 5, 2};

static const char name_health[] = "health";
static const char labels_health[] = "clock\0"
                                    "hot\0"
                                    "level\0"
                                    "power\0"
                                    "count\0"
                                    "last";
static const struct mip_named_bits bits_health[] = {
    {0, 1, NULL}, {1, 1, NULL}, {4, 3, NULL}, {9, 1, NULL}, {30, 4, NULL}, {127, 1, NULL},
};
const struct mip_names mip_names_health = {name_health, labels_health, NULL, bits_health, 6, 16};

static const char name_tools_shape[] = "tools.shape";
static const char labels_tools_shape[] = "none\0"
                                         "circle\0"
                                         "path\0"
                                         "turn\0"
                                         "label";
static const uint8_t numbers_tools_shape[] = {0, 1, 2, 3, 4};
const struct mip_names mip_names_tools_shape = {
    name_tools_shape, labels_tools_shape, numbers_tools_shape, NULL, 5, 1};
const char *mip_tools_shape_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_shape, value);
}

static const char name_tools_fill[] = "tools.fill";
static const char labels_tools_fill[] = "empty\0"
                                        "solid\0"
                                        "striped";
static const uint8_t numbers_tools_fill[] = {0, 1, 2};
const struct mip_names mip_names_tools_fill = {
    name_tools_fill, labels_tools_fill, numbers_tools_fill, NULL, 3, 1};
const char *mip_tools_fill_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_fill, value);
}

static const char name_tools_drive[] = "tools.drive";
static const char labels_tools_drive[] = "off\0"
                                         "pulse\0"
                                         "serial";
static const uint8_t numbers_tools_drive[] = {0, 1, 2};
const struct mip_names mip_names_tools_drive = {
    name_tools_drive, labels_tools_drive, numbers_tools_drive, NULL, 3, 1};
const char *mip_tools_drive_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_drive, value);
}

static const char name_tools_pulse[] = "tools.pulse_use";
static const char labels_tools_pulse[] = "input\0"
                                         "output";
static const uint8_t numbers_tools_pulse[] = {1, 2};
const struct mip_names mip_names_tools_pulse = {
    name_tools_pulse, labels_tools_pulse, numbers_tools_pulse, NULL, 2, 1};
const char *mip_tools_pulse_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_pulse, value);
}

static const char name_tools_serial_use[] = "tools.serial_use";
static const char labels_tools_serial_use[] = "receive\0"
                                              "transmit";
static const uint8_t numbers_tools_serial_use[] = {1, 33};
const struct mip_names mip_names_tools_serial_use = {
    name_tools_serial_use, labels_tools_serial_use, numbers_tools_serial_use, NULL, 2, 1};
const char *mip_tools_serial_use_name(uint8_t value) {
    return mip_value_name(&mip_names_tools_serial_use, value);
}

static const char name_tools_a_faults[] = "tools.model_a_faults";
static const char labels_tools_a_faults[] = "clock\0"
                                            "sensor\0"
                                            "solution";
static const struct mip_named_bits bits_tools_a_faults[] = {
    {0, 1, NULL},
    {8, 1, NULL},
    {24, 1, NULL},
};
const struct mip_names mip_names_tools_a_faults = {
    name_tools_a_faults, labels_tools_a_faults, NULL, bits_tools_a_faults, 3, 4};

static const char name_tools_model_b_faults[] = "tools.model_b_faults";
static const char labels_tools_model_b_faults[] = "general\0"
                                                  "overload\0"
                                                  "accel";
static const struct mip_named_bits bits_tools_model_b_faults[] = {
    {0, 1, NULL},
    {1, 1, NULL},
    {12, 1, NULL},
};
const struct mip_names mip_names_tools_model_b_faults = {
    name_tools_model_b_faults, labels_tools_model_b_faults, NULL, bits_tools_model_b_faults, 3, 4};

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
