#include "render_core/raytrace/height_mipmap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "platform/threads/thread_workers.hpp"

namespace tedavis::raytrace::test_height_mipmap {
namespace {

template <class Height>
struct Bounded {
    Bounded(std::uint32_t columns, std::uint32_t rows, HeightBound bound, std::uint32_t gap = 0) : mipmap(bound) {
        std::mt19937 random(columns * 31 + rows);
        const std::uint32_t stride = columns + gap;
        posts.resize(std::size_t{stride} * rows);
        for (Height& post : posts) post = static_cast<Height>(static_cast<int>(random() % 60000) - 30000);
        memory.resize(HeightMipmap<Height>::bytes_needed(columns, rows) / 8 + 1);
        base::Arena arena(memory.data(), memory.size() * 8);
        EXPECT_TRUE(mipmap.start({posts.data(), columns, rows, stride}, arena));
    }
    void build() {
        base::SerialWorkers workers;
        mipmap.build(workers);
    }
    [[nodiscard]] std::vector<Height> nodes() const {
        std::vector<Height> all;
        for (std::uint32_t n = 0; n < mipmap.levels(); ++n) {
            const MipmapLevel<Height> level = mipmap.level(n);
            all.insert(all.end(), level.nodes, level.nodes + std::size_t{level.columns} * level.rows);
        }
        return all;
    }

    std::vector<Height> posts;
    std::vector<std::uint64_t> memory;
    HeightMipmap<Height> mipmap;
};

/// Of all cells of a node that have a surface, by looking at each of their posts.
template <class Height>
Height by_looking(const HeightGrid<Height>& grid, HeightBound bound, std::uint32_t level, std::uint32_t column,
                  std::uint32_t row) {
    Height most = bound == HeightBound::maximum ? std::numeric_limits<Height>::lowest() : std::numeric_limits<Height>::max();
    const std::uint32_t right = std::min((column + 1) << level, grid.columns - 1);
    const std::uint32_t bottom = std::min((row + 1) << level, grid.rows - 1);
    for (std::uint32_t r = row << level; r < bottom; ++r)
        for (std::uint32_t c = column << level; c < right; ++c) {
            const Height posts[] = {grid.at(c, r), grid.at(c + 1, r), grid.at(c, r + 1), grid.at(c + 1, r + 1)};
            if (std::count(std::begin(posts), std::end(posts), HeightGrid<Height>::kVoid) > 0) continue;
            for (const Height post : posts) most = bound == HeightBound::maximum ? std::max(most, post) : std::min(most, post);
        }
    return most;
}

template <class Height>
std::size_t wrong_nodes(const HeightMipmap<Height>& mipmap) {
    std::size_t wrong = 0;
    for (std::uint32_t n = 0; n < mipmap.levels(); ++n) {
        const MipmapLevel<Height> level = mipmap.level(n);
        for (std::uint32_t row = 0; row < level.rows; ++row)
            for (std::uint32_t column = 0; column < level.columns; ++column)
                if (level.at(column, row) != by_looking(mipmap.grid(), mipmap.bound(), n, column, row)) ++wrong;
    }
    return wrong;
}

constexpr std::uint32_t kSides[] = {2, 3, 4, 5, 6, 17, 64, 65, 66, 129, 200};

TEST(HeightMipmap, BoundsEveryNodeOfEverySize) {
    for (const std::uint32_t columns : kSides)
        for (const std::uint32_t rows : kSides) {
            Bounded<std::int16_t> highest(columns, rows, HeightBound::maximum), lowest(columns, rows, HeightBound::minimum, 3);
            highest.build();
            lowest.build();
            ASSERT_EQ(wrong_nodes(highest.mipmap), 0u) << columns << " x " << rows;
            ASSERT_EQ(wrong_nodes(lowest.mipmap), 0u) << columns << " x " << rows;
            const MipmapLevel<std::int16_t> top = highest.mipmap.level(highest.mipmap.levels() - 1);
            ASSERT_EQ(top.columns * top.rows, 1u);
        }
}

TEST(HeightMipmap, TheCheckFindsANodeThatLosesARow) {
    Bounded<std::int16_t> ground(200, 101, HeightBound::maximum);
    ground.build();
    const MipmapLevel<std::int16_t> level = ground.mipmap.level(3);
    const_cast<std::int16_t*>(level.nodes)[level.columns] = -32767;
    EXPECT_EQ(wrong_nodes(ground.mipmap), 1u);
}

TEST(HeightMipmap, CellsWithoutHeightsBoundNothing) {
    for (const HeightBound bound : {HeightBound::maximum, HeightBound::minimum}) {
        Bounded<float> ground(70, 40, bound);
        for (std::size_t n = 0; n < ground.posts.size(); n += 7) ground.posts[n] = HeightGrid<float>::kVoid;
        for (std::size_t n = 0; n < 70 * 9; ++n) ground.posts[n] = HeightGrid<float>::kVoid;
        ground.build();
        EXPECT_EQ(wrong_nodes(ground.mipmap), 0u);
    }
}

TEST(HeightMipmap, AnUpdateGivesWhatBuildingAnewWould) {
    std::mt19937 random(5);
    Bounded<std::int16_t> ground(150, 133, HeightBound::maximum);
    ground.build();
    for (int round = 0; round < 60; ++round) {
        PostRegion changed;
        changed.first_column = static_cast<std::uint32_t>(random() % 150);
        changed.first_row = static_cast<std::uint32_t>(random() % 133);
        changed.end_column = std::min(changed.first_column + static_cast<std::uint32_t>(random() % 20), 150u);
        changed.end_row = std::min(changed.first_row + static_cast<std::uint32_t>(random() % 20), 133u);
        for (std::uint32_t r = changed.first_row; r < changed.end_row; ++r)
            for (std::uint32_t c = changed.first_column; c < changed.end_column; ++c)
                ground.posts[r * 150 + c] = static_cast<std::int16_t>(random() % 5 == 0 ? -32768 : random() % 40000 - 20000);
        ground.mipmap.update(changed);
        const std::vector<std::int16_t> updated = ground.nodes();
        ground.build();
        ASSERT_EQ(updated, ground.nodes()) << round;
    }
}

TEST(HeightMipmap, IsTheSameForEveryNumberOfWorkers) {
    Bounded<std::int16_t> ground(1003, 771, HeightBound::maximum);
    ground.build();
    const std::vector<std::int16_t> serial = ground.nodes();
    for (const std::uint32_t threads : {2u, 3u, 7u}) {
        const auto workers = platform::make_thread_workers({threads, nullptr});
        std::fill(ground.memory.begin(), ground.memory.end(), 0);
        ground.mipmap.build(*workers.value());
        EXPECT_EQ(ground.nodes(), serial) << threads;
    }
}

TEST(HeightMipmap, KeepsToItsMemoryAndRefusesLess) {
    std::vector<std::int16_t> posts(33 * 20);
    const HeightGrid<std::int16_t> grid{posts.data(), 33, 20, 33};
    const std::uint64_t bytes = HeightMipmap<std::int16_t>::bytes_needed(33, 20);
    std::vector<std::uint64_t> memory(bytes / 8 + 1);
    base::Arena enough(memory.data(), bytes), less(memory.data(), bytes - 8);
    HeightMipmap<std::int16_t> mipmap;
    EXPECT_FALSE(mipmap.start(grid, less));
    EXPECT_TRUE(mipmap.start(grid, enough));
    EXPECT_LT(static_cast<double>(HeightMipmap<std::int16_t>::bytes_needed(4096, 4096)) / (4096.0 * 4096.0) + 2, 5);
}

}  // namespace
}  // namespace tedavis::raytrace::test_height_mipmap
