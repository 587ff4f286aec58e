#include "render_core/draw/data/ghost_signs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_ghost_signs {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

constexpr std::int64_t kStart_ns = 1'780'000'000'000'000'000;
constexpr design::Color kColor{224, 140, 255};

std::int64_t time_ns(double second) { return kStart_ns + static_cast<std::int64_t>(second * 1e9); }

/// From 3 km ahead to the right, 10 m/s, for five minutes.
host_sim::LayerDraft ghosts(const std::string& name = "GHOST a") {
    host_sim::LayerDraft layer;
    layer.name = "ghosts";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::ghost;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    layer.names = {name};
    for (int n = 0; n <= 30; ++n) {
        layer.points.push_back(BillboardRoom::point(3000, 100.0 * n - 1500, 1000));
        layer.points.back().time_ns = time_ns(10 * n);
    }
    layer.starts = {0, 31};
    return layer;
}

struct Drawn {
    explicit Drawn(double second, const host_sim::LayerDraft& layer = ghosts(), std::size_t vertices = 16'384)
        : test(layer), room(vertices) {
        test.element.color = kColor;
        test.time_ns = time_ns(second);
        ElementInput input = test.input();
        input.eye = room.view.eye;
        count = add_ghost_signs(room.sheet, input);
    }
    /// The sign without its name.
    [[nodiscard]] Rect sign() const {
        float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
        for (const QuadVertex& vertex : room.batch.vertices()) {
            if (vertex.extent_x < 0) continue;
            left = std::min(left, vertex.x), right = std::max(right, vertex.x);
            top = std::min(top, vertex.y), bottom = std::max(bottom, vertex.y);
        }
        return {left, top, right - left, bottom - top};
    }
    ElementOfTest test;
    BillboardRoom room;
    ElementCount count;
};

Point spot_of(const Drawn& drawn, double right_m) {
    const scene::ScenePoint at = BillboardRoom::point(3000, right_m, 0);
    return drawn.room.sheet.spot(earth::to_ecef({at.latitude_rad, at.longitude_rad, {1000}})).at;
}

TEST(GhostSigns, StandWhereTheFlightIsThenAlsoBetweenItsPoints) {
    for (const double second : {40.0, 95.0, 103.7, 150.0}) {
        const Drawn drawn(second);
        EXPECT_EQ(drawn.count.drawn, 1u);
        EXPECT_NEAR(drawn.sign().center().x, spot_of(drawn, 10 * second - 1500).x, 0.5) << second;
    }
}

TEST(GhostSigns, BeforeAndAfterTheFlightThereIsNone) {
    for (const double second : {-1.0, 301.0}) {
        const Drawn drawn(second);
        EXPECT_EQ(drawn.count.drawn, 0u);
        EXPECT_EQ(drawn.count.hidden, 1u);
        EXPECT_TRUE(drawn.room.drawn().empty());
    }
    EXPECT_EQ(Drawn(0).count.drawn + Drawn(300).count.drawn, 2u) << "its ends belong to it";
}

TEST(GhostSigns, PointsWithoutTimesHaveNone) {
    host_sim::LayerDraft layer = ghosts();
    for (scene::ScenePoint& point : layer.points) point.time_ns = scene::kNoTime;
    EXPECT_TRUE(Drawn(100, layer).room.drawn().empty());
}

/// The way reaches 120 s back and ahead, 1,200 m each, and no farther; what comes is fainter.
TEST(GhostSigns, TheWayIsAThinLineThatIsFaintAhead) {
    const Drawn drawn(150);
    float left = 1e9f, right = -1e9f;
    for (const QuadVertex& vertex : drawn.room.links.vertices()) {
        left = std::min(left, vertex.x), right = std::max(right, vertex.x);
        if (vertex.rgba[0] == 0) continue;
        const bool is_flown = vertex.x<spot_of(drawn, 0).x - 2, comes = vertex.x> spot_of(drawn, 0).x + 2;
        if (is_flown) {
            EXPECT_EQ(vertex.rgba[3], 255);
        }
        if (comes) {
            EXPECT_LT(vertex.rgba[3], 128);
        }
    }
    EXPECT_NEAR(left, spot_of(drawn, -1200).x, 4);
    EXPECT_NEAR(right, spot_of(drawn, 1200).x, 4);
    EXPECT_LE(drawn.room.links.vertices().size(), std::size_t{8} * (240 / kGhostLine_s + 2));
}

/// Its own color alone, dark rims beside: no warning's red or amber, no number, no arrow. Letters are those of its name.
TEST(GhostSigns, SayNothingButWhoItIs) {
    const Drawn drawn(100);
    for (const QuadVertex& vertex : drawn.room.drawn()) {
        const bool is_rim = vertex.rgba[0] == 0 && vertex.rgba[1] == 0 && vertex.rgba[2] == 0;
        EXPECT_TRUE(is_rim || (vertex.rgba[0] == kColor.red && vertex.rgba[1] == kColor.green && vertex.rgba[2] == kColor.blue));
    }
    EXPECT_EQ(drawn.room.glyph_vertices(), 8u * 6) << "GHOST a: six letters and their halos";
    EXPECT_EQ(Drawn(100, ghosts("")).room.glyph_vertices(), 0u);
}

TEST(GhostSigns, AFullBatchLeavesSignsOutWhole) {
    const Drawn drawn(100, ghosts(), 24);
    EXPECT_EQ(drawn.count.drawn, 0u);
    EXPECT_EQ(drawn.room.batch.use().refused + drawn.room.links.use().refused, 0u);
}

/// Straight between two points, whichever side of 180 degrees they are on.
TEST(GhostSigns, APlaceIsInProportionOfTime) {
    host_sim::LayerDraft layer = ghosts();
    layer.points = {{0.5, 3.1, 100, 0, 0}, {0.6, -3.1, 200, 0, 1'000}};
    layer.starts = {0, 2};
    const test_support::LoadedScene loaded(layer);
    const GhostPlace half = ghost_place(loaded.layer(), 0, 250);
    ASSERT_TRUE(half.is_known);
    EXPECT_NEAR(half.point.latitude_rad, 0.525, 1e-12);
    EXPECT_NEAR(half.point.longitude_rad, 3.1 + 0.25 * (2 * 3.14159265358979323846 - 6.2), 1e-9);
    EXPECT_NEAR(half.point.height_m, 125, 1e-4);
    EXPECT_FALSE(ghost_place(loaded.layer(), 0, 1'001).is_known);
}

}  // namespace
}  // namespace tedavis::draw::test_ghost_signs
