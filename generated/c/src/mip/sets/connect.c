/* Finds a device and starts its data. */
#include "mip/connect.h"

/** The time-out of a ping in milliseconds. Two pings are sent at each rate, because bytes at
 * another rate may damage the first one. */
#define LISTEN 150
#define PINGS 2

static const uint32_t bauds[] = {115200, 3000000, 921600, 460800, 230400,
                                 57600,  38400,   19200,  9600,   4800};

/** Notes that a packet has arrived. */
static void hear(void *user, const struct mip_device *device, bool ends) {
    (void)device, (void)ends;
    *(bool *)user = true;
}

/** Pings at the current rate until any packet arrives; then sets `*heard`. Since any packet will
 * do, barriers do not precede the pings: at a low rate, the reply to a long one takes longer than
 * LISTEN. One precedes the command after them, if any reply may still arrive. */
static struct mip_result ping(struct mip_device *device, bool *heard) {
    const struct mip_observer listening = {hear, heard};
    const struct mip_observer *const observer = device->observer;
    struct mip_client *const client = &device->client;
    const uint32_t timeout = client->timeout;
    struct mip_retry retry = {PINGS, 1u << MIP_TIMED_OUT};
    struct mip_result result;
    if (client->behind != 0) {
        mip_client_miss(client); /* the next barrier differs from the one that was sent */
    }
    uint8_t missed = client->missed;
    mip_parser_init(&device->parser); /* bytes of another rate */
    device->observer = &listening;
    client->timeout = LISTEN;
    do {
        client->missed = 0;
        client->behind = 0;
        result = mip_call_base_ping(device);
        missed = client->missed > missed ? client->missed : missed;
    } while (!*heard && mip_again(&retry, result));
    client->missed = missed;
    device->observer = observer;
    client->timeout = timeout;
    return result;
}

/** Finds the baud rate. True if a device was heard. */
static bool find(struct mip_device *device, bool (*set_baud)(void *user, uint32_t baud),
                 struct mip_result *result) {
    bool heard = false;
    bool set = false;
    for (size_t i = 0; i < sizeof(bauds) / sizeof(bauds[0]) && set_baud != NULL; i++) {
        if (set_baud(device->port.user, bauds[i])) {
            set = true;
            *result = ping(device, &heard);
            if (heard || result->outcome != MIP_TIMED_OUT) {
                return heard;
            }
        }
    }
    if (!set) {
        *result = ping(device, &heard);
    }
    return heard;
}

/** One of several steps; `shared` is their common data. */
typedef struct mip_result step(struct mip_device *device, void *shared);

/** Runs steps until one fails. A step without a reply is repeated. */
static struct mip_result run(struct mip_device *device, step *const *steps, size_t count,
                             void *shared) {
    struct mip_result result = {MIP_ACKNOWLEDGED, 0, MIP_OK, false};
    for (size_t i = 0; i < count && mip_succeeded(result); i++) {
        struct mip_retry retry = MIP_RETRY;
        do {
            result = steps[i](device, shared);
        } while (mip_again(&retry, result));
    }
    return result;
}

static struct mip_result idle(struct mip_device *device, void *shared) {
    (void)shared;
    return mip_call_base_set_idle(device);
}

static struct mip_result identify(struct mip_device *device, void *shared) {
    return mip_call_base_get_device_info(device,
                                         (struct mip_base_get_device_info_response *)shared);
}

struct mip_result mip_device_connect(struct mip_device *device,
                                     bool (*set_baud)(void *user, uint32_t baud),
                                     struct mip_base_get_device_info_response *identity) {
    static step *const steps[] = {idle, identify};
    struct mip_result result;
    MIP_ASSERT(device->deferred == NULL); /* see mip_defer */
    return find(device, set_baud, &result)
               ? run(device, steps, sizeof(steps) / sizeof(steps[0]), identity)
               : result;
}

/** The settings of a stream. */
struct plan {
    uint8_t descriptor_set;
    uint8_t count;
    /* True if the device supports only the commands of older devices. */
    bool older;
    /* The index of the timestamp in `fields`; `count` if there is none. */
    uint8_t stamp_at;
    /* How many timestamps have been tried. */
    uint8_t tried;
    struct mip_rate *rates;
    struct mip_3dm_get_base_rate_response base;
    struct mip_descriptor_rate fields[83];
};

/** Reads the base rate with the older command for this set. */
static struct mip_result older_base_rate(struct mip_device *device, struct plan *plan,
                                         struct mip_result result) {
    switch (plan->descriptor_set) {
    case 0x80: {
        struct mip_3dm_get_imu_base_rate_response base;
        result = mip_call_3dm_get_imu_base_rate(device, &base);
        plan->base.rate = base.rate;
        break;
    }
    case 0x81: {
        struct mip_3dm_get_gnss_base_rate_response base;
        result = mip_call_3dm_get_gnss_base_rate(device, &base);
        plan->base.rate = base.rate;
        break;
    }
    case 0x82: {
        struct mip_3dm_get_filter_base_rate_response base;
        result = mip_call_3dm_get_filter_base_rate(device, &base);
        plan->base.rate = base.rate;
        break;
    }
    default:
        break;
    }
    return result;
}

static struct mip_result base_rate(struct mip_device *device, void *shared) {
    struct plan *plan = (struct plan *)shared;
    struct mip_result result =
        mip_call_3dm_get_base_rate(device, plan->descriptor_set, &plan->base);
    if (result.outcome == MIP_REFUSED) {
        const struct mip_exchange *const sent = device->sent;
        const struct mip_result older = older_base_rate(device, plan, result);
        plan->older = older.outcome != MIP_REFUSED; /* otherwise, it lacks this set */
        if (plan->older) {
            result = older;
        } else {
            device->sent = sent; /* the one that was rejected */
        }
    }
    return result;
}

/** Returns the decimation whose rate is nearest to `wanted`, which is not 0. */
static uint16_t decimation(float base, float wanted) {
    if (!(wanted < base)) {
        return 1;
    }
    if (!(wanted * UINT16_MAX > base)) {
        return UINT16_MAX;
    }
    const uint32_t below = (uint32_t)(base / wanted);
    const float faster = base / (float)below;
    const float slower = base / (float)(below + 1);
    return (uint16_t)(faster - wanted <= wanted - slower ? below : below + 1);
}

/** The timestamps to try, in this order: descriptor set, 0 for all, and descriptor. */
static const uint8_t timestamps[][2] = {
    {0, 0xD5},    {0, 0xD7},    {0x81, 0x09}, {0x91, 0x09}, {0x92, 0x09},
    {0x94, 0x09}, {0x95, 0x09}, {0x82, 0x11}, {0x80, 0x12}, {0, 0xD3},
};

/** Writes the next timestamp to try into the fields; after the last one, drops it. Returns false if
 * there is nothing else to try. */
static bool next_timestamp(struct plan *plan) {
    while (plan->stamp_at < plan->count &&
           plan->tried < sizeof(timestamps) / sizeof(timestamps[0])) {
        const uint8_t *const timestamp = timestamps[plan->tried++];
        if (timestamp[0] == 0 || timestamp[0] == plan->descriptor_set) {
            plan->fields[plan->stamp_at].descriptor = timestamp[1];
            return true;
        }
    }
    if (plan->stamp_at >= plan->count || plan->count == 1) { /* no fields would clear the format */
        return false;
    }
    plan->count--;
    for (size_t i = plan->stamp_at; i < plan->count; i++) {
        plan->fields[i] = plan->fields[i + 1];
    }
    plan->stamp_at = plan->count;
    return true;
}

/** Computes the decimations, and checks that the device supports all rates. Sends nothing. */
static struct mip_result divide(struct mip_device *device, void *shared) {
    struct plan *plan = (struct plan *)shared;
    struct mip_result result = {MIP_ACKNOWLEDGED, 0, MIP_OK, false};
    const uint16_t base = plan->base.rate;
    (void)device;
    plan->stamp_at = plan->count;
    for (uint8_t i = plan->count; i-- > 0;) {
        struct mip_rate *rate = &plan->rates[i];
        const bool fastest = rate->wanted <= 0 && rate->wanted >= 0;
        const uint16_t by = base == 0 || fastest ? 1 : decimation(base, rate->wanted);
        plan->fields[i].descriptor = rate->descriptor;
        plan->fields[i].decimation = by;
        plan->stamp_at = rate->descriptor == MIP_TIMESTAMP ? i : plan->stamp_at;
        rate->nearest = (float)base / (float)by;
        if (!mip_rate_fits(rate)) {
            result.outcome = MIP_NO_SUCH_RATE;
        }
    }
    (void)next_timestamp(plan);
    return result;
}

static struct mip_result write_format(struct mip_device *device, const struct plan *plan) {
    if (plan->older && plan->descriptor_set == 0x80) {
        return mip_call_3dm_imu_message_format_write(device, plan->count, plan->fields);
    }
    if (plan->older && plan->descriptor_set == 0x81) {
        return mip_call_3dm_gnss_message_format_write(device, plan->count, plan->fields);
    }
    if (plan->older && plan->descriptor_set == 0x82) {
        return mip_call_3dm_filter_message_format_write(device, plan->count, plan->fields);
    }
    return mip_call_3dm_message_format_write(device, plan->descriptor_set, plan->count,
                                             plan->fields);
}

static struct mip_result format(struct mip_device *device, void *shared) {
    struct plan *plan = (struct plan *)shared;
    struct mip_result result;
    do {
        result = write_format(device, plan);
    } while (result.outcome == MIP_REFUSED && next_timestamp(plan));
    return result;
}

static struct mip_result stream(struct mip_device *device, void *shared) {
    const struct plan *plan = (const struct plan *)shared;
    if (plan->older && plan->descriptor_set == 0x80) {
        return mip_call_3dm_data_stream_control_write(device, 1, true);
    }
    if (plan->older && plan->descriptor_set == 0x81) {
        return mip_call_3dm_data_stream_control_write(device, 2, true);
    }
    if (plan->older && plan->descriptor_set == 0x82) {
        return mip_call_3dm_data_stream_control_write(device, 3, true);
    }
    return mip_call_3dm_data_stream_control_write(device, plan->descriptor_set, true);
}

static struct mip_result resume(struct mip_device *device, void *shared) {
    (void)shared;
    return mip_call_base_resume(device);
}

struct mip_result mip_device_stream(struct mip_device *device, uint8_t descriptor_set,
                                    uint8_t count, struct mip_rate *rates) {
    static step *const steps[] = {base_rate, divide, format, stream, resume};
    struct plan plan;
    MIP_ASSERT(device->deferred == NULL); /* see mip_defer */
    if (count > sizeof(plan.fields) / sizeof(plan.fields[0])) {
        const struct mip_result result = {MIP_NOT_SENT, 0, MIP_ERROR_COUNT, false};
        return result;
    }
    plan.descriptor_set = descriptor_set;
    plan.count = count;
    plan.older = false;
    plan.tried = 0;
    plan.rates = rates;
    return run(device, steps, sizeof(steps) / sizeof(steps[0]), &plan);
}
