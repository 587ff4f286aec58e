/// Places of the pitch ladder on the screen: conformal, by elevation and by an offset to the side of the aircraft's heading.
#pragma once

#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

class LadderFrame {
public:
    explicit LadderFrame(const SymbologyInput& input) : view_(input.view), heading_rad_(input.view_heading_rad) {}

    /// `aside`: tangent of the angle to the right of the heading's vertical plane.
    [[nodiscard]] ProjectedPoint at(double elevation_rad, double aside) const {
        const glm::dvec3 right{-std::sin(heading_rad_), std::cos(heading_rad_), 0};
        return project(view_, direction_of(heading_rad_, elevation_rad) + right * aside);
    }
    /// Projects the point of the horizon in a true direction.
    [[nodiscard]] ProjectedPoint on_horizon(double direction_rad) const { return project(view_, direction_of(direction_rad, 0)); }
    /// Offset to the side that spans so many pixels near the middle of the screen.
    [[nodiscard]] double tangent_of(float pixels) const { return static_cast<double>(pixels) / view_.focal_px; }

private:
    const ViewFrame& view_;
    double heading_rad_;
};

}  // namespace tedavis::draw
