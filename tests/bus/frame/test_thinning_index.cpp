#include "bus/frame/thinning_index.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::bus {
namespace {

struct Mark {
    base::Time newest;
    std::uint64_t item = 0;
};

/// Adds marks as a reader of `items` items would, item n at n milliseconds.
void fill(ThinningIndex<Mark>& index, std::uint64_t items) {
    std::uint64_t since = 0;
    for (std::uint64_t n = 1; n <= items; ++n) {
        if (!index.due(++since)) continue;
        index.add({{static_cast<std::int64_t>(n) * 1'000'000}, n});
        since = 0;
    }
}

TEST(ThinningIndex, StaysWithinItsMemoryAndEven) {
    std::vector<Mark> storage(16);
    ThinningIndex<Mark> index({storage.data(), storage.size()}, 10);
    fill(index, 100000);
    EXPECT_LE(index.size(), 16u);
    EXPECT_GE(index.size(), 8u);
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < index.size(); ++i) {
        EXPECT_LE(storage[i].item - before, 2 * index.stride());
        before = storage[i].item;
    }
    EXPECT_GE(before + 2 * index.stride(), 100000u);
}

TEST(ThinningIndex, FindsTheLastMarkAtOrBefore) {
    std::vector<Mark> storage(8);
    ThinningIndex<Mark> index({storage.data(), storage.size()}, 10);
    EXPECT_EQ(index.at_or_before({5}), nullptr);
    fill(index, 40);
    EXPECT_EQ(index.at_or_before({9'999'999}), nullptr);
    ASSERT_NE(index.at_or_before({10'000'000}), nullptr);
    EXPECT_EQ(index.at_or_before({10'000'000})->item, 10u);
    EXPECT_EQ(index.at_or_before({39'999'999})->item, 30u);
    EXPECT_EQ(index.at_or_before({1'000'000'000})->item, 40u);
}

}  // namespace
}  // namespace tedavis::bus
