// What C++ adds, used as a program would.
#include "mip/connect.h"
#include "mip/cpp/mip.hpp"
#include "mip/extra/ostream.hpp"
#include "mip/extra/profiles.h"
#include "mip/extra/rejected.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                                       \
            std::exit(1);                                                                                              \
        }                                                                                                              \
    } while (false)

namespace {

using mip::sensor::scaled_accel;
using fix_info = mip::gnss_data::fix_info;

// Printed in a manual: an acceleration whose last number is not a number.
const std::uint8_t ACCEL[] = {0x75, 0x65, 0x80, 0x0E, 0x0E, 0x04, 0x3E, 0x7A, 0x63, 0xA0,
                              0xBB, 0x8E, 0x3B, 0x29, 0x7F, 0xE5, 0xBF, 0x7F, 0x84, 0xEE};

template <class... Values> std::string shown(const Values &...values) {
    std::ostringstream out;
    (out << ... << values);
    return out.str();
}

// --------------------------------------------------------------------------------- types

static_assert(mip::descriptor<scaled_accel> == 0x04 && mip::traits<scaled_accel>::key == 0x8004);
static_assert(mip::traits<scaled_accel>::name == "sensor.scaled_accel");
static_assert(std::is_void_v<std::iterator_traits<mip::packet::iterator>::pointer>);
static_assert(std::is_trivially_copyable_v<fix_info> && sizeof(fix_info) == sizeof(mip_gnss_data_fix_info));
static_assert(sizeof(mip::mip_3dm::pps_source) == 1);
static_assert(mip::sensor_set == 0x80 && mip::gnss_2_set == 0x92);
#ifdef __cpp_concepts
static_assert(mip::layout<scaled_accel> && !mip::layout<int>);
#endif

void enumerations() {
    using mip::gnss_fix_type;
    CHECK(to_string(gnss_fix_type::fix_3d) == "fix_3d" && to_string(static_cast<gnss_fix_type>(99)).empty());
    CHECK(shown(gnss_fix_type::fix_3d, ' ', static_cast<gnss_fix_type>(99)) == "fix_3d 99");
    CHECK(mip::to_string(MIP_ERROR_TRUNCATED) == "truncated");
    CHECK(shown(mip::outcome::timed_out) == "timed out");
}

void flags() {
    using valid = mip::gnss_data::llh_position_flags;
    valid some = valid::lat_lon | valid::horizontal_accuracy;
    CHECK(mip::has(some, valid::lat_lon) && !mip::has(some, valid::lat_lon | valid::msl_height));
    CHECK(shown(some) == "lat_lon | horizontal_accuracy" && to_string(valid::lat_lon) == "lat_lon");
    some &= ~valid::lat_lon;
    CHECK(some == valid::horizontal_accuracy && to_string(valid{}).empty() && shown(valid{}) == "0");
    CHECK(shown(static_cast<valid>(0x8001)) == "lat_lon | 32768");
    using rtk = mip::rtk_status_flags;
    CHECK(mip::get(static_cast<rtk>(MIP_RTK_STATUS_FLAGS_RSSI), rtk::rssi) == 0xFF);
    mip::gq7_continuous_built_in_test test = {};
    mip_set_bits(test.bytes, MIP_BITS(127, 1), 1);
    using bits = mip::gq7_continuous_built_in_test_bits;
    CHECK(!mip::has(test, static_cast<bits>(1 << 8)) && mip::get(test, static_cast<bits>(127 | 1 << 8)) == 1);
    mip::system_data::built_in_test sent = {};
    std::memcpy(sent.result, test.bytes, sizeof(sent.result));
    CHECK(!mip::has(sent.result, static_cast<bits>(1 << 8)) && mip::get(sent.result, static_cast<bits>(127 | 1 << 8)) == 1);
}

void spans() {
    const std::vector<float> numbers = {1, 2, 3};
    const mip::span<const float> all = numbers;
    float sum = 0;
    for (const float each : all) {
        sum += each;
    }
    CHECK(sum == 6 && all.size() == 3 && all[2] == 3 && !all.empty());
    CHECK(mip::detail::count(std::vector<char>(300)) == 255);
    const float fixed[3] = {1, 2, 3};
    CHECK(mip::span(fixed).size() == 3 && mip::span(fixed).end()[-1] == 3);
    const char name[4] = {'a', 'b', 0, 'c'};
    const char full[2] = {'a', 'b'};
    CHECK(mip::text(name) == "ab" && mip::text(full) == "ab");
#ifdef __cpp_lib_span
    const std::span<const float> same = all;
    CHECK(same.data() == numbers.data() && mip::span<const float>(same).size() == 3);
#endif
}

// --------------------------------------------------------------------------------- packets

void fields() {
    const auto packet = mip::packet::from(ACCEL);
    CHECK(packet && !mip::packet::from({ACCEL, 19}));
    int count = 0;
    for (const mip::field &field : *packet) {
        const auto accel = field.as<scaled_accel>();
        CHECK(accel && field.is<scaled_accel>() && field.key() == mip::traits<scaled_accel>::key);
        CHECK(accel->scaled_accel[0] > 0.2445F && accel->scaled_accel[0] < 0.2446F);
        CHECK(!field.as<mip::sensor::scaled_gyro>() && field.bytes().size() == 12);
        count++;
    }
    CHECK(count == 1);
    CHECK(shown(*packet).find("scaled_accel") != std::string::npos);
    const std::uint8_t bad[] = {0x75, 0x65, 0x80, 4, 2, 0x04, 9, 0x04, 0x73, 0xD2}; // its second length is wrong
    const mip::packet malformed(mip_packet{bad, sizeof(bad), 0x80});
    auto at = malformed.begin();
    CHECK(at != malformed.end() && at.error() == MIP_OK);
    ++at;
    CHECK(at == malformed.end() && at.error() == MIP_ERROR_FIELD_LENGTH);
}

void streams() {
    std::vector<std::uint8_t> stream = {'$', 'G', 'u', 'e', 0x80, 0xFF}; // noise that looks like a packet
    for (int i = 0; i < 3; i++) {
        stream.insert(stream.end(), ACCEL, ACCEL + sizeof(ACCEL));
    }
    mip::packets all(stream);
    int count = 0;
    for (const mip::packet &packet : all) {
        CHECK(packet.size == sizeof(ACCEL) && std::memcmp(packet.bytes, ACCEL, sizeof(ACCEL)) == 0);
        count++;
    }
    CHECK(count == 3 && all.skipped() == 6);
    mip::parser parser;
    for (std::size_t at = 0; at < stream.size(); at += 7) {
        for (const mip::packet &packet : parser.feed({&stream[at], stream.size() - at < 7 ? stream.size() - at : 7})) {
            CHECK(packet.size == sizeof(ACCEL));
            count++;
        }
    }
    CHECK(count == 3); // the noise holds them back
    for (const mip::packet &packet : parser.flush()) {
        CHECK(packet.descriptor_set == mip::sensor_set);
        count++;
    }
    CHECK(count == 6);
}

void function(const mip::sensor::scaled_gyro &) {
}

void dispatching() {
    mip::builder builder(mip::gnss_2_set);
    fix_info info = {};
    info.c_type::fix_type = MIP_GNSS_FIX_TYPE_FIX_3D;
    CHECK(builder.add(info) == MIP_OK && builder.add(0x7E, {ACCEL, 2}) == MIP_OK);
    CHECK(builder.add(scaled_accel{}) == MIP_ERROR_SET && builder.error() == MIP_ERROR_SET);
    const mip::packet packet = builder.finish();
    int infos = 0, others = 0;
    mip::dispatch(
        packet, function, [&](const scaled_accel &) { CHECK(false); },
        [&infos](const fix_info &value, const mip::field &from) mutable noexcept {
            infos += value.fix_type() == mip::gnss_fix_type::fix_3d && from.descriptor_set == 0x92;
        },
        [&](const fix_info &) { CHECK(false); }, // only the first one is called
        [&](const mip::field &other) { others += other.descriptor; });
    CHECK(infos == 1 && others == 0x7E);
    CHECK(!mip::dispatch(*packet.begin(), [](const scaled_accel &) {}));
}

void layouts_of_one_descriptor() {
    using basic = mip::mip_3dm::device_status_basic_response;
    using other = mip::mip_3dm::device_status_basic_gx3_response;
    static_assert(mip::traits<basic>::key == mip::traits<other>::key);
    mip::builder builder(mip::mip_3dm_set);
    CHECK(builder.add(other{}) == MIP_OK);
    int count = 0;
    mip::dispatch(
        builder.finish(), [](const basic &) { CHECK(false); }, [&](const other &) { count++; });
    CHECK(count == 1);
}

// --------------------------------------------------------------------------------- a device

// Answers each packet that is written with the next of these.
struct Port {
    std::vector<std::vector<std::uint8_t>> answers;
    std::vector<std::uint8_t> written, coming;
    std::uint32_t time = 0;

    std::optional<std::size_t> read(mip::span<std::uint8_t> room) {
        time += 100;
        if (coming.empty() && answers.empty()) {
            return std::nullopt;
        }
        CHECK(coming.size() <= room.size());
        const std::size_t size = coming.size();
        std::copy(coming.begin(), coming.end(), room.begin());
        coming.clear();
        return size;
    }
    bool write(mip::bytes packet) {
        written.assign(packet.begin(), packet.end());
        coming = answers.front();
        answers.erase(answers.begin());
        return true;
    }
    std::uint32_t now() const {
        return time;
    }
};

// An acknowledge, and a field behind it.
template <class... Response>
std::vector<std::uint8_t> answer(std::uint8_t set, std::uint8_t descriptor, mip::ack_code code, const Response &...response) {
    mip::builder builder(set);
    mip::acknowledge acknowledge = {};
    acknowledge.command = descriptor;
    acknowledge.c_type::code = mip::number(code);
    CHECK(builder.add(acknowledge) == MIP_OK && ((builder.add(response) == MIP_OK) && ...));
    const mip::packet made = builder.finish();
    return {made.bytes, made.bytes + made.size};
}

struct Counter {
    int values = 0, others = 0;
    std::uint32_t arrived = 0;
};

void calls() {
    using namespace mip::mip_3dm;
    Port port;
    mip::device device(port);
    pps_source_control_response gpio = {};
    gpio.c_type::source = MIP_3DM_PPS_SOURCE_GPIO;
    const auto ok = mip::ack_code::ok;
    port.answers = {{0x75, 0x65, 0x01, 0x04, 0x04, 0xF1, 0x01, 0x00, 0xD5, 0x6A},
                    answer(0x0C, MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR, ok, gpio),
                    answer(0x0C, MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR, ok),
                    answer(0x0C, MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR, mip::ack_code::invalid_parameter),
                    answer(0x0C, MIP_3DM_MESSAGE_FORMAT_DESCRIPTOR, ok),
                    answer(0x0C, MIP_3DM_MESSAGE_FORMAT_DESCRIPTOR, ok),
                    {}};
    const mip::result<> ping = device.call(mip::base::ping{});
    CHECK(ping && ping.outcome() == mip::outcome::acknowledged && ping.reason().empty());
    CHECK((port.written == std::vector<std::uint8_t>{0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6})); // from a manual
    const mip::result<pps_source_control_response> read = device.call(read_pps_source_control{});
    CHECK(read && read->source() == pps_source::gpio && (*read).source() == pps_source::gpio);
    const mip::result<> &any = read; // of any response
    CHECK(any && any.outcome() == mip::outcome::acknowledged);
    auto command = mip::change(*read);
    CHECK(command.source == mip::number(pps_source::gpio));
    command.source = mip::number(pps_source::disabled);
    CHECK(device.call(command) && port.written[7] == MIP_3DM_PPS_SOURCE_DISABLED);
    const auto refused = device.call(write_pps_source_control{pps_source::gpio});
    CHECK(!refused && refused.outcome() == mip::outcome::refused);
    CHECK(refused.code() == mip::ack_code::invalid_parameter);
    CHECK(shown(refused) == "refused, invalid_parameter");
    mip_retry retry = {2, 1U << MIP_REFUSED};
    CHECK(mip_again(&retry, refused.c()));

    // A span, and the same with the builder and with the structure of C.
    const mip::descriptor_rate rates[] = {{4, 10}, {5, 1000}};
    const write_message_format format = {mip::sensor_set, rates};
    CHECK(device.call(format));
    mip::builder builder(mip::mip_3dm_set);
    CHECK(builder.add(format) == MIP_OK);
    const mip::packet made = builder.finish();
    CHECK(std::vector<std::uint8_t>(made.bytes, made.bytes + made.size) == port.written);
    mip_3dm_message_format whole;
    format.fill(&whole);
    port.written.clear();
    CHECK(device.call(whole) && std::vector<std::uint8_t>(made.bytes, made.bytes + made.size) == port.written);
    const std::vector<mip::descriptor_rate> many(300);
    const auto unsent = device.call(write_message_format{mip::sensor_set, many});
    CHECK(!unsent && unsent.outcome() == mip::outcome::not_sent && unsent.error() == MIP_ERROR_COUNT);
    device.timeout(300);
    CHECK(device.call(mip::base::ping{}).outcome() == mip::outcome::closed);
}

void handlers() {
    Port port;
    mip::device<3> device(port);
    Counter counter;
    device.on<scaled_accel>([&counter, &port](const scaled_accel &, const mip::field &, std::uint32_t arrived) {
        counter.values++;
        counter.arrived = arrived;
        CHECK(arrived == port.time);
    });
    const auto large = [a = &counter, b = &counter, c = &counter, &device](const fix_info &) {
        a->values += b == c;
        CHECK(device.current().descriptor_set == mip::gnss_2_set);
    };
    device.on<fix_info>(mip::gnss_2_set, std::ref(large));
    device.on_other([&counter](const mip::field &) { counter.others++; });
    int begun = 0, ended = 0;
    const auto observer = [&](const mip::packet &packet, bool ends) {
        CHECK(packet.bytes == device.current().bytes && packet.begin() != packet.end());
        (ends ? ended : begun)++;
    };
    device.observe(observer);

    port.coming.assign(ACCEL, ACCEL + sizeof(ACCEL));
    for (const std::uint8_t set : {mip::gnss_1_set, mip::gnss_2_set}) {
        mip::builder builder(set);
        CHECK(builder.add(fix_info{}) == MIP_OK);
        const mip::packet packet = builder.finish();
        port.coming.insert(port.coming.end(), packet.bytes, packet.bytes + packet.size);
    }
    CHECK(device.poll() && counter.values == 2 && counter.others == 1 && counter.arrived == 100);
    CHECK(device.current().size == 0 && begun == 3 && ended == 3);
    CHECK(!device.poll()); // the port is gone

    Port another;
    another.answers = {{}};
    mip::device<1> small(another);
    small.on_other([](const mip::field &) {});
    CHECK(small.poll());
    small.on_other([](const mip::field &) {});
    CHECK(!small.poll()); // there is no room for a second one
}

void connecting() {
    using namespace mip::mip_3dm;
    const auto ok = mip::ack_code::ok;
    Port port;
    mip::device device(port);
    mip::base::get_device_info_response given = {}, info;
    given.device_info.firmware_version = 1042;
    get_base_rate_response base = {};
    base.rate = 1000;
    port.answers = {answer(0x01, 0x01, ok), answer(0x01, 0x02, ok), answer(0x01, 0x03, ok, given),
                    answer(0x0C, 0x0E, ok, base), answer(0x0C, 0x0F, ok), answer(0x0C, 0x11, ok),
                    answer(0x01, 0x06, ok), answer(0x0C, 0x0E, ok, base)};
    CHECK(device.connect(info) && info.device_info.firmware_version == 1042);
    std::vector<mip_rate> rates = {{mip::descriptor<scaled_accel>, 100, 0}};
    CHECK(device.stream(mip::sensor_set, rates) && rates[0].nearest == 100);
    mip_rate odd[] = {{mip::descriptor<scaled_accel>, 300, 0}};
    CHECK(device.stream(mip::sensor_set, odd).outcome() == mip::outcome::no_such_rate);
    rates.resize(300);
    CHECK(device.stream(mip::sensor_set, rates).error() == MIP_ERROR_COUNT);
}

void client_without_a_port() {
    using namespace mip::mip_3dm;
    const auto ok = mip::ack_code::ok;
    pps_source_control_response gpio = {};
    gpio.c_type::source = MIP_3DM_PPS_SOURCE_GPIO;
    mip::client client;
    mip::request pps(read_pps_source_control{});
    mip::request stream(write_data_stream_control{mip::sensor_set, true});
    mip::request ping(mip::base::ping{});
    CHECK(!pps.waiting() && pps.result().outcome() == mip::outcome::not_sent);

    // Two commands in one packet, the same as a builder makes, without a barrier.
    const mip::bytes both = client.send(0, pps, stream);
    mip::builder builder(mip::mip_3dm_set);
    CHECK(builder.add(pps.command) == MIP_OK && builder.add(stream.command) == MIP_OK);
    const mip::packet made = builder.finish();
    CHECK(both.size() == made.size && std::memcmp(both.data(), made.bytes, made.size) == 0 && pps.waiting());
    auto coming = answer(0x0C, MIP_3DM_PPS_SOURCE_CONTROL_DESCRIPTOR, ok, gpio);
    const auto last = answer(0x0C, MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR, mip::ack_code::invalid_parameter);
    coming.insert(coming.end(), ACCEL, ACCEL + sizeof(ACCEL));
    coming.insert(coming.end(), last.begin(), last.end());
    int values = 0, others = 0;
    for (const std::uint8_t &byte : coming) {
        client.receive({&byte, 1}, 10, [&](const scaled_accel &) { values++; }, [&](const mip::field &) { others++; });
    }
    CHECK(values == 1 && others == 0 && !pps.waiting() && !stream.waiting());
    CHECK(pps.result() && pps.result()->source() == pps_source::gpio);
    CHECK(shown(stream.result()) == "refused, invalid_parameter");

    // After a time-out, a barrier precedes the next command; what is answered before the barrier is late.
    CHECK(client.send(20, ping).size() == 8);
    client.timeout(300);
    client.receive({}, 1019);
    CHECK(ping.waiting());
    client.receive({}, 1020);
    CHECK(ping.result().outcome() == mip::outcome::timed_out);
    CHECK(client.send(1030, stream).size() > 13);
    client.receive(answer(0x0C, MIP_3DM_DATA_STREAM_CONTROL_DESCRIPTOR, ok), 1040); // late: it is not for this one
    CHECK(stream.waiting());
    client.receive({}, 1330);
    CHECK(stream.result().outcome() == mip::outcome::timed_out);

    // One that does not fit: nothing is sent, and nothing of it waits.
    const std::vector<mip::descriptor_rate> many(300);
    mip::request format(write_message_format{mip::sensor_set, many});
    CHECK(client.send(2000, pps, format).empty() && !pps.waiting() && !format.waiting());
    CHECK(mip::number(pps.result()->source()) == 0); // not that of the last time
    CHECK(format.result().error() == MIP_ERROR_COUNT && client.c().waiting == nullptr);
    // A command of another set than the first.
    CHECK(client.send(2000, ping, pps).empty() && pps.result().error() == MIP_ERROR_SET);
    {
        mip::request<mip_base_get_device_info> gone; // a structure of C
        CHECK(!client.send(3000, gone).empty() && client.c().waiting != nullptr);
    }
    CHECK(client.c().waiting == nullptr);
    // For one of several responses, in which the function and the selector are fixed.
    mip::client other;
    mip::request status(for_device_status_basic_response{6251});
    CHECK(other.send(0, status).size() == 11);
    other.receive(answer(0x0C, MIP_3DM_DEVICE_STATUS_DESCRIPTOR, ok, device_status_basic_response{}), 10);
    CHECK(status.result());
    mip::builder packet(mip::base_set);
    CHECK(packet.add(mip::base::read_for_gps_time_update_tow_response{}) == MIP_OK);
}

void rejected_fields() {
    const mip_known_device known = {&mip_profile_cv7_ar, nullptr, 0};
    const mip::descriptor_rate rates[] = {{0x04, 1}, {0x06, 1}};
    const auto mag = mip::find_rejected(mip::mip_3dm::write_message_format{mip::sensor_set, rates}, known);
    char text[60], part[10];
    CHECK(mag && mag.why() == mip::rejection::absent && mag.index == 1 && mag.descriptor == 0x06);
    CHECK(mag.text(text, known).substr(0, 10) == "3DM-CV7-AR" && mag.text(part, known) == "3DM-CV7-A");
    CHECK(!mip::find_rejected(mip::base::ping{}, known)); // it lists no fields
    const auto older = mip::find_rejected(mip::mip_3dm::write_message_format{mip::filter_data_set, rates}, {&mip_profile_gx5_15, nullptr, 0});
    CHECK(older.why() == mip::rejection::other_command && older.descriptor == MIP_3DM_FILTER_MESSAGE_FORMAT_DESCRIPTOR);
}

} // namespace

int main() {
    rejected_fields();
    enumerations();
    flags();
    spans();
    fields();
    streams();
    dispatching();
    layouts_of_one_descriptor();
    calls();
    handlers();
    connecting();
    client_without_a_port();
    return 0;
}
