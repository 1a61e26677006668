// Reads a log: prints filter positions as CSV, and the number of fields of each kind.
#include "mip/cpp/mip.hpp"
#include "mip/extra/ostream.hpp"
#include "mip/extra/registry.h"

#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <vector>

int main(int argc, char **argv) {
    std::ifstream file(argc == 2 ? argv[1] : "", std::ios::binary);
    if (!file) {
        std::cerr << "usage: " << argv[0] << " FILE\n";
        return 2;
    }
    const std::vector<char> log{std::istreambuf_iterator<char>(file), {}};
    const auto *first = reinterpret_cast<const std::uint8_t *>(log.data());

    std::map<std::uint16_t, int> count; // by descriptor set and descriptor
    double time = 0;
    mip::packets packets({first, log.size()});
    std::cout << std::fixed << "time,latitude,longitude,flags\n";
    for (const mip::packet &packet : packets) {
        for (const mip::field &field : packet) {
            const int number = ++count[field.key()];
            if (const auto stamp = field.as<mip::filter_data::timestamp>()) {
                time = stamp->tow;
            } else if (const auto place = field.as<mip::filter_data::llh_position>()) {
                std::cout << std::setprecision(3) << time << ',' << std::setprecision(9)
                          << place->latitude << ',' << place->longitude << ','
                          << place->valid_flags() << '\n';
            } else if (field.is<mip::filter_data::status>() && number == 1) {
                std::cerr << "first status:" << field << '\n';
            }
        }
    }
    for (const auto &[key, number] : count) {
        const auto set = static_cast<std::uint8_t>(key >> 8);
        const mip_entry *known = mip_registry_next(set, static_cast<std::uint8_t>(key), nullptr);
        std::cerr << number << " x "
                  << (known != nullptr ? mip_registry_set_name(known, set) : "unknown") << '.'
                  << (known != nullptr ? known->name : "field") << '\n';
    }
    std::cerr << packets.skipped() << " bytes are not part of a packet\n";
    return 0;
}
