#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/base_commands.hpp"
#include "mip/line.h"
#include "mip/cpp/sensor.hpp"

#include <cstdio>
#include <string>

static void show(const char *what, const mip::result<void> &result) {
    if (!result) {
        std::fprintf(stderr, "%s: %s\n", what, std::string(result.reason()).c_str());
    }
}

int main(int argc, char **argv) {
    mip_line line;
    const char *place = argc > 1 ? argv[1] : "/dev/ttyACM0"; // or COM3, or HOST:PORT
    if (!mip_line_open(&line, place, 115200)) {
        std::fprintf(stderr, "%s: %s\n", place, line.error);
        return 1;
    }
    mip::device<> device(line.port);
    device.on<mip::sensor::scaled_accel>([](const auto &accel) {
        const auto &a = accel.scaled_accel;
        std::printf("%8.4f %8.4f %8.4f g\n", double(a[0]), double(a[1]), double(a[2]));
        std::fflush(stdout);
    });

    show("idle", device.call(mip::base::set_idle{}));
    const auto info = device.call(mip::base::get_device_info{});
    show("device information", info);
    if (info) {
        std::puts(std::string(mip::text(info->device_info.model_name)).c_str());
    }

    // 100 Hz, if the base rate of the device is 1000 Hz, as on the 7-series.
    const mip::descriptor_rate fields[] = {{mip::descriptor<mip::sensor::scaled_accel>, 10}};
    show("format", device.call(mip::mip_3dm::write_message_format{mip::sensor_set, fields}));
    show("stream", device.call(mip::mip_3dm::write_data_stream_control{mip::sensor_set, true}));
    show("resume", device.call(mip::base::resume{}));
    while (device.poll()) { // until the port is lost
    }
    mip_line_close(&line);
    return 0;
}
