#include "render_core/raytrace/picture/stored_surface.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace {
namespace {

SurfaceSettings stored_settings(bool has_noise) {
    SurfaceSettings settings;
    settings.kind = SurfaceKind::approximate_bicubic;
    settings.subdivisions = 4;
    settings.micro.kind = has_noise ? MicroKind::noise : MicroKind::none;
    settings.micro.noise.amplitude = 12;
    return settings;
}

class StoredSurfaceTest : public ::testing::Test {
protected:
    StoredSurfaceTest() : heights_(test_support::hilly_heights<std::int16_t>(40, 30, 9)) { heights_.at(10, 12) = kHole; }
    static constexpr std::int16_t kHole = HeightGrid<std::int16_t>::kVoid;

    void store(const SurfaceSettings& settings) {
        memory_.resize(StoredSurface<std::int16_t>::bytes_needed(heights_.grid(), settings.subdivisions) + 16);
        base::Arena arena(memory_.data(), memory_.size());
        ASSERT_TRUE(stored_.start(heights_.grid(), settings, arena));
        base::SerialWorkers alone;
        stored_.build(alone);
    }
    test_support::HeldHeights<std::int16_t> heights_;
    std::vector<unsigned char> memory_;
    StoredSurface<std::int16_t> stored_;
};

TEST_F(StoredSurfaceTest, IsTheApproachedBicubicSurfaceEverywhere) {
    const SurfaceSettings settings = stored_settings(false);
    store(settings);
    SurfaceSettings flat;
    flat.kind = SurfaceKind::bilinear;
    test_support::Dice dice(4);
    for (int n = 0; n < 20000; ++n) {
        const double x = dice.between(0, 39), y = dice.between(0, 29);
        SurfacePoint right, found;
        const bool is_there = find_surface(heights_.grid(), settings, x, y, right);
        ASSERT_EQ(find_surface(stored_.grid(), flat, x * 4, y * 4, found), is_there) << x << " " << y;
        if (is_there) {
            EXPECT_NEAR(found.height, right.height, 1e-4);
        }
    }
}

TEST_F(StoredSurfaceTest, HasTheMicroStructureAtItsPosts) {
    const SurfaceSettings settings = stored_settings(true);
    store(settings);
    std::uint32_t moved = 0;
    for (std::uint32_t row = 0; row < stored_.grid().rows; ++row)
        for (std::uint32_t column = 0; column < stored_.grid().columns; ++column) {
            SurfacePoint right;
            if (!find_surface(heights_.grid(), settings, column / 4.0, row / 4.0, right)) continue;
            ASSERT_NEAR(stored_.grid().at(column, row), right.height, 1e-4);
            moved += std::abs(noise_at(settings.micro.noise, column / 4.0, row / 4.0).height) > 1 ? 1 : 0;
        }
    EXPECT_GT(moved, 5000U);
}

TEST_F(StoredSurfaceTest, TooManyPostsAndTooLittleMemoryAreRefused) {
    HeightGrid<std::int16_t> large = heights_.grid();
    large.columns = large.stride = 40000;
    large.rows = 20000;
    EXPECT_EQ(StoredSurface<std::int16_t>::bytes_needed(large, 4), 0U);
    base::Arena none(memory_.data(), 0);
    StoredSurface<std::int16_t> refused;
    EXPECT_FALSE(refused.start(large, stored_settings(false), none));
    EXPECT_FALSE(refused.start(heights_.grid(), stored_settings(false), none));
}

}  // namespace
}  // namespace tedavis::raytrace
