/* Tools. */
#include "mip/tools.h"
#include "mip/tools_commands.h"
#include "mip/program.h"

static const uint8_t program_ping[] = {
    MIP_END,
};

const struct mip_codec mip_tools_ping_codec = {
    0x01, 0x01, MIP_COMMAND, 0, sizeof(struct mip_tools_ping), 0, false, program_ping, NULL};

const struct mip_command mip_tools_ping_command = {&mip_tools_ping_codec, NULL, NULL, 0};

static const uint8_t program_settings[] = {
    MIP_REQUIRED(6, 3, 2, 1, 1, 1, 3),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_settings, port)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_settings, mode)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_settings, baud)),
    MIP_GROUP(1),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_settings, limit)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_settings, reserved)),
    MIP_END,
};

const struct mip_codec mip_tools_settings_codec = {
    0x01, 0x02,  MIP_COMMAND,      0,           sizeof(struct mip_tools_settings),
    0,    false, program_settings, &mip_program};

static bool silent_settings(const void *value) {
    const struct mip_tools_settings *v = (const struct mip_tools_settings *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_settings_1(const void *value) {
    const struct mip_tools_settings *v = (const struct mip_tools_settings *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_settings[] = {
    {&mip_tools_settings_response_codec, asked_settings_1},
    {NULL, NULL},
};

const struct mip_command mip_tools_settings_command = {&mip_tools_settings_codec, silent_settings,
                                                       responses_settings, 0};

static const uint8_t program_settings_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_tools_settings_response, port)),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_settings_response, baud)),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_settings_response, limit)),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_settings_response, reserved)),
    MIP_END,
};

const struct mip_codec mip_tools_settings_response_codec = {
    0x01,
    0x82,
    MIP_RESPONSE,
    9,
    sizeof(struct mip_tools_settings_response),
    0,
    false,
    program_settings_response,
    NULL};

static const uint8_t program_set_time[] = {
    MIP_REQUIRED(6, 2, 1, 0, 0, 0, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_set_time, part)),
    MIP_GROUP(1),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_set_time, value)),
    MIP_END,
};

const struct mip_codec mip_tools_set_time_codec = {
    0x01, 0x03,  MIP_COMMAND,      0,           sizeof(struct mip_tools_set_time),
    0,    false, program_set_time, &mip_program};

static bool silent_set_time(const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;
    return v->function == MIP_FUNCTION_SELECTOR_APPLY;
}

static bool asked_set_time_1(const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ && v->part == 1;
}

static bool asked_set_time_2(const void *value) {
    const struct mip_tools_set_time *v = (const struct mip_tools_set_time *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ && v->part == 2;
}

static const struct mip_response responses_set_time[] = {
    {&mip_tools_set_time_fast_response_codec, asked_set_time_1},
    {&mip_tools_set_time_slow_response_codec, asked_set_time_2},
    {NULL, NULL},
};

const struct mip_command mip_tools_set_time_command = {&mip_tools_set_time_codec, silent_set_time,
                                                       responses_set_time, 0};

static const uint8_t program_set_time_fast_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_tools_set_time_fast_response, value)),
    MIP_END,
};

const struct mip_codec mip_tools_set_time_fast_response_codec = {
    0x01,
    0x83,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_tools_set_time_fast_response),
    0,
    sizeof(struct mip_tools_set_time_fast_response) >= 8,
    program_set_time_fast_response,
    NULL};

static const uint8_t program_set_time_slow_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_tools_set_time_slow_response, value)),
    MIP_END,
};

const struct mip_codec mip_tools_set_time_slow_response_codec = {
    0x01,
    0x84,
    MIP_RESPONSE,
    4,
    sizeof(struct mip_tools_set_time_slow_response),
    0,
    sizeof(struct mip_tools_set_time_slow_response) >= 8,
    program_set_time_slow_response,
    NULL};

static const uint8_t program_status[] = {
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_status, selector)),
    MIP_END,
};

const struct mip_codec mip_tools_status_codec = {
    0x01, 0x04,  MIP_COMMAND,    0,           sizeof(struct mip_tools_status),
    0,    false, program_status, &mip_program};

static bool asked_status_1(const void *value) {
    const struct mip_tools_status *v = (const struct mip_tools_status *)value;
    return v->selector == 1;
}

static bool asked_status_2(const void *value) {
    const struct mip_tools_status *v = (const struct mip_tools_status *)value;
    return v->selector == 2;
}

static const struct mip_response responses_status[] = {
    {&mip_tools_status_short_codec, asked_status_1},
    {&mip_tools_status_long_codec, asked_status_2},
    {&mip_tools_status_old_codec, asked_status_2},
    {&mip_tools_full_codec, asked_status_2},
    {NULL, NULL},
};

const struct mip_command mip_tools_status_command = {&mip_tools_status_codec, NULL,
                                                     responses_status, 2500};

static const uint8_t program_status_short[] = {
    MIP_LAYOUT(0, 253, 3, 0, 0x12, 1, 0x67, 2, 0x01),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x01),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_status_short, flags)),
    MIP_END,
};

const struct mip_codec mip_tools_status_short_codec = {
    0x01, 0x90,  MIP_RESPONSE,         0,          sizeof(struct mip_tools_status_short),
    0,    false, program_status_short, &mip_layout};

static const uint8_t program_status_long[] = {
    MIP_LAYOUT(15, 15, 3, 0, 0x12, 1, 0x67, 2, 0x02),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_status_long, flags)),
    MIP_64_BITS(1, MIP_AT(struct mip_tools_status_long, uptime)),
    MIP_END,
};

const struct mip_codec mip_tools_status_long_codec = {
    0x01, 0x90,  MIP_RESPONSE,        0,          sizeof(struct mip_tools_status_long),
    0,    false, program_status_long, &mip_layout};

static const uint8_t program_status_old[] = {
    MIP_LAYOUT(0, 14, 3, 0, 0x12, 1, 0x67, 2, 0x02),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_status_old, uptime)),
    MIP_END,
};

const struct mip_codec mip_tools_status_old_codec = {
    0x01, 0x90,  MIP_RESPONSE,       0,          sizeof(struct mip_tools_status_old),
    0,    false, program_status_old, &mip_layout};

static const uint8_t program_full[] = {
    MIP_LAYOUT(16, 253, 3, 0, 0x12, 1, 0x67, 2, 0x02),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x02),
    MIP_16_BITS(2, MIP_AT(struct mip_tools_full, place.x)),
    MIP_64_BITS(1, MIP_AT(struct mip_tools_full, uptime)),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_full, mode)),
    MIP_END,
};

const struct mip_codec mip_tools_full_codec = {
    0x01, 0x90,  MIP_RESPONSE, 0,          sizeof(struct mip_tools_full),
    0,    false, program_full, &mip_layout};

static const uint8_t program_bias[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_tools_bias, bias)),
    MIP_END,
};

const struct mip_codec mip_tools_bias_codec = {
    0x01, 0x05,  MIP_COMMAND,  0,           sizeof(struct mip_tools_bias),
    0,    false, program_bias, &mip_program};

static bool asked_bias_1(const void *value) {
    const struct mip_tools_bias *v = (const struct mip_tools_bias *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_bias[] = {
    {&mip_tools_bias_vector_codec, asked_bias_1},
    {NULL, NULL},
};

const struct mip_command mip_tools_bias_command = {&mip_tools_bias_codec, NULL, responses_bias, 0};

static const uint8_t program_bias_vector[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_tools_bias_vector, bias)),
    MIP_END,
};

const struct mip_codec mip_tools_bias_vector_codec = {0x01,
                                                      0x9B,
                                                      MIP_RESPONSE,
                                                      12,
                                                      sizeof(struct mip_tools_bias_vector),
                                                      0,
                                                      sizeof(struct mip_tools_bias_vector) >= 8,
                                                      program_bias_vector,
                                                      NULL};

static const uint8_t program_capture_bias[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_tools_capture_bias, time)),
    MIP_END,
};

const struct mip_codec mip_tools_capture_bias_codec = {0x01,
                                                       0x06,
                                                       MIP_COMMAND,
                                                       2,
                                                       sizeof(struct mip_tools_capture_bias),
                                                       0,
                                                       sizeof(struct mip_tools_capture_bias) >= 8,
                                                       program_capture_bias,
                                                       NULL};

static const struct mip_response responses_capture_bias[] = {
    {&mip_tools_bias_vector_codec, NULL},
    {NULL, NULL},
};

const struct mip_command mip_tools_capture_bias_command = {&mip_tools_capture_bias_codec, NULL,
                                                           responses_capture_bias, 0};

static const uint8_t program_formats[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_tools_formats, suppress_ack)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_formats, num_segments), 25, 10,
                MIP_AT(struct mip_tools_formats, num_segments)),
    MIP_EACH(1, struct mip_segment, 7, MIP_AT(struct mip_tools_formats, segments)),
    MIP_16_BITS(2, MIP_AT(struct mip_segment, from.x)),
    MIP_16_BITS(2, MIP_AT(struct mip_segment, to.x)),
    MIP_8_BITS(2, MIP_AT(struct mip_segment, weights)),
    MIP_END,
    MIP_END,
};

const struct mip_codec mip_tools_formats_codec = {
    0x01, 0x07,  MIP_COMMAND,     0,           sizeof(struct mip_tools_formats),
    0,    false, program_formats, &mip_program};

static bool silent_formats(const void *value) {
    const struct mip_tools_formats *v = (const struct mip_tools_formats *)value;
    return v->suppress_ack != 0;
}

const struct mip_command mip_tools_formats_command = {&mip_tools_formats_codec, silent_formats,
                                                      NULL, 0};

static const uint8_t program_choice[] = {
    MIP_REQUIRED(2, 3, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_choice, instance)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_choice, shape)),
    MIP_GROUP(1),
    MIP_SWITCH(1, 4, MIP_AT(struct mip_tools_choice, shape)),
    MIP_CASE(21, 0x01),
    MIP_16_BITS(2, MIP_AT(struct mip_tools_choice, parameters.circle.center.x)),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_choice, parameters.circle.fill)),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_tools_choice, parameters.circle.fill)),
    MIP_CASE(3, 0x01),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_choice, parameters.circle.filling.solid)),
    MIP_END,
    MIP_CASE(5, 0x02),
    MIP_DOUBLES(1, MIP_AT(struct mip_tools_choice, parameters.circle.filling.striped.width)),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_choice, parameters.circle.filling.striped.angle)),
    MIP_END,
    MIP_END,
    MIP_CASE(17, 0x02),
    MIP_8_BITS(2, MIP_AT(struct mip_tools_choice, parameters.path.closed)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_choice, parameters.path.num_points), 62, 4,
                MIP_AT(struct mip_tools_choice, parameters.path.num_points)),
    MIP_EACH(1, struct mip_point, 3, MIP_AT(struct mip_tools_choice, parameters.path.points)),
    MIP_16_BITS(2, MIP_AT(struct mip_point, x)),
    MIP_END,
    MIP_END,
    MIP_CASE(3, 0x03),
    MIP_32_BITS(4, MIP_AT(struct mip_tools_choice, parameters.rotation)),
    MIP_END,
    MIP_CASE(3, 0x04),
    MIP_8_BITS(8, MIP_AT(struct mip_tools_choice, parameters.label)),
    MIP_END,
    MIP_END,
};

const struct mip_codec mip_tools_choice_codec = {
    0x01, 0x08,  MIP_COMMAND,    0,           sizeof(struct mip_tools_choice),
    0,    false, program_choice, &mip_program};

static bool asked_choice_1(const void *value) {
    const struct mip_tools_choice *v = (const struct mip_tools_choice *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_choice[] = {
    {&mip_tools_choice_response_codec, asked_choice_1},
    {NULL, NULL},
};

const struct mip_command mip_tools_choice_command = {&mip_tools_choice_codec, NULL,
                                                     responses_choice, 0};

static const uint8_t program_choice_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_tools_choice_response, instance)),
    MIP_SWITCH(1, 4, MIP_AT(struct mip_tools_choice_response, shape)),
    MIP_CASE(21, 0x01),
    MIP_16_BITS(2, MIP_AT(struct mip_tools_choice_response, parameters.circle.center.x)),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_choice_response, parameters.circle.fill)),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_tools_choice_response, parameters.circle.fill)),
    MIP_CASE(3, 0x01),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_choice_response, parameters.circle.filling.solid)),
    MIP_END,
    MIP_CASE(5, 0x02),
    MIP_DOUBLES(1,
                MIP_AT(struct mip_tools_choice_response, parameters.circle.filling.striped.width)),
    MIP_32_BITS(1,
                MIP_AT(struct mip_tools_choice_response, parameters.circle.filling.striped.angle)),
    MIP_END,
    MIP_END,
    MIP_CASE(17, 0x02),
    MIP_8_BITS(2, MIP_AT(struct mip_tools_choice_response, parameters.path.closed)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_choice_response, parameters.path.num_points), 62, 4,
                MIP_AT(struct mip_tools_choice_response, parameters.path.num_points)),
    MIP_EACH(1, struct mip_point, 3,
             MIP_AT(struct mip_tools_choice_response, parameters.path.points)),
    MIP_16_BITS(2, MIP_AT(struct mip_point, x)),
    MIP_END,
    MIP_END,
    MIP_CASE(3, 0x03),
    MIP_32_BITS(4, MIP_AT(struct mip_tools_choice_response, parameters.rotation)),
    MIP_END,
    MIP_CASE(3, 0x04),
    MIP_8_BITS(8, MIP_AT(struct mip_tools_choice_response, parameters.label)),
    MIP_END,
    MIP_END,
};

const struct mip_codec mip_tools_choice_response_codec = {0x01,
                                                          0x88,
                                                          MIP_RESPONSE,
                                                          0,
                                                          sizeof(struct mip_tools_choice_response),
                                                          0,
                                                          false,
                                                          program_choice_response,
                                                          &mip_program};

static const uint8_t program_list[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(2),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_list, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_list, count), 125, 2,
                MIP_AT(struct mip_tools_list, count)),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_list, items)),
    MIP_END,
};

const struct mip_codec mip_tools_list_codec = {
    0x01, 0x09,  MIP_COMMAND,  0,           sizeof(struct mip_tools_list),
    0,    false, program_list, &mip_program};

static bool asked_list_1(const void *value) {
    const struct mip_tools_list *v = (const struct mip_tools_list *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_list[] = {
    {&mip_tools_list_response_codec, asked_list_1},
    {NULL, NULL},
};

const struct mip_command mip_tools_list_command = {&mip_tools_list_codec, NULL, responses_list, 0};

static const uint8_t program_list_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_tools_list_response, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_list_response, count), 126, 2,
                MIP_AT(struct mip_tools_list_response, count)),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_list_response, items)),
    MIP_END,
};

const struct mip_codec mip_tools_list_response_codec = {
    0x01, 0x89,  MIP_RESPONSE,          0,           sizeof(struct mip_tools_list_response),
    0,    false, program_list_response, &mip_program};

static const uint8_t program_stock[] = {
    MIP_END,
};

const struct mip_codec mip_tools_stock_codec = {
    0x01, 0x0A, MIP_COMMAND, 0, sizeof(struct mip_tools_stock), 0, false, program_stock, NULL};

static const struct mip_response responses_stock[] = {
    {&mip_tools_stock_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_command mip_tools_stock_command = {&mip_tools_stock_codec, NULL, responses_stock,
                                                    0};

static const uint8_t program_stock_response[] = {
    MIP_REST(126, 2, MIP_AT(struct mip_tools_stock_response, descriptors_count)),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_stock_response, descriptors)),
    MIP_END,
};

const struct mip_codec mip_tools_stock_response_codec = {
    0x01, 0x8A,  MIP_RESPONSE,           0,           sizeof(struct mip_tools_stock_response),
    0,    false, program_stock_response, &mip_program};

static const uint8_t program_pin[] = {
    MIP_REQUIRED(2, 2, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_pin, drive)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_pin, use)),
    MIP_END,
};

const struct mip_codec mip_tools_pin_codec = {
    0x01, 0x0B, MIP_COMMAND, 0, sizeof(struct mip_tools_pin), 0, false, program_pin, &mip_program};

static bool asked_pin_1(const void *value) {
    const struct mip_tools_pin *v = (const struct mip_tools_pin *)value;
    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_pin[] = {
    {&mip_tools_pin_response_codec, asked_pin_1},
    {NULL, NULL},
};

const struct mip_command mip_tools_pin_command = {&mip_tools_pin_codec, NULL, responses_pin, 0};

static const uint8_t program_pin_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_tools_pin_response, drive)),
    MIP_END,
};

const struct mip_codec mip_tools_pin_response_codec = {0x01,
                                                       0x8B,
                                                       MIP_RESPONSE,
                                                       2,
                                                       sizeof(struct mip_tools_pin_response),
                                                       0,
                                                       sizeof(struct mip_tools_pin_response) >= 8,
                                                       program_pin_response,
                                                       NULL};

static const uint8_t program_hello[] = {
    MIP_OPTIONAL(1), MIP_32_BITS(1, MIP_AT(struct mip_tools_hello, reserved)),
    MIP_GROUP(1),    MIP_DOUBLES(2, MIP_AT(struct mip_tools_hello, later)),
    MIP_END,
};

const struct mip_codec mip_tools_hello_codec = {
    0x01, 0x0C,  MIP_COMMAND,   0,           sizeof(struct mip_tools_hello),
    0,    false, program_hello, &mip_program};

static const struct mip_response responses_hello[] = {
    {&mip_tools_hello_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_command mip_tools_hello_command = {&mip_tools_hello_codec, NULL, responses_hello,
                                                    0};

static const uint8_t program_hello_response[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_tools_hello_response, seen)),
    MIP_END,
};

const struct mip_codec mip_tools_hello_response_codec = {0x01,
                                                         0x8C,
                                                         MIP_RESPONSE,
                                                         4,
                                                         sizeof(struct mip_tools_hello_response),
                                                         0,
                                                         sizeof(struct mip_tools_hello_response) >=
                                                             8,
                                                         program_hello_response,
                                                         NULL};

static const uint8_t program_readings[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_tools_readings, drive)),
    MIP_END,
};

const struct mip_codec mip_tools_readings_codec = {0x01,
                                                   0x0D,
                                                   MIP_COMMAND,
                                                   1,
                                                   sizeof(struct mip_tools_readings),
                                                   0,
                                                   sizeof(struct mip_tools_readings) >= 8,
                                                   program_readings,
                                                   NULL};

static const struct mip_response responses_readings[] = {
    {&mip_tools_readings_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_command mip_tools_readings_command = {&mip_tools_readings_codec, NULL,
                                                       responses_readings, 0};

static const uint8_t program_readings_response[] = {
    MIP_FAR,
    MIP_8_BITS(2, MIP_FAR_AT(struct mip_tools_readings_response, drive)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_readings_response, count), 49, 5,
                MIP_FAR_AT(struct mip_tools_readings_response, count)),
    MIP_EACH(1, struct mip_tools_reading, 7,
             MIP_FAR_AT(struct mip_tools_readings_response, readings)),
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_tools_reading, kind)),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_tools_reading, value)),
    MIP_END,
    MIP_8_BITS(1, MIP_FAR_AT(struct mip_tools_readings_response, last.kind)),
    MIP_32_BITS(1, MIP_FAR_AT(struct mip_tools_readings_response, last.value)),
    MIP_END,
};

const struct mip_codec mip_tools_readings_response_codec = {
    0x01,
    0x8D,
    MIP_RESPONSE,
    0,
    sizeof(struct mip_tools_readings_response),
    0,
    false,
    program_readings_response,
    &mip_program};

static const uint8_t program_poll[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_tools_poll, descriptor_set)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_poll, count), 250, 1,
                MIP_AT(struct mip_tools_poll, count)),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_poll, descriptors)),
    MIP_END,
};

const struct mip_codec mip_tools_poll_codec = {
    0x01, 0x0E,  MIP_COMMAND,  0,           sizeof(struct mip_tools_poll),
    0,    false, program_poll, &mip_program};

const struct mip_command mip_tools_poll_command = {&mip_tools_poll_codec, NULL, NULL, 0};
