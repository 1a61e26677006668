/* Parser and three fields. */
#include "mip/sensor.h"

extern uint8_t rx[64];
extern size_t rx_size;

struct mip_parser parser;
struct mip_sensor_scaled_accel accel;
struct mip_sensor_scaled_gyro gyro;
struct mip_sensor_gps_timestamp stamp;

static void take(const struct mip_field *field) {
    switch (mip_field_key(field)) {
    case MIP_SENSOR_SCALED_ACCEL:
        (void)(mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK);
        break;
    case MIP_SENSOR_SCALED_GYRO:
        (void)(mip_sensor_scaled_gyro_decode(&gyro, field) == MIP_OK);
        break;
    case MIP_SENSOR_GPS_TIMESTAMP:
        (void)(mip_sensor_gps_timestamp_decode(&stamp, field) == MIP_OK);
        break;
    }
}

int main(void) {
    mip_parser_init(&parser);
    for (;;) {
        const uint8_t *data = rx;
        size_t size = rx_size;
        struct mip_packet packet;
        while (mip_parser_next(&parser, &data, &size, &packet)) {
            struct mip_walk walk = mip_walk_packet(&packet);
            struct mip_field field;
            while (mip_walk_next(&walk, &field)) {
                take(&field);
            }
        }
    }
}
