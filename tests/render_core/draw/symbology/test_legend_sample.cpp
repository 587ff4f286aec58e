#include "render_core/draw/symbology/legend_sample.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "render_core/draw/symbology/painter.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_legend_sample {
namespace {

using design::Color;
using test_support::BatchStore;
using test_support::Picture;

constexpr Color kData{200, 120, 40}, kUnder{40, 60, 200};
constexpr Rect kBox{10, 10, 60, 32};

Picture drawn(SampleLook look, double share) {
    const Layout layout = make_layout(640, 480, 96);
    BatchStore store;
    LegendSample sample;
    sample.color = kData;
    sample.under = kUnder;
    sample.look = look;
    sample.share = share;
    build_sample(Painter(store.batch, layout), sample, kBox);
    EXPECT_EQ(store.batch.use().refused, 0u);
    Picture picture(80, 52, {0, 0, 0});
    rasterize(store.batch, picture);
    return picture;
}

/// Of the pixels inside the frame those that are nearer to what shows through, or to any other colour, than to the data's.
double changed_share(SampleLook look, double share) {
    const Picture picture = drawn(look, share);
    int changed = 0, all = 0;
    for (int y = 14; y < 38; ++y)
        for (int x = 14; x < 66; ++x, ++all)
            changed += 2 * std::abs(picture.at(x, y).red - kData.red) > std::abs(kData.red - kUnder.red) ? 1 : 0;
    return static_cast<double>(changed) / all;
}

TEST(LegendSample, PlainIsPlainAndEveryPatternIsSeen) {
    EXPECT_EQ(changed_share(SampleLook::plain, 1), 0);
    for (const SampleLook look :
         {SampleLook::cut_stripes, SampleLook::cut_grid, SampleLook::dots, SampleLook::grains, SampleLook::strokes,
          SampleLook::rough, SampleLook::washed, SampleLook::mesh, SampleLook::rim}) {
        const Picture picture = drawn(look, 0.6);
        int kept = 0, all = 0;
        for (int y = 14; y < 38; ++y)
            for (int x = 14; x < 66; ++x, ++all) kept += picture.at(x, y) == kData ? 1 : 0;
        EXPECT_LT(kept, 0.98 * all) << static_cast<int>(look);
        EXPECT_GT(kept, 0.05 * all) << static_cast<int>(look);
    }
}

TEST(LegendSample, WhatIsTakenAwayFollowsTheShare) {
    for (const SampleLook look : {SampleLook::grains, SampleLook::strokes}) {
        EXPECT_NEAR(changed_share(look, 0.5), 0.5, 0.15) << static_cast<int>(look);
        EXPECT_LT(changed_share(look, 0.2), changed_share(look, 0.6)) << static_cast<int>(look);
    }
    EXPECT_GT(changed_share(SampleLook::mesh, 0), changed_share(SampleLook::mesh, 1)) << "a wide mesh has fewer lines";
    EXPECT_NEAR(changed_share(SampleLook::cut_stripes, 0), 1 / 3.0, 0.12) << "a third, as on the ground";
}

TEST(LegendSample, NothingIsDrawnBesideTheBox) {
    for (const SampleLook look : {SampleLook::plain, SampleLook::cut_stripes, SampleLook::grains, SampleLook::strokes,
                                  SampleLook::mesh, SampleLook::washed, SampleLook::rough}) {
        const Picture picture = drawn(look, 0.7);
        for (int y = 0; y < 52; ++y)
            for (int x = 0; x < 80; ++x)
                if (!kBox.shrunk(-1.5f).contains(Point{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f})) {
                    ASSERT_EQ(picture.at(x, y), (Color{0, 0, 0})) << static_cast<int>(look) << ": " << x << ", " << y;
                }
    }
}

}  // namespace
}  // namespace tedavis::draw::test_legend_sample
