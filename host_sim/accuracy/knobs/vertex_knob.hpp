/// The number format in which the screen position of a terrain vertex is computed (render_core/draw/shaders/terrain_place.vert),
/// a setting with one level.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_vertex_precision_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
