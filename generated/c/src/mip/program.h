/**
 * @file
 * The programs in generated sources that describe layouts. Those of numbers only are run by
 * codec.c, the others by program.c.
 *
 * A program is a row of steps in wire order, up to MIP_END. A step for numbers is one byte, kind
 * and count, and the place of the first one in the structure; the others follow it without a gap.
 */
#ifndef MIP_PROGRAM_H
#define MIP_PROGRAM_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The bytes of a member. */
#define MIP_SIZE(type, member) sizeof(((type *)0)->member)

/** The place of a member, in a program whose places are all below 256. */
#define MIP_AT(type, member) offsetof(type, member)
/** The place of a member, in another program. */
#define MIP_FAR_AT(type, member) offsetof(type, member) >> 8, offsetof(type, member) & 0xFF

/** Numbers of one kind: 1 to 31 of them, or 0 if their count follows. */
#define MIP_NUMBERS(kind, count) ((kind) << 5 | (count))
/** The kinds. Their last two bits are the size of a number: 1, 2, 4 or 8 bytes. Doubles are a kind
 * of their own, which some compilers do not have. */
#define MIP_KIND_DOUBLE 3
/** One byte. */
#define MIP_KIND_8 4
/** Two bytes. */
#define MIP_KIND_16 5
/** Four bytes. */
#define MIP_KIND_32 6
/** Eight bytes. */
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

/** The counts of numbers of 64, 32 and 16 bits in a layout, at most 4, 9 and 4, as one number below
 * 256. */
#define MIP_SHAPE(longs, words, halves) ((longs) * 50 + (words) * 5 + (halves))

/** The first bytes of the other steps. */
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

/** The descriptor sets of a field besides its first one. They are right before the program. */
#define MIP_MORE_SETS(...) __VA_ARGS__

/** The end of a program, or of a part of it. */
#define MIP_END MIP_STEP_END
/** All places of the program have two bytes. Before any other step but MIP_LAYOUT. */
#define MIP_FAR MIP_STEP_FAR
/** The sizes that the layout may have, if they distinguish it from the others of its descriptor.
 * The first step. */
#define MIP_SIZES(shortest, longest) MIP_STEP_LAYOUT, shortest, longest, 0
/** The same, with the number of bytes that distinguish it from the others, and for each such
 * byte its place in the data and its value. */
#define MIP_LAYOUT(shortest, longest, bytes, ...) \
    MIP_STEP_LAYOUT, shortest, longest, bytes, __VA_ARGS__
/** The structure begins with the number of present parameters; those up to `last` always are. */
#define MIP_OPTIONAL(last) MIP_STEP_OPTIONAL, 0, last
/** The same, and the function selector follows: the number of functions, and how many parameters
 * each requires, from function 1 on. */
#define MIP_REQUIRED(functions, ...) MIP_STEP_OPTIONAL, functions, __VA_ARGS__
/** The next 1 to 16 parameters are present together or not at all. */
#define MIP_GROUP(count) MIP_STEP_GROUP + (count)
/** The same for more of them. */
#define MIP_LARGE_GROUP(count) MIP_STEP_GROUP, count
/** The parameters of the group that begins may have values even if they are left out: constructors
 * fill in what is reserved. */
#define MIP_RESERVED MIP_STEP_RESERVED
/** Bytes that are always the same. */
#define MIP_CONSTANT(size, ...) MIP_STEP_CONSTANT, size, __VA_ARGS__
/** The next step is repeated as often as a member of `size` bytes states, at most `capacity`
 * times; each time it takes `wire` bytes of the field. */
#define MIP_COUNTED(size, capacity, wire, place) MIP_STEP_COUNTED, size, capacity, wire, place
/** The next step is repeated until the field ends; a member of one byte is the number of times. */
#define MIP_REST(capacity, wire, place) MIP_STEP_REST, 1, capacity, wire, place
/** Structures of a type. Their program follows, which has `length` bytes. */
#define MIP_EACH(count, type, length, place) \
    MIP_STEP_EACH, count, sizeof(type) >> 8, sizeof(type) & 0xFF, length, place
/** A member of `size` bytes selects the case that is present. They follow. */
#define MIP_SWITCH(size, cases, place) MIP_STEP_SWITCH, size, cases, place
/** The bytes of the value that selects a case. Its program follows, which has `length` bytes. */
#define MIP_CASE(length, ...) __VA_ARGS__, length

/** Reads or writes numbers of one kind, and returns the end of what it has read or written. */
uint8_t *mip_move(uint8_t *wire, uint8_t *memory, unsigned kind, size_t count, bool writing);

/** Runs programs that are more than numbers. Only their codecs refer to one, so that a program
 * without such fields does not link it. */
struct mip_interpreter {
    /** Does the data have this layout? NULL if its descriptor has no other. */
    bool (*matches)(const struct mip_codec *codec, const struct mip_field *field);
    /** Decodes a field, and counts the bytes after its last parameter. */
    mip_error (*read)(const struct mip_codec *codec, void *value, const struct mip_field *field,
                      size_t *trailing);
    /** Encodes a field into `room` bytes, and counts those that it has used. */
    mip_error (*write)(const struct mip_codec *codec, const void *value, uint8_t *data, size_t room,
                       size_t *size);
};

/** For the only layout of a descriptor. */
extern const struct mip_interpreter mip_program;
/** For one of several, which begins with MIP_SIZES or MIP_LAYOUT. */
extern const struct mip_interpreter mip_layout;

#ifdef __cplusplus
}
#endif

#endif
