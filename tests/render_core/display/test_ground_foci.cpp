// What foci change of the ground in whole frames: when, by which effect, and that nothing changes where none is anywhere.
#include <gtest/gtest.h>

#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/effect_requests.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_ground_foci {
namespace {

using effects::Effect;
using test_support::aircraft_over_hills;
using test_support::hills;
using test_support::hills_picture;
using test_support::HillsPicture;

/// The near ground is in focus; the far one is the context's.
design::DesignSettings design_with(const design::FocusTerrain& context) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.style.sketch.silhouettes = 0;
    design::SymbologySettings& over = design.symbology;
    over.attitude = over.heading = over.airspeed = over.altitude = over.vertical_speed = over.flight_path = over.legend =
        over.ground_height = over.phase = over.air = over.baro_setting = false;
    design::FocusSettings focus;
    focus.radius_m = 1800;
    focus.context.width_m = 400;
    focus.terrain = context;
    EXPECT_TRUE(design.foci.try_push_back(focus));
    return design;
}
design::FocusTerrain dark() {
    design::FocusTerrain context;
    context.brightness = 0.3;
    return context;
}

/// One display after the other: only one surface is current.
class Hills {
public:
    Hills(const std::string& device, const design::DesignSettings& design) : display_("egl", device, 320, 240, &bytes_, design) {}
    HillsPicture picture(double roll_deg = 0) {
        HillsPicture seen = hills_picture(display_, aircraft_over_hills(1700, 30, -12, roll_deg));
        EXPECT_EQ(display_.display().gl().denied().total, 0u);
        return seen;
    }
    /// Of the last picture; without a name where the design does not ask for it.
    [[nodiscard]] EffectRecord effect(Effect asked) {
        for (const EffectRecord& noted : display_.display().record().effects)
            if (noted.name.view() == effects::row_of(asked).name) return noted;
        return {};
    }
    [[nodiscard]] Display& display() { return display_.display(); }

private:
    test_support::MemoryBytes bytes_{hills().image};
    test_support::HeadlessDisplay display_;
};

HillsPicture picture_of(const std::string& device, const design::DesignSettings& design, double roll_deg = 0) {
    return Hills(device, design).picture(roll_deg);
}
design::DesignSettings without_foci(design::DesignSettings design) {
    design.foci.clear();
    return design;
}

double mean_of(const HillsPicture& picture, std::uint32_t first_row, std::uint32_t last_row) {
    double sum = 0;
    for (std::uint32_t y = first_row; y < last_row; ++y)
        for (std::uint32_t x = 60; x < 260; ++x) sum += picture.at(x, y)[1];
    return sum / (200.0 * (last_row - first_row));
}

class GroundFoci : public testing::TestWithParam<const char*> {};

TEST_P(GroundFoci, TheContextIsDarker) {
    const HillsPicture as_it_is = picture_of(GetParam(), without_foci(design_with(dark())));
    Hills with(GetParam(), design_with(dark()));
    const HillsPicture seen = with.picture();
    EXPECT_EQ(with.effect(Effect::focus_ground).name.view(), "focus_ground");
    EXPECT_EQ(with.effect(Effect::focus_ground).state, EffectState::run);
    EXPECT_LT(mean_of(seen, 110, 130), 0.75 * mean_of(as_it_is, 110, 130)) << "far off";
    EXPECT_NEAR(mean_of(seen, 225, 238), mean_of(as_it_is, 225, 238), 3) << "near";
}

/// The picture of the same design without foci, by its programs: of a design whose ground is drawn as codes, too.
TEST_P(GroundFoci, WhereNoFocusIsAnywhereNothingChanges) {
    for (const double silhouettes : {0.0, 0.8}) {
        design::DesignSettings design = design_with(dark());
        design.terrain.style.sketch.silhouettes = silhouettes;
        const HillsPicture none = picture_of(GetParam(), without_foci(design));
        EXPECT_NE(picture_of(GetParam(), design), none) << "control";
        design.foci[0].at = design::FocusAt::place;
        design.foci[0].place = "nowhere";
        Hills lost(GetParam(), design);
        EXPECT_EQ(lost.picture(), none);
        EXPECT_EQ(lost.effect(Effect::focus_ground).state, EffectState::skipped);
        EXPECT_EQ(lost.effect(Effect::focus_ground).reason.view(), "no focus is anywhere");
    }
}

TEST_P(GroundFoci, TheRecoverySeesAllOfTheGround) {
    const HillsPicture rolled = picture_of(GetParam(), without_foci(design_with(dark())), 100);
    const HillsPicture level = picture_of(GetParam(), without_foci(design_with(dark())));
    Hills with(GetParam(), design_with(dark()));
    EXPECT_EQ(with.picture(100), rolled);
    EXPECT_EQ(with.effect(Effect::focus_ground).reason.view(), effects::kRemovedByPolicy);
    EXPECT_NE(with.picture(0), level) << "and then it is back";
    EXPECT_EQ(with.effect(Effect::focus_ground).state, EffectState::run);
}

TEST_P(GroundFoci, TheDevicesBudgetHoldsThem) {
    Hills with(GetParam(), design_with(dark()));
    with.picture();
    const ByteRecord& bytes = with.display().record().bytes;
    EXPECT_LE(bytes.cpu, bytes.cpu_budget);
    EXPECT_LE(bytes.gpu, bytes.gpu_budget);
}

INSTANTIATE_TEST_SUITE_P(Lanes, GroundFoci, testing::Values("es2-small", "es3-mid"),
                         [](const auto& lane) { return std::string(lane.param).substr(0, 3); });

/// Sum of differences between neighbours: what blur takes.
double sharpness(const HillsPicture& picture, std::uint32_t first_row, std::uint32_t last_row) {
    double sum = 0;
    for (std::uint32_t y = first_row; y < last_row; ++y)
        for (std::uint32_t x = 60; x < 260; ++x) sum += std::abs(picture.at(x, y)[1] - picture.at(x + 1, y)[1]);
    return sum;
}

design::FocusTerrain blurred() {
    design::FocusTerrain context;
    context.blur_px = 6;
    return context;
}

TEST(GroundFociBlur, TheContextIsBlurredAndTheFocusIsNot) {
    design::DesignSettings design = design_with(blurred());
    design.terrain.style.sketch.stippling = 1;  // something to be blurred
    const HillsPicture as_it_is = picture_of("es3-mid", without_foci(design));
    Hills with("es3-mid", design);
    const HillsPicture seen = with.picture();
    EXPECT_EQ(with.effect(Effect::focus_blur).name.view(), "focus_blur");
    EXPECT_EQ(with.effect(Effect::focus_blur).state, EffectState::run);
    EXPECT_LT(sharpness(seen, 112, 130), 0.7 * sharpness(as_it_is, 112, 130));
    EXPECT_NEAR(mean_of(seen, 112, 130), mean_of(as_it_is, 112, 130), 6);
    EXPECT_GT(sharpness(seen, 225, 238), 0.95 * sharpness(as_it_is, 225, 238));
}

/// What the device cannot do, what has no room in alpha, and what the governor gives up.
TEST(GroundFociBlur, BrightnessStandsForIt) {
    const auto far_mean = [](Hills& seen) { return mean_of(seen.picture(), 112, 130); };
    double as_blurred = 0;
    {
        Hills large("es3-mid", design_with(blurred()));
        as_blurred = far_mean(large);
        effects::EffectSet blur;
        blur.add(Effect::focus_blur);
        large.display().memory().budget.give_up(blur);
        EXPECT_LT(far_mean(large), 0.9 * as_blurred) << "given up";
        EXPECT_EQ(large.effect(Effect::focus_blur).replaced_by.view(), "focus_ground");
    }
    {
        Hills small("es2-small", design_with(blurred()));
        EXPECT_LT(far_mean(small), 0.9 * as_blurred) << "no second picture";
        EXPECT_EQ(small.effect(Effect::focus_blur).replaced_by.view(), "focus_ground");
    }
    design::DesignSettings design = design_with(blurred());
    design.terrain.style.sketch.silhouettes = 0.5;
    Hills outlined("es3-mid", design);
    EXPECT_LT(far_mean(outlined), 0.9 * as_blurred) << "silhouettes";
    EXPECT_EQ(outlined.effect(Effect::focus_blur).replaced_by.view(), "focus_ground");
}

}  // namespace
}  // namespace tedavis::display::test_ground_foci
