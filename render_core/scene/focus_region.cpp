#include "render_core/scene/focus_region.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::scene {
namespace {

/// As std::fmin and std::fmax of numbers, without a call.
double smaller(double a, double b) { return a < b ? a : b; }
double larger(double a, double b) { return a > b ? a : b; }
double within_one(double part) { return smaller(larger(part, 0), 1); }

double largest(const glm::dvec2& way) { return larger(std::fabs(way.x), std::fabs(way.y)); }

/// Half the side of the square round `way` that touches a circle round the origin; within the way to the circle, negative.
double chebyshev_to_circle(const glm::dvec2& way, double radius_m) {
    const double x = largest(way), y = smaller(std::fabs(way.x), std::fabs(way.y));
    if (x * x + y * y <= radius_m * radius_m) return glm::length(way) - radius_m;
    if (x - radius_m >= y) return x - radius_m;                                   // by a side
    return (x + y - std::sqrt(2 * radius_m * radius_m - (x - y) * (x - y))) / 2;  // by a corner
}

double euclidean_to_square(const glm::dvec2& way, double half_m) {
    const double x = std::fabs(way.x) - half_m, y = std::fabs(way.y) - half_m;
    return x <= 0 || y <= 0 ? larger(x, y) : std::hypot(x, y);
}

double to_place(const FocusRegion& region, const glm::dvec2& way) {
    const bool is_chebyshev = region.context.distance == FocusDistance::chebyshev;
    if (region.is_square) return is_chebyshev ? largest(way) - region.radius_m : euclidean_to_square(way, region.radius_m);
    return is_chebyshev ? chebyshev_to_circle(way, region.radius_m) : glm::length(way) - region.radius_m;
}

double at_part(const glm::dvec2& way, const glm::dvec2& along, double part) { return largest(way - along * within_one(part)); }

/// The larger of two distances that are straight lines but for a kink each is least at its ends, at a kink or where they cross.
double chebyshev_to_leg(const glm::dvec2& way, const glm::dvec2& along) {
    double least = smaller(at_part(way, along, 0), at_part(way, along, 1));
    const double over[4] = {way.x, way.y, way.x - way.y, way.x + way.y};
    const double by[4] = {along.x, along.y, along.x - along.y, along.x + along.y};
    for (int n = 0; n < 4; ++n)
        if (std::fabs(by[n]) > 1e-9) least = smaller(least, at_part(way, along, over[n] / by[n]));
    return least;
}

double euclidean_to_leg(const glm::dvec2& way, const glm::dvec2& along) {
    const double square = glm::dot(along, along);
    const double part = square > 0 ? within_one(glm::dot(way, along) / square) : 0;
    return glm::length(way - along * part);
}

double to_leg(const FocusRegion& region, const glm::dvec2& way, const glm::dvec2& along) {
    return (region.context.distance == FocusDistance::chebyshev ? chebyshev_to_leg(way, along) : euclidean_to_leg(way, along)) -
           region.radius_m;
}

/// A path of one point is a place.
bool is_path(const FocusRegion& region) { return region.kind == FocusPoints::path && region.point_count > 1; }

bool is_beside(const FocusRegion& region, const glm::dvec3& place, double height_m) {
    if (!region.is_volume) return false;
    if (!region.is_ball) return height_m < region.lower_m || height_m > region.upper_m;
    const double up_m = height_m - (region.lower_m + region.upper_m) / 2;
    const glm::dvec2 ground = in_focus_plane(region, place) - region.points[0];
    return glm::dot(ground, ground) + up_m * up_m > region.radius_m * region.radius_m;
}

}  // namespace

FocusRegion focus_region_at(double latitude_rad, double longitude_rad) noexcept {
    FocusRegion region;
    const glm::dmat3 axes = earth::north_east_down(latitude_rad, longitude_rad);
    region.is_valid = true;
    region.anchor = earth::to_ecef({latitude_rad, longitude_rad, {0}});
    region.north = axes[0];
    region.east = axes[1];
    region.up = -axes[2];
    region.lower_m = -std::numeric_limits<double>::infinity();
    region.upper_m = std::numeric_limits<double>::infinity();
    return region;
}

glm::dvec2 in_focus_plane(const FocusRegion& region, const glm::dvec3& place) noexcept {
    const glm::dvec3 way = place - region.anchor;
    return {glm::dot(way, region.east), glm::dot(way, region.north)};
}

std::uint32_t focus_part_count(const FocusRegion& region) noexcept {
    return is_path(region) ? region.point_count - 1 : region.point_count;
}

double focus_part_distance_m(const FocusRegion& region, std::uint32_t part, const glm::dvec2& ground) noexcept {
    const glm::dvec2 way = ground - region.points[part];
    return is_path(region) ? to_leg(region, way, region.points[part + 1] - region.points[part]) : to_place(region, way);
}

double focus_distance_m(const FocusRegion& region, const glm::dvec2& ground) noexcept {
    double least = std::numeric_limits<double>::infinity();
    const std::uint32_t parts = focus_part_count(region);
    for (std::uint32_t n = 0; n < parts; ++n) least = smaller(least, focus_part_distance_m(region, n, ground));
    return larger(least, 0);
}

double degree_at_distance(const FocusContext& context, double distance_m) noexcept {
    if (!(distance_m < context.width_m)) return 0;
    const double part = distance_m / context.width_m;
    if (context.levels == 0) return 1 - part;
    return 1 - (std::floor(part * context.levels) + 1) / (context.levels + 1);
}

double degree_of_value(const FocusValueRange& range, double value) noexcept {
    if (!(range.low <= range.high) || std::isnan(value)) return 0;
    const double beyond = std::fmax(range.low - value, value - range.high);
    return beyond > 0 ? degree_at_distance({FocusDistance::euclidean, range.similar, range.levels}, beyond) : 1;
}

double height_m(const FocusRegion& region, const glm::dvec3& place) noexcept {
    const glm::dvec2 ground = in_focus_plane(region, place);
    return glm::dot(place - region.anchor, region.up) + glm::dot(ground, ground) / (2 * earth::kMeanRadius_m);
}

double ground_focus_degree(const FocusRegion& region, const glm::dvec2& ground) noexcept {
    if (!region.is_valid) return 0;
    const double distance_m = focus_distance_m(region, ground);
    return distance_m > 0 ? degree_at_distance(region.context, distance_m) : 1;
}

double focus_degree(const FocusRegion& region, const glm::dvec3& place, double height_m) noexcept {
    const double degree = ground_focus_degree(region, in_focus_plane(region, place));
    return degree > kMaxBesideVolume && is_beside(region, place, height_m) ? kMaxBesideVolume : degree;
}

double ground_focus_degree(const FocusRegions& regions, const glm::dvec3& place) noexcept {
    bool is_any = false;
    double degree = 0;
    for (const FocusRegion& region : regions) {
        is_any = is_any || region.is_valid;
        if (region.is_valid) degree = std::fmax(degree, ground_focus_degree(region, in_focus_plane(region, place)));
    }
    return is_any ? degree : 1;
}

double focus_degree(const FocusRegions& regions, const glm::dvec3& place, double height_m) noexcept {
    bool is_any = false;
    double degree = 0;
    for (const FocusRegion& region : regions) {
        is_any = is_any || region.is_valid;
        if (region.is_valid) degree = std::fmax(degree, focus_degree(region, place, height_m));
    }
    return is_any ? degree : 1;
}

}  // namespace tedavis::scene
