#include "render_core/design/focus_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tedavis::design::test_focus_settings {
namespace {

/// Empty where the text is accepted.
std::string read(const std::string& text, FocusList& foci) {
    base::ConfigReader reader(text, "d.toml");
    base::ConfigSection root = reader.root();
    read_foci(root, foci);
    return reader.finish() ? std::string() : std::string(reader.error().message.view());
}

TEST(FocusSettings, ThereIsNoneUnlessADesignHasOne) {
    FocusList foci;
    EXPECT_EQ(read("", foci), "");
    EXPECT_TRUE(foci.empty());
}

TEST(FocusSettings, AreWhatTheFileSays) {
    FocusList foci;
    EXPECT_EQ(read("[[focus]]\nname = 'dest'\nshape = 'cuboid'\nat = 'position'\nposition_deg = [46.5, -9.25]\nradius_m = 800\n"
                   "lower_m = 900\nupper_m = 3000\n"
                   "[focus.context]\nwidth_m = 1500\nlevels = 3\n"
                   "[focus.terrain]\nsketch_outside = true\nbrightness = 0.5\nsaturation = 0.25\nblur_px = 3\n"
                   "[focus.data]\ndetail = 0.5\nbrightness = 0.6\nsaturation = 0.7\nsize = 0.8\naggregate = 4\n"
                   "context = 'hidden'\n"
                   "[focus.border]\nkind = 'halo'\ncolor = '#102030'\nwidth_px = 4\n"
                   "[focus.distortion]\npower = 2\n",
                   foci),
              "");
    ASSERT_EQ(foci.size(), 1u);
    const FocusSettings& focus = foci[0];
    EXPECT_EQ(focus.name.view(), "dest");
    EXPECT_EQ(focus.shape, FocusShape::cuboid);
    EXPECT_EQ(focus.at, FocusAt::position);
    EXPECT_DOUBLE_EQ(focus.latitude_rad, 46.5 * std::acos(-1.0) / 180);
    EXPECT_DOUBLE_EQ(focus.longitude_rad, -9.25 * std::acos(-1.0) / 180);
    EXPECT_EQ(focus.radius_m, 800);
    EXPECT_EQ(focus.lower_m, 900);
    EXPECT_EQ(focus.upper_m, 3000);
    EXPECT_EQ(focus.context.distance, scene::FocusDistance::chebyshev) << "as its shape";
    EXPECT_EQ(focus.context.width_m, 1500);
    EXPECT_EQ(focus.context.levels, 3u);
    EXPECT_TRUE(focus.terrain.sketch_outside);
    EXPECT_EQ(focus.terrain.brightness, 0.5);
    EXPECT_EQ(focus.terrain.saturation, 0.25);
    EXPECT_EQ(focus.terrain.blur_px, 3);
    EXPECT_EQ(focus.of_data.detail, 0.5);
    EXPECT_EQ(focus.of_data.brightness, 0.6);
    EXPECT_EQ(focus.of_data.saturation, 0.7);
    EXPECT_EQ(focus.of_data.size, 0.8);
    EXPECT_EQ(focus.of_data.aggregate, 4u);
    EXPECT_EQ(focus.of_data.context, FocusContextData::hidden);
    EXPECT_EQ(focus.border.kind, FocusBorderKind::halo);
    EXPECT_EQ(focus.border.color, (Color{0x10, 0x20, 0x30}));
    EXPECT_EQ(focus.border.width_px, 4);
    EXPECT_EQ(focus.power, 2u);
}

TEST(FocusSettings, AskForNothingByThemselves) {
    FocusList foci;
    EXPECT_EQ(read("[[focus]]\n", foci), "");
    ASSERT_EQ(foci.size(), 1u);
    EXPECT_EQ(foci[0].name.view(), "circle");
    EXPECT_EQ(foci[0].at, FocusAt::own_ship);
    EXPECT_FALSE(foci[0].terrain.is_any());
    EXPECT_FALSE(foci[0].of_data.is_any());
    EXPECT_EQ(foci[0].border.kind, FocusBorderKind::none);
    EXPECT_EQ(foci[0].power, 0u);
}

TEST(FocusSettings, DataByValueIntervalOrExtreme) {
    FocusList foci;
    const std::string head = "[[focus]]\nshape = 'data'\nrole = 'wind'\nattribute = 'speed'\n";
    EXPECT_EQ(read(head + "value = 12\nwithin = 0.5\nsimilar = 3\n", foci), "");
    EXPECT_EQ(foci[0].data.low, 11.5);
    EXPECT_EQ(foci[0].data.high, 12.5);
    EXPECT_EQ(foci[0].data.similar, 3);
    EXPECT_EQ(foci[0].data.role, scene::LayerRole::wind);
    EXPECT_EQ(read(head + "interval = [10, 15]\n", foci), "");
    EXPECT_EQ(foci[0].data.values, FocusValues::interval);
    EXPECT_EQ(foci[0].data.low, 10);
    EXPECT_EQ(foci[0].data.high, 15);
    EXPECT_EQ(read(head + "extreme = 'lowest'\nwithin = 1\n", foci), "");
    EXPECT_EQ(foci[0].data.values, FocusValues::lowest);
    EXPECT_EQ(foci[0].data.within, 1);
}

TEST(FocusSettings, FourHaveRoom) {
    FocusList foci;
    std::string text;
    for (int n = 0; n < 4; ++n) text += "[[focus]]\n";
    EXPECT_EQ(read(text, foci), "");
    EXPECT_EQ(foci.size(), 4u);
    EXPECT_NE(read(text + "[[focus]]\n", foci).find("keep at most 4"), std::string::npos);
}

TEST(FocusSettings, TheContextIsCommonToAll) {
    FocusList foci;
    EXPECT_EQ(read("[[focus]]\n[[focus]]\n[focus.terrain]\nbrightness = 0.5\n[[focus]]\n[focus.data]\nsize = 0.5\n", foci), "");
    EXPECT_EQ(terrain_of_context(foci).brightness, 0.5);
    EXPECT_EQ(data_of_context(foci).size, 0.5);
    for (const char* table : {"[focus.terrain]\n", "[focus.data]\n"})
        EXPECT_NE(read("[[focus]]\n" + std::string(table) + "[[focus]]\n" + table, foci).find("stated twice"), std::string::npos);
    EXPECT_EQ(read("[[focus]]\n[focus.border]\n[[focus]]\n[focus.border]\nkind = 'line'\n", foci), "") << "of each its own";
    EXPECT_FALSE(terrain_of_context(foci).is_any());
    EXPECT_FALSE(data_of_context(foci).is_any());
}

TEST(FocusSettings, APathIsTheWayAheadAndNothingElseIs) {
    FocusList foci;
    EXPECT_EQ(read("[[focus]]\nshape = 'path'\n", foci), "");
    EXPECT_EQ(foci[0].at, FocusAt::flight_path);
    EXPECT_NE(read("[[focus]]\nshape = 'path'\nat = 'own_ship'\n", foci), "");
    EXPECT_NE(read("[[focus]]\nshape = 'circle'\nat = 'flight_path'\n", foci), "");
}

TEST(FocusSettings, WhatHasNoMeaningIsRefused) {
    FocusList foci;
    for (const char* text : {"shape = 'ring'\n",
                             "at = 'home'\n",
                             "at = 'place'\n",
                             "place = 'DAVOS'\n",
                             "at = 'position'\n",
                             "position_deg = [1, 2]\n",
                             "at = 'position'\nposition_deg = [91, 0]\n",
                             "ahead_s = 60\n",
                             "height_m = 100\n",
                             "lower_m = 1\n",
                             "shape = 'cuboid'\nlower_m = 1\n",
                             "shape = 'cuboid'\nlower_m = 2\nupper_m = 1\n",
                             "radius_m = 0\n",
                             "value = 1\n",
                             "similar = 1\n",
                             "shape = 'data'\n",
                             "shape = 'data'\nlayer = 'a'\nattribute = 'b'\n",
                             "shape = 'data'\nlayer = 'a'\nvalue = 1\n",
                             "shape = 'data'\nlayer = 'a'\nrole = 'wind'\nattribute = 'b'\nvalue = 1\n",
                             "shape = 'data'\nlayer = 'a'\nattribute = 'b'\nvalue = 1\ninterval = [1, 2]\n",
                             "shape = 'data'\nlayer = 'a'\nattribute = 'b'\ninterval = [2, 1]\n",
                             "shape = 'data'\nlayer = 'a'\nattribute = 'b'\ninterval = [1, 2]\nwithin = 1\n",
                             "shape = 'data'\nlayer = 'a'\nattribute = 'b'\nvalue = 1\nat = 'own_ship'\n",
                             "place = 'a name of more than 23 bytes'\n",
                             "[focus.context]\nwidth_m = -1\n",
                             "[focus.context]\nlevels = 17\n",
                             "[focus.context]\ndistance = 'taxi'\n",
                             "[focus.terrain]\nbrightness = 2\n",
                             "[focus.data]\nsize = 0\n",
                             "[focus.data]\ncontext = 'gone'\n",
                             "[focus.border]\nkind = 'fence'\n",
                             "[focus.distortion]\npower = 5\n",
                             "[focus.lens]\n",
                             "zoom = 1\n"})
        EXPECT_NE(read("[[focus]]\n" + std::string(text), foci).find("d.toml:"), std::string::npos) << text;
}

TEST(FocusSettings, OneLineStatesWhatATableDoes) {
    const auto line =
        read_focus("shape = \"square\", at = \"place\", place = \"DAVOS\", radius_m = 700, terrain.brightness = 0.5");
    ASSERT_TRUE(line.ok());
    FocusList foci;
    EXPECT_EQ(
        read("[[focus]]\nshape = 'square'\nat = 'place'\nplace = 'DAVOS'\nradius_m = 700\n[focus.terrain]\nbrightness = 0.5\n",
             foci),
        "");
    const FocusSettings& focus = line.value();
    EXPECT_EQ(focus.shape, foci[0].shape);
    EXPECT_EQ(focus.place.view(), foci[0].place.view());
    EXPECT_EQ(focus.radius_m, foci[0].radius_m);
    EXPECT_EQ(focus.terrain.brightness, foci[0].terrain.brightness);
    EXPECT_EQ(focus.context.distance, foci[0].context.distance);
    for (const char* text : {"shape = \"ring\"", "shape = square", "}, {", "radius = 3"})
        EXPECT_FALSE(read_focus(text).ok()) << text;
    EXPECT_FALSE(read_focus(std::string(2000, ' ')).ok());
    EXPECT_NE(read_focus("radius_m = 1").error().message.view().find("--focus:1: 'radius_m' must be"), std::string::npos);
}

TEST(FocusSettings, BrightnessStandsForBlur) {
    const FocusTerrain blurred{true, 0.6, 0.3, 5}, sharp{false, 0.6, 1, 0};
    EXPECT_DOUBLE_EQ(darkened_instead_of_blurred(blurred).brightness, 0.6 * kBlurAsBrightness);
    EXPECT_EQ(darkened_instead_of_blurred(blurred).blur_px, 0);
    EXPECT_TRUE(darkened_instead_of_blurred(blurred).sketch_outside);
    EXPECT_EQ(darkened_instead_of_blurred(sharp).brightness, 0.6);
}

}  // namespace
}  // namespace tedavis::design::test_focus_settings
