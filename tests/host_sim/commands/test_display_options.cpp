#include "host_sim/commands/display_options.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim::test_display_options {
namespace {

/// A command that has them all.
struct DisplayOptions : ::testing::Test {
    DisplayOptions() {
        add_picture_options(&app, picture);
        add_legend(&app, picture);
        add_accuracy_shown(&app, shown);
        add_time(&app, time);
    }
    void parse(std::vector<std::string> words) {
        std::reverse(words.begin(), words.end());  // as CLI11 takes them
        app.parse(std::move(words));
    }

    CLI::App app;
    PictureOptions picture;
    AccuracyShown shown;
    std::optional<base::Time> time;
};

TEST_F(DisplayOptions, AreTheUsualOnesWhereNothingIsSaid) {
    parse({});
    const PictureOptions usual;
    EXPECT_EQ(picture.design, usual.design);
    EXPECT_EQ(picture.device, usual.device);
    EXPECT_EQ(picture.gl, usual.gl);
    EXPECT_EQ(picture.legend, flight::LegendShow::key) << "the default in flight";
    EXPECT_FALSE(picture.size || picture.tau_px || picture.deadline_ms || picture.saliency || picture.clutter || time);
    EXPECT_FALSE(shown.any());
}

TEST_F(DisplayOptions, ReachThePicture) {
    parse({"--terrain", "a.tdb", "--scene",    "b.sdb",    "--device", "sc2",        "--aircraft", "jet",     "--size",
           "64x48",     "--gl",  "osmesa",     "--design", "cruise",   "--palette",  "dark",       "--light", "night",
           "--tau",     "2",     "--deadline", "20",       "--costs",  "costs.toml", "--saliency", "map",     "--force-effects",
           "--weights", "data=1"});
    EXPECT_EQ(picture.terrain + " " + picture.scene, "a.tdb b.sdb");
    EXPECT_EQ(picture.device + " " + picture.aircraft + " " + picture.design, "sc2 jet cruise");
    EXPECT_EQ(picture.palette + " " + picture.costs, "dark costs.toml");
    ASSERT_TRUE(picture.size);
    EXPECT_EQ(picture.size->height, 48u);
    EXPECT_EQ(picture.gl, GlChoice::osmesa);
    EXPECT_EQ(picture.light, design::SymbologyLight::night);
    EXPECT_EQ(picture.tau_px, 2);
    EXPECT_EQ(picture.deadline_ms, 20);
    EXPECT_EQ(picture.saliency, design::SaliencyView::map);
    EXPECT_TRUE(picture.force_effects);
}

TEST_F(DisplayOptions, FociAddUpAndViewsAndTimesAreRead) {
    parse({"--focus", "at = 1", "--focus", "at = 2", "--clutter", "regions", "--legend", "whole", "--error-map", "--time",
           "1970-01-01T00:00:07Z"});
    EXPECT_EQ(picture.foci, (std::vector<std::string>{"at = 1", "at = 2"}));
    EXPECT_EQ(picture.clutter, design::ClutterView::regions);
    EXPECT_EQ(picture.legend, flight::LegendShow::whole);
    EXPECT_TRUE(shown.error_map);
    EXPECT_FALSE(shown.figures);
    ASSERT_TRUE(time);
    EXPECT_EQ(time->ns, 7'000'000'000);
}

TEST_F(DisplayOptions, UnknownWordsAndNumbersOutOfRangeAreRefused) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--gl", "metal"},
                                                  {"--light", "dusk"},
                                                  {"--legend", "some"},
                                                  {"--saliency", "edges"},
                                                  {"--clutter", "heat"},
                                                  {"--size", "64"},
                                                  {"--time", "noon"}})
        EXPECT_THROW(parse(words), UserError) << words[1];
    for (const char* const option : {"--tau", "--deadline"}) EXPECT_THROW(parse({option, "0"}), CLI::ParseError) << option;
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_options
