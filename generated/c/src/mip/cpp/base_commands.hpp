/**
 * @file
 * The commands of Base, in C++17: see mip/base_commands.h.
 */
#ifndef MIP_BASE_COMMANDS_HPP
#define MIP_BASE_COMMANDS_HPP

#include "mip/base_commands.h"
#include "mip/cpp/base.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_base_ping, void)
MIP_COMMAND_OF(mip_base_set_idle, void)
MIP_COMMAND_OF(mip_base_get_device_info, ::mip::base::get_device_info_response)
MIP_COMMAND_OF(mip_base_get_device_descriptors, ::mip::base::get_device_descriptors_response)
MIP_COMMAND_OF(mip_base_built_in_test, ::mip::base::built_in_test_response)
MIP_COMMAND_OF(mip_base_resume, void)
MIP_COMMAND_OF(mip_base_get_extended_descriptors, ::mip::base::get_extended_descriptors_response)
MIP_COMMAND_OF(mip_base_continuous_built_in_test, ::mip::base::continuous_built_in_test_response)
MIP_COMMAND_OF(mip_base_comm_speed, ::mip::base::comm_speed_response)
MIP_CHANGE_OF(mip_base_comm_speed, ::mip::base::comm_speed_response, mip_base_comm_speed_write_from)
MIP_COMMAND_OF(mip_base_gps_time_update, void)
MIP_COMMAND_OF(mip_base_soft_reset, void)

namespace base {

/** @addtogroup mip_base
 * @{ */

/** Ping. See mip_call_base_ping. */
struct ping : fixed_command<::mip_base_ping, void> {};

/** Set to idle. See mip_call_base_set_idle. */
struct set_idle : fixed_command<::mip_base_set_idle, void> {};

/** Get device information. See mip_call_base_get_device_info. */
struct get_device_info
    : fixed_command<::mip_base_get_device_info, ::mip::base::get_device_info_response> {};

/** Get device descriptors. See mip_call_base_get_device_descriptors. */
struct get_device_descriptors : fixed_command<::mip_base_get_device_descriptors,
                                              ::mip::base::get_device_descriptors_response> {};

/** Built-in test. See mip_call_base_built_in_test. */
struct built_in_test
    : fixed_command<::mip_base_built_in_test, ::mip::base::built_in_test_response> {};

/** Resume. See mip_call_base_resume. */
struct resume : fixed_command<::mip_base_resume, void> {};

/** Get device descriptors (extended). See mip_call_base_get_extended_descriptors. */
struct get_extended_descriptors : fixed_command<::mip_base_get_extended_descriptors,
                                                ::mip::base::get_extended_descriptors_response> {};

/** Continuous built-in test. See mip_call_base_continuous_built_in_test. */
struct continuous_built_in_test : fixed_command<::mip_base_continuous_built_in_test,
                                                ::mip::base::continuous_built_in_test_response> {};

/** Comm port speed: write. See mip_call_base_comm_speed_write. */
struct write_comm_speed {
    uint8_t port;
    uint32_t baud;

    using command = ::mip_base_comm_speed;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_comm_speed_write(device_, port, baud);
    }
    const command *fill(command *to_) const {
        return ::mip_base_comm_speed_write(to_, port, baud);
    }
};

/** Comm port speed: read. See mip_call_base_comm_speed_read. */
struct read_comm_speed {
    uint8_t port;

    using command = ::mip_base_comm_speed;
    using response = ::mip::base::comm_speed_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_base_comm_speed_read(device_, port, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_base_comm_speed_read(to_, port);
    }
};

/** Comm port speed: save. See mip_call_base_comm_speed_save. */
struct save_comm_speed {
    uint8_t port;

    using command = ::mip_base_comm_speed;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_comm_speed_save(device_, port);
    }
    const command *fill(command *to_) const {
        return ::mip_base_comm_speed_save(to_, port);
    }
};

/** Comm port speed: load. See mip_call_base_comm_speed_load. */
struct load_comm_speed {
    uint8_t port;

    using command = ::mip_base_comm_speed;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_comm_speed_load(device_, port);
    }
    const command *fill(command *to_) const {
        return ::mip_base_comm_speed_load(to_, port);
    }
};

/** Comm port speed: default. See mip_call_base_comm_speed_default. */
struct default_comm_speed {
    uint8_t port;

    using command = ::mip_base_comm_speed;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_comm_speed_default(device_, port);
    }
    const command *fill(command *to_) const {
        return ::mip_base_comm_speed_default(to_, port);
    }
};

/** GPS time update: write. See mip_call_base_gps_time_update_write. */
struct write_gps_time_update {
    ::mip::base::gps_time_field field_id;
    uint32_t value;

    using command = ::mip_base_gps_time_update;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_gps_time_update_write(
            device_, static_cast<enum mip_base_gps_time_field>(field_id), value);
    }
    const command *fill(command *to_) const {
        return ::mip_base_gps_time_update_write(
            to_, static_cast<enum mip_base_gps_time_field>(field_id), value);
    }
};

/** GPS time update: read. See mip_call_base_gps_time_update_read. */
struct read_gps_time_update {
    ::mip::base::gps_time_field field_id;

    using command = ::mip_base_gps_time_update;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_gps_time_update_read(
            device_, static_cast<enum mip_base_gps_time_field>(field_id));
    }
    const command *fill(command *to_) const {
        return ::mip_base_gps_time_update_read(to_,
                                               static_cast<enum mip_base_gps_time_field>(field_id));
    }
};

/** GPS time update: read. See mip_call_for_base_gps_time_update_week_number_response_read. */
struct read_for_gps_time_update_week_number_response {

    using command = ::mip_base_gps_time_update;
    using response = ::mip::base::gps_time_update_week_number_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_base_gps_time_update_week_number_response_read(device_, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_base_gps_time_update_read(to_, MIP_BASE_GPS_TIME_FIELD_WEEK_NUMBER);
    }
};

/** GPS time update: read. See mip_call_for_base_gps_time_update_tow_response_read. */
struct read_for_gps_time_update_tow_response {

    using command = ::mip_base_gps_time_update;
    using response = ::mip::base::gps_time_update_tow_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_base_gps_time_update_tow_response_read(device_, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_base_gps_time_update_read(to_, MIP_BASE_GPS_TIME_FIELD_TOW);
    }
};

/** GPS time update: apply. See mip_call_base_gps_time_update_apply. */
struct apply_gps_time_update {
    ::mip::base::gps_time_field field_id;
    uint32_t value;

    using command = ::mip_base_gps_time_update;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_base_gps_time_update_apply(
            device_, static_cast<enum mip_base_gps_time_field>(field_id), value);
    }
    const command *fill(command *to_) const {
        return ::mip_base_gps_time_update_apply(
            to_, static_cast<enum mip_base_gps_time_field>(field_id), value);
    }
};

/** Reset device. See mip_call_base_soft_reset. */
struct soft_reset : fixed_command<::mip_base_soft_reset, void> {};

/** @} */

} // namespace base

} // namespace mip

#endif
