#include "host_sim/terrain_builder/fine_unit.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_fine_unit {
namespace {

using namespace terrain;
using test_support::BuildGround;

TEST(FineUnit, MakesEveryChunkOfItsDomainOnce) {
    BuildGround ground(test_support::make_rough_raster(1100, 70));
    ASSERT_EQ(ground.plan.unit_count(), 2u);
    std::set<std::uint64_t> seen;
    for (std::uint32_t unit = 0; unit < 2; ++unit) {
        const FineUnit made = build_fine_unit(ground.sources, unit);
        for (const ChunkEntry& entry : made.regular) {
            EXPECT_TRUE(seen.insert(key_of(entry).packed()).second);
            EXPECT_EQ(entry.i / 32, unit);
            EXPECT_EQ(entry.payload.crc, checksum(ground.store.parts.at(entry.payload.offset).data(), entry.payload.bytes));
        }
        for (const IrregularChunk& chunk : made.irregular) {
            EXPECT_TRUE(seen.insert(key_of(chunk.entry).packed()).second);
            EXPECT_EQ(chunk.entry.i >> (kUnitLevel - chunk.entry.level), unit);
            EXPECT_EQ(chunk.entry.payload.bytes, chunk.payload.size());
            EXPECT_EQ(chunk.entry.payload.crc, checksum(chunk.payload.data(), chunk.payload.size()));
            EXPECT_NE(chunk.entry.children, 0);
        }
    }
    std::size_t expected = 0;
    for (std::uint32_t level = 0; level <= kUnitLevel; ++level)
        expected += ground.plan.lattice.grid_columns(level) * ground.plan.lattice.grid_rows(level);
    EXPECT_EQ(seen.size(), expected);
}

/// A unit knows nothing of its neighbours but the posts beside it: what they have farther away does not matter.
TEST(FineUnit, DependsOnlyOnWhatIsBesideIt) {
    Raster changed = test_support::make_rough_raster(1100, 40);
    BuildGround first(changed);
    for (std::uint32_t j = 0; j < 40; ++j)
        for (std::uint32_t i = 1060; i < 1100; ++i) changed.height_m[changed.at(i, j)] += 100;
    BuildGround second(changed);
    const FineUnit a = build_fine_unit(first.sources, 0), b = build_fine_unit(second.sources, 0);
    ASSERT_EQ(a.irregular.size(), b.irregular.size());
    int equal = 0;
    for (std::size_t n = 0; n < a.irregular.size(); ++n) equal += a.irregular[n].payload == b.irregular[n].payload ? 1 : 0;
    EXPECT_GT(equal, static_cast<int>(a.irregular.size()) - 4) << "border lines of high levels reach farther";
    EXPECT_EQ(first.store.parts.begin()->second, second.store.parts.begin()->second);
}

TEST(FineUnit, ATerrainOfOneChunkIsRegular) {
    BuildGround ground(test_support::make_rough_raster(20, 33));
    const FineUnit made = build_fine_unit(ground.sources, 0);
    EXPECT_EQ(made.regular.size(), 1u);
    EXPECT_TRUE(made.irregular.empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_fine_unit
