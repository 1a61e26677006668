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
     * has no bytes, just like a silent one; only poll() detects it, by POLLHUP (see
     * examples/posix.c).
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
    /** The type of field: its codec, such as &mip_sensor_scaled_accel_codec, or MIP_ANY_FIELD. */
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
    /** In handlers and observers, the packet that is being handled: mip_walk_packet finds all its
     * fields, for example a timestamp and the values of that time. NULL otherwise. */
    const struct mip_packet *packet;
    /** Called where each packet begins and ends; NULL unless your program sets it. It must stay at
     * its address, and may be constant. */
    const struct mip_observer *observer;
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

/** The outcome of a command. */
enum mip_outcome {
    /** It was not sent: its values cannot be encoded (`error` is the reason), or, if `error` is
     * MIP_OK, the port could not write. */
    MIP_NOT_SENT = 0,
    /** The device has carried it out, and its response has been stored, if it has one. */
    MIP_ACKNOWLEDGED,
    /** It was sent; devices do not answer it. */
    MIP_SENT,
    /** The device has rejected it: `code` is the reason. */
    MIP_REFUSED,
    /** No reply arrived in time. If it arrives later, it is handled as data. */
    MIP_TIMED_OUT,
    /** The device has acknowledged it without its response. */
    MIP_MISSING_RESPONSE,
    /** The device has sent a response that cannot be decoded: `error` is the reason. */
    MIP_UNDECODABLE,
    /** The port was lost before the reply arrived. */
    MIP_CLOSED,
    /** It was not sent, because the call was made in a handler of the same device. */
    MIP_BUSY,
    /** The stream was not changed, because the device does not support one of the rates. See
     * mip_device_stream. */
    MIP_NO_SUCH_RATE
};

/** The outcome of a command, with the reason. */
struct MIP_WORD mip_result {
    /** The outcome. */
    enum mip_outcome outcome;
    /** The acknowledge code of the answer, if there was one: a value of enum mip_ack_code. */
    uint8_t code;
    /** A mip_error: the reason for MIP_NOT_SENT and MIP_UNDECODABLE. */
    uint8_t error;
    /** Has the response been stored? */
    bool responded;
};

/** Has the command been carried out, as far as is known? */
static inline bool mip_succeeded(struct mip_result result) {
    return result.outcome == MIP_ACKNOWLEDGED || result.outcome == MIP_SENT;
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

/** Returns the outcome in words: "timed out". */
MIP_API const char *mip_outcome_name(enum mip_outcome outcome);

/** Returns why a command was rejected or not sent, or why its response could not be decoded: the
 * name of the acknowledge code or the error; "unknown" for a code without a name, whose number is
 * in `code`; "" if there is no reason. */
MIP_API const char *mip_result_reason(struct mip_result result);

/**
 * Initializes a device. The port is copied. The handlers must stay at their address; they may be
 * constant, or NULL if there are none. Nothing is sent or read.
 */
MIP_API void mip_device_init(struct mip_device *device, const struct mip_port *port,
                             size_t handler_count, const struct mip_handler *handlers);

/**
 * Reads once, at most as many bytes as the longest packet has, and calls the handlers of the fields
 * that are now complete. Call it repeatedly to receive data; the same happens while a command waits
 * for its reply. Returns false if the port is lost, or if it is called in a handler.
 */
MIP_API bool mip_device_poll(struct mip_device *device);

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

#ifdef __cplusplus
}
#endif

#endif
