/* The stream parser. A packet that lies wholly inside the caller's bytes is checked and handed out
 * there; only one that is cut by their end is put together in the buffer. */
#include "mip/core.h"

#include <string.h>

void mip_parser_init(struct mip_parser *parser) {
    parser->skipped = 0;
    parser->length = 0;
    parser->done = 0;
    parser->missing = 0;
}

/** The size of the packet that may begin here; more than `size` if that many bytes do not tell
 * yet, 0 if none begins here. */
static inline size_t candidate(const uint8_t *bytes, size_t size) {
    if (size >= MIP_HEADER_SIZE) {
        return mip_get_16(bytes) == (MIP_SYNC_1 << 8 | MIP_SYNC_2) && bytes[2] != 0
                   ? (size_t)bytes[3] + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE
                   : 0;
    }
    return bytes[0] != MIP_SYNC_1 || (size > 1 && bytes[1] != MIP_SYNC_2) ||
                   (size > 2 && bytes[2] == 0)
               ? 0
               : size + 1;
}

/** Is this candidate, which is complete, a packet? Its header has been looked at. */
static bool is_packet(const uint8_t *bytes, size_t size, struct mip_packet *packet) {
    packet->bytes = bytes;
    packet->size = size;
    packet->descriptor_set = bytes[2];
    size -= MIP_CHECKSUM_SIZE;
    return mip_checksum(bytes, size) == mip_get_16(bytes + size);
}

/** Removes bytes from the front of the buffer. */
static void drop(struct mip_parser *parser, size_t size) {
    parser->length = (uint16_t)(parser->length - size);
    if (parser->length > 0) {
        memmove(parser->buffer, parser->buffer + size, parser->length);
    }
}

/** The first byte, and those up to the next that may start a packet. */
static size_t garbage(const uint8_t *bytes, size_t size) {
    const uint8_t *sync = (const uint8_t *)memchr(bytes + 1, MIP_SYNC_1, size - 1);
    return sync == NULL ? size : (size_t)(sync - bytes);
}

static void skip(struct mip_parser *parser) {
    const size_t count = garbage(parser->buffer, parser->length);
    parser->skipped += (uint32_t)count;
    drop(parser, count);
}

/** Moves bytes of the caller into the buffer. */
static void keep(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t count) {
    if (count == 0) {
        return;
    }
    uint8_t *to = parser->buffer + parser->length;
    const uint8_t *from = *data;
    *data = from + count;
    *size -= count;
    parser->length = (uint16_t)(parser->length + count);
    parser->missing = (uint16_t)(parser->missing - count);
    memcpy(to, from, count);
}

/** Finds a packet in the caller's bytes, and keeps the beginning of one that their end cuts. */
static bool next_in_place(struct mip_parser *parser, const uint8_t **data, size_t *size,
                          struct mip_packet *packet) {
    while (*size > 0) {
        const size_t goal = candidate(*data, *size);
        if (goal > *size) {
            parser->missing = (uint16_t)goal;
            keep(parser, data, size, *size);
            break;
        }
        const bool found = goal > 0 && is_packet(*data, goal, packet);
        const size_t count = found ? packet->size : garbage(*data, *size);
        *data += count;
        *size -= count;
        if (found) {
            return true;
        }
        parser->skipped += (uint32_t)count;
    }
    return false;
}

/** The same if the buffer is not empty: finds a packet that begins there, then others. */
static bool next_in_buffer(struct mip_parser *parser, const uint8_t **data, size_t *size,
                           struct mip_packet *packet) {
    const size_t given = *size;
    if (parser->done > 0) { /* the packet of the last call */
        drop(parser, parser->done);
        parser->done = 0;
    }
    while (parser->length > 0) {
        keep(parser, data, size, *size < parser->missing ? *size : parser->missing);
        if (parser->missing > 0) {
            return false;
        }
        const size_t goal = candidate(parser->buffer, parser->length);
        if (goal > parser->length) {
            parser->missing = (uint16_t)(goal - parser->length);
            continue;
        }
        const bool found = goal > 0 && is_packet(parser->buffer, goal, packet);
        if (found) {
            parser->done = (uint16_t)goal;
        } else {
            skip(parser);
        }
        /* What is behind and has just been copied is found again where it was. */
        const size_t behind = (size_t)parser->length - parser->done;
        if (behind <= given - *size) {
            parser->length = parser->done;
            *data -= behind;
            *size += behind;
        }
        if (found) {
            return true;
        }
    }
    return next_in_place(parser, data, size, packet);
}

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    if (*size == 1 && parser->missing > 1) { /* byte by byte, in an interrupt */
        parser->buffer[parser->length++] = *(*data)++;
        parser->missing--;
        *size = 0;
        return false;
    }
    return parser->length > 0 ? next_in_buffer(parser, data, size, packet)
                              : next_in_place(parser, data, size, packet);
}

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    if (next_in_buffer(parser, &data, &size, packet)) {
        return true;
    }
    for (size_t at = 1; at + MIP_HEADER_SIZE < parser->length; at++) {
        const size_t left = parser->length - at;
        const size_t goal = candidate(parser->buffer + at, left);
        if (goal > 0 && goal <= left && is_packet(parser->buffer + at, goal, packet)) {
            parser->skipped += (uint32_t)at;
            drop(parser, at);
            parser->missing = 0;
            return next_in_buffer(parser, &data, &size, packet);
        }
    }
    return false;
}

bool mip_parser_flush(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    while (!next_in_buffer(parser, &data, &size, packet)) {
        if (parser->length == 0) {
            return false;
        }
        skip(parser);
        parser->missing = 0;
    }
    return true;
}
