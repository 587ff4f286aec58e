#include "host_sim/reports/run_folder.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_run_folder {
namespace {

TEST(RunFolder, PicturesSortByNameAsByNumber) {
    EXPECT_EQ(frame_picture_path("out", 123), "out/frames/000123.png");
    EXPECT_EQ(frame_picture_path("a/b", 1234567), "a/b/frames/1234567.png");
    EXPECT_LT(frame_picture_path("out", 99), frame_picture_path("out", 100));
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_folder
