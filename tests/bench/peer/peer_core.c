/* The same as ours_core.c with the vendor's SDK. */
#include "mip/mip_field.h"
#include "mip/mip_parser.h"

extern uint8_t rx[64];
extern size_t rx_size;
void tx(const uint8_t *bytes, size_t size);

mip_parser parser;
uint32_t seen;

static bool on_packet(void *user, const mip_packet_view *packet, mip_timestamp time) {
    (void)user, (void)time;
    mip_field_view field;
    mip_field_init_empty(&field);
    while (mip_field_next_in_packet(&field, packet)) {
        seen += mip_field_field_descriptor(&field) + mip_field_payload(&field)[0];
    }
    return true;
}

int main(void) {
    uint8_t buffer[261];
    mip_packet_view packet;
    mip_packet_create(&packet, buffer, sizeof(buffer), 0x01);
    mip_packet_add_field(&packet, 0x01, NULL, 0);
    mip_packet_finalize(&packet);
    tx(mip_packet_buffer(&packet), mip_packet_total_length(&packet));
    mip_parser_init(&parser, on_packet, NULL, 100);
    for (;;) {
        mip_parser_parse(&parser, rx, rx_size, 0);
    }
}
