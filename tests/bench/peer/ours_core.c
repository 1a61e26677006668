/* Parser, walk and builder: firmware that only forwards packets links these. */
#include "mip/core.h"

extern uint8_t rx[64];
extern size_t rx_size;
void tx(const uint8_t *bytes, size_t size);

struct mip_parser parser;
uint32_t seen;

int main(void) {
    uint8_t buffer[MIP_MAX_PACKET];
    struct mip_builder builder;
    mip_builder_start(&builder, buffer, sizeof(buffer), 0x01);
    (void)(mip_builder_add(&builder, 0x01, NULL, 0) == MIP_OK);
    struct mip_packet packet = mip_builder_finish(&builder);
    tx(packet.bytes, packet.size);
    mip_parser_init(&parser);
    for (;;) {
        const uint8_t *data = rx;
        size_t size = rx_size;
        while (mip_parser_next(&parser, &data, &size, &packet)) {
            struct mip_walk walk = mip_walk_packet(&packet);
            struct mip_field field;
            while (mip_walk_next(&walk, &field)) {
                seen += field.descriptor + field.data[0];
            }
        }
    }
}
