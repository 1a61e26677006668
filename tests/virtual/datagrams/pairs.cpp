// The same as pairs.c, with the device of C++.
#include "udp.h"

#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/device.hpp"

struct Udp {
    int handle;

    std::optional<std::size_t> read(mip::span<std::uint8_t> room) {
        return udp_read(handle, room.data(), room.size());
    }
    bool write(mip::bytes packet) {
        return udp_write(handle, packet.data(), packet.size());
    }
    std::uint32_t now() {
        return udp_now();
    }
    bool waits() {
        return udp_wait(handle, 0);
    }
};

int main(int argc, char **argv) {
    static const std::uint8_t sets[] = {0x80, 0x82, 0x91, 0x92, 0x93, 0x94, 0xA0};
    count count = {};
    Udp udp = {udp_open(argv[argc - 2])};
    mip::device<> device(udp);
    device.on_other([&count](const mip_field &) { count.kept++; });
    device.c().client.timeout = 10000;
    for (int i = 0; i < std::atoi(argv[argc - 1]); i++) {
        const auto rate = device.call(mip::mip_3dm::get_base_rate{sets[i % 7]});
        count_pair(&count, bool(rate), rate && rate->descriptor_set == sets[i % 7]);
    }
    for (const std::uint32_t end = udp_now() + 300; static_cast<std::int32_t>(end - udp_now()) > 0;) {
        device.poll();
    }
    return print_count(&count);
}
