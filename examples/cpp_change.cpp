#include "mip/cpp/aiding_commands.hpp"

// Reads an aiding frame, moves it, and writes it back with everything else as it was.
template <class Device> bool move_frame(Device &device, std::uint8_t id, float x) {
    auto frame = device.call(mip::aiding::read_frame_config{id, mip::aiding::frame_format::euler});
    if (frame) {
        frame->translation[0] = x;
        return static_cast<bool>(device.call(mip::change(*frame)));
    }
    return false;
}
