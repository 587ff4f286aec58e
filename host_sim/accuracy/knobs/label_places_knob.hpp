/// The places beside and above its point that a name may take (render_core/draw/data/label_planner.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::unique_ptr<Knob> make_label_places_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
