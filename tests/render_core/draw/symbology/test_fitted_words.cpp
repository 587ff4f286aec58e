#include "render_core/draw/symbology/fitted_words.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw::test_fitted_words {
namespace {

std::string cut(const char* text, float room) { return std::string(cut_words(text, room, 11).view()); }

TEST(FittedWords, WhatFitsStaysAsItIs) {
    EXPECT_EQ(cut("GROUND ELEV", text_width_px("GROUND ELEV", 11)), "GROUND ELEV");
    EXPECT_EQ(cut("", 0), "");
}

TEST(FittedWords, OfTheOthersTheFirstLettersAreKept) {
    for (float room = 20; room < text_width_px("GROUND ELEV", 11); room += 1) {
        const std::string kept = cut("GROUND ELEV", room);
        EXPECT_LE(text_width_px(kept, 11), room);
        EXPECT_EQ(kept.substr(kept.size() - 2), "..");
        EXPECT_EQ(std::string("GROUND ELEV").substr(0, kept.size() - 2), kept.substr(0, kept.size() - 2));
        EXPECT_NE(kept[kept.size() - 3], ' ') << "no blank before the dots";
    }
    EXPECT_GT(cut("GROUND ELEV", 60).size(), cut("GROUND ELEV", 40).size());
}

TEST(FittedWords, ANumberIsNeverAnotherNumber) {
    EXPECT_EQ(cut("12500", 10), "12500");
    EXPECT_EQ(cut("-2000", 10), "-2000");
    EXPECT_NE(cut("FL125", 25), "FL125") << "the control: with a letter it is a word";
}

TEST(FittedWords, LettersOfSeveralBytesAreCutWhole) {
    const std::string degrees = "AB\xC2\xB0\xC2\xB0\xC2\xB0";
    for (float room = 10; room < 40; room += 1) {
        const std::string kept = cut(degrees.c_str(), room);
        EXPECT_NE(static_cast<unsigned char>(kept[kept.size() > 2 ? kept.size() - 3 : 0]), 0xC2u) << room;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_fitted_words
