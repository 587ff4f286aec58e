#include "render_core/terrain/ground_scan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::terrain {
namespace {

constexpr double kRounding_m = 1e-6;  // of places in space, computed in doubles
constexpr double kMinDepth = 1.25;    // of places on triangles, in margins

struct Polygon {
    static constexpr int kMaxCorners = 3 + 5;  // each plane adds one, but for slivers that rounding bends
    glm::dvec3 corner[kMaxCorners];
    int count;
    bool overflown = false;

    void add(const glm::dvec3& p) {
        if (count < kMaxCorners)
            corner[count++] = p;
        else
            overflown = true;
    }
};

/// Leaves what lies where `inside` is not below zero: Sutherland and Hodgman, Reentrant polygon clipping (CACM 17, 1974).
template <class Inside>
void clip(Polygon& polygon, const Inside& inside) {
    bool is_cut = false;
    for (int n = 0; n < polygon.count; ++n) is_cut = is_cut || !(inside(polygon.corner[n]) >= 0);
    if (!is_cut) return;
    Polygon part{{}, 0, polygon.overflown};
    for (int n = 0; n < polygon.count; ++n) {
        const glm::dvec3 &a = polygon.corner[n], &b = polygon.corner[n + 1 < polygon.count ? n + 1 : 0];
        const double of_a = inside(a), of_b = inside(b);
        if (of_a >= 0) part.add(a);
        if ((of_a >= 0) != (of_b >= 0)) part.add(a + (b - a) * (of_a / (of_a - of_b)));
    }
    polygon = part;
}

double from_axis(double tangent) { return std::sqrt(1 + tangent * tangent); }

}  // namespace

void ViewBox::include(const glm::dvec3& place) {
    low = glm::min(low, place);
    high = glm::max(high, place);
}

glm::dvec3 seen(const View& view, const glm::dvec3& d) {
    return {glm::dot(d, view.right), glm::dot(d, view.down), glm::dot(d, view.forward)};
}

GroundScan::GroundScan(const View& view, const glm::dvec3& down, double margin_m, double error_m)
    : focal_px_(view.focal_px),
      near_m_(view.near_m),
      down_(seen(view, down)),
      across_(std::hypot(down_.x, down_.y)),
      off_axis_(std::hypot(view.half_width_tangent(), view.half_height_tangent())),
      corner_ray_(from_axis(off_axis_)),
      error_m_(error_m + kRounding_m),
      aside_m_(margin_m + error_m_),
      side_{{view.half_width_tangent(), aside_m_ * from_axis(view.half_width_tangent())},
            {view.half_height_tangent(), aside_m_ * from_axis(view.half_height_tangent())}} {}

double GroundScan::px_per_m(const ViewBox& box) const {
    const double farthest_m = box.high.z + aside_m_;
    if (box.is_empty() || farthest_m < near_m_) return 0;
    for (int axis = 0; axis < 2; ++axis) {
        const double reach_m = side_[axis].tangent * farthest_m + aside_m_;
        if (box.low[axis] > reach_m || -box.high[axis] > reach_m) return 0;
    }
    const glm::dvec3 nearest = glm::max(glm::max(box.low, -box.high), glm::dvec3(0)), corner = glm::max(-box.low, box.high);
    const double turned = glm::length(corner) / earth::kMinCurvatureRadius_m;
    const double across = across_ + turned, along = std::abs(down_.z) + turned;
    // Drawn points lie in the picture, which is as wide as it is deep, and true ones straight above or below them.
    double drawn_m = (glm::length(nearest) - aside_m_) / corner_ray_;
    for (int axis = 0; axis < 2; ++axis) drawn_m = std::max(drawn_m, (nearest[axis] - aside_m_) / side_[axis].tangent);
    const double depth_m = std::max({box.low.z - error_m_, drawn_m - aside_m_ * std::min(along, 1.0), near_m_});
    return focal_px_ * (across + off_axis_ * along) / depth_m;
}

/// On a flat triangle 1/z is linear in x and y, and the length convex: over a polygon with corners i their product stays below
/// the largest (length_i / z_j + length_j / z_i) / 2, its Bernstein coefficients.
double GroundScan::px_per_m(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    Polygon part{{a, b, c}, 3};
    for (int axis = 0; axis < 2; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const Side& side = side_[axis];
            clip(part, [&](const glm::dvec3& p) { return side.tangent * p.z + side.margin_m - sign * p[axis]; });
        }
    clip(part, [this](const glm::dvec3& p) { return p.z - (near_m_ - aside_m_); });
    if (part.overflown) return std::numeric_limits<double>::infinity();
    double farthest_m = 0, length[Polygon::kMaxCorners], nearness[Polygon::kMaxCorners];
    for (int n = 0; n < part.count; ++n) farthest_m = std::max(farthest_m, glm::length(part.corner[n]));
    for (int n = 0; n < part.count; ++n) {
        const glm::dvec3& p = part.corner[n];
        if (!(p.z > kMinDepth * aside_m_)) return std::numeric_limits<double>::infinity();
        // The vertical there is another one, and the drawn point stands elsewhere in the picture.
        const double turned = farthest_m / earth::kMinCurvatureRadius_m + aside_m_ / (p.z - aside_m_);
        length[n] = std::hypot(down_.x - p.x / p.z * down_.z, down_.y - p.y / p.z * down_.z) + turned * (1 + off_axis_);
        nearness[n] = 1 / (p.z - error_m_);
    }
    double largest = 0;
    for (int n = 0; n < part.count; ++n)
        for (int m = 0; m <= n; ++m) largest = std::max(largest, 0.5 * (length[n] * nearness[m] + length[m] * nearness[n]));
    return focal_px_ * largest;
}

/// What is left of a triangle in the view is no nearer than its nearest corner, and as deep as the view must be to contain it. So
/// its tangents are those of the view at this depth at most, and every product below is at most that of the greatest length and
/// the greatest nearness.
bool GroundScan::is_at_most(double px_per_m, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    constexpr double kRounding = 1e-9;
    const glm::dvec3 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
    double depth_m = low.z, farthest_m2 = 0;
    for (int axis = 0; axis < 2; ++axis)
        depth_m = std::max(depth_m, (std::max(low[axis], -high[axis]) - side_[axis].margin_m) / side_[axis].tangent);
    depth_m *= 1 - kRounding;
    if (!(depth_m > kMinDepth * aside_m_)) return false;
    for (const glm::dvec3* corner : {&a, &b, &c}) farthest_m2 = std::max(farthest_m2, glm::dot(*corner, *corner));
    const double turned = std::sqrt(farthest_m2) / earth::kMinCurvatureRadius_m + aside_m_ / (depth_m - aside_m_);
    const double x = side_[0].tangent + side_[0].margin_m / depth_m, y = side_[1].tangent + side_[1].margin_m / depth_m;
    const double length = across_ + std::sqrt(x * x + y * y) * std::abs(down_.z) + turned * (1 + off_axis_);
    return focal_px_ * length * (1 + kRounding) <= px_per_m * (depth_m - error_m_);
}

}  // namespace tedavis::terrain
