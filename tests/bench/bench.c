/* Parses a file that holds a stream, decodes two fields of each packet, and prints nanoseconds for
 * each. */
#include "mip/sensor.h"
#include "mip/shared.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double run(const uint8_t *data, size_t size, bool decode, double *sum) {
    struct timespec begin, end;
    struct mip_parser parser;
    struct mip_packet packet;
    size_t packets = 0;
    mip_parser_init(&parser);
    clock_gettime(CLOCK_MONOTONIC, &begin);
    while (mip_parser_next(&parser, &data, &size, &packet)) {
        struct mip_walk walk = mip_walk_packet(&packet);
        struct mip_field field;
        packets++;
        while (decode && mip_walk_next(&walk, &field)) {
            struct mip_sensor_scaled_accel accel;
            struct mip_sensor_scaled_gyro gyro;
            if (field.descriptor == MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR &&
                mip_sensor_scaled_accel_decode(&accel, &field) == MIP_OK) {
                *sum += (double)accel.scaled_accel[0];
            } else if (field.descriptor == MIP_SENSOR_SCALED_GYRO_DESCRIPTOR &&
                       mip_sensor_scaled_gyro_decode(&gyro, &field) == MIP_OK) {
                *sum += (double)gyro.scaled_gyro[0];
            }
        }
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    return ((double)(end.tv_sec - begin.tv_sec) * 1e9 + (double)(end.tv_nsec - begin.tv_nsec)) /
           (double)packets;
}

int main(int count, char **arguments) {
    FILE *file = count > 1 ? fopen(arguments[1], "rb") : NULL;
    if (file == NULL) {
        return 2;
    }
    fseek(file, 0, SEEK_END);
    size_t size = (size_t)ftell(file);
    rewind(file);
    uint8_t *data = malloc(size);
    double sum = 0;
    if (data == NULL || fread(data, 1, size, file) != size) {
        return 2;
    }
    printf("%.1f ", run(data, size, false, &sum));
    printf("%.1f\n", run(data, size, true, &sum));
    fclose(file);
    free(data);
    return sum > 0 ? 0 : 1;
}
