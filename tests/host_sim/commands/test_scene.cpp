#include "host_sim/commands/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_scene {
namespace {

using test_support::CommandRun;
using test_support::expect_user_error;
using test_support::run_command;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SceneCommand : public ::testing::Test {
protected:
    SceneCommand() {
        place_.write("masts.csv",
                     "lon,lat,name,height,sigma,kind\n9.8,46.8,A,40,1,mast\n9.9,46.9,B,,2,turbine\n9.7,46.7,C,12.5,,mast\n");
        build_.scene =
            place_.write("s.toml",
                         "name = 'masts'\norigin = 'made for a test'\n[[layer]]\nname = 'masts'\nsource = 'masts.csv'\n"
                         "role = 'obstacle'\ndata_time = '2020-04-12T09:47:00Z'\nvalid_hours = 1\n"
                         "[[layer.attribute]]\nname = 'height'\nunit = 'm'\n[layer.attribute.uncertainty]\n"
                         "kind = 'standard_deviation'\nvariable = 'sigma'\nfull = 4\n"
                         "[[layer.attribute]]\nname = 'kind'\nscale = 'nominal'\nclasses = ['mast', 'turbine']\n");
        build_.output = place_.file("s.sdb");
    }
    CommandRun build(bool json = false) {
        return run_command([&](Console& console) { return run_scene_build(build_, console); }, json);
    }
    CommandRun info(const std::string& database, bool json = false) {
        return run_command([&](Console& console) { return run_scene_info({database}, console); }, json);
    }
    std::string write_small_scene() {
        const std::vector<std::uint8_t> bytes = sdb_bytes(test_support::small_scene());
        return place_.write("small.sdb", std::string(bytes.begin(), bytes.end()));
    }

    test_support::TemporaryFolder place_;
    SceneBuildOptions build_;
};

TEST_F(SceneCommand, WhatIsBuiltIsDescribed) {
    const CommandRun built = build(true);
    EXPECT_EQ(built.code, 0);
    EXPECT_EQ(built.notes, "");
    const auto json = built.json();
    EXPECT_EQ(json, info(build_.output, true).json());
    EXPECT_EQ(json["name"], "masts");
    EXPECT_EQ(json["origin"], "made for a test");
    EXPECT_EQ(json["revision"], 1);
    EXPECT_EQ(json["bytes"].get<std::uintmax_t>(), std::filesystem::file_size(build_.output));
    const auto& layer = json["layers"][0];
    EXPECT_EQ(layer["role"], "obstacle");
    EXPECT_EQ(layer["shape"], "points");
    EXPECT_EQ(layer["features"], 3);
    EXPECT_EQ(layer["points"], 3);
    EXPECT_EQ(layer["data_time"], "2020-04-12T09:47:00Z");
    EXPECT_EQ(layer["valid_until"], "2020-04-12T10:47:00Z");
    EXPECT_EQ(layer["source"], "masts.csv");
    const auto& height = layer["attributes"][0];
    EXPECT_EQ(height["unit"], "m");
    EXPECT_EQ(height["min"], 12.5);
    EXPECT_EQ(height["max"], 40);
    EXPECT_EQ(height["missing"], 1);
    EXPECT_EQ(height["uncertainty"]["kind"], "standard_deviation");
    EXPECT_NEAR(height["uncertainty"]["greatest"].get<double>(), 0.25, 1.0 / 254);
    EXPECT_EQ(height["uncertainty"]["unknown"], 1) << "of the two that have a value one has no sigma";
    EXPECT_EQ(layer["attributes"][1]["scale"], "nominal");
    EXPECT_THAT(layer["attributes"][1]["classes"], ElementsAre("mast", "turbine"));
    EXPECT_TRUE(layer["attributes"][1]["uncertainty"].is_null());
    EXPECT_EQ(build(true).json()["revision"], 2);
}

TEST_F(SceneCommand, WordsSayTheSame) {
    const std::string text = build().results;
    EXPECT_THAT(text, HasSubstr("s.sdb: scene masts, revision 1, 1 layers, "));
    EXPECT_THAT(text, HasSubstr("\n  masts (obstacle): 3 points, 2020-04-12T09:47:00Z, from masts.csv"));
    EXPECT_THAT(text, HasSubstr("\n    height: 12.5 .. 40 m, 1 missing; standard_deviation 0.25 .. 0.25 of 4 m, unknown for 1"));
    EXPECT_THAT(text, HasSubstr("\n    kind: 2 classes; uncertainty not stated"));
}

TEST_F(SceneCommand, EveryShapeIsDescribed) {
    const std::string path = write_small_scene();
    const auto layers = info(path, true).json()["layers"];
    ASSERT_EQ(layers.size(), 4u);
    EXPECT_EQ(layers[0]["grid"]["levels"], 2);
    EXPECT_EQ(layers[0]["points"], 48);
    EXPECT_EQ(layers[0]["attributes"][0]["interpolated"], 1);
    EXPECT_EQ(layers[2]["shape"], "areas");
    EXPECT_EQ(layers[2]["features"], 2);
    EXPECT_EQ(layers[3]["shape"], "meshes");
    EXPECT_TRUE(layers[3]["data_time"].is_null());
    const std::string text = info(path).results;
    EXPECT_THAT(text, HasSubstr("air (field): 4 x 3 posts, 2 levels, 2 times from 1970-01-01T00:00:00Z to 1970-01-01T01:00:00Z, "
                                "from made for a test"));
    EXPECT_THAT(text, HasSubstr("zones (no_go): 2 areas of 7 points"));
}

TEST_F(SceneCommand, NotesStandBesideTheResult) {
    place_.write("masts.csv", "lon,lat,name,height,sigma,kind\n9.8,46.8,A,40,1,tree\n");
    const CommandRun built = build();
    EXPECT_THAT(built.notes, HasSubstr("note: masts: 1 values of 'kind' are no class of the attribute"));
    place_.write("masts.csv", "lon,lat,name,height,sigma,kind\n");
    EXPECT_THAT(build().notes, HasSubstr("note: masts: nothing is left to show"));
    EXPECT_THAT(build().results, HasSubstr("height: no values; uncertainty not stated"));
}

TEST_F(SceneCommand, FaultsAreSentences) {
    expect_user_error([&] { (void)info(place_.file("none.sdb")); }, "none.sdb");
    expect_user_error([&] { (void)info(build_.scene); }, "is not a scene database");
    build_.scene = "no-such";
    expect_user_error([&] { (void)build(); }, "no-such");
    EXPECT_FALSE(std::filesystem::exists(build_.output));
}

}  // namespace
}  // namespace tedavis::host_sim::test_scene
