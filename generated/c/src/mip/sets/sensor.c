/* Sensor data. */
#include "mip/sensor.h"
#include "mip/core/program.h"

static const uint8_t program_raw_accel[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_raw_accel, raw_accel)),
    MIP_END,
};

MIP_CODEC(mip_sensor_raw_accel, 0x80, 0x01, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0), program_raw_accel,
          NULL);

static const uint8_t program_raw_gyro[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_raw_gyro, raw_gyro)),
    MIP_END,
};

MIP_CODEC(mip_sensor_raw_gyro, 0x80, 0x02, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0), program_raw_gyro,
          NULL);

static const uint8_t program_raw_mag[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_raw_mag, raw_mag)),
    MIP_END,
};

MIP_CODEC(mip_sensor_raw_mag, 0x80, 0x03, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0), program_raw_mag,
          NULL);

static const uint8_t program_scaled_accel[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_scaled_accel, scaled_accel)),
    MIP_END,
};

MIP_CODEC(mip_sensor_scaled_accel, 0x80, 0x04, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_scaled_accel, NULL);

static const uint8_t program_scaled_gyro[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_scaled_gyro, scaled_gyro)),
    MIP_END,
};

MIP_CODEC(mip_sensor_scaled_gyro, 0x80, 0x05, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_scaled_gyro, NULL);

static const uint8_t program_scaled_mag[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_scaled_mag, scaled_mag)),
    MIP_END,
};

MIP_CODEC(mip_sensor_scaled_mag, 0x80, 0x06, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_scaled_mag, NULL);

static const uint8_t program_delta_theta[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_delta_theta, delta_theta)),
    MIP_END,
};

MIP_CODEC(mip_sensor_delta_theta, 0x80, 0x07, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_delta_theta, NULL);

static const uint8_t program_delta_velocity[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_delta_velocity, delta_velocity)),
    MIP_END,
};

MIP_CODEC(mip_sensor_delta_velocity, 0x80, 0x08, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_delta_velocity, NULL);

static const uint8_t program_comp_orientation_matrix[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_sensor_comp_orientation_matrix, m)),
    MIP_END,
};

MIP_CODEC(mip_sensor_comp_orientation_matrix, 0x80, 0x09, MIP_DATA, 36, 0, MIP_SHAPE(0, 9, 0),
          program_comp_orientation_matrix, NULL);

static const uint8_t program_comp_quaternion[] = {
    MIP_32_BITS(4, MIP_AT(struct mip_sensor_comp_quaternion, q)),
    MIP_END,
};

MIP_CODEC(mip_sensor_comp_quaternion, 0x80, 0x0A, MIP_DATA, 16, 0, MIP_SHAPE(0, 4, 0),
          program_comp_quaternion, NULL);

static const uint8_t program_comp_orientation_update_matrix[] = {
    MIP_32_BITS(9, MIP_AT(struct mip_sensor_comp_orientation_update_matrix, m)),
    MIP_END,
};

MIP_CODEC(mip_sensor_comp_orientation_update_matrix, 0x80, 0x0B, MIP_DATA, 36, 0,
          MIP_SHAPE(0, 9, 0), program_comp_orientation_update_matrix, NULL);

static const uint8_t program_comp_euler_angles[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_comp_euler_angles, roll)),
    MIP_END,
};

MIP_CODEC(mip_sensor_comp_euler_angles, 0x80, 0x0C, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_comp_euler_angles, NULL);

static const uint8_t program_orientation_raw_temperature[] = {
    MIP_16_BITS(4, MIP_AT(struct mip_sensor_orientation_raw_temperature, raw_temperature)),
    MIP_END,
};

MIP_CODEC(mip_sensor_orientation_raw_temperature, 0x80, 0x0D, MIP_DATA, 8, 0, MIP_SHAPE(0, 0, 4),
          program_orientation_raw_temperature, NULL);

static const uint8_t program_internal_timestamp[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_sensor_internal_timestamp, counts)),
    MIP_END,
};

MIP_CODEC(mip_sensor_internal_timestamp, 0x80, 0x0E, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0),
          program_internal_timestamp, NULL);

static const uint8_t program_pps_timestamp[] = {
    MIP_SIZES(0, 8),
    MIP_32_BITS(2, MIP_AT(struct mip_sensor_pps_timestamp, seconds)),
    MIP_END,
};

MIP_CODEC(mip_sensor_pps_timestamp, 0x80, 0x0F, MIP_DATA, 0, 0, 0, program_pps_timestamp,
          &mip_layout);

static const uint8_t program_pps_timestamp_with_flags[] = {
    MIP_SIZES(9, 253),
    MIP_8_BITS(1, MIP_AT(struct mip_sensor_pps_timestamp_with_flags, flags)),
    MIP_32_BITS(2, MIP_AT(struct mip_sensor_pps_timestamp_with_flags, seconds)),
    MIP_END,
};

MIP_CODEC(mip_sensor_pps_timestamp_with_flags, 0x80, 0x0F, MIP_DATA, 0, 0, 0,
          program_pps_timestamp_with_flags, &mip_layout);

static const uint8_t program_north_vector[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_north_vector, stabilized_mag)),
    MIP_END,
};

MIP_CODEC(mip_sensor_north_vector, 0x80, 0x10, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_north_vector, NULL);

static const uint8_t program_up_vector[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_up_vector, stabilized_accel)),
    MIP_END,
};

MIP_CODEC(mip_sensor_up_vector, 0x80, 0x11, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0), program_up_vector,
          NULL);

static const uint8_t program_gps_timestamp[] = {
    MIP_DOUBLES(1, MIP_AT(struct mip_sensor_gps_timestamp, tow)),
    MIP_16_BITS(2, MIP_AT(struct mip_sensor_gps_timestamp, week_number)),
    MIP_END,
};

MIP_CODEC(mip_sensor_gps_timestamp, 0x80, 0x12, MIP_DATA, 12, 0, MIP_SHAPE(1, 0, 2),
          program_gps_timestamp, NULL);

static const uint8_t program_temperature_statistics[] = {
    MIP_32_BITS(3, MIP_AT(struct mip_sensor_temperature_statistics, min_temperature)),
    MIP_END,
};

MIP_CODEC(mip_sensor_temperature_statistics, 0x80, 0x14, MIP_DATA, 12, 0, MIP_SHAPE(0, 3, 0),
          program_temperature_statistics, NULL);

static const uint8_t program_raw_pressure[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_sensor_raw_pressure, raw_pressure)),
    MIP_END,
};

MIP_CODEC(mip_sensor_raw_pressure, 0x80, 0x16, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0),
          program_raw_pressure, NULL);

static const uint8_t program_scaled_pressure[] = {
    MIP_32_BITS(1, MIP_AT(struct mip_sensor_scaled_pressure, scaled_pressure)),
    MIP_END,
};

MIP_CODEC(mip_sensor_scaled_pressure, 0x80, 0x17, MIP_DATA, 4, 0, MIP_SHAPE(0, 1, 0),
          program_scaled_pressure, NULL);

static const uint8_t program_overrange_status[] = {
    MIP_16_BITS(1, MIP_AT(struct mip_sensor_overrange_status, status)),
    MIP_END,
};

MIP_CODEC(mip_sensor_overrange_status, 0x80, 0x18, MIP_DATA, 2, 0, MIP_SHAPE(0, 0, 1),
          program_overrange_status, NULL);

static const uint8_t program_odometer[] = {
    MIP_32_BITS(2, MIP_AT(struct mip_sensor_odometer, speed)),
    MIP_16_BITS(1, MIP_AT(struct mip_sensor_odometer, valid_flags)),
    MIP_END,
};

MIP_CODEC(mip_sensor_odometer, 0x80, 0x40, MIP_DATA, 10, 0, MIP_SHAPE(0, 2, 1), program_odometer,
          NULL);
