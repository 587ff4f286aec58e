/// Heights above the ellipsoid from heights above MSL.
#pragma once

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/lattice_window.hpp"

namespace tedavis::host_sim {

/// Fills in surface_m of the window. A post has the same bits in every window; posts outside keep height 0.
void add_undulation(const BuildPlan& plan, LatticeWindow& window);

}  // namespace tedavis::host_sim
