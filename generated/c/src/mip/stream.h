/**
 * @file
 * Everything in a stream of bytes, in order: packets, and the bytes between them, such as NMEA
 * sentences or RTCM messages, each with its place. Also an index of the packets of a log.
 *
 * Optional: a program that wants only the packets uses the parser of mip/core.h.
 */
#ifndef MIP_STREAM_H
#define MIP_STREAM_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A packet, or bytes that are not part of one. */
struct mip_piece {
    /** The place of the first byte: the number of bytes of the stream before it. */
    uint64_t offset;
    /** The bytes. They are valid until the next call, and as long as those given are unchanged. */
    const uint8_t *bytes;
    /** Their number, at least 1. */
    size_t size;
    /** The packet with exactly these bytes; NULL if they are not part of a packet. */
    const struct mip_packet *packet;
};

/** Divides a stream into pieces. Each byte is in exactly one piece, and the pieces are in order. */
struct mip_stream {
    /** The place of the next byte that has not been in a piece yet. */
    uint64_t offset;
    /** It finds the packets; its `skipped` is the number of bytes in other pieces. */
    struct mip_parser parser;
    /** The packet of the current piece. */
    struct mip_packet packet;
    /** Bytes to return before it, of those that the parser held. */
    size_t held;
    /** The same, of those given. */
    size_t given;
    /** The first of those given. */
    const uint8_t *from;
    /** Does the packet follow them? */
    bool found;
    /** The bytes that the parser held before it was called. */
    uint8_t before[MIP_MAX_PACKET];
};

/** Initializes a stream, for its first byte. */
MIP_API void mip_stream_init(struct mip_stream *stream);

/**
 * Returns the next piece, and advances `data` and `size`. False if more bytes are needed.
 *
 *     while (mip_stream_next(&stream, &data, &size, &piece)) { ... }
 *
 * The packets are those that the parser finds, whatever the sizes of the chunks. Other bytes are
 * returned as soon as they cannot begin a packet. A long run of them may come in several pieces.
 */
MIP_API bool mip_stream_next(struct mip_stream *stream, const uint8_t **data, size_t *size,
                             struct mip_piece *piece);

/**
 * Discards the incomplete packet at the end, and returns its bytes instead, piece by piece:
 * see mip_parser_flush.
 *
 *     while (mip_stream_flush(&stream, &piece)) { ... }
 */
MIP_API bool mip_stream_flush(struct mip_stream *stream, struct mip_piece *piece);

/**
 * Finds the packets of a log in memory, such as a mapped file, and stores the places of at most
 * `room` of them. Returns their number; less than `room` means that there are no more.
 *
 * `*at` is where the search begins, 0 at first. Afterwards it is where it continues: call it again
 * for the next places, or when the log has grown. `ended`: no more bytes will follow, so that an
 * incomplete packet is discarded, and packets after its first bytes are found. Otherwise `*at`
 * stays at its first byte.
 *
 *     while ((count = mip_index(bytes, size, true, &at, offsets, ROOM)) > 0) { ... }
 */
MIP_API size_t mip_index(const uint8_t *bytes, size_t size, bool ended, size_t *at, size_t *offsets,
                         size_t room);

#ifdef __cplusplus
}
#endif

#endif
