#include "render_core/draw/data/runway_surface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kFinestStep_m = 50, kCoarsestStep_m = 800, kStepOfDistance = 0.1;  // of the distance

}  // namespace

double seat_height_m(const ElementInput& input, const scene::ScenePoint& place) {
    const double drawn_m = input.ground.drawn_height_m(place.latitude_rad, place.longitude_rad);
    if (!std::isnan(drawn_m)) return drawn_m;
    const Placed stated = placed(input, place);
    return stated.is_known ? stated.height_m : std::nan("");
}

double RunwaySurface::bearing_rad() const { return std::atan2(way_.x, way_.y); }

/// In powers of two: it must not change with every frame.
double RunwaySurface::step_from(const ElementInput& input, const glm::dvec3& middle) const {
    const double nearest_m = std::max(glm::distance(input.eye, middle) - 0.5 * length_m_, 0.0);
    double step_m = kFinestStep_m;
    while (step_m < kCoarsestStep_m &&
           (2 * step_m < kStepOfDistance * nearest_m || length_m_ > 2 * kMaxRunway_m / kMaxRunwaySections * step_m))
        step_m *= 2;
    return length_m_ / std::ceil(length_m_ / step_m - 0.01);
}

bool RunwaySurface::build(const ElementInput& input, const scene::ScenePoint& first, const scene::ScenePoint& last,
                          double width_m) {
    const glm::dvec2 whole = flat_offset(first, last);
    length_m_ = glm::length(whole);
    half_m_ = 0.5 * width_m;
    if (!(length_m_ > kMinRunway_m) || length_m_ > kMaxRunway_m) return false;
    way_ = whole / length_m_;
    const scene::ScenePoint middle = between(first, last, 0.5);
    const LocalAxes axes = local_axes(middle.latitude_rad, middle.longitude_rad);
    const glm::dvec2 across = right_of(whole);
    right_ = axes.east * across.x + axes.north * across.y;
    up_ = axes.up;
    step_m_ = step_from(input, earth::to_ecef({middle.latitude_rad, middle.longitude_rad, {0}}));
    const auto steps = static_cast<std::size_t>(std::lround(length_m_ / step_m_));
    middles_.clear();
    for (std::size_t n = 0; n <= steps; ++n) {
        const scene::ScenePoint at = between(first, last, static_cast<double>(n) / static_cast<double>(steps));
        double highest_m = std::nan("");
        for (const double side : {-1.0, 0.0, 1.0})
            highest_m = std::fmax(highest_m, seat_height_m(input, moved(at, across * (half_m_ * side))));
        if (std::isnan(highest_m)) return false;
        const glm::dvec3 place = earth::to_ecef({at.latitude_rad, at.longitude_rad, {highest_m + kRunwayLift_m}});
        if (!middles_.try_push_back(place)) return false;
    }
    return true;
}

glm::dvec3 RunwaySurface::at(double along_m, double aside_m) const {
    const double place = along_m / step_m_, most = static_cast<double>(middles_.size() - 2);
    const double begins = std::clamp(std::floor(place), 0.0, most);
    const auto section = static_cast<std::size_t>(begins);
    const glm::dvec3 &from = middles_[section], &to = middles_[section + 1];
    return from + (place - begins) * (to - from) + aside_m * right_;
}

}  // namespace tedavis::draw
