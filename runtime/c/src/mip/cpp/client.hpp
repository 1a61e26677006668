/**
 * @file
 * The command client in C++17, without input, output or a clock, for your own event loop.
 */
#ifndef MIP_CLIENT_HPP
#define MIP_CLIENT_HPP

#include "mip/cpp/device.hpp"

namespace mip {

class client;

/**
 * A command and its response: `mip::request ping(mip::base::ping{})`. It can be sent again. The
 * client must outlive it, and stores its address while it waits. A span in the command is not
 * copied: its array must exist whenever the command is sent.
 */
template <class Command> class request {
  public:
    using response = typename detail::answer<Command>::type;

    explicit request(const Command &of = {}) : command(of) {
    }
    request(const request &) = delete;
    request &operator=(const request &) = delete;
    ~request() {
        cancel();
    }

    /** Does it still wait for a reply? */
    bool waiting() const {
        return request_.result.outcome == MIP_WAITING;
    }
    /** Returns the outcome: not_sent before it is sent, waiting until the reply, closed if
     * cancelled. */
    mip::result<response> result() const {
        if constexpr (std::is_void_v<response>) {
            return request_.result;
        } else {
            return {request_.result, response_};
        }
    }
    /** Stops waiting. */
    void cancel() {
        if (client_ != nullptr) {
            mip_client_cancel(client_, &request_);
        }
    }

    /** The command that is sent. */
    Command command;

  private:
    friend client;
    using structure = typename detail::sent<Command>::structure;
    struct nothing {};

    bool add(mip_client &to, mip_builder &packet, std::uint32_t now) {
        structure room;
        const structure *value = detail::sent<Command>::fill(command, &room);
        const mip_codec *codec = nullptr;
        void *answer = nullptr;
        if constexpr (!std::is_void_v<response>) {
            codec = &traits<response>::codec();
            answer = static_cast<c_type<response> *>(&response_);
        }
        client_ = &to;
        return mip_client_send(&to, &request_, &packet, &exchange<structure>::command(), value,
                               codec, answer, now) == MIP_OK;
    }
    /** It was not sent; the error of an encoder is kept. */
    void forget(std::uint8_t error = MIP_OK) {
        cancel();
        client_ = nullptr;
        request_ = {};
        response_ = {};
        request_.result.error = error;
    }

    mip_client *client_ = nullptr;
    mip_request request_ = {};
    std::conditional_t<std::is_void_v<response>, nothing, response> response_ = {};
};

/**
 * Encodes commands in packets that you write, and finds the replies in the bytes that you read. The
 * time is in milliseconds, and may wrap around.
 */
class client {
  public:
    client() {
        mip_client_init(&client_);
        mip_parser_init(&parser_);
    }
    client(const client &) = delete;
    client &operator=(const client &) = delete;

    /**
     * Makes a packet of commands of one descriptor set. Returns the bytes to write, which the
     * client stores until the next call. They begin with a barrier if the reply to an earlier
     * command may still arrive. Requests that still wait are cancelled first. If a command cannot
     * be encoded, the bytes are empty, and the result of that request contains the error.
     */
    template <class... Commands>
    [[nodiscard]] bytes send(std::uint32_t now, request<Commands> &...requests) {
        (requests.forget(), ...);
        const mip_client before = client_;
        const std::size_t barrier = mip_client_barrier(&client_, bytes_);
        mip_builder packet;
        (void)mip_builder_start(&packet, bytes_ + barrier, MIP_MAX_PACKET, set(requests...));
        if (!(requests.add(client_, packet, now) && ...)) {
            (requests.forget(requests.request_.result.error), ...);
            client_.missed = before.missed;
            client_.behind = before.behind;
            return {};
        }
        return {bytes_, barrier + mip_builder_finish(&packet).size};
    }

    /**
     * Processes bytes as they arrive, in any pieces; pass none to only update the time. Requests
     * are answered or time out. All other fields are passed to the handlers, as in mip::dispatch.
     */
    template <class... Handlers>
    void receive(bytes piece, std::uint32_t now, Handlers &&...handlers) {
        const std::uint8_t *at = piece.data();
        std::size_t left = piece.size();
        packet found;
        while (mip_parser_next(&parser_, &at, &left, &found) ||
               mip_client_poll(&client_, &parser_, now, &found)) {
            mip_walk walk = mip_walk_packet(&found);
            mip_request *answered;
            field each;
            if (mip_client_passes(&client_, &found)) {
                continue;
            }
            while (mip_client_next(&client_, &walk, &answered, &each)) {
                if (answered == nullptr) {
                    dispatch(each, handlers...);
                }
            }
        }
    }

    /** Sets the reply time-out in milliseconds: at most MIP_MAX_TIMEOUT, 24 days. */
    void timeout(std::uint32_t milliseconds) {
        client_.timeout = milliseconds;
    }
    /** Returns the C client, for functions that have no equivalent here. */
    mip_client &c() {
        return client_;
    }
    /** Returns the parser of the received bytes. */
    mip_parser &parser() {
        return parser_;
    }

  private:
    template <class First, class... More>
    static std::uint8_t set(const request<First> &, const request<More> &...) {
        return exchange<typename detail::sent<First>::structure>::answers().descriptor_set;
    }

    mip_client client_;
    mip_parser parser_;
    std::uint8_t bytes_[MIP_MAX_BARRIER + MIP_MAX_PACKET];
};

} // namespace mip

#endif
