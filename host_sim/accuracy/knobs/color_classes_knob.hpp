/// The number of classes of a colour scale; the error is that of the value read from a colour
/// (render_core/design/data_scale.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_color_classes_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
