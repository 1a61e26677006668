/**
 * @file
 * Selects one of the two stream parsers, and declares what they share.
 */
#ifndef MIP_PARSER_H
#define MIP_PARSER_H

#include "mip/core.h"

#if defined(MIP_PARSER_SMALL) && defined(MIP_PARSER_FAST)
#error "MIP_PARSER_SMALL and MIP_PARSER_FAST are both defined: define one of them, or none"
#elif !defined(MIP_PARSER_SMALL) && !defined(MIP_PARSER_FAST)
#if UINTPTR_MAX < UINT64_MAX
/** Compiles the parser that takes less code. */
#define MIP_PARSER_SMALL
#else
/** Compiles the parser that takes less time. */
#define MIP_PARSER_FAST
#endif
#endif

/** Returns the size of the packet that may begin here, of which `size` bytes are known. If these
 * are too few to know it, returns a larger number; 0 if no packet begins here. */
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

#ifdef MIP_DIAGNOSTICS
/** Counts a candidate that is complete and was found invalid. */
#define MIP_COUNT_BAD_CHECKSUM(parser, bytes, size) \
    ((parser)->bad_checksums += candidate(bytes, size) != 0)
#else
#define MIP_COUNT_BAD_CHECKSUM(parser, bytes, size) ((void)0)
#endif

/** Like candidate(), and describes the packet if it is complete; returns 0 if it is then not
 * valid. */
size_t mip_parser_examine(const uint8_t *bytes, size_t size, struct mip_packet *packet);

#endif
