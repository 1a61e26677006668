/* Searches in the reflection tables. */
#include "mip/extra/reflect.h"

#include <string.h>

const struct mip_reflection *mip_reflect(const struct mip_codec *codec) {
    for (size_t i = 0; i < mip_reflection_count; i++) {
        if (mip_reflections[i].codec == codec) {
            return &mip_reflections[i];
        }
    }
    return NULL;
}

const struct mip_names *mip_names_find(const char *name) {
    for (size_t i = 0; i < mip_all_names_count; i++) {
        if (strcmp(mip_all_names[i]->name, name) == 0) {
            return mip_all_names[i];
        }
    }
    return NULL;
}
