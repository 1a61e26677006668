/*
 * One layout: what is decoded is encoded to the same bytes, the rest is counted, and an error leaves zeros. codec.c
 * proves of any layout that nothing else is accessed, and that any structure is encoded or rejected.
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
