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

/* A field made of hexadecimal text. */
static inline struct mip_field field_of(uint8_t set, uint8_t descriptor, const char *hex) {
    static uint8_t bytes[MIP_MAX_FIELD_DATA];
    struct mip_field field = {bytes, (uint8_t)(strlen(hex) / 2), set, descriptor};
    for (size_t i = 0; i < field.size; i++) {
        unsigned value;
        CHECK(sscanf(hex + 2 * i, "%2x", &value) == 1);
        bytes[i] = (uint8_t)value;
    }
    return field;
}

#endif
