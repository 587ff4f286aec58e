// That a display holds the budget of clutter in what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "render_core/gl/program.hpp"
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
        : display("egl", device_of(device), kWidth, kHeight, &terrain, design, test_support::as_it_is, &scene) {
        show();
    }
    /// A device without a compiler gets one: its programs come from text here, its calls are its own.
    static effects::DeviceSettings device_of(const char* name) {
        effects::DeviceSettings device = test_support::shipped_device(name);
        if (!gl::has_compiler(device.capability)) device.capability = gl::with_compiler(device.capability);
        return device;
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
    for (const char* const device : {"es3-mid", "es2-small", "sc2"}) {
        const Still without = shown(crowd_design(1), device), with = shown(crowd_design(kBudget), device);
        const ClutterRecord& clutter = with.record.clutter;
        ASSERT_TRUE(clutter.measured.whole.is_known && clutter.measured.least.is_known && clutter.reached.is_known);
        int beyond = 0, decluttered = 0;
        double free_excess = 0, held_excess = 0;
        for (std::size_t n = 0; n < without.densities.size(); ++n) {
            const double free = without.densities[n], held = with.densities[n];
            const double can_be = std::max(kBudget, static_cast<double>(clutter.measured.least.measure[n]) + effects::kMinUse);
            EXPECT_EQ(clutter.measured.whole.measure[n], static_cast<float>(free)) << device << " region " << n;
            EXPECT_EQ(clutter.reached.measure[n], static_cast<float>(held)) << "what is shown has been measured";
            free_excess += std::max(free - can_be, 0.0);
            held_excess += std::max(held - can_be, 0.0);
            beyond += free > kBudget ? 1 : 0;
            decluttered += clutter.left.factor[n] < 1 ? 1 : 0;
        }
        EXPECT_LE(held_excess, kBudget) << device << ": of all regions together";
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

/// `on_ground`: the strength of the samples' shadows.
design::DesignSettings shaded_crowd(double on_ground) {
    design::DesignSettings design = crowd_design(kBudget);
    design.effects.shadows.on_ground = on_ground;
    design.effects.shadows.casters.add(LayerRole::sample);
    return design;
}

/// The terrain off screen is drawn for the first probe alone; a frame that is drawn anew draws it again, and is the same picture.
TEST(DisplayClutter, ProbesThatHaveTheTerrainOfAnotherShowTheSamePicture) {
    for (const double on_ground : {0.0, 0.6}) {
        design::DesignSettings design = shaded_crowd(on_ground);
        design.terrain.style.sketch.silhouettes = 1;
        Shown one(design);
        const std::vector<std::uint8_t> held = one.rgba;
        EXPECT_TRUE(one.still().record.clutter.reached.is_known);
        EXPECT_GT(one.still().record.terrain.triangles, 0u) << "of the picture that is shown";
        std::vector<std::uint8_t> again(held.size());
        one.display.display().draw_up_to(one.display.surface(), PictureLayer::symbology);
        EXPECT_TRUE(gl::read_pixels(one.display.display().gl(), kWidth, kHeight, again));
        EXPECT_EQ(again, held) << on_ground;
        one.display.display().draw_up_to(one.display.surface(), PictureLayer::terrain);
        EXPECT_TRUE(gl::read_pixels(one.display.display().gl(), kWidth, kHeight, again));
        EXPECT_NE(again, held) << "control: without data";
    }
}

TEST(DisplayClutter, OnlyTerrainWithShadowsOfDataIsDrawnForEveryProbe) {
    for (const double on_ground : {0.0, 0.6}) {
        Shown one(shaded_crowd(on_ground));
        const auto frame = std::make_unique<PlannedFrame>();
        FramePlanner& planner = one.display.display().planner();
        PlannerMemory memory = one.display.display().memory();
        planner.plan({one.state, {}, test_support::kHillsNow + base::Duration::from_seconds(0.5)}, memory, *frame);
        EXPECT_FALSE(frame->clutter.has_terrain) << "the first picture of a frame";
        planner.plan_again({false, clutter_of(0.5F)}, memory, *frame);
        ASSERT_NE(frame->clutter.probe, Probe::none);
        EXPECT_EQ(frame->clutter.has_terrain, !frame->effects.runs(effects::Effect::soft_shadows));
        EXPECT_EQ(frame->effects.runs(effects::Effect::soft_shadows), on_ground > 0);
        planner.plan_again({true, {}}, memory, *frame);
        EXPECT_FALSE(frame->clutter.has_terrain) << "it has failed";
        planner.conclude(memory, *frame);
        EXPECT_FALSE(frame->clutter.has_terrain) << "whoever draws the frame again draws all of it";
    }
}

TEST(DisplayClutter, ItsViewsLieOverThePicture) {
    design::DesignSettings plain = crowd_design(1), edges = plain, regions = plain;
    edges.effects.clutter = design::ClutterView::edges;
    regions.effects.clutter = design::ClutterView::regions;
    for (const char* const device : {"es3-mid", "sc2"}) {
        EXPECT_NE(shown(regions, device).rgba, shown(plain, device).rgba) << device;
        const std::vector<std::uint8_t> lines = shown(edges, device).rgba;
        std::size_t white = 0, between = 0;
        for (std::size_t n = 0; n < lines.size(); n += 4) {
            white += lines[n] == 255 ? 1 : 0;
            between += lines[n] != 255 && lines[n] != 0 ? 1 : 0;
        }
        EXPECT_GT(white, 1000u) << device;
        EXPECT_EQ(between, 0u) << device << ": edges, and nothing else";
    }
}

/// A stereo pair has no regions of its own.
TEST(DisplayClutter, WhereItCannotBeMeasuredItSaysSo) {
    design::DesignSettings stereo = crowd_design(kBudget);
    stereo.effects.stereo.mode = design::StereoMode::side_by_side;
    const Still pair = shown(stereo);
    EXPECT_FALSE(pair.record.clutter.measured.whole.is_known);
    EXPECT_NE(pair.effect().reason.view(), "");
    EXPECT_TRUE(shown(crowd_design(kBudget)).record.clutter.measured.whole.is_known) << "control";
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_elements
