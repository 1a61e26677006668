/* Values that may be anything, and how a loop is recognized. */
#ifndef ANY_H
#define ANY_H

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

size_t nondet_size(void);
uint8_t nondet_byte(void);
uint16_t nondet_16(void);
uint32_t nondet_32(void);
_Bool nondet_bool(void);

static size_t up_to(size_t most) {
    const size_t value = nondet_size();
    __CPROVER_assume(value <= most);
    return value;
}

/* Memory of exactly this size, with any content. */
static uint8_t *any_bytes(size_t size) {
    uint8_t *bytes = (uint8_t *)malloc(size);
    __CPROVER_assume(bytes != NULL);
    return bytes;
}

/* In a macro for loops: is it this one, by its function and the length of its head? */
#define IS(function, head, text) (sizeof(__func__) == sizeof(function) && sizeof(text) == sizeof(head))

#endif
