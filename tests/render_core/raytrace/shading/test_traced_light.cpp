#include "render_core/raytrace/shading/traced_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_traced_light {
namespace {

/// The inside of a ball of one material, with nothing else: what is reflected is known in closed form.
struct Ball {
    Material material;
    bool is_open_above = false;
    int rays = 0, shadow_rays = 0;

    LitScene scene() {
        LitScene made;
        made.intersect = [](const void* context, const glm::dvec3& origin, const glm::dvec3& direction) {
            auto& ball = *static_cast<Ball*>(const_cast<void*>(context));
            ++ball.rays;
            const double b = glm::dot(origin, direction), c = glm::dot(origin, origin) - 1;
            const glm::dvec3 point = origin + (-b + std::sqrt(std::max(b * b - c, 0.0))) * direction;
            LitPlace place;
            place.is_hit = !(ball.is_open_above && point.z > 0);
            place.normal = -glm::normalize(point);
            place.point = point * 0.9999999;
            place.material = ball.material;
            return place;
        };
        made.is_hidden = [](const void* context, const glm::dvec3&, const glm::dvec3&) {
            ++static_cast<Ball*>(const_cast<void*>(context))->shadow_rays;
            return true;
        };
        made.context = this;
        return made;
    }
};

/// A floor at z = 0 under an open sky.
LitScene floor_scene(const Material* material) {
    LitScene scene;
    scene.intersect = [](const void* context, const glm::dvec3& origin, const glm::dvec3& direction) {
        LitPlace place;
        place.is_hit = direction.z < 0;
        if (place.is_hit) place.point = origin - direction * (origin.z / direction.z) + glm::dvec3(0, 0, 1e-9);
        place.material = *static_cast<const Material*>(context);
        return place;
    };
    scene.is_hidden = [](const void*, const glm::dvec3&, const glm::dvec3&) { return false; };
    scene.context = material;
    return scene;
}

TEST(TracedLight, AFloorUnderAnEvenSkyHasItsColor) {
    Material material;
    material.color = {0.2f, 0.5f, 0.9f};
    LitScene scene = floor_scene(&material);
    scene.sun.radiance = glm::vec3(0);
    const glm::vec3 light = traced_light(scene, {0, 0, 5}, {0.3, 0.1, -1}, {1, 64}, 7);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(light[channel], material.color[channel], 1e-6);
}

TEST(TracedLight, AFloorInTheSunIsLamberts) {
    Material material;
    material.color = glm::vec3(0.5f);
    LitScene scene = floor_scene(&material);
    scene.sky = glm::vec3(0);
    scene.sun.towards = glm::normalize(glm::dvec3(1, 0, 1));
    scene.sun.radiance = glm::vec3(2);
    EXPECT_NEAR(traced_light(scene, {0, 0, 5}, {0, 0, -1}, {2, 8}, 1).x, 0.5 * 2 * std::sqrt(0.5), 1e-6);
    scene.is_hidden = [](const void*, const glm::dvec3&, const glm::dvec3&) { return true; };
    EXPECT_EQ(traced_light(scene, {0, 0, 5}, {0, 0, -1}, {2, 8}, 1).x, 0);
}

TEST(TracedLight, AMirrorShowsTheSkyAndAHalfMirrorHalfOfIt) {
    Material material;
    material.color = glm::vec3(0);
    material.mirror = 1;
    LitScene scene = floor_scene(&material);
    scene.sun.radiance = glm::vec3(0);
    EXPECT_EQ(traced_light(scene, {0, 0, 5}, {1, 0, -1}, {1, 4}, 3).x, 1);
    material.mirror = 0.5f;
    EXPECT_NEAR(traced_light(scene, {0, 0, 5}, {1, 0, -1}, {1, 1000}, 3).x, 0.5, 5e-3);
}

TEST(TracedLight, BouncesInAHalfOpenBallComeToTheirLimit) {
    // From the lower half of a ball every direction of light is even (the integrating sphere): with half of it open the light of
    // the wall after n bounces is the sum of powers of colour / 2.
    Ball ball;
    ball.material.color = glm::vec3(0.8f);
    ball.is_open_above = true;
    for (const std::uint32_t bounces : {1u, 2u, 4u, 12u}) {
        LitScene scene = ball.scene();
        scene.sun.radiance = glm::vec3(0);
        double expected = 0, kept = 0.5;
        for (std::uint32_t n = 0; n < bounces; ++n, kept *= 0.5) expected += std::pow(0.8, n + 1) * kept;
        const glm::vec3 light = traced_light(scene, {0, 0, 0}, {0.2, 0.1, -1}, {bounces, 4096}, 5);
        EXPECT_NEAR(light.x, expected, 4e-3) << bounces;
    }
}

TEST(TracedLight, RaysAreBounded) {
    Ball ball;
    const LitScene scene = ball.scene();
    (void)traced_light(scene, {0, 0, 0}, {0, 0, -1}, {5, 10}, 1);
    EXPECT_EQ(ball.rays, 60);
    EXPECT_LE(ball.shadow_rays, 60);
}

TEST(TracedLight, ThePictureIsTheSameEveryTimeAndPixelsDiffer) {
    Ball ball;
    ball.is_open_above = true;
    LitScene scene = ball.scene();
    scene.sun.radiance = glm::vec3(0);
    const float one = traced_light(scene, {0, 0, 0}, {0.1, 0, -1}, {3, 16}, 1).x;
    EXPECT_EQ(traced_light(scene, {0, 0, 0}, {0.1, 0, -1}, {3, 16}, 1).x, one);
    EXPECT_NE(traced_light(scene, {0, 0, 0}, {0.1, 0, -1}, {3, 16}, 2).x, one);
}

TEST(TracedLight, DirectionsAreSpreadByTheCosine) {
    test_support::Dice dice(1);
    for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::normalize(glm::dvec3(1, -2, 0.3)),
                                     glm::normalize(glm::dvec3(1e-9, 0, -1))}) {
        glm::dvec3 mean(0);
        double square = 0;
        for (std::uint32_t n = 0; n < 4000; ++n) {
            const glm::dvec2 sample = even_sample(n, 3, 9);
            const glm::dvec3 direction = cosine_direction(normal, sample.x, sample.y);
            ASSERT_NEAR(glm::length(direction), 1, 1e-12);
            const double cosine = glm::dot(direction, normal);
            ASSERT_GE(cosine, -1e-12);
            mean += direction;
            square += cosine * cosine;
        }
        EXPECT_LT(glm::length(mean / 4000.0 - normal * (2.0 / 3)), 0.01) << normal.z;
        EXPECT_NEAR(square / 4000, 0.5, 0.01);
    }
}

TEST(TracedLight, TheSequenceHasOnePointInEveryBox) {
    for (const std::uint32_t dimension : {0u, 1u, 4u, 9u})
        for (int across = 0; across <= 8; ++across) {
            std::vector<int> points(256);
            for (std::uint32_t n = 0; n < 256; ++n) {
                const glm::dvec2 p = even_sample(n, dimension, 77);
                const auto column = static_cast<std::size_t>(p.x * (1 << across));
                const auto row = static_cast<std::size_t>(p.y * (1 << (8 - across)));
                ++points[(column << (8 - across)) + row];
            }
            for (const int count : points) ASSERT_EQ(count, 1) << dimension << ' ' << across;
        }
}

TEST(TracedLight, PlacesInAPathDoNotFollowEachOther) {
    // A choice made by one leaves the next even: means of products of what is above and below a half.
    for (std::uint32_t a = 0; a < 6; ++a)
        for (std::uint32_t b = 0; b < 6; ++b) {
            if (a == b) continue;
            double sum = 0;
            constexpr int kPoints = 4096;
            for (std::uint32_t n = 0; n < kPoints; ++n)
                if (even_sample(n, a, 5).x > 0.9) sum += even_sample(n, b, 5).x - 0.5;
            EXPECT_LT(std::abs(sum), 4 * 0.289 * std::sqrt(kPoints * 0.1)) << a << ' ' << b;
        }
}

}  // namespace
}  // namespace tedavis::raytrace::test_traced_light
