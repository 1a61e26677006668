/**
 * @file
 * System, in C++17: see mip/system.h.
 */
#ifndef MIP_SYSTEM_HPP
#define MIP_SYSTEM_HPP

#include "mip/system_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_system_interface_control, MIP_SYSTEM_INTERFACE_CONTROL, MIP_SYSTEM_INTERFACE_CONTROL,
           "system.interface_control", decode)
MIP_LAYOUT(mip_system_comm_mode, MIP_SYSTEM_COMM_MODE, MIP_SYSTEM_COMM_MODE, "system.comm_mode",
           decode)
MIP_LAYOUT(mip_system_interface_control_response, MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE,
           MIP_SYSTEM_INTERFACE_CONTROL_RESPONSE, "system.interface_control_response",
           decode_inline)
MIP_LAYOUT(mip_system_comm_mode_response, MIP_SYSTEM_COMM_MODE_RESPONSE,
           MIP_SYSTEM_COMM_MODE_RESPONSE, "system.comm_mode_response", decode_inline)

/** System */
inline constexpr std::uint8_t system_set = MIP_SYSTEM_SET;

namespace system {

/** @addtogroup mip_system
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

/** mip_system_comm_protocols: system.comm_protocols */
enum class comm_protocols : uint32_t {
    mip = MIP_SYSTEM_COMM_PROTOCOLS_MIP,
    nmea = MIP_SYSTEM_COMM_PROTOCOLS_NMEA,
    rtcm = MIP_SYSTEM_COMM_PROTOCOLS_RTCM,
    spartn = MIP_SYSTEM_COMM_PROTOCOLS_SPARTN,
    sbf = MIP_SYSTEM_COMM_PROTOCOLS_SBF,
};
MIP_NAMES_OF(flag_names, comm_protocols, mip_names_system_comm_protocols)

/** mip_system_protocol_mode: system.protocol_mode */
enum class protocol_mode : uint8_t {
    standard = MIP_SYSTEM_PROTOCOL_MODE_STANDARD,
    sensor_direct = MIP_SYSTEM_PROTOCOL_MODE_SENSOR_DIRECT,
    gnss_direct = MIP_SYSTEM_PROTOCOL_MODE_GNSS_DIRECT,
};
MIP_NAMES_OF(value_names, protocol_mode, mip_names_system_protocol_mode)

struct interface_control_response_ : ::mip_system_interface_control_response {
    using c_type = ::mip_system_interface_control_response;
    ::mip::comm_interface port() const {
        return static_cast<::mip::comm_interface>(c_type::port);
    }
    ::mip::system::comm_protocols protocols_incoming() const {
        return static_cast<::mip::system::comm_protocols>(c_type::protocols_incoming);
    }
    ::mip::system::comm_protocols protocols_outgoing() const {
        return static_cast<::mip::system::comm_protocols>(c_type::protocols_outgoing);
    }
};

/** Interface control response. See struct mip_system_interface_control_response. */
using interface_control_response = interface_control_response_;

struct comm_mode_response_ : ::mip_system_comm_mode_response {
    using c_type = ::mip_system_comm_mode_response;
    ::mip::system::protocol_mode mode() const {
        return static_cast<::mip::system::protocol_mode>(c_type::mode);
    }
};

/** Communication mode response. See struct mip_system_comm_mode_response. */
using comm_mode_response = comm_mode_response_;

/** @} */

} // namespace system

} // namespace mip

#endif
