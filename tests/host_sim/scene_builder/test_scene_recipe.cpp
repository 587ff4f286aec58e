#include "host_sim/scene_builder/scene_recipe.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scene_recipe {
namespace {

using scene::LayerRole;
using test_support::expect_user_error;

constexpr const char* kWhole = R"(name = "davos"
origin = "Copernicus"
[[layer]]
name = "wind"
title = "WIND"
source = "era5.nc"
role = "wind"
importance = 200
from = "2020-01-15T12:00:00Z"
until = "2020-01-15T18:00:00Z"
valid_hours = 1.5
height_variable = "z"
height_factor = 0.101971621
height_datum = "msl"
[layer.prepare]
fill_cells = 2
smooth_cells = 0.5
[layer.prepare.region]
west_deg = 9
south_deg = 46
east_deg = 10.5
north_deg = 47.5
[[layer.attribute]]
name = "east"
variable = "u"
unit = "m/s"
missing = [-32767, 9999]
least = -150
most = 150
[layer.attribute.uncertainty]
kind = "standard_deviation"
value = 2
full = 8
growth_per_hour = 0.05
[[layer.attribute]]
name = "cover"
scale = "nominal"
classes = ["water", "wood", "rock"]
)";

std::string with(const std::string& text, const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
}

void expect_fault(const std::string& text, const std::string& words) {
    expect_user_error([&text] { (void)parse_scene(text, "s.toml"); }, words);
}

TEST(SceneRecipe, MembersAreKeptOfAnEnsembleOnly) {
    const auto layer = [](const std::string& keys) {
        return "name = 's'\n[[layer]]\nname = 'a'\nsource = 'a.tif'\n" + keys + "[[layer.attribute]]\nname = 'v'\n";
    };
    const SceneRecipe scene = parse_scene(layer("members = 'bands'\nkeep_members = 9\n"), "s.toml");
    EXPECT_EQ(scene.layers[0].keep_members, 9u);
    EXPECT_EQ(parse_scene(layer("members = 'bands'\n"), "s.toml").layers[0].keep_members, 0u);
    expect_fault(layer("keep_members = 9\n"), "needs members = \"bands\"");
    expect_fault(layer("members = 'bands'\nkeep_members = 1\n"), "one member alone is no ensemble");
    expect_fault(layer("members = 'bands'\nkeep_members = 17\n"), "keep_members");
}

TEST(SceneRecipe, ASpreadIsThatOfMembers) {
    const auto layer = [](const std::string& members, const std::string& keys) {
        return "name = 's'\n[[layer]]\nname = 'a'\nsource = 'a.tif'\n" + members +
               "[[layer.attribute]]\nname = 'v'\n[layer.attribute.uncertainty]\n" + keys;
    };
    const std::string bands = "members = 'bands'\n", spread = "kind = 'standard_deviation'\nis_spread = true\n";
    EXPECT_TRUE(parse_scene(layer(bands, spread), "s.toml").layers[0].attributes[0].uncertainty.is_spread);
    expect_fault(layer("", spread), "s.toml:9: 'is_spread'");
    expect_fault(layer("", spread), "give members = \"bands\"");
    expect_fault(layer(bands, "kind = 'percent'\nis_spread = true\n"), "'is_spread' is a standard deviation");
    expect_fault(layer(bands, spread + "is_quality = true\n"), "how unsure, not how sure");
    expect_fault(layer("", "kind = 'ordinal'\nvariable = 'q'\nclasses = ['sure', 'guessed']\nis_quality = true\n"),
                 "from certain to wholly unsure already");
}

TEST(SceneRecipe, EveryKeyIsRead) {
    const SceneRecipe scene = parse_scene(kWhole, "s.toml");
    EXPECT_EQ(scene.name, "davos");
    ASSERT_EQ(scene.layers.size(), 1u);
    const LayerRecipe& layer = scene.layers[0];
    EXPECT_EQ(layer.role, scene::LayerRole::wind);
    EXPECT_EQ(layer.importance, 200);
    ASSERT_TRUE(layer.from_ns && layer.until_ns);
    EXPECT_EQ(*layer.until_ns - *layer.from_ns, std::int64_t{6} * 3'600'000'000'000);
    EXPECT_EQ(layer.valid_hours, 1.5);
    EXPECT_EQ(layer.height_variable, "z");
    ASSERT_TRUE(layer.prepare.region.has_value());
    EXPECT_EQ(layer.prepare.region->east_deg, 10.5);
    EXPECT_EQ(layer.prepare.fill_cells, 2);
    ASSERT_EQ(layer.attributes.size(), 2u);
    const AttributeRecipe &east = layer.attributes[0], &cover = layer.attributes[1];
    EXPECT_EQ(east.variable, "u");
    EXPECT_EQ(east.missing, (std::vector<double>{-32767, 9999}));
    EXPECT_EQ(east.most, 150);
    EXPECT_EQ(east.uncertainty.kind, scene::UncertaintyKind::standard_deviation);
    EXPECT_EQ(east.uncertainty.value, 2);
    EXPECT_EQ(east.uncertainty.full, 8);
    EXPECT_EQ(cover.variable, "cover") << "the column has the attribute's name unless said otherwise";
    EXPECT_EQ(cover.classes.size(), 3u);
    EXPECT_EQ(cover.uncertainty.kind, scene::UncertaintyKind::none);
}

TEST(SceneRecipe, KeysOfTablesAndFlights) {
    const std::string head = "name = 's'\n[[layer]]\nname = 'masts'\nsource = 'm.csv'\nrole = 'obstacle'\n";
    const LayerRecipe plain = parse_scene(head, "s.toml").layers[0];
    EXPECT_EQ(plain.name_variable, "name");
    EXPECT_EQ(plain.time_variable, "");
    EXPECT_TRUE(plain.attributes.empty());
    const LayerRecipe masts = parse_scene(head +
                                              "name_variable = 'ident'\ntime_variable = 'seen'\naircraft = 'HBKRA'\n"
                                              "[layer.prepare]\nkeep_attribute = 'kind'\nkeep_most = 1\n"
                                              "[[layer.attribute]]\nname = 'kind'\n[layer.attribute.uncertainty]\n"
                                              "kind = 'ordinal'\nvariable = 'trust'\nclasses = ['sure', 'so-so', 'guessed']\n",
                                          "s.toml")
                                  .layers[0];
    EXPECT_EQ(masts.name_variable, "ident");
    EXPECT_EQ(masts.time_variable, "seen");
    EXPECT_EQ(masts.aircraft, "HBKRA");
    EXPECT_EQ(masts.prepare.keep_most, 1);
    EXPECT_LT(masts.prepare.keep_least, -1e9);
    EXPECT_EQ(masts.attributes[0].uncertainty.classes.size(), 3u);
    expect_fault(head +
                     "[[layer.attribute]]\nname = 'kind'\n[layer.attribute.uncertainty]\nkind = 'ordinal'\nvalue = 1\n"
                     "classes = ['sure', 'guessed']\n",
                 "two or more names are needed, and the 'variable' that holds them");
}

TEST(SceneRecipe, ANameThatIsTooLongForATitleHasNone) {
    const auto titled = [](const std::string& name) {
        return parse_scene("name = 'x'\n[[layer]]\nname = 'a'\nsource = 'b'\n[[layer.attribute]]\nname = '" + name + "'\n",
                           "s.toml")
            .layers[0]
            .attributes[0]
            .title;
    };
    EXPECT_EQ(titled("height_accuracy"), "height_accuracy");
    EXPECT_EQ(titled("position_accuracy"), "") << "legends show the name itself";
}

TEST(SceneRecipe, WhatIsDrawnInMetresIsNotCalledFeet) {
    const auto layer = [](const std::string& role, const std::string& attribute) {
        return "name = 'x'\n[[layer]]\nname = 'a'\nsource = 'b'\nrole = '" + role + "'\n[[layer.attribute]]\n" + attribute;
    };
    const auto unit_of = [&](const std::string& role, const std::string& attribute) {
        return parse_scene(layer(role, attribute), "s.toml").layers[0].attributes[0].unit;
    };
    expect_fault(layer("obstacle", "name = 'height'\nunit = 'ft'\n"),
                 "s.toml:8: 'height' of this role is in m, not in 'ft'; give unit = \"m\" and factor = 0.3048");
    expect_fault(layer("no_go", "name = 'ceiling'\nunit = 'ft'\n"), "'ceiling' of this role is in m");
    expect_fault(layer("wind", "name = 'east'\nunit = 'kt'\n"), "give unit = \"m/s\" and factor = 0.514444444");
    expect_fault(layer("obstacle", "name = 'height'\nunit = 'furlong'\n"),
                 "and the factor that makes m of what the source states");
    expect_fault(layer("obstacle", "name = 'height'\nunit = 'ft'\nfactor = 0.3048\n"), "give unit = \"m\" and the factor");
    expect_fault(layer("trajectory", "name = 'wind'\nvariable = 'derived:wind_speed'\nunit = 'kt'\n"),
                 "s.toml:9: 'derived:wind_speed' is in m/s");
    EXPECT_EQ(unit_of("obstacle", "name = 'height'\nunit = 'm'\nfactor = 0.3048\n"), "m");
    EXPECT_EQ(unit_of("obstacle", "name = 'height'\n"), "m") << "it is known";
    EXPECT_EQ(unit_of("sample", "name = 'height'\nunit = 'ft'\n"), "ft") << "nothing is drawn by it as metres";
    EXPECT_EQ(unit_of("trajectory", "name = 'wind'\nvariable = 'derived:wind_speed'\nunit = 'kt'\nfactor = 1.94384\n"), "kt");
}

TEST(SceneRecipe, NamesAreThoseOfTheFile) {
    EXPECT_EQ(scene::name_of(LayerRole::storm_cell), "storm_cell");
    EXPECT_EQ(scene::name_of(LayerRole::model), "model");
    EXPECT_EQ(shape_name(scene::LayerShape::areas), "areas");
    EXPECT_EQ(scale_name(scene::AttributeScale::ordinal), "ordinal");
    EXPECT_EQ(kind_name(scene::UncertaintyKind::percent), "percent");
    EXPECT_EQ(scope_name(scene::UncertaintyScope::data_set), "data_set");
}

TEST(SceneRecipe, FaultsAreSaidWithTheirLine) {
    expect_fault("origin = 'x'", "name");
    expect_fault("name = 'x'", "1 to 32 tables [[layer]]");
    expect_fault(with(kWhole, "role = \"wind\"", "role = \"breeze\""), "s.toml:7: 'role' must be one of: field, wind");
    expect_fault(with(kWhole, "from = \"2020-01-15T12:00:00Z\"", "from = \"noon\""), "s.toml:9: no time such as");
    expect_fault(with(kWhole, "from = \"2020-01-15T12", "from = \"2021-01-15T12"), "must not be after 'until'");
    expect_fault(with(kWhole, "south_deg = 46", "south_deg = 48"), "must be below north_deg");
    expect_fault(with(kWhole, "classes = [\"water\", \"wood\", \"rock\"]\n", ""), "need 'classes'");
    expect_fault(with(kWhole, "scale = \"nominal\"", "scale = \"quantitative\""), "has no 'classes'");
    expect_fault(with(kWhole, "classes = [\"water\", \"wood\", \"rock\"]\n",
                      "classes = [\"water\", \"wood\", \"rock\"]\nclass_values = [1, 2]\n"),
                 "one number for each name");
    expect_fault(with(kWhole, "value = 2\n", ""), "must say how large it is");
    expect_fault(with(kWhole, "value = 2\n", "value = 2\nvariable = \"e\"\n"), "must say how large it is");
    expect_fault(with(kWhole, "full = 8", "full = 0"), "'full' must be");
    expect_fault(with(kWhole, "unit = \"m/s\"\n", "unit = \"m/s\"\nfactor = 0\n"), "must not be 0");
    expect_fault(with(kWhole, "source = \"era5.nc\"\n", ""), "source");
    expect_fault(with(kWhole, "least = -150", "leest = -150"), "unknown key");
}

TEST(SceneRecipe, DataAreNoSceneFile) {
    expect_user_error([] { (void)parse_scene(std::string_view("GRIB\0\0", 6), "storm.grib"); },
                      "storm.grib: is no scene file, which is TOML text; see what data hold by 'tedavis scene look FILE'");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scene_recipe
