/* The stream parser. */
#include "mip/core.h"

#include <string.h>

void mip_parser_init(struct mip_parser *parser) {
    parser->skipped = 0;
    parser->length = 0;
    parser->done = 0;
}

/** Removes bytes from the front of the buffer. */
static void drop(struct mip_parser *parser, size_t size) {
    if (size > 0) {
        parser->length = (uint16_t)(parser->length - size);
        memmove(parser->buffer, parser->buffer + size, parser->length);
    }
}

static void skip(struct mip_parser *parser, size_t size) {
    parser->skipped += (uint32_t)size;
    drop(parser, size);
}

/** The number of bytes before the first one that may start a packet. */
static size_t garbage(const uint8_t *bytes, size_t size) {
    const uint8_t *sync = (const uint8_t *)memchr(bytes, MIP_SYNC_1, size);
    return sync == NULL ? size : (size_t)(sync - bytes);
}

/** Do the first bytes of the buffer rule out a packet? */
static bool is_false_sync(const struct mip_parser *parser) {
    return (parser->length > 1 && parser->buffer[1] != MIP_SYNC_2) ||
           (parser->length > 2 && parser->buffer[2] == 0);
}

/** Bytes that the candidate in the buffer needs: first the header, which gives its length, then
 * all. */
static size_t wanted(const struct mip_parser *parser) {
    return parser->length < MIP_HEADER_SIZE
               ? MIP_HEADER_SIZE
               : (size_t)parser->buffer[3] + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE;
}

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    drop(parser, parser->done); /* the packet of the last call */
    parser->done = 0;
    for (;;) {
        if (parser->length == 0 && *size > 0) { /* do not copy garbage */
            const size_t count = garbage(*data, *size);
            parser->skipped += (uint32_t)count;
            *data += count;
            *size -= count;
        }
        skip(parser, garbage(parser->buffer, parser->length));
        if (is_false_sync(parser)) {
            skip(parser, 1);
            continue;
        }
        const size_t goal = wanted(parser);
        if (parser->length >= goal) {
            if (mip_packet_check(parser->buffer, goal, packet) == MIP_OK) {
                parser->done = (uint16_t)goal;
                return true;
            }
            skip(parser, 1);
            continue;
        }
        const size_t missing = goal - parser->length;
        const size_t count = *size < missing ? *size : missing;
        if (count == 0) {
            return false;
        }
        memcpy(parser->buffer + parser->length, *data, count);
        parser->length = (uint16_t)(parser->length + count);
        *data += count;
        *size -= count;
    }
}

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    if (mip_parser_next(parser, &data, &size, packet)) {
        return true;
    }
    for (size_t at = 1; at + MIP_HEADER_SIZE < parser->length; at++) {
        const uint8_t *candidate = parser->buffer + at;
        size = (size_t)candidate[3] + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE;
        if (at + size <= parser->length && mip_packet_check(candidate, size, packet) == MIP_OK) {
            skip(parser, at);
            size = 0;
            return mip_parser_next(parser, &data, &size, packet);
        }
    }
    return false;
}

bool mip_parser_flush(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    while (!mip_parser_next(parser, &data, &size, packet)) {
        if (parser->length == 0) {
            return false;
        }
        skip(parser, 1);
    }
    return true;
}
