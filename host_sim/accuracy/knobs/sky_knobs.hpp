/// Two settings of the sky that is visible from a post: the azimuths along which its horizon is searched, and how far
/// (render_core/raytrace/shading/sky_map.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

/// At the radius of `tedavis trace`.
[[nodiscard]] std::unique_ptr<Knob> make_sky_azimuths_knob(const KnobGround& ground);
/// With the azimuths of `tedavis trace`.
[[nodiscard]] std::unique_ptr<Knob> make_sky_radius_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
