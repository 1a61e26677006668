

/* The parameters of all fields. */
#include "mip/extra/reflect.h"

#include "mip/extra/names.h"

#include "mip/protocol.h"
#include "mip/base.h"
#include "mip/3dm.h"
#include "mip/filter.h"
#include "mip/gnss.h"
#include "mip/rtk.h"
#include "mip/displacement.h"
#include "mip/aiding.h"
#include "mip/system.h"
#include "mip/sensor.h"
#include "mip/gnss_data.h"
#include "mip/filter_data.h"
#include "mip/displacement_data.h"
#include "mip/system_data.h"
#include "mip/shared.h"

/* The offset of a member, and the size of one item of it. */
#define ONE(record, member) offsetof(record, member), sizeof(((record *)0)->member)
#define MANY(record, member) offsetof(record, member), sizeof(((record *)0)->member[0])

/* A single number; and neither names, nor readings, structures and unions. */
#define NUMBER(scalar) MIP_KIND_NUMBER, MIP_SCALAR_##scalar, MIP_LENGTH_ONE, 1, 1
#define NONE NULL, NULL, NULL, NULL, 0

/* ----------------------------------------------------------------------------------- parameters */

static const struct mip_parameter parameters_event_trigger_gpio[] = {
    {"pin", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_event_trigger_gpio, pin), 0, NONE},
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_event_trigger_gpio, mode), 0,
     &mip_names_event_trigger_gpio_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_event_trigger_gpio = {parameters_event_trigger_gpio, 2,
                                                            sizeof(struct mip_event_trigger_gpio)};

static const struct mip_parameter parameters_event_threshold_window[] = {
    {"low_threshold", "", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_event_threshold_window, low_threshold), 0, NONE},
    {"high_threshold", "", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_event_threshold_window, high_threshold), 0, NONE},
};
static const struct mip_record record_event_threshold_window = {
    parameters_event_threshold_window, 2, sizeof(struct mip_event_threshold_window)};

static const struct mip_parameter parameters_event_threshold_interval[] = {
    {"interval_threshold", "", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_event_threshold_interval, interval_threshold), 0, NONE},
    {"interval", "", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_event_threshold_interval, interval), 0,
     NONE},
};
static const struct mip_record record_event_threshold_interval = {
    parameters_event_threshold_interval, 2, sizeof(struct mip_event_threshold_interval)};

static const struct mip_parameter members_event_trigger_threshold_thresholds[] = {
    {"window", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_event_threshold, window), 0, NULL, NULL, &record_event_threshold_window, NULL,
     0},
    {"interval", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_event_threshold, interval), 0, NULL, NULL, &record_event_threshold_interval,
     NULL, 0},
};
static const struct mip_case cases_event_trigger_threshold_thresholds[] = {
    {1, &members_event_trigger_threshold_thresholds[0]},
    {2, &members_event_trigger_threshold_thresholds[1]},
};
static const struct mip_parameter parameters_event_trigger_threshold[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_event_trigger_threshold, descriptor_set), 0, NONE},
    {"field_descriptor", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_event_trigger_threshold, field_descriptor), 0, NONE},
    {"parameter_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_event_trigger_threshold, parameter_id),
     0, NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_event_trigger_threshold, type), 0,
     &mip_names_event_threshold_type, NULL, NULL, NULL, 0},
    {"thresholds", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_event_trigger_threshold, thresholds), 0, NULL, NULL, NULL,
     cases_event_trigger_threshold_thresholds, 2},
};
static const struct mip_record record_event_trigger_threshold = {
    parameters_event_trigger_threshold, 5, sizeof(struct mip_event_trigger_threshold)};

static const struct mip_parameter parameters_event_trigger_combination[] = {
    {"logic_table", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_event_trigger_combination, logic_table), 0, NONE},
    {"input_triggers", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_event_trigger_combination, input_triggers), 0, NONE},
};
static const struct mip_record record_event_trigger_combination = {
    parameters_event_trigger_combination, 2, sizeof(struct mip_event_trigger_combination)};

static const struct mip_parameter parameters_event_action_gpio[] = {
    {"pin", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_event_action_gpio, pin), 0, NONE},
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_event_action_gpio, mode), 0,
     &mip_names_event_action_gpio_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_event_action_gpio = {parameters_event_action_gpio, 2,
                                                           sizeof(struct mip_event_action_gpio)};

static const struct mip_parameter parameters_event_action_message[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_event_action_message, descriptor_set), 0, NONE},
    {"decimation", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_event_action_message, decimation), 0,
     NONE},
    {"num_fields", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_event_action_message, num_fields), 0, NONE},
    {"descriptors", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, MIP_ROOM(12, 249), 1, 2,
     0, 0, MANY(struct mip_event_action_message, descriptors), 0, NONE},
};
static const struct mip_record record_event_action_message = {
    parameters_event_action_message, 4, sizeof(struct mip_event_action_message)};

static const struct mip_parameter parameters_nmea_message[] = {
    {"message_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_nmea_message, message_id), 0,
     &mip_names_nmea_message_id, NULL, NULL, NULL, 0},
    {"talker_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_nmea_message, talker_id), 0,
     &mip_names_nmea_talker_id, NULL, NULL, NULL, 0},
    {"source_descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_nmea_message, source_descriptor_set), 0, NONE},
    {"decimation", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_nmea_message, decimation), 0, NONE},
};
static const struct mip_record record_nmea_message = {parameters_nmea_message, 4,
                                                      sizeof(struct mip_nmea_message)};

static const struct mip_parameter parameters_descriptor_rate[] = {
    {"descriptor", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_descriptor_rate, descriptor), 0, NONE},
    {"decimation", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_descriptor_rate, decimation), 0, NONE},
};
static const struct mip_record record_descriptor_rate = {parameters_descriptor_rate, 2,
                                                         sizeof(struct mip_descriptor_rate)};

static const struct mip_parameter parameters_base_device_info[] = {
    {"firmware_version", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_base_device_info, firmware_version), 0, NONE},
    {"model_name", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_base_device_info, model_name), 0, NONE},
    {"model_number", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_base_device_info, model_number), 0, NONE},
    {"serial_number", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_base_device_info, serial_number), 0, NONE},
    {"lot_number", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_base_device_info, lot_number), 0, NONE},
    {"device_options", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_base_device_info, device_options), 0, NONE},
};
static const struct mip_record record_base_device_info = {parameters_base_device_info, 6,
                                                          sizeof(struct mip_base_device_info)};

static const struct mip_parameter parameters_3dm_poll_entry[] = {
    {"descriptor", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_poll_entry, descriptor), 0, NONE},
    {"reserved", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_3dm_poll_entry, reserved), 0, NONE},
};
static const struct mip_record record_3dm_poll_entry = {parameters_3dm_poll_entry, 2,
                                                        sizeof(struct mip_3dm_poll_entry)};

static const struct mip_parameter parameters_3dm_constellation_settings_entry[] = {
    {"constellation_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_constellation_settings_entry, constellation_id), 0,
     &mip_names_3dm_constellation_id, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_constellation_settings_entry, enable), 0,
     NONE},
    {"reserved_channels", "1", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_constellation_settings_entry, reserved_channels), 0, NONE},
    {"max_channels", "1", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_constellation_settings_entry, max_channels), 0, NONE},
    {"option_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_constellation_settings_entry, option_flags), 0,
     &mip_names_3dm_constellation_options, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_constellation_settings_entry = {
    parameters_3dm_constellation_settings_entry, 5,
    sizeof(struct mip_3dm_constellation_settings_entry)};

static const struct mip_parameter parameters_3dm_event_support_info[] = {
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_support_info, type), 0, NONE},
    {"count", "1", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_support_info, count), 0, NONE},
};
static const struct mip_record record_3dm_event_support_info = {
    parameters_3dm_event_support_info, 2, sizeof(struct mip_3dm_event_support_info)};

static const struct mip_parameter parameters_3dm_event_trigger_status_entry[] = {
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_trigger_status_entry, type), 0,
     &mip_names_event_trigger_type, NULL, NULL, NULL, 0},
    {"status", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_trigger_status_entry, status), 0,
     &mip_names_event_trigger_status, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_event_trigger_status_entry = {
    parameters_3dm_event_trigger_status_entry, 2,
    sizeof(struct mip_3dm_event_trigger_status_entry)};

static const struct mip_parameter parameters_3dm_event_action_status_entry[] = {
    {"action_type", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_event_action_status_entry, action_type), 0, &mip_names_event_action_type,
     NULL, NULL, NULL, 0},
    {"trigger_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_event_action_status_entry, trigger_id), 0, NONE},
};
static const struct mip_record record_3dm_event_action_status_entry = {
    parameters_3dm_event_action_status_entry, 2, sizeof(struct mip_3dm_event_action_status_entry)};

static const struct mip_parameter parameters_3dm_sensor_range_entry[] = {
    {"setting", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_sensor_range_entry, setting), 0, NONE},
    {"range", "", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_3dm_sensor_range_entry, range), 0, NONE},
};
static const struct mip_record record_3dm_sensor_range_entry = {
    parameters_3dm_sensor_range_entry, 2, sizeof(struct mip_3dm_sensor_range_entry)};

static const struct mip_parameter parameters_gnss_receiver_info_entry[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_receiver_info_entry, receiver_id),
     0, NONE},
    {"mip_data_descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_receiver_info_entry, mip_data_descriptor_set), 0, NONE},
    {"description", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_gnss_receiver_info_entry, description), 0, NONE},
};
static const struct mip_record record_gnss_receiver_info_entry = {
    parameters_gnss_receiver_info_entry, 3, sizeof(struct mip_gnss_receiver_info_entry)};

static const struct mip_parameter parameters_aiding_measurement_time[] = {
    {"timebase", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_measurement_time, timebase), 0,
     &mip_names_aiding_timebase, NULL, NULL, NULL, 0},
    {"reserved", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_measurement_time, reserved), 0,
     NONE},
    {"nanoseconds", "ns", NUMBER(U64), 0, 0, 0,
     ONE(struct mip_aiding_measurement_time, nanoseconds), 0, NONE},
};
static const struct mip_record record_aiding_measurement_time = {
    parameters_aiding_measurement_time, 3, sizeof(struct mip_aiding_measurement_time)};

static const struct mip_parameter parameters_protocol_acknowledge[] = {
    {"command", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_protocol_acknowledge, command), 0, NONE},
    {"code", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_protocol_acknowledge, code), 0,
     &mip_names_ack_code, NULL, NULL, NULL, 0},
};
static const struct mip_record record_protocol_acknowledge = {
    parameters_protocol_acknowledge, 2, sizeof(struct mip_protocol_acknowledge)};

static const struct mip_record record_base_ping = {NULL, 0, sizeof(struct mip_base_ping)};

static const struct mip_record record_base_set_idle = {NULL, 0, sizeof(struct mip_base_set_idle)};

static const struct mip_record record_base_get_device_info = {
    NULL, 0, sizeof(struct mip_base_get_device_info)};

static const struct mip_record record_base_get_device_descriptors = {
    NULL, 0, sizeof(struct mip_base_get_device_descriptors)};

static const struct mip_record record_base_built_in_test = {NULL, 0,
                                                            sizeof(struct mip_base_built_in_test)};

static const struct mip_record record_base_resume = {NULL, 0, sizeof(struct mip_base_resume)};

static const struct mip_record record_base_get_extended_descriptors = {
    NULL, 0, sizeof(struct mip_base_get_extended_descriptors)};

static const struct mip_record record_base_continuous_built_in_test = {
    NULL, 0, sizeof(struct mip_base_continuous_built_in_test)};

static const struct mip_reading readings_base_comm_speed_port[] = {
    {"3dm-cv7-ahrs", 0, 0, &mip_names_comm_interface},
    {"3dm-cv7-ar", 0, 0, &mip_names_comm_interface},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_comm_interface},
    {"3dm-cv7-ins", 0, 0, &mip_names_comm_interface},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_comm_interface},
    {"3dm-cx7-ar", 0, 0, &mip_names_comm_interface},
    {"3dm-cx7-ins", 0, 0, &mip_names_comm_interface},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_comm_interface},
    {"3dm-gv7-ar", 0, 0, &mip_names_comm_interface},
    {"3dm-gv7-ins", 0, 0, &mip_names_comm_interface},
};
static const struct mip_parameter parameters_base_comm_speed[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_base_comm_speed, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"port", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_base_comm_speed, port), 0, NULL,
     readings_base_comm_speed_port, NULL, NULL, 10},
    {"baud", "Bd", NUMBER(U32), 0, 2, 0, ONE(struct mip_base_comm_speed, baud), 0, NONE},
};
static const struct mip_record record_base_comm_speed = {parameters_base_comm_speed, 3,
                                                         sizeof(struct mip_base_comm_speed)};
static const uint8_t required_base_comm_speed[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_base_gps_time_update[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_base_gps_time_update, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"field_id", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_base_gps_time_update, field_id), 0,
     &mip_names_base_gps_time_field, NULL, NULL, NULL, 0},
    {"value", "", NUMBER(U32), 0, 2, 0, ONE(struct mip_base_gps_time_update, value), 0, NONE},
};
static const struct mip_record record_base_gps_time_update = {
    parameters_base_gps_time_update, 3, sizeof(struct mip_base_gps_time_update)};
static const uint8_t required_base_gps_time_update[] = {0, 2, 1, 0, 0, 0, 2};

static const struct mip_record record_base_soft_reset = {NULL, 0,
                                                         sizeof(struct mip_base_soft_reset)};

static const struct mip_parameter parameters_base_get_device_info_response[] = {
    {"device_info", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_base_get_device_info_response, device_info), 0, NULL, NULL,
     &record_base_device_info, NULL, 0},
};
static const struct mip_record record_base_get_device_info_response = {
    parameters_base_get_device_info_response, 1, sizeof(struct mip_base_get_device_info_response)};

static const struct mip_parameter parameters_base_get_device_descriptors_response[] = {
    {"descriptors", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_REST, 126, 1, 0, 0, 0,
     MANY(struct mip_base_get_device_descriptors_response, descriptors),
     offsetof(struct mip_base_get_device_descriptors_response, descriptors_count), NONE},
};
static const struct mip_record record_base_get_device_descriptors_response = {
    parameters_base_get_device_descriptors_response, 1,
    sizeof(struct mip_base_get_device_descriptors_response)};

static const struct mip_reading readings_base_built_in_test_response_result[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-cv5-15", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-cv5-25", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-cv7-ahrs", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-cv7-ar", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-cv7-ins", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-cx5-10", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-cx5-15", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-cx5-25", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-cx7-ar", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-cx7-ins", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-gq7", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-gv7-ar", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-gv7-ins", 0, 0, &mip_names_cv7_built_in_test},
    {"3dm-gx5-15", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-gx5-25", 0, 0, &mip_names_gx5_built_in_test},
    {"3dm-rtk", 0, 0, &mip_names_cv7_built_in_test},
};
static const struct mip_parameter parameters_base_built_in_test_response[] = {
    {"result", "", NUMBER(U32), 0, 0, 0, ONE(struct mip_base_built_in_test_response, result), 0,
     NULL, readings_base_built_in_test_response_result, NULL, NULL, 20},
};
static const struct mip_record record_base_built_in_test_response = {
    parameters_base_built_in_test_response, 1, sizeof(struct mip_base_built_in_test_response)};

static const struct mip_parameter parameters_base_gps_time_update_week_number_response[] = {
    {"week_number", "week", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_base_gps_time_update_week_number_response, week_number), 0, NONE},
};
static const struct mip_record record_base_gps_time_update_week_number_response = {
    parameters_base_gps_time_update_week_number_response, 1,
    sizeof(struct mip_base_gps_time_update_week_number_response)};

static const struct mip_parameter parameters_base_gps_time_update_tow_response[] = {
    {"tow", "s", NUMBER(U32), 0, 0, 0, ONE(struct mip_base_gps_time_update_tow_response, tow), 0,
     NONE},
};
static const struct mip_record record_base_gps_time_update_tow_response = {
    parameters_base_gps_time_update_tow_response, 1,
    sizeof(struct mip_base_gps_time_update_tow_response)};

static const struct mip_parameter parameters_base_get_extended_descriptors_response[] = {
    {"descriptors", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_REST, 126, 1, 0, 0, 0,
     MANY(struct mip_base_get_extended_descriptors_response, descriptors),
     offsetof(struct mip_base_get_extended_descriptors_response, descriptors_count), NONE},
};
static const struct mip_record record_base_get_extended_descriptors_response = {
    parameters_base_get_extended_descriptors_response, 1,
    sizeof(struct mip_base_get_extended_descriptors_response)};

static const struct mip_reading readings_base_continuous_built_in_test_response_result[] = {
    {"3dm-cv7-ahrs", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cv7-ar", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_cv7_continuous_built_in_test},
    {"3dm-cv7-ins", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cx7-ar", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cx7-ins", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-gq7", 0, 0, &mip_names_gq7_continuous_built_in_test},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-gv7-ar", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-gv7-ins", 0, 0, &mip_names_cv7_inertial_bit},
};
static const struct mip_parameter parameters_base_continuous_built_in_test_response[] = {
    {"result", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_base_continuous_built_in_test_response, result), 0, NULL,
     readings_base_continuous_built_in_test_response_result, NULL, NULL, 11},
};
static const struct mip_record record_base_continuous_built_in_test_response = {
    parameters_base_continuous_built_in_test_response, 1,
    sizeof(struct mip_base_continuous_built_in_test_response)};

static const struct mip_reading readings_base_comm_speed_response_port[] = {
    {"3dm-cv7-ahrs", 0, 0, &mip_names_comm_interface},
    {"3dm-cv7-ar", 0, 0, &mip_names_comm_interface},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_comm_interface},
    {"3dm-cv7-ins", 0, 0, &mip_names_comm_interface},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_comm_interface},
    {"3dm-cx7-ar", 0, 0, &mip_names_comm_interface},
    {"3dm-cx7-ins", 0, 0, &mip_names_comm_interface},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_comm_interface},
    {"3dm-gv7-ar", 0, 0, &mip_names_comm_interface},
    {"3dm-gv7-ins", 0, 0, &mip_names_comm_interface},
};
static const struct mip_parameter parameters_base_comm_speed_response[] = {
    {"port", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_base_comm_speed_response, port), 0, NULL,
     readings_base_comm_speed_response_port, NULL, NULL, 10},
    {"baud", "Bd", NUMBER(U32), 0, 0, 0, ONE(struct mip_base_comm_speed_response, baud), 0, NONE},
};
static const struct mip_record record_base_comm_speed_response = {
    parameters_base_comm_speed_response, 2, sizeof(struct mip_base_comm_speed_response)};

static const struct mip_parameter parameters_3dm_poll_imu_data[] = {
    {"suppress_ack", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_poll_imu_data, suppress_ack), 0,
     NONE},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_poll_imu_data, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 0, 0,
     MANY(struct mip_3dm_poll_imu_data, descriptors), 0, NULL, NULL, &record_3dm_poll_entry, NULL,
     0},
};
static const struct mip_record record_3dm_poll_imu_data = {parameters_3dm_poll_imu_data, 3,
                                                           sizeof(struct mip_3dm_poll_imu_data)};

static const struct mip_parameter parameters_3dm_poll_gnss_data[] = {
    {"suppress_ack", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_poll_gnss_data, suppress_ack), 0,
     NONE},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_poll_gnss_data, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 0, 0,
     MANY(struct mip_3dm_poll_gnss_data, descriptors), 0, NULL, NULL, &record_3dm_poll_entry, NULL,
     0},
};
static const struct mip_record record_3dm_poll_gnss_data = {parameters_3dm_poll_gnss_data, 3,
                                                            sizeof(struct mip_3dm_poll_gnss_data)};

static const struct mip_parameter parameters_3dm_poll_filter_data[] = {
    {"suppress_ack", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_poll_filter_data, suppress_ack),
     0, NONE},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_poll_filter_data, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 0, 0,
     MANY(struct mip_3dm_poll_filter_data, descriptors), 0, NULL, NULL, &record_3dm_poll_entry,
     NULL, 0},
};
static const struct mip_record record_3dm_poll_filter_data = {
    parameters_3dm_poll_filter_data, 3, sizeof(struct mip_3dm_poll_filter_data)};

static const struct mip_parameter parameters_3dm_poll_nmea_data[] = {
    {"suppress_ack", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_poll_nmea_data, suppress_ack), 0,
     NONE},
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_poll_nmea_data, count), 0, NONE},
    {"format_entries", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 50, 1, 1, 0, 0,
     MANY(struct mip_3dm_poll_nmea_data, format_entries), 0, NULL, NULL, &record_nmea_message, NULL,
     0},
};
static const struct mip_record record_3dm_poll_nmea_data = {parameters_3dm_poll_nmea_data, 3,
                                                            sizeof(struct mip_3dm_poll_nmea_data)};

static const struct mip_record record_3dm_get_imu_base_rate = {
    NULL, 0, sizeof(struct mip_3dm_get_imu_base_rate)};

static const struct mip_record record_3dm_get_gnss_base_rate = {
    NULL, 0, sizeof(struct mip_3dm_get_gnss_base_rate)};

static const struct mip_parameter parameters_3dm_imu_message_format[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_imu_message_format, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 2, 0,
     ONE(struct mip_3dm_imu_message_format, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 2, 0,
     MANY(struct mip_3dm_imu_message_format, descriptors), 0, NULL, NULL, &record_descriptor_rate,
     NULL, 0},
};
static const struct mip_record record_3dm_imu_message_format = {
    parameters_3dm_imu_message_format, 3, sizeof(struct mip_3dm_imu_message_format)};
static const uint8_t required_3dm_imu_message_format[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_gnss_message_format[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gnss_message_format, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 2, 0,
     ONE(struct mip_3dm_gnss_message_format, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 2, 0,
     MANY(struct mip_3dm_gnss_message_format, descriptors), 0, NULL, NULL, &record_descriptor_rate,
     NULL, 0},
};
static const struct mip_record record_3dm_gnss_message_format = {
    parameters_3dm_gnss_message_format, 3, sizeof(struct mip_3dm_gnss_message_format)};
static const uint8_t required_3dm_gnss_message_format[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_filter_message_format[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_filter_message_format, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 2, 0,
     ONE(struct mip_3dm_filter_message_format, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 2, 0,
     MANY(struct mip_3dm_filter_message_format, descriptors), 0, NULL, NULL,
     &record_descriptor_rate, NULL, 0},
};
static const struct mip_record record_3dm_filter_message_format = {
    parameters_3dm_filter_message_format, 3, sizeof(struct mip_3dm_filter_message_format)};
static const uint8_t required_3dm_filter_message_format[] = {0, 2, 0, 0, 0, 0};

static const struct mip_record record_3dm_get_filter_base_rate = {
    NULL, 0, sizeof(struct mip_3dm_get_filter_base_rate)};

static const struct mip_parameter parameters_3dm_nmea_message_format[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_nmea_message_format, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 2, 0,
     ONE(struct mip_3dm_nmea_message_format, count), 0, NONE},
    {"format_entries", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 50, 1, 1, 2, 0,
     MANY(struct mip_3dm_nmea_message_format, format_entries), 0, NULL, NULL, &record_nmea_message,
     NULL, 0},
};
static const struct mip_record record_3dm_nmea_message_format = {
    parameters_3dm_nmea_message_format, 3, sizeof(struct mip_3dm_nmea_message_format)};
static const uint8_t required_3dm_nmea_message_format[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_poll_data[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_poll_data, descriptor_set), 0,
     NONE},
    {"suppress_ack", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_poll_data, suppress_ack), 0,
     NONE},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_3dm_poll_data, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 250, 1, 2, 0, 0,
     MANY(struct mip_3dm_poll_data, descriptors), 0, NONE},
};
static const struct mip_record record_3dm_poll_data = {parameters_3dm_poll_data, 4,
                                                       sizeof(struct mip_3dm_poll_data)};

static const struct mip_parameter parameters_3dm_get_base_rate[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_get_base_rate, descriptor_set),
     0, NONE},
};
static const struct mip_record record_3dm_get_base_rate = {parameters_3dm_get_base_rate, 1,
                                                           sizeof(struct mip_3dm_get_base_rate)};

static const struct mip_parameter parameters_3dm_message_format[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_message_format, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"descriptor_set", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_message_format, descriptor_set),
     0, NONE},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 3, 0,
     ONE(struct mip_3dm_message_format, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 2, 3, 0,
     MANY(struct mip_3dm_message_format, descriptors), 0, NULL, NULL, &record_descriptor_rate, NULL,
     0},
};
static const struct mip_record record_3dm_message_format = {parameters_3dm_message_format, 4,
                                                            sizeof(struct mip_3dm_message_format)};
static const uint8_t required_3dm_message_format[] = {0, 3, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_factory_streaming[] = {
    {"action", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_factory_streaming, action), 0,
     &mip_names_3dm_factory_streaming_action, NULL, NULL, NULL, 0},
    {"reserved", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_factory_streaming, reserved), 0, NONE},
};
static const struct mip_record record_3dm_factory_streaming = {
    parameters_3dm_factory_streaming, 2, sizeof(struct mip_3dm_factory_streaming)};

static const struct mip_reading readings_3dm_data_stream_control_descriptor_set[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cv5-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cv5-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-10", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-dh3", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gq4-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-35", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-imu", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-35", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-mv5-ar", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-rq1-45-st", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-rq1-imu", 0, 0, &mip_names_3dm_legacy_data_stream},
};
static const struct mip_parameter parameters_3dm_data_stream_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_data_stream_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"descriptor_set", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_3dm_data_stream_control, descriptor_set), 0, NULL,
     readings_3dm_data_stream_control_descriptor_set, NULL, NULL, 25},
    {"enable", "", NUMBER(BOOL), 0, 2, 0, ONE(struct mip_3dm_data_stream_control, enable), 0, NONE},
};
static const struct mip_record record_3dm_data_stream_control = {
    parameters_3dm_data_stream_control, 3, sizeof(struct mip_3dm_data_stream_control)};
static const uint8_t required_3dm_data_stream_control[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_raw_rtcm_2_3_message[] = {
    {"data", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_REST, 253, 1, 0, 0, 0,
     MANY(struct mip_3dm_raw_rtcm_2_3_message, data),
     offsetof(struct mip_3dm_raw_rtcm_2_3_message, data_count), NONE},
};
static const struct mip_record record_3dm_raw_rtcm_2_3_message = {
    parameters_3dm_raw_rtcm_2_3_message, 1, sizeof(struct mip_3dm_raw_rtcm_2_3_message)};

static const struct mip_parameter parameters_3dm_constellation_settings[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_constellation_settings, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"max_channels", "1", NUMBER(U16), 0, 1, 0,
     ONE(struct mip_3dm_constellation_settings, max_channels), 0, NONE},
    {"config_count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 3, 0,
     ONE(struct mip_3dm_constellation_settings, config_count), 0, NONE},
    {"settings", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 41, 1, 2, 3, 0,
     MANY(struct mip_3dm_constellation_settings, settings), 0, NULL, NULL,
     &record_3dm_constellation_settings_entry, NULL, 0},
};
static const struct mip_record record_3dm_constellation_settings = {
    parameters_3dm_constellation_settings, 4, sizeof(struct mip_3dm_constellation_settings)};
static const uint8_t required_3dm_constellation_settings[] = {0, 3, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_gnss_sbas_settings[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gnss_sbas_settings, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable_sbas", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_gnss_sbas_settings, enable_sbas), 0,
     NONE},
    {"sbas_options", "", NUMBER(U16), 0, 2, 0, ONE(struct mip_3dm_gnss_sbas_settings, sbas_options),
     0, &mip_names_3dm_sbas_options, NULL, NULL, NULL, 0},
    {"num_included_prns", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 4, 4, 0,
     ONE(struct mip_3dm_gnss_sbas_settings, num_included_prns), 0, NONE},
    {"included_prns", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_COUNTED, 124, 1, 3, 4, 0,
     MANY(struct mip_3dm_gnss_sbas_settings, included_prns), 0, NONE},
};
static const struct mip_record record_3dm_gnss_sbas_settings = {
    parameters_3dm_gnss_sbas_settings, 5, sizeof(struct mip_3dm_gnss_sbas_settings)};
static const uint8_t required_3dm_gnss_sbas_settings[] = {0, 4, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_gnss_assisted_fix[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gnss_assisted_fix, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"option", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_gnss_assisted_fix, option), 0,
     &mip_names_3dm_assisted_fix_option, NULL, NULL, NULL, 0},
    {"flags", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_gnss_assisted_fix, flags), 0, NONE},
};
static const struct mip_record record_3dm_gnss_assisted_fix = {
    parameters_3dm_gnss_assisted_fix, 3, sizeof(struct mip_3dm_gnss_assisted_fix)};
static const uint8_t required_3dm_gnss_assisted_fix[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_gnss_time_assistance[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gnss_time_assistance, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"tow", "s", NUMBER(DOUBLE), 0, 1, 0, ONE(struct mip_3dm_gnss_time_assistance, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 2, 0,
     ONE(struct mip_3dm_gnss_time_assistance, week_number), 0, NONE},
    {"accuracy", "s", NUMBER(FLOAT), 0, 3, 0, ONE(struct mip_3dm_gnss_time_assistance, accuracy), 0,
     NONE},
};
static const struct mip_record record_3dm_gnss_time_assistance = {
    parameters_3dm_gnss_time_assistance, 4, sizeof(struct mip_3dm_gnss_time_assistance)};
static const uint8_t required_3dm_gnss_time_assistance[] = {0, 3, 0};

static const struct mip_parameter parameters_3dm_pps_source_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_pps_source_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_pps_source_control, source), 0,
     &mip_names_3dm_pps_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_pps_source_control = {
    parameters_3dm_pps_source_control, 2, sizeof(struct mip_3dm_pps_source_control)};
static const uint8_t required_3dm_pps_source_control[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_get_event_support[] = {
    {"query", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_get_event_support, query), 0,
     &mip_names_3dm_event_support_query, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_get_event_support = {
    parameters_3dm_get_event_support, 1, sizeof(struct mip_3dm_get_event_support)};

static const struct mip_parameter parameters_3dm_event_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"instance", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_event_control, instance), 0, NONE},
    {"mode", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_event_control, mode), 0,
     &mip_names_event_trigger_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_event_control = {parameters_3dm_event_control, 3,
                                                           sizeof(struct mip_3dm_event_control)};
static const uint8_t required_3dm_event_control[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_get_event_trigger_status[] = {
    {"requested_count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_get_event_trigger_status, requested_count), 0, NONE},
    {"requested_instances", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 252, 1, 0, 0, 0,
     MANY(struct mip_3dm_get_event_trigger_status, requested_instances), 0, NONE},
};
static const struct mip_record record_3dm_get_event_trigger_status = {
    parameters_3dm_get_event_trigger_status, 2, sizeof(struct mip_3dm_get_event_trigger_status)};

static const struct mip_parameter parameters_3dm_get_event_action_status[] = {
    {"requested_count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_get_event_action_status, requested_count), 0, NONE},
    {"requested_instances", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 252, 1, 0, 0, 0,
     MANY(struct mip_3dm_get_event_action_status, requested_instances), 0, NONE},
};
static const struct mip_record record_3dm_get_event_action_status = {
    parameters_3dm_get_event_action_status, 2, sizeof(struct mip_3dm_get_event_action_status)};

static const struct mip_parameter members_3dm_event_trigger_config_parameters[] = {
    {"gpio", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_trigger_config_parameters, gpio), 0, NULL, NULL,
     &record_event_trigger_gpio, NULL, 0},
    {"threshold", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_trigger_config_parameters, threshold), 0, NULL, NULL,
     &record_event_trigger_threshold, NULL, 0},
    {"combination", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_trigger_config_parameters, combination), 0, NULL, NULL,
     &record_event_trigger_combination, NULL, 0},
};
static const struct mip_case cases_3dm_event_trigger_config_parameters[] = {
    {0, NULL},
    {1, &members_3dm_event_trigger_config_parameters[0]},
    {2, &members_3dm_event_trigger_config_parameters[1]},
    {3, &members_3dm_event_trigger_config_parameters[2]},
};
static const struct mip_parameter parameters_3dm_event_trigger_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_trigger_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"instance", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_event_trigger_config, instance), 0,
     NONE},
    {"type", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_event_trigger_config, type), 0,
     &mip_names_event_trigger_type, NULL, NULL, NULL, 0},
    {"parameters", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 3, 0,
     ONE(struct mip_3dm_event_trigger_config, parameters), 0, NULL, NULL, NULL,
     cases_3dm_event_trigger_config_parameters, 4},
};
static const struct mip_record record_3dm_event_trigger_config = {
    parameters_3dm_event_trigger_config, 4, sizeof(struct mip_3dm_event_trigger_config)};
static const uint8_t required_3dm_event_trigger_config[] = {0, 3, 1, 1, 1, 1};

static const struct mip_parameter members_3dm_event_action_config_parameters[] = {
    {"gpio", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_action_config_parameters, gpio), 0, NULL, NULL,
     &record_event_action_gpio, NULL, 0},
    {"message", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_action_config_parameters, message), 0, NULL, NULL,
     &record_event_action_message, NULL, 0},
};
static const struct mip_case cases_3dm_event_action_config_parameters[] = {
    {0, NULL},
    {1, &members_3dm_event_action_config_parameters[0]},
    {2, &members_3dm_event_action_config_parameters[1]},
};
static const struct mip_parameter parameters_3dm_event_action_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_action_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"instance", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_event_action_config, instance), 0,
     NONE},
    {"trigger", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_event_action_config, trigger), 0, NONE},
    {"type", "", NUMBER(U8), 0, 3, 0, ONE(struct mip_3dm_event_action_config, type), 0,
     &mip_names_event_action_type, NULL, NULL, NULL, 0},
    {"parameters", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 4, 0,
     ONE(struct mip_3dm_event_action_config, parameters), 0, NULL, NULL, NULL,
     cases_3dm_event_action_config_parameters, 3},
};
static const struct mip_record record_3dm_event_action_config = {
    parameters_3dm_event_action_config, 5, sizeof(struct mip_3dm_event_action_config)};
static const uint8_t required_3dm_event_action_config[] = {0, 4, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_device_settings[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_device_settings, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_device_settings = {
    parameters_3dm_device_settings, 1, sizeof(struct mip_3dm_device_settings)};
static const uint8_t required_3dm_device_settings[] = {0, 0, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_sensor_to_vehicle_transform_euler[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"roll", "rad", NUMBER(FLOAT), 0, 1, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler, roll), 0, NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler, pitch), 0, NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 3, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler, yaw), 0, NONE},
};
static const struct mip_record record_3dm_sensor_to_vehicle_transform_euler = {
    parameters_3dm_sensor_to_vehicle_transform_euler, 4,
    sizeof(struct mip_3dm_sensor_to_vehicle_transform_euler)};
static const uint8_t required_3dm_sensor_to_vehicle_transform_euler[] = {0, 3, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_sensor_to_vehicle_transform_quaternion[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_quaternion, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 1, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_quaternion, q), 0, NONE},
};
static const struct mip_record record_3dm_sensor_to_vehicle_transform_quaternion = {
    parameters_3dm_sensor_to_vehicle_transform_quaternion, 2,
    sizeof(struct mip_3dm_sensor_to_vehicle_transform_quaternion)};
static const uint8_t required_3dm_sensor_to_vehicle_transform_quaternion[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_sensor_to_vehicle_transform_dcm[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_dcm, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"dcm", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 1, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_dcm, dcm), 0, NONE},
};
static const struct mip_record record_3dm_sensor_to_vehicle_transform_dcm = {
    parameters_3dm_sensor_to_vehicle_transform_dcm, 2,
    sizeof(struct mip_3dm_sensor_to_vehicle_transform_dcm)};
static const uint8_t required_3dm_sensor_to_vehicle_transform_dcm[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_gps_dynamics_mode[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gps_dynamics_mode, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"mode", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_gps_dynamics_mode, mode), 0,
     &mip_names_3dm_receiver_dynamics, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_gps_dynamics_mode = {
    parameters_3dm_gps_dynamics_mode, 2, sizeof(struct mip_3dm_gps_dynamics_mode)};
static const uint8_t required_3dm_gps_dynamics_mode[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_imu_signal_conditioning[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_imu_signal_conditioning, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"orientation_decimation", "1", NUMBER(U16), 0, 1, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, orientation_decimation), 0, NONE},
    {"data_conditioning_flags", "", NUMBER(U16), 0, 2, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, data_conditioning_flags), 0,
     &mip_names_3dm_data_conditioning_flags, NULL, NULL, NULL, 0},
    {"inertial_filter_width", "1", NUMBER(U8), 0, 3, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, inertial_filter_width), 0, NONE},
    {"mag_filter_width", "1", NUMBER(U8), 0, 4, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, mag_filter_width), 0, NONE},
    {"up_compensation", "s", NUMBER(U16), 0, 5, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, up_compensation), 0, NONE},
    {"north_compensation", "s", NUMBER(U16), 0, 6, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, north_compensation), 0, NONE},
    {"mag_bandwidth", "", NUMBER(U8), 0, 7, 0,
     ONE(struct mip_3dm_imu_signal_conditioning, mag_bandwidth), 0, &mip_names_3dm_mag_bandwidth,
     NULL, NULL, NULL, 0},
    {"reserved", "", NUMBER(U16), 0, 8, 0, ONE(struct mip_3dm_imu_signal_conditioning, reserved), 0,
     NONE},
};
static const struct mip_record record_3dm_imu_signal_conditioning = {
    parameters_3dm_imu_signal_conditioning, 9, sizeof(struct mip_3dm_imu_signal_conditioning)};
static const uint8_t required_3dm_imu_signal_conditioning[] = {0, 8, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_imu_timestamp[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_imu_timestamp, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"selector", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_imu_timestamp, selector), 0,
     &mip_names_3dm_imu_timestamp_selector, NULL, NULL, NULL, 0},
    {"time", "", NUMBER(U32), 0, 2, 0, ONE(struct mip_3dm_imu_timestamp, time), 0, NONE},
};
static const struct mip_record record_3dm_imu_timestamp = {parameters_3dm_imu_timestamp, 3,
                                                           sizeof(struct mip_3dm_imu_timestamp)};
static const uint8_t required_3dm_imu_timestamp[] = {0, 2, 1};

static const struct mip_parameter parameters_3dm_accel_bias[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_accel_bias, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"bias", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_3dm_accel_bias, bias), 0, NONE},
};
static const struct mip_record record_3dm_accel_bias = {parameters_3dm_accel_bias, 2,
                                                        sizeof(struct mip_3dm_accel_bias)};
static const uint8_t required_3dm_accel_bias[] = {0, 1, 0, 0, 0, 0, 1};

static const struct mip_parameter parameters_3dm_gyro_bias[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gyro_bias, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"bias", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_3dm_gyro_bias, bias), 0, NONE},
};
static const struct mip_record record_3dm_gyro_bias = {parameters_3dm_gyro_bias, 2,
                                                       sizeof(struct mip_3dm_gyro_bias)};
static const uint8_t required_3dm_gyro_bias[] = {0, 1, 0, 0, 0, 0, 1};

static const struct mip_parameter parameters_3dm_capture_gyro_bias[] = {
    {"averaging_time_ms", "ms", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_capture_gyro_bias, averaging_time_ms), 0, NONE},
};
static const struct mip_record record_3dm_capture_gyro_bias = {
    parameters_3dm_capture_gyro_bias, 1, sizeof(struct mip_3dm_capture_gyro_bias)};

static const struct mip_parameter parameters_3dm_mag_hard_iron_offset[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_mag_hard_iron_offset, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"offset", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_3dm_mag_hard_iron_offset, offset), 0, NONE},
};
static const struct mip_record record_3dm_mag_hard_iron_offset = {
    parameters_3dm_mag_hard_iron_offset, 2, sizeof(struct mip_3dm_mag_hard_iron_offset)};
static const uint8_t required_3dm_mag_hard_iron_offset[] = {0, 1, 0, 0, 0, 0, 1};

static const struct mip_parameter parameters_3dm_mag_soft_iron_matrix[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_mag_soft_iron_matrix, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"matrix", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 1, 0,
     ONE(struct mip_3dm_mag_soft_iron_matrix, matrix), 0, NONE},
};
static const struct mip_record record_3dm_mag_soft_iron_matrix = {
    parameters_3dm_mag_soft_iron_matrix, 2, sizeof(struct mip_3dm_mag_soft_iron_matrix)};
static const uint8_t required_3dm_mag_soft_iron_matrix[] = {0, 1, 0, 0, 0, 0, 1};

static const struct mip_parameter parameters_3dm_coning_sculling_enable[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_coning_sculling_enable, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(BOOL), 0, 1, 0, ONE(struct mip_3dm_coning_sculling_enable, enable), 0,
     NONE},
};
static const struct mip_record record_3dm_coning_sculling_enable = {
    parameters_3dm_coning_sculling_enable, 2, sizeof(struct mip_3dm_coning_sculling_enable)};
static const uint8_t required_3dm_coning_sculling_enable[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_uart_baud_rate[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_uart_baud_rate, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"baud", "Bd", NUMBER(U32), 0, 1, 0, ONE(struct mip_3dm_uart_baud_rate, baud), 0, NONE},
};
static const struct mip_record record_3dm_uart_baud_rate = {parameters_3dm_uart_baud_rate, 2,
                                                            sizeof(struct mip_3dm_uart_baud_rate)};
static const uint8_t required_3dm_uart_baud_rate[] = {0, 1, 0, 0, 0, 0};

static const struct mip_reading readings_3dm_gpio_config_behavior[] = {
    {NULL, 2, 0, &mip_names_gpio_unused_behavior},
    {NULL, 2, 1, &mip_names_gpio_behavior},
    {NULL, 2, 2, &mip_names_gpio_pps_behavior},
    {NULL, 2, 3, &mip_names_gpio_encoder_behavior},
    {NULL, 2, 4, &mip_names_gpio_timestamp_behavior},
    {NULL, 2, 5, &mip_names_gpio_uart_behavior},
};
static const struct mip_parameter parameters_3dm_gpio_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"pin", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_gpio_config, pin), 0, NONE},
    {"feature", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_gpio_config, feature), 0,
     &mip_names_gpio_feature, NULL, NULL, NULL, 0},
    {"behavior", "", NUMBER(U8), 0, 3, 0, ONE(struct mip_3dm_gpio_config, behavior), 0, NULL,
     readings_3dm_gpio_config_behavior, NULL, NULL, 6},
    {"pin_mode", "", NUMBER(U8), 0, 4, 0, ONE(struct mip_3dm_gpio_config, pin_mode), 0,
     &mip_names_gpio_pin_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_gpio_config = {parameters_3dm_gpio_config, 5,
                                                         sizeof(struct mip_3dm_gpio_config)};
static const uint8_t required_3dm_gpio_config[] = {0, 4, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_gpio_state[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_state, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"pin", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_gpio_state, pin), 0, NONE},
    {"state", "", NUMBER(BOOL), 0, 2, 0, ONE(struct mip_3dm_gpio_state, state), 0, NONE},
};
static const struct mip_record record_3dm_gpio_state = {parameters_3dm_gpio_state, 3,
                                                        sizeof(struct mip_3dm_gpio_state)};
static const uint8_t required_3dm_gpio_state[] = {0, 2, 1};

static const struct mip_parameter parameters_3dm_odometer_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_odometer_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"mode", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_odometer_config, mode), 0,
     &mip_names_3dm_odometer_mode, NULL, NULL, NULL, 0},
    {"scaling", "pulse/m", NUMBER(FLOAT), 0, 2, 0, ONE(struct mip_3dm_odometer_config, scaling), 0,
     NONE},
    {"uncertainty", "1", NUMBER(FLOAT), 0, 3, 0, ONE(struct mip_3dm_odometer_config, uncertainty),
     0, NONE},
};
static const struct mip_record record_3dm_odometer_config = {
    parameters_3dm_odometer_config, 4, sizeof(struct mip_3dm_odometer_config)};
static const uint8_t required_3dm_odometer_config[] = {0, 3, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_imu_low_pass_filter[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_imu_low_pass_filter, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"target_descriptor", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_3dm_imu_low_pass_filter, target_descriptor), 0, NONE},
    {"enable", "", NUMBER(BOOL), 0, 2, 0, ONE(struct mip_3dm_imu_low_pass_filter, enable), 0, NONE},
    {"manual", "", NUMBER(BOOL), 0, 3, 0, ONE(struct mip_3dm_imu_low_pass_filter, manual), 0, NONE},
    {"frequency", "Hz", NUMBER(U16), 0, 4, 0, ONE(struct mip_3dm_imu_low_pass_filter, frequency), 0,
     NONE},
    {"reserved", "", NUMBER(U8), 0, 5, 0, ONE(struct mip_3dm_imu_low_pass_filter, reserved), 0,
     NONE},
};
static const struct mip_record record_3dm_imu_low_pass_filter = {
    parameters_3dm_imu_low_pass_filter, 6, sizeof(struct mip_3dm_imu_low_pass_filter)};
static const uint8_t required_3dm_imu_low_pass_filter[] = {0, 5, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_complementary_filter[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_complementary_filter, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"pitch_roll_enable", "", NUMBER(BOOL), 0, 1, 0,
     ONE(struct mip_3dm_complementary_filter, pitch_roll_enable), 0, NONE},
    {"heading_enable", "", NUMBER(BOOL), 0, 2, 0,
     ONE(struct mip_3dm_complementary_filter, heading_enable), 0, NONE},
    {"pitch_roll_time_constant", "s", NUMBER(FLOAT), 0, 3, 0,
     ONE(struct mip_3dm_complementary_filter, pitch_roll_time_constant), 0, NONE},
    {"heading_time_constant", "s", NUMBER(FLOAT), 0, 4, 0,
     ONE(struct mip_3dm_complementary_filter, heading_time_constant), 0, NONE},
};
static const struct mip_record record_3dm_complementary_filter = {
    parameters_3dm_complementary_filter, 5, sizeof(struct mip_3dm_complementary_filter)};
static const uint8_t required_3dm_complementary_filter[] = {0, 4, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_sensor_range[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_sensor_range, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"sensor", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_sensor_range, sensor), 0,
     &mip_names_3dm_sensor_range_type, NULL, NULL, NULL, 0},
    {"setting", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_sensor_range, setting), 0, NONE},
};
static const struct mip_record record_3dm_sensor_range = {parameters_3dm_sensor_range, 3,
                                                          sizeof(struct mip_3dm_sensor_range)};
static const uint8_t required_3dm_sensor_range[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_get_calibrated_sensor_ranges[] = {
    {"sensor", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_get_calibrated_sensor_ranges, sensor), 0,
     &mip_names_3dm_sensor_range_type, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_get_calibrated_sensor_ranges = {
    parameters_3dm_get_calibrated_sensor_ranges, 1,
    sizeof(struct mip_3dm_get_calibrated_sensor_ranges)};

static const struct mip_parameter parameters_3dm_low_pass_filter[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_low_pass_filter, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"descriptor_set", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_low_pass_filter, descriptor_set),
     0, NONE},
    {"field_descriptor", "", NUMBER(U8), 0, 2, 0,
     ONE(struct mip_3dm_low_pass_filter, field_descriptor), 0, NONE},
    {"enable", "", NUMBER(BOOL), 0, 3, 0, ONE(struct mip_3dm_low_pass_filter, enable), 0, NONE},
    {"manual", "", NUMBER(BOOL), 0, 4, 0, ONE(struct mip_3dm_low_pass_filter, manual), 0, NONE},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 5, 0, ONE(struct mip_3dm_low_pass_filter, frequency), 0,
     NONE},
};
static const struct mip_record record_3dm_low_pass_filter = {
    parameters_3dm_low_pass_filter, 6, sizeof(struct mip_3dm_low_pass_filter)};
static const uint8_t required_3dm_low_pass_filter[] = {0, 5, 2, 2, 2, 2};

static const struct mip_parameter parameters_3dm_data_stream_format[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_data_stream_format, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"stream", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_data_stream_format, stream), 0,
     &mip_names_3dm_internal_sensor, NULL, NULL, NULL, 0},
    {"format", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_data_stream_format, format), 0,
     &mip_names_3dm_stream_format, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_data_stream_format = {
    parameters_3dm_data_stream_format, 3, sizeof(struct mip_3dm_data_stream_format)};
static const uint8_t required_3dm_data_stream_format[] = {0, 2, 2, 2, 2, 2};

static const struct mip_parameter parameters_3dm_device_power_state[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_device_power_state, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"device", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_3dm_device_power_state, device), 0,
     &mip_names_3dm_internal_sensor, NULL, NULL, NULL, 0},
    {"state", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_3dm_device_power_state, state), 0,
     &mip_names_3dm_sensor_power_state, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_device_power_state = {
    parameters_3dm_device_power_state, 3, sizeof(struct mip_3dm_device_power_state)};
static const uint8_t required_3dm_device_power_state[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_3dm_gps_advanced_settings[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gps_advanced_settings, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_gps_advanced_settings = {
    parameters_3dm_gps_advanced_settings, 1, sizeof(struct mip_3dm_gps_advanced_settings)};
static const uint8_t required_3dm_gps_advanced_settings[] = {0, 0, 0, 0, 0, 0};

static const struct mip_parameter parameters_3dm_device_status[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_3dm_device_status, model_number), 0,
     NONE},
    {"status_selector", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_device_status, status_selector),
     0, &mip_names_3dm_device_status_selector, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_device_status = {parameters_3dm_device_status, 2,
                                                           sizeof(struct mip_3dm_device_status)};

static const struct mip_parameter parameters_3dm_imu_message_format_response[] = {
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_imu_message_format_response, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 84, 1, 0, 0, 0,
     MANY(struct mip_3dm_imu_message_format_response, descriptors), 0, NULL, NULL,
     &record_descriptor_rate, NULL, 0},
};
static const struct mip_record record_3dm_imu_message_format_response = {
    parameters_3dm_imu_message_format_response, 2,
    sizeof(struct mip_3dm_imu_message_format_response)};

static const struct mip_parameter parameters_3dm_gnss_message_format_response[] = {
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_gnss_message_format_response, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 84, 1, 0, 0, 0,
     MANY(struct mip_3dm_gnss_message_format_response, descriptors), 0, NULL, NULL,
     &record_descriptor_rate, NULL, 0},
};
static const struct mip_record record_3dm_gnss_message_format_response = {
    parameters_3dm_gnss_message_format_response, 2,
    sizeof(struct mip_3dm_gnss_message_format_response)};

static const struct mip_parameter parameters_3dm_filter_message_format_response[] = {
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_filter_message_format_response, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 84, 1, 0, 0, 0,
     MANY(struct mip_3dm_filter_message_format_response, descriptors), 0, NULL, NULL,
     &record_descriptor_rate, NULL, 0},
};
static const struct mip_record record_3dm_filter_message_format_response = {
    parameters_3dm_filter_message_format_response, 2,
    sizeof(struct mip_3dm_filter_message_format_response)};

static const struct mip_parameter parameters_3dm_get_imu_base_rate_response[] = {
    {"rate", "Hz", NUMBER(U16), 0, 0, 0, ONE(struct mip_3dm_get_imu_base_rate_response, rate), 0,
     NONE},
};
static const struct mip_record record_3dm_get_imu_base_rate_response = {
    parameters_3dm_get_imu_base_rate_response, 1,
    sizeof(struct mip_3dm_get_imu_base_rate_response)};

static const struct mip_parameter parameters_3dm_get_gnss_base_rate_response[] = {
    {"rate", "Hz", NUMBER(U16), 0, 0, 0, ONE(struct mip_3dm_get_gnss_base_rate_response, rate), 0,
     NONE},
};
static const struct mip_record record_3dm_get_gnss_base_rate_response = {
    parameters_3dm_get_gnss_base_rate_response, 1,
    sizeof(struct mip_3dm_get_gnss_base_rate_response)};

static const struct mip_reading readings_3dm_data_stream_control_response_descriptor_set[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cv5-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cv5-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-10", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-cx5-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-dh3", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gq4-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-35", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx3-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx4-imu", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-15", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-25", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-35", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-gx5-45", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-mv5-ar", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-rq1-45-st", 0, 0, &mip_names_3dm_legacy_data_stream},
    {"3dm-rq1-imu", 0, 0, &mip_names_3dm_legacy_data_stream},
};
static const struct mip_parameter parameters_3dm_data_stream_control_response[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_data_stream_control_response, descriptor_set), 0, NULL,
     readings_3dm_data_stream_control_response_descriptor_set, NULL, NULL, 25},
    {"enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_data_stream_control_response, enabled), 0, NONE},
};
static const struct mip_record record_3dm_data_stream_control_response = {
    parameters_3dm_data_stream_control_response, 2,
    sizeof(struct mip_3dm_data_stream_control_response)};

static const struct mip_parameter parameters_3dm_imu_signal_conditioning_response[] = {
    {"orientation_decimation", "1", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, orientation_decimation), 0, NONE},
    {"data_conditioning_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, data_conditioning_flags), 0,
     &mip_names_3dm_data_conditioning_flags, NULL, NULL, NULL, 0},
    {"inertial_filter_width", "1", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, inertial_filter_width), 0, NONE},
    {"mag_filter_width", "1", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, mag_filter_width), 0, NONE},
    {"up_compensation", "s", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, up_compensation), 0, NONE},
    {"north_compensation", "s", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, north_compensation), 0, NONE},
    {"mag_bandwidth", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, mag_bandwidth), 0,
     &mip_names_3dm_mag_bandwidth, NULL, NULL, NULL, 0},
    {"reserved", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_imu_signal_conditioning_response, reserved), 0, NONE},
};
static const struct mip_record record_3dm_imu_signal_conditioning_response = {
    parameters_3dm_imu_signal_conditioning_response, 8,
    sizeof(struct mip_3dm_imu_signal_conditioning_response)};

static const struct mip_parameter parameters_3dm_uart_baud_rate_response[] = {
    {"baud", "Bd", NUMBER(U32), 0, 0, 0, ONE(struct mip_3dm_uart_baud_rate_response, baud), 0,
     NONE},
};
static const struct mip_record record_3dm_uart_baud_rate_response = {
    parameters_3dm_uart_baud_rate_response, 1, sizeof(struct mip_3dm_uart_baud_rate_response)};

static const struct mip_parameter parameters_3dm_data_stream_format_response[] = {
    {"stream", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_data_stream_format_response, stream), 0,
     &mip_names_3dm_internal_sensor, NULL, NULL, NULL, 0},
    {"format", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_data_stream_format_response, format), 0,
     &mip_names_3dm_stream_format, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_data_stream_format_response = {
    parameters_3dm_data_stream_format_response, 2,
    sizeof(struct mip_3dm_data_stream_format_response)};

static const struct mip_parameter parameters_3dm_device_power_state_response[] = {
    {"device", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_device_power_state_response, device), 0,
     &mip_names_3dm_internal_sensor, NULL, NULL, NULL, 0},
    {"state", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_device_power_state_response, state), 0,
     &mip_names_3dm_sensor_power_state, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_device_power_state_response = {
    parameters_3dm_device_power_state_response, 2,
    sizeof(struct mip_3dm_device_power_state_response)};

static const struct mip_parameter parameters_3dm_get_filter_base_rate_response[] = {
    {"rate", "Hz", NUMBER(U16), 0, 0, 0, ONE(struct mip_3dm_get_filter_base_rate_response, rate), 0,
     NONE},
};
static const struct mip_record record_3dm_get_filter_base_rate_response = {
    parameters_3dm_get_filter_base_rate_response, 1,
    sizeof(struct mip_3dm_get_filter_base_rate_response)};

static const struct mip_parameter parameters_3dm_imu_low_pass_filter_response[] = {
    {"target_descriptor", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_imu_low_pass_filter_response, target_descriptor), 0, NONE},
    {"enable", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_imu_low_pass_filter_response, enable),
     0, NONE},
    {"manual", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_imu_low_pass_filter_response, manual),
     0, NONE},
    {"frequency", "Hz", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_imu_low_pass_filter_response, frequency), 0, NONE},
    {"reserved", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_imu_low_pass_filter_response, reserved), 0, NONE},
};
static const struct mip_record record_3dm_imu_low_pass_filter_response = {
    parameters_3dm_imu_low_pass_filter_response, 5,
    sizeof(struct mip_3dm_imu_low_pass_filter_response)};

static const struct mip_parameter parameters_3dm_nmea_message_format_response[] = {
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_nmea_message_format_response, count), 0, NONE},
    {"format_entries", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 50, 1, 0, 0, 0,
     MANY(struct mip_3dm_nmea_message_format_response, format_entries), 0, NULL, NULL,
     &record_nmea_message, NULL, 0},
};
static const struct mip_record record_3dm_nmea_message_format_response = {
    parameters_3dm_nmea_message_format_response, 2,
    sizeof(struct mip_3dm_nmea_message_format_response)};

static const struct mip_parameter parameters_3dm_get_base_rate_response[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_get_base_rate_response, descriptor_set), 0, NONE},
    {"rate", "Hz", NUMBER(U16), 0, 0, 0, ONE(struct mip_3dm_get_base_rate_response, rate), 0, NONE},
};
static const struct mip_record record_3dm_get_base_rate_response = {
    parameters_3dm_get_base_rate_response, 2, sizeof(struct mip_3dm_get_base_rate_response)};

static const struct mip_parameter parameters_3dm_message_format_response[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_message_format_response, descriptor_set), 0, NONE},
    {"num_descriptors", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_message_format_response, num_descriptors), 0, NONE},
    {"descriptors", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 83, 1, 1, 0, 0,
     MANY(struct mip_3dm_message_format_response, descriptors), 0, NULL, NULL,
     &record_descriptor_rate, NULL, 0},
};
static const struct mip_record record_3dm_message_format_response = {
    parameters_3dm_message_format_response, 3, sizeof(struct mip_3dm_message_format_response)};

static const struct mip_parameter parameters_3dm_device_status_basic_rq1_imu_response[] = {
    {"model_number", "", MIP_KIND_CONSTANT, MIP_SCALAR_U16, MIP_LENGTH_ONE, 1, 1, 0, 0, 6238, 0, 0,
     0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 1, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_rq1_imu_response, status_flags), 0, NONE},
    {"system_timer", "us", NUMBER(U64), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_rq1_imu_response, system_timer), 0, NONE},
};
static const struct mip_record record_3dm_device_status_basic_rq1_imu_response = {
    parameters_3dm_device_status_basic_rq1_imu_response, 4,
    sizeof(struct mip_3dm_device_status_basic_rq1_imu_response)};

static const struct mip_reading readings_3dm_device_status_basic_response_system_state[] = {
    {"3dm-gx4-45", 0, 0, &mip_names_3dm_gx4_system_state},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_3dm_gx4_system_state},
    {"3dm-rq1-45-st", 0, 0, &mip_names_3dm_gx4_system_state},
};
static const struct mip_parameter parameters_3dm_device_status_basic_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 1, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_response, status_flags), 0, NONE},
    {"system_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_response, system_state), 0, NULL,
     readings_3dm_device_status_basic_response_system_state, NULL, NULL, 3},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_response, system_timer), 0, NONE},
};
static const struct mip_record record_3dm_device_status_basic_response = {
    parameters_3dm_device_status_basic_response, 5,
    sizeof(struct mip_3dm_device_status_basic_response)};

static const struct mip_parameter parameters_3dm_device_status_basic_without_state_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_without_state_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 1, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_without_state_response, status_flags), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_without_state_response, system_timer), 0, NONE},
};
static const struct mip_record record_3dm_device_status_basic_without_state_response = {
    parameters_3dm_device_status_basic_without_state_response, 4,
    sizeof(struct mip_3dm_device_status_basic_without_state_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, status_flags), 0, NONE},
    {"system_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, system_state), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, system_timer), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, imu_stream_enabled), 0, NONE},
    {"filter_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, filter_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, imu_dropped_packets), 0, NONE},
    {"filter_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, filter_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, comm_port_bytes_written), 0, NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, comm_port_write_overruns), 0, NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, comm_port_read_overruns), 0, NONE},
    {"imu_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, imu_parser_errors), 0, NONE},
    {"imu_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, imu_message_count), 0, NONE},
    {"imu_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_response, imu_last_message_time), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_response = {
    parameters_3dm_device_status_diagnostic_response, 16,
    sizeof(struct mip_3dm_device_status_diagnostic_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_gnss_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, status_flags), 0, NONE},
    {"system_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, system_state), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, system_timer), 0, NONE},
    {"gnss_power_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_power_state), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, imu_stream_enabled), 0, NONE},
    {"gnss_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_stream_enabled), 0, NONE},
    {"filter_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, filter_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, imu_dropped_packets), 0, NONE},
    {"gnss_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_dropped_packets), 0, NONE},
    {"filter_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, filter_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, comm_port_bytes_written), 0, NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, comm_port_write_overruns), 0, NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, comm_port_read_overruns), 0, NONE},
    {"imu_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, imu_parser_errors), 0, NONE},
    {"imu_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, imu_message_count), 0, NONE},
    {"imu_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, imu_last_message_time), 0, NONE},
    {"gnss_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_parser_errors), 0, NONE},
    {"gnss_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_message_count), 0, NONE},
    {"gnss_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gnss_response, gnss_last_message_time), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_gnss_response = {
    parameters_3dm_device_status_diagnostic_gnss_response, 24,
    sizeof(struct mip_3dm_device_status_diagnostic_gnss_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_gq4_45_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, status_flags), 0, NONE},
    {"system_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, system_state), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, system_timer), 0, NONE},
    {"gnss_power_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_power_state), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, imu_stream_enabled), 0, NONE},
    {"gnss_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_stream_enabled), 0, NONE},
    {"filter_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, filter_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, imu_dropped_packets), 0, NONE},
    {"gnss_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_dropped_packets), 0, NONE},
    {"filter_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, filter_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, comm_port_bytes_written), 0,
     NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, comm_port_write_overruns), 0,
     NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, comm_port_read_overruns), 0,
     NONE},
    {"imu_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, imu_parser_errors), 0, NONE},
    {"imu_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, imu_message_count), 0, NONE},
    {"imu_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, imu_last_message_time), 0, NONE},
    {"gnss_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_parser_errors), 0, NONE},
    {"gnss_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_message_count), 0, NONE},
    {"gnss_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, gnss_last_message_time), 0, NONE},
    {"mag_init_failed", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, mag_init_failed), 0, NONE},
    {"pressure_init_failed", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, pressure_init_failed), 0, NONE},
    {"receiver_init_failed", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gq4_45_response, receiver_init_failed), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_gq4_45_response = {
    parameters_3dm_device_status_diagnostic_gq4_45_response, 27,
    sizeof(struct mip_3dm_device_status_diagnostic_gq4_45_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_rq1_45_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, status_flags), 0, NONE},
    {"system_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, system_state), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, system_timer), 0, NONE},
    {"gnss_power_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_power_state), 0, NONE},
    {"cold_start_on_power_on", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, cold_start_on_power_on), 0, NONE},
    {"temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, temperature), 0, NONE},
    {"temperature_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, temperature_last_time), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, imu_stream_enabled), 0, NONE},
    {"gnss_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_stream_enabled), 0, NONE},
    {"filter_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, filter_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, imu_dropped_packets), 0, NONE},
    {"gnss_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_dropped_packets), 0, NONE},
    {"filter_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, filter_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, comm_port_bytes_written), 0,
     NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, comm_port_write_overruns), 0,
     NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, comm_port_read_overruns), 0,
     NONE},
    {"imu_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, imu_parser_errors), 0, NONE},
    {"imu_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, imu_message_count), 0, NONE},
    {"imu_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, imu_last_message_time), 0, NONE},
    {"gnss_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_parser_errors), 0, NONE},
    {"gnss_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_message_count), 0, NONE},
    {"gnss_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_45_response, gnss_last_message_time), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_rq1_45_response = {
    parameters_3dm_device_status_diagnostic_rq1_45_response, 27,
    sizeof(struct mip_3dm_device_status_diagnostic_rq1_45_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_gx4_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, status_flags), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, system_timer), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, imu_stream_enabled), 0, NONE},
    {"filter_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, filter_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, imu_dropped_packets), 0, NONE},
    {"filter_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, filter_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, comm_port_bytes_written), 0, NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, comm_port_write_overruns), 0, NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, comm_port_read_overruns), 0, NONE},
    {"usb_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, usb_bytes_written), 0, NONE},
    {"usb_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, usb_bytes_read), 0, NONE},
    {"usb_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, usb_write_overruns), 0, NONE},
    {"usb_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, usb_read_overruns), 0, NONE},
    {"imu_parser_errors", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, imu_parser_errors), 0, NONE},
    {"imu_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, imu_message_count), 0, NONE},
    {"imu_last_message_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_response, imu_last_message_time), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_gx4_response = {
    parameters_3dm_device_status_diagnostic_gx4_response, 21,
    sizeof(struct mip_3dm_device_status_diagnostic_gx4_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_imu_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, status_flags), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, system_timer), 0, NONE},
    {"has_mag", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, has_mag), 0, NONE},
    {"has_pressure", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, has_pressure), 0, NONE},
    {"power_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, power_state), 0, NONE},
    {"gyro_range", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, gyro_range), 0, NONE},
    {"accel_range", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, accel_range), 0, NONE},
    {"reserved", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, reserved), 0, NONE},
    {"temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, temperature), 0, NONE},
    {"temperature_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, temperature_last_time), 0, NONE},
    {"temperature_error", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, temperature_error), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, imu_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, imu_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, comm_port_bytes_written), 0, NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, comm_port_write_overruns), 0, NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_imu_response, comm_port_read_overruns), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_imu_response = {
    parameters_3dm_device_status_diagnostic_imu_response, 21,
    sizeof(struct mip_3dm_device_status_diagnostic_imu_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_gx4_imu_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, status_flags), 0, NONE},
    {"system_timer", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, system_timer), 0, NONE},
    {"has_mag", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, has_mag), 0, NONE},
    {"has_pressure", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, has_pressure), 0, NONE},
    {"gyro_range", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, gyro_range), 0, NONE},
    {"accel_range", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, accel_range), 0, NONE},
    {"mag_range", "", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, mag_range), 0, NONE},
    {"pressure_range", "", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, pressure_range), 0, NONE},
    {"temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, temperature), 0, NONE},
    {"temperature_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, temperature_last_time), 0, NONE},
    {"temperature_error", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, temperature_error), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, imu_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, imu_dropped_packets), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, comm_port_bytes_written), 0,
     NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, comm_port_write_overruns), 0,
     NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx4_imu_response, comm_port_read_overruns), 0,
     NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_gx4_imu_response = {
    parameters_3dm_device_status_diagnostic_gx4_imu_response, 21,
    sizeof(struct mip_3dm_device_status_diagnostic_gx4_imu_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_rq1_imu_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"status_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, status_flags), 0, NONE},
    {"system_timer", "us", NUMBER(U64), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, system_timer), 0, NONE},
    {"temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, temperature), 0, NONE},
    {"temperature_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, temperature_last_time), 0, NONE},
    {"bad_temperature_sensor_detected", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, bad_temperature_sensor_detected),
     0, NONE},
    {"cold_temperature_detected", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, cold_temperature_detected), 0,
     NONE},
    {"bad_voltage_detected", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, bad_voltage_detected), 0, NONE},
    {"pps_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, pps_count), 0, NONE},
    {"pps_last_time", "ms", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, pps_last_time), 0, NONE},
    {"imu_stream_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, imu_stream_enabled), 0, NONE},
    {"imu_dropped_packets", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, imu_dropped_packets), 0, NONE},
    {"comm_port_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_state), 0, NONE},
    {"comm_port_baud_rate", "Bd", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_baud_rate), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_bytes_written), 0,
     NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_write_overruns), 0,
     NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_rq1_imu_response, comm_port_read_overruns), 0,
     NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_rq1_imu_response = {
    parameters_3dm_device_status_diagnostic_rq1_imu_response, 19,
    sizeof(struct mip_3dm_device_status_diagnostic_rq1_imu_response)};

static const struct mip_parameter parameters_3dm_device_status_basic_gx3_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_gx3_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 1, 0, 0,
     0, NONE},
    {"comm_mode", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_gx3_response, comm_mode), 0, NONE},
    {"comm_device", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_gx3_response, comm_device), 0, NONE},
    {"settings_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_gx3_response, settings_flags), 0, NONE},
    {"comm_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_gx3_response, comm_state), 0, NONE},
    {"comm_baud_rate", "Bd", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_basic_gx3_response, comm_baud_rate), 0, NONE},
};
static const struct mip_record record_3dm_device_status_basic_gx3_response = {
    parameters_3dm_device_status_basic_gx3_response, 7,
    sizeof(struct mip_3dm_device_status_basic_gx3_response)};

static const struct mip_parameter parameters_3dm_device_status_diagnostic_gx3_response[] = {
    {"model_number", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, model_number), 0, NONE},
    {"status_selector", "", MIP_KIND_CONSTANT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 2, 0, 0,
     0, NONE},
    {"comm_mode", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_mode), 0, NONE},
    {"comm_device", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_device), 0, NONE},
    {"settings_flags", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, settings_flags), 0, NONE},
    {"comm_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_state), 0, NONE},
    {"comm_baud_rate", "Bd", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_baud_rate), 0, NONE},
    {"comm_port_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_port_bytes_written), 0, NONE},
    {"comm_port_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_port_bytes_read), 0, NONE},
    {"comm_port_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_port_write_overruns), 0, NONE},
    {"comm_port_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, comm_port_read_overruns), 0, NONE},
    {"usb_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, usb_state), 0, NONE},
    {"usb_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, usb_bytes_written), 0, NONE},
    {"usb_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, usb_bytes_read), 0, NONE},
    {"usb_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, usb_write_overruns), 0, NONE},
    {"usb_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, usb_read_overruns), 0, NONE},
    {"gnss_driver_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_driver_state), 0, NONE},
    {"gnss_port_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_port_state), 0, NONE},
    {"gnss_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_bytes_written), 0, NONE},
    {"gnss_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_bytes_read), 0, NONE},
    {"gnss_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_write_overruns), 0, NONE},
    {"gnss_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_read_overruns), 0, NONE},
    {"gnss_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_message_count), 0, NONE},
    {"gnss_delayed_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, gnss_delayed_message_count), 0,
     NONE},
    {"imu_driver_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_driver_state), 0, NONE},
    {"imu_port_state", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_port_state), 0, NONE},
    {"imu_bytes_written", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_bytes_written), 0, NONE},
    {"imu_bytes_read", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_bytes_read), 0, NONE},
    {"imu_write_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_write_overruns), 0, NONE},
    {"imu_read_overruns", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_read_overruns), 0, NONE},
    {"imu_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_message_count), 0, NONE},
    {"imu_delayed_message_count", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_3dm_device_status_diagnostic_gx3_response, imu_delayed_message_count), 0, NONE},
};
static const struct mip_record record_3dm_device_status_diagnostic_gx3_response = {
    parameters_3dm_device_status_diagnostic_gx3_response, 32,
    sizeof(struct mip_3dm_device_status_diagnostic_gx3_response)};

static const struct mip_parameter parameters_3dm_gps_dynamics_mode_response[] = {
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gps_dynamics_mode_response, mode), 0,
     &mip_names_3dm_receiver_dynamics, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_gps_dynamics_mode_response = {
    parameters_3dm_gps_dynamics_mode_response, 1,
    sizeof(struct mip_3dm_gps_dynamics_mode_response)};

static const struct mip_parameter parameters_3dm_imu_timestamp_response[] = {
    {"selector", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_imu_timestamp_response, selector), 0,
     &mip_names_3dm_imu_timestamp_selector, NULL, NULL, NULL, 0},
    {"time", "", NUMBER(U32), 0, 0, 0, ONE(struct mip_3dm_imu_timestamp_response, time), 0, NONE},
};
static const struct mip_record record_3dm_imu_timestamp_response = {
    parameters_3dm_imu_timestamp_response, 2, sizeof(struct mip_3dm_imu_timestamp_response)};

static const struct mip_parameter parameters_3dm_complementary_filter_response[] = {
    {"pitch_roll_enable", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_complementary_filter_response, pitch_roll_enable), 0, NONE},
    {"heading_enable", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_complementary_filter_response, heading_enable), 0, NONE},
    {"pitch_roll_time_constant", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_complementary_filter_response, pitch_roll_time_constant), 0, NONE},
    {"heading_time_constant", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_complementary_filter_response, heading_time_constant), 0, NONE},
};
static const struct mip_record record_3dm_complementary_filter_response = {
    parameters_3dm_complementary_filter_response, 4,
    sizeof(struct mip_3dm_complementary_filter_response)};

static const struct mip_parameter parameters_3dm_accel_bias_response[] = {
    {"bias", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_3dm_accel_bias_response, bias), 0, NONE},
};
static const struct mip_record record_3dm_accel_bias_response = {
    parameters_3dm_accel_bias_response, 1, sizeof(struct mip_3dm_accel_bias_response)};

static const struct mip_parameter parameters_3dm_gyro_bias_response[] = {
    {"bias", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_3dm_gyro_bias_response, bias), 0, NONE},
};
static const struct mip_record record_3dm_gyro_bias_response = {
    parameters_3dm_gyro_bias_response, 1, sizeof(struct mip_3dm_gyro_bias_response)};

static const struct mip_parameter parameters_3dm_mag_hard_iron_offset_response[] = {
    {"offset", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_3dm_mag_hard_iron_offset_response, offset), 0, NONE},
};
static const struct mip_record record_3dm_mag_hard_iron_offset_response = {
    parameters_3dm_mag_hard_iron_offset_response, 1,
    sizeof(struct mip_3dm_mag_hard_iron_offset_response)};

static const struct mip_parameter parameters_3dm_mag_soft_iron_matrix_response[] = {
    {"matrix", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_3dm_mag_soft_iron_matrix_response, matrix), 0, NONE},
};
static const struct mip_record record_3dm_mag_soft_iron_matrix_response = {
    parameters_3dm_mag_soft_iron_matrix_response, 1,
    sizeof(struct mip_3dm_mag_soft_iron_matrix_response)};

static const struct mip_parameter parameters_3dm_coning_sculling_enable_response[] = {
    {"enable", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_3dm_coning_sculling_enable_response, enable), 0, NONE},
};
static const struct mip_record record_3dm_coning_sculling_enable_response = {
    parameters_3dm_coning_sculling_enable_response, 1,
    sizeof(struct mip_3dm_coning_sculling_enable_response)};

static const struct mip_parameter parameters_3dm_constellation_settings_response[] = {
    {"max_channels_available", "1", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_constellation_settings_response, max_channels_available), 0, NONE},
    {"max_channels_use", "1", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_constellation_settings_response, max_channels_use), 0, NONE},
    {"config_count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_3dm_constellation_settings_response, config_count), 0, NONE},
    {"settings", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 41, 1, 2, 0, 0,
     MANY(struct mip_3dm_constellation_settings_response, settings), 0, NULL, NULL,
     &record_3dm_constellation_settings_entry, NULL, 0},
};
static const struct mip_record record_3dm_constellation_settings_response = {
    parameters_3dm_constellation_settings_response, 4,
    sizeof(struct mip_3dm_constellation_settings_response)};

static const struct mip_parameter parameters_3dm_gnss_sbas_settings_response[] = {
    {"enable_sbas", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_gnss_sbas_settings_response, enable_sbas), 0, NONE},
    {"sbas_options", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_gnss_sbas_settings_response, sbas_options), 0, &mip_names_3dm_sbas_options,
     NULL, NULL, NULL, 0},
    {"num_included_prns", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_3dm_gnss_sbas_settings_response, num_included_prns), 0, NONE},
    {"included_prns", "", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_COUNTED, 124, 1, 2, 0, 0,
     MANY(struct mip_3dm_gnss_sbas_settings_response, included_prns), 0, NONE},
};
static const struct mip_record record_3dm_gnss_sbas_settings_response = {
    parameters_3dm_gnss_sbas_settings_response, 4,
    sizeof(struct mip_3dm_gnss_sbas_settings_response)};

static const struct mip_parameter parameters_3dm_gnss_assisted_fix_response[] = {
    {"option", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gnss_assisted_fix_response, option), 0,
     &mip_names_3dm_assisted_fix_option, NULL, NULL, NULL, 0},
    {"flags", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gnss_assisted_fix_response, flags), 0,
     NONE},
};
static const struct mip_record record_3dm_gnss_assisted_fix_response = {
    parameters_3dm_gnss_assisted_fix_response, 2,
    sizeof(struct mip_3dm_gnss_assisted_fix_response)};

static const struct mip_parameter parameters_3dm_gnss_time_assistance_response[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_3dm_gnss_time_assistance_response, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_3dm_gnss_time_assistance_response, week_number), 0, NONE},
    {"accuracy", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_gnss_time_assistance_response, accuracy), 0, NONE},
};
static const struct mip_record record_3dm_gnss_time_assistance_response = {
    parameters_3dm_gnss_time_assistance_response, 3,
    sizeof(struct mip_3dm_gnss_time_assistance_response)};

static const struct mip_parameter parameters_3dm_pps_source_control_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_pps_source_control_response, source), 0,
     &mip_names_3dm_pps_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_pps_source_control_response = {
    parameters_3dm_pps_source_control_response, 1,
    sizeof(struct mip_3dm_pps_source_control_response)};

static const struct mip_parameter parameters_3dm_sensor_to_vehicle_transform_euler_response[] = {
    {"roll", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler_response, roll), 0, NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler_response, pitch), 0, NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_euler_response, yaw), 0, NONE},
};
static const struct mip_record record_3dm_sensor_to_vehicle_transform_euler_response = {
    parameters_3dm_sensor_to_vehicle_transform_euler_response, 3,
    sizeof(struct mip_3dm_sensor_to_vehicle_transform_euler_response)};

static const struct mip_parameter parameters_3dm_sensor_to_vehicle_transform_quaternion_response[] =
    {
        {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
         ONE(struct mip_3dm_sensor_to_vehicle_transform_quaternion_response, q), 0, NONE},
};
static const struct mip_record record_3dm_sensor_to_vehicle_transform_quaternion_response = {
    parameters_3dm_sensor_to_vehicle_transform_quaternion_response, 1,
    sizeof(struct mip_3dm_sensor_to_vehicle_transform_quaternion_response)};

static const struct mip_parameter parameters_3dm_sensor_to_vehicle_transform_dcm_response[] = {
    {"dcm", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_3dm_sensor_to_vehicle_transform_dcm_response, dcm), 0, NONE},
};
static const struct mip_record record_3dm_sensor_to_vehicle_transform_dcm_response = {
    parameters_3dm_sensor_to_vehicle_transform_dcm_response, 1,
    sizeof(struct mip_3dm_sensor_to_vehicle_transform_dcm_response)};

static const struct mip_parameter parameters_3dm_get_event_support_response[] = {
    {"query", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_get_event_support_response, query), 0,
     &mip_names_3dm_event_support_query, NULL, NULL, NULL, 0},
    {"max_instances", "1", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_get_event_support_response, max_instances), 0, NONE},
    {"num_entries", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 3, 0, 0,
     ONE(struct mip_3dm_get_event_support_response, num_entries), 0, NONE},
    {"entries", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 125, 1, 2, 0, 0,
     MANY(struct mip_3dm_get_event_support_response, entries), 0, NULL, NULL,
     &record_3dm_event_support_info, NULL, 0},
};
static const struct mip_record record_3dm_get_event_support_response = {
    parameters_3dm_get_event_support_response, 4,
    sizeof(struct mip_3dm_get_event_support_response)};

static const struct mip_parameter parameters_3dm_event_control_response[] = {
    {"instance", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_control_response, instance), 0,
     NONE},
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_control_response, mode), 0,
     &mip_names_event_trigger_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_event_control_response = {
    parameters_3dm_event_control_response, 2, sizeof(struct mip_3dm_event_control_response)};

static const struct mip_parameter parameters_3dm_get_event_trigger_status_response[] = {
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_get_event_trigger_status_response, count), 0, NONE},
    {"triggers", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 126, 1, 0, 0, 0,
     MANY(struct mip_3dm_get_event_trigger_status_response, triggers), 0, NULL, NULL,
     &record_3dm_event_trigger_status_entry, NULL, 0},
};
static const struct mip_record record_3dm_get_event_trigger_status_response = {
    parameters_3dm_get_event_trigger_status_response, 2,
    sizeof(struct mip_3dm_get_event_trigger_status_response)};

static const struct mip_parameter parameters_3dm_get_event_action_status_response[] = {
    {"count", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_get_event_action_status_response, count), 0, NONE},
    {"actions", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 126, 1, 0, 0, 0,
     MANY(struct mip_3dm_get_event_action_status_response, actions), 0, NULL, NULL,
     &record_3dm_event_action_status_entry, NULL, 0},
};
static const struct mip_record record_3dm_get_event_action_status_response = {
    parameters_3dm_get_event_action_status_response, 2,
    sizeof(struct mip_3dm_get_event_action_status_response)};

static const struct mip_parameter members_3dm_event_trigger_config_response_parameters[] = {
    {"gpio", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_trigger_config_parameters, gpio), 0, NULL, NULL,
     &record_event_trigger_gpio, NULL, 0},
    {"threshold", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_trigger_config_parameters, threshold), 0, NULL, NULL,
     &record_event_trigger_threshold, NULL, 0},
    {"combination", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_trigger_config_parameters, combination), 0, NULL, NULL,
     &record_event_trigger_combination, NULL, 0},
};
static const struct mip_case cases_3dm_event_trigger_config_response_parameters[] = {
    {0, NULL},
    {1, &members_3dm_event_trigger_config_response_parameters[0]},
    {2, &members_3dm_event_trigger_config_response_parameters[1]},
    {3, &members_3dm_event_trigger_config_response_parameters[2]},
};
static const struct mip_parameter parameters_3dm_event_trigger_config_response[] = {
    {"instance", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_event_trigger_config_response, instance), 0, NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_trigger_config_response, type), 0,
     &mip_names_event_trigger_type, NULL, NULL, NULL, 0},
    {"parameters", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_3dm_event_trigger_config_response, parameters), 0, NULL, NULL, NULL,
     cases_3dm_event_trigger_config_response_parameters, 4},
};
static const struct mip_record record_3dm_event_trigger_config_response = {
    parameters_3dm_event_trigger_config_response, 3,
    sizeof(struct mip_3dm_event_trigger_config_response)};

static const struct mip_parameter members_3dm_event_action_config_response_parameters[] = {
    {"gpio", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_action_config_parameters, gpio), 0, NULL, NULL,
     &record_event_action_gpio, NULL, 0},
    {"message", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(union mip_3dm_event_action_config_parameters, message), 0, NULL, NULL,
     &record_event_action_message, NULL, 0},
};
static const struct mip_case cases_3dm_event_action_config_response_parameters[] = {
    {0, NULL},
    {1, &members_3dm_event_action_config_response_parameters[0]},
    {2, &members_3dm_event_action_config_response_parameters[1]},
};
static const struct mip_parameter parameters_3dm_event_action_config_response[] = {
    {"instance", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_event_action_config_response, instance), 0, NONE},
    {"trigger", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_action_config_response, trigger),
     0, NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_event_action_config_response, type), 0,
     &mip_names_event_action_type, NULL, NULL, NULL, 0},
    {"parameters", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_event_action_config_response, parameters), 0, NULL, NULL, NULL,
     cases_3dm_event_action_config_response_parameters, 3},
};
static const struct mip_record record_3dm_event_action_config_response = {
    parameters_3dm_event_action_config_response, 4,
    sizeof(struct mip_3dm_event_action_config_response)};

static const struct mip_reading readings_3dm_gpio_config_response_behavior[] = {
    {NULL, 1, 0, &mip_names_gpio_unused_behavior},
    {NULL, 1, 1, &mip_names_gpio_behavior},
    {NULL, 1, 2, &mip_names_gpio_pps_behavior},
    {NULL, 1, 3, &mip_names_gpio_encoder_behavior},
    {NULL, 1, 4, &mip_names_gpio_timestamp_behavior},
    {NULL, 1, 5, &mip_names_gpio_uart_behavior},
};
static const struct mip_parameter parameters_3dm_gpio_config_response[] = {
    {"pin", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_config_response, pin), 0, NONE},
    {"feature", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_config_response, feature), 0,
     &mip_names_gpio_feature, NULL, NULL, NULL, 0},
    {"behavior", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_config_response, behavior), 0,
     NULL, readings_3dm_gpio_config_response_behavior, NULL, NULL, 6},
    {"pin_mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_config_response, pin_mode), 0,
     &mip_names_gpio_pin_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_3dm_gpio_config_response = {
    parameters_3dm_gpio_config_response, 4, sizeof(struct mip_3dm_gpio_config_response)};

static const struct mip_parameter parameters_3dm_gpio_state_response[] = {
    {"pin", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_gpio_state_response, pin), 0, NONE},
    {"state", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_gpio_state_response, state), 0, NONE},
};
static const struct mip_record record_3dm_gpio_state_response = {
    parameters_3dm_gpio_state_response, 2, sizeof(struct mip_3dm_gpio_state_response)};

static const struct mip_parameter parameters_3dm_odometer_config_response[] = {
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_odometer_config_response, mode), 0,
     &mip_names_3dm_odometer_mode, NULL, NULL, NULL, 0},
    {"scaling", "pulse/m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_odometer_config_response, scaling), 0, NONE},
    {"uncertainty", "1", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_odometer_config_response, uncertainty), 0, NONE},
};
static const struct mip_record record_3dm_odometer_config_response = {
    parameters_3dm_odometer_config_response, 3, sizeof(struct mip_3dm_odometer_config_response)};

static const struct mip_parameter parameters_3dm_sensor_range_response[] = {
    {"sensor", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_sensor_range_response, sensor), 0,
     &mip_names_3dm_sensor_range_type, NULL, NULL, NULL, 0},
    {"setting", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_3dm_sensor_range_response, setting), 0,
     NONE},
};
static const struct mip_record record_3dm_sensor_range_response = {
    parameters_3dm_sensor_range_response, 2, sizeof(struct mip_3dm_sensor_range_response)};

static const struct mip_parameter parameters_3dm_get_calibrated_sensor_ranges_response[] = {
    {"sensor", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_get_calibrated_sensor_ranges_response, sensor), 0,
     &mip_names_3dm_sensor_range_type, NULL, NULL, NULL, 0},
    {"num_ranges", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 0, 0,
     ONE(struct mip_3dm_get_calibrated_sensor_ranges_response, num_ranges), 0, NONE},
    {"ranges", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 50, 1, 1, 0, 0,
     MANY(struct mip_3dm_get_calibrated_sensor_ranges_response, ranges), 0, NULL, NULL,
     &record_3dm_sensor_range_entry, NULL, 0},
};
static const struct mip_record record_3dm_get_calibrated_sensor_ranges_response = {
    parameters_3dm_get_calibrated_sensor_ranges_response, 3,
    sizeof(struct mip_3dm_get_calibrated_sensor_ranges_response)};

static const struct mip_parameter parameters_3dm_low_pass_filter_response[] = {
    {"descriptor_set", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_low_pass_filter_response, descriptor_set), 0, NONE},
    {"field_descriptor", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_3dm_low_pass_filter_response, field_descriptor), 0, NONE},
    {"enable", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_low_pass_filter_response, enable), 0,
     NONE},
    {"manual", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_3dm_low_pass_filter_response, manual), 0,
     NONE},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_3dm_low_pass_filter_response, frequency), 0, NONE},
};
static const struct mip_record record_3dm_low_pass_filter_response = {
    parameters_3dm_low_pass_filter_response, 5, sizeof(struct mip_3dm_low_pass_filter_response)};

static const struct mip_record record_filter_reset = {NULL, 0, sizeof(struct mip_filter_reset)};

static const struct mip_parameter parameters_filter_set_initial_attitude[] = {
    {"roll", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_set_initial_attitude, roll), 0,
     NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_set_initial_attitude, pitch), 0,
     NONE},
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_set_initial_attitude, heading),
     0, NONE},
};
static const struct mip_record record_filter_set_initial_attitude = {
    parameters_filter_set_initial_attitude, 3, sizeof(struct mip_filter_set_initial_attitude)};

static const struct mip_parameter parameters_filter_set_initial_heading[] = {
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_set_initial_heading, heading),
     0, NONE},
};
static const struct mip_record record_filter_set_initial_heading = {
    parameters_filter_set_initial_heading, 1, sizeof(struct mip_filter_set_initial_heading)};

static const struct mip_parameter parameters_filter_set_initial_attitude_from_imu[] = {
    {"declination", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_set_initial_attitude_from_imu, declination), 0, NONE},
};
static const struct mip_record record_filter_set_initial_attitude_from_imu = {
    parameters_filter_set_initial_attitude_from_imu, 1,
    sizeof(struct mip_filter_set_initial_attitude_from_imu)};

static const struct mip_record record_filter_run = {NULL, 0, sizeof(struct mip_filter_run)};

static const struct mip_parameter parameters_filter_vehicle_dynamics_mode[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_vehicle_dynamics_mode, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"mode", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_vehicle_dynamics_mode, mode), 0,
     &mip_names_filter_dynamics_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_vehicle_dynamics_mode = {
    parameters_filter_vehicle_dynamics_mode, 2, sizeof(struct mip_filter_vehicle_dynamics_mode)};
static const uint8_t required_filter_vehicle_dynamics_mode[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_rotation_euler[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"roll", "rad", NUMBER(FLOAT), 0, 1, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler, roll), 0, NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler, pitch), 0, NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 3, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler, yaw), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_rotation_euler = {
    parameters_filter_sensor_to_vehicle_rotation_euler, 4,
    sizeof(struct mip_filter_sensor_to_vehicle_rotation_euler)};
static const uint8_t required_filter_sensor_to_vehicle_rotation_euler[] = {0, 3, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_offset[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_sensor_to_vehicle_offset, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_sensor_to_vehicle_offset, offset), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_offset = {
    parameters_filter_sensor_to_vehicle_offset, 2,
    sizeof(struct mip_filter_sensor_to_vehicle_offset)};
static const uint8_t required_filter_sensor_to_vehicle_offset[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_antenna_offset[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_antenna_offset, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_antenna_offset, offset), 0, NONE},
};
static const struct mip_record record_filter_antenna_offset = {
    parameters_filter_antenna_offset, 2, sizeof(struct mip_filter_antenna_offset)};
static const uint8_t required_filter_antenna_offset[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_estimation_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_estimation_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"flags", "", NUMBER(U16), 0, 1, 0, ONE(struct mip_filter_estimation_control, flags), 0,
     &mip_names_filter_estimated_states, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_estimation_control = {
    parameters_filter_estimation_control, 2, sizeof(struct mip_filter_estimation_control)};
static const uint8_t required_filter_estimation_control[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_gnss_source[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_gnss_source, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_gnss_source, source), 0,
     &mip_names_filter_gnss_aiding_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_gnss_source = {parameters_filter_gnss_source, 2,
                                                            sizeof(struct mip_filter_gnss_source)};
static const uint8_t required_filter_gnss_source[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_external_gnss_update[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_filter_external_gnss_update, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_external_gnss_update, week_number), 0, NONE},
    {"latitude", "deg", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_external_gnss_update, latitude), 0, NONE},
    {"longitude", "deg", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_external_gnss_update, longitude), 0, NONE},
    {"height", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_filter_external_gnss_update, height), 0,
     NONE},
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_external_gnss_update, velocity), 0, NONE},
    {"position_uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_external_gnss_update, position_uncertainty), 0, NONE},
    {"velocity_uncertainty", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0,
     0, ONE(struct mip_filter_external_gnss_update, velocity_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_external_gnss_update = {
    parameters_filter_external_gnss_update, 8, sizeof(struct mip_filter_external_gnss_update)};

static const struct mip_parameter parameters_filter_external_heading_update[] = {
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update, heading), 0, NONE},
    {"heading_uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update, heading_uncertainty), 0, NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_external_heading_update, type), 0,
     &mip_names_filter_heading_type, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_external_heading_update = {
    parameters_filter_external_heading_update, 3,
    sizeof(struct mip_filter_external_heading_update)};

static const struct mip_parameter parameters_filter_heading_source[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_heading_source, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_heading_source, source), 0,
     &mip_names_filter_heading_update_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_heading_source = {
    parameters_filter_heading_source, 2, sizeof(struct mip_filter_heading_source)};
static const uint8_t required_filter_heading_source[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_auto_initialization_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_auto_initialization_control, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_auto_initialization_control, enable),
     0, NONE},
};
static const struct mip_record record_filter_auto_initialization_control = {
    parameters_filter_auto_initialization_control, 2,
    sizeof(struct mip_filter_auto_initialization_control)};
static const uint8_t required_filter_auto_initialization_control[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_accel_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_accel_noise, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_accel_noise, noise), 0, NONE},
};
static const struct mip_record record_filter_accel_noise = {parameters_filter_accel_noise, 2,
                                                            sizeof(struct mip_filter_accel_noise)};
static const uint8_t required_filter_accel_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_gyro_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_gyro_noise, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_gyro_noise, noise), 0, NONE},
};
static const struct mip_record record_filter_gyro_noise = {parameters_filter_gyro_noise, 2,
                                                           sizeof(struct mip_filter_gyro_noise)};
static const uint8_t required_filter_gyro_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_accel_bias_model[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_accel_bias_model, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"beta", "1/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_accel_bias_model, beta), 0, NONE},
    {"noise", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 2, 0,
     ONE(struct mip_filter_accel_bias_model, noise), 0, NONE},
};
static const struct mip_record record_filter_accel_bias_model = {
    parameters_filter_accel_bias_model, 3, sizeof(struct mip_filter_accel_bias_model)};
static const uint8_t required_filter_accel_bias_model[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_gyro_bias_model[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_gyro_bias_model, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"beta", "1/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_gyro_bias_model, beta), 0, NONE},
    {"noise", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 2, 0,
     ONE(struct mip_filter_gyro_bias_model, noise), 0, NONE},
};
static const struct mip_record record_filter_gyro_bias_model = {
    parameters_filter_gyro_bias_model, 3, sizeof(struct mip_filter_gyro_bias_model)};
static const uint8_t required_filter_gyro_bias_model[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_auto_zupt[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_auto_zupt, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_auto_zupt, enable), 0, NONE},
    {"threshold", "m/s", NUMBER(FLOAT), 0, 2, 0, ONE(struct mip_filter_auto_zupt, threshold), 0,
     NONE},
};
static const struct mip_record record_filter_auto_zupt = {parameters_filter_auto_zupt, 3,
                                                          sizeof(struct mip_filter_auto_zupt)};
static const uint8_t required_filter_auto_zupt[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_external_heading_update_with_time[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update_with_time, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update_with_time, week_number), 0, NONE},
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update_with_time, heading), 0, NONE},
    {"heading_uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update_with_time, heading_uncertainty), 0, NONE},
    {"type", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_external_heading_update_with_time, type), 0,
     &mip_names_filter_heading_type, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_external_heading_update_with_time = {
    parameters_filter_external_heading_update_with_time, 5,
    sizeof(struct mip_filter_external_heading_update_with_time)};

static const struct mip_parameter parameters_filter_auto_angular_zupt[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_auto_angular_zupt, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_auto_angular_zupt, enable), 0, NONE},
    {"threshold", "rad/s", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_auto_angular_zupt, threshold), 0, NONE},
};
static const struct mip_record record_filter_auto_angular_zupt = {
    parameters_filter_auto_angular_zupt, 3, sizeof(struct mip_filter_auto_angular_zupt)};
static const uint8_t required_filter_auto_angular_zupt[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_tare_orientation[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_tare_orientation, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"axes", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_tare_orientation, axes), 0,
     &mip_names_filter_tare_axes, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_tare_orientation = {
    parameters_filter_tare_orientation, 2, sizeof(struct mip_filter_tare_orientation)};
static const uint8_t required_filter_tare_orientation[] = {0, 1, 0, 0, 0, 0};

static const struct mip_record record_filter_commanded_zupt = {
    NULL, 0, sizeof(struct mip_filter_commanded_zupt)};

static const struct mip_record record_filter_commanded_angular_zupt = {
    NULL, 0, sizeof(struct mip_filter_commanded_angular_zupt)};

static const struct mip_parameter parameters_filter_reference_position[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_reference_position, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_reference_position, enable), 0, NONE},
    {"latitude", "deg", NUMBER(DOUBLE), 0, 2, 0,
     ONE(struct mip_filter_reference_position, latitude), 0, NONE},
    {"longitude", "deg", NUMBER(DOUBLE), 0, 3, 0,
     ONE(struct mip_filter_reference_position, longitude), 0, NONE},
    {"altitude", "m", NUMBER(DOUBLE), 0, 4, 0, ONE(struct mip_filter_reference_position, altitude),
     0, NONE},
};
static const struct mip_record record_filter_reference_position = {
    parameters_filter_reference_position, 5, sizeof(struct mip_filter_reference_position)};
static const uint8_t required_filter_reference_position[] = {0, 4, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_mag_capture_auto_calibration[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_mag_capture_auto_calibration, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_mag_capture_auto_calibration = {
    parameters_filter_mag_capture_auto_calibration, 1,
    sizeof(struct mip_filter_mag_capture_auto_calibration)};
static const uint8_t required_filter_mag_capture_auto_calibration[] = {0, 0, 0, 0};

static const struct mip_parameter parameters_filter_gravity_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_gravity_noise, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_gravity_noise, noise), 0, NONE},
};
static const struct mip_record record_filter_gravity_noise = {
    parameters_filter_gravity_noise, 2, sizeof(struct mip_filter_gravity_noise)};
static const uint8_t required_filter_gravity_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_pressure_altitude_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_pressure_altitude_noise, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "m", NUMBER(FLOAT), 0, 1, 0, ONE(struct mip_filter_pressure_altitude_noise, noise), 0,
     NONE},
};
static const struct mip_record record_filter_pressure_altitude_noise = {
    parameters_filter_pressure_altitude_noise, 2,
    sizeof(struct mip_filter_pressure_altitude_noise)};
static const uint8_t required_filter_pressure_altitude_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_hard_iron_offset_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_hard_iron_offset_noise, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_hard_iron_offset_noise, noise), 0, NONE},
};
static const struct mip_record record_filter_hard_iron_offset_noise = {
    parameters_filter_hard_iron_offset_noise, 2, sizeof(struct mip_filter_hard_iron_offset_noise)};
static const uint8_t required_filter_hard_iron_offset_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_soft_iron_matrix_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_soft_iron_matrix_noise, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 1, 0,
     ONE(struct mip_filter_soft_iron_matrix_noise, noise), 0, NONE},
};
static const struct mip_record record_filter_soft_iron_matrix_noise = {
    parameters_filter_soft_iron_matrix_noise, 2, sizeof(struct mip_filter_soft_iron_matrix_noise)};
static const uint8_t required_filter_soft_iron_matrix_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_enable_measurements[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_enable_measurements, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"control", "", NUMBER(U16), 0, 1, 0, ONE(struct mip_filter_enable_measurements, control), 0,
     &mip_names_filter_measurement_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_enable_measurements = {
    parameters_filter_enable_measurements, 2, sizeof(struct mip_filter_enable_measurements)};
static const uint8_t required_filter_enable_measurements[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_mag_noise[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_mag_noise, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"noise", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 1, 0,
     ONE(struct mip_filter_mag_noise, noise), 0, NONE},
};
static const struct mip_record record_filter_mag_noise = {parameters_filter_mag_noise, 2,
                                                          sizeof(struct mip_filter_mag_noise)};
static const uint8_t required_filter_mag_noise[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_magnetic_declination_source[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_magnetic_declination_source, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_magnetic_declination_source, source),
     0, &mip_names_filter_mag_parameter_source, NULL, NULL, NULL, 0},
    {"declination", "rad", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_magnetic_declination_source, declination), 0, NONE},
};
static const struct mip_record record_filter_magnetic_declination_source = {
    parameters_filter_magnetic_declination_source, 3,
    sizeof(struct mip_filter_magnetic_declination_source)};
static const uint8_t required_filter_magnetic_declination_source[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_accel_magnitude_adaptive[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_accel_magnitude_adaptive, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"adaptive_measurement", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, adaptive_measurement), 0,
     &mip_names_filter_adaptive_measurement_selector, NULL, NULL, NULL, 0},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, frequency), 0, NONE},
    {"low_limit", "m/s^2", NUMBER(FLOAT), 0, 3, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, low_limit), 0, NONE},
    {"high_limit", "m/s^2", NUMBER(FLOAT), 0, 4, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, high_limit), 0, NONE},
    {"low_limit_uncertainty", "m/s^2", NUMBER(FLOAT), 0, 5, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, low_limit_uncertainty), 0, NONE},
    {"high_limit_uncertainty", "m/s^2", NUMBER(FLOAT), 0, 6, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, high_limit_uncertainty), 0, NONE},
    {"minimum_uncertainty", "m/s^2", NUMBER(FLOAT), 0, 7, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive, minimum_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_accel_magnitude_adaptive = {
    parameters_filter_accel_magnitude_adaptive, 8,
    sizeof(struct mip_filter_accel_magnitude_adaptive)};
static const uint8_t required_filter_accel_magnitude_adaptive[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_mag_magnitude_adaptive[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_mag_magnitude_adaptive, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"adaptive_measurement", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, adaptive_measurement), 0,
     &mip_names_filter_adaptive_measurement_selector, NULL, NULL, NULL, 0},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, frequency), 0, NONE},
    {"low_limit", "gauss", NUMBER(FLOAT), 0, 3, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, low_limit), 0, NONE},
    {"high_limit", "gauss", NUMBER(FLOAT), 0, 4, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, high_limit), 0, NONE},
    {"low_limit_uncertainty", "gauss", NUMBER(FLOAT), 0, 5, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, low_limit_uncertainty), 0, NONE},
    {"high_limit_uncertainty", "gauss", NUMBER(FLOAT), 0, 6, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, high_limit_uncertainty), 0, NONE},
    {"minimum_uncertainty", "gauss", NUMBER(FLOAT), 0, 7, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive, minimum_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_mag_magnitude_adaptive = {
    parameters_filter_mag_magnitude_adaptive, 8, sizeof(struct mip_filter_mag_magnitude_adaptive)};
static const uint8_t required_filter_mag_magnitude_adaptive[] = {0, 7, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_mag_dip_angle_adaptive[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_mag_dip_angle_adaptive, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(BOOL), 0, 1, 0, ONE(struct mip_filter_mag_dip_angle_adaptive, enable), 0,
     NONE},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive, frequency), 0, NONE},
    {"high_limit", "rad", NUMBER(FLOAT), 0, 3, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive, high_limit), 0, NONE},
    {"high_limit_uncertainty", "rad", NUMBER(FLOAT), 0, 4, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive, high_limit_uncertainty), 0, NONE},
    {"minimum_uncertainty", "rad", NUMBER(FLOAT), 0, 5, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive, minimum_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_mag_dip_angle_adaptive = {
    parameters_filter_mag_dip_angle_adaptive, 6, sizeof(struct mip_filter_mag_dip_angle_adaptive)};
static const uint8_t required_filter_mag_dip_angle_adaptive[] = {0, 5, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_altitude_aiding[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_altitude_aiding, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"selector", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_altitude_aiding, selector), 0,
     &mip_names_filter_altitude_aiding_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_altitude_aiding = {
    parameters_filter_altitude_aiding, 2, sizeof(struct mip_filter_altitude_aiding)};
static const uint8_t required_filter_altitude_aiding[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_pitch_roll_aiding[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_pitch_roll_aiding, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"aiding", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_pitch_roll_aiding, aiding), 0,
     &mip_names_filter_pitch_roll_aiding_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_pitch_roll_aiding = {
    parameters_filter_pitch_roll_aiding, 2, sizeof(struct mip_filter_pitch_roll_aiding)};
static const uint8_t required_filter_pitch_roll_aiding[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_magnetic_inclination_source[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_magnetic_inclination_source, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_magnetic_inclination_source, source),
     0, &mip_names_filter_mag_parameter_source, NULL, NULL, NULL, 0},
    {"inclination", "rad", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_magnetic_inclination_source, inclination), 0, NONE},
};
static const struct mip_record record_filter_magnetic_inclination_source = {
    parameters_filter_magnetic_inclination_source, 3,
    sizeof(struct mip_filter_magnetic_inclination_source)};
static const uint8_t required_filter_magnetic_inclination_source[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_magnetic_magnitude_source[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_magnetic_magnitude_source, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_magnetic_magnitude_source, source), 0,
     &mip_names_filter_mag_parameter_source, NULL, NULL, NULL, 0},
    {"magnitude", "gauss", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_magnetic_magnitude_source, magnitude), 0, NONE},
};
static const struct mip_record record_filter_magnetic_magnitude_source = {
    parameters_filter_magnetic_magnitude_source, 3,
    sizeof(struct mip_filter_magnetic_magnitude_source)};
static const uint8_t required_filter_magnetic_magnitude_source[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_rotation_dcm[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_dcm, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"dcm", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 1, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_dcm, dcm), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_rotation_dcm = {
    parameters_filter_sensor_to_vehicle_rotation_dcm, 2,
    sizeof(struct mip_filter_sensor_to_vehicle_rotation_dcm)};
static const uint8_t required_filter_sensor_to_vehicle_rotation_dcm[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_quaternion[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_quaternion, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 1, 0,
     ONE(struct mip_filter_sensor_to_vehicle_quaternion, q), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_quaternion = {
    parameters_filter_sensor_to_vehicle_quaternion, 2,
    sizeof(struct mip_filter_sensor_to_vehicle_quaternion)};
static const uint8_t required_filter_sensor_to_vehicle_quaternion[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_aiding_measurement_enable[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_aiding_measurement_enable, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"aiding_source", "", NUMBER(U16), 0, 1, 0,
     ONE(struct mip_filter_aiding_measurement_enable, aiding_source), 0,
     &mip_names_filter_aiding_source, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(BOOL), 0, 2, 0, ONE(struct mip_filter_aiding_measurement_enable, enable),
     0, NONE},
};
static const struct mip_record record_filter_aiding_measurement_enable = {
    parameters_filter_aiding_measurement_enable, 3,
    sizeof(struct mip_filter_aiding_measurement_enable)};
static const uint8_t required_filter_aiding_measurement_enable[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_filter_kinematic_constraint[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_kinematic_constraint, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"accel_constraint", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_kinematic_constraint, accel_constraint), 0,
     &mip_names_filter_accel_constraint, NULL, NULL, NULL, 0},
    {"velocity_constraint", "", NUMBER(U8), 0, 2, 0,
     ONE(struct mip_filter_kinematic_constraint, velocity_constraint), 0,
     &mip_names_filter_velocity_constraint, NULL, NULL, NULL, 0},
    {"angular_constraint", "", NUMBER(U8), 0, 3, 0,
     ONE(struct mip_filter_kinematic_constraint, angular_constraint), 0,
     &mip_names_filter_angular_constraint, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_kinematic_constraint = {
    parameters_filter_kinematic_constraint, 4, sizeof(struct mip_filter_kinematic_constraint)};
static const uint8_t required_filter_kinematic_constraint[] = {0, 3, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_initialization_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_initialization_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"wait_for_run_command", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_initialization_config, wait_for_run_command), 0, NONE},
    {"initial_condition_source", "", NUMBER(U8), 0, 2, 0,
     ONE(struct mip_filter_initialization_config, initial_condition_source), 0,
     &mip_names_filter_initial_condition_source, NULL, NULL, NULL, 0},
    {"auto_heading_alignment_selector", "", NUMBER(U8), 0, 3, 0,
     ONE(struct mip_filter_initialization_config, auto_heading_alignment_selector), 0,
     &mip_names_filter_heading_alignment, NULL, NULL, NULL, 0},
    {"initial_heading", "deg", NUMBER(FLOAT), 0, 4, 0,
     ONE(struct mip_filter_initialization_config, initial_heading), 0, NONE},
    {"initial_pitch", "deg", NUMBER(FLOAT), 0, 5, 0,
     ONE(struct mip_filter_initialization_config, initial_pitch), 0, NONE},
    {"initial_roll", "deg", NUMBER(FLOAT), 0, 6, 0,
     ONE(struct mip_filter_initialization_config, initial_roll), 0, NONE},
    {"initial_position", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 7, 0,
     ONE(struct mip_filter_initialization_config, initial_position), 0, NONE},
    {"initial_velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 8, 0,
     ONE(struct mip_filter_initialization_config, initial_velocity), 0, NONE},
    {"reference_frame_selector", "", NUMBER(U8), 0, 9, 0,
     ONE(struct mip_filter_initialization_config, reference_frame_selector), 0,
     &mip_names_filter_reference_frame, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_initialization_config = {
    parameters_filter_initialization_config, 10, sizeof(struct mip_filter_initialization_config)};
static const uint8_t required_filter_initialization_config[] = {0, 9, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_adaptive_filter_options[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_adaptive_filter_options, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"level", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_adaptive_filter_options, level), 0,
     &mip_names_filter_adaptive_level, NULL, NULL, NULL, 0},
    {"time_limit", "ms", NUMBER(U16), 0, 2, 0,
     ONE(struct mip_filter_adaptive_filter_options, time_limit), 0, NONE},
};
static const struct mip_record record_filter_adaptive_filter_options = {
    parameters_filter_adaptive_filter_options, 3,
    sizeof(struct mip_filter_adaptive_filter_options)};
static const uint8_t required_filter_adaptive_filter_options[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_multi_antenna_offset[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_multi_antenna_offset, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"receiver_id", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_multi_antenna_offset, receiver_id), 0, NONE},
    {"antenna_offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 2, 0,
     ONE(struct mip_filter_multi_antenna_offset, antenna_offset), 0, NONE},
};
static const struct mip_record record_filter_multi_antenna_offset = {
    parameters_filter_multi_antenna_offset, 3, sizeof(struct mip_filter_multi_antenna_offset)};
static const uint8_t required_filter_multi_antenna_offset[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_filter_relative_position_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_relative_position_config, function),
     0, &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_relative_position_config, source), 0,
     &mip_names_filter_relative_position_source, NULL, NULL, NULL, 0},
    {"reference_frame_selector", "", NUMBER(U8), 0, 2, 0,
     ONE(struct mip_filter_relative_position_config, reference_frame_selector), 0,
     &mip_names_filter_reference_frame, NULL, NULL, NULL, 0},
    {"reference_coordinates", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 3, 0,
     ONE(struct mip_filter_relative_position_config, reference_coordinates), 0, NONE},
};
static const struct mip_record record_filter_relative_position_config = {
    parameters_filter_relative_position_config, 4,
    sizeof(struct mip_filter_relative_position_config)};
static const uint8_t required_filter_relative_position_config[] = {0, 3, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_reference_point_lever_arm[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_reference_point_lever_arm, function), 0, &mip_names_function_selector,
     NULL, NULL, NULL, 0},
    {"reference_point", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_reference_point_lever_arm, reference_point), 0,
     &mip_names_filter_reference_point, NULL, NULL, NULL, 0},
    {"lever_arm_offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 2, 0,
     ONE(struct mip_filter_reference_point_lever_arm, lever_arm_offset), 0, NONE},
};
static const struct mip_record record_filter_reference_point_lever_arm = {
    parameters_filter_reference_point_lever_arm, 3,
    sizeof(struct mip_filter_reference_point_lever_arm)};
static const uint8_t required_filter_reference_point_lever_arm[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_speed_measurement[] = {
    {"source", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_speed_measurement, source), 0, NONE},
    {"tow", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_speed_measurement, tow), 0, NONE},
    {"speed", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_speed_measurement, speed), 0,
     NONE},
    {"speed_uncertainty", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_speed_measurement, speed_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_speed_measurement = {
    parameters_filter_speed_measurement, 4, sizeof(struct mip_filter_speed_measurement)};

static const struct mip_parameter parameters_filter_speed_lever_arm[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_speed_lever_arm, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"source", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_filter_speed_lever_arm, source), 0, NONE},
    {"lever_arm_offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 2, 0,
     ONE(struct mip_filter_speed_lever_arm, lever_arm_offset), 0, NONE},
};
static const struct mip_record record_filter_speed_lever_arm = {
    parameters_filter_speed_lever_arm, 3, sizeof(struct mip_filter_speed_lever_arm)};
static const uint8_t required_filter_speed_lever_arm[] = {0, 2, 1, 1, 1, 1};

static const struct mip_parameter parameters_filter_vertical_gyro_constraint_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_vertical_gyro_constraint_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_vertical_gyro_constraint_control, enable), 0, NONE},
};
static const struct mip_record record_filter_vertical_gyro_constraint_control = {
    parameters_filter_vertical_gyro_constraint_control, 2,
    sizeof(struct mip_filter_vertical_gyro_constraint_control)};
static const uint8_t required_filter_vertical_gyro_constraint_control[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_wheeled_vehicle_constraint_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_wheeled_vehicle_constraint_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_wheeled_vehicle_constraint_control, enable), 0, NONE},
};
static const struct mip_record record_filter_wheeled_vehicle_constraint_control = {
    parameters_filter_wheeled_vehicle_constraint_control, 2,
    sizeof(struct mip_filter_wheeled_vehicle_constraint_control)};
static const uint8_t required_filter_wheeled_vehicle_constraint_control[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_gnss_antenna_calibration_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_gnss_antenna_calibration_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_filter_gnss_antenna_calibration_control, enable), 0, NONE},
    {"max_offset", "m", NUMBER(FLOAT), 0, 2, 0,
     ONE(struct mip_filter_gnss_antenna_calibration_control, max_offset), 0, NONE},
};
static const struct mip_record record_filter_gnss_antenna_calibration_control = {
    parameters_filter_gnss_antenna_calibration_control, 3,
    sizeof(struct mip_filter_gnss_antenna_calibration_control)};
static const uint8_t required_filter_gnss_antenna_calibration_control[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_filter_vehicle_dynamics_mode_response[] = {
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_vehicle_dynamics_mode_response, mode),
     0, &mip_names_filter_dynamics_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_vehicle_dynamics_mode_response = {
    parameters_filter_vehicle_dynamics_mode_response, 1,
    sizeof(struct mip_filter_vehicle_dynamics_mode_response)};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_rotation_euler_response[] = {
    {"roll", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler_response, roll), 0, NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler_response, pitch), 0, NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_euler_response, yaw), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_rotation_euler_response = {
    parameters_filter_sensor_to_vehicle_rotation_euler_response, 3,
    sizeof(struct mip_filter_sensor_to_vehicle_rotation_euler_response)};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_offset_response[] = {
    {"offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_offset_response, offset), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_offset_response = {
    parameters_filter_sensor_to_vehicle_offset_response, 1,
    sizeof(struct mip_filter_sensor_to_vehicle_offset_response)};

static const struct mip_parameter parameters_filter_antenna_offset_response[] = {
    {"offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_antenna_offset_response, offset), 0, NONE},
};
static const struct mip_record record_filter_antenna_offset_response = {
    parameters_filter_antenna_offset_response, 1,
    sizeof(struct mip_filter_antenna_offset_response)};

static const struct mip_parameter parameters_filter_estimation_control_response[] = {
    {"flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_estimation_control_response, flags),
     0, &mip_names_filter_estimated_states, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_estimation_control_response = {
    parameters_filter_estimation_control_response, 1,
    sizeof(struct mip_filter_estimation_control_response)};

static const struct mip_parameter parameters_filter_gnss_source_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_gnss_source_response, source), 0,
     &mip_names_filter_gnss_aiding_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_gnss_source_response = {
    parameters_filter_gnss_source_response, 1, sizeof(struct mip_filter_gnss_source_response)};

static const struct mip_parameter parameters_filter_heading_source_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_heading_source_response, source), 0,
     &mip_names_filter_heading_update_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_heading_source_response = {
    parameters_filter_heading_source_response, 1,
    sizeof(struct mip_filter_heading_source_response)};

static const struct mip_parameter parameters_filter_auto_initialization_control_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_auto_initialization_control_response, enable), 0, NONE},
};
static const struct mip_record record_filter_auto_initialization_control_response = {
    parameters_filter_auto_initialization_control_response, 1,
    sizeof(struct mip_filter_auto_initialization_control_response)};

static const struct mip_parameter parameters_filter_accel_noise_response[] = {
    {"noise", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_accel_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_accel_noise_response = {
    parameters_filter_accel_noise_response, 1, sizeof(struct mip_filter_accel_noise_response)};

static const struct mip_parameter parameters_filter_gyro_noise_response[] = {
    {"noise", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_gyro_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_gyro_noise_response = {
    parameters_filter_gyro_noise_response, 1, sizeof(struct mip_filter_gyro_noise_response)};

static const struct mip_parameter parameters_filter_accel_bias_model_response[] = {
    {"beta", "1/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_accel_bias_model_response, beta), 0, NONE},
    {"noise", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_accel_bias_model_response, noise), 0, NONE},
};
static const struct mip_record record_filter_accel_bias_model_response = {
    parameters_filter_accel_bias_model_response, 2,
    sizeof(struct mip_filter_accel_bias_model_response)};

static const struct mip_parameter parameters_filter_gyro_bias_model_response[] = {
    {"beta", "1/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_gyro_bias_model_response, beta), 0, NONE},
    {"noise", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_gyro_bias_model_response, noise), 0, NONE},
};
static const struct mip_record record_filter_gyro_bias_model_response = {
    parameters_filter_gyro_bias_model_response, 2,
    sizeof(struct mip_filter_gyro_bias_model_response)};

static const struct mip_parameter parameters_filter_auto_zupt_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_auto_zupt_response, enable), 0, NONE},
    {"threshold", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_auto_zupt_response, threshold), 0, NONE},
};
static const struct mip_record record_filter_auto_zupt_response = {
    parameters_filter_auto_zupt_response, 2, sizeof(struct mip_filter_auto_zupt_response)};

static const struct mip_parameter parameters_filter_auto_angular_zupt_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_auto_angular_zupt_response, enable),
     0, NONE},
    {"threshold", "rad/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_auto_angular_zupt_response, threshold), 0, NONE},
};
static const struct mip_record record_filter_auto_angular_zupt_response = {
    parameters_filter_auto_angular_zupt_response, 2,
    sizeof(struct mip_filter_auto_angular_zupt_response)};

static const struct mip_parameter parameters_filter_reference_position_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_reference_position_response, enable),
     0, NONE},
    {"latitude", "deg", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_reference_position_response, latitude), 0, NONE},
    {"longitude", "deg", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_reference_position_response, longitude), 0, NONE},
    {"altitude", "m", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_reference_position_response, altitude), 0, NONE},
};
static const struct mip_record record_filter_reference_position_response = {
    parameters_filter_reference_position_response, 4,
    sizeof(struct mip_filter_reference_position_response)};

static const struct mip_parameter parameters_filter_gravity_noise_response[] = {
    {"noise", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_gravity_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_gravity_noise_response = {
    parameters_filter_gravity_noise_response, 1, sizeof(struct mip_filter_gravity_noise_response)};

static const struct mip_parameter parameters_filter_pressure_altitude_noise_response[] = {
    {"noise", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_pressure_altitude_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_pressure_altitude_noise_response = {
    parameters_filter_pressure_altitude_noise_response, 1,
    sizeof(struct mip_filter_pressure_altitude_noise_response)};

static const struct mip_parameter parameters_filter_hard_iron_offset_noise_response[] = {
    {"noise", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_hard_iron_offset_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_hard_iron_offset_noise_response = {
    parameters_filter_hard_iron_offset_noise_response, 1,
    sizeof(struct mip_filter_hard_iron_offset_noise_response)};

static const struct mip_parameter parameters_filter_soft_iron_matrix_noise_response[] = {
    {"noise", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_filter_soft_iron_matrix_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_soft_iron_matrix_noise_response = {
    parameters_filter_soft_iron_matrix_noise_response, 1,
    sizeof(struct mip_filter_soft_iron_matrix_noise_response)};

static const struct mip_parameter parameters_filter_tare_orientation_response[] = {
    {"axes", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_tare_orientation_response, axes), 0,
     &mip_names_filter_tare_axes, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_tare_orientation_response = {
    parameters_filter_tare_orientation_response, 1,
    sizeof(struct mip_filter_tare_orientation_response)};

static const struct mip_parameter parameters_filter_enable_measurements_response[] = {
    {"control", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_enable_measurements_response, control), 0,
     &mip_names_filter_measurement_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_enable_measurements_response = {
    parameters_filter_enable_measurements_response, 1,
    sizeof(struct mip_filter_enable_measurements_response)};

static const struct mip_parameter parameters_filter_mag_noise_response[] = {
    {"noise", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_mag_noise_response, noise), 0, NONE},
};
static const struct mip_record record_filter_mag_noise_response = {
    parameters_filter_mag_noise_response, 1, sizeof(struct mip_filter_mag_noise_response)};

static const struct mip_parameter parameters_filter_magnetic_declination_source_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_magnetic_declination_source_response, source), 0,
     &mip_names_filter_mag_parameter_source, NULL, NULL, NULL, 0},
    {"declination", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_magnetic_declination_source_response, declination), 0, NONE},
};
static const struct mip_record record_filter_magnetic_declination_source_response = {
    parameters_filter_magnetic_declination_source_response, 2,
    sizeof(struct mip_filter_magnetic_declination_source_response)};

static const struct mip_parameter parameters_filter_accel_magnitude_adaptive_response[] = {
    {"adaptive_measurement", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, adaptive_measurement), 0,
     &mip_names_filter_adaptive_measurement_selector, NULL, NULL, NULL, 0},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, frequency), 0, NONE},
    {"low_limit", "m/s^2", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, low_limit), 0, NONE},
    {"high_limit", "m/s^2", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, high_limit), 0, NONE},
    {"low_limit_uncertainty", "m/s^2", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, low_limit_uncertainty), 0, NONE},
    {"high_limit_uncertainty", "m/s^2", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, high_limit_uncertainty), 0, NONE},
    {"minimum_uncertainty", "m/s^2", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_accel_magnitude_adaptive_response, minimum_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_accel_magnitude_adaptive_response = {
    parameters_filter_accel_magnitude_adaptive_response, 7,
    sizeof(struct mip_filter_accel_magnitude_adaptive_response)};

static const struct mip_parameter parameters_filter_mag_magnitude_adaptive_response[] = {
    {"adaptive_measurement", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, adaptive_measurement), 0,
     &mip_names_filter_adaptive_measurement_selector, NULL, NULL, NULL, 0},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, frequency), 0, NONE},
    {"low_limit", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, low_limit), 0, NONE},
    {"high_limit", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, high_limit), 0, NONE},
    {"low_limit_uncertainty", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, low_limit_uncertainty), 0, NONE},
    {"high_limit_uncertainty", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, high_limit_uncertainty), 0, NONE},
    {"minimum_uncertainty", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_magnitude_adaptive_response, minimum_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_mag_magnitude_adaptive_response = {
    parameters_filter_mag_magnitude_adaptive_response, 7,
    sizeof(struct mip_filter_mag_magnitude_adaptive_response)};

static const struct mip_parameter parameters_filter_mag_dip_angle_adaptive_response[] = {
    {"enable", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive_response, enable), 0, NONE},
    {"frequency", "Hz", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive_response, frequency), 0, NONE},
    {"high_limit", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive_response, high_limit), 0, NONE},
    {"high_limit_uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive_response, high_limit_uncertainty), 0, NONE},
    {"minimum_uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_mag_dip_angle_adaptive_response, minimum_uncertainty), 0, NONE},
};
static const struct mip_record record_filter_mag_dip_angle_adaptive_response = {
    parameters_filter_mag_dip_angle_adaptive_response, 5,
    sizeof(struct mip_filter_mag_dip_angle_adaptive_response)};

static const struct mip_parameter parameters_filter_altitude_aiding_response[] = {
    {"selector", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_altitude_aiding_response, selector),
     0, &mip_names_filter_altitude_aiding_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_altitude_aiding_response = {
    parameters_filter_altitude_aiding_response, 1,
    sizeof(struct mip_filter_altitude_aiding_response)};

static const struct mip_parameter parameters_filter_pitch_roll_aiding_response[] = {
    {"aiding", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_pitch_roll_aiding_response, aiding),
     0, &mip_names_filter_pitch_roll_aiding_source, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_pitch_roll_aiding_response = {
    parameters_filter_pitch_roll_aiding_response, 1,
    sizeof(struct mip_filter_pitch_roll_aiding_response)};

static const struct mip_parameter parameters_filter_magnetic_inclination_source_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_magnetic_inclination_source_response, source), 0,
     &mip_names_filter_mag_parameter_source, NULL, NULL, NULL, 0},
    {"inclination", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_magnetic_inclination_source_response, inclination), 0, NONE},
};
static const struct mip_record record_filter_magnetic_inclination_source_response = {
    parameters_filter_magnetic_inclination_source_response, 2,
    sizeof(struct mip_filter_magnetic_inclination_source_response)};

static const struct mip_parameter parameters_filter_magnetic_magnitude_source_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_magnetic_magnitude_source_response, source), 0,
     &mip_names_filter_mag_parameter_source, NULL, NULL, NULL, 0},
    {"magnitude", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_magnetic_magnitude_source_response, magnitude), 0, NONE},
};
static const struct mip_record record_filter_magnetic_magnitude_source_response = {
    parameters_filter_magnetic_magnitude_source_response, 2,
    sizeof(struct mip_filter_magnetic_magnitude_source_response)};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_rotation_dcm_response[] = {
    {"dcm", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_rotation_dcm_response, dcm), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_rotation_dcm_response = {
    parameters_filter_sensor_to_vehicle_rotation_dcm_response, 1,
    sizeof(struct mip_filter_sensor_to_vehicle_rotation_dcm_response)};

static const struct mip_parameter parameters_filter_sensor_to_vehicle_quaternion_response[] = {
    {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(struct mip_filter_sensor_to_vehicle_quaternion_response, q), 0, NONE},
};
static const struct mip_record record_filter_sensor_to_vehicle_quaternion_response = {
    parameters_filter_sensor_to_vehicle_quaternion_response, 1,
    sizeof(struct mip_filter_sensor_to_vehicle_quaternion_response)};

static const struct mip_parameter parameters_filter_aiding_measurement_enable_response[] = {
    {"aiding_source", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_aiding_measurement_enable_response, aiding_source), 0,
     &mip_names_filter_aiding_source, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_filter_aiding_measurement_enable_response, enable), 0, NONE},
};
static const struct mip_record record_filter_aiding_measurement_enable_response = {
    parameters_filter_aiding_measurement_enable_response, 2,
    sizeof(struct mip_filter_aiding_measurement_enable_response)};

static const struct mip_parameter parameters_filter_kinematic_constraint_response[] = {
    {"accel_constraint", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_kinematic_constraint_response, accel_constraint), 0,
     &mip_names_filter_accel_constraint, NULL, NULL, NULL, 0},
    {"velocity_constraint", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_kinematic_constraint_response, velocity_constraint), 0,
     &mip_names_filter_velocity_constraint, NULL, NULL, NULL, 0},
    {"angular_constraint", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_kinematic_constraint_response, angular_constraint), 0,
     &mip_names_filter_angular_constraint, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_kinematic_constraint_response = {
    parameters_filter_kinematic_constraint_response, 3,
    sizeof(struct mip_filter_kinematic_constraint_response)};

static const struct mip_parameter parameters_filter_initialization_config_response[] = {
    {"wait_for_run_command", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, wait_for_run_command), 0, NONE},
    {"initial_condition_source", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, initial_condition_source), 0,
     &mip_names_filter_initial_condition_source, NULL, NULL, NULL, 0},
    {"auto_heading_alignment_selector", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, auto_heading_alignment_selector), 0,
     &mip_names_filter_heading_alignment, NULL, NULL, NULL, 0},
    {"initial_heading", "deg", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, initial_heading), 0, NONE},
    {"initial_pitch", "deg", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, initial_pitch), 0, NONE},
    {"initial_roll", "deg", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, initial_roll), 0, NONE},
    {"initial_position", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, initial_position), 0, NONE},
    {"initial_velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, initial_velocity), 0, NONE},
    {"reference_frame_selector", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_initialization_config_response, reference_frame_selector), 0,
     &mip_names_filter_reference_frame, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_initialization_config_response = {
    parameters_filter_initialization_config_response, 9,
    sizeof(struct mip_filter_initialization_config_response)};

static const struct mip_parameter parameters_filter_adaptive_filter_options_response[] = {
    {"level", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_adaptive_filter_options_response, level), 0,
     &mip_names_filter_adaptive_level, NULL, NULL, NULL, 0},
    {"time_limit", "ms", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_adaptive_filter_options_response, time_limit), 0, NONE},
};
static const struct mip_record record_filter_adaptive_filter_options_response = {
    parameters_filter_adaptive_filter_options_response, 2,
    sizeof(struct mip_filter_adaptive_filter_options_response)};

static const struct mip_parameter parameters_filter_multi_antenna_offset_response[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_multi_antenna_offset_response, receiver_id), 0, NONE},
    {"antenna_offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_multi_antenna_offset_response, antenna_offset), 0, NONE},
};
static const struct mip_record record_filter_multi_antenna_offset_response = {
    parameters_filter_multi_antenna_offset_response, 2,
    sizeof(struct mip_filter_multi_antenna_offset_response)};

static const struct mip_parameter parameters_filter_relative_position_config_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_relative_position_config_response, source), 0,
     &mip_names_filter_relative_position_source, NULL, NULL, NULL, 0},
    {"reference_frame_selector", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_relative_position_config_response, reference_frame_selector), 0,
     &mip_names_filter_reference_frame, NULL, NULL, NULL, 0},
    {"reference_coordinates", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_relative_position_config_response, reference_coordinates), 0, NONE},
};
static const struct mip_record record_filter_relative_position_config_response = {
    parameters_filter_relative_position_config_response, 3,
    sizeof(struct mip_filter_relative_position_config_response)};

static const struct mip_parameter parameters_filter_reference_point_lever_arm_response[] = {
    {"reference_point", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_reference_point_lever_arm_response, reference_point), 0,
     &mip_names_filter_reference_point, NULL, NULL, NULL, 0},
    {"lever_arm_offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_reference_point_lever_arm_response, lever_arm_offset), 0, NONE},
};
static const struct mip_record record_filter_reference_point_lever_arm_response = {
    parameters_filter_reference_point_lever_arm_response, 2,
    sizeof(struct mip_filter_reference_point_lever_arm_response)};

static const struct mip_parameter parameters_filter_speed_lever_arm_response[] = {
    {"source", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_speed_lever_arm_response, source), 0,
     NONE},
    {"lever_arm_offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_speed_lever_arm_response, lever_arm_offset), 0, NONE},
};
static const struct mip_record record_filter_speed_lever_arm_response = {
    parameters_filter_speed_lever_arm_response, 2,
    sizeof(struct mip_filter_speed_lever_arm_response)};

static const struct mip_parameter parameters_filter_vertical_gyro_constraint_control_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_vertical_gyro_constraint_control_response, enable), 0, NONE},
};
static const struct mip_record record_filter_vertical_gyro_constraint_control_response = {
    parameters_filter_vertical_gyro_constraint_control_response, 1,
    sizeof(struct mip_filter_vertical_gyro_constraint_control_response)};

static const struct mip_parameter parameters_filter_wheeled_vehicle_constraint_control_response[] =
    {
        {"enable", "", NUMBER(U8), 0, 0, 0,
         ONE(struct mip_filter_wheeled_vehicle_constraint_control_response, enable), 0, NONE},
};
static const struct mip_record record_filter_wheeled_vehicle_constraint_control_response = {
    parameters_filter_wheeled_vehicle_constraint_control_response, 1,
    sizeof(struct mip_filter_wheeled_vehicle_constraint_control_response)};

static const struct mip_parameter parameters_filter_gnss_antenna_calibration_control_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_gnss_antenna_calibration_control_response, enable), 0, NONE},
    {"max_offset", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_gnss_antenna_calibration_control_response, max_offset), 0, NONE},
};
static const struct mip_record record_filter_gnss_antenna_calibration_control_response = {
    parameters_filter_gnss_antenna_calibration_control_response, 2,
    sizeof(struct mip_filter_gnss_antenna_calibration_control_response)};

static const struct mip_record record_gnss_receiver_info = {NULL, 0,
                                                            sizeof(struct mip_gnss_receiver_info)};

static const struct mip_parameter parameters_gnss_signal_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_signal_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"gps_enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_gnss_signal_config, gps_enable), 0,
     &mip_names_gnss_gps_signals, NULL, NULL, NULL, 0},
    {"glonass_enable", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_gnss_signal_config, glonass_enable),
     0, &mip_names_gnss_glonass_signals, NULL, NULL, NULL, 0},
    {"galileo_enable", "", NUMBER(U8), 0, 3, 0, ONE(struct mip_gnss_signal_config, galileo_enable),
     0, &mip_names_gnss_galileo_signals, NULL, NULL, NULL, 0},
    {"beidou_enable", "", NUMBER(U8), 0, 4, 0, ONE(struct mip_gnss_signal_config, beidou_enable), 0,
     &mip_names_gnss_beidou_signals, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 4, 1, 0, 5, 0,
     MANY(struct mip_gnss_signal_config, reserved), 0, NONE},
};
static const struct mip_record record_gnss_signal_config = {parameters_gnss_signal_config, 6,
                                                            sizeof(struct mip_gnss_signal_config)};
static const uint8_t required_gnss_signal_config[] = {0, 5, 0, 0, 0, 0};

static const struct mip_parameter parameters_gnss_receiver_reset[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_receiver_reset, receiver_id), 0,
     &mip_names_gnss_receiver_id, NULL, NULL, NULL, 0},
    {"reset_type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_receiver_reset, reset_type), 0,
     &mip_names_gnss_receiver_reset_type, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_receiver_reset = {
    parameters_gnss_receiver_reset, 2, sizeof(struct mip_gnss_receiver_reset)};

static const struct mip_parameter parameters_gnss_rtk_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_rtk_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"ambiguity_fix_mode", "", NUMBER(U8), 0, 1, 0,
     ONE(struct mip_gnss_rtk_config, ambiguity_fix_mode), 0, &mip_names_gnss_ambiguity_fix_mode,
     NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 4, 1, 0, 2, 0,
     MANY(struct mip_gnss_rtk_config, reserved), 0, NONE},
};
static const struct mip_record record_gnss_rtk_config = {parameters_gnss_rtk_config, 3,
                                                         sizeof(struct mip_gnss_rtk_config)};
static const uint8_t required_gnss_rtk_config[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_gnss_rtk_dongle_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_rtk_dongle_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_gnss_rtk_dongle_config, enable), 0, NONE},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 3, 1, 0, 2, 0,
     MANY(struct mip_gnss_rtk_dongle_config, reserved), 0, NONE},
};
static const struct mip_record record_gnss_rtk_dongle_config = {
    parameters_gnss_rtk_dongle_config, 3, sizeof(struct mip_gnss_rtk_dongle_config)};
static const uint8_t required_gnss_rtk_dongle_config[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_gnss_spartn_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_spartn_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"enable", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_gnss_spartn_config, enable), 0, NONE},
    {"type", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_gnss_spartn_config, type), 0,
     &mip_names_gnss_spartn_connection, NULL, NULL, NULL, 0},
    {"current_key_tow", "s", NUMBER(U32), 0, 3, 0,
     ONE(struct mip_gnss_spartn_config, current_key_tow), 0, NONE},
    {"current_key_week", "week", NUMBER(U16), 0, 4, 0,
     ONE(struct mip_gnss_spartn_config, current_key_week), 0, NONE},
    {"current_key", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 5, 0,
     MANY(struct mip_gnss_spartn_config, current_key), 0, NONE},
    {"next_key_tow", "s", NUMBER(U32), 0, 6, 0, ONE(struct mip_gnss_spartn_config, next_key_tow), 0,
     NONE},
    {"next_key_week", "week", NUMBER(U16), 0, 7, 0,
     ONE(struct mip_gnss_spartn_config, next_key_week), 0, NONE},
    {"next_key", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 8, 0,
     MANY(struct mip_gnss_spartn_config, next_key), 0, NONE},
};
static const struct mip_record record_gnss_spartn_config = {parameters_gnss_spartn_config, 9,
                                                            sizeof(struct mip_gnss_spartn_config)};
static const uint8_t required_gnss_spartn_config[] = {0, 8, 0, 0, 0, 0};

static const struct mip_parameter parameters_gnss_receiver_safe_mode[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_receiver_safe_mode, receiver_id),
     0, NONE},
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_receiver_safe_mode, enable), 0, NONE},
};
static const struct mip_record record_gnss_receiver_safe_mode = {
    parameters_gnss_receiver_safe_mode, 2, sizeof(struct mip_gnss_receiver_safe_mode)};

static const struct mip_parameter parameters_gnss_receiver_info_response[] = {
    {"num_receivers", "", MIP_KIND_COUNTER, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_gnss_receiver_info_response, num_receivers), 0, NONE},
    {"receiver_info", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_COUNTED, 7, 1, 0, 0, 0,
     MANY(struct mip_gnss_receiver_info_response, receiver_info), 0, NULL, NULL,
     &record_gnss_receiver_info_entry, NULL, 0},
};
static const struct mip_record record_gnss_receiver_info_response = {
    parameters_gnss_receiver_info_response, 2, sizeof(struct mip_gnss_receiver_info_response)};

static const struct mip_parameter parameters_gnss_signal_config_response[] = {
    {"gps_enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_signal_config_response, gps_enable),
     0, &mip_names_gnss_gps_signals, NULL, NULL, NULL, 0},
    {"glonass_enable", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_signal_config_response, glonass_enable), 0,
     &mip_names_gnss_glonass_signals, NULL, NULL, NULL, 0},
    {"galileo_enable", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_signal_config_response, galileo_enable), 0,
     &mip_names_gnss_galileo_signals, NULL, NULL, NULL, 0},
    {"beidou_enable", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_signal_config_response, beidou_enable), 0, &mip_names_gnss_beidou_signals,
     NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_signal_config_response, reserved), 0, NONE},
};
static const struct mip_record record_gnss_signal_config_response = {
    parameters_gnss_signal_config_response, 5, sizeof(struct mip_gnss_signal_config_response)};

static const struct mip_parameter parameters_gnss_rtk_config_response[] = {
    {"ambiguity_fix_mode", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_rtk_config_response, ambiguity_fix_mode), 0,
     &mip_names_gnss_ambiguity_fix_mode, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_rtk_config_response, reserved), 0, NONE},
};
static const struct mip_record record_gnss_rtk_config_response = {
    parameters_gnss_rtk_config_response, 2, sizeof(struct mip_gnss_rtk_config_response)};

static const struct mip_parameter parameters_gnss_rtk_dongle_config_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_rtk_dongle_config_response, enable), 0,
     NONE},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 3, 1, 0, 0, 0,
     MANY(struct mip_gnss_rtk_dongle_config_response, reserved), 0, NONE},
};
static const struct mip_record record_gnss_rtk_dongle_config_response = {
    parameters_gnss_rtk_dongle_config_response, 2,
    sizeof(struct mip_gnss_rtk_dongle_config_response)};

static const struct mip_parameter parameters_gnss_spartn_config_response[] = {
    {"enable", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_spartn_config_response, enable), 0,
     NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_spartn_config_response, type), 0,
     &mip_names_gnss_spartn_connection, NULL, NULL, NULL, 0},
    {"current_key_tow", "s", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_gnss_spartn_config_response, current_key_tow), 0, NONE},
    {"current_key_week", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_spartn_config_response, current_key_week), 0, NONE},
    {"current_key", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_gnss_spartn_config_response, current_key), 0, NONE},
    {"next_key_tow", "s", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_gnss_spartn_config_response, next_key_tow), 0, NONE},
    {"next_key_week", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_spartn_config_response, next_key_week), 0, NONE},
    {"next_key", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_gnss_spartn_config_response, next_key), 0, NONE},
};
static const struct mip_record record_gnss_spartn_config_response = {
    parameters_gnss_spartn_config_response, 8, sizeof(struct mip_gnss_spartn_config_response)};

static const struct mip_record record_rtk_get_status_flags = {
    NULL, 0, sizeof(struct mip_rtk_get_status_flags)};

static const struct mip_record record_rtk_get_imei = {NULL, 0, sizeof(struct mip_rtk_get_imei)};

static const struct mip_record record_rtk_get_imsi = {NULL, 0, sizeof(struct mip_rtk_get_imsi)};

static const struct mip_record record_rtk_get_iccid = {NULL, 0, sizeof(struct mip_rtk_get_iccid)};

static const struct mip_record record_rtk_get_rssi = {NULL, 0, sizeof(struct mip_rtk_get_rssi)};

static const struct mip_parameter parameters_rtk_connected_device_type[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_rtk_connected_device_type, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"device_type", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_rtk_connected_device_type, device_type),
     0, &mip_names_rtk_connected_device, NULL, NULL, NULL, 0},
};
static const struct mip_record record_rtk_connected_device_type = {
    parameters_rtk_connected_device_type, 2, sizeof(struct mip_rtk_connected_device_type)};
static const uint8_t required_rtk_connected_device_type[] = {0, 1, 0, 0, 0, 0};

static const struct mip_record record_rtk_get_activation_code = {
    NULL, 0, sizeof(struct mip_rtk_get_activation_code)};

static const struct mip_record record_rtk_get_modem_firmware_version = {
    NULL, 0, sizeof(struct mip_rtk_get_modem_firmware_version)};

static const struct mip_parameter parameters_rtk_service_status[] = {
    {"reserved1", "", NUMBER(U32), 0, 0, 0, ONE(struct mip_rtk_service_status, reserved1), 0, NONE},
    {"reserved2", "", NUMBER(U32), 0, 0, 0, ONE(struct mip_rtk_service_status, reserved2), 0, NONE},
};
static const struct mip_record record_rtk_service_status = {parameters_rtk_service_status, 2,
                                                            sizeof(struct mip_rtk_service_status)};

static const struct mip_parameter parameters_rtk_erase_storage[] = {
    {"media", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_rtk_erase_storage, media), 0,
     &mip_names_rtk_storage_medium, NULL, NULL, NULL, 0},
};
static const struct mip_record record_rtk_erase_storage = {parameters_rtk_erase_storage, 1,
                                                           sizeof(struct mip_rtk_erase_storage)};

static const struct mip_parameter parameters_rtk_led_control[] = {
    {"primary_color", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 3, 1, 0, 0, 0,
     MANY(struct mip_rtk_led_control, primary_color), 0, NONE},
    {"alternate_color", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 3, 1, 0, 0, 0,
     MANY(struct mip_rtk_led_control, alternate_color), 0, NONE},
    {"action", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_rtk_led_control, action), 0,
     &mip_names_rtk_led_action, NULL, NULL, NULL, 0},
    {"period", "", NUMBER(U32), 0, 0, 0, ONE(struct mip_rtk_led_control, period), 0, NONE},
};
static const struct mip_record record_rtk_led_control = {parameters_rtk_led_control, 4,
                                                         sizeof(struct mip_rtk_led_control)};

static const struct mip_record record_rtk_modem_hard_reset = {
    NULL, 0, sizeof(struct mip_rtk_modem_hard_reset)};

static const struct mip_parameter parameters_rtk_get_status_flags_response[] = {
    {"flags", "", NUMBER(U32), 0, 0, 0, ONE(struct mip_rtk_get_status_flags_response, flags), 0,
     &mip_names_rtk_status_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_rtk_get_status_flags_response = {
    parameters_rtk_get_status_flags_response, 1, sizeof(struct mip_rtk_get_status_flags_response)};

static const struct mip_parameter parameters_rtk_get_imei_response[] = {
    {"imei", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_rtk_get_imei_response, imei), 0, NONE},
};
static const struct mip_record record_rtk_get_imei_response = {
    parameters_rtk_get_imei_response, 1, sizeof(struct mip_rtk_get_imei_response)};

static const struct mip_parameter parameters_rtk_get_imsi_response[] = {
    {"imsi", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_rtk_get_imsi_response, imsi), 0, NONE},
};
static const struct mip_record record_rtk_get_imsi_response = {
    parameters_rtk_get_imsi_response, 1, sizeof(struct mip_rtk_get_imsi_response)};

static const struct mip_parameter parameters_rtk_get_iccid_response[] = {
    {"iccid", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_rtk_get_iccid_response, iccid), 0, NONE},
};
static const struct mip_record record_rtk_get_iccid_response = {
    parameters_rtk_get_iccid_response, 1, sizeof(struct mip_rtk_get_iccid_response)};

static const struct mip_parameter parameters_rtk_get_rssi_response[] = {
    {"valid", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_rtk_get_rssi_response, valid), 0, NONE},
    {"rssi", "", NUMBER(S32), 0, 0, 0, ONE(struct mip_rtk_get_rssi_response, rssi), 0, NONE},
    {"signal_quality", "", NUMBER(S32), 0, 0, 0,
     ONE(struct mip_rtk_get_rssi_response, signal_quality), 0, NONE},
};
static const struct mip_record record_rtk_get_rssi_response = {
    parameters_rtk_get_rssi_response, 3, sizeof(struct mip_rtk_get_rssi_response)};

static const struct mip_parameter parameters_rtk_connected_device_type_response[] = {
    {"device_type", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_rtk_connected_device_type_response, device_type), 0,
     &mip_names_rtk_connected_device, NULL, NULL, NULL, 0},
};
static const struct mip_record record_rtk_connected_device_type_response = {
    parameters_rtk_connected_device_type_response, 1,
    sizeof(struct mip_rtk_connected_device_type_response)};

static const struct mip_parameter parameters_rtk_get_activation_code_response[] = {
    {"activation_code", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_rtk_get_activation_code_response, activation_code), 0, NONE},
};
static const struct mip_record record_rtk_get_activation_code_response = {
    parameters_rtk_get_activation_code_response, 1,
    sizeof(struct mip_rtk_get_activation_code_response)};

static const struct mip_parameter parameters_rtk_get_modem_firmware_version_response[] = {
    {"modem_firmware_version", "", MIP_KIND_TEXT, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 32, 1, 0, 0, 0,
     MANY(struct mip_rtk_get_modem_firmware_version_response, modem_firmware_version), 0, NONE},
};
static const struct mip_record record_rtk_get_modem_firmware_version_response = {
    parameters_rtk_get_modem_firmware_version_response, 1,
    sizeof(struct mip_rtk_get_modem_firmware_version_response)};

static const struct mip_parameter parameters_rtk_service_status_response[] = {
    {"flags", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_rtk_service_status_response, flags), 0,
     &mip_names_rtk_service_flags, NULL, NULL, NULL, 0},
    {"received_bytes", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_rtk_service_status_response, received_bytes), 0, NONE},
    {"last_bytes", "byte", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_rtk_service_status_response, last_bytes), 0, NONE},
    {"last_bytes_time", "", NUMBER(U64), 0, 0, 0,
     ONE(struct mip_rtk_service_status_response, last_bytes_time), 0, NONE},
};
static const struct mip_record record_rtk_service_status_response = {
    parameters_rtk_service_status_response, 4, sizeof(struct mip_rtk_service_status_response)};

static const struct mip_record record_displacement_get_calibration = {
    NULL, 0, sizeof(struct mip_displacement_get_calibration)};

static const struct mip_parameter parameters_displacement_output_rate[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_displacement_output_rate, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
};
static const struct mip_record record_displacement_output_rate = {
    parameters_displacement_output_rate, 1, sizeof(struct mip_displacement_output_rate)};
static const uint8_t required_displacement_output_rate[] = {0, 0, 0};

static const struct mip_parameter parameters_displacement_device_time[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_displacement_device_time, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"time", "ns", NUMBER(U64), 0, 1, 0, ONE(struct mip_displacement_device_time, time), 0, NONE},
};
static const struct mip_record record_displacement_device_time = {
    parameters_displacement_device_time, 2, sizeof(struct mip_displacement_device_time)};
static const uint8_t required_displacement_device_time[] = {0, 1};

static const struct mip_parameter parameters_displacement_get_calibration_response[] = {
    {"slope", "", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_displacement_get_calibration_response, slope), 0, NONE},
    {"offset", "", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_displacement_get_calibration_response, offset), 0, NONE},
};
static const struct mip_record record_displacement_get_calibration_response = {
    parameters_displacement_get_calibration_response, 2,
    sizeof(struct mip_displacement_get_calibration_response)};

static const struct mip_parameter parameters_displacement_output_rate_response[] = {
    {"rate", "Hz", NUMBER(U32), 0, 0, 0, ONE(struct mip_displacement_output_rate_response, rate), 0,
     NONE},
};
static const struct mip_record record_displacement_output_rate_response = {
    parameters_displacement_output_rate_response, 1,
    sizeof(struct mip_displacement_output_rate_response)};

static const struct mip_parameter members_aiding_frame_config_rotation[] = {
    {"euler", "rad", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(union mip_aiding_frame_config_rotation, euler), 0, NONE},
    {"quaternion", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(union mip_aiding_frame_config_rotation, quaternion), 0, NONE},
};
static const struct mip_case cases_aiding_frame_config_rotation[] = {
    {1, &members_aiding_frame_config_rotation[0]},
    {2, &members_aiding_frame_config_rotation[1]},
};
static const struct mip_parameter parameters_aiding_frame_config[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_frame_config, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_aiding_frame_config, frame_id), 0, NONE},
    {"format", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_aiding_frame_config, format), 0,
     &mip_names_aiding_frame_format, NULL, NULL, NULL, 0},
    {"tracking_enabled", "", NUMBER(BOOL), 0, 3, 0,
     ONE(struct mip_aiding_frame_config, tracking_enabled), 0, NONE},
    {"translation", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 4, 0,
     ONE(struct mip_aiding_frame_config, translation), 0, NONE},
    {"rotation", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 2, 5, 0,
     ONE(struct mip_aiding_frame_config, rotation), 0, NULL, NULL, NULL,
     cases_aiding_frame_config_rotation, 2},
};
static const struct mip_record record_aiding_frame_config = {
    parameters_aiding_frame_config, 6, sizeof(struct mip_aiding_frame_config)};
static const uint8_t required_aiding_frame_config[] = {0, 5, 2, 1, 1, 1};

static const struct mip_parameter parameters_aiding_sensor_frame_map[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_sensor_frame_map, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"sensor_id", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_aiding_sensor_frame_map, sensor_id), 0,
     NONE},
    {"frame_id", "", NUMBER(U8), 0, 2, 0, ONE(struct mip_aiding_sensor_frame_map, frame_id), 0,
     NONE},
};
static const struct mip_record record_aiding_sensor_frame_map = {
    parameters_aiding_sensor_frame_map, 3, sizeof(struct mip_aiding_sensor_frame_map)};
static const uint8_t required_aiding_sensor_frame_map[] = {0, 2, 0, 0, 0, 0};

static const struct mip_parameter parameters_aiding_echo_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_echo_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"mode", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_aiding_echo_control, mode), 0,
     &mip_names_aiding_echo_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_echo_control = {
    parameters_aiding_echo_control, 2, sizeof(struct mip_aiding_echo_control)};
static const uint8_t required_aiding_echo_control[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_aiding_ecef_position[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_ecef_position, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_ecef_position, frame_id), 0, NONE},
    {"position", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_ecef_position, position), 0, NONE},
    {"uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_ecef_position, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_ecef_position, valid_flags), 0,
     &mip_names_aiding_axis_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_ecef_position = {
    parameters_aiding_ecef_position, 5, sizeof(struct mip_aiding_ecef_position)};

static const struct mip_parameter parameters_aiding_llh_position[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_llh_position, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_llh_position, frame_id), 0, NONE},
    {"latitude", "deg", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_aiding_llh_position, latitude), 0,
     NONE},
    {"longitude", "deg", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_aiding_llh_position, longitude), 0,
     NONE},
    {"height", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_aiding_llh_position, height), 0, NONE},
    {"uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_llh_position, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_llh_position, valid_flags), 0,
     &mip_names_aiding_llh_axis_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_llh_position = {
    parameters_aiding_llh_position, 7, sizeof(struct mip_aiding_llh_position)};

static const struct mip_parameter parameters_aiding_height_above_ellipsoid[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_height_above_ellipsoid, time), 0, NULL, NULL,
     &record_aiding_measurement_time, NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_height_above_ellipsoid, frame_id),
     0, NONE},
    {"height", "m", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_aiding_height_above_ellipsoid, height),
     0, NONE},
    {"uncertainty", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_aiding_height_above_ellipsoid, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_aiding_height_above_ellipsoid, valid_flags), 0, NONE},
};
static const struct mip_record record_aiding_height_above_ellipsoid = {
    parameters_aiding_height_above_ellipsoid, 5, sizeof(struct mip_aiding_height_above_ellipsoid)};

static const struct mip_parameter parameters_aiding_pressure_old[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_pressure_old, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_pressure_old, frame_id), 0, NONE},
    {"pressure", "mbar", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_aiding_pressure_old, pressure), 0,
     NONE},
    {"uncertainty", "mbar", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_aiding_pressure_old, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_pressure_old, valid_flags), 0,
     NONE},
};
static const struct mip_record record_aiding_pressure_old = {
    parameters_aiding_pressure_old, 5, sizeof(struct mip_aiding_pressure_old)};

static const struct mip_parameter parameters_aiding_ecef_velocity[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_ecef_velocity, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_ecef_velocity, frame_id), 0, NONE},
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_ecef_velocity, velocity), 0, NONE},
    {"uncertainty", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_ecef_velocity, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_ecef_velocity, valid_flags), 0,
     &mip_names_aiding_axis_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_ecef_velocity = {
    parameters_aiding_ecef_velocity, 5, sizeof(struct mip_aiding_ecef_velocity)};

static const struct mip_parameter parameters_aiding_ned_velocity[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_ned_velocity, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_ned_velocity, frame_id), 0, NONE},
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_ned_velocity, velocity), 0, NONE},
    {"uncertainty", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_ned_velocity, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_ned_velocity, valid_flags), 0,
     &mip_names_aiding_axis_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_ned_velocity = {
    parameters_aiding_ned_velocity, 5, sizeof(struct mip_aiding_ned_velocity)};

static const struct mip_parameter parameters_aiding_body_frame_velocity[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_body_frame_velocity, time), 0, NULL, NULL,
     &record_aiding_measurement_time, NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_body_frame_velocity, frame_id), 0,
     NONE},
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_body_frame_velocity, velocity), 0, NONE},
    {"uncertainty", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_body_frame_velocity, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_aiding_body_frame_velocity, valid_flags), 0, &mip_names_aiding_axis_flags, NULL,
     NULL, NULL, 0},
};
static const struct mip_record record_aiding_body_frame_velocity = {
    parameters_aiding_body_frame_velocity, 5, sizeof(struct mip_aiding_body_frame_velocity)};

static const struct mip_parameter parameters_aiding_true_heading[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_true_heading, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_true_heading, frame_id), 0, NONE},
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_aiding_true_heading, heading), 0,
     NONE},
    {"uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_aiding_true_heading, uncertainty),
     0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_true_heading, valid_flags), 0,
     NONE},
};
static const struct mip_record record_aiding_true_heading = {
    parameters_aiding_true_heading, 5, sizeof(struct mip_aiding_true_heading)};

static const struct mip_parameter parameters_aiding_magnetic_field[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_magnetic_field, time), 0, NULL, NULL, &record_aiding_measurement_time,
     NULL, 0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_magnetic_field, frame_id), 0, NONE},
    {"magnetic_field", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_magnetic_field, magnetic_field), 0, NONE},
    {"uncertainty", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_magnetic_field, uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_magnetic_field, valid_flags), 0,
     &mip_names_aiding_axis_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_magnetic_field = {
    parameters_aiding_magnetic_field, 5, sizeof(struct mip_aiding_magnetic_field)};

static const struct mip_parameter parameters_aiding_pressure[] = {
    {"time", "", MIP_KIND_STRUCT, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 0, 0, 0,
     ONE(struct mip_aiding_pressure, time), 0, NULL, NULL, &record_aiding_measurement_time, NULL,
     0},
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_pressure, frame_id), 0, NONE},
    {"pressure", "mbar", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_aiding_pressure, pressure), 0,
     NONE},
    {"uncertainty", "mbar", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_aiding_pressure, uncertainty), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_aiding_pressure, valid_flags), 0,
     NONE},
};
static const struct mip_record record_aiding_pressure = {parameters_aiding_pressure, 5,
                                                         sizeof(struct mip_aiding_pressure)};

static const struct mip_parameter members_aiding_frame_config_response_rotation[] = {
    {"euler", "rad", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(union mip_aiding_frame_config_rotation, euler), 0, NONE},
    {"quaternion", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(union mip_aiding_frame_config_rotation, quaternion), 0, NONE},
};
static const struct mip_case cases_aiding_frame_config_response_rotation[] = {
    {1, &members_aiding_frame_config_response_rotation[0]},
    {2, &members_aiding_frame_config_response_rotation[1]},
};
static const struct mip_parameter parameters_aiding_frame_config_response[] = {
    {"frame_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_frame_config_response, frame_id), 0,
     NONE},
    {"format", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_frame_config_response, format), 0,
     &mip_names_aiding_frame_format, NULL, NULL, NULL, 0},
    {"tracking_enabled", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_aiding_frame_config_response, tracking_enabled), 0, NONE},
    {"translation", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_aiding_frame_config_response, translation), 0, NONE},
    {"rotation", "", MIP_KIND_UNION, MIP_SCALAR_U8, MIP_LENGTH_ONE, 1, 1, 1, 0, 0,
     ONE(struct mip_aiding_frame_config_response, rotation), 0, NULL, NULL, NULL,
     cases_aiding_frame_config_response_rotation, 2},
};
static const struct mip_record record_aiding_frame_config_response = {
    parameters_aiding_frame_config_response, 5, sizeof(struct mip_aiding_frame_config_response)};

static const struct mip_parameter parameters_aiding_sensor_frame_map_response[] = {
    {"sensor_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_aiding_sensor_frame_map_response, sensor_id), 0, NONE},
    {"frame_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_aiding_sensor_frame_map_response, frame_id), 0, NONE},
};
static const struct mip_record record_aiding_sensor_frame_map_response = {
    parameters_aiding_sensor_frame_map_response, 2,
    sizeof(struct mip_aiding_sensor_frame_map_response)};

static const struct mip_parameter parameters_aiding_echo_control_response[] = {
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_aiding_echo_control_response, mode), 0,
     &mip_names_aiding_echo_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_aiding_echo_control_response = {
    parameters_aiding_echo_control_response, 1, sizeof(struct mip_aiding_echo_control_response)};

static const struct mip_parameter parameters_system_interface_control[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_system_interface_control, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"port", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_system_interface_control, port), 0,
     &mip_names_comm_interface, NULL, NULL, NULL, 0},
    {"protocols_incoming", "", NUMBER(U32), 0, 2, 0,
     ONE(struct mip_system_interface_control, protocols_incoming), 0,
     &mip_names_system_comm_protocols, NULL, NULL, NULL, 0},
    {"protocols_outgoing", "", NUMBER(U32), 0, 3, 0,
     ONE(struct mip_system_interface_control, protocols_outgoing), 0,
     &mip_names_system_comm_protocols, NULL, NULL, NULL, 0},
};
static const struct mip_record record_system_interface_control = {
    parameters_system_interface_control, 4, sizeof(struct mip_system_interface_control)};
static const uint8_t required_system_interface_control[] = {0, 3, 1, 1, 1, 1};

static const struct mip_parameter parameters_system_comm_mode[] = {
    {"function", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_system_comm_mode, function), 0,
     &mip_names_function_selector, NULL, NULL, NULL, 0},
    {"mode", "", NUMBER(U8), 0, 1, 0, ONE(struct mip_system_comm_mode, mode), 0,
     &mip_names_system_protocol_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_system_comm_mode = {parameters_system_comm_mode, 2,
                                                          sizeof(struct mip_system_comm_mode)};
static const uint8_t required_system_comm_mode[] = {0, 1, 0, 0, 0, 0};

static const struct mip_parameter parameters_system_interface_control_response[] = {
    {"port", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_system_interface_control_response, port), 0,
     &mip_names_comm_interface, NULL, NULL, NULL, 0},
    {"protocols_incoming", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_system_interface_control_response, protocols_incoming), 0,
     &mip_names_system_comm_protocols, NULL, NULL, NULL, 0},
    {"protocols_outgoing", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_system_interface_control_response, protocols_outgoing), 0,
     &mip_names_system_comm_protocols, NULL, NULL, NULL, 0},
};
static const struct mip_record record_system_interface_control_response = {
    parameters_system_interface_control_response, 3,
    sizeof(struct mip_system_interface_control_response)};

static const struct mip_parameter parameters_system_comm_mode_response[] = {
    {"mode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_system_comm_mode_response, mode), 0,
     &mip_names_system_protocol_mode, NULL, NULL, NULL, 0},
};
static const struct mip_record record_system_comm_mode_response = {
    parameters_system_comm_mode_response, 1, sizeof(struct mip_system_comm_mode_response)};

static const struct mip_parameter parameters_sensor_raw_accel[] = {
    {"raw_accel", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_raw_accel, raw_accel), 0, NONE},
};
static const struct mip_record record_sensor_raw_accel = {parameters_sensor_raw_accel, 1,
                                                          sizeof(struct mip_sensor_raw_accel)};

static const struct mip_parameter parameters_sensor_raw_gyro[] = {
    {"raw_gyro", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_raw_gyro, raw_gyro), 0, NONE},
};
static const struct mip_record record_sensor_raw_gyro = {parameters_sensor_raw_gyro, 1,
                                                         sizeof(struct mip_sensor_raw_gyro)};

static const struct mip_parameter parameters_sensor_raw_mag[] = {
    {"raw_mag", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_raw_mag, raw_mag), 0, NONE},
};
static const struct mip_record record_sensor_raw_mag = {parameters_sensor_raw_mag, 1,
                                                        sizeof(struct mip_sensor_raw_mag)};

static const struct mip_parameter parameters_sensor_scaled_accel[] = {
    {"scaled_accel", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_scaled_accel, scaled_accel), 0, NONE},
};
static const struct mip_record record_sensor_scaled_accel = {
    parameters_sensor_scaled_accel, 1, sizeof(struct mip_sensor_scaled_accel)};

static const struct mip_parameter parameters_sensor_scaled_gyro[] = {
    {"scaled_gyro", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_scaled_gyro, scaled_gyro), 0, NONE},
};
static const struct mip_record record_sensor_scaled_gyro = {parameters_sensor_scaled_gyro, 1,
                                                            sizeof(struct mip_sensor_scaled_gyro)};

static const struct mip_parameter parameters_sensor_scaled_mag[] = {
    {"scaled_mag", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_scaled_mag, scaled_mag), 0, NONE},
};
static const struct mip_record record_sensor_scaled_mag = {parameters_sensor_scaled_mag, 1,
                                                           sizeof(struct mip_sensor_scaled_mag)};

static const struct mip_parameter parameters_sensor_delta_theta[] = {
    {"delta_theta", "rad", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_delta_theta, delta_theta), 0, NONE},
};
static const struct mip_record record_sensor_delta_theta = {parameters_sensor_delta_theta, 1,
                                                            sizeof(struct mip_sensor_delta_theta)};

static const struct mip_parameter parameters_sensor_delta_velocity[] = {
    {"delta_velocity", "g*s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_delta_velocity, delta_velocity), 0, NONE},
};
static const struct mip_record record_sensor_delta_velocity = {
    parameters_sensor_delta_velocity, 1, sizeof(struct mip_sensor_delta_velocity)};

static const struct mip_parameter parameters_sensor_comp_orientation_matrix[] = {
    {"m", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_sensor_comp_orientation_matrix, m), 0, NONE},
};
static const struct mip_record record_sensor_comp_orientation_matrix = {
    parameters_sensor_comp_orientation_matrix, 1,
    sizeof(struct mip_sensor_comp_orientation_matrix)};

static const struct mip_parameter parameters_sensor_comp_quaternion[] = {
    {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(struct mip_sensor_comp_quaternion, q), 0, NONE},
};
static const struct mip_record record_sensor_comp_quaternion = {
    parameters_sensor_comp_quaternion, 1, sizeof(struct mip_sensor_comp_quaternion)};

static const struct mip_parameter parameters_sensor_comp_orientation_update_matrix[] = {
    {"m", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_sensor_comp_orientation_update_matrix, m), 0, NONE},
};
static const struct mip_record record_sensor_comp_orientation_update_matrix = {
    parameters_sensor_comp_orientation_update_matrix, 1,
    sizeof(struct mip_sensor_comp_orientation_update_matrix)};

static const struct mip_parameter parameters_sensor_comp_euler_angles[] = {
    {"roll", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_sensor_comp_euler_angles, roll), 0,
     NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_sensor_comp_euler_angles, pitch), 0,
     NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_sensor_comp_euler_angles, yaw), 0, NONE},
};
static const struct mip_record record_sensor_comp_euler_angles = {
    parameters_sensor_comp_euler_angles, 3, sizeof(struct mip_sensor_comp_euler_angles)};

static const struct mip_parameter parameters_sensor_orientation_raw_temperature[] = {
    {"raw_temperature", "1", MIP_KIND_NUMBER, MIP_SCALAR_U16, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_sensor_orientation_raw_temperature, raw_temperature), 0, NONE},
};
static const struct mip_record record_sensor_orientation_raw_temperature = {
    parameters_sensor_orientation_raw_temperature, 1,
    sizeof(struct mip_sensor_orientation_raw_temperature)};

static const struct mip_parameter parameters_sensor_internal_timestamp[] = {
    {"counts", "1", NUMBER(U32), 0, 0, 0, ONE(struct mip_sensor_internal_timestamp, counts), 0,
     NONE},
};
static const struct mip_record record_sensor_internal_timestamp = {
    parameters_sensor_internal_timestamp, 1, sizeof(struct mip_sensor_internal_timestamp)};

static const struct mip_parameter parameters_sensor_pps_timestamp[] = {
    {"seconds", "s", NUMBER(U32), 0, 0, 0, ONE(struct mip_sensor_pps_timestamp, seconds), 0, NONE},
    {"useconds", "us", NUMBER(U32), 0, 0, 0, ONE(struct mip_sensor_pps_timestamp, useconds), 0,
     NONE},
};
static const struct mip_record record_sensor_pps_timestamp = {
    parameters_sensor_pps_timestamp, 2, sizeof(struct mip_sensor_pps_timestamp)};

static const struct mip_parameter parameters_sensor_pps_timestamp_with_flags[] = {
    {"flags", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_sensor_pps_timestamp_with_flags, flags), 0,
     NONE},
    {"seconds", "s", NUMBER(U32), 0, 0, 0, ONE(struct mip_sensor_pps_timestamp_with_flags, seconds),
     0, NONE},
    {"nanoseconds", "ns", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_sensor_pps_timestamp_with_flags, nanoseconds), 0, NONE},
};
static const struct mip_record record_sensor_pps_timestamp_with_flags = {
    parameters_sensor_pps_timestamp_with_flags, 3,
    sizeof(struct mip_sensor_pps_timestamp_with_flags)};

static const struct mip_parameter parameters_sensor_north_vector[] = {
    {"stabilized_mag", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_north_vector, stabilized_mag), 0, NONE},
};
static const struct mip_record record_sensor_north_vector = {
    parameters_sensor_north_vector, 1, sizeof(struct mip_sensor_north_vector)};

static const struct mip_parameter parameters_sensor_up_vector[] = {
    {"stabilized_accel", "g", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_sensor_up_vector, stabilized_accel), 0, NONE},
};
static const struct mip_record record_sensor_up_vector = {parameters_sensor_up_vector, 1,
                                                          sizeof(struct mip_sensor_up_vector)};

static const struct mip_reading readings_sensor_gps_timestamp_valid_flags[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-cv5-15", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-cv5-25", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-cx5-10", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-cx5-15", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-cx5-25", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-cx5-45", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-dh3", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gq4-45", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx3-15", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx3-25", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx3-35", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx3-45", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx4-15", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx4-25", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx4-45", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx4-imu", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx5-15", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx5-25", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx5-35", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-gx5-45", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-mv5-ar", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-rq1-45-st", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
    {"3dm-rq1-imu", 0, 0, &mip_names_gx5_sensor_gps_timestamp_flags},
};
static const struct mip_parameter parameters_sensor_gps_timestamp[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_sensor_gps_timestamp, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0, ONE(struct mip_sensor_gps_timestamp, week_number),
     0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_sensor_gps_timestamp, valid_flags), 0,
     &mip_names_sensor_gps_timestamp_flags, readings_sensor_gps_timestamp_valid_flags, NULL, NULL,
     25},
};
static const struct mip_record record_sensor_gps_timestamp = {
    parameters_sensor_gps_timestamp, 3, sizeof(struct mip_sensor_gps_timestamp)};

static const struct mip_parameter parameters_sensor_temperature_statistics[] = {
    {"min_temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_sensor_temperature_statistics, min_temperature), 0, NONE},
    {"max_temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_sensor_temperature_statistics, max_temperature), 0, NONE},
    {"mean_temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_sensor_temperature_statistics, mean_temperature), 0, NONE},
};
static const struct mip_record record_sensor_temperature_statistics = {
    parameters_sensor_temperature_statistics, 3, sizeof(struct mip_sensor_temperature_statistics)};

static const struct mip_parameter parameters_sensor_raw_pressure[] = {
    {"raw_pressure", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_sensor_raw_pressure, raw_pressure),
     0, NONE},
};
static const struct mip_record record_sensor_raw_pressure = {
    parameters_sensor_raw_pressure, 1, sizeof(struct mip_sensor_raw_pressure)};

static const struct mip_parameter parameters_sensor_scaled_pressure[] = {
    {"scaled_pressure", "mbar", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_sensor_scaled_pressure, scaled_pressure), 0, NONE},
};
static const struct mip_record record_sensor_scaled_pressure = {
    parameters_sensor_scaled_pressure, 1, sizeof(struct mip_sensor_scaled_pressure)};

static const struct mip_parameter parameters_sensor_overrange_status[] = {
    {"status", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_sensor_overrange_status, status), 0,
     &mip_names_sensor_overrange_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_sensor_overrange_status = {
    parameters_sensor_overrange_status, 1, sizeof(struct mip_sensor_overrange_status)};

static const struct mip_parameter parameters_sensor_odometer[] = {
    {"speed", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_sensor_odometer, speed), 0, NONE},
    {"uncertainty", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_sensor_odometer, uncertainty), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_sensor_odometer, valid_flags), 0,
     &mip_names_sensor_odometer_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_sensor_odometer = {parameters_sensor_odometer, 3,
                                                         sizeof(struct mip_sensor_odometer)};

static const struct mip_parameter parameters_gnss_data_llh_position[] = {
    {"latitude", "deg", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_llh_position, latitude),
     0, NONE},
    {"longitude", "deg", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_llh_position, longitude),
     0, NONE},
    {"ellipsoid_height", "m", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_llh_position, ellipsoid_height), 0, NONE},
    {"msl_height", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_llh_position, msl_height),
     0, NONE},
    {"horizontal_accuracy", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_llh_position, horizontal_accuracy), 0, NONE},
    {"vertical_accuracy", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_llh_position, vertical_accuracy), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_llh_position, valid_flags),
     0, &mip_names_gnss_data_llh_position_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_llh_position = {
    parameters_gnss_data_llh_position, 7, sizeof(struct mip_gnss_data_llh_position)};

static const struct mip_parameter parameters_gnss_data_ecef_position[] = {
    {"position", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_ecef_position, position), 0, NONE},
    {"position_accuracy", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_ecef_position, position_accuracy), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_ecef_position, valid_flags),
     0, &mip_names_gnss_data_ecef_position_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_ecef_position = {
    parameters_gnss_data_ecef_position, 3, sizeof(struct mip_gnss_data_ecef_position)};

static const struct mip_parameter parameters_gnss_data_ned_velocity[] = {
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_ned_velocity, velocity), 0, NONE},
    {"speed", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_ned_velocity, speed), 0,
     NONE},
    {"ground_speed", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_ned_velocity, ground_speed), 0, NONE},
    {"heading", "deg", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_ned_velocity, heading), 0,
     NONE},
    {"speed_accuracy", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_ned_velocity, speed_accuracy), 0, NONE},
    {"heading_accuracy", "deg", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_ned_velocity, heading_accuracy), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_ned_velocity, valid_flags),
     0, &mip_names_gnss_data_ned_velocity_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_ned_velocity = {
    parameters_gnss_data_ned_velocity, 7, sizeof(struct mip_gnss_data_ned_velocity)};

static const struct mip_parameter parameters_gnss_data_ecef_velocity[] = {
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_ecef_velocity, velocity), 0, NONE},
    {"velocity_accuracy", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_ecef_velocity, velocity_accuracy), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_ecef_velocity, valid_flags),
     0, &mip_names_gnss_data_ecef_velocity_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_ecef_velocity = {
    parameters_gnss_data_ecef_velocity, 3, sizeof(struct mip_gnss_data_ecef_velocity)};

static const struct mip_parameter parameters_gnss_data_dop[] = {
    {"gdop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, gdop), 0, NONE},
    {"pdop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, pdop), 0, NONE},
    {"hdop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, hdop), 0, NONE},
    {"vdop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, vdop), 0, NONE},
    {"tdop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, tdop), 0, NONE},
    {"ndop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, ndop), 0, NONE},
    {"edop", "1", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dop, edop), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_dop, valid_flags), 0,
     &mip_names_gnss_data_dop_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_dop = {parameters_gnss_data_dop, 8,
                                                       sizeof(struct mip_gnss_data_dop)};

static const struct mip_parameter parameters_gnss_data_utc_time[] = {
    {"year", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, year), 0, NONE},
    {"month", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, month), 0, NONE},
    {"day", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, day), 0, NONE},
    {"hour", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, hour), 0, NONE},
    {"min", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, min), 0, NONE},
    {"sec", "s", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, sec), 0, NONE},
    {"msec", "ms", NUMBER(U32), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, msec), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_utc_time, valid_flags), 0,
     &mip_names_gnss_data_utc_time_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_utc_time = {parameters_gnss_data_utc_time, 8,
                                                            sizeof(struct mip_gnss_data_utc_time)};

static const struct mip_parameter parameters_gnss_data_gps_time[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_time, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_gps_time, week_number),
     0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_gps_time, valid_flags), 0,
     &mip_names_gnss_data_gps_time_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_gps_time = {parameters_gnss_data_gps_time, 3,
                                                            sizeof(struct mip_gnss_data_gps_time)};

static const struct mip_parameter parameters_gnss_data_clock_info[] = {
    {"bias", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_clock_info, bias), 0, NONE},
    {"drift", "s/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_clock_info, drift), 0, NONE},
    {"accuracy_estimate", "s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_clock_info, accuracy_estimate), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_clock_info, valid_flags), 0,
     &mip_names_gnss_data_clock_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_clock_info = {
    parameters_gnss_data_clock_info, 4, sizeof(struct mip_gnss_data_clock_info)};

static const struct mip_parameter parameters_gnss_data_fix_info[] = {
    {"fix_type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_fix_info, fix_type), 0,
     &mip_names_gnss_fix_type, NULL, NULL, NULL, 0},
    {"num_sv", "1", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_fix_info, num_sv), 0, NONE},
    {"fix_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_fix_info, fix_flags), 0,
     &mip_names_gnss_data_fix_flags, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_fix_info, valid_flags), 0,
     &mip_names_gnss_data_fix_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_fix_info = {parameters_gnss_data_fix_info, 4,
                                                            sizeof(struct mip_gnss_data_fix_info)};

static const struct mip_parameter parameters_gnss_data_sv_info[] = {
    {"channel", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sv_info, channel), 0, NONE},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sv_info, satellite_id), 0,
     NONE},
    {"carrier_noise_ratio", "dB-Hz", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_sv_info, carrier_noise_ratio), 0, NONE},
    {"azimuth", "deg", NUMBER(S16), 0, 0, 0, ONE(struct mip_gnss_data_sv_info, azimuth), 0, NONE},
    {"elevation", "deg", NUMBER(S16), 0, 0, 0, ONE(struct mip_gnss_data_sv_info, elevation), 0,
     NONE},
    {"sv_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_sv_info, sv_flags), 0,
     &mip_names_gnss_data_sv_flags, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_sv_info, valid_flags), 0,
     &mip_names_gnss_data_sv_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_sv_info = {parameters_gnss_data_sv_info, 7,
                                                           sizeof(struct mip_gnss_data_sv_info)};

static const struct mip_parameter parameters_gnss_data_hardware_status[] = {
    {"receiver_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_hardware_status, receiver_state), 0,
     &mip_names_gnss_data_receiver_state, NULL, NULL, NULL, 0},
    {"antenna_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_hardware_status, antenna_state), 0,
     &mip_names_gnss_data_antenna_state, NULL, NULL, NULL, 0},
    {"antenna_power", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_hardware_status, antenna_power), 0,
     &mip_names_gnss_data_antenna_power, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_hardware_status, valid_flags), 0,
     &mip_names_gnss_data_hardware_status_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_hardware_status = {
    parameters_gnss_data_hardware_status, 4, sizeof(struct mip_gnss_data_hardware_status)};

static const struct mip_parameter parameters_gnss_data_dgps_info[] = {
    {"age", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dgps_info, age), 0, NONE},
    {"base_station_id", "", NUMBER(S16), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_info, base_station_id), 0, NONE},
    {"base_station_status", "", NUMBER(S16), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_info, base_station_status), 0, NONE},
    {"num_channels", "1", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_dgps_info, num_channels),
     0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_dgps_info, valid_flags), 0,
     &mip_names_gnss_data_dgps_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_dgps_info = {
    parameters_gnss_data_dgps_info, 5, sizeof(struct mip_gnss_data_dgps_info)};

static const struct mip_parameter parameters_gnss_data_dgps_info_satellite[] = {
    {"satellite_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_info_satellite, satellite_id), 0, NONE},
    {"age", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dgps_info_satellite, age), 0,
     NONE},
    {"range_correction", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_info_satellite, range_correction), 0, NONE},
    {"range_rate_correction", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_info_satellite, range_rate_correction), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_info_satellite, valid_flags), 0,
     &mip_names_gnss_data_dgps_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_dgps_info_satellite = {
    parameters_gnss_data_dgps_info_satellite, 5, sizeof(struct mip_gnss_data_dgps_info_satellite)};

static const struct mip_parameter parameters_gnss_data_dgps_channel[] = {
    {"satellite_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_dgps_channel, satellite_id),
     0, NONE},
    {"age", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_dgps_channel, age), 0, NONE},
    {"range_correction", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_channel, range_correction), 0, NONE},
    {"range_rate_correction", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_dgps_channel, range_rate_correction), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_dgps_channel, valid_flags),
     0, &mip_names_gnss_data_dgps_channel_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_dgps_channel = {
    parameters_gnss_data_dgps_channel, 5, sizeof(struct mip_gnss_data_dgps_channel)};

static const struct mip_parameter parameters_gnss_data_clock_info_2[] = {
    {"bias", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_clock_info_2, bias), 0, NONE},
    {"drift", "s/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_clock_info_2, drift), 0,
     NONE},
    {"bias_accuracy_estimate", "s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_clock_info_2, bias_accuracy_estimate), 0, NONE},
    {"drift_accuracy_estimate", "s/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_clock_info_2, drift_accuracy_estimate), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_clock_info_2, valid_flags),
     0, &mip_names_gnss_data_clock_info_2_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_clock_info_2 = {
    parameters_gnss_data_clock_info_2, 5, sizeof(struct mip_gnss_data_clock_info_2)};

static const struct mip_parameter parameters_gnss_data_gps_leap_seconds[] = {
    {"leap_seconds", "s", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_leap_seconds, leap_seconds), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_leap_seconds, valid_flags), 0,
     &mip_names_gnss_data_gps_leap_seconds_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_gps_leap_seconds = {
    parameters_gnss_data_gps_leap_seconds, 2, sizeof(struct mip_gnss_data_gps_leap_seconds)};

static const struct mip_parameter parameters_gnss_data_sbas_info[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, week_number),
     0, NONE},
    {"sbas_system", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, sbas_system), 0,
     &mip_names_gnss_data_sbas_system, NULL, NULL, NULL, 0},
    {"sbas_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, sbas_id), 0, NONE},
    {"count", "1", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, count), 0, NONE},
    {"sbas_status", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, sbas_status), 0,
     &mip_names_gnss_data_sbas_status, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_sbas_info, valid_flags), 0,
     &mip_names_gnss_data_sbas_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_sbas_info = {
    parameters_gnss_data_sbas_info, 7, sizeof(struct mip_gnss_data_sbas_info)};

static const struct mip_parameter parameters_gnss_data_sbas_correction[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_correction, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_correction, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_sbas_correction, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_sbas_correction, week_number), 0, NONE},
    {"gnss_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_correction, gnss_id), 0,
     &mip_names_gnss_constellation, NULL, NULL, NULL, 0},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_sbas_correction, satellite_id), 0, NONE},
    {"udrei", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_sbas_correction, udrei), 0, NONE},
    {"pseudorange_correction", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_sbas_correction, pseudorange_correction), 0, NONE},
    {"iono_correction", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_sbas_correction, iono_correction), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_sbas_correction, valid_flags), 0,
     &mip_names_gnss_data_sbas_correction_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_sbas_correction = {
    parameters_gnss_data_sbas_correction, 10, sizeof(struct mip_gnss_data_sbas_correction)};

static const struct mip_parameter parameters_gnss_data_rf_error_detection[] = {
    {"rf_band", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_rf_error_detection, rf_band), 0,
     &mip_names_gnss_data_rf_band, NULL, NULL, NULL, 0},
    {"jamming_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_rf_error_detection, jamming_state), 0,
     &mip_names_gnss_data_jamming_state, NULL, NULL, NULL, 0},
    {"spoofing_state", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_rf_error_detection, spoofing_state), 0,
     &mip_names_gnss_data_spoofing_state, NULL, NULL, NULL, 0},
    {"frequency", "MHz", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_rf_error_detection, frequency), 0, NONE},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 2, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_rf_error_detection, reserved), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_rf_error_detection, valid_flags), 0,
     &mip_names_gnss_data_rf_error_detection_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_rf_error_detection = {
    parameters_gnss_data_rf_error_detection, 6, sizeof(struct mip_gnss_data_rf_error_detection)};

static const struct mip_parameter parameters_gnss_data_heading[] = {
    {"heading", "deg", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_heading, heading), 0, NONE},
    {"uncertainty", "deg", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_heading, uncertainty),
     0, NONE},
    {"fix_type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_heading, fix_type), 0,
     &mip_names_gnss_data_heading_fix_type, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_heading, valid_flags), 0,
     &mip_names_gnss_data_heading_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_heading = {parameters_gnss_data_heading, 4,
                                                           sizeof(struct mip_gnss_data_heading)};

static const struct mip_parameter parameters_gnss_data_satellite_status[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_satellite_status, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_satellite_status, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_satellite_status, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_satellite_status, week_number), 0, NONE},
    {"gnss_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_satellite_status, gnss_id), 0,
     &mip_names_gnss_constellation, NULL, NULL, NULL, 0},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_satellite_status, satellite_id), 0, NONE},
    {"elevation", "deg", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_satellite_status, elevation), 0, NONE},
    {"azimuth", "deg", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_satellite_status, azimuth),
     0, NONE},
    {"health", "", NUMBER(BOOL), 0, 0, 0, ONE(struct mip_gnss_data_satellite_status, health), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_satellite_status, valid_flags), 0,
     &mip_names_gnss_data_satellite_status_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_satellite_status = {
    parameters_gnss_data_satellite_status, 10, sizeof(struct mip_gnss_data_satellite_status)};

static const struct mip_parameter parameters_gnss_data_raw[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_raw, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_raw, week_number), 0,
     NONE},
    {"receiver_id", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_raw, receiver_id), 0, NONE},
    {"tracking_channel", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, tracking_channel),
     0, NONE},
    {"gnss_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, gnss_id), 0,
     &mip_names_gnss_constellation, NULL, NULL, NULL, 0},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, satellite_id), 0, NONE},
    {"signal_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, signal_id), 0,
     &mip_names_gnss_signal, NULL, NULL, NULL, 0},
    {"signal_strength", "dB-Hz", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_raw, signal_strength), 0, NONE},
    {"quality", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_raw, quality), 0,
     &mip_names_gnss_data_signal_quality, NULL, NULL, NULL, 0},
    {"pseudorange", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_raw, pseudorange), 0,
     NONE},
    {"carrier_phase", "cycle", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_raw, carrier_phase), 0, NONE},
    {"doppler", "Hz", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_raw, doppler), 0, NONE},
    {"range_uncertainty", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_raw, range_uncertainty), 0, NONE},
    {"phase_uncertainty", "cycle", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_raw, phase_uncertainty), 0, NONE},
    {"doppler_uncertainty", "Hz", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_raw, doppler_uncertainty), 0, NONE},
    {"lock_time", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_raw, lock_time), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_raw, valid_flags), 0,
     &mip_names_gnss_data_raw_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_raw = {parameters_gnss_data_raw, 19,
                                                       sizeof(struct mip_gnss_data_raw)};

static const struct mip_parameter parameters_gnss_data_base_station_info[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_base_station_info, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_base_station_info, week_number), 0, NONE},
    {"ecef_position", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_base_station_info, ecef_position), 0, NONE},
    {"height", "m", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_gnss_data_base_station_info, height), 0,
     NONE},
    {"station_id", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_base_station_info, station_id), 0, NONE},
    {"indicators", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_base_station_info, indicators), 0,
     &mip_names_gnss_data_base_station_indicators, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_base_station_info, valid_flags), 0,
     &mip_names_gnss_data_base_station_info_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_base_station_info = {
    parameters_gnss_data_base_station_info, 7, sizeof(struct mip_gnss_data_base_station_info)};

static const struct mip_parameter parameters_gnss_data_rtk_corrections_status[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_rtk_corrections_status, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, week_number), 0, NONE},
    {"epoch_status", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, epoch_status), 0,
     &mip_names_gnss_data_rtk_epoch_status, NULL, NULL, NULL, 0},
    {"dongle_status", "", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, dongle_status), 0,
     &mip_names_rtk_status_flags, NULL, NULL, NULL, 0},
    {"gps_correction_latency", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, gps_correction_latency), 0, NONE},
    {"glonass_correction_latency", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, glonass_correction_latency), 0, NONE},
    {"galileo_correction_latency", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, galileo_correction_latency), 0, NONE},
    {"beidou_correction_latency", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, beidou_correction_latency), 0, NONE},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U32, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_rtk_corrections_status, reserved), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_rtk_corrections_status, valid_flags), 0,
     &mip_names_gnss_data_rtk_corrections_status_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_rtk_corrections_status = {
    parameters_gnss_data_rtk_corrections_status, 10,
    sizeof(struct mip_gnss_data_rtk_corrections_status)};

static const struct mip_parameter parameters_gnss_data_gps_ephemeris[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, week_number), 0, NONE},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, satellite_id),
     0, NONE},
    {"health", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, health), 0, NONE},
    {"iodc", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, iodc), 0, NONE},
    {"iode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, iode), 0, NONE},
    {"t_oc", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, t_oc), 0, NONE},
    {"af0", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, af0), 0, NONE},
    {"af1", "s/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, af1), 0, NONE},
    {"af2", "s/s^2", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, af2), 0,
     NONE},
    {"t_gd", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, t_gd), 0, NONE},
    {"isc_l1ca", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, isc_l1ca), 0,
     NONE},
    {"isc_l2c", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, isc_l2c), 0,
     NONE},
    {"t_oe", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, t_oe), 0, NONE},
    {"a", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, a), 0, NONE},
    {"a_dot", "m/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, a_dot), 0,
     NONE},
    {"mean_anomaly", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, mean_anomaly), 0, NONE},
    {"delta_mean_motion", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, delta_mean_motion), 0, NONE},
    {"delta_mean_motion_dot", "rad/s^2", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, delta_mean_motion_dot), 0, NONE},
    {"eccentricity", "1", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, eccentricity), 0, NONE},
    {"argument_of_perigee", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, argument_of_perigee), 0, NONE},
    {"omega", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, omega), 0,
     NONE},
    {"omega_dot", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, omega_dot), 0, NONE},
    {"inclination", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, inclination), 0, NONE},
    {"inclination_dot", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_ephemeris, inclination_dot), 0, NONE},
    {"c_ic", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, c_ic), 0,
     NONE},
    {"c_is", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, c_is), 0,
     NONE},
    {"c_uc", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, c_uc), 0,
     NONE},
    {"c_us", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, c_us), 0,
     NONE},
    {"c_rc", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, c_rc), 0, NONE},
    {"c_rs", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, c_rs), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_gnss_data_gps_ephemeris, valid_flags),
     0, &mip_names_gnss_data_ephemeris_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_gps_ephemeris = {
    parameters_gnss_data_gps_ephemeris, 34, sizeof(struct mip_gnss_data_gps_ephemeris)};

static const struct mip_parameter parameters_gnss_data_glonass_ephemeris[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, week_number), 0, NONE},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, satellite_id), 0, NONE},
    {"frequency_number", "", NUMBER(S8), 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, frequency_number), 0, NONE},
    {"tk", "s", NUMBER(U32), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, tk), 0, NONE},
    {"tb", "s", NUMBER(U32), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, tb), 0, NONE},
    {"satellite_type", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, satellite_type), 0,
     &mip_names_gnss_data_glonass_satellite_type, NULL, NULL, NULL, 0},
    {"gamma", "1", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, gamma), 0,
     NONE},
    {"tau_n", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, tau_n), 0,
     NONE},
    {"position", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, position), 0, NONE},
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, velocity), 0, NONE},
    {"accel", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, accel), 0, NONE},
    {"health", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, health), 0,
     NONE},
    {"p", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, p), 0, NONE},
    {"nt", "day", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, nt), 0, NONE},
    {"delta_tau_n", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, delta_tau_n), 0, NONE},
    {"ft", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, ft), 0, NONE},
    {"en", "day", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, en), 0, NONE},
    {"p1", "min", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, p1), 0, NONE},
    {"p2", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, p2), 0, NONE},
    {"p3", "1", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, p3), 0, NONE},
    {"p4", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_glonass_ephemeris, p4), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_glonass_ephemeris, valid_flags), 0,
     &mip_names_gnss_data_glonass_ephemeris_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_glonass_ephemeris = {
    parameters_gnss_data_glonass_ephemeris, 25, sizeof(struct mip_gnss_data_glonass_ephemeris)};

static const struct mip_parameter parameters_gnss_data_galileo_ephemeris[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, week_number), 0, NONE},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, satellite_id), 0, NONE},
    {"health", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, health), 0,
     NONE},
    {"iodc", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, iodc), 0, NONE},
    {"iode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, iode), 0, NONE},
    {"t_oc", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, t_oc), 0,
     NONE},
    {"af0", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, af0), 0,
     NONE},
    {"af1", "s/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, af1), 0,
     NONE},
    {"af2", "s/s^2", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, af2), 0,
     NONE},
    {"t_gd", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, t_gd), 0,
     NONE},
    {"isc_l1ca", "s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, isc_l1ca), 0, NONE},
    {"isc_l2c", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, isc_l2c),
     0, NONE},
    {"t_oe", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, t_oe), 0,
     NONE},
    {"a", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, a), 0, NONE},
    {"a_dot", "m/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, a_dot), 0,
     NONE},
    {"mean_anomaly", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, mean_anomaly), 0, NONE},
    {"delta_mean_motion", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, delta_mean_motion), 0, NONE},
    {"delta_mean_motion_dot", "rad/s^2", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, delta_mean_motion_dot), 0, NONE},
    {"eccentricity", "1", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, eccentricity), 0, NONE},
    {"argument_of_perigee", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, argument_of_perigee), 0, NONE},
    {"omega", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, omega), 0,
     NONE},
    {"omega_dot", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, omega_dot), 0, NONE},
    {"inclination", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, inclination), 0, NONE},
    {"inclination_dot", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, inclination_dot), 0, NONE},
    {"c_ic", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, c_ic), 0,
     NONE},
    {"c_is", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, c_is), 0,
     NONE},
    {"c_uc", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, c_uc), 0,
     NONE},
    {"c_us", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, c_us), 0,
     NONE},
    {"c_rc", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, c_rc), 0,
     NONE},
    {"c_rs", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_ephemeris, c_rs), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_ephemeris, valid_flags), 0,
     &mip_names_gnss_data_ephemeris_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_galileo_ephemeris = {
    parameters_gnss_data_galileo_ephemeris, 34, sizeof(struct mip_gnss_data_galileo_ephemeris)};

static const struct mip_parameter parameters_gnss_data_beidou_ephemeris[] = {
    {"index", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, index), 0, NONE},
    {"count", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, count), 0, NONE},
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, week_number), 0, NONE},
    {"satellite_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, satellite_id), 0, NONE},
    {"health", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, health), 0,
     NONE},
    {"iodc", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, iodc), 0, NONE},
    {"iode", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, iode), 0, NONE},
    {"t_oc", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, t_oc), 0,
     NONE},
    {"af0", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, af0), 0, NONE},
    {"af1", "s/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, af1), 0,
     NONE},
    {"af2", "s/s^2", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, af2), 0,
     NONE},
    {"t_gd", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, t_gd), 0,
     NONE},
    {"isc_l1ca", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, isc_l1ca),
     0, NONE},
    {"isc_l2c", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, isc_l2c),
     0, NONE},
    {"t_oe", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, t_oe), 0,
     NONE},
    {"a", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, a), 0, NONE},
    {"a_dot", "m/s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, a_dot), 0,
     NONE},
    {"mean_anomaly", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, mean_anomaly), 0, NONE},
    {"delta_mean_motion", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, delta_mean_motion), 0, NONE},
    {"delta_mean_motion_dot", "rad/s^2", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, delta_mean_motion_dot), 0, NONE},
    {"eccentricity", "1", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, eccentricity), 0, NONE},
    {"argument_of_perigee", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, argument_of_perigee), 0, NONE},
    {"omega", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, omega), 0,
     NONE},
    {"omega_dot", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, omega_dot), 0, NONE},
    {"inclination", "rad", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, inclination), 0, NONE},
    {"inclination_dot", "rad/s", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, inclination_dot), 0, NONE},
    {"c_ic", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, c_ic), 0,
     NONE},
    {"c_is", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, c_is), 0,
     NONE},
    {"c_uc", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, c_uc), 0,
     NONE},
    {"c_us", "rad", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, c_us), 0,
     NONE},
    {"c_rc", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, c_rc), 0,
     NONE},
    {"c_rs", "m", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_ephemeris, c_rs), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_ephemeris, valid_flags), 0,
     &mip_names_gnss_data_ephemeris_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_beidou_ephemeris = {
    parameters_gnss_data_beidou_ephemeris, 34, sizeof(struct mip_gnss_data_beidou_ephemeris)};

static const struct mip_parameter parameters_gnss_data_gps_iono_correction[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_gps_iono_correction, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_iono_correction, week_number), 0, NONE},
    {"alpha", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_gps_iono_correction, alpha), 0, NONE},
    {"beta", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_gps_iono_correction, beta), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_gps_iono_correction, valid_flags), 0,
     &mip_names_gnss_data_gps_iono_correction_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_gps_iono_correction = {
    parameters_gnss_data_gps_iono_correction, 5, sizeof(struct mip_gnss_data_gps_iono_correction)};

static const struct mip_parameter parameters_gnss_data_galileo_iono_correction[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_galileo_iono_correction, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_iono_correction, week_number), 0, NONE},
    {"alpha", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 3, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_galileo_iono_correction, alpha), 0, NONE},
    {"disturbance_flags", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_iono_correction, disturbance_flags), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_galileo_iono_correction, valid_flags), 0,
     &mip_names_gnss_data_galileo_iono_correction_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_galileo_iono_correction = {
    parameters_gnss_data_galileo_iono_correction, 5,
    sizeof(struct mip_gnss_data_galileo_iono_correction)};

static const struct mip_parameter parameters_gnss_data_beidou_iono_correction[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_gnss_data_beidou_iono_correction, tow), 0,
     NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_iono_correction, week_number), 0, NONE},
    {"alpha", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_beidou_iono_correction, alpha), 0, NONE},
    {"beta", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 4, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_beidou_iono_correction, beta), 0, NONE},
    {"alpha_correction", "", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_FIXED, 9, 1, 0, 0, 0,
     MANY(struct mip_gnss_data_beidou_iono_correction, alpha_correction), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_gnss_data_beidou_iono_correction, valid_flags), 0,
     &mip_names_gnss_data_beidou_iono_correction_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_gnss_data_beidou_iono_correction = {
    parameters_gnss_data_beidou_iono_correction, 6,
    sizeof(struct mip_gnss_data_beidou_iono_correction)};

static const struct mip_parameter parameters_filter_data_llh_position[] = {
    {"latitude", "deg", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_filter_data_llh_position, latitude),
     0, NONE},
    {"longitude", "deg", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_data_llh_position, longitude), 0, NONE},
    {"ellipsoid_height", "m", NUMBER(DOUBLE), 0, 0, 0,
     ONE(struct mip_filter_data_llh_position, ellipsoid_height), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_llh_position, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_llh_position = {
    parameters_filter_data_llh_position, 4, sizeof(struct mip_filter_data_llh_position)};

static const struct mip_parameter parameters_filter_data_ned_velocity[] = {
    {"north", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_ned_velocity, north), 0,
     NONE},
    {"east", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_ned_velocity, east), 0,
     NONE},
    {"down", "m/s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_ned_velocity, down), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_ned_velocity, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ned_velocity = {
    parameters_filter_data_ned_velocity, 4, sizeof(struct mip_filter_data_ned_velocity)};

static const struct mip_parameter parameters_filter_data_attitude_quaternion[] = {
    {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(struct mip_filter_data_attitude_quaternion, q), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_attitude_quaternion, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_attitude_quaternion = {
    parameters_filter_data_attitude_quaternion, 2,
    sizeof(struct mip_filter_data_attitude_quaternion)};

static const struct mip_parameter parameters_filter_data_attitude_dcm[] = {
    {"dcm", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_filter_data_attitude_dcm, dcm), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_attitude_dcm, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_attitude_dcm = {
    parameters_filter_data_attitude_dcm, 2, sizeof(struct mip_filter_data_attitude_dcm)};

static const struct mip_parameter parameters_filter_data_euler_angles[] = {
    {"roll", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_euler_angles, roll), 0,
     NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_euler_angles, pitch), 0,
     NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_euler_angles, yaw), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_euler_angles, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_euler_angles = {
    parameters_filter_data_euler_angles, 4, sizeof(struct mip_filter_data_euler_angles)};

static const struct mip_parameter parameters_filter_data_gyro_bias[] = {
    {"bias", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_gyro_bias, bias), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_gyro_bias, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_gyro_bias = {
    parameters_filter_data_gyro_bias, 2, sizeof(struct mip_filter_data_gyro_bias)};

static const struct mip_parameter parameters_filter_data_accel_bias[] = {
    {"bias", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_accel_bias, bias), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_accel_bias, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_accel_bias = {
    parameters_filter_data_accel_bias, 2, sizeof(struct mip_filter_data_accel_bias)};

static const struct mip_parameter parameters_filter_data_llh_position_uncertainty[] = {
    {"north", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_llh_position_uncertainty, north), 0, NONE},
    {"east", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_llh_position_uncertainty, east), 0, NONE},
    {"down", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_llh_position_uncertainty, down), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_llh_position_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_llh_position_uncertainty = {
    parameters_filter_data_llh_position_uncertainty, 4,
    sizeof(struct mip_filter_data_llh_position_uncertainty)};

static const struct mip_parameter parameters_filter_data_ned_velocity_uncertainty[] = {
    {"north", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_ned_velocity_uncertainty, north), 0, NONE},
    {"east", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_ned_velocity_uncertainty, east), 0, NONE},
    {"down", "m/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_ned_velocity_uncertainty, down), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_ned_velocity_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ned_velocity_uncertainty = {
    parameters_filter_data_ned_velocity_uncertainty, 4,
    sizeof(struct mip_filter_data_ned_velocity_uncertainty)};

static const struct mip_parameter parameters_filter_data_euler_angles_uncertainty[] = {
    {"roll", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_euler_angles_uncertainty, roll), 0, NONE},
    {"pitch", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_euler_angles_uncertainty, pitch), 0, NONE},
    {"yaw", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_euler_angles_uncertainty, yaw), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_euler_angles_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_euler_angles_uncertainty = {
    parameters_filter_data_euler_angles_uncertainty, 4,
    sizeof(struct mip_filter_data_euler_angles_uncertainty)};

static const struct mip_parameter parameters_filter_data_gyro_bias_uncertainty[] = {
    {"bias_uncertainty", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_gyro_bias_uncertainty, bias_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gyro_bias_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_gyro_bias_uncertainty = {
    parameters_filter_data_gyro_bias_uncertainty, 2,
    sizeof(struct mip_filter_data_gyro_bias_uncertainty)};

static const struct mip_parameter parameters_filter_data_accel_bias_uncertainty[] = {
    {"bias_uncertainty", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_accel_bias_uncertainty, bias_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_accel_bias_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_accel_bias_uncertainty = {
    parameters_filter_data_accel_bias_uncertainty, 2,
    sizeof(struct mip_filter_data_accel_bias_uncertainty)};

static const struct mip_parameter parameters_filter_data_linear_accel[] = {
    {"accel", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_linear_accel, accel), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_linear_accel, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_linear_accel = {
    parameters_filter_data_linear_accel, 2, sizeof(struct mip_filter_data_linear_accel)};

static const struct mip_parameter parameters_filter_data_comp_angular_rate[] = {
    {"gyro", "rad/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_comp_angular_rate, gyro), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_comp_angular_rate, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_comp_angular_rate = {
    parameters_filter_data_comp_angular_rate, 2, sizeof(struct mip_filter_data_comp_angular_rate)};

static const struct mip_parameter parameters_filter_data_wgs84_gravity_magnitude[] = {
    {"gravity_magnitude", "m/s^2", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_wgs84_gravity_magnitude, gravity_magnitude), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_wgs84_gravity_magnitude, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_wgs84_gravity_magnitude = {
    parameters_filter_data_wgs84_gravity_magnitude, 2,
    sizeof(struct mip_filter_data_wgs84_gravity_magnitude)};

static const struct mip_reading readings_filter_data_status_filter_state[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cv5-15", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cv5-25", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cv7-ahrs", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-cv7-ar", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-cv7-ins", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-cx5-10", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cx5-15", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cx5-25", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cx5-45", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-cx7-ar", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-cx7-ins", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-dh3", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gq4-45", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gq7", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-gv7-ar", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-gv7-ins", 0, 0, &mip_names_filter_data_cv7_filter_state},
    {"3dm-gx3-15", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx3-35", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx3-45", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx4-15", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx4-25", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx4-45", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx4-imu", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx5-15", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx5-25", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-gx5-45", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-mv5-ar", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-rq1-45-st", 0, 0, &mip_names_filter_data_gx5_filter_state},
    {"3dm-rq1-imu", 0, 0, &mip_names_filter_data_gx5_filter_state},
};
static const struct mip_reading readings_filter_data_status_dynamics_mode[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cv5-15", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cv5-25", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cv7-ahrs", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-cv7-ar", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-cv7-ins", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-cx5-10", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cx5-15", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cx5-25", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cx5-45", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-cx7-ar", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-cx7-ins", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-dh3", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gq4-45", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gq7", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-gv7-ar", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-gv7-ins", 0, 0, &mip_names_filter_data_cv7_dynamics_mode},
    {"3dm-gx3-15", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx3-35", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx3-45", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx4-15", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx4-25", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx4-45", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx4-imu", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx5-15", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx5-25", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-gx5-45", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-mv5-ar", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-rq1-45-st", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
    {"3dm-rq1-imu", 0, 0, &mip_names_filter_data_gx5_dynamics_mode},
};
static const struct mip_reading readings_filter_data_status_status_flags[] = {
    {"3dm-cv5-10", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cv5-15", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cv5-25", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cv7-ahrs", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-cv7-ar", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-cv7-ins", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-cx5-10", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cx5-15", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cx5-25", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cx5-45", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-cx7-ar", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-cx7-ins", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-dh3", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gq4-45", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gq7", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-gv7-ar", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-gv7-ins", 0, 0, &mip_names_filter_data_cv7_status_flags},
    {"3dm-gx3-15", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx3-35", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx3-45", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx4-15", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx4-25", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx4-45", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx4-imu", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx5-15", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx5-25", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-gx5-45", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-mv5-ar", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-rq1-45-lt", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-rq1-45-st", 0, 0, &mip_names_filter_data_gx5_status_flags},
    {"3dm-rq1-imu", 0, 0, &mip_names_filter_data_gx5_status_flags},
};
static const struct mip_parameter parameters_filter_data_status[] = {
    {"filter_state", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_status, filter_state), 0,
     NULL, readings_filter_data_status_filter_state, NULL, NULL, 34},
    {"dynamics_mode", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_status, dynamics_mode),
     0, NULL, readings_filter_data_status_dynamics_mode, NULL, NULL, 34},
    {"status_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_status, status_flags), 0,
     NULL, readings_filter_data_status_status_flags, NULL, NULL, 34},
};
static const struct mip_record record_filter_data_status = {parameters_filter_data_status, 3,
                                                            sizeof(struct mip_filter_data_status)};

static const struct mip_parameter parameters_filter_data_timestamp[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_filter_data_timestamp, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_timestamp, week_number), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_timestamp, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_timestamp = {
    parameters_filter_data_timestamp, 3, sizeof(struct mip_filter_data_timestamp)};

static const struct mip_parameter parameters_filter_data_quaternion_attitude_uncertainty[] = {
    {"q", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(struct mip_filter_data_quaternion_attitude_uncertainty, q), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_quaternion_attitude_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_quaternion_attitude_uncertainty = {
    parameters_filter_data_quaternion_attitude_uncertainty, 2,
    sizeof(struct mip_filter_data_quaternion_attitude_uncertainty)};

static const struct mip_parameter parameters_filter_data_gravity_vector[] = {
    {"gravity", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_gravity_vector, gravity), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gravity_vector, valid_flags), 0, &mip_names_filter_data_valid_flags,
     NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_gravity_vector = {
    parameters_filter_data_gravity_vector, 2, sizeof(struct mip_filter_data_gravity_vector)};

static const struct mip_parameter parameters_filter_data_heading_update_state[] = {
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_heading_update_state, heading), 0, NONE},
    {"heading_uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_heading_update_state, heading_uncertainty), 0, NONE},
    {"source", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_heading_update_state, source),
     0, &mip_names_filter_data_heading_source_flags, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_heading_update_state, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_heading_update_state = {
    parameters_filter_data_heading_update_state, 4,
    sizeof(struct mip_filter_data_heading_update_state)};

static const struct mip_parameter parameters_filter_data_magnetic_model[] = {
    {"intensity_north", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_magnetic_model, intensity_north), 0, NONE},
    {"intensity_east", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_magnetic_model, intensity_east), 0, NONE},
    {"intensity_down", "gauss", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_magnetic_model, intensity_down), 0, NONE},
    {"inclination", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_magnetic_model, inclination), 0, NONE},
    {"declination", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_magnetic_model, declination), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_magnetic_model, valid_flags), 0, &mip_names_filter_data_valid_flags,
     NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_magnetic_model = {
    parameters_filter_data_magnetic_model, 6, sizeof(struct mip_filter_data_magnetic_model)};

static const struct mip_parameter parameters_filter_data_gyro_scale_factor[] = {
    {"scale_factor", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_gyro_scale_factor, scale_factor), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gyro_scale_factor, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_gyro_scale_factor = {
    parameters_filter_data_gyro_scale_factor, 2, sizeof(struct mip_filter_data_gyro_scale_factor)};

static const struct mip_parameter parameters_filter_data_accel_scale_factor[] = {
    {"scale_factor", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_accel_scale_factor, scale_factor), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_accel_scale_factor, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_accel_scale_factor = {
    parameters_filter_data_accel_scale_factor, 2,
    sizeof(struct mip_filter_data_accel_scale_factor)};

static const struct mip_parameter parameters_filter_data_gyro_scale_factor_uncertainty[] = {
    {"scale_factor_uncertainty", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0,
     0, ONE(struct mip_filter_data_gyro_scale_factor_uncertainty, scale_factor_uncertainty), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gyro_scale_factor_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_gyro_scale_factor_uncertainty = {
    parameters_filter_data_gyro_scale_factor_uncertainty, 2,
    sizeof(struct mip_filter_data_gyro_scale_factor_uncertainty)};

static const struct mip_parameter parameters_filter_data_accel_scale_factor_uncertainty[] = {
    {"scale_factor_uncertainty", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0,
     0, ONE(struct mip_filter_data_accel_scale_factor_uncertainty, scale_factor_uncertainty), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_accel_scale_factor_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_accel_scale_factor_uncertainty = {
    parameters_filter_data_accel_scale_factor_uncertainty, 2,
    sizeof(struct mip_filter_data_accel_scale_factor_uncertainty)};

static const struct mip_parameter parameters_filter_data_mag_bias[] = {
    {"bias", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_mag_bias, bias), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_mag_bias, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_bias = {
    parameters_filter_data_mag_bias, 2, sizeof(struct mip_filter_data_mag_bias)};

static const struct mip_parameter parameters_filter_data_mag_bias_uncertainty[] = {
    {"bias_uncertainty", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_mag_bias_uncertainty, bias_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_mag_bias_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_bias_uncertainty = {
    parameters_filter_data_mag_bias_uncertainty, 2,
    sizeof(struct mip_filter_data_mag_bias_uncertainty)};

static const struct mip_parameter parameters_filter_data_comp_accel[] = {
    {"accel", "m/s^2", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_comp_accel, accel), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_comp_accel, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_comp_accel = {
    parameters_filter_data_comp_accel, 2, sizeof(struct mip_filter_data_comp_accel)};

static const struct mip_parameter parameters_filter_data_standard_atmosphere[] = {
    {"geometric_altitude", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_standard_atmosphere, geometric_altitude), 0, NONE},
    {"geopotential_altitude", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_standard_atmosphere, geopotential_altitude), 0, NONE},
    {"standard_temperature", "degC", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_standard_atmosphere, standard_temperature), 0, NONE},
    {"standard_pressure", "mbar", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_standard_atmosphere, standard_pressure), 0, NONE},
    {"standard_density", "kg/m^3", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_standard_atmosphere, standard_density), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_standard_atmosphere, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_standard_atmosphere = {
    parameters_filter_data_standard_atmosphere, 6,
    sizeof(struct mip_filter_data_standard_atmosphere)};

static const struct mip_parameter parameters_filter_data_pressure_altitude[] = {
    {"pressure_altitude", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_pressure_altitude, pressure_altitude), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_pressure_altitude, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_pressure_altitude = {
    parameters_filter_data_pressure_altitude, 2, sizeof(struct mip_filter_data_pressure_altitude)};

static const struct mip_parameter parameters_filter_data_density_altitude[] = {
    {"density_altitude", "m", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_density_altitude, density_altitude), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_density_altitude, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_density_altitude = {
    parameters_filter_data_density_altitude, 2, sizeof(struct mip_filter_data_density_altitude)};

static const struct mip_parameter parameters_filter_data_mag_offset[] = {
    {"hard_iron", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_mag_offset, hard_iron), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_mag_offset, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_offset = {
    parameters_filter_data_mag_offset, 2, sizeof(struct mip_filter_data_mag_offset)};

static const struct mip_parameter parameters_filter_data_mag_matrix[] = {
    {"soft_iron", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_filter_data_mag_matrix, soft_iron), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_filter_data_mag_matrix, valid_flags),
     0, &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_matrix = {
    parameters_filter_data_mag_matrix, 2, sizeof(struct mip_filter_data_mag_matrix)};

static const struct mip_parameter parameters_filter_data_mag_offset_uncertainty[] = {
    {"hard_iron_uncertainty", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0,
     0, 0, ONE(struct mip_filter_data_mag_offset_uncertainty, hard_iron_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_mag_offset_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_offset_uncertainty = {
    parameters_filter_data_mag_offset_uncertainty, 2,
    sizeof(struct mip_filter_data_mag_offset_uncertainty)};

static const struct mip_parameter parameters_filter_data_mag_matrix_uncertainty[] = {
    {"soft_iron_uncertainty", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_filter_data_mag_matrix_uncertainty, soft_iron_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_mag_matrix_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_matrix_uncertainty = {
    parameters_filter_data_mag_matrix_uncertainty, 2,
    sizeof(struct mip_filter_data_mag_matrix_uncertainty)};

static const struct mip_parameter parameters_filter_data_mag_covariance_matrix[] = {
    {"covariance", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 9, 0, 0, 0,
     ONE(struct mip_filter_data_mag_covariance_matrix, covariance), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_mag_covariance_matrix, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_covariance_matrix = {
    parameters_filter_data_mag_covariance_matrix, 2,
    sizeof(struct mip_filter_data_mag_covariance_matrix)};

static const struct mip_parameter parameters_filter_data_mag_residual_vector[] = {
    {"residual", "gauss", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_mag_residual_vector, residual), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_mag_residual_vector, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_mag_residual_vector = {
    parameters_filter_data_mag_residual_vector, 2,
    sizeof(struct mip_filter_data_mag_residual_vector)};

static const struct mip_parameter parameters_filter_data_antenna_offset_correction[] = {
    {"offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_antenna_offset_correction, offset), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_antenna_offset_correction, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_antenna_offset_correction = {
    parameters_filter_data_antenna_offset_correction, 2,
    sizeof(struct mip_filter_data_antenna_offset_correction)};

static const struct mip_parameter parameters_filter_data_antenna_offset_correction_uncertainty[] = {
    {"offset_uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_antenna_offset_correction_uncertainty, offset_uncertainty), 0,
     NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_antenna_offset_correction_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_antenna_offset_correction_uncertainty = {
    parameters_filter_data_antenna_offset_correction_uncertainty, 2,
    sizeof(struct mip_filter_data_antenna_offset_correction_uncertainty)};

static const struct mip_parameter parameters_filter_data_clock_correction[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction, receiver_id), 0, NONE},
    {"bias", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_clock_correction, bias), 0,
     NONE},
    {"bias_drift", "s/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction, bias_drift), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_clock_correction = {
    parameters_filter_data_clock_correction, 4, sizeof(struct mip_filter_data_clock_correction)};

static const struct mip_parameter parameters_filter_data_clock_correction_uncertainty[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction_uncertainty, receiver_id), 0, NONE},
    {"bias_uncertainty", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction_uncertainty, bias_uncertainty), 0, NONE},
    {"bias_drift_uncertainty", "s/s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction_uncertainty, bias_drift_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_clock_correction_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_clock_correction_uncertainty = {
    parameters_filter_data_clock_correction_uncertainty, 4,
    sizeof(struct mip_filter_data_clock_correction_uncertainty)};

static const struct mip_parameter parameters_filter_data_multi_antenna_offset_correction[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_multi_antenna_offset_correction, receiver_id), 0, NONE},
    {"offset", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_multi_antenna_offset_correction, offset), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_multi_antenna_offset_correction, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_multi_antenna_offset_correction = {
    parameters_filter_data_multi_antenna_offset_correction, 3,
    sizeof(struct mip_filter_data_multi_antenna_offset_correction)};

static const struct mip_parameter parameters_filter_data_multi_antenna_offset_uncertainty[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_multi_antenna_offset_uncertainty, receiver_id), 0, NONE},
    {"offset_uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_multi_antenna_offset_uncertainty, offset_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_multi_antenna_offset_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_multi_antenna_offset_uncertainty = {
    parameters_filter_data_multi_antenna_offset_uncertainty, 3,
    sizeof(struct mip_filter_data_multi_antenna_offset_uncertainty)};

static const struct mip_parameter parameters_filter_data_ecef_position_uncertainty[] = {
    {"position_uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_ecef_position_uncertainty, position_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_ecef_position_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ecef_position_uncertainty = {
    parameters_filter_data_ecef_position_uncertainty, 2,
    sizeof(struct mip_filter_data_ecef_position_uncertainty)};

static const struct mip_parameter parameters_filter_data_ecef_velocity_uncertainty[] = {
    {"velocity_uncertainty", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0,
     0, ONE(struct mip_filter_data_ecef_velocity_uncertainty, velocity_uncertainty), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_ecef_velocity_uncertainty, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ecef_velocity_uncertainty = {
    parameters_filter_data_ecef_velocity_uncertainty, 2,
    sizeof(struct mip_filter_data_ecef_velocity_uncertainty)};

static const struct mip_parameter parameters_filter_data_ecef_position[] = {
    {"position", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_ecef_position, position), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_ecef_position, valid_flags), 0, &mip_names_filter_data_valid_flags,
     NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ecef_position = {
    parameters_filter_data_ecef_position, 2, sizeof(struct mip_filter_data_ecef_position)};

static const struct mip_parameter parameters_filter_data_ecef_velocity[] = {
    {"velocity", "m/s", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_ecef_velocity, velocity), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_ecef_velocity, valid_flags), 0, &mip_names_filter_data_valid_flags,
     NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ecef_velocity = {
    parameters_filter_data_ecef_velocity, 2, sizeof(struct mip_filter_data_ecef_velocity)};

static const struct mip_parameter parameters_filter_data_ned_relative_position[] = {
    {"relative_position", "m", MIP_KIND_NUMBER, MIP_SCALAR_DOUBLE, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_ned_relative_position, relative_position), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_ned_relative_position, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_ned_relative_position = {
    parameters_filter_data_ned_relative_position, 2,
    sizeof(struct mip_filter_data_ned_relative_position)};

static const struct mip_parameter parameters_filter_data_gnss_position_aiding_status[] = {
    {"receiver_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_position_aiding_status, receiver_id), 0, NONE},
    {"tow", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_position_aiding_status, tow), 0, NONE},
    {"status", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_position_aiding_status, status), 0,
     &mip_names_filter_data_gnss_aiding_status, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 8, 1, 0, 0, 0,
     MANY(struct mip_filter_data_gnss_position_aiding_status, reserved), 0, NONE},
};
static const struct mip_record record_filter_data_gnss_position_aiding_status = {
    parameters_filter_data_gnss_position_aiding_status, 4,
    sizeof(struct mip_filter_data_gnss_position_aiding_status)};

static const struct mip_parameter parameters_filter_data_gnss_attitude_aiding_status[] = {
    {"tow", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_attitude_aiding_status, tow), 0, NONE},
    {"status", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_attitude_aiding_status, status), 0,
     &mip_names_filter_data_gnss_aiding_status, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 8, 1, 0, 0, 0,
     MANY(struct mip_filter_data_gnss_attitude_aiding_status, reserved), 0, NONE},
};
static const struct mip_record record_filter_data_gnss_attitude_aiding_status = {
    parameters_filter_data_gnss_attitude_aiding_status, 3,
    sizeof(struct mip_filter_data_gnss_attitude_aiding_status)};

static const struct mip_parameter parameters_filter_data_heading_aiding_status[] = {
    {"tow", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_heading_aiding_status, tow), 0,
     NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_data_heading_aiding_status, type), 0,
     &mip_names_filter_data_heading_aiding_type, NULL, NULL, NULL, 0},
    {"reserved", "", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_FIXED, 2, 1, 0, 0, 0,
     MANY(struct mip_filter_data_heading_aiding_status, reserved), 0, NONE},
};
static const struct mip_record record_filter_data_heading_aiding_status = {
    parameters_filter_data_heading_aiding_status, 3,
    sizeof(struct mip_filter_data_heading_aiding_status)};

static const struct mip_parameter parameters_filter_data_aiding_measurement_summary[] = {
    {"tow", "s", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_aiding_measurement_summary, tow), 0, NONE},
    {"source", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_aiding_measurement_summary, source), 0, NONE},
    {"type", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_filter_data_aiding_measurement_summary, type),
     0, &mip_names_filter_data_aiding_measurement_type, NULL, NULL, NULL, 0},
    {"indicator", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_aiding_measurement_summary, indicator), 0,
     &mip_names_filter_data_aiding_measurement_indicator, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_aiding_measurement_summary = {
    parameters_filter_data_aiding_measurement_summary, 4,
    sizeof(struct mip_filter_data_aiding_measurement_summary)};

static const struct mip_parameter parameters_filter_data_odometer_scale_factor_error[] = {
    {"scale_factor_error", "1", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_odometer_scale_factor_error, scale_factor_error), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_odometer_scale_factor_error, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_odometer_scale_factor_error = {
    parameters_filter_data_odometer_scale_factor_error, 2,
    sizeof(struct mip_filter_data_odometer_scale_factor_error)};

static const struct mip_parameter parameters_filter_data_odometer_scale_factor_error_uncertainty[] =
    {
        {"scale_factor_error_uncertainty", "1", NUMBER(FLOAT), 0, 0, 0,
         ONE(struct mip_filter_data_odometer_scale_factor_error_uncertainty,
             scale_factor_error_uncertainty),
         0, NONE},
        {"valid_flags", "", NUMBER(U16), 0, 0, 0,
         ONE(struct mip_filter_data_odometer_scale_factor_error_uncertainty, valid_flags), 0,
         &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_odometer_scale_factor_error_uncertainty = {
    parameters_filter_data_odometer_scale_factor_error_uncertainty, 2,
    sizeof(struct mip_filter_data_odometer_scale_factor_error_uncertainty)};

static const struct mip_parameter parameters_filter_data_gnss_dual_antenna_status[] = {
    {"tow", "s", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_filter_data_gnss_dual_antenna_status, tow),
     0, NONE},
    {"heading", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_dual_antenna_status, heading), 0, NONE},
    {"heading_uncertainty", "rad", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_dual_antenna_status, heading_uncertainty), 0, NONE},
    {"fix_type", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_dual_antenna_status, fix_type), 0,
     &mip_names_filter_data_dual_antenna_fix_type, NULL, NULL, NULL, 0},
    {"status_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_dual_antenna_status, status_flags), 0,
     &mip_names_filter_data_dual_antenna_status_flags, NULL, NULL, NULL, 0},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_filter_data_gnss_dual_antenna_status, valid_flags), 0,
     &mip_names_filter_data_valid_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_filter_data_gnss_dual_antenna_status = {
    parameters_filter_data_gnss_dual_antenna_status, 6,
    sizeof(struct mip_filter_data_gnss_dual_antenna_status)};

static const struct mip_parameter parameters_filter_data_aiding_frame_config_error[] = {
    {"frame_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_aiding_frame_config_error, frame_id), 0, NONE},
    {"translation", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0, 0,
     ONE(struct mip_filter_data_aiding_frame_config_error, translation), 0, NONE},
    {"attitude", "1", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 4, 0, 0, 0,
     ONE(struct mip_filter_data_aiding_frame_config_error, attitude), 0, NONE},
};
static const struct mip_record record_filter_data_aiding_frame_config_error = {
    parameters_filter_data_aiding_frame_config_error, 3,
    sizeof(struct mip_filter_data_aiding_frame_config_error)};

static const struct mip_parameter parameters_filter_data_aiding_frame_config_error_uncertainty[] = {
    {"frame_id", "", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_filter_data_aiding_frame_config_error_uncertainty, frame_id), 0, NONE},
    {"translation_uncertainty", "m", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0,
     0, ONE(struct mip_filter_data_aiding_frame_config_error_uncertainty, translation_uncertainty),
     0, NONE},
    {"attitude_uncertainty", "rad", MIP_KIND_NUMBER, MIP_SCALAR_FLOAT, MIP_LENGTH_ONE, 1, 3, 0, 0,
     0, ONE(struct mip_filter_data_aiding_frame_config_error_uncertainty, attitude_uncertainty), 0,
     NONE},
};
static const struct mip_record record_filter_data_aiding_frame_config_error_uncertainty = {
    parameters_filter_data_aiding_frame_config_error_uncertainty, 3,
    sizeof(struct mip_filter_data_aiding_frame_config_error_uncertainty)};

static const struct mip_parameter parameters_displacement_data_displacement_raw[] = {
    {"counts", "1", NUMBER(U32), 0, 0, 0,
     ONE(struct mip_displacement_data_displacement_raw, counts), 0, NONE},
};
static const struct mip_record record_displacement_data_displacement_raw = {
    parameters_displacement_data_displacement_raw, 1,
    sizeof(struct mip_displacement_data_displacement_raw)};

static const struct mip_parameter parameters_displacement_data_displacement[] = {
    {"displacement", "mm", NUMBER(FLOAT), 0, 0, 0,
     ONE(struct mip_displacement_data_displacement, displacement), 0, NONE},
};
static const struct mip_record record_displacement_data_displacement = {
    parameters_displacement_data_displacement, 1,
    sizeof(struct mip_displacement_data_displacement)};

static const struct mip_parameter parameters_displacement_data_timestamp[] = {
    {"flags", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_displacement_data_timestamp, flags), 0,
     &mip_names_displacement_data_timestamp_flags, NULL, NULL, NULL, 0},
    {"time", "ns", NUMBER(U64), 0, 0, 0, ONE(struct mip_displacement_data_timestamp, time), 0,
     NONE},
};
static const struct mip_record record_displacement_data_timestamp = {
    parameters_displacement_data_timestamp, 2, sizeof(struct mip_displacement_data_timestamp)};

static const struct mip_reading readings_system_data_built_in_test_result[] = {
    {"3dm-cv7-ahrs", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cv7-ar", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cv7-gnss-ins", 0, 0, &mip_names_cv7_continuous_built_in_test},
    {"3dm-cv7-ins", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cx7-ahrs", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cx7-ar", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-cx7-ins", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-gq7", 0, 0, &mip_names_gq7_continuous_built_in_test},
    {"3dm-gv7-ahrs", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-gv7-ar", 0, 0, &mip_names_cv7_inertial_bit},
    {"3dm-gv7-ins", 0, 0, &mip_names_cv7_inertial_bit},
};
static const struct mip_parameter parameters_system_data_built_in_test[] = {
    {"result", "", MIP_KIND_NUMBER, MIP_SCALAR_U8, MIP_LENGTH_FIXED, 16, 1, 0, 0, 0,
     MANY(struct mip_system_data_built_in_test, result), 0, NULL,
     readings_system_data_built_in_test_result, NULL, NULL, 11},
};
static const struct mip_record record_system_data_built_in_test = {
    parameters_system_data_built_in_test, 1, sizeof(struct mip_system_data_built_in_test)};

static const struct mip_parameter parameters_system_data_time_sync_status[] = {
    {"time_sync", "", NUMBER(BOOL), 0, 0, 0,
     ONE(struct mip_system_data_time_sync_status, time_sync), 0, NONE},
    {"last_pps_received", "s", NUMBER(U8), 0, 0, 0,
     ONE(struct mip_system_data_time_sync_status, last_pps_received), 0, NONE},
};
static const struct mip_record record_system_data_time_sync_status = {
    parameters_system_data_time_sync_status, 2, sizeof(struct mip_system_data_time_sync_status)};

static const struct mip_parameter parameters_system_data_gpio_state[] = {
    {"states", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_system_data_gpio_state, states), 0,
     &mip_names_system_data_gpio_pin_states, NULL, NULL, NULL, 0},
};
static const struct mip_record record_system_data_gpio_state = {
    parameters_system_data_gpio_state, 1, sizeof(struct mip_system_data_gpio_state)};

static const struct mip_parameter parameters_system_data_gpio_analog_value[] = {
    {"gpio_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_system_data_gpio_analog_value, gpio_id), 0,
     NONE},
    {"value", "V", NUMBER(FLOAT), 0, 0, 0, ONE(struct mip_system_data_gpio_analog_value, value), 0,
     NONE},
};
static const struct mip_record record_system_data_gpio_analog_value = {
    parameters_system_data_gpio_analog_value, 2, sizeof(struct mip_system_data_gpio_analog_value)};

static const struct mip_parameter parameters_shared_event_source[] = {
    {"trigger_id", "", NUMBER(U8), 0, 0, 0, ONE(struct mip_shared_event_source, trigger_id), 0,
     NONE},
};
static const struct mip_record record_shared_event_source = {
    parameters_shared_event_source, 1, sizeof(struct mip_shared_event_source)};

static const struct mip_parameter parameters_shared_ticks[] = {
    {"ticks", "1", NUMBER(U32), 0, 0, 0, ONE(struct mip_shared_ticks, ticks), 0, NONE},
};
static const struct mip_record record_shared_ticks = {parameters_shared_ticks, 1,
                                                      sizeof(struct mip_shared_ticks)};

static const struct mip_parameter parameters_shared_delta_ticks[] = {
    {"ticks", "1", NUMBER(U32), 0, 0, 0, ONE(struct mip_shared_delta_ticks, ticks), 0, NONE},
};
static const struct mip_record record_shared_delta_ticks = {parameters_shared_delta_ticks, 1,
                                                            sizeof(struct mip_shared_delta_ticks)};

static const struct mip_parameter parameters_shared_gps_timestamp[] = {
    {"tow", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_shared_gps_timestamp, tow), 0, NONE},
    {"week_number", "week", NUMBER(U16), 0, 0, 0, ONE(struct mip_shared_gps_timestamp, week_number),
     0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0, ONE(struct mip_shared_gps_timestamp, valid_flags), 0,
     &mip_names_shared_gps_timestamp_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_shared_gps_timestamp = {
    parameters_shared_gps_timestamp, 3, sizeof(struct mip_shared_gps_timestamp)};

static const struct mip_parameter parameters_shared_delta_time[] = {
    {"seconds", "s", NUMBER(DOUBLE), 0, 0, 0, ONE(struct mip_shared_delta_time, seconds), 0, NONE},
};
static const struct mip_record record_shared_delta_time = {parameters_shared_delta_time, 1,
                                                           sizeof(struct mip_shared_delta_time)};

static const struct mip_parameter parameters_shared_reference_timestamp[] = {
    {"nanoseconds", "ns", NUMBER(U64), 0, 0, 0,
     ONE(struct mip_shared_reference_timestamp, nanoseconds), 0, NONE},
};
static const struct mip_record record_shared_reference_timestamp = {
    parameters_shared_reference_timestamp, 1, sizeof(struct mip_shared_reference_timestamp)};

static const struct mip_parameter parameters_shared_reference_time_delta[] = {
    {"dt_nanos", "ns", NUMBER(U64), 0, 0, 0, ONE(struct mip_shared_reference_time_delta, dt_nanos),
     0, NONE},
};
static const struct mip_record record_shared_reference_time_delta = {
    parameters_shared_reference_time_delta, 1, sizeof(struct mip_shared_reference_time_delta)};

static const struct mip_parameter parameters_shared_external_timestamp[] = {
    {"nanoseconds", "ns", NUMBER(U64), 0, 0, 0,
     ONE(struct mip_shared_external_timestamp, nanoseconds), 0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_shared_external_timestamp, valid_flags), 0,
     &mip_names_shared_external_timestamp_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_shared_external_timestamp = {
    parameters_shared_external_timestamp, 2, sizeof(struct mip_shared_external_timestamp)};

static const struct mip_parameter parameters_shared_external_time_delta[] = {
    {"dt_nanos", "ns", NUMBER(U64), 0, 0, 0, ONE(struct mip_shared_external_time_delta, dt_nanos),
     0, NONE},
    {"valid_flags", "", NUMBER(U16), 0, 0, 0,
     ONE(struct mip_shared_external_time_delta, valid_flags), 0,
     &mip_names_shared_external_time_delta_flags, NULL, NULL, NULL, 0},
};
static const struct mip_record record_shared_external_time_delta = {
    parameters_shared_external_time_delta, 2, sizeof(struct mip_shared_external_time_delta)};

/* --------------------------------------------------------------------------------------- fields */

const struct mip_reflection mip_reflections[] = {
    {&mip_protocol_acknowledge_codec, &record_protocol_acknowledge, false, false, NULL, 0, 0},
    {&mip_base_ping_codec, &record_base_ping, false, false, NULL, 0, 0},
    {&mip_base_set_idle_codec, &record_base_set_idle, false, false, NULL, 0, 0},
    {&mip_base_get_device_info_codec, &record_base_get_device_info, false, false, NULL, 0, 0},
    {&mip_base_get_device_descriptors_codec, &record_base_get_device_descriptors, false, false,
     NULL, 0, 0},
    {&mip_base_built_in_test_codec, &record_base_built_in_test, false, false, NULL, 0, 0},
    {&mip_base_resume_codec, &record_base_resume, false, false, NULL, 0, 0},
    {&mip_base_get_extended_descriptors_codec, &record_base_get_extended_descriptors, false, false,
     NULL, 0, 0},
    {&mip_base_continuous_built_in_test_codec, &record_base_continuous_built_in_test, false, false,
     NULL, 0, 0},
    {&mip_base_comm_speed_codec, &record_base_comm_speed, true, true, required_base_comm_speed,
     sizeof(required_base_comm_speed), offsetof(struct mip_base_comm_speed, present)},
    {&mip_base_gps_time_update_codec, &record_base_gps_time_update, true, true,
     required_base_gps_time_update, sizeof(required_base_gps_time_update),
     offsetof(struct mip_base_gps_time_update, present)},
    {&mip_base_soft_reset_codec, &record_base_soft_reset, false, false, NULL, 0, 0},
    {&mip_base_get_device_info_response_codec, &record_base_get_device_info_response, false, false,
     NULL, 0, 0},
    {&mip_base_get_device_descriptors_response_codec, &record_base_get_device_descriptors_response,
     false, false, NULL, 0, 0},
    {&mip_base_built_in_test_response_codec, &record_base_built_in_test_response, false, false,
     NULL, 0, 0},
    {&mip_base_gps_time_update_week_number_response_codec,
     &record_base_gps_time_update_week_number_response, false, false, NULL, 0, 0},
    {&mip_base_gps_time_update_tow_response_codec, &record_base_gps_time_update_tow_response, false,
     false, NULL, 0, 0},
    {&mip_base_get_extended_descriptors_response_codec,
     &record_base_get_extended_descriptors_response, false, false, NULL, 0, 0},
    {&mip_base_continuous_built_in_test_response_codec,
     &record_base_continuous_built_in_test_response, false, false, NULL, 0, 0},
    {&mip_base_comm_speed_response_codec, &record_base_comm_speed_response, false, false, NULL, 0,
     0},
    {&mip_3dm_poll_imu_data_codec, &record_3dm_poll_imu_data, false, false, NULL, 0, 0},
    {&mip_3dm_poll_gnss_data_codec, &record_3dm_poll_gnss_data, false, false, NULL, 0, 0},
    {&mip_3dm_poll_filter_data_codec, &record_3dm_poll_filter_data, false, false, NULL, 0, 0},
    {&mip_3dm_poll_nmea_data_codec, &record_3dm_poll_nmea_data, false, false, NULL, 0, 0},
    {&mip_3dm_get_imu_base_rate_codec, &record_3dm_get_imu_base_rate, false, false, NULL, 0, 0},
    {&mip_3dm_get_gnss_base_rate_codec, &record_3dm_get_gnss_base_rate, false, false, NULL, 0, 0},
    {&mip_3dm_imu_message_format_codec, &record_3dm_imu_message_format, true, true,
     required_3dm_imu_message_format, sizeof(required_3dm_imu_message_format),
     offsetof(struct mip_3dm_imu_message_format, present)},
    {&mip_3dm_gnss_message_format_codec, &record_3dm_gnss_message_format, true, true,
     required_3dm_gnss_message_format, sizeof(required_3dm_gnss_message_format),
     offsetof(struct mip_3dm_gnss_message_format, present)},
    {&mip_3dm_filter_message_format_codec, &record_3dm_filter_message_format, true, true,
     required_3dm_filter_message_format, sizeof(required_3dm_filter_message_format),
     offsetof(struct mip_3dm_filter_message_format, present)},
    {&mip_3dm_get_filter_base_rate_codec, &record_3dm_get_filter_base_rate, false, false, NULL, 0,
     0},
    {&mip_3dm_nmea_message_format_codec, &record_3dm_nmea_message_format, true, true,
     required_3dm_nmea_message_format, sizeof(required_3dm_nmea_message_format),
     offsetof(struct mip_3dm_nmea_message_format, present)},
    {&mip_3dm_poll_data_codec, &record_3dm_poll_data, false, false, NULL, 0, 0},
    {&mip_3dm_get_base_rate_codec, &record_3dm_get_base_rate, false, false, NULL, 0, 0},
    {&mip_3dm_message_format_codec, &record_3dm_message_format, true, true,
     required_3dm_message_format, sizeof(required_3dm_message_format),
     offsetof(struct mip_3dm_message_format, present)},
    {&mip_3dm_factory_streaming_codec, &record_3dm_factory_streaming, false, false, NULL, 0, 0},
    {&mip_3dm_data_stream_control_codec, &record_3dm_data_stream_control, true, true,
     required_3dm_data_stream_control, sizeof(required_3dm_data_stream_control),
     offsetof(struct mip_3dm_data_stream_control, present)},
    {&mip_3dm_raw_rtcm_2_3_message_codec, &record_3dm_raw_rtcm_2_3_message, false, false, NULL, 0,
     0},
    {&mip_3dm_constellation_settings_codec, &record_3dm_constellation_settings, true, true,
     required_3dm_constellation_settings, sizeof(required_3dm_constellation_settings),
     offsetof(struct mip_3dm_constellation_settings, present)},
    {&mip_3dm_gnss_sbas_settings_codec, &record_3dm_gnss_sbas_settings, true, true,
     required_3dm_gnss_sbas_settings, sizeof(required_3dm_gnss_sbas_settings),
     offsetof(struct mip_3dm_gnss_sbas_settings, present)},
    {&mip_3dm_gnss_assisted_fix_codec, &record_3dm_gnss_assisted_fix, true, true,
     required_3dm_gnss_assisted_fix, sizeof(required_3dm_gnss_assisted_fix),
     offsetof(struct mip_3dm_gnss_assisted_fix, present)},
    {&mip_3dm_gnss_time_assistance_codec, &record_3dm_gnss_time_assistance, true, true,
     required_3dm_gnss_time_assistance, sizeof(required_3dm_gnss_time_assistance),
     offsetof(struct mip_3dm_gnss_time_assistance, present)},
    {&mip_3dm_pps_source_control_codec, &record_3dm_pps_source_control, true, true,
     required_3dm_pps_source_control, sizeof(required_3dm_pps_source_control),
     offsetof(struct mip_3dm_pps_source_control, present)},
    {&mip_3dm_get_event_support_codec, &record_3dm_get_event_support, false, false, NULL, 0, 0},
    {&mip_3dm_event_control_codec, &record_3dm_event_control, true, true,
     required_3dm_event_control, sizeof(required_3dm_event_control),
     offsetof(struct mip_3dm_event_control, present)},
    {&mip_3dm_get_event_trigger_status_codec, &record_3dm_get_event_trigger_status, false, false,
     NULL, 0, 0},
    {&mip_3dm_get_event_action_status_codec, &record_3dm_get_event_action_status, false, false,
     NULL, 0, 0},
    {&mip_3dm_event_trigger_config_codec, &record_3dm_event_trigger_config, true, true,
     required_3dm_event_trigger_config, sizeof(required_3dm_event_trigger_config),
     offsetof(struct mip_3dm_event_trigger_config, present)},
    {&mip_3dm_event_action_config_codec, &record_3dm_event_action_config, true, true,
     required_3dm_event_action_config, sizeof(required_3dm_event_action_config),
     offsetof(struct mip_3dm_event_action_config, present)},
    {&mip_3dm_device_settings_codec, &record_3dm_device_settings, true, false,
     required_3dm_device_settings, sizeof(required_3dm_device_settings), 0},
    {&mip_3dm_sensor_to_vehicle_transform_euler_codec,
     &record_3dm_sensor_to_vehicle_transform_euler, true, true,
     required_3dm_sensor_to_vehicle_transform_euler,
     sizeof(required_3dm_sensor_to_vehicle_transform_euler),
     offsetof(struct mip_3dm_sensor_to_vehicle_transform_euler, present)},
    {&mip_3dm_sensor_to_vehicle_transform_quaternion_codec,
     &record_3dm_sensor_to_vehicle_transform_quaternion, true, true,
     required_3dm_sensor_to_vehicle_transform_quaternion,
     sizeof(required_3dm_sensor_to_vehicle_transform_quaternion),
     offsetof(struct mip_3dm_sensor_to_vehicle_transform_quaternion, present)},
    {&mip_3dm_sensor_to_vehicle_transform_dcm_codec, &record_3dm_sensor_to_vehicle_transform_dcm,
     true, true, required_3dm_sensor_to_vehicle_transform_dcm,
     sizeof(required_3dm_sensor_to_vehicle_transform_dcm),
     offsetof(struct mip_3dm_sensor_to_vehicle_transform_dcm, present)},
    {&mip_3dm_gps_dynamics_mode_codec, &record_3dm_gps_dynamics_mode, true, true,
     required_3dm_gps_dynamics_mode, sizeof(required_3dm_gps_dynamics_mode),
     offsetof(struct mip_3dm_gps_dynamics_mode, present)},
    {&mip_3dm_imu_signal_conditioning_codec, &record_3dm_imu_signal_conditioning, true, true,
     required_3dm_imu_signal_conditioning, sizeof(required_3dm_imu_signal_conditioning),
     offsetof(struct mip_3dm_imu_signal_conditioning, present)},
    {&mip_3dm_imu_timestamp_codec, &record_3dm_imu_timestamp, true, true,
     required_3dm_imu_timestamp, sizeof(required_3dm_imu_timestamp),
     offsetof(struct mip_3dm_imu_timestamp, present)},
    {&mip_3dm_accel_bias_codec, &record_3dm_accel_bias, true, true, required_3dm_accel_bias,
     sizeof(required_3dm_accel_bias), offsetof(struct mip_3dm_accel_bias, present)},
    {&mip_3dm_gyro_bias_codec, &record_3dm_gyro_bias, true, true, required_3dm_gyro_bias,
     sizeof(required_3dm_gyro_bias), offsetof(struct mip_3dm_gyro_bias, present)},
    {&mip_3dm_capture_gyro_bias_codec, &record_3dm_capture_gyro_bias, false, false, NULL, 0, 0},
    {&mip_3dm_mag_hard_iron_offset_codec, &record_3dm_mag_hard_iron_offset, true, true,
     required_3dm_mag_hard_iron_offset, sizeof(required_3dm_mag_hard_iron_offset),
     offsetof(struct mip_3dm_mag_hard_iron_offset, present)},
    {&mip_3dm_mag_soft_iron_matrix_codec, &record_3dm_mag_soft_iron_matrix, true, true,
     required_3dm_mag_soft_iron_matrix, sizeof(required_3dm_mag_soft_iron_matrix),
     offsetof(struct mip_3dm_mag_soft_iron_matrix, present)},
    {&mip_3dm_coning_sculling_enable_codec, &record_3dm_coning_sculling_enable, true, true,
     required_3dm_coning_sculling_enable, sizeof(required_3dm_coning_sculling_enable),
     offsetof(struct mip_3dm_coning_sculling_enable, present)},
    {&mip_3dm_uart_baud_rate_codec, &record_3dm_uart_baud_rate, true, true,
     required_3dm_uart_baud_rate, sizeof(required_3dm_uart_baud_rate),
     offsetof(struct mip_3dm_uart_baud_rate, present)},
    {&mip_3dm_gpio_config_codec, &record_3dm_gpio_config, true, true, required_3dm_gpio_config,
     sizeof(required_3dm_gpio_config), offsetof(struct mip_3dm_gpio_config, present)},
    {&mip_3dm_gpio_state_codec, &record_3dm_gpio_state, true, true, required_3dm_gpio_state,
     sizeof(required_3dm_gpio_state), offsetof(struct mip_3dm_gpio_state, present)},
    {&mip_3dm_odometer_config_codec, &record_3dm_odometer_config, true, true,
     required_3dm_odometer_config, sizeof(required_3dm_odometer_config),
     offsetof(struct mip_3dm_odometer_config, present)},
    {&mip_3dm_imu_low_pass_filter_codec, &record_3dm_imu_low_pass_filter, true, true,
     required_3dm_imu_low_pass_filter, sizeof(required_3dm_imu_low_pass_filter),
     offsetof(struct mip_3dm_imu_low_pass_filter, present)},
    {&mip_3dm_complementary_filter_codec, &record_3dm_complementary_filter, true, true,
     required_3dm_complementary_filter, sizeof(required_3dm_complementary_filter),
     offsetof(struct mip_3dm_complementary_filter, present)},
    {&mip_3dm_sensor_range_codec, &record_3dm_sensor_range, true, true, required_3dm_sensor_range,
     sizeof(required_3dm_sensor_range), offsetof(struct mip_3dm_sensor_range, present)},
    {&mip_3dm_get_calibrated_sensor_ranges_codec, &record_3dm_get_calibrated_sensor_ranges, false,
     false, NULL, 0, 0},
    {&mip_3dm_low_pass_filter_codec, &record_3dm_low_pass_filter, true, true,
     required_3dm_low_pass_filter, sizeof(required_3dm_low_pass_filter),
     offsetof(struct mip_3dm_low_pass_filter, present)},
    {&mip_3dm_data_stream_format_codec, &record_3dm_data_stream_format, true, true,
     required_3dm_data_stream_format, sizeof(required_3dm_data_stream_format),
     offsetof(struct mip_3dm_data_stream_format, present)},
    {&mip_3dm_device_power_state_codec, &record_3dm_device_power_state, true, true,
     required_3dm_device_power_state, sizeof(required_3dm_device_power_state),
     offsetof(struct mip_3dm_device_power_state, present)},
    {&mip_3dm_gps_advanced_settings_codec, &record_3dm_gps_advanced_settings, true, false,
     required_3dm_gps_advanced_settings, sizeof(required_3dm_gps_advanced_settings), 0},
    {&mip_3dm_device_status_codec, &record_3dm_device_status, false, false, NULL, 0, 0},
    {&mip_3dm_imu_message_format_response_codec, &record_3dm_imu_message_format_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_gnss_message_format_response_codec, &record_3dm_gnss_message_format_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_filter_message_format_response_codec, &record_3dm_filter_message_format_response,
     false, false, NULL, 0, 0},
    {&mip_3dm_get_imu_base_rate_response_codec, &record_3dm_get_imu_base_rate_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_get_gnss_base_rate_response_codec, &record_3dm_get_gnss_base_rate_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_data_stream_control_response_codec, &record_3dm_data_stream_control_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_imu_signal_conditioning_response_codec, &record_3dm_imu_signal_conditioning_response,
     false, false, NULL, 0, 0},
    {&mip_3dm_uart_baud_rate_response_codec, &record_3dm_uart_baud_rate_response, false, false,
     NULL, 0, 0},
    {&mip_3dm_data_stream_format_response_codec, &record_3dm_data_stream_format_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_device_power_state_response_codec, &record_3dm_device_power_state_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_get_filter_base_rate_response_codec, &record_3dm_get_filter_base_rate_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_imu_low_pass_filter_response_codec, &record_3dm_imu_low_pass_filter_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_nmea_message_format_response_codec, &record_3dm_nmea_message_format_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_get_base_rate_response_codec, &record_3dm_get_base_rate_response, false, false, NULL,
     0, 0},
    {&mip_3dm_message_format_response_codec, &record_3dm_message_format_response, false, false,
     NULL, 0, 0},
    {&mip_3dm_device_status_basic_rq1_imu_response_codec,
     &record_3dm_device_status_basic_rq1_imu_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_basic_response_codec, &record_3dm_device_status_basic_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_device_status_basic_without_state_response_codec,
     &record_3dm_device_status_basic_without_state_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_response_codec,
     &record_3dm_device_status_diagnostic_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_gnss_response_codec,
     &record_3dm_device_status_diagnostic_gnss_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_gq4_45_response_codec,
     &record_3dm_device_status_diagnostic_gq4_45_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_rq1_45_response_codec,
     &record_3dm_device_status_diagnostic_rq1_45_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_gx4_response_codec,
     &record_3dm_device_status_diagnostic_gx4_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_imu_response_codec,
     &record_3dm_device_status_diagnostic_imu_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_gx4_imu_response_codec,
     &record_3dm_device_status_diagnostic_gx4_imu_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_rq1_imu_response_codec,
     &record_3dm_device_status_diagnostic_rq1_imu_response, false, false, NULL, 0, 0},
    {&mip_3dm_device_status_basic_gx3_response_codec, &record_3dm_device_status_basic_gx3_response,
     false, false, NULL, 0, 0},
    {&mip_3dm_device_status_diagnostic_gx3_response_codec,
     &record_3dm_device_status_diagnostic_gx3_response, false, false, NULL, 0, 0},
    {&mip_3dm_gps_dynamics_mode_response_codec, &record_3dm_gps_dynamics_mode_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_imu_timestamp_response_codec, &record_3dm_imu_timestamp_response, false, false, NULL,
     0, 0},
    {&mip_3dm_complementary_filter_response_codec, &record_3dm_complementary_filter_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_accel_bias_response_codec, &record_3dm_accel_bias_response, false, false, NULL, 0, 0},
    {&mip_3dm_gyro_bias_response_codec, &record_3dm_gyro_bias_response, false, false, NULL, 0, 0},
    {&mip_3dm_mag_hard_iron_offset_response_codec, &record_3dm_mag_hard_iron_offset_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_mag_soft_iron_matrix_response_codec, &record_3dm_mag_soft_iron_matrix_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_coning_sculling_enable_response_codec, &record_3dm_coning_sculling_enable_response,
     false, false, NULL, 0, 0},
    {&mip_3dm_constellation_settings_response_codec, &record_3dm_constellation_settings_response,
     false, false, NULL, 0, 0},
    {&mip_3dm_gnss_sbas_settings_response_codec, &record_3dm_gnss_sbas_settings_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_gnss_assisted_fix_response_codec, &record_3dm_gnss_assisted_fix_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_gnss_time_assistance_response_codec, &record_3dm_gnss_time_assistance_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_pps_source_control_response_codec, &record_3dm_pps_source_control_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_sensor_to_vehicle_transform_euler_response_codec,
     &record_3dm_sensor_to_vehicle_transform_euler_response, false, false, NULL, 0, 0},
    {&mip_3dm_sensor_to_vehicle_transform_quaternion_response_codec,
     &record_3dm_sensor_to_vehicle_transform_quaternion_response, false, false, NULL, 0, 0},
    {&mip_3dm_sensor_to_vehicle_transform_dcm_response_codec,
     &record_3dm_sensor_to_vehicle_transform_dcm_response, false, false, NULL, 0, 0},
    {&mip_3dm_get_event_support_response_codec, &record_3dm_get_event_support_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_event_control_response_codec, &record_3dm_event_control_response, false, false, NULL,
     0, 0},
    {&mip_3dm_get_event_trigger_status_response_codec,
     &record_3dm_get_event_trigger_status_response, false, false, NULL, 0, 0},
    {&mip_3dm_get_event_action_status_response_codec, &record_3dm_get_event_action_status_response,
     false, false, NULL, 0, 0},
    {&mip_3dm_event_trigger_config_response_codec, &record_3dm_event_trigger_config_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_event_action_config_response_codec, &record_3dm_event_action_config_response, false,
     false, NULL, 0, 0},
    {&mip_3dm_gpio_config_response_codec, &record_3dm_gpio_config_response, false, false, NULL, 0,
     0},
    {&mip_3dm_gpio_state_response_codec, &record_3dm_gpio_state_response, false, false, NULL, 0, 0},
    {&mip_3dm_odometer_config_response_codec, &record_3dm_odometer_config_response, false, false,
     NULL, 0, 0},
    {&mip_3dm_sensor_range_response_codec, &record_3dm_sensor_range_response, false, false, NULL, 0,
     0},
    {&mip_3dm_get_calibrated_sensor_ranges_response_codec,
     &record_3dm_get_calibrated_sensor_ranges_response, false, false, NULL, 0, 0},
    {&mip_3dm_low_pass_filter_response_codec, &record_3dm_low_pass_filter_response, false, false,
     NULL, 0, 0},
    {&mip_filter_reset_codec, &record_filter_reset, false, false, NULL, 0, 0},
    {&mip_filter_set_initial_attitude_codec, &record_filter_set_initial_attitude, false, false,
     NULL, 0, 0},
    {&mip_filter_set_initial_heading_codec, &record_filter_set_initial_heading, false, false, NULL,
     0, 0},
    {&mip_filter_set_initial_attitude_from_imu_codec, &record_filter_set_initial_attitude_from_imu,
     false, false, NULL, 0, 0},
    {&mip_filter_run_codec, &record_filter_run, false, false, NULL, 0, 0},
    {&mip_filter_vehicle_dynamics_mode_codec, &record_filter_vehicle_dynamics_mode, true, true,
     required_filter_vehicle_dynamics_mode, sizeof(required_filter_vehicle_dynamics_mode),
     offsetof(struct mip_filter_vehicle_dynamics_mode, present)},
    {&mip_filter_sensor_to_vehicle_rotation_euler_codec,
     &record_filter_sensor_to_vehicle_rotation_euler, true, true,
     required_filter_sensor_to_vehicle_rotation_euler,
     sizeof(required_filter_sensor_to_vehicle_rotation_euler),
     offsetof(struct mip_filter_sensor_to_vehicle_rotation_euler, present)},
    {&mip_filter_sensor_to_vehicle_offset_codec, &record_filter_sensor_to_vehicle_offset, true,
     true, required_filter_sensor_to_vehicle_offset,
     sizeof(required_filter_sensor_to_vehicle_offset),
     offsetof(struct mip_filter_sensor_to_vehicle_offset, present)},
    {&mip_filter_antenna_offset_codec, &record_filter_antenna_offset, true, true,
     required_filter_antenna_offset, sizeof(required_filter_antenna_offset),
     offsetof(struct mip_filter_antenna_offset, present)},
    {&mip_filter_estimation_control_codec, &record_filter_estimation_control, true, true,
     required_filter_estimation_control, sizeof(required_filter_estimation_control),
     offsetof(struct mip_filter_estimation_control, present)},
    {&mip_filter_gnss_source_codec, &record_filter_gnss_source, true, true,
     required_filter_gnss_source, sizeof(required_filter_gnss_source),
     offsetof(struct mip_filter_gnss_source, present)},
    {&mip_filter_external_gnss_update_codec, &record_filter_external_gnss_update, false, false,
     NULL, 0, 0},
    {&mip_filter_external_heading_update_codec, &record_filter_external_heading_update, false,
     false, NULL, 0, 0},
    {&mip_filter_heading_source_codec, &record_filter_heading_source, true, true,
     required_filter_heading_source, sizeof(required_filter_heading_source),
     offsetof(struct mip_filter_heading_source, present)},
    {&mip_filter_auto_initialization_control_codec, &record_filter_auto_initialization_control,
     true, true, required_filter_auto_initialization_control,
     sizeof(required_filter_auto_initialization_control),
     offsetof(struct mip_filter_auto_initialization_control, present)},
    {&mip_filter_accel_noise_codec, &record_filter_accel_noise, true, true,
     required_filter_accel_noise, sizeof(required_filter_accel_noise),
     offsetof(struct mip_filter_accel_noise, present)},
    {&mip_filter_gyro_noise_codec, &record_filter_gyro_noise, true, true,
     required_filter_gyro_noise, sizeof(required_filter_gyro_noise),
     offsetof(struct mip_filter_gyro_noise, present)},
    {&mip_filter_accel_bias_model_codec, &record_filter_accel_bias_model, true, true,
     required_filter_accel_bias_model, sizeof(required_filter_accel_bias_model),
     offsetof(struct mip_filter_accel_bias_model, present)},
    {&mip_filter_gyro_bias_model_codec, &record_filter_gyro_bias_model, true, true,
     required_filter_gyro_bias_model, sizeof(required_filter_gyro_bias_model),
     offsetof(struct mip_filter_gyro_bias_model, present)},
    {&mip_filter_auto_zupt_codec, &record_filter_auto_zupt, true, true, required_filter_auto_zupt,
     sizeof(required_filter_auto_zupt), offsetof(struct mip_filter_auto_zupt, present)},
    {&mip_filter_external_heading_update_with_time_codec,
     &record_filter_external_heading_update_with_time, false, false, NULL, 0, 0},
    {&mip_filter_auto_angular_zupt_codec, &record_filter_auto_angular_zupt, true, true,
     required_filter_auto_angular_zupt, sizeof(required_filter_auto_angular_zupt),
     offsetof(struct mip_filter_auto_angular_zupt, present)},
    {&mip_filter_tare_orientation_codec, &record_filter_tare_orientation, true, true,
     required_filter_tare_orientation, sizeof(required_filter_tare_orientation),
     offsetof(struct mip_filter_tare_orientation, present)},
    {&mip_filter_commanded_zupt_codec, &record_filter_commanded_zupt, false, false, NULL, 0, 0},
    {&mip_filter_commanded_angular_zupt_codec, &record_filter_commanded_angular_zupt, false, false,
     NULL, 0, 0},
    {&mip_filter_reference_position_codec, &record_filter_reference_position, true, true,
     required_filter_reference_position, sizeof(required_filter_reference_position),
     offsetof(struct mip_filter_reference_position, present)},
    {&mip_filter_mag_capture_auto_calibration_codec, &record_filter_mag_capture_auto_calibration,
     true, false, required_filter_mag_capture_auto_calibration,
     sizeof(required_filter_mag_capture_auto_calibration), 0},
    {&mip_filter_gravity_noise_codec, &record_filter_gravity_noise, true, true,
     required_filter_gravity_noise, sizeof(required_filter_gravity_noise),
     offsetof(struct mip_filter_gravity_noise, present)},
    {&mip_filter_pressure_altitude_noise_codec, &record_filter_pressure_altitude_noise, true, true,
     required_filter_pressure_altitude_noise, sizeof(required_filter_pressure_altitude_noise),
     offsetof(struct mip_filter_pressure_altitude_noise, present)},
    {&mip_filter_hard_iron_offset_noise_codec, &record_filter_hard_iron_offset_noise, true, true,
     required_filter_hard_iron_offset_noise, sizeof(required_filter_hard_iron_offset_noise),
     offsetof(struct mip_filter_hard_iron_offset_noise, present)},
    {&mip_filter_soft_iron_matrix_noise_codec, &record_filter_soft_iron_matrix_noise, true, true,
     required_filter_soft_iron_matrix_noise, sizeof(required_filter_soft_iron_matrix_noise),
     offsetof(struct mip_filter_soft_iron_matrix_noise, present)},
    {&mip_filter_enable_measurements_codec, &record_filter_enable_measurements, true, true,
     required_filter_enable_measurements, sizeof(required_filter_enable_measurements),
     offsetof(struct mip_filter_enable_measurements, present)},
    {&mip_filter_mag_noise_codec, &record_filter_mag_noise, true, true, required_filter_mag_noise,
     sizeof(required_filter_mag_noise), offsetof(struct mip_filter_mag_noise, present)},
    {&mip_filter_magnetic_declination_source_codec, &record_filter_magnetic_declination_source,
     true, true, required_filter_magnetic_declination_source,
     sizeof(required_filter_magnetic_declination_source),
     offsetof(struct mip_filter_magnetic_declination_source, present)},
    {&mip_filter_accel_magnitude_adaptive_codec, &record_filter_accel_magnitude_adaptive, true,
     true, required_filter_accel_magnitude_adaptive,
     sizeof(required_filter_accel_magnitude_adaptive),
     offsetof(struct mip_filter_accel_magnitude_adaptive, present)},
    {&mip_filter_mag_magnitude_adaptive_codec, &record_filter_mag_magnitude_adaptive, true, true,
     required_filter_mag_magnitude_adaptive, sizeof(required_filter_mag_magnitude_adaptive),
     offsetof(struct mip_filter_mag_magnitude_adaptive, present)},
    {&mip_filter_mag_dip_angle_adaptive_codec, &record_filter_mag_dip_angle_adaptive, true, true,
     required_filter_mag_dip_angle_adaptive, sizeof(required_filter_mag_dip_angle_adaptive),
     offsetof(struct mip_filter_mag_dip_angle_adaptive, present)},
    {&mip_filter_altitude_aiding_codec, &record_filter_altitude_aiding, true, true,
     required_filter_altitude_aiding, sizeof(required_filter_altitude_aiding),
     offsetof(struct mip_filter_altitude_aiding, present)},
    {&mip_filter_pitch_roll_aiding_codec, &record_filter_pitch_roll_aiding, true, true,
     required_filter_pitch_roll_aiding, sizeof(required_filter_pitch_roll_aiding),
     offsetof(struct mip_filter_pitch_roll_aiding, present)},
    {&mip_filter_magnetic_inclination_source_codec, &record_filter_magnetic_inclination_source,
     true, true, required_filter_magnetic_inclination_source,
     sizeof(required_filter_magnetic_inclination_source),
     offsetof(struct mip_filter_magnetic_inclination_source, present)},
    {&mip_filter_magnetic_magnitude_source_codec, &record_filter_magnetic_magnitude_source, true,
     true, required_filter_magnetic_magnitude_source,
     sizeof(required_filter_magnetic_magnitude_source),
     offsetof(struct mip_filter_magnetic_magnitude_source, present)},
    {&mip_filter_sensor_to_vehicle_rotation_dcm_codec,
     &record_filter_sensor_to_vehicle_rotation_dcm, true, true,
     required_filter_sensor_to_vehicle_rotation_dcm,
     sizeof(required_filter_sensor_to_vehicle_rotation_dcm),
     offsetof(struct mip_filter_sensor_to_vehicle_rotation_dcm, present)},
    {&mip_filter_sensor_to_vehicle_quaternion_codec, &record_filter_sensor_to_vehicle_quaternion,
     true, true, required_filter_sensor_to_vehicle_quaternion,
     sizeof(required_filter_sensor_to_vehicle_quaternion),
     offsetof(struct mip_filter_sensor_to_vehicle_quaternion, present)},
    {&mip_filter_aiding_measurement_enable_codec, &record_filter_aiding_measurement_enable, true,
     true, required_filter_aiding_measurement_enable,
     sizeof(required_filter_aiding_measurement_enable),
     offsetof(struct mip_filter_aiding_measurement_enable, present)},
    {&mip_filter_kinematic_constraint_codec, &record_filter_kinematic_constraint, true, true,
     required_filter_kinematic_constraint, sizeof(required_filter_kinematic_constraint),
     offsetof(struct mip_filter_kinematic_constraint, present)},
    {&mip_filter_initialization_config_codec, &record_filter_initialization_config, true, true,
     required_filter_initialization_config, sizeof(required_filter_initialization_config),
     offsetof(struct mip_filter_initialization_config, present)},
    {&mip_filter_adaptive_filter_options_codec, &record_filter_adaptive_filter_options, true, true,
     required_filter_adaptive_filter_options, sizeof(required_filter_adaptive_filter_options),
     offsetof(struct mip_filter_adaptive_filter_options, present)},
    {&mip_filter_multi_antenna_offset_codec, &record_filter_multi_antenna_offset, true, true,
     required_filter_multi_antenna_offset, sizeof(required_filter_multi_antenna_offset),
     offsetof(struct mip_filter_multi_antenna_offset, present)},
    {&mip_filter_relative_position_config_codec, &record_filter_relative_position_config, true,
     true, required_filter_relative_position_config,
     sizeof(required_filter_relative_position_config),
     offsetof(struct mip_filter_relative_position_config, present)},
    {&mip_filter_reference_point_lever_arm_codec, &record_filter_reference_point_lever_arm, true,
     true, required_filter_reference_point_lever_arm,
     sizeof(required_filter_reference_point_lever_arm),
     offsetof(struct mip_filter_reference_point_lever_arm, present)},
    {&mip_filter_speed_measurement_codec, &record_filter_speed_measurement, false, false, NULL, 0,
     0},
    {&mip_filter_speed_lever_arm_codec, &record_filter_speed_lever_arm, true, true,
     required_filter_speed_lever_arm, sizeof(required_filter_speed_lever_arm),
     offsetof(struct mip_filter_speed_lever_arm, present)},
    {&mip_filter_vertical_gyro_constraint_control_codec,
     &record_filter_vertical_gyro_constraint_control, true, true,
     required_filter_vertical_gyro_constraint_control,
     sizeof(required_filter_vertical_gyro_constraint_control),
     offsetof(struct mip_filter_vertical_gyro_constraint_control, present)},
    {&mip_filter_wheeled_vehicle_constraint_control_codec,
     &record_filter_wheeled_vehicle_constraint_control, true, true,
     required_filter_wheeled_vehicle_constraint_control,
     sizeof(required_filter_wheeled_vehicle_constraint_control),
     offsetof(struct mip_filter_wheeled_vehicle_constraint_control, present)},
    {&mip_filter_gnss_antenna_calibration_control_codec,
     &record_filter_gnss_antenna_calibration_control, true, true,
     required_filter_gnss_antenna_calibration_control,
     sizeof(required_filter_gnss_antenna_calibration_control),
     offsetof(struct mip_filter_gnss_antenna_calibration_control, present)},
    {&mip_filter_vehicle_dynamics_mode_response_codec,
     &record_filter_vehicle_dynamics_mode_response, false, false, NULL, 0, 0},
    {&mip_filter_sensor_to_vehicle_rotation_euler_response_codec,
     &record_filter_sensor_to_vehicle_rotation_euler_response, false, false, NULL, 0, 0},
    {&mip_filter_sensor_to_vehicle_offset_response_codec,
     &record_filter_sensor_to_vehicle_offset_response, false, false, NULL, 0, 0},
    {&mip_filter_antenna_offset_response_codec, &record_filter_antenna_offset_response, false,
     false, NULL, 0, 0},
    {&mip_filter_estimation_control_response_codec, &record_filter_estimation_control_response,
     false, false, NULL, 0, 0},
    {&mip_filter_gnss_source_response_codec, &record_filter_gnss_source_response, false, false,
     NULL, 0, 0},
    {&mip_filter_heading_source_response_codec, &record_filter_heading_source_response, false,
     false, NULL, 0, 0},
    {&mip_filter_auto_initialization_control_response_codec,
     &record_filter_auto_initialization_control_response, false, false, NULL, 0, 0},
    {&mip_filter_accel_noise_response_codec, &record_filter_accel_noise_response, false, false,
     NULL, 0, 0},
    {&mip_filter_gyro_noise_response_codec, &record_filter_gyro_noise_response, false, false, NULL,
     0, 0},
    {&mip_filter_accel_bias_model_response_codec, &record_filter_accel_bias_model_response, false,
     false, NULL, 0, 0},
    {&mip_filter_gyro_bias_model_response_codec, &record_filter_gyro_bias_model_response, false,
     false, NULL, 0, 0},
    {&mip_filter_auto_zupt_response_codec, &record_filter_auto_zupt_response, false, false, NULL, 0,
     0},
    {&mip_filter_auto_angular_zupt_response_codec, &record_filter_auto_angular_zupt_response, false,
     false, NULL, 0, 0},
    {&mip_filter_reference_position_response_codec, &record_filter_reference_position_response,
     false, false, NULL, 0, 0},
    {&mip_filter_gravity_noise_response_codec, &record_filter_gravity_noise_response, false, false,
     NULL, 0, 0},
    {&mip_filter_pressure_altitude_noise_response_codec,
     &record_filter_pressure_altitude_noise_response, false, false, NULL, 0, 0},
    {&mip_filter_hard_iron_offset_noise_response_codec,
     &record_filter_hard_iron_offset_noise_response, false, false, NULL, 0, 0},
    {&mip_filter_soft_iron_matrix_noise_response_codec,
     &record_filter_soft_iron_matrix_noise_response, false, false, NULL, 0, 0},
    {&mip_filter_tare_orientation_response_codec, &record_filter_tare_orientation_response, false,
     false, NULL, 0, 0},
    {&mip_filter_enable_measurements_response_codec, &record_filter_enable_measurements_response,
     false, false, NULL, 0, 0},
    {&mip_filter_mag_noise_response_codec, &record_filter_mag_noise_response, false, false, NULL, 0,
     0},
    {&mip_filter_magnetic_declination_source_response_codec,
     &record_filter_magnetic_declination_source_response, false, false, NULL, 0, 0},
    {&mip_filter_accel_magnitude_adaptive_response_codec,
     &record_filter_accel_magnitude_adaptive_response, false, false, NULL, 0, 0},
    {&mip_filter_mag_magnitude_adaptive_response_codec,
     &record_filter_mag_magnitude_adaptive_response, false, false, NULL, 0, 0},
    {&mip_filter_mag_dip_angle_adaptive_response_codec,
     &record_filter_mag_dip_angle_adaptive_response, false, false, NULL, 0, 0},
    {&mip_filter_altitude_aiding_response_codec, &record_filter_altitude_aiding_response, false,
     false, NULL, 0, 0},
    {&mip_filter_pitch_roll_aiding_response_codec, &record_filter_pitch_roll_aiding_response, false,
     false, NULL, 0, 0},
    {&mip_filter_magnetic_inclination_source_response_codec,
     &record_filter_magnetic_inclination_source_response, false, false, NULL, 0, 0},
    {&mip_filter_magnetic_magnitude_source_response_codec,
     &record_filter_magnetic_magnitude_source_response, false, false, NULL, 0, 0},
    {&mip_filter_sensor_to_vehicle_rotation_dcm_response_codec,
     &record_filter_sensor_to_vehicle_rotation_dcm_response, false, false, NULL, 0, 0},
    {&mip_filter_sensor_to_vehicle_quaternion_response_codec,
     &record_filter_sensor_to_vehicle_quaternion_response, false, false, NULL, 0, 0},
    {&mip_filter_aiding_measurement_enable_response_codec,
     &record_filter_aiding_measurement_enable_response, false, false, NULL, 0, 0},
    {&mip_filter_kinematic_constraint_response_codec, &record_filter_kinematic_constraint_response,
     false, false, NULL, 0, 0},
    {&mip_filter_initialization_config_response_codec,
     &record_filter_initialization_config_response, false, false, NULL, 0, 0},
    {&mip_filter_adaptive_filter_options_response_codec,
     &record_filter_adaptive_filter_options_response, false, false, NULL, 0, 0},
    {&mip_filter_multi_antenna_offset_response_codec, &record_filter_multi_antenna_offset_response,
     false, false, NULL, 0, 0},
    {&mip_filter_relative_position_config_response_codec,
     &record_filter_relative_position_config_response, false, false, NULL, 0, 0},
    {&mip_filter_reference_point_lever_arm_response_codec,
     &record_filter_reference_point_lever_arm_response, false, false, NULL, 0, 0},
    {&mip_filter_speed_lever_arm_response_codec, &record_filter_speed_lever_arm_response, false,
     false, NULL, 0, 0},
    {&mip_filter_vertical_gyro_constraint_control_response_codec,
     &record_filter_vertical_gyro_constraint_control_response, false, false, NULL, 0, 0},
    {&mip_filter_wheeled_vehicle_constraint_control_response_codec,
     &record_filter_wheeled_vehicle_constraint_control_response, false, false, NULL, 0, 0},
    {&mip_filter_gnss_antenna_calibration_control_response_codec,
     &record_filter_gnss_antenna_calibration_control_response, false, false, NULL, 0, 0},
    {&mip_gnss_receiver_info_codec, &record_gnss_receiver_info, false, false, NULL, 0, 0},
    {&mip_gnss_signal_config_codec, &record_gnss_signal_config, true, true,
     required_gnss_signal_config, sizeof(required_gnss_signal_config),
     offsetof(struct mip_gnss_signal_config, present)},
    {&mip_gnss_receiver_reset_codec, &record_gnss_receiver_reset, false, false, NULL, 0, 0},
    {&mip_gnss_rtk_config_codec, &record_gnss_rtk_config, true, true, required_gnss_rtk_config,
     sizeof(required_gnss_rtk_config), offsetof(struct mip_gnss_rtk_config, present)},
    {&mip_gnss_rtk_dongle_config_codec, &record_gnss_rtk_dongle_config, true, true,
     required_gnss_rtk_dongle_config, sizeof(required_gnss_rtk_dongle_config),
     offsetof(struct mip_gnss_rtk_dongle_config, present)},
    {&mip_gnss_spartn_config_codec, &record_gnss_spartn_config, true, true,
     required_gnss_spartn_config, sizeof(required_gnss_spartn_config),
     offsetof(struct mip_gnss_spartn_config, present)},
    {&mip_gnss_receiver_safe_mode_codec, &record_gnss_receiver_safe_mode, false, false, NULL, 0, 0},
    {&mip_gnss_receiver_info_response_codec, &record_gnss_receiver_info_response, false, false,
     NULL, 0, 0},
    {&mip_gnss_signal_config_response_codec, &record_gnss_signal_config_response, false, false,
     NULL, 0, 0},
    {&mip_gnss_rtk_config_response_codec, &record_gnss_rtk_config_response, false, false, NULL, 0,
     0},
    {&mip_gnss_rtk_dongle_config_response_codec, &record_gnss_rtk_dongle_config_response, false,
     false, NULL, 0, 0},
    {&mip_gnss_spartn_config_response_codec, &record_gnss_spartn_config_response, false, false,
     NULL, 0, 0},
    {&mip_rtk_get_status_flags_codec, &record_rtk_get_status_flags, false, false, NULL, 0, 0},
    {&mip_rtk_get_imei_codec, &record_rtk_get_imei, false, false, NULL, 0, 0},
    {&mip_rtk_get_imsi_codec, &record_rtk_get_imsi, false, false, NULL, 0, 0},
    {&mip_rtk_get_iccid_codec, &record_rtk_get_iccid, false, false, NULL, 0, 0},
    {&mip_rtk_get_rssi_codec, &record_rtk_get_rssi, false, false, NULL, 0, 0},
    {&mip_rtk_connected_device_type_codec, &record_rtk_connected_device_type, true, true,
     required_rtk_connected_device_type, sizeof(required_rtk_connected_device_type),
     offsetof(struct mip_rtk_connected_device_type, present)},
    {&mip_rtk_get_activation_code_codec, &record_rtk_get_activation_code, false, false, NULL, 0, 0},
    {&mip_rtk_get_modem_firmware_version_codec, &record_rtk_get_modem_firmware_version, false,
     false, NULL, 0, 0},
    {&mip_rtk_service_status_codec, &record_rtk_service_status, false, false, NULL, 0, 0},
    {&mip_rtk_erase_storage_codec, &record_rtk_erase_storage, false, false, NULL, 0, 0},
    {&mip_rtk_led_control_codec, &record_rtk_led_control, false, false, NULL, 0, 0},
    {&mip_rtk_modem_hard_reset_codec, &record_rtk_modem_hard_reset, false, false, NULL, 0, 0},
    {&mip_rtk_get_status_flags_response_codec, &record_rtk_get_status_flags_response, false, false,
     NULL, 0, 0},
    {&mip_rtk_get_imei_response_codec, &record_rtk_get_imei_response, false, false, NULL, 0, 0},
    {&mip_rtk_get_imsi_response_codec, &record_rtk_get_imsi_response, false, false, NULL, 0, 0},
    {&mip_rtk_get_iccid_response_codec, &record_rtk_get_iccid_response, false, false, NULL, 0, 0},
    {&mip_rtk_get_rssi_response_codec, &record_rtk_get_rssi_response, false, false, NULL, 0, 0},
    {&mip_rtk_connected_device_type_response_codec, &record_rtk_connected_device_type_response,
     false, false, NULL, 0, 0},
    {&mip_rtk_get_activation_code_response_codec, &record_rtk_get_activation_code_response, false,
     false, NULL, 0, 0},
    {&mip_rtk_get_modem_firmware_version_response_codec,
     &record_rtk_get_modem_firmware_version_response, false, false, NULL, 0, 0},
    {&mip_rtk_service_status_response_codec, &record_rtk_service_status_response, false, false,
     NULL, 0, 0},
    {&mip_displacement_get_calibration_codec, &record_displacement_get_calibration, false, false,
     NULL, 0, 0},
    {&mip_displacement_output_rate_codec, &record_displacement_output_rate, true, false,
     required_displacement_output_rate, sizeof(required_displacement_output_rate), 0},
    {&mip_displacement_device_time_codec, &record_displacement_device_time, true, true,
     required_displacement_device_time, sizeof(required_displacement_device_time),
     offsetof(struct mip_displacement_device_time, present)},
    {&mip_displacement_get_calibration_response_codec,
     &record_displacement_get_calibration_response, false, false, NULL, 0, 0},
    {&mip_displacement_output_rate_response_codec, &record_displacement_output_rate_response, false,
     false, NULL, 0, 0},
    {&mip_aiding_frame_config_codec, &record_aiding_frame_config, true, true,
     required_aiding_frame_config, sizeof(required_aiding_frame_config),
     offsetof(struct mip_aiding_frame_config, present)},
    {&mip_aiding_sensor_frame_map_codec, &record_aiding_sensor_frame_map, true, true,
     required_aiding_sensor_frame_map, sizeof(required_aiding_sensor_frame_map),
     offsetof(struct mip_aiding_sensor_frame_map, present)},
    {&mip_aiding_echo_control_codec, &record_aiding_echo_control, true, true,
     required_aiding_echo_control, sizeof(required_aiding_echo_control),
     offsetof(struct mip_aiding_echo_control, present)},
    {&mip_aiding_ecef_position_codec, &record_aiding_ecef_position, false, false, NULL, 0, 0},
    {&mip_aiding_llh_position_codec, &record_aiding_llh_position, false, false, NULL, 0, 0},
    {&mip_aiding_height_above_ellipsoid_codec, &record_aiding_height_above_ellipsoid, false, false,
     NULL, 0, 0},
    {&mip_aiding_pressure_old_codec, &record_aiding_pressure_old, false, false, NULL, 0, 0},
    {&mip_aiding_ecef_velocity_codec, &record_aiding_ecef_velocity, false, false, NULL, 0, 0},
    {&mip_aiding_ned_velocity_codec, &record_aiding_ned_velocity, false, false, NULL, 0, 0},
    {&mip_aiding_body_frame_velocity_codec, &record_aiding_body_frame_velocity, false, false, NULL,
     0, 0},
    {&mip_aiding_true_heading_codec, &record_aiding_true_heading, false, false, NULL, 0, 0},
    {&mip_aiding_magnetic_field_codec, &record_aiding_magnetic_field, false, false, NULL, 0, 0},
    {&mip_aiding_pressure_codec, &record_aiding_pressure, false, false, NULL, 0, 0},
    {&mip_aiding_frame_config_response_codec, &record_aiding_frame_config_response, false, false,
     NULL, 0, 0},
    {&mip_aiding_sensor_frame_map_response_codec, &record_aiding_sensor_frame_map_response, false,
     false, NULL, 0, 0},
    {&mip_aiding_echo_control_response_codec, &record_aiding_echo_control_response, false, false,
     NULL, 0, 0},
    {&mip_system_interface_control_codec, &record_system_interface_control, true, true,
     required_system_interface_control, sizeof(required_system_interface_control),
     offsetof(struct mip_system_interface_control, present)},
    {&mip_system_comm_mode_codec, &record_system_comm_mode, true, true, required_system_comm_mode,
     sizeof(required_system_comm_mode), offsetof(struct mip_system_comm_mode, present)},
    {&mip_system_interface_control_response_codec, &record_system_interface_control_response, false,
     false, NULL, 0, 0},
    {&mip_system_comm_mode_response_codec, &record_system_comm_mode_response, false, false, NULL, 0,
     0},
    {&mip_sensor_raw_accel_codec, &record_sensor_raw_accel, false, false, NULL, 0, 0},
    {&mip_sensor_raw_gyro_codec, &record_sensor_raw_gyro, false, false, NULL, 0, 0},
    {&mip_sensor_raw_mag_codec, &record_sensor_raw_mag, false, false, NULL, 0, 0},
    {&mip_sensor_scaled_accel_codec, &record_sensor_scaled_accel, false, false, NULL, 0, 0},
    {&mip_sensor_scaled_gyro_codec, &record_sensor_scaled_gyro, false, false, NULL, 0, 0},
    {&mip_sensor_scaled_mag_codec, &record_sensor_scaled_mag, false, false, NULL, 0, 0},
    {&mip_sensor_delta_theta_codec, &record_sensor_delta_theta, false, false, NULL, 0, 0},
    {&mip_sensor_delta_velocity_codec, &record_sensor_delta_velocity, false, false, NULL, 0, 0},
    {&mip_sensor_comp_orientation_matrix_codec, &record_sensor_comp_orientation_matrix, false,
     false, NULL, 0, 0},
    {&mip_sensor_comp_quaternion_codec, &record_sensor_comp_quaternion, false, false, NULL, 0, 0},
    {&mip_sensor_comp_orientation_update_matrix_codec,
     &record_sensor_comp_orientation_update_matrix, false, false, NULL, 0, 0},
    {&mip_sensor_comp_euler_angles_codec, &record_sensor_comp_euler_angles, false, false, NULL, 0,
     0},
    {&mip_sensor_orientation_raw_temperature_codec, &record_sensor_orientation_raw_temperature,
     false, false, NULL, 0, 0},
    {&mip_sensor_internal_timestamp_codec, &record_sensor_internal_timestamp, false, false, NULL, 0,
     0},
    {&mip_sensor_pps_timestamp_codec, &record_sensor_pps_timestamp, false, false, NULL, 0, 0},
    {&mip_sensor_pps_timestamp_with_flags_codec, &record_sensor_pps_timestamp_with_flags, false,
     false, NULL, 0, 0},
    {&mip_sensor_north_vector_codec, &record_sensor_north_vector, false, false, NULL, 0, 0},
    {&mip_sensor_up_vector_codec, &record_sensor_up_vector, false, false, NULL, 0, 0},
    {&mip_sensor_gps_timestamp_codec, &record_sensor_gps_timestamp, false, false, NULL, 0, 0},
    {&mip_sensor_temperature_statistics_codec, &record_sensor_temperature_statistics, false, false,
     NULL, 0, 0},
    {&mip_sensor_raw_pressure_codec, &record_sensor_raw_pressure, false, false, NULL, 0, 0},
    {&mip_sensor_scaled_pressure_codec, &record_sensor_scaled_pressure, false, false, NULL, 0, 0},
    {&mip_sensor_overrange_status_codec, &record_sensor_overrange_status, false, false, NULL, 0, 0},
    {&mip_sensor_odometer_codec, &record_sensor_odometer, false, false, NULL, 0, 0},
    {&mip_gnss_data_llh_position_codec, &record_gnss_data_llh_position, false, false, NULL, 0, 0},
    {&mip_gnss_data_ecef_position_codec, &record_gnss_data_ecef_position, false, false, NULL, 0, 0},
    {&mip_gnss_data_ned_velocity_codec, &record_gnss_data_ned_velocity, false, false, NULL, 0, 0},
    {&mip_gnss_data_ecef_velocity_codec, &record_gnss_data_ecef_velocity, false, false, NULL, 0, 0},
    {&mip_gnss_data_dop_codec, &record_gnss_data_dop, false, false, NULL, 0, 0},
    {&mip_gnss_data_utc_time_codec, &record_gnss_data_utc_time, false, false, NULL, 0, 0},
    {&mip_gnss_data_gps_time_codec, &record_gnss_data_gps_time, false, false, NULL, 0, 0},
    {&mip_gnss_data_clock_info_codec, &record_gnss_data_clock_info, false, false, NULL, 0, 0},
    {&mip_gnss_data_fix_info_codec, &record_gnss_data_fix_info, false, false, NULL, 0, 0},
    {&mip_gnss_data_sv_info_codec, &record_gnss_data_sv_info, false, false, NULL, 0, 0},
    {&mip_gnss_data_hardware_status_codec, &record_gnss_data_hardware_status, false, false, NULL, 0,
     0},
    {&mip_gnss_data_dgps_info_codec, &record_gnss_data_dgps_info, false, false, NULL, 0, 0},
    {&mip_gnss_data_dgps_info_satellite_codec, &record_gnss_data_dgps_info_satellite, false, false,
     NULL, 0, 0},
    {&mip_gnss_data_dgps_channel_codec, &record_gnss_data_dgps_channel, false, false, NULL, 0, 0},
    {&mip_gnss_data_clock_info_2_codec, &record_gnss_data_clock_info_2, false, false, NULL, 0, 0},
    {&mip_gnss_data_gps_leap_seconds_codec, &record_gnss_data_gps_leap_seconds, false, false, NULL,
     0, 0},
    {&mip_gnss_data_sbas_info_codec, &record_gnss_data_sbas_info, false, false, NULL, 0, 0},
    {&mip_gnss_data_sbas_correction_codec, &record_gnss_data_sbas_correction, false, false, NULL, 0,
     0},
    {&mip_gnss_data_rf_error_detection_codec, &record_gnss_data_rf_error_detection, false, false,
     NULL, 0, 0},
    {&mip_gnss_data_heading_codec, &record_gnss_data_heading, false, false, NULL, 0, 0},
    {&mip_gnss_data_satellite_status_codec, &record_gnss_data_satellite_status, false, false, NULL,
     0, 0},
    {&mip_gnss_data_raw_codec, &record_gnss_data_raw, false, false, NULL, 0, 0},
    {&mip_gnss_data_base_station_info_codec, &record_gnss_data_base_station_info, false, false,
     NULL, 0, 0},
    {&mip_gnss_data_rtk_corrections_status_codec, &record_gnss_data_rtk_corrections_status, false,
     false, NULL, 0, 0},
    {&mip_gnss_data_gps_ephemeris_codec, &record_gnss_data_gps_ephemeris, false, false, NULL, 0, 0},
    {&mip_gnss_data_glonass_ephemeris_codec, &record_gnss_data_glonass_ephemeris, false, false,
     NULL, 0, 0},
    {&mip_gnss_data_galileo_ephemeris_codec, &record_gnss_data_galileo_ephemeris, false, false,
     NULL, 0, 0},
    {&mip_gnss_data_beidou_ephemeris_codec, &record_gnss_data_beidou_ephemeris, false, false, NULL,
     0, 0},
    {&mip_gnss_data_gps_iono_correction_codec, &record_gnss_data_gps_iono_correction, false, false,
     NULL, 0, 0},
    {&mip_gnss_data_galileo_iono_correction_codec, &record_gnss_data_galileo_iono_correction, false,
     false, NULL, 0, 0},
    {&mip_gnss_data_beidou_iono_correction_codec, &record_gnss_data_beidou_iono_correction, false,
     false, NULL, 0, 0},
    {&mip_filter_data_llh_position_codec, &record_filter_data_llh_position, false, false, NULL, 0,
     0},
    {&mip_filter_data_ned_velocity_codec, &record_filter_data_ned_velocity, false, false, NULL, 0,
     0},
    {&mip_filter_data_attitude_quaternion_codec, &record_filter_data_attitude_quaternion, false,
     false, NULL, 0, 0},
    {&mip_filter_data_attitude_dcm_codec, &record_filter_data_attitude_dcm, false, false, NULL, 0,
     0},
    {&mip_filter_data_euler_angles_codec, &record_filter_data_euler_angles, false, false, NULL, 0,
     0},
    {&mip_filter_data_gyro_bias_codec, &record_filter_data_gyro_bias, false, false, NULL, 0, 0},
    {&mip_filter_data_accel_bias_codec, &record_filter_data_accel_bias, false, false, NULL, 0, 0},
    {&mip_filter_data_llh_position_uncertainty_codec, &record_filter_data_llh_position_uncertainty,
     false, false, NULL, 0, 0},
    {&mip_filter_data_ned_velocity_uncertainty_codec, &record_filter_data_ned_velocity_uncertainty,
     false, false, NULL, 0, 0},
    {&mip_filter_data_euler_angles_uncertainty_codec, &record_filter_data_euler_angles_uncertainty,
     false, false, NULL, 0, 0},
    {&mip_filter_data_gyro_bias_uncertainty_codec, &record_filter_data_gyro_bias_uncertainty, false,
     false, NULL, 0, 0},
    {&mip_filter_data_accel_bias_uncertainty_codec, &record_filter_data_accel_bias_uncertainty,
     false, false, NULL, 0, 0},
    {&mip_filter_data_linear_accel_codec, &record_filter_data_linear_accel, false, false, NULL, 0,
     0},
    {&mip_filter_data_comp_angular_rate_codec, &record_filter_data_comp_angular_rate, false, false,
     NULL, 0, 0},
    {&mip_filter_data_wgs84_gravity_magnitude_codec, &record_filter_data_wgs84_gravity_magnitude,
     false, false, NULL, 0, 0},
    {&mip_filter_data_status_codec, &record_filter_data_status, false, false, NULL, 0, 0},
    {&mip_filter_data_timestamp_codec, &record_filter_data_timestamp, false, false, NULL, 0, 0},
    {&mip_filter_data_quaternion_attitude_uncertainty_codec,
     &record_filter_data_quaternion_attitude_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_gravity_vector_codec, &record_filter_data_gravity_vector, false, false, NULL,
     0, 0},
    {&mip_filter_data_heading_update_state_codec, &record_filter_data_heading_update_state, false,
     false, NULL, 0, 0},
    {&mip_filter_data_magnetic_model_codec, &record_filter_data_magnetic_model, false, false, NULL,
     0, 0},
    {&mip_filter_data_gyro_scale_factor_codec, &record_filter_data_gyro_scale_factor, false, false,
     NULL, 0, 0},
    {&mip_filter_data_accel_scale_factor_codec, &record_filter_data_accel_scale_factor, false,
     false, NULL, 0, 0},
    {&mip_filter_data_gyro_scale_factor_uncertainty_codec,
     &record_filter_data_gyro_scale_factor_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_accel_scale_factor_uncertainty_codec,
     &record_filter_data_accel_scale_factor_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_mag_bias_codec, &record_filter_data_mag_bias, false, false, NULL, 0, 0},
    {&mip_filter_data_mag_bias_uncertainty_codec, &record_filter_data_mag_bias_uncertainty, false,
     false, NULL, 0, 0},
    {&mip_filter_data_comp_accel_codec, &record_filter_data_comp_accel, false, false, NULL, 0, 0},
    {&mip_filter_data_standard_atmosphere_codec, &record_filter_data_standard_atmosphere, false,
     false, NULL, 0, 0},
    {&mip_filter_data_pressure_altitude_codec, &record_filter_data_pressure_altitude, false, false,
     NULL, 0, 0},
    {&mip_filter_data_density_altitude_codec, &record_filter_data_density_altitude, false, false,
     NULL, 0, 0},
    {&mip_filter_data_mag_offset_codec, &record_filter_data_mag_offset, false, false, NULL, 0, 0},
    {&mip_filter_data_mag_matrix_codec, &record_filter_data_mag_matrix, false, false, NULL, 0, 0},
    {&mip_filter_data_mag_offset_uncertainty_codec, &record_filter_data_mag_offset_uncertainty,
     false, false, NULL, 0, 0},
    {&mip_filter_data_mag_matrix_uncertainty_codec, &record_filter_data_mag_matrix_uncertainty,
     false, false, NULL, 0, 0},
    {&mip_filter_data_mag_covariance_matrix_codec, &record_filter_data_mag_covariance_matrix, false,
     false, NULL, 0, 0},
    {&mip_filter_data_mag_residual_vector_codec, &record_filter_data_mag_residual_vector, false,
     false, NULL, 0, 0},
    {&mip_filter_data_antenna_offset_correction_codec,
     &record_filter_data_antenna_offset_correction, false, false, NULL, 0, 0},
    {&mip_filter_data_antenna_offset_correction_uncertainty_codec,
     &record_filter_data_antenna_offset_correction_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_clock_correction_codec, &record_filter_data_clock_correction, false, false,
     NULL, 0, 0},
    {&mip_filter_data_clock_correction_uncertainty_codec,
     &record_filter_data_clock_correction_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_multi_antenna_offset_correction_codec,
     &record_filter_data_multi_antenna_offset_correction, false, false, NULL, 0, 0},
    {&mip_filter_data_multi_antenna_offset_uncertainty_codec,
     &record_filter_data_multi_antenna_offset_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_ecef_position_uncertainty_codec,
     &record_filter_data_ecef_position_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_ecef_velocity_uncertainty_codec,
     &record_filter_data_ecef_velocity_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_ecef_position_codec, &record_filter_data_ecef_position, false, false, NULL, 0,
     0},
    {&mip_filter_data_ecef_velocity_codec, &record_filter_data_ecef_velocity, false, false, NULL, 0,
     0},
    {&mip_filter_data_ned_relative_position_codec, &record_filter_data_ned_relative_position, false,
     false, NULL, 0, 0},
    {&mip_filter_data_gnss_position_aiding_status_codec,
     &record_filter_data_gnss_position_aiding_status, false, false, NULL, 0, 0},
    {&mip_filter_data_gnss_attitude_aiding_status_codec,
     &record_filter_data_gnss_attitude_aiding_status, false, false, NULL, 0, 0},
    {&mip_filter_data_heading_aiding_status_codec, &record_filter_data_heading_aiding_status, false,
     false, NULL, 0, 0},
    {&mip_filter_data_aiding_measurement_summary_codec,
     &record_filter_data_aiding_measurement_summary, false, false, NULL, 0, 0},
    {&mip_filter_data_odometer_scale_factor_error_codec,
     &record_filter_data_odometer_scale_factor_error, false, false, NULL, 0, 0},
    {&mip_filter_data_odometer_scale_factor_error_uncertainty_codec,
     &record_filter_data_odometer_scale_factor_error_uncertainty, false, false, NULL, 0, 0},
    {&mip_filter_data_gnss_dual_antenna_status_codec, &record_filter_data_gnss_dual_antenna_status,
     false, false, NULL, 0, 0},
    {&mip_filter_data_aiding_frame_config_error_codec,
     &record_filter_data_aiding_frame_config_error, false, false, NULL, 0, 0},
    {&mip_filter_data_aiding_frame_config_error_uncertainty_codec,
     &record_filter_data_aiding_frame_config_error_uncertainty, false, false, NULL, 0, 0},
    {&mip_displacement_data_displacement_raw_codec, &record_displacement_data_displacement_raw,
     false, false, NULL, 0, 0},
    {&mip_displacement_data_displacement_codec, &record_displacement_data_displacement, false,
     false, NULL, 0, 0},
    {&mip_displacement_data_timestamp_codec, &record_displacement_data_timestamp, false, false,
     NULL, 0, 0},
    {&mip_system_data_built_in_test_codec, &record_system_data_built_in_test, false, false, NULL, 0,
     0},
    {&mip_system_data_time_sync_status_codec, &record_system_data_time_sync_status, false, false,
     NULL, 0, 0},
    {&mip_system_data_gpio_state_codec, &record_system_data_gpio_state, false, false, NULL, 0, 0},
    {&mip_system_data_gpio_analog_value_codec, &record_system_data_gpio_analog_value, false, false,
     NULL, 0, 0},
    {&mip_shared_event_source_codec, &record_shared_event_source, false, false, NULL, 0, 0},
    {&mip_shared_ticks_codec, &record_shared_ticks, false, false, NULL, 0, 0},
    {&mip_shared_delta_ticks_codec, &record_shared_delta_ticks, false, false, NULL, 0, 0},
    {&mip_shared_gps_timestamp_codec, &record_shared_gps_timestamp, false, false, NULL, 0, 0},
    {&mip_shared_delta_time_codec, &record_shared_delta_time, false, false, NULL, 0, 0},
    {&mip_shared_reference_timestamp_codec, &record_shared_reference_timestamp, false, false, NULL,
     0, 0},
    {&mip_shared_reference_time_delta_codec, &record_shared_reference_time_delta, false, false,
     NULL, 0, 0},
    {&mip_shared_external_timestamp_codec, &record_shared_external_timestamp, false, false, NULL, 0,
     0},
    {&mip_shared_external_time_delta_codec, &record_shared_external_time_delta, false, false, NULL,
     0, 0},
};
const size_t mip_reflection_count = sizeof(mip_reflections) / sizeof(mip_reflections[0]);
