/* Commands and their answers. */
#include "mip/client.h"

void mip_client_init(struct mip_client *client) {
    client->waiting = NULL;
    client->timeout = MIP_DEFAULT_TIMEOUT;
}

mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                         struct mip_builder *packet, const struct mip_codec *codec,
                         const void *command, uint32_t now) {
    const mip_error error = mip_encode(codec, command, packet);
    mip_client_cancel(client, request); /* it could still wait for an earlier answer */
    if (error != MIP_OK) {
        request->state = MIP_REQUEST_CANCELLED; /* so that nobody waits for it */
        return error;
    }
    request->state = MIP_REQUEST_WAITING;
    request->code = 0;
    request->responded = false;
    request->error = MIP_OK;
    request->descriptor_set = codec->descriptor_set;
    request->descriptor = codec->descriptor;
    request->codec = NULL;
    request->response = NULL;
    request->deadline = now + (codec->timeout > client->timeout ? codec->timeout : client->timeout);
    request->next = NULL;
    if (codec->silent != NULL && codec->silent(command)) {
        request->state = MIP_REQUEST_SILENT;
        return MIP_OK;
    }
    struct mip_request **end = &client->waiting;
    while (*end != NULL) {
        end = &(*end)->next;
    }
    *end = request;
    return MIP_OK;
}

void mip_client_expect(struct mip_request *request, const struct mip_codec *codec, void *response) {
    request->codec = codec;
    request->response = response;
}

/** Takes a request out of those that wait. */
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

/** The request that an acknowledge field answers: the oldest one of that command. */
static struct mip_request *answer(struct mip_client *client, const struct mip_field *field) {
    struct mip_protocol_acknowledge acknowledge;
    if (mip_protocol_acknowledge_decode(&acknowledge, field) != MIP_OK) {
        return NULL;
    }
    for (struct mip_request *r = client->waiting; r != NULL; r = r->next) {
        if (r->descriptor_set == field->descriptor_set && r->descriptor == acknowledge.command) {
            const bool done = acknowledge.code == 0;
            leave(client, r, done ? MIP_REQUEST_ACKNOWLEDGED : MIP_REQUEST_REFUSED);
            r->code = acknowledge.code;
            return r;
        }
    }
    return NULL;
}

bool mip_client_receive(struct mip_client *client, const struct mip_packet *packet) {
    bool answered = false;
    struct mip_request *request = NULL; /* the one that the last acknowledge field answered */
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_field field;
    while (mip_walk_next(&walk, &field)) {
        if (field.descriptor == MIP_PROTOCOL_ACKNOWLEDGE_DESCRIPTOR) {
            request = answer(client, &field);
            answered = answered || request != NULL;
        } else if (request != NULL && request->codec != NULL && !request->responded &&
                   field.descriptor == request->codec->descriptor) {
            request->error = (uint8_t)mip_decode(request->codec, request->response, &field, NULL);
            request->responded = request->error == MIP_OK;
        }
    }
    return answered;
}

size_t mip_client_expire(struct mip_client *client, uint32_t now) {
    size_t count = 0;
    struct mip_request *r = client->waiting;
    while (r != NULL) {
        struct mip_request *next = r->next;
        if ((uint32_t)(now - r->deadline) < UINT32_C(0x80000000)) { /* the time may wrap around */
            leave(client, r, MIP_REQUEST_TIMED_OUT);
            count++;
        }
        r = next;
    }
    return count;
}

void mip_client_cancel(struct mip_client *client, struct mip_request *request) {
    leave(client, request, MIP_REQUEST_CANCELLED);
}
