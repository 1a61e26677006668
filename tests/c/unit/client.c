/* The command client as C programs use it: adding, expecting, cancelling and time, with the packets of a scripted device.
 * What answers what is in the conformance suite, whose driver uses the functions below these. */
#include "check.h"

#include "mip/tools_commands.h"

static uint8_t sent[MIP_MAX_PACKET];
static struct mip_builder packet;
static struct mip_client client;

static struct mip_builder *fresh(void) {
    CHECK(mip_builder_start(&packet, sent, sizeof(sent), MIP_TOOLS_SET) == MIP_OK);
    return &packet;
}

/* The device sends a packet of raw fields. */
static bool receive(uint8_t set, const char *payload, size_t size) {
    const struct mip_packet p = packet_of(set, payload, size);
    return mip_client_receive(&client, &p);
}

#define RECEIVE(set, payload) receive(set, payload, sizeof(payload) - 1)

static size_t waiting(void) {
    size_t count = 0;
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        count++;
    }
    return count;
}

/* Time passes without a parser: how many requests does it end? */
static size_t expire(uint32_t now) {
    const size_t before = waiting();
    CHECK(!mip_client_poll(&client, NULL, now, NULL));
    return before - waiting();
}

static void expect(struct mip_request *request, const struct mip_codec *codec, void *response) {
    CHECK(mip_client_expect(request, codec, response));
}

static void add(struct mip_request *request, const struct mip_command *command, const void *value, uint32_t now) {
    CHECK(mip_client_add(&client, request, &packet, command, value, now) == MIP_OK);
}

static void answered(void) {
    struct mip_request r;
    struct mip_tools_settings_response response;
    struct mip_tools_settings read;
    mip_tools_settings_read(&read, 1, MIP_MODE_FAST);
    memset(&response, 0xAA, sizeof(response));
    fresh();
    CHECK(mip_send_tools_settings(&client, &r, &packet, &read, &response, 0) == MIP_OK && response.baud == 0);
    CHECK(r.result.outcome == MIP_WAITING && !RECEIVE(0x80, "\x04\xF1\x02\0"));
    CHECK(is_packet(mip_builder_finish(&packet), "\x75\x65\x01\x05\x05\x02\x02\x01\x01\xEB\x94", 11));
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0\x0B\x82\x01\x02\0\0\x25\x80\0\x07\x01"));
    CHECK(r.result.outcome == MIP_ACKNOWLEDGED && r.result.code == MIP_ACK_CODE_OK && client.waiting == NULL);
    CHECK(r.result.responded && response.baud == 9600 && response.mode == MIP_MODE_SLOW && response.limit == 7);
}

static void not_sent(void) {
    struct mip_request r[2] = {{.result = {.outcome = MIP_WAITING}}, {.result = {.outcome = MIP_WAITING}}};
    struct mip_tools_settings none;
    memset(&none, 0, sizeof(none));
    const size_t before = fresh()->length;
    CHECK(mip_client_add(&client, &r[0], &packet, &mip_tools_settings_command, &none, 0) == MIP_ERROR_MISSING);
    CHECK(r[0].result.outcome == MIP_NOT_SENT && r[0].result.error == MIP_ERROR_MISSING);
    CHECK(client.waiting == NULL && packet.error == MIP_ERROR_MISSING);
    CHECK(packet.length == before && is_packet(mip_builder_finish(&packet), "\x75\x65\x01\x00\xDB\x05", 6));

    /* Nor does a command wait that does not fit, or belongs to another set; those before it do. */
    struct mip_builder other;
    uint8_t bytes[MIP_MAX_PACKET];
    CHECK(mip_builder_start(&other, bytes, 6 + 2, MIP_TOOLS_SET) == MIP_OK);
    CHECK(mip_client_add(&client, &r[0], &other, &mip_tools_ping_command, NULL, 0) == MIP_OK);
    CHECK(mip_client_add(&client, &r[1], &other, &mip_tools_ping_command, NULL, 0) == MIP_ERROR_LENGTH);
    CHECK(r[1].result.outcome == MIP_NOT_SENT && client.waiting == &r[0] && r[0].next == NULL);
    mip_client_cancel(&client, &r[0]);
    CHECK(mip_builder_start(&other, bytes, sizeof(bytes), 0x7F) == MIP_OK);
    CHECK(mip_client_add(&client, &r[0], &other, &mip_tools_ping_command, NULL, 0) == MIP_ERROR_SET);
    CHECK(r[0].result.outcome == MIP_NOT_SENT && client.waiting == NULL && other.length == MIP_HEADER_SIZE);

    /* A request that still waits and is used again waits once. */
    fresh();
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    add(&r[1], &mip_tools_ping_command, NULL, 0);
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    CHECK(client.waiting == &r[1] && r[1].next == &r[0] && r[0].next == NULL);
    CHECK(expire(10000) == 2);
}

/* A longer time-out of the caller, up to the longest. */
static void timed_out(void) {
    struct mip_request r;
    struct mip_tools_status status;
    mip_tools_status_make(&status, 1); /* which has a time-out of its own */
    client.timeout = 5000;
    fresh();
    add(&r, &mip_tools_status_command, &status, 0);
    CHECK(expire(4999) == 0);
    mip_client_cancel(&client, &r);
    CHECK(r.result.outcome == MIP_CLOSED && client.waiting == NULL);
    mip_client_cancel(&client, &r); /* once more does no harm */
    CHECK(expire(9999) == 0 && r.result.outcome == MIP_CLOSED);
    client.timeout = UINT32_MAX;
    fresh();
    add(&r, &mip_tools_ping_command, NULL, 1000);
    CHECK(expire(1000) == 0 && expire(MIP_MAX_TIMEOUT) == 0 && expire(1000 + MIP_MAX_TIMEOUT) == 1);
    client.timeout = MIP_DEFAULT_TIMEOUT;
}

/* Only a response that the values select can have a place. */
static void responses(void) {
    struct mip_request r;
    struct mip_tools_settings_response settings;
    struct mip_tools_set_time_fast_response fast;
    struct mip_tools_set_time_slow_response slow;
    struct mip_tools_set_time command;
    mip_tools_set_time_read(&command, MIP_MODE_SLOW);
    fresh();
    add(&r, &mip_tools_set_time_command, &command, 0);
    CHECK(!mip_client_expect(&r, &mip_tools_set_time_fast_response_codec, &fast) && r.response == NULL);
    CHECK(!mip_client_expect(&r, &mip_tools_settings_response_codec, &settings) && r.response == NULL);
    CHECK(!mip_client_expect(&r, NULL, &settings) && r.response == NULL);
    expect(&r, &mip_tools_set_time_slow_response_codec, &slow);
    CHECK(RECEIVE(0x01, "\x04\xF1\x03\0\x06\x84\0\0\0\x07") && r.result.responded && slow.value == 7);
    mip_tools_set_time_write(&command, MIP_MODE_SLOW, 1); /* it asks for none */
    add(&r, &mip_tools_set_time_command, &command, 0);
    CHECK(!mip_client_expect(&r, &mip_tools_set_time_slow_response_codec, &slow));
    CHECK(RECEIVE(0x01, "\x04\xF1\x03\0") && r.result.outcome == MIP_ACKNOWLEDGED);
    mip_tools_set_time_apply(&command, MIP_MODE_FAST, 5); /* and this is not even answered */
    add(&r, &mip_tools_set_time_command, &command, 0);
    CHECK(r.result.outcome == MIP_SENT && client.waiting == NULL);

    /* Layouts of one descriptor: one that other values select, and one that devices of another kind send. */
    struct mip_tools_status_old old = {9};
    struct mip_tools_status_short brief;
    struct mip_tools_status ask;
    mip_tools_status_make(&ask, 2);
    fresh();
    add(&r, &mip_tools_status_command, &ask, 0);
    CHECK(r.asked->layout == &mip_tools_status_long_codec && r.codec == NULL);
    CHECK(!mip_client_expect(&r, &mip_tools_status_short_codec, &brief));
    expect(&r, &mip_tools_status_old_codec, &old);
    CHECK(RECEIVE(0x01, "\x04\xF1\x04\0\x09\x90\x12\x67\x02\0\0\0\x05"));
    CHECK(r.result.outcome == MIP_ACKNOWLEDGED && r.result.responded && old.uptime == 5);
}

/* All at once: a barrier, its reply, a reply in pieces, data behind it, and time. */
static void steps(void) {
    static const uint8_t barrier[] = {0x75, 0x65, 0x01, 0x04, 0x02, 0x01, 0x02, 0x01, 0xE5, 0x21};
    static const uint8_t arriving[] = {0x75, 0x65, 0x01, 0x08, 0x04, 0xF1, 0x01, 0x00, 0x04, 0xF1, 0x01, 0x00, 0xCF,
                                       0xC7, 0x75, 0x65, 0x01, 0x04, 0x04, 0xF1, 0x01, 0x00, 0xD5, 0x6A};
    static struct mip_parser parser;
    uint8_t bytes[MIP_MAX_SENT];
    struct mip_request r;
    struct mip_packet p;
    const uint8_t *at = NULL;
    size_t left = 0;
    memset(&client, 0, sizeof(client));
    mip_client_init(&client);
    CHECK(mip_client_start(&client, &packet, bytes, MIP_TOOLS_SET) == 0);
    add(&r, &mip_tools_ping_command, NULL, 0);
    CHECK(!mip_client_step(&client, &parser, MIP_DEFAULT_TIMEOUT, &at, &left, &p));
    CHECK(r.result.outcome == MIP_TIMED_OUT);
    CHECK(mip_client_start(&client, &packet, bytes, MIP_TOOLS_SET) == sizeof(barrier));
    CHECK(memcmp(bytes, barrier, sizeof(barrier) - 2) == 0);
    add(&r, &mip_tools_ping_command, NULL, 0);
    CHECK(mip_builder_finish(&packet).bytes == bytes + sizeof(barrier));
    for (size_t i = 0, found = 0; i < sizeof(arriving); i++) {
        at = arriving + i;
        left = 1;
        CHECK(r.result.outcome == MIP_WAITING);
        found += mip_client_step(&client, &parser, 1, &at, &left, &p);
        CHECK(left == 0 && found == (i == sizeof(arriving) - 1)); /* not the reply to the barrier */
    }
    CHECK(r.result.outcome == MIP_ACKNOWLEDGED && p.descriptor_set == 0x01);
}

int main(void) {
    mip_client_init(&client);
    steps();
    answered();
    not_sent();
    timed_out();
    responses();
    return 0;
}
