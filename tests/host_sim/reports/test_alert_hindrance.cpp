#include "host_sim/reports/alert_hindrance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "render_core/policy/flag_table.hpp"
#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_alert_hindrance {
namespace {

display::FrameRecord flagged(std::initializer_list<const char*> flags = {}) {
    display::FrameRecord record = test_support::frame_result(0, 0).record;
    record.alerts.height_above_terrain_m = 300;
    for (const char* flag : flags) EXPECT_TRUE(record.flags.try_push_back(display::Name(flag)));
    return record;
}

TEST(AlertHindrance, NothingHindersAWatchedFlight) {
    EXPECT_EQ(hindrance_of(flagged()), AlertHindrance::none);
    EXPECT_EQ(hindrance_of(flagged({"terrain.ends", "vertical_accuracy.assumed", "own_ship.height_on_qnh", "heading.lost"})),
              AlertHindrance::none)
        << "these change what is drawn alone";
}

TEST(AlertHindrance, EachFlagHasItsReason) {
    using base::SignalState;
    EXPECT_EQ(hindrance_of(flagged({"terrain.missing", "terrain.degraded"})), AlertHindrance::no_terrain);
    EXPECT_EQ(hindrance_of(flagged({"terrain.failed"})), AlertHindrance::terrain_failed);
    EXPECT_EQ(hindrance_of(flagged({"terrain.outside_database"})), AlertHindrance::outside);
    EXPECT_EQ(hindrance_of(flagged({"terrain.above_own_ship"})), AlertHindrance::below_surface);
    for (const char* flag : {"terrain.degraded", "own_ship.height_not_geometric", "vertical_accuracy.above_limit",
                             "horizontal_accuracy.above_limit", "vertical_accuracy.lost", "horizontal_accuracy.stale"})
        EXPECT_EQ(hindrance_of(flagged({flag})), AlertHindrance::degraded) << flag;
    display::FrameRecord record = flagged();
    record.alerts.height_above_terrain_m = std::nan("");
    EXPECT_EQ(hindrance_of(record), AlertHindrance::unknown_ground);
    for (const SignalState state : {SignalState::stale, SignalState::lost, SignalState::missing, SignalState::invalid}) {
        record.own_ship.state = state;
        EXPECT_EQ(hindrance_of(record), AlertHindrance::no_position);
    }
}

TEST(AlertHindrance, AnAlertWasPossibleWhereItWasGiven) {
    display::FrameRecord record = flagged({"terrain.outside_database"});
    record.alerts.terrain = policy::TerrainAhead::caution;
    EXPECT_EQ(hindrance_of(record), AlertHindrance::none) << "the track came back over the database";
}

/// A flag that is renamed must not make alerts possible.
TEST(AlertHindrance, ItsFlagsAreThoseOfTheTable) {
    using policy::RecordFlag;
    for (const auto& [flag, name] : {std::pair{RecordFlag::terrain_missing, "terrain.missing"},
                                     {RecordFlag::terrain_failed, "terrain.failed"},
                                     {RecordFlag::terrain_outside_database, "terrain.outside_database"},
                                     {RecordFlag::terrain_above_own_ship, "terrain.above_own_ship"},
                                     {RecordFlag::terrain_degraded, "terrain.degraded"},
                                     {RecordFlag::own_ship_height_not_geometric, "own_ship.height_not_geometric"},
                                     {RecordFlag::horizontal_accuracy_above_limit, "horizontal_accuracy.above_limit"},
                                     {RecordFlag::vertical_accuracy_above_limit, "vertical_accuracy.above_limit"}})
        EXPECT_EQ(policy::name_of(flag), name);
}

TEST(AlertHindrance, EachHasANameAndWords) {
    std::set<std::string> names, words;
    for (std::size_t n = 0; n < kAlertHindranceCount; ++n) {
        names.insert(name_of(static_cast<AlertHindrance>(n)));
        words.insert(words_of(static_cast<AlertHindrance>(n)));
    }
    EXPECT_EQ(names.size(), kAlertHindranceCount);
    EXPECT_EQ(words.size(), kAlertHindranceCount);
}

}  // namespace
}  // namespace tedavis::host_sim::test_alert_hindrance
