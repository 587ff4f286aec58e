#include "host_sim/flight_test/text_in_pixels.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::host_sim::test_text_in_pixels {
namespace {

constexpr int kWidth = 360, kHeight = 80;
constexpr design::Color kWhite{255, 255, 255, 255}, kAmber{255, 180, 0, 255}, kGround{90, 110, 70, 255};

/// The rasterizer of the tests draws what is looked at, not the code that looks.
class TextInPixels : public ::testing::Test {
protected:
    TextInPixels() { write(ground_, ""); }

    struct Written {
        std::string text = "TERRAIN AHEAD";
        float size_px = 18, halo_px = 0, angle_rad = 0;
        design::Color color = kWhite;
    };
    void write(test_support::BatchStore& store, const std::string& text) { write(store, text, Written()); }
    void write(test_support::BatchStore& store, const std::string& text, const Written& how) {
        draw::TextStyle style;
        style.size_px = how.size_px;
        style.color = how.color;
        style.halo_px = how.halo_px;
        EXPECT_TRUE(store.batch.text(text, {kWidth / 2.0f, kHeight / 2.0f}, draw::TextAnchor::center, style, how.angle_rad));
    }
    /// Over ground with stripes, so that nothing of it is even.
    static RgbaPicture picture_of(const draw::QuadBatch& batch) {
        test_support::Picture drawn(kWidth, kHeight, kGround);
        for (std::size_t n = 0; n < drawn.rgb.size(); ++n)
            drawn.rgb[n] = static_cast<std::uint8_t>(drawn.rgb[n] + (n / 3 % 5) * 9 + (n / 3 / kWidth) % 7 * 5);
        test_support::rasterize(batch, drawn);
        RgbaPicture picture{kWidth, kHeight, {}};
        for (std::size_t n = 0; n < drawn.rgb.size(); n += 3)
            picture.pixels.insert(picture.pixels.end(), {drawn.rgb[n], drawn.rgb[n + 1], drawn.rgb[n + 2], 255});
        return picture;
    }
    /// What the template of a text says of another picture; of its own where `drawn` is empty.
    double correlation(const Written& how, const std::function<void(test_support::BatchStore&)>& drawn = nullptr) {
        test_support::BatchStore store;
        write(store, how.text, how);
        const std::vector<PlacedWords> words = placed_words(store.batch, draw::make_layout(640, 480, 96));
        EXPECT_EQ(words.size(), 1u);
        test_support::BatchStore other;
        if (drawn) drawn(other);
        look_ = faintest_character(picture_of(drawn ? other.batch : store.batch), words.at(0), 0, how.text.size());
        return look_->correlation;
    }
    test_support::BatchStore ground_;
    std::optional<CharacterLook> look_;
};

TEST_F(TextInPixels, IsSeenInEverySizeWithAndWithoutARim) {
    for (const float size_px : {10.0f, 14.5f, 18.0f, 31.0f})
        for (const float halo_px : {0.0f, 1.0f, 2.5f})
            for (const float angle_rad : {0.0f, 0.3f}) {
                Written how;
                how.size_px = size_px;
                how.halo_px = halo_px;
                how.angle_rad = how.size_px > 20 ? 0.0f : angle_rad;
                EXPECT_GT(correlation(how), 0.9) << size_px << " px, rim " << halo_px << ", turned " << angle_rad;
            }
}

TEST_F(TextInPixels, DarkTextOnALightBoxIsSeen) {
    const Written how{"PITCH", 18, 0, 0, {0, 0, 0, 255}};
    EXPECT_GT(correlation(how,
                          [&](test_support::BatchStore& store) {
                              static_cast<void>(store.batch.box({0, 0, kWidth, kHeight}, kAmber));
                              write(store, how.text, how);
                          }),
              0.9);
}

/// The controls: the same place without the text, with another text as long, and with a text that is covered.
TEST_F(TextInPixels, WhatIsNotThereIsNotSeen) {
    const Written how;
    EXPECT_LT(correlation(how, [](test_support::BatchStore&) {}), kSeenCorrelation / 2);
    EXPECT_LT(correlation(how, [&](test_support::BatchStore& store) { write(store, "OBSTACLE NEAR", how); }),
              kSeenCorrelation / 2);
    EXPECT_LT(correlation(how,
                          [&](test_support::BatchStore& store) {
                              write(store, how.text, how);
                              static_cast<void>(store.batch.box({0, 0, kWidth, kHeight}, {40, 40, 40, 255}));
                          }),
              kSeenCorrelation / 2);
}

TEST_F(TextInPixels, OneCoveredCharacterIsNamed) {
    Written how;
    const double whole = correlation(how);
    EXPECT_GT(whole, 0.9);
    const double covered = correlation(how, [&](test_support::BatchStore& store) {
        write(store, how.text, how);
        const auto words = placed_words(store.batch, draw::make_layout(640, 480, 96));
        const WrittenGlyph& glyph = words.at(0).glyphs.at(8);  // "H" of "AHEAD"; the blank has none
        static_cast<void>(store.batch.box(
            {glyph.corner.x, glyph.corner.y, glyph.right.x - glyph.corner.x, glyph.down.y - glyph.corner.y}, {40, 40, 40, 255}));
    });
    EXPECT_LT(covered, kSeenCorrelation / 2);
    EXPECT_EQ(look_->at, 9u);
}

TEST_F(TextInPixels, AnotherCharacterIsNotTakenForIt) {
    const Written how{"ALT 1"};
    EXPECT_LT(correlation(how, [&](test_support::BatchStore& store) { write(store, "ALT 7", how); }), kSeenCorrelation);
    EXPECT_EQ(look_->at, 4u);
}

/// Of nearly the color of its ground nobody sees it, though its shape is there to the last bit.
TEST_F(TextInPixels, TextOfNearlyTheColorOfItsGroundIsNotSeen) {
    const Written how{"PITCH", 18, 0, 0, {200, 200, 200, 255}};
    const auto over = [&](int levels) {
        const auto ground = static_cast<std::uint8_t>(200 - levels);
        return correlation(how, [&](test_support::BatchStore& store) {
            static_cast<void>(store.batch.box({0, 0, kWidth, kHeight}, {ground, ground, ground, 255}));
            write(store, how.text, how);
        });
    };
    for (const int levels : {0, 1, 2, 5}) EXPECT_LT(over(levels), 0.01) << levels << " levels darker";
    EXPECT_GT(over(40), 0.9);
}

TEST_F(TextInPixels, OnlyTheAskedWordCounts) {
    test_support::BatchStore store;
    write(store, "TERRAIN AHEAD");
    const auto words = placed_words(store.batch, draw::make_layout(640, 480, 96));
    const WrittenGlyph& first = words.at(0).glyphs.at(0);
    static_cast<void>(store.batch.box({first.corner.x, 0, first.right.x - first.corner.x, kHeight}, {40, 40, 40, 255}));
    const RgbaPicture picture = picture_of(store.batch);
    EXPECT_LT(faintest_character(picture, words.at(0), 0, 7)->correlation, kSeenCorrelation);
    EXPECT_GT(faintest_character(picture, words.at(0), 8, 13)->correlation, 0.9);
    EXPECT_FALSE(faintest_character(picture, words.at(0), 7, 8)) << "a blank has no pixels";
}

TEST_F(TextInPixels, BeyondThePictureNothingIsSeen) {
    test_support::BatchStore store;
    EXPECT_TRUE(store.batch.text("A", {-40, 20}, draw::TextAnchor::center, draw::TextStyle()));
    const auto words = placed_words(store.batch, draw::make_layout(640, 480, 96));
    EXPECT_EQ(faintest_character(picture_of(store.batch), words.at(0), 0, 1)->correlation, 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_text_in_pixels
