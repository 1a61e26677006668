#include "mip/3dm_commands.hpp"
#include "mip/client.hpp"
#include "mip/sensor.hpp"

// Your own event loop: the client neither reads, writes nor waits, and your program tells the time.
bool set_pps_source(mip::client &client, mip::mip_3dm::pps_source source) {
    mip::request command(mip::mip_3dm::write_pps_source_control{source});
    transmit(client.send(milliseconds(), command)); // of one set, several commands: one packet
    while (command.waiting()) {
        std::uint8_t piece[64];
        const std::size_t size = receive(piece, sizeof(piece)); // 0 if there are none
        client.receive({piece, size}, milliseconds(),           // and the data among the answers
                       [](const mip::sensor::scaled_accel &accel) { show(accel.scaled_accel); });
    }
    if (!command.result()) {
        report(to_string(command.result().outcome()), command.result().reason());
    }
    return static_cast<bool>(command.result());
}
