/*
 * The client: one event, in any state with up to three requests that wait. It accesses nothing outside its
 * arguments and leaves such a state again: a list of requests that wait, in their order, less those that left it.
 * Each set of waiting requests is a branch of its own, so that the prover knows the list before the event.
 *
 * The functions of the parser, the walk and the codec that it calls may do anything that has been proved of them.
 */
#include "any.h"

#include "mip/core.h"

static bool any_walk_next(struct mip_walk *walk, struct mip_field *field);
static size_t any_field_at(struct mip_field *field, const uint8_t *at, size_t left);
#define mip_walk_next any_walk_next
#define mip_field_at any_field_at
#include "mip/core/client.c"

#define REQUESTS 3
#define RESPONSES 2

struct mip_request nondet_request(void);
struct mip_response nondet_response(void);
struct mip_exchange nondet_exchange(void);

static struct mip_codec codec;
static uint8_t response; /* where all responses are stored */
static struct mip_response responses[REQUESTS][RESPONSES];
static struct mip_exchange exchanges[REQUESTS];
/* Separate objects: the prover would treat an array as a whole. */
static struct mip_request first, second, third;
static struct mip_request *const requests[REQUESTS] = {&first, &second, &third};
static struct mip_client client;

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    assert(__CPROVER_w_ok(parser, sizeof(*parser)) && __CPROVER_w_ok(packet, sizeof(*packet)));
    return nondet_bool();
}

size_t mip_packet_seal(uint8_t *bytes, uint8_t set, size_t size) {
    assert(set != 0 && __CPROVER_w_ok(bytes, size + 6));
    return size + 6;
}

/* Goes to a field of any bytes, or to none, which changes nothing. */
static bool any_walk_next(struct mip_walk *walk, struct mip_field *field) {
    assert(__CPROVER_w_ok(walk, sizeof(*walk)) && __CPROVER_w_ok(field, sizeof(*field)));
    if (nondet_bool()) {
        return false;
    }
    field->size = (uint8_t)up_to(253);
    field->data = any_bytes(field->size);
    field->descriptor = nondet_byte();
    field->descriptor_set = nondet_byte();
    walk->end = field->data + field->size;
    return true;
}

/* Finds a field of any bytes, or none, which changes nothing. */
static size_t any_field_at(struct mip_field *field, const uint8_t *at, size_t left) {
    struct mip_walk walk;
    (void)at, (void)left;
    return any_walk_next(&walk, field) ? 2U + field->size : 0;
}

bool mip_codec_matches(const struct mip_codec *of, const struct mip_field *field) {
    assert(of == &codec && __CPROVER_r_ok(field->data, field->size));
    return nondet_bool();
}

mip_error mip_decode(const struct mip_codec *of, void *value, const struct mip_field *field, size_t *trailing) {
    assert(of == &codec && value == &response && trailing == NULL && __CPROVER_r_ok(field->data, field->size));
    return (mip_error)up_to(MIP_ERROR_LAYOUT);
}

/* The command that begins at `length` has this many bytes; one that selects a function has it in the third. */
static bool has_selector;
mip_error mip_encode(const struct mip_codec *of, const void *value, struct mip_builder *packet) {
    const size_t size = up_to(packet->capacity - MIP_CHECKSUM_SIZE - packet->length);
    assert(of == &codec && value == &response);
    if (nondet_bool() || size < (has_selector ? 3 : 2) || size > 255) {
        return MIP_ERROR_LENGTH;
    }
    packet->buffer[packet->length] = (uint8_t)size;
    packet->length += size;
    return MIP_OK;
}

/* A barrier is represented by the payload size of its reply: none, or at least two commands. */
static bool is_barrier(uint8_t payload) {
    return payload == 0 || (payload >= FIRST_BARRIER && payload <= 252 && payload % 4 == 0);
}

/* Any state in which the requests with a bit in `waiting` wait. */
static void any_state(unsigned waiting) {
    client.waiting = NULL;
    client.timeout = nondet_32();
    client.missed = nondet_byte();
    client.behind = nondet_byte();
    __CPROVER_assume(is_barrier(client.missed) && is_barrier(client.behind));
    for (size_t i = REQUESTS; i-- > 0;) {
        for (size_t j = 0; j < RESPONSES; j++) {
            responses[i][j] = nondet_response();
            responses[i][j].layout = nondet_bool() ? &codec : NULL;
        }
        responses[i][RESPONSES - 1].more = false;
        exchanges[i] = nondet_exchange();
        exchanges[i].responses = responses[i];
        __CPROVER_assume(exchanges[i].response_count <= RESPONSES);
        if (exchanges[i].response_count > 0) {
            responses[i][exchanges[i].response_count - 1].more = false;
        }
        *requests[i] = nondet_request();
        requests[i]->exchange = &exchanges[i];
        const size_t asked = up_to(exchanges[i].response_count);
        requests[i]->asked = asked < exchanges[i].response_count ? &responses[i][asked] : NULL;
        requests[i]->codec = &codec;
        requests[i]->response = nondet_bool() ? &response : NULL;
        requests[i]->result.error = MIP_OK;
        requests[i]->next = client.waiting;
        if ((waiting >> i & 1U) != 0) {
            requests[i]->result.outcome = MIP_WAITING;
            client.waiting = requests[i];
        }
    }
}

/* The requests that are left wait, in their order. */
static void check(void) {
    assert(is_barrier(client.missed) && is_barrier(client.behind));
    const struct mip_request *r = client.waiting;
    for (size_t i = 0; i < REQUESTS; i++) {
        if (r == requests[i]) {
            assert(r->result.outcome == MIP_WAITING);
            r = r->next;
        }
    }
    assert(r == NULL);
}

/* Time passes. */
static void poll(void) {
    struct mip_parser parser;
    struct mip_packet packet;
    const uint32_t now = nondet_32();
    if (!mip_client_poll(&client, nondet_bool() ? &parser : NULL, now, &packet)) {
        for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
            assert((uint32_t)(now - r->deadline) > MIP_MAX_TIMEOUT);
        }
    }
}

/* A request is cancelled, whether it waits or not. */
static void cancel(void) {
    struct mip_request *request = requests[up_to(REQUESTS - 1)];
    mip_client_cancel(&client, request);
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        assert(r != request);
    }
}

/* A request begins to wait. */
static void wait(void) {
    const size_t last = REQUESTS - 1;
    __CPROVER_assume(requests[last]->result.outcome != MIP_WAITING);
    requests[last]->result.outcome = MIP_WAITING;
    requests[last]->next = NULL;
    mip_client_wait(&client, requests[last], nondet_32());
}

/* A barrier is written. */
static void barrier(void) {
    uint8_t bytes[MIP_MAX_BARRIER];
    const size_t size = mip_client_barrier(&client, bytes);
    assert(size <= sizeof(bytes));
}

/* A packet arrives that may be the answer of the barrier. */
static void passes(void) {
    uint8_t bytes[MIP_MAX_PACKET];
    const struct mip_packet packet = {bytes, (uint16_t)(bytes[3] + 6U), nondet_byte()};
    const uint8_t behind = client.behind;
    if (mip_client_passes(&client, &packet)) {
        assert(behind != 0 && bytes[3] == behind && client.behind == 0);
    } else {
        assert(client.behind == behind);
    }
}

/* Is a field an acknowledge of the command of this request, which waits for no barrier? */
static bool is_about(const struct mip_request *request, const struct mip_field *field) {
    return request->behind == 0 && request->exchange->descriptor == field->data[0] &&
           request->exchange->descriptor_set == field->descriptor_set;
}

/* A field arrives, and perhaps one behind it. */
static void next(void) {
    struct mip_walk walk;
    struct mip_field field;
    struct mip_request *answered = &first;
    const bool found = mip_client_next(&client, &walk, &answered, &field);
    assert(found || answered == NULL);
    if (answered == NULL) {
        return;
    }
    assert(answered->result.outcome == MIP_ACKNOWLEDGED || answered->result.outcome == MIP_REFUSED ||
           answered->result.outcome == MIP_MISSING_RESPONSE || answered->result.outcome == MIP_UNDECODABLE);
    assert((answered->result.outcome == MIP_REFUSED) == (answered->result.code != 0));
    assert(answered->result.outcome != MIP_REFUSED || is_about(answered, &field));
    const struct mip_request *r = client.waiting;
    for (size_t i = 0; requests[i] != answered; i++) {
        if (r == requests[i]) {
            assert(answered->result.outcome != MIP_REFUSED || !is_about(r, &field)); /* the oldest is refused */
            r = r->next;
        }
    }
}

#define IN_ANY_STATE(event)                                               \
    void client_##event(void) {                                           \
        for (unsigned waiting = 0; waiting < 1U << REQUESTS; waiting++) { \
            if (nondet_bool()) {                                          \
                any_state(waiting);                                       \
                event();                                                  \
                check();                                                  \
                __CPROVER_assume(false);                                  \
            }                                                             \
        }                                                                 \
    }

IN_ANY_STATE(poll)
IN_ANY_STATE(passes)
IN_ANY_STATE(next)
IN_ANY_STATE(cancel)
IN_ANY_STATE(wait)
IN_ANY_STATE(barrier)

/* A command is added to a packet. Its request waits already, or not; that it is removed from a longer list, and added to
 * one, has proofs of its own. */
void client_add(void) {
    any_state(nondet_bool() ? 1U << (REQUESTS - 1) : 0);
    struct mip_request *request = requests[REQUESTS - 1];
    const struct mip_command command = {&codec, request->exchange, has_selector = nondet_bool()};
    const size_t capacity = up_to(MIP_MAX_PACKET);
    struct mip_builder packet;
    __CPROVER_assume(mip_builder_start(&packet, any_bytes(capacity), capacity, nondet_byte()) == MIP_OK);
    packet.length += up_to(packet.capacity - MIP_CHECKSUM_SIZE - packet.length);
    const size_t before = packet.length;
    const mip_error error = mip_client_add(&client, request, &packet, &command, &response, nondet_32());
    assert(error == MIP_OK ? packet.length > before : packet.length == before);
    assert((error == MIP_OK) == (request->result.outcome == MIP_WAITING || request->result.outcome == MIP_SENT));
    mip_client_expect(request, &codec, nondet_bool() ? &response : NULL);
    check();
}
