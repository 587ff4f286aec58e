/// Intersects rays in lanes with the surface of one cell each.
///
/// The heights of ray and surface are compared where the ray enters and leaves the cell and, for two triangles, where it
/// crosses the diagonal: their signs decide whether there is a hit, and only then where. A ray below the surface at its entry
/// hits it there. Surface heights are clamped between the cell's lowest and highest post, so that a node whose bound is clear
/// of a ray contains no hit.
#pragma once

#include "render_core/raytrace/kernel/ray_lanes.hpp"
#include "render_core/raytrace/kernel/traced_nodes.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

template <class V>
struct CellHit {
    typename V::Mask is_hit;
    typename V::Mask is_beyond;  ///< at the entry the ray is farther beyond the surface than is possible for a continuous one
    typename V::Float t;
};

/// Heights of a cell's posts relative to the ray's origin, and the origin's position in the cell.
template <class V, class Height>
struct CellPosts {
    using Float = typename V::Float;
    using Int = typename V::Int;
    Float nw, ne, sw, se, highest, lowest;
    Float column, row;  ///< position of the origin in the cell

    TEDAVIS_LANES_INLINE CellPosts gather(const TracedNodes<Height>& field, const RayLanes<V>& ray, Int column, Int row,
                                          typename V::Mask m) {
        const Int at = row * Int(field.stride) + column;
        CellPosts p;
        if constexpr (sizeof(Height) == 2) {
            Int a, b, c, d;
            V::gather_two(field.posts, at, m, a, b);
            V::gather_two(field.posts, at + Int(field.stride), m, c, d);
            p.nw = V::to_float(a - ray.z);
            p.ne = V::to_float(b - ray.z);
            p.sw = V::to_float(c - ray.z);
            p.se = V::to_float(d - ray.z);
        } else {
            const Float z = V::to_float(ray.z);
            V::gather_two(field.posts, at, m, p.nw, p.ne);
            V::gather_two(field.posts, at + Int(field.stride), m, p.sw, p.se);
            p.nw = p.nw - z;
            p.ne = p.ne - z;
            p.sw = p.sw - z;
            p.se = p.se - z;
        }
        finish(p, ray, column, row);
        return p;
    }
    /// Loads one cell for all rays.
    TEDAVIS_LANES_INLINE CellPosts of(const TracedNodes<Height>& field, const RayLanes<V>& ray, std::int32_t column,
                                      std::int32_t row) {
        const Height* const upper = field.posts + row * field.stride + column;
        const Height* const lower = upper + field.stride;
        CellPosts p;
        p.nw = above_origin(upper[0], ray);
        p.ne = above_origin(upper[1], ray);
        p.sw = above_origin(lower[0], ray);
        p.se = above_origin(lower[1], ray);
        finish(p, ray, Int(column), Int(row));
        return p;
    }
    TEDAVIS_LANES_INLINE Float above_origin(Height height, const RayLanes<V>& ray) {
        if constexpr (sizeof(Height) == 2)
            return V::to_float(Int(std::int32_t{height}) - ray.z);
        else
            return Float(height) - V::to_float(ray.z);
    }
    TEDAVIS_LANES_INLINE void finish(CellPosts& p, const RayLanes<V>& ray, Int column, Int row) {
        p.highest = V::max(V::max(p.nw, p.ne), V::max(p.sw, p.se));
        p.lowest = V::min(V::min(p.nw, p.ne), V::min(p.sw, p.se));
        p.column = ray.x.own_fraction - V::to_float(column - ray.x.own_cell);
        p.row = ray.y.own_fraction - V::to_float(row - ray.y.own_cell);
    }
    TEDAVIS_LANES_INLINE Float within(Float place) { return V::min(V::max(place, Float(0)), Float(1)); }
};

/// Surface heights for rays that cross a cell between a pair of times, independent of their climb: at entry and exit, and
/// between.
template <class V>
struct CellProfile {
    using Float = typename V::Float;
    Float t_in, t_out, surface_in, surface_out;
    typename V::Mask crosses;        ///< the ray crosses the diagonal
    Float t_middle, surface_middle;  ///< there
    Float bend;                      ///< bilinear: twice the surface's second-order term over the whole crossing
    Float highest, lowest;           ///< range of the posts
    Float seam, size;                ///< for seam_tolerance()
};

template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE CellProfile<V> profile_of(const RayLanes<V>& ray, const CellPosts<V, Height>& p, typename V::Float t_in,
                                               typename V::Float t_out) {
    using Float = typename V::Float;
    using Posts = CellPosts<V, Height>;
    const Float one(1), none(0);
    const Float u_in = Posts::within(p.column + t_in * ray.x.own_speed), v_in = Posts::within(p.row + t_in * ray.y.own_speed);
    const Float u_out = Posts::within(p.column + t_out * ray.x.own_speed), v_out = Posts::within(p.row + t_out * ray.y.own_speed);
    const auto held = [&](Float height) TEDAVIS_LANES_LAMBDA { return V::max(V::min(height, p.highest), p.lowest); };
    CellProfile<V> all;
    all.t_in = t_in;
    all.t_out = t_out;
    all.highest = p.highest;
    all.lowest = p.lowest;
    if constexpr (surface == CellSurface::two_triangles) {
        const auto at = [&](Float u, Float v) TEDAVIS_LANES_LAMBDA {
            const Float north = p.nw + u * (p.ne - p.nw) + v * (p.sw - p.nw);
            const Float south = p.se + (one - u) * (p.sw - p.se) + (one - v) * (p.ne - p.se);
            return held(V::select(u + v <= one, north, south));
        };
        all.surface_in = at(u_in, v_in);
        all.surface_out = at(u_out, v_out);
        const Float side_in = u_in + v_in - one, side_out = u_out + v_out - one;
        all.crosses = side_in * side_out < none;
        all.t_middle = V::min(V::max(t_in + (t_out - t_in) * (side_in / (side_in - side_out)), t_in), t_out);
        const Float u_middle = Posts::within(p.column + all.t_middle * ray.x.own_speed);
        all.surface_middle = held(p.sw + u_middle * (p.ne - p.sw));
        all.bend = none;
    } else {
        const Float twist = p.ne - p.nw + p.sw - p.se;
        const auto at = [&](Float u, Float v)
                            TEDAVIS_LANES_LAMBDA { return held(p.nw + u * (p.ne - p.nw) + v * (p.sw - p.nw) - u * v * twist); };
        all.surface_in = at(u_in, v_in);
        all.surface_out = at(u_out, v_out);
        all.bend = twist * (u_out - u_in) * (v_out - v_in);
        all.crosses = V::mask(0);
        all.t_middle = t_in;
        all.surface_middle = all.surface_in;
    }
    all.seam = (t_in * (ray.x.speed + ray.y.speed) + Float(2)) * (p.highest - p.lowest);
    all.size = V::max(p.highest, none - p.lowest);
    return all;
}

/// Upper bound of the height difference between both sides of an edge, plus the error of a ray's beginning.
template <class V>
TEDAVIS_LANES_INLINE typename V::Float seam_tolerance(const RayLanes<V>& ray, const CellProfile<V>& p, typename V::Float height) {
    using Float = typename V::Float;
    constexpr float kSteps = 4.8e-7f;  // four units in the last place
    return Float(kSteps) * (p.seam + V::max(V::max(height, Float(0) - height), p.size)) + ray.gap;
}

/// Distance of a ray at a height from the surface, positive on the side that it came from.
template <class V, HitSide side>
TEDAVIS_LANES_INLINE typename V::Float gap_of(typename V::Float height, typename V::Float surface) {
    return side == HitSide::below ? surface - height : height - surface;
}

/// Which of the `asked` rays with a hit at their entry are on the other side by more than the seam tolerance.
template <class V>
TEDAVIS_LANES_INLINE typename V::Mask is_beyond(const RayLanes<V>& ray, const CellProfile<V>& p, typename V::Float height_in,
                                                typename V::Float in, typename V::Mask is_hit_in, typename V::Mask asked) {
    if (!V::any(is_hit_in & asked)) return V::mask(0);  // rare
    return in < typename V::Float(0) - seam_tolerance<V>(ray, p, height_in);
}

template <class V, HitSide side>
TEDAVIS_LANES_INLINE CellHit<V> intersect_triangles(const RayLanes<V>& ray, const CellProfile<V>& p, typename V::Mask asked) {
    using Float = typename V::Float;
    using Lanes = RayLanes<V>;
    const Float height_in = Lanes::height_at(ray, p.t_in);
    const Float in = gap_of<V, side>(height_in, p.surface_in);
    const Float middle = gap_of<V, side>(Lanes::height_at(ray, p.t_middle), p.surface_middle);
    const Float out = gap_of<V, side>(Lanes::height_at(ray, p.t_out), p.surface_out);
    const typename V::Mask is_hit_in = in <= Float(0), is_hit_before = p.crosses & (middle <= Float(0));
    CellHit<V> m;
    m.is_hit = is_hit_in | is_hit_before | (out <= Float(0));
    m.is_beyond = is_beyond<V>(ray, p, height_in, in, is_hit_in, asked);
    // Linear interpolation between the last point on this side and the first on the other.
    const auto is_after = V::without(p.crosses, is_hit_before);
    const Float since = V::select(is_after, p.t_middle, p.t_in), gap_since = V::select(is_after, middle, in);
    const Float until = V::select(is_hit_before, p.t_middle, p.t_out), gap_until = V::select(is_hit_before, middle, out);
    m.t = V::select(is_hit_in, p.t_in, since + (until - since) * (gap_since / (gap_since - gap_until)));
    return m;
}

/// The gap of a ray over a bilinear patch is quadratic; the ray may dip below the surface between two points above it.
template <class V, HitSide side>
TEDAVIS_LANES_INLINE CellHit<V> intersect_patch(const RayLanes<V>& ray, const CellProfile<V>& p, typename V::Mask asked) {
    using Float = typename V::Float;
    using Lanes = RayLanes<V>;
    const Float height_in = Lanes::height_at(ray, p.t_in);
    const Float in = gap_of<V, side>(height_in, p.surface_in);
    const Float out = gap_of<V, side>(Lanes::height_at(ray, p.t_out), p.surface_out);
    const Float whole_bend = side == HitSide::below ? Float(0) - p.bend : p.bend;
    const Float whole_fall = in - out + whole_bend;  // of the gap, as it enters
    // Scaled by the larger one, so that no square overflows a float for a vertical ray.
    const Float scale = Float(1) / V::max(V::max(whole_fall, Float(0) - whole_fall), V::max(whole_bend, Float(0) - whole_bend));
    const Float bend = whole_bend * scale, fall = whole_fall * scale, gap = in * scale;
    const Float root = fall * fall - Float(4) * bend * gap;
    const Float width = V::sqrt(V::max(root, Float(0)));
    const auto falls = fall > Float(0);  // chooses the form of the first root without cancellation
    const Float share = V::select(falls, gap + gap, fall - width) / V::select(falls, fall + width, bend + bend);
    const Float between = p.t_in + (p.t_out - p.t_in) * share;
    const Float height = Lanes::height_at(ray, between);
    const auto is_possible = side == HitSide::below ? height >= p.lowest : height <= p.highest;
    const auto dips = (root >= Float(0)) & falls & (share < Float(1)) & is_possible;
    const auto is_hit_in = in <= Float(0);
    CellHit<V> m;
    m.is_hit = is_hit_in | dips | (out <= Float(0));
    m.is_beyond = is_beyond<V>(ray, p, height_in, in, is_hit_in, asked);
    m.t = V::select(is_hit_in, p.t_in, V::min(V::max(between, p.t_in), p.t_out));
    return m;
}

template <class V, CellSurface surface, HitSide side>
TEDAVIS_LANES_INLINE CellHit<V> intersect_surface(const RayLanes<V>& ray, const CellProfile<V>& p, typename V::Mask asked) {
    if constexpr (surface == CellSurface::two_triangles)
        return intersect_triangles<V, side>(ray, p, asked);
    else
        return intersect_patch<V, side>(ray, p, asked);
}

}  // namespace tedavis::raytrace
