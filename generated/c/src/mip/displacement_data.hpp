/**
 * @file
 * Displacement data, in C++17: see mip/displacement_data.h.
 */
#ifndef MIP_DISPLACEMENT_DATA_HPP
#define MIP_DISPLACEMENT_DATA_HPP

#include "mip/displacement_data.h"
#include "mip/types.hpp"

namespace mip {

MIP_LAYOUT(mip_displacement_data_displacement_raw, MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW,
           MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW)
MIP_LAYOUT(mip_displacement_data_displacement, MIP_DISPLACEMENT_DATA_DISPLACEMENT,
           MIP_DISPLACEMENT_DATA_DISPLACEMENT)

/** Displacement data */
inline constexpr std::uint8_t displacement_data_set = MIP_DISPLACEMENT_DATA_SET;

namespace displacement_data {

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

/** Raw displacement. See struct mip_displacement_data_displacement_raw. */
using displacement_raw = ::mip_displacement_data_displacement_raw;

/** Displacement. See struct mip_displacement_data_displacement. */
using displacement = ::mip_displacement_data_displacement;

} // namespace displacement_data

} // namespace mip

#endif
