/* A device at a port. */
#include "mip/device.h"

#include <string.h>

void mip_device_init(struct mip_device *device, const struct mip_port *port,
                     const struct mip_handler *handlers, size_t handler_count) {
    memset(device, 0, sizeof(*device)); /* so its parser, too, is at the beginning of a stream */
    device->port = *port;
    device->handlers = handlers;
    device->handler_count = handlers != NULL ? handler_count : 0;
    device->silence = MIP_DEFAULT_SILENCE;
    device->client.timeout = MIP_DEFAULT_TIMEOUT;
}

const struct mip_codec mip_any_field = {0, 0, 0, 0, 0, 0, 0, NULL, NULL};

/** Is a handler for this field? */
static bool is_for(const struct mip_handler *handler, const struct mip_field *field) {
    return (handler->descriptor_set == MIP_ANY_SET ||
            handler->descriptor_set == field->descriptor_set) &&
           (handler->type == MIP_ANY_FIELD ||
            (handler->type != NULL && mip_field_is(field, handler->type)));
}

/** Tells the observer, if there is one. */
static void tell(const struct mip_device *device, bool begins) {
    const struct mip_observer *observer = device->observer;
    if (observer != NULL) {
        observer->packet(observer->user, device, begins);
    }
}

/** Gives the answers in a packet to the client, and the other fields to the handlers. */
static void handle(struct mip_device *device, const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_request *answered;
    struct mip_field field;
    if (mip_client_passes(&device->client, packet)) {
        return;
    }
    device->packet = packet;
    tell(device, true);
    while (mip_client_next(&device->client, &walk, &answered, &field)) {
        const struct mip_handler *h = device->handlers;
        size_t left = answered == NULL ? device->handler_count : 0;
        for (; left > 0 && !is_for(h, &field); left--) {
            h++;
        }
        if (left > 0 && h->handle != NULL) {
            h->handle(h->user, &field, device->heard);
        }
    }
    tell(device, false);
    device->packet = NULL;
}

/** Reads once, into MIP_MAX_PACKET bytes, and updates the time. False if the port is gone. */
static bool update(struct mip_device *device, uint8_t *bytes) {
    const struct mip_port *port = &device->port;
    const uint8_t *data = bytes;
    struct mip_packet packet;
    size_t size = 0;
    bool open = port->read(port->user, bytes, MIP_MAX_PACKET, &size);
    uint32_t now = port->now(port->user);
    if (size > MIP_MAX_PACKET) { /* what has been read is not known */
        size = 0;
        open = false;
    }
    if (size > 0) {
        device->heard = now;
    }
    const bool ended =
        !open || (device->silence > 0 && (uint32_t)(now - device->heard) >= device->silence);
    if (size == MIP_MAX_PACKET) { /* the answer may already be waiting after what was read */
        const uint32_t timeout = device->client.timeout;
        now -= timeout < MIP_DEFAULT_TIMEOUT ? timeout : MIP_DEFAULT_TIMEOUT;
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
    return device->packet == NULL && update(device, bytes);
}

/* ------------------------------------------------------------------------------------- commands */

/** The place of a command's data in its packet. */
#define DATA (MIP_HEADER_SIZE + 2)

/** Sends a packet whose fields are at their place. */
static bool transmit(const struct mip_device *device, uint8_t descriptor_set, uint8_t *bytes,
                     size_t size) {
    const size_t end = MIP_HEADER_SIZE + size;
    bytes[0] = MIP_SYNC_1;
    bytes[1] = MIP_SYNC_2;
    bytes[2] = descriptor_set;
    bytes[3] = (uint8_t)size;
    mip_put_16(bytes + end, mip_checksum(bytes, end));
    return device->port.write(device->port.user, bytes, end + MIP_CHECKSUM_SIZE);
}

/** Before a command: false in a handler. */
static bool begin(struct mip_device *device, struct mip_request *request, uint8_t *bytes) {
    if (request->response != NULL) {
        memset(request->response, 0, request->codec->size);
    }
    if (device->packet != NULL) {
        request->state = MIP_BUSY;
        return false;
    }
    const size_t size = mip_client_guard(&device->client, bytes + MIP_HEADER_SIZE);
    if (size > 0 && !transmit(device, MIP_BARRIER_SET, bytes, size)) {
        mip_client_miss(&device->client); /* the next one is another */
        return false;
    }
    return true;
}

/** Sends a command, whose data are at their place in the packet, and waits for its answer. */
static void carry_out(struct mip_device *device, struct mip_request *request, uint8_t *bytes,
                      size_t size) {
    const struct mip_port *port = &device->port;
    bytes[4] = (uint8_t)(size + 2);
    bytes[5] = request->exchange->descriptor;
    if (transmit(device, request->exchange->descriptor_set, bytes, size + 2)) {
        mip_client_wait(&device->client, request, bytes + MIP_HEADER_SIZE, port->now(port->user));
        while (request->state == MIP_REQUEST_WAITING) {
            if (!update(device, bytes)) {                    /* the packet is gone */
                mip_client_cancel(&device->client, request); /* unless the last bytes answered it */
            }
        }
    } else {
        mip_client_miss(&device->client); /* a part may have been sent */
    }
}

/** The states of a request are its outcomes; one that never waited was not sent. */
static struct mip_result result_of(const struct mip_request *request) {
    struct mip_result result;
    result.outcome = (enum mip_outcome)request->state;
    result.code = request->code;
    result.error = request->error;
    return result;
}

struct mip_result mip_device_call(struct mip_device *device, const struct mip_command *command,
                                  const void *value, const struct mip_codec *codec,
                                  void *response) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_request request;
    memset(&request, 0, sizeof(request));
    request.exchange = command->exchange;
    request.codec = codec;
    request.response = response;
    if (begin(device, &request, bytes)) {
        struct mip_builder builder;
        mip_builder_start(&builder, bytes, sizeof(bytes), command->exchange->descriptor_set);
        request.error = (uint8_t)mip_command_encode(command, value, &builder);
        if (request.error == MIP_OK) {
            carry_out(device, &request, bytes, builder.length - DATA);
        }
    }
    return result_of(&request);
}

struct mip_result mip_device_send(struct mip_device *device, const struct mip_exchange *exchange,
                                  const uint8_t *data, size_t size, const struct mip_codec *codec,
                                  void *response) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_request request;
    memset(&request, 0, sizeof(request));
    request.exchange = exchange;
    request.codec = codec;
    request.response = response;
    if (begin(device, &request, bytes)) {
        if (size > MIP_MAX_FIELD_DATA) {
            request.error = MIP_ERROR_COUNT;
        } else {
            if (size > 0) {
                memcpy(bytes + DATA, data, size);
            }
            carry_out(device, &request, bytes, size);
        }
    }
    return result_of(&request);
}
