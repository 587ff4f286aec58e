#include "host_sim/importers/fix_cleaner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim::test_fix_cleaner {
namespace {

/// North at 50 m/s, one fix a second, climbing at 3 m/s.
RecordedFlight steady_flight(int fixes) {
    RecordedFlight flight;
    for (int i = 0; i < fixes; ++i) {
        RecordedFix fix;
        fix.time = base::Time{i * std::int64_t{1'000'000'000}};
        fix.latitude_rad = base::radians(46.0) + 50.0 * i / 6.36e6;
        fix.longitude_rad = base::radians(9.0);
        fix.gnss_height_m = 1000 + 3.0 * i;
        fix.pressure_altitude_m = 980 + 3.0 * i;
        flight.fixes.push_back(fix);
    }
    return flight;
}

TEST(FixCleaner, LeavesACleanFlightAlone) {
    RecordedFlight flight = steady_flight(100);
    const CleaningCounts counts = clean_fixes(flight);
    EXPECT_EQ(flight.fixes.size(), 100u);
    EXPECT_EQ(counts.out_of_order + counts.duplicates + counts.position_jumps + counts.gnss_height_jumps + counts.pressure_jumps,
              0u);
}

TEST(FixCleaner, SortsAndDropsDuplicates) {
    RecordedFlight flight = steady_flight(20);
    std::swap(flight.fixes[5], flight.fixes[9]);
    flight.fixes.push_back(flight.fixes[3]);
    const CleaningCounts counts = clean_fixes(flight);
    EXPECT_EQ(flight.fixes.size(), 20u);
    EXPECT_EQ(counts.duplicates, 1u);
    EXPECT_GT(counts.out_of_order, 0u);
    EXPECT_TRUE(
        std::is_sorted(flight.fixes.begin(), flight.fixes.end(), [](const auto& a, const auto& b) { return a.time < b.time; }));
}

TEST(FixCleaner, DropsJumpsThatComeBack) {
    RecordedFlight flight = steady_flight(60);
    flight.fixes[20].latitude_rad += base::radians(0.05);
    flight.fixes[40].longitude_rad += base::radians(0.1);
    flight.fixes[41].longitude_rad += base::radians(0.1);
    const CleaningCounts counts = clean_fixes(flight);
    EXPECT_EQ(counts.position_jumps, 3u);
    EXPECT_EQ(flight.fixes.size(), 57u);
}

TEST(FixCleaner, BelievesAMoveThatLasts) {
    RecordedFlight flight = steady_flight(60);
    for (std::size_t i = 30; i < 60; ++i) flight.fixes[i].latitude_rad += base::radians(0.05);
    const CleaningCounts counts = clean_fixes(flight);
    EXPECT_EQ(counts.position_jumps, 0u);
    EXPECT_EQ(flight.fixes.size(), 60u);
}

TEST(FixCleaner, EmptiesHeightOutliersAndKeepsTheFix) {
    RecordedFlight flight = steady_flight(60);
    *flight.fixes[10].gnss_height_m += 91;
    *flight.fixes[11].gnss_height_m += 91;
    *flight.fixes[30].pressure_altitude_m -= 91;
    const CleaningCounts counts = clean_fixes(flight);
    EXPECT_EQ(counts.gnss_height_jumps, 2u);
    EXPECT_EQ(counts.pressure_jumps, 1u);
    EXPECT_EQ(flight.fixes.size(), 60u);
    EXPECT_FALSE(flight.fixes[10].gnss_height_m);
    EXPECT_TRUE(flight.fixes[10].pressure_altitude_m);
}

TEST(FixCleaner, ADescentGoesOnThroughAPauseOfTheRecording) {
    RecordedFlight flight = steady_flight(60);
    for (std::size_t i = 0; i < 60; ++i) {
        const double pause_s = i < 30 ? 0 : 12;
        flight.fixes[i].time = flight.fixes[i].time + base::Duration::from_seconds(pause_s);
        flight.fixes[i].latitude_rad += 50.0 * pause_s / 6.36e6;
        flight.fixes[i].gnss_height_m = 3000 - 9 * (static_cast<double>(i) + pause_s);
    }
    EXPECT_EQ(clean_fixes(flight).gnss_height_jumps, 0u);
    *flight.fixes[31].gnss_height_m += 180;
    EXPECT_EQ(clean_fixes(flight).gnss_height_jumps, 1u) << "a control";
}

TEST(FixCleaner, SurvivesVeryShortFlights) {
    for (int count : {0, 1, 2}) {
        RecordedFlight flight = steady_flight(count);
        (void)clean_fixes(flight);
        EXPECT_EQ(flight.fixes.size(), static_cast<std::size_t>(count));
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_fix_cleaner
