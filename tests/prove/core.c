/*
 * The core: checksum, check of packets, walk and builder. Walk and builder begin in any state that they can be in, and
 * one call leaves them in such a state again, so that what is proved of one call is proved of any number.
 */
#include "any.h"

#include "mip/core/checksum.h"

#ifdef ANY_CHECKSUM
/* The checksum has a proof of its own: here it is any number, and its bytes must be readable. */
static uint16_t any_sum(const uint8_t *bytes, size_t size) {
    assert(__CPROVER_r_ok(bytes, size));
    return nondet_16();
}
#define mip_sum any_sum
#endif
#include "mip/core/core.c"

/* The method that is compiled returns the sums that the protocol defines. */
void checksum(void) {
    const size_t size = up_to(LARGEST);
    const uint8_t *bytes = any_bytes(size);
    uint8_t a = 0;
    uint8_t b = 0;
    for (size_t i = 0; i < size; i++) {
        a = (uint8_t)(a + bytes[i]);
        b = (uint8_t)(b + a);
    }
    assert(mip_sum(bytes, size) == (a << 8 | b));
}

/* Bytes that are accepted are exactly one packet with its checksum; others change nothing. */
void packet(void) {
    const size_t size = up_to(LARGEST);
    const uint8_t *bytes = any_bytes(size);
    struct mip_packet p = {NULL, 0, 0};
    const mip_error error = mip_packet_check(bytes, size, &p);
    const bool header = size >= 2 && bytes[0] == 0x75 && bytes[1] == 0x65;
    assert(header == (error != MIP_ERROR_SYNC));
    if (error == MIP_OK) {
        assert(p.bytes == bytes && p.size == size && size >= 6 && size == bytes[3] + 6U);
        assert(p.descriptor_set == bytes[2] && bytes[2] != 0 && bytes[2] != 0xFF);
        const uint16_t sum = mip_sum(bytes, size - 2);
        assert(bytes[size - 2] == sum >> 8 && bytes[size - 1] == (sum & 0xFF));
    } else {
        assert(p.bytes == NULL && p.size == 0);
    }
}

/* From any place in a payload of any size: a field inside it, or the end, or an error that stays. */
void walk(void) {
    const size_t size = up_to(255);
    const size_t at = up_to(size);
    const uint8_t *bytes = any_bytes(size + 1);
    struct mip_walk w;
    struct mip_field field;
    w.at = bytes + at;
    w.end = bytes + size;
    w.descriptor_set = nondet_byte();
    w.error = at < size || nondet_bool() ? MIP_OK : MIP_ERROR_FIELD_LENGTH; /* an error ends the walk */
    const mip_error before = w.error;
    if (mip_walk_next(&w, &field)) {
        assert(before == MIP_OK && w.error == MIP_OK);
        assert(field.data == bytes + at + 2 && field.size == bytes[at] - 2 && field.descriptor == bytes[at + 1]);
        assert(w.at == field.data + field.size && w.at <= w.end && field.descriptor_set == w.descriptor_set);
    } else {
        assert(w.at == w.end && (w.error == MIP_OK) == (before == MIP_OK && at == size));
        assert(at == size || bytes[at] < 2 || bytes[at] > size - at);
    }
}

/* A walk through a packet begins at its first field and ends before its checksum, even if it is no valid packet. */
void walk_begins(void) {
    const size_t size = up_to(MIP_MAX_PACKET);
    const struct mip_packet p = {any_bytes(size), size, nondet_byte()};
    const struct mip_walk w = mip_walk_packet(&p);
    assert(w.error == MIP_OK && w.descriptor_set == p.descriptor_set);
    assert(size < 6 ? w.at == w.end : w.at == p.bytes + 4 && w.end == p.bytes + size - 2);
}

/* From any state of a packet that is being built: a field of any size is inside it, or it is rejected and nothing changes. */
void builder(void) {
    const size_t capacity = up_to(300);
    uint8_t *buffer = any_bytes(capacity);
    struct mip_builder b;
    const uint8_t set = nondet_byte();
    if (mip_builder_start(&b, buffer, capacity, set) == MIP_OK) {
        assert(set != 0 && set != 0xFF && capacity >= 6);
        assert(buffer[0] == 0x75 && buffer[1] == 0x65 && buffer[2] == set && buffer[3] == 0 && b.length == 4);
        b.length += up_to(b.capacity - 6);
        buffer[3] = (uint8_t)(b.length - 4);
    } else {
        assert(set == 0 || set == 0xFF || capacity < 6);
    }
    const struct mip_builder before = b;
    const size_t size = up_to(300);
    const uint8_t *data = any_bytes(size);
    const uint8_t descriptor = nondet_byte();
    if (mip_builder_add(&b, descriptor, data, size) == MIP_OK) {
        assert(b.length == before.length + 2 + size && b.length + 2 <= capacity);
        assert(buffer[before.length] == size + 2 && buffer[before.length + 1] == descriptor);
        const size_t i = up_to(size);
        assert(i == size || buffer[before.length + 2 + i] == data[i]);
    } else {
        assert(b.length == before.length && b.error != MIP_OK);
        assert(size + 2 > 255 || before.length == 0 || before.length + 2 + size + 2 > b.capacity);
    }
    assert(b.length == 0 || buffer[3] == b.length - 4);
    const struct mip_packet p = mip_builder_finish(&b);
    assert(b.length == 0 ? p.size == 0 : p.size == b.length + 2 && p.size <= capacity && p.bytes == buffer);
}
