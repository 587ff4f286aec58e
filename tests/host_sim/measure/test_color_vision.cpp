#include "host_sim/measure/color_vision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tedavis::host_sim::test_color_vision {
namespace {

double seen_difference(ColorVision vision, const design::LinearRgb& first, const design::LinearRgb& second) {
    return color_difference(lab_of(seen_with(vision, first)), lab_of(seen_with(vision, second)));
}

struct Copunctal {
    ColorVision vision;
    double x, y;
};
// Where the confusion lines of each dichromacy meet in the CIE 1931 diagram (Smith, Pokorny, Vision Research 15, 1975).
constexpr Copunctal kCopunctal[] = {
    {ColorVision::protan, 0.747, 0.253}, {ColorVision::deutan, 1.080, -0.080}, {ColorVision::tritan, 0.171, 0.0}};

/// Linear sRGB of the missing cone's light alone, its largest part 1.
design::LinearRgb missing_light(const Copunctal& point) {
    const double z = 1 - point.x - point.y;
    const double red = 3.2404542 * point.x - 1.5371385 * point.y - 0.4985314 * z;
    const double green = -0.9692660 * point.x + 1.8760108 * point.y + 0.0415560 * z;
    const double blue = 0.0556434 * point.x - 0.2040259 * point.y + 1.0572252 * z;
    const double most = std::fmax(std::fabs(red), std::fmax(std::fabs(green), std::fabs(blue)));
    return {red / most, green / most, blue / most};
}

TEST(ColorVision, ColorsOnAConfusionLineLookAlikeToItsOwnDeficiencyAlone) {
    for (const Copunctal& point : kCopunctal) {
        const design::LinearRgb step = missing_light(point);
        for (const design::LinearRgb& from :
             {design::LinearRgb{0.3, 0.3, 0.3}, design::LinearRgb{0.25, 0.3, 0.2}, design::LinearRgb{0.4, 0.3, 0.3}})
            for (const double amount : {0.1, -0.1}) {
                const design::LinearRgb to{from.red + amount * step.red, from.green + amount * step.green,
                                           from.blue + amount * step.blue};
                const double normal = seen_difference(ColorVision::normal, from, to);
                ASSERT_GT(normal, 6);
                EXPECT_LT(seen_difference(point.vision, from, to), 0.3 * normal) << to_string(point.vision);
                const bool red_green = point.vision != ColorVision::tritan;
                const ColorVision other = red_green ? ColorVision::tritan : ColorVision::protan;
                EXPECT_GT(seen_difference(other, from, to), 0.7 * normal) << "control: " << to_string(other);
            }
    }
}

TEST(ColorVision, GreysStayAndNormalVisionChangesNothing) {
    for (const double light : {0.0, 0.05, 0.3, 0.7, 1.0})
        for (const ColorVision vision : kColorVisions) {
            const design::LinearRgb seen = seen_with(vision, {light, light, light});
            EXPECT_NEAR(seen.red, light, 2e-6);
            EXPECT_NEAR(seen.green, light, 2e-6);
            EXPECT_NEAR(seen.blue, light, 2e-6);
        }
    const design::LinearRgb same = seen_with(ColorVision::normal, {0.1, 0.5, 0.9});
    EXPECT_EQ(same.red, 0.1);
    EXPECT_EQ(same.green, 0.5);
    EXPECT_EQ(same.blue, 0.9);
}

TEST(ColorVision, RedIsDarkToProtanopesAlone) {
    const design::LinearRgb red{1, 0, 0};
    EXPECT_NEAR(seen_with(ColorVision::protan, red).red, 0.152286, 1e-9) << "as published";
    EXPECT_EQ(seen_with(ColorVision::protan, red).blue, 0) << "cut at black";
    const auto lightness = [&red](ColorVision vision) { return lab_of(seen_with(vision, red)).lightness; };
    EXPECT_LT(lightness(ColorVision::protan), 0.8 * lightness(ColorVision::normal));
    EXPECT_GT(lightness(ColorVision::tritan), 0.9 * lightness(ColorVision::normal));
}

TEST(ColorVision, EachHasAName) {
    EXPECT_EQ(to_string(ColorVision::normal), std::string("normal vision"));
    EXPECT_EQ(to_string(ColorVision::deutan), std::string("deuteranopia"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_color_vision
