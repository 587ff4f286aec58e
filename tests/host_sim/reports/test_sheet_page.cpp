#include "host_sim/reports/sheet_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/host_sim/reports/small_sheet.hpp"

namespace tedavis::host_sim::test_sheet_page {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

DrawnSheet flagged_sheet() {
    DrawnSheet sheet = test_support::small_sheet();
    display::FrameRecord& record = sheet.groups[0].pictures[1].result.record;
    EXPECT_TRUE(record.flags.try_push_back(display::Name("terrain.coarse")));
    EXPECT_TRUE(record.flags.try_push_back(display::Name("vertical_speed.missing")));
    display::EffectRecord effect;
    effect.name = "cast_shadows";
    effect.state = display::EffectState::replaced;
    effect.reason = "no <horizons> in the database";
    effect.replaced_by = "lambert";
    EXPECT_TRUE(record.effects.try_push_back(effect));
    effect.name = "warning_colors";
    effect.state = display::EffectState::skipped;
    EXPECT_TRUE(record.effects.try_push_back(effect));
    effect.name = "silhouettes";
    effect.state = display::EffectState::run;
    EXPECT_TRUE(record.effects.try_push_back(effect));
    return sheet;
}

TEST(SheetPage, NamesEveryPictureAndWhatItLacks) {
    const std::string page = sheet_page(flagged_sheet());
    for (const char* part :
         {"<!DOCTYPE html>", "width=device-width", "A &lt;small&gt; sheet", "hills.tdb", "36.5000&deg; N 84.2500&deg; W", "First",
          "Second", "Title a", "styles/d", "12345 triangles", "terrain.coarse",
          "cast_shadows replaced by lambert: no &lt;horizons&gt; in the database", "@media print", "not certified"})
        EXPECT_THAT(page, HasSubstr(part));
    for (const char* usual : {"silhouettes", "warning_colors", "vertical_speed"})
        EXPECT_THAT(page, Not(HasSubstr(usual))) << "what is as it should be needs no words";
}

TEST(SheetPage, PicturesOfAFlightHaveCaptionsAndNoCommonPose) {
    DrawnSheet sheet = test_support::small_sheet();
    EXPECT_FALSE(nlohmann::json::parse(sheet_json(sheet)).at("pictures").at(0).contains("caption"));
    sheet.pose.reset();
    sheet.groups[0].pictures[0].caption = "It flies <low>.";
    sheet.groups[0].pictures[0].flight_s = 12.5;
    EXPECT_THAT(sheet_page(sheet), HasSubstr("<div>It flies &lt;low&gt;.</div>"));
    EXPECT_THAT(sheet_page(sheet), HasSubstr("seen along a flight"));
    EXPECT_THAT(sheet_page(sheet), Not(HasSubstr("&deg;")));
    const auto json = nlohmann::json::parse(sheet_json(sheet));
    EXPECT_TRUE(json.at("pose").is_null());
    EXPECT_EQ(json.at("pictures").at(0).at("caption"), "It flies <low>.");
    EXPECT_EQ(json.at("pictures").at(0).at("flight_s"), 12.5);
}

TEST(SheetPage, NeedsNothingButItself) {
    const std::string page = sheet_page(flagged_sheet());
    for (const char* outside : {"<script", "<link", "@import", "http"}) EXPECT_THAT(page, Not(HasSubstr(outside)));
    const std::regex source("(src|href)='([^']{0,22})");
    std::size_t pictures = 0;
    for (std::sregex_iterator it(page.begin(), page.end(), source), end; it != end; ++it, ++pictures)
        EXPECT_EQ((*it)[2].str(), "data:image/png;base64,");
    EXPECT_EQ(pictures, 4u);
}

TEST(SheetPage, JsonHoldsWhatScriptsRelyOn) {
    const auto json = nlohmann::json::parse(sheet_json(flagged_sheet()));
    EXPECT_EQ(json.at("sheet"), "small");
    EXPECT_EQ(json.at("picture"), "sheet.png");
    EXPECT_EQ(json.at("pose").at("lon_deg"), -84.25);
    ASSERT_EQ(json.at("pictures").size(), 4u);
    const auto& picture = json.at("pictures").at(1);
    EXPECT_EQ(picture.at("group"), "First");
    EXPECT_EQ(picture.at("title"), "Title b");
    EXPECT_EQ(picture.at("design"), "styles/b");
    EXPECT_EQ(picture.at("file"), "b.png");
    EXPECT_EQ(picture.at("hash"), "0123456789abcdef");
    EXPECT_EQ(picture.at("triangles"), 12345);
    EXPECT_EQ(picture.at("flags"), nlohmann::json({"terrain.coarse", "vertical_speed.missing"}));
    EXPECT_TRUE(picture.at("data").is_object()) << "the counts of each type";
    EXPECT_EQ(picture.at("effects").at(0).at("replaced_by"), "lambert");
    EXPECT_EQ(json.at("pictures").at(3).at("group"), "Second");
}

}  // namespace
}  // namespace tedavis::host_sim::test_sheet_page
