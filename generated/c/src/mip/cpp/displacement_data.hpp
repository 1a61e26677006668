/**
 * @file
 * Displacement data, in C++17: see mip/displacement_data.h.
 */
#ifndef MIP_DISPLACEMENT_DATA_HPP
#define MIP_DISPLACEMENT_DATA_HPP

#include "mip/displacement_data_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_displacement_data_displacement_raw, MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW,
           MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW, "displacement_data.displacement_raw",
           decode_inline)
MIP_LAYOUT(mip_displacement_data_displacement, MIP_DISPLACEMENT_DATA_DISPLACEMENT,
           MIP_DISPLACEMENT_DATA_DISPLACEMENT, "displacement_data.displacement", decode_inline)
MIP_LAYOUT(mip_displacement_data_timestamp, MIP_DISPLACEMENT_DATA_TIMESTAMP,
           MIP_DISPLACEMENT_DATA_TIMESTAMP, "displacement_data.timestamp", decode_inline)

/** Displacement data */
inline constexpr std::uint8_t displacement_data_set = MIP_DISPLACEMENT_DATA_SET;

namespace displacement_data {

/** @addtogroup mip_displacement_data
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

/** mip_displacement_data_timestamp_flags: displacement_data.timestamp_flags */
enum class timestamp_flags : uint8_t {
    time = MIP_DISPLACEMENT_DATA_TIMESTAMP_FLAGS_TIME,
};
MIP_NAMES_OF(flag_names, timestamp_flags, mip_names_displacement_data_timestamp_flags)

/** Raw displacement. See struct mip_displacement_data_displacement_raw. */
using displacement_raw = ::mip_displacement_data_displacement_raw;

/** Displacement. See struct mip_displacement_data_displacement. */
using displacement = ::mip_displacement_data_displacement;

struct timestamp_ : ::mip_displacement_data_timestamp {
    using c_type = ::mip_displacement_data_timestamp;
    ::mip::displacement_data::timestamp_flags flags() const {
        return static_cast<::mip::displacement_data::timestamp_flags>(c_type::flags);
    }
};

/** Displacement device timestamp. See struct mip_displacement_data_timestamp. */
using timestamp = timestamp_;

/** @} */

} // namespace displacement_data

} // namespace mip

#endif
