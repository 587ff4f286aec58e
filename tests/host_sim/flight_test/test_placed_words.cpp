#include "host_sim/flight_test/placed_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::host_sim::test_placed_words {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

class Words : public ::testing::Test {
protected:
    std::vector<std::string> texts() const {
        std::vector<std::string> all;
        for (const PlacedWords& words : placed_words(store_.batch, layout_)) all.push_back(words.text);
        return all;
    }
    void write(const char* text, draw::Point at, float halo_px = 0) {
        draw::TextStyle style;
        style.color = {255, 255, 255, 255};
        style.halo_px = halo_px;
        EXPECT_TRUE(store_.batch.text(text, at, draw::TextAnchor::left, style));
    }
    draw::Layout layout_ = draw::make_layout(640, 480, 96);
    test_support::BatchStore store_;
};

TEST_F(Words, AreReadBackAsTheyWereWritten) {
    write("TERRAIN AHEAD", {40, 100});
    write("123", {400, 200});
    write("-5 \u00b0C, i W .", {40, 300});
    EXPECT_THAT(texts(), ElementsAre("TERRAIN AHEAD", "123", "-5 \u00b0C, i W ."));
}

TEST_F(Words, AreReadBackFromATurnedText) {
    draw::TextStyle style;
    style.color = {255, 255, 255, 255};
    EXPECT_TRUE(store_.batch.text("AV 12", {40, 100}, draw::TextAnchor::left, style, 0.5f));
    EXPECT_THAT(texts(), ElementsAre("AV 12"));
}

TEST_F(Words, HaveTheGlyphsThatTheyWereWrittenWith) {
    write("A B", {40, 100}, 2);
    write("C", {200, 100});
    const auto words = placed_words(store_.batch, layout_);
    ASSERT_EQ(words.size(), 2u);
    ASSERT_EQ(words[0].glyphs.size(), 2u);
    EXPECT_EQ(words[0].glyphs[1].at, 2u) << "behind the blank";
    EXPECT_EQ(words[0].glyphs[1].halo_px, 2);
    ASSERT_EQ(words[1].glyphs.size(), 1u);
    EXPECT_EQ(words[1].glyphs[0].halo_px, 0) << "a text without a rim behind one with a rim";
    EXPECT_EQ(words[1].glyphs[0].color.green, 255);
    EXPECT_LT(words[1].glyphs[0].corner.x, words[1].x);
    EXPECT_GT(words[1].glyphs[0].right.x, words[1].x);
}

TEST_F(Words, AreFoundWhole) {
    EXPECT_THAT(places_of_words("AHEAD AND AHEAD", "AHEAD"), ElementsAre(0u, 10u));
    EXPECT_TRUE(has_words("TERRAIN AHEAD", "AHEAD"));
    EXPECT_TRUE(has_words("TERRAIN AHEAD", "TERRAIN AHEAD"));
    EXPECT_TRUE(has_words("AAHEAD AHEAD", "AHEAD"));
    EXPECT_FALSE(has_words("TERRAIN AHEAD", "HEAD"));
    EXPECT_FALSE(has_words("120", "2"));
    EXPECT_FALSE(has_words("TERRAIN", ""));
    EXPECT_EQ(with_single_blanks("  A   B "), "A B");
}

TEST_F(Words, WhatTheTypefaceLacksIsNamed) {
    EXPECT_EQ(unwritable_character("5 \u00b0C?"), "");
    EXPECT_EQ(unwritable_character("A\u4e2dB"), "\u4e2d");
}

TEST_F(Words, AHaloIsNoText) {
    write("PITCH", {40, 100}, 2);
    EXPECT_THAT(texts(), ElementsAre("PITCH"));
}

TEST_F(Words, OtherShapesAreNone) {
    static_cast<void>(store_.batch.box({10, 10, 50, 50}, {255, 0, 0, 255}));
    static_cast<void>(store_.batch.line({0, 0}, {100, 100}, 2, {255, 0, 0, 255}));
    EXPECT_THAT(texts(), ElementsAre());
}

TEST_F(Words, TheirBoxIsThatOfTheLayout) {
    const draw::Point top = layout_.annunciations.center(), left = layout_.airspeed.center();
    write("A", top);
    write("B", left);
    const auto words = placed_words(store_.batch, layout_);
    ASSERT_EQ(words.size(), 2u);
    EXPECT_THAT(words[0].boxes, Contains("annunciations"));
    EXPECT_THAT(words[0].boxes, Not(Contains("airspeed")));
    EXPECT_THAT(words[1].boxes, Contains("airspeed"));
}

TEST_F(Words, BoxesHaveNames) { EXPECT_THAT(layout_box_names(), Contains("annunciations")); }

}  // namespace
}  // namespace tedavis::host_sim::test_placed_words
