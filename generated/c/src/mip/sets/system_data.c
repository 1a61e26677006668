/* System data. */
#include "mip/system_data.h"
#include "mip/core/program.h"

static const uint8_t program_built_in_test[] = {
    MIP_8_BITS(16, MIP_AT(struct mip_system_data_built_in_test, result)),
    MIP_END,
};

MIP_CODEC(mip_system_data_built_in_test, 0xA0, 0x01, MIP_DATA, 16, 0, 0, program_built_in_test,
          NULL);

static const uint8_t program_time_sync_status[] = {
    MIP_8_BITS(2, MIP_AT(struct mip_system_data_time_sync_status, time_sync)),
    MIP_END,
};

MIP_CODEC(mip_system_data_time_sync_status, 0xA0, 0x02, MIP_DATA, 2, 0, 0, program_time_sync_status,
          NULL);

static const uint8_t program_gpio_state[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_system_data_gpio_state, states)),
    MIP_END,
};

MIP_CODEC(mip_system_data_gpio_state, 0xA0, 0x03, MIP_DATA, 1, 0, 0, program_gpio_state, NULL);

static const uint8_t program_gpio_analog_value[] = {
    MIP_8_BITS(1, MIP_AT(struct mip_system_data_gpio_analog_value, gpio_id)),
    MIP_32_BITS(1, MIP_AT(struct mip_system_data_gpio_analog_value, value)),
    MIP_END,
};

MIP_CODEC(mip_system_data_gpio_analog_value, 0xA0, 0x04, MIP_DATA, 5, 0, 0,
          program_gpio_analog_value, NULL);
