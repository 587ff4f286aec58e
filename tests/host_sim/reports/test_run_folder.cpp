#include "host_sim/reports/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_run_folder {
namespace {

TEST(RunFolder, PicturesSortByNameAsByNumber) {
    EXPECT_EQ(frame_picture_path("out", 123), "out/frames/000123.png");
    EXPECT_EQ(frame_picture_path("a/b", 1234567), "a/b/frames/1234567.png");
    EXPECT_LT(frame_picture_path("out", 99), frame_picture_path("out", 100));
}

TEST(RunFolder, ARunIsNotOverwritten) {
    const test_support::TemporaryFolder place;
    require_no_run(place.path());
    require_no_run(place.file("not there"));
    (void)place.write(kFrameRecordsName, "{}");
    test_support::expect_user_error([&] { require_no_run(place.path()); }, "holds a run");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_folder
