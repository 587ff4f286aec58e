/// The work of seams.hpp. Everything depends on `Lanes`, so that sources with other flags share no compiled function.
#pragma once

#include <cmath>

#include "render_core/raytrace/kernel/march.hpp"
#include "tests/support/contraction/seams.hpp"

namespace tedavis::test_support {

template <class Lanes>
struct SeamWork {
    struct Point {
        float x, y;
    };
    /// Twice the area of the triangle of a, b and the origin; positive to the left of a -> b.
    __attribute__((noinline)) static float edge_function(Point a, Point b) { return a.x * b.y - a.y * b.x; }

    static std::uint32_t mix(std::uint32_t& state) {
        state = state * 1664525u + 1013904223u;
        return (state ^ (state >> 16)) * 0x85ebca6bu;
    }
    static EdgeSeams edges(std::uint64_t points) {
        EdgeSeams found;
        std::uint32_t state = 1;
        const auto number = [&] { return static_cast<float>(mix(state) >> 8) * 0x1p-20f; };
        for (; found.points < points; ++found.points) {
            const Point a{number(), number()}, b{number(), number()};
            const float along = static_cast<float>(mix(state) >> 8) * 0x1p-24f;
            const float across = (b.x - a.x) * along, down = (b.y - a.y) * along;
            const Point at{a.x + across, a.y + down};
            const Point first{a.x - at.x, a.y - at.y}, second{b.x - at.x, b.y - at.y};
            const float forth = edge_function(first, second), back = edge_function(second, first);
            found.uneven += forth != -back;
            found.gaps += forth < 0 && back < 0;
        }
        return found;
    }

    static raytrace::Hit trace(const raytrace::HeightMipmap<std::int16_t>& maxima, const raytrace::Ray& ray) {
        using namespace raytrace;
        const double column = std::floor(ray.origin.x), row = std::floor(ray.origin.y), z = std::floor(ray.origin.z);
        RayLanes<Lanes> lanes;
        using Axis = RayAxis<Lanes>;
        lanes.x = Axis::make(static_cast<std::int32_t>(column), static_cast<float>(ray.origin.x - column), ray.direction.x);
        lanes.y = Axis::make(static_cast<std::int32_t>(row), static_cast<float>(ray.origin.y - row), ray.direction.y);
        lanes.z = static_cast<std::int32_t>(z);
        lanes.z_fraction = static_cast<float>(ray.origin.z - z);
        lanes.climb = ray.direction.z;
        lanes.from = ray.from;
        lanes.to = ray.to;
        lanes.gap = ray.gap;
        const TracedNodes<std::int16_t> nodes(maxima);
        TraversalState<Lanes> m = enter<Lanes, std::int16_t>(nodes, lanes, lanes.from, true, nodes.layout->top);
        march_nodes<Lanes, std::int16_t, CellSurface::two_triangles, HitSide::above>(nodes, lanes, m);
        Hit hit;
        if (!m.is_hit || m.is_beyond) return hit;
        hit.side = HitSide::above;
        hit.t = m.hit_t;
        hit.column = static_cast<std::uint32_t>(m.hit_column);
        hit.row = static_cast<std::uint32_t>(m.hit_row);
        return hit;
    }
};

}  // namespace tedavis::test_support
