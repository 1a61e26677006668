/* What both applications use: a message format, and handlers for its three fields. */
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
