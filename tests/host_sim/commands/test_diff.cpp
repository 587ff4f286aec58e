#include "host_sim/commands/diff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/run_folders.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::host_sim::test_diff {
namespace {

using test_support::CommandRun;
using test_support::run_command;
using test_support::write_run;
using ::testing::HasSubstr;

class DiffCommand : public ::testing::Test {
protected:
    CommandRun diff(bool json) {
        return run_command([&](Console& console) { return run_diff({place_.file("a"), place_.file("b")}, console); }, json);
    }
    test_support::TemporaryFolder place_;
};

TEST_F(DiffCommand, EqualRunsAreZero) {
    for (const char* name : {"a", "b"}) write_run(place_, name, [](FrameResult&) {});
    EXPECT_EQ(diff(false).code, 0);
    EXPECT_EQ(diff(false).results, "the runs are the same\n");
    EXPECT_EQ(diff(true).json(), nlohmann::json({{"same", true}}));
}

TEST_F(DiffCommand, DifferentRunsAreOneAndSayWhere) {
    write_run(place_, "a", [](FrameResult&) {});
    write_run(place_, "b", [](FrameResult& result) {
        if (result.record.frame < 2) return;
        result.hash ^= 1;
        result.record.terrain.triangles = 7;
    });
    RgbaPicture picture{8, 8, std::vector<std::uint8_t>(256, 9)};
    test_support::write_picture(place_, "a", 2, picture);
    picture.pixels[0] = 19;
    test_support::write_picture(place_, "b", 2, picture);
    const CommandRun text = diff(false);
    EXPECT_EQ(text.code, 1);
    for (const char* part : {"frame 2", "terrain.triangles", "12345", "1 differ"}) EXPECT_THAT(text.results, HasSubstr(part));
    const auto json = diff(true).json();
    EXPECT_EQ(json["same"], false);
    EXPECT_EQ(json["frame"], 2);
    EXPECT_EQ(json["line"], 3);
    EXPECT_EQ(json["pixels"]["count"], 1);
    EXPECT_EQ(json["pixels"]["largest"], 10);
    EXPECT_EQ(json["entries"].size(), 2u) << "the hash and the triangles";
}

TEST_F(DiffCommand, ARunThatEndsFirstDiffers) {
    write_run(
        place_, "a", [](FrameResult&) {}, 2);
    write_run(place_, "b", [](FrameResult&) {});
    EXPECT_EQ(diff(true).code, 1);
    EXPECT_EQ(diff(true).json()["a_ended"], true);
}

}  // namespace
}  // namespace tedavis::host_sim::test_diff
