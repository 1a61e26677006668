/* Opens a device, streams a data field of the reference once per second, and reads it. */
#include "mip/connect.h"
#include "mip/line.h"
/* 1. the line of the page that begins with #include */
#include "mip/sensor.h"

#include <stdio.h>

/* 3. the descriptor set and the descriptor of the page */
enum { SET = 0x80, DESCRIPTOR = 0x04 };

static void on_field(void *user, const struct mip_field *received, uint32_t arrived) {
    const struct mip_field field = *received;
    (void)user;
    if (field.descriptor_set != SET || field.descriptor != DESCRIPTOR) {
        return;
    }
    printf("%10.3f s: %u bytes\n", arrived / 1e3, field.size);
    fflush(stdout);
    /* 2. the other lines of the page */
    struct mip_sensor_scaled_accel value;
    if (mip_sensor_scaled_accel_decode(&value, &field) == MIP_OK) {
        printf("%g %g %g\n", (double)value.scaled_accel[0], (double)value.scaled_accel[1],
               (double)value.scaled_accel[2]);
    }
    /* end of 2 */
}

static const struct mip_handler handlers[] = {{MIP_ANY_FIELD, MIP_ANY_SET, on_field, NULL}};

int main(int argc, char **argv) {
    struct mip_line line;
    struct mip_device device;
    struct mip_base_get_device_info_response info;
    struct mip_rate rates[] = {{DESCRIPTOR, 1, 0}}; /* 1 Hz */
    const char *name = argc == 2 ? argv[1] : "/dev/ttyACM0"; /* or COM3, or HOST:PORT */

    if (!mip_line_open(&line, name, 115200)) {
        fprintf(stderr, "%s: %s\n", name, line.error);
        return 1;
    }
    mip_device_init(&device, &line.port, MIP_ARRAY(handlers));
    struct mip_result result = mip_device_connect(&device, mip_line_set_baud, &info);
    if (mip_succeeded(result)) {
        result = mip_device_stream(&device, SET, MIP_ARRAY(rates));
    }
    if (!mip_succeeded(result)) {
        fprintf(stderr, "%s %s\n", mip_outcome_name(result.outcome), mip_result_reason(result));
        return 1;
    }
    while (mip_device_poll(&device)) { /* until the port is lost */
    }
    mip_line_close(&line);
    return 0;
}
