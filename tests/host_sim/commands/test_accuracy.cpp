#include "host_sim/commands/accuracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/commands/option_texts.hpp"
#include "host_sim/commands/shot.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_accuracy {
namespace {

using test_support::expect_user_error;
using ::testing::HasSubstr;
using ::testing::Not;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

AccuracyOptions quick(const std::string& folder) {
    AccuracyOptions options;
    options.output = files().folder.file(folder);
    options.terrains = {files().terrain};
    options.is_quick = true;
    options.knobs = {"ray_halvings"};
    return options;
}

test_support::CommandRun run(const AccuracyOptions& options, bool json) {
    return test_support::run_command([&](Console& console) { return run_accuracy(options, console); }, json);
}

TEST(Accuracy, LeavesItsFilesAndAnswers) {
    AccuracyOptions options = quick("report");
    options.budget_ms = 1e6;
    options.target_error = "1e-3 cells of the grid";
    const auto said = run(options, false);
    EXPECT_EQ(said.code, 0);
    EXPECT_THAT(said.results, HasSubstr("the most accurate within 1e+06 ms\n  ray_halvings: 15 halvings"));
    constexpr const char* kQuickest = "the quickest with at most 0.001 cells of the grid\n  ray_halvings: ";
    EXPECT_THAT(said.results, HasSubstr(kQuickest));
    EXPECT_THAT(said.results, Not(HasSubstr(std::string(kQuickest) + "6 halvings"))) << "control: they are 0.002 cells off";
    const auto json = nlohmann::json::parse(read_file(options.output + "/accuracy.json"));
    EXPECT_EQ(json.at("knobs").size(), 1u);
    EXPECT_FALSE(json.at("interrupted"));
    EXPECT_THAT(read_file(options.output + "/accuracy.csv"), HasSubstr("\nray_halvings,\"0 halvings\","));
    EXPECT_THAT(read_file(options.output + "/report.html"), HasSubstr("id='ray_halvings'"));
}

TEST(Accuracy, GoesOnWhereItWas) {
    AccuracyOptions options = quick("resumed");
    const auto first = run(options, true).json();
    options.knobs = {"ray_steps", "ray_halvings"};
    const auto both = run(options, true).json();
    ASSERT_EQ(both.at("knobs").size(), 2u);
    EXPECT_EQ(both.at("knobs")[0].at("name"), "ray_steps") << "the registry's order";
    EXPECT_EQ(both.at("knobs")[1], first.at("knobs")[0]) << "was not measured again";
    options.is_quick = false;
    expect_user_error([&] { static_cast<void>(run(options, true)); }, "accuracy.json: was measured with another");
}

TEST(Accuracy, ShowsThatAWrongSearchIsWrong) {
    AccuracyOptions options = quick("control");
    options.is_control_only = true;
    const auto said = run(options, true);
    EXPECT_EQ(said.code, 0);
    const auto control = said.json().at("negative_control");
    EXPECT_TRUE(control.at("caught"));
    EXPECT_GT(control.at("wrong").at("mean"), 10 * control.at("right").at("mean").get<double>());
    EXPECT_TRUE(said.json().at("knobs").empty());
}

TEST(Accuracy, ComparesWithAnEarlierReport) {
    AccuracyOptions options = quick("earlier");
    auto earlier = run(options, true).json();
    for (auto& level : earlier.at("knobs")[0].at("levels"))
        for (const char* const figure : {"mean", "max"})
            level.at("error").at(figure) = 0.5 * level.at("error").at(figure).get<double>();
    options.compare = {files().folder.write("more_accurate.json", earlier.dump()), options.output + "/accuracy.json"};
    options.slower_percent = 10'000;
    options.output = files().folder.file("later");
    const auto said = run(options, true);
    EXPECT_EQ(said.code, 1);
    ASSERT_EQ(said.json().at("comparisons").size(), 2u);
    const auto less_accurate = [&](std::size_t n) {
        return said.json().at("comparisons")[n].at("levels")[0].at("less_accurate");
    };
    EXPECT_TRUE(less_accurate(0));
    EXPECT_FALSE(less_accurate(1)) << "control: the same errors";
    options.compare.erase(options.compare.begin());
    EXPECT_EQ(run(options, true).code, 0) << "control: only the same errors";
}

TEST(Accuracy, FliesARecordedFlight) {
    AccuracyOptions options = quick("recorded");
    options.knobs = {"terrain_tau"};
    options.flights = {files().log};
    options.display.size = {320, 180};
    const auto json = run(options, true).json();
    EXPECT_EQ(json.at("conditions").at("flight"), files().log);
    EXPECT_EQ(json.at("conditions").at("size"), "320 x 180");
    const std::string command = json.at("knobs")[0].at("levels")[0].at("worst").at("command");
    EXPECT_THAT(command,
                HasSubstr(" --terrain " + files().terrain + " --design default --device es3-mid --size 320x180 --tau 16"));
    ShotOptions shot;
    const std::size_t pose = command.find("--pose ") + 7;
    shot.pose = pose_from(command.substr(pose, command.find(' ', pose) - pose));
    EXPECT_NEAR(shot.pose.latitude_deg, 47.04, 0.01) << "where the log was recorded";
    shot.picture.terrain = files().terrain;
    shot.picture.size = PictureSize{320, 180};
    shot.output = files().folder.file("worst.png");
    EXPECT_EQ(test_support::run_command([&](Console& console) { return run_shot(shot, console); }, true).code, 0);
    options.flights.clear();
    expect_user_error([&] { static_cast<void>(run(options, true)); }, "accuracy.json: was measured with another");
}

TEST(Accuracy, RefusesWrongFlightsAndDisplays) {
    const auto refused = [](const auto& change, const char* sentence) {
        AccuracyOptions options = quick("never_flown");
        change(options);
        expect_user_error([&] { static_cast<void>(run(options, false)); }, sentence);
        EXPECT_FALSE(std::filesystem::exists(options.output)) << sentence;
    };
    refused([](AccuracyOptions& o) { o.flights = {files().folder.file("none.log")}; }, "none.log");
    refused([](AccuracyOptions& o) { o.flights = {files().folder.write("empty.log", "")}; }, "no CAN frame in this file");
    refused([](AccuracyOptions& o) { o.switches = {"x.switches"}; }, "--switches x.switches: has no --flight");
    refused(
        [](AccuracyOptions& o) {
            o.flights = {files().log, files().log, files().log};
            o.terrains = {files().terrain, files().terrain};
        },
        "--terrain: was given 2 times for 3 flights");
    refused([](AccuracyOptions& o) { o.display.size = {63, 200}; }, "--size 63x200: a quarter of it is too small");
    refused([](AccuracyOptions& o) { o.display.device = "no_such"; }, "no_such");
    refused([](AccuracyOptions& o) { o.display.design = "map_north_up"; }, "--design map_north_up: shows a map");
}

TEST(Accuracy, RefusesWrongUsageBeforeItMeasures) {
    AccuracyOptions options = quick("never");
    options.knobs = {"nothing"};
    expect_user_error([&] { static_cast<void>(run(options, false)); }, "--knob nothing: is unknown");
    options = quick("never");
    options.target_error = "much";
    expect_user_error([&] { static_cast<void>(run(options, false)); }, "--target-error much: is no error above 0 with its unit");
    options = quick("never");
    options.terrains = {files().folder.file("none.tdb")};
    EXPECT_THROW(static_cast<void>(run(options, false)), UserError);
    options = quick("never");
    options.compare = {files().folder.write("other.json", R"({"schema": "tedavis.accuracy/0"})")};
    expect_user_error([&] { static_cast<void>(run(options, false)); }, "other.json: has the schema 'tedavis.accuracy/0'");
    EXPECT_FALSE(std::filesystem::exists(options.output)) << "nothing is left";
}

TEST(TargetFrom, ReadsANumberAndItsUnit) {
    EXPECT_EQ(target_from("0.5px").unit, "px");
    EXPECT_EQ(target_from("0.5 px").value, 0.5);
    EXPECT_EQ(target_from("2 cells of the grid").unit, "cells of the grid");
    for (const char* const wrong : {"", "5", "-1 m", "px", "0 m"})
        EXPECT_THROW(static_cast<void>(target_from(wrong)), UserError) << wrong;
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy
