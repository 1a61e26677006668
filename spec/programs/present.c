#include "mip/filter.h"

/* All but the last parameter of a command whose parameters may be left out, from the end on. */
mip_error limit_error(struct mip_builder *packet) {
    struct mip_filter_accel_magnitude_adaptive command;
    mip_filter_accel_magnitude_adaptive_write(&command, MIP_FILTER_ADAPTIVE_MEASUREMENT_SELECTOR_FIXED);
    /* present is 0 now: only what write requires would be sent. */
    command.frequency = 10;
    command.low_limit = -1;
    command.high_limit = 1;
    command.low_limit_uncertainty = 0.5F;
    command.high_limit_uncertainty = 0.5F;
    command.present = MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT_UNCERTAINTY;
    return mip_filter_accel_magnitude_adaptive_encode(&command, packet);
}

/* The limit that a device has told; 0 if it has not. */
float limit_of(const struct mip_filter_accel_magnitude_adaptive *command) {
    return command->present >= MIP_FILTER_ACCEL_MAGNITUDE_ADAPTIVE_WITH_HIGH_LIMIT ? command->high_limit : 0;
}
