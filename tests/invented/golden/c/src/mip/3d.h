/**
 * @file
 *
 * Awkward names (0x0C). Names that are keywords or begin with a digit.
 */
#ifndef MIP_3D_H
#define MIP_3D_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/3d.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_3d Awkward names (0x0C)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_3D_SET 0x0C

/**
 * Default: command (0x0C,0x10).
 *
 * Its parameters are keywords here and there.
 *
 * Not acknowledged if mode of mip_tools_settings is MIP_MODE_FAST. Supported by Model A.
 *
 * - guide: Default
 */
struct mip_3d_default {
    /** A keyword. */
    uint8_t class_;
    /** A keyword. */
    uint8_t type;
    /** A keyword. */
    uint8_t register_;
    /** A keyword. */
    uint8_t self;
    /** Used by generated code elsewhere. */
    uint8_t present_;
};

/** Descriptor set and descriptor, as mip_field_key returns them. */
#define MIP_3D_DEFAULT 0x0C10
/** Its descriptor. */
#define MIP_3D_DEFAULT_DESCRIPTOR 0x10
/** Its name in the specification. */
#define MIP_3D_DEFAULT_NAME "3d.default"

/** The field's wire format. */
extern MIP_API const struct mip_codec mip_3d_default_codec;

/** Decodes the field. On an error the structure is zeroed. */
static inline mip_error mip_3d_default_decode(struct mip_3d_default *value,
                                              const struct mip_field *field) {
    return mip_decode_only(&mip_3d_default_codec, 0x10, value, sizeof(*value), field);
}

/** Adds the field to a packet. On an error the packet is unchanged. */
MIP_CHECKED static inline mip_error mip_3d_default_encode(const struct mip_3d_default *value,
                                                          struct mip_builder *builder) {
    return mip_encode(&mip_3d_default_codec, value, builder);
}

/**
 * Default. Fills the structure and returns its address.
 *
 * - class_: A keyword.
 * - type: A keyword.
 * - register_: A keyword.
 * - self: A keyword.
 * - present_: Used by generated code elsewhere.
 */
static inline struct mip_3d_default *mip_3d_default_make(struct mip_3d_default *command,
                                                         uint8_t class_, uint8_t type,
                                                         uint8_t register_, uint8_t self,
                                                         uint8_t present_) {
    memset(command, 0, sizeof(*command));
    command->class_ = class_;
    command->type = type;
    command->register_ = register_;
    command->self = self;
    command->present_ = present_;
    return command;
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
