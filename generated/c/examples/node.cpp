// A node in the style of ROS: reads a device at a TCP port, and publishes its data as messages.
#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/base_commands.hpp"
#include "mip/cpp/sensor.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

// A connection, closed at the end of its scope. The three
// functions below the constructor are those that a device needs.
class Connection {
  public:
    Connection(const char *host, const char *port) {
        addrinfo hints = addrinfo();
        addrinfo *found = nullptr;
        hints.ai_socktype = SOCK_STREAM;
        if (getaddrinfo(host, port, &hints, &found) == 0) {
            for (addrinfo *at = found; at != nullptr && socket_ < 0; at = at->ai_next) {
                socket_ = socket(at->ai_family, at->ai_socktype, at->ai_protocol);
                if (socket_ >= 0 && connect(socket_, at->ai_addr, at->ai_addrlen) != 0) {
                    close(socket_);
                    socket_ = -1;
                }
            }
            freeaddrinfo(found);
        }
        if (socket_ < 0) {
            throw std::runtime_error(std::string("no connection to ") + host + ":" + port);
        }
    }
    ~Connection() {
        close(socket_);
    }
    Connection(const Connection &) = delete;
    Connection &operator=(const Connection &) = delete;

    std::optional<std::size_t> read(mip::span<std::uint8_t> room) {
        pollfd wait = {socket_, POLLIN, 0};
        if (::poll(&wait, 1, 100) <= 0) {
            return 0; // nothing for a while
        }
        const ssize_t got = recv(socket_, room.data(), room.size(), 0);
        if (got <= 0) {
            return std::nullopt; // the connection is lost
        }
        return static_cast<std::size_t>(got);
    }

    bool write(mip::bytes packet) {
        return send(socket_, packet.data(), packet.size(), MSG_NOSIGNAL) ==
               static_cast<ssize_t>(packet.size());
    }

    std::uint32_t now() const {
        const auto time = std::chrono::steady_clock::now().time_since_epoch();
        return static_cast<std::uint32_t>(
            std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
    }

  private:
    int socket_ = -1;
};

// Like sensor_msgs::msg::Imu, in SI units.
struct Imu {
    std::uint32_t stamp = 0;
    double acceleration[3] = {};
    double angular_velocity[3] = {};
};

class ImuNode {
  public:
    ImuNode(Connection &connection, std::function<void(const Imu &)> publish)
        : device_(connection), publish_(std::move(publish)) {
        device_.on<mip::sensor::scaled_gyro>([this](const auto &gyro) {
            for (int i = 0; i < 3; i++) {
                imu_.angular_velocity[i] = double(gyro.scaled_gyro[i]);
            }
        });
        // This is the last field of each packet, so the message is complete.
        device_.on<mip::sensor::scaled_accel>(
            [this](const auto &accel, const mip::field &, std::uint32_t arrived) {
                for (int i = 0; i < 3; i++) {
                    imu_.acceleration[i] = 9.80665 * double(accel.scaled_accel[i]);
                }
                imu_.stamp = arrived;
                publish_(imu_);
            });
    }

    // Throws if the device rejects a command.
    std::string configure(std::uint16_t decimation) {
        const mip::descriptor_rate fields[] = {
            {mip::descriptor<mip::sensor::scaled_gyro>, decimation},
            {mip::descriptor<mip::sensor::scaled_accel>, decimation},
        };
        expect("idle", device_.call(mip::base::set_idle{}));
        const auto information = device_.call(mip::base::get_device_info{});
        expect("device information", information);
        expect("format", device_.call(mip::mip_3dm::write_message_format{mip::sensor_set, fields}));
        expect("stream",
               device_.call(mip::mip_3dm::write_data_stream_control{mip::sensor_set, true}));
        expect("resume", device_.call(mip::base::resume{}));
        return std::string(mip::text(information->device_info.model_name));
    }

    bool spin_once() {
        return device_.poll();
    }

  private:
    template <class Response>
    static void expect(const char *what, const mip::result<Response> &result) {
        if (!result) {
            throw std::runtime_error(std::string(what) + ": " + to_string(result.outcome()).data() +
                                     " " + std::string(result.reason()));
        }
    }

    mip::device<2> device_;
    std::function<void(const Imu &)> publish_;
    Imu imu_;
};

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s HOST PORT\n", argv[0]);
        return 2;
    }
    try {
        Connection connection(argv[1], argv[2]);
        int count = 0;
        ImuNode node(connection, [&](const Imu &imu) {
            const double *a = imu.acceleration;
            std::printf("%8.4f %8.4f %8.4f m/s^2\n", a[0], a[1], a[2]);
            count++;
        });
        std::printf("%s\n", node.configure(100).c_str());
        while (count < 10) {
            if (!node.spin_once()) {
                throw std::runtime_error("the connection is lost");
            }
        }
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
