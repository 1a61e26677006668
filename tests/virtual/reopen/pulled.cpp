// The same as pulled.c, with the device of C++.
#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/base.hpp"
#include "mip/connect.h"
#include "mip/cpp/device.hpp"
#include "mip/line.h"
#include "mip/cpp/sensor.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char **argv) {
    const unsigned wanted = argc == 3 ? static_cast<unsigned>(std::atoi(argv[2])) : 0;
    unsigned reopened = 0, answered = 0, lost = 0, wrong = 0, other = 0, number = 0, before = 0, fields = 0;
    mip_line line;
    if (!mip_line_open(&line, argv[1], 115200)) {
        return std::fprintf(stderr, "%s\n", line.error);
    }
    mip::device<> device(line.port);
    device.on<mip::sensor::scaled_accel>([&fields](const mip::sensor::scaled_accel &) { fields++; });
    mip::base::get_device_info_response info;
    mip_rate rates[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 100, 0}};
    if (!device.connect(info) || !device.stream(mip::sensor_set, rates)) {
        return std::fprintf(stderr, "it does not start\n");
    }
    while (reopened < wanted) {
        static const std::uint8_t sets[] = {0x80, 0x82, 0x91};
        const std::uint8_t set = sets[number++ % 3];
        const auto result = device.call(mip::mip_3dm::get_base_rate{set});
        const mip::outcome outcome = result.outcome();
        answered += outcome == mip::outcome::acknowledged;
        wrong += result && result->descriptor_set != set;
        lost += outcome == mip::outcome::closed;
        other += outcome != mip::outcome::acknowledged && outcome != mip::outcome::closed &&
                 outcome != mip::outcome::not_sent;
        if (!result && !device.poll()) {
            if (!mip_line_reopen(&line, 10000)) {
                return std::fprintf(stderr, "%s\n", line.error);
            }
            reopened++;
            before += fields > 0;
            fields = 0;
        }
    }
    std::printf("{\"reopened\": %u, \"streamed\": %u, \"answered\": %u, \"lost\": %u, \"wrong\": %u, \"other\": %u}\n",
                reopened, before, answered, lost, wrong, other);
    mip_line_close(&line);
}
