/// Traverses a maximum mipmap with a ray (Tevs et al. 2008): skips every node that the ray lies above, and descends to the
/// cells of the others.
#pragma once

#include <algorithm>

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/search/node_walk.hpp"
#include "render_core/raytrace/search/surface_hit.hpp"

namespace tedavis::raytrace {

/// Calls `look(walk)` for the cells in the order of the ray; the first call that returns a hit ends the traversal.
template <class Height, class Look>
[[nodiscard]] SurfaceHit walk_nodes(const HeightMipmap<Height>& maxima, const Ray& ray, TraceCounts& counts, const Look& look) {
    const std::uint32_t top = maxima.levels() - 1;
    NodeWalk walk(ray, maxima.grid().columns - 1, maxima.grid().rows - 1);
    std::uint32_t level = top;
    while (walk.is_inside()) {
        ++counts.nodes;
        const Height highest = maxima.level(level).at(walk.column() >> level, walk.row() >> level);
        const double lowest_of_ray = std::min(walk.height_at(walk.t()), walk.height_at(walk.exit_t(level)));
        const bool is_above = highest == no_surface<Height>(HeightBound::maximum) || lowest_of_ray > static_cast<double>(highest);
        if (!is_above && level > 0) {
            --level;
            continue;
        }
        if (!is_above) {
            ++counts.cells;
            const SurfaceHit hit = look(walk);
            if (hit.side != HitSide::none) return hit;
        }
        walk.leave(level);
        level = std::min(level + 1, top);
    }
    return {};
}

}  // namespace tedavis::raytrace
