/**
 * @file
 * GNSS commands, in C++17: see mip/gnss.h.
 */
#ifndef MIP_GNSS_HPP
#define MIP_GNSS_HPP

#include "mip/gnss_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_gnss_receiver_info, MIP_GNSS_RECEIVER_INFO, MIP_GNSS_RECEIVER_INFO,
           "gnss.receiver_info", decode)
MIP_LAYOUT(mip_gnss_signal_config, MIP_GNSS_SIGNAL_CONFIG, MIP_GNSS_SIGNAL_CONFIG,
           "gnss.signal_config", decode)
MIP_LAYOUT(mip_gnss_receiver_reset, MIP_GNSS_RECEIVER_RESET, MIP_GNSS_RECEIVER_RESET,
           "gnss.receiver_reset", decode_inline)
MIP_LAYOUT(mip_gnss_rtk_config, MIP_GNSS_RTK_CONFIG, MIP_GNSS_RTK_CONFIG, "gnss.rtk_config", decode)
MIP_LAYOUT(mip_gnss_rtk_dongle_config, MIP_GNSS_RTK_DONGLE_CONFIG, MIP_GNSS_RTK_DONGLE_CONFIG,
           "gnss.rtk_dongle_config", decode)
MIP_LAYOUT(mip_gnss_spartn_config, MIP_GNSS_SPARTN_CONFIG, MIP_GNSS_SPARTN_CONFIG,
           "gnss.spartn_config", decode)
MIP_LAYOUT(mip_gnss_receiver_safe_mode, MIP_GNSS_RECEIVER_SAFE_MODE, MIP_GNSS_RECEIVER_SAFE_MODE,
           "gnss.receiver_safe_mode", decode_inline)
MIP_LAYOUT(mip_gnss_receiver_info_response, MIP_GNSS_RECEIVER_INFO_RESPONSE,
           MIP_GNSS_RECEIVER_INFO_RESPONSE, "gnss.receiver_info_response", decode)
MIP_LAYOUT(mip_gnss_signal_config_response, MIP_GNSS_SIGNAL_CONFIG_RESPONSE,
           MIP_GNSS_SIGNAL_CONFIG_RESPONSE, "gnss.signal_config_response", decode_inline)
MIP_LAYOUT(mip_gnss_rtk_config_response, MIP_GNSS_RTK_CONFIG_RESPONSE, MIP_GNSS_RTK_CONFIG_RESPONSE,
           "gnss.rtk_config_response", decode_inline)
MIP_LAYOUT(mip_gnss_rtk_dongle_config_response, MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE,
           MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE, "gnss.rtk_dongle_config_response", decode_inline)
MIP_LAYOUT(mip_gnss_spartn_config_response, MIP_GNSS_SPARTN_CONFIG_RESPONSE,
           MIP_GNSS_SPARTN_CONFIG_RESPONSE, "gnss.spartn_config_response", decode_inline)

/** GNSS commands */
inline constexpr std::uint8_t gnss_set = MIP_GNSS_SET;

namespace gnss {

/** @addtogroup mip_gnss
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

/** mip_gnss_receiver_info_entry */
using receiver_info_entry = ::mip_gnss_receiver_info_entry;

/** mip_gnss_gps_signals: gnss.gps_signals */
enum class gps_signals : uint8_t {
    l1ca = MIP_GNSS_GPS_SIGNALS_L1CA,
    l2c = MIP_GNSS_GPS_SIGNALS_L2C,
    l5 = MIP_GNSS_GPS_SIGNALS_L5,
};
MIP_NAMES_OF(flag_names, gps_signals, mip_names_gnss_gps_signals)

/** mip_gnss_glonass_signals: gnss.glonass_signals */
enum class glonass_signals : uint8_t {
    l1of = MIP_GNSS_GLONASS_SIGNALS_L1OF,
    l2of = MIP_GNSS_GLONASS_SIGNALS_L2OF,
};
MIP_NAMES_OF(flag_names, glonass_signals, mip_names_gnss_glonass_signals)

/** mip_gnss_galileo_signals: gnss.galileo_signals */
enum class galileo_signals : uint8_t {
    e1 = MIP_GNSS_GALILEO_SIGNALS_E1,
    e5b = MIP_GNSS_GALILEO_SIGNALS_E5B,
    e5a = MIP_GNSS_GALILEO_SIGNALS_E5A,
};
MIP_NAMES_OF(flag_names, galileo_signals, mip_names_gnss_galileo_signals)

/** mip_gnss_beidou_signals: gnss.beidou_signals */
enum class beidou_signals : uint8_t {
    b1 = MIP_GNSS_BEIDOU_SIGNALS_B1,
    b2 = MIP_GNSS_BEIDOU_SIGNALS_B2,
    b2a = MIP_GNSS_BEIDOU_SIGNALS_B2A,
};
MIP_NAMES_OF(flag_names, beidou_signals, mip_names_gnss_beidou_signals)

/** mip_gnss_receiver_id: gnss.receiver_id */
enum class receiver_id : uint8_t {
    all = MIP_GNSS_RECEIVER_ID_ALL,
    internal_receiver_1 = MIP_GNSS_RECEIVER_ID_INTERNAL_RECEIVER_1,
    internal_receiver_2 = MIP_GNSS_RECEIVER_ID_INTERNAL_RECEIVER_2,
    user_receiver_1 = MIP_GNSS_RECEIVER_ID_USER_RECEIVER_1,
    user_receiver_2 = MIP_GNSS_RECEIVER_ID_USER_RECEIVER_2,
};
MIP_NAMES_OF(value_names, receiver_id, mip_names_gnss_receiver_id)

/** mip_gnss_receiver_reset_type: gnss.receiver_reset_type */
enum class receiver_reset_type : uint8_t {
    hardware = MIP_GNSS_RECEIVER_RESET_TYPE_HARDWARE,
    cold = MIP_GNSS_RECEIVER_RESET_TYPE_COLD,
    warm = MIP_GNSS_RECEIVER_RESET_TYPE_WARM,
    hot = MIP_GNSS_RECEIVER_RESET_TYPE_HOT,
};
MIP_NAMES_OF(value_names, receiver_reset_type, mip_names_gnss_receiver_reset_type)

/** mip_gnss_ambiguity_fix_mode: gnss.ambiguity_fix_mode */
enum class ambiguity_fix_mode : uint8_t {
    off = MIP_GNSS_AMBIGUITY_FIX_MODE_OFF,
    conservative = MIP_GNSS_AMBIGUITY_FIX_MODE_CONSERVATIVE,
    moderate = MIP_GNSS_AMBIGUITY_FIX_MODE_MODERATE,
    aggressive = MIP_GNSS_AMBIGUITY_FIX_MODE_AGGRESSIVE,
};
MIP_NAMES_OF(value_names, ambiguity_fix_mode, mip_names_gnss_ambiguity_fix_mode)

/** mip_gnss_spartn_connection: gnss.spartn_connection */
enum class spartn_connection : uint8_t {
    none = MIP_GNSS_SPARTN_CONNECTION_NONE,
    network = MIP_GNSS_SPARTN_CONNECTION_NETWORK,
    l_band = MIP_GNSS_SPARTN_CONNECTION_L_BAND,
};
MIP_NAMES_OF(value_names, spartn_connection, mip_names_gnss_spartn_connection)

struct receiver_info_response_ : ::mip_gnss_receiver_info_response {
    using c_type = ::mip_gnss_receiver_info_response;
    span<const ::mip_gnss_receiver_info_entry> receiver_info() const {
        return {c_type::receiver_info, c_type::num_receivers};
    }
};

/** Receiver info response. See struct mip_gnss_receiver_info_response. */
using receiver_info_response = receiver_info_response_;

struct signal_config_response_ : ::mip_gnss_signal_config_response {
    using c_type = ::mip_gnss_signal_config_response;
    ::mip::gnss::gps_signals gps_enable() const {
        return static_cast<::mip::gnss::gps_signals>(c_type::gps_enable);
    }
    ::mip::gnss::glonass_signals glonass_enable() const {
        return static_cast<::mip::gnss::glonass_signals>(c_type::glonass_enable);
    }
    ::mip::gnss::galileo_signals galileo_enable() const {
        return static_cast<::mip::gnss::galileo_signals>(c_type::galileo_enable);
    }
    ::mip::gnss::beidou_signals beidou_enable() const {
        return static_cast<::mip::gnss::beidou_signals>(c_type::beidou_enable);
    }
};

/** Signal configuration response. See struct mip_gnss_signal_config_response. */
using signal_config_response = signal_config_response_;

struct rtk_config_response_ : ::mip_gnss_rtk_config_response {
    using c_type = ::mip_gnss_rtk_config_response;
    ::mip::gnss::ambiguity_fix_mode ambiguity_fix_mode() const {
        return static_cast<::mip::gnss::ambiguity_fix_mode>(c_type::ambiguity_fix_mode);
    }
};

/** RTK configuration response. See struct mip_gnss_rtk_config_response. */
using rtk_config_response = rtk_config_response_;

/** RTK dongle configuration response. See struct mip_gnss_rtk_dongle_config_response. */
using rtk_dongle_config_response = ::mip_gnss_rtk_dongle_config_response;

struct spartn_config_response_ : ::mip_gnss_spartn_config_response {
    using c_type = ::mip_gnss_spartn_config_response;
    ::mip::gnss::spartn_connection type() const {
        return static_cast<::mip::gnss::spartn_connection>(c_type::type);
    }
};

/** SPARTN configuration response. See struct mip_gnss_spartn_config_response. */
using spartn_config_response = spartn_config_response_;

/** @} */

} // namespace gnss

} // namespace mip

#endif
