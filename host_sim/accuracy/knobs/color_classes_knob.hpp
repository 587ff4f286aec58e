/// The classes of a colour scale: how far the value that is read from a colour is from the true one
/// (render_core/design/data_scale.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_color_classes_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
