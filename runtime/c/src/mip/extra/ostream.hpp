/**
 * @file
 * Prints packets and fields to a std::ostream, with names and units. It links the tables of all
 * sets.
 */
#ifndef MIP_OSTREAM_HPP
#define MIP_OSTREAM_HPP

#include "mip/cpp/core.hpp"
#include "mip/extra/print.h"

#include <ostream>

namespace mip {

/** Creates a printer that writes to a stream. */
inline mip_print print_to(std::ostream &out) {
    mip_print print = {};
    print.put = [](void *stream, const char *text, std::size_t size) {
        static_cast<std::ostream *>(stream)->write(text, static_cast<std::streamsize>(size));
    };
    print.user = &out;
    return print;
}

/** Prints a packet, field by field. */
inline std::ostream &operator<<(std::ostream &out, const packet &printed) {
    const mip_print print = print_to(out);
    mip_print_packet(&print, &printed);
    return out;
}

/** Prints a field and its values. */
inline std::ostream &operator<<(std::ostream &out, const field &printed) {
    const mip_print print = print_to(out);
    mip_print_field(&print, &printed);
    return out;
}

} // namespace mip

#endif
