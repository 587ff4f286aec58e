#include "host_sim/sweep/draw_sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/evaluation/picture_meter.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/replay/posed_frame.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_draw_sweep {
namespace {

const test_support::FlownFiles& flown() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

class DrawSweep : public ::testing::Test {
protected:
    DrawSweep() {
        job_.picture = flown().options("unused").picture;
        job_.terrain_name = "my.tdb";
        job_.picture.size = PictureSize{160, 120};
        job_.place = SweptPlace{47.03, 9.68, {}};
        job_.rings = {2, {4000}, {600, 1200}};
        job_.folder = place_.path();
        job_.is_stopped = [] { return false; };
    }
    Sweep drawn() {
        WrittenFiles files;
        Sweep sweep = drawn(files);
        files.keep();
        return sweep;
    }
    Sweep drawn(WrittenFiles& files) {
        std::ostringstream results, notes;
        Console console(results, notes, false, false);
        Sweep sweep = draw_sweep(job_, files, console, fault_);
        EXPECT_EQ(fault_, "");
        return sweep;
    }
    test_support::TemporaryFolder place_;
    SweepJob job_;
    std::string fault_;
};

// One display draws them all; each is the picture that a display of its own would draw.
TEST_F(DrawSweep, EachViewIsThatOfADisplayOfItsOwn) {
    const Sweep sweep = drawn();
    ASSERT_EQ(sweep.views.size(), 4u);
    for (const SweptView& view : sweep.views) {
        DisplaySession fresh(job_.picture, false);
        EXPECT_EQ(posed_frame(fresh, view.viewpoint.pose, {}).hash, view.hash) << view.file;
        const RgbaPicture picture = read_png(place_.file(view.file));
        EXPECT_EQ(picture.pixels, upright(fresh.pixels()).pixels);
        PictureMeter meter({});
        EXPECT_EQ(meter.measure(picture, "p", nullptr, {}).clutter, view.measures.clutter);
        ASSERT_EQ(view.measures.layers.size(), 5u);
        EXPECT_EQ(view.measures.layers[0].layer, "terrain");
    }
    EXPECT_NE(sweep.views[0].hash, sweep.views[1].hash);
}

TEST_F(DrawSweep, ThePlaceLiesInTheMiddleOfThePicture) {
    for (const SweptView& view : drawn().views) {
        ASSERT_TRUE(view.place.is_inside);
        EXPECT_NEAR(view.place.x_px, 80, 1);
        EXPECT_NEAR(view.place.y_px, 60, 20) << "the design may tilt the view";
        EXPECT_GT(view.saliency.area, 0);
        EXPECT_GT(view.saliency.share, 0);
        EXPECT_NE(view.sight, PlaceSight::outside_picture);
    }
}

TEST_F(DrawSweep, WhatStandsOutHasAllViews) {
    const Sweep sweep = drawn();
    ASSERT_GE(sweep.standing_out.size(), 2u);
    std::string words;
    for (const StandingOut& one : sweep.standing_out) {
        words += one.title + "; ";
        EXPECT_GT(one.opinions.feature_congestion, 0);
        EXPECT_FALSE(one.picture_png.empty() || one.heat_png.empty() || one.edges_png.empty());
    }
    for (const char* what : {"most clutter", "least clutter", "the place draws the eye most"})
        EXPECT_THAT(words, ::testing::HasSubstr(what));
    EXPECT_EQ(place_.entries(), 4u + 7 * sweep.standing_out.size()) << "four pictures, all views of these";
}

// Symbology stands before the place: what it draws of the eye is not the place's.
TEST_F(DrawSweep, ThePlaceIsJudgedWithoutSymbology) {
    const Sweep with = drawn();
    job_.picture.symbology = false;
    const Sweep without = drawn();
    for (std::size_t n = 0; n < with.views.size(); ++n) {
        EXPECT_NE(with.views[n].hash, without.views[n].hash);
        EXPECT_EQ(with.views[n].saliency.share, without.views[n].saliency.share);
    }
}

TEST_F(DrawSweep, MasksAreLeftWhereAskedFor) {
    job_.layers = true;
    const Sweep sweep = drawn();
    EXPECT_EQ(place_.entries(), 4u + 4 + 7 * sweep.standing_out.size());
    EXPECT_TRUE(std::filesystem::exists(layer_mask_path(place_.file(sweep.views[0].file))));
}

TEST_F(DrawSweep, TheMiddleOfTheTerrainIsThePlaceOfAll) {
    job_.place.reset();
    job_.rings = {1, {3000}, {900}};
    const Sweep sweep = drawn();
    EXPECT_NEAR(sweep.place.latitude_rad * 57.29578, 47.1 - 96.0 / 1200, 1e-3);
    EXPECT_EQ(sweep.standing_out.size(), 1u) << "the only one";
}

TEST_F(DrawSweep, ViewpointsWithoutAViewAreSkipped) {
    job_.rings = {2, {3000, 60'000}, {-1500, 800}};
    const Sweep sweep = drawn();
    EXPECT_EQ(sweep.views.size(), 2u);
    ASSERT_EQ(sweep.skipped.size(), 6u);
    EXPECT_EQ(sweep.skipped[0].reason, "below the ground");
    EXPECT_EQ(sweep.skipped[2].reason, "outside the terrain");
}

TEST_F(DrawSweep, WhereTheDisplayWouldShowItsRecoveryPictureNothingIsMeasured) {
    job_.rings = {1, {1000, 4000}, {900}};
    const Sweep sweep = drawn();
    ASSERT_EQ(sweep.views.size(), 1u);
    EXPECT_EQ(sweep.views[0].viewpoint.distance_m, 4000);
    ASSERT_EQ(sweep.skipped.size(), 1u);
    EXPECT_EQ(sweep.skipped[0].reason, "so steep that the display shows its recovery picture");
    EXPECT_EQ(place_.entries(), 1u + 7) << "nothing is left of it";
}

TEST_F(DrawSweep, WhereNoneIsLeftItIsAnError) {
    job_.rings = {2, {60'000}, {800}};
    test_support::expect_user_error([&] { (void)drawn(); }, "none of 2 viewpoints can be drawn over my.tdb");
    job_.place = SweptPlace{10, 10, {}};
    test_support::expect_user_error([&] { (void)drawn(); }, "no ground height is known there");
    job_.place = SweptPlace{47.03, 9.68, {}};
    job_.rings = {2, {2000.1, 2000.2}, {800}};
    test_support::expect_user_error([&] { (void)drawn(); }, "the same to a metre");
    EXPECT_EQ(place_.entries(), 0u);
}

TEST_F(DrawSweep, StoppedItHasTheViewsSoFar) {
    int asked = 0;
    job_.is_stopped = [&] { return ++asked > 3; };
    const Sweep sweep = drawn();
    EXPECT_TRUE(sweep.interrupted);
    EXPECT_EQ(sweep.views.size(), 3u);
    job_.is_stopped = [] { return true; };
    EXPECT_THROW((void)drawn(), Interrupted);
}

TEST_F(DrawSweep, NothingStaysWhereItIsNotKept) {
    {
        WrittenFiles files;
        (void)drawn(files);
        EXPECT_GT(place_.entries(), 4u);
    }
    EXPECT_EQ(place_.entries(), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_draw_sweep
