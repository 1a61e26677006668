/* Prints numbers as decimal text without the C library, exactly, by multi-word arithmetic. */
#include "mip/extra/print.h"

#include <string.h>

/* The number of words for the largest and the smallest double, scaled to whole numbers. */
#define WORDS 37
/* The number of digits that distinguish every double from all others. */
#define MAX_DIGITS 17
/* Numbers with more digits before the point, or more zeros after it, are printed with an exponent.
 */
#define MAX_WHOLE 16
#define MAX_ZEROS 3

void mip_print_string(const struct mip_print *print, const char *text) {
    size_t size = 0;
    while (text[size] != '\0') {
        size++;
    }
    if (size > 0) {
        print->put(print->user, text, size);
    }
}

void mip_print_unsigned(const struct mip_print *print, uint64_t value) {
    char digits[20];
    size_t at = sizeof(digits);
    do {
        digits[--at] = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    print->put(print->user, digits + at, sizeof(digits) - at);
}

void mip_print_signed(const struct mip_print *print, int64_t value) {
    if (value < 0) {
        print->put(print->user, "-", 1);
    }
    mip_print_unsigned(print, value < 0 ? 0 - (uint64_t)value : (uint64_t)value);
}

/* ------------------------------------------------------------------------------- long numbers */

/* A whole number, least significant word first. All numbers in a computation have the same number
 * of words. */
struct big {
    uint32_t words[WORDS];
};

/* value * 2^shift */
static void set(struct big *b, uint64_t value, unsigned shift) {
    const unsigned first = shift / 32;
    const unsigned bits = shift % 32;
    memset(b, 0, sizeof(*b));
    b->words[first] = (uint32_t)(value << bits);
    b->words[first + 1] = (uint32_t)(value >> (32 - bits));
    b->words[first + 2] = bits > 0 ? (uint32_t)(value >> (64 - bits)) : 0;
}

static void times_ten(struct big *b, size_t size) {
    uint64_t carry = 0;
    for (size_t i = 0; i < size; i++) {
        carry += (uint64_t)b->words[i] * 10;
        b->words[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static void add(struct big *sum, const struct big *a, const struct big *b, size_t size) {
    uint64_t carry = 0;
    for (size_t i = 0; i < size; i++) {
        carry += (uint64_t)a->words[i] + b->words[i];
        sum->words[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static void subtract(struct big *from, const struct big *b, size_t size) {
    uint32_t borrow = 0;
    for (size_t i = 0; i < size; i++) {
        const uint64_t less = (uint64_t)b->words[i] + borrow;
        borrow = from->words[i] < less;
        from->words[i] = (uint32_t)(from->words[i] - less);
    }
}

/* Returns a negative number, zero or a positive number. */
static int compare(const struct big *a, const struct big *b, size_t size) {
    while (size-- > 0) {
        if (a->words[size] != b->words[size]) {
            return a->words[size] < b->words[size] ? -1 : 1;
        }
    }
    return 0;
}

/* ------------------------------------------------------------------------------------- digits */

/* A positive number: mantissa * 2^exponent. Below a power of two, the next number is only half as
 * far away as above it: `uneven`. */
struct binary {
    uint64_t mantissa;
    int exponent;
    bool uneven;
};

/* Estimates the exponent of the largest power of ten below a number; it may be one too low. */
static int estimate(const struct binary *v) {
    int32_t log = v->exponent - 1;
    for (uint64_t m = v->mantissa; m > 0; m >>= 1) {
        log++;
    }
    log *= 30103; /* the logarithm of 2, times 100000 */
    return (int)(log >= 0 ? log / 100000 : -((99999 - log) / 100000));
}

/*
 * Finds the shortest digits that are nearer to the number than to any other, and of those the
 * nearest, by the method of Steele and White. The number is rest / unit * 10^point; values less
 * than `below` below it or less than `above` above it are rounded to it. Returns the number of
 * digits; the decimal point is before the first one, shifted by `point`.
 */
static size_t shortest(const struct binary *v, char *digits, int *point) {
    const unsigned up = v->exponent > 0 ? (unsigned)v->exponent : 0;
    const unsigned down = v->exponent < 0 ? (unsigned)-v->exponent : 0;
    const unsigned shift = v->uneven ? 2 : 1;
    const size_t size = (up + down + 64) / 32 + 1;
    const int even = v->mantissa % 2 == 0 ? 1 : 0; /* halfway values are rounded to even numbers */
    struct big rest, unit, below, above, sum;
    size_t count = 0;
    set(&rest, v->mantissa, up + shift);
    set(&unit, 1, down + shift);
    set(&below, 1, up);
    set(&above, 1, up + shift - 1);
    *point = estimate(v);
    for (int i = 0; i < *point; i++) {
        times_ten(&unit, size);
    }
    for (int i = *point; i < 0; i++) {
        times_ten(&rest, size);
        times_ten(&below, size);
        times_ten(&above, size);
    }
    for (add(&sum, &rest, &above, size); compare(&sum, &unit, size) + even > 0; ++*point) {
        times_ten(&unit, size);
    }
    for (bool low = false, high = false; !low && !high; count++) {
        char digit = '0';
        times_ten(&rest, size);
        times_ten(&below, size);
        times_ten(&above, size);
        for (; compare(&rest, &unit, size) >= 0; digit++) {
            subtract(&rest, &unit, size);
        }
        add(&sum, &rest, &above, size);
        low = compare(&rest, &below, size) - even < 0;
        high = compare(&sum, &unit, size) + even > 0;
        if (low && high) {
            add(&sum, &rest, &rest, size);
            high = compare(&sum, &unit, size) + digit % 2 > 0;
        }
        digits[count] = (char)(digit + (high ? 1 : 0));
    }
    return count;
}

static void put_decimal(const struct mip_print *print, const struct binary *v) {
    char digits[MAX_DIGITS + MAX_WHOLE];
    int point;
    const size_t count = shortest(v, digits, &point);
    if (point > MAX_WHOLE || point < -MAX_ZEROS) {
        print->put(print->user, digits, 1);
        if (count > 1) {
            print->put(print->user, ".", 1);
            print->put(print->user, digits + 1, count - 1);
        }
        print->put(print->user, "e", 1);
        mip_print_signed(print, point - 1);
    } else if (point <= 0) {
        print->put(print->user, "0.000", (size_t)(2 - point));
        print->put(print->user, digits, count);
    } else {
        const size_t whole = (size_t)point;
        memset(digits + count, '0', MAX_WHOLE);
        print->put(print->user, digits, whole);
        if (count > whole) {
            print->put(print->user, ".", 1);
            print->put(print->user, digits + whole, count - whole);
        }
    }
}

/* Prints the number with these bits. Its mantissa has `width` bits, without the leading one. */
static void put_real(const struct mip_print *print, uint64_t bits, unsigned width,
                     unsigned exponents) {
    const uint64_t leading = UINT64_C(1) << width;
    const uint64_t mantissa = bits & (leading - 1);
    const uint32_t top = (UINT32_C(1) << exponents) - 1;
    const uint32_t exponent = (uint32_t)(bits >> width) & top;
    struct binary v;
    if (exponent == top && mantissa != 0) {
        mip_print_string(print, "nan");
        return;
    }
    if ((bits >> (width + exponents)) != 0) {
        print->put(print->user, "-", 1);
    }
    if (exponent == top) {
        mip_print_string(print, "inf");
        return;
    }
    if (exponent == 0 && mantissa == 0) {
        print->put(print->user, "0", 1);
        return;
    }
    v.mantissa = exponent > 0 ? mantissa + leading : mantissa;
    v.exponent = (int)(exponent > 0 ? exponent : 1) - (int)(top / 2) - (int)width;
    v.uneven = mantissa == 0 && exponent > 1;
    put_decimal(print, &v);
}

void mip_print_float(const struct mip_print *print, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof(bits));
    put_real(print, bits, 23, 8);
}

void mip_print_double(const struct mip_print *print, double value) {
    uint64_t bits = 0;
    uint32_t narrow = 0;
    memcpy(sizeof(value) == sizeof(bits) ? (void *)&bits : &narrow, &value, sizeof(value));
    if (sizeof(value) == sizeof(bits)) {
        put_real(print, bits, 52, 11);
    } else {
        put_real(print, narrow, 23, 8);
    }
}
