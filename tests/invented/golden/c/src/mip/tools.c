/* Tools. */
#include "mip/tools.h"
#include "mip/tools_commands.h"
#include "mip/program.h"

static const uint8_t program_ping[] = {
    MIP_END,
};

const struct mip_codec mip_tools_ping_codec = {
    0x01, 0x01, MIP_COMMAND, 0, sizeof(struct mip_tools_ping), 0, 0, program_ping, NULL};

const struct mip_exchange mip_tools_ping_exchange = {0x01, 0x01, 0, 0, NULL};

const struct mip_command mip_tools_ping_command = {&mip_tools_ping_codec, &mip_tools_ping_exchange,
                                                   false};

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
    MIP_RESERVED,
    MIP_8_BITS(1, MIP_AT(struct mip_tools_settings, reserved)),
    MIP_END,
};

const struct mip_codec mip_tools_settings_codec = {
    0x01, 0x02, MIP_COMMAND,      0,           sizeof(struct mip_tools_settings),
    0,    0,    program_settings, &mip_program};

static const struct mip_response responses_settings[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_tools_settings_exchange = {
    0x01, 0x02, 0, sizeof(responses_settings) / sizeof(responses_settings[0]), responses_settings};

const struct mip_command mip_tools_settings_command = {&mip_tools_settings_codec,
                                                       &mip_tools_settings_exchange, true};

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
    0,
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
    0x01, 0x03, MIP_COMMAND,      0,           sizeof(struct mip_tools_set_time),
    0,    0,    program_set_time, &mip_program};

static const struct mip_response responses_set_time[] = {
    {NULL, 0x00, 2, MIP_FUNCTION_SELECTOR_APPLY, false},
    {NULL, 0x83, 2, MIP_FUNCTION_SELECTOR_READ, true},
    {NULL, 0x83, 3, 1, false},
    {NULL, 0x84, 2, MIP_FUNCTION_SELECTOR_READ, true},
    {NULL, 0x84, 3, 2, false},
};

const struct mip_exchange mip_tools_set_time_exchange = {
    0x01, 0x03, 0, sizeof(responses_set_time) / sizeof(responses_set_time[0]), responses_set_time};

const struct mip_command mip_tools_set_time_command = {&mip_tools_set_time_codec,
                                                       &mip_tools_set_time_exchange, true};

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
    MIP_SHAPE(0, 1, 0),
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
    MIP_SHAPE(0, 1, 0),
    program_set_time_slow_response,
    NULL};

static const uint8_t program_status[] = {
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_status, selector)),
    MIP_END,
};

const struct mip_codec mip_tools_status_codec = {
    0x01, 0x04, MIP_COMMAND,    0,           sizeof(struct mip_tools_status),
    0,    0,    program_status, &mip_program};

static const struct mip_response responses_status[] = {
    {&mip_tools_status_paged_codec, 0x90, 4, 1, true},
    {&mip_tools_status_short_codec, 0x90, 4, 1, false},
    {&mip_tools_status_long_codec, 0x90, 4, 2, true},
    {&mip_tools_status_old_codec, 0x90, 4, 2, true},
    {&mip_tools_full_codec, 0x90, 4, 2, false},
};

const struct mip_exchange mip_tools_status_exchange = {
    0x01, 0x04, 10, sizeof(responses_status) / sizeof(responses_status[0]), responses_status};

const struct mip_command mip_tools_status_command = {&mip_tools_status_codec,
                                                     &mip_tools_status_exchange, false};

static const uint8_t program_status_paged[] = {
    MIP_LAYOUT(0, 253, 4, 0, 0x12, 1, 0x67, 2, 0x01, 3, 0x07),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x01),
    MIP_CONSTANT(1, 0x07),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_status_paged, uptime)),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_status_paged, level)),
    MIP_END,
};

const struct mip_codec mip_tools_status_paged_codec = {
    0x01, 0x90, MIP_RESPONSE,         0,          sizeof(struct mip_tools_status_paged),
    0,    0,    program_status_paged, &mip_layout};

static const uint8_t program_status_short[] = {
    MIP_LAYOUT(0, 253, 3, 0, 0x12, 1, 0x67, 2, 0x01),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x01),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_status_short, flags)),
    MIP_END,
};

const struct mip_codec mip_tools_status_short_codec = {
    0x01, 0x90, MIP_RESPONSE,         0,          sizeof(struct mip_tools_status_short),
    0,    0,    program_status_short, &mip_layout};

static const uint8_t program_status_long[] = {
    MIP_LAYOUT(15, 15, 3, 0, 0x12, 1, 0x67, 2, 0x02),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_status_long, flags)),
    MIP_64_BITS(1, MIP_AT(struct mip_tools_status_long, uptime)),
    MIP_END,
};

const struct mip_codec mip_tools_status_long_codec = {
    0x01, 0x90, MIP_RESPONSE,        0,          sizeof(struct mip_tools_status_long),
    0,    0,    program_status_long, &mip_layout};

static const uint8_t program_status_old[] = {
    MIP_LAYOUT(0, 14, 3, 0, 0x12, 1, 0x67, 2, 0x02),
    MIP_CONSTANT(2, 0x12, 0x67),
    MIP_CONSTANT(1, 0x02),
    MIP_32_BITS(1, MIP_AT(struct mip_tools_status_old, uptime)),
    MIP_END,
};

const struct mip_codec mip_tools_status_old_codec = {
    0x01, 0x90, MIP_RESPONSE,       0,          sizeof(struct mip_tools_status_old),
    0,    0,    program_status_old, &mip_layout};

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
    0x01, 0x90, MIP_RESPONSE, 0, sizeof(struct mip_tools_full), 0, 0, program_full, &mip_layout};

static const uint8_t program_bias[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_tools_bias, bias)),
    MIP_END,
};

const struct mip_codec mip_tools_bias_codec = {
    0x01, 0x05, MIP_COMMAND, 0, sizeof(struct mip_tools_bias), 0, 0, program_bias, &mip_program};

static const struct mip_response responses_bias[] = {
    {NULL, 0x9B, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_tools_bias_exchange = {
    0x01, 0x05, 0, sizeof(responses_bias) / sizeof(responses_bias[0]), responses_bias};

const struct mip_command mip_tools_bias_command = {&mip_tools_bias_codec, &mip_tools_bias_exchange,
                                                   true};

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
                                                      MIP_SHAPE(0, 3, 0),
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
                                                       MIP_SHAPE(0, 0, 1),
                                                       program_capture_bias,
                                                       NULL};

static const struct mip_response responses_capture_bias[] = {
    {NULL, 0x9B, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_tools_capture_bias_exchange = {
    0x01, 0x06, 0, sizeof(responses_capture_bias) / sizeof(responses_capture_bias[0]),
    responses_capture_bias};

const struct mip_command mip_tools_capture_bias_command = {&mip_tools_capture_bias_codec,
                                                           &mip_tools_capture_bias_exchange, false};

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
    0x01, 0x07, MIP_COMMAND,     0,           sizeof(struct mip_tools_formats),
    0,    0,    program_formats, &mip_program};

static const struct mip_response responses_formats[] = {
    {NULL, 0x00, 2, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_tools_formats_exchange = {
    0x01, 0x07, 0, sizeof(responses_formats) / sizeof(responses_formats[0]), responses_formats};

const struct mip_command mip_tools_formats_command = {&mip_tools_formats_codec,
                                                      &mip_tools_formats_exchange, false};

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
    0x01, 0x08, MIP_COMMAND,    0,           sizeof(struct mip_tools_choice),
    0,    0,    program_choice, &mip_program};

static const struct mip_response responses_choice[] = {
    {NULL, 0x88, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_tools_choice_exchange = {
    0x01, 0x08, 0, sizeof(responses_choice) / sizeof(responses_choice[0]), responses_choice};

const struct mip_command mip_tools_choice_command = {&mip_tools_choice_codec,
                                                     &mip_tools_choice_exchange, true};

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
                                                          0,
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
    0x01, 0x09, MIP_COMMAND, 0, sizeof(struct mip_tools_list), 0, 0, program_list, &mip_program};

static const struct mip_response responses_list[] = {
    {NULL, 0x89, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_tools_list_exchange = {
    0x01, 0x09, 0, sizeof(responses_list) / sizeof(responses_list[0]), responses_list};

const struct mip_command mip_tools_list_command = {&mip_tools_list_codec, &mip_tools_list_exchange,
                                                   true};

static const uint8_t program_list_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_tools_list_response, count)),
    MIP_COUNTED(MIP_SIZE(struct mip_tools_list_response, count), 126, 2,
                MIP_AT(struct mip_tools_list_response, count)),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_list_response, items)),
    MIP_END,
};

const struct mip_codec mip_tools_list_response_codec = {
    0x01, 0x89, MIP_RESPONSE,          0,           sizeof(struct mip_tools_list_response),
    0,    0,    program_list_response, &mip_program};

static const uint8_t program_stock[] = {
    MIP_END,
};

const struct mip_codec mip_tools_stock_codec = {
    0x01, 0x0A, MIP_COMMAND, 0, sizeof(struct mip_tools_stock), 0, 0, program_stock, NULL};

static const struct mip_response responses_stock[] = {
    {NULL, 0x8A, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_tools_stock_exchange = {
    0x01, 0x0A, 0, sizeof(responses_stock) / sizeof(responses_stock[0]), responses_stock};

const struct mip_command mip_tools_stock_command = {&mip_tools_stock_codec,
                                                    &mip_tools_stock_exchange, false};

static const uint8_t program_stock_response[] = {
    MIP_REST(126, 2, MIP_AT(struct mip_tools_stock_response, descriptors_count)),
    MIP_16_BITS(1, MIP_AT(struct mip_tools_stock_response, descriptors)),
    MIP_END,
};

const struct mip_codec mip_tools_stock_response_codec = {
    0x01, 0x8A, MIP_RESPONSE,           0,           sizeof(struct mip_tools_stock_response),
    0,    0,    program_stock_response, &mip_program};

static const uint8_t program_pin[] = {
    MIP_REQUIRED(2, 2, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_pin, drive)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_tools_pin, use)),
    MIP_END,
};

const struct mip_codec mip_tools_pin_codec = {
    0x01, 0x0B, MIP_COMMAND, 0, sizeof(struct mip_tools_pin), 0, 0, program_pin, &mip_program};

static const struct mip_response responses_pin[] = {
    {NULL, 0x8B, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

const struct mip_exchange mip_tools_pin_exchange = {
    0x01, 0x0B, 0, sizeof(responses_pin) / sizeof(responses_pin[0]), responses_pin};

const struct mip_command mip_tools_pin_command = {&mip_tools_pin_codec, &mip_tools_pin_exchange,
                                                  true};

static const uint8_t program_pin_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_tools_pin_response, drive)),
    MIP_END,
};

const struct mip_codec mip_tools_pin_response_codec = {
    0x01, 0x8B, MIP_RESPONSE,         2,   sizeof(struct mip_tools_pin_response),
    0,    0,    program_pin_response, NULL};

static const uint8_t program_hello[] = {
    MIP_OPTIONAL(1), MIP_32_BITS(1, MIP_AT(struct mip_tools_hello, reserved)),
    MIP_GROUP(1),    MIP_DOUBLES(2, MIP_AT(struct mip_tools_hello, later)),
    MIP_END,
};

const struct mip_codec mip_tools_hello_codec = {
    0x01, 0x0C, MIP_COMMAND, 0, sizeof(struct mip_tools_hello), 0, 0, program_hello, &mip_program};

static const struct mip_response responses_hello[] = {
    {NULL, 0x8C, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_tools_hello_exchange = {
    0x01, 0x0C, 0, sizeof(responses_hello) / sizeof(responses_hello[0]), responses_hello};

const struct mip_command mip_tools_hello_command = {&mip_tools_hello_codec,
                                                    &mip_tools_hello_exchange, false};

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
                                                         MIP_SHAPE(0, 1, 0),
                                                         program_hello_response,
                                                         NULL};

static const uint8_t program_readings[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_tools_readings, drive)),
    MIP_END,
};

const struct mip_codec mip_tools_readings_codec = {
    0x01, 0x0D, MIP_COMMAND, 1, sizeof(struct mip_tools_readings), 0, 0, program_readings, NULL};

static const struct mip_response responses_readings[] = {
    {NULL, 0x8D, 0, MIP_NOT_ZERO, false},
};

const struct mip_exchange mip_tools_readings_exchange = {
    0x01, 0x0D, 0, sizeof(responses_readings) / sizeof(responses_readings[0]), responses_readings};

const struct mip_command mip_tools_readings_command = {&mip_tools_readings_codec,
                                                       &mip_tools_readings_exchange, false};

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
    0,
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
    0x01, 0x0E, MIP_COMMAND, 0, sizeof(struct mip_tools_poll), 0, 0, program_poll, &mip_program};

const struct mip_exchange mip_tools_poll_exchange = {0x01, 0x0E, 0, 0, NULL};

const struct mip_command mip_tools_poll_command = {&mip_tools_poll_codec, &mip_tools_poll_exchange,
                                                   false};
