/* The command client. */
#include "mip/client.h"

#include <string.h>

void mip_client_init(struct mip_client *client) {
    client->waiting = NULL;
    client->timeout = MIP_DEFAULT_TIMEOUT;
}

/** The first response that a command with these values requests; NULL if it requests none. */
static const struct mip_response *wanted(const struct mip_command *command, const void *value) {
    const struct mip_response *r = command->responses;
    while (r != NULL && r->codec != NULL && r->asked != NULL && !r->asked(value)) {
        r++;
    }
    return r != NULL && r->codec != NULL ? r : NULL;
}

/** Those that it requests under the same condition: the layouts that the response may have. */
static const struct mip_response *another(const struct mip_response *r) {
    const struct mip_response *next = r + 1;
    while (next->codec != NULL && next->asked != r->asked) {
        next++;
    }
    return next->codec != NULL ? next : NULL;
}

mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                         struct mip_builder *packet, const struct mip_command *command,
                         const void *value, uint32_t now) {
    const mip_error error = mip_encode(command->codec, value, packet);
    uint32_t timeout = command->timeout > client->timeout ? command->timeout : client->timeout;
    if (timeout > MIP_MAX_TIMEOUT) { /* or it would seem to be over */
        timeout = MIP_MAX_TIMEOUT;
    }
    mip_client_cancel(client, request);     /* it could still wait for an earlier answer */
    request->state = MIP_REQUEST_CANCELLED; /* so that it does not wait if there is an error */
    request->code = 0;
    request->responded = false;
    request->error = MIP_OK;
    request->command = command;
    request->asked = error == MIP_OK ? wanted(command, value) : NULL;
    request->codec = request->asked != NULL ? request->asked->codec : NULL;
    request->response = NULL;
    request->deadline = now + timeout;
    request->next = NULL;
    if (error != MIP_OK) {
        return error;
    }
    if (command->silent != NULL && command->silent(value)) {
        request->state = MIP_REQUEST_SILENT;
        return MIP_OK;
    }
    request->state = MIP_REQUEST_WAITING;
    struct mip_request **end = &client->waiting;
    while (*end != NULL) {
        end = &(*end)->next;
    }
    *end = request;
    return MIP_OK;
}

bool mip_client_expect(struct mip_request *request, const struct mip_codec *codec, void *response) {
    request->response = NULL;
    for (const struct mip_response *r = request->asked; r != NULL; r = another(r)) {
        if (r->codec == codec) {
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

/** Removes a request from the waiting list. */
static void leave(struct mip_client *client, struct mip_request *request, uint8_t state) {
    for (struct mip_request **at = &client->waiting; *at != NULL; at = &(*at)->next) {
        if (*at == request) {
            *at = request->next;
            request->next = NULL;
            request->state = state;
            return;
        }
    }
}

/** Is this field a response to the command, for any values of the command? */
static bool may_answer(const struct mip_command *command, const struct mip_field *field) {
    for (const struct mip_response *r = command->responses; r != NULL && r->codec != NULL; r++) {
        if (r->codec->descriptor == field->descriptor) {
            return true;
        }
    }
    return false;
}

/** Decodes the response that a request expects. False if the field is not that response. */
static bool respond(struct mip_request *request, const struct mip_field *field) {
    const struct mip_response *r = request->asked;
    while (r != NULL &&
           (r->codec->descriptor != field->descriptor || !mip_codec_matches(r->codec, field))) {
        r = another(r);
    }
    if (r == NULL) {
        return false;
    }
    if (request->response == NULL) {
        request->codec = r->codec;
        return true;
    }
    mip_error error = MIP_ERROR_LAYOUT;
    if (r->codec == request->codec) {
        error = mip_decode(r->codec, request->response, field, NULL);
    } else {
        memset(request->response, 0, request->codec->size);
    }
    if (error == MIP_ERROR_CONSTANT) {
        return false; /* it answers something else */
    }
    request->codec = r->codec;
    request->error = (uint8_t)error;
    request->responded = error == MIP_OK;
    return true;
}

/**
 * Finds the request that an acknowledge field and the field after it (NULL if there is none)
 * answer: the oldest one of that command. A response never answers a request that does not expect
 * it, because it may be the late answer to another one; an acknowledge without a response first
 * answers requests that expect none. `state` becomes the new state of the request.
 */
static struct mip_request *find(const struct mip_client *client, uint8_t set,
                                const struct mip_protocol_acknowledge *acknowledge,
                                const struct mip_field *behind, uint8_t *state) {
    struct mip_request *left_alone = NULL;
    for (struct mip_request *r = client->waiting; r != NULL; r = r->next) {
        if (r->command->codec->descriptor != acknowledge->command ||
            !mip_codec_belongs(r->command->codec, set)) {
            continue;
        }
        if (acknowledge->code != 0) {
            *state = MIP_REQUEST_REFUSED;
            return r;
        }
        const bool response = behind != NULL && may_answer(r->command, behind);
        if (r->codec == NULL ? !response : response && respond(r, behind)) {
            *state = r->error != MIP_OK ? MIP_REQUEST_UNDECODABLE : MIP_REQUEST_ACKNOWLEDGED;
            return r;
        }
        if (!response && left_alone == NULL) {
            left_alone = r;
        }
    }
    *state = MIP_REQUEST_MISSING_RESPONSE;
    return left_alone;
}

bool mip_client_next(struct mip_client *client, struct mip_walk *walk,
                     struct mip_request **answered, struct mip_field *field) {
    struct mip_protocol_acknowledge acknowledge;
    struct mip_field behind;
    uint8_t state;
    *answered = NULL;
    if (!mip_walk_next(walk, field)) {
        return false;
    }
    if (field->descriptor != MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR ||
        mip_protocol_acknowledge_decode(&acknowledge, field) != MIP_OK) {
        return true;
    }
    struct mip_walk ahead = *walk;
    const bool more = mip_walk_next(&ahead, &behind);
    struct mip_request *request =
        find(client, field->descriptor_set, &acknowledge, more ? &behind : NULL, &state);
    if (request == NULL) {
        return true;
    }
    leave(client, request, state);
    request->code = acknowledge.code;
    if (request->codec != NULL &&
        (state == MIP_REQUEST_ACKNOWLEDGED || state == MIP_REQUEST_UNDECODABLE)) {
        *walk = ahead; /* after the response */
        *field = behind;
    }
    *answered = request;
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
    for (struct mip_request *r = client->waiting; r != NULL;) {
        struct mip_request *next = r->next;
        if (is_late(r, now)) {
            leave(client, r, MIP_REQUEST_TIMED_OUT);
        }
        r = next;
    }
    return false;
}

void mip_client_cancel(struct mip_client *client, struct mip_request *request) {
    leave(client, request, MIP_REQUEST_CANCELLED);
}
