/* A typical application: ping, idle, message format, stream, resume; then three fields by handlers. With STEP, it never
   waits for a reply. */
#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/sensor.h"

bool port_write(void *user, const uint8_t *bytes, size_t size);
uint32_t port_now(void *user);

struct mip_device device;
struct mip_sensor_scaled_accel accel;
struct mip_sensor_scaled_gyro gyro;
struct mip_sensor_gps_timestamp stamp;

static void on_accel(void *user, const struct mip_field *field, uint32_t time) {
    (void)user, (void)time;
    (void)(mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK);
}

static void on_gyro(void *user, const struct mip_field *field, uint32_t time) {
    (void)user, (void)time;
    (void)(mip_sensor_scaled_gyro_decode(&gyro, field) == MIP_OK);
}

static void on_stamp(void *user, const struct mip_field *field, uint32_t time) {
    (void)user, (void)time;
    (void)(mip_sensor_gps_timestamp_decode(&stamp, field) == MIP_OK);
}

static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
    {&mip_sensor_scaled_gyro_codec, MIP_ANY_SET, on_gyro, NULL},
    {&mip_sensor_gps_timestamp_codec, MIP_ANY_SET, on_stamp, NULL},
};
static const struct mip_descriptor_rate fields[] = {{0x04, 10}, {0x05, 10}, {0x12, 10}};

#ifndef STEP
bool port_read(void *user, uint8_t *bytes, size_t size, size_t *count);

int main(void) {
    static const struct mip_port port = {port_read, port_write, port_now, NULL};
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    while (!mip_succeeded(mip_call_base_ping(&device))) {
    }
    (void)mip_succeeded(mip_call_base_set_idle(&device));
    (void)mip_succeeded(mip_call_3dm_message_format_write(&device, MIP_SENSOR_SET, MIP_ARRAY(fields)));
    (void)mip_succeeded(mip_call_3dm_data_stream_control_write(&device, MIP_SENSOR_SET, true));
    (void)mip_succeeded(mip_call_base_resume(&device));
    for (;;) {
        (void)mip_device_poll(&device);
    }
}

#else
size_t receive(uint8_t *bytes, size_t size);

int main(void) {
    static const struct mip_port port = {NULL, port_write, port_now, NULL};
    static struct mip_request request;
    static unsigned step;
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    request.result.outcome = MIP_ACKNOWLEDGED;
    for (;;) {
        uint8_t bytes[64];
        mip_device_step(&device, bytes, receive(bytes, sizeof(bytes)));
        if (step < 5 && request.result.outcome != MIP_WAITING) {
            struct mip_device *const to = mip_defer(&device, &request);
            switch (step++) {
            case 0:
                (void)mip_call_base_ping(to);
                break;
            case 1:
                (void)mip_call_base_set_idle(to);
                break;
            case 2:
                (void)mip_call_3dm_message_format_write(to, MIP_SENSOR_SET, MIP_ARRAY(fields));
                break;
            case 3:
                (void)mip_call_3dm_data_stream_control_write(to, MIP_SENSOR_SET, true);
                break;
            default:
                (void)mip_call_base_resume(to);
            }
        }
    }
}
#endif
