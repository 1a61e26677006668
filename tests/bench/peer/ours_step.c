/* The same application without waiting: ping, idle, message format, stream, resume; then three fields by handlers. */
#include "app.h"

size_t receive(uint8_t *bytes, size_t size);

int main(void) {
    static const struct mip_port port = {NULL, port_write, port_now, NULL};
    static struct mip_request request;
    unsigned step = 0;
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    request.result.outcome = MIP_ACKNOWLEDGED;
    for (;;) {
        uint8_t bytes[64];
        mip_device_step(&device, bytes, receive(bytes, sizeof(bytes)));
        if (step < 5 && request.result.outcome != MIP_WAITING) {
            struct mip_device *const to = mip_defer(&device, &request);
            switch (step++) {
            case 0:
                (void)mip_call_base_ping(to);
                break;
            case 1:
                (void)mip_call_base_set_idle(to);
                break;
            case 2:
                (void)mip_call_3dm_message_format_write(to, MIP_SENSOR_SET, MIP_ARRAY(fields));
                break;
            case 3:
                (void)mip_call_3dm_data_stream_control_write(to, MIP_SENSOR_SET, true);
                break;
            default:
                (void)mip_call_base_resume(to);
            }
        }
    }
}
