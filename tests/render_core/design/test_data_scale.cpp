#include "render_core/design/data_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/design/color_difference.hpp"
#include "render_core/design/design_settings.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::design::test_data_scale {
namespace {

using test_support::scale_of;

TEST(DataScale, AValueBelongsToExactlyOneClass) {
    const DataScale scale = scale_of({10, 20, 40});
    EXPECT_EQ(class_of(scale, -1e9), 0u);
    EXPECT_EQ(class_of(scale, std::nextafter(10.0, 0.0)), 0u);
    EXPECT_EQ(class_of(scale, 10), 1u) << "a limit belongs to the class above it";
    EXPECT_EQ(class_of(scale, 20), 2u);
    EXPECT_EQ(class_of(scale, 39.999), 2u);
    EXPECT_EQ(class_of(scale, 40), 3u);
    EXPECT_EQ(class_of(scale, std::numeric_limits<double>::infinity()), 3u);
    EXPECT_EQ(class_of(scale_of({}), 55), 0u);
}

TEST(DataScale, ClassesHaveTheColorsOfTheirMiddles) {
    const DataScale scale = scale_of({10, 20, 40});
    EXPECT_NEAR(scale_color(scale, 3).red, 255 * 0.05, 0.6);
    EXPECT_NEAR(scale_color(scale, 12).red, 255 * 0.15, 0.6);
    EXPECT_NEAR(scale_color(scale, 25).red, 255 * 0.3, 0.6);
    EXPECT_NEAR(scale_color(scale, 99).red, 255 * 0.7, 0.6);
    EXPECT_NEAR(scale_color(scale_of({}), 25).red, 255 * 0.25, 0.6) << "without classes it is the palette";
}

TEST(DataScale, KindsAreNeitherDividedNorJoined) {
    const auto fault_of = [](const std::string& text) {
        test_support::GreyPalettes palettes;
        base::ConfigReader reader(text, "d.toml");
        base::ConfigSection root = reader.root();
        DataScale scale;
        read_scale(root, palettes, scale);
        return reader.finish() ? std::string() : std::string(reader.error().message.view());
    };
    EXPECT_EQ(fault_of("palette = 'kinds'\n"), "");
    for (const char* const limits : {"classes = 3\n", "breaks = [0.5]\n"})
        EXPECT_NE(fault_of(std::string("palette = 'kinds'\n") + limits).find("has classes of its own"), std::string::npos);
    EXPECT_EQ(fault_of("palette = 'grey'\nclasses = 3\n"), "") << "control";
    DataScale scale;
    scale.palette = test_support::kinds_palette();
    reduce_classes(scale, 2);
    EXPECT_TRUE(scale.breaks.empty());
    EXPECT_EQ(scale_color(scale, 1), (Color{210, 210, 210}));
}

/// Hue of CIELAB: red 40, yellow 100, green 136, magenta -30 degrees, as the primaries of a screen have them.
double hue_deg(Color color) {
    const Lab lab = lab_of(linear_rgb(color));
    return base::degrees(std::atan2(lab.b, lab.a));
}

/// What a weather radar shows. Control: brown, as cells were, has none of these hues.
TEST(DataScale, StormCellsHaveTheColorsOfAWeatherRadar) {
    const DesignSettings design = test_support::shipped_design("default");
    const DataElement* cells = nullptr;
    for (const DataElement& element : design.data.elements)
        if (element.role == scene::LayerRole::storm_cell) cells = &element;
    ASSERT_NE(cells, nullptr);
    struct Expected {
        double from_dbz, to_dbz, hue_deg;
    };
    for (const Expected& expected : {Expected{20, 29.9, 138}, {30, 39.9, 100}, {40, 49.9, 39}, {50, 75, -15}})
        for (const double dbz : {expected.from_dbz, expected.to_dbz}) {
            const Color color = scale_color(cells->by_color.scale, dbz);
            EXPECT_NEAR(hue_deg(color), expected.hue_deg, 8) << dbz;
            const Lab lab = lab_of(linear_rgb(color));
            EXPECT_GT(std::hypot(lab.a, lab.b), 60) << dbz;
        }
    const Lab weak = lab_of(linear_rgb(scale_color(cells->by_color.scale, 12)));
    EXPECT_LT(std::hypot(weak.a, weak.b), 50) << "pale where it is weak";
    EXPECT_LE(cells->opacity, 0.45) << "ground and sky show through";
    const Color brown{0x8a, 0x52, 0x38};
    EXPECT_GT(std::fabs(hue_deg(brown) - 39), 8) << "control";
}

}  // namespace
}  // namespace tedavis::design::test_data_scale
