#include "mip/3dm.h"
#include "mip/client.h"

bool set_pps_source(struct mip_client *client, mip_3dm_pps_source source) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    struct mip_request request;
    struct mip_3dm_pps_source_control command = mip_3dm_pps_source_control_write(source);

    mip_builder_start(&builder, buffer, sizeof(buffer), MIP_3DM_SET);
    if (mip_client_add(client, &request, &builder, &mip_3dm_pps_source_control_codec, &command,
                       milliseconds()) != MIP_OK) {
        return false;
    }
    transmit(mip_builder_finish(&builder));
    while (request.state == MIP_REQUEST_WAITING) {
        struct mip_packet packet;
        if (receive(&packet)) { /* from your parser; data go wherever data go */
            mip_client_receive(client, &packet);
        }
        mip_client_expire(client, milliseconds());
    }
    return request.state == MIP_REQUEST_ACKNOWLEDGED; /* if it was refused, request.code says why */
}
