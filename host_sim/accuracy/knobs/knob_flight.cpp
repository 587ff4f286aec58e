#include "host_sim/accuracy/knobs/knob_flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/scenario/scenario_scene.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "host_sim/shipped_files.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kStatesOfSecond = static_cast<std::size_t>(1 / kScenarioStep_s + 0.5);

/// Every place of the flight, at intervals of a second, lies over posts.
bool holds_flight(const TracedGround& ground, const ScenarioFlight& flight) {
    for (std::size_t n = 0; n < flight.states().size(); n += kStatesOfSecond) {
        const ScenarioFlight::State& state = flight.states()[n];
        const glm::dvec3 place = ground.space().place(earth::to_ecef({state.latitude_rad, state.longitude_rad, {0}}));
        if (!(place.x >= 0 && place.y >= 0 && place.x <= ground.columns() - 1.0 && place.y <= ground.rows() - 1.0)) return false;
    }
    return true;
}

/// East of the strip by as many metres as before.
void move_place(double& latitude_rad, double& longitude_rad, const LandingStrip& from, const earth::Geodetic& to) {
    const double stretch = std::cos(from.latitude_rad) / std::cos(to.latitude_rad);
    latitude_rad += to.latitude_rad - from.latitude_rad;
    longitude_rad = to.longitude_rad + stretch * (longitude_rad - from.longitude_rad);
}

Scenario moved_scenario(Scenario scenario, const TracedGround& ground) {
    const earth::Geodetic to =
        earth::from_ecef(ground.space().position({0.5 * (ground.columns() - 1), 0.5 * (ground.rows() - 1), 0}));
    const LandingStrip from = scenario.strip;
    const double up_m = ground.highest_m() - from.elevation_msl_m;
    for (Leg& leg : scenario.legs) {
        move_place(leg.latitude_rad, leg.longitude_rad, from, to);
        leg.altitude_msl_m += up_m;
    }
    scenario.strip.latitude_rad = to.latitude_rad;
    scenario.strip.longitude_rad = to.longitude_rad;
    scenario.strip.elevation_msl_m += up_m;
    scenario.traffic.clear();
    scenario.scene.clear();
    return scenario;
}

}  // namespace

KnobFlight::KnobFlight(const TracedGround& ground)
    : scenario_(scenario_over(ground, geoid_, is_moved_)), flight_(scenario_, scenario_.seed, geoid_) {}

Scenario KnobFlight::scenario_over(const TracedGround& ground, const GeoidEgm96& geoid, bool& is_moved) {
    const std::string path = resolve_config("default", "scenarios");
    const Scenario scenario = parse_scenario(read_file(path), path);
    is_moved = !holds_flight(ground, ScenarioFlight(scenario, scenario.seed, geoid));
    return is_moved ? moved_scenario(scenario, ground) : scenario;
}

double KnobFlight::duration_s() const { return static_cast<double>(flight_.states().size() - 1) * kScenarioStep_s; }

AircraftPose KnobFlight::pose_at(double at_s) const {
    const std::vector<ScenarioFlight::State>& states = flight_.states();
    const double step = std::clamp(at_s / kScenarioStep_s, 0.0, static_cast<double>(states.size() - 1));
    const auto before = static_cast<std::size_t>(step);
    const ScenarioFlight::State &a = states[before], &b = states[std::min(before + 1, states.size() - 1)];
    const double share = step - static_cast<double>(before);
    const auto between = [share](double from, double to) { return from + share * (to - from); };
    AircraftPose pose;
    pose.latitude_deg = base::degrees(between(a.latitude_rad, b.latitude_rad));
    pose.longitude_deg = base::degrees(between(a.longitude_rad, b.longitude_rad));
    pose.altitude_msl_m = between(a.altitude_msl_m, b.altitude_msl_m);
    pose.heading_deg = base::degrees(earth::wrap_heading(between(a.heading_rad, b.heading_rad)));
    pose.pitch_deg = base::degrees(between(a.pitch_rad, b.pitch_rad));
    pose.roll_deg = base::degrees(between(a.roll_rad, b.roll_rad));
    pose.time = flight_.begin() + base::Duration::from_seconds(step * kScenarioStep_s);
    return pose;
}

std::vector<AircraftPose> KnobFlight::poses(std::size_t count) const {
    std::vector<AircraftPose> poses;
    for (std::size_t n = 0; n < count; ++n)
        poses.push_back(pose_at((static_cast<double>(n) + 0.5) * duration_s() / static_cast<double>(count)));
    return poses;
}

const std::string& KnobFlight::scene() {
    if (!scene_.empty()) return scene_;
    const MadeScene made =
        make_scenario_scene(scenario_, flight_, scenario_.seed, [](std::string_view, std::size_t, std::size_t) {});
    const std::vector<std::uint8_t> bytes = sdb_bytes(made.draft);
    const std::string path = folder_.path() + "/scene.sdb";
    write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    scene_ = path;
    return scene_;
}

std::string pose_text(const AircraftPose& pose) {
    char text[160];
    std::snprintf(text, sizeof text, "%.6f,%.6f,%.2f,%.3f,%.3f,%.3f", pose.latitude_deg, pose.longitude_deg, pose.altitude_msl_m,
                  pose.heading_deg, pose.pitch_deg, pose.roll_deg);
    return text;
}

}  // namespace tedavis::host_sim
