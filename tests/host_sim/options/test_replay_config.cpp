#include "host_sim/options/replay_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "host_sim/commands/command_line.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_replay_config {
namespace {

using test_support::TemporaryFolder;
using ::testing::HasSubstr;

const std::string kConfigs = test_support::source_dir() + "/configs/";

ReplayOptions round_trip(const ReplayOptions& options) {
    const TemporaryFolder folder;
    const std::string path = folder.file("saved.toml");
    save_replay_config(options, path);
    return load_replay_config(path);
}

TEST(ReplayConfig, DefaultsStayDefaults) {
    ReplayOptions options;
    options.log = "/data/flight.log";
    const ReplayOptions loaded = round_trip(options);
    EXPECT_EQ(loaded.log, options.log);
    EXPECT_EQ(loaded.switches, "");
    EXPECT_EQ(loaded.switch_config, "one_hot");
    EXPECT_EQ(loaded.picture.design, kConfigs + "designs/default.toml") << "a board knows no short names";
    EXPECT_EQ(loaded.picture.aircraft, "");
    EXPECT_EQ(loaded.picture.palette, "");
    EXPECT_EQ(loaded.picture.light, design::SymbologyLight::day);
    EXPECT_EQ(loaded.picture.terrain, "");
    EXPECT_FALSE(loaded.picture.size);
    EXPECT_FALSE(loaded.picture.tau_px);
    EXPECT_FALSE(loaded.picture.force_effects);
    EXPECT_EQ(loaded.picture.legend, flight::LegendShow::key);
    EXPECT_FALSE(loaded.picture.saliency);
    EXPECT_FALSE(loaded.picture.clutter);
    EXPECT_FALSE(loaded.accuracy.any());
    EXPECT_FALSE(loaded.from_s || loaded.to_s || loaded.step_s || loaded.frames);
}

TEST(ReplayConfig, EveryParameterComesBackToTheBit) {
    ReplayOptions options;
    options.log = "/data/flight.log";
    options.switches = "/data/flight.switches";
    options.switch_config = "coded_parity";
    options.phase = "takeoff.first_climb";
    options.aircraft_class = flight::AircraftClass::jet;
    options.from_s = 0.1;
    options.to_s = 1e5 / 3;
    options.step_s = -1.0 / 30;
    options.spread = 300;
    options.frames = FrameOutput::none;
    options.picture.terrain = "/data/alps.tdb";
    options.picture.design = "cruise";
    options.picture.device = "es2-small";
    options.picture.bus = "glider";
    options.picture.aircraft = "jet";
    options.picture.palette = "standard";
    options.picture.light = design::SymbologyLight::night;
    options.picture.size = PictureSize{641, 483};
    options.picture.gl = GlChoice::osmesa;
    options.picture.tau_px = 0.3;
    options.picture.force_effects = true;
    options.picture.legend = flight::LegendShow::whole;
    options.picture.saliency = design::SaliencyView::map;
    options.picture.clutter = design::ClutterView::regions;
    options.picture.deadline_ms = 16.7;
    options.picture.costs = "/data/costs.toml";
    options.picture.foci = {R"(at = "place", place = "A \"B\"")", "radius_m = 700"};
    options.accuracy = {true, true};
    options.ghosts = {"/logs/a.log", "/logs/b \"2\".log"};
    options.ghost_align = GhostAlign::takeoff;
    const ReplayOptions loaded = round_trip(options);
    EXPECT_EQ(loaded.accuracy, options.accuracy);
    EXPECT_EQ(loaded.ghosts, options.ghosts);
    EXPECT_EQ(loaded.ghost_align, options.ghost_align);
    EXPECT_EQ(loaded.picture.legend, options.picture.legend);
    EXPECT_EQ(loaded.picture.deadline_ms, options.picture.deadline_ms);
    EXPECT_EQ(loaded.picture.costs, options.picture.costs);
    EXPECT_EQ(loaded.picture.foci, options.picture.foci);
    EXPECT_EQ(loaded.switches, options.switches);
    EXPECT_EQ(loaded.switch_config, kConfigs + "switches/coded_parity.toml");
    EXPECT_EQ(loaded.phase, options.phase);
    EXPECT_EQ(loaded.aircraft_class, options.aircraft_class);
    EXPECT_EQ(loaded.from_s, options.from_s);
    EXPECT_EQ(loaded.to_s, options.to_s);
    EXPECT_EQ(loaded.step_s, options.step_s);
    EXPECT_EQ(loaded.spread, options.spread);
    EXPECT_EQ(loaded.frames, options.frames);
    EXPECT_EQ(loaded.picture.terrain, options.picture.terrain);
    EXPECT_EQ(loaded.picture.design, kConfigs + "designs/" + options.picture.design + ".toml");
    EXPECT_EQ(loaded.picture.device, kConfigs + "devices/" + options.picture.device + ".toml");
    EXPECT_EQ(loaded.picture.bus, kConfigs + "buses/" + options.picture.bus + ".toml");
    EXPECT_EQ(loaded.picture.aircraft, kConfigs + "aircraft/" + options.picture.aircraft + ".toml");
    EXPECT_EQ(loaded.picture.palette, kConfigs + "palettes/symbology/" + options.picture.palette + ".toml");
    EXPECT_EQ(loaded.picture.light, options.picture.light);
    ASSERT_TRUE(loaded.picture.size);
    EXPECT_EQ(loaded.picture.size->width, 641u);
    EXPECT_EQ(loaded.picture.size->height, 483u);
    EXPECT_EQ(loaded.picture.gl, options.picture.gl);
    EXPECT_EQ(loaded.picture.tau_px, options.picture.tau_px);
    EXPECT_TRUE(loaded.picture.force_effects);
    EXPECT_EQ(loaded.picture.saliency, design::SaliencyView::map);
    EXPECT_EQ(loaded.picture.clutter, design::ClutterView::regions);
}

TEST(ReplayConfig, PathsHoldWhereverTheFileGoes) {
    const TemporaryFolder folder;
    ReplayOptions options;
    options.log = "flights/../flight.log";
    options.picture.design = folder.write("own.toml", "name = \"own\"\n");
    const ReplayOptions loaded = round_trip(options);
    EXPECT_EQ(loaded.log, (std::filesystem::current_path() / "flight.log").string());
    EXPECT_EQ(loaded.picture.design, options.picture.design);
}

/// Each path of a configuration that was read from the working folder.
TEST(ReplayConfig, PathsOfTheBoardHoldToo) {
    const TemporaryFolder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    folder.write("board.toml", "device = '" + kConfigs + "devices/es2-small.toml'\ndesign = '" + kConfigs +
                                   "designs/default.toml'\ndesigns = 'own'\nbus = '" + kConfigs +
                                   "buses/canaerospace.toml'\n[programs]\nfolder = 'made'\n[records]\nsocket = 'r.sock'\n");
    std::filesystem::current_path(folder.path());
    const std::string saved = replay_config_text(load_replay_config("board.toml"));
    std::filesystem::current_path(before);
    for (const auto& [key, name] : {std::pair{"designs", "own/"}, {"palettes", ""}, {"folder", "made"}, {"socket", "r.sock"}})
        EXPECT_THAT(saved, HasSubstr(key + (" = \"" + folder.file(name)) + "\"\n"));
}

TEST(ReplayConfig, WhatTheBoardAloneHasStays) {
    const TemporaryFolder folder;
    const std::string board =
        folder.write("board.toml", "title = 'b'\ndevice = '" + kConfigs + "devices/es2-small.toml'\ndesign = '" + kConfigs +
                                       "designs/default.toml'\nbus = '" + kConfigs +
                                       "buses/canaerospace.toml'\n[can]\ninterface = 'can7'\nfd = true\n[surface]\nbackend "
                                       "= 'kms'\n[screen]\nconnector = 'DSI-1'\n[records]\nsocket = '/run/r'\n");
    const ReplayOptions loaded = load_replay_config(board);
    EXPECT_EQ(loaded.picture.design_folders.palettes, folder.path() + "/") << "the file's own folder, as on a board";
    const std::string saved = replay_config_text(loaded);
    for (const char* line :
         {"title = \"b\"", "interface = \"can7\"", "fd = true", "connector = \"DSI-1\"", "socket = \"/run/r\""})
        EXPECT_THAT(saved, HasSubstr(line));
    EXPECT_EQ(saved.find("[replay]"), std::string::npos) << "nothing of the desk was said";
}

TEST(ReplayConfig, OddNamesSurvive) {
    ReplayOptions options;
    options.log = "/tmp/a \"quoted\" \\ name = [1]\t\n#.log";
    options.switches = "/tmp/Gr\xc3\xbc\xc3\x9f\x65.switches";
    const ReplayOptions loaded = round_trip(options);
    EXPECT_EQ(loaded.log, options.log);
    EXPECT_EQ(loaded.switches, options.switches);
}

TEST(ReplayConfig, FaultsAreNamedWithTheirLine) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& text, const std::string& words) {
        const std::string path = folder.write("x.toml", text);
        test_support::expect_user_error([&] { static_cast<void>(load_replay_config(path)); }, words);
    };
    const std::string head = "device = 'd'\ndesign = 'e'\nbus = 'b'\n[replay]\n";
    refused(head + "log = 3\n", "x.toml:5");
    refused(head + "log = \"a\"\nnonsense = 1\n", "x.toml:6");
    refused(head + "log = \"a\"\nframes = \"gif\"\n", "x.toml:6");
    refused(head + "phase = \"takeof\"\n", "x.toml:5");
    refused(head + "from_s = nan\n", "x.toml:5");
    refused(head + "[surface]\nwidth_px = 320\n", "x.toml:5");
    refused(head + "[surface]\nwidth_px = 3\nheight_px = 3\n", "x.toml:6");
    refused(head + "[picture]\ndesign = \"cruise\"\n", "picture");
    refused("log = \"a", "x.toml:1");
    test_support::expect_user_error([&] { static_cast<void>(load_replay_config(folder.file("none.toml"))); }, "none.toml");
}

int command(std::vector<std::string> words, std::string& notes) {
    words.insert(words.begin(), "tedavis");
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    std::ostringstream results, told;
    const int code = run_command_line(static_cast<int>(pointers.size()), pointers.data(), results, told, false);
    notes = told.str();
    return code;
}

// The round trip as a user makes it.
TEST(ReplayConfig, ASavedRunLoadsToTheSameHashes) {
    const test_support::FlownFiles files;
    const std::string saved = files.folder.file("saved.toml"), first = files.folder.file("first"),
                      second = files.folder.file("second"), antenna = files.folder.file("antenna");
    const std::vector<std::string> flown = {"replay", files.log, "--terrain", files.terrain, "--size",   "320x240",
                                            "--from", "1",       "--to",      "4",           "--step",   "-0.75",
                                            "--tau",  "3",       "--frames",  "hash",        "--design", "approach"};
    const auto with = [&flown](const std::vector<std::string>& more) {
        std::vector<std::string> words = flown;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    std::string notes;
    ASSERT_EQ(command(with({"--aircraft", "jet", "-o", first, "--save-config", saved}), notes), 0) << notes;
    ASSERT_EQ(command(with({"-o", antenna}), notes), 0) << notes;
    ASSERT_EQ(command({"replay", "--config", saved, "-o", second}, notes), 0) << notes;
    EXPECT_EQ(test_support::hashes_by_time(first).size(), 5u);
    EXPECT_EQ(test_support::hashes_by_time(first), test_support::hashes_by_time(second));
    EXPECT_NE(test_support::hashes_by_time(first), test_support::hashes_by_time(antenna)) << "the eye point is part of it";
    EXPECT_EQ(test_support::summary_of(second).at("aircraft"), kConfigs + "aircraft/jet.toml");
    EXPECT_EQ(test_support::summary_of(antenna).at("aircraft"), "");
    EXPECT_EQ(command({"check", saved}, notes), 0) << notes;
}

TEST(ReplayConfig, WhatTheFileSaysIsNotSaidTwice) {
    std::string notes;
    EXPECT_EQ(command({"replay", "--config", "x.toml", "-o", "y", "--size", "320x240"}, notes), 2);
    EXPECT_THAT(notes, HasSubstr("leave out --size"));
    EXPECT_EQ(command({"replay", "flight.log", "--config", "x.toml", "-o", "y"}, notes), 2);
    EXPECT_THAT(notes, HasSubstr("x.toml: ")) << "a log may stand there: the file is missing";
    EXPECT_EQ(command({"replay", "-o", "y"}, notes), 2);
    EXPECT_THAT(notes, HasSubstr("no log named"));
    EXPECT_EQ(command({"replay", "flight.log", "-o", "y", "--tour", "t.csv"}, notes), 2);
    EXPECT_THAT(notes, HasSubstr("--window"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_replay_config
