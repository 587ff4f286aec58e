#include "render_core/draw/data/solid_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_solid_shapes {
namespace {

using test_support::open_edges;
using test_support::SolidRoomOfTest;
using test_support::volume_m3;

const glm::dvec3 kFoot(4'000'000, 900'000, 4'900'000);

double volume_of(SolidRoomOfTest& room) {
    room.batch.clear();
    EXPECT_TRUE(room.mesh.add_to(room.batch));
    EXPECT_EQ(open_edges(room.batch, room.batch.pieces()[0]), 0u);
    return volume_m3(room.batch, room.batch.pieces()[0]);
}

/// Of a regular polygon with its corners on a circle.
double polygon_m2(int sides, double radius) { return 0.5 * sides * radius * radius * std::sin(2 * base::kPi / sides); }

TEST(SolidShapes, AFrustumHasItsVolumeAnyWayRound) {
    for (const glm::dvec3& way : {glm::dvec3(0, 0, 30), glm::dvec3(-12, 5, 8), glm::dvec3(0, -40, 0)})
        for (const int sides : {3, 4, 10}) {
            SolidRoomOfTest room;
            room.mesh.begin(kFoot);
            add_frustum(room.mesh, kFoot, kFoot + way, 4, 2, sides, {1, 0.3, 0.1});
            const double a = polygon_m2(sides, 4), b = polygon_m2(sides, 2);
            const double expected = glm::length(way) / 3 * (a + b + std::sqrt(a * b));
            EXPECT_NEAR(volume_of(room), expected, expected * 1e-4) << sides;
        }
}

TEST(SolidShapes, ATipIsClosed) {
    SolidRoomOfTest room;
    room.mesh.begin(kFoot);
    add_frustum(room.mesh, kFoot, kFoot + glm::dvec3(0, 0, 9), 2, 0, 6, {1, 0, 0});
    EXPECT_NEAR(volume_of(room), polygon_m2(6, 2) * 3, 1e-3);
}

TEST(SolidShapes, WithoutAWayThereIsNone) {
    SolidRoomOfTest room;
    room.mesh.begin(kFoot);
    add_frustum(room.mesh, kFoot, kFoot, 2, 1, 6, {1, 0, 0});
    add_frustum(room.mesh, kFoot, kFoot + glm::dvec3(5, 0, 0), 2, 1, 6, {1, 0, 0});
    add_ellipsoid(room.mesh, kFoot, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0, 5);
    EXPECT_EQ(room.mesh.vertex_count(), 0u);
}

TEST(SolidShapes, ABoxHasItsVolume) {
    SolidRoomOfTest room;
    room.mesh.begin(kFoot);
    add_box(room.mesh, kFoot, {3, 0, 0}, {0, 2, 0}, {0, 0, 1});
    EXPECT_NEAR(volume_of(room), 8 * 6, 1e-3);
}

TEST(SolidShapes, AnEllipsoidIsNearlyRoundAndOutward) {
    SolidRoomOfTest room;
    const LocalAxes axes = local_axes(0.8, 0.2);
    room.mesh.begin(kFoot);
    add_ellipsoid(room.mesh, kFoot, axes, 30, 10);
    const double round = 4.0 / 3 * base::kPi * 30 * 30 * 10;
    const double volume = volume_of(room);
    EXPECT_LT(volume, round) << "its corners lie on it";
    EXPECT_GT(volume, 0.8 * round);
    for (const SolidVertex& vertex : room.batch.vertices()) {
        const glm::dvec3 at(vertex.place_m);
        const double x = glm::dot(at, axes.east) / 30, y = glm::dot(at, axes.north) / 30, z = glm::dot(at, axes.up) / 10;
        EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-5);
        glm::dvec3 normal(0);
        for (int n = 0; n < 3; ++n) normal[n] = (vertex.normal[n] - 127.0) / 127;
        const glm::dvec3 gradient = axes.east * (x / 30) + axes.north * (y / 30) + axes.up * (z / 10);
        EXPECT_GT(glm::dot(normal, glm::normalize(gradient)), 0.99);
    }
}

}  // namespace
}  // namespace tedavis::draw::test_solid_shapes
