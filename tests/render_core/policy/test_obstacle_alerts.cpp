#include "render_core/policy/obstacle_alerts.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tedavis::policy::test_obstacle_alerts {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(ObstacleAlerts, EachHasTheLevelOfItsTimeAndAllThatOfTheSoonest) {
    ObstacleAlerts alerts;
    EXPECT_EQ(alerts.level(), TerrainAhead::none);
    alerts.add(2, 7, 45, kNever);
    EXPECT_EQ(alerts.level(), TerrainAhead::caution);
    alerts.add(2, 3, 20, kNever);
    alerts.add(4, 7, 61, kNever);
    alerts.add(4, 8, kNever, kNever);
    EXPECT_EQ(alerts.level(), TerrainAhead::warning);
    EXPECT_EQ(alerts.soonest_s(), 20);
    EXPECT_EQ(alerts.count(), 2u);
    EXPECT_EQ(alerts.of(2, 7), TerrainAhead::caution);
    EXPECT_EQ(alerts.of(2, 3), TerrainAhead::warning);
    EXPECT_EQ(alerts.of(4, 7), TerrainAhead::none) << "beyond a minute";
    EXPECT_EQ(alerts.of(3, 3), TerrainAhead::none) << "of another layer";
}

/// As straight ahead in a turn.
TEST(ObstacleAlerts, AnObstacleIsJudgedByWhatCountsAndSaysItsTime) {
    ObstacleAlerts alerts;
    alerts.add(2, 7, kNever, 20);
    alerts.add(2, 8, 35, kNever);
    alerts.add(2, 9, kNever, 31);
    alerts.add(2, 6, 50, 45);
    EXPECT_EQ(alerts.level(), TerrainAhead::caution);
    EXPECT_EQ(alerts.all()[0].feature, 8u);
    EXPECT_EQ(alerts.all()[1].seconds(), 20);
    EXPECT_EQ(alerts.all()[2].seconds(), 50) << "on the predicted track";
    EXPECT_EQ(alerts.count(), 3u) << "one counts for more than a minute";
}

TEST(ObstacleAlerts, TheSoonestAreKeptAndAllAreCounted) {
    ObstacleAlerts alerts;
    constexpr std::uint32_t kAll = 200;
    for (std::uint32_t n = 0; n < kAll; ++n) alerts.add(0, n, 59.0 - n * 0.25, kNever);
    EXPECT_EQ(alerts.count(), kAll);
    ASSERT_EQ(alerts.all().size(), ObstacleAlerts::kMax);
    EXPECT_EQ(alerts.all()[0].feature, kAll - 1);
    for (std::size_t n = 1; n < alerts.all().size(); ++n) EXPECT_GE(alerts.all()[n].counted_s(), alerts.all()[n - 1].counted_s());
    EXPECT_EQ(alerts.of(0, kAll - 1), TerrainAhead::warning);
    EXPECT_EQ(alerts.of(0, 0), TerrainAhead::none) << "control: there was no room for it";
}

/// What is drawn anew follows from it.
TEST(ObstacleAlerts, TheKeyIsOfLevelsNotOfTimes) {
    ObstacleAlerts first, later, nearer, other;
    EXPECT_EQ(first.key(), 0u);
    first.add(1, 5, 45, kNever), first.add(1, 6, 40, kNever);
    later.add(1, 5, 38, kNever), later.add(1, 6, 39, kNever);
    nearer.add(1, 5, 45, kNever), nearer.add(1, 6, 29, kNever);
    other.add(1, 5, 45, kNever), other.add(2, 6, 40, kNever);
    EXPECT_EQ(first.key(), later.key());
    EXPECT_NE(first.key(), nearer.key());
    EXPECT_NE(first.key(), other.key());
}

}  // namespace
}  // namespace tedavis::policy::test_obstacle_alerts
