#include "render_core/draw/data/polyline_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

namespace tedavis::draw::test_polyline_weights {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<float> weights_of(const std::vector<PolylineVertex>& way) {
    std::vector<float> weights(way.size());
    std::vector<PolylineStretch> waiting(way.size());
    weigh_vertices({way.data(), way.size()}, {weights.data(), weights.size()}, {waiting.data(), waiting.size()});
    return weights;
}

std::vector<PolylineVertex> wandering(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::normal_distribution<double> step(0, 30);
    std::vector<PolylineVertex> way(count);
    glm::dvec3 place(0);
    for (PolylineVertex& point : way) {
        place += glm::dvec3(80 + step(random), step(random), 0.3 * step(random));
        point.place = place;
        point.values = {{step(random), kNone, 0}};
    }
    return way;
}

/// The method as it was published.
void split(const std::vector<PolylineVertex>& way, std::size_t first, std::size_t last, double tolerance_m,
           std::vector<bool>& kept) {
    kept[first] = kept[last] = true;
    std::size_t farthest = first;
    double distance_m = tolerance_m;
    for (std::size_t n = first + 1; n < last; ++n)
        if (const double d = distance_from_segment(way[n], way[first], way[last]); d > distance_m) {
            distance_m = d;
            farthest = n;
        }
    if (farthest == first) return;
    split(way, first, farthest, tolerance_m, kept);
    split(way, farthest, last, tolerance_m, kept);
}

TEST(PolylineWeights, KeepsWhatTheMethodKeepsAtEveryTolerance) {
    for (unsigned seed = 1; seed < 20; ++seed) {
        const std::vector<PolylineVertex> way = wandering(seed, 200);
        const std::vector<float> weights = weights_of(way);
        for (const double tolerance_m : {1.5, 12.25, 40.0, 130.0}) {
            std::vector<bool> expected(way.size()), kept(way.size());
            split(way, 0, way.size() - 1, tolerance_m, expected);
            for (std::size_t n = 0; n < way.size(); ++n) kept[n] = static_cast<double>(weights[n]) > tolerance_m;
            EXPECT_EQ(kept, expected) << "seed " << seed << ", " << tolerance_m << " m";
            EXPECT_LT(std::count(kept.begin(), kept.end(), true), tolerance_m < 100 ? 201 : 100);
        }
    }
}

TEST(PolylineWeights, NothingLeftOutIsFartherThanTheTolerance) {
    const std::vector<PolylineVertex> way = wandering(7, 512);
    const std::vector<float> weights = weights_of(way);
    constexpr double kTolerance_m = 25;
    std::size_t from = 0;
    for (std::size_t to = 1; to < way.size(); ++to) {
        if (!(static_cast<double>(weights[to]) > kTolerance_m)) continue;
        for (std::size_t n = from + 1; n < to; ++n)
            EXPECT_LE(distance_from_segment(way[n], way[from], way[to]), kTolerance_m + 1e-3);
        from = to;
    }
    EXPECT_EQ(from, way.size() - 1) << "the last one is kept";
}

TEST(PolylineWeights, DistancesAreFromTheStretchNotFromItsLine) {
    const PolylineVertex from{{0, 0, 0}, {{0, 0, 0}}}, to{{100, 0, 0}, {{10, 0, kNone}}};
    EXPECT_DOUBLE_EQ(distance_from_segment({{50, 3, 4}, {{5, 0, 0}}}, from, to), 5);
    EXPECT_DOUBLE_EQ(distance_from_segment({{160, 0, 0}, {{10, 0, 0}}}, from, to), 60) << "beyond its end";
    EXPECT_DOUBLE_EQ(distance_from_segment({{50, 1, 0}, {{5, 7, 0}}}, from, to), 7) << "a value off its line";
    EXPECT_DOUBLE_EQ(distance_from_segment({{50, 1, 0}, {{5, kNone, 1e6}}}, from, to), 1) << "values that are none";
    EXPECT_DOUBLE_EQ(distance_from_segment({{0, 2, 0}, {{0, 0, 0}}}, from, {from.place, {{0, 0, 0}}}), 2) << "a way of no length";
}

TEST(PolylineWeights, ShortWaysAreTheirEnds) {
    EXPECT_TRUE(weights_of({}).empty());
    for (std::size_t count = 1; count < 3; ++count)
        for (const float weight : weights_of(wandering(3, count))) EXPECT_TRUE(std::isinf(weight));
    const std::vector<PolylineVertex> still(20);
    const std::vector<float> weights = weights_of(still);
    EXPECT_EQ(std::count(weights.begin(), weights.end(), 0.0f), 18) << "of equal points none matters";
}

}  // namespace
}  // namespace tedavis::draw::test_polyline_weights
