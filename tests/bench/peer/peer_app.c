/* The same as ours_app.c with the vendor's SDK. */
#include "mip/definitions/commands_3dm.h"
#include "mip/definitions/commands_base.h"
#include "mip/definitions/data_sensor.h"
#include "mip/mip_interface.h"

bool port_receive(struct mip_interface *device, uint8_t *bytes, size_t size, mip_timeout timeout, bool from_command,
                  size_t *count, mip_timestamp *time);
bool port_send(struct mip_interface *device, const uint8_t *bytes, size_t size);

mip_interface device;
mip_dispatch_handler handlers[3];
mip_sensor_scaled_accel_data accel;
mip_sensor_scaled_gyro_data gyro;
mip_sensor_gps_timestamp_data stamp;

int main(void) {
    static const mip_descriptor_rate fields[] = {{0x04, 10}, {0x05, 10}, {0x12, 10}};
    mip_interface_init(&device, 100, 1000, port_send, port_receive, mip_interface_default_update, NULL);
    mip_interface_register_extractor(&device, &handlers[0], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_ACCEL_SCALED,
                                     extract_mip_sensor_scaled_accel_data_from_field, &accel);
    mip_interface_register_extractor(&device, &handlers[1], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_GYRO_SCALED,
                                     extract_mip_sensor_scaled_gyro_data_from_field, &gyro);
    mip_interface_register_extractor(&device, &handlers[2], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_TIME_STAMP_GPS,
                                     extract_mip_sensor_gps_timestamp_data_from_field, &stamp);
    while (mip_base_ping(&device) != MIP_ACK_OK) {
    }
    mip_base_set_idle(&device);
    mip_3dm_write_message_format(&device, MIP_SENSOR_DATA_DESC_SET, 3, fields);
    mip_3dm_write_datastream_control(&device, MIP_SENSOR_DATA_DESC_SET, true);
    mip_base_resume(&device);
    for (;;) {
        mip_interface_update(&device, 0, false);
    }
}
