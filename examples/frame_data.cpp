// Opens a device, streams a data field of the reference once per second, and reads it.
#include "mip/connect.h"
#include "mip/cpp/device.hpp"
#include "mip/line.h"
// 1. the line of the page that begins with #include
#include "mip/cpp/sensor.hpp"

#include <iostream>

// 3. the descriptor set and the descriptor of the page
enum : std::uint8_t { SET = 0x80, DESCRIPTOR = 0x04 };

static void on_field(const mip::field &field, std::uint32_t arrived) {
    if (field.descriptor_set != SET || field.descriptor != DESCRIPTOR) {
        return;
    }
    std::cout << arrived << " ms: " << +field.size << " bytes" << std::endl;
    // 2. the other lines of the page
    if (const auto value = field.as<mip::sensor::scaled_accel>()) {
        std::cout << value->scaled_accel[0] << ' ' << value->scaled_accel[1] << ' '
                  << value->scaled_accel[2] << '\n';
    }
    // end of 2
}

int main(int argc, char **argv) {
    const char *place = argc > 1 ? argv[1] : "/dev/ttyACM0"; // or COM3, or HOST:PORT
    mip_line line;
    if (!mip_line_open(&line, place, 115200)) {
        std::cerr << place << ": " << line.error << '\n';
        return 1;
    }
    mip::device<> device(line.port);
    device.on_other(on_field);
    mip_base_get_device_info_response info;
    mip_rate rates[] = {{DESCRIPTOR, 1, 0}}; // 1 Hz
    mip::result<> result = device.connect(info, mip_line_set_baud);
    if (result) {
        result = device.stream(SET, rates);
    }
    if (!result) {
        std::cerr << result << '\n';
        return 1;
    }
    while (device.poll()) { // until the port is lost
    }
    mip_line_close(&line);
    return 0;
}
