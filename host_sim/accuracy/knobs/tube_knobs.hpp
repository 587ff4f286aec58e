/// Two settings of the tubes round trajectories: the number of sides of a ring, and the recorded points at which rings are placed
/// (render_core/scene/tube_mesh.hpp, render_core/draw/data/tube_path.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_tube_sides_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_tube_points_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
