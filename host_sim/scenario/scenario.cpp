#include "host_sim/scenario/scenario.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

#include "bus/canaerospace/traffic_profile.hpp"
#include "host_sim/calendar_time.hpp"
#include "host_sim/scenario/read_angle.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_errors.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using base::ConfigSection;

constexpr std::array<std::string_view, 6> kKinds = {"stand", "roll", "hold", "fly_to", "final", "land"};
constexpr std::array<std::string_view, 3> kStatedBy = {"nobody", "can", "switches"};
constexpr std::size_t kMaxLegs = 256;
constexpr std::size_t kMaxTraffic = bus::kTrafficNumbers;

constexpr std::string_view kStart = "2026-06-01T12:00:00Z";  // where the file states none

LandingStrip read_strip(ConfigSection section) {
    LandingStrip strip;
    strip.latitude_rad = read_angle(section, "latitude_deg", -85, 85);
    strip.longitude_rad = read_angle(section, "longitude_deg", -180, 180);
    strip.heading_rad = read_angle(section, "heading_deg", 0, 360);
    strip.elevation_msl_m = section.number("elevation_msl_m", -500, 6000);
    strip.length_m = section.number("length_m", 200, 6000, strip.length_m);
    strip.width_m = section.number("width_m", 5, 100, strip.width_m);
    return strip;
}

double pressure(ConfigSection& section, std::string_view key, double low_hpa, double high_hpa, double fallback_pa) {
    return section.has(key) ? base::kPascalsPerHectopascal * section.number(key, low_hpa, high_hpa) : fallback_pa;
}

Environment read_environment(ConfigSection section) {
    Environment air;
    air.qnh_pa = pressure(section, "qnh_hpa", 900, 1060, air.qnh_pa);
    air.qnh_spread_pa = pressure(section, "qnh_spread_hpa", 0, 20, air.qnh_spread_pa);
    air.temperature_deviation_k = section.number("temperature_deviation_k", -40, 40, air.temperature_deviation_k);
    air.temperature_spread_k = section.number("temperature_spread_k", 0, 20, air.temperature_spread_k);
    air.wind_speed_mps = section.number("wind_speed_mps", 0, 30, air.wind_speed_mps);
    air.wind_speed_spread_mps = section.number("wind_speed_spread_mps", 0, 10, air.wind_speed_spread_mps);
    air.wind_from_rad = read_angle(section, "wind_from_deg", 0, 360, air.wind_from_rad);
    air.wind_from_spread_rad = read_angle(section, "wind_from_spread_deg", 0, 180, air.wind_from_spread_rad);
    air.magnetic_variation_rad = read_angle(section, "magnetic_variation_deg", -60, 60, air.magnetic_variation_rad);
    air.turbulence = section.number("turbulence", 0, 1, air.turbulence);
    return air;
}

AircraftLimits read_aircraft(ConfigSection section) {
    AircraftLimits aircraft;
    aircraft.antenna_height_m = section.number("antenna_height_m", 0, 20, aircraft.antenna_height_m);
    aircraft.bank_rad = read_angle(section, "bank_deg", 5, 60, aircraft.bank_rad);
    aircraft.roll_rate_radps = read_angle(section, "roll_rate_dps", 2, 90, aircraft.roll_rate_radps);
    aircraft.acceleration_mps2 = section.number("acceleration_mps2", 0.1, 10, aircraft.acceleration_mps2);
    return aircraft;
}

Guidance read_guidance(ConfigSection& section, const LandingStrip& strip) {
    Guidance guidance;
    guidance.decision_height_m = section.number("decision_height_m", 0, 1000);
    guidance.minimum_msl_m = section.number("minimum_msl_m", -500, 10000);
    guidance.flaps_travel_s = section.number("flaps_travel_s", 0.1, 120);
    if (section.has("minimum_msl_m") && guidance.minimum_msl_m < strip.elevation_msl_m)
        section.fault("minimum_msl_m", "the minimum lies below the strip; give a height above mean sea level");
    return guidance;
}

void read_target(ConfigSection& section, Leg& leg) {
    leg.speed_mps = section.number("speed_mps", 20, 300);
    leg.altitude_msl_m = section.number("altitude_msl_m", -500, 15000);
    leg.climb_mps = section.number("climb_mps", 0.5, 50);
}

void read_glide(ConfigSection& section, Leg& leg) {
    leg.speed_mps = section.number("speed_mps", 20, 300);
    leg.glide_rad = read_angle(section, "glide_deg", 2, 8);
}

/// Only the keys of the leg's kind are read; any other one is a fault of its own.
void read_kind(ConfigSection& section, Leg& leg) {
    switch (leg.kind) {
        case LegKind::stand: leg.duration_s = section.number("duration_s", 0.1, 600); break;
        case LegKind::roll:
            leg.speed_mps = section.number("speed_mps", 20, 150);
            leg.acceleration_mps2 = section.number("acceleration_mps2", 0.5, 10);
            break;
        case LegKind::hold:
            read_target(section, leg);
            leg.heading_rad = read_angle(section, "heading_deg", 0, 360);
            leg.duration_s = section.number("duration_s", 0, 3600, 0);
            break;
        case LegKind::fly_to:
            read_target(section, leg);
            leg.latitude_rad = read_angle(section, "latitude_deg", -85, 85);
            leg.longitude_rad = read_angle(section, "longitude_deg", -180, 180);
            leg.capture_m = section.number("capture_m", 50, 20000);
            break;
        case LegKind::final_leg:
            read_glide(section, leg);
            leg.until_height_m = section.number("until_height_m", 5, 1000);
            break;
        case LegKind::land:
            read_glide(section, leg);
            leg.acceleration_mps2 = section.number("braking_mps2", 0.5, 6);
            break;
    }
}

Leg read_leg(ConfigSection section) {
    Leg leg;
    section.choose("kind", kKinds, leg.kind);
    section.choose("stated_by", kStatedBy, leg.stated_by);
    const flight::ParsedPhase phase = flight::phase_from_name(section.text("phase"));
    if (section.has("phase") && !phase.ok) section.fault("phase", "no such flight phase; say for example takeoff.first_climb");
    leg.phase = phase.phase;
    leg.flaps = section.number("flaps", 0, 1, 0);
    const bool is_known = !section.has("kind") || std::find(kKinds.begin(), kKinds.end(), section.text("kind")) != kKinds.end();
    if (is_known) read_kind(section, leg);  // of another kind nobody knows the keys
    return leg;
}

/// A bare name is that of a shipped scene file.
std::string read_scene(ConfigSection& root, const std::string& file_name) {
    const std::string name(root.text("scene", ""));
    if (name.empty()) return {};
    std::string path = stated_config(name, "scenes", file_name);
    std::error_code not_there;
    if (!std::filesystem::is_regular_file(path, not_there))
        root.fault("scene",
                   "there is no scene file " + path + "; name a shipped one such as jacksboro, or a file from this one's folder");
    return path;
}

std::vector<TrafficSettings> read_aircraft_around(ConfigSection& root) {
    std::vector<TrafficSettings> traffic;
    const std::size_t aircraft = root.table_count("traffic");
    if (aircraft > kMaxTraffic) root.fault("traffic", "at most 32 tables [[traffic]]");
    for (std::size_t i = 0; i < aircraft && i < kMaxTraffic; ++i) {
        ConfigSection section = root.table_at("traffic", i);
        traffic.push_back(read_traffic(section));
    }
    return traffic;
}

/// A bare name is that of a shipped raster.
RadioAltimeterSettings read_radio_altimeter(ConfigSection& section, const std::string& file_name) {
    RadioAltimeterSettings altimeter;
    altimeter.range_m = section.number("range_m", 10, 10000);
    const std::string name(section.text("terrain"));
    const bool is_bare = name.find_first_of("./") == std::string::npos;
    altimeter.terrain = is_bare ? shipped_root() + "/configs/data/" + name + ".tif" : path_from(file_name, name);
    std::error_code not_there;
    if (!std::filesystem::is_regular_file(altimeter.terrain, not_there))
        section.fault("terrain", "there is no raster " + altimeter.terrain +
                                     "; name a shipped one such as jacksboro_srtm3, or a file from this one's folder");
    return altimeter;
}

std::vector<std::string> sentences_of(base::Span<const base::Error> errors) {
    std::vector<std::string> sentences;
    for (const base::Error& error : errors) sentences.emplace_back(error.message.view());
    return sentences;
}

}  // namespace

Scenario parse_scenario(std::string_view text, const std::string& file_name) {
    base::ConfigReader reader(text, file_name);
    ConfigSection root = reader.root();
    Scenario scenario;
    scenario.name = std::string(root.text("name", std::filesystem::path(file_name).stem().string()));
    scenario.purpose = std::string(root.text("purpose", ""));
    scenario.seed = static_cast<std::uint64_t>(root.integer("seed", 0, std::numeric_limits<std::int64_t>::max(), 1));
    scenario.switch_config = std::string(root.text("switch_config", "one_hot"));
    const auto start = parse_iso8601(root.text("start_utc", kStart));
    if (!start) root.fault("start_utc", "no time such as 2026-06-01T14:00:00Z");
    scenario.start = start.value_or(base::Time{});
    if (root.has("strip"))
        scenario.strip = read_strip(root.section("strip"));
    else
        root.fault("strip", "there is no table [strip]; add it with the place where the flight takes off and lands");
    scenario.environment = read_environment(root.section("environment"));
    scenario.aircraft = read_aircraft(root.section("aircraft"));
    scenario.scene = read_scene(root, file_name);
    if (ConfigSection weather = root.section("weather"); weather.present()) scenario.weather = read_weather(weather);
    if (ConfigSection guidance = root.section("guidance"); guidance.present())
        scenario.guidance = read_guidance(guidance, scenario.strip);
    if (ConfigSection altimeter = root.section("radio_altimeter"); altimeter.present())
        scenario.radio_altimeter = read_radio_altimeter(altimeter, file_name);
    scenario.traffic = read_aircraft_around(root);
    const std::size_t legs = root.table_count("leg");
    if (legs == 0 || legs > kMaxLegs) root.fault("leg", "1 to 256 tables [[leg]] are needed; add one for each part of the way");
    for (std::size_t i = 0; i < legs && i < kMaxLegs; ++i) scenario.legs.push_back(read_leg(root.table_at("leg", i)));
    if (!reader.finish()) throw UserErrors(sentences_of(reader.errors()));
    return scenario;
}

}  // namespace tedavis::host_sim
