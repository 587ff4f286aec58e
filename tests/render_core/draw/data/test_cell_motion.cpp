#include "render_core/draw/data/cell_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_cell_motion {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

host_sim::LayerDraft cell(float speed_mps, float toward_deg) {
    host_sim::LayerDraft layer;
    layer.name = "storm";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::storm_cell;
    layer.points = {scene_point(46.8, 9.8, 0), scene_point(46.8, 9.81, 0), scene_point(46.81, 9.8, 0)};
    layer.starts = {0, 3};
    const auto bind = [&](const char* name, float value) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.of = scene::AttributeOf::feature;
        attribute.values = {value};
        layer.attributes.push_back(attribute);
    };
    bind("speed", speed_mps);
    bind("toward", static_cast<float>(base::radians(static_cast<double>(toward_deg))));
    return layer;
}

TEST(CellMotion, IsAsLongAsTheWayAndPointsThere) {
    const double latitude = base::radians(46.8), longitude = base::radians(9.8);
    const glm::dvec3 place = earth::to_ecef({latitude, longitude, {3000}});
    const LocalAxes axes = local_axes(latitude, longitude);
    for (const float toward_deg : {0.0f, 60.0f, 200.0f})
        for (const float speed : {3.0f, 12.0f, 40.0f}) {
            ElementOfTest test(cell(speed, toward_deg));
            SolidRoomOfTest room;
            const double toward = base::radians(static_cast<double>(toward_deg));
            add_motion_arrow(room.batch, room.mesh, test.input(), 0, {place, toward, true});
            ASSERT_EQ(room.batch.pieces().size(), 2u) << "itself and its rim";
            const SolidPiece& piece = room.batch.pieces()[0];
            EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
            EXPECT_GT(test_support::volume_m3(room.batch, piece), 0);
            // By where the tip is north and east of the front, not by the sine and cosine that the arrow is made with.
            glm::dvec3 tip(0);
            for (std::uint32_t n = 0; n < piece.vertices; ++n) {
                const glm::dvec3 at = piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m) - place;
                if (glm::length(at) > glm::length(tip)) tip = at;
            }
            EXPECT_NEAR(glm::length(tip), static_cast<double>(speed) * kMotionAhead_s, 1);
            const double bearing = std::atan2(glm::dot(tip, axes.east), glm::dot(tip, axes.north));
            EXPECT_NEAR(std::remainder(bearing - toward, 2 * base::kPi), 0, 1e-3);
            EXPECT_FALSE(piece.look.is_mixed);
        }
}

TEST(CellMotion, WhatStandsOrIsUnknownHasNone) {
    const auto moves = [](float speed, float toward) {
        ElementOfTest test(cell(speed, toward));
        return has_motion(test.input(), 0);
    };
    const float unknown = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(moves(10, 0));
    EXPECT_FALSE(moves(0.1f, 0));
    EXPECT_FALSE(moves(unknown, 0));
    EXPECT_FALSE(moves(10, unknown));
    ElementOfTest test(cell(10, 0));
    SolidRoomOfTest room;
    add_motion_arrow(room.batch, room.mesh, test.input(), 0, {glm::dvec3(0), 0, false});
    EXPECT_EQ(room.batch.pieces().size(), 0u) << "nobody knows where its front is";
}

}  // namespace
}  // namespace tedavis::draw::test_cell_motion
