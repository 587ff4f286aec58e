#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_frame_settings_knob {
namespace {

std::size_t level_named(const Knob& knob, const std::string& name) {
    for (std::size_t n = 0; n < knob.facts().levels.size(); ++n)
        if (knob.facts().levels[n].name.text() == name) return n;
    ADD_FAILURE() << name;
    return 0;
}

TEST(FrameSettingsKnob, ErrorsGrowWithTheToleranceAndWithTheDrawnPixel) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_frame_settings_knob(shipped.quick());
    const auto greatest = [&](const char* name) { return test_support::errors_of(*knob, level_named(*knob, name)).max; };
    EXPECT_LE(greatest("tau 1 px, full size"), 1);
    EXPECT_LE(greatest("tau 1 px, half size"), 2.5) << "a drawn pixel is two of the window";
    EXPECT_GE(test_support::errors_of(*knob, level_named(*knob, "tau 0.5 px, half size")).mean, 0.5)
        << "within a drawn pixel nobody can tell";
    EXPECT_GT(greatest("tau 8 px, half size"), greatest("tau 8 px, full size"));
    EXPECT_GT(greatest("tau 8 px, full size"), greatest("tau 1 px, full size"));
    EXPECT_LE(*knob->proven(level_named(*knob, "tau 1 px, full size")), 1);
    EXPECT_GE(*knob->proven(level_named(*knob, "tau 1 px, full size")), greatest("tau 1 px, full size"));
    const double of_half_px = *knob->proven(level_named(*knob, "tau 1 px, half size"));
    EXPECT_LE(of_half_px, 2.5) << "a drawn pixel is two of the window";
    EXPECT_GE(of_half_px, greatest("tau 1 px, half size"));
    const std::size_t half = level_named(*knob, "tau 2 px, half size");
    EXPECT_EQ(knob->options(half), "--tau 2 --size 320x180");
    const auto picture = knob->picture(half, 0);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 640u) << "as the window shows it";
}

TEST(FrameSettingsKnob, ItsLargestPictureIsAsLargeAsAsked) {
    const test_support::MadeKnobGround made;
    KnobGround ground = made.quick();
    ground.display.size = {480, 480};
    ground.display.device = "desktop";
    ground.display.design = "cruise";
    const auto knob = make_frame_settings_knob(ground);
    EXPECT_EQ(knob->options(level_named(*knob, "tau 2 px, half size")), "--tau 2 --size 240x240");
    const std::size_t full = level_named(*knob, "tau 1 px, full size");
    EXPECT_EQ(knob->picture(full, 0)->height, 480u);
    EXPECT_NE(knob->command(full, 0).find("--design cruise --device desktop --size 480x480 --tau 1 --pose"), std::string::npos)
        << knob->command(full, 0);
    EXPECT_NE(knob->facts().metric.text().find("480 x 480"), std::string::npos);
    std::vector<double> errors;
    knob->find_errors(full, 0, errors);
    ASSERT_FALSE(errors.empty());
    const KnobPixel last = *knob->pixel_of(0, errors.size() - 1);
    EXPECT_GT(last.y, 360u) << "near the lower border";
    EXPECT_LT(last.y, 480u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_frame_settings_knob
