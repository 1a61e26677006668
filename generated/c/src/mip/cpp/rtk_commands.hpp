/**
 * @file
 * The commands of RTK commands, in C++17: see mip/rtk_commands.h.
 */
#ifndef MIP_RTK_COMMANDS_HPP
#define MIP_RTK_COMMANDS_HPP

#include "mip/rtk_commands.h"
#include "mip/cpp/rtk.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_rtk_get_status_flags, ::mip::rtk::get_status_flags_response)
MIP_COMMAND_OF(mip_rtk_get_imei, ::mip::rtk::get_imei_response)
MIP_COMMAND_OF(mip_rtk_get_imsi, ::mip::rtk::get_imsi_response)
MIP_COMMAND_OF(mip_rtk_get_iccid, ::mip::rtk::get_iccid_response)
MIP_COMMAND_OF(mip_rtk_get_rssi, ::mip::rtk::get_rssi_response)
MIP_COMMAND_OF(mip_rtk_connected_device_type, ::mip::rtk::connected_device_type_response)
MIP_CHANGE_OF(mip_rtk_connected_device_type, ::mip::rtk::connected_device_type_response,
              mip_rtk_connected_device_type_write_from)
MIP_COMMAND_OF(mip_rtk_get_activation_code, ::mip::rtk::get_activation_code_response)
MIP_COMMAND_OF(mip_rtk_get_modem_firmware_version, ::mip::rtk::get_modem_firmware_version_response)
MIP_COMMAND_OF(mip_rtk_service_status, ::mip::rtk::service_status_response)
MIP_COMMAND_OF(mip_rtk_erase_storage, void)
MIP_COMMAND_OF(mip_rtk_led_control, void)
MIP_COMMAND_OF(mip_rtk_modem_hard_reset, void)

namespace rtk {

/** @addtogroup mip_rtk
 * @{ */

/** Get status flags. See mip_call_rtk_get_status_flags. */
struct get_status_flags
    : fixed_command<::mip_rtk_get_status_flags, ::mip::rtk::get_status_flags_response> {};

/** Get IMEI. See mip_call_rtk_get_imei. */
struct get_imei : fixed_command<::mip_rtk_get_imei, ::mip::rtk::get_imei_response> {};

/** Get IMSI. See mip_call_rtk_get_imsi. */
struct get_imsi : fixed_command<::mip_rtk_get_imsi, ::mip::rtk::get_imsi_response> {};

/** Get ICCID. See mip_call_rtk_get_iccid. */
struct get_iccid : fixed_command<::mip_rtk_get_iccid, ::mip::rtk::get_iccid_response> {};

/** Get RSSI. See mip_call_rtk_get_rssi. */
struct get_rssi : fixed_command<::mip_rtk_get_rssi, ::mip::rtk::get_rssi_response> {};

/** Connected device type: write. See mip_call_rtk_connected_device_type_write. */
struct write_connected_device_type {
    ::mip::rtk::connected_device device_type;

    using command = ::mip_rtk_connected_device_type;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_rtk_connected_device_type_write(
            device_, static_cast<enum mip_rtk_connected_device>(device_type));
    }
    const command *fill(command *to_) const {
        return ::mip_rtk_connected_device_type_write(
            to_, static_cast<enum mip_rtk_connected_device>(device_type));
    }
};

/** Connected device type: read. See mip_call_rtk_connected_device_type_read. */
struct read_connected_device_type
    : fixed_command<::mip_rtk_connected_device_type, ::mip::rtk::connected_device_type_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Connected device type: save. See mip_call_rtk_connected_device_type_save. */
struct save_connected_device_type
    : fixed_command<::mip_rtk_connected_device_type, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Connected device type: load. See mip_call_rtk_connected_device_type_load. */
struct load_connected_device_type
    : fixed_command<::mip_rtk_connected_device_type, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Connected device type: default. See mip_call_rtk_connected_device_type_default. */
struct default_connected_device_type
    : fixed_command<::mip_rtk_connected_device_type, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Get activation code. See mip_call_rtk_get_activation_code. */
struct get_activation_code
    : fixed_command<::mip_rtk_get_activation_code, ::mip::rtk::get_activation_code_response> {};

/** Get modem firmware version. See mip_call_rtk_get_modem_firmware_version. */
struct get_modem_firmware_version : fixed_command<::mip_rtk_get_modem_firmware_version,
                                                  ::mip::rtk::get_modem_firmware_version_response> {
};

/** Service status. */
using service_status = ::mip_rtk_service_status;

/** Erase storage. See mip_call_rtk_erase_storage. */
struct erase_storage {
    ::mip::rtk::storage_medium media;

    using command = ::mip_rtk_erase_storage;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_rtk_erase_storage(device_,
                                            static_cast<enum mip_rtk_storage_medium>(media));
    }
    const command *fill(command *to_) const {
        return ::mip_rtk_erase_storage_make(to_, static_cast<enum mip_rtk_storage_medium>(media));
    }
};

/** LED control. See mip_call_rtk_led_control. */
struct led_control {
    uint8_t primary_color[3];
    uint8_t alternate_color[3];
    ::mip::rtk::led_action action;
    uint32_t period;

    using command = ::mip_rtk_led_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_rtk_led_control(device_, primary_color, alternate_color,
                                          static_cast<enum mip_rtk_led_action>(action), period);
    }
    const command *fill(command *to_) const {
        return ::mip_rtk_led_control_make(to_, primary_color, alternate_color,
                                          static_cast<enum mip_rtk_led_action>(action), period);
    }
};

/** Modem hard reset. See mip_call_rtk_modem_hard_reset. */
struct modem_hard_reset : fixed_command<::mip_rtk_modem_hard_reset, void> {};

/** @} */

} // namespace rtk

} // namespace mip

#endif
