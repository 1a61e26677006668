/* All fields of all descriptor sets. */
#include "mip/registry.h"

#include "mip/protocol.h"
#include "mip/tools.h"
#include "mip/3d.h"
#include "mip/measurements.h"
#include "mip/more.h"
#include "mip/copy.h"
#include "mip/shared.h"

const struct mip_entry mip_registry[] = {
    {0x00, 0xF1, MIP_RESPONSE, 0, 0, MIP_PROTOCOL_ACKNOWLEDGE_NAME,
     &mip_protocol_acknowledge_codec},
    {0x01, 0x01, MIP_COMMAND, 0, 0, MIP_TOOLS_PING_NAME, &mip_tools_ping_codec},
    {0x01, 0x02, MIP_COMMAND, 1, 0, MIP_TOOLS_SETTINGS_NAME, &mip_tools_settings_codec},
    {0x01, 0x03, MIP_COMMAND, 2, 1, MIP_TOOLS_SET_TIME_NAME, &mip_tools_set_time_codec},
    {0x01, 0x04, MIP_COMMAND, 4, 3, MIP_TOOLS_STATUS_NAME, &mip_tools_status_codec},
    {0x01, 0x05, MIP_COMMAND, 1, 7, MIP_TOOLS_BIAS_NAME, &mip_tools_bias_codec},
    {0x01, 0x06, MIP_COMMAND, 1, 8, MIP_TOOLS_CAPTURE_BIAS_NAME, &mip_tools_capture_bias_codec},
    {0x01, 0x07, MIP_COMMAND, 0, 9, MIP_TOOLS_FORMATS_NAME, &mip_tools_formats_codec},
    {0x01, 0x08, MIP_COMMAND, 1, 9, MIP_TOOLS_CHOICE_NAME, &mip_tools_choice_codec},
    {0x01, 0x09, MIP_COMMAND, 1, 10, MIP_TOOLS_LIST_NAME, &mip_tools_list_codec},
    {0x01, 0x0A, MIP_COMMAND, 1, 11, MIP_TOOLS_STOCK_NAME, &mip_tools_stock_codec},
    {0x01, 0x0B, MIP_COMMAND, 1, 12, MIP_TOOLS_PIN_NAME, &mip_tools_pin_codec},
    {0x01, 0x0C, MIP_COMMAND, 1, 13, MIP_TOOLS_HELLO_NAME, &mip_tools_hello_codec},
    {0x01, 0x0D, MIP_COMMAND, 1, 14, MIP_TOOLS_READINGS_NAME, &mip_tools_readings_codec},
    {0x01, 0x82, MIP_RESPONSE, 1, 15, MIP_TOOLS_SETTINGS_RESPONSE_NAME,
     &mip_tools_settings_response_codec},
    {0x01, 0x83, MIP_RESPONSE, 1, 16, MIP_TOOLS_SET_TIME_FAST_RESPONSE_NAME,
     &mip_tools_set_time_fast_response_codec},
    {0x01, 0x84, MIP_RESPONSE, 1, 17, MIP_TOOLS_SET_TIME_SLOW_RESPONSE_NAME,
     &mip_tools_set_time_slow_response_codec},
    {0x01, 0x88, MIP_RESPONSE, 1, 18, MIP_TOOLS_CHOICE_RESPONSE_NAME,
     &mip_tools_choice_response_codec},
    {0x01, 0x89, MIP_RESPONSE, 1, 19, MIP_TOOLS_LIST_RESPONSE_NAME, &mip_tools_list_response_codec},
    {0x01, 0x8A, MIP_RESPONSE, 1, 20, MIP_TOOLS_STOCK_RESPONSE_NAME,
     &mip_tools_stock_response_codec},
    {0x01, 0x8B, MIP_RESPONSE, 1, 21, MIP_TOOLS_PIN_RESPONSE_NAME, &mip_tools_pin_response_codec},
    {0x01, 0x8C, MIP_RESPONSE, 1, 22, MIP_TOOLS_HELLO_RESPONSE_NAME,
     &mip_tools_hello_response_codec},
    {0x01, 0x8D, MIP_RESPONSE, 1, 23, MIP_TOOLS_READINGS_RESPONSE_NAME,
     &mip_tools_readings_response_codec},
    {0x01, 0x90, MIP_RESPONSE, 1, 24, MIP_TOOLS_STATUS_SHORT_NAME, &mip_tools_status_short_codec},
    {0x01, 0x90, MIP_RESPONSE, 1, 25, MIP_TOOLS_STATUS_LONG_NAME, &mip_tools_status_long_codec},
    {0x01, 0x90, MIP_RESPONSE, 1, 26, MIP_TOOLS_STATUS_OLD_NAME, &mip_tools_status_old_codec},
    {0x01, 0x90, MIP_RESPONSE, 1, 27, MIP_TOOLS_FULL_NAME, &mip_tools_full_codec},
    {0x01, 0x9B, MIP_RESPONSE, 2, 28, MIP_TOOLS_BIAS_VECTOR_NAME, &mip_tools_bias_vector_codec},
    {0x0C, 0x10, MIP_COMMAND, 0, 30, MIP_3D_DEFAULT_NAME, &mip_3d_default_codec},
    {0x80, 0x01, MIP_DATA, 0, 30, MIP_MEASUREMENTS_ACCEL_NAME, &mip_measurements_accel_codec},
    {0x80, 0x02, MIP_DATA, 0, 30, MIP_MEASUREMENTS_NUMBERS_NAME, &mip_measurements_numbers_codec},
    {0x80, 0x03, MIP_DATA, 0, 30, MIP_MEASUREMENTS_STRINGS_NAME, &mip_measurements_strings_codec},
    {0x80, 0x04, MIP_DATA, 0, 30, MIP_MEASUREMENTS_HEALTH_NAME, &mip_measurements_health_codec},
    {0x80, 0x05, MIP_DATA, 0, 30, MIP_MEASUREMENTS_ARRAYS_NAME, &mip_measurements_arrays_codec},
    {0x80, 0x06, MIP_DATA, 0, 30, MIP_MEASUREMENTS_GROWING_NAME, &mip_measurements_growing_codec},
    {0x80, 0x07, MIP_DATA, 0, 30, MIP_MEASUREMENTS_RADIO_NAME, &mip_measurements_radio_codec},
    {0x80, 0x08, MIP_DATA, 0, 30, MIP_MEASUREMENTS_CLOUD_NAME, &mip_measurements_cloud_codec},
    {0x80, 0x09, MIP_DATA, 0, 30, MIP_MEASUREMENTS_GUST_NAME, &mip_measurements_gust_codec},
    {0x80, 0x0A, MIP_DATA, 0, 30, MIP_MEASUREMENTS_BREEZE_NAME, &mip_measurements_breeze_codec},
    {0x81, 0x01, MIP_DATA, 0, 30, MIP_MORE_ACCEL_NAME, &mip_more_accel_codec},
    {0x81, 0x03, MIP_DATA, 0, 30, MIP_MORE_STRINGS_NAME, &mip_more_strings_codec},
    {0x81, 0x07, MIP_DATA, 0, 30, MIP_MORE_OWN_NAME, &mip_more_own_codec},
    {0x92, 0x01, MIP_DATA, 0, 30, MIP_COPY_ACC_NAME, &mip_copy_acc_codec},
    {0x92, 0x02, MIP_DATA, 0, 30, MIP_COPY_NUMBERS_NAME, &mip_copy_numbers_codec},
    {0x92, 0x03, MIP_DATA, 0, 30, MIP_COPY_STRINGS_NAME, &mip_copy_strings_codec},
    {0x92, 0x04, MIP_DATA, 0, 30, MIP_COPY_HEALTH_NAME, &mip_copy_health_codec},
    {0x92, 0x05, MIP_DATA, 0, 30, MIP_COPY_ARRAYS_NAME, &mip_copy_arrays_codec},
    {0x92, 0x06, MIP_DATA, 0, 30, MIP_COPY_GROWING_NAME, &mip_copy_growing_codec},
    {0x92, 0x07, MIP_DATA, 0, 30, MIP_COPY_RADIO_NAME, &mip_copy_radio_codec},
    {0x92, 0x08, MIP_DATA, 0, 30, MIP_COPY_CLOUD_NAME, &mip_copy_cloud_codec},
    {0x92, 0x09, MIP_DATA, 0, 30, MIP_COPY_GUST_NAME, &mip_copy_gust_codec},
    {0x92, 0x0A, MIP_DATA, 0, 30, MIP_COPY_BREEZE_NAME, &mip_copy_breeze_codec},
    {0xFF, 0xD3, MIP_DATA, 0, 30, MIP_SHARED_TIMESTAMP_NAME, &mip_shared_timestamp_codec},
};
const size_t mip_registry_size = sizeof(mip_registry) / sizeof(mip_registry[0]);

const uint16_t mip_registry_links[] = {14, 15, 16, 23, 24, 25, 26, 27, 27, 17, 18,
                                       19, 20, 21, 22, 2,  3,  3,  8,  9,  10, 11,
                                       12, 13, 4,  4,  4,  4,  5,  6,  0};
