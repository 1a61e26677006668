/* Packets, fields, and the codec of values. */
#include "mip/core.h"

#include <string.h>

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
    walk.at = packet->bytes + MIP_HEADER_SIZE;
    walk.end = packet->bytes + packet->size - MIP_CHECKSUM_SIZE;
    walk.descriptor_set = packet->descriptor_set;
    walk.malformed = false;
    return walk;
}

bool mip_walk_next(struct mip_walk *walk, struct mip_field *field) {
    const size_t left = (size_t)(walk->end - walk->at);
    if (left == 0 || walk->malformed) {
        return false;
    }
    const uint8_t length = walk->at[0];
    if (length < 2 || length > left) {
        walk->malformed = true;
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

/** The maximum size of the data of one more field; false if not even an empty field fits. */
static bool room_for_field(const struct mip_builder *builder, size_t *room) {
    const size_t taken = builder->length + 2 + MIP_CHECKSUM_SIZE;
    if (builder->capacity < taken) {
        return false;
    }
    *room = builder->capacity - taken;
    return true;
}

/** Completes a field whose data are already in place behind its header. */
static void append(struct mip_builder *builder, uint8_t descriptor, size_t size) {
    builder->buffer[builder->length] = (uint8_t)(size + 2);
    builder->buffer[builder->length + 1] = descriptor;
    builder->length += size + 2;
    builder->buffer[3] = (uint8_t)(builder->length - MIP_HEADER_SIZE);
}

mip_error mip_builder_add(struct mip_builder *builder, uint8_t descriptor, const void *data,
                          size_t size) {
    size_t room;
    if (!room_for_field(builder, &room) || size > room) {
        return MIP_ERROR_LENGTH;
    }
    if (size > 0) {
        memmove(builder->buffer + builder->length + 2, data, size);
    }
    append(builder, descriptor, size);
    return MIP_OK;
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

/* ------------------------------------------------------------------------------------- decoding */

mip_error mip_decode_field(const struct mip_field *field, mip_read_function read, void *value,
                           size_t size, size_t *trailing) {
    struct mip_reader r;
    const uint8_t *end = field->data + field->size;
    for (;;) {
        memset(&r, 0, sizeof(r));
        memset(value, 0, size);
        r.at = field->data;
        r.end = end;
        read(&r, value);
        if (!r.cut) {
            break;
        }
        end = r.mark; /* again, without the incomplete group */
    }
    if (r.error != MIP_OK) {
        memset(value, 0, size);
    }
    if (trailing != NULL) {
        *trailing = (size_t)(field->data + field->size - r.at);
    }
    return (mip_error)r.error;
}

mip_error mip_decode(const struct mip_codec *codec, void *value, const struct mip_field *field,
                     size_t *trailing) {
    return mip_decode_field(field, codec->read, value, codec->size, trailing);
}

static void fail_reading(struct mip_reader *r, mip_error error) {
    if (error == MIP_ERROR_TRUNCATED && r->optional) {
        r->cut = true;
    } else {
        r->error = (uint8_t)error;
    }
    r->stopped = true;
}

/** The next bytes, or NULL if there are too few or reading has ended. */
static const uint8_t *take(struct mip_reader *r, size_t size) {
    if (r->stopped) {
        return NULL;
    }
    if (size > (size_t)(r->end - r->at)) {
        fail_reading(r, MIP_ERROR_TRUNCATED);
        return NULL;
    }
    const uint8_t *from = r->at;
    r->at += size;
    return from;
}

void mip_read_nothing(struct mip_reader *r, void *value) {
    (void)r;
    (void)value;
}

static uint32_t get_32(const uint8_t *from) {
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8 | from[3];
}

void mip_read_8(struct mip_reader *r, void *to, size_t count) {
    const uint8_t *from = take(r, count);
    if (from != NULL && count > 0) {
        memcpy(to, from, count);
    }
}

void mip_read_16(struct mip_reader *r, void *to, size_t count) {
    uint8_t *out = (uint8_t *)to;
    const uint8_t *from = take(r, 2 * count);
    for (size_t i = 0; from != NULL && i < count; i++) {
        const uint16_t value = (uint16_t)((uint32_t)from[2 * i] << 8 | from[2 * i + 1]);
        memcpy(out + 2 * i, &value, 2);
    }
}

void mip_read_32(struct mip_reader *r, void *to, size_t count) {
    uint8_t *out = (uint8_t *)to;
    const uint8_t *from = take(r, 4 * count);
    for (size_t i = 0; from != NULL && i < count; i++) {
        const uint32_t value = get_32(from + 4 * i);
        memcpy(out + 4 * i, &value, 4);
    }
}

void mip_read_64(struct mip_reader *r, void *to, size_t count) {
    uint8_t *out = (uint8_t *)to;
    const uint8_t *from = take(r, 8 * count);
    for (size_t i = 0; from != NULL && i < count; i++) {
        const uint64_t value = (uint64_t)get_32(from + 8 * i) << 32 | get_32(from + 8 * i + 4);
        memcpy(out + 8 * i, &value, 8);
    }
}

void mip_read_constant(struct mip_reader *r, uint64_t value, size_t size) {
    const uint8_t *from = take(r, size);
    for (size_t i = 0; from != NULL && i < size; i++) {
        if (from[i] != (uint8_t)(value >> 8 * (size - 1 - i))) {
            fail_reading(r, MIP_ERROR_CONSTANT);
            return;
        }
    }
}

size_t mip_read_count(struct mip_reader *r, uint32_t count, size_t capacity, size_t item) {
    if (r->stopped) {
        return 0;
    }
    if (count > capacity || count > (size_t)(r->end - r->at) / item) {
        fail_reading(r, MIP_ERROR_COUNT);
        return 0;
    }
    return (size_t)count;
}

size_t mip_read_rest(struct mip_reader *r, size_t capacity, size_t item) {
    if (r->stopped) {
        return 0;
    }
    const size_t count = (size_t)(r->end - r->at) / item;
    return count < capacity ? count : capacity;
}

static uint8_t required_by(uint8_t function, const uint8_t *table, size_t size) {
    return function < size ? table[function] : 0;
}

void mip_read_required(struct mip_reader *r, uint8_t function, const uint8_t *table, size_t size) {
    r->required = required_by(function, table, size);
}

void mip_read_group(struct mip_reader *r, uint8_t first, uint8_t last) {
    if (r->stopped) {
        return;
    }
    r->present = (uint8_t)(first - 1);
    r->last = last;
    r->mark = r->at;
    r->optional = last > r->required;
    r->stopped = r->optional && r->at == r->end;
}

uint8_t mip_read_present(const struct mip_reader *r) {
    const bool empty = r->optional && r->at == r->mark; /* an empty union: same as absent */
    return r->stopped || empty ? r->present : r->last;
}

/* ------------------------------------------------------------------------------------- encoding */

/**
 * May this packet hold the field? Commands and responses belong to their own set, the acknowledge
 * field to every command set, data to every data set, because sets share them.
 */
static bool belongs(const struct mip_builder *builder, uint8_t descriptor_set) {
    const uint8_t packet = builder->buffer[2];
    if (descriptor_set >= 0x80) {
        return packet >= 0x80;
    }
    return descriptor_set == 0 ? packet < 0x80 : packet == descriptor_set;
}

mip_error mip_encode_field(struct mip_builder *builder, uint8_t descriptor_set, uint8_t descriptor,
                           mip_write_function write, const void *value) {
    struct mip_writer w;
    size_t room;
    if (!room_for_field(builder, &room)) {
        return MIP_ERROR_LENGTH;
    }
    if (!belongs(builder, descriptor_set)) {
        return MIP_ERROR_SET;
    }
    memset(&w, 0, sizeof(w));
    w.at = builder->buffer + builder->length + 2;
    w.end = w.at + room;
    write(&w, value);
    if (!w.stopped && w.present > w.last) {
        w.error = MIP_ERROR_MISSING;
    }
    if (w.error == MIP_OK) {
        append(builder, descriptor, (size_t)(w.at - (builder->buffer + builder->length + 2)));
    }
    return (mip_error)w.error;
}

mip_error mip_encode(const struct mip_codec *codec, const void *value,
                     struct mip_builder *builder) {
    return mip_encode_field(builder, codec->descriptor_set, codec->descriptor, codec->write, value);
}

static void fail_writing(struct mip_writer *w, mip_error error) {
    w->error = (uint8_t)error;
    w->stopped = true;
}

/** Where to write the next bytes, or NULL if they do not fit or writing has ended. */
static uint8_t *give(struct mip_writer *w, size_t size) {
    if (w->stopped) {
        return NULL;
    }
    if (size > (size_t)(w->end - w->at)) {
        fail_writing(w, MIP_ERROR_LENGTH);
        return NULL;
    }
    uint8_t *to = w->at;
    w->at += size;
    return to;
}

void mip_write_nothing(struct mip_writer *w, const void *value) {
    (void)w;
    (void)value;
}

static void put_32(uint8_t *to, uint32_t value) {
    to[0] = (uint8_t)(value >> 24);
    to[1] = (uint8_t)(value >> 16);
    to[2] = (uint8_t)(value >> 8);
    to[3] = (uint8_t)value;
}

void mip_write_8(struct mip_writer *w, const void *from, size_t count) {
    uint8_t *to = give(w, count);
    if (to != NULL && count > 0) {
        memcpy(to, from, count);
    }
}

void mip_write_16(struct mip_writer *w, const void *from, size_t count) {
    const uint8_t *in = (const uint8_t *)from;
    uint8_t *to = give(w, 2 * count);
    for (size_t i = 0; to != NULL && i < count; i++) {
        uint16_t value;
        memcpy(&value, in + 2 * i, 2);
        to[2 * i] = (uint8_t)(value >> 8);
        to[2 * i + 1] = (uint8_t)(value & 0xFFU);
    }
}

void mip_write_32(struct mip_writer *w, const void *from, size_t count) {
    const uint8_t *in = (const uint8_t *)from;
    uint8_t *to = give(w, 4 * count);
    for (size_t i = 0; to != NULL && i < count; i++) {
        uint32_t value;
        memcpy(&value, in + 4 * i, 4);
        put_32(to + 4 * i, value);
    }
}

void mip_write_64(struct mip_writer *w, const void *from, size_t count) {
    const uint8_t *in = (const uint8_t *)from;
    uint8_t *to = give(w, 8 * count);
    for (size_t i = 0; to != NULL && i < count; i++) {
        uint64_t value;
        memcpy(&value, in + 8 * i, 8);
        put_32(to + 8 * i, (uint32_t)(value >> 32));
        put_32(to + 8 * i + 4, (uint32_t)(value & 0xFFFFFFFFU));
    }
}

void mip_write_constant(struct mip_writer *w, uint64_t value, size_t size) {
    uint8_t *to = give(w, size);
    for (size_t i = 0; to != NULL && i < size; i++) {
        to[i] = (uint8_t)(value >> 8 * (size - 1 - i));
    }
}

size_t mip_write_count(struct mip_writer *w, uint32_t count, size_t capacity) {
    if (w->stopped) {
        return 0;
    }
    if (count > capacity) {
        fail_writing(w, MIP_ERROR_COUNT);
        return 0;
    }
    return (size_t)count;
}

void mip_write_required(struct mip_writer *w, uint8_t function, const uint8_t *table, size_t size,
                        uint8_t present) {
    const uint8_t required = required_by(function, table, size);
    w->present = present > required ? present : required;
}

void mip_write_group(struct mip_writer *w, uint8_t first, uint8_t last) {
    if (w->stopped) {
        return;
    }
    w->last = last;
    if (w->present >= first && w->present < last) {
        fail_writing(w, MIP_ERROR_MISSING);
    }
    w->stopped = w->present < last;
}

/* --------------------------------------------------------------------------------------- values */

void mip_copy(void *to, size_t room, const void *from, size_t size) {
    if (size > 0 && room > 0) {
        memcpy(to, from, size < room ? size : room);
    }
}

void mip_copy_text(char *to, size_t room, const char *text) {
    size_t i = 0;
    for (; i + 1 < room && text[i] != '\0'; i++) {
        to[i] = text[i];
    }
    for (; i + 1 < room; i++) {
        to[i] = ' ';
    }
    to[i] = '\0';
}

uint64_t mip_get_bits(const uint8_t *bytes, unsigned first, unsigned width) {
    uint64_t value = 0;
    for (unsigned i = width; i-- > 0;) {
        const unsigned bit = first + i;
        value = value << 1 | (bytes[bit / 8] >> bit % 8 & 1U);
    }
    return value;
}

void mip_set_bits(uint8_t *bytes, unsigned first, unsigned width, uint64_t value) {
    for (unsigned i = 0; i < width; i++) {
        const unsigned bit = first + i;
        const unsigned mask = 1U << bit % 8;
        if ((value >> i & 1U) != 0) {
            bytes[bit / 8] = (uint8_t)(bytes[bit / 8] | mask);
        } else {
            bytes[bit / 8] = (uint8_t)(bytes[bit / 8] & ~mask);
        }
    }
}
