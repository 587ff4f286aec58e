#include "render_core/raytrace/search/undersampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_core/raytrace/search/row_start.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_undersampling {
namespace {

struct HeldPicture {
    std::vector<glm::vec3> pixels;
    std::vector<std::uint8_t> traced;
    UndersampledPicture picture;
    HeldPicture(std::uint32_t width, std::uint32_t height) : pixels(width * height, glm::vec3(-1)), traced(width * height) {
        picture = {pixels, traced, width, height};
    }
    [[nodiscard]] undersampling::Square whole() const { return {0, 0, picture.width - 1, picture.height - 1}; }
};

glm::vec3 disc(std::uint32_t x, std::uint32_t y) {
    const float d = std::hypot(static_cast<float>(x) - 50, static_cast<float>(y) - 40);
    return d < 25 ? glm::vec3(0.9f, 0.2f, 0.1f) : glm::vec3(0.1f + 0.0005f * static_cast<float>(x), 0.2f, 0.3f);
}

TEST(Undersampling, FillsEveryPixelOfEverySize) {
    for (const auto& [width, height] :
         {std::pair(1u, 1u), std::pair(2u, 1u), std::pair(9u, 9u), std::pair(101u, 83u), std::pair(64u, 1u)})
        for (const std::uint32_t square : {1u, 2u, 7u, 8u, 64u}) {
            HeldPicture held(width, height);
            Undersampling settings;
            settings.square = square;
            const std::uint64_t rays = undersample(held.picture, held.whole(), settings, disc);
            std::uint64_t counted = 0;
            for (const std::uint8_t traced : held.traced) counted += traced;
            EXPECT_EQ(rays, counted);
            for (const glm::vec3& pixel : held.pixels) ASSERT_GE(pixel.x, 0) << width << ' ' << height << ' ' << square;
        }
}

TEST(Undersampling, ALargeThingIsDrawnFromAFractionOfTheRays) {
    HeldPicture held(101, 83);
    const std::uint64_t rays = undersample(held.picture, held.whole(), {}, disc);
    EXPECT_LT(rays, 101 * 83 / 3);
    int off = 0;
    for (std::uint32_t y = 0; y < 83; ++y)
        for (std::uint32_t x = 0; x < 101; ++x) off += std::abs(held.pixels[y * 101 + x].x - disc(x, y).x) > 0.05f ? 1 : 0;
    EXPECT_LT(off, 30);
}

TEST(Undersampling, TracesAllWhereItIsToldTo) {
    for (const Undersampling& settings : {Undersampling{1, 1.f}, Undersampling{8, -1.f}}) {
        HeldPicture held(33, 21);
        EXPECT_EQ(undersample(held.picture, held.whole(), settings, disc), 33u * 21u);
        for (std::uint32_t n = 0; n < 33 * 21; ++n) EXPECT_EQ(held.pixels[n], disc(n % 33, n / 33));
    }
}

TEST(Undersampling, LosesWhatNoCornerMeets) {
    const auto needle = [](std::uint32_t x, std::uint32_t y) { return glm::vec3(x == 11 && y > 2 && y < 7 ? 1 : 0); };
    HeldPicture held(33, 33);
    undersample(held.picture, held.whole(), {8, 0.01f}, needle);
    EXPECT_EQ(held.pixels[5 * 33 + 11].x, 0);
    HeldPicture fine(33, 33);
    undersample(fine.picture, fine.whole(), {1, 0.01f}, needle);
    EXPECT_EQ(fine.pixels[5 * 33 + 11].x, 1);
}

/// Rays of a column of pixels from the lowest up; how many do not meet what they would from the eye.
int lost_by_row_start(const test_support::SurfaceScene<std::int16_t>& scene, double share) {
    int lost = 0;
    for (int column = -40; column <= 40; ++column) {
        double ways[1] = {0};
        for (int line = 0; line < 120; ++line) {
            Ray ray{{2, 64, 45},
                    {1, 0.01f * static_cast<float>(column) + 0.0003f * static_cast<float>(line),
                     -0.8f + 0.008f * static_cast<float>(line)}};
            const SurfaceHit exact = scene.trace(ray);
            ray.from = row_start(ray, ways, {share});
            const SurfaceHit found = scene.trace(ray);
            lost += found.t != exact.t && std::abs(found.t - exact.t) > 1e-9 ? 1 : 0;
            ways[0] = found.side == HitSide::none ? std::numeric_limits<double>::infinity() : distance_over_ground(ray, found.t);
        }
    }
    return lost;
}

TEST(RowStart, MostlyHoldsOverHillsAndLosesNeedles) {
    auto heights = test_support::hilly_heights<std::int16_t>(129, 129, 4, 40);
    const test_support::SurfaceScene<std::int16_t> hills(heights, SurfaceKind::bilinear);
    for (std::uint32_t n = 0; n < 129 * 129; n += 37) heights.posts[n] = 44;
    const test_support::SurfaceScene<std::int16_t> needles(heights, SurfaceKind::bilinear);
    EXPECT_LT(lost_by_row_start(hills, 1), 81 * 120 / 20);
    EXPECT_GT(lost_by_row_start(needles, 1), lost_by_row_start(hills, 1));
    EXPECT_LE(lost_by_row_start(needles, 0.5), lost_by_row_start(needles, 1));
    EXPECT_EQ(lost_by_row_start(needles, 0), 0);
}

TEST(RowStart, SaysNothingWhereNothingWasMet) {
    Ray ray{{0, 0, 0}, {3, 4, 0}, 2, 100};
    const double none[] = {std::numeric_limits<double>::infinity()}, some[] = {50, 30};
    EXPECT_EQ(row_start(ray, none, {}), 2);
    EXPECT_EQ(row_start(ray, {}, {}), 2);
    EXPECT_EQ(row_start(ray, some, {}), 6);
    EXPECT_EQ(row_start(ray, some, {0.1}), 2);
    EXPECT_EQ(row_start({{0, 0, 0}, {0, 0, 1}}, some, {}), 0);
}

}  // namespace
}  // namespace tedavis::raytrace::test_undersampling
