#include "target/calibrate_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/accuracy/governor_choice.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/replay/display_session.hpp"
#include "target/board_display.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/captured_output.hpp"
#include "tests/target/fake_board.hpp"
#include "tests/target/ticking_clock.hpp"

namespace tedavis::target::test_calibrate_board {
namespace {

using ::testing::HasSubstr;

struct CalibrateBoardTest : testing::Test {
    CalibrateBoardTest() {
        TickingClock::reset();
        settings.width_px = 64;
        settings.height_px = 48;
        settings.phases = {};  // their pictures are measured alike
        settings.device.deadline_ms = 5;
    }
    std::string refusal(bool json = false) {
        base::Error error;
        out = printed([&](std::FILE* to) {
            error = calibrate_board(settings, {path.c_str(), 3, json}, {TickingClock::clocks(), lines.log()}, stop, to);
        });
        return std::string(error.message.view());
    }
    void expect_nothing_written() const {
        EXPECT_FALSE(std::filesystem::exists(path));
        EXPECT_FALSE(std::filesystem::exists(path + ".part"));
        EXPECT_EQ(out, "");
    }
    BoardSettings settings = board_settings();
    test_support::TemporaryFolder folder;
    std::string path = folder.file("board.costs.toml");
    LogLines lines;
    StopSignal stop;
    std::string out;
};

TEST_F(CalibrateBoardTest, WritesCostsThatBoardAndDeskRead) {
    ASSERT_EQ(refusal(true), "");
    const auto json = nlohmann::json::parse(out);
    EXPECT_EQ(json["costs"], path);
    EXPECT_GT(json["measured"], 4);
    EXPECT_GT(json["not_measured"].size(), 5u) << "es2-small cannot do all, and no design asks for all";
    const std::string text = host_sim::read_file(path);
    EXPECT_THAT(text, HasSubstr("by tedavis-display --calibrate, over "));
    EXPECT_THAT(text, HasSubstr("date = \"2026-06-01T14:02:37Z\""));

    settings.costs = Path(path);
    {
        platform::DisplayHost host;
        ASSERT_FALSE(start_board_display(settings, host));
        EXPECT_EQ(hold_board_deadline(settings, host).message.view(), "") << "the governor takes them";
        EXPECT_TRUE(host.display().memory().budget.is_held());
    }
    effects::Calibration read = host_sim::read_costs(path);
    EXPECT_EQ(read.subject.device, settings.device.name);
    EXPECT_NEAR(read.costs[effects::Overhead::frame].fixed_ms, TickingClock::kTick_ns / 1e6, 1e-6);
    EXPECT_NEAR(read.quality.at[0].ms, TickingClock::kTick_ns / 1e6, 1e-6);
    EXPECT_GT(read.quality.at[0].error_px, 0) << "the proven bound of what is drawn";
    host_sim::PictureOptions desk;
    desk.device = std::string(read.subject.device.view());
    desk.size = host_sim::PictureSize{read.subject.width_px, read.subject.height_px};
    desk.costs = path;
    desk.deadline_ms = 20;
    EXPECT_TRUE(host_sim::DisplaySession(desk, false).display().memory().budget.is_held()) << "accuracy --costs";
}

/// As text; and a control: a board that differs in anything that costs depend on does not take the file.
TEST_F(CalibrateBoardTest, AnotherBoardDoesNotTakeThem) {
    ASSERT_EQ(refusal(), "");
    EXPECT_THAT(out, HasSubstr("not measured: no design of this board asks for it\n"));
    EXPECT_THAT(out, HasSubstr("  level 0 "));
    settings.costs = Path(path);
    settings.width_px = 128;
    platform::DisplayHost host;
    ASSERT_FALSE(start_board_display(settings, host));
    EXPECT_THAT(std::string(hold_board_deadline(settings, host).message.view()), HasSubstr("another size"));
}

TEST_F(CalibrateBoardTest, WithoutTerrainOrAPlaceToWriteItSaysSo) {
    settings.terrain = Path();
    EXPECT_EQ(refusal(), "--calibrate: the board file names no terrain to measure over; add [terrain] with a database");
    expect_nothing_written();
    settings.terrain = Path(folder.write("area.tdb", "no terrain"));
    EXPECT_THAT(refusal(), HasSubstr("area.tdb: "));
    expect_nothing_written();
    settings = board_settings();
    settings.device = test_support::shipped_device("sc2");
    EXPECT_THAT(refusal(), HasSubstr("--calibrate: device 'sc2' has no compiler"));
    expect_nothing_written();
    settings = board_settings();
    path = folder.file("none/board.costs.toml");
    EXPECT_THAT(refusal(), HasSubstr("none/board.costs.toml: cannot be written"));
    EXPECT_EQ(TickingClock::now_ns, 0) << "said before anything is measured";
}

TEST_F(CalibrateBoardTest, ASignalLeavesNothingBehind) {
    TickingClock::on_look = [] {
        if (TickingClock::now_ns == 40 * TickingClock::kTick_ns) raise(SIGINT);
    };
    EXPECT_EQ(refusal(), "interrupted; nothing was written");
    EXPECT_TRUE(stop.requested());
    expect_nothing_written();
}

}  // namespace
}  // namespace tedavis::target::test_calibrate_board
