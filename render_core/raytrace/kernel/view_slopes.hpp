/// The rays of a picture: their origin, and the change of their directions over the pixels.
#pragma once

#include "render_core/raytrace/kernel/ray_lanes.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

/// The origin of all rays of a picture, split into whole cells or steps and fractions.
struct ViewOrigin {
    std::int32_t column, row, z;
    float column_fraction, row_fraction, z_fraction;

    TEDAVIS_LANES_INLINE std::int32_t whole(double place) {
        const auto n = static_cast<std::int32_t>(place);
        return n - (static_cast<double>(n) > place ? 1 : 0);
    }
    TEDAVIS_LANES_INLINE ViewOrigin of(const glm::dvec3& place) {
        ViewOrigin o;
        o.column = whole(place.x);
        o.row = whole(place.y);
        o.z = whole(place.z);
        o.column_fraction = static_cast<float>(place.x - o.column);
        o.row_fraction = static_cast<float>(place.y - o.row);
        o.z_fraction = static_cast<float>(place.z - o.z);
        return o;
    }
};

/// A component of the directions as a linear function over the picture.
struct DirectionSlope {
    float corner, right, down;

    template <class V>
    TEDAVIS_LANES_INLINE typename V::Float at(const DirectionSlope& d, typename V::Float x, typename V::Float y) {
        using Float = typename V::Float;
        return Float(d.corner) + x * Float(d.right) + y * Float(d.down);
    }
    /// Largest difference from its value at the centre of a square.
    TEDAVIS_LANES_INLINE float reach(const DirectionSlope& d, float half_side) {
        return (__builtin_fabsf(d.right) + __builtin_fabsf(d.down)) * half_side;
    }
};

struct ViewSlopes {
    DirectionSlope x, y, z;
    explicit ViewSlopes(const GridCamera& c)
        : x{c.corner.x, c.right.x, c.down.x}, y{c.corner.y, c.right.y, c.down.y}, z{c.corner.z, c.right.z, c.down.z} {}
};

/// Makes rays without their directions.
template <class V>
TEDAVIS_LANES_INLINE RayLanes<V> rays_from(const ViewOrigin& origin, const RaySpan& span) {
    using Float = typename V::Float;
    RayLanes<V> ray;
    ray.z = typename V::Int(origin.z);
    ray.z_fraction = Float(origin.z_fraction);
    ray.from = Float(span.from);
    ray.to = Float(span.to);
    ray.gap = Float(span.gap);
    return ray;
}

}  // namespace tedavis::raytrace
