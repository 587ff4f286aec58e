/// Where rays in lanes meet the surface of one cell each.
///
/// The surface is compared with the ray where it enters and leaves the cell and, of two triangles, where it crosses from one to
/// the other: signs decide whether it is met, and only then where. A ray below the surface as it enters has met it there.
/// Heights of the surface are held below the cell's highest post, so that a node that lies below a ray holds no meeting.
#pragma once

#include "render_core/raytrace/kernel/ray_lanes.hpp"
#include "render_core/raytrace/kernel/traced_nodes.hpp"
#include "render_core/raytrace/ray.hpp"

namespace tedavis::raytrace {

template <class V>
struct CellMeeting {
    typename V::Mask is_met;
    typename V::Mask is_beyond;  ///< it is on the other side as it enters, by more than a continuous surface allows
    typename V::Float t;
};

/// Heights of a cell's posts above the ray's own, and the ray's place in the cell.
template <class V, class Height>
struct CellPosts {
    using Float = typename V::Float;
    using Int = typename V::Int;
    Float nw, ne, sw, se, highest, lowest;
    Float column, row;  ///< of the origin in the cell

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
    /// Of one cell for all rays.
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

/// How far the ray is from the surface, on the side that it came along.
template <class V, class Height, HitSide side>
struct RayGap {
    using Float = typename V::Float;
    Float t, u, v, height, gap;

    TEDAVIS_LANES_INLINE RayGap at(const RayLanes<V>& ray, const CellPosts<V, Height>& p, Float t) {
        using Posts = CellPosts<V, Height>;
        RayGap g;
        g.t = t;
        g.u = Posts::within(p.column + t * ray.x.own_speed);
        g.v = Posts::within(p.row + t * ray.y.own_speed);
        g.height = RayLanes<V>::height_at(ray, t);
        return g;
    }
    TEDAVIS_LANES_INLINE void compare(RayGap& g, const CellPosts<V, Height>& p, Float surface) {
        if constexpr (side == HitSide::below)
            g.gap = V::max(surface, p.lowest) - g.height;
        else
            g.gap = g.height - V::min(surface, p.highest);
    }
    TEDAVIS_LANES_INLINE void over_triangles(RayGap& g, const CellPosts<V, Height>& p) {
        const Float north = p.nw + g.u * (p.ne - p.nw) + g.v * (p.sw - p.nw);
        const Float south = p.se + (Float(1) - g.u) * (p.sw - p.se) + (Float(1) - g.v) * (p.ne - p.se);
        compare(g, p, V::select(g.u + g.v <= Float(1), north, south));
    }
    TEDAVIS_LANES_INLINE void over_patch(RayGap& g, const CellPosts<V, Height>& p) {
        compare(g, p, p.nw + g.u * (p.ne - p.nw) + g.v * (p.sw - p.nw) + g.u * g.v * (p.nw - p.ne - p.sw + p.se));
    }
};

/// What two sides of an edge may differ by, and more.
template <class V, class Height, HitSide side>
TEDAVIS_LANES_INLINE typename V::Float seam_tolerance(const RayLanes<V>& ray, const CellPosts<V, Height>& p,
                                                      const RayGap<V, Height, side>& in) {
    using Float = typename V::Float;
    constexpr float kSteps = 4.8e-7f;  // four units in the last place
    const Float far = in.t * (ray.x.speed + ray.y.speed) + Float(2);
    const Float height = V::max(V::max(in.height, Float(0) - in.height), V::max(p.highest, Float(0) - p.lowest));
    return Float(kSteps) * (far * (p.highest - p.lowest) + height);
}

/// Between two places where the gap is more than 0 and not; linear between.
template <class V, class Height, HitSide side>
TEDAVIS_LANES_INLINE typename V::Float meeting_between(const RayGap<V, Height, side>& a, const RayGap<V, Height, side>& b) {
    return a.t + (b.t - a.t) * (a.gap / (a.gap - b.gap));
}

template <class V, class Height, HitSide side>
TEDAVIS_LANES_INLINE CellMeeting<V> meet_triangles(const RayLanes<V>& ray, const CellPosts<V, Height>& p, typename V::Float t_in,
                                                   typename V::Float t_out) {
    using Float = typename V::Float;
    using Gap = RayGap<V, Height, side>;
    Gap in = Gap::at(ray, p, t_in), out = Gap::at(ray, p, t_out);
    Gap::over_triangles(in, p);
    Gap::over_triangles(out, p);
    const Float side_in = in.u + in.v - Float(1), side_out = out.u + out.v - Float(1);
    const auto crosses = side_in * side_out < Float(0);
    Gap middle = Gap::at(ray, p, V::min(V::max(t_in + (t_out - t_in) * (side_in / (side_in - side_out)), t_in), t_out));
    Gap::compare(middle, p, p.sw + middle.u * (p.ne - p.sw));

    CellMeeting<V> m;
    const auto is_met_in = in.gap <= Float(0);
    const auto is_met_before = crosses & (middle.gap <= Float(0));
    m.is_met = is_met_in | is_met_before | (out.gap <= Float(0));
    m.is_beyond = in.gap < Float(0) - seam_tolerance<V, Height, side>(ray, p, in);
    Gap a, b;
    const auto is_after = V::without(crosses, is_met_before);
    a.t = V::select(is_after, middle.t, in.t);
    a.gap = V::select(is_after, middle.gap, in.gap);
    b.t = V::select(is_met_before, middle.t, out.t);
    b.gap = V::select(is_met_before, middle.gap, out.gap);
    m.t = V::select(is_met_in, t_in, meeting_between<V, Height, side>(a, b));
    return m;
}

/// A ray over a bilinear patch has a quadratic gap; it may dip below the surface between two places above it.
template <class V, class Height, HitSide side>
TEDAVIS_LANES_INLINE CellMeeting<V> meet_patch(const RayLanes<V>& ray, const CellPosts<V, Height>& p, typename V::Float t_in,
                                               typename V::Float t_out) {
    using Float = typename V::Float;
    using Gap = RayGap<V, Height, side>;
    Gap in = Gap::at(ray, p, t_in), out = Gap::at(ray, p, t_out);
    Gap::over_patch(in, p);
    Gap::over_patch(out, p);
    const Float twist = side == HitSide::below ? p.nw - p.ne - p.sw + p.se : p.ne - p.nw + p.sw - p.se;
    const Float whole_bend = twist * (out.u - in.u) * (out.v - in.v);
    const Float whole_fall = in.gap - out.gap + whole_bend;  // of the gap, as it enters
    // Over the larger of both, so that no square is too large for a float where a ray stands upright.
    const Float scale = Float(1) / V::max(V::max(whole_fall, Float(0) - whole_fall), V::max(whole_bend, Float(0) - whole_bend));
    const Float bend = whole_bend * scale, fall = whole_fall * scale, gap = in.gap * scale;
    const Float root = fall * fall - Float(4) * bend * gap;
    const Float width = V::sqrt(V::max(root, Float(0)));
    const auto falls = fall > Float(0);  // whichever form of the first root takes nothing away from its like
    const Float share = V::select(falls, gap + gap, fall - width) / V::select(falls, fall + width, bend + bend);
    const Float between = t_in + (t_out - t_in) * share;
    const auto dips = (root >= Float(0)) & falls & (share < Float(1)) & (RayLanes<V>::height_at(ray, between) <= p.highest);

    CellMeeting<V> m;
    const auto is_met_in = in.gap <= Float(0);
    m.is_met = is_met_in | dips | (out.gap <= Float(0));
    m.is_beyond = in.gap < Float(0) - seam_tolerance<V, Height, side>(ray, p, in);
    m.t = V::select(is_met_in, t_in, V::min(V::max(between, t_in), t_out));
    return m;
}

}  // namespace tedavis::raytrace
