#include "mip/3dm_commands.h"
#include "mip/sensor.h"

static void on_accel(void *user, const struct mip_field *field, uint32_t arrived) {
    struct mip_sensor_scaled_accel accel;
    (void)user;
    if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
        show(accel.scaled_accel, arrived);
    }
}

static const struct mip_handler handlers[] = {
    {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_accel, NULL},
};

bool run(const struct mip_port *port) { /* with read, write and now */
    struct mip_device device;
    struct mip_3dm_pps_source_control_response pps;
    mip_device_init(&device, port, MIP_ARRAY(handlers));

    struct mip_result result = mip_call_3dm_pps_source_control_read(&device, &pps);
    if (mip_succeeded(result) && pps.source != MIP_3DM_PPS_SOURCE_GPIO) {
        result = mip_call_3dm_pps_source_control_write(&device, MIP_3DM_PPS_SOURCE_GPIO);
    }
    if (!mip_succeeded(result)) {
        report(mip_outcome_name(result.outcome), mip_result_reason(result)); /* refused, ... */
        return false;
    }
    while (mip_device_poll(&device)) { /* until the port is lost */
    }
    return true;
}
