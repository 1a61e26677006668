/* Several layouts of one descriptor. */
#include "mip/core.h"

bool mip_codec_matches(const struct mip_codec *codec, const struct mip_field *field) {
    const struct mip_layout *layout = codec->layout;
    if (layout == NULL) {
        return true;
    }
    if (field->size < layout->shortest || field->size > layout->longest) {
        return false;
    }
    for (size_t i = 0; i < layout->constant_count; i++) {
        const struct mip_constant *c = &layout->constants[i];
        for (unsigned k = 0; k < c->size && c->offset + k < field->size; k++) {
            if (field->data[c->offset + k] != (uint8_t)(c->value >> 8 * (c->size - 1U - k))) {
                return false;
            }
        }
    }
    return true;
}
