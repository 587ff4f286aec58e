#include "host_sim/pack/packed_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_packed_file {
namespace {

TEST(PackedFile, IsAddedOnceAndNeverOverAnother) {
    const test_support::TemporaryFolder folder;
    const std::string one = folder.write("one", "1"), two = folder.write("two", "1");
    PackedFiles files;
    add_packed({one, "a/x", {}, {}, {}}, files);
    add_packed({folder.path() + "/./one", "a/x", {}, {}, {}}, files);
    add_packed({two, "b/x", {}, {}, {}}, files);
    EXPECT_EQ(files.size(), 2u);
    test_support::expect_user_error([&] { add_packed({two, "a/x", {}, {}, {}}, files); }, "two: would lie in the pack where ");
}

}  // namespace
}  // namespace tedavis::host_sim::test_packed_file
