/* Checksum, packets, builder, field walk, and the parser as far as its drivers do not reach. */
#include "check.h"

static const char PING[] = "\x75\x65\x01\x02\x02\x01\xE0\xC6";

static void packets(void) {
    const uint8_t *ping = (const uint8_t *)PING;
    uint8_t changed[8];
    struct mip_packet packet;
    CHECK(mip_checksum(ping, 6) == 0xE0C6);
    CHECK(mip_packet_check(ping, 8, &packet) == MIP_OK);
    CHECK(packet.bytes == ping && packet.size == 8 && packet.descriptor_set == 1);
    CHECK(mip_packet_check(ping, 0, &packet) == MIP_ERROR_SYNC);
    CHECK(mip_packet_check(ping, 1, &packet) == MIP_ERROR_SYNC);
    CHECK(mip_packet_check(ping, 2, &packet) == MIP_ERROR_LENGTH);
    CHECK(mip_packet_check(ping, 7, &packet) == MIP_ERROR_LENGTH);
    memcpy(changed, ping, 8);
    changed[7] ^= 1;
    CHECK(mip_packet_check(changed, 8, &packet) == MIP_ERROR_CHECKSUM);
    changed[2] = 0;
    CHECK(mip_packet_check(changed, 8, &packet) == MIP_ERROR_LENGTH);
    changed[1] = 0;
    CHECK(mip_packet_check(changed, 8, &packet) == MIP_ERROR_SYNC);
}

/* The parser, the check and the builder agree: no packet has descriptor set 0 or 0xFF. */
static void sets(void) {
    for (unsigned set = 0; set < 256; set++) {
        uint8_t bytes[8] = {0x75, 0x65, (uint8_t)set, 2, 2, 1, 0, 0};
        uint8_t buffer[MIP_MAX_PACKET] = {0}; /* some compilers do not see that it is not read */
        const bool valid = set > 0 && set < 0xFF;
        const uint16_t sum = mip_checksum(bytes, 6);
        const uint8_t *data = bytes;
        size_t size = sizeof(bytes);
        struct mip_packet packet;
        struct mip_parser p;
        struct mip_builder b;
        mip_put_16(bytes + 6, sum);
        mip_parser_init(&p);
        CHECK(mip_parser_next(&p, &data, &size, &packet) == valid && p.skipped == (valid ? 0 : 8));
        CHECK(mip_packet_check(bytes, sizeof(bytes), &packet) == (valid ? MIP_OK : MIP_ERROR_LENGTH));
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), (uint8_t)set) == (valid ? MIP_OK : MIP_ERROR_SET));
        CHECK(mip_builder_set(&b) == (valid ? set : 0));
    }
}

static void builder(void) {
    uint8_t buffer[MIP_MAX_PACKET + 8];
    uint8_t data[MIP_MAX_FIELD_DATA + 1];
    struct mip_builder b;
    struct mip_packet packet;
    memset(data, 0xA5, sizeof(data));

    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 1) == MIP_OK);
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

    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 1) == MIP_OK);
    CHECK(mip_builder_add(&b, 2, data, MIP_MAX_FIELD_DATA + 1) == MIP_ERROR_LENGTH);
    CHECK(mip_builder_add(&b, 2, data, MIP_MAX_FIELD_DATA) == MIP_OK);

    /* A buffer of the caller that is just large enough, or too small. */
    memset(buffer, 0xEE, sizeof(buffer));
    CHECK(mip_builder_start(&b, buffer, 8, 1) == MIP_OK);
    CHECK(mip_builder_add(&b, 1, data, 1) == MIP_ERROR_LENGTH);
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_OK);
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_ERROR_LENGTH);
    CHECK(is_packet(mip_builder_finish(&b), PING, 8) && buffer[8] == 0xEE);

    CHECK(mip_builder_start(&b, buffer, 5, 1) == MIP_ERROR_LENGTH);
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_ERROR_LENGTH && mip_builder_finish(&b).size == 0);
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0) == MIP_ERROR_SET);
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), 0xFF) == MIP_ERROR_SET);
    CHECK(mip_builder_add(&b, 1, NULL, 0) == MIP_ERROR_LENGTH && mip_builder_finish(&b).size == 0);
}

static void walk(void) {
    static const uint8_t bad[] = {0x75, 0x65, 0x80, 0x06, 0x03, 0x07, 0x11, 0x02, 0x08, 0x01, 0, 0};
    const struct mip_packet packet = {bad, sizeof(bad), 0x80};
    struct mip_walk w = mip_walk_packet(&packet);
    struct mip_field field;
    CHECK(mip_walk_next(&w, &field) && field.descriptor_set == 0x80 && field.descriptor == 7);
    CHECK(field.size == 1 && field.data == bad + 6 && w.error == MIP_OK);
    CHECK(mip_walk_next(&w, &field) && field.descriptor == 8 && field.size == 0);
    CHECK(!mip_walk_next(&w, &field) && w.error == MIP_ERROR_FIELD_LENGTH);
    CHECK(!mip_walk_next(&w, &field) && w.error == MIP_ERROR_FIELD_LENGTH);
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
}

static void parser(void) {
    uint8_t stream[32];
    const uint8_t *data = stream;
    size_t size = 4;
    struct mip_parser p;
    struct mip_packet packet;

    /* A header that promises 200 bytes hides a ping until the caller's time-out has passed. */
    memcpy(stream, "\x75\x65\x01\xC8", 4);
    memcpy(stream + 4, PING, 8);
    memcpy(stream + 12, PING, 8);
    memcpy(stream + 20, PING, 3);
    mip_parser_init(&p);
    size = 23;
    CHECK(!mip_parser_next(&p, &data, &size, &packet) && size == 0 && data == stream + 23);
    CHECK(p.skipped == 0);
    CHECK(mip_parser_flush(&p, &packet) && is_packet(packet, PING, 8) && p.skipped == 4);
    CHECK(mip_parser_flush(&p, &packet) && is_packet(packet, PING, 8));
    CHECK(!mip_parser_flush(&p, &packet) && p.skipped == 7);
    CHECK(!mip_parser_flush(&p, &packet) && p.skipped == 7);

    /* After a flush, and after a flush that returned a packet, the stream goes on. */
    data = stream;
    size = 12;
    CHECK(!mip_parser_next(&p, &data, &size, &packet));
    CHECK(mip_parser_flush(&p, &packet) && is_packet(packet, PING, 8));
    data = stream + 4;
    size = 8;
    CHECK(mip_parser_next(&p, &data, &size, &packet) && is_packet(packet, PING, 8));
    CHECK(!mip_parser_next(&p, &data, &size, &packet) && p.skipped == 11);

    /* No bytes at all. */
    data = NULL;
    size = 0;
    CHECK(!mip_parser_next(&p, &data, &size, &packet));
}

/* Is every packet copied? */
#ifdef __OPTIMIZE_SIZE__
#define COPIED true
#else
#define COPIED false
#endif

/* A packet is copied only if the end of the caller's bytes cuts it, or if the library is built for size; noise does not
 * change that. Its position always follows from the bytes consumed and those that the parser still holds. */
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
                CHECK((packet.bytes == stream + 4 + 8 * found) != (COPIED || is_cut));
                CHECK((packet.bytes == p.buffer) == (COPIED || is_cut));
                CHECK(data == stream + 12 + 8 * found && p.length == p.done);
                found++;
            }
            data = stream + cut;
            size = whole - cut;
        }
        CHECK(found == 2 && p.skipped == 0);
    }
}

/* Fed byte by byte, as an interrupt does: a packet is there with its last byte, and not before. */
static void byte_by_byte(void) {
    static const uint8_t stream[] = "\x75\x75\x65\x01\x02\x02\x01\xE0\xC6"
                                    "\x75\x65\x01\x02\x02\x01\xE0\xC6";
    struct mip_parser p;
    struct mip_packet packet;
    mip_parser_init(&p);
    for (size_t i = 0; i < sizeof(stream) - 1; i++) {
        const uint8_t *data = stream + i;
        size_t size = 1;
        const bool found = mip_parser_next(&p, &data, &size, &packet);
        CHECK(found == (i == 8 || i == 16) && size == 0 && data == stream + i + 1);
        CHECK(!found || is_packet(packet, PING, 8));
    }
    CHECK(p.skipped == 1);
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
    packets();
    sets();
    builder();
    walk();
    walk_of_nothing();
    parser();
    in_place();
    byte_by_byte();
    names();
    return 0;
}
