/**
 * @file
 * What a device supports, and how it differs from others. mip/profiles.h names the devices.
 */
#ifndef MIP_PROFILE_H
#define MIP_PROFILE_H

#include "mip/export.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A command or a data field that a device supports. */
struct mip_profile_field {
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** Letters of the function selectors that the device takes: "WRSLD"; empty without selectors.
     */
    const char *functions;
    /** Why the device is believed to support it; NULL if that is certain. */
    const char *evidence;
};

/** How often a device samples the fields of a data set. */
struct mip_profile_rate {
    /** The data set. */
    uint8_t descriptor_set;
    /** In Hz; 0: sent as the data arise. */
    double rate;
};

/** A port of a device. */
struct mip_profile_port {
    /** What the manual calls it. */
    const char *name;
    /** The number that commands use; 0 if there is none. */
    uint8_t id;
    /** Elements of `baud_rates`. */
    uint8_t baud_rate_count;
    /** The baud rates that it can have; NULL if it has none. */
    const uint32_t *baud_rates;
    /** "MIP, NMEA" */
    const char *protocols;
};

/** A limit of a device: a number, and what it limits. */
struct mip_profile_limit {
    /** A word for it. */
    const char *name;
    /** The limit itself. */
    double value;
    /** Empty if it has none. */
    const char *unit;
    /** What it limits. */
    const char *description;
};

/** A note in words, with a table if it has rows. */
struct mip_profile_note {
    /** A word for it. */
    const char *name;
    /** Its heading. */
    const char *title;
    /** Its text. */
    const char *description;
    /** Row by row, the heading first. */
    const char *const *cells;
    /** Rows of the table, the heading counted; 0: there is none. */
    uint8_t rows;
    /** Columns of the table. */
    uint8_t columns;
};

/** The device's own type for a parameter. */
struct mip_profile_reading {
    /** "filter_data.status.status_flags" */
    const char *of;
    /** Name of an enumeration or a bitfield: "filter_data.gx5_status_flags". */
    const char *type;
};

/** What is known of a device. */
struct mip_profile {
    /** A word for it: "3dm-gx5-15". */
    const char *id;
    /** What the maker calls it: "3DM-GX5-15". */
    const char *title;
    /** The manual that describes it, as the specification calls it; empty if none is known. */
    const char *manual;
    /** What it is. */
    const char *description;
    /** The beginning of its model and serial numbers; 0 if it is not known. */
    uint16_t model_number;
    /** "5" of 5-series devices; 0 if it is not known. */
    uint8_t generation;
    /** Elements of `also`. */
    uint8_t also_count;
    /** Elements of `incomplete`. */
    uint8_t incomplete_count;
    /** Elements of `fields`. */
    uint16_t field_count;
    /** Elements of `rates`. */
    uint8_t rate_count;
    /** Elements of `ports`. */
    uint8_t port_count;
    /** Elements of `limits`. */
    uint8_t limit_count;
    /** Elements of `notes`. */
    uint8_t note_count;
    /** Elements of `readings`. */
    uint8_t reading_count;
    /** Elements of `ack_codes`. */
    uint8_t ack_code_count;
    /** What others call it. */
    const char *const *also;
    /** What is not known of it, in sentences. If there is any, it may have more than is listed. */
    const char *const *incomplete;
    /** What it supports, by descriptor set and descriptor. */
    const struct mip_profile_field *fields;
    /** How often it samples each data set. */
    const struct mip_profile_rate *rates;
    /** Its ports. */
    const struct mip_profile_port *ports;
    /** Its limits. */
    const struct mip_profile_limit *limits;
    /** What else the manual says of it. */
    const struct mip_profile_note *notes;
    /** The types that it has of its own. */
    const struct mip_profile_reading *readings;
    /** The acknowledge codes that it sends. */
    const uint8_t *ack_codes;
};

/** All devices. */
extern MIP_API const struct mip_profile *const mip_profiles[];
/** The number of devices. */
extern MIP_API const size_t mip_profile_count;

/** A device by its id ("3dm-gx5-15"), its title or another name; NULL if it is unknown. */
MIP_API const struct mip_profile *mip_profile_find(const char *name);

/** A device by its model number; NULL if it is unknown, as newer ones are. */
MIP_API const struct mip_profile *mip_profile_by_model(uint16_t model_number);

/**
 * The model number that the device information gives: its model and serial numbers begin with it.
 * Spaces may come before it, and a dot, a dash, a space, a NUL or the end of the text behind it. 0
 * if it is not there.
 */
MIP_API uint16_t mip_model_number(const char *text, size_t size);

/** Does the device support a command or a data field? NULL if it is not known to. */
MIP_API const struct mip_profile_field *mip_profile_supports(const struct mip_profile *profile,
                                                             uint8_t descriptor_set,
                                                             uint8_t descriptor);

/** The same, though it may not be certain: `evidence` says why it is believed. */
MIP_API const struct mip_profile_field *mip_profile_may_support(const struct mip_profile *profile,
                                                                uint8_t descriptor_set,
                                                                uint8_t descriptor);

/** The base rate of a data set in Hz: 0 if data are sent as they come, negative if it has none. */
MIP_API double mip_profile_base_rate(const struct mip_profile *profile, uint8_t descriptor_set);

/** The name of the device's own type for a parameter; NULL if it has none. */
MIP_API const char *mip_profile_reading_of(const struct mip_profile *profile, const char *of);

#ifdef __cplusplus
}
#endif

#endif
