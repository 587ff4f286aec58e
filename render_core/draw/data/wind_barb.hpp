/// The wind barb of weather charts (WMO-No. 485, station model): a staff from a ring to where the wind blows from, with half a
/// barb for 5 knots, a barb for 10 and a pennant for 50, rounded to 5, on the side of the low pressure: left of the wind in the
/// northern hemisphere, right in the southern. A bare staff means less than 3 knots, two rings mean calm. Two signs are this
/// project's own: a V in the ring for variable wind, an M for missing wind.
///
/// Thread  any. Memory  none. Failure  false when the batch has no room.
#pragma once

#include "render_core/draw/quad_batch.hpp"
#include "render_core/scene/wind.hpp"

namespace tedavis::draw {

/// What a staff carries.
struct BarbFlags {
    int pennants = 0, barbs = 0, halves = 0;
};
/// Returns the flags for a speed, with at most 5 pennants: 250 knots.
[[nodiscard]] BarbFlags barb_flags(double speed_mps) noexcept;

struct BarbStyle {
    float staff_px = 40;
    bool is_southern = false;
    design::Color color;
    design::Color text{255, 255, 255, 255};
};

/// Vertices of the largest sign, its rim included.
inline constexpr std::size_t kMaxBarbVertices = 4 * 2 * (2 * 10 + 2 + 5 * 4 + 5);

/// `from`: unit vector on the screen, to where steady wind blows from.
bool draw_wind_barb(QuadBatch& batch, Point ring, Point from, const scene::Wind& wind, const BarbStyle& style);

}  // namespace tedavis::draw
