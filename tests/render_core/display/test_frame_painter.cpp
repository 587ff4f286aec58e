#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <type_traits>

#include "render_core/display/display.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_frame_painter {
namespace {

using design::StereoMode;
using draw::EyeSide;
using effects::Effect;
using test_support::HeadlessDisplay;

constexpr std::uint32_t kWidth = 320, kHeight = 200;

/// A name that two base classes have is ambiguous, so the address of such a member tells whether T has the name as well, as a
/// function of any signature.
struct PlanNames {
    int plan, plan_again;
};
template <class T>
struct WithPlanNames : T, PlanNames {};

template <class T, class = void>
constexpr bool kPlans = true;
template <class T>
constexpr bool kPlans<T, std::void_t<decltype(&WithPlanNames<T>::plan)>> = false;

template <class T, class = void>
constexpr bool kPlansAgain = true;
template <class T>
constexpr bool kPlansAgain<T, std::void_t<decltype(&WithPlanNames<T>::plan_again)>> = false;

static_assert(!kPlans<FramePainter> && !kPlansAgain<FramePainter>, "a painter that is asked to plan does not compile");
static_assert(!kPlans<TerrainPainter> && !kPlansAgain<TerrainPainter>);
static_assert(!kPlans<ElementPainter> && !kPlansAgain<ElementPainter>);

struct PlansAgain {
    void plan_again(int times);
};
static_assert(kPlans<ElementPlanner> && kPlansAgain<PlansAgain>, "control");
static_assert(std::is_member_function_pointer_v<decltype(&FramePlanner::plan)> &&
                  std::is_member_function_pointer_v<decltype(&FramePlanner::plan_again)>,
              "control: these are the names of the planner, from which no class can be derived");

design::DesignSettings stereo_design(StereoMode mode) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.tau_px = 0.01;  // every post, whatever eye asks
    design.effects.stereo = {mode, 3, 90};
    design.effects.antialiasing = design::Antialiasing::off;  // it reads between pixels, where floats round the other way
    return design;
}

EffectState state_of(const HeadlessDisplay& headless, Effect effect) {
    for (const EffectRecord& noted : const_cast<HeadlessDisplay&>(headless).display().record().effects)
        if (noted.name.view() == effects::row_of(effect).name) return noted.state;
    return EffectState::skipped;
}

/// The hills from a free view, which has no symbology.
struct Hills {
    explicit Hills(const design::DesignSettings& design, std::uint32_t width = kWidth)
        : headless("egl", "desktop", width, kHeight, &bytes, design) {}
    std::vector<std::uint8_t> from(const terrain::View& view) {
        headless.display().planner().set_free_view(view);
        return test_support::settled_pixels(headless, state, test_support::kHillsNow);
    }
    test_support::MemoryBytes bytes{test_support::hills().image};
    HeadlessDisplay headless;
    flight::AircraftState state = test_support::aircraft_over_hills(1400, 30, -12);
};

terrain::View view_of(const design::DesignSettings& design) {
    design::DesignSettings mono = design;
    mono.effects.stereo.mode = StereoMode::none;
    Hills hills(mono);
    (void)test_support::settled_pixels(hills.headless, hills.state, test_support::kHillsNow);
    return hills.headless.display().planned().picture.camera.view;
}

TEST(DisplayDrawing, AnAnaglyphIsEachEyesOwnPictureInItsColors) {
    const design::DesignSettings design = stereo_design(StereoMode::anaglyph);
    Camera middle;
    middle.view = view_of(design);
    const std::uint32_t margin = eye_margin_px(design.view.horizontal_field_of_view_rad, kWidth);
    const StereoCameras pair = stereo_cameras(design.effects.stereo, middle.view.focal_px, middle.view.near_m, margin);
    ASSERT_GT(pair.base_m, 0.5);
    ASSERT_GT(pair.shift_px, 0);
    std::vector<std::uint8_t> both;
    {
        Hills stereo(design);
        both = stereo.from(middle.view);
        EXPECT_EQ(state_of(stereo.headless, Effect::stereo), EffectState::run);
    }
    design::DesignSettings mono = design;
    mono.effects.stereo.mode = StereoMode::none;
    int differs = 0;
    for (const EyeSide side : draw::kEyeSides) {
        Hills one(mono, kWidth + 2 * margin);
        const auto alone = one.from(camera_of(middle, pair, side, margin).view);
        const std::uint32_t begins = margin + static_cast<std::uint32_t>(side == EyeSide::left ? pair.shift_px : -pair.shift_px);
        for (std::size_t y = 0; y < kHeight; ++y)
            for (std::size_t x = 0; x < kWidth; ++x)
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    if ((channel == 0) != (side == EyeSide::left)) continue;
                    const auto seen = both[(y * kWidth + x) * 4 + channel];
                    const auto expected = alone[(y * (kWidth + 2 * margin) + x + begins) * 4 + channel];
                    differs += seen != expected ? 1 : 0;
                }
    }
    EXPECT_EQ(differs, 0);
}

TEST(DisplayDrawing, SideBySideHasSymbologyInBothHalves) {
    design::DesignSettings design = stereo_design(StereoMode::side_by_side);
    Hills stereo(design);
    const auto both = test_support::settled_pixels(stereo.headless, stereo.state, test_support::kHillsNow);
    std::size_t yellows[2] = {};  // of the aircraft symbol
    for (std::size_t y = 0; y < kHeight; ++y)
        for (std::size_t x = 0; x < kWidth; ++x) {
            const std::uint8_t* const p = both.data() + (y * kWidth + x) * 4;
            yellows[2 * x / kWidth] += p[0] > 200 && p[1] > 170 && p[2] < 60 ? 1u : 0u;
        }
    EXPECT_GT(yellows[0], 20u);
    EXPECT_NEAR(static_cast<double>(yellows[1]), static_cast<double>(yellows[0]), 0.1 * static_cast<double>(yellows[0]));
}

TEST(DisplayDrawing, FromFarAwayOnePictureServesBothEyes) {
    design::DesignSettings design = stereo_design(StereoMode::anaglyph);
    design.effects.stereo.base_m = 0.01;
    std::vector<std::uint8_t> one;
    {
        Hills stereo(design);
        one = test_support::settled_pixels(stereo.headless, stereo.state, test_support::kHillsNow);
        EXPECT_EQ(state_of(stereo.headless, Effect::stereo), EffectState::skipped);
    }
    design.effects.stereo.mode = StereoMode::none;
    Hills mono(design);
    const auto expected = test_support::settled_pixels(mono.headless, mono.state, test_support::kHillsNow);
    // A wider picture has other clip coordinates: floats round some edges and shades the other way.
    std::size_t differs = 0;
    for (std::size_t n = 0; n < one.size(); ++n) differs += std::abs(int{one[n]} - int{expected[n]}) > 1 ? 1u : 0u;
    EXPECT_LT(differs, one.size() / 500);
}

TEST(DisplayDrawing, StereoIsBuiltAtStartOrRefusedLater) {
    const design::DesignSettings with = stereo_design(StereoMode::anaglyph);
    design::DesignSettings without = with;
    without.effects.stereo.mode = StereoMode::none;
    {
        Hills mono(without);
        EXPECT_FALSE(mono.headless.display().set_design(with));
    }
    Hills stereo(with);
    EXPECT_FALSE(stereo.headless.display().set_design(without));
    EXPECT_TRUE(stereo.headless.display().set_design(stereo_design(StereoMode::side_by_side)));
}

int greatest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(int{a[n]} - int{b[n]}));
    return most;
}

/// The picture so long after kHillsNow.
std::vector<std::uint8_t> later(Hills& hills, double seconds) {
    const base::Time now = test_support::kHillsNow + base::Duration::from_seconds(seconds);
    hills.headless.display().plan({hills.state, {}, now});
    return test_support::drawn_pixels(hills.headless);
}

TEST(DisplayDrawing, ASceneFadesIntoTheNextDesigns) {
    design::DesignSettings before = stereo_design(StereoMode::none), after = before;
    before.effects.fade_s = after.effects.fade_s = 0.2;  // the aircraft's state is that of kHillsNow
    after.terrain.sea = after.terrain.unknown = {1, 2, 3};
    after.terrain.style.shade.ambient = 0.9 * after.terrain.style.shade.ambient;
    after.sky.haze_distance_m = 2000;
    const terrain::View view = view_of(before);
    Hills hills(before);
    const auto was = hills.from(view);
    EXPECT_EQ(state_of(hills.headless, Effect::cross_fade), EffectState::skipped) << "nothing has changed";
    ASSERT_TRUE(hills.headless.display().set_design(after));
    EXPECT_LE(greatest_difference(later(hills, 0.1), was), 1) << "it begins as it was";
    EXPECT_EQ(state_of(hills.headless, Effect::cross_fade), EffectState::run);
    const auto half = later(hills, 0.2), is = later(hills, 0.4);
    EXPECT_EQ(state_of(hills.headless, Effect::cross_fade), EffectState::skipped);
    EXPECT_GT(greatest_difference(was, is), 20) << "the designs differ";
    for (std::size_t n = 0; n < half.size(); ++n) ASSERT_NEAR(half[n], 0.5 * (was[n] + is[n]), 1.6);
    for (const EffectRecord& noted : hills.headless.display().record().effects) {
        if (noted.name.view() != "cross_fade") continue;
        EXPECT_EQ(noted.draws + noted.passes, 0u);
    }
    design::DesignSettings at_once = after;
    at_once.effects.fade_s = 0;
    at_once.sky.haze_distance_m = before.sky.haze_distance_m;
    ASSERT_TRUE(hills.headless.display().set_design(at_once));
    const auto next = later(hills, 0.45);
    EXPECT_EQ(next, later(hills, 0.5)) << "a design without a fade changes at once";
}

TEST(DisplayDrawing, ADeviceWithoutAPictureMoreShowsOneEye) {
    test_support::MemoryBytes bytes{test_support::hills().image};
    HeadlessDisplay small("egl", "es2-small", kWidth, kHeight, &bytes, stereo_design(StereoMode::anaglyph));
    (void)test_support::settled_pixels(small, test_support::aircraft_over_hills(1400), test_support::kHillsNow);
    EXPECT_EQ(state_of(small, Effect::stereo), EffectState::skipped);
}

}  // namespace
}  // namespace tedavis::display::test_frame_painter
