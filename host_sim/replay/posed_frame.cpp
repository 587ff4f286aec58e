#include "host_sim/replay/posed_frame.hpp"

#include <memory>

#include "platform/clock/monotonic_clock.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/flight/flight_trail.hpp"

namespace tedavis::host_sim {
namespace {

double milliseconds_since(base::Time start) { return (platform::monotonic_now() - start).to_seconds() * 1000; }

}  // namespace

FrameResult posed_frame(DisplaySession& session, const AircraftPose& pose, const flight::PhaseStatus& phase) {
    FrameResult result;
    const base::Time start = platform::monotonic_now();
    const auto way = std::make_unique<flight::FlightTrail>();
    for (const AircraftPose& before : poses_before(pose)) way->step(posed_aircraft(before, session.display()), before.time);
    const flight::AircraftState state = posed_aircraft(pose, session.display());
    display::settle(session.display(), {state, phase, pose.time});
    session.display().plan({state, phase, pose.time, pose.flown.seconds > 0 ? way.get() : nullptr});
    result.timing.plan_ms = milliseconds_since(start);
    session.draw();
    result.timing.total_ms = milliseconds_since(start);
    result.timing.draw_ms = result.timing.total_ms - result.timing.plan_ms;
    result.record = session.display().record();
    result.hash = session.frame_hash();
    if (const terrain::TerrainDatabase* const database = session.display().planner().terrain_database(); database != nullptr)
        result.clearance = ClearanceMeter(*database).measure(state, pose.time, result.record.heading_rad);
    return result;
}

}  // namespace tedavis::host_sim
