/* The stream parser. A packet that lies wholly inside the caller's bytes is checked and returned
 * there; only one that their end cuts is assembled in the buffer. If size matters more than speed,
 * every packet is: search() is then the only way. */
#include "mip/checksum.h"

#include <string.h>

void mip_parser_init(struct mip_parser *parser) {
    parser->skipped = 0;
    parser->length = 0;
    parser->done = 0;
}

/** The size of the packet that may begin here, of which `size` bytes are known; more than these if
 * more are needed to know it, 0 if none begins here. */
MIP_QUICK size_t candidate(const uint8_t *bytes, size_t size) {
    if ((size > 0 && bytes[0] != MIP_SYNC_1) || (size > 1 && bytes[1] != MIP_SYNC_2) ||
        (size > 2 && !mip_set_valid(bytes[2]))) {
        return 0;
    }
    return size < MIP_HEADER_SIZE ? MIP_HEADER_SIZE
                                  : (size_t)bytes[3] + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE;
}

/** Do these bytes have the checksum that follows them? */
MIP_QUICK bool sound(const uint8_t *bytes, size_t size) {
#ifdef __OPTIMIZE_SIZE__
    return mip_checksum(bytes, size) == mip_get_16(bytes + size);
#else
    return mip_sum(bytes, size) == mip_get_16(bytes + size);
#endif
}

/** Is this candidate, which is complete, a packet? Its header has been checked. */
MIP_QUICK bool is_packet(const uint8_t *bytes, size_t size, struct mip_packet *packet) {
    packet->bytes = bytes;
    packet->size = size;
    packet->descriptor_set = bytes[2];
    return sound(bytes, size - MIP_CHECKSUM_SIZE);
}

/** Moves bytes of the caller to the end of the buffer. */
static void take(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t count) {
    memcpy(parser->buffer + parser->length, *data, count);
    parser->length = (uint16_t)(parser->length + count);
    *data += count;
    *size -= count;
}

#ifndef __OPTIMIZE_SIZE__
/** The payload of a packet of which the checksum takes a block at once. */
#define SHORTEST 12

/** The first byte, and those up to the next that may start a packet. */
static size_t garbage(const uint8_t *bytes, size_t size) {
    const uint8_t *sync = (const uint8_t *)memchr(bytes + 1, MIP_SYNC_1, size - 1);
    return sync == NULL ? size : (size_t)(sync - bytes);
}

/** Looks for a packet in the caller's bytes; the buffer, which is empty, gets the beginning of one
 * that their end cuts. */
MIP_APART bool scan(struct mip_parser *parser, const uint8_t **data, size_t *size,
                    struct mip_packet *packet) {
    const uint8_t *at = *data;
    size_t left = *size;
    bool found = false;
    while (left > 0) {
        const size_t goal = candidate(at, left);
        if (goal > left) {
            take(parser, &at, &left, left);
            break;
        }
        found = goal > 0 && is_packet(at, goal, packet);
        const size_t count = found ? goal : garbage(at, left);
        parser->skipped += found ? 0 : (uint32_t)count;
        at += count;
        left -= count;
        if (found) {
            break;
        }
    }
    *data = at;
    *size = left;
    return found;
}
#endif

/** The same as candidate() for a place in the buffer, and 0 if the packet is there and not valid.
 */
static size_t examine(const struct mip_parser *parser, size_t at, struct mip_packet *packet) {
    const uint8_t *bytes = parser->buffer + at;
    const size_t size = parser->length - at;
    const size_t goal = candidate(bytes, size);
    return goal == 0 || goal > size || is_packet(bytes, goal, packet) ? goal : 0;
}

/** Looks for a packet in the buffer, with as many of the caller's bytes as it needs. */
static bool search(struct mip_parser *parser, const uint8_t **data, size_t *size,
                   struct mip_packet *packet) {
#ifndef __OPTIMIZE_SIZE__
    const size_t given = *size;
#endif
    for (;;) {
        const size_t left = (size_t)parser->length - parser->done;
#ifndef __OPTIMIZE_SIZE__
        if (left <= given - *size) { /* all of them are in the caller's bytes, too */
            if (left > 0) {
                *data -= left;
                *size += left;
            }
            parser->length = 0;
            parser->done = 0;
            return scan(parser, data, size, packet);
        }
#endif
        const size_t goal = examine(parser, parser->done, packet);
        if (goal == 0) {
            parser->done++;
            parser->skipped++;
        } else if (goal <= left) {
            parser->done = (uint16_t)(parser->done + goal);
            return true;
        } else {
            const size_t missing = goal - left;
            memmove(parser->buffer, parser->buffer + parser->done, left);
            parser->length = (uint16_t)left;
            parser->done = 0;
            if (*size == 0) {
                return false;
            }
            take(parser, data, size, *size < missing ? *size : missing);
        }
    }
}

#ifndef __OPTIMIZE_SIZE__
/** All of the caller's bytes belong to a packet that goes on: keeps them. */
MIP_APART bool keep(struct mip_parser *parser, const uint8_t **data, size_t *size) {
    take(parser, data, size, *size);
    return false;
}

/** The buffer has a packet's beginning, most often with its header: takes the rest. */
MIP_APART bool resume(struct mip_parser *parser, const uint8_t **data, size_t *size,
                      struct mip_packet *packet) {
    const size_t length = parser->length;
    if (parser->done > 0 || length < MIP_HEADER_SIZE) {
        return search(parser, data, size, packet);
    }
    const size_t end = (size_t)parser->buffer[3] + MIP_HEADER_SIZE;
    const size_t missing = end + MIP_CHECKSUM_SIZE - length;
    if (*size == 1 && missing > 1) { /* byte by byte, as an interrupt feeds it */
        parser->buffer[parser->length++] = *(*data)++;
        *size = 0;
        return false;
    }
    if (*size < missing) {
        return *size > 0 && keep(parser, data, size);
    }
    memcpy(parser->buffer + length, *data, missing);
    if (!sound(parser->buffer, end)) {
        return search(parser, data, size, packet); /* copies it again */
    }
    parser->length = parser->done = (uint16_t)(end + MIP_CHECKSUM_SIZE);
    packet->bytes = parser->buffer;
    packet->size = end + MIP_CHECKSUM_SIZE;
    packet->descriptor_set = parser->buffer[2];
    *data += missing;
    *size -= missing;
    return true;
}
#endif

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
#ifndef __OPTIMIZE_SIZE__
    /* Packet after packet, without a call; the shortest ones apart, as they have no whole block. */
    if (parser->length == parser->done) {
        const uint8_t *bytes = *data;
        parser->length = 0;
        parser->done = 0;
        if (*size >= MIP_HEADER_SIZE && mip_get_16(bytes) == (MIP_SYNC_1 << 8 | MIP_SYNC_2) &&
            mip_set_valid(bytes[2]) && bytes[3] >= SHORTEST) {
            const size_t end = (size_t)bytes[3] + MIP_HEADER_SIZE;
            if (end + MIP_CHECKSUM_SIZE > *size) {
                return keep(parser, data, size);
            }
            if (sound(bytes, end)) {
                packet->bytes = bytes;
                packet->size = end + MIP_CHECKSUM_SIZE;
                packet->descriptor_set = bytes[2];
                *data += packet->size;
                *size -= packet->size;
                return true;
            }
        }
        return scan(parser, data, size, packet);
    }
    return resume(parser, data, size, packet);
#else
    return search(parser, data, size, packet);
#endif
}

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *nothing = parser->buffer;
    size_t none = 0;
    if (mip_parser_next(parser, &nothing, &none, packet)) {
        return true;
    }
    for (size_t at = 1; at < parser->length; at++) {
        const size_t goal = examine(parser, at, packet);
        if (goal > 0 && goal <= parser->length - at) {
            parser->skipped += (uint32_t)at;
            parser->done = (uint16_t)(at + goal);
            return true;
        }
    }
    return false;
}

bool mip_parser_flush(struct mip_parser *parser, struct mip_packet *packet) {
    const bool found = mip_parser_look_behind(parser, packet);
    if (!found) {
        parser->skipped += parser->length;
        parser->length = 0;
    }
    return found;
}
