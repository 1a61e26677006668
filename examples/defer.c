#include "mip/3dm_commands.h"

/* Reads the PPS source and changes it, without waiting. Call this as often as you like, until it returns true;
 * `bytes` have arrived since the last time, perhaps none. */
bool set_pps_source(struct mip_device *device, const uint8_t *bytes, size_t size) {
    static struct mip_request request; /* NOT_SENT at first */
    static struct mip_3dm_pps_source_control_response pps;
    static enum { READ, WRITE, DONE } next = READ;
    mip_device_step(device, bytes, size); /* calls the handlers of data */
    if (request.result.outcome == MIP_WAITING) {
        return false;
    }
    if (next == READ) {
        mip_call_3dm_pps_source_control_read(mip_defer(device, &request), &pps);
        next = WRITE;
    } else if (next == WRITE && mip_succeeded(request.result)) {
        mip_call_3dm_pps_source_control_write(mip_defer(device, &request), MIP_3DM_PPS_SOURCE_GPIO);
        next = DONE;
    } else if (next == WRITE) {
        next = READ; /* it was rejected, or not answered: try again */
    } else {
        return true;
    }
    return false;
}
