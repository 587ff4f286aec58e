/// Settings of effects, measured by the colours of pictures: the size of the shadow map, taps and squares of a blur, the steps of
/// light shafts, the levels of a focus' context, and the pages of baked maps in memory.
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_shadow_map_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_blur_taps_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_blur_squares_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_shaft_steps_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_focus_levels_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_map_pages_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
