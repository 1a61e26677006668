/* System data. */
#include "mip/system_data.h"

#include <string.h>

static void read_built_in_test(struct mip_reader *r, void *value) {
    struct mip_system_data_built_in_test *v = (struct mip_system_data_built_in_test *)value;
    mip_read_u8(r, v->result, 16);
}

static void write_built_in_test(struct mip_writer *w, const void *value) {
    const struct mip_system_data_built_in_test *v =
        (const struct mip_system_data_built_in_test *)value;
    mip_write_u8(w, v->result, 16);
}

const struct mip_codec mip_system_data_built_in_test_codec = {
    0xA0, /* descriptor set */
    MIP_SYSTEM_DATA_BUILT_IN_TEST_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_system_data_built_in_test),
    0, /* time-out */
    read_built_in_test,
    write_built_in_test,
    NULL,
    NULL,
    NULL,
};

mip_error mip_system_data_built_in_test_decode(struct mip_system_data_built_in_test *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_built_in_test, value, sizeof(*value), NULL);
}

mip_error mip_system_data_built_in_test_encode(const struct mip_system_data_built_in_test *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0xA0, MIP_SYSTEM_DATA_BUILT_IN_TEST_DESCRIPTOR,
                            write_built_in_test, value);
}

static void read_time_sync_status(struct mip_reader *r, void *value) {
    struct mip_system_data_time_sync_status *v = (struct mip_system_data_time_sync_status *)value;
    mip_read_bool(r, &v->time_sync, 1);
    mip_read_u8(r, &v->last_pps_received, 1);
}

static void write_time_sync_status(struct mip_writer *w, const void *value) {
    const struct mip_system_data_time_sync_status *v =
        (const struct mip_system_data_time_sync_status *)value;
    mip_write_bool(w, &v->time_sync, 1);
    mip_write_u8(w, &v->last_pps_received, 1);
}

const struct mip_codec mip_system_data_time_sync_status_codec = {
    0xA0, /* descriptor set */
    MIP_SYSTEM_DATA_TIME_SYNC_STATUS_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_system_data_time_sync_status),
    0, /* time-out */
    read_time_sync_status,
    write_time_sync_status,
    NULL,
    NULL,
    NULL,
};

mip_error mip_system_data_time_sync_status_decode(struct mip_system_data_time_sync_status *value,
                                                  const struct mip_field *field) {
    return mip_decode_field(field, read_time_sync_status, value, sizeof(*value), NULL);
}

mip_error mip_system_data_time_sync_status_encode(
    const struct mip_system_data_time_sync_status *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0xA0, MIP_SYSTEM_DATA_TIME_SYNC_STATUS_DESCRIPTOR,
                            write_time_sync_status, value);
}

static void read_gpio_state(struct mip_reader *r, void *value) {
    struct mip_system_data_gpio_state *v = (struct mip_system_data_gpio_state *)value;
    mip_read_u8(r, &v->states, 1);
}

static void write_gpio_state(struct mip_writer *w, const void *value) {
    const struct mip_system_data_gpio_state *v = (const struct mip_system_data_gpio_state *)value;
    mip_write_u8(w, &v->states, 1);
}

const struct mip_codec mip_system_data_gpio_state_codec = {
    0xA0, /* descriptor set */
    MIP_SYSTEM_DATA_GPIO_STATE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_system_data_gpio_state),
    0, /* time-out */
    read_gpio_state,
    write_gpio_state,
    NULL,
    NULL,
    NULL,
};

mip_error mip_system_data_gpio_state_decode(struct mip_system_data_gpio_state *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_gpio_state, value, sizeof(*value), NULL);
}

mip_error mip_system_data_gpio_state_encode(const struct mip_system_data_gpio_state *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0xA0, MIP_SYSTEM_DATA_GPIO_STATE_DESCRIPTOR, write_gpio_state,
                            value);
}

static void read_gpio_analog_value(struct mip_reader *r, void *value) {
    struct mip_system_data_gpio_analog_value *v = (struct mip_system_data_gpio_analog_value *)value;
    mip_read_u8(r, &v->gpio_id, 1);
    mip_read_float(r, &v->value, 1);
}

static void write_gpio_analog_value(struct mip_writer *w, const void *value) {
    const struct mip_system_data_gpio_analog_value *v =
        (const struct mip_system_data_gpio_analog_value *)value;
    mip_write_u8(w, &v->gpio_id, 1);
    mip_write_float(w, &v->value, 1);
}

const struct mip_codec mip_system_data_gpio_analog_value_codec = {
    0xA0, /* descriptor set */
    MIP_SYSTEM_DATA_GPIO_ANALOG_VALUE_DESCRIPTOR,
    MIP_DATA,
    sizeof(struct mip_system_data_gpio_analog_value),
    0, /* time-out */
    read_gpio_analog_value,
    write_gpio_analog_value,
    NULL,
    NULL,
    NULL,
};

mip_error mip_system_data_gpio_analog_value_decode(struct mip_system_data_gpio_analog_value *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_gpio_analog_value, value, sizeof(*value), NULL);
}

mip_error mip_system_data_gpio_analog_value_encode(
    const struct mip_system_data_gpio_analog_value *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0xA0, MIP_SYSTEM_DATA_GPIO_ANALOG_VALUE_DESCRIPTOR,
                            write_gpio_analog_value, value);
}
