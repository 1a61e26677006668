/* A device at a port. */
#include "mip/device.h"

#include <string.h>

/** For how many milliseconds after a time-out a late answer is looked for. */
#define LATE 10000

/** Before a command, reading what has arrived ends after so many reads, or milliseconds. */
#define CATCH_UP_READS 64
#define CATCH_UP_TIME 100

void mip_device_init(struct mip_device *device, const struct mip_port *port,
                     const struct mip_handler *handlers, size_t handler_count) {
    device->port = *port;
    device->handlers = handlers;
    device->handler_count = handlers != NULL ? handler_count : 0;
    device->silence = MIP_DEFAULT_SILENCE;
    device->heard = 0;
    device->missed = 0;
    device->owed = false;
    device->packet = NULL;
    device->observer = NULL;
    mip_client_init(&device->client);
    mip_parser_init(&device->parser);
}

const struct mip_codec mip_any_field = {0, 0, 0, 0, 0, 0, false, NULL, NULL};

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
    device->packet = packet;
    tell(device, true);
    while (mip_client_next(&device->client, &walk, &answered, &field)) {
        const struct mip_handler *h = device->handlers;
        size_t left = answered == NULL ? device->handler_count : 0;
        while (left > 0 && !is_for(h, &field)) {
            h++;
            left--;
        }
        if (left > 0 && h->handle != NULL) {
            h->handle(h->user, &field, device->heard);
        }
    }
    tell(device, false);
    device->packet = NULL;
}

/** Reads once, into these bytes, and updates the time; `*came`: was there anything? False if the
 * port is gone. */
static bool update(struct mip_device *device, uint8_t *bytes, size_t room, bool *came) {
    const struct mip_port *port = &device->port;
    const uint8_t *data = bytes;
    struct mip_packet packet;
    size_t size = 0;
    bool open = port->read(port->user, bytes, room, &size);
    const uint32_t now = port->now(port->user);
    if (size > room) { /* what has been read is not known */
        size = 0;
        open = false;
    }
    *came = size > 0;
    if (*came) {
        device->heard = now;
    }
    const bool ended =
        !open || (device->silence > 0 && (uint32_t)(now - device->heard) >= device->silence);
    /* If there was no room for more, the answer may already be waiting after what was read. */
    const uint32_t timeout = device->client.timeout;
    const uint32_t grace = timeout < MIP_DEFAULT_TIMEOUT ? timeout : MIP_DEFAULT_TIMEOUT;
    const uint32_t passed = size < room ? now : now - grace;
    while (mip_parser_next(&device->parser, &data, &size, &packet) ||
           (ended && mip_parser_flush(&device->parser, &packet)) ||
           mip_client_poll(&device->client, &device->parser, passed, &packet)) {
        handle(device, &packet);
    }
    return open;
}

bool mip_device_poll(struct mip_device *device) {
    uint8_t bytes[MIP_MAX_PACKET];
    bool came;
    return device->packet == NULL && update(device, bytes, sizeof(bytes), &came);
}

/** Reads and handles what has arrived; not for ever, because more may be arriving. */
static void catch_up(struct mip_device *device, uint8_t *bytes, size_t room) {
    const struct mip_port *port = &device->port;
    const uint32_t start = port->now(port->user);
    struct mip_packet packet;
    unsigned left = CATCH_UP_READS;
    bool came = true;
    bool open = true;
    while (open && came && left > 0 && (uint32_t)(port->now(port->user) - start) < CATCH_UP_TIME) {
        open = update(device, bytes, room, &came);
        left--;
    }
    while (mip_parser_look_behind(&device->parser, &packet)) {
        handle(device, &packet);
    }
}

static struct mip_result result_of(enum mip_outcome outcome, uint8_t code, mip_error error) {
    struct mip_result result;
    result.outcome = outcome;
    result.code = code;
    result.error = (uint8_t)error;
    return result;
}

/** The answer to the command may still come. */
static void owe(struct mip_device *device) {
    device->missed = device->port.now(device->port.user);
    device->owed = true;
}

/** Begins a packet in these bytes, after what has arrived is read if an old answer may be in it. */
static bool begin(struct mip_device *device, struct mip_builder *builder, uint8_t *bytes,
                  const struct mip_exchange *exchange) {
    if (device->packet != NULL) {
        return false;
    }
    if (device->owed) {
        device->owed = (uint32_t)(device->port.now(device->port.user) - device->missed) < LATE;
        if (device->owed) {
            catch_up(device, bytes, MIP_MAX_PACKET);
        }
    }
    return mip_builder_start(builder, bytes, MIP_MAX_PACKET, exchange->descriptor_set) == MIP_OK;
}

/** Sends the packet of a command, unless there is an error, and waits for its answer. */
static struct mip_result finish(struct mip_device *device, struct mip_builder *builder,
                                const struct mip_exchange *exchange, mip_error error,
                                const struct mip_codec *codec, void *response) {
    const struct mip_port *port = &device->port;
    struct mip_request request;
    if (response != NULL) {
        memset(response, 0, codec->size);
    }
    if (device->packet != NULL) {
        return result_of(MIP_BUSY, 0, MIP_OK);
    }
    if (error != MIP_OK) {
        return result_of(MIP_NOT_SENT, 0, error);
    }
    mip_client_wait(&device->client, &request, builder, exchange,
                    builder->length - MIP_HEADER_SIZE - 2, port->now(port->user));
    if (response != NULL) {
        mip_client_expect(&request, codec, response);
    }
    const struct mip_packet packet = mip_builder_finish(builder);
    if (!port->write(port->user, packet.bytes, packet.size)) {
        mip_client_cancel(&device->client, &request);
        owe(device); /* a part of it may have been sent */
        return result_of(MIP_NOT_SENT, 0, MIP_OK);
    }
    while (request.state == MIP_REQUEST_WAITING) {
        bool came;
        if (!update(device, builder->buffer, MIP_MAX_PACKET, &came)) { /* the packet is gone */
            mip_client_cancel(&device->client, &request); /* unless the last bytes answered it */
        }
    }
    if (request.state == MIP_REQUEST_TIMED_OUT || request.state == MIP_REQUEST_CANCELLED) {
        owe(device);
    }
    /* The states of a request are its outcomes. */
    return result_of((enum mip_outcome)request.state, request.code, (mip_error)request.error);
}

struct mip_result mip_device_call(struct mip_device *device, const struct mip_command *command,
                                  const void *value, const struct mip_codec *codec,
                                  void *response) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder builder;
    mip_error error = MIP_OK;
    if (begin(device, &builder, bytes, command->exchange)) {
        error = mip_command_encode(command, value, &builder);
    }
    return finish(device, &builder, command->exchange, error, codec, response);
}

struct mip_result mip_device_send(struct mip_device *device, const struct mip_exchange *exchange,
                                  const uint8_t *data, size_t size, const struct mip_codec *codec,
                                  void *response) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder builder;
    mip_error error = MIP_ERROR_COUNT;
    if (size <= MIP_MAX_FIELD_DATA && begin(device, &builder, bytes, exchange)) {
        error = mip_builder_add(&builder, exchange->descriptor, data, size);
    }
    return finish(device, &builder, exchange, error, codec, response);
}
