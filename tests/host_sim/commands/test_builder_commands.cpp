#include "tests/host_sim/commands/parsed_commands.hpp"

namespace tedavis::host_sim::test_builder_commands {
namespace {

using Builders = test_support::ParsedCommands<add_builders>;

TEST_F(Builders, OptionsReachTheirCommand) {
    parse({"terrain", "build", "a.tif", "b.tif", "-o", "x.tdb", "--bounds", "1,2,3,4", "--void", "-9999", "--accuracy", "16"});
    EXPECT_EQ(line.terrain_build.rasters, (std::vector<std::string>{"a.tif", "b.tif"}));
    EXPECT_EQ(line.terrain_build.output, "x.tdb");
    EXPECT_EQ(line.terrain_build.bounds, "1,2,3,4");
    EXPECT_EQ(line.terrain_build.void_value, -9999);
    EXPECT_EQ(line.terrain_build.accuracy_m, 16);
    EXPECT_TRUE(static_cast<bool>(line.run));
}

TEST_F(Builders, TheCacheIsClearedOnlyWhereAsked) {
    parse({"terrain", "cache"});
    EXPECT_FALSE(line.terrain_cache.clear);
    parse({"terrain", "cache", "--clear"});
    EXPECT_TRUE(line.terrain_cache.clear);
}

TEST_F(Builders, ALogOfAFlightHasItsAltimeterSetting) {
    parse({"convert", "f.igc", "-o", "f.log", "--qnh", "1013.2", "--json"});
    EXPECT_EQ(line.convert.flight, "f.igc");
    EXPECT_EQ(line.convert.qnh_hpa, 1013.2);
    EXPECT_FALSE(line.convert.assume_geometric);
    EXPECT_TRUE(line.json);
}

TEST_F(Builders, WhatIsNoChoiceIsRefused) {
    EXPECT_THROW(parse({"terrain", "build", "a.tif", "-o", "x.tdb", "--vertical-datum", "nap"}), CLI::ParseError);
    EXPECT_THROW(parse({"terrain", "fractal", "--type", "int8", "-o", "x.tif"}), CLI::ParseError);
    EXPECT_THROW(parse({"scenario", "build", "default"}), CLI::ParseError) << "no folder";
    EXPECT_THROW(parse({"scene"}), CLI::ParseError);
}

}  // namespace
}  // namespace tedavis::host_sim::test_builder_commands
