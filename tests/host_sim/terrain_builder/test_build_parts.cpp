#include "host_sim/terrain_builder/build_parts.hpp"

#include <gtest/gtest.h>

#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::host_sim::test_build_parts {
namespace {

using namespace terrain;

TEST(BuildParts, OpenPartsFollowEachOtherAlignedAndAreReadBack) {
    const Raster raster = test_support::make_rough_raster(80, 70);
    const TerrainSources sources(test_support::posts_of(raster));
    const test_support::TemporaryFolder folder;
    BuildParts parts(sources, folder.file("w"), {});
    EXPECT_EQ(parts.record.end, parts.layout.open_parts);
    const std::uint8_t bytes[] = {1, 2, 3, 4, 5};
    const PartPlace place{0, 5, checksum(bytes, 5)};
    const std::uint64_t first = parts.append(ChunkPart::irregular, {1, 0, 0}, place, {bytes, 5}),
                        second = parts.append(ChunkPart::attributes, {1, 0, 0}, place, {bytes, 5});
    EXPECT_EQ(first, parts.layout.open_parts);
    EXPECT_EQ(second, first + 8);
    std::uint8_t read[5];
    parts.store.get({second, 5, 0}, read);
    EXPECT_EQ(read[4], 5);
}

TEST(BuildParts, AFolderIsTakenOverByAnEqualBuildOnly) {
    const Raster raster = test_support::make_rough_raster(80, 70), other = test_support::make_rough_raster(80, 71);
    const TerrainSources sources(test_support::posts_of(raster)), others(test_support::posts_of(other));
    const test_support::TemporaryFolder folder;
    BuildOptions options;
    options.identity = "a";
    {
        BuildParts parts(sources, folder.file("w"), options);
        parts.record.stage = 3;
        parts.sync();
        parts.journal.append(parts.record);
    }
    EXPECT_EQ(BuildParts(sources, folder.file("w"), options).record.stage, 3u);
    EXPECT_EQ(BuildParts(others, folder.file("w"), options).record.stage, 0u);
    {
        BuildParts parts(sources, folder.file("w"), options);
        parts.record.stage = 3;
        parts.journal.append(parts.record);
    }
    options.identity = "b";
    EXPECT_EQ(BuildParts(sources, folder.file("w"), options).record.stage, 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_build_parts
