// The smallest device flies over a database far larger than its memory: bytes stay as they are and within the budget table,
// nothing allocates, ground is in every picture and without a hole, unless the picture says that it is taken away. tests/big
// flies over 12 GB.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/support/budget_flight.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tedavis {
namespace {

constexpr int kLegs = 8;
constexpr std::uint32_t kSide = 3000;
constexpr std::uint64_t kLeastBytes = 500'000'000;

TEST(BudgetFlight, OverHalfAGigabyteStaysWithinTheSmallestDevice) {
    const test_support::TemporaryFolder folder;
    host_sim::build_terrain(test_support::fractal_posts(kSide), folder.file("t.tdb"), {});
    ASSERT_GE(std::filesystem::file_size(folder.file("t.tdb")), kLeastBytes);
    const test_support::FlownBudget flown = test_support::BudgetFlight(folder.file("t.tdb"), "es2-small", kSide, kLegs).fly();
    EXPECT_EQ(flown.frames, 400);
    EXPECT_EQ(flown.changed_bytes, 0) << "of " << flown.cpu_bytes << " and " << flown.gpu_bytes;
    EXPECT_EQ(flown.over_budget, 0);
    EXPECT_EQ(flown.over_triangles, 0);
    EXPECT_LE(flown.cpu_bytes + flown.gpu_bytes, 64u << 20);
    EXPECT_EQ(flown.heap_calls, 0u);
    EXPECT_EQ(flown.without_terrain, 0);
    EXPECT_EQ(flown.taken_away_later, 0);
    EXPECT_LE(flown.taken_away, 4 * kLegs) << "two after every jump, and some in fast turns";
    EXPECT_EQ(flown.failing, 0);
    EXPECT_EQ(flown.holes, 0);
    std::printf("%.0f triangles, taken away in %d frames, %.1f ms (p99 %.1f ms) of processor time\n", flown.mean_triangles,
                flown.taken_away, flown.quantile_ms(0.5), flown.quantile_ms(0.99));
}

}  // namespace
}  // namespace tedavis
