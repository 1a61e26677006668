/* Sensor data. */
#include "mip/sensor.h"

#include <string.h>

static void read_raw_accel(struct mip_reader *r, void *value) {
    struct mip_sensor_raw_accel *v = (struct mip_sensor_raw_accel *)value;
    mip_read_float(r, v->raw_accel, 3);
}

static void write_raw_accel(struct mip_writer *w, const void *value) {
    const struct mip_sensor_raw_accel *v = (const struct mip_sensor_raw_accel *)value;
    mip_write_float(w, v->raw_accel, 3);
}

const struct mip_codec mip_sensor_raw_accel_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_RAW_ACCEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_raw_accel),
    0, /* time-out */
    read_raw_accel,
    write_raw_accel,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_raw_accel_decode(struct mip_sensor_raw_accel *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_raw_accel, value, sizeof(*value), NULL);
}

mip_error mip_sensor_raw_accel_encode(const struct mip_sensor_raw_accel *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_RAW_ACCEL_DESCRIPTOR, write_raw_accel, value);
}

static void read_raw_gyro(struct mip_reader *r, void *value) {
    struct mip_sensor_raw_gyro *v = (struct mip_sensor_raw_gyro *)value;
    mip_read_float(r, v->raw_gyro, 3);
}

static void write_raw_gyro(struct mip_writer *w, const void *value) {
    const struct mip_sensor_raw_gyro *v = (const struct mip_sensor_raw_gyro *)value;
    mip_write_float(w, v->raw_gyro, 3);
}

const struct mip_codec mip_sensor_raw_gyro_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_RAW_GYRO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_raw_gyro),
    0, /* time-out */
    read_raw_gyro,
    write_raw_gyro,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_raw_gyro_decode(struct mip_sensor_raw_gyro *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_raw_gyro, value, sizeof(*value), NULL);
}

mip_error mip_sensor_raw_gyro_encode(const struct mip_sensor_raw_gyro *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_RAW_GYRO_DESCRIPTOR, write_raw_gyro, value);
}

static void read_raw_mag(struct mip_reader *r, void *value) {
    struct mip_sensor_raw_mag *v = (struct mip_sensor_raw_mag *)value;
    mip_read_float(r, v->raw_mag, 3);
}

static void write_raw_mag(struct mip_writer *w, const void *value) {
    const struct mip_sensor_raw_mag *v = (const struct mip_sensor_raw_mag *)value;
    mip_write_float(w, v->raw_mag, 3);
}

const struct mip_codec mip_sensor_raw_mag_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_RAW_MAG_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_raw_mag),
    0, /* time-out */
    read_raw_mag,
    write_raw_mag,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_raw_mag_decode(struct mip_sensor_raw_mag *value,
                                    const struct mip_field *field) {
    return mip_decode_field(field, read_raw_mag, value, sizeof(*value), NULL);
}

mip_error mip_sensor_raw_mag_encode(const struct mip_sensor_raw_mag *value,
                                    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_RAW_MAG_DESCRIPTOR, write_raw_mag, value);
}

static void read_scaled_accel(struct mip_reader *r, void *value) {
    struct mip_sensor_scaled_accel *v = (struct mip_sensor_scaled_accel *)value;
    mip_read_float(r, v->scaled_accel, 3);
}

static void write_scaled_accel(struct mip_writer *w, const void *value) {
    const struct mip_sensor_scaled_accel *v = (const struct mip_sensor_scaled_accel *)value;
    mip_write_float(w, v->scaled_accel, 3);
}

const struct mip_codec mip_sensor_scaled_accel_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_scaled_accel),
    0, /* time-out */
    read_scaled_accel,
    write_scaled_accel,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_scaled_accel_decode(struct mip_sensor_scaled_accel *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_scaled_accel, value, sizeof(*value), NULL);
}

mip_error mip_sensor_scaled_accel_encode(const struct mip_sensor_scaled_accel *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, write_scaled_accel,
                            value);
}

static void read_scaled_gyro(struct mip_reader *r, void *value) {
    struct mip_sensor_scaled_gyro *v = (struct mip_sensor_scaled_gyro *)value;
    mip_read_float(r, v->scaled_gyro, 3);
}

static void write_scaled_gyro(struct mip_writer *w, const void *value) {
    const struct mip_sensor_scaled_gyro *v = (const struct mip_sensor_scaled_gyro *)value;
    mip_write_float(w, v->scaled_gyro, 3);
}

const struct mip_codec mip_sensor_scaled_gyro_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_SCALED_GYRO_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_scaled_gyro),
    0, /* time-out */
    read_scaled_gyro,
    write_scaled_gyro,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_scaled_gyro_decode(struct mip_sensor_scaled_gyro *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_scaled_gyro, value, sizeof(*value), NULL);
}

mip_error mip_sensor_scaled_gyro_encode(const struct mip_sensor_scaled_gyro *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_SCALED_GYRO_DESCRIPTOR, write_scaled_gyro,
                            value);
}

static void read_scaled_mag(struct mip_reader *r, void *value) {
    struct mip_sensor_scaled_mag *v = (struct mip_sensor_scaled_mag *)value;
    mip_read_float(r, v->scaled_mag, 3);
}

static void write_scaled_mag(struct mip_writer *w, const void *value) {
    const struct mip_sensor_scaled_mag *v = (const struct mip_sensor_scaled_mag *)value;
    mip_write_float(w, v->scaled_mag, 3);
}

const struct mip_codec mip_sensor_scaled_mag_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_SCALED_MAG_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_scaled_mag),
    0, /* time-out */
    read_scaled_mag,
    write_scaled_mag,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_scaled_mag_decode(struct mip_sensor_scaled_mag *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_scaled_mag, value, sizeof(*value), NULL);
}

mip_error mip_sensor_scaled_mag_encode(const struct mip_sensor_scaled_mag *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_SCALED_MAG_DESCRIPTOR, write_scaled_mag,
                            value);
}

static void read_delta_theta(struct mip_reader *r, void *value) {
    struct mip_sensor_delta_theta *v = (struct mip_sensor_delta_theta *)value;
    mip_read_float(r, v->delta_theta, 3);
}

static void write_delta_theta(struct mip_writer *w, const void *value) {
    const struct mip_sensor_delta_theta *v = (const struct mip_sensor_delta_theta *)value;
    mip_write_float(w, v->delta_theta, 3);
}

const struct mip_codec mip_sensor_delta_theta_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_DELTA_THETA_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_delta_theta),
    0, /* time-out */
    read_delta_theta,
    write_delta_theta,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_delta_theta_decode(struct mip_sensor_delta_theta *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_delta_theta, value, sizeof(*value), NULL);
}

mip_error mip_sensor_delta_theta_encode(const struct mip_sensor_delta_theta *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_DELTA_THETA_DESCRIPTOR, write_delta_theta,
                            value);
}

static void read_delta_velocity(struct mip_reader *r, void *value) {
    struct mip_sensor_delta_velocity *v = (struct mip_sensor_delta_velocity *)value;
    mip_read_float(r, v->delta_velocity, 3);
}

static void write_delta_velocity(struct mip_writer *w, const void *value) {
    const struct mip_sensor_delta_velocity *v = (const struct mip_sensor_delta_velocity *)value;
    mip_write_float(w, v->delta_velocity, 3);
}

const struct mip_codec mip_sensor_delta_velocity_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_DELTA_VELOCITY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_delta_velocity),
    0, /* time-out */
    read_delta_velocity,
    write_delta_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_delta_velocity_decode(struct mip_sensor_delta_velocity *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_delta_velocity, value, sizeof(*value), NULL);
}

mip_error mip_sensor_delta_velocity_encode(const struct mip_sensor_delta_velocity *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_DELTA_VELOCITY_DESCRIPTOR,
                            write_delta_velocity, value);
}

static void read_comp_orientation_matrix(struct mip_reader *r, void *value) {
    struct mip_sensor_comp_orientation_matrix *v =
        (struct mip_sensor_comp_orientation_matrix *)value;
    mip_read_float(r, v->m, 9);
}

static void write_comp_orientation_matrix(struct mip_writer *w, const void *value) {
    const struct mip_sensor_comp_orientation_matrix *v =
        (const struct mip_sensor_comp_orientation_matrix *)value;
    mip_write_float(w, v->m, 9);
}

const struct mip_codec mip_sensor_comp_orientation_matrix_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_COMP_ORIENTATION_MATRIX_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_comp_orientation_matrix),
    0, /* time-out */
    read_comp_orientation_matrix,
    write_comp_orientation_matrix,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_comp_orientation_matrix_decode(
    struct mip_sensor_comp_orientation_matrix *value, const struct mip_field *field) {
    return mip_decode_field(field, read_comp_orientation_matrix, value, sizeof(*value), NULL);
}

mip_error mip_sensor_comp_orientation_matrix_encode(
    const struct mip_sensor_comp_orientation_matrix *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_COMP_ORIENTATION_MATRIX_DESCRIPTOR,
                            write_comp_orientation_matrix, value);
}

static void read_comp_quaternion(struct mip_reader *r, void *value) {
    struct mip_sensor_comp_quaternion *v = (struct mip_sensor_comp_quaternion *)value;
    mip_read_float(r, v->q, 4);
}

static void write_comp_quaternion(struct mip_writer *w, const void *value) {
    const struct mip_sensor_comp_quaternion *v = (const struct mip_sensor_comp_quaternion *)value;
    mip_write_float(w, v->q, 4);
}

const struct mip_codec mip_sensor_comp_quaternion_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_COMP_QUATERNION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_comp_quaternion),
    0, /* time-out */
    read_comp_quaternion,
    write_comp_quaternion,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_comp_quaternion_decode(struct mip_sensor_comp_quaternion *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_comp_quaternion, value, sizeof(*value), NULL);
}

mip_error mip_sensor_comp_quaternion_encode(const struct mip_sensor_comp_quaternion *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_COMP_QUATERNION_DESCRIPTOR,
                            write_comp_quaternion, value);
}

static void read_comp_orientation_update_matrix(struct mip_reader *r, void *value) {
    struct mip_sensor_comp_orientation_update_matrix *v =
        (struct mip_sensor_comp_orientation_update_matrix *)value;
    mip_read_float(r, v->m, 9);
}

static void write_comp_orientation_update_matrix(struct mip_writer *w, const void *value) {
    const struct mip_sensor_comp_orientation_update_matrix *v =
        (const struct mip_sensor_comp_orientation_update_matrix *)value;
    mip_write_float(w, v->m, 9);
}

const struct mip_codec mip_sensor_comp_orientation_update_matrix_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_comp_orientation_update_matrix),
    0, /* time-out */
    read_comp_orientation_update_matrix,
    write_comp_orientation_update_matrix,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_comp_orientation_update_matrix_decode(
    struct mip_sensor_comp_orientation_update_matrix *value, const struct mip_field *field) {
    return mip_decode_field(field, read_comp_orientation_update_matrix, value, sizeof(*value),
                            NULL);
}

mip_error mip_sensor_comp_orientation_update_matrix_encode(
    const struct mip_sensor_comp_orientation_update_matrix *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_COMP_ORIENTATION_UPDATE_MATRIX_DESCRIPTOR,
                            write_comp_orientation_update_matrix, value);
}

static void read_comp_euler_angles(struct mip_reader *r, void *value) {
    struct mip_sensor_comp_euler_angles *v = (struct mip_sensor_comp_euler_angles *)value;
    mip_read_float(r, &v->roll, 1);
    mip_read_float(r, &v->pitch, 1);
    mip_read_float(r, &v->yaw, 1);
}

static void write_comp_euler_angles(struct mip_writer *w, const void *value) {
    const struct mip_sensor_comp_euler_angles *v =
        (const struct mip_sensor_comp_euler_angles *)value;
    mip_write_float(w, &v->roll, 1);
    mip_write_float(w, &v->pitch, 1);
    mip_write_float(w, &v->yaw, 1);
}

const struct mip_codec mip_sensor_comp_euler_angles_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_COMP_EULER_ANGLES_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_comp_euler_angles),
    0, /* time-out */
    read_comp_euler_angles,
    write_comp_euler_angles,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_comp_euler_angles_decode(struct mip_sensor_comp_euler_angles *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_comp_euler_angles, value, sizeof(*value), NULL);
}

mip_error mip_sensor_comp_euler_angles_encode(const struct mip_sensor_comp_euler_angles *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_COMP_EULER_ANGLES_DESCRIPTOR,
                            write_comp_euler_angles, value);
}

static void read_orientation_raw_temperature(struct mip_reader *r, void *value) {
    struct mip_sensor_orientation_raw_temperature *v =
        (struct mip_sensor_orientation_raw_temperature *)value;
    mip_read_u16(r, v->raw_temperature, 4);
}

static void write_orientation_raw_temperature(struct mip_writer *w, const void *value) {
    const struct mip_sensor_orientation_raw_temperature *v =
        (const struct mip_sensor_orientation_raw_temperature *)value;
    mip_write_u16(w, v->raw_temperature, 4);
}

const struct mip_codec mip_sensor_orientation_raw_temperature_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_orientation_raw_temperature),
    0, /* time-out */
    read_orientation_raw_temperature,
    write_orientation_raw_temperature,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_orientation_raw_temperature_decode(
    struct mip_sensor_orientation_raw_temperature *value, const struct mip_field *field) {
    return mip_decode_field(field, read_orientation_raw_temperature, value, sizeof(*value), NULL);
}

mip_error mip_sensor_orientation_raw_temperature_encode(
    const struct mip_sensor_orientation_raw_temperature *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_ORIENTATION_RAW_TEMPERATURE_DESCRIPTOR,
                            write_orientation_raw_temperature, value);
}

static void read_internal_timestamp(struct mip_reader *r, void *value) {
    struct mip_sensor_internal_timestamp *v = (struct mip_sensor_internal_timestamp *)value;
    mip_read_u32(r, &v->counts, 1);
}

static void write_internal_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_sensor_internal_timestamp *v =
        (const struct mip_sensor_internal_timestamp *)value;
    mip_write_u32(w, &v->counts, 1);
}

const struct mip_codec mip_sensor_internal_timestamp_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_INTERNAL_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_internal_timestamp),
    0, /* time-out */
    read_internal_timestamp,
    write_internal_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_internal_timestamp_decode(struct mip_sensor_internal_timestamp *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_internal_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_sensor_internal_timestamp_encode(const struct mip_sensor_internal_timestamp *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_INTERNAL_TIMESTAMP_DESCRIPTOR,
                            write_internal_timestamp, value);
}

static void read_pps_timestamp(struct mip_reader *r, void *value) {
    struct mip_sensor_pps_timestamp *v = (struct mip_sensor_pps_timestamp *)value;
    mip_read_u32(r, &v->seconds, 1);
    mip_read_u32(r, &v->useconds, 1);
}

static void write_pps_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_sensor_pps_timestamp *v = (const struct mip_sensor_pps_timestamp *)value;
    mip_write_u32(w, &v->seconds, 1);
    mip_write_u32(w, &v->useconds, 1);
}

const struct mip_codec mip_sensor_pps_timestamp_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_PPS_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_pps_timestamp),
    0, /* time-out */
    read_pps_timestamp,
    write_pps_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_pps_timestamp_decode(struct mip_sensor_pps_timestamp *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_pps_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_sensor_pps_timestamp_encode(const struct mip_sensor_pps_timestamp *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_PPS_TIMESTAMP_DESCRIPTOR, write_pps_timestamp,
                            value);
}

static void read_north_vector(struct mip_reader *r, void *value) {
    struct mip_sensor_north_vector *v = (struct mip_sensor_north_vector *)value;
    mip_read_float(r, v->stabilized_mag, 3);
}

static void write_north_vector(struct mip_writer *w, const void *value) {
    const struct mip_sensor_north_vector *v = (const struct mip_sensor_north_vector *)value;
    mip_write_float(w, v->stabilized_mag, 3);
}

const struct mip_codec mip_sensor_north_vector_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_NORTH_VECTOR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_north_vector),
    0, /* time-out */
    read_north_vector,
    write_north_vector,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_north_vector_decode(struct mip_sensor_north_vector *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_north_vector, value, sizeof(*value), NULL);
}

mip_error mip_sensor_north_vector_encode(const struct mip_sensor_north_vector *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_NORTH_VECTOR_DESCRIPTOR, write_north_vector,
                            value);
}

static void read_up_vector(struct mip_reader *r, void *value) {
    struct mip_sensor_up_vector *v = (struct mip_sensor_up_vector *)value;
    mip_read_float(r, v->stabilized_accel, 3);
}

static void write_up_vector(struct mip_writer *w, const void *value) {
    const struct mip_sensor_up_vector *v = (const struct mip_sensor_up_vector *)value;
    mip_write_float(w, v->stabilized_accel, 3);
}

const struct mip_codec mip_sensor_up_vector_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_UP_VECTOR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_up_vector),
    0, /* time-out */
    read_up_vector,
    write_up_vector,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_up_vector_decode(struct mip_sensor_up_vector *value,
                                      const struct mip_field *field) {
    return mip_decode_field(field, read_up_vector, value, sizeof(*value), NULL);
}

mip_error mip_sensor_up_vector_encode(const struct mip_sensor_up_vector *value,
                                      struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_UP_VECTOR_DESCRIPTOR, write_up_vector, value);
}

static void read_gps_timestamp(struct mip_reader *r, void *value) {
    struct mip_sensor_gps_timestamp *v = (struct mip_sensor_gps_timestamp *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gps_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_sensor_gps_timestamp *v = (const struct mip_sensor_gps_timestamp *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_sensor_gps_timestamp_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_GPS_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_gps_timestamp),
    0, /* time-out */
    read_gps_timestamp,
    write_gps_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_gps_timestamp_decode(struct mip_sensor_gps_timestamp *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_gps_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_sensor_gps_timestamp_encode(const struct mip_sensor_gps_timestamp *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_GPS_TIMESTAMP_DESCRIPTOR, write_gps_timestamp,
                            value);
}

static void read_temperature_statistics(struct mip_reader *r, void *value) {
    struct mip_sensor_temperature_statistics *v = (struct mip_sensor_temperature_statistics *)value;
    mip_read_float(r, &v->min_temperature, 1);
    mip_read_float(r, &v->max_temperature, 1);
    mip_read_float(r, &v->mean_temperature, 1);
}

static void write_temperature_statistics(struct mip_writer *w, const void *value) {
    const struct mip_sensor_temperature_statistics *v =
        (const struct mip_sensor_temperature_statistics *)value;
    mip_write_float(w, &v->min_temperature, 1);
    mip_write_float(w, &v->max_temperature, 1);
    mip_write_float(w, &v->mean_temperature, 1);
}

const struct mip_codec mip_sensor_temperature_statistics_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_TEMPERATURE_STATISTICS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_temperature_statistics),
    0, /* time-out */
    read_temperature_statistics,
    write_temperature_statistics,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_temperature_statistics_decode(struct mip_sensor_temperature_statistics *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_temperature_statistics, value, sizeof(*value), NULL);
}

mip_error mip_sensor_temperature_statistics_encode(
    const struct mip_sensor_temperature_statistics *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_TEMPERATURE_STATISTICS_DESCRIPTOR,
                            write_temperature_statistics, value);
}

static void read_raw_pressure(struct mip_reader *r, void *value) {
    struct mip_sensor_raw_pressure *v = (struct mip_sensor_raw_pressure *)value;
    mip_read_float(r, &v->raw_pressure, 1);
}

static void write_raw_pressure(struct mip_writer *w, const void *value) {
    const struct mip_sensor_raw_pressure *v = (const struct mip_sensor_raw_pressure *)value;
    mip_write_float(w, &v->raw_pressure, 1);
}

const struct mip_codec mip_sensor_raw_pressure_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_RAW_PRESSURE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_raw_pressure),
    0, /* time-out */
    read_raw_pressure,
    write_raw_pressure,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_raw_pressure_decode(struct mip_sensor_raw_pressure *value,
                                         const struct mip_field *field) {
    return mip_decode_field(field, read_raw_pressure, value, sizeof(*value), NULL);
}

mip_error mip_sensor_raw_pressure_encode(const struct mip_sensor_raw_pressure *value,
                                         struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_RAW_PRESSURE_DESCRIPTOR, write_raw_pressure,
                            value);
}

static void read_scaled_pressure(struct mip_reader *r, void *value) {
    struct mip_sensor_scaled_pressure *v = (struct mip_sensor_scaled_pressure *)value;
    mip_read_float(r, &v->scaled_pressure, 1);
}

static void write_scaled_pressure(struct mip_writer *w, const void *value) {
    const struct mip_sensor_scaled_pressure *v = (const struct mip_sensor_scaled_pressure *)value;
    mip_write_float(w, &v->scaled_pressure, 1);
}

const struct mip_codec mip_sensor_scaled_pressure_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_SCALED_PRESSURE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_scaled_pressure),
    0, /* time-out */
    read_scaled_pressure,
    write_scaled_pressure,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_scaled_pressure_decode(struct mip_sensor_scaled_pressure *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_scaled_pressure, value, sizeof(*value), NULL);
}

mip_error mip_sensor_scaled_pressure_encode(const struct mip_sensor_scaled_pressure *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_SCALED_PRESSURE_DESCRIPTOR,
                            write_scaled_pressure, value);
}

static void read_overrange_status(struct mip_reader *r, void *value) {
    struct mip_sensor_overrange_status *v = (struct mip_sensor_overrange_status *)value;
    mip_read_u16(r, &v->status, 1);
}

static void write_overrange_status(struct mip_writer *w, const void *value) {
    const struct mip_sensor_overrange_status *v = (const struct mip_sensor_overrange_status *)value;
    mip_write_u16(w, &v->status, 1);
}

const struct mip_codec mip_sensor_overrange_status_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_OVERRANGE_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_overrange_status),
    0, /* time-out */
    read_overrange_status,
    write_overrange_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_overrange_status_decode(struct mip_sensor_overrange_status *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, read_overrange_status, value, sizeof(*value), NULL);
}

mip_error mip_sensor_overrange_status_encode(const struct mip_sensor_overrange_status *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_OVERRANGE_STATUS_DESCRIPTOR,
                            write_overrange_status, value);
}

static void read_odometer(struct mip_reader *r, void *value) {
    struct mip_sensor_odometer *v = (struct mip_sensor_odometer *)value;
    mip_read_float(r, &v->speed, 1);
    mip_read_float(r, &v->uncertainty, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_odometer(struct mip_writer *w, const void *value) {
    const struct mip_sensor_odometer *v = (const struct mip_sensor_odometer *)value;
    mip_write_float(w, &v->speed, 1);
    mip_write_float(w, &v->uncertainty, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_sensor_odometer_codec = {
    0x80, /* descriptor set */
    MIP_SENSOR_ODOMETER_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_sensor_odometer),
    0, /* time-out */
    read_odometer,
    write_odometer,
    NULL,
    NULL,
    NULL,
};

mip_error mip_sensor_odometer_decode(struct mip_sensor_odometer *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_odometer, value, sizeof(*value), NULL);
}

mip_error mip_sensor_odometer_encode(const struct mip_sensor_odometer *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x80, MIP_SENSOR_ODOMETER_DESCRIPTOR, write_odometer, value);
}
