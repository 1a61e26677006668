/**
 * @file
 * What fields are made of, for tools that treat all of them alike. It links all types of all sets,
 * so small programs do without it.
 */
#ifndef MIP_REFLECT_H
#define MIP_REFLECT_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Kinds of a parameter. */
#define MIP_KIND_NUMBER 0   /* one number, or an array of them */
#define MIP_KIND_CONSTANT 1 /* a number that is always the same and has no member */
#define MIP_KIND_COUNTER 2  /* the number of elements of a later parameter */
#define MIP_KIND_TEXT 3     /* characters; the member has one more for the NUL */
#define MIP_KIND_BITS 4     /* a bitfield in bytes, least significant byte first */
#define MIP_KIND_STRUCT 5   /* a structure, or an array of them */
#define MIP_KIND_UNION 6    /* the member that an earlier parameter selects */

/** Scalars. */
#define MIP_SCALAR_U8 0
#define MIP_SCALAR_U16 1
#define MIP_SCALAR_U32 2
#define MIP_SCALAR_U64 3
#define MIP_SCALAR_S8 4
#define MIP_SCALAR_S16 5
#define MIP_SCALAR_S32 6
#define MIP_SCALAR_S64 7
#define MIP_SCALAR_FLOAT 8
#define MIP_SCALAR_DOUBLE 9
#define MIP_SCALAR_BOOL 10
#define MIP_SCALAR_CHAR 11

/** How many items a parameter has. */
#define MIP_LENGTH_ONE 0     /* it is no array */
#define MIP_LENGTH_FIXED 1   /* always `capacity` */
#define MIP_LENGTH_COUNTED 2 /* as many as the parameter `by` says */
#define MIP_LENGTH_REST 3    /* as many as the field holds */

/** A value of an enumeration. */
struct mip_named_value {
    const char *name;
    uint64_t value;
};

struct mip_names;

/** One flag, or one number, inside a bitfield. */
struct mip_named_bits {
    const char *name;
    uint8_t first;
    uint8_t width;
    /** The enumeration of the number, or NULL. */
    const struct mip_names *names;
};

/** An enumeration (`values`) or a bitfield (`bits`). */
struct mip_names {
    /** Name in the specification, after its set and a full stop if a set owns it. */
    const char *name;
    const struct mip_named_value *values;
    const struct mip_named_bits *bits;
    /** Elements of `values` or of `bits`. */
    uint8_t count;
    /** Bytes of the number. */
    uint8_t size;
};

/** What gives a number its meaning where that depends on the device or on another parameter. */
struct mip_reading {
    /** Id of the device; NULL where it depends on the parameter `by`. */
    const char *device;
    /** Parameter that decides, and its value. */
    uint8_t by;
    uint64_t value;
    const struct mip_names *names;
};

struct mip_record;
struct mip_case;

/** One value of a field or of a structure, in wire order. */
struct mip_parameter {
    const char *name;
    /** "m/s"; one for each element where they differ: "deg, deg, m"; empty if there is none. */
    const char *unit;
    /** A MIP_KIND_... value. */
    uint8_t kind;
    /** A MIP_SCALAR_... value, of numbers, constants and counters. */
    uint8_t scalar;
    /** A MIP_LENGTH_... value. */
    uint8_t length;
    /** Items that the member has room for, the NUL of a text not counted. */
    uint8_t capacity;
    /** Numbers of one item: 3 of a vector with x, y and z; 1 where the item is no vector. */
    uint8_t elements;
    /** Index of the parameter that counts or selects; of a counter, the array that it counts. */
    uint8_t by;
    /** Parameters that are there if this one is, without the function selector; 0: it always is. */
    uint8_t group;
    /** Of a constant. */
    uint64_t value;
    /** Where the member begins in its structure, and bytes of one item in memory. */
    uint16_t offset;
    uint16_t item_size;
    /** Where the length is REST: the member with the number of items, a uint8_t. */
    uint16_t count_offset;
    /** Of numbers and bits: what names them, or NULL. */
    const struct mip_names *names;
    const struct mip_reading *readings;
    /** Of structures. */
    const struct mip_record *record;
    /** Of unions. */
    const struct mip_case *cases;
    /** Elements of `readings` or of `cases`. */
    uint8_t count;
};

/** One alternative of a union; `parameter` is NULL where it is empty. */
struct mip_case {
    uint64_t value;
    const struct mip_parameter *parameter;
};

/** The parameters of a field or of a structure. */
struct mip_record {
    const struct mip_parameter *parameters;
    uint8_t count;
    /** Bytes of the structure. */
    uint16_t size;
};

/** How to look into the structure of a field. */
struct mip_reflection {
    const struct mip_codec *codec;
    const struct mip_record *record;
    /** Does it begin with a function selector? May parameters be absent? */
    bool selector;
    bool optional;
    /** Parameters that must be there, by function selector. */
    const uint8_t *required;
    uint8_t required_size;
    /** Where the member `present` is, if parameters may be absent. */
    uint16_t present_offset;
};

/** All fields, but for those that repeat the field of another set. */
extern const struct mip_reflection mip_reflections[];
extern const size_t mip_reflection_count;

/** All enumerations and bitfields. */
extern const struct mip_names *const mip_all_names[];
extern const size_t mip_all_names_count;

/** How to look into a field; NULL if the codec is none of this binding. */
const struct mip_reflection *mip_reflect(const struct mip_codec *codec);

/** An enumeration or a bitfield by its name: "ack_code", "base.gps_time_field". */
const struct mip_names *mip_names_find(const char *name);

/** The name of a value of an enumeration; NULL if it has none. */
const char *mip_value_name(const struct mip_names *names, uint64_t value);

#ifdef __cplusplus
}
#endif

#endif
