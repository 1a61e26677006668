/* Doubles of eight bytes on compilers whose doubles have four. */
#include "mip/core.h"

/* The mantissa's bits and the exponent's bias, of both formats. */
#define WIDE 52
#define NARROW 23
#define WIDE_BIAS 1023
#define NARROW_BIAS 127

uint32_t mip_narrow(uint64_t bits) {
    const uint32_t sign = (uint32_t)(bits >> 32) & UINT32_C(0x80000000);
    const int exponent = (int)(bits >> WIDE & 0x7FF) - WIDE_BIAS + NARROW_BIAS;
    uint64_t mantissa = bits & ((UINT64_C(1) << WIDE) - 1);
    unsigned drop = WIDE - NARROW;
    uint32_t narrow = 0;
    if (exponent == 0x7FF - WIDE_BIAS + NARROW_BIAS) { /* infinity, or a NaN, which stays quiet */
        const uint32_t quiet = mantissa != 0 ? UINT32_C(1) << (NARROW - 1) : 0;
        return sign | UINT32_C(0x7F800000) | quiet | (uint32_t)(mantissa >> drop);
    }
    if (exponent >= 0xFF) {
        return sign | UINT32_C(0x7F800000);
    }
    if (exponent > 0) {
        narrow = (uint32_t)exponent << NARROW;
    } else { /* subnormal: the leading one becomes a bit of the mantissa */
        if (exponent < -NARROW) {
            return sign;
        }
        mantissa |= UINT64_C(1) << WIDE;
        drop += (unsigned)(1 - exponent);
    }
    const uint64_t rest = mantissa & ((UINT64_C(1) << drop) - 1);
    const uint64_t half = UINT64_C(1) << (drop - 1);
    narrow += (uint32_t)(mantissa >> drop);
    if (rest > half || (rest == half && (narrow & 1) != 0)) {
        narrow++; /* a carry correctly increments the exponent */
    }
    return sign | narrow;
}

uint64_t mip_widen(uint32_t bits) {
    const uint64_t sign = (uint64_t)(bits & UINT32_C(0x80000000)) << 32;
    uint32_t exponent = bits >> NARROW & 0xFF;
    uint32_t mantissa = bits & ((UINT32_C(1) << NARROW) - 1);
    if (exponent == 0xFF) {
        return sign | UINT64_C(0x7FF) << WIDE | (uint64_t)mantissa << (WIDE - NARROW);
    }
    if (exponent == 0) {
        if (mantissa == 0) {
            return sign;
        }
        exponent = 1;
        for (; (mantissa >> NARROW) == 0; exponent--) { /* subnormal: it becomes a normal double */
            mantissa <<= 1;
        }
        mantissa &= (UINT32_C(1) << NARROW) - 1;
    }
    /* The exponent of the smallest subnormals is negative; the sum is not. */
    return sign | (uint64_t)(uint32_t)(exponent + WIDE_BIAS - NARROW_BIAS) << WIDE |
           (uint64_t)mantissa << (WIDE - NARROW);
}
