/* The stream parser. A packet that lies wholly inside the caller's bytes is checked and returned
 * there; only a packet that their end cuts is assembled in the buffer. */
#include "mip/checksum.h"

#include <string.h>

void mip_parser_init(struct mip_parser *parser) {
    parser->skipped = 0;
    parser->length = 0;
    parser->done = 0;
    parser->missing = 0;
}

/** The size of the packet that may begin here; more than `size` if more bytes are needed to know
 * it, 0 if none begins here. */
static size_t candidate(const uint8_t *bytes, size_t size) {
    if (bytes[0] != MIP_SYNC_1 || (size > 1 && bytes[1] != MIP_SYNC_2) ||
        (size > 2 && !mip_set_valid(bytes[2]))) {
        return 0;
    }
    return size < MIP_HEADER_SIZE ? size + 1
                                  : (size_t)bytes[3] + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE;
}

/** Is this candidate, which is complete, a packet? Its header has been checked. */
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
    memmove(parser->buffer, parser->buffer + size, parser->length);
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

MIP_APART bool search(struct mip_parser *parser, const uint8_t **data, size_t *size,
                      struct mip_packet *packet) {
    const uint8_t *at = *data;
    size_t left = *size;
    size_t wanted = parser->missing;
    bool found = false;
    if (parser->done > 0) { /* the packet of the last call */
        drop(parser, parser->done);
        parser->done = 0;
        wanted = 0;
    }
    for (;;) {
        if (wanted > 0) { /* into the buffer */
            const size_t count = left < wanted ? left : wanted;
            if (count > 0) {
                memcpy(parser->buffer + parser->length, at, count);
                parser->length = (uint16_t)(parser->length + count);
                at += count;
                left -= count;
                wanted -= count;
            }
            if (wanted > 0) {
                break;
            }
        }
        const bool buffered = parser->length > 0;
        const uint8_t *bytes = buffered ? parser->buffer : at;
        const size_t known = buffered ? parser->length : left;
        if (known == 0) {
            break;
        }
        const size_t goal = candidate(bytes, known);
        if (goal > known) { /* the end of the caller's bytes cuts it */
            wanted = buffered ? goal - known : known;
            continue;
        }
        found = goal > 0 && is_packet(bytes, goal, packet);
        const size_t count = found ? goal : garbage(bytes, known);
        parser->skipped += found ? 0 : (uint32_t)count;
        if (buffered) {
            if (found) {
                parser->done = (uint16_t)count;
            } else {
                drop(parser, count);
            }
            /* Bytes after it that have just been copied are found again where they were. */
            const size_t behind = parser->length - parser->done;
            if (behind > 0 && behind <= *size - left) {
                parser->length = parser->done;
                at -= behind;
                left += behind;
            }
        } else {
            at += count;
            left -= count;
        }
        if (found) {
            break;
        }
    }
    parser->missing = (uint16_t)wanted;
    *data = at;
    *size = left;
    return found;
}

#ifndef __OPTIMIZE_SIZE__

/** Copies bytes into the buffer. */
static void keep(struct mip_parser *parser, const uint8_t *bytes, size_t size) {
    memcpy(parser->buffer + parser->length, bytes, size);
    parser->length = (uint16_t)(parser->length + size);
}

/** The beginning of a packet is in the buffer: waits for its end, and checks it. Bytes after it, or
 * an end that does not match, are left to search(). */
MIP_APART bool resume(struct mip_parser *parser, const uint8_t **data, size_t *size,
                      struct mip_packet *packet) {
    const size_t missing = parser->missing;
    if (*size == 0) {
        return false;
    }
    if (*size < missing) {
        keep(parser, *data, *size);
        parser->missing = (uint16_t)(missing - *size);
        *data += *size;
        *size = 0;
        return false;
    }
    if (parser->length >= MIP_HEADER_SIZE) {
        keep(parser, *data, missing);
        if (is_packet(parser->buffer, parser->length, packet)) {
            parser->done = parser->length;
            parser->missing = 0;
            *data += missing;
            *size -= missing;
            return true;
        }
        parser->length = (uint16_t)(parser->length - missing);
    }
    return search(parser, data, size, packet);
}

/** Packet after packet; whatever else there is, is left to search(). */
MIP_APART bool next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                    struct mip_packet *packet) {
    const uint8_t *bytes = *data;
    const size_t left = *size;
    if (parser->missing > 0) {
        return resume(parser, data, size, packet);
    }
    if (parser->length == parser->done) {
        parser->length = 0;
        parser->done = 0;
        if (left >= MIP_HEADER_SIZE && bytes[0] == MIP_SYNC_1 && bytes[1] == MIP_SYNC_2 &&
            mip_set_valid(bytes[2])) {
            const size_t end = (size_t)bytes[3] + MIP_HEADER_SIZE;
            const size_t goal = end + MIP_CHECKSUM_SIZE;
            if (goal > left) {
                keep(parser, bytes, left);
                parser->missing = (uint16_t)(goal - left);
                *data = bytes + left;
                *size = 0;
                return false;
            }
            if (mip_sum(bytes, end) == mip_get_16(bytes + end)) {
                packet->bytes = bytes;
                packet->size = goal;
                packet->descriptor_set = bytes[2];
                *data = bytes + goal;
                *size = left - goal;
                return true;
            }
        }
    }
    return search(parser, data, size, packet);
}

#endif

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
#ifdef __OPTIMIZE_SIZE__
    return search(parser, data, size, packet);
#else
    if (*size == 1 && parser->missing > 1) { /* byte by byte, as an interrupt feeds it */
        parser->buffer[parser->length++] = *(*data)++;
        parser->missing--;
        *size = 0;
        return false;
    }
    return next(parser, data, size, packet);
#endif
}

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    if (search(parser, &data, &size, packet)) {
        return true;
    }
    for (size_t at = 1; at + MIP_HEADER_SIZE < parser->length; at++) {
        const size_t left = parser->length - at;
        const size_t goal = candidate(parser->buffer + at, left);
        if (goal > 0 && goal <= left && is_packet(parser->buffer + at, goal, packet)) {
            parser->skipped += (uint32_t)at;
            drop(parser, at);
            parser->missing = 0;
            return search(parser, &data, &size, packet);
        }
    }
    return false;
}

bool mip_parser_flush(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *data = parser->buffer;
    size_t size = 0;
    while (!search(parser, &data, &size, packet)) {
        if (parser->length == 0) {
            return false;
        }
        skip(parser);
        parser->missing = 0;
    }
    return true;
}
