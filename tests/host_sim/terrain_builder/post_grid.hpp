/// Grids of posts with equal steps both ways.
#pragma once

#include "host_sim/terrain_builder/post_grid.hpp"

namespace tedavis::test_support {

[[nodiscard]] inline host_sim::PostGrid post_grid(double west_deg, double north_deg, double step_deg, std::uint32_t columns,
                                                  std::uint32_t rows) {
    host_sim::PostGrid grid;
    grid.west_deg = west_deg;
    grid.north_deg = north_deg;
    grid.step_lon_deg = grid.step_lat_deg = step_deg;
    grid.columns = columns;
    grid.rows = rows;
    grid.source = "r.tif";
    return grid;
}

}  // namespace tedavis::test_support
