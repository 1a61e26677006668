/* A typical application: ping, idle, message format, stream, resume; then three fields by handlers. */
#include "app.h"

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
