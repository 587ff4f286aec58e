#include "host_sim/clearance/closest_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/terrain/brute_ground.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_closest_points {
namespace {

using ::testing::ElementsAre;

/// A sample each second, with these heights above the terrain.
std::vector<TrackSample> track_of(const std::vector<double>& heights_m) {
    std::vector<TrackSample> track;
    for (const double height_m : heights_m) {
        TrackSample sample;
        sample.time = base::Time{} + base::Duration::seconds(static_cast<std::int64_t>(track.size()));
        sample.height_above_terrain_m = height_m;
        sample.phase = {flight::Scenario::cruise, 0};
        track.push_back(sample);
    }
    return track;
}

std::vector<std::size_t> lowest(const std::vector<TrackSample>& track) {
    return closest_samples(track, [&](std::size_t n) { return track[n].height_above_terrain_m; });
}

/// 1000 m, with dips at some seconds.
std::vector<double> dips(std::size_t count, const std::vector<std::pair<std::size_t, double>>& at) {
    std::vector<double> heights_m(count, 1000);
    heights_m.front() = heights_m.back() = 2000;
    for (std::size_t n = 1; n + 1 < count; ++n) heights_m[n] += 1e-6 * static_cast<double>(n);
    for (const auto& [n, height_m] : at) heights_m[n] = height_m;
    return heights_m;
}

TEST(ClosestPoints, AreMinimaAtLeastHalfAMinuteApart) {
    const auto chosen = lowest(track_of(dips(200, {{40, 300}, {60, 250}, {69, 280}, {91, 290}, {150, 100}})));
    ASSERT_GE(chosen.size(), 3u);
    EXPECT_EQ(chosen[0], 150u);
    EXPECT_EQ(chosen[1], 60u);
    EXPECT_EQ(chosen[2], 91u) << "those at 40 and 69 s are less than 30 s from the one at 60 s";
    EXPECT_LE(chosen.size(), kMaxClosest);
}

TEST(ClosestPoints, TakeOffAndLandingAreLeftOut) {
    std::vector<double> heights_m;
    for (int n = 0; n <= 200; ++n) heights_m.push_back(std::max(0.0, 600 - 8.0 * std::abs(n - 100) + (n == 130 ? -50 : 0)));
    std::vector<TrackSample> track = track_of(heights_m);
    for (TrackSample& sample : track) sample.is_on_ground = sample.height_above_terrain_m <= 0;
    EXPECT_THAT(lowest(track), ElementsAre(130)) << "not the ground, nor where the time round it begins";
    const std::vector<bool> counts = counted_samples(track);
    EXPECT_FALSE(counts[25 + 29]);
    EXPECT_TRUE(counts[25 + 30]) << "the last sample on the ground is that at 25 s";
    for (TrackSample& sample : track) sample.is_on_ground = false;
    EXPECT_NE(lowest(track).front(), 130u) << "control: without the rule it is the ground";
}

TEST(ClosestPoints, AGapAndUnknownGroundAreNoMinimum) {
    std::vector<TrackSample> track = track_of(dips(100, {{50, 300}, {51, 200}}));
    track[51].height_above_terrain_m = std::nan("");
    const auto beside_unknown = lowest(track);
    EXPECT_EQ(std::count(beside_unknown.begin(), beside_unknown.end(), 50u), 0) << "the ground beside it is unknown";
    EXPECT_THAT(lowest(track_of(std::vector<double>(60, std::nan("")))), ElementsAre());
    track = track_of(dips(100, {{51, 200}}));
    for (std::size_t n = 51; n < track.size(); ++n) track[n].time = track[n].time + base::Duration::seconds(60);
    const auto chosen = lowest(track);
    EXPECT_EQ(std::count(chosen.begin(), chosen.end(), 51u), 0) << "what came before it is unknown";
}

TEST(ClosestPoints, StandingIsToldByThePhaseOrBySpeedAndHeight) {
    EXPECT_TRUE(stands_on_ground({flight::Scenario::ground, 0}, 60, 500));
    EXPECT_FALSE(stands_on_ground({flight::Scenario::cruise, 0}, 0, 2)) << "a helicopter hovers";
    EXPECT_TRUE(stands_on_ground({}, 5, 3));
    EXPECT_FALSE(stands_on_ground({}, 5, 100));
    EXPECT_FALSE(stands_on_ground({}, 40, 3));
}

/// A descending circle over rough ground, a sample each half second.
struct FlownRound {
    FlownRound() {
        for (int n = 0; n <= 240; ++n) track.push_back(at(0.5 * n));
    }
    [[nodiscard]] TrackSample at(double seconds) {
        const double turned = 2 * base::kPi * seconds / 120;
        TrackSample sample;
        sample.time = base::Time{} + base::Duration::from_seconds(seconds);
        earth::Geodetic& place = sample.own.place;
        place.latitude_rad = base::radians(47.06) + 1200 / 6.37e6 * std::cos(turned);
        place.longitude_rad = base::radians(9.64) + 1200 / 4.34e6 * std::sin(turned);
        sample.own.height_msl_m = 1450 - 0.5 * seconds;
        sample.own.is_geometric = true;
        place.height.m = sample.own.height_msl_m + built.database.undulation(place.latitude_rad, place.longitude_rad).m;
        sample.height_above_terrain_m = meter.height_above_terrain_m(sample.own);
        return sample;
    }
    Raster raster = test_support::make_rough_raster(97, 97);
    test_support::BuiltDatabase built{raster};
    ClearanceMeter meter{built.database};
    std::vector<TrackSample> track;
};

/// The oracle knows the circle itself and the raster only.
TEST(ClosestPoints, AreThoseOfABruteForceSearchOverRasterAndTrack) {
    FlownRound round;
    const ClosestPoints found = closest_points(round.track, round.meter);
    ASSERT_FALSE(found.by_height.empty());
    ASSERT_FALSE(found.by_distance.empty());
    const test_support::BruteGround brute(round.raster, round.built.database);
    double least_m = INFINITY, least_s = 0;
    for (int n = 0; n <= 12000; ++n) {
        const TrackSample sample = round.at(0.01 * n);
        const double above_m =
            sample.own.height_msl_m - brute.height_m(sample.own.place.latitude_rad, sample.own.place.longitude_rad);
        if (above_m < least_m) least_m = above_m, least_s = 0.01 * n;
    }
    const TrackSample& lowest = found.by_height.front().sample;
    EXPECT_NEAR(lowest.height_above_terrain_m, least_m, 1);
    EXPECT_NEAR((lowest.time - base::Time{}).to_seconds(), least_s, 0.5);
    double nearest_m = INFINITY, nearest_s = 0;
    for (int n = 0; n <= 240; ++n) {
        const double here_m = brute.distance_m(earth::to_ecef(round.at(0.5 * n).own.place));
        if (here_m < nearest_m) nearest_m = here_m, nearest_s = 0.5 * n;
    }
    const ClosestPoint& nearest = found.by_distance.front();
    EXPECT_NEAR(nearest.nearest.distance_m, nearest_m, 1);
    EXPECT_NEAR((nearest.sample.time - base::Time{}).to_seconds(), nearest_s, 0.5);
}

TEST(ClosestPoints, AnotherRasterGivesAnotherAnswer) {
    FlownRound round;
    Raster displaced = round.raster;
    displaced.west_deg += 5 * displaced.step_lon_deg;
    const test_support::BuiltDatabase built(displaced);
    ClearanceMeter meter(built.database);
    std::vector<TrackSample> track = round.track;
    for (TrackSample& sample : track) sample.height_above_terrain_m = meter.height_above_terrain_m(sample.own);
    const ClosestPoints here = closest_points(round.track, round.meter), there = closest_points(track, meter);
    ASSERT_FALSE(here.by_height.empty());
    ASSERT_FALSE(there.by_height.empty());
    EXPECT_GT(
        std::fabs(here.by_height.front().sample.height_above_terrain_m - there.by_height.front().sample.height_above_terrain_m),
        1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_closest_points
