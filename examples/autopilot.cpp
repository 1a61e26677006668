// A driver in the style of ArduPilot: no heap, no exceptions, no waiting. The scheduler
// calls update() at some rate; bytes are read from and written to UART buffers.
#include "mip/cpp/3dm_commands.hpp"
#include "mip/cpp/filter_data.hpp"
#include "mip/cpp/sensor.hpp"

// What the board provides.
std::size_t uart_read(std::uint8_t *bytes, std::size_t room); // received bytes, at most this many
bool uart_write(const std::uint8_t *bytes, std::size_t size); // false if there is no room
std::uint32_t board_milliseconds();

// The data that the autopilot needs.
struct Attitude {
    float roll, pitch, yaw;
    bool valid;
};

class Driver {
  public:
    // Reads received bytes. Returns true if the attitude is new.
    bool update() {
        std::uint8_t bytes[128];
        const std::size_t size = uart_read(bytes, sizeof(bytes));
        if (size > 0) {
            heard_ = board_milliseconds();
        }
        fresh_ = false;
        for (const mip::packet &packet : parser_.feed({bytes, size})) {
            take(packet);
        }
        if (!streaming_ && board_milliseconds() - asked_ >= 500) {
            ask();
        }
        return fresh_;
    }
    bool healthy() const {
        return streaming_ && board_milliseconds() - heard_ < 200;
    }
    const Attitude &attitude() const {
        return attitude_;
    }
    const float *accel() const {
        return accel_;
    }

  private:
    // Sends both commands in one packet, again and again until they are acknowledged.
    void ask() {
        const mip::descriptor_rate fields[] = {
            {mip::descriptor<mip::filter_data::euler_angles>, 5}};
        mip::builder packet(mip::mip_3dm_set);
        if (packet.add(mip::mip_3dm::write_message_format{mip::filter_data_set, fields}) ==
                MIP_OK &&
            packet.add(mip::mip_3dm::write_data_stream_control{mip::filter_data_set, true}) ==
                MIP_OK) {
            const mip::packet made = packet.finish();
            if (uart_write(made.bytes, made.size)) {
                asked_ = board_milliseconds();
            }
        }
    }

    void take(const mip::packet &packet) {
        mip::dispatch(
            packet,
            [this](const mip::filter_data::euler_angles &angles) {
                using flags = mip::filter_data::valid_flags;
                attitude_ = {angles.roll, angles.pitch, angles.yaw,
                             mip::has(angles.valid_flags(), flags::valid)};
                fresh_ = true;
            },
            [this](const mip::sensor::scaled_accel &accel) {
                for (int i = 0; i < 3; i++) {
                    accel_[i] = 9.80665F * accel.scaled_accel[i];
                }
            },
            [this](const mip::acknowledge &answer) {
                streaming_ =
                    streaming_ || (answer.command == MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR &&
                                   answer.code() == mip::ack_code::ok);
            });
    }

    mip::parser parser_;
    Attitude attitude_ = {};
    float accel_[3] = {};
    std::uint32_t heard_ = 0, asked_ = 0;
    bool fresh_ = false, streaming_ = false;
};

// The scheduler.
void attitude_task();
void attitude_task() {
    static Driver driver;
    if (driver.update() && driver.healthy() && driver.attitude().valid) {
        // use driver.attitude()
    }
}
