/// The first point at which a ray meets a surface with micro-structure in one cell: by steps that cannot pass it.
///
/// Where the ray is g above the surface and g changes no faster than L along the ray, it meets nothing within g / L (Hart 1996;
/// Lipschitz bounds). L comes from the steepest slopes of the patch and of the micro-structure.
///
/// What is inexact: a ray counts as meeting the surface where it comes as close as kSkin of the patch's range of heights and the
/// amplitude, so up to that too early, and rays that pass as closely above it count as meeting it. After kMaxSteps the ray meets
/// where it is, which is never behind the surface. Cost: a surface point a step; steep micro-structure makes steps short.
#pragma once

#include "render_core/raytrace/search/cell_ray.hpp"

namespace tedavis::raytrace {

inline constexpr double kSkin = 1e-6;
inline constexpr int kMaxSteps = 4096;

[[nodiscard]] Crossing stepwise_crossing(const CellPatch& patch, const MicroStructure& micro, const CellRay& ray);

}  // namespace tedavis::raytrace
