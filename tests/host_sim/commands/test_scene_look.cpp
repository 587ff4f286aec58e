#include "host_sim/commands/scene_look.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/scene_builder/netcdf_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scene_look {
namespace {

using test_support::CommandRun;
using ::testing::HasSubstr;

class SceneLookCommand : public ::testing::Test {
protected:
    static CommandRun look(const std::vector<std::string>& files, bool json = false) {
        return test_support::run_command([&](Console& console) { return run_scene_look({files, ""}, console); }, json);
    }
    test_support::TemporaryFolder folder_;
};

TEST_F(SceneLookCommand, AGridIsDescribed) {
    test_support::NetcdfFile file;
    file.times_h = {6, 9, 12};
    file.write(folder_.file("u.nc"));
    const std::string text = look({folder_.file("u.nc")}).results;
    EXPECT_THAT(text, HasSubstr("u.nc: grid (netCDF)"));
    EXPECT_THAT(text, HasSubstr("grid: 4 x 3 posts, 0.5 x 0.5 degrees (38.3 x 55.6 km), W 9 S 46 E 10.5 N 47")) << "cos 46.5";
    EXPECT_THAT(text, HasSubstr("unit: m s**-1; the scene keeps m/s"));
    EXPECT_THAT(text, HasSubstr("times: 1970-01-01T06:00:00Z to 1970-01-01T12:00:00Z, 3 times, every 3 h"));
    EXPECT_THAT(text, HasSubstr("values of the first grid: 0 .. 11"));
    EXPECT_THAT(text, HasSubstr("\n[[layer]]\nname = \"u\"\n"));
    const auto json = look({folder_.file("u.nc")}, true).json()["files"][0];
    EXPECT_EQ(json["kind"], "grid");
    const auto& variable = json["grid"]["variables"][0];
    EXPECT_EQ(variable["name"], "u");
    EXPECT_EQ(variable["kept_unit"], "m/s");
    EXPECT_EQ(variable["times"]["count"], 3);
    EXPECT_EQ(variable["times"]["step_s"], 10800);
    EXPECT_EQ(variable["grid"]["columns"], 4);
    EXPECT_EQ(variable["members"]["most"], 1);
    EXPECT_THAT(text, HasSubstr(json["layer"].get<std::string>()));
}

TEST_F(SceneLookCommand, ATableIsDescribed) {
    const std::string file = folder_.write("masts.csv", "lon,lat,name,height,kind\n9.8,46.8,A,40,mast\n9.9,46.9,B,,crane\n");
    const std::string text = look({file}).results;
    EXPECT_THAT(text, HasSubstr("masts.csv: table or map (CSV)"));
    EXPECT_THAT(text, HasSubstr("features: 2 points"));
    EXPECT_THAT(text, HasSubstr("extent: W 9.8 S 46.8 E 9.9 N 46.9"));
    EXPECT_THAT(text, HasSubstr("height: number, 40 .. 40; stated 1 times"));
    EXPECT_THAT(text, HasSubstr("kind: text, crane, mast; stated 2 times"));
    const auto columns = look({file}, true).json()["files"][0]["features"]["columns"];
    EXPECT_EQ(columns.size(), 5u);
}

TEST_F(SceneLookCommand, WhatCannotBeReadIsSaidAndTheRestIsShown) {
    const std::string good = folder_.write("p.csv", "lon,lat\n9.8,46.8\n"), bad = folder_.write("notes.md", "# Notes\n");
    const CommandRun both = look({bad, good});
    EXPECT_EQ(both.code, 2);
    EXPECT_THAT(both.results, HasSubstr("p.csv: table or map"));
    EXPECT_THAT(both.notes, HasSubstr("notes.md: no scene can take it"));
    EXPECT_EQ(look({good, good}).code, 0);
    test_support::expect_user_error([&] { (void)look({bad}); }, "no scene can take it");
    test_support::expect_user_error([&] { (void)look({bad, bad}); }, "no scene can take it");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scene_look
