#include "host_sim/terrain_builder/attribute_baker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "host_sim/terrain_builder/height_pyramid.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_attribute_baker {
namespace {

using namespace terrain;
using test_support::BuildGround;

struct Baked {
    BuildGround ground;
    HeightPyramid pyramid;
    AttributeBaker baker;
    std::map<std::uint64_t, AttributePage> pages;  // by ChunkKey::packed()

    explicit Baked(Raster raster, bool backwards = false)
        : ground(std::move(raster)),
          pyramid(ground.folder.path(), ground.posts, ground.plan.lattice.is_closed()),
          baker(ground.plan, ground.layout, ground.coverage, pyramid, ground.store) {
        for (std::uint32_t m = 1; m < pyramid.level_count(); ++m)
            for (std::uint32_t b = 0; b < pyramid.block_count(m); ++b) pyramid.build_block(m, b);
        for (std::uint32_t n = 0; n < baker.task_count(); ++n)
            for (const BakedPage& page : baker.run(backwards ? baker.task_count() - 1 - n : n)) {
                const std::vector<std::uint8_t>& bytes = ground.store.parts.at(page.place.offset);
                EXPECT_EQ(page.place.crc, checksum(bytes.data(), bytes.size()));
                EXPECT_EQ(bytes.size(), sizeof(AttributePage));
                EXPECT_EQ(pages.count(page.chunk.packed()), 0u) << "made twice";
                std::memcpy(&pages[page.chunk.packed()], bytes.data(), sizeof(AttributePage));
            }
    }
    [[nodiscard]] const AttributePage& page(std::uint32_t level, std::uint32_t i, std::uint32_t j) const {
        return pages.at(ChunkKey{level, i, j}.packed());
    }
};

std::size_t texel(std::uint32_t i, std::uint32_t j) { return std::size_t{j} * kAttributePosts + i; }

/// East-west slope s and north-south slope t by the cell sizes of the row.
Raster plane(std::uint32_t columns, std::uint32_t rows) {
    return test_support::make_raster(columns, rows, [](auto i, auto j) { return 1000 + 5.0f * i - 10.0f * j; });
}

TEST(AttributeBaker, MakesEveryPageOnce) {
    for (const Raster& raster : {plane(300, 200), plane(1100, 40), plane(34, 34)}) {
        const Baked baked(raster);
        std::size_t expected = 0;
        for (std::uint32_t level = 1; level < baked.ground.plan.levels(); ++level)
            expected += baked.ground.plan.lattice.grid_columns(level) * baked.ground.plan.lattice.grid_rows(level);
        EXPECT_EQ(baked.pages.size(), expected);
    }
    EXPECT_EQ(Baked(plane(33, 20)).baker.task_count(), 0u) << "level 0 has no pages";
}

TEST(AttributeBaker, NormalsOfAPlaneAreItsNormalAtEveryLevel) {
    const Baked baked(plane(600, 300));
    const double north_m = base::radians(1.0 / 1200) * earth::meridian_radius_m(base::radians(47.0));
    for (std::uint32_t level = 1; level < 4; ++level) {
        const AttributePage& page = baked.page(level, 1, 1);
        const double latitude = baked.ground.plan.lattice.latitude_rad((64 + 5) << (level - 1));
        const double east_m = base::radians(1.0 / 1200) * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
        const double east = -5 / east_m, north = -10 / north_m, length = std::sqrt(1 + east * east + north * north);
        EXPECT_NEAR(decode_signed(page.form[texel(10, 5)][0]), east / length, 0.006) << level;
        EXPECT_NEAR(decode_signed(page.form[texel(10, 5)][1]), north / length, 0.006) << level;
        EXPECT_NEAR(decode_signed_root(page.form[texel(10, 5)][3]), 0, 0.001) << level;
    }
}

TEST(AttributeBaker, NeighbouringPagesShareTheirLastTexels) {
    const Baked baked(test_support::make_rough_raster(600, 300));
    for (std::uint32_t level = 1; level < 4; ++level)
        for (std::uint32_t n = 0; n < kAttributePosts; ++n) {
            const AttributePage &west = baked.page(level, 0, 0), &east = baked.page(level, 1, 0);
            for (int byte = 0; byte < 4; ++byte) {
                ASSERT_EQ(west.form[texel(64, n)][byte], east.form[texel(0, n)][byte]) << level;
                ASSERT_EQ(west.light[texel(64, n)][byte], east.light[texel(0, n)][byte]) << level;
                ASSERT_EQ(west.aperture[texel(64, n)][byte], east.aperture[texel(0, n)][byte]) << level;
            }
            for (int k = 0; k < kHorizonDirections; ++k)
                ASSERT_EQ(west.horizon[k][n / 2 * kHorizonPosts + 32], east.horizon[k][n / 2 * kHorizonPosts]) << level;
        }
}

TEST(AttributeBaker, TheOrderOfTasksDoesNotMatter) {
    const Baked forward(test_support::make_rough_raster(1100, 300)), backward(test_support::make_rough_raster(1100, 300), true);
    ASSERT_GT(forward.baker.task_count(), 2u);
    EXPECT_EQ(forward.ground.store.parts, backward.ground.store.parts);
}

TEST(AttributeBaker, AWallIsAHorizonFarAway) {
    // 2000 m high, 200 cells (18 km) east of the texel: far beyond the reach of a tile.
    const Baked baked(test_support::make_raster(600, 200, [](auto i, auto) { return i > 300 && i < 500 ? 2000.0f : 0.0f; }));
    const AttributePage& page = baked.page(1, 1, 1);
    const std::uint32_t i = 36 / 2, j = 20 / 2;  // post 64 + 36 = 100
    const double latitude = baked.ground.plan.lattice.latitude_rad(84);
    const double east_m = base::radians(1.0 / 1200) * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
    const double distance_m = 201 * east_m;
    const double sine = std::sin(std::atan(2000 / distance_m - distance_m / (2 * 6371000)));
    EXPECT_NEAR(decode_horizon_sine(page.horizon[4][j * kHorizonPosts + i]), sine, 0.15 * sine) << "east";
    EXPECT_LT(decode_horizon_sine(page.horizon[12][j * kHorizonPosts + i]), 1e-3) << "west";
}

TEST(AttributeBaker, ClassesAreTheRasters) {
    Raster raster = test_support::make_rough_raster(200, 150);
    for (std::uint32_t j = 10; j < 50; ++j)
        for (std::uint32_t i = 20; i < 60; ++i) raster.post_class[raster.at(i, j)] = i < 40 ? PostClass::void_ : PostClass::sea;
    const Baked baked(raster);
    const AttributePage& page = baked.page(1, 0, 0);
    for (std::uint32_t j = 0; j < kAttributePosts; ++j)
        for (std::uint32_t i = 0; i < kAttributePosts; ++i)
            ASSERT_EQ(class_of_code(page.light[texel(i, j)][3]), raster.post_class[raster.at(i, j)]);
    EXPECT_EQ(class_of_code(baked.page(2, 0, 0).light[texel(15, 15)][3]), PostClass::void_);
    EXPECT_EQ(class_of_code(baked.page(2, 0, 0).light[texel(25, 15)][3]), PostClass::sea);
}

TEST(AttributeBaker, BeyondTheLatticeTheLastPostIsRepeated) {
    const Baked baked(plane(100, 80));
    const AttributePage& page = baked.page(1, 1, 1);  // posts 64..99 and 64..79
    for (int byte = 0; byte < 4; ++byte) {
        EXPECT_EQ(page.form[texel(64, 5)][byte], page.form[texel(35, 5)][byte]);
        EXPECT_EQ(page.form[texel(7, 64)][byte], page.form[texel(7, 15)][byte]);
    }
}

TEST(AttributeBaker, GoesRoundTheEarthAndOverThePoles) {
    const Baked baked(test_support::make_earth_raster(1));
    const std::uint32_t last = baked.ground.plan.lattice.grid_columns(1) - 1;
    const std::uint32_t end = baked.ground.plan.header.columns - 1 - 64 * last;
    for (std::uint32_t n = 0; n < kAttributePosts; ++n)
        for (int byte = 0; byte < 4; ++byte)
            ASSERT_EQ(baked.page(1, last, 1).form[texel(end, n)][byte], baked.page(1, 0, 1).form[texel(0, n)][byte]);
    EXPECT_EQ(baked.pages.size(), 6u * 3 + 3 * 2 + 2 * 1 + 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_attribute_baker
