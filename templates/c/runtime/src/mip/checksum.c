/* The checksum: a is the sum of all bytes, b the sum of all values of a, both modulo 256.
 *
 * For bytes x[0] to x[n - 1], b is also the sum of (n - i) * x[i], so that many bytes can be added
 * at once. MIP_CHECKSUM chooses how; without it, the compiler's target and options do. */
#include "mip/core.h"

#define MIP_CHECKSUM_PLAIN 0 /* byte by byte: the smallest */
#define MIP_CHECKSUM_WORDS 1 /* eight bytes at a time: portable */
#define MIP_CHECKSUM_SSE2 2  /* sixteen bytes at a time */
#define MIP_CHECKSUM_NEON 3

#ifndef MIP_CHECKSUM
#if defined(__OPTIMIZE_SIZE__) || UINTPTR_MAX < UINT64_MAX
#define MIP_CHECKSUM MIP_CHECKSUM_PLAIN
#elif defined(__SSE2__) || defined(_M_X64)
#define MIP_CHECKSUM MIP_CHECKSUM_SSE2
#elif defined(__ARM_NEON)
#define MIP_CHECKSUM MIP_CHECKSUM_NEON
#else
#define MIP_CHECKSUM MIP_CHECKSUM_WORDS
#endif
#endif

/** The sums; only their low eight bits count. */
struct sums {
    uint32_t a;
    uint32_t b;
};

static struct sums plain(const uint8_t *bytes, size_t size) {
    struct sums s = {0, 0};
    for (size_t i = 0; i < size; i++) {
        s.a += bytes[i];
        s.b += s.a;
    }
    return s;
}

#if MIP_CHECKSUM != MIP_CHECKSUM_PLAIN

/** The sums of one run of bytes and of `size` bytes behind it. */
static struct sums joined(struct sums first, struct sums second, size_t size) {
    first.b += first.a * (uint32_t)size + second.b;
    first.a += second.a;
    return first;
}

/** Four lanes of 16 bits, each with eight that count. */
#define LANES UINT64_C(0x00FF00FF00FF00FF)

/** The sum of the lanes, each times its weight; the weight of the lowest lane is the highest one.
 */
static uint32_t weighted(uint64_t lanes, uint64_t weights) {
    return (uint32_t)((lanes * weights) >> 48);
}

/** Compilers make one load of this where the host allows it. */
static uint64_t load(const uint8_t *p) {
    return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24 |
           (uint64_t)p[4] << 32 | (uint64_t)p[5] << 40 | (uint64_t)p[6] << 48 |
           (uint64_t)p[7] << 56;
}

static struct sums words(const uint8_t *bytes, size_t size) {
    const size_t odd = size % 8;
    struct sums sums = plain(bytes, odd);
    const uint8_t *at = bytes + odd;
    const uint8_t *end = bytes + size;
    uint64_t even_bytes = 0; /* by their place in a word */
    uint64_t odd_bytes = 0;
    uint64_t before = 0; /* the sum of what the sums were before each word */
    while (at < end) {
        const uint8_t *stop = end - at > 64 ? at + 64 : end; /* lanes overflow after nine words */
        for (; at < stop; at += 8) {
            const uint64_t word = load(at);
            before += even_bytes + odd_bytes;
            even_bytes += word & LANES;
            odd_bytes += (word >> 8) & LANES;
        }
        before &= LANES;
        even_bytes &= LANES;
        odd_bytes &= LANES;
    }
    const uint64_t ones = UINT64_C(0x0001000100010001);
    const struct sums rest = {weighted(even_bytes, ones) + weighted(odd_bytes, ones),
                              8 * weighted(before, ones) +
                                  weighted(even_bytes, UINT64_C(0x0008000600040002)) +
                                  weighted(odd_bytes, UINT64_C(0x0007000500030001))};
    return joined(sums, rest, size - odd);
}

#endif

#if MIP_CHECKSUM == MIP_CHECKSUM_SSE2

#include <emmintrin.h>

static uint32_t total(__m128i v) {
    v = _mm_add_epi32(v, _mm_srli_si128(v, 8));
    v = _mm_add_epi32(v, _mm_srli_si128(v, 4));
    return (uint32_t)_mm_cvtsi128_si32(v);
}

/** Bytes times their weights, 16 to 1. */
static __m128i products(__m128i v) {
    const __m128i zero = _mm_setzero_si128();
    return _mm_add_epi32(
        _mm_madd_epi16(_mm_unpacklo_epi8(v, zero), _mm_set_epi16(9, 10, 11, 12, 13, 14, 15, 16)),
        _mm_madd_epi16(_mm_unpackhi_epi8(v, zero), _mm_set_epi16(1, 2, 3, 4, 5, 6, 7, 8)));
}

static struct sums vectors(const uint8_t *bytes, size_t size) {
    static const uint8_t masks[32] = {0,    0,    0,    0,    0,    0,    0,    0,
                                      0,    0,    0,    0,    0,    0,    0,    0,
                                      0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,
                                      0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
    if (size < 16) {
        return words(bytes, size);
    }
    const __m128i zero = _mm_setzero_si128();
    const size_t rest = size % 16;
    __m128i a = zero;
    __m128i b = zero;
    __m128i before = zero;
    for (const uint8_t *at = bytes; at < bytes + (size - rest); at += 16) {
        const __m128i v = _mm_loadu_si128((const __m128i *)(const void *)at);
        before = _mm_add_epi32(before, a);
        a = _mm_add_epi32(a, _mm_sad_epu8(v, zero));
        b = _mm_add_epi32(b, products(v));
    }
    /* The last sixteen bytes once more, without those that are done. */
    const __m128i mask = _mm_loadu_si128((const __m128i *)(const void *)(masks + rest));
    const __m128i v =
        _mm_and_si128(mask, _mm_loadu_si128((const __m128i *)(const void *)(bytes + (size - 16))));
    const uint32_t done = total(a);
    b = _mm_add_epi32(_mm_add_epi32(b, products(v)), _mm_slli_epi32(before, 4));
    const struct sums s = {done + total(_mm_sad_epu8(v, zero)), total(b) + done * (uint32_t)rest};
    return s;
}

#elif MIP_CHECKSUM == MIP_CHECKSUM_NEON

#include <arm_neon.h>

static uint32_t total(uint32x4_t v) {
    return vgetq_lane_u32(v, 0) + vgetq_lane_u32(v, 1) + vgetq_lane_u32(v, 2) +
           vgetq_lane_u32(v, 3);
}

static struct sums vectors(const uint8_t *bytes, size_t size) {
    static const uint8_t weights[16] = {16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1};
    const size_t odd = size % 16;
    const struct sums head = words(bytes, odd);
    const uint8x16_t w = vld1q_u8(weights);
    uint32x4_t a = vdupq_n_u32(0);
    uint32x4_t b = a;
    uint32x4_t before = a;
    for (const uint8_t *at = bytes + odd; at < bytes + size; at += 16) {
        const uint8x16_t v = vld1q_u8(at);
        before = vaddq_u32(before, a);
        a = vpadalq_u16(a, vpaddlq_u8(v));
        b = vpadalq_u16(b, vmull_u8(vget_low_u8(v), vget_low_u8(w)));
        b = vpadalq_u16(b, vmull_u8(vget_high_u8(v), vget_high_u8(w)));
    }
    const struct sums rest = {total(a), total(b) + 16 * total(before)};
    return joined(head, rest, size - odd);
}

#endif

uint16_t mip_checksum(const uint8_t *bytes, size_t size) {
#if MIP_CHECKSUM == MIP_CHECKSUM_PLAIN
    const struct sums s = plain(bytes, size);
#elif MIP_CHECKSUM == MIP_CHECKSUM_WORDS
    const struct sums s = words(bytes, size);
#else
    const struct sums s = vectors(bytes, size);
#endif
    return (uint16_t)((s.a & 0xFFU) << 8 | (s.b & 0xFFU));
}
