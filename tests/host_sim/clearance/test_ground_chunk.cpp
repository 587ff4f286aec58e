#include "host_sim/clearance/ground_chunk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_ground_chunk {
namespace {

TEST(GroundBox, KnowsDistancesAndRegions) {
    GroundBox box;
    box.include({1, 2, 3});
    box.include({2, 4, 5});
    EXPECT_DOUBLE_EQ(box.distance_m({1.5, 3, 4}), 0);
    EXPECT_DOUBLE_EQ(box.distance_m({1, -1, -1}), 5);
    EXPECT_DOUBLE_EQ(box.level_distance_m({1, -1, -1}), 3);
    EXPECT_TRUE(box.may_reach({{{0, 0, 1}, 4.9}}));
    EXPECT_FALSE(box.may_reach({{{0, 0, 1}, 5.1}}));
    EXPECT_FALSE(box.may_reach({{{-1, 0, 0}, -0.5}}));
}

TEST(GroundChunk, FindsTheFlatGroundBelow) {
    const test_support::BuiltDatabase built(test_support::make_raster(33, 33, [](auto, auto) { return 500.0f; }));
    const auto chunk = GroundChunk::read(built.database, built.entry({0, 0, 0}));
    ASSERT_NE(chunk, nullptr);
    double distance_m = 1e9;
    glm::dvec3 nearest{};
    const glm::dvec3 eye(20, 30, -300);
    ASSERT_TRUE(chunk->find_nearer(eye, {}, distance_m, nearest));
    EXPECT_NEAR(nearest.z, distance_m, 0.1) << "straight down";
    EXPECT_LT(std::hypot(nearest.x, nearest.y), 1);
    double again_m = distance_m;
    EXPECT_FALSE(chunk->find_nearer(eye, {}, again_m, nearest)) << "nothing is nearer than the nearest";
    again_m = 1e9;
    EXPECT_FALSE(chunk->find_nearer(eye, {{{0, 0, -1}, 0}}, again_m, nearest)) << "nothing reaches the eye's height";
}

TEST(GroundChunk, CellsAtAVoidPostAreNoGround) {
    const auto heights = [](std::uint32_t i, std::uint32_t j) {
        return i == 16 && j == 16 ? std::nanf("") : i > 12 && i < 20 && j > 12 && j < 20 ? 700.0f : 500.0f;
    };
    const test_support::BuiltDatabase built(test_support::make_raster(33, 33, heights));
    const terrain::ChunkEntry entry = built.entry({0, 0, 0});
    const auto chunk = GroundChunk::read(built.database, entry);
    ASSERT_NE(chunk, nullptr);
    const earth::Geodetic post{built.lattice().latitude_rad(16), built.lattice().longitude_rad(16), {}};
    const double undulation_m = built.database.undulation(post.latitude_rad, post.longitude_rad).m;
    const glm::dvec3 over = earth::to_ecef({post.latitude_rad, post.longitude_rad, {710 + undulation_m}});
    const glm::dvec3 eye = (over - chunk->centre()) * chunk->axes();
    double distance_m = 1e9;
    glm::dvec3 nearest{};
    ASSERT_TRUE(chunk->find_nearer(eye, {}, distance_m, nearest));
    EXPECT_NEAR(distance_m, std::hypot(10, 63.3), 1.5) << "the next column; ten metres below there is nothing";
    EXPECT_TRUE(chunk->has_void_within(eye, 1));
    EXPECT_FALSE(chunk->has_void_within(eye + glm::dvec3(1000, 0, 0), 100));
}

TEST(GroundChunk, ADamagedOneIsNotRead) {
    test_support::BuiltDatabase built(test_support::make_rough_raster(33, 33));
    const terrain::ChunkEntry entry = built.entry({0, 0, 0});
    built.image[entry.payload.offset + 8] ^= 1;
    EXPECT_EQ(GroundChunk::read(built.database, entry), nullptr);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ground_chunk
