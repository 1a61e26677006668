/* Aiding commands. */
#include "mip/aiding.h"
#include "mip/aiding_commands.h"
#include "mip/core/program.h"

static const uint8_t program_frame_config[] = {
    MIP_REQUIRED(5, 5, 2, 1, 1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_frame_config, frame_id)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_frame_config, format)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_frame_config, tracking_enabled)),
    MIP_GROUP(1),
    MIP_32_BITS(3, MIP_AT(struct mip_aiding_frame_config, translation)),
    MIP_GROUP(1),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_aiding_frame_config, format)),
    MIP_CASE(3, 0x01),
    MIP_32_BITS(3, MIP_AT(struct mip_aiding_frame_config, rotation.euler)),
    MIP_END,
    MIP_CASE(3, 0x02),
    MIP_32_BITS(4, MIP_AT(struct mip_aiding_frame_config, rotation.quaternion)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_aiding_frame_config, 0x13, 0x01, MIP_COMMAND, 0, 0, 0, program_frame_config,
          &mip_program);

static const struct mip_response responses_frame_config[] = {
    {NULL, 0x81, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_aiding_frame_config, 0x13, 0x01, 0, 1, responses_frame_config, true);

static const uint8_t program_frame_config_response[] = {
    MIP_8_BITS(3, MIP_AT(struct mip_aiding_frame_config_response, frame_id)),
    MIP_32_BITS(3, MIP_AT(struct mip_aiding_frame_config_response, translation)),
    MIP_SWITCH(1, 2, MIP_AT(struct mip_aiding_frame_config_response, format)),
    MIP_CASE(3, 0x01),
    MIP_32_BITS(3, MIP_AT(struct mip_aiding_frame_config_response, rotation.euler)),
    MIP_END,
    MIP_CASE(3, 0x02),
    MIP_32_BITS(4, MIP_AT(struct mip_aiding_frame_config_response, rotation.quaternion)),
    MIP_END,
    MIP_END,
};

MIP_CODEC(mip_aiding_frame_config_response, 0x13, 0x81, MIP_RESPONSE, 0, 0, 0,
          program_frame_config_response, &mip_program);

static const uint8_t program_sensor_frame_map[] = {
    MIP_REQUIRED(1, 2),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_sensor_frame_map, sensor_id)),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_sensor_frame_map, frame_id)),
    MIP_END,
};

MIP_CODEC(mip_aiding_sensor_frame_map, 0x13, 0x02, MIP_COMMAND, 0, 0, 0, program_sensor_frame_map,
          &mip_program);

static const struct mip_response responses_sensor_frame_map[] = {
    {NULL, 0x82, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_aiding_sensor_frame_map, 0x13, 0x02, 0, 1, responses_sensor_frame_map, true);

static const uint8_t program_sensor_frame_map_response[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_sensor_frame_map_response, sensor_id)),
    MIP_END,
};

MIP_CODEC(mip_aiding_sensor_frame_map_response, 0x13, 0x82, MIP_RESPONSE, 2, 0, 0,
          program_sensor_frame_map_response, NULL);

static const uint8_t program_echo_control[] = {
    MIP_REQUIRED(1, 1),
    MIP_GROUP(1),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_echo_control, mode)),
    MIP_END,
};

MIP_CODEC(mip_aiding_echo_control, 0x13, 0x1F, MIP_COMMAND, 0, 0, 0, program_echo_control,
          &mip_program);

static const struct mip_response responses_echo_control[] = {
    {NULL, 0x9F, 2, MIP_FUNCTION_SELECTOR_READ, false},
};

MIP_EXCHANGE(mip_aiding_echo_control, 0x13, 0x1F, 0, 1, responses_echo_control, true);

static const uint8_t program_echo_control_response[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_echo_control_response, mode)),
    MIP_END,
};

MIP_CODEC(mip_aiding_echo_control_response, 0x13, 0x9F, MIP_RESPONSE, 1, 0, 0,
          program_echo_control_response, NULL);

static const uint8_t program_ecef_position[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_ecef_position, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_ecef_position, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_ecef_position, frame_id)),
    MIP_DOUBLES(3, MIP_AT(struct mip_aiding_ecef_position, position)),
    MIP_32_BITS(3, MIP_AT(struct mip_aiding_ecef_position, uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_ecef_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_ecef_position, 0x13, 0x21, MIP_COMMAND, 49, 0, 0, program_ecef_position, NULL);

MIP_EXCHANGE(mip_aiding_ecef_position, 0x13, 0x21, 0, 0, NULL, false);

static const uint8_t program_llh_position[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_llh_position, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_llh_position, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_llh_position, frame_id)),
    MIP_DOUBLES(3, MIP_AT(struct mip_aiding_llh_position, latitude)),
    MIP_32_BITS(3, MIP_AT(struct mip_aiding_llh_position, uncertainty)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_llh_position, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_llh_position, 0x13, 0x22, MIP_COMMAND, 49, 0, 0, program_llh_position, NULL);

MIP_EXCHANGE(mip_aiding_llh_position, 0x13, 0x22, 0, 0, NULL, false);

static const uint8_t program_height_above_ellipsoid[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_height_above_ellipsoid, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_height_above_ellipsoid, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_height_above_ellipsoid, frame_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_aiding_height_above_ellipsoid, height)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_height_above_ellipsoid, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_height_above_ellipsoid, 0x13, 0x23, MIP_COMMAND, 21, 0, 0,
          program_height_above_ellipsoid, NULL);

MIP_EXCHANGE(mip_aiding_height_above_ellipsoid, 0x13, 0x23, 0, 0, NULL, false);

static const uint8_t program_pressure_old[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_pressure_old, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_pressure_old, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_pressure_old, frame_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_aiding_pressure_old, pressure)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_pressure_old, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_pressure_old, 0x13, 0x25, MIP_COMMAND, 21, 0, 0, program_pressure_old, NULL);

MIP_EXCHANGE(mip_aiding_pressure_old, 0x13, 0x25, 0, 0, NULL, false);

static const uint8_t program_ecef_velocity[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_ecef_velocity, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_ecef_velocity, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_ecef_velocity, frame_id)),
    MIP_32_BITS(6, MIP_AT(struct mip_aiding_ecef_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_ecef_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_ecef_velocity, 0x13, 0x28, MIP_COMMAND, 37, 0, 0, program_ecef_velocity, NULL);

MIP_EXCHANGE(mip_aiding_ecef_velocity, 0x13, 0x28, 0, 0, NULL, false);

static const uint8_t program_ned_velocity[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_ned_velocity, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_ned_velocity, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_ned_velocity, frame_id)),
    MIP_32_BITS(6, MIP_AT(struct mip_aiding_ned_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_ned_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_ned_velocity, 0x13, 0x29, MIP_COMMAND, 37, 0, 0, program_ned_velocity, NULL);

MIP_EXCHANGE(mip_aiding_ned_velocity, 0x13, 0x29, 0, 0, NULL, false);

static const uint8_t program_body_frame_velocity[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_body_frame_velocity, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_body_frame_velocity, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_body_frame_velocity, frame_id)),
    MIP_32_BITS(6, MIP_AT(struct mip_aiding_body_frame_velocity, velocity)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_body_frame_velocity, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_body_frame_velocity, 0x13, 0x2A, MIP_COMMAND, 37, 0, 0,
          program_body_frame_velocity, NULL);

MIP_EXCHANGE(mip_aiding_body_frame_velocity, 0x13, 0x2A, 0, 0, NULL, false);

static const uint8_t program_true_heading[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_true_heading, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_true_heading, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_true_heading, frame_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_aiding_true_heading, heading)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_true_heading, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_true_heading, 0x13, 0x31, MIP_COMMAND, 21, 0, 0, program_true_heading, NULL);

MIP_EXCHANGE(mip_aiding_true_heading, 0x13, 0x31, 0, 0, NULL, false);

static const uint8_t program_magnetic_field[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_magnetic_field, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_magnetic_field, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_magnetic_field, frame_id)),
    MIP_32_BITS(6, MIP_AT(struct mip_aiding_magnetic_field, magnetic_field)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_magnetic_field, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_magnetic_field, 0x13, 0x32, MIP_COMMAND, 37, 0, 0, program_magnetic_field,
          NULL);

MIP_EXCHANGE(mip_aiding_magnetic_field, 0x13, 0x32, 0, 0, NULL, false);

static const uint8_t program_pressure[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_aiding_pressure, time.timebase)),
    MIP_64_BITS(1, MIP_AT(struct mip_aiding_pressure, time.nanoseconds)),
    MIP_8_BITS(1, MIP_AT(struct mip_aiding_pressure, frame_id)),
    MIP_32_BITS(2, MIP_AT(struct mip_aiding_pressure, pressure)),
    MIP_16_BITS(1, MIP_AT(struct mip_aiding_pressure, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_aiding_pressure, 0x13, 0x33, MIP_COMMAND, 21, 0, 0, program_pressure, NULL);

MIP_EXCHANGE(mip_aiding_pressure, 0x13, 0x33, 0, 0, NULL, false);
