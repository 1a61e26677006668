/* The command client: every outcome, in the packets of a device that answers as one likes. */
#include "check.h"

#include "mip/client.h"
#include "mip/measurements.h"
#include "mip/tools.h"

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

static void add(struct mip_request *request, const struct mip_codec *codec, const void *command, uint32_t now) {
    CHECK(mip_client_add(&client, request, &packet, codec, command, now) == MIP_OK);
}

static void acknowledged(void) {
    struct mip_request r;
    struct mip_tools_settings_response response;
    struct mip_tools_settings read = mip_tools_settings_read(1, MIP_MODE_FAST);
    fresh();
    add(&r, &mip_tools_settings_codec, &read, 0);
    mip_client_expect(&r, &mip_tools_settings_response_codec, &response);
    CHECK(r.state == MIP_REQUEST_WAITING);
    CHECK(is_packet(mip_builder_finish(&packet), "\x75\x65\x01\x05\x05\x02\x02\x01\x01\xEB\x94", 11));

    /* Streams of data, other sets and answers to others disturb nothing. */
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

    /* Without a response, though one is expected; with one, though none is. */
    fresh();
    add(&r, &mip_tools_settings_codec, &read, 0);
    mip_client_expect(&r, &mip_tools_settings_response_codec, &response);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0"));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && !r.responded && r.error == MIP_OK);
    fresh();
    add(&r, &mip_tools_settings_codec, &read, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0\x0B\x82\x01\x02\0\0\x25\x80\0\x07\x01"));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && !r.responded);

    /* A response that is too short says so, and leaves zeros. */
    fresh();
    memset(&response, 0xAA, sizeof(response));
    add(&r, &mip_tools_settings_codec, &read, 0);
    mip_client_expect(&r, &mip_tools_settings_response_codec, &response);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\0\x04\x82\x01\x02"));
    CHECK(r.state == MIP_REQUEST_ACKNOWLEDGED && !r.responded && r.error == MIP_ERROR_TRUNCATED);
    CHECK(response.port == 0);
}

static void refused(void) {
    struct mip_request r;
    struct mip_tools_settings write = mip_tools_settings_write(9, MIP_MODE_FAST, 1);
    fresh();
    add(&r, &mip_tools_settings_codec, &write, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\x03"));
    CHECK(r.state == MIP_REQUEST_REFUSED && r.code == MIP_ACK_CODE_INVALID_PARAMETER);
    fresh();
    add(&r, &mip_tools_settings_codec, &write, 0);
    CHECK(RECEIVE(0x01, "\x04\xF1\x02\x77")); /* a code that nobody knows */
    CHECK(r.state == MIP_REQUEST_REFUSED && r.code == 0x77);
}

static void timed_out(void) {
    struct mip_request r;
    const uint32_t start = UINT32_MAX - 100; /* the time wraps around meanwhile */
    fresh();
    add(&r, &mip_tools_ping_codec, NULL, start);
    CHECK(mip_client_expire(&client, start) == 0);
    CHECK(mip_client_expire(&client, start + MIP_DEFAULT_TIMEOUT - 1) == 0);
    CHECK(mip_client_expire(&client, start + MIP_DEFAULT_TIMEOUT) == 1 && r.state == MIP_REQUEST_TIMED_OUT);
    CHECK(!RECEIVE(0x01, "\x04\xF1\x01\0") && r.state == MIP_REQUEST_TIMED_OUT); /* too late */

    /* A command that takes longer, by the specification or by the caller. */
    struct mip_tools_status status = mip_tools_status_make(1);
    fresh();
    add(&r, &mip_tools_status_codec, &status, 0);
    CHECK(mip_client_expire(&client, 2499) == 0 && mip_client_expire(&client, 2500) == 1);
    client.timeout = 5000;
    fresh();
    add(&r, &mip_tools_status_codec, &status, 0);
    CHECK(mip_client_expire(&client, 4999) == 0);
    mip_client_cancel(&client, &r);
    CHECK(r.state == MIP_REQUEST_CANCELLED && client.waiting == NULL);
    mip_client_cancel(&client, &r); /* once more does no harm */
    CHECK(mip_client_expire(&client, 9999) == 0 && r.state == MIP_REQUEST_CANCELLED);
    client.timeout = MIP_DEFAULT_TIMEOUT;
}

static void several(void) {
    struct mip_request r[4];
    struct mip_tools_bias_vector bias;
    struct mip_tools_bias read = mip_tools_bias_read();
    struct mip_tools_settings first = mip_tools_settings_save(1);
    struct mip_tools_settings second = mip_tools_settings_save(2);
    fresh();
    add(&r[0], &mip_tools_ping_codec, NULL, 0);
    add(&r[1], &mip_tools_settings_codec, &first, 0);
    add(&r[2], &mip_tools_bias_codec, &read, 0);
    add(&r[3], &mip_tools_settings_codec, &second, 10);
    mip_client_expect(&r[2], &mip_tools_bias_vector_codec, &bias);
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

    /* The oldest of equal commands is answered first; each runs out of time by itself. */
    fresh();
    add(&r[0], &mip_tools_ping_codec, NULL, 0);
    add(&r[1], &mip_tools_ping_codec, NULL, 100);
    add(&r[2], &mip_tools_ping_codec, NULL, 200);
    CHECK(RECEIVE(0x01, "\x04\xF1\x01\0") && r[0].state == MIP_REQUEST_ACKNOWLEDGED);
    CHECK(mip_client_expire(&client, 1100) == 1 && r[1].state == MIP_REQUEST_TIMED_OUT);
    CHECK(r[2].state == MIP_REQUEST_WAITING && mip_client_expire(&client, 10000) == 1);

    /* What cannot be sent is not waited for. */
    fresh();
    struct mip_builder small;
    uint8_t six[6];
    struct mip_request stuck = {.state = MIP_REQUEST_WAITING};
    CHECK(mip_builder_start(&small, six, sizeof(six), MIP_TOOLS_SET) == MIP_OK);
    CHECK(mip_client_add(&client, &stuck, &small, &mip_tools_ping_codec, NULL, 0) == MIP_ERROR_LENGTH);
    CHECK(stuck.state == MIP_REQUEST_CANCELLED && client.waiting == NULL);
    uint8_t wrong[MIP_MAX_PACKET];
    CHECK(mip_builder_start(&small, wrong, sizeof(wrong), 0x7F) == MIP_OK);
    CHECK(mip_client_add(&client, &stuck, &small, &mip_tools_ping_codec, NULL, 0) == MIP_ERROR_SET);
    CHECK(stuck.state == MIP_REQUEST_CANCELLED && small.length == MIP_HEADER_SIZE);

    /* A request that still waits and is used again waits once. */
    fresh();
    add(&r[0], &mip_tools_ping_codec, NULL, 0);
    add(&r[1], &mip_tools_ping_codec, NULL, 0);
    add(&r[0], &mip_tools_ping_codec, NULL, 0);
    CHECK(client.waiting == &r[1] && r[1].next == &r[0] && r[0].next == NULL);
    CHECK(mip_client_expire(&client, 10000) == 2);

    /* A command that does not fit is refused before anything changes. */
    fresh();
    packet.capacity = MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE + 3;
    CHECK(mip_client_add(&client, &r[0], &packet, &mip_tools_bias_codec, &read, 0) == MIP_OK);
    CHECK(mip_client_add(&client, &r[1], &packet, &mip_tools_ping_codec, NULL, 0) == MIP_ERROR_LENGTH);
    CHECK(client.waiting == &r[0] && r[0].next == NULL);
    mip_client_cancel(&client, &r[0]);
}

static void silent(void) {
    struct mip_request r;
    struct mip_tools_set_time apply = mip_tools_set_time_apply(MIP_MODE_FAST, 5);
    fresh();
    add(&r, &mip_tools_set_time_codec, &apply, 0);
    CHECK(r.state == MIP_REQUEST_SILENT && client.waiting == NULL);
    struct mip_tools_set_time write = mip_tools_set_time_write(MIP_MODE_FAST, 5);
    add(&r, &mip_tools_set_time_codec, &write, 0);
    CHECK(r.state == MIP_REQUEST_WAITING && RECEIVE(0x01, "\x04\xF1\x03\0"));
    struct mip_tools_formats quiet = mip_tools_formats_make(true, 0, 0, NULL);
    add(&r, &mip_tools_formats_codec, &quiet, 0);
    CHECK(r.state == MIP_REQUEST_SILENT && client.waiting == NULL);
    quiet.suppress_ack = false;
    add(&r, &mip_tools_formats_codec, &quiet, 0);
    CHECK(r.state == MIP_REQUEST_WAITING && RECEIVE(0x01, "\x04\xF1\x07\0"));
}

static void layouts(void) {
    /* The response of a command that has several: the caller knows which one it asked for. */
    struct mip_request r;
    struct mip_tools_status_short brief;
    struct mip_tools_status ask = mip_tools_status_make(1);
    fresh();
    add(&r, &mip_tools_status_codec, &ask, 0);
    mip_client_expect(&r, &mip_tools_status_short_codec, &brief);
    CHECK(RECEIVE(0x01, "\x04\xF1\x04\0\x09\x90\x12\x67\x01\0\0\0\x05") && r.responded && brief.flags == 5);
    add(&r, &mip_tools_status_codec, &ask, 0);
    mip_client_expect(&r, &mip_tools_status_short_codec, &brief);
    CHECK(RECEIVE(0x01, "\x04\xF1\x04\0\x09\x90\x12\x67\x02\0\0\0\x05"));
    CHECK(!r.responded && r.error == MIP_ERROR_CONSTANT);
}

int main(void) {
    mip_client_init(&client);
    acknowledged();
    refused();
    timed_out();
    several();
    silent();
    layouts();
    return 0;
}
