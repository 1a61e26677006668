#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/sensor.hpp"

bool run(Port &port) { // your own class with read, write and now: see mip/cpp/device.hpp
    mip::device device(port);
    device.on<mip::sensor::scaled_accel>([](const auto &accel) { show(accel.scaled_accel); });

    const auto pps = device.call(mip::mip_3dm::read_pps_source_control{});
    if (pps && pps->source() != mip::mip_3dm::pps_source::gpio) {
        const auto done =
            device.call(mip::mip_3dm::write_pps_source_control{mip::mip_3dm::pps_source::gpio});
        if (!done) {
            report(to_string(done.outcome()), done.reason()); // refused, ...
            return false;
        }
    }
    while (device.poll()) { // until the port is lost
    }
    return true;
}
