#include "host_sim/terrain_builder/drape_baker.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/quiet_gdal.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/support/files/image_file.hpp"

namespace tedavis::host_sim::test_drape_baker {
namespace {

using namespace terrain;
using test_support::BuildGround;
using test_support::ImageFile;
using test_support::Rgba;

constexpr std::uint32_t kSteps = kDrapePosts - 1;

/// All pages of a drape, kept as a build keeps them.
struct Draped {
    BuildGround ground;
    std::uint64_t end = 1;
    std::map<std::uint64_t, PartPlace> places;  // by ChunkKey::packed()
    DrapeBaker baker;

    Draped(std::uint32_t columns, std::uint32_t rows, const ImageFile& image, std::uint32_t base_level = 0)
        : ground(test_support::make_raster(columns, rows, [](auto, auto) { return 500.0f; })),
          baker(ground.plan, base_level, {image.write(ground.folder.file("i.tif")), {}, {}}, ground.store,
                [this](const ChunkKey& key) { return places.count(key.packed()) != 0 ? places.at(key.packed()) : PartPlace{}; }) {
        for (std::uint32_t level = baker.first_level(); level < baker.end_level(); ++level)
            for (std::uint32_t task = 0; task < baker.task_count(level); ++task) keep(baker.run(level, task));
    }
    void keep(const std::optional<BakedPage>& page) {
        if (!page) return;
        EXPECT_EQ(page->place.crc, checksum(page->bytes.data(), page->bytes.size()));
        PartPlace place = page->place;
        place.offset = end;
        end += place.bytes;
        ground.store.put(ChunkPart::drape, page->chunk, place, {page->bytes.data(), page->bytes.size()});
        EXPECT_EQ(places.count(page->chunk.packed()), 0u) << "made twice";
        places[page->chunk.packed()] = place;
    }
    [[nodiscard]] bool has(const ChunkKey& key) const { return places.count(key.packed()) != 0; }
    /// Of a level, by its place in the whole level.
    [[nodiscard]] Rgba texel(std::uint32_t level, std::uint32_t x, std::uint32_t y) const {
        const ChunkKey key{level, x / kSteps, y / kSteps};
        const std::uint8_t* p =
            &ground.store.parts.at(places.at(key.packed()).offset)[4 * (std::size_t{y % kSteps} * kDrapePosts + x % kSteps)];
        return {p[0], p[1], p[2], p[3]};
    }

    QuietGdal quiet_;
};

/// Pixels a quarter post wide over posts -5..columns+5.
ImageFile fine_image(int columns, int rows) {
    ImageFile image;
    const double pixel = 0.25 / 1200;
    image.transform = {9.6 - 5.0 / 1200, pixel, 0, 47.1 + 5.0 / 1200, 0, -pixel};
    image.columns = 4 * (columns + 10);
    image.rows = 4 * (rows + 10);
    return image;
}

TEST(DrapeBaker, EveryChunkFromTheFinestLevelUpHasAPage) {
    const Draped draped(150, 80, fine_image(150, 80));
    ASSERT_EQ(draped.baker.first_level(), 0u);
    for (std::uint32_t level = 0; level < draped.baker.end_level(); ++level)
        for (std::uint32_t j = 0; j < draped.ground.plan.lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < draped.ground.plan.lattice.grid_columns(level); ++i)
                EXPECT_TRUE(draped.has({level, i, j})) << level << "/" << i << "/" << j;
}

TEST(DrapeBaker, ATexelIsTheMeanOfThoseOfTheImageRoundIt) {
    ImageFile image = fine_image(150, 80);
    image.color = test_support::wavy(40);
    const Draped draped(150, 80, image);
    // Repeated (1 2 1) / 4 is a bell whose variance adds up: (4^level - 1) / 6 texels of level 0, each way. Of a wave it leaves
    // exp(-variance * k^2 / 2), so that the mean is known in advance.
    for (const std::uint32_t level : {1u, 2u}) {
        const std::uint32_t step = 1u << level;
        const double variance = (std::pow(4.0, level) - 1) / 6;
        const double k = 6.283185307 / 40;
        int compared = 0;
        for (std::uint32_t y = 20; y < 300 / step; y += 3)
            for (std::uint32_t x = 20; x < 560 / step; x += 3) {
                const double i = 20 + x * step - 0.5, j = 20 + y * step - 0.5;  // pixels: the image begins 5 posts before
                const double wave = std::sin(k * (i + 0.3 * j)) * std::exp(-0.5 * variance * k * k * (1 + 0.09));
                ASSERT_NEAR(draped.texel(level, x, y)[0], 127.5 + 120 * wave, 2.5) << level << " at " << x << ", " << y;
                ++compared;
            }
        EXPECT_GT(compared, 500);
    }
}

TEST(DrapeBaker, NeighbouringPagesShareTheirLastTexels) {
    ImageFile image = fine_image(150, 80);
    image.color = test_support::wavy(11);
    const Draped draped(150, 80, image);
    for (const std::uint32_t level : {0u, 1u}) {
        const auto page = [&](std::uint32_t i, std::uint32_t j) -> const std::vector<std::uint8_t>& {
            return draped.ground.store.parts.at(draped.places.at(ChunkKey{level, i, j}.packed()).offset);
        };
        for (std::uint32_t n = 0; n < kDrapePosts; ++n)
            for (std::size_t c = 0; c < 4; ++c) {
                ASSERT_EQ(page(0, 0)[4 * (std::size_t{n} * kDrapePosts + kSteps) + c],
                          page(1, 0)[4 * (std::size_t{n} * kDrapePosts) + c]);
                ASSERT_EQ(page(0, 0)[4 * (std::size_t{kSteps} * kDrapePosts + n) + c], page(0, 1)[4 * std::size_t{n} + c]);
            }
    }
}

TEST(DrapeBaker, ChunksOfWhichTheImageHasNothingHaveNoPage) {
    ImageFile image = fine_image(30, 30);  // of 150 by 80 posts
    const Draped draped(150, 80, image);
    EXPECT_TRUE(draped.has({0, 0, 0}));
    EXPECT_TRUE(draped.has({0, 1, 0})) << "up to post 35";
    EXPECT_FALSE(draped.has({0, 2, 0}));
    EXPECT_FALSE(draped.has({1, 1, 0}));
    EXPECT_TRUE(draped.has({draped.baker.end_level() - 1, 0, 0}));
    EXPECT_EQ(draped.texel(1, 100, 10)[3], 0) << "beside the image";
    EXPECT_EQ(draped.texel(1, 10, 10)[3], 255);
}

TEST(DrapeBaker, LevelsAreTheDatabases) {
    const Draped draped(150, 80, fine_image(150, 80), 2);
    EXPECT_EQ(draped.baker.first_level(), 0u) << "of the coarse posts";
    EXPECT_TRUE(draped.has({2, 0, 0}));
    EXPECT_FALSE(draped.has({0, 0, 0}));
    EXPECT_TRUE(draped.has({1 + draped.ground.plan.levels(), 0, 0}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_drape_baker
