/**
 * @file
 * The checksum, inline for the parser, and for mip_checksum.
 */
#ifndef MIP_CHECKSUM_H
#define MIP_CHECKSUM_H

/* a is the sum of all bytes, b the sum of all values of a, both modulo 256.
 *
 * For bytes x[0] to x[n - 1], b is also the sum of (n - i) * x[i], so that many bytes can be
 * added at once. MIP_CHECKSUM selects the method; without it, the compiler's target and options
 * do. */
#include "mip/core.h"

/** Byte by byte: the smallest code. */
#define MIP_CHECKSUM_PLAIN 0
/** Eight bytes at a time: portable. */
#define MIP_CHECKSUM_WORDS 1
/** Sixteen bytes at a time. */
#define MIP_CHECKSUM_SSE2 2

/** @def MIP_CHECKSUM
 * The method of computing checksums, one of these. */
#ifndef MIP_CHECKSUM
#if defined(__OPTIMIZE_SIZE__) || UINTPTR_MAX < UINT64_MAX
/** The method of computing checksums. */
#define MIP_CHECKSUM MIP_CHECKSUM_PLAIN
#elif defined(__SSE2__) || defined(_M_X64)
#define MIP_CHECKSUM MIP_CHECKSUM_SSE2
#else
#define MIP_CHECKSUM MIP_CHECKSUM_WORDS
#endif
#endif

/** The sums; only their low eight bits count. */
struct mip_sums {
    /** The sum of all bytes. */
    uint32_t a;
    /** The sum of all values of a. */
    uint32_t b;
};

/** Byte by byte. */
static inline struct mip_sums plain(const uint8_t *bytes, size_t size) {
    struct mip_sums s = {0, 0};
    const uint8_t *end = bytes + size;
    if (size % 2 > 0) {
        s.a = *bytes++;
        s.b = s.a;
    }
    while (bytes != end) {
        s.a += bytes[0];
        s.b += s.a;
        s.a += bytes[1];
        s.b += s.a;
        bytes += 2;
    }
    return s;
}

#if MIP_CHECKSUM == MIP_CHECKSUM_WORDS

/** Four lanes of 16 bits, of which only the low eight matter. */
#define LANES UINT64_C(0x00FF00FF00FF00FF)

/** Loads eight bytes in big-endian order; compilers reduce this to one load where possible. */
static inline uint64_t load(const uint8_t *p) {
    return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24 |
           (uint64_t)p[4] << 32 | (uint64_t)p[5] << 40 | (uint64_t)p[6] << 48 |
           (uint64_t)p[7] << 56;
}

/** Eight bytes at a time. */
static inline struct mip_sums words(const uint8_t *bytes, size_t size) {
    if (size < 8) {
        return plain(bytes, size);
    }
    /* The first word is padded with zeros in front, which change nothing. */
    const uint64_t first = load(bytes) << (64 - 8 * size) % 64;
    uint64_t even = first & LANES; /* sums of bytes by their position in a word */
    uint64_t odd = (first >> 8) & LANES;
    uint64_t before = 0; /* the sum of the sums before each word */
    size_t left = (size - 1) / 8;
    bytes += size - 8 * left;
    while (left > 0) {
        size_t count = left < 15 ? left : 15; /* more would overflow the lanes */
        left -= count;
        for (; count > 0; count--) {
            const uint64_t word = load(bytes);
            before += even + odd;
            even += word & LANES;
            odd += (word >> 8) & LANES;
            bytes += 8;
        }
        before &= LANES;
        even &= LANES;
        odd &= LANES;
    }
    /* The highest lane of a product is the sum of all lanes times their weights. */
    const uint64_t a = (even + odd) * UINT64_C(0x0001000100010001);
    const uint64_t b = before * UINT64_C(0x0008000800080008) + even * UINT64_C(0x0008000600040002) +
                       odd * UINT64_C(0x0007000500030001);
    const struct mip_sums sums = {(uint32_t)(a >> 48), (uint32_t)(b >> 48)};
    return sums;
}

#endif

#if MIP_CHECKSUM == MIP_CHECKSUM_SSE2

#include <emmintrin.h>

/** Returns a mask for the last block, sixteen lanes of eight bits: it zeroes the bytes that earlier
 * blocks have summed. */
static inline const uint8_t *mask(size_t rest) {
    static const uint8_t bytes[32] = {0,    0,    0,    0,    0,    0,    0,    0,
                                      0,    0,    0,    0,    0,    0,    0,    0,
                                      0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,
                                      0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
    return bytes + rest;
}

/** Sixteen bytes. */
static inline __m128i block(const uint8_t *bytes) {
    return _mm_loadu_si128((const __m128i *)(const void *)bytes);
}

/** Sixteen bytes at a time. */
static inline struct mip_sums vectors(const uint8_t *bytes, size_t size) {
    if (size < 16) {
        return plain(bytes, size);
    }
    const __m128i zero = _mm_setzero_si128();
    const uint8_t *last = bytes + (size - 16);
    const size_t rest = size % 16;
    __m128i done = block(bytes); /* sums of bytes by their position in a block */
    __m128i before = zero;       /* the sum of the sums before each block */
    for (size_t at = 16; at + 16 <= size; at += 16) {
        before = _mm_add_epi8(before, done);
        done = _mm_add_epi8(done, block(bytes + at));
    }
    const __m128i a = _mm_add_epi8(done, _mm_and_si128(block(mask(rest)), block(last)));
    const __m128i low = _mm_set_epi16(9, 10, 11, 12, 13, 14, 15, 16);
    const __m128i high = _mm_set_epi16(1, 2, 3, 4, 5, 6, 7, 8);
    const __m128i inside = _mm_add_epi32(_mm_madd_epi16(_mm_unpacklo_epi8(a, zero), low),
                                         _mm_madd_epi16(_mm_unpackhi_epi8(a, zero), high));
    const __m128i behind = _mm_mul_epu32(_mm_sad_epu8(done, zero), _mm_set1_epi32((int)rest));
    const __m128i b =
        _mm_add_epi32(_mm_add_epi32(inside, behind), _mm_slli_epi32(_mm_sad_epu8(before, zero), 4));
    /* Both sums in one number: b has fewer than 20 bits, and only eight bits of a matter. */
    __m128i both = _mm_add_epi32(b, _mm_slli_epi32(_mm_sad_epu8(a, zero), 24));
    both = _mm_add_epi32(both, _mm_shuffle_epi32(both, _MM_SHUFFLE(1, 0, 3, 2)));
    both = _mm_add_epi32(both, _mm_shuffle_epi32(both, _MM_SHUFFLE(2, 3, 0, 1)));
    const uint32_t result = (uint32_t)_mm_cvtsi128_si32(both);
    const struct mip_sums sums = {result >> 24, result};
    return sums;
}

#endif

/** Computes the checksum of some bytes. */
MIP_INLINE uint16_t mip_sum(const uint8_t *bytes, size_t size) {
#if MIP_CHECKSUM == MIP_CHECKSUM_PLAIN
    const struct mip_sums s = plain(bytes, size);
#elif MIP_CHECKSUM == MIP_CHECKSUM_WORDS
    const struct mip_sums s = words(bytes, size);
#else
    const struct mip_sums s = vectors(bytes, size);
#endif
    return (uint16_t)((s.a & 0xFFU) << 8 | (s.b & 0xFFU));
}

#endif
