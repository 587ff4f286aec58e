#include "host_sim/accuracy/knobs/recorded_poses.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/flown_display.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/open_log.hpp"
#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kPoseStep_s = 0.1;
constexpr double kMaxInstants = 36'000;
constexpr PictureSize kUndrawnSize = {64, 64};  ///< the display plans and draws nothing
constexpr double kUndrawnTau_px = 16;

std::uint64_t identity_of(const PlayerFiles& files) {
    base::Fnv1a64 hash;
    std::vector<char> part(1 << 20);
    const std::unique_ptr<base::ByteSource> log = open_log(files.log);
    for (std::uint64_t at = 0; at < log->size(); at += part.size()) {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(part.size(), log->size() - at));
        if (!log->read(at, part.data(), count))
            throw UserError(files.log + ": cannot be read beyond byte " + std::to_string(at) + "; check the medium it lies on");
        hash.add(part.data(), count);
    }
    const std::string switches = files.switches.empty() ? std::string() : read_switch_log(files.switches);
    hash.add(switches.data(), switches.size());
    return hash.value();
}

AircraftPose pose_of(const display::FrameStatement& stated, base::Duration since_begin) {
    AircraftPose pose;
    pose.latitude_deg = base::degrees(stated.own_ship.position.latitude_rad);
    pose.longitude_deg = base::degrees(stated.own_ship.position.longitude_rad);
    pose.altitude_msl_m = stated.altitude_msl_m;
    pose.heading_deg = base::degrees(stated.heading_rad);
    pose.pitch_deg = base::degrees(stated.pitch_rad);
    pose.roll_deg = base::degrees(stated.roll_rad);
    pose.time = base::Time{} + since_begin;
    if (stated.phase.source != flight::PhaseSource::none) pose.phase = stated.phase.presented;
    return pose;
}

bool holds(const GeoExtent& extent, const AircraftPose& pose) {
    return pose.latitude_deg >= extent.south_deg && pose.latitude_deg <= extent.north_deg &&
           pose.longitude_deg >= extent.west_deg && pose.longitude_deg <= extent.east_deg;
}

}  // namespace

RecordedPoses read_recorded_poses(const PlayerFiles& files, const std::string& terrain, Console& console) {
    PictureOptions options;
    options.terrain = terrain;
    options.size = kUndrawnSize;
    options.tau_px = kUndrawnTau_px;
    options.gl = offered_gl();
    DisplaySession session(options, true);
    display::Display& display = session.display();
    FlightPlayer player(files, display, &console);
    RecordedPoses recorded;
    recorded.log = files.log;
    recorded.identity = identity_of(files);
    const double duration_s = (player.last() - player.first()).to_seconds();
    recorded.step_s = std::max(kPoseStep_s, duration_s / (kMaxInstants - 1));
    const auto instants = static_cast<std::uint64_t>(duration_s / recorded.step_s) + 1;
    const GeoExtent extent = extent_of(*display.planner().terrain_database());
    bool has_position = false;
    const InterruptGuard interrupt;
    for (std::uint64_t n = 0; n < instants; ++n) {
        const base::Duration since = base::Duration::from_seconds(static_cast<double>(n) * recorded.step_s);
        display.plan(player.at(player.first() + since));
        const display::FrameStatement& stated = display.planned();
        if (stated.own_ship.state == base::SignalState::valid) {
            has_position = true;
            const AircraftPose pose = pose_of(stated, since);
            if (holds(extent, pose)) recorded.valid.push_back(pose);
        }
        console.progress("reading " + files.log, n + 1, instants);
        if (interrupt.requested()) throw Interrupted(files.log + ": interrupted while it was read; nothing was written");
    }
    console.progress_done();
    if (!has_position)
        throw UserError("--flight " + files.log +
                        ": has no valid position at any instant, so there is no pose to measure at; name a log with positions");
    if (recorded.valid.empty())
        throw UserError("--flight " + files.log + ": is nowhere over " + terrain + "; name its terrain with --terrain");
    return recorded;
}

}  // namespace tedavis::host_sim
