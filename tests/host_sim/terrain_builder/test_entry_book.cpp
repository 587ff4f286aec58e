#include "host_sim/terrain_builder/entry_book.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_entry_book {
namespace {

using namespace terrain;
using test_support::BuildGround;

ChunkEntry entry_of(const ChunkKey& key, std::uint16_t vertices) {
    ChunkEntry entry{};
    entry.level = static_cast<std::uint8_t>(key.level);
    entry.i = key.i;
    entry.j = key.j;
    entry.vertex_count = vertices;
    return entry;
}

struct Book {
    BuildGround ground{test_support::make_rough_raster(150, 110)};
    BuildPlan fine;
    InsetCoverage coverage;
    EntriesFile coarse{ground.folder.file("coarse"), ground.plan.lattice},
        changed{ground.folder.file("changed"), ground.plan.lattice};
    EntryBook book{coverage, coarse, changed};

    explicit Book(std::uint32_t levels) : fine(make_finer_plan(ground.plan, levels)) {
        if (levels == 0) return;
        coverage = InsetCoverage(fine.lattice, levels, {{480, 400, 560, 500}});
        for (const PostRange& region : coverage.regions())
            book.add(std::make_unique<RegionEntries>(ground.folder.file("region"), region, levels));
    }
};

TEST(EntryBook, WithoutInsetsKeysAreTheLattices) {
    Book made(0);
    made.coarse.write(entry_of({1, 1, 0}, 7));
    EXPECT_EQ(made.book.read({1, 1, 0}).vertex_count, 7);
    made.book.write(entry_of({1, 1, 0}, 9));
    EXPECT_EQ(made.book.read({1, 1, 0}).vertex_count, 9);
    EXPECT_EQ(made.coarse.read({1, 1, 0}).vertex_count, 7) << "what was made first stays";
}

TEST(EntryBook, CoarseLevelsAreCountedFromTheBaseLevel) {
    Book made(3);
    made.coarse.write(entry_of({1, 2, 1}, 7));
    const ChunkEntry read = made.book.read({4, 2, 1});
    EXPECT_EQ(read.vertex_count, 7);
    EXPECT_EQ(key_of(read), (ChunkKey{4, 2, 1}));
    made.book.write(read);
    EXPECT_EQ(made.changed.read({1, 2, 1}).level, 1);
}

TEST(EntryBook, FineEntriesHavePlacesOfTheirOwn) {
    Book made(3);
    std::uint16_t n = 0;
    std::vector<ChunkKey> keys;
    for (std::uint32_t level = 0; level < 3; ++level)
        for (std::uint32_t j = 0; j < made.fine.lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < made.fine.lattice.grid_columns(level); ++i)
                if (made.coverage.exists({level, i, j})) keys.push_back({level, i, j});
    ASSERT_GT(keys.size(), 20u);
    for (const ChunkKey& key : keys) EXPECT_EQ(made.book.read(key).vertex_count, 0);
    for (const ChunkKey& key : keys) made.book.write(entry_of(key, ++n));
    n = 0;
    for (const ChunkKey& key : keys) EXPECT_EQ(made.book.read(key).vertex_count, ++n);
    EXPECT_EQ(made.book.read({0, 0, 0}).vertex_count, 0) << "outside every region";
}

}  // namespace
}  // namespace tedavis::host_sim::test_entry_book
