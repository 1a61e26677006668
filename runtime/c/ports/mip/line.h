/**
 * @file
 * Serial ports and TCP connections on a computer, for mip/device.h. Optional: compile the files in
 * this folder with your program, and link with ws2_32 on Windows. A microcontroller needs none of
 * them.
 *
 *     struct mip_line line;
 *     if (!mip_line_open(&line, "/dev/ttyACM0", 115200)) {
 *         puts(line.error);
 *     }
 *     mip_device_init(&device, &line.port, count, handlers);
 */
#ifndef MIP_LINE_H
#define MIP_LINE_H

#include "mip/device.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Milliseconds that a read waits for the first byte. */
#define MIP_LINE_WAIT 10
/** Milliseconds that a write waits until the other end accepts bytes. */
#define MIP_LINE_PATIENCE 5000

/** An open serial port or TCP connection. It must not move while a device uses it. */
struct mip_line {
    /** For mip_device_init. */
    struct mip_port port;
    /** The system's file descriptor, handle or socket. */
    intptr_t handle;
    /** The name passed to mip_line_open, for mip_line_reopen. */
    const char *name;
    /** Its baud rate. */
    uint32_t baud;
    /** Is it a TCP connection? */
    bool is_tcp;
    /** Why it could not be opened, or why it was lost; NULL while it is open. */
    const char *error;
};

/**
 * Opens a port: a TCP connection if the name is HOST:PORT, else a serial port, such as
 * /dev/ttyACM0 or COM3, with 8 data bits, no parity, 1 stop bit and no flow control. The port is
 * opened exclusively. The name must stay at its address. Returns false on failure: see `error`.
 */
bool mip_line_open(struct mip_line *line, const char *name, uint32_t baud);

/**
 * Opens a lost port again, for example after mip_device_poll has returned false: closes it, and
 * tries to open it every 100 ms for `within` milliseconds. The device then continues at the same
 * baud rate:
 *
 *     while (mip_device_poll(&device) || mip_line_reopen(&line, 30000)) { ... }
 *
 * The outcome of the command that was waiting is MIP_CLOSED. The device may have restarted; then it
 * sends nothing until you call mip_device_stream again. Returns false if the port could not be
 * opened: see `error`.
 */
bool mip_line_reopen(struct mip_line *line, uint32_t within);

/** Changes the baud rate of a serial port, and discards received bytes; for mip_device_connect.
 * Returns false if the system or the port does not support the rate, and for a TCP connection. */
bool mip_line_set_baud(void *line, uint32_t baud);

/** Closes a port. */
void mip_line_close(struct mip_line *line);

#ifdef __cplusplus
}
#endif

#endif
