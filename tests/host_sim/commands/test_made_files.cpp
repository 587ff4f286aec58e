#include "host_sim/commands/made_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_made_files {
namespace {

TEST(MadeFiles, GoUnlessTheyAreKept) {
    const test_support::TemporaryFolder folder;
    const std::string old = folder.write("old", "before");
    for (const bool is_kept : {false, true}) {
        MadeFiles made;
        made.add(old);
        made.add(folder.file("new"));
        made.add(folder.file("never_written"));
        folder.write("new", "now");
        folder.write("old", "replaced");
        if (is_kept) made.keep();
    }
    EXPECT_TRUE(std::filesystem::exists(folder.file("new"))) << "kept";
    {
        MadeFiles made;
        made.add(folder.file("other"));
        folder.write("other", "now");
    }
    EXPECT_FALSE(std::filesystem::exists(folder.file("other")));
    EXPECT_EQ(folder.read("old"), "replaced") << "what was there before stays";
}

}  // namespace
}  // namespace tedavis::host_sim::test_made_files
