/**
 * @file
 * Everything in a stream of bytes, in order: packets, and the bytes between them, such as NMEA
 * sentences or RTCM messages, each with its offset. Also an index of the packets in a log.
 *
 * Optional: if you need only the packets, use the parser in mip/core.h.
 */
#ifndef MIP_STREAM_H
#define MIP_STREAM_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A packet, or bytes that are not part of one. */
struct mip_piece {
    /** The offset of the first byte in the stream. */
    uint64_t offset;
    /** The bytes. They are valid until the next call, and while the caller's bytes are unchanged.
     */
    const uint8_t *bytes;
    /** Their number, at least 1. */
    size_t size;
    /** The packet with exactly these bytes; NULL if they are not part of a packet. */
    const struct mip_packet *packet;
};

/** Divides a stream into pieces. Each byte is in exactly one piece, and the pieces are in order. */
struct mip_stream {
    /** The offset of the next byte that has not been in a piece yet. */
    uint64_t offset;
    /** The parser that finds the packets; its `skipped` counts the bytes in other pieces. */
    struct mip_parser parser;
    /** The packet of the current piece. */
    struct mip_packet packet;
    /** The number of bytes to return before the packet, of those that the parser held. */
    size_t held;
    /** The number of bytes to return before the packet, of the caller's. */
    size_t given;
    /** The first of the caller's bytes to return. */
    const uint8_t *from;
    /** Does the packet follow these bytes? */
    bool found;
    /** The bytes that the parser held before it was called. */
    uint8_t before[MIP_MAX_PACKET];
};

/** Initializes a stream. */
MIP_API void mip_stream_init(struct mip_stream *stream);

/**
 * Gets the next piece, and advances `data` and `size`. Returns false if more bytes are needed.
 *
 *     while (mip_stream_next(&stream, &data, &size, &piece)) { ... }
 *
 * The packets are those that the parser finds, whatever the sizes of the chunks. Other bytes are
 * returned as soon as they cannot begin a packet. A long run of them may be split into several
 * pieces.
 */
MIP_API bool mip_stream_next(struct mip_stream *stream, const uint8_t **data, size_t *size,
                             struct mip_piece *piece);

/**
 * Discards the incomplete packet at the end, and returns its bytes piece by piece, together with
 * packets within it: see mip_parser_flush.
 *
 *     while (mip_stream_flush(&stream, &piece)) { ... }
 */
MIP_API bool mip_stream_flush(struct mip_stream *stream, struct mip_piece *piece);

/**
 * Finds the packets of a log in memory, such as a mapped file, and stores the offsets of at most
 * `room` of them. Returns their number; if it is less than `room`, there are no more.
 *
 * The search begins at `*at`, which is 0 at first and is updated: call this again for the next
 * offsets, or when the log has grown. `ended` means that no more bytes will follow, so that an
 * incomplete packet is discarded, and packets within it are found. Otherwise `*at` stays at its
 * first byte.
 *
 *     while ((count = mip_index(bytes, size, true, &at, offsets, ROOM)) > 0) { ... }
 */
MIP_API size_t mip_index(const uint8_t *bytes, size_t size, bool ended, size_t *at, size_t *offsets,
                         size_t room);

#ifdef __cplusplus
}
#endif

#endif
