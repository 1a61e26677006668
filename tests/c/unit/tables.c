/* Registry, reflection and device profiles. */
#include "check.h"

#include "mip/profiles.h"
#include "mip/measurements.h"
#include "mip/protocol.h"
#include "mip/reflect.h"
#include "mip/registry.h"
#include "mip/shared.h"
#include "mip/tools.h"

static bool is(const char *a, const char *b) {
    return a != NULL && strcmp(a, b) == 0;
}

static void registry(void) {
    /* Layouts are told apart by constants, as far as the data reach, then by size. */
    struct mip_field field = field_of(1, 0x90, "1267");
    CHECK(is(mip_registry_find(&field)->name, "status_paged"));
    field = field_of(1, 0x90, "12670100");
    CHECK(is(mip_registry_find(&field)->name, "status_short"));
    field = field_of(1, 0x90, "126703");
    CHECK(mip_registry_find(&field) == NULL);
    static const uint8_t data[253] = {0x12, 0x67, 0x02};
    for (uint8_t size = 3; size <= 253; size++) {
        field.data = data;
        field.size = size;
        CHECK(is(mip_registry_find(&field)->name, size < 15    ? "status_old"
                                                  : size == 15 ? "status_long"
                                                               : "status_full"));
    }
    size_t count = 0;
    for (const struct mip_entry *e = NULL; (e = mip_registry_next(1, 0x90, e)) != NULL; count++) {
        CHECK(e->descriptor == 0x90);
    }
    CHECK(count == 5 && mip_registry_next(1, 0x7F, NULL) == NULL && mip_registry_next(0x55, 0x01, NULL) == NULL);
    field = field_of(0x55, 0xF1, "");
    CHECK(mip_registry_find(&field)->codec == &mip_protocol_acknowledge_codec);
    field = field_of(0x99, 0xD3, "");
    CHECK(is(mip_registry_find(&field)->name, "timestamp"));
    field = field_of(0x81, 0x01, "");
    CHECK(is(mip_registry_find(&field)->name, "accel"));
    CHECK(mip_registry_find(&field)->codec == &mip_measurements_accel_codec);

    /* Commands and responses, both ways. */
    const struct mip_entry *bias = mip_registry_by_name("tools.bias", NULL);
    const struct mip_entry *vector = mip_registry_link(bias, 0);
    CHECK(vector->codec == &mip_tools_bias_vector_codec && mip_registry_link(bias, 1) == NULL);
    CHECK(mip_registry_link(vector, 0) == bias);
    CHECK(mip_registry_link(vector, 1)->codec == &mip_tools_capture_bias_codec);
    CHECK(mip_registry_link(vector, 2) == NULL);
    CHECK(is(mip_registry_link(mip_registry_by_name("tools.set_time", NULL), 1)->name, "set_time_slow_response"));
    for (size_t i = 0; i < mip_registry_size; i++) {
        const struct mip_entry *e = &mip_registry[i];
        CHECK(mip_reflect(e->codec) != NULL && mip_reflect(e->codec)->record->size == e->codec->size);
        for (size_t k = 0; k < e->link_count; k++) {
            CHECK(mip_registry_link(e, k)->role == (e->role == MIP_COMMAND ? MIP_RESPONSE : MIP_COMMAND));
        }
    }
}

/* A type has a name in each set in which it occurs, and another type may have its descriptor in others. */
static void names_by_set(void) {
    static const struct {
        const char *name;
        uint8_t set;
        const struct mip_codec *codec;
    } known[] = {
        {"measurements.accel", 0x80, &mip_measurements_accel_codec},
        {"more.accel", 0x81, &mip_measurements_accel_codec},
        {"copy.accel", 0x92, &mip_measurements_accel_codec},
        {"measurements.radio", 0x80, &mip_measurements_radio_codec},
        {"more.own", 0x81, &mip_measurements_own_codec},
        {"copy.radio", 0x92, &mip_measurements_radio_codec},
        {"tools.ping", 0x01, &mip_tools_ping_codec},
        {"shared.timestamp", 0xFF, &mip_shared_timestamp_codec},
        {"protocol.acknowledge", 0, &mip_protocol_acknowledge_codec},
    };
    for (size_t i = 0; i < sizeof(known) / sizeof(known[0]); i++) {
        uint8_t set = 0x77;
        const struct mip_entry *entry = mip_registry_by_name(known[i].name, &set);
        CHECK(entry != NULL && entry->codec == known[i].codec && set == known[i].set);
        CHECK(mip_registry_by_name(known[i].name, NULL) == entry);
        const uint8_t packet = set == 0 ? 0x55 : set == 0xFF ? 0x92
                                                             : set; /* one in which it may occur */
        const struct mip_field field = {NULL, 0, packet, entry->descriptor};
        CHECK(mip_registry_find(&field) == entry && mip_registry_next(packet, entry->descriptor, NULL) == entry);
        CHECK(mip_registry_next(packet, entry->descriptor, entry) == NULL);
        const char *name = mip_registry_set_name(entry, packet);
        CHECK(strncmp(name, known[i].name, strlen(name)) == 0 && is(known[i].name + strlen(name) + 1, entry->name));
    }
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
}

/* Commands, responses and data occur in packets of their own set, the acknowledge in those of all command sets, shared
 * data in those of all data sets. */
static void sets(void) {
    static union {
        double aligned;
        uint8_t bytes[8192];
    } value;
    uint8_t buffer[MIP_MAX_PACKET];
    for (size_t i = 0; i < mip_registry_size; i++) {
        const struct mip_entry *e = &mip_registry[i];
        CHECK(e->codec->size <= sizeof(value));
        for (unsigned set = 1; set < 0xFF; set++) {
            const bool right = mip_codec_belongs(e->codec, (uint8_t)set);
            struct mip_builder b;
            CHECK(mip_builder_start(&b, buffer, sizeof(buffer), (uint8_t)set) == MIP_OK);
            CHECK(mip_encode(e->codec, &value, &b) == (right ? MIP_OK : MIP_ERROR_SET));
            CHECK(right == (b.length > MIP_HEADER_SIZE) && buffer[3] == b.length - MIP_HEADER_SIZE);
        }
    }
}

static void reflection(void) {
    const struct mip_reflection *r = mip_reflect(&mip_tools_pin_codec);
    const struct mip_parameter *use = &r->record->parameters[2];
    CHECK(r->selector && r->optional && r->record->count == 3 && is(use->name, "use"));
    CHECK(use->count == 2 && use->readings[1].by == 1 && use->readings[1].value == MIP_TOOLS_DRIVE_SERIAL);
    CHECK(is(mip_value_name(use->readings[1].names, MIP_TOOLS_SERIAL_USE_TRANSMIT), "transmit"));
    CHECK(mip_value_name(use->readings[1].names, 99) == NULL);
    r = mip_reflect(&mip_measurements_accel_codec);
    CHECK(is(r->record->parameters[0].unit, "g") && r->record->parameters[0].elements == 3);
    const struct mip_names *flags = r->record->parameters[1].names;
    CHECK(flags == mip_names_find("state_flags") && flags->bits[2].first == 4 && flags->bits[2].width == 3);
    CHECK(mip_names_number(flags, 0) == 0);
    CHECK(flags->bits[3].names == mip_names_find("mode") && mip_value_name(flags, 1) == NULL);
    CHECK(mip_names_find("tools.shape")->count == 5 && mip_names_find("nothing") == NULL);
    r = mip_reflect(&mip_tools_status_short_codec);
    CHECK(is(r->record->parameters[2].readings[1].device, "model-b"));
    static const struct mip_codec other = {0, 0, 0, 0, 0, 0, false, NULL, NULL};
    CHECK(mip_reflect(&other) == NULL);
}

static void devices(void) {
    const struct mip_profile *a = mip_profile_find("model-a");
    const struct mip_profile *b = mip_profile_find("model-b");
    CHECK(mip_profile_count == 5 && a == &mip_profile_model_a && b == &mip_profile_model_b);
    CHECK(mip_profile_find("model-d") == NULL && mip_profile_find("") == NULL && mip_profile_find("  ") == NULL);
    /* As a device sends it. */
    CHECK(mip_profile_find("     model-a") == a && mip_profile_find("model-a    ") == a);
    CHECK(mip_profile_find("model-a b") == NULL && mip_profile_find("model- a") == NULL && mip_profile_find("model") == NULL);
    CHECK(a->model_number == 4711 && b->model_number == 0);
    CHECK(is(mip_profile_find_field(a, MIP_TOOLS_SET, MIP_TOOLS_SETTINGS_DESCRIPTOR)->functions, "WRSLDA"));
    CHECK(is(mip_profile_find_field(b, MIP_TOOLS_SET, MIP_TOOLS_SETTINGS_DESCRIPTOR)->functions, "WR"));
    CHECK(is(mip_profile_find_field(b, MIP_TOOLS_SET, MIP_TOOLS_PING_DESCRIPTOR)->functions, ""));
    CHECK(mip_profile_find_field(b, MIP_TOOLS_SET, MIP_TOOLS_CHOICE_DESCRIPTOR) == NULL);
    CHECK(mip_profile_support(b, MIP_TOOLS_SET, MIP_TOOLS_CHOICE_DESCRIPTOR) == MIP_SUPPORT_NO);
    CHECK(mip_profile_support(a, MIP_TOOLS_SET, MIP_TOOLS_CHOICE_DESCRIPTOR) == MIP_SUPPORT_YES);
    CHECK(mip_profile_base_rate(a, 0x80) > 999 && mip_profile_base_rate(a, 0x80) < 1001);
    CHECK(mip_profile_base_rate(b, 0x81) < 0);
    CHECK(is(mip_profile_reading_of(b, "protocol.acknowledge.code"), "mode"));
    CHECK(mip_profile_reading_of(a, "protocol.acknowledge.code") == NULL);
    CHECK(mip_profile_reading_of(b, "measurements.accel.scaled_accel") == NULL); /* another unit, but no type */
    CHECK(is(mip_profile_reading_of(a, "tools.status_short.flags"), "tools.model_a_faults"));
    CHECK(a->port_count == 2 && a->ports[0].id == 0x11 && a->ports[0].baud_rates[1] == 115200);
    CHECK(is(a->ports[1].name, "USB") && a->ports[1].id == 0); /* it has none */
    CHECK(is(a->ports[0].receives, "MIP, NMEA") && is(a->ports[1].sends, "MIP") && a->ports[1].baud_rate_count == 0);
    CHECK(a->note_count == 1 && a->notes[0].rows == 3 && a->notes[0].columns == 2);
    CHECK(is(a->notes[0].cells[3], "pulse") && is(a->limits[1].unit, "g") && a->ack_codes[2] == 3);
}

static void uncertain(void) {
    const struct mip_profile *old = mip_profile_by_model(4001);
    CHECK(old == mip_profile_find("First") && old == mip_profile_find("Old 1") && old == mip_profile_find("old-1"));
    CHECK(mip_profile_by_model(0) == NULL && mip_profile_by_model(4003) == NULL);
    CHECK(old->generation == 1 && is(old->manual, "") && is(mip_profiles[0]->manual, "guide"));
    CHECK(old->incomplete_count == 1 && is(old->incomplete[0], "No manual is known; see `tools.ping`."));
    CHECK(mip_profile_support(old, 0x01, 0x01) == MIP_SUPPORT_YES);
    CHECK(mip_profile_support(old, 0x80, 0x02) == MIP_SUPPORT_PROBABLE);
    CHECK(is(mip_profile_find_field(old, 0x80, 0x02)->evidence->why,
             "Supported by devices of the same generation, Model A and Model B."));
    CHECK(mip_profile_find_field(old, 0x80, 0x03) == NULL);
    CHECK(mip_profile_support(old, 0x80, 0x03) == MIP_SUPPORT_UNKNOWN);
    const struct mip_profile *c = mip_profile_find("Model C");
    CHECK(c->refused_count == 1 && mip_profile_support(c, 0x01, 0x08) == MIP_SUPPORT_NO);
    CHECK(is(mip_profile_find_field(c, 0x01, 0x08)->evidence->why, "Rejected by the device (firmware 1.2)."));
    CHECK(is(mip_profile_firmware_of(c, 0x01, 0x06), ">= 1.0, < 1.1") && mip_profile_firmware_of(c, 0x01, 0x01) == NULL);
    CHECK(is(c->limits[0].firmware, "< 2.0") && is(mip_profile_find("Model A")->limits[0].firmware, ""));
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
    names_by_set();
    sets();
    reflection();
    devices();
    uncertain();
    model_numbers();
    return 0;
}
