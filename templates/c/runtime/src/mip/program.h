/**
 * @file
 * The programs that describe layouts: what generated sources contain and codec.c runs.
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

/** The place of a member, in a program all of whose places are below 256, and in another. */
#define MIP_AT(type, member) offsetof(type, member)
#define MIP_FAR_AT(type, member) offsetof(type, member) >> 8, offsetof(type, member) & 0xFF

/** Numbers of one kind: 1 to 31 of them, or 0 if their count follows. */
#define MIP_NUMBERS(kind, count) ((kind) << 5 | (count))
#define MIP_8_BITS(count, place) MIP_NUMBERS(1, count), place
#define MIP_16_BITS(count, place) MIP_NUMBERS(2, count), place
#define MIP_32_BITS(count, place) MIP_NUMBERS(3, count), place
#define MIP_64_BITS(count, place) MIP_NUMBERS(4, count), place
#define MIP_DOUBLES(count, place) MIP_NUMBERS(5, count), place

/** More than 31 numbers: MIP_8_BITS(0, MIP_MANY(200, place)). */
#define MIP_MANY(count, place) count, place

/** What the other steps begin with. */
enum {
    MIP_STEP_END,
    MIP_STEP_FAR,
    MIP_STEP_LAYOUT,
    MIP_STEP_OPTIONAL,
    MIP_STEP_GROUP,
    MIP_STEP_CONSTANT,
    MIP_STEP_COUNTED,
    MIP_STEP_REST,
    MIP_STEP_EACH,
    MIP_STEP_SWITCH
};

/** The end of a program, or of a part of it. */
#define MIP_END MIP_STEP_END
/** All places of the program have two bytes. Before any other step but MIP_LAYOUT. */
#define MIP_FAR MIP_STEP_FAR
/** The sizes that the layout may have, the number of bytes that tell it from the other layouts of
 * its descriptor, and of each such byte, where it is in the data, and its value. First of all. */
#define MIP_SIZES(shortest, longest) MIP_STEP_LAYOUT, shortest, longest, 0
#define MIP_LAYOUT(shortest, longest, bytes, ...) \
    MIP_STEP_LAYOUT, shortest, longest, bytes, __VA_ARGS__
/** The structure begins with the number of present parameters. With functions, the function
 * selector follows; the step has the number of functions, and how many parameters each requires, by
 * its value. */
#define MIP_OPTIONAL MIP_STEP_OPTIONAL, 0
#define MIP_REQUIRED(functions, ...) MIP_STEP_OPTIONAL, functions, __VA_ARGS__
/** The following parameters, numbers `first` to `last`, are present together or not at all. */
#define MIP_GROUP(first, last) MIP_STEP_GROUP, first, last
/** Bytes that are always the same. */
#define MIP_CONSTANT(size, ...) MIP_STEP_CONSTANT, size, __VA_ARGS__
/** The next step is taken as often as a member of `size` bytes says, and at most `capacity` times;
 * each time it takes `wire` bytes of the field. */
#define MIP_COUNTED(size, capacity, wire, place) MIP_STEP_COUNTED, size, capacity, wire, place
/** The next step is taken until the field ends; a member of one byte says how often. */
#define MIP_REST(capacity, wire, place) MIP_STEP_REST, 1, capacity, wire, place
/** Structures of a type. Their program follows, which has `length` bytes. */
#define MIP_EACH(count, type, length, place) \
    MIP_STEP_EACH, count, sizeof(type) >> 8, sizeof(type) & 0xFF, length, place
/** A member of `size` bytes says which of the cases is there. They follow. */
#define MIP_SWITCH(size, cases, place) MIP_STEP_SWITCH, size, cases, place
/** The bytes of the value that selects a case. Its program follows, which has `length` bytes. */
#define MIP_CASE(length, ...) __VA_ARGS__, length

/** Runs the program of a codec to decode a field, and counts the bytes behind its last parameter.
 */
mip_error mip_program_read(const struct mip_codec *codec, void *value,
                           const struct mip_field *field, size_t *trailing);

/** Runs the program of a codec to encode a field into `room` bytes, and counts those it has used.
 */
mip_error mip_program_write(const struct mip_codec *codec, const void *value, uint8_t *data,
                            size_t room, size_t *size);

#ifdef __cplusplus
}
#endif

#endif
