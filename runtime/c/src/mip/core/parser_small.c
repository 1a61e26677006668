/* The stream parser for small code. Like the fast one, it copies only packets that span calls. */
#include "mip/core/parser.h"

#ifdef MIP_PARSER_SMALL
#include <string.h>

/** Drops the first bytes of the buffer; or of the caller's, if it is empty. */
static void drop(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t count) {
    if (parser->length > 0) {
        parser->done = (uint16_t)(parser->done + count);
    } else {
        *data += count;
        *size -= count;
    }
}

/** Returns the number of bytes up to the next one, after the first, that may start a packet. */
static size_t garbage(const uint8_t *bytes, size_t size) {
    const size_t first = bytes[0] == MIP_SYNC_1; /* otherwise aligned bytes are searched faster */
    const uint8_t *sync = (const uint8_t *)memchr(bytes + first, MIP_SYNC_1, size - first);
    return sync == NULL ? size : (size_t)(sync - bytes);
}

/** Copies as many of the caller's bytes to the buffer as are missing. Returns whether something can
 * be decided then. */
static bool feed(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t missing) {
    const size_t count = *size < missing ? *size : missing;
    const uint8_t *from = *data;
    uint8_t *to = parser->buffer + parser->length;
    if (count == 0) {
        return false;
    }
    parser->length = (uint16_t)(parser->length + count);
    *data = from + count;
    *size -= count;
    if (count == 1) {
        *to = *from; /* without a call, for streams that are fed byte by byte */
    } else {
        memcpy(to, from, count);
    }
    if (parser->missing > 0) { /* the packet's size is known, so it must be complete */
        parser->missing = (uint16_t)(missing - count);
    }
    return parser->missing == 0;
}

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    for (;;) {
        size_t missing = parser->missing;
        if (missing == 0) {
            const uint8_t *bytes = parser->buffer + parser->done;
            size_t left = (size_t)parser->length - parser->done;
            if (left == 0) {
                parser->length = 0;
                parser->done = 0;
                bytes = *data;
                left = *size;
            }
            const size_t goal = mip_parser_examine(bytes, left, packet);
            if (goal == 0) {
                MIP_COUNT_BAD_CHECKSUM(parser, bytes, left);
                const size_t count = garbage(bytes, left);
                parser->skipped += (uint32_t)count;
                drop(parser, data, size, count);
                continue;
            }
            if (goal <= left) {
                drop(parser, data, size, goal);
                return true;
            }
            missing = parser->length > 0 ? goal - left : goal;
            if (parser->done > 0) {
                memmove(parser->buffer, bytes, left);
                parser->length = (uint16_t)left;
                parser->done = 0;
            }
            if (left >= MIP_HEADER_SIZE) {
                parser->missing = (uint16_t)missing;
            }
        }
        if (!feed(parser, data, size, missing)) {
            return false;
        }
    }
}
#endif
