#include "render_core/draw/shadow_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/free_view.hpp"

namespace tedavis::draw::test_shadow_frame {
namespace {

terrain::View view_from(double latitude_deg, double longitude_deg, double height_m, double heading_rad, double pitch_rad) {
    const double latitude = base::radians(latitude_deg), longitude = base::radians(longitude_deg);
    return test_support::free_view(earth::to_ecef({latitude, longitude, {height_m}}),
                                   earth::body_axes(latitude, longitude, heading_rad, pitch_rad, 0), 640, 480, 10);
}

TEST(ShadowFrame, AxesAreARightHandAndTheThirdIsTheSun) {
    for (const double elevation : {0.06, 0.8, 1.57}) {
        const terrain::View view = view_from(47.01, 9.99, 2000, 1, -0.2);
        const ShadowFrame frame = make_shadow_frame({view, 1000, 2.3, elevation, 1024});
        EXPECT_LT(glm::length(glm::cross(frame.axes[0], frame.axes[1]) - frame.axes[2]), 1e-12);
        const glm::dmat3 down = earth::north_east_down(base::radians(47.0), base::radians(10.0));
        const glm::dvec3 sun =
            down * glm::dvec3(std::cos(elevation) * std::cos(2.3), std::cos(elevation) * std::sin(2.3), -std::sin(elevation));
        EXPECT_LT(glm::length(frame.axes[2] - sun), 1e-12) << "at the knot";
        EXPECT_LT(std::fabs(glm::dot(frame.axes[0], down[2])), 1e-12) << "level";
    }
}

TEST(ShadowFrame, TexelsStayWhereTheyAreWhileTheEyeMoves) {
    const ShadowFrame first = make_shadow_frame({view_from(47.0, 10.0, 2000, 0.4, 0), 900, 2.3, 0.7, 1024});
    bool has_moved = false;
    for (int n = 1; n < 200; ++n) {
        const ShadowFrame next =
            make_shadow_frame({view_from(47.0 + 1e-5 * n, 10.0 + 2e-5 * n, 2000, 0.4, 0), 900, 2.3, 0.7, 1024});
        ASSERT_EQ(next.anchor, first.anchor);
        ASSERT_EQ(next.axes, first.axes);
        for (std::size_t k = 0; k < kShadowLevels; ++k) {
            const glm::dvec2 texels = (next.levels[k].middle_m - first.levels[k].middle_m) / texel_m(first.levels[k], 1024);
            ASSERT_NEAR(texels.x, std::round(texels.x), 1e-9);
            ASSERT_NEAR(texels.y, std::round(texels.y), 1e-9);
            has_moved = has_moved || glm::length(texels) > 0.5;
        }
    }
    EXPECT_TRUE(has_moved) << "control: they follow the eye";
}

TEST(ShadowFrame, EveryLevelLiesInTheNextAndHasTheEye) {
    for (const double height_m : {50.0, 2000.0, 11'000.0})
        for (const double pitch : {-1.57, -0.3, 0.0}) {
            const terrain::View view = view_from(47.0, 10.0, height_m, 2.0, pitch);
            const ShadowFrame frame = make_shadow_frame({view, height_m, 2.3, 0.7, 1024});
            for (std::size_t n = 0; n + 1 < kShadowLevels; ++n) {
                const glm::dvec2 away = glm::abs(frame.levels[n].middle_m - frame.levels[n + 1].middle_m);
                EXPECT_LT(std::fmax(away.x, away.y) + frame.levels[n].half_m, frame.levels[n + 1].half_m);
            }
            EXPECT_GE(frame.levels[0].half_m, std::fmin(height_m, 16'000) * 0.99) << "ground below the eye is in the finest";
        }
}

TEST(ShadowFrame, ACasterIsInTheLevelsThatItReaches) {
    const terrain::View view = view_from(47.0, 10.0, 1000, 0, 0);
    ShadowFrame frame = make_shadow_frame({view, 1000, 2.3, 0.7, 1024});
    const glm::dvec3 far = frame.anchor + frame.axes[0] * (frame.levels[1].middle_m.x + 1.5 * frame.levels[1].half_m) +
                           frame.axes[1] * frame.levels[1].middle_m.y;
    add_caster(frame, {far, 10, 700});
    EXPECT_FALSE(frame.levels[0].is_used);
    EXPECT_FALSE(frame.levels[1].is_used);
    EXPECT_TRUE(frame.levels[2].is_used);
    EXPECT_EQ(frame.top_m, 700);
    add_caster(frame, {far, frame.levels[1].half_m, 500});
    EXPECT_TRUE(frame.levels[1].is_used) << "it reaches in";
    EXPECT_EQ(frame.top_m, 700) << "the highest";
}

TEST(ShadowFrame, OnlyWhatMayShadeThePictureIsInIt) {
    const terrain::View view = view_from(47.0, 10.0, 1000, 0, -0.1);                                         // to the north
    const ShadowFrame frame = make_shadow_frame({view, 1000, base::radians(180), base::radians(30), 1024});  // in the south
    const glm::dmat3 down = earth::north_east_down(base::radians(47.0), base::radians(10.0));
    const auto ball = [&](double north_m, double east_m, double height_m) {
        return CasterBall{view.eye + down * glm::dvec3(north_m, east_m, 1000 - height_m), 20, height_m};
    };
    EXPECT_TRUE(shades_the_view(frame, view, ball(3000, 0, 800), 0)) << "before the eye";
    EXPECT_TRUE(shades_the_view(frame, view, ball(-1000, 0, 3000), 0)) << "behind it, the shadow falls before it";
    EXPECT_FALSE(shades_the_view(frame, view, ball(-1000, 0, 300), 0)) << "behind it, and the shadow, too";
    EXPECT_FALSE(shades_the_view(frame, view, ball(3000, 9000, 800), 0)) << "beside the picture";
}

}  // namespace
}  // namespace tedavis::draw::test_shadow_frame
