/* RTK commands. */
#include "mip/rtk.h"

#include <string.h>

static const struct mip_response responses_get_status_flags[] = {
    {&mip_rtk_get_status_flags_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_status_flags_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_STATUS_FLAGS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_status_flags),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_status_flags,
    NULL,
};

mip_error mip_rtk_get_status_flags_decode(struct mip_rtk_get_status_flags *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_status_flags_encode(const struct mip_rtk_get_status_flags *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_STATUS_FLAGS_DESCRIPTOR, mip_write_nothing,
                            value);
}

static void read_get_status_flags_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_status_flags_response *v = (struct mip_rtk_get_status_flags_response *)value;
    mip_read_u32(r, &v->flags, 1);
}

static void write_get_status_flags_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_status_flags_response *v =
        (const struct mip_rtk_get_status_flags_response *)value;
    mip_write_u32(w, &v->flags, 1);
}

const struct mip_codec mip_rtk_get_status_flags_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_STATUS_FLAGS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_status_flags_response),
    0, /* time-out */
    read_get_status_flags_response,
    write_get_status_flags_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_status_flags_response_decode(struct mip_rtk_get_status_flags_response *value,
                                                   const struct mip_field *field) {
    return mip_decode_field(field, read_get_status_flags_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_status_flags_response_encode(
    const struct mip_rtk_get_status_flags_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_STATUS_FLAGS_RESPONSE_DESCRIPTOR,
                            write_get_status_flags_response, value);
}

static const struct mip_response responses_get_imei[] = {
    {&mip_rtk_get_imei_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_imei_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_IMEI_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_imei),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_imei,
    NULL,
};

mip_error mip_rtk_get_imei_decode(struct mip_rtk_get_imei *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_imei_encode(const struct mip_rtk_get_imei *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_IMEI_DESCRIPTOR, mip_write_nothing, value);
}

static void read_get_imei_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_imei_response *v = (struct mip_rtk_get_imei_response *)value;
    mip_read_char(r, v->imei, 32);
}

static void write_get_imei_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_imei_response *v = (const struct mip_rtk_get_imei_response *)value;
    mip_write_char(w, v->imei, 32);
}

const struct mip_codec mip_rtk_get_imei_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_IMEI_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_imei_response),
    0, /* time-out */
    read_get_imei_response,
    write_get_imei_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_imei_response_decode(struct mip_rtk_get_imei_response *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_get_imei_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_imei_response_encode(const struct mip_rtk_get_imei_response *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_IMEI_RESPONSE_DESCRIPTOR,
                            write_get_imei_response, value);
}

static const struct mip_response responses_get_imsi[] = {
    {&mip_rtk_get_imsi_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_imsi_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_IMSI_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_imsi),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_imsi,
    NULL,
};

mip_error mip_rtk_get_imsi_decode(struct mip_rtk_get_imsi *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_imsi_encode(const struct mip_rtk_get_imsi *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_IMSI_DESCRIPTOR, mip_write_nothing, value);
}

static void read_get_imsi_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_imsi_response *v = (struct mip_rtk_get_imsi_response *)value;
    mip_read_char(r, v->imsi, 32);
}

static void write_get_imsi_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_imsi_response *v = (const struct mip_rtk_get_imsi_response *)value;
    mip_write_char(w, v->imsi, 32);
}

const struct mip_codec mip_rtk_get_imsi_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_IMSI_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_imsi_response),
    0, /* time-out */
    read_get_imsi_response,
    write_get_imsi_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_imsi_response_decode(struct mip_rtk_get_imsi_response *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_get_imsi_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_imsi_response_encode(const struct mip_rtk_get_imsi_response *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_IMSI_RESPONSE_DESCRIPTOR,
                            write_get_imsi_response, value);
}

static const struct mip_response responses_get_iccid[] = {
    {&mip_rtk_get_iccid_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_iccid_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_ICCID_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_iccid),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_iccid,
    NULL,
};

mip_error mip_rtk_get_iccid_decode(struct mip_rtk_get_iccid *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_iccid_encode(const struct mip_rtk_get_iccid *value,
                                   struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_ICCID_DESCRIPTOR, mip_write_nothing, value);
}

static void read_get_iccid_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_iccid_response *v = (struct mip_rtk_get_iccid_response *)value;
    mip_read_char(r, v->iccid, 32);
}

static void write_get_iccid_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_iccid_response *v = (const struct mip_rtk_get_iccid_response *)value;
    mip_write_char(w, v->iccid, 32);
}

const struct mip_codec mip_rtk_get_iccid_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_ICCID_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_iccid_response),
    0, /* time-out */
    read_get_iccid_response,
    write_get_iccid_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_iccid_response_decode(struct mip_rtk_get_iccid_response *value,
                                            const struct mip_field *field) {
    return mip_decode_field(field, read_get_iccid_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_iccid_response_encode(const struct mip_rtk_get_iccid_response *value,
                                            struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_ICCID_RESPONSE_DESCRIPTOR,
                            write_get_iccid_response, value);
}

static const struct mip_response responses_get_rssi[] = {
    {&mip_rtk_get_rssi_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_rssi_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_RSSI_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_rssi),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_rssi,
    NULL,
};

mip_error mip_rtk_get_rssi_decode(struct mip_rtk_get_rssi *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_rssi_encode(const struct mip_rtk_get_rssi *value,
                                  struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_RSSI_DESCRIPTOR, mip_write_nothing, value);
}

static void read_get_rssi_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_rssi_response *v = (struct mip_rtk_get_rssi_response *)value;
    mip_read_bool(r, &v->valid, 1);
    mip_read_s32(r, &v->rssi, 1);
    mip_read_s32(r, &v->signal_quality, 1);
}

static void write_get_rssi_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_rssi_response *v = (const struct mip_rtk_get_rssi_response *)value;
    mip_write_bool(w, &v->valid, 1);
    mip_write_s32(w, &v->rssi, 1);
    mip_write_s32(w, &v->signal_quality, 1);
}

const struct mip_codec mip_rtk_get_rssi_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_RSSI_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_rssi_response),
    0, /* time-out */
    read_get_rssi_response,
    write_get_rssi_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_rssi_response_decode(struct mip_rtk_get_rssi_response *value,
                                           const struct mip_field *field) {
    return mip_decode_field(field, read_get_rssi_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_rssi_response_encode(const struct mip_rtk_get_rssi_response *value,
                                           struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_RSSI_RESPONSE_DESCRIPTOR,
                            write_get_rssi_response, value);
}

/** Parameters that each function requires, by its value. */
static const uint8_t required_connected_device_type[] = {0, 1, 0, 0, 0, 0};

static void read_connected_device_type(struct mip_reader *r, void *value) {
    struct mip_rtk_connected_device_type *v = (struct mip_rtk_connected_device_type *)value;
    mip_read_u8(r, &v->function, 1);
    mip_read_required(r, v->function, required_connected_device_type,
                      sizeof(required_connected_device_type));
    mip_read_group(r, 1, 1);
    mip_read_u8(r, &v->device_type, 1);
    v->present = mip_read_present(r);
}

static void write_connected_device_type(struct mip_writer *w, const void *value) {
    const struct mip_rtk_connected_device_type *v =
        (const struct mip_rtk_connected_device_type *)value;
    mip_write_u8(w, &v->function, 1);
    mip_write_required(w, v->function, required_connected_device_type,
                       sizeof(required_connected_device_type), v->present);
    mip_write_group(w, 1, 1);
    mip_write_u8(w, &v->device_type, 1);
}

static bool asked_connected_device_type_1(const void *value) {
    const struct mip_rtk_connected_device_type *v =
        (const struct mip_rtk_connected_device_type *)value;

    return v->function == MIP_FUNCTION_SELECTOR_READ;
}

static const struct mip_response responses_connected_device_type[] = {
    {&mip_rtk_connected_device_type_response_codec, asked_connected_device_type_1},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_connected_device_type_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_CONNECTED_DEVICE_TYPE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_connected_device_type),
    0, /* time-out */
    read_connected_device_type,
    write_connected_device_type,
    NULL,
    responses_connected_device_type,
    NULL,
};

mip_error mip_rtk_connected_device_type_decode(struct mip_rtk_connected_device_type *value,
                                               const struct mip_field *field) {
    return mip_decode_field(field, read_connected_device_type, value, sizeof(*value), NULL);
}

mip_error mip_rtk_connected_device_type_encode(const struct mip_rtk_connected_device_type *value,
                                               struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_CONNECTED_DEVICE_TYPE_DESCRIPTOR,
                            write_connected_device_type, value);
}

struct mip_rtk_connected_device_type
mip_rtk_connected_device_type_write(mip_rtk_connected_device device_type) {
    struct mip_rtk_connected_device_type v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.device_type = device_type;
    return v;
}

struct mip_rtk_connected_device_type mip_rtk_connected_device_type_read(void) {
    struct mip_rtk_connected_device_type v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_READ;
    return v;
}

struct mip_rtk_connected_device_type mip_rtk_connected_device_type_save(void) {
    struct mip_rtk_connected_device_type v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_SAVE;
    return v;
}

struct mip_rtk_connected_device_type mip_rtk_connected_device_type_load(void) {
    struct mip_rtk_connected_device_type v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_LOAD;
    return v;
}

struct mip_rtk_connected_device_type mip_rtk_connected_device_type_default(void) {
    struct mip_rtk_connected_device_type v;
    memset(&v, 0, sizeof(v));
    v.function = MIP_FUNCTION_SELECTOR_DEFAULT;
    return v;
}

static void read_connected_device_type_response(struct mip_reader *r, void *value) {
    struct mip_rtk_connected_device_type_response *v =
        (struct mip_rtk_connected_device_type_response *)value;
    mip_read_u8(r, &v->device_type, 1);
}

static void write_connected_device_type_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_connected_device_type_response *v =
        (const struct mip_rtk_connected_device_type_response *)value;
    mip_write_u8(w, &v->device_type, 1);
}

const struct mip_codec mip_rtk_connected_device_type_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_connected_device_type_response),
    0, /* time-out */
    read_connected_device_type_response,
    write_connected_device_type_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_connected_device_type_response_decode(
    struct mip_rtk_connected_device_type_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_connected_device_type_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_rtk_connected_device_type_response_encode(
    const struct mip_rtk_connected_device_type_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_CONNECTED_DEVICE_TYPE_RESPONSE_DESCRIPTOR,
                            write_connected_device_type_response, value);
}

static const struct mip_response responses_get_activation_code[] = {
    {&mip_rtk_get_activation_code_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_activation_code_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_ACTIVATION_CODE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_activation_code),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_activation_code,
    NULL,
};

mip_error mip_rtk_get_activation_code_decode(struct mip_rtk_get_activation_code *value,
                                             const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_activation_code_encode(const struct mip_rtk_get_activation_code *value,
                                             struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_ACTIVATION_CODE_DESCRIPTOR,
                            mip_write_nothing, value);
}

static void read_get_activation_code_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_activation_code_response *v =
        (struct mip_rtk_get_activation_code_response *)value;
    mip_read_char(r, v->activation_code, 32);
}

static void write_get_activation_code_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_activation_code_response *v =
        (const struct mip_rtk_get_activation_code_response *)value;
    mip_write_char(w, v->activation_code, 32);
}

const struct mip_codec mip_rtk_get_activation_code_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_ACTIVATION_CODE_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_activation_code_response),
    0, /* time-out */
    read_get_activation_code_response,
    write_get_activation_code_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_activation_code_response_decode(
    struct mip_rtk_get_activation_code_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_activation_code_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_activation_code_response_encode(
    const struct mip_rtk_get_activation_code_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_ACTIVATION_CODE_RESPONSE_DESCRIPTOR,
                            write_get_activation_code_response, value);
}

static const struct mip_response responses_get_modem_firmware_version[] = {
    {&mip_rtk_get_modem_firmware_version_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_get_modem_firmware_version_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_MODEM_FIRMWARE_VERSION_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_get_modem_firmware_version),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    responses_get_modem_firmware_version,
    NULL,
};

mip_error mip_rtk_get_modem_firmware_version_decode(
    struct mip_rtk_get_modem_firmware_version *value, const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_get_modem_firmware_version_encode(
    const struct mip_rtk_get_modem_firmware_version *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_MODEM_FIRMWARE_VERSION_DESCRIPTOR,
                            mip_write_nothing, value);
}

static void read_get_modem_firmware_version_response(struct mip_reader *r, void *value) {
    struct mip_rtk_get_modem_firmware_version_response *v =
        (struct mip_rtk_get_modem_firmware_version_response *)value;
    mip_read_char(r, v->modem_firmware_version, 32);
}

static void write_get_modem_firmware_version_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_get_modem_firmware_version_response *v =
        (const struct mip_rtk_get_modem_firmware_version_response *)value;
    mip_write_char(w, v->modem_firmware_version, 32);
}

const struct mip_codec mip_rtk_get_modem_firmware_version_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_get_modem_firmware_version_response),
    0, /* time-out */
    read_get_modem_firmware_version_response,
    write_get_modem_firmware_version_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_get_modem_firmware_version_response_decode(
    struct mip_rtk_get_modem_firmware_version_response *value, const struct mip_field *field) {
    return mip_decode_field(field, read_get_modem_firmware_version_response, value, sizeof(*value),
                            NULL);
}

mip_error mip_rtk_get_modem_firmware_version_response_encode(
    const struct mip_rtk_get_modem_firmware_version_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_GET_MODEM_FIRMWARE_VERSION_RESPONSE_DESCRIPTOR,
                            write_get_modem_firmware_version_response, value);
}

static void read_service_status(struct mip_reader *r, void *value) {
    struct mip_rtk_service_status *v = (struct mip_rtk_service_status *)value;
    mip_read_u32(r, &v->reserved1, 1);
    mip_read_u32(r, &v->reserved2, 1);
}

static void write_service_status(struct mip_writer *w, const void *value) {
    const struct mip_rtk_service_status *v = (const struct mip_rtk_service_status *)value;
    mip_write_u32(w, &v->reserved1, 1);
    mip_write_u32(w, &v->reserved2, 1);
}

static const struct mip_response responses_service_status[] = {
    {&mip_rtk_service_status_response_codec, NULL},
    {NULL, NULL},
};

const struct mip_codec mip_rtk_service_status_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_SERVICE_STATUS_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_service_status),
    0, /* time-out */
    read_service_status,
    write_service_status,
    NULL,
    responses_service_status,
    NULL,
};

mip_error mip_rtk_service_status_decode(struct mip_rtk_service_status *value,
                                        const struct mip_field *field) {
    return mip_decode_field(field, read_service_status, value, sizeof(*value), NULL);
}

mip_error mip_rtk_service_status_encode(const struct mip_rtk_service_status *value,
                                        struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_SERVICE_STATUS_DESCRIPTOR, write_service_status,
                            value);
}

static void read_service_status_response(struct mip_reader *r, void *value) {
    struct mip_rtk_service_status_response *v = (struct mip_rtk_service_status_response *)value;
    mip_read_u8(r, &v->flags, 1);
    mip_read_u32(r, &v->received_bytes, 1);
    mip_read_u32(r, &v->last_bytes, 1);
    mip_read_u64(r, &v->last_bytes_time, 1);
}

static void write_service_status_response(struct mip_writer *w, const void *value) {
    const struct mip_rtk_service_status_response *v =
        (const struct mip_rtk_service_status_response *)value;
    mip_write_u8(w, &v->flags, 1);
    mip_write_u32(w, &v->received_bytes, 1);
    mip_write_u32(w, &v->last_bytes, 1);
    mip_write_u64(w, &v->last_bytes_time, 1);
}

const struct mip_codec mip_rtk_service_status_response_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_SERVICE_STATUS_RESPONSE_DESCRIPTOR,
    MIP_RESPONSE,
    sizeof(struct mip_rtk_service_status_response),
    0, /* time-out */
    read_service_status_response,
    write_service_status_response,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_service_status_response_decode(struct mip_rtk_service_status_response *value,
                                                 const struct mip_field *field) {
    return mip_decode_field(field, read_service_status_response, value, sizeof(*value), NULL);
}

mip_error mip_rtk_service_status_response_encode(
    const struct mip_rtk_service_status_response *value, struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_SERVICE_STATUS_RESPONSE_DESCRIPTOR,
                            write_service_status_response, value);
}

static void read_erase_storage(struct mip_reader *r, void *value) {
    struct mip_rtk_erase_storage *v = (struct mip_rtk_erase_storage *)value;
    mip_read_u8(r, &v->media, 1);
}

static void write_erase_storage(struct mip_writer *w, const void *value) {
    const struct mip_rtk_erase_storage *v = (const struct mip_rtk_erase_storage *)value;
    mip_write_u8(w, &v->media, 1);
}

const struct mip_codec mip_rtk_erase_storage_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_ERASE_STORAGE_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_erase_storage),
    0, /* time-out */
    read_erase_storage,
    write_erase_storage,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_erase_storage_decode(struct mip_rtk_erase_storage *value,
                                       const struct mip_field *field) {
    return mip_decode_field(field, read_erase_storage, value, sizeof(*value), NULL);
}

mip_error mip_rtk_erase_storage_encode(const struct mip_rtk_erase_storage *value,
                                       struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_ERASE_STORAGE_DESCRIPTOR, write_erase_storage,
                            value);
}

struct mip_rtk_erase_storage mip_rtk_erase_storage_make(mip_rtk_storage_medium media) {
    struct mip_rtk_erase_storage v;
    memset(&v, 0, sizeof(v));
    v.media = media;
    return v;
}

static void read_led_control(struct mip_reader *r, void *value) {
    struct mip_rtk_led_control *v = (struct mip_rtk_led_control *)value;
    mip_read_u8(r, v->primary_color, 3);
    mip_read_u8(r, v->alternate_color, 3);
    mip_read_u8(r, &v->action, 1);
    mip_read_u32(r, &v->period, 1);
}

static void write_led_control(struct mip_writer *w, const void *value) {
    const struct mip_rtk_led_control *v = (const struct mip_rtk_led_control *)value;
    mip_write_u8(w, v->primary_color, 3);
    mip_write_u8(w, v->alternate_color, 3);
    mip_write_u8(w, &v->action, 1);
    mip_write_u32(w, &v->period, 1);
}

const struct mip_codec mip_rtk_led_control_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_LED_CONTROL_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_led_control),
    0, /* time-out */
    read_led_control,
    write_led_control,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_led_control_decode(struct mip_rtk_led_control *value,
                                     const struct mip_field *field) {
    return mip_decode_field(field, read_led_control, value, sizeof(*value), NULL);
}

mip_error mip_rtk_led_control_encode(const struct mip_rtk_led_control *value,
                                     struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_LED_CONTROL_DESCRIPTOR, write_led_control,
                            value);
}

struct mip_rtk_led_control mip_rtk_led_control_make(const uint8_t primary_color[3],
                                                    const uint8_t alternate_color[3],
                                                    mip_rtk_led_action action, uint32_t period) {
    struct mip_rtk_led_control v;
    memset(&v, 0, sizeof(v));
    memcpy(v.primary_color, primary_color, sizeof(v.primary_color));
    memcpy(v.alternate_color, alternate_color, sizeof(v.alternate_color));
    v.action = action;
    v.period = period;
    return v;
}

const struct mip_codec mip_rtk_modem_hard_reset_codec = {
    0x0F, /* descriptor set */
    MIP_RTK_MODEM_HARD_RESET_DESCRIPTOR,
    MIP_COMMAND,
    sizeof(struct mip_rtk_modem_hard_reset),
    0, /* time-out */
    mip_read_nothing,
    mip_write_nothing,
    NULL,
    NULL,
    NULL,
};

mip_error mip_rtk_modem_hard_reset_decode(struct mip_rtk_modem_hard_reset *value,
                                          const struct mip_field *field) {
    return mip_decode_field(field, mip_read_nothing, value, sizeof(*value), NULL);
}

mip_error mip_rtk_modem_hard_reset_encode(const struct mip_rtk_modem_hard_reset *value,
                                          struct mip_builder *builder) {
    return mip_encode_field(builder, 0x0F, MIP_RTK_MODEM_HARD_RESET_DESCRIPTOR, mip_write_nothing,
                            value);
}
