/**
 * @file
 * The first minutes with a device: finds its baud rate, reads its device information, and starts
 * its data at rates in Hz.
 *
 *     struct mip_device device;
 *     struct mip_base_get_device_info_response identity;
 *     mip_device_init(&device, &port, count, handlers);
 *     result = mip_device_connect(&device, set_baud, &identity);
 *
 * Optional: what a program does not call is not linked.
 */
#ifndef MIP_CONNECT_H
#define MIP_CONNECT_H

#include "mip/3dm_commands.h"
#include "mip/base_commands.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/connect.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Finds a device: tries each baud rate until anything answers a ping, or sends data; then sets the
 * device to idle, and reads its device information. Commands without a reply are repeated.
 *
 * `set_baud` changes the baud rate of the port, and returns false if the port does not support it.
 * Its argument `user` is `port.user`. Pass NULL if the port has no baud rate, or is already set to
 * that of the device. The rates are
 * 115200, 3000000, 921600, 460800, 230400, 57600, 38400, 19200, 9600, 4800.
 * A rate at which no device answers takes about a third of a second.
 *
 * Returns the result of the last command. If it is MIP_TIMED_OUT, no device was found, and the port
 * has the rate that was tried last.
 */
MIP_API struct mip_result mip_device_connect(struct mip_device *device,
                                             bool (*set_baud)(void *user, uint32_t baud),
                                             struct mip_base_get_device_info_response *identity);

/** The first timestamp of the set that the device accepts; if it has none, the other fields are
 * sent without one. */
#define MIP_TIMESTAMP 0U

/** A field of a stream, and how often it is sent. */
struct mip_rate {
    /** The field of the set: MIP_..._DESCRIPTOR, or MIP_TIMESTAMP. */
    uint8_t descriptor;
    /** The wanted rate in Hz. 0: the highest rate of the device. */
    float wanted;
    /** The nearest rate of the device in Hz, which mip_device_stream sets. 0: the field is sent as
     * its data arrives. */
    float nearest;
};

/** After mip_device_stream: does the device support the wanted rate? It does if that differs from
 * the nearest one by at most a ten-thousandth (333.33 Hz is 1000 Hz / 3), is 0, or if the field is
 * sent as its data arrives. */
static inline bool mip_rate_fits(const struct mip_rate *rate) {
    const float tolerance = rate->wanted * 1e-4f;
    const float more = rate->nearest - rate->wanted;
    return rate->wanted >= 0 &&
           (rate->wanted <= 0 || rate->nearest <= 0 || (more <= tolerance && -more <= tolerance));
}

/**
 * Starts the data of a set: reads the base rate of the set, writes which fields are sent and how
 * often, in this order, enables the stream, and ends the idle state. List MIP_TIMESTAMP first, as
 * often as the most frequent field, to get the times of packets. If the device rejects the first
 * command, the older commands for the set are used instead.
 *
 * A device divides its base rate by whole numbers. If it does not support a wanted rate, nothing is
 * changed, and the outcome is MIP_NO_SUCH_RATE: mip_rate_fits returns false for such rates, and
 * `nearest` is what to use instead. If the base rate is 0, data is sent as it arrives, whatever the
 * wanted rate. At most 83 fields fit; with more, the error is MIP_ERROR_COUNT.
 * Commands without a reply are repeated.
 */
MIP_API struct mip_result mip_device_stream(struct mip_device *device, uint8_t descriptor_set,
                                            uint8_t count, struct mip_rate *rates);

#ifdef __cplusplus
}
#endif

#endif
