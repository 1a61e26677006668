/* What the examples for boards do with their port: find the device, and stream accelerations at 100
 * Hz. */
#include "mip/connect.h"
#include "mip/sensor.h"

/* The application's handler for an acceleration, in g. */
void application_take(const float accel[3]);

static void on_accel(void *user, const struct mip_field *field, uint32_t time) {
    struct mip_sensor_scaled_accel accel;
    (void)user, (void)time;
    if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
        application_take(accel.scaled_accel);
    }
}

/* `set_baud` may be NULL; `rest` waits for a moment, or does nothing. */
void application_run(const struct mip_port *port, bool (*set_baud)(void *user, uint32_t baud),
                     void (*rest)(void));
void application_run(const struct mip_port *port, bool (*set_baud)(void *user, uint32_t baud),
                     void (*rest)(void)) {
    static const struct mip_handler handlers[] = {
        {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL}};
    static struct mip_device device;
    struct mip_base_get_device_info_response info;
    struct mip_rate rates[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 100, 0}};
    mip_device_init(&device, port, MIP_ARRAY(handlers));
    while (!mip_succeeded(mip_device_connect(&device, set_baud, &info)) ||
           !mip_succeeded(mip_device_stream(&device, MIP_SENSOR_SET, MIP_ARRAY(rates)))) {
        rest(); /* the device is still starting, or nothing is connected */
    }
    for (;;) {
        (void)mip_device_poll(&device);
    }
}
