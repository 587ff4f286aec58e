#include "render_core/perception/layer_saliency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/render_core/perception/held_saliency.hpp"

namespace tedavis::perception::test_layer_saliency {
namespace {

using test_support::HeldSaliency;
using test_support::Rgb;
using test_support::SyntheticPicture;

struct Layered {
    Layered(int width_, int height_, int layers_) : width(width_), height(height_), layers(pixels_of(width, height)) {
        for (std::size_t n = 0; n < layers.size(); ++n)
            layers[n] = static_cast<std::uint8_t>(test_support::scrambled(static_cast<std::uint32_t>(n / 3), 1, 4) %
                                                  static_cast<std::uint32_t>(layers_));
        const int level = saliency_level(width, height);
        map.width = level_side(width, level);
        map.height = level_side(height, level);
        map.level = level;
        for (int n = 0; n < map.width * map.height; ++n)
            values.push_back(static_cast<float>(test_support::scrambled(static_cast<std::uint32_t>(n), 2, 4) % 1000) / 999);
        map.values = {values.data(), values.size()};
    }
    [[nodiscard]] LayerSaliencies sums() const {
        LayerSaliencies out;
        EXPECT_TRUE(layer_saliency(map, {layers, width, height}, out));
        return out;
    }
    int width, height;
    std::vector<std::uint8_t> layers;
    std::vector<float> values;
    SaliencyMap map;
};

TEST(LayerSaliency, IsTheSumOverEachPixelsMapValue) {
    for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {130, 77}, {67, 40}}) {
        const Layered of(width, height, 5);
        const LayerSaliencies sums = of.sums();
        double all = 0, expected[16] = {}, most[16] = {};
        std::uint64_t pixels[16] = {};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t layer = of.layers[pixels_of(width, y) + static_cast<std::size_t>(x)];
                const double value =
                    of.values[pixels_of(of.map.width, y >> of.map.level) + static_cast<std::size_t>(x >> of.map.level)];
                expected[layer] += value;
                most[layer] = std::max(most[layer], value);
                ++pixels[layer];
                all += value;
            }
        for (std::size_t n = 0; n < kMaxLayers; ++n) {
            EXPECT_EQ(sums[n].pixels, pixels[n]);
            EXPECT_NEAR(sums[n].share, all > 0 ? expected[n] / all : 0, 1e-4);
            EXPECT_NEAR(sums[n].area, static_cast<double>(pixels[n]) / (width * height), 1e-12);
            EXPECT_NEAR(sums[n].mean, pixels[n] > 0 ? expected[n] / static_cast<double>(pixels[n]) : 0, 1e-5);
            EXPECT_NEAR(sums[n].most, most[n], 1e-5);
        }
    }
}

TEST(LayerSaliency, SharesAddUpToOne) {
    const LayerSaliencies sums = Layered(200, 100, 16).sums();
    double share = 0, area = 0;
    for (const LayerSaliency& layer : sums) {
        share += layer.share;
        area += layer.area;
    }
    EXPECT_NEAR(share, 1, 1e-12);
    EXPECT_NEAR(area, 1, 1e-12);
}

// In parts: each layer counted apart, the others as one.
TEST(LayerSaliency, PartsAddUpToTheWholeToTheLastStep) {
    Layered of(211, 97, 6);
    const LayerSaliencies whole = of.sums();
    const std::vector<std::uint8_t> layers = of.layers;
    for (std::uint8_t kept = 0; kept < 6; ++kept) {
        std::transform(layers.begin(), layers.end(), of.layers.begin(),
                       [kept](std::uint8_t layer) { return static_cast<std::uint8_t>(layer == kept ? 1 : 0); });
        EXPECT_EQ(of.sums()[1].saliency_65535ths, whole[kept].saliency_65535ths);
    }
}

TEST(LayerSaliency, HigherNumbersCountAsTheLast) {
    Layered of(64, 64, 4);
    std::fill(of.layers.begin(), of.layers.end(), 200);
    EXPECT_EQ(of.sums()[15].area, 1);
}

TEST(LayerSaliency, WhereNothingIsSalientSharesAreNothing) {
    Layered of(64, 64, 4);
    std::fill(of.values.begin(), of.values.end(), 0.0f);
    for (const LayerSaliency& layer : of.sums()) EXPECT_EQ(layer.share, 0);
}

TEST(LayerSaliency, WhatStandsOutHasAGreaterShareThanArea) {
    const SyntheticPicture picture(256, 192, [](int x, int y) {
        return x / 16 == 5 && y / 16 == 4 ? Rgb{250, 220, 0} : Rgb{60, 90, 60};
    });
    std::vector<std::uint8_t> layers;
    for (int y = 0; y < 192; ++y)
        for (int x = 0; x < 256; ++x) layers.push_back(x / 16 == 5 && y / 16 == 4 ? 3 : 0);
    HeldSaliency held(256, 192);
    ASSERT_TRUE(held.model.look(picture.view(), 0));
    LayerSaliencies sums;
    ASSERT_TRUE(layer_saliency(held.model.map(SaliencyScale::per_picture), {layers, 256, 192}, sums));
    EXPECT_GT(sums[3].share, 20 * sums[3].area);
    EXPECT_GT(sums[3].mean, 20 * sums[0].mean);
}

TEST(LayerSaliency, RefusesLayersOfAnotherPicture) {
    const Layered of(200, 100, 3);
    LayerSaliencies out;
    out[0].pixels = 77;
    EXPECT_FALSE(layer_saliency(of.map, {of.layers, 190, 100}, out));
    EXPECT_FALSE(layer_saliency(of.map, {of.layers, 0, 0}, out));
    EXPECT_FALSE(layer_saliency(of.map, {base::Span<const std::uint8_t>(of.layers).subspan(0, 100), 200, 100}, out));
    EXPECT_EQ(out[0].pixels, 77u);
}

}  // namespace
}  // namespace tedavis::perception::test_layer_saliency
