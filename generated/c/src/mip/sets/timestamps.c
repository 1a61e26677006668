/* The time of a packet. */
#include "mip/timestamps.h"

#define NO_CLOCK 0xFFU
/** Every part of a time is below this, so that the sum of two fits. */
#define MOST UINT64_C(4000000000000000000)
#define SECOND INT64_C(1000000000)
#define WEEK (INT64_C(604800) * SECOND)

struct part {
    uint8_t offset;
    uint8_t size;
    bool is_float;
    bool undated;   /* does it count in a time without a date? */
    uint64_t scale; /* nanoseconds of its unit */
};

struct reading {
    uint16_t readings; /* bit n: of mip_reading_of n */
    uint16_t flags;    /* that mark a time as valid */
    uint16_t others;   /* unknown devices read them so if none of these is set; 0: never */
};

struct source {
    uint8_t descriptor_set;
    uint8_t descriptor;
    uint8_t size;
    uint8_t clock;
    uint8_t other;    /* the clock of a time of week that is not valid as a date */
    uint8_t count_at; /* of the elements of an array before the time */
    uint8_t element;  /* the size of one, or 0 */
    uint8_t flags_at;
    uint8_t flags_size;
    uint8_t part_count;
    struct part parts[2];
    uint8_t reading_count;
    struct reading readings[2];
};

static const struct source sources[] = {
    /* shared.gps_timestamp */
    {0xFF,
     0xD3,
     12,
     MIP_CLOCK_GPS,
     MIP_CLOCK_DEVICE,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x3, 0}}},
    /* sensor.gps_timestamp */
    {0x80,
     0x12,
     12,
     MIP_CLOCK_GPS,
     MIP_CLOCK_DEVICE,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     2,
     {{0x4, 0x4, 0xFFF8}, {0xFFFF, 0x18, 0}}},
    /* filter_data.timestamp */
    {0x82,
     0x11,
     12,
     MIP_CLOCK_GPS,
     MIP_CLOCK_DEVICE,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x1, 0}}},
    /* gnss_data.gps_time */
    {0x81,
     0x09,
     12,
     MIP_CLOCK_GPS,
     NO_CLOCK,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x3, 0}}},
    /* gnss_data.gps_time */
    {0x91,
     0x09,
     12,
     MIP_CLOCK_GPS,
     NO_CLOCK,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x3, 0}}},
    /* gnss_data.gps_time */
    {0x92,
     0x09,
     12,
     MIP_CLOCK_GPS,
     NO_CLOCK,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x3, 0}}},
    /* gnss_data.gps_time */
    {0x94,
     0x09,
     12,
     MIP_CLOCK_GPS,
     NO_CLOCK,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x3, 0}}},
    /* gnss_data.gps_time */
    {0x95,
     0x09,
     12,
     MIP_CLOCK_GPS,
     NO_CLOCK,
     0,
     0,
     10,
     2,
     2,
     {{0, 8, true, true, 1000000000U}, {8, 2, false, false, 604800000000000U}},
     1,
     {{0xFFFF, 0x3, 0}}},
    /* shared.external_timestamp */
    {0xFF,
     0xD7,
     10,
     MIP_CLOCK_EXTERNAL,
     NO_CLOCK,
     0,
     0,
     8,
     2,
     1,
     {{0, 8, false, true, 1U}},
     1,
     {{0xFFFF, 0x1, 0}}},
    /* shared.reference_timestamp */
    {0xFF,
     0xD5,
     8,
     MIP_CLOCK_REFERENCE,
     NO_CLOCK,
     0,
     0,
     0,
     0,
     1,
     {{0, 8, false, true, 1U}},
     0,
     {{0, 0, 0}}},
};

static const char *const devices_2[] = {
    "3dm-cv5-10", "3dm-cv5-15",  "3dm-cv5-25",    "3dm-cx5-10",    "3dm-cx5-15",
    "3dm-cx5-25", "3dm-cx5-45",  "3dm-dh3",       "3dm-gq4-45",    "3dm-gx3-15",
    "3dm-gx3-25", "3dm-gx3-35",  "3dm-gx3-45",    "3dm-gx4-15",    "3dm-gx4-25",
    "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-15",    "3dm-gx5-25",    "3dm-gx5-35",
    "3dm-gx5-45", "3dm-mv5-ar",  "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu",
};

static bool is_listed(const char *device, const char *const *ids, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (strcmp(device, ids[i]) == 0) {
            return true;
        }
    }
    return false;
}

uint8_t mip_reading_of(const char *device) {
    if (device == NULL) {
        return MIP_READING_UNKNOWN;
    }
    if (is_listed(device, devices_2, 25)) {
        return 2;
    }
    return MIP_READING_USUAL;
}

uint8_t mip_reading_of_model(uint16_t model_number) {
    static const struct {
        uint16_t model;
        uint8_t reading;
    } models[] = {{6259, 2}, {6258, 2}, {6257, 2}, {6286, 1}, {6287, 1}, {6292, 1}, {6291, 1},
                  {6275, 2}, {6274, 2}, {6273, 2}, {6271, 2}, {6701, 1}, {6700, 1}, {6702, 1},
                  {6219, 2}, {6250, 2}, {6284, 1}, {6288, 1}, {6289, 1}, {6290, 1}, {6227, 2},
                  {6223, 2}, {6225, 2}, {6228, 2}, {6233, 2}, {6234, 2}, {6236, 2}, {6237, 2},
                  {6254, 2}, {6253, 2}, {6252, 2}, {6251, 2}, {6243, 2}, {6232, 2}, {6239, 2},
                  {6238, 2}, {6285, 1}, {6130, 1}, {6279, 2}, {6280, 2}, {6281, 2}, {6256, 2},
                  {6272, 2}, {6255, 2}};
    for (size_t i = 0; i < sizeof(models) / sizeof(models[0]); i++) {
        if (models[i].model == model_number) {
            return models[i].reading;
        }
    }
    return MIP_READING_UNKNOWN;
}

static uint64_t number(const uint8_t *bytes, size_t size) {
    uint64_t value = 0;
    for (size_t i = 0; i < size; i++) {
        value = value << 8 | bytes[i];
    }
    return value;
}

/** Divides by a power of two, rounded to nearest, halves to even. */
static uint64_t halved(uint64_t value, unsigned times) {
    if (times == 0 || times > 63) {
        return times == 0 ? value : 0;
    }
    const uint64_t half = UINT64_C(1) << (times - 1U);
    const uint64_t quotient = value >> times;
    const uint64_t rest = value & ((half << 1U) - 1U);
    return quotient + (rest > half || (rest == half && (quotient & 1U) != 0) ? 1U : 0U);
}

/** Multiplies the magnitude of an eight-byte double by a number, as a machine with doubles does,
 * and rounds the product. Returns MOST if the result is larger, or is no number. */
static uint64_t scaled(uint64_t bits, uint32_t scale) {
    const unsigned exponent = (unsigned)(bits >> 52U) & 0x7FFU;
    const uint64_t mantissa = (bits & UINT64_C(0xFFFFFFFFFFFFF)) | UINT64_C(0x10000000000000);
    const uint64_t low = (mantissa & 0xFFFFFFFFU) * scale;
    const uint64_t high = (mantissa >> 32U) * scale + (low >> 32U); /* the product is high, low */
    unsigned extra = 0; /* bits of the product beyond the 53 of a double */
    int power = (int)exponent - 1075;
    if (exponent == 0x7FFU) {
        return MOST;
    }
    if (exponent == 0) {
        return 0; /* less than any nanosecond */
    }
    while ((high >> (21U + extra)) > 0) {
        extra++;
    }
    const uint64_t kept =
        (extra > 0 ? high << (32U - extra) : high << 32U) | (low & 0xFFFFFFFFU) >> extra;
    const uint64_t rest = (low & 0xFFFFFFFFU) & ((UINT64_C(1) << extra) - 1U);
    const uint64_t half = extra > 0 ? UINT64_C(1) << (extra - 1U) : 0;
    const bool up = extra > 0 && (rest > half || (rest == half && (kept & 1U) != 0));
    const uint64_t product = kept + (up ? 1U : 0U);
    power += (int)extra;
    if (power < 0) {
        return halved(product, (unsigned)-power);
    }
    return power > 9 || product << power >= MOST ? MOST : product << power;
}

/** Adds a part of a time. Returns false if it is too large, or no number. */
static bool add(const struct part *part, const uint8_t *data, int64_t *time) {
    uint64_t bits = number(data + part->offset, part->size);
    uint64_t magnitude;
    bool negative = false;
    if (part->is_float) {
        bits = part->size == 4 ? mip_widen((uint32_t)bits) : bits;
        magnitude = scaled(bits, (uint32_t)part->scale);
        negative = bits >> 63U > 0;
    } else {
        magnitude = bits <= (MOST - 1U) / part->scale ? bits * part->scale : MOST;
    }
    if (magnitude >= MOST) {
        return false;
    }
    *time += negative ? -(int64_t)magnitude : (int64_t)magnitude;
    return true;
}

/** Adds the parts of a time, with or without its weeks. Returns false if one is too large, or no
 * number. */
static bool total(const struct source *source, const uint8_t *data, bool weeks, int64_t *time) {
    *time = 0;
    for (size_t i = 0; i < source->part_count; i++) {
        if ((weeks || source->parts[i].undated) && !add(&source->parts[i], data, time)) {
            return false;
        }
    }
    return true;
}

/** Do the flags mark the time as valid? */
static bool is_marked(const struct source *source, const uint8_t *data, uint8_t reading) {
    const uint64_t flags = number(data + source->flags_at, source->flags_size);
    for (size_t i = 0; i < source->reading_count; i++) {
        const struct reading *r = &source->readings[i];
        if ((reading < 16 && (r->readings >> reading & 1U) != 0) ||
            (reading == MIP_READING_UNKNOWN && r->others != 0 && (flags & r->others) == 0)) {
            return mip_has(flags, r->flags);
        }
    }
    return true;
}

/** Is the time counted in weeks? Then week 0 is no date, and a time of week that is in no week no
 * time. */
static bool has_weeks(const struct source *source) {
    for (size_t i = 0; i < source->part_count; i++) {
        if (!source->parts[i].undated) {
            return true;
        }
    }
    return false;
}

/** Reads a time of a clock. A field without one is absent if the clock is that of times without a
 * date. */
static enum mip_time_state time_of(const struct source *source, const struct mip_field *field,
                                   uint8_t reading, uint8_t clock, int64_t *time) {
    int64_t sum = 0;
    int64_t of_week = 0;
    const size_t array = (size_t)field->data[source->count_at] * source->element;
    const uint8_t *data = field->data + array;
    const bool is_whole = field->size >= source->size + array;
    const bool weeks = has_weeks(source);
    const bool has_time = is_whole && total(source, data, false, &of_week) &&
                          (!weeks || (of_week >= 0 && of_week <= WEEK));
    const bool dated = has_time && total(source, data, true, &sum) && (!weeks || sum > of_week) &&
                       is_marked(source, field->data, reading);
    if (clock == source->clock) {
        if (dated) {
            *time = mip_time_utc(clock, sum);
        }
        return dated ? MIP_TIME_VALID : MIP_TIME_NOT_VALID;
    }
    if (dated || !is_whole) {
        return MIP_TIME_ABSENT;
    }
    *time = of_week;
    return has_time ? MIP_TIME_VALID : MIP_TIME_NOT_VALID;
}

enum mip_time_state mip_time(const struct mip_packet *packet, uint8_t clock, uint8_t reading,
                             int64_t *time) {
    const size_t count = sizeof(sources) / sizeof(sources[0]);
    struct mip_walk walk = mip_walk_packet(packet);
    struct mip_field field;
    unsigned lowest = 0x100;
    uint32_t seen = 0; /* only the first field of a type counts */
    enum mip_time_state state = MIP_TIME_ABSENT;
    int64_t found = 0;
    while (packet->descriptor_set >= 0x80 && mip_walk_next(&walk, &field)) {
        for (size_t i = 0; i < count; i++) {
            const struct source *s = &sources[i];
            if (field.descriptor != s->descriptor ||
                !mip_set_has(field.descriptor_set, s->descriptor_set) || field.size < s->size ||
                (seen >> i & 1U) != 0) {
                continue;
            }
            seen |= UINT32_C(1) << i;
            if (field.descriptor < lowest &&
                (clock == s->clock || (s->other != NO_CLOCK && clock == s->other))) {
                const enum mip_time_state own = time_of(s, &field, reading, clock, &found);
                lowest = own == MIP_TIME_ABSENT ? lowest : field.descriptor;
                state = own == MIP_TIME_ABSENT ? state : own;
            }
        }
    }
    if (state == MIP_TIME_VALID) {
        *time = found;
    }
    return state;
}

int64_t mip_time_utc(uint8_t clock, int64_t time) {
    /* The days since 1970 of each clock's epoch, and those from which on clocks are ahead of UTC.
     */
    static const uint16_t epochs[] = {3657, 0, 0, 0};
    static const struct {
        uint16_t day;
        int16_t ahead; /* seconds */
    } leaps[] = {{4199, 1},   {4564, 2},   {4929, 3},   {5660, 4},   {6574, 5},   {7305, 6},
                 {7670, 7},   {8217, 8},   {8582, 9},   {8947, 10},  {9496, 11},  {10043, 12},
                 {10592, 13}, {13149, 14}, {14245, 15}, {15522, 16}, {16617, 17}, {17167, 18}};
    if (clock >= sizeof(epochs) / sizeof(epochs[0]) || epochs[clock] == 0) {
        return time;
    }
    const int64_t epoch = epochs[clock] * (INT64_C(86400) * SECOND);
    if (time > INT64_MAX - epoch) {
        return INT64_MAX;
    }
    time += epoch;
    for (size_t i = sizeof(leaps) / sizeof(leaps[0]); i > 0; i--) {
        if (time >= (leaps[i - 1].day * INT64_C(86400) + leaps[i - 1].ahead) * SECOND) {
            return time - leaps[i - 1].ahead * SECOND;
        }
    }
    return time;
}
