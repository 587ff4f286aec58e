#include "render_core/raytrace/picture/span_light.hpp"

#include <gtest/gtest.h>

#include <random>

#include "render_core/raytrace/shading/aperture_light.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kLitPosts = 65;
constexpr GridScale kPostScale = {30, 25, 0.5};

class SpanLightTest : public ::testing::Test {
protected:
    SpanLightTest()
        : heights_(test_support::fractal_heights(kLitPosts)), memory_(1 << 20), arena_(memory_.data(), memory_.size()) {
        SkyMapSettings settings;
        settings.scale = kPostScale;
        settings.has_apertures = true;
        EXPECT_TRUE(sky_.start(heights_.grid(), settings, arena_));
        base::SerialWorkers alone;
        sky_.build(alone);
    }

    void any_surface() {
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); };
        surface_.count = PixelSpan::kMax;
        for (std::uint32_t n = 0; n < surface_.count; ++n) {
            surface_.is_hit[n] = true;
            surface_.x[n] = any(0, kLitPosts - 1);
            surface_.y[n] = any(0, kLitPosts - 1);
            surface_.height[n] = static_cast<float>(any(-100, 1200));
            surface_.slope_x[n] = static_cast<float>(any(-80, 80));
            surface_.slope_y[n] = static_cast<float>(any(-80, 80));
            eye_[0][n] = static_cast<float>(any(-1, 1));
            eye_[1][n] = static_cast<float>(any(-1, 1));
            eye_[2][n] = static_cast<float>(any(-1, 1));
            light_.sun_seen[n] = light_.sky_seen[n] = 1;
        }
        look_.sun.towards = glm::normalize(glm::dvec3(any(-1, 1), any(-1, 1), any(-0.1, 1)));
        look_.sun.radiance = {1, 0.5f, 0.25f};
        look_.material.gloss = 0.5f;
        look_.material.sharpness = 1 + static_cast<std::uint32_t>(any(0, 40));
        find_normals(surface_, kPostScale, light_.normal);
        find_eyes(eye_[0], eye_[1], eye_[2], surface_.count, kPostScale, light_.eye);
        find_colors(surface_, look_, light_.color);
    }
    [[nodiscard]] glm::dvec3 normal(std::uint32_t n) const {
        return normal_of({surface_.height[n], surface_.slope_x[n], surface_.slope_y[n]}, kPostScale);
    }
    [[nodiscard]] glm::dvec3 eye(std::uint32_t n) const {
        return -glm::normalize(
            glm::dvec3(eye_[0][n] * kPostScale.column_m, eye_[1][n] * kPostScale.row_m, eye_[2][n] * kPostScale.height_m));
    }

    test_support::HeightField<std::int16_t> heights_;
    std::vector<unsigned char> memory_;
    base::Arena arena_;
    SkyMap<std::int16_t> sky_;
    std::mt19937 random_{3};
    SpanSurface surface_;
    TraceLook look_;
    SpanLight light_;
    float eye_[3][PixelSpan::kMax];
};

TEST_F(SpanLightTest, IsLocalLightOfOnePlaceAtATime) {
    double worst = 0;
    for (int run = 0; run < 200; ++run) {
        any_surface();
        add_up_light(Shading::phong, look_, surface_.count, light_);
        for (std::uint32_t n = 0; n < surface_.count; ++n) {
            const glm::vec3 one = local_light(look_.material, normal(n), eye(n), look_.sun, 1, look_.sky, 1);
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(double{light_.light[c][n]} - double{one[c]}));
        }
    }
    EXPECT_LT(worst, 2e-5);
}

TEST_F(SpanLightTest, SkyViewsAreThoseOfTheMap) {
    any_surface();
    find_sky(surface_, sky_, Ambient::sky_view, look_.sun.towards, light_);
    for (std::uint32_t n = 0; n < surface_.count; ++n)
        EXPECT_NEAR(light_.sky_seen[n], sky_.view_at(surface_.x[n], surface_.y[n]), 2e-6);
}

TEST_F(SpanLightTest, AperturesLetThroughWhatTheyDoOneByOne) {
    double worst_sky = 0, worst_sun = 0;
    std::uint32_t partly = 0;
    for (int run = 0; run < 1000; ++run) {
        any_surface();
        if (run % 2 == 1) {  // the sun near the rim of the first place's aperture
            const Aperture first = sky_.aperture_at(surface_.x[0], surface_.y[0], normal(0));
            const double radius = std::acos(first.cos_radius);
            const glm::dvec3 across = glm::normalize(glm::cross(first.axis, glm::dvec3(0.3, 0.5, -0.2)));
            look_.sun.towards = std::cos(radius) * first.axis + std::sin(radius) * across;
        }
        find_sky(surface_, sky_, Ambient::apertures, look_.sun.towards, light_);
        for (std::uint32_t n = 0; n < surface_.count; ++n) {
            const Aperture aperture = sky_.aperture_at(surface_.x[n], surface_.y[n], normal(n));
            const ApertureLight one = aperture_light(aperture, normal(n), look_.sun.towards, kSunRadius_rad, OverlapKind::smooth);
            worst_sky = std::max(worst_sky, std::abs(double{light_.sky_seen[n]} - one.sky));
            worst_sun = std::max(worst_sun, std::abs(double{light_.sun_seen[n]} - one.sun));
            partly += one.sun > 0.01 && one.sun < 0.99 ? 1 : 0;
        }
    }
    EXPECT_GT(partly, 300U);
    EXPECT_LT(worst_sky, 2e-5);
    EXPECT_LT(worst_sun, 1e-3);
}

TEST_F(SpanLightTest, ColorsGoByHeightFromTheFirstToTheLast) {
    const glm::vec3 palette[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}};
    look_.ground = {palette, 100, 300};
    surface_.count = 5;
    const float heights[] = {-50, 100, 150, 250, 900};
    std::copy(heights, heights + 5, surface_.height);
    find_colors(surface_, look_, light_.color);
    const glm::vec3 expected[] = {{0, 0, 0}, {0, 0, 0}, {0.5f, 0, 0}, {1, 0.5f, 0.25f}, {1, 1, 0.5f}};
    for (std::uint32_t n = 0; n < 5; ++n)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(light_.color[c][n], expected[n][c], 1e-6) << n;
}

}  // namespace
}  // namespace tedavis::raytrace
