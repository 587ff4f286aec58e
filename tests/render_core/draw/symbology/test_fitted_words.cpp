#include "render_core/draw/symbology/fitted_words.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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
    EXPECT_EQ(cut("FL125", 25), "FL125");
    EXPECT_NE(cut("FLIGHT", 25), "FLIGHT") << "the control: without a digit it is a word";
}

/// No value that was not in the text: every word with a digit is one of its words, with the unit that followed it.
std::string changed_value(const std::string& text, const std::string& kept, const std::vector<std::string>& values) {
    const bool is_cut = kept.size() > 2 && kept.substr(kept.size() - 2) == "..";
    std::string rest = is_cut ? kept.substr(0, kept.size() - 2) : kept;
    for (const std::string& value : values)
        if (const std::size_t at = rest.find(value); at != std::string::npos && text.find(value) == at)
            rest.erase(at, value.size());
    return rest.find_first_of("0123456789") == std::string::npos ? "" : rest;
}

TEST(FittedWords, AValueAndItsUnitAreNeverParted) {
    const struct {
        const char* text;
        std::vector<std::string> values;
    } kTexts[] = {{"WIND 850 HPA", {"850 HPA"}},
                  {"241/112KT 45S", {"241/112KT 45S", "241/112KT"}},
                  {"TRAFFIC 12 NM AHEAD", {"12 NM"}},
                  {"GUST 116 KM/H MAX", {"116 KM/H"}},
                  {"CLIMB 500 FT/MIN MAX", {"500 FT/MIN"}},
                  {"FL125 CLOUD TOPS", {"FL125"}},
                  {"5.0\xC2\xB0 PATH", {"5.0\xC2\xB0"}}};
    for (const auto& [text, values] : kTexts)
        for (float room = 5; room < text_width_px(text, 11); room += 1)
            EXPECT_EQ(changed_value(text, cut(text, room), values), "") << text << " in " << room << ": " << cut(text, room);
    EXPECT_EQ(cut("2D WIND/TURBULENCE", 40), "2D WI..") << "a slash alone makes no unit";
    EXPECT_EQ(cut("WIND 850 HPA", 60), "WIND..");
    EXPECT_EQ(cut("850 HPA WIND", 75), "850 HPA WI..");
    // The controls: values that are cut as words would be.
    EXPECT_NE(changed_value("WIND 850 HPA", "WIND 85..", {"850 HPA"}), "");
    EXPECT_NE(changed_value("WIND 850 HPA", "WIND 850 H..", {"850 HPA"}), "");
    EXPECT_NE(changed_value("FL125 CLOUD TOPS", "FL1..", {"FL125"}), "");
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
