#include "render_core/draw/data/label_features.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "render_core/draw/data/layer_foci.hpp"
#include "tests/render_core/draw/data/labelled_layer.hpp"
#include "tests/support/display/foci_of_test.hpp"

namespace tedavis::draw::test_label_features {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

host_sim::LayerDraft layer_of(const std::vector<scene::ScenePoint>& points, scene::LayerRole role = scene::LayerRole::place) {
    host_sim::LayerDraft layer;
    layer.name = "places";
    layer.role = role;
    layer.points = points;
    return layer;
}

std::set<std::uint32_t> offered(ElementOfTest& test, const BillboardRoom& room) {
    std::vector<unsigned char> block(1u << 16);
    base::Arena arena(block.data(), block.size());
    LabelPlanner planner;
    EXPECT_TRUE(planner.start(arena));
    const ElementInput input = test.input();
    test_support::decide_labels(planner, input, room.sheet.eye());
    std::set<std::uint32_t> features;
    for (const Label& label : planner.labels()) features.insert(feature_of(label.key));
    return features;
}

TEST(LabelFeatures, WhatMayBeInThePictureIsOffered) {
    ElementOfTest test(layer_of({BillboardRoom::point(4000, 0, 1000), BillboardRoom::point(-20'000, 0, 1000),
                                 BillboardRoom::point(79'000, 0, 1000), BillboardRoom::point(90'000, 0, 1000),
                                 BillboardRoom::point(40'000, 35'000, 1000), BillboardRoom::point(5000, 60'000, 1000)}));
    const BillboardRoom room;
    EXPECT_EQ(offered(test, room), (std::set<std::uint32_t>{0, 2, 4}))
        << "a little beside the picture, for it may turn; not far beside it, behind it or too far away";
}

/// The tall one far behind is of more interest, but it must not hide the near one.
TEST(LabelFeatures, OfWhatWarnsTheNearestComesFirst) {
    host_sim::LayerDraft masts =
        layer_of({BillboardRoom::point(9000, 0, 1000), BillboardRoom::point(3000, 5, 1000)}, scene::LayerRole::obstacle);
    host_sim::AttributeDraft height;
    height.name = "height";
    height.of = scene::AttributeOf::feature;
    height.values = {300, 10};
    masts.attributes = {height};
    for (const scene::LayerRole role : {scene::LayerRole::obstacle, scene::LayerRole::sample}) {
        masts.role = role;
        ElementOfTest test(masts);
        const BillboardRoom room;
        std::vector<unsigned char> block(1u << 16);
        base::Arena arena(block.data(), block.size());
        LabelPlanner planner;
        ASSERT_TRUE(planner.start(arena));
        const ElementInput input = test.input();
        test_support::decide_labels(planner, input, room.sheet.eye());
        ASSERT_EQ(planner.labels().size(), 2u);
        EXPECT_EQ(feature_of(planner.labels()[0].key), role == scene::LayerRole::obstacle ? 1u : 0u);
    }
}

TEST(LabelFeatures, WhatWarnsIsProtected) {
    using scene::LayerRole;
    for (const LayerRole role : {LayerRole::obstacle, LayerRole::no_go, LayerRole::airspace, LayerRole::storm_cell}) {
        ElementOfTest test(layer_of({BillboardRoom::point(4000, 0, 1000)}, role));
        EXPECT_TRUE(label_group(test.input()).is_protected);
        EXPECT_FALSE(label_group(test.input()).only_named);
    }
    ElementOfTest place(layer_of({BillboardRoom::point(4000, 0, 1000)}));
    EXPECT_FALSE(label_group(place.input()).is_protected);
    EXPECT_TRUE(label_group(place.input()).only_named);
    EXPECT_GT(label_group(place.input()).most, 1e6);
    place.element.detail = 0.5;
    EXPECT_EQ(label_group(place.input()).most, 12);
    EXPECT_EQ(label_group(place.input()).named_share, 0.5);
}

scene::DetailRegions crowded_on_the_left(float factor) {
    scene::DetailRegions crowded;
    for (std::size_t n = 0; n < crowded.factor.size(); ++n)
        if (n % scene::DetailRegions::kAcross < scene::DetailRegions::kAcross / 2) crowded.factor[n] = factor;
    return crowded;
}

/// Of equal interest, one on each side of the picture.
TEST(LabelFeatures, InACrowdedRegionWhatDoesNotWarnGivesWay) {
    const scene::DetailRegions crowded = crowded_on_the_left(0.25f);
    for (const scene::LayerRole role : {scene::LayerRole::sample, scene::LayerRole::obstacle}) {
        ElementOfTest test(layer_of({BillboardRoom::point(9000, -2000, 1000), BillboardRoom::point(9000, 2000, 1000)}, role));
        const BillboardRoom room;
        const auto left = [&](std::uint32_t feature) {
            return level_left(test.input(), feature, room.sheet.eye(), design::LabelSettings(), crowded);
        };
        EXPECT_EQ(left(0), role == scene::LayerRole::sample ? LabelLevel::none : LabelLevel::name);
        EXPECT_EQ(left(1), LabelLevel::name);
    }
}

TEST(LabelFeatures, TheLessARegionKeepsTheMoreOfALabelGivesWay) {
    ElementOfTest sample(layer_of({BillboardRoom::point(9000, -2000, 1000)}, scene::LayerRole::sample));
    ElementOfTest place(layer_of({BillboardRoom::point(9000, -2000, 1000)}));
    const BillboardRoom room;
    design::LabelSettings settings;
    settings.name_above = 0.4;
    settings.marker_above = 0.2;
    const auto level = [&](ElementOfTest& test, float factor) {
        return level_left(test.input(), 0, room.sheet.eye(), settings, crowded_on_the_left(factor));
    };
    std::set<LabelLevel> levels;
    for (float factor = 1; factor > 0.04f; factor -= 0.05f) {
        levels.insert(level(sample, factor));
        EXPECT_GE(level(sample, factor), level(sample, factor - 0.05f));
        EXPECT_NE(level(place, factor), LabelLevel::marker) << "places without a name have no marker";
    }
    EXPECT_EQ(levels.size(), 3u) << "control: all levels occur";
}

TEST(LabelFeatures, WhatIsInAFocusKeepsAll) {
    ElementOfTest test(layer_of({BillboardRoom::point(9000, -2000, 1000)}, scene::LayerRole::sample));
    const scene::ScenePoint middle = BillboardRoom::point(9000, -2000, 1000);
    const std::string place = "at = \"position\", position_deg = [" + std::to_string(base::degrees(middle.latitude_rad)) + ", " +
                              std::to_string(base::degrees(middle.longitude_rad)) + "], radius_m = 1000, ";
    const test_support::FociOfTest foci({place + "data.context = \"hidden\""});
    const BillboardRoom room;
    ElementInput input = test.input();
    const scene::DetailRegions crowded = crowded_on_the_left(0.25f);
    EXPECT_EQ(level_left(input, 0, room.sheet.eye(), {}, crowded), LabelLevel::none) << "control";
    const LayerFoci layer(&foci.frame(), input.layer, 0, false);
    input.foci = &layer;
    EXPECT_EQ(level_left(input, 0, room.sheet.eye(), {}, crowded), LabelLevel::name);
}

/// Beside each other, of too little interest for names.
TEST(LabelFeatures, InAFocusThereAreNamesAndRoundItMarkers) {
    host_sim::LayerDraft places = layer_of({BillboardRoom::point(20'000, 0, 1000), BillboardRoom::point(20'000, 2500, 1000),
                                            BillboardRoom::point(20'000, 9000, 1000)});
    places.names = {"A", "B", "C"};
    ElementOfTest test(places);
    const scene::ScenePoint middle = BillboardRoom::point(20'000, 0, 1000);
    const std::string place = "at = \"position\", position_deg = [" + std::to_string(base::degrees(middle.latitude_rad)) + ", " +
                              std::to_string(base::degrees(middle.longitude_rad)) + "], radius_m = 1000, ";
    const test_support::FociOfTest foci({place + "context.width_m = 4000, data.detail = 0.5, data.context = \"hidden\""});
    const BillboardRoom room;
    std::vector<unsigned char> block(1u << 16);
    base::Arena arena(block.data(), block.size());
    LabelPlanner planner;
    ASSERT_TRUE(planner.start(arena));
    ElementInput input = test.input();
    const LayerFoci layer(&foci.frame(), input.layer, 0, false);
    input.foci = &layer;
    design::LabelSettings settings;
    settings.name_above = 0.9;
    settings.marker_above = 0.8;
    test_support::decide_labels(planner, input, room.sheet.eye(), settings);
    std::map<std::uint32_t, LabelLevel> levels;
    for (const Label& label : planner.labels()) levels[feature_of(label.key)] = label.level;
    EXPECT_EQ(levels, (std::map<std::uint32_t, LabelLevel>{{0, LabelLevel::name}, {1, LabelLevel::marker}}));
    input.foci = nullptr;
    test_support::decide_labels(planner, input, room.sheet.eye(), settings);
    for (const Label& label : planner.labels()) EXPECT_EQ(label.level, LabelLevel::none) << "control";
}

TEST(LabelFeatures, TheShapeIsThatOfTheBillboard) {
    ElementOfTest test(layer_of({BillboardRoom::point(4000, 0, 1000), BillboardRoom::point(-4000, 0, 1000)}));
    const BillboardRoom room;
    BillboardShape shape;
    ASSERT_TRUE(billboard_shape(test.input(), 0, room.sheet.eye(), true, shape));
    const LabelShape label = label_shape(test.input(), 0, room.sheet.eye());
    EXPECT_TRUE(label.is_known);
    EXPECT_EQ(label.box.middle.x, shape.box.middle.x);
    EXPECT_EQ(label.box.middle.y, shape.box.middle.y);
    EXPECT_EQ(label.stems, kSignStems);
    EXPECT_FALSE(label_shape(test.input(), 1, room.sheet.eye()).is_known);
}

}  // namespace
}  // namespace tedavis::draw::test_label_features
