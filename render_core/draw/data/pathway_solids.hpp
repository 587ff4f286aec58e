/// Builds planned paths as frames to fly through (pathway_frames.hpp) and thin lines; outlines only, so that nothing behind them
/// is hidden.
///
/// Frames     rectangles whose lines are kFrameLine_px wide at every distance, in the element's colour.
/// Accuracy   uncertainty `widening`: a second, dashed frame of thinner lines around, larger on each side by the accuracy (95 %)
///            of the place, to the sides and in height (cautious_accuracy() in placement.hpp). A layer that states no accuracy
///            has none. The nearest frames have one; the uncertainty's strength states their share of all frames, rounded up.
/// Lines      along the path from where frames begin to fade, to its end; lines of a layer that have no frames are shown whole.
///            Where the path is less than kFloating_m above the ground, and within kGone_m of the own ship, there is no line.
/// Rim        `halo_px` is the width of a dark rim on both sides of all lines.
///
/// Lines face the eye point. Counts are lines of the layer; hidden is what is out of a focus, has no place, lies behind the own
/// ship or has no room. Memory  none. Thread  the ground's. Bounded: kMaxPathPoints a line.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kFrameLine_px = 2, kThinLine_px = 1.25;
inline constexpr std::size_t kMaxPathPoints = 256;

/// True for layers that can be shown as pathways: planned paths.
[[nodiscard]] bool shows_pathways(const scene::Layer& layer);

[[nodiscard]] ElementCount add_pathway(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
