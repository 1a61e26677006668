/* Which kind of line a name means. */
#include "open.h"

/** Connects to HOST:PORT, or to [ADDRESS]:PORT with an address of IPv6. */
static void open_address(struct mip_line *line, const char *name, const char *colon) {
    char host[256];
    const size_t length = (size_t)(colon - name);
    const size_t bracket = length > 1 && name[0] == '[' && colon[-1] == ']';
    const size_t bare = length - 2 * bracket;
    if (bare >= sizeof(host)) {
        line->error = "the name of the host is too long";
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
    line->port.user = line;
    line->is_tcp = colon != NULL && strchr(name, '/') == NULL;
    if (line->is_tcp) {
        open_address(line, name, colon);
    } else {
        mip_line_open_serial(line, name, baud);
    }
    return line->error == NULL;
}
