#include "host_sim/flight_test/board_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/commands/pack.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_board_file {
namespace {

std::string shipped(const std::string& path) { return shipped_root() + "/configs/" + path; }

class BoardFileTest : public ::testing::Test {
protected:
    BoardFileTest() {
        place_.write("area.tdb", "terrain");
        board_text_ = "title = \"b\"\ndevice = \"" + shipped("devices/es2-small.toml") + "\"\ndesign = \"" +
                      shipped("designs/default.toml") + "\"\npalettes = \"" + shipped("palettes") +
                      "\"\nbus = \"own_bus.toml\"\n[can]\ninterface = \"can3\"\nfilter = true\n" +
                      "[terrain]\ndatabase = \"area.tdb\"\n[switches]\nconfig = \"own_panel.toml\"\n" +
                      "[records]\nsocket = \"/run/tedavis/records\"\n[memory]\ntouch = true\n";
        place_.write("own_bus.toml", read_file(shipped("buses/canaerospace.toml")));
        std::string panel = read_file(shipped("switches/one_hot.toml"));
        for (std::size_t at = 0; (at = panel.find("\"panel\"", at)) != std::string::npos;) panel.replace(at, 7, "\"gpio0\"");
        place_.write("own_panel.toml", panel);
        board_ = read_board_file(place_.write("board.toml", board_text_));
    }
    std::string misfit(const std::string& settings) {
        ScriptFaults faults;
        const FlightTest test = read_flight_test(place_.write("a.toml", settings + "[[expect]]\nat_s = 1\nphase = \"cruise\"\n"),
                                                 {}, faults, script_defaults(board_));
        EXPECT_TRUE(faults.empty()) << faults.sentences().front();
        return misfit_of(test, board_);
    }
    test_support::TemporaryFolder place_;
    std::string board_text_;
    BoardFile board_;
};

TEST_F(BoardFileTest, NamesAreThoseOfTheFileFromItsFolder) {
    EXPECT_EQ(board_.interface, "can3");
    EXPECT_EQ(board_.terrain, place_.file("area.tdb"));
    EXPECT_EQ(board_.scene, "");
    EXPECT_EQ(board_.panel.lines[0].chip.view(), "gpio0");
    EXPECT_GT(board_.rate_hz, 0);
}

TEST_F(BoardFileTest, WhatAScriptLeavesOpenIsTheBoards) {
    EXPECT_EQ(misfit(""), "");
    ScriptFaults faults;
    const FlightTest test = read_flight_test(place_.write("a.toml", "[[expect]]\nat_s = 1\nphase = \"cruise\"\n"), {}, faults,
                                             script_defaults(board_));
    EXPECT_EQ(test.panel.lines[0].chip.view(), "gpio0");
}

TEST_F(BoardFileTest, WhatAScriptNamesMustBeTheBoards) {
    EXPECT_EQ(misfit("switches = \"one_hot\"\nbus = \"canaerospace\"\ndesign = \"default\"\ndevice = \"es2-small\"\n"), "")
        << "the same content, a panel on another chip";
    EXPECT_EQ(misfit("terrain = \"./area.tdb\"\n"), "");
    EXPECT_EQ(misfit("terrain = \"jacksboro\"\n"),
              "is one of the terrain 'jacksboro', and the board has '" + place_.file("area.tdb") + "'");
    EXPECT_NE(misfit("scene = \"jacksboro\"\n"), "");
    EXPECT_NE(misfit("switches = \"coded_parity\"\n"), "");
    EXPECT_NE(misfit("device = \"es3-mid\"\n"), "");
    EXPECT_NE(misfit("design = \"cruise\"\n"), "");
}

TEST_F(BoardFileTest, ABuiltTerrainIsKnownByItsName) {
    place_.write("jacksboro.tdb", "terrain");
    board_.terrain = place_.file("jacksboro.tdb");
    EXPECT_EQ(misfit("terrain = \"jacksboro\"\n"), "");
}

/// As tedavis-display finds them: folders of the board's own, and no shipped ones.
TEST_F(BoardFileTest, TheDesignsAreThoseOfTheBoardsFolders) {
    for (const char* folder : {"board/palettes", "board/designs"}) std::filesystem::create_directories(place_.file(folder));
    place_.write("board/palettes/ours.toml", read_file(shipped("palettes/alpine.toml")));
    place_.write("board/designs/own_cruise.toml", "name = \"own cruise\"\n");
    place_.write("board/main.toml", "name = \"main\"\n[phases]\ncruise = \"own_cruise\"\n");
    const std::string text = "device = \"" + shipped("devices/es2-small.toml") + "\"\ndesign = \"main.toml\"\nbus = \"" +
                             shipped("buses/canaerospace.toml") +
                             "\"\ndesigns = \"designs\"\npalettes = \"palettes\"\n[can]\ninterface = \"can0\"\nfd = true\n";
    board_ = read_board_file(place_.write("board/board.toml", text));
    EXPECT_EQ(board_.designs, (std::vector<std::string>{"main", "own cruise"}));
    EXPECT_TRUE(board_.can_fd);
    EXPECT_EQ(misfit("[[expect]]\nat_s = 2\ndesign = \"own cruise\"\n"), "");
}

TEST_F(BoardFileTest, APackIsABoardFile) {
    const test_support::TemporaryFolder packs;
    const std::string config =
        place_.write("p.toml", "device = \"" + shipped("devices/es2-small.toml") + "\"\ndesign = \"" +
                                   shipped("designs/default.toml") + "\"\npalettes = \"" + shipped("palettes") +
                                   "\"\nbus = \"own_bus.toml\"\n" + "[can]\ninterface = \"can3\"\n");
    PackOptions options;
    options.config = config;
    options.output = packs.file("pack");
    static_cast<void>(test_support::run_command([&](Console& console) { return run_pack(options, console); }));
    board_ = read_board_file(options.output);
    EXPECT_EQ(board_.interface, "can3");
    EXPECT_EQ(board_.path, packs.file("pack/config.toml"));
    EXPECT_EQ(misfit("bus = \"canaerospace\"\n"), "");
    packs.write("pack/config.toml", "changed");
    test_support::expect_user_error([&] { static_cast<void>(read_board_file(options.output)); }, "config.toml");
}

TEST_F(BoardFileTest, SwitchesNeedAPanelOfTheBoard) {
    const std::string step = "[[step]]\nat_s = 0\nswitch = \"CRUISE\"\n";
    EXPECT_EQ(misfit(step), "");
    board_.switches.clear();
    EXPECT_EQ(misfit(step), "throws switches, and the board has no panel");
    EXPECT_EQ(misfit(""), "");
}

TEST_F(BoardFileTest, FaultsAreNamed) {
    const auto expect_fault = [&](const std::string& text, const std::string& words) {
        const std::string path = place_.write("b.toml", text);
        test_support::expect_user_error([&] { static_cast<void>(read_board_file(path)); }, words);
    };
    expect_fault("title = \"b\"\n", "'device'");
    expect_fault("design = 5\n", "b.toml:1");
    expect_fault("= 5\n", "b.toml:1");
    expect_fault(board_text_ + "[memroy]\ntouch = true\n", "memroy");
}

}  // namespace
}  // namespace tedavis::host_sim::test_board_file
