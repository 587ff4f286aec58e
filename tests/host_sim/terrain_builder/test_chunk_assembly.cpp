#include "host_sim/terrain_builder/chunk_assembly.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_chunk_assembly {
namespace {

using namespace terrain;
using test_support::BuildGround;

struct Assembled {
    const BuildGround& ground;
    LatticeWindow window = ground.all();
    PostPlaces places{ground.plan.lattice, window.i0, window.j0, window.columns, window.rows};

    ChunkDraft chunk(const ChunkKey& key) {
        ChunkAssembly assembly(ground.plan, key);
        for (const BorderPost& post : chunk_border(ground.plan, ground.lines, key)) assembly.add_border(post, window, places);
        const PostRange posts = ground.plan.lattice.posts_of(key);
        assembly.add_inner((posts.i0 + posts.i1) / 2, (posts.j0 + posts.j1) / 2, window, places);
        return assembly.finish();
    }
};

glm::dvec3 place_of(const ChunkEntry& entry, const ChunkVertex& v) {
    return glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) + glm::dvec3(v.x, v.y, v.z);
}

TEST(ChunkAssembly, VerticesLieOnTheGridBesideTheirPosts) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    for (const ChunkKey& key : {ChunkKey{0, 3, 2}, {1, 1, 1}, {3, 0, 0}}) {
        const ChunkDraft draft = Assembled{ground}.chunk(key);
        const LatticeWindow all = ground.all();
        const PostRange posts = ground.plan.lattice.posts_of(key);
        EXPECT_EQ(draft.entry.border_count + 1u, draft.entry.vertex_count);
        for (const ChunkVertex& v : draft.vertices) {
            const std::uint32_t i = posts.i0 + v.i, j = posts.j0 + v.j;
            const glm::dvec3 place = place_of(draft.entry, v);
            EXPECT_LE(glm::length(place - ground.plan.lattice.position(i, j, all.surface_m[all.at(i, j)])), draft.rounding_m);
            const glm::dvec3 steps = place / ground.plan.quantum_m(0);
            EXPECT_EQ(steps, glm::round(steps));
            EXPECT_EQ(v.height_m, ground.raster.height_m[ground.raster.at(i, j)]);
            const glm::dvec3 normal(v.normal[0], v.normal[1], v.normal[2]);
            EXPECT_NEAR(glm::length(normal), 127, 1.5);
        }
        for (const double centre : draft.entry.centre_m) EXPECT_EQ(centre, std::round(centre));
    }
}

/// A place half way between two of the grid, more steps from the Earth's centre than 32 bits count.
TEST(ChunkAssembly, HalvesAreRoundedFarFromTheEarthsCentre) {
    const BuildGround ground(test_support::make_raster(
        40, 40, [](auto, auto) { return 10.0f; }, 0, 0, 1.0 / 1200));
    LatticeWindow window = ground.all();
    const auto half = static_cast<float>(0.5 * ground.plan.quantum_m(0));
    window.surface_m[window.at(0, 0)] = half;  // at 0 N 0 E, x is the semi-major axis and this
    const PostPlaces places(ground.plan.lattice, window.i0, window.j0, window.columns, window.rows);
    ChunkAssembly assembly(ground.plan, {0, 0, 0});
    assembly.add_inner(0, 0, window, places);
    assembly.add_inner(1, 1, window, places);
    const ChunkDraft draft = assembly.finish();
    EXPECT_NEAR(place_of(draft.entry, draft.vertices[0]).x, earth::kSemiMajorAxis_m + double{half}, ground.plan.quantum_m(0));
}

/// Two chunks would round it differently.
TEST(ChunkAssembly, AVertexThatAFloatDoesNotHoldIsRefused) {
    const BuildGround ground(test_support::make_raster(
        40, 40, [](auto, auto) { return 10.0f; }, 9, 47, 1.0 / 1200));
    LatticeWindow window = ground.all();
    const PostPlaces places(ground.plan.lattice, window.i0, window.j0, window.columns, window.rows);
    window.surface_m[window.at(1, 1)] = 300'000;
    ChunkAssembly assembly(ground.plan, {0, 0, 0});
    assembly.add_inner(0, 0, window, places);
    assembly.add_inner(1, 1, window, places);
    test_support::expect_user_error([&assembly] { (void)assembly.finish(); }, "farther from its chunk's centre");
}

TEST(ChunkAssembly, TheBoxHoldsEveryVertexAndLittleMore) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    for (const ChunkKey& key : {ChunkKey{0, 3, 2}, {1, 1, 1}, {3, 0, 0}}) {
        const ChunkDraft draft = Assembled{ground}.chunk(key);
        const ChunkEntry& e = draft.entry;
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 direction(e.axes[3 * axis], e.axes[3 * axis + 1], e.axes[3 * axis + 2]);
            EXPECT_NEAR(glm::length(direction), 1, 1e-6);
            double farthest = 0;
            for (const ChunkVertex& v : draft.vertices)
                farthest = std::max(farthest, std::abs(glm::dot(glm::dvec3(v.x, v.y, v.z), direction)));
            EXPECT_LE(farthest, e.half_extent_m[axis]);
            EXPECT_GE(farthest, e.half_extent_m[axis] - 4 - 1e-3 * e.half_extent_m[axis]);
        }
    }
}

TEST(ChunkAssembly, TheBoxGrowsInEveryDirection) {
    ChunkEntry entry{};
    entry.half_extent_m[0] = 100;
    entry.half_extent_m[2] = 7;
    grow_box(entry, 2.5);
    EXPECT_NEAR(entry.half_extent_m[0], 102.5, 1e-4);
    EXPECT_NEAR(entry.half_extent_m[1], 2.5, 1e-4);
    EXPECT_GE(entry.half_extent_m[2], 9.5f);
}

TEST(ChunkAssembly, ANeighbourHoldsTheSamePlace) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    const ChunkDraft west = Assembled{ground}.chunk({0, 3, 2}), east = Assembled{ground}.chunk({0, 4, 2}),
                     parent = Assembled{ground}.chunk({1, 1, 1});
    int shared = 0;
    const auto compare = [&](const ChunkDraft& a, std::uint32_t a_i, std::uint32_t a_j, const ChunkDraft& b, std::uint32_t b_i,
                             std::uint32_t b_j) {
        for (std::uint32_t n = 0; n < a.entry.border_count; ++n)
            for (std::uint32_t m = 0; m < b.entry.border_count; ++m) {
                const ChunkVertex &v = a.vertices[n], &w = b.vertices[m];
                if (a_i + v.i != b_i + w.i || a_j + v.j != b_j + w.j) continue;
                EXPECT_EQ(place_of(a.entry, v), place_of(b.entry, w));
                for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(v.normal[axis], w.normal[axis]);
                ++shared;
            }
    };
    compare(west, 96, 64, east, 128, 64);
    EXPECT_EQ(shared, 33);
    compare(parent, 64, 64, east, 128, 64);
    EXPECT_GT(shared, 36);
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_assembly
