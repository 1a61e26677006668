/*
 * Decoding and encoding for any well-formed codec (steps.h): they access nothing outside the field, the structure, the
 * packet and the program. A layout of more than numbers is read and written by an interpreter that does anything that
 * interpreter.c proves of ours.
 *
 * As in parser.c, loops are proved by induction, with a macro.
 */
#include "any.h"

#include "steps.h"

#include <string.h>

/* ------------------------------------------------------------------------- what the loops do first */

static uint8_t *number_data; /* of the field, or where it is in the packet */
static struct mip_codec codec;

/* A round for one of several bytes begins; it is the same for each. */
static void byte_begins(size_t *at, size_t bytes, uint8_t **byte) {
    static unsigned rounds;
    __CPROVER_assume(rounds++ == 0);
    assert(*at == 0);
    *at = nondet_size();
    __CPROVER_assume(*at < bytes);
    *byte += *at;
}

/* A round for one of several numbers begins, or, inside it, what is written as a loop for the preprocessor only. */
static void number_begins(uint8_t **at, uint8_t **place, size_t *left, unsigned first) {
    static unsigned calls;
    static uint8_t *from, *to;
    static size_t all;
    const unsigned kind = first >> 5 & 3;
    switch (calls++) {
    case 0:
        from = *at;
        to = *place;
        all = *left;
        *left = up_to(all);
        __CPROVER_assume(*left > 0);
        *at += (all - *left) << kind;
        *place += (all - *left) << kind;
        break;
    case 1:
        break;
    default:
        assert(*at == from + ((all - *left) << kind) && *place == to + ((all - *left) << kind));
        assert(*left > 0 && *left < all);
        __CPROVER_assume(false);
    }
}

/* A round for a step of numbers begins. The sizes of all its steps are `numbers`, so that those of this one and the
 * further ones are what is left of it. */
static void numbers_begin(const uint8_t **at, uint8_t **wire, unsigned *first) {
    static unsigned rounds;
    static size_t before, size;
    if (rounds++ > 0) {
        assert(*at == codec.program + 2 && *wire == number_data + before + size);
        __CPROVER_assume(false);
    }
    assert(*at == codec.program && *wire == number_data);
    before = up_to(codec.numbers);
    size = numbers_size(codec.program, codec.size);
    __CPROVER_assume(size > 0 && size <= codec.numbers - before);
    *wire = number_data + before;
    *first = *codec.program;
}

/* What the macro names in functions that have no such variable. */
static size_t i, size, count;
static const uint8_t *program;
static uint8_t *wire, *memory;
static unsigned step;

/* Copies are looked at, and not made: what is in memory is any bytes, before and after. */
static void *any_copy(void *to, const void *from, size_t bytes) {
    assert(__CPROVER_w_ok(to, bytes) && __CPROVER_r_ok(from, bytes));
    return to;
}

static void *any_set(void *to, int byte, size_t bytes) {
    (void)byte;
    assert(__CPROVER_w_ok(to, bytes));
    return to;
}
#define memcpy any_copy
#define memset any_set

#ifdef ANY_NUMBERS
/* Neither are numbers written; `moves` looks how they are. */
#define ANY_PUT(bits)                                              \
    static void any_put_##bits(uint8_t *to, uint##bits##_t number) { \
        (void)number;                                              \
        assert(__CPROVER_w_ok(to, (bits) / 8));                     \
    }
ANY_PUT(8)
ANY_PUT(16)
ANY_PUT(32)
ANY_PUT(64)
#define mip_put_8 any_put_8
#define mip_put_16 any_put_16
#define mip_put_32 any_put_32
#define mip_put_64 any_put_64
#endif

#define for(...)                                                                                      \
    for (__VA_ARGS__)                                                                                 \
        if (IS("move_all", "unsigned step = *program; step != MIP_END; step = *program", #__VA_ARGS__) \
                ? numbers_begin(&program, &wire, &step)                                               \
            : IS("move", "size_t i = 0; i < size * count; i++", #__VA_ARGS__) ? byte_begins(&i, size * count, &wire) \
            : IS("mip_codec_belongs", "size_t i = codec->more_sets; i > 0; i--", #__VA_ARGS__) ? set_begins(&i) \
                                                                                               : (void)0, \
            true)
#define do do if (IS("move", "", "") ? number_begins(&wire, &memory, &count, step) : (void)0, true)

/* A round for a further set begins; it is the same for each. */
static void set_begins(size_t *at) {
    static unsigned rounds;
    __CPROVER_assume(rounds++ == 0);
    assert(*at == codec.more_sets);
    *at = up_to(codec.more_sets);
    __CPROVER_assume(*at > 0);
}
#include "mip/core/codec.c"
#undef for
#undef do

/* ----------------------------------------------------------------------------------- what may be */

static bool any_matches(const struct mip_codec *of, const struct mip_field *field) {
    assert(of == &codec && __CPROVER_r_ok(field->data, field->size));
    return nondet_bool();
}

static mip_error any_read(const struct mip_codec *of, void *value, const struct mip_field *field, size_t *trailing) {
    assert(of == &codec && __CPROVER_w_ok(value, of->size) && __CPROVER_r_ok(field->data, field->size));
    if (trailing != NULL) {
        *trailing = up_to(field->size);
    }
    return (mip_error)nondet_byte();
}

static mip_error any_write(const struct mip_codec *of, const void *value, uint8_t *data, size_t room, size_t *used) {
    assert(of == &codec && __CPROVER_r_ok(value, of->size) && __CPROVER_w_ok(data, room));
    *used = up_to(room);
    return (mip_error)nondet_byte();
}

static const struct mip_interpreter any_interpreter = {any_matches, any_read, any_write};
static const struct mip_interpreter of_only_layout = {NULL, any_read, any_write};

/* A codec with any further sets before its program, of which the step that is looked at is the first. */
static void any_codec(void) {
    codec.descriptor_set = nondet_byte();
    codec.descriptor = nondet_byte();
    codec.numbers = nondet_byte();
    codec.shape = nondet_byte();
    codec.more_sets = nondet_byte();
    codec.size = (uint16_t)up_to(0xFFFF);
    const size_t steps = up_to(3);
    __CPROVER_assume(steps > 0);
    uint8_t *before = any_bytes(codec.more_sets + steps);
    codec.program = before + codec.more_sets;
    codec.interpreter = nondet_bool() ? NULL : nondet_bool() ? &any_interpreter : &of_only_layout;
    __CPROVER_assume(shape_fits(&codec));
    __CPROVER_assume(codec.interpreter != NULL || codec.program[0] == MIP_END || steps == 3);
}

void decode(void) {
    any_codec();
    const size_t size = up_to(255);
    number_data = any_bytes(size);
    const struct mip_field field = {number_data, (uint8_t)size, nondet_byte(), nondet_byte()};
    size_t rest = 0;
    mip_decode(&codec, any_bytes(codec.size), &field, nondet_bool() ? &rest : NULL);
    assert(rest <= size);
}

/* From any state of a packet that is being built. */
void encode(void) {
    any_codec();
    const size_t capacity = up_to(MIP_MAX_PACKET + 1);
    uint8_t *buffer = any_bytes(capacity);
    struct mip_builder b;
    __CPROVER_assume(mip_builder_start(&b, buffer, capacity, nondet_byte()) == MIP_OK);
    b.length += up_to(b.capacity - MIP_HEADER_SIZE - MIP_CHECKSUM_SIZE);
    const size_t length = b.length;
    buffer[3] = (uint8_t)(length - MIP_HEADER_SIZE);
    number_data = buffer + length + 2;
    const mip_error error = mip_encode(&codec, any_bytes(codec.size), &b);
    assert(b.length + MIP_CHECKSUM_SIZE <= b.capacity && b.capacity <= capacity);
    assert(error == MIP_OK ? b.length >= length + 2 : b.length == length);
    assert(buffer[3] == b.length - MIP_HEADER_SIZE);
}

/* What the interpreter calls: numbers of any kind. */
void moves(void) {
    const size_t times = up_to(255);
    const unsigned kind = nondet_byte();
    __CPROVER_assume(kind >= MIP_KIND_DOUBLE && kind <= MIP_KIND_64);
    const size_t bytes = times << (kind & 3);
    __CPROVER_assume(bytes <= 255); /* more is in no field */
    uint8_t *place = any_bytes(bytes);
    assert(mip_move(place, any_bytes(bytes), kind, times, nondet_bool()) == place + bytes);
}
