#include "render_core/draw/data/motion_times.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "render_core/draw/data/cell_motion.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_motion_times {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;
using test_support::SolidRoomOfTest;

constexpr double kAhead_m = 20'000, kWide_m = 8000;
constexpr float kBase_m = 2000;

/// As far to the left as it is wide; it moves to the right.
host_sim::LayerDraft cell(float speed_mps) {
    host_sim::LayerDraft layer;
    layer.name = "storm";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::storm_cell;
    layer.points = {BillboardRoom::point(kAhead_m - 1000, -kWide_m, 0), BillboardRoom::point(kAhead_m - 1000, 0, 0),
                    BillboardRoom::point(kAhead_m + 1000, 0, 0), BillboardRoom::point(kAhead_m + 1000, -kWide_m, 0)};
    layer.starts = {0, 4};
    const auto bind = [&](const char* name, float value) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.of = scene::AttributeOf::feature;
        attribute.values = {value};
        layer.attributes.push_back(attribute);
    };
    bind("floor", kBase_m);
    bind("ceiling", 6000);
    bind("speed", speed_mps);
    bind("toward", static_cast<float>(base::radians(90)));
    return layer;
}

std::uint32_t add_times(BillboardRoom& room, float speed_mps) {
    ElementOfTest test(cell(speed_mps));
    SolidRoomOfTest solids;
    ElementInput input = test.input();
    input.eye = room.view.eye;
    return add_motion_times(room.sheet, solids.mesh, input);
}

/// Columns of the barbs by a pinhole. Control: the first barb is elsewhere.
TEST(MotionTimes, StandAtTheFarthestBarb) {
    for (const auto& [speed_mps, after_s] : {std::pair(4.0f, 1800.0), std::pair(10.0f, 600.0)}) {
        BillboardRoom room;
        ASSERT_EQ(add_times(room, speed_mps), 1u);
        ASSERT_EQ(room.sheet.boxes().size(), 1u);
        EXPECT_GT(room.glyph_vertices(), 0u);
        const double speed = static_cast<double>(speed_mps);
        const auto column = [&](double seconds) {
            return room.view.width / 2.0 + room.view.focal_px * speed * seconds / kAhead_m;
        };
        const double middle = static_cast<double>(room.sheet.boxes()[0].center().x);
        EXPECT_NEAR(middle, column(after_s), 4) << speed_mps;
        EXPECT_GT(std::fabs(middle - column(kBarbEvery_s)), 20) << "control";
    }
}

/// Where its room below is taken it stands above; where there is none anywhere, nowhere.
TEST(MotionTimes, CoverNoOtherSign) {
    BillboardRoom room;
    ASSERT_EQ(add_times(room, 4), 1u);
    const Rect below = room.sheet.boxes()[0];
    BillboardRoom taken;
    ASSERT_TRUE(taken.sheet.claim_beside(below));
    ASSERT_EQ(add_times(taken, 4), 1u);
    EXPECT_FALSE(taken.sheet.boxes()[1].overlaps(below));
    EXPECT_LT(taken.sheet.boxes()[1].bottom(), below.y);
    BillboardRoom full;
    ASSERT_TRUE(full.sheet.claim_beside({below.x - 100, below.y - 100, 200 + below.width, 200 + below.height}));
    EXPECT_EQ(add_times(full, 4), 0u);
    EXPECT_EQ(full.glyph_vertices(), 0u);
}

TEST(MotionTimes, WhatStandsOrHasNoBarbHasNone) {
    BillboardRoom room;
    EXPECT_EQ(add_times(room, 0), 0u);
    EXPECT_EQ(add_times(room, 60), 0u) << "the line ends before its first barb";
    EXPECT_EQ(add_times(room, 4), 1u) << "control";
}

}  // namespace
}  // namespace tedavis::draw::test_motion_times
