/**
 * @file
 * The commands of Awkward names, in C++17: see mip/3d_commands.h.
 */
#ifndef MIP_3D_COMMANDS_HPP
#define MIP_3D_COMMANDS_HPP

#include "mip/3d_commands.h"
#include "mip/3d.hpp"
#include "mip/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_3d_default, void)

namespace mip_3d {

/** @addtogroup mip_3d
 * @{ */

/** Default. See mip_call_3d_default. */
struct default_ {
    uint8_t class_;
    uint8_t type;
    uint8_t register_;
    uint8_t self;
    uint8_t present;

    using command = ::mip_3d_default;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_3d_default(device_, class_, type, register_, self, present);
    }
    const command *fill(command *to_) const {
        return ::mip_3d_default_make(to_, class_, type, register_, self, present);
    }
};

/** @} */

} // namespace mip_3d

} // namespace mip

#endif
