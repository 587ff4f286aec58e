#include "target/board_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "host_sim/input_file.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/pack/write_pack.hpp"
#include "target/self_test.hpp"
#include "tests/support/files/changing_file.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/captured_output.hpp"

namespace tedavis::target::test_board_program {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kBoard = test_support::source_dir() + "/tests/target/boards/fake_board.toml";

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
}

/// An integrator's own board in a folder of its own: with the shipped settings, and the terrain that the self-test has.
class OwnBoard : public ::testing::Test {
protected:
    OwnBoard() {
        terrain_.assign(embedded_inputs().terrain.begin(), embedded_inputs().terrain.end());
        folder_.write("area.tdb", terrain_);
    }
    std::string board(const std::string& tables = "", const std::string& device = kConfigs + "devices/es2-small.toml") {
        return folder_.write("board.toml", "device = '" + device + "'\ndesign = '" + kConfigs +
                                               "designs/default.toml'\npalettes = '" + kConfigs + "palettes'\nbus = '" +
                                               kConfigs +
                                               "buses/canaerospace.toml'\n[terrain]\ndatabase = 'area.tdb'\n[can]\ninterface = "
                                               "'can9'\n[memory]\ntouch = false\n" +
                                               tables);
    }
    /// The same board with a design that names none for phases: fewer pictures are measured.
    std::string without_phases(const std::string& board) {
        std::string text = host_sim::read_file(board);
        const std::string design = "designs/default.toml";
        text.replace(text.find(design), design.size(), "designs/cruise.toml");
        return folder_.write("board.toml", text);
    }
    Ran self_test(const std::string& board) { return run({"--self-test", "--config", board.c_str()}); }
    Ran flown(const std::string& board) { return run({"--config", board.c_str(), "--frames", "2"}); }
    void expect_found(const std::string& board, const std::string& line) {
        const Ran ran = self_test(board);
        EXPECT_EQ(ran.code, 1) << "a check does not hold";
        EXPECT_THAT(ran.out, HasSubstr(line));
        EXPECT_THAT(ran.out, HasSubstr("self-test: FAILED"));
    }

    static inline const std::string kConfigs = test_support::source_dir() + "/configs/";
    test_support::TemporaryFolder folder_;
    std::string terrain_;
};

TEST_F(OwnBoard, IsSoundAsItIs) {
    const Ran ran = self_test(board());
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("ok      board_terrain  "));
    EXPECT_EQ(flown(board()).code, 0);
}

TEST_F(OwnBoard, StartsFromAPackThatIsAsPacked) {
    const std::string config = without_phases(board()), pack = folder_.file("pack");
    const host_sim::PackContents contents = host_sim::pack_contents(host_sim::load_replay_config(config), config);
    const auto write = [&](const std::string& until) {
        host_sim::write_pack(contents, {pack, true, "", until, ""}, [](std::uint64_t, std::uint64_t) {});
    };
    write("2020-01-01");
    const Ran ran = flown(pack);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("files, each as packed"));
    EXPECT_THAT(ran.err, HasSubstr("was valid until 2020-01-01, and this is 20"));
    write("");
    EXPECT_THAT(flown(pack).err, Not(HasSubstr("valid"))) << "control";
    EXPECT_EQ(self_test(pack).code, 0);
    const std::string lines = run({"--config", pack.c_str(), "--frames", "1", "--json"}).out;
    EXPECT_EQ(nlohmann::json::parse(lines.substr(0, lines.find('\n'))).at("pack").at("signed"), false);
    std::string terrain = host_sim::read_file(pack + "/terrain/area.tdb");
    terrain[terrain.size() / 2] = static_cast<char>(terrain[terrain.size() / 2] ^ 1);
    folder_.write("pack/terrain/area.tdb", terrain);
    for (const std::vector<const char*>& arguments :
         std::vector<std::vector<const char*>>{{"--config", pack.c_str(), "--frames", "1"},
                                               {"--probe", "--config", pack.c_str()},
                                               {"--self-test", "--config", pack.c_str()}}) {
        const Ran refused = run(arguments);
        EXPECT_EQ(refused.code, 2);
        EXPECT_THAT(refused.err, HasSubstr("terrain/area.tdb: was changed after packing"));
    }
    const Ran no_key = run({"--config", pack.c_str(), "--pack-key", "/nowhere.pub"});
    EXPECT_EQ(no_key.code, 2);
    EXPECT_THAT(no_key.err, HasSubstr("--pack-key /nowhere.pub: cannot be read"));
    const std::string key = folder_.write(
        "k.pub",
        "untrusted comment: minisign public key C659D84D2214F1ED\nRWTt8RQiTdhZxqxF1UvwXA/qhYVP8iYP+yUVxVPP7tPIyykCczHCU+pM\n");
    EXPECT_THAT(run({"--config", pack.c_str(), "--pack-key", key.c_str()}).err, HasSubstr("pack.toml: is not signed"));
    const Ran no_pack = run({"--config", config.c_str(), "--pack-key", key.c_str()});
    EXPECT_EQ(no_pack.code, 2);
    EXPECT_THAT(no_pack.err, HasSubstr("is of no pack, so that no signature would be asked for"));
}

/// The service does not start again after 2.
TEST_F(OwnBoard, APackThatChangesDuringItsStartEndsWithOne) {
    const std::string config = without_phases(board()), pack = folder_.file("pack");
    host_sim::write_pack(host_sim::pack_contents(host_sim::load_replay_config(config), config), {pack, false, "", "", ""},
                         [](std::uint64_t, std::uint64_t) {});
    Ran ran;
    {
        const test_support::ChangingFile changing(pack + "/config.toml", "title = 'half of a copy'\n",
                                                  host_sim::read_file(pack + "/config.toml"));
        for (int tries = 0; tries < 100 && ran.code != 1; ++tries) ran = flown(pack);
    }
    EXPECT_EQ(ran.code, 1);
    EXPECT_THAT(ran.err, HasSubstr("was replaced or changed during the start; start again"));
    EXPECT_EQ(flown(pack).code, 2) << "control: as it stays it is no pack";
}

TEST_F(OwnBoard, ItsTerrainIsTestedAndItFliesWithoutIt) {
    const std::string path = folder_.file("area.tdb");
    std::filesystem::remove(path);
    expect_found(board(), "FAILED  board_terrain            " + path + ": cannot be read");
    const Ran ran = flown(board());
    EXPECT_EQ(ran.code, 0) << "the service does not start again after 2";
    EXPECT_THAT(ran.err,
                HasSubstr(path + ": cannot be read (No such file or directory); check the path; the display shows TERRAIN "
                                 "FAIL"));
    EXPECT_THAT(ran.out, HasSubstr("terrain FAILED"));
    folder_.write("area.tdb", terrain_.substr(0, terrain_.size() / 2));
    expect_found(board(), "FAILED  board_terrain            " + path + ": is shorter than its header says");
    EXPECT_EQ(flown(board()).code, 0);
    terrain_[terrain_.size() / 2] = static_cast<char>(terrain_[terrain_.size() / 2] ^ 1);
    folder_.write("area.tdb", terrain_);
    expect_found(board(), "FAILED  board_terrain            " + path + ": ");
}

TEST_F(OwnBoard, ItsSceneAndCostsAreTested) {
    expect_found(board("[scene]\ndatabase = 'area.sdb'\n"), "FAILED  board_scene              " + folder_.file("area.sdb"));
    EXPECT_EQ(flown(board("[scene]\ndatabase = 'area.sdb'\n")).code, 0) << "it may come later";
    folder_.write("area.sdb", "no scene");
    EXPECT_EQ(flown(board("[scene]\ndatabase = 'area.sdb'\n")).code, 0);
    folder_.write("board.costs.toml", "device = 'another'\n");
    expect_found(board("[costs]\nfile = 'board.costs.toml'\n"),
                 "FAILED  board_costs              " + folder_.file("board.costs.toml"));
    EXPECT_EQ(flown(board("[costs]\nfile = 'board.costs.toml'\n")).code, 2) << "a wrong file of settings";
}

/// What the board measured, it flies by.
TEST_F(OwnBoard, ItsCostsAreMeasuredOnIt) {
    const std::string small = "[surface]\nwidth_px = 64\nheight_px = 48\n", costs = folder_.file("board.costs.toml");
    const std::string with_costs = "[costs]\nfile = 'board.costs.toml'\n";
    const std::string path = without_phases(board(small + with_costs));
    EXPECT_EQ(flown(path).code, 2) << "they are not there yet";
    const auto calibrated = [&](const std::string& board) {
        return run({"--calibrate", "-o", costs.c_str(), "--rounds", "3", "--config", board.c_str()});
    };
    const Ran ran = calibrated(path);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.out, StartsWith(costs + ": what everything costs on es2-small, "));
    EXPECT_THAT(self_test(path).out, HasSubstr("ok      board_costs              measured on this board"));
    EXPECT_EQ(flown(path).code, 0);
    expect_found(without_phases(board("[surface]\nwidth_px = 80\nheight_px = 48\n" + with_costs)), "FAILED  board_costs");
    std::filesystem::remove(folder_.file("area.tdb"));
    const Ran without = calibrated(path);
    EXPECT_EQ(without.code, 2);
    EXPECT_THAT(without.err, HasSubstr("area.tdb: cannot be read"));
    EXPECT_EQ(without.out, "");
}

TEST_F(OwnBoard, ADeviceThatIsTooSmallIsRefusedByBoth) {
    std::string device = host_sim::read_file(kConfigs + "devices/es2-small.toml");
    const std::size_t line = device.find("bytes", device.find("\"lod_scratch\""));
    ASSERT_NE(line, std::string::npos);
    device.replace(line, device.find('\n', line) - line, "bytes = 4096");
    const std::string small = board("", folder_.write("small.toml", device));
    expect_found(small, "the budget line 'lod_scratch' has 1120 of 4096 bytes left and ");
    const Ran ran = flown(small);
    EXPECT_EQ(ran.code, 2);
    EXPECT_THAT(ran.err, HasSubstr("the budget line 'lod_scratch' has 1120 of 4096 bytes left and "));
    EXPECT_EQ(self_test(board("nonsense = 1\n")).code, 2) << "what is no board file is not tested";
}

TEST(BoardProgram, RunsWithoutItsBus) {
    const Ran ran = run({"--config", kBoard.c_str(), "--frames", "3", "--json"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_THAT(ran.err, HasSubstr("CAN interface 'can9': "));
    const std::size_t line = ran.out.find('\n');
    EXPECT_EQ(nlohmann::json::parse(ran.out.substr(0, line)).at("board"), "fake board");
    EXPECT_EQ(nlohmann::json::parse(ran.out.substr(line + 1)).at("frames"), 3);
}

TEST(BoardProgram, TheProbeListsWhatIsHereOrSaysWhyABoardDoesNotWork) {
    const Ran offer = run({"--probe"});
    EXPECT_EQ(offer.code, 0) << offer.out;
    EXPECT_THAT(offer.out, HasSubstr("gl               es2, off-screen: "));
    EXPECT_EQ(nlohmann::json::parse(run({"--probe", "--json"}).out).at("probe"), true);
    const Ran board = run({"--probe", "--config", kBoard.c_str()});
    EXPECT_EQ(board.code, 1) << "there is no can9";
    EXPECT_THAT(board.out, HasSubstr("FAILED  can                      CAN interface 'can9': "));
    EXPECT_THAT(board.out, HasSubstr("ok      board_display            640 x 480, "));
    EXPECT_THAT(board.out, HasSubstr("probe: FAILED\n"));
    EXPECT_EQ(run({"--probe", "--config", "/nowhere.toml"}).code, 2);
}

/// The start says of the bus what the probe says.
TEST(BoardProgram, TheProbeSaysWhatTheStartSays) {
    const Ran started = run({"--config", kBoard.c_str(), "--frames", "1"});
    const std::string begin = "CAN interface 'can9': ";
    const std::size_t at = started.err.find(begin);
    ASSERT_NE(at, std::string::npos) << started.err;
    EXPECT_THAT(run({"--probe", "--config", kBoard.c_str()}).out,
                HasSubstr(started.err.substr(at, started.err.find('\n', at) - at)));
}

#if defined(TEDAVIS_HAVE_KMS)
TEST_F(OwnBoard, AScreenThatIsMissingEndsWithOneAndAWrongOneWithTwo) {
    const std::string screen = "[surface]\nbackend = 'kms'\n[screen]\npath = '";
    const Ran missing = flown(board(screen + "/dev/dri/by-path/no-such-card'\n"));
    EXPECT_EQ(missing.code, 1) << "the service manager tries again";
    EXPECT_THAT(missing.err, HasSubstr("[surface]: /dev/dri/by-path/no-such-card: there is no such card"));
    const Ran wrong = flown(board(screen + "/dev/null'\n"));
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("/dev/null: drives no screens"));
    const std::string asked = board(screen + "/dev/null'\n");
    EXPECT_THAT(run({"--probe", "--config", asked.c_str()}).out,
                HasSubstr("FAILED  screen                   [surface]: /dev/null: drives"));
}
#endif

TEST(BoardProgram, EveryStartTestsItself) {
    const Ran ran = run({"--config", kBoard.c_str(), "--frames", "1", "--json"});
    const auto json = nlohmann::json::parse(ran.out.substr(0, ran.out.find('\n')));
    EXPECT_EQ(json.at("self_test").at("holds"), true);
    EXPECT_GT(json.at("self_test").at("checks"), 15);
    EXPECT_THAT(run({"--config", kBoard.c_str(), "--frames", "1"}).out, HasSubstr("self-test of the start: passed, "));
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
