#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/commands/parsed_commands.hpp"

namespace tedavis::host_sim::test_flight_test_commands {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using FlightTestCommands = test_support::ParsedCommands<add_tests>;

TEST_F(FlightTestCommands, VerifyTakesScriptsAndParameters) {
    parse({"verify", "a.toml", "b.toml", "--set", "x=1", "--set", "y=2", "--junit", "r.xml", "-o", "out", "--json"});
    EXPECT_THAT(line.verify.scripts, ElementsAre("a.toml", "b.toml"));
    EXPECT_THAT(line.verify.parameters, ElementsAre("x=1", "y=2"));
    EXPECT_EQ(line.verify.junit, "r.xml");
    EXPECT_EQ(line.verify.output, "out");
    EXPECT_TRUE(line.json);
}

TEST_F(FlightTestCommands, VerifyNeedsNoScript) {
    parse({"verify"});
    EXPECT_THAT(line.verify.scripts, IsEmpty());
}

TEST_F(FlightTestCommands, BusEncodeTakesValues) {
    parse({"bus", "encode", "pitch_deg=-5", "phase=cruise", "--at", "2.5", "--interface", "vcan0", "--bus", "glider"});
    EXPECT_THAT(line.bus_encode.values, ElementsAre("pitch_deg=-5", "phase=cruise"));
    EXPECT_EQ(line.bus_encode.at_s, 2.5);
    EXPECT_EQ(line.bus_encode.interface_name, "vcan0");
    EXPECT_EQ(line.bus_encode.bus, "glider");
}

TEST_F(FlightTestCommands, BusEncodeNeedsAValue) { EXPECT_THROW(parse({"bus", "encode"}), CLI::ParseError); }

}  // namespace
}  // namespace tedavis::host_sim::test_flight_test_commands
