#include "mip/filter.h"

/* Sends all optional parameters of a command except the last one. */
mip_error limit_error(struct mip_builder *packet) {
    struct mip_filter_accel_magnitude_adaptive command;
    mip_filter_accel_magnitude_adaptive_write(&command, MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED);
    /* present is 0 here, so only the parameters that write requires would be sent. */
    command.frequency = 10;
    command.low_limit = -1;
    command.high_limit = 1;
    command.low_limit_uncertainty = 0.5F;
    command.high_limit_uncertainty = 0.5F;
    command.present = MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT_UNCERTAINTY;
    return mip_filter_accel_magnitude_adaptive_encode(&command, packet);
}

/* Returns the limit that the device reports; 0 if it reports none. */
float limit_of(const struct mip_filter_accel_magnitude_adaptive *command) {
    return command->present >= MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT ? command->high_limit : 0;
}
