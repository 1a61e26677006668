// For 32-bit boards: starts the accelerations of a device at Serial1, and prints the one along x, in g, to Serial.
#include <mip.h>
#include <mip/cpp/3dm_commands.hpp>
#include <mip/cpp/base_commands.hpp>
#include <mip/cpp/sensor.hpp>

struct Port {
    std::optional<size_t> read(mip::span<uint8_t> room) {
        size_t count = 0;
        while (count < room.size() && Serial1.available() > 0) {
            room[count++] = (uint8_t)Serial1.read();
        }
        return count;
    }
    bool write(mip::bytes packet) {
        return Serial1.write(packet.data(), packet.size()) == packet.size();
    }
    uint32_t now() {
        return millis();
    }
} port;

mip::device device(port);

void setup() {
    Serial.begin(115200);
    Serial1.begin(115200);
    device.on<mip::sensor::scaled_accel>([](const auto &accel) { Serial.println(accel.scaled_accel[0]); });

    const mip::descriptor_rate fields[] = {{mip::descriptor<mip::sensor::scaled_accel>, 10}};
    if (!device.call(mip::base::set_idle{}) ||
        !device.call(mip::mip_3dm::write_message_format{mip::sensor_set, fields}) ||
        !device.call(mip::mip_3dm::write_data_stream_control{mip::sensor_set, true}) ||
        !device.call(mip::base::resume{})) {
        Serial.println("no device, or it refuses");
    }
}

void loop() {
    device.poll();
}
