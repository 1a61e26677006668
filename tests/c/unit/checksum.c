/* Every form of the checksum against the plain one: all lengths of packets and more, at all alignments. */
#include "check.h"
#include "mip/core.h"

enum { SIZE = 4096,
       ROOM = 32 };

static uint16_t by_the_book(const uint8_t *bytes, size_t size) {
    uint8_t a = 0;
    uint8_t b = 0;
    for (size_t i = 0; i < size; i++) {
        a = (uint8_t)(a + bytes[i]);
        b = (uint8_t)(b + a);
    }
    return (uint16_t)(a * 256u + b);
}

static uint8_t bytes[SIZE + ROOM];

int main(void) {
    uint32_t random = 1;
    for (int kind = 0; kind < 3; kind++) {
        for (size_t i = 0; i < sizeof(bytes); i++) {
            random = random * 1664525u + 1013904223u;
            bytes[i] = kind == 0 ? (uint8_t)(random >> 24) : kind == 1 ? 0xFF
                                                                       : (uint8_t)i;
        }
        for (size_t at = 0; at < ROOM; at++) {
            for (size_t size = 0; size <= 600; size++) {
                CHECK(mip_checksum(bytes + at, size) == by_the_book(bytes + at, size));
            }
            CHECK(mip_checksum(bytes + at, SIZE) == by_the_book(bytes + at, SIZE));
        }
    }
    return 0;
}
