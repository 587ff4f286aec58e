/// The step between the posts of a field from which an isosurface is made (render_core/draw/data/isosurface_solids.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_isosurface_step_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
