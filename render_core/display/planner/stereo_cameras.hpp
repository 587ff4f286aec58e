/// The two cameras of a stereo picture, beside the one that a frame is planned for: their positions, and the shift of their
/// pictures that makes points in the screen's plane coincide.
///
/// A point at depth d has the parallax f b (1/d - 1/c) pixels: f the focal length in pixels, b the eyes' distance from one
/// another, c that of the screen. Pixels of the picture; metres. Pure; any thread.
#pragma once

#include "render_core/design/view_effects.hpp"
#include "render_core/display/planner/camera.hpp"
#include "render_core/draw/eye_side.hpp"

namespace tedavis::display {

/// Distances as multiples of the distance between the eyes: that of the screen (the rule of thirty, from stereo photography), and
/// the least of what is drawn.
inline constexpr double kScreenOfBase = 30, kNearestOfBase = 6;

struct StereoCameras {
    double base_m = 0;          ///< 0: both are the middle one
    std::int32_t shift_px = 0;  ///< of each eye's picture towards its own side

    /// Returns the distance of the screen's plane, which the rounding to whole pixels changes a little; infinite where both are
    /// the middle one.
    [[nodiscard]] double screen_m(double focal_px) const;
};

/// Returns by how much an eye's picture is wider than the screen, on either side: enough for every pair of a view of this width.
[[nodiscard]] std::uint32_t eye_margin_px(double horizontal_field_of_view_rad, std::uint32_t width_px) noexcept;

/// Returns the pair of cameras for a view whose near plane is at `near_m`.
[[nodiscard]] StereoCameras stereo_cameras(const design::Stereo& stereo, double focal_px, double near_m,
                                           std::uint32_t margin_px) noexcept;

/// Returns the middle eye's view, widened to contain all that either eye shows.
[[nodiscard]] terrain::View seen_by_both(const terrain::View& middle, const StereoCameras& pair) noexcept;

/// Returns a camera of the pair, with the wider picture.
[[nodiscard]] Camera camera_of(const Camera& middle, const StereoCameras& pair, draw::EyeSide side,
                               std::uint32_t margin_px) noexcept;

/// Returns the greatest parallax, in pixels, between these depths.
[[nodiscard]] double parallax_bound_px(const StereoCameras& pair, double focal_px, double nearest_m, double farthest_m) noexcept;

}  // namespace tedavis::display
