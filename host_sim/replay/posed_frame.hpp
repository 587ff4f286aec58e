/// Draws one picture from a given pose, after all the terrain that it requests is loaded.
#pragma once

#include "host_sim/replay/display_session.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

/// Loads the terrain, plans and draws; the pixels stay in the session.
[[nodiscard]] FrameResult posed_frame(DisplaySession& session, const AircraftPose& pose, const flight::PhaseStatus& phase);

}  // namespace tedavis::host_sim
