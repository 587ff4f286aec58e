/// Degrees of many places by their angles: what focus_region.hpp says of places on the ellipsoid, without sines and roots.
///
/// Places are within 0.01 m of where in_focus_plane() has them. Those beyond the box round focus and context are context without
/// a closer look; of a region that reaches farther than kFocusMapReach_rad every place is looked at.
///
/// Pure; any thread. Radians, WGS84.
#pragma once

#include <array>

#include "render_core/scene/focus_region.hpp"

namespace tedavis::scene {

inline constexpr double kFocusMapReach_rad = 0.05;

class FocusMap {
public:
    FocusMap() = default;
    /// Of a valid region.
    explicit FocusMap(const FocusRegion& region);

    /// A bit a side of the box round focus and context that the place lies beyond; of a region that is too wide for that none.
    [[nodiscard]] unsigned beyond(double latitude_rad, double longitude_rad) const {
        if (is_wide_) return 0;
        const double north = latitude_rad - latitude_rad_, east = east_of(longitude_rad);
        return (north < south_ ? 1u : 0u) | (north > north_ ? 2u : 0u) | (east < west_ ? 4u : 0u) | (east > east_ ? 8u : 0u);
    }
    /// Of a place on the ellipsoid. `region`: the one that the map was made of.
    [[nodiscard]] glm::dvec2 in_plane(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
        if (is_wide_) return in_plane_of(region, latitude_rad, longitude_rad);
        const double north = latitude_rad - latitude_rad_, east = east_of(longitude_rad), square = east * east;
        const double out_m = at(out_m_, north);
        const double sine = east * (1 - square * (1.0 / 6) * (1 - square * (1.0 / 20)));
        const double less = 0.5 * square * (1 - square * (1.0 / 12) * (1 - square * (1.0 / 30)));  // 1 - cosine
        return {out_m * sine, at(along_m_, north) + out_m * less * sine_};
    }
    /// ground_focus_degree() of it.
    [[nodiscard]] double degree(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
        if (beyond(latitude_rad, longitude_rad) != 0) return 0;
        return ground_focus_degree(region, in_plane(region, latitude_rad, longitude_rad));
    }

    /// The place as parts of the focus: 2 in it, 1 in the intermediate context, 0 in the context.
    [[nodiscard]] int part(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
        if (beyond(latitude_rad, longitude_rad) != 0) return 0;
        const glm::dvec2 ground = in_plane(region, latitude_rad, longitude_rad);
        if (!is_round_) return part_of(region, ground);
        double least = 1e300;
        for (std::uint32_t n = 0; n < region.point_count; ++n) {
            const double x = ground.x - region.points[n].x, y = ground.y - region.points[n].y, square = x * x + y * y;
            least = square < least ? square : least;
        }
        const bool is_in = least <= focus_m2_, is_near = least < context_m2_;
        return int{is_in} + int{is_in || is_near};
    }

private:
    static constexpr std::size_t kTerms = 5;
    using Series = std::array<double, kTerms>;
    [[nodiscard]] static double at(const Series& series, double angle) {
        return (((series[4] * angle + series[3]) * angle + series[2]) * angle + series[1]) * angle + series[0];
    }
    [[nodiscard]] static glm::dvec2 in_plane_of(const FocusRegion& region, double latitude_rad, double longitude_rad);
    [[nodiscard]] static int part_of(const FocusRegion& region, const glm::dvec2& ground);
    [[nodiscard]] double east_of(double longitude_rad) const {
        constexpr double kTurn = 6.283185307179586;
        const double east = longitude_rad - longitude_rad_;
        return east > 0.5 * kTurn ? east - kTurn : east < -0.5 * kTurn ? east + kTurn : east;
    }

    double latitude_rad_ = 0, longitude_rad_ = 0;
    double sine_ = 0;  ///< of the latitude
    /// By the angle north of the anchor: how far from the axis, and on the anchor's meridian how far north in the plane.
    Series out_m_{}, along_m_{};
    bool is_wide_ = false, is_round_ = false;
    double focus_m2_ = 0, context_m2_ = 0;                ///< squares of how far they reach round a place
    double south_ = 0, north_ = 0, west_ = 0, east_ = 0;  ///< of what may be near, from the anchor
};

}  // namespace tedavis::scene
