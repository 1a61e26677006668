/* Filter data. */
#include "mip/filter_data.h"

#include <string.h>

static void read_llh_position(struct mip_reader *r, void *value) {
    struct mip_filter_data_llh_position *v = (struct mip_filter_data_llh_position *)value;
    mip_read_double(r, &v->latitude, 1);
    mip_read_double(r, &v->longitude, 1);
    mip_read_double(r, &v->ellipsoid_height, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_llh_position(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_llh_position *v =
        (const struct mip_filter_data_llh_position *)value;
    mip_write_double(w, &v->latitude, 1);
    mip_write_double(w, &v->longitude, 1);
    mip_write_double(w, &v->ellipsoid_height, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_llh_position_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_LLH_POSITION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_llh_position),
    0, /* time-out */
    read_llh_position,
    write_llh_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_llh_position_decode(struct mip_filter_data_llh_position *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_llh_position, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_llh_position_encode(const struct mip_filter_data_llh_position *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_LLH_POSITION_DESCRIPTOR,
                            write_llh_position, value);
}

static void read_ned_velocity(struct mip_reader *r, void *value) {
    struct mip_filter_data_ned_velocity *v = (struct mip_filter_data_ned_velocity *)value;
    mip_read_float(r, &v->north, 1);
    mip_read_float(r, &v->east, 1);
    mip_read_float(r, &v->down, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ned_velocity(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ned_velocity *v =
        (const struct mip_filter_data_ned_velocity *)value;
    mip_write_float(w, &v->north, 1);
    mip_write_float(w, &v->east, 1);
    mip_write_float(w, &v->down, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ned_velocity_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_NED_VELOCITY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ned_velocity),
    0, /* time-out */
    read_ned_velocity,
    write_ned_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ned_velocity_decode(struct mip_filter_data_ned_velocity *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_ned_velocity, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ned_velocity_encode(const struct mip_filter_data_ned_velocity *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_NED_VELOCITY_DESCRIPTOR,
                            write_ned_velocity, value);
}

static void read_attitude_quaternion(struct mip_reader *r, void *value) {
    struct mip_filter_data_attitude_quaternion *v =
        (struct mip_filter_data_attitude_quaternion *)value;
    mip_read_float(r, v->q, 4);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_attitude_quaternion(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_attitude_quaternion *v =
        (const struct mip_filter_data_attitude_quaternion *)value;
    mip_write_float(w, v->q, 4);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_attitude_quaternion_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ATTITUDE_QUATERNION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_attitude_quaternion),
    0, /* time-out */
    read_attitude_quaternion,
    write_attitude_quaternion,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_attitude_quaternion_decode(
    struct mip_filter_data_attitude_quaternion *value, const struct mip_field *field) {
    return mip_decode_field(field, read_attitude_quaternion, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_attitude_quaternion_encode(
    const struct mip_filter_data_attitude_quaternion *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ATTITUDE_QUATERNION_DESCRIPTOR,
                            write_attitude_quaternion, value);
}

static void read_attitude_dcm(struct mip_reader *r, void *value) {
    struct mip_filter_data_attitude_dcm *v = (struct mip_filter_data_attitude_dcm *)value;
    mip_read_float(r, v->dcm, 9);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_attitude_dcm(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_attitude_dcm *v =
        (const struct mip_filter_data_attitude_dcm *)value;
    mip_write_float(w, v->dcm, 9);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_attitude_dcm_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ATTITUDE_DCM_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_attitude_dcm),
    0, /* time-out */
    read_attitude_dcm,
    write_attitude_dcm,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_attitude_dcm_decode(struct mip_filter_data_attitude_dcm *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_attitude_dcm, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_attitude_dcm_encode(const struct mip_filter_data_attitude_dcm *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ATTITUDE_DCM_DESCRIPTOR,
                            write_attitude_dcm, value);
}

static void read_euler_angles(struct mip_reader *r, void *value) {
    struct mip_filter_data_euler_angles *v = (struct mip_filter_data_euler_angles *)value;
    mip_read_float(r, &v->roll, 1);
    mip_read_float(r, &v->pitch, 1);
    mip_read_float(r, &v->yaw, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_euler_angles(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_euler_angles *v =
        (const struct mip_filter_data_euler_angles *)value;
    mip_write_float(w, &v->roll, 1);
    mip_write_float(w, &v->pitch, 1);
    mip_write_float(w, &v->yaw, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_euler_angles_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_EULER_ANGLES_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_euler_angles),
    0, /* time-out */
    read_euler_angles,
    write_euler_angles,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_euler_angles_decode(struct mip_filter_data_euler_angles *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_euler_angles, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_euler_angles_encode(const struct mip_filter_data_euler_angles *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_EULER_ANGLES_DESCRIPTOR,
                            write_euler_angles, value);
}

static void read_gyro_bias(struct mip_reader *r, void *value) {
    struct mip_filter_data_gyro_bias *v = (struct mip_filter_data_gyro_bias *)value;
    mip_read_float(r, v->bias, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gyro_bias(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gyro_bias *v = (const struct mip_filter_data_gyro_bias *)value;
    mip_write_float(w, v->bias, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_gyro_bias_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GYRO_BIAS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gyro_bias),
    0, /* time-out */
    read_gyro_bias,
    write_gyro_bias,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gyro_bias_decode(struct mip_filter_data_gyro_bias *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_bias, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gyro_bias_encode(const struct mip_filter_data_gyro_bias *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GYRO_BIAS_DESCRIPTOR, write_gyro_bias,
                            value);
}

static void read_accel_bias(struct mip_reader *r, void *value) {
    struct mip_filter_data_accel_bias *v = (struct mip_filter_data_accel_bias *)value;
    mip_read_float(r, v->bias, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_accel_bias(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_accel_bias *v = (const struct mip_filter_data_accel_bias *)value;
    mip_write_float(w, v->bias, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_accel_bias_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ACCEL_BIAS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_accel_bias),
    0, /* time-out */
    read_accel_bias,
    write_accel_bias,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_accel_bias_decode(struct mip_filter_data_accel_bias *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_accel_bias, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_accel_bias_encode(const struct mip_filter_data_accel_bias *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ACCEL_BIAS_DESCRIPTOR, write_accel_bias,
                            value);
}

static void read_llh_position_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_llh_position_uncertainty *v =
        (struct mip_filter_data_llh_position_uncertainty *)value;
    mip_read_float(r, &v->north, 1);
    mip_read_float(r, &v->east, 1);
    mip_read_float(r, &v->down, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_llh_position_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_llh_position_uncertainty *v =
        (const struct mip_filter_data_llh_position_uncertainty *)value;
    mip_write_float(w, &v->north, 1);
    mip_write_float(w, &v->east, 1);
    mip_write_float(w, &v->down, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_llh_position_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_LLH_POSITION_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_llh_position_uncertainty),
    0, /* time-out */
    read_llh_position_uncertainty,
    write_llh_position_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_llh_position_uncertainty_decode(
    struct mip_filter_data_llh_position_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_llh_position_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_llh_position_uncertainty_encode(
    const struct mip_filter_data_llh_position_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_LLH_POSITION_UNCERTAINTY_DESCRIPTOR,
                            write_llh_position_uncertainty, value);
}

static void read_ned_velocity_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_ned_velocity_uncertainty *v =
        (struct mip_filter_data_ned_velocity_uncertainty *)value;
    mip_read_float(r, &v->north, 1);
    mip_read_float(r, &v->east, 1);
    mip_read_float(r, &v->down, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ned_velocity_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ned_velocity_uncertainty *v =
        (const struct mip_filter_data_ned_velocity_uncertainty *)value;
    mip_write_float(w, &v->north, 1);
    mip_write_float(w, &v->east, 1);
    mip_write_float(w, &v->down, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ned_velocity_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_NED_VELOCITY_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ned_velocity_uncertainty),
    0, /* time-out */
    read_ned_velocity_uncertainty,
    write_ned_velocity_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ned_velocity_uncertainty_decode(
    struct mip_filter_data_ned_velocity_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_ned_velocity_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ned_velocity_uncertainty_encode(
    const struct mip_filter_data_ned_velocity_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_NED_VELOCITY_UNCERTAINTY_DESCRIPTOR,
                            write_ned_velocity_uncertainty, value);
}

static void read_euler_angles_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_euler_angles_uncertainty *v =
        (struct mip_filter_data_euler_angles_uncertainty *)value;
    mip_read_float(r, &v->roll, 1);
    mip_read_float(r, &v->pitch, 1);
    mip_read_float(r, &v->yaw, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_euler_angles_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_euler_angles_uncertainty *v =
        (const struct mip_filter_data_euler_angles_uncertainty *)value;
    mip_write_float(w, &v->roll, 1);
    mip_write_float(w, &v->pitch, 1);
    mip_write_float(w, &v->yaw, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_euler_angles_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_EULER_ANGLES_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_euler_angles_uncertainty),
    0, /* time-out */
    read_euler_angles_uncertainty,
    write_euler_angles_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_euler_angles_uncertainty_decode(
    struct mip_filter_data_euler_angles_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_euler_angles_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_euler_angles_uncertainty_encode(
    const struct mip_filter_data_euler_angles_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_EULER_ANGLES_UNCERTAINTY_DESCRIPTOR,
                            write_euler_angles_uncertainty, value);
}

static void read_gyro_bias_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_gyro_bias_uncertainty *v =
        (struct mip_filter_data_gyro_bias_uncertainty *)value;
    mip_read_float(r, v->bias_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gyro_bias_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gyro_bias_uncertainty *v =
        (const struct mip_filter_data_gyro_bias_uncertainty *)value;
    mip_write_float(w, v->bias_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_gyro_bias_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GYRO_BIAS_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gyro_bias_uncertainty),
    0, /* time-out */
    read_gyro_bias_uncertainty,
    write_gyro_bias_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gyro_bias_uncertainty_decode(
    struct mip_filter_data_gyro_bias_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_bias_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gyro_bias_uncertainty_encode(
    const struct mip_filter_data_gyro_bias_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GYRO_BIAS_UNCERTAINTY_DESCRIPTOR,
                            write_gyro_bias_uncertainty, value);
}

static void read_accel_bias_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_accel_bias_uncertainty *v =
        (struct mip_filter_data_accel_bias_uncertainty *)value;
    mip_read_float(r, v->bias_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_accel_bias_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_accel_bias_uncertainty *v =
        (const struct mip_filter_data_accel_bias_uncertainty *)value;
    mip_write_float(w, v->bias_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_accel_bias_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ACCEL_BIAS_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_accel_bias_uncertainty),
    0, /* time-out */
    read_accel_bias_uncertainty,
    write_accel_bias_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_accel_bias_uncertainty_decode(
    struct mip_filter_data_accel_bias_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_accel_bias_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_accel_bias_uncertainty_encode(
    const struct mip_filter_data_accel_bias_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ACCEL_BIAS_UNCERTAINTY_DESCRIPTOR,
                            write_accel_bias_uncertainty, value);
}

static void read_linear_accel(struct mip_reader *r, void *value) {
    struct mip_filter_data_linear_accel *v = (struct mip_filter_data_linear_accel *)value;
    mip_read_float(r, v->accel, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_linear_accel(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_linear_accel *v =
        (const struct mip_filter_data_linear_accel *)value;
    mip_write_float(w, v->accel, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_linear_accel_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_LINEAR_ACCEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_linear_accel),
    0, /* time-out */
    read_linear_accel,
    write_linear_accel,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_linear_accel_decode(struct mip_filter_data_linear_accel *value,
                                              const struct mip_field *field) {
    return mip_decode_field(field, read_linear_accel, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_linear_accel_encode(const struct mip_filter_data_linear_accel *value,
                                              struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_LINEAR_ACCEL_DESCRIPTOR,
                            write_linear_accel, value);
}

static void read_comp_angular_rate(struct mip_reader *r, void *value) {
    struct mip_filter_data_comp_angular_rate *v = (struct mip_filter_data_comp_angular_rate *)value;
    mip_read_float(r, v->gyro, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_comp_angular_rate(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_comp_angular_rate *v =
        (const struct mip_filter_data_comp_angular_rate *)value;
    mip_write_float(w, v->gyro, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_comp_angular_rate_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_COMP_ANGULAR_RATE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_comp_angular_rate),
    0, /* time-out */
    read_comp_angular_rate,
    write_comp_angular_rate,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_comp_angular_rate_decode(struct mip_filter_data_comp_angular_rate *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_comp_angular_rate, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_comp_angular_rate_encode(
    const struct mip_filter_data_comp_angular_rate *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_COMP_ANGULAR_RATE_DESCRIPTOR,
                            write_comp_angular_rate, value);
}

static void read_wgs84_gravity_magnitude(struct mip_reader *r, void *value) {
    struct mip_filter_data_wgs84_gravity_magnitude *v =
        (struct mip_filter_data_wgs84_gravity_magnitude *)value;
    mip_read_float(r, &v->gravity_magnitude, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_wgs84_gravity_magnitude(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_wgs84_gravity_magnitude *v =
        (const struct mip_filter_data_wgs84_gravity_magnitude *)value;
    mip_write_float(w, &v->gravity_magnitude, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_wgs84_gravity_magnitude_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_WGS84_GRAVITY_MAGNITUDE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_wgs84_gravity_magnitude),
    0, /* time-out */
    read_wgs84_gravity_magnitude,
    write_wgs84_gravity_magnitude,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_wgs84_gravity_magnitude_decode(
    struct mip_filter_data_wgs84_gravity_magnitude *value, const struct mip_field *field) {
    return mip_decode_field(field, read_wgs84_gravity_magnitude, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_wgs84_gravity_magnitude_encode(
    const struct mip_filter_data_wgs84_gravity_magnitude *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_WGS84_GRAVITY_MAGNITUDE_DESCRIPTOR,
                            write_wgs84_gravity_magnitude, value);
}

static void read_status(struct mip_reader *r, void *value) {
    struct mip_filter_data_status *v = (struct mip_filter_data_status *)value;
    mip_read_u16(r, &v->filter_state, 1);
    mip_read_u16(r, &v->dynamics_mode, 1);
    mip_read_u16(r, &v->status_flags, 1);
}

static void write_status(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_status *v = (const struct mip_filter_data_status *)value;
    mip_write_u16(w, &v->filter_state, 1);
    mip_write_u16(w, &v->dynamics_mode, 1);
    mip_write_u16(w, &v->status_flags, 1);
}

const struct mip_codec mip_filter_data_status_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_status),
    0, /* time-out */
    read_status,
    write_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_status_decode(struct mip_filter_data_status *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_status, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_status_encode(const struct mip_filter_data_status *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_STATUS_DESCRIPTOR, write_status, value);
}

static void read_timestamp(struct mip_reader *r, void *value) {
    struct mip_filter_data_timestamp *v = (struct mip_filter_data_timestamp *)value;
    mip_read_double(r, &v->tow, 1);
    mip_read_u16(r, &v->week_number, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_timestamp(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_timestamp *v = (const struct mip_filter_data_timestamp *)value;
    mip_write_double(w, &v->tow, 1);
    mip_write_u16(w, &v->week_number, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_timestamp_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_TIMESTAMP_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_timestamp),
    0, /* time-out */
    read_timestamp,
    write_timestamp,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_timestamp_decode(struct mip_filter_data_timestamp *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_timestamp, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_timestamp_encode(const struct mip_filter_data_timestamp *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_TIMESTAMP_DESCRIPTOR, write_timestamp,
                            value);
}

static void read_quaternion_attitude_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_quaternion_attitude_uncertainty *v =
        (struct mip_filter_data_quaternion_attitude_uncertainty *)value;
    mip_read_float(r, v->q, 4);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_quaternion_attitude_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_quaternion_attitude_uncertainty *v =
        (const struct mip_filter_data_quaternion_attitude_uncertainty *)value;
    mip_write_float(w, v->q, 4);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_quaternion_attitude_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_QUATERNION_ATTITUDE_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_quaternion_attitude_uncertainty),
    0, /* time-out */
    read_quaternion_attitude_uncertainty,
    write_quaternion_attitude_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_quaternion_attitude_uncertainty_decode(
    struct mip_filter_data_quaternion_attitude_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_quaternion_attitude_uncertainty, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_data_quaternion_attitude_uncertainty_encode(
    const struct mip_filter_data_quaternion_attitude_uncertainty *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82,
                            MIP_FILTER_DATA_QUATERNION_ATTITUDE_UNCERTAINTY_DESCRIPTOR,
                            write_quaternion_attitude_uncertainty, value);
}

static void read_gravity_vector(struct mip_reader *r, void *value) {
    struct mip_filter_data_gravity_vector *v = (struct mip_filter_data_gravity_vector *)value;
    mip_read_float(r, v->gravity, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gravity_vector(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gravity_vector *v =
        (const struct mip_filter_data_gravity_vector *)value;
    mip_write_float(w, v->gravity, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_gravity_vector_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GRAVITY_VECTOR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gravity_vector),
    0, /* time-out */
    read_gravity_vector,
    write_gravity_vector,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gravity_vector_decode(struct mip_filter_data_gravity_vector *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_gravity_vector, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gravity_vector_encode(const struct mip_filter_data_gravity_vector *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GRAVITY_VECTOR_DESCRIPTOR,
                            write_gravity_vector, value);
}

static void read_heading_update_state(struct mip_reader *r, void *value) {
    struct mip_filter_data_heading_update_state *v =
        (struct mip_filter_data_heading_update_state *)value;
    mip_read_float(r, &v->heading, 1);
    mip_read_float(r, &v->heading_uncertainty, 1);
    mip_read_u16(r, &v->source, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_heading_update_state(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_heading_update_state *v =
        (const struct mip_filter_data_heading_update_state *)value;
    mip_write_float(w, &v->heading, 1);
    mip_write_float(w, &v->heading_uncertainty, 1);
    mip_write_u16(w, &v->source, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_heading_update_state_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_HEADING_UPDATE_STATE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_heading_update_state),
    0, /* time-out */
    read_heading_update_state,
    write_heading_update_state,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_heading_update_state_decode(
    struct mip_filter_data_heading_update_state *value, const struct mip_field *field) {
    return mip_decode_field(field, read_heading_update_state, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_heading_update_state_encode(
    const struct mip_filter_data_heading_update_state *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_HEADING_UPDATE_STATE_DESCRIPTOR,
                            write_heading_update_state, value);
}

static void read_magnetic_model(struct mip_reader *r, void *value) {
    struct mip_filter_data_magnetic_model *v = (struct mip_filter_data_magnetic_model *)value;
    mip_read_float(r, &v->intensity_north, 1);
    mip_read_float(r, &v->intensity_east, 1);
    mip_read_float(r, &v->intensity_down, 1);
    mip_read_float(r, &v->inclination, 1);
    mip_read_float(r, &v->declination, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_magnetic_model(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_magnetic_model *v =
        (const struct mip_filter_data_magnetic_model *)value;
    mip_write_float(w, &v->intensity_north, 1);
    mip_write_float(w, &v->intensity_east, 1);
    mip_write_float(w, &v->intensity_down, 1);
    mip_write_float(w, &v->inclination, 1);
    mip_write_float(w, &v->declination, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_magnetic_model_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAGNETIC_MODEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_magnetic_model),
    0, /* time-out */
    read_magnetic_model,
    write_magnetic_model,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_magnetic_model_decode(struct mip_filter_data_magnetic_model *value,
                                                const struct mip_field *field) {
    return mip_decode_field(field, read_magnetic_model, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_magnetic_model_encode(const struct mip_filter_data_magnetic_model *value,
                                                struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAGNETIC_MODEL_DESCRIPTOR,
                            write_magnetic_model, value);
}

static void read_gyro_scale_factor(struct mip_reader *r, void *value) {
    struct mip_filter_data_gyro_scale_factor *v = (struct mip_filter_data_gyro_scale_factor *)value;
    mip_read_float(r, v->scale_factor, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gyro_scale_factor(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gyro_scale_factor *v =
        (const struct mip_filter_data_gyro_scale_factor *)value;
    mip_write_float(w, v->scale_factor, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_gyro_scale_factor_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GYRO_SCALE_FACTOR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gyro_scale_factor),
    0, /* time-out */
    read_gyro_scale_factor,
    write_gyro_scale_factor,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gyro_scale_factor_decode(struct mip_filter_data_gyro_scale_factor *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_scale_factor, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gyro_scale_factor_encode(
    const struct mip_filter_data_gyro_scale_factor *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GYRO_SCALE_FACTOR_DESCRIPTOR,
                            write_gyro_scale_factor, value);
}

static void read_accel_scale_factor(struct mip_reader *r, void *value) {
    struct mip_filter_data_accel_scale_factor *v =
        (struct mip_filter_data_accel_scale_factor *)value;
    mip_read_float(r, v->scale_factor, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_accel_scale_factor(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_accel_scale_factor *v =
        (const struct mip_filter_data_accel_scale_factor *)value;
    mip_write_float(w, v->scale_factor, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_accel_scale_factor_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_accel_scale_factor),
    0, /* time-out */
    read_accel_scale_factor,
    write_accel_scale_factor,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_accel_scale_factor_decode(
    struct mip_filter_data_accel_scale_factor *value, const struct mip_field *field) {
    return mip_decode_field(field, read_accel_scale_factor, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_accel_scale_factor_encode(
    const struct mip_filter_data_accel_scale_factor *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_DESCRIPTOR,
                            write_accel_scale_factor, value);
}

static void read_gyro_scale_factor_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_gyro_scale_factor_uncertainty *v =
        (struct mip_filter_data_gyro_scale_factor_uncertainty *)value;
    mip_read_float(r, v->scale_factor_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gyro_scale_factor_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gyro_scale_factor_uncertainty *v =
        (const struct mip_filter_data_gyro_scale_factor_uncertainty *)value;
    mip_write_float(w, v->scale_factor_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_gyro_scale_factor_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GYRO_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gyro_scale_factor_uncertainty),
    0, /* time-out */
    read_gyro_scale_factor_uncertainty,
    write_gyro_scale_factor_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gyro_scale_factor_uncertainty_decode(
    struct mip_filter_data_gyro_scale_factor_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gyro_scale_factor_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gyro_scale_factor_uncertainty_encode(
    const struct mip_filter_data_gyro_scale_factor_uncertainty *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GYRO_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR,
                            write_gyro_scale_factor_uncertainty, value);
}

static void read_accel_scale_factor_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_accel_scale_factor_uncertainty *v =
        (struct mip_filter_data_accel_scale_factor_uncertainty *)value;
    mip_read_float(r, v->scale_factor_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_accel_scale_factor_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_accel_scale_factor_uncertainty *v =
        (const struct mip_filter_data_accel_scale_factor_uncertainty *)value;
    mip_write_float(w, v->scale_factor_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_accel_scale_factor_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_accel_scale_factor_uncertainty),
    0, /* time-out */
    read_accel_scale_factor_uncertainty,
    write_accel_scale_factor_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_accel_scale_factor_uncertainty_decode(
    struct mip_filter_data_accel_scale_factor_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_accel_scale_factor_uncertainty, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_data_accel_scale_factor_uncertainty_encode(
    const struct mip_filter_data_accel_scale_factor_uncertainty *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82,
                            MIP_FILTER_DATA_ACCEL_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR,
                            write_accel_scale_factor_uncertainty, value);
}

static void read_mag_bias(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_bias *v = (struct mip_filter_data_mag_bias *)value;
    mip_read_float(r, v->bias, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_bias(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_bias *v = (const struct mip_filter_data_mag_bias *)value;
    mip_write_float(w, v->bias, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_bias_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_BIAS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_bias),
    0, /* time-out */
    read_mag_bias,
    write_mag_bias,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_bias_decode(struct mip_filter_data_mag_bias *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, read_mag_bias, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_bias_encode(const struct mip_filter_data_mag_bias *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_BIAS_DESCRIPTOR, write_mag_bias,
                            value);
}

static void read_mag_bias_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_bias_uncertainty *v =
        (struct mip_filter_data_mag_bias_uncertainty *)value;
    mip_read_float(r, v->bias_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_bias_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_bias_uncertainty *v =
        (const struct mip_filter_data_mag_bias_uncertainty *)value;
    mip_write_float(w, v->bias_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_bias_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_BIAS_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_bias_uncertainty),
    0, /* time-out */
    read_mag_bias_uncertainty,
    write_mag_bias_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_bias_uncertainty_decode(
    struct mip_filter_data_mag_bias_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_bias_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_bias_uncertainty_encode(
    const struct mip_filter_data_mag_bias_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_BIAS_UNCERTAINTY_DESCRIPTOR,
                            write_mag_bias_uncertainty, value);
}

static void read_comp_accel(struct mip_reader *r, void *value) {
    struct mip_filter_data_comp_accel *v = (struct mip_filter_data_comp_accel *)value;
    mip_read_float(r, v->accel, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_comp_accel(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_comp_accel *v = (const struct mip_filter_data_comp_accel *)value;
    mip_write_float(w, v->accel, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_comp_accel_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_COMP_ACCEL_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_comp_accel),
    0, /* time-out */
    read_comp_accel,
    write_comp_accel,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_comp_accel_decode(struct mip_filter_data_comp_accel *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_comp_accel, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_comp_accel_encode(const struct mip_filter_data_comp_accel *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_COMP_ACCEL_DESCRIPTOR, write_comp_accel,
                            value);
}

static void read_standard_atmosphere(struct mip_reader *r, void *value) {
    struct mip_filter_data_standard_atmosphere *v =
        (struct mip_filter_data_standard_atmosphere *)value;
    mip_read_float(r, &v->geometric_altitude, 1);
    mip_read_float(r, &v->geopotential_altitude, 1);
    mip_read_float(r, &v->standard_temperature, 1);
    mip_read_float(r, &v->standard_pressure, 1);
    mip_read_float(r, &v->standard_density, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_standard_atmosphere(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_standard_atmosphere *v =
        (const struct mip_filter_data_standard_atmosphere *)value;
    mip_write_float(w, &v->geometric_altitude, 1);
    mip_write_float(w, &v->geopotential_altitude, 1);
    mip_write_float(w, &v->standard_temperature, 1);
    mip_write_float(w, &v->standard_pressure, 1);
    mip_write_float(w, &v->standard_density, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_standard_atmosphere_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_STANDARD_ATMOSPHERE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_standard_atmosphere),
    0, /* time-out */
    read_standard_atmosphere,
    write_standard_atmosphere,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_standard_atmosphere_decode(
    struct mip_filter_data_standard_atmosphere *value, const struct mip_field *field) {
    return mip_decode_field(field, read_standard_atmosphere, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_standard_atmosphere_encode(
    const struct mip_filter_data_standard_atmosphere *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_STANDARD_ATMOSPHERE_DESCRIPTOR,
                            write_standard_atmosphere, value);
}

static void read_pressure_altitude(struct mip_reader *r, void *value) {
    struct mip_filter_data_pressure_altitude *v = (struct mip_filter_data_pressure_altitude *)value;
    mip_read_float(r, &v->pressure_altitude, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_pressure_altitude(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_pressure_altitude *v =
        (const struct mip_filter_data_pressure_altitude *)value;
    mip_write_float(w, &v->pressure_altitude, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_pressure_altitude_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_PRESSURE_ALTITUDE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_pressure_altitude),
    0, /* time-out */
    read_pressure_altitude,
    write_pressure_altitude,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_pressure_altitude_decode(struct mip_filter_data_pressure_altitude *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_pressure_altitude, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_pressure_altitude_encode(
    const struct mip_filter_data_pressure_altitude *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_PRESSURE_ALTITUDE_DESCRIPTOR,
                            write_pressure_altitude, value);
}

static void read_density_altitude(struct mip_reader *r, void *value) {
    struct mip_filter_data_density_altitude *v = (struct mip_filter_data_density_altitude *)value;
    mip_read_float(r, &v->density_altitude, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_density_altitude(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_density_altitude *v =
        (const struct mip_filter_data_density_altitude *)value;
    mip_write_float(w, &v->density_altitude, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_density_altitude_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_DENSITY_ALTITUDE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_density_altitude),
    0, /* time-out */
    read_density_altitude,
    write_density_altitude,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_density_altitude_decode(struct mip_filter_data_density_altitude *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_density_altitude, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_density_altitude_encode(
    const struct mip_filter_data_density_altitude *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_DENSITY_ALTITUDE_DESCRIPTOR,
                            write_density_altitude, value);
}

static void read_mag_offset(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_offset *v = (struct mip_filter_data_mag_offset *)value;
    mip_read_float(r, v->hard_iron, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_offset(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_offset *v = (const struct mip_filter_data_mag_offset *)value;
    mip_write_float(w, v->hard_iron, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_offset_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_OFFSET_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_offset),
    0, /* time-out */
    read_mag_offset,
    write_mag_offset,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_offset_decode(struct mip_filter_data_mag_offset *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_mag_offset, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_offset_encode(const struct mip_filter_data_mag_offset *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_OFFSET_DESCRIPTOR, write_mag_offset,
                            value);
}

static void read_mag_matrix(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_matrix *v = (struct mip_filter_data_mag_matrix *)value;
    mip_read_float(r, v->soft_iron, 9);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_matrix(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_matrix *v = (const struct mip_filter_data_mag_matrix *)value;
    mip_write_float(w, v->soft_iron, 9);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_matrix_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_MATRIX_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_matrix),
    0, /* time-out */
    read_mag_matrix,
    write_mag_matrix,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_matrix_decode(struct mip_filter_data_mag_matrix *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_mag_matrix, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_matrix_encode(const struct mip_filter_data_mag_matrix *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_MATRIX_DESCRIPTOR, write_mag_matrix,
                            value);
}

static void read_mag_offset_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_offset_uncertainty *v =
        (struct mip_filter_data_mag_offset_uncertainty *)value;
    mip_read_float(r, v->hard_iron_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_offset_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_offset_uncertainty *v =
        (const struct mip_filter_data_mag_offset_uncertainty *)value;
    mip_write_float(w, v->hard_iron_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_offset_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_OFFSET_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_offset_uncertainty),
    0, /* time-out */
    read_mag_offset_uncertainty,
    write_mag_offset_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_offset_uncertainty_decode(
    struct mip_filter_data_mag_offset_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_offset_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_offset_uncertainty_encode(
    const struct mip_filter_data_mag_offset_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_OFFSET_UNCERTAINTY_DESCRIPTOR,
                            write_mag_offset_uncertainty, value);
}

static void read_mag_matrix_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_matrix_uncertainty *v =
        (struct mip_filter_data_mag_matrix_uncertainty *)value;
    mip_read_float(r, v->soft_iron_uncertainty, 9);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_matrix_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_matrix_uncertainty *v =
        (const struct mip_filter_data_mag_matrix_uncertainty *)value;
    mip_write_float(w, v->soft_iron_uncertainty, 9);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_matrix_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_MATRIX_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_matrix_uncertainty),
    0, /* time-out */
    read_mag_matrix_uncertainty,
    write_mag_matrix_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_matrix_uncertainty_decode(
    struct mip_filter_data_mag_matrix_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_matrix_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_matrix_uncertainty_encode(
    const struct mip_filter_data_mag_matrix_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_MATRIX_UNCERTAINTY_DESCRIPTOR,
                            write_mag_matrix_uncertainty, value);
}

static void read_mag_covariance_matrix(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_covariance_matrix *v =
        (struct mip_filter_data_mag_covariance_matrix *)value;
    mip_read_float(r, v->covariance, 9);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_covariance_matrix(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_covariance_matrix *v =
        (const struct mip_filter_data_mag_covariance_matrix *)value;
    mip_write_float(w, v->covariance, 9);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_covariance_matrix_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_COVARIANCE_MATRIX_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_covariance_matrix),
    0, /* time-out */
    read_mag_covariance_matrix,
    write_mag_covariance_matrix,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_covariance_matrix_decode(
    struct mip_filter_data_mag_covariance_matrix *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_covariance_matrix, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_covariance_matrix_encode(
    const struct mip_filter_data_mag_covariance_matrix *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_COVARIANCE_MATRIX_DESCRIPTOR,
                            write_mag_covariance_matrix, value);
}

static void read_mag_residual_vector(struct mip_reader *r, void *value) {
    struct mip_filter_data_mag_residual_vector *v =
        (struct mip_filter_data_mag_residual_vector *)value;
    mip_read_float(r, v->residual, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_mag_residual_vector(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_mag_residual_vector *v =
        (const struct mip_filter_data_mag_residual_vector *)value;
    mip_write_float(w, v->residual, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_mag_residual_vector_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MAG_RESIDUAL_VECTOR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_mag_residual_vector),
    0, /* time-out */
    read_mag_residual_vector,
    write_mag_residual_vector,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_mag_residual_vector_decode(
    struct mip_filter_data_mag_residual_vector *value, const struct mip_field *field) {
    return mip_decode_field(field, read_mag_residual_vector, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_mag_residual_vector_encode(
    const struct mip_filter_data_mag_residual_vector *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_MAG_RESIDUAL_VECTOR_DESCRIPTOR,
                            write_mag_residual_vector, value);
}

static void read_antenna_offset_correction(struct mip_reader *r, void *value) {
    struct mip_filter_data_antenna_offset_correction *v =
        (struct mip_filter_data_antenna_offset_correction *)value;
    mip_read_float(r, v->offset, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_antenna_offset_correction(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_antenna_offset_correction *v =
        (const struct mip_filter_data_antenna_offset_correction *)value;
    mip_write_float(w, v->offset, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_antenna_offset_correction_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_antenna_offset_correction),
    0, /* time-out */
    read_antenna_offset_correction,
    write_antenna_offset_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_antenna_offset_correction_decode(
    struct mip_filter_data_antenna_offset_correction *value, const struct mip_field *field) {
    return mip_decode_field(field, read_antenna_offset_correction, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_antenna_offset_correction_encode(
    const struct mip_filter_data_antenna_offset_correction *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ANTENNA_OFFSET_CORRECTION_DESCRIPTOR,
                            write_antenna_offset_correction, value);
}

static void read_antenna_offset_correction_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_antenna_offset_uncertainty *v =
        (struct mip_filter_data_antenna_offset_uncertainty *)value;
    mip_read_float(r, v->offset_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_antenna_offset_correction_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_antenna_offset_uncertainty *v =
        (const struct mip_filter_data_antenna_offset_uncertainty *)value;
    mip_write_float(w, v->offset_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_antenna_offset_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ANTENNA_OFFSET_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_antenna_offset_uncertainty),
    0, /* time-out */
    read_antenna_offset_correction_uncertainty,
    write_antenna_offset_correction_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_antenna_offset_uncertainty_decode(
    struct mip_filter_data_antenna_offset_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_antenna_offset_correction_uncertainty, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_data_antenna_offset_uncertainty_encode(
    const struct mip_filter_data_antenna_offset_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ANTENNA_OFFSET_UNCERTAINTY_DESCRIPTOR,
                            write_antenna_offset_correction_uncertainty, value);
}

static void read_clock_correction(struct mip_reader *r, void *value) {
    struct mip_filter_data_clock_correction *v = (struct mip_filter_data_clock_correction *)value;
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_float(r, &v->bias, 1);
    mip_read_float(r, &v->bias_drift, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_clock_correction(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_clock_correction *v =
        (const struct mip_filter_data_clock_correction *)value;
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_float(w, &v->bias, 1);
    mip_write_float(w, &v->bias_drift, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_clock_correction_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_CLOCK_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_clock_correction),
    0, /* time-out */
    read_clock_correction,
    write_clock_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_clock_correction_decode(struct mip_filter_data_clock_correction *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_clock_correction, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_clock_correction_encode(
    const struct mip_filter_data_clock_correction *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_CLOCK_CORRECTION_DESCRIPTOR,
                            write_clock_correction, value);
}

static void read_clock_correction_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_clock_correction_uncertainty *v =
        (struct mip_filter_data_clock_correction_uncertainty *)value;
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_float(r, &v->bias_uncertainty, 1);
    mip_read_float(r, &v->bias_drift_uncertainty, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_clock_correction_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_clock_correction_uncertainty *v =
        (const struct mip_filter_data_clock_correction_uncertainty *)value;
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_float(w, &v->bias_uncertainty, 1);
    mip_write_float(w, &v->bias_drift_uncertainty, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_clock_correction_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_CLOCK_CORRECTION_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_clock_correction_uncertainty),
    0, /* time-out */
    read_clock_correction_uncertainty,
    write_clock_correction_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_clock_correction_uncertainty_decode(
    struct mip_filter_data_clock_correction_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_clock_correction_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_clock_correction_uncertainty_encode(
    const struct mip_filter_data_clock_correction_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_CLOCK_CORRECTION_UNCERTAINTY_DESCRIPTOR,
                            write_clock_correction_uncertainty, value);
}

static void read_multi_antenna_offset_correction(struct mip_reader *r, void *value) {
    struct mip_filter_data_multi_antenna_offset_correction *v =
        (struct mip_filter_data_multi_antenna_offset_correction *)value;
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_float(r, v->offset, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_multi_antenna_offset_correction(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_multi_antenna_offset_correction *v =
        (const struct mip_filter_data_multi_antenna_offset_correction *)value;
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_float(w, v->offset, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_multi_antenna_offset_correction_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_CORRECTION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_multi_antenna_offset_correction),
    0, /* time-out */
    read_multi_antenna_offset_correction,
    write_multi_antenna_offset_correction,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_multi_antenna_offset_correction_decode(
    struct mip_filter_data_multi_antenna_offset_correction *value, const struct mip_field *field) {
    return mip_decode_field(field, read_multi_antenna_offset_correction, value, sizeof(*value),
                            NULL);
}

mip_error mip_filter_data_multi_antenna_offset_correction_encode(
    const struct mip_filter_data_multi_antenna_offset_correction *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82,
                            MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_CORRECTION_DESCRIPTOR,
                            write_multi_antenna_offset_correction, value);
}

static void read_multi_antenna_offset_correction_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_multi_antenna_offset_uncertainty *v =
        (struct mip_filter_data_multi_antenna_offset_uncertainty *)value;
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_float(r, v->offset_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_multi_antenna_offset_correction_uncertainty(struct mip_writer *w,
                                                              const void *value) {
    const struct mip_filter_data_multi_antenna_offset_uncertainty *v =
        (const struct mip_filter_data_multi_antenna_offset_uncertainty *)value;
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_float(w, v->offset_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_multi_antenna_offset_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_multi_antenna_offset_uncertainty),
    0, /* time-out */
    read_multi_antenna_offset_correction_uncertainty,
    write_multi_antenna_offset_correction_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_multi_antenna_offset_uncertainty_decode(
    struct mip_filter_data_multi_antenna_offset_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_multi_antenna_offset_correction_uncertainty, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_data_multi_antenna_offset_uncertainty_encode(
    const struct mip_filter_data_multi_antenna_offset_uncertainty *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82,
                            MIP_FILTER_DATA_MULTI_ANTENNA_OFFSET_UNCERTAINTY_DESCRIPTOR,
                            write_multi_antenna_offset_correction_uncertainty, value);
}

static void read_ecef_position_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_ecef_position_uncertainty *v =
        (struct mip_filter_data_ecef_position_uncertainty *)value;
    mip_read_float(r, v->position_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_position_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ecef_position_uncertainty *v =
        (const struct mip_filter_data_ecef_position_uncertainty *)value;
    mip_write_float(w, v->position_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ecef_position_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ECEF_POSITION_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ecef_position_uncertainty),
    0, /* time-out */
    read_ecef_position_uncertainty,
    write_ecef_position_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ecef_position_uncertainty_decode(
    struct mip_filter_data_ecef_position_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_position_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ecef_position_uncertainty_encode(
    const struct mip_filter_data_ecef_position_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ECEF_POSITION_UNCERTAINTY_DESCRIPTOR,
                            write_ecef_position_uncertainty, value);
}

static void read_ecef_velocity_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_ecef_velocity_uncertainty *v =
        (struct mip_filter_data_ecef_velocity_uncertainty *)value;
    mip_read_float(r, v->velocity_uncertainty, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_velocity_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ecef_velocity_uncertainty *v =
        (const struct mip_filter_data_ecef_velocity_uncertainty *)value;
    mip_write_float(w, v->velocity_uncertainty, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ecef_velocity_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ECEF_VELOCITY_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ecef_velocity_uncertainty),
    0, /* time-out */
    read_ecef_velocity_uncertainty,
    write_ecef_velocity_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ecef_velocity_uncertainty_decode(
    struct mip_filter_data_ecef_velocity_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_velocity_uncertainty, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ecef_velocity_uncertainty_encode(
    const struct mip_filter_data_ecef_velocity_uncertainty *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ECEF_VELOCITY_UNCERTAINTY_DESCRIPTOR,
                            write_ecef_velocity_uncertainty, value);
}

static void read_ecef_position(struct mip_reader *r, void *value) {
    struct mip_filter_data_ecef_position *v = (struct mip_filter_data_ecef_position *)value;
    mip_read_double(r, v->position, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_position(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ecef_position *v =
        (const struct mip_filter_data_ecef_position *)value;
    mip_write_double(w, v->position, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ecef_position_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ECEF_POSITION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ecef_position),
    0, /* time-out */
    read_ecef_position,
    write_ecef_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ecef_position_decode(struct mip_filter_data_ecef_position *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_position, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ecef_position_encode(const struct mip_filter_data_ecef_position *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ECEF_POSITION_DESCRIPTOR,
                            write_ecef_position, value);
}

static void read_ecef_velocity(struct mip_reader *r, void *value) {
    struct mip_filter_data_ecef_velocity *v = (struct mip_filter_data_ecef_velocity *)value;
    mip_read_float(r, v->velocity, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ecef_velocity(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ecef_velocity *v =
        (const struct mip_filter_data_ecef_velocity *)value;
    mip_write_float(w, v->velocity, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ecef_velocity_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ECEF_VELOCITY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ecef_velocity),
    0, /* time-out */
    read_ecef_velocity,
    write_ecef_velocity,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ecef_velocity_decode(struct mip_filter_data_ecef_velocity *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_ecef_velocity, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ecef_velocity_encode(const struct mip_filter_data_ecef_velocity *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ECEF_VELOCITY_DESCRIPTOR,
                            write_ecef_velocity, value);
}

static void read_ned_relative_position(struct mip_reader *r, void *value) {
    struct mip_filter_data_ned_relative_position *v =
        (struct mip_filter_data_ned_relative_position *)value;
    mip_read_double(r, v->relative_position, 3);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_ned_relative_position(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_ned_relative_position *v =
        (const struct mip_filter_data_ned_relative_position *)value;
    mip_write_double(w, v->relative_position, 3);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_ned_relative_position_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_NED_RELATIVE_POSITION_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_ned_relative_position),
    0, /* time-out */
    read_ned_relative_position,
    write_ned_relative_position,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_ned_relative_position_decode(
    struct mip_filter_data_ned_relative_position *value, const struct mip_field *field) {
    return mip_decode_field(field, read_ned_relative_position, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_ned_relative_position_encode(
    const struct mip_filter_data_ned_relative_position *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_NED_RELATIVE_POSITION_DESCRIPTOR,
                            write_ned_relative_position, value);
}

static void read_gnss_position_aiding_status(struct mip_reader *r, void *value) {
    struct mip_filter_data_gnss_position_aiding_status *v =
        (struct mip_filter_data_gnss_position_aiding_status *)value;
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_float(r, &v->tow, 1);
    mip_read_u16(r, &v->status, 1);
    mip_read_u8(r, v->reserved, 8);
}

static void write_gnss_position_aiding_status(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gnss_position_aiding_status *v =
        (const struct mip_filter_data_gnss_position_aiding_status *)value;
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_float(w, &v->tow, 1);
    mip_write_u16(w, &v->status, 1);
    mip_write_u8(w, v->reserved, 8);
}

const struct mip_codec mip_filter_data_gnss_position_aiding_status_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GNSS_POSITION_AIDING_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gnss_position_aiding_status),
    0, /* time-out */
    read_gnss_position_aiding_status,
    write_gnss_position_aiding_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gnss_position_aiding_status_decode(
    struct mip_filter_data_gnss_position_aiding_status *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_position_aiding_status, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gnss_position_aiding_status_encode(
    const struct mip_filter_data_gnss_position_aiding_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GNSS_POSITION_AIDING_STATUS_DESCRIPTOR,
                            write_gnss_position_aiding_status, value);
}

static void read_gnss_attitude_aiding_status(struct mip_reader *r, void *value) {
    struct mip_filter_data_gnss_attitude_aiding_status *v =
        (struct mip_filter_data_gnss_attitude_aiding_status *)value;
    mip_read_float(r, &v->tow, 1);
    mip_read_u16(r, &v->status, 1);
    mip_read_u8(r, v->reserved, 8);
}

static void write_gnss_attitude_aiding_status(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gnss_attitude_aiding_status *v =
        (const struct mip_filter_data_gnss_attitude_aiding_status *)value;
    mip_write_float(w, &v->tow, 1);
    mip_write_u16(w, &v->status, 1);
    mip_write_u8(w, v->reserved, 8);
}

const struct mip_codec mip_filter_data_gnss_attitude_aiding_status_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GNSS_ATTITUDE_AIDING_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gnss_attitude_aiding_status),
    0, /* time-out */
    read_gnss_attitude_aiding_status,
    write_gnss_attitude_aiding_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gnss_attitude_aiding_status_decode(
    struct mip_filter_data_gnss_attitude_aiding_status *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_attitude_aiding_status, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gnss_attitude_aiding_status_encode(
    const struct mip_filter_data_gnss_attitude_aiding_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GNSS_ATTITUDE_AIDING_STATUS_DESCRIPTOR,
                            write_gnss_attitude_aiding_status, value);
}

static void read_heading_aiding_status(struct mip_reader *r, void *value) {
    struct mip_filter_data_heading_aiding_status *v =
        (struct mip_filter_data_heading_aiding_status *)value;
    mip_read_float(r, &v->tow, 1);
    mip_read_u8(r, &v->type, 1);
    mip_read_float(r, v->reserved, 2);
}

static void write_heading_aiding_status(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_heading_aiding_status *v =
        (const struct mip_filter_data_heading_aiding_status *)value;
    mip_write_float(w, &v->tow, 1);
    mip_write_u8(w, &v->type, 1);
    mip_write_float(w, v->reserved, 2);
}

const struct mip_codec mip_filter_data_heading_aiding_status_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_HEADING_AIDING_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_heading_aiding_status),
    0, /* time-out */
    read_heading_aiding_status,
    write_heading_aiding_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_heading_aiding_status_decode(
    struct mip_filter_data_heading_aiding_status *value, const struct mip_field *field) {
    return mip_decode_field(field, read_heading_aiding_status, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_heading_aiding_status_encode(
    const struct mip_filter_data_heading_aiding_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_HEADING_AIDING_STATUS_DESCRIPTOR,
                            write_heading_aiding_status, value);
}

static void read_aiding_measurement_summary(struct mip_reader *r, void *value) {
    struct mip_filter_data_aiding_measurement_summary *v =
        (struct mip_filter_data_aiding_measurement_summary *)value;
    mip_read_float(r, &v->tow, 1);
    mip_read_u8(r, &v->source, 1);
    mip_read_u8(r, &v->type, 1);
    mip_read_u8(r, &v->indicator, 1);
}

static void write_aiding_measurement_summary(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_aiding_measurement_summary *v =
        (const struct mip_filter_data_aiding_measurement_summary *)value;
    mip_write_float(w, &v->tow, 1);
    mip_write_u8(w, &v->source, 1);
    mip_write_u8(w, &v->type, 1);
    mip_write_u8(w, &v->indicator, 1);
}

const struct mip_codec mip_filter_data_aiding_measurement_summary_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_AIDING_MEASUREMENT_SUMMARY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_aiding_measurement_summary),
    0, /* time-out */
    read_aiding_measurement_summary,
    write_aiding_measurement_summary,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_aiding_measurement_summary_decode(
    struct mip_filter_data_aiding_measurement_summary *value, const struct mip_field *field) {
    return mip_decode_field(field, read_aiding_measurement_summary, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_aiding_measurement_summary_encode(
    const struct mip_filter_data_aiding_measurement_summary *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_AIDING_MEASUREMENT_SUMMARY_DESCRIPTOR,
                            write_aiding_measurement_summary, value);
}

static void read_odometer_scale_factor_error(struct mip_reader *r, void *value) {
    struct mip_filter_data_odometer_scale_factor_error *v =
        (struct mip_filter_data_odometer_scale_factor_error *)value;
    mip_read_float(r, &v->scale_factor_error, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_odometer_scale_factor_error(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_odometer_scale_factor_error *v =
        (const struct mip_filter_data_odometer_scale_factor_error *)value;
    mip_write_float(w, &v->scale_factor_error, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_odometer_scale_factor_error_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_odometer_scale_factor_error),
    0, /* time-out */
    read_odometer_scale_factor_error,
    write_odometer_scale_factor_error,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_odometer_scale_factor_error_decode(
    struct mip_filter_data_odometer_scale_factor_error *value, const struct mip_field *field) {
    return mip_decode_field(field, read_odometer_scale_factor_error, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_odometer_scale_factor_error_encode(
    const struct mip_filter_data_odometer_scale_factor_error *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_ERROR_DESCRIPTOR,
                            write_odometer_scale_factor_error, value);
}

static void read_odometer_scale_factor_error_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_odometer_scale_factor_uncertainty *v =
        (struct mip_filter_data_odometer_scale_factor_uncertainty *)value;
    mip_read_float(r, &v->scale_factor_error_uncertainty, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_odometer_scale_factor_error_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_odometer_scale_factor_uncertainty *v =
        (const struct mip_filter_data_odometer_scale_factor_uncertainty *)value;
    mip_write_float(w, &v->scale_factor_error_uncertainty, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_odometer_scale_factor_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_odometer_scale_factor_uncertainty),
    0, /* time-out */
    read_odometer_scale_factor_error_uncertainty,
    write_odometer_scale_factor_error_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_odometer_scale_factor_uncertainty_decode(
    struct mip_filter_data_odometer_scale_factor_uncertainty *value,
    const struct mip_field *field) {
    return mip_decode_field(field, read_odometer_scale_factor_error_uncertainty, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_data_odometer_scale_factor_uncertainty_encode(
    const struct mip_filter_data_odometer_scale_factor_uncertainty *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82,
                            MIP_FILTER_DATA_ODOMETER_SCALE_FACTOR_UNCERTAINTY_DESCRIPTOR,
                            write_odometer_scale_factor_error_uncertainty, value);
}

static void read_gnss_dual_antenna_status(struct mip_reader *r, void *value) {
    struct mip_filter_data_gnss_dual_antenna_status *v =
        (struct mip_filter_data_gnss_dual_antenna_status *)value;
    mip_read_float(r, &v->tow, 1);
    mip_read_float(r, &v->heading, 1);
    mip_read_float(r, &v->heading_uncertainty, 1);
    mip_read_u8(r, &v->fix_type, 1);
    mip_read_u16(r, &v->status_flags, 1);
    mip_read_u16(r, &v->valid_flags, 1);
}

static void write_gnss_dual_antenna_status(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_gnss_dual_antenna_status *v =
        (const struct mip_filter_data_gnss_dual_antenna_status *)value;
    mip_write_float(w, &v->tow, 1);
    mip_write_float(w, &v->heading, 1);
    mip_write_float(w, &v->heading_uncertainty, 1);
    mip_write_u8(w, &v->fix_type, 1);
    mip_write_u16(w, &v->status_flags, 1);
    mip_write_u16(w, &v->valid_flags, 1);
}

const struct mip_codec mip_filter_data_gnss_dual_antenna_status_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_GNSS_DUAL_ANTENNA_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_gnss_dual_antenna_status),
    0, /* time-out */
    read_gnss_dual_antenna_status,
    write_gnss_dual_antenna_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_gnss_dual_antenna_status_decode(
    struct mip_filter_data_gnss_dual_antenna_status *value, const struct mip_field *field) {
    return mip_decode_field(field, read_gnss_dual_antenna_status, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_gnss_dual_antenna_status_encode(
    const struct mip_filter_data_gnss_dual_antenna_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_GNSS_DUAL_ANTENNA_STATUS_DESCRIPTOR,
                            write_gnss_dual_antenna_status, value);
}

static void read_aiding_frame_config_error(struct mip_reader *r, void *value) {
    struct mip_filter_data_aiding_frame_config_error *v =
        (struct mip_filter_data_aiding_frame_config_error *)value;
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, v->translation, 3);
    mip_read_float(r, v->attitude, 4);
}

static void write_aiding_frame_config_error(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_aiding_frame_config_error *v =
        (const struct mip_filter_data_aiding_frame_config_error *)value;
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, v->translation, 3);
    mip_write_float(w, v->attitude, 4);
}

const struct mip_codec mip_filter_data_aiding_frame_config_error_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_aiding_frame_config_error),
    0, /* time-out */
    read_aiding_frame_config_error,
    write_aiding_frame_config_error,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_aiding_frame_config_error_decode(
    struct mip_filter_data_aiding_frame_config_error *value, const struct mip_field *field) {
    return mip_decode_field(field, read_aiding_frame_config_error, value, sizeof(*value), NULL);
}

mip_error mip_filter_data_aiding_frame_config_error_encode(
    const struct mip_filter_data_aiding_frame_config_error *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82, MIP_FILTER_DATA_AIDING_FRAME_CONFIG_ERROR_DESCRIPTOR,
                            write_aiding_frame_config_error, value);
}

static void read_aiding_frame_config_error_uncertainty(struct mip_reader *r, void *value) {
    struct mip_filter_data_aiding_frame_error_uncertainty *v =
        (struct mip_filter_data_aiding_frame_error_uncertainty *)value;
    mip_read_u8(r, &v->frame_id, 1);
    mip_read_float(r, v->translation_uncertainty, 3);
    mip_read_float(r, v->attitude_uncertainty, 3);
}

static void write_aiding_frame_config_error_uncertainty(struct mip_writer *w, const void *value) {
    const struct mip_filter_data_aiding_frame_error_uncertainty *v =
        (const struct mip_filter_data_aiding_frame_error_uncertainty *)value;
    mip_write_u8(w, &v->frame_id, 1);
    mip_write_float(w, v->translation_uncertainty, 3);
    mip_write_float(w, v->attitude_uncertainty, 3);
}

const struct mip_codec mip_filter_data_aiding_frame_error_uncertainty_codec = {
    0x82, /* descriptor set */
    MIP_FILTER_DATA_AIDING_FRAME_ERROR_UNCERTAINTY_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_filter_data_aiding_frame_error_uncertainty),
    0, /* time-out */
    read_aiding_frame_config_error_uncertainty,
    write_aiding_frame_config_error_uncertainty,
    NULL,
    NULL,
    NULL,
};

mip_error mip_filter_data_aiding_frame_error_uncertainty_decode(
    struct mip_filter_data_aiding_frame_error_uncertainty *value, const struct mip_field *field) {
    return mip_decode_field(field, read_aiding_frame_config_error_uncertainty, value,
                            sizeof(*value), NULL);
}

mip_error mip_filter_data_aiding_frame_error_uncertainty_encode(
    const struct mip_filter_data_aiding_frame_error_uncertainty *value,
    struct mip_builder *builder) {
    return mip_encode_field(builder, 0x82,
                            MIP_FILTER_DATA_AIDING_FRAME_ERROR_UNCERTAINTY_DESCRIPTOR,
                            write_aiding_frame_config_error_uncertainty, value);
}
