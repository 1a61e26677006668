/**
 * @file
 * The core of the MIP binding: packets, fields, and the stream parser.
 *
 * C99 without heap; of the standard library it uses only memcpy, memmove, memset and memchr.
 * Nothing depends on the byte order or the alignment of the host.
 */
#ifndef MIP_CORE_H
#define MIP_CORE_H

#include "mip/constants.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes before the payload: two sync bytes, descriptor set, length of the payload. */
#define MIP_HEADER_SIZE 4
/** Bytes after the payload. */
#define MIP_CHECKSUM_SIZE 2
/** Maximum size of a packet. */
#define MIP_MAX_PACKET (MIP_HEADER_SIZE + MIP_MAX_PAYLOAD + MIP_CHECKSUM_SIZE)

/** Errors. */
typedef enum mip_error {
    MIP_OK = 0,
    /** The bytes do not start with the sync bytes of a packet. */
    MIP_ERROR_SYNC,
    /** A packet does not have the length that it states, or something does not fit into a packet.
     */
    MIP_ERROR_LENGTH,
    /** The checksum of a packet does not match. */
    MIP_ERROR_CHECKSUM,
    /** A field is shorter than its own header or reaches beyond its packet. */
    MIP_ERROR_FIELD_LENGTH,
    /** A field is too short for what it must hold. */
    MIP_ERROR_TRUNCATED,
    /** A count exceeds the number of elements that follow, or the size of the array. */
    MIP_ERROR_COUNT,
    /** A constant has another value. */
    MIP_ERROR_CONSTANT,
    /** The number of present parameters ends between a counter and its array, or exceeds them. */
    MIP_ERROR_MISSING,
    /** The field does not stand in packets of this descriptor set. */
    MIP_ERROR_SET,
    /** The data have another layout of the descriptor than the caller expects. */
    MIP_ERROR_LAYOUT
} mip_error;

/** The error as one word in lower case: "truncated"; "ok" if there is none. */
const char *mip_error_name(mip_error error);

/** Zero is false, anything else is true; bytes other than 0 and 1 are preserved. */
typedef uint8_t mip_bool;

/* --------------------------------------------------------------------------- packets and fields */

/** A complete, valid packet, anywhere in memory. */
struct mip_packet {
    /** From the first sync byte on. */
    const uint8_t *bytes;
    /** Header and checksum included. */
    size_t size;
    uint8_t descriptor_set;
};

/** One field of a packet, not yet decoded. */
struct mip_field {
    /** What follows the descriptor. */
    const uint8_t *data;
    /** Bytes of data. */
    uint8_t size;
    /** Descriptor set of the packet. */
    uint8_t descriptor_set;
    uint8_t descriptor;
};

/** An iterator over the fields of a packet. */
struct mip_walk {
    const uint8_t *at;
    const uint8_t *end;
    uint8_t descriptor_set;
    /** The walk ended at a malformed field; the fields before it are valid. */
    bool malformed;
};

/** The checksum of some bytes: its first byte is the high one. */
uint16_t mip_checksum(const uint8_t *bytes, size_t size);

/** Checks that bytes are exactly one packet: MIP_OK, or what is wrong with them. */
mip_error mip_packet_check(const uint8_t *bytes, size_t size, struct mip_packet *packet);

/** Begins a walk through the fields of a packet. */
struct mip_walk mip_walk_packet(const struct mip_packet *packet);

/** Gets the next field. False at the end; `malformed` then tells whether that is an error. */
bool mip_walk_next(struct mip_walk *walk, struct mip_field *field);

/* ------------------------------------------------------------------------------- packet builder */

/** Builds a packet from fields, in a buffer of the caller. */
struct mip_builder {
    uint8_t *buffer;
    /** Size of the buffer; at most MIP_MAX_PACKET bytes are used. */
    size_t capacity;
    /** Bytes used, without the checksum. */
    size_t length;
};

/**
 * Begins a packet. MIP_ERROR_LENGTH if the buffer does not even hold an empty one, or if the
 * descriptor set is 0; then nothing can be added.
 */
mip_error mip_builder_start(struct mip_builder *builder, uint8_t *buffer, size_t capacity,
                            uint8_t descriptor_set);

/** Adds a field from its bytes. MIP_ERROR_LENGTH if it does not fit; the packet is unchanged. */
mip_error mip_builder_add(struct mip_builder *builder, uint8_t descriptor, const void *data,
                          size_t size);

/** Writes the checksum and returns the packet. More fields may be added before finishing again. */
struct mip_packet mip_builder_finish(struct mip_builder *builder);

/* -------------------------------------------------------------------------------- stream parser */

/** Finds packets in a stream of bytes, however it is cut into pieces. */
struct mip_parser {
    /** Bytes so far that belong to no packet. */
    uint32_t skipped;
    /** Bytes in the buffer, how many of them are done with, and how many are missing at least. */
    uint16_t length;
    uint16_t done;
    uint16_t missing;
    uint8_t buffer[MIP_MAX_PACKET];
};

/** Initializes a parser for a new stream. */
void mip_parser_init(struct mip_parser *parser);

/**
 * Reads bytes until a packet is complete or no byte is left, and advances `data` and `size`.
 *
 *     while (mip_parser_next(&parser, &data, &size, &packet)) { ... }
 *
 * The packet is in the caller's bytes, or in the parser if their end has cut it: it stays valid
 * until the parser is called again, and as long as these bytes stay where they are.
 */
bool mip_parser_next(struct mip_parser *parser, const uint8_t **data, size_t *size,
                     struct mip_packet *packet);

/**
 * Gives up the incomplete packet only if a whole one is behind its first bytes, and finds that one:
 * the first was noise then. Otherwise nothing changes.
 */
bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet);

/**
 * Gives up the incomplete packet, for instance at the end of a file, and finds packets hidden
 * behind its first bytes. Call it until it returns false.
 */
bool mip_parser_flush(struct mip_parser *parser, struct mip_packet *packet);

/* --------------------------------------------------------------------------------- typed fields */

struct mip_reader;
struct mip_writer;

/** Reads the parameters of a field into its zeroed structure. */
typedef void (*mip_read_function)(struct mip_reader *reader, void *value);
/** Writes the parameters of a field. */
typedef void (*mip_write_function)(struct mip_writer *writer, const void *value);

/** Roles of a field. */
#define MIP_COMMAND 0
#define MIP_RESPONSE 1
#define MIP_DATA 2

struct mip_codec;

/** A response of a command. */
struct mip_response {
    const struct mip_codec *codec;
    /** Does a command with these values ask for it? NULL if it always does. */
    bool (*asked)(const void *command);
};

/** A value at a fixed place. */
struct mip_constant {
    uint8_t offset;
    uint8_t size;
    uint64_t value;
};

/** What tells one of several layouts of a descriptor from the others. */
struct mip_layout {
    /** Bytes of data that it may have. */
    uint8_t shortest;
    uint8_t longest;
    uint8_t constant_count;
    const struct mip_constant *constants;
};

/** All that generic code needs to handle a type of field; the client and the registry use it. */
struct mip_codec {
    uint8_t descriptor_set;
    uint8_t descriptor;
    /** MIP_COMMAND, MIP_RESPONSE or MIP_DATA. */
    uint8_t role;
    /** Size of the structure. */
    uint16_t size;
    /** Milliseconds that a device may take to answer; 0: no longer than usual. */
    uint16_t timeout;
    mip_read_function read;
    mip_write_function write;
    /** Does the device leave this command unanswered? NULL if it always answers. */
    bool (*silent)(const void *value);
    /** The responses of this command, up to an entry without a codec; NULL if there are none. */
    const struct mip_response *responses;
    /** NULL if it is the only layout of its descriptor. */
    const struct mip_layout *layout;
};

/** Do the data of a field have this layout of their descriptor, as far as they reach? */
bool mip_codec_matches(const struct mip_codec *codec, const struct mip_field *field);

/**
 * Decodes a field of any type. On an error `value` is zeroed. `trailing` may be NULL; it receives
 * the number of bytes after the last known parameter, as newer devices may send more.
 */
mip_error mip_decode(const struct mip_codec *codec, void *value, const struct mip_field *field,
                     size_t *trailing);

/** Encodes a field of any type into a packet. On an error the packet is unchanged. */
mip_error mip_encode(const struct mip_codec *codec, const void *value, struct mip_builder *builder);

/* ------------------------------------------------------------------------------------ bitfields */

/** Are all of these bits set? */
static inline bool mip_has(uint64_t flags, uint64_t bits) {
    return (flags & bits) == bits;
}

/** Set and clear bits of a bitfield of 8, 16, 32 or 64 bits. */
static inline void mip_set_8(uint8_t *flags, uint8_t bits) {
    *flags = (uint8_t)(*flags | bits);
}
static inline void mip_clear_8(uint8_t *flags, uint8_t bits) {
    *flags = (uint8_t)(*flags & ~(uint32_t)bits);
}
static inline void mip_set_16(uint16_t *flags, uint16_t bits) {
    *flags = (uint16_t)(*flags | bits);
}
static inline void mip_clear_16(uint16_t *flags, uint16_t bits) {
    *flags = (uint16_t)(*flags & ~(uint32_t)bits);
}
static inline void mip_set_32(uint32_t *flags, uint32_t bits) {
    *flags = (uint32_t)(*flags | bits);
}
static inline void mip_clear_32(uint32_t *flags, uint32_t bits) {
    *flags = (uint32_t)(*flags & ~bits);
}
static inline void mip_set_64(uint64_t *flags, uint64_t bits) {
    *flags = (uint64_t)(*flags | bits);
}
static inline void mip_clear_64(uint64_t *flags, uint64_t bits) {
    *flags = (uint64_t)(*flags & ~bits);
}

/* ---------------------------------------------------------------- functions of generated code */

/** Reads big-endian numbers; nothing after an error or after the last present group. */
struct mip_reader {
    const uint8_t *at;
    const uint8_t *end;
    /** Where the last group of parameters began. */
    const uint8_t *mark;
    /** A mip_error. */
    uint8_t error;
    /** Parameters that the function selector requires, and present parameters. */
    uint8_t required;
    uint8_t present;
    /** Last parameter of the group that is being read. */
    uint8_t last;
    /** May the group be absent? Was it cut short? Is there nothing more to read? */
    bool optional;
    bool cut;
    bool stopped;
};

/** Writes big-endian numbers; nothing after an error or after the last present group. */
struct mip_writer {
    uint8_t *at;
    uint8_t *end;
    /** A mip_error. */
    uint8_t error;
    /** Parameters to be written, and the last one of the group that is being written. */
    uint8_t present;
    uint8_t last;
    bool stopped;
};

mip_error mip_decode_field(const struct mip_field *field, mip_read_function read, void *value,
                           size_t size, size_t *trailing);
mip_error mip_encode_field(struct mip_builder *builder, uint8_t descriptor_set, uint8_t descriptor,
                           mip_write_function write, const void *value);

/** For fields without parameters. */
void mip_read_nothing(struct mip_reader *r, void *value);
void mip_write_nothing(struct mip_writer *w, const void *value);

/** Numbers of 8, 16, 32 or 64 bits of any kind. */
void mip_read_8(struct mip_reader *r, void *to, size_t count);
void mip_read_16(struct mip_reader *r, void *to, size_t count);
void mip_read_32(struct mip_reader *r, void *to, size_t count);
void mip_read_64(struct mip_reader *r, void *to, size_t count);
void mip_write_8(struct mip_writer *w, const void *from, size_t count);
void mip_write_16(struct mip_writer *w, const void *from, size_t count);
void mip_write_32(struct mip_writer *w, const void *from, size_t count);
void mip_write_64(struct mip_writer *w, const void *from, size_t count);

/** A number of `size` bytes that must have this value. */
void mip_read_constant(struct mip_reader *r, uint64_t value, size_t size);
void mip_write_constant(struct mip_writer *w, uint64_t value, size_t size);

/** The number of elements of an array, counted or to the end of the field; 0 after an error. */
size_t mip_read_count(struct mip_reader *r, uint32_t count, size_t capacity, size_t item);
size_t mip_read_rest(struct mip_reader *r, size_t capacity, size_t item);
size_t mip_write_count(struct mip_writer *w, uint32_t count, size_t capacity);

/** How many parameters to process: by function selector, or as many as the caller wants. */
void mip_read_required(struct mip_reader *r, uint8_t function, const uint8_t *table, size_t size);
void mip_write_required(struct mip_writer *w, uint8_t function, const uint8_t *table, size_t size,
                        uint8_t present);

/** Begins the parameters `first` to `last`, which are present together or not at all. */
void mip_read_group(struct mip_reader *r, uint8_t first, uint8_t last);
void mip_write_group(struct mip_writer *w, uint8_t first, uint8_t last);

/** Ends the last group and returns the number of present parameters. */
uint8_t mip_read_present(const struct mip_reader *r);

/** Copies as many bytes as there is room for. */
void mip_copy(void *to, size_t room, const void *from, size_t size);
/** Copies a string and fills the rest with spaces; `room` counts the terminating NUL too. */
void mip_copy_text(char *to, size_t room, const char *text);

/** A number in a bitfield of bytes, least significant byte first. */
uint64_t mip_get_bits(const uint8_t *bytes, unsigned first, unsigned width);
void mip_set_bits(uint8_t *bytes, unsigned first, unsigned width, uint64_t value);

/** The same by the name of the scalar, so that the compiler checks the type of the member. */
static inline void mip_read_u8(struct mip_reader *r, uint8_t *to, size_t count) {
    mip_read_8(r, to, count);
}
static inline void mip_write_u8(struct mip_writer *w, const uint8_t *from, size_t count) {
    mip_write_8(w, from, count);
}
static inline void mip_read_u16(struct mip_reader *r, uint16_t *to, size_t count) {
    mip_read_16(r, to, count);
}
static inline void mip_write_u16(struct mip_writer *w, const uint16_t *from, size_t count) {
    mip_write_16(w, from, count);
}
static inline void mip_read_u32(struct mip_reader *r, uint32_t *to, size_t count) {
    mip_read_32(r, to, count);
}
static inline void mip_write_u32(struct mip_writer *w, const uint32_t *from, size_t count) {
    mip_write_32(w, from, count);
}
static inline void mip_read_u64(struct mip_reader *r, uint64_t *to, size_t count) {
    mip_read_64(r, to, count);
}
static inline void mip_write_u64(struct mip_writer *w, const uint64_t *from, size_t count) {
    mip_write_64(w, from, count);
}
static inline void mip_read_s8(struct mip_reader *r, int8_t *to, size_t count) {
    mip_read_8(r, to, count);
}
static inline void mip_write_s8(struct mip_writer *w, const int8_t *from, size_t count) {
    mip_write_8(w, from, count);
}
static inline void mip_read_s16(struct mip_reader *r, int16_t *to, size_t count) {
    mip_read_16(r, to, count);
}
static inline void mip_write_s16(struct mip_writer *w, const int16_t *from, size_t count) {
    mip_write_16(w, from, count);
}
static inline void mip_read_s32(struct mip_reader *r, int32_t *to, size_t count) {
    mip_read_32(r, to, count);
}
static inline void mip_write_s32(struct mip_writer *w, const int32_t *from, size_t count) {
    mip_write_32(w, from, count);
}
static inline void mip_read_s64(struct mip_reader *r, int64_t *to, size_t count) {
    mip_read_64(r, to, count);
}
static inline void mip_write_s64(struct mip_writer *w, const int64_t *from, size_t count) {
    mip_write_64(w, from, count);
}
static inline void mip_read_float(struct mip_reader *r, float *to, size_t count) {
    mip_read_32(r, to, count);
}
static inline void mip_write_float(struct mip_writer *w, const float *from, size_t count) {
    mip_write_32(w, from, count);
}
static inline void mip_read_double(struct mip_reader *r, double *to, size_t count) {
    mip_read_64(r, to, count);
}
static inline void mip_write_double(struct mip_writer *w, const double *from, size_t count) {
    mip_write_64(w, from, count);
}
static inline void mip_read_bool(struct mip_reader *r, mip_bool *to, size_t count) {
    mip_read_8(r, to, count);
}
static inline void mip_write_bool(struct mip_writer *w, const mip_bool *from, size_t count) {
    mip_write_8(w, from, count);
}
static inline void mip_read_char(struct mip_reader *r, char *to, size_t count) {
    mip_read_8(r, to, count);
}
static inline void mip_write_char(struct mip_writer *w, const char *from, size_t count) {
    mip_write_8(w, from, count);
}

#ifdef __cplusplus
}
#endif

#endif
