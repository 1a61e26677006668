/* A device at a port. */
#include "mip/device.h"

#include <string.h>

void mip_device_init(struct mip_device *device, const struct mip_port *port, size_t handler_count,
                     const struct mip_handler *handlers) {
    memset(device, 0, sizeof(*device)); /* which also initializes the parser */
    device->port = *port;
    device->handlers = handlers;
    device->handler_count = handlers != NULL ? handler_count : 0;
    device->silence = MIP_DEFAULT_SILENCE;
    device->client.timeout = MIP_DEFAULT_TIMEOUT;
}

/* No field has descriptor 0. */
const struct mip_codec mip_any_field = {0, 0, 0, 0, 0, 0, 0, NULL, NULL};

/** Does a handler match this field? */
static bool is_for(const struct mip_handler *handler, const struct mip_field *field) {
    const struct mip_codec *type = handler->type;
    return type != NULL &&
           (handler->descriptor_set == MIP_ANY_SET ||
            handler->descriptor_set == field->descriptor_set) &&
           (type->descriptor == 0 || mip_field_is(field, type));
}

/** Calls the first handler that matches a field. */
static void dispatch(const struct mip_device *device, const struct mip_field *field) {
    const struct mip_handler *h = device->handlers;
    for (size_t left = device->handler_count; left > 0; left--) {
        if (is_for(h, field)) {
            if (h->handle != NULL) {
                h->handle(h->user, field, device->heard);
            }
            return;
        }
        h++;
    }
}

/** Passes the replies in a packet to the client, and the other fields to the handlers. */
static void handle(struct mip_device *device, const struct mip_packet *packet) {
    struct mip_walk walk = {packet->bytes + MIP_HEADER_SIZE,
                            packet->bytes + packet->size - MIP_CHECKSUM_SIZE,
                            packet->descriptor_set, MIP_OK};
    struct mip_request *answered;
    struct mip_field field;
    if (mip_client_passes(&device->client, packet)) {
        return;
    }
    device->packet = packet;
    bool ends = false;
    do { /* once for the fields, and once after the last field */
        if (device->observer != NULL) {
            device->observer->packet(device->observer->user, device, ends);
        }
        while (mip_client_next(&device->client, &walk, &answered, &field)) {
            if (answered == NULL) {
                dispatch(device, &field);
            }
        }
        ends = !ends;
    } while (ends);
    device->packet = NULL;
}

/** Reads once, into MIP_MAX_PACKET bytes, and updates the time. Returns false if the port is lost.
 */
static bool update(struct mip_device *device, uint8_t *bytes) {
    const struct mip_port *port = &device->port;
    const uint8_t *data = bytes;
    struct mip_packet packet;
    size_t size = 0;
    bool open = port->read(port->user, bytes, MIP_MAX_PACKET, &size);
    uint32_t now = port->now(port->user);
    if (size > MIP_MAX_PACKET) { /* which bytes have been read is not known */
        size = 0;
        open = false;
    } else if (size > 0) {
        device->heard = now;
    }
    const bool ended =
        !open || (device->silence > 0 && (uint32_t)(now - device->heard) >= device->silence);
    if (size >= MIP_MAX_PACKET) { /* the reply may already wait after the bytes read */
        now -= MIP_BACKLOG;
    }
    while (mip_parser_next(&device->parser, &data, &size, &packet) ||
           (ended && mip_parser_flush(&device->parser, &packet)) ||
           mip_client_poll(&device->client, &device->parser, now, &packet)) {
        handle(device, &packet);
    }
    return open;
}

bool mip_device_poll(struct mip_device *device) {
    uint8_t bytes[MIP_MAX_PACKET];
    if (device->packet != NULL) { /* in a handler */
        return false;
    }
    return update(device, bytes);
}

/* ------------------------------------------------------------------------------------- commands */

/** The offset of a command's data in its packet. */
#define DATA (MIP_HEADER_SIZE + 2)

/** Sends the barrier that must precede the next command, if there is one. */
static bool guard(struct mip_device *device) {
    uint8_t bytes[MIP_MAX_BARRIER];
    const size_t size = mip_client_barrier(&device->client, bytes);
    return size == 0 || device->port.write(device->port.user, bytes, size);
}

/** Sends a command, whose data is already in the packet, and waits for its reply. */
static struct mip_result carry_out(struct mip_device *device, struct mip_request *request,
                                   uint8_t *bytes, size_t size) {
    const struct mip_port *port = &device->port;
    struct mip_result result;
    if (device->packet != NULL) { /* in a handler */
        request->state = MIP_BUSY;
    } else if (request->error == MIP_OK) {
        bytes[4] = (uint8_t)(size + 2);
        bytes[5] = request->exchange->descriptor;
        size = mip_packet_seal(bytes, request->exchange->descriptor_set, size + 2);
        if (guard(device) && port->write(port->user, bytes, size)) {
            mip_client_wait(&device->client, request, port->now(port->user));
            while (request->state == MIP_REQUEST_WAITING) {
                if (!update(device, bytes)) {                    /* reuses the packet's memory */
                    mip_client_cancel(&device->client, request); /* unless it was just answered */
                }
            }
        } else {
            mip_client_miss(&device->client); /* a part may have been sent */
        }
    }
    /* The states of a request are the outcomes; a request that never waited was not sent. */
    if (sizeof(result) == 4) { /* one word, in the same order */
        memcpy(&result, &request->state, 4);
        return result;
    }
    result.outcome = (enum mip_outcome)request->state;
    result.code = request->code;
    result.error = request->error;
    result.responded = request->responded;
    return result;
}

/** Initializes a request. */
static void request_of(struct mip_request *request, const struct mip_exchange *exchange,
                       const struct mip_codec *codec, void *response) {
    memset(request, 0, sizeof(*request));
    request->exchange = exchange;
    request->codec = codec;
    request->response = response;
    if (response != NULL) {
        memset(response, 0, codec->size);
    }
}

struct mip_result mip_device_call(struct mip_device *device, const struct mip_command *command,
                                  const void *value, const struct mip_codec *codec,
                                  void *response) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder builder;
    struct mip_request request;
    request_of(&request, command->exchange, codec, response);
    mip_builder_start(&builder, bytes, sizeof(bytes), command->exchange->descriptor_set);
    request.error = (uint8_t)mip_command_encode(command, value, &builder);
    if (request.error == MIP_OK) {
        request.asked = mip_requested(command->exchange, bytes + MIP_HEADER_SIZE);
    }
    return carry_out(device, &request, bytes, builder.length - DATA);
}

/** Sends data, and waits for the reply. */
static struct mip_result send(struct mip_device *device, struct mip_request *request,
                              const uint8_t *data, size_t size) {
    uint8_t bytes[MIP_MAX_PACKET];
    if (size > MIP_MAX_FIELD_DATA) {
        request->error = MIP_ERROR_COUNT;
    } else {
        memcpy(bytes + DATA, data, size);
    }
    return carry_out(device, request, bytes, size);
}

struct mip_result mip_device_send(struct mip_device *device, const struct mip_exchange *exchange,
                                  const uint8_t *data, size_t size) {
    struct mip_request request;
    memset(&request, 0, sizeof(request));
    request.exchange = exchange;
    return send(device, &request, data, size);
}

struct mip_result mip_device_request(struct mip_device *device, const struct mip_exchange *exchange,
                                     const uint8_t *data, size_t size,
                                     const struct mip_codec *codec, void *response) {
    struct mip_request request;
    request_of(&request, exchange, codec, response);
    request.asked = exchange->responses;
    while (request.asked->descriptor != codec->descriptor) {
        request.asked++;
    }
    return send(device, &request, data, size);
}
