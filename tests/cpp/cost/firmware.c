/* A typical application of a microcontroller: three fields, and a few commands. */
#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/filter_data.h"
#include "mip/sensor.h"

extern const struct mip_port uart;
void use(float value);
void start(void);

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_sensor_scaled_accel accel;
    (void)user;
    (void)arrived;
    if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
        use(accel.scaled_accel[0]);
    }
}

static void on_gyro(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_sensor_scaled_gyro gyro;
    (void)user;
    (void)arrived;
    if (mip_sensor_scaled_gyro_decode(&gyro, field) == MIP_OK) {
        use(gyro.scaled_gyro[0]);
    }
}

static void on_velocity(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_filter_data_ned_velocity velocity;
    (void)user;
    (void)arrived;
    if (mip_filter_data_ned_velocity_decode(&velocity, field) == MIP_OK) {
        use(velocity.north);
    }
}

static struct mip_device device;
static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
    {&mip_sensor_scaled_gyro_codec, MIP_ANY_SET, on_gyro, NULL},
    {&mip_filter_data_ned_velocity_codec, MIP_ANY_SET, on_velocity, NULL},
};

void start(void) {
    const struct mip_descriptor_rate fields[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 10}, {MIP_SENSOR_SCALED_GYRO_DESCRIPTOR, 10}};
    mip_device_init(&device, &uart, MIP_ARRAY(handlers));
    if (mip_succeeded(mip_call_base_ping(&device)) &&
        mip_succeeded(mip_call_3dm_message_format_write(&device, MIP_SENSOR_SET, MIP_ARRAY(fields))) &&
        mip_succeeded(mip_call_3dm_data_stream_control_write(&device, MIP_SENSOR_SET, true))) {
        while (mip_device_poll(&device)) {
        }
    }
}
