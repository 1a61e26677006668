/**
 * @file
 * The command client, without input, output or a clock.
 *
 * The caller builds a packet, sends it, and passes received packets and the time to the client. The
 * caller also owns the requests: each must stay at its address until it is no longer waiting.
 *
 *     ... send mip_client_barrier(&client, bytes) bytes ...
 *     mip_builder_start(&builder, buffer, sizeof(buffer), MIP_..._SET);
 *     mip_client_add(&client, &request, &builder, &mip_..._command, &command, now);
 *     mip_client_expect(&request, &mip_..._response_codec, &response);
 *     ... send mip_builder_finish(&builder) ...
 *     while (request.state == MIP_REQUEST_WAITING) {
 *         ... read, at most, `size` bytes to `data` ...
 *         while (mip_parser_next(&parser, &data, &size, &packet) ||
 *                mip_client_poll(&client, &parser, now, &packet)) {
 *             mip_client_receive(&client, &packet);
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
/** The longest time-out, 24 days, because the time may wrap around. A longer one is shortened. */
#define MIP_MAX_TIMEOUT UINT32_C(0x7FFFFFFF)
/** The bytes of the longest barrier: 63 commands. */
#define MIP_MAX_BARRIER (6 + 2 * 63)

/** For `value` of a response: any value but 0. */
#define MIP_NOT_ZERO 0xFF

/**
 * A way in which a device answers a command, and one test of a byte of the command. Responses that
 * are linked by `more` belong together: each is a layout that may be sent if all of their tests
 * hold.
 */
struct mip_response {
    /** The wire format of the response, if its descriptor has several; else NULL. */
    const struct mip_codec *layout;
    /** Its descriptor; 0 if the device leaves the command unanswered. */
    uint8_t descriptor;
    /** The tested byte, by its offset in the field, whose first byte, the length, is never 0. A
     * missing byte counts as 0. */
    uint8_t at;
    /** The value that it must have, or MIP_NOT_ZERO. */
    uint8_t value;
    /** Does the next one belong to this one? */
    bool more;
};

/** The replies to a command. */
struct mip_exchange {
    /** Descriptor set of the command. */
    uint8_t descriptor_set;
    /** Descriptor of the command. */
    uint8_t descriptor;
    /** Quarters of a second that a device may take to answer; 0: no longer than usual. */
    uint8_t timeout;
    /** The number of responses. */
    uint8_t response_count;
    /** The first of them whose tests hold is sent; if there is none, only an acknowledge. */
    const struct mip_response *responses;
};

/** A command: its wire format, and its replies. */
struct mip_command {
    /** The wire format of the command. */
    const struct mip_codec *codec;
    /** The replies to it. */
    const struct mip_exchange *exchange;
    /** Does it begin with a function selector? */
    bool selects;
};

/** No answer yet. */
#define MIP_REQUEST_WAITING 0
/** The device has carried out the command, and sent its response, if it has one. */
#define MIP_REQUEST_ACKNOWLEDGED 1
/** The device has refused the command; `code` is the reason. */
#define MIP_REQUEST_REFUSED 3
/** The device did not answer in time. */
#define MIP_REQUEST_TIMED_OUT 4
/** The device does not answer this command: it is complete once it is sent. */
#define MIP_REQUEST_SILENT 2
/** The caller has cancelled the request. */
#define MIP_REQUEST_CANCELLED 7
/** The device has acknowledged the command without sending its response. */
#define MIP_REQUEST_MISSING_RESPONSE 5
/** The device has sent a response that cannot be decoded; `error` is the reason. */
#define MIP_REQUEST_UNDECODABLE 6

/** One command that was sent. */
struct mip_request {
    /** The next waiting request. */
    struct mip_request *next;
    /** The replies to the command. */
    const struct mip_exchange *exchange;
    /** The response that it requests; NULL if it requests none. */
    const struct mip_response *asked;
    /** The wire format of the response, if the caller expects one, or if it is one of several
     * layouts and has been received; else NULL. */
    const struct mip_codec *codec;
    /** Where the response is stored; NULL if the caller does not need it. */
    void *response;
    /** When the request times out, in the caller's milliseconds. */
    uint32_t deadline;
    /** A MIP_REQUEST_... value. */
    uint8_t state;
    /** The acknowledge code of the answer, if there is one: a value of enum mip_ack_code. */
    uint8_t code;
    /** A mip_error: what is wrong with the response; its structure is then zeroed. */
    uint8_t error;
    /** Has the response been stored? */
    bool responded;
    /** The barrier that must be answered first, by the payload of its answer. 0: none. */
    uint8_t behind;
};

/** The commands that are waiting for an answer, oldest first. */
struct mip_client {
    /** The oldest request that waits; NULL if none does. */
    struct mip_request *waiting;
    /** Milliseconds that a device may take to answer; at most MIP_MAX_TIMEOUT. */
    uint32_t timeout;
    /** The barrier to be sent next, by the payload of its answer: four bytes for each command, and
     * one command more than there were requests without an answer since the last one. 0: none. */
    uint8_t missed;
    /** The barrier that was sent, in the same form, until it is answered. 0: none. */
    uint8_t behind;
};

/** Initializes a client: no request is waiting, and the time-out is MIP_DEFAULT_TIMEOUT. */
MIP_API void mip_client_init(struct mip_client *client);

/** Adds a command to a packet. A function selector that was left 0 is MIP_ERROR_MISSING: no device
 * answers it. On an error the packet is unchanged. */
MIP_CHECKED MIP_API mip_error mip_command_encode(const struct mip_command *command,
                                                 const void *value, struct mip_builder *packet);

/**
 * Adds a command to a packet and waits for its answer. `now` is the time in milliseconds, which may
 * wrap around. On an error the packet is unchanged and the request is cancelled. `value` is the
 * structure of the command, or NULL if it has no parameters. A request that still waits in this
 * client is cancelled first; one that waits in another client must be cancelled there before.
 */
MIP_CHECKED MIP_API mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                                             struct mip_builder *packet,
                                             const struct mip_command *command, const void *value,
                                             uint32_t now);

/** The response that a command requests, or the first of several layouts; NULL if it requests none,
 * and one with descriptor 0 if the device leaves the command unanswered.
 * `field` begins with the length of the command. */
MIP_API const struct mip_response *mip_requested(const struct mip_exchange *exchange,
                                                 const uint8_t *field);

/** Waits for the answer to a command that the caller has written. The request must be zero but for
 * `exchange`, `asked`, and, set before or afterwards, `codec` and `response`. */
MIP_API void mip_client_wait(struct mip_client *client, struct mip_request *request, uint32_t now);

/**
 * Sets where the response is stored. Call it right after mip_client_add. False, and nothing is
 * stored, if the command with its values does not request this response.
 *
 * If devices answer in different layouts, state which one this device has; if it sends another one,
 * the request is undecodable with MIP_ERROR_LAYOUT. If you do not know, take the field from
 * mip_client_next and decode it by the `codec` of the request, which then is the layout received.
 */
MIP_API bool mip_client_expect(struct mip_request *request, const struct mip_codec *codec,
                               void *response);

/**
 * Both in one: adds a command, and sets where its response is stored. The structure of the response
 * is zeroed first, and stays zeroed if the command with these values does not request it;
 * `response` may be NULL. The generated functions mip_send_... call this with the types of each
 * command.
 */
MIP_CHECKED MIP_API mip_error mip_client_send(struct mip_client *client,
                                              struct mip_request *request,
                                              struct mip_builder *packet,
                                              const struct mip_command *command, const void *value,
                                              const struct mip_codec *codec, void *response,
                                              uint32_t now);

/**
 * Processes a received packet. True if it answered any request; the answered requests are no longer
 * waiting. Data has no effect.
 *
 * An answer belongs to the oldest waiting request of the command whose descriptor it echoes, if its
 * response is of a type that the request expects. MIP has no other mark: without a barrier, the
 * late answer to a request that has timed out or was cancelled answers the next one of the same
 * command, even if that one asks for other values, for example for another descriptor set.
 */
MIP_API bool mip_client_receive(struct mip_client *client, const struct mip_packet *packet);

/**
 * Writes the barrier that must be sent before the next packet of commands, and returns its size;
 * mostly 0, as no answer is late. `bytes` has room for MIP_MAX_BARRIER. Call it before the first
 * mip_client_add of each packet, and send these bytes, so that a late answer is never taken for
 * another one:
 *
 *     size = mip_client_barrier(&client, bytes);
 *     ... send these bytes, if there are any ...
 *     mip_builder_start(...);
 *     mip_client_add(...);
 *
 * It is a packet of several commands that change nothing (MIP_BARRIER_DESCRIPTOR). The device
 * answers in order, and the commands of one packet in one packet: their number identifies the
 * barrier. Until then, no answer belongs to the requests after it, and from then on, none to those
 * before it, which have timed out. A request whose barrier is not answered times out, although the
 * device may have carried it out.
 */
MIP_API size_t mip_client_barrier(struct mip_client *client, uint8_t *bytes);

/** Is a packet the answer to a barrier before waiting requests? mip_client_receive calls this; call
 * it yourself before mip_client_next, and ignore the packet if it is. */
MIP_API bool mip_client_passes(struct mip_client *client, const struct mip_packet *packet);

/** Counts a command that was sent without a request, and whose answer may still arrive: the next
 * packet must be sent after a barrier. */
MIP_API void mip_client_miss(struct mip_client *client);

/**
 * The same step by step, for callers that also use the other fields of the packet: continues a
 * walk, from its start or any other point. False at the end. Otherwise, either `*answered` is the
 * request that was answered, and `*field` its response or, without one, the acknowledge; or
 * `*answered` is NULL, and `*field` is a field that does not answer a request.
 *
 *     struct mip_walk walk = mip_walk_packet(&packet);
 *     while (mip_client_next(&client, &walk, &answered, &field)) { ... }
 *
 * After mip_client_barrier, call mip_client_passes first.
 */
MIP_API bool mip_client_next(struct mip_client *client, struct mip_walk *walk,
                             struct mip_request **answered, struct mip_field *field);

/**
 * Updates the time. Call it when mip_parser_next has returned false, until both do; then the
 * overdue requests have timed out. Before that, it searches the bytes that the parser holds back,
 * because noise that looks like the start of a packet may hide an answer: it returns true if it
 * finds a packet, which the caller handles like any other. An incomplete packet is kept. `parser`
 * is the parser of the packets, or NULL.
 */
MIP_API bool mip_client_poll(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                             struct mip_packet *packet);

/** Cancels a request, so that its memory may be reused. */
MIP_API void mip_client_cancel(struct mip_client *client, struct mip_request *request);

#ifdef __cplusplus
}
#endif

#endif
