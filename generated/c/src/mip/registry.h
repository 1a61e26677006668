/**
 * @file
 * Finds the type of any field by its descriptor or its name. It links all types of all sets, so
 * small programs should not use it.
 */
#ifndef MIP_REGISTRY_H
#define MIP_REGISTRY_H

#include "mip/client.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A field as a descriptor set defines or repeats it. */
struct mip_entry {
    /** Descriptor set: 0 for fields of all command sets, 0xFF for those of all data sets. */
    uint8_t descriptor_set;
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** MIP_COMMAND, MIP_RESPONSE or MIP_DATA. */
    uint8_t role;
    /** Entries that mip_registry_link gives. */
    uint8_t link_count;
    /** Where they are in mip_registry_links. */
    uint16_t first_link;
    /** Name in the specification: "3dm.pps_source_control". */
    const char *name;
    /** Its wire format. */
    const struct mip_codec *codec;
    /** NULL if it is not a command. */
    const struct mip_command *command;
};

/** All fields, by descriptor set and descriptor. */
extern MIP_API const struct mip_entry mip_registry[];
/** The number of all fields. */
extern MIP_API const size_t mip_registry_size;
/** For mip_registry_link: indexes of entries. */
extern MIP_API const uint16_t mip_registry_links[];

/** The layouts of a descriptor in packets of a set: the first one, and how many. */
MIP_API const struct mip_entry *mip_registry_candidates(uint8_t descriptor_set, uint8_t descriptor,
                                                        size_t *count);

/** The layout of a field; NULL if it is unknown, or if the data has none of the known layouts.
 */
MIP_API const struct mip_entry *mip_registry_find(const struct mip_field *field);

/** A field by its name; NULL if there is none. */
MIP_API const struct mip_entry *mip_registry_by_name(const char *name);

/** The responses of a command, or the commands of a response, from 0; NULL after the last one. */
MIP_API const struct mip_entry *mip_registry_link(const struct mip_entry *entry, size_t number);

#ifdef __cplusplus
}
#endif

#endif
