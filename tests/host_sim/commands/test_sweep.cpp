#include "host_sim/commands/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_sweep {
namespace {

using ::testing::HasSubstr;

const test_support::FlownFiles& swept_files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

SweepOptions sweep_options(const std::string& output) {
    SweepOptions o;
    o.place = SweptPlace{47.03, 9.68, {}};
    o.rings = {3, {2500}, {-400, 900}};
    o.picture.terrain = swept_files().terrain;
    o.picture.size = PictureSize{160, 120};
    o.output = swept_files().folder.file(output);
    return o;
}

test_support::CommandRun run(const SweepOptions& o, bool json = false) {
    return test_support::run_command([&](Console& console) { return run_sweep(o, console); }, json);
}

TEST(SweepCommand, LeavesPicturesTableAndReport) {
    const SweepOptions o = sweep_options("whole/inner");
    const test_support::CommandRun told = run(o, true);
    EXPECT_EQ(told.code, 0);
    const auto json = told.json();
    EXPECT_EQ(nlohmann::json::parse(read_file(o.output + "/sweep.json")), json);
    EXPECT_EQ(json["views"].size() + json["skipped"].size(), 6u);
    for (const auto& view : json["views"]) EXPECT_TRUE(std::filesystem::exists(o.output + "/" + view["file"].get<std::string>()));
    for (const auto& one : json["standing_out"])
        EXPECT_TRUE(std::filesystem::exists(o.output + "/" + one["sheet"].get<std::string>()));
    EXPECT_THAT(read_file(o.output + "/report.html"), HasSubstr("Viewpoints round 47.0300, 9.6800"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(told.notes.begin(), told.notes.end(), '\n')), json["skipped"].size())
        << "each is told: " << told.notes;
}

TEST(SweepCommand, EqualSweepsGiveEqualResults) {
    SweepOptions one = sweep_options("one"), other = sweep_options("other");
    EXPECT_EQ(run(one, true).results, run(other, true).results);
    other.picture.design = "cruise";
    EXPECT_NE(run(other, true).json()["views"], run(one, true).json()["views"]) << "another design";
}

TEST(SweepCommand, HasGroundOfItsOwn) {
    SweepOptions o;
    o.rings = {1, {3000}, {900}};
    o.picture.size = PictureSize{160, 120};
    o.output = swept_files().folder.file("own");
    const auto json = run(o, true).json();
    EXPECT_EQ(json["terrain"], "the shipped terrain");
    EXPECT_EQ(json["scene"], "that of the shipped scenario");
    ASSERT_EQ(json["views"].size(), 1u);
    EXPECT_GT(json["views"][0]["clutter"], 0);
    o.place = SweptPlace{10, 10, {}};
    o.output = swept_files().folder.file("nowhere");
    test_support::expect_user_error([&] { (void)run(o); }, "known there in the shipped terrain");
    EXPECT_FALSE(std::filesystem::exists(o.output));
}

TEST(SweepCommand, TellsPeople) {
    const std::string text = run(sweep_options("text")).results;
    EXPECT_THAT(text, HasSubstr("text: "));
    EXPECT_THAT(text, HasSubstr("most clutter"));
    EXPECT_THAT(text, HasSubstr("report.html"));
}

TEST(SweepCommand, LeavesNothingWhereItFails) {
    SweepOptions o = sweep_options("none");
    o.rings.distances_m = {90'000};
    test_support::expect_user_error([&] { (void)run(o); }, "outside the terrain");
    EXPECT_FALSE(std::filesystem::exists(o.output));
    o = sweep_options("run");
    std::filesystem::create_directory(o.output);
    (void)swept_files().folder.write("run/frames.jsonl", "{}\n");
    test_support::expect_user_error([&] { (void)run(o); }, "holds a run");
}

}  // namespace
}  // namespace tedavis::host_sim::test_sweep
