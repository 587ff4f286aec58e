#include "render_core/terrain/key_map.hpp"

#include <gtest/gtest.h>

#include <random>
#include <unordered_map>
#include <vector>

namespace tedavis::terrain::test_key_map {
namespace {

struct Map {
    explicit Map(std::uint32_t entries) : memory(KeyMap::bytes_needed(entries)) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(map.start(arena, entries));
    }
    std::vector<std::uint8_t> memory;
    KeyMap map;
};

TEST(KeyMap, AgreesWithTheLibrarysThroughInsertsErasesAndChanges) {
    Map m(300);
    std::unordered_map<std::uint64_t, std::uint32_t> expected;
    std::mt19937 random(5);
    for (int step = 0; step < 60000; ++step) {
        // Few keys, far apart in one bit only, so that they meet.
        const std::uint64_t key = (std::uint64_t{random() % 400} << 40) + 1;
        if (random() % 2 == 0) {
            m.map.erase(key);
            expected.erase(key);
        } else if (expected.count(key) != 0) {
            m.map.change(key, static_cast<std::uint32_t>(step));
            expected[key] = static_cast<std::uint32_t>(step);
        } else if (m.map.insert(key, static_cast<std::uint32_t>(step))) {
            expected[key] = static_cast<std::uint32_t>(step);
        } else {
            EXPECT_EQ(expected.size(), 300u);
        }
        ASSERT_EQ(m.map.size(), expected.size());
        const std::uint64_t asked = (std::uint64_t{random() % 400} << 40) + 1;
        const auto found = expected.find(asked);
        ASSERT_EQ(m.map.find(asked), found == expected.end() ? KeyMap::kNone : found->second);
    }
}

TEST(KeyMap, RefusesWhenFullAndServesAgainWhenCleared) {
    Map m(3);
    for (std::uint64_t key : {1u, 2u, 3u}) EXPECT_TRUE(m.map.insert(key, 7));
    EXPECT_FALSE(m.map.insert(4, 7));
    EXPECT_EQ(m.map.find(4), KeyMap::kNone);
    m.map.clear();
    EXPECT_EQ(m.map.find(1), KeyMap::kNone);
    EXPECT_TRUE(m.map.insert(4, 8));
    EXPECT_EQ(m.map.find(4), 8u);
}

TEST(KeyMap, RefusesASmallArena) {
    std::vector<std::uint8_t> memory(64);
    base::Arena arena(memory.data(), memory.size());
    KeyMap map;
    EXPECT_FALSE(map.start(arena, 100));
}

}  // namespace
}  // namespace tedavis::terrain::test_key_map
