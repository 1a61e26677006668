/* Reads base rates while data streams; reopens the port each time it is pulled, a given number of times. */
#include "mip/3dm_commands.h"
#include "mip/connect.h"
#include "mip/line.h"
#include "mip/sensor.h"

#include <stdio.h>
#include <stdlib.h>

static unsigned fields;

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    (void)user;
    (void)field;
    (void)arrived;
    fields++;
}

static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
};

static const uint8_t sets[] = {0x80, 0x82, 0x91};

int main(int argc, char **argv) {
    const unsigned wanted = argc == 3 ? (unsigned)atoi(argv[2]) : 0;
    unsigned reopened = 0, answered = 0, lost = 0, wrong = 0, other = 0, number = 0, before = 0;
    struct mip_rate rates[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 100, 0}};
    struct mip_base_get_device_info_response info;
    struct mip_3dm_get_base_rate_response rate;
    struct mip_line line;
    struct mip_device device;
    if (!mip_line_open(&line, argv[1], 115200)) {
        return fprintf(stderr, "%s\n", line.error);
    }
    mip_device_init(&device, &line.port, MIP_ARRAY(handlers));
    if (!mip_succeeded(mip_device_connect(&device, NULL, &info)) ||
        !mip_succeeded(mip_device_stream(&device, MIP_SENSOR_SET, MIP_ARRAY(rates)))) {
        return fprintf(stderr, "it does not start\n");
    }
    while (reopened < wanted) {
        const uint8_t set = sets[number++ % sizeof(sets)];
        struct mip_result result = mip_call_3dm_get_base_rate(&device, set, &rate);
        answered += result.outcome == MIP_ACKNOWLEDGED;
        wrong += result.outcome == MIP_ACKNOWLEDGED && rate.descriptor_set != set;
        if (result.outcome == MIP_CLOSED || result.outcome == MIP_NOT_SENT) {
            lost += result.outcome == MIP_CLOSED;
        } else {
            other += result.outcome != MIP_ACKNOWLEDGED;
        }
        if (result.outcome != MIP_ACKNOWLEDGED && !mip_device_poll(&device)) {
            if (!mip_line_reopen(&line, 10000)) {
                return fprintf(stderr, "%s\n", line.error);
            }
            reopened++;
            before += fields > 0;
            fields = 0;
        }
    }
    printf("{\"reopened\": %u, \"streamed\": %u, \"answered\": %u, \"lost\": %u, \"wrong\": %u, \"other\": %u}\n",
           reopened, before, answered, lost, wrong, other);
    mip_line_close(&line);
    return 0;
}
