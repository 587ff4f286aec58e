/// A design as the weights of its aspects leave it: each technique conveys as much of its most as the design's curves say
/// (priority.hpp), and what would spoil something else gives way by rule:
///
///   shading      falls where the ground's colours say much: by half where they are continuous and data come before terrain; and
///                so far that neighbouring classes differ by `least_difference` in its darkest shade
///   extrinsic    uncertainty is at most 1 - weight of the terrain where terrain comes first, so that no glyph hides it; of an
///                element that has no more room for it transparency takes its place, of a sign a broken rim
///   intrinsic    uncertainty never falls below two gradations: what is unsure is never shown as sure
///
/// Pure functions; any thread.
#pragma once

#include "render_core/design/design_settings.hpp"

namespace tedavis::design {

/// 0..1; 0 is no shading at all.
[[nodiscard]] ShadeSettings at_strength(const ShadeSettings& shade, double strength) noexcept;
[[nodiscard]] SketchSettings at_strength(const SketchSettings& sketch, double strength) noexcept;

/// The least `ambient`, no less than the shade's own, at which neighbouring classes differ by `least` CIEDE2000 in its darkest
/// shade; 1 where they never do. Of a continuous scale the shade's own.
[[nodiscard]] double legible_ambient(const ShadeSettings& shade, const DataScale& scale, double least) noexcept;

/// In place, of `design` as it was read.
void weigh(const AspectWeights& weights, DesignSettings& design) noexcept;
/// By the weights that the design states.
[[nodiscard]] DesignSettings weighted(const DesignSettings& design) noexcept;

/// Strengths, techniques and colours of light that `like`, the design as it was read, shows and `design`, at some weights, does
/// not, so faint that nobody sees them: both have the same programs.
void keep_programs(const DesignSettings& like, DesignSettings& design) noexcept;

}  // namespace tedavis::design
