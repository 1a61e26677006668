/**
 * @file
 * System data, in C++17: see mip/system_data.h.
 */
#ifndef MIP_SYSTEM_DATA_HPP
#define MIP_SYSTEM_DATA_HPP

#include "mip/system_data_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_system_data_built_in_test, MIP_SYSTEM_DATA_BUILT_IN_TEST,
           MIP_SYSTEM_DATA_BUILT_IN_TEST, "system_data.built_in_test", decode_inline)
MIP_LAYOUT(mip_system_data_time_sync_status, MIP_SYSTEM_DATA_TIME_SYNC_STATUS,
           MIP_SYSTEM_DATA_TIME_SYNC_STATUS, "system_data.time_sync_status", decode_inline)
MIP_LAYOUT(mip_system_data_gpio_state, MIP_SYSTEM_DATA_GPIO_STATE, MIP_SYSTEM_DATA_GPIO_STATE,
           "system_data.gpio_state", decode_inline)
MIP_LAYOUT(mip_system_data_gpio_analog_value, MIP_SYSTEM_DATA_GPIO_ANALOG_VALUE,
           MIP_SYSTEM_DATA_GPIO_ANALOG_VALUE, "system_data.gpio_analog_value", decode_inline)

/** System data */
inline constexpr std::uint8_t system_data_set = MIP_SYSTEM_DATA_SET;

namespace system_data {

/** @addtogroup mip_system_data
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

/** mip_system_data_gpio_pin_states: system_data.gpio_pin_states */
enum class gpio_pin_states : uint8_t {
    pin_1 = MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_1,
    pin_2 = MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_2,
    pin_3 = MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_3,
    pin_4 = MIP_SYSTEM_DATA_GPIO_PIN_STATES_PIN_4,
};
MIP_NAMES_OF(flag_names, gpio_pin_states, mip_names_system_data_gpio_pin_states)

/** Built-in test. See struct mip_system_data_built_in_test. */
using built_in_test = ::mip_system_data_built_in_test;

/** Time sync status. See struct mip_system_data_time_sync_status. */
using time_sync_status = ::mip_system_data_time_sync_status;

struct gpio_state_ : ::mip_system_data_gpio_state {
    using c_type = ::mip_system_data_gpio_state;
    ::mip::system_data::gpio_pin_states states() const {
        return static_cast<::mip::system_data::gpio_pin_states>(c_type::states);
    }
};

/** GPIO state. See struct mip_system_data_gpio_state. */
using gpio_state = gpio_state_;

/** GPIO analog value. See struct mip_system_data_gpio_analog_value. */
using gpio_analog_value = ::mip_system_data_gpio_analog_value;

/** @} */

} // namespace system_data

} // namespace mip

#endif
