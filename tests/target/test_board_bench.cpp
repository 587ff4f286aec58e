#include "target/board_bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/fake_board.hpp"
#include "tests/target/ticking_clock.hpp"

namespace tedavis::target::test_board_bench {
namespace {

using effects::Effect;
using ::testing::HasSubstr;

struct BoardBenchTest : testing::Test {
    BoardBenchTest() {
        TickingClock::reset();
        settings.width_px = 96;
        settings.height_px = 64;
        settings.phases = {};
    }
    BoardBench& bench() {
        made = std::make_unique<BoardBench>(settings, clocks, stop, log);
        return *made;
    }
    BoardSettings settings = board_settings();
    BoardClocks clocks = TickingClock::clocks();
    StopSignal stop;
    LogLines lines;
    EventLog log = lines.log();
    std::unique_ptr<BoardBench> made;
    std::unique_ptr<platform::BenchPicture> picture = std::make_unique<platform::BenchPicture>();
};

TEST_F(BoardBenchTest, StandsOverTheMiddleOfTheBoardsTerrain) {
    platform::BenchPlace place;
    ASSERT_EQ(bench().find_place(place).message.view(), "");
    EXPECT_NEAR(place.pose.latitude_rad, base::radians((36.5713 + 36.6254) / 2), 2e-5);
    EXPECT_NEAR(place.pose.longitude_rad, base::radians((-84.2029 - 84.1488) / 2), 2e-5);
    EXPECT_GT(place.pose.altitude_msl_m, 236 + BoardBench::kHeightAboveGround_m);
    EXPECT_LT(place.pose.altitude_msl_m, 1076 + BoardBench::kHeightAboveGround_m) << "of the ground there, not of the summit";
    settings.terrain = Path("/nowhere.tdb");
    EXPECT_THAT(std::string(bench().find_place(place).message.view()), HasSubstr("/nowhere.tdb: cannot be read"));
}

TEST_F(BoardBenchTest, MeasuresAnEffectInADesignOfTheBoardThatAsksForIt) {
    settings.design = effects::without_effect(settings.design, Effect::haze);
    design::DesignSettings foggy = settings.design;
    foggy.sky.haze_distance_m = 40000;
    foggy.name = "foggy";
    ASSERT_TRUE(settings.phases.add({flight::FlightPhase{}, design::DesignFileName("foggy")}, foggy));
    EXPECT_EQ(bench().picture_with(Effect::haze, *picture).view(), "");
    EXPECT_EQ(bench().quality_pictures(), 2u);
    bench().quality_picture(1, *picture);
    EXPECT_EQ(picture->name.view(), "foggy");
    EXPECT_EQ(bench().picture_with(Effect::antialiasing, *picture).view(), "") << "can be added";
    EXPECT_EQ(picture->name, base::FixedString<127>(settings.design.name.view()));
    EXPECT_EQ(bench().picture_with(Effect::curtains, *picture).view(), "no design of this board asks for it");
    EXPECT_EQ(bench().picture_with(effects::Overhead::elements, *picture).view(), "the board has no spatial data");
}

TEST_F(BoardBenchTest, ASceneThatIsNotThereIsSaidAndLeftOut) {
    const test_support::TemporaryFolder folder;
    settings.scene = Path(folder.file("area.sdb"));
    bench().own_picture(*picture);
    EXPECT_FALSE(picture->has_scene);
    EXPECT_THAT(lines.str(), HasSubstr("area.sdb: cannot be read"));
    EXPECT_THAT(lines.str(), HasSubstr("; costs are measured without spatial data\n"));
}

TEST_F(BoardBenchTest, DrawsAsInFlight) {
    std::unique_ptr<platform::DisplayHost> host;
    bench().own_picture(*picture);
    ASSERT_EQ(made->open(*picture, host).message.view(), "");
    host->display().plan({{}, {}, base::Time{1}});
    EXPECT_TRUE(made->draw(*host));
    EXPECT_EQ(host->surface().width(), 96u);
    EXPECT_EQ(host->display().planner().settings().device.name, settings.device.name);
    EXPECT_EQ(host->display().gl().denied().total, 0u) << "no call outside the device";
}

TEST_F(BoardBenchTest, SaysHowMuchTimeIsLeft) {
    bench().progress(0, 40);
    made->progress(1, 40);
    EXPECT_EQ(lines.str(), "") << "not at every step";
    TickingClock::now_ns += 10'000'000'000;
    made->progress(10, 40);
    EXPECT_EQ(lines.str(), "tedavis-display: costs: 10 of 40 steps are measured, about 30 s are left\n");
}

}  // namespace
}  // namespace tedavis::target::test_board_bench
