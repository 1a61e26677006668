/* What all programs of this folder use. They run against the output of tests/invented/spec. */
#ifndef CHECK_H
#define CHECK_H

#include "mip/core.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition)                                                    \
    do {                                                                    \
        if (!(condition)) {                                                 \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            exit(1);                                                        \
        }                                                                   \
    } while (0)

/* Is the packet exactly these bytes? */
static inline bool is_packet(struct mip_packet packet, const char *bytes, size_t size) {
    return packet.size == size && memcmp(packet.bytes, bytes, size) == 0;
}

/* The data of the only field in a builder, as hexadecimal text in a static buffer. */
static inline const char *only_field(const struct mip_builder *builder) {
    static char text[2 * MIP_MAX_PAYLOAD + 1];
    const uint8_t *field = builder->buffer + MIP_HEADER_SIZE;
    CHECK(builder->length == (size_t)MIP_HEADER_SIZE + field[0]);
    for (size_t i = 2; i < field[0]; i++) {
        snprintf(text + 2 * (i - 2), 3, "%02x", field[i]);
    }
    text[2 * (field[0] - 2U)] = '\0';
    return text;
}

/* The bytes of hexadecimal text, up to anything else; returns their number. */
static inline size_t octets(const char *text, uint8_t *bytes) {
    size_t size = 0;
    unsigned value;
    while (sscanf(text + 2 * size, "%2x", &value) == 1) {
        bytes[size++] = (uint8_t)value;
    }
    return size;
}

/* A field made of hexadecimal text. */
static inline struct mip_field field_of(uint8_t set, uint8_t descriptor, const char *hex) {
    static uint8_t bytes[MIP_MAX_FIELD_DATA];
    const struct mip_field field = {bytes, (uint8_t)octets(hex, bytes), set, descriptor};
    CHECK(strlen(hex) == 2U * field.size);
    return field;
}

/* A packet made of raw fields: length, descriptor, data. */
static inline struct mip_packet packet_of(uint8_t set, const char *payload, size_t size) {
    static uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder b;
    CHECK(mip_builder_start(&b, bytes, sizeof(bytes), set) == MIP_OK);
    for (size_t at = 0; at < size; at += (uint8_t)payload[at]) {
        const size_t length = (uint8_t)payload[at];
        CHECK(mip_builder_add(&b, (uint8_t)payload[at + 1], payload + at + 2, length - 2) == MIP_OK);
    }
    return mip_builder_finish(&b);
}

#endif
