#include "render_core/raytrace/hit_place.hpp"

#include "render_core/raytrace/kernel/view_slopes.hpp"

namespace tedavis::raytrace {

HitPlace hit_place(const Ray& ray, const Hit& hit) {
    using Axis = RayAxis<ScalarLanes>;
    const ViewOrigin origin = ViewOrigin::of(ray.origin);
    const Axis column = Axis::make(origin.column, origin.column_fraction, ray.direction.x);
    const Axis row = Axis::make(origin.row, origin.row_fraction, ray.direction.y);
    return {Axis::place_in(column, static_cast<std::int32_t>(hit.column), hit.t),
            Axis::place_in(row, static_cast<std::int32_t>(hit.row), hit.t)};
}

}  // namespace tedavis::raytrace
