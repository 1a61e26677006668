#include "mip/3dm_commands.h"

bool set_pps_source(struct mip_client *client, struct mip_parser *parser, enum mip_3dm_pps_source source) {
    uint8_t bytes[MIP_MAX_SENT];
    struct mip_builder builder;
    struct mip_request request;
    struct mip_3dm_pps_source_control command;
    mip_3dm_pps_source_control_write(&command, source);

    size_t sent = mip_client_start(client, &builder, bytes, MIP_3DM_SET);
    if (mip_send_3dm_pps_source_control(client, &request, &builder, &command, NULL,
                                        milliseconds()) != MIP_OK) {
        return false;
    }
    sent += mip_builder_finish(&builder).size;
    transmit(bytes, sent);
    while (request.result.outcome == MIP_WAITING) {
        uint8_t chunk[64];
        const uint8_t *data = chunk;
        size_t size = receive(chunk, sizeof(chunk)); /* 0 if none arrived */
        struct mip_packet packet;
        while (mip_client_step(client, parser, milliseconds(), &data, &size, &packet)) {
            handle(&packet); /* its data */
        }
    }
    return mip_succeeded(request.result); /* otherwise, mip_result_reason(request.result) is the reason */
}
