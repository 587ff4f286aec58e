/// Rays in lanes, and the times at which they cross grid lines.
///
/// On each axis a ray is mirrored so that it runs towards greater numbers: cell n of the mirrored axis is cell n of the grid,
/// or cell -1 - n where the ray runs back. A line has one crossing time, whichever cell it is computed for; the cell at a time
/// is the last one whose first line has been crossed. So the cells of a ray do not depend on the kind of traversal.
#pragma once

#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

template <class V>
struct RayAxis {
    using Float = typename V::Float;
    using Int = typename V::Int;

    Int sign;        ///< 0, or -1 where it is mirrored: `cell ^ sign` turns one number into the other
    Int cell;        ///< cell of the origin, mirrored
    Float fraction;  ///< position of the origin in its cell, mirrored: -1..1
    Float speed;     ///< cells per unit of t, above 0
    Float inverse;   ///< 1 / speed
    Int own_cell;    ///< not mirrored, with fraction and speed
    Float own_fraction, own_speed;

    /// Time at which the first line of a mirrored cell is crossed.
    TEDAVIS_LANES_INLINE Float crossing(const RayAxis& a, Int line) {
        return (V::to_float(line - a.cell) - a.fraction) * a.inverse;
    }
    /// The mirrored cell at a time. The first estimate is off by one at most.
    TEDAVIS_LANES_INLINE Int cell_at(const RayAxis& a, Float t) {
        Int n = V::floor_to_int(a.fraction + t * a.speed) + a.cell;
        n = V::select(crossing(a, n + Int(1)) <= t, n + Int(1), n);
        return V::select(crossing(a, n) > t, n - Int(1), n);
    }
    /// The ray's position 0..1 in a cell of the grid at a time.
    TEDAVIS_LANES_INLINE Float place_in(const RayAxis& a, Int own, Float t) {
        const Float place = (a.own_fraction - V::to_float(own - a.own_cell)) + t * a.own_speed;
        return V::max(V::min(place, Float(1)), Float(0));
    }
    TEDAVIS_LANES_INLINE RayAxis select(typename V::Mask m, const RayAxis& a, const RayAxis& b) {
        RayAxis s;
        s.cell = V::select(m, a.cell, b.cell);
        s.fraction = V::select(m, a.fraction, b.fraction);
        s.speed = V::select(m, a.speed, b.speed);
        s.inverse = V::select(m, a.inverse, b.inverse);
        return s;
    }
    /// Makes an axis from the origin's cell (column or row) and fraction, and from speeds that may be 0. Speeds next to 0 count
    /// as positive, because their sign is lost where denormals are flushed.
    TEDAVIS_LANES_INLINE RayAxis make(Int cell, Float fraction, Float direction) {
        constexpr float kMinSpeed = 1e-30f;
        const auto is_back = direction < Float(-kMinSpeed);
        RayAxis a;
        a.sign = V::select(is_back, Int(-1), Int(0));
        a.own_cell = cell;
        a.own_fraction = fraction;
        a.cell = (cell ^ a.sign) - a.sign;
        a.fraction = V::select(is_back, Float(0) - fraction, fraction);
        a.speed = V::max(V::select(is_back, Float(0) - direction, direction), Float(kMinSpeed));
        a.own_speed = V::select(is_back, Float(0) - a.speed, a.speed);
        a.inverse = Float(1) / a.speed;
        return a;
    }
};

template <class V>
struct RayLanes {
    using Float = typename V::Float;
    using Int = typename V::Int;

    RayAxis<V> x, y;
    Int z;  ///< origin, whole height steps
    Float z_fraction;
    Float climb;  ///< height steps per unit of t
    Float from, to;
    Float gap;  ///< height steps: a ray that begins below the surface by no more than this and roundings hits it there

    /// Height above the origin's whole height steps. Monotone in t, rounding included.
    TEDAVIS_LANES_INLINE Float height_at(const RayLanes& r, Float t) { return r.z_fraction + t * r.climb; }
};

}  // namespace tedavis::raytrace
