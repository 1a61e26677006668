/* Finds a device at a serial port or a TCP connection, and prints accelerations at 100 Hz. */
#include "mip/connect.h"
#include "mip/line.h"
#include "mip/sensor.h"

#include <stdio.h>
#include <string.h>

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_sensor_scaled_accel accel;
    const float *a = accel.scaled_accel;
    (void)user;
    if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
        printf("%10.3f s: %8.4f %8.4f %8.4f g\n", arrived / 1e3, (double)a[0], (double)a[1],
               (double)a[2]);
    }
}

static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
};

static int failed(const char *what, const struct mip_device *device, struct mip_result result) {
    fprintf(stderr, "%s: %s %s (0x%02X,0x%02X)\n", what, mip_outcome_name(result.outcome),
            mip_result_reason(result), device->sent->descriptor_set, device->sent->descriptor);
    return 1;
}

int main(int argc, char **argv) {
    struct mip_line line;
    struct mip_device device;
    struct mip_base_get_device_info_response info;
    struct mip_rate rates[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 100, 0}};
    const char *name = argc == 2 ? argv[1] : "/dev/ttyACM0"; /* or COM3, or HOST:PORT */

    if (!mip_line_open(&line, name, 115200)) {
        fprintf(stderr, "%s: %s\n", name, line.error);
        return 1;
    }
    mip_device_init(&device, &line.port, MIP_ARRAY(handlers));
    struct mip_result result = mip_device_connect(&device, mip_line_set_baud, &info);
    if (!mip_succeeded(result)) {
        return failed("connect", &device, result);
    }
    const char *model = info.device_info.model_name; /* padded with spaces */
    puts(model + strspn(model, " "));
    result = mip_device_stream(&device, MIP_SENSOR_SET, MIP_ARRAY(rates));
    if (!mip_succeeded(result)) { /* rates[0].nearest is the nearest supported rate */
        return failed("stream", &device, result);
    }
    while (mip_device_poll(&device)) { /* until the port is lost */
    }
    mip_line_close(&line);
    return 0;
}
