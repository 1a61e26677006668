/*
 * The stream parser, compiled for size: one call, in any state that it can be in, with a piece of any bytes. It
 * accesses nothing outside the piece and its buffer, loses no byte, and leaves such a state again, so that what is
 * proved of one call is proved of any number.
 *
 * Its loops are proved by induction: when one is entered, all that it changes becomes anything that its invariant
 * allows; after one round, the invariant must hold again. The macro below puts this into the source. Copies and
 * checksums do anything that their contracts allow.
 */
#include "mip/checksum.h"

#include <assert.h>
#include <stdlib.h>

size_t nondet_size(void);
uint16_t nondet_16(void);
uint32_t nondet_32(void);
_Bool nondet_bool(void);

struct content {
    uint8_t bytes[MIP_MAX_PACKET];
};
struct content nondet_content(void);

static struct mip_parser state;
static struct mip_packet found;
static const uint8_t *piece; /* the caller's bytes */
static size_t size;
static const uint8_t *data; /* what is left of them */
static size_t left_over;

static size_t up_to(size_t most) {
    const size_t value = nondet_size();
    __CPROVER_assume(value <= most);
    return value;
}

/* Bytes of the stream so far that are in no packet, and those of this piece that are still to come. */
static uint16_t total(size_t unread) {
    return (uint16_t)(state.skipped + state.length - state.done + unread);
}
static uint16_t total_before;

static bool is_state(void) {
    return state.done <= state.length && state.length <= MIP_MAX_PACKET;
}

static void any_state(void) {
    state.skipped = nondet_32();
    state.length = nondet_16();
    state.done = nondet_16();
    *(struct content *)state.buffer = nondet_content();
    __CPROVER_assume(is_state());
}

/* ------------------------------------------------------------- contracts of what the parser calls */

static uint16_t any_sum(const uint8_t *bytes, size_t count) {
    assert(__CPROVER_r_ok(bytes, count));
    return nondet_16();
}

uint16_t mip_checksum(const uint8_t *bytes, size_t count) {
    return any_sum(bytes, count);
}

static void any_copy(void *to, const void *from, size_t count) {
    assert(to != NULL && from != NULL && __CPROVER_r_ok(from, count) && __CPROVER_w_ok(to, count));
    assert(__CPROVER_same_object(to, &state) && (uint8_t *)to >= state.buffer &&
           (size_t)((uint8_t *)to - state.buffer) + count <= MIP_MAX_PACKET);
    *(struct content *)state.buffer = nondet_content();
}

void *memcpy(void *to, const void *from, size_t count) {
    assert(!__CPROVER_same_object(to, from));
    any_copy(to, from, count);
    return to;
}

void *memmove(void *to, const void *from, size_t count) {
    any_copy(to, from, count);
    return to;
}

/* ----------------------------------------------------------------------------------------- loops */

/* A round of the search begins. It changes the state, and what is left of the piece. */
static void search_round(void) {
    static unsigned rounds;
    assert(is_state() && left_over <= size && total(left_over) == total_before);
    assert(size == 0 || data == piece + (size - left_over));
    __CPROVER_assume(rounds++ == 0);
    any_state();
    left_over = up_to(size);
    if (size > 0) {
        data = piece + (size - left_over);
    }
    __CPROVER_assume(total(left_over) == total_before);
}

/* A round of look_behind() begins, which changes nothing but its place. */
static void look_round(size_t *place) {
    __CPROVER_assume(*place == 1);
    *place = nondet_size();
    __CPROVER_assume(*place >= 1 && *place < state.length);
}

static size_t at; /* for the macro, in the function that has no such variable */

/* Chooses by the name of the function that has the loop. */
#define for(...)      \
    for (__VA_ARGS__) \
        if (sizeof(__func__) == sizeof("mip_parser_look_behind") ? look_round(&at) : search_round(), true)
#define mip_sum any_sum
#include "mip/parser.c"
#undef for

/* ----------------------------------------------------------------------------------------- proofs */

static void any_call(size_t most) {
    size = up_to(most);
    piece = (const uint8_t *)malloc(size);
    __CPROVER_assume(piece != NULL);
    data = size > 0 || nondet_bool() ? piece : NULL;
    left_over = size;
    any_state();
    total_before = total(size);
}

/* After a call: a packet in the piece or in the buffer, or no byte is left. */
static void check(bool is_found) {
    assert(is_state());
    assert(total(left_over) == (uint16_t)(total_before - (is_found ? found.size : 0)));
    if (is_found) {
        assert(found.size >= 6 && found.size <= MIP_MAX_PACKET && __CPROVER_r_ok(found.bytes, found.size));
        assert(__CPROVER_same_object(found.bytes, piece) || __CPROVER_same_object(found.bytes, &state));
    } else {
        assert(left_over == 0);
    }
}

/* The first state satisfies the invariant. */
void parser_init(void) {
    mip_parser_init(&state);
    assert(is_state() && state.skipped == 0);
}

void parser_next(void) {
    any_call(LARGEST);
    const bool is_found = mip_parser_next(&state, &data, &left_over, &found);
    assert(left_over <= size && (size == 0 || data == piece + (size - left_over)));
    check(is_found);
}

void parser_flush(void) {
    any_call(0);
    const bool is_found = mip_parser_flush(&state, &found);
    check(is_found);
    assert(is_found || state.length == 0);
}
