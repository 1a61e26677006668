/* GNSS commands. */
#include "mip/gnss.h"

#include <string.h>

void mip_gnss_receiver_info_entry_read(struct mip_reader *r,
                                       struct mip_gnss_receiver_info_entry *v) {
    mip_read_u8(r, &v->receiver_id, 1);
    mip_read_u8(r, &v->mip_data_descriptor_set, 1);
    mip_read_char(r, v->description, 32);
}

void mip_gnss_receiver_info_entry_write(struct mip_writer *w,
                                        const struct mip_gnss_receiver_info_entry *v) {
    mip_write_u8(w, &v->receiver_id, 1);
    mip_write_u8(w, &v->mip_data_descriptor_set, 1);
    mip_write_char(w, v->description, 32);
}

static const struct mip_response responses_receiver_info[] = {
    {&mip_gnss_receiver_info_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_gnss_receiver_info_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_RECEIVER_INFO_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_gnss_receiver_info),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_receiver_info,
    NULL,
};

mip_error mip_gnss_receiver_info_decode(struct mip_gnss_receiver_info *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_gnss_receiver_info_encode(const struct mip_gnss_receiver_info *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_RECEIVER_INFO_DESCRIPTOR, mip_write_nothing,
                            value);
}

static void read_receiver_info_response(struct mip_reader *r, void *value) {
    struct mip_gnss_receiver_info_response *v = (struct mip_gnss_receiver_info_response *)value;
    mip_read_u8(r, &v->num_receivers, 1);
    for (size_t i = 0, n = mip_read_count(r, v->num_receivers, 7, 34); i < n; i++) {
        mip_gnss_receiver_info_entry_read(r, &v->receiver_info[i]);
    }
}

static void write_receiver_info_response(struct mip_writer *w, const void *value) {
    const struct mip_gnss_receiver_info_response *v =
        (const struct mip_gnss_receiver_info_response *)value;
    mip_write_u8(w, &v->num_receivers, 1);
    for (size_t i = 0, n = mip_write_count(w, v->num_receivers, 7); i < n; i++) {
        mip_gnss_receiver_info_entry_write(w, &v->receiver_info[i]);
    }
}

const struct mip_codec mip_gnss_receiver_info_response_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_RECEIVER_INFO_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_gnss_receiver_info_response),
    0, /* time-out */
    read_receiver_info_response,
    write_receiver_info_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_receiver_info_response_decode(struct mip_gnss_receiver_info_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_receiver_info_response, value, sizeof(*value), NULL);
}

mip_error mip_gnss_receiver_info_response_encode(
    const struct mip_gnss_receiver_info_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_RECEIVER_INFO_RESPONSE_DESCRIPTOR,
                            write_receiver_info_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_signal_config[] = {0, 5, 0, 0, 0, 0};

static void read_signal_config(struct mip_reader *r, void *value) {
    struct mip_gnss_signal_config *v = (struct mip_gnss_signal_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_signal_config, sizeof(required_signal_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->gps_enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->glonass_enable, 1);
    mip_read_group(r, 3, 3);
    mip_read_u8(r, &v->galileo_enable, 1);
    mip_read_group(r, 4, 4);
    mip_read_u8(r, &v->beidou_enable, 1);
    mip_read_group(r, 5, 5);
    mip_read_u8(r, v->reserved, 4);
    v->present = mip_read_present(r);
}

static void write_signal_config(struct mip_writer *w, const void *value) {
    const struct mip_gnss_signal_config *v = (const struct mip_gnss_signal_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_signal_config, sizeof(required_signal_config),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->gps_enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->glonass_enable, 1);
    mip_write_group(w, 3, 3);
    mip_write_u8(w, &v->galileo_enable, 1);
    mip_write_group(w, 4, 4);
    mip_write_u8(w, &v->beidou_enable, 1);
    mip_write_group(w, 5, 5);
    mip_write_u8(w, v->reserved, 4);
}

static bool asked_signal_config_1(const void *value) {
    const struct mip_gnss_signal_config *v = (const struct mip_gnss_signal_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_signal_config[] = {
    {&mip_gnss_signal_config_response_codec, asked_signal_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_gnss_signal_config_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_SIGNAL_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_gnss_signal_config),
    0, /* time-out */
    read_signal_config,
    write_signal_config,
    NULL,
    responses_signal_config,
    NULL,
};

mip_error mip_gnss_signal_config_decode(struct mip_gnss_signal_config *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_signal_config, value, sizeof(*value), NULL);
}

mip_error mip_gnss_signal_config_encode(const struct mip_gnss_signal_config *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_SIGNAL_CONFIG_DESCRIPTOR, write_signal_config,
                            value);
}

struct mip_gnss_signal_config mip_gnss_signal_config_write(mip_gnss_gps_signals gps_enable,
                                                           mip_gnss_glonass_signals glonass_enable,
                                                           mip_gnss_galileo_signals galileo_enable,
                                                           mip_gnss_beidou_signals beidou_enable) {
    struct mip_gnss_signal_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.gps_enable = gps_enable;
    v.glonass_enable = glonass_enable;
    v.galileo_enable = galileo_enable;
    v.beidou_enable = beidou_enable;
    return v;
}

struct mip_gnss_signal_config mip_gnss_signal_config_read(void) {
    struct mip_gnss_signal_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_gnss_signal_config mip_gnss_signal_config_save(void) {
    struct mip_gnss_signal_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_gnss_signal_config mip_gnss_signal_config_load(void) {
    struct mip_gnss_signal_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_gnss_signal_config mip_gnss_signal_config_default(void) {
    struct mip_gnss_signal_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_signal_config_response(struct mip_reader *r, void *value) {
    struct mip_gnss_signal_config_response *v = (struct mip_gnss_signal_config_response *)value;
    mip_read_u8(r, &v->gps_enable, 1);
    mip_read_u8(r, &v->glonass_enable, 1);
    mip_read_u8(r, &v->galileo_enable, 1);
    mip_read_u8(r, &v->beidou_enable, 1);
    mip_read_u8(r, v->reserved, 4);
}

static void write_signal_config_response(struct mip_writer *w, const void *value) {
    const struct mip_gnss_signal_config_response *v =
        (const struct mip_gnss_signal_config_response *)value;
    mip_write_u8(w, &v->gps_enable, 1);
    mip_write_u8(w, &v->glonass_enable, 1);
    mip_write_u8(w, &v->galileo_enable, 1);
    mip_write_u8(w, &v->beidou_enable, 1);
    mip_write_u8(w, v->reserved, 4);
}

const struct mip_codec mip_gnss_signal_config_response_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_SIGNAL_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_gnss_signal_config_response),
    0, /* time-out */
    read_signal_config_response,
    write_signal_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_signal_config_response_decode(struct mip_gnss_signal_config_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_signal_config_response, value, sizeof(*value), NULL);
}

mip_error mip_gnss_signal_config_response_encode(
    const struct mip_gnss_signal_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_SIGNAL_CONFIG_RESPONSE_DESCRIPTOR,
                            write_signal_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_rtk_dongle_config[] = {0, 2, 0, 0, 0, 0};

static void read_rtk_dongle_config(struct mip_reader *r, void *value) {
    struct mip_gnss_rtk_dongle_config *v = (struct mip_gnss_rtk_dongle_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_rtk_dongle_config,
                      sizeof(required_rtk_dongle_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, v->reserved, 3);
    v->present = mip_read_present(r);
}

static void write_rtk_dongle_config(struct mip_writer *w, const void *value) {
    const struct mip_gnss_rtk_dongle_config *v = (const struct mip_gnss_rtk_dongle_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_rtk_dongle_config,
                       sizeof(required_rtk_dongle_config), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, v->reserved, 3);
}

static bool asked_rtk_dongle_config_1(const void *value) {
    const struct mip_gnss_rtk_dongle_config *v = (const struct mip_gnss_rtk_dongle_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_rtk_dongle_config[] = {
    {&mip_gnss_rtk_dongle_config_response_codec, asked_rtk_dongle_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_gnss_rtk_dongle_config_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_RTK_DONGLE_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_gnss_rtk_dongle_config),
    0, /* time-out */
    read_rtk_dongle_config,
    write_rtk_dongle_config,
    NULL,
    responses_rtk_dongle_config,
    NULL,
};

mip_error mip_gnss_rtk_dongle_config_decode(struct mip_gnss_rtk_dongle_config *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_rtk_dongle_config, value, sizeof(*value), NULL);
}

mip_error mip_gnss_rtk_dongle_config_encode(const struct mip_gnss_rtk_dongle_config *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_RTK_DONGLE_CONFIG_DESCRIPTOR,
                            write_rtk_dongle_config, value);
}

struct mip_gnss_rtk_dongle_config mip_gnss_rtk_dongle_config_write(uint8_t enable) {
    struct mip_gnss_rtk_dongle_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    return v;
}

struct mip_gnss_rtk_dongle_config mip_gnss_rtk_dongle_config_read(void) {
    struct mip_gnss_rtk_dongle_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_gnss_rtk_dongle_config mip_gnss_rtk_dongle_config_save(void) {
    struct mip_gnss_rtk_dongle_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_gnss_rtk_dongle_config mip_gnss_rtk_dongle_config_load(void) {
    struct mip_gnss_rtk_dongle_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_gnss_rtk_dongle_config mip_gnss_rtk_dongle_config_default(void) {
    struct mip_gnss_rtk_dongle_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_rtk_dongle_config_response(struct mip_reader *r, void *value) {
    struct mip_gnss_rtk_dongle_config_response *v =
        (struct mip_gnss_rtk_dongle_config_response *)value;
    mip_read_u8(r, &v->enable, 1);
    mip_read_u8(r, v->reserved, 3);
}

static void write_rtk_dongle_config_response(struct mip_writer *w, const void *value) {
    const struct mip_gnss_rtk_dongle_config_response *v =
        (const struct mip_gnss_rtk_dongle_config_response *)value;
    mip_write_u8(w, &v->enable, 1);
    mip_write_u8(w, v->reserved, 3);
}

const struct mip_codec mip_gnss_rtk_dongle_config_response_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_gnss_rtk_dongle_config_response),
    0, /* time-out */
    read_rtk_dongle_config_response,
    write_rtk_dongle_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_rtk_dongle_config_response_decode(
    struct mip_gnss_rtk_dongle_config_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_rtk_dongle_config_response, value, sizeof(*value), NULL);
}

mip_error mip_gnss_rtk_dongle_config_response_encode(
    const struct mip_gnss_rtk_dongle_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_RTK_DONGLE_CONFIG_RESPONSE_DESCRIPTOR,
                            write_rtk_dongle_config_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_spartn_config[] = {0, 8, 0, 0, 0, 0};

static void read_spartn_config(struct mip_reader *r, void *value) {
    struct mip_gnss_spartn_config *v = (struct mip_gnss_spartn_config *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_spartn_config, sizeof(required_spartn_config));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->enable, 1);
    mip_read_group(r, 2, 2);
    mip_read_u8(r, &v->type, 1);
    mip_read_group(r, 3, 3);
    mip_read_u32(r, &v->current_key_tow, 1);
    mip_read_group(r, 4, 4);
    mip_read_u16(r, &v->current_key_week, 1);
    mip_read_group(r, 5, 5);
    mip_read_u8(r, v->current_key, 32);
    mip_read_group(r, 6, 6);
    mip_read_u32(r, &v->next_key_tow, 1);
    mip_read_group(r, 7, 7);
    mip_read_u16(r, &v->next_key_week, 1);
    mip_read_group(r, 8, 8);
    mip_read_u8(r, v->next_key, 32);
    v->present = mip_read_present(r);
}

static void write_spartn_config(struct mip_writer *w, const void *value) {
    const struct mip_gnss_spartn_config *v = (const struct mip_gnss_spartn_config *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_spartn_config, sizeof(required_spartn_config),
                       v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->enable, 1);
    mip_write_group(w, 2, 2);
    mip_write_u8(w, &v->type, 1);
    mip_write_group(w, 3, 3);
    mip_write_u32(w, &v->current_key_tow, 1);
    mip_write_group(w, 4, 4);
    mip_write_u16(w, &v->current_key_week, 1);
    mip_write_group(w, 5, 5);
    mip_write_u8(w, v->current_key, 32);
    mip_write_group(w, 6, 6);
    mip_write_u32(w, &v->next_key_tow, 1);
    mip_write_group(w, 7, 7);
    mip_write_u16(w, &v->next_key_week, 1);
    mip_write_group(w, 8, 8);
    mip_write_u8(w, v->next_key, 32);
}

static bool asked_spartn_config_1(const void *value) {
    const struct mip_gnss_spartn_config *v = (const struct mip_gnss_spartn_config *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_spartn_config[] = {
    {&mip_gnss_spartn_config_response_codec, asked_spartn_config_1},
    {NULL, NULL},
};

const struct mip_codec mip_gnss_spartn_config_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_SPARTN_CONFIG_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_gnss_spartn_config),
    0, /* time-out */
    read_spartn_config,
    write_spartn_config,
    NULL,
    responses_spartn_config,
    NULL,
};

mip_error mip_gnss_spartn_config_decode(struct mip_gnss_spartn_config *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_spartn_config, value, sizeof(*value), NULL);
}

mip_error mip_gnss_spartn_config_encode(const struct mip_gnss_spartn_config *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_SPARTN_CONFIG_DESCRIPTOR, write_spartn_config,
                            value);
}

struct mip_gnss_spartn_config mip_gnss_spartn_config_write(
    uint8_t enable, mip_gnss_spartn_connection type, uint32_t current_key_tow,
    uint16_t current_key_week, const uint8_t current_key[32], uint32_t next_key_tow,
    uint16_t next_key_week, const uint8_t next_key[32]) {
    struct mip_gnss_spartn_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.enable = enable;
    v.type = type;
    v.current_key_tow = current_key_tow;
    v.current_key_week = current_key_week;
    memcpy(v.current_key, current_key, sizeof(v.current_key));
    v.next_key_tow = next_key_tow;
    v.next_key_week = next_key_week;
    memcpy(v.next_key, next_key, sizeof(v.next_key));
    return v;
}

struct mip_gnss_spartn_config mip_gnss_spartn_config_read(void) {
    struct mip_gnss_spartn_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_gnss_spartn_config mip_gnss_spartn_config_save(void) {
    struct mip_gnss_spartn_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_gnss_spartn_config mip_gnss_spartn_config_load(void) {
    struct mip_gnss_spartn_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_gnss_spartn_config mip_gnss_spartn_config_default(void) {
    struct mip_gnss_spartn_config v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_spartn_config_response(struct mip_reader *r, void *value) {
    struct mip_gnss_spartn_config_response *v = (struct mip_gnss_spartn_config_response *)value;
    mip_read_u8(r, &v->enable, 1);
    mip_read_u8(r, &v->type, 1);
    mip_read_u32(r, &v->current_key_tow, 1);
    mip_read_u16(r, &v->current_key_week, 1);
    mip_read_u8(r, v->current_key, 32);
    mip_read_u32(r, &v->next_key_tow, 1);
    mip_read_u16(r, &v->next_key_week, 1);
    mip_read_u8(r, v->next_key, 32);
}

static void write_spartn_config_response(struct mip_writer *w, const void *value) {
    const struct mip_gnss_spartn_config_response *v =
        (const struct mip_gnss_spartn_config_response *)value;
    mip_write_u8(w, &v->enable, 1);
    mip_write_u8(w, &v->type, 1);
    mip_write_u32(w, &v->current_key_tow, 1);
    mip_write_u16(w, &v->current_key_week, 1);
    mip_write_u8(w, v->current_key, 32);
    mip_write_u32(w, &v->next_key_tow, 1);
    mip_write_u16(w, &v->next_key_week, 1);
    mip_write_u8(w, v->next_key, 32);
}

const struct mip_codec mip_gnss_spartn_config_response_codec = {
    0x0E, /* descriptor set */
    MIP_GNSS_SPARTN_CONFIG_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_gnss_spartn_config_response),
    0, /* time-out */
    read_spartn_config_response,
    write_spartn_config_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_gnss_spartn_config_response_decode(struct mip_gnss_spartn_config_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_spartn_config_response, value, sizeof(*value), NULL);
}

mip_error mip_gnss_spartn_config_response_encode(
    const struct mip_gnss_spartn_config_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0E, MIP_GNSS_SPARTN_CONFIG_RESPONSE_DESCRIPTOR,
                            write_spartn_config_response, value);
}
