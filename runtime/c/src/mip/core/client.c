/* The command client. */
#include "mip/client.h"

#include <string.h>

void mip_client_init(struct mip_client *client) {
    memset(client, 0, sizeof(*client));
    client->timeout = MIP_DEFAULT_TIMEOUT;
}

/** Does the test of a response hold for a command? */
static bool holds(const struct mip_response *r, const uint8_t *field) {
    const uint8_t byte = r->at < field[0] ? field[r->at] : 0;
    return r->value == MIP_NOT_ZERO ? byte != 0 : byte == r->value;
}

const struct mip_response *mip_requested(const struct mip_exchange *exchange,
                                         const uint8_t *field) {
    const struct mip_response *const all = exchange->responses;
    for (size_t i = 0; i < exchange->response_count; i++) {
        const struct mip_response *const first = &all[i];
        for (; holds(&all[i], field); i++) {
            if (!all[i].more) {
                return first;
            }
        }
        while (all[i].more) {
            i++;
        }
    }
    return NULL;
}

void mip_client_wait(struct mip_client *client, struct mip_request *request, uint32_t now) {
    const uint32_t longer = request->exchange->timeout * 250U;
    uint32_t timeout = longer > client->timeout ? longer : client->timeout;
    struct mip_request **end = &client->waiting;
    if (timeout > MIP_MAX_TIMEOUT) { /* a longer one would seem to have passed */
        timeout = MIP_MAX_TIMEOUT;
    }
    request->deadline = now + timeout;
    request->behind = client->behind;
    request->result.outcome = MIP_WAITING;
    if (request->asked != NULL && request->asked->descriptor == 0) {
        request->result.outcome = MIP_SENT;
        return;
    }
    while (*end != NULL) {
        end = &(*end)->next;
    }
    *end = request;
}

mip_error mip_command_encode(const struct mip_command *command, const void *value,
                             struct mip_builder *packet) {
    const size_t before = packet->length;
    mip_error error = mip_encode(command->codec, value, packet);
    if (error == MIP_OK && command->has_selector && packet->buffer[before + 2] == 0) {
        packet->length = before;
        packet->buffer[3] = (uint8_t)(before - MIP_HEADER_SIZE);
        error = mip_builder_note(packet, MIP_ERROR_MISSING);
    }
    return error;
}

mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                         struct mip_builder *packet, const struct mip_command *command,
                         const void *value, uint32_t now) {
    const size_t start = packet->length;
    const mip_error error = mip_command_encode(command, value, packet);
    mip_client_cancel(client, request); /* it could still wait for an earlier reply */
    memset(request, 0, sizeof(*request));
    request->exchange = command->exchange;
    if (error == MIP_OK) {
        request->asked = mip_requested(request->exchange, packet->buffer + start);
        mip_client_wait(client, request, now);
    } else {
        request->result.error = (uint8_t)error;
    }
    return error;
}

bool mip_client_expect(struct mip_request *request, const struct mip_codec *codec, void *response) {
    const struct mip_response *r = request->asked;
    bool more =
        r != NULL && codec != NULL && codec->descriptor_set == request->exchange->descriptor_set;
    request->response = NULL;
    for (; more; r++) {
        if (r->descriptor == codec->descriptor && (r->layout == NULL || r->layout == codec)) {
            request->codec = codec;
            request->response = response;
            return true;
        }
        more = r->more;
    }
    return false;
}

mip_error mip_client_send(struct mip_client *client, struct mip_request *request,
                          struct mip_builder *packet, const struct mip_command *command,
                          const void *value, const struct mip_codec *codec, void *response,
                          uint32_t now) {
    const mip_error error = mip_client_add(client, request, packet, command, value, now);
    if (response != NULL) {
        memset(response, 0, codec->size);
        mip_client_expect(request, codec, response);
    }
    return error;
}

/** Returns the outcome of a request after a response to its command, which then takes the place of
 * `field`; it still waits if it has requested another response. */
static enum mip_outcome respond(struct mip_request *request, const struct mip_field *behind,
                                struct mip_field *field) {
    const struct mip_response *r = request->asked;
    while (r->descriptor != behind->descriptor ||
           (r->layout != NULL && !mip_codec_matches(r->layout, behind))) {
        if (!r->more) {
            return MIP_WAITING;
        }
        r++;
    }
    if (request->response != NULL) {
        const mip_error error = mip_decode(request->codec, request->response, behind, NULL);
        if (error == MIP_ERROR_CONSTANT) {
            return MIP_WAITING; /* it answers something else */
        }
        request->result.error = (uint8_t)error;
        request->result.responded = error == MIP_OK;
    }
    if (r->layout != NULL && !request->result.responded) {
        request->codec = r->layout;
    }
    *field = *behind;
    return request->result.error != MIP_OK ? MIP_UNDECODABLE : MIP_ACKNOWLEDGED;
}

/** Returns the outcome of a request after an acknowledge of its command, with a code, and the field
 * after that. */
static enum mip_outcome judge(struct mip_request *request, uint8_t code,
                              const struct mip_field *behind, struct mip_field *field) {
    const struct mip_response *r = request->exchange->responses;
    if (code != 0) {
        return MIP_REFUSED;
    }
    for (size_t left = request->exchange->response_count; left > 0; left--) {
        if (r->descriptor == behind->descriptor) {
            return request->asked != NULL ? respond(request, behind, field) : MIP_WAITING;
        }
        r++;
    }
    return request->asked != NULL ? MIP_MISSING_RESPONSE : MIP_ACKNOWLEDGED;
}

/** Removes a request from the waiting list. */
static void leave(struct mip_request **at, enum mip_outcome outcome) {
    struct mip_request *request = *at;
    *at = request->next;
    request->result.outcome = outcome;
}

/*
 * An acknowledge field and the field after it (`behind`) answer the oldest request of that command.
 * A response is never matched to a request that does not expect it, because it may be the late
 * reply to another one. An acknowledge without a response is matched first to requests that expect
 * none.
 */
struct mip_request *mip_client_match(struct mip_client *client, const uint8_t *end,
                                     struct mip_field *field) {
    struct mip_request **found = NULL;
    struct mip_request *r;
    enum mip_outcome outcome = MIP_WAITING;
    const uint8_t *const next = field->data + field->size;
    if (field->size < 2) {
        return NULL;
    }
    const uint8_t descriptor = field->data[0];
    const uint8_t code = field->data[1];
    struct mip_field behind = *field; /* without a field, there is no response */
    mip_field_at(&behind, next, (size_t)(end - next));
    for (struct mip_request **at = &client->waiting; (r = *at) != NULL; at = &r->next) {
        if (r->behind != 0 || r->exchange->descriptor != descriptor ||
            r->exchange->descriptor_set != field->descriptor_set) {
            continue;
        }
        const enum mip_outcome judged = judge(r, code, &behind, field);
        if (judged == MIP_WAITING || judged == outcome) {
            continue; /* if several lack their response, the first counts */
        }
        found = at;
        outcome = judged;
        if (outcome != MIP_MISSING_RESPONSE) {
            break;
        }
    }
    if (found != NULL) {
        r = *found;
        r->result.code = code;
        leave(found, outcome);
    }
    return r;
}

/** The payload size of the reply to the shortest barrier; a single command is not a barrier. */
#define FIRST_BARRIER 8

void mip_client_miss(struct mip_client *client) {
    const uint8_t next = (uint8_t)(client->missed + 4);
    client->missed = next < FIRST_BARRIER ? FIRST_BARRIER : next; /* also after the longest */
}

size_t mip_client_barrier(struct mip_client *client, uint8_t *bytes) {
    if (MIP_BARRIER_SET == 0 || client->behind == client->missed) {
        return 0;
    }
    for (const struct mip_request *r = client->waiting; r != NULL; r = r->next) {
        mip_client_miss(client); /* they may be the same commands as in a barrier */
    }
    client->behind = client->missed;
    const size_t size = client->behind / 2U;
    uint8_t *at = bytes + MIP_HEADER_SIZE;
    for (size_t left = size; left > 0; left -= 2) {
        *at++ = 2;
        *at++ = MIP_BARRIER_DESCRIPTOR;
    }
    return mip_packet_seal(bytes, MIP_BARRIER_SET, size);
}

bool mip_client_passes(struct mip_client *client, const struct mip_packet *packet) {
    const uint8_t size = client->behind;
    const uint8_t *field = packet->bytes;
    const uint32_t answer = /* for each command: length, descriptor, echoed descriptor */
        UINT32_C(0x40000) + MIP_ACKNOWLEDGE_DESCRIPTOR * 256U + MIP_BARRIER_DESCRIPTOR;
    if (MIP_BARRIER_SET == 0 || size == 0 || packet->descriptor_set != MIP_BARRIER_SET ||
        packet->bytes[3] != size) {
        return false;
    }
    for (size_t left = size; left > 0; left -= 4) { /* with any code */
        field += 4;
        if (mip_get_32(field) >> 8 != answer) {
            return false;
        }
    }
    client->behind = 0;
    if (client->missed == size) {
        client->missed = 0;
    }
    for (struct mip_request **at = &client->waiting; *at != NULL;) {
        if ((*at)->behind != size) {
            leave(at, MIP_TIMED_OUT); /* replies are in order, so it has none */
        } else {
            (*at)->behind = 0;
            at = &(*at)->next;
        }
    }
    return true;
}

size_t mip_client_start(struct mip_client *client, struct mip_builder *packet, uint8_t *bytes,
                        uint8_t descriptor_set) {
    const size_t size = mip_client_barrier(client, bytes);
    (void)mip_builder_start(packet, bytes + size, MIP_MAX_PACKET, descriptor_set);
    return size;
}

/** Matches the fields of a packet to requests. */
static bool receive(struct mip_client *client, const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_request *request;
    struct mip_field field;
    bool answered = false;
    while (client->waiting != NULL && mip_client_next(client, &walk, &request, &field)) {
        answered = answered || request != NULL;
    }
    return answered;
}

bool mip_client_receive(struct mip_client *client, const struct mip_packet *packet) {
    return !mip_client_passes(client, packet) && receive(client, packet);
}

bool mip_client_step(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                     const uint8_t **data, size_t *size, struct mip_packet *packet) {
    while (mip_parser_next(parser, data, size, packet) ||
           mip_client_poll(client, parser, now, packet)) {
        if (!mip_client_passes(client, packet)) {
            receive(client, packet);
            return true;
        }
    }
    return false;
}

static bool is_late(const struct mip_request *request, uint32_t now) {
    return (uint32_t)(now - request->deadline) <= MIP_MAX_TIMEOUT; /* the time may wrap around */
}

/** Removes a request whose reply may still arrive. */
MIP_APART void give_up(struct mip_client *client, struct mip_request **at,
                       enum mip_outcome outcome) {
    leave(at, outcome);
    mip_client_miss(client);
}

bool mip_client_poll(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                     struct mip_packet *packet) {
    for (struct mip_request **at = &client->waiting; *at != NULL;) {
        if (!is_late(*at, now)) {
            at = &(*at)->next;
        } else if (parser != NULL && mip_parser_look_behind(parser, packet)) {
            return true; /* noise may hide a reply; the part of the next packet is kept */
        } else {
            give_up(client, at, MIP_TIMED_OUT);
#ifdef MIP_DIAGNOSTICS
            client->timeouts++;
#endif
        }
    }
    return false;
}

void mip_client_cancel(struct mip_client *client, struct mip_request *request) {
    struct mip_request **at = &client->waiting;
    while (*at != NULL && *at != request) {
        at = &(*at)->next;
    }
    if (*at != NULL) {
        give_up(client, at, MIP_CLOSED);
    }
}
