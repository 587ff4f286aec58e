/// Upper bound, in pixels, of a vertical error of the ground in a view, from flat pieces of the ground.
///
/// A point drawn at the tangents (x, y) by e above or below the true one, which is z deep, is displaced by e * focal * |u_xy -
/// (x, y) u_z| / z pixels (projected_error.hpp). The true surface lies vertically within `error_m` of the pieces, and the drawn
/// one within `margin_m` of that. True points nearer than the near plane do not count. Pure arithmetic; any thread.
#pragma once

#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Ranges along the view's right, down and forward axes, relative to its eye point, m. Empty by default.
struct ViewBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
    void include(const glm::dvec3& place);
};

class GroundScan {
public:
    /// `down` is the ellipsoid's vertical at the eye point, ECEF. Margin and error are in metres and not negative.
    GroundScan(const View& view, const glm::dvec3& down, double margin_m, double error_m);

    /// Returns the pixels per metre of error for ground in a box; 0 where none of it can be in the view.
    [[nodiscard]] double px_per_m(const ViewBox& box) const;
    /// Returns a tighter bound for a flat triangle, whose corners are as seen() returns them; infinite for one whose depth is
    /// only a few margins.
    [[nodiscard]] double px_per_m(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;
    /// Whether the bound for such a triangle is certainly no more than `px_per_m`; much cheaper than the bound itself.
    [[nodiscard]] bool is_at_most(double px_per_m, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

private:
    struct Side {
        double tangent, margin_m;
    };

    const double focal_px_, near_m_;
    const glm::dvec3 down_;    ///< right, down and ahead
    const double across_;      ///< length of `down_` across the view's axis
    const double off_axis_;    ///< tangent of the picture's corners
    const double corner_ray_;  ///< length of a ray to a corner, for one that is 1 deep
    const double error_m_, aside_m_;
    const Side side_[2];
};

/// Expresses a direction, or a position relative to the eye point, in the view's axes: right, down, forward.
[[nodiscard]] glm::dvec3 seen(const View& view, const glm::dvec3& d);

}  // namespace tedavis::terrain
