/**
 * @file
 * Awkward names, in C++17: see mip/3d.h.
 */
#ifndef MIP_3D_HPP
#define MIP_3D_HPP

#include "mip/3d.h"
#include "mip/types.hpp"

namespace mip {

MIP_LAYOUT(mip_3d_default, MIP_3D_DEFAULT, MIP_3D_DEFAULT)

/** Awkward names */
inline constexpr std::uint8_t mip_3d_set = MIP_3D_SET;

namespace mip_3d {

/** @addtogroup mip_3d
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

/** @} */

} // namespace mip_3d

} // namespace mip

#endif
