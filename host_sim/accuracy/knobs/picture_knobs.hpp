/// Two settings of traced pictures: antialiasing rays of a pixel, and light paths from a pixel
/// (render_core/raytrace/picture/trace_settings.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_antialias_rays_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_light_paths_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
