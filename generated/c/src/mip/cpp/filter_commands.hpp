/**
 * @file
 * The commands of Filter commands, in C++17: see mip/filter_commands.h.
 */
#ifndef MIP_FILTER_COMMANDS_HPP
#define MIP_FILTER_COMMANDS_HPP

#include "mip/filter_commands.h"
#include "mip/cpp/filter.hpp"
#include "mip/cpp/device.hpp"

namespace mip {

MIP_COMMAND_OF(mip_filter_reset, void)
MIP_COMMAND_OF(mip_filter_set_initial_attitude, void)
MIP_COMMAND_OF(mip_filter_set_initial_heading, void)
MIP_COMMAND_OF(mip_filter_set_initial_attitude_from_imu, void)
MIP_COMMAND_OF(mip_filter_run, void)
MIP_COMMAND_OF(mip_filter_vehicle_dynamics_mode, ::mip::filter::vehicle_dynamics_mode_response)
MIP_CHANGE_OF(mip_filter_vehicle_dynamics_mode, ::mip::filter::vehicle_dynamics_mode_response,
              mip_filter_vehicle_dynamics_mode_write_from)
MIP_COMMAND_OF(mip_filter_sensor_to_vehicle_rotation_euler,
               ::mip::filter::sensor_to_vehicle_rotation_euler_response)
MIP_CHANGE_OF(mip_filter_sensor_to_vehicle_rotation_euler,
              ::mip::filter::sensor_to_vehicle_rotation_euler_response,
              mip_filter_sensor_to_vehicle_rotation_euler_write_from)
MIP_COMMAND_OF(mip_filter_sensor_to_vehicle_offset,
               ::mip::filter::sensor_to_vehicle_offset_response)
MIP_CHANGE_OF(mip_filter_sensor_to_vehicle_offset, ::mip::filter::sensor_to_vehicle_offset_response,
              mip_filter_sensor_to_vehicle_offset_write_from)
MIP_COMMAND_OF(mip_filter_antenna_offset, ::mip::filter::antenna_offset_response)
MIP_CHANGE_OF(mip_filter_antenna_offset, ::mip::filter::antenna_offset_response,
              mip_filter_antenna_offset_write_from)
MIP_COMMAND_OF(mip_filter_estimation_control, ::mip::filter::estimation_control_response)
MIP_CHANGE_OF(mip_filter_estimation_control, ::mip::filter::estimation_control_response,
              mip_filter_estimation_control_write_from)
MIP_COMMAND_OF(mip_filter_gnss_source, ::mip::filter::gnss_source_response)
MIP_CHANGE_OF(mip_filter_gnss_source, ::mip::filter::gnss_source_response,
              mip_filter_gnss_source_write_from)
MIP_COMMAND_OF(mip_filter_external_gnss_update, void)
MIP_COMMAND_OF(mip_filter_external_heading_update, void)
MIP_COMMAND_OF(mip_filter_heading_source, ::mip::filter::heading_source_response)
MIP_CHANGE_OF(mip_filter_heading_source, ::mip::filter::heading_source_response,
              mip_filter_heading_source_write_from)
MIP_COMMAND_OF(mip_filter_auto_initialization_control,
               ::mip::filter::auto_initialization_control_response)
MIP_CHANGE_OF(mip_filter_auto_initialization_control,
              ::mip::filter::auto_initialization_control_response,
              mip_filter_auto_initialization_control_write_from)
MIP_COMMAND_OF(mip_filter_accel_noise, ::mip::filter::accel_noise_response)
MIP_CHANGE_OF(mip_filter_accel_noise, ::mip::filter::accel_noise_response,
              mip_filter_accel_noise_write_from)
MIP_COMMAND_OF(mip_filter_gyro_noise, ::mip::filter::gyro_noise_response)
MIP_CHANGE_OF(mip_filter_gyro_noise, ::mip::filter::gyro_noise_response,
              mip_filter_gyro_noise_write_from)
MIP_COMMAND_OF(mip_filter_accel_bias_model, ::mip::filter::accel_bias_model_response)
MIP_CHANGE_OF(mip_filter_accel_bias_model, ::mip::filter::accel_bias_model_response,
              mip_filter_accel_bias_model_write_from)
MIP_COMMAND_OF(mip_filter_gyro_bias_model, ::mip::filter::gyro_bias_model_response)
MIP_CHANGE_OF(mip_filter_gyro_bias_model, ::mip::filter::gyro_bias_model_response,
              mip_filter_gyro_bias_model_write_from)
MIP_COMMAND_OF(mip_filter_auto_zupt, ::mip::filter::auto_zupt_response)
MIP_CHANGE_OF(mip_filter_auto_zupt, ::mip::filter::auto_zupt_response,
              mip_filter_auto_zupt_write_from)
MIP_COMMAND_OF(mip_filter_external_heading_update_with_time, void)
MIP_COMMAND_OF(mip_filter_auto_angular_zupt, ::mip::filter::auto_angular_zupt_response)
MIP_CHANGE_OF(mip_filter_auto_angular_zupt, ::mip::filter::auto_angular_zupt_response,
              mip_filter_auto_angular_zupt_write_from)
MIP_COMMAND_OF(mip_filter_tare_orientation, ::mip::filter::tare_orientation_response)
MIP_CHANGE_OF(mip_filter_tare_orientation, ::mip::filter::tare_orientation_response,
              mip_filter_tare_orientation_write_from)
MIP_COMMAND_OF(mip_filter_commanded_zupt, void)
MIP_COMMAND_OF(mip_filter_commanded_angular_zupt, void)
MIP_COMMAND_OF(mip_filter_reference_position, ::mip::filter::reference_position_response)
MIP_CHANGE_OF(mip_filter_reference_position, ::mip::filter::reference_position_response,
              mip_filter_reference_position_write_from)
MIP_COMMAND_OF(mip_filter_mag_capture_auto_calibration, void)
MIP_COMMAND_OF(mip_filter_gravity_noise, ::mip::filter::gravity_noise_response)
MIP_CHANGE_OF(mip_filter_gravity_noise, ::mip::filter::gravity_noise_response,
              mip_filter_gravity_noise_write_from)
MIP_COMMAND_OF(mip_filter_pressure_altitude_noise, ::mip::filter::pressure_altitude_noise_response)
MIP_CHANGE_OF(mip_filter_pressure_altitude_noise, ::mip::filter::pressure_altitude_noise_response,
              mip_filter_pressure_altitude_noise_write_from)
MIP_COMMAND_OF(mip_filter_hard_iron_offset_noise, ::mip::filter::hard_iron_offset_noise_response)
MIP_CHANGE_OF(mip_filter_hard_iron_offset_noise, ::mip::filter::hard_iron_offset_noise_response,
              mip_filter_hard_iron_offset_noise_write_from)
MIP_COMMAND_OF(mip_filter_soft_iron_matrix_noise, ::mip::filter::soft_iron_matrix_noise_response)
MIP_CHANGE_OF(mip_filter_soft_iron_matrix_noise, ::mip::filter::soft_iron_matrix_noise_response,
              mip_filter_soft_iron_matrix_noise_write_from)
MIP_COMMAND_OF(mip_filter_enable_measurements, ::mip::filter::enable_measurements_response)
MIP_CHANGE_OF(mip_filter_enable_measurements, ::mip::filter::enable_measurements_response,
              mip_filter_enable_measurements_write_from)
MIP_COMMAND_OF(mip_filter_mag_noise, ::mip::filter::mag_noise_response)
MIP_CHANGE_OF(mip_filter_mag_noise, ::mip::filter::mag_noise_response,
              mip_filter_mag_noise_write_from)
MIP_COMMAND_OF(mip_filter_magnetic_declination_source,
               ::mip::filter::magnetic_declination_source_response)
MIP_CHANGE_OF(mip_filter_magnetic_declination_source,
              ::mip::filter::magnetic_declination_source_response,
              mip_filter_magnetic_declination_source_write_from)
MIP_COMMAND_OF(mip_filter_accel_magnitude_adaptive,
               ::mip::filter::accel_magnitude_error_adaptive_measurement_response)
MIP_CHANGE_OF(mip_filter_accel_magnitude_adaptive,
              ::mip::filter::accel_magnitude_error_adaptive_measurement_response,
              mip_filter_accel_magnitude_adaptive_write_from)
MIP_COMMAND_OF(mip_filter_mag_magnitude_adaptive,
               ::mip::filter::mag_magnitude_error_adaptive_measurement_response)
MIP_CHANGE_OF(mip_filter_mag_magnitude_adaptive,
              ::mip::filter::mag_magnitude_error_adaptive_measurement_response,
              mip_filter_mag_magnitude_adaptive_write_from)
MIP_COMMAND_OF(mip_filter_mag_dip_angle_adaptive,
               ::mip::filter::mag_dip_angle_error_adaptive_measurement_response)
MIP_CHANGE_OF(mip_filter_mag_dip_angle_adaptive,
              ::mip::filter::mag_dip_angle_error_adaptive_measurement_response,
              mip_filter_mag_dip_angle_adaptive_write_from)
MIP_COMMAND_OF(mip_filter_altitude_aiding, ::mip::filter::altitude_aiding_response)
MIP_CHANGE_OF(mip_filter_altitude_aiding, ::mip::filter::altitude_aiding_response,
              mip_filter_altitude_aiding_write_from)
MIP_COMMAND_OF(mip_filter_pitch_roll_aiding, ::mip::filter::pitch_roll_aiding_response)
MIP_CHANGE_OF(mip_filter_pitch_roll_aiding, ::mip::filter::pitch_roll_aiding_response,
              mip_filter_pitch_roll_aiding_write_from)
MIP_COMMAND_OF(mip_filter_magnetic_inclination_source,
               ::mip::filter::magnetic_inclination_source_response)
MIP_CHANGE_OF(mip_filter_magnetic_inclination_source,
              ::mip::filter::magnetic_inclination_source_response,
              mip_filter_magnetic_inclination_source_write_from)
MIP_COMMAND_OF(mip_filter_magnetic_magnitude_source,
               ::mip::filter::magnetic_magnitude_source_response)
MIP_CHANGE_OF(mip_filter_magnetic_magnitude_source,
              ::mip::filter::magnetic_magnitude_source_response,
              mip_filter_magnetic_magnitude_source_write_from)
MIP_COMMAND_OF(mip_filter_sensor_to_vehicle_rotation_dcm,
               ::mip::filter::sensor_to_vehicle_rotation_dcm_response)
MIP_CHANGE_OF(mip_filter_sensor_to_vehicle_rotation_dcm,
              ::mip::filter::sensor_to_vehicle_rotation_dcm_response,
              mip_filter_sensor_to_vehicle_rotation_dcm_write_from)
MIP_COMMAND_OF(mip_filter_sensor_to_vehicle_quaternion,
               ::mip::filter::sensor_to_vehicle_rotation_quaternion_response)
MIP_CHANGE_OF(mip_filter_sensor_to_vehicle_quaternion,
              ::mip::filter::sensor_to_vehicle_rotation_quaternion_response,
              mip_filter_sensor_to_vehicle_quaternion_write_from)
MIP_COMMAND_OF(mip_filter_aiding_measurement_enable,
               ::mip::filter::aiding_measurement_enable_response)
MIP_CHANGE_OF(mip_filter_aiding_measurement_enable,
              ::mip::filter::aiding_measurement_enable_response,
              mip_filter_aiding_measurement_enable_write_from)
MIP_COMMAND_OF(mip_filter_kinematic_constraint, ::mip::filter::kinematic_constraint_response)
MIP_CHANGE_OF(mip_filter_kinematic_constraint, ::mip::filter::kinematic_constraint_response,
              mip_filter_kinematic_constraint_write_from)
MIP_COMMAND_OF(mip_filter_initialization_config, ::mip::filter::initialization_config_response)
MIP_CHANGE_OF(mip_filter_initialization_config, ::mip::filter::initialization_config_response,
              mip_filter_initialization_config_write_from)
MIP_COMMAND_OF(mip_filter_adaptive_filter_options, ::mip::filter::adaptive_filter_options_response)
MIP_CHANGE_OF(mip_filter_adaptive_filter_options, ::mip::filter::adaptive_filter_options_response,
              mip_filter_adaptive_filter_options_write_from)
MIP_COMMAND_OF(mip_filter_multi_antenna_offset, ::mip::filter::multi_antenna_offset_response)
MIP_CHANGE_OF(mip_filter_multi_antenna_offset, ::mip::filter::multi_antenna_offset_response,
              mip_filter_multi_antenna_offset_write_from)
MIP_COMMAND_OF(mip_filter_relative_position_config,
               ::mip::filter::relative_position_config_response)
MIP_CHANGE_OF(mip_filter_relative_position_config, ::mip::filter::relative_position_config_response,
              mip_filter_relative_position_config_write_from)
MIP_COMMAND_OF(mip_filter_reference_point_lever_arm,
               ::mip::filter::reference_point_lever_arm_response)
MIP_CHANGE_OF(mip_filter_reference_point_lever_arm,
              ::mip::filter::reference_point_lever_arm_response,
              mip_filter_reference_point_lever_arm_write_from)
MIP_COMMAND_OF(mip_filter_speed_measurement, void)
MIP_COMMAND_OF(mip_filter_speed_lever_arm, ::mip::filter::speed_lever_arm_response)
MIP_CHANGE_OF(mip_filter_speed_lever_arm, ::mip::filter::speed_lever_arm_response,
              mip_filter_speed_lever_arm_write_from)
MIP_COMMAND_OF(mip_filter_vertical_gyro_constraint_control,
               ::mip::filter::vertical_gyro_constraint_control_response)
MIP_CHANGE_OF(mip_filter_vertical_gyro_constraint_control,
              ::mip::filter::vertical_gyro_constraint_control_response,
              mip_filter_vertical_gyro_constraint_control_write_from)
MIP_COMMAND_OF(mip_filter_wheeled_vehicle_constraint_control,
               ::mip::filter::wheeled_vehicle_constraint_control_response)
MIP_CHANGE_OF(mip_filter_wheeled_vehicle_constraint_control,
              ::mip::filter::wheeled_vehicle_constraint_control_response,
              mip_filter_wheeled_vehicle_constraint_control_write_from)
MIP_COMMAND_OF(mip_filter_gnss_antenna_calibration_control,
               ::mip::filter::gnss_antenna_calibration_control_response)
MIP_CHANGE_OF(mip_filter_gnss_antenna_calibration_control,
              ::mip::filter::gnss_antenna_calibration_control_response,
              mip_filter_gnss_antenna_calibration_control_write_from)

namespace filter {

/** @addtogroup mip_filter
 * @{ */

/** Reset navigation filter. See mip_call_filter_reset. */
struct reset : fixed_command<::mip_filter_reset, void> {};

/** Set initial attitude. See mip_call_filter_set_initial_attitude. */
struct set_initial_attitude {
    float roll;
    float pitch;
    float heading;

    using command = ::mip_filter_set_initial_attitude;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_set_initial_attitude(device_, roll, pitch, heading);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_set_initial_attitude_make(to_, roll, pitch, heading);
    }
};

/** Set initial heading. See mip_call_filter_set_initial_heading. */
struct set_initial_heading {
    float heading;

    using command = ::mip_filter_set_initial_heading;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_set_initial_heading(device_, heading);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_set_initial_heading_make(to_, heading);
    }
};

/** Set initial attitude from IMU. See mip_call_filter_set_initial_attitude_from_imu. */
struct set_initial_attitude_from_imu {
    float declination;

    using command = ::mip_filter_set_initial_attitude_from_imu;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_set_initial_attitude_from_imu(device_, declination);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_set_initial_attitude_from_imu_make(to_, declination);
    }
};

/** Run navigation filter. See mip_call_filter_run. */
struct run : fixed_command<::mip_filter_run, void> {};

/** Vehicle dynamics mode: write. See mip_call_filter_vehicle_dynamics_mode_write. */
struct write_vehicle_dynamics_mode {
    ::mip::filter::dynamics_mode mode;

    using command = ::mip_filter_vehicle_dynamics_mode;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_vehicle_dynamics_mode_write(
            device_, static_cast<enum mip_filter_dynamics_mode>(mode));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_vehicle_dynamics_mode_write(
            to_, static_cast<enum mip_filter_dynamics_mode>(mode));
    }
};

/** Vehicle dynamics mode: read. See mip_call_filter_vehicle_dynamics_mode_read. */
struct read_vehicle_dynamics_mode
    : fixed_command<::mip_filter_vehicle_dynamics_mode,
                    ::mip::filter::vehicle_dynamics_mode_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Vehicle dynamics mode: save. See mip_call_filter_vehicle_dynamics_mode_save. */
struct save_vehicle_dynamics_mode
    : fixed_command<::mip_filter_vehicle_dynamics_mode, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Vehicle dynamics mode: load. See mip_call_filter_vehicle_dynamics_mode_load. */
struct load_vehicle_dynamics_mode
    : fixed_command<::mip_filter_vehicle_dynamics_mode, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Vehicle dynamics mode: default. See mip_call_filter_vehicle_dynamics_mode_default. */
struct default_vehicle_dynamics_mode
    : fixed_command<::mip_filter_vehicle_dynamics_mode, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Sensor to vehicle frame transformation: write. See
 * mip_call_filter_sensor_to_vehicle_rotation_euler_write.
 */
struct write_sensor_to_vehicle_rotation_euler {
    float roll;
    float pitch;
    float yaw;

    using command = ::mip_filter_sensor_to_vehicle_rotation_euler;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_sensor_to_vehicle_rotation_euler_write(device_, roll, pitch, yaw);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_sensor_to_vehicle_rotation_euler_write(to_, roll, pitch, yaw);
    }
};

/**
 * Sensor to vehicle frame transformation: read. See
 * mip_call_filter_sensor_to_vehicle_rotation_euler_read.
 */
struct read_sensor_to_vehicle_rotation_euler
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_euler,
                    ::mip::filter::sensor_to_vehicle_rotation_euler_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Sensor to vehicle frame transformation: save. See
 * mip_call_filter_sensor_to_vehicle_rotation_euler_save.
 */
struct save_sensor_to_vehicle_rotation_euler
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_euler, void,
                    MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Sensor to vehicle frame transformation: load. See
 * mip_call_filter_sensor_to_vehicle_rotation_euler_load.
 */
struct load_sensor_to_vehicle_rotation_euler
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_euler, void,
                    MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Sensor to vehicle frame transformation: default. See
 * mip_call_filter_sensor_to_vehicle_rotation_euler_default.
 */
struct default_sensor_to_vehicle_rotation_euler
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_euler, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Sensor to vehicle offset: write. See mip_call_filter_sensor_to_vehicle_offset_write. */
struct write_sensor_to_vehicle_offset {
    float offset[3];

    using command = ::mip_filter_sensor_to_vehicle_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_sensor_to_vehicle_offset_write(device_, offset);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_sensor_to_vehicle_offset_write(to_, offset);
    }
};

/** Sensor to vehicle offset: read. See mip_call_filter_sensor_to_vehicle_offset_read. */
struct read_sensor_to_vehicle_offset
    : fixed_command<::mip_filter_sensor_to_vehicle_offset,
                    ::mip::filter::sensor_to_vehicle_offset_response, MIP_FUNCTION_SELECTOR_READ> {
};

/** Sensor to vehicle offset: save. See mip_call_filter_sensor_to_vehicle_offset_save. */
struct save_sensor_to_vehicle_offset
    : fixed_command<::mip_filter_sensor_to_vehicle_offset, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Sensor to vehicle offset: load. See mip_call_filter_sensor_to_vehicle_offset_load. */
struct load_sensor_to_vehicle_offset
    : fixed_command<::mip_filter_sensor_to_vehicle_offset, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Sensor to vehicle offset: default. See mip_call_filter_sensor_to_vehicle_offset_default. */
struct default_sensor_to_vehicle_offset
    : fixed_command<::mip_filter_sensor_to_vehicle_offset, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GNSS antenna offset: write. See mip_call_filter_antenna_offset_write. */
struct write_antenna_offset {
    float offset[3];

    using command = ::mip_filter_antenna_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_antenna_offset_write(device_, offset);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_antenna_offset_write(to_, offset);
    }
};

/** GNSS antenna offset: read. See mip_call_filter_antenna_offset_read. */
struct read_antenna_offset
    : fixed_command<::mip_filter_antenna_offset, ::mip::filter::antenna_offset_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** GNSS antenna offset: save. See mip_call_filter_antenna_offset_save. */
struct save_antenna_offset
    : fixed_command<::mip_filter_antenna_offset, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** GNSS antenna offset: load. See mip_call_filter_antenna_offset_load. */
struct load_antenna_offset
    : fixed_command<::mip_filter_antenna_offset, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** GNSS antenna offset: default. See mip_call_filter_antenna_offset_default. */
struct default_antenna_offset
    : fixed_command<::mip_filter_antenna_offset, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Estimation control flags: write. See mip_call_filter_estimation_control_write. */
struct write_estimation_control {
    ::mip::filter::estimated_states flags;

    using command = ::mip_filter_estimation_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_estimation_control_write(device_, ::mip::number(flags));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_estimation_control_write(to_, ::mip::number(flags));
    }
};

/** Estimation control flags: read. See mip_call_filter_estimation_control_read. */
struct read_estimation_control
    : fixed_command<::mip_filter_estimation_control, ::mip::filter::estimation_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Estimation control flags: save. See mip_call_filter_estimation_control_save. */
struct save_estimation_control
    : fixed_command<::mip_filter_estimation_control, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Estimation control flags: load. See mip_call_filter_estimation_control_load. */
struct load_estimation_control
    : fixed_command<::mip_filter_estimation_control, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Estimation control flags: default. See mip_call_filter_estimation_control_default. */
struct default_estimation_control
    : fixed_command<::mip_filter_estimation_control, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GNSS aiding source: write. See mip_call_filter_gnss_source_write. */
struct write_gnss_source {
    ::mip::filter::gnss_aiding_source source;

    using command = ::mip_filter_gnss_source;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_gnss_source_write(
            device_, static_cast<enum mip_filter_gnss_aiding_source>(source));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_gnss_source_write(
            to_, static_cast<enum mip_filter_gnss_aiding_source>(source));
    }
};

/** GNSS aiding source: read. See mip_call_filter_gnss_source_read. */
struct read_gnss_source
    : fixed_command<::mip_filter_gnss_source, ::mip::filter::gnss_source_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** GNSS aiding source: save. See mip_call_filter_gnss_source_save. */
struct save_gnss_source
    : fixed_command<::mip_filter_gnss_source, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** GNSS aiding source: load. See mip_call_filter_gnss_source_load. */
struct load_gnss_source
    : fixed_command<::mip_filter_gnss_source, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** GNSS aiding source: default. See mip_call_filter_gnss_source_default. */
struct default_gnss_source
    : fixed_command<::mip_filter_gnss_source, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** External GNSS update. See mip_call_filter_external_gnss_update. */
struct external_gnss_update {
    double tow;
    uint16_t week_number;
    double latitude;
    double longitude;
    double height;
    float velocity[3];
    float position_uncertainty[3];
    float velocity_uncertainty[3];

    using command = ::mip_filter_external_gnss_update;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_external_gnss_update(device_, tow, week_number, latitude,
                                                      longitude, height, velocity,
                                                      position_uncertainty, velocity_uncertainty);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_external_gnss_update_make(to_, tow, week_number, latitude, longitude,
                                                      height, velocity, position_uncertainty,
                                                      velocity_uncertainty);
    }
};

/** External heading update. See mip_call_filter_external_heading_update. */
struct external_heading_update {
    float heading;
    float heading_uncertainty;
    ::mip::filter::heading_type type;

    using command = ::mip_filter_external_heading_update;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_external_heading_update(
            device_, heading, heading_uncertainty, static_cast<enum mip_filter_heading_type>(type));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_external_heading_update_make(
            to_, heading, heading_uncertainty, static_cast<enum mip_filter_heading_type>(type));
    }
};

/** Heading update control: write. See mip_call_filter_heading_source_write. */
struct write_heading_source {
    ::mip::filter::heading_update_source source;

    using command = ::mip_filter_heading_source;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_heading_source_write(
            device_, static_cast<enum mip_filter_heading_update_source>(source));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_heading_source_write(
            to_, static_cast<enum mip_filter_heading_update_source>(source));
    }
};

/** Heading update control: read. See mip_call_filter_heading_source_read. */
struct read_heading_source
    : fixed_command<::mip_filter_heading_source, ::mip::filter::heading_source_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Heading update control: save. See mip_call_filter_heading_source_save. */
struct save_heading_source
    : fixed_command<::mip_filter_heading_source, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Heading update control: load. See mip_call_filter_heading_source_load. */
struct load_heading_source
    : fixed_command<::mip_filter_heading_source, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Heading update control: default. See mip_call_filter_heading_source_default. */
struct default_heading_source
    : fixed_command<::mip_filter_heading_source, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Automatic initialization: write. See mip_call_filter_auto_initialization_control_write. */
struct write_auto_initialization_control {
    uint8_t enable;

    using command = ::mip_filter_auto_initialization_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_auto_initialization_control_write(device_, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_auto_initialization_control_write(to_, enable);
    }
};

/** Automatic initialization: read. See mip_call_filter_auto_initialization_control_read. */
struct read_auto_initialization_control
    : fixed_command<::mip_filter_auto_initialization_control,
                    ::mip::filter::auto_initialization_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Automatic initialization: save. See mip_call_filter_auto_initialization_control_save. */
struct save_auto_initialization_control
    : fixed_command<::mip_filter_auto_initialization_control, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Automatic initialization: load. See mip_call_filter_auto_initialization_control_load. */
struct load_auto_initialization_control
    : fixed_command<::mip_filter_auto_initialization_control, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Automatic initialization: default. See mip_call_filter_auto_initialization_control_default. */
struct default_auto_initialization_control
    : fixed_command<::mip_filter_auto_initialization_control, void, MIP_FUNCTION_SELECTOR_DEFAULT> {
};

/** Accelerometer noise: write. See mip_call_filter_accel_noise_write. */
struct write_accel_noise {
    float noise[3];

    using command = ::mip_filter_accel_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_accel_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_accel_noise_write(to_, noise);
    }
};

/** Accelerometer noise: read. See mip_call_filter_accel_noise_read. */
struct read_accel_noise
    : fixed_command<::mip_filter_accel_noise, ::mip::filter::accel_noise_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Accelerometer noise: save. See mip_call_filter_accel_noise_save. */
struct save_accel_noise
    : fixed_command<::mip_filter_accel_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Accelerometer noise: load. See mip_call_filter_accel_noise_load. */
struct load_accel_noise
    : fixed_command<::mip_filter_accel_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Accelerometer noise: default. See mip_call_filter_accel_noise_default. */
struct default_accel_noise
    : fixed_command<::mip_filter_accel_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Gyroscope noise: write. See mip_call_filter_gyro_noise_write. */
struct write_gyro_noise {
    float noise[3];

    using command = ::mip_filter_gyro_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_gyro_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_gyro_noise_write(to_, noise);
    }
};

/** Gyroscope noise: read. See mip_call_filter_gyro_noise_read. */
struct read_gyro_noise : fixed_command<::mip_filter_gyro_noise, ::mip::filter::gyro_noise_response,
                                       MIP_FUNCTION_SELECTOR_READ> {};

/** Gyroscope noise: save. See mip_call_filter_gyro_noise_save. */
struct save_gyro_noise : fixed_command<::mip_filter_gyro_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {
};

/** Gyroscope noise: load. See mip_call_filter_gyro_noise_load. */
struct load_gyro_noise : fixed_command<::mip_filter_gyro_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {
};

/** Gyroscope noise: default. See mip_call_filter_gyro_noise_default. */
struct default_gyro_noise
    : fixed_command<::mip_filter_gyro_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Accelerometer bias model: write. See mip_call_filter_accel_bias_model_write. */
struct write_accel_bias_model {
    float beta[3];
    float noise[3];

    using command = ::mip_filter_accel_bias_model;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_accel_bias_model_write(device_, beta, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_accel_bias_model_write(to_, beta, noise);
    }
};

/** Accelerometer bias model: read. See mip_call_filter_accel_bias_model_read. */
struct read_accel_bias_model
    : fixed_command<::mip_filter_accel_bias_model, ::mip::filter::accel_bias_model_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Accelerometer bias model: save. See mip_call_filter_accel_bias_model_save. */
struct save_accel_bias_model
    : fixed_command<::mip_filter_accel_bias_model, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Accelerometer bias model: load. See mip_call_filter_accel_bias_model_load. */
struct load_accel_bias_model
    : fixed_command<::mip_filter_accel_bias_model, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Accelerometer bias model: default. See mip_call_filter_accel_bias_model_default. */
struct default_accel_bias_model
    : fixed_command<::mip_filter_accel_bias_model, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Gyroscope bias model: write. See mip_call_filter_gyro_bias_model_write. */
struct write_gyro_bias_model {
    float beta[3];
    float noise[3];

    using command = ::mip_filter_gyro_bias_model;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_gyro_bias_model_write(device_, beta, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_gyro_bias_model_write(to_, beta, noise);
    }
};

/** Gyroscope bias model: read. See mip_call_filter_gyro_bias_model_read. */
struct read_gyro_bias_model
    : fixed_command<::mip_filter_gyro_bias_model, ::mip::filter::gyro_bias_model_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Gyroscope bias model: save. See mip_call_filter_gyro_bias_model_save. */
struct save_gyro_bias_model
    : fixed_command<::mip_filter_gyro_bias_model, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Gyroscope bias model: load. See mip_call_filter_gyro_bias_model_load. */
struct load_gyro_bias_model
    : fixed_command<::mip_filter_gyro_bias_model, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Gyroscope bias model: default. See mip_call_filter_gyro_bias_model_default. */
struct default_gyro_bias_model
    : fixed_command<::mip_filter_gyro_bias_model, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Automatic zero velocity update: write. See mip_call_filter_auto_zupt_write. */
struct write_auto_zupt {
    uint8_t enable;
    float threshold;

    using command = ::mip_filter_auto_zupt;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_auto_zupt_write(device_, enable, threshold);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_auto_zupt_write(to_, enable, threshold);
    }
};

/** Automatic zero velocity update: read. See mip_call_filter_auto_zupt_read. */
struct read_auto_zupt : fixed_command<::mip_filter_auto_zupt, ::mip::filter::auto_zupt_response,
                                      MIP_FUNCTION_SELECTOR_READ> {};

/** Automatic zero velocity update: save. See mip_call_filter_auto_zupt_save. */
struct save_auto_zupt : fixed_command<::mip_filter_auto_zupt, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Automatic zero velocity update: load. See mip_call_filter_auto_zupt_load. */
struct load_auto_zupt : fixed_command<::mip_filter_auto_zupt, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Automatic zero velocity update: default. See mip_call_filter_auto_zupt_default. */
struct default_auto_zupt
    : fixed_command<::mip_filter_auto_zupt, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** External heading update with time. See mip_call_filter_external_heading_update_with_time. */
struct external_heading_update_with_time {
    double tow;
    uint16_t week_number;
    float heading;
    float heading_uncertainty;
    ::mip::filter::heading_type type;

    using command = ::mip_filter_external_heading_update_with_time;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_external_heading_update_with_time(
            device_, tow, week_number, heading, heading_uncertainty,
            static_cast<enum mip_filter_heading_type>(type));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_external_heading_update_with_time_make(
            to_, tow, week_number, heading, heading_uncertainty,
            static_cast<enum mip_filter_heading_type>(type));
    }
};

/** Zero angular rate update: write. See mip_call_filter_auto_angular_zupt_write. */
struct write_auto_angular_zupt {
    uint8_t enable;
    float threshold;

    using command = ::mip_filter_auto_angular_zupt;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_auto_angular_zupt_write(device_, enable, threshold);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_auto_angular_zupt_write(to_, enable, threshold);
    }
};

/** Zero angular rate update: read. See mip_call_filter_auto_angular_zupt_read. */
struct read_auto_angular_zupt
    : fixed_command<::mip_filter_auto_angular_zupt, ::mip::filter::auto_angular_zupt_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Zero angular rate update: save. See mip_call_filter_auto_angular_zupt_save. */
struct save_auto_angular_zupt
    : fixed_command<::mip_filter_auto_angular_zupt, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Zero angular rate update: load. See mip_call_filter_auto_angular_zupt_load. */
struct load_auto_angular_zupt
    : fixed_command<::mip_filter_auto_angular_zupt, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Zero angular rate update: default. See mip_call_filter_auto_angular_zupt_default. */
struct default_auto_angular_zupt
    : fixed_command<::mip_filter_auto_angular_zupt, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Tare orientation: write. See mip_call_filter_tare_orientation_write. */
struct write_tare_orientation {
    ::mip::filter::tare_axes axes;

    using command = ::mip_filter_tare_orientation;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_tare_orientation_write(device_, ::mip::number(axes));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_tare_orientation_write(to_, ::mip::number(axes));
    }
};

/** Tare orientation: read. See mip_call_filter_tare_orientation_read. */
struct read_tare_orientation
    : fixed_command<::mip_filter_tare_orientation, ::mip::filter::tare_orientation_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Tare orientation: save. See mip_call_filter_tare_orientation_save. */
struct save_tare_orientation
    : fixed_command<::mip_filter_tare_orientation, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Tare orientation: load. See mip_call_filter_tare_orientation_load. */
struct load_tare_orientation
    : fixed_command<::mip_filter_tare_orientation, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Tare orientation: default. See mip_call_filter_tare_orientation_default. */
struct default_tare_orientation
    : fixed_command<::mip_filter_tare_orientation, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Commanded zero velocity update. See mip_call_filter_commanded_zupt. */
struct commanded_zupt : fixed_command<::mip_filter_commanded_zupt, void> {};

/** Commanded zero angular rate update. See mip_call_filter_commanded_angular_zupt. */
struct commanded_angular_zupt : fixed_command<::mip_filter_commanded_angular_zupt, void> {};

/** Set reference position: write. See mip_call_filter_reference_position_write. */
struct write_reference_position {
    uint8_t enable;
    double latitude;
    double longitude;
    double altitude;

    using command = ::mip_filter_reference_position;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_reference_position_write(device_, enable, latitude, longitude,
                                                          altitude);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_reference_position_write(to_, enable, latitude, longitude, altitude);
    }
};

/** Set reference position: read. See mip_call_filter_reference_position_read. */
struct read_reference_position
    : fixed_command<::mip_filter_reference_position, ::mip::filter::reference_position_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Set reference position: save. See mip_call_filter_reference_position_save. */
struct save_reference_position
    : fixed_command<::mip_filter_reference_position, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Set reference position: load. See mip_call_filter_reference_position_load. */
struct load_reference_position
    : fixed_command<::mip_filter_reference_position, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Set reference position: default. See mip_call_filter_reference_position_default. */
struct default_reference_position
    : fixed_command<::mip_filter_reference_position, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Capture automatic magnetometer calibration: write. See
 * mip_call_filter_mag_capture_auto_calibration_write.
 */
struct write_mag_capture_auto_calibration
    : fixed_command<::mip_filter_mag_capture_auto_calibration, void, MIP_FUNCTION_SELECTOR_WRITE> {
};

/**
 * Capture automatic magnetometer calibration: save. See
 * mip_call_filter_mag_capture_auto_calibration_save.
 */
struct save_mag_capture_auto_calibration
    : fixed_command<::mip_filter_mag_capture_auto_calibration, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Gravity noise: write. See mip_call_filter_gravity_noise_write. */
struct write_gravity_noise {
    float noise[3];

    using command = ::mip_filter_gravity_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_gravity_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_gravity_noise_write(to_, noise);
    }
};

/** Gravity noise: read. See mip_call_filter_gravity_noise_read. */
struct read_gravity_noise
    : fixed_command<::mip_filter_gravity_noise, ::mip::filter::gravity_noise_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Gravity noise: save. See mip_call_filter_gravity_noise_save. */
struct save_gravity_noise
    : fixed_command<::mip_filter_gravity_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Gravity noise: load. See mip_call_filter_gravity_noise_load. */
struct load_gravity_noise
    : fixed_command<::mip_filter_gravity_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Gravity noise: default. See mip_call_filter_gravity_noise_default. */
struct default_gravity_noise
    : fixed_command<::mip_filter_gravity_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Pressure altitude noise: write. See mip_call_filter_pressure_altitude_noise_write. */
struct write_pressure_altitude_noise {
    float noise;

    using command = ::mip_filter_pressure_altitude_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_pressure_altitude_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_pressure_altitude_noise_write(to_, noise);
    }
};

/** Pressure altitude noise: read. See mip_call_filter_pressure_altitude_noise_read. */
struct read_pressure_altitude_noise
    : fixed_command<::mip_filter_pressure_altitude_noise,
                    ::mip::filter::pressure_altitude_noise_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Pressure altitude noise: save. See mip_call_filter_pressure_altitude_noise_save. */
struct save_pressure_altitude_noise
    : fixed_command<::mip_filter_pressure_altitude_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Pressure altitude noise: load. See mip_call_filter_pressure_altitude_noise_load. */
struct load_pressure_altitude_noise
    : fixed_command<::mip_filter_pressure_altitude_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Pressure altitude noise: default. See mip_call_filter_pressure_altitude_noise_default. */
struct default_pressure_altitude_noise
    : fixed_command<::mip_filter_pressure_altitude_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Hard iron offset noise: write. See mip_call_filter_hard_iron_offset_noise_write. */
struct write_hard_iron_offset_noise {
    float noise[3];

    using command = ::mip_filter_hard_iron_offset_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_hard_iron_offset_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_hard_iron_offset_noise_write(to_, noise);
    }
};

/** Hard iron offset noise: read. See mip_call_filter_hard_iron_offset_noise_read. */
struct read_hard_iron_offset_noise
    : fixed_command<::mip_filter_hard_iron_offset_noise,
                    ::mip::filter::hard_iron_offset_noise_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Hard iron offset noise: save. See mip_call_filter_hard_iron_offset_noise_save. */
struct save_hard_iron_offset_noise
    : fixed_command<::mip_filter_hard_iron_offset_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Hard iron offset noise: load. See mip_call_filter_hard_iron_offset_noise_load. */
struct load_hard_iron_offset_noise
    : fixed_command<::mip_filter_hard_iron_offset_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Hard iron offset noise: default. See mip_call_filter_hard_iron_offset_noise_default. */
struct default_hard_iron_offset_noise
    : fixed_command<::mip_filter_hard_iron_offset_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Soft iron matrix noise: write. See mip_call_filter_soft_iron_matrix_noise_write. */
struct write_soft_iron_matrix_noise {
    float noise[9];

    using command = ::mip_filter_soft_iron_matrix_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_soft_iron_matrix_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_soft_iron_matrix_noise_write(to_, noise);
    }
};

/** Soft iron matrix noise: read. See mip_call_filter_soft_iron_matrix_noise_read. */
struct read_soft_iron_matrix_noise
    : fixed_command<::mip_filter_soft_iron_matrix_noise,
                    ::mip::filter::soft_iron_matrix_noise_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Soft iron matrix noise: save. See mip_call_filter_soft_iron_matrix_noise_save. */
struct save_soft_iron_matrix_noise
    : fixed_command<::mip_filter_soft_iron_matrix_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Soft iron matrix noise: load. See mip_call_filter_soft_iron_matrix_noise_load. */
struct load_soft_iron_matrix_noise
    : fixed_command<::mip_filter_soft_iron_matrix_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Soft iron matrix noise: default. See mip_call_filter_soft_iron_matrix_noise_default. */
struct default_soft_iron_matrix_noise
    : fixed_command<::mip_filter_soft_iron_matrix_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Enable or disable measurements: write. See mip_call_filter_enable_measurements_write. */
struct write_enable_measurements {
    ::mip::filter::measurement_flags control;

    using command = ::mip_filter_enable_measurements;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_enable_measurements_write(device_, ::mip::number(control));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_enable_measurements_write(to_, ::mip::number(control));
    }
};

/** Enable or disable measurements: read. See mip_call_filter_enable_measurements_read. */
struct read_enable_measurements
    : fixed_command<::mip_filter_enable_measurements, ::mip::filter::enable_measurements_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Enable or disable measurements: save. See mip_call_filter_enable_measurements_save. */
struct save_enable_measurements
    : fixed_command<::mip_filter_enable_measurements, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Enable or disable measurements: load. See mip_call_filter_enable_measurements_load. */
struct load_enable_measurements
    : fixed_command<::mip_filter_enable_measurements, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Enable or disable measurements: default. See mip_call_filter_enable_measurements_default. */
struct default_enable_measurements
    : fixed_command<::mip_filter_enable_measurements, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Magnetometer noise: write. See mip_call_filter_mag_noise_write. */
struct write_mag_noise {
    float noise[3];

    using command = ::mip_filter_mag_noise;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_mag_noise_write(device_, noise);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_mag_noise_write(to_, noise);
    }
};

/** Magnetometer noise: read. See mip_call_filter_mag_noise_read. */
struct read_mag_noise : fixed_command<::mip_filter_mag_noise, ::mip::filter::mag_noise_response,
                                      MIP_FUNCTION_SELECTOR_READ> {};

/** Magnetometer noise: save. See mip_call_filter_mag_noise_save. */
struct save_mag_noise : fixed_command<::mip_filter_mag_noise, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Magnetometer noise: load. See mip_call_filter_mag_noise_load. */
struct load_mag_noise : fixed_command<::mip_filter_mag_noise, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Magnetometer noise: default. See mip_call_filter_mag_noise_default. */
struct default_mag_noise
    : fixed_command<::mip_filter_mag_noise, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Magnetic declination source: write. See mip_call_filter_magnetic_declination_source_write. */
struct write_magnetic_declination_source {
    ::mip::filter::mag_parameter_source source;
    float declination;

    using command = ::mip_filter_magnetic_declination_source;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_magnetic_declination_source_write(
            device_, static_cast<enum mip_filter_mag_parameter_source>(source), declination);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_magnetic_declination_source_write(
            to_, static_cast<enum mip_filter_mag_parameter_source>(source), declination);
    }
};

/** Magnetic declination source: read. See mip_call_filter_magnetic_declination_source_read. */
struct read_magnetic_declination_source
    : fixed_command<::mip_filter_magnetic_declination_source,
                    ::mip::filter::magnetic_declination_source_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Magnetic declination source: save. See mip_call_filter_magnetic_declination_source_save. */
struct save_magnetic_declination_source
    : fixed_command<::mip_filter_magnetic_declination_source, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Magnetic declination source: load. See mip_call_filter_magnetic_declination_source_load. */
struct load_magnetic_declination_source
    : fixed_command<::mip_filter_magnetic_declination_source, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Magnetic declination source: default. See mip_call_filter_magnetic_declination_source_default.
 */
struct default_magnetic_declination_source
    : fixed_command<::mip_filter_magnetic_declination_source, void, MIP_FUNCTION_SELECTOR_DEFAULT> {
};

/**
 * Gravity magnitude error adaptive measurement: write. See
 * mip_call_filter_accel_magnitude_adaptive_write.
 */
struct write_accel_magnitude_error_adaptive_measurement {
    ::mip::filter::adaptive_measurement_selector adaptive_measurement;

    using command = ::mip_filter_accel_magnitude_adaptive;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_accel_magnitude_adaptive_write(
            device_,
            static_cast<enum mip_filter_adaptive_measurement_selector>(adaptive_measurement));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_accel_magnitude_adaptive_write(
            to_, static_cast<enum mip_filter_adaptive_measurement_selector>(adaptive_measurement));
    }
};

/**
 * Gravity magnitude error adaptive measurement: read. See
 * mip_call_filter_accel_magnitude_adaptive_read.
 */
struct read_accel_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_accel_magnitude_adaptive,
                    ::mip::filter::accel_magnitude_error_adaptive_measurement_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Gravity magnitude error adaptive measurement: save. See
 * mip_call_filter_accel_magnitude_adaptive_save.
 */
struct save_accel_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_accel_magnitude_adaptive, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Gravity magnitude error adaptive measurement: load. See
 * mip_call_filter_accel_magnitude_adaptive_load.
 */
struct load_accel_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_accel_magnitude_adaptive, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Gravity magnitude error adaptive measurement: default. See
 * mip_call_filter_accel_magnitude_adaptive_default.
 */
struct default_accel_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_accel_magnitude_adaptive, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Magnetometer magnitude error adaptive measurement: write. See
 * mip_call_filter_mag_magnitude_adaptive_write.
 */
struct write_mag_magnitude_error_adaptive_measurement {
    ::mip::filter::adaptive_measurement_selector adaptive_measurement;
    float frequency;
    float low_limit;
    float high_limit;
    float low_limit_uncertainty;
    float high_limit_uncertainty;
    float minimum_uncertainty;

    using command = ::mip_filter_mag_magnitude_adaptive;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_mag_magnitude_adaptive_write(
            device_,
            static_cast<enum mip_filter_adaptive_measurement_selector>(adaptive_measurement),
            frequency, low_limit, high_limit, low_limit_uncertainty, high_limit_uncertainty,
            minimum_uncertainty);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_mag_magnitude_adaptive_write(
            to_, static_cast<enum mip_filter_adaptive_measurement_selector>(adaptive_measurement),
            frequency, low_limit, high_limit, low_limit_uncertainty, high_limit_uncertainty,
            minimum_uncertainty);
    }
};

/**
 * Magnetometer magnitude error adaptive measurement: read. See
 * mip_call_filter_mag_magnitude_adaptive_read.
 */
struct read_mag_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_magnitude_adaptive,
                    ::mip::filter::mag_magnitude_error_adaptive_measurement_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Magnetometer magnitude error adaptive measurement: save. See
 * mip_call_filter_mag_magnitude_adaptive_save.
 */
struct save_mag_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_magnitude_adaptive, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Magnetometer magnitude error adaptive measurement: load. See
 * mip_call_filter_mag_magnitude_adaptive_load.
 */
struct load_mag_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_magnitude_adaptive, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Magnetometer magnitude error adaptive measurement: default. See
 * mip_call_filter_mag_magnitude_adaptive_default.
 */
struct default_mag_magnitude_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_magnitude_adaptive, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Magnetometer dip angle error adaptive measurement: write. See
 * mip_call_filter_mag_dip_angle_adaptive_write.
 */
struct write_mag_dip_angle_error_adaptive_measurement {
    bool enable;
    float frequency;
    float high_limit;
    float high_limit_uncertainty;
    float minimum_uncertainty;

    using command = ::mip_filter_mag_dip_angle_adaptive;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_mag_dip_angle_adaptive_write(
            device_, enable, frequency, high_limit, high_limit_uncertainty, minimum_uncertainty);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_mag_dip_angle_adaptive_write(
            to_, enable, frequency, high_limit, high_limit_uncertainty, minimum_uncertainty);
    }
};

/**
 * Magnetometer dip angle error adaptive measurement: read. See
 * mip_call_filter_mag_dip_angle_adaptive_read.
 */
struct read_mag_dip_angle_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_dip_angle_adaptive,
                    ::mip::filter::mag_dip_angle_error_adaptive_measurement_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Magnetometer dip angle error adaptive measurement: save. See
 * mip_call_filter_mag_dip_angle_adaptive_save.
 */
struct save_mag_dip_angle_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_dip_angle_adaptive, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Magnetometer dip angle error adaptive measurement: load. See
 * mip_call_filter_mag_dip_angle_adaptive_load.
 */
struct load_mag_dip_angle_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_dip_angle_adaptive, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Magnetometer dip angle error adaptive measurement: default. See
 * mip_call_filter_mag_dip_angle_adaptive_default.
 */
struct default_mag_dip_angle_error_adaptive_measurement
    : fixed_command<::mip_filter_mag_dip_angle_adaptive, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Altitude aiding: write. See mip_call_filter_altitude_aiding_write. */
struct write_altitude_aiding {
    ::mip::filter::altitude_aiding_source selector;

    using command = ::mip_filter_altitude_aiding;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_altitude_aiding_write(
            device_, static_cast<enum mip_filter_altitude_aiding_source>(selector));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_altitude_aiding_write(
            to_, static_cast<enum mip_filter_altitude_aiding_source>(selector));
    }
};

/** Altitude aiding: read. See mip_call_filter_altitude_aiding_read. */
struct read_altitude_aiding
    : fixed_command<::mip_filter_altitude_aiding, ::mip::filter::altitude_aiding_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Altitude aiding: save. See mip_call_filter_altitude_aiding_save. */
struct save_altitude_aiding
    : fixed_command<::mip_filter_altitude_aiding, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Altitude aiding: load. See mip_call_filter_altitude_aiding_load. */
struct load_altitude_aiding
    : fixed_command<::mip_filter_altitude_aiding, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Altitude aiding: default. See mip_call_filter_altitude_aiding_default. */
struct default_altitude_aiding
    : fixed_command<::mip_filter_altitude_aiding, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Pitch and roll aiding: write. See mip_call_filter_pitch_roll_aiding_write. */
struct write_pitch_roll_aiding {
    ::mip::filter::pitch_roll_aiding_source aiding;

    using command = ::mip_filter_pitch_roll_aiding;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_pitch_roll_aiding_write(
            device_, static_cast<enum mip_filter_pitch_roll_aiding_source>(aiding));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_pitch_roll_aiding_write(
            to_, static_cast<enum mip_filter_pitch_roll_aiding_source>(aiding));
    }
};

/** Pitch and roll aiding: read. See mip_call_filter_pitch_roll_aiding_read. */
struct read_pitch_roll_aiding
    : fixed_command<::mip_filter_pitch_roll_aiding, ::mip::filter::pitch_roll_aiding_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Pitch and roll aiding: save. See mip_call_filter_pitch_roll_aiding_save. */
struct save_pitch_roll_aiding
    : fixed_command<::mip_filter_pitch_roll_aiding, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Pitch and roll aiding: load. See mip_call_filter_pitch_roll_aiding_load. */
struct load_pitch_roll_aiding
    : fixed_command<::mip_filter_pitch_roll_aiding, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Pitch and roll aiding: default. See mip_call_filter_pitch_roll_aiding_default. */
struct default_pitch_roll_aiding
    : fixed_command<::mip_filter_pitch_roll_aiding, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Magnetic inclination source: write. See mip_call_filter_magnetic_inclination_source_write. */
struct write_magnetic_inclination_source {
    ::mip::filter::mag_parameter_source source;
    float inclination;

    using command = ::mip_filter_magnetic_inclination_source;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_magnetic_inclination_source_write(
            device_, static_cast<enum mip_filter_mag_parameter_source>(source), inclination);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_magnetic_inclination_source_write(
            to_, static_cast<enum mip_filter_mag_parameter_source>(source), inclination);
    }
};

/** Magnetic inclination source: read. See mip_call_filter_magnetic_inclination_source_read. */
struct read_magnetic_inclination_source
    : fixed_command<::mip_filter_magnetic_inclination_source,
                    ::mip::filter::magnetic_inclination_source_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Magnetic inclination source: save. See mip_call_filter_magnetic_inclination_source_save. */
struct save_magnetic_inclination_source
    : fixed_command<::mip_filter_magnetic_inclination_source, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Magnetic inclination source: load. See mip_call_filter_magnetic_inclination_source_load. */
struct load_magnetic_inclination_source
    : fixed_command<::mip_filter_magnetic_inclination_source, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Magnetic inclination source: default. See mip_call_filter_magnetic_inclination_source_default.
 */
struct default_magnetic_inclination_source
    : fixed_command<::mip_filter_magnetic_inclination_source, void, MIP_FUNCTION_SELECTOR_DEFAULT> {
};

/** Magnetic field magnitude source: write. See mip_call_filter_magnetic_magnitude_source_write. */
struct write_magnetic_magnitude_source {
    ::mip::filter::mag_parameter_source source;
    float magnitude;

    using command = ::mip_filter_magnetic_magnitude_source;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_magnetic_magnitude_source_write(
            device_, static_cast<enum mip_filter_mag_parameter_source>(source), magnitude);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_magnetic_magnitude_source_write(
            to_, static_cast<enum mip_filter_mag_parameter_source>(source), magnitude);
    }
};

/** Magnetic field magnitude source: read. See mip_call_filter_magnetic_magnitude_source_read. */
struct read_magnetic_magnitude_source
    : fixed_command<::mip_filter_magnetic_magnitude_source,
                    ::mip::filter::magnetic_magnitude_source_response, MIP_FUNCTION_SELECTOR_READ> {
};

/** Magnetic field magnitude source: save. See mip_call_filter_magnetic_magnitude_source_save. */
struct save_magnetic_magnitude_source
    : fixed_command<::mip_filter_magnetic_magnitude_source, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Magnetic field magnitude source: load. See mip_call_filter_magnetic_magnitude_source_load. */
struct load_magnetic_magnitude_source
    : fixed_command<::mip_filter_magnetic_magnitude_source, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Magnetic field magnitude source: default. See mip_call_filter_magnetic_magnitude_source_default.
 */
struct default_magnetic_magnitude_source
    : fixed_command<::mip_filter_magnetic_magnitude_source, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Sensor to vehicle rotation, matrix: write. See
 * mip_call_filter_sensor_to_vehicle_rotation_dcm_write.
 */
struct write_sensor_to_vehicle_rotation_dcm {
    float dcm[9];

    using command = ::mip_filter_sensor_to_vehicle_rotation_dcm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_sensor_to_vehicle_rotation_dcm_write(device_, dcm);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_sensor_to_vehicle_rotation_dcm_write(to_, dcm);
    }
};

/**
 * Sensor to vehicle rotation, matrix: read. See
 * mip_call_filter_sensor_to_vehicle_rotation_dcm_read.
 */
struct read_sensor_to_vehicle_rotation_dcm
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_dcm,
                    ::mip::filter::sensor_to_vehicle_rotation_dcm_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Sensor to vehicle rotation, matrix: save. See
 * mip_call_filter_sensor_to_vehicle_rotation_dcm_save.
 */
struct save_sensor_to_vehicle_rotation_dcm
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_dcm, void, MIP_FUNCTION_SELECTOR_SAVE> {
};

/**
 * Sensor to vehicle rotation, matrix: load. See
 * mip_call_filter_sensor_to_vehicle_rotation_dcm_load.
 */
struct load_sensor_to_vehicle_rotation_dcm
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_dcm, void, MIP_FUNCTION_SELECTOR_LOAD> {
};

/**
 * Sensor to vehicle rotation, matrix: default. See
 * mip_call_filter_sensor_to_vehicle_rotation_dcm_default.
 */
struct default_sensor_to_vehicle_rotation_dcm
    : fixed_command<::mip_filter_sensor_to_vehicle_rotation_dcm, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Sensor to vehicle rotation, quaternion: write. See
 * mip_call_filter_sensor_to_vehicle_quaternion_write.
 */
struct write_sensor_to_vehicle_rotation_quaternion {
    float q[4];

    using command = ::mip_filter_sensor_to_vehicle_quaternion;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_sensor_to_vehicle_quaternion_write(device_, q);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_sensor_to_vehicle_quaternion_write(to_, q);
    }
};

/**
 * Sensor to vehicle rotation, quaternion: read. See
 * mip_call_filter_sensor_to_vehicle_quaternion_read.
 */
struct read_sensor_to_vehicle_rotation_quaternion
    : fixed_command<::mip_filter_sensor_to_vehicle_quaternion,
                    ::mip::filter::sensor_to_vehicle_rotation_quaternion_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Sensor to vehicle rotation, quaternion: save. See
 * mip_call_filter_sensor_to_vehicle_quaternion_save.
 */
struct save_sensor_to_vehicle_rotation_quaternion
    : fixed_command<::mip_filter_sensor_to_vehicle_quaternion, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Sensor to vehicle rotation, quaternion: load. See
 * mip_call_filter_sensor_to_vehicle_quaternion_load.
 */
struct load_sensor_to_vehicle_rotation_quaternion
    : fixed_command<::mip_filter_sensor_to_vehicle_quaternion, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Sensor to vehicle rotation, quaternion: default. See
 * mip_call_filter_sensor_to_vehicle_quaternion_default.
 */
struct default_sensor_to_vehicle_rotation_quaternion
    : fixed_command<::mip_filter_sensor_to_vehicle_quaternion, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Aiding measurement control: write. See mip_call_filter_aiding_measurement_enable_write. */
struct write_aiding_measurement_enable {
    ::mip::filter::aiding_source aiding_source;
    bool enable;

    using command = ::mip_filter_aiding_measurement_enable;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_aiding_measurement_enable_write(
            device_, ::mip::number(aiding_source), enable);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_aiding_measurement_enable_write(to_, ::mip::number(aiding_source),
                                                            enable);
    }
};

/** Aiding measurement control: read. See mip_call_filter_aiding_measurement_enable_read. */
struct read_aiding_measurement_enable {
    ::mip::filter::aiding_source aiding_source;

    using command = ::mip_filter_aiding_measurement_enable;
    using response = ::mip::filter::aiding_measurement_enable_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_filter_aiding_measurement_enable_read(device_,
                                                                ::mip::number(aiding_source), to_);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_aiding_measurement_enable_read(to_, ::mip::number(aiding_source));
    }
};

/** Aiding measurement control: save. See mip_call_filter_aiding_measurement_enable_save. */
struct save_aiding_measurement_enable {
    ::mip::filter::aiding_source aiding_source;

    using command = ::mip_filter_aiding_measurement_enable;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_aiding_measurement_enable_save(device_,
                                                                ::mip::number(aiding_source));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_aiding_measurement_enable_save(to_, ::mip::number(aiding_source));
    }
};

/** Aiding measurement control: load. See mip_call_filter_aiding_measurement_enable_load. */
struct load_aiding_measurement_enable {
    ::mip::filter::aiding_source aiding_source;

    using command = ::mip_filter_aiding_measurement_enable;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_aiding_measurement_enable_load(device_,
                                                                ::mip::number(aiding_source));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_aiding_measurement_enable_load(to_, ::mip::number(aiding_source));
    }
};

/** Aiding measurement control: default. See mip_call_filter_aiding_measurement_enable_default. */
struct default_aiding_measurement_enable {
    ::mip::filter::aiding_source aiding_source;

    using command = ::mip_filter_aiding_measurement_enable;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_aiding_measurement_enable_default(device_,
                                                                   ::mip::number(aiding_source));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_aiding_measurement_enable_default(to_, ::mip::number(aiding_source));
    }
};

/** Kinematic constraint: write. See mip_call_filter_kinematic_constraint_write. */
struct write_kinematic_constraint {
    ::mip::filter::accel_constraint accel_constraint;
    ::mip::filter::velocity_constraint velocity_constraint;
    ::mip::filter::angular_constraint angular_constraint;

    using command = ::mip_filter_kinematic_constraint;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_kinematic_constraint_write(
            device_, static_cast<enum mip_filter_accel_constraint>(accel_constraint),
            static_cast<enum mip_filter_velocity_constraint>(velocity_constraint),
            static_cast<enum mip_filter_angular_constraint>(angular_constraint));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_kinematic_constraint_write(
            to_, static_cast<enum mip_filter_accel_constraint>(accel_constraint),
            static_cast<enum mip_filter_velocity_constraint>(velocity_constraint),
            static_cast<enum mip_filter_angular_constraint>(angular_constraint));
    }
};

/** Kinematic constraint: read. See mip_call_filter_kinematic_constraint_read. */
struct read_kinematic_constraint
    : fixed_command<::mip_filter_kinematic_constraint, ::mip::filter::kinematic_constraint_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Kinematic constraint: save. See mip_call_filter_kinematic_constraint_save. */
struct save_kinematic_constraint
    : fixed_command<::mip_filter_kinematic_constraint, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Kinematic constraint: load. See mip_call_filter_kinematic_constraint_load. */
struct load_kinematic_constraint
    : fixed_command<::mip_filter_kinematic_constraint, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Kinematic constraint: default. See mip_call_filter_kinematic_constraint_default. */
struct default_kinematic_constraint
    : fixed_command<::mip_filter_kinematic_constraint, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Navigation filter initialization: write. See mip_call_filter_initialization_config_write. */
struct write_initialization_config {
    uint8_t wait_for_run_command;
    ::mip::filter::initial_condition_source initial_condition_source;
    ::mip::filter::heading_alignment auto_heading_alignment_selector;
    float initial_heading;
    float initial_pitch;
    float initial_roll;
    float initial_position[3];
    float initial_velocity[3];
    ::mip::filter::reference_frame reference_frame_selector;

    using command = ::mip_filter_initialization_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_initialization_config_write(
            device_, wait_for_run_command,
            static_cast<enum mip_filter_initial_condition_source>(initial_condition_source),
            ::mip::number(auto_heading_alignment_selector), initial_heading, initial_pitch,
            initial_roll, initial_position, initial_velocity,
            static_cast<enum mip_filter_reference_frame>(reference_frame_selector));
    }
    const command *fill(command *to_) const {
        return ::mip_filter_initialization_config_write(
            to_, wait_for_run_command,
            static_cast<enum mip_filter_initial_condition_source>(initial_condition_source),
            ::mip::number(auto_heading_alignment_selector), initial_heading, initial_pitch,
            initial_roll, initial_position, initial_velocity,
            static_cast<enum mip_filter_reference_frame>(reference_frame_selector));
    }
};

/** Navigation filter initialization: read. See mip_call_filter_initialization_config_read. */
struct read_initialization_config
    : fixed_command<::mip_filter_initialization_config,
                    ::mip::filter::initialization_config_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Navigation filter initialization: save. See mip_call_filter_initialization_config_save. */
struct save_initialization_config
    : fixed_command<::mip_filter_initialization_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Navigation filter initialization: load. See mip_call_filter_initialization_config_load. */
struct load_initialization_config
    : fixed_command<::mip_filter_initialization_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Navigation filter initialization: default. See mip_call_filter_initialization_config_default. */
struct default_initialization_config
    : fixed_command<::mip_filter_initialization_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Adaptive filter control: write. See mip_call_filter_adaptive_filter_options_write. */
struct write_adaptive_filter_options {
    ::mip::filter::adaptive_level level;
    uint16_t time_limit;

    using command = ::mip_filter_adaptive_filter_options;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_adaptive_filter_options_write(
            device_, static_cast<enum mip_filter_adaptive_level>(level), time_limit);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_adaptive_filter_options_write(
            to_, static_cast<enum mip_filter_adaptive_level>(level), time_limit);
    }
};

/** Adaptive filter control: read. See mip_call_filter_adaptive_filter_options_read. */
struct read_adaptive_filter_options
    : fixed_command<::mip_filter_adaptive_filter_options,
                    ::mip::filter::adaptive_filter_options_response, MIP_FUNCTION_SELECTOR_READ> {};

/** Adaptive filter control: save. See mip_call_filter_adaptive_filter_options_save. */
struct save_adaptive_filter_options
    : fixed_command<::mip_filter_adaptive_filter_options, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Adaptive filter control: load. See mip_call_filter_adaptive_filter_options_load. */
struct load_adaptive_filter_options
    : fixed_command<::mip_filter_adaptive_filter_options, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Adaptive filter control: default. See mip_call_filter_adaptive_filter_options_default. */
struct default_adaptive_filter_options
    : fixed_command<::mip_filter_adaptive_filter_options, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** GNSS multi-antenna offset: write. See mip_call_filter_multi_antenna_offset_write. */
struct write_multi_antenna_offset {
    uint8_t receiver_id;
    float antenna_offset[3];

    using command = ::mip_filter_multi_antenna_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_multi_antenna_offset_write(device_, receiver_id, antenna_offset);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_multi_antenna_offset_write(to_, receiver_id, antenna_offset);
    }
};

/** GNSS multi-antenna offset: read. See mip_call_filter_multi_antenna_offset_read. */
struct read_multi_antenna_offset {
    uint8_t receiver_id;

    using command = ::mip_filter_multi_antenna_offset;
    using response = ::mip::filter::multi_antenna_offset_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_filter_multi_antenna_offset_read(device_, receiver_id, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_multi_antenna_offset_read(to_, receiver_id);
    }
};

/** GNSS multi-antenna offset: save. See mip_call_filter_multi_antenna_offset_save. */
struct save_multi_antenna_offset {
    uint8_t receiver_id;

    using command = ::mip_filter_multi_antenna_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_multi_antenna_offset_save(device_, receiver_id);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_multi_antenna_offset_save(to_, receiver_id);
    }
};

/** GNSS multi-antenna offset: load. See mip_call_filter_multi_antenna_offset_load. */
struct load_multi_antenna_offset {
    uint8_t receiver_id;

    using command = ::mip_filter_multi_antenna_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_multi_antenna_offset_load(device_, receiver_id);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_multi_antenna_offset_load(to_, receiver_id);
    }
};

/** GNSS multi-antenna offset: default. See mip_call_filter_multi_antenna_offset_default. */
struct default_multi_antenna_offset {
    uint8_t receiver_id;

    using command = ::mip_filter_multi_antenna_offset;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_multi_antenna_offset_default(device_, receiver_id);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_multi_antenna_offset_default(to_, receiver_id);
    }
};

/** Relative position configuration: write. See mip_call_filter_relative_position_config_write. */
struct write_relative_position_config {
    ::mip::filter::relative_position_source source;
    ::mip::filter::reference_frame reference_frame_selector;
    double reference_coordinates[3];

    using command = ::mip_filter_relative_position_config;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_relative_position_config_write(
            device_, static_cast<enum mip_filter_relative_position_source>(source),
            static_cast<enum mip_filter_reference_frame>(reference_frame_selector),
            reference_coordinates);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_relative_position_config_write(
            to_, static_cast<enum mip_filter_relative_position_source>(source),
            static_cast<enum mip_filter_reference_frame>(reference_frame_selector),
            reference_coordinates);
    }
};

/** Relative position configuration: read. See mip_call_filter_relative_position_config_read. */
struct read_relative_position_config
    : fixed_command<::mip_filter_relative_position_config,
                    ::mip::filter::relative_position_config_response, MIP_FUNCTION_SELECTOR_READ> {
};

/** Relative position configuration: save. See mip_call_filter_relative_position_config_save. */
struct save_relative_position_config
    : fixed_command<::mip_filter_relative_position_config, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Relative position configuration: load. See mip_call_filter_relative_position_config_load. */
struct load_relative_position_config
    : fixed_command<::mip_filter_relative_position_config, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Relative position configuration: default. See mip_call_filter_relative_position_config_default.
 */
struct default_relative_position_config
    : fixed_command<::mip_filter_relative_position_config, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Reference point lever arm: write. See mip_call_filter_reference_point_lever_arm_write. */
struct write_reference_point_lever_arm {
    ::mip::filter::reference_point reference_point;
    float lever_arm_offset[3];

    using command = ::mip_filter_reference_point_lever_arm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_reference_point_lever_arm_write(
            device_, static_cast<enum mip_filter_reference_point>(reference_point),
            lever_arm_offset);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_reference_point_lever_arm_write(
            to_, static_cast<enum mip_filter_reference_point>(reference_point), lever_arm_offset);
    }
};

/** Reference point lever arm: read. See mip_call_filter_reference_point_lever_arm_read. */
struct read_reference_point_lever_arm
    : fixed_command<::mip_filter_reference_point_lever_arm,
                    ::mip::filter::reference_point_lever_arm_response, MIP_FUNCTION_SELECTOR_READ> {
};

/** Reference point lever arm: save. See mip_call_filter_reference_point_lever_arm_save. */
struct save_reference_point_lever_arm
    : fixed_command<::mip_filter_reference_point_lever_arm, void, MIP_FUNCTION_SELECTOR_SAVE> {};

/** Reference point lever arm: load. See mip_call_filter_reference_point_lever_arm_load. */
struct load_reference_point_lever_arm
    : fixed_command<::mip_filter_reference_point_lever_arm, void, MIP_FUNCTION_SELECTOR_LOAD> {};

/** Reference point lever arm: default. See mip_call_filter_reference_point_lever_arm_default. */
struct default_reference_point_lever_arm
    : fixed_command<::mip_filter_reference_point_lever_arm, void, MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** Speed measurement. See mip_call_filter_speed_measurement. */
struct speed_measurement {
    float tow;
    float speed;
    float speed_uncertainty;

    using command = ::mip_filter_speed_measurement;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_speed_measurement(device_, tow, speed, speed_uncertainty);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_speed_measurement_make(to_, tow, speed, speed_uncertainty);
    }
};

/** Speed measurement lever arm: write. See mip_call_filter_speed_lever_arm_write. */
struct write_speed_lever_arm {
    float lever_arm_offset[3];

    using command = ::mip_filter_speed_lever_arm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_speed_lever_arm_write(device_, lever_arm_offset);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_speed_lever_arm_write(to_, lever_arm_offset);
    }
};

/** Speed measurement lever arm: read. See mip_call_filter_speed_lever_arm_read. */
struct read_speed_lever_arm {

    using command = ::mip_filter_speed_lever_arm;
    using response = ::mip::filter::speed_lever_arm_response;
    mip_result call(mip_device *device_, response *to_) const {
        return ::mip_call_filter_speed_lever_arm_read(device_, to_);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_speed_lever_arm_read(to_);
    }
};

/** Speed measurement lever arm: save. See mip_call_filter_speed_lever_arm_save. */
struct save_speed_lever_arm {

    using command = ::mip_filter_speed_lever_arm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_speed_lever_arm_save(device_);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_speed_lever_arm_save(to_);
    }
};

/** Speed measurement lever arm: load. See mip_call_filter_speed_lever_arm_load. */
struct load_speed_lever_arm {

    using command = ::mip_filter_speed_lever_arm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_speed_lever_arm_load(device_);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_speed_lever_arm_load(to_);
    }
};

/** Speed measurement lever arm: default. See mip_call_filter_speed_lever_arm_default. */
struct default_speed_lever_arm {

    using command = ::mip_filter_speed_lever_arm;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_speed_lever_arm_default(device_);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_speed_lever_arm_default(to_);
    }
};

/** Vertical gyro constraint: write. See mip_call_filter_vertical_gyro_constraint_control_write. */
struct write_vertical_gyro_constraint_control {
    uint8_t enable;

    using command = ::mip_filter_vertical_gyro_constraint_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_vertical_gyro_constraint_control_write(device_, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_vertical_gyro_constraint_control_write(to_, enable);
    }
};

/** Vertical gyro constraint: read. See mip_call_filter_vertical_gyro_constraint_control_read. */
struct read_vertical_gyro_constraint_control
    : fixed_command<::mip_filter_vertical_gyro_constraint_control,
                    ::mip::filter::vertical_gyro_constraint_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/** Vertical gyro constraint: save. See mip_call_filter_vertical_gyro_constraint_control_save. */
struct save_vertical_gyro_constraint_control
    : fixed_command<::mip_filter_vertical_gyro_constraint_control, void,
                    MIP_FUNCTION_SELECTOR_SAVE> {};

/** Vertical gyro constraint: load. See mip_call_filter_vertical_gyro_constraint_control_load. */
struct load_vertical_gyro_constraint_control
    : fixed_command<::mip_filter_vertical_gyro_constraint_control, void,
                    MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Vertical gyro constraint: default. See mip_call_filter_vertical_gyro_constraint_control_default.
 */
struct default_vertical_gyro_constraint_control
    : fixed_command<::mip_filter_vertical_gyro_constraint_control, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * Wheeled vehicle constraint: write. See mip_call_filter_wheeled_vehicle_constraint_control_write.
 */
struct write_wheeled_vehicle_constraint_control {
    uint8_t enable;

    using command = ::mip_filter_wheeled_vehicle_constraint_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_wheeled_vehicle_constraint_control_write(device_, enable);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_wheeled_vehicle_constraint_control_write(to_, enable);
    }
};

/**
 * Wheeled vehicle constraint: read. See mip_call_filter_wheeled_vehicle_constraint_control_read.
 */
struct read_wheeled_vehicle_constraint_control
    : fixed_command<::mip_filter_wheeled_vehicle_constraint_control,
                    ::mip::filter::wheeled_vehicle_constraint_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * Wheeled vehicle constraint: save. See mip_call_filter_wheeled_vehicle_constraint_control_save.
 */
struct save_wheeled_vehicle_constraint_control
    : fixed_command<::mip_filter_wheeled_vehicle_constraint_control, void,
                    MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * Wheeled vehicle constraint: load. See mip_call_filter_wheeled_vehicle_constraint_control_load.
 */
struct load_wheeled_vehicle_constraint_control
    : fixed_command<::mip_filter_wheeled_vehicle_constraint_control, void,
                    MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * Wheeled vehicle constraint: default. See
 * mip_call_filter_wheeled_vehicle_constraint_control_default.
 */
struct default_wheeled_vehicle_constraint_control
    : fixed_command<::mip_filter_wheeled_vehicle_constraint_control, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/**
 * GNSS antenna offset calibration: write. See
 * mip_call_filter_gnss_antenna_calibration_control_write.
 */
struct write_gnss_antenna_calibration_control {
    uint8_t enable;
    float max_offset;

    using command = ::mip_filter_gnss_antenna_calibration_control;
    using response = void;
    mip_result call(mip_device *device_) const {
        return ::mip_call_filter_gnss_antenna_calibration_control_write(device_, enable,
                                                                        max_offset);
    }
    const command *fill(command *to_) const {
        return ::mip_filter_gnss_antenna_calibration_control_write(to_, enable, max_offset);
    }
};

/**
 * GNSS antenna offset calibration: read. See mip_call_filter_gnss_antenna_calibration_control_read.
 */
struct read_gnss_antenna_calibration_control
    : fixed_command<::mip_filter_gnss_antenna_calibration_control,
                    ::mip::filter::gnss_antenna_calibration_control_response,
                    MIP_FUNCTION_SELECTOR_READ> {};

/**
 * GNSS antenna offset calibration: save. See mip_call_filter_gnss_antenna_calibration_control_save.
 */
struct save_gnss_antenna_calibration_control
    : fixed_command<::mip_filter_gnss_antenna_calibration_control, void,
                    MIP_FUNCTION_SELECTOR_SAVE> {};

/**
 * GNSS antenna offset calibration: load. See mip_call_filter_gnss_antenna_calibration_control_load.
 */
struct load_gnss_antenna_calibration_control
    : fixed_command<::mip_filter_gnss_antenna_calibration_control, void,
                    MIP_FUNCTION_SELECTOR_LOAD> {};

/**
 * GNSS antenna offset calibration: default. See
 * mip_call_filter_gnss_antenna_calibration_control_default.
 */
struct default_gnss_antenna_calibration_control
    : fixed_command<::mip_filter_gnss_antenna_calibration_control, void,
                    MIP_FUNCTION_SELECTOR_DEFAULT> {};

/** @} */

} // namespace filter

} // namespace mip

#endif
