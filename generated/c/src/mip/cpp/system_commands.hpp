/**
 * @file
 * The commands of System, in C++17: see mip/system_commands.h.
 */
#ifndef MIP_SYSTEM_COMMANDS_HPP
#define MIP_SYSTEM_COMMANDS_HPP

#include "mip/system_commands.h"
#include "mip/cpp/system.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_system_interface_control, ::mip::system::interface_control_response)
MIP_CHANGE_OF(mip_system_interface_control, ::mip::system::interface_control_response,
              mip_system_interface_control_write_from)
MIP_COMMAND_OF(mip_system_comm_mode, ::mip::system::comm_mode_response)
MIP_CHANGE_OF(mip_system_comm_mode, ::mip::system::comm_mode_response,
              mip_system_comm_mode_write_from)

namespace system {

/** @addtogroup mip_system
 * @{ */

/** Interface control: write. See mip_call_system_interface_control_write. */
struct write_interface_control {
    ::mip::comm_interface port;
    ::mip::system::comm_protocols protocols_incoming;
    ::mip::system::comm_protocols protocols_outgoing;

    using command = ::mip_system_interface_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_system_interface_control_write(
            device_, static_cast<enum mip_comm_interface>(port), ::mip::number(protocols_incoming),
            ::mip::number(protocols_outgoing));
    }
    const command *fill(command *to_) const {
        return ::mip_system_interface_control_write(to_, static_cast<enum mip_comm_interface>(port),
                                                    ::mip::number(protocols_incoming),
                                                    ::mip::number(protocols_outgoing));
    }
};

/** Interface control: read. See mip_call_system_interface_control_read. */
struct read_interface_control {
    ::mip::comm_interface port;

    using command = ::mip_system_interface_control;
    using response = ::mip::system::interface_control_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_system_interface_control_read(
            device_, static_cast<enum mip_comm_interface>(port), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_system_interface_control_read(to_, static_cast<enum mip_comm_interface>(port));
    }
};

/** Interface control: save. See mip_call_system_interface_control_save. */
struct save_interface_control {
    ::mip::comm_interface port;

    using command = ::mip_system_interface_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_system_interface_control_save(device_,
                                                        static_cast<enum mip_comm_interface>(port));
    }
    const command *fill(command *to_) const {
        return ::mip_system_interface_control_save(to_, static_cast<enum mip_comm_interface>(port));
    }
};

/** Interface control: load. See mip_call_system_interface_control_load. */
struct load_interface_control {
    ::mip::comm_interface port;

    using command = ::mip_system_interface_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_system_interface_control_load(device_,
                                                        static_cast<enum mip_comm_interface>(port));
    }
    const command *fill(command *to_) const {
        return ::mip_system_interface_control_load(to_, static_cast<enum mip_comm_interface>(port));
    }
};

/** Interface control: default. See mip_call_system_interface_control_default. */
struct default_interface_control {
    ::mip::comm_interface port;

    using command = ::mip_system_interface_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_system_interface_control_default(
            device_, static_cast<enum mip_comm_interface>(port));
    }
    const command *fill(command *to_) const {
        return ::mip_system_interface_control_default(to_,
                                                      static_cast<enum mip_comm_interface>(port));
    }
};

/** Communication mode: write. See mip_call_system_comm_mode_write. */
struct write_comm_mode {
    ::mip::system::protocol_mode mode;

    using command = ::mip_system_comm_mode;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_system_comm_mode_write(device_,
                                                 static_cast<enum mip_system_protocol_mode>(mode));
    }
    const command *fill(command *to_) const {
        return ::mip_system_comm_mode_write(to_, static_cast<enum mip_system_protocol_mode>(mode));
    }
};

/** Communication mode: read. See mip_call_system_comm_mode_read. */
struct read_comm_mode : fixed_command<::mip_system_comm_mode, ::mip::system::comm_mode_response,
                                      MIP_FUNCTION_SELECTOR_READ> {};

/** Communication mode: save. See mip_call_system_comm_mode_save. */
struct save_comm_mode : fixed_command<::mip_system_comm_mode, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Communication mode: load. See mip_call_system_comm_mode_load. */
struct load_comm_mode : fixed_command<::mip_system_comm_mode, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Communication mode: default. See mip_call_system_comm_mode_default. */
struct default_comm_mode
    : fixed_command<::mip_system_comm_mode, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** @} */

} // namespace system

} // namespace mip

#endif
