#include "host_sim/measure/perceptual_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_core/design/color_difference.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_perceptual_difference {
namespace {

constexpr std::uint32_t kWidth = 48, kHeight = 40;

struct Rgb {
    std::uint8_t red, green, blue;
};

template <class ColorAt>
RgbaPicture picture(ColorAt color_at) {
    RgbaPicture made{kWidth, kHeight, {}};
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const Rgb color = color_at(x, y);
            for (std::uint8_t byte : {color.red, color.green, color.blue, std::uint8_t{255}}) made.pixels.push_back(byte);
        }
    return made;
}

RgbaPicture flat(Rgb color) {
    return picture([&](std::uint32_t, std::uint32_t) { return color; });
}

PerceptualDifference difference(const RgbaPicture& a, const RgbaPicture& b, double pixels_per_degree = 67) {
    return perceptual_difference(view_of(a), view_of(b), {pixels_per_degree});
}

RgbaPicture with_column(std::uint32_t column, Rgb color) {
    return picture([&](std::uint32_t x, std::uint32_t) { return x == column ? color : Rgb{118, 118, 118}; });
}

TEST(PerceptualDifference, OfAPictureAndItselfIsNothing) {
    const RgbaPicture some = picture([](std::uint32_t x, std::uint32_t y) {
        return Rgb{static_cast<std::uint8_t>(x * 5), static_cast<std::uint8_t>(y * 6), 90};
    });
    const PerceptualDifference none = difference(some, some);
    EXPECT_EQ(none.mean, 0);
    EXPECT_EQ(none.map.size(), std::size_t{kWidth} * kHeight);
}

/// Flat pictures have no features, and blurring leaves them as they are: what remains is equation 3 of the paper over the two
/// colours.
double by_equation(Rgb first, Rgb second) {
    const auto hunt = [](Rgb c) {
        const design::Lab lab = design::lab_of(design::linear_rgb({c.red, c.green, c.blue}));
        return design::Lab{lab.lightness, lab.lightness * lab.a / 100, lab.lightness * lab.b / 100};
    };
    const auto distance = [&](Rgb a, Rgb b) {
        const design::Lab p = hunt(a), q = hunt(b);
        return std::pow(std::abs(p.lightness - q.lightness) + std::hypot(p.a - q.a, p.b - q.b), 0.7);
    };
    const double most = distance({0, 255, 0}, {0, 0, 255}), d = distance(first, second);
    return d < 0.4 * most ? 0.95 * d / (0.4 * most) : 0.95 + 0.05 * (d - 0.4 * most) / (0.6 * most);
}

TEST(PerceptualDifference, OfFlatColorsFollowsThePapersEquation) {
    const Rgb pairs[][2] = {
        {{0, 0, 0}, {255, 255, 255}}, {{0, 255, 0}, {0, 0, 255}}, {{120, 90, 60}, {125, 90, 60}}, {{200, 30, 30}, {30, 30, 30}}};
    for (const auto& pair : pairs)
        EXPECT_NEAR(difference(flat(pair[0]), flat(pair[1])).mean, by_equation(pair[0], pair[1]), 2e-3);
    EXPECT_NEAR(difference(flat({0, 255, 0}), flat({0, 0, 255})).mean, 1, 1e-3) << "the largest there is";
}

TEST(PerceptualDifference, DoesNotDependOnTheOrder) {
    const RgbaPicture a = with_column(20, {250, 250, 250}), b = with_column(23, {90, 40, 40});
    const PerceptualDifference one = difference(a, b), other = difference(b, a);
    for (std::size_t n = 0; n < one.map.size(); ++n) ASSERT_NEAR(one.map[n], other.map[n], 1e-12);
}

/// Black and white squares of one pixel against the grey with the same light: from far away nobody can tell them apart.
TEST(PerceptualDifference, OfAFinePatternFallsWithTheDistance) {
    const RgbaPicture grey = flat({188, 188, 188}), board = picture([](std::uint32_t x, std::uint32_t y) {
                                                        return (x + y) % 2 == 0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
                                                    });
    const auto middle = [&](double pixels_per_degree) {
        return difference(grey, board, pixels_per_degree).map[std::size_t{kHeight / 2} * kWidth + kWidth / 2];
    };
    EXPECT_LT(middle(67), 0.05);
    EXPECT_GT(middle(5), 0.5) << "control: close by it is coarse";
}

TEST(PerceptualDifference, CountsAMissingLineMoreThanAFlatChangeOfTheSameTone) {
    const RgbaPicture grey = flat({118, 118, 118}), line = with_column(24, {160, 160, 160}), brighter = flat({160, 160, 160});
    const std::size_t on_line = std::size_t{kHeight / 2} * kWidth + 24;
    // The eye's blur takes much of a line of one pixel, so its colour alone differs less than the flat tone.
    EXPECT_GT(difference(grey, line).map[on_line], 0.5 * difference(grey, brighter).map[on_line]);
    EXPECT_LT(difference(grey, line).map[on_line - 20], 1e-3) << "control: far from it nothing differs";
}

TEST(PerceptualDifference, RefusesOtherSizes) {
    RgbaPicture small = flat({0, 0, 0});
    small.height -= 1;
    small.pixels.resize(std::size_t{small.width} * small.height * 4);
    test_support::expect_user_error([&] { static_cast<void>(difference(flat({0, 0, 0}), small)); }, "different sizes");
}

}  // namespace
}  // namespace tedavis::host_sim::test_perceptual_difference
