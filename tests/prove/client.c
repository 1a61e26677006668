/*
 * The client: one event, in any state with up to three requests that wait. It accesses nothing outside its
 * arguments and leaves such a state again: a list of requests that wait, in their order, less those that left it.
 *
 * What it calls of the parser is any that its contract allows.
 */
#include "mip/client.c"

#include <assert.h>
#include <stdlib.h>

#define REQUESTS 3
#define RESPONSES 2

size_t nondet_size(void);
uint8_t nondet_byte(void);
uint32_t nondet_32(void);
_Bool nondet_bool(void);
struct mip_request nondet_request(void);
struct mip_response nondet_response(void);
struct mip_exchange nondet_exchange(void);

static struct mip_codec codec;
static struct mip_response responses[REQUESTS][RESPONSES];
static struct mip_exchange exchanges[REQUESTS];
static struct mip_request requests[REQUESTS];
static struct mip_client client;

bool mip_parser_look_behind(struct mip_parser *parser, struct mip_packet *packet) {
    assert(__CPROVER_w_ok(parser, sizeof(*parser)) && __CPROVER_w_ok(packet, sizeof(*packet)));
    return nondet_bool();
}

size_t mip_packet_seal(uint8_t *bytes, uint8_t set, size_t size) {
    assert(set != 0 && __CPROVER_w_ok(bytes, size + 6));
    return size + 6;
}

static size_t up_to(size_t most) {
    const size_t any = nondet_size();
    __CPROVER_assume(any <= most);
    return any;
}

/* A barrier is the payload of its answer: none, or at least two commands. */
static bool is_barrier(uint8_t payload) {
    return payload == 0 || (payload >= FIRST_BARRIER && payload <= 252 && payload % 4 == 0);
}

static void any_state(void) {
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
        requests[i] = nondet_request();
        requests[i].exchange = &exchanges[i];
        const size_t asked = up_to(exchanges[i].response_count);
        requests[i].asked = asked < exchanges[i].response_count ? &responses[i][asked] : NULL;
        requests[i].codec = &codec;
            requests[i].next = client.waiting;
        if (nondet_bool()) {
            requests[i].state = MIP_REQUEST_WAITING;
            client.waiting = &requests[i];
        }
    }
}

/* Those that are left wait and keep their order. */
static void check(void) {
    assert(is_barrier(client.missed) && is_barrier(client.behind));
    const struct mip_request *before = NULL;
    size_t count = 0;
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        assert(__CPROVER_same_object(r, requests) && (before == NULL || r > before));
        assert(r->state == MIP_REQUEST_WAITING);
        before = r;
        count++;
        assert(count <= REQUESTS);
    }
}

/* Time passes. */
void client_poll(void) {
    struct mip_parser parser;
    struct mip_packet packet;
    any_state();
    const uint32_t now = nondet_32();
    if (!mip_client_poll(&client, nondet_bool() ? &parser : NULL, now, &packet)) {
        for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
            assert((uint32_t)(now - r->deadline) > MIP_MAX_TIMEOUT);
        }
    }
    check();
}

/* A request is cancelled, whether it waits or not. */
void client_cancel(void) {
    any_state();
    struct mip_request *request = &requests[up_to(REQUESTS - 1)];
    mip_client_cancel(&client, request);
    check();
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        assert(r != request);
    }
}

/* A request begins to wait. */
void client_wait(void) {
    any_state();
    const size_t last = REQUESTS - 1;
    __CPROVER_assume(requests[last].state != MIP_REQUEST_WAITING);
    requests[last].state = MIP_REQUEST_WAITING;
    requests[last].next = NULL;
    mip_client_wait(&client, &requests[last], nondet_32());
    check();
}

/* A barrier is written. */
void client_barrier(void) {
    uint8_t bytes[MIP_MAX_BARRIER];
    any_state();
    const size_t size = mip_client_barrier(&client, bytes);
    assert(size <= sizeof(bytes));
    check();
}
