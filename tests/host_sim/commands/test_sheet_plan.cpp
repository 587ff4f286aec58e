#include "host_sim/commands/sheet_plan.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_sheet_plan {
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
    EXPECT_EQ(plan.terrain, shipped_root() + "/configs/data/x.tif");
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

std::string view(const std::string& name, int heading_deg) {
    return "[[view]]\nname = '" + name +
           "'\nlatitude_deg = 1\nlongitude_deg = 2\naltitude_msl_m = 3\nheading_deg = " + std::to_string(heading_deg) + "\n";
}

TEST(SheetPlan, DataHaveASceneAndATime) {
    const std::string rest = kHead + kGroup + picture("A", "a");
    const SheetPlan plan = parse_sheet_plan("scene = 'jacksboro'\ntime = '1970-01-01T00:01:00Z'\n" + rest, "d.toml");
    EXPECT_EQ(plan.scene, shipped_root() + "/configs/scenes/jacksboro.toml");
    ASSERT_TRUE(plan.time);
    EXPECT_EQ(plan.time->ns, 60'000'000'000);
    EXPECT_EQ(parse_sheet_plan("scenario = 'default'\n" + rest, "d.toml").scenario,
              shipped_root() + "/configs/scenarios/default.toml");
    EXPECT_EQ(parse_sheet_plan("scene = '../own.toml'\n" + rest, "/a/b/d.toml").scene, "/a/own.toml");
    std::string own_terrain = rest;
    own_terrain.replace(own_terrain.find("x.tif"), 5, "../x.tif");
    EXPECT_EQ(parse_sheet_plan(own_terrain, "/a/b/d.toml").terrain, "/a/x.tif") << "from the sheet's folder";
    test_support::expect_user_error([&] { (void)parse_sheet_plan("scene = 'a'\nscenario = 'b'\n" + rest, "d.toml"); },
                                    "keep one");
    test_support::expect_user_error([&] { (void)parse_sheet_plan("time = 'noon'\n" + rest, "d.toml"); }, "d.toml:1");
}

TEST(SheetPlan, OnePictureBecomesAPairOfLittleAndAllDetail) {
    const SheetPlan plan =
        parse_sheet_plan("little_detail = 0.3\n" + kHead + kGroup + picture("Barbs", "data/barbs") + picture("Plain", "plain") +
                             "little_detail = 0\n" + picture("Own", "own") + "little_detail = 0.5\n",
                         "d.toml");
    const auto& pictures = plan.groups[0].pictures;
    ASSERT_EQ(pictures.size(), 5u);
    EXPECT_EQ(pictures[0].title, "Barbs, little detail");
    EXPECT_EQ(pictures[0].file, "barbs_30.png");
    EXPECT_EQ(pictures[0].detail, 0.3);
    EXPECT_EQ(pictures[1].title, "Barbs, all detail");
    EXPECT_EQ(pictures[1].file, "barbs_100.png") << "one design twice";
    EXPECT_EQ(pictures[1].detail, 1);
    EXPECT_EQ(pictures[2].title, "Plain");
    EXPECT_EQ(pictures[2].file, "plain.png");
    EXPECT_FALSE(pictures[2].detail) << "none: the design's own";
    EXPECT_EQ(pictures[3].detail, 0.5);
}

TEST(SheetPlan, PicturesHaveViewsByName) {
    const std::string seen = picture("A", "a") + "view = 'near'\n";
    const SheetPlan plan = parse_sheet_plan(
        kHead + view("near", 4) + "time = '1970-01-01T00:01:00Z'\n" + view("far", 5) + kGroup + seen + picture("B", "b"),
        "d.toml");
    EXPECT_EQ(plan.pose_of(plan.groups[0].pictures[0]).heading_deg, 4);
    EXPECT_EQ(plan.pose_of(plan.groups[0].pictures[0]).time.ns, 60'000'000'000);
    EXPECT_EQ(plan.pose_of(plan.groups[0].pictures[1]).heading_deg, 40) << "the sheet's own";
    EXPECT_EQ(plan.pose_of(plan.groups[0].pictures[1]).time.ns, kPosedTime.ns);
    const auto refused = [](const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { (void)parse_sheet_plan(text, "d.toml"); }, words);
    };
    refused(kHead + view("far", 5) + kGroup + seen, "d.toml: picture 'A' asks for the view 'near', which is not there");
    refused(kHead + view("far", 5) + view("far", 6) + kGroup + picture("A", "a"), "of this view alone");
}

TEST(SheetPlan, AnotherSheetsPicturesAreShownFromViewsOfItsOwn) {
    const test_support::TemporaryFolder folder;
    folder.write("first.toml", kHead + view("near", 4) + kGroup + picture("A", "a") + "view = 'near'\n");
    std::string head = kHead;
    head.replace(head.find("columns = 2"), 11, "groups_of = './first.toml'");
    const SheetPlan plan = read_sheet_plan(folder.write("second.toml", head + view("near", 9)));
    EXPECT_EQ(plan.columns, 2u);
    ASSERT_EQ(plan.picture_count(), 1u);
    EXPECT_EQ(plan.pose_of(plan.groups[0].pictures[0]).heading_deg, 9);
    const auto refused = [&](const std::string& text, const std::string& words) {
        const std::string path = folder.write("third.toml", text);
        test_support::expect_user_error([&] { (void)read_sheet_plan(path); }, words);
    };
    refused(head, "third.toml: picture 'A' asks for the view 'near'");
    refused(head + view("near", 9) + kGroup + picture("A", "a"), "would be the second 'a.png'");
    const SheetPlan more = read_sheet_plan(folder.write("more.toml", head + view("near", 9) + kGroup + picture("B", "b")));
    EXPECT_EQ(more.picture_count(), 2u);
    EXPECT_EQ(more.groups[1].pictures[0].title, "B") << "its own come last";
    std::string third = head + view("near", 9);
    third.replace(third.find("first"), 5, "second");
    refused(third, "second.toml, which has no groups of its own");
}

TEST(SheetPlan, DesignsOfAFolderStandInForThoseOfTheirNames) {
    const test_support::TemporaryFolder folder;
    const std::string pictures = kGroup + picture("A", "data/a") + "little_detail = 0.5\n" + picture("B", "data/b");
    const std::string path = folder.write("s.toml", "designs = 'own'\n" + kHead + pictures);
    test_support::expect_user_error([&] { (void)read_sheet_plan(path); }, "own, where no design is");
    std::filesystem::create_directories(folder.file("own/data"));
    const std::string own = folder.write("own/data/a.toml", "");
    const SheetPlan plan = read_sheet_plan(path);
    const auto& shown = plan.groups[0].pictures;
    ASSERT_EQ(shown.size(), 3u);
    EXPECT_EQ(shown[0].design, own);
    EXPECT_EQ(shown[0].file, "a_50.png") << "files are called as they were";
    EXPECT_EQ(shown[1].design, own) << "both of a pair";
    EXPECT_EQ(shown[2].design, "data/b") << "the folder has none of this name";
    folder.write("own/data/typo.toml", "");
    test_support::expect_user_error([&] { (void)read_sheet_plan(path); }, "typo.toml: no picture of");
}

TEST(SheetPlan, AViewMayHaveBeenFlownTo) {
    const std::string flown =
        "[view.flown]\nseconds = 90\nspeed_mps = 50\nwind_mps = 7\nwind_from_deg = 200\n"
        "temperature_c = 3\naccuracy_m = 25\n";
    const SheetPlan plan =
        parse_sheet_plan(kHead + view("near", 4) + flown + kGroup + picture("A", "a") + "view = 'near'\n", "d");
    const FlownHistory& history = plan.pose_of(plan.groups[0].pictures[0]).flown;
    EXPECT_EQ(history.seconds, 90);
    EXPECT_EQ(history.wind_from_deg, 200);
    EXPECT_EQ(history.accuracy_before_m, 25) << "as at the end";
    EXPECT_EQ(plan.pose.flown.seconds, 0) << "others have flown nothing";
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

TEST(SheetPlan, TheShippedOnesAreWhole) {
    const std::map<std::string, std::size_t> least = {
        {"terrain-styles", 27}, {"data-techniques", 74}, {"effects", 18}, {"focus", 39}, {"priority", 6}};
    for (const auto& [name, pictures] : least) {
        const std::string path = resolve_config(name, "sheets");
        const SheetPlan plan = read_sheet_plan(path);
        EXPECT_NO_THROW(require_designs(plan, path));
        EXPECT_GE(plan.picture_count(), pictures) << "every design of its folder";
        EXPECT_NO_THROW((void)read_file(plan.terrain));
    }
}

TEST(SheetPlan, ADesignThatIsNotThereIsNamedWithItsPicture) {
    const SheetPlan plan = parse_sheet_plan(kHead + kGroup + picture("Woods", "styles/woods"), "s.toml");
    test_support::expect_user_error([&] { require_designs(plan, "s.toml"); },
                                    "s.toml: picture 'Woods': styles/woods: no such file");
}

}  // namespace
}  // namespace tedavis::host_sim::test_sheet_plan
