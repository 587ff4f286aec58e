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

TEST_F(FlightTestCommands, RecordTakesALogAndWhatItIsShownWith) {
    parse({"record",   "a.log",  "--switches", "a.switches", "--switch-config", "coded",  "--bus",     "b.toml",
           "--design", "cruise", "--device",   "es3-mid",    "--aircraft",      "glider", "--terrain", "t.tdb",
           "--scene",  "s.sdb",  "-o",         "s.toml",     "--from",          "2",      "--to",      "9",
           "--margin", "0.2",    "--yes"});
    const RecordOptions& o = line.record;
    EXPECT_THAT((std::vector<std::string>{o.input, o.switches, o.switch_config, o.bus, o.design, o.device, o.aircraft, o.terrain,
                                          o.scene, o.output}),
                ElementsAre("a.log", "a.switches", "coded", "b.toml", "cruise", "es3-mid", "glider", "t.tdb", "s.sdb", "s.toml"));
    EXPECT_EQ(o.from_s, 2.0);
    EXPECT_EQ(o.to_s, 9.0);
    EXPECT_EQ(o.margin_s, 0.2);
    EXPECT_TRUE(o.yes);
}

TEST_F(FlightTestCommands, RecordTakesTimesOrASpan) {
    parse({"record", "a.log", "-o", "s.toml", "--at", "3", "--at", "4"});
    EXPECT_THAT(line.record.at_s, ElementsAre(3, 4));
    EXPECT_THROW(parse({"record", "a.log", "-o", "s.toml", "--at", "3", "--to", "4"}), CLI::ParseError);
    EXPECT_NO_THROW(parse({"record", "--target", "/run/records", "-o", "s.toml"})) << "a display is recorded without a log";
    EXPECT_THROW(parse({"record", "a.log"}), CLI::ParseError);
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_test_commands
