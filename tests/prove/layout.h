/*
 * One layout. decode: the bytes of a field, in memory of exactly its size, are decoded without an access outside that
 * memory and the structure; what is decoded is encoded to the same bytes. encode: any structure is encoded into a
 * packet of any capacity without an access outside it, or it is rejected and the packet is unchanged.
 *
 * proofs.py states the layout: HEADER, TYPE (its structure), CODEC, SET, and LARGEST, the largest field that is
 * tried.
 */
#include HEADER
#include "mip/program.h"

#include <assert.h>
#include <stdlib.h>

size_t nondet_size(void);

/* Byte by byte: the prover then knows the value of each byte that is copied. */
void *memcpy(void *to, const void *from, size_t size) {
    for (size_t i = 0; i < size; i++) {
        ((uint8_t *)to)[i] = ((const uint8_t *)from)[i];
    }
    return to;
}

/* Is not called. */
uint16_t mip_checksum(const uint8_t *bytes, size_t size) {
    (void)bytes, (void)size;
    assert(false);
    return 0;
}

static void decode_these(const uint8_t *data, size_t size) {
    const struct mip_field field = {data, (uint8_t)size, SET, CODEC.descriptor};
    uint8_t value[sizeof(TYPE)];
    size_t rest;
    const mip_error error = mip_decode(&CODEC, value, &field, &rest);
    assert(rest <= size);
    if (error == MIP_OK) {
        uint8_t buffer[LARGEST + 8];
        struct mip_builder builder;
        assert(mip_builder_start(&builder, buffer, sizeof(buffer), SET) == MIP_OK);
        assert(mip_encode(&CODEC, value, &builder) == MIP_OK);
        const size_t used = builder.length - MIP_HEADER_SIZE - 2;
        assert(used == size - rest);
        for (size_t i = 0; i < used; i++) {
            assert(buffer[MIP_HEADER_SIZE + 2 + i] == data[i]);
        }
    } else {
        const size_t i = nondet_size();
        assert(i >= sizeof(value) || value[i] == 0);
    }
}

static void encode_this(const void *value, uint8_t *buffer, size_t capacity) {
    struct mip_builder builder;
    if (mip_builder_start(&builder, buffer, capacity, SET) == MIP_OK) {
        const mip_error error = mip_encode(&CODEC, value, &builder);
        assert(builder.length + MIP_CHECKSUM_SIZE <= capacity);
        assert(buffer[3] == builder.length - MIP_HEADER_SIZE);
        assert(error == MIP_OK ? builder.length >= MIP_HEADER_SIZE + 2 : builder.length == MIP_HEADER_SIZE);
    }
}

