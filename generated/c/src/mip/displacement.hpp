/**
 * @file
 * Displacement commands, in C++17: see mip/displacement.h.
 */
#ifndef MIP_DISPLACEMENT_HPP
#define MIP_DISPLACEMENT_HPP

#include "mip/displacement.h"
#include "mip/types.hpp"

namespace mip {

/** Displacement commands */
inline constexpr std::uint8_t displacement_set = MIP_DISPLACEMENT_SET;

namespace displacement {

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

} // namespace displacement

} // namespace mip

#endif
