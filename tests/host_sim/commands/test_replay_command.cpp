#include <sstream>

#include "tests/host_sim/commands/parsed_commands.hpp"

namespace tedavis::host_sim::test_replay_command {
namespace {

using ReplayCommand = test_support::ParsedCommands<add_replay>;

TEST_F(ReplayCommand, OptionsReachTheReplay) {
    parse({"replay",     "f.log", "--terrain", "x.tdb", "--size",   "320x240", "--gl",     "osmesa",
           "--from",     "2.5",   "--step",    "-1",    "--frames", "hash",    "--ledger", "--force-effects",
           "--saliency", "heat",  "--clutter", "edges", "--legend", "whole",   "-o",       "run"});
    EXPECT_EQ(line.replay.log, "f.log");
    EXPECT_EQ(line.replay.picture.legend, flight::LegendShow::whole);
    EXPECT_EQ(line.replay.picture.terrain, "x.tdb");
    ASSERT_TRUE(line.replay.picture.size.has_value());
    EXPECT_EQ(line.replay.picture.size->width, 320u);
    EXPECT_EQ(line.replay.picture.gl, GlChoice::osmesa);
    EXPECT_EQ(line.replay.from_s, 2.5);
    EXPECT_EQ(line.replay.step_s, -1);
    EXPECT_EQ(line.replay.frame_output(), FrameOutput::hash);
    EXPECT_TRUE(line.replay.ledger);
    EXPECT_TRUE(line.replay.picture.force_effects);
    EXPECT_EQ(line.replay.picture.saliency, design::SaliencyView::heat);
    EXPECT_EQ(line.replay.picture.clutter, design::ClutterView::edges);
}

TEST_F(ReplayCommand, GhostsMayBeSeveralAndAreAlignedByTimeUnlessAnotherWayIsAskedFor) {
    parse({"replay", "f.log", "--ghost", "a.log", "--ghost", "b.log", "-o", "run"});
    EXPECT_EQ(line.replay.ghosts, (std::vector<std::string>{"a.log", "b.log"}));
    EXPECT_EQ(line.replay.ghost_align, GhostAlign::time);
    EXPECT_EQ(line.replay.output, "run");
    parse({"replay", "f.log", "--ghost", "a.log", "--ghost-align", "takeoff", "-o", "run"});
    EXPECT_EQ(line.replay.ghost_align, GhostAlign::takeoff);
}

TEST_F(ReplayCommand, WhatCannotStandTogetherIsRefused) {
    EXPECT_THROW(parse({"replay", "f.log", "-o", "run", "--window", "--ledger"}), CLI::ParseError);
    EXPECT_THROW(parse({"replay", "f.log", "-o", "run", "--spread", "20", "--step", "1"}), CLI::ParseError);
    EXPECT_THROW(parse({"replay", "f.log", "-o", "run", "--tour", "t.csv"}), CLI::ParseError) << "a tour needs a window";
    EXPECT_THROW(parse({"replay", "f.log", "-o", "run", "--ghost-align", "place"}), CLI::ParseError) << "nothing to align";
    EXPECT_THROW(parse({"replay", "f.log"}), CLI::ParseError) << "no folder";
}

TEST_F(ReplayCommand, AConfigSaysAllThatIsNotOfTheMoment) {
    parse({"replay", "--config", "saved.toml", "--tau", "1", "-o", "run"});
    std::ostringstream words;
    Console console(words, words, false, false);
    try {
        static_cast<void>(line.run(console));
        ADD_FAILURE() << "it was taken";
    } catch (const UserError& error) {
        EXPECT_STREQ(error.what(), "--config saved.toml: this file says it already; leave out --tau");
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_replay_command
