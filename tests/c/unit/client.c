/* The command client: every outcome, with the packets of a scripted device. */
#include "check.h"

#include "mip/measurements.h"
#include "mip/tools_commands.h"

static uint8_t sent[MIP_MAX_PACKET];
static struct mip_builder packet;
static struct mip_client client;

static struct mip_builder *fresh(void) {
    CHECK(mip_builder_start(&packet, sent, sizeof(sent), MIP_TOOLS_SET) == MIP_OK);
    return &packet;
}

/* The device sends a packet made of raw fields: length, descriptor, data. */
static bool receive(uint8_t set, const char *payload, size_t size) {
    static uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder b;
    CHECK(mip_builder_start(&b, bytes, sizeof(bytes), set) == MIP_OK);
    for (size_t at = 0; at < size; at += (uint8_t)payload[at]) {
        const size_t length = (uint8_t)payload[at];
        CHECK(mip_builder_add(&b, (uint8_t)payload[at + 1], payload + at + 2, length - 2) == MIP_OK);
    }
    const struct mip_packet p = mip_builder_finish(&b);
    return mip_client_receive(&client, &p);
}

#define RECEIVE(set, payload) receive(set, payload, sizeof(payload) - 1)

/* Time passes without a parser: how many requests does it end? */
static size_t expire(uint32_t now) {
    size_t before = 0;
    size_t after = 0;
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        before++;
    }
    CHECK(!mip_client_poll(&client, NULL, now, NULL));
    for (const struct mip_request *r = client.waiting; r != NULL; r = r->next) {
        after++;
    }
    return before - after;
}

static void expect(struct mip_request *request, const struct mip_codec *codec, void *response) {
    CHECK(mip_client_expect(request, codec, response));
}

static void add(struct mip_request *request, const struct mip_command *command, const void *value, uint32_t now) {
    CHECK(mip_client_add(&client, request, &packet, command, value, now) == MIP_OK);
}

static void acknowledged(void) {
    struct mip_request r;
    struct mip_tools_settings_response response;
    struct mip_tools_settings read;
    mip_tools_settings_read(&read, 1, MIP_MODE_FAST);
    fresh();
    add(&r, &mip_tools_settings_command, &read, 0);
    expect(&r, &mip_tools_settings_response_codec, &response);
    CHECK(r.state == MIP_REQUEST_WAITING);
    CHECK(is_packet(mip_builder_finish(&packet), "\x75\x65\x01\x05\x05\x02\x02\x01\x01\xEB\x94", 11));

    /* Data, other sets and replies to other commands change nothing. */
    CHECK(!RECEIVE(0x80, "\x10\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0"));
    CHECK(!RECEIVE(0x0C, "\x04\xF1\x02\0"));
    CHECK(!RECEIVE(0x01, "\x04\xF1\x01\0"));
    CHECK(!RECEIVE(0x80, "\x04\xF1\x02\0"));
    CHECK(!RECEIVE(0x01, "\x03\xF1\x02"));
    CHECK(!RECEIVE(0x01, ""));
    CHECK(r.state == MIP_REQUEST_WAITING);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0\x0B\x82\x01\x02\0\0\x25\x80\0\x07\x01"));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && r.code == MIP_ACK_CODE_OK && client.waiting == NULL);
    CHECK(r.responded && response.baud == 9600 && response.mode == MIP_MODE_SLOW && response.limit == 7);

    /* The response is missing; then it is there, though the caller has no place for it. */
    fresh();
    add(&r, &mip_tools_settings_command, &read, 0);
    expect(&r, &mip_tools_settings_response_codec, &response);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0"));
    CHECK(r.state == MIP_REQUEST_MISSING_RESPONSE && !r.responded && r.error == MIP_OK);
    fresh();
    add(&r, &mip_tools_settings_command, &read, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0\x0B\x82\x01\x02\0\0\x25\x80\0\x07\x01"));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && !r.responded && client.waiting == NULL);

    /* A response that is too short is reported, and leaves zeros. */
    fresh();
    memset(&response, 0xAA, sizeof(response));
    add(&r, &mip_tools_settings_command, &read, 0);
    expect(&r, &mip_tools_settings_response_codec, &response);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0\x04\x82\x01\x02"));
    CHECK(r.state == MIP_REQUEST_UNDECODABLE && !r.responded && r.error == MIP_ERROR_TRUNCATED);
    CHECK(response.port == 0);
}

static void without_a_function(void) {
    struct mip_request r;
    struct mip_tools_settings none;
    memset(&none, 0, sizeof(none));
    const size_t before = fresh()->length;
    CHECK(mip_encode(&mip_tools_settings_codec, &none, &packet) == MIP_OK); /* a codec carries any value */
    fresh();
    CHECK(mip_client_add(&client, &r, &packet, &mip_tools_settings_command, &none, 0) == MIP_ERROR_MISSING);
    CHECK(r.state == MIP_REQUEST_CANCELLED && client.waiting == NULL && packet.error == MIP_ERROR_MISSING);
    CHECK(packet.length == before && is_packet(mip_builder_finish(&packet), "\x75\x65\x01\x00\xDB\x05", 6));
}

static void refused(void) {
    struct mip_request r;
    struct mip_tools_settings write;
    mip_tools_settings_write(&write, 9, MIP_MODE_FAST, 1);
    fresh();
    add(&r, &mip_tools_settings_command, &write, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\x03"));
    CHECK(r.state == MIP_REQUEST_REFUSED && r.code == MIP_ACK_CODE_INVALID_PARAMETER);
    fresh();
    add(&r, &mip_tools_settings_command, &write, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\x77")); /* a code that nobody knows */
    CHECK(r.state == MIP_REQUEST_REFUSED && r.code == 0x77);
}

static void timed_out(void) {
    struct mip_request r;
    const uint32_t start = UINT32_MAX - 100; /* the time wraps around meanwhile */
    fresh();
    add(&r, &mip_tools_ping_command, NULL, start);
    CHECK(expire(start) == 0);
    CHECK(expire(start + MIP_DEFAULT_TIMEOUT - 1) == 0);
    CHECK(expire(start + MIP_DEFAULT_TIMEOUT) == 1 && r.state == MIP_REQUEST_TIMED_OUT);
    CHECK(!RECEIVE(0x01, "\x04\xF1\x01\0") && r.state == MIP_REQUEST_TIMED_OUT); /* too late */

    /* A longer time-out, from the specification or from the caller. */
    struct mip_tools_status status;
    mip_tools_status_make(&status, 1);
    fresh();
    add(&r, &mip_tools_status_command, &status, 0);
    CHECK(expire(2499) == 0 && expire(2500) == 1);
    client.timeout = 5000;
    fresh();
    add(&r, &mip_tools_status_command, &status, 0);
    CHECK(expire(4999) == 0);
    mip_client_cancel(&client, &r);
    CHECK(r.state == MIP_REQUEST_CANCELLED && client.waiting == NULL);
    mip_client_cancel(&client, &r); /* once more does no harm */
    CHECK(expire(9999) == 0 && r.state == MIP_REQUEST_CANCELLED);

    /* The longest time-out. */
    client.timeout = UINT32_MAX;
    fresh();
    add(&r, &mip_tools_ping_command, NULL, 1000);
    CHECK(expire(1000) == 0 && expire(MIP_MAX_TIMEOUT) == 0 && expire(1000 + MIP_MAX_TIMEOUT) == 1);
    client.timeout = MIP_DEFAULT_TIMEOUT;
}

static void several(void) {
    struct mip_request r[4];
    struct mip_tools_bias_vector bias;
    struct mip_tools_bias read;
    mip_tools_bias_read(&read);
    struct mip_tools_settings first;
    mip_tools_settings_save(&first, 1);
    struct mip_tools_settings second;
    mip_tools_settings_save(&second, 2);
    fresh();
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    add(&r[1], &mip_tools_settings_command, &first, 0);
    add(&r[2], &mip_tools_bias_command, &read, 0);
    add(&r[3], &mip_tools_settings_command, &second, 10);
    expect(&r[2], &mip_tools_bias_vector_codec, &bias);
    CHECK(packet.length == MIP_HEADER_SIZE + 2 + 4 + 3 + 4);
    /* One packet answers some of them, each by its own acknowledge; a malformed field ends it. */
    CHECK(RECEIVE(0x01, "\x04\xF1\x01\0\x04\xF1\x02\x01\x04\xF1\x05\0\x0E\x9B\x3F\x80\0\0\0\0\0\0\xC0\0\0\0"));
    CHECK(r[0].state == MIP_REQUEST_ACKNOWLEDGED && r[1].state == MIP_REQUEST_REFUSED);
    CHECK(r[2].state == MIP_REQUEST_ACKNOWLEDGED && r[2].responded);
    const float x = bias.bias[0], z = bias.bias[2];
    CHECK(x > 0.99F && x < 1.01F && z < -1.99F && z > -2.01F);
    CHECK(r[3].state == MIP_REQUEST_WAITING && client.waiting == &r[3]);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0"));
    CHECK(r[3].state == MIP_REQUEST_ACKNOWLEDGED);

    /* The oldest of equal commands is answered first; each has a time-out of its own. */
    fresh();
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    add(&r[1], &mip_tools_ping_command, NULL, 100);
    add(&r[2], &mip_tools_ping_command, NULL, 200);
    CHECK(RECEIVE(0x01, "\x04\xF1\x01\0") && r[0].state == MIP_REQUEST_ACKNOWLEDGED);
    CHECK(expire(1100) == 1 && r[1].state == MIP_REQUEST_TIMED_OUT);
    CHECK(r[2].state == MIP_REQUEST_WAITING && expire(10000) == 1);

    /* A command that cannot be sent does not wait. */
    fresh();
    struct mip_builder small;
    uint8_t six[6];
    struct mip_request stuck = {.state = MIP_REQUEST_WAITING};
    CHECK(mip_builder_start(&small, six, sizeof(six), MIP_TOOLS_SET) == MIP_OK);
    CHECK(mip_client_add(&client, &stuck, &small, &mip_tools_ping_command, NULL, 0) == MIP_ERROR_LENGTH);
    CHECK(stuck.state == MIP_REQUEST_CANCELLED && client.waiting == NULL);
    uint8_t wrong[MIP_MAX_PACKET];
    CHECK(mip_builder_start(&small, wrong, sizeof(wrong), 0x7F) == MIP_OK);
    CHECK(mip_client_add(&client, &stuck, &small, &mip_tools_ping_command, NULL, 0) == MIP_ERROR_SET);
    CHECK(stuck.state == MIP_REQUEST_CANCELLED && small.length == MIP_HEADER_SIZE);

    /* A request that still waits and is used again waits once. */
    fresh();
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    add(&r[1], &mip_tools_ping_command, NULL, 0);
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    CHECK(client.waiting == &r[1] && r[1].next == &r[0] && r[0].next == NULL);
    CHECK(expire(10000) == 2);

    /* A command that does not fit is rejected before anything changes. */
    fresh();
    packet.capacity = MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE + 3;
    CHECK(mip_client_add(&client, &r[0], &packet, &mip_tools_bias_command, &read, 0) == MIP_OK);
    CHECK(mip_client_add(&client, &r[1], &packet, &mip_tools_ping_command, NULL, 0) == MIP_ERROR_LENGTH);
    CHECK(client.waiting == &r[0] && r[0].next == NULL);
    mip_client_cancel(&client, &r[0]);
}

static void silent(void) {
    struct mip_request r;
    struct mip_tools_set_time apply;
    mip_tools_set_time_apply(&apply, MIP_MODE_FAST, 5);
    fresh();
    add(&r, &mip_tools_set_time_command, &apply, 0);
    CHECK(r.state == MIP_REQUEST_SILENT && client.waiting == NULL);
    struct mip_tools_set_time write;
    mip_tools_set_time_write(&write, MIP_MODE_FAST, 5);
    add(&r, &mip_tools_set_time_command, &write, 0);
    CHECK(r.state == MIP_REQUEST_WAITING && RECEIVE(0x01, "\x04\xF1\x03\0"));
    struct mip_tools_formats quiet;
    mip_tools_formats_make(&quiet, true, 0, 0, NULL);
    add(&r, &mip_tools_formats_command, &quiet, 0);
    CHECK(r.state == MIP_REQUEST_SILENT && client.waiting == NULL);
    quiet.suppress_ack = false;
    add(&r, &mip_tools_formats_command, &quiet, 0);
    CHECK(r.state == MIP_REQUEST_WAITING && RECEIVE(0x01, "\x04\xF1\x07\0"));
}

static void responses(void) {
    struct mip_request r;
    struct mip_tools_settings_response settings;
    struct mip_tools_set_time_fast_response fast;
    struct mip_tools_set_time_slow_response slow;
    struct mip_tools_status_short brief;

    /* Only the response that the values select can have a place. */
    struct mip_tools_set_time read;
    mip_tools_set_time_read(&read, MIP_MODE_SLOW);
    fresh();
    add(&r, &mip_tools_set_time_command, &read, 0);
    CHECK(!mip_client_expect(&r, &mip_tools_set_time_fast_response_codec, &fast) && r.response == NULL);
    CHECK(!mip_client_expect(&r, &mip_tools_settings_response_codec, &settings) && r.response == NULL);
    CHECK(!mip_client_expect(&r, NULL, &settings) && r.response == NULL);
    expect(&r, &mip_tools_set_time_slow_response_codec, &slow);
    memset(&slow, 0xAA, sizeof(slow));
    /* A response of another descriptor is not taken, though it has the same layout. */
    CHECK(!RECEIVE(0x01, "\x04\xF1\x03\0\x06\x83\0\0\0\x07"));
    CHECK(r.state == MIP_REQUEST_WAITING && slow.value == 0xAAAAAAAA);
    CHECK(RECEIVE(0x01, "\x04\xF1\x03\0\x06\x84\0\0\0\x07"));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && r.responded && slow.value == 7);
    /* Nor is a foreign field, or anything behind it. */
    fresh();
    add(&r, &mip_tools_set_time_command, &read, 0);
    expect(&r, &mip_tools_set_time_slow_response_codec, &slow);
    memset(&slow, 0xAA, sizeof(slow));
    CHECK(RECEIVE(0x01, "\x04\xF1\x03\0\x06\xEE\0\0\0\x07\x06\x84\0\0\0\x07"));
    CHECK(r.state == MIP_REQUEST_MISSING_RESPONSE && !r.responded && slow.value == 0xAAAAAAAA);
    /* Commands that ask for no response. */
    struct mip_tools_set_time write;
    mip_tools_set_time_write(&write, MIP_MODE_SLOW, 1);
    fresh();
    add(&r, &mip_tools_set_time_command, &write, 0);
    CHECK(!mip_client_expect(&r, &mip_tools_set_time_slow_response_codec, &slow));
    CHECK(!RECEIVE(0x01, "\x04\xF1\x03\0\x06\x84\0\0\0\x07")); /* the late answer to a read */
    CHECK(RECEIVE(0x01, "\x04\xF1\x03\0\x06\xEE\0\0\0\x07") && r.state == MIP_REQUEST_ACKNOWLEDGED);

    /* Two layouts of one descriptor. */
    struct mip_tools_status ask;
    mip_tools_status_make(&ask, 1);
    fresh();
    add(&r, &mip_tools_status_command, &ask, 0);
    expect(&r, &mip_tools_status_short_codec, &brief);
    CHECK(!RECEIVE(0x01, "\x04\xF1\x04\0\x09\x90\x12\x67\x02\0\0\0\x05"));
    CHECK(r.state == MIP_REQUEST_WAITING && r.error == MIP_OK);
    CHECK(RECEIVE(0x01, "\x04\xF1\x04\0\x09\x90\x12\x67\x01\0\0\0\x05") && r.responded && brief.flags == 5);
}

/* A response that devices send in layouts of different sizes. */
static void sizes(void) {
    static const char old[] = "\x04\xF1\x04\0\x09\x90\x12\x67\x02\0\0\0\x05";
    static const char current[] = "\x04\xF1\x04\0\x11\x90\x12\x67\x02\0\0\0\x07\0\0\0\0\0\0\0\x06";
    struct mip_request r;
    struct mip_tools_status_old value = {9};
    struct mip_tools_status_short brief;
    struct mip_tools_status ask;
    mip_tools_status_make(&ask, 2);

    /* The one that is expected. */
    fresh();
    add(&r, &mip_tools_status_command, &ask, 0);
    CHECK(r.asked->layout == &mip_tools_status_long_codec && r.codec == NULL);
    CHECK(!mip_client_expect(&r, &mip_tools_status_short_codec, &brief));
    expect(&r, &mip_tools_status_old_codec, &value);
    CHECK(RECEIVE(0x01, old) && r.state == MIP_REQUEST_ACKNOWLEDGED && r.responded && value.uptime == 5);

    /* Another one: this is reported, and leaves zeros. */
    fresh();
    add(&r, &mip_tools_status_command, &ask, 0);
    expect(&r, &mip_tools_status_old_codec, &value);
    CHECK(RECEIVE(0x01, current) && r.state == MIP_REQUEST_UNDECODABLE && r.error == MIP_ERROR_LAYOUT);
    CHECK(!r.responded && value.uptime == 0 && r.codec == &mip_tools_status_long_codec);

    /* One that is not expected: the request states which it is. */
    fresh();
    add(&r, &mip_tools_status_command, &ask, 0);
    CHECK(RECEIVE(0x01, old) && r.state == MIP_REQUEST_ACKNOWLEDGED && r.codec == &mip_tools_status_old_codec);
}

static void step_by_step(void) {
    /* Each answer, and each field that answers nothing, in order. */
    static uint8_t bytes[MIP_MAX_PACKET];
    struct mip_request r[2];
    struct mip_request *answered;
    struct mip_tools_bias_vector bias;
    struct mip_tools_bias read;
    mip_tools_bias_read(&read);
    struct mip_builder b;
    struct mip_field field;
    fresh();
    add(&r[0], &mip_tools_ping_command, NULL, 0);
    add(&r[1], &mip_tools_bias_command, &read, 0);
    expect(&r[1], &mip_tools_bias_vector_codec, &bias);
    CHECK(mip_builder_start(&b, bytes, sizeof(bytes), 0x01) == MIP_OK);
    CHECK(mip_builder_add(&b, 0xF1, "\x01\0", 2) == MIP_OK && mip_builder_add(&b, 0xEE, "\x07", 1) == MIP_OK);
    CHECK(mip_builder_add(&b, 0xF1, "\x05\0", 2) == MIP_OK && mip_builder_add(&b, 0x9B, bytes, 12) == MIP_OK);
    CHECK(mip_builder_add(&b, 0xF1, "\x05\0", 2) == MIP_OK);
    const struct mip_packet p = mip_builder_finish(&b);
    struct mip_walk walk = mip_walk_packet(&p);
    CHECK(mip_client_next(&client, &walk, &answered, &field) && answered == &r[0] && field.descriptor == 0xF1);
    CHECK(r[0].state == MIP_REQUEST_ACKNOWLEDGED && r[1].state == MIP_REQUEST_WAITING);
    CHECK(mip_client_next(&client, &walk, &answered, &field) && answered == NULL && field.descriptor == 0xEE);
    CHECK(mip_client_next(&client, &walk, &answered, &field) && answered == &r[1] && field.descriptor == 0x9B);
    CHECK(r[1].responded && field.size == 12);
    CHECK(mip_client_next(&client, &walk, &answered, &field) && answered == NULL && field.descriptor == 0xF1);
    CHECK(!mip_client_next(&client, &walk, &answered, &field) && answered == NULL && walk.error == MIP_OK);
}

static void noise(void) {
    /* An answer behind the beginning of a packet that never ends is found before the time-out. */
    static const uint8_t stream[] = "\x75\x65\x80\xFF\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A\x75\x65\x01\x00\xDB";
    static const uint8_t rest[] = "\x05";
    const uint8_t *data = stream;
    size_t size = sizeof(stream) - 1;
    struct mip_parser parser;
    struct mip_packet p;
    struct mip_request r;
    fresh();
    add(&r, &mip_tools_ping_command, NULL, 0);
    mip_parser_init(&parser);
    CHECK(!mip_parser_next(&parser, &data, &size, &p));
    CHECK(!mip_client_poll(&client, &parser, 999, &p) && r.state == MIP_REQUEST_WAITING && parser.skipped == 0);
    CHECK(mip_client_poll(&client, &parser, 1000, &p) && mip_client_receive(&client, &p));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && parser.skipped == 4);
    /* Nothing is late any more: the incomplete packet behind it stays. */
    CHECK(!mip_client_poll(&client, &parser, 1000, &p) && parser.skipped == 4);
    data = rest;
    size = sizeof(rest) - 1;
    CHECK(mip_parser_next(&parser, &data, &size, &p) && p.size == 6 && parser.skipped == 4);
    /* A complete packet behind it comes next. */
    static const uint8_t two[] = "\x75\x65\x80\xFF\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A\x75\x65\x01\x00\xDB\x05";
    data = two;
    size = sizeof(two) - 1;
    fresh();
    add(&r, &mip_tools_ping_command, NULL, 0);
    CHECK(!mip_parser_next(&parser, &data, &size, &p));
    CHECK(mip_client_poll(&client, &parser, 1000, &p) && mip_client_receive(&client, &p));
    CHECK(mip_parser_next(&parser, &data, &size, &p) && p.size == 6 && !mip_client_receive(&client, &p));
    CHECK(!mip_client_poll(&client, &parser, 1000, &p) && r.state == MIP_REQUEST_ACKNOWLEDGED);
}

static void lost(void) {
    /* Of two requests of one command, each gets the answer that fits it. */
    struct mip_request r[2];
    struct mip_tools_bias_vector bias;
    struct mip_tools_bias read;
    mip_tools_bias_read(&read);
    struct mip_tools_bias save;
    mip_tools_bias_save(&save);
    fresh();
    add(&r[0], &mip_tools_bias_command, &save, 0);
    add(&r[1], &mip_tools_bias_command, &read, 0);
    expect(&r[1], &mip_tools_bias_vector_codec, &bias);
    CHECK(RECEIVE(0x01, "\x04\xF1\x05\0\x0E\x9B\0\0\0\0\0\0\0\0\0\0\0\0") && r[1].responded);
    CHECK(r[0].state == MIP_REQUEST_WAITING && expire(5000) == 1 && r[0].state == MIP_REQUEST_TIMED_OUT);
    fresh();
    add(&r[0], &mip_tools_bias_command, &read, 0);
    add(&r[1], &mip_tools_bias_command, &save, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x05\0") && r[1].state == MIP_REQUEST_ACKNOWLEDGED);
    CHECK(RECEIVE(0x01, "\x04\xF1\x05\0") && r[0].state == MIP_REQUEST_MISSING_RESPONSE);
}

int main(void) {
    mip_client_init(&client);
    acknowledged();
    without_a_function();
    refused();
    timed_out();
    several();
    silent();
    responses();
    sizes();
    step_by_step();
    noise();
    lost();
    return 0;
}
