/// The surface between the posts that rays are intersected with: flat pieces, some subdivisions of the smooth one, or the smooth
/// one itself (render_core/raytrace/surface; thesis 6.2.2.2).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_surface_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
