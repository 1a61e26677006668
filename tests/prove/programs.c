/* Are the codecs of the library well-formed? Prints those that are not, and the number of those that are. */
#include "mip/extra/registry.h"

#include "steps.h"

#include <stdio.h>

static bool sets_are_known(const struct mip_codec *codec) {
    for (size_t i = codec->more_sets; i > 0; i--) { /* right before the program */
        if (mip_registry_set(*(codec->program - i)) == NULL) {
            return false;
        }
    }
    return true;
}

int main(void) {
    size_t well = 0;
    for (size_t i = 0; i < mip_registry_size; i++) {
        const struct mip_entry *entry = &mip_registry[i];
        if (well_formed(entry->codec) && sets_are_known(entry->codec)) {
            well++;
        } else {
            printf("%s is not well-formed\n", entry->name);
        }
    }
    printf("%zu\n", well);
    return 0;
}
