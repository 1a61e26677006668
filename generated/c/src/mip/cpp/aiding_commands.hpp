/**
 * @file
 * The commands of Aiding commands, in C++17: see mip/aiding_commands.h.
 */
#ifndef MIP_AIDING_COMMANDS_HPP
#define MIP_AIDING_COMMANDS_HPP

#include "mip/aiding_commands.h"
#include "mip/cpp/aiding.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_aiding_frame_config, ::mip::aiding::frame_config_response)
MIP_CHANGE_OF(mip_aiding_frame_config, ::mip::aiding::frame_config_response,
              mip_aiding_frame_config_write_from)
MIP_COMMAND_OF(mip_aiding_sensor_frame_map, ::mip::aiding::sensor_frame_map_response)
MIP_CHANGE_OF(mip_aiding_sensor_frame_map, ::mip::aiding::sensor_frame_map_response,
              mip_aiding_sensor_frame_map_write_from)
MIP_COMMAND_OF(mip_aiding_echo_control, ::mip::aiding::echo_control_response)
MIP_CHANGE_OF(mip_aiding_echo_control, ::mip::aiding::echo_control_response,
              mip_aiding_echo_control_write_from)
MIP_COMMAND_OF(mip_aiding_ecef_position, void)
MIP_COMMAND_OF(mip_aiding_llh_position, void)
MIP_COMMAND_OF(mip_aiding_height_above_ellipsoid, void)
MIP_COMMAND_OF(mip_aiding_pressure_old, void)
MIP_COMMAND_OF(mip_aiding_ecef_velocity, void)
MIP_COMMAND_OF(mip_aiding_ned_velocity, void)
MIP_COMMAND_OF(mip_aiding_body_frame_velocity, void)
MIP_COMMAND_OF(mip_aiding_true_heading, void)
MIP_COMMAND_OF(mip_aiding_magnetic_field, void)
MIP_COMMAND_OF(mip_aiding_pressure, void)

namespace aiding {

/** @addtogroup mip_aiding
 * @{ */

/** Frame configuration: write. See mip_call_aiding_frame_config_write. */
struct write_frame_config {
    uint8_t frame_id;
    ::mip::aiding::frame_format format;
    bool tracking_enabled;
    float translation[3];
    ::mip_aiding_frame_config_rotation rotation;

    using command = ::mip_aiding_frame_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_frame_config_write(
            device_, frame_id, static_cast<enum mip_aiding_frame_format>(format), tracking_enabled,
            translation, &rotation);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_frame_config_write(to_, frame_id,
                                               static_cast<enum mip_aiding_frame_format>(format),
                                               tracking_enabled, translation, &rotation);
    }
};

/** Frame configuration: read. See mip_call_aiding_frame_config_read. */
struct read_frame_config {
    uint8_t frame_id;
    ::mip::aiding::frame_format format;

    using command = ::mip_aiding_frame_config;
    using response = ::mip::aiding::frame_config_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_aiding_frame_config_read(
            device_, frame_id, static_cast<enum mip_aiding_frame_format>(format), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_frame_config_read(to_, frame_id,
                                              static_cast<enum mip_aiding_frame_format>(format));
    }
};

/** Frame configuration: save. See mip_call_aiding_frame_config_save. */
struct save_frame_config {
    uint8_t frame_id;

    using command = ::mip_aiding_frame_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_frame_config_save(device_, frame_id);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_frame_config_save(to_, frame_id);
    }
};

/** Frame configuration: load. See mip_call_aiding_frame_config_load. */
struct load_frame_config {
    uint8_t frame_id;

    using command = ::mip_aiding_frame_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_frame_config_load(device_, frame_id);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_frame_config_load(to_, frame_id);
    }
};

/** Frame configuration: default. See mip_call_aiding_frame_config_default. */
struct default_frame_config {
    uint8_t frame_id;

    using command = ::mip_aiding_frame_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_frame_config_default(device_, frame_id);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_frame_config_default(to_, frame_id);
    }
};

/** Sensor frame map: write. See mip_call_aiding_sensor_frame_map_write. */
struct write_sensor_frame_map {
    uint8_t sensor_id;
    uint8_t frame_id;

    using command = ::mip_aiding_sensor_frame_map;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_sensor_frame_map_write(device_, sensor_id, frame_id);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_sensor_frame_map_write(to_, sensor_id, frame_id);
    }
};

/** Sensor frame map: read. See mip_call_aiding_sensor_frame_map_read. */
struct read_sensor_frame_map
    : fixed_command<::mip_aiding_sensor_frame_map, ::mip::aiding::sensor_frame_map_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Sensor frame map: save. See mip_call_aiding_sensor_frame_map_save. */
struct save_sensor_frame_map
    : fixed_command<::mip_aiding_sensor_frame_map, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Sensor frame map: load. See mip_call_aiding_sensor_frame_map_load. */
struct load_sensor_frame_map
    : fixed_command<::mip_aiding_sensor_frame_map, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Sensor frame map: default. See mip_call_aiding_sensor_frame_map_default. */
struct default_sensor_frame_map
    : fixed_command<::mip_aiding_sensor_frame_map, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Echo control: write. See mip_call_aiding_echo_control_write. */
struct write_echo_control {
    ::mip::aiding::echo_mode mode;

    using command = ::mip_aiding_echo_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_echo_control_write(device_,
                                                    static_cast<enum mip_aiding_echo_mode>(mode));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_echo_control_write(to_, static_cast<enum mip_aiding_echo_mode>(mode));
    }
};

/** Echo control: read. See mip_call_aiding_echo_control_read. */
struct read_echo_control
    : fixed_command<::mip_aiding_echo_control, ::mip::aiding::echo_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Echo control: save. See mip_call_aiding_echo_control_save. */
struct save_echo_control
    : fixed_command<::mip_aiding_echo_control, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Echo control: load. See mip_call_aiding_echo_control_load. */
struct load_echo_control
    : fixed_command<::mip_aiding_echo_control, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Echo control: default. See mip_call_aiding_echo_control_default. */
struct default_echo_control
    : fixed_command<::mip_aiding_echo_control, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** ECEF position. See mip_call_aiding_ecef_position. */
struct ecef_position {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    double position[3];
    float uncertainty[3];
    ::mip::aiding::axis_flags valid_flags;

    using command = ::mip_aiding_ecef_position;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_ecef_position(device_, &time, frame_id, position, uncertainty,
                                               ::mip::number(valid_flags));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_ecef_position_make(to_, &time, frame_id, position, uncertainty,
                                               ::mip::number(valid_flags));
    }
};

/** LLH position. See mip_call_aiding_llh_position. */
struct llh_position {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    double latitude;
    double longitude;
    double height;
    float uncertainty[3];
    ::mip::aiding::llh_axis_flags valid_flags;

    using command = ::mip_aiding_llh_position;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_llh_position(device_, &time, frame_id, latitude, longitude, height,
                                              uncertainty, ::mip::number(valid_flags));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_llh_position_make(to_, &time, frame_id, latitude, longitude, height,
                                              uncertainty, ::mip::number(valid_flags));
    }
};

/** Height above ellipsoid. See mip_call_aiding_height_above_ellipsoid. */
struct height_above_ellipsoid {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float height;
    float uncertainty;
    uint16_t valid_flags;

    using command = ::mip_aiding_height_above_ellipsoid;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_height_above_ellipsoid(device_, &time, frame_id, height,
                                                        uncertainty, valid_flags);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_height_above_ellipsoid_make(to_, &time, frame_id, height, uncertainty,
                                                        valid_flags);
    }
};

/** Pressure (old). See mip_call_aiding_pressure_old. */
struct pressure_old {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float pressure;
    float uncertainty;
    uint16_t valid_flags;

    using command = ::mip_aiding_pressure_old;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_pressure_old(device_, &time, frame_id, pressure, uncertainty,
                                              valid_flags);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_pressure_old_make(to_, &time, frame_id, pressure, uncertainty,
                                              valid_flags);
    }
};

/** ECEF velocity. See mip_call_aiding_ecef_velocity. */
struct ecef_velocity {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float velocity[3];
    float uncertainty[3];
    ::mip::aiding::axis_flags valid_flags;

    using command = ::mip_aiding_ecef_velocity;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_ecef_velocity(device_, &time, frame_id, velocity, uncertainty,
                                               ::mip::number(valid_flags));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_ecef_velocity_make(to_, &time, frame_id, velocity, uncertainty,
                                               ::mip::number(valid_flags));
    }
};

/** NED velocity. See mip_call_aiding_ned_velocity. */
struct ned_velocity {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float velocity[3];
    float uncertainty[3];
    ::mip::aiding::axis_flags valid_flags;

    using command = ::mip_aiding_ned_velocity;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_ned_velocity(device_, &time, frame_id, velocity, uncertainty,
                                              ::mip::number(valid_flags));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_ned_velocity_make(to_, &time, frame_id, velocity, uncertainty,
                                              ::mip::number(valid_flags));
    }
};

/** Body frame velocity. See mip_call_aiding_body_frame_velocity. */
struct body_frame_velocity {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float velocity[3];
    float uncertainty[3];
    ::mip::aiding::axis_flags valid_flags;

    using command = ::mip_aiding_body_frame_velocity;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_body_frame_velocity(device_, &time, frame_id, velocity,
                                                     uncertainty, ::mip::number(valid_flags));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_body_frame_velocity_make(to_, &time, frame_id, velocity, uncertainty,
                                                     ::mip::number(valid_flags));
    }
};

/** True heading. See mip_call_aiding_true_heading. */
struct true_heading {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float heading;
    float uncertainty;
    uint16_t valid_flags;

    using command = ::mip_aiding_true_heading;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_true_heading(device_, &time, frame_id, heading, uncertainty,
                                              valid_flags);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_true_heading_make(to_, &time, frame_id, heading, uncertainty,
                                              valid_flags);
    }
};

/** Magnetic field. See mip_call_aiding_magnetic_field. */
struct magnetic_field {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float magnetic_field[3];
    float uncertainty[3];
    ::mip::aiding::axis_flags valid_flags;

    using command = ::mip_aiding_magnetic_field;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_magnetic_field(device_, &time, frame_id, magnetic_field,
                                                uncertainty, ::mip::number(valid_flags));
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_magnetic_field_make(to_, &time, frame_id, magnetic_field, uncertainty,
                                                ::mip::number(valid_flags));
    }
};

/** Pressure. See mip_call_aiding_pressure. */
struct pressure {
    ::mip_aiding_measurement_time time;
    uint8_t frame_id;
    float pressure;
    float uncertainty;
    uint16_t valid_flags;

    using command = ::mip_aiding_pressure;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_aiding_pressure(device_, &time, frame_id, pressure, uncertainty,
                                          valid_flags);
    }
    const command *fill(command *to_) const {
        return ::mip_aiding_pressure_make(to_, &time, frame_id, pressure, uncertainty, valid_flags);
    }
};

/** @} */

} // namespace aiding

} // namespace mip

#endif
