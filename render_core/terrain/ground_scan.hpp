/// How many pixels a vertical error of the ground is, at most, by flat pieces of the ground in a view.
///
/// A point drawn at the tangents (x, y) by e above or below the true one, which is z deep, is e * focal * |u_xy - (x, y) u_z| / z
/// pixels off (projected_error.hpp). The true surface lies within `error_m` of what is included, straight above or below, and
/// the drawn one within `margin_m` of that. True points nearer than the near plane have no place in the picture. Pure arithmetic;
/// any thread.
#pragma once

#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Ranges of places along the view's right, down and ahead, relative to its eye, m. As made it holds nothing.
struct ViewBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool is_empty() const { return !(low.x <= high.x); }
    void include(const glm::dvec3& place);
};

class GroundScan {
public:
    /// `down`: the ellipsoid's vertical at the eye, ECEF. Margin and error not below 0, m.
    GroundScan(const View& view, const glm::dvec3& down, double margin_m, double error_m);

    /// Pixels a metre of what lies in a box; 0 where none of it can be drawn in the view.
    [[nodiscard]] double px_per_m(const ViewBox& box) const;
    /// The same, and closer, of a flat triangle, by its corners as seen(); infinite for one that is few margins deep.
    [[nodiscard]] double px_per_m(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

private:
    struct Side {
        double tangent, margin_m;
    };

    const double focal_px_, near_m_;
    const glm::dvec3 down_;  ///< right, down and ahead
    const double off_axis_, error_m_, aside_m_;
    const Side side_[2];
};

/// A direction or place relative to the eye along the view's right, down and ahead.
[[nodiscard]] glm::dvec3 seen(const View& view, const glm::dvec3& d);

}  // namespace tedavis::terrain
