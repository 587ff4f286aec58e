#include "host_sim/replay/load_design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_load_design {
namespace {

TEST(LoadDesign, FindsShippedAndOwnFiles) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    options.design = "cruise";
    EXPECT_EQ(load_design(options).name.view(), "cruise");
    options.design = folder.write("own.toml", "name = \"own\"\n[terrain]\ntau_px = 4\n");
    EXPECT_EQ(load_design(options).name.view(), "own");
    EXPECT_EQ(load_design(options).terrain.tau_px, 4);
    EXPECT_EQ(design_path(options), options.design);
}

TEST(LoadDesign, FociOfTheCommandLineStandBeforeTheDesigns) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    options.design = folder.write("own.toml", "name = \"own\"\n[[focus]]\nname = \"D\"\n[[focus]]\n");
    options.foci = {"name = \"C\", radius_m = 700"};
    const design::DesignSettings design = load_design(options);
    ASSERT_EQ(design.foci.size(), 3u);
    EXPECT_EQ(design.foci[0].name.view(), "C");
    EXPECT_EQ(design.foci[1].name.view(), "D");
    options.foci = {"radius = 1"};
    test_support::expect_user_error([&] { static_cast<void>(load_design(options)); }, "--focus:1: unknown key");
    options.foci = {"", "", ""};
    test_support::expect_user_error([&] { static_cast<void>(load_design(options)); }, "room for 4");
}

TEST(LoadDesigns, PhasesHaveTheDesignsThatTheFileNames) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    options.tau_px = 7;
    folder.write("low.toml", "name = \"low\"\n");
    options.design = folder.write("own.toml",
                                  "name = \"own\"\n[phases]\ntakeoff = \"low.toml\"\napproach = \"low.toml\"\n"
                                  "cruise = \"cruise\"\n");
    std::vector<ReadFile> files;
    const auto designs = load_designs(options, &files);
    EXPECT_EQ(designs->design.name.view(), "own");
    ASSERT_EQ(designs->phases.size(), 2u);
    EXPECT_EQ(designs->phases.at(designs->phases.place_of(flight::kApproachFinal)).name.view(), "low");
    EXPECT_EQ(designs->phases.at(designs->phases.place_of({flight::Scenario::cruise, 0})).name.view(), "cruise")
        << "a shipped one";
    for (std::size_t place = 1; place <= 2; ++place) EXPECT_EQ(designs->phases.at(place).terrain.tau_px, 7);
    const auto was_read = [&files](const std::string& end) {
        return std::any_of(files.begin(), files.end(), [&end](const ReadFile& file) {
            return file.path.size() >= end.size() && file.path.substr(file.path.size() - end.size()) == end;
        });
    };
    EXPECT_TRUE(was_read("own.toml") && was_read("low.toml") && was_read("cruise.toml") && was_read("natural.toml"));
}

TEST(LoadDesigns, FaultsNameTheFileThatHasThem) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    options.design = folder.write("own.toml", "name = \"own\"\n[phases]\ncruise = \"low.toml\"\n");
    const auto load = [&options] { static_cast<void>(load_designs(options)); };
    test_support::expect_user_error(load, "low.toml");
    folder.write("low.toml", "name = \"low\"\n[terrain]\ntau = 4\n");
    test_support::expect_user_error(load, "low.toml:3");
    folder.write("low.toml", "name = \"low\"\n[phases]\ncruise = \"cruise\"\n");
    test_support::expect_user_error(load, "it has no table [phases]; remove it");
}

TEST(LoadDesign, TheCommandLineStaysAboveTheFile) {
    PictureOptions options;
    options.tau_px = 7;
    EXPECT_EQ(load_design(options).terrain.tau_px, 7);
}

TEST(LoadDesign, WithoutSymbologyTheLegendAndTheMapsScaleStay) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    options.design = folder.write("own.toml", "name = \"own\"\n[symbology]\nunits = \"m_kmh\"\n");
    options.symbology = false;
    const design::SymbologySettings shown = load_design(options).symbology;
    EXPECT_FALSE(shown.attitude || shown.heading || shown.airspeed || shown.altitude || shown.vertical_speed ||
                 shown.flight_path || shown.baro_setting || shown.ground_height || shown.phase);
    EXPECT_TRUE(shown.legend && shown.map);
    EXPECT_EQ(shown.units, base::DisplayUnits::metric);
    folder.write("own.toml", "name = \"own\"\n[symbology]\nlegend = false\nmap = false\n");
    EXPECT_FALSE(load_design(options).symbology.legend || load_design(options).symbology.map) << "where the design has one";
}

TEST(LoadDesign, NamesPalettesAndTellsWhatItRead) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    std::vector<ReadFile> files;
    options.design = folder.write("own.toml", "name = \"own\"\n[terrain]\npalette = \"grey\"\n");
    EXPECT_EQ(load_design(options, &files).terrain.palette.name.view(), "grey");
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0].path, shipped_root() + "/configs/palettes/grey.toml");
    EXPECT_EQ(files[0].text, read_file(files[0].path));
    EXPECT_EQ(files[1].path, options.design);
    EXPECT_EQ(files[1].text, read_file(options.design));
    folder.write("own.toml", "name = \"own\"\n[terrain]\npalette = \"my.toml\"\n");
    test_support::expect_user_error([&] { static_cast<void>(load_design(options, &files)); },
                                    "own.toml:3: " + folder.file("my.toml"));
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0].text, "") << "not there";
}

TEST(LoadDesign, SaysWhatIsWrong) {
    const test_support::TemporaryFolder folder;
    PictureOptions options;
    options.design = folder.write("own.toml", "name = \"own\"\n\ncolour = 1\n");
    test_support::expect_user_error([&] { static_cast<void>(load_design(options)); }, "own.toml:3");
    options.design = "no_such";
    test_support::expect_user_error([&] { static_cast<void>(load_design(options)); }, "one of these:");
}

}  // namespace
}  // namespace tedavis::host_sim::test_load_design
