/**
 * @file
 * Prints packets and fields in readable form, with names, units and flags, and unknown bytes in
 * hexadecimal. It links all types of all sets, so small programs should not use it.
 *
 *     char buffer[1024];
 *     struct mip_text text;
 *     struct mip_print print = mip_print_to_text(&text, buffer, sizeof(buffer));
 *     mip_print_packet(&print, &packet);
 *     puts(buffer);
 *
 * prints, for example:
 *
 *     packet (0x80) sensor, 20 bytes
 *       sensor.scaled_accel: data (0x80,0x04)
 *         scaled_accel: [0.5, -0.25, 1] g
 *
 * The text is ASCII, and each line ends with a line feed. No heap is used: while a field is
 * printed, its structure is on the stack (`union mip_any_value`), and about 800 bytes more for a
 * number that is not whole. The text may change between versions; programs should not parse it.
 */
#ifndef MIP_PRINT_H
#define MIP_PRINT_H

#include "mip/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The destination of the text, and the device. */
struct mip_print {
    /** Writes the next piece of the text, which has no NUL at its end. */
    void (*put)(void *user, const char *text, size_t size);
    /** The first argument of `put`. */
    void *user;
    /** Id of the device, such as "3dm-gx5-15", because the meaning of some values depends on it.
     * NULL if it is not known; such values are then plain numbers. */
    const char *device;
};

/** Text in a buffer of fixed size: see mip_print_to_text. */
struct mip_text {
    /** The text so far. It ends with a NUL, unless there is no room at all. */
    char *buffer;
    /** Size of the buffer. */
    size_t room;
    /** The number of characters of the whole text, without the NUL. If it is `room` or more, the
     * buffer contains only the beginning. */
    size_t length;
};

/** Begins a text in a buffer of `room` bytes. Text that does not fit is counted and omitted. */
MIP_API struct mip_print mip_print_to_text(struct mip_text *text, char *buffer, size_t room);

/** Prints a packet: its descriptor set, its fields, and the error after the last one, if any. */
MIP_API void mip_print_packet(const struct mip_print *print, const struct mip_packet *packet);

/** Prints a field: its name, its descriptors and its values, or why it cannot be decoded, and its
 * bytes. */
MIP_API void mip_print_field(const struct mip_print *print, const struct mip_field *field);

/** Prints a text that ends with a NUL. */
MIP_API void mip_print_string(const struct mip_print *print, const char *text);

/** Prints a whole number. */
MIP_API void mip_print_unsigned(const struct mip_print *print, uint64_t value);

/** Prints a whole number that may be negative. */
MIP_API void mip_print_signed(const struct mip_print *print, int64_t value);

/** Prints a float with the fewest digits that distinguish it from all others: "0.1", "1e-7",
 * "-inf", "nan". */
MIP_API void mip_print_float(const struct mip_print *print, float value);

/** Prints a double in the same way. */
MIP_API void mip_print_double(const struct mip_print *print, double value);

#ifdef __cplusplus
}
#endif

#endif
