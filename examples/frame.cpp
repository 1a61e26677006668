// Opens a device, and sends a command of the reference.
#include "mip/connect.h"
#include "mip/cpp/device.hpp"
#include "mip/line.h"
// 1. the line of the page that begins with #include
#include "mip/cpp/base_commands.hpp"

#include <iostream>

static bool run(mip::device<> &device) {
    // 2. the other lines of the page
    const auto result = device.call(mip::base::ping{});
    // end of 2
    std::cerr << "command: " << result << '\n';
    return bool(result);
}

int main(int argc, char **argv) {
    const char *place = argc > 1 ? argv[1] : "/dev/ttyACM0"; // or COM3, or HOST:PORT
    mip_line line;
    if (!mip_line_open(&line, place, 115200)) {
        std::cerr << place << ": " << line.error << '\n';
        return 1;
    }
    mip::device<> device(line.port);
    mip_base_get_device_info_response info;
    const mip::result<> found = device.connect(info, mip_line_set_baud);
    if (!found) {
        std::cerr << "connect: " << found << '\n';
    }
    const bool done = found && run(device);
    mip_line_close(&line);
    return done ? 0 : 1;
}
