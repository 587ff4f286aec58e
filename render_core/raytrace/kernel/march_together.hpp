/// Traverses the cells of a small, narrow beam for all its rays together, so that each cell is read only once.
///
/// The beam is followed in slabs, one cell thick, along its faster axis; in each slab all cells that any ray may cross are
/// tested in the order in which rays cross them (Wald et al. 2006, "Ray tracing animated scenes using coherent grid
/// traversal"). A ray is in a cell between the times at which it crosses the surrounding lines, so each ray has the same hit as
/// alone, bit for bit.
#pragma once

#include "render_core/raytrace/kernel/march.hpp"

namespace tedavis::raytrace {

inline constexpr int kMaxSlabs = 24;
inline constexpr std::int32_t kWidestSlab = 3;  ///< cells; wider beams are slower this way

/// An axis of a beam whose rays all run in the same direction, mirrored.
struct NarrowAxis {
    std::int32_t sign, cell;  ///< as in RayAxis
    float fraction;
    std::int32_t cells;  ///< cells of the grid

    /// Distance from the origin to the first line of a mirrored cell.
    TEDAVIS_LANES_INLINE float line(const NarrowAxis& a, std::int32_t n) { return static_cast<float>(n - a.cell) - a.fraction; }
    TEDAVIS_LANES_INLINE std::int32_t cell_at(const NarrowAxis& a, float way) { return floor_of(a.fraction + way) + a.cell; }
    TEDAVIS_LANES_INLINE bool holds(const NarrowAxis& a, std::int32_t n) {
        return static_cast<std::uint32_t>(n ^ a.sign) < static_cast<std::uint32_t>(a.cells);
    }
    TEDAVIS_LANES_INLINE std::int32_t floor_of(float a) {
        const auto whole = static_cast<std::int32_t>(a);
        return whole - (static_cast<float>(whole) > a ? 1 : 0);
    }
    template <class V>
    TEDAVIS_LANES_INLINE bool is_one_way(const RayAxis<V>& rays) {
        const std::uint32_t back = V::bits(rays.sign < typename V::Int(0));
        return back == 0 || back == V::bits(V::mask(~0u));
    }
    TEDAVIS_LANES_INLINE NarrowAxis make(bool is_back, std::int32_t cell, float fraction, std::int32_t cells) {
        return {is_back ? -1 : 0, is_back ? -cell : cell, is_back ? -fraction : fraction, cells};
    }
};

/// Tests a cell for all rays without a hit; times of crossing its lines are in the order x, y.
template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE void try_cell(const TracedNodes<Height>& field, const RayLanes<V>& ray, std::int32_t column,
                                   std::int32_t row, typename V::Float in, typename V::Float out, TraversalState<V>& m) {
    using Float = typename V::Float;
    const Float t_in = V::max(in, ray.from), t_out = V::min(out, ray.to);
    const Float z_in = RayLanes<V>::height_at(ray, t_in), z_out = RayLanes<V>::height_at(ray, t_out);
    const Float bound = CellPosts<V, Height>::above_origin(field.nodes[row * field.columns + column], ray);
    const auto asks = V::without(m.runs & (t_in < t_out), V::min(z_in, z_out) > bound);
    if (!V::any(asks)) return;
    const auto posts = CellPosts<V, Height>::of(field, ray, column, row);
    (void)intersect<V, Height, surface, HitSide::above>(ray, posts, typename V::Int(column), typename V::Int(row), t_in, t_out,
                                                        asks, m);
}

/// Follows rays from slab to slab. Returns the first slab that was not tested; rays that are still active have no hit before
/// it.
template <class V, class Height, CellSurface surface, bool is_x_fast>
TEDAVIS_LANES_INLINE std::int32_t march_slabs(const TracedNodes<Height>& field, const RayLanes<V>& ray, const NarrowAxis& fast,
                                              const NarrowAxis& slow, std::int32_t slab, TraversalState<V>& m) {
    using Float = typename V::Float;
    constexpr float kSlack = 1e-5f;
    const RayAxis<V>&fast_rays = is_x_fast ? ray.x : ray.y, &slow_rays = is_x_fast ? ray.y : ray.x;
    const Float slope = slow_rays.speed * fast_rays.inverse;
    const float least = V::least(slope) * (1 - kSlack), most = V::most(slope) * (1 + kSlack);
    for (int n = 0; n < kMaxSlabs && V::any(m.runs) && NarrowAxis::holds(fast, slab); ++n, ++slab) {
        const float begin = NarrowAxis::line(fast, slab), end = NarrowAxis::line(fast, slab + 1);
        const std::int32_t first = NarrowAxis::cell_at(slow, (begin > 0 ? begin : 0) * least - kSlack);
        const std::int32_t last = NarrowAxis::cell_at(slow, end * most + kSlack);
        if (last - first >= kWidestSlab) return slab;
        const Float fast_in = Float(begin) * fast_rays.inverse, fast_out = Float(end) * fast_rays.inverse;
        Float slow_in = Float(NarrowAxis::line(slow, first)) * slow_rays.inverse;
        for (std::int32_t cell = first; cell <= last; ++cell) {
            const Float slow_out = Float(NarrowAxis::line(slow, cell + 1)) * slow_rays.inverse;
            if (NarrowAxis::holds(slow, cell)) {
                const std::int32_t along = slab ^ fast.sign, aside = cell ^ slow.sign;
                try_cell<V, Height, surface>(field, ray, is_x_fast ? along : aside, is_x_fast ? aside : along,
                                             V::max(fast_in, slow_in), V::min(fast_out, slow_out), m);
            }
            slow_in = slow_out;
        }
    }
    return slab;
}

}  // namespace tedavis::raytrace
