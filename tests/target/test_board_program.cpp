#include "target/board_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "tests/support/temporary_folder.hpp"
#include "tests/target/captured_output.hpp"

namespace tedavis::target::test_board_program {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kBoard = std::string(TEDAVIS_SOURCE_DIR) + "/tests/target/boards/fake_board.toml";

struct Ran {
    int code = -1;
    std::string out, err;
};
Ran run(const std::vector<const char*>& arguments) {
    Ran ran;
    testing::internal::CaptureStderr();
    ran.out =
        printed([&](std::FILE* out) { ran.code = run_board_program(static_cast<int>(arguments.size()), arguments.data(), out); });
    ran.err = testing::internal::GetCapturedStderr();
    return ran;
}

TEST(BoardProgram, AnswersQuestions) {
    EXPECT_EQ(run({"--help"}).code, 0);
    EXPECT_THAT(run({"--help"}).out, HasSubstr("--self-test"));
    EXPECT_EQ(run({"--version"}).code, 0);
    EXPECT_THAT(run({"--version"}).out, StartsWith("tedavis-display "));
}

TEST(BoardProgram, WrongUsageAndInputEndWithTwoAndOneSentence) {
    const test_support::TemporaryFolder folder;
    const std::string broken = folder.write("broken.toml", "title = 'x'\ndevice = 5\n");
    for (const auto& [arguments, says] : std::vector<std::pair<std::vector<const char*>, std::string>>{
             {{}, "--config: is missing"},
             {{"--fast"}, "'--fast': no such option"},
             {{"--config", "/nowhere.toml"}, "/nowhere.toml: cannot be read (No such file or directory); check the path"},
             {{"--config", broken.c_str()}, broken + ":2: "},
             {{"--self-test", "--config", broken.c_str()}, broken + ":2: "}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.code, 2);
        EXPECT_EQ(ran.out, "");
        EXPECT_THAT(ran.err, StartsWith("tedavis-display: " + says));
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1);
    }
    const std::string no_terrain = "[terrain]\ndatabase = 'absent.tdb'\n[can]\ninterface = 'can9'\n";
    const std::string configs = std::string(TEDAVIS_SOURCE_DIR) + "/configs/";
    const std::string board =
        folder.write("board.toml", "device = '" + configs + "devices/es2-small.toml'\ndesign = '" + configs +
                                       "designs/default.toml'\npalettes = '" + configs + "palettes'\nbus = '" + configs +
                                       "buses/canaerospace.toml'\n" + no_terrain);
    const Ran ran = run({"--config", board.c_str()});
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr(folder.file("absent.tdb")));
}

TEST(BoardProgram, RunsWithoutItsBus) {
    const Ran ran = run({"--config", kBoard.c_str(), "--frames", "3", "--json"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_THAT(ran.err, HasSubstr("CAN interface 'can9': "));
    const std::size_t line = ran.out.find('\n');
    EXPECT_EQ(nlohmann::json::parse(ran.out.substr(0, line)).at("board"), "fake board");
    EXPECT_EQ(nlohmann::json::parse(ran.out.substr(line + 1)).at("frames"), 3);
}

TEST(BoardProgram, TheSelfTestHoldsHere) {
    const Ran ran = run({"--self-test", "--json", "--config", kBoard.c_str()});
    EXPECT_EQ(ran.code, 0) << ran.out;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json.at("self_test"), true);
    EXPECT_EQ(json.at("checks").at(0).at("name"), "board_file");
}

}  // namespace
}  // namespace tedavis::target::test_board_program
