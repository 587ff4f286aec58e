/// Clips lines at the border of a drawing.
#pragma once

#include <vector>

namespace tedavis::host_sim {

struct MapPoint {
    double x = 0, y = 0;
};
/// Points that are joined, in order.
using MapLine = std::vector<MapPoint>;

/// Returns the parts of the lines within 0 .. `width` and 0 .. `height`, the border included: a line that leaves and comes back
/// becomes two. Lines of less than two points are left out.
[[nodiscard]] std::vector<MapLine> lines_within(const std::vector<MapLine>& lines, double width, double height);
[[nodiscard]] bool is_within(const MapPoint& point, double width, double height);

}  // namespace tedavis::host_sim
