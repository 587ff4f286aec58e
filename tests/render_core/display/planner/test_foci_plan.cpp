#include "render_core/display/planner/foci_plan.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/foci_of_test.hpp"
#include "tests/support/display/shown_elements.hpp"

namespace tedavis::display::test_foci_plan {
namespace {

using test_support::FociOfTest;

class FociPlans : public test_support::ShownElements {
protected:
    FrameRecord noted(const FociOfTest& foci) {
        elements_.set(&scene_.scene(), asked_);
        ElementFrame frame{ground_, frame_.view, {255, 0, 255}, flight::time_of_source(test_support::kNow)};
        frame.foci = &foci.frame();
        elements_.plan(frame);
        elements_.plan_signs(frame, {});
        FrameRecord record;
        record_foci(foci.plan, elements_, frame, record);
        return record;
    }
};

TEST(FociPlan, EachFocusHasItsPlaceInTheList) {
    FociOfTest foci(
        {R"(at = "own_ship")", R"(at = "place", place = "NOWHERE")", R"(at = "position", position_deg = [46.9, 9.9])"});
    ASSERT_EQ(foci.frame().regions.size(), 3u);
    EXPECT_TRUE(foci.region(0).is_valid);
    EXPECT_FALSE(foci.region(1).is_valid);
    EXPECT_TRUE(foci.region(2).is_valid);
    EXPECT_EQ(foci.plan.heights_m[0], 3000);
    EXPECT_EQ(foci.plan.heights_m[2], 600);
    EXPECT_EQ(foci.frame().least_degree, 0.5);
}

/// The same from any start: what came before is not asked.
TEST(FociPlan, IsOfTheFrameAlone) {
    FociOfTest one({R"(at = "own_ship", data.size = 0.5)"}), other({R"(at = "own_ship", data.size = 0.5)"});
    one.own_ship.position.latitude_rad += 0.01;
    one.plan_again();
    one.own_ship = other.own_ship;
    one.plan_again();
    EXPECT_EQ(draw::key_of(one.frame(), 0, false), draw::key_of(other.frame(), 0, false));
}

TEST_F(FociPlans, TheRecordCountsAndDerives) {
    ask_for("air", design::DataTechnique::spheres).by_color.attribute = "temperature";
    asked_[0].by_color.scale.palette = design::alpine_palette();
    const FociOfTest foci(
        {R"(name = "HERE", at = "position", position_deg = [46.5, 9.5], radius_m = 1000, context.width_m = 60_000)",
         R"(name = "WARM", shape = "data", layer = "air", attribute = "temperature", extreme = "highest", within = 1)",
         R"(name = "GONE", at = "place", place = "NOWHERE")"},
        &scene_.scene(), flight::time_of_source(test_support::kNow));
    const FrameRecord record = noted(foci);
    ASSERT_EQ(record.foci.size(), 3u);
    const FocusRecord &here = record.foci[0], &warm = record.foci[1], &gone = record.foci[2];
    EXPECT_EQ(here.name.view(), "HERE");
    EXPECT_EQ(here.in_focus + here.intermediate + here.context, 12u) << "posts";
    EXPECT_EQ(here.in_focus, 1u);
    ASSERT_EQ(here.values.size(), 1u);
    EXPECT_EQ(here.values[0].count, 2u) << "on two levels";
    EXPECT_LT(here.values[0].low, here.values[0].high);
    EXPECT_NEAR(base::degrees(here.latitude_rad), 46.5, 1e-6);
    EXPECT_LE(warm.low, warm.high);
    EXPECT_EQ(warm.in_focus + warm.intermediate + warm.context, 24u) << "values";
    EXPECT_GT(warm.in_focus, 0u);
    EXPECT_FALSE(gone.is_shown);
    EXPECT_NE(gone.reason.view().find("no feature"), std::string_view::npos);
    EXPECT_EQ(gone.sight.view(), "nowhere");
}

TEST_F(FociPlans, SolidsStepBackAndComeAgain) {
    host_sim::SceneDraft draft;
    ask_for("huts", design::DataTechnique::solid);
    const FociOfTest here(
        {R"(at = "position", position_deg = [46.8, 9.8], radius_m = 1000, context.width_m = 0, data.context = "hidden")"});
    const FociOfTest none({R"(at = "position", position_deg = [46.8, 9.8], radius_m = 1000, terrain.brightness = 0.5)"});
    static_cast<void>(noted(none));
    EXPECT_EQ(elements_.reports()[0].count.drawn, 2u);
    static_cast<void>(noted(here));
    EXPECT_EQ(elements_.reports()[0].count.drawn, 1u) << "the other one is 13 km away";
    EXPECT_EQ(elements_.reports()[0].count.hidden, 1u);
    static_cast<void>(noted(none));
    EXPECT_EQ(elements_.reports()[0].count.drawn, 2u);
}

}  // namespace
}  // namespace tedavis::display::test_foci_plan
