/**
 * @file
 * Shared data, in C++17: see mip/shared.h.
 */
#ifndef MIP_SHARED_HPP
#define MIP_SHARED_HPP

#include "mip/shared_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_shared_event_source, MIP_SHARED_EVENT_SOURCE, MIP_SHARED_EVENT_SOURCE,
           "shared.event_source", decode_inline)
MIP_LAYOUT(mip_shared_ticks, MIP_SHARED_TICKS, MIP_SHARED_TICKS, "shared.ticks", decode_inline)
MIP_LAYOUT(mip_shared_delta_ticks, MIP_SHARED_DELTA_TICKS, MIP_SHARED_DELTA_TICKS,
           "shared.delta_ticks", decode_inline)
MIP_LAYOUT(mip_shared_gps_timestamp, MIP_SHARED_GPS_TIMESTAMP, MIP_SHARED_GPS_TIMESTAMP,
           "shared.gps_timestamp", decode_inline)
MIP_LAYOUT(mip_shared_delta_time, MIP_SHARED_DELTA_TIME, MIP_SHARED_DELTA_TIME, "shared.delta_time",
           decode_inline)
MIP_LAYOUT(mip_shared_reference_timestamp, MIP_SHARED_REFERENCE_TIMESTAMP,
           MIP_SHARED_REFERENCE_TIMESTAMP, "shared.reference_timestamp", decode_inline)
MIP_LAYOUT(mip_shared_reference_time_delta, MIP_SHARED_REFERENCE_TIME_DELTA,
           MIP_SHARED_REFERENCE_TIME_DELTA, "shared.reference_time_delta", decode_inline)
MIP_LAYOUT(mip_shared_external_timestamp, MIP_SHARED_EXTERNAL_TIMESTAMP,
           MIP_SHARED_EXTERNAL_TIMESTAMP, "shared.external_timestamp", decode_inline)
MIP_LAYOUT(mip_shared_external_time_delta, MIP_SHARED_EXTERNAL_TIME_DELTA,
           MIP_SHARED_EXTERNAL_TIME_DELTA, "shared.external_time_delta", decode_inline)

/** Shared data */
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
#ifdef MIP_NAMES_H
using ::mip::operator<<;
#endif
using ::mip::get;
using ::mip::has;
using ::mip::to_string;

/** mip_shared_gps_timestamp_flags: shared.gps_timestamp_flags */
enum class gps_timestamp_flags : uint16_t {
    tow = MIP_SHARED_GPS_TIMESTAMP_FLAGS_TOW,
    week_number = MIP_SHARED_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER,
    time_valid = MIP_SHARED_GPS_TIMESTAMP_FLAGS_TIME_VALID,
};
MIP_NAMES_OF(flag_names, gps_timestamp_flags, mip_names_shared_gps_timestamp_flags)

/** mip_shared_external_timestamp_flags: shared.external_timestamp_flags */
enum class external_timestamp_flags : uint16_t {
    nanoseconds = MIP_SHARED_EXTERNAL_TIMESTAMP_FLAGS_NANOSECONDS,
};
MIP_NAMES_OF(flag_names, external_timestamp_flags, mip_names_shared_external_timestamp_flags)

/** mip_shared_external_time_delta_flags: shared.external_time_delta_flags */
enum class external_time_delta_flags : uint16_t {
    dt_nanos = MIP_SHARED_EXTERNAL_TIME_DELTA_FLAGS_DT_NANOS,
};
MIP_NAMES_OF(flag_names, external_time_delta_flags, mip_names_shared_external_time_delta_flags)

/** Event source. See struct mip_shared_event_source. */
using event_source = ::mip_shared_event_source;

/** Ticks. See struct mip_shared_ticks. */
using ticks = ::mip_shared_ticks;

/** Delta ticks. See struct mip_shared_delta_ticks. */
using delta_ticks = ::mip_shared_delta_ticks;

struct gps_timestamp_ : ::mip_shared_gps_timestamp {
    using c_type = ::mip_shared_gps_timestamp;
    ::mip::shared::gps_timestamp_flags valid_flags() const {
        return static_cast<::mip::shared::gps_timestamp_flags>(c_type::valid_flags);
    }
};

/** GPS timestamp. See struct mip_shared_gps_timestamp. */
using gps_timestamp = gps_timestamp_;

/** Delta time. See struct mip_shared_delta_time. */
using delta_time = ::mip_shared_delta_time;

/** Reference timestamp. See struct mip_shared_reference_timestamp. */
using reference_timestamp = ::mip_shared_reference_timestamp;

/** Reference time delta. See struct mip_shared_reference_time_delta. */
using reference_time_delta = ::mip_shared_reference_time_delta;

struct external_timestamp_ : ::mip_shared_external_timestamp {
    using c_type = ::mip_shared_external_timestamp;
    ::mip::shared::external_timestamp_flags valid_flags() const {
        return static_cast<::mip::shared::external_timestamp_flags>(c_type::valid_flags);
    }
};

/** External timestamp. See struct mip_shared_external_timestamp. */
using external_timestamp = external_timestamp_;

struct external_time_delta_ : ::mip_shared_external_time_delta {
    using c_type = ::mip_shared_external_time_delta;
    ::mip::shared::external_time_delta_flags valid_flags() const {
        return static_cast<::mip::shared::external_time_delta_flags>(c_type::valid_flags);
    }
};

/** External time delta. See struct mip_shared_external_time_delta. */
using external_time_delta = external_time_delta_;

/** @} */

} // namespace shared

} // namespace mip

#endif
