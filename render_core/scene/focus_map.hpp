/// Degrees of many places by their angles: what focus_region.hpp says of places on the ellipsoid, without sines and roots.
///
/// Places are within 0.1 m of where in_focus_plane() has them. Those beyond the box round focus and context are context without a
/// closer look; of a region that reaches farther than kFocusMapReach_rad every place is looked at.
///
/// Pure; any thread. Radians, WGS84.
#pragma once

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
    [[nodiscard]] glm::dvec2 in_plane(const FocusRegion& region, double latitude_rad, double longitude_rad) const;
    /// ground_focus_degree() of it.
    [[nodiscard]] double degree(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
        if (beyond(latitude_rad, longitude_rad) != 0) return 0;
        return ground_focus_degree(region, in_plane(region, latitude_rad, longitude_rad));
    }

private:
    [[nodiscard]] double east_of(double longitude_rad) const {
        constexpr double kTurn = 6.283185307179586;
        const double east = longitude_rad - longitude_rad_;
        return east > 0.5 * kTurn ? east - kTurn : east < -0.5 * kTurn ? east + kTurn : east;
    }

    double latitude_rad_ = 0, longitude_rad_ = 0;
    double sine_ = 0, cosine_ = 1, radius_m_ = 0;
    bool is_wide_ = false;
    double south_ = 0, north_ = 0, west_ = 0, east_ = 0;  ///< of what may be near, from the anchor
};

}  // namespace tedavis::scene
