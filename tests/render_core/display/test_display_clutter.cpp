// That a display holds the budget of clutter in what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/held_edges.hpp"
#include "tests/support/map_scene.hpp"
#include "tests/support/scene_drafts.hpp"

namespace tedavis::display::test_display_clutter {
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

/// A still picture, as `shot` makes it.
struct Shown {
    explicit Shown(const design::DesignSettings& design, const char* device = "es3-mid")
        : display("egl", device, kWidth, kHeight, &terrain, design, test_support::as_it_is, &scene) {
        show();
    }
    void show() {
        display.display().settle(state, {}, test_support::kHillsNow);
        if (display.display().must_be_drawn()) display.display().draw(display.surface());
        display.display().update(state, {}, test_support::kHillsNow);
        rgba = test_support::drawn_pixels(display);
    }
    /// From the upper left; the processor's.
    [[nodiscard]] std::vector<double> densities() const {
        std::vector<std::uint8_t> rows;
        for (std::uint32_t y = kHeight; y-- > 0;)
            rows.insert(rows.end(), rgba.begin() + std::ptrdiff_t{4} * kWidth * y,
                        rgba.begin() + std::ptrdiff_t{4} * kWidth * (y + 1));
        test_support::HeldEdges held(kWidth, kHeight);
        const std::vector<std::uint8_t> edges = held.of({rows.data(), kWidth, kHeight, 4});
        std::vector<double> found(48);
        EXPECT_TRUE(perception::region_densities({edges, kWidth, kHeight}, {}, found));
        return found;
    }
    [[nodiscard]] const ClutterRecord& clutter() { return display.display().record().clutter; }
    [[nodiscard]] std::uint32_t glyphs() {
        for (const DataRecord& one : display.display().record().data)
            if (one.type.view() == "sample") return one.drawn;
        return 0;
    }

    test_support::MemoryBytes terrain{test_support::hills().image}, scene{crowd()};
    flight::AircraftState state = test_support::aircraft_over_hills(1500, 40);
    HeadlessDisplay display;
    std::vector<std::uint8_t> rgba;
};

TEST(DisplayClutter, EveryRegionIsWithinTheBudgetOrAsCalmAsItCanBe) {
    for (const char* const device : {"es3-mid", "es2-small"}) {
        Shown without(design_with(1), device), with(design_with(kBudget), device);
        const std::vector<double> free = without.densities(), held = with.densities();
        const effects::ClutterMeasures& measured = with.clutter().measured;
        ASSERT_TRUE(measured.whole.is_known && measured.least.is_known && measured.tried.is_known) << device;
        int beyond = 0, lowered = 0;
        for (std::size_t n = 0; n < free.size(); ++n) {
            EXPECT_NEAR(static_cast<double>(measured.whole.measure[n]), free[n], 0.01) << "the same picture as without a budget";
            beyond += free[n] > kBudget ? 1 : 0;
            const double least = static_cast<double>(measured.least.measure[n]);
            EXPECT_LE(held[n], std::max({kBudget, least, std::min(free[n], kBudget)}) + 0.012) << device << " region " << n;
            lowered += with.clutter().left.factor[n] < 1 ? 1 : 0;
        }
        EXPECT_GT(beyond, 4) << "control: without a budget there is more";
        EXPECT_GT(lowered, 4);
        EXPECT_LT(with.glyphs(), without.glyphs());
        EXPECT_GT(with.display.display().record().labels.lowered, 0u);
        EXPECT_EQ(without.display.display().record().labels.lowered, 0u);
        const std::uint32_t roles =
            1u << static_cast<unsigned>(LayerRole::sample) | 1u << static_cast<unsigned>(LayerRole::place);
        EXPECT_EQ(with.clutter().roles, roles);
        EXPECT_EQ(with.display.display().gl().denied().total, 0u);
    }
}

/// As the picture that it measures on the way to another one leaves no trace, so does the whole measure.
TEST(DisplayClutter, ABudgetThatIsNeverReachedChangesNothing) {
    Shown without(design_with(1)), with(design_with(0.9));
    EXPECT_EQ(with.rgba, without.rgba);
    EXPECT_TRUE(with.clutter().measured.whole.is_known);
    EXPECT_FALSE(with.clutter().measured.least.is_known) << "nobody asks for it";
    EXPECT_NE(Shown(design_with(kBudget)).rgba, without.rgba) << "control";
}

TEST(DisplayClutter, WhatComesFirstDoesNotGiveWayAndIsNotMeasured) {
    Shown without(design_with(1, 1)), with(design_with(kBudget, 1));
    EXPECT_EQ(with.rgba, without.rgba);
    EXPECT_FALSE(with.clutter().measured.whole.is_known);
    for (const EffectRecord& effect : with.display.display().record().effects)
        if (effect.name.view() == "clutter") EXPECT_EQ(effect.reason.view(), "nothing is shown that gives way");
}

TEST(DisplayClutter, OnlyTheFirstFrameOfAnEpochPaysForIt) {
    Shown shown(design_with(kBudget));
    const auto work = [&](double seconds) {
        shown.display.display().update(shown.state, {}, test_support::kHillsNow + base::Duration::from_seconds(seconds));
        static_cast<void>(test_support::drawn_pixels(shown.display));
        for (const EffectRecord& effect : shown.display.display().record().effects)
            if (effect.name.view() == "clutter") return effect.passes;
        return 0u;
    };
    EXPECT_EQ(work(0.1), 0u);
    EXPECT_GT(work(0.5), 2u);
    EXPECT_EQ(work(0.6), 0u);
}

TEST(DisplayClutter, ItsViewsLieOverThePictureWithANotice) {
    design::DesignSettings plain = design_with(1), edges = plain, regions = plain;
    edges.effects.clutter = design::ClutterView::edges;
    regions.effects.clutter = design::ClutterView::regions;
    const std::vector<std::uint8_t> bare = Shown(plain).rgba, tinted = Shown(regions).rgba, lines = Shown(edges).rgba;
    EXPECT_NE(tinted, bare);
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
    Shown pair(stereo);
    EXPECT_FALSE(pair.clutter().measured.whole.is_known);
    Shown small(design_with(kBudget), "sc2");
    EXPECT_EQ(small.clutter().budget, 1) << "none is held";
    const auto& effects = small.display.display().record().effects;
    const auto clutter =
        std::find_if(effects.begin(), effects.end(), [](const EffectRecord& one) { return one.name.view() == "clutter"; });
    ASSERT_NE(clutter, effects.end());
    EXPECT_EQ(clutter->reason.view(), "the device cannot copy what it has drawn");
}

}  // namespace
}  // namespace tedavis::display::test_display_clutter
