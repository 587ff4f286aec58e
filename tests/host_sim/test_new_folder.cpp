#include "host_sim/new_folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_new_folder {
namespace {

TEST(NewFolder, GoesAgainWithTheParentsItMade) {
    const test_support::TemporaryFolder place;
    for (const char* ending : {"", "/", "/."}) {
        {
            const NewFolder folder(place.file("a/b/c") + ending);
            EXPECT_TRUE(std::filesystem::is_directory(place.file("a/b/c")));
        }
        EXPECT_EQ(place.entries(), 0u) << ending;
    }
}

TEST(NewFolder, StaysWhenKept) {
    const test_support::TemporaryFolder place;
    {
        NewFolder folder(place.file("a/b"));
        folder.keep();
    }
    EXPECT_TRUE(std::filesystem::is_directory(place.file("a/b")));
}

TEST(NewFolder, NeverTakesWhatItDidNotMake) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directory(place.file("mine"));
    { const NewFolder folder(place.file("mine")); }
    EXPECT_TRUE(std::filesystem::is_directory(place.file("mine")));
    {
        const NewFolder folder(place.file("new"));
        place.write("new/result", "x");
    }
    EXPECT_EQ(place.read("new/result"), "x");
}

TEST(NewFolder, RefusesAPlaceThatIsAFile) {
    const test_support::TemporaryFolder place;
    place.write("file", "");
    test_support::expect_user_error([&] { const NewFolder folder(place.file("file/a")); }, "cannot be made");
    test_support::expect_user_error([&] { const NewFolder folder(place.file("file")); }, "cannot be made");
    EXPECT_EQ(place.entries(), 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_new_folder
