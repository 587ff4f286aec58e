/// Two eyes beside the one that a frame is planned for: where they are, and how far their pictures move so that what lies in the
/// screen's plane has the same place in both.
///
/// A point at depth d has the parallax f b (1/d - 1/c) pixels: f the focal length in pixels, b the eyes' distance from one
/// another, c that of the screen. Pixels of the picture; metres. Pure; any thread.
#pragma once

#include "render_core/design/view_effects.hpp"
#include "render_core/display/camera.hpp"
#include "render_core/draw/stereo_pass.hpp"

namespace tedavis::display {

/// So many times farther than the eyes are apart is the screen (the rule of thirty, from stereo photography); and at least so
/// many times all that is drawn.
inline constexpr double kScreenOfBase = 30, kNearestOfBase = 6;

struct StereoCameras {
    double base_m = 0;          ///< 0: both are the middle one
    std::int32_t shift_px = 0;  ///< of each eye's picture towards its own side

    /// Of the screen's plane, which whole pixels move a little; infinite where both are the middle one.
    [[nodiscard]] double screen_m(double focal_px) const;
};

/// How much wider than the screen an eye's picture is, on either side: enough for every pair of a view of this width.
[[nodiscard]] std::uint32_t eye_margin_px(double horizontal_field_of_view_rad, std::uint32_t width_px) noexcept;

/// Of a view whose near plane is at `near_m`.
[[nodiscard]] StereoCameras stereo_cameras(const design::Stereo& stereo, double focal_px, double near_m,
                                           std::uint32_t margin_px) noexcept;

/// The middle eye's view, so wide that it has all that either eye shows.
[[nodiscard]] terrain::View seen_by_both(const terrain::View& middle, const StereoCameras& pair) noexcept;

/// An eye of the pair, with the wider picture.
[[nodiscard]] Camera camera_of(const Camera& middle, const StereoCameras& pair, draw::EyeSide side,
                               std::uint32_t margin_px) noexcept;

/// The greatest parallax, in pixels, of what lies between these depths.
[[nodiscard]] double parallax_bound_px(const StereoCameras& pair, double focal_px, double nearest_m, double farthest_m) noexcept;

}  // namespace tedavis::display
