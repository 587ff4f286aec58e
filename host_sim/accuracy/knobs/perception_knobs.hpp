/// The size at which a picture's saliency and edges are measured (render_core/perception).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_saliency_start_knob(const KnobGround& ground);
[[nodiscard]] std::unique_ptr<Knob> make_edge_size_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
