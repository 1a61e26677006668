/* Presence, constructors, strings, unions, and what a failed decode or encode leaves behind. */
#include "check.h"

#include "mip/3d.h"
#include "mip/measurements_inline.h"
#include "mip/program.h"
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
    /* Constructors build the shortest form. */
    struct mip_tools_settings v;
    mip_tools_settings_write(&v, 1, MIP_MODE_SLOW, 9600);
    CHECK(v.present == 0 && ENCODES(tools_settings, &v, "01010200002580"));
    v.limit = 5; /* without `present`, it would not be sent, and nobody would notice */
    CHECK(mip_tools_settings_encode(&v, fresh(1)) == MIP_ERROR_MISSING && packet.length == MIP_HEADER_SIZE);
    v.limit = 0;
    mip_tools_settings_read(&v, 1, MIP_MODE_SLOW);
    CHECK(ENCODES(tools_settings, &v, "020102"));
    mip_tools_settings_save(&v, 7);
    CHECK(ENCODES(tools_settings, &v, "0307"));
    mip_tools_settings_load(&v, 7);
    CHECK(ENCODES(tools_settings, &v, "0407"));
    mip_tools_settings_default(&v, 7);
    CHECK(ENCODES(tools_settings, &v, "0507"));
    mip_tools_settings_apply(&v, 1, MIP_MODE_FAST, 1);
    CHECK(ENCODES(tools_settings, &v, "06010100000001"));

    /* Optional parameters are settable; reserved ones have the value to send. */
    mip_tools_settings_write(&v, 1, MIP_MODE_SLOW, 9600);
    v.limit = 0x1234;
    v.present = MIP_TOOLS_SETTINGS_WITH_LIMIT;
    CHECK(ENCODES(tools_settings, &v, "010102000025801234"));
    v.present = MIP_TOOLS_SETTINGS_WITH_RESERVED;
    CHECK(ENCODES(tools_settings, &v, "01010200002580123401"));

    /* Dummy values after the parameters that a function requires are preserved byte for byte. */
    struct mip_field field = field_of(1, 2, "03070200");
    size_t trailing;
    CHECK(mip_decode(&mip_tools_settings_codec, &v, &field, &trailing) == MIP_OK);
    CHECK(v.present == 2 && v.mode == MIP_MODE_SLOW && v.baud == 0 && trailing == 1);
    CHECK(ENCODES(tools_settings, &v, "030702"));
    /* After a change of the function, its own parameters are required. */
    v.function = MIP_FUNCTION_SELECTOR_WRITE;
    v.baud = 5;
    CHECK(ENCODES(tools_settings, &v, "01070200000005"));
    /* More than the parameters that exist. */
    v.present = 6;
    CHECK(mip_tools_settings_encode(&v, fresh(1)) == MIP_ERROR_MISSING && packet.length == MIP_HEADER_SIZE);
    /* An unknown selector requires nothing. */
    field = field_of(1, 2, "77");
    CHECK(mip_tools_settings_decode(&v, &field) == MIP_OK && v.function == 0x77 && v.present == 0);
    CHECK(ENCODES(tools_settings, &v, "77"));

    /* Without a selector. */
    struct mip_measurements_growing g;
    field = field_of(0x80, 6, "00010002");
    CHECK(mip_measurements_growing_decode(&g, &field) == MIP_OK);
    CHECK(g.present == MIP_MEASUREMENTS_GROWING_WITH_SECOND && g.first == 1 && g.second == 2);
    CHECK(ENCODES(measurements_growing, &g, "00010002"));
    g.present = 0;
    CHECK(mip_measurements_growing_encode(&g, fresh(0x80)) == MIP_ERROR_MISSING); /* `second` has a value */
    g.second = 0;
    CHECK(ENCODES(measurements_growing, &g, "0001"));
    g.second = 2;
    g.present = 3;
    CHECK(ENCODES(measurements_growing, &g, "0001000200000000"));
    /* Half a parameter is left over, and its member is untouched. */
    field = field_of(0x80, 6, "000100027fe5bf");
    CHECK(mip_decode(&mip_measurements_growing_codec, &g, &field, &trailing) == MIP_OK);
    uint32_t bits;
    memcpy(&bits, &g.third, 4);
    CHECK(g.present == 2 && trailing == 3 && bits == 0);

    /* A counter and its array are present or absent together. */
    static const uint16_t items[] = {0x0102, 0x0304};
    struct mip_tools_list l;
    mip_tools_list_write(&l, 2, items);
    CHECK(ENCODES(tools_list, &l, "010201020304"));
    mip_tools_list_read(&l);
    CHECK(ENCODES(tools_list, &l, "02"));
    l.present = 1;
    CHECK(mip_tools_list_encode(&l, fresh(1)) == MIP_ERROR_MISSING);
    l.present = 2;
    CHECK(ENCODES(tools_list, &l, "0200"));
    field = field_of(1, 9, "0200");
    CHECK(mip_tools_list_decode(&l, &field) == MIP_OK && l.present == 2 && l.count == 0);
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
    struct mip_field field = field_of(1, 9, "01030102");
    memset(&l, 0xAA, sizeof(l));
    CHECK(mip_tools_list_decode(&l, &field) == MIP_ERROR_COUNT);
    for (size_t i = 0; i < sizeof(l); i++) {
        CHECK(((const uint8_t *)&l)[i] == 0);
    }
    mip_tools_list_write(&l, 0, NULL);
    CHECK(ENCODES(tools_list, &l, "0100"));
}

static void refused(void) {
    /* A field that does not fit leaves those before it unchanged. */
    struct mip_measurements_accel accel;
    memset(&accel, 0, sizeof(accel));
    struct mip_builder *b = fresh(MIP_MEASUREMENTS_SET);
    size_t count = 0;
    while (mip_measurements_accel_encode(&accel, b) == MIP_OK) {
        count++;
    }
    CHECK(count == 15 && b->length == MIP_HEADER_SIZE + 15 * 16);
    struct mip_packet done = mip_builder_finish(b);
    CHECK(mip_packet_check(done.bytes, done.size, &done) == MIP_OK);
    /* A smaller field still fits. */
    CHECK(mip_builder_add(b, 1, NULL, 0) == MIP_OK);
}

static void sets(void) {
    /* Data goes into data packets only, and commands into those of their own set. */
    struct mip_measurements_own own = {MIP_MODE_FAST};
    struct mip_protocol_acknowledge ack = {1, MIP_ACK_CODE_OK};
    CHECK(mip_measurements_own_encode(&own, fresh(MIP_TOOLS_SET)) == MIP_ERROR_SET);
    CHECK(packet.length == MIP_HEADER_SIZE && mip_builder_finish(&packet).size == 6);
    CHECK(mip_measurements_own_encode(&own, fresh(0x7F)) == MIP_ERROR_SET);
    CHECK(mip_measurements_own_encode(&own, fresh(MIP_MORE_SET)) == MIP_OK);
    CHECK(mip_measurements_own_encode(&own, fresh(MIP_MEASUREMENTS_SET)) == MIP_ERROR_SET);
    CHECK(mip_measurements_own_encode(&own, fresh(MIP_COPY_SET)) == MIP_ERROR_SET);
    CHECK(mip_tools_ping_encode(NULL, fresh(MIP_MEASUREMENTS_SET)) == MIP_ERROR_SET);
    CHECK(mip_tools_ping_encode(NULL, fresh(MIP_TOOLS_SET + 1)) == MIP_ERROR_SET);
    CHECK(mip_protocol_acknowledge_encode(&ack, fresh(0x7F)) == MIP_OK);
    CHECK(mip_protocol_acknowledge_encode(&ack, fresh(0x80)) == MIP_ERROR_SET);
}

/* A field that occurs in several sets is one type, which no other set has. */
static void several_sets(void) {
    static const char data[] = "3f800000400000004040000000ff";
    struct mip_measurements_accel accel;
    for (unsigned set = 1; set < 0xFF; set++) {
        const bool right = set == MIP_MEASUREMENTS_SET || set == MIP_MORE_SET || set == MIP_COPY_SET;
        const mip_error error = right ? MIP_OK : MIP_ERROR_SET;
        const struct mip_field field = field_of((uint8_t)set, MIP_MEASUREMENTS_ACCEL_DESCRIPTOR, data);
        CHECK(mip_measurements_accel_decode(&accel, &field) == error && accel.valid_flags == (right ? 255 : 0));
        memset(&accel, 0xAA, sizeof(accel));
        CHECK(mip_measurements_accel_decode_inline(&accel, &field) == error && accel.valid_flags == (right ? 255 : 0));
        CHECK(mip_measurements_accel_encode(&accel, fresh((uint8_t)set)) == error);
        CHECK(!right || strcmp(only_field(&packet), data) == 0);
        CHECK(mip_measurements_accel_encode_inline(&accel, fresh((uint8_t)set)) == error);
        CHECK(!right || strcmp(only_field(&packet), data) == 0);
        CHECK(mip_field_is(&field, &mip_measurements_accel_codec) == right);
        CHECK(!mip_field_is(&field, &mip_measurements_strings_codec));
        switch (mip_field_key(&field)) { /* the key of a type in a set is a constant */
        case MIP_MEASUREMENTS_ACCEL(MIP_MEASUREMENTS_SET):
        case MIP_MEASUREMENTS_ACCEL(MIP_COPY_SET):
            CHECK(set != MIP_MORE_SET && right);
            break;
        default:
            CHECK(set == MIP_MORE_SET || !right);
        }
    }
    /* The same descriptor is another type in another set. */
    const struct mip_field field = field_of(MIP_MORE_SET, 7, "01");
    struct mip_measurements_own own;
    struct mip_measurements_radio radio;
    CHECK(MIP_MEASUREMENTS_OWN == MIP_KEY(MIP_MORE_SET, 7) && mip_field_key(&field) == MIP_MEASUREMENTS_OWN);
    CHECK(mip_measurements_own_decode(&own, &field) == MIP_OK && own.mode == MIP_MODE_FAST);
    CHECK(mip_measurements_radio_decode(&radio, &field) == MIP_ERROR_SET);
    /* A packet that was not begun has no set. */
    struct mip_builder none;
    CHECK(mip_builder_start(&none, buffer, 5, MIP_COPY_SET) == MIP_ERROR_LENGTH && mip_builder_set(&none) == 0);
    CHECK(mip_measurements_accel_encode(&accel, &none) == MIP_ERROR_LENGTH);
    CHECK(mip_measurements_accel_encode_inline(&accel, &none) == MIP_ERROR_SET && none.length == 0);
    CHECK(mip_builder_set(fresh(MIP_COPY_SET)) == MIP_COPY_SET);
}

/* A field is decoded only as its own type. */
static void other_fields(void) {
    struct mip_measurements_accel accel;
    struct mip_field field = field_of(MIP_MORE_SET, MIP_MEASUREMENTS_ACCEL_DESCRIPTOR + 1, "3f800000400000004040000000ff");
    size_t trailing;
    memset(&accel, 0xAA, sizeof(accel));
    CHECK(mip_decode(&mip_measurements_accel_codec, &accel, &field, &trailing) == MIP_ERROR_DESCRIPTOR);
    CHECK(trailing == 14 && accel.valid_flags == 0);
    CHECK(mip_measurements_accel_decode_inline(&accel, &field) == MIP_ERROR_DESCRIPTOR);
    /* Shared fields are in every data set, the acknowledge is in every command set. */
    struct mip_shared_timestamp time;
    struct mip_protocol_acknowledge ack;
    for (unsigned set = 1; set < 256; set++) {
        field = field_of((uint8_t)set, MIP_SHARED_TIMESTAMP_DESCRIPTOR, "000000000000000000000000000000000000");
        CHECK((mip_shared_timestamp_decode(&time, &field) == MIP_OK) == (set >= 0x80));
        CHECK((mip_field_key(&field) == MIP_SHARED_TIMESTAMP) == (set >= 0x80));
        field = field_of((uint8_t)set, MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR, "0100");
        CHECK(mip_protocol_acknowledge_decode(&ack, &field) == (set < 0x80 ? MIP_OK : MIP_ERROR_SET));
        CHECK((mip_field_key(&field) == MIP_PROTOCOL_ACKNOWLEDGE) == (set < 0x80));
    }
}

/* The names of values; those without one, and numbers that C cannot have in an enumeration. */
static void names_of_values(void) {
    CHECK(strcmp(mip_mode_name(MIP_MODE_FAST), "fast") == 0 && mip_mode_name(0x77) == NULL);
    CHECK(strcmp(mip_wide_code_name(MIP_WIDE_CODE_HIGH), "high") == 0 && mip_wide_code_name(0x77) == NULL);
}

static void unions(void) {
    union mip_tools_choice_parameters u;
    memset(&u, 0, sizeof(u));
    u.circle.center.x = 1;
    u.circle.center.y = -2;
    u.circle.fill = MIP_TOOLS_FILL_SOLID;
    u.circle.filling.solid = 255;
    struct mip_tools_choice v;
    mip_tools_choice_write(&v, 1, MIP_TOOLS_SHAPE_CIRCLE, &u);
    CHECK(ENCODES(tools_choice, &v, "0101010001fffe01000000ff"));
    mip_tools_choice_write(&v, 1, MIP_TOOLS_SHAPE_NONE, NULL);
    CHECK(ENCODES(tools_choice, &v, "010100"));
    v.shape = 0x99; /* unknown: the union is empty */
    CHECK(ENCODES(tools_choice, &v, "010199"));
    struct mip_field field = field_of(1, 8, "010104414243444546474821");
    size_t trailing;
    CHECK(mip_decode(&mip_tools_choice_codec, &v, &field, &trailing) == MIP_OK && trailing == 1);
    CHECK(strcmp(v.parameters.label, "ABCDEFGH") == 0 && v.present == 3);
}

static void strings(void) {
    struct mip_measurements_strings s;
    memset(&s, 0, sizeof(s));
    mip_copy_text(s.model, sizeof(s.model), "CV7");
    CHECK(strcmp(s.model, "CV7             ") == 0);
    mip_copy_text(s.model, sizeof(s.model), "longer than sixteen bytes");
    CHECK(strcmp(s.model, "longer than sixt") == 0);
    s.length = 2;
    memcpy(s.name, "ab", 2);
    s.rest_count = 3;
    memcpy(s.rest, "xyz", 3);
    CHECK(ENCODES(measurements_strings, &s, "6c6f6e676572207468616e2073697874026162"
                                            "78797a"));
    struct mip_measurements_strings t;
    struct mip_field field = field_of(0x81, MIP_MEASUREMENTS_STRINGS_DESCRIPTOR, "30313233343536373839616263646566016a6b");
    CHECK(mip_measurements_strings_decode(&t, &field) == MIP_OK);
    CHECK(strcmp(t.model, "0123456789abcdef") == 0 && strcmp(t.name, "j") == 0);
    CHECK(t.rest_count == 1 && strcmp(t.rest, "k") == 0);
}

/* If a descriptor has several layouts, a field is decoded only as its own one. */
static void layouts(void) {
    struct mip_tools_status_long wanted;
    struct mip_tools_status_old old;
    struct mip_tools_status_short brief;
    size_t trailing;
    struct mip_field field = field_of(1, 0x90, "126702000000010000000000000005");
    CHECK(mip_field_key(&field) == MIP_TOOLS_STATUS_LONG && MIP_TOOLS_STATUS_LONG == MIP_TOOLS_STATUS_OLD);
    CHECK(mip_tools_status_long_decode(&wanted, &field) == MIP_OK && wanted.flags == 1 && wanted.uptime == 5);
    memset(&old, 0xAA, sizeof(old));
    CHECK(mip_decode(&mip_tools_status_old_codec, &old, &field, &trailing) == MIP_ERROR_LAYOUT);
    CHECK(old.uptime == 0 && trailing == field.size);
    CHECK(mip_tools_status_short_decode(&brief, &field) == MIP_ERROR_LAYOUT);
    /* Too short for any: the bytes that are there must match. */
    field = field_of(1, 0x90, "1267");
    CHECK(mip_tools_status_short_decode(&brief, &field) == MIP_ERROR_TRUNCATED);
    field = field_of(1, 0x90, "126702");
    CHECK(mip_tools_status_short_decode(&brief, &field) == MIP_ERROR_LAYOUT);
}

static void constants(void) {
    struct mip_tools_status command;
    mip_tools_status_make(&command, 2);
    CHECK(ENCODES(tools_status, &command, "126702"));
    struct mip_tools_status_long status;
    struct mip_field field = field_of(1, 0x90, "1267010000000100000000000000ff");
    CHECK(mip_tools_status_long_decode(&status, &field) == MIP_ERROR_LAYOUT && status.uptime == 0);
    field = field_of(1, 4, "126802");
    CHECK(mip_tools_status_decode(&command, &field) == MIP_ERROR_CONSTANT && command.selector == 0);
    CHECK(sizeof(MIP_TOOLS_STATUS_NAME) == sizeof("tools.status") && mip_tools_status_exchange.timeout == 10 /* 2.5 s */);
    /* Keywords, and a parameter with the name of a member that generated code uses itself. */
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
    refused();
    sets();
    several_sets();
    other_fields();
    names_of_values();
    unions();
    wide_tags();
    strings();
    layouts();
    constants();
    return 0;
}
