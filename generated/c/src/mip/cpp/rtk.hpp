/**
 * @file
 * RTK commands, in C++17: see mip/rtk.h.
 */
#ifndef MIP_RTK_HPP
#define MIP_RTK_HPP

#include "mip/rtk_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_rtk_get_status_flags, MIP_RTK_GET_STATUS_FLAGS, MIP_RTK_GET_STATUS_FLAGS,
           "rtk.get_status_flags", decode)
MIP_LAYOUT(mip_rtk_get_imei, MIP_RTK_GET_IMEI, MIP_RTK_GET_IMEI, "rtk.get_imei", decode)
MIP_LAYOUT(mip_rtk_get_imsi, MIP_RTK_GET_IMSI, MIP_RTK_GET_IMSI, "rtk.get_imsi", decode)
MIP_LAYOUT(mip_rtk_get_iccid, MIP_RTK_GET_ICCID, MIP_RTK_GET_ICCID, "rtk.get_iccid", decode)
MIP_LAYOUT(mip_rtk_get_rssi, MIP_RTK_GET_RSSI, MIP_RTK_GET_RSSI, "rtk.get_rssi", decode)
MIP_LAYOUT(mip_rtk_connected_device_type, MIP_RTK_CONNECTED_DEVICE_TYPE,
           MIP_RTK_CONNECTED_DEVICE_TYPE, "rtk.connected_device_type", decode)
MIP_LAYOUT(mip_rtk_get_activation_code, MIP_RTK_GET_ACTIVATION_CODE, MIP_RTK_GET_ACTIVATION_CODE,
           "rtk.get_activation_code", decode)
MIP_LAYOUT(mip_rtk_get_modem_firmware_version, MIP_RTK_GET_MODEM_FIRMWARE_VERSION,
           MIP_RTK_GET_MODEM_FIRMWARE_VERSION, "rtk.get_modem_firmware_version", decode)
MIP_LAYOUT(mip_rtk_service_status, MIP_RTK_SERVICE_STATUS, MIP_RTK_SERVICE_STATUS,
           "rtk.service_status", decode_inline)
MIP_LAYOUT(mip_rtk_erase_storage, MIP_RTK_ERASE_STORAGE, MIP_RTK_ERASE_STORAGE, "rtk.erase_storage",
           decode_inline)
MIP_LAYOUT(mip_rtk_led_control, MIP_RTK_LED_CONTROL, MIP_RTK_LED_CONTROL, "rtk.led_control",
           decode_inline)
MIP_LAYOUT(mip_rtk_modem_hard_reset, MIP_RTK_MODEM_HARD_RESET, MIP_RTK_MODEM_HARD_RESET,
           "rtk.modem_hard_reset", decode)
MIP_LAYOUT(mip_rtk_get_status_flags_response, MIP_RTK_GET_STATUS_FLAGS_RESPONSE,
           MIP_RTK_GET_STATUS_FLAGS_RESPONSE, "rtk.get_status_flags_response", decode_inline)
MIP_LAYOUT(mip_rtk_get_imei_response, MIP_RTK_GET_IMEI_RESPONSE, MIP_RTK_GET_IMEI_RESPONSE,
           "rtk.get_imei_response", decode_inline)
MIP_LAYOUT(mip_rtk_get_imsi_response, MIP_RTK_GET_IMSI_RESPONSE, MIP_RTK_GET_IMSI_RESPONSE,
           "rtk.get_imsi_response", decode_inline)
MIP_LAYOUT(mip_rtk_get_iccid_response, MIP_RTK_GET_ICCID_RESPONSE, MIP_RTK_GET_ICCID_RESPONSE,
           "rtk.get_iccid_response", decode_inline)
MIP_LAYOUT(mip_rtk_get_rssi_response, MIP_RTK_GET_RSSI_RESPONSE, MIP_RTK_GET_RSSI_RESPONSE,
           "rtk.get_rssi_response", decode_inline)
MIP_LAYOUT(mip_rtk_connected_device_type_response, MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE,
           MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE, "rtk.connected_device_type_response",
           decode_inline)
MIP_LAYOUT(mip_rtk_get_activation_code_response, MIP_RTK_GET_ACTIVATION_CODE_RESPONSE,
           MIP_RTK_GET_ACTIVATION_CODE_RESPONSE, "rtk.get_activation_code_response", decode_inline)
MIP_LAYOUT(mip_rtk_get_modem_firmware_version_response, MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE,
           MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE, "rtk.get_modem_firmware_version_response",
           decode_inline)
MIP_LAYOUT(mip_rtk_service_status_response, MIP_RTK_SERVICE_STATUS_RESPONSE,
           MIP_RTK_SERVICE_STATUS_RESPONSE, "rtk.service_status_response", decode_inline)

/** RTK commands */
inline constexpr std::uint8_t rtk_set = MIP_RTK_SET;

namespace rtk {

/** @addtogroup mip_rtk
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

/** mip_rtk_connected_device: rtk.connected_device */
enum class connected_device : uint8_t {
    generic = MIP_RTK_CONNECTED_DEVICE_GENERIC,
    gq7 = MIP_RTK_CONNECTED_DEVICE_GQ7,
};
MIP_NAMES_OF(value_names, connected_device, mip_names_rtk_connected_device)

/** mip_rtk_service_flags: rtk.service_flags */
enum class service_flags : uint8_t {
    throttle = MIP_RTK_SERVICE_FLAGS_THROTTLE,
    corrections_unavailable = MIP_RTK_SERVICE_FLAGS_CORRECTIONS_UNAVAILABLE,
};
MIP_NAMES_OF(flag_names, service_flags, mip_names_rtk_service_flags)

/** mip_rtk_storage_medium: rtk.storage_medium */
enum class storage_medium : uint8_t {
    external_flash = MIP_RTK_STORAGE_MEDIUM_EXTERNAL_FLASH,
    sd = MIP_RTK_STORAGE_MEDIUM_SD,
};
MIP_NAMES_OF(value_names, storage_medium, mip_names_rtk_storage_medium)

/** mip_rtk_led_action: rtk.led_action */
enum class led_action : uint8_t {
    none = MIP_RTK_LED_ACTION_NONE,
    flash = MIP_RTK_LED_ACTION_FLASH,
    pulsate = MIP_RTK_LED_ACTION_PULSATE,
};
MIP_NAMES_OF(value_names, led_action, mip_names_rtk_led_action)

struct get_status_flags_response_ : ::mip_rtk_get_status_flags_response {
    using c_type = ::mip_rtk_get_status_flags_response;
    ::mip::rtk_status_flags flags() const {
        return static_cast<::mip::rtk_status_flags>(c_type::flags);
    }
};

/** Get status flags response. See struct mip_rtk_get_status_flags_response. */
using get_status_flags_response = get_status_flags_response_;

struct get_imei_response_ : ::mip_rtk_get_imei_response {
    using c_type = ::mip_rtk_get_imei_response;
    /** May contain leading or trailing spaces. */
    std::string_view imei() const {
        return ::mip::text(c_type::imei);
    }
};

/** Get IMEI response. See struct mip_rtk_get_imei_response. */
using get_imei_response = get_imei_response_;

struct get_imsi_response_ : ::mip_rtk_get_imsi_response {
    using c_type = ::mip_rtk_get_imsi_response;
    /** May contain leading or trailing spaces. */
    std::string_view imsi() const {
        return ::mip::text(c_type::imsi);
    }
};

/** Get IMSI response. See struct mip_rtk_get_imsi_response. */
using get_imsi_response = get_imsi_response_;

struct get_iccid_response_ : ::mip_rtk_get_iccid_response {
    using c_type = ::mip_rtk_get_iccid_response;
    /** May contain leading or trailing spaces. */
    std::string_view iccid() const {
        return ::mip::text(c_type::iccid);
    }
};

/** Get ICCID response. See struct mip_rtk_get_iccid_response. */
using get_iccid_response = get_iccid_response_;

/** Get RSSI response. See struct mip_rtk_get_rssi_response. */
using get_rssi_response = ::mip_rtk_get_rssi_response;

struct connected_device_type_response_ : ::mip_rtk_connected_device_type_response {
    using c_type = ::mip_rtk_connected_device_type_response;
    ::mip::rtk::connected_device device_type() const {
        return static_cast<::mip::rtk::connected_device>(c_type::device_type);
    }
};

/** Connected device type response. See struct mip_rtk_connected_device_type_response. */
using connected_device_type_response = connected_device_type_response_;

struct get_activation_code_response_ : ::mip_rtk_get_activation_code_response {
    using c_type = ::mip_rtk_get_activation_code_response;
    /** May contain leading or trailing spaces. */
    std::string_view activation_code() const {
        return ::mip::text(c_type::activation_code);
    }
};

/** Get activation code response. See struct mip_rtk_get_activation_code_response. */
using get_activation_code_response = get_activation_code_response_;

struct get_modem_firmware_version_response_ : ::mip_rtk_get_modem_firmware_version_response {
    using c_type = ::mip_rtk_get_modem_firmware_version_response;
    /** May contain leading or trailing spaces. */
    std::string_view modem_firmware_version() const {
        return ::mip::text(c_type::modem_firmware_version);
    }
};

/** Get modem firmware version response. See struct mip_rtk_get_modem_firmware_version_response. */
using get_modem_firmware_version_response = get_modem_firmware_version_response_;

struct service_status_response_ : ::mip_rtk_service_status_response {
    using c_type = ::mip_rtk_service_status_response;
    ::mip::rtk::service_flags flags() const {
        return static_cast<::mip::rtk::service_flags>(c_type::flags);
    }
};

/** Service status response. See struct mip_rtk_service_status_response. */
using service_status_response = service_status_response_;

/** @} */

} // namespace rtk

} // namespace mip

#endif
