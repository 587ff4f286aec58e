#include "host_sim/commands/sheet_plan.hpp"

#include <gtest/gtest.h>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/expect_user_error.hpp"

namespace tedavis::host_sim {
namespace {

const std::string kHead =
    "title = 'Two'\ncolumns = 2\nterrain = 'x.tif'\nwidth_px = 320\nheight_px = 240\n"
    "[pose]\nlatitude_deg = 47.03\nlongitude_deg = 9.68\naltitude_msl_m = 2500\nheading_deg = 40\npitch_deg = -6\n";
const std::string kGroup = "[[group]]\ntitle = 'Shade'\n";

std::string picture(const std::string& title, const std::string& design) {
    return "[[group.picture]]\ntitle = '" + title + "'\ndesign = '" + design + "'\n";
}

TEST(SheetPlan, ReadsWhatTheFileSays) {
    const SheetPlan plan =
        parse_sheet_plan(kHead + kGroup + picture("One light", "styles/lambert") + picture("Own", "my/own.toml") +
                             "[[group]]\ntitle = 'Map'\n" + picture("Cruise", "cruise"),
                         "two.toml");
    EXPECT_EQ(plan.title, "Two");
    EXPECT_EQ(plan.columns, 2u);
    EXPECT_EQ(plan.terrain, "x.tif");
    EXPECT_EQ(plan.size.width, 320u);
    EXPECT_EQ(plan.size.height, 240u);
    EXPECT_FALSE(plan.symbology);
    EXPECT_FALSE(plan.generated_image);
    EXPECT_TRUE(parse_sheet_plan("generated_image = true\n" + kHead + kGroup + picture("A", "a"), "s.toml").generated_image);
    EXPECT_EQ(plan.pose.latitude_deg, 47.03);
    EXPECT_EQ(plan.pose.pitch_deg, -6);
    EXPECT_EQ(plan.pose.roll_deg, 0) << "level where nothing is said";
    ASSERT_EQ(plan.groups.size(), 2u);
    EXPECT_EQ(plan.groups[0].title, "Shade");
    EXPECT_EQ(plan.groups[0].pictures[0].file, "lambert.png");
    EXPECT_EQ(plan.groups[0].pictures[1].file, "own.png");
    EXPECT_EQ(plan.groups[0].pictures[1].design, "my/own.toml");
    EXPECT_EQ(plan.groups[1].pictures[0].title, "Cruise");
    EXPECT_EQ(plan.picture_count(), 3u);
}

TEST(SheetPlan, DataHaveASceneATimeDetailsAndViewsOfTheirOwn) {
    const SheetPlan plan = parse_sheet_plan("scene = 'jacksboro'\ntime = '1970-01-01T00:01:00Z'\n" + kHead + kGroup +
                                                picture("Low", "barbs") + "detail = 0.3\n" + picture("High", "barbs") +
                                                "detail = 1\n[group.picture.pose]\nlatitude_deg = 1\nlongitude_deg = 2\n" +
                                                "altitude_msl_m = 3\nheading_deg = 4\n",
                                            "d.toml");
    EXPECT_EQ(plan.scene, "jacksboro");
    EXPECT_EQ(parse_sheet_plan("scenario = 'default'\n" + kHead + kGroup + picture("A", "a"), "d.toml").scenario, "default");
    test_support::expect_user_error(
        [] { (void)parse_sheet_plan("scene = 'a'\nscenario = 'b'\n" + kHead + kGroup + picture("A", "a"), "d.toml"); },
        "keep one");
    ASSERT_TRUE(plan.time);
    EXPECT_EQ(plan.time->ns, 60'000'000'000);
    const auto& pictures = plan.groups[0].pictures;
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures[0].file, "barbs_30.png");
    EXPECT_EQ(pictures[1].file, "barbs_100.png") << "one design twice";
    EXPECT_EQ(pictures[0].detail, 0.3);
    EXPECT_FALSE(pictures[0].pose);
    ASSERT_TRUE(pictures[1].pose);
    EXPECT_EQ(pictures[1].pose->heading_deg, 4);
    test_support::expect_user_error(
        [] { (void)parse_sheet_plan("time = 'noon'\n" + kHead + kGroup + picture("A", "a"), "d.toml"); }, "d.toml:1");
}

TEST(SheetPlan, NamesTheLineOfWhatIsWrong) {
    const auto refused = [](const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { (void)parse_sheet_plan(text, "s.toml"); }, words);
    };
    const std::string good = kHead + kGroup + picture("A", "styles/a");
    EXPECT_NO_THROW((void)parse_sheet_plan(good, "s.toml"));
    refused(good + "colour = 1\n", "s.toml:");
    refused(kHead, "[[group]]");
    refused(kHead + kGroup, "[[group.picture]]");
    refused(good + picture("B", "other/a"), "s.toml:19: ");
    refused(good + picture("B", "other/a"), "'a.png', whose name is taken");
    refused(good + picture("B", "sheet"), "'sheet.png', whose name is taken");
    refused(good + picture("", "b"), "s.toml:18: ");
    refused(good + picture(std::string(61, 'x'), "b"), "1 to 60 characters");
    refused(good + "[[group.picture]]\ntitle = 'B'\n", "design");
    std::string off_the_earth = good;
    off_the_earth.replace(off_the_earth.find("47.03"), 5, "97.03");
    refused(off_the_earth, "s.toml:7: ");
}

TEST(SheetPlan, TheShippedOneIsWhole) {
    const std::string path = resolve_config("terrain-styles", "sheets");
    const SheetPlan plan = parse_sheet_plan(read_file(path), path);
    EXPECT_NO_THROW(require_designs(plan, path));
    EXPECT_GE(plan.picture_count(), 27u) << "every design of styles";
    EXPECT_NO_THROW((void)read_file(shipped_root() + "/configs/data/" + plan.terrain));
}

TEST(SheetPlan, ADesignThatIsNotThereIsNamedWithItsPicture) {
    const SheetPlan plan = parse_sheet_plan(kHead + kGroup + picture("Woods", "styles/woods"), "s.toml");
    test_support::expect_user_error([&] { require_designs(plan, "s.toml"); },
                                    "s.toml: picture 'Woods': styles/woods: no such file");
}

}  // namespace
}  // namespace tedavis::host_sim
