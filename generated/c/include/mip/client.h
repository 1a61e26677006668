/**
 * @file
 * Commands and their answers, without input, output or a clock.
 *
 * The caller builds a packet, sends it, hands over the packets that come back, and says what time
 * it is. The caller also owns the requests: each must stay in place until it is no longer waiting.
 *
 *     mip_builder_start(&builder, buffer, sizeof(buffer), MIP_..._SET);
 *     mip_client_add(&client, &request, &builder, &mip_..._codec, &command, now);
 *     mip_client_expect(&request, &mip_..._response_codec, &response);
 *     ... send mip_builder_finish(&builder) ...
 *     while (request.state == MIP_REQUEST_WAITING) {
 *         ... mip_client_receive(&client, &packet) for each packet that mip_parser_next gives ...
 *         while (mip_client_poll(&client, &parser, now, &packet)) {
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

/** How long a device may take to answer, in milliseconds, unless the command says otherwise. */
#define MIP_DEFAULT_TIMEOUT 1000

/** No answer yet. */
#define MIP_REQUEST_WAITING 0
/** The device has carried the command out, and sent the response that belongs to it, if any. */
#define MIP_REQUEST_ACKNOWLEDGED 1
/** The device has refused the command; `code` says why. */
#define MIP_REQUEST_REFUSED 2
/** The device did not answer in time. */
#define MIP_REQUEST_TIMED_OUT 3
/** The device does not answer this command: it is done when it is sent. */
#define MIP_REQUEST_SILENT 4
/** The caller does not wait any longer. */
#define MIP_REQUEST_CANCELLED 5
/** The device has acknowledged the command, but not sent the response that belongs to it. */
#define MIP_REQUEST_MISSING_RESPONSE 6
/** The device has sent a response that cannot be decoded; `error` says why. */
#define MIP_REQUEST_UNDECODABLE 7

/** One command on its way. */
struct mip_request {
    /** A MIP_REQUEST_... value. */
    uint8_t state;
    /** The code of the answer, if there is one. */
    mip_ack_code code;
    /** Is the response in its place? */
    bool responded;
    /** A mip_error: what is wrong with the response that came; then its place is all zero. */
    uint8_t error;
    /** The command, and the response that it asks for; NULL if it asks for none. Where devices
     * answer in different layouts, it is the first one or the expected one, and in the end the one
     * that came. */
    const struct mip_codec *command;
    const struct mip_codec *codec;
    /** The responses of the command, from the one that it asks for on. */
    const struct mip_response *asked;
    /** Where the response goes; NULL if the caller does not need it. */
    void *response;
    /** When it is too late, in the milliseconds of the caller. */
    uint32_t deadline;
    /** The next one that waits. */
    struct mip_request *next;
};

/** The commands that wait for an answer, oldest first. */
struct mip_client {
    struct mip_request *waiting;
    /** Milliseconds that a device may take to answer. */
    uint32_t timeout;
};

/** Makes a client ready: nothing is waiting, and the time-out is MIP_DEFAULT_TIMEOUT. */
void mip_client_init(struct mip_client *client);

/**
 * Adds a command to a packet and waits for its answer. `now` is the time in milliseconds, which may
 * wrap around. On an error the packet stays as it was, and the request is cancelled: nothing waits
 * for it. `command` may be NULL where the command has no parameters.
 */
mip_error mip_client_add(struct mip_client *client, struct mip_request *request,
                         struct mip_builder *packet, const struct mip_codec *codec,
                         const void *command, uint32_t now);

/**
 * Says where the response goes. To be called right after mip_client_add. False, and nothing is
 * stored, if this is not the response that the command asks for with its values.
 *
 * If devices answer in different layouts, say which one this device has; if it sends another one,
 * the request is undecodable with MIP_ERROR_LAYOUT. Who does not know takes the field from
 * mip_client_next and decodes it by the `codec` of the request.
 */
bool mip_client_expect(struct mip_request *request, const struct mip_codec *codec, void *response);

/**
 * Takes a packet that has come. True if it answered anything; data and late answers disturb
 * nothing. The answered requests are no longer waiting.
 */
bool mip_client_receive(struct mip_client *client, const struct mip_packet *packet);

/**
 * The same step by step, for callers who want to know what else is in the packet: goes on in a
 * walk, which may be at its beginning. True if there was something: either `*answered` is the
 * request that has been answered, and `*field` its response or, without one, the acknowledge; or
 * `*answered` is NULL, and `*field` answers nothing.
 *
 *     struct mip_walk walk = mip_walk_packet(&packet);
 *     while (mip_client_next(&client, &walk, &answered, &field)) { ... }
 */
bool mip_client_next(struct mip_client *client, struct mip_walk *walk,
                     struct mip_request **answered, struct mip_field *field);

/**
 * Says what time it is. To be called until it returns false; then the requests whose time is over
 * are timed out. Before, it gives up what the parser holds back, as noise that looks like the
 * beginning of a packet hides an answer: true if a packet was found, which is to be handled as any.
 * `parser` is the one that the packets come from, NULL if there is none.
 */
bool mip_client_poll(struct mip_client *client, struct mip_parser *parser, uint32_t now,
                     struct mip_packet *packet);

/** Ends the waiting of one request, so that it may go away. */
void mip_client_cancel(struct mip_client *client, struct mip_request *request);

#ifdef __cplusplus
}
#endif

#endif
