/// The anchor of a feature's sign: above a point, a line's middle, that of a runway, the mean of an area's corners, or a storm's
/// current position; for no-go areas and airspaces at their ceiling. Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/sign_box.hpp"

namespace tedavis::draw {

/// Computes the anchor; returns false for a run without points.
[[nodiscard]] bool anchor_of(const ElementInput& input, std::uint32_t feature, scene::ScenePoint& anchor);
/// Returns the position for an anchor: at the top where the feature has limits, where it is visible from afar.
[[nodiscard]] Placed place_of(const ElementInput& input, std::uint32_t feature, const scene::ScenePoint& anchor);
/// True for airspaces, whose signs show their vertical limits, as on charts.
[[nodiscard]] bool has_limits(const scene::Layer& layer);

/// Number of stem lengths that a sign may use; an obstacle's stem must not look like its height.
[[nodiscard]] std::uint8_t sign_stems(const scene::Layer& layer);

}  // namespace tedavis::draw
