/**
 * @file
 * Types that more than one descriptor set uses.
 */
#ifndef MIP_TYPES_H
#define MIP_TYPES_H

#include "mip/core.h"

#if MIP_VERSION_NUMBER != 100
#error "mip/types.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The result of a command. */
enum mip_ack_code MIP_ENUM_8 {
    /** Done. */
    MIP_ACK_CODE_OK = 0,
    /** No such command. Full name: unknown_command. */
    MIP_ACK_CODE_UNKNOWN = 1,
    /** A parameter is out of range. */
    MIP_ACK_CODE_INVALID_PARAMETER = 3
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_ack_code_name(uint8_t value);

/** What the device does. Uncertain: Whether there are more. */
enum mip_mode MIP_ENUM_8 {
    /** A keyword in three languages. */
    MIP_MODE_DEFAULT = 0,
    /** Quick. Uncertain: How quick. */
    MIP_MODE_FAST = 1,
    /** Careful. Deprecated. */
    MIP_MODE_SLOW = 2
};

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_mode_name(uint8_t value);

/** An enumeration over four bytes. */
#define MIP_WIDE_CODE_LOW 1
/** An enumeration over four bytes. */
#define MIP_WIDE_CODE_HIGH UINT32_C(0xFFFF0000)

/** Returns the name of a value in the specification; NULL if it has none. */
MIP_API const char *mip_wide_code_name(uint32_t value);

/** Bits of all kinds. */
typedef uint16_t mip_state_flags;
/** Bit 0. Ready to measure. */
#define MIP_STATE_FLAGS_READY 0x0001U
/** Bit 1. Too hot. Uncertain: The limit; 85 degrees is likely. */
#define MIP_STATE_FLAGS_HOT 0x0002U
/** Bits 4 to 6. A number from 0 to 7. */
#define MIP_STATE_FLAGS_LEVEL 0x0070U
/** Bits 8 to 9. An enumeration inside the bitfield. A value of enum mip_mode. */
#define MIP_STATE_FLAGS_MODE 0x0300U
/** Bits 0 to 1. Ready or hot. Full name: any. Overlaps other bits. */
#define MIP_STATE_FLAGS_OR 0x0003U

/** Bits 4 to 6. A number from 0 to 7. */
static inline uint8_t mip_state_flags_get_level(mip_state_flags flags) {
    const uint32_t bits = flags & MIP_STATE_FLAGS_LEVEL;
    return (uint8_t)(bits >> 4);
}

/** Sets it. */
static inline void mip_state_flags_set_level(mip_state_flags *flags, uint8_t value) {
    const uint32_t mask = MIP_STATE_FLAGS_LEVEL;
    const uint32_t bits = (uint32_t)value << 4;
    *flags = (mip_state_flags)((*flags & ~mask) | (bits & mask));
}

/** Bits 8 to 9. An enumeration inside the bitfield. A value of enum mip_mode. */
static inline uint8_t mip_state_flags_get_mode(mip_state_flags flags) {
    const uint32_t bits = flags & MIP_STATE_FLAGS_MODE;
    return (uint8_t)(bits >> 8);
}

/** Sets it. */
static inline void mip_state_flags_set_mode(mip_state_flags *flags, uint8_t value) {
    const uint32_t mask = MIP_STATE_FLAGS_MODE;
    const uint32_t bits = (uint32_t)value << 8;
    *flags = (mip_state_flags)((*flags & ~mask) | (bits & mask));
}

/** One hundred and twenty-eight bits, least significant byte first. */
struct mip_health {
    /** Least significant byte first. */
    uint8_t bytes[16];
};
/** Bit 0. The clock has failed. */
#define MIP_HEALTH_CLOCK MIP_BITS(0, 1)
/** Bit 1. Too hot. Uncertain: The limit; 85 degrees is likely. */
#define MIP_HEALTH_HOT MIP_BITS(1, 1)
/** Bits 4 to 6. A number from 0 to 7. */
#define MIP_HEALTH_LEVEL MIP_BITS(4, 3)
/** Bit 9. The supply is out of range. */
#define MIP_HEALTH_POWER MIP_BITS(9, 1)
/** Bits 30 to 33. A number across two bytes. Full name: count. */
#define MIP_HEALTH_NUM MIP_BITS(30, 4)
/** Bit 127. The very last bit. */
#define MIP_HEALTH_LAST MIP_BITS(127, 1)

/** A place in a plane. */
struct mip_point {
    /** Eastward. Unit: m. */
    int16_t x;
    /** Northward. Unit: m. */
    int16_t y;
};

/** Two places, nested. */
struct mip_segment {
    /** Begins here. */
    struct mip_point from;
    /** Ends here. */
    struct mip_point to;
    /** Of its ends. */
    uint8_t weights[2];
};

#ifdef __cplusplus
}
#endif

#endif
