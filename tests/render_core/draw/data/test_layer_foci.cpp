#include "render_core/draw/data/layer_foci.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/foci_of_test.hpp"

namespace tedavis::draw::test_layer_foci {
namespace {

using test_support::ElementOfTest;
using test_support::FociOfTest;
using test_support::scene_point;

const char* const kRound =
    R"(at = "position", position_deg = [46.8, 9.8], radius_m = 3000, context = {width_m = 4000, levels = 0}, data.brightness = 0.3, data.context = "hidden")";

/// A layer's foci with the input that has them.
struct Judged {
    Judged(const host_sim::LayerDraft& draft, const char* line) : element(draft), foci({line}, nullptr), plain(element.input()) {
        layer = LayerFoci(&foci.frame(), plain.layer, 0, false);
    }
    double degree(std::uint32_t feature) { return layer.degree(plain, feature); }

    ElementOfTest element;
    FociOfTest foci;
    ElementInput plain;
    LayerFoci layer;
};

host_sim::LayerDraft towns(std::size_t count) {
    host_sim::LayerDraft layer;
    layer.name = "towns";
    layer.role = scene::LayerRole::place;
    std::mt19937 random(9);
    std::uniform_real_distribution<double> off(-0.15, 0.15);
    for (std::size_t n = 0; n < count; ++n) layer.points.push_back(scene_point(46.8 + off(random), 9.8 + off(random), 0));
    return layer;
}

host_sim::LayerDraft shape(scene::LayerShape kind, scene::LayerRole role, std::vector<scene::ScenePoint> points) {
    host_sim::LayerDraft layer;
    layer.name = "shape";
    layer.shape = kind;
    layer.role = role;
    layer.starts = {0, static_cast<std::uint32_t>(points.size())};
    layer.points = std::move(points);
    return layer;
}

TEST(LayerFoci, PointsHaveTheDegreeOfTheirPlace) {
    const host_sim::LayerDraft draft = towns(500);
    Judged judged(draft, kRound);
    FocusCounts expected;
    for (std::uint32_t n = 0; n < 500; ++n) {
        const scene::ScenePoint& point = draft.points[n];
        const double away = earth::surface_distance_m({point.latitude_rad, point.longitude_rad, {0}},
                                                      {base::radians(46.8), base::radians(9.8), {0}});
        const double degree = away <= 3000 ? 1 : std::max(1 - (away - 3000) / 4000, 0.0);
        EXPECT_NEAR(judged.degree(n), degree, 1e-5);
        ++(degree >= 1 ? expected.in_focus : degree > 0 ? expected.intermediate : expected.context);
        EXPECT_EQ(judged.layer.look(judged.plain, n).is_hidden, degree <= 0);
    }
    const FocusCounts counts = count_in_focus(judged.foci.frame(), 0, judged.layer, judged.plain);
    EXPECT_EQ(counts.in_focus, expected.in_focus);
    EXPECT_EQ(counts.intermediate, expected.intermediate);
    EXPECT_EQ(counts.context, expected.context);
    EXPECT_GT(expected.intermediate, 20u);
}

TEST(LayerFoci, WhatMayBeDangerousNeverStepsBack) {
    for (const auto& [role, is_danger] : {std::pair(scene::LayerRole::place, false), {scene::LayerRole::obstacle, true}}) {
        host_sim::LayerDraft draft = towns(40);
        draft.role = role;
        Judged judged(draft, kRound);
        bool is_any_hidden = false;
        for (std::uint32_t n = 0; n < 40; ++n) is_any_hidden = is_any_hidden || judged.layer.look(judged.plain, n).is_hidden;
        EXPECT_EQ(is_any_hidden, !is_danger);
        EXPECT_EQ(judged.layer.frame() == nullptr, is_danger);
        EXPECT_GT(count_in_focus(judged.foci.frame(), 0, judged.layer, judged.plain).context, 10u) << "and is counted as it is";
    }
}

/// Its corners are 20 km away on either side.
TEST(LayerFoci, ALineThatPassesThroughIsThere) {
    Judged through(
        shape(scene::LayerShape::lines, scene::LayerRole::road, {scene_point(46.81, 9.5, 0), scene_point(46.81, 10.1, 0)}),
        kRound);
    EXPECT_EQ(through.degree(0), 1);
    Judged past(
        shape(scene::LayerShape::lines, scene::LayerRole::road, {scene_point(46.845, 9.5, 0), scene_point(46.845, 10.1, 0)}),
        kRound);
    EXPECT_NEAR(past.degree(0), 1 - (5003 - 3000) / 4000.0, 0.02);
    Judged far(shape(scene::LayerShape::lines, scene::LayerRole::road, {scene_point(46.9, 9.5, 0), scene_point(46.9, 10.1, 0)}),
               kRound);
    EXPECT_EQ(far.degree(0), 0);
    EXPECT_EQ(through.layer.look_of_point({0, 0}).brightness, 0.3) << "its end steps back";
    EXPECT_FALSE(through.layer.look_of_point({0, 0}).is_hidden);
}

TEST(LayerFoci, AnAreaRoundTheFocusIsInIt) {
    const std::vector<scene::ScenePoint> round = {scene_point(46.5, 9.4, 0), scene_point(46.5, 10.2, 0),
                                                  scene_point(47.1, 10.2, 0), scene_point(47.1, 9.4, 0)};
    Judged area(shape(scene::LayerShape::areas, scene::LayerRole::airspace, round), kRound);
    EXPECT_EQ(area.degree(0), 1);
    std::vector<scene::ScenePoint> beside = round;
    for (scene::ScenePoint& point : beside) point.longitude_rad += base::radians(0.9);
    Judged other(shape(scene::LayerShape::areas, scene::LayerRole::airspace, beside), kRound);
    EXPECT_EQ(other.degree(0), 0) << "its west side is 38 km away";
    Judged line(shape(scene::LayerShape::lines, scene::LayerRole::road, round), kRound);
    EXPECT_EQ(line.degree(0), 0) << "a control: round a line there is nothing";
}

TEST(LayerFoci, ByTheValueThatAFocusMeans) {
    host_sim::LayerDraft areas = test_support::small_areas();
    areas.role = scene::LayerRole::airspace;
    const test_support::LoadedScene scene(areas);
    ElementOfTest element(areas);
    FociOfTest foci(
        {R"(shape = "data", layer = ")" + areas.name + R"(", attribute = "floor", value = 1500, similar = 600, data.size = 0.5)"},
        &scene.scene());
    const ElementInput input = element.input();
    const LayerFoci layer(&foci.frame(), input.layer, 0, false);
    EXPECT_TRUE(layer.is_by_value(0));
    EXPECT_EQ(layer.degree(input, 0), 1);
    EXPECT_EQ(layer.degree(input, 1), 0.5) << "2000 m is similar";
    EXPECT_EQ(layer.look(input, 1).size, 0.5);
}

TEST(LayerFoci, VolumesLookAtHeights) {
    host_sim::LayerDraft draft = towns(0);
    draft.height_datum = scene::HeightDatum::ellipsoid;
    draft.points = {scene_point(46.8, 9.8, 1500), scene_point(46.8, 9.8, 2500)};
    Judged judged(draft, R"(shape = "cuboid", lower_m = 1000, upper_m = 2000, data.size = 0.5)");
    EXPECT_EQ(judged.degree(0), 1);
    EXPECT_LT(judged.degree(1), 1);
    EXPECT_GT(judged.degree(1), 0);
}

TEST(LayerFoci, NoFociAreNoDifference) {
    ElementOfTest element(towns(3));
    ElementInput input = element.input();
    EXPECT_EQ(look_of_feature(input, 0).size, 1);
    const LayerFoci none;
    input.foci = &none;
    EXPECT_EQ(look_of_feature(input, 0).size, 1);
    EXPECT_EQ(none.degree(input, 1), 1);
}

}  // namespace
}  // namespace tedavis::draw::test_layer_foci
