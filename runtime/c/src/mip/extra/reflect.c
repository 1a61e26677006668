/* Searches in the reflection table. */
#include "mip/extra/reflect.h"

const struct mip_reflection *mip_reflect(const struct mip_codec *codec) {
    for (size_t i = 0; i < mip_reflection_count; i++) {
        if (mip_reflections[i].codec == codec) {
            return &mip_reflections[i];
        }
    }
    return NULL;
}
