/// Finds the first hit of a ray with a surface with micro-structure in one cell, by steps that cannot pass the surface.
///
/// Where the ray is g above the surface and g changes no faster than L along the ray, there is no hit within g / L (Hart 1996;
/// Lipschitz bounds). L comes from the steepest slopes of the patch and of the micro-structure.
///
/// What is inexact: a hit is reported where the ray comes closer to the surface than kSkin times the patch's range of heights
/// and the amplitude. So hits may be too early by that distance, and rays that pass closer than it count as hits. After
/// kMaxSteps the current point counts as the hit; it is never behind the surface. Cost: one surface point per step; steep
/// micro-structure makes steps short.
#pragma once

#include "render_core/raytrace/search/cell_ray.hpp"

namespace tedavis::raytrace {

inline constexpr double kSkin = 1e-6;
inline constexpr int kMaxSteps = 4096;

[[nodiscard]] Crossing stepwise_crossing(const CellPatch& patch, const MicroStructure& micro, const CellRay& ray);

}  // namespace tedavis::raytrace
