/* The few things of the library that more than one fuzz target needs. */
#ifndef FUZZ_LIBRARY_H
#define FUZZ_LIBRARY_H

#include "fuzz.h"

#include "mip/registry.h"

/* May a packet of this set hold a field of this codec? */
static inline bool belongs(const struct mip_codec *codec, uint8_t set) {
    return codec->descriptor_set == 0xFF ? set >= 0x80
           : codec->descriptor_set == 0  ? set < 0x80
                                         : set == codec->descriptor_set;
}

static inline bool all_zero(const void *memory, size_t size) {
    const uint8_t *bytes = (const uint8_t *)memory;
    for (size_t i = 0; i < size; i++) {
        if (bytes[i] != 0) {
            return false;
        }
    }
    return true;
}

#endif
