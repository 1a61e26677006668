/* Searches in the registry. */
#include "mip/registry.h"

#include <string.h>

#define SHARED_SET 0xFF
#define FIRST_DATA_SET 0x80

static const struct mip_entry *search(uint8_t descriptor_set, uint8_t descriptor, size_t *count) {
    size_t first = 0;
    size_t end = mip_registry_size;
    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        const struct mip_entry *e = &mip_registry[middle];
        if (e->descriptor_set < descriptor_set ||
            (e->descriptor_set == descriptor_set && e->descriptor < descriptor)) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    *count = 0;
    for (size_t i = first; i < mip_registry_size; i++) {
        if (mip_registry[i].descriptor_set != descriptor_set ||
            mip_registry[i].descriptor != descriptor) {
            break;
        }
        ++*count;
    }
    return *count > 0 ? &mip_registry[first] : NULL;
}

const struct mip_entry *mip_registry_candidates(uint8_t descriptor_set, uint8_t descriptor,
                                                size_t *count) {
    const bool data = descriptor_set >= FIRST_DATA_SET;
    if (data) {
        const struct mip_entry *own = search(descriptor_set, descriptor, count);
        return own != NULL ? own : search(SHARED_SET, descriptor, count);
    }
    const struct mip_entry *common = search(0, descriptor, count);
    return common != NULL ? common : search(descriptor_set, descriptor, count);
}

const struct mip_entry *mip_registry_find(const struct mip_field *field) {
    size_t count;
    const struct mip_entry *entry =
        mip_registry_candidates(field->descriptor_set, field->descriptor, &count);
    for (size_t i = 0; i < count; i++) {
        if (mip_codec_matches(entry[i].codec, field)) {
            return &entry[i];
        }
    }
    return NULL;
}

const struct mip_entry *mip_registry_by_name(const char *name) {
    for (size_t i = 0; i < mip_registry_size; i++) {
        if (strcmp(mip_registry[i].name, name) == 0) {
            return &mip_registry[i];
        }
    }
    return NULL;
}

const struct mip_entry *mip_registry_link(const struct mip_entry *entry, size_t number) {
    return number < entry->link_count
               ? &mip_registry[mip_registry_links[entry->first_link + number]]
               : NULL;
}
