/* One call for each command: every outcome, handlers, and time, at a scripted port. */
#include "check.h"

#include "mip/measurements.h"
#include "mip/shared.h"
#include "mip/tools_commands.h"

/* Bytes that will arrive, and when. */
struct event {
    uint32_t at;
    size_t size;
    uint8_t bytes[MIP_MAX_PACKET];
};

struct line {
    struct event events[200];
    size_t count, next, taken;
    /* Bytes of one read at most, how long a read takes, and how long it waits if there is nothing. */
    size_t limit;
    uint32_t takes, waits, clock;
    /* What was written last, and how much was read and written. */
    uint8_t sent[MIP_MAX_PACKET];
    size_t sent_size;
    unsigned reads, writes;
    bool gone, deaf, boasts, endless, ends;
};

static struct line line, other;
static struct mip_device device;

static bool line_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    struct line *l = (struct line *)user;
    CHECK(*count == 0 && size > 0);
    l->reads++;
    l->clock += l->takes;
    if (l->boasts) {
        *count = size + 1;
        return true;
    }
    if (l->endless) {
        memset(bytes, 0, size);
        *count = size;
        return true;
    }
    while (*count < size && *count < l->limit && l->next < l->count &&
           l->clock - l->events[l->next].at < UINT32_C(0x80000000)) {
        const struct event *e = &l->events[l->next];
        bytes[(*count)++] = e->bytes[l->taken++];
        if (l->taken == e->size) {
            l->taken = 0;
            l->next++;
        }
    }
    if (*count == 0) {
        l->clock += l->waits;
        return !l->gone;
    }
    return !l->ends;
}

static bool line_write(void *user, const uint8_t *bytes, size_t size) {
    struct line *l = (struct line *)user;
    CHECK(size <= sizeof(l->sent));
    memcpy(l->sent, bytes, size);
    l->sent_size = size;
    l->writes++;
    return !l->deaf;
}

static uint32_t line_now(void *user) {
    return ((struct line *)user)->clock;
}

static const struct mip_port port = {line_read, line_write, line_now, &line};
static const struct mip_port other_port = {line_read, line_write, line_now, &other};

/* What the handlers were called with. */
struct seen {
    struct mip_field fields[400];
    uint32_t arrived[400];
    size_t count;
};

static struct seen seen, rest;

static void forget(void) {
    seen.count = rest.count = 0;
}

static void fresh_line(struct line *l, uint32_t start) {
    memset(l, 0, sizeof(*l));
    l->limit = SIZE_MAX;
    l->waits = 10;
    l->clock = start;
}

static void fresh(const struct mip_handler *handlers, size_t count) {
    fresh_line(&line, 5000);
    forget();
    mip_device_init(&device, &port, count, handlers);
}

/* Lets bytes arrive after `delay`. */
static void bytes_come(struct line *l, uint32_t delay, const void *bytes, size_t size) {
    struct event *e = &l->events[l->count++];
    CHECK(l->count <= sizeof(l->events) / sizeof(l->events[0]) && size <= sizeof(e->bytes));
    e->at = l->clock + delay;
    e->size = size;
    memcpy(e->bytes, bytes, size);
}

/* Lets a packet of raw fields arrive after `delay`. */
static void packet_comes(struct line *l, uint32_t delay, uint8_t set, const char *payload, size_t size) {
    const struct mip_packet p = packet_of(set, payload, size);
    bytes_come(l, delay, p.bytes, p.size);
}

#define COMES(delay, set, payload) packet_comes(&line, delay, set, payload, sizeof(payload) - 1)

#define PONG "\x04\xF1\x01\0"
#define SETTINGS "\x04\xF1\x02\0\x0B\x82\x01\x02\0\0\x25\x80\0\x07\x01"
#define ACCEL "\x10\x01\x3F\x80\0\0\0\0\0\0\0\0\0\0\0\0"
#define TIME "\x06\xD3\0\0\0\x07"

static bool is(struct mip_result r, enum mip_outcome outcome, uint8_t code, mip_error error) {
    return r.outcome == outcome && r.code == code && r.error == error &&
           mip_succeeded(r) == (outcome == MIP_ACKNOWLEDGED || outcome == MIP_SENT);
}

static bool is_zero(const void *value, size_t size) {
    const uint8_t *bytes = (const uint8_t *)value;
    while (size > 0 && bytes[size - 1] == 0) {
        size--;
    }
    return size == 0;
}

static void see(void *user, const struct mip_field *field, uint32_t arrived) {
    struct seen *s = (struct seen *)user;
    CHECK(s->count < sizeof(s->fields) / sizeof(s->fields[0]));
    s->fields[s->count] = *field;
    s->arrived[s->count++] = arrived;
}

static const struct mip_handler all[] = {{MIP_ANY_FIELD, MIP_ANY_SET, see, &seen}};

/* ------------------------------------------------------------------------------------ outcomes */

static void answers(void) {
    struct mip_tools_settings_response response;
    fresh(NULL, 0);
    COMES(20, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK));
    CHECK(line.clock == 5020 && is_packet((struct mip_packet){line.sent, line.sent_size, 1},
                                          "\x75\x65\x01\x02\x02\x01\xE0\xC6", 8));
    COMES(20, 0x01, SETTINGS);
    CHECK(is(mip_call_tools_settings_read(&device, 1, MIP_MODE_SLOW, &response), MIP_ACKNOWLEDGED, 0, MIP_OK));
    CHECK(response.baud == 9600 && response.mode == MIP_MODE_SLOW && response.limit == 7);
    CHECK(line.sent_size == 11 && memcmp(line.sent + 4, "\x05\x02\x02\x01\x02", 5) == 0);
    COMES(20, 0x01, SETTINGS); /* the caller does not want the response */
    CHECK(is(mip_call_tools_settings_read(&device, 1, MIP_MODE_SLOW, NULL), MIP_ACKNOWLEDGED, 0, MIP_OK));

    /* Without a function, no device would answer: nothing is sent. */
    struct mip_tools_settings command;
    memset(&command, 0, sizeof(command));
    line.sent_size = 0;
    CHECK(is(mip_call_tools_settings_with(&device, &command, NULL), MIP_NOT_SENT, 0, MIP_ERROR_MISSING));
    CHECK(line.sent_size == 0);

    struct mip_tools_status_old old; /* the device has another layout */
    COMES(20, 0x01, "\x04\xF1\x04\0\x11\x90\x12\x67\x02\0\0\0\0\0\0\0\0\0\0\0\x05");
    CHECK(is(mip_call_for_tools_status_old(&device, &old), MIP_UNDECODABLE, 0, MIP_ERROR_LAYOUT));
    CHECK(device.client.waiting == NULL);
}

/* The reply to a read, and its outcome; the caller's structure has zeros. */
static void fails(const char *reply, size_t size, struct mip_result wanted, const char *reason) {
    struct mip_tools_settings_response response;
    memset(&response, 0xAA, sizeof(response));
    packet_comes(&line, 20, 0x01, reply, size);
    const struct mip_result r = mip_call_tools_settings_read(&device, 9, MIP_MODE_FAST, &response);
    CHECK(is(r, wanted.outcome, wanted.code, wanted.error) && is_zero(&response, sizeof(response)));
    CHECK(strcmp(mip_result_reason(r), reason) == 0);
}

#define FAILS(reply, reason, ...) fails(reply, sizeof(reply) - 1, (struct mip_result){__VA_ARGS__, false}, reason)

static void refusals(void) {
    fresh(NULL, 0);
    FAILS("\x04\xF1\x02\x03", "invalid_parameter", MIP_REFUSED, MIP_ACK_CODE_INVALID_PARAMETER, MIP_OK);
    FAILS("\x04\xF1\x02\x77", "unknown", MIP_REFUSED, 0x77, MIP_OK); /* a code that nobody knows */
    FAILS("\x04\xF1\x02\0", "", MIP_MISSING_RESPONSE, 0, MIP_OK);
    FAILS("\x04\xF1\x02\0\x04\x82\x01\x02", "truncated", MIP_UNDECODABLE, 0, MIP_ERROR_TRUNCATED);
}

static void no_answers(void) {
    fresh(all, 1);
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK));
    CHECK(line.clock == 6000 && device.client.waiting == NULL);
    COMES(0, 0x01, PONG); /* too late: unsolicited */
    CHECK(mip_device_poll(&device) && seen.count == 1 && mip_field_key(&seen.fields[0]) == MIP_PROTOCOL_ACKNOWLEDGE);
    device.client.timeout = 100;
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK) && line.clock == 6100);
    line.clock = UINT32_MAX - 40; /* the time wraps around meanwhile */
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK) && line.clock == 59);

    /* These are not answered: nothing is read. */
    line.clock += 10000;
    const unsigned reads = line.reads;
    CHECK(is(mip_call_tools_set_time_apply(&device, MIP_MODE_FAST, 5), MIP_SENT, 0, MIP_OK) && line.reads == reads);
    CHECK(is(mip_device_tell(&device, &mip_tools_ping_command, NULL), MIP_SENT, 0, MIP_OK) && line.reads == reads);

    /* A command that does not fit is not sent. */
    const unsigned writes = line.writes;
    static const struct mip_segment segments[255];
    struct mip_result r = mip_call_tools_formats(&device, false, 255, 0, segments);
    CHECK(is(r, MIP_NOT_SENT, 0, MIP_ERROR_COUNT) && line.writes == writes && device.client.waiting == NULL);
    CHECK(strcmp(mip_result_reason(r), "count") == 0);
    line.deaf = true;
    r = mip_call_tools_ping(&device);
    CHECK(is(r, MIP_NOT_SENT, 0, MIP_OK) && line.reads == reads && device.client.waiting == NULL);
    CHECK(strcmp(mip_result_reason(r), "") == 0);
}

/* The answer to a command that has timed out is not that of the next one. */
static void late_answers(void) {
    fresh(all, 1);
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK));
    bytes_come(&line, 0, "ue\x80\xFF", 4); /* noise hides it */
    COMES(0, 0x01, PONG);
    COMES(0, 0x80, ACCEL);
    COMES(10, 0x01, PONG PONG); /* the barrier */
    COMES(20, 0x01, "\x04\xF1\x01\x03");
    unsigned writes = line.writes;
    CHECK(is(mip_call_tools_ping(&device), MIP_REFUSED, MIP_ACK_CODE_INVALID_PARAMETER, MIP_OK));
    CHECK(seen.count == 2 && mip_field_key(&seen.fields[0]) == MIP_PROTOCOL_ACKNOWLEDGE);
    CHECK(device.parser.skipped == 4 && line.writes == writes + 2);

    /* There is no second barrier. */
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK) && line.writes == writes + 3);

    /* While a barrier is not answered, replies may be late; so may those of the barrier. */
    device.client.timeout = 100;
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK));
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK));
    COMES(0, 0x01, PONG PONG);
    COMES(0, 0x01, PONG);
    COMES(0, 0x01, PONG PONG PONG);
    COMES(0, 0x01, "\x04\xF1\x01\x03");
    CHECK(is(mip_call_tools_ping(&device), MIP_REFUSED, MIP_ACK_CODE_INVALID_PARAMETER, MIP_OK));

    /* Bytes without end do not delay a command. */
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK));
    line.endless = true;
    line.deaf = true; /* so that it does not wait afterwards */
    const unsigned reads = line.reads;
    writes = line.writes;
    CHECK(is(mip_call_tools_ping(&device), MIP_NOT_SENT, 0, MIP_OK) && line.writes == writes + 1);
    CHECK(line.reads == reads);
}

/* A device may acknowledge a command that nobody waits for: that does not answer the next one. */
static void told_acknowledges(void) {
    fresh(all, 1);
    for (unsigned i = 1; i <= 2; i++) { /* no barrier precedes them */
        CHECK(is(mip_device_tell(&device, &mip_tools_ping_command, NULL), MIP_SENT, 0, MIP_OK) && line.writes == i);
    }
    COMES(0, 0x01, PONG);
    COMES(0, 0x01, PONG);
    COMES(0, 0x01, PONG PONG); /* the barrier, which is the same after any number of them */
    COMES(0, 0x01, "\x04\xF1\x01\x03");
    CHECK(is(mip_call_tools_ping(&device), MIP_REFUSED, MIP_ACK_CODE_INVALID_PARAMETER, MIP_OK));
    CHECK(line.writes == 4 && seen.count == 2);

    /* None follows a command that is never answered. */
    struct mip_tools_set_time command;
    mip_tools_set_time_apply(&command, MIP_MODE_FAST, 5);
    CHECK(is(mip_device_tell(&device, &mip_tools_set_time_command, &command), MIP_SENT, 0, MIP_OK));
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK) && line.writes == 6);
}

static void closed(void) {
    fresh(all, 1);
    line.gone = true;
    CHECK(is(mip_call_tools_ping(&device), MIP_CLOSED, 0, MIP_OK));
    CHECK(line.reads == 1 && device.client.waiting == NULL && !mip_device_poll(&device));
    /* What has arrived, or arrives with the end, is not lost, even behind noise; nor is an answer in it. */
    for (int with_end = 0; with_end < 2; with_end++) {
        fresh(all, 1);
        *(with_end ? &line.ends : &line.gone) = true;
        bytes_come(&line, 0, "ue\x80\xFF", 4);
        COMES(0, 0x80, ACCEL);
        COMES(0, 0x01, PONG);
        CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK) && seen.count == 1);
        COMES(0, 0x80, ACCEL);
        CHECK(mip_device_poll(&device) == !with_end && seen.count == 2);
    }
    /* After a read that failed, an answer may be that of the command before. */
    fresh(all, 1);
    line.gone = true;
    CHECK(is(mip_call_tools_ping(&device), MIP_CLOSED, 0, MIP_OK));
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_CLOSED, 0, MIP_OK));
    /* The same after a write that failed: a part may have been sent. */
    fresh(all, 1);
    line.deaf = true;
    CHECK(is(mip_call_tools_ping(&device), MIP_NOT_SENT, 0, MIP_OK));
    line.deaf = false;
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK));
    fresh(all, 1);
    line.gone = true;
    /* Requests that the caller has added time out, even if nothing arrives. */
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder b;
    struct mip_request request;
    mip_builder_start(&b, bytes, sizeof(bytes), MIP_TOOLS_SET);
    CHECK(mip_send_tools_ping(&device.client, &request, &b, line.clock) == MIP_OK);
    for (int i = 0; i < 100; i++) {
        CHECK(!mip_device_poll(&device));
    }
    CHECK(request.result.outcome == MIP_TIMED_OUT);
    /* A read that reports more bytes than there is room for. */
    fresh(NULL, 0);
    line.boasts = true;
    CHECK(is(mip_call_tools_ping(&device), MIP_CLOSED, 0, MIP_OK) && !mip_device_poll(&device));
}

static struct mip_result inner;
static struct mip_tools_settings_response inner_response;

static void call_again(void *user, const struct mip_field *field, uint32_t arrived) {
    (void)field, (void)arrived;
    memset(&inner_response, 0xAA, sizeof(inner_response));
    inner = mip_call_tools_settings_read((struct mip_device *)user, 1, MIP_MODE_FAST, &inner_response);
    /* False for its own device: otherwise, a loop in a handler would never end. */
    CHECK(mip_device_poll((struct mip_device *)user) == (user != &device));
}

static void busy(void) {
    const struct mip_handler again = {&mip_measurements_accel_codec, MIP_ANY_SET, call_again, &device};
    fresh(&again, 1);
    COMES(0, 0x80, ACCEL);
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK));
    CHECK(is(inner, MIP_BUSY, 0, MIP_OK) && is_zero(&inner_response, sizeof(inner_response)));
    CHECK(line.writes == 1 && line.reads == 1);

    /* It may call another device. */
    struct mip_device second;
    const struct mip_handler call_other = {&mip_measurements_accel_codec, MIP_ANY_SET, call_again, &second};
    fresh(&call_other, 1);
    fresh_line(&other, 77);
    mip_device_init(&second, &other_port, 0, NULL);
    packet_comes(&other, 30, 0x01, SETTINGS, sizeof(SETTINGS) - 1);
    COMES(0, 0x80, ACCEL);
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK));
    CHECK(is(inner, MIP_ACKNOWLEDGED, 0, MIP_OK) && inner_response.baud == 9600 && other.clock == 107 + 10);
}

/* A call that does not wait: its reply arrives later, in pieces, is overdue, or the command cannot be sent. */
static struct mip_request later[2];

static void call_later(void *user, const struct mip_field *field, uint32_t arrived) {
    (void)field, (void)arrived;
    CHECK(is(mip_call_tools_ping(mip_defer((struct mip_device *)user, &later[1])), MIP_WAITING, 0, MIP_OK));
    CHECK(!mip_device_step((struct mip_device *)user, (const uint8_t *)"\x75", 1)); /* nothing is used in a handler */
    CHECK(((struct mip_device *)user)->parser.length == 0);
}

static void deferred(void) {
    static const uint8_t pong[] = {0x75, 0x65, 0x01, 0x04, 0x04, 0xF1, 0x01, 0x00, 0xD5, 0x6A};
    const struct mip_handler again = {&mip_measurements_accel_codec, MIP_ANY_SET, call_later, &device};
    struct mip_tools_settings_response response;
    fresh(&again, 1);
    memset(later, 0, sizeof(later));
    CHECK(later[0].result.outcome == MIP_NOT_SENT);
    CHECK(is(mip_call_tools_ping(mip_defer(&device, &later[0])), MIP_WAITING, 0, MIP_OK) && line.reads == 0);
    CHECK(line.writes == 1 && device.deferred == NULL);
    for (size_t i = 0; i < sizeof(pong); i++) {
        CHECK(later[0].result.outcome == MIP_WAITING);
        CHECK(mip_device_step(&device, pong + i, 1));
    }
    CHECK(is(later[0].result, MIP_ACKNOWLEDGED, 0, MIP_OK) && device.client.waiting == NULL);

    /* Two wait; a handler starts the second one. Each has its own reply. */
    CHECK(is(mip_call_tools_settings_read(mip_defer(&device, &later[0]), 1, MIP_MODE_FAST, &response), MIP_WAITING, 0,
             MIP_OK));
    COMES(0, 0x80, ACCEL);
    CHECK(mip_device_poll(&device) && later[1].result.outcome == MIP_WAITING);
    COMES(0, 0x01, PONG);
    COMES(0, 0x01, SETTINGS);
    CHECK(mip_device_poll(&device) && response.baud == 9600 && later[0].result.responded);
    CHECK(is(later[1].result, MIP_ACKNOWLEDGED, 0, MIP_OK));

    /* Overdue; then a barrier precedes the next one. */
    CHECK(is(mip_call_tools_ping(mip_defer(&device, &later[0])), MIP_WAITING, 0, MIP_OK));
    line.clock += MIP_DEFAULT_TIMEOUT;
    CHECK(mip_device_step(&device, NULL, 0));
    CHECK(is(later[0].result, MIP_TIMED_OUT, 0, MIP_OK));
    const unsigned writes = line.writes;
    CHECK(is(mip_call_tools_ping(mip_defer(&device, &later[0])), MIP_WAITING, 0, MIP_OK) && line.writes == writes + 2);

    /* Used again while it waits, and one that the port cannot write. */
    line.deaf = true;
    CHECK(is(mip_call_tools_ping(mip_defer(&device, &later[0])), MIP_NOT_SENT, 0, MIP_OK));
    CHECK(is(later[0].result, MIP_NOT_SENT, 0, MIP_OK) && device.client.waiting == NULL);
}

/* Replies that come twice: what waits is taken in before a command is sent, so that it is data. */
static bool line_waits(void *user) {
    const struct line *l = (const struct line *)user;
    return l->next < l->count && l->clock - l->events[l->next].at < UINT32_C(0x80000000);
}

static bool always_waits(void *user) {
    (void)user;
    return true;
}

static void twice(void) {
    fresh(all, 1);
    device.waits = line_waits;
    memset(later, 0, sizeof(later));
    COMES(0, 0x01, PONG);
    COMES(10, 0x01, "\x04\xF1\x01\x03");
    CHECK(is(mip_call_tools_ping(&device), MIP_REFUSED, MIP_ACK_CODE_INVALID_PARAMETER, MIP_OK) && seen.count == 1);

    /* A deferred call does not read, because mip_defer has locked the device. */
    COMES(0, 0x01, PONG);
    const unsigned reads = line.reads;
    CHECK(is(mip_call_tools_ping(mip_defer(&device, &later[0])), MIP_WAITING, 0, MIP_OK) && line.reads == reads);
    CHECK(mip_device_poll(&device) && is(later[0].result, MIP_ACKNOWLEDGED, 0, MIP_OK));

    /* Bytes that arrive without end do not keep a command from being sent. */
    line.endless = true;
    device.waits = always_waits;
    device.client.timeout = 50;
    line.takes = 10;
    const unsigned writes = line.writes;
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK) && line.writes == writes + 1);
}

static void outcome_names(void) {
    static const char *const names[] = {"not sent", "acknowledged", "sent", "refused", "timed out", "missing response",
                                        "undecodable", "closed", "waiting", "busy", "no such rate"};
    for (int i = 0; i < 11; i++) {
        CHECK(strcmp(mip_outcome_name((enum mip_outcome)i), names[i]) == 0);
    }
    const struct mip_result nothing = {MIP_NOT_SENT, 0, MIP_OK, false};
    CHECK(is_zero(&nothing.outcome, sizeof(nothing.outcome)) && !mip_succeeded(nothing));
}

/* ------------------------------------------------------------------------------------ handlers */

static void handlers(void) {
    static const struct mip_handler table[] = {
        {NULL, MIP_ANY_SET, see, &rest},                           /* left empty: for no field */
        {&mip_measurements_accel_codec, MIP_MORE_SET, NULL, NULL}, /* ignored */
        {&mip_shared_timestamp_codec, MIP_ANY_SET, see, &seen},
        {&mip_measurements_accel_codec, MIP_ANY_SET, see, &seen},
        {&mip_measurements_accel_codec, MIP_ANY_SET, see, &rest}, /* never used: an earlier entry matches */
        {MIP_ANY_FIELD, MIP_ANY_SET, see, &rest},
    };
    fresh(table, 6);
    COMES(10, 0x80, TIME ACCEL "\x03\x55\x01");
    COMES(20, 0x81, TIME ACCEL);
    COMES(30, 0x01, "\x04\xF1\x09\0" PONG); /* one that nobody has asked for, and the answer */
    COMES(30, 0x80, ACCEL);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK) && line.reads == 6);
    const uint16_t accel = MIP_MEASUREMENTS_ACCEL(MIP_MEASUREMENTS_SET);
    const uint16_t wanted[] = {MIP_SHARED_TIMESTAMP, accel, MIP_SHARED_TIMESTAMP, accel};
    const uint8_t sets[] = {0x80, 0x80, 0x81, 0x80};
    const uint32_t times[] = {5010, 5010, 5020, 5030};
    CHECK(seen.count == 4 && rest.count == 2);
    for (int i = 0; i < 4; i++) {
        CHECK(mip_field_key(&seen.fields[i]) == wanted[i] && seen.arrived[i] == times[i]);
        CHECK(seen.fields[i].descriptor_set == sets[i]);
    }
    CHECK(mip_field_key(&rest.fields[0]) == 0x8055 && mip_field_key(&rest.fields[1]) == MIP_PROTOCOL_ACKNOWLEDGE);

    /* A type in each of its sets, but another handler in one of them; all fields of a set, and of no other. A field that
     * has the descriptor of the type in a set where the type does not occur is another one. */
    static struct seen second;
    static const struct mip_handler several[] = {
        {&mip_measurements_accel_codec, MIP_COPY_SET, see, &second},
        {&mip_measurements_accel_codec, MIP_ANY_SET, see, &seen},
        {&mip_measurements_radio_codec, MIP_ANY_SET, see, &seen},
        {&mip_shared_timestamp_codec, MIP_MORE_SET, see, &second},
        {MIP_ANY_FIELD, MIP_MEASUREMENTS_SET, see, &rest},
    };
    fresh(several, 5);
    COMES(0, 0x80, ACCEL TIME "\x03\x07\x01\x03\x55\x01");
    COMES(0, 0x81, ACCEL TIME "\x03\x07\x01\x03\x55\x01");
    COMES(0, 0x92, ACCEL TIME "\x03\x07\x01\x03\x55\x01");
    COMES(0, 0x93, ACCEL TIME "\x03\x07\x01\x03\x55\x01");
    while (line.next < line.count) {
        CHECK(mip_device_poll(&device));
    }
    const uint16_t any_set[] = {0x8001, 0x8007, 0x8101, 0x9207};
    const uint16_t one_set[] = {MIP_SHARED_TIMESTAMP, 0x9201};
    const uint16_t left[] = {MIP_SHARED_TIMESTAMP, 0x8055};
    CHECK(seen.count == 4 && second.count == 2 && rest.count == 2);
    for (int i = 0; i < 4; i++) {
        CHECK(mip_field_key(&seen.fields[i]) == any_set[i]);
        CHECK(mip_field_key(&second.fields[i % 2]) == one_set[i % 2]);
        CHECK(mip_field_key(&rest.fields[i % 2]) == left[i % 2]);
    }
    CHECK(second.fields[0].descriptor_set == MIP_MORE_SET);

    /* Layouts of one descriptor are types of their own. */
    static const struct mip_handler layouts[] = {
        {&mip_tools_status_old_codec, MIP_ANY_SET, see, &seen},
        {MIP_ANY_FIELD, MIP_ANY_SET, see, &rest},
    };
    fresh(layouts, 2);
    COMES(0, 0x01, "\x11\x90\x12\x67\x02\0\0\0\0\0\0\0\0\0\0\0\x05\x09\x90\x12\x67\x01\0\0\0\x05");
    CHECK(mip_device_poll(&device) && seen.count + rest.count == 2);
    CHECK(rest.count > 0 && rest.fields[rest.count - 1].size == 7);

    /* A handler for the acknowledges of all sets; other fields, which have none, are dropped. */
    static const struct mip_handler few[] = {{&mip_protocol_acknowledge_codec, MIP_ANY_SET, see, &seen}};
    fresh(few, 1);
    COMES(0, 0x01, "\x04\xF1\x09\0");
    COMES(0, 0x0C, "\x04\xF1\x10\0");
    COMES(0, 0x80, "\x04\xF1\x10\0"); /* of a data set, it is something else */
    CHECK(mip_device_poll(&device) && seen.count == 2 && device.parser.skipped == 0);
    struct mip_handler filled[] = {few[0], {NULL, MIP_ANY_SET, NULL, NULL}};
    fresh(filled, 2);
    COMES(0, 0x80, ACCEL);
    CHECK(mip_device_poll(&device) && seen.count == 0);
    filled[1].type = &mip_measurements_accel_codec; /* an empty entry is filled while data arrives */
    filled[1].handle = see;
    filled[1].user = &seen;
    COMES(0, 0x80, ACCEL);
    CHECK(mip_device_poll(&device) && seen.count == 1);
    mip_device_init(&device, &port, 3, NULL); /* none, whatever their number */
    COMES(0, 0x80, ACCEL);
    CHECK(mip_device_poll(&device) && line.next == line.count);
}

/* A handler can see the other fields of its packet. */
static struct mip_device *owner;

static void see_time(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_walk walk = mip_walk_packet(owner->packet);
    struct mip_field other_field;
    (void)arrived;
    CHECK(owner->packet->descriptor_set == field->descriptor_set);
    while (mip_walk_next(&walk, &other_field)) {
        *(unsigned *)user += mip_field_key(&other_field) == MIP_SHARED_TIMESTAMP;
    }
}

static void packets(void) {
    static unsigned stamped;
    const struct mip_handler accel = {&mip_measurements_accel_codec, MIP_ANY_SET, see_time, &stamped};
    owner = &device;
    fresh(&accel, 1);
    COMES(0, 0x80, ACCEL);
    COMES(0, 0x81, TIME);
    CHECK(device.packet == NULL && mip_device_poll(&device) && stamped == 0);
    COMES(0, 0x80, ACCEL TIME);
    CHECK(mip_device_poll(&device) && stamped == 1 && device.packet == NULL);
}

/* However reads cut the stream, and whatever is called meanwhile, each field is handled once. */
static void nothing_is_lost(void) {
    for (size_t limit = 1; limit < 300; limit = limit * 3 / 2 + 1) {
        fresh(all, 1);
        line.limit = limit;
        for (int i = 0; i < 30; i++) {
            COMES((uint32_t)(10 * i), 0x80, TIME ACCEL);
            COMES((uint32_t)(10 * i), 0x01, PONG);
            COMES((uint32_t)(10 * i), 0x80, ACCEL);
        }
        for (int i = 0; i < 30; i++) {
            CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK));
        }
        while (line.next < line.count) {
            CHECK(mip_device_poll(&device));
        }
        CHECK(device.parser.skipped == 0 && line.reads >= line.count * 8 / limit);
        /* Of replies that came together, one answered the ping; the others were unsolicited. */
        size_t data = 0;
        for (size_t i = 0; i < seen.count; i++) {
            data += seen.fields[i].descriptor_set == 0x80;
        }
        CHECK(data == 90 && seen.count <= 120);
    }
}

/* ---------------------------------------------------------------------------------------- time */

static void poll_for(uint32_t time) {
    const uint32_t start = line.clock;
    while (line.clock - start < time) {
        CHECK(mip_device_poll(&device));
    }
}

static void parser_time_out(uint32_t start) {
    fresh(all, 1);
    line.clock = start;
    bytes_come(&line, 0, "ue\x80\xFF", 4); /* looks like the start of a long packet */
    COMES(0, 0x80, ACCEL);
    poll_for(MIP_DEFAULT_SILENCE - 10);
    CHECK(seen.count == 0 && device.parser.skipped == 0);
    poll_for(20);
    CHECK(seen.count == 1 && seen.arrived[0] == start && device.parser.skipped == 4);

    /* A pause shorter than `silence` cuts no packet; a longer one does. */
    forget();
    bytes_come(&line, 0, "ue\x80\x03\x03", 5);
    bytes_come(&line, 250, "\x55", 1);
    bytes_come(&line, 500, "\x01\xB6\xD1", 3);
    poll_for(600);
    CHECK(seen.count == 1 && seen.arrived[0] - start > 500 && device.parser.skipped == 4);
    bytes_come(&line, 0, "ue\x80\x03\x03", 5);
    bytes_come(&line, 400, "\x55\x01\xB6\xD1", 4);
    poll_for(800);
    CHECK(seen.count == 1 && device.parser.skipped == 13);

    /* Without it, noise holds back what follows, until a command that waits looks behind it. */
    device.silence = 0;
    forget();
    bytes_come(&line, 0, "ue\x80\xFF", 4);
    COMES(0, 0x80, ACCEL);
    COMES(0, 0x01, PONG);
    poll_for(5000);
    CHECK(seen.count == 0);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK) && seen.count == 1);
}

/* The calls of an observer, with those of handlers in between: "(a)" is a packet with an acceleration, "~" a
 * gap of six bytes. */
static char told[100];
static uint32_t gap;

static void tell(void *user, const struct mip_device *of, bool ends) {
    CHECK(user == &gap && of == &device && of->packet != NULL && of->heard == line.clock);
    CHECK(!mip_device_poll(&device) && mip_call_tools_ping(&device).outcome == MIP_BUSY);
    const uint32_t skipped = mip_gap(of, &gap);
    CHECK(skipped == 0 || (skipped == 6 && !ends));
    strcat(told, skipped > 0 ? "~(" : ends ? ")"
                                           : "(");
}

static void tell_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    (void)user, (void)field, (void)arrived;
    strcat(told, "a");
}

/* Each packet begins and ends once, whatever is in it: even replies, no field, or a truncated field. */
static void observers(void) {
    static const struct mip_handler accels[] = {{&mip_measurements_accel_codec, MIP_ANY_SET, tell_accel, NULL}};
    static const struct mip_observer observer = {tell, &gap};
    static const uint8_t cut[] = {0x75, 0x65, 0x80, 0x02, 0x05, 0x01, 0x62, 0xC8};
    struct mip_packet packet;
    fresh(accels, 1);
    told[0] = '\0';
    gap = 0;
    device.observer = &observer;
    COMES(10, 0x80, TIME ACCEL ACCEL);
    COMES(10, 0x80, "");
    bytes_come(&line, 10, "$GPGGA", 6);
    COMES(10, 0x80, TIME);
    COMES(10, 0x01, PONG);
    CHECK(mip_packet_check(cut, sizeof(cut), &packet) == MIP_OK);
    bytes_come(&line, 10, cut, sizeof(cut));
    CHECK(mip_call_tools_ping(&device).outcome == MIP_ACKNOWLEDGED);
    poll_for(1000);
    CHECK(strcmp(told, "(aa)()~()()()") == 0);

    device.observer = NULL;
    COMES(10, 0x80, ACCEL);
    poll_for(1000);
    CHECK(strcmp(told, "(aa)()~()()()a") == 0);
}

static void dawdle(void *user, const struct mip_field *field, uint32_t arrived) {
    (void)field, (void)arrived;
    ((struct line *)user)->clock += 40;
}

/* A slow host does not report a time-out while the reply waits to be read. */
static void backlog(void) {
    static const struct mip_handler slow[] = {{&mip_measurements_accel_codec, MIP_ANY_SET, dawdle, &line}};
    fresh(slow, 1);
    device.client.timeout = 100;
    for (int i = 0; i < 14; i++) { /* more than one read returns */
        COMES(0, 0x80, ACCEL "\x14\x66                  ");
    }
    COMES(0, 0x01, PONG);
    CHECK(is(mip_call_tools_ping(&device), MIP_ACKNOWLEDGED, 0, MIP_OK) && line.clock >= 5000 + 400);

    /* Nor does it wait longer than its time-out and MIP_BACKLOG, */
    fresh(NULL, 0);
    line.endless = true;
    line.takes = 10;
    device.client.timeout = 50;
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK) && line.clock == 5000 + 50 + MIP_BACKLOG);

    /* even if that is the longest: it does not seem to have passed at once. */
    fresh(NULL, 0);
    device.client.timeout = UINT32_MAX;
    CHECK(is(mip_call_tools_ping(mip_defer(&device, &later[0])), MIP_WAITING, 0, MIP_OK));
    line.endless = true;
    CHECK(mip_device_poll(&device) && later[0].result.outcome == MIP_WAITING);
    line.clock += MIP_MAX_TIMEOUT + MIP_BACKLOG - 1;
    CHECK(mip_device_poll(&device) && later[0].result.outcome == MIP_WAITING);
    line.clock += 1;
    CHECK(mip_device_poll(&device) && later[0].result.outcome == MIP_TIMED_OUT);

    /* or for ever. */
    fresh(NULL, 0);
    line.endless = true;
    line.takes = 10;
    CHECK(is(mip_call_tools_ping(&device), MIP_TIMED_OUT, 0, MIP_OK) && line.clock == 6000 + MIP_BACKLOG);
}

int main(void) {
    answers();
    refusals();
    no_answers();
    late_answers();
    told_acknowledges();
    closed();
    busy();
    deferred();
    twice();
    outcome_names();
    handlers();
    packets();
    nothing_is_lost();
    parser_time_out(5000);
    parser_time_out(UINT32_MAX - 100);
    observers();
    backlog();
    return 0;
}
