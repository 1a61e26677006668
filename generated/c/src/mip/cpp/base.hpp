/**
 * @file
 * Base, in C++17: see mip/base.h.
 */
#ifndef MIP_BASE_HPP
#define MIP_BASE_HPP

#include "mip/base_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_base_ping, MIP_BASE_PING, MIP_BASE_PING, "base.ping", decode)
MIP_LAYOUT(mip_base_set_idle, MIP_BASE_SET_IDLE, MIP_BASE_SET_IDLE, "base.set_idle", decode)
MIP_LAYOUT(mip_base_get_device_info, MIP_BASE_GET_DEVICE_INFO, MIP_BASE_GET_DEVICE_INFO,
           "base.get_device_info", decode)
MIP_LAYOUT(mip_base_get_device_descriptors, MIP_BASE_GET_DEVICE_DESCRIPTORS,
           MIP_BASE_GET_DEVICE_DESCRIPTORS, "base.get_device_descriptors", decode)
MIP_LAYOUT(mip_base_built_in_test, MIP_BASE_BUILT_IN_TEST, MIP_BASE_BUILT_IN_TEST,
           "base.built_in_test", decode)
MIP_LAYOUT(mip_base_resume, MIP_BASE_RESUME, MIP_BASE_RESUME, "base.resume", decode)
MIP_LAYOUT(mip_base_get_extended_descriptors, MIP_BASE_GET_EXTENDED_DESCRIPTORS,
           MIP_BASE_GET_EXTENDED_DESCRIPTORS, "base.get_extended_descriptors", decode)
MIP_LAYOUT(mip_base_continuous_built_in_test, MIP_BASE_CONTINUOUS_BUILT_IN_TEST,
           MIP_BASE_CONTINUOUS_BUILT_IN_TEST, "base.continuous_built_in_test", decode)
MIP_LAYOUT(mip_base_comm_speed, MIP_BASE_COMM_SPEED, MIP_BASE_COMM_SPEED, "base.comm_speed", decode)
MIP_LAYOUT(mip_base_gps_time_update, MIP_BASE_GPS_TIME_UPDATE, MIP_BASE_GPS_TIME_UPDATE,
           "base.gps_time_update", decode)
MIP_LAYOUT(mip_base_soft_reset, MIP_BASE_SOFT_RESET, MIP_BASE_SOFT_RESET, "base.soft_reset", decode)
MIP_LAYOUT(mip_base_get_device_info_response, MIP_BASE_GET_DEVICE_INFO_RESPONSE,
           MIP_BASE_GET_DEVICE_INFO_RESPONSE, "base.get_device_info_response", decode_inline)
MIP_LAYOUT(mip_base_get_device_descriptors_response, MIP_BASE_GET_DEVICE_DESCRIPTORS_RESPONSE,
           MIP_BASE_GET_DEVICE_DESCRIPTORS_RESPONSE, "base.get_device_descriptors_response", decode)
MIP_LAYOUT(mip_base_built_in_test_response, MIP_BASE_BUILT_IN_TEST_RESPONSE,
           MIP_BASE_BUILT_IN_TEST_RESPONSE, "base.built_in_test_response", decode_inline)
MIP_LAYOUT(mip_base_gps_time_update_week_number_response,
           MIP_BASE_GPS_TIME_UPDATE_WEEK_NUMBER_RESPONSE,
           MIP_BASE_GPS_TIME_UPDATE_WEEK_NUMBER_RESPONSE,
           "base.gps_time_update_week_number_response", decode_inline)
MIP_LAYOUT(mip_base_gps_time_update_tow_response, MIP_BASE_GPS_TIME_UPDATE_TOW_RESPONSE,
           MIP_BASE_GPS_TIME_UPDATE_TOW_RESPONSE, "base.gps_time_update_tow_response",
           decode_inline)
MIP_LAYOUT(mip_base_get_extended_descriptors_response, MIP_BASE_GET_EXTENDED_DESCRIPTORS_RESPONSE,
           MIP_BASE_GET_EXTENDED_DESCRIPTORS_RESPONSE, "base.get_extended_descriptors_response",
           decode)
MIP_LAYOUT(mip_base_continuous_built_in_test_response, MIP_BASE_CONTINUOUS_BUILT_IN_TEST_RESPONSE,
           MIP_BASE_CONTINUOUS_BUILT_IN_TEST_RESPONSE, "base.continuous_built_in_test_response",
           decode_inline)
MIP_LAYOUT(mip_base_comm_speed_response, MIP_BASE_COMM_SPEED_RESPONSE, MIP_BASE_COMM_SPEED_RESPONSE,
           "base.comm_speed_response", decode_inline)

/** Base */
inline constexpr std::uint8_t base_set = MIP_BASE_SET;

namespace base {

/** @addtogroup mip_base
 * @{ */

using ::mip::operator|;
using ::mip::operator&;
using ::mip::operator^;
using ::mip::operator~;
using ::mip::operator|=;
using ::mip::operator&=;
using ::mip::operator^=;
#ifdef MIP_NAMES_H
using ::mip::operator<<;
#endif
using ::mip::get;
using ::mip::has;
using ::mip::to_string;

/** mip_base_device_info */
using device_info = ::mip_base_device_info;

/** mip_base_gps_time_field: base.gps_time_field */
enum class gps_time_field : uint8_t {
    week_number = MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER,
    tow = MIP_BASE_GPS_TIME_FIELD_TOW,
};
MIP_NAMES_OF(value_names, gps_time_field, mip_names_base_gps_time_field)

/** Get device information response. See struct mip_base_get_device_info_response. */
using get_device_info_response = ::mip_base_get_device_info_response;

struct get_device_descriptors_response_ : ::mip_base_get_device_descriptors_response {
    using c_type = ::mip_base_get_device_descriptors_response;
    span<const uint16_t> descriptors() const {
        return {c_type::descriptors, c_type::descriptors_count};
    }
};

/** Get device descriptors response. See struct mip_base_get_device_descriptors_response. */
using get_device_descriptors_response = get_device_descriptors_response_;

/** Built-in test response. See struct mip_base_built_in_test_response. */
using built_in_test_response = ::mip_base_built_in_test_response;

struct get_extended_descriptors_response_ : ::mip_base_get_extended_descriptors_response {
    using c_type = ::mip_base_get_extended_descriptors_response;
    span<const uint16_t> descriptors() const {
        return {c_type::descriptors, c_type::descriptors_count};
    }
};

/**
 * Get device descriptors (extended) response. See struct
 * mip_base_get_extended_descriptors_response.
 */
using get_extended_descriptors_response = get_extended_descriptors_response_;

/** Continuous built-in test response. See struct mip_base_continuous_built_in_test_response. */
using continuous_built_in_test_response = ::mip_base_continuous_built_in_test_response;

/** Comm port speed response. See struct mip_base_comm_speed_response. */
using comm_speed_response = ::mip_base_comm_speed_response;

/** GPS time update, week number. See struct mip_base_gps_time_update_week_number_response. */
using gps_time_update_week_number_response = ::mip_base_gps_time_update_week_number_response;

/** GPS time update, time of week. See struct mip_base_gps_time_update_tow_response. */
using gps_time_update_tow_response = ::mip_base_gps_time_update_tow_response;

/** @} */

} // namespace base

} // namespace mip

#endif
