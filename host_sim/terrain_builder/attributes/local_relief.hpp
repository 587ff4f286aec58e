/// Local relief: how far a post stands above the mean of its surroundings.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"

namespace tedavis::host_sim {

/// Metres, for the inner posts row by row: height minus the mean of the valid posts in the square that reaches kReliefReach posts
/// to each side; 0 at posts without a height. Heights are rounded to 2^-10 m, which makes the sums exact. Source: the low-pass
/// difference of Hesse, "LiDAR-derived Local Relief Models", Archaeological Prospection 17, 2010, without its second step along
/// the zero line.
[[nodiscard]] std::vector<float> local_relief_m(const AttributeTile& tile);

}  // namespace tedavis::host_sim
