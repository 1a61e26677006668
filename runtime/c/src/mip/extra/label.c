/* The names of values. */
#include "mip/extra/reflect.h"

#include <string.h>

const char *mip_names_label(const struct mip_names *names, size_t index) {
    const char *label = names->labels;
    while (index > 0) {
        index -= *label == '\0';
        label++;
    }
    return label;
}

uint64_t mip_names_number(const struct mip_names *names, size_t index) {
    const uint8_t *at = (const uint8_t *)names->numbers;
    uint8_t byte = 0;
    uint16_t half = 0;
    uint32_t word = 0;
    uint64_t twice = 0;
    if (at == NULL) { /* a bitfield */
        return 0;
    }
    at += index * names->size;
    switch (names->size) {
    case 1:
        memcpy(&byte, at, sizeof(byte));
        return byte;
    case 2:
        memcpy(&half, at, sizeof(half));
        return half;
    case 4:
        memcpy(&word, at, sizeof(word));
        return word;
    default:
        memcpy(&twice, at, sizeof(twice));
        return twice;
    }
}

const char *mip_value_name(const struct mip_names *names, uint64_t value) {
    for (size_t i = 0; names->numbers != NULL && i < names->count; i++) {
        if (mip_names_number(names, i) == value) {
            return mip_names_label(names, i);
        }
    }
    return NULL;
}
