#include "render_core/draw/data/area_prisms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/cell_motion.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_area_prisms {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr double kLatitude_deg = 46.8, kLongitude_deg = 9.8;

/// A square of 1000 m, counter-clockwise from its south-west corner.
host_sim::LayerDraft square(bool clockwise = false) {
    host_sim::LayerDraft layer;
    layer.name = "zone";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::no_go;
    const double latitude = base::radians(kLatitude_deg);
    const double north = base::degrees(1000 / earth::meridian_radius_m(latitude));
    const double east = base::degrees(1000 / (earth::prime_vertical_radius_m(latitude) * std::cos(latitude)));
    layer.points = {scene_point(kLatitude_deg, kLongitude_deg, 0), scene_point(kLatitude_deg, kLongitude_deg + east, 0),
                    scene_point(kLatitude_deg + north, kLongitude_deg + east, 0),
                    scene_point(kLatitude_deg + north, kLongitude_deg, 0)};
    if (clockwise) std::reverse(layer.points.begin(), layer.points.end());
    layer.starts = {0, 4};
    return layer;
}

void bind(host_sim::LayerDraft& layer, const char* name, float value) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = scene::AttributeOf::feature;
    attribute.values = {value};
    layer.attributes.push_back(attribute);
}

void bind_datum(host_sim::LayerDraft& layer, const char* name, float code) {
    bind(layer, name, code);
    layer.attributes.back().scale = scene::AttributeScale::nominal;
    layer.attributes.back().classes = {"msl", "ground", "standard"};
}

/// Least and greatest height over the ellipsoid of a piece.
struct Reach {
    double low = 1e9, high = -1e9;
};
Reach reach_of(const SolidBatch& batch, const SolidPiece& piece) {
    Reach reach;
    for (std::uint32_t n = 0; n < piece.vertices; ++n) {
        const glm::dvec3 at = piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + n].place_m);
        const double height = earth::from_ecef(at).height.m;
        reach.low = std::min(reach.low, height);
        reach.high = std::max(reach.high, height);
    }
    return reach;
}

TEST(AreaPrisms, ASquareHasTheVolumeOfABox) {
    for (const bool clockwise : {false, true}) {
        host_sim::LayerDraft layer = square(clockwise);
        bind(layer, "floor", 1500);
        bind(layer, "ceiling", 2500);
        ElementOfTest test(layer);
        SolidRoomOfTest room;
        const ElementCount count = add_area_prisms(room.batch, room.mesh, test.input());
        EXPECT_EQ(count.drawn, 1u);
        ASSERT_EQ(room.batch.pieces().size(), 1u);
        const SolidPiece& piece = room.batch.pieces()[0];
        EXPECT_NEAR(test_support::volume_m3(room.batch, piece), 1e9, 2e6) << "the Earth is 0.06 % wider up there";
        EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
        const Reach reach = reach_of(room.batch, piece);
        EXPECT_NEAR(reach.low, 1550, 0.01);
        EXPECT_NEAR(reach.high, 2550, 0.01);
        EXPECT_EQ(piece.look.group, 3);
    }
}

TEST(AreaPrisms, LimitsOverTheGroundFollowIt) {
    host_sim::LayerDraft layer = square();
    bind(layer, "ceiling", 100);
    bind_datum(layer, "ceiling_datum", 1);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_area_prisms(room.batch, room.mesh, test.input()).drawn, 1u);
    const Reach reach = reach_of(room.batch, room.batch.pieces()[0]);
    EXPECT_NEAR(reach.low, 600, 0.01) << "no floor: from the ground";
    EXPECT_NEAR(reach.high, 700, 0.01);
    test.ground.is_known = false;
    room.batch.clear();
    const ElementCount none = add_area_prisms(room.batch, room.mesh, test.input());
    EXPECT_EQ(none.hidden, 1u);
    EXPECT_EQ(room.batch.pieces().size(), 0u);
}

TEST(AreaPrisms, AnUnknownCeilingIsAboveEverybody) {
    host_sim::LayerDraft layer = square();
    bind(layer, "floor", 1000);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    static_cast<void>(add_area_prisms(room.batch, room.mesh, test.input()));
    EXPECT_NEAR(reach_of(room.batch, room.batch.pieces()[0]).high, kUnknownCeiling_m + 50, 0.01);
}

TEST(AreaPrisms, AValueMayStandForTheHeight) {
    host_sim::LayerDraft layer = square();
    bind(layer, "floor", 1000);
    bind(layer, "intensity", 30);
    ElementOfTest test(layer);
    test.element.size_attribute = "intensity";
    test.element.size_m = 4000;
    SolidRoomOfTest room;
    static_cast<void>(add_area_prisms(room.batch, room.mesh, test.input()));
    const Reach reach = reach_of(room.batch, room.batch.pieces()[0]);
    EXPECT_NEAR(reach.high - reach.low, 4000, 0.01) << "the largest value of the layer";
}

TEST(AreaPrisms, CellsGoWithTheirSpeedFromTheTimeOfTheData) {
    host_sim::LayerDraft layer = square();
    layer.role = scene::LayerRole::storm_cell;
    layer.data_time_ns = 1'000'000'000'000;
    bind(layer, "floor", 1000);
    bind(layer, "ceiling", 2000);
    bind(layer, "speed", 12);
    bind(layer, "toward", static_cast<float>(base::radians(90)));
    ElementOfTest test(layer);
    EXPECT_TRUE(prisms_move(test.input().layer));
    SolidRoomOfTest still, later;
    static_cast<void>(add_area_prisms(still.batch, still.mesh, test.input()));
    test.time_ns = layer.data_time_ns + 600'000'000'000;
    static_cast<void>(add_area_prisms(later.batch, later.mesh, test.input()));
    EXPECT_LT(glm::distance(still.batch.pieces()[0].anchor, later.batch.pieces()[0].anchor), 1e-9) << "time is no date";
    test.has_date = true;
    later.batch.clear();
    static_cast<void>(add_area_prisms(later.batch, later.mesh, test.input()));
    const auto middle = [](const SolidBatch& batch) {
        glm::dvec3 sum(0);
        const base::Span<const SolidVertex> cell = batch.vertices().subspan(0, batch.pieces()[0].vertices);
        for (const SolidVertex& vertex : cell) sum += glm::dvec3(vertex.place_m);
        return batch.pieces()[0].anchor + sum / static_cast<double>(cell.size());
    };
    const glm::dvec3 gone = middle(later.batch) - middle(still.batch);
    const LocalAxes axes = local_axes(base::radians(kLatitude_deg), base::radians(kLongitude_deg));
    EXPECT_NEAR(glm::dot(gone, axes.east), 7200, 20);
    EXPECT_NEAR(glm::dot(gone, axes.north), 0, 20);
}

TEST(AreaPrisms, LongSidesAreCutAndTooManyCornersHidden) {
    host_sim::LayerDraft layer = square();
    for (scene::ScenePoint& point : layer.points) {
        point.latitude_rad = base::radians(kLatitude_deg) + 10 * (point.latitude_rad - base::radians(kLatitude_deg));
        point.longitude_rad = base::radians(kLongitude_deg) + 10 * (point.longitude_rad - base::radians(kLongitude_deg));
    }
    bind(layer, "ceiling", 3000);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_area_prisms(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_GE(room.batch.pieces()[0].vertices, 4 * 5 * 6u) << "sides of 2 km";
    for (scene::ScenePoint& point : layer.points) point.latitude_rad += point.latitude_rad > 0.8173 ? 0.2 : 0;
    ElementOfTest huge(layer);
    room.batch.clear();
    EXPECT_EQ(add_area_prisms(room.batch, room.mesh, huge.input()).hidden, 1u);
}

TEST(AreaPrisms, AnUncertainPlaceReachesFarther) {
    host_sim::LayerDraft layer = square();
    layer.position_accuracy_m = 200;
    bind(layer, "floor", 1000);
    bind(layer, "ceiling", 2000);
    ElementOfTest test(layer);
    test.element.uncertainty = design::ElementUncertainty::widening;
    SolidRoomOfTest room;
    static_cast<void>(add_area_prisms(room.batch, room.mesh, test.input()));
    ASSERT_EQ(room.batch.pieces().size(), 2u);
    EXPECT_NEAR(test_support::volume_m3(room.batch, room.batch.pieces()[1]), 1400.0 * 1400 * 1000, 4e6);
    EXPECT_LT(room.batch.pieces()[1].look.opacity, room.batch.pieces()[0].look.opacity);
    EXPECT_TRUE(room.batch.pieces()[1].look.is_mixed);
}

/// Of a piece seen from above: the area that its upper faces cover.
double covered_m2(const SolidBatch& batch, const SolidPiece& piece) {
    const glm::dvec3 up = earth::up_at(piece.anchor);
    double area = 0;
    for (std::uint32_t n = 0; n + 2 < piece.indices; n += 3) {
        const auto at = [&](std::uint32_t k) {
            return glm::dvec3(batch.vertices()[piece.first_vertex + batch.indices()[piece.first_index + n + k]].place_m);
        };
        area += std::max(0.0, 0.5 * glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), up));
    }
    return area;
}

/// With 40 corners.
host_sim::LayerDraft disk() {
    host_sim::LayerDraft layer = square();
    const scene::ScenePoint middle = layer.points[0];
    const double across = layer.points[1].longitude_rad - middle.longitude_rad;
    const double along = layer.points[3].latitude_rad - middle.latitude_rad;
    layer.points.clear();
    for (int n = 0; n < 40; ++n) {
        scene::ScenePoint at = middle;
        at.longitude_rad += across * std::cos(base::kPi * n / 20);
        at.latitude_rad += along * std::sin(base::kPi * n / 20);
        layer.points.push_back(at);
    }
    layer.starts = {0, 40};
    bind(layer, "floor", 1000);
    bind(layer, "ceiling", 2000);
    return layer;
}

TEST(AreaPrisms, WithLittleDetailTheyHaveFewerCornersAndCoverMore) {
    ElementOfTest test(disk());
    double least = base::kPi * 1e6 * 0.99;
    std::size_t before = 1u << 20;
    for (const double detail : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        test.element.detail = detail;
        SolidRoomOfTest room;
        EXPECT_EQ(add_area_prisms(room.batch, room.mesh, test.input()).drawn, 1u);
        const double area = covered_m2(room.batch, room.batch.pieces()[0]);
        EXPECT_GE(area, least) << detail;
        EXPECT_LE(area, base::kPi * 1e6 * (1 + kMaxOutlineGrowth * (1 - detail)) * 1.002);
        EXPECT_LE(room.batch.vertices().size(), before);
        least = area * 0.999;
        before = room.batch.vertices().size();
    }
    EXPECT_LT(before, 40u) << "of 40 corners there is about a box left";
}

TEST(AreaPrisms, WithLittleDetailLowBuildingsAreLeftOutAndNothingElse) {
    for (const scene::LayerRole role : {scene::LayerRole::building, scene::LayerRole::no_go}) {
        host_sim::LayerDraft layer = square();
        layer.role = role;
        layer.points.insert(layer.points.end(), layer.points.begin(), layer.points.begin() + 4);
        layer.starts = {0, 4, 8};
        bind(layer, "height", 6);
        layer.attributes.back().values.push_back(30);
        ElementOfTest test(layer);
        test.element.detail = 0.25;
        SolidRoomOfTest room;
        const ElementCount count = add_area_prisms(room.batch, room.mesh, test.input());
        EXPECT_EQ(count.hidden, role == scene::LayerRole::building ? 1u : 0u);
        EXPECT_EQ(count.all(), 2u);
    }
}

TEST(AreaPrisms, TheLineOfACellsMotionBeginsAtItsFront) {
    host_sim::LayerDraft layer = square();
    layer.role = scene::LayerRole::storm_cell;
    bind(layer, "floor", 1000);
    bind(layer, "ceiling", 2000);
    bind(layer, "speed", 12);
    bind(layer, "toward", static_cast<float>(base::radians(90)));
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    ElementInput input = test.input();
    input.eye = earth::to_ecef({base::radians(kLatitude_deg), base::radians(kLongitude_deg - 0.5), {1500}});
    static_cast<void>(add_area_prisms(room.batch, room.mesh, input));
    ASSERT_EQ(room.batch.pieces().size(), 3u) << "the cell, the line and its rim";
    const LocalAxes axes = local_axes(base::radians(kLatitude_deg), base::radians(kLongitude_deg));
    const auto reach = [&](const SolidPiece& piece, double sign) {
        double farthest = -1e9;
        for (std::uint32_t n = 0; n < piece.vertices; ++n) {
            const glm::dvec3 at = piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m);
            farthest = std::max(farthest, sign * glm::dot(at, axes.east));
        }
        return sign * farthest;
    };
    const double front = reach(room.batch.pieces()[0], 1);
    EXPECT_NEAR(reach(room.batch.pieces()[1], -1), front, 2);
    // Far away, and straight away from the eye: nothing cuts it.
    EXPECT_NEAR(reach(room.batch.pieces()[1], 1), front + 12 * kMotionAhead_s, 60);
    layer.role = scene::LayerRole::airspace;
    ElementOfTest airspace(layer);
    room.batch.clear();
    static_cast<void>(add_area_prisms(room.batch, room.mesh, airspace.input()));
    EXPECT_EQ(room.batch.pieces().size(), 1u) << "what stands has none";
}

}  // namespace
}  // namespace tedavis::draw::test_area_prisms
