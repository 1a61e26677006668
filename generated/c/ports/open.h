/* The system's functions for line.c, in posix.c or windows.c. Those that open a line set its error
 * on failure. */
#ifndef MIP_OPEN_H
#define MIP_OPEN_H

#include "mip/line.h"

void mip_line_open_serial(struct mip_line *line, const char *name, uint32_t baud);
void mip_line_open_tcp(struct mip_line *line, const char *host, const char *number);
bool mip_line_set_mode(const struct mip_line *line, uint32_t baud);

/** Waits for a number of milliseconds, and returns the time after that, in milliseconds. */
uint32_t mip_line_pause(uint32_t milliseconds);

#endif
