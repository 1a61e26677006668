#include "mip/connect.h"
#include "mip/cpp/device.hpp"
#include "mip/cpp/sensor.hpp"
#include "mip/line.h"

#include <cstdio>
#include <cstring>
#include <iostream>

int main(int argc, char **argv) {
    mip_line line;
    const char *place = argc > 1 ? argv[1] : "/dev/ttyACM0"; // or COM3, or HOST:PORT
    if (!mip_line_open(&line, place, 115200)) {
        std::cerr << place << ": " << line.error << '\n';
        return 1;
    }
    mip::device<> device(line.port);
    device.on<mip::sensor::scaled_accel>([](const auto &accel) {
        const auto &a = accel.scaled_accel;
        std::printf("%8.4f %8.4f %8.4f g\n", double(a[0]), double(a[1]), double(a[2]));
        std::fflush(stdout);
    });

    mip_base_get_device_info_response info;
    if (const mip::result<> found = device.connect(info, mip_line_set_baud); !found) {
        std::cerr << "connect: " << found << '\n';
        return 1;
    }
    const char *model = info.device_info.model_name; // padded with spaces
    std::puts(model + std::strspn(model, " "));

    mip_rate rates[] = {{mip::descriptor<mip::sensor::scaled_accel>, 100, 0}}; // 100 Hz
    if (const mip::result<> started = device.stream(mip::sensor_set, rates); !started) {
        std::cerr << "stream: " << started << '\n';
        return 1;
    }
    while (device.poll()) { // until the port is lost
    }
    mip_line_close(&line);
    return 0;
}
