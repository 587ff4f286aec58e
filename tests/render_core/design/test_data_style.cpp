#include "render_core/design/data_style.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/grey_palettes.hpp"

namespace tedavis::design {
namespace {

using test_support::GreyPalettes;

struct Read {
    DataStyle style;
    std::string fault;
};
Read read(const std::string& text) {
    GreyPalettes palettes;
    base::ConfigReader reader(text, "d.toml");
    Read result;
    read_data_style(reader.root().section("data"), palettes, result.style);
    if (!reader.finish()) result.fault = std::string(reader.error().sentence.view());
    return result;
}

TEST(DataStyle, EveryKeyIsRead) {
    const Read whole = read(R"([data.ground]
layer = "radar"
attribute = "reflectivity"
palette = "grey"
breaks = [10, 30.5]
opacity = 0.5
height_m = 1500
[data.ground.uncertainty]
technique = "noise"
strength = 0.4
levels = 3
)");
    EXPECT_EQ(whole.fault, "");
    const GroundData& ground = whole.style.ground;
    EXPECT_TRUE(ground.is_shown);
    EXPECT_EQ(ground.layer.view(), "radar");
    EXPECT_EQ(ground.attribute.view(), "reflectivity");
    ASSERT_EQ(ground.scale.breaks.size(), 2u);
    EXPECT_EQ(ground.scale.breaks[1], 30.5);
    EXPECT_EQ(ground.opacity, 0.5);
    EXPECT_EQ(ground.height_m, 1500);
    EXPECT_EQ(ground.uncertainty.technique, IntrinsicUncertainty::noise);
    EXPECT_EQ(ground.uncertainty.levels, 3u);
    EXPECT_FALSE(read("").style.ground.is_shown) << "nothing is shown that is not asked for";
    EXPECT_FALSE(read("[data.ground]\nenabled = false\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'").style.ground.is_shown);
}

TEST(DataStyle, FaultsAreSaid) {
    const std::string start = "[data.ground]\nlayer = 'a'\nattribute = 'b'\n";
    EXPECT_NE(read("[data.ground]\nlayer = 'a'\npalette = 'grey'").fault, "");
    EXPECT_NE(read(start + "palette = 'none'").fault, "");
    EXPECT_EQ(read(start + "palette = 'grey'\nbreaks = [5, 5]").fault, "d.toml:5: 'breaks' must ascend; sort them");
    EXPECT_NE(read(start + "palette = 'grey'\nbreaks = [5]\nclasses = 3").fault.find("keep one"), std::string::npos);
    EXPECT_NE(read(start + "palette = 'grey'\nclasses = 1").fault.find("2 to 16"), std::string::npos);
    EXPECT_NE(read(start + "palette = 'grey'\nopacity = 2").fault, "");
    EXPECT_NE(read(start + "palette = 'grey'\n[data.ground.uncertainty]\ntechnique = 'magic'").fault, "");
    EXPECT_NE(read(start + "palette = 'grey'\n[data.ground.uncertainty]\nlevels = 1").fault, "");
    EXPECT_NE(read(start + "palette = 'grey'\nbreaks = [0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15]").fault.find("at most 15"),
              std::string::npos);
}

TEST(DataStyle, ManyClassesAreAlmostThePalette) {
    const Read fine = read("[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'\nclasses = 16");
    ASSERT_EQ(fine.style.ground.scale.breaks.size(), 15u);
    for (double value = 0; value <= 100; value += 0.7)
        EXPECT_NEAR(scale_color(fine.style.ground.scale, value).red, 2.55 * value, 255 / 32.0 + 0.6) << "half a class";
}

TEST(DataStyle, ProgramsDifferByTechnique) {
    DataStyle none, shown;
    shown.ground.is_shown = true;
    EXPECT_FALSE(same_programs(none, shown));
    DataStyle other = shown;
    other.ground.opacity = 0.1;
    other.ground.uncertainty.strength = 0.1;
    EXPECT_TRUE(same_programs(shown, other));
    other.ground.uncertainty.technique = IntrinsicUncertainty::strokes;
    EXPECT_FALSE(same_programs(shown, other));
}

}  // namespace
}  // namespace tedavis::design
