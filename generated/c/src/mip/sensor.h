/**
 * @file
 *
 * Sensor data (0x80). Inertial, magnetic and pressure measurements, and the attitude of the
 * complementary filter.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_SENSOR_H
#define MIP_SENSOR_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/sensor.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_sensor Sensor data (0x80)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_SENSOR_SET 0x80

/** Sensor axes that were near or outside their range. */
typedef uint16_t mip_sensor_overrange_flags;
/**
 * Bit 0. The accelerometer x axis is near or outside its range. Affects mip_sensor_scaled_accel.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_X 0x0001U
/**
 * Bit 1. The accelerometer y axis is near or outside its range. Affects mip_sensor_scaled_accel.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Y 0x0002U
/**
 * Bit 2. The accelerometer z axis is near or outside its range. Affects mip_sensor_scaled_accel.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Z 0x0004U
/** Bit 4. The gyroscope x axis is near or outside its range. Affects mip_sensor_scaled_gyro. */
#define MIP_SENSOR_OVERRANGE_FLAGS_GYRO_X 0x0010U
/** Bit 5. The gyroscope y axis is near or outside its range. Affects mip_sensor_scaled_gyro. */
#define MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Y 0x0020U
/** Bit 6. The gyroscope z axis is near or outside its range. Affects mip_sensor_scaled_gyro. */
#define MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Z 0x0040U
/**
 * Bit 8. The magnetometer x axis is near or outside its range. Affects mip_sensor_scaled_mag.
 * Requires a magnetometer.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_MAG_X 0x0100U
/**
 * Bit 9. The magnetometer y axis is near or outside its range. Affects mip_sensor_scaled_mag.
 * Requires a magnetometer.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_MAG_Y 0x0200U
/**
 * Bit 10. The magnetometer z axis is near or outside its range. Affects mip_sensor_scaled_mag.
 * Requires a magnetometer.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_MAG_Z 0x0400U
/**
 * Bit 12. The pressure sensor is near or outside its range. Affects mip_sensor_scaled_pressure.
 * Requires a pressure sensor.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_PRESSURE 0x1000U

/** Validity of the odometer values. */
typedef uint16_t mip_sensor_odometer_flags;
/** Bit 0. Set if an odometer is configured; its values are then valid. */
#define MIP_SENSOR_ODOMETER_FLAGS_ODOMETER 0x0001U

/**
 * Raw accel: data (0x80,0x01).
 *
 * Raw acceleration in sensor counts, temperature compensated.
 *
 * Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw accel (0x80,0x01)
 * - mip-sdk-2014: Raw accel (0x80,0x01)
 */
struct mip_sensor_raw_accel {
    /** Acceleration in counts. Elements: x, y, z. Unit: 1. Frame: sensor. */
    float raw_accel[3];
};

#define MIP_SENSOR_RAW_ACCEL 0x8001
#define MIP_SENSOR_RAW_ACCEL_DESCRIPTOR 0x01
MIP_FIELD(mip_sensor_raw_accel, 0x01);

/**
 * Raw gyro: data (0x80,0x02).
 *
 * Raw angular rate in sensor counts, temperature compensated.
 *
 * Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw gyro (0x80,0x02)
 * - mip-sdk-2014: Raw gyro (0x80,0x02)
 */
struct mip_sensor_raw_gyro {
    /** Angular rate in counts. Elements: x, y, z. Unit: 1. Frame: sensor. */
    float raw_gyro[3];
};

#define MIP_SENSOR_RAW_GYRO 0x8002
#define MIP_SENSOR_RAW_GYRO_DESCRIPTOR 0x02
MIP_FIELD(mip_sensor_raw_gyro, 0x02);

/**
 * Raw mag: data (0x80,0x03).
 *
 * Raw magnetic field in sensor counts, temperature compensated.
 *
 * Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Requires a magnetometer.
 *
 * - mip-sdk-4: Raw mag (0x80,0x03)
 * - mip-sdk-2014: Raw mag (0x80,0x03)
 */
struct mip_sensor_raw_mag {
    /**
     * Magnetic field in counts. Elements: x, y, z. Unit: 1. Frame: vehicle. Uncertain: The frame is
     * doubtful: the SDK has the vehicle frame here, but the sensor frame for raw acceleration and
     * raw angular rate.
     */
    float raw_mag[3];
};

#define MIP_SENSOR_RAW_MAG 0x8003
#define MIP_SENSOR_RAW_MAG_DESCRIPTOR 0x03
MIP_FIELD(mip_sensor_raw_mag, 0x03);

/**
 * Scaled accel: data (0x80,0x04).
 *
 * Specific force, temperature compensated: about -1 g on z when level and at rest.
 *
 * At rest, it is the opposite of the gravity vector.
 *
 * - 3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04)
 * - 3dm-cv7-gnss-ins: Scaled Accel (0x80,0x04)
 */
struct mip_sensor_scaled_accel {
    /**
     * Specific force: acceleration minus gravity. Elements: x, y, z. Unit: g. Frame: vehicle. At
     * rest and level: x 0, y 0, z -1.
     */
    float scaled_accel[3];
};

#define MIP_SENSOR_SCALED_ACCEL 0x8004
#define MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR 0x04
MIP_FIELD(mip_sensor_scaled_accel, 0x04);

/**
 * Scaled gyro: data (0x80,0x05).
 *
 * Measured angular rate, temperature compensated.
 *
 * - 3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05)
 * - 3dm-cv7-gnss-ins: Scaled Gyro (0x80,0x05)
 */
struct mip_sensor_scaled_gyro {
    /**
     * Angular rate about each axis. Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and
     * level: x 0, y 0, z 0. Positive: right side down, nose up, clockwise seen from above.
     */
    float scaled_gyro[3];
};

#define MIP_SENSOR_SCALED_GYRO 0x8005
#define MIP_SENSOR_SCALED_GYRO_DESCRIPTOR 0x05
MIP_FIELD(mip_sensor_scaled_gyro, 0x05);

/**
 * Scaled mag: data (0x80,0x06).
 *
 * Measured magnetic field, temperature compensated.
 *
 * Requires a magnetometer.
 *
 * - 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)
 */
struct mip_sensor_scaled_mag {
    /** Magnetic field. Elements: x, y, z. Unit: gauss. Frame: vehicle. */
    float scaled_mag[3];
};

#define MIP_SENSOR_SCALED_MAG 0x8006
#define MIP_SENSOR_SCALED_MAG_DESCRIPTOR 0x06
MIP_FIELD(mip_sensor_scaled_mag, 0x06);

/**
 * Delta theta: data (0x80,0x07).
 *
 * Time integral of the angular rate over the period set by the message format.
 *
 * - 3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07)
 * - 3dm-cv7-gnss-ins: Delta Theta (0x80,0x07)
 */
struct mip_sensor_delta_theta {
    /**
     * Integral of the angular rate. Elements: x, y, z. Unit: rad. Frame: vehicle. At rest and
     * level: x 0, y 0, z 0. Positive: right side down, nose up, clockwise seen from above.
     */
    float delta_theta[3];
};

#define MIP_SENSOR_DELTA_THETA 0x8007
#define MIP_SENSOR_DELTA_THETA_DESCRIPTOR 0x07
MIP_FIELD(mip_sensor_delta_theta, 0x07);

/**
 * Delta velocity: data (0x80,0x08).
 *
 * Time integral of the specific force over the period set by the message format.
 *
 * Multiply by 9.80665 m/s^2 for a change of velocity in metres per second.
 *
 * Divided by the period, z is -1 g on a device that is level and at rest.
 *
 * - 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)
 * - 3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)
 */
struct mip_sensor_delta_velocity {
    /**
     * Integral of the specific force: acceleration minus gravity. Elements: x, y, z. Unit: g*s.
     * Frame: vehicle. At rest and level: x 0, y 0.
     */
    float delta_velocity[3];
};

#define MIP_SENSOR_DELTA_VELOCITY 0x8008
#define MIP_SENSOR_DELTA_VELOCITY_DESCRIPTOR 0x08
MIP_FIELD(mip_sensor_delta_velocity, 0x08);

/**
 * Complementary filter orientation matrix: data (0x80,0x09).
 *
 * Attitude from the complementary filter as a direction cosine matrix, relative to the NED frame.
 *
 * `v_vehicle = m * v_ned`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.
 *
 * - 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)
 * - 3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)
 */
struct mip_sensor_comp_orientation_matrix {
    /**
     * Rotates vectors of the NED frame into the vehicle frame; row-major. Elements: m11, m12, m13,
     * m21, m22, m23, m31, m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0,
     * m32 0, m33 1. On the 3DM-GX5-15: Rotates vectors of the NED frame into the sensor frame;
     * row-major.
     */
    float m[9];
};

#define MIP_SENSOR_COMP_ORIENTATION_MATRIX 0x8009
#define MIP_SENSOR_COMP_ORIENTATION_MATRIX_DESCRIPTOR 0x09
MIP_FIELD(mip_sensor_comp_orientation_matrix, 0x09);

/**
 * Complementary filter quaternion: data (0x80,0x0A).
 *
 * Attitude from the complementary filter as a quaternion, relative to the NED frame.
 *
 * The 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.
 *
 * `v_ned = q * v_vehicle * q^-1`
 *
 * - 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)
 * - 3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)
 */
struct mip_sensor_comp_quaternion {
    /**
     * Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first.
     * Elements: w, x, y, z. Unit: 1. Frame: ned. At rest and level: x 0, y 0. On the 3DM-GX5-15:
     * Rotates vectors of the sensor frame into the NED frame; Hamilton quaternion, w first.
     */
    float q[4];
};

#define MIP_SENSOR_COMP_QUATERNION 0x800A
#define MIP_SENSOR_COMP_QUATERNION_DESCRIPTOR 0x0A
MIP_FIELD(mip_sensor_comp_quaternion, 0x0A);

/**
 * Complementary filter orientation update matrix: data (0x80,0x0B).
 *
 * Change in the complementary filter's attitude, as a matrix.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Known only from the MIP SDK
 * of 2014 and MicroStrain MIP SDK. Uncertain: No source states the interval of the change and the
 * frames; the SDKs state only the name and the layout.
 *
 * - mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B)
 * - mip-sdk-2014: Orientation Update Matrix (0x80,0x0B)
 */
struct mip_sensor_comp_orientation_update_matrix {
    /**
     * Matrix in row-major order. Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1.
     */
    float m[9];
};

#define MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX 0x800B
#define MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX_DESCRIPTOR 0x0B
MIP_FIELD(mip_sensor_comp_orientation_update_matrix, 0x0B);

/**
 * Complementary filter Euler angles: data (0x80,0x0C).
 *
 * Attitude from the complementary filter as Euler angles, relative to the NED frame.
 *
 * Uncertain: The ranges of the angles are inferred; no source states them.
 *
 * - 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)
 * - 3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)
 */
struct mip_sensor_comp_euler_angles {
    /**
     * Roll angle, applied after yaw and pitch (order 3-2-1). Unit: rad. Frame: ned. Range: -pi to
     * pi. At rest and level: 0. Positive: right side down.
     */
    float roll;
    /**
     * Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest
     * and level: 0. Positive: nose up.
     */
    float pitch;
    /** Yaw angle. Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above. */
    float yaw;
};

#define MIP_SENSOR_COMP_EULER_ANGLES 0x800C
#define MIP_SENSOR_COMP_EULER_ANGLES_DESCRIPTOR 0x0C
MIP_FIELD(mip_sensor_comp_euler_angles, 0x0C);

/**
 * Orientation raw temperatures: data (0x80,0x0D).
 *
 * Raw readings of four temperature sensors.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Also called
 * `orientation_raw_temp`. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * The first sensor belongs to the magnetometer, the second to gyroscope 3 and accelerometer 3, the
 * third to gyroscope 2 and accelerometers 1 and 2, the fourth to gyroscope 1.
 *
 * - mip-sdk-4: Orientation Raw Temp (0x80,0x0D)
 * - mip-sdk-2014: Raw Temperature (0x80,0x0D)
 */
struct mip_sensor_orientation_raw_temperature {
    /**
     * Temperatures in counts. Unit: 1. Uncertain: No source states the scale, or the axes of the
     * numbers 1 to 3.
     */
    uint16_t raw_temperature[4];
};

#define MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE 0x800D
#define MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE_DESCRIPTOR 0x0D
MIP_FIELD(mip_sensor_orientation_raw_temperature, 0x0D);

/**
 * Internal timestamp: data (0x80,0x0E).
 *
 * Free-running counter of the device.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Known only from the MIP SDK
 * of 2014 and MicroStrain MIP SDK. Uncertain: No source lists the devices that send it; the SDK of
 * 2014 is for devices of the 3-series and 4-series.
 *
 * - mip-sdk-4: Internal timestamp (0x80,0x0E)
 * - mip-sdk-2014: Internal timestamp (0x80,0x0E)
 */
struct mip_sensor_internal_timestamp {
    /** Counter: 62 500 counts per second, 16 us each. Unit: 1. */
    uint32_t counts;
};

#define MIP_SENSOR_INTERNAL_TIMESTAMP 0x800E
#define MIP_SENSOR_INTERNAL_TIMESTAMP_DESCRIPTOR 0x0E
MIP_FIELD(mip_sensor_internal_timestamp, 0x0E);

/**
 * PPS timestamp: data (0x80,0x0F).
 *
 * Time counted by the pulse per second.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. The size of its data
 * distinguishes it from mip_sensor_pps_timestamp_with_flags. Known only from the MicroStrain MIP
 * SDK. Uncertain: Possibly no device sends it; mip_sensor_pps_timestamp_with_flags has more
 * sources. Uncertain: No source states the epoch.
 *
 * The sources contradict each other. Only the SDK has this layout.
 *
 * - mip-sdk-4: PPS timestamp (0x80,0x0F)
 */
struct mip_sensor_pps_timestamp {
    /** Whole seconds. Unit: s. Uncertain: The unit is inferred from the name. */
    uint32_t seconds;
    /** Fraction of the second. Unit: us. Uncertain: The unit is inferred from the name. */
    uint32_t useconds;
};

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_SENSOR_PPS_TIMESTAMP 0x800F
#define MIP_SENSOR_PPS_TIMESTAMP_DESCRIPTOR 0x0F
MIP_FIELD(mip_sensor_pps_timestamp, 0x0F);

/**
 * PPS timestamp with flags: data (0x80,0x0F).
 *
 * Time counted by the pulse per second, with its state and nanoseconds.
 *
 * Deprecated: the SDK marks the descriptor as deprecated and names no replacement. The size of its
 * data distinguishes it from mip_sensor_pps_timestamp. Known only from the MIP SDK of 2014 and
 * MicroStrain Communication Library. Uncertain: No source lists the devices that send it; the SDK
 * of 2014 dates from the time of the 3DM-GX3. Uncertain: No source states the epoch.
 *
 * The sources disagree on the layout; this one is from MSCL and the SDK of 2014.
 *
 * - mscl: 1PPS Timestamp (0x80,0x0F)
 * - mip-sdk-2014: 1PPS Timestamp (0x80,0x0F)
 */
struct mip_sensor_pps_timestamp_with_flags {
    /** State of the time. Uncertain: No source states the meaning of the bits. */
    uint8_t flags;
    /** Whole seconds. Unit: s. */
    uint32_t seconds;
    /** Fraction of the second. Unit: ns. */
    uint32_t nanoseconds;
};

/** Other layouts share this descriptor: _decode rejects those with MIP_ERROR_LAYOUT. */
#define MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS 0x800F
#define MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS_DESCRIPTOR 0x0F
MIP_FIELD(mip_sensor_pps_timestamp_with_flags, 0x0F);

/**
 * Complementary filter stabilized north vector: data (0x80,0x10).
 *
 * Estimate of the geomagnetic field by the complementary filter, free of short disturbances.
 *
 * Without magnetic disturbance it equals the measured magnetic field, unless a sensor-to-vehicle
 * transformation moves the latter out of the sensor frame.
 *
 * A lasting disturbance is not compensated.
 *
 * - 3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10)
 */
struct mip_sensor_north_vector {
    /**
     * Geomagnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor. Uncertain: The frame is
     * doubtful: the SDK has the vehicle frame, but the lists of what the sensor-to-vehicle
     * transformation changes lack this vector.
     */
    float stabilized_mag[3];
};

#define MIP_SENSOR_NORTH_VECTOR 0x8010
#define MIP_SENSOR_NORTH_VECTOR_DESCRIPTOR 0x10
MIP_FIELD(mip_sensor_north_vector, 0x10);

/**
 * Complementary filter stabilized up vector: data (0x80,0x11).
 *
 * Estimate of the vertical (up) by the complementary filter, free of linear acceleration.
 *
 * At rest it equals the measured acceleration, unless a sensor-to-vehicle transformation moves the
 * latter out of the sensor frame.
 *
 * - 3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11)
 * - mip-sdk-4: Complementary filter stabilized up vector (0x80,0x11)
 */
struct mip_sensor_up_vector {
    /**
     * Opposite of the gravity vector, as the accelerometers measure it. Elements: x, y, z. Unit: g.
     * Frame: sensor. At rest and level: x 0, y 0, z -1. Uncertain: The frame is doubtful: the SDK
     * has the vehicle frame, but the lists of what the sensor-to-vehicle transformation changes
     * lack this vector.
     */
    float stabilized_accel[3];
};

#define MIP_SENSOR_UP_VECTOR 0x8011
#define MIP_SENSOR_UP_VECTOR_DESCRIPTOR 0x11
MIP_FIELD(mip_sensor_up_vector, 0x11);

/**
 * GPS timestamp: data (0x80,0x12).
 *
 * GPS time of the sensor data.
 *
 * Without a PPS the time runs on the internal clock and jumps when the PPS returns.
 *
 * The fraction of the time of week is the time since the last pulse.
 *
 * Without external synchronization it is the internal system time.
 *
 * Where the device has it, use mip_shared_gps_timestamp instead; this field may be deprecated.
 *
 * - 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
 * - 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
 */
struct mip_sensor_gps_timestamp {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TOW_VALID in valid_flags is set. On the 3DM-CV5-10,
     * 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45,
     * 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45,
     * 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR, 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and
     * 3DM-RQ1-IMU: valid if MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED in valid_flags is
     * set (inferred: the 3DM-GX5-15 has it). On the 3DM-GX5-15 and 3DM-GX5-35: valid if
     * MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_SENSOR_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER_VALID in
     * valid_flags is set. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15,
     * 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45,
     * 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR,
     * 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: valid if
     * MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED in valid_flags is set (inferred: the
     * 3DM-GX5-15 has it). On the 3DM-GX5-15 and 3DM-GX5-35: valid if
     * MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * State of the time. On the 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-10, 3DM-CX5-15,
     * 3DM-CX5-25, 3DM-CX5-45, 3DM-DH3, 3DM-GQ4-45, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45,
     * 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX4-IMU, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR,
     * 3DM-RQ1-45-LT, 3DM-RQ1-45-ST and 3DM-RQ1-IMU: values of mip_gx5_sensor_gps_timestamp_flags
     * (inferred: the 3DM-GX5-15 has it). On the 3DM-GX5-15 and 3DM-GX5-35: values of
     * mip_gx5_sensor_gps_timestamp_flags.
     */
    mip_sensor_gps_timestamp_flags valid_flags;
};

#define MIP_SENSOR_GPS_TIMESTAMP 0x8012
#define MIP_SENSOR_GPS_TIMESTAMP_DESCRIPTOR 0x12
MIP_FIELD(mip_sensor_gps_timestamp, 0x12);

/**
 * Temperature statistics: data (0x80,0x14).
 *
 * Temperatures since the last power-on or reset.
 *
 * Also called `temperature_abs`.
 *
 * The values come from the inertial sensors, alone or together with sensors on the board.
 *
 * - 3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14)
 */
struct mip_sensor_temperature_statistics {
    /** Lowest temperature. Unit: degC. */
    float min_temperature;
    /** Highest temperature. Unit: degC. */
    float max_temperature;
    /** Mean of the temperatures inside the device. Unit: degC. */
    float mean_temperature;
};

#define MIP_SENSOR_TEMPERATURE_STATISTICS 0x8014
#define MIP_SENSOR_TEMPERATURE_STATISTICS_DESCRIPTOR 0x14
MIP_FIELD(mip_sensor_temperature_statistics, 0x14);

/**
 * Raw pressure: data (0x80,0x16).
 *
 * Raw ambient pressure in sensor counts, temperature compensated.
 *
 * Known only from the MicroStrain MIP SDK. Requires a pressure sensor.
 *
 * - mip-sdk-4: Raw pressure (0x80,0x16)
 */
struct mip_sensor_raw_pressure {
    /** Pressure in counts. Unit: 1. */
    float raw_pressure;
};

#define MIP_SENSOR_RAW_PRESSURE 0x8016
#define MIP_SENSOR_RAW_PRESSURE_DESCRIPTOR 0x16
MIP_FIELD(mip_sensor_raw_pressure, 0x16);

/**
 * Scaled pressure: data (0x80,0x17).
 *
 * Measured ambient pressure, temperature compensated.
 *
 * Requires a pressure sensor.
 *
 * - 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)
 * - 3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)
 */
struct mip_sensor_scaled_pressure {
    /** Ambient pressure. Unit: mbar. Range: at least 0. */
    float scaled_pressure;
};

#define MIP_SENSOR_SCALED_PRESSURE 0x8017
#define MIP_SENSOR_SCALED_PRESSURE_DESCRIPTOR 0x17
MIP_FIELD(mip_sensor_scaled_pressure, 0x17);

/**
 * Overrange status: data (0x80,0x18).
 *
 * Sensor axes that are near or outside their range.
 *
 * - 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)
 */
struct mip_sensor_overrange_status {
    /**
     * One bit for each axis. On the 3DM-CV7-AR, 3DM-CX7-AR and 3DM-GV7-AR: only
     * MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_X, MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Y,
     * MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Z, MIP_SENSOR_OVERRANGE_FLAGS_GYRO_X,
     * MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Y, MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Z and
     * MIP_SENSOR_OVERRANGE_FLAGS_PRESSURE.
     */
    mip_sensor_overrange_flags status;
};

#define MIP_SENSOR_OVERRANGE_STATUS 0x8018
#define MIP_SENSOR_OVERRANGE_STATUS_DESCRIPTOR 0x18
MIP_FIELD(mip_sensor_overrange_status, 0x18);

/**
 * Odometer data: data (0x80,0x40).
 *
 * Speed measured by the wheel encoder.
 *
 * Also called `odometer_data`.
 *
 * - 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)
 */
struct mip_sensor_odometer {
    /**
     * Average speed over the interval; negative values come from quadrature encoders only. Unit:
     * m/s. Frame: vehicle. Positive: forward. Valid if MIP_SENSOR_ODOMETER_FLAGS_ODOMETER in
     * valid_flags is set.
     */
    float speed;
    /**
     * Uncertainty of the speed. Unit: m/s. Range: at least 0. Valid if
     * MIP_SENSOR_ODOMETER_FLAGS_ODOMETER in valid_flags is set.
     */
    float uncertainty;
    /** Validity of the measured values. */
    mip_sensor_odometer_flags valid_flags;
};

#define MIP_SENSOR_ODOMETER 0x8040
#define MIP_SENSOR_ODOMETER_DESCRIPTOR 0x40
MIP_FIELD(mip_sensor_odometer, 0x40);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
