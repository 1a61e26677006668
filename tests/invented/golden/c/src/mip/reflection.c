

/* The parameters of all fields. */
#include "mip/reflect.h"

#include "mip/names.h"

#include "mip/protocol.h"
#include "mip/tools.h"
#include "mip/3d.h"
#include "mip/measurements.h"
#include "mip/shared.h"

/* The offset of a member, and the size of one item of it. */
#define ONE(record, member) offsetof(record, member), sizeof(((record *)0)->member)
#define MANY(record, member) offsetof(record, member), sizeof(((record *)0)->member[0])

/* ----------------------------------------------------------------------------------- parameters */

static const struct mip_parameter parameters_point[] = {
    {"x", "m", MIP_KIND_NUMBER, MIP_SCALAR_S16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_point, x), 0, NULL, NULL, NULL, NULL, 0},
    {"y", "m", MIP_KIND_NUMBER, MIP_SCALAR_S16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_point, y), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_point = {
    parameters_point,
    2,
    sizeof(struct mip_point),
};

static const struct mip_parameter parameters_segment[] = {
    {"from", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_segment, from), 0, NULL, NULL, &record_point, NULL, 0},
    {"to", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_segment, to), 0, NULL, NULL, &record_point, NULL, 0},
    {"weights", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 2, 1, 0, 0, 0,
     MANY(struct mip_segment, weights), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_segment = {
    parameters_segment,
    3,
    sizeof(struct mip_segment),
};

static const struct mip_parameter parameters_tools_bars[] = {
    {"width", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_bars, width), 0, NULL, NULL, NULL, NULL, 0},
    {"angle", "deg", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_bars, angle), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_bars = {
    parameters_tools_bars,
    2,
    sizeof(struct mip_tools_bars),
};

static const struct mip_parameter members_tools_circle_filling[] = {
    {"solid", "", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_tools_circle_filling, solid), 0, NULL, NULL, NULL, NULL, 0},
    {"striped", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_tools_circle_filling, striped), 0, NULL, NULL, &record_tools_bars, NULL, 0},
};
static const struct mip_case cases_tools_circle_filling[] = {
    {0, NULL},
    {1, &members_tools_circle_filling[0]},
    {2, &members_tools_circle_filling[1]},
};
static const struct mip_parameter parameters_tools_circle[] = {
    {"center", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_circle, center), 0, NULL, NULL, &record_point, NULL, 0},
    {"fill", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_circle, fill), 0, &mip_names_tools_fill, NULL, NULL, NULL, 0},
    {"filling", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_tools_circle, filling), 0, NULL, NULL, NULL, cases_tools_circle_filling, 3},
};
static const struct mip_record record_tools_circle = {
    parameters_tools_circle,
    3,
    sizeof(struct mip_tools_circle),
};

static const struct mip_parameter parameters_tools_path[] = {
    {"closed", "", MIP_KIND_NUMBER, MIP_SCALAR_BOOL, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_path, closed), 0, NULL, NULL, NULL, NULL, 0},
    {"num_points", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_tools_path, num_points), 0, NULL, NULL, NULL, NULL, 0},
    {"points", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 62, 1, 1, 0, 0,
     MANY(struct mip_tools_path, points), 0, NULL, NULL, &record_point, NULL, 0},
};
static const struct mip_record record_tools_path = {
    parameters_tools_path,
    3,
    sizeof(struct mip_tools_path),
};

static const struct mip_parameter parameters_tools_reading[] = {
    {"kind", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_reading, kind), 0, NULL, NULL, NULL, NULL, 0},
    {"value", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_reading, value), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_reading = {
    parameters_tools_reading,
    2,
    sizeof(struct mip_tools_reading),
};

static const struct mip_reading readings_protocol_acknowledge_code[] = {
    {"model-b", 0, 0, &mip_names_mode},
};
static const struct mip_parameter parameters_protocol_acknowledge[] = {
    {"command", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_protocol_acknowledge, command), 0, NULL, NULL, NULL, NULL, 0},
    {"code", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_protocol_acknowledge, code), 0, &mip_names_ack_code,
     readings_protocol_acknowledge_code, NULL, NULL, 1},
};
static const struct mip_record record_protocol_acknowledge = {
    parameters_protocol_acknowledge,
    2,
    sizeof(struct mip_protocol_acknowledge),
};

static const struct mip_record record_tools_ping = {
    NULL,
    0,
    sizeof(struct mip_tools_ping),
};

static const struct mip_parameter parameters_tools_settings[] = {
    {"function", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_settings, function), 0, &mip_names_function_selector, NULL, NULL, NULL,
     0},
    {"port", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 1, 0,
     ONE(struct mip_tools_settings, port), 0, NULL, NULL, NULL, NULL, 0},
    {"mode", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 2, 0,
     ONE(struct mip_tools_settings, mode), 0, &mip_names_mode, NULL, NULL, NULL, 0},
    {"baud", "Bd", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 3, 0,
     ONE(struct mip_tools_settings, baud), 0, NULL, NULL, NULL, NULL, 0},
    {"limit", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 4, 0,
     ONE(struct mip_tools_settings, limit), 0, NULL, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 5, 0,
     ONE(struct mip_tools_settings, reserved), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_settings = {
    parameters_tools_settings,
    6,
    sizeof(struct mip_tools_settings),
};
static const uint8_t required_tools_settings[] = {0, 3, 2, 1, 1, 1, 3};

static const struct mip_parameter parameters_tools_set_time[] = {
    {"function", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_set_time, function), 0, &mip_names_function_selector, NULL, NULL, NULL,
     0},
    {"part", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 1, 0,
     ONE(struct mip_tools_set_time, part), 0, &mip_names_mode, NULL, NULL, NULL, 0},
    {"value", "s", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 2, 0,
     ONE(struct mip_tools_set_time, value), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_set_time = {
    parameters_tools_set_time,
    3,
    sizeof(struct mip_tools_set_time),
};
static const uint8_t required_tools_set_time[] = {0, 2, 1, 0, 0, 0, 2};

static const struct mip_parameter parameters_tools_status[] = {
    {"model", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 4711, 0, 0, 0,
     NULL, NULL, NULL, NULL, 0},
    {"selector", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status, selector), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_status = {
    parameters_tools_status,
    2,
    sizeof(struct mip_tools_status),
};

static const struct mip_parameter parameters_tools_bias[] = {
    {"function", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_bias, function), 0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"bias", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_tools_bias, bias), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_bias = {
    parameters_tools_bias,
    2,
    sizeof(struct mip_tools_bias),
};
static const uint8_t required_tools_bias[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_tools_capture_bias[] = {
    {"time", "s", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_capture_bias, time), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_capture_bias = {
    parameters_tools_capture_bias,
    1,
    sizeof(struct mip_tools_capture_bias),
};

static const struct mip_parameter parameters_tools_formats[] = {
    {"suppress_ack", "", MIP_KIND_NUMBER, MIP_SCALAR_BOOL, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_formats, suppress_ack), 0, NULL, NULL, NULL, NULL, 0},
    {"num_segments", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_tools_formats, num_segments), 0, NULL, NULL, NULL, NULL, 0},
    {"checkpoint", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_formats, checkpoint), 0, NULL, NULL, NULL, NULL, 0},
    {"segments", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 25, 1, 1, 0, 0,
     MANY(struct mip_tools_formats, segments), 0, NULL, NULL, &record_segment, NULL, 0},
};
static const struct mip_record record_tools_formats = {
    parameters_tools_formats,
    4,
    sizeof(struct mip_tools_formats),
};

static const struct mip_parameter members_tools_choice_parameters[] = {
    {"circle", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_tools_choice_parameters, circle), 0, NULL, NULL, &record_tools_circle, NULL, 0},
    {"path", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_tools_choice_parameters, path), 0, NULL, NULL, &record_tools_path, NULL, 0},
    {"rotation", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(union mip_tools_choice_parameters, rotation), 0, NULL, NULL, NULL, NULL, 0},
    {"label", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 8, 1, 0, 0, 0,
     MANY(union mip_tools_choice_parameters, label), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_case cases_tools_choice_parameters[] = {
    {0, NULL},
    {1, &members_tools_choice_parameters[0]},
    {2, &members_tools_choice_parameters[1]},
    {3, &members_tools_choice_parameters[2]},
    {4, &members_tools_choice_parameters[3]},
};
static const struct mip_parameter parameters_tools_choice[] = {
    {"function", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_choice, function), 0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"instance", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 1, 0,
     ONE(struct mip_tools_choice, instance), 0, NULL, NULL, NULL, NULL, 0},
    {"shape", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 2, 0,
     ONE(struct mip_tools_choice, shape), 0, &mip_names_tools_shape, NULL, NULL, NULL, 0},
    {"parameters", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 3, 0,
     ONE(struct mip_tools_choice, parameters), 0, NULL, NULL, NULL, cases_tools_choice_parameters,
     5},
};
static const struct mip_record record_tools_choice = {
    parameters_tools_choice,
    4,
    sizeof(struct mip_tools_choice),
};
static const uint8_t required_tools_choice[] = {0, 3, 1};

static const struct mip_parameter parameters_tools_list[] = {
    {"function", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_list, function), 0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 2, 0,
     ONE(struct mip_tools_list, count), 0, NULL, NULL, NULL, NULL, 0},
    {"items", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_COUNTED, 125, 1, 1, 2, 0,
     MANY(struct mip_tools_list, items), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_list = {
    parameters_tools_list,
    3,
    sizeof(struct mip_tools_list),
};
static const uint8_t required_tools_list[] = {0, 2, 0, 0};

static const struct mip_record record_tools_stock = {
    NULL,
    0,
    sizeof(struct mip_tools_stock),
};

static const struct mip_reading readings_tools_pin_use[] = {
    {NULL, 1, 1, &mip_names_tools_pulse},
    {NULL, 1, 2, &mip_names_tools_serial_use},
};
static const struct mip_parameter parameters_tools_pin[] = {
    {"function", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_pin, function), 0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"drive", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 1, 0,
     ONE(struct mip_tools_pin, drive), 0, &mip_names_tools_drive, NULL, NULL, NULL, 0},
    {"use", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 2, 0,
     ONE(struct mip_tools_pin, use), 0, NULL, readings_tools_pin_use, NULL, NULL, 2},
};
static const struct mip_record record_tools_pin = {
    parameters_tools_pin,
    3,
    sizeof(struct mip_tools_pin),
};
static const uint8_t required_tools_pin[] = {0, 2, 1};

static const struct mip_parameter parameters_tools_hello[] = {
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_hello, reserved), 0, NULL, NULL, NULL, NULL, 0},
    {"later", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 2, 1, 0, 2, 0,
     MANY(struct mip_tools_hello, later), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_hello = {
    parameters_tools_hello,
    2,
    sizeof(struct mip_tools_hello),
};

static const struct mip_parameter parameters_tools_readings[] = {
    {"drive", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_readings, drive), 0, &mip_names_tools_drive, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_readings = {
    parameters_tools_readings,
    1,
    sizeof(struct mip_tools_readings),
};

static const struct mip_parameter parameters_tools_poll[] = {
    {"descriptor_set", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_poll, descriptor_set), 0, NULL, NULL, NULL, NULL, 0},
    {"first", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_poll, first), 0, NULL, NULL, NULL, NULL, 0},
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_tools_poll, count), 0, NULL, NULL, NULL, NULL, 0},
    {"descriptors", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 250, 1, 2, 0, 0,
     MANY(struct mip_tools_poll, descriptors), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_poll = {
    parameters_tools_poll,
    4,
    sizeof(struct mip_tools_poll),
};

static const struct mip_parameter parameters_tools_settings_response[] = {
    {"port", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_settings_response, port), 0, NULL, NULL, NULL, NULL, 0},
    {"mode", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_settings_response, mode), 0, &mip_names_mode, NULL, NULL, NULL, 0},
    {"baud", "Bd", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_settings_response, baud), 0, NULL, NULL, NULL, NULL, 0},
    {"limit", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_settings_response, limit), 0, NULL, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_settings_response, reserved), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_settings_response = {
    parameters_tools_settings_response,
    5,
    sizeof(struct mip_tools_settings_response),
};

static const struct mip_parameter parameters_tools_set_time_fast_response[] = {
    {"value", "s", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_set_time_fast_response, value), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_set_time_fast_response = {
    parameters_tools_set_time_fast_response,
    1,
    sizeof(struct mip_tools_set_time_fast_response),
};

static const struct mip_parameter parameters_tools_set_time_slow_response[] = {
    {"value", "s", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_set_time_slow_response, value), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_set_time_slow_response = {
    parameters_tools_set_time_slow_response,
    1,
    sizeof(struct mip_tools_set_time_slow_response),
};

static const struct mip_parameter members_tools_choice_response_parameters[] = {
    {"circle", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_tools_choice_response_parameters, circle), 0, NULL, NULL, &record_tools_circle,
     NULL, 0},
    {"path", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_tools_choice_response_parameters, path), 0, NULL, NULL, &record_tools_path, NULL,
     0},
    {"rotation", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(union mip_tools_choice_response_parameters, rotation), 0, NULL, NULL, NULL, NULL, 0},
    {"label", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 8, 1, 0, 0, 0,
     MANY(union mip_tools_choice_response_parameters, label), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_case cases_tools_choice_response_parameters[] = {
    {0, NULL},
    {1, &members_tools_choice_response_parameters[0]},
    {2, &members_tools_choice_response_parameters[1]},
    {3, &members_tools_choice_response_parameters[2]},
    {4, &members_tools_choice_response_parameters[3]},
};
static const struct mip_parameter parameters_tools_choice_response[] = {
    {"instance", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_choice_response, instance), 0, NULL, NULL, NULL, NULL, 0},
    {"shape", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_choice_response, shape), 0, &mip_names_tools_shape, NULL, NULL, NULL, 0},
    {"parameters", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_tools_choice_response, parameters), 0, NULL, NULL, NULL,
     cases_tools_choice_response_parameters, 5},
};
static const struct mip_record record_tools_choice_response = {
    parameters_tools_choice_response,
    3,
    sizeof(struct mip_tools_choice_response),
};

static const struct mip_parameter parameters_tools_list_response[] = {
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_tools_list_response, count), 0, NULL, NULL, NULL, NULL, 0},
    {"items", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_COUNTED, 126, 1, 0, 0, 0,
     MANY(struct mip_tools_list_response, items), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_list_response = {
    parameters_tools_list_response,
    2,
    sizeof(struct mip_tools_list_response),
};

static const struct mip_parameter parameters_tools_stock_response[] = {
    {"descriptors", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_REST, 126, 1, 0, 0, 0,
     MANY(struct mip_tools_stock_response, descriptors),
     offsetof(struct mip_tools_stock_response, descriptors_count), NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_stock_response = {
    parameters_tools_stock_response,
    1,
    sizeof(struct mip_tools_stock_response),
};

static const struct mip_reading readings_tools_pin_response_use[] = {
    {NULL, 0, 1, &mip_names_tools_pulse},
    {NULL, 0, 2, &mip_names_tools_serial_use},
};
static const struct mip_parameter parameters_tools_pin_response[] = {
    {"drive", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_pin_response, drive), 0, &mip_names_tools_drive, NULL, NULL, NULL, 0},
    {"use", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_pin_response, use), 0, NULL, readings_tools_pin_response_use, NULL, NULL,
     2},
};
static const struct mip_record record_tools_pin_response = {
    parameters_tools_pin_response,
    2,
    sizeof(struct mip_tools_pin_response),
};

static const struct mip_parameter parameters_tools_hello_response[] = {
    {"seen", "s", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_hello_response, seen), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_hello_response = {
    parameters_tools_hello_response,
    1,
    sizeof(struct mip_tools_hello_response),
};

static const struct mip_parameter parameters_tools_readings_response[] = {
    {"drive", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_readings_response, drive), 0, &mip_names_tools_drive, NULL, NULL, NULL,
     0},
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_tools_readings_response, count), 0, NULL, NULL, NULL, NULL, 0},
    {"readings", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 49, 1, 1, 0, 0,
     MANY(struct mip_tools_readings_response, readings), 0, NULL, NULL, &record_tools_reading, NULL,
     0},
    {"last", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_readings_response, last), 0, NULL, NULL, &record_tools_reading, NULL, 0},
};
static const struct mip_record record_tools_readings_response = {
    parameters_tools_readings_response,
    4,
    sizeof(struct mip_tools_readings_response),
};

static const struct mip_parameter parameters_tools_status_paged[] = {
    {"model", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 4711, 0, 0, 0,
     NULL, NULL, NULL, NULL, 0},
    {"selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 1, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"page", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 7, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"uptime", "s", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status_paged, uptime), 0, NULL, NULL, NULL, NULL, 0},
    {"level", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status_paged, level), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_status_paged = {
    parameters_tools_status_paged,
    5,
    sizeof(struct mip_tools_status_paged),
};

static const struct mip_reading readings_tools_status_short_flags[] = {
    {"model-a", 0, 0, &mip_names_tools_a_faults},
    {"model-b", 0, 0, &mip_names_tools_model_b_faults},
    {"model-c", 0, 0, &mip_names_tools_a_faults},
};
static const struct mip_parameter parameters_tools_status_short[] = {
    {"model", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 4711, 0, 0, 0,
     NULL, NULL, NULL, NULL, 0},
    {"selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 1, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"flags", "", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status_short, flags), 0, NULL, readings_tools_status_short_flags, NULL,
     NULL, 3},
};
static const struct mip_record record_tools_status_short = {
    parameters_tools_status_short,
    3,
    sizeof(struct mip_tools_status_short),
};

static const struct mip_reading readings_tools_status_long_flags[] = {
    {"model-a", 0, 0, &mip_names_tools_a_faults},
    {"model-b", 0, 0, &mip_names_tools_model_b_faults},
};
static const struct mip_parameter parameters_tools_status_long[] = {
    {"model", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 4711, 0, 0, 0,
     NULL, NULL, NULL, NULL, 0},
    {"selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"flags", "", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status_long, flags), 0, NULL, readings_tools_status_long_flags, NULL,
     NULL, 2},
    {"uptime", "s", MIP_KIND_NUMBER, MIP_SCALAR_U64, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status_long, uptime), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_status_long = {
    parameters_tools_status_long,
    4,
    sizeof(struct mip_tools_status_long),
};

static const struct mip_parameter parameters_tools_status_old[] = {
    {"model", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 4711, 0, 0, 0,
     NULL, NULL, NULL, NULL, 0},
    {"selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"uptime", "s", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_status_old, uptime), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_status_old = {
    parameters_tools_status_old,
    3,
    sizeof(struct mip_tools_status_old),
};

static const struct mip_parameter parameters_tools_full[] = {
    {"model", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 4711, 0, 0, 0,
     NULL, NULL, NULL, NULL, 0},
    {"selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"place", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_full, place), 0, NULL, NULL, &record_point, NULL, 0},
    {"uptime", "s", MIP_KIND_NUMBER, MIP_SCALAR_U64, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_full, uptime), 0, NULL, NULL, NULL, NULL, 0},
    {"mode", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_tools_full, mode), 0, &mip_names_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_full = {
    parameters_tools_full,
    5,
    sizeof(struct mip_tools_full),
};

static const struct mip_parameter parameters_tools_bias_vector[] = {
    {"bias", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_tools_bias_vector, bias), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_tools_bias_vector = {
    parameters_tools_bias_vector,
    1,
    sizeof(struct mip_tools_bias_vector),
};

static const struct mip_parameter parameters_3d_default[] = {
    {"class", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_3d_default, class_), 0, NULL, NULL, NULL, NULL, 0},
    {"type", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_3d_default, type), 0, NULL, NULL, NULL, NULL, 0},
    {"register", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_3d_default, register_), 0, NULL, NULL, NULL, NULL, 0},
    {"self", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_3d_default, self), 0, NULL, NULL, NULL, NULL, 0},
    {"present", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_3d_default, present_), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3d_default = {
    parameters_3d_default,
    5,
    sizeof(struct mip_3d_default),
};

static const struct mip_parameter parameters_measurements_accel[] = {
    {"scaled_accel", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_measurements_accel, scaled_accel), 0, NULL, NULL, NULL, NULL, 0},
    {"valid_flags", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_accel, valid_flags), 0, &mip_names_state_flags, NULL, NULL, NULL,
     0},
};
static const struct mip_record record_measurements_accel = {
    parameters_measurements_accel,
    2,
    sizeof(struct mip_measurements_accel),
};

static const struct mip_parameter parameters_measurements_numbers[] = {
    {"u8", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, u8), 0, NULL, NULL, NULL, NULL, 0},
    {"u16", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, u16), 0, NULL, NULL, NULL, NULL, 0},
    {"u32", "", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, u32), 0, NULL, NULL, NULL, NULL, 0},
    {"u64", "", MIP_KIND_NUMBER, MIP_SCALAR_U64, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, u64), 0, NULL, NULL, NULL, NULL, 0},
    {"s8", "", MIP_KIND_NUMBER, MIP_SCALAR_S8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, s8), 0, NULL, NULL, NULL, NULL, 0},
    {"s16", "", MIP_KIND_NUMBER, MIP_SCALAR_S16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, s16), 0, NULL, NULL, NULL, NULL, 0},
    {"s32", "", MIP_KIND_NUMBER, MIP_SCALAR_S32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, s32), 0, NULL, NULL, NULL, NULL, 0},
    {"s64", "", MIP_KIND_NUMBER, MIP_SCALAR_S64, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, s64), 0, NULL, NULL, NULL, NULL, 0},
    {"float", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, float_), 0, NULL, NULL, NULL, NULL, 0},
    {"double", "1", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, double_), 0, NULL, NULL, NULL, NULL, 0},
    {"bool", "", MIP_KIND_NUMBER, MIP_SCALAR_BOOL, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, bool_), 0, NULL, NULL, NULL, NULL, 0},
    {"char", "", MIP_KIND_NUMBER, MIP_SCALAR_CHAR, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_numbers, char_), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_numbers = {
    parameters_measurements_numbers,
    12,
    sizeof(struct mip_measurements_numbers),
};

static const struct mip_parameter parameters_measurements_strings[] = {
    {"model", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_measurements_strings, model), 0, NULL, NULL, NULL, NULL, 0},
    {"length", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_measurements_strings, length), 0, NULL, NULL, NULL, NULL, 0},
    {"name", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 236, 1, 1, 0, 0,
     MANY(struct mip_measurements_strings, name), 0, NULL, NULL, NULL, NULL, 0},
    {"rest", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_REST, 236, 1, 0, 0, 0,
     MANY(struct mip_measurements_strings, rest),
     offsetof(struct mip_measurements_strings, rest_count), NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_strings = {
    parameters_measurements_strings,
    4,
    sizeof(struct mip_measurements_strings),
};

static const struct mip_parameter parameters_measurements_health[] = {
    {"result", "", MIP_KIND_BITS, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_health, result), 0, &mip_names_health, NULL, NULL, NULL, 0},
    {"code", "", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_health, code), 0, &mip_names_wide_code, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_health = {
    parameters_measurements_health,
    2,
    sizeof(struct mip_measurements_health),
};

static const struct mip_parameter parameters_measurements_arrays[] = {
    {"modes", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 3, 1, 0, 0, 0,
     MANY(struct mip_measurements_arrays, modes), 0, &mip_names_mode, NULL, NULL, NULL, 0},
    {"flags", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_FIXED, 2, 1, 0, 0, 0,
     MANY(struct mip_measurements_arrays, flags), 0, &mip_names_state_flags, NULL, NULL, NULL, 0},
    {"vectors", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_FIXED, 2, 3, 0, 0, 0,
     MANY(struct mip_measurements_arrays, vectors), 0, NULL, NULL, NULL, NULL, 0},
    {"points", "m", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 2, 1, 0, 0, 0,
     MANY(struct mip_measurements_arrays, points), 0, NULL, NULL, &record_point, NULL, 0},
    {"track", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_arrays, track), 0, NULL, NULL, &record_segment, NULL, 0},
    {"offsets", "", MIP_KIND_NUMBER, MIP_SCALAR_S8, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_measurements_arrays, offsets), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_arrays = {
    parameters_measurements_arrays,
    6,
    sizeof(struct mip_measurements_arrays),
};

static const struct mip_parameter parameters_measurements_growing[] = {
    {"first", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_growing, first), 0, NULL, NULL, NULL, NULL, 0},
    {"second", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 2, 0,
     ONE(struct mip_measurements_growing, second), 0, NULL, NULL, NULL, NULL, 0},
    {"third", "deg", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 3, 0,
     ONE(struct mip_measurements_growing, third), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_growing = {
    parameters_measurements_growing,
    3,
    sizeof(struct mip_measurements_growing),
};

static const struct mip_parameter parameters_measurements_radio[] = {
    {"connected", "", MIP_KIND_NUMBER, MIP_SCALAR_BOOL, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_radio, connected), 0, NULL, NULL, NULL, NULL, 0},
    {"strength", "", MIP_KIND_NUMBER, MIP_SCALAR_S32, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_radio, strength), 0, NULL, NULL, NULL, NULL, 0},
    {"noise", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_radio, noise), 0, NULL, NULL, NULL, NULL, 0},
    {"gap", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_radio, gap), 0, NULL, NULL, NULL, NULL, 0},
    {"gaps", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 2, 1, 0, 0, 0,
     MANY(struct mip_measurements_radio, gaps), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_radio = {
    parameters_measurements_radio,
    5,
    sizeof(struct mip_measurements_radio),
};

static const struct mip_parameter parameters_measurements_own[] = {
    {"mode", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_own, mode), 0, &mip_names_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_own = {
    parameters_measurements_own,
    1,
    sizeof(struct mip_measurements_own),
};

static const struct mip_parameter parameters_measurements_cloud[] = {
    {"num_points", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_measurements_cloud, num_points), 0, NULL, NULL, NULL, NULL, 0},
    {"points", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 61, 1, 0, 0, 0,
     MANY(struct mip_measurements_cloud, points), 0, NULL, NULL, &record_point, NULL, 0},
    {"stamp", "s", MIP_KIND_NUMBER, MIP_SCALAR_U64, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_cloud, stamp), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_cloud = {
    parameters_measurements_cloud,
    3,
    sizeof(struct mip_measurements_cloud),
};

static const struct mip_parameter parameters_measurements_gust[] = {
    {"station", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_gust, station), 0, NULL, NULL, NULL, NULL, 0},
    {"place", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_gust, place), 0, NULL, NULL, &record_point, NULL, 0},
    {"height", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_gust, height), 0, NULL, NULL, NULL, NULL, 0},
    {"speed", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_measurements_gust, speed), 0, NULL, NULL, NULL, NULL, 0},
    {"gap", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 7, 0, 0, 0, NULL,
     NULL, NULL, NULL, 0},
    {"valid_flags", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_gust, valid_flags), 0, &mip_names_state_flags, NULL, NULL, NULL,
     0},
};
static const struct mip_record record_measurements_gust = {
    parameters_measurements_gust,
    6,
    sizeof(struct mip_measurements_gust),
};

static const struct mip_parameter parameters_measurements_breeze[] = {
    {"place", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_breeze, place), 0, NULL, NULL, &record_point, NULL, 0},
    {"height", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_measurements_breeze, height), 0, NULL, NULL, NULL, NULL, 0},
    {"turn", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(struct mip_measurements_breeze, turn), 0, NULL, NULL, NULL, NULL, 0},
};
static const struct mip_record record_measurements_breeze = {
    parameters_measurements_breeze,
    3,
    sizeof(struct mip_measurements_breeze),
};

static const struct mip_parameter parameters_shared_timestamp[] = {
    {"tow", "s", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_shared_timestamp, tow), 0, NULL, NULL, NULL, NULL, 0},
    {"valid_flags", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_shared_timestamp, valid_flags), 0, &mip_names_state_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_shared_timestamp = {
    parameters_shared_timestamp,
    2,
    sizeof(struct mip_shared_timestamp),
};

/* --------------------------------------------------------------------------------------- fields */

const struct mip_reflection mip_reflections[] = {
    {&mip_protocol_acknowledge_codec, &record_protocol_acknowledge, false, false, NULL, 0, 0},
    {&mip_tools_ping_codec, &record_tools_ping, false, false, NULL, 0, 0},
    {&mip_tools_settings_codec, &record_tools_settings, true, true, required_tools_settings,
     sizeof(required_tools_settings), offsetof(struct mip_tools_settings, present)},
    {&mip_tools_set_time_codec, &record_tools_set_time, true, true, required_tools_set_time,
     sizeof(required_tools_set_time), offsetof(struct mip_tools_set_time, present)},
    {&mip_tools_status_codec, &record_tools_status, false, false, NULL, 0, 0},
    {&mip_tools_bias_codec, &record_tools_bias, true, true, required_tools_bias,
     sizeof(required_tools_bias), offsetof(struct mip_tools_bias, present)},
    {&mip_tools_capture_bias_codec, &record_tools_capture_bias, false, false, NULL, 0, 0},
    {&mip_tools_formats_codec, &record_tools_formats, false, false, NULL, 0, 0},
    {&mip_tools_choice_codec, &record_tools_choice, true, true, required_tools_choice,
     sizeof(required_tools_choice), offsetof(struct mip_tools_choice, present)},
    {&mip_tools_list_codec, &record_tools_list, true, true, required_tools_list,
     sizeof(required_tools_list), offsetof(struct mip_tools_list, present)},
    {&mip_tools_stock_codec, &record_tools_stock, false, false, NULL, 0, 0},
    {&mip_tools_pin_codec, &record_tools_pin, true, true, required_tools_pin,
     sizeof(required_tools_pin), offsetof(struct mip_tools_pin, present)},
    {&mip_tools_hello_codec, &record_tools_hello, false, true, NULL, 0,
     offsetof(struct mip_tools_hello, present)},
    {&mip_tools_readings_codec, &record_tools_readings, false, false, NULL, 0, 0},
    {&mip_tools_poll_codec, &record_tools_poll, false, false, NULL, 0, 0},
    {&mip_tools_settings_response_codec, &record_tools_settings_response, false, false, NULL, 0, 0},
    {&mip_tools_set_time_fast_response_codec, &record_tools_set_time_fast_response, false, false,
     NULL, 0, 0},
    {&mip_tools_set_time_slow_response_codec, &record_tools_set_time_slow_response, false, false,
     NULL, 0, 0},
    {&mip_tools_choice_response_codec, &record_tools_choice_response, false, false, NULL, 0, 0},
    {&mip_tools_list_response_codec, &record_tools_list_response, false, false, NULL, 0, 0},
    {&mip_tools_stock_response_codec, &record_tools_stock_response, false, false, NULL, 0, 0},
    {&mip_tools_pin_response_codec, &record_tools_pin_response, false, false, NULL, 0, 0},
    {&mip_tools_hello_response_codec, &record_tools_hello_response, false, false, NULL, 0, 0},
    {&mip_tools_readings_response_codec, &record_tools_readings_response, false, false, NULL, 0, 0},
    {&mip_tools_status_paged_codec, &record_tools_status_paged, false, false, NULL, 0, 0},
    {&mip_tools_status_short_codec, &record_tools_status_short, false, false, NULL, 0, 0},
    {&mip_tools_status_long_codec, &record_tools_status_long, false, false, NULL, 0, 0},
    {&mip_tools_status_old_codec, &record_tools_status_old, false, false, NULL, 0, 0},
    {&mip_tools_full_codec, &record_tools_full, false, false, NULL, 0, 0},
    {&mip_tools_bias_vector_codec, &record_tools_bias_vector, false, false, NULL, 0, 0},
    {&mip_3d_default_codec, &record_3d_default, false, false, NULL, 0, 0},
    {&mip_measurements_accel_codec, &record_measurements_accel, false, false, NULL, 0, 0},
    {&mip_measurements_numbers_codec, &record_measurements_numbers, false, false, NULL, 0, 0},
    {&mip_measurements_strings_codec, &record_measurements_strings, false, false, NULL, 0, 0},
    {&mip_measurements_health_codec, &record_measurements_health, false, false, NULL, 0, 0},
    {&mip_measurements_arrays_codec, &record_measurements_arrays, false, false, NULL, 0, 0},
    {&mip_measurements_growing_codec, &record_measurements_growing, false, true, NULL, 0,
     offsetof(struct mip_measurements_growing, present)},
    {&mip_measurements_radio_codec, &record_measurements_radio, false, false, NULL, 0, 0},
    {&mip_measurements_own_codec, &record_measurements_own, false, false, NULL, 0, 0},
    {&mip_measurements_cloud_codec, &record_measurements_cloud, false, false, NULL, 0, 0},
    {&mip_measurements_gust_codec, &record_measurements_gust, false, false, NULL, 0, 0},
    {&mip_measurements_breeze_codec, &record_measurements_breeze, false, false, NULL, 0, 0},
    {&mip_shared_timestamp_codec, &record_shared_timestamp, false, false, NULL, 0, 0},
};
const size_t mip_reflection_count = sizeof(mip_reflections) / sizeof(mip_reflections[0]);
