/// Applies the weights of aspects to a design: each technique's detail follows the design's curves (priority.hpp), and
/// conflicts between techniques are resolved by rules:
///
///   shading      is reduced where the ground's colours convey much: by half where they are continuous and data come before
///                terrain, and so far that neighbouring classes differ by `least_difference` in its darkest shade
///   extrinsic    uncertainty is at most 1 - weight of the terrain where terrain comes first, so that no glyph hides the terrain;
///                for an element that has no room left for it, it is replaced by transparency, for a sign by a dashed rim
///   intrinsic    uncertainty keeps at least two gradations, so that uncertain data are never shown as certain
///
/// Pure functions; any thread.
#pragma once

#include "render_core/design/design_settings.hpp"

namespace tedavis::design {

/// Returns the shading at a strength 0..1; 0 is no shading.
[[nodiscard]] ShadeSettings at_strength(const ShadeSettings& shade, double strength) noexcept;
[[nodiscard]] SketchSettings at_strength(const SketchSettings& sketch, double strength) noexcept;

/// Returns the least `ambient`, not below the shade's own, at which neighbouring classes differ by `least` CIEDE2000 in the
/// darkest shade; 1 where they never do, and the shade's own for a continuous scale.
[[nodiscard]] double legible_ambient(const ShadeSettings& shade, const DataScale& scale, double least) noexcept;

/// Applies the weights to `design`, which must be as it was read.
void apply_priorities(const AspectWeights& weights, DesignSettings& design) noexcept;
/// Returns the design with the weights that it states.
[[nodiscard]] DesignSettings weighted(const DesignSettings& design) noexcept;

/// Gives `design` (after weights) the techniques and coloured lights of `like` (as it was read) that it no longer shows, at
/// invisible strengths, so that both need the same shader programs.
void keep_programs(const DesignSettings& like, DesignSettings& design) noexcept;

}  // namespace tedavis::design
