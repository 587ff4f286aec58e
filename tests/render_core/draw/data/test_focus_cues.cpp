#include "render_core/draw/data/focus_cues.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/foci_of_test.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_focus_cues {
namespace {

using test_support::BillboardRoom;
using test_support::FociOfTest;

/// So many metres ahead of the eye, which looks north, and right of it.
std::string at(double ahead_m, double right_m) {
    const scene::ScenePoint point = BillboardRoom::point(ahead_m, right_m, 0);
    return "name = \"LAKE\", at = \"position\", radius_m = 200, position_deg = [" +
           std::to_string(base::degrees(point.latitude_rad)) + ", " + std::to_string(base::degrees(point.longitude_rad)) + "]";
}

struct Cued {
    explicit Cued(const std::string& line, const QuadBatch* symbology = nullptr) : foci({line}) {
        foci.own_ship.position.height.m = BillboardRoom::kEyeHeight_m;
        foci.plan_again();
        room.begin(symbology);
        cues = add_focus_cues(room.sheet, foci.frame(), foci.ground, base::DisplayUnits::feet_and_knots);
    }
    BillboardRoom room;
    FociOfTest foci;
    FocusCues cues;
};

TEST(FocusCues, WhatIsSeenNeedsNone) {
    const Cued ahead(at(5000, 300));
    EXPECT_EQ(ahead.cues[0].sight, FocusSight::seen);
    EXPECT_FALSE(ahead.cues[0].is_drawn);
    EXPECT_TRUE(ahead.room.drawn().empty());
    const Cued inside(at(-100, 50));
    EXPECT_EQ(inside.cues[0].sight, FocusSight::around);
    EXPECT_TRUE(inside.room.drawn().empty());
}

TEST(FocusCues, AnArrowLeadsOutOfThePictureToTheRightSide) {
    for (const double right_m : {-8000.0, 8000.0})
        for (const double ahead_m : {3000.0, -3000.0}) {
            const Cued cued(at(ahead_m, right_m));
            EXPECT_EQ(cued.cues[0].sight, FocusSight::out_of_view);
            ASSERT_TRUE(cued.cues[0].is_drawn);
            const Rect bounds = cued.room.bounds();
            EXPECT_GE(bounds.x, 0);
            EXPECT_LE(bounds.x + bounds.width, 800);
            EXPECT_GE(bounds.y, 0);
            EXPECT_LE(bounds.y + bounds.height, 600);
            const bool is_right = bounds.x > 650, is_left = bounds.x + bounds.width < 150;
            EXPECT_EQ(is_right, right_m > 0);
            EXPECT_EQ(is_left, right_m < 0);
            EXPECT_NEAR(cued.cues[0].distance_m, std::hypot(8000, 3000), 30);
            EXPECT_GT(cued.room.glyph_vertices(), 4 * 2 * 8u) << "LAKE and 4.6 NM, with halos";
        }
}

/// Symbols stand on the right edge; the arrow goes up or down along it, or farther in.
TEST(FocusCues, NothingOfTheSymbologyIsCovered) {
    std::vector<QuadVertex> vertices(256);
    std::vector<std::uint16_t> indices(512);
    QuadBatch symbology({vertices.data(), vertices.size()}, {indices.data(), indices.size()});
    const Rect tape{640, 0, 160, 600};
    ASSERT_TRUE(symbology.box(tape, {255, 255, 255}));
    const Cued cued(at(3000, 8000), &symbology);
    ASSERT_TRUE(cued.cues[0].is_drawn);
    EXPECT_FALSE(cued.room.bounds().overlaps(tape));
    ASSERT_TRUE(symbology.box({0, 0, 800, 600}, {255, 255, 255}));
    const Cued none(at(3000, 8000), &symbology);
    EXPECT_EQ(none.cues[0].sight, FocusSight::out_of_view);
    EXPECT_FALSE(none.cues[0].is_drawn) << "and the record says so";
    EXPECT_TRUE(none.room.drawn().empty());
}

TEST(FocusCues, SeveralKeepClearOfEachOther) {
    FociOfTest foci({at(3000, 8000), at(3010, 8010), at(2990, 8000)});
    BillboardRoom room;
    const FocusCues cues = add_focus_cues(room.sheet, foci.frame(), foci.ground, base::DisplayUnits::metric);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_TRUE(cues[n].is_drawn) << n;
    EXPECT_GT(room.bounds().height, 3 * 2 * 16);
}

TEST(FocusCues, WhatIsNowhereHasNone) {
    FociOfTest foci({R"(at = "own_ship")"});
    foci.own_ship.state = base::SignalState::lost;
    foci.plan_again();
    BillboardRoom room;
    EXPECT_EQ(add_focus_cues(room.sheet, foci.frame(), foci.ground, base::DisplayUnits::feet_and_knots)[0].sight,
              FocusSight::nowhere);
    EXPECT_STREQ(name_of(FocusSight::behind_terrain), "behind terrain");
}

}  // namespace
}  // namespace tedavis::draw::test_focus_cues
