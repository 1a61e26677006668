/**
 * @file
 * Reflection of fields, for generic tools. It links all types of all sets, so small programs should
 * not use it.
 */
#ifndef MIP_REFLECT_H
#define MIP_REFLECT_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Kinds of a parameter. */

/** One number, or an array of them. */
#define MIP_KIND_NUMBER 0
/** A number that is always the same and has no member. */
#define MIP_KIND_CONSTANT 1
/** The number of elements of a later parameter. */
#define MIP_KIND_COUNTER 2
/** Characters; the member has one more for the NUL. */
#define MIP_KIND_TEXT 3
/** A bitfield in bytes, least significant byte first. */
#define MIP_KIND_BITS 4
/** A structure, or an array of them. */
#define MIP_KIND_STRUCT 5
/** One member, selected by an earlier parameter. */
#define MIP_KIND_UNION 6

/* Scalars. */

/** Unsigned, 8 bits. */
#define MIP_SCALAR_U8 0
/** Unsigned, 16 bits. */
#define MIP_SCALAR_U16 1
/** Unsigned, 32 bits. */
#define MIP_SCALAR_U32 2
/** Unsigned, 64 bits. */
#define MIP_SCALAR_U64 3
/** Signed, 8 bits. */
#define MIP_SCALAR_S8 4
/** Signed, 16 bits. */
#define MIP_SCALAR_S16 5
/** Signed, 32 bits. */
#define MIP_SCALAR_S32 6
/** Signed, 64 bits. */
#define MIP_SCALAR_S64 7
/** A float. */
#define MIP_SCALAR_FLOAT 8
/** A double. */
#define MIP_SCALAR_DOUBLE 9
/** A mip_bool. */
#define MIP_SCALAR_BOOL 10
/** A character. */
#define MIP_SCALAR_CHAR 11

/* The number of items of a parameter. */

/** Not an array. */
#define MIP_LENGTH_ONE 0
/** Always `capacity`. */
#define MIP_LENGTH_FIXED 1
/** As many as the parameter `by` states. */
#define MIP_LENGTH_COUNTED 2
/** As many as the rest of the field contains. */
#define MIP_LENGTH_REST 3

struct mip_names;

/** One flag, or one number, inside a bitfield. */
struct mip_named_bits {
    /** Its least significant bit, from 0. */
    uint8_t first;
    /** The number of bits; 1 for a flag. */
    uint8_t width;
    /** The values of the parameter `by`, below 16, while which it means something, as bits: 1 <<
     * value. 0 if it always does. */
    uint16_t states;
    /** The enumeration of the number, or NULL. */
    const struct mip_names *names;
};

/** An enumeration or a bitfield; the tables of the other kind are NULL. */
struct mip_names {
    /** Name in the specification, prefixed with its set and a period if a set owns it. */
    const char *name;
    /** The names of its values or bits, each followed by a NUL: see mip_names_label. */
    const char *labels;
    /** The values of an enumeration, as unsigned numbers of `size` bytes. See mip_names_number. */
    const void *numbers;
    /** The flags and numbers of a bitfield. */
    const struct mip_named_bits *bits;
    /** The number of values or bits. */
    uint16_t count;
    /** The size of the number in bytes. */
    uint8_t size;
};

/** The type that defines the meaning of a number, if it depends on the device or a parameter. */
struct mip_reading {
    /** Id of the device; NULL if it depends on the parameter `by`. */
    const char *device;
    /** The index of the parameter that it depends on. */
    uint8_t by;
    /** The value of that parameter. */
    uint64_t value;
    /** The type. */
    const struct mip_names *names;
};

struct mip_record;
struct mip_case;

/** One value of a field or of a structure, in wire order. */
struct mip_parameter {
    /** Name in the specification. */
    const char *name;
    /** Its unit: "m/s"; if elements differ, one for each: "deg, deg, m"; empty if there is none. */
    const char *unit;
    /** A MIP_KIND_... value. */
    uint8_t kind;
    /** A MIP_SCALAR_... value; for numbers, constants and counters. */
    uint8_t scalar;
    /** A MIP_LENGTH_... value. */
    uint8_t length;
    /** Maximum number of items of the member, without the NUL of a text. */
    uint8_t capacity;
    /** Numbers in one item: 3 for a vector with x, y and z; 1 if the item is not a vector. */
    uint8_t elements;
    /** Index of the parameter that counts or selects, or is the state on which the meaning of bits
     * depends; for a counter, of the array that it counts. */
    uint8_t by;
    /** The number of parameters that are present if this one is, without the function selector; 0
     * if it is always present. */
    uint8_t group;
    /** The value of a constant. */
    uint64_t value;
    /** Offset of the member in its structure. */
    uint16_t offset;
    /** Size of one item in memory. */
    uint16_t item_size;
    /** If `length` is MIP_LENGTH_REST: offset of the member with the number of items, a uint8_t. */
    uint16_t count_offset;
    /** For numbers and bits: the type that names them, or NULL. */
    const struct mip_names *names;
    /** For numbers whose type depends on the device or a parameter: the possible types. Else NULL.
     */
    const struct mip_reading *readings;
    /** For structures: their parameters. */
    const struct mip_record *record;
    /** For unions: their alternatives. */
    const struct mip_case *cases;
    /** Elements of `readings` or of `cases`. */
    uint16_t count;
};

/** One alternative of a union; `parameter` is NULL if it is empty. */
struct mip_case {
    /** The value that selects it. */
    uint64_t value;
    /** The selected member of the union. */
    const struct mip_parameter *parameter;
};

/** The parameters of a field or of a structure. */
struct mip_record {
    /** In wire order; NULL if there are none. */
    const struct mip_parameter *parameters;
    /** Elements of `parameters`. */
    uint8_t count;
    /** Size of the structure. */
    uint16_t size;
};

/** The reflection of a field. */
struct mip_reflection {
    /** The wire format of the field. */
    const struct mip_codec *codec;
    /** Its parameters. */
    const struct mip_record *record;
    /** Does the field begin with a function selector? */
    bool selector;
    /** May parameters be absent? */
    bool optional;
    /** Number of required parameters, by function selector. */
    const uint8_t *required;
    /** Elements of `required`. */
    uint8_t required_size;
    /** Offset of the member `present`, if parameters may be absent. */
    uint16_t present_offset;
};

/** Memory for the structure of any field: mip_decode(entry->codec, &value, &field, NULL). */
union mip_any_value {
    /** The structure. */
    uint8_t bytes[MIP_MAX_VALUE_SIZE];
    /** Only for the alignment. */
    uint64_t whole;
    /** Only for the alignment. */
    double real;
};

/** All fields. */
extern MIP_API const struct mip_reflection mip_reflections[];
/** The number of all fields. */
extern MIP_API const size_t mip_reflection_count;

/** Returns the reflection of a field; NULL if the codec does not belong to this binding. */
MIP_API const struct mip_reflection *mip_reflect(const struct mip_codec *codec);

/** Returns the name of a value or a bit, by its index. */
MIP_API const char *mip_names_label(const struct mip_names *names, size_t index);

/** Returns the number of a value of an enumeration, by its index; 0 for a bitfield. */
MIP_API uint64_t mip_names_number(const struct mip_names *names, size_t index);

/** Returns the name of a value of an enumeration; NULL if it has none. */
MIP_API const char *mip_value_name(const struct mip_names *names, uint64_t value);

/** Defines `mip_..._name(value)`, which returns the name of a value of an enumeration, or NULL. */
#define MIP_VALUE_NAME(type, names)                         \
    static inline const char *type##_name(uint64_t value) { \
        return mip_value_name(&names, value);               \
    }                                                       \
    struct mip_names

#ifdef __cplusplus
}
#endif

#endif
