/**
 * @file
 * The time of a packet, by clock, and times in UTC.
 *
 *     int64_t time;
 *     if (mip_time(&packet, MIP_CLOCK_GPS, MIP_READING_UNKNOWN, &time) == MIP_TIME_VALID) ...
 *
 * Optional: what a program does not call is not linked. There is no floating-point arithmetic:
 * times are whole nanoseconds.
 */
#ifndef MIP_TIMESTAMPS_H
#define MIP_TIMESTAMPS_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/timestamps.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The clocks of timestamps. */
enum {
    /** GPS time, once a receiver, a PPS or the host has set it. Unix (POSIX) time is 315964800 s
       more, less the leap seconds. */
    MIP_CLOCK_GPS = 0,
    /** Nanoseconds of the clock that is synchronized to the PPS. */
    MIP_CLOCK_EXTERNAL = 1,
    /** Nanoseconds since power-on, by the clock of the device. */
    MIP_CLOCK_REFERENCE = 2,
    /** Seconds since power-on, which a device without GPS time sends as the time of week. */
    MIP_CLOCK_DEVICE = 3
};

/** What a packet contains of a clock's time. */
enum mip_time_state {
    /** No timestamp of this clock. */
    MIP_TIME_ABSENT = 0,
    /** A timestamp that has no valid time of this clock. */
    MIP_TIME_NOT_VALID = 1,
    /** A time. */
    MIP_TIME_VALID = 2
};

/** How devices read flags that mark values as valid: the device is not known, so that the flags
 * themselves decide where this differs. */
#define MIP_READING_UNKNOWN 0U
/** As most devices do. */
#define MIP_READING_USUAL 1U

/** Returns how a device reads flags, by its id, which is the `id` of its profile; NULL if it is not
 * known. */
MIP_API uint8_t mip_reading_of(const char *device);

/** The same, by the model number of the device information: MIP_READING_UNKNOWN if the model is not
 * known. Links no profiles. */
MIP_API uint8_t mip_reading_of_model(uint16_t model_number);

/**
 * Finds the time of a data packet by a clock, in nanoseconds: since 1970 in UTC if the clock has a
 * date, otherwise since its start.
 *
 * A time of week that is not valid as a date, or that has week 0, is the time of a clock without a
 * date. If several fields contain the time of a clock, the one with the lowest descriptor counts.
 * `reading` is the result of mip_reading_of or mip_reading_of_model. `time` is only changed if the
 * time is valid.
 */
MIP_API enum mip_time_state mip_time(const struct mip_packet *packet, uint8_t clock,
                                     uint8_t reading, int64_t *time);

/** Converts nanoseconds since a clock's epoch, which you computed yourself, to nanoseconds since
 * 1970 in UTC; the result of mip_time is in UTC already. A leap second becomes the second after it.
 * The time of a clock without a date is unchanged. */
MIP_API int64_t mip_time_utc(uint8_t clock, int64_t time);

#ifdef __cplusplus
}
#endif

#endif
