/// A band of a picture in lanes: its beams, from large to small, and then its rays.
#pragma once

#include "render_core/raytrace/kernel/beam_march.hpp"
#include "render_core/raytrace/kernel/march.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

/// Steps after which beams of each size are left where they are: those of their rays that get on do so alone.
inline constexpr int kMostBeamSteps[kBeamSizes] = {100, 100, 20, 12};
inline constexpr int kMostCells = 16;   ///< that rays pass one by one before they look at larger nodes
inline constexpr int kFinerLevels = 2;  ///< at which rays begin, than where their beam ended

/// The origin of all rays of a picture, in whole cells and steps and what is left.
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

/// A component of directions, over the picture.
struct DirectionSlope {
    float corner, right, down;

    template <class V>
    TEDAVIS_LANES_INLINE typename V::Float at(const DirectionSlope& d, typename V::Float x, typename V::Float y) {
        using Float = typename V::Float;
        return Float(d.corner) + x * Float(d.right) + y * Float(d.down);
    }
    /// By how much it differs from the middle of a square.
    TEDAVIS_LANES_INLINE float reach(const DirectionSlope& d, float half_side) {
        return (__builtin_fabsf(d.right) + __builtin_fabsf(d.down)) * half_side;
    }
};

struct ViewSlopes {
    DirectionSlope x, y, z;
    explicit ViewSlopes(const GridCamera& c)
        : x{c.corner.x, c.right.x, c.down.x}, y{c.corner.y, c.right.y, c.down.y}, z{c.corner.z, c.right.z, c.down.z} {}
};

/// A row of beams of one size; `around` are those of the size before, null for the first.
template <class V, class Height>
void start_beams(const TracedNodes<Height>& nodes, const ViewOrigin& origin, const ViewSlopes& slopes, int size,
                 std::uint32_t row, const BeamStarts& beams, const BeamStarts* around) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    const auto side = static_cast<float>(kBeamSide[size]), half = 0.5f * side;
    const Float y(static_cast<float>(row) * side + half);
    for (std::uint32_t first = 0; first < beams.across; first += V::kCount) {
        float middle[V::kCount], t[V::kCount];
        std::int32_t level[V::kCount];
        for (std::uint32_t n = 0; n < V::kCount; ++n) {
            const std::uint32_t at = first + n < beams.across ? first + n : beams.across - 1;
            middle[n] = static_cast<float>(at) * side + half;
            const std::size_t parent = around == nullptr ? 0 : std::size_t{row / 2} * around->across + at / 2;
            t[n] = around == nullptr ? 0 : around->t.data()[parent];
            level[n] = around == nullptr ? nodes.layout->top : around->level.data()[parent];
        }
        const Float x = V::load(middle);
        BeamLanes<V> b;
        b.x = BeamAxis<V>::make(DirectionSlope::at<V>(slopes.x, x, y), Float(DirectionSlope::reach(slopes.x, half)));
        b.y = BeamAxis<V>::make(DirectionSlope::at<V>(slopes.y, x, y), Float(DirectionSlope::reach(slopes.y, half)));
        b.least_climb =
            BeamAxis<V>::make(DirectionSlope::at<V>(slopes.z, x, y), Float(DirectionSlope::reach(slopes.z, half))).least;
        b.column = Int(origin.column);
        b.row = Int(origin.row);
        b.z = Int(origin.z);
        b.column_fraction = Float(origin.column_fraction);
        b.row_fraction = Float(origin.row_fraction);
        b.z_fraction = Float(origin.z_fraction);
        b.t = V::load(t);
        b.level = V::load(level);
        march_beams<V, Height>(nodes, b, kMostBeamSteps[size]);
        V::store(t, b.t);
        V::store(level, b.level);
        const std::size_t to = std::size_t{row} * beams.across + first;
        for (std::uint32_t n = 0; n < V::kCount && first + n < beams.across; ++n) {
            beams.t.data()[to + n] = t[n];
            beams.level.data()[to + n] = level[n];
        }
    }
}

/// Lanes that are traced together: 4 x 4 pixels of a beam, or a part of those, or those of neighbouring beams.
template <class V>
struct PacketShape {
    static constexpr std::uint32_t kWidth = V::kCount > 16 ? V::kCount / 4 : V::kCount < 4 ? V::kCount : 4;
    static constexpr std::uint32_t kHeight = V::kCount / kWidth;
    static constexpr std::uint32_t column(std::uint32_t lane) { return lane % 4 + lane / 16 * 4; }
    static constexpr std::uint32_t row(std::uint32_t lane) { return lane % 16 / 4; }
};

template <class V, class Height, CellSurface surface>
void trace_packet(const ViewJob<Height>& job, const TracedNodes<Height>& nodes, const ViewOrigin& origin,
                  const ViewSlopes& slopes, std::uint32_t left, std::uint32_t top) {
    using Float = typename V::Float;
    using Int = typename V::Int;
    using Shape = PacketShape<V>;
    const BeamStarts& beams = job.beams[kBeamSizes - 1];
    float x[V::kCount], y[V::kCount], start[V::kCount];
    std::int32_t level[V::kCount];
    std::uint32_t inside = 0;
    for (std::uint32_t n = 0; n < V::kCount; ++n) {
        const std::uint32_t column = left + Shape::column(n), row = top + Shape::row(n);
        const bool is_inside = column < job.width && row < job.height;
        inside |= (is_inside ? 1u : 0u) << n;
        x[n] = static_cast<float>(column) + 0.5f;
        y[n] = static_cast<float>(row) + 0.5f;
        const std::size_t beam = is_inside ? std::size_t{row / 4} * beams.across + column / 4 : 0;
        start[n] = beams.t.data()[beam];
        level[n] = beams.level.data()[beam];
    }
    const Float at_x = V::load(x), at_y = V::load(y);
    RayLanes<V> ray;
    ray.x = RayAxis<V>::make(Int(origin.column), Float(origin.column_fraction), DirectionSlope::at<V>(slopes.x, at_x, at_y));
    ray.y = RayAxis<V>::make(Int(origin.row), Float(origin.row_fraction), DirectionSlope::at<V>(slopes.y, at_x, at_y));
    ray.z = Int(origin.z);
    ray.z_fraction = Float(origin.z_fraction);
    ray.climb = DirectionSlope::at<V>(slopes.z, at_x, at_y);
    ray.from = Float(0.0f);
    ray.to = Float(__builtin_inff());
    March<V> m = enter<V, Height>(nodes, ray, V::load(start), V::mask(inside), V::load(level));
    march_cells<V, Height, surface, HitSide::above>(nodes, ray, m, kMostCells);
    if (V::any(m.runs)) march_nodes<V, Height, surface, HitSide::above>(nodes, ray, m);

    float t[V::kCount];
    std::int32_t cell[V::kCount];
    V::store(t, V::select(m.is_met, m.met_t, Float(__builtin_inff())));
    V::store(cell, V::select(m.is_met, m.met_row * Int(nodes.columns) + m.met_column, Int(-1)));
    const std::uint32_t beyond = V::bits(m.is_beyond);
    for (std::uint32_t n = 0; n < V::kCount; ++n) {
        if ((inside >> n & 1) == 0) continue;
        const std::size_t to = std::size_t{top + Shape::row(n)} * job.width + left + Shape::column(n);
        job.t[to] = t[n];
        job.cell[to] = cell[n];
        job.side[to] = cell[n] < 0 ? HitSide::none : HitSide::above;
        if ((beyond >> n & 1) != 0) trace_pixel(job, left + Shape::column(n), top + Shape::row(n));
    }
}

template <class V, class Height>
void trace_band(const ViewJob<Height>& job, std::uint32_t band) {
    using Shape = PacketShape<V>;
    const TracedNodes<Height> nodes(*job.field->maxima);
    const ViewOrigin origin = ViewOrigin::of(job.camera->origin);
    const ViewSlopes slopes(*job.camera);
    for (int size = 0; size < kBeamSizes; ++size) {
        const std::uint32_t rows = kBandRows / kBeamSide[size];
        for (std::uint32_t row = band * rows; row < (band + 1) * rows && row < job.beams[size].down; ++row)
            start_beams<V, Height>(nodes, origin, slopes, size, row, job.beams[size], size == 0 ? nullptr : &job.beams[size - 1]);
    }
    const std::uint32_t end = (band + 1) * kBandRows < job.height ? (band + 1) * kBandRows : job.height;
    const bool is_patch = job.field->surface == CellSurface::bilinear;
    for (std::uint32_t top = band * kBandRows; top < end; top += Shape::kHeight)
        for (std::uint32_t left = 0; left < job.width; left += Shape::kWidth)
            if (is_patch)
                trace_packet<V, Height, CellSurface::bilinear>(job, nodes, origin, slopes, left, top);
            else
                trace_packet<V, Height, CellSurface::two_triangles>(job, nodes, origin, slopes, left, top);
}

}  // namespace tedavis::raytrace
