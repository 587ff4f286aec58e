/// Checks the pose of a picture: it may lie outside the terrain or below the ground, or no terrain may be in view.
#pragma once

#include <string>

#include "host_sim/reports/run_findings.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

/// `terrain` is the database as the user named it. There are no findings where the display has no terrain.
[[nodiscard]] Findings pose_findings(const AircraftPose& pose, const display::FrameRecord& record, const std::string& terrain,
                                     display::Display& display);

}  // namespace tedavis::host_sim
