#include "render_core/earth/magnified_segment.hpp"

#include <cmath>
#include <glm/matrix.hpp>
#include <utility>

namespace tedavis::earth::magnified_segment {

Shares within(const Magnifier::Cell& cell, const glm::dvec2& begin, const glm::dvec2& by) {
    Shares shares;
    for (const glm::dvec3& edge : cell.edges) {
        const double at_begin = glm::dot(edge, glm::dvec3(begin, 1)), change = glm::dot(glm::dvec2(edge), by);
        if (change > 0)
            shares.from = std::fmax(shares.from, -at_begin / change);
        else if (change < 0)
            shares.to = std::fmin(shares.to, -at_begin / change);
        else if (at_begin < 0)
            return {1, 0};
    }
    return shares;
}

bool part_over(const Magnifier& magnifier, const Magnifier::Cell& cell, const TrueSegment& shown, TrueSegment& part) {
    const glm::dmat2 back = glm::inverse(cell.slope);
    const glm::dvec2 begin = back * (magnifier.in_plane(shown.begin) - cell.shift);
    const glm::dvec2 by = back * (magnifier.in_plane(shown.end) - magnifier.in_plane(shown.begin));
    const Shares shares = within(cell, begin, by);
    if (!shares.is_any()) return false;
    const glm::dvec3 way = shown.end - shown.begin;
    const auto at = [&](double share) {
        const Ecef place = shown.begin + way * share;
        return magnifier.shifted(place, magnifier.in_plane(place), begin + by * share);
    };
    part = {at(shares.from), at(shares.to)};
    return true;
}

Moved moved_shares(const Magnifiers& magnifiers, const TrueSegment& shown) {
    Moved moved;
    for (const Magnifier& magnifier : magnifiers) {
        const glm::dvec2 begin = magnifier.in_plane(shown.begin);
        const Shares shares = within(magnifier.cell(magnifier.cell_count() - 1), begin, magnifier.in_plane(shown.end) - begin);
        if (!shares.is_any()) continue;
        std::size_t n = moved.count++;
        moved.of[n] = shares;
        for (; n > 0 && moved.of[n].from < moved.of[n - 1].from; --n) std::swap(moved.of[n], moved.of[n - 1]);
    }
    return moved;
}

}  // namespace tedavis::earth::magnified_segment
