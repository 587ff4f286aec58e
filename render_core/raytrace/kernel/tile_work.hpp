/// The data that the rays of a tile share.
#pragma once

#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/kernel/view_slopes.hpp"

namespace tedavis::raytrace {

template <class V, class Height>
struct TileWork {
    const ViewJob<Height>& job;
    const TracedNodes<Height> nodes;
    const ViewOrigin origin;
    const ViewSlopes slopes;
    const std::uint32_t left, top;

    TileWork(const ViewJob<Height>& asked, std::uint32_t x, std::uint32_t y)
        : job(asked),
          nodes(*asked.field->maxima),
          origin(ViewOrigin::of(asked.camera->origin)),
          slopes(*asked.camera),
          left(x),
          top(y) {}
    /// Returns the rays through points of the picture.
    [[nodiscard]] __attribute__((always_inline)) RayLanes<V> rays(typename V::Float x, typename V::Float y) const {
        using Axis = RayAxis<V>;
        using Float = typename V::Float;
        using Int = typename V::Int;
        RayLanes<V> ray = rays_from<V>(origin, job.span);
        ray.x = Axis::make(Int(origin.column), Float(origin.column_fraction), DirectionSlope::at<V>(slopes.x, x, y));
        ray.y = Axis::make(Int(origin.row), Float(origin.row_fraction), DirectionSlope::at<V>(slopes.y, x, y));
        ray.climb = DirectionSlope::at<V>(slopes.z, x, y);
        return ray;
    }
};

}  // namespace tedavis::raytrace
