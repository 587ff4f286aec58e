#include "host_sim/commands/shot.hpp"

#include <cctype>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/geoid_below.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using base::radians;
using flight::Signal;

constexpr base::Time kShotTime{0};

/// An aircraft that stands still in the air, everything about it known and fresh.
flight::AircraftState posed_aircraft(const ShotPose& pose, display::Display& display) {
    flight::AircraftState state;
    flight::OwnShipEstimate& own = state.own_ship;
    own.position.latitude_rad = radians(pose.latitude_deg);
    own.position.longitude_rad = earth::wrap_longitude(radians(pose.longitude_deg));
    GeoidBelow geoid(display.terrain_database());
    own.position.height =
        earth::to_ellipsoid({pose.altitude_msl_m}, geoid.at(own.position.latitude_rad, own.position.longitude_rad));
    own.at = kShotTime;
    own.state = base::SignalState::valid;
    own.height_is_geometric = true;
    const auto set = [&state](Signal signal, double value) { state[signal] = {value, kShotTime}; };
    set(Signal::latitude, own.position.latitude_rad);
    set(Signal::longitude, own.position.longitude_rad);
    set(Signal::ellipsoid_height, own.position.height.m);
    set(Signal::true_altitude, pose.altitude_msl_m);
    set(Signal::true_heading, earth::wrap_heading(radians(pose.heading_deg)));
    set(Signal::pitch, radians(pose.pitch_deg));
    set(Signal::roll, radians(pose.roll_deg));
    state[Signal::height_above_terrain] = display.height_above_terrain(own, kShotTime);
    return state;
}

double milliseconds_since(base::Time start) { return (platform::monotonic_now() - start).to_seconds() * 1000; }

std::string record_path(const std::string& picture) { return std::filesystem::path(picture).replace_extension(".json").string(); }

void require_png_name(const std::string& picture) {
    std::string extension = std::filesystem::path(picture).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!extension.empty() && extension != ".png")
        throw UserError("-o " + picture + ": the picture is a PNG; give it a name that ends in .png");
}

flight::PhaseStatus stated_phase(const std::string& name) {
    if (name.empty()) return {};
    const flight::ParsedPhase phase = flight::phase_from_name(name);
    if (!phase.ok) throw UserError("--phase " + name + ": unknown; write for instance takeoff.first_climb or cruise");
    return {phase.phase, flight::PhaseSource::switches, false, false};
}

}  // namespace

int run_shot(const ShotOptions& options, Console& console) {
    require_png_name(options.output);
    const flight::PhaseStatus phase = stated_phase(options.phase);
    DisplaySession session(options.picture, false);
    FrameResult result;
    const base::Time start = platform::monotonic_now();
    const flight::AircraftState state = posed_aircraft(options.pose, session.display());
    session.display().settle(state, phase, kShotTime);
    session.display().update(state, phase, kShotTime);
    result.timing.plan_ms = milliseconds_since(start);
    session.draw();
    result.timing.total_ms = milliseconds_since(start);
    result.timing.draw_ms = result.timing.total_ms - result.timing.plan_ms;
    result.record = session.display().record();
    result.hash = session.frame_hash();
    const std::string json = frame_record_json(result, kShotTime);
    write_png(options.output, session.pixels());
    write_file_atomically(record_path(options.output), json + "\n");
    console.result(options.output + ": " + std::to_string(session.width()) + " x " + std::to_string(session.height()) +
                       " pixels, " + std::to_string(result.record.terrain.triangles) + " terrain triangles, hash " +
                       hash_text(result.hash),
                   json);
    const std::string fault = session.terrain_fault();
    if (fault.empty()) return 0;
    console.note("note: " + fault);
    return kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
