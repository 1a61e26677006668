#include "mip/3dm_commands.h"

bool set_pps_source(struct mip_client *client, struct mip_parser *parser, enum mip_3dm_pps_source source) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    struct mip_request request;
    struct mip_3dm_pps_source_control command;
    mip_3dm_pps_source_control_write(&command, source);

    mip_builder_start(&builder, buffer, sizeof(buffer), MIP_3DM_SET);
    if (mip_send_3dm_pps_source_control(client, &request, &builder, &command, NULL,
                                        milliseconds()) != MIP_OK) {
        return false;
    }
    transmit(mip_builder_finish(&builder));
    while (request.state == MIP_REQUEST_WAITING) {
        uint8_t chunk[64];
        const uint8_t *data = chunk;
        size_t size = receive(chunk, sizeof(chunk)); /* 0 if none arrived */
        struct mip_packet packet;
        while (mip_parser_next(parser, &data, &size, &packet) ||
               mip_client_poll(client, parser, milliseconds(), &packet)) {
            mip_client_receive(client, &packet); /* also handle the packet's data here */
        }
    }
    return request.state == MIP_REQUEST_ACKNOWLEDGED; /* if refused, request.code is the reason */
}
