#include "render_core/draw/data/tube_skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/base/units.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_tube_skin {
namespace {

using test_support::SolidRoomOfTest;

const glm::dvec3 kHere{6.4e6, 0, 0};  // up is x
constexpr float kRadius_m = 40;

/// A way north, 100 m a ring.
std::vector<scene::TubeRing> straight(std::size_t count) {
    std::vector<scene::TubePoint> points(count);
    for (std::size_t n = 0; n < count; ++n) points[n] = {kHere + glm::dvec3(0, 0, 100.0 * static_cast<double>(n)), {}, kRadius_m};
    std::vector<scene::TubeRing> rings(count + 1);
    rings.resize(scene::make_tube({points.data(), count}, glm::dvec3(0), {rings.data(), rings.size()}).rings);
    return rings;
}

TubeBlock block_of(const std::vector<scene::TubeRing>& rings, std::size_t first, std::size_t end) {
    return {{rings.data() + first, end - first}, first == 0, end == rings.size()};
}

class TubeSkinOfTest : public ::testing::Test {
protected:
    TubeSkinOfTest() : memory_(TubeSkin::bytes_needed()) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(skin.start(arena));
    }
    bool add(const TubeBlock& block) {
        const std::vector<RingColors> colors(block.rings.size(), RingColors{{{200, 0, 0, 255}, {}}, {{0, 0, 200, 255}, {}}});
        return skin.add_sides(room.batch, room.mesh, block, {colors.data(), colors.size()});
    }

    TubeSkin skin;
    SolidRoomOfTest room;

private:
    std::vector<unsigned char> memory_;
};

double hexagon_m2(double radius_m) { return 1.5 * std::sqrt(3.0) * radius_m * radius_m; }

TEST_F(TubeSkinOfTest, BlocksOfAPieceAreOneClosedTube) {
    const std::vector<scene::TubeRing> rings = straight(9);
    ASSERT_TRUE(add(block_of(rings, 0, 4)));
    ASSERT_TRUE(add(block_of(rings, 3, 7)));
    ASSERT_TRUE(add(block_of(rings, 6, 9)));
    ASSERT_EQ(room.batch.pieces().size(), 1u);
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_NEAR(test_support::volume_m3(room.batch, piece), hexagon_m2(40) * 800, 1e3) << "positive: it faces outwards";
    EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u) << "no ends within, one at each side";
    EXPECT_EQ(piece.indices, 3 * (8 * 12 + 2 * 4u));
}

TEST_F(TubeSkinOfTest, ABlockInTheMiddleIsOpen) {
    const std::vector<scene::TubeRing> rings = straight(9);
    ASSERT_TRUE(add(block_of(rings, 3, 7)));
    EXPECT_EQ(test_support::open_edges(room.batch, room.batch.pieces()[0]), 12u) << "six edges at each side";
}

TEST_F(TubeSkinOfTest, SidesTakeTurnsAndTheUpperOneIsEven) {
    const std::vector<scene::TubeRing> rings = straight(2);
    ASSERT_TRUE(add(block_of(rings, 0, 2)));
    std::size_t even = 0, odd = 0;
    for (const SolidVertex& vertex : room.batch.vertices()) {
        if (vertex.normal[2] != 127) continue;  // an end
        const bool is_odd = vertex.rgba[2] == 200;
        ++(is_odd ? odd : even);
        const bool is_up = vertex.normal[0] > 250, is_down = vertex.normal[0] < 4;
        EXPECT_FALSE(is_up && is_odd);
        EXPECT_FALSE(is_down && !is_odd) << "three sides farther";
    }
    EXPECT_EQ(even, 12u);
    EXPECT_EQ(odd, 12u);
}

TEST_F(TubeSkinOfTest, FullBatchesRefuse) {
    SolidRoomOfTest small(20);
    const std::vector<scene::TubeRing> rings = straight(3);
    const std::vector<RingColors> colors(3);
    EXPECT_FALSE(skin.add_sides(small.batch, small.mesh, block_of(rings, 0, 3), {colors.data(), 3}));
    EXPECT_FALSE(add_tube_hull(small.batch, small.mesh, block_of(rings, 0, 3), kTubeHullSides, {}, {colors.data(), 3}));
    EXPECT_EQ(small.batch.use().refused, 2u);
}

TEST_F(TubeSkinOfTest, HullsOfNoMarginAreTheTube) {
    const std::vector<scene::TubeRing> rings = straight(5);
    std::vector<RingColors> colors(5);
    colors[3].even.color = {50, 60, 70, 255};
    ASSERT_TRUE(add_tube_hull(room.batch, room.mesh, block_of(rings, 0, 5), kTubeRimSides, {}, {colors.data(), 5}));
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_NEAR(test_support::volume_m3(room.batch, piece), hexagon_m2(40) * 400, 500);
    EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
    for (const SolidVertex& vertex : room.batch.vertices()) {
        const glm::dvec3 outwards(vertex.place_m.x, vertex.place_m.y, 0);
        const glm::dvec3 normal(vertex.normal[0] - 127.0, vertex.normal[1] - 127.0, 0);
        EXPECT_GT(glm::dot(glm::normalize(outwards), glm::normalize(normal)), 0.999);
        EXPECT_EQ(vertex.rgba[1] == 60, std::abs(vertex.place_m.z - 300) < 1) << "every ring its own colour";
    }
}

TEST_F(TubeSkinOfTest, MarginsAreEllipses) {
    const std::vector<scene::TubeRing> rings = straight(2);
    const std::vector<TubeMargin> margins(2, TubeMargin{100, 30});
    const std::vector<RingColors> colors(2);
    ASSERT_TRUE(
        add_tube_hull(room.batch, room.mesh, block_of(rings, 0, 2), kTubeHullSides, {margins.data(), 2}, {colors.data(), 2}));
    double high = 0, wide = 0, from = 0, to = 0;
    for (const SolidVertex& vertex : room.batch.vertices()) {
        const glm::dvec3 at(vertex.place_m);
        high = std::max(high, at.x);
        wide = std::max(wide, at.y);
        from = std::min(from, at.z);
        to = std::max(to, at.z);
    }
    // Corners stand 15 degrees beside the axes.
    const auto reach = [](double up, double across) { return 40 + 1 / std::hypot(up / 30, across / 100); };
    const double c = std::cos(base::radians(15)), s = std::sin(base::radians(15));
    EXPECT_NEAR(high, std::max(reach(c, s) * c, reach(s, c) * s), 0.1);
    EXPECT_NEAR(wide, reach(s, c) * c, 0.1);
    EXPECT_NEAR(from, -100, 0.1);
    EXPECT_NEAR(to, 200, 0.1);
    EXPECT_EQ(test_support::open_edges(room.batch, room.batch.pieces()[0]), 0u);
}

TEST_F(TubeSkinOfTest, ASinglePlaceIsAnOctahedron) {
    const std::vector<scene::TubeRing> rings = straight(1);
    ASSERT_EQ(rings.size(), 1u);
    ASSERT_TRUE(add_tube_marker(room.batch, room.mesh, rings[0], {{9, 8, 7, 255}, {}}));
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_NEAR(test_support::volume_m3(room.batch, piece), 4.0 / 3 * 80 * 80 * 80, 100);
    EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
    EXPECT_EQ(piece.indices, 24u);
}

}  // namespace
}  // namespace tedavis::draw::test_tube_skin
