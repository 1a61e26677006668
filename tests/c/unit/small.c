/* A program that reads one value, and should link nothing more. */
#include "mip/measurements.h"

static struct mip_parser parser;

float newest(const uint8_t *data, size_t size);

float newest(const uint8_t *data, size_t size) {
    struct mip_packet packet;
    struct mip_field field;
    struct mip_measurements_accel accel = {{0, 0, 0}, 0};
    while (mip_parser_next(&parser, &data, &size, &packet)) {
        struct mip_walk walk = mip_walk_packet(&packet);
        while (mip_walk_next(&walk, &field)) {
            if (mip_field_key(&field) == MIP_MEASUREMENTS_ACCEL(MIP_MEASUREMENTS_SET)) {
                (void)mip_measurements_accel_decode(&accel, &field);
            }
        }
    }
    return accel.scaled_accel[2];
}

int main(void) {
    static const uint8_t bytes[] = {0x75, 0x65, 0x80, 0x00};
    mip_parser_init(&parser);
    return newest(bytes, sizeof(bytes)) > 0;
}
