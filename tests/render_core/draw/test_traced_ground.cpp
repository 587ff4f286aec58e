#include "render_core/draw/traced_ground.hpp"

#include <gtest/gtest.h>

#include <random>

#include "render_core/terrain/regular_chunk.hpp"
#include "tests/support/terrain/ground_files.hpp"

namespace tedavis::draw::test_traced_ground {
namespace {

using terrain::HeightStatus;
using terrain::PostClass;
using test_support::mixed_file;
using test_support::OpenedGround;
using test_support::rough_file;

/// scene::Ground with memory of its own.
struct Held {
    explicit Held(OpenedGround& of, std::int64_t bytes_off = 0)
        : memory((TracedGround::bytes_needed(of.database.lattice())) / 8 + 1) {
        base::Arena arena(
            memory.data(),
            static_cast<std::size_t>(static_cast<std::int64_t>(TracedGround::bytes_needed(of.database.lattice())) + bytes_off));
        base::SerialWorkers workers;
        fault = ground.start(of.query, workers, arena);
    }
    std::vector<std::uint64_t> memory;
    TracedGround ground;
    TracedGroundFault fault;
};

double surface_of(const raytrace::HeightGrid<float>& grid, double i, double j) {
    const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>(j);
    const double u = i - a, v = j - b;
    const double nw{grid.at(a, b)}, ne{grid.at(a + 1, b)}, sw{grid.at(a, b + 1)}, se{grid.at(a + 1, b + 1)};
    return u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
}

TEST(TracedGround, HasTheTrueSurfaceWhateverTheLevelsOfItsChunks) {
    for (const auto& spec : {rough_file(200, 150), mixed_file(false)}) {
        OpenedGround of(spec);
        const Held held(of);
        ASSERT_EQ(held.fault, TracedGroundFault::none);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> i(0, spec.columns - 1.001), j(0, spec.rows - 1.001);
        for (int n = 0; n < 5000; ++n) {
            const double x = i(random), y = j(random);
            const terrain::HeightAnswer truth = of.ask(x, y);
            ASSERT_EQ(truth.status, HeightStatus::land);
            ASSERT_NEAR(surface_of(held.ground.heights(), x, y), truth.height.m, 0.0003) << x << ", " << y;
        }
    }
}

TEST(TracedGround, LooksAreThoseStored) {
    OpenedGround of(rough_file(130, 97));
    const Held held(of);
    ASSERT_EQ(held.fault, TracedGroundFault::none);
    const terrain::ExactChunk chunk = of.query.exact_chunk(40, 70);
    const terrain::PostRange posts = of.database.lattice().posts_of(key_of(*chunk.entry));
    const auto grid = terrain::regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, 0);
    for (std::uint32_t j = posts.j0; j <= posts.j1; ++j)
        for (std::uint32_t i = posts.i0; i <= posts.i1; ++i) {
            const terrain::ChunkVertex& stored = chunk.vertices[grid.index_of(i - posts.i0, j - posts.j0)];
            const PostLook& look = held.ground.looks()[std::size_t{j} * 130 + i];
            EXPECT_EQ(held.ground.heights().at(i, j), stored.height_m);
            for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(look.normal[axis], stored.normal[axis]);
            EXPECT_EQ(look.post_class, PostClass::land);
        }
}

/// Filled heights, not holes: rays meet what triangles show there.
TEST(TracedGround, GroundWithoutDataIsFilledAndKnown) {
    OpenedGround of(mixed_file(true));
    const Held held(of);
    ASSERT_EQ(held.fault, TracedGroundFault::none);
    EXPECT_EQ(held.ground.looks()[std::size_t{215} * 257 + 205].post_class, PostClass::void_);
    EXPECT_EQ(held.ground.looks()[std::size_t{180} * 257 + 205].post_class, PostClass::land);
    for (std::uint32_t n = 0; n < 257 * 257; ++n) {
        ASSERT_GT(held.ground.heights().posts[n], -1000.0f);
        ASSERT_LT(held.ground.heights().posts[n], 5000.0f);
    }
}

TEST(TracedGround, SaysWhyItIsNone) {
    OpenedGround of(rough_file(130, 97));
    EXPECT_EQ(Held(of, -1).fault, TracedGroundFault::no_room);
    test_support::TdbSpec earth = test_support::whole_earth(128, 65);
    earth.height_m = [](std::uint32_t, std::uint32_t) { return 100.0; };
    earth.measured = false;
    OpenedGround round(earth);
    EXPECT_EQ(Held(round).fault, TracedGroundFault::round);
    test_support::TdbSpec spec = rough_file(130, 97);
    OpenedGround damaged(spec);
    damaged.bytes.content[damaged.tdb.entry({0, 2, 1}).payload.offset + 12] ^= 1;
    EXPECT_EQ(Held(damaged).fault, TracedGroundFault::damaged);
}

}  // namespace
}  // namespace tedavis::draw::test_traced_ground
