// Asks a device at a TCP port for its name and for accelerations, in C++11.
#include "mip/3dm_commands.h"
#include "mip/base_commands.h"
#include "mip/sensor.h"

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

// A connection, closed at the end of its scope.
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

    bool read(uint8_t *bytes, size_t size, size_t *count) {
        pollfd wait = {socket_, POLLIN, 0};
        if (poll(&wait, 1, 100) <= 0) {
            return true; // nothing for a while
        }
        const ssize_t got = recv(socket_, bytes, size, 0);
        *count = got > 0 ? static_cast<size_t>(got) : 0;
        return got > 0;
    }

    bool write(const uint8_t *bytes, size_t size) {
        while (size > 0) {
            const ssize_t count = send(socket_, bytes, size, MSG_NOSIGNAL);
            if (count < 0) {
                return false;
            }
            bytes += count;
            size -= static_cast<size_t>(count);
        }
        return true;
    }

  private:
    int socket_ = -1;
};

static uint32_t milliseconds(void *) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<uint32_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

// Functions that C calls, and that call those of a class: lambdas without captures.
static mip_port port_of(Connection &connection) {
    return {[](void *user, uint8_t *bytes, size_t size, size_t *count) {
                return static_cast<Connection *>(user)->read(bytes, size, count);
            },
            [](void *user, const uint8_t *bytes, size_t size) {
                return static_cast<Connection *>(user)->write(bytes, size);
            },
            milliseconds, &connection};
}

// Throws if the command has not been carried out.
static void expect(const char *what, mip_result result) {
    if (!mip_succeeded(result)) {
        const std::string why = mip_result_reason(result);
        throw std::runtime_error(std::string(what) + ": " + mip_outcome_name(result.outcome) +
                                 (why.empty() ? "" : ", " + why));
    }
}

static void run(Connection &connection) {
    unsigned count = 0;
    const mip_handler handlers[] = {
        {&mip_sensor_scaled_accel_codec, MIP_ANY_SET,
         [](void *user, const mip_field *field, uint32_t) {
             mip_sensor_scaled_accel accel;
             if (mip_sensor_scaled_accel_decode(&accel, field) == MIP_OK) {
                 const float *a = accel.scaled_accel;
                 std::printf("%8.4f %8.4f %8.4f g\n", double(a[0]), double(a[1]), double(a[2]));
                 ++*static_cast<unsigned *>(user);
             }
         },
         &count},
    };
    const mip_port port = port_of(connection);
    mip_device device;
    mip_device_init(&device, &port, handlers, 1);

    mip_base_get_device_info_response info;
    const mip_descriptor_rate fields[] = {{MIP_SENSOR_SCALED_ACCEL_DESCRIPTOR, 100}};
    expect("idle", mip_call_base_set_idle(&device));
    expect("device information", mip_call_base_get_device_info(&device, &info));
    std::printf("%s\n", info.device_info.model_name);
    expect("format", mip_call_3dm_message_format_write(&device, MIP_SENSOR_SET, 1, fields));
    expect("stream", mip_call_3dm_data_stream_control_write(&device, MIP_SENSOR_SET, true));
    expect("resume", mip_call_base_resume(&device));
    while (count < 10) {
        if (!mip_device_poll(&device)) {
            throw std::runtime_error("the connection is lost");
        }
    }
}

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s HOST PORT\n", argv[0]);
        return 2;
    }
    try {
        Connection connection(argv[1], argv[2]);
        run(connection);
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
