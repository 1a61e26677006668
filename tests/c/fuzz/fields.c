/*
 * Every layout of a descriptor: decode, encode, decode; and what a builder and a walk make of any bytes.
 *
 * Input: flags, a descriptor set, a descriptor, how much room a small builder lacks; then the data of the field,
 * or with PAYLOAD the payload of a packet.
 */
#include "fuzz.h"

#include "mip/extra/registry.h"

static bool all_zero(const void *memory, size_t size) {
    const uint8_t *bytes = (const uint8_t *)memory;
    for (size_t i = 0; i < size; i++) {
        if (bytes[i] != 0) {
            return false;
        }
    }
    return true;
}

enum { PAYLOAD = 0x80 };

static void check_packet(struct mip_builder *b, uint8_t set) {
    const struct mip_packet packet = mip_builder_finish(b);
    struct mip_packet checked;
    CHECK(mip_packet_check(packet.bytes, packet.size, &checked) == MIP_OK);
    CHECK(checked.descriptor_set == set && checked.size == b->length + MIP_CHECKSUM_SIZE);
}

/* Encodes a value with exactly the room that it needs, less `lack` bytes; the field in front of it is untouched. */
static void encode_tightly(const struct mip_codec *codec, const void *value, uint8_t set, const uint8_t *wanted,
                           size_t size, size_t lack) {
    static const uint8_t front[3] = {1, 2, 3};
    const size_t before = MIP_HEADER_SIZE + 2 + sizeof(front);
    const size_t room = before + 2 + size + MIP_CHECKSUM_SIZE;
    const size_t capacity = room - (lack < size + 2 ? lack : size + 2);
    uint8_t *buffer = (uint8_t *)exactly(capacity);
    struct mip_builder b;
    CHECK(mip_builder_start(&b, buffer, capacity, set) == MIP_OK);
    CHECK(mip_builder_add(&b, 0x7E, front, sizeof(front)) == MIP_OK && b.length == before);
    const mip_error error = mip_encode(codec, value, &b);
    if (lack == 0 && room <= MIP_MAX_PACKET) {
        CHECK(error == MIP_OK && b.length == before + 2 + size);
        CHECK(buffer[before] == size + 2 && buffer[before + 1] == codec->descriptor);
        CHECK(size == 0 || memcmp(buffer + before + 2, wanted, size) == 0);
    } else {
        CHECK(error == MIP_ERROR_LENGTH && b.length == before);
    }
    CHECK(buffer[3] == b.length - MIP_HEADER_SIZE && memcmp(buffer + before - sizeof(front), front, sizeof(front)) == 0);
    check_packet(&b, set);
    free(buffer);
}

/* Encodes a value that was decoded: the same bytes, and the same value again. */
static void encode_again(const struct mip_codec *codec, const uint8_t *value, const struct mip_field *field, size_t size,
                         size_t lack) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder b;
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), field->descriptor_set) == MIP_OK);
    CHECK(mip_encode(codec, value, &b) == MIP_OK);
    CHECK(b.length == MIP_HEADER_SIZE + 2 + size);
    CHECK(size == 0 || memcmp(buffer + MIP_HEADER_SIZE + 2, field->data, size) == 0);
    check_packet(&b, field->descriptor_set);

    uint8_t *again = (uint8_t *)exactly(codec->size);
    const struct mip_field encoded = {buffer + MIP_HEADER_SIZE + 2, (uint8_t)size, field->descriptor_set,
                                      field->descriptor};
    size_t trailing;
    memset(again, 0x55, codec->size);
    CHECK(mip_decode(codec, again, &encoded, &trailing) == MIP_OK && trailing == 0);
    CHECK(memcmp(value, again, codec->size) == 0);
    free(again);
    encode_tightly(codec, value, field->descriptor_set, field->data, size, 0);
    encode_tightly(codec, value, field->descriptor_set, field->data, size, 1 + lack);
}

/* Encodes arbitrary memory as a value: if it can be encoded, decoding returns the same. */
static void encode_anything(const struct mip_codec *codec, const struct mip_field *field) {
    uint8_t *value = (uint8_t *)exactly(codec->size);
    for (size_t i = 0; i < codec->size; i++) {
        value[i] = field->size > 0 ? field->data[i % field->size] : 0;
    }
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder b;
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), field->descriptor_set) == MIP_OK);
    const mip_error error = mip_encode(codec, value, &b);
    if (error == MIP_OK) {
        const size_t size = b.length - MIP_HEADER_SIZE - 2;
        const struct mip_field encoded = {buffer + MIP_HEADER_SIZE + 2, (uint8_t)size, field->descriptor_set,
                                          field->descriptor};
        size_t trailing;
        CHECK(mip_decode(codec, value, &encoded, &trailing) == MIP_OK && trailing == 0);
        encode_again(codec, value, &encoded, size, 0);
    } else {
        CHECK(error == MIP_ERROR_COUNT || error == MIP_ERROR_LENGTH || error == MIP_ERROR_MISSING);
        CHECK(b.length == MIP_HEADER_SIZE && buffer[3] == 0);
        check_packet(&b, field->descriptor_set);
    }
    free(value);
}

static void one_layout(const struct mip_codec *codec, const struct mip_field *field, size_t lack) {
    uint8_t *value = (uint8_t *)exactly(codec->size);
    size_t trailing = SIZE_MAX;
    memset(value, 0xAA, codec->size);
    const mip_error error = mip_decode(codec, value, field, &trailing);
    if (error == MIP_OK) {
        CHECK(trailing <= field->size);
        encode_again(codec, value, field, field->size - trailing, lack);
    } else {
        CHECK(error == MIP_ERROR_TRUNCATED || error == MIP_ERROR_COUNT || error == MIP_ERROR_CONSTANT ||
              error == MIP_ERROR_LAYOUT);
        CHECK(all_zero(value, codec->size));
    }
    CHECK((error == MIP_ERROR_LAYOUT) == !mip_codec_matches(codec, field));
    free(value);
    encode_anything(codec, field);
}

static void all_layouts(const struct mip_field *field, size_t lack) {
    const struct mip_entry *found = mip_registry_find(field);
    const struct mip_entry *entry = NULL;
    bool among = false;
    while ((entry = mip_registry_next(field->descriptor_set, field->descriptor, entry)) != NULL) {
        const struct mip_codec *codec = entry->codec;
        CHECK(codec->descriptor == field->descriptor && mip_codec_belongs(codec, field->descriptor_set));
        CHECK(mip_field_is(field, codec) == mip_codec_matches(codec, field));
        among = among || found == entry;
        one_layout(codec, field, lack);
    }
    CHECK(found == NULL || (among && mip_codec_matches(found->codec, field)));
}

/* The fields of a payload by the rules of the wire; the walk finds the same, and a builder builds it again. */
static void all_fields(const uint8_t *payload, size_t size, uint8_t set, size_t lack) {
    uint8_t *bytes = (uint8_t *)exactly(size + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE);
    bytes[0] = 0x75;
    bytes[1] = 0x65;
    bytes[2] = set;
    bytes[3] = (uint8_t)size;
    if (size > 0) {
        memcpy(bytes + MIP_HEADER_SIZE, payload, size);
    }
    const uint16_t sum = mip_checksum(bytes, MIP_HEADER_SIZE + size);
    bytes[MIP_HEADER_SIZE + size] = (uint8_t)(sum >> 8);
    bytes[MIP_HEADER_SIZE + size + 1] = (uint8_t)(sum & 0xFF);
    struct mip_packet packet;
    CHECK(mip_packet_check(bytes, size + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE, &packet) == MIP_OK);

    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder b;
    struct mip_field field;
    struct mip_walk walk = mip_walk_packet(&packet);
    size_t at = 0;
    CHECK(mip_builder_start(&b, buffer, sizeof(buffer), set) == MIP_OK);
    while (at < size && payload[at] >= 2 && payload[at] <= size - at) {
        CHECK(mip_walk_next(&walk, &field));
        CHECK(field.data == bytes + MIP_HEADER_SIZE + at + 2 && field.size == payload[at] - 2);
        CHECK(field.descriptor == payload[at + 1] && field.descriptor_set == set);
        CHECK(mip_builder_add(&b, field.descriptor, field.data, field.size) == MIP_OK);
        all_layouts(&field, lack);
        at += payload[at];
    }
    CHECK(!mip_walk_next(&walk, &field) && (walk.error == MIP_ERROR_FIELD_LENGTH) == (at < size));
    CHECK(!mip_walk_next(&walk, &field) && (walk.error == MIP_ERROR_FIELD_LENGTH) == (at < size));
    CHECK(b.length == MIP_HEADER_SIZE + at && memcmp(buffer + MIP_HEADER_SIZE, bytes + MIP_HEADER_SIZE, at) == 0);
    check_packet(&b, set);
    free(bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct input in = {data, size};
    const uint8_t flags = input_byte(&in);
    const uint8_t set = input_byte(&in);
    const uint8_t descriptor = input_byte(&in);
    const size_t lack = input_byte(&in);
    if (set == 0 || set == 0xFF) { /* no packet has them */
        return 0;
    }
    size_t count = (flags & PAYLOAD) != 0 ? MIP_MAX_PAYLOAD : MIP_MAX_FIELD_DATA;
    uint8_t *bytes = input_bytes(&in, &count);
    if ((flags & PAYLOAD) != 0) {
        all_fields(bytes, count, set, lack);
    } else {
        const struct mip_field field = {bytes, (uint8_t)count, set, descriptor};
        all_layouts(&field, lack);
    }
    free(bytes);
    return 0;
}
