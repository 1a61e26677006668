/* Layouts of numbers only: fields of any size. */
#include "layout.h"

void decode(void) {
    const size_t size = nondet_size();
    __CPROVER_assume(size <= LARGEST);
    uint8_t *data = (uint8_t *)malloc(size);
    __CPROVER_assume(data != NULL);
    decode_these(data, size);
}
