#include "host_sim/evaluation/gaussian_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::host_sim::test_gaussian_window {
namespace {

ValueMap noise_map(int width, int height, std::uint32_t seed) {
    ValueMap map(width, height);
    for (std::size_t n = 0; n < map.values.size(); ++n)
        map.values[n] = test_support::scrambled(static_cast<std::uint32_t>(n), 3, seed) % 1000 / 1000.0;
    return map;
}

/// Sum over the pixels of a picture; `value` of column and row.
template <class Value>
double directly(const ValueMap& map, int x, int y, double sigma, int radius, const Value& value) {
    double sum = 0, weights = 0;
    for (int v = std::max(y - radius, 0); v <= std::min(y + radius, map.height - 1); ++v)
        for (int u = std::max(x - radius, 0); u <= std::min(x + radius, map.width - 1); ++u) {
            const double weight = std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * sigma * sigma));
            sum += weight * value(u, v);
            weights += weight;
        }
    return sum / weights;
}

TEST(GaussianWindow, AgreesWithDirectSums) {
    for (const auto& [width, height] : {std::pair{23, 11}, std::pair{4, 30}, std::pair{1, 1}}) {
        const ValueMap a = noise_map(width, height, 1), b = noise_map(width, height, 2);
        const GaussianWindow window(2, 5);
        const ValueMap mean_a = window.mean(a), mean_b = window.mean(b);
        const ValueMap covariance = window.covariance(a, b, mean_a, mean_b);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double mean = directly(a, x, y, 2, 5, [&](int u, int v) { return a.row(v)[u]; });
                const double other = directly(a, x, y, 2, 5, [&](int u, int v) { return b.row(v)[u]; });
                ASSERT_NEAR(mean_a.row(y)[x], mean, 1e-13);
                const double together =
                    directly(a, x, y, 2, 5, [&](int u, int v) { return (a.row(v)[u] - mean) * (b.row(v)[u] - other); });
                ASSERT_NEAR(covariance.row(y)[x], together, 1e-13);
            }
    }
}

TEST(GaussianWindow, KeepsWhatIsConstant) {
    ValueMap map(40, 9);
    std::fill(map.values.begin(), map.values.end(), 0.75);
    for (const double value : GaussianWindow(3, 6).mean(map).values) EXPECT_NEAR(value, 0.75, 1e-15);
}

}  // namespace
}  // namespace tedavis::host_sim::test_gaussian_window
