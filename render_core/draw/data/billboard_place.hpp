/// Where the sign of a feature stands: above a point, a line's middle, the middle of an area's corners, where the storm has gone
/// to; no-go areas and airspaces have theirs at their ceiling. Pure but for the ground that is asked. Bounded.
#pragma once

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/sign_box.hpp"

namespace tedavis::draw {

/// False of a run without points, which has none.
[[nodiscard]] bool anchor_of(const ElementInput& input, std::uint32_t feature, scene::ScenePoint& anchor);
/// Of this anchor: at the top where the feature has limits, for there it is seen from afar.
[[nodiscard]] Placed place_of(const ElementInput& input, std::uint32_t feature, const scene::ScenePoint& anchor);
/// Airspaces stand there with what they reach from and to, as on charts.
[[nodiscard]] bool has_limits(const scene::Layer& layer);

/// How many lengths a stem may have: that of an obstacle would read as its height.
[[nodiscard]] std::uint8_t sign_stems(const scene::Layer& layer);

}  // namespace tedavis::draw
