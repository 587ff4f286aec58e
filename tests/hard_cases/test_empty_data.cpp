// Sets of data with nothing in them: nothing is drawn, it is said, and nothing else changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/hard_cases/scene_files.hpp"

namespace tedavis::tests::test_empty_data {
namespace {

using test_support::DataPicture;
using test_support::DataSite;
using test_support::kBareGround;
using test_support::plain_ground_design;
using test_support::RasterFile;
using test_support::SceneFiles;
using test_support::site_raster;
using ::testing::HasSubstr;

enum class Geometry { point, line, area };

/// A role, the technique that shows it, and attributes that the technique needs.
struct Case {
    const char* role;
    const char* technique;
    Geometry geometry;
    const char* attributes = "";
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.role << " as " << c.technique; }

constexpr const char* kValue = "[[layer.attribute]]\nname = 'value'\nunit = 'm'\n";
constexpr const char* kHeight = "[[layer.attribute]]\nname = 'height'\nvariable = 'value'\nunit = 'm'\n";
constexpr const char* kCeiling = "[[layer.attribute]]\nname = 'ceiling'\nvariable = 'value'\nunit = 'm'\n";

/// `count`: features.
std::string map_of(Geometry geometry, int count) {
    std::string text = R"({"type":"FeatureCollection","features":[)";
    for (int n = 0; n < count; ++n) {
        const std::string west = std::to_string(DataSite::kLongitude_deg - 0.01 + 0.004 * n),
                          east = std::to_string(DataSite::kLongitude_deg + 0.01),
                          south = std::to_string(DataSite::kLatitude_deg - 0.006),
                          north = std::to_string(DataSite::kLatitude_deg + 0.006);
        const std::string sw = "[" + west + "," + south + ",700]", se = "[" + east + "," + south + ",700]",
                          ne = "[" + east + "," + north + ",700]";
        text += n == 0 ? "" : ",";
        text += R"({"type":"Feature","properties":{"name":"ONE","value":900},"geometry":{"type":")";
        if (geometry == Geometry::point) text += R"(Point","coordinates":)" + sw;
        if (geometry == Geometry::line) text += R"(LineString","coordinates":[)" + sw + "," + ne + "]";
        if (geometry == Geometry::area) text += R"(Polygon","coordinates":[[)" + sw + "," + se + "," + ne + "," + sw + "]]";
        text += "}}";
    }
    return text + "]}";
}

class EmptySet : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Roles, EmptySet,
    ::testing::Values(Case{"trajectory", "tube", Geometry::line}, Case{"road", "ribbon", Geometry::line},
                      Case{"river", "ribbon", Geometry::line}, Case{"runway", "solid", Geometry::line},
                      Case{"obstacle", "solid", Geometry::point, kHeight},
                      Case{"obstacle", "billboard", Geometry::point, kHeight}, Case{"place", "billboard", Geometry::point},
                      Case{"sample", "spheres", Geometry::point, kValue}, Case{"sample", "bars", Geometry::point, kValue},
                      Case{"no_go", "prism", Geometry::area, kCeiling}, Case{"airspace", "prism", Geometry::area, kCeiling},
                      Case{"storm_cell", "prism", Geometry::area, kCeiling}, Case{"building", "prism", Geometry::area, kHeight}),
    [](const auto& c) { return std::string(c.param.role) + "_" + c.param.technique; });

TEST_P(EmptySet, DrawsNothingAndSaysSo) {
    const Case& c = GetParam();
    SceneFiles files;
    const bool has_value = std::string(c.attributes) == kValue;
    const std::string layer = "[[layer]]\nname = 'set'\nsource = 'set.geojson'\nrole = '" + std::string(c.role) + "'\n" +
                              c.attributes,
                      design = plain_ground_design("[[data.element]]\nrole = '" + std::string(c.role) + "'\ntechnique = '" +
                                                   c.technique + "'\nsize_m = 300\n" +
                                                   (has_value ? "attribute = 'value'\npalette = 'scale.toml'\n" : ""));
    files.write(map_of(c.geometry, 0), "set.geojson");
    const DataPicture empty = files.drawn(layer, design);
    EXPECT_THAT(files.notes(), HasSubstr("note: set: nothing is left to show"));
    const DataPicture bare = files.draw(plain_ground_design(""));
    EXPECT_EQ(empty, bare);
    EXPECT_EQ(bare.count(kBareGround), std::size_t{320} * 240);
    EXPECT_EQ(files.draw_with_legend(design), files.draw_with_legend(plain_ground_design(""))) << "no legend either";
    files.write(map_of(c.geometry, 2), "set.geojson");
    const DataPicture shown = files.drawn(layer, design);
    EXPECT_GT(shown.differing(bare), 5u) << "control";
}

TEST(EmptyTable, OfPointsDrawsNothing) {
    SceneFiles files;
    const std::string layer = "[[layer]]\nname = 'set'\nsource = 'set.csv'\nrole = 'place'\n",
                      design = plain_ground_design("[[data.element]]\nrole = 'place'\ntechnique = 'billboard'\n");
    files.write("lon,lat,name\n", "set.csv");
    const DataPicture empty = files.drawn(layer, design);
    EXPECT_THAT(files.notes(), HasSubstr("note: set: nothing is left to show"));
    EXPECT_EQ(empty.count(kBareGround), std::size_t{320} * 240);
    files.write("lon,lat,name\n-84.21,36.71,ONE\n", "set.csv");
    EXPECT_NE(files.drawn(layer, design), empty) << "control";
}

/// A grid in which no post has a value is marked all over as missing, and its legend has the scale.
TEST(EmptyGrid, IsMissingAllOver) {
    SceneFiles files;
    const std::string
        layer = "[[layer]]\nname = 'set'\nsource = 'grid.tif'\n[[layer.attribute]]\nname = 'value'\nvariable = 'band 1'\n",
        design = plain_ground_design("[data.ground]\nlayer = 'set'\nattribute = 'value'\npalette = 'scale.toml'\n");
    RasterFile raster = site_raster();
    raster.value = [](int, int) { return std::numeric_limits<double>::quiet_NaN(); };
    files.write(raster);
    const DataPicture empty = files.drawn(layer, design);
    EXPECT_THAT(files.notes(), HasSubstr("note: set: 'band 1' has no values"));
    const design::Color missing = design::default_design_settings().data.missing;
    EXPECT_EQ(empty.count(kBareGround) + empty.count(missing), std::size_t{320} * 240);
    EXPECT_GT(empty.count(missing), 1000u);
    for (const char* const technique : {"spheres", "bars", "isosurface"}) {
        const DataPicture drawn = files.draw(plain_ground_design(
            "[[data.element]]\nlayer = 'set'\nattribute = 'value'\npalette = 'scale.toml'\ntechnique = '" +
            std::string(technique) + "'\nsize_m = 200\nlevels = [40]\nheights_m = [100]\nheights_over_ground = true\n"));
        EXPECT_EQ(drawn.record.data.size() > 0 ? drawn.record.data[0].aggregated : 0, 0u) << technique;
    }
    raster.value = [](int, int) { return 42.0; };
    files.write(raster);
    EXPECT_EQ(files.drawn(layer, design).count(missing), 0u) << "control";
    EXPECT_EQ(files.notes(), "");
}

}  // namespace
}  // namespace tedavis::tests::test_empty_data
