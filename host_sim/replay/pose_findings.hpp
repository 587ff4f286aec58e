/// What is wrong with a pose of which a picture was drawn: it lies outside the terrain, below the ground, or no terrain is in
/// view.
#pragma once

#include <string>

#include "host_sim/reports/run_findings.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

/// `terrain`: as the user named it; nothing is found where the display has none.
[[nodiscard]] Findings pose_findings(const AircraftPose& pose, const display::FrameRecord& record, const std::string& terrain,
                                     display::Display& display);

}  // namespace tedavis::host_sim
