/* Opens a device, and sends a command of the reference. */
#include "mip/connect.h"
#include "mip/line.h"
/* 1. the line of the page that begins with #include */
#include "mip/base_commands.h"

#include <stdio.h>

static struct mip_result run(struct mip_device *device) {
    /* 2. the other lines of the page */
    struct mip_result result = mip_call_base_ping(device);
    /* end of 2 */
    return result;
}

static int told(const char *what, struct mip_result result) {
    fprintf(stderr, "%s: %s %s\n", what, mip_outcome_name(result.outcome),
            mip_result_reason(result));
    return mip_succeeded(result) ? 0 : 1;
}

int main(int argc, char **argv) {
    struct mip_line line;
    struct mip_device device;
    struct mip_base_get_device_info_response info;
    const char *name = argc == 2 ? argv[1] : "/dev/ttyACM0"; /* or COM3, or HOST:PORT */

    if (!mip_line_open(&line, name, 115200)) {
        fprintf(stderr, "%s: %s\n", name, line.error);
        return 1;
    }
    mip_device_init(&device, &line.port, 0, NULL);
    struct mip_result result = mip_device_connect(&device, mip_line_set_baud, &info);
    const int failed = mip_succeeded(result) ? told("command", run(&device)) : told("connect", result);
    mip_line_close(&line);
    return failed;
}
