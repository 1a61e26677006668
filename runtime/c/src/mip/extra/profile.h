/**
 * @file
 * The fields that a device supports, and its differences from other devices. mip/extra/profiles.h
 * lists the devices.
 */
#ifndef MIP_PROFILE_H
#define MIP_PROFILE_H

#include "mip/core/export.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Does a device support a command or a data field? */
enum mip_support {
    /** No source mentions it, and the profile is incomplete. */
    MIP_SUPPORT_UNKNOWN = 0,
    /** It does not. */
    MIP_SUPPORT_NO = 1,
    /** Its family or a nearly identical device has it. */
    MIP_SUPPORT_ASSUMED = 2,
    /** An example, a program or a list of others names this very model. */
    MIP_SUPPORT_LIKELY = 3,
    /** It does. */
    MIP_SUPPORT_YES = 4
};

/** Why a device is believed to have some fields, or not to have them. */
struct mip_profile_evidence {
    /** Whether the device supports them: an `enum mip_support`. */
    uint8_t answer;
    /** The reason for the answer. */
    const char *why;
    /** What the device lacks: "has no magnetometer"; empty if no hardware is concerned. */
    const char *absence;
};

/** A command or a data field that a device supports, probably supports, or does not support. */
struct mip_profile_field {
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** Letters of the function selectors that the device accepts: "WRSLD"; empty without selectors.
     */
    const char *functions;
    /** Whether the device supports it, and why that is believed; never NULL. */
    const struct mip_profile_evidence *evidence;
};

/** The firmware that a command or a data field requires. */
struct mip_profile_firmware {
    /** Descriptor set of the field. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** The versions that support it: "> 1.0.07" or ">= 1.0, < 1.1". */
    const char *versions;
};

/** The rate at which a device samples the fields of a data set. */
struct mip_profile_rate {
    /** The data set. */
    uint8_t descriptor_set;
    /** In Hz; 0: sent as the data arrives. */
    double rate;
};

/** A parameter whose type is specific to the device. */
struct mip_profile_reading {
    /** The parameter: "filter_data.status.status_flags". */
    const char *of;
    /** Name of an enumeration or a bitfield: "filter_data.gx5_status_flags". */
    const char *type;
};

/** A device profile. */
struct mip_profile {
    /** Its id: "3dm-gx5-15". */
    const char *id;
    /** The manufacturer's name: "3DM-GX5-15". */
    const char *title;
    /** The specification's id of the manual that describes it; empty if none is known. */
    const char *manual;
    /** Its description. */
    const char *description;
    /** Its model number, with which its serial numbers begin, too; 0 if it is not known. */
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
    /** Elements of `absent_sets`. */
    uint8_t absent_count;
    /** Elements of `firmware`. */
    uint8_t firmware_count;
    /** Elements of `rates`. */
    uint8_t rate_count;
    /** Elements of `readings`. */
    uint8_t reading_count;
    /** Other names. */
    const char *const *also;
    /** Statements on what is unknown about it. If there are any, it may support more than is
     * listed. */
    const char *const *incomplete;
    /** The fields that it supports, or is believed to support, by descriptor set and descriptor. */
    const struct mip_profile_field *fields;
    /** The fields that it is known not to support. */
    const struct mip_profile_field *refuses;
    /** The data sets of which it has no field for lack of hardware; their `descriptor` is 0. */
    const struct mip_profile_field *absent_sets;
    /** The firmware that some of these fields require. */
    const struct mip_profile_firmware *firmware;
    /** The rates at which it samples data sets. */
    const struct mip_profile_rate *rates;
    /** The parameters whose types are specific to it. */
    const struct mip_profile_reading *readings;
};

/** All devices. */
extern MIP_API const struct mip_profile *const mip_profiles[];
/** The number of devices. */
extern MIP_API const size_t mip_profile_count;

/** Finds a device by its id ("3dm-gx5-15"), title or another name, for example from the device
 * information; spaces around it do not matter. Returns NULL if it is unknown. */
MIP_API const struct mip_profile *mip_profile_find(const char *name);

/** Finds a device by its model number; returns NULL if it is unknown, for example of a newer
 * device. */
MIP_API const struct mip_profile *mip_profile_by_model(uint16_t model_number);

/**
 * Returns the number with which a model or serial number of the device information begins; 0 if
 * there is none. Spaces may precede it; a dot, dash, space, NUL or the end of the text must follow
 * it.
 */
MIP_API uint16_t mip_model_number(const char *text, size_t size);

/** Returns whether the device supports a command or a data field. For a field that a complete
 * profile does not list, this is MIP_SUPPORT_NO. A shared field belongs to every data set. */
MIP_API enum mip_support mip_profile_support(const struct mip_profile *profile,
                                             uint8_t descriptor_set, uint8_t descriptor);

/** Finds the profile's entry for a command or a data field, with its `evidence`; returns NULL if
 * there is none. */
MIP_API const struct mip_profile_field *mip_profile_find_field(const struct mip_profile *profile,
                                                               uint8_t descriptor_set,
                                                               uint8_t descriptor);

/** Returns the firmware versions that support a command or a data field: "> 1.0.07"; NULL if all
 * do, or if that is unknown. */
MIP_API const char *mip_profile_firmware_of(const struct mip_profile *profile,
                                            uint8_t descriptor_set, uint8_t descriptor);

/** Returns the base rate of a data set in Hz: 0 if data is sent as it arrives, negative if there is
 * none. */
MIP_API double mip_profile_base_rate(const struct mip_profile *profile, uint8_t descriptor_set);

/** Returns the name of a parameter's type on this device, if it is specific to it; else NULL. */
MIP_API const char *mip_profile_reading_of(const struct mip_profile *profile, const char *of);

#ifdef __cplusplus
}
#endif

#endif
