/* Requests the name of a device, and prints accelerations from a stream of bytes. */
#include "mip/base.h"
#include "mip/sensor.h"

#include <stdio.h>

int main(void) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    mip_builder_start(&builder, buffer, sizeof(buffer), MIP_BASE_SET);
    if (mip_base_get_device_info_encode(NULL, &builder) != MIP_OK) {
        return 1;
    }
    struct mip_packet packet = mip_builder_finish(&builder); /* now send packet.bytes */
    printf("%zu bytes to send\n", packet.size);

    static const uint8_t stream[] = "$GPGGA noise\r\n\x75\x65\x80\x0E\x0E\x04\x3E\x7A\x63\xA0"
                                    "\xBB\x8E\x3B\x29\x7F\xE5\xBF\x7F\x84\xEE";
    const uint8_t *data = stream;
    size_t size = sizeof(stream) - 1;
    struct mip_parser parser;
    mip_parser_init(&parser);
    while (mip_parser_next(&parser, &data, &size, &packet)) {
        struct mip_walk walk = mip_walk_packet(&packet);
        struct mip_field field;
        while (mip_walk_next(&walk, &field)) {
            struct mip_sensor_scaled_accel accel;
            switch (mip_field_key(&field)) {
            case MIP_SENSOR_SCALED_ACCEL:
                if (mip_sensor_scaled_accel_decode(&accel, &field) == MIP_OK) {
                    printf("%.4f g along x\n", (double)accel.scaled_accel[0]);
                }
                break;
            default: /* others */
                break;
            }
        }
    }
    return 0;
}
