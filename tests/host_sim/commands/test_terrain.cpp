#include "host_sim/commands/terrain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/terrain/tdb_format.hpp"
#include "tests/support/files/image_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_terrain {
namespace {

using test_support::CommandRun;
using test_support::expect_user_error;
using test_support::run_command;
using ::testing::HasSubstr;

class TerrainCommand : public ::testing::Test {
protected:
    TerrainCommand() {
        test_support::RasterFile file;
        file.columns = 70;
        file.rows = 50;
        file.value = [](int i, int j) { return 500 + 40 * ((i * 7 + j * 13) % 11); };
        raster_ = file.write(place_.file("r.tif"));
        build_.rasters = {raster_};
        build_.output = place_.file("t.tdb");
    }
    CommandRun build(bool json = false) {
        return run_command([&](Console& console) { return run_terrain_build(build_, console); }, json);
    }
    CommandRun check(const TerrainBuildOptions& options) {
        return run_command([&](Console& console) { return run_terrain_check({build_.output, options}, console); }, true);
    }
    CommandRun info() {
        return run_command([&](Console& console) { return run_terrain_info({build_.output}, console); }, true);
    }

    test_support::TemporaryFolder place_;
    std::string raster_;
    TerrainBuildOptions build_;
};

TEST_F(TerrainCommand, TheIdentityOfABuildIsThatOfFilesAndOptions) {
    const std::string identity = terrain_build_identity(build_);
    TerrainBuildOptions other = build_;
    other.output = place_.file("elsewhere.tdb");
    EXPECT_EQ(terrain_build_identity(other), identity) << "wherever it is written";
    other.accuracy_m = 16;
    EXPECT_NE(terrain_build_identity(other), identity);
    other = build_;
    other.bounds = "9.6,46.5,10.2,47.1";
    EXPECT_NE(terrain_build_identity(other), identity);
}

TEST_F(TerrainCommand, WhatIsBuiltIsDescribedAndHolds) {
    build_.accuracy_m = 16;
    const CommandRun built = build(true);
    EXPECT_EQ(built.code, 0);
    EXPECT_EQ(built.notes, "");
    EXPECT_EQ(built.json(), info().json());
    const auto json = info().json();
    EXPECT_EQ(json["columns"], 70);
    EXPECT_EQ(json["rows"], 50);
    EXPECT_NEAR(json["west_deg"].get<double>(), 9.605, 1e-9);
    EXPECT_NEAR(json["south_deg"].get<double>(), 47.095 - 0.49, 1e-9);
    EXPECT_EQ(json["min_height_m"], 500);
    EXPECT_EQ(json["max_height_m"], 900);
    EXPECT_EQ(json["le90_m"], 16);
    EXPECT_EQ(json["source"], "r.tif");
    EXPECT_EQ(json["bytes"].get<std::uintmax_t>(), std::filesystem::file_size(build_.output));
    TerrainBuildOptions rasters_alone = build_;
    rasters_alone.accuracy_m.reset();
    EXPECT_EQ(check(rasters_alone).code, 0) << "the accuracy is taken from the database";
    rasters_alone.accuracy_m = 15;
    EXPECT_EQ(check(rasters_alone).code, 1) << "and held against what is stated";
    const CommandRun checked = check(build_);
    EXPECT_EQ(checked.code, 0);
    EXPECT_EQ(checked.json()["violations"], 0);
    EXPECT_EQ(checked.json()["chunks"], json["chunks"]);
    EXPECT_EQ(checked.json()["worst_excess_m"], 0);
}

TEST_F(TerrainCommand, BuildsTheSameBytesAgain) {
    (void)build();
    const std::string first = place_.read("t.tdb");
    (void)build();
    EXPECT_EQ(place_.read("t.tdb"), first);
}

TEST_F(TerrainCommand, ACheckThatDoesNotHoldIsOne) {
    (void)build();
    test_support::RasterFile other;
    other.columns = 70;
    other.rows = 50;
    other.value = [](int i, int j) { return 500 + 40 * ((i * 7 + j * 13) % 11) + (i == 30 && j == 20 ? 25 : 0); };
    TerrainBuildOptions options = build_;
    options.rasters = {other.write(place_.file("other.tif"))};
    const CommandRun checked = check(options);
    EXPECT_EQ(checked.code, 1);
    EXPECT_GT(checked.json()["violations"], 0);
    EXPECT_GE(checked.json()["worst_excess_m"].get<double>(), 25);
    EXPECT_EQ(checked.json()["violating_chunks"].size(), checked.json()["violations"]);
}

TEST_F(TerrainCommand, BoundsDatumAndVoidsReachTheRaster) {
    build_.bounds = "9.7,46.8,9.9,47";
    build_.vertical_datum = "ellipsoid";
    build_.void_value = 500;
    (void)build();
    const auto json = info().json();
    EXPECT_EQ(json["columns"], 20);
    EXPECT_EQ(json["vertical_datum"], "ellipsoid");
    EXPECT_GT(json["void_posts"], 0);
    EXPECT_LT(json["max_height_m"].get<double>(), 860) << "the geoid lies 50 m above the ellipsoid here";
    EXPECT_EQ(check(build_).code, 0) << "the same options give the same database";
}

TEST_F(TerrainCommand, ExtentAndSystemPlaceAFileThatHasNone) {
    const std::string picture = "P5 40 30 255\n" + std::string(40 * 30, 99);
    build_.rasters = {place_.write("bare.pgm", picture)};
    build_.crs = "EPSG:32632";
    build_.extent = "558000,5185100,559200,5186000";
    (void)build();
    const auto json = info().json();
    EXPECT_NEAR(json["west_deg"].get<double>(), 9.76, 0.01);
    EXPECT_NEAR(json["north_deg"].get<double>(), 46.824, 0.01);
    EXPECT_EQ(json["max_height_m"], 99);
    EXPECT_EQ(json["vertical_datum"], "egm96");
    EXPECT_EQ(check(build_).code, 0);
}

TEST_F(TerrainCommand, RefusesOptionsThatCannotBe) {
    const auto refuses = [&](const std::string& words, auto change) {
        TerrainBuildOptions options = build_;
        change(options);
        expect_user_error([&] { (void)run_command([&](Console& console) { return run_terrain_build(options, console); }); },
                          words);
        EXPECT_FALSE(std::filesystem::exists(build_.output));
    };
    for (const char* bounds : {"1,2,3", "10,46,9,47", "9,47,10,46", "a,b,c,d", "9,46,10,47,1", "nan,46,10,47", "9,46,10,147"})
        refuses("--bounds", [&](TerrainBuildOptions& o) { o.bounds = bounds; });
    for (const char* extent : {"1,2,3", "10,46,9,47", "9,47,10,46", "a,b,c,d"})
        refuses("--extent", [&](TerrainBuildOptions& o) { o.extent = extent; });
    refuses("says itself where it lies", [](TerrainBuildOptions& o) { o.extent = "9,46,10,47"; });
    refuses("--encoding cmyk", [](TerrainBuildOptions& o) { o.encoding = "cmyk"; });
    refuses("no three bands of 8 bits", [](TerrainBuildOptions& o) { o.encoding = "terrarium"; });
    refuses("--vertical-datum moon", [](TerrainBuildOptions& o) { o.vertical_datum = "moon"; });
    refuses("--accuracy", [](TerrainBuildOptions& o) { o.accuracy_m = std::nan(""); });
    refuses("is also an input", [&](TerrainBuildOptions& o) { o.output = raster_; });
    EXPECT_TRUE(std::filesystem::exists(raster_));
}

TEST_F(TerrainCommand, OtherFilesAreNotReplaced) {
    const std::string mine = "my own notes\n";
    place_.write("t.tdb", mine);
    expect_user_error([&] { (void)build(); }, "t.tdb: is there already and is no terrain database");
    EXPECT_EQ(place_.read("t.tdb"), mine);
    std::filesystem::remove(build_.output);
    EXPECT_EQ(build().code, 0);
    EXPECT_EQ(build().code, 0) << "a database makes room for the next";
}

/// Over the raster of the fixture.
test_support::ImageFile image_file() {
    test_support::ImageFile image;
    image.transform = {9.6, 0.0025, 0, 47.1, 0, -0.0025};
    image.columns = 280;
    image.rows = 200;
    return image;
}

TEST_F(TerrainCommand, AnImageIsDrapedDescribedAndChecked) {
    (void)build();
    EXPECT_TRUE(info().json()["drape"].is_null());
    EXPECT_THAT(build().results, HasSubstr("no image drape"));
    build_.drape = image_file().write(place_.file("i.tif"));
    EXPECT_THAT(build().results, HasSubstr("image drape of"));
    const auto json = info().json();
    EXPECT_EQ(json["drape"]["finest_level"], 0);
    EXPECT_NEAR(json["drape"]["texel_deg"].get<double>(), 0.0025, 1e-12);
    EXPECT_GT(json["by_level"][0]["drape_pages"], 5);
    EXPECT_EQ(check(build_).code, 0);
    TerrainBuildOptions without = build_;
    without.drape.clear();
    EXPECT_EQ(check(without).code, 0);
    const std::string first = place_.read("t.tdb");
    (void)build();
    EXPECT_EQ(place_.read("t.tdb"), first);
}

TEST_F(TerrainCommand, AnImageWithoutAPlaceGetsItFromOptions) {
    test_support::ImageFile image = image_file();
    image.placed = false;
    image.crs.clear();
    build_.drape = image.write(place_.file("bare.tif"));
    build_.drape_crs = "EPSG:4326";
    build_.drape_extent = "9.6,46.6,10.3,47.1";
    EXPECT_EQ(build().code, 0);
    EXPECT_EQ(info().json()["drape"]["finest_level"], 0);
}

TEST_F(TerrainCommand, ImagesThatCannotBeDrapedAreRefusedAndNothingIsLeft) {
    const auto refuses = [&](const std::string& words) {
        expect_user_error([&] { (void)build(); }, words);
        EXPECT_FALSE(std::filesystem::exists(build_.output));
        EXPECT_FALSE(std::filesystem::exists(build_.output + ".part"));
    };
    build_.drape = raster_;
    refuses("r.tif: its values are no 8-bit colours");
    build_.drape = place_.file("none.png");
    refuses("none.png: no such file");
    test_support::ImageFile image = image_file();
    image.crs.clear();
    build_.drape = image.write(place_.file("i.tif"));
    refuses("i.tif: the image names no coordinate system on Earth");
    image = image_file();
    image.transform[0] = 50;
    build_.drape = image.write(place_.file("far.tif"));
    refuses("far.tif: the image shows nothing of r.tif");
    build_.drape_extent = "1,2,3";
    refuses("--drape-extent 1,2,3: not W,S,E,N");
    build_.drape.clear();
    refuses("name it with --drape");
    build_.drape_extent.clear();
    build_.drape = image_file().write(place_.file("t.tdb"));
    expect_user_error([&] { (void)build(); }, "t.tdb");
    EXPECT_TRUE(std::filesystem::exists(build_.output)) << "the image is not overwritten";
}

TEST_F(TerrainCommand, InfoTellsOfEveryLevel) {
    (void)build();
    const auto levels = info().json()["by_level"];
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[0]["chunks"], 6);
    EXPECT_EQ(levels[0]["triangles"], 2 * 69 * 49);
    EXPECT_EQ(levels[2]["chunks"], 1);
    EXPECT_GT(levels[2]["worst_error_m"].get<double>(), levels[0]["worst_error_m"].get<double>());
}

TEST_F(TerrainCommand, InfoRefusesADamagedDirectory) {
    (void)build();
    std::string bytes = place_.read("t.tdb");
    place_.write("t.tdb", bytes.substr(0, bytes.size() / 2));
    expect_user_error([&] { (void)info(); }, "t.tdb: is shorter than its header says");
    bytes[100] = static_cast<char>(bytes[100] ^ 1);
    place_.write("t.tdb", bytes);
    expect_user_error([&] { (void)info(); }, "t.tdb: has a damaged header");
}

TEST_F(TerrainCommand, ADamagedHeaderDoesNotHold) {
    (void)build();
    std::string bytes = place_.read("t.tdb");
    bytes[offsetof(terrain::FileHeader, source) + 100] ^= 1;
    place_.write("t.tdb", bytes);
    const CommandRun checked = check(build_);
    EXPECT_EQ(checked.code, 1);
    EXPECT_GE(checked.json()["violations"], 1);
}

TEST_F(TerrainCommand, ALeftOverFolderOfOtherOptionsIsNotTakenOver) {
    std::filesystem::create_directory(place_.file("t.tdb.part"));
    place_.write("t.tdb.part/journal", "of something else");
    EXPECT_EQ(build().code, 0);
    EXPECT_FALSE(std::filesystem::exists(place_.file("t.tdb.part")));
    EXPECT_EQ(check(build_).code, 0);
}

TEST_F(TerrainCommand, FractalTerrainIsARasterThatBuilds) {
    TerrainFractalOptions options;
    options.size = 100;
    options.seed = 7;
    options.output = place_.file("f.tif");
    const CommandRun made = run_command([&](Console& console) { return run_terrain_fractal(options, console); }, true);
    EXPECT_EQ(made.code, 0);
    EXPECT_EQ(made.json()["size"], 100);
    EXPECT_EQ(made.json()["seed"], 7);
    EXPECT_EQ(load_rasters({options.output}, {}).columns, 100u);
    for (const std::uint32_t size : {2u, 200000u}) {
        expect_user_error(
            [&] {
                (void)run_command([&](Console& console) {
                    return run_terrain_fractal({size, 1, place_.file("x.tif"), "int16"}, console);
                });
            },
            "--size");
    }
    EXPECT_FALSE(std::filesystem::exists(place_.file("x.tif")));
    expect_user_error(
        [&] {
            (void)run_command([&](Console& console) {
                return run_terrain_fractal({100, 1, place_.file("x.tif"), "bits"}, console);
            });
        },
        "--type bits: unknown; choose float32 or int16");
}

TEST_F(TerrainCommand, FractalTerrainReplacesItsOwnRastersOnly) {
    TerrainFractalOptions options;
    options.size = 100;
    options.output = place_.file("f.tif");
    const auto make = [&] { return run_command([&](Console& console) { return run_terrain_fractal(options, console); }).code; };
    const std::string dem = place_.read("r.tif");
    for (const std::string& other : {std::string("my own notes\n"), dem}) {
        place_.write("f.tif", other);
        expect_user_error([&] { (void)make(); }, "f.tif: is there already and is no generated terrain");
        EXPECT_EQ(place_.read("f.tif"), other);
    }
    std::filesystem::remove(options.output);
    EXPECT_EQ(make(), 0);
    const std::string first = place_.read("f.tif");
    EXPECT_EQ(make(), 0);
    EXPECT_EQ(place_.read("f.tif"), first);
}

TEST_F(TerrainCommand, NotesOfTheRasterReachTheUser) {
    test_support::RasterFile two;
    two.bands = 2;
    build_.rasters = {two.write(place_.file("two.tif"))};
    EXPECT_THAT(build().notes, HasSubstr("two.tif: has 2 bands"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain
