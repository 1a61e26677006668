/**
 * @file
 * The command client, without input, output or a clock.
 *
 * The caller builds a packet, sends it, and passes received packets and the time to the client. The
 * caller also owns the requests: each must stay at its address until it is no longer waiting.
 *
 *     uint8_t bytes[MIP_MAX_SENT];
 *     size_t size = mip_client_start(&client, &builder, bytes, MIP_..._SET);
 *     mip_send_..._...(&client, &request, &builder, &command, &response, now);
 *     size += mip_builder_finish(&builder).size;
 *     ... send these bytes ...
 *     while (request.result.outcome == MIP_WAITING) {
 *         ... read up to `size` bytes into `data` ...
 *         while (mip_client_step(&client, &parser, now, &data, &size, &packet)) {
 *             ... handle the data in the packet ...
 *         }
 *     }
 */
#ifndef MIP_CLIENT_H
#define MIP_CLIENT_H

#include "mip/protocol.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Milliseconds that a device may take to reply, unless the command has its own limit. */
#define MIP_DEFAULT_TIMEOUT 1000
/** The longest time-out, 24 days: half of the range of the time, which may wrap around, less 20
 * hours. A longer one is shortened. */
#define MIP_MAX_TIMEOUT UINT32_C(2073600000)
/** The bytes of the longest barrier: 63 commands. */
#define MIP_MAX_BARRIER (6 + 2 * 63)
/** The most bytes that mip_client_start begins: a barrier and a packet. */
#define MIP_MAX_SENT (MIP_MAX_BARRIER + MIP_MAX_PACKET)

/** A response's `value`: any value except 0. */
#define MIP_NOT_ZERO 0xFF

/**
 * A response to a command, and a test of one byte of the command. Responses that are linked by
 * `more` belong together: if all of their tests hold, the device may send any of their layouts.
 */
struct mip_response {
    /** The wire format of the response, if its descriptor has several; else NULL. */
    const struct mip_codec *layout;
    /** Its descriptor; 0 if the device leaves the command unanswered. */
    uint8_t descriptor;
    /** The offset of the tested byte in the field. The field begins with its length, which is never
     * 0. A missing byte counts as 0. */
    uint8_t at;
    /** The value that it must have, or MIP_NOT_ZERO. */
    uint8_t value;
    /** Does the next response belong to this one? */
    bool more;
};

/** The replies to a command. */
struct mip_exchange {
    /** Descriptor set of the command. */
    uint8_t descriptor_set;
    /** Descriptor of the command. */
    uint8_t descriptor;
    /** The time that a device may take to reply, in quarters of a second; 0: the usual time. */
    uint8_t timeout;
    /** The number of responses. */
    uint8_t response_count;
    /** The device sends the first response whose tests hold; if none do, only an acknowledge. */
    const struct mip_response *responses;
};

/** A command: its wire format, and its replies. */
struct mip_command {
    /** The wire format of the command. */
    const struct mip_codec *codec;
    /** The replies to it. */
    const struct mip_exchange *exchange;
    /** Does the command begin with a function selector? */
    bool has_selector;
};

/** Declares the description of a command, `name_command`, and of its replies, `name_exchange`. */
#define MIP_COMMAND_REPLIES(name)                             \
    extern MIP_API const struct mip_exchange name##_exchange; \
    extern MIP_API const struct mip_command name##_command

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
    /** It was cancelled, or the port was lost, before the reply arrived. */
    MIP_CLOSED,
    /** It was sent, and its reply has not arrived. */
    MIP_WAITING,
    /** It was not sent, because the call was made in a handler of the same device, or would have to
     * wait, and the port has no `read`. */
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

/** Returns the outcome in words: "timed out". */
MIP_API const char *mip_outcome_name(enum mip_outcome outcome);

/** Returns why a command was rejected or not sent, or why its response could not be decoded: the
 * name of the acknowledge code or the error; "unknown" for a code without a name, whose number is
 * in `code`; "" if there is no reason. */
MIP_API const char *mip_result_reason(struct mip_result result);

/** One command that was sent. */
struct mip_request {
    /** The next waiting request. */
    struct mip_request *next;
    /** The replies to the command. */
    const struct mip_exchange *exchange;
    /** The response that it requests; NULL if it requests none. */
    const struct mip_response *asked;
    /** The wire format of the response: the one that the caller expects, or of several layouts the
     * one received; else NULL. */
    const struct mip_codec *codec;
    /** Where the response is stored; NULL if the caller does not need it. */
    void *response;
    /** When the request times out, in the caller's milliseconds. */
    uint32_t deadline;
    /** The outcome: MIP_WAITING until the reply has arrived or is overdue. */
    struct mip_result result;
    /** The barrier that must be answered first, identified by its reply's payload size. 0: none. */
    uint8_t behind;
};

/** The commands that wait for a reply, oldest first. */
struct mip_client {
    /** The oldest request that waits; NULL if none does. */
    struct mip_request *waiting;
    /** Milliseconds that a device may take to reply; at most MIP_MAX_TIMEOUT. */
    uint32_t timeout;
    /** The next barrier to send, identified by its reply's payload size: four bytes per command. It
     * has one command more than there were unanswered requests since the last one. 0: none. */
    uint8_t missed;
    /** The barrier that was sent, in the same form, until it is answered. 0: none. */
    uint8_t behind;
#ifdef MIP_DIAGNOSTICS
    /** The number of requests that have timed out. */
    uint32_t timeouts;
#endif
};

/** Initializes a client: no request is waiting, and the time-out is MIP_DEFAULT_TIMEOUT. */
MIP_API void mip_client_init(struct mip_client *client);

/** Adds a command to a packet. If its function selector is still 0, which no device answers, the
 * error is MIP_ERROR_MISSING. On an error the packet is unchanged. */
MIP_CHECKED MIP_API mip_error mip_command_encode(const struct mip_command *command,
                                                 const void *value, struct mip_builder *packet);

/**
 * Adds a command to a packet and waits for its reply. `now` is the time in milliseconds, which may
 * wrap around. On an error the packet is unchanged and the outcome is MIP_NOT_SENT. `value` is the
 * command's structure, or NULL if it has no parameters. A request that still waits in this client
 * is cancelled first; if it waits in another client, cancel it there before.
 */
MIP_CHECKED MIP_API mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet,
                                             const struct mip_command *command, const void *value,
                                             uint32_t now);

/** Returns the response that a command requests, or the first of several layouts; NULL if it
 * requests none, and one with descriptor 0 if the device leaves the command unanswered. `field`
 * begins with the command's length. */
MIP_API const struct mip_response *mip_requested(const struct mip_exchange *exchange,
                                                 const uint8_t *field);

/** Waits for the reply to a command that the caller has written. The request must be zero except
 * `exchange`, `asked`, and `codec` and `response`, which may also be set afterwards. */
MIP_API void mip_client_wait(struct mip_client *client, struct mip_request *request, uint32_t now);

/**
 * Sets where the response is stored. Call this right after mip_client_add. If the command with its
 * values does not request this response, returns false, and nothing will be stored.
 *
 * If devices answer in different layouts, pass the codec of your device's layout; if the device
 * sends another one, the outcome is MIP_UNDECODABLE with MIP_ERROR_LAYOUT. If you do not know
 * the layout, get the field from mip_client_next, and decode it by the request's `codec`, which is
 * then the layout received.
 */
MIP_API bool mip_client_expect(struct mip_request *request, const struct mip_codec *codec,
                               void *response);

/**
 * Does both: adds a command, and sets where its response is stored. The response's structure is
 * zeroed first, and stays zeroed if the command with these values does not request it. `response`
 * may be NULL. The generated functions mip_send_... call this with the types of each command.
 */
MIP_CHECKED MIP_API mip_error mip_client_send(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              const struct mip_command *command, const void *value,
                                              const struct mip_codec *codec, void *response,
                                              uint32_t now);

/**
 * Starts a packet of commands in `bytes`, which has MIP_MAX_SENT, after a barrier if one must
 * precede it. Returns the barrier's size, to which you add that of the packet: send both. First
 * take in what has already arrived, with mip_client_step, so that a reply that came twice or out of
 * order is not matched to the next command.
 */
MIP_API size_t mip_client_start(struct mip_client *client, struct mip_builder *packet,
                                uint8_t *bytes, uint8_t descriptor_set);

/**
 * Does all that received bytes and the time require, in order: finds the next packet, takes it as
 * the reply to a barrier or to requests, and ends overdue requests after a look at the bytes that
 * the parser holds back. Returns true for each packet except replies to barriers, for the data in
 * it. Call it until it returns false, as often as you read; `size` may be 0.
 */
MIP_API bool mip_client_step(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                             const uint8_t **data, size_t *size, struct mip_packet *packet);

/** Defines a function that adds a command to a packet: mip_client_send with the types of the
 * command and of its response. */
#define MIP_SEND(send, name, answer)                                                               \
    static inline mip_error send(struct mip_client *client, struct mip_request *request,           \
                                 struct mip_builder *packet, const struct name *command,           \
                                 struct answer *response, uint32_t now) {                          \
        return mip_client_send(client, request, packet, &name##_command, command, &answer##_codec, \
                               response, now);                                                     \
    }                                                                                              \
    struct mip_client

/**
 * Processes a received packet. Returns true if it answered any request; such requests no longer
 * wait. Data has no effect.
 *
 * A reply is matched to the oldest waiting request of the command whose descriptor it echoes, if
 * its response is of a type that the request expects. Nothing else in MIP identifies it: without a
 * barrier, the late reply to a request that has timed out or was cancelled would answer the next
 * request of the same command, even if that asks for other values, for example of another
 * descriptor set.
 */
MIP_API bool mip_client_receive(struct mip_client *client, const struct mip_packet *packet);

/**
 * Writes the barrier that must be sent before the next packet of commands, and returns its size;
 * 0 if every earlier command was answered. `bytes` must have room for MIP_MAX_BARRIER. Call this
 * before the first mip_client_add of each packet, and send these bytes, so that a late reply is
 * never matched to another request:
 *
 *     size = mip_client_barrier(&client, bytes);
 *     ... send these bytes, if there are any ...
 *     mip_builder_start(...);
 *     mip_client_add(...);
 *
 * A barrier is a packet of several commands that change nothing (MIP_BARRIER_DESCRIPTOR). The
 * device replies in order, and to all commands of a packet in one packet; their number identifies
 * the barrier. Before the reply to the barrier, no reply is matched to a request sent after it;
 * after that, none is matched to a request sent before it, which has timed out. If the barrier is
 * not answered, the requests after it time out, although the device may have carried them out.
 */
MIP_API size_t mip_client_barrier(struct mip_client *client, uint8_t *bytes);

/** Is this packet the reply to a barrier? mip_client_receive calls this. Before mip_client_next,
 * call it yourself, and ignore the packet if it returns true. */
MIP_API bool mip_client_passes(struct mip_client *client, const struct mip_packet *packet);

/** Counts a command that was sent without a request, and whose reply may still arrive, so that a
 * barrier precedes the next packet. */
MIP_API void mip_client_miss(struct mip_client *client);

/** Matches an acknowledge field of a packet, whose payload ends at `end`, to a request, and returns
 * that, or NULL. If the response follows, replaces `field` by it. */
MIP_API struct mip_request *mip_client_match(struct mip_client *client, const uint8_t *end,
                                             struct mip_field *field);

/**
 * Does the same as mip_client_receive field by field, for callers that also use the other fields of
 * the packet: continues a walk, from its start or any other point. Returns false at the end.
 * Otherwise, either `*answered` is the request that was answered, and `*field` its response or,
 * without one, the acknowledge; or `*answered` is NULL, and `*field` does not answer a request.
 *
 *     struct mip_walk walk = mip_walk_packet(&packet);
 *     while (mip_client_next(&client, &walk, &answered, &field)) { ... }
 *
 * If you send barriers, call mip_client_passes first.
 */
static inline bool mip_client_next(struct mip_client *client, struct mip_walk *walk,
                                   struct mip_request **answered, struct mip_field *field) {
    const bool more = mip_walk_next(walk, field);
    *answered = NULL;
    if (more && client->waiting != NULL && field->descriptor == MIP_ACKNOWLEDGE_DESCRIPTOR) {
        *answered = mip_client_match(client, walk->end, field);
        walk->at = field->data + field->size;
    }
    return more;
}

/**
 * Updates the time. Call this when mip_parser_next has returned false, until both return false;
 * then all overdue requests have timed out. Before a request times out, this searches the bytes
 * that the parser holds back, because noise that looks like the start of a packet may hide a reply.
 * If it finds a packet, it returns true; handle that packet like any other. An incomplete packet is
 * kept. `parser` is the parser that finds the packets, or NULL.
 */
MIP_API bool mip_client_poll(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                             struct mip_packet *packet);

/** Cancels a request, so that its memory may be reused. A deferred one: mip_device_cancel. */
MIP_API void mip_client_cancel(struct mip_client *client, struct mip_request *request);

#ifdef __cplusplus
}
#endif

#endif
