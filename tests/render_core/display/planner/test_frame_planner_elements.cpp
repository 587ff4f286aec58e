// That a display holds the budget of clutter in what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/render_core/display/planner/crowd_of_data.hpp"
#include "tests/support/perception/held_edges.hpp"

namespace tedavis::display::test_frame_planner_elements {
namespace {

using scene::LayerRole;
using test_support::clutter_of;
using test_support::crowd;
using test_support::crowd_design;
using test_support::HeadlessDisplay;

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr double kBudget = 0.08;

/// What a display showed, which is no more: one at a time.
struct Still {
    std::vector<std::uint8_t> rgba;  ///< bottom row first
    std::vector<double> densities;   ///< of regions, from the upper left; the processor's
    FrameRecord record;
    std::uint32_t denied = 0;
    [[nodiscard]] std::uint32_t glyphs() const {
        for (const DataRecord& one : record.data)
            if (one.type.view() == "sample") return one.drawn;
        return 0;
    }
    [[nodiscard]] EffectRecord effect() const {
        for (const EffectRecord& one : record.effects)
            if (one.name.view() == "clutter") return one;
        return {};
    }
};

/// A still picture, as `shot` makes it.
struct Shown {
    explicit Shown(const design::DesignSettings& design, const char* device = "es3-mid")
        : display("egl", device, kWidth, kHeight, &terrain, design, test_support::as_it_is, &scene) {
        show();
    }
    void show() {
        settle(display.display(), {state, {}, test_support::kHillsNow});
        display.display().plan({state, {}, test_support::kHillsNow});
        rgba = test_support::drawn_pixels(display);
    }
    /// From the upper left; the processor's.
    [[nodiscard]] std::vector<double> densities() const {
        constexpr std::ptrdiff_t kRow = std::ptrdiff_t{4} * kWidth;
        const std::uint8_t* const top = rgba.data() + kRow * (kHeight - 1);
        test_support::HeldEdges held(kWidth, kHeight);
        const std::vector<std::uint8_t> edges = held.of({top, kWidth, kHeight, 4, -kRow});
        std::vector<double> found(48);
        EXPECT_TRUE(perception::region_densities({edges, kWidth, kHeight}, {}, found));
        return found;
    }
    [[nodiscard]] Still still() {
        return {rgba, densities(), display.display().record(), static_cast<std::uint32_t>(display.display().gl().denied().total)};
    }

    test_support::MemoryBytes terrain{test_support::hills().image}, scene{crowd()};
    flight::AircraftState state = test_support::aircraft_over_hills(1500, 40);
    HeadlessDisplay display;
    std::vector<std::uint8_t> rgba;
};

Still shown(const design::DesignSettings& design, const char* device = "es3-mid") { return Shown(design, device).still(); }

TEST(DisplayClutter, EveryRegionIsWithinTheBudgetOrAsCalmAsItCanBe) {
    for (const char* const device : {"es3-mid", "es2-small"}) {
        const Still without = shown(crowd_design(1), device), with = shown(crowd_design(kBudget), device);
        const ClutterRecord& clutter = with.record.clutter;
        ASSERT_TRUE(clutter.measured.whole.is_known && clutter.measured.least.is_known && clutter.reached.is_known);
        int beyond = 0, decluttered = 0;
        double free_excess = 0, held_excess = 0;
        for (std::size_t n = 0; n < without.densities.size(); ++n) {
            const double free = without.densities[n], held = with.densities[n];
            const double can_be = std::max(kBudget, static_cast<double>(clutter.measured.least.measure[n]) + 0.03);
            EXPECT_NEAR(static_cast<double>(clutter.measured.whole.measure[n]), free, 0.03) << "but for long faint edges";
            EXPECT_NEAR(static_cast<double>(clutter.reached.measure[n]), held, 0.03) << "what is shown has been measured";
            free_excess += std::max(free - can_be, 0.0);
            held_excess += std::max(held - can_be, 0.0);
            beyond += free > kBudget + 0.03 ? 1 : 0;
            decluttered += clutter.left.factor[n] < 1 ? 1 : 0;
        }
        EXPECT_LT(held_excess, kBudget + 0.03) << device << ": of all regions together";
        EXPECT_GT(free_excess, 1) << "control";
        EXPECT_GT(beyond, 3) << "control: without a budget there is more";
        EXPECT_GT(decluttered, 3);
        EXPECT_LT(with.glyphs(), without.glyphs());
        EXPECT_GT(with.record.labels.decluttered, 0u);
        EXPECT_EQ(without.record.labels.decluttered, 0u);
        EXPECT_EQ(clutter.roles, 1u << static_cast<unsigned>(LayerRole::sample) | 1u << static_cast<unsigned>(LayerRole::place));
        EXPECT_EQ(with.denied, 0u);
    }
}

/// What the painter measures enters as plain input; no picture is needed to plan all of them.
TEST(DisplayClutter, PlansAskForPicturesUntilTheBudgetIsHeld) {
    Shown one(crowd_design(kBudget));
    const auto frame = std::make_unique<PlannedFrame>();
    const flight::FrameInput input{one.state, {}, test_support::kHillsNow + base::Duration::from_seconds(0.5)};
    FramePlanner& planner = one.display.display().planner();
    PlannerMemory before = one.display.display().memory();
    before.cut();
    PlannerMemory memory = before;
    planner.plan(input, memory, *frame);
    EXPECT_TRUE(memory.must_be_drawn());
    ASSERT_EQ(frame->clutter.probe, Probe::shown) << "nothing has given way yet";
    planner.plan_again({false, clutter_of(0.5F)}, memory, *frame);
    ASSERT_EQ(frame->clutter.probe, Probe::hidden);
    EXPECT_EQ(frame->declutter.regions.factor, effects::least_detail().factor);
    planner.plan_again({false, clutter_of(0)}, memory, *frame);
    ASSERT_EQ(frame->clutter.probe, Probe::hidden) << "something between may be enough";
    planner.plan_again({false, clutter_of(0.01F)}, memory, *frame);
    EXPECT_EQ(frame->clutter.probe, Probe::none);
    EXPECT_FALSE(frame->declutter.regions.is_whole());
    // Control: what is within the budget asks for no other picture.
    memory = before;
    planner.plan(input, memory, *frame);
    planner.plan_again({false, clutter_of(0.01F)}, memory, *frame);
    EXPECT_EQ(frame->clutter.probe, Probe::none);
    EXPECT_TRUE(frame->declutter.regions.is_whole());
}

TEST(DisplayClutter, TerrainThatFailsEndsTheProbes) {
    Shown one(crowd_design(kBudget));
    const auto frame = std::make_unique<PlannedFrame>();
    PlannerMemory memory = one.display.display().memory();
    FramePlanner& planner = one.display.display().planner();
    planner.plan({one.state, {}, test_support::kHillsNow + base::Duration::from_seconds(0.5)}, memory, *frame);
    ASSERT_NE(frame->clutter.probe, Probe::none);
    planner.plan_again({true, {}}, memory, *frame);
    EXPECT_FALSE(frame->decisions.show_terrain);
    EXPECT_EQ(frame->clutter.probe, Probe::none) << "without terrain no data are shown";
}

/// Pictures that are drawn to be measured leave no trace.
TEST(DisplayClutter, ABudgetThatIsNeverReachedChangesNothing) {
    const Still without = shown(crowd_design(1)), with = shown(crowd_design(0.9));
    EXPECT_EQ(with.rgba, without.rgba);
    EXPECT_TRUE(with.record.clutter.measured.whole.is_known);
    EXPECT_FALSE(with.record.clutter.measured.least.is_known) << "nobody asks for it";
    EXPECT_NE(shown(crowd_design(kBudget)).rgba, without.rgba) << "control";
}

TEST(DisplayClutter, WhatComesFirstDoesNotGiveWayAndIsNotMeasured) {
    const Still without = shown(crowd_design(1, 1)), with = shown(crowd_design(kBudget, 1));
    EXPECT_EQ(with.rgba, without.rgba);
    EXPECT_FALSE(with.record.clutter.measured.whole.is_known);
    EXPECT_EQ(with.effect().reason.view(), "nothing is shown that gives way");
}

TEST(DisplayClutter, OnlyTheFirstFrameOfAnIntervalPaysForIt) {
    Shown one(crowd_design(kBudget));
    const auto passes = [&](double seconds) {
        one.display.display().plan({one.state, {}, test_support::kHillsNow + base::Duration::from_seconds(seconds)});
        static_cast<void>(test_support::drawn_pixels(one.display));
        return one.still().effect().passes;
    };
    EXPECT_EQ(passes(0.1), 0u);
    EXPECT_GT(passes(0.5), 2u);
    EXPECT_EQ(passes(0.6), 0u);
}

TEST(DisplayClutter, ItsViewsLieOverThePicture) {
    design::DesignSettings plain = crowd_design(1), edges = plain, regions = plain;
    edges.effects.clutter = design::ClutterView::edges;
    regions.effects.clutter = design::ClutterView::regions;
    EXPECT_NE(shown(regions).rgba, shown(plain).rgba);
    const std::vector<std::uint8_t> lines = shown(edges).rgba;
    std::size_t white = 0, between = 0;
    for (std::size_t n = 0; n < lines.size(); n += 4) {
        white += lines[n] == 255 ? 1 : 0;
        between += lines[n] != 255 && lines[n] != 0 ? 1 : 0;
    }
    EXPECT_GT(white, 1000u);
    EXPECT_EQ(between, 0u) << "edges, and nothing else";
}

/// A stereo pair has no regions of its own; sc2 cannot copy its picture.
TEST(DisplayClutter, WhereItCannotBeMeasuredItSaysSo) {
    design::DesignSettings stereo = crowd_design(kBudget);
    stereo.effects.stereo.mode = design::StereoMode::side_by_side;
    EXPECT_FALSE(shown(stereo).record.clutter.measured.whole.is_known);
    const design::DesignSettings possible = effects::possible_design(crowd_design(kBudget), test_support::shipped_device("sc2"));
    EXPECT_EQ(possible.priority.held_clutter(), 1) << "none is held";
    effects::PlanInput input;
    input[effects::Effect::clutter].kind = effects::EffectRequest::Kind::applicable;
    const effects::FramePlan plan = effects::plan_effects(input, test_support::shipped_device("sc2").capability);
    EXPECT_EQ(plan[effects::Effect::clutter].reason, "the device cannot copy what it has drawn");
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_elements
