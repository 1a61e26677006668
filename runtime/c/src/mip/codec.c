/* Decodes and encodes fields. */
#include "mip/program.h"

#include <string.h>

/* What the programs and the types of members rely on. */
#define ASSERT(name, condition) typedef char assert_##name[(condition) ? 1 : -1]
ASSERT(bytes_have_eight_bits, (unsigned char)-1 == 255);
ASSERT(floats_have_four_bytes, sizeof(float) == 4);
ASSERT(doubles_have_eight_bytes_or_four, sizeof(double) == 8 || sizeof(double) == 4);

/* Layouts that are only numbers, as most are, need no interpreter, unless size matters more than
 * speed or doubles differ from those on the wire. */
#ifdef __OPTIMIZE_SIZE__
#define QUICK false
#else
#define QUICK (sizeof(double) == 8)
#endif

/** Reads numbers up to the end of the program. */
static void read_all(const uint8_t *wire, const uint8_t *program, uint8_t *value) {
    for (unsigned step = *program; step != MIP_END; step = *program) {
        uint8_t *memory = value + program[1];
        size_t count = step & 31;
        program += 2;
        if (step < MIP_NUMBERS(2, 0)) {
            do {
                *memory++ = *wire++;
            } while (--count > 0);
        } else if (step < MIP_NUMBERS(3, 0)) {
            do {
                const uint16_t number = mip_get_16(wire);
                memcpy(memory, &number, sizeof(number));
                wire += sizeof(number);
                memory += sizeof(number);
            } while (--count > 0);
        } else if (step < MIP_NUMBERS(4, 0)) {
            do {
                const uint32_t number = mip_get_32(wire);
                memcpy(memory, &number, sizeof(number));
                wire += sizeof(number);
                memory += sizeof(number);
            } while (--count > 0);
        } else {
            do {
                const uint64_t number = mip_get_64(wire);
                memcpy(memory, &number, sizeof(number));
                wire += sizeof(number);
                memory += sizeof(number);
            } while (--count > 0);
        }
    }
}

/** Writes numbers up to the end of the program. */
static void write_all(uint8_t *wire, const uint8_t *program, const uint8_t *value) {
    for (unsigned step = *program; step != MIP_END; step = *program) {
        const uint8_t *memory = value + program[1];
        size_t count = step & 31;
        program += 2;
        if (step < MIP_NUMBERS(2, 0)) {
            do {
                *wire++ = *memory++;
            } while (--count > 0);
        } else if (step < MIP_NUMBERS(3, 0)) {
            do {
                uint16_t number;
                memcpy(&number, memory, sizeof(number));
                mip_put_16(wire, number);
                wire += sizeof(number);
                memory += sizeof(number);
            } while (--count > 0);
        } else if (step < MIP_NUMBERS(4, 0)) {
            do {
                uint32_t number;
                memcpy(&number, memory, sizeof(number));
                mip_put_32(wire, number);
                wire += sizeof(number);
                memory += sizeof(number);
            } while (--count > 0);
        } else {
            do {
                uint64_t number;
                memcpy(&number, memory, sizeof(number));
                mip_put_64(wire, number);
                wire += sizeof(number);
                memory += sizeof(number);
            } while (--count > 0);
        }
    }
}

bool mip_codec_belongs(const struct mip_codec *codec, uint8_t descriptor_set) {
    const uint8_t *set = codec->program;
    size_t left = codec->more_sets;
    bool found = mip_set_has(descriptor_set, codec->descriptor_set);
    for (; !found && left > 0; left--) {
        found = *--set == descriptor_set;
    }
    return found;
}

bool mip_codec_matches(const struct mip_codec *codec, const struct mip_field *field) {
    const uint8_t *p = codec->program;
    if (p[0] != MIP_STEP_LAYOUT) {
        return true;
    }
    if (field->size < p[1] || field->size > p[2]) {
        return false;
    }
    for (size_t left = p[3]; left > 0; left--) { /* places in the data, and the bytes there */
        p += 2;
        if (p[2] < field->size && field->data[p[2]] != p[3]) {
            return false;
        }
    }
    return true;
}

bool mip_field_is(const struct mip_field *field, const struct mip_codec *codec) {
    return field->descriptor == codec->descriptor &&
           mip_codec_belongs(codec, field->descriptor_set) && mip_codec_matches(codec, field);
}

mip_error mip_decode(const struct mip_codec *codec, void *value, const struct mip_field *field,
                     size_t *trailing) {
    mip_error error = mip_codec_belongs(codec, field->descriptor_set)
                          ? mip_field_check(field, field->descriptor_set, codec->descriptor,
                                            QUICK ? codec->numbers : 0)
                          : MIP_ERROR_SET;
    if (QUICK && codec->numbers > 0 && error == MIP_OK) {
        if (codec->size != codec->numbers) { /* gaps between members are zeroed, too */
            memset(value, 0, codec->size);
        }
        read_all(field->data, codec->program, (uint8_t *)value);
        if (trailing != NULL) {
            *trailing = (size_t)field->size - codec->numbers;
        }
        return MIP_OK;
    }
    if (error == MIP_OK || error == MIP_ERROR_TRUNCATED) {
        if (mip_codec_matches(codec, field)) {
            return mip_program_read(codec, value, field, trailing);
        }
        error = MIP_ERROR_LAYOUT;
    }
    memset(value, 0, codec->size);
    if (trailing != NULL) {
        *trailing = field->size;
    }
    return error;
}

mip_error mip_encode(const struct mip_codec *codec, const void *value,
                     struct mip_builder *builder) {
    const size_t start = builder->length + 2;
    size_t size = codec->numbers;
    uint8_t *data;
    if (start + MIP_CHECKSUM_SIZE > builder->capacity) {
        return MIP_ERROR_LENGTH;
    }
    if (!mip_codec_belongs(codec, builder->buffer[2])) {
        return MIP_ERROR_SET;
    }
    if (!QUICK || size == 0) {
        const size_t room = builder->capacity - MIP_CHECKSUM_SIZE - start;
        const mip_error error =
            mip_program_write(codec, value, builder->buffer + start, room, &size);
        if (error != MIP_OK) {
            return error;
        }
    }
    const mip_error error =
        mip_builder_reserve(builder, builder->buffer[2], codec->descriptor, size, &data);
    if (QUICK && error == MIP_OK && codec->numbers > 0) {
        write_all(data, codec->program, (const uint8_t *)value);
    }
    return error;
}
