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

/** Describes a packet whose bytes have been checked, or are being checked. */
MIP_QUICK void describe(struct mip_packet *packet, const uint8_t *bytes, size_t size) {
    packet->bytes = bytes;
    packet->size = size;
    packet->descriptor_set = bytes[2];
}

/** The same as candidate() for a place in the buffer, and 0 if the packet is complete and not
 * valid.
 */
static size_t examine(const struct mip_parser *parser, size_t at, struct mip_packet *packet) {
    const uint8_t *bytes = parser->buffer + at;
    const size_t size = parser->length - at;
    const size_t goal = candidate(bytes, size);
    if (goal > 0 && goal <= size) {
        const size_t end = goal - MIP_CHECKSUM_SIZE;
        describe(packet, bytes, goal);
        return mip_checksum(bytes, end) == mip_get_16(bytes + end) ? goal : 0;
    }
    return goal;
}

#ifndef __OPTIMIZE_SIZE__
/** The shortest payload of packets whose checksum takes a block at once. */
#define SHORTEST 12
/** The size that memcpy copies without a call; most packets fit. */
#define BLOCK 64
/** The most bytes by which two candidates may differ if the sum of one follows from the other's. */
#define NEAR 16

/** Do these bytes have the checksum that follows them? */
MIP_QUICK bool sound(const uint8_t *bytes, size_t size) {
    return mip_sum(bytes, size) == mip_get_16(bytes + size);
}

/** Copies bytes without a call: most are few. */
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

/** Moves bytes of the caller to the end of the buffer. */
MIP_QUICK void append(struct mip_parser *parser, const uint8_t **data, size_t *size, size_t count) {
    const uint8_t *bytes = *data;
    const size_t length = parser->length;
    parser->length =
        (uint16_t)(length + count); /* before bytes are written, which could be these */
    *data = bytes + count;
    *size -= count;
    copy(parser->buffer + length, bytes, count);
}

/** Keeps all of the caller's bytes in the buffer, which is empty: the beginning of a packet of
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

/** The first byte, and those up to the next that may start a packet. */
static size_t garbage(const uint8_t *bytes, size_t size) {
    const uint8_t *sync = (const uint8_t *)memchr(bytes + 1, MIP_SYNC_1, size - 1);
    return sync == NULL ? size : (size_t)(sync - bytes);
}

/** The bytes of a candidate before its checksum, and their sum, which is the first half of that. */
struct window {
    const uint8_t *begin;
    const uint8_t *end;
    uint32_t sum;
};

/** The same as sound() for one candidate after the other, which noise may have: if most bytes are
 * those of the one before, only the others are added or subtracted. */
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

/** Looks for a packet in the caller's bytes; the buffer, which is empty, gets the beginning of one
 * that their end cuts. */
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
#endif

#ifdef __OPTIMIZE_SIZE__
#define search mip_parser_next /* the only way */
#else
static bool search(struct mip_parser *parser, const uint8_t **data, size_t *size,
                   struct mip_packet *packet);
#endif

/** Looks for a packet in the buffer, with as many of the caller's bytes as it needs. */
bool search(struct mip_parser *parser, const uint8_t **data, size_t *size,
            struct mip_packet *packet) {
#ifndef __OPTIMIZE_SIZE__
    const size_t given = *size;
    parser->missing = 0;
#endif
    for (;;) {
        const size_t left = (size_t)parser->length - parser->done;
#ifndef __OPTIMIZE_SIZE__
        if (left <= given - *size) { /* all of them are in the caller's bytes, too */
            if (left > 0) {          /* else there may be no bytes at all, at no address */
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
            const size_t count = *size < missing ? *size : missing;
            memcpy(parser->buffer + left, *data, count);
            parser->length = (uint16_t)(left + count);
            *data += count;
            *size -= count;
        }
    }
}

#ifndef __OPTIMIZE_SIZE__
/** Keeps all of the caller's bytes, if there are any, as they belong to the packet whose beginning
 * is in the buffer. */
MIP_APART bool extend(struct mip_parser *parser, const uint8_t **data, size_t *size) {
    if (*size == 0) {
        return false;
    }
    parser->missing = (uint16_t)(parser->missing - *size);
    append(parser, data, size, *size);
    return false;
}

/** Completes that packet, whose rest is in the caller's bytes. */
MIP_APART bool complete(struct mip_parser *parser, const uint8_t **data, size_t *size,
                        struct mip_packet *packet) {
    const size_t missing = parser->missing;
    const size_t goal = parser->length + missing;
    uint8_t *to = parser->buffer + parser->length;
    if (missing <= BLOCK && *size >= BLOCK && goal <= sizeof(parser->buffer) - BLOCK) {
        memcpy(to, *data, BLOCK); /* a few too many, but without a call */
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
#endif

#ifndef __OPTIMIZE_SIZE__
bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet) {
    /* Packet after packet, without a call. The shortest ones are separate: they have no whole
     * block. */
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
#ifndef __OPTIMIZE_SIZE__
            parser->missing = 0;
#endif
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
