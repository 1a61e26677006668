/* Decodes and encodes fields. */
#include "mip/core/parser.h"
#include "mip/core/program.h"

#include <string.h>

/* Assumptions of programs and of member types. */
#define ASSERT(name, condition) typedef char assert_##name[(condition) ? 1 : -1]
ASSERT(bytes_have_eight_bits, (unsigned char)-1 == 255);
ASSERT(floats_have_four_bytes, sizeof(float) == 4);
ASSERT(doubles_have_eight_bytes_or_four, sizeof(double) == 8 || sizeof(double) == 4);

/** Reads or writes doubles if the compiler has none of eight bytes. */
static uint8_t *move_narrow(uint8_t *wire, uint8_t *memory, size_t count, bool writing) {
    for (; count > 0; count--) {
        uint32_t bits;
        if (writing) {
            memcpy(&bits, memory, sizeof(bits));
            mip_put_64(wire, mip_widen(bits));
        } else {
            bits = mip_narrow(mip_get_64(wire));
            memcpy(memory, &bits, sizeof(bits));
        }
        wire += 8;
        memory += sizeof(bits);
    }
    return wire;
}

#ifdef __OPTIMIZE_SIZE__
/** Does size matter more than speed? */
#define SMALL true

/** Reads or writes numbers of one kind. Few programs do both. */
MIP_INLINE uint8_t *move(uint8_t *wire, uint8_t *memory, unsigned kind, size_t count,
                         bool writing) {
    /* On a little-endian host, bytes in memory are in reverse order, so the last bits of their
     * index are flipped. */
    const uint16_t one = 1;
    const size_t size = (size_t)1 << (kind & 3);
    const size_t flip = *(const uint8_t *)&one == 1 ? size - 1 : 0;
    if (kind == MIP_KIND_DOUBLE && sizeof(double) < 8) {
        return move_narrow(wire, memory, count, writing);
    }
    for (size_t i = 0; i < size * count; i++) {
        uint8_t *at = memory + (i ^ flip);
        if (writing) {
            *wire++ = *at;
        } else {
            *at = *wire++;
        }
    }
    return wire;
}

uint8_t *mip_move(uint8_t *wire, uint8_t *memory, unsigned kind, size_t count, bool writing) {
    return move(wire, memory, kind, count, writing);
}

/** Reads or writes a layout that is only numbers. */
MIP_INLINE void move_all(const uint8_t *program, uint8_t *wire, uint8_t *value, bool writing) {
    for (unsigned step = *program; step != MIP_END; step = *program) {
        wire = move(wire, value + program[1], step >> 5, step & 31, writing);
        program += 2;
    }
}

#else
/** Does size matter more than speed? */
#define SMALL false

/** Reads or writes a number of 8, 16, 32 or 64 bits at an offset. */
#define MOVE_1(bits, at)                                    \
    do {                                                    \
        uint##bits##_t number;                              \
        if (writing) {                                      \
            memcpy(&number, memory + (at), sizeof(number)); \
            mip_put_##bits(wire + (at), number);            \
        } else {                                            \
            number = mip_get_##bits(wire + (at));           \
            memcpy(memory + (at), &number, sizeof(number)); \
        }                                                   \
    } while (0)

/** Reads or writes several numbers. */
#define MOVE(bits)          \
    do {                    \
        MOVE_1(bits, 0);    \
        wire += bits / 8;   \
        memory += bits / 8; \
    } while (--count > 0)

/** Reads or writes at least one number. */
MIP_QUICK uint8_t *move(uint8_t *wire, uint8_t *memory, unsigned step, size_t count, bool writing) {
    if (sizeof(double) < 8 && step < MIP_NUMBERS(MIP_KIND_DOUBLE + 1, 0)) {
        return move_narrow(wire, memory, count, writing);
    }
    if (step - MIP_NUMBERS(MIP_KIND_32, 0) < MIP_NUMBERS(1, 0)) { /* most numbers are floats */
        MOVE(32);
    } else if (step - MIP_NUMBERS(MIP_KIND_16, 0) < MIP_NUMBERS(1, 0)) {
        MOVE(16);
    } else if (step - MIP_NUMBERS(MIP_KIND_8, 0) < MIP_NUMBERS(1, 0)) {
        MOVE(8);
    } else {
        MOVE(64);
    }
    return wire;
}

uint8_t *mip_move(uint8_t *wire, uint8_t *memory, unsigned kind, size_t count, bool writing) {
    return count > 0 ? move(wire, memory, MIP_NUMBERS(kind, 0), count, writing) : wire;
}

MIP_QUICK void move_all(const uint8_t *program, uint8_t *wire, uint8_t *value, bool writing) {
    for (unsigned step = *program; step != MIP_END; step = *program) {
        wire = move(wire, value + program[1], step, step & 31, writing);
        program += 2;
    }
}

#endif

#if defined(MIP_PARSER_FAST) && !defined(__OPTIMIZE_SIZE__)
/* Frequent layouts are read and written without a loop: two to four numbers of this many bits at an
 * offset, and the gap at the end of the structure. */
#define MOVE_2(bits, at) \
    MOVE_1(bits, at);    \
    MOVE_1(bits, (at) + (bits) / 8)
#define MOVE_3(bits, at) \
    MOVE_2(bits, at);    \
    MOVE_1(bits, (at) + (bits) / 4)
#define MOVE_4(bits, at) \
    MOVE_2(bits, at);    \
    MOVE_2(bits, (at) + (bits) / 4)
#define CLEAR_END() memset(memory + codec->size - 8, 0, writing ? 0 : 8)

/** Reads or writes a layout of one of the most frequent shapes. Returns false if it has another. */
MIP_QUICK bool move_shape(const struct mip_codec *codec, uint8_t *wire, uint8_t *memory,
                          bool writing) {
    switch (sizeof(double) == 8 ? codec->shape : 0) {
    case MIP_SHAPE(0, 1, 0):
        MOVE_1(32, 0);
        return true;
    case MIP_SHAPE(0, 3, 0):
        MOVE_3(32, 0);
        return true;
    case MIP_SHAPE(0, 3, 1):
        CLEAR_END();
        MOVE_3(32, 0);
        MOVE_1(16, 12);
        return true;
    case MIP_SHAPE(0, 4, 1):
        CLEAR_END();
        MOVE_4(32, 0);
        MOVE_1(16, 16);
        return true;
    case MIP_SHAPE(1, 0, 0):
        MOVE_1(64, 0);
        return true;
    case MIP_SHAPE(1, 0, 1):
        CLEAR_END();
        MOVE_1(64, 0);
        MOVE_1(16, 8);
        return true;
    case MIP_SHAPE(1, 0, 2):
        CLEAR_END();
        MOVE_1(64, 0);
        MOVE_2(16, 8);
        return true;
    case MIP_SHAPE(3, 0, 1):
        CLEAR_END();
        MOVE_3(64, 0);
        MOVE_1(16, 24);
        return true;
    case MIP_SHAPE(0, 0, 3):
        MOVE_3(16, 0);
        return true;
    default:
        return false;
    }
}
#else
/** Returns false: no layout has its own code. */
static inline bool move_shape(const struct mip_codec *codec, const uint8_t *wire,
                              const uint8_t *memory, bool writing) {
    (void)codec, (void)wire, (void)memory, (void)writing;
    return false;
}
#endif

bool mip_codec_belongs(const struct mip_codec *codec, uint8_t descriptor_set) {
    if (mip_set_has(descriptor_set, codec->descriptor_set)) {
        return true;
    }
    for (size_t i = codec->more_sets; i > 0; i--) {
        if (*(codec->program - i) == descriptor_set) {
            return true;
        }
    }
    return false;
}

bool mip_codec_matches(const struct mip_codec *codec, const struct mip_field *field) {
    const struct mip_interpreter *interpreter = codec->interpreter;
    if (interpreter == NULL || interpreter->matches == NULL) {
        return true;
    }
    return interpreter->matches(codec, field);
}

/** Checks that a field is of this type. */
MIP_APART mip_error check(const struct mip_field *field, const struct mip_codec *codec) {
    return field->descriptor != codec->descriptor             ? MIP_ERROR_DESCRIPTOR
           : !mip_codec_belongs(codec, field->descriptor_set) ? MIP_ERROR_SET
           : !mip_codec_matches(codec, field)                 ? MIP_ERROR_LAYOUT
           : codec->numbers > field->size                     ? MIP_ERROR_TRUNCATED
                                                              : MIP_OK;
}

bool mip_field_is(const struct mip_field *field, const struct mip_codec *codec) {
    return SMALL ? check(field, codec) < MIP_ERROR_SET /* of any size */
                 : field->descriptor == codec->descriptor &&
                       mip_codec_belongs(codec, field->descriptor_set) &&
                       mip_codec_matches(codec, field);
}

/** Decodes most fields, without a call. Returns false for others; then nothing has changed. */
MIP_QUICK bool decode_shape(const struct mip_codec *codec, void *value,
                            const struct mip_field *field) {
    uint8_t *data = (uint8_t *)(uintptr_t)field->data; /* it is only read */
    return mip_set_has(field->descriptor_set, codec->descriptor_set) &&
           field->size >= codec->numbers && move_shape(codec, data, (uint8_t *)value, false);
}

mip_error mip_decode(const struct mip_codec *codec, void *value, const struct mip_field *field,
                     size_t *trailing) {
    if (!SMALL && trailing == NULL && field->descriptor == codec->descriptor) {
        return mip_decode_same(codec, value, field);
    }
    const mip_error error = check(field, codec);
    size_t left = field->size;
    if (SMALL || error != MIP_OK || codec->size != codec->numbers) { /* gaps between members, too */
        memset(value, 0, codec->size);
    }
    if (error == MIP_OK) {
        if (codec->interpreter != NULL) {
            return codec->interpreter->read(codec, value, field, trailing);
        }
        /* The field is only read. */
        move_all(codec->program, (uint8_t *)(uintptr_t)field->data, (uint8_t *)value, false);
        left -= codec->numbers;
    }
    if (trailing != NULL) {
        *trailing = left;
    }
    return error;
}

mip_error mip_decode_same(const struct mip_codec *codec, void *value,
                          const struct mip_field *field) {
    size_t trailing; /* not used */
    return decode_shape(codec, value, field) ? MIP_OK : mip_decode(codec, value, field, &trailing);
}

mip_error mip_encode(const struct mip_codec *codec, const void *value,
                     struct mip_builder *builder) {
    const size_t start = builder->length + 2;
    size_t size = codec->numbers;
    uint8_t *data;
    MIP_ASSERT(value != NULL || (codec->interpreter == NULL && size == 0));
    if (start + size + MIP_CHECKSUM_SIZE > builder->capacity) {
        return mip_builder_note(builder, MIP_ERROR_LENGTH);
    }
    data = builder->buffer + start;
    if (!mip_codec_belongs(codec, builder->buffer[2])) {
        return mip_builder_note(builder, MIP_ERROR_SET);
    }
    if (codec->interpreter == NULL) {
        uint8_t *memory = (uint8_t *)(uintptr_t)value; /* it is only read */
        if (!move_shape(codec, data, memory, true)) {
            move_all(codec->program, data, memory, true);
        }
    } else {
        const size_t room = builder->capacity - MIP_CHECKSUM_SIZE - start;
        const mip_error error = codec->interpreter->write(codec, value, data, room, &size);
        if (error != MIP_OK) {
            return mip_builder_note(builder, error);
        }
    }
    return mip_builder_reserve(builder, builder->buffer[2], codec->descriptor, size, &data);
}
