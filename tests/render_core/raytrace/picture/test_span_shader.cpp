#include "render_core/raytrace/picture/span_shader.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/picture/trace_presets.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

/// A plane of height 0, with a ridge kRidge steps high along column 40.
class SpanShaderTest : public ::testing::Test {
protected:
    static constexpr std::int16_t kRidge = 20000;
    static test_support::HeightField<std::int16_t> ridge() {
        test_support::HeightField<std::int16_t> posts(65, 65);
        for (std::uint32_t row = 0; row < 65; ++row) posts.at(40, row) = kRidge;
        return posts;
    }
    SpanShaderTest() : drawn_(ridge(), {time_preset()}, 16, 16) {
        settings_ = time_preset();
        drawn_.look.ground.palette = {};
        drawn_.look.material.color = {0.5f, 0.25f, 1};
        drawn_.look.sun.towards = glm::normalize(glm::dvec3(1, 0, 1));
        scale_ = drawn_.scene.scale();
        shader_ = {&settings_, &drawn_.scene.terrain(settings_), drawn_.scene.maps(), &drawn_.look, 0};
    }
    /// Straight down on places along a row.
    void look_down(std::initializer_list<double> columns) {
        surface_.count = 0;
        for (const double x : columns) {
            const std::uint32_t n = surface_.count++;
            rays_.direction[0][n] = rays_.direction[1][n] = 0;
            rays_.direction[2][n] = -1;
            origins_[n] = {x, 20.5, 30000};
            rays_.origins = origins_;
            const RayHit hit = shader_.terrain->intersect(rays_.ray(n));
            surface_.is_hit[n] = hit.is_hit;
            surface_.x[n] = hit.x;
            surface_.y[n] = hit.y;
            surface_.t[n] = hit.t;
            surface_.height[n] = static_cast<float>(hit.point.height);
            surface_.slope_x[n] = static_cast<float>(hit.point.slope_x);
            surface_.slope_y[n] = static_cast<float>(hit.point.slope_y);
            seeds_[n] = n;
        }
        shader_.shade(rays_, seeds_, surface_, light_);
    }

    test_support::DrawnTrace drawn_;
    TraceSettings settings_;
    GridScale scale_;
    SpanShader<std::int16_t> shader_;
    SpanRays rays_;
    SpanSurface surface_;
    glm::dvec3 origins_[PixelSpan::kMax];
    std::uint32_t seeds_[PixelSpan::kMax];
    glm::vec3 light_[PixelSpan::kMax];
};

TEST_F(SpanShaderTest, ShadowsLieBehindTheRidgeAsFarAsItsHeightSays) {
    settings_.has_shadows = true;
    const double reach = kRidge * scale_.height_m / scale_.column_m;  // posts: the sun is 45 degrees high
    look_down({40 - reach - 0.5, 40 - reach + 0.5, 44, 200});
    const float lit = 0.5f * (drawn_.look.sky.x + drawn_.look.sun.radiance.x * std::sqrt(0.5f));
    EXPECT_NEAR(light_[0].x, lit, 1e-4);
    EXPECT_NEAR(light_[1].x, 0.5f * drawn_.look.sky.x, 1e-6);
    EXPECT_NEAR(light_[2].x, lit, 1e-4);
    EXPECT_EQ(light_[3], drawn_.look.background);
    settings_.has_shadows = false;
    look_down({40 - reach + 0.5});
    EXPECT_NEAR(light_[0].x, lit, 1e-4);
}

TEST_F(SpanShaderTest, WithoutShadingColorsAreTheGroundsAndThoseOfData) {
    settings_.shading = Shading::none;
    look_down({10, 20});
    EXPECT_EQ(light_[0], drawn_.look.material.color);
    const float values[4] = {1, 1, 1, 1}, doubts[4] = {0.25f, 0.25f, 0.25f, 0.25f};
    const glm::vec3 palette[] = {{1, 1, 0}};
    drawn_.look.values = {values, 2, 2, 15, 0, 40, 60};
    drawn_.look.uncertainties = {doubts, 2, 2, 15, 0, 40, 60};
    drawn_.look.legend.palette = palette;
    settings_.has_data = true;
    look_down({10, 20});
    EXPECT_EQ(light_[0], drawn_.look.material.color);
    EXPECT_NEAR(light_[1].x, 0.5 * 0.25 + 1 * 0.75, 1e-6);
    EXPECT_NEAR(light_[1].z, 1 * 0.25, 1e-6);
}

TEST_F(SpanShaderTest, TheNearestCapsuleHidesTheGround) {
    settings_.has_capsules = true;
    const Capsule bars[] = {{{0, 615, 200}, {400, 615, 200}, 20}, {{0, 615, -900}, {400, 615, -900}, 20}};
    drawn_.look.capsules = bars;
    look_down({10, 20});  // 300 and 600 m along, 615 m across
    EXPECT_GT(light_[0].x, 2 * light_[0].y);
    EXPECT_NEAR(light_[1].x, 0.5f * (drawn_.look.sky.x + drawn_.look.sun.radiance.x * std::sqrt(0.5f)), 1e-4);
}

TEST_F(SpanShaderTest, AMirrorSendsRaysUpAgain) {
    drawn_.look.material.mirror = 0.5f;
    drawn_.look.mirror_below = 10;
    look_down({10, 39.9});
    EXPECT_EQ(shader_.mirror_of(surface_, 0), 0.5f);
    EXPECT_EQ(shader_.mirror_of(surface_, 1), 0.0f);
    rays_.direction[0][0] = 1;
    rays_.direction[2][0] = static_cast<float>(-scale_.column_m / scale_.height_m);  // 45 degrees
    const Ray sent = shader_.mirrored(rays_, surface_, 0);
    EXPECT_GT(sent.direction.z, 0);
    EXPECT_NEAR(sent.direction.z * scale_.height_m, sent.direction.x * scale_.column_m, 1e-3);
    EXPECT_NEAR(sent.origin.x, 10, 1e-9);
}

TEST_F(SpanShaderTest, PathsOnLevelGroundSeeSunAndSky) {
    settings_.paths = 32;
    settings_.bounces = 1;
    look_down({1});
    const float right = 0.5f * (drawn_.look.sky.x + drawn_.look.sun.radiance.x * std::sqrt(0.5f));
    EXPECT_NEAR(light_[0].x, right, 0.1f * right);
}

}  // namespace
}  // namespace tedavis::raytrace
