#include "plain.h"

#include <string.h>

static void checksum(const uint8_t *bytes, size_t size, uint8_t sum[2]) {
    uint32_t a = 0;
    uint32_t b = 0;
    for (size_t i = 0; i < size; i++) {
        a += bytes[i];
        b += a;
    }
    sum[0] = (uint8_t)a;
    sum[1] = (uint8_t)b;
}

void plain_init(struct plain_parser *parser) {
    parser->length = 0;
}

/** Takes one byte. True if it completes a packet. Bytes that turn out not to be a packet are lost. */
static inline bool take(struct plain_parser *parser, uint8_t byte) {
    uint8_t sum[2];
    const size_t length = parser->length;
    parser->buffer[length] = byte;
    parser->length = (uint16_t)(length + 1);
    if (length >= 4) {
        if (length + 1 < parser->size) {
            return false;
        }
        parser->length = 0;
        checksum(parser->buffer, length - 1, sum);
        return parser->buffer[length - 1] == sum[0] && byte == sum[1];
    }
    if ((length == 0 && byte != 0x75) || (length == 1 && byte != 0x65)) {
        parser->length = 0;
    } else if (length == 3) {
        parser->size = byte + 6U;
    }
    return false;
}

bool plain_next(struct plain_parser *parser, const uint8_t **data, size_t *size) {
    const uint8_t *at = *data;
    const uint8_t *end = at + *size;
    bool found = false;
    while (!found && at < end) {
        found = take(parser, *at++);
    }
    *data = at;
    *size = (size_t)(end - at);
    return found;
}

bool plain_field(const struct plain_parser *parser, size_t *at, uint8_t *descriptor,
                 const uint8_t **data, size_t *size) {
    const uint8_t *field = parser->buffer + *at;
    const size_t left = parser->size - 2U - *at;
    if (left < 2 || field[0] < 2 || field[0] > left) {
        return false;
    }
    *descriptor = field[1];
    *data = field + 2;
    *size = field[0] - 2U;
    *at += field[0];
    return true;
}

static uint16_t get_u16(const uint8_t *p) {
    return (uint16_t)(p[0] << 8 | p[1]);
}

static uint32_t get_u32(const uint8_t *p) {
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

static void get_floats(float *to, const uint8_t *p, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const uint32_t bits = get_u32(p + 4 * i);
        memcpy(&to[i], &bits, 4);
    }
}

static void get_doubles(double *to, const uint8_t *p, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const uint64_t bits = (uint64_t)get_u32(p + 8 * i) << 32 | get_u32(p + 8 * i + 4);
        memcpy(&to[i], &bits, 8);
    }
}

bool plain_decode(uint8_t set, uint8_t descriptor, const uint8_t *data, size_t size,
                  union plain_value *value) {
    switch (set << 8 | descriptor) {
    case 0x8004: /* acceleration, angular rate, their sums */
    case 0x8005:
    case 0x8007:
    case 0x8008:
        if (size < 12) {
            return false;
        }
        get_floats(value->vector.xyz, data, 3);
        return true;
    case 0x8012: /* time */
    case 0x8211:
        if (size < 12) {
            return false;
        }
        get_doubles(&value->time.tow, data, 1);
        value->time.week = get_u16(data + 8);
        value->time.valid = get_u16(data + 10);
        return true;
    case 0x8203: /* attitude */
        if (size < 18) {
            return false;
        }
        get_floats(value->quaternion.q, data, 4);
        value->quaternion.valid = get_u16(data + 16);
        return true;
    case 0x8201: /* position */
        if (size < 26) {
            return false;
        }
        get_doubles(value->position.llh, data, 3);
        value->position.valid = get_u16(data + 24);
        return true;
    case 0x8202: /* velocity, acceleration, angular rate */
    case 0x820D:
    case 0x820E:
        if (size < 14) {
            return false;
        }
        get_floats(value->vector.xyz, data, 3);
        value->vector.valid = get_u16(data + 12);
        return true;
    case 0x8210: /* status */
        if (size < 6) {
            return false;
        }
        value->status.state = get_u16(data);
        value->status.mode = get_u16(data + 2);
        value->status.flags = get_u16(data + 4);
        return true;
    default:
        return false;
    }
}

void plain_start(struct plain_builder *builder, uint8_t *buffer, size_t capacity, uint8_t set) {
    const uint8_t head[] = {0x75, 0x65, set, 0};
    builder->buffer = buffer;
    builder->capacity = capacity;
    builder->length = 0;
    builder->failed = capacity < 6;
    if (!builder->failed) {
        memcpy(buffer, head, sizeof(head));
        builder->length = sizeof(head);
    }
}

static void put(struct plain_builder *builder, uint8_t byte) {
    if (builder->length + 2 < builder->capacity) {
        builder->buffer[builder->length++] = byte;
    } else {
        builder->failed = true;
    }
}

void plain_begin(struct plain_builder *builder, uint8_t descriptor, size_t size) {
    put(builder, (uint8_t)(size + 2));
    put(builder, descriptor);
}

void plain_u64(struct plain_builder *builder, uint64_t value) {
    for (int shift = 56; shift >= 0; shift -= 8) {
        put(builder, (uint8_t)(value >> shift));
    }
}

void plain_float(struct plain_builder *builder, float value) {
    uint32_t bits;
    memcpy(&bits, &value, 4);
    for (int shift = 24; shift >= 0; shift -= 8) {
        put(builder, (uint8_t)(bits >> shift));
    }
}

size_t plain_finish(struct plain_builder *builder) {
    if (builder->failed) {
        return 0;
    }
    builder->buffer[3] = (uint8_t)(builder->length - 4);
    checksum(builder->buffer, builder->length, builder->buffer + builder->length);
    return builder->length + 2;
}
