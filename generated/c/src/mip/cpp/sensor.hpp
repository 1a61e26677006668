/**
 * @file
 * Sensor data, in C++17: see mip/sensor.h.
 */
#ifndef MIP_SENSOR_HPP
#define MIP_SENSOR_HPP

#include "mip/sensor_inline.h"
#include "mip/cpp/types.hpp"

namespace mip {

MIP_LAYOUT(mip_sensor_raw_accel, MIP_SENSOR_RAW_ACCEL, MIP_SENSOR_RAW_ACCEL, "sensor.raw_accel",
           decode_inline)
MIP_LAYOUT(mip_sensor_raw_gyro, MIP_SENSOR_RAW_GYRO, MIP_SENSOR_RAW_GYRO, "sensor.raw_gyro",
           decode_inline)
MIP_LAYOUT(mip_sensor_raw_mag, MIP_SENSOR_RAW_MAG, MIP_SENSOR_RAW_MAG, "sensor.raw_mag",
           decode_inline)
MIP_LAYOUT(mip_sensor_scaled_accel, MIP_SENSOR_SCALED_ACCEL, MIP_SENSOR_SCALED_ACCEL,
           "sensor.scaled_accel", decode_inline)
MIP_LAYOUT(mip_sensor_scaled_gyro, MIP_SENSOR_SCALED_GYRO, MIP_SENSOR_SCALED_GYRO,
           "sensor.scaled_gyro", decode_inline)
MIP_LAYOUT(mip_sensor_scaled_mag, MIP_SENSOR_SCALED_MAG, MIP_SENSOR_SCALED_MAG, "sensor.scaled_mag",
           decode_inline)
MIP_LAYOUT(mip_sensor_delta_theta, MIP_SENSOR_DELTA_THETA, MIP_SENSOR_DELTA_THETA,
           "sensor.delta_theta", decode_inline)
MIP_LAYOUT(mip_sensor_delta_velocity, MIP_SENSOR_DELTA_VELOCITY, MIP_SENSOR_DELTA_VELOCITY,
           "sensor.delta_velocity", decode_inline)
MIP_LAYOUT(mip_sensor_comp_orientation_matrix, MIP_SENSOR_COMP_ORIENTATION_MATRIX,
           MIP_SENSOR_COMP_ORIENTATION_MATRIX, "sensor.comp_orientation_matrix", decode_inline)
MIP_LAYOUT(mip_sensor_comp_quaternion, MIP_SENSOR_COMP_QUATERNION, MIP_SENSOR_COMP_QUATERNION,
           "sensor.comp_quaternion", decode_inline)
MIP_LAYOUT(mip_sensor_comp_orientation_update_matrix, MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX,
           MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX, "sensor.comp_orientation_update_matrix",
           decode_inline)
MIP_LAYOUT(mip_sensor_comp_euler_angles, MIP_SENSOR_COMP_EULER_ANGLES, MIP_SENSOR_COMP_EULER_ANGLES,
           "sensor.comp_euler_angles", decode_inline)
MIP_LAYOUT(mip_sensor_orientation_raw_temperature, MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE,
           MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE, "sensor.orientation_raw_temperature",
           decode_inline)
MIP_LAYOUT(mip_sensor_internal_timestamp, MIP_SENSOR_INTERNAL_TIMESTAMP,
           MIP_SENSOR_INTERNAL_TIMESTAMP, "sensor.internal_timestamp", decode_inline)
MIP_LAYOUT(mip_sensor_pps_timestamp, MIP_SENSOR_PPS_TIMESTAMP, MIP_SENSOR_PPS_TIMESTAMP,
           "sensor.pps_timestamp", decode_inline)
MIP_LAYOUT(mip_sensor_pps_timestamp_with_flags, MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS,
           MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS, "sensor.pps_timestamp_with_flags", decode_inline)
MIP_LAYOUT(mip_sensor_north_vector, MIP_SENSOR_NORTH_VECTOR, MIP_SENSOR_NORTH_VECTOR,
           "sensor.north_vector", decode_inline)
MIP_LAYOUT(mip_sensor_up_vector, MIP_SENSOR_UP_VECTOR, MIP_SENSOR_UP_VECTOR, "sensor.up_vector",
           decode_inline)
MIP_LAYOUT(mip_sensor_gps_timestamp, MIP_SENSOR_GPS_TIMESTAMP, MIP_SENSOR_GPS_TIMESTAMP,
           "sensor.gps_timestamp", decode_inline)
MIP_LAYOUT(mip_sensor_temperature_statistics, MIP_SENSOR_TEMPERATURE_STATISTICS,
           MIP_SENSOR_TEMPERATURE_STATISTICS, "sensor.temperature_statistics", decode_inline)
MIP_LAYOUT(mip_sensor_raw_pressure, MIP_SENSOR_RAW_PRESSURE, MIP_SENSOR_RAW_PRESSURE,
           "sensor.raw_pressure", decode_inline)
MIP_LAYOUT(mip_sensor_scaled_pressure, MIP_SENSOR_SCALED_PRESSURE, MIP_SENSOR_SCALED_PRESSURE,
           "sensor.scaled_pressure", decode_inline)
MIP_LAYOUT(mip_sensor_overrange_status, MIP_SENSOR_OVERRANGE_STATUS, MIP_SENSOR_OVERRANGE_STATUS,
           "sensor.overrange_status", decode_inline)
MIP_LAYOUT(mip_sensor_odometer, MIP_SENSOR_ODOMETER, MIP_SENSOR_ODOMETER, "sensor.odometer",
           decode_inline)

/** Sensor data */
inline constexpr std::uint8_t sensor_set = MIP_SENSOR_SET;

namespace sensor {

/** @addtogroup mip_sensor
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

/** mip_sensor_overrange_flags: sensor.overrange_flags */
enum class overrange_flags : uint16_t {
    accel_x = MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_X,
    accel_y = MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Y,
    accel_z = MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Z,
    gyro_x = MIP_SENSOR_OVERRANGE_FLAGS_GYRO_X,
    gyro_y = MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Y,
    gyro_z = MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Z,
    mag_x = MIP_SENSOR_OVERRANGE_FLAGS_MAG_X,
    mag_y = MIP_SENSOR_OVERRANGE_FLAGS_MAG_Y,
    mag_z = MIP_SENSOR_OVERRANGE_FLAGS_MAG_Z,
    pressure = MIP_SENSOR_OVERRANGE_FLAGS_PRESSURE,
};
MIP_NAMES_OF(flag_names, overrange_flags, mip_names_sensor_overrange_flags)

/** mip_sensor_odometer_flags: sensor.odometer_flags */
enum class odometer_flags : uint16_t {
    odometer = MIP_SENSOR_ODOMETER_FLAGS_ODOMETER,
};
MIP_NAMES_OF(flag_names, odometer_flags, mip_names_sensor_odometer_flags)

/** Raw accel. See struct mip_sensor_raw_accel. */
using raw_accel = ::mip_sensor_raw_accel;

/** Raw gyro. See struct mip_sensor_raw_gyro. */
using raw_gyro = ::mip_sensor_raw_gyro;

/** Raw mag. See struct mip_sensor_raw_mag. */
using raw_mag = ::mip_sensor_raw_mag;

/** Scaled accel. See struct mip_sensor_scaled_accel. */
using scaled_accel = ::mip_sensor_scaled_accel;

/** Scaled gyro. See struct mip_sensor_scaled_gyro. */
using scaled_gyro = ::mip_sensor_scaled_gyro;

/** Scaled mag. See struct mip_sensor_scaled_mag. */
using scaled_mag = ::mip_sensor_scaled_mag;

/** Delta theta. See struct mip_sensor_delta_theta. */
using delta_theta = ::mip_sensor_delta_theta;

/** Delta velocity. See struct mip_sensor_delta_velocity. */
using delta_velocity = ::mip_sensor_delta_velocity;

/** Complementary filter orientation matrix. See struct mip_sensor_comp_orientation_matrix. */
using comp_orientation_matrix = ::mip_sensor_comp_orientation_matrix;

/** Complementary filter quaternion. See struct mip_sensor_comp_quaternion. */
using comp_quaternion = ::mip_sensor_comp_quaternion;

/**
 * Complementary filter orientation update matrix. See struct
 * mip_sensor_comp_orientation_update_matrix.
 */
using comp_orientation_update_matrix = ::mip_sensor_comp_orientation_update_matrix;

/** Complementary filter Euler angles. See struct mip_sensor_comp_euler_angles. */
using comp_euler_angles = ::mip_sensor_comp_euler_angles;

/** Orientation raw temperatures. See struct mip_sensor_orientation_raw_temperature. */
using orientation_raw_temperature = ::mip_sensor_orientation_raw_temperature;

/** Internal timestamp. See struct mip_sensor_internal_timestamp. */
using internal_timestamp = ::mip_sensor_internal_timestamp;

/** PPS timestamp. See struct mip_sensor_pps_timestamp. */
using pps_timestamp = ::mip_sensor_pps_timestamp;

/** PPS timestamp with flags. See struct mip_sensor_pps_timestamp_with_flags. */
using pps_timestamp_with_flags = ::mip_sensor_pps_timestamp_with_flags;

/** Complementary filter stabilized north vector. See struct mip_sensor_north_vector. */
using north_vector = ::mip_sensor_north_vector;

/** Complementary filter stabilized up vector. See struct mip_sensor_up_vector. */
using up_vector = ::mip_sensor_up_vector;

struct gps_timestamp_ : ::mip_sensor_gps_timestamp {
    using c_type = ::mip_sensor_gps_timestamp;
    ::mip::sensor_gps_timestamp_flags valid_flags() const {
        return static_cast<::mip::sensor_gps_timestamp_flags>(c_type::valid_flags);
    }
};

/** GPS timestamp. See struct mip_sensor_gps_timestamp. */
using gps_timestamp = gps_timestamp_;

/** Temperature statistics. See struct mip_sensor_temperature_statistics. */
using temperature_statistics = ::mip_sensor_temperature_statistics;

/** Raw pressure. See struct mip_sensor_raw_pressure. */
using raw_pressure = ::mip_sensor_raw_pressure;

/** Scaled pressure. See struct mip_sensor_scaled_pressure. */
using scaled_pressure = ::mip_sensor_scaled_pressure;

struct overrange_status_ : ::mip_sensor_overrange_status {
    using c_type = ::mip_sensor_overrange_status;
    ::mip::sensor::overrange_flags status() const {
        return static_cast<::mip::sensor::overrange_flags>(c_type::status);
    }
};

/** Overrange status. See struct mip_sensor_overrange_status. */
using overrange_status = overrange_status_;

struct odometer_ : ::mip_sensor_odometer {
    using c_type = ::mip_sensor_odometer;
    ::mip::sensor::odometer_flags valid_flags() const {
        return static_cast<::mip::sensor::odometer_flags>(c_type::valid_flags);
    }
};

/** Odometer data. See struct mip_sensor_odometer. */
using odometer = odometer_;

/** @} */

} // namespace sensor

} // namespace mip

#endif
