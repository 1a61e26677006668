/*
 * The stream parser against a plain one that keeps the whole stream and tries every place in order.
 *
 * Input: a byte for the sizes of the pieces, a byte for what happens between them, the stream.
 */
#include "fuzz.h"

#include "mip/core.h"

/* ----------------------------------------------------------------------------- the plain reference */

struct plain {
    const uint8_t *stream;
    size_t end; /* bytes received */
    size_t at;  /* bytes processed */
    size_t skipped;
};

/* What is at a position: a packet (its size), nothing (0), or the start of a possible packet (-1). */
static int packet_at(const struct plain *p, size_t at) {
    const uint8_t *b = p->stream + at;
    const size_t left = p->end - at;
    if (b[0] != 0x75 || (left > 1 && b[1] != 0x65) || (left > 2 && (b[2] == 0 || b[2] == 0xFF))) {
        return 0;
    }
    if (left < 4 || left < b[3] + 6u) {
        return -1;
    }
    const size_t covered = b[3] + 4u;
    uint8_t sum = 0;
    uint8_t sums = 0;
    for (size_t i = 0; i < covered; i++) {
        sum = (uint8_t)(sum + b[i]);
        sums = (uint8_t)(sums + sum);
    }
    return b[covered] == sum && b[covered + 1] == sums ? (int)covered + 2 : 0;
}

/* The size of the next packet, which then ends at p->at; 0 if there is none yet. */
static size_t plain_next(struct plain *p) {
    for (; p->at < p->end; p->at++, p->skipped++) {
        const int size = packet_at(p, p->at);
        if (size < 0) {
            return 0;
        }
        if (size > 0) {
            p->at += (size_t)size;
            return (size_t)size;
        }
    }
    return 0;
}

static size_t plain_flush(struct plain *p) {
    for (;;) {
        const size_t size = plain_next(p);
        if (size > 0 || p->at == p->end) {
            return size;
        }
        p->at++;
        p->skipped++;
    }
}

static size_t plain_look_behind(struct plain *p) {
    const size_t size = plain_next(p);
    if (size > 0) {
        return size;
    }
    for (size_t at = p->at + 1; at < p->end; at++) {
        if (packet_at(p, at) > 0) {
            p->skipped += at - p->at;
            p->at = at;
            return plain_next(p);
        }
    }
    return 0;
}

/* ------------------------------------------------------------------------------------- comparison */

static void compare(const struct mip_parser *parser, const struct plain *p, bool found, const struct mip_packet *packet,
                    size_t size) {
    CHECK(found == (size > 0));
    CHECK(parser->skipped == p->skipped);
    if (found) {
        CHECK(packet->size == size && memcmp(packet->bytes, p->stream + (p->at - size), size) == 0);
        CHECK(packet->descriptor_set == packet->bytes[2]);
        struct mip_packet checked;
        CHECK(mip_packet_check(packet->bytes, packet->size, &checked) == MIP_OK && checked.size == size);
    }
}

static void between(struct mip_parser *parser, struct plain *p, uint8_t what) {
    struct mip_packet packet;
    bool found = what < 32;
    while (found) { /* each call returns a packet or is the last */
        const bool flush = what < 16;
        found = flush ? mip_parser_flush(parser, &packet) : mip_parser_look_behind(parser, &packet);
        compare(parser, p, found, &packet, flush ? plain_flush(p) : plain_look_behind(p));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct input in = {data, size};
    const uint8_t pieces = input_byte(&in);
    const uint8_t events = input_byte(&in);
    uint32_t random = (uint32_t)pieces << 8 | events;
    struct plain p = {in.at, 0, 0, 0};
    struct mip_parser parser;
    struct mip_packet packet;
    memset(&parser, 0xAA, sizeof(parser));
    mip_parser_init(&parser);
    while (in.left > 0) {
        random = random * UINT32_C(1664525) + UINT32_C(1013904223);
        size_t count = pieces == 0 ? in.left : pieces < 128 ? pieces
                                                            : (random >> 24) % (pieces - 127u) + 1;
        uint8_t *piece = input_bytes(&in, &count);
        const uint8_t *at = piece;
        size_t left = count;
        p.end += count;
        bool found;
        do {
            found = mip_parser_next(&parser, &at, &left, &packet);
            CHECK(at + left == piece + count);
            compare(&parser, &p, found, &packet, plain_next(&p));
        } while (found);
        CHECK(left == 0);
        free(piece);
        if (events > 0) {
            between(&parser, &p, (uint8_t)(random >> 16));
        }
    }
    between(&parser, &p, 0);
    CHECK(p.at == p.end);
    return 0;
}
