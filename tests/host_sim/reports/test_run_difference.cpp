#include "host_sim/reports/run_difference.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/run_folders.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_run_difference {
namespace {

using test_support::write_run;

const auto kSame = [](FrameResult&) {};

class RunDifferenceTest : public ::testing::Test {
protected:
    std::optional<RunDifference> compare() { return first_difference(place_.file("a"), place_.file("b")); }
    test_support::TemporaryFolder place_;
};

TEST_F(RunDifferenceTest, EqualRunsHaveNoneAndTimesDoNotCount) {
    write_run(place_, "a", kSame);
    write_run(place_, "b", [](FrameResult& result) { result.timing = {9, 9, 18}; });
    EXPECT_FALSE(compare());
}

TEST_F(RunDifferenceTest, TheFirstDifferingFrameAndItsEntries) {
    write_run(place_, "a", kSame);
    write_run(place_, "b", [](FrameResult& result) {
        if (result.record.frame < 2) return;
        result.record.terrain.triangles += 1;
        result.record.own_ship.state = base::SignalState::stale;
        EXPECT_TRUE(result.record.flags.try_push_back(display::Name("position.stale")));
    });
    const auto difference = compare();
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->frame, 2u);
    EXPECT_EQ(difference->line, 3u);
    EXPECT_NEAR(difference->time_s, 0.2, 1e-12);
    ASSERT_EQ(difference->entries.size(), 3u);
    EXPECT_EQ(difference->entries[0].entry, "own_ship.state");
    EXPECT_EQ(difference->entries[0].a, "\"valid\"");
    EXPECT_EQ(difference->entries[0].b, "\"stale\"");
    EXPECT_EQ(difference->entries[1].entry, "flags[0]");
    EXPECT_EQ(difference->entries[1].a, "");
    EXPECT_EQ(difference->entries[2].entry, "terrain.triangles");
    EXPECT_EQ(difference->entries[2].b, "12346");
    EXPECT_FALSE(difference->pixels) << "the hashes agree";
}

TEST_F(RunDifferenceTest, ARunThatEndsFirstIsNamed) {
    write_run(place_, "a", kSame);
    write_run(place_, "b", kSame, 3);
    const auto difference = compare();
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->frame, 3u);
    EXPECT_TRUE(difference->b_ended);
    EXPECT_FALSE(difference->a_ended);
    EXPECT_TRUE(difference->entries.empty());
}

class PictureDifferenceTest : public RunDifferenceTest {
protected:
    PictureDifferenceTest() {
        write_run(place_, "a", kSame);
        write_run(place_, "b", [](FrameResult& result) { result.hash += result.record.frame == 1 ? 1 : 0; });
    }
    RgbaPicture picture_{20, 10, std::vector<std::uint8_t>(800, 50)};
};

TEST_F(PictureDifferenceTest, PixelsAreCountedAndBoxed) {
    test_support::write_picture(place_, "a", 1, picture_);
    const auto set = [this](std::size_t x, std::size_t y, std::uint8_t value) { picture_.pixels[(y * 20 + x) * 4 + 1] = value; };
    set(3, 2, 60);
    set(7, 8, 20);
    test_support::write_picture(place_, "b", 1, picture_);
    const auto difference = compare();
    ASSERT_TRUE(difference && difference->pixels);
    EXPECT_EQ(difference->frame, 1u);
    EXPECT_EQ(difference->pixels->count, 2u);
    EXPECT_EQ(difference->pixels->left, 3u);
    EXPECT_EQ(difference->pixels->right, 7u);
    EXPECT_EQ(difference->pixels->top, 2u);
    EXPECT_EQ(difference->pixels->bottom, 8u);
    EXPECT_EQ(difference->pixels->largest, 30u);
    EXPECT_EQ(difference->pixels->note, "");
}

TEST_F(PictureDifferenceTest, SaysWhyPixelsCannotBeCompared) {
    EXPECT_EQ(compare()->pixels->note, "the pictures were not written by both runs");
    test_support::write_picture(place_, "a", 1, picture_);
    test_support::write_picture(place_, "b", 1, picture_);
    EXPECT_EQ(compare()->pixels->note, "the pictures on disk are equal although the recorded hashes differ");
    test_support::write_picture(place_, "b", 1, {10, 20, std::vector<std::uint8_t>(800, 50)});
    EXPECT_EQ(compare()->pixels->note, "the pictures are 20x10 and 10x20");
}

TEST_F(RunDifferenceTest, RefusesWhatIsNoRun) {
    write_run(place_, "a", kSame);
    test_support::expect_user_error([&] { (void)compare(); }, "b/frames.jsonl: cannot be read");
    write_run(place_, "b", kSame);
    for (const char* text : {"words\n", "[1]\n", "{\"frame\":-1}\n", "{\"frame\":0}\n", "\n"}) {
        place_.write("b/frames.jsonl", text);
        test_support::expect_user_error([&] { (void)compare(); }, "b/frames.jsonl:1: no frame record");
    }
    place_.write("b/frames.jsonl", "");
    test_support::expect_user_error([&] { (void)compare(); }, "b/frames.jsonl: holds no frame");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_difference
