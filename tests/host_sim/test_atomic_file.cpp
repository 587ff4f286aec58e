#include "host_sim/atomic_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_atomic_file {
namespace {

TEST(AtomicFile, AppearsOnCommitOnly) {
    const test_support::TemporaryFolder folder;
    {
        AtomicFile file(folder.file("a"));
        file.stream() << "whole";
        EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
        file.commit();
    }
    EXPECT_EQ(folder.read("a"), "whole");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, TakesWhatALibraryWroteToItsPart) {
    const test_support::TemporaryFolder folder;
    AtomicFile file(folder.file("a"));
    std::ofstream(file.part_path()) << "by name";
    file.commit();
    EXPECT_EQ(folder.read("a"), "by name");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, LeavesWhatWasThereWhenAbandoned) {
    const test_support::TemporaryFolder folder;
    folder.write("a", "before");
    {
        AtomicFile file(folder.file("a"));
        file.stream() << "half";
    }
    EXPECT_EQ(folder.read("a"), "before");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, ASealedFileIsNotThereYet) {
    const test_support::TemporaryFolder folder;
    {
        AtomicFile file(folder.file("a"));
        file.stream() << "whole";
        file.seal();
        EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
    }
    EXPECT_EQ(folder.entries(), 0u);
    AtomicFile file(folder.file("a"));
    file.stream() << "whole";
    file.seal();
    file.commit();
    EXPECT_EQ(folder.read("a"), "whole");
}

TEST(AtomicFile, RefusesAPlaceThatCannotBeWritten) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { AtomicFile file(folder.file("none/a")); }, "cannot be written");
    test_support::expect_user_error([&] { AtomicFile file(folder.path()); }, "is a folder");
    test_support::expect_user_error([] { AtomicFile file("/dev/null"); }, "is a device or a pipe");
}

TEST(AtomicFile, ReportsAFullDiskAndLeavesNothing) {
    ASSERT_TRUE(std::filesystem::exists("/dev/full"));
    const test_support::TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder.file("a.part"));
    test_support::expect_user_error(
        [&] {
            AtomicFile file(folder.file("a"));
            file.stream() << std::string(1 << 20, 'x');
            file.commit();
        },
        "free space");
    EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
}

TEST(AtomicFile, MakesFoldersWithTheirParents) {
    const test_support::TemporaryFolder folder;
    make_folder(folder.file("b/c"));
    EXPECT_TRUE(std::filesystem::is_directory(folder.file("b/c")));
    folder.write("file", "");
    test_support::expect_user_error([&] { make_folder(folder.file("file/d")); }, "cannot be made");
}

}  // namespace
}  // namespace tedavis::host_sim::test_atomic_file
