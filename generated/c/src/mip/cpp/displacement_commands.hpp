/**
 * @file
 * The commands of Displacement commands, in C++17: see mip/displacement_commands.h.
 */
#ifndef MIP_DISPLACEMENT_COMMANDS_HPP
#define MIP_DISPLACEMENT_COMMANDS_HPP

#include "mip/displacement_commands.h"
#include "mip/cpp/displacement.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_displacement_get_calibration, ::mip::displacement::get_calibration_response)
MIP_COMMAND_OF(mip_displacement_output_rate, ::mip::displacement::output_rate_response)
MIP_COMMAND_OF(mip_displacement_device_time, void)

namespace displacement {

/** @addtogroup mip_displacement
 * @{ */

/** Get analog to displacement calibration. See mip_call_displacement_get_calibration. */
struct get_calibration : fixed_command<::mip_displacement_get_calibration,
                                       ::mip::displacement::get_calibration_response> {};

/** Displacement output data rate: read. See mip_call_displacement_output_rate_read. */
struct read_output_rate
    : fixed_command<::mip_displacement_output_rate, ::mip::displacement::output_rate_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Displacement device time: write. See mip_call_displacement_device_time_write. */
struct write_device_time {
    uint64_t time;

    using command = ::mip_displacement_device_time;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_displacement_device_time_write(device_, time);
    }
    const command *fill(command *to_) const {
        return ::mip_displacement_device_time_write(to_, time);
    }
};

/** @} */

} // namespace displacement

} // namespace mip

#endif
