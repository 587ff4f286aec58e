#include "host_sim/scenario/scenario_traffic.hpp"

#include <cmath>

#include "host_sim/scenario/local_plane.hpp"
#include "host_sim/scenario/read_angle.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::host_sim {
namespace {

using base::ConfigSection;

/// The numbers that this draws are not those of the flight.
constexpr std::uint64_t kStream = 0x7452414646494330;
constexpr double kLongestFlight_s = 14'400;

std::string read_callsign(ConfigSection& section) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    std::string callsign(section.text("callsign", ""));
    if (callsign.size() > 8 || callsign.find_first_not_of(kLetters) != std::string::npos)
        section.fault("callsign", "at most eight letters A to Z and digits");
    return callsign;
}

std::uint32_t read_address(ConfigSection& section) {
    const std::string text(section.text("address"));
    const bool is_number =
        !text.empty() && text.size() <= 6 && text.find_first_not_of("0123456789ABCDEFabcdef") == std::string::npos;
    const unsigned long address = is_number ? std::stoul(text, nullptr, 16) : 0;
    if (address == 0) section.fault("address", "a transponder's address such as \"A0F12B\", six hexadecimal digits and not 0");
    return static_cast<std::uint32_t>(address);
}

/// Of one that turns, in metres east and north since it was at its place, and its track now.
struct Flown {
    double east_m, north_m, track_rad;
};
Flown flown(const TrafficSettings& aircraft, double seconds) {
    const double turned = aircraft.turn_radps * seconds;
    if (aircraft.turn_radps == 0) {
        const double way_m = aircraft.speed_mps * seconds;
        return {way_m * std::sin(aircraft.track_rad), way_m * std::cos(aircraft.track_rad), aircraft.track_rad};
    }
    const double radius_m = aircraft.speed_mps / aircraft.turn_radps, track = aircraft.track_rad + turned;
    return {radius_m * (std::cos(aircraft.track_rad) - std::cos(track)),
            radius_m * (std::sin(track) - std::sin(aircraft.track_rad)), track};
}

}  // namespace

TrafficSettings read_traffic(ConfigSection& section) {
    TrafficSettings aircraft;
    aircraft.callsign = read_callsign(section);
    aircraft.address = read_address(section);
    aircraft.latitude_rad = read_angle(section, "latitude_deg", -85, 85);
    aircraft.longitude_rad = read_angle(section, "longitude_deg", -180, 180);
    aircraft.altitude_msl_m = section.number("altitude_msl_m", -500, 20000);
    aircraft.spread_m = section.number("spread_m", 0, 20000, 0);
    aircraft.at_s = section.number("at_s", 0, kLongestFlight_s);
    aircraft.track_rad = read_angle(section, "track_deg", 0, 360);
    aircraft.speed_mps = section.number("speed_mps", 0, 350);
    aircraft.climb_mps = section.number("climb_mps", -50, 50, 0);
    aircraft.turn_radps = base::radians(section.number("turn_dps", -30, 30, 0));
    aircraft.stands_before = section.boolean("stands_before", false);
    aircraft.position_deviation_m = section.number("position_deviation_m", 0, 20000, 0);
    aircraft.height_deviation_m = section.number("height_deviation_m", 0, 2000, 0);
    aircraft.received_from_s = section.number("received_from_s", 0, kLongestFlight_s, 0);
    aircraft.received_until_s = section.number("received_until_s", 0, kLongestFlight_s, kLongestFlight_s);
    return aircraft;
}

ScenarioTraffic::ScenarioTraffic(const std::vector<TrafficSettings>& settings, base::Time start, std::uint64_t seed,
                                 const GeoidEgm96& geoid)
    : aircraft_(settings), start_(start), geoid_(geoid) {
    SeededRandom random(seed ^ kStream);
    for (TrafficSettings& aircraft : aircraft_) {
        const double east_m = random.within(0, aircraft.spread_m), north_m = random.within(0, aircraft.spread_m);
        const PlanePlace place = LocalPlane(aircraft.latitude_rad, aircraft.longitude_rad).at(east_m, north_m);
        aircraft.latitude_rad = place.latitude_rad;
        aircraft.longitude_rad = place.longitude_rad;
    }
}

std::vector<ReceivedAircraft> ScenarioTraffic::at(base::Time time) const {
    std::vector<ReceivedAircraft> received;
    const double second = (time - start_).to_seconds();
    for (std::size_t n = 0; n < aircraft_.size(); ++n)
        if (second >= aircraft_[n].received_from_s && second <= aircraft_[n].received_until_s)
            received.push_back({static_cast<std::uint8_t>(n), report_of(aircraft_[n], time)});
    return received;
}

flight::TrafficReport ScenarioTraffic::report_of(const TrafficSettings& aircraft, base::Time time) const {
    const double since_s = (time - start_).to_seconds() - aircraft.at_s;
    const bool stands = aircraft.stands_before && since_s < 0;
    const double seconds = stands ? 0 : since_s;
    const Flown way = flown(aircraft, seconds);
    const PlanePlace place = LocalPlane(aircraft.latitude_rad, aircraft.longitude_rad).at(way.east_m, way.north_m);
    const double height_m =
        aircraft.altitude_msl_m + aircraft.climb_mps * seconds + geoid_.undulation(place.latitude_rad, place.longitude_rad).m;
    flight::TrafficReport report;
    report.address = aircraft.address;
    report.callsign = {aircraft.callsign};
    report.place = {place.latitude_rad,
                    place.longitude_rad,
                    time,
                    static_cast<float>(height_m),
                    static_cast<float>(aircraft.position_deviation_m),
                    static_cast<float>(aircraft.height_deviation_m)};
    report.ground_speed_mps = static_cast<float>(stands ? 0 : aircraft.speed_mps);
    report.true_track_rad = static_cast<float>(earth::wrap_heading(way.track_rad));
    report.climb_mps = static_cast<float>(stands ? 0 : aircraft.climb_mps);
    return report;
}

}  // namespace tedavis::host_sim
