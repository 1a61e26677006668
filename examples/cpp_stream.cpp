#include "mip/cpp/filter_data.hpp"
#include "mip/cpp/sensor.hpp"

// All packets of a log in memory. For a stream that arrives in pieces, use mip::parser.
void read(mip::bytes log) {
    for (const mip::packet &packet : mip::packets(log)) {
        for (const mip::field &field : packet) {
            if (const auto accel = field.as<mip::sensor::scaled_accel>()) { // std::optional
                show(accel->scaled_accel);
            }
        }
    }
}

// Each field is passed to the function with a parameter of its type. Other fields are ignored.
void handle(const mip::packet &packet) {
    mip::dispatch(
        packet, [](const mip::sensor::scaled_accel &accel) { show(accel.scaled_accel); },
        [](const mip::filter_data::status &status, const mip::field &field) {
            report(status.filter_state, field.descriptor_set);
        });
}

// A packet of two commands, for a program that must not wait.
bool ask(mip::builder &packet) {
    const mip::descriptor_rate fields[] = {{mip::descriptor<mip::sensor::scaled_accel>, 10}};
    return packet.add(mip::mip_3dm::write_message_format{mip::sensor_set, fields}) == MIP_OK &&
           packet.add(mip::mip_3dm::write_data_stream_control{mip::sensor_set, true}) == MIP_OK;
}
