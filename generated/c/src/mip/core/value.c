/* The members of structures: texts, bytes, and bits of bytes. */
#include "mip/core.h"

void mip_copy(void *to, size_t room, const void *from, size_t size) {
    if (size > 0 && room > 0) {
        memcpy(to, from, size < room ? size : room);
    }
}

void mip_copy_text(char *to, size_t room, const char *text) {
    size_t i = 0;
    for (; i + 1 < room && text[i] != '\0'; i++) {
        to[i] = text[i];
    }
    for (; i + 1 < room; i++) {
        to[i] = ' ';
    }
    to[i] = '\0';
}

uint64_t mip_get_bits(const uint8_t *bytes, unsigned bits) {
    uint64_t value = 0;
    for (unsigned i = bits >> 8; i-- > 0;) {
        const unsigned bit = (bits & 0xFFU) + i;
        value = value << 1 | ((unsigned)bytes[bit / 8] >> bit % 8 & 1U);
    }
    return value;
}

void mip_set_bits(uint8_t *bytes, unsigned bits, uint64_t value) {
    for (unsigned i = 0; i < bits >> 8; i++) {
        const unsigned bit = (bits & 0xFFU) + i;
        const unsigned mask = 1U << bit % 8;
        if ((value & 1U) != 0) {
            bytes[bit / 8] = (uint8_t)(bytes[bit / 8] | mask);
        } else {
            bytes[bit / 8] = (uint8_t)(bytes[bit / 8] & ~mask);
        }
        value >>= 1;
    }
}
