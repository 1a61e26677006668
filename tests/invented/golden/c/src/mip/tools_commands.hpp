/**
 * @file
 * The commands of Tools, in C++17: see mip/tools_commands.h.
 */
#ifndef MIP_TOOLS_COMMANDS_HPP
#define MIP_TOOLS_COMMANDS_HPP

#include "mip/tools_commands.h"
#include "mip/tools.hpp"
#include "mip/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_tools_ping, void)
MIP_COMMAND_OF(mip_tools_settings, ::mip::tools::settings_response)
MIP_COMMAND_OF(mip_tools_set_time, void)
MIP_COMMAND_OF(mip_tools_status, void)
MIP_COMMAND_OF(mip_tools_bias, ::mip::tools::bias_vector)
MIP_COMMAND_OF(mip_tools_capture_bias, ::mip::tools::bias_vector)
MIP_COMMAND_OF(mip_tools_formats, void)
MIP_COMMAND_OF(mip_tools_choice, ::mip::tools::choice_response)
MIP_COMMAND_OF(mip_tools_list, ::mip::tools::list_response)
MIP_COMMAND_OF(mip_tools_stock, ::mip::tools::inventory_response)
MIP_COMMAND_OF(mip_tools_pin, ::mip::tools::pin_response)
MIP_COMMAND_OF(mip_tools_hello, ::mip::tools::hello_response)
MIP_COMMAND_OF(mip_tools_readings, ::mip::tools::readings_response)
MIP_COMMAND_OF(mip_tools_poll, void)

namespace tools {

/** @addtogroup mip_tools
 * @{ */

/** Ping. See mip_call_tools_ping. */
struct ping : fixed_command<::mip_tools_ping, void> {};

/** Settings: write. See mip_call_tools_settings_write. */
struct write_settings {
    uint8_t port;
    ::mip::mode mode;
    uint32_t baud;

    using command = ::mip_tools_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_settings_write(device_, port, static_cast<enum mip_mode>(mode),
                                               baud);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_settings_write(to_, port, static_cast<enum mip_mode>(mode), baud);
    }
};

/** Settings: read. See mip_call_tools_settings_read. */
struct read_settings {
    uint8_t port;
    ::mip::mode mode;

    using command = ::mip_tools_settings;
    using response = ::mip::tools::settings_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_tools_settings_read(device_, port, static_cast<enum mip_mode>(mode), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_settings_read(to_, port, static_cast<enum mip_mode>(mode));
    }
};

/** Settings: save. See mip_call_tools_settings_save. */
struct save_settings {
    uint8_t port;

    using command = ::mip_tools_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_settings_save(device_, port);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_settings_save(to_, port);
    }
};

/** Settings: load. See mip_call_tools_settings_load. */
struct load_settings {
    uint8_t port;

    using command = ::mip_tools_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_settings_load(device_, port);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_settings_load(to_, port);
    }
};

/** Settings: default. See mip_call_tools_settings_default. */
struct default_settings {
    uint8_t port;

    using command = ::mip_tools_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_settings_default(device_, port);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_settings_default(to_, port);
    }
};

/** Settings: apply. See mip_call_tools_settings_apply. */
struct apply_settings {
    uint8_t port;
    ::mip::mode mode;
    uint32_t baud;

    using command = ::mip_tools_settings;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_settings_apply(device_, port, static_cast<enum mip_mode>(mode),
                                               baud);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_settings_apply(to_, port, static_cast<enum mip_mode>(mode), baud);
    }
};

/** Set time: write. See mip_call_tools_set_time_write. */
struct write_set_time {
    ::mip::mode part;
    uint32_t value;

    using command = ::mip_tools_set_time;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_set_time_write(device_, static_cast<enum mip_mode>(part), value);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_set_time_write(to_, static_cast<enum mip_mode>(part), value);
    }
};

/** Set time: read. See mip_call_tools_set_time_read. */
struct read_set_time {
    ::mip::mode part;

    using command = ::mip_tools_set_time;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_set_time_read(device_, static_cast<enum mip_mode>(part));
    }
    const command *fill(command *to_) const {
        return ::mip_tools_set_time_read(to_, static_cast<enum mip_mode>(part));
    }
};

/** Set time: read. See mip_call_for_tools_set_time_fast_response_read. */
struct read_for_set_time_fast_response {

    using command = ::mip_tools_set_time;
    using response = ::mip::tools::set_time_fast_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_set_time_fast_response_read(device_, to_);
    }
};

/** Set time: read. See mip_call_for_tools_set_time_slow_response_read. */
struct read_for_set_time_slow_response {

    using command = ::mip_tools_set_time;
    using response = ::mip::tools::set_time_slow_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_set_time_slow_response_read(device_, to_);
    }
};

/** Set time: apply. See mip_call_tools_set_time_apply. */
struct apply_set_time {
    ::mip::mode part;
    uint32_t value;

    using command = ::mip_tools_set_time;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_set_time_apply(device_, static_cast<enum mip_mode>(part), value);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_set_time_apply(to_, static_cast<enum mip_mode>(part), value);
    }
};

/** Status. See mip_call_tools_status. */
struct status {
    uint8_t selector;

    using command = ::mip_tools_status;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_status(device_, selector);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_status_make(to_, selector);
    }
};

/** Status. See mip_call_for_tools_status_paged. */
struct for_status_paged {

    using command = ::mip_tools_status;
    using response = ::mip::tools::status_paged;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_status_paged(device_, to_);
    }
};

/** Status. See mip_call_for_tools_status_short. */
struct for_status_short {

    using command = ::mip_tools_status;
    using response = ::mip::tools::status_short;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_status_short(device_, to_);
    }
};

/** Status. See mip_call_for_tools_status_long. */
struct for_status_long {

    using command = ::mip_tools_status;
    using response = ::mip::tools::status_long;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_status_long(device_, to_);
    }
};

/** Status. See mip_call_for_tools_status_old. */
struct for_status_old {

    using command = ::mip_tools_status;
    using response = ::mip::tools::status_old;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_status_old(device_, to_);
    }
};

/** Status. See mip_call_for_tools_full. */
struct for_status_full {

    using command = ::mip_tools_status;
    using response = ::mip::tools::status_full;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_for_tools_full(device_, to_);
    }
};

/** Bias: write. See mip_call_tools_bias_write. */
struct write_bias {
    float bias[3];

    using command = ::mip_tools_bias;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_bias_write(device_, bias);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_bias_write(to_, bias);
    }
};

/** Bias: read. See mip_call_tools_bias_read. */
struct read_bias
    : fixed_command<::mip_tools_bias, ::mip::tools::bias_vector, MIP_FUNCTION_SELECTOR_READ> {};

/** Bias: save. See mip_call_tools_bias_save. */
struct save_bias : fixed_command<::mip_tools_bias, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Bias: load. See mip_call_tools_bias_load. */
struct load_bias : fixed_command<::mip_tools_bias, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Bias: default. See mip_call_tools_bias_default. */
struct default_bias : fixed_command<::mip_tools_bias, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Capture bias. See mip_call_tools_capture_bias. */
struct capture_bias {
    uint16_t time;

    using command = ::mip_tools_capture_bias;
    using response = ::mip::tools::bias_vector;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_tools_capture_bias(device_, time, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_capture_bias_make(to_, time);
    }
};

/** Formats. See mip_call_tools_formats. */
struct formats {
    bool suppress_ack;
    uint8_t checkpoint;
    span<const ::mip_segment> segments;

    using command = ::mip_tools_formats;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_formats(device_, suppress_ack, detail::count(segments), checkpoint,
                                        segments.data());
    }
    const command *fill(command *to_) const {
        return ::mip_tools_formats_make(to_, suppress_ack, detail::count(segments), checkpoint,
                                        segments.data());
    }
};

/** Choice: write. See mip_call_tools_choice_write. */
struct write_choice {
    uint8_t instance;
    ::mip::tools::shape shape;
    ::mip_tools_choice_parameters parameters;

    using command = ::mip_tools_choice;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_choice_write(device_, instance,
                                             static_cast<enum mip_tools_shape>(shape), &parameters);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_choice_write(to_, instance, static_cast<enum mip_tools_shape>(shape),
                                        &parameters);
    }
};

/** Choice: read. See mip_call_tools_choice_read. */
struct read_choice {
    uint8_t instance;

    using command = ::mip_tools_choice;
    using response = ::mip::tools::choice_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_tools_choice_read(device_, instance, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_choice_read(to_, instance);
    }
};

/** List: write. See mip_call_tools_list_write. */
struct write_list {
    span<const uint16_t> items;

    using command = ::mip_tools_list;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_list_write(device_, detail::count(items), items.data());
    }
    const command *fill(command *to_) const {
        return ::mip_tools_list_write(to_, detail::count(items), items.data());
    }
};

/** List: read. See mip_call_tools_list_read. */
struct read_list
    : fixed_command<::mip_tools_list, ::mip::tools::list_response, MIP_FUNCTION_SELECTOR_READ> {};

/** List: save. See mip_call_tools_list_save. */
struct save_list : fixed_command<::mip_tools_list, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Inventory. See mip_call_tools_stock. */
struct inventory : fixed_command<::mip_tools_stock, ::mip::tools::inventory_response> {};

/** Pin: write. See mip_call_tools_pin_write. */
struct write_pin {
    ::mip::tools::drive drive;
    uint8_t use;

    using command = ::mip_tools_pin;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_pin_write(device_, static_cast<enum mip_tools_drive>(drive), use);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_pin_write(to_, static_cast<enum mip_tools_drive>(drive), use);
    }
};

/** Pin: read. See mip_call_tools_pin_read. */
struct read_pin {
    ::mip::tools::drive drive;

    using command = ::mip_tools_pin;
    using response = ::mip::tools::pin_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_tools_pin_read(device_, static_cast<enum mip_tools_drive>(drive), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_pin_read(to_, static_cast<enum mip_tools_drive>(drive));
    }
};

/** Hello. */
using hello = ::mip_tools_hello;

/** Readings. See mip_call_tools_readings. */
struct readings {
    ::mip::tools::drive drive;

    using command = ::mip_tools_readings;
    using response = ::mip::tools::readings_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_tools_readings(device_, static_cast<enum mip_tools_drive>(drive), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_tools_readings_make(to_, static_cast<enum mip_tools_drive>(drive));
    }
};

/** Poll. See mip_call_tools_poll. */
struct poll {
    uint8_t descriptor_set;
    uint8_t first;
    span<const uint8_t> descriptors;

    using command = ::mip_tools_poll;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_tools_poll(device_, descriptor_set, first, detail::count(descriptors),
                                     descriptors.data());
    }
    const command *fill(command *to_) const {
        return ::mip_tools_poll_make(to_, descriptor_set, first, detail::count(descriptors),
                                     descriptors.data());
    }
};

/** @} */

} // namespace tools

} // namespace mip

#endif
