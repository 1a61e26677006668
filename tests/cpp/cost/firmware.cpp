// A typical application of a microcontroller: three fields, and a few commands.
#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/base_commands.hpp"
#include "mip/cpp/filter_data.hpp"
#include "mip/cpp/sensor.hpp"

extern "C" {
extern const mip_port uart;
void use(float value);
void start(void);
}

void start() {
    static mip::device<3> device(uart);
    device.on<mip::sensor::scaled_accel>([](const auto &accel) { use(accel.scaled_accel[0]); });
    device.on<mip::sensor::scaled_gyro>([](const auto &gyro) { use(gyro.scaled_gyro[0]); });
    device.on<mip::filter_data::ned_velocity>([](const auto &velocity) { use(velocity.north); });

    const mip::descriptor_rate fields[] = {{mip::descriptor<mip::sensor::scaled_accel>, 10},
                                           {mip::descriptor<mip::sensor::scaled_gyro>, 10}};
    if (device.call(mip::base::ping{}) &&
        device.call(mip::mip_3dm::write_message_format{mip::sensor_set, fields}) &&
        device.call(mip::mip_3dm::write_data_stream_control{mip::sensor_set, true})) {
        while (device.poll()) {
        }
    }
}
