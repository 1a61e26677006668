// Reads a log: prints filter positions as CSV, and the number of fields of each kind.
#include "mip/cpp/mip.hpp"
#include "mip/extra/ostream.hpp"
#include "mip/extra/registry.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

int main(int argc, char **argv) {
    std::ifstream file(argc == 2 ? argv[1] : "", std::ios::binary);
    if (!file) {
        std::cerr << "usage: " << argv[0] << " FILE\n";
        return 2;
    }
    const std::vector<char> log{std::istreambuf_iterator<char>(file), {}};
    const auto *first = reinterpret_cast<const std::uint8_t *>(log.data());

    std::map<std::string, int> count;
    double time = 0;
    mip::packets packets({first, log.size()});
    std::cout << "time,latitude,longitude,flags\n";
    for (const mip::packet &packet : packets) {
        for (const mip::field &field : packet) {
            const mip_entry *known = mip_registry_find(&field);
            const int number = ++count[known != nullptr ? known->name : "unknown"];
            if (const auto stamp = field.as<mip::filter_data::timestamp>()) {
                time = stamp->tow;
            } else if (const auto place = field.as<mip::filter_data::llh_position>()) {
                std::cout << time << ',' << place->latitude << ',' << place->longitude << ','
                          << place->valid_flags() << '\n';
            } else if (field.is<mip::filter_data::status>() && number == 1) {
                std::cerr << "first status:" << field << '\n';
            }
        }
    }
    for (const auto &[name, number] : count) {
        std::cerr << number << " x " << name << '\n';
    }
    std::cerr << packets.skipped() << " bytes are not part of a packet\n";
    return 0;
}
