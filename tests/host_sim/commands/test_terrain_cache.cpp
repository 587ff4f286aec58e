#include "host_sim/commands/terrain_cache.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <thread>

#include "host_sim/commands/kept_terrains.hpp"
#include "tests/host_sim/terrain_builder/height_files.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_terrain_cache {
namespace {

namespace fs = std::filesystem;
using test_support::expect_user_error;
using ::testing::HasSubstr;
using ::testing::Not;

class TerrainCache : public ::testing::Test {
protected:
    TerrainCache() {
        setenv("XDG_CACHE_HOME", place_.path().c_str(), 1);
        write_raster(0);
        build_.rasters = {raster_};
    }
    ~TerrainCache() override { unsetenv("XDG_CACHE_HOME"); }

    void write_raster(double higher) {
        test_support::RasterFile file;
        file.columns = 40;
        file.rows = 30;
        file.value = [higher](int i, int j) { return 500 + higher + 40 * ((i * 7 + j * 13) % 11); };
        file.write(raster_);
    }
    /// The path; what was said lies in `notes_`.
    std::string cached() {
        std::string path;
        notes_ = test_support::run_command([&](Console& console) {
                     path = cached_terrain(build_, console);
                     return 0;
                 }).notes;
        return path;
    }
    /// Databases in the cache.
    [[nodiscard]] std::size_t databases() const {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(terrain_cache_folder()))
            count += entry.path().extension() == ".tdb" ? 1 : 0;
        return count;
    }

    test_support::TemporaryFolder place_;
    std::string raster_ = place_.file("alps.tif"), notes_;
    TerrainBuildOptions build_;
};

TEST_F(TerrainCache, ADatabaseIsBuiltOnceAndSaid) {
    const std::string path = cached();
    EXPECT_THAT(notes_, HasSubstr("terrain was built for this and later flights: " + path));
    EXPECT_THAT(path, HasSubstr(place_.path() + "/tedavis/terrain/alps-"));
    const auto written = fs::last_write_time(path);
    EXPECT_EQ(cached(), path);
    EXPECT_EQ(notes_, "note: terrain from the cache: " + path + "\n");
    EXPECT_EQ(fs::last_write_time(path), written);
    EXPECT_EQ(databases(), 1u);
}

TEST_F(TerrainCache, AUseIsKnownThoughTheDatabaseIsNotTouched) {
    const std::string path = cached(), lock = path + ".lock";
    const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(100);
    fs::last_write_time(path, long_ago);
    fs::last_write_time(lock, long_ago);
    EXPECT_EQ(cached(), path);
    EXPECT_EQ(fs::last_write_time(path), long_ago);
    EXPECT_GT(fs::last_write_time(lock), long_ago + std::chrono::hours(99));
    EXPECT_EQ(kept_terrains(terrain_cache_folder()).size(), 1u) << "names of the cache are told from others";
}

TEST_F(TerrainCache, AnotherRasterOrOptionIsAnotherDatabase) {
    const std::string path = cached();
    build_.accuracy_m = 16;
    const std::string with_accuracy = cached();
    EXPECT_NE(with_accuracy, path);
    build_.accuracy_m.reset();
    write_raster(1);
    fs::last_write_time(raster_, fs::last_write_time(raster_) + std::chrono::seconds(5));
    const std::string changed = cached();
    EXPECT_NE(changed, path);
    EXPECT_EQ(databases(), 3u);
}

/// They may move, project, mask or scale it.
TEST_F(TerrainCache, AChangedFileBesideTheRasterIsAnotherDatabase) {
    const std::string without = cached();
    std::set<std::string> paths{without};
    for (const char* const name : {"alps.tif.aux.xml", "alps.tif.ovr", "alps.tif.msk"}) {
        const std::string aux = place_.write(name, "<PAMDataset></PAMDataset>");
        EXPECT_TRUE(paths.insert(cached()).second) << name << " is there";
        fs::last_write_time(aux, fs::last_write_time(aux) + std::chrono::seconds(5));
        EXPECT_TRUE(paths.insert(cached()).second) << name << " was changed";
        fs::remove(aux);
        EXPECT_EQ(cached(), without) << "it is gone again";
    }
}

TEST_F(TerrainCache, AChangedWorldFileIsAnotherDatabase) {
    test_support::RasterFile file;
    file.transform = {0, 1, 0, 0, 0, 1};  // none
    file.type = GDT_Byte;
    file.value = [](int i, int j) { return 3.0 * i + j; };
    const std::string world = place_.write("hills.wld", "0.01\n0\n0\n-0.01\n9.605\n47.095\n");
    build_.rasters = {test_support::write_as("PNG", file, place_.file("hills.png"))};
    build_.crs = "EPSG:4326";
    const std::string before = cached();
    static_cast<void>(place_.write("hills.wld", "0.01\n0\n0\n-0.01\n10.605\n47.095\n"));
    fs::last_write_time(world, fs::last_write_time(world) + std::chrono::seconds(5));
    EXPECT_NE(cached(), before);
}

TEST_F(TerrainCache, ADamagedDatabaseIsBuiltAnew) {
    const std::string path = cached();
    const auto bytes = fs::file_size(path);
    fs::resize_file(path, bytes / 2);
    EXPECT_EQ(cached(), path);
    EXPECT_THAT(notes_, HasSubstr("terrain was built"));
    EXPECT_EQ(fs::file_size(path), bytes);
}

TEST_F(TerrainCache, OneProcessBuildsAndAnotherWaitsForIt) {
    const std::string path = cached();
    const std::string aside = place_.file("aside.tdb");
    fs::rename(path, aside);
    const int other = open((path + ".lock").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(other, 0);
    ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0) << "nobody holds it after a build";
    std::thread waiting([&] { EXPECT_EQ(cached(), path); });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_FALSE(fs::exists(path)) << "it does not build beside the other";
    fs::rename(aside, path);
    close(other);
    waiting.join();
    EXPECT_THAT(notes_, HasSubstr("another tedavis builds " + path));
    EXPECT_THAT(notes_, HasSubstr("terrain from the cache"));
    EXPECT_THAT(notes_, Not(HasSubstr("was built")));
}

TEST_F(TerrainCache, WhatCannotBeBuiltIsRefusedAndNoDatabaseAppears) {
    build_.rasters = {place_.file("missing.tif")};
    expect_user_error([&] { cached(); }, "missing.tif");
    build_.rasters = {place_.write("words.tif", "no raster")};
    expect_user_error([&] { cached(); }, "words.tif");
    EXPECT_EQ(databases(), 0u);
}

TEST_F(TerrainCache, TheFolderIsThatOfTheEnvironment) {
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    setenv("XDG_CACHE_HOME", "relative", 1);
    setenv("HOME", "/home/pilot", 1);
    EXPECT_EQ(terrain_cache_folder(), "/home/pilot/.cache/tedavis/terrain");
    unsetenv("HOME");
    EXPECT_EQ(terrain_cache_folder(), "");
    expect_user_error([&] { cached(); }, "set HOME or XDG_CACHE_HOME");
    if (!home.empty()) setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_cache
