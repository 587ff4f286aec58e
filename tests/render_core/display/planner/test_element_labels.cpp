#include "render_core/display/planner/element_labels.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::display::test_element_labels {
namespace {

using test_support::BillboardRoom;

host_sim::LayerDraft layer_of(const std::string& name, scene::LayerRole role, const std::vector<double>& right_m,
                              double ahead_m = 4000) {
    host_sim::LayerDraft layer;
    layer.name = name;
    layer.role = role;
    for (const double right : right_m) {
        layer.points.push_back(BillboardRoom::point(ahead_m, right, 1000));
        layer.names.emplace_back("Ort");
    }
    return layer;
}

host_sim::SceneDraft scene_of(const std::vector<host_sim::LayerDraft>& layers) { return {"one", "a test", 1, layers}; }

design::DataElement element_of(scene::LayerRole role) {
    design::DataElement element;
    element.role = role;
    element.technique = design::DataTechnique::billboard;
    return element;
}

/// Labels of places and masts on a sheet of their own.
class Shown final : ElementLabels::Inputs {
public:
    explicit Shown(const host_sim::SceneDraft& draft) : scene_(draft), block_(1u << 16) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(labels.start(arena));
        set();
    }
    /// Design 0 shows places and masts, design 1 masts alone.
    void set(std::size_t design = 0) {
        elements_.clear();
        const bool has_room = (design != 0 || elements_.try_push_back(element_of(scene::LayerRole::place))) &&
                              elements_.try_push_back(element_of(scene::LayerRole::obstacle));
        EXPECT_TRUE(has_room);
        labels.set(&scene_.scene(), elements_, settings, design);
    }
    /// `now` in seconds, `turned` in degrees.
    LabelCounts frame(double now_s, double turned_deg = 0, flight::FlightTime time = {}) {
        BillboardRoom turned(64, turned_deg);
        room.view = turned.view;
        room.begin();
        decide(now_s, time);
        ElementLabels::Pass pass(labels, room.sheet, *this, declutter);
        pass.add_protected();
        pass.add_others();
        return pass.count();
    }
    void decide(double now_s, flight::FlightTime time = {}) {
        labels.decide({ground_, room.view, {}, time, base::Time{} + base::Duration::from_seconds(now_s), 16});
    }
    [[nodiscard]] std::uint32_t drawn(std::size_t layer) const {
        return labels.drawn(elements_[layer], scene_.scene().layers()[layer]);
    }
    [[nodiscard]] std::uint32_t suppressed(std::size_t layer) const {
        return labels.suppressed(elements_[layer], scene_.scene().layers()[layer]);
    }

    ElementLabels labels;
    BillboardRoom room;
    design::LabelSettings settings;
    bool shows_places = true;
    const policy::Declutter* declutter = nullptr;

private:
    const draw::ElementInput* input(const design::DataElement& element, const scene::Layer& layer) override {
        if (!shows_places && element.role == scene::LayerRole::place) return nullptr;
        return &input_.emplace(draw::ElementInput{element, 0, layer, ground_, {}});
    }

    test_support::LoadedScene scene_;
    std::vector<unsigned char> block_;
    design::DataElementList elements_;
    test_support::LevelGround ground_;
    std::optional<draw::ElementInput> input_;
};

using scene::LayerRole;
const host_sim::LayerDraft kPlaces = layer_of("places", LayerRole::place, {-1000, 0, 1000});
const host_sim::LayerDraft kMasts = layer_of("masts", LayerRole::obstacle, {-500, 1500});

TEST(ElementLabels, AllElementsAreCountedAsOne) {
    Shown shown(scene_of({kPlaces, kMasts}));
    const LabelCounts first = shown.frame(10);
    EXPECT_EQ(first.placed, 5u);
    EXPECT_EQ(first.suppressed, 0u);
    EXPECT_EQ(first.changed, 5u) << "all of them came";
    EXPECT_EQ(shown.drawn(0), 3u);
    EXPECT_EQ(shown.drawn(1), 2u);
    EXPECT_EQ(shown.frame(10.1).changed, 0u);
    EXPECT_EQ(shown.frame(10.6).changed, 0u) << "in another interval too";
    shown.shows_places = false;
    const LabelCounts without = shown.frame(10.7);
    EXPECT_EQ(without.placed, 2u);
    EXPECT_EQ(without.changed, 3u);
    EXPECT_EQ(without.suppressed, 3u);
    shown.labels.rest();
    EXPECT_EQ(shown.frame(10.8).changed, 2u) << "after a frame without signs they come anew";
}

/// In the left half of the picture, as the interval saw it.
TEST(ElementLabels, WhereARegionIsCrowdedNamesGiveWayButNotWhatWarns) {
    policy::Declutter declutter;
    declutter.roles = 1u << static_cast<unsigned>(LayerRole::place) | 1u << static_cast<unsigned>(LayerRole::obstacle);
    for (std::size_t n = 0; n < declutter.regions.factor.size(); ++n)
        if (n % scene::DetailRegions::kAcross < scene::DetailRegions::kAcross / 2) declutter.regions.factor[n] = 0.25f;
    Shown shown(
        scene_of({layer_of("places", LayerRole::place, {-1000, 1000}), layer_of("masts", LayerRole::obstacle, {-500, 1500})}));
    EXPECT_EQ(shown.frame(10).decluttered, 0u);
    EXPECT_EQ(shown.drawn(0), 2u);
    shown.declutter = &declutter;
    const LabelCounts crowded = shown.frame(10.1);
    EXPECT_EQ(crowded.decluttered, 1u);
    EXPECT_EQ(crowded.placed, 3u);
    EXPECT_EQ(crowded.suppressed, 1u);
    EXPECT_EQ(shown.drawn(0), 1u);
    EXPECT_EQ(shown.drawn(1), 2u);
    EXPECT_EQ(shown.frame(10.2, 12).decluttered, 1u) << "within an interval nothing comes and goes with a turn";
    EXPECT_EQ(shown.frame(10.6, 40).decluttered, 2u) << "as seen by the next one both are on the left";
    declutter.roles = 0;
    EXPECT_EQ(shown.frame(10.7, 40).decluttered, 0u);
}

/// The mast is listed after the place, of less interest, and at the same spot.
TEST(ElementLabels, WhatWarnsHasTheRoomBeforeAllOthers) {
    Shown shown(scene_of({layer_of("places", LayerRole::place, {0}, 3000), layer_of("masts", LayerRole::obstacle, {2}, 3010)}));
    shown.settings.relevance = {};
    shown.settings.name_above = shown.settings.marker_above = 0;
    shown.set();
    static_cast<void>(shown.frame(10));
    EXPECT_EQ(shown.drawn(1), 1u);
    Shown alone(scene_of({layer_of("places", LayerRole::place, {0}, 3000)}));
    static_cast<void>(alone.frame(10));
    EXPECT_EQ(alone.drawn(0), 1u);
}

/// The name of the nearer one would lie over the other.
TEST(ElementLabels, NoNameHidesWhatWarns) {
    for (const double aside_m : {180.0, -180.0}) {
        host_sim::LayerDraft masts = layer_of("masts", LayerRole::obstacle, {0, aside_m}, 3000);
        masts.points[1].latitude_rad += 1e-6;
        masts.names[0] = "A mast with a long name";
        Shown shown(scene_of({kPlaces, masts}));
        static_cast<void>(shown.frame(10));
        EXPECT_EQ(shown.drawn(1), 2u) << aside_m;
    }
}

TEST(ElementLabels, WhatIsLeftOutIsCountedByElement) {
    std::vector<double> crowd;
    for (int n = 0; n < 60; ++n) crowd.push_back(10.0 * n - 300);
    Shown shown(scene_of({layer_of("places", LayerRole::place, crowd), kMasts}));
    const LabelCounts counts = shown.frame(10);
    EXPECT_GT(shown.suppressed(0), 10u);
    EXPECT_EQ(shown.suppressed(1), 0u);
    EXPECT_EQ(counts.suppressed + counts.placed, 62u);
}

TEST(ElementLabels, DecisionsStandForAnInterval) {
    Shown shown(scene_of({kPlaces, kMasts}));
    static_cast<void>(shown.frame(10));
    LabelHistory before, after;
    shown.labels.keep(before);
    static_cast<void>(shown.frame(10.4, 3));
    shown.labels.keep(after);
    EXPECT_EQ(after.labels.interval, before.labels.interval);
    EXPECT_EQ(after.labels.labels.size(), before.labels.labels.size());
    static_cast<void>(shown.frame(10.5, 3));
    shown.labels.keep(after);
    EXPECT_EQ(after.labels.interval, before.labels.interval + 1);
    EXPECT_EQ(shown.frame(10.6, 180).placed, 0u) << "behind";
    shown.labels.restore(before);
    shown.labels.keep(after);
    EXPECT_EQ(after.labels.interval, before.labels.interval);
}

bool are_same(const LabelHistory& a, const LabelHistory& b) {
    bool same = a.labels.interval == b.labels.interval && a.labels.labels.size() == b.labels.labels.size();
    for (std::size_t n = 0; same && n < a.labels.labels.size(); ++n) {
        const draw::Label &one = a.labels.labels[n], &other = b.labels.labels[n];
        same = one.key == other.key && one.level == other.level && one.side == other.side && one.age == other.age;
    }
    return same;
}

LabelHistory memory_of(const Shown& shown) {
    LabelHistory memory;
    shown.labels.keep(memory);
    return memory;
}

TEST(ElementLabels, AnotherDesignsIntervalIsAsSeenAtItsFirstInstant) {
    Shown shown(scene_of({kPlaces, kMasts})), other(scene_of({kPlaces, kMasts})), late(scene_of({kPlaces, kMasts}));
    static_cast<void>(shown.frame(9.6));
    static_cast<void>(shown.frame(10.1));
    const LabelHistory before = memory_of(shown);
    shown.set(1);
    EXPECT_EQ(shown.frame(10.3, 180).placed, 0u) << "behind";
    other.set(1);
    static_cast<void>(other.frame(10.1));
    EXPECT_TRUE(are_same(memory_of(shown), memory_of(other)));
    late.set(1);
    static_cast<void>(late.frame(10.3, 180));
    EXPECT_FALSE(are_same(memory_of(shown), memory_of(late))) << "control: seen from where the design turned";
    // One that comes from the interval before goes on likewise.
    static_cast<void>(shown.frame(10.6, 20));
    other.labels.restore(before);
    static_cast<void>(other.frame(10.6, 20));
    EXPECT_TRUE(are_same(memory_of(shown), memory_of(other)));
}

TEST(ElementLabels, AnIntervalDecidedElsewhereLeavesWhatTheFrameShowed) {
    Shown shown(scene_of({kPlaces, kMasts})), chain(scene_of({kPlaces, kMasts})), straight(scene_of({kPlaces, kMasts}));
    for (Shown* const one : {&shown, &straight}) static_cast<void>(one->frame(9.6));
    static_cast<void>(straight.frame(10.1));
    static_cast<void>(chain.frame(9.6));
    static_cast<void>(chain.frame(10.1));
    LabelHistory own = memory_of(shown), decided = memory_of(chain);
    for (draw::Label& label : decided.labels.labels) label.look = 0;  // of an interval that no frame has shown
    own.take_interval(decided);
    EXPECT_TRUE(are_same(own, decided));
    shown.labels.restore(own);
    EXPECT_EQ(shown.frame(10.2).changed, straight.frame(10.2).changed);
    // Controls: without what was shown all labels come anew; those that the decision leaves out go.
    shown.labels.restore(decided);
    EXPECT_GT(shown.frame(10.3).changed, 0u);
    const auto placed = static_cast<std::uint32_t>(decided.labels.labels.size());
    ASSERT_GT(placed, 0u);
    decided.labels.labels.clear();
    own = memory_of(straight);
    own.take_interval(decided);
    EXPECT_GT(own.labels.gone, 0u);
    EXPECT_LE(own.labels.gone, placed);
}

TEST(ElementLabels, OfAnIntervalWithoutLabelsNothingIsDecidedAnew) {
    Shown shown(scene_of({kPlaces, kMasts}));
    static_cast<void>(shown.frame(9.6));
    shown.labels.skip(base::Time{} + base::Duration::from_seconds(10.1));
    shown.set(1);
    EXPECT_EQ(shown.frame(10.3).placed, 0u);
    EXPECT_EQ(shown.frame(10.5).placed, 2u);
}

TEST(ElementLabels, AnotherEyeAtTheSameInstantSeesItsOwn) {
    Shown shown(scene_of({kPlaces, kMasts}));
    EXPECT_EQ(shown.frame(10, 180).placed, 0u);
    EXPECT_EQ(shown.frame(10, 0).placed, 5u) << "a camera that is moved while time stands still";
}

TEST(ElementLabels, WhatIsOutOfDateIsNotOffered) {
    host_sim::LayerDraft late = kPlaces;
    late.valid_until_ns = 1'000;
    Shown shown(scene_of({late, kMasts}));
    flight::FlightTime time;
    time.utc = {2'000};
    time.is_date = true;
    EXPECT_EQ(shown.frame(10, 0, time).placed, 2u);
    time.is_date = false;
    EXPECT_EQ(shown.frame(20, 0, time).placed, 5u) << "nobody knows the time";
}

TEST(ElementLabels, OnlyIconsAndNamesOfTheSceneAreLabels) {
    const test_support::LoadedScene scene(scene_of({kPlaces, layer_of("heard", LayerRole::traffic, {0})}));
    design::DataElement element = element_of(LayerRole::place);
    EXPECT_TRUE(has_labels(element, scene.scene().layers()[0]));
    EXPECT_FALSE(has_labels(element, scene.scene().layers()[1])) << "other aircraft have signs of their own";
    EXPECT_TRUE(is_meant(element, scene.scene().layers()[0]));
    EXPECT_FALSE(is_meant(element, scene.scene().layers()[1]));
    design::DataElementList elements;
    ASSERT_TRUE(elements.try_push_back(element));
    EXPECT_TRUE(ElementLabels::is_any(scene.scene(), elements));
    elements[0].technique = design::DataTechnique::solid;
    EXPECT_FALSE(has_labels(elements[0], scene.scene().layers()[0]));
    EXPECT_FALSE(ElementLabels::is_any(scene.scene(), elements));
}

}  // namespace
}  // namespace tedavis::display::test_element_labels
