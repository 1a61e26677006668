/* Searches in the registry. */
#include "mip/extra/registry.h"

#include <string.h>

#define SHARED_SET 0xFF
#define FIRST_DATA_SET 0x80

const struct mip_set *mip_registry_set(uint8_t number) {
    size_t first = 0;
    size_t end = mip_registry_set_count;
    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        if (mip_registry_sets[middle].number < number) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    return first < mip_registry_set_count && mip_registry_sets[first].number == number
               ? &mip_registry_sets[first]
               : NULL;
}

/** Finds the first entry from this one on that has the descriptor and occurs in the set. Entries of
 * a descriptor are consecutive, and entries of later sets do not occur in this one. */
static const struct mip_entry *among(const struct mip_entry *entry, uint8_t descriptor_set,
                                     uint8_t descriptor) {
    for (; entry < mip_registry + mip_registry_size && entry->descriptor == descriptor; entry++) {
        if (mip_codec_belongs(entry->codec, descriptor_set)) {
            return entry;
        }
    }
    return NULL;
}

/** Finds the first entry of a descriptor in a set. */
static const struct mip_entry *search(const struct mip_set *set, uint8_t descriptor_set,
                                      uint8_t descriptor) {
    size_t first = set != NULL ? set->first : mip_registry_size;
    size_t end = set != NULL ? first + set->count : first;
    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        if (mip_registry[middle].descriptor < descriptor) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    return among(&mip_registry[first], descriptor_set, descriptor);
}

const struct mip_entry *mip_registry_next(uint8_t descriptor_set, uint8_t descriptor,
                                          const struct mip_entry *last) {
    if (last != NULL) {
        return among(last + 1, descriptor_set, descriptor);
    }
    const struct mip_set *own = mip_registry_set(descriptor_set);
    const struct mip_entry *entry = search(own, descriptor_set, descriptor);
    if (entry == NULL) {
        own = mip_registry_set(descriptor_set >= FIRST_DATA_SET ? SHARED_SET : 0);
        entry = search(own, descriptor_set, descriptor);
    }
    return entry;
}

const struct mip_entry *mip_registry_find(const struct mip_field *field) {
    const struct mip_entry *entry = NULL;
    do {
        entry = mip_registry_next(field->descriptor_set, field->descriptor, entry);
    } while (entry != NULL && !mip_codec_matches(entry->codec, field));
    return entry;
}

const char *mip_registry_set_name(const struct mip_entry *entry, uint8_t descriptor_set) {
    const uint8_t first = entry->codec->descriptor_set;
    const struct mip_set *set = mip_registry_set(mip_set_valid(first) ? descriptor_set : first);
    return set != NULL ? set->name : "";
}

/** Returns the rest of a name after the set's name and a period; NULL if it begins otherwise. */
static const char *after(const char *set, const char *name) {
    while (*set != '\0' && *set == *name) {
        set++;
        name++;
    }
    return *set == '\0' && *name == '.' ? name + 1 : NULL;
}

const struct mip_entry *mip_registry_by_name(const char *name, uint8_t *descriptor_set) {
    for (size_t i = 0; i < mip_registry_set_count; i++) {
        const struct mip_set *set = &mip_registry_sets[i];
        const char *rest = after(set->name, name);
        for (size_t k = 0; rest != NULL && k < set->count; k++) {
            const struct mip_entry *entry = &mip_registry[set->first + k];
            if (strcmp(entry->name, rest) == 0 && mip_codec_belongs(entry->codec, set->number)) {
                if (descriptor_set != NULL) {
                    *descriptor_set = set->number;
                }
                return entry;
            }
        }
    }
    return NULL;
}

const struct mip_entry *mip_registry_link(const struct mip_entry *entry, size_t number) {
    return number < entry->link_count
               ? &mip_registry[mip_registry_links[entry->first_link + number]]
               : NULL;
}
