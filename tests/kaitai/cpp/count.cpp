// Counts what mip.cpp finds in a file: packets, bytes between them, fields, unknown ones, and those that cannot be decoded.
#include "mip.h"

#include <fstream>
#include <iostream>
#include <iterator>

int main(int, char **argv) {
    std::ifstream file(argv[1], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    kaitai::kstream stream(bytes);
    mip_t log(&stream);
    long packets = 0, between = 0, fields = 0, unknown = 0, wrong = 0;
    for (mip_t::part_t *part : *log.parts()) {
        if (!part->is_packet()) {
            between += 1 + part->skipped()->rest().size();
            continue;
        }
        ++packets;
        for (mip_t::field_t *field : *part->packet()->payload()->fields()) {
            if (!field->is_sound()) {
                ++wrong;
                continue;
            }
            ++fields;
            try {
                unknown += field->data() == nullptr;
            } catch (const std::exception &) {
                ++wrong;
            }
        }
    }
    std::cout << packets << " " << between << " " << fields << " " << unknown << " " << wrong << "\n";
}
