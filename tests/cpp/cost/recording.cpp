// The same as recording.c.
#include "mip/filter_data.hpp"
#include "mip/sensor.hpp"

#include <cstdio>

int main(int argc, char **argv) {
    std::FILE *file = argc == 2 ? std::fopen(argv[1], "rb") : nullptr;
    std::uint8_t bytes[4096];
    std::size_t size;
    double sum = 0;
    if (file == nullptr) {
        return 2;
    }
    const auto handle = [&](const mip::packet &packet) {
        mip::dispatch(
            packet,
            [&](const mip::sensor::scaled_accel &accel) { sum += double(accel.scaled_accel[0]); },
            [&](const mip::filter_data::ned_velocity &velocity) { sum += double(velocity.north); },
            [&](const mip::filter_data::status &status) { sum += status.filter_state; });
    };
    mip::parser parser;
    while ((size = std::fread(bytes, 1, sizeof(bytes), file)) > 0) {
        for (const mip::packet &packet : parser.feed({bytes, size})) {
            handle(packet);
        }
    }
    for (const mip::packet &packet : parser.flush()) {
        handle(packet);
    }
    std::printf("%a\n", sum);
    return 0;
}
