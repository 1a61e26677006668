/* The stream parser for speed. A packet that lies wholly within the caller's bytes is checked and
 * returned in place; only one that spans calls is assembled in the buffer. */
#include "mip/core/parser.h"

#ifdef MIP_PARSER_FAST
#include "mip/core/checksum.h"

#include <string.h>

/** The shortest payload of packets whose checksum is computed in blocks. */
#define SHORTEST 12
/** A size that memcpy copies without a call; most packets are no longer. */
#define BLOCK 64
/** The most bytes by which two candidates may differ if one sum is derived from the other. */
#define NEAR 16

/** Do these bytes have the checksum that follows them? */
MIP_QUICK bool sound(const uint8_t *bytes, size_t size) {
    return mip_sum(bytes, size) == mip_get_16(bytes + size);
}

/** Copies bytes, without a call if there are few, as is usual. */
MIP_QUICK void copy(uint8_t *to, const uint8_t *from, size_t size) {
    if (size >= 16) {
        for (size_t at = 0; at + 16 <= size; at += 16) {
            memcpy(to + at, from + at, 16);
        }
        memcpy(to + size - 16, from + size - 16, 16);
    } else if (size >= 8) {
        memcpy(to, from, 8);
        memcpy(to + size - 8, from + size - 8, 8);
    } else {
        for (size_t i = 0; i < size; i++) {
            to[i] = from[i];
        }
    }
}

/** Moves the caller's bytes to the end of the buffer. */
MIP_QUICK void append(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t count) {
    const uint8_t *bytes = *data;
    const size_t length = parser->length;
    parser->length = (uint16_t)(length + count); /* before the copy, which could alias it */
    *data = bytes + count;
    *size -= count;
    copy(parser->buffer + length, bytes, count);
}

/** Keeps all of the caller's bytes in the empty buffer: they are the beginning of a packet of
 * `goal` bytes, or of its header. */
MIP_APART bool keep(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t goal) {
    const uint8_t *bytes = *data;
    const size_t count = *size;
    parser->length = (uint16_t)count;
    parser->missing = count < MIP_HEADER_SIZE ? 0 : (uint16_t)(goal - count);
    *data = bytes + count;
    *size = 0;
    copy(parser->buffer, bytes, count);
    return false;
}

/** Returns the number of bytes up to the next one, after the first, that may start a packet. */
static size_t garbage(const uint8_t *bytes, size_t size) {
    const uint8_t *sync = (const uint8_t *)memchr(bytes + 1, MIP_SYNC_1, size - 1);
    return sync == NULL ? size : (size_t)(sync - bytes);
}

/** A candidate's bytes before its checksum, and their sum, which is the checksum's first byte. */
struct window {
    const uint8_t *begin;
    const uint8_t *end;
    uint32_t sum;
};

/** Like sound(), for the successive candidates that noise may contain: if a candidate shares most
 * bytes with the previous one, only the differences are added or subtracted. */
MIP_QUICK bool sound_again(struct window *before, const uint8_t *begin, size_t size) {
    struct window w = *before;
    const uint8_t *end = begin + size;
    const size_t moved = (size_t)(end < w.end ? w.end - end : end - w.end);
    if (moved + (size_t)(begin - w.begin) > NEAR) {
        const uint16_t sum = mip_sum(begin, size);
        before->begin = begin;
        before->end = end;
        before->sum = sum >> 8;
        return sum == mip_get_16(end);
    }
    while (w.begin < begin) {
        w.sum -= *w.begin++;
    }
    while (w.end < end) {
        w.sum += *w.end++;
    }
    while (w.end > end) {
        w.sum -= *--w.end;
    }
    *before = w;
    return (w.sum & 0xFFU) == *end && mip_checksum(begin, size) == mip_get_16(end);
}

/** Looks for a packet in the caller's bytes, and stores the beginning of an incomplete one in the
 * empty buffer. */
MIP_APART bool scan(struct mip_parser *parser, const uint8_t **data, size_t *size,
                    struct mip_packet *packet) {
    const uint8_t *at = *data;
    size_t left = *size;
    struct window window = {at, at, 0};
    bool found = false;
    size_t goal = 0;
    while (left > 0 && !found) {
        size_t count;
        goal = candidate(at, left);
        if (goal > left) {
            break;
        }
        if (goal > 0 && sound_again(&window, at, goal - MIP_CHECKSUM_SIZE)) {
            describe(packet, at, goal);
            count = goal;
            found = true;
        } else {
            MIP_COUNT_BAD_CHECKSUM(parser, at, left);
            count = goal > 0 && at[2] == MIP_SYNC_1 ? 2 : garbage(at, left);
            parser->skipped += (uint32_t)count;
        }
        at += count;
        left -= count;
    }
    *data = at;
    *size = left;
    return found || (left > 0 && keep(parser, data, size, goal));
}

/** Looks for a packet in the buffer, and moves as many of the caller's bytes there as it needs. */
static bool search(struct mip_parser *parser, const uint8_t **data, size_t *size,
                   struct mip_packet *packet) {
    const size_t given = *size;
    parser->missing = 0;
    for (;;) {
        const size_t left = (size_t)parser->length - parser->done;
        if (left <= given - *size) { /* all of these are still in the caller's bytes */
            if (left > 0) {          /* otherwise the caller's pointer may be NULL */
                *data -= left;
                *size += left;
            }
            parser->length = 0;
            parser->done = 0;
            return scan(parser, data, size, packet);
        }
        const size_t goal = mip_parser_examine(parser->buffer + parser->done, left, packet);
        if (goal == 0) {
            MIP_COUNT_BAD_CHECKSUM(parser, parser->buffer + parser->done, left);
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
            const size_t count = *size < missing ? *size : missing;
            memcpy(parser->buffer + left, *data, count);
            parser->length = (uint16_t)(left + count);
            *data += count;
            *size -= count;
        }
    }
}

/** Keeps all of the caller's bytes, if any, because they belong to the packet whose beginning is in
 * the buffer. */
MIP_APART bool extend(struct mip_parser *parser, const uint8_t **data, size_t *size) {
    if (*size == 0) {
        return false;
    }
    parser->missing = (uint16_t)(parser->missing - *size);
    append(parser, data, size, *size);
    return false;
}

/** Completes the packet in the buffer, whose rest is in the caller's bytes. */
MIP_APART bool complete(struct mip_parser *parser, const uint8_t **data, size_t *size,
                        struct mip_packet *packet) {
    const size_t missing = parser->missing;
    const size_t goal = parser->length + missing;
    uint8_t *to = parser->buffer + parser->length;
    if (missing <= BLOCK && *size >= BLOCK && goal <= sizeof(parser->buffer) - BLOCK) {
        memcpy(to, *data, BLOCK); /* perhaps too many, but without a call */
    } else {
        memcpy(to, *data, missing);
    }
    if (!sound(parser->buffer, goal - MIP_CHECKSUM_SIZE)) {
        return search(parser, data, size, packet); /* copies them again */
    }
    parser->length = 0;
    describe(packet, parser->buffer, goal);
    *data += missing;
    *size -= missing;
    return true;
}

/** Continues a packet whose beginning is in the buffer, and whose size is not known yet. */
MIP_APART bool begin(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    while (parser->length < MIP_HEADER_SIZE && parser->done == 0 && *size > 0) {
        append(parser, data, size, 1);
    }
    const size_t goal = candidate(parser->buffer, parser->length);
    if (parser->done > 0 || goal == 0 || goal <= parser->length) {
        return search(parser, data, size, packet);
    }
    if (parser->length < MIP_HEADER_SIZE) {
        return false;
    }
    parser->missing = (uint16_t)(goal - parser->length);
    return *size < parser->missing ? extend(parser, data, size)
                                   : complete(parser, data, size, packet);
}

bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    /* Packet after packet, without a call. The shortest packets are handled separately, because
     * they do not contain a whole block. */
    const uint8_t *bytes = *data;
    if (parser->length > 0) {
        return *size < parser->missing ? extend(parser, data, size)
               : parser->missing > 0   ? complete(parser, data, size, packet)
                                       : begin(parser, data, size, packet);
    }
    if (*size < MIP_HEADER_SIZE || mip_get_16(bytes) != (MIP_SYNC_1 << 8 | MIP_SYNC_2) ||
        !mip_set_valid(bytes[2]) || bytes[3] < SHORTEST) {
        return scan(parser, data, size, packet);
    }
    const size_t end = (size_t)bytes[3] + MIP_HEADER_SIZE;
    if (end + MIP_CHECKSUM_SIZE > *size) {
        return keep(parser, data, size, end + MIP_CHECKSUM_SIZE);
    }
    if (!sound(bytes, end)) {
        return scan(parser, data, size, packet);
    }
    describe(packet, bytes, end + MIP_CHECKSUM_SIZE);
    *data += packet->size;
    *size -= packet->size;
    return true;
}
#endif
