/**
 * @file
 * The fields that a device supports, and its differences from other devices. mip/profiles.h names
 * the devices.
 */
#ifndef MIP_PROFILE_H
#define MIP_PROFILE_H

#include "mip/export.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Does a device have a command or a data field? */
enum mip_support {
    /** No source mentions it, and the profile is incomplete. */
    MIP_SUPPORT_UNKNOWN = 0,
    /** It does not. */
    MIP_SUPPORT_NO = 1,
    /** It probably does. */
    MIP_SUPPORT_PROBABLE = 2,
    /** It does. */
    MIP_SUPPORT_YES = 3
};

/** Why a device is believed to have some fields, or not to have them. */
struct mip_profile_evidence {
    /** Its answer: an `enum mip_support`. */
    uint8_t answer;
    /** Why, in words. */
    const char *why;
};

/** A command or a data field that a device certainly or probably has, or that it lacks. */
struct mip_profile_field {
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** Letters of the function selectors that the device accepts: "WRSLD"; empty without selectors.
     */
    const char *functions;
    /** The certainty of this, and the reasons; never NULL. */
    const struct mip_profile_evidence *evidence;
};

/** The firmware that a command or a data field requires. */
struct mip_profile_firmware {
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** The versions that have it: "> 1.0.07" or ">= 1.0, < 1.1". */
    const char *versions;
};

/** The rate at which a device samples the fields of a data set. */
struct mip_profile_rate {
    /** The data set. */
    uint8_t descriptor_set;
    /** In Hz; 0: sent as the data arrives. */
    double rate;
};

/** A port of a device. */
struct mip_profile_port {
    /** Its name in the manual. */
    const char *name;
    /** The number that commands use; 0 if there is none. */
    uint8_t id;
    /** Elements of `baud_rates`. */
    uint8_t baud_rate_count;
    /** The baud rates that it can have; NULL if it has none. */
    const uint32_t *baud_rates;
    /** The protocols that it receives: "MIP, NMEA". */
    const char *receives;
    /** The protocols that it sends. */
    const char *sends;
};

/** A limit of a device: a number, and the limited quantity. */
struct mip_profile_limit {
    /** Its name. */
    const char *name;
    /** The limit itself. */
    double value;
    /** Empty if it has none. */
    const char *unit;
    /** The limited quantity. */
    const char *description;
    /** The firmware versions that have it: ">= 1.0.04"; empty if all have. */
    const char *firmware;
};

/** A note in words, with a table if it has rows. */
struct mip_profile_note {
    /** Its name. */
    const char *name;
    /** Its heading. */
    const char *title;
    /** Its text. */
    const char *description;
    /** Row by row, the heading first. */
    const char *const *cells;
    /** Rows of the table, including the heading; 0: there is none. */
    uint8_t rows;
    /** Columns of the table. */
    uint8_t columns;
};

/** The type that is specific to the device for a parameter. */
struct mip_profile_reading {
    /** "filter_data.status.status_flags" */
    const char *of;
    /** Name of an enumeration or a bitfield: "filter_data.gx5_status_flags". */
    const char *type;
};

/** A device profile. */
struct mip_profile {
    /** Its id: "3dm-gx5-15". */
    const char *id;
    /** Its name by the manufacturer: "3DM-GX5-15". */
    const char *title;
    /** The id in the specification of the manual that describes it; empty if none is known. */
    const char *manual;
    /** Its description. */
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
    /** Elements of `refuses`. */
    uint16_t refused_count;
    /** Elements of `firmware`. */
    uint8_t firmware_count;
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
    /** Other names. */
    const char *const *also;
    /** Statements on what is unknown about it. If there are any, it may have more than is
     * listed. */
    const char *const *incomplete;
    /** The fields that it certainly or probably has, by descriptor set and descriptor. */
    const struct mip_profile_field *fields;
    /** The fields that it is known not to have. */
    const struct mip_profile_field *refuses;
    /** The firmware that some of these fields require. */
    const struct mip_profile_firmware *firmware;
    /** The rates at which it samples data sets. */
    const struct mip_profile_rate *rates;
    /** Its ports. */
    const struct mip_profile_port *ports;
    /** Its limits. */
    const struct mip_profile_limit *limits;
    /** Other statements of the manual about it. */
    const struct mip_profile_note *notes;
    /** The types that are specific to it. */
    const struct mip_profile_reading *readings;
    /** The acknowledge codes that it sends. */
    const uint8_t *ack_codes;
};

/** All devices. */
extern MIP_API const struct mip_profile *const mip_profiles[];
/** The number of devices. */
extern MIP_API const size_t mip_profile_count;

/** A device by its id ("3dm-gx5-15"), its title or another name, as the device information has it:
 * spaces around it do not matter. NULL if it is unknown. */
MIP_API const struct mip_profile *mip_profile_find(const char *name);

/** A device by its model number; NULL if it is unknown, for example that of a newer device. */
MIP_API const struct mip_profile *mip_profile_by_model(uint16_t model_number);

/**
 * The model number in the device information: its model and serial numbers begin with it.
 * Spaces may precede it, and a dot, a dash, a space, a NUL or the end of the text follows it. 0 if
 * there is none.
 */
MIP_API uint16_t mip_model_number(const char *text, size_t size);

/** Does the device have a command or a data field? A field that a complete profile does not list is
 * MIP_SUPPORT_NO. A shared field counts in every data set. */
MIP_API enum mip_support mip_profile_support(const struct mip_profile *profile,
                                             uint8_t descriptor_set, uint8_t descriptor);

/** The entry of a command or a data field in the profile: its `evidence` states how certain it is,
 * and why. NULL if there is none. */
MIP_API const struct mip_profile_field *mip_profile_find_field(const struct mip_profile *profile,
                                                               uint8_t descriptor_set,
                                                               uint8_t descriptor);

/** The firmware versions that have a command or a data field: "> 1.0.07". NULL if all have it, or
 * if it is not known. */
MIP_API const char *mip_profile_firmware_of(const struct mip_profile *profile,
                                            uint8_t descriptor_set, uint8_t descriptor);

/** The base rate of a data set in Hz: 0 if data is sent as it arrives, negative if it has none. */
MIP_API double mip_profile_base_rate(const struct mip_profile *profile, uint8_t descriptor_set);

/** The name of the type that is specific to the device for a parameter; NULL if it has none. */
MIP_API const char *mip_profile_reading_of(const struct mip_profile *profile, const char *of);

#ifdef __cplusplus
}
#endif

#endif
