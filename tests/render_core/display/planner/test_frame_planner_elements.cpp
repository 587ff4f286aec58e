// That a display holds the budget of clutter in what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/support/perception/held_edges.hpp"
#include "tests/support/scene/map_scene.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_frame_planner_elements {
namespace {

using scene::LayerRole;
using test_support::HeadlessDisplay;

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr double kBudget = 0.08;

/// 1000 samples in the air ahead of the aircraft over the hills, and names on the ground.
const std::vector<std::uint8_t>& crowd() {
    static const std::vector<std::uint8_t> kBytes = [] {
        std::uint32_t state = 7;
        const auto next = [&] { return static_cast<double>((state = state * 1664525u + 1013904223u) >> 8) / (1u << 24); };
        host_sim::LayerDraft samples, places;
        samples.name = "samples";
        samples.role = LayerRole::sample;
        host_sim::AttributeDraft dose;
        dose.name = "dose";
        for (int n = 0; n < 1000; ++n) {
            samples.points.push_back(
                test_support::scene_point(47.01 + 0.07 * next(), 9.69 + 0.12 * next(), static_cast<float>(1100 + 1500 * next())));
            dose.values.push_back(static_cast<float>(next()));
        }
        samples.attributes = {dose};
        places.name = "places";
        places.role = LayerRole::place;
        for (int n = 0; n < 60; ++n) {
            places.points.push_back(test_support::scene_point(47.01 + 0.05 * next(), 9.7 + 0.06 * next(), std::nanf("")));
            places.names.push_back("Ort " + std::to_string(n));
        }
        return host_sim::sdb_bytes({"crowd", "a test", 1, {samples, places}});
    }();
    return kBytes;
}

design::DesignSettings design_with(double budget, double data = 0.5) {
    design::DesignSettings design = test_support::without_symbols(test_support::shipped_design("default"));
    design.data = {};
    design.foci = {};
    design.effects = {};
    design.warning_colors = false;
    design.priority = {};
    design.priority.is_stated = true;
    design.priority.weights.of[design::kDataAspect] = data;
    for (const double at : {0.0, 1.0}) EXPECT_TRUE(design.priority.data.knots.try_push_back({at, 1}));
    design.priority.clutter_budget = budget;
    design::DataElement spheres, names;
    spheres.role = LayerRole::sample;
    spheres.technique = design::DataTechnique::spheres;
    spheres.by_color.attribute = "dose";
    EXPECT_TRUE(spheres.by_color.scale.palette.stops.try_push_back({0, {255, 255, 80}}));
    EXPECT_TRUE(spheres.by_color.scale.palette.stops.try_push_back({1, {40, 0, 120}}));
    spheres.size_m = 150;
    names.role = LayerRole::place;
    names.technique = design::DataTechnique::billboard;
    EXPECT_TRUE(design.data.elements.try_push_back(spheres));
    EXPECT_TRUE(design.data.elements.try_push_back(names));
    return design;
}

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
        const Still without = shown(design_with(1), device), with = shown(design_with(kBudget), device);
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

effects::ClutterMap clutter_of(float measure) {
    effects::ClutterMap map;
    map.is_known = true;
    map.measure.fill(measure);
    return map;
}

/// What the painter measures enters as plain input; no picture is needed to plan all of them.
TEST(DisplayClutter, PlansAskForPicturesUntilTheBudgetIsHeld) {
    Shown one(design_with(kBudget));
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
    Shown one(design_with(kBudget));
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
    const Still without = shown(design_with(1)), with = shown(design_with(0.9));
    EXPECT_EQ(with.rgba, without.rgba);
    EXPECT_TRUE(with.record.clutter.measured.whole.is_known);
    EXPECT_FALSE(with.record.clutter.measured.least.is_known) << "nobody asks for it";
    EXPECT_NE(shown(design_with(kBudget)).rgba, without.rgba) << "control";
}

TEST(DisplayClutter, WhatComesFirstDoesNotGiveWayAndIsNotMeasured) {
    const Still without = shown(design_with(1, 1)), with = shown(design_with(kBudget, 1));
    EXPECT_EQ(with.rgba, without.rgba);
    EXPECT_FALSE(with.record.clutter.measured.whole.is_known);
    EXPECT_EQ(with.effect().reason.view(), "nothing is shown that gives way");
}

TEST(DisplayClutter, OnlyTheFirstFrameOfAnIntervalPaysForIt) {
    Shown one(design_with(kBudget));
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
    design::DesignSettings plain = design_with(1), edges = plain, regions = plain;
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
    design::DesignSettings stereo = design_with(kBudget);
    stereo.effects.stereo.mode = design::StereoMode::side_by_side;
    EXPECT_FALSE(shown(stereo).record.clutter.measured.whole.is_known);
    const design::DesignSettings possible = effects::possible_design(design_with(kBudget), test_support::shipped_device("sc2"));
    EXPECT_EQ(possible.priority.held_clutter(), 1) << "none is held";
    effects::PlanInput input;
    input[effects::Effect::clutter].kind = effects::EffectRequest::Kind::applicable;
    const effects::FramePlan plan = effects::plan_effects(input, test_support::shipped_device("sc2").capability);
    EXPECT_EQ(plan[effects::Effect::clutter].reason, "the device cannot copy what it has drawn");
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_elements
