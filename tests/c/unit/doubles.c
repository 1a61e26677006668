/* Doubles of four bytes: the conversions against those of a compiler that has both kinds. */
#include "check.h"

union wide {
    double number;
    uint64_t bits;
};

union narrow {
    float number;
    uint32_t bits;
};

static bool is_nan_64(uint64_t bits) {
    return (bits & UINT64_C(0x7FFFFFFFFFFFFFFF)) > UINT64_C(0x7FF0000000000000);
}

static bool is_nan_32(uint32_t bits) {
    return (bits & UINT32_C(0x7FFFFFFF)) > UINT32_C(0x7F800000);
}

static void narrow(uint64_t bits) {
    const uint32_t found = mip_narrow(bits);
    if (is_nan_64(bits)) {
        CHECK(is_nan_32(found) && found >> 31 == bits >> 63);
    } else {
        const union wide given = {.bits = bits};
        CHECK(found == ((union narrow){(float)given.number}).bits);
    }
}

static void widen(uint32_t bits) {
    const uint64_t found = mip_widen(bits);
    if (is_nan_32(bits)) {
        CHECK(is_nan_64(found) && found >> 63 == bits >> 31);
    } else {
        const union narrow given = {.bits = bits};
        CHECK(found == ((union wide){(double)given.number}).bits);
        CHECK(mip_narrow(found) == bits); /* nothing is lost on the way there and back */
    }
}

int main(void) {
    uint64_t state = 1;
    for (uint32_t exponent = 0; exponent < 0x800; exponent++) {
        for (int i = 0; i < 200; i++) {
            state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
            const uint64_t sign_and_mantissa = state & UINT64_C(0x800FFFFFFFFFFFFF);
            /* Few bits set, too, so that halves occur, which are rounded to even. */
            const uint64_t few = UINT64_C(1) << (state >> 58) % 52 | UINT64_C(1) << (i % 52);
            const uint64_t all = (uint64_t)exponent << 52;
            narrow(all | sign_and_mantissa);
            narrow(all | few);
            narrow(all | (few & UINT64_C(0x000FFFFFF0000000)));
            narrow(all);
            narrow(all | UINT64_C(0x000FFFFFFFFFFFFF));
            widen((exponent & 0xFF) << 23 | (uint32_t)(state >> 41) | (uint32_t)(state & 1) << 31);
            widen((exponent & 0xFF) << 23 | 1);
            widen((exponent & 0xFF) << 23);
        }
    }
    return 0;
}
