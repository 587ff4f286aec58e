#include "host_sim/commands/accuracy_flights.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_accuracy_flights {
namespace {

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

std::vector<MeasuredFlight> read(const AccuracyOptions& options) {
    std::ostringstream results, notes;
    Console console{results, notes, true, false};
    base::SerialWorkers workers;
    return read_flights(options, workers, console);
}

TEST(AccuracyFlights, ShareTheHeightsOfOneTerrain) {
    AccuracyOptions options;
    options.flights = {files().log, files().log};
    options.terrains = {files().terrain};
    const std::vector<MeasuredFlight> flights = read(options);
    ASSERT_EQ(flights.size(), 2u);
    EXPECT_EQ(flights[0].ground, flights[1].ground);
    EXPECT_EQ(flights[0].terrain, files().terrain);
    EXPECT_EQ(flights[0].recorded->log, files().log);
    EXPECT_EQ(flights[0].knob_ground(options).recorded, &*flights[0].recorded);
    const test_support::FlownFiles other;
    options.terrains = {files().terrain, other.terrain};
    const std::vector<MeasuredFlight> apart = read(options);
    EXPECT_NE(apart[0].ground, apart[1].ground) << "control: each has its own terrain";
}

TEST(AccuracyFlights, WithoutAFlightTheTerrainIsThatOfTheShippedOne) {
    AccuracyOptions options;
    options.terrains = {files().terrain};
    const std::vector<MeasuredFlight> flights = read(options);
    ASSERT_EQ(flights.size(), 1u);
    EXPECT_FALSE(flights[0].recorded.has_value());
    EXPECT_EQ(flights[0].knob_ground(options).recorded, nullptr);
}

TEST(AccuracyFlights, RefuseWhatDoesNotBelongTogether) {
    AccuracyOptions options;
    options.flights = {"a.log", "b.log", "c.log"};
    options.terrains = {"a.tdb", "b.tdb"};
    test_support::expect_user_error([&] { require_pairs(options); }, "--terrain: was given 2 times for 3 flights");
    options.terrains = {"a.tdb"};
    options.switches = {"a", "b", "c"};
    require_pairs(options);
    options.switches.emplace_back("d");
    test_support::expect_user_error([&] { require_pairs(options); }, "--switches d: has no --flight");
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_flights
