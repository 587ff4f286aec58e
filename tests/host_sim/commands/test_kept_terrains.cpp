#include "host_sim/commands/kept_terrains.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

#include "host_sim/commands/terrain_cache.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_kept_terrains {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class KeptTerrains : public ::testing::Test {
protected:
    KeptTerrains() {
        setenv("XDG_CACHE_HOME", place_.path().c_str(), 1);
        folder_ = terrain_cache_folder();
        fs::create_directories(folder_);
    }
    ~KeptTerrains() override { unsetenv("XDG_CACHE_HOME"); }

    /// A database with its lock, used so many hours ago.
    std::string keep(const std::string& name, std::size_t bytes, int hours_ago) {
        const std::string path = folder_ + "/" + name + "-0123456789abcdef.tdb";
        const std::string inside = "tedavis/terrain/" + fs::path(path).filename().string();
        static_cast<void>(place_.write(inside, std::string(bytes, 'x')));
        static_cast<void>(place_.write(inside + ".lock", ""));
        const auto used = fs::file_time_type::clock::now() - std::chrono::hours(hours_ago);
        fs::last_write_time(path, used - std::chrono::hours(1000));
        fs::last_write_time(path + ".lock", used);
        return path;
    }
    [[nodiscard]] std::vector<std::string> paths() const {
        std::vector<std::string> found;
        for (const KeptTerrain& kept : kept_terrains(folder_)) found.push_back(kept.path);
        return found;
    }

    test_support::TemporaryFolder place_;
    std::string folder_;
};

TEST_F(KeptTerrains, AreListedByTheirLastUse) {
    const std::string old = keep("old", 100, 50), fresh = keep("fresh", 10, 1), middle = keep("middle", 20, 9);
    EXPECT_THAT(paths(), ElementsAre(fresh, middle, old));
    record_terrain_use(old);
    EXPECT_THAT(paths(), ElementsAre(old, fresh, middle));
    EXPECT_EQ(kept_terrains(folder_)[0].bytes, 100u);
    EXPECT_TRUE(kept_terrains(folder_ + "/none").empty());
}

TEST_F(KeptTerrains, ThoseUsedLongestAgoGoFirst) {
    const std::string a = keep("a", 100, 4), b = keep("b", 100, 3), c = keep("c", 100, 2), d = keep("d", 100, 1);
    EXPECT_TRUE(trim_terrains(folder_, 400, d).empty()) << "the limit itself is allowed";
    const auto removed = trim_terrains(folder_, 399, d);
    ASSERT_EQ(removed.size(), 1u);
    EXPECT_EQ(removed[0].path, a);
    EXPECT_THAT(removed_words(removed), HasSubstr("removed a-0123456789abcdef.tdb (0.0 MB, last used 4.0 h ago)"));
    EXPECT_THAT(paths(), ElementsAre(d, c, b));
    EXPECT_EQ(trim_terrains(folder_, 50, b).size(), 2u);
    EXPECT_THAT(paths(), ElementsAre(b)) << "the one that is needed stays, though it is too large";
}

TEST_F(KeptTerrains, AnInterruptedBuildCountsAndGoesToo) {
    const std::string a = keep("a", 10, 5), b = keep("b", 10, 1);
    fs::create_directories(a + ".part");
    fs::create_directories(folder_ + "/only-fedcba9876543210.tdb.part");
    static_cast<void>(place_.write("tedavis/terrain/" + fs::path(a).filename().string() + ".part/posts", std::string(500, 'x')));
    static_cast<void>(place_.write("tedavis/terrain/only-fedcba9876543210.tdb.part/posts", std::string(7, 'x')));
    for (const KeptTerrain& kept : kept_terrains(folder_)) {
        EXPECT_TRUE(kept.path != a || kept.bytes == 510u) << kept.bytes;
        EXPECT_EQ(kept.is_built, kept.path == a || kept.path == b) << kept.path;
    }
    EXPECT_EQ(trim_terrains(folder_, 0, "").size(), 3u);
    EXPECT_FALSE(fs::exists(a + ".part"));
    EXPECT_TRUE(paths().empty());
}

TEST_F(KeptTerrains, OtherFilesAndWhatIsBeingBuiltStay) {
    const std::string other = place_.write("tedavis/terrain/alps.tdb", "my own");
    const std::string words = place_.write("tedavis/terrain/notes-0123456789abcdef.txt", "my own");
    const std::string built = keep("built", 10, 9);
    const int lock = open((built + ".lock").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_EQ(flock(lock, LOCK_EX | LOCK_NB), 0);
    EXPECT_TRUE(trim_terrains(folder_, 0, "").empty());
    EXPECT_TRUE(fs::exists(other) && fs::exists(words) && fs::exists(built));
    close(lock);
    EXPECT_EQ(trim_terrains(folder_, 0, "").size(), 1u);
    EXPECT_TRUE(fs::exists(other) && fs::exists(words));
}

TEST_F(KeptTerrains, WhatIsUsedStaysUntilItIsNot) {
    const std::string used = keep("used", 10, 9), other = keep("other", 10, 1);
    {
        TerrainUse first(used);
        const TerrainUse use = std::move(first), again(used);
        const auto removed = trim_terrains(folder_, 0, "");
        ASSERT_EQ(removed.size(), 1u);
        EXPECT_EQ(removed[0].path, other);
        EXPECT_THAT(test_support::run_command([](Console& console) { return run_terrain_cache({true}, console); }).results,
                    HasSubstr("; 1 database in use, being built or not removable stay"));
        EXPECT_TRUE(fs::exists(used));
    }
    EXPECT_EQ(trim_terrains(folder_, 0, "").size(), 1u);
    const TerrainUse without_lock(folder_ + "/none.tdb");
    EXPECT_TRUE(paths().empty());
}

TEST_F(KeptTerrains, TheCommandShowsAndClearsThem) {
    const auto run = [](bool clear, bool json) {
        return test_support::run_command([&](Console& console) { return run_terrain_cache({clear}, console); }, json);
    };
    const std::string a = keep("a", 2'500'000, 72), b = keep("b", 10, 1);
    EXPECT_EQ(run(false, false).results,
              folder_ + ": 2 databases, 2.5 MB; beyond 10.0 GB those used longest ago are removed\n  " +
                  "b-0123456789abcdef.tdb: 0.0 MB, used 60 min ago\n  " + "a-0123456789abcdef.tdb: 2.5 MB, used 3 d ago\n");
    EXPECT_THAT(paths(), ElementsAre(b, a)) << "to look removes nothing";
    const auto cleared = run(true, true).json();
    EXPECT_EQ(cleared["removed"].size(), 2u);
    EXPECT_EQ(cleared["databases"].size(), 0u);
    EXPECT_EQ(cleared["folder"], folder_);
    EXPECT_TRUE(paths().empty());
    fs::remove_all(folder_);
    EXPECT_THAT(run(false, false).results, HasSubstr(": 0 databases, 0.0 MB"));
    EXPECT_FALSE(fs::exists(folder_)) << "it is not made";
}

TEST_F(KeptTerrains, WithoutAFolderItSaysWhatToSet) {
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    unsetenv("XDG_CACHE_HOME");
    unsetenv("HOME");
    test_support::expect_user_error(
        [] { (void)test_support::run_command([](Console& console) { return run_terrain_cache({}, console); }); },
        "set HOME or XDG_CACHE_HOME");
    if (!home.empty()) setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_kept_terrains
