#include "host_sim/terrain_builder/work_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_work_file {
namespace {

using test_support::expect_user_error;

TEST(WorkFile, ReadsBackWhatWasWrittenAnywhere) {
    const test_support::TemporaryFolder folder;
    {
        WorkFile file(folder.file("w"));
        file.write(10, "abc", 3);
        file.write(0, "xy", 2);
        file.sync();
    }
    WorkFile file(folder.file("w"));
    EXPECT_EQ(file.size(), 13u);
    char bytes[13];
    file.read(0, bytes, sizeof bytes);
    EXPECT_EQ(std::string(bytes, sizeof bytes), std::string("xy\0\0\0\0\0\0\0\0abc", 13));
    file.resize(20);
    file.read(15, bytes, 5);
    EXPECT_EQ(std::string(bytes, 5), std::string(5, '\0')) << "what was never written reads as 0";
}

TEST(WorkFile, MovesKeepItOpen) {
    const test_support::TemporaryFolder folder;
    WorkFile first(folder.file("w")), second;
    second = std::move(first);
    second.write(0, "q", 1);
    EXPECT_EQ(second.size(), 1u);
    EXPECT_EQ(second.path(), folder.file("w"));
}

TEST(WorkFile, SaysWhatFails) {
    const test_support::TemporaryFolder folder;
    expect_user_error([&] { WorkFile file(folder.file("no/such/folder")); }, "no/such/folder: cannot be opened");
    expect_user_error([&] { (void)WorkFile::existing(folder.file("none")); }, "none: cannot be read");
    WorkFile file(folder.file("w"));
    file.write(0, "abc", 3);
    char bytes[8];
    expect_user_error([&] { file.read(0, bytes, sizeof bytes); }, "w: cannot be read");
    WorkFile closed = WorkFile::existing(folder.file("w"));
    expect_user_error([&] { closed.write(0, "z", 1); }, "cannot be written");
    EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_work_file
