/* Shared by the fuzz targets. Each is one function in libFuzzer's form, which replay.c calls without libFuzzer. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition)                                                    \
    do {                                                                    \
        if (!(condition)) {                                                 \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            abort();                                                        \
        }                                                                   \
    } while (0)

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The input, read from its front; zeros after its end. */
struct input {
    const uint8_t *at;
    size_t left;
};

static inline uint8_t input_byte(struct input *in) {
    if (in->left == 0) {
        return 0;
    }
    in->left--;
    return *in->at++;
}

/* Memory of exactly this size, so that the address sanitizer reports every access beyond it. */
static inline void *exactly(size_t size) {
    void *memory = malloc(size > 0 ? size : 1);
    CHECK(memory != NULL);
    return memory;
}

/* The next bytes of the input, at most `size`, in memory of their own. */
static inline uint8_t *input_bytes(struct input *in, size_t *size) {
    *size = *size < in->left ? *size : in->left;
    uint8_t *bytes = (uint8_t *)exactly(*size);
    if (*size > 0) {
        memcpy(bytes, in->at, *size);
        in->at += *size;
        in->left -= *size;
    }
    return bytes;
}

#endif
