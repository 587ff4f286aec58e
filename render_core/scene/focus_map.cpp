#include "render_core/scene/focus_map.hpp"

#include <cmath>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::scene {
namespace {

/// Through as many places as it has terms, evenly over kFocusMapReach_rad to either side (Newton's divided differences).
template <std::size_t N, class Function>
std::array<double, N> series_of(const Function& function) {
    std::array<double, N> places{}, differences{}, series{};
    for (std::size_t n = 0; n < N; ++n) {
        places[n] = kFocusMapReach_rad * (2 * static_cast<double>(n) / (N - 1) - 1);
        differences[n] = function(places[n]);
    }
    for (std::size_t k = 1; k < N; ++k)
        for (std::size_t n = N - 1; n >= k; --n)
            differences[n] = (differences[n] - differences[n - 1]) / (places[n] - places[n - k]);
    for (std::size_t n = N; n-- > 0;) {
        for (std::size_t k = N - 1; k > 0; --k) series[k] = series[k - 1] - places[n] * series[k];
        series[0] = differences[n] - places[n] * series[0];
    }
    return series;
}

}  // namespace

FocusMap::FocusMap(const FocusRegion& region) {
    const earth::Geodetic anchor = earth::from_ecef(region.anchor);
    latitude_rad_ = anchor.latitude_rad;
    longitude_rad_ = anchor.longitude_rad;
    sine_ = std::sin(latitude_rad_);
    const double cosine = std::cos(latitude_rad_);
    const auto out_m = [&](double north) {
        return earth::prime_vertical_radius_m(latitude_rad_ + north) * std::cos(latitude_rad_ + north);
    };
    const auto up_axis_m = [&](double north) {
        return (1 - earth::kEccentricitySquared) * earth::prime_vertical_radius_m(latitude_rad_ + north) *
               std::sin(latitude_rad_ + north);
    };
    out_m_ = series_of<kTerms>(out_m);
    along_m_ = series_of<kTerms>(
        [&](double north) { return (up_axis_m(north) - up_axis_m(0)) * cosine - (out_m(north) - out_m(0)) * sine_; });
    is_round_ = region.kind == FocusPoints::places && !region.is_square && region.context.distance == FocusDistance::euclidean;
    focus_m2_ = region.radius_m * region.radius_m;
    context_m2_ = (region.radius_m + region.context.width_m) * (region.radius_m + region.context.width_m);
    glm::dvec2 low(1e12), high(-1e12);
    for (std::uint32_t n = 0; n < region.point_count; ++n) {
        low = glm::min(low, region.points[n]);
        high = glm::max(high, region.points[n]);
    }
    // Lengths in the plane are short by less than a hundredth, and degrees of longitude by less than twice their width's change.
    constexpr double kSafe = 1.02, kMinCosine = 0.05;
    const double reach_m = region.radius_m + region.context.width_m;
    const double per_m = kSafe / earth::kMinCurvatureRadius_m;
    const auto from = [&](double edge_m, double per) { return std::fmin((edge_m - reach_m) * per, 0.0) - 1e-4; };
    const auto to = [&](double edge_m, double per) { return std::fmax((edge_m + reach_m) * per, 0.0) + 1e-4; };
    south_ = from(low.y, per_m);
    north_ = to(high.y, per_m);
    const double least_cosine = std::fmin(std::cos(latitude_rad_ + north_), std::cos(latitude_rad_ + south_));
    const double across = least_cosine > kMinCosine ? per_m / least_cosine : 1e9;
    west_ = from(low.x, across);
    east_ = to(high.x, across);
    is_wide_ = std::fmax(std::fmax(north_, east_), -std::fmin(south_, west_)) > kFocusMapReach_rad;
}

glm::dvec2 FocusMap::in_plane_of(const FocusRegion& region, double latitude_rad, double longitude_rad) {
    return in_focus_plane(region, earth::to_ecef({latitude_rad, longitude_rad, {0}}));
}

int FocusMap::part_of(const FocusRegion& region, const glm::dvec2& ground) {
    const double distance_m = focus_distance_m(region, ground);
    return distance_m <= 0 ? 2 : distance_m < region.context.width_m ? 1 : 0;
}

}  // namespace tedavis::scene
