/**
 * @file
 * The core of the MIP binding: packets, fields, and the stream parser.
 *
 * C99 without a heap. Of the standard library, only memcpy, memmove, memset and memchr are used.
 * Nothing depends on the host's byte order or alignment.
 */
#ifndef MIP_CORE_H
#define MIP_CORE_H

#include "mip/constants.h"
#include "mip/core/export.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes before the payload: two sync bytes, descriptor set, length of the payload. */
#define MIP_HEADER_SIZE 4
/** Bytes after the payload. */
#define MIP_CHECKSUM_SIZE 2
/** Maximum size of a packet. */
#define MIP_MAX_PACKET (MIP_HEADER_SIZE + MIP_MAX_PAYLOAD + MIP_CHECKSUM_SIZE)

/** The result of functions that can fail. */
typedef enum mip_error {
    /** No error. */
    MIP_OK = 0,
    /** The bytes do not start with the sync bytes of a packet. */
    MIP_ERROR_SYNC,
    /** A packet's size is not the length that it states, or something does not fit into a packet.
     */
    MIP_ERROR_LENGTH,
    /** The checksum of a packet does not match. */
    MIP_ERROR_CHECKSUM,
    /** A field is shorter than its own header or extends past its packet. */
    MIP_ERROR_FIELD_LENGTH,
    /** A field is too short for its parameters. */
    MIP_ERROR_TRUNCATED,
    /** A count exceeds the number of elements that follow, or the size of the array. */
    MIP_ERROR_COUNT,
    /** A constant has the wrong value. */
    MIP_ERROR_CONSTANT,
    /** `present` separates a counter from its array, or is too large, or an omitted parameter has a
     * value; or a command has no function selector. */
    MIP_ERROR_MISSING,
    /** The field does not belong in packets of this descriptor set. */
    MIP_ERROR_SET,
    /** The field's descriptor is not that of the requested type. */
    MIP_ERROR_DESCRIPTOR,
    /** The data has a different layout of the descriptor than the requested one. */
    MIP_ERROR_LAYOUT
} mip_error;

/** Returns MIP_VERSION_NUMBER of the linked library, to compare it with that of the headers. */
MIP_API unsigned long mip_version(void);

/** Returns the error as one word in lower case: "truncated"; "ok" if there is none. */
MIP_API const char *mip_error_name(mip_error error);

#ifndef __cplusplus
/** Text that only a C++ compiler sees. */
#define MIP_IN_CPP(text)
#else
#define MIP_IN_CPP(text) text
#endif

/* These follow the name of an enumeration. In C++, they set its width on the wire, so that it can
 * also hold unnamed values; in C, the compiler chooses the width. */

/** An 8-bit enumeration. */
#define MIP_ENUM_8 MIP_IN_CPP( : uint8_t)
/** A 16-bit enumeration. */
#define MIP_ENUM_16 MIP_IN_CPP( : uint16_t)
/** A 32-bit enumeration. */
#define MIP_ENUM_32 MIP_IN_CPP( : uint32_t)
/** A 64-bit enumeration. */
#define MIP_ENUM_64 MIP_IN_CPP( : uint64_t)

/** A Boolean: zero is false, anything else is true. Bytes other than 0 and 1 are preserved. */
typedef uint8_t mip_bool;

#ifdef MIP_WHOLE_ARRAYS
/** The elements of an array: all that fit into a field. */
#define MIP_ROOM(documented, fitting) (fitting)
#else
/** The elements of an array: its documented range, if that needs fewer than fit into a field. For
 * all that fit, compile the library and the program with -DMIP_WHOLE_ARRAYS. */
#define MIP_ROOM(documented, fitting) (documented)
#endif

/* --------------------------------------------------------------------------- packets and fields */

/** A complete, valid packet, anywhere in memory. */
struct mip_packet {
    /** From the first sync byte on. */
    const uint8_t *bytes;
    /** Header and checksum included. */
    size_t size;
    /** Descriptor set of its fields: MIP_SENSOR_SET, MIP_BASE_SET, ... */
    uint8_t descriptor_set;
};

/** One field of a packet, not yet decoded. */
struct mip_field {
    /** The bytes after the descriptor. */
    const uint8_t *data;
    /** Bytes of data. */
    uint8_t size;
    /** Descriptor set of the packet. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
};

/** An iterator over the fields of a packet. */
struct mip_walk {
    /** The next field. */
    const uint8_t *at;
    /** The end of the payload. */
    const uint8_t *end;
    /** Descriptor set of the packet. */
    uint8_t descriptor_set;
    /** MIP_ERROR_FIELD_LENGTH if the walk ended at a malformed field, else MIP_OK. The fields
     * before it are valid. */
    mip_error error;
};

/** May a packet have this descriptor set? Not 0 or 0xFF, which in tables denote all command sets
 * and all data sets. */
static inline bool mip_set_valid(uint8_t descriptor_set) {
    return descriptor_set != 0 && descriptor_set != 0xFF;
}

/** Computes the checksum of some bytes; its high byte is sent first. */
MIP_API uint16_t mip_checksum(const uint8_t *bytes, size_t size);

/** Checks that bytes are exactly one packet, by the rules of the parser and the builder: no packet
 * has descriptor set 0 or 0xFF. */
MIP_API mip_error mip_packet_check(const uint8_t *bytes, size_t size, struct mip_packet *packet);

/** Begins a walk through the fields of a packet. */
static inline struct mip_walk mip_walk_packet(const struct mip_packet *packet) {
    struct mip_walk walk;
    walk.at = packet->bytes;
    walk.end = packet->bytes;
    if (packet->size >= MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE) { /* otherwise there are no fields */
        walk.at += MIP_HEADER_SIZE;
        walk.end += packet->size - MIP_CHECKSUM_SIZE;
    }
    walk.descriptor_set = packet->descriptor_set;
    walk.error = MIP_OK;
    return walk;
}

/** Sets a field's descriptor and data to those of the field that begins at `at`, and returns its
 * length; 0 if it does not end within the next `left` bytes. */
static inline size_t mip_field_at(struct mip_field *field, const uint8_t *at, size_t left) {
    const size_t length = left > 0 ? at[0] : 0;
    if (length < 2 || length > left) {
        return 0;
    }
    field->data = at + 2;
    field->size = (uint8_t)(length - 2);
    field->descriptor = at[1];
    return length;
}

/** Gets the next field. Returns false at the end; `error` is then MIP_OK if all fields are valid.
 */
static inline bool mip_walk_next(struct mip_walk *walk, struct mip_field *field) {
    const size_t left = (size_t)(walk->end - walk->at);
    const size_t length = mip_field_at(field, walk->at, left);
    if (length > 0) {
        field->descriptor_set = walk->descriptor_set;
        walk->at += length;
        return true;
    }
    if (left > 0) {
        walk->at = walk->end;
        walk->error = MIP_ERROR_FIELD_LENGTH;
    }
    return false;
}

/** Descriptor set and descriptor of a field as one constant. */
#define MIP_KEY(descriptor_set, descriptor) ((uint16_t)((descriptor_set) * 256U + (descriptor)))

/**
 * Returns the type of a field as one number:
 * `switch (mip_field_key(&field)) { case MIP_SENSOR_...: ... }`. For a field that occurs in several
 * sets, the constant is a macro of the set, so that each is a case of its own:
 * `case MIP_GNSS_DATA_...(MIP_GNSS_2_SET):`. Shared fields have the same key in every data set, and
 * the acknowledge has the same key in every command set.
 */
static inline uint16_t mip_field_key(const struct mip_field *field) {
    uint32_t set = field->descriptor_set;
    if (field->descriptor >= MIP_FIRST_SHARED) {
        set = set >= 0x80 ? 0xFF : field->descriptor == MIP_ACKNOWLEDGE_DESCRIPTOR ? 0 : set;
    }
    return (uint16_t)(set << 8 | field->descriptor);
}

/* ------------------------------------------------------------------------------- packet builder */

/** Builds a packet from fields, in the caller's buffer. */
struct mip_builder {
    /** The packet so far. */
    uint8_t *buffer;
    /** Size of the buffer; at most MIP_MAX_PACKET bytes are used. */
    size_t capacity;
    /** Bytes used, without the checksum. */
    size_t length;
    /** The first error when the packet was begun or fields were added, for callers that check once
     * at the end; MIP_OK if there was none. The packet stays valid, without the rejected fields. */
    mip_error error;
};

/** Stores the error if it is the first one, and returns it. */
static inline mip_error mip_builder_note(struct mip_builder *builder, mip_error error) {
    if (builder->error == MIP_OK) {
        builder->error = error;
    }
    return error;
}

/**
 * Begins a packet. Fails with MIP_ERROR_LENGTH if the buffer is too small for an empty packet, and
 * with MIP_ERROR_SET if the descriptor set is 0 or 0xFF, which no packet has; then nothing can be
 * added.
 */
static inline mip_error mip_builder_start(struct mip_builder *builder, uint8_t *buffer,
                                          size_t capacity, uint8_t descriptor_set) {
    builder->buffer = buffer;
    builder->capacity = 0;
    builder->length = 0;
    builder->error = MIP_OK;
    if (!mip_set_valid(descriptor_set)) {
        return mip_builder_note(builder, MIP_ERROR_SET);
    }
    if (capacity < MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE) {
        return mip_builder_note(builder, MIP_ERROR_LENGTH);
    }
    buffer[0] = MIP_SYNC_1;
    buffer[1] = MIP_SYNC_2;
    buffer[2] = descriptor_set;
    buffer[3] = 0;
    builder->capacity = capacity < MIP_MAX_PACKET ? capacity : MIP_MAX_PACKET;
    builder->length = MIP_HEADER_SIZE;
    return MIP_OK;
}

/** Returns the packet's descriptor set; 0 if the packet could not be begun. */
static inline uint8_t mip_builder_set(const struct mip_builder *builder) {
    return builder->length > 0 ? builder->buffer[2] : 0;
}

/** Adds a field from its bytes. If it does not fit, the packet is unchanged: MIP_ERROR_LENGTH. */
MIP_CHECKED MIP_API mip_error mip_builder_add(struct mip_builder *builder, uint8_t descriptor,
                                              const void *data, size_t size);

/** Writes the checksum and returns the packet. More fields may be added before finishing again. */
static inline struct mip_packet mip_builder_finish(struct mip_builder *builder) {
    struct mip_packet packet = {builder->buffer, 0, 0};
    if (builder->length > 0) {
        const uint16_t sum = mip_checksum(builder->buffer, builder->length);
        builder->buffer[builder->length] = (uint8_t)(sum >> 8);
        builder->buffer[builder->length + 1] = (uint8_t)(sum & 0xFFU);
        packet.size = builder->length + MIP_CHECKSUM_SIZE;
        packet.descriptor_set = builder->buffer[2];
    }
    return packet;
}

/** Writes the header and the checksum around a payload of `size` bytes, which is already at
 * bytes + MIP_HEADER_SIZE. Returns the size of the packet. */
MIP_API size_t mip_packet_seal(uint8_t *bytes, uint8_t descriptor_set, size_t size);

/* -------------------------------------------------------------------------------- stream parser */

/** Finds packets in a stream of bytes, in pieces of any size. */
struct mip_parser {
    /** The number of bytes so far that are not part of a packet. */
    uint32_t skipped;
#ifdef MIP_DIAGNOSTICS
    /** The number of packets with a bad checksum, and of noise that looks like one. */
    uint32_t bad_checksums;
#endif
    /** Bytes in the buffer. */
    uint16_t length;
    /** The number of these that have been processed: the last packet, and the bytes before it. */
    uint16_t done;
    /** The number of missing bytes of the packet that begins the buffer; 0 if that is not known. */
    uint16_t missing;
    /** The beginning of a packet whose end has not arrived yet. */
    uint8_t buffer[MIP_MAX_PACKET];
};

/** Initializes a parser for a new stream. */
MIP_API void mip_parser_init(struct mip_parser *parser);

/**
 * Reads bytes until a packet is complete or no byte is left, and advances `data` and `size`.
 * Returns true if it has found a packet.
 *
 *     while (mip_parser_next(&parser, &data, &size, &packet)) { ... }
 *
 * The packet is in the caller's bytes, or in the parser if it spans calls. It is valid until the
 * parser is called again, and while these bytes are unchanged.
 */
MIP_API bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                             struct mip_packet *packet);

/**
 * Discards the incomplete packet if a whole packet begins within it, because it was noise, and
 * finds that packet. Otherwise returns false, and nothing changes.
 */
MIP_API bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet);

/**
 * Discards the incomplete packet, and finds whole packets within it.
 *
 * Noise may look like the beginning of a packet of up to 261 bytes. The parser then waits for the
 * rest, and holds back what follows, even whole packets, until that many bytes have arrived or
 * until this function is called. Call it at the end of a file, and when the line has been silent
 * for longer than a packet takes. If you do not, the last packets of a file may be missing, and
 * packets of a live stream may be delayed, but none is lost. If you call it while the rest of a
 * packet is still arriving, that packet is lost; mip_parser_look_behind keeps it.
 *
 *     while (mip_parser_flush(&parser, &packet)) { ... }
 */
MIP_API bool mip_parser_flush(struct mip_parser *parser, struct mip_packet *packet);

/* --------------------------------------------------------------------------------- typed fields */

/*
 * Optional parameters: the member `present`
 *
 * Some fields may end early, because an older device, or a command that does not need all values,
 * omits the last parameters. The structure of such a field begins with `present`, the number of
 * parameters that are present, counted from the first one, without the function selector.
 *
 * After decoding, it is the number received; the other members are zero. Before encoding, set it to
 * the number to send. The parameters that the function requires are always sent, so 0, which
 * constructors set, means only these. The constants ..._WITH_<PARAMETER> are values for it: they
 * include that parameter and all before it.
 *
 *     mip_..._write(&command, port, baud);
 *     command.flow_control = 1;
 *     command.present = MIP_..._WITH_FLOW_CONTROL;
 *
 *     if (response.present >= MIP_..._WITH_FLOW_CONTROL) { ... response.flow_control ... }
 */

/** A field that is sent to a device. */
#define MIP_COMMAND 0
/** A field that answers a command. */
#define MIP_RESPONSE 1
/** A field with data, which the device sends without a request. */
#define MIP_DATA 2

struct mip_interpreter;

/** The wire format of a type of field. */
struct mip_codec {
    /** Descriptor set: 0 for all command sets, 0xFF for all data sets. If there are several, it is
     * the first; mip_codec_belongs checks all of them. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** MIP_COMMAND, MIP_RESPONSE or MIP_DATA. */
    uint8_t role;
    /** The minimum number of bytes of data of a layout that is only numbers; 0 for others. */
    uint8_t numbers;
    /** Size of the structure. */
    uint16_t size;
    /** The number of further descriptor sets in which it occurs; they are right before `program`.
     */
    uint8_t more_sets;
    /** MIP_SHAPE of a layout that is only numbers, the widest first, without gaps; else 0. */
    uint8_t shape;
    /** The steps that read and write it: see mip/core/program.h. */
    const uint8_t *program;
    /** Runs the steps; NULL if the layout is only numbers. */
    const struct mip_interpreter *interpreter;
};

/** Do packets of this descriptor set contain fields of this type? */
MIP_API bool mip_codec_belongs(const struct mip_codec *codec, uint8_t descriptor_set);

/** Does the data of a field, as far as present, have this layout of its descriptor? */
MIP_API bool mip_codec_matches(const struct mip_codec *codec, const struct mip_field *field);

/** Is it a field of this type, in any of the descriptor sets in which the type occurs? The field's
 * `descriptor_set` is the one in which it arrived. */
MIP_API bool mip_field_is(const struct mip_field *field, const struct mip_codec *codec);

/**
 * Decodes a field of any type. On an error, `value` is zeroed. `trailing`, which may be NULL,
 * receives the number of bytes after the last known parameter, because newer devices may send more.
 */
MIP_API mip_error mip_decode(const struct mip_codec *codec, void *value,
                             const struct mip_field *field, size_t *trailing);

/** Like mip_decode, for a field whose descriptor is known to be the type's. */
MIP_API mip_error mip_decode_same(const struct mip_codec *codec, void *value,
                                  const struct mip_field *field);

/** Zeroes a structure that has gaps or whose field cannot be decoded; returns whether it cannot. */
static inline bool mip_cleared(mip_error error, void *value, size_t size, size_t wire) {
    if (error != MIP_OK || size != wire) {
        memset(value, 0, size);
    }
    return error != MIP_OK;
}

/** Defines `name_how(&command)`, which fills the structure for a function without parameters, and
 * returns it. */
#define MIP_FILL(name, how, selector)                               \
    static inline struct name *name##_##how(struct name *command) { \
        memset(command, 0, sizeof(*command));                       \
        command->function = selector;                               \
        return command;                                             \
    }                                                               \
    struct mip_builder

/**
 * Declares what each field has: its wire format, `name_codec`; `name_decode(&value, &field)`, which
 * zeroes the structure on an error; and `name_encode(&value, &builder)`, which adds the field to a
 * packet, or leaves the packet unchanged on an error. Its constants are its descriptor, and, as
 * mip_field_key returns them, descriptor set and descriptor.
 */
#define MIP_FIELD(name, number)                                                                \
    extern MIP_API const struct mip_codec name##_codec;                                        \
    static inline mip_error name##_decode(struct name *value, const struct mip_field *field) { \
        return mip_decode_only(&name##_codec, number, value, sizeof(*value), field);           \
    }                                                                                          \
    MIP_CHECKED static inline mip_error name##_encode(const struct name *value,                \
                                                      struct mip_builder *builder) {           \
        return mip_encode(&name##_codec, value, builder);                                      \
    }                                                                                          \
    struct mip_builder

/** Decodes a field if it has this descriptor; each ..._decode calls this. Most fields of a packet
 * are of other types. They are rejected without a call, unless size matters more than speed. */
static inline mip_error mip_decode_only(const struct mip_codec *codec, uint8_t descriptor,
                                        void *value, size_t size, const struct mip_field *field) {
#ifdef __OPTIMIZE_SIZE__
    (void)descriptor;
    (void)size;
    return mip_decode(codec, value, field, NULL);
#else
    if (field->descriptor != descriptor) {
        memset(value, 0, size);
        return MIP_ERROR_DESCRIPTOR;
    }
    return mip_decode_same(codec, value, field);
#endif
}

/**
 * Encodes a field of any type into a packet. On an error the packet is unchanged. `value` may be
 * NULL if the field has no parameters.
 */
MIP_CHECKED MIP_API mip_error mip_encode(const struct mip_codec *codec, const void *value,
                                         struct mip_builder *builder);

/** May packets of one set contain fields of another? Field set 0 means all command sets, 0xFF all
 * data sets. */
static inline bool mip_set_has(uint8_t packet_set, uint8_t field_set) {
    return field_set == packet_set || (field_set == 0xFF && packet_set >= 0x80) ||
           (field_set == 0 && packet_set < 0x80);
}

/** Checks that a field has this set and descriptor, and at least this many bytes of data. */
static inline mip_error mip_field_check(const struct mip_field *field, uint8_t descriptor_set,
                                        uint8_t descriptor, size_t size) {
    return field->descriptor != descriptor                       ? MIP_ERROR_DESCRIPTOR
           : !mip_set_has(field->descriptor_set, descriptor_set) ? MIP_ERROR_SET
           : field->size < size                                  ? MIP_ERROR_TRUNCATED
                                                                 : MIP_OK;
}

/**
 * Adds a field of this many bytes, at most MIP_MAX_FIELD_DATA, which the caller then writes to
 * `*data`. On an error, MIP_ERROR_SET or MIP_ERROR_LENGTH, the packet is unchanged. To add a field
 * of any size, call mip_builder_add.
 */
static inline mip_error mip_builder_reserve(struct mip_builder *builder, uint8_t descriptor_set,
                                            uint8_t descriptor, size_t size, uint8_t **data) {
    const size_t end = builder->length + 2 + size;
    if (end + MIP_CHECKSUM_SIZE > builder->capacity) {
        return mip_builder_note(builder, MIP_ERROR_LENGTH);
    }
    if (!mip_set_has(builder->buffer[2], descriptor_set)) {
        return mip_builder_note(builder, MIP_ERROR_SET);
    }
    uint8_t *at = builder->buffer + builder->length;
    at[0] = (uint8_t)(size + 2);
    at[1] = descriptor;
    *data = at + 2;
    builder->length = end;
    builder->buffer[3] = (uint8_t)(end - MIP_HEADER_SIZE);
    return MIP_OK;
}

/* -------------------------------------------------------------------------- big-endian numbers */

/** Reads an 8-bit integer. */
static inline uint8_t mip_get_8(const uint8_t *from) {
    return from[0];
}

/** Reads a 16-bit big-endian integer. */
static inline uint16_t mip_get_16(const uint8_t *from) {
    return (uint16_t)((uint32_t)from[0] << 8 | from[1]);
}

/** Reads a 32-bit big-endian integer. */
static inline uint32_t mip_get_32(const uint8_t *from) {
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8 | from[3];
}

/** Reads a 64-bit big-endian integer. */
static inline uint64_t mip_get_64(const uint8_t *from) {
    return (uint64_t)mip_get_32(from) << 32 | mip_get_32(from + 4);
}

/** Writes an 8-bit integer. */
static inline void mip_put_8(uint8_t *to, uint8_t value) {
    to[0] = value;
}

/** Writes a 16-bit big-endian integer. */
static inline void mip_put_16(uint8_t *to, uint16_t value) {
    to[0] = (uint8_t)(value >> 8);
    to[1] = (uint8_t)value;
}

/** Writes a 32-bit big-endian integer. */
static inline void mip_put_32(uint8_t *to, uint32_t value) {
    to[0] = (uint8_t)(value >> 24);
    to[1] = (uint8_t)(value >> 16);
    to[2] = (uint8_t)(value >> 8);
    to[3] = (uint8_t)value;
}

/** Writes a 64-bit big-endian integer. */
static inline void mip_put_64(uint8_t *to, uint64_t value) {
    mip_put_32(to, (uint32_t)(value >> 32));
    mip_put_32(to + 4, (uint32_t)value);
}

/** Converts the bits of an eight-byte double to a float's, rounded to nearest, for compilers whose
 * doubles have four bytes. */
MIP_API uint32_t mip_narrow(uint64_t bits);

/** Converts the bits of a float to an eight-byte double's. */
MIP_API uint64_t mip_widen(uint32_t bits);

/* By address, because some machines change the bits of a NaN that is passed by value. */

/** Reads a float of four bytes. */
static inline void mip_get_float(float *to, const uint8_t *from) {
    const uint32_t bits = mip_get_32(from);
    memcpy(to, &bits, sizeof(bits));
}

/** Writes a float of four bytes. */
static inline void mip_put_float(uint8_t *to, const float *value) {
    uint32_t bits;
    memcpy(&bits, value, sizeof(bits));
    mip_put_32(to, bits);
}

/** Reads a double of eight bytes; it is rounded if the compiler's doubles have four. */
static inline void mip_get_double(double *to, const uint8_t *from) {
    const uint64_t bits = mip_get_64(from);
    const uint32_t narrow = sizeof(*to) == sizeof(bits) ? 0 : mip_narrow(bits);
    memcpy(to, sizeof(*to) == sizeof(bits) ? (const void *)&bits : &narrow, sizeof(*to));
}

/** Writes a double of eight bytes. */
static inline void mip_put_double(uint8_t *to, const double *value) {
    uint64_t bits = 0;
    uint32_t narrow = 0;
    memcpy(sizeof(*value) == sizeof(bits) ? (void *)&bits : &narrow, value, sizeof(*value));
    mip_put_64(to, sizeof(*value) == sizeof(bits) ? bits : mip_widen(narrow));
}

/* ------------------------------------------------------------------------------------ bitfields */

/** Are all of these bits set? */
static inline bool mip_has(uint64_t flags, uint64_t bits) {
    return (flags & bits) == bits;
}

/** Sets bits in an 8-bit bitfield. */
static inline void mip_set_8(uint8_t *flags, uint8_t bits) {
    *flags = (uint8_t)(*flags | bits);
}

/** Clears bits in an 8-bit bitfield. */
static inline void mip_clear_8(uint8_t *flags, uint8_t bits) {
    *flags = (uint8_t)(*flags & ~(uint32_t)bits);
}

/** Sets bits in a 16-bit bitfield. */
static inline void mip_set_16(uint16_t *flags, uint16_t bits) {
    *flags = (uint16_t)(*flags | bits);
}

/** Clears bits in a 16-bit bitfield. */
static inline void mip_clear_16(uint16_t *flags, uint16_t bits) {
    *flags = (uint16_t)(*flags & ~(uint32_t)bits);
}

/** Sets bits in a 32-bit bitfield. */
static inline void mip_set_32(uint32_t *flags, uint32_t bits) {
    *flags = (uint32_t)(*flags | bits);
}

/** Clears bits in a 32-bit bitfield. */
static inline void mip_clear_32(uint32_t *flags, uint32_t bits) {
    *flags = (uint32_t)(*flags & ~bits);
}

/** Sets bits in a 64-bit bitfield. */
static inline void mip_set_64(uint64_t *flags, uint64_t bits) {
    *flags = (uint64_t)(*flags | bits);
}

/** Clears bits in a 64-bit bitfield. */
static inline void mip_clear_64(uint64_t *flags, uint64_t bits) {
    *flags = (uint64_t)(*flags & ~bits);
}

/** Denotes bits of a bitfield in bytes, least significant byte first: `width` of them, at most 64,
 * starting with bit `first`. */
#define MIP_BITS(first, width) ((unsigned)(first) | (unsigned)(width) << 8)

/** Returns the number in these bits: mip_get_bits(status.bytes, MIP_..._GYRO_FAULT). */
MIP_API uint64_t mip_get_bits(const uint8_t *bytes, unsigned bits);

/** Sets the number in these bits. */
MIP_API void mip_set_bits(uint8_t *bytes, unsigned bits, uint64_t value);

/* ----------------------------------------------------------------- arguments of constructors */

#ifdef MIP_REFUSED_BY_COMPILER
/** This is only declared, so that a call of it is an error. */
void mip_neither_true_nor_false(void)
    MIP_REFUSED_BY_COMPILER("neither true nor false: are two arguments swapped?");
#endif

/** Returns its argument. Optimizing compilers reject a constant that is neither true nor false,
 * such as a descriptor set that was passed instead of `true`. */
static inline mip_bool mip_truth(mip_bool value) {
#ifdef MIP_REFUSED_BY_COMPILER
    if (__builtin_constant_p(value) && value > 1) {
        mip_neither_true_nor_false();
    }
#endif
    return value;
}

#ifdef MIP_REFUSED_BY_COMPILER
/** This is only declared, so that a call of it is an error. */
void mip_array_has_fewer_elements(void)
    MIP_REFUSED_BY_COMPILER("the array has fewer elements: use MIP_ARRAY(array)");
#endif

/** The number of elements of an array and its address, as two arguments. */
#define MIP_ARRAY(array) (sizeof(array) / sizeof((array)[0])), (array)

/** Returns the size of `count` elements in bytes. Optimizing compilers reject a constant count that
 * is larger than the array. */
static inline size_t mip_counted(size_t count, const void *items, size_t size) {
#ifdef MIP_REFUSED_BY_COMPILER
    if (__builtin_constant_p(count) && __builtin_object_size(items, 0) < count * size) {
        mip_array_has_fewer_elements();
    }
#else
    (void)items;
#endif
    return count * size;
}

/** Copies `size` bytes, or `room` if that is less. */
MIP_API void mip_copy(void *to, size_t room, const void *from, size_t size);

/** Copies a string, truncated or padded with spaces to the size; `room` includes the terminating
 * NUL. */
MIP_API void mip_copy_text(char *to, size_t room, const char *text);

#ifdef __cplusplus
}
#endif

#endif
