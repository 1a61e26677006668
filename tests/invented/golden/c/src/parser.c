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
static size_t candidate(const uint8_t *bytes, size_t size) {
    if (size >= MIP_HEADER_SIZE) {
        return bytes[0] == MIP_SYNC_1 && bytes[1] == MIP_SYNC_2 && bytes[2] != 0
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
    const uint8_t *end = bytes + (size - MIP_CHECKSUM_SIZE);
    const uint16_t sum = mip_checksum(bytes, size - MIP_CHECKSUM_SIZE);
    if (end[0] != sum >> 8 || end[1] != (sum & 0xFFU)) {
        return false;
    }
    packet->bytes = bytes;
    packet->size = size;
    packet->descriptor_set = bytes[2];
    return true;
}

/** Removes bytes from the front of the buffer. */
static void drop(struct mip_parser *parser, size_t size) {
    parser->length = (uint16_t)(parser->length - size);
    memmove(parser->buffer, parser->buffer + size, parser->length);
}

/** Removes the first byte of the buffer, and those up to the next that may start a packet. */
static void skip(struct mip_parser *parser) {
    size_t count = 1;
    while (count < parser->length && parser->buffer[count] != MIP_SYNC_1) {
        count++;
    }
    parser->skipped += (uint32_t)count;
    drop(parser, count);
}

/** Moves bytes into the buffer. */
static void take(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t count) {
    memcpy(parser->buffer + parser->length, *data, count);
    parser->length = (uint16_t)(parser->length + count);
    *data += count;
    *size -= count;
}

/** Gives back bytes behind the first `kept` of the buffer, if all of them have just been taken. */
static void give_back(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t kept,
                      const uint8_t *begin) {
    const size_t count = parser->length - kept;
    if (count <= (size_t)(*data - begin)) {
        parser->length = (uint16_t)kept;
        *data -= count;
        *size += count;
    }
}

/** Finds a packet in the caller's bytes; a candidate that they cut goes into the buffer. */
static bool find(struct mip_parser *parser, const uint8_t **data, size_t *size,
                 struct mip_packet *packet) {
    const uint8_t *at = *data;
    size_t left = *size;
    while (left > 0) {
        if (*at != MIP_SYNC_1) {
            const uint8_t *sync = (const uint8_t *)memchr(at, MIP_SYNC_1, left);
            if (sync == NULL) {
                at += left;
                left = 0;
                break;
            }
            left -= (size_t)(sync - at);
            at = sync;
        }
        const size_t goal = candidate(at, left);
        if (goal > left) {
            break;
        }
        if (goal > 0 && is_packet(at, goal, packet)) {
            parser->skipped += (uint32_t)(at - *data);
            *data = at + goal;
            *size = left - goal;
            return true;
        }
        at++;
        left--;
    }
    parser->skipped += (uint32_t)(at - *data);
    *data = at;
    *size = left;
    if (left > 0) {
        parser->missing = (uint16_t)(candidate(at, left) - left);
        take(parser, data, size, left);
    }
    return false;
}

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    const uint8_t *begin = *data;
    if (parser->done > 0) { /* the packet of the last call */
        drop(parser, parser->done);
        parser->done = 0;
    } else if (*size < parser->missing) {
        parser->missing = (uint16_t)(parser->missing - *size);
        if (*size > 0) {
            take(parser, data, size, *size);
        }
        return false;
    }
    while (parser->length > 0) {
        const size_t goal = candidate(parser->buffer, parser->length);
        if (goal > parser->length) {
            const size_t missing = goal - parser->length;
            if (*size < missing) {
                parser->missing = (uint16_t)(missing - *size);
                if (*size > 0) {
                    take(parser, data, size, *size);
                }
                return false;
            }
            take(parser, data, size, missing);
        } else if (goal > 0 && is_packet(parser->buffer, goal, packet)) {
            give_back(parser, data, size, goal, begin);
            parser->done = (uint16_t)goal;
            parser->missing = 0;
            return true;
        } else {
            skip(parser);
            give_back(parser, data, size, 0, begin);
        }
    }
    parser->missing = 0;
    return find(parser, data, size, packet);
}

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    if (mip_parser_next(parser, &data, &size, packet)) {
        return true;
    }
    for (size_t at = 1; at + MIP_HEADER_SIZE < parser->length; at++) {
        const size_t left = parser->length - at;
        const size_t goal = candidate(parser->buffer + at, left);
        if (goal > 0 && goal <= left && is_packet(parser->buffer + at, goal, packet)) {
            parser->skipped += (uint32_t)at;
            drop(parser, at);
            parser->missing = 0;
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
        skip(parser);
        parser->missing = 0;
    }
    return true;
}
