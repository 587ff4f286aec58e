#include "host_sim/comparison/place_alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_place_alignment {
namespace {

TrackPlace place(double north_m, double east_m) {
    const ComparedFrame frame = made_frame(0, 0, north_m, east_m);
    return {frame.latitude_deg, frame.longitude_deg, true};
}

std::vector<TrackPlace> random_track(std::mt19937& random, std::size_t places) {
    std::uniform_real_distribution<double> metres(-2000, 2000);
    std::vector<TrackPlace> track;
    for (std::size_t n = 0; n < places; ++n) track.push_back(place(metres(random), metres(random)));
    return track;
}

/// Distance to a segment by trying many of its places.
double tried_distance_m(const TrackPlace& from, const std::vector<TrackPlace>& other, std::size_t segment) {
    const TrackPlace &begin = other[segment], &end = other[std::min(segment + 1, other.size() - 1)];
    double least_m = INFINITY;
    for (int n = 0; n <= 2000; ++n) {
        const double share = n / 2000.0;
        const double north_m =
            (begin.latitude_deg + share * (end.latitude_deg - begin.latitude_deg) - from.latitude_deg) * kDegree_m;
        const double east_m = (begin.longitude_deg + share * (end.longitude_deg - begin.longitude_deg) - from.longitude_deg) *
                              kDegree_m * std::cos(from.latitude_deg * 3.14159265358979 / 180);
        least_m = std::min(least_m, std::hypot(north_m, east_m));
    }
    return least_m;
}

/// The least sum over all assignments that do not go back, by trying each of them.
double tried_sum(const std::vector<std::vector<double>>& costs, std::size_t row, std::size_t first) {
    if (row == costs.size()) return 0;
    double least = INFINITY;
    for (std::size_t column = first; column < costs[row].size(); ++column)
        least = std::min(least, costs[row][column] + tried_sum(costs, row + 1, column));
    return least;
}

/// A place without a counterpart counts as far as the limit. Where several places share a segment they may not go back on it,
/// which the search over segments does not know: their sum is no less than the least one. Where none do it is exactly that.
TEST(PlaceAlignment, SumsAreThoseOfTheBestOfAllAssignments) {
    std::mt19937 random(7);
    int compared = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const double within_m = trial % 2 == 0 ? 1500 : 6000;
        const auto track = random_track(random, 4), other = random_track(random, 14);
        std::vector<std::vector<double>> costs(track.size());
        for (std::size_t n = 0; n < track.size(); ++n)
            for (std::size_t m = 0; m < other.size(); ++m)
                costs[n].push_back(std::pow(std::min(tried_distance_m(track[n], other, m), within_m), 2));
        const auto pairs = paired_places(track, other, within_m);
        double along = -1, sum = 0;
        bool has_segments_of_their_own = true;
        for (const auto& pair : pairs) {
            sum += pair ? std::pow(pair->distance_m, 2) : within_m * within_m;
            has_segments_of_their_own = has_segments_of_their_own && pair && std::floor(pair->along) > std::floor(along);
            if (!pair) continue;
            EXPECT_GE(pair->along, along) << "it does not go back";
            EXPECT_LE(pair->distance_m, within_m);
            along = pair->along;
        }
        const double least = tried_sum(costs, 0, 0);
        EXPECT_GE(sum, least * 0.999) << trial;
        if (!has_segments_of_their_own) continue;
        EXPECT_LE(sum, least * 1.001) << trial;
        ++compared;
    }
    EXPECT_GE(compared, 10);
}

TEST(PlaceAlignment, ATrackIsItsOwnCounterpart) {
    std::mt19937 random(3);
    const auto track = random_track(random, 12);
    const auto pairs = paired_places(track, track, 3000);
    for (std::size_t n = 0; n < track.size(); ++n) {
        ASSERT_TRUE(pairs[n]);
        EXPECT_NEAR(pairs[n]->along, static_cast<double>(n), 1e-9);
        EXPECT_NEAR(pairs[n]->distance_m, 0, 1e-3);
    }
}

/// The nearest place would be on the way out for all; the order makes it the way back for the second half.
TEST(PlaceAlignment, AnOutAndBackFlightIsPairedInItsOrder) {
    std::vector<TrackPlace> track, other;
    for (int n = 0; n <= 10; ++n) track.push_back(place(1000.0 * (n <= 5 ? n : 10 - n), 0));
    for (int n = 0; n <= 20; ++n) other.push_back(place(500.0 * (n <= 10 ? n : 20 - n), n <= 10 ? 40 : 60));
    const auto pairs = paired_places(track, other, 500);
    for (std::size_t n = 0; n < track.size(); ++n) {
        ASSERT_TRUE(pairs[n]) << n;
        EXPECT_NEAR(pairs[n]->along, 2.0 * static_cast<double>(n), 0.2) << n;
    }
}

/// Three circuits of the other flight in a holding pattern: the places along the straight track still go forwards.
TEST(PlaceAlignment, AHoldingPatternDoesNotJump) {
    std::vector<TrackPlace> track, other;
    for (int n = 0; n <= 20; ++n) track.push_back(place(500.0 * n, 0));
    for (int n = 0; n <= 10; ++n) other.push_back(place(500.0 * n, 30));
    for (int n = 1; n <= 36; ++n) other.push_back(place(5000 + 800 * std::sin(n * 0.5236), 830 - 800 * std::cos(n * 0.5236)));
    for (int n = 11; n <= 20; ++n) other.push_back(place(500.0 * n, 30));
    const auto pairs = paired_places(track, other, 3000);
    double along = -1;
    for (std::size_t n = 0; n < track.size(); ++n) {
        ASSERT_TRUE(pairs[n]);
        EXPECT_GE(pairs[n]->along, along);
        along = pairs[n]->along;
    }
    EXPECT_GT(along, 50) << "the end is paired with the end";
}

TEST(PlaceAlignment, FarPlacesAndEmptyTracksHaveNone) {
    const auto pairs = paired_places({place(0, 0), place(0, 9000)}, {place(0, 100), place(0, 200)}, 3000);
    EXPECT_TRUE(pairs[0]);
    EXPECT_FALSE(pairs[1]);
    EXPECT_TRUE(paired_places({}, {place(0, 0)}, 3000).empty());
    EXPECT_FALSE(paired_places({place(0, 0)}, {}, 3000)[0]);
}

TEST(PlaceAlignment, ThereIsNoPlaceWithinAGap) {
    std::vector<TrackPlace> other{place(0, 0), place(8000, 0)};
    ASSERT_NEAR(paired_places({place(4000, 0)}, other, 3000)[0]->along, 0.5, 1e-6);
    other[0].joins_next = false;
    EXPECT_FALSE(paired_places({place(4000, 0)}, other, 3000)[0]);
}

}  // namespace
}  // namespace tedavis::host_sim::test_place_alignment
