/// Traversal of rays in lanes to the cells that they hit: from cell to cell, or through the nodes of a mipmap.
///
/// Both traversals test the same cells, except those whose bounds exclude a hit, and give the same bits.
#pragma once

#include "render_core/raytrace/kernel/cell_crossing.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

/// The traversal state of rays, and their hits.
template <class V>
struct TraversalState {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Mask = typename V::Mask;

    Mask runs;  ///< active: no hit yet, and still in the grid
    Float t;
    Float leaves;     ///< time at which they leave the grid or end
    Int column, row;  ///< cell at t, in mirrored coordinates
    Int level;
    Mask is_hit, is_beyond;
    Float hit_t;
    Int hit_column, hit_row;  ///< in the grid

    Mask asks;    ///< have reached a cell that they may hit
    Mask passes;  ///< have no hit in their cell
};

/// The lowest mirrored cell number of an axis with this many cells.
template <class V>
TEDAVIS_LANES_INLINE typename V::Int first_cell(const RayAxis<V>& axis, std::int32_t cells) {
    using Int = typename V::Int;
    return axis.sign & Int(-cells);
}

/// Computes when rays enter and leave the grid, not in which cell. Rays that never enter it, or only at infinite time, are not
/// active.
template <class V, class Height>
TEDAVIS_LANES_INLINE TraversalState<V> enter_times(const TracedNodes<Height>& field, const RayLanes<V>& ray,
                                                   typename V::Float from, typename V::Mask asked, typename V::Int level) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Axis = RayAxis<V>;
    constexpr float kNever = 1e29f;
    const Int columns(field.columns), rows(field.rows);
    const Int first_x = first_cell<V>(ray.x, field.columns), first_y = first_cell<V>(ray.y, field.rows);
    const Float in = V::max(from, V::max(Axis::crossing(ray.x, first_x), Axis::crossing(ray.y, first_y)));
    TraversalState<V> m;
    m.leaves = V::min(ray.to, V::min(Axis::crossing(ray.x, first_x + columns), Axis::crossing(ray.y, first_y + rows)));
    m.runs = asked & (in < m.leaves) & (in < Float(kNever));
    m.t = V::select(m.runs, in, Float(0));
    m.column = m.row = Int(0);
    m.level = level;
    m.is_hit = m.is_beyond = m.asks = m.passes = V::mask(0);
    m.hit_t = Float(0);
    m.hit_column = m.hit_row = Int(0);
    return m;
}

/// Computes the cells in which they enter the grid.
template <class V, class Height>
TEDAVIS_LANES_INLINE void enter_cells(const TracedNodes<Height>& field, const RayLanes<V>& ray, TraversalState<V>& m) {
    using Int = typename V::Int;
    const auto entered = [&m](const RayAxis<V>& axis, std::int32_t cells) TEDAVIS_LANES_LAMBDA {
        const Int first = first_cell<V>(axis, cells);
        return V::min(V::max(RayAxis<V>::cell_at(axis, m.t), first), first + Int(cells - 1));
    };
    m.column = entered(ray.x, field.columns);
    m.row = entered(ray.y, field.rows);
}

template <class V, class Height>
TEDAVIS_LANES_INLINE TraversalState<V> enter(const TracedNodes<Height>& field, const RayLanes<V>& ray, typename V::Float from,
                                             typename V::Mask asked, typename V::Int level) {
    TraversalState<V> m = enter_times<V, Height>(field, ray, from, asked, level);
    enter_cells<V, Height>(field, ray, m);
    return m;
}

/// Returns which rays stay on their side of the node's bound until they leave the node.
template <class V, class Height, HitSide side>
TEDAVIS_LANES_INLINE typename V::Mask stays_clear(const TracedNodes<Height>& field, const RayLanes<V>& ray,
                                                  const TraversalState<V>& m, typename V::Float t_out, typename V::Int node,
                                                  typename V::Mask asked) {
    using Float = typename V::Float;
    const auto falls = ray.climb < Float(0);
    constexpr bool is_from_below = side == HitSide::below;
    const Float nearest =
        RayLanes<V>::height_at(ray, is_from_below ? V::select(falls, m.t, t_out) : V::select(falls, t_out, m.t));
    Float bound;
    if constexpr (sizeof(Height) == 2)
        bound = V::to_float(V::gather(field.nodes, node, asked) - ray.z);
    else
        bound = V::gather(field.nodes, node, asked) - V::to_float(ray.z);
    return is_from_below ? nearest < bound : nearest > bound;
}

/// Returns which of the `asked` rays hit the surface of their cell.
template <class V, class Height, CellSurface surface, HitSide side>
TEDAVIS_LANES_INLINE typename V::Mask intersect(const RayLanes<V>& ray, const CellPosts<V, Height>& posts, typename V::Int column,
                                                typename V::Int row, typename V::Float t_in, typename V::Float t_out,
                                                typename V::Mask asked, TraversalState<V>& m) {
    const auto profile = profile_of<V, Height, surface>(ray, posts, t_in, t_out);
    const CellHit<V> cell_hit = intersect_surface<V, surface, side>(ray, profile, asked);
    const auto hit = asked & cell_hit.is_hit;
    m.is_hit = m.is_hit | hit;
    m.is_beyond = m.is_beyond | (hit & cell_hit.is_beyond);
    m.hit_t = V::select(hit, cell_hit.t, m.hit_t);
    m.hit_column = V::select(hit, column, m.hit_column);
    m.hit_row = V::select(hit, row, m.hit_row);
    m.runs = V::without(m.runs, hit);
    return hit;
}

/// Tests the cells of the rays that have reached one.
template <class V, class Height, CellSurface surface, HitSide side>
TEDAVIS_LANES_INLINE void intersect_cells(const TracedNodes<Height>& field, const RayLanes<V>& ray, TraversalState<V>& m) {
    using Int = typename V::Int;
    using Float = typename V::Float;
    using Axis = RayAxis<V>;
    const Int one(1), column = m.column ^ ray.x.sign, row = m.row ^ ray.y.sign;
    const auto posts = CellPosts<V, Height>::gather(field, ray, column, row, m.asks);
    const Float t_in = V::max(V::max(Axis::crossing(ray.x, m.column), Axis::crossing(ray.y, m.row)), ray.from);
    const Float t_out = V::min(V::min(Axis::crossing(ray.x, m.column + one), Axis::crossing(ray.y, m.row + one)), ray.to);
    const auto hit = intersect<V, Height, surface, side>(ray, posts, column, row, t_in, t_out, m.asks, m);
    m.passes = V::without(m.asks, hit);
    m.asks = V::mask(0);
}

/// Traverses cell by cell, for rays that are close to their hit. Ends after a number of cells.
template <class V, class Height, CellSurface surface, HitSide side>
TEDAVIS_LANES_INLINE void march_cells(const TracedNodes<Height>& field, const RayLanes<V>& ray, TraversalState<V>& m, int most) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Mask = typename V::Mask;
    using Axis = RayAxis<V>;
    const Int none(0), one(1), across(field.columns);
    m.level = none;
    const Int step_x = ray.x.sign | one, step_y = V::select(ray.y.sign < none, none - across, across);
    Int node = (m.row ^ ray.y.sign) * across + (m.column ^ ray.x.sign);
    Float t_x = Axis::crossing(ray.x, m.column + one), t_y = Axis::crossing(ray.y, m.row + one);
    while (true) {
        const Mask steps = V::without(m.runs, m.asks);
        if (!V::any(steps) || most-- <= 0) {
            if (!V::any(m.asks)) return;
            intersect_cells<V, Height, surface, side>(field, ray, m);
            continue;
        }
        const Float t_out = V::min(t_x, t_y);
        const Mask skips = steps & (stays_clear<V, Height, side>(field, ray, m, t_out, node, steps) | m.passes);
        m.asks = m.asks | V::without(steps, skips);
        m.passes = V::without(m.passes, skips);
        const Mask by_x = skips & (t_x <= t_y), by_y = skips & (t_y <= t_x);
        m.column = V::select(by_x, m.column + one, m.column);
        m.row = V::select(by_y, m.row + one, m.row);
        node = V::select(by_x, node + step_x, node);
        node = V::select(by_y, node + step_y, node);
        m.t = V::select(skips, t_out, m.t);
        m.runs = m.runs & (m.t < m.leaves);
        t_x = Axis::crossing(ray.x, m.column + one);
        t_y = Axis::crossing(ray.y, m.row + one);
    }
}

/// One step: to the next node, or one level down; rays that stop at level `finest` request a cell test.
template <class V, class Height, HitSide side, int finest = 0>
TEDAVIS_LANES_INLINE void step_node(const TracedNodes<Height>& field, const RayLanes<V>& ray, TraversalState<V>& m,
                                    typename V::Mask steps) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Mask = typename V::Mask;
    using Axis = RayAxis<V>;
    const Int none(0), one(1), top(field.layout->top), least(finest);
    const Int inside = (one << m.level) - one;
    const Int line_x = (m.column | inside) + one, line_y = (m.row | inside) + one;
    const Float t_x = Axis::crossing(ray.x, line_x), t_y = Axis::crossing(ray.y, line_y);
    const Float t_out = V::min(t_x, t_y);
    const Int node = V::look_up(field.layout->first, m.level) +
                     ((m.row >> m.level) ^ ray.y.sign) * V::look_up(field.layout->columns, m.level) +
                     ((m.column >> m.level) ^ ray.x.sign);
    const Mask skips = steps & (stays_clear<V, Height, side>(field, ray, m, t_out, node, steps) | m.passes);
    const Mask halts = V::without(steps, skips), is_cell = m.level == least;
    m.asks = m.asks | (halts & is_cell);
    m.passes = V::without(m.passes, skips);

    const Mask by_x = t_x <= t_y;
    const Int other = Axis::cell_at(Axis::select(by_x, ray.y, ray.x), t_out);
    m.column = V::select(skips, V::select(by_x, line_x, other), m.column);
    m.row = V::select(skips, V::select(by_x, other, line_y), m.row);
    m.t = V::select(skips, t_out, m.t);
    m.runs = m.runs & (m.t < m.leaves);
    const Int crossed = V::select(by_x, line_x, line_y) >> m.level;
    const Mask rises = skips & ((crossed & one) == none) & (m.level < top);
    m.level = V::select(rises, m.level + one, V::select(V::without(halts, is_cell), m.level - one, m.level));
}

/// Traverses nodes to the end.
template <class V, class Height, CellSurface surface, HitSide side>
TEDAVIS_LANES_INLINE void march_nodes(const TracedNodes<Height>& field, const RayLanes<V>& ray, TraversalState<V>& m) {
    while (true) {
        const auto steps = V::without(m.runs, m.asks);
        if (V::any(steps)) {
            step_node<V, Height, side>(field, ray, m, steps);
        } else {
            if (!V::any(m.asks)) return;
            intersect_cells<V, Height, surface, side>(field, ray, m);
        }
    }
}

}  // namespace tedavis::raytrace
