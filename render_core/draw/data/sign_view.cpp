#include "render_core/draw/data/sign_view.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

/// Depths of lines are interpolated in the picture; far outside of it floats do not hold their places.
constexpr float kFarthest_px = 32'000;

}  // namespace

SignSpot SignView::spot(const glm::dvec3& place) const {
    const glm::dvec3 from_eye = view.magnifiers.moved(place) - view.eye;
    SignSpot result;
    result.distance_m = glm::dot(from_eye, view.forward);
    if (!(result.distance_m > view.near_m)) return result;
    const double x = 0.5 * view.width + view.focal_px * glm::dot(from_eye, view.right) / result.distance_m;
    const double y = 0.5 * view.height + view.focal_px * glm::dot(from_eye, view.down) / result.distance_m;
    result.at = {static_cast<float>(x), static_cast<float>(y)};
    result.is_ahead = std::abs(result.at.x) < kFarthest_px && std::abs(result.at.y) < kFarthest_px;
    return result;
}

double SignView::seen_distance_m(double distance_m) const {
    constexpr double kUsual = 0.57735026918962576;  // of half of 60 degrees
    return distance_m * std::fmin(view.half_width_tangent() / kUsual, 1.0);
}

}  // namespace tedavis::draw
