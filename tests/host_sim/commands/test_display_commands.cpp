#include "tests/host_sim/commands/parsed_commands.hpp"

namespace tedavis::host_sim::test_display_commands {
namespace {

using Displays = test_support::ParsedCommands<add_displays>;

TEST_F(Displays, OptionsReachTheSweep) {
    EXPECT_EQ(line.sweep.rings.bearings, 8u);
    parse({"sweep",       "--around",  "36.6,-84.2,400", "--radius",    "100",      "--bearings", "12",
           "--distances", "1000,2500", "--heights",      "-20,300,900", "--design", "cruise",     "--terrain",
           "x.tdb",       "--phase",   "cruise",         "--layers",    "-o",       "out"});
    ASSERT_TRUE(line.sweep.place.has_value());
    EXPECT_EQ(line.sweep.place->altitude_msl_m, 400);
    EXPECT_EQ(line.sweep.radius_m, 100);
    EXPECT_EQ(line.sweep.rings.bearings, 12u);
    EXPECT_EQ(line.sweep.rings.distances_m, (std::vector<double>{1000, 2500}));
    EXPECT_EQ(line.sweep.rings.heights_m, (std::vector<double>{-20, 300, 900}));
    EXPECT_EQ(line.sweep.picture.design, "cruise");
    EXPECT_EQ(line.sweep.phase, "cruise");
    EXPECT_TRUE(line.sweep.layers);
    EXPECT_THROW(parse({"sweep", "-o", "out", "--distances", "5"}), UserError);
    EXPECT_THROW(parse({"sweep", "-o", "out", "--bearings", "0"}), CLI::ParseError);
    EXPECT_THROW(parse({"sweep"}), CLI::ParseError) << "no folder";
}

TEST_F(Displays, ProgramsAreForTheDeviceWithoutACompiler) {
    EXPECT_EQ(line.shaders.picture.device, "sc2");
    parse({"shaders", "-o", "p", "--design", "cruise"});
    EXPECT_EQ(line.shaders.output, "p");
    EXPECT_EQ(line.shaders.picture.design, "cruise");
}

TEST_F(Displays, OptionsReachThePlanOfADevice) {
    parse({"device", "plan", "--size", "800x480", "--memory", "64M", "--design", "cruise", "--lane", "es3", "--rate", "20",
           "--scene", "s.sdb", "--terrain", "t.tdb", "-o", "d.toml"});
    ASSERT_TRUE(line.device_plan.picture.size.has_value());
    EXPECT_EQ(line.device_plan.picture.size->width, 800u);
    EXPECT_EQ(line.device_plan.memory, "64M");
    EXPECT_EQ(line.device_plan.picture.design, "cruise");
    EXPECT_EQ(line.device_plan.picture.scene, "s.sdb");
    EXPECT_EQ(line.device_plan.picture.terrain, "t.tdb");
    EXPECT_EQ(line.device_plan.lane, effects::Lane::es3);
    EXPECT_EQ(line.device_plan.rate_hz, 20);
    EXPECT_THROW(parse({"device", "plan", "--size", "800x480", "-o", "d.toml"}), CLI::ParseError) << "no memory";
    EXPECT_THROW(parse({"device"}), CLI::ParseError);
}

TEST_F(Displays, WhatCannotStandTogetherIsRefused) {
    EXPECT_THROW(parse({"shot", "--pose", "47,9,2000,0,0,0", "-o", "x.png", "--gl", "metal"}), UserError);
    EXPECT_THROW(parse({"shaders"}), CLI::ParseError);
    EXPECT_THROW(parse({"shot", "-o", "x.png"}), CLI::ParseError) << "no pose";
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_commands
