/**
 * @file
 * The commands of GNSS commands, in C++17: see mip/gnss_commands.h.
 */
#ifndef MIP_GNSS_COMMANDS_HPP
#define MIP_GNSS_COMMANDS_HPP

#include "mip/gnss_commands.h"
#include "mip/cpp/gnss.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_gnss_receiver_info, ::mip::gnss::receiver_info_response)
MIP_COMMAND_OF(mip_gnss_signal_config, ::mip::gnss::signal_config_response)
MIP_CHANGE_OF(mip_gnss_signal_config, ::mip::gnss::signal_config_response,
              mip_gnss_signal_config_write_from)
MIP_COMMAND_OF(mip_gnss_receiver_reset, void)
MIP_COMMAND_OF(mip_gnss_rtk_config, ::mip::gnss::rtk_config_response)
MIP_CHANGE_OF(mip_gnss_rtk_config, ::mip::gnss::rtk_config_response, mip_gnss_rtk_config_write_from)
MIP_COMMAND_OF(mip_gnss_rtk_dongle_config, ::mip::gnss::rtk_dongle_config_response)
MIP_CHANGE_OF(mip_gnss_rtk_dongle_config, ::mip::gnss::rtk_dongle_config_response,
              mip_gnss_rtk_dongle_config_write_from)
MIP_COMMAND_OF(mip_gnss_spartn_config, ::mip::gnss::spartn_config_response)
MIP_CHANGE_OF(mip_gnss_spartn_config, ::mip::gnss::spartn_config_response,
              mip_gnss_spartn_config_write_from)
MIP_COMMAND_OF(mip_gnss_receiver_safe_mode, void)

namespace gnss {

/** @addtogroup mip_gnss
 * @{ */

/** Receiver info. See mip_call_gnss_receiver_info. */
struct receiver_info
    : fixed_command<::mip_gnss_receiver_info, ::mip::gnss::receiver_info_response> {};

/** Signal configuration: write. See mip_call_gnss_signal_config_write. */
struct write_signal_config {
    ::mip::gnss::gps_signals gps_enable;
    ::mip::gnss::glonass_signals glonass_enable;
    ::mip::gnss::galileo_signals galileo_enable;
    ::mip::gnss::beidou_signals beidou_enable;

    using command = ::mip_gnss_signal_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_gnss_signal_config_write(
            device_, ::mip::number(gps_enable), ::mip::number(glonass_enable),
            ::mip::number(galileo_enable), ::mip::number(beidou_enable));
    }
    const command *fill(command *to_) const {
        return ::mip_gnss_signal_config_write(
            to_, ::mip::number(gps_enable), ::mip::number(glonass_enable),
            ::mip::number(galileo_enable), ::mip::number(beidou_enable));
    }
};

/** Signal configuration: read. See mip_call_gnss_signal_config_read. */
struct read_signal_config
    : fixed_command<::mip_gnss_signal_config, ::mip::gnss::signal_config_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Signal configuration: save. See mip_call_gnss_signal_config_save. */
struct save_signal_config
    : fixed_command<::mip_gnss_signal_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Signal configuration: load. See mip_call_gnss_signal_config_load. */
struct load_signal_config
    : fixed_command<::mip_gnss_signal_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Signal configuration: default. See mip_call_gnss_signal_config_default. */
struct default_signal_config
    : fixed_command<::mip_gnss_signal_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Receiver reset. See mip_call_gnss_receiver_reset. */
struct receiver_reset {
    ::mip::gnss::receiver_id receiver_id;
    ::mip::gnss::receiver_reset_type reset_type;

    using command = ::mip_gnss_receiver_reset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_gnss_receiver_reset(
            device_, static_cast<enum mip_gnss_receiver_id>(receiver_id),
            static_cast<enum mip_gnss_receiver_reset_type>(reset_type));
    }
    const command *fill(command *to_) const {
        return ::mip_gnss_receiver_reset_make(
            to_, static_cast<enum mip_gnss_receiver_id>(receiver_id),
            static_cast<enum mip_gnss_receiver_reset_type>(reset_type));
    }
};

/** RTK configuration: write. See mip_call_gnss_rtk_config_write. */
struct write_rtk_config {
    ::mip::gnss::ambiguity_fix_mode ambiguity_fix_mode;

    using command = ::mip_gnss_rtk_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_gnss_rtk_config_write(
            device_, static_cast<enum mip_gnss_ambiguity_fix_mode>(ambiguity_fix_mode));
    }
    const command *fill(command *to_) const {
        return ::mip_gnss_rtk_config_write(
            to_, static_cast<enum mip_gnss_ambiguity_fix_mode>(ambiguity_fix_mode));
    }
};

/** RTK configuration: read. See mip_call_gnss_rtk_config_read. */
struct read_rtk_config : fixed_command<::mip_gnss_rtk_config, ::mip::gnss::rtk_config_response,
                                       MIP_FUNCTION_SELECTOR_READ> {};

/** RTK configuration: save. See mip_call_gnss_rtk_config_save. */
struct save_rtk_config : fixed_command<::mip_gnss_rtk_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** RTK configuration: load. See mip_call_gnss_rtk_config_load. */
struct load_rtk_config : fixed_command<::mip_gnss_rtk_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** RTK configuration: default. See mip_call_gnss_rtk_config_default. */
struct default_rtk_config
    : fixed_command<::mip_gnss_rtk_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** RTK dongle configuration: write. See mip_call_gnss_rtk_dongle_config_write. */
struct write_rtk_dongle_config {
    uint8_t enable;

    using command = ::mip_gnss_rtk_dongle_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_gnss_rtk_dongle_config_write(device_, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_gnss_rtk_dongle_config_write(to_, enable);
    }
};

/** RTK dongle configuration: read. See mip_call_gnss_rtk_dongle_config_read. */
struct read_rtk_dongle_config
    : fixed_command<::mip_gnss_rtk_dongle_config, ::mip::gnss::rtk_dongle_config_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** RTK dongle configuration: save. See mip_call_gnss_rtk_dongle_config_save. */
struct save_rtk_dongle_config
    : fixed_command<::mip_gnss_rtk_dongle_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** RTK dongle configuration: load. See mip_call_gnss_rtk_dongle_config_load. */
struct load_rtk_dongle_config
    : fixed_command<::mip_gnss_rtk_dongle_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** RTK dongle configuration: default. See mip_call_gnss_rtk_dongle_config_default. */
struct default_rtk_dongle_config
    : fixed_command<::mip_gnss_rtk_dongle_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** SPARTN configuration: write. See mip_call_gnss_spartn_config_write. */
struct write_spartn_config {
    uint8_t enable;
    ::mip::gnss::spartn_connection type;
    uint32_t current_key_tow;
    uint16_t current_key_week;
    uint8_t current_key[32];
    uint32_t next_key_tow;
    uint16_t next_key_week;
    uint8_t next_key[32];

    using command = ::mip_gnss_spartn_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_gnss_spartn_config_write(
            device_, enable, static_cast<enum mip_gnss_spartn_connection>(type), current_key_tow,
            current_key_week, current_key, next_key_tow, next_key_week, next_key);
    }
    const command *fill(command *to_) const {
        return ::mip_gnss_spartn_config_write(
            to_, enable, static_cast<enum mip_gnss_spartn_connection>(type), current_key_tow,
            current_key_week, current_key, next_key_tow, next_key_week, next_key);
    }
};

/** SPARTN configuration: read. See mip_call_gnss_spartn_config_read. */
struct read_spartn_config
    : fixed_command<::mip_gnss_spartn_config, ::mip::gnss::spartn_config_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** SPARTN configuration: save. See mip_call_gnss_spartn_config_save. */
struct save_spartn_config
    : fixed_command<::mip_gnss_spartn_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** SPARTN configuration: load. See mip_call_gnss_spartn_config_load. */
struct load_spartn_config
    : fixed_command<::mip_gnss_spartn_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** SPARTN configuration: default. See mip_call_gnss_spartn_config_default. */
struct default_spartn_config
    : fixed_command<::mip_gnss_spartn_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Receiver safe mode. See mip_call_gnss_receiver_safe_mode. */
struct receiver_safe_mode {
    uint8_t receiver_id;
    uint8_t enable;

    using command = ::mip_gnss_receiver_safe_mode;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_gnss_receiver_safe_mode(device_, receiver_id, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_gnss_receiver_safe_mode_make(to_, receiver_id, enable);
    }
};

/** @} */

} // namespace gnss

} // namespace mip

#endif
