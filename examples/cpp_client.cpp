#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/client.hpp"
#include "mip/cpp/sensor.hpp"

// Your own event loop: the client does not read, write or wait, and your program provides the time.
bool set_pps_source(mip::client &client, mip::mip_3dm::pps_source source) {
    mip::request command(mip::mip_3dm::write_pps_source_control{source});
    transmit(client.send(milliseconds(), command)); // several commands of one set fit in one packet
    while (command.waiting()) {
        std::uint8_t piece[64];
        const std::size_t size = receive(piece, sizeof(piece)); // 0 if none arrived
        client.receive({piece, size}, milliseconds(),           // also handles data
                       [](const mip::sensor::scaled_accel &accel) { show(accel.scaled_accel); });
    }
    if (!command.result()) {
        report(to_string(command.result().outcome()), command.result().reason());
    }
    return static_cast<bool>(command.result());
}
