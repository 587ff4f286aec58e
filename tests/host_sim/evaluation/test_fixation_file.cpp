#include "host_sim/evaluation/fixation_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_fixation_file {
namespace {

class FixationCsv : public ::testing::Test {
protected:
    FixationFile read(const std::string& text) { return read_fixations(place_.write("gaze.csv", text)); }
    void refused(const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { (void)read(text); }, words);
    }
    test_support::TemporaryFolder place_;
};

TEST_F(FixationCsv, PixelsFilesAndTimes) {
    const FixationFile file = read("\xef\xbb\xbf# gaze\r\ny,file,x,time_s,who\r\n10.5,a.png,20,1.5,p1\n\n0,b.png,0,-2,p2\n");
    ASSERT_EQ(file.fixations.size(), 2u);
    EXPECT_EQ(file.fixations[0].x, 20);
    EXPECT_EQ(file.fixations[0].y, 10.5);
    EXPECT_EQ(file.fixations[0].file, "a.png");
    EXPECT_EQ(file.fixations[0].time_s, 1.5);
    EXPECT_EQ(file.fixations[1].line, 5u);
    EXPECT_TRUE(file.has_files && file.has_times && !file.in_shares);
    EXPECT_EQ(gaze_pixel(file, file.fixations[0], 100, 100)->x, 20u);
    EXPECT_EQ(gaze_pixel(file, file.fixations[0], 100, 100)->y, 10u);
    EXPECT_FALSE(gaze_pixel(file, file.fixations[0], 20, 100).has_value()) << "x 20 lies beyond 20 columns";
}

TEST_F(FixationCsv, SharesWhereNothingIsAboveOne) {
    const FixationFile file = read("x,y\n0.5,0.25\n1,1\n0,0\n");
    EXPECT_TRUE(file.in_shares);
    EXPECT_EQ(gaze_pixel(file, file.fixations[0], 100, 40)->x, 50u);
    EXPECT_EQ(gaze_pixel(file, file.fixations[0], 100, 40)->y, 10u);
    EXPECT_EQ(gaze_pixel(file, file.fixations[1], 100, 40)->x, 99u) << "the far edge belongs to the last pixel";
    const FixationFile beside = read("x,y\n-0.1,0.5\n");
    EXPECT_FALSE(gaze_pixel(beside, beside.fixations[0], 10, 10).has_value());
}

TEST_F(FixationCsv, SaysHowManyMissed) {
    const FixationFile file = read("x,y\n10,20\n30,40\n");
    EXPECT_EQ(words_about_missed(file, 2), "");
    EXPECT_THAT(words_about_missed(file, 1), ::testing::HasSubstr("gaze.csv: 1 of 2 fixations lie on none"));
}

TEST_F(FixationCsv, SaysWhereItIsWrong) {
    refused("", "gaze.csv: empty");
    refused("a,b\n1,2\n", "gaze.csv:1: no columns x and y");
    refused("x,y,x\n1,2,3\n", "gaze.csv:1: two columns x");
    refused("x,y\n", "holds no fixation");
    refused("x,y\n1,2\n3,four\n", "gaze.csv:3: 'four' is no number for y");
    refused("x,y\n1,nan\n", "gaze.csv:2: 'nan' is no number");
    refused("x,y\n1\n", "gaze.csv:2: 1 cells where the first line names 2");
    refused("x,y,time_s\n1,2,\n", "gaze.csv:2: '' is no number for time_s");
}

}  // namespace
}  // namespace tedavis::host_sim::test_fixation_file
