/* Builder, field walk and parser, as far as the conformance driver and the fuzz targets do not reach. */
#include "check.h"

static const char PING[] = "\x75\x65\x01\x02\x02\x01\xE0\xC6";

static void builder(void) {
    uint8_t buffer[MIP_MAX_PACKET + 8];
    uint8_t data[MIP_MAX_FIELD_DATA];
    struct mip_builder b;
    struct mip_packet packet;
    memset(data, 0xA5, sizeof(data));
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 1) == MIP_OK && mip_builder_set(&b) == 1);
    CHECK(is_packet(mip_builder_finish(&b), "\x75\x65\x01\x00\xDB\x05", 6)); /* an empty payload */
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_OK && b.error == MIP_OK);
    CHECK(is_packet(mip_builder_finish(&b), PING, 8));

    /* A field that does not fit is rejected, and the packet stays as it was. */
    CHECK(mip_builder_add(&b, 2, data, MIP_MAX_FIELD_DATA) == MIP_ERROR_LENGTH);
    CHECK(is_packet(mip_builder_finish(&b), PING, 8));
    CHECK(mip_builder_add(&b, 2, data, MIP_MAX_FIELD_DATA - 2) == MIP_OK);
    CHECK(b.error == MIP_ERROR_LENGTH); /* a program that checks only at the end still sees it */
    packet = mip_builder_finish(&b);
    CHECK(packet.size == MIP_MAX_PACKET && mip_packet_check(packet.bytes, packet.size, &packet) == MIP_OK);
    CHECK(mip_builder_add(&b, 3, NULL, 0) == MIP_ERROR_LENGTH);

    CHECK(mip_builder_start(&b, buffer, 5, 1) == MIP_ERROR_LENGTH);
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_ERROR_LENGTH && mip_builder_finish(&b).size == 0);
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0) == MIP_ERROR_SET);
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0xFF) == MIP_ERROR_SET);
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_ERROR_LENGTH && mip_builder_finish(&b).size == 0);
}

/* What is not a packet has no fields. */
static void walk_of_nothing(void) {
    uint8_t buffer[8] = {0x75, 0x65, 0x01, 0xFF, 0x01, 0x01, 0x01, 0x01};
    struct mip_builder b;
    struct mip_field field;
    for (size_t capacity = 0; capacity < 6; capacity++) {
        CHECK(mip_builder_start(&b, buffer, capacity, 1) == MIP_ERROR_LENGTH);
        const struct mip_packet packet = mip_builder_finish(&b);
        struct mip_walk w = mip_walk_packet(&packet);
        CHECK(packet.size == 0 && !mip_walk_next(&w, &field) && w.error == MIP_OK);
    }
    const struct mip_packet none = {NULL, 0, 0};
    struct mip_walk w = mip_walk_packet(&none);
    CHECK(!mip_walk_next(&w, &field));
    /* Nor do no bytes make a packet. */
    struct mip_parser p;
    struct mip_packet found;
    const uint8_t *data = NULL;
    size_t size = 0;
    mip_parser_init(&p);
    CHECK(!mip_parser_next(&p, &data, &size, &found));
}

/* A packet is copied only if the end of the caller's bytes cuts it; noise does not change that. Its position always
 * follows from the bytes consumed and those that the parser still holds. */
static void in_place(void) {
    static const uint8_t stream[] = "\x75\x65\x01\xFF\x75\x65\x01\x02\x02\x01\xE0\xC6"
                                    "\x75\x65\x01\x02\x02\x01\xE0\xC6";
    const size_t whole = sizeof(stream) - 1;
    struct mip_parser p;
    struct mip_packet packet;
    for (size_t cut = 1; cut < whole; cut++) {
        const uint8_t *data = stream;
        size_t size = cut;
        mip_parser_init(&p);
        CHECK(!mip_parser_next(&p, &data, &size, &packet)); /* a false start holds everything back */
        data = stream + cut;
        size = whole - cut;
        CHECK(!mip_parser_next(&p, &data, &size, &packet) && size == 0);
        CHECK(mip_parser_flush(&p, &packet) && mip_parser_flush(&p, &packet) && p.skipped == 4);
    }
    for (size_t cut = 4; cut <= whole; cut++) {
        const uint8_t *data = stream + 4;
        size_t size = cut - 4;
        size_t found = 0;
        mip_parser_init(&p);
        for (int part = 0; part < 2; part++) {
            while (mip_parser_next(&p, &data, &size, &packet)) {
                const bool is_cut = 4 + 8 * found < cut && cut < 12 + 8 * found;
                CHECK(is_packet(packet, PING, 8));
                CHECK((packet.bytes == stream + 4 + 8 * found) != is_cut);
                CHECK((packet.bytes == p.buffer) == is_cut);
                CHECK(data == stream + 12 + 8 * found && p.length == p.done);
                found++;
            }
            data = stream + cut;
            size = whole - cut;
        }
        CHECK(found == 2 && p.skipped == 0);
    }
}

static void names(void) {
    CHECK(strcmp(mip_error_name(MIP_OK), "ok") == 0);
    CHECK(strcmp(mip_error_name(MIP_ERROR_FIELD_LENGTH), "field_length") == 0);
    CHECK(strcmp(mip_error_name(MIP_ERROR_MISSING), "missing") == 0);
    CHECK(strcmp(mip_error_name(MIP_ERROR_SET), "set") == 0);
    CHECK(strcmp(mip_error_name(MIP_ERROR_LAYOUT), "layout") == 0);
}

int main(void) {
    CHECK(mip_version() == MIP_VERSION_NUMBER);
    builder();
    walk_of_nothing();
    in_place();
    names();
    return 0;
}
