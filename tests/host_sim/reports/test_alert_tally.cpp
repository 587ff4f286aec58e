#include "host_sim/reports/alert_tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/policy/terrain_ahead.hpp"
#include "render_core/scene/ground.hpp"

namespace tedavis::host_sim::test_alert_tally {
namespace {

constexpr double kLatitude = base::radians(46.8), kLongitude = base::radians(9.8);
constexpr double kPlain_m = 300, kSpeed_mps = 70;

/// A wall of a height that begins so far to the north, over a plain.
class Wall final : public scene::Ground, public policy::GroundBound {
public:
    Wall(double from_m, double top_m) : from_m_(from_m), top_m_(top_m) {}
    double height_m(double latitude_rad, double) override { return north_m(latitude_rad) > from_m_ ? top_m_ : kPlain_m; }
    double undulation_m(double, double) override { return 0; }
    double highest_m(double latitude_rad, double, double radius_m, double) override {
        return north_m(latitude_rad) + radius_m > from_m_ ? top_m_ : kPlain_m;
    }

private:
    [[nodiscard]] static double north_m(double latitude_rad) {
        return (latitude_rad - kLatitude) * earth::meridian_radius_m(kLatitude);
    }
    double from_m_, top_m_;
};

/// To the north, 700 m over the plain; from a place on it turns back.
struct Flight {
    double turns_at_m = 1e9;
    double until_s = 150, step_s = 0.5;

    [[nodiscard]] AlertTally over(Wall& wall) const {
        AlertTally tally;
        double north_m = 0, east_m = 0, direction_rad = 0;
        for (double seconds = 0; seconds < until_s; seconds += step_s) {
            const bool turns = north_m > turns_at_m && direction_rad < base::kPi;
            const double turn_radps = turns ? base::radians(6) : 0;
            tally.add(record(seconds, north_m, east_m, direction_rad, turn_radps, wall));
            north_m += kSpeed_mps * std::cos(direction_rad) * step_s;
            east_m += kSpeed_mps * std::sin(direction_rad) * step_s;
            direction_rad += turn_radps * step_s;
        }
        return tally;
    }

    [[nodiscard]] static display::FrameRecord record(double seconds, double north_m, double east_m, double direction_rad,
                                                     double turn_radps, Wall& wall) {
        policy::TerrainWatchInput input;
        input.track = {{kLatitude + north_m / earth::meridian_radius_m(kLatitude),
                        kLongitude + east_m / (earth::prime_vertical_radius_m(kLatitude) * std::cos(kLatitude)),
                        {1000}},
                       kSpeed_mps * std::cos(direction_rad),
                       kSpeed_mps * std::sin(direction_rad),
                       0,
                       turn_radps};
        input.phase = {flight::Scenario::cruise, 0};
        policy::TerrainWatch watch(input, wall, wall);
        display::FrameRecord made;
        made.time = base::Time{} + base::Duration::from_seconds(seconds);
        made.alerts.terrain = watch.ahead();
        made.alerts.is_watching = watch.is_watching();
        made.alerts.clearance_m = watch.clearance_m();
        const earth::Geodetic& at = input.track.from;
        made.alerts.height_above_terrain_m = at.height.m - wall.height_m(at.latitude_rad, at.longitude_rad);
        return made;
    }
};

/// A wall of 900 m is crossed 100 m above it, where 700 ft are required.
TEST(AlertTally, AViolationThatIsFlownConfirmsItsAlert) {
    Wall wall(7000, 900);
    const TerrainAlertCounts counts = Flight{}.over(wall).counts();
    EXPECT_EQ(counts.count, 1u);
    EXPECT_EQ(counts.false_count, 0u);
    EXPECT_EQ(counts.warnings, 1u);
    EXPECT_EQ(counts.false_warnings, 0u);
    EXPECT_NEAR(counts.seconds_caution, 30, 6) << "from a minute to half a minute before it";
    EXPECT_GT(counts.seconds_warning, 30);
    EXPECT_NEAR(counts.hours, 150 / 3600.0, 1e-9);
    EXPECT_EQ(counts.false_per_hour(), 0);
}

/// A wall that is higher than the flight, left by a turn 2 km before it.
TEST(AlertTally, AWallThatIsLeftByATurnWasAFalseAlert) {
    Wall wall(7000, 1500);
    Flight flight;
    flight.turns_at_m = 4900;
    const TerrainAlertCounts counts = flight.over(wall).counts();
    EXPECT_EQ(counts.count, 1u);
    EXPECT_EQ(counts.false_count, 1u);
    EXPECT_NEAR(counts.false_per_hour(), 3600 / 150.0, 1e-6);
    EXPECT_GT(counts.seconds_caution, 20);
    flight.turns_at_m = 6900;
    EXPECT_EQ(flight.over(wall).counts().false_count, 0u) << "control: the turn came too late";
}

TEST(AlertTally, AFlightOverAPlainHasNone) {
    Wall wall(1e9, 1500);
    const TerrainAlertCounts counts = Flight{}.over(wall).counts();
    EXPECT_EQ(counts.count, 0u);
    EXPECT_EQ(counts.seconds_caution + counts.seconds_warning, 0);
}

display::FrameRecord frame(double seconds, policy::TerrainAhead level, double height_m, bool is_watching = true) {
    display::FrameRecord record;
    record.time = base::Time{} + base::Duration::from_seconds(seconds);
    record.alerts.terrain = level;
    record.alerts.height_above_terrain_m = height_m;
    record.alerts.clearance_m = 100;
    record.alerts.is_watching = is_watching;
    return record;
}

/// Caution at 0 s, warning at 5 s.
TerrainAlertCounts with_low(double low_s, bool lands = false) {
    AlertTally tally;
    for (int seconds = 0; seconds < 90; ++seconds) {
        const policy::TerrainAhead level = seconds < 5    ? policy::TerrainAhead::caution
                                           : seconds < 10 ? policy::TerrainAhead::warning
                                                          : policy::TerrainAhead::none;
        tally.add(frame(seconds, level, seconds >= low_s ? 50 : 300, !lands || seconds < 20));
    }
    return tally.counts();
}

TEST(AlertTally, CautionsLookAMinuteAheadAndWarningsHalfOfIt) {
    EXPECT_EQ(with_low(30).false_warnings, 0u);
    EXPECT_EQ(with_low(50).false_warnings, 1u);
    EXPECT_EQ(with_low(50).false_count, 0u);
    EXPECT_EQ(with_low(80).false_count, 1u);
    EXPECT_EQ(with_low(30, true).false_count, 1u) << "it landed before";
    EXPECT_DOUBLE_EQ(with_low(80).seconds_caution, 5);
    EXPECT_DOUBLE_EQ(with_low(80).seconds_warning, 5);
}

/// Twelve minutes, a frame a second: degraded in the first nine.
TEST(AlertTally, CountsWhereAlertsWerePossible) {
    AlertTally tally;
    for (int seconds = 0; seconds < 720; ++seconds) {
        display::FrameRecord record = frame(seconds, policy::TerrainAhead::none, 300);
        record.own_ship.state = base::SignalState::valid;
        EXPECT_TRUE(seconds >= 540 || record.flags.try_push_back(display::Name("terrain.degraded")));
        tally.add(record);
    }
    const TerrainAlertCounts counts = tally.counts();
    EXPECT_NEAR(counts.possible_hours(), 180 / 3600.0, 1e-9);
    EXPECT_NEAR(counts.hours, 720 / 3600.0, 1e-9);
    EXPECT_EQ(counts.possible_frames(), 180u);
    EXPECT_EQ(counts.frames(), 720u);
    const auto degraded = static_cast<std::size_t>(AlertHindrance::degraded);
    EXPECT_EQ(counts.frames_by[degraded], 540u);
    EXPECT_NEAR(counts.hours_by[degraded], 540 / 3600.0, 1e-9);
    EXPECT_FALSE(counts.has_gaps);
}

TEST(AlertTally, FramesFarApartHaveNoTime) {
    AlertTally tally;
    for (int n = 0; n < 5; ++n) tally.add(frame(60.0 * n, policy::TerrainAhead::none, 300));
    EXPECT_TRUE(tally.counts().has_gaps);
    EXPECT_EQ(tally.counts().frames(), 5u);
    EXPECT_EQ(tally.counts().possible_frames(), 0u) << "no position is valid";
}

}  // namespace
}  // namespace tedavis::host_sim::test_alert_tally
