// The headers in a C++ program, linked with the library in C.
#include "mip/measurements.h"
#include "mip/extra/profiles.h"
#include "mip/extra/reflect.h"
#include "mip/extra/registry.h"
#include "mip/tools_commands.h"

#include <cstring>

// An enumeration holds every value that its member can have, and converts back to it.
static_assert(sizeof(mip_mode) == 1, "a value that has no name would be undefined");
static_assert(static_cast<uint8_t>(static_cast<mip_mode>(0xFE)) == 0xFE, "lost");

int main() {
    uint8_t buffer[MIP_MAX_PACKET];
    mip_builder builder;
    mip_tools_settings command;
    mip_tools_settings_write(&command, 1, MIP_MODE_SLOW, 9600);
    mip_measurements_accel accel = {{1.0F, 2.0F, 3.0F}, MIP_STATE_FLAGS_READY};
    mip_clear_16(&accel.valid_flags, MIP_STATE_FLAGS_READY | MIP_STATE_FLAGS_HOT);
    mip_state_flags_set_level(&accel.valid_flags, 5);
    bool good = mip_builder_start(&builder, buffer, sizeof buffer, MIP_TOOLS_SET) == MIP_OK &&
                mip_tools_settings_encode(&command, &builder) == MIP_OK &&
                mip_builder_finish(&builder).size == 15 && mip_state_flags_get_level(accel.valid_flags) == 5;
    good = good && mip_registry_by_name("tools.ping", nullptr)->codec == &mip_tools_ping_codec &&
           mip_reflect(&mip_measurements_accel_codec) != nullptr && mip_profile_find("model-a") == &mip_profile_model_a;
    static const mip_handler handler = {&mip_measurements_accel_codec, MIP_MORE_SET, nullptr, nullptr};
    const mip_field field = {nullptr, 0, handler.descriptor_set, handler.type->descriptor};
    switch (mip_field_key(&field)) {
    case MIP_MEASUREMENTS_ACCEL(MIP_MORE_SET):
        good = good && mip_field_is(&field, handler.type);
        break;
    default:
        good = false;
    }
    mip_client client;
    mip_request request;
    mip_client_init(&client);
    good = good && mip_send_tools_settings(&client, &request, &builder, &command, nullptr, 0) == MIP_OK;
    return good && client.waiting == &request ? 0 : 1;
}
