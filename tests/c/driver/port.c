#define _POSIX_C_SOURCE 200809L
#include "port.h"

#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/socket.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static int connect_to(const char *host, const char *service) {
    struct addrinfo hints;
    struct addrinfo *found;
    int handle = -1;
    memset(&hints, 0, sizeof(hints));
    hints.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(host, service, &hints, &found) != 0) {
        return -1;
    }
    for (const struct addrinfo *a = found; a != NULL && handle < 0; a = a->ai_next) {
        handle = socket(a->ai_family, a->ai_socktype, a->ai_protocol);
        if (handle >= 0 && connect(handle, a->ai_addr, a->ai_addrlen) != 0) {
            close(handle);
            handle = -1;
        }
    }
    freeaddrinfo(found);
    return handle;
}

/* Bytes as they are: no lines, no echo, no signals, no translation. */
static bool make_raw(int handle) {
    struct termios t;
    if (tcgetattr(handle, &t) != 0) {
        return false;
    }
    t.c_iflag &= ~(tcflag_t)(BRKINT | ICRNL | IGNCR | INLCR | INPCK | ISTRIP | IXON | PARMRK);
    t.c_oflag &= ~(tcflag_t)OPOST;
    t.c_cflag = (t.c_cflag & ~(tcflag_t)(CSIZE | PARENB)) | CS8 | CREAD | CLOCAL;
    t.c_lflag &= ~(tcflag_t)(ECHO | ECHONL | ICANON | IEXTEN | ISIG);
    t.c_cc[VMIN] = 1;
    t.c_cc[VTIME] = 0;
    return tcsetattr(handle, TCSANOW, &t) == 0;
}

static uint64_t clock_milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1000 * (uint64_t)now.tv_sec + (uint64_t)now.tv_nsec / 1000000;
}

bool port_open(struct port *port, const char *name) {
    const char *colon = strrchr(name, ':');
    char host[256];
    port->closed = false;
    signal(SIGPIPE, SIG_IGN);
    port->start = clock_milliseconds();
    if (colon == NULL) {
        port->handle = open(name, O_RDWR | O_NOCTTY);
        if (port->handle >= 0 && !make_raw(port->handle)) {
            close(port->handle);
            port->handle = -1;
        }
    } else if ((size_t)(colon - name) < sizeof(host)) {
        memcpy(host, name, (size_t)(colon - name));
        host[colon - name] = '\0';
        port->handle = connect_to(host, colon + 1);
    } else {
        port->handle = -1;
    }
    return port->handle >= 0;
}

void port_close(struct port *port) {
    close(port->handle);
}

uint32_t port_milliseconds(const struct port *port) {
    return (uint32_t)(clock_milliseconds() - port->start);
}

void port_write(struct port *port, const uint8_t *data, size_t size) {
    while (size > 0 && !port->closed) {
        const ssize_t written = write(port->handle, data, size);
        if (written > 0) {
            data += written;
            size -= (size_t)written;
        } else if (written < 0 && errno != EINTR) {
            port->closed = true;
        }
    }
}

size_t port_read(struct port *port, uint8_t *data, size_t capacity, uint32_t milliseconds) {
    struct pollfd wanted = {port->handle, POLLIN, 0};
    const bool ready = poll(&wanted, port->closed ? 0 : 1, (int)milliseconds) > 0;
    const ssize_t size = ready ? read(port->handle, data, capacity) : 0;
    if (ready && (size == 0 || (size < 0 && errno != EINTR))) {
        port->closed = true; /* a closed pseudo-terminal returns an error */
    }
    return size > 0 ? (size_t)size : 0;
}
