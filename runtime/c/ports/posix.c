/* Serial ports and TCP connections by POSIX: Linux, macOS, BSD. */
#ifndef _WIN32
#define _DEFAULT_SOURCE /* also baud rates and locks that POSIX does not have */

#include "open.h"

#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

/* ------------------------------------------------------------------------ reading and writing */

/** Notes why a line is lost; returns false. */
static bool lost(struct mip_line *line, const char *why) {
    line->error = why;
    return false;
}

static bool read_line(void *user, uint8_t *bytes, size_t size, size_t *count) {
    struct mip_line *line = (struct mip_line *)user;
    if (line->handle < 0) { /* could not be opened again; poll() would ignore it */
        return false;
    }
    struct pollfd wait = {(int)line->handle, POLLIN, 0};
    const int ready = poll(&wait, 1, MIP_LINE_WAIT);
    if (ready <= 0) { /* nothing for a while */
        return ready == 0 || errno == EINTR || lost(line, strerror(errno));
    }
    const ssize_t got = read(wait.fd, bytes, size);
    if (got < 0) {
        return errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK ||
               lost(line, strerror(errno));
    }
    *count = (size_t)got;
    if (got == 0 && line->is_tcp) {
        return lost(line, "the connection was closed");
    }
    return got > 0 || (wait.revents & POLLHUP) == 0 || lost(line, "the port was disconnected");
}

static bool write_line(void *user, const uint8_t *bytes, size_t size) {
    struct mip_line *line = (struct mip_line *)user;
    if (line->handle < 0) {
        return false;
    }
    while (size > 0) {
        struct pollfd wait = {(int)line->handle, POLLOUT, 0};
        const int ready = poll(&wait, 1, MIP_LINE_PATIENCE);
        if (ready == 0 || (ready < 0 && errno != EINTR)) {
            return lost(line, ready == 0 ? "the other end accepts no bytes" : strerror(errno));
        }
#ifdef MSG_NOSIGNAL
        const ssize_t count =
            line->is_tcp ? send(wait.fd, bytes, size, MSG_NOSIGNAL) : write(wait.fd, bytes, size);
#else
        const ssize_t count = write(wait.fd, bytes, size);
#endif
        if (count < 0 && errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK) {
            return lost(line, strerror(errno));
        }
        if (count > 0) {
            bytes += count;
            size -= (size_t)count;
        }
    }
    return true;
}

static uint32_t milliseconds(void *user) {
    struct timespec now;
    (void)user;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_sec * 1000u + (uint32_t)(now.tv_nsec / 1000000);
}

uint32_t mip_line_pause(uint32_t wait) {
    if (wait > 0) {
        poll(NULL, 0, (int)wait);
    }
    return milliseconds(NULL);
}

/* ------------------------------------------------------------------------------- serial ports */

/** Returns the system's constant for a baud rate; B0 if it has none. */
static speed_t speed_of(uint32_t baud) {
    static const struct {
        uint32_t baud;
        speed_t speed;
    } speeds[] = {
        {4800, B4800},       {9600, B9600}, {19200, B19200}, {38400, B38400},
#ifdef B57600
        {57600, B57600},
#endif
#ifdef B115200
        {115200, B115200},
#endif
#ifdef B230400
        {230400, B230400},
#endif
#ifdef B460800
        {460800, B460800},
#endif
#ifdef B921600
        {921600, B921600},
#endif
#ifdef B3000000
        {3000000, B3000000},
#endif
    };
    for (size_t i = 0; i < sizeof(speeds) / sizeof(speeds[0]); i++) {
        if (speeds[i].baud == baud) {
            return speeds[i].speed;
        }
    }
#ifdef __APPLE__
    return baud; /* the constant of a rate is the rate itself */
#else
    return B0;
#endif
}

/** Sets raw mode, 8N1, at this rate. On an error, sets errno. */
static bool set_mode(int file, uint32_t baud) {
    const speed_t speed = speed_of(baud);
    struct termios mode;
    if (speed == B0) {
        errno = EINVAL;
        return false;
    }
    if (tcgetattr(file, &mode) != 0) {
        return false;
    }
    mode.c_iflag = IGNBRK; /* no flow control, no translation of line ends */
    mode.c_oflag = 0;
    mode.c_lflag = 0;
    mode.c_cflag = CS8 | CREAD | CLOCAL;
    mode.c_cc[VMIN] = 0;
    mode.c_cc[VTIME] = 0;
    return cfsetispeed(&mode, speed) == 0 && cfsetospeed(&mode, speed) == 0 &&
           tcsetattr(file, TCSANOW, &mode) == 0 && tcflush(file, TCIOFLUSH) == 0;
}

static void use(struct mip_line *line, int file) {
    line->handle = file;
    line->port.read = read_line;
    line->port.write = write_line;
    line->port.now = milliseconds;
}

void mip_line_open_serial(struct mip_line *line, const char *name, uint32_t baud) {
    const int file = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (file < 0) {
        line->error = strerror(errno);
        return;
    }
    if (flock(file, LOCK_EX | LOCK_NB) != 0) { /* two readers would each receive only a part */
        line->error = "the port is in use by another program";
    } else if (!set_mode(file, baud)) {
        line->error =
            errno == EINVAL ? "the port does not support this baud rate" : strerror(errno);
    }
    if (line->error != NULL) {
        close(file);
        return;
    }
    use(line, file);
}

bool mip_line_set_mode(const struct mip_line *line, uint32_t baud) {
    return set_mode((int)line->handle, baud);
}

/* --------------------------------------------------------------------------- TCP connections */

/** Connects to one address; returns -1 if that fails. */
static int connected(const struct addrinfo *to) {
    const int one = 1;
    const int file = socket(to->ai_family, to->ai_socktype, to->ai_protocol);
    if (file < 0) {
        return -1;
    }
    if (connect(file, to->ai_addr, to->ai_addrlen) != 0) {
        const int why = errno;
        close(file);
        errno = why;
        return -1;
    }
    setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &one, sizeof(one));
#ifdef SO_NOSIGPIPE
    setsockopt(file, SOL_SOCKET, SO_NOSIGPIPE, &one, sizeof(one));
#endif
    return file;
}

void mip_line_open_tcp(struct mip_line *line, const char *host, const char *number) {
    struct addrinfo wanted;
    struct addrinfo *found = NULL;
    int file = -1;
    memset(&wanted, 0, sizeof(wanted));
    wanted.ai_socktype = SOCK_STREAM;
    const int failed = getaddrinfo(host, number, &wanted, &found);
    if (failed != 0) {
        line->error = gai_strerror(failed);
        return;
    }
    for (const struct addrinfo *to = found; to != NULL && file < 0; to = to->ai_next) {
        file = connected(to);
    }
    if (file >= 0) {
        use(line, file);
    } else {
        line->error = strerror(errno);
    }
    freeaddrinfo(found);
}

void mip_line_close(struct mip_line *line) {
    if (line->handle >= 0) {
        close((int)line->handle);
        line->handle = -1;
    }
}

#else
typedef int mip_not_posix; /* C does not allow an empty file */
#endif
