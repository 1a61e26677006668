/*
 * Layouts that are more than numbers. Their program is run for one size after the other, and for one value after the
 * other of each byte that decides how others are read (WIRE: its place, how many values, the values). Each case is a
 * branch of its own that ends there, so that the prover does not carry the state of one into the next.
 */
#include "layout.h"

_Bool nondet_bool(void);

struct split {
    size_t at;
    size_t count;
    uint8_t values[40];
};
static const struct split wire[] = {WIRE{0, 0, {0}}};

/* The next choice of values; false after the last. */
static bool next(const struct split *splits, size_t *choice) {
    for (; splits->count > 0; splits++, choice++) {
        if (++*choice < splits->count) {
            return true;
        }
        *choice = 0;
    }
    return false;
}

/* Sets bytes to the values of a choice; false if another choice has the same bytes, because the field is shorter. */
static bool choose(uint8_t *bytes, size_t size, const struct split *splits, const size_t *choice) {
    bool first = true;
    for (; splits->count > 0; splits++, choice++) {
        if (splits->at < size) {
            bytes[splits->at] = splits->values[*choice];
        } else {
            first = first && *choice == 0;
        }
    }
    return first;
}

void decode(void) {
    size_t choice[8] = {0};
    do {
        for (size_t size = 0; size <= LARGEST; size++) {
            uint8_t data[LARGEST]; /* the field ends where this does */
            if (choose(data + (LARGEST - size), size, wire, choice) && nondet_bool()) {
                decode_these(data + (LARGEST - size), size);
                __CPROVER_assume(false);
            }
        }
    } while (next(wire, choice));
}
