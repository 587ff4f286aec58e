#include "render_core/design/data_scale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/design/color_difference.hpp"
#include "render_core/design/design_settings.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/hard_case.hpp"

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

/// The naive form: the palette is stretched over the data's own span, which is 0 for one value everywhere.
double share_of_span(const std::vector<double>& data, double value) {
    const auto [low, high] = std::minmax_element(data.begin(), data.end());
    return (value - *low) / (*high - *low);
}

TEST(DataScale, OneValueEverywhereHasItsColor) {
    const DataScale scale = scale_of({});
    int wrong = 0, without_share = 0;
    for (const double value : {42.0, 0.0, 100.0, 1e-30, 5e-324}) {
        wrong += std::fabs(scale_color(scale, value).red - 255 * value / 100) > 0.6 ? 1 : 0;
        const double share = share_of_span({value, value}, value);
        without_share += std::fabs(share - value / 100) <= 0.6 / 255 ? 0 : 1;
        EXPECT_TRUE(std::isnan(share)) << "control: 0/0";
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(without_share, 5) << "control";
    EXPECT_EQ(share_of_span({5, std::nextafter(5, 6)}, 5), 0) << "rounding is stretched over the whole palette,";
    EXPECT_EQ(share_of_span({5, std::nextafter(5, 6)}, std::nextafter(5, 6)), 1);
    EXPECT_EQ(scale_color(scale, std::nextafter(5, 6)), scale_color(scale, 5)) << "which the product does not do";
    test_support::record_worst("A37", wrong);
    test_support::record_control("A37", without_share);
}

TEST(DataScale, NarrowPalettesAndNoNumbersHaveColors) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(class_of(scale_of({10, 20}), nan), 0u) << "the lowest: missing values are left out before";
    EXPECT_EQ(scale_color(scale_of({}), nan), (Color{0, 0, 0}));
    for (const double high : {std::nextafter(5.0, 6.0), 5 + 1e-300, 5e-324}) {
        DataScale narrow;
        const double low = high < 1 ? 0 : 5;
        ASSERT_TRUE(narrow.palette.stops.try_push_back({low, {0, 0, 0}}));
        for (const double value : {-1.0, low, high, 7.0}) EXPECT_EQ(scale_color(narrow, value), (Color{0, 0, 0})) << "one stop";
        ASSERT_TRUE(narrow.palette.stops.try_push_back({high, {255, 255, 255}}));
        EXPECT_EQ(scale_color(narrow, low), (Color{0, 0, 0}));
        EXPECT_EQ(scale_color(narrow, 7), (Color{255, 255, 255}));
    }
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
