#include "host_sim/reports/map_lines.hpp"

#include <algorithm>
#include <utility>

namespace tedavis::host_sim {
namespace {

/// The part of a leg that is inside, as shares of it; empty where `from` is above `to`.
struct LegPart {
    double from = 0, to = 1;

    /// Keeps where start + share * change is at least 0.
    void keep_positive(double start, double change) {
        if (change == 0) {
            if (start < 0) from = 2;
            return;
        }
        const double at = -start / change;
        if (change > 0) from = std::max(from, at);
        if (change < 0) to = std::min(to, at);
    }
};

MapPoint point_of_leg(const MapPoint& a, const MapPoint& b, double share) {
    if (share == 0) return a;
    return share == 1 ? b : MapPoint{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

void add_lines_within(const MapLine& line, double width, double height, std::vector<MapLine>& within) {
    bool is_joined = false;  // the last line goes on where this leg begins
    for (std::size_t n = 1; n < line.size(); ++n) {
        const MapPoint &a = line[n - 1], &b = line[n];
        LegPart part;
        part.keep_positive(a.x, b.x - a.x);
        part.keep_positive(width - a.x, a.x - b.x);
        part.keep_positive(a.y, b.y - a.y);
        part.keep_positive(height - a.y, a.y - b.y);
        if (part.from > part.to) {
            is_joined = false;
            continue;
        }
        if (!is_joined) within.push_back({point_of_leg(a, b, part.from)});
        within.back().push_back(point_of_leg(a, b, part.to));
        is_joined = part.to == 1;
    }
}

}  // namespace

std::vector<MapLine> lines_within(const std::vector<MapLine>& lines, double width, double height) {
    std::vector<MapLine> within;
    for (const MapLine& line : lines) add_lines_within(line, width, height, within);
    return within;
}

bool is_within(const MapPoint& point, double width, double height) {
    return point.x >= 0 && point.x <= width && point.y >= 0 && point.y <= height;
}

}  // namespace tedavis::host_sim
