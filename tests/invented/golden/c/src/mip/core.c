/* Packets, fields, and the packet builder. */
#include "mip/core.h"

/* --------------------------------------------------------------------------- packets and fields */

mip_error mip_packet_check(const uint8_t *bytes, size_t size, struct mip_packet *packet) {
    if (size < 2 || bytes[0] != MIP_SYNC_1 || bytes[1] != MIP_SYNC_2) {
        return MIP_ERROR_SYNC;
    }
    if (size < MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE || bytes[2] == 0 ||
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

struct mip_walk mip_walk_packet(const struct mip_packet *packet) {
    struct mip_walk walk;
    walk.at = packet->bytes;
    walk.end = packet->bytes;
    if (packet->size >= MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE) { /* no packet: no fields */
        walk.at += MIP_HEADER_SIZE;
        walk.end += packet->size - MIP_CHECKSUM_SIZE;
    }
    walk.descriptor_set = packet->descriptor_set;
    walk.error = MIP_OK;
    return walk;
}

bool mip_walk_next(struct mip_walk *walk, struct mip_field *field) {
    const size_t left = (size_t)(walk->end - walk->at);
    if (left == 0 || walk->error != MIP_OK) {
        return false;
    }
    const uint8_t length = walk->at[0];
    if (length < 2 || length > left) {
        walk->error = MIP_ERROR_FIELD_LENGTH;
        return false;
    }
    field->data = walk->at + 2;
    field->size = (uint8_t)(length - 2);
    field->descriptor_set = walk->descriptor_set;
    field->descriptor = walk->at[1];
    walk->at += length;
    return true;
}

/* ------------------------------------------------------------------------------- packet builder */

mip_error mip_builder_start(struct mip_builder *builder, uint8_t *buffer, size_t capacity,
                            uint8_t descriptor_set) {
    builder->buffer = buffer;
    builder->capacity = 0;
    builder->length = 0;
    if (capacity < MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE || descriptor_set == 0) {
        return MIP_ERROR_LENGTH;
    }
    buffer[0] = MIP_SYNC_1;
    buffer[1] = MIP_SYNC_2;
    buffer[2] = descriptor_set;
    buffer[3] = 0;
    builder->capacity = capacity < MIP_MAX_PACKET ? capacity : MIP_MAX_PACKET;
    builder->length = MIP_HEADER_SIZE;
    return MIP_OK;
}

mip_error mip_builder_add(struct mip_builder *builder, uint8_t descriptor, const void *data,
                          size_t size) {
    uint8_t *to;
    const uint8_t set = builder->length > 0 ? builder->buffer[2] : 0;
    if (size > MIP_MAX_FIELD_DATA) {
        return MIP_ERROR_LENGTH;
    }
    const mip_error error = mip_builder_reserve(builder, set, descriptor, size, &to);
    if (error == MIP_OK && size > 0) {
        memmove(to, data, size);
    }
    return error;
}

struct mip_packet mip_builder_finish(struct mip_builder *builder) {
    struct mip_packet packet = {builder->buffer, 0, 0};
    if (builder->length > 0) {
        const uint16_t sum = mip_checksum(builder->buffer, builder->length);
        builder->buffer[builder->length] = (uint8_t)(sum >> 8);
        builder->buffer[builder->length + 1] = (uint8_t)(sum & 0xFFU);
        packet.size = builder->length + MIP_CHECKSUM_SIZE;
        packet.descriptor_set = builder->buffer[2];
    }
    return packet;
}
