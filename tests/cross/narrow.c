/* Doubles of the wire on a machine whose doubles have four bytes: by the table and by the direct decoder. */
#include "check.h"

#include "mip/measurements_inline.h"

/* A flag, a signed number, two floats, two doubles: 1.5, and 0.1 as a double of eight bytes has it. */
static const char DATA[] = "01fffffffe3fc00000c0100000"
                           "3ff80000000000003fb999999999999a";
/* The result: 0.1 is rounded to a float. */
static const char CUT[] = "01fffffffe3fc00000c0100000"
                          "3ff80000000000003fb99999a0000000";

static void check(const struct mip_measurements_radio *v) {
    CHECK(v->connected == 1 && v->strength == -2);
    CHECK(v->noise >= 1.5F && v->noise <= 1.5F && v->gap >= -2.25F && v->gap <= -2.25F);
    CHECK(v->gaps[0] >= 1.5 && v->gaps[0] <= 1.5 && v->gaps[1] >= 0.1 && v->gaps[1] <= 0.1);
}

int main(void) {
    struct {
        struct mip_measurements_radio value;
        uint8_t behind[16];
    } place;
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder b;
    const struct mip_field field = field_of(0x80, 0x07, DATA);
    CHECK(sizeof(double) == 4);

    memset(&place, 0xAA, sizeof(place));
    CHECK(mip_measurements_radio_decode(&place.value, &field) == MIP_OK);
    check(&place.value);
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0x80) == MIP_OK);
    CHECK(mip_measurements_radio_encode(&place.value, &b) == MIP_OK && strcmp(only_field(&b), CUT) == 0);

    memset(&place.value, 0, sizeof(place.value));
    CHECK(mip_measurements_radio_decode_inline(&place.value, &field) == MIP_OK);
    check(&place.value);
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0x80) == MIP_OK);
    CHECK(mip_measurements_radio_encode_inline(&place.value, &b) == MIP_OK && strcmp(only_field(&b), CUT) == 0);
    for (size_t i = 0; i < sizeof(place.behind); i++) {
        CHECK(place.behind[i] == 0xAA);
    }
    return 0;
}
