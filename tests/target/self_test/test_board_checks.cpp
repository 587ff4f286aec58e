#include "target/self_test/board_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"
#include "tests/target/board_costs.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_board_checks {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class BoardChecksTest : public ::testing::Test {
protected:
    SelfTestReport checked() const {
        SelfTestReport report;
        check_board(settings_, report);
        return report;
    }
    /// The only check that does not hold, "name: finding"; empty where all do.
    std::string fault() const {
        std::string faults;
        const SelfTestReport report = checked();
        for (const SelfCheck& check : report.checks())
            if (!check.holds) faults += std::string(check.name.view()) + ": " + std::string(check.finding.view());
        return faults;
    }
    std::string terrain_file(const std::string& bytes) {
        settings_.terrain = Path(folder_.write("area.tdb", bytes));
        return folder_.file("area.tdb");
    }
    static std::string terrain_bytes() { return {embedded_inputs().terrain.begin(), embedded_inputs().terrain.end()}; }
    static std::string scene_bytes() {
        const std::vector<std::uint8_t> bytes = host_sim::sdb_bytes(test_support::small_scene());
        return {bytes.begin(), bytes.end()};
    }

    test_support::TemporaryFolder folder_;
    BoardSettings settings_ = board_settings();
};

TEST_F(BoardChecksTest, ASoundBoardIsToldWhatItHas) {
    settings_.scene = Path(folder_.write("area.sdb", scene_bytes()));
    settings_.costs = Path(folder_.write("costs.toml", costs_of_this_board(settings_)));
    const SelfTestReport report = checked();
    EXPECT_TRUE(report.holds()) << fault();
    const auto finding = [&](const char* name) { return std::string(report.find(name)->finding.view()); };
    EXPECT_THAT(finding("board_terrain"), HasSubstr(" chunks, every checksum right"));
    EXPECT_EQ(finding("board_scene"), "4 layers, revision 1, every checksum right");
    EXPECT_EQ(finding("board_surface"), "egl");
    EXPECT_THAT(finding("board_display"), StartsWith("640 x 480, "));
    EXPECT_EQ(finding("board_costs"), "measured on this board");
    EXPECT_EQ(report.find("board_programs"), nullptr) << "the board file names none";
}

TEST_F(BoardChecksTest, WhatTheBoardFileDoesNotNameIsNotChecked) {
    settings_.terrain = Path();
    const SelfTestReport report = checked();
    EXPECT_TRUE(report.holds());
    EXPECT_EQ(report.checks().size(), 2u) << "surface and display";
}

TEST_F(BoardChecksTest, TerrainIsReadToItsLastByte) {
    const std::string sound = terrain_bytes();
    terrain_file(sound);
    EXPECT_EQ(fault(), "") << "control";
    settings_.terrain = Path(folder_.file("none.tdb"));
    EXPECT_EQ(fault(),
              "board_terrain: " + folder_.file("none.tdb") + ": cannot be read (No such file or directory); check the path");
    const std::string path = terrain_file(sound.substr(0, sound.size() / 2));
    EXPECT_THAT(fault(), StartsWith("board_terrain: " + path + ": is shorter than its header says"));
    std::string damaged = sound;
    test_support::damage_payloads(damaged);
    terrain_file(damaged);
    EXPECT_THAT(fault(), StartsWith("board_terrain: " + path + ": has a damaged chunk (offset "))
        << "which the start does not read";
    terrain_file("this is no terrain database" + std::string(500, '.'));
    EXPECT_THAT(fault(), StartsWith("board_terrain: " + path + ": is not a terrain database"));
}

TEST_F(BoardChecksTest, ASceneMustBeWholeAndFitTheDevice) {
    settings_.scene = Path(folder_.file("none.sdb"));
    EXPECT_THAT(fault(), StartsWith("board_scene: " + folder_.file("none.sdb") + ": cannot be read"));
    std::string damaged = scene_bytes();
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    settings_.scene = Path(folder_.write("area.sdb", damaged));
    EXPECT_THAT(fault(), StartsWith("board_scene: " + folder_.file("area.sdb") + ": "));
    settings_.scene = Path(folder_.write("area.sdb", scene_bytes()));
    EXPECT_EQ(fault(), "") << "control";
    settings_.device.budget.find(effects::kSceneData)->bytes = 512;
    EXPECT_THAT(fault(), StartsWith("board_scene: " + folder_.file("area.sdb") + ": ")) << "no room for it";
}

TEST_F(BoardChecksTest, CostsMustBeThisBoards) {
    settings_.costs = Path(folder_.write("costs.toml", costs_of(settings_, "another")));
    EXPECT_THAT(fault(), HasSubstr("board_costs: "));
    EXPECT_THAT(fault(), HasSubstr("'another', not for"));
    settings_.costs = Path(folder_.write("costs.toml", "device = 5\n"));
    EXPECT_THAT(fault(), StartsWith("board_costs: " + folder_.file("costs.toml") + ":1: "));
    settings_.costs = Path(folder_.file("none.toml"));
    EXPECT_THAT(fault(), HasSubstr("none.toml"));
}

TEST_F(BoardChecksTest, BudgetsAreThoseThatTheStartBuilds) {
    settings_.device.budget.find(effects::kLodScratch)->bytes = 8;
    EXPECT_THAT(fault(),
                StartsWith("board_display: device 'es2-small': the budget line 'lod_scratch' has 8 of 8 bytes left and "));
    settings_.scene = Path(folder_.write("area.sdb", "no scene"));
    EXPECT_THAT(fault(), HasSubstr("board_scene: " + folder_.file("area.sdb"))) << "which needs no display";
    settings_ = board_settings();
    settings_.device.budget.find(effects::kTerrainIndex)->bytes = 8;
    EXPECT_THAT(fault(), StartsWith("board_display: ")) << "a database that is sound, and too large for the device";
    settings_ = board_settings();
    settings_.surface = base::FixedString<15>("glut");
    EXPECT_EQ(fault(), "board_surface: [surface]: the surface 'glut' is not known; use egl or osmesa");
}

TEST_F(BoardChecksTest, ProgramsMustBeThere) {
    settings_.programs = Path(folder_.file("none.programs"));
    EXPECT_THAT(fault(), StartsWith("board_programs: " + folder_.file("none.programs")));
    settings_.programs = Path(folder_.path());
    EXPECT_EQ(fault(), "") << "not read by a device with a compiler";
    const SelfTestReport report = checked();
    ASSERT_NE(report.find("board_programs"), nullptr);
    EXPECT_TRUE(report.find("board_programs")->holds);
}

}  // namespace
}  // namespace tedavis::target::test_board_checks
