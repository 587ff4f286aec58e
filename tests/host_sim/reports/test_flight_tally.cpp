#include "host_sim/reports/flight_tally.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/flights/frame_result.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_flight_tally {
namespace {

using ::testing::HasSubstr;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

const terrain::TerrainDatabase& database() {
    static const test_support::BuiltDatabase kBuilt(test_support::make_rough_raster(65, 65));
    return kBuilt.database;
}

/// Over terrain that has arrived.
display::FrameRecord frame(double time_s, std::initializer_list<const char*> flags = {}) {
    display::FrameRecord record = test_support::frame_result(0, time_s).record;
    record.terrain.pending = 0;
    for (const char* flag : flags) EXPECT_TRUE(record.flags.try_push_back(display::Name(flag)));
    return record;
}

Findings found(const FlightTally& tally) { return tally.findings("X.tdb", &database()); }

TEST(FlightTally, AFlightOverItsTerrainHasNoFindings) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 5; ++n) tally.add(frame(n), 300);
    EXPECT_TRUE(found(tally).empty());
    EXPECT_EQ(tally.worst_error_px(), 0.75);
    EXPECT_EQ(tally.worst_start_error_px(), 0);
}

TEST(FlightTally, FramesOutsideAreCountedAndTheTimeInsideIsTold) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 10; ++n) {
        const bool is_outside = n < 3 || n > 6;
        tally.add(is_outside ? frame(100 + n, {"terrain.outside_database"}) : frame(100 + n), 300);
    }
    const Findings findings = found(tally);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "terrain.outside");
    EXPECT_EQ(findings[0].text, "6 of 10 frames lie outside X.tdb; inside: 103 - 106 s");
    EXPECT_EQ(findings[0].count, 6u);
    EXPECT_TRUE(tally.findings("", nullptr).empty()) << "without terrain nothing lies outside of it";
}

TEST(FlightTally, ARunBackwardsTellsTheSameTime) {
    FlightTally tally(base::Time{});
    for (int n = 9; n >= 0; --n) tally.add(n < 3 ? frame(n, {"terrain.outside_database"}) : frame(n), 300);
    EXPECT_THAT(found(tally)[0].text, HasSubstr("3 of 10 frames lie outside X.tdb; inside: 3 - 9 s"));
}

TEST(FlightTally, AFlightWhollyOutsideSaysWhereBothLie) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 4; ++n) tally.add(frame(n, {"terrain.outside_database"}), kUnknown);
    const Findings findings = found(tally);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].text, "all 4 frames lie outside X.tdb: it covers " + extent_of(database()).words() +
                                    ", the flight 46.500 .. 46.500 N, 9.750 .. 9.750 E");
}

TEST(FlightTally, ManySpansAreCountedBeyondTheThird) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 12; ++n) tally.add(n % 2 == 0 ? frame(n, {"terrain.outside_database"}) : frame(n), 300);
    EXPECT_THAT(found(tally)[0].text, HasSubstr("inside: 1 - 1 s, 3 - 3 s, 5 - 5 s and 3 more spans"));
}

TEST(FlightTally, AFlightBelowTheGroundOrNowhereIsSaid) {
    FlightTally below(base::Time{});
    below.add(frame(0), 20);
    below.add(frame(1.5, {"terrain.above_own_ship"}), -12);
    below.add(frame(2, {"terrain.above_own_ship"}), -35.4);
    const Findings findings = found(below);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "terrain.above_own_ship");
    EXPECT_EQ(findings[0].text, "2 of 3 frames lie below the ground of X.tdb, first at 1.5 s, at most by 35 m");
    FlightTally lost(base::Time{});
    display::FrameRecord nowhere = frame(0);
    nowhere.own_ship.state = base::SignalState::lost;
    lost.add(nowhere, kUnknown);
    ASSERT_EQ(found(lost).size(), 1u);
    EXPECT_EQ(found(lost)[0].name, "flight.no_position");
}

display::FrameRecord arriving(double time_s, double error_px, std::uint32_t pending,
                              std::initializer_list<const char*> flags = {}) {
    display::FrameRecord record = frame(time_s, flags);
    record.terrain.worst_error_px = error_px;
    record.terrain.pending = pending;
    return record;
}

TEST(FlightTally, ErrorsWhileTheFirstChunksArriveStandBeside) {
    FlightTally tally(base::Time{});
    display::FrameRecord without_terrain = frame(0);
    without_terrain.terrain = {};
    tally.add(without_terrain, 300);
    tally.add(arriving(1, 431299, 40, {"terrain.coarse"}), 300);
    tally.add(arriving(2, 12, 3, {"terrain.coarse"}), 300);
    tally.add(arriving(3, 0.9, 0), 300);
    tally.add(arriving(4, 2.5, 5), 300);
    EXPECT_EQ(tally.worst_error_px(), 2.5) << "what arrives late in flight counts";
    EXPECT_EQ(tally.worst_start_error_px(), 431299);
    const Findings findings = found(tally);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "terrain.start_error");
    EXPECT_THAT(findings[0].text,
                HasSubstr("2 frames from 1.0 s on showed terrain coarser than the design allows, up to 431299 px"));
}

TEST(FlightTally, AVoidBelowTheFlightIsTold) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 4; ++n) tally.add(frame(n), n < 3 ? kUnknown : 300);
    ASSERT_EQ(found(tally).size(), 1u);
    EXPECT_EQ(found(tally)[0].name, "terrain.no_height");
    EXPECT_EQ(found(tally)[0].text, "3 of 4 frames lie over ground without a height in X.tdb (void or damaged)");
}

TEST(FlightTally, TerrainThatIsNeverShownIsTold) {
    FlightTally tally(base::Time{}), control(base::Time{});
    for (int n = 0; n < 4; ++n) {
        display::FrameRecord record = frame(n);
        control.add(record, 300);
        record.terrain.limit = display::Name();
        tally.add(record, 300);
    }
    EXPECT_EQ(tally.frames_with_terrain(), 0u);
    ASSERT_EQ(found(tally).size(), 1u);
    EXPECT_EQ(found(tally)[0].name, "terrain.never_shown");
    EXPECT_EQ(control.frames_with_terrain(), 4u);
    EXPECT_TRUE(found(control).empty());
}

/// Look-ahead may want more than there is room for: that is no start.
TEST(FlightTally, AStartEndsAfterTwoSeconds) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 10; ++n) {
        display::FrameRecord record = frame(n);
        record.terrain.pending = 3;
        record.terrain.worst_error_px = n < 3 ? 50 : 2;
        tally.add(record, 300);
    }
    EXPECT_EQ(tally.worst_start_error_px(), 50);
    EXPECT_EQ(tally.worst_error_px(), 2);
    FlightTally failing(base::Time{});
    display::FrameRecord record = frame(0, {"terrain.failing"});
    record.terrain.pending = 1;
    record.terrain.worst_error_px = 7;
    failing.add(record, 300);
    EXPECT_EQ(failing.worst_error_px(), 7) << "what cannot be had does not arrive";
}

TEST(FlightTally, StaleDataAreToldByLayerWithTheirAge) {
    FlightTally tally(base::Time{});
    for (int n = 0; n < 4; ++n) {
        display::FrameRecord record = frame(n);
        if (n > 0) EXPECT_TRUE(record.stale.try_push_back({"wind", 74 * 86400.0 + n}));
        if (n == 2) EXPECT_TRUE(record.stale.try_push_back({"radar", 2400}));
        tally.add(record, 300);
    }
    const Findings findings = found(tally);
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].name, "data.stale");
    EXPECT_EQ(findings[0].text, "the layer radar is stale in 1 frame of 4, at most 40 min old");
    EXPECT_EQ(findings[1].text, "the layer wind is stale in 3 frames of 4, at most 74 d old");
    EXPECT_EQ(findings[1].count, 3u);
}

TEST(FlightTally, AStartThatShowsNoTerrainMisleadsNobody) {
    FlightTally tally(base::Time{});
    tally.add(arriving(1, 431299, 40, {"terrain.too_coarse"}), 300);
    tally.add(arriving(2, 0.9, 0), 300);
    EXPECT_EQ(tally.worst_start_error_px(), 431299);
    EXPECT_TRUE(found(tally).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_tally
