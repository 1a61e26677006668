/* A serial port, a pseudo-terminal or a TCP connection, by POSIX. */
#ifndef DRIVER_PORT_H
#define DRIVER_PORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct port {
    int handle;
    bool closed; /* by the other end */
    uint64_t start; /* milliseconds of a clock */
};

/* `name` is the path of a terminal, or HOST:PORT. False if it cannot be opened. */
bool port_open(struct port *port, const char *name);
void port_close(struct port *port);

/* The time since it was opened. */
uint32_t port_milliseconds(const struct port *port);

void port_write(struct port *port, const uint8_t *data, size_t size);

/* Reads what has arrived, waiting at most that long; 0 also if the port is closed. */
size_t port_read(struct port *port, uint8_t *data, size_t capacity, uint32_t milliseconds);

#endif
