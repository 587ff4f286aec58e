#include "host_sim/commands/sheet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "host_sim/png_file.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"

namespace tedavis::host_sim::test_sheet {
namespace {

using test_support::CommandRun;
using ::testing::HasSubstr;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

std::string sheet_of(const std::string& second_design) {
    return "title = 'Two ways'\ncolumns = 2\nterrain = 'jacksboro_srtm3.tif'\nwidth_px = 160\nheight_px = 120\n"
           "[pose]\nlatitude_deg = 47.03\nlongitude_deg = 9.68\naltitude_msl_m = 2500\nheading_deg = 40\npitch_deg = -6\n"
           "[[group]]\ntitle = 'Shade'\n[[group.picture]]\ntitle = 'One light'\ndesign = 'styles/lambert'\n"
           "[[group]]\ntitle = 'Texture'\n[[group.picture]]\ntitle = 'Heights'\ndesign = '" +
           second_design + "'\n";
}

SheetOptions options(const std::string& output) {
    SheetOptions o;
    o.sheet = files().folder.write("two.toml", sheet_of("styles/hypsometric_tints"));
    o.output = files().folder.file(output);
    o.picture.terrain = files().terrain;
    return o;
}

CommandRun run(const SheetOptions& o, bool json = false) {
    return test_support::run_command([&](Console& console) { return run_sheet(o, console); }, json);
}

void refused(const SheetOptions& o, const std::string& words) {
    test_support::expect_user_error([&] { (void)run(o); }, words);
    EXPECT_FALSE(std::filesystem::exists(o.output)) << "nothing half written";
}

TEST(SheetCommand, LeavesPicturesSheetPageAndRecords) {
    const SheetOptions o = options("whole/inner");
    const CommandRun told = run(o, true);
    EXPECT_EQ(told.code, 0);
    EXPECT_EQ(told.notes, "");
    const auto json = told.json();
    EXPECT_EQ(nlohmann::json::parse(files().folder.read("whole/inner/sheet.json")), json);
    EXPECT_EQ(json.at("terrain"), files().terrain);
    ASSERT_EQ(json.at("pictures").size(), 2u);
    EXPECT_NE(json.at("pictures").at(0).at("hash"), json.at("pictures").at(1).at("hash"));
    for (const auto& picture : json.at("pictures")) {
        EXPECT_GT(picture.at("triangles"), 100);
        EXPECT_EQ(read_png(o.output + "/" + picture.at("file").get<std::string>()).width, 160u);
    }
    const RgbaPicture sheet = read_png(o.output + "/sheet.png");
    EXPECT_GT(sheet.width, 2 * 160u);
    EXPECT_GT(sheet.height, 2 * 120u) << "a row for each group";
    EXPECT_THAT(files().folder.read("whole/inner/index.html"), HasSubstr("One light"));
    EXPECT_THAT(run(o).results, HasSubstr("2 pictures of " + files().terrain));
}

TEST(SheetCommand, LayersLieBesideThePicturesThatTheyLeaveAsTheyAre) {
    SheetOptions o = options("layered");
    const auto plain = run(o, true).json();
    EXPECT_FALSE(std::filesystem::exists(o.output + "/lambert.layers.png"));
    o.layers = true;
    const auto layered = run(o, true).json();
    EXPECT_EQ(layered.at("pictures").at(0).at("hash"), plain.at("pictures").at(0).at("hash"));
    const RgbaPicture mask = read_png(o.output + "/lambert.layers.png");
    EXPECT_EQ(mask.width, 160u);
    std::set<std::uint8_t> layers;
    for (std::size_t n = 0; n < mask.pixels.size(); n += 4) layers.insert(mask.pixels[n]);
    EXPECT_EQ(layers, (std::set<std::uint8_t>{0, 4})) << "terrain and symbology";
}

TEST(SheetCommand, SizeAndPoseReplaceTheSheetsOwn) {
    SheetOptions o = options("own");
    const auto first = run(o, true).json();
    EXPECT_EQ(run(o, true).json(), first) << "equal input, equal pictures";
    o.picture.size = PictureSize{96, 64};
    o.pose = AircraftPose{47.04, 9.68, 2600, 90, -8, 0};
    const auto other = run(o, true).json();
    EXPECT_EQ(read_png(o.output + "/lambert.png").width, 96u);
    EXPECT_EQ(other.at("pose").at("heading_deg"), 90);
    o.pose->heading_deg = 95;
    EXPECT_NE(run(o, true).json().at("pictures").at(0).at("hash"), other.at("pictures").at(0).at("hash"));
}

TEST(SheetCommand, WithoutTerrainTheDefaultIsBuilt) {
    SheetOptions o = options("default");
    o.picture.terrain.clear();
    o.pose = AircraftPose{36.55, -84.2, 1200, 320, -8, 0};
    const CommandRun told = run(o, true);
    EXPECT_EQ(told.code, 0) << told.notes;
    EXPECT_EQ(told.json().at("terrain"), "jacksboro_srtm3.tif");
    EXPECT_GT(told.json().at("pictures").at(0).at("triangles"), 100);
    for (const auto& entry : std::filesystem::directory_iterator(o.output))
        EXPECT_NE(entry.path().extension(), ".tdb") << "the database was only a step";
}

TEST(SheetCommand, AGeneratedImageIsShownAndSaid) {
    SheetOptions o = options("image");
    const std::string plain = sheet_of("styles/aerial_image");
    o.sheet = files().folder.write("image.toml", "generated_image = true\n" + plain);
    o.picture.terrain.clear();
    o.pose = AircraftPose{36.55, -84.2, 1200, 320, -8, 0};
    const auto shown = run(o, true).json().at("pictures");
    EXPECT_EQ(shown.at(0).at("title"), "One light") << "the others are as they were";
    EXPECT_EQ(shown.at(1).at("title"), "Heights (generated)");
    o.sheet = files().folder.write("plain.toml", plain);
    const auto without = run(o, true).json().at("pictures");
    EXPECT_EQ(without.at(0).at("title"), "One light");
    EXPECT_EQ(without.at(1).at("title"), "Heights (the terrain database has no image)");
    EXPECT_THAT(files().folder.read("image/index.html"), HasSubstr("<b>Heights (the terrain database has no image)</b>"));
    EXPECT_THAT(without.at(1).at("flags").dump(), HasSubstr("terrain.no_image"));
    EXPECT_NE(without.at(1).at("hash"), shown.at(1).at("hash"));
    EXPECT_EQ(without.at(0).at("hash"), shown.at(0).at("hash"));
}

/// Table 5.1 of the thesis, measured on one view.
TEST(SheetCommand, PriorityMovesEdgesColorsAndGlyphs) {
    SheetOptions o = options("priority");
    o.sheet = "priority";
    o.picture.terrain.clear();
    o.picture.size = PictureSize{320, 240};
    const auto pictures = run(o, true).json().at("pictures");
    ASSERT_GE(pictures.size(), 3u);
    const auto measure = [&](std::size_t n, const char* name) { return pictures.at(n).at("measures").at(name).get<double>(); };
    constexpr std::size_t kTerrain = 0, kData = 1, kUncertainty = 2;
    EXPECT_GT(measure(kTerrain, "edge_density"), 1.2 * measure(kData, "edge_density"));
    EXPECT_GT(measure(kTerrain, "edge_density"), 1.2 * measure(kUncertainty, "edge_density"));
    EXPECT_GT(measure(kData, "data_colors"), 10 * measure(kTerrain, "data_colors"));
    EXPECT_GT(measure(kData, "data_colors"), 10 * measure(kUncertainty, "data_colors"));
    EXPECT_GT(measure(kTerrain, "data_colors"), 1);
    EXPECT_EQ(measure(kTerrain, "glyphs"), 0);
    EXPECT_EQ(measure(kData, "glyphs"), 0);
    EXPECT_GT(measure(kUncertainty, "glyphs"), 20);
    EXPECT_EQ(pictures.at(kData).at("weights").at("data").at("weight"), 1);
}

TEST(SheetCommand, WrongInputLeavesNothing) {
    SheetOptions o = options("none");
    o.sheet = "no-such-sheet";
    refused(o,
            "no-such-sheet: no such file and no shipped one of sheets; name a file, or one of these: data-techniques, "
            "effects, focus, priority, terrain-styles");
    o.sheet = files().folder.write("missing.toml", sheet_of("styles/woods"));
    refused(o, "missing.toml: picture 'Heights': styles/woods: no such file");
    o = options("none");
    o.picture.terrain = files().folder.file("none.tdb");
    refused(o, "none.tdb");
    o = options("none");
    o.pose = AircraftPose{36.55, -84.2, 1200, 320, -8, 0};
    refused(o, "two.toml: the pose lies outside the terrain " + files().terrain + "; name a view of it with --pose");
    o = options("none");
    o.picture.device = "toaster";
    refused(o, "toaster");
    o = options("flight.log/none");
    refused(o, "flight.log");
}

TEST(SheetCommand, DamagedTerrainLeavesTheSheetAndEndsWithTwo) {
    std::string image = files().folder.read("terrain.tdb");
    test_support::damage_payloads(image);
    SheetOptions o = options("damaged");
    o.picture.terrain = files().folder.write("damaged.tdb", image);
    const CommandRun told = run(o, true);
    EXPECT_EQ(told.code, 2);
    EXPECT_THAT(told.notes, HasSubstr("damaged.tdb: a part of it cannot be used"));
    EXPECT_THAT(told.json().at("pictures").at(0).at("flags").dump(), HasSubstr("terrain.failing"));
    EXPECT_TRUE(std::filesystem::exists(o.output + "/sheet.png"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_sheet
