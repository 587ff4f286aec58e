#include "render_core/terrain/kept_heights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace tedavis::terrain::test_kept_heights {
namespace {

struct Kept {
    Kept() {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(heights.start(arena));
    }
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(KeptHeights::bytes_needed());
    KeptHeights heights;
};

HeightAnswer answer(double height_m) { return {HeightStatus::land, {height_m}, {48}}; }

double latitude(int n) { return 0.8 + 1e-5 * n; }
double longitude(int n) { return 0.17 + 3e-6 * (n % 37); }

TEST(KeptHeights, FindsExactlyWhatWasKept) {
    Kept kept;
    EXPECT_EQ(kept.heights.find(0.8, 0.17), nullptr);
    kept.heights.keep(0.8, 0.17, answer(1234));
    ASSERT_NE(kept.heights.find(0.8, 0.17), nullptr);
    EXPECT_EQ(kept.heights.find(0.8, 0.17)->height.m, 1234);
    EXPECT_EQ(kept.heights.find(0.8, 0.17)->undulation.m, 48);
    EXPECT_EQ(kept.heights.find(0.17, 0.8), nullptr);
    EXPECT_EQ(kept.heights.find(std::nextafter(0.8, 1), 0.17), nullptr);
    EXPECT_EQ(kept.heights.find(0.8, std::nextafter(0.17, 0)), nullptr);
}

/// Against a map that forgets nothing.
TEST(KeptHeights, NeverReturnsTheAnswerOfAnotherPlace) {
    Kept kept;
    std::map<int, double> all;
    int found = 0;
    for (int n = 0; n < 20000; ++n) {
        const int place = n % 2 == 0 ? n / 2 % 300 : (n * 7919) % 5000;  // some are asked for again and again
        const HeightAnswer* const one = kept.heights.find(latitude(place), longitude(place));
        if (one != nullptr) {
            ++found;
            ASSERT_EQ(one->height.m, all.at(place));
        }
        all[place] = n;
        if (one == nullptr) kept.heights.keep(latitude(place), longitude(place), answer(n));
        if (one != nullptr) all[place] = one->height.m;
    }
    EXPECT_LT(found, 20000) << "control: it is too small for all";
    EXPECT_GT(found, 1000);
}

TEST(KeptHeights, AThousandPlacesStay) {
    Kept kept;
    constexpr int kPlaces = 1000;
    for (int n = 0; n < kPlaces; ++n) kept.heights.keep(latitude(n), longitude(n), answer(n));
    int lost = 0;
    for (int n = 0; n < kPlaces; ++n) lost += kept.heights.find(latitude(n), longitude(n)) == nullptr ? 1 : 0;
    EXPECT_LT(lost, kPlaces / 20);
}

TEST(KeptHeights, WhatIsAskedForOutlivesWhatIsNot) {
    Kept kept;
    kept.heights.keep(0.8, 0.17, answer(1234));
    for (int n = 0; n < 20000; ++n) {
        kept.heights.keep(latitude(n + 1), longitude(n), answer(n));
        ASSERT_NE(kept.heights.find(0.8, 0.17), nullptr) << n;
    }
    Kept control;
    control.heights.keep(0.8, 0.17, answer(1234));
    for (int n = 0; n < 20000; ++n) control.heights.keep(latitude(n + 1), longitude(n), answer(n));
    EXPECT_EQ(control.heights.find(0.8, 0.17), nullptr);
}

TEST(KeptHeights, RefusesASmallArena) {
    Kept kept;
    base::Arena arena(kept.memory.data(), kept.memory.size() / 2);
    EXPECT_FALSE(KeptHeights().start(arena));
}

}  // namespace
}  // namespace tedavis::terrain::test_kept_heights
