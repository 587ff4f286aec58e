/// Reports of other aircraft on CANaerospace: this project's own profile in the user-defined identifiers, sent by a receiver
/// (ADS-B, for example). configs/buses/README.md specifies it for the sender.
///
/// A report is twelve messages with consecutive identifiers from the bus file's first one on, in the order of TrafficPart. The
/// service code is the sender's number of the aircraft (the standard numbers waypoints in the same way). The message code
/// counts the reports with this number, so that all parts of one report have the same code. Pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/canaerospace/data_type.hpp"
#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/traffic.hpp"

namespace tedavis::bus {

enum class TrafficPart : std::uint8_t {
    address,
    callsign_begin,
    callsign_end,
    latitude,
    longitude,
    height,
    ground_speed,
    true_track,
    climb,
    position_deviation,
    height_deviation,
    age,
    count
};
inline constexpr std::size_t kTrafficParts = static_cast<std::size_t>(TrafficPart::count);
static_assert(kTrafficParts == kTrafficIdentifiers);
inline constexpr std::uint8_t kTrafficNumbers = 32;  ///< a sender's numbers are 0 .. 31

struct TrafficPartEntry {
    const char* name;
    const char* unit;     ///< on the bus
    std::uint32_t types;  ///< bit n: data type n is accepted
    double low, high;     ///< plausible values in that unit; others are refused
};
[[nodiscard]] const TrafficPartEntry& traffic_part_entry(TrafficPart part) noexcept;

/// Decodes a part into SI units, radians or seconds; four letters of a callsign are returned as their bits. Returns false where
/// the value is implausible or not a number.
[[nodiscard]] bool decode_traffic_part(TrafficPart part, const TypedValue& value, double& number) noexcept;

/// Builds a report from the decoded parts. `received` is the receive time of the first part.
using TrafficNumbers = std::array<double, kTrafficParts>;
[[nodiscard]] flight::TrafficReport traffic_report(const TrafficNumbers& numbers, base::Time received) noexcept;

/// Who sends a report.
struct TrafficSender {
    std::uint16_t first_identifier = 0;
    std::uint8_t node = 0;
    std::uint8_t number = 0;  ///< of the aircraft, 0 .. kTrafficNumbers - 1
    std::uint8_t code = 0;    ///< of the report
};
/// Writes kTrafficParts frames stamped `time`; the report's age is relative to `time`. Returns the number of frames, 0 where
/// the span is too short or a part would not be accepted.
std::size_t encode_traffic(const flight::TrafficReport& report, const TrafficSender& sender, base::Time time,
                           base::Span<CanFrame> out) noexcept;

}  // namespace tedavis::bus
