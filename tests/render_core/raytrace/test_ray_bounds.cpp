// Bounds of the mipmap for sizes at which halving goes wrong (NUMERICS A24, finding 8), against all cells one by one.
#include <gtest/gtest.h>

#include <cmath>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace::test_ray_bounds {
namespace {

using test_support::HeightField;
using test_support::mixed_bits;

template <class Height>
class Bounds {
public:
    Bounds(const HeightField<Height>& field, HeightBound bound) : mipmap(bound) {
        memory_.resize(HeightMipmap<Height>::bytes_needed(field.columns, field.rows) / 8 + 1);
        base::Arena arena(memory_.data(), memory_.size() * 8);
        EXPECT_TRUE(mipmap.start(field.grid(), arena));
    }
    HeightMipmap<Height> mipmap;

private:
    std::vector<std::uint64_t> memory_;
};

/// Any heights, also the least and the greatest that there are, voids among them.
template <class Height>
HeightField<Height> wild_field(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed) {
    HeightField<Height> field(columns, rows);
    for (std::uint32_t n = 0; n < field.posts.size(); ++n) {
        const std::uint32_t bits = mixed_bits(n ^ mixed_bits(seed));
        field.posts[n] = bits % 997 == 0 ? HeightGrid<Height>::kVoid : static_cast<Height>(static_cast<std::int16_t>(bits >> 16));
    }
    return field;
}

/// What bounds a cell; nothing where a post is void.
template <class Height>
bool cell_bound(const HeightGrid<Height>& grid, std::uint32_t column, std::uint32_t row, HeightBound bound, Height& value) {
    const Height posts[4] = {grid.at(column, row), grid.at(column + 1, row), grid.at(column, row + 1),
                             grid.at(column + 1, row + 1)};
    value = posts[0];
    for (const Height post : posts) {
        if (post == HeightGrid<Height>::kVoid) return false;
        value = bound == HeightBound::maximum ? std::max(value, post) : std::min(value, post);
    }
    return true;
}

/// How many nodes do not bound their cells, or bound them by more than they reach.
template <class Height>
std::uint64_t wrong_nodes(const HeightField<Height>& field, HeightBound bound, std::uint32_t levels,
                          const std::vector<MipmapLevel<Height>>& made) {
    const bool is_maximum = bound == HeightBound::maximum;
    std::uint64_t wrong = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        const std::uint32_t columns = ((field.columns - 2) >> level) + 1, rows = ((field.rows - 2) >> level) + 1;
        const Height nothing = is_maximum ? std::numeric_limits<Height>::lowest() : std::numeric_limits<Height>::max();
        std::vector<Height> expected(std::size_t{columns} * rows, nothing);
        for (std::uint32_t row = 0; row + 1 < field.rows; ++row) {
            for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
                Height value{};
                if (!cell_bound(field.grid(), column, row, bound, value)) continue;
                Height& node = expected[std::size_t{row >> level} * columns + (column >> level)];
                node = is_maximum ? std::max(node, value) : std::min(node, value);
            }
        }
        if (made[level].columns != columns || made[level].rows != rows) return 1;
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t column = 0; column < columns; ++column)
                wrong += made[level].at(column, row) != expected[std::size_t{row} * columns + column];
    }
    return wrong;
}

template <class Height>
std::uint64_t wrong_nodes(const HeightField<Height>& field, const HeightMipmap<Height>& mipmap) {
    std::vector<MipmapLevel<Height>> levels;
    for (std::uint32_t n = 0; n < mipmap.levels(); ++n) levels.push_back(mipmap.level(n));
    EXPECT_EQ(levels.back().columns, 1U);
    EXPECT_EQ(levels.back().rows, 1U);
    return wrong_nodes(field, mipmap.bound(), mipmap.levels(), levels);
}

struct Size {
    std::uint32_t columns, rows;
};
const std::vector<Size>& sizes() {
    static const std::vector<Size> all = {{2, 2},       {3, 2},       {2, 3},       {3, 3},       {5, 5},
                                          {17, 17},     {2, 1000},    {1000, 2},    {2, 4097},    {4097, 2},
                                          {129, 65},    {65, 130},    {1000, 1000}, {1001, 1001}, {1023, 1023},
                                          {1025, 1025}, {1000, 1023}, {3601, 37},   {37, 3601}};
    return all;
}

template <class Height>
void check_all_sizes() {
    base::SerialWorkers serial;
    for (const Size& size : sizes()) {
        const HeightField<Height> field = wild_field<Height>(size.columns, size.rows, 1);
        for (const HeightBound bound : {HeightBound::maximum, HeightBound::minimum}) {
            Bounds<Height> bounds(field, bound);
            bounds.mipmap.build(serial);
            EXPECT_EQ(wrong_nodes(field, bounds.mipmap), 0U) << size.columns << " x " << size.rows;
        }
    }
}

TEST(RayBounds, AreExactForEverySize) {
    check_all_sizes<std::int16_t>();
    check_all_sizes<float>();
}

TEST(RayBounds, AreExactForWholeTiles) {
    auto workers = platform::make_thread_workers({3, nullptr});
    ASSERT_TRUE(workers.ok());
    for (const std::uint32_t side : {3601U, 4097U}) {
        const HeightField<std::int16_t> field = wild_field<std::int16_t>(side, side, 2);
        Bounds<std::int16_t> bounds(field, HeightBound::maximum);
        bounds.mipmap.build(*workers.value());
        EXPECT_EQ(wrong_nodes(field, bounds.mipmap), 0U) << side;
    }
}

/// Levels of half the nodes, rounded down, as textures have them.
struct HalvedLevels {
    std::vector<std::vector<std::int16_t>> nodes;
    std::vector<MipmapLevel<std::int16_t>> levels;

    explicit HalvedLevels(const MipmapLevel<std::int16_t>& cells) : levels{cells} {
        while (levels.back().columns > 1 || levels.back().rows > 1) {
            const MipmapLevel<std::int16_t> fine = levels.back();
            const std::uint32_t columns = std::max(fine.columns / 2, 1U), rows = std::max(fine.rows / 2, 1U);
            nodes.emplace_back();
            for (std::uint32_t row = 0; row < rows; ++row)
                for (std::uint32_t column = 0; column < columns; ++column)
                    nodes.back().push_back(std::max(
                        std::max(fine.at(2 * column, 2 * row), fine.at(std::min(2 * column + 1, fine.columns - 1), 2 * row)),
                        std::max(fine.at(2 * column, std::min(2 * row + 1, fine.rows - 1)),
                                 fine.at(std::min(2 * column + 1, fine.columns - 1), std::min(2 * row + 1, fine.rows - 1)))));
            levels.push_back({nodes.back().data(), columns, rows});
        }
    }
};

TEST(RayBounds, TheCheckFindsHalvingThatRoundsDown) {
    base::SerialWorkers serial;
    std::uint64_t worst = 0, most_halved = 0;
    for (const std::uint32_t side : {1000U, 1001U, 1023U, 3601U, 1025U}) {
        const HeightField<std::int16_t> field = wild_field<std::int16_t>(side, 130, 3);
        Bounds<std::int16_t> bounds(field, HeightBound::maximum);
        bounds.mipmap.build(serial);
        const HalvedLevels halved(bounds.mipmap.level(0));
        const auto levels = static_cast<std::uint32_t>(std::min<std::size_t>(halved.levels.size(), bounds.mipmap.levels()));
        const std::uint64_t wrong = wrong_nodes(field, HeightBound::maximum, levels, halved.levels);
        EXPECT_GT(wrong, 0U) << side;
        worst = std::max(worst, wrong_nodes(field, bounds.mipmap));
        most_halved = std::max(most_halved, wrong);
    }
    EXPECT_EQ(worst, 0U);
    test_support::record_worst("A24", static_cast<double>(worst));
    test_support::record_control("A24", static_cast<double>(most_halved));
}

TEST(RayBounds, AreTheSameForAnyNumberOfWorkers) {
    const HeightField<std::int16_t> field = wild_field<std::int16_t>(777, 1501, 4);
    for (const std::uint32_t count : {1U, 2U, 3U, 7U}) {
        auto workers = platform::make_thread_workers({count, nullptr});
        ASSERT_TRUE(workers.ok());
        Bounds<std::int16_t> bounds(field, HeightBound::maximum);
        bounds.mipmap.build(*workers.value());
        EXPECT_EQ(wrong_nodes(field, bounds.mipmap), 0U) << count;
    }
}

TEST(RayBounds, FollowChangedRegions) {
    base::SerialWorkers serial;
    for (const Size& size : {Size{2, 2}, Size{2, 77}, Size{77, 2}, Size{130, 67}, Size{65, 65}}) {
        HeightField<std::int16_t> field = wild_field<std::int16_t>(size.columns, size.rows, 5);
        Bounds<std::int16_t> maxima(field, HeightBound::maximum), minima(field, HeightBound::minimum);
        maxima.mipmap.build(serial);
        minima.mipmap.build(serial);
        int stale = 0;  // before the update
        for (std::uint32_t n = 0; n < 60; ++n) {
            const auto pick = [&](std::uint32_t end, std::uint32_t salt) { return mixed_bits(n * 16 + salt) % end; };
            PostRegion region{pick(size.columns, 1), pick(size.rows, 2), 0, 0};
            region.end_column = region.first_column + 1 + pick(size.columns - region.first_column, 3);
            region.end_row = region.first_row + 1 + pick(size.rows - region.first_row, 4);
            for (std::uint32_t row = region.first_row; row < region.end_row; ++row)
                for (std::uint32_t column = region.first_column; column < region.end_column; ++column)
                    field.at(column, row) = static_cast<std::int16_t>(mixed_bits(n ^ mixed_bits(row * 4096 + column)));
            stale += wrong_nodes(field, maxima.mipmap) + wrong_nodes(field, minima.mipmap) > 0;
            maxima.mipmap.update(region);
            minima.mipmap.update(region);
            ASSERT_EQ(wrong_nodes(field, maxima.mipmap) + wrong_nodes(field, minima.mipmap), 0U) << n;
        }
        EXPECT_GT(stale, 40);
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_bounds
