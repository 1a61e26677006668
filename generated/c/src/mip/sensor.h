/**
 * @file
 *
 * Sensor data (0x80). Inertial, magnetic and pressure measurements, and the attitude of the
 * complementary filter.
 *
 * Devices that only probably support a field are listed in mip/profiles.h, not here.
 */
#ifndef MIP_SENSOR_H
#define MIP_SENSOR_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
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
 * Bit 0. The accelerometer x axis is near or outside its range. Concerns mip_sensor_scaled_accel.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_X 0x0001U
/**
 * Bit 1. The accelerometer y axis is near or outside its range. Concerns mip_sensor_scaled_accel.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Y 0x0002U
/**
 * Bit 2. The accelerometer z axis is near or outside its range. Concerns mip_sensor_scaled_accel.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_ACCEL_Z 0x0004U
/** Bit 4. The gyroscope x axis is near or outside its range. Concerns mip_sensor_scaled_gyro. */
#define MIP_SENSOR_OVERRANGE_FLAGS_GYRO_X 0x0010U
/** Bit 5. The gyroscope y axis is near or outside its range. Concerns mip_sensor_scaled_gyro. */
#define MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Y 0x0020U
/** Bit 6. The gyroscope z axis is near or outside its range. Concerns mip_sensor_scaled_gyro. */
#define MIP_SENSOR_OVERRANGE_FLAGS_GYRO_Z 0x0040U
/** Bit 8. The magnetometer x axis is near or outside its range. Concerns mip_sensor_scaled_mag. */
#define MIP_SENSOR_OVERRANGE_FLAGS_MAG_X 0x0100U
/** Bit 9. The magnetometer y axis is near or outside its range. Concerns mip_sensor_scaled_mag. */
#define MIP_SENSOR_OVERRANGE_FLAGS_MAG_Y 0x0200U
/** Bit 10. The magnetometer z axis is near or outside its range. Concerns mip_sensor_scaled_mag. */
#define MIP_SENSOR_OVERRANGE_FLAGS_MAG_Z 0x0400U
/**
 * Bit 12. The pressure sensor is near or outside its range. Concerns mip_sensor_scaled_pressure.
 */
#define MIP_SENSOR_OVERRANGE_FLAGS_PRESSURE 0x1000U

/** Validity of the odometer values. */
typedef uint16_t mip_sensor_odometer_flags;
/** Bit 0. Set if an odometer is configured; its values are then valid. */
#define MIP_SENSOR_ODOMETER_FLAGS_ODOMETER 0x0001U

/**
 * Raw accel: data (0x80,0x01).
 *
 * Raw acceleration in counts of the sensor, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw accel (0x80,0x01)
 * - mip-sdk-2014: Raw accel (0x80,0x01)
 */
struct mip_sensor_raw_accel {
    /** Acceleration in counts. Elements: x, y, z. Unit: 1. Frame: sensor. */
    float raw_accel[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_RAW_ACCEL 0x8001
/** Its descriptor. */
#define MIP_SENSOR_RAW_ACCEL_DESCRIPTOR 0x01
/** Its name in the specification. */
#define MIP_SENSOR_RAW_ACCEL_NAME "sensor.raw_accel"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_raw_accel_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_raw_accel_decode(struct mip_sensor_raw_accel *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_raw_accel_codec, 0x01, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_sensor_raw_accel_encode(const struct mip_sensor_raw_accel *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_raw_accel_codec, value, builder);
}

/**
 * Raw gyro: data (0x80,0x02).
 *
 * Raw angular rate in counts of the sensor, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw gyro (0x80,0x02)
 * - mip-sdk-2014: Raw gyro (0x80,0x02)
 */
struct mip_sensor_raw_gyro {
    /** Angular rate in counts. Elements: x, y, z. Unit: 1. Frame: sensor. */
    float raw_gyro[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_RAW_GYRO 0x8002
/** Its descriptor. */
#define MIP_SENSOR_RAW_GYRO_DESCRIPTOR 0x02
/** Its name in the specification. */
#define MIP_SENSOR_RAW_GYRO_NAME "sensor.raw_gyro"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_raw_gyro_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_raw_gyro_decode(struct mip_sensor_raw_gyro *value,
                                                   const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_raw_gyro_codec, 0x02, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_sensor_raw_gyro_encode(const struct mip_sensor_raw_gyro *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_raw_gyro_codec, value, builder);
}

/**
 * Raw mag: data (0x80,0x03).
 *
 * Raw magnetic field in counts of the sensor, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw mag (0x80,0x03)
 * - mip-sdk-2014: Raw mag (0x80,0x03)
 */
struct mip_sensor_raw_mag {
    /**
     * Magnetic field in counts. Elements: x, y, z. Unit: 1. Frame: vehicle. Uncertain: The frame.
     * The SDK has the vehicle frame here, but the sensor frame for raw acceleration and raw angular
     * rate.
     */
    float raw_mag[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_RAW_MAG 0x8003
/** Its descriptor. */
#define MIP_SENSOR_RAW_MAG_DESCRIPTOR 0x03
/** Its name in the specification. */
#define MIP_SENSOR_RAW_MAG_NAME "sensor.raw_mag"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_raw_mag_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_raw_mag_decode(struct mip_sensor_raw_mag *value,
                                                  const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_raw_mag_codec, 0x03, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_sensor_raw_mag_encode(const struct mip_sensor_raw_mag *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_raw_mag_codec, value, builder);
}

/**
 * Scaled accel: data (0x80,0x04).
 *
 * Specific force, temperature compensated: about -1 g on z when level and at rest.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
 * 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.
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

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_SCALED_ACCEL 0x8004
/** Its descriptor. */
#define MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR 0x04
/** Its name in the specification. */
#define MIP_SENSOR_SCALED_ACCEL_NAME "sensor.scaled_accel"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_scaled_accel_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_scaled_accel_decode(struct mip_sensor_scaled_accel *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_scaled_accel_codec, 0x04, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_scaled_accel_encode(
    const struct mip_sensor_scaled_accel *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_scaled_accel_codec, value, builder);
}

/**
 * Scaled gyro: data (0x80,0x05).
 *
 * Measured angular rate, temperature compensated.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS,
 * 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.
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

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_SCALED_GYRO 0x8005
/** Its descriptor. */
#define MIP_SENSOR_SCALED_GYRO_DESCRIPTOR 0x05
/** Its name in the specification. */
#define MIP_SENSOR_SCALED_GYRO_NAME "sensor.scaled_gyro"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_scaled_gyro_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_scaled_gyro_decode(struct mip_sensor_scaled_gyro *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_scaled_gyro_codec, 0x05, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_scaled_gyro_encode(
    const struct mip_sensor_scaled_gyro *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_scaled_gyro_codec, value, builder);
}

/**
 * Scaled mag: data (0x80,0x06).
 *
 * Measured magnetic field, temperature compensated.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-CX5-45, 3DM-GQ7-GNSS/INS, 3DM-GX5-35
 * and 3DM-GX5-45.
 *
 * - 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)
 */
struct mip_sensor_scaled_mag {
    /** Magnetic field. Elements: x, y, z. Unit: gauss. Frame: vehicle. */
    float scaled_mag[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_SCALED_MAG 0x8006
/** Its descriptor. */
#define MIP_SENSOR_SCALED_MAG_DESCRIPTOR 0x06
/** Its name in the specification. */
#define MIP_SENSOR_SCALED_MAG_NAME "sensor.scaled_mag"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_scaled_mag_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_scaled_mag_decode(struct mip_sensor_scaled_mag *value,
                                                     const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_scaled_mag_codec, 0x06, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_scaled_mag_encode(
    const struct mip_sensor_scaled_mag *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_scaled_mag_codec, value, builder);
}

/**
 * Delta theta: data (0x80,0x07).
 *
 * Time integral of the angular rate over the period set by the message format.
 *
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.
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

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_DELTA_THETA 0x8007
/** Its descriptor. */
#define MIP_SENSOR_DELTA_THETA_DESCRIPTOR 0x07
/** Its name in the specification. */
#define MIP_SENSOR_DELTA_THETA_NAME "sensor.delta_theta"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_delta_theta_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_delta_theta_decode(struct mip_sensor_delta_theta *value,
                                                      const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_delta_theta_codec, 0x07, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_delta_theta_encode(
    const struct mip_sensor_delta_theta *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_delta_theta_codec, value, builder);
}

/**
 * Delta velocity: data (0x80,0x08).
 *
 * Time integral of the acceleration over the period set by the message format.
 *
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15.
 *
 * Multiply by 9.80665 m/s^2 for a change of velocity in metres per second.
 *
 * It includes gravity. Divided by the period, z is -1 g on a device that is level and at rest.
 *
 * - 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)
 * - 3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)
 */
struct mip_sensor_delta_velocity {
    /**
     * Integral of the acceleration. Elements: x, y, z. Unit: g*s. Frame: vehicle. At rest and
     * level: x 0, y 0.
     */
    float delta_velocity[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_DELTA_VELOCITY 0x8008
/** Its descriptor. */
#define MIP_SENSOR_DELTA_VELOCITY_DESCRIPTOR 0x08
/** Its name in the specification. */
#define MIP_SENSOR_DELTA_VELOCITY_NAME "sensor.delta_velocity"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_delta_velocity_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_delta_velocity_decode(struct mip_sensor_delta_velocity *value,
                                                         const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_delta_velocity_codec, 0x08, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_delta_velocity_encode(
    const struct mip_sensor_delta_velocity *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_delta_velocity_codec, value, builder);
}

/**
 * Complementary filter orientation matrix: data (0x80,0x09).
 *
 * Attitude from the complementary filter as a direction cosine matrix, relative to the NED frame.
 *
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
 *
 * `v_vehicle = m * v_ned`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.
 *
 * - 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)
 * - 3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)
 */
struct mip_sensor_comp_orientation_matrix {
    /**
     * Rotation from the NED frame to the vehicle frame. Elements: m11, m12, m13, m21, m22, m23,
     * m31, m32, m33. Unit: 1. Frame: ned. At rest and level: m13 0, m23 0, m31 0, m32 0, m33 1. On
     * the 3DM-GX5-15: Rotation from the NED frame to the sensor frame.
     */
    float m[9];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_COMP_ORIENTATION_MATRIX 0x8009
/** Its descriptor. */
#define MIP_SENSOR_COMP_ORIENTATION_MATRIX_DESCRIPTOR 0x09
/** Its name in the specification. */
#define MIP_SENSOR_COMP_ORIENTATION_MATRIX_NAME "sensor.comp_orientation_matrix"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_comp_orientation_matrix_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_comp_orientation_matrix_decode(
    struct mip_sensor_comp_orientation_matrix *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_comp_orientation_matrix_codec, 0x09, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_comp_orientation_matrix_encode(
    const struct mip_sensor_comp_orientation_matrix *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_comp_orientation_matrix_codec, value, builder);
}

/**
 * Complementary filter quaternion: data (0x80,0x0A).
 *
 * Attitude from the complementary filter as a quaternion, relative to the NED frame.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-15.
 *
 * `v_vehicle = q^-1 * v_ned * q`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle
 * frame.
 *
 * - 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)
 * - 3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)
 */
struct mip_sensor_comp_quaternion {
    /**
     * Rotation between the NED frame and the vehicle frame. Elements: w, x, y, z. Unit: 1. Frame:
     * ned. At rest and level: x 0, y 0. On the 3DM-GX5-15: Rotation between the NED frame and the
     * sensor frame.
     */
    float q[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_COMP_QUATERNION 0x800A
/** Its descriptor. */
#define MIP_SENSOR_COMP_QUATERNION_DESCRIPTOR 0x0A
/** Its name in the specification. */
#define MIP_SENSOR_COMP_QUATERNION_NAME "sensor.comp_quaternion"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_comp_quaternion_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_comp_quaternion_decode(struct mip_sensor_comp_quaternion *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_comp_quaternion_codec, 0x0A, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_comp_quaternion_encode(
    const struct mip_sensor_comp_quaternion *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_comp_quaternion_codec, value, builder);
}

/**
 * Complementary filter orientation update matrix: data (0x80,0x0B).
 *
 * Change in the complementary filter's attitude, as a matrix.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device
 * profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: The interval of
 * the change and the frames. The SDK and the SDK of 2014 state only the name and the layout.
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

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX 0x800B
/** Its descriptor. */
#define MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX_DESCRIPTOR 0x0B
/** Its name in the specification. */
#define MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX_NAME "sensor.comp_orientation_update_matrix"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_comp_orientation_update_matrix_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_comp_orientation_update_matrix_decode(
    struct mip_sensor_comp_orientation_update_matrix *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_comp_orientation_update_matrix_codec, 0x0B, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_comp_orientation_update_matrix_encode(
    const struct mip_sensor_comp_orientation_update_matrix *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_comp_orientation_update_matrix_codec, value, builder);
}

/**
 * Complementary filter Euler angles: data (0x80,0x0C).
 *
 * Attitude from the complementary filter as Euler angles, relative to the NED frame.
 *
 * Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15. Uncertain: The ranges of the angles. Uncertain:
 * which no source states.
 *
 * The rotations are in the order yaw, pitch, roll (3-2-1).
 *
 * - 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)
 * - 3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)
 */
struct mip_sensor_comp_euler_angles {
    /**
     * Roll angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. At rest
     * and level: 0. Positive: right side down.
     */
    float roll;
    /**
     * Pitch angle. Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest
     * and level: 0. Positive: nose up.
     */
    float pitch;
    /**
     * Yaw angle. Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793. Positive:
     * clockwise seen from above.
     */
    float yaw;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_COMP_EULER_ANGLES 0x800C
/** Its descriptor. */
#define MIP_SENSOR_COMP_EULER_ANGLES_DESCRIPTOR 0x0C
/** Its name in the specification. */
#define MIP_SENSOR_COMP_EULER_ANGLES_NAME "sensor.comp_euler_angles"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_comp_euler_angles_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_comp_euler_angles_decode(
    struct mip_sensor_comp_euler_angles *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_comp_euler_angles_codec, 0x0C, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_comp_euler_angles_encode(
    const struct mip_sensor_comp_euler_angles *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_comp_euler_angles_codec, value, builder);
}

/**
 * Orientation raw temperatures: data (0x80,0x0D).
 *
 * Raw readings of four temperature sensors.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Also called
 * `orientation_raw_temp`. Not listed in any device profile. Known only from the MIP SDK of 2014 and
 * MicroStrain MIP SDK.
 *
 * The first sensor belongs to the magnetometer, the second to gyroscope 3 and accelerometer 3, the
 * third to gyroscope 2 and accelerometers 1 and 2, the fourth to gyroscope 1.
 *
 * - mip-sdk-4: Orientation Raw Temp (0x80,0x0D)
 * - mip-sdk-2014: Raw Temperature (0x80,0x0D)
 */
struct mip_sensor_orientation_raw_temperature {
    /**
     * Temperatures in counts. Unit: 1. Uncertain: The scale, and which axes the numbers 1 to 3 are.
     */
    uint16_t raw_temperature[4];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE 0x800D
/** Its descriptor. */
#define MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE_DESCRIPTOR 0x0D
/** Its name in the specification. */
#define MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE_NAME "sensor.orientation_raw_temperature"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_orientation_raw_temperature_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_orientation_raw_temperature_decode(
    struct mip_sensor_orientation_raw_temperature *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_orientation_raw_temperature_codec, 0x0D, value,
                           sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_orientation_raw_temperature_encode(
    const struct mip_sensor_orientation_raw_temperature *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_orientation_raw_temperature_codec, value, builder);
}

/**
 * Internal timestamp: data (0x80,0x0E).
 *
 * Free-running counter of the device.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any device
 * profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: Which devices
 * send it. The SDK of 2014 is for devices of the 3-series and 4-series.
 *
 * - mip-sdk-4: Internal timestamp (0x80,0x0E)
 * - mip-sdk-2014: Internal timestamp (0x80,0x0E)
 */
struct mip_sensor_internal_timestamp {
    /** Counter: 62 500 counts per second, 16 us each. Unit: 1. */
    uint32_t counts;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_INTERNAL_TIMESTAMP 0x800E
/** Its descriptor. */
#define MIP_SENSOR_INTERNAL_TIMESTAMP_DESCRIPTOR 0x0E
/** Its name in the specification. */
#define MIP_SENSOR_INTERNAL_TIMESTAMP_NAME "sensor.internal_timestamp"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_internal_timestamp_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_internal_timestamp_decode(
    struct mip_sensor_internal_timestamp *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_internal_timestamp_codec, 0x0E, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_internal_timestamp_encode(
    const struct mip_sensor_internal_timestamp *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_internal_timestamp_codec, value, builder);
}

/**
 * PPS timestamp: data (0x80,0x0F).
 *
 * Time counted by the pulse per second.
 *
 * Deprecated: the SDK marks it as deprecated and names no replacement. Distinguished from
 * mip_sensor_pps_timestamp_with_flags by the size of its data. Not listed in any device profile.
 * Known only from the MicroStrain MIP SDK. Uncertain: Whether any device sends it.
 * mip_sensor_pps_timestamp_with_flags has more sources. Uncertain: The epoch.
 *
 * The sources contradict each other. Only the SDK has this layout.
 *
 * - mip-sdk-4: PPS timestamp (0x80,0x0F)
 */
struct mip_sensor_pps_timestamp {
    /** Whole seconds. Unit: s. Uncertain: The unit; it follows from the name. */
    uint32_t seconds;
    /** Fraction of the second. Unit: us. Uncertain: The unit; it follows from the name. */
    uint32_t useconds;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_SENSOR_PPS_TIMESTAMP 0x800F
/** Its descriptor. */
#define MIP_SENSOR_PPS_TIMESTAMP_DESCRIPTOR 0x0F
/** Its name in the specification. */
#define MIP_SENSOR_PPS_TIMESTAMP_NAME "sensor.pps_timestamp"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_pps_timestamp_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_pps_timestamp_decode(struct mip_sensor_pps_timestamp *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_pps_timestamp_codec, 0x0F, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_pps_timestamp_encode(
    const struct mip_sensor_pps_timestamp *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_pps_timestamp_codec, value, builder);
}

/**
 * PPS timestamp with flags: data (0x80,0x0F).
 *
 * Time counted by the pulse per second, with its state and nanoseconds.
 *
 * Deprecated: the SDK marks the descriptor as deprecated and names no replacement. Distinguished
 * from mip_sensor_pps_timestamp by the size of its data. Not listed in any device profile. Known
 * only from the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: Which devices
 * send it. The SDK of 2014 dates from the time of the 3DM-GX3 devices. Uncertain: The epoch.
 *
 * The sources disagree on the layout; this one is from MSCL and the SDK of 2014.
 *
 * - mscl: 1PPS Timestamp (0x80,0x0F)
 * - mip-sdk-2014: 1PPS Timestamp (0x80,0x0F)
 */
struct mip_sensor_pps_timestamp_with_flags {
    /** State of the time. Uncertain: The meaning of the bits, which no source states. */
    uint8_t flags;
    /** Whole seconds. Unit: s. */
    uint32_t seconds;
    /** Fraction of the second. Unit: ns. */
    uint32_t nanoseconds;
};

/**
 * Descriptor set and descriptor, as mip_field_key returns them. Other layouts share them: _decode
 * rejects those with MIP_ERROR_LAYOUT.
 */
#define MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS 0x800F
/** Its descriptor. */
#define MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS_DESCRIPTOR 0x0F
/** Its name in the specification. */
#define MIP_SENSOR_PPS_TIMESTAMP_WITH_FLAGS_NAME "sensor.pps_timestamp_with_flags"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_pps_timestamp_with_flags_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_pps_timestamp_with_flags_decode(
    struct mip_sensor_pps_timestamp_with_flags *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_pps_timestamp_with_flags_codec, 0x0F, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_pps_timestamp_with_flags_encode(
    const struct mip_sensor_pps_timestamp_with_flags *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_pps_timestamp_with_flags_codec, value, builder);
}

/**
 * Complementary filter stabilized north vector: data (0x80,0x10).
 *
 * Estimate of the geomagnetic field by the complementary filter, free of short disturbances.
 *
 * Supported by 3DM-GX5-15.
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
     * Geomagnetic field. Elements: x, y, z. Unit: gauss. Frame: sensor. Uncertain: The frame. The
     * SDK has the vehicle frame, but the lists of what the sensor-to-vehicle transformation changes
     * lack this vector.
     */
    float stabilized_mag[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_NORTH_VECTOR 0x8010
/** Its descriptor. */
#define MIP_SENSOR_NORTH_VECTOR_DESCRIPTOR 0x10
/** Its name in the specification. */
#define MIP_SENSOR_NORTH_VECTOR_NAME "sensor.north_vector"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_north_vector_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_north_vector_decode(struct mip_sensor_north_vector *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_north_vector_codec, 0x10, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_north_vector_encode(
    const struct mip_sensor_north_vector *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_north_vector_codec, value, builder);
}

/**
 * Complementary filter stabilized up vector: data (0x80,0x11).
 *
 * Estimate of the vertical (up) by the complementary filter, free of linear acceleration.
 *
 * Supported by 3DM-GX5-15 and 3DM-GX5-35.
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
     * Frame: sensor. At rest and level: x 0, y 0, z -1. Uncertain: The frame. The SDK has the
     * vehicle frame, but the lists of what the sensor-to-vehicle transformation changes lack this
     * vector.
     */
    float stabilized_accel[3];
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_UP_VECTOR 0x8011
/** Its descriptor. */
#define MIP_SENSOR_UP_VECTOR_DESCRIPTOR 0x11
/** Its name in the specification. */
#define MIP_SENSOR_UP_VECTOR_NAME "sensor.up_vector"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_up_vector_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_up_vector_decode(struct mip_sensor_up_vector *value,
                                                    const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_up_vector_codec, 0x11, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_sensor_up_vector_encode(const struct mip_sensor_up_vector *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_up_vector_codec, value, builder);
}

/**
 * GPS timestamp: data (0x80,0x12).
 *
 * GPS time of the sensor data.
 *
 * Supported by 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.
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
     * MIP_SENSOR_GPS_TIMESTAMP_FLAGS_TOW_VALID in valid_flags is set. On the 3DM-GX5-15 and
     * 3DM-GX5-35: valid if MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED in valid_flags is
     * set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_SENSOR_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER_VALID in
     * valid_flags is set. On the 3DM-GX5-15 and 3DM-GX5-35: valid if
     * MIP_GX5_SENSOR_GPS_TIMESTAMP_FLAGS_TIME_INITIALIZED in valid_flags is set.
     */
    uint16_t week_number;
    /**
     * State of the time. On the 3DM-GX5-15 and 3DM-GX5-35: values of
     * mip_gx5_sensor_gps_timestamp_flags.
     */
    mip_sensor_gps_timestamp_flags valid_flags;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_GPS_TIMESTAMP 0x8012
/** Its descriptor. */
#define MIP_SENSOR_GPS_TIMESTAMP_DESCRIPTOR 0x12
/** Its name in the specification. */
#define MIP_SENSOR_GPS_TIMESTAMP_NAME "sensor.gps_timestamp"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_gps_timestamp_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_gps_timestamp_decode(struct mip_sensor_gps_timestamp *value,
                                                        const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_gps_timestamp_codec, 0x12, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_gps_timestamp_encode(
    const struct mip_sensor_gps_timestamp *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_gps_timestamp_codec, value, builder);
}

/**
 * Temperature statistics: data (0x80,0x14).
 *
 * Temperatures since the last power-on or reset.
 *
 * Also called `temperature_abs`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
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

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_TEMPERATURE_STATISTICS 0x8014
/** Its descriptor. */
#define MIP_SENSOR_TEMPERATURE_STATISTICS_DESCRIPTOR 0x14
/** Its name in the specification. */
#define MIP_SENSOR_TEMPERATURE_STATISTICS_NAME "sensor.temperature_statistics"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_temperature_statistics_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_temperature_statistics_decode(
    struct mip_sensor_temperature_statistics *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_temperature_statistics_codec, 0x14, value, sizeof(*value),
                           field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_temperature_statistics_encode(
    const struct mip_sensor_temperature_statistics *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_temperature_statistics_codec, value, builder);
}

/**
 * Raw pressure: data (0x80,0x16).
 *
 * Raw ambient pressure in counts of the sensor, temperature compensated.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Raw pressure (0x80,0x16)
 */
struct mip_sensor_raw_pressure {
    /** Pressure in counts. Unit: 1. */
    float raw_pressure;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_RAW_PRESSURE 0x8016
/** Its descriptor. */
#define MIP_SENSOR_RAW_PRESSURE_DESCRIPTOR 0x16
/** Its name in the specification. */
#define MIP_SENSOR_RAW_PRESSURE_NAME "sensor.raw_pressure"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_raw_pressure_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_raw_pressure_decode(struct mip_sensor_raw_pressure *value,
                                                       const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_raw_pressure_codec, 0x16, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_raw_pressure_encode(
    const struct mip_sensor_raw_pressure *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_raw_pressure_codec, value, builder);
}

/**
 * Scaled pressure: data (0x80,0x17).
 *
 * Measured ambient pressure, temperature compensated.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS, 3DM-GX5-15 and
 * 3DM-GX5-35.
 *
 * - 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)
 * - 3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)
 */
struct mip_sensor_scaled_pressure {
    /** Ambient pressure. Unit: mbar. Range: at least 0. */
    float scaled_pressure;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_SCALED_PRESSURE 0x8017
/** Its descriptor. */
#define MIP_SENSOR_SCALED_PRESSURE_DESCRIPTOR 0x17
/** Its name in the specification. */
#define MIP_SENSOR_SCALED_PRESSURE_NAME "sensor.scaled_pressure"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_scaled_pressure_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_scaled_pressure_decode(struct mip_sensor_scaled_pressure *value,
                                                          const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_scaled_pressure_codec, 0x17, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_scaled_pressure_encode(
    const struct mip_sensor_scaled_pressure *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_scaled_pressure_codec, value, builder);
}

/**
 * Overrange status: data (0x80,0x18).
 *
 * Sensor axes that are near or outside their range.
 *
 * Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)
 */
struct mip_sensor_overrange_status {
    /** One bit for each axis. */
    mip_sensor_overrange_flags status;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_OVERRANGE_STATUS 0x8018
/** Its descriptor. */
#define MIP_SENSOR_OVERRANGE_STATUS_DESCRIPTOR 0x18
/** Its name in the specification. */
#define MIP_SENSOR_OVERRANGE_STATUS_NAME "sensor.overrange_status"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_overrange_status_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_overrange_status_decode(
    struct mip_sensor_overrange_status *value, const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_overrange_status_codec, 0x18, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_sensor_overrange_status_encode(
    const struct mip_sensor_overrange_status *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_overrange_status_codec, value, builder);
}

/**
 * Odometer data: data (0x80,0x40).
 *
 * Speed measured by the wheel encoder.
 *
 * Also called `odometer_data`. Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)
 */
struct mip_sensor_odometer {
    /**
     * Average speed over the interval; negative values come from quadrature encoders only. Unit:
     * m/s. Valid if MIP_SENSOR_ODOMETER_FLAGS_ODOMETER in valid_flags is set.
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

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_SENSOR_ODOMETER 0x8040
/** Its descriptor. */
#define MIP_SENSOR_ODOMETER_DESCRIPTOR 0x40
/** Its name in the specification. */
#define MIP_SENSOR_ODOMETER_NAME "sensor.odometer"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_sensor_odometer_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_sensor_odometer_decode(struct mip_sensor_odometer *value,
                                                   const struct mip_field *field) {
    return mip_decode_only(&mip_sensor_odometer_codec, 0x40, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error
mip_sensor_odometer_encode(const struct mip_sensor_odometer *value, struct mip_builder *builder) {
    return mip_encode(&mip_sensor_odometer_codec, value, builder);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
