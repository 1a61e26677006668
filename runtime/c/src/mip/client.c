/* The command client. */
#include "mip/client.h"

#include <string.h>

void mip_client_init(struct mip_client *client) {
    client->waiting = NULL;
    client->timeout = MIP_DEFAULT_TIMEOUT;
}

/** Does the data of a command fulfil a condition? */
static bool holds(const uint8_t *condition, const uint8_t *data, size_t size) {
    bool all = true;
    for (; *condition != MIP_WHEN_END; condition += 3) {
        const uint8_t byte = condition[1] < size ? data[condition[1]] : 0;
        if (*condition == 3) {
            if (all) {
                break;
            }
            all = true;
        } else if (*condition == 2 ? byte == 0 : byte != condition[2]) {
            all = false;
        }
    }
    return all;
}

/** The next response under the same condition: another layout. */
static const struct mip_response *another(const struct mip_response *r) {
    const struct mip_response *next = r + 1;
    return next->descriptor != 0 && next->asked == r->asked ? next : NULL;
}

void mip_client_wait(struct mip_client *client, struct mip_request *request,
                     const struct mip_builder *packet, const struct mip_exchange *exchange,
                     size_t size, uint32_t now) {
    const uint8_t *data = packet->buffer + packet->length - size;
    const struct mip_response *r = exchange->responses;
    uint32_t timeout = exchange->timeout > client->timeout ? exchange->timeout : client->timeout;
    struct mip_request **end = &client->waiting;
    if (timeout > MIP_MAX_TIMEOUT) { /* or it would seem to be over */
        timeout = MIP_MAX_TIMEOUT;
    }
    while (r != NULL && r->descriptor != 0 && r->asked != NULL && !holds(r->asked, data, size)) {
        r++;
    }
    mip_client_cancel(client, request); /* it could still wait for an earlier answer */
    memset(request, 0, sizeof(*request));
    request->descriptor_set = packet->buffer[2];
    request->exchange = exchange;
    request->asked = r != NULL && r->descriptor != 0 ? r : NULL;
    request->deadline = now + timeout;
    if (exchange->silent != NULL && holds(exchange->silent, data, size)) {
        request->state = MIP_REQUEST_SILENT;
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
    if (error == MIP_OK && command->exchange->selects && packet->buffer[before + 2] == 0) {
        packet->length = before;
        packet->buffer[3] = (uint8_t)(before - MIP_HEADER_SIZE);
        error = mip_builder_note(packet, MIP_ERROR_MISSING);
    }
    return error;
}

mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                         struct mip_builder *packet, const struct mip_command *command,
                         const void *value, uint32_t now) {
    const size_t start = packet->length + 2;
    const mip_error error = mip_command_encode(command, value, packet);
    if (error == MIP_OK) {
        mip_client_wait(client, request, packet, command->exchange, packet->length - start, now);
    } else {
        mip_client_cancel(client, request);
        memset(request, 0, sizeof(*request));
        request->state = MIP_REQUEST_CANCELLED;
    }
    return error;
}

bool mip_client_expect(struct mip_request *request, const struct mip_codec *codec, void *response) {
    request->response = NULL;
    for (const struct mip_response *r = request->asked; r != NULL; r = another(r)) {
        if (codec != NULL && r->descriptor == codec->descriptor &&
            codec->descriptor_set == request->descriptor_set &&
            (r->layout == NULL || r->layout == codec)) {
            request->codec = codec;
            request->response = response;
            return true;
        }
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

/** Is this field a response to the command, for any values of the command? */
static bool may_answer(const struct mip_exchange *exchange, uint8_t descriptor) {
    const struct mip_response *r = exchange->responses;
    while (r != NULL && r->descriptor != 0 && r->descriptor != descriptor) {
        r++;
    }
    return r != NULL && r->descriptor != 0;
}

/** Decodes the response that a request expects. False if the field is not that response. */
static bool respond(struct mip_request *request, const struct mip_field *field) {
    const struct mip_response *r = request->asked;
    while (r != NULL && (r->descriptor != field->descriptor ||
                         (r->layout != NULL && !mip_codec_matches(r->layout, field)))) {
        r = another(r);
    }
    if (r == NULL) {
        return false;
    }
    if (request->response != NULL) {
        const mip_error error = mip_decode(request->codec, request->response, field, NULL);
        if (error == MIP_ERROR_CONSTANT) {
            return false; /* it answers something else */
        }
        request->error = (uint8_t)error;
        request->responded = error == MIP_OK;
    }
    if (r->layout != NULL) {
        request->codec = r->layout;
    }
    return true;
}

/** Removes a request from the waiting list. */
static void leave(struct mip_request **at, uint8_t state) {
    struct mip_request *request = *at;
    *at = request->next;
    request->next = NULL;
    request->state = state;
}

/*
 * An acknowledge field and the field after it (`behind`) answer the oldest request of that command.
 * A response never answers a request that does not expect it, because it may be the late answer to
 * another one; an acknowledge without a response first answers requests that expect none.
 */
bool mip_client_next(struct mip_client *client, struct mip_walk *walk,
                     struct mip_request **answered, struct mip_field *field) {
    struct mip_request **found = NULL;
    struct mip_request *r;
    struct mip_field behind;
    uint8_t state = MIP_REQUEST_MISSING_RESPONSE;
    *answered = NULL;
    if (!mip_walk_next(walk, field)) {
        return false;
    }
    if (field->descriptor != MIP_ACKNOWLEDGE_DESCRIPTOR || field->size < 2) {
        return true;
    }
    struct mip_walk ahead = *walk;
    if (!mip_walk_next(&ahead, &behind)) {
        behind.descriptor = 0;
    }
    for (struct mip_request **at = &client->waiting; (r = *at) != NULL; at = &r->next) {
        if (r->exchange->descriptor != field->data[0] ||
            r->descriptor_set != field->descriptor_set) {
            continue;
        }
        const bool response = may_answer(r->exchange, behind.descriptor);
        if (field->data[1] != 0) {
            state = MIP_REQUEST_REFUSED;
        } else if (r->asked == NULL ? !response : response && respond(r, &behind)) {
            state = r->error != MIP_OK ? MIP_REQUEST_UNDECODABLE : MIP_REQUEST_ACKNOWLEDGED;
        } else {
            if (!response && found == NULL) {
                found = at;
            }
            continue;
        }
        found = at;
        break;
    }
    if (found == NULL) {
        return true;
    }
    r = *found;
    leave(found, state);
    r->code = field->data[1];
    if (r->asked != NULL &&
        (state == MIP_REQUEST_ACKNOWLEDGED || state == MIP_REQUEST_UNDECODABLE)) {
        *walk = ahead; /* after the response */
        *field = behind;
    }
    *answered = r;
    return true;
}

bool mip_client_receive(struct mip_client *client, const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_request *request;
    struct mip_field field;
    bool answered = false;
    while (mip_client_next(client, &walk, &request, &field)) {
        answered = answered || request != NULL;
    }
    return answered;
}

static bool is_late(const struct mip_request *request, uint32_t now) {
    return (uint32_t)(now - request->deadline) <= MIP_MAX_TIMEOUT; /* the time may wrap around */
}

bool mip_client_poll(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                     struct mip_packet *packet) {
    const uint8_t *nothing = NULL;
    size_t none = 0;
    bool late = false;
    for (const struct mip_request *r = client->waiting; r != NULL; r = r->next) {
        late = late || is_late(r, now);
    }
    /* Noise may hide an answer; the part of the next packet that has arrived is kept. */
    if (parser != NULL && (late ? mip_parser_look_behind(parser, packet)
                                : mip_parser_next(parser, &nothing, &none, packet))) {
        return true;
    }
    for (struct mip_request **at = &client->waiting; *at != NULL;) {
        if (is_late(*at, now)) {
            leave(at, MIP_REQUEST_TIMED_OUT);
        } else {
            at = &(*at)->next;
        }
    }
    return false;
}

void mip_client_cancel(struct mip_client *client, struct mip_request *request) {
    for (struct mip_request **at = &client->waiting; *at != NULL; at = &(*at)->next) {
        if (*at == request) {
            leave(at, MIP_REQUEST_CANCELLED);
            break;
        }
    }
}
