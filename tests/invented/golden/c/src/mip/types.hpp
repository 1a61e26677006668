/**
 * @file
 * The types that descriptor sets share, in C++17: see mip/types.h and mip/protocol.h.
 */
#ifndef MIP_TYPES_HPP
#define MIP_TYPES_HPP

#include "mip/core.hpp"
#include "mip/names.h"
#include "mip/protocol.h"

namespace mip {

MIP_LAYOUT(mip_protocol_acknowledge, MIP_PROTOCOL_ACKNOWLEDGE, MIP_PROTOCOL_ACKNOWLEDGE)

/** mip_function_selector: function_selector */
enum class function_selector : uint8_t {
    write = MIP_FUNCTION_SELECTOR_WRITE,
    read = MIP_FUNCTION_SELECTOR_READ,
    save = MIP_FUNCTION_SELECTOR_SAVE,
    load = MIP_FUNCTION_SELECTOR_LOAD,
    default_ = MIP_FUNCTION_SELECTOR_DEFAULT,
    apply = MIP_FUNCTION_SELECTOR_APPLY,
};
inline value_names names_of(function_selector) {
    return {::mip_names_function_selector};
}

/** mip_ack_code: ack_code */
enum class ack_code : uint8_t {
    ok = MIP_ACK_CODE_OK,
    unknown_command = MIP_ACK_CODE_UNKNOWN,
    invalid_parameter = MIP_ACK_CODE_INVALID_PARAMETER,
};
inline value_names names_of(ack_code) {
    return {::mip_names_ack_code};
}

/** mip_mode: mode */
enum class mode : uint8_t {
    default_ = MIP_MODE_DEFAULT,
    fast = MIP_MODE_FAST,
    slow = MIP_MODE_SLOW,
};
inline value_names names_of(mode) {
    return {::mip_names_mode};
}

/** mip_wide_code: wide_code */
enum class wide_code : uint32_t {
    low = MIP_WIDE_CODE_LOW,
    high = MIP_WIDE_CODE_HIGH,
};
inline value_names names_of(wide_code) {
    return {::mip_names_wide_code};
}

/** mip_state_flags: state_flags */
enum class state_flags : uint16_t {
    ready = MIP_STATE_FLAGS_READY,
    hot = MIP_STATE_FLAGS_HOT,
    level = MIP_STATE_FLAGS_LEVEL,
    mode = MIP_STATE_FLAGS_MODE,
    any = MIP_STATE_FLAGS_OR,
};
inline flag_names names_of(state_flags) {
    return {::mip_names_state_flags};
}

/** mip_health: health */
using health = ::mip_health;

/** The bits of health, for mip::get and mip::has. */
enum class health_bits : std::uint16_t {
    clock = MIP_HEALTH_CLOCK,
    hot = MIP_HEALTH_HOT,
    level = MIP_HEALTH_LEVEL,
    power = MIP_HEALTH_POWER,
    count = MIP_HEALTH_NUM,
    last = MIP_HEALTH_LAST,
};
inline bit_names names_of(health_bits) {
    return {::mip_names_health};
}

/** mip_point */
using point = ::mip_point;

/** mip_segment */
using segment = ::mip_segment;

struct acknowledge_ : ::mip_protocol_acknowledge {
    using c_type = ::mip_protocol_acknowledge;
    ::mip::ack_code code() const {
        return static_cast<::mip::ack_code>(c_type::code);
    }
};

/** Acknowledge. See struct mip_protocol_acknowledge. */
using acknowledge = acknowledge_;

} // namespace mip

#endif
