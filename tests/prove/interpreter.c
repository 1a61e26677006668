/*
 * The interpreter of programs, for any field and any well-formed program (steps.h): it accesses nothing outside the
 * field, the structure and the program. What is proved of one step, in any state that a step can begin in, is proved of
 * programs of any length, and of arrays of any number of items.
 *
 * As in parser.c, loops are proved by induction, with a macro. The program of an item is run by a call of its own,
 * which is replaced by anything that such a call may do: it finds a program of one step that ends it.
 */
#include "any.h"

#include <stddef.h>

/* The product of a count and the size of an item: any function, of which only laws of products are used. */
size_t __CPROVER_uninterpreted_product(size_t count, size_t each);

static size_t product(size_t count, size_t each) {
    const size_t found = __CPROVER_uninterpreted_product(count, each);
    __CPROVER_assume(found <= (size_t)0xFF * 0xFFFF);
    return found;
}
#define PRODUCT product

#include "steps.h"

#include <string.h>

static uint8_t *data; /* of the field, or of the packet */
static size_t room;
static size_t field_size; /* of the structure of the field */

/* Moving numbers has a proof of its own: here they become any. */
uint8_t *mip_move(uint8_t *wire, uint8_t *memory, unsigned kind, size_t count, bool writing) {
    assert(kind >= MIP_KIND_DOUBLE && kind <= MIP_KIND_64);
    const size_t size = (size_t)1 << (kind & 3);
    assert(writing ? __CPROVER_w_ok(wire, count * size) : __CPROVER_r_ok(wire, count * size));
    assert(writing ? __CPROVER_r_ok(memory, count * size) : __CPROVER_w_ok(memory, count * size));
    return wire + count * size;
}

/* ------------------------------------------------------------------------- what the loops do first */

struct stream;
static void step_begins(struct stream *s, const uint8_t **p, uint8_t *base, size_t *times);
static void item_begins(size_t *n, uint8_t **item);
static void case_begins(const uint8_t **program, size_t *cases, size_t size);
static void byte_of_layout_begins(const uint8_t **p, size_t *left);

/* A round for one of several bytes begins; it is the same for each. */
static void byte_begins(size_t *at, size_t count) {
    static unsigned rounds;
    __CPROVER_assume(rounds++ == 0);
    assert(*at == 0);
    *at = nondet_size();
    __CPROVER_assume(*at < count);
}

/* What the macro names in functions that have no such variable. */
static struct stream *s;
static const uint8_t *p, *program;
static uint8_t *base, *item;
static size_t times, n, i, cases, size, left;

#define for(...)                                                                                              \
    for (__VA_ARGS__)                                                                                         \
        if (IS("run", ";;", #__VA_ARGS__)                                     ? step_begins(s, &p, base, &times) \
            : IS("run", "size_t n = of[0] * times; n > 0; n--", #__VA_ARGS__) ? item_begins(&n, &item)           \
            : IS("selected", "; cases > 0; cases--", #__VA_ARGS__)            ? case_begins(&program, &cases, size) \
            : IS("matches", "size_t left = p[3]; left > 0; left--", #__VA_ARGS__) ? byte_of_layout_begins(&p, &left) \
            : IS("run", "size_t i = 0; i < n * size; i++", #__VA_ARGS__) ||                                   \
                    IS("constant", "size_t i = 0; wire != NULL && i < size; i++", #__VA_ARGS__)               \
                ? byte_begins(&i, sizeof(__func__) == sizeof("run") ? n * size : size)                        \
                : (void)0,                                                                                    \
            true)
#include "mip/core/program.c"
#undef for

/* ----------------------------------------------------------------------------------- what may be */

/* What holds of a stream before and after each step. */
static bool is_stream(const struct stream *of) {
    return __CPROVER_same_object(of->at, data) && __CPROVER_same_object(of->end, data) && data <= of->at &&
           of->at <= of->end && of->end <= data + room &&
           (!of->optional || (__CPROVER_same_object(of->mark, data) && data <= of->mark && of->mark <= of->at)) &&
           (!of->cut || of->optional) && (!of->counts || field_size >= 2);
}

static struct stream any_stream(void) {
    struct stream any;
    any.end = data + up_to(room);
    any.at = data + up_to((size_t)(any.end - data));
    any.mark = nondet_bool() ? data + up_to((size_t)(any.at - data)) : NULL;
    any.error = nondet_byte();
    any.required = nondet_byte();
    any.present = nondet_byte();
    any.last = nondet_byte();
    any.writing = nondet_bool();
    any.far = nondet_bool();
    any.counts = nondet_bool();
    any.optional = nondet_bool();
    any.cut = nondet_bool();
    any.stopped = nondet_bool();
    any.absent = nondet_bool();
    __CPROVER_assume(is_stream(&any));
    return any;
}

static bool goes_on(const struct stream *of) {
    return !of->stopped && !of->cut;
}

/* What the steps of one program have in common. */
static bool same_run(const struct stream *a, const struct stream *b) {
    return a->writing == b->writing && a->end == b->end;
}

/* ------------------------------------------------------------------- a run that is not looked into */

static const uint8_t *inner; /* its program, if one is to begin */
static size_t inner_size;    /* of its structure */
static bool inner_whole;     /* is it the program of a field? That may be run again. */

/* Anything that a run may do to the stream. One that fails ends also the run in which it is, which then changes nothing
 * more: only one that succeeds is to be followed. */
static void any_run(struct stream *of, const uint8_t **at, uint8_t *place) {
    static const uint8_t ends[] = {MIP_STEP_END};
    static unsigned runs;
    assert(*at == inner && is_stream(of) && goes_on(of) && __CPROVER_w_ok(place, inner_size));
    __CPROVER_assume(runs++ < 2);
    const struct stream before = *of;
    *of = any_stream();
    __CPROVER_assume(same_run(of, &before));
    __CPROVER_assume(inner_whole || (goes_on(of) && of->far == before.far));
    *at = ends;
}

/* --------------------------------------------------------------------------------------- one step */

static struct surroundings around;
static struct stream first;        /* the stream before the step */
static const uint8_t *code, *next; /* the program from this step on, and where the next step begins */
static uint8_t *structure;

static void step_begins(struct stream *of, const uint8_t **at, uint8_t *place, size_t *count) {
    static unsigned rounds;
    if (inner != NULL) {
        any_run(of, at, place);
        inner = inner_whole ? inner : NULL;
        return;
    }
    if (rounds++ > 0) { /* the next one */
        assert(is_stream(of) && goes_on(of) && same_run(of, &first));
        assert(of->far == first.far || (code[0] == MIP_STEP_FAR && around.whole));
        assert(*at == next && place == structure);
        assert(code[0] == MIP_STEP_COUNTED || code[0] == MIP_STEP_REST ? *count <= code[2] : *count == 1);
        __CPROVER_assume(false);
    }
    *count = around.capacity > 0 ? nondet_byte() : 1;
    __CPROVER_assume(around.capacity == 0 || *count <= around.capacity);
}

/* A round for an item begins: what remains of the array is in the structure. */
static void item_begins(size_t *remaining, uint8_t **at) {
    static unsigned rounds;
    const size_t each = (size_t)code[2] << 8 | code[3];
    if (rounds++ > 0) {
        assert((size_t)(*at - structure) + product(*remaining, each) <= around.size);
        __CPROVER_assume(false);
    }
    const size_t most = around.capacity > 0 ? around.capacity : code[1];
    assert(*remaining <= most && *at == structure + place_at(code + 5, &around));
    __CPROVER_assume(product(*remaining, each) <= product(most, each));
    assert((size_t)(*at - structure) + product(*remaining, each) <= around.size);
    *remaining = up_to(*remaining);
    __CPROVER_assume(*remaining > 0 && product(*remaining, each) == product(*remaining - 1, each) + each);
    *at = structure + up_to(around.size);
    __CPROVER_assume((size_t)(*at - structure) + product(*remaining, each) <= around.size);
    inner = next - code[4];
    inner_size = each;
}

static void case_begins(const uint8_t **at, size_t *remaining, size_t tag) {
    static unsigned rounds;
    static const uint8_t *of;
    static size_t length;
    if (rounds++ > 0) {
        assert(*at == of + length + of[length - 1]);
        __CPROVER_assume(false);
    }
    const size_t behind = up_to(300);
    of = any_bytes(behind);
    length = case_size(of, behind, tag);
    *remaining = up_to(255);
    __CPROVER_assume(length > 0 && *remaining > 0);
    next = of + length;
    *at = of;
}

/* A round for a byte that distinguishes layouts begins. */
static void byte_of_layout_begins(const uint8_t **at, size_t *remaining) {
    static unsigned rounds;
    static size_t before;
    if (rounds++ > 0) {
        assert(*at == code + 2 * (before + 1) && *remaining == code[3] - (before + 1));
        __CPROVER_assume(false);
    }
    assert(*at == code && *remaining == code[3]);
    before = up_to(code[3]);
    *remaining = code[3] - before;
    __CPROVER_assume(*remaining > 0);
    *at = code + 2 * before;
}

/* One step of a program for any structure, from any state. */
static void any_step(bool numbers, bool counted) {
    room = up_to(255);
    data = any_bytes(room);
    field_size = up_to(0xFFFF);
    struct stream of = any_stream();
    __CPROVER_assume(goes_on(&of));
    first = of;
    around.size = up_to(0xFFFF);
    around.far = of.far;
    around.whole = nondet_bool();
    around.capacity = nondet_byte();
    __CPROVER_assume(!around.whole || around.size == field_size);
    structure = any_bytes(around.size);
    const size_t remaining = up_to(600);
    code = any_bytes(remaining);
    const size_t taken = step_size(code, remaining, &around);
    __CPROVER_assume(taken > 0 && (code[0] >= MIP_NUMBERS(MIP_KIND_DOUBLE, 0)) == numbers);
    __CPROVER_assume(!numbers || (around.capacity > 0) == counted);
    next = code + taken + (code[0] == MIP_STEP_EACH ? code[4] : 0);
    __CPROVER_assume(code[0] == MIP_STEP_END || next < code + remaining); /* something follows */
    const bool well = run(&of, code, structure);
    assert(is_stream(&of) && same_run(&of, &first) && (!well || goes_on(&of)));
}

void step_of_numbers(void) {
    any_step(true, false);
}

void step_of_counted_numbers(void) {
    any_step(true, true);
}

void other_step(void) {
    any_step(false, false);
}

static struct mip_codec any_codec(void) {
    struct mip_codec codec;
    room = up_to(255);
    data = any_bytes(room);
    field_size = up_to(0xFFFF);
    codec.size = (uint16_t)field_size;
    inner = codec.program = any_bytes(1);
    inner_size = field_size;
    inner_whole = true;
    return codec;
}

/* The first step of a program tells whether a field has its layout. */
void layout(void) {
    const size_t remaining = up_to(600);
    code = any_bytes(remaining);
    __CPROVER_assume(remaining > 0 && code[0] == MIP_STEP_LAYOUT && step_size(code, remaining, &around) > 0);
    const struct mip_codec codec = {.program = code};
    const uint8_t size = nondet_byte();
    const struct mip_field field = {any_bytes(size), size, nondet_byte(), nondet_byte()};
    matches(&codec, &field);
}

/* A field is read, in as many runs as it needs: the second one has the end that any further one may have. */
void read(void) {
    const struct mip_codec codec = any_codec();
    const struct mip_field field = {data, (uint8_t)up_to(room), nondet_byte(), nondet_byte()};
    size_t rest = 0;
    read_field(&codec, any_bytes(field_size), &field, nondet_bool() ? &rest : NULL);
    assert(rest <= field.size);
}

void write(void) {
    const struct mip_codec codec = any_codec();
    size_t used = 0;
    write_field(&codec, any_bytes(field_size), data, room, &used);
    assert(used <= room);
}
