/// Columns of a picture that each lie in one vertical plane: a column is swept once, outwards and upwards.
///
/// Where all rays of a column run over the same line on the ground, they cross the lines of the grid at the same times and differ
/// in their climb alone. What a steep one passes, a less steep one passes higher up, roundings included: so each ray goes on from
/// the cell where the one below it ended, and meets what it would meet alone, with the same bits.
///
/// After Lee and Shin 1997, "Rapid generation of virtual terrain views through a raycasting of height fields along vertical
/// ray coherence"; here without their approximations.
#pragma once

#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/kernel/swept_rows.hpp"
#include "render_core/raytrace/kernel/view_slopes.hpp"

namespace tedavis::raytrace {

/// Where neighbouring columns are: the next ray of each, counted from the steepest.
template <class V>
struct ColumnSweep {
    typename V::Float x;
    typename V::Int lane, place;
    std::int32_t end, mirror, first_row;  ///< the row of place p: (p ^ mirror) + first_row

    TEDAVIS_LANES_INLINE typename V::Float climb(const ViewSlopes& slopes, const ColumnSweep& sweep) {
        using Int = typename V::Int;
        const Int row = (sweep.place ^ Int(sweep.mirror)) + Int(sweep.first_row);
        return DirectionSlope::at<V>(slopes.z, sweep.x, V::to_float(row) + typename V::Float(0.5f));
    }
};

/// Keeps what has been met, and lets the next rays of those columns go on from there.
template <class V, class Height>
TEDAVIS_LANES_INLINE void keep_and_go_on(const ViewSlopes& slopes, std::int32_t columns, SweptRows<V, Height>& rows,
                                         ColumnSweep<V>& sweep, RayLanes<V>& ray, March<V>& m) {
    using Int = typename V::Int;
    SweptRows<V, Height>::keep(rows, sweep.place, sweep.lane, ray, m, columns);
    sweep.place = V::select(m.is_met, sweep.place + Int(1), sweep.place);
    ray.climb = ColumnSweep<V>::climb(slopes, sweep);
    const auto ends = sweep.place == Int(sweep.end);
    m.asks = V::without(m.asks, ends);
    m.runs = V::without(m.runs, ends);
}

/// All rays of the columns that ask which meet the cells that they stand before.
template <class V, class Height, CellSurface surface>
TEDAVIS_LANES_INLINE void sweep_cells(const TracedNodes<Height>& nodes, const ViewSlopes& slopes, SweptRows<V, Height>& rows,
                                      ColumnSweep<V>& sweep, RayLanes<V>& ray, March<V>& m) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Axis = RayAxis<V>;
    const Int one(1), column = m.column ^ ray.x.sign, row = m.row ^ ray.y.sign;
    const auto posts = CellPosts<V, Height>::gather(nodes, ray, column, row, m.asks);
    const Float t_in = V::max(V::max(Axis::crossing(ray.x, m.column), Axis::crossing(ray.y, m.row)), ray.from);
    const Float t_out = V::min(V::min(Axis::crossing(ray.x, m.column + one), Axis::crossing(ray.y, m.row + one)), ray.to);
    const auto profile = profile_of<V, Height, surface>(ray, posts, t_in, t_out);
    m.met_column = column;
    m.met_row = row;
    auto asks = rows.with_room(m.asks, m.runs, sweep.place);
    while (V::any(asks)) {
        const CellMeeting<V> meeting = meet_surface<V, surface, HitSide::above>(ray, profile, asks);
        m.is_met = asks & meeting.is_met;
        m.is_beyond = m.is_met & meeting.is_beyond;
        m.met_t = meeting.t;
        const auto passes = V::without(asks, m.is_met);
        m.passes = m.passes | passes;
        m.asks = V::without(m.asks, passes);
        keep_and_go_on<V, Height>(slopes, nodes.columns, rows, sweep, ray, m);
        asks = rows.with_room(m.asks, m.runs, sweep.place);
    }
}

/// Columns [left, left + V::kCount) of the picture, as far as it has them.
template <class V, class Height, CellSurface surface>
void sweep_columns(const ViewJob<Height>& job, const TracedNodes<Height>& nodes, std::uint32_t left) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    const ViewOrigin origin = ViewOrigin::of(job.camera->origin);
    const ViewSlopes slopes(*job.camera);
    const std::uint32_t columns = left + V::kCount < job.width ? V::kCount : job.width - left;
    const bool is_upwards = job.camera->down.z < 0;
    SweptRows<V, Height> rows(job, left, columns, is_upwards);
    float middle[V::kCount];
    std::int32_t lane[V::kCount];
    for (std::int32_t n = 0; n < V::kCount; ++n) {
        middle[n] = static_cast<float>(left + static_cast<std::uint32_t>(n)) + 0.5f;
        lane[n] = n;
    }
    const auto height = static_cast<std::int32_t>(job.height);
    ColumnSweep<V> sweep{V::load(middle), V::load(lane), Int(0), height, is_upwards ? -1 : 0, is_upwards ? height : 0};
    RayLanes<V> ray = rays_from<V>(origin, RaySpan{});
    ray.x = RayAxis<V>::make(Int(origin.column), Float(origin.column_fraction),
                             DirectionSlope::at<V>(slopes.x, sweep.x, Float(0.5f)));
    ray.y = RayAxis<V>::make(Int(origin.row), Float(origin.row_fraction), DirectionSlope::at<V>(slopes.y, sweep.x, Float(0.5f)));
    ray.climb = ColumnSweep<V>::climb(slopes, sweep);
    const std::uint32_t all = columns == 32 ? ~0u : (1u << columns) - 1;
    March<V> m = enter<V, Height>(nodes, ray, ray.from, V::mask(all), Int(nodes.layout->top));
    while (V::any(m.runs)) {
        const auto asks = rows.with_room(m.asks, m.runs, sweep.place), steps = V::without(m.runs, m.asks);
        if (V::any(steps) && 4 * __builtin_popcount(V::bits(asks)) < 3 * __builtin_popcount(V::bits(asks | steps))) {
            step_node<V, Height, HitSide::above>(nodes, ray, m, steps);
            continue;
        }
        sweep_cells<V, Height, surface>(nodes, slopes, rows, sweep, ray, m);
    }
    rows.finish(sweep.place);
}

}  // namespace tedavis::raytrace
