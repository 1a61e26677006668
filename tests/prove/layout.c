/*
 * One layout. decode: the bytes of a field, in memory of exactly its size, are decoded without an access outside that
 * memory and the structure; what is decoded is encoded to the same bytes. encode: any structure is encoded into a
 * packet of any capacity without an access outside it, or refused and the packet is unchanged.
 *
 * proofs.py states the layout: HEADER, TYPE (its structure), CODEC, SET, and LARGEST, the largest field that is looked
 * at. The program of a layout that is more than numbers is run for one size after the other, and for one value after
 * the other of each byte that decides how others are read (WIRE, MEMORY: its place, how many values, the values).
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

#ifndef WIRE

void decode(void) {
    const size_t size = nondet_size();
    __CPROVER_assume(size <= LARGEST);
    uint8_t *data = (uint8_t *)malloc(size);
    __CPROVER_assume(data != NULL);
    decode_these(data, size);
}

void encode(void) {
    const size_t capacity = nondet_size();
    __CPROVER_assume(capacity <= MIP_MAX_PACKET + 1);
    uint8_t *buffer = (uint8_t *)malloc(capacity);
    __CPROVER_assume(buffer != NULL);
    uint8_t value[sizeof(TYPE)];
    encode_this(value, buffer, capacity);
}

#else

struct split {
    size_t at;
    size_t count;
    uint8_t values[40];
};
static const struct split wire[] = {WIRE{0, 0, {0}}};
static const struct split memory[] = {MEMORY{0, 0, {0}}};

/* The next choice of values; false after the last. */
static bool next(const struct split *splits, size_t *choice) {
    for (; splits->count > 0; splits++, choice++) {
        if (++*choice < splits->count) {
            return true;
        }
        *choice = 0;
    }
    return false;
}

/* Bytes with the values of a choice; false if another choice has the same bytes, as there are fewer. */
static bool choose(uint8_t *bytes, size_t size, const struct split *splits, const size_t *choice) {
    bool first = true;
    for (; splits->count > 0; splits++, choice++) {
        if (splits->at < size) {
            bytes[splits->at] = splits->values[*choice];
        } else {
            first = first && *choice == 0;
        }
    }
    return first;
}

void decode(void) {
    size_t choice[8] = {0};
    do {
        for (size_t size = 0; size <= LARGEST; size++) {
            uint8_t data[LARGEST]; /* the field ends where this does */
            if (choose(data + (LARGEST - size), size, wire, choice)) {
                decode_these(data + (LARGEST - size), size);
            }
        }
    } while (next(wire, choice));
}

void encode(void) {
    size_t choice[8] = {0};
    do {
        for (size_t i = 0; i < 4; i++) { /* enough for the largest; one byte too few; nothing but the header; nothing */
            static const size_t capacities[] = {LARGEST + 8, LARGEST + 6, 8, 6};
            uint8_t value[sizeof(TYPE)];
            uint8_t buffer[LARGEST + 8]; /* the packet ends where this does */
            choose(value, sizeof(value), memory, choice);
            encode_this(value, buffer + (sizeof(buffer) - capacities[i]), capacities[i]);
        }
    } while (next(memory, choice));
}

#endif
