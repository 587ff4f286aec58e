#include "render_core/draw/data/wind_barb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_wind_barb {
namespace {

using test_support::BillboardRoom;

constexpr double kKnot_mps = 1852.0 / 3600.0;
constexpr Point kWest{-1, 0};

scene::Wind wind(double knots, scene::WindState state = scene::WindState::steady) { return {state, 0, knots * kKnot_mps, 1}; }

BarbStyle style(bool is_southern = false) { return {40, is_southern, {255, 255, 255}, {255, 255, 255}}; }

/// White ink above and below the row of the ring.
struct Ink {
    int above = 0, below = 0, left = 0, right = 0;
};
Ink ink_of(Point from, const scene::Wind& wind, const BarbStyle& style) {
    BillboardRoom room;
    EXPECT_TRUE(draw_wind_barb(room.batch, {100, 100}, from, wind, style));
    EXPECT_LE(room.drawn().size(), kMaxBarbVertices);
    test_support::Picture picture(200, 200, {0, 0, 0});
    rasterize(room.batch, picture);
    Ink ink;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            if (picture.at(x, y).red < 128) continue;
            ink.above += y < 94 ? 1 : 0;
            ink.below += y > 106 ? 1 : 0;
            ink.left += x < 94 ? 1 : 0;
            ink.right += x > 106 ? 1 : 0;
        }
    return ink;
}

TEST(WindBarb, FlagsAddUpToTheSpeedInFives) {
    for (int knots = 0; knots <= 250; ++knots) {
        const BarbFlags flags = barb_flags(knots * kKnot_mps);
        const int shown = 50 * flags.pennants + 10 * flags.barbs + 5 * flags.halves;
        EXPECT_LE(std::abs(shown - knots), 2) << knots;
        EXPECT_LE(flags.barbs, 4);
        EXPECT_LE(flags.halves, 1);
    }
    EXPECT_EQ(barb_flags(900).pennants, 5) << "no more than 250 knots";
    EXPECT_EQ(barb_flags(std::nan("")).pennants, 0);
    EXPECT_EQ(barb_flags(-5).barbs, 0);
}

TEST(WindBarb, FlagsAreOnTheSideOfTheLowPressure) {
    // A west wind blows to the right; on its left, above, is the low of the northern hemisphere.
    const Ink north = ink_of(kWest, wind(65), style()), south = ink_of(kWest, wind(65), style(true));
    EXPECT_GT(north.above, 50);
    EXPECT_EQ(north.below, 0);
    EXPECT_GT(south.below, 50);
    EXPECT_EQ(south.above, 0);
    EXPECT_GT(north.left, 0);
    EXPECT_EQ(north.right, 0) << "the staff leads to where it comes from";
    const Ink from_south = ink_of({0, 1}, wind(65), style());
    EXPECT_GT(from_south.left, 30);
    EXPECT_EQ(from_south.right, 0);
}

TEST(WindBarb, MoreWindHasMoreInk) {
    for (const auto& speeds : {std::vector<double>{1, 5, 10, 15, 25, 45}, {50, 100, 150}}) {
        int before = -1;
        for (const double knots : speeds) {
            const Ink ink = ink_of(kWest, wind(knots), style());
            EXPECT_GT(ink.above, before) << knots;
            before = ink.above;
        }
    }
    EXPECT_EQ(ink_of(kWest, wind(1), style()).above, 0) << "a staff alone";
    EXPECT_GT(ink_of(kWest, wind(1), style()).left, 0);
}

TEST(WindBarb, WithoutADirectionThereIsNoStaff) {
    using scene::WindState;
    std::size_t vertices[3];
    int n = 0;
    for (const WindState state : {WindState::calm, WindState::variable, WindState::unknown}) {
        BillboardRoom room;
        EXPECT_TRUE(draw_wind_barb(room.batch, {100, 100}, kWest, wind(9, state), style()));
        EXPECT_LT(std::fmax(room.bounds().width, room.bounds().height), 26) << "rings and a letter";
        vertices[n++] = room.glyph_vertices();
    }
    EXPECT_EQ(vertices[0], 0u) << "two rings";
    EXPECT_EQ(vertices[1], 8u) << "a letter and its halo";
    EXPECT_EQ(vertices[2], 8u);
}

TEST(WindBarb, AFullBatchSaysSo) {
    BillboardRoom room(40);
    EXPECT_FALSE(draw_wind_barb(room.batch, {100, 100}, kWest, wind(35), style()));
}

}  // namespace
}  // namespace tedavis::draw::test_wind_barb
