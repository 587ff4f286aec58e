/// The error of the terrain, in pixels, that a design allows.
#pragma once

#include <memory>
#include <optional>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"
#include "host_sim/accuracy/knobs/seen_ground.hpp"
#include "render_core/display/display.hpp"

namespace tedavis::host_sim {

/// Bound of the error of terrain_error_px() in a picture of kFlownSize, for ground at least kNearestSeenPlace_m away.
inline constexpr double kSeenErrorBound_px = 2e-3;

/// Distance in pixels between a place as the planned frame draws it and its true projection; nothing where the frame draws no
/// terrain.
[[nodiscard]] std::optional<double> terrain_error_px(display::Display& display, const SeenPlace& place);

[[nodiscard]] std::unique_ptr<Knob> make_terrain_tau_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
