/// The form of the overlap of sun and aperture in ambient aperture lighting: one smoothstep or the exact area
/// (render_core/raytrace/shading/cap_overlap.hpp; Oat and Sander 2007).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_cap_overlap_knob(const KnobGround& ground);

/// The knob's reference: the overlap of two caps whose circles cross, in steradians, by the area of a circular lune with three
/// arc cosines in long double.
[[nodiscard]] double overlap_by_arc_cosines(double radius_a_rad, double radius_b_rad, double distance_rad);

}  // namespace tedavis::host_sim
