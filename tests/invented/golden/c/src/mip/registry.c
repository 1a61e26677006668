/* All fields of all descriptor sets. */
#include "mip/registry.h"

#include "mip/protocol.h"
#include "mip/tools.h"
#include "mip/tools_commands.h"
#include "mip/3d.h"
#include "mip/3d_commands.h"
#include "mip/measurements.h"
#include "mip/shared.h"

const struct mip_entry mip_registry[] = {
    {0xF1, MIP_RESPONSE, 0, 0, "acknowledge", &mip_protocol_acknowledge_codec, NULL},
    {0x01, MIP_COMMAND, 0, 0, "ping", &mip_tools_ping_codec, &mip_tools_ping_command},
    {0x02, MIP_COMMAND, 1, 0, "settings", &mip_tools_settings_codec, &mip_tools_settings_command},
    {0x03, MIP_COMMAND, 2, 1, "set_time", &mip_tools_set_time_codec, &mip_tools_set_time_command},
    {0x04, MIP_COMMAND, 5, 3, "status", &mip_tools_status_codec, &mip_tools_status_command},
    {0x05, MIP_COMMAND, 1, 8, "bias", &mip_tools_bias_codec, &mip_tools_bias_command},
    {0x06, MIP_COMMAND, 1, 9, "capture_bias", &mip_tools_capture_bias_codec,
     &mip_tools_capture_bias_command},
    {0x07, MIP_COMMAND, 0, 10, "formats", &mip_tools_formats_codec, &mip_tools_formats_command},
    {0x08, MIP_COMMAND, 1, 10, "choice", &mip_tools_choice_codec, &mip_tools_choice_command},
    {0x09, MIP_COMMAND, 1, 11, "list", &mip_tools_list_codec, &mip_tools_list_command},
    {0x0A, MIP_COMMAND, 1, 12, "inventory", &mip_tools_stock_codec, &mip_tools_stock_command},
    {0x0B, MIP_COMMAND, 1, 13, "pin", &mip_tools_pin_codec, &mip_tools_pin_command},
    {0x0C, MIP_COMMAND, 1, 14, "hello", &mip_tools_hello_codec, &mip_tools_hello_command},
    {0x0D, MIP_COMMAND, 1, 15, "readings", &mip_tools_readings_codec, &mip_tools_readings_command},
    {0x0E, MIP_COMMAND, 0, 16, "poll", &mip_tools_poll_codec, &mip_tools_poll_command},
    {0x82, MIP_RESPONSE, 1, 16, "settings_response", &mip_tools_settings_response_codec, NULL},
    {0x83, MIP_RESPONSE, 1, 17, "set_time_fast_response", &mip_tools_set_time_fast_response_codec,
     NULL},
    {0x84, MIP_RESPONSE, 1, 18, "set_time_slow_response", &mip_tools_set_time_slow_response_codec,
     NULL},
    {0x88, MIP_RESPONSE, 1, 19, "choice_response", &mip_tools_choice_response_codec, NULL},
    {0x89, MIP_RESPONSE, 1, 20, "list_response", &mip_tools_list_response_codec, NULL},
    {0x8A, MIP_RESPONSE, 1, 21, "inventory_response", &mip_tools_stock_response_codec, NULL},
    {0x8B, MIP_RESPONSE, 1, 22, "pin_response", &mip_tools_pin_response_codec, NULL},
    {0x8C, MIP_RESPONSE, 1, 23, "hello_response", &mip_tools_hello_response_codec, NULL},
    {0x8D, MIP_RESPONSE, 1, 24, "readings_response", &mip_tools_readings_response_codec, NULL},
    {0x90, MIP_RESPONSE, 1, 25, "status_paged", &mip_tools_status_paged_codec, NULL},
    {0x90, MIP_RESPONSE, 1, 26, "status_short", &mip_tools_status_short_codec, NULL},
    {0x90, MIP_RESPONSE, 1, 27, "status_long", &mip_tools_status_long_codec, NULL},
    {0x90, MIP_RESPONSE, 1, 28, "status_old", &mip_tools_status_old_codec, NULL},
    {0x90, MIP_RESPONSE, 1, 29, "status_full", &mip_tools_full_codec, NULL},
    {0x9B, MIP_RESPONSE, 2, 30, "bias_vector", &mip_tools_bias_vector_codec, NULL},
    {0x10, MIP_COMMAND, 0, 32, "default", &mip_3d_default_codec, &mip_3d_default_command},
    {0x01, MIP_DATA, 0, 32, "accel", &mip_measurements_accel_codec, NULL},
    {0x02, MIP_DATA, 0, 32, "numbers", &mip_measurements_numbers_codec, NULL},
    {0x03, MIP_DATA, 0, 32, "strings", &mip_measurements_strings_codec, NULL},
    {0x04, MIP_DATA, 0, 32, "health", &mip_measurements_health_codec, NULL},
    {0x05, MIP_DATA, 0, 32, "arrays", &mip_measurements_arrays_codec, NULL},
    {0x06, MIP_DATA, 0, 32, "growing", &mip_measurements_growing_codec, NULL},
    {0x07, MIP_DATA, 0, 32, "radio", &mip_measurements_radio_codec, NULL},
    {0x07, MIP_DATA, 0, 32, "own", &mip_measurements_own_codec, NULL},
    {0x08, MIP_DATA, 0, 32, "cloud", &mip_measurements_cloud_codec, NULL},
    {0x09, MIP_DATA, 0, 32, "gust", &mip_measurements_gust_codec, NULL},
    {0x0A, MIP_DATA, 0, 32, "breeze", &mip_measurements_breeze_codec, NULL},
    {0xD3, MIP_DATA, 0, 32, "timestamp", &mip_shared_timestamp_codec, NULL},
};
const size_t mip_registry_size = sizeof(mip_registry) / sizeof(mip_registry[0]);

const struct mip_set mip_registry_sets[] = {
    {0x00, 0, 1, "protocol"},       {0x01, 1, 29, "tools"}, {0x0C, 30, 1, "3d"},
    {0x80, 31, 11, "measurements"}, {0x81, 31, 11, "more"}, {0x92, 31, 11, "copy"},
    {0xFF, 42, 1, "shared"},
};
const size_t mip_registry_set_count = sizeof(mip_registry_sets) / sizeof(mip_registry_sets[0]);

const uint16_t mip_registry_links[] = {15, 16, 17, 24, 25, 26, 27, 28, 29, 29, 18,
                                       19, 20, 21, 22, 23, 2,  3,  3,  8,  9,  10,
                                       11, 12, 13, 4,  4,  4,  4,  4,  5,  6,  0};
