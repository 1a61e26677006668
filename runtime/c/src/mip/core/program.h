/**
 * @file
 * The programs in generated sources that describe layouts. codec.c runs programs of only numbers,
 * and program.c all others.
 *
 * A program is a sequence of steps in wire order, up to MIP_END. A step for numbers is one byte
 * with their kind and count, then the offset of the first one in the structure; the others follow
 * it without gaps.
 */
#ifndef MIP_PROGRAM_H
#define MIP_PROGRAM_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Defines the codec of a field. The values are in the order of struct mip_codec. */
#define MIP_CODEC(name, set, descriptor, role, numbers, sets, shape, program, interpreter) \
    const struct mip_codec name##_codec = {                                                \
        set, descriptor, role, numbers, sizeof(struct name), sets, shape, program, interpreter}

/** Defines how a command is answered, and the command. The values are in the order of struct
 * mip_exchange and struct mip_command. */
#define MIP_EXCHANGE(name, set, descriptor, quarters, count, responses, functions)             \
    const struct mip_exchange name##_exchange = {set, descriptor, quarters, count, responses}; \
    const struct mip_command name##_command = {&name##_codec, &name##_exchange, functions}

/** The size of a member in bytes. */
#define MIP_SIZE(type, member) sizeof(((type *)0)->member)

/** The offset of a member, in a program whose offsets are all below 256. */
#define MIP_AT(type, member) offsetof(type, member)
/** The offset of a member, in a program that begins with MIP_FAR. */
#define MIP_FAR_AT(type, member) offsetof(type, member) >> 8, offsetof(type, member) & 0xFF

/** A step for numbers of one kind: 1 to 31 of them, or 0 if their count is the next byte. */
#define MIP_NUMBERS(kind, count) ((kind) << 5 | (count))
/** The kind of doubles, which is separate because some compilers have no eight-byte doubles. The
 * last two bits of each kind encode the size of a number: 1, 2, 4 or 8 bytes. */
#define MIP_KIND_DOUBLE 3
/** The kind of one-byte numbers. */
#define MIP_KIND_8 4
/** The kind of two-byte numbers. */
#define MIP_KIND_16 5
/** The kind of four-byte numbers. */
#define MIP_KIND_32 6
/** The kind of eight-byte numbers. */
#define MIP_KIND_64 7

/** Doubles. */
#define MIP_DOUBLES(count, place) MIP_NUMBERS(MIP_KIND_DOUBLE, count), place
/** Numbers of 8 bits. */
#define MIP_8_BITS(count, place) MIP_NUMBERS(MIP_KIND_8, count), place
/** Numbers of 16 bits. */
#define MIP_16_BITS(count, place) MIP_NUMBERS(MIP_KIND_16, count), place
/** Numbers of 32 bits. */
#define MIP_32_BITS(count, place) MIP_NUMBERS(MIP_KIND_32, count), place
/** Numbers of 64 bits. */
#define MIP_64_BITS(count, place) MIP_NUMBERS(MIP_KIND_64, count), place

/** More than 31 numbers: MIP_8_BITS(0, MIP_MANY(200, place)). */
#define MIP_MANY(count, place) count, place

/** Combines the counts of 64-, 32- and 16-bit numbers in a layout, at most 4, 9 and 4, in one
 * number below 256. */
#define MIP_SHAPE(longs, words, halves) ((longs) * 50 + (words) * 5 + (halves))

/** The first bytes of all other steps. */
enum {
    /** MIP_END. */
    MIP_STEP_END,
    /** MIP_FAR. */
    MIP_STEP_FAR,
    /** MIP_SIZES and MIP_LAYOUT. */
    MIP_STEP_LAYOUT,
    /** MIP_OPTIONAL and MIP_REQUIRED. */
    MIP_STEP_OPTIONAL,
    /** MIP_CONSTANT. */
    MIP_STEP_CONSTANT,
    /** MIP_COUNTED. */
    MIP_STEP_COUNTED,
    /** MIP_REST. */
    MIP_STEP_REST,
    /** MIP_EACH. */
    MIP_STEP_EACH,
    /** MIP_SWITCH. */
    MIP_STEP_SWITCH,
    /** MIP_RESERVED. */
    MIP_STEP_RESERVED,
    /** MIP_GROUP. */
    MIP_STEP_GROUP
};

/** The descriptor sets of a field except the first one. They are placed right before the program.
 */
#define MIP_MORE_SETS(...) __VA_ARGS__

/** Ends a program, or a part of it. */
#define MIP_END MIP_STEP_END
/** All offsets in the program have two bytes. This precedes every other step except MIP_LAYOUT. */
#define MIP_FAR MIP_STEP_FAR
/** The smallest and largest size of the layout, if they distinguish it from the descriptor's other
 * layouts. This is the first step. */
#define MIP_SIZES(shortest, longest) MIP_STEP_LAYOUT, shortest, longest, 0
/** Like MIP_SIZES, with the number of bytes that distinguish the layout from others, and for each
 * such byte its offset in the data and its value. */
#define MIP_LAYOUT(shortest, longest, bytes, ...) \
    MIP_STEP_LAYOUT, shortest, longest, bytes, __VA_ARGS__
/** The structure begins with the number of present parameters. Those up to `last` are always
 * present. */
#define MIP_OPTIONAL(last) MIP_STEP_OPTIONAL, 0, last
/** Like MIP_OPTIONAL, for a command whose function selector comes next: the number of functions,
 * and how many parameters each requires, from function 1 on. */
#define MIP_REQUIRED(functions, ...) MIP_STEP_OPTIONAL, functions, __VA_ARGS__
/** The next 1 to 16 parameters are present together or not at all. */
#define MIP_GROUP(count) MIP_STEP_GROUP + (count)
/** Like MIP_GROUP, for more than 16 parameters. */
#define MIP_LARGE_GROUP(count) MIP_STEP_GROUP, count
/** The parameters of the group that begins here may have values even if the group is absent,
 * because constructors set reserved parameters. */
#define MIP_RESERVED MIP_STEP_RESERVED
/** A constant: bytes that are always the same. */
#define MIP_CONSTANT(size, ...) MIP_STEP_CONSTANT, size, __VA_ARGS__
/** Repeats the next step as often as a member of `size` bytes states, at most `capacity` times;
 * each time it uses `wire` bytes of the field. */
#define MIP_COUNTED(size, capacity, wire, place) MIP_STEP_COUNTED, size, capacity, wire, place
/** Repeats the next step until the field ends; a member of one byte is the number of repetitions.
 */
#define MIP_REST(capacity, wire, place) MIP_STEP_REST, 1, capacity, wire, place
/** Structures of one type: `count` of them. The next `length` bytes are their program. */
#define MIP_EACH(count, type, length, place) \
    MIP_STEP_EACH, count, sizeof(type) >> 8, sizeof(type) & 0xFF, length, place
/** A union: a member of `size` bytes selects one of the `cases` that follow. */
#define MIP_SWITCH(size, cases, place) MIP_STEP_SWITCH, size, cases, place
/** A case of a union: the bytes of the value that selects it. The next `length` bytes are its
 * program. */
#define MIP_CASE(length, ...) __VA_ARGS__, length

/** Reads or writes numbers of one kind, and returns the end of the bytes read or written. */
uint8_t *mip_move(uint8_t *wire, uint8_t *memory, unsigned kind, size_t count, bool writing);

/** Runs programs that contain more than numbers. Only codecs with such programs refer to it, so
 * that applications without such fields do not link it. */
struct mip_interpreter {
    /** Does the data have this layout? NULL if it is the descriptor's only layout. */
    bool (*matches)(const struct mip_codec *codec, const struct mip_field *field);
    /** Decodes a field, and counts the bytes after its last parameter. */
    mip_error (*read)(const struct mip_codec *codec, void *value, const struct mip_field *field,
                      size_t *trailing);
    /** Encodes a field into `room` bytes, and counts the bytes used. */
    mip_error (*write)(const struct mip_codec *codec, const void *value, uint8_t *data, size_t room,
                       size_t *size);
};

/** The interpreter for a descriptor's only layout. */
extern const struct mip_interpreter mip_program;
/** The interpreter for one of several layouts, whose program begins with MIP_SIZES or MIP_LAYOUT.
 */
extern const struct mip_interpreter mip_layout;

#ifdef __cplusplus
}
#endif

#endif
