/* Functions of the registry, of reflection and of device profiles; a generated test looks at every row of their tables. */
#include "check.h"

#include "mip/extra/names.h"
#include "mip/extra/profiles.h"
#include "mip/measurements.h"
#include "mip/extra/reflect.h"
#include "mip/extra/registry.h"
#include "mip/tools.h"

static bool is(const char *a, const char *b) {
    return a != NULL && strcmp(a, b) == 0;
}

static void registry(void) {
    size_t count = 0;
    for (const struct mip_entry *e = NULL; (e = mip_registry_next(1, 0x90, e)) != NULL; count++) {
        CHECK(e->descriptor == 0x90);
    }
    CHECK(count == 5 && mip_registry_next(1, 0x7F, NULL) == NULL && mip_registry_next(0x55, 0x01, NULL) == NULL);
    const struct mip_entry *bias = mip_registry_by_name("tools.bias", NULL);
    CHECK(mip_registry_link(bias, 0)->codec == &mip_tools_bias_vector_codec && mip_registry_link(bias, 1) == NULL);
    static const char *const unknown[] = {"no.such_field", "more.radio", "copy.own", "measurements.own", "more", "", "accel",
                                          "more.", "moreaccel", "mor.accel"};
    for (size_t i = 0; i < sizeof(unknown) / sizeof(unknown[0]); i++) {
        uint8_t set = 0x77;
        CHECK(mip_registry_by_name(unknown[i], &set) == NULL && set == 0x77);
    }
    CHECK(is(mip_registry_set(0x92)->name, "copy") && mip_registry_set(0x93) == NULL && mip_registry_set(0xFE) == NULL);
    for (size_t i = 0; i < mip_registry_set_count; i++) {
        CHECK(mip_registry_set(mip_registry_sets[i].number) == &mip_registry_sets[i]);
    }
    static const struct mip_codec other = {0, 0, 0, 0, 0, 0, false, NULL, NULL};
    CHECK(mip_reflect(&other) == NULL);
}

static void names(void) {
    const struct mip_parameter *use = &mip_reflect(&mip_tools_pin_codec)->record->parameters[2];
    CHECK(is(mip_value_name(use->readings[1].names, MIP_TOOLS_SERIAL_USE_TRANSMIT), "transmit"));
    CHECK(mip_value_name(use->readings[1].names, 99) == NULL);
    const struct mip_names *flags = mip_reflect(&mip_measurements_accel_codec)->record->parameters[1].names;
    CHECK(flags == &mip_names_state_flags && flags->bits[2].first == 4 && flags->bits[2].width == 3);
    CHECK(mip_names_number(flags, 0) == 0 && mip_value_name(flags, 1) == NULL);
    CHECK(flags->bits[3].names == &mip_names_mode && mip_names_tools_shape.count == 5);
}

static void devices(void) {
    const struct mip_profile *a = mip_profile_find("model-a");
    const struct mip_profile *b = mip_profile_find("model-b");
    CHECK(mip_profile_count == 5 && a == &mip_profile_model_a && b == &mip_profile_model_b);
    CHECK(mip_profile_find("model-d") == NULL && mip_profile_find("") == NULL && mip_profile_find("  ") == NULL);
    /* As a device sends it. */
    CHECK(mip_profile_find("     model-a") == a && mip_profile_find("model-a    ") == a);
    CHECK(mip_profile_find("model-a b") == NULL && mip_profile_find("model- a") == NULL && mip_profile_find("model") == NULL);
    CHECK(mip_profile_by_model(0) == NULL && mip_profile_by_model(4003) == NULL);
    const struct mip_profile *old = mip_profile_by_model(4001);
    CHECK(mip_profile_find_field(old, 0x80, 0x03) == NULL && mip_profile_support(old, 0x80, 0x03) == MIP_SUPPORT_UNKNOWN);
    CHECK(mip_profile_base_rate(b, 0x81) < 0);
    CHECK(mip_profile_reading_of(a, "protocol.acknowledge.code") == NULL);
    CHECK(mip_profile_reading_of(b, "measurements.accel.scaled_accel") == NULL); /* another unit, but no type */
}

static uint16_t number_of(const char *text) {
    return mip_model_number(text, strlen(text));
}

/* The start of the model and serial numbers in the device information. */
static void model_numbers(void) {
    static const struct {
        const char *text;
        uint16_t number;
    } known[] = {{"6254", 6254}, {"  6254-4220      ", 6254}, {"6251.12345", 6251}, {"6254 x", 6254}, {"06254", 6254}, {"65535", 65535}, {"625", 625}, {" 42-1234", 42}, {"", 0}, {" ", 0}, {"-", 0}, {"GX5-15", 0}, {"6254x", 0}, {"-6254", 0}, {"65536", 0}, {"99999999999", 0}, {"0000", 0}, {"+6254", 0}, {"6254\xB2", 0}};
    for (size_t i = 0; i < sizeof(known) / sizeof(known[0]); i++) {
        CHECK(number_of(known[i].text) == known[i].number);
    }
    CHECK(mip_model_number("6254\0\0", 6) == 6254 && mip_model_number("62549", 4) == 6254);
    CHECK(mip_model_number(NULL, 0) == 0);
}

int main(void) {
    registry();
    names();
    devices();
    model_numbers();
    return 0;
}
