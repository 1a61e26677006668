/* Every truncation of a stream, in pieces of every size: the packets are those that were put there, and all other bytes
 * are skipped. */
#include "check.h"

static uint8_t stream[1200];
static size_t length;
static size_t begins[64], ends[64], packets;

static void add(const void *bytes, size_t size) {
    CHECK(length + size <= sizeof(stream));
    memcpy(stream + length, bytes, size);
    length += size;
}

/* A packet whose data contains sync bytes, the beginning of another one, and no whole one. */
static void add_packet(uint8_t size) {
    uint8_t bytes[MIP_MAX_PACKET], data[MIP_MAX_FIELD_DATA];
    struct mip_builder b;
    for (size_t i = 0; i < size; i++) {
        data[i] = (uint8_t)(i % 4 == 0 ? 0x75 : i % 4 == 1 ? 0x65
                                                           : 0x80 - i);
    }
    CHECK(mip_builder_start(&b, bytes, sizeof(bytes), 0x80) == MIP_OK);
    CHECK(mip_builder_add(&b, 4, data, size) == MIP_OK);
    const struct mip_packet packet = mip_builder_finish(&b);
    begins[packets] = length;
    add(packet.bytes, packet.size);
    ends[packets++] = length;
}

/* What stands between packets: text with and without the first sync byte, a false header that announces a long packet,
 * one byte of a header, and a packet with a wrong checksum. */
static void fill(void) {
    static const char *const between[] = {"$GPGGA,1*00\r\n", "u-blox", "\x75\x65\x80\xFF", "\x75",
                                          "\x75\x65\x01\x02\x02\x01\xE0\xC7", "", "\x75\x65", "uue"};
    for (size_t i = 0; i < sizeof(between) / sizeof(between[0]); i++) {
        add(between[i], strlen(between[i]));
        add_packet((uint8_t)(i * i * 3));
        add_packet((uint8_t)(7 * i));
    }
}

/* The parser must find each packet of the first `size` bytes, and nothing else. */
static void parse(size_t size, size_t piece) {
    struct mip_parser parser;
    struct mip_packet packet;
    size_t found = 0, in_packets = 0;
    mip_parser_init(&parser);
    for (size_t at = 0; at <= size; at += piece) {
        const uint8_t *data = stream + at;
        size_t left = size - at < piece ? size - at : piece;
        bool last = at + piece > size;
        while (mip_parser_next(&parser, &data, &left, &packet) || (last && mip_parser_flush(&parser, &packet))) {
            CHECK(found < packets && ends[found] <= size);
            CHECK(is_packet(packet, (const char *)stream + begins[found], ends[found] - begins[found]));
            in_packets += packet.size;
            found++;
        }
        CHECK(left == 0);
    }
    CHECK(found == packets || ends[found] > size);
    CHECK(parser.skipped == size - in_packets);
}

int main(void) {
    fill();
    CHECK(packets == 16 && length > 700);
    for (size_t piece = 1; piece <= length; piece++) {
        parse(length, piece);
    }
    for (size_t size = 0; size < length; size++) {
        parse(size, 1);
        parse(size, size > 7 ? size / 7 : 1);
        parse(size, length);
    }
    return 0;
}
