/* The same as ours_fields.c with the vendor's SDK. */
#include "mip/definitions/data_sensor.h"
#include "mip/mip_field.h"
#include "mip/mip_parser.h"

extern uint8_t rx[64];
extern size_t rx_size;

mip_parser parser;
mip_sensor_scaled_accel_data accel;
mip_sensor_scaled_gyro_data gyro;
mip_sensor_gps_timestamp_data stamp;

static bool on_packet(void *user, const mip_packet_view *packet, mip_timestamp time) {
    (void)user, (void)time;
    if (mip_packet_descriptor_set(packet) != MIP_SENSOR_DATA_DESC_SET) {
        return true;
    }
    mip_field_view field;
    mip_field_init_empty(&field);
    while (mip_field_next_in_packet(&field, packet)) {
        switch (mip_field_field_descriptor(&field)) {
        case MIP_DATA_DESC_SENSOR_ACCEL_SCALED:
            extract_mip_sensor_scaled_accel_data_from_field(&field, &accel);
            break;
        case MIP_DATA_DESC_SENSOR_GYRO_SCALED:
            extract_mip_sensor_scaled_gyro_data_from_field(&field, &gyro);
            break;
        case MIP_DATA_DESC_SENSOR_TIME_STAMP_GPS:
            extract_mip_sensor_gps_timestamp_data_from_field(&field, &stamp);
            break;
        }
    }
    return true;
}

int main(void) {
    mip_parser_init(&parser, on_packet, NULL, 100);
    for (;;) {
        mip_parser_parse(&parser, rx, rx_size, 0);
    }
}
