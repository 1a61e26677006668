/* What both stream parsers share: parser_small.c and parser_fast.c contain mip_parser_next. */
#include "mip/core/parser.h"

void mip_parser_init(struct mip_parser *parser) {
    parser->skipped = 0;
    parser->length = 0;
    parser->done = 0;
    parser->missing = 0;
}

size_t mip_parser_examine(const uint8_t *bytes, size_t size, struct mip_packet *packet) {
    const size_t goal = candidate(bytes, size);
    if (goal > 0 && goal <= size) {
        const size_t end = goal - MIP_CHECKSUM_SIZE;
        describe(packet, bytes, goal);
        return mip_checksum(bytes, end) == mip_get_16(bytes + end) ? goal : 0;
    }
    return goal;
}

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    const uint8_t *nothing = parser->buffer;
    size_t none = 0;
    if (mip_parser_next(parser, &nothing, &none, packet)) {
        return true;
    }
    for (size_t at = 1; at < parser->length; at++) {
        const size_t left = parser->length - at;
        const size_t goal = mip_parser_examine(parser->buffer + at, left, packet);
        if (goal > 0 && goal <= left) {
            parser->skipped += (uint32_t)at;
            parser->done = (uint16_t)(at + goal);
            parser->missing = 0;
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
        parser->missing = 0;
    }
    return found;
}
