#include "render_core/draw/quad_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"

namespace tedavis::draw::test_quad_batch {
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

/// Quads of glyphs in `store`, each resized in the atlas: `box_of` says to which texels. Places follow, since both are affine.
template <class BoxOf>
void resize_glyphs(Store& store, BoxOf box_of) {
    const FontAtlas& atlas = font_atlas();
    for (std::size_t first = 0; first < store.batch.vertices().size(); first += 4) {
        QuadVertex* const corner = &store.vertex_store[first];  // 0 left top, 1 right top, 2 right bottom, 3 left bottom
        const QuadVertex drawn[4] = {corner[0], corner[1], corner[2], corner[3]};
        const auto width = static_cast<float>(atlas.width), height = static_cast<float>(atlas.height);
        const Rect from{drawn[0].u * width, drawn[0].v * height, (drawn[2].u - drawn[0].u) * width,
                        (drawn[2].v - drawn[0].v) * height};
        const Rect to = box_of(from);
        for (int n = 0; n < 4; ++n) {
            const float u = n == 1 || n == 2 ? to.right() : to.x, v = n >= 2 ? to.bottom() : to.y;
            const float a = (u - from.x) / from.width, b = (v - from.y) / from.height;
            corner[n].x = drawn[0].x + a * (drawn[1].x - drawn[0].x) + b * (drawn[3].x - drawn[0].x);
            corner[n].y = drawn[0].y + a * (drawn[1].y - drawn[0].y) + b * (drawn[3].y - drawn[0].y);
            corner[n].u = u / width;
            corner[n].v = v / height;
        }
    }
}

/// The box of the glyph that has the middle of a box of texels, as it was baked.
Rect baked_box(const Rect& texels) {
    const float u = texels.x + texels.width / 2, v = texels.y + texels.height / 2;
    for (const Glyph& glyph : font_atlas().glyphs) {
        const Rect box{static_cast<float>(glyph.u), static_cast<float>(glyph.v), static_cast<float>(glyph.width),
                       static_cast<float>(glyph.height)};
        if (box.contains(Point{u, v})) return box;
    }
    ADD_FAILURE() << "no glyph at " << u << ", " << v;
    return texels;
}

/// Largest difference of a channel over two pictures of the same size.
int largest_difference(const Picture& a, const Picture& b) {
    int largest = 0;
    for (std::size_t n = 0; n < a.rgb.size(); ++n) largest = std::max(largest, std::abs(a.rgb[n] - b.rgb[n]));
    return largest;
}

// A glyph's quad leaves out the part of the spread that its outline and halo do not reach: whole boxes draw the same.
TEST(QuadBatch, WholeGlyphBoxesDrawTheSamePixels) {
    std::vector<std::string> lines(1);  // every glyph of the typeface in UTF-8, twelve a line
    for (const Glyph& glyph : font_atlas().glyphs) {
        if (lines.back().size() >= 12) lines.emplace_back();
        const std::uint32_t c = glyph.code_point;
        if (c >= 0x800) lines.back() += {static_cast<char>(0xE0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3F))};
        if (c >= 0x80 && c < 0x800) lines.back() += static_cast<char>(0xC0 | c >> 6);
        lines.back() += static_cast<char>(c < 0x80 ? c : 0x80 | (c & 0x3F));
    }
    int trimmed = 0, cut_shows = 0;
    for (const float size : {9.0f, 17.3f, 26.0f, 48.0f})
        for (const float halo : {0.0f, 1.0f, 2.5f})
            for (const float angle : {0.0f, 0.7f})
                for (std::size_t n = 0; n < lines.size(); n += angle == 0.0f && halo == 1.0f ? 1 : 4) {
                    const int edge = static_cast<int>(12 * size);
                    const auto draw = [&](float texels, bool whole) {
                        Store store;
                        const TextStyle style{size, kWhite, halo, {200, 30, 60, 255}};
                        const auto middle = static_cast<float>(edge) / 2 + 0.3f;
                        EXPECT_TRUE(store.batch.text(lines[n], {middle, middle}, TextAnchor::center, style, angle));
                        resize_glyphs(store, [&](const Rect& box) { return whole ? baked_box(box) : box.shrunk(texels); });
                        Picture picture(edge, edge, kBlack);
                        rasterize(store.batch, picture);
                        return picture;
                    };
                    const Picture drawn = draw(0, false);
                    EXPECT_LE(largest_difference(drawn, draw(0, true)), 1)
                        << size << " " << halo << " " << angle << " " << lines[n];
                    cut_shows += largest_difference(drawn, draw(font_atlas().texels_per_em / size * 2, false)) > 20 ? 1 : 0;
                    Store plain;
                    plain.batch.text("M", {50, 50}, TextAnchor::left, {size, kWhite});
                    trimmed += plain.vertex_store[1].u - plain.vertex_store[0].u <
                                       (static_cast<float>(glyph_of('M').width) - 1) / static_cast<float>(font_atlas().width)
                                   ? 1
                                   : 0;
                }
    EXPECT_GT(trimmed, 10) << "nothing was left out";
    EXPECT_GT(cut_shows, 10) << "control: two pixels less on each side show";
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

TEST(QuadBatch, DistancesHoldUntilTheNextFrame) {
    Store store;
    store.batch.box({0, 0, 9, 9}, kWhite);
    store.batch.set_distance(500);
    store.batch.triangle({0, 0}, {9, 0}, {0, 9}, kWhite);
    store.batch.text("A", {50, 50}, TextAnchor::left, {16, kWhite, 0, kBlack});
    store.batch.set_distance(100, 900);
    store.batch.line({10, 10}, {90, 10}, 2, kWhite);
    const auto all = store.batch.vertices();
    for (std::size_t n = 0; n < all.size(); ++n) {
        const float expected = n < 4 ? 0 : n < 11 ? 500 : all[n].x < 50 ? 100 : 900;
        EXPECT_EQ(all[n].distance_m, expected) << n;
    }
    store.batch.clear();
    store.batch.box({0, 0, 9, 9}, kWhite);
    EXPECT_EQ(store.batch.vertices()[0].distance_m, 0);
}

TEST(QuadBatch, TextIsCutAtTheClipOnlyWhereThatIsAskedFor) {
    const TextStyle style{40, kWhite, 0, kBlack};
    const Rect window{0, 30, 100, 40};
    Store whole, left_out, cut, turned;
    whole.batch.text("8", {50, 36}, TextAnchor::center, style);
    left_out.batch.set_clip(window);
    left_out.batch.text("8", {50, 36}, TextAnchor::center, style);
    cut.batch.set_clip(window, ClippedText::cut);
    cut.batch.text("8", {50, 36}, TextAnchor::center, style);
    turned.batch.set_clip(window, ClippedText::cut);
    turned.batch.text("8", {50, 36}, TextAnchor::center, style, 0.3f);
    EXPECT_EQ(ink(left_out.batch), 0);
    EXPECT_EQ(ink(turned.batch), 0) << "a box that is turned cannot be cut";
    EXPECT_GT(ink(cut.batch), 0);
    EXPECT_LT(ink(cut.batch), 0.9 * ink(whole.batch));
    for (const QuadVertex& vertex : cut.batch.vertices()) EXPECT_GE(vertex.y, window.y);
    cut.batch.set_clip(window);
    cut.batch.text("8", {20, 36}, TextAnchor::center, style);
    EXPECT_EQ(cut.batch.vertices().size(), 4u) << "the next clip leaves texts out again";
}

}  // namespace
}  // namespace tedavis::draw::test_quad_batch
