#include "host_sim/commands/verify_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_verify_board {
namespace {

class VerifyBoard : public ::testing::Test {
protected:
    VerifyBoard() {
        const std::string configs = shipped_root() + "/configs/";
        options_.target = place_.file("records");
        options_.board =
            place_.write("board.toml", "device = \"" + configs + "devices/es2-small.toml\"\ndesign = \"" + configs +
                                           "designs/default.toml\"\npalettes = \"" + configs + "palettes\"\nbus = \"" + configs +
                                           "buses/canaerospace.toml\"\n[switches]\nconfig = \"" + configs +
                                           "switches/one_hot.toml\"\n[can]\ninterface = \"nothere0\"\n");
    }
    std::string script(const std::string& settings, const std::string& name = "a.toml") const {
        return place_.write(name, settings + "[[expect]]\nat_s = 1\nphase = \"unknown\"\n");
    }
    void expect_refused(const std::string& words) {
        const auto run = [&](Console& console) { return run_verify(options_, console); };
        test_support::expect_user_error([&] { static_cast<void>(test_support::run_command(run)); }, words);
    }
    test_support::TemporaryFolder place_;
    VerifyOptions options_;
};

TEST_F(VerifyBoard, OptionsOfABoardNeedOne) {
    EXPECT_FALSE(stated_board("", "", ""));
    EXPECT_EQ(stated_board(options_.target, options_.board, "")->interface, "nothere0");
    options_.board.clear();
    expect_refused("say --board");
    options_.target.clear();
    options_.panel_lines = "/x";
    expect_refused("say --target");
}

TEST_F(VerifyBoard, AScriptOfAnotherBoardIsRefusedWhereItIsNamed) {
    options_.scripts = {script("terrain = \"jacksboro\"\n")};
    expect_refused("is one of the terrain 'jacksboro', and the board has none; fly it on that board");
}

TEST_F(VerifyBoard, SwitchesNeedTheirLines) {
    options_.scripts = {script("[[step]]\nat_s = 0\nswitch = \"CRUISE\"\n")};
    expect_refused("a.toml: throws switches, and no --panel-lines are given; name the folder");
}

/// Those of a folder are left out instead, so that the others are flown.
TEST_F(VerifyBoard, ScriptsOfAFolderThatThrowSwitchesAreLeftOut) {
    options_.scripts = {place_.file("scripts")};
    std::filesystem::create_directories(options_.scripts[0]);
    static_cast<void>(script("[[step]]\nat_s = 0\nswitch = \"CRUISE\"\n", "scripts/a.toml"));
    expect_refused("no script is one of this board (" + place_.file("scripts/a.toml") + " throws switches, and no --panel-lines");
    static_cast<void>(script("", "scripts/b.toml"));
    expect_refused("nothere0");
}

TEST_F(VerifyBoard, ABusThatIsNotThereIsNamedBeforeAnythingIsFlown) {
    options_.scripts = {script("")};
    expect_refused("nothere0");
}

TEST_F(VerifyBoard, AFolderWithoutAScriptOfTheBoardIsRefused) {
    options_.scripts = {place_.file("scripts")};
    std::filesystem::create_directories(options_.scripts[0]);
    static_cast<void>(script("terrain = \"jacksboro\"\n", "scripts/a.toml"));
    expect_refused("no script is one of this board");
}

}  // namespace
}  // namespace tedavis::host_sim::test_verify_board
