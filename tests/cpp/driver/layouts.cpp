// The functions that the driver of C calls, implemented in C++: decoding, encoding, and the packets of a stream.
//
// The driver is compiled with other names for them. It identifies a layout by its codec; here that becomes a type.
#include "mip/cpp/mip.hpp"

#include <cstdlib>
#include <vector>

namespace {

struct layout {
    const mip_codec *codec;
    mip_error (*decode)(void *value, const mip::field &field, std::size_t *trailing);
    mip_error (*add)(const void *value, mip::builder &builder);
};

// `Ways`: whether the three ways to get a value are compared. Compiling them takes most of the time.
template <class T, bool Ways> constexpr layout layout_of() {
    return {nullptr,
            [](void *value, const mip::field &field, std::size_t *trailing) {
                T &to = *static_cast<T *>(value);
                const mip_error error = field.decode(to, trailing);
                if (error == MIP_OK && !field.is<T>()) {
                    std::abort();
                }
                if constexpr (Ways) {
                    if (field.as<T>().has_value() != (error == MIP_OK)) {
                        std::abort();
                    }
                    bool called = false;
                    mip::dispatch(field, [&](const T &) { called = true; });
                    if (called != (error == MIP_OK)) {
                        std::abort();
                    }
                }
                return error;
            },
            [](const void *value, mip::builder &builder) {
                static const T empty = {}; // a field without parameters may have no structure
                return builder.add(value != nullptr ? *static_cast<const T *>(value) : empty);
            }};
}

layout with(layout made, const mip_codec &codec) {
    made.codec = &codec;
    return made;
}

const layout &find(const mip_codec *codec) {
    static const std::vector<layout> all = {
#define LAYOUT(type, ways) with(layout_of<::type, ways>(), mip::traits<::type>::codec()),
#include "layouts.inc"
    };
    for (const layout &each : all) {
        if (each.codec == codec) {
            return each;
        }
    }
    std::abort();
}

// Packets that were found and not yet returned.
std::vector<std::vector<std::uint8_t>> found;
std::size_t given = 0;

void keep(const mip::packet &packet) {
    found.emplace_back(packet.bytes, packet.bytes + packet.size);
}

bool give(mip_packet *packet) {
    if (given == found.size()) {
        found.clear();
        given = 0;
        return false;
    }
    const std::vector<std::uint8_t> &next = found[given++];
    *packet = mip_packet{next.data(), next.size(), next[2]};
    return true;
}

} // namespace

extern "C" {

mip_error cpp_decode(const mip_codec *codec, void *value, const mip_field *field, std::size_t *trailing) {
    return find(codec).decode(value, *field, trailing);
}

mip_error cpp_encode(const mip_codec *codec, const void *value, mip_builder *builder) {
    mip::builder packet(mip_builder_set(builder));
    const mip_error error = find(codec).add(value, packet);
    if (error != MIP_OK) {
        return mip_builder_note(builder, error);
    }
    const mip::packet made = packet.finish();
    const mip::field field = *made.begin();
    return mip_builder_add(builder, field.descriptor, field.data, field.size);
}

mip_error cpp_packet_check(const std::uint8_t *bytes, std::size_t size, mip_packet *packet) {
    mip_error error;
    if (const auto checked = mip::packet::from({bytes, size}, &error)) {
        *packet = *checked;
    }
    return error;
}

bool cpp_parser_next(mip_parser *parser, const std::uint8_t **data, std::size_t *size, mip_packet *packet) {
    if (*size > 0) {
        for (const mip::packet &each : mip::packet_range<false>(*parser, {*data, *size})) {
            keep(each);
        }
        *data += *size;
        *size = 0;
    }
    return give(packet);
}

bool cpp_parser_flush(mip_parser *parser, mip_packet *packet) {
    if (found.empty()) {
        for (const mip::packet &each : mip::packet_range<true>(*parser, {})) {
            keep(each);
        }
    }
    return give(packet);
}
}
