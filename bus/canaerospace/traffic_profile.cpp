#include "bus/canaerospace/traffic_profile.hpp"

#include <cmath>
#include <cstdio>

#include "bus/canaerospace/identifier_table.hpp"
#include "bus/canaerospace/message_header.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::bus {
namespace {

constexpr std::uint32_t kAnalogue = type_bit(DataType::float32) | type_bit(DataType::short16x2);
constexpr std::size_t kLetters = 4;  // of a callsign, in a message
constexpr double kLargestAddress = 0xFFFFFF;

constexpr TrafficPartEntry kParts[kTrafficParts] = {
    {"Traffic_address", "", type_bit(DataType::ulong32), 1, kLargestAddress},
    {"Traffic_callsign_1_to_4", "", type_bit(DataType::achar8x4), 0, 0xFFFFFFFF},
    {"Traffic_callsign_5_to_8", "", type_bit(DataType::achar8x4), 0, 0xFFFFFFFF},
    {"Traffic_latitude", "deg", type_bit(DataType::long32), -90, 90},
    {"Traffic_longitude", "deg", type_bit(DataType::long32), -180, 180},
    {"Traffic_ellipsoid_height", "m", kAnalogue, -1000, 40000},
    {"Traffic_ground_speed", "m/s", kAnalogue, 0, 700},
    {"Traffic_true_track", "deg", kAnalogue, -180, 360},
    {"Traffic_vertical_speed", "m/s", kAnalogue, -200, 200},
    {"Traffic_position_deviation", "m", kAnalogue, 0, 50000},
    {"Traffic_height_deviation", "m", kAnalogue, 0, 5000},
    {"Traffic_age", "s", kAnalogue, 0, 60},
};

bool is_callsign(TrafficPart part) { return part == TrafficPart::callsign_begin || part == TrafficPart::callsign_end; }
bool is_angle(TrafficPart part) {
    return part == TrafficPart::latitude || part == TrafficPart::longitude || part == TrafficPart::true_track;
}
bool is_letter(std::int64_t code) { return (code >= 'A' && code <= 'Z') || (code >= '0' && code <= '9') || code == ' '; }

bool decode_letters(const TypedValue& value, double& number) {
    std::uint32_t bits = 0;
    for (std::size_t n = 0; n < kLetters; ++n) {
        if (!is_letter(value.parts[n])) return false;
        bits = bits << 8 | static_cast<std::uint32_t>(value.parts[n]);
    }
    number = bits;
    return true;
}

/// Without the blanks that fill it up. What stands behind a blank belongs to no callsign.
base::FixedString<8> callsign_of(double begin, double end) {
    char letters[2 * kLetters];
    std::size_t count = 0;
    for (const double half : {begin, end})
        for (unsigned shift = 32; shift > 0; shift -= 8)
            letters[count++] = static_cast<char>(static_cast<std::uint32_t>(half) >> (shift - 8) & 0xFFu);
    const std::string_view all(letters, count);
    return {all.substr(0, all.find(' '))};
}

TypedValue letters_of(const flight::TrafficReport& report, std::size_t first) {
    TypedValue value{DataType::achar8x4, kLetters, 0, {}};
    const std::string_view callsign = report.callsign.view();
    for (std::size_t n = 0; n < kLetters; ++n)
        value.parts[n] = first + n < callsign.size() ? static_cast<unsigned char>(callsign[first + n]) : ' ';
    return value;
}

TypedValue long_of(double rad) { return {DataType::long32, 1, 0, {std::llround(base::degrees(rad) / kDegreesPerLongUnit)}}; }

TypedValue float_of(double number) { return {DataType::float32, 1, static_cast<float>(number), {}}; }
TypedValue float_of(float number) { return {DataType::float32, 1, number, {}}; }

TypedValue value_of(TrafficPart part, const flight::TrafficReport& report, base::Time time) {
    switch (part) {
        case TrafficPart::address: return {DataType::ulong32, 1, 0, {report.address}};
        case TrafficPart::callsign_begin: return letters_of(report, 0);
        case TrafficPart::callsign_end: return letters_of(report, kLetters);
        case TrafficPart::latitude: return long_of(report.place.latitude_rad);
        case TrafficPart::longitude: return long_of(report.place.longitude_rad);
        case TrafficPart::height: return float_of(report.place.height_m);
        case TrafficPart::ground_speed: return float_of(report.ground_speed_mps);
        case TrafficPart::true_track: return float_of(base::degrees(static_cast<double>(report.true_track_rad)));
        case TrafficPart::climb: return float_of(report.climb_mps);
        case TrafficPart::position_deviation: return float_of(report.place.position_deviation_m);
        case TrafficPart::height_deviation: return float_of(report.place.height_deviation_m);
        case TrafficPart::age: return float_of((time - report.place.at).to_seconds());
        case TrafficPart::count: break;
    }
    return {};
}

}  // namespace

const TrafficPartEntry& traffic_part_entry(TrafficPart part) noexcept { return kParts[static_cast<std::size_t>(part)]; }

bool decode_traffic_part(TrafficPart part, const TypedValue& value, double& number) noexcept {
    if (is_callsign(part)) return decode_letters(value, number);
    const TrafficPartEntry& entry = traffic_part_entry(part);
    double stated = number_of(value);
    if (value.type == DataType::long32) stated *= kDegreesPerLongUnit;
    if (!(stated >= entry.low && stated <= entry.high)) return false;  // which a NaN is not
    number = is_angle(part) ? base::radians(stated) : stated;
    return true;
}

flight::TrafficReport traffic_report(const TrafficNumbers& numbers, base::Time received) noexcept {
    const auto number = [&](TrafficPart part) { return numbers[static_cast<std::size_t>(part)]; };
    const auto real = [&](TrafficPart part) { return static_cast<float>(number(part)); };
    flight::TrafficReport report;
    report.address = static_cast<std::uint32_t>(number(TrafficPart::address));
    report.callsign = callsign_of(number(TrafficPart::callsign_begin), number(TrafficPart::callsign_end));
    report.place = {number(TrafficPart::latitude),
                    earth::wrap_longitude(number(TrafficPart::longitude)),
                    received - base::Duration::from_seconds(number(TrafficPart::age)),
                    real(TrafficPart::height),
                    real(TrafficPart::position_deviation),
                    real(TrafficPart::height_deviation)};
    report.ground_speed_mps = real(TrafficPart::ground_speed);
    report.true_track_rad = static_cast<float>(earth::wrap_heading(number(TrafficPart::true_track)));
    report.climb_mps = real(TrafficPart::climb);
    return report;
}

std::size_t encode_traffic(const flight::TrafficReport& report, const TrafficSender& sender, base::Time time,
                           base::Span<CanFrame> out) noexcept {
    if (out.size() < kTrafficParts || sender.number >= kTrafficNumbers) return 0;
    for (std::size_t n = 0; n < kTrafficParts; ++n) {
        const auto part = static_cast<TrafficPart>(n);
        const TypedValue value = value_of(part, report, time);
        double accepted = 0;
        if (!decode_traffic_part(part, value, accepted)) return 0;
        CanFrame& frame = out[n];
        frame = CanFrame();
        frame.time = time;
        set_message_id(frame, static_cast<std::uint16_t>(sender.first_identifier + n), 0);
        write_header(frame, {sender.node, static_cast<std::uint8_t>(value.type), sender.number, sender.code});
        frame.length =
            static_cast<std::uint8_t>(kMessageHeaderBytes + encode_value(value, frame.data.data() + kMessageHeaderBytes));
    }
    return kTrafficParts;
}

}  // namespace tedavis::bus
