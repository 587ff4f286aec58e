#include "render_core/policy/priority_boost.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tedavis::policy::test_priority_boost {
namespace {

constexpr std::size_t kTerrain = design::kTerrainAspect, kUnsure = design::kUncertaintyAspect;

/// Asks for the same at every instant, and notes which.
class Asked final : public BoostSource {
public:
    PriorityBoosts raises;
    std::int64_t none_before_ns = 0;
    std::vector<std::int64_t> instants;

    [[nodiscard]] PriorityBoosts boosts_at(const PriorityInstant& instant) override {
        instants.push_back(instant.now.ns);
        return instant.now.ns < none_before_ns ? PriorityBoosts() : raises;
    }
    void ask(std::size_t aspect, double raise) {
        raises = {};
        raises.of[aspect] = raise;
        raises.has_hazard = raise > 0 && aspect != kUnsure;
        raises.hazard.latitude_rad = raise;
    }
};

struct Flight {
    Asked asked;
    PriorityBoost raised;
    std::size_t design = 0;
    double latitude_rad = 0.8;

    double follow(double seconds) {
        PriorityInstant instant;
        instant.now = base::Time{std::llround(seconds * 1e9)};
        instant.own_ship.position.latitude_rad = latitude_rad;
        raised.follow(instant, asked, design);
        return raise(kTerrain);
    }
    [[nodiscard]] double raise(std::size_t aspect) const {
        design::AspectWeights stated;
        stated.of.fill(0);
        return raised.above(stated).of[aspect];
    }
};

TEST(PriorityBoost, TheFirstIntervalHasWhatIsAskedFor) {
    Flight flight;
    flight.asked.ask(kTerrain, 0.7);
    EXPECT_EQ(flight.follow(3.2), 0.7);
    ASSERT_NE(flight.raised.hazard(), nullptr);
    EXPECT_EQ(flight.raised.hazard()->latitude_rad, 0.7);
}

TEST(PriorityBoost, WhatFlickersFromFrameToFrameDoesNot) {
    Flight flight;
    std::size_t changes = 0;
    double before = 0, most = 0;
    for (int frame = 0; frame < 300; ++frame) {
        flight.asked.ask(kTerrain, frame % 3 == 0 ? 0.7 : 0);
        const double raise = flight.follow(10 + frame / 30.0);
        if (frame > 0 && raise != before) {
            ++changes;
            most = std::max(most, std::fabs(raise - before));
            EXPECT_EQ(frame % 15, 0) << "only where an interval begins";
        }
        before = raise;
    }
    EXPECT_LE(changes, 20u);
    EXPECT_LE(most, PriorityBoost::kMaxRise);
    EXPECT_EQ(flight.asked.instants.size(), 20u) << "asked once an interval";
}

TEST(PriorityBoost, ItRisesAndFallsLittleByLittle) {
    Flight flight;
    EXPECT_EQ(flight.follow(0), 0);
    flight.asked.ask(kTerrain, 0.6);
    EXPECT_EQ(flight.follow(0.49), 0);
    EXPECT_EQ(flight.follow(0.5), 0.25);
    EXPECT_EQ(flight.follow(1.1), 0.5);
    EXPECT_EQ(flight.follow(1.6), 0.6);
    flight.asked.ask(kTerrain, 0);
    EXPECT_DOUBLE_EQ(flight.follow(2), 0.475);
    EXPECT_NE(flight.raised.hazard(), nullptr) << "it is still falling";
    EXPECT_EQ(flight.raised.hazard()->latitude_rad, 0.6);
    EXPECT_DOUBLE_EQ(flight.follow(3), 0.225) << "two intervals at once";
    EXPECT_EQ(flight.follow(9), 0);
    EXPECT_EQ(flight.raised.hazard(), nullptr);
}

/// As if the flight had come to it for the first time.
TEST(PriorityBoost, AnEarlierInstantFollowsFromNothing) {
    Flight flight;
    flight.asked.ask(kTerrain, 1);
    EXPECT_EQ(flight.follow(20), 1);
    flight.asked.ask(kTerrain, 0);
    EXPECT_EQ(flight.follow(10), 0);
}

TEST(PriorityBoost, TheSameInstantElsewhereIsDecidedAnew) {
    Flight flight;
    EXPECT_EQ(flight.follow(5), 0);
    flight.asked.ask(kTerrain, 0.9);
    EXPECT_EQ(flight.follow(5), 0) << "the same flight";
    flight.latitude_rad = 0.81;
    EXPECT_EQ(flight.follow(5), 0.9);
}

TEST(PriorityBoost, AnotherDesignDecidesTheIntervalAtItsFirstInstant) {
    Flight flight;
    flight.follow(5);
    flight.follow(5.5);
    const PriorityBoost before = flight.raised;
    flight.follow(5.75);
    flight.design = 1;
    flight.asked.ask(kTerrain, 0.9);
    EXPECT_EQ(flight.follow(5.8), 0.9) << "at once";
    EXPECT_EQ(flight.asked.instants.back(), 5'500'000'000);
    // The next interval is the same, whether the turn was seen or not.
    Flight other = flight;
    other.raised = before;
    const double seen = flight.follow(6);
    EXPECT_EQ(seen, other.follow(6));
    flight.asked.none_before_ns = other.asked.none_before_ns = 6'000'000'000;
    other.raised = before;
    EXPECT_NE(seen, other.follow(6)) << "control: what the former instant asked for counts";
    EXPECT_EQ(other.asked.instants.back(), 6'000'000'000);
}

TEST(PriorityBoost, NoWeightIsAboveOne) {
    Flight flight;
    flight.asked.ask(kUnsure, 0.6);
    flight.follow(1);
    design::AspectWeights stated;
    stated.of.fill(0.7);
    EXPECT_EQ(flight.raised.above(stated).of[kUnsure], 1);
    EXPECT_EQ(flight.raised.above(stated).of[kTerrain], 0.7);
    EXPECT_EQ(flight.raised.hazard(), nullptr) << "what is stale lies nowhere";
}

TEST(PriorityBoost, AnAlertComesAtOnceAndStaysForTwoSeconds) {
    Flight flight;
    flight.follow(10);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::none);
    flight.asked.raises.terrain_ahead = TerrainAhead::caution;
    flight.follow(10.5);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::caution);
    flight.asked.raises.terrain_ahead = TerrainAhead::warning;
    flight.follow(11);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::warning);
    flight.asked.raises.terrain_ahead = TerrainAhead::none;
    for (const double seconds : {11.5, 12.0, 12.5}) {
        flight.follow(seconds);
        EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::warning) << seconds;
    }
    flight.follow(13);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::none) << "control";
}

TEST(PriorityBoost, AnObstacleAlertStaysAsLongWithTheObstaclesThatItLastNamed) {
    Flight flight;
    flight.follow(10);
    flight.asked.raises.obstacles.add(1, 7, 40, std::numeric_limits<double>::infinity());
    flight.follow(10.5);
    EXPECT_EQ(flight.raised.obstacles().of(1, 7), TerrainAhead::caution);
    flight.asked.raises.obstacles = {};
    flight.asked.raises.obstacles.add(1, 8, 20, std::numeric_limits<double>::infinity());
    flight.follow(11);
    EXPECT_EQ(flight.raised.obstacles().of(1, 7), TerrainAhead::none) << "it is no longer in the way";
    flight.asked.raises.obstacles = {};
    flight.follow(12.5);
    EXPECT_EQ(flight.raised.obstacles().of(1, 8), TerrainAhead::warning);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::none);
    flight.design = 1;
    flight.follow(12.6);
    EXPECT_EQ(flight.raised.obstacles().of(1, 8), TerrainAhead::warning) << "another design keeps it";
    flight.follow(13);
    EXPECT_EQ(flight.raised.obstacles().level(), TerrainAhead::none) << "control";
}

TEST(PriorityBoost, AnotherDesignKeepsTheAlert) {
    Flight flight;
    flight.asked.raises.terrain_ahead = TerrainAhead::warning;
    flight.follow(10);
    flight.asked.raises.terrain_ahead = TerrainAhead::none;
    flight.follow(10.5);
    flight.design = 1;
    flight.follow(10.6);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::warning);
    flight.latitude_rad = 0.82;
    flight.follow(10.6);
    EXPECT_EQ(flight.raised.terrain_ahead(), TerrainAhead::none) << "control: the same instant elsewhere is another flight";
}

}  // namespace
}  // namespace tedavis::policy::test_priority_boost
