/* A device at a port. */
#include "mip/device.h"

#include "mip/core/parser.h"

#include <string.h>

void mip_device_begin(struct mip_device *device, const struct mip_port *port, size_t handler_count,
                      const struct mip_handler *handlers) {
    MIP_ASSERT(port->write != NULL && port->now != NULL);
    memset(device, 0, sizeof(*device)); /* which also initializes the parser */
    device->port = *port;
    device->handlers = handlers;
    device->handler_count = handlers != NULL ? handler_count : 0;
    device->silence = MIP_DEFAULT_SILENCE;
    device->client.timeout = MIP_DEFAULT_TIMEOUT;
}

/* No field has descriptor 0. */
const struct mip_codec mip_any_field = {0, 0, 0, 0, 0, 0, 0, NULL, NULL};

/** May a handler want a field with this descriptor, modulo 32? Most others then cost little. */
static bool wanted(struct mip_device *device, uint8_t descriptor) {
#ifdef MIP_PARSER_FAST
    if (device->selected != device->handler_count) { /* C++ adds handlers one by one */
        device->selected = device->handler_count;
        device->descriptors = 0;
        for (size_t i = 0; i < device->handler_count; i++) {
            const struct mip_codec *const type = device->handlers[i].type;
            device->descriptors |= type != NULL && type->descriptor != 0
                                       ? UINT32_C(1) << (type->descriptor & 31)
                                       : UINT32_MAX; /* an empty entry may be filled later */
        }
    }
    return (device->descriptors >> (descriptor & 31) & 1) != 0;
#else
    (void)device, (void)descriptor;
    return true;
#endif
}

/** Calls the first handler that matches a field. Most handlers differ in the descriptor. */
static void dispatch(const struct mip_device *device, const struct mip_field *field) {
    const struct mip_handler *h = device->handlers;
    for (size_t left = device->handler_count; left > 0; left--, h++) {
        const struct mip_codec *type = h->type;
        if (type != NULL &&
            (h->descriptor_set == MIP_ANY_SET || h->descriptor_set == field->descriptor_set) &&
            (type->descriptor == 0 ||
             (type->descriptor == field->descriptor && mip_field_is(field, type)))) {
            if (h->handle != NULL) {
                h->handle(h->user, field, device->heard);
            }
            return;
        }
    }
}

/** Counts a packet of its descriptor set. */
static void count_packet(struct mip_device *device, const struct mip_packet *packet) {
    (void)device, (void)packet;
#ifdef MIP_DIAGNOSTICS
    struct mip_set_count *count = device->sets;
    while (count->descriptor_set != packet->descriptor_set && count->descriptor_set != 0 &&
           count < &device->sets[MIP_COUNTED_SETS - 1]) {
        count++;
    }
    if (count->descriptor_set == 0 || count->descriptor_set == packet->descriptor_set) {
        count->descriptor_set = packet->descriptor_set;
        count->packets++;
        count->bytes += (uint32_t)packet->size;
    }
#endif
}

/** Tells the program where a packet begins or ends. */
MIP_INLINE void observe(const struct mip_device *device, bool ends) {
    if (device->observer != NULL) {
        device->observer->packet(device->observer->user, device, ends);
    }
}

/** Passes the replies in a packet to the client, and the other fields to the handlers. */
static void handle(struct mip_device *device, const struct mip_packet *packet) {
    struct mip_walk walk = {packet->bytes + MIP_HEADER_SIZE,
                            packet->bytes + packet->size - MIP_CHECKSUM_SIZE,
                            packet->descriptor_set, MIP_OK};
    struct mip_request *answered;
    struct mip_field field;
    count_packet(device, packet);
    if (device->client.behind != 0 && mip_client_passes(&device->client, packet)) {
        return;
    }
    device->packet = packet;
    observe(device, false);
    while (mip_client_next(&device->client, &walk, &answered, &field)) {
        if (answered == NULL && wanted(device, field.descriptor)) {
            dispatch(device, &field);
        }
    }
    observe(device, true);
    device->packet = NULL;
}

/** Shows bytes to the program. */
static void show(const struct mip_device *device, const uint8_t *bytes, size_t size, bool sent) {
    (void)device, (void)bytes, (void)size, (void)sent;
#ifdef MIP_HOOKS
    if (device->hooks != NULL && device->hooks->bytes != NULL && size > 0) {
        device->hooks->bytes(device->hooks->user, bytes, size, sent);
    }
#endif
}

/** Handles received bytes, and updates the time. Returns false if this is called in a handler. */
static bool handle_bytes(struct mip_device *device, const uint8_t *data, size_t size, bool ended) {
    struct mip_packet packet;
    mip_device_lock(device, true);
    if (device->packet != NULL) {
        mip_device_lock(device, false);
        return false;
    }
    uint32_t now = device->port.now(device->port.user);
    if (size > 0) {
        device->heard = now;
    }
    if (device->silence > 0 && (uint32_t)(now - device->heard) >= device->silence) {
        ended = true;
    }
    if (size >= MIP_MAX_PACKET) { /* the reply may already wait after the bytes read */
        now -= MIP_BACKLOG;
    }
    show(device, data, size, false);
    while (mip_parser_next(&device->parser, &data, &size, &packet) ||
           (ended && mip_parser_flush(&device->parser, &packet)) ||
           mip_client_poll(&device->client, &device->parser, now, &packet)) {
        handle(device, &packet);
    }
    mip_device_lock(device, false);
    return true;
}

/** Reads once, into MIP_MAX_PACKET bytes, and updates the time. Returns false if the port is lost.
 */
static bool update(struct mip_device *device, uint8_t *bytes) {
    const struct mip_port *port = &device->port;
    size_t size = 0;
    bool open = port->read(port->user, bytes, MIP_MAX_PACKET, &size);
    if (size > MIP_MAX_PACKET) { /* which bytes have been read is not known */
        size = 0;
        open = false;
    }
    return handle_bytes(device, bytes, size, !open) && open;
}

bool mip_device_step(struct mip_device *device, const uint8_t *data, size_t size) {
    return handle_bytes(device, data, size, false);
}

/** Does the same unless this is called in a handler. */
static bool poll(struct mip_device *device, uint8_t *bytes) {
    mip_device_lock(device, true);
    const bool outside = device->packet == NULL;
    mip_device_lock(device, false);
    return outside && update(device, bytes);
}

bool mip_device_poll(struct mip_device *device) {
    uint8_t bytes[MIP_MAX_PACKET];
    return poll(device, bytes);
}

/* ------------------------------------------------------------------------------------- commands */

/** The offset of a command's data in its packet. */
#define DATA (MIP_HEADER_SIZE + 2)

/** Sends bytes. */
static bool write(const struct mip_device *device, const uint8_t *bytes, size_t size) {
    show(device, bytes, size, true);
    return device->port.write(device->port.user, bytes, size);
}

/** Sends the barrier that must precede the next command, if there is one. */
static bool guard(struct mip_device *device) {
    uint8_t bytes[MIP_MAX_BARRIER];
    const size_t size = mip_client_barrier(&device->client, bytes);
    return size == 0 || write(device, bytes, size);
}

/** Takes in what has arrived before a command is sent: it cannot be the reply to that. */
MIP_INLINE void take_in(struct mip_device *device, uint8_t *bytes) {
    if (device->wait != NULL) {
        device->wait(device, bytes, NULL);
    }
}

/** Is the command deferred? Then mip_defer keeps the device locked, and the port is never read. */
static bool defers(const struct mip_device *device) {
    mip_device_lock(device, true);
    const bool is_deferred = device->deferred != NULL;
    mip_device_lock(device, false);
    return is_deferred;
}

/** The most reads before a command, because bytes may arrive as fast as they are handled. */
#define READS_BEFORE 64

void mip_device_wait(struct mip_device *device, uint8_t *bytes, struct mip_request *request) {
    if (request == NULL) {
        unsigned left = READS_BEFORE;
        while (device->waits != NULL && !defers(device) && device->waits(device->port.user) &&
               poll(device, bytes) && --left > 0) {
        }
        return;
    }
    while (mip_request_result(device, request).outcome == MIP_WAITING) {
        if (!update(device, bytes)) {           /* reuses the packet's memory */
            mip_device_cancel(device, request); /* unless it was just answered */
        }
    }
}

/** Sends a command, whose data is already in the packet, and waits for its reply. */
static struct mip_result carry_out(struct mip_device *device, struct mip_request *request,
                                   uint8_t *bytes, size_t size) {
    mip_device_lock(device, true);
    struct mip_request *const deferred = device->deferred;
    if (deferred != NULL) {
        device->deferred = NULL;
        mip_device_lock(device, false);               /* mip_defer has locked it once more */
        mip_client_cancel(&device->client, deferred); /* it may still wait */
        *deferred = *request;
        request = deferred;
    } else if (device->packet != NULL || device->wait == NULL) { /* in a handler, or no `read` */
        request->result.outcome = MIP_BUSY;
        mip_device_lock(device, false);
        return request->result;
    }
    if (request->result.error == MIP_OK) {
        const struct mip_exchange *const exchange = request->exchange;
        device->sent = exchange;
        bytes[4] = (uint8_t)(size + 2);
        bytes[5] = exchange->descriptor;
        size = mip_packet_seal(bytes, exchange->descriptor_set, size + 2);
        if (guard(device) && write(device, bytes, size)) {
            mip_client_wait(&device->client, request, device->port.now(device->port.user));
        } else {
            mip_client_miss(&device->client); /* a part may have been sent */
        }
    }
    mip_device_lock(device, false);
    if (deferred == NULL) {
        device->wait(device, bytes, request);
    }
    return mip_request_result(device, request);
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
    take_in(device, bytes);
    mip_builder_start(&builder, bytes, sizeof(bytes), command->exchange->descriptor_set);
    request.result.error = (uint8_t)mip_command_encode(command, value, &builder);
    if (request.result.error == MIP_OK) {
        request.asked = mip_requested(command->exchange, bytes + MIP_HEADER_SIZE);
    }
    return carry_out(device, &request, bytes, builder.length - DATA);
}

struct mip_result mip_device_tell(struct mip_device *device, const struct mip_command *command,
                                  const void *value) {
    static const struct mip_response none = {NULL, 0, 0, MIP_NOT_ZERO, false};
    struct mip_client *const client = &device->client;
    const struct mip_response *asked = &none;
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder builder;
    struct mip_request request;
    request_of(&request, command->exchange, NULL, NULL);
    request.asked = &none;
    take_in(device, bytes);
    mip_builder_start(&builder, bytes, sizeof(bytes), command->exchange->descriptor_set);
    request.result.error = (uint8_t)mip_command_encode(command, value, &builder);
    if (request.result.error == MIP_OK) {
        asked = mip_requested(command->exchange, bytes + MIP_HEADER_SIZE);
    }
    mip_device_lock(device, true);
    const uint8_t behind = client->behind;
    const uint8_t missed = client->missed;
    client->behind = missed; /* it needs no barrier */
    const struct mip_result result = carry_out(device, &request, bytes, builder.length - DATA);
    if (client->behind == missed) { /* nor was one sent, for the request that it replaces */
        client->behind = behind;
    }
    if (result.outcome == MIP_SENT && client->missed == client->behind &&
        (asked == NULL || asked->descriptor != 0)) {
        mip_client_miss(client); /* the device may reply; then the next command does */
    }
    mip_device_lock(device, false);
    return result;
}

/** Sends data, and waits for the reply. */
MIP_INLINE struct mip_result send(struct mip_device *device, struct mip_request *request,
                                  const uint8_t *data, size_t size) {
    uint8_t bytes[MIP_MAX_PACKET];
    take_in(device, bytes);
    if (size > MIP_MAX_FIELD_DATA) {
        request->result.error = MIP_ERROR_COUNT;
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
