#include "render_core/display/stereo_cameras.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tedavis::display::test_stereo_cameras {
namespace {

using draw::EyeSide;

constexpr std::uint32_t kWidth = 1024;
constexpr double kField_rad = 1.0471975511965976;
const double kFocal_px = 0.5 * kWidth / std::tan(0.5 * kField_rad);
const std::uint32_t kMargin_px = eye_margin_px(kField_rad, kWidth);

/// At the origin of axes of its own: x right, y down, z forward.
Camera middle_camera(double near_m) {
    Camera camera;
    camera.view.eye = {0, 0, 0};
    camera.view.right = {1, 0, 0};
    camera.view.down = {0, 1, 0};
    camera.view.forward = {0, 0, 1};
    camera.view.focal_px = kFocal_px;
    camera.view.width = kWidth;
    camera.view.height = 768;
    camera.view.near_m = near_m;
    return camera;
}

/// Column on the screen where an eye sees a place.
double column(const Camera& camera, const StereoCameras& pair, EyeSide side, const glm::dvec3& place) {
    const glm::dvec3 from = place - camera.view.eye;
    const double in_picture = 0.5 * camera.view.width + camera.view.focal_px * from.x / from.z;
    const double begins = kMargin_px + (side == EyeSide::left ? 1.0 : -1.0) * pair.shift_px;
    return in_picture - begins;
}

double parallax(const Camera& middle, const StereoCameras& pair, const glm::dvec3& place) {
    const Camera left = camera_of(middle, pair, EyeSide::left, kMargin_px),
                 right = camera_of(middle, pair, EyeSide::right, kMargin_px);
    return column(left, pair, EyeSide::left, place) - column(right, pair, EyeSide::right, place);
}

TEST(StereoCameras, ThePlaneOfTheScreenHasNoParallax) {
    const Camera middle = middle_camera(20);
    const StereoCameras pair = stereo_cameras({design::StereoMode::anaglyph, 2, 300}, kFocal_px, 20, kMargin_px);
    EXPECT_EQ(pair.base_m, 2);
    const double screen_m = pair.screen_m(kFocal_px);
    EXPECT_NEAR(screen_m, 300, 300 / (2.0 * pair.shift_px)) << "within half a pixel of shift";
    for (const double x : {-100.0, 0.0, 80.0}) EXPECT_NEAR(parallax(middle, pair, {x, 30, screen_m}), 0, 1e-9);
    EXPECT_NEAR(parallax(middle, pair, {5, 5, 1e9}), -2.0 * pair.shift_px, 1e-5) << "what is far is uncrossed";
    EXPECT_GT(parallax(middle, pair, {5, 5, 100}), 0) << "what is near is crossed";
    const Camera left = camera_of(middle, pair, EyeSide::left, kMargin_px),
                 right = camera_of(middle, pair, EyeSide::right, kMargin_px);
    EXPECT_DOUBLE_EQ(right.view.eye.x - left.view.eye.x, 2);
    EXPECT_EQ(left.view.width, kWidth + 2 * kMargin_px);
    EXPECT_NEAR(
        0.5 * (column(left, pair, EyeSide::left, {0, 0, screen_m}) + column(right, pair, EyeSide::right, {0, 0, screen_m})),
        0.5 * kWidth, 1e-9);
}

TEST(StereoCameras, TheBaseIsSmallerWhereScreenOrGroundAreNear) {
    const design::Stereo wide{design::StereoMode::anaglyph, 100, 3000};
    EXPECT_EQ(stereo_cameras(wide, kFocal_px, 1e6, kMargin_px).base_m, 100);
    EXPECT_EQ(stereo_cameras(wide, kFocal_px, 12, kMargin_px).base_m, 2);
    EXPECT_EQ(stereo_cameras({design::StereoMode::anaglyph, 100, 60}, kFocal_px, 50, kMargin_px).base_m, 2);
    EXPECT_EQ(stereo_cameras(wide, kFocal_px, 0, kMargin_px).base_m, 0);
    EXPECT_TRUE(std::isinf(StereoCameras{}.screen_m(kFocal_px)));
}

TEST(StereoCameras, WhatAnEyeShowsIsInTheMiddleViewAndInItsPicture) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int n = 0; n < 20'000; ++n) {
        const double near_m = std::exp(8 * unit(random) - 1);
        const design::Stereo stereo{design::StereoMode::anaglyph, std::exp(9 * unit(random) - 4), std::exp(12 * unit(random))};
        const StereoCameras pair = stereo_cameras(stereo, kFocal_px, near_m, kMargin_px);
        const Camera middle = middle_camera(near_m);
        const terrain::View seen = seen_by_both(middle.view, pair);
        ASSERT_LE(pair.shift_px, static_cast<std::int32_t>(kMargin_px));
        const double z = near_m * std::exp(10 * unit(random));
        const glm::dvec3 place{(unit(random) - 0.5) * 2 * z, 0, z};
        for (const EyeSide side : draw::kEyeSides) {
            const double at = column(camera_of(middle, pair, side, kMargin_px), pair, side, place);
            if (at < 0 || at > kWidth) continue;
            EXPECT_LE(std::abs(place.x) / z, seen.half_width_tangent() * (1 + 1e-12)) << n;
        }
        EXPECT_LE(std::abs(parallax(middle, pair, place)), parallax_bound_px(pair, kFocal_px, near_m, 1e9) + 1e-6) << n;
    }
    EXPECT_EQ(parallax_bound_px({}, kFocal_px, 1, 1e9), 0);
}

}  // namespace
}  // namespace tedavis::display::test_stereo_cameras
