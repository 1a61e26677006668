/**
 * @file
 * Measurements, in C++17: see mip/measurements.h.
 */
#ifndef MIP_MEASUREMENTS_HPP
#define MIP_MEASUREMENTS_HPP

#include "mip/measurements.h"
#include "mip/types.hpp"

namespace mip {

MIP_LAYOUT(mip_measurements_accel, MIP_MEASUREMENTS_ACCEL, 0)
MIP_LAYOUT(mip_measurements_numbers, MIP_MEASUREMENTS_NUMBERS, 0)
MIP_LAYOUT(mip_measurements_strings, MIP_MEASUREMENTS_STRINGS, 0)
MIP_LAYOUT(mip_measurements_health, MIP_MEASUREMENTS_HEALTH, 0)
MIP_LAYOUT(mip_measurements_arrays, MIP_MEASUREMENTS_ARRAYS, 0)
MIP_LAYOUT(mip_measurements_growing, MIP_MEASUREMENTS_GROWING, 0)
MIP_LAYOUT(mip_measurements_radio, MIP_MEASUREMENTS_RADIO, 0)
MIP_LAYOUT(mip_measurements_own, MIP_MEASUREMENTS_OWN, MIP_MEASUREMENTS_OWN)
MIP_LAYOUT(mip_measurements_cloud, MIP_MEASUREMENTS_CLOUD, 0)
MIP_LAYOUT(mip_measurements_gust, MIP_MEASUREMENTS_GUST, 0)
MIP_LAYOUT(mip_measurements_breeze, MIP_MEASUREMENTS_BREEZE, 0)

/** Measurements */
inline constexpr std::uint8_t measurements_set = MIP_MEASUREMENTS_SET;
/** More measurements */
inline constexpr std::uint8_t more_set = MIP_MORE_SET;
/** Copied measurements */
inline constexpr std::uint8_t copy_set = MIP_COPY_SET;

namespace measurements {

/** @addtogroup mip_measurements
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

struct accel_ : ::mip_measurements_accel {
    using c_type = ::mip_measurements_accel;
    ::mip::state_flags valid_flags() const {
        return static_cast<::mip::state_flags>(c_type::valid_flags);
    }
};

/** Acceleration. See struct mip_measurements_accel. */
using accel = accel_;

/** Numbers. See struct mip_measurements_numbers. */
using numbers = ::mip_measurements_numbers;

struct strings_ : ::mip_measurements_strings {
    using c_type = ::mip_measurements_strings;
    /** May contain leading or trailing spaces. */
    std::string_view model() const {
        return ::mip::text(c_type::model);
    }
    std::string_view name() const {
        return {c_type::name, c_type::length};
    }
    std::string_view rest() const {
        return {c_type::rest, c_type::rest_count};
    }
};

/** Strings. See struct mip_measurements_strings. */
using strings = strings_;

struct health_ : ::mip_measurements_health {
    using c_type = ::mip_measurements_health;
    ::mip::wide_code code() const {
        return static_cast<::mip::wide_code>(c_type::code);
    }
};

/** Health. See struct mip_measurements_health. */
using health = health_;

/** Arrays. See struct mip_measurements_arrays. */
using arrays = ::mip_measurements_arrays;

struct growing_ : ::mip_measurements_growing {
    using c_type = ::mip_measurements_growing;
    /** If it is present. */
    std::optional<uint16_t> second() const {
        return present >= MIP_MEASUREMENTS_GROWING_WITH_SECOND
                   ? std::optional<uint16_t>(static_cast<uint16_t>(c_type::second))
                   : std::nullopt;
    }
    /** If it is present. */
    std::optional<float> third() const {
        return present >= MIP_MEASUREMENTS_GROWING_WITH_THIRD
                   ? std::optional<float>(static_cast<float>(c_type::third))
                   : std::nullopt;
    }
};

/** Growing. See struct mip_measurements_growing. */
using growing = growing_;

/** Radio. See struct mip_measurements_radio. */
using radio = ::mip_measurements_radio;

struct own_ : ::mip_measurements_own {
    using c_type = ::mip_measurements_own;
    ::mip::mode mode() const {
        return static_cast<::mip::mode>(c_type::mode);
    }
};

/** Own. See struct mip_measurements_own. */
using own = own_;

struct cloud_ : ::mip_measurements_cloud {
    using c_type = ::mip_measurements_cloud;
    span<const ::mip_point> points() const {
        return {c_type::points, c_type::num_points};
    }
};

/** Cloud. See struct mip_measurements_cloud. */
using cloud = cloud_;

struct gust_ : ::mip_measurements_gust {
    using c_type = ::mip_measurements_gust;
    ::mip::state_flags valid_flags() const {
        return static_cast<::mip::state_flags>(c_type::valid_flags);
    }
};

/** Gust. See struct mip_measurements_gust. */
using gust = gust_;

/** Breeze. See struct mip_measurements_breeze. */
using breeze = ::mip_measurements_breeze;

/** @} */

} // namespace measurements

} // namespace mip

#endif
