/**
 * @file
 * Tools, in C++17: see mip/tools.h.
 */
#ifndef MIP_TOOLS_HPP
#define MIP_TOOLS_HPP

#include "mip/tools.h"
#include "mip/types.hpp"

namespace mip {

MIP_LAYOUT(mip_tools_ping, MIP_TOOLS_PING, MIP_TOOLS_PING)
MIP_LAYOUT(mip_tools_settings, MIP_TOOLS_SETTINGS, MIP_TOOLS_SETTINGS)
MIP_LAYOUT(mip_tools_set_time, MIP_TOOLS_SET_TIME, MIP_TOOLS_SET_TIME)
MIP_LAYOUT(mip_tools_status, MIP_TOOLS_STATUS, MIP_TOOLS_STATUS)
MIP_LAYOUT(mip_tools_bias, MIP_TOOLS_BIAS, MIP_TOOLS_BIAS)
MIP_LAYOUT(mip_tools_capture_bias, MIP_TOOLS_CAPTURE_BIAS, MIP_TOOLS_CAPTURE_BIAS)
MIP_LAYOUT(mip_tools_formats, MIP_TOOLS_FORMATS, MIP_TOOLS_FORMATS)
MIP_LAYOUT(mip_tools_choice, MIP_TOOLS_CHOICE, MIP_TOOLS_CHOICE)
MIP_LAYOUT(mip_tools_list, MIP_TOOLS_LIST, MIP_TOOLS_LIST)
MIP_LAYOUT(mip_tools_stock, MIP_TOOLS_STOCK, MIP_TOOLS_STOCK)
MIP_LAYOUT(mip_tools_pin, MIP_TOOLS_PIN, MIP_TOOLS_PIN)
MIP_LAYOUT(mip_tools_hello, MIP_TOOLS_HELLO, MIP_TOOLS_HELLO)
MIP_LAYOUT(mip_tools_readings, MIP_TOOLS_READINGS, MIP_TOOLS_READINGS)
MIP_LAYOUT(mip_tools_poll, MIP_TOOLS_POLL, MIP_TOOLS_POLL)
MIP_LAYOUT(mip_tools_settings_response, MIP_TOOLS_SETTINGS_RESPONSE, MIP_TOOLS_SETTINGS_RESPONSE)
MIP_LAYOUT(mip_tools_set_time_fast_response, MIP_TOOLS_SET_TIME_FAST_RESPONSE,
           MIP_TOOLS_SET_TIME_FAST_RESPONSE)
MIP_LAYOUT(mip_tools_set_time_slow_response, MIP_TOOLS_SET_TIME_SLOW_RESPONSE,
           MIP_TOOLS_SET_TIME_SLOW_RESPONSE)
MIP_LAYOUT(mip_tools_choice_response, MIP_TOOLS_CHOICE_RESPONSE, MIP_TOOLS_CHOICE_RESPONSE)
MIP_LAYOUT(mip_tools_list_response, MIP_TOOLS_LIST_RESPONSE, MIP_TOOLS_LIST_RESPONSE)
MIP_LAYOUT(mip_tools_stock_response, MIP_TOOLS_STOCK_RESPONSE, MIP_TOOLS_STOCK_RESPONSE)
MIP_LAYOUT(mip_tools_pin_response, MIP_TOOLS_PIN_RESPONSE, MIP_TOOLS_PIN_RESPONSE)
MIP_LAYOUT(mip_tools_hello_response, MIP_TOOLS_HELLO_RESPONSE, MIP_TOOLS_HELLO_RESPONSE)
MIP_LAYOUT(mip_tools_readings_response, MIP_TOOLS_READINGS_RESPONSE, MIP_TOOLS_READINGS_RESPONSE)
MIP_LAYOUT(mip_tools_status_paged, MIP_TOOLS_STATUS_PAGED, MIP_TOOLS_STATUS_PAGED)
MIP_LAYOUT(mip_tools_status_short, MIP_TOOLS_STATUS_SHORT, MIP_TOOLS_STATUS_SHORT)
MIP_LAYOUT(mip_tools_status_long, MIP_TOOLS_STATUS_LONG, MIP_TOOLS_STATUS_LONG)
MIP_LAYOUT(mip_tools_status_old, MIP_TOOLS_STATUS_OLD, MIP_TOOLS_STATUS_OLD)
MIP_LAYOUT(mip_tools_full, MIP_TOOLS_FULL, MIP_TOOLS_FULL)
MIP_LAYOUT(mip_tools_bias_vector, MIP_TOOLS_BIAS_VECTOR, MIP_TOOLS_BIAS_VECTOR)

/** Tools */
inline constexpr std::uint8_t tools_set = MIP_TOOLS_SET;

namespace tools {

/** @addtogroup mip_tools
 * @{ */

using ::mip::operator|;
using ::mip::operator&;
using ::mip::operator^;
using ::mip::operator~;
using ::mip::operator|=;
using ::mip::operator&=;
using ::mip::operator^=;
using ::mip::operator<<;
using ::mip::get;
using ::mip::has;
using ::mip::to_string;

/** mip_tools_shape: tools.shape */
enum class shape : uint8_t {
    none = MIP_TOOLS_SHAPE_NONE,
    circle = MIP_TOOLS_SHAPE_CIRCLE,
    path = MIP_TOOLS_SHAPE_PATH,
    turn = MIP_TOOLS_SHAPE_TURN,
    label = MIP_TOOLS_SHAPE_LABEL,
};
inline value_names names_of(shape) {
    return {::mip_names_tools_shape};
}

/** mip_tools_fill: tools.fill */
enum class fill : uint8_t {
    empty = MIP_TOOLS_FILL_EMPTY,
    solid = MIP_TOOLS_FILL_SOLID,
    striped = MIP_TOOLS_FILL_STRIPED,
};
inline value_names names_of(fill) {
    return {::mip_names_tools_fill};
}

/** mip_tools_bars */
using stripes = ::mip_tools_bars;

/** mip_tools_circle */
using circle = ::mip_tools_circle;

/** mip_tools_path */
using path = ::mip_tools_path;

/** mip_tools_drive: tools.drive */
enum class drive : uint8_t {
    off = MIP_TOOLS_DRIVE_OFF,
    pulse = MIP_TOOLS_DRIVE_PULSE,
    serial = MIP_TOOLS_DRIVE_SERIAL,
};
inline value_names names_of(drive) {
    return {::mip_names_tools_drive};
}

/** mip_tools_pulse: tools.pulse_use */
enum class pulse_use : uint8_t {
    input = MIP_TOOLS_PULSE_INPUT,
    output = MIP_TOOLS_PULSE_OUTPUT,
};
inline value_names names_of(pulse_use) {
    return {::mip_names_tools_pulse};
}

/** mip_tools_serial_use: tools.serial_use */
enum class serial_use : uint8_t {
    receive = MIP_TOOLS_SERIAL_USE_RECEIVE,
    transmit = MIP_TOOLS_SERIAL_USE_TRANSMIT,
};
inline value_names names_of(serial_use) {
    return {::mip_names_tools_serial_use};
}

/** mip_tools_reading */
using reading = ::mip_tools_reading;

/** mip_tools_a_faults: tools.model_a_faults */
enum class model_a_faults : uint32_t {
    clock = MIP_TOOLS_A_FAULTS_CLOCK,
    sensor = MIP_TOOLS_A_FAULTS_SENSOR,
    solution = MIP_TOOLS_A_FAULTS_SOLUTION,
};
inline flag_names names_of(model_a_faults) {
    return {::mip_names_tools_a_faults};
}

/** mip_tools_model_b_faults: tools.model_b_faults */
enum class model_b_faults : uint32_t {
    general = MIP_TOOLS_MODEL_B_FAULTS_GENERAL,
    overload = MIP_TOOLS_MODEL_B_FAULTS_OVERLOAD,
    accel = MIP_TOOLS_MODEL_B_FAULTS_ACCEL,
};
inline flag_names names_of(model_b_faults) {
    return {::mip_names_tools_model_b_faults};
}

struct settings_response_ : ::mip_tools_settings_response {
    using c_type = ::mip_tools_settings_response;
    ::mip::mode mode() const {
        return static_cast<::mip::mode>(c_type::mode);
    }
};

/** Settings response. See struct mip_tools_settings_response. */
using settings_response = settings_response_;

/** Set time response. See struct mip_tools_set_time_fast_response. */
using set_time_fast_response = ::mip_tools_set_time_fast_response;

/** Set time response. See struct mip_tools_set_time_slow_response. */
using set_time_slow_response = ::mip_tools_set_time_slow_response;

/** Status response. See struct mip_tools_status_paged. */
using status_paged = ::mip_tools_status_paged;

/** Status response. See struct mip_tools_status_short. */
using status_short = ::mip_tools_status_short;

/** Status response. See struct mip_tools_status_long. */
using status_long = ::mip_tools_status_long;

/** Status response. See struct mip_tools_status_old. */
using status_old = ::mip_tools_status_old;

struct status_full_ : ::mip_tools_full {
    using c_type = ::mip_tools_full;
    ::mip::mode mode() const {
        return static_cast<::mip::mode>(c_type::mode);
    }
};

/** Status response. See struct mip_tools_full. */
using status_full = status_full_;

/** Bias response. See struct mip_tools_bias_vector. */
using bias_vector = ::mip_tools_bias_vector;

struct choice_response_ : ::mip_tools_choice_response {
    using c_type = ::mip_tools_choice_response;
    ::mip::tools::shape shape() const {
        return static_cast<::mip::tools::shape>(c_type::shape);
    }
};

/** Choice response. See struct mip_tools_choice_response. */
using choice_response = choice_response_;

struct list_response_ : ::mip_tools_list_response {
    using c_type = ::mip_tools_list_response;
    span<const uint16_t> items() const {
        return {c_type::items, c_type::count};
    }
};

/** List response. See struct mip_tools_list_response. */
using list_response = list_response_;

struct inventory_response_ : ::mip_tools_stock_response {
    using c_type = ::mip_tools_stock_response;
    span<const uint16_t> descriptors() const {
        return {c_type::descriptors, c_type::descriptors_count};
    }
};

/** Inventory response. See struct mip_tools_stock_response. */
using inventory_response = inventory_response_;

struct pin_response_ : ::mip_tools_pin_response {
    using c_type = ::mip_tools_pin_response;
    ::mip::tools::drive drive() const {
        return static_cast<::mip::tools::drive>(c_type::drive);
    }
};

/** Pin response. See struct mip_tools_pin_response. */
using pin_response = pin_response_;

/** Hello response. See struct mip_tools_hello_response. */
using hello_response = ::mip_tools_hello_response;

struct readings_response_ : ::mip_tools_readings_response {
    using c_type = ::mip_tools_readings_response;
    ::mip::tools::drive drive() const {
        return static_cast<::mip::tools::drive>(c_type::drive);
    }
    span<const ::mip_tools_reading> readings() const {
        return {c_type::readings, c_type::count};
    }
};

/** Readings response. See struct mip_tools_readings_response. */
using readings_response = readings_response_;

/** @} */

} // namespace tools

} // namespace mip

#endif
