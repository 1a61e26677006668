/**
 * @file
 * C++17 over the C library: packets and fields as ranges, values by their type, names.
 *
 * Header-only, without heap, exceptions, virtual functions or run-time type information. It stores
 * no more than the C library does, so objects of both can be mixed freely.
 */
#ifndef MIP_CORE_HPP
#define MIP_CORE_HPP

#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "mip/cpp/core.hpp needs C++17: -std=c++17. The headers *.h also work in C++11."
#endif

#include "mip/core.h"
#if __has_include("mip/extra/names.h")
#include "mip/extra/names.h"
#else
struct mip_names;
#endif

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>
#include <type_traits>
#if __cplusplus > 201703L
#include <version>
#endif
#ifdef __cpp_lib_span
#include <span>
#endif

namespace mip {

/* --------------------------------------------------------------------------------------- layouts
 */

/**
 * Facts about a layout: `descriptor`; `key`, as mip_field_key returns it, unless the layout occurs
 * in several descriptor sets; `name`, as in the specification; `codec()`; and `decode`, without
 * tables if its size is fixed. The headers of descriptor sets specialize it for each C structure;
 * types derived from one have the same facts.
 */
template <class T, class = void> struct traits;
template <class T>
struct traits<T, std::void_t<typename T::c_type>> : traits<typename T::c_type> {};

namespace detail {

/** Defines `key`, except for a layout of several descriptor sets, for which it is 0 here. */
template <std::uint16_t Key> struct keyed {
    static constexpr std::uint16_t key = Key;
};
template <> struct keyed<0> {};

} // namespace detail

/** Marks a C structure as a layout. */
#define MIP_LAYOUT(type, constant, number, words, decoder)                \
    template <> struct traits<::type> : detail::keyed<number> {           \
        using c_type = ::type;                                            \
        static constexpr std::uint8_t descriptor = constant##_DESCRIPTOR; \
        static constexpr std::string_view name = words;                   \
        static const mip_codec &codec() {                                 \
            return ::type##_codec;                                        \
        }                                                                 \
        static mip_error decode(::type *to, const mip_field *from) {      \
            return ::type##_##decoder(to, from);                          \
        }                                                                 \
    };

/** The descriptor of a layout: `{mip::descriptor<mip::..._data::...>, decimation}`. */
template <class T> inline constexpr std::uint8_t descriptor = traits<T>::descriptor;

/** The C structure of a layout. */
template <class T> using c_type = typename traits<T>::c_type;

#ifdef __cpp_concepts
/** A type of field. */
template <class T>
concept layout = requires { traits<T>::codec(); };

/** Stands for `class` where a type must be a field type. */
#define MIP_LAYOUT_TYPE ::mip::layout
#else
#define MIP_LAYOUT_TYPE class
#endif

/* ----------------------------------------------------------------------------------------- spans
 */

/** A pointer and a count: elements in memory that the span does not own. */
template <class T> class span {
  public:
    constexpr span() = default;
    constexpr span(T *data, std::size_t size) : data_(data), size_(size) {
    }
    template <std::size_t Size> constexpr span(T (&items)[Size]) : data_(items), size_(Size) {
    }
    /** Converts std::array, std::vector, std::span and other types with data and size. */
    template <class Container, class = std::enable_if_t<std::is_convertible_v<
                                   decltype(std::declval<Container &>().data()), T *>>>
    constexpr span(Container &&items) : data_(items.data()), size_(items.size()) {
    }
    constexpr T *data() const {
        return data_;
    }
    constexpr std::size_t size() const {
        return size_;
    }
    constexpr bool empty() const {
        return size_ == 0;
    }
    constexpr T *begin() const {
        return data_;
    }
    constexpr T *end() const {
        return data_ + size_;
    }
    constexpr T &operator[](std::size_t index) const {
        return data_[index];
    }

  private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

/** Bytes of a stream. */
using bytes = span<const std::uint8_t>;

/** Returns a string that ends with a NUL or at the end of its array. */
template <std::size_t Size> std::string_view text(const char (&characters)[Size]) {
    const auto *end = static_cast<const char *>(::memchr(characters, '\0', Size));
    return {characters, end != nullptr ? static_cast<std::size_t>(end - characters) : Size};
}

/* ------------------------------------------------------------------------- enumerations and flags
 */

/* Enumerations and bitfields are `enum class`; the type that names_of returns distinguishes them.
 */

/** The names of the values of an enumeration. */
struct value_names {
    /** The names. */
    const mip_names &table;
};

/** The names of the flags of a bitfield, which is a number. */
struct flag_names {
    /** The names. */
    const mip_names &table;
};

/** The names of the bits of a bitfield in bytes. */
struct bit_names {
    /** The names. */
    const mip_names &table;
};

/** The names of a type; without the folder extra, only which of the three it has. */
#ifdef MIP_NAMES_H
#define MIP_NAMES_OF(kind, type, names) \
    inline kind names_of(type) {        \
        return {::names};               \
    }
#else
#define MIP_NAMES_OF(kind, type, names) kind names_of(type);
#endif

namespace detail {

/** Returns the number of elements in C's type. A larger number than that holds is too large for any
 * array. */
template <class Items> constexpr std::uint8_t count(const Items &items) {
    return static_cast<std::uint8_t>(std::size(items) < 0xFF ? std::size(items) : 0xFF);
}

template <class E, class Names, class = void> struct has_names : std::false_type {};
template <class E, class Names>
struct has_names<E, Names, std::void_t<decltype(names_of(std::declval<E>()))>>
    : std::is_same<decltype(names_of(std::declval<E>())), Names> {};

template <class E> using if_value = std::enable_if_t<has_names<E, value_names>::value>;
template <class E> using if_flags = std::enable_if_t<has_names<E, flag_names>::value>;
template <class E> using if_bits = std::enable_if_t<has_names<E, bit_names>::value>;

/** Returns the number of bits by which a mask is shifted. */
template <class Number> constexpr unsigned shift(Number mask) {
    unsigned places = 0;
    while (mask != 0 && (mask >> places & 1U) == 0) {
        places++;
    }
    return places;
}

} // namespace detail

/** Returns the number of an enumeration or a bitfield, like std::to_underlying. */
template <class E> constexpr std::underlying_type_t<E> number(E value) {
    return static_cast<std::underlying_type_t<E>>(value);
}

template <class E, class = detail::if_flags<E>> constexpr E operator|(E a, E b) {
    return static_cast<E>(number(a) | number(b));
}
template <class E, class = detail::if_flags<E>> constexpr E operator&(E a, E b) {
    return static_cast<E>(number(a) & number(b));
}
template <class E, class = detail::if_flags<E>> constexpr E operator^(E a, E b) {
    return static_cast<E>(number(a) ^ number(b));
}
template <class E, class = detail::if_flags<E>> constexpr E operator~(E a) {
    return static_cast<E>(~number(a));
}
template <class E, class = detail::if_flags<E>> constexpr E &operator|=(E &a, E b) {
    return a = a | b;
}
template <class E, class = detail::if_flags<E>> constexpr E &operator&=(E &a, E b) {
    return a = a & b;
}
template <class E, class = detail::if_flags<E>> constexpr E &operator^=(E &a, E b) {
    return a = a ^ b;
}

/** Are all of these flags set? */
template <class E, class = detail::if_flags<E>> constexpr bool has(E flags, E wanted) {
    return (flags & wanted) == wanted;
}

/** Returns a number inside a bitfield. */
template <class E, class = detail::if_flags<E>>
constexpr std::underlying_type_t<E> get(E flags, E mask) {
    return static_cast<std::underlying_type_t<E>>(number(flags & mask) >>
                                                  detail::shift(number(mask)));
}

/** Returns a number in a bitfield in bytes; a flag is 0 or 1. */
template <class Flags, class E, class = detail::if_bits<E>>
std::uint64_t get(const Flags &flags, E bits) {
    return mip_get_bits(flags.bytes, number(bits));
}
template <std::size_t Size, class E, class = detail::if_bits<E>>
std::uint64_t get(const std::uint8_t (&flags)[Size], E bits) {
    return mip_get_bits(flags, number(bits));
}

/** Is this flag set in a bitfield in bytes, or any bit of this number? */
template <class Flags, class E, class = detail::if_bits<E>> bool has(const Flags &flags, E bits) {
    return get(flags, bits) != 0;
}

#ifdef MIP_NAMES_H
/** Returns the name of a value in the specification; empty if it has none. */
template <class E, class = detail::if_value<E>> std::string_view to_string(E value) {
    const char *name = mip_value_name(&names_of(value).table, number(value));
    return name != nullptr ? name : std::string_view();
}

/** Returns the name of one flag, or of a number in a bitfield; empty if it has none. */
template <class E, class = detail::if_flags<E>, class = void> std::string_view to_string(E flag) {
    const mip_names &names = names_of(flag).table;
    for (std::size_t i = 0; i < names.count; i++) {
        const std::uint64_t mask = (~UINT64_C(0) >> (64 - names.bits[i].width))
                                   << names.bits[i].first;
        if (mask == number(flag)) {
            return mip_names_label(&names, i);
        }
    }
    return {};
}

/** Writes the name of a value, or its number if it has none, to a stream such as std::ostream. */
template <class Stream, class E, class = detail::if_value<E>>
Stream &operator<<(Stream &out, E value) {
    const std::string_view name = to_string(value);
    name.empty() ? out << +number(value) : out << name;
    return out;
}

/** Writes the names of the flags that are set: "a | b"; bits without a name as a number. */
template <class Stream, class E, class = detail::if_flags<E>, class = void>
Stream &operator<<(Stream &out, E flags) {
    const mip_names &names = names_of(flags).table;
    auto left = number(flags);
    const char *between = "";
    for (std::size_t i = 0; i < names.count; i++) {
        const auto bit = static_cast<decltype(left)>(1ULL << names.bits[i].first);
        if (names.bits[i].width == 1 && (left & bit) != 0) {
            out << between << mip_names_label(&names, i);
            left = static_cast<decltype(left)>(left & ~bit);
            between = " | ";
        }
    }
    if (left != 0 || *between == '\0') {
        out << between << +left;
    }
    return out;
}
#endif

/** Returns the error as one word: "truncated". */
inline std::string_view to_string(mip_error error) {
    return mip_error_name(error);
}

/* --------------------------------------------------------------------------- fields and packets */

/** One field of a packet, not yet decoded. */
struct field : mip_field {
    field() = default;
    field(const mip_field &other) : mip_field(other) {
    }

    /** Returns descriptor set and descriptor as one number: `case traits<T>::key`. */
    std::uint16_t key() const {
        return mip_field_key(this);
    }
    /** Returns its data, without its header. */
    mip::bytes bytes() const {
        return {data, size};
    }
    /** Is it of this type, in any of the descriptor sets in which the type occurs? */
    template <MIP_LAYOUT_TYPE T> bool is() const {
        return mip_field_is(this, &traits<T>::codec());
    }
    /** Returns its value, if it is of this type. */
    template <MIP_LAYOUT_TYPE T> std::optional<T> as() const {
        T value;
        if (descriptor != traits<T>::descriptor || traits<T>::decode(&value, this) != MIP_OK) {
            return std::nullopt;
        }
        return value;
    }
    /** Decodes it. If it is not of this type or too short, `value` is zeroed. */
    template <MIP_LAYOUT_TYPE T> mip_error decode(T &value) const {
        c_type<T> &to = value;
        return mip_decode_only(&traits<T>::codec(), traits<T>::descriptor, &to, sizeof(to), this);
    }
    /** Like decode(value); `trailing` receives the number of bytes after the last known parameter.
     */
    template <MIP_LAYOUT_TYPE T> mip_error decode(T &value, std::size_t *trailing) const {
        c_type<T> &to = value;
        return mip_decode(&traits<T>::codec(), &to, this, trailing);
    }
};

/** The end of the ranges in this header. */
struct end_of_range {};

/** A packet: a range of fields. It ends before a field whose length is impossible. */
struct packet : mip_packet {
    packet() = default;
    packet(const mip_packet &other) : mip_packet(other) {
    }

    /** Iterates over the fields. */
    class iterator {
      public:
        using iterator_category = std::input_iterator_tag;
        using value_type = field;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = field;

        explicit iterator(const mip_packet &packet) : walk_(mip_walk_packet(&packet)) {
            ++*this;
        }
        /* By value, so that the compiler keeps the walk in registers. */
        field operator*() const {
            return field_;
        }
        iterator &operator++() {
            more_ = mip_walk_next(&walk_, &field_);
            return *this;
        }
        void operator++(int) {
            ++*this;
        }
        friend bool operator==(const iterator &at, end_of_range) {
            return !at.more_;
        }
        friend bool operator!=(const iterator &at, end_of_range) {
            return at.more_;
        }
        /** Returns, at the end, MIP_ERROR_FIELD_LENGTH if a malformed field is there, else MIP_OK.
         */
        mip_error error() const {
            return walk_.error;
        }

      private:
        mip_walk walk_;
        field field_;
        bool more_ = false;
    };

    iterator begin() const {
        return iterator(*this);
    }
    end_of_range end() const {
        return {};
    }
    /** Returns the packet if the bytes are exactly one. `why` receives the error. */
    static std::optional<packet> from(mip::bytes of, mip_error *why = nullptr) {
        packet checked;
        const mip_error error = mip_packet_check(of.data(), of.size(), &checked);
        if (why != nullptr) {
            *why = error;
        }
        return error == MIP_OK ? std::optional<packet>(checked) : std::nullopt;
    }
};

/* ---------------------------------------------------------------------------------------- streams
 */

/** The packets in a piece of a stream; if it is the last piece, also those within an incomplete
 * packet. */
template <bool Last> class packet_range {
  public:
    packet_range(mip_parser &parser, bytes piece)
        : parser_(&parser), at_(piece.data()), left_(piece.size()) {
    }

    /** Iterates over the packets. */
    class iterator {
      public:
        using iterator_category = std::input_iterator_tag;
        using value_type = packet;
        using difference_type = std::ptrdiff_t;
        using pointer = const packet *;
        using reference = const packet &;

        explicit iterator(packet_range &range) : range_(&range) {
            ++*this;
        }
        const packet &operator*() const {
            return packet_;
        }
        const packet *operator->() const {
            return &packet_;
        }
        iterator &operator++() {
            more_ = range_->next(packet_);
            return *this;
        }
        void operator++(int) {
            ++*this;
        }
        friend bool operator==(const iterator &at, end_of_range) {
            return !at.more_;
        }
        friend bool operator!=(const iterator &at, end_of_range) {
            return at.more_;
        }

      private:
        packet_range *range_;
        packet packet_;
        bool more_ = false;
    };

    iterator begin() {
        return iterator(*this);
    }
    end_of_range end() const {
        return {};
    }

  private:
    bool next(packet &found) {
        if (mip_parser_next(parser_, &at_, &left_, &found)) {
            return true;
        }
        if constexpr (Last) {
            return mip_parser_flush(parser_, &found);
        }
        return false;
    }

    mip_parser *parser_;
    const std::uint8_t *at_;
    std::size_t left_;
};

/** Finds packets in a stream of bytes that arrives in pieces. */
class parser : public mip_parser {
  public:
    parser() {
        mip_parser_init(this);
    }
    /** Returns the packets that this piece completes. Iterate over all of them: leaving the loop
     * early loses the rest of the piece. A packet is valid until the next one, and while the piece
     * is. */
    packet_range<false> feed(bytes piece) {
        return {*this, piece};
    }
    /** Returns packets within an incomplete packet. Call this at the end of a file, and when the
     * line has been silent for longer than a packet takes. See mip_parser_flush. */
    packet_range<true> flush() {
        return {*this, {}};
    }
};

/** All packets in memory, such as in a mapped file: `for (packet p : packets(file))`. */
class packets {
  public:
    explicit packets(bytes stream) : range_(parser_, stream) {
    }
    packets(const packets &) = delete;
    packets &operator=(const packets &) = delete;

    packet_range<true>::iterator begin() {
        return range_.begin();
    }
    end_of_range end() const {
        return {};
    }
    /** Returns the number of bytes so far that are not part of a packet. */
    std::uint32_t skipped() const {
        return parser_.skipped;
    }

  private:
    parser parser_;
    packet_range<true> range_;
};

/* --------------------------------------------------------------------------------------- dispatch
 */

namespace detail {

template <class R, class C, class T, class... More> T first_parameter(R (C::*)(T, More...) const);
template <class R, class C, class T, class... More> T first_parameter(R (C::*)(T, More...));
template <class R, class T, class... More> T first_parameter(R (*)(T, More...));

template <class Handler, class = void> struct handled {
    using type = decltype(first_parameter(&Handler::operator()));
};
template <class Handler>
struct handled<Handler, std::enable_if_t<std::is_function_v<std::remove_pointer_t<Handler>>>> {
    using type = decltype(first_parameter(std::declval<Handler>()));
};

/** The type of a handler's first parameter. */
template <class Handler>
using handled_by =
    std::remove_cv_t<std::remove_reference_t<typename handled<std::decay_t<Handler>>::type>>;

/** Calls a handler with the arguments that it accepts: the value, the field, the time. */
template <class Handler, class T, class... More>
void call(Handler &handler, const T &value, const field &from, More... more) {
    if constexpr (std::is_invocable_v<Handler &, const T &, const field &, More...>) {
        handler(value, from, more...);
    } else if constexpr (std::is_invocable_v<Handler &, const T &, const field &>) {
        handler(value, from);
    } else {
        handler(value);
    }
}

/** Calls a handler if it is for this field. */
template <class Handler> bool offer(const field &from, Handler &handler) {
    using T = handled_by<Handler>;
    if constexpr (std::is_same_v<T, field>) {
        handler(from);
        return true;
    } else {
        T value;
        if (from.descriptor != traits<T>::descriptor ||
            traits<T>::decode(&value, &from) != MIP_OK) {
            return false;
        }
        call(handler, value, from);
        return true;
    }
}

} // namespace detail

/**
 * Calls the first handler whose parameter is of the field's type: `[](const T &value) {...}` or
 * `[](const T &value, const field &from) {...}`. A handler whose only parameter is a field is
 * called with every field that no earlier handler accepts. Returns true if any was called.
 */
template <class... Handlers> bool dispatch(const field &from, Handlers &&...handlers) {
    return (detail::offer(from, handlers) || ...);
}

/** Dispatches each field of a packet. */
template <class... Handlers> void dispatch(const packet &from, Handlers &&...handlers) {
    mip_walk walk = mip_walk_packet(&from);
    field each;
    while (mip_walk_next(&walk, &each)) {
        dispatch(each, handlers...);
    }
}

/* ---------------------------------------------------------------------------------------- builder
 */

namespace detail {

/** The C structure that is sent for a value: the value itself, or the one that a command fills. */
template <class T, class = void> struct sent {
    using structure = c_type<T>;
    static const structure *fill(const T &value, structure *) {
        return &value;
    }
};
template <class T> struct sent<T, std::void_t<typename T::command>> {
    using structure = typename T::command;
    static const structure *fill(const T &value, structure *room) {
        return value.fill(room);
    }
};

} // namespace detail

/** Builds a packet. */
class builder {
  public:
    explicit builder(std::uint8_t descriptor_set) {
        (void)mip_builder_start(&builder_, buffer_, sizeof(buffer_), descriptor_set);
    }
    builder(const builder &) = delete;
    builder &operator=(const builder &) = delete;

    /** Adds a field, or a command such as `write_...{}`. On an error the packet is unchanged. */
    template <class T> [[nodiscard]] mip_error add(const T &value) {
        typename detail::sent<T>::structure room;
        return mip_encode(&traits<decltype(room)>::codec(), detail::sent<T>::fill(value, &room),
                          &builder_);
    }
    /** Adds a field from its bytes. */
    [[nodiscard]] mip_error add(std::uint8_t descriptor, bytes data) {
        return mip_builder_add(&builder_, descriptor, data.data(), data.size());
    }
    /** Returns the first error when the packet was begun or fields were added; MIP_OK if none. */
    mip_error error() const {
        return builder_.error;
    }
    /** Returns the packet, which is stored in the builder. */
    packet finish() {
        return mip_builder_finish(&builder_);
    }

  private:
    mip_builder builder_;
    std::uint8_t buffer_[MIP_MAX_PACKET];
};

} // namespace mip

#ifdef __cpp_lib_span
/* So that std::span is constructed from one. */
template <class T> inline constexpr bool std::ranges::enable_borrowed_range<mip::span<T>> = true;
#endif

#endif
