#include "host_sim/commands/calibrate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/display_session.hpp"
#include "render_core/effects/calibration.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_calibrate {
namespace {

using test_support::expect_user_error;
using ::testing::HasSubstr;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

CalibrateOptions small(const std::string& output) {
    CalibrateOptions options;
    options.picture = files().options("unused").picture;
    options.picture.size = PictureSize{96, 64};
    options.pose = AircraftPose{47.03, 9.68, 2500, 40, -6, 0};
    options.rounds = 3;
    options.output = files().folder.file(output);
    return options;
}

TEST(Calibrate, WritesCostsThatThisDisplayTakesAndNoOther) {
    const CalibrateOptions options = small("costs.toml");
    const auto run = test_support::run_command([&](Console& console) { return run_calibrate(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json()["device"], "es3-mid");
    EXPECT_EQ(nlohmann::json::parse(read_file(files().folder.file("costs.json"))), run.json());
    const auto read = effects::read_calibration(read_file(options.output), options.output);
    ASSERT_TRUE(read.ok()) << read.error().message.c_str();
    const effects::CostTable& costs = read.value().costs;
    EXPECT_GT(costs.overheads[0].fixed_ms, 0) << "every frame costs something";
    const effects::QualityLevels& levels = read.value().quality;
    EXPECT_GT(levels.at[0].ms, 0) << "the design's own picture";
    EXPECT_EQ(levels.at[0].error_color, 0);
    std::size_t chosen = 0, reduced = 0;
    const auto json = run.json();
    for (const auto& candidate : json.at("quality")) {
        chosen += candidate["level"].is_null() ? 0 : 1;
        reduced += candidate["error_color"] > 0 ? 1 : 0;
    }
    EXPECT_EQ(chosen, levels.count);
    EXPECT_GT(reduced, 10u) << "what is given up can be seen";
    EXPECT_THAT(read_file(options.output), HasSubstr("# not measured")) << "this database has no image";

    PictureOptions picture = options.picture;
    picture.costs = options.output;
    picture.deadline_ms = 20;
    { EXPECT_TRUE(DisplaySession(picture, false).display().memory().budget.is_held()); }
    picture.size = PictureSize{128, 64};
    const auto open = [&] { DisplaySession(picture, false); };
    expect_user_error(open, "another size");
    picture.size = options.picture.size;
    picture.device = "desktop";
    expect_user_error(open, "not for 'desktop'");
}

TEST(Calibrate, WrongUsageIsRefusedBeforeAnythingIsMeasured) {
    CalibrateOptions options = small("costs.txt");
    const auto run = [&] { test_support::run_command([&](Console& console) { return run_calibrate(options, console); }); };
    expect_user_error(run, ".toml");
    options = small("unposed.toml");
    options.pose.reset();
    expect_user_error(run, "--pose");
    EXPECT_FALSE(std::filesystem::exists(options.output));
    EXPECT_FALSE(std::filesystem::exists(options.output + ".part"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_calibrate
