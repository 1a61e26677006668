/**
 * @file
 * Displacement commands, in C++17: see mip/displacement.h.
 */
#ifndef MIP_DISPLACEMENT_HPP
#define MIP_DISPLACEMENT_HPP

#include "mip/displacement_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_displacement_get_calibration, MIP_DISPLACEMENT_GET_CALIBRATION,
           MIP_DISPLACEMENT_GET_CALIBRATION, "displacement.get_calibration", decode)
MIP_LAYOUT(mip_displacement_output_rate, MIP_DISPLACEMENT_OUTPUT_RATE, MIP_DISPLACEMENT_OUTPUT_RATE,
           "displacement.output_rate", decode_inline)
MIP_LAYOUT(mip_displacement_device_time, MIP_DISPLACEMENT_DEVICE_TIME, MIP_DISPLACEMENT_DEVICE_TIME,
           "displacement.device_time", decode)
MIP_LAYOUT(mip_displacement_get_calibration_response, MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE,
           MIP_DISPLACEMENT_GET_CALIBRATION_RESPONSE, "displacement.get_calibration_response",
           decode_inline)
MIP_LAYOUT(mip_displacement_output_rate_response, MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE,
           MIP_DISPLACEMENT_OUTPUT_RATE_RESPONSE, "displacement.output_rate_response",
           decode_inline)

/** Displacement commands */
inline constexpr std::uint8_t displacement_set = MIP_DISPLACEMENT_SET;

namespace displacement {

/** @addtogroup mip_displacement
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

/**
 * Get analog to displacement calibration response. See struct
 * mip_displacement_get_calibration_response.
 */
using get_calibration_response = ::mip_displacement_get_calibration_response;

/** Displacement output data rate response. See struct mip_displacement_output_rate_response. */
using output_rate_response = ::mip_displacement_output_rate_response;

/** @} */

} // namespace displacement

} // namespace mip

#endif
