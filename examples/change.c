#include "mip/3dm_commands.h"

/* Reads an event trigger, changes its lower threshold, and writes it back with everything else as it was. */
struct mip_result set_threshold(struct mip_device *device, uint8_t instance, double low) {
    struct mip_3dm_event_trigger_config_response trigger;
    struct mip_3dm_event_trigger_config command;
    struct mip_result result = mip_call_3dm_event_trigger_config_read(device, instance, &trigger);
    if (mip_succeeded(result) && trigger.type == MIP_EVENT_TRIGGER_TYPE_THRESHOLD) {
        trigger.parameters.threshold.thresholds.window.low_threshold = low;
        mip_3dm_event_trigger_config_write_from(&command, &trigger);
        result = mip_call_3dm_event_trigger_config_with(device, &command, NULL);
    }
    return result;
}
