#include "render_core/perception/edge_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::perception::test_edge_rows {
namespace {

using test_support::noise_picture;
using test_support::SyntheticPicture;

template <class T>
struct Row {
    explicit Row(int width, T filled = T{}) : elements(row_elements(width), filled) {}
    T* at() { return elements.data() + kRowLead; }
    std::vector<T> elements;
};

/// A channel of a pixel, ends repeated.
int level(const SyntheticPicture& picture, int x, int y, int c) {
    return picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1))[static_cast<std::size_t>(c)];
}

struct Blurred {
    Blurred(const SyntheticPicture& picture, const GaussianWeights& weights) : row(picture.width) {
        std::vector<Row<std::uint16_t>> sums(static_cast<std::size_t>(picture.height), Row<std::uint16_t>(picture.width));
        for (int y = 0; y < picture.height; ++y) {
            Row<std::uint8_t> source(picture.width, 200);
            copy_colors(picture.view(), y, source.at());
            repeat_ends(source.at(), picture.width, weights.radius);
            blur_across(source.at(), sums[static_cast<std::size_t>(y)].at(), picture.width, weights);
        }
        BlurRows rows{};
        for (int k = 0; k <= 2 * weights.radius; ++k)
            rows[static_cast<std::size_t>(k)] =
                sums[static_cast<std::size_t>(std::clamp(kMiddle + k - weights.radius, 0, picture.height - 1))].at();
        blur_down(rows, row.at(), picture.width, weights);
    }
    static constexpr int kMiddle = 4;
    Row<std::uint8_t> row;
};

TEST(EdgeRows, ABlurIsTheWeightedSumRoundedOnce) {
    for (const int width : {1, 2, 15, 16, 17, 33}) {
        const SyntheticPicture picture = noise_picture(width, 9, 5);
        for (const double sigma : {0.0, 0.5, 1.0, 2.0, 3.0}) {
            const GaussianWeights weights = gaussian_weights(sigma);
            Blurred blurred(picture, weights);
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < kColors; ++c) {
                    int sum = 0;
                    for (int v = -weights.radius; v <= weights.radius; ++v)
                        for (int u = -weights.radius; u <= weights.radius; ++u)
                            sum += weights.at[static_cast<std::size_t>(std::abs(u))] *
                                   weights.at[static_cast<std::size_t>(std::abs(v))] *
                                   level(picture, x + u, Blurred::kMiddle + v, c);
                    ASSERT_EQ(blurred.row.at()[kColors * x + c], (sum + (1 << 15)) >> 16) << width << ' ' << sigma << ' ' << x;
                }
        }
    }
}

struct Slopes {
    explicit Slopes(int width) : across(width), down(width), squared(width) {}
    GradientRow row() { return {across.at(), down.at(), squared.at()}; }
    Row<std::int16_t> across, down;
    Row<std::int32_t> squared;
};

TEST(EdgeRows, TheGradientIsSobels) {
    for (const int width : {1, 2, 16, 21}) {
        const SyntheticPicture picture = noise_picture(width, 3, 8);
        std::vector<Row<std::uint8_t>> levels(3, Row<std::uint8_t>(width));
        for (int y = 0; y < 3; ++y) {
            copy_colors(picture.view(), y, levels[static_cast<std::size_t>(y)].at());
            repeat_ends(levels[static_cast<std::size_t>(y)].at(), width, 1);
        }
        Slopes slopes(width);
        std::vector<std::int16_t> sums(2 * row_elements(width));
        gradient({levels[0].at(), levels[1].at(), levels[2].at()}, sums.data(), width, slopes.row());
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < kColors; ++c) {
                const auto at = [&](int u, int v) { return level(picture, x + u, 1 + v, c); };
                const int across = at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
                const int down = at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
                const int i = kColors * x + c;
                ASSERT_EQ(slopes.across.at()[i], across);
                ASSERT_EQ(slopes.down.at()[i], down);
                ASSERT_EQ(slopes.squared.at()[i], across * across + down * down);
            }
        for (int i = 0; i < kColors; ++i) {
            EXPECT_EQ(slopes.squared.at()[-1 - i], 0);
            EXPECT_EQ(slopes.squared.at()[kColors * width + i], 0);
        }
    }
}

/// Red gradients of three rows of one width, all of the same direction.
struct Ridge {
    Ridge(std::vector<std::vector<int>> lengths, int across, int down) : slopes(3, Slopes(static_cast<int>(lengths[0].size()))) {
        width = static_cast<int>(lengths[0].size());
        for (std::size_t y = 0; y < 3; ++y)
            for (std::size_t x = 0; x < lengths[y].size(); ++x) {
                slopes[y].squared.at()[kColors * x] = lengths[y][x];
                slopes[y].across.at()[kColors * x] = static_cast<std::int16_t>(across);
                slopes[y].down.at()[kColors * x] = static_cast<std::int16_t>(down);
            }
    }
    std::vector<int> middle() {
        std::vector<std::uint8_t> edges(static_cast<std::size_t>(width), 99);
        thin({slopes[0].squared.at(), slopes[2].squared.at(), slopes[1].row()}, {10, 50}, width, edges.data());
        return {edges.begin(), edges.end()};
    }
    int width = 0;
    std::vector<Slopes> slopes;
};

TEST(EdgeRows, OnlyTheLargestAcrossAnEdgeRemains) {
    const std::vector<std::vector<int>> lengths = {{90, 20, 20}, {20, 40, 30}, {20, 20, 60}};
    EXPECT_EQ(Ridge(lengths, 100, 41).middle()[1], 0x01) << "neighbours to the left and right are smaller";
    EXPECT_EQ(Ridge(lengths, 100, 42).middle()[1], 0) << "one of the diagonal is larger";
    EXPECT_EQ(Ridge(lengths, 100, -42).middle()[1], 0x01) << "those of the other diagonal are not";
    EXPECT_EQ(Ridge(lengths, 41, 100).middle()[1], 0x01) << "nor those above and below";
    EXPECT_EQ(Ridge(lengths, 42, 100).middle()[1], 0);
    EXPECT_EQ(Ridge(lengths, -42, -100).middle()[1], 0) << "directions have no sign";
}

TEST(EdgeRows, ThresholdsMustBeExceeded) {
    EXPECT_EQ(Ridge({{0, 0, 0}, {0, 10, 0}, {0, 0, 0}}, 1, 0).middle()[1], 0);
    EXPECT_EQ(Ridge({{0, 0, 0}, {0, 11, 0}, {0, 0, 0}}, 1, 0).middle()[1], 0x01);
    EXPECT_EQ(Ridge({{0, 0, 0}, {0, 50, 0}, {0, 0, 0}}, 1, 0).middle()[1], 0x01);
    EXPECT_EQ(Ridge({{0, 0, 0}, {0, 51, 0}, {0, 0, 0}}, 1, 0).middle()[1], 0x10);
}

TEST(EdgeRows, OfTwoEqualOnesOneRemains) {
    EXPECT_EQ(Ridge({{0, 0, 0, 0}, {0, 60, 60, 0}, {0, 0, 0, 0}}, 1, 0).middle(), (std::vector<int>{0, 0x10, 0, 0}));
    EXPECT_EQ(Ridge({{0, 0}, {60, 60}, {60, 60}}, 0, 1).middle(), (std::vector<int>{0x10, 0x10}));
    EXPECT_EQ(Ridge({{60, 60}, {60, 60}, {0, 0}}, 0, 1).middle(), (std::vector<int>{0, 0}));
}

}  // namespace
}  // namespace tedavis::perception::test_edge_rows
