/* speed FILE FUNCTION ROUNDS: runs one of the functions below over the bytes of a file, and prints
 * the fewest nanoseconds of processor time that a round took and what it found. Each is a function
 * of its own, so that valgrind can count the instructions of one. */
#include "mip/device.h"
#include "mip/filter_data_inline.h"
#include "mip/sensor_inline.h"
#include "mip/shared_inline.h"
#include "rounds.h"
#ifndef BOARD
#include "mip/extra/registry.h"
#endif

enum { CHUNK = 4096,
       SMALL = 64,
       BUILT = 44 };

/** The known fields of the log. */
#define FIELDS(X)                                                       \
    X(SENSOR_SCALED_ACCEL, sensor_scaled_accel)                         \
    X(SENSOR_SCALED_GYRO, sensor_scaled_gyro)                           \
    X(SENSOR_DELTA_THETA, sensor_delta_theta)                           \
    X(SENSOR_DELTA_VELOCITY, sensor_delta_velocity)                     \
    X(SENSOR_GPS_TIMESTAMP, sensor_gps_timestamp)                       \
    X(FILTER_DATA_TIMESTAMP, filter_data_timestamp)                     \
    X(FILTER_DATA_ATTITUDE_QUATERNION, filter_data_attitude_quaternion) \
    X(FILTER_DATA_LLH_POSITION, filter_data_llh_position)               \
    X(FILTER_DATA_NED_VELOCITY, filter_data_ned_velocity)               \
    X(FILTER_DATA_LINEAR_ACCEL, filter_data_linear_accel)               \
    X(FILTER_DATA_COMP_ANGULAR_RATE, filter_data_comp_angular_rate)     \
    X(FILTER_DATA_STATUS, filter_data_status)

#define CASE(key, name, decode)                                        \
    case MIP_##key: {                                                  \
        struct mip_##name value;                                       \
        const bool good = mip_##name##decode(&value, field) == MIP_OK; \
        use(&value);                                                   \
        return good;                                                   \
    }
#define DIRECT(key, name) CASE(key, name, _decode_inline)
#define TABLE(key, name) CASE(key, name, _decode)

static bool direct(const struct mip_field *field) {
    switch (mip_field_key(field)) {
        FIELDS(DIRECT)
    default:
        return false;
    }
}

static bool table(const struct mip_field *field) {
    switch (mip_field_key(field)) {
        FIELDS(TABLE)
    default:
        return false;
    }
}

/** A few wanted fields. */
static bool three(const struct mip_field *field) {
    switch (mip_field_key(field)) {
        TABLE(SENSOR_SCALED_ACCEL, sensor_scaled_accel)
        TABLE(SENSOR_SCALED_GYRO, sensor_scaled_gyro)
        TABLE(FILTER_DATA_ATTITUDE_QUATERNION, filter_data_attitude_quaternion)
    default:
        return false;
    }
}

static bool three_direct(const struct mip_field *field) {
    switch (mip_field_key(field)) {
        DIRECT(SENSOR_SCALED_ACCEL, sensor_scaled_accel)
        DIRECT(SENSOR_SCALED_GYRO, sensor_scaled_gyro)
        DIRECT(FILTER_DATA_ATTITUDE_QUATERNION, filter_data_attitude_quaternion)
    default:
        return false;
    }
}

/** The layers above the parser, with handlers for the same fields. */
static size_t handled;

#define HANDLER(name)                                                                    \
    static void on_##name(void *user, const struct mip_field *field, uint32_t arrived) { \
        struct mip_##name value;                                                         \
        (void)user, (void)arrived;                                                       \
        handled += mip_##name##_decode(&value, field) == MIP_OK;                         \
        use(&value);                                                                     \
    }
HANDLER(sensor_scaled_accel)
HANDLER(sensor_scaled_gyro)
HANDLER(filter_data_attitude_quaternion)

static uint32_t port_now(void *user) {
    (void)user;
    return 0;
}

static bool port_write(void *user, const uint8_t *bytes, size_t size) {
    (void)user, (void)bytes, (void)size;
    return true;
}

static size_t through_device(const uint8_t *data, size_t size) {
    static const struct mip_port port = {NULL, port_write, port_now, NULL};
    static const struct mip_handler handlers[] = {
        {&mip_sensor_scaled_accel_codec, MIP_ANY_SET, on_sensor_scaled_accel, NULL},
        {&mip_sensor_scaled_gyro_codec, MIP_ANY_SET, on_sensor_scaled_gyro, NULL},
        {&mip_filter_data_attitude_quaternion_codec, MIP_ANY_SET, on_filter_data_attitude_quaternion, NULL},
    };
    static struct mip_device device;
    handled = 0;
    mip_device_init(&device, &port, MIP_ARRAY(handlers));
    for (size_t part; size > 0; data += part, size -= part) {
        part = size < SMALL ? size : SMALL;
        mip_device_step(&device, data, part);
    }
    return handled;
}

static size_t through_client(const uint8_t *data, size_t size) {
    static struct mip_client client;
    static struct mip_parser parser;
    size_t count = 0;
    mip_client_init(&client);
    mip_parser_init(&parser);
    while (size > 0) {
        size_t part = size < SMALL ? size : SMALL;
        struct mip_packet packet;
        size -= part;
        while (mip_client_step(&client, &parser, 0, &data, &part, &packet)) {
            struct mip_walk walk = mip_walk_packet(&packet);
            struct mip_field field;
            while (mip_walk_next(&walk, &field)) {
                count += three(&field);
            }
        }
    }
    return count;
}

#ifndef BOARD /* the registry needs all tables */
static bool registry(const struct mip_field *field) {
    static union {
        uint64_t aligned;
        uint8_t bytes[1024];
    } value;
    const struct mip_entry *entry = mip_registry_find(field);
    const bool good = entry != NULL && entry->codec->size <= sizeof(value) &&
                      mip_decode(entry->codec, &value, field, NULL) == MIP_OK;
    use(&value);
    return good;
}
#endif

/** Counts the packets, or the fields that could be decoded. */
static inline __attribute__((always_inline)) size_t parse(const uint8_t *data, size_t size, size_t chunk,
                                                          bool (*decode)(const struct mip_field *)) {
    struct mip_parser parser;
    size_t count = 0;
    mip_parser_init(&parser);
    while (size > 0) {
        size_t part = size < chunk ? size : chunk;
        struct mip_packet packet;
        size -= part;
        while (mip_parser_next(&parser, &data, &part, &packet)) {
            if (decode == NULL) {
                use(&packet);
                count++;
                continue;
            }
            struct mip_walk walk = mip_walk_packet(&packet);
            struct mip_field field;
            while (mip_walk_next(&walk, &field)) {
                count += decode(&field);
            }
        }
    }
    return count;
}

#define ENCODE(encode)                                                      \
    built += mip_sensor_scaled_accel##encode(&accel, &builder) == MIP_OK && \
             mip_sensor_scaled_gyro##encode(&gyro, &builder) == MIP_OK &&   \
             mip_shared_reference_timestamp##encode(&stamp, &builder) == MIP_OK

#define BUILD(encode)                                              \
    size_t built = 0;                                              \
    for (size_t at = 0; at + BUILT <= size; at += BUILT) {         \
        struct mip_sensor_scaled_accel accel;                      \
        struct mip_sensor_scaled_gyro gyro;                        \
        struct mip_shared_reference_timestamp stamp;               \
        uint8_t packet[MIP_MAX_PACKET];                            \
        struct mip_builder builder;                                \
        memcpy(&accel, data + at, 12);                             \
        memcpy(&gyro, data + at + 12, 12);                         \
        memcpy(&stamp, data + at + 24, 8);                         \
        mip_builder_start(&builder, packet, sizeof(packet), 0x80); \
        ENCODE(encode);                                            \
        built += mip_builder_finish(&builder).size - 1;            \
        use(packet);                                               \
    }                                                              \
    return built

FUNCTION(ours_parse) {
    return parse(data, size, CHUNK, NULL);
}
FUNCTION(ours_whole) {
    return parse(data, size, size, NULL);
}
FUNCTION(ours_small) {
    return parse(data, size, SMALL, NULL);
}
FUNCTION(ours_eight) {
    return parse(data, size, 8, NULL);
}
FUNCTION(ours_bytewise) {
    return parse(data, size, 1, NULL);
}
FUNCTION(ours_read) {
    uint8_t buffer[CHUNK];
    struct mip_parser parser;
    size_t count = 0;
    mip_parser_init(&parser);
    while (size > 0) {
        size_t part = size < CHUNK ? size : CHUNK;
        const uint8_t *bytes = buffer;
        struct mip_packet packet;
        memcpy(buffer, data, part); /* as reading a file would */
        use(buffer);
        data += part;
        size -= part;
        while (mip_parser_next(&parser, &bytes, &part, &packet)) {
            use(&packet);
            count++;
        }
    }
    return count;
}
FUNCTION(ours_direct) {
    return parse(data, size, CHUNK, direct);
}
FUNCTION(ours_table) {
    return parse(data, size, CHUNK, table);
}
FUNCTION(ours_three) {
    return parse(data, size, CHUNK, three);
}
FUNCTION(ours_small_three) {
    return parse(data, size, SMALL, three);
}
FUNCTION(ours_small_direct) {
    return parse(data, size, SMALL, three_direct);
}
FUNCTION(ours_device) {
    return through_device(data, size);
}
FUNCTION(ours_client) {
    return through_client(data, size);
}
#ifndef BOARD
FUNCTION(ours_registry) {
    return parse(data, size, CHUNK, registry);
}
#endif
FUNCTION(ours_build_direct) {
    BUILD(_encode_inline);
}
FUNCTION(ours_build_table) {
    BUILD(_encode);
}
static const struct row ROWS[] = {
    ROW(ours_parse),
    ROW(ours_whole),
    ROW(ours_small),
    ROW(ours_eight),
    ROW(ours_bytewise),
    ROW(ours_read),
    ROW(ours_direct),
    ROW(ours_table),
    ROW(ours_three),
    ROW(ours_small_three),
    ROW(ours_small_direct),
    ROW(ours_build_direct),
    ROW(ours_build_table),
    ROW(ours_device),
    ROW(ours_client),
#ifndef BOARD
    ROW(ours_registry),
#endif
};

int main(int arguments, char **given) {
    return run_rounds(ROWS, sizeof(ROWS) / sizeof(ROWS[0]), arguments, given);
}
