/* speed FILE FUNCTION ROUNDS: as ../speed.c, with the vendor's SDK as its documentation and its examples use it: a
 * parser that calls back for each packet, extractors, and the dispatcher for a few wanted fields. */
#include "mip/definitions/data_filter.h"
#include "mip/definitions/data_sensor.h"
#include "mip/mip_dispatch.h"
#include "mip/mip_field.h"
#include "mip/mip_interface.h"
#include "mip/mip_parser.h"
#include "rounds.h"

static size_t count;

static bool on_packet(void *user, const mip_packet_view *packet, mip_timestamp time) {
    (void)user, (void)time;
    use(packet);
    count++;
    return true;
}

#define CASE(descriptor, name)                                                 \
    case MIP_DATA_DESC_##descriptor: {                                         \
        mip_##name##_data value;                                               \
        const bool good = extract_mip_##name##_data_from_field(field, &value); \
        use(&value);                                                           \
        return good;                                                           \
    }

static bool sensor(const mip_field_view *field) {
    switch (mip_field_field_descriptor(field)) {
        CASE(SENSOR_ACCEL_SCALED, sensor_scaled_accel)
        CASE(SENSOR_GYRO_SCALED, sensor_scaled_gyro)
        CASE(SENSOR_DELTA_THETA, sensor_delta_theta)
        CASE(SENSOR_DELTA_VELOCITY, sensor_delta_velocity)
        CASE(SENSOR_TIME_STAMP_GPS, sensor_gps_timestamp)
    default:
        return false;
    }
}

static bool filter(const mip_field_view *field) {
    switch (mip_field_field_descriptor(field)) {
        CASE(FILTER_FILTER_TIMESTAMP, filter_timestamp)
        CASE(FILTER_ATT_QUATERNION, filter_attitude_quaternion)
        CASE(FILTER_POS_LLH, filter_position_llh)
        CASE(FILTER_VEL_NED, filter_velocity_ned)
        CASE(FILTER_LINEAR_ACCELERATION, filter_linear_accel)
        CASE(FILTER_COMPENSATED_ANGULAR_RATE, filter_comp_angular_rate)
        CASE(FILTER_FILTER_STATUS, filter_status)
    default:
        return false;
    }
}

static bool on_all(void *user, const mip_packet_view *packet, mip_timestamp time) {
    (void)user, (void)time;
    const uint8_t set = mip_packet_descriptor_set(packet);
    mip_field_view field;
    mip_field_init_empty(&field);
    while (mip_field_next_in_packet(&field, packet)) {
        count += set == MIP_SENSOR_DATA_DESC_SET ? sensor(&field) : set == MIP_FILTER_DATA_DESC_SET && filter(&field);
    }
    return true;
}

static mip_dispatcher dispatcher;

static bool on_three(void *user, const mip_packet_view *packet, mip_timestamp time) {
    (void)user;
    mip_dispatcher_dispatch_packet(&dispatcher, packet, time);
    return true;
}

#define EXTRACTOR(name)                                                       \
    static mip_##name##_data name;                                            \
    static bool take_##name(const mip_field_view *field, void *value) {       \
        const bool good = extract_mip_##name##_data_from_field(field, value); \
        count += good;                                                        \
        use(value);                                                           \
        return good;                                                          \
    }
EXTRACTOR(sensor_scaled_accel)
EXTRACTOR(sensor_scaled_gyro)
EXTRACTOR(filter_attitude_quaternion)

static size_t parse(const uint8_t *data, size_t size, size_t chunk, mip_packet_callback callback) {
    mip_parser parser;
    count = 0;
    mip_parser_init(&parser, callback, NULL, 100000);
    while (size > 0) {
        const size_t part = size < chunk ? size : chunk;
        mip_parser_parse(&parser, data, part, 0);
        data += part;
        size -= part;
    }
    return count;
}

FUNCTION(peer_parse) {
    return parse(data, size, 4096, on_packet);
}
FUNCTION(peer_small) {
    return parse(data, size, 64, on_packet);
}
FUNCTION(peer_all) {
    return parse(data, size, 4096, on_all);
}
FUNCTION(peer_eight) {
    return parse(data, size, 8, on_packet);
}
FUNCTION(peer_bytewise) {
    return parse(data, size, 1, on_packet);
}
static size_t dispatched(const uint8_t *data, size_t size, size_t chunk) {
    static mip_dispatch_handler handlers[3];
    mip_dispatcher_init(&dispatcher);
    mip_dispatch_handler_init_extractor(&handlers[0], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_ACCEL_SCALED,
                                        take_sensor_scaled_accel, &sensor_scaled_accel);
    mip_dispatch_handler_init_extractor(&handlers[1], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_GYRO_SCALED,
                                        take_sensor_scaled_gyro, &sensor_scaled_gyro);
    mip_dispatch_handler_init_extractor(&handlers[2], MIP_FILTER_DATA_DESC_SET, MIP_DATA_DESC_FILTER_ATT_QUATERNION,
                                        take_filter_attitude_quaternion, &filter_attitude_quaternion);
    for (int i = 0; i < 3; i++) {
        mip_dispatcher_add_handler(&dispatcher, &handlers[i]);
    }
    return parse(data, size, chunk, on_three);
}
FUNCTION(peer_three) {
    return dispatched(data, size, 4096);
}
FUNCTION(peer_small_three) {
    return dispatched(data, size, 64);
}
FUNCTION(peer_device) {
    static mip_dispatch_handler handlers[3];
    static mip_interface device;
    count = 0;
    mip_interface_init(&device, 100, 1000, NULL, NULL, mip_interface_default_update, NULL);
    mip_interface_register_extractor(&device, &handlers[0], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_ACCEL_SCALED,
                                     take_sensor_scaled_accel, &sensor_scaled_accel);
    mip_interface_register_extractor(&device, &handlers[1], MIP_SENSOR_DATA_DESC_SET, MIP_DATA_DESC_SENSOR_GYRO_SCALED,
                                     take_sensor_scaled_gyro, &sensor_scaled_gyro);
    mip_interface_register_extractor(&device, &handlers[2], MIP_FILTER_DATA_DESC_SET, MIP_DATA_DESC_FILTER_ATT_QUATERNION,
                                     take_filter_attitude_quaternion, &filter_attitude_quaternion);
    for (size_t part; size > 0; data += part, size -= part) {
        part = size < 64 ? size : 64;
        mip_interface_input_bytes_from_device(&device, data, part, 0);
    }
    return count;
}

static const struct row ROWS[] = {ROW(peer_parse), ROW(peer_small), ROW(peer_all), ROW(peer_three),
                                  ROW(peer_eight), ROW(peer_bytewise), ROW(peer_small_three), ROW(peer_device)};

int main(int arguments, char **given) {
    return run_rounds(ROWS, sizeof(ROWS) / sizeof(ROWS[0]), arguments, given);
}
