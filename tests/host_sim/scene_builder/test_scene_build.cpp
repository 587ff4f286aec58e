#include "host_sim/scene_builder/scene_build.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/scene_builder/open_scene.hpp"
#include "render_core/base/units.hpp"
#include "tests/host_sim/scene_builder/model_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scene_build {
namespace {

using scene::Layer;
using scene::LayerRole;
using scene::LayerShape;
using test_support::expect_user_error;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kFlight =
    "time,latitude_deg,longitude_deg,height_msl_m,aircraft\n1586684820,46.8,9.8,2000,HB1\n1586684821,46.8005,9.8,2002,HB1\n"
    "1586684822,46.801,9.8,2004,HB1\n1586684820,46.7,9.7,3000,HB2\n1586684825,46.7,9.71,3000,HB2\n";
constexpr const char* kScene = R"(name = "all"
origin = "made for a test"
[[layer]]
name = "masts"
source = "masts.csv"
licence = "own work"
role = "obstacle"
importance = 200
height_datum = "ground"
height_variable = "height"
position_accuracy_m = 5
data_time = "2020-04-12T09:00:00Z"
valid_hours = 2
[[layer.attribute]]
name = "height"
unit = "m"
[[layer]]
name = "zones"
source = "zones.txt"
role = "airspace"
[[layer]]
name = "runways"
source = "runways.csv"
role = "runway"
[[layer]]
name = "own"
source = "flight.csv"
role = "trajectory"
aircraft = "HB1"
height_accuracy_m = 15
[[layer]]
name = "others"
source = "flight.csv"
role = "traffic"
valid_hours = 0.5
[[layer]]
name = "field"
source = "grid.tif"
role = "field"
[[layer.attribute]]
name = "value"
variable = "band 1"
)";

class SceneFiles : public ::testing::Test {
protected:
    SceneFiles() {
        (void)test_support::RasterFile().write(folder_.file("grid.tif"));
        folder_.write("masts.csv", "lon,lat,name,height\n9.8,46.8,A,40\n9.9,46.9,B,tall\n");
        folder_.write("zones.txt", "AC D\nAN ZONE\nAL GND\nAH FL100\nV X=46:48:00N 9:48:00E\nDC 3\n");
        folder_.write(
            "runways.csv",
            "airport_ident,length_ft,width_ft,closed,le_ident,le_latitude_deg,le_longitude_deg,le_elevation_ft,he_ident,"
            "he_latitude_deg,he_longitude_deg,he_elevation_ft\nLSZS,5906,131,0,03,46.52,9.87,5600,21,46.54,9.89,5590\n");
        folder_.write("flight.csv", kFlight);
    }
    std::vector<std::string> build(const std::string& scene = kScene) {
        return build_scene(folder_.write("scene.toml", scene), folder_.file("x.sdb"),
                           [this](std::string_view layer, std::size_t done, std::size_t total) {
                               seen_.push_back(std::string(layer) + ' ' + std::to_string(done) + '/' + std::to_string(total));
                           });
    }
    void expect_refused(const std::string& scene, const std::string& words) {
        expect_user_error([&] { build(scene); }, words);
        EXPECT_FALSE(std::filesystem::exists(folder_.file("x.sdb")));
        EXPECT_FALSE(std::filesystem::exists(folder_.file("x.sdb.part")));
    }

    test_support::TemporaryFolder folder_;
    std::vector<std::string> seen_;
};

TEST_F(SceneFiles, EverySourceBecomesALayer) {
    const std::vector<std::string> notes = build();
    EXPECT_THAT(notes, Contains(HasSubstr("masts: 1 values of 'height' are no numbers")));
    EXPECT_THAT(seen_, Contains("zones 1/6"));
    const OpenScene open(folder_.file("x.sdb"));
    const scene::Scene& scene = open.scene();
    EXPECT_STREQ(scene.header().name, "all");
    EXPECT_STREQ(scene.header().origin, "made for a test");
    EXPECT_EQ(scene.header().revision, 1u);
    ASSERT_EQ(scene.layers().size(), 6u);
    const Layer& masts = *scene.find("masts");
    EXPECT_EQ(masts.entry->role, LayerRole::obstacle);
    EXPECT_EQ(masts.entry->height_datum, scene::HeightDatum::ground);
    EXPECT_EQ(masts.entry->importance, 200);
    EXPECT_EQ(masts.entry->position_accuracy_m, 5);
    EXPECT_STREQ(masts.entry->source, "masts.csv, own work");
    EXPECT_EQ(masts.entry->valid_until_ns - masts.entry->data_time_ns, std::int64_t{7200} * 1'000'000'000);
    EXPECT_EQ(masts.points[0].height_m, 40);
    EXPECT_EQ(masts.name_of(1), "B");

    const Layer& zones = *scene.find("zones");
    EXPECT_EQ(zones.entry->shape, LayerShape::areas);
    EXPECT_NEAR(double{zones.find("ceiling")->values[0]}, 3048, 1e-3);
    EXPECT_EQ(zones.find("ceiling_datum")->class_name(static_cast<std::uint32_t>(zones.find("ceiling_datum")->values[0])),
              "standard");
    EXPECT_NEAR(double{scene.find("runways")->find("width")->values[0]}, 131 * 0.3048, 1e-3);
    const Layer &own = *scene.find("own"), &others = *scene.find("others");
    EXPECT_EQ(own.entry->feature_count, 1u);
    EXPECT_EQ(own.entry->height_accuracy_m, 15);
    EXPECT_NEAR(double{own.find("vertical_speed")->values[1]}, 2, 0.05);
    EXPECT_EQ(own.points[2].time_ns, 1'586'684'822'000'000'000);
    EXPECT_EQ(others.entry->feature_count, 2u);
    EXPECT_EQ(others.name_of(1), "HB2");
    EXPECT_EQ(others.entry->data_time_ns, 1'586'684'825'000'000'000);
    EXPECT_EQ(others.entry->valid_until_ns - others.entry->data_time_ns, std::int64_t{1800} * 1'000'000'000);
    EXPECT_EQ(scene.find("field")->entry->grid.columns, 20u);
    EXPECT_EQ(scene.find("field")->entry->valid_until_ns, INT64_MAX);
}

TEST_F(SceneFiles, GivenLayersStandInForThoseOfTheirNames) {
    LayerDraft zones, more;
    zones.name = "zones";
    zones.shape = more.shape = LayerShape::areas;
    zones.starts = more.starts = {0};
    more.name = "more";
    std::filesystem::remove(folder_.file("zones.txt"));  // nobody asks for it
    const MadeScene made = make_scene(parse_scene(kScene, "scene.toml"), folder_.path(), [](auto, auto, auto) {},
                                      {std::move(more), std::move(zones)});
    ASSERT_EQ(made.draft.layers.size(), 7u);
    EXPECT_EQ(made.draft.layers[1].name, "zones");
    EXPECT_EQ(made.draft.layers[1].feature_count(), 0u);
    EXPECT_EQ(made.draft.layers[5].name, "field");
    EXPECT_EQ(made.draft.layers[6].name, "more");
}

TEST_F(SceneFiles, AModelStandsAtPoints) {
    build();
    folder_.write("hut.gltf", test_support::tetrahedron());
    const std::string file = folder_.write(
        "scene.toml", "name = 's'\n[[layer]]\nname = 'huts'\nsource = 'masts.csv'\nrole = 'model'\nmodel = 'hut.gltf'\n");
    build_scene(file, folder_.file("huts.sdb"), [](std::string_view, std::size_t, std::size_t) {});
    const OpenScene open(folder_.file("huts.sdb"));
    const Layer& huts = open.scene().layers()[0];
    EXPECT_EQ(huts.entry->shape, LayerShape::meshes);
    EXPECT_EQ(huts.entry->triangle_count, 4u);
    EXPECT_GT(huts.points.size(), 0u);
}

TEST_F(SceneFiles, EachBuildIsARevision) {
    build();
    const std::string first = folder_.read("x.sdb");
    build();
    EXPECT_EQ(OpenScene(folder_.file("x.sdb")).scene().header().revision, 2u);
    folder_.write("x.sdb", first.substr(0, first.size() / 2));
    build();
    EXPECT_EQ(folder_.read("x.sdb"), first) << "what is damaged has no revision, and equal builds are equal bytes";
}

TEST_F(SceneFiles, OtherFilesAreNotReplaced) {
    const std::string mine = "my own table, which no layer reads\n";
    folder_.write("x.sdb", mine);
    expect_user_error([this] { build(); }, "x.sdb: is there already and is no scene database");
    EXPECT_EQ(folder_.read("x.sdb"), mine);
    EXPECT_FALSE(std::filesystem::exists(folder_.file("x.sdb.part")));
}

TEST_F(SceneFiles, BadInputLeavesWhatWasThere) {
    const std::string head = "name = 's'\n[[layer]]\nname = 'a'\n";
    expect_refused(head, "scene.toml:2");
    expect_refused(head + "source = 'none.csv'\n", "none.csv");
    expect_refused(head + "source = 'masts.csv'\nrole = 'place'\nvalid_hours = 3\n",
                   "a: 'valid_hours' counts from the data's time");
    const std::string grows =
        "[[layer.attribute]]\nname = 'value'\nvariable = 'band 1'\n[layer.attribute.uncertainty]\n"
        "kind = 'interval'\nvalue = 1\nfull = 10\ngrowth_per_hour = 0.2\n";
    expect_refused(head + "source = 'grid.tif'\n" + grows, "a: 'growth_per_hour' of 'value' counts from the data's time");
    build(head + "source = 'grid.tif'\ndata_time = '2020-04-12T09:00:00Z'\n" + grows);
    std::filesystem::remove(folder_.file("x.sdb"));
    expect_refused(head + "source = 'masts.csv'\nrole = 'place'\naircraft = 'HB1'\n", "a: 'aircraft' chooses one");
    expect_refused(head + "source = 'masts.csv'\nrole = 'model'\nmodel = 'none.gltf'\n",
                   "none.gltf: cannot be read as a 3D model");
    expect_refused(head + "source = 'grid.tif'\nmodel = 'hut.gltf'\n", "a: 'model' is for tables and flights");
    expect_refused(head + "source = 'grid.tif'\ntime_variable = 't'\n", "a: 'time_variable' is for tables and flights");
    expect_refused(head + "source = 'masts.csv'\nrole = 'place'\nlicence = '" + std::string(200, 'x') + "'\n",
                   "a: its source 'masts.csv, xxx");
    expect_refused(head + "source = 'masts.csv'\nrole = 'place'\n[[layer]]\nname = 'a'\nsource = 'masts.csv'\nrole = 'place'\n",
                   "a: two layers have this name");
    expect_refused(head +
                       "source = 'masts.csv'\nrole = 'place'\n[[layer.attribute]]\nname = 'height'\n[[layer.attribute]]\nname = "
                       "'height'\n",
                   "a: two attributes have the name 'height'");
    build();
    const std::string before = folder_.read("x.sdb");
    expect_user_error([this] { build("name = 's'\n[[layer]]\nname = 'a'\nsource = 'none.csv'\n"); }, "none.csv");
    EXPECT_EQ(folder_.read("x.sdb"), before);
}

TEST_F(SceneFiles, ALayerThatCouldShowNothingIsRefused) {
    const std::string head = "name = 's'\n[[layer]]\nname = 'a'\n",
                      value = "[[layer.attribute]]\nname = 'v'\nvariable = 'band 1'\n";
    expect_refused(head + "source = 'grid.tif'\nrole = 'wind'\n" + value,
                   "a: role \"wind\" needs the attributes 'east' and 'north'");
    expect_refused(head + "source = 'grid.tif'\nrole = 'obstacle'\n" + value, "a: role \"obstacle\" shows points");
    expect_refused(head + "source = 'masts.csv'\n", "a: role \"field\" shows rasters");
    EXPECT_TRUE(build(head + "source = 'grid.tif'\n" + value).empty()) << "this one can";
}

TEST_F(SceneFiles, OutputsReplaceNoInput) {
    const std::string scene = folder_.write("scene.toml", kScene);
    for (const char* const input : {"scene.toml", "masts.csv", "grid.tif"})
        expect_user_error([&] { build_scene(scene, folder_.file(input), [](std::string_view, std::size_t, std::size_t) {}); },
                          "is also an input of this command");
    EXPECT_EQ(folder_.read("scene.toml"), kScene);
}

TEST_F(SceneFiles, AStoppedBuildLeavesNothing) {
    struct Stopped {};
    const std::string scene = folder_.write("scene.toml", kScene);
    EXPECT_THROW(build_scene(scene, folder_.file("x.sdb"),
                             [](std::string_view, std::size_t done, std::size_t) {
                                 if (done == 3) throw Stopped();
                             }),
                 Stopped);
    EXPECT_FALSE(std::filesystem::exists(folder_.file("x.sdb")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_scene_build
