#include "host_sim/terrain_builder/attributes/row_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace tedavis::host_sim::test_row_directions {
namespace {

using terrain::kHorizonDirection;
using terrain::kHorizonDirections;

// Oracle: azimuths from the public function of the core, distances from the lattice.
TEST(RowDirections, UnitVectorsAndDistancesFollowTheCells) {
    constexpr double kEast_m = 21, kNorth_m = 30.9;
    const auto directions = row_directions(kEast_m, kNorth_m);
    double sum = 0;
    for (int k = 0; k < kHorizonDirections; ++k) {
        const RowDirection& d = directions[static_cast<std::size_t>(k)];
        const double azimuth = terrain::horizon_azimuth_rad(k, kEast_m, kNorth_m);
        EXPECT_NEAR(d.east, std::sin(azimuth), 1e-6);
        EXPECT_NEAR(d.north, std::cos(azimuth), 1e-6);
        const auto lattice = kHorizonDirection[static_cast<std::size_t>(k)];
        const double distance_m = 7 * std::hypot(0.5 * lattice.east2 * kEast_m, 0.5 * lattice.north2 * kNorth_m);
        EXPECT_NEAR(d.per_m[7] * distance_m, 1, 1e-6);
        EXPECT_NEAR(d.drop[7], distance_m / 2 / 6371000, 1e-9);
        sum += static_cast<double>(d.weight);
        const double before = terrain::horizon_azimuth_rad((k + 15) % 16, kEast_m, kNorth_m),
                     after = terrain::horizon_azimuth_rad((k + 1) % 16, kEast_m, kNorth_m);
        EXPECT_NEAR(d.weight, std::fmod(after - before + 2 * base::kPi, 2 * base::kPi) / (4 * base::kPi), 1e-6);
    }
    EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(RowDirections, ARightAngleChangesNoBitOnSquareCells) {
    for (const double cell_m : {30.0, 27.77, 92.6, 1e5 / 3}) {
        const auto directions = row_directions(cell_m, cell_m);
        for (std::size_t k = 0; k < kHorizonDirections; ++k) {
            const RowDirection &a = directions[k], &b = directions[(k + 4) % kHorizonDirections];
            EXPECT_EQ(a.weight, b.weight);
            EXPECT_EQ(a.per_m, b.per_m);
            EXPECT_EQ(a.north, b.east);
            EXPECT_EQ(a.east, -b.north);
        }
    }
    const auto narrow = row_directions(20, 30);
    EXPECT_NE(narrow[0].weight, narrow[4].weight) << "the cells must be square";
}

TEST(RowDirections, SamplesLieOnPostsOrHalfWayBetweenTwo) {
    constexpr std::ptrdiff_t kStride = 100;
    const auto places = sample_places(kStride);
    const auto expect = [&](std::size_t k, std::size_t s, HalfPost plane, std::ptrdiff_t south, std::ptrdiff_t east) {
        EXPECT_EQ(places[k][s].plane, plane) << k << " " << s;
        EXPECT_EQ(places[k][s].offset, south * kStride + east) << k << " " << s;
    };
    expect(0, 5, at_post, -5, 0);     // north
    expect(4, 16, at_post, 0, 16);    // east
    expect(6, 3, at_post, 3, 3);      // south-east
    expect(1, 4, at_post, -4, 2);     // (1,2)
    expect(1, 3, half_east, -3, 1);   // column 1.5
    expect(3, 3, half_south, -2, 3);  // row -1.5
    expect(5, 3, half_south, 1, 3);   // row 1.5
    expect(13, 1, half_south, -1, -1);
    expect(15, 1, half_east, -1, -1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_row_directions
