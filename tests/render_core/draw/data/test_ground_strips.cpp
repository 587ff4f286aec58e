#include "render_core/draw/data/ground_strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/built_element.hpp"

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
double upward_m2(const SolidBatch& batch, const SolidPiece& piece, int least_red = 0) {
    const glm::dvec3 up = piece.anchor / glm::length(piece.anchor);
    double area = 0;
    for (std::uint32_t n = 0; n < piece.indices; n += 3) {
        glm::dvec3 at[3];
        int red = 255;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const SolidVertex& vertex = batch.vertices()[piece.first_vertex + batch.indices()[piece.first_index + n + k]];
            at[k] = glm::dvec3(vertex.place_m);
            red = std::min<int>(red, vertex.rgba[0]);
        }
        const double facing = 0.5 * glm::dot(glm::cross(at[1] - at[0], at[2] - at[0]), up);
        if (facing > 0 && red >= least_red) area += facing;
    }
    return area;
}

TEST(Runways, AreClosedSlabsOfTheirLengthAndWidth) {
    host_sim::LayerDraft layer = line_of(scene::LayerRole::runway, 1200);
    host_sim::AttributeDraft width;
    width.name = "width";
    width.of = scene::AttributeOf::feature;
    width.values = {45};
    layer.attributes.push_back(width);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_runways(room.batch, room.mesh, test.input()).drawn, 1u);
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_NEAR(upward_m2(room.batch, piece), 1200 * 45, 1200 * 45 * 0.002);
    EXPECT_NEAR(test_support::volume_m3(room.batch, piece), 1200 * 45 * 4, 1200 * 45 * 4 * 0.002);
    const double painted = upward_m2(room.batch, piece, 245);
    EXPECT_NEAR(painted, 2 * 30 * 45 * 6 / 15.0 + 0.6 * 1128 * 0.9, 60) << "stripes at both ends, dashes between";
    double low = 1e9, high = -1e9;
    for (const SolidVertex& vertex : room.batch.vertices()) {
        const double height = earth::from_ecef(piece.anchor + glm::dvec3(vertex.place_m)).height.m;
        low = std::min(low, height);
        high = std::max(high, height);
    }
    EXPECT_NEAR(high, 600 + kStripLift_m, 0.05);
    EXPECT_LT(low, 600) << "it reaches into the ground";
}

TEST(Runways, WithoutAWidthTheyHaveTheUsualOne) {
    ElementOfTest test(line_of(scene::LayerRole::runway, 800));
    SolidRoomOfTest room;
    EXPECT_EQ(add_runways(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_NEAR(upward_m2(room.batch, room.batch.pieces()[0]), 800 * kRunwayWidth_m, 100);
    test.element.size_m = 50;
    room.batch.clear();
    EXPECT_EQ(add_runways(room.batch, room.mesh, test.input()).drawn, 1u);
    EXPECT_NEAR(upward_m2(room.batch, room.batch.pieces()[0]), 800 * 50, 100);
}

TEST(Runways, LongOnesFitAndWhatIsNoneIsHidden) {
    SolidRoomOfTest room;
    const auto drawn = [&](double length_m, bool is_known = true) {
        ElementOfTest test(line_of(scene::LayerRole::runway, length_m));
        test.ground.is_known = is_known;
        const ElementCount count = add_runways(room.batch, room.mesh, test.input());
        EXPECT_EQ(count.all(), 1u);
        return count.drawn;
    };
    EXPECT_EQ(drawn(5500), 1u);
    EXPECT_EQ(drawn(8000 - 1), 1u);
    EXPECT_EQ(drawn(9000), 0u) << "longer than any";
    EXPECT_EQ(drawn(20), 0u);
    EXPECT_EQ(drawn(0), 0u);
    EXPECT_EQ(drawn(1200, false), 0u);
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

}  // namespace
}  // namespace tedavis::draw::test_ground_strips
