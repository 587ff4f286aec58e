#include <gtest/gtest.h>

#include "host_sim/commands/command_groups.hpp"
#include "tests/host_sim/commands/parsed_commands.hpp"

namespace tedavis::host_sim::test_fly_command {
namespace {

using FlyCommand = test_support::ParsedCommands<add_fly>;

TEST_F(FlyCommand, HasThreeHundredFramesUnlessOthersAreAskedFor) {
    parse({"fly", "f.igc", "-o", "out"});
    EXPECT_EQ(line.fly.flight.flight, "f.igc");
    EXPECT_EQ(line.fly.replay.output, "out");
    EXPECT_EQ(line.fly.replay.spread, 300u);
    EXPECT_FALSE(line.fly.replay.yes);
}

TEST_F(FlyCommand, TakesFlightsTerrainAndLooks) {
    parse({"fly",       "f.json.gz", "--aircraft",      "4b1815",   "--qnh",      "1013",
           "--terrain", "a.tif",     "--terrain",       "b.tif",    "--accuracy", "16",
           "--design",  "cruise",    "--aircraft-file", "jet",      "--size",     "320x240",
           "--frames",  "50",        "--yes",           "--strict", "-o",         "out"});
    EXPECT_EQ(line.fly.flight.aircraft, "4b1815");
    EXPECT_EQ(line.fly.flight.qnh_hpa, 1013);
    EXPECT_EQ(line.fly.terrain.rasters, (std::vector<std::string>{"a.tif", "b.tif"}));
    EXPECT_EQ(line.fly.terrain.accuracy_m, 16);
    EXPECT_EQ(line.fly.replay.picture.design, "cruise");
    EXPECT_EQ(line.fly.replay.picture.aircraft, "jet");
    EXPECT_EQ(line.fly.replay.picture.size->width, 320u);
    EXPECT_EQ(line.fly.replay.spread, 50u);
    EXPECT_TRUE(line.fly.replay.yes);
    EXPECT_TRUE(line.fly.replay.strict);
}

TEST_F(FlyCommand, NeedsAFlightAndAFolder) {
    EXPECT_THROW(parse({"fly", "f.igc"}), CLI::ParseError);
    EXPECT_THROW(parse({"fly", "-o", "out"}), CLI::ParseError);
    EXPECT_THROW(parse({"fly", "f.igc", "-o", "out", "--frames", "1"}), CLI::ParseError);
}

}  // namespace
}  // namespace tedavis::host_sim::test_fly_command
