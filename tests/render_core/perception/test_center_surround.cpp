#include "render_core/perception/center_surround.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/render_core/perception/held_plane.hpp"

namespace tedavis::perception::test_center_surround {
namespace {

using test_support::Field;
using test_support::HeldPlane;
using test_support::noise_plane;

/// Levels of one plane, each by chance: they need not belong together.
struct Levels {
    Levels(int width, int height) {
        for (int n = 0; n < kFeatureLevels; ++n) {
            held.push_back(noise_plane(level_side(width, n), level_side(height, n), static_cast<std::uint32_t>(n + 1)));
            fields.push_back(held.back().field());
        }
        for (std::size_t n = 0; n < kFeatureLevels; ++n) pyramid[n] = held[n].plane;
        for (int n = 0; n < kCenters; ++n) {
            above_held.emplace_back(level_side(width, n), level_side(height, n));
            below_held.emplace_back(level_side(width, n), level_side(height, n));
        }
        for (std::size_t n = 0; n < kCenters; ++n) {
            above[n] = above_held[n].plane;
            below[n] = below_held[n].plane;
        }
        scratch.resize(center_surround_scratch(width));
    }
    /// Of the whole formula, by recursion over centres.
    template <class Part>
    [[nodiscard]] double expected(int x, int y, const Part& part) const {
        Field sum(1, 1);
        for (int center = 2; center >= 0; --center) {
            const Field& fine = fields[static_cast<std::size_t>(center)];
            Field here(fine.width, fine.height);
            for (int v = 0; v < fine.height; ++v)
                for (int u = 0; u < fine.width; ++u) {
                    for (const double scale : {8.0, 16.0}) {
                        const std::size_t level = static_cast<std::size_t>(center) + (scale == 8.0 ? 3 : 4);
                        here.at(u, v) += part(fine(u, v) - fields[level].between((u + 0.5) / scale, (v + 0.5) / scale)) / 6;
                    }
                    if (center < 2) here.at(u, v) += sum.between((u + 0.5) / 2, (v + 0.5) / 2);
                }
            sum = here;
        }
        return sum(x, y);
    }
    std::vector<HeldPlane> held, above_held, below_held;
    std::vector<Field> fields;
    FeaturePyramid pyramid;
    CenterPlanes above, below;
    std::vector<float> scratch;
};

TEST(CenterSurround, IsTheMeanDifferenceOverPairsOfScales) {
    Levels levels(37, 21);
    signed_differences(levels.pyramid, levels.above, levels.below, levels.scratch);
    for (const auto& [x, y] : {std::pair{0, 0}, {36, 20}, {18, 7}, {3, 19}}) {
        EXPECT_NEAR(levels.above[0].row(y)[x], levels.expected(x, y, [](double d) { return std::max(d, 0.0); }), 1e-6);
        EXPECT_NEAR(levels.below[0].row(y)[x], levels.expected(x, y, [](double d) { return std::max(-d, 0.0); }), 1e-6);
    }
    differences(levels.pyramid, levels.above, levels.scratch);
    for (const auto& [x, y] : {std::pair{0, 0}, {36, 20}, {18, 7}, {3, 19}})
        EXPECT_NEAR(levels.above[0].row(y)[x], levels.expected(x, y, [](double d) { return std::fabs(d); }), 1e-6);
}

TEST(CenterSurround, SignsAddUpToTheWhole) {
    Levels levels(16, 48), again(16, 48);
    signed_differences(levels.pyramid, levels.above, levels.below, levels.scratch);
    differences(again.pyramid, again.above, again.scratch);
    for (std::size_t n = 0; n < levels.above[0].size(); ++n)
        EXPECT_NEAR(levels.above[0].values[n] + levels.below[0].values[n], again.above[0].values[n], 1e-6);
}

TEST(CenterSurround, EqualLevelsDifferNowhere) {
    Levels levels(20, 20);
    for (HeldPlane& held : levels.held) std::fill(held.values.begin(), held.values.end(), 0.7f);
    signed_differences(levels.pyramid, levels.above, levels.below, levels.scratch);
    for (std::size_t n = 0; n < levels.above[0].size(); ++n) {
        EXPECT_EQ(levels.above[0].values[n], 0);
        EXPECT_EQ(levels.below[0].values[n], 0);
    }
}

}  // namespace
}  // namespace tedavis::perception::test_center_surround
