/// Finds how far along a beam of rays with one origin none of its rays hits anything.
///
/// A beam is the hull of its rays: at time t they lie in a box that grows with t. It is advanced as long as the box, over a
/// span of time, lies above the 2 x 2 nodes that contain it. The hull is used instead of the corner rays, so the result is
/// conservative. Boxes are enlarged by more than the rounding of rays in lanes.
#pragma once

#include "render_core/raytrace/kernel/ray_lanes.hpp"
#include "render_core/raytrace/kernel/traced_nodes.hpp"

namespace tedavis::raytrace {

/// The range of speeds of a beam's rays along an axis.
template <class V>
struct BeamAxis {
    using Float = typename V::Float;
    using Int = typename V::Int;
    Float least, most;
    Float per_least, per_most;  ///< reciprocals of the speeds
    typename V::Mask is_back;   ///< the beam runs towards lower cell numbers
    typename V::Mask goes_down, goes_up;

    TEDAVIS_LANES_INLINE BeamAxis make(Float middle, Float half) {
        constexpr float kWider = 1e-5f;
        BeamAxis a;
        const Float size = V::max(middle, Float(0) - middle) + half;
        a.least = middle - half - size * Float(kWider);
        a.most = middle + half + size * Float(kWider);
        a.is_back = middle < Float(0);
        a.goes_down = a.least < Float(0);
        a.goes_up = a.most > Float(0);
        a.per_least = Float(1) / V::select(a.goes_down, a.least, Float(1));
        a.per_most = Float(1) / V::select(a.goes_up, a.most, Float(1));
        return a;
    }
};

/// The nodes of an axis that a beam lies over, two of a level, and the time at which it leaves them.
template <class V>
struct BeamNodes {
    using Float = typename V::Float;
    using Int = typename V::Int;
    Int first;
    typename V::Mask fits, fits_finer;
    Float leaves;

    TEDAVIS_LANES_INLINE BeamNodes under(const BeamAxis<V>& a, Int cell, Float fraction, Float t, Int level) {
        constexpr float kNever = 1e30f;
        const Int one(1);
        const Int low = V::floor_to_int(fraction + t * a.least) + cell, high = V::floor_to_int(fraction + t * a.most) + cell;
        BeamNodes n;
        n.first = V::select(a.is_back, (high >> level) - one, low >> level);
        n.fits = ((low >> level) >= n.first) & (n.first + one >= (high >> level));
        const Int finer = V::max(level - one, Int(0));
        n.fits_finer = (low >> finer) + one >= (high >> finer);
        const Int side = one << level;
        const Float up = (V::to_float((n.first + one + one) * side - cell) - fraction) * a.per_most;
        const Float down = (V::to_float(n.first * side - cell) - fraction) * a.per_least;
        n.leaves = V::min(V::select(a.goes_up, up, Float(kNever)), V::select(a.goes_down, down, Float(kNever)));
        return n;
    }
};

/// Returns the highest bound of the 2 x 2 nodes of a level from (column, row) on, relative to the height z.
template <class V, class Height>
TEDAVIS_LANES_INLINE typename V::Float highest_under(const TracedNodes<Height>& field, typename V::Int column,
                                                     typename V::Int row, typename V::Int level, typename V::Int z,
                                                     typename V::Mask m) {
    using Int = typename V::Int;
    const Int none(0), one(1);
    const Int across = V::look_up(field.layout->columns, level), down = V::look_up(field.layout->rows, level);
    const Int c = V::max(V::min(column, across - Int(2)), none);
    const Int first = V::look_up(field.layout->first, level) + c;
    const Int upper = V::max(V::min(row, down - one), none), lower = V::max(V::min(row + one, down - one), none);
    if constexpr (sizeof(Height) == 2) {
        Int p, q, r, s;
        V::gather_two(field.nodes, first + upper * across, m, p, q);
        V::gather_two(field.nodes, first + lower * across, m, r, s);
        return V::to_float(V::max(V::max(p, q), V::max(r, s)) - z);
    } else {
        typename V::Float p, q, r, s;
        V::gather_two(field.nodes, first + upper * across, m, p, q);
        V::gather_two(field.nodes, first + lower * across, m, r, s);
        return V::max(V::max(p, q), V::max(r, s)) - V::to_float(z);
    }
}

/// The start times of beams with one origin, and the mipmap level that they had reached.
template <class V>
struct BeamLanes {
    using Float = typename V::Float;
    using Int = typename V::Int;
    BeamAxis<V> x, y;
    Int column, row, z;
    Float column_fraction, row_fraction, z_fraction;
    Float least_climb;
    Float t, to;
    Int level;
};

/// Advances beams by at most `most` steps; `b.t` is then the time before which none of their rays has a hit.
template <class V, class Height>
TEDAVIS_LANES_INLINE void march_beams(const TracedNodes<Height>& field, BeamLanes<V>& b, int most) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Mask = typename V::Mask;
    constexpr float kLess = 1 - 1e-6f, kSlack = 1e-6f;
    const Int none(0), one(1), top(field.layout->top);
    const auto falls = b.least_climb < Float(0);
    Mask runs = b.t < b.to, went_on = V::mask(0);
    for (int n = 0; n < most && V::any(runs); ++n) {
        const auto x = BeamNodes<V>::under(b.x, b.column, b.column_fraction, b.t, b.level);
        const auto y = BeamNodes<V>::under(b.y, b.row, b.row_fraction, b.t, b.level);
        const Mask fits = x.fits & y.fits;
        const Float t_out = V::min(x.leaves, y.leaves) * Float(kLess);
        const Float way = V::select(falls, t_out, b.t) * b.least_climb;
        const Float size = V::max(way, Float(0) - way);
        const Float lowest = b.z_fraction + way - size * Float(kSlack) - Float(kSlack);
        const Float highest = highest_under<V, Height>(field, x.first, y.first, b.level, b.z, runs & fits);
        const Mask goes_on = runs & fits & (lowest > highest) & (t_out > b.t);
        b.t = V::select(goes_on, t_out, b.t);
        runs = runs & (b.t < b.to);
        const Mask finer = V::without(runs & fits, goes_on) & x.fits_finer & y.fits_finer & (b.level > none);
        const Mask coarser = ((goes_on & went_on) | V::without(runs, fits)) & (b.level < top);
        runs = runs & (goes_on | finer | coarser);
        went_on = goes_on;
        b.level = V::select(finer, b.level - one, V::select(coarser, b.level + one, b.level));
    }
}

}  // namespace tedavis::raytrace
