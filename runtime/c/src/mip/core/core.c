/* Packets, fields, and the packet builder. */
#include "mip/core.h"

#include "mip/core/checksum.h"

unsigned long mip_version(void) {
    return MIP_VERSION_NUMBER;
}

/* --------------------------------------------------------------------------- packets and fields */

uint16_t mip_checksum(const uint8_t *bytes, size_t size) {
    return mip_sum(bytes, size);
}

mip_error mip_packet_check(const uint8_t *bytes, size_t size, struct mip_packet *packet) {
    if (size < 2 || bytes[0] != MIP_SYNC_1 || bytes[1] != MIP_SYNC_2) {
        return MIP_ERROR_SYNC;
    }
    if (size < MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE || !mip_set_valid(bytes[2]) ||
        size != (size_t)bytes[3] + MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE) {
        return MIP_ERROR_LENGTH;
    }
    const uint16_t sum = mip_checksum(bytes, size - MIP_CHECKSUM_SIZE);
    if (bytes[size - 2] != sum >> 8 || bytes[size - 1] != (sum & 0xFFU)) {
        return MIP_ERROR_CHECKSUM;
    }
    packet->bytes = bytes;
    packet->size = size;
    packet->descriptor_set = bytes[2];
    return MIP_OK;
}

/* ------------------------------------------------------------------------------- packet builder */

size_t mip_packet_seal(uint8_t *bytes, uint8_t descriptor_set, size_t size) {
    const size_t end = MIP_HEADER_SIZE + size;
    bytes[0] = MIP_SYNC_1;
    bytes[1] = MIP_SYNC_2;
    bytes[2] = descriptor_set;
    bytes[3] = (uint8_t)size;
    mip_put_16(bytes + end, mip_checksum(bytes, end));
    return end + MIP_CHECKSUM_SIZE;
}

mip_error mip_builder_add(struct mip_builder *builder, uint8_t descriptor, const void *data,
                          size_t size) {
    uint8_t *to;
    if (size > MIP_MAX_FIELD_DATA) {
        return mip_builder_note(builder, MIP_ERROR_LENGTH);
    }
    const mip_error error =
        mip_builder_reserve(builder, mip_builder_set(builder), descriptor, size, &to);
    if (error == MIP_OK && size > 0) {
        memmove(to, data, size);
    }
    return error;
}
