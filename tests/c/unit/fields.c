/* Presence, counts, strings, and what a failed decode or encode leaves behind, as far as members of C are concerned. */
#include "check.h"

#include "mip/3d.h"
#include "mip/measurements_inline.h"
#include "mip/core/program.h"
#include "mip/extra/names.h"
#include "mip/shared.h"
#include "mip/tools_commands.h"

static uint8_t buffer[MIP_MAX_PACKET];
static struct mip_builder packet;

static struct mip_builder *fresh(uint8_t set) {
    CHECK(mip_builder_start(&packet, buffer, sizeof(buffer), set) == MIP_OK);
    return &packet;
}

#define ENCODES(name, value, hex)                                                      \
    (mip_##name##_encode(value, fresh(mip_##name##_codec.descriptor_set)) == MIP_OK && \
     strcmp(only_field(&packet), hex) == 0)

static void presence(void) {
    struct mip_tools_settings v;
    mip_tools_settings_write(&v, 1, MIP_MODE_SLOW, 9600);
    CHECK(v.present == 0 && ENCODES(tools_settings, &v, "01010200002580")); /* the shortest form */
    v.limit = 5; /* without `present`, it would not be sent, and nobody would notice */
    CHECK(mip_tools_settings_encode(&v, fresh(1)) == MIP_ERROR_MISSING && packet.length == MIP_HEADER_SIZE);
    v.present = MIP_TOOLS_SETTINGS_WITH_LIMIT;
    CHECK(ENCODES(tools_settings, &v, "010102000025800005"));
    v.present = MIP_TOOLS_SETTINGS_WITH_RESERVED; /* it has the value to send */
    CHECK(ENCODES(tools_settings, &v, "01010200002580000501"));
    v.present = 6; /* more than the parameters that exist */
    CHECK(mip_tools_settings_encode(&v, fresh(1)) == MIP_ERROR_MISSING && packet.length == MIP_HEADER_SIZE);

    /* A counter and its array are present or absent together. */
    struct mip_tools_list l;
    mip_tools_list_read(&l);
    l.present = 1;
    CHECK(mip_tools_list_encode(&l, fresh(1)) == MIP_ERROR_MISSING);
    l.present = 2;
    CHECK(ENCODES(tools_list, &l, "0200"));
}

static void counts(void) {
    static const uint16_t items[126] = {0};
    struct mip_tools_list l;
    mip_tools_list_write(&l, 125, items);
    CHECK(mip_tools_list_encode(&l, fresh(1)) == MIP_OK);
    /* A constructor copies no more than there is room for, and encode rejects the count. */
    mip_tools_list_write(&l, 126, items);
    CHECK(l.count == 126 && mip_tools_list_encode(&l, fresh(1)) == MIP_ERROR_COUNT);
    CHECK(packet.length == MIP_HEADER_SIZE && mip_builder_finish(&packet).size == 6);
    mip_tools_list_write(&l, 0, NULL);
    CHECK(ENCODES(tools_list, &l, "0100"));
}

/* What has no set, descriptor or name: keys, errors and values. */
static void others(void) {
    static const char data[] = "3f800000400000004040000000ff";
    struct mip_measurements_accel accel;
    struct mip_field field = field_of(MIP_COPY_SET, MIP_MEASUREMENTS_ACCEL_DESCRIPTOR, data);
    size_t trailing;
    switch (mip_field_key(&field)) { /* the key of a type in a set is a constant */
    case MIP_MEASUREMENTS_ACCEL(MIP_MEASUREMENTS_SET):
        CHECK(false);
        break;
    case MIP_MEASUREMENTS_ACCEL(MIP_COPY_SET):
        CHECK(mip_measurements_accel_decode(&accel, &field) == MIP_OK && accel.valid_flags == 255);
        break;
    default:
        CHECK(false);
    }
    field.descriptor_set = 0x7F;
    CHECK(mip_measurements_accel_decode(&accel, &field) == MIP_ERROR_SET && accel.valid_flags == 0);
    field = field_of(MIP_MORE_SET, MIP_MEASUREMENTS_ACCEL_DESCRIPTOR + 1, data);
    memset(&accel, 0xAA, sizeof(accel));
    CHECK(mip_decode(&mip_measurements_accel_codec, &accel, &field, &trailing) == MIP_ERROR_DESCRIPTOR);
    CHECK(trailing == 14 && accel.valid_flags == 0);
    CHECK(mip_measurements_accel_decode_inline(&accel, &field) == MIP_ERROR_DESCRIPTOR);
    /* A packet that was not begun has no set. */
    struct mip_builder none;
    CHECK(mip_builder_start(&none, buffer, 5, MIP_COPY_SET) == MIP_ERROR_LENGTH && mip_builder_set(&none) == 0);
    CHECK(mip_measurements_accel_encode(&accel, &none) == MIP_ERROR_LENGTH);
    CHECK(mip_measurements_accel_encode_inline(&accel, &none) == MIP_ERROR_SET && none.length == 0);
    CHECK(mip_mode_name(0x77) == NULL && mip_wide_code_name(0x77) == NULL);
    /* A tag that nobody knows: the union is empty. */
    struct mip_tools_choice v;
    mip_tools_choice_write(&v, 1, MIP_TOOLS_SHAPE_NONE, NULL);
    CHECK(ENCODES(tools_choice, &v, "010100"));
    v.shape = 0x99;
    CHECK(ENCODES(tools_choice, &v, "010199"));
}

static void strings(void) {
    struct mip_measurements_strings s;
    memset(&s, 0, sizeof(s));
    mip_copy_text(s.model, sizeof(s.model), "CV7");
    CHECK(strcmp(s.model, "CV7             ") == 0);
    mip_copy_text(s.model, sizeof(s.model), "longer than sixteen bytes");
    CHECK(strcmp(s.model, "longer than sixt") == 0);
    struct mip_measurements_strings t;
    struct mip_field field = field_of(0x81, MIP_MEASUREMENTS_STRINGS_DESCRIPTOR, "30313233343536373839616263646566016a6b");
    CHECK(mip_measurements_strings_decode(&t, &field) == MIP_OK);
    CHECK(strcmp(t.model, "0123456789abcdef") == 0 && strcmp(t.name, "j") == 0);
    CHECK(t.rest_count == 1 && strcmp(t.rest, "k") == 0);
}

/* Keywords, and a parameter with the name of a member that generated code uses itself. */
static void keywords(void) {
    struct mip_3d_default d;
    mip_3d_default_make(&d, 1, 2, 3, 4, 5);
    CHECK(d.class_ == 1 && d.register_ == 3 && d.present_ == 5);
    CHECK(mip_tools_ping_encode(NULL, fresh(1)) == MIP_OK && strcmp(only_field(&packet), "") == 0);
}

/* A tag of two bytes: a case is found behind another one whose tag differs in its first byte. */
static void wide_tags(void) {
    struct wide {
        uint16_t tag;
        uint8_t value;
    } wide;
    static const uint8_t program[] = {
        MIP_16_BITS(1, MIP_AT(struct wide, tag)),
        MIP_SWITCH(2, 2, MIP_AT(struct wide, tag)),
        MIP_CASE(3, 0x01, 0x00),
        MIP_8_BITS(1, MIP_AT(struct wide, value)),
        MIP_END,
        MIP_CASE(3, 0x02, 0x00),
        MIP_8_BITS(1, MIP_AT(struct wide, value)),
        MIP_END,
        MIP_END,
    };
    static const struct mip_codec codec = {1, 0x7F, MIP_COMMAND, 0, sizeof(wide), 0, 0, program, &mip_program};
    const struct mip_field field = field_of(1, 0x7F, "020007");
    CHECK(mip_decode(&codec, &wide, &field, NULL) == MIP_OK && wide.tag == 0x0200 && wide.value == 7);
    CHECK(mip_encode(&codec, &wide, fresh(1)) == MIP_OK && strcmp(only_field(&packet), "020007") == 0);
}

int main(void) {
    presence();
    counts();
    others();
    wide_tags();
    strings();
    keywords();
    return 0;
}
