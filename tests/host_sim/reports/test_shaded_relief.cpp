#include "host_sim/reports/shaded_relief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "host_sim/terrain_builder/verify_database.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::host_sim::test_shaded_relief {
namespace {

using Height = std::function<float(std::uint32_t, std::uint32_t)>;

constexpr GeoExtent kInside{46.97, 47.07, 9.63, 9.73};  // of 193 x 193 posts from 47.1 N 9.6 E, 1/1200 degree apart

/// 20 x 20 pixels of terrain by a formula of column and row.
RgbaPicture relief_of(const Height& height, const GeoExtent& extent = kInside) {
    const test_support::TemporaryFolder folder;
    const std::string path = folder.file("t.tdb");
    build_terrain(test_support::posts_of(test_support::make_raster(193, 193, height)), path, {});
    const OpenDatabase open(path);
    return shaded_relief(open.database(), extent, 20, 20);
}

/// Red, green and blue added.
int brightness(const RgbaPicture& picture, std::size_t column, std::size_t row) {
    const std::uint8_t* const pixel = &picture.pixels[4 * (row * picture.width + column)];
    return pixel[0] + pixel[1] + pixel[2];
}

/// Slopes of one angle, of which the mean height is the same in the middle of the picture.
int brightness_of_slope(float east, float south) {
    const RgbaPicture picture = relief_of([=](std::uint32_t i, std::uint32_t j) {
        return 2000 + 40 * (east * (static_cast<float>(i) - 96) + south * (static_cast<float>(j) - 90));
    });
    return brightness(picture, 10, 10);
}

TEST(ShadedRelief, TheLightComesFromTheNorthWest) {
    const int to_light = brightness_of_slope(0.7f, 0.7f), to_north_east = brightness_of_slope(-0.7f, 0.7f);
    const int away = brightness_of_slope(-0.7f, -0.7f);
    EXPECT_GT(to_light, to_north_east) << "ground that rises to the south-east faces the light";
    EXPECT_GT(to_north_east, away);
}

TEST(ShadedRelief, HigherGroundIsLighterWhereItIsFlat) {
    const RgbaPicture picture = relief_of([](std::uint32_t i, std::uint32_t) { return i < 96 ? 500.0f : 2500.0f; });
    EXPECT_LT(brightness(picture, 3, 10), brightness(picture, 16, 10));
}

TEST(ShadedRelief, NorthIsUp) {
    const RgbaPicture picture = relief_of([](std::uint32_t, std::uint32_t j) { return j < 96 ? 2500.0f : 500.0f; });
    EXPECT_GT(brightness(picture, 10, 2), brightness(picture, 10, 17));
}

TEST(ShadedRelief, WhatIsNotKnownIsGrey) {
    const auto is_grey = [](const RgbaPicture& picture, std::size_t place) {
        const std::uint8_t* const pixel = &picture.pixels[4 * place];
        return pixel[0] == pixel[1] && pixel[1] == pixel[2];
    };
    const RgbaPicture outside = relief_of([](std::uint32_t, std::uint32_t) { return 700.0f; }, {40, 40.1, 9.6, 9.7});
    for (std::size_t n = 0; n < 400; ++n) EXPECT_TRUE(is_grey(outside, n)) << n;
    const RgbaPicture voids =
        relief_of([](std::uint32_t i, std::uint32_t) { return i < 96 ? 700.0f : std::numeric_limits<float>::quiet_NaN(); });
    EXPECT_FALSE(is_grey(voids, 2)) << "control";
    EXPECT_TRUE(is_grey(voids, 17));
}

}  // namespace
}  // namespace tedavis::host_sim::test_shaded_relief
