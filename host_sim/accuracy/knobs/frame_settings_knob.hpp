/// Combinations of the settings by which a user trades the accuracy of a frame for its time: the error allowed for the terrain,
/// and the share of the window that is drawn. Their Pareto front is that of both settings together.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

inline constexpr char kFrameSettings[] = "frame_settings";

[[nodiscard]] std::unique_ptr<Knob> make_frame_settings_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
