/* What firmware usually does by hand, for comparison: a parser that copies each byte,
 * a checksum loop, a switch over the descriptors of the log, a builder that works byte by byte. */
#ifndef PLAIN_H
#define PLAIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct plain_parser {
    uint8_t buffer[261];
    /** Bytes in the buffer; size of the packet, once its header is there. */
    uint16_t length;
    uint16_t size;
};

struct plain_vector {
    float xyz[3];
    uint16_t valid;
};

struct plain_time {
    double tow;
    uint16_t week;
    uint16_t valid;
};

struct plain_quaternion {
    float q[4];
    uint16_t valid;
};

struct plain_position {
    double llh[3];
    uint16_t valid;
};

struct plain_status {
    uint16_t state;
    uint16_t mode;
    uint16_t flags;
};

union plain_value {
    struct plain_vector vector;
    struct plain_time time;
    struct plain_quaternion quaternion;
    struct plain_position position;
    struct plain_status status;
};

struct plain_builder {
    uint8_t *buffer;
    size_t capacity;
    size_t length;
    bool failed;
};

void plain_init(struct plain_parser *parser);
/** Takes bytes until a packet is in the buffer. */
bool plain_next(struct plain_parser *parser, const uint8_t **data, size_t *size);
/** The next field of the packet in the buffer. `at` begins at 4. */
bool plain_field(const struct plain_parser *parser, size_t *at, uint8_t *descriptor,
                 const uint8_t **data, size_t *size);
bool plain_decode(uint8_t set, uint8_t descriptor, const uint8_t *data, size_t size,
                  union plain_value *value);

void plain_start(struct plain_builder *builder, uint8_t *buffer, size_t capacity, uint8_t set);
void plain_begin(struct plain_builder *builder, uint8_t descriptor, size_t size);
void plain_float(struct plain_builder *builder, float value);
void plain_u64(struct plain_builder *builder, uint64_t value);
size_t plain_finish(struct plain_builder *builder);

#endif
