/**
 * @file
 * Shared, in C++17: see mip/shared.h.
 */
#ifndef MIP_SHARED_HPP
#define MIP_SHARED_HPP

#include "mip/shared.h"
#include "mip/types.hpp"

namespace mip {

MIP_LAYOUT(mip_shared_timestamp, MIP_SHARED_TIMESTAMP, MIP_SHARED_TIMESTAMP)

/** Shared */
inline constexpr std::uint8_t shared_set = MIP_SHARED_SET;

namespace shared {

/** @addtogroup mip_shared
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

struct timestamp_ : ::mip_shared_timestamp {
    using c_type = ::mip_shared_timestamp;
    ::mip::state_flags valid_flags() const {
        return static_cast<::mip::state_flags>(c_type::valid_flags);
    }
};

/** Timestamp. See struct mip_shared_timestamp. */
using timestamp = timestamp_;

/** @} */

} // namespace shared

} // namespace mip

#endif
