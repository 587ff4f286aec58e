#include "render_core/design/mean_color_difference.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "render_core/design/color_difference.hpp"

namespace tedavis::design::test_mean_color_difference {
namespace {

using Bytes = std::vector<std::uint8_t>;

double mean(const Bytes& first, const Bytes& second) {
    return mean_color_difference({first.data(), first.size()}, {second.data(), second.size()});
}

TEST(MeanColorDifference, IsTheMeanOfThePixels) {
    const Lab white = lab_of(linear_rgb({255, 255, 255})), black = lab_of(linear_rgb({0, 0, 0}));
    EXPECT_NEAR(color_difference(white, black), 100, 1e-6) << "known: black against white";
    EXPECT_NEAR(mean({255, 255, 255, 9, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 255}), 50, 1e-6);
    EXPECT_EQ(mean({1, 2, 3, 4}, {1, 2, 3, 200}), 0) << "alpha is not looked at";
    EXPECT_EQ(mean({}, {}), 0);
}

/// Pixels that repeat are not computed again: the sum is that of all.
TEST(MeanColorDifference, AgreesWithEveryPixelByItself) {
    std::mt19937 random(3);
    Bytes first, second;
    double sum = 0;
    constexpr int kPixels = 400;
    for (int n = 0; n < kPixels; ++n) {
        const auto a = static_cast<std::uint8_t>(random() % 3 * 80), b = static_cast<std::uint8_t>(random() % 2 * 60);
        first.insert(first.end(), {a, b, 10, 255});
        second.insert(second.end(), {b, a, 10, 255});
        sum += color_difference(lab_of(linear_rgb({a, b, 10})), lab_of(linear_rgb({b, a, 10})));
    }
    EXPECT_NEAR(mean(first, second), sum / kPixels, 1e-9);
}

}  // namespace
}  // namespace tedavis::design::test_mean_color_difference
