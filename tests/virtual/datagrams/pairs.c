/* Reads the base rates of seven sets in turn, and counts the replies that are those of another command. */
#include "udp.h"

static bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count) {
    *count = udp_read(*(int *)user, bytes, size);
    return true;
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    return udp_write(*(int *)user, bytes, size);
}

static uint32_t port_now(void *user) {
    (void)user;
    return udp_now();
}

static bool port_waits(void *user) {
    return udp_wait(*(int *)user, 0);
}

static void keep(void *user, const struct mip_field *field, uint32_t arrived) {
    (void)field;
    (void)arrived;
    ++*(unsigned *)user;
}

int main(int argc, char **argv) {
    static const uint8_t sets[] = {0x80, 0x82, 0x91, 0x92, 0x93, 0x94, 0xA0};
    struct count count = {0, 0, 0, 0, 0, 0};
    int udp = udp_open(argv[argc - 2]);
    const struct mip_port port = {port_read, port_write, port_now, &udp};
    const struct mip_handler handlers[] = {{MIP_ANY_FIELD, MIP_ANY_SET, keep, &count.kept}};
    struct mip_3dm_get_base_rate_response rate;
    struct mip_device device;
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    device.waits = port_waits;
    device.client.timeout = 10000;
    for (int i = 0; i < atoi(argv[argc - 1]); i++) {
        const struct mip_result result = mip_call_3dm_get_base_rate(&device, sets[i % 7], &rate);
        const bool acknowledged = result.outcome == MIP_ACKNOWLEDGED;
        count_pair(&count, acknowledged, acknowledged && rate.descriptor_set == sets[i % 7]);
    }
    for (const uint32_t end = udp_now() + 300; (int32_t)(end - udp_now()) > 0;) {
        mip_device_poll(&device);
    }
    return print_count(&count);
}
