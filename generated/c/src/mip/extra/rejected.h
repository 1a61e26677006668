/**
 * @file
 * The field for which a device has rejected a command that lists fields.
 *
 * Optional: what a program does not call is not linked.
 */
#ifndef MIP_REJECTED_H
#define MIP_REJECTED_H

#include "mip/connect.h"
#include "mip/extra/profile.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/extra/rejected.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Why a device rejects a field, in the order in which the reasons are searched. */
enum mip_rejection {
    /** Nothing shows the field. */
    MIP_REJECTION_UNKNOWN = 0,
    /** The device does not send it. */
    MIP_REJECTION_ABSENT,
    /** Its decimation is 0. */
    MIP_REJECTION_DECIMATION,
    /** The list is longer than permitted. */
    MIP_REJECTION_TOO_MANY,
    /** It is not data of the set. */
    MIP_REJECTION_UNDEFINED,
    /** No source states that this model sends it. */
    MIP_REJECTION_UNLISTED,
    /** The device has another command for it, whose set and descriptor are stated. Searched first.
     */
    MIP_REJECTION_OTHER_COMMAND
};

/** What is known about a device. */
struct mip_known_device {
    /** Its profile, such as mip_device_profile returns it; NULL if it is not known. */
    const struct mip_profile *profile;
    /** All that the device lists itself, in response to all commands for its descriptors: the set
     * in the high byte, the descriptor in the low one. NULL if one of them was not answered,
     * because what is missing here counts as not sent. */
    const uint16_t *descriptors;
    /** Elements of `descriptors`. */
    size_t descriptor_count;
};

/** The field for which a device has rejected a command, or the command that it has instead. */
struct mip_rejected {
    /** An `enum mip_rejection`. */
    uint8_t reason;
    /** Its index in the list. */
    uint8_t index;
    /** Its set. */
    uint8_t descriptor_set;
    /** Its descriptor; 0 for the whole set. */
    uint8_t descriptor;
    /** The number of fields in the list. */
    uint8_t count;
    /** The greatest number that is permitted; 0 if that is not known. */
    uint8_t most;
};

/**
 * Finds the field for which a device has rejected a command, or the command that it has instead.
 * `command` is the field that was sent. If nothing shows it, the reason is MIP_REJECTION_UNKNOWN.
 */
MIP_API struct mip_rejected mip_find_rejected(const struct mip_field *command,
                                              const struct mip_known_device *known);

/**
 * Writes a reason in words: "3DM-CV7-AR has no GNSS receiver". Links the names of all fields.
 * Returns the size of the whole text, of which at most `size` - 1 characters and a NUL are stored;
 * 0 for MIP_REJECTION_UNKNOWN.
 */
MIP_API size_t mip_rejected_text(const struct mip_rejected *rejected,
                                 const struct mip_known_device *known, char *text, size_t size);

/** Finds the rate for whose field a device has rejected a stream: `index` is its index in `rates`.
 */
MIP_API struct mip_rejected mip_stream_rejected(uint8_t descriptor_set, uint8_t count,
                                                const struct mip_rate *rates,
                                                const struct mip_known_device *known);

#ifdef __cplusplus
}
#endif

#endif
