/// Other aircraft of a scenario, which the receiver on board reports: on a straight line or a circle, at constant speed and
/// climb; or standing first.
///
///     [[traffic]]
///     callsign = "N172TD"            letters and digits, at most eight; may be left out
///     address = "A0F12B"             of its transponder, hexadecimal
///     latitude_deg, longitude_deg, altitude_msl_m     position, varied by the seed within spread_m to each side,
///     at_s = 60                      time of this position after the start
///     track_deg, speed_mps, climb_mps
///     turn_dps = 0                   right positive
///     stands_before = false          it stands at this position until at_s
///     position_deviation_m, height_deviation_m        standard deviations that it states; 0: it states none
///     received_from_s = 0, received_until_s = 400
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/flight_log/flight_source.hpp"
#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/config_reader.hpp"

namespace tedavis::host_sim {

struct TrafficSettings {
    std::string callsign;
    std::uint32_t address = 0;
    double latitude_rad = 0, longitude_rad = 0, altitude_msl_m = 0, spread_m = 0;
    double at_s = 0;
    bool stands_before = false;
    double track_rad = 0, speed_mps = 0, climb_mps = 0, turn_radps = 0;
    double position_deviation_m = 0, height_deviation_m = 0;
    double received_from_s = 0, received_until_s = 0;
};

[[nodiscard]] TrafficSettings read_traffic(base::ConfigSection& section);

class ScenarioTraffic {
public:
    /// `geoid` must outlive it.
    ScenarioTraffic(const std::vector<TrafficSettings>& settings, base::Time start, std::uint64_t seed, const GeoidEgm96& geoid);

    /// Returns the aircraft received at a time; their numbers are indices in the settings.
    [[nodiscard]] std::vector<ReceivedAircraft> at(base::Time time) const;

private:
    [[nodiscard]] flight::TrafficReport report_of(const TrafficSettings& aircraft, base::Time time) const;

    std::vector<TrafficSettings> aircraft_;  ///< with the positions of the seed
    base::Time start_;
    const GeoidEgm96& geoid_;
};

}  // namespace tedavis::host_sim
