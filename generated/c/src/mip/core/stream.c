/* Pieces of a stream, and the index of a log. The parser finds the packets. The other bytes are
 * counted here in a size_t, because the parser's own counter may wrap around. */
#include "mip/stream.h"

#include <string.h>

void mip_stream_init(struct mip_stream *stream) {
    stream->offset = 0;
    stream->held = 0;
    stream->given = 0;
    stream->from = NULL;
    stream->found = false;
    mip_parser_init(&stream->parser);
}

/** Returns the number of bytes that the parser keeps because they may begin a packet. */
static size_t held_by(const struct mip_parser *parser) {
    return (size_t)parser->length - parser->done;
}

/** Is there a piece that has not been returned yet? */
static bool waiting(const struct mip_stream *stream) {
    return stream->held > 0 || stream->given > 0 || stream->found;
}

/** Copies the bytes that the parser holds, because it drops those that it skips. Returns their
 * number. */
static size_t keep(struct mip_stream *stream) {
    const size_t held = held_by(&stream->parser);
    if (held > 0) {
        memcpy(stream->before, stream->parser.buffer + stream->parser.done, held);
    }
    return held;
}

/** Divides the bytes that the parser has skipped: first those that it held, then the caller's. A
 * packet, if one was found, follows them. */
static void divide(struct mip_stream *stream, size_t held, size_t given) {
    const size_t left = held_by(&stream->parser) + (stream->found ? stream->packet.size : 0);
    const size_t skipped = held + given - left;
    stream->held = skipped < held ? skipped : held;
    stream->given = skipped - stream->held;
}

/** Returns the first of the pieces that have not been returned yet. */
static bool take(struct mip_stream *stream, struct mip_piece *piece) {
    piece->offset = stream->offset;
    piece->packet = NULL;
    if (stream->held > 0) {
        piece->bytes = stream->before;
        piece->size = stream->held;
        stream->held = 0;
    } else if (stream->given > 0) {
        piece->bytes = stream->from;
        piece->size = stream->given;
        stream->given = 0;
    } else if (stream->found) {
        piece->bytes = stream->packet.bytes;
        piece->size = stream->packet.size;
        piece->packet = &stream->packet;
        stream->found = false;
    } else {
        return false;
    }
    stream->offset += piece->size;
    return true;
}

bool mip_stream_next(struct mip_stream *stream, const uint8_t **data, size_t *size,
                     struct mip_piece *piece) {
    if (!waiting(stream)) {
        const size_t held = keep(stream);
        const size_t before = *size;
        stream->from = *data;
        stream->found = mip_parser_next(&stream->parser, data, size, &stream->packet);
        divide(stream, held, before - *size);
    }
    return take(stream, piece);
}

bool mip_stream_flush(struct mip_stream *stream, struct mip_piece *piece) {
    if (!waiting(stream)) {
        const size_t held = keep(stream);
        stream->found = mip_parser_flush(&stream->parser, &stream->packet);
        divide(stream, held, 0);
    }
    return take(stream, piece);
}

size_t mip_index(const uint8_t *bytes, size_t size, bool ended, size_t *at, size_t *offsets,
                 size_t room) {
    size_t count = 0;
    while (count < room && *at < size) {
        const uint8_t *data = bytes + *at;
        size_t left = size - *at;
        struct mip_parser parser;
        struct mip_packet packet;
        mip_parser_init(&parser);
        while (count < room && mip_parser_next(&parser, &data, &left, &packet)) {
            /* The parser may have copied the packet, with bytes after it. */
            *at = (size_t)(data - bytes) - held_by(&parser);
            offsets[count++] = *at - packet.size;
        }
        if (count < room) {
            *at = size - held_by(&parser);
            if (!ended) {
                break;
            }
            *at += *at < size; /* the first byte of a packet whose end is missing */
        }
    }
    return count;
}
