#include "render_core/display/stereo_cameras.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tedavis::display {

double StereoCameras::screen_m(double focal_px) const {
    return shift_px > 0 ? 0.5 * focal_px * base_m / shift_px : std::numeric_limits<double>::infinity();
}

std::uint32_t eye_margin_px(double horizontal_field_of_view_rad, std::uint32_t width_px) noexcept {
    const double focal_px = 0.5 * width_px / std::tan(0.5 * horizontal_field_of_view_rad);
    return static_cast<std::uint32_t>(std::ceil(0.5 * focal_px / kScreenOfBase));
}

StereoCameras stereo_cameras(const design::Stereo& stereo, double focal_px, double near_m, std::uint32_t margin_px) noexcept {
    StereoCameras pair;
    pair.base_m = std::fmin(stereo.base_m, std::fmin(stereo.screen_m / kScreenOfBase, near_m / kNearestOfBase));
    const double shift_px = 0.5 * focal_px * pair.base_m / stereo.screen_m;
    // A free view may have a longer lens than the margin was made for.
    pair.shift_px = static_cast<std::int32_t>(std::fmin(std::round(shift_px), margin_px));
    return pair;
}

terrain::View seen_by_both(const terrain::View& middle, const StereoCameras& pair) noexcept {
    terrain::View seen = middle;
    // The parallax of what is nearest; of what is farthest it is no greater than the shift, which is smaller.
    const double nearest_px = 0.5 * middle.focal_px * pair.base_m / middle.near_m;
    seen.width += 2 * static_cast<std::uint32_t>(std::ceil(std::fmax(nearest_px, pair.shift_px)));
    return seen;
}

Camera camera_of(const Camera& middle, const StereoCameras& pair, draw::EyeSide side, std::uint32_t margin_px) noexcept {
    Camera camera = middle;
    camera.view.eye += (side == draw::EyeSide::left ? -0.5 : 0.5) * pair.base_m * middle.view.right;
    camera.view.width += 2 * margin_px;
    return camera;
}

double parallax_bound_px(const StereoCameras& pair, double focal_px, double nearest_m, double farthest_m) noexcept {
    if (!(pair.base_m > 0)) return 0;
    const auto parallax_px = [&](double depth_m) {
        return std::abs(focal_px * pair.base_m / std::fmax(depth_m, 1e-3) - 2.0 * pair.shift_px);
    };
    return std::fmax(parallax_px(nearest_m), parallax_px(farthest_m));
}

}  // namespace tedavis::display
