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

/** A type of field, which may occur in several descriptor sets. */
struct mip_entry {
    /** Descriptor of the field. */
    uint8_t descriptor;
    /** MIP_COMMAND, MIP_RESPONSE or MIP_DATA. */
    uint8_t role;
    /** The number of entries that mip_registry_link returns. */
    uint8_t link_count;
    /** The index of the first of them in mip_registry_links. */
    uint16_t first_link;
    /** Name in the specification, without the set's: "pps_source_control". */
    const char *name;
    /** Its wire format; mip_codec_belongs checks whether it occurs in a set. */
    const struct mip_codec *codec;
    /** The command; NULL if it is not one. */
    const struct mip_command *command;
};

/** A descriptor set. Several sets may share the same entries, which need not occur in all of them.
 */
struct mip_set {
    /** Its number; 0 for all command sets, 0xFF for all data sets. */
    uint8_t number;
    /** The index of the first of its entries in mip_registry. */
    uint16_t first;
    /** The number of its entries. */
    uint16_t count;
    /** Name in the specification: "3dm". */
    const char *name;
};

/** All types of fields, by descriptor set and descriptor. */
extern MIP_API const struct mip_entry mip_registry[];
/** The number of all types of fields. */
extern MIP_API const size_t mip_registry_size;
/** All descriptor sets, by number. */
extern MIP_API const struct mip_set mip_registry_sets[];
/** The number of all descriptor sets. */
extern MIP_API const size_t mip_registry_set_count;
/** Indexes of entries, for mip_registry_link. */
extern MIP_API const uint16_t mip_registry_links[];

/** Finds a descriptor set by its number; returns NULL if it is unknown. */
MIP_API const struct mip_set *mip_registry_set(uint8_t number);

/** Returns the first part of a field's full name in packets of this set: "gnss_2" of "gnss_2.dop",
 * "shared" for a field that all data sets share. */
MIP_API const char *mip_registry_set_name(const struct mip_entry *entry, uint8_t descriptor_set);

/** Returns the next layout of a descriptor in packets of a set: the first if `last` is NULL, else
 * the one after `last`; NULL after the last one. */
MIP_API const struct mip_entry *mip_registry_next(uint8_t descriptor_set, uint8_t descriptor,
                                                  const struct mip_entry *last);

/** Finds the layout of a field; returns NULL if the field is unknown, or if its data has none of
 * the known layouts. */
MIP_API const struct mip_entry *mip_registry_find(const struct mip_field *field);

/** Finds a field by its name: "gnss_2.dop"; returns NULL if there is none. If `descriptor_set` is
 * not NULL, it receives the set in the name, with 0 and 0xFF as in mip_set. */
MIP_API const struct mip_entry *mip_registry_by_name(const char *name, uint8_t *descriptor_set);

/** Returns the responses to a command, or the commands of a response, by number from 0; NULL after
 * the last one. */
MIP_API const struct mip_entry *mip_registry_link(const struct mip_entry *entry, size_t number);

#ifdef __cplusplus
}
#endif

#endif
