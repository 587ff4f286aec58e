/// A generated flight as its file describes it (`configs/scenarios/*.toml`): a strip, the air, and a chain of legs.
///
/// SI and radians inside; the file uses degrees and hectopascals. Every value is checked where it is read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scenario/scenario_traffic.hpp"
#include "host_sim/scenario/weather_settings.hpp"
#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

/// A straight landing strip.
struct LandingStrip {
    double latitude_rad = 0, longitude_rad = 0;  ///< of its centre
    double heading_rad = 0;                      ///< direction of take-off and landing
    double elevation_msl_m = 0;
    double length_m = 1000, width_m = 30;
};

/// The atmosphere; the seed varies each value within its spread.
struct Environment {
    double qnh_pa = 101325, qnh_spread_pa = 0;
    double temperature_deviation_k = 0, temperature_spread_k = 0;  ///< from the standard atmosphere
    double wind_speed_mps = 0, wind_speed_spread_mps = 0;
    double wind_from_rad = 0, wind_from_spread_rad = 0;
    double magnetic_variation_rad = 0;  ///< east positive
    double turbulence = 0;              ///< 0 calm .. 1 rough: scale of small random motions of the attitude
};

/// Performance limits of the simulated aircraft.
struct AircraftLimits {
    double antenna_height_m = 2.5;  ///< of the reference point above the wheels
    double bank_rad = 0.6;
    double roll_rate_radps = 0.35;
    double acceleration_mps2 = 2;
};

enum class LegKind : std::uint8_t {
    stand,      ///< on the ground, not moving
    roll,       ///< along the strip until its speed is reached, then off
    hold,       ///< a heading, climbing or descending to an altitude; ends at the altitude or after a time
    fly_to,     ///< a point; ends within `capture_m` of it, or when it lies behind
    final_leg,  ///< the strip's extended centre line and glide path, down to a height above the strip
    land,       ///< glide path, flare, touchdown, braking to a stop
};

/// The source by which the phase of a leg is stated to the display.
enum class PhaseStatedBy : std::uint8_t { nobody, can, switches };

struct Leg {
    LegKind kind = LegKind::stand;
    flight::FlightPhase phase;
    PhaseStatedBy stated_by = PhaseStatedBy::nobody;
    double speed_mps = 0;                                       ///< true airspeed to reach
    double altitude_msl_m = 0;                                  ///< hold, fly_to
    double climb_mps = 0;                                       ///< largest vertical speed either way
    double heading_rad = 0;                                     ///< hold
    double latitude_rad = 0, longitude_rad = 0, capture_m = 0;  ///< fly_to
    double duration_s = 0;                                      ///< stand; hold: at most, 0 for no limit
    double acceleration_mps2 = 0;                               ///< roll, and braking of land
    double glide_rad = 0;                                       ///< final_leg, land
    double until_height_m = 0;                                  ///< final_leg: of the wheels above the strip
    double flaps = 0;                                           ///< lever, share of full travel
};

/// Guidance data that the aircraft sends; others are derived from the legs.
struct Guidance {
    double decision_height_m = 0;  ///< height above ground
    double minimum_msl_m = 0;      ///< true altitude; stated as the altimeter shows it
    double flaps_travel_s = 0;     ///< from up to full
};

/// The aircraft's radio altimeter.
struct RadioAltimeterSettings {
    std::string terrain;  ///< path of the raster of the ground
    double range_m = 0;   ///< greatest height that it measures
};

struct Scenario {
    std::string name, purpose;
    std::uint64_t seed = 0;
    base::Time start;
    LandingStrip strip;
    Environment environment;
    AircraftLimits aircraft;
    std::string switch_config;  ///< shipped name or path
    std::string scene;          ///< path of the scene file for the data around the flight; empty: none
    std::optional<WeatherSettings> weather;
    std::optional<Guidance> guidance;  ///< nothing: none is sent
    std::optional<RadioAltimeterSettings> radio_altimeter;
    std::vector<TrafficSettings> traffic;  ///< other aircraft
    std::vector<Leg> legs;
};

/// `file_name` is the path of the file, for messages and for the names in it, which are relative to its folder. Throws UserError
/// with the line.
[[nodiscard]] Scenario parse_scenario(std::string_view text, const std::string& file_name);

}  // namespace tedavis::host_sim
