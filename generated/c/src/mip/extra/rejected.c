/* Finds the field for which a device has rejected a command. */
#include "mip/extra/rejected.h"

#define SHARED_SET 0xFFU
#define FIRST_DATA_SET 0x80U

/** A list of fields in a command. Offsets count from the beginning of its data; -1: there is none.
 */
struct listing {
    uint8_t descriptor_set;
    uint8_t descriptor;
    int16_t set;      /* of all fields */
    int16_t set_at;   /* else, where its number is */
    int16_t count_at; /* the number of entries; without it, there is one */
    int16_t first; /* the descriptor in the first entry; without it, the command names only a set */
    int16_t stride;
    int16_t most;          /* entries */
    int16_t decimation_at; /* in an entry: a u16 that must not be 0 */
    int16_t tag_at;
    int16_t tag; /* which the list requires there */
};

static const struct listing listings[] = {
    {0x0C, 0x01, 128, 0, 1, 2, 3, -1, -1, -1, 0},   {0x0C, 0x02, 129, 0, 1, 2, 3, 83, -1, -1, 0},
    {0x0C, 0x03, 130, 0, 1, 2, 3, -1, -1, -1, 0},   {0x0C, 0x06, 128, 0, -1, -1, 1, -1, -1, -1, 0},
    {0x0C, 0x07, 129, 0, -1, -1, 1, -1, -1, -1, 0}, {0x0C, 0x08, 128, 0, 1, 2, 3, -1, 1, -1, 0},
    {0x0C, 0x09, 129, 0, 1, 2, 3, 82, 1, -1, 0},    {0x0C, 0x0A, 130, 0, 1, 2, 3, -1, 1, -1, 0},
    {0x0C, 0x0B, 130, 0, -1, -1, 1, -1, -1, -1, 0}, {0x0C, 0x0D, -1, 0, 2, 3, 1, -1, -1, -1, 0},
    {0x0C, 0x0E, -1, 0, -1, -1, 1, -1, -1, -1, 0},  {0x0C, 0x0F, -1, 1, 2, 3, 3, -1, 1, -1, 0},
    {0x0C, 0x11, -1, 1, -1, -1, 1, -1, -1, -1, 0},  {0x0C, 0x2E, -1, 3, -1, 4, 1, -1, -1, 2, 2},
    {0x0C, 0x2F, -1, 4, 7, 8, 1, 12, -1, 3, 2},     {0x0C, 0x50, 128, 0, -1, 1, 1, -1, -1, -1, 0},
    {0x0C, 0x54, -1, 1, -1, 2, 1, -1, -1, -1, 0},
};

/** Commands, and those that do the same on devices that lack them. */
static const struct {
    uint8_t descriptor_set;
    uint8_t descriptor;
    uint8_t other_set;
    uint8_t other_descriptor;
} alternatives[] = {
    {0x01, 0x09, 0x0C, 0x40}, {0x0C, 0x01, 0x0C, 0x0D}, {0x0C, 0x02, 0x0C, 0x0D},
    {0x0C, 0x03, 0x0C, 0x0D}, {0x0C, 0x06, 0x0C, 0x0E}, {0x0C, 0x07, 0x0C, 0x0E},
    {0x0C, 0x08, 0x0C, 0x0F}, {0x0C, 0x09, 0x0C, 0x0F}, {0x0C, 0x0A, 0x0C, 0x0F},
    {0x0C, 0x0B, 0x0C, 0x0E}, {0x0C, 0x0D, 0x0C, 0x01}, {0x0C, 0x0D, 0x0C, 0x02},
    {0x0C, 0x0D, 0x0C, 0x03}, {0x0C, 0x0E, 0x0C, 0x06}, {0x0C, 0x0E, 0x0C, 0x07},
    {0x0C, 0x0E, 0x0C, 0x0B}, {0x0C, 0x0F, 0x0C, 0x08}, {0x0C, 0x0F, 0x0C, 0x09},
    {0x0C, 0x0F, 0x0C, 0x0A}, {0x0C, 0x40, 0x01, 0x09}, {0x0C, 0x50, 0x0C, 0x54},
    {0x0C, 0x54, 0x0C, 0x50},
};

/** The descriptors of data: a bit for each. */
static const struct {
    uint8_t descriptor_set;
    uint8_t bits[32];
} defined[] = {
    {0x80, {254, 255, 215, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0,
            0,   0,   0,   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {0x81, {248, 255, 63, 0, 5, 0, 3, 0, 0, 0, 0, 0, 30, 0, 26, 0,
            0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0,  0}},
    {0x82, {254, 255, 255, 31, 103, 23, 255, 0, 255, 3, 3, 0, 0, 0, 0, 0,
            0,   0,   0,   0,  0,   0,  0,   0, 0,   0, 0, 0, 0, 0, 0, 0}},
    {0x90, {22, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {0x91, {248, 255, 63, 0, 5, 0, 3, 0, 0, 0, 0, 0, 30, 0, 26, 0,
            0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0,  0}},
    {0x92, {248, 255, 63, 0, 5, 0, 3, 0, 0, 0, 0, 0, 30, 0, 26, 0,
            0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0,  0}},
    {0x93, {248, 255, 63, 0, 5, 0, 3, 0, 0, 0, 0, 0, 30, 0, 26, 0,
            0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0,  0}},
    {0x94, {248, 255, 63, 0, 5, 0, 3, 0, 0, 0, 0, 0, 30, 0, 26, 0,
            0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0,  0}},
    {0x95, {248, 255, 63, 0, 5, 0, 3, 0, 0, 0, 0, 0, 30, 0, 26, 0,
            0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0,  0}},
    {0xA0, {30, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {0xFF, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0,
            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 1, 0, 0, 0, 0}},
};

static unsigned byte_at(const struct mip_field *command, int at) {
    return at >= 0 && at < command->size ? command->data[at] : 0U;
}

/** Is the list in the command? */
static bool applies(const struct listing *list, const struct mip_field *command) {
    return list->descriptor_set == command->descriptor_set &&
           list->descriptor == command->descriptor &&
           (list->tag_at < 0 || byte_at(command, list->tag_at) == (unsigned)list->tag);
}

static unsigned set_of(const struct listing *list, const struct mip_field *command) {
    return list->set >= 0 ? (unsigned)list->set : byte_at(command, list->set_at);
}

/** Is another command for all sets, or for one that this command is about? */
static bool fits(uint8_t other_set, uint8_t other_descriptor, const struct mip_field *command) {
    const size_t count = sizeof(listings) / sizeof(listings[0]);
    bool about = true;
    for (size_t i = 0; i < count && about; i++) {
        const struct listing *other = &listings[i];
        if (other->descriptor_set == other_set && other->descriptor == other_descriptor &&
            other->set >= 0) {
            about = false;
            for (size_t k = 0; k < count && !about; k++) {
                about = applies(&listings[k], command) &&
                        set_of(&listings[k], command) == (unsigned)other->set;
            }
        }
    }
    return about;
}

static bool is_defined(uint8_t descriptor_set, uint8_t descriptor) {
    for (size_t i = 0; i < sizeof(defined) / sizeof(defined[0]); i++) {
        if ((defined[i].descriptor_set == descriptor_set ||
             defined[i].descriptor_set == SHARED_SET) &&
            (defined[i].bits[descriptor / 8] >> descriptor % 8 & 1) != 0) {
            return true;
        }
    }
    return false;
}

/** Does the device have this field, or with descriptor 0, any of the set? */
static enum mip_support sends(const struct mip_known_device *known, uint8_t descriptor_set,
                              uint8_t descriptor) {
    const struct mip_profile *profile = known->profile;
    for (size_t i = 0; i < known->descriptor_count; i++) {
        const unsigned set = known->descriptors[i] >> 8;
        const unsigned listed = known->descriptors[i] & 0xFFU;
        if (descriptor == 0
                ? set == descriptor_set
                : listed == descriptor && (set == descriptor_set || set == SHARED_SET)) {
            return MIP_SUPPORT_YES;
        }
    }
    if (known->descriptors != NULL) {
        return MIP_SUPPORT_NO;
    }
    if (profile == NULL) {
        return MIP_SUPPORT_UNKNOWN;
    }
    for (size_t i = 0; i < profile->field_count && descriptor == 0; i++) {
        if (profile->fields[i].descriptor_set == descriptor_set) {
            return MIP_SUPPORT_YES;
        }
    }
    return mip_profile_support(profile, descriptor_set, descriptor);
}

/** Does the device have a field, certainly or as is believed? */
static bool has(const struct mip_known_device *known, uint8_t descriptor_set, uint8_t descriptor) {
    const enum mip_support support = sends(known, descriptor_set, descriptor);
    return support != MIP_SUPPORT_NO && support != MIP_SUPPORT_UNKNOWN;
}

/** Does the reason hold for an item? */
static bool holds(uint8_t reason, const struct mip_rejected *item, unsigned decimation,
                  const struct mip_known_device *known) {
    const enum mip_support support = sends(known, item->descriptor_set, item->descriptor);
    switch (reason) {
    case MIP_REJECTION_ABSENT:
        return support == MIP_SUPPORT_NO;
    case MIP_REJECTION_DECIMATION:
        return decimation == 0;
    case MIP_REJECTION_TOO_MANY:
        return item->most != 0 && item->index >= item->most;
    case MIP_REJECTION_UNDEFINED:
        return support == MIP_SUPPORT_UNKNOWN && item->descriptor != 0 &&
               !is_defined(item->descriptor_set, item->descriptor);
    default:
        return support == MIP_SUPPORT_UNKNOWN && known->profile != NULL;
    }
}

/** Finds the first item of a list for which the reason holds. */
static bool find(const struct listing *list, const struct mip_field *command,
                 const struct mip_known_device *known, struct mip_rejected *item) {
    const unsigned set = set_of(list, command);
    const unsigned count = list->count_at >= 0 ? byte_at(command, list->count_at) : 1U;
    const bool listed = list->first >= 0 && count > 0;
    item->descriptor_set = (uint8_t)set;
    item->count = (uint8_t)count;
    item->most = (uint8_t)(list->most > 0 ? list->most : 0);
    for (unsigned i = 0; set >= FIRST_DATA_SET && i < (listed ? count : 1U); i++) {
        const int at = listed ? list->first + (int)i * list->stride : -1;
        const int by = at + list->decimation_at;
        const bool divided = listed && list->decimation_at >= 0;
        item->index = (uint8_t)i;
        item->descriptor = (uint8_t)byte_at(command, at);
        if (holds(item->reason, item,
                  divided ? byte_at(command, by) << 8 | byte_at(command, by + 1) : 1U, known)) {
            return true;
        }
    }
    return false;
}

struct mip_rejected mip_find_rejected(const struct mip_field *command,
                                      const struct mip_known_device *known) {
    const struct mip_rejected nothing = {MIP_REJECTION_UNKNOWN, 0, 0, 0, 0, 0};
    struct mip_rejected item = nothing;
    const bool lacking =
        sends(known, command->descriptor_set, command->descriptor) == MIP_SUPPORT_NO;
    for (size_t i = 0; lacking && i < sizeof(alternatives) / sizeof(alternatives[0]); i++) {
        const uint8_t set = alternatives[i].other_set;
        const uint8_t descriptor = alternatives[i].other_descriptor;
        if (alternatives[i].descriptor_set == command->descriptor_set &&
            alternatives[i].descriptor == command->descriptor && has(known, set, descriptor) &&
            fits(set, descriptor, command)) {
            item.reason = MIP_REJECTION_OTHER_COMMAND;
            item.descriptor_set = set;
            item.descriptor = descriptor;
            return item;
        }
    }
    for (item.reason = MIP_REJECTION_ABSENT; item.reason <= MIP_REJECTION_UNLISTED; item.reason++) {
        for (size_t i = 0; i < sizeof(listings) / sizeof(listings[0]); i++) {
            if (applies(&listings[i], command) && find(&listings[i], command, known, &item)) {
                return item;
            }
        }
    }
    return nothing;
}

/** Adds the command by which mip_device_stream writes which fields are sent. */
static mip_error add_format(struct mip_builder *packet, uint8_t descriptor_set, uint8_t count,
                            const struct mip_descriptor_rate *fields,
                            const struct mip_known_device *known) {
    const bool lacking = sends(known, 0x0C, 0x0F) == MIP_SUPPORT_NO;
    if (lacking && descriptor_set == 0x80 && has(known, 0x0C, 0x08)) {
        struct mip_3dm_imu_message_format older;
        mip_3dm_imu_message_format_write(&older, count, fields);
        return mip_3dm_imu_message_format_encode(&older, packet);
    }
    if (lacking && descriptor_set == 0x81 && has(known, 0x0C, 0x09)) {
        struct mip_3dm_gnss_message_format older;
        mip_3dm_gnss_message_format_write(&older, count, fields);
        return mip_3dm_gnss_message_format_encode(&older, packet);
    }
    if (lacking && descriptor_set == 0x82 && has(known, 0x0C, 0x0A)) {
        struct mip_3dm_filter_message_format older;
        mip_3dm_filter_message_format_write(&older, count, fields);
        return mip_3dm_filter_message_format_encode(&older, packet);
    }
    struct mip_3dm_message_format command;
    mip_3dm_message_format_write(&command, descriptor_set, count, fields);
    return mip_3dm_message_format_encode(&command, packet);
}

struct mip_rejected mip_stream_rejected(uint8_t descriptor_set, uint8_t count,
                                        const struct mip_rate *rates,
                                        const struct mip_known_device *known) {
    uint8_t bytes[MIP_MAX_PACKET];
    struct mip_builder packet;
    struct mip_field field = {NULL, 0, 0, 0}; /* of no command, if there are too many rates */
    struct mip_descriptor_rate fields[83];
    for (size_t i = 0; i < count && i < sizeof(fields) / sizeof(fields[0]); i++) {
        fields[i].descriptor = rates[i].descriptor;
        fields[i].decimation = 1;
    }
    if (mip_builder_start(&packet, bytes, sizeof(bytes), 0x0C) == MIP_OK &&
        add_format(&packet, descriptor_set, count, fields, known) == MIP_OK) {
        const struct mip_packet sent = mip_builder_finish(&packet);
        struct mip_walk walk = mip_walk_packet(&sent);
        (void)mip_walk_next(&walk, &field);
    }
    return mip_find_rejected(&field, known);
}
