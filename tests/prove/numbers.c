/* Layouts of numbers only: fields of any size, packets of any capacity. */
#include "layout.h"

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
