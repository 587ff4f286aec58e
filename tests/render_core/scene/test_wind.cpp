#include "render_core/scene/wind.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::scene::test_wind {
namespace {

using base::radians;

/// Towards east and north, of a wind from a direction.
struct Blowing {
    double east_mps, north_mps;
};
Blowing from(double direction_deg, double speed_mps) {
    return {-speed_mps * std::sin(radians(direction_deg)), -speed_mps * std::cos(radians(direction_deg))};
}

Wind mean_of(const std::vector<double>& directions_deg, double speed_mps = 10) {
    WindMean mean;
    for (const double direction : directions_deg)
        mean.add(from(direction, speed_mps).east_mps, from(direction, speed_mps).north_mps);
    return mean.mean();
}

TEST(Wind, ADirectionIsWhereItComesFrom) {
    for (double direction = 0; direction < 360; direction += 7.5) {
        const Wind wind = wind_of(from(direction, 12).east_mps, from(direction, 12).north_mps);
        EXPECT_EQ(wind.state, WindState::steady);
        EXPECT_NEAR(earth::angle_difference(wind.from_rad, radians(direction)), 0, 1e-12) << direction;
        EXPECT_NEAR(wind.speed_mps, 12, 1e-12);
        EXPECT_DOUBLE_EQ(wind.constancy, 1);
    }
}

TEST(Wind, TheMeanOf350And10IsNorthAndNotSouth) {
    const Wind wind = mean_of({350, 10});
    EXPECT_NEAR(earth::angle_difference(wind.from_rad, 0), 0, 1e-12);
    EXPECT_NEAR(wind.constancy, std::cos(radians(10)), 1e-12);
    EXPECT_NEAR(wind.speed_mps, 10, 1e-12) << "the air is as fast as before";
}

TEST(Wind, WhereDirectionsCancelThereIsNone) {
    for (const std::vector<double>& directions : {std::vector<double>{0, 180}, {0, 120, 240}, {10, 100, 190, 280}}) {
        const Wind wind = mean_of(directions);
        EXPECT_EQ(wind.state, WindState::variable);
        EXPECT_EQ(wind.from_rad, 0);
        EXPECT_NEAR(wind.speed_mps, 10, 1e-12);
    }
    EXPECT_EQ(mean_of({0, 170}).state, WindState::steady) << "almost is not wholly";
}

TEST(Wind, MeansGivenAloneSayTheSame) {
    WindMean mean;
    for (const double direction : {80.0, 110.0, 95.0})
        mean.add(from(direction, direction).east_mps, from(direction, 7).north_mps);
    const Wind whole = mean.mean(), alone = wind_of_means(mean.east_mps(), mean.north_mps(), whole.speed_mps);
    EXPECT_EQ(alone.state, whole.state);
    EXPECT_EQ(alone.from_rad, whole.from_rad);
    EXPECT_EQ(alone.constancy, whole.constancy);
    EXPECT_EQ(wind_of_means(0.1, 0, 10).state, WindState::variable);
    EXPECT_EQ(wind_of_means(0, 0, 0).state, WindState::calm);
}

TEST(Wind, CalmHasNoDirection) {
    EXPECT_EQ(wind_of(0, 0).state, WindState::calm);
    EXPECT_EQ(mean_of({90}, 0.99 * kCalm_mps).state, WindState::calm);
    EXPECT_EQ(mean_of({90}, 1.01 * kCalm_mps).state, WindState::steady);
    EXPECT_EQ(wind_of(std::numeric_limits<double>::denorm_min(), 0).state, WindState::calm);
}

TEST(Wind, WhatIsNoNumberIsLeftOutAndCounted) {
    WindMean mean;
    EXPECT_EQ(mean.mean().state, WindState::unknown);
    mean.add(std::nan(""), 1);
    mean.add(1, std::numeric_limits<double>::infinity());
    EXPECT_EQ(mean.mean().state, WindState::unknown);
    mean.add(3, 4);
    EXPECT_EQ(mean.left_out(), 2u);
    EXPECT_EQ(mean.count(), 1u);
    EXPECT_DOUBLE_EQ(mean.mean().speed_mps, 5);
}

/// Turning all winds turns their mean.
TEST(Wind, MeansTurnWithTheCompass) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0, 360);
    const std::vector<double> directions{12, 40, 77, 350, 301};
    const double mean = mean_of(directions).from_rad;
    for (int n = 0; n < 20000; ++n) {
        const double turn = any(random);
        std::vector<double> turned;
        for (const double direction : directions) turned.push_back(direction + turn);
        ASSERT_NEAR(earth::angle_difference(mean_of(turned).from_rad, mean + radians(turn)), 0, 1e-12) << turn;
    }
}

TEST(Wind, HeadAndCrossWind) {
    const auto along = [](double direction_deg, double track_deg) {
        const Blowing wind = from(direction_deg, 10);
        return along_track(wind.east_mps, wind.north_mps, radians(track_deg));
    };
    EXPECT_NEAR(along(90, 90).head_mps, 10, 1e-12);
    EXPECT_NEAR(along(270, 90).head_mps, -10, 1e-12) << "tail wind";
    EXPECT_NEAR(along(180, 90).cross_mps, 10, 1e-12) << "from the right";
    EXPECT_NEAR(along(0, 90).cross_mps, -10, 1e-12) << "from the left";
    EXPECT_NEAR(along(30, 0).head_mps, 10 * std::cos(radians(30)), 1e-12);
    EXPECT_NEAR(along(30, 0).cross_mps, 10 * std::sin(radians(30)), 1e-12);
}

}  // namespace
}  // namespace tedavis::scene::test_wind
