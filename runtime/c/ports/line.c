/* Derives the kind of line from a name, and opens it again. */
#include "open.h"

/** Milliseconds between attempts to open a port again. */
#define PAUSE 100

/** Connects to HOST:PORT, or to [ADDRESS]:PORT with an IPv6 address. */
static void open_address(struct mip_line *line, const char *name, const char *colon) {
    char host[256];
    const size_t length = (size_t)(colon - name);
    const size_t bracket = length > 1 && name[0] == '[' && colon[-1] == ']';
    const size_t bare = length - 2 * bracket;
    if (bare >= sizeof(host)) {
        line->error = "the host name is too long";
        return;
    }
    memcpy(host, name + bracket, bare);
    host[bare] = '\0';
    mip_line_open_tcp(line, host, colon + 1);
}

bool mip_line_open(struct mip_line *line, const char *name, uint32_t baud) {
    const char *colon = strrchr(name, ':');
    line->handle = -1;
    line->error = NULL;
    line->name = name;
    line->baud = baud;
    line->port.user = line;
    line->is_tcp = colon != NULL && strchr(name, '/') == NULL;
    if (line->is_tcp) {
        open_address(line, name, colon);
    } else {
        mip_line_open_serial(line, name, baud);
    }
    return line->error == NULL;
}

bool mip_line_set_baud(void *user, uint32_t baud) {
    struct mip_line *line = (struct mip_line *)user;
    if (line->is_tcp || !mip_line_set_mode(line, baud)) {
        return false;
    }
    line->baud = baud;
    return true;
}

bool mip_line_reopen(struct mip_line *line, uint32_t within) {
    const uint32_t start = mip_line_pause(0);
    mip_line_close(line);
    while (!mip_line_open(line, line->name, line->baud)) {
        if (mip_line_pause(PAUSE) - start >= within) {
            return false;
        }
    }
    return true;
}
