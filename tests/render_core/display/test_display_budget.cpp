// What a display shows while a deadline is held.
#include <gtest/gtest.h>

#include "render_core/display/preroll.hpp"
#include "render_core/effects/calibration.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/flights/six_levels.hpp"

namespace tedavis::display::test_display_budget {
namespace {

using effects::Effect;
using test_support::aircraft_over_hills;
using test_support::has_flag;
using test_support::hills_picture;
using test_support::HillsPicture;
using test_support::OverHills;

/// Nothing but triangles costs anything.
effects::CostTable costs_of_triangles() {
    effects::CostTable costs;
    costs.is_known = true;
    costs[Effect::terrain].ms_per_thousand = 1;
    return costs;
}

/// From where the hills need not be drawn to the last post.
flight::AircraftState high() { return aircraft_over_hills(9000, 30, -20); }

const EffectRecord* effect_of(const FrameRecord& record, std::string_view name) {
    for (const EffectRecord& effect : record.effects)
        if (effect.name.view() == name) return &effect;
    return nullptr;
}

TEST(DisplayBudget, WithoutADeadlineNothingChangesAndTheRecordSaysSo) {
    OverHills over;
    const HillsPicture before = hills_picture(over.display, aircraft_over_hills(1500));
    over.display.display().memory().budget.hold(0, costs_of_triangles(), test_support::six_levels());
    EXPECT_EQ(hills_picture(over.display, aircraft_over_hills(1500)), before);
    const GovernorRecord& governor = over.display.display().record().governor;
    EXPECT_EQ(governor.why.view(), "no deadline is set");
    EXPECT_DOUBLE_EQ(governor.predicted_ms, over.display.display().planned().counters.triangles / 1000);
    over.display.display().memory().budget.hold(0.001, {}, test_support::six_levels());
    EXPECT_EQ(hills_picture(over.display, aircraft_over_hills(1500)), before) << "it rests where costs are not known";
    EXPECT_EQ(over.display.display().record().governor.why.view(), "the cost is not known: calibrate this device");
}

TEST(DisplayBudget, AScarceDeadlineCoarsensTheTerrainButTakesNoWarningColors) {
    OverHills over;
    over.show_bands();
    display::Display& display = over.display.display();
    static_cast<void>(hills_picture(over.display, high()));
    const double whole = display.planned().counters.triangles;
    const double tau_px = display.record().terrain.tau_px;
    display.memory().budget.hold(0.8 * whole / 1000, costs_of_triangles(), test_support::six_levels());
    const HillsPicture reduced = hills_picture(over.display, high());
    const FrameRecord& record = display.record();
    EXPECT_GT(record.governor.quality_level, 0u);
    EXPECT_GT(record.terrain.tau_px, tau_px);
    EXPECT_LE(record.terrain.worst_error_px, 4) << "degraded terrain would lose its warning colours";
    EXPECT_LT(display.planned().counters.triangles, 0.8 * whole);
    EXPECT_FALSE(has_flag(over.display, "deadline.missed"));
    EXPECT_FALSE(has_flag(over.display, "terrain.coarse"));
    ASSERT_NE(effect_of(record, "warning_colors"), nullptr);
    EXPECT_EQ(effect_of(record, "warning_colors")->state, EffectState::run);
    EXPECT_EQ(hills_picture(over.display, high()), reduced) << "the same instant is the same picture";
}

TEST(DisplayBudget, WhereNothingSufficesItSaysSoAndGivesUpSilhouettes) {
    OverHills over;
    display::Display& display = over.display.display();
    display.memory().budget.hold(0.001, costs_of_triangles(), test_support::six_levels());
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(1500)));
    const FrameRecord& record = display.record();
    EXPECT_EQ(record.governor.quality_level, 4u) << "the last level has as many triangles";
    EXPECT_EQ(record.governor.tau_factor, 4);
    EXPECT_TRUE(record.governor.given_up.has(Effect::silhouettes));
    EXPECT_EQ(record.governor.why.view(), "the cheapest picture is too dear");
    EXPECT_TRUE(has_flag(over.display, "deadline.missed"));
    const EffectRecord* const silhouettes = effect_of(record, "silhouettes");
    ASSERT_NE(silhouettes, nullptr) << "the test's design asks for them";
    EXPECT_EQ(silhouettes->state, EffectState::skipped);
    EXPECT_EQ(silhouettes->reason.view(), "the time does not suffice");
}

TEST(DisplayBudget, TheDisplaySaysItWhereTheDesignAsks) {
    OverHills over;
    display::Display& display = over.display.display();
    display.memory().budget.hold(0.001, costs_of_triangles(), test_support::six_levels());
    const HillsPicture quiet = hills_picture(over.display, aircraft_over_hills(1500));
    design::DesignSettings design = test_support::shipped_design("default");
    design.effects.fade_s = 0;  // time stands still here
    design.degradation.show_reduced = false;
    ASSERT_TRUE(display.set_design(design));
    const HillsPicture without = hills_picture(over.display, aircraft_over_hills(1500));
    design.degradation.show_reduced = true;
    ASSERT_TRUE(display.set_design(design));
    EXPECT_NE(hills_picture(over.display, aircraft_over_hills(1500)), without);
    display.memory().budget.hold(0, {});
    const HillsPicture whole = hills_picture(over.display, aircraft_over_hills(1500));
    design.degradation.show_reduced = false;
    ASSERT_TRUE(display.set_design(design));
    EXPECT_EQ(hills_picture(over.display, aircraft_over_hills(1500)), whole) << "nothing is reduced, nothing is said";
}

}  // namespace
}  // namespace tedavis::display::test_display_budget
