/* Loaded before a program whose port is fixed, /dev/ttyACM0: opens what INTEROP_PORT names, a path or HOST:PORT. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <netdb.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

static int line = -1; /* a socket, which has no terminal settings */

static int dial(const char *address) {
    char host[256];
    const char *colon = strrchr(address, ':');
    struct addrinfo hints = {0}, *found;
    hints.ai_socktype = SOCK_STREAM;
    if (colon == NULL || (size_t)(colon - address) >= sizeof(host)) {
        return -1;
    }
    memcpy(host, address, (size_t)(colon - address));
    host[colon - address] = '\0';
    if (getaddrinfo(host, colon + 1, &hints, &found) != 0) {
        return -1;
    }
    line = socket(found->ai_family, found->ai_socktype, found->ai_protocol);
    if (line >= 0 && connect(line, found->ai_addr, found->ai_addrlen) != 0) {
        close(line);
        line = -1;
    }
    freeaddrinfo(found);
    return line;
}

int open(const char *path, int flags, ...) {
    int (*next)(const char *, int, ...) = (int (*)(const char *, int, ...))dlsym(RTLD_NEXT, "open");
    const char *port = getenv("INTEROP_PORT");
    va_list more;
    va_start(more, flags);
    mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
    va_end(more);
    if (port == NULL || strcmp(path, "/dev/ttyACM0") != 0) {
        return next(path, flags, mode);
    }
    return port[0] == '/' ? next(port, flags, mode) : dial(port);
}

int tcgetattr(int file, struct termios *settings) {
    int (*next)(int, struct termios *) = (int (*)(int, struct termios *))dlsym(RTLD_NEXT, "tcgetattr");
    if (file == line && line >= 0) {
        memset(settings, 0, sizeof(*settings));
        return 0;
    }
    return next(file, settings);
}

int tcsetattr(int file, int when, const struct termios *settings) {
    int (*next)(int, int, const struct termios *) =
        (int (*)(int, int, const struct termios *))dlsym(RTLD_NEXT, "tcsetattr");
    return file == line && line >= 0 ? 0 : next(file, when, settings);
}
