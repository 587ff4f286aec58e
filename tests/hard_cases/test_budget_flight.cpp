// The smallest device flies over a database far larger than its memory: bytes stay as they are and within the budget table,
// nothing allocates, ground is in every picture and without a hole, unless the picture says that it is taken away. tests/big
// flies over 12 GB.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/budget_flight.hpp"
#include "tests/support/terrain/fractal_posts.hpp"

namespace tedavis::test_budget_flight {
namespace {

constexpr int kLegs = 6;
constexpr std::uint32_t kSide = 2150;
constexpr std::uint64_t kMinBytes = 250'000'000;

TEST(BudgetFlight, OverAQuarterGigabyteStaysWithinTheSmallestDevice) {
    const test_support::TemporaryFolder folder;
    host_sim::build_terrain(test_support::fractal_posts(kSide), folder.file("t.tdb"), {});
    ASSERT_GE(std::filesystem::file_size(folder.file("t.tdb")), kMinBytes);
    test_support::BudgetFlight flight(folder.file("t.tdb"), "es2-small", test_support::fractal_ground(kSide), kLegs);
    const test_support::FlownBudget flown = flight.fly();
    EXPECT_EQ(flown.frames, kLegs * test_support::BudgetFlight::kFramesOfALeg);
    test_support::expect_within_device(flown, kLegs);
    EXPECT_EQ(flight.slowest_refinement(), test_support::BudgetFlight::kArrivalFrames);
    std::printf("%.0f triangles, taken away in %d frames, %.1f ms (p99 %.1f ms) of processor time\n", flown.mean_triangles,
                flown.taken_away, flown.quantile_ms(0.5), flown.quantile_ms(0.99));
}

}  // namespace
}  // namespace tedavis::test_budget_flight
