/* Pieces of a stream, and the index of a log: whatever the chunks, each byte comes once and in order, and the packets
 * are those that the parser finds. */
#include "check.h"

#include "mip/stream.h"

#define SIZE 700

static uint8_t log_bytes[SIZE];

/* Numbers that look random, and are the same everywhere. */
static uint32_t number(uint32_t below) {
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % below;
}

/* Packets, sentences, false syncs, broken packets and noise; the last of it may be cut. */
static void fill(void) {
    static const char *const texts[] = {"$GPGGA,1*00\r\n", "\x75", "\x75\x65", "\x75\x65\x01\xF0", "\x75\x65\x80\x04"};
    size_t size = 0;
    while (size < SIZE) {
        uint8_t bytes[MIP_MAX_PACKET];
        struct mip_builder builder;
        const uint8_t *from = bytes;
        size_t count;
        if (number(3) == 0) {
            from = (const uint8_t *)texts[number(5)];
            count = strlen((const char *)from);
        } else {
            static const uint8_t data[40] = {0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6};
            CHECK(mip_builder_start(&builder, bytes, sizeof(bytes), 0x80) == MIP_OK);
            for (uint32_t fields = number(4); fields > 0; fields--) {
                CHECK(mip_builder_add(&builder, 4, data, (uint8_t)number(sizeof(data))) == MIP_OK);
            }
            count = mip_builder_finish(&builder).size;
            bytes[number((uint32_t)count)] ^= (uint8_t)(number(4) == 0);
        }
        for (size_t i = 0; i < count && size < SIZE; i++) {
            log_bytes[size++] = from[i];
        }
    }
}

/* The positions of the packets that the parser finds. */
static size_t wanted[SIZE];
static size_t wanted_count;

static void find(void) {
    struct mip_parser parser;
    struct mip_packet packet;
    uint32_t skipped = 0;
    size_t at = 0;
    wanted_count = 0;
    mip_parser_init(&parser);
    for (size_t i = 0; i <= SIZE; i++) {
        const uint8_t *data = log_bytes + i;
        size_t size = i < SIZE;
        while (i < SIZE ? mip_parser_next(&parser, &data, &size, &packet) : mip_parser_flush(&parser, &packet)) {
            at += parser.skipped - skipped;
            skipped = parser.skipped;
            wanted[wanted_count++] = at;
            at += packet.size;
        }
    }
    CHECK(at + parser.skipped - skipped == SIZE);
}

static size_t next_place, next_packet;

static void look(const struct mip_piece *piece) {
    CHECK(piece->offset == next_place && piece->size > 0 && piece->size <= SIZE - next_place);
    CHECK(memcmp(piece->bytes, log_bytes + next_place, piece->size) == 0);
    if (piece->packet != NULL) {
        struct mip_packet packet;
        CHECK(next_packet < wanted_count && wanted[next_packet] == next_place);
        CHECK(piece->packet->bytes == piece->bytes && piece->packet->size == piece->size);
        CHECK(mip_packet_check(piece->bytes, piece->size, &packet) == MIP_OK);
        next_packet++;
    } else {
        CHECK(next_packet == wanted_count || wanted[next_packet] >= next_place + piece->size);
    }
    next_place += piece->size;
}

static void pieces(size_t chunk) {
    struct mip_stream stream;
    struct mip_piece piece;
    next_place = next_packet = 0;
    mip_stream_init(&stream);
    for (size_t at = 0; at < SIZE;) {
        uint8_t bytes[SIZE]; /* gone after the chunk */
        size_t size = chunk > 0 ? chunk : 1 + number(300);
        size = size < SIZE - at ? size : SIZE - at;
        memcpy(bytes, log_bytes + at, size);
        at += size;
        const uint8_t *data = bytes;
        while (mip_stream_next(&stream, &data, &size, &piece)) {
            look(&piece);
        }
        CHECK(size == 0);
        memset(bytes, 0x75, sizeof(bytes));
    }
    while (mip_stream_flush(&stream, &piece)) {
        look(&piece);
    }
    CHECK(next_place == SIZE && next_packet == wanted_count && stream.offset == SIZE);
}

/* In one call, in calls for a few places each, and while the log grows. */
static void indexes(void) {
    size_t places[SIZE], at = 0, count, all = 0;
    CHECK(mip_index(log_bytes, SIZE, true, &at, places, SIZE) == wanted_count && at == SIZE);
    CHECK(memcmp(places, wanted, wanted_count * sizeof(wanted[0])) == 0);
    CHECK(mip_index(log_bytes, SIZE, true, &at, places, SIZE) == 0);

    const size_t room = 1 + number(4);
    at = 0;
    while ((count = mip_index(log_bytes, SIZE, true, &at, places, room)) > 0) {
        CHECK(memcmp(places, wanted + all, count * sizeof(wanted[0])) == 0);
        all += count;
    }
    CHECK(all == wanted_count && at == SIZE);

    all = at = 0;
    for (size_t size = 0; size <= SIZE; size += 1 + number(60)) {
        const size_t before = at;
        count = mip_index(log_bytes, size, false, &at, places, SIZE);
        CHECK(memcmp(places, wanted + all, count * sizeof(wanted[0])) == 0);
        CHECK(at >= before && at <= size && size - at <= MIP_MAX_PACKET);
        all += count;
    }
    all += mip_index(log_bytes, SIZE, true, &at, places, SIZE);
    CHECK(all == wanted_count && at == SIZE);
    at = 0;
    CHECK(mip_index(log_bytes, 0, true, &at, places, SIZE) == 0 && at == 0);
}

int main(void) {
    unsigned packets = 0;
    for (unsigned round = 0; round < 300; round++) {
        fill();
        find();
        packets += (unsigned)wanted_count;
        indexes();
        for (size_t chunk = 0; chunk < 12; chunk++) {
            pieces(chunk);
        }
        pieces(SIZE);
    }
    CHECK(packets > 300);
    return 0;
}
