#include "render_core/scene/focus_map.hpp"

#include <cmath>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::scene {
namespace {

/// Sine and cosine of small angles: below 1e-13 off within kFocusMapReach_rad.
struct Small {
    double sine, less;  ///< 1 - cosine
};
Small small(double angle) {
    const double square = angle * angle;
    return {angle * (1 - square / 6 * (1 - square / 20 * (1 - square / 42))),
            0.5 * square * (1 - square / 12 * (1 - square / 30))};
}

}  // namespace

FocusMap::FocusMap(const FocusRegion& region) {
    const earth::Geodetic anchor = earth::from_ecef(region.anchor);
    latitude_rad_ = anchor.latitude_rad;
    longitude_rad_ = anchor.longitude_rad;
    sine_ = std::sin(latitude_rad_);
    cosine_ = std::cos(latitude_rad_);
    radius_m_ = earth::prime_vertical_radius_m(latitude_rad_);
    glm::dvec2 low(1e12), high(-1e12);
    for (std::uint32_t n = 0; n < region.point_count; ++n) {
        low = glm::min(low, region.points[n]);
        high = glm::max(high, region.points[n]);
    }
    // Lengths in the plane are short by less than a hundredth, and degrees of longitude by less than twice their width's change.
    constexpr double kSafe = 1.02, kLeastCosine = 0.05;
    const double reach_m = region.radius_m + region.context.width_m;
    const double per_m = kSafe / earth::kLeastCurvatureRadius_m;
    const auto from = [&](double edge_m, double per) { return std::fmin((edge_m - reach_m) * per, 0.0) - 1e-4; };
    const auto to = [&](double edge_m, double per) { return std::fmax((edge_m + reach_m) * per, 0.0) + 1e-4; };
    south_ = from(low.y, per_m);
    north_ = to(high.y, per_m);
    const double least_cosine = std::fmin(std::cos(latitude_rad_ + north_), std::cos(latitude_rad_ + south_));
    const double across = least_cosine > kLeastCosine ? per_m / least_cosine : 1e9;
    west_ = from(low.x, across);
    east_ = to(high.x, across);
    is_wide_ = std::fmax(std::fmax(north_, east_), -std::fmin(south_, west_)) > kFocusMapReach_rad;
}

/// The difference of two places in ECEF along the anchor's axes; by angles from it, so that nothing is lost in large numbers.
glm::dvec2 FocusMap::in_plane(const FocusRegion& region, double latitude_rad, double longitude_rad) const {
    if (is_wide_) return in_focus_plane(region, earth::to_ecef({latitude_rad, longitude_rad, {0}}));
    const Small up = small(latitude_rad - latitude_rad_), round = small(east_of(longitude_rad));
    const double sine = sine_ * (1 - up.less) + cosine_ * up.sine, cosine = cosine_ * (1 - up.less) - sine_ * up.sine;
    const double radius_m = earth::kSemiMajorAxis_m / std::sqrt(1 - earth::kEccentricitySquared * sine * sine);
    const double out_m = radius_m * cosine;  // of the axis
    const double along_axis_m = (1 - earth::kEccentricitySquared) * (radius_m * sine - radius_m_ * sine_);
    const double outwards_m = out_m * (1 - round.less) - radius_m_ * cosine_;
    return {out_m * round.sine, along_axis_m * cosine_ - outwards_m * sine_};
}

}  // namespace tedavis::scene
