// The governor over a synthetic flight whose costs are simulated: what it holds, and what it would not without hysteresis.
#include "render_core/effects/frame_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/support/files/hard_case.hpp"
#include "tests/support/flights/six_levels.hpp"

namespace tedavis::effects::test_frame_budget {
namespace {

using Kind = EffectRequest::Kind;

base::Time at(double seconds) { return base::Time{} + base::Duration::from_seconds(seconds); }

/// With 250,000 triangles, 4000 glyphs and everything on: 80 ms.
CostTable simulated_costs() {
    CostTable table;
    table.is_known = true;
    table[Overhead::frame] = {1, 1, 0};
    table[Effect::terrain] = {0.5, 0.5, 0.1};
    table[Effect::warning_colors] = {0, 0.5, 0};
    table[Effect::silhouettes] = {0, 16, 0};
    table[Effect::haze] = {0, 0.5, 0};
    table[Overhead::elements] = {0.2, 0, 4};
    table[Overhead::glyphs] = {0.3, 0, 9.5};
    return table;
}

/// Of a scene with much in view; with little, as from far above, forms and distances call for nothing.
PlanInput called(double load) {
    PlanInput input;
    input[Effect::terrain] = input[Effect::warning_colors] = {Kind::applicable, ""};
    const Kind kind = load > 0.15 ? Kind::applicable : Kind::not_applicable;
    input[Effect::silhouettes] = input[Effect::haze] = {kind, ""};
    return input;
}

constexpr double kMegapixels = 1024 * 768 / 1e6;
constexpr TerrainTolerance kTolerance{1, 4};

/// How much there is in view at the design's own quality, 1: 80 ms.
FrameCounters counters_of(double load) {
    FrameCounters counters;
    counters.megapixels = kMegapixels;
    counters.triangles = 250'000 * load;
    counters.glyphs = 4000 * load;
    counters.elements = 300 * load;
    return counters;
}

/// What a scene does to them at another quality: with another power than the model believes.
FrameCounters drawn_at(FrameCounters counters, double tau_px, double detail) {
    counters.triangles *= std::pow(tau_px, -0.75);
    counters.glyphs *= std::pow(8, -2 * (1 - detail));
    return counters;
}

/// Six minutes: calm, a jump, ramps, oscillation round the limit at several periods, noise.
double load_at(double t) {
    const double noise = 1 + 0.02 * std::sin(917 * t) * std::sin(311 * t);
    const auto between = [&](double from_s, double to_s) { return t >= from_s && t < to_s; };
    double load = 0.1;
    if (between(20, 60)) load = 1;                           // a jump to 80 ms and back
    if (between(80, 100)) load = 0.1 + 0.9 * (t - 80) / 20;  // a ramp
    if (between(100, 120)) load = 1;
    if (between(120, 140)) load = 1 - 0.9 * (t - 120) / 20;
    if (between(150, 180)) load = 0.3 + 0.18 * std::sin(2 * M_PI * t / 0.7);  // round the limit, quickly
    if (between(180, 210)) load = 0.3 + 0.2 * std::sin(2 * M_PI * t / 3);     // less quickly
    if (between(210, 260)) load = 0.3 + 0.25 * std::sin(2 * M_PI * t / 11);   // slowly
    if (between(270, 300)) load = std::fmod(t, 6) < 3 ? 1 : 0.1;              // jumps to and fro
    if (between(310, 340)) load = 0.9;
    return load * noise;
}

struct Flown {
    int frames = 0, within = 0, changes = 0;
    double shortest_s = 1e9;       ///< between two changes
    double dearest_design_ms = 0;  ///< what the design's own picture would cost
    std::vector<std::size_t> quality_levels;
    [[nodiscard]] double share() const { return static_cast<double>(within) / frames; }
};

/// The simulated machine draws what the planned frame has; the terrain and the glyphs are those of the quality level before.
Flown fly(double deadline_ms, const GovernorSettings& settings = {}, double first_s = 0) {
    FrameBudget budget;
    budget.hold(deadline_ms, simulated_costs(), test_support::six_levels(), settings);
    Flown flown;
    double last_change_s = -1e9;
    constexpr double kRate_hz = 30;
    for (int n = static_cast<int>(first_s * kRate_hz); n < 360 * kRate_hz; ++n) {
        const double t = n / kRate_hz;
        const PlanInput calls = called(load_at(t));
        const FrameCounters asked = counters_of(load_at(t));
        const FrameCounters drawn = drawn_at(asked, budget.tau_factor(kTolerance), budget.detail_factor());
        const FramePlan plan = budget.plan(calls, {}, drawn, kTolerance, at(t));
        const double ms = modelled_ms(simulated_costs(), plan, drawn);
        EXPECT_DOUBLE_EQ(ms, budget.report().predicted_ms);
        flown.within += ms <= deadline_ms ? 1 : 0;
        flown.dearest_design_ms =
            std::fmax(flown.dearest_design_ms, modelled_ms(simulated_costs(), plan_effects(calls, {}), asked));
        ++flown.frames;
        flown.quality_levels.push_back(budget.report().quality_level);
        if (!budget.report().changed) continue;
        ++flown.changes;
        flown.shortest_s = std::fmin(flown.shortest_s, t - last_change_s);
        last_change_s = t;
    }
    return flown;
}

TEST(FrameBudgetFlight, HoldsDeadlinesOnASceneOf80Milliseconds) {
    double shortest_s = 1e9;
    for (const double deadline_ms : {33.0, 16.0}) {
        const Flown flown = fly(deadline_ms);
        shortest_s = std::fmin(shortest_s, flown.shortest_s);
        std::printf("%.0f ms: %.2f %% of frames within, %d changes, %.2f s the least between two\n", deadline_ms,
                    100 * flown.share(), flown.changes, flown.shortest_s);
        EXPECT_GE(flown.dearest_design_ms, 79);
        EXPECT_GE(flown.share(), 0.99) << deadline_ms;
        EXPECT_GE(flown.shortest_s, 2 - 1e-9) << deadline_ms;
        EXPECT_GE(flown.changes, 6) << "it also comes back";
        EXPECT_GT(std::count(flown.quality_levels.begin(), flown.quality_levels.end(), 0u), flown.frames / 8)
            << "calm times have the whole picture";
    }
    test_support::record_worst("A60", shortest_s);
}

/// Without a budget the flight's deadlines are broken: the scene is what the test says.
TEST(FrameBudgetFlight, TheDesignsOwnPictureWouldNotHoldThem) {
    const Flown flown = fly(1e9);
    EXPECT_EQ(flown.changes, 0);
    EXPECT_EQ(flown.within, flown.frames);
    GovernorSettings never;
    never.act_at = 1e9;
    EXPECT_LT(fly(33, never).share(), 0.7);
}

TEST(FrameBudgetFlight, WithoutHysteresisDeadlinesAreMissed) {
    GovernorSettings none;
    none.act_at = none.aim_at = none.relax_at = 1;
    none.most_patience = 1;
    EXPECT_LT(std::fmin(fly(33, none).share(), fly(16, none).share()), 0.99);
    EXPECT_GT(fly(33, none).changes, fly(33).changes);
}

TEST(FrameBudgetFlight, WithoutDwellItChangesMoreOften) {
    GovernorSettings none;
    none.dwell = {};
    const Flown without = fly(33, none);
    EXPECT_GT(without.changes, 3 * fly(33).changes);
    EXPECT_LT(without.shortest_s, 0.5);
    test_support::record_control("A60", without.shortest_s);
}

TEST(FrameBudgetFlight, IsDeterministic) { EXPECT_EQ(fly(33).quality_levels, fly(33).quality_levels); }

/// A replay that restores the governor goes on as the whole run did, wherever it begins.
TEST(FrameBudget, RestoredItGoesOnAlike) {
    FrameBudget whole, part;
    whole.hold(33, simulated_costs(), test_support::six_levels());
    part.hold(33, simulated_costs(), test_support::six_levels());
    const auto plan = [](FrameBudget& budget, double t) {
        const FrameCounters drawn = drawn_at(counters_of(load_at(t)), budget.tau_factor(kTolerance), budget.detail_factor());
        static_cast<void>(budget.plan(called(load_at(t)), {}, drawn, kTolerance, at(t)));
        return budget.report();
    };
    for (int n = 0; n < 1800; ++n) static_cast<void>(plan(whole, n / 30.0));
    part.restore(whole.history());
    for (int n = 1800; n < 6000; ++n) {
        const BudgetReport one = plan(whole, n / 30.0), other = plan(part, n / 30.0);
        ASSERT_EQ(one.quality_level, other.quality_level) << n;
        ASSERT_EQ(one.predicted_ms, other.predicted_ms);
    }
}

TEST(FrameBudget, RestsWithoutDeadlineAndWithoutCosts) {
    FrameBudget budget;
    const FrameCounters much = counters_of(10);
    FramePlan plan = budget.plan(called(1), {}, much, kTolerance, at(1));
    EXPECT_TRUE(plan.runs(Effect::silhouettes));
    EXPECT_EQ(budget.report().why, GovernorWhy::no_deadline);
    EXPECT_EQ(budget.report().predicted_ms, 0);
    budget.hold(16, CostTable{});
    plan = budget.plan(called(1), {}, much, kTolerance, at(2));
    EXPECT_TRUE(plan.runs(Effect::silhouettes));
    EXPECT_EQ(budget.report().why, GovernorWhy::cost_unknown);
    EXPECT_FALSE(budget.report().is_missed) << "nobody knows";
    EXPECT_EQ(budget.tau_factor(kTolerance), 1);
    budget.hold(0, simulated_costs());
    static_cast<void>(budget.plan(called(1), {}, much, kTolerance, at(3)));
    EXPECT_EQ(budget.report().why, GovernorWhy::no_deadline);
    EXPECT_GT(budget.report().predicted_ms, 100) << "known costs are said";
}

/// Costs are those at the design's own error: at a coarser level triangles would seem cheap.
TEST(FrameBudget, ChoosesTheRendererByTheCostsOfTheDesignsOwnError) {
    FrameBudget budget;
    const auto choose = [&](double seconds, double triangles) {
        FrameCounters counters;
        counters.megapixels = 2;
        counters.triangles = triangles;
        return budget.choose_renderer(at(seconds), 0, counters, kTolerance, TriangleFit::exact_enough);
    };
    budget.hold(40, simulated_costs());
    EXPECT_FALSE(budget.knows_rays());
    EXPECT_FALSE(choose(0, 3000).costs.is_known);
    CostTable table = simulated_costs();
    table[Overhead::rays] = {0, 7, 0};
    budget.hold(40, table);
    EXPECT_TRUE(budget.knows_rays());
    const RendererCosts costs = choose(1, 3000).costs;
    EXPECT_TRUE(costs.is_known);
    EXPECT_DOUBLE_EQ(costs.triangles_ms, 0.5 + 2 * 0.5 + 0.3);
    EXPECT_DOUBLE_EQ(costs.rays_ms, 14);
    EXPECT_DOUBLE_EQ(costs.frame_ms, 1 + 2);
    EXPECT_EQ(costs.deadline_ms, 40);
    EXPECT_FALSE(choose(1, 3000).by_rays);
    EXPECT_TRUE(choose(0.5, 300'000).by_rays) << "an earlier time: decided at once";
    QualityLevels coarse = test_support::six_levels();
    budget.hold(40, table, coarse);
    budget.restore({FrameGovernor(coarse.count - 1u), {}});
    EXPECT_GT(choose(2, 60'000).costs.triangles_ms, 0.5 + 2 * 0.5 + 6) << "more triangles would be needed";
    budget.hold(40, table);
    EXPECT_FALSE(choose(0.1, 3000).by_rays) << "nothing is left of what was held before";
}

TEST(FrameBudget, GivesUpOnlyWhatItMayAndSaysWhy) {
    FrameBudget budget;
    budget.hold(1, simulated_costs(), test_support::six_levels());
    const FramePlan plan = budget.plan(called(1), {}, counters_of(1), kTolerance, at(0));
    EXPECT_EQ(budget.report().quality_level, kQualityLevelCount - 1);
    EXPECT_TRUE(budget.report().is_missed);
    EXPECT_EQ(plan[Effect::silhouettes].reason, "the time does not suffice");
    EXPECT_EQ(plan[Effect::silhouettes].state, PlanState::skipped) << "ridges are not in reserve";
    EXPECT_TRUE(plan.runs(Effect::haze));
    EXPECT_TRUE(plan.runs(Effect::terrain));
    EXPECT_TRUE(plan.runs(Effect::warning_colors));
    EXPECT_EQ(budget.tau_factor(kTolerance), 4);
    EXPECT_TRUE(budget.is_reduced());
}

TEST(FrameBudget, ADeadlineWithRoomHasTheDesignsOwnPictureAllAlong) {
    const Flown flown = fly(200);
    EXPECT_EQ(flown.changes, 0);
    for (const std::size_t level : flown.quality_levels) ASSERT_EQ(level, 0u);
    EXPECT_GT(fly(33).changes, 0) << "control";
}

TEST(FrameBudget, APinnedLevelIsDrawnUntilADeadlineIsHeld) {
    FrameBudget budget;
    const QualityLevel last = test_support::six_levels().at[5];
    budget.pin(last);
    const FramePlan plan = budget.plan(called(1), {}, counters_of(1), kTolerance, at(0));
    EXPECT_EQ(plan[Effect::silhouettes].state, PlanState::skipped);
    EXPECT_EQ(budget.tau_factor(kTolerance), last.tau_factor);
    EXPECT_EQ(budget.detail_factor(), last.detail_factor);
    EXPECT_TRUE(budget.gives_up(Effect::silhouettes));
    budget.hold(0, {});
    EXPECT_TRUE(budget.plan(called(1), {}, counters_of(1), kTolerance, at(1)).runs(Effect::silhouettes));
    EXPECT_EQ(budget.tau_factor(kTolerance), 1);
}

/// Only the measured levels are there to choose from.
TEST(FrameBudget, WithoutMeasuredLevelsNothingIsReduced) {
    FrameBudget budget;
    budget.hold(1, simulated_costs());
    const FramePlan plan = budget.plan(called(1), {}, counters_of(1), kTolerance, at(0));
    EXPECT_TRUE(plan.runs(Effect::silhouettes));
    EXPECT_EQ(budget.report().quality_level, 0u);
    EXPECT_EQ(budget.report().why, GovernorWhy::cheapest_is_too_dear);
    EXPECT_TRUE(budget.report().is_missed);
    EXPECT_FALSE(budget.is_reduced());
}

TEST(FrameBudget, TheReportSaysWhatTheLevelIs) {
    FrameBudget budget;
    const QualityLevels levels = test_support::six_levels();
    budget.hold(33, simulated_costs(), levels);
    static_cast<void>(budget.plan(called(1), {}, counters_of(1), kTolerance, at(0)));
    const BudgetReport& report = budget.report();
    ASSERT_GT(report.quality_level, 0u);
    EXPECT_EQ(report.quality.tau_factor, levels.at[report.quality_level].tau_factor);
    EXPECT_EQ(report.quality.detail_factor, levels.at[report.quality_level].detail_factor);
    EXPECT_TRUE(report.quality.given_up.has(Effect::depth_of_field));
}

TEST(FrameBudget, AMachineThatNeedsMoreThanTheModelSaysIsBelieved) {
    FrameBudget budget;
    budget.hold(20, simulated_costs(), test_support::six_levels());
    const auto frame = [&](double t) { static_cast<void>(budget.plan(called(0.05), {}, counters_of(0.05), kTolerance, at(t))); };
    frame(0);
    const double modelled = budget.report().predicted_ms;
    EXPECT_EQ(budget.report().quality_level, 0u);
    budget.record_measured(5 * modelled);
    frame(0.03);
    EXPECT_EQ(budget.report().quality_level, 0u) << "one late frame is no trend";
    for (int n = 2; n < 60; ++n) {
        budget.record_measured(3 * modelled);
        frame(n * 0.03);
    }
    EXPECT_GT(budget.report().quality_level, 0u);
    const std::size_t reduced = budget.report().quality_level;
    budget.record_measured(19);
    frame(1.9);
    EXPECT_EQ(budget.report().quality_level, reduced) << "it may have waited for the screen";
    budget.record_measured(std::nan(""));
    frame(2);
    EXPECT_TRUE(std::isfinite(budget.report().predicted_ms));
}

}  // namespace
}  // namespace tedavis::effects::test_frame_budget
