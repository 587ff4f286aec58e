// Kinds of ground cover, from a raster of somebody's codes to the picture: pure colours, by name, and what is no kind is missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/scene_recipe.hpp"
#include "platform/files/file_byte_source.hpp"
#include "render_core/display/planner/data_legends.hpp"
#include "render_core/display/planner/spatial_data.hpp"
#include "tests/hard_cases/scene_files.hpp"
#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::tests::test_land_cover {
namespace {

using design::Color;
using test_support::DataPicture;
using test_support::DataSite;
using test_support::kBareGround;
using test_support::plain_ground_design;
using test_support::RasterFile;
using test_support::SceneFiles;
using test_support::site_raster;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kForest = 10, kGrass = 30, kWater = 80, kSnow = 70, kNobodys = 77;
constexpr Color kForestColor{40, 80, 50}, kGrassColor{150, 170, 120}, kWaterColor{80, 130, 200};

/// The palette has another order than the scene, does not know snow, and knows sand, of which there is none.
constexpr const char* kPalette =
    "name = 'cover'\ntitle = 'COVER'\nkind = 'nominal'\npurpose = 'data'\n[[class]]\nname = 'water'\ncolor = '#5082c8'\n"
    "[[class]]\nname = 'sand'\ncolor = '#f0e0c0'\n[[class]]\nname = 'grass'\ncolor = '#96aa78'\n[[class]]\nname = 'forest'\n"
    "color = '#285032'\n";

std::string cover_layer(const std::string& scale =
                            "scale = 'nominal'\nclasses = ['forest', 'grass', 'snow', 'water', 'sand']\n"
                            "class_values = [10, 30, 70, 80, 60]\n") {
    return "[[layer]]\nname = 'cover'\ntitle = 'Cover'\nsource = 'grid.tif'\nrole = 'land_cover'\n[[layer.attribute]]\n"
           "name = 'kind'\nvariable = 'band 1'\n" +
           scale + "[layer.attribute.uncertainty]\nkind = 'percent'\nvalue = 0\n";
}
std::string cover_design(const std::string& palette = "cover.toml") {
    return plain_ground_design("[data.ground]\nlayer = 'cover'\nattribute = 'kind'\nopacity = 1\npalette = '" + palette + "'\n");
}

int code_at(int i, int j) {
    constexpr int kCodes[] = {kForest, kGrass, kWater, kForest, kWater};
    if (i == 4 && j == 4) return kNobodys;
    return i == 2 && j == 3 ? kSnow : kCodes[(3 * i + 2 * j + i * j) % 5];
}
RasterFile cover_raster() {
    RasterFile raster = site_raster();
    raster.type = GDT_Byte;
    raster.value = [](int i, int j) { return code_at(i, j); };
    return raster;
}
bool is_missing(int code) { return code == kSnow || code == kNobodys; }

class LandCoverOf : public ::testing::TestWithParam<const char*> {
protected:
    LandCoverOf() { files_.write(kPalette, "cover.toml"); }
    SceneFiles files_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Lanes, LandCoverOf, ::testing::Values("es2-small", "es3-mid"));

TEST_P(LandCoverOf, EveryPixelHasTheColorOfTheNearestPost) {
    files_.write(cover_raster());
    const DataPicture drawn = files_.drawn(cover_layer(), cover_design());
    const Color missing = design::default_design_settings().data.missing;
    const std::map<int, Color> colors = {{kForest, kForestColor}, {kGrass, kGrassColor}, {kWater, kWaterColor}};
    const RasterFile raster = cover_raster();
    std::map<int, int> compared;
    int mixed = 0, wrong = 0, dots = 0;
    for (std::uint32_t y = 0; y < drawn.picture.height; ++y)
        for (std::uint32_t x = 0; x < drawn.picture.width; ++x) {
            const Color color = drawn.at(x, y);
            const bool is_pure =
                color == kForestColor || color == kGrassColor || color == kWaterColor || color == kBareGround || color == missing;
            mixed += is_pure ? 0 : 1;
            const earth::Geodetic place = DataSite::places_from_above()[y * drawn.picture.width + x];
            const double u = (base::degrees(place.longitude_rad) - raster.x(0, 0)) / raster.transform[1],
                         v = (base::degrees(place.latitude_rad) - raster.y(0, 0)) / raster.transform[5];
            const double to_border = std::fmin(std::fabs(u - std::floor(u) - 0.5), std::fabs(v - std::floor(v) - 0.5));
            if (to_border < 0.02 || !(u > 0.02 && u < 6.98 && v > 0.02 && v < 6.98)) continue;
            const int code = code_at(static_cast<int>(std::lround(u)), static_cast<int>(std::lround(v)));
            ++compared[code];
            if (is_missing(code)) {
                wrong += color == kBareGround || color == missing ? 0 : 1;
                dots += color == missing ? 1 : 0;
            } else {
                wrong += color == colors.at(code) ? 0 : 1;
            }
        }
    EXPECT_EQ(mixed, 0) << "at borders too";
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(dots, 40) << "a kind that the palette does not name, and a code that is none, have the sign of what is missing";
    for (const int code : {kForest, kGrass, kWater}) EXPECT_GT(compared[code], 3'000) << code;
    for (const int code : {kSnow, kNobodys}) EXPECT_GT(compared[code], 500) << code;
    // Control: numbers are blended.
    const DataPicture blended = files_.drawn(cover_layer("scale = 'quantitative'\n"), cover_design("scale.toml"));
    std::set<std::array<int, 3>> seen;
    for (std::uint32_t x = 0; x < blended.picture.width; ++x) {
        const Color color = blended.at(x, 120);
        seen.insert({color.red, color.green, color.blue});
    }
    EXPECT_GT(seen.size(), 30u);
}

TEST_P(LandCoverOf, WarpedFromAnotherSystemItStaysPure) {
    RasterFile raster = cover_raster();
    raster.crs = "EPSG:32616";
    raster.columns = raster.rows = 24;
    raster.transform = {746'000, 250, 0, 4'069'500, 0, -250};
    raster.value = [](int i, int j) { return (i + j) % 3 == 0 ? kForest : (i + j) % 3 == 1 ? kGrass : kWater; };
    files_.write(raster);
    const DataPicture drawn = files_.drawn(cover_layer(), cover_design());
    const Color missing = design::default_design_settings().data.missing;
    const std::size_t pure = drawn.count(kForestColor) + drawn.count(kGrassColor) + drawn.count(kWaterColor);
    EXPECT_EQ(pure + drawn.count(kBareGround) + drawn.count(missing), std::size_t{320} * 240);
    EXPECT_GT(std::min({drawn.count(kForestColor), drawn.count(kGrassColor), drawn.count(kWaterColor)}), 10'000u);
}

TEST_P(LandCoverOf, NumbersHaveNoKinds) {
    files_.write(site_raster());
    const DataPicture drawn = files_.drawn(cover_layer("scale = 'quantitative'\n"), cover_design());
    EXPECT_EQ(drawn.count(kBareGround), std::size_t{320} * 240) << "not drawn at all, rather than in colours of kinds";
    EXPECT_EQ(drawn.effect("ground_data").reason.view(), "the palette is of classes, and the attribute has none");
    files_.write(cover_raster());
    EXPECT_EQ(files_.drawn(cover_layer(), cover_design()).effect("ground_data").reason.view(), "asked for by the design")
        << "control";
}

/// Polygons of a map, with a lake in the wood.
TEST_P(LandCoverOf, PolygonsBecomeColorsOfTheGround) {
    files_.write(R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"kind":"forest"},"geometry":{"type":"Polygon","coordinates":[
[[-84.24,36.70],[-84.18,36.70],[-84.18,36.72],[-84.24,36.72],[-84.24,36.70]],
[[-84.22,36.705],[-84.20,36.705],[-84.20,36.715],[-84.22,36.715],[-84.22,36.705]]]}},
{"type":"Feature","properties":{"kind":"water"},"geometry":{"type":"Polygon","coordinates":[
[[-84.213,36.707],[-84.207,36.707],[-84.207,36.713],[-84.213,36.713],[-84.213,36.707]]]}}]})",
                 "cover.geojson");
    const std::string layer =
        "[[layer]]\nname = 'cover'\nsource = 'cover.geojson'\nrole = 'land_cover'\nraster_m = 40\n[[layer.attribute]]\n"
        "name = 'kind'\nscale = 'nominal'\nclasses = ['forest', 'water']\n[layer.attribute.uncertainty]\nkind = 'percent'\n"
        "value = 0\n";
    const DataPicture drawn = files_.drawn(layer, cover_design());
    EXPECT_EQ(files_.notes(), "");
    const Color missing = design::default_design_settings().data.missing;
    constexpr double kEdge_deg = 0.0005;  // a post and a pixel
    int wrong = 0;
    std::array<int, 3> compared{};
    for (std::size_t n = 0; n < DataSite::places_from_above().size(); ++n) {
        const earth::Geodetic& place = DataSite::places_from_above()[n];
        const double east = base::degrees(place.longitude_rad) + 84.21, north = base::degrees(place.latitude_rad) - 36.71;
        const auto within = [&](double width, double height) {
            const double inside = std::fmin(width - std::fabs(east), height - std::fabs(north));
            return std::fabs(inside) < kEdge_deg ? 0 : inside > 0 ? 1 : -1;
        };
        const int lake = within(0.003, 0.003), clearing = within(0.01, 0.005), wood = within(0.03, 0.01);
        if (lake == 0 || clearing == 0 || wood <= 0) continue;
        const Color color = drawn.at(static_cast<std::uint32_t>(n % 320), static_cast<std::uint32_t>(n / 320));
        const std::size_t expected = lake > 0 ? 0 : clearing > 0 ? 1 : 2;
        ++compared[expected];
        const bool is_right = expected == 0   ? color == kWaterColor
                              : expected == 1 ? color == kBareGround || color == missing
                                              : color == kForestColor;
        wrong += is_right ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0);
    for (const int count : compared) EXPECT_GT(count, 500);
}

/// What the legend of the ground says of the database that was built last.
std::string legend_of(const SceneFiles& files, const std::string& design_text) {
    auto file = platform::open_file(files.database().c_str());
    std::vector<std::uint8_t> memory(1 << 18);
    base::Arena scene(memory.data(), 1 << 17), slices(memory.data() + (1 << 17), 1 << 16);
    display::SpatialData data;
    EXPECT_EQ(data.start(&file.value(), {scene, slices}, 64).message.view(), "");
    host_sim::PictureOptions options;
    options.design = files.folder().write("design.toml", design_text);
    const design::DesignSettings design = host_sim::load_design(options);
    draw::DataLegends legends;
    display::add_ground_legend(data, data.plan(design.data, {}), design, {}, legends);
    return test_support::text_in(legends, test_support::area_of(30));
}

TEST(LandCoverLegend, NamesTheKindsInUse) {
    SceneFiles files;
    files.write(kPalette, "cover.toml");
    files.write(cover_raster());
    EXPECT_EQ(files.build(cover_layer()).code, 0);
    const std::string text = legend_of(files, cover_design());
    for (const char* const name : {"FOREST", "GRASS", "WATER", "MISSING", "COVERKIND"}) EXPECT_THAT(text, HasSubstr(name));
    EXPECT_THAT(text, Not(HasSubstr("SNOW"))) << "which has no colour";
    EXPECT_THAT(text, Not(HasSubstr("FILLED"))) << "kinds are never interpolated";
    EXPECT_THAT(text, Not(HasSubstr("SAND"))) << "of which there is none";
    RasterFile water = cover_raster();
    water.value = [](int, int) { return kWater; };
    files.write(water);
    EXPECT_EQ(files.build(cover_layer()).code, 0);
    const std::string alone = legend_of(files, cover_design());
    EXPECT_THAT(alone, HasSubstr("WATER"));
    EXPECT_THAT(alone, Not(HasSubstr("FOREST")));
}

/// What is shipped belongs together: the palette has a colour for each kind of the scene.
TEST(LandCover, TheShippedPaletteNamesTheShippedKinds) {
    const std::string path = test_support::source_dir() + "/configs/scenes/jacksboro.toml";
    const design::Palette palette = test_support::ShippedFiles().find({"data_land_cover", ""}).value();
    std::size_t kinds = 0;
    for (const host_sim::LayerRecipe& layer : host_sim::parse_scene(host_sim::read_file(path), path).layers)
        if (layer.role == scene::LayerRole::land_cover)
            for (const std::string& name : layer.attributes.at(0).classes) {
                EXPECT_GT(color_of_name(palette, name).alpha, 0) << name;
                ++kinds;
            }
    EXPECT_EQ(kinds, palette.class_names.size());
}

}  // namespace
}  // namespace tedavis::tests::test_land_cover
