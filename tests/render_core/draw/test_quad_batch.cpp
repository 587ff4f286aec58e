#include "render_core/draw/quad_batch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "tests/support/batch_rasterizer.hpp"

namespace tedavis::draw {
namespace {

using test_support::Picture;
using test_support::rasterize;

constexpr design::Color kWhite{255, 255, 255};
constexpr design::Color kBlack{0, 0, 0};

struct Store {
    explicit Store(std::size_t vertices = 4000)
        : vertex_store(vertices),
          index_store(vertices * 3 / 2),
          batch({vertex_store.data(), vertex_store.size()}, {index_store.data(), index_store.size()}) {}
    std::vector<QuadVertex> vertex_store;
    std::vector<std::uint16_t> index_store;
    QuadBatch batch;
};

/// Sum of the coverage over the picture, pixels.
double ink(const QuadBatch& batch, int width = 100, int height = 100) {
    Picture picture(width, height, kBlack);
    rasterize(batch, picture);
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) sum += picture.rgb[i] / 255.0;
    return sum;
}

TEST(QuadBatch, LinesCoverTheirAreaAtAnyAngle) {
    for (double angle = 0; angle < 3.2; angle += 0.37)
        for (float width : {1.5f, 2.0f, 5.0f}) {
            Store store;
            const Point half{static_cast<float>(30 * std::cos(angle)), static_cast<float>(30 * std::sin(angle))};
            EXPECT_TRUE(store.batch.line({50.3f - half.x, 50.1f - half.y}, {50.3f + half.x, 50.1f + half.y}, width, kWhite));
            EXPECT_NEAR(ink(store.batch), 60.0 * width, 60.0 * width * 0.06) << angle << " " << width;
        }
}

TEST(QuadBatch, ABoxOnPixelBordersIsExact) {
    Store store;
    store.batch.box({10, 20, 30, 40}, kWhite);
    Picture picture(60, 70, kBlack);
    rasterize(store.batch, picture);
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 60; ++x)
            EXPECT_EQ(picture.at(x, y), x >= 10 && x < 40 && y >= 20 && y < 60 ? kWhite : kBlack) << x << " " << y;
}

TEST(QuadBatch, FramesLieInsideTheirBox) {
    Store store;
    store.batch.frame({10, 10, 50, 30}, 3, kWhite);
    EXPECT_NEAR(ink(store.batch), 50 * 30 - 44 * 24, 2);
    Picture picture(80, 60, kBlack);
    rasterize(store.batch, picture);
    EXPECT_EQ(picture.at(8, 20), kBlack);
    EXPECT_EQ(picture.at(10, 10), kWhite);  // the corner is closed
    EXPECT_EQ(picture.at(35, 25), kBlack);
}

TEST(QuadBatch, RefusesWholeShapesWhenFullAndCountsThem) {
    Store store(9);  // two quads and one vertex
    EXPECT_TRUE(store.batch.line({0, 0}, {9, 9}, 1, kWhite));
    EXPECT_TRUE(store.batch.line({0, 0}, {9, 9}, 1, kWhite));
    EXPECT_FALSE(store.batch.line({0, 0}, {9, 9}, 1, kWhite));
    EXPECT_FALSE(store.batch.triangle({0, 0}, {9, 9}, {0, 9}, kWhite));
    EXPECT_FALSE(store.batch.text("AB", {0, 0}, TextAnchor::left, {}));
    EXPECT_EQ(store.batch.use().refused, 4u);
    EXPECT_EQ(store.batch.vertices().size(), 8u);
    EXPECT_EQ(store.batch.indices().size(), 12u);
    store.batch.clear();
    EXPECT_EQ(store.batch.use().in_use, 0u);
    EXPECT_EQ(store.batch.use().high_water, 8u);
    EXPECT_TRUE(store.batch.triangle({0, 0}, {9, 9}, {0, 9}, kWhite));
}

TEST(QuadBatch, IndicesNeverLeaveSixteenBits) {
    Store store(70'000);
    while (store.batch.line({0, 0}, {1, 1}, 1, kWhite)) {
    }
    EXPECT_EQ(store.batch.vertices().size(), 65'536u);
    EXPECT_EQ(store.batch.indices()[store.batch.indices().size() - 1], 65'535u);
}

TEST(QuadBatch, TheClipCutsEverything) {
    const Rect clip{30, 30, 20, 20};
    Store store;
    store.batch.set_clip(clip);
    store.batch.line({0, 0}, {99, 99}, 3, kWhite);
    store.batch.line({40, 0}, {40, 99}, 3, kWhite);
    store.batch.line({0, 10}, {99, 10}, 3, kWhite);  // wholly outside
    store.batch.box({0, 45, 99, 99}, kWhite);
    store.batch.text("MMMMMMMM", {0, 40}, TextAnchor::left, {18, kWhite});
    store.batch.text("MMMMMMMM", {20, 20}, TextAnchor::left, {18, kWhite}, 0.5f);
    store.batch.triangle({40, 40}, {90, 40}, {40, 45}, kWhite);
    Picture picture(100, 100, kBlack);
    rasterize(store.batch, picture);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool inside = clip.contains(Point{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
            EXPECT_TRUE(inside || picture.at(x, y) == kBlack) << x << " " << y;
        }
    EXPECT_EQ(picture.at(40, 33), kWhite);
    store.batch.clear();
    store.batch.box({0, 0, 10, 10}, kWhite);  // clear lifts the clip
    EXPECT_NEAR(ink(store.batch), 100, 1e-6);
}

TEST(QuadBatch, TextStandsAroundItsAnchor) {
    for (TextAnchor anchor : {TextAnchor::left, TextAnchor::center, TextAnchor::right}) {
        Store store;
        store.batch.text("HHH", {60, 50}, anchor, {20, kWhite});
        Picture picture(120, 100, kBlack);
        rasterize(store.batch, picture);
        int left = 120, right = -1, top = 100, bottom = -1;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 120; ++x)
                if (picture.at(x, y).red > 127)
                    left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
        const double width = static_cast<double>(text_width_px("HHH", 20));
        const double expected_left = 60 - (anchor == TextAnchor::left ? 0 : anchor == TextAnchor::center ? width / 2 : width);
        EXPECT_NEAR(left, expected_left, 3);
        EXPECT_NEAR(right + 1, expected_left + width, 3);
        EXPECT_NEAR((top + bottom + 1) / 2.0, 50, 1.0);
        EXPECT_NEAR(bottom + 1 - top, static_cast<double>(font_atlas().cap_height_em) * 20, 1.5);
    }
}

TEST(QuadBatch, TurnedTextHasTheSameInk) {
    double upright = 0;
    for (float angle : {0.0f, 0.4f, 1.5707964f, 3.0f}) {
        Store store;
        store.batch.text("KT 120", {60, 60}, TextAnchor::center, {18, kWhite}, angle);
        const double sum = ink(store.batch, 120, 120);
        if (angle == 0.0f) upright = sum;
        EXPECT_NEAR(sum, upright, upright * 0.03);
    }
    EXPECT_GT(upright, 200);
}

TEST(QuadBatch, HalosSurroundTheGlyphs) {
    Store plain, rimmed;
    plain.batch.text("8", {50, 50}, TextAnchor::center, {40, kWhite});
    TextStyle style{40, kWhite, 2, kWhite};
    rimmed.batch.text("8", {50, 50}, TextAnchor::center, style);
    EXPECT_GT(ink(rimmed.batch), ink(plain.batch) * 1.2);
}

TEST(QuadBatch, NotANumberDrawsNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    Store store;
    for (float bad : {nan, infinity}) {
        EXPECT_TRUE(store.batch.line({bad, 0}, {1, 1}, 1, kWhite));
        EXPECT_TRUE(store.batch.triangle({0, 0}, {1, bad}, {1, 1}, kWhite));
        EXPECT_TRUE(store.batch.text("1", {bad, 0}, TextAnchor::left, {}));
        EXPECT_TRUE(store.batch.text("1", {0, 0}, TextAnchor::left, {}, bad));
    }
    EXPECT_TRUE(store.batch.box({nan, 0, 1, 1}, kWhite));
    EXPECT_TRUE(store.batch.line({0, 0}, {1, 1}, nan, kWhite));
    EXPECT_TRUE(store.batch.vertices().empty());
}

TEST(QuadBatch, GlyphsAndLargeBoxesBeginRunsInTheOrderOfCovering) {
    Store made(128);
    QuadBatch& batch = made.batch;
    EXPECT_EQ(batch.runs().size(), 0u);
    batch.line({0, 0}, {300, 0}, 2, kWhite);
    batch.box({0, 0, 100, 100}, kWhite);
    batch.text("12", {20, 20}, TextAnchor::left, {});
    batch.line({0, 0}, {10, 10}, 2, kWhite);  // not worth another program
    batch.text("3", {20, 40}, TextAnchor::left, {});
    batch.box({100, 0, 100, 100}, kWhite);
    batch.box({0, 0, 10, 10}, kWhite);
    const base::Span<const QuadRun> runs = batch.runs();
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(runs[0].first_index, 0u);
    EXPECT_FALSE(runs[0].glyphs);
    EXPECT_EQ(runs[1].first_index, 12u);
    EXPECT_TRUE(runs[1].glyphs);
    EXPECT_EQ(runs[2].first_index, 36u);
    EXPECT_FALSE(runs[2].glyphs);
    batch.clear();
    EXPECT_EQ(batch.runs().size(), 0u);
}

TEST(QuadBatch, MoreRunsThanThereIsRoomForAreRefused) {
    Store made(8 * kMaxQuadRuns);
    for (std::size_t n = 0; n < kMaxQuadRuns / 2; ++n) {
        EXPECT_TRUE(made.batch.box({0, 0, 100, 100}, kWhite));
        EXPECT_TRUE(made.batch.text("1", {10, 10}, TextAnchor::left, {}));
    }
    EXPECT_TRUE(made.batch.box({0, 0, 10, 10}, kWhite));
    EXPECT_FALSE(made.batch.box({0, 0, 100, 100}, kWhite));
    EXPECT_EQ(made.batch.use().refused, 1u);
}

}  // namespace
}  // namespace tedavis::draw
