/* The few things of the library that more than one fuzz target needs. */
#ifndef FUZZ_LIBRARY_H
#define FUZZ_LIBRARY_H

#include "fuzz.h"

#include "mip/registry.h"

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
