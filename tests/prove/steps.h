/*
 * What makes a codec well-formed: mip/codec.c and the interpreter of mip/program.c then access nothing outside the
 * field, the structure and the program. codec.c and interpreter.c prove this; programs.c looks whether the codecs of a
 * library are well-formed.
 */
#include "mip/core/program.h"

#ifndef PRODUCT
#define PRODUCT(count, each) ((count) * (each))
#endif

/* The numbers of one item of a counted array. With more of them, the prover needs too long for their product. */
#define MOST_NUMBERS 4

/* What a program is run for. */
struct surroundings {
    size_t size;     /* of the structure */
    bool far;        /* are there places of two bytes? */
    bool whole;      /* is this the program of a field, not of an item? */
    size_t capacity; /* of the array that the step before has counted; 0 if it has not */
};

/* The place that begins here; `size` or more if it is not in the structure. */
static size_t place_at(const uint8_t *p, const struct surroundings *in) {
    return in->far ? (size_t)(p[0] << 8 | p[1]) : p[0];
}

/* Is it inside, and is there so much behind it? */
static bool fits(const uint8_t *p, size_t size, const struct surroundings *in) {
    const size_t at = place_at(p, in);
    return at <= in->size && size <= in->size - at;
}

static bool is_size(size_t size) {
    return size == 1 || size == 2 || size == 4 || size == 8;
}

/* The bytes of a step without the programs in it; 0 if it is ill-formed, or if it has more than `left` bytes. */
static size_t step_size(const uint8_t *p, size_t left, const struct surroundings *in) {
    const size_t place = in->far ? 2 : 1;
    const size_t times = in->capacity > 0 ? in->capacity : 1;
    if (left < 1) {
        return 0;
    }
    if (p[0] >= MIP_NUMBERS(MIP_KIND_DOUBLE, 0)) {
        const bool many = (p[0] & 31) == 0;
        const size_t size = 1 + (many ? 1 : 0) + place;
        if (left < size) {
            return 0;
        }
        const size_t count = many ? p[1] : p[0] & 31;
        if (in->capacity > 0 && count > MOST_NUMBERS) {
            return 0;
        }
        const size_t number = p[0] >> 5 == MIP_KIND_DOUBLE ? sizeof(double) : (size_t)1 << (p[0] >> 5 & 3);
        return fits(p + size - place, count * times * number, in) ? size : 0;
    }
    if (p[0] == MIP_STEP_EACH) {
        const size_t size = 5 + place;
        if (left < size) {
            return 0;
        }
        const size_t count = in->capacity > 0 ? in->capacity : p[1];
        return p[4] > 0 && p[4] <= left - size && (in->capacity == 0 || p[1] == 1) &&
                       fits(p + 5, PRODUCT(count, (size_t)p[2] << 8 | p[3]), in)
                   ? size
                   : 0;
    }
    if (in->capacity > 0) {
        return 0; /* only arrays are counted */
    }
    switch (p[0]) {
    case MIP_STEP_FAR:
        return in->whole ? 1 : 0;
    case MIP_STEP_LAYOUT:
        return left >= 4 && left >= 4U + 2U * p[3] ? 4U + 2U * p[3] : 0;
    case MIP_STEP_OPTIONAL: {
        const size_t size = left < 3 ? 0 : p[1] > 0 ? 2U + p[1] : 3U;
        return in->whole && size <= left && in->size >= 2 ? size : 0;
    }
    case MIP_STEP_CONSTANT:
        return left >= 2 && left >= 2U + p[1] ? 2U + p[1] : 0;
    case MIP_STEP_COUNTED:
    case MIP_STEP_REST:
        return left >= 4 + place && is_size(p[1]) && p[2] > 0 && p[3] > 0 && fits(p + 4, p[1], in) ? 4 + place : 0;
    case MIP_STEP_SWITCH:
        return left >= 3 + place && is_size(p[1]) && fits(p + 3, p[1], in) ? 3 + place : 0;
    case MIP_STEP_GROUP:
        return left >= 2 ? 2 : 0;
    default: /* MIP_END, MIP_RESERVED, groups */
        return 1;
    }
}

/* The bytes of a case of a switch without its program; 0 if it is ill-formed. */
static size_t case_size(const uint8_t *p, size_t left, size_t tag) {
    return left > tag && p[tag] > 0 && p[tag] <= left - tag - 1 ? tag + 1 : 0;
}

/* The bytes of a program, of which there may be `left`; 0 if it is ill-formed. */
static size_t program_size(const uint8_t *p, size_t left, struct surroundings in) {
    size_t at = 0;
    for (;;) {
        size_t size = step_size(p + at, left - at, &in);
        const uint8_t *step = p + at;
        if (size == 0) {
            return 0;
        }
        if (step[0] == MIP_STEP_END) {
            return at + 1;
        }
        if (step[0] == MIP_STEP_EACH) {
            const struct surroundings item = {(size_t)step[2] << 8 | step[3], in.far, false, 0};
            if (program_size(step + size, step[4], item) != step[4]) {
                return 0;
            }
            size += step[4];
        }
        at += size;
        if (step[0] == MIP_STEP_SWITCH) { /* its cases end the program; the MIP_END behind them is not reached */
            for (size_t cases = step[2]; cases > 0; cases--) {
                const size_t head = case_size(p + at, left - at, step[1]);
                const size_t length = head > 0 ? p[at + head - 1] : 0;
                if (head == 0 || program_size(p + at + head, length, in) != length) {
                    return 0;
                }
                at += head + length;
            }
            return at < left && p[at] == MIP_STEP_END ? at + 1 : 0;
        }
        in.far = in.far || step[0] == MIP_STEP_FAR;
        in.capacity = step[0] == MIP_STEP_COUNTED || step[0] == MIP_STEP_REST ? step[2] : 0;
    }
}

/* The bytes in a field of a step of numbers, of a layout that has no other steps; 0 if it is ill-formed. */
static size_t numbers_size(const uint8_t *p, size_t structure) {
    const size_t bytes = (size_t)(p[0] & 31) << (p[0] >> 5 & 3);
    return p[0] >= MIP_NUMBERS(MIP_KIND_DOUBLE, 0) && p[1] <= structure && bytes <= structure - p[1] ? bytes : 0;
}

/* Are the numbers of its shape those of the codec, and in its structure? */
static bool shape_fits(const struct mip_codec *codec) {
    const size_t shape = codec->shape;
    return shape == 0 || (codec->numbers == shape / 50 * 8 + shape % 50 / 5 * 4 + shape % 5 * 2 &&
                          codec->numbers <= codec->size && codec->interpreter == NULL);
}

/* A codec of any layout. */
static bool well_formed(const struct mip_codec *codec) {
    const struct surroundings field = {codec->size, false, true, 0};
    const uint8_t *p = codec->program;
    size_t numbers = 0;
    if (!shape_fits(codec)) {
        return false;
    }
    if (codec->interpreter != NULL) {
        return (codec->interpreter->matches == NULL || p[0] == MIP_STEP_LAYOUT) && program_size(p, 0xFFFF, field) > 0;
    }
    for (; p[0] != MIP_STEP_END; p += 2) {
        const size_t size = numbers_size(p, codec->size);
        if (size == 0) {
            return false;
        }
        numbers += size;
    }
    return numbers == codec->numbers;
}
