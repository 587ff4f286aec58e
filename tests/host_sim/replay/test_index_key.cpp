// The key must change with everything that the states in an index depend on, and with nothing else.
#include "host_sim/replay/index_key.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>

#include "platform/files/file_byte_source.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_index_key {
namespace {

using test_support::TemporaryFolder;

FileIdentity identity(const std::string& path) {
    platform::FileByteSource content = std::move(platform::open_file(path.c_str()).value());
    return file_identity(path, content);
}

TEST(IndexKey, NamesTheFirstPartThatDiffers) {
    IndexKey a;
    EXPECT_EQ(first_difference(a, a), nullptr);
    const char* const names[] = {"the program",         "the log",           "the bus settings",
                                 "the switch log",      "the switch config", "the aircraft or the phase",
                                 "the terrain database"};
    for (std::size_t n = IndexKey::count_; n-- > 0;) {
        IndexKey b = a;
        b.parts[n] = 1;
        EXPECT_STREQ(first_difference(a, b), names[n]);
    }
}

TEST(IndexKey, AFileIsItselfUntilItChanges) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.log", "abc");
    const std::uint64_t before = identity(path).hash;
    EXPECT_EQ(identity(path).hash, before);
    static_cast<void>(folder.write("a.log", "abd"));
    EXPECT_NE(identity(path).hash, before);
    EXPECT_GT(identity(path).changed_ns, 0);
}

TEST(IndexKey, TimesAloneTellThatAFileWasWrittenAgain) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.toml", "abc");
    const std::uint64_t before = times_identity(path);
    EXPECT_EQ(times_identity(path), before);
    std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(1));
    EXPECT_NE(times_identity(path), before);
    test_support::expect_user_error([&] { static_cast<void>(times_identity(folder.file("b.toml"))); }, "cannot be looked at");
}

TEST(IndexKey, ARestoredModificationTimeDoesNotDeceiveIt) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.log", std::string(300'000, 'x'));
    const struct timespec old[2] = {{1'600'000'000, 0}, {1'600'000'000, 0}};
    ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), old, 0), 0);
    const FileIdentity before = identity(path);
    struct stat now {};
    do {  // until the clock of the file system has ticked
        std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(150'000).put('y');
        ASSERT_EQ(utimensat(AT_FDCWD, path.c_str(), old, 0), 0);
        ASSERT_EQ(stat(path.c_str(), &now), 0);
    } while (std::int64_t{now.st_ctim.tv_sec} * 1'000'000'000 + now.st_ctim.tv_nsec == before.changed_ns);
    EXPECT_NE(identity(path).hash, before.hash);
}

TEST(IndexKey, SamplesTheEndsOfAFileEvenIfItsTimesLie) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.log", std::string(300'000, 'x'));
    const std::string twin = folder.write("b.log", std::string(299'999, 'x') + "y");
    // The same path and times, other bytes: what a file system without change times would show.
    platform::FileByteSource own = std::move(platform::open_file(path.c_str()).value());
    platform::FileByteSource other = std::move(platform::open_file(twin.c_str()).value());
    EXPECT_NE(file_identity(path, own).hash, file_identity(path, other).hash);
}

TEST(IndexKey, RefusesAFileThatIsGone) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.log", "abc");
    platform::FileByteSource content = std::move(platform::open_file(path.c_str()).value());
    std::filesystem::remove(path);
    test_support::expect_user_error([&] { static_cast<void>(file_identity(path, content)); }, "a.log: cannot be looked at");
}

TEST(IndexKey, TextsAndPrograms) {
    EXPECT_EQ(text_identity(""), 0u);
    EXPECT_EQ(text_identity("a"), text_identity("a"));
    EXPECT_NE(text_identity("a"), text_identity("b"));
    EXPECT_NE(program_identity(), 0u);
    EXPECT_EQ(program_identity(), program_identity());
}

TEST(IndexKey, TerrainIsToldByItsHeights) {
    const test_support::BuiltDatabase a(test_support::make_rough_raster(150, 150, 1));
    const test_support::BuiltDatabase same(test_support::make_rough_raster(150, 150, 1));
    const test_support::BuiltDatabase other(test_support::make_rough_raster(150, 150, 2));
    EXPECT_EQ(terrain_identity(nullptr), 0u);
    EXPECT_EQ(terrain_identity(&a.database), terrain_identity(&same.database));
    EXPECT_NE(terrain_identity(&a.database), terrain_identity(&other.database));
    EXPECT_NE(terrain_identity(&a.database), 0u);
}

TEST(IndexKey, OnePostOfTheTerrainIsEnough) {
    host_sim::Raster raster = test_support::make_rough_raster(150, 150, 1);
    const test_support::BuiltDatabase a(raster);
    raster.height_m[raster.at(70, 70)] += 0.25f;
    const test_support::BuiltDatabase b(std::move(raster));
    EXPECT_NE(terrain_identity(&a.database), terrain_identity(&b.database));
}

}  // namespace
}  // namespace tedavis::host_sim::test_index_key
