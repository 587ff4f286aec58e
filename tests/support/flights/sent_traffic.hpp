/// Reports on other aircraft as a receiver puts them on the bus.
#pragma once

#include <array>
#include <vector>

#include "bus/canaerospace/traffic_profile.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

inline constexpr std::uint16_t kFirstTraffic = 1840;

[[nodiscard]] inline bus::BusSettings traffic_bus() {
    bus::BusSettings settings;
    settings.traffic.first_identifier = kFirstTraffic;
    return settings;
}

/// North-east at 60 m/s and climbing, somewhere near 47 N 9.7 E.
[[nodiscard]] inline flight::TrafficReport traffic_report(std::uint32_t address, base::Time at, double latitude_deg = 47.01,
                                                          double longitude_deg = 9.72) {
    flight::TrafficReport report;
    report.address = address;
    report.callsign = {"TDV417"};
    report.place = {base::radians(latitude_deg), base::radians(longitude_deg), at, 1500.5f, 40, 20};
    report.ground_speed_mps = 60;
    report.true_track_rad = static_cast<float>(base::radians(45));
    report.climb_mps = 2.5f;
    return report;
}

/// Its messages at a time.
[[nodiscard]] inline std::vector<bus::CanFrame> traffic_frames(const flight::TrafficReport& report, std::uint8_t number,
                                                               std::uint8_t code, base::Time time, std::uint8_t node = 7) {
    std::vector<bus::CanFrame> frames(bus::kTrafficParts);
    frames.resize(bus::encode_traffic(report, {kFirstTraffic, node, number, code}, time, {frames.data(), frames.size()}));
    return frames;
}

}  // namespace tedavis::test_support
