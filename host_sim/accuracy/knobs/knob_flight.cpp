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

constexpr double kStripBelow_m = 500;  ///< of the data round a recorded flight: the default flight climbs about so high
constexpr std::size_t kStatesOfSecond = 100;
static_assert(static_cast<double>(kStatesOfSecond) * kScenarioStep_s == 1);

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

/// The strip, and the flight with it, at a place and a height above mean sea level.
Scenario moved_scenario(Scenario scenario, const earth::Geodetic& to, double elevation_msl_m) {
    const LandingStrip from = scenario.strip;
    const double up_m = elevation_msl_m - from.elevation_msl_m;
    for (Leg& leg : scenario.legs) {
        move_place(leg.latitude_rad, leg.longitude_rad, from, to);
        leg.altitude_msl_m += up_m;
    }
    scenario.strip.latitude_rad = to.latitude_rad;
    scenario.strip.longitude_rad = to.longitude_rad;
    scenario.strip.elevation_msl_m += up_m;
    scenario.traffic.clear();
    scenario.radio_altimeter.reset();
    scenario.scene.clear();
    return scenario;
}

Scenario scenario_below(const Scenario& scenario, const AircraftPose& aircraft) {
    const earth::Geodetic to{base::radians(aircraft.latitude_deg), base::radians(aircraft.longitude_deg), {0}};
    return moved_scenario(scenario, to, std::max(0.0, aircraft.altitude_msl_m - kStripBelow_m));
}

AircraftPose pose_between(const AircraftPose& a, const AircraftPose& b, double share) {
    const auto between = [share](double from, double to) { return from + share * (to - from); };
    const auto turned = [share](double from, double to) { return from + share * std::remainder(to - from, 360.0); };
    AircraftPose pose = a;
    pose.latitude_deg = between(a.latitude_deg, b.latitude_deg);
    pose.longitude_deg = turned(a.longitude_deg, b.longitude_deg);
    pose.altitude_msl_m = between(a.altitude_msl_m, b.altitude_msl_m);
    pose.heading_deg = base::degrees(earth::wrap_heading(base::radians(turned(a.heading_deg, b.heading_deg))));
    pose.pitch_deg = between(a.pitch_deg, b.pitch_deg);
    pose.roll_deg = std::remainder(turned(a.roll_deg, b.roll_deg), 360.0);
    return pose;
}

}  // namespace

KnobFlight::KnobFlight(const TracedGround& ground, const RecordedPoses* recorded)
    : recorded_(recorded), scenario_(scenario_over(ground)), flight_(scenario_, scenario_.seed, geoid_) {}

Scenario KnobFlight::scenario_over(const TracedGround& ground) {
    const std::string path = resolve_config("default", "scenarios");
    Scenario scenario = parse_scenario(read_file(path), path);
    if (recorded_ != nullptr) return scenario_below(scenario, recorded_->valid[recorded_->valid.size() / 2]);
    is_moved_ = !holds_flight(ground, ScenarioFlight(scenario, scenario.seed, geoid_));
    if (!is_moved_) return scenario;
    const glm::dvec3 middle{0.5 * (ground.columns() - 1), 0.5 * (ground.rows() - 1), 0};
    return moved_scenario(scenario, earth::from_ecef(ground.space().position(middle)), ground.highest_m());
}

std::string KnobFlight::name() const {
    if (recorded_ != nullptr) return recorded_->log;
    return is_moved_ ? "the shipped flight, moved to the terrain" : "the shipped flight";
}

double KnobFlight::duration_s() const {
    if (recorded_ != nullptr) return static_cast<double>(recorded_->valid.size()) * recorded_->step_s;
    return static_cast<double>(flight_.states().size() - 1) * kScenarioStep_s;
}

AircraftPose KnobFlight::recorded_pose_at(double at_s) const {
    const std::vector<AircraftPose>& valid = recorded_->valid;
    const base::Time time = base::Time{} + base::Duration::from_seconds(at_s);
    const auto after = std::upper_bound(valid.begin(), valid.end(), time,
                                        [](base::Time at, const AircraftPose& pose) { return at < pose.time; });
    if (after == valid.begin()) return valid.front();
    const AircraftPose& before = *(after - 1);
    AircraftPose pose = before;
    if (after != valid.end()) {
        const double gap_s = (after->time - before.time).to_seconds();
        if (gap_s < 1.5 * recorded_->step_s) pose = pose_between(before, *after, (time - before.time).to_seconds() / gap_s);
    }
    pose.time = time;
    return pose;
}

AircraftPose KnobFlight::pose_at(double at_s) const {
    if (recorded_ != nullptr) return recorded_pose_at(at_s);
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

flight::FlightPhase KnobFlight::phase_at(const AircraftPose& pose) const {
    return recorded_ != nullptr ? pose.phase : flight_.stated_phase(pose.time).value_or(flight::FlightPhase());
}

void KnobFlight::add_signals(const AircraftPose& pose, flight::AircraftState& state) const {
    const std::optional<SignalSample> sample = recorded_ == nullptr ? flight_.at(pose.time) : std::nullopt;
    if (!sample) return;
    for (std::size_t n = 0; n < flight::kSignalCount; ++n) {
        const auto signal = static_cast<flight::Signal>(n);
        if (sample->has(signal) && !state[signal].received()) state[signal] = {(*sample)[signal], pose.time};
    }
    state.is_posed = false;
    state.traffic.is_received = true;
    for (const ReceivedAircraft& other : flight_.traffic(pose.time))
        static_cast<void>(state.traffic.reports.try_push_back(other.report));
}

std::vector<AircraftPose> KnobFlight::poses(std::size_t count) const {
    std::vector<AircraftPose> poses;
    for (std::size_t n = 0; n < count; ++n) {
        const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(count);
        poses.push_back(recorded_ == nullptr
                            ? pose_at(share * duration_s())
                            : recorded_->valid[static_cast<std::size_t>(share * static_cast<double>(recorded_->valid.size()))]);
    }
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

flight::PhaseStatus phase_of(const AircraftPose& pose) {
    if (pose.phase.scenario == flight::Scenario::unknown) return {};
    return flight::stated_phase(pose.phase, flight::PhaseSource::switches);
}

std::string phase_option(const AircraftPose& pose) {
    if (pose.phase.scenario == flight::Scenario::unknown) return "";
    const std::string part = flight::sub_phase_name(pose.phase);
    return std::string(" --phase ") + flight::scenario_name(pose.phase) + (part.empty() ? "" : "." + part);
}

}  // namespace tedavis::host_sim
