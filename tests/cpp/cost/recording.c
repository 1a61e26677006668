/* Sums three fields of a recording, as the README of C shows; recording.cpp is compared with it. */
#include "mip/filter_data.h"
#include "mip/sensor.h"

#include <stdio.h>

static double sum;

static void handle(const struct mip_packet *packet) {
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_field field;
    while (mip_walk_next(&walk, &field)) {
        struct mip_sensor_scaled_accel accel;
        struct mip_filter_data_ned_velocity velocity;
        struct mip_filter_data_status status;
        switch (mip_field_key(&field)) {
        case MIP_SENSOR_SCALED_ACCEL:
            if (mip_sensor_scaled_accel_decode(&accel, &field) == MIP_OK) {
                sum += (double)accel.scaled_accel[0];
            }
            break;
        case MIP_FILTER_DATA_NED_VELOCITY:
            if (mip_filter_data_ned_velocity_decode(&velocity, &field) == MIP_OK) {
                sum += (double)velocity.north;
            }
            break;
        case MIP_FILTER_DATA_STATUS:
            if (mip_filter_data_status_decode(&status, &field) == MIP_OK) {
                sum += status.filter_state;
            }
            break;
        default:
            break;
        }
    }
}

int main(int argc, char **argv) {
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    uint8_t bytes[4096];
    struct mip_parser parser;
    struct mip_packet packet;
    size_t size;
    if (file == NULL) {
        return 2;
    }
    mip_parser_init(&parser);
    while ((size = fread(bytes, 1, sizeof(bytes), file)) > 0) {
        const uint8_t *at = bytes;
        while (mip_parser_next(&parser, &at, &size, &packet)) {
            handle(&packet);
        }
    }
    while (mip_parser_flush(&parser, &packet)) {
        handle(&packet);
    }
    printf("%a\n", sum);
    return 0;
}
