/*
 * Every type gets random bytes to decode and random memory to encode. Nothing may crash, a failed
 * decode leaves zeros, and a failed encode leaves the packet as it was.
 */
#include "check.h"

#include "mip/registry.h"

static uint32_t state = 1;

static uint8_t random_byte(void) {
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    const uint8_t byte = (uint8_t)(state >> 24);
    const uint8_t choice = (uint8_t)(state >> 16 & 3U);
    return choice == 0 ? 0 : choice == 1 ? (uint8_t)(byte % 8) /* functions, tags, counts */
                                         : byte;
}

/* A set whose packets may hold the field. */
static uint8_t set_of(const struct mip_codec *codec) {
    switch (codec->descriptor_set) {
    case 0:
        return 1;
    case 0xFF:
        return 0x80;
    default:
        return codec->descriptor_set;
    }
}

static void decode(const struct mip_codec *codec) {
    const uint8_t size = (uint8_t)(random_byte() % (MIP_MAX_FIELD_DATA + 1));
    uint8_t *data = (uint8_t *)malloc(size);
    uint8_t *value = (uint8_t *)malloc(codec->size);
    CHECK((data != NULL || size == 0) && value != NULL);
    for (size_t i = 0; i < size; i++) {
        data[i] = random_byte();
    }
    memset(value, 0xAA, codec->size);
    const struct mip_field field = {data, size, codec->descriptor_set, codec->descriptor};
    size_t trailing = 0;
    if (mip_decode(codec, value, &field, &trailing) == MIP_OK) {
        uint8_t buffer[MIP_MAX_PACKET];
        struct mip_builder b;
        const uint8_t set = set_of(codec);
        CHECK(mip_builder_start(&b, buffer, sizeof(buffer), set) == MIP_OK);
        CHECK(mip_encode(codec, value, &b) == MIP_OK);
        CHECK(b.length == MIP_HEADER_SIZE + 2 + size - trailing);
        CHECK(size == 0 || memcmp(buffer + MIP_HEADER_SIZE + 2, data, size - trailing) == 0);
    } else {
        for (size_t i = 0; i < codec->size; i++) {
            CHECK(value[i] == 0);
        }
    }
    free(data);
    free(value);
}

static void encode(const struct mip_entry *entry) {
    const struct mip_codec *codec = entry->codec;
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder b;
    uint8_t *value = (uint8_t *)malloc(codec->size);
    CHECK(value != NULL);
    for (size_t i = 0; i < codec->size; i++) {
        value[i] = random_byte();
    }
    const uint8_t set = set_of(codec);
    CHECK(mip_builder_start(&b, buffer, 6 + random_byte(), set) == MIP_OK);
    const size_t before = b.length;
    const mip_error error = mip_encode(codec, value, &b);
    CHECK(error == MIP_OK || error == MIP_ERROR_COUNT || error == MIP_ERROR_LENGTH || error == MIP_ERROR_MISSING);
    CHECK((error == MIP_OK) == (b.length != before) && b.length <= b.capacity - MIP_CHECKSUM_SIZE);
    struct mip_packet packet = mip_builder_finish(&b);
    CHECK(mip_packet_check(packet.bytes, packet.size, &packet) == MIP_OK);
    free(value);
}

int main(void) {
    for (size_t i = 0; i < mip_registry_size; i++) {
        for (int k = 0; k < 300; k++) {
            decode(mip_registry[i].codec);
            encode(&mip_registry[i]);
        }
    }
    return 0;
}
