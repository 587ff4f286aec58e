#include "render_core/draw/data/obstacle_solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/obstacle_stand.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_obstacle_solids {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
const std::vector<std::string> kKinds = {"mast", "turbine", "chimney", "crane", "pole", "silo"};

host_sim::LayerDraft obstacle(const std::string& kind, float height_m, scene::HeightDatum datum = scene::HeightDatum::ground) {
    host_sim::LayerDraft layer;
    layer.name = "obstacles";
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = datum;
    layer.points = {scene_point(46.8, 9.8, height_m)};
    host_sim::AttributeDraft kinds;
    kinds.name = "kind";
    kinds.scale = scene::AttributeScale::nominal;
    kinds.of = scene::AttributeOf::feature;
    kinds.classes = kKinds;
    kinds.values = {static_cast<float>(std::find(kKinds.begin(), kKinds.end(), kind) - kKinds.begin())};
    layer.attributes.push_back(kinds);
    return layer;
}

void bind(host_sim::LayerDraft& layer, const char* name, float value) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = scene::AttributeOf::feature;
    attribute.values = {value};
    layer.attributes.push_back(attribute);
}

host_sim::LayerDraft cable(const std::vector<scene::ScenePoint>& points, scene::HeightDatum datum) {
    host_sim::LayerDraft layer;
    layer.name = "cables";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = datum;
    layer.points = points;
    layer.starts = {0, static_cast<std::uint32_t>(points.size())};
    return layer;
}

struct Reach {
    double low = 1e9, high = -1e9;
};
Reach reach_of(const SolidBatch& batch) {
    Reach reach;
    for (const SolidPiece& piece : batch.pieces())
        for (std::uint32_t n = 0; n < piece.vertices; ++n) {
            const glm::dvec3 at = piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + n].place_m);
            const double height = earth::from_ecef(at).height.m;
            reach.low = std::min(reach.low, height);
            reach.high = std::max(reach.high, height);
        }
    return reach;
}

TEST(ObstacleSolids, EveryKindHasItsTrueHeightAndIsClosed) {
    for (const std::string& kind : kKinds) {
        ElementOfTest test(obstacle(kind, 120));
        SolidRoomOfTest room;
        const ElementCount count = add_obstacle_points(room.batch, room.mesh, test.input());
        EXPECT_EQ(count.drawn, 1u) << kind;
        ASSERT_EQ(room.batch.pieces().size(), 2u) << "itself and its rim";
        const Reach reach = reach_of(room.batch);
        EXPECT_NEAR(reach.high, 720, 0.6) << kind;
        EXPECT_NEAR(reach.low, 600, 0.6) << kind;
        EXPECT_GT(test_support::volume_m3(room.batch, room.batch.pieces()[0]), 0) << kind;
        EXPECT_EQ(test_support::open_edges(room.batch, room.batch.pieces()[0]), 0u) << kind;
        EXPECT_EQ(room.batch.pieces()[0].look.halo_px, 0);
        EXPECT_EQ(room.batch.pieces()[1].look.halo_px, kMinHalf_px);
    }
}

TEST(ObstacleSolids, HeightsAreOverTheLayersDatumOrStated) {
    const auto reach = [](host_sim::LayerDraft layer, bool has_ground = true) {
        ElementOfTest test(layer);
        test.ground.is_known = has_ground;
        SolidRoomOfTest room;
        EXPECT_EQ(add_obstacle_points(room.batch, room.mesh, test.input()).drawn, 1u);
        return reach_of(room.batch);
    };
    EXPECT_NEAR(reach(obstacle("pole", 700, scene::HeightDatum::msl)).high, 750, 0.3) << "the geoid lies at 50 m";
    EXPECT_NEAR(reach(obstacle("pole", 700, scene::HeightDatum::msl)).low, 600, 0.3);
    host_sim::LayerDraft layer = obstacle("pole", kNone);
    bind(layer, "height", 33);
    EXPECT_NEAR(reach(layer).high, 633, 0.3);
    layer = obstacle("pole", 700, scene::HeightDatum::msl);
    bind(layer, "height", 33);
    EXPECT_NEAR(reach(layer, false).low, 717, 0.3) << "no ground: by its own height";
}

TEST(ObstacleSolids, AnUnknownHeightIsShownAsUnknown) {
    ElementOfTest test(obstacle("pole", kNone));
    SolidRoomOfTest room;
    EXPECT_EQ(add_obstacle_points(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_NEAR(reach_of(room.batch).high, 600 + scene::kUnknownObstacle_m, 0.3);
    EXPECT_EQ(room.batch.vertices()[0].rgba[0], 255);
    EXPECT_EQ(room.batch.vertices()[0].rgba[2], 255) << "the colour of missing data";
    test.ground.is_known = false;
    room.batch.clear();
    EXPECT_EQ(add_obstacle_points(room.batch, room.mesh, test.input()).hidden, 1u);
}

TEST(ObstacleSolids, WhatIsMixedHasNoRimOfItsOwn) {
    ElementOfTest test(obstacle("mast", 90));
    test.element.opacity = 0.5;
    SolidRoomOfTest room;
    static_cast<void>(add_obstacle_points(room.batch, room.mesh, test.input()));
    EXPECT_EQ(room.batch.pieces().size(), 1u);
    test.element.halo_px = 3;
    room.batch.clear();
    static_cast<void>(add_obstacle_points(room.batch, room.mesh, test.input()));
    ASSERT_EQ(room.batch.pieces().size(), 2u);
    EXPECT_EQ(room.batch.pieces()[1].look.halo_px, 3);
}

TEST(Cables, SagBetweenTheirPoles) {
    const double north = base::degrees(300 / earth::meridian_radius_m(base::radians(46.8)));
    host_sim::LayerDraft layer =
        cable({scene_point(46.8, 9.8, kNone), scene_point(46.8 + north, 9.8, kNone)}, scene::HeightDatum::ground);
    // Over the ground at height 600 m, poles reach up to 700 m; the span of 300 m sags by 10 m.
    bind(layer, "height", 100);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_cables(room.batch, room.mesh, test.input()).drawn, 1u);
    const glm::dvec3 middle = earth::to_ecef({base::radians(46.8 + north / 2), base::radians(9.8), {690}});
    double nearest = 1e9;
    const SolidPiece& piece = room.batch.pieces()[0];
    for (std::uint32_t n = 0; n < piece.vertices; ++n)
        nearest = std::min(
            nearest, glm::distance(piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m), middle));
    EXPECT_LT(nearest, 0.1);
    EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
    EXPECT_NEAR(reach_of(room.batch).low, 600, 0.1) << "the feet of its poles";
    EXPECT_NEAR(reach_of(room.batch).high, 700, 0.2);
}

TEST(Cables, SurveyedOnesHangAsTheyAreSaidTo) {
    std::vector<scene::ScenePoint> points;
    for (int n = 0; n < 5; ++n) points.push_back(scene_point(46.8 + 0.001 * n, 9.8, 800));
    ElementOfTest test(cable(points, scene::HeightDatum::msl));
    SolidRoomOfTest room;
    EXPECT_EQ(add_cables(room.batch, room.mesh, test.input()).drawn, 1u);
    const SolidPiece& piece = room.batch.pieces()[0];
    std::uint32_t between = 0;
    for (std::uint32_t n = 0; n < piece.vertices; ++n) {
        const glm::dvec3 at = piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m);
        const double height = earth::from_ecef(at).height.m;
        between += height > 600.5 && height < 849 ? 1 : 0;
    }
    EXPECT_EQ(between, 0u) << "nothing but cable at its height and two poles down to the ground";
}

TEST(Cables, WhatCannotBePlacedIsHidden) {
    ElementOfTest lost(cable({scene_point(46.8, 9.8, kNone), scene_point(46.81, 9.8, kNone)}, scene::HeightDatum::ground));
    lost.ground.is_known = false;
    SolidRoomOfTest room;
    EXPECT_EQ(add_cables(room.batch, room.mesh, lost.input()).hidden, 1u);
    ElementOfTest twice(cable({scene_point(46.8, 9.8, 90), scene_point(46.8, 9.8, 90)}, scene::HeightDatum::ground));
    EXPECT_EQ(add_cables(room.batch, room.mesh, twice.input()).drawn, 1u) << "points on each other: its poles stand";
    EXPECT_EQ(room.batch.use().refused, 0u);
}

/// Vertices of the first piece, to ECEF.
std::vector<glm::dvec3> places_of(const SolidBatch& batch) {
    std::vector<glm::dvec3> places;
    const SolidPiece& piece = batch.pieces()[0];
    for (std::uint32_t n = 0; n < piece.vertices; ++n)
        places.push_back(piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + n].place_m));
    return places;
}

/// How far outside of the first piece, which bends inwards nowhere, a place is.
double outside_m(const SolidBatch& batch, const glm::dvec3& place) {
    const SolidPiece& piece = batch.pieces()[0];
    const auto at = [&](std::uint32_t n) {
        return piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + batch.indices()[piece.first_index + n]].place_m);
    };
    double outside = -1e9;
    for (std::uint32_t n = 0; n + 2 < piece.indices; n += 3) {
        const glm::dvec3 normal = glm::cross(at(n + 1) - at(n), at(n + 2) - at(n));
        if (glm::length(normal) > 1e-9) outside = std::max(outside, glm::dot(place - at(n), normal / glm::length(normal)));
    }
    return outside;
}

TEST(ObstacleSolids, WithLittleDetailABodyContainsTheShape) {
    for (const std::string& kind : kKinds)
        for (const double detail : {0.0, 0.2, 0.45}) {
            ElementOfTest test(obstacle(kind, 120));
            SolidRoomOfTest whole, body;
            static_cast<void>(add_obstacle_points(whole.batch, whole.mesh, test.input()));
            test.element.detail = detail;
            EXPECT_EQ(add_obstacle_points(body.batch, body.mesh, test.input()).drawn, 1u) << "none is left out";
            EXPECT_LT(body.batch.vertices().size(), whole.batch.vertices().size()) << kind;
            for (const glm::dvec3& place : places_of(whole.batch)) EXPECT_LT(outside_m(body.batch, place), 0.7) << kind << detail;
        }
}

/// Control: the body of a pole holds no mast with its guys.
TEST(ObstacleSolids, AnotherOnesBodyDoesNotContainIt) {
    ElementOfTest mast(obstacle("mast", 120)), pole(obstacle("pole", 120));
    pole.element.detail = 0.2;
    SolidRoomOfTest whole, body;
    static_cast<void>(add_obstacle_points(whole.batch, whole.mesh, mast.input()));
    static_cast<void>(add_obstacle_points(body.batch, body.mesh, pole.input()));
    double most = -1e9;
    for (const glm::dvec3& place : places_of(whole.batch)) most = std::max(most, outside_m(body.batch, place));
    EXPECT_GT(most, 30);
}

TEST(Cables, WithLittleDetailNoPartIsBelowTheTrueOne) {
    const host_sim::LayerDraft layer =
        cable({scene_point(46.8, 9.8, 30), scene_point(46.803, 9.8, 30)}, scene::HeightDatum::ground);
    ElementOfTest test(layer);
    double before = 0;
    for (const double detail : {1.0, 0.6, 0.3, 0.0}) {
        test.element.detail = detail;
        SolidRoomOfTest room;
        EXPECT_EQ(add_cables(room.batch, room.mesh, test.input()).drawn, 1u);
        double lowest = 1e9;  // of what lies between the poles
        for (const glm::dvec3& place : places_of(room.batch)) {
            const earth::Geodetic at = earth::from_ecef(place);
            const double along = (base::degrees(at.latitude_rad) - 46.8) / 0.003;
            if (along < 0.01 || along > 0.99) continue;
            lowest = std::min(lowest, at.height.m);
        }
        EXPECT_GE(lowest, before) << detail;
        before = lowest;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_obstacle_solids
