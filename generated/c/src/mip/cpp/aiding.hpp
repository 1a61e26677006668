/**
 * @file
 * Aiding commands, in C++17: see mip/aiding.h.
 */
#ifndef MIP_AIDING_HPP
#define MIP_AIDING_HPP

#include "mip/aiding_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_aiding_frame_config, MIP_AIDING_FRAME_CONFIG, MIP_AIDING_FRAME_CONFIG,
           "aiding.frame_config", decode)
MIP_LAYOUT(mip_aiding_sensor_frame_map, MIP_AIDING_SENSOR_FRAME_MAP, MIP_AIDING_SENSOR_FRAME_MAP,
           "aiding.sensor_frame_map", decode)
MIP_LAYOUT(mip_aiding_echo_control, MIP_AIDING_ECHO_CONTROL, MIP_AIDING_ECHO_CONTROL,
           "aiding.echo_control", decode)
MIP_LAYOUT(mip_aiding_ecef_position, MIP_AIDING_ECEF_POSITION, MIP_AIDING_ECEF_POSITION,
           "aiding.ecef_position", decode_inline)
MIP_LAYOUT(mip_aiding_llh_position, MIP_AIDING_LLH_POSITION, MIP_AIDING_LLH_POSITION,
           "aiding.llh_position", decode_inline)
MIP_LAYOUT(mip_aiding_height_above_ellipsoid, MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID,
           MIP_AIDING_HEIGHT_ABOVE_ELLIPSOID, "aiding.height_above_ellipsoid", decode_inline)
MIP_LAYOUT(mip_aiding_pressure_old, MIP_AIDING_PRESSURE_OLD, MIP_AIDING_PRESSURE_OLD,
           "aiding.pressure_old", decode_inline)
MIP_LAYOUT(mip_aiding_ecef_velocity, MIP_AIDING_ECEF_VELOCITY, MIP_AIDING_ECEF_VELOCITY,
           "aiding.ecef_velocity", decode_inline)
MIP_LAYOUT(mip_aiding_ned_velocity, MIP_AIDING_NED_VELOCITY, MIP_AIDING_NED_VELOCITY,
           "aiding.ned_velocity", decode_inline)
MIP_LAYOUT(mip_aiding_body_frame_velocity, MIP_AIDING_BODY_FRAME_VELOCITY,
           MIP_AIDING_BODY_FRAME_VELOCITY, "aiding.body_frame_velocity", decode_inline)
MIP_LAYOUT(mip_aiding_true_heading, MIP_AIDING_TRUE_HEADING, MIP_AIDING_TRUE_HEADING,
           "aiding.true_heading", decode_inline)
MIP_LAYOUT(mip_aiding_magnetic_field, MIP_AIDING_MAGNETIC_FIELD, MIP_AIDING_MAGNETIC_FIELD,
           "aiding.magnetic_field", decode_inline)
MIP_LAYOUT(mip_aiding_pressure, MIP_AIDING_PRESSURE, MIP_AIDING_PRESSURE, "aiding.pressure",
           decode_inline)
MIP_LAYOUT(mip_aiding_frame_config_response, MIP_AIDING_FRAME_CONFIG_RESPONSE,
           MIP_AIDING_FRAME_CONFIG_RESPONSE, "aiding.frame_config_response", decode)
MIP_LAYOUT(mip_aiding_sensor_frame_map_response, MIP_AIDING_SENSOR_FRAME_MAP_RESPONSE,
           MIP_AIDING_SENSOR_FRAME_MAP_RESPONSE, "aiding.sensor_frame_map_response", decode_inline)
MIP_LAYOUT(mip_aiding_echo_control_response, MIP_AIDING_ECHO_CONTROL_RESPONSE,
           MIP_AIDING_ECHO_CONTROL_RESPONSE, "aiding.echo_control_response", decode_inline)

/** Aiding commands */
inline constexpr std::uint8_t aiding_set = MIP_AIDING_SET;

namespace aiding {

/** @addtogroup mip_aiding
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

/** mip_aiding_frame_format: aiding.aiding_frame_format */
enum class frame_format : uint8_t {
    euler = MIP_AIDING_FRAME_FORMAT_EULER,
    quaternion = MIP_AIDING_FRAME_FORMAT_QUATERNION,
};
MIP_NAMES_OF(value_names, frame_format, mip_names_aiding_frame_format)

/** mip_aiding_echo_mode: aiding.aiding_echo_mode */
enum class echo_mode : uint8_t {
    suppress_ack = MIP_AIDING_ECHO_MODE_SUPPRESS_ACK,
    standard = MIP_AIDING_ECHO_MODE_STANDARD,
    response = MIP_AIDING_ECHO_MODE_RESPONSE,
};
MIP_NAMES_OF(value_names, echo_mode, mip_names_aiding_echo_mode)

/** mip_aiding_timebase: aiding.timebase */
enum class timebase : uint8_t {
    internal_reference = MIP_AIDING_TIMEBASE_INTERNAL_REFERENCE,
    external_time = MIP_AIDING_TIMEBASE_EXTERNAL_TIME,
    time_of_arrival = MIP_AIDING_TIMEBASE_TIME_OF_ARRIVAL,
};
MIP_NAMES_OF(value_names, timebase, mip_names_aiding_timebase)

/** mip_aiding_measurement_time */
using measurement_time = ::mip_aiding_measurement_time;

/** mip_aiding_axis_flags: aiding.axis_flags */
enum class axis_flags : uint16_t {
    x = MIP_AIDING_AXIS_FLAGS_X,
    y = MIP_AIDING_AXIS_FLAGS_Y,
    z = MIP_AIDING_AXIS_FLAGS_Z,
};
MIP_NAMES_OF(flag_names, axis_flags, mip_names_aiding_axis_flags)

/** mip_aiding_llh_axis_flags: aiding.llh_axis_flags */
enum class llh_axis_flags : uint16_t {
    latitude = MIP_AIDING_LLH_AXIS_FLAGS_LATITUDE,
    longitude = MIP_AIDING_LLH_AXIS_FLAGS_LONGITUDE,
    height = MIP_AIDING_LLH_AXIS_FLAGS_HEIGHT,
};
MIP_NAMES_OF(flag_names, llh_axis_flags, mip_names_aiding_llh_axis_flags)

struct frame_config_response_ : ::mip_aiding_frame_config_response {
    using c_type = ::mip_aiding_frame_config_response;
    ::mip::aiding::frame_format format() const {
        return static_cast<::mip::aiding::frame_format>(c_type::format);
    }
};

/** Frame configuration response. See struct mip_aiding_frame_config_response. */
using frame_config_response = frame_config_response_;

/** Sensor frame map response. See struct mip_aiding_sensor_frame_map_response. */
using sensor_frame_map_response = ::mip_aiding_sensor_frame_map_response;

struct echo_control_response_ : ::mip_aiding_echo_control_response {
    using c_type = ::mip_aiding_echo_control_response;
    ::mip::aiding::echo_mode mode() const {
        return static_cast<::mip::aiding::echo_mode>(c_type::mode);
    }
};

/** Echo control response. See struct mip_aiding_echo_control_response. */
using echo_control_response = echo_control_response_;

/** @} */

} // namespace aiding

} // namespace mip

#endif
