/**
 * @file
 * A device at a port, in C++17: a call for each command, and handlers for data.
 */
#ifndef MIP_DEVICE_HPP
#define MIP_DEVICE_HPP

#include "mip/cpp/core.hpp"
#include "mip/device.h"
#include "mip/cpp/types.hpp"

#include <new>
#include <utility>
#ifdef __cpp_lib_concepts
#include <concepts>
#endif

namespace mip {

/** The outcome of a command. */
enum class outcome {
    /** It could not be encoded, or the port could not write. */
    not_sent = MIP_NOT_SENT,
    /** The device has carried it out. */
    acknowledged = MIP_ACKNOWLEDGED,
    /** It was sent; devices do not answer it. */
    sent = MIP_SENT,
    /** The device has rejected it: `code` is the reason. */
    refused = MIP_REFUSED,
    /** No reply arrived in time. */
    timed_out = MIP_TIMED_OUT,
    /** The device has acknowledged it without its response. */
    missing_response = MIP_MISSING_RESPONSE,
    /** The device has sent a response that cannot be decoded: `error` is the reason. */
    undecodable = MIP_UNDECODABLE,
    /** It was cancelled, or the port was lost, before the reply arrived. */
    closed = MIP_CLOSED,
    /** It was sent without waiting, and its reply has not arrived. */
    waiting = MIP_WAITING,
    /** The call was made in a handler of the same device. */
    busy = MIP_BUSY,
    /** The stream was not changed, because the device does not support one of the rates. */
    no_such_rate = MIP_NO_SUCH_RATE
};

/** Returns the outcome in words: "timed out". */
inline std::string_view to_string(outcome value) {
    return mip_outcome_name(static_cast<enum mip_outcome>(value));
}

/** Writes "timed out" to a stream such as std::ostream. */
template <class Stream>
auto operator<<(Stream &out, outcome value)
    -> decltype(static_cast<Stream &>(out << std::string_view())) {
    return static_cast<Stream &>(out << to_string(value));
}

/** The base of all results. */
class [[nodiscard]] basic_result {
  public:
    basic_result(const mip_result &of) : result_(of) {
    }
    /** Has the command been carried out, as far as is known? */
    explicit operator bool() const {
        return mip_succeeded(result_);
    }
    mip::outcome outcome() const {
        return static_cast<mip::outcome>(result_.outcome);
    }
    /** Returns the acknowledge code: why the device has rejected the command. It is ok if there was
     * no reply. */
    ack_code code() const {
        return static_cast<ack_code>(result_.code);
    }
    /** Returns the reason for not_sent and undecodable. */
    mip_error error() const {
        return static_cast<mip_error>(result_.error);
    }
    /** Returns the name of the code or the error, if there is one. */
    std::string_view reason() const {
        return mip_result_reason(result_);
    }
    /** Returns the C result, such as for mip_again. */
    const mip_result &c() const {
        return result_;
    }

  private:
    mip_result result_;
};

/** The outcome of a command, and its response, which is zeroed if none was received:
 * `if (r) { r->... }`. */
template <class Response = void> class [[nodiscard]] result : public basic_result {
  public:
    result(const mip_result &of, const Response &response) : basic_result(of), response_(response) {
    }
    const Response &operator*() const {
        return response_;
    }
    const Response *operator->() const {
        return &response_;
    }
    Response &operator*() {
        return response_;
    }
    Response *operator->() {
        return &response_;
    }

  private:
    Response response_;
};

/** The outcome of a command without a response, or of any command. */
template <> class [[nodiscard]] result<void> : public basic_result {
  public:
    using basic_result::basic_result;
    result(const basic_result &of) : basic_result(of) {
    }
};

/** Writes "refused, unknown_command" to a stream such as std::ostream. */
template <class Stream, class Response>
auto operator<<(Stream &out, const result<Response> &of)
    -> decltype(static_cast<Stream &>(out << std::string_view())) {
    out << of.outcome();
    return of.reason().empty() ? out : static_cast<Stream &>(out << ", " << of.reason());
}

/* --------------------------------------------------------------------------------------- commands
 */

/** The response to the command with this C structure; the headers of commands specialize it. */
template <class Command> struct exchange;

/** Specializes `exchange` for a structure. */
#define MIP_COMMAND_OF(type, answer)           \
    template <> struct exchange<::type> {      \
        using response = answer;               \
        static const mip_exchange &answers() { \
            return ::type##_exchange;          \
        }                                      \
        static const mip_command &command() {  \
            return ::type##_command;           \
        }                                      \
    };

/** Defines `change` for a command: the command that writes the values of a response, to read,
 * change and write them: `device.call(mip::change(*response))`. */
#define MIP_CHANGE_OF(type, response, write_from)  \
    inline ::type change(const response &values) { \
        ::type command;                            \
        return *::write_from(&command, &values);   \
    }

namespace detail {

/** The response to a command, which may be a C structure. */
template <class T, class = void> struct answer {
    using type = typename exchange<T>::response;
};
template <class T> struct answer<T, std::void_t<typename T::command>> {
    using type = typename T::response;
};

} // namespace detail

/** A command whose data is always the same: none, or only the function selector. */
template <class Command, class Response, std::uint8_t... Function> struct fixed_command {
    using command = Command;
    using response = Response;

    /** Sends it, and waits for the reply. */
    mip_result call(mip_device *device) const {
        return mip_device_send(device, &exchange<Command>::answers(), data, sizeof...(Function));
    }
    template <class T> mip_result call(mip_device *device, T *to) const {
        c_type<T> *answer = to;
        return mip_device_request(device, &exchange<Command>::answers(), data, sizeof...(Function),
                                  &traits<T>::codec(), answer);
    }
    /** Fills the C structure. */
    const command *fill(command *to) const {
        *to = {};
        ((to->function = Function), ...);
        return to;
    }

  private:
    static constexpr std::uint8_t data[] = {Function..., 0};
};

/* ----------------------------------------------------------------------------------------- ports
 */

#ifdef __cpp_lib_concepts
/** The port of a device, and a clock. */
template <class T>
concept port = requires(T &way, span<std::uint8_t> room, bytes packet) {
    /* Reads what has arrived, perhaps 0 bytes; has no value if the port is lost. */
    { way.read(room) } -> std::convertible_to<std::optional<std::size_t>>;
    /* Sends all bytes; false if that failed. */
    { way.write(packet) } -> std::convertible_to<bool>;
    /* Milliseconds, which may wrap around. */
    { way.now() } -> std::convertible_to<std::uint32_t>;
};
#define MIP_PORT_TYPE ::mip::port
#else
#define MIP_PORT_TYPE class
#endif

namespace detail {
/* The device's `waits` for a port that has the function, else null. */
template <class Port>
auto waits_of(int)
    -> std::enable_if_t<sizeof(std::declval<Port &>().waits()) != 0, bool (*)(void *)> {
    return
        [](void *user) noexcept { return static_cast<bool>(static_cast<Port *>(user)->waits()); };
}
template <class Port> std::nullptr_t waits_of(...) {
    return nullptr;
}
} // namespace detail

/**
 * Returns a C port that calls your object, which must outlive the device and have
 * `std::optional<std::size_t> read(mip::span<std::uint8_t> room)`, `bool write(mip::bytes packet)`
 * and `std::uint32_t now()`. They do what the functions of struct mip_port do. For a line such as
 * UDP, also `bool waits()`: see struct mip_device. An exception from any of them ends the program.
 */
template <MIP_PORT_TYPE Port> mip_port port_of(Port &port) {
    return {[](void *user, std::uint8_t *to, std::size_t size, std::size_t *count) noexcept {
                const std::optional<std::size_t> read =
                    static_cast<Port *>(user)->read(span<std::uint8_t>(to, size));
                *count = read.value_or(0);
                return read.has_value();
            },
            [](void *user, const std::uint8_t *from, std::size_t size) noexcept {
                return static_cast<bool>(static_cast<Port *>(user)->write(bytes(from, size)));
            },
            [](void *user) noexcept {
                return static_cast<std::uint32_t>(static_cast<Port *>(user)->now());
            },
            &port};
}

/* ---------------------------------------------------------------------------------------- devices
 */

/**
 * A device at a port. It has room for `Handlers` handlers, and cannot be moved, because the C
 * library stores addresses of its parts.
 */
template <std::size_t Handlers = 8> class device {
  public:
    explicit device(const mip_port &port) {
        mip_device_init(&device_, &port, 0, entries_);
    }
    template <MIP_PORT_TYPE Port, class = std::enable_if_t<!std::is_same_v<Port, mip_port>>>
    explicit device(Port &port) : device(port_of(port)) {
        device_.waits = detail::waits_of<Port>(0);
    }
    device(const device &) = delete;
    device &operator=(const device &) = delete;

    /**
     * Registers a handler that is called with each value of type T that arrives: `(const T
     * &value)`, optionally with `const field &from`, and `std::uint32_t arrived`, the time by the
     * port's clock. Only the first handler of a field is called. It must not block, nor call the
     * device. An exception from a handler ends the program.
     *
     * The device stores a copy, so a lambda may capture at most two pointers, such as `[this]` or
     * `[&a, &b]`. If there is no room for the handler, poll returns false from then on.
     */
    template <MIP_LAYOUT_TYPE T, class Handler> void on(Handler handler) {
        on<T>(MIP_ANY_SET, handler);
    }
    /** Registers a handler for one of the descriptor sets in which the type occurs. */
    template <MIP_LAYOUT_TYPE T, class Handler>
    void on(std::uint8_t descriptor_set, Handler handler) {
        static_assert(std::is_invocable_v<Handler &, const T &> ||
                          std::is_invocable_v<Handler &, const T &, const field &> ||
                          std::is_invocable_v<Handler &, const T &, const field &, std::uint32_t>,
                      "a handler takes the value and, optionally, the field and the time");
        add(&traits<T>::codec(), descriptor_set, handler,
            [](void *user, const mip_field *from, std::uint32_t arrived) noexcept {
                T value;
                c_type<T> &to = value;
                if (mip_decode_only(&traits<T>::codec(), traits<T>::descriptor, &to, sizeof(to),
                                    from) == MIP_OK) {
                    detail::call(*std::launder(static_cast<Handler *>(user)), value, field(*from),
                                 arrived);
                }
            });
    }
    /** Registers a handler that is called with each field that has no earlier handler:
     * `(const field &from)`, optionally with the time. */
    template <class Handler> void on_other(Handler handler) {
        add(MIP_ANY_FIELD, MIP_ANY_SET, handler,
            [](void *user, const mip_field *from, std::uint32_t arrived) noexcept {
                Handler &call = *std::launder(static_cast<Handler *>(user));
                if constexpr (std::is_invocable_v<Handler &, const field &, std::uint32_t>) {
                    call(field(*from), arrived);
                } else {
                    (void)arrived;
                    call(field(*from));
                }
            });
    }

    /**
     * Observes packets: `handler(const packet &of, bool ends)` is called before the fields of each
     * packet are handled, and after that, with `ends` true. It is an object that stays at its
     * address, such as a named lambda. The same restrictions apply as to other handlers.
     */
    template <class Handler> void observe(Handler &handler) {
        static_assert(!std::is_function_v<Handler>,
                      "an observer is an object, such as a named lambda that calls the function");
        static_assert(std::is_invocable_v<Handler &, const packet &, bool>,
                      "an observer takes the packet, and whether it ends");
        observer_.packet = [](void *user, const mip_device *from, bool ends) noexcept {
            (*static_cast<Handler *>(user))(packet(*from->packet), ends);
        };
        observer_.user = const_cast<void *>(static_cast<const void *>(&handler));
        device_.observer = &observer_;
    }

    /** Finds the device and its baud rate, sets it to idle, and reads its device information into
     * `identity`. Include mip/connect.h: see mip_device_connect. */
    template <class Identity>
    result<> connect(Identity &identity,
                     bool (*set_baud)(void *user, std::uint32_t baud) = nullptr) {
        return mip_device_connect(&device_, set_baud, &identity);
    }
    /** Starts the data of a set at rates in Hz: an array of mip_rate, or a container of them.
     * Include mip/connect.h: see mip_device_stream. */
    template <class Rates> result<> stream(std::uint8_t descriptor_set, Rates &rates) {
        return mip_device_stream(&device_, descriptor_set, detail::count(rates), std::data(rates));
    }

    /** Reads once, and calls the handlers of the fields that are now complete. Returns false if the
     * port is lost, if a handler calls it, or if there were too many handlers. */
    bool poll() {
        return !full_ && mip_device_poll(&device_);
    }

    /** Sends a command, such as `write_...{}`, and waits for its reply. */
    template <class Command, class = typename Command::command>
    result<typename Command::response> call(const Command &command) {
        if constexpr (std::is_void_v<typename Command::response>) {
            return command.call(&device_);
        } else {
            typename Command::response response;
            const mip_result done = command.call(&device_, &response);
            return {done, response};
        }
    }
    /** Sends a command from its C structure, for optional parameters. */
    template <class Command, class Response = typename exchange<Command>::response>
    result<Response> call(const Command &command) {
        const mip_command &sent = exchange<Command>::command();
        if constexpr (std::is_void_v<Response>) {
            return mip_device_call(&device_, &sent, &command, nullptr, nullptr);
        } else {
            Response response;
            c_type<Response> &to = response;
            const mip_result done =
                mip_device_call(&device_, &sent, &command, &traits<Response>::codec(), &to);
            return {done, response};
        }
    }

    /** Sets the reply time-out in milliseconds: at most MIP_MAX_TIMEOUT, 24 days. */
    void timeout(std::uint32_t milliseconds) {
        device_.client.timeout = milliseconds;
    }
    /** Returns the packet whose fields are being handled; an empty one outside handlers. */
    packet current() const {
        return device_.packet != nullptr ? *device_.packet : mip_packet{nullptr, 0, 0};
    }
    /** Returns the C device, for functions that have no equivalent here. */
    mip_device &c() {
        return device_;
    }

  private:
    /** Memory for the captures of a handler. */
    struct alignas(void *) room {
        unsigned char bytes[2 * sizeof(void *)];
    };

    template <class Handler>
    void add(const mip_codec *type, std::uint8_t descriptor_set, const Handler &handler,
             void (*handle)(void *, const mip_field *, std::uint32_t)) {
        static_assert(std::is_trivially_copyable_v<Handler> &&
                          std::is_trivially_destructible_v<Handler> &&
                          sizeof(Handler) <= sizeof(room) && alignof(Handler) <= alignof(room),
                      "a handler captures too much: capture a reference, or use std::ref");
        if (void *at = enter(type, descriptor_set, handle)) {
            new (at) Handler(handler);
        }
    }
    /** Does the part of `add` that all handlers share; returns the memory for the captures. */
    void *enter(const mip_codec *type, std::uint8_t descriptor_set,
                void (*handle)(void *, const mip_field *, std::uint32_t)) {
        const std::size_t next = device_.handler_count;
        if (next == Handlers) {
            full_ = true;
            return nullptr;
        }
        device_.handler_count++;
        entries_[next] = {type, descriptor_set, handle, captured_[next].bytes};
        return captured_[next].bytes;
    }

    mip_device device_;
    mip_observer observer_ = {};
    mip_handler entries_[Handlers];
    room captured_[Handlers];
    bool full_ = false;
};

} // namespace mip

#endif
