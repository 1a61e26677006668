/*
 * The stream parsers, small and fast: one call, in any state that it can be in, with a piece of any bytes. It accesses
 * nothing outside the piece and its buffer, loses no byte, and leaves such a state again, so that what is proved of one
 * call is proved of any number. The fast one has parts, which are proved one by one.
 *
 * Its loops are proved by induction: when one is entered, all that it changes becomes anything that its invariant
 * allows; after one round, the invariant must hold again. The macro below puts this into the source. Copies and
 * checksums do anything that their contracts allow.
 */
#include "any.h"

#include "mip/core/checksum.h"
#include "mip/core/parser.h"

struct content {
    uint8_t bytes[MIP_MAX_PACKET];
};
struct content nondet_content(void);

static struct mip_parser state;
static struct mip_packet packet;
static const uint8_t *piece; /* the caller's bytes */
static size_t size;
static const uint8_t *data; /* what is left of them */
static size_t left_over;

/* Bytes of the stream so far that are in no packet, and those of this piece that are still to come. */
static uint16_t total(size_t unread) {
    return (uint16_t)(state.skipped + state.length - state.done + unread);
}
static uint16_t total_before;

static bool is_state(void) {
    if (state.length > 0 && state.missing > 0) { /* of the packet whose beginning is in the buffer */
        const size_t goal = (size_t)state.length + state.missing;
        return state.done == 0 && goal >= MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE && goal <= MIP_MAX_PACKET;
    }
#ifdef MIP_PARSER_SMALL
    if (state.missing > 0) {
        return false;
    }
#endif
    return state.done <= state.length && state.length <= MIP_MAX_PACKET;
}

static void any_state(void) {
    state.skipped = nondet_32();
    state.length = nondet_16();
    state.done = nondet_16();
    state.missing = nondet_16();
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

void *memchr(const void *from, int byte, size_t count) {
    (void)byte;
    assert(count == 0 || __CPROVER_r_ok(from, count));
    return count > 0 && nondet_bool() ? (uint8_t *)from + up_to(count - 1) : NULL;
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
#ifdef MIP_PARSER_FAST
    __CPROVER_assume(state.missing == 0);
#endif
}

/* A round of look_behind() begins, which changes nothing but its place. */
static void look_round(size_t *place) {
    __CPROVER_assume(*place == 1);
    *place = nondet_size();
    __CPROVER_assume(*place >= 1 && *place < state.length);
}

/* A round of a copy begins; it is the same for each. */
static void copy_round(size_t *place, size_t each, size_t all) {
    __CPROVER_assume(*place == 0);
    *place = up_to(all);
    __CPROVER_assume(*place + each <= all);
}

/* A round of the scan begins, while the buffer is empty: with a candidate at any place of what is left, and the window
 * of any one before it. After a packet there is no further round. */
static void scan_round(const uint8_t **candidate, size_t *left, const uint8_t **begin, const uint8_t **end,
                       bool is_found) {
    static unsigned rounds;
    assert(state.length == 0 && state.done == 0 && *left <= size &&
           (size == 0 || *candidate == piece + (size - *left)));
    assert(total(*left) == (uint16_t)(total_before - (is_found ? packet.size : 0)));
    assert(size == 0 || (piece <= *begin && *begin <= *end && *begin <= *candidate && *end <= piece + size));
    __CPROVER_assume(rounds++ == 0 || is_found);
    if (!is_found) {
        *left = up_to(size);
        state.skipped = nondet_32();
        __CPROVER_assume(total(*left) == total_before);
        if (size > 0) {
            *candidate = piece + (size - *left);
            *end = piece + up_to(size);
            *begin = piece + up_to((size_t)(*end - piece));
            __CPROVER_assume(*begin <= *candidate);
        }
    }
}

/* A round of the loop begins that moves an end of the window up, or down: from any place on the way. The round after
 * the last one ends the loop. */
static void window_round(const uint8_t **place, const uint8_t *goal, unsigned loop) {
    static unsigned rounds[3];
    if (loop < 2 ? *place >= goal : *place <= goal) {
        return;
    }
    __CPROVER_assume(rounds[loop]++ == 0);
    *place = loop < 2 ? goal - up_to((size_t)(goal - *place)) : goal + up_to((size_t)(*place - goal));
}

/* For the macros, in functions that have no such variables. */
static size_t at, left;
static bool found;
static struct {
    const uint8_t *begin, *end;
} window, w;
static bool begin(struct mip_parser *parser, const uint8_t **of, size_t *all, struct mip_packet *found_now);
static const uint8_t *end;

#define for(...)                                                                                        \
    for (__VA_ARGS__)                                                                                   \
        if (IS("mip_parser_look_behind", "size_t at = 1; at < parser->length; at++", #__VA_ARGS__)      \
                ? look_round(&at)                                                                       \
            : IS("copy", "size_t at = 0; at + 16 <= size; at += 16", #__VA_ARGS__) ? copy_round(&at, 16, size) \
            : IS("copy", "size_t i = 0; i < size; i++", #__VA_ARGS__)              ? copy_round(&i, 1, size)   \
                                                                                   : search_round(),    \
            true)
#define while(...)                                                                                      \
    while (IS("scan", "left > 0 && !found", #__VA_ARGS__)                                               \
               ? scan_round((const uint8_t **)&at, &left, &window.begin, &window.end, found)            \
           : IS("sound_again", "w.begin < begin", #__VA_ARGS__)                                         \
               ? window_round(&w.begin, (const uint8_t *)(uintptr_t)begin, 0)                           \
           : IS("sound_again", "w.end < end", #__VA_ARGS__)                                             \
               ? window_round(&w.end, end, (#__VA_ARGS__)[6] == '<' ? 1 : 2)                            \
               : (void)0,                                                                               \
           (__VA_ARGS__))
static size_t i;

/* ------------------------------------------------------------------- calls that are not looked into */

/* Anything that scan(), search() or mip_parser_next() may do, each of which has a proof of its own: it finds a packet, or
 * no byte is left. */
static bool any_call_of(struct mip_parser *parser, const uint8_t **at_now, size_t *unread, struct mip_packet *to) {
    assert(parser == &state && is_state() && *unread <= size && (*unread == 0 || *at_now == piece + (size - *unread)));
    const uint16_t before = total(*unread);
    const bool is_found = nondet_bool();
    any_state();
    const size_t used = is_found ? up_to(*unread) : *unread;
    if (used > 0) {
        *at_now += used;
    }
    *unread -= used;
    if (is_found) {
        to->size = up_to(MIP_MAX_PACKET);
        const bool inside = nondet_bool();
        __CPROVER_assume(to->size >= 6 && (!inside || to->size <= size));
        to->bytes = inside ? piece + up_to(size - to->size) : state.buffer;
    }
    __CPROVER_assume(total(*unread) == (uint16_t)(before - (is_found ? to->size : 0)));
    __CPROVER_assume(is_found || state.done == 0);
    return is_found;
}

/* What mip_parser_examine() may return: the size of a packet that is complete, is not, or is of unknown size. */
static bool is_goal(size_t goal, size_t count) {
    if (goal == 0) {
        return count > 0;
    }
    return count < MIP_HEADER_SIZE ? goal == MIP_HEADER_SIZE
                                   : goal >= MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE && goal <= MIP_MAX_PACKET;
}

/* The same for sound_again(), which says whether bytes have the checksum that follows them. */
static bool any_sound(const uint8_t *bytes, size_t count) {
    assert(__CPROVER_r_ok(bytes, count + MIP_CHECKSUM_SIZE));
    return nondet_bool();
}

/* The same for mip_parser_examine(). */
static size_t any_goal(const uint8_t *bytes, size_t count, struct mip_packet *to) {
    assert(count == 0 || __CPROVER_r_ok(bytes, count));
    const size_t goal = up_to(MIP_MAX_PACKET);
    __CPROVER_assume(is_goal(goal, count));
    if (goal > 0 && goal <= count) {
        to->bytes = bytes;
        to->size = goal;
    }
    return goal;
}

/* Definitions and declarations keep the name; what is replaced is a call, which begins in another way. */
#if REPLACED > 0
#define copy(to, ...) COPY_##to, __VA_ARGS__)
#define COPY_uint8_t copy(uint8_t
#define COPY_parser any_copy(parser
#define sound_again(before, begin, bytes) SOUND_##begin, bytes)
#define SOUND_const sound_again(struct window *before, const
#define SOUND_at any_sound(at
#endif
#ifdef EXAMINED
#define mip_parser_examine(bytes, ...) EXAMINE_##bytes, __VA_ARGS__)
#define EXAMINE_const mip_parser_examine(const
#define EXAMINE_bytes any_goal(bytes
#define EXAMINE_parser any_goal(parser
#endif
#if REPLACED > 1
#define scan(parser, ...) SCAN_##parser, __VA_ARGS__)
#define SCAN_struct scan(struct
#define SCAN_parser any_call_of(parser
#endif
#if REPLACED > 2
#define search(parser, ...) SEARCH_##parser, __VA_ARGS__)
#define SEARCH_struct search(struct
#define SEARCH_parser any_call_of(parser
#endif
#if REPLACED > 3
#define mip_parser_next(parser, ...) NEXT_##parser, __VA_ARGS__)
#define NEXT_struct mip_parser_next(struct
#define NEXT_parser any_call_of(parser
#endif
#define mip_sum any_sum
#include "mip/core/parser.c"
#include "mip/core/parser_fast.c"
#include "mip/core/parser_small.c"
#undef for
#undef while
#undef copy
#undef sound_again
#undef scan
#undef search
#undef mip_parser_next
#undef mip_parser_examine

/* ----------------------------------------------------------------------------------------- proofs */

static void any_call(size_t most) {
    size = up_to(most);
    piece = any_bytes(size);
    data = size > 0 || nondet_bool() ? piece : NULL;
    left_over = size;
    any_state();
    total_before = total(size);
}

/* After a call: a packet in the piece or in the buffer, or no byte is left. */
static void check(bool is_found) {
    assert(is_state());
    assert(total(left_over) == (uint16_t)(total_before - (is_found ? packet.size : 0)));
    if (is_found) {
        assert(packet.size >= 6 && packet.size <= MIP_MAX_PACKET && __CPROVER_r_ok(packet.bytes, packet.size));
        assert(__CPROVER_same_object(packet.bytes, piece) || __CPROVER_same_object(packet.bytes, &state));
    } else {
        assert(left_over == 0 && state.done == 0);
    }
}

static void check_call(bool is_found) {
    assert(left_over <= size && (size == 0 || data == piece + (size - left_over)));
    check(is_found);
}

/* The first state satisfies the invariant. */
void parser_init(void) {
    mip_parser_init(&state);
    assert(is_state() && state.skipped == 0);
}

#ifdef MIP_PARSER_FAST
/* What a parser does with bytes while its buffer is empty. */
void parser_scan(void) {
    any_call(LARGEST);
    state.length = 0;
    state.done = 0;
    total_before = total(size);
    check_call(scan(&state, &data, &left_over, &packet));
}

/* A few bytes are copied into the buffer. */
void parser_copy(void) {
    any_call(MIP_MAX_PACKET);
    const size_t offset = up_to(MIP_MAX_PACKET - size);
    copy(state.buffer + offset, piece, size);
}

/* The window moves on to any later candidate. */
void parser_sum(void) {
    any_call(LARGEST);
    struct window w;
    w.end = piece + up_to(size);
    w.begin = piece + up_to((size_t)(w.end - piece));
    w.sum = nondet_32();
    const size_t count = up_to(MIP_MAX_PACKET);
    __CPROVER_assume(count + MIP_CHECKSUM_SIZE <= size);
    const uint8_t *next = piece + up_to(size - count - MIP_CHECKSUM_SIZE);
    __CPROVER_assume(w.begin <= next);
    sound_again(&w, next, count);
    assert(piece <= w.begin && w.begin <= w.end && w.end <= piece + size && w.begin <= next);
}

/* What it does if a packet in the buffer is not valid. */
void parser_search(void) {
    any_call(LARGEST);
    check_call(search(&state, &data, &left_over, &packet));
}
#endif

void parser_examine(void) {
    size = up_to(LARGEST);
    piece = any_bytes(size);
    const size_t goal = mip_parser_examine(piece, size, &packet);
    assert(is_goal(goal, size));
    assert(goal == 0 || goal > size || (packet.bytes == piece && packet.size == goal));
}

void parser_next(void) {
    any_call(LARGEST);
    check_call(mip_parser_next(&state, &data, &left_over, &packet));
}

void parser_flush(void) {
    any_call(0);
    const bool is_found = mip_parser_flush(&state, &packet);
    check(is_found);
    assert(is_found || state.length == 0);
}
