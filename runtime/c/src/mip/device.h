/**
 * @file
 * A device at a port: one call for each command, and handlers for its data.
 *
 * The caller provides three functions: read, write, and a clock. Then each function of
 * mip/..._commands.h sends a command, waits for the reply, and returns the outcome:
 *
 *     mip_device_init(&device, &port, MIP_ARRAY(handlers));
 *     if (mip_succeeded(mip_call_3dm_..._read(&device, &response))) { ... }
 *     while (mip_device_poll(&device)) { ... }
 *
 * If your program has its own event loop, or sends several commands in one packet, use
 * mip/client.h, on which this is built.
 */
#ifndef MIP_DEVICE_H
#define MIP_DEVICE_H

#include "mip/client.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Milliseconds without a byte after which an incomplete packet is discarded: a little more than
 * the longest packet takes at 9600 Bd. */
#define MIP_DEFAULT_SILENCE 300

/** The most milliseconds that a call waits beyond `timeout`, while each read fills its whole
 * buffer, because the reply may be among the bytes that wait. */
#define MIP_BACKLOG 250

/** The port of a device, and a clock. */
struct mip_port {
    /**
     * Reads up to `size` bytes that have arrived, and stores their number in `*count`, which is 0
     * before. It may wait for a while if there are none, but must then return, because a waiting
     * command checks its time-out only between reads. Returns false if the port is lost and no more
     * bytes will arrive; bytes that it has stored are still handled. A terminal that was hung up
     * has no bytes, just like a silent one; only poll() detects it, by POLLHUP (see ports/posix.c).
     */
    bool (*read)(void *user, uint8_t *bytes, size_t size, size_t *count);
    /** Sends all of these bytes. Returns false if that failed. */
    bool (*write)(void *user, const uint8_t *bytes, size_t size);
    /** Returns a time in milliseconds that only increases and is never set; it may wrap around. */
    uint32_t (*now)(void *user);
    /** The first argument of these functions. */
    void *user;
};

/** A handler's `type`: every field without an earlier entry. It is not NULL, so that an empty entry
 * matches no field. */
#define MIP_ANY_FIELD (&mip_any_field)

/** Not a wire format: only its address matters. */
extern MIP_API const struct mip_codec mip_any_field;

/** A handler's `descriptor_set`: every set in which the type occurs. */
#define MIP_ANY_SET 0

/** A handler of received fields. */
struct mip_handler {
    /** The type of field: its codec, such as &mip_sensor_scaled_accel_codec, or MIP_ANY_FIELD; NULL
     * for none yet. Do not replace one by another while data arrives. */
    const struct mip_codec *type;
    /** The descriptor set, for example of one of two receivers, or MIP_ANY_SET. */
    uint8_t descriptor_set;
    /**
     * Called with the field; NULL to ignore it. The field's `descriptor_set` is the set in which it
     * arrived. `arrived` is the time, by the port's clock, when the last bytes of its packet had
     * been read. The field's data is valid until the handler returns. The handler must not block,
     * because the reply to a command may be next. It cannot send a command to this device, which
     * would return MIP_BUSY, nor poll the device.
     */
    void (*handle)(void *user, const struct mip_field *field, uint32_t arrived);
    /** The first argument of the function. */
    void *user;
};

struct mip_device;

/** Observes packets, for programs that handle all fields of a packet together. */
struct mip_observer {
    /**
     * Called twice for each packet: before its fields are handled, and after that, with `ends`
     * true. `device->packet` is the packet, and `device->heard` the time when its last bytes had
     * been read. mip_gap counts the bytes before it that are not part of a packet, such as an NMEA
     * sentence or a damaged packet. The same restrictions apply as to handlers.
     */
    void (*packet)(void *user, const struct mip_device *device, bool ends);
    /** The first argument of the function. */
    void *user;
};

#ifdef MIP_HOOKS
/** What a program may add to a device; each function may be NULL. */
struct mip_hooks {
    /** Locks (true) or unlocks a recursive mutex, for a device that several threads use. It is not
     * locked while the port is read. */
    void (*lock)(void *user, bool locks);
    /** Called with all bytes that were received, or are about to be sent, for example to record
     * them. */
    void (*bytes)(void *user, const uint8_t *bytes, size_t size, bool sent);
    /** The first argument of these functions. */
    void *user;
};
#endif

#ifdef MIP_DIAGNOSTICS
/** The number of descriptor sets whose packets a device counts. */
#define MIP_COUNTED_SETS 8

/** The packets of a descriptor set, and their bytes. */
struct mip_set_count {
    /** The descriptor set; 0 if this entry is not used. */
    uint8_t descriptor_set;
    /** The number of packets. */
    uint32_t packets;
    /** The size of these packets. */
    uint32_t bytes;
};
#endif

/** A device and the state of its stream. Several can be used at the same time. */
struct mip_device {
    /** The connection to it. */
    struct mip_port port;
    /** The first of these that matches a field is called; if none does, the field is dropped. */
    const struct mip_handler *handlers;
    /** The number of handlers. */
    size_t handler_count;
    /** The parser time-out: when no byte has arrived for this many milliseconds, an incomplete
     * packet is discarded, and packets within it are found. 0: never. */
    uint32_t silence;
    /** When the last bytes arrived. */
    uint32_t heard;
    /** Returns whether bytes have arrived, so that `read` would not wait; its argument is the
     * port's `user`. NULL unless your program sets it, for a line where replies can come twice or
     * out of order, such as UDP: before a command is sent, up to 64 reads then handle what has
     * arrived, as data. A deferred command reads nothing: poll the device before it. Serial ports
     * and TCP keep the order. */
    bool (*waits)(void *user);
    /** Waits by the port's `read`: mip_device_wait, or NULL if there is no `read`. */
    void (*wait)(struct mip_device *device, uint8_t *bytes, struct mip_request *request);
    /** In handlers and observers, the packet that is being handled: mip_walk_packet finds all its
     * fields, for example a timestamp and the values of that time. NULL otherwise. */
    const struct mip_packet *packet;
    /** Called where each packet begins and ends; NULL unless your program sets it. It must stay at
     * its address, and may be constant. */
    const struct mip_observer *observer;
#ifdef MIP_HOOKS
    /** What your program adds; NULL unless it sets it. Must stay at its address. */
    const struct mip_hooks *hooks;
#endif
    /** The number of handlers whose descriptors, modulo 32, are the bits of `descriptors`. */
    size_t selected;
    /** The descriptors that a handler may want. Only the library sets these two, if it uses them.
     */
    uint32_t descriptors;
    /** The last command that was sent: the one that was rejected, if mip_device_stream or
     * mip_device_connect reports that. NULL before the first one. */
    const struct mip_exchange *sent;
    /** The request of the next call, which then does not wait: see mip_defer. */
    struct mip_request *deferred;
#ifdef MIP_DIAGNOSTICS
    /** What has been received, by set. `parser` counts the bytes outside packets and the bad
     * checksums, `client` the time-outs. */
    struct mip_set_count sets[MIP_COUNTED_SETS];
#endif
    /** The command client; its `timeout` is the time that the device may take to reply. */
    struct mip_client client;
    /** The parser, which holds the bytes of an incomplete packet. */
    struct mip_parser parser;
};

/** Returns the number of bytes outside packets since the last call with the same `seen`; set that
 * to 0 before the first call. */
static inline uint32_t mip_gap(const struct mip_device *device, uint32_t *seen) {
    const uint32_t gap = device->parser.skipped - *seen;
    *seen = device->parser.skipped;
    return gap;
}

/**
 * The number of attempts for a command, and the outcomes after which it is sent again.
 *
 *     struct mip_retry retry = MIP_RETRY;
 *     do {
 *         result = mip_call_...(&device, ...);
 *     } while (mip_again(&retry, result));
 */
struct mip_retry {
    /** The number of attempts left. */
    unsigned attempts;
    /** A bit for each outcome after which the command is sent again: 1u << MIP_TIMED_OUT. */
    unsigned outcomes;
};

/** Three attempts, after outcomes that noise on the line can cause. A command that was not answered
 * may have been carried out. */
#define MIP_RETRY {3, 1u << MIP_TIMED_OUT | 1u << MIP_MISSING_RESPONSE | 1u << MIP_UNDECODABLE}

/** Should the command be sent again? Counts the attempts. */
static inline bool mip_again(struct mip_retry *retry, struct mip_result result) {
    if (retry->attempts > 0) {
        retry->attempts--;
    }
    return retry->attempts > 0 && (retry->outcomes >> result.outcome & 1u) != 0;
}

/** Waits for the reply to a request; without one, takes in what has arrived. Only mip_device_init
 * refers to this. */
MIP_API void mip_device_wait(struct mip_device *device, uint8_t *bytes,
                             struct mip_request *request);

/** Like mip_device_init, for a port whose `read` is NULL. */
MIP_API void mip_device_begin(struct mip_device *device, const struct mip_port *port,
                              size_t handler_count, const struct mip_handler *handlers);

/**
 * Initializes a device. The port is copied. The handlers must stay at their address; they may be
 * constant, or NULL if there are none. Nothing is sent or read.
 */
static inline void mip_device_init(struct mip_device *device, const struct mip_port *port,
                                   size_t handler_count, const struct mip_handler *handlers) {
    mip_device_begin(device, port, handler_count, handlers);
    if (port->read != NULL) { /* otherwise a program that never waits does not link what waits */
        device->wait = mip_device_wait;
    }
}

/**
 * Reads once, at most as many bytes as the longest packet has, and calls the handlers of the fields
 * that are now complete. Call it repeatedly to receive data; the same happens while a command waits
 * for its reply. Returns false if the port is lost, or if it is called in a handler.
 */
MIP_API bool mip_device_poll(struct mip_device *device);

/**
 * Like mip_device_poll, but with bytes that your program has received, in any pieces; without any,
 * it only updates the time. The port's `read` is not called, and may be NULL. Returns false, and
 * uses none of the bytes, if it is called in a handler.
 */
MIP_API bool mip_device_step(struct mip_device *device, const uint8_t *data, size_t size);

/** Locks (true) or unlocks a device by the function of its hooks. Does nothing without MIP_HOOKS.
 */
static inline void mip_device_lock(const struct mip_device *device, bool locks) {
    (void)device, (void)locks;
#ifdef MIP_HOOKS
    if (device->hooks != NULL && device->hooks->lock != NULL) {
        device->hooks->lock(device->hooks->user, locks);
    }
#endif
}

/**
 * Lets the next call send its command and return at once, with the outcome MIP_WAITING:
 *
 *     mip_call_..._read(mip_defer(&device, &request), &response);
 *     ... mip_device_step(&device, bytes, size) or mip_device_poll(&device), until
 *         request.result.outcome is another ...
 *
 * The request and the response must stay at their addresses until then. A request that still waits
 * is cancelled first. Several may wait, and a handler may do this, too. Before its memory goes,
 * cancel a request that may still wait: mip_device_cancel. With MIP_HOOKS, this locks the device,
 * and the call unlocks it: use it only as the argument of a function mip_call_..., and not of
 * mip_device_connect or mip_device_stream, which call several.
 */
static inline struct mip_device *mip_defer(struct mip_device *device, struct mip_request *request) {
    mip_device_lock(device, true);
    device->deferred = request;
    return device;
}

/** Returns `request->result` while the device is locked, for a thread that does not receive. */
static inline struct mip_result mip_request_result(const struct mip_device *device,
                                                   const struct mip_request *request) {
    mip_device_lock(device, true);
    const struct mip_result result = request->result;
    mip_device_lock(device, false);
    return result;
}

/** Cancels a deferred request while the device is locked: its outcome is then MIP_CLOSED, unless it
 * was just answered. A task that gives up a request calls this before the memory of the request and
 * of its response goes. */
static inline void mip_device_cancel(struct mip_device *device, struct mip_request *request) {
    mip_device_lock(device, true);
    mip_client_cancel(&device->client, request);
    mip_device_lock(device, false);
}

/**
 * Sends a command, and waits for its reply. The functions mip_call_... call this with the types of
 * each command. `value` is the command's structure, or NULL if it has no parameters. The response
 * is stored in `response`, the structure of `codec`, or not stored if that is NULL. It is zeroed
 * first, and stays zeroed unless the command succeeds and requests this response.
 *
 * The reply to a command that has timed out may still arrive. A barrier is therefore sent before
 * the next command (see mip_client_barrier), and what arrives before the barrier's reply is data,
 * so that a late reply is never matched to another command. This costs a packet each way, and no
 * further wait.
 *
 * The call waits at most as long as the client's `timeout`, or the command's own if that is longer,
 * and on a flooded line MIP_BACKLOG more. A read that blocks adds its own time.
 */
MIP_API struct mip_result mip_device_call(struct mip_device *device,
                                          const struct mip_command *command, const void *value,
                                          const struct mip_codec *codec, void *response);

/**
 * Sends a command, and does not wait for a reply; one that arrives is data, even during the next
 * call, which is preceded by a barrier for that. The outcome is MIP_SENT. This is for commands that
 * the device does not acknowledge because of a setting of another command, which their
 * documentation names: mip_device_call would wait for each in vain.
 */
MIP_API struct mip_result mip_device_tell(struct mip_device *device,
                                          const struct mip_command *command, const void *value);

/** `data` for a command that has none: any address. */
#define MIP_NO_DATA(exchange) (&(exchange).descriptor)

/**
 * Sends a command that never requests a response. Its data is passed as it is sent, instead of its
 * structure; the address must not be NULL. Functions mip_call_... with plain values as arguments
 * call this or mip_device_request, so that a program with only these links no encoder. If there are
 * more than MIP_MAX_FIELD_DATA bytes, the command is not sent: MIP_ERROR_COUNT.
 */
MIP_API struct mip_result mip_device_send(struct mip_device *device,
                                          const struct mip_exchange *exchange, const uint8_t *data,
                                          size_t size);

/** Like mip_device_send, for a command that always requests a response: one of those in `exchange`.
 */
MIP_API struct mip_result mip_device_request(struct mip_device *device,
                                             const struct mip_exchange *exchange,
                                             const uint8_t *data, size_t size,
                                             const struct mip_codec *codec, void *response);

/** Defines a call of a command with all of its values, including optional parameters. */
#define MIP_CALL_WITH(call, name, answer)                                                       \
    static inline struct mip_result call(struct mip_device *device, const struct name *command, \
                                         struct answer *response) {                             \
        return mip_device_call(device, &name##_command, command, &answer##_codec, response);    \
    }                                                                                           \
    struct mip_device

/** Defines a call of a function without parameters, which is only acknowledged. */
#define MIP_CALL(call, name, selector)                                        \
    static inline struct mip_result call(struct mip_device *device) {         \
        const uint8_t data[] = {selector};                                    \
        return mip_device_send(device, &name##_exchange, data, sizeof(data)); \
    }                                                                         \
    struct mip_device

/** Defines a call of a function without parameters, which requests this response. */
#define MIP_CALL_FOR(call, name, selector, answer)                                               \
    static inline struct mip_result call(struct mip_device *device, struct answer *response) {   \
        const uint8_t data[] = {selector};                                                       \
        return mip_device_request(device, &name##_exchange, data, sizeof(data), &answer##_codec, \
                                  response);                                                     \
    }                                                                                            \
    struct mip_device

#ifdef __cplusplus
}
#endif

#endif
