#include "render_core/draw/data/ground_strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_ground_strips {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Of so many metres to the north.
host_sim::LayerDraft line_of(scene::LayerRole role, double length_m) {
    host_sim::LayerDraft layer;
    layer.name = "line";
    layer.shape = scene::LayerShape::lines;
    layer.role = role;
    const double north = base::degrees(length_m / earth::meridian_radius_m(base::radians(46.8)));
    layer.points = {scene_point(46.8, 9.8, kNone), scene_point(46.8 + north, 9.8, kNone)};
    layer.starts = {0, 2};
    return layer;
}

/// Sum of a piece's triangles that face up.
double upward_m2(const SolidBatch& batch, const SolidPiece& piece) {
    const glm::dvec3 up = piece.anchor / glm::length(piece.anchor);
    double area = 0;
    for (std::uint32_t n = 0; n < piece.indices; n += 3) {
        glm::dvec3 at[3];
        for (std::uint32_t k = 0; k < 3; ++k) {
            const SolidVertex& vertex = batch.vertices()[piece.first_vertex + batch.indices()[piece.first_index + n + k]];
            at[k] = glm::dvec3(vertex.place_m);
        }
        const double facing = 0.5 * glm::dot(glm::cross(at[1] - at[0], at[2] - at[0]), up);
        if (facing > 0) area += facing;
    }
    return area;
}

TEST(Ribbons, FollowTheGroundInShortSteps) {
    ElementOfTest test(line_of(scene::LayerRole::road, 4999));
    test.element.size_m = 12;
    SolidRoomOfTest room;
    EXPECT_EQ(add_ribbons(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_EQ(room.batch.vertices().size(), 25 * 4u) << "of 200 m";
    EXPECT_NEAR(upward_m2(room.batch, room.batch.pieces()[0]), 4999 * 12, 80);
    for (const SolidVertex& vertex : room.batch.vertices())
        EXPECT_NEAR(earth::from_ecef(room.batch.pieces()[0].anchor + glm::dvec3(vertex.place_m)).height.m, 600 + kStripLift_m,
                    0.05);
}

TEST(Ribbons, BendsStayAsWideAsTheirLegs) {
    host_sim::LayerDraft layer = line_of(scene::LayerRole::river, 1000);
    layer.points.push_back(layer.points[1]);
    layer.points.push_back(layer.points[1]);
    layer.points[3].longitude_rad += 1000 / (earth::prime_vertical_radius_m(0.8168) * std::cos(0.8168));
    layer.starts = {0, 4};
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_ribbons(room.batch, room.mesh, test.input()).drawn, 1u) << "a point that is twice there does no harm";
    EXPECT_NEAR(upward_m2(room.batch, room.batch.pieces()[0]), 2000 * kRiverWidth_m, 0.03 * 2000 * kRiverWidth_m);
}

TEST(Ribbons, LongLinesTakeSeveralMeshesAndFullBatchesHide) {
    ElementOfTest test(line_of(scene::LayerRole::road, 300'000));
    SolidRoomOfTest room;
    EXPECT_EQ(add_ribbons(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_EQ(room.batch.vertices().size(), 1500 * 4u);
    SolidRoomOfTest small(1000);
    EXPECT_EQ(add_ribbons(small.batch, small.mesh, test.input()).hidden, 1u);
    test.ground.is_known = false;
    EXPECT_EQ(add_ribbons(room.batch, room.mesh, test.input()).hidden, 1u);
}

/// Goes north in steps of 50 m, from side to side by so much.
host_sim::LayerDraft winding(double aside_m, std::size_t points) {
    host_sim::LayerDraft layer = line_of(scene::LayerRole::road, 50);
    const scene::ScenePoint first = layer.points[0], step = layer.points[1];
    const double east = aside_m / (earth::prime_vertical_radius_m(first.latitude_rad) * std::cos(first.latitude_rad));
    layer.points.clear();
    for (std::size_t n = 0; n < points; ++n) {
        scene::ScenePoint at = first;
        at.latitude_rad += static_cast<double>(n) * (step.latitude_rad - first.latitude_rad);
        at.longitude_rad += east * std::sin(0.7 * static_cast<double>(n));
        layer.points.push_back(at);
    }
    layer.starts = {0, static_cast<std::uint32_t>(points)};
    return layer;
}

/// The farthest that a point of a line is from the middle of the strip that is drawn, along the ground.
double farthest_m(const host_sim::LayerDraft& layer, const SolidBatch& batch) {
    double farthest = 0;
    for (const scene::ScenePoint& point : layer.points) {
        const glm::dvec3 at = earth::to_ecef({point.latitude_rad, point.longitude_rad, {600 + kStripLift_m}});
        double nearest = 1e9;
        for (const SolidPiece& piece : batch.pieces())
            for (std::uint32_t n = 0; n + 3 < piece.vertices; n += 4) {
                const auto place = [&](std::uint32_t k) {
                    return piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + n + k].place_m);
                };
                const glm::dvec3 from = 0.5 * (place(0) + place(1)), way = 0.5 * (place(2) + place(3)) - from;
                const double share = std::clamp(glm::dot(at - from, way) / glm::dot(way, way), 0.0, 1.0);
                nearest = std::min(nearest, glm::distance(at, from + share * way));
            }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

TEST(Ribbons, WithLittleDetailTheyAreStraighterWithinTheTolerance) {
    const host_sim::LayerDraft layer = winding(120, 90);
    ElementOfTest test(layer);
    std::size_t before = 1u << 30;
    for (const double detail : {1.0, 0.8, 0.6, 0.2}) {
        test.element.detail = detail;
        SolidRoomOfTest room;
        EXPECT_EQ(add_ribbons(room.batch, room.mesh, test.input()).drawn, 1u);
        EXPECT_LE(room.batch.vertices().size(), before);
        before = room.batch.vertices().size();
        EXPECT_LE(farthest_m(layer, room.batch), kMaxStraightened_m * (1 - detail) + 1) << detail;
        if (detail == 0.2) {
            EXPECT_GT(farthest_m(layer, room.batch), 60) << "control: it is no longer the true way";
        }
    }
    EXPECT_LT(before, 4 * 89u / 2) << "of 89 legs";
}

TEST(Ribbons, WithLittleDetailNarrowOnesAreLeftOut) {
    host_sim::LayerDraft layer = line_of(scene::LayerRole::road, 1000);
    layer.points.insert(layer.points.end(), layer.points.begin(), layer.points.begin() + 2);
    layer.points.insert(layer.points.end(), layer.points.begin(), layer.points.begin() + 2);
    layer.starts = {0, 2, 4, 6};
    host_sim::AttributeDraft width;
    width.name = "width";
    width.of = scene::AttributeOf::feature;
    width.values = {4, 20, kNone};
    layer.attributes.push_back(width);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_ribbons(room.batch, room.mesh, test.input()).drawn, 3u);
    test.element.detail = 0.25;
    const ElementCount count = add_ribbons(room.batch, room.mesh, test.input());
    EXPECT_EQ(count.drawn, 2u) << "nobody knows how wide the last one is";
    EXPECT_EQ(count.hidden, 1u);
}

}  // namespace
}  // namespace tedavis::draw::test_ground_strips
