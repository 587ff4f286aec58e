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
    const auto reach = [](const host_sim::LayerDraft& layer, bool has_ground = true) {
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

/// Poles and edge, their rim, and the wall.
constexpr std::size_t kCablePieces = 3;

/// Vertices of a piece, to ECEF.
std::vector<glm::dvec3> places_of(const SolidBatch& batch, std::size_t number = 0) {
    std::vector<glm::dvec3> places;
    const SolidPiece& piece = batch.pieces()[number];
    for (std::uint32_t n = 0; n < piece.vertices; ++n)
        places.push_back(piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + n].place_m));
    return places;
}

TEST(Cables, HaveASolidEdgeStraightBetweenTheirTops) {
    const double north = base::degrees(300 / earth::meridian_radius_m(base::radians(46.8)));
    host_sim::LayerDraft layer =
        cable({scene_point(46.8, 9.8, kNone), scene_point(46.8 + north, 9.8, kNone)}, scene::HeightDatum::ground);
    bind(layer, "height", 100);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_cables(room.batch, room.mesh, test.input()).drawn, 1u);
    ASSERT_EQ(room.batch.pieces().size(), kCablePieces);
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_FALSE(piece.look.is_mixed);
    EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
    int between = 0;
    for (const glm::dvec3& place : places_of(room.batch)) {
        const earth::Geodetic at = earth::from_ecef(place);
        const double along = (base::degrees(at.latitude_rad) - 46.8) / north;
        if (along > 0.01 && along < 0.99) ++between;
    }
    EXPECT_EQ(between, 0) << "nothing but poles and what leads straight from one to the other";
    EXPECT_NEAR(reach_of(room.batch).high, 700, 0.2);
}

/// Hills of 40 m across every 500 m; its heights are the test's oracle.
class WavyGround final : public scene::Ground {
public:
    double height_m(double latitude_rad, double) override { return 600 + 20 * std::sin(base::degrees(latitude_rad) * 1400); }
    double undulation_m(double, double) override { return 50; }
};

/// How far the wall's lower edge is below the ground, at the least and at the most, over all of its length.
struct Depth {
    double least_m = 1e9, most_m = -1e9;
};
Depth depth_of_wall(const SolidBatch& batch, scene::Ground& ground) {
    Depth depth;
    const std::vector<glm::dvec3> places = places_of(batch, 2);
    for (std::size_t n = 1; n + 2 < places.size(); n += 2)
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const earth::Geodetic at = earth::from_ecef(places[n] + (places[n + 2] - places[n]) * share);
            const double depth_m = ground.height_m(at.latitude_rad, at.longitude_rad) - at.height.m;
            depth.least_m = std::min(depth.least_m, depth_m);
            depth.most_m = std::max(depth.most_m, depth_m);
        }
    return depth;
}

/// Control: a wall from foot to foot would hang over the valleys.
TEST(Cables, AreTranslucentWallsThatReachTheGroundEverywhere) {
    host_sim::LayerDraft layer = cable({scene_point(46.8, 9.8, 90), scene_point(46.82, 9.8, 90)}, scene::HeightDatum::ground);
    ElementOfTest test(layer);
    WavyGround ground;
    const auto build = [&](SolidRoomOfTest& room, scene::Ground& on) {
        const ElementInput of = test.input();
        ElementInput input{of.element, of.group, of.layer, on, of.missing};
        EXPECT_EQ(add_cables(room.batch, room.mesh, input).drawn, 1u);
        ASSERT_EQ(room.batch.pieces().size(), kCablePieces);
    };
    SolidRoomOfTest room, level;
    build(room, ground);
    const SolidLook& look = room.batch.pieces()[2].look;
    EXPECT_TRUE(look.is_mixed);
    EXPECT_FALSE(look.is_thing) << "it casts no shadow";
    EXPECT_FLOAT_EQ(look.opacity, kWallShare);
    const Depth seated = depth_of_wall(room.batch, ground);
    EXPECT_GT(seated.least_m, 0.5 * kWallRoot_m);
    EXPECT_LT(seated.most_m, 1.5 * kWallRoot_m);
    build(level, test.ground);
    EXPECT_LT(depth_of_wall(level.batch, ground).least_m, 0.5 * kWallRoot_m) << "control";
}

TEST(Cables, WallsBeginAtTheStraightLineBetweenTops) {
    ElementOfTest test(cable({scene_point(46.8, 9.8, 30), scene_point(46.81, 9.81, 130)}, scene::HeightDatum::ground));
    SolidRoomOfTest room;
    EXPECT_EQ(add_cables(room.batch, room.mesh, test.input()).drawn, 1u);
    const glm::dvec3 from = earth::to_ecef({base::radians(46.8), base::radians(9.8), {630}});
    const glm::dvec3 to = earth::to_ecef({base::radians(46.81), base::radians(9.81), {730}});
    const std::vector<glm::dvec3> places = places_of(room.batch, 2);
    for (std::size_t n = 0; n < places.size(); n += 2)
        EXPECT_LT(glm::length(glm::cross(places[n] - from, glm::normalize(to - from))), 0.02) << n;
    EXPECT_LT(glm::distance(places.front(), from), 0.02);
    EXPECT_LT(glm::distance(places[places.size() - 2], to), 0.02);
}

TEST(Cables, LongOnesHaveLongerSteps) {
    std::vector<scene::ScenePoint> points;
    for (int n = 0; n <= 20; ++n) points.push_back(scene_point(46.0 + 0.05 * n, 9.8, 1200));
    ElementOfTest test(cable(points, scene::HeightDatum::msl));
    SolidRoomOfTest room;
    EXPECT_EQ(add_cables(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_EQ(room.batch.use().refused, 0u);
    std::uint32_t vertices = 0;
    for (const SolidPiece& piece : room.batch.pieces())
        if (piece.look.is_mixed) vertices += piece.vertices;
    EXPECT_GT(vertices, 2 * 1024u);
    EXPECT_LE(vertices, 2 * (1024u + 2 * 20));
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

/// Control: with less detail a mast is another.
TEST(Cables, AreTheSameAtEveryDetail) {
    ElementOfTest line(cable({scene_point(46.8, 9.8, 30), scene_point(46.803, 9.8, 30)}, scene::HeightDatum::ground));
    ElementOfTest mast(obstacle("mast", 120));
    const auto vertices = [](ElementOfTest& test, double detail) {
        test.element.detail = detail;
        SolidRoomOfTest room;
        const bool is_line = test.input().layer.entry->shape == scene::LayerShape::lines;
        static_cast<void>(is_line ? add_cables(room.batch, room.mesh, test.input())
                                  : add_obstacle_points(room.batch, room.mesh, test.input()));
        return room.batch.vertices().size();
    };
    EXPECT_EQ(vertices(line, 1), vertices(line, 0));
    EXPECT_NE(vertices(mast, 1), vertices(mast, 0));
}

}  // namespace
}  // namespace tedavis::draw::test_obstacle_solids
