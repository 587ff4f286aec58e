/// A pinhole camera for terrain and drawers: pose in ECEF, picture size in pixels, clip planes. Plain data.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>

#include "render_core/earth/magnifier.hpp"

namespace tedavis::terrain {

/// Error bounds from the true surface round the eye point, for errors of several sizes (near_ground.hpp).
struct NearGround {
    static constexpr int kMaxSteps = 13;

    /// A vertical error of no more than margin_m moves no drawn point by more than px_per_m for each metre of it.
    struct Step {
        double margin_m = 0, px_per_m = 0;
    };
    Step steps[kMaxSteps];  ///< by ascending margins
    int count = 0;

    /// Returns the bound in pixels; infinite for an error beyond the last margin.
    [[nodiscard]] double px(double error_m) const {
        for (int n = 0; n < count; ++n)
            if (error_m <= steps[n].margin_m) return error_m * steps[n].px_per_m;
        return std::numeric_limits<double>::infinity();
    }
};

struct View {
    glm::dvec3 eye;      ///< ECEF, m
    glm::dvec3 forward;  ///< unit vectors in ECEF
    glm::dvec3 right;
    glm::dvec3 down;
    double focal_px = 1;  ///< focal length, pixels per unit tangent, both axes
    std::uint32_t width = 1, height = 1;
    double near_m = 1;
    double far_m = 400000;
    NearGround ground;  ///< holds for this pose, and for no wider picture (near_ground.hpp)
    /// Not NaN: the surface is drawn as a plane at this height above MSL.
    double flat_msl_m = std::numeric_limits<double>::quiet_NaN();

    earth::Magnifiers magnifiers{};  ///< drawing and placing apply them

    [[nodiscard]] bool is_flat() const { return flat_msl_m == flat_msl_m; }
    [[nodiscard]] double half_width_tangent() const { return 0.5 * width / focal_px; }
    [[nodiscard]] double half_height_tangent() const { return 0.5 * height / focal_px; }
};
static_assert(std::is_trivially_copyable_v<View>);

}  // namespace tedavis::terrain
