#include "host_sim/shipped_files.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_shipped_files {
namespace {

/// Sets TEDAVIS_ROOT for one test.
class RootGuard {
public:
    explicit RootGuard(const std::string& root) { setenv("TEDAVIS_ROOT", root.c_str(), 1); }
    ~RootGuard() { unsetenv("TEDAVIS_ROOT"); }
};

TEST(ShippedFiles, ResolvesShortNamesBelowTheSourceTree) {
    EXPECT_EQ(resolve_config("es3-mid", "devices"), shipped_root() + "/configs/devices/es3-mid.toml");
}

TEST(ShippedFiles, TheEnvironmentNamesAnotherRoot) {
    const test_support::TemporaryFolder folder;
    const RootGuard root(folder.path());
    std::filesystem::create_directories(folder.file("configs/designs"));
    folder.write("configs/designs/mine.toml", "");
    EXPECT_EQ(resolve_config("mine", "designs"), folder.path() + "/configs/designs/mine.toml");
    std::filesystem::create_directories(folder.file("configs/designs/styles"));
    folder.write("configs/designs/styles/plain.toml", "");
    EXPECT_EQ(resolve_config("styles/plain", "designs"), folder.path() + "/configs/designs/styles/plain.toml");
    test_support::expect_user_error([] { (void)resolve_config("cruise", "designs"); },
                                    "name a file, or one of these: mine, styles/plain");
    test_support::expect_user_error([] { (void)resolve_config("x", "devices"); }, "none in");
}

TEST(ShippedFiles, PathsStayAsTheyAre) {
    const test_support::TemporaryFolder folder;
    const std::string path = folder.write("own.toml", "");
    EXPECT_EQ(resolve_config(path, "designs"), path);
    const std::string bare = folder.write("styles", "");
    EXPECT_EQ(resolve_config(bare, "designs"), bare);
    for (const char* name : {"", "/", "/styles/lambert", "styles/../styles/lambert"})
        test_support::expect_user_error([&] { (void)resolve_config(name, "designs"); }, "no such file");
    test_support::expect_user_error([&] { (void)resolve_config(folder.file("none.toml"), "designs"); }, "no such file");
}

TEST(ShippedFiles, NamesInAFileAreShippedOnesOrStartFromItsFolder) {
    EXPECT_EQ(stated_config("jacksboro", "scenes", "/a/b/s.toml"), shipped_root() + "/configs/scenes/jacksboro.toml");
    EXPECT_EQ(stated_config("own.toml", "scenes", "/a/b/s.toml"), "/a/b/own.toml");
    EXPECT_EQ(stated_config("../own.toml", "scenes", "/a/b/s.toml"), "/a/own.toml");
    EXPECT_EQ(path_from("/a/b/s.toml", "/c/x.tif"), "/c/x.tif") << "an absolute path stays";
    EXPECT_EQ(path_from("s.toml", "x.tif"), "x.tif");
}

}  // namespace
}  // namespace tedavis::host_sim::test_shipped_files
