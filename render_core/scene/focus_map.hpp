/// Computes focus degrees of many points from their latitudes and longitudes, without sines and roots; the same as
/// focus_region.hpp for points on the ellipsoid.
///
/// Positions differ from in_focus_plane() by less than 0.01 m. Points outside a box round focus and intermediate context are
/// classified as context at once; for a region that reaches farther than kFocusMapReach_rad every point is computed.
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
    /// `region` must be valid.
    explicit FocusMap(const FocusRegion& region);

    /// Returns one bit for each side of the box that the point lies beyond; 0 for a region that is too wide for a box.
    [[nodiscard]] unsigned beyond(double latitude_rad, double longitude_rad) const {
        if (is_wide_) return 0;
        const double north = latitude_rad - latitude_rad_, east = east_of(longitude_rad);
        return (north < south_ ? 1u : 0u) | (north > north_ ? 2u : 0u) | (east < west_ ? 4u : 0u) | (east > east_ ? 8u : 0u);
    }
    /// Returns the plane coordinates of a point on the ellipsoid. `region` is the one that the map was made from.
    [[nodiscard]] glm::dvec2 in_plane(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
        if (is_wide_) return in_plane_of(region, latitude_rad, longitude_rad);
        const double north = latitude_rad - latitude_rad_, east = east_of(longitude_rad), square = east * east;
        const double out_m = at(out_m_, north);
        const double sine = east * (1 - square * (1.0 / 6) * (1 - square * (1.0 / 20)));
        const double less = 0.5 * square * (1 - square * (1.0 / 12) * (1 - square * (1.0 / 30)));  // 1 - cosine
        return {out_m * sine, at(along_m_, north) + out_m * less * sine_};
    }
    /// Returns ground_focus_degree() of the point.
    [[nodiscard]] double degree(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
        if (beyond(latitude_rad, longitude_rad) != 0) return 0;
        return ground_focus_degree(region, in_plane(region, latitude_rad, longitude_rad));
    }

    /// Classifies a point: 2 in the focus, 1 in the intermediate context, 0 in the context.
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
    double sine_ = 0;  ///< sine of the anchor's latitude
    /// By the angle north of the anchor: distance from the Earth's axis, and distance north in the plane on the anchor's
    /// meridian.
    Series out_m_{}, along_m_{};
    bool is_wide_ = false, is_round_ = false;
    double focus_m2_ = 0, context_m2_ = 0;                ///< squares of their reach round a point
    double south_ = 0, north_ = 0, west_ = 0, east_ = 0;  ///< the box, relative to the anchor
};

}  // namespace tedavis::scene
