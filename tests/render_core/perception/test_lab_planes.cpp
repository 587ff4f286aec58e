#include "render_core/perception/lab_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render_core/design/color_difference.hpp"
#include "tests/render_core/perception/held_plane.hpp"

namespace tedavis::perception::test_lab_planes {
namespace {

using test_support::HeldPlane;
using test_support::Rgb;
using test_support::SyntheticPicture;

struct Converted {
    Converted(const SyntheticPicture& picture, int level)
        : lightness(level_side(picture.width, level), level_side(picture.height, level)),
          a(lightness.plane.width, lightness.plane.height),
          b(lightness.plane.width, lightness.plane.height) {
        std::vector<unsigned char> block(LabConversion::bytes(picture.width));
        base::Arena arena(block.data(), block.size());
        LabConversion conversion;
        EXPECT_TRUE(conversion.start(arena, picture.width));
        conversion.convert(picture.view(), level, {lightness.plane, a.plane, b.plane});
    }
    HeldPlane lightness, a, b;
};

/// Levels may lie between whole ones.
design::Lab lab_of_levels(double red, double green, double blue) {
    const auto light = [](double level) {
        const double share = level / 255;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return design::lab_of({light(red), light(green), light(blue)});
}

constexpr double kBound = 1e-4;  // a hundredth of a unit

TEST(LabPlanes, AreTheExactFormulasWithinTheirBound) {
    const SyntheticPicture colors(256, 86, [](int x, int y) {
        return Rgb{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(3 * y), static_cast<std::uint8_t>(x * 7 + y * 31)};
    });
    Converted of(colors, 0);
    for (std::size_t n = 0; n < of.lightness.values.size(); ++n) {
        const std::uint8_t* levels = colors.pixels.data() + 3 * n;
        const design::Lab lab = lab_of_levels(levels[0], levels[1], levels[2]);
        ASSERT_NEAR(of.lightness.values[n], lab.lightness / 100, kBound);
        ASSERT_NEAR(of.a.values[n], lab.a / 100, kBound);
        ASSERT_NEAR(of.b.values[n], lab.b / 100, kBound);
    }
}

TEST(LabPlanes, WhiteAndBlackAreTheEndsOfTheScale) {
    const SyntheticPicture two(2, 1, [](int x, int) { return x == 0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255}; });
    Converted of(two, 0);
    EXPECT_NEAR(of.lightness.values[0], 0, 1e-6);
    EXPECT_NEAR(of.lightness.values[1], 1, 1e-6);
    for (const float value : {of.a.values[0], of.a.values[1], of.b.values[0], of.b.values[1]}) EXPECT_NEAR(value, 0, 1e-5);
}

TEST(LabPlanes, SmallerOnesAreOfMeanLevelsWithTheBorderRepeated) {
    const SyntheticPicture picture = test_support::noise_picture(11, 7, 3);
    for (const int level : {1, 2}) {
        Converted of(picture, level);
        const int block = 1 << level;
        for (int y = 0; y < of.lightness.plane.height; ++y)
            for (int x = 0; x < of.lightness.plane.width; ++x) {
                double sums[3] = {};
                for (int v = 0; v < block; ++v)
                    for (int u = 0; u < block; ++u)
                        for (std::size_t c = 0; c < 3; ++c)
                            sums[c] += picture.at(std::min(block * x + u, 10), std::min(block * y + v, 6))[c];
                for (double& sum : sums) sum /= block * block;
                const design::Lab lab = lab_of_levels(sums[0], sums[1], sums[2]);
                EXPECT_NEAR(of.lightness.plane.row(y)[x], lab.lightness / 100, kBound) << level << ' ' << x << ' ' << y;
                EXPECT_NEAR(of.a.plane.row(y)[x], lab.a / 100, kBound);
                EXPECT_NEAR(of.b.plane.row(y)[x], lab.b / 100, kBound);
            }
    }
}

TEST(LabPlanes, RefusesWithoutRoom) {
    std::vector<unsigned char> block(LabConversion::bytes(100) - 200);
    base::Arena arena(block.data(), block.size());
    LabConversion conversion;
    EXPECT_FALSE(conversion.start(arena, 100));
}

}  // namespace
}  // namespace tedavis::perception::test_lab_planes
