/* What is compiled only with MIP_HOOKS and MIP_DIAGNOSTICS: the bytes seen, the lock, the counts. */
#include "check.h"

#include "mip/tools_commands.h"

static struct mip_device device;
static const uint8_t *arriving;
static size_t left, received, sent;
static int depth, deepest;
static bool lost;
/* The requests that wait, at the last change of the lock. */
static const struct mip_request *waiting;
static uint32_t clock_time;

static bool take(void *user, uint8_t *bytes, size_t size, size_t *count) {
    (void)user;
    CHECK(depth == 0); /* reading may take long */
    *count = left < size ? left : size;
    memcpy(bytes, arriving, *count);
    arriving += *count;
    left -= *count;
    clock_time += 100;
    return !lost;
}

static bool put(void *user, const uint8_t *bytes, size_t size) {
    (void)user, (void)bytes, (void)size;
    CHECK(depth > 0);
    return true;
}

static uint32_t now(void *user) {
    (void)user;
    return clock_time;
}

static void lock(void *user, bool locks) {
    (void)user;
    CHECK(depth > 0 || device.client.waiting == waiting); /* nothing changes without the lock */
    waiting = device.client.waiting;
    depth += locks ? 1 : -1;
    deepest = depth > deepest ? depth : deepest;
    CHECK(depth >= 0);
}

static void bytes(void *user, const uint8_t *some, size_t size, bool is_sent) {
    (void)user;
    CHECK(some != NULL && size > 0 && depth > 0);
    *(is_sent ? &sent : &received) += size;
}

int main(void) {
    static const struct mip_port port = {take, put, now, NULL};
    static const struct mip_hooks hooks = {lock, bytes, NULL};
    static const struct mip_hooks none = {NULL, NULL, NULL};
    /* Noise, an acknowledge with a wrong checksum, one with the right one, an empty packet. */
    static const uint8_t stream[] = "n\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6B"
                                    "\x75\x65\x01\x04\x04\xF1\x01\x00\xD5\x6A\x75\x65\x80\x00\x5A\x03";
    const size_t length = sizeof(stream) - 1;
    mip_device_init(&device, &port, 0, NULL);
    device.hooks = &hooks;
    for (size_t pieces = 1; pieces <= 2; pieces++) { /* whole, and byte by byte */
        const uint32_t before = device.parser.bad_checksums;
        arriving = stream;
        left = length;
        if (pieces == 1) {
            CHECK(mip_call_tools_ping(&device).outcome == MIP_ACKNOWLEDGED);
        } else {
            for (size_t i = 0; i < length; i++) {
                mip_device_step(&device, stream + i, 1);
            }
        }
        CHECK(device.parser.bad_checksums == before + 1 && device.parser.skipped == 11 * pieces);
        CHECK(device.sets[0].descriptor_set == 0x01 && device.sets[0].packets == pieces && device.sets[0].bytes == 10 * pieces);
        CHECK(device.sets[1].descriptor_set == 0x80 && device.sets[1].packets == pieces && device.sets[1].bytes == 6 * pieces);
        CHECK(device.sets[2].descriptor_set == 0 && received == length * pieces && sent == 8);
    }
    device.hooks = &none; /* without functions */
    mip_device_step(&device, NULL, 0);
    device.hooks = &hooks;
    left = 0;
    deepest = 0;
    CHECK(mip_call_tools_ping(&device).outcome == MIP_TIMED_OUT && device.client.timeouts == 1);
    CHECK(depth == 0 && deepest == 1);
    /* mip_defer locks until the command has been sent, so that no other thread sends one in between. */
    struct mip_request request = {0};
    struct mip_device *const to = mip_defer(&device, &request);
    CHECK(depth == 1);
    (void)mip_call_tools_ping(to);
    CHECK(depth == 0 && deepest == 2 && mip_request_result(&device, &request).outcome == MIP_WAITING);
    CHECK(depth == 0 && device.deferred == NULL);
    deepest = 0;
    mip_device_cancel(&device, &request);
    CHECK(depth == 0 && request.result.outcome == MIP_CLOSED && device.client.waiting == NULL);
    lost = true;
    CHECK(mip_call_tools_ping(&device).outcome == MIP_CLOSED && depth == 0);
    lost = false;
    /* A set more than there is room for is not counted, and nothing is overwritten. */
    for (unsigned set = 0x81; set < 0x90; set++) {
        uint8_t packet[8];
        const size_t size = mip_packet_seal(packet, (uint8_t)set, 0);
        mip_device_step(&device, packet, size);
    }
    CHECK(device.sets[MIP_COUNTED_SETS - 1].packets == 1 && device.client.timeouts == 1);
    return 0;
}
